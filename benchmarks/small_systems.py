"""Time for 1000 small systems of different stiffness: SolveVariations on one core against a loop in Python.

`python benchmarks/small_systems.py > docs/data/small_systems.txt`. The loop sets the parameter and
calls SolveDynamic. Both ways take turns; the fastest of three runs counts, in seconds that the core has computed.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Callable
from typing import Any

import numpy as np

import dalembert as exu
from dalembert.itemInterface import (
    CoordinateSpringDamper,
    Force,
    MarkerBodyPosition,
    MarkerNodeCoordinate,
    Mass1D,
    Node1D,
    NodePointGround,
    NodeRigidBody2D,
    ObjectGround,
    ObjectRigidBody2D,
    RevoluteJoint2D,
    SensorBody,
    SensorNode,
)

ROUNDS = 3


def masses(*values: float) -> tuple[Any, Any]:
    """Masses one above the other on springs, the last one on the ground; the assembled system and the first spring."""
    mbs = exu.SystemContainer().AddSystem()
    markers = []
    for value in values:
        node = mbs.AddNode(Node1D(referenceCoordinates=[0], initialCoordinates=[0.05]))
        mbs.AddObject(Mass1D(nodeNumber=node, physicsMass=value))
        markers.append(mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=node, coordinate=0)))
    markers.append(mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.AddNode(NodePointGround()), coordinate=0)))
    springs = [
        mbs.AddObject(CoordinateSpringDamper(markerNumbers=markers[i : i + 2], stiffness=2e4 * 9**i, damping=1500))
        for i in range(len(values))
    ]
    mbs.AddSensor(SensorNode(nodeNumber=0, outputVariableType=exu.OutputVariableType.Coordinates, writeToFile=False))
    mbs.Assemble()
    return mbs, (springs[0], "stiffness", 2e4)


def pendulum() -> tuple[Any, Any]:
    mbs = exu.SystemContainer().AddSystem()
    node = mbs.AddNode(NodeRigidBody2D(referenceCoordinates=[0.5, 0, 0]))
    body = mbs.AddObject(ObjectRigidBody2D(nodeNumber=node, physicsMass=1, physicsInertia=0.1))
    ends = [
        mbs.AddMarker(MarkerBodyPosition(bodyNumber=number, localPosition=[x, 0, 0]))
        for number, x in ((mbs.AddObject(ObjectGround()), 0), (body, -0.5))
    ]
    mbs.AddObject(RevoluteJoint2D(markerNumbers=ends))
    centre = mbs.AddMarker(MarkerBodyPosition(bodyNumber=body))
    mbs.AddLoad(Force(markerNumber=centre, loadVector=[0, -9.81, 0]))
    mbs.AddSensor(SensorNode(nodeNumber=node, outputVariableType=exu.OutputVariableType.Position, writeToFile=False))
    mbs.Assemble()
    return mbs, (body, "physicsMass", 1.0)


def points(count: int) -> tuple[Any, Any]:
    """Point masses that hang below each other on springs and dampers."""
    mbs = exu.SystemContainer().AddSystem()
    row = [mbs.CreateGround()]
    for i in range(1, count + 1):
        row.append(mbs.CreateMassPoint(referencePosition=[0.1 * i, -0.3 * i, 0], physicsMass=1, gravity=[0, -9.81, 0]))
    springs = [
        mbs.CreateSpringDamper(bodyNumbers=row[i : i + 2], referenceLength=0.3, stiffness=500, damping=5)
        for i in range(count)
    ]
    mbs.AddSensor(SensorBody(bodyNumber=row[-1], outputVariableType=exu.OutputVariableType.Position, writeToFile=False))
    mbs.Assemble()
    return mbs, (springs[0], "stiffness", 500)


SYSTEMS: dict[str, Callable[[], tuple[Any, Any]]] = {
    "oscillator, 1 unknown": lambda: masses(300),
    "quarter car, 2 unknowns": lambda: masses(300, 40),
    "three masses, 3 unknowns": lambda: masses(300, 100, 40),
    "mass in space, 3 unknowns": lambda: points(1),
    "four masses, 4 unknowns": lambda: masses(300, 100, 60, 40),
    "pendulum, 5 unknowns": pendulum,
    "five in space, 15 unknowns": lambda: points(5),
}


def settings(steps: int) -> Any:
    s = exu.SimulationSettings()
    s.timeIntegration.numberOfSteps, s.timeIntegration.endTime = steps, 1e-3 * steps
    s.timeIntegration.verboseMode = 0
    s.solutionSettings.writeSolutionToFile = False
    return s


def one_by_one(mbs: Any, target: Any, values: Any, steps: int) -> list[float]:
    item, name, _ = target
    found = []
    for value in values.tolist():
        mbs.SetObjectParameter(item, name, value)
        mbs.SolveDynamic(settings(steps))
        found.append(float(np.ravel(mbs.GetSensorValues(0))[0]))
    return found


def together(mbs: Any, target: Any, values: Any, steps: int) -> list[float]:
    results = mbs.SolveVariations({target[:2]: values}, settings(steps), numberOfThreads=1)
    assert results.success.all() and results.sideBySide.all()
    return list(results.sensorValues[:, 0])


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("variations", nargs="?", type=int, default=1000)
    parser.add_argument("steps", nargs="*", type=int, default=[10, 100, 1000])
    a = parser.parse_args()
    print(f"{a.variations} variations on one core")
    print(f"{'':26s} {'steps':>6s} {'loop (s)':>9s} {'together (s)':>13s} {'ratio':>6s}")
    for name, make in SYSTEMS.items():
        for steps in a.steps:
            seconds: dict[Any, float] = {one_by_one: np.inf, together: np.inf}
            for _ in range(ROUNDS):
                found = []
                for way in seconds:
                    mbs, target = make()
                    values = target[2] * np.linspace(0.5, 1.5, a.variations)
                    start = time.process_time()
                    found.append(way(mbs, target, values, steps))
                    seconds[way] = min(seconds[way], time.process_time() - start)
                assert found[0] == found[1], f"{name}: results differ"
            loop, side = seconds.values()
            print(f"{name:26s} {steps:6d} {loop:9.3f} {side:13.3f} {loop / side:6.1f}")


if __name__ == "__main__":
    main()
