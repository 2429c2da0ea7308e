# Generated from codegen/names.py by codegen/templates/snake_case.py.j2. Do not edit; run `python -m codegen`.
# tests/codegen/test_freshness.py compares this file with its sources.
"""Names of handles and of Model: `physicsMass` is `physics_mass`."""

import re

WORD = re.compile(r"ANCF|ALE|FFRF|COMs|\d+D|[A-Z]+(?![a-z])(?:\d+(?![\dD]))?|[A-Z]?[a-z]+(?:\d+(?![\dD]))?|\d+")


def snake_case(name: str) -> str:
    """`ANCFCable2D` -> `ancf_cable_2d`."""
    return "_".join(WORD.findall(name)).lower()
