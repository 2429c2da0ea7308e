"""Rotations, rigid transformations, inertia, and curves of ropes."""
