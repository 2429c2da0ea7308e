"""Progress output of long computations."""

from __future__ import annotations

import time
from collections.abc import Callable

MANY = 20000  # nodes from which on progress is shown unasked


def reporter(count: int, verbose: bool, many: int = MANY) -> Callable[[str], None]:
    """A function that prints a line with the seconds so far; it is silent for small meshes unless verbose."""
    if not verbose and count < many:
        return lambda text: None
    start = time.perf_counter()
    return lambda text: print(f"FEM: {text}, {time.perf_counter() - start:.1f} s", flush=True)
