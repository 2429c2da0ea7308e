"""Print what building models costs: python building.py [--peer PYTHON].

Time to add an item, time to assemble it, how these grow with the number of items, and resident memory per item. PYTHON
is an interpreter with Exudyn installed; by default this one is tried. Each measurement is a process
of its own: python building.py --measure MODULE MODEL ITEMS prints its numbers as a line of JSON.
"""

from __future__ import annotations

import argparse
import gc
import json
import math
import os
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from compare import has_peer, printed_by
from models import Package

SIZES = (1_000, 10_000, 100_000)
REPETITIONS = 3


def _add_mass(p: Package, mbs: Any, x: float, y: float) -> Any:
    """Add a mass point and return the marker on it: three items."""
    node = mbs.AddNode(p.items.NodePoint(referenceCoordinates=[x, y, 0.0]))
    mbs.AddObject(p.items.ObjectMassPoint(physicsMass=1.0, nodeNumber=node))
    return mbs.AddMarker(p.items.MarkerNodePosition(nodeNumber=node))


def _add_spring(p: Package, mbs: Any, marker0: Any, marker1: Any) -> None:
    mbs.AddObject(
        p.items.ObjectConnectorSpringDamper(markerNumbers=[marker0, marker1], referenceLength=1.0, stiffness=1e3)
    )


def add_chain(p: Package, mbs: Any, items: int) -> None:
    """Add mass points in a row, each tied to the next: four items for each point."""
    markers = [_add_mass(p, mbs, float(i), 0.0) for i in range(items // 4)]
    for left, right in zip(markers, markers[1:], strict=False):
        _add_spring(p, mbs, left, right)


def add_grid(p: Package, mbs: Any, items: int) -> None:
    """Add mass points in a square, each tied to its neighbours: five items for each point."""
    n = math.isqrt(items // 5)
    rows = [[_add_mass(p, mbs, float(i), float(j)) for i in range(n)] for j in range(n)]
    for line in (*rows, *zip(*rows, strict=True)):
        for left, right in zip(line, line[1:], strict=False):
            _add_spring(p, mbs, left, right)


MODELS: dict[str, Callable[[Package, Any, int], None]] = {"chain": add_chain, "grid": add_grid}


def _resident_bytes() -> int:
    gc.collect()
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE")


def measure(module: str, model: str, items: int) -> dict[str, float]:
    """Return microseconds and bytes per item; memory is that of the first model, times are the least of all."""
    p = Package.load(module)
    containers, adding, assembling, memory = [], [], [], []
    for _ in range(REPETITIONS):
        containers.append(p.exu.SystemContainer())
        mbs = containers[-1].AddSystem()
        memory.append(_resident_bytes())
        start = time.perf_counter()
        MODELS[model](p, mbs, items)
        added = time.perf_counter()
        memory.append(_resident_bytes())
        ready = time.perf_counter()
        mbs.Assemble()
        assembling.append(time.perf_counter() - ready)
        adding.append(added - start)
        memory.append(_resident_bytes())
    data = mbs.systemData
    added_items = data.NumberOfNodes() + data.NumberOfObjects() + data.NumberOfMarkers()
    return {
        "add": 1e6 * min(adding) / added_items,
        "assemble": 1e6 * min(assembling) / added_items,
        "model": (memory[1] - memory[0]) / added_items,
        "system": (memory[2] - memory[1]) / added_items,
    }


def exponent(costs: list[dict[str, float]]) -> float:
    """Return how the time to add and assemble all items grows with their number n: as n to this power."""
    first, last = (cost["add"] + cost["assemble"] for cost in (costs[0], costs[-1]))
    return 1 + math.log(last / first) / math.log(SIZES[-1] / SIZES[0])


# Titles and digits behind the point.
COLUMNS = {
    "us to add": 2,
    "us to assemble": 2,
    "exponent": 2,
    "bytes of model": 0,
    "bytes of system": 0,
    "all bytes": 0,
}


def line(model: str, module: str, costs: list[dict[str, float]]) -> str:
    """Return one line of the table, for the largest model."""
    most = costs[-1]
    memory = (most["model"], most["system"], most["model"] + most["system"])
    values = (most["add"], most["assemble"], exponent(costs), *memory)
    cells = [f"{v:{len(title)}.{n}f}" for v, (title, n) in zip(values, COLUMNS.items(), strict=True)]
    return "  ".join((f"{model:5s}", f"{module:9s}", *cells))


def main() -> None:
    """Measure both models with both packages."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--peer", default=sys.executable, help="interpreter with exudyn")
    parser.add_argument("--measure", nargs=3, metavar=("MODULE", "MODEL", "ITEMS"))
    arguments = parser.parse_args()
    if arguments.measure:
        module, model, items = arguments.measure
        print(json.dumps(measure(module, model, int(items))))
        return
    packages = {"dalembert": sys.executable} | ({"exudyn": arguments.peer} if has_peer(arguments.peer) else {})
    print(f"per item, of {SIZES[-1]} items")
    print("  ".join((" " * 5, " " * 9, *COLUMNS)))
    for model in MODELS:
        for module, python in packages.items():
            costs = [printed_by(python, "building.py", "--measure", module, model, str(n)) for n in SIZES]
            print(line(model, module, [cost for cost in costs if cost is not None]), flush=True)


if __name__ == "__main__":
    main()
