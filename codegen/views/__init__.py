"""Representation of the model in each target language. Each property has a small function."""
