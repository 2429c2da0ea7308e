"""Small functions for models: checks of types, excitations, matrices, symbolic functions."""
