"""Print what general contact takes: python contact.py [PART ...].

Processor time per explicit step for each sphere, with and without friction, of spheres on a mesh of 100 000 triangles,
and of lines that are asked for what they meet first there. Two solutions of different length tell steps from what comes
once.
"""

from __future__ import annotations

import argparse
import resource
import time
from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np

import dalembert as exu
from dalembert import itemInterface as eii

RADIUS, STIFFNESS, DAMPING = 0.01, 2e4, 2.0
MASS = 2500 * 4 / 3 * np.pi * RADIUS**3
STEP = 2e-5


def hills(cells: int, width: float) -> tuple[np.ndarray, np.ndarray]:
    """Two triangles for each cell of a square, low hills on it."""
    x, y = np.meshgrid(np.linspace(0, width, cells + 1), np.linspace(0, width, cells + 1), indexing="ij")
    points = np.stack([x, y, 0.1 * RADIUS * np.sin(40 * x) * np.cos(30 * y)], axis=-1).reshape(-1, 3)
    i = (np.arange(cells)[:, None] * (cells + 1) + np.arange(cells)).reshape(-1)
    j = i + cells + 1
    return points, np.concatenate([np.stack([i, j, j + 1], axis=1), np.stack([i, j + 1, i + 1], axis=1)])


def spheres(shape: tuple[int, int, int], friction: float, cells: int = 0) -> tuple[Any, Any]:
    """Return a system with spheres that touch on a lattice, on a mesh if it has cells, and its contact."""
    mbs = exu.SystemContainer().AddSystem()
    contact = mbs.AddGeneralContact()
    contact.SetFrictionPairings(friction * np.eye(1))
    surface: dict[str, Any] = {"contactStiffness": STIFFNESS, "contactDamping": DAMPING, "frictionMaterialIndex": 0}
    pitch, rng = 1.96 * RADIUS, np.random.default_rng(7)
    if cells:
        marker = mbs.AddMarker(eii.MarkerBodyRigid(bodyNumber=mbs.CreateGround()))
        points, triangles = hills(cells, max(shape) * pitch)
        contact.AddTrianglesRigidBodyBased(marker, pointList=points, triangleList=triangles, **surface)
    for place in np.ndindex(shape):
        p = (np.array(place) + 0.5) * pitch + rng.uniform(-0.01, 0.01, 3) * RADIUS
        if friction:
            node = mbs.AddNode(eii.NodeRigidBodyRotVecLG(referenceCoordinates=[*p, 0, 0, 0]))
            inertia = [0.4 * MASS * RADIUS**2] * 3 + [0] * 3
            mbs.AddObject(eii.ObjectRigidBody(physicsMass=MASS, physicsInertia=inertia, nodeNumber=node))
            marker = mbs.AddMarker(eii.MarkerNodeRigid(nodeNumber=node))
        else:
            node = mbs.AddNode(eii.NodePoint(referenceCoordinates=p))
            mbs.AddObject(eii.ObjectMassPoint(physicsMass=MASS, nodeNumber=node))
            marker = mbs.AddMarker(eii.MarkerNodePosition(nodeNumber=node))
        mbs.AddLoad(eii.LoadForceVector(markerNumber=marker, loadVector=[0, 0, -9.81 * MASS]))
        contact.AddSphereWithMarker(marker, radius=RADIUS, **surface)
    mbs.Assemble()
    return mbs, contact


def time_of_steps(mbs: Any, steps: int, repeat: int = 3) -> float:
    """Return the processor time of a step in seconds."""
    times = {}
    for count in (1, steps + 1):
        settings = exu.SimulationSettings()
        settings.timeIntegration.numberOfSteps = count
        settings.timeIntegration.endTime = count * STEP
        settings.timeIntegration.verboseMode = 0
        settings.solutionSettings.writeSolutionToFile = False
        settings.timeIntegration.explicitIntegration.computeEndOfStepAccelerations = False
        tries = []
        for _ in range(repeat):
            start = time.process_time()
            mbs.SolveDynamic(settings, solverType=exu.DynamicSolverType.ExplicitEuler)
            tries.append(time.process_time() - start)
        times[count] = min(tries)
    return (times[steps + 1] - times[1]) / steps


def lattice(size: int, friction: float) -> None:
    side = round(size ** (1 / 3))
    mbs, _ = spheres((side, side, side), friction)
    one = time_of_steps(mbs, max(5, 2_000_000 // side**3)) / side**3
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 2**20
    what = "with friction" if friction else "without friction"
    print(
        f"{side**3:8d} spheres {what:18s} {1e9 * one:8.0f} ns per sphere and step, {memory:6.2f} GB at most until here",
        flush=True,
    )


def lines_per_second(contact: Any, width: float, count: int = 20_000, **options: Any) -> float:
    """Ask for what lines from above meet first in a square."""
    starts = np.column_stack([np.random.default_rng(1).uniform(0, width, (count, 2)), np.full(count, 1.0)]).tolist()
    way = [1e-3, 2e-3, -1.0]
    start = time.process_time()
    for place in starts:
        contact.ShortestDistanceAlongLine(place, way, minDistance=0.0, maxDistance=3.0, **options)
    return count / (time.process_time() - start)


def mesh() -> None:
    triangles = f"{2 * 224**2} triangles"
    mbs, contact = spheres((100, 100, 1), 0.0, 224)
    one = time_of_steps(mbs, 200) / 1e4
    print(f"   10000 spheres on {triangles} {1e9 * one:8.0f} ns per sphere and step", flush=True)
    print(f"{lines_per_second(contact, 1.96):8.0f} lines per second among 10000 spheres and {triangles}", flush=True)
    mbs, contact = spheres((1, 1, 1), 0.0, 224)
    only = {"typeIndex": exu.ContactTypeIndex.IndexTrigsRigidBodyBased}
    print(f"{lines_per_second(contact, RADIUS, **only):8.0f} lines per second among {triangles}", flush=True)


def main() -> None:
    """Measure the chosen parts."""
    parts: dict[str, Callable[[], None]] = {"mesh": mesh}
    parts |= {f"points-{n}": partial(lattice, n, 0.0) for n in (1000, 10_000, 100_000, 1_000_000)}
    parts |= {f"bodies-{n}": partial(lattice, n, 0.3) for n in (1000, 10_000, 100_000, 1_000_000)}
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("parts", nargs="*", metavar="PART", help=", ".join(parts))
    for name in parser.parse_args().parts or parts:
        parts[name]()


if __name__ == "__main__":
    main()
