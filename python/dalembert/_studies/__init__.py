"""Many computations of one model: variations, optimization, sensitivities, and parallel execution."""
