"""Objects instead of numbers: Model, handles of items, and Solution, over the interface with indices.

words: texts for enumerations, axes and colors. assembly: initial values. handle: handles.
model: Model. solve, solution: Solution.
"""
