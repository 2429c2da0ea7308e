"""Objects instead of numbers: Model, handles of items, and Solution, over the interface with indices.

words: texts for enumerations, axes and colors. item_facts: parameters and outputs by item type. handle: handles.
model: Model. solve, solution: Solution.
"""
