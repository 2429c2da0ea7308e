"""What single calls from Python cost: parameters in models of several sizes, small solves, robots, rotations, graphics,
imports.

`python benchmarks/python_calls.py` prints microseconds of processor time per call, the least of five rounds.
`--module exudyn` measures another package with the same interface, in an environment that has it.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from importlib import import_module
from typing import Any

import numpy as np

Calls = Iterator[tuple[str, Callable[[], Any]]]
ROUNDS, SECONDS = 5, 0.05
ANGLES = [0.0, -0.7, -0.7, -0.7, 0.7, 1.5]


def cost(call: Callable[[], Any]) -> float:
    """Return microseconds per call."""
    call()
    count = 1
    while True:
        start = time.process_time()
        for _ in range(count):
            call()
        if time.process_time() - start > SECONDS / ROUNDS:
            break
        count *= 2
    best = np.inf
    for _ in range(ROUNDS):
        start = time.process_time()
        for _ in range(count):
            call()
        best = min(best, (time.process_time() - start) / count)
    return 1e6 * float(best)


class Package:
    """The modules of one package."""

    def __init__(self, name: str) -> None:
        self.name, self.exu = name, import_module(name)
        self.items, self.utilities = self.module("itemInterface"), self.module("utilities")

    def module(self, name: str) -> Any:
        return import_module(f"{self.name}.{name}")

    def system(self) -> Any:
        return self.exu.SystemContainer().AddSystem()


def parameters(package: Package) -> Calls:
    items = package.items
    for count in (1, 3000):
        mbs = package.system()
        for i in range(count):
            node = mbs.AddNode(items.NodePoint(referenceCoordinates=[i, 0, 0]))
            body = mbs.AddObject(items.MassPoint(physicsMass=1.0, nodeNumber=node))
            marker = mbs.AddMarker(items.MarkerBodyPosition(bodyNumber=body))
            load = mbs.AddLoad(items.LoadForceVector(markerNumber=marker, loadVector=[0, 0, 0]))
        mbs.Assemble()
        set_object, set_load = mbs.SetObjectParameter, mbs.SetLoadParameter
        yield f"mass, {count} masses", lambda f=set_object, i=body: f(i, "physicsMass", 2.0)
        yield f"load, {count} masses", lambda f=set_load, i=load: f(i, "loadVector", [0.0, 0.0, 1.0])
    for count in (3, 300):
        mbs, zero, one = package.system(), np.zeros(count), np.eye(count)
        node = mbs.AddNode(
            items.NodeGenericODE2(
                numberOfODE2Coordinates=count,
                referenceCoordinates=zero,
                initialCoordinates=zero,
                initialCoordinates_t=zero,
            )
        )
        matrices = {"massMatrix": one, "stiffnessMatrix": one, "dampingMatrix": one}
        body = mbs.AddObject(items.ObjectGenericODE2(nodeNumbers=[node], forceVector=zero, **matrices))
        mbs.Assemble()
        yield (
            f"forces, {count} coordinates",
            lambda f=mbs.SetObjectParameter, i=body, x=zero: f(i, "forceVector", x),
        )


def solves(package: Package) -> Calls:
    exu, items = package.exu, package.items
    mbs = package.system()
    node = mbs.AddNode(items.NodePoint(initialVelocities=[1, 0, 0]))
    mbs.AddObject(items.MassPoint(physicsMass=1, nodeNumber=node))
    position = exu.OutputVariableType.Position
    sensor = mbs.AddSensor(items.SensorNode(nodeNumber=node, outputVariableType=position, storeInternal=True))
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.solutionSettings.writeSolutionToFile = False
    settings.solutionSettings.sensorsWritePeriod = 1e-3
    time_integration = settings.timeIntegration
    time_integration.verboseMode = 0
    time_integration.numberOfSteps, time_integration.endTime = 1000, 1
    mbs.SolveDynamic(settings)
    yield "GetSensorStoredData of 1000 rows", lambda: mbs.GetSensorStoredData(sensor)
    yield "OutputVariableType.Position", lambda: exu.OutputVariableType.Position
    time_integration.numberOfSteps, time_integration.endTime = 1, 1e-6
    yield "SolveDynamic of one step", lambda: mbs.SolveDynamic(settings)
    yield "Assemble of one mass", mbs.Assemble
    large = package.system()
    for i in range(3000):
        large.CreateRigidBody(inertia=package.utilities.InertiaSphere(1, 1), referencePosition=[i, 0, 0])
    yield "Assemble of 3000 rigid bodies", large.Assemble


def graphics(package: Package) -> Calls:
    shapes = package.module("graphics")
    sphere = shapes.Sphere(nTiles=16)
    yield "graphics.Brick", lambda: shapes.Brick(size=[1, 1, 1], color=shapes.color.red)
    yield "graphics.MergeTriangleLists", lambda: shapes.MergeTriangleLists(sphere, sphere)


def robots(package: Package) -> Calls:
    robotics, models = package.module("robotics"), package.module("robotics.models")
    tool = robotics.RobotTool(HT=package.utilities.HTtranslate([0, 0, 0.1]))
    empty = robotics.Robot(gravity=[0, 0, 9.81], tool=tool, referenceConfiguration=[])
    robot = models.LinkDict2Robot(models.ManipulatorUR5(), empty)
    mbs = package.system()
    tree = robot.CreateKinematicTree(mbs)["objectKinematicTree"]
    mbs.Assemble()
    for name in ("jointPositionOffsetVector", "jointForceVector"):
        yield f"{name} of a tree", lambda name=name: mbs.SetObjectParameter(tree, name, ANGLES)
    HT = robot.JointHT(ANGLES)
    yield "Robot.JointHT", lambda: robot.JointHT(ANGLES)
    yield "Robot.COMHT", lambda: robot.COMHT(HT)
    yield "Robot.Jacobian", lambda: robot.Jacobian(HT)
    yield "Robot.StaticTorques", lambda: robot.StaticTorques(HT)
    kinematics = robotics.InverseKinematicsNumerical(robot=robot, useRenderer=False)
    goal = np.array(robot.JointHT(np.array(ANGLES) + 0.001)[-1])
    yield "InverseKinematicsNumerical.Solve", lambda: kinematics.Solve(goal, ANGLES)


def rotations(package: Package) -> Calls:
    u, v = package.utilities, [0.1, 0.2, 0.3]
    A = np.array(u.RotXYZ2RotationMatrix(v))
    p, T = np.array(u.RotationMatrix2EulerParameters(A)), np.array(u.HTtranslate(v)) @ np.array(u.HTrotateX(0.3))
    arguments: dict[str, tuple[Any, ...]] = {
        "RotXYZ2RotationMatrix": (v,),
        "RotXYZ2EulerParameters": (v,),
        "RotationMatrix2RotXYZ": (A,),
        "RotationVector2RotationMatrix": (v,),
        "RotationMatrix2RotationVector": (A,),
        "EulerParameters2G": (p,),
        "EulerParameters2RotationMatrix": (p,),
        "Skew": (v,),
        "HTtranslate": (v,),
        "HTrotateZ": (0.1,),
        "HomogeneousTransformation": (A, v),
        "HT2rotationMatrix": (T,),
        "HT2translation": (T,),
        "InverseHT": (T,),
        "InertiaCuboid": (1000, v),
    }
    for name, values in arguments.items():
        yield name, lambda f=getattr(u, name), values=values: f(*values)


def first_time(line: str, prepared: str = "import numpy") -> float:
    """Return microseconds that a line takes in a new process."""
    code = f"{prepared}; import time; t = time.process_time(); {line}; print(time.process_time() - t)"
    runs = [
        subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True) for _ in range(ROUNDS)
    ]
    return min(1e6 * float(run.stdout.split()[-1]) for run in runs)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--module", default="dalembert")
    package = Package(parser.parse_args().module)
    for measured in (parameters, solves, robots, rotations, graphics):
        for name, call in measured(package):
            print(f"{name:40} {cost(call):12.2f}")
    for module in ("", ".utilities", ".robotics", ".FEM"):
        line = f"import {package.name}{module}"
        print(f"{line:40} {first_time(line):12.0f}")
    prepared = f"import {package.name}.utilities; mbs = {package.name}.SystemContainer().AddSystem()"
    print(f"{'first mbs.CreateGround':40} {first_time('mbs.CreateGround()', prepared):12.0f}")


if __name__ == "__main__":
    main()
