"""What stands around solvers: consistent starts, linearized systems, diagnosis of failures."""
