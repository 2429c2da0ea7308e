"""Finite element meshes: elements, matrices, modes, stresses, and flexible bodies made of them."""
