"""Ranges of numbers, in the notation of intervals: `[0, 1]`, `(0, 1)`, `[1, inf)`."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass

from codegen.model import SpecError

_INTERVAL = re.compile(r"([\[(])\s*([^,\s]+)\s*,\s*([^,\s]+)\s*([\])])\Z")


@dataclass(frozen=True)
class Range:
    """A round bracket leaves its bound out."""

    lower: float
    upper: float
    lower_open: bool = False
    upper_open: bool = False

    def __contains__(self, value: float) -> bool:
        above = value > self.lower if self.lower_open else value >= self.lower
        return above and (value < self.upper if self.upper_open else value <= self.upper)

    @property
    def words(self) -> str:
        """Return `from 0 to 1`, `greater than 0 and at most 1`, or `at least 1`."""
        below = f"{'less than' if self.upper_open else 'at most'} {self.upper:g}"
        above = f"{'greater than' if self.lower_open else 'at least'} {self.lower:g}"
        if math.isinf(self.upper):
            return above
        if math.isinf(self.lower):
            return below
        if not self.lower_open and not self.upper_open:
            return f"from {self.lower:g} to {self.upper:g}"
        return f"{above} and {below}"


def read_range(text: str) -> Range:
    match = _INTERVAL.match(text.strip())
    try:
        assert match
        lower, upper = float(match[2]), float(match[3])
    except (AssertionError, ValueError):
        raise SpecError(f"range: {text!r} is not an interval such as '[0, 1]', '(0, 1)' or '[1, inf)'") from None
    if not lower < upper:
        raise SpecError(f"range: {text!r} is empty")
    result = Range(lower, upper, match[1] == "(", match[4] == ")")
    if math.inf in result or -math.inf in result:
        raise SpecError(f"range: {text!r} contains infinity; write a round bracket there")
    return result
