"""Time for many slider-cranks with rods of different lengths: SolveVariations against ParameterVariation.

`python benchmarks/ensemble.py --peer PYTHON > docs/data/ensemble.txt` compares with Exudyn as
well, if the interpreter PYTHON has it. ParameterVariation builds, assembles and solves each model in Python, in so many
processes; SolveVariations uses as many threads. Seconds are those of a clock, and those that all cores together have
computed, which other work on the machine hardly changes.
"""

from __future__ import annotations

import argparse
import importlib
import json
import os
import resource
import subprocess
import sys
import time
from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

import numpy as np

CRANK, SHORTEST, LONGEST = 0.1, 0.25, 0.35  # m
MASSES = (0.3, 0.5, 0.4)  # kg: crank, rod, slider


def rod_parameters(rod: Any) -> tuple[Any, Any, Any]:
    """Places of the three centers of mass along the stretched mechanism, and the inertia of the rod."""
    return CRANK + rod / 2, CRANK + rod, MASSES[1] * rod**2 / 12


def slider_crank(module: str, rod: float) -> tuple[Any, list[Any], list[Any], list[Any]]:
    """Return an assembled system, its nodes, its bodies and the markers at the ends of its rod."""
    exu, it = (importlib.import_module(module + part) for part in ("", ".itemInterface"))
    mbs = exu.SystemContainer().AddSystem()
    middle, end, inertia = rod_parameters(rod)
    places, inertias = (CRANK / 2, middle, end), (MASSES[0] * CRANK**2 / 12, inertia, 1e-3)
    nodes = [mbs.AddNode(it.NodeRigidBody2D(referenceCoordinates=[x, 0.0, 0.0])) for x in places]
    bodies = [
        mbs.AddObject(it.ObjectRigidBody2D(nodeNumber=node, physicsMass=mass, physicsInertia=inertia))
        for node, mass, inertia in zip(nodes, MASSES, inertias, strict=True)
    ]
    ground = mbs.AddObject(it.ObjectGround())
    markers = []
    for first, x0, second, x1 in (
        (ground, 0.0, bodies[0], -CRANK / 2),
        (bodies[0], CRANK / 2, bodies[1], -rod / 2),
        (bodies[1], rod / 2, bodies[2], 0.0),
    ):
        pair = [
            mbs.AddMarker(it.MarkerBodyRigid(bodyNumber=body, localPosition=[x, 0.0, 0.0]))
            for body, x in ((first, x0), (second, x1))
        ]
        mbs.AddObject(it.ObjectJointRevolute2D(markerNumbers=pair))
        markers += pair
    rest = mbs.AddMarker(it.MarkerNodeCoordinate(nodeNumber=mbs.AddNode(it.NodePointGround()), coordinate=0))
    for k in (1, 2):
        guided = mbs.AddMarker(it.MarkerNodeCoordinate(nodeNumber=nodes[2], coordinate=k))
        mbs.AddObject(it.ObjectConnectorCoordinate(markerNumbers=[rest, guided]))
    drive = mbs.AddMarker(it.MarkerNodeRigid(nodeNumber=nodes[0]))
    mbs.AddLoad(it.LoadTorqueVector(markerNumber=drive, loadVector=[0.0, 0.0, 0.3]))
    position = exu.OutputVariableType.Position
    mbs.AddSensor(it.SensorNode(nodeNumber=nodes[2], outputVariableType=position, writeToFile=False))
    mbs.Assemble()
    return mbs, nodes, bodies, markers[3:5]


def settings(module: str, steps: int) -> Any:
    s = importlib.import_module(module).SimulationSettings()
    s.timeIntegration.numberOfSteps, s.timeIntegration.endTime = steps, 1e-3 * steps
    s.timeIntegration.verboseMode = 0
    s.solutionSettings.writeSolutionToFile = False
    return s


def final_position(module: str, steps: int, parameters: dict[str, float]) -> float:
    """The function of ParameterVariation: place of the slider at the end."""
    mbs = slider_crank(module, parameters["rod"])[0]
    mbs.SolveDynamic(settings(module, steps))
    return float(mbs.GetSensorValues(0)[0])


def by_processes(module: str, variations: int, steps: int, processes: int) -> Sequence[float]:
    processing = importlib.import_module(module + ".processing")
    _, values = processing.ParameterVariation(
        parameterFunction=partial(final_position, module, steps),
        parameters={"rod": (SHORTEST, LONGEST, variations)},
        useMultiProcessing=processes > 1,
        numberOfThreads=processes,
        showProgress=False,
    )
    return list(values)


def by_threads(variations: int, steps: int, threads: int) -> Sequence[float]:
    rods, zero = np.linspace(SHORTEST, LONGEST, variations), np.zeros(variations)
    middle, end, inertia = rod_parameters(rods)
    mbs, nodes, bodies, (left, right) = slider_crank("dalembert", 0.3)
    results = mbs.SolveVariations(
        {
            (nodes[1], "referenceCoordinates"): np.column_stack([middle, zero, zero]),
            (nodes[2], "referenceCoordinates"): np.column_stack([end, zero, zero]),
            (bodies[1], "physicsInertia"): inertia,
            (left, "localPosition"): np.column_stack([-rods / 2, zero, zero]),
            (right, "localPosition"): np.column_stack([rods / 2, zero, zero]),
        },
        settings("dalembert", steps),
        numberOfThreads=threads,
    )
    assert results.success.all(), results.messages
    return list(results.sensorValues[:, 0])


def processor_time() -> float:
    """Seconds that this process and its children have computed, on all cores together."""
    used = (resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    return sum(u.ru_utime + u.ru_stime for u in used)


def timed(solve: Callable[..., Sequence[float]], *arguments: Any) -> dict[str, float]:
    start, used = time.perf_counter(), processor_time()
    values = solve(*arguments)
    return {
        "seconds": time.perf_counter() - start,
        "processor": processor_time() - used,
        "sum": float(np.sum(values)),
    }


def peer(python: str, sizes: list[int]) -> dict[str, float] | None:
    """Run this file by the interpreter that has Exudyn; None if there is none."""
    command = [python, __file__, "--only", "exudyn", *map(str, sizes)]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    return dict(json.loads(run.stdout.splitlines()[-1])) if run.returncode == 0 else None


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("variations", nargs="?", type=int, default=1000)
    parser.add_argument("steps", nargs="?", type=int, default=250)
    parser.add_argument("processes", nargs="?", type=int, default=len(os.sched_getaffinity(0)))
    parser.add_argument("--peer", default=sys.executable, help="interpreter with exudyn")
    parser.add_argument("--only", help=argparse.SUPPRESS)
    a = parser.parse_args()
    sizes = [a.variations, a.steps, a.processes]
    importlib.import_module(f"{a.only or 'dalembert'}.processing")  # whose time is not meant
    if a.only:
        print(json.dumps(timed(by_processes, a.only, *sizes)))
        return
    ours = timed(by_threads, *sizes)
    rows = {
        "SolveVariations": ours,
        "ParameterVariation": timed(by_processes, "dalembert", *sizes),
        "ParameterVariation of exudyn": peer(a.peer, sizes),
    }
    print(f"{a.variations} variations of {a.steps} steps on {a.processes} cores")
    print(f"{'':30s} {'seconds':>8s} {'ratio':>6s} {'processor':>10s} {'ratio':>6s} {'difference':>10s}")
    for name, row in rows.items():
        if row is not None:
            pairs = " ".join(f"{row[k]:{w}.3f} {row[k] / ours[k]:6.1f}" for k, w in (("seconds", 8), ("processor", 10)))
            print(f"{name:30s} {pairs} {abs(row['sum'] / ours['sum'] - 1):10.0e}")


if __name__ == "__main__":
    main()
