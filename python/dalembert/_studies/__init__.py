"""Many computations of one model: variations, optimization, sensitivities, and what runs them side by side."""
