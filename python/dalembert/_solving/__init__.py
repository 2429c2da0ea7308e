"""Functions around solvers: consistent initial conditions, linearized systems, diagnosis of failures."""
