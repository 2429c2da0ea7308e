"""Models that settings are tried on, and everything that can be seen of a solution."""

from __future__ import annotations

import contextlib
import io
import re
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from oscillators import friction_or_stop, mass, oscillator

import dalembert as exu
from dalembert.itemInterface import (
    CoordinateConstraint,
    LoadCoordinate,
    MarkerNodeCoordinate,
    NodeGenericODE1,
    ObjectGenericODE1,
    SensorNode,
)

Variable = exu.OutputVariableType
EXPLICIT = {name: getattr(exu.DynamicSolverType, name) for name in ("RK44", "DOPRI5", "ExplicitEuler")}


class Run(NamedTuple):
    error: str
    printed: str
    files: dict[str, str]  # without times of the day
    seen: list[dict[str, str]]  # the files after each step, of models that watch them
    table: np.ndarray  # time and value of the sensor
    state: list[list[float]]  # and the accelerations
    it: Any
    threads: int
    residual_size: int
    idle: float  # s of waiting for real time


def _files() -> dict[str, str]:
    paths = [path for path in Path().rglob("*") if path.is_file()]
    texts = {str(path): path.read_bytes().decode(errors="replace") for path in paths}
    return {name: re.sub(r"(started|finished).*|cpuTime=[^,]*", "", text) for name, text in texts.items()}


def solve(build: Callable[[], Any], change: dict[str, Any], solver: str, times: int) -> Run:
    """Build the model in an empty folder and solve it with the changed settings, through the solver's own class."""
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps, settings.staticSolver.numberOfLoadSteps = 10, 2
    settings.solutionSettings.writeSolutionToFile = False
    for path, value in change.items():
        group, _, name = path.rpartition(".")
        setattr(_at(settings, group), name, value)
    if solver in EXPLICIT:
        settings.timeIntegration.explicitIntegration.dynamicSolverType = EXPLICIT[solver]
    classes = {"static": exu.MainSolverStatic, "implicit": exu.MainSolverImplicitSecondOrder}
    tool: Any = classes.get(solver, exu.MainSolverExplicit)()
    printed, error = io.StringIO(), ""
    with tempfile.TemporaryDirectory() as folder, contextlib.chdir(folder), contextlib.redirect_stdout(printed):
        mbs = build()
        for _ in range(times):
            try:
                error = (
                    "" if tool.SolveSystem(mbs, settings) else f"failed: {tool.GetErrorString()}\n{tool.GetDiagnosis()}"
                )
            except (ValueError, RuntimeError) as problem:
                error = str(problem)
        files = _files()
    residual = _residual_size(tool)
    table = np.array(mbs.GetSensorStoredData(0))
    state = [*map(list, mbs.systemData.GetSystemState()), list(mbs.systemData.GetODE2Coordinates_tt())]
    seen = mbs.variables.get("seen", [])
    idle = tool.timer.realtimeIdleCPU
    return Run(
        error, printed.getvalue(), files, seen, table, state, tool.it, tool.output.numberOfThreadsUsed, residual, idle
    )


def _residual_size(tool: Any) -> int:
    """0 if the solver has nothing to show."""
    try:
        return int(tool.GetSystemResidual().size)
    except (RuntimeError, ValueError):
        return 0


def _at(settings: Any, path: str) -> Any:
    for name in path.split(".") if path else ():
        settings = getattr(settings, name)
    return settings


# ---- models ------------------------------------------------------------------------------------------------------------


def cubic(linear: float, factor: float) -> Any:
    def law(mbs: Any, t: float, item: int, u: float, v: float, k: float, d: float, offset: float) -> float:
        return linear * u + factor * u**3

    return law


def spring(force: float = 1.0, **parameters: Any) -> Any:
    """A mass on a spring under a load, not yet assembled; its sensor writes a file."""
    model = oscillator(**parameters)
    model.load(force)
    model.mbs.SetSensorParameter(model.sensor, "fileName", "sensor.txt")
    return model


def assembled(model: Any) -> Any:
    model.mbs.Assemble()
    return model.mbs


def oscillation() -> Any:
    return assembled(spring())


def nonlinear() -> Any:
    model = spring(force=30.0, law=cubic(80.0, 5e4))
    model.mbs.SetNodeParameter(model.node, "referenceCoordinates", [0.7])
    return assembled(model)


def steep() -> Any:
    return assembled(spring(force=200.0, law=cubic(1.0, 1e5), physics_mass=1e-3, position=0.0, speed=0.0))


def starting_in_balance() -> Any:
    return assembled(spring(force=1e-3, law=cubic(1e-3, 1e3), physics_mass=1e-12, position=0.0, speed=0.0))


def many() -> Any:
    """Equal springs in parallel."""
    model = spring(force=30.0, law=cubic(80.0, 5e3))
    for _ in range(24):
        node = model.mbs.AddNode(exu.Node1D(referenceCoordinates=[0], initialCoordinates=[0.3]))
        model.mbs.AddObject(exu.ObjectMass1D(nodeNumber=node, physicsMass=2))
        marker = model.mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=node, coordinate=0))
        model.mbs.AddObject(
            exu.ObjectConnectorCoordinateSpringDamper(
                markerNumbers=[model.ground, marker], springForceUserFunction=cubic(80.0, 5e3)
            )
        )
        model.mbs.AddLoad(LoadCoordinate(markerNumber=marker, load=30.0))
    return assembled(model)


def watched() -> Any:
    """Stores the contents of the files after each step."""
    model = spring()
    model.mbs.variables["seen"] = []

    def look(mbs: Any, t: float) -> bool:
        mbs.variables["seen"].append(_files())
        return True

    model.mbs.SetPostStepUserFunction(look)
    return assembled(model)


def _second_mass(mbs: Any) -> Any:
    node = mbs.AddNode(exu.Node1D(referenceCoordinates=[0], initialCoordinates=[0.0]))
    mbs.AddObject(exu.ObjectMass1D(nodeNumber=node, physicsMass=1))
    return mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=node, coordinate=0))


def coupled_by_the_user() -> Any:
    """The user's Jacobian couples masses that no item couples."""
    model = spring()
    other = _second_mass(model.mbs)
    model.mbs.AddObject(exu.ObjectConnectorCoordinateSpringDamper(markerNumbers=[model.ground, other], stiffness=1.0))
    entries = exu.MatrixContainer()
    entries.SetWithDenseMatrix([[0.0, 1e-9], [1e-9, 0.0]], useDenseMatrix=True)
    model.mbs.SetSystemJacobianUserFunction(lambda mbs, t, q, v, y: entries)
    return assembled(model)


def redundant() -> Any:
    model = spring()
    for name in ("once", "twice"):
        model.mbs.AddObject(CoordinateConstraint(name=name, markerNumbers=[model.ground, model.marker], offset=0.3))
    return assembled(model)


def contradictory() -> Any:
    model = spring()
    for offset in (0.3, 0.3001):
        model.mbs.AddObject(CoordinateConstraint(markerNumbers=[model.ground, model.marker], offset=offset))
    return assembled(model)


def door() -> Any:
    """How a moment is shared by the forces and moments of two hinges."""
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.CreateGround()
    inertia = exu.rigidBodyUtilities.InertiaCuboid(100, [1, 0.1, 2])
    leaf = mbs.CreateRigidBody(referencePosition=[0.5, 0, 0], inertia=inertia, gravity=[0, 0, -9.81])
    for height in (-0.5, 0.5):
        hinge = mbs.CreateRevoluteJoint(bodyNumbers=[ground, leaf], position=[0, 0, height], axis=[0, 0, 1])
    mbs.AddSensor(
        exu.itemInterface.SensorObject(objectNumber=hinge, storeInternal=True, outputVariableType=Variable.ForceLocal)
    )
    mbs.Assemble()
    return mbs


def held() -> Any:
    """A second mass, with a speed, is held by a constraint."""
    model = spring()
    node = model.mbs.AddNode(exu.Node1D(referenceCoordinates=[0], initialVelocities=[1.0]))
    model.mbs.AddObject(exu.ObjectMass1D(nodeNumber=node, physicsMass=1))
    marker = model.mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=node, coordinate=0))
    model.mbs.AddObject(CoordinateConstraint(markerNumbers=[model.ground, marker]))
    return assembled(model)


def everything() -> Any:
    """Coordinates of first and second order, a multiplier, and history."""
    model = spring()
    friction_or_stop(model, stiffness=0.0, fDynamicFriction=0.1, stickingStiffness=1e3, stickingDamping=5.0)
    other = _second_mass(model.mbs)
    model.mbs.AddObject(CoordinateConstraint(markerNumbers=[model.ground, other]))
    node = model.mbs.AddNode(
        NodeGenericODE1(referenceCoordinates=[0], initialCoordinates=[0.5], numberOfODE1Coordinates=1)
    )
    model.mbs.AddObject(ObjectGenericODE1(nodeNumbers=[node], systemMatrix=[[-1.0]], rhsVector=[1.0]))
    return assembled(model)


def chain(points: int = 100) -> Any:
    """Enough points for a sparse solver."""
    mbs = exu.SystemContainer().AddSystem()
    before = mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=mbs.AddObject(exu.ObjectGround())))
    for i in range(points):
        node = mbs.AddNode(exu.NodePoint(referenceCoordinates=[i + 1.0, 0, 0]))
        mbs.AddObject(exu.ObjectMassPoint(nodeNumber=node, physicsMass=1))
        marker = mbs.AddMarker(exu.MarkerNodePosition(nodeNumber=node))
        mbs.AddObject(exu.ObjectConnectorCartesianSpringDamper(markerNumbers=[before, marker], stiffness=[1, 1, 1]))
        before = marker
    mbs.AddSensor(SensorNode(nodeNumber=node, storeInternal=True, outputVariableType=Variable.Displacement))
    mbs.Assemble()
    return mbs


def long_chain() -> Any:
    """Enough points for two threads."""
    return chain(1500)


def _with_verdicts(verdict: Callable[[list[float]], list[float]]) -> Any:
    """The user decides about steps; `verdict` gets the times at which it was asked before."""
    model = spring()
    asked: list[float] = []

    def judge(mbs: Any, t: float) -> list[float]:
        answer = verdict([*asked, t])
        asked.append(t)
        return answer

    model.mbs.SetPostNewtonUserFunction(judge)
    return assembled(model)


def switching() -> Any:
    """The first solution of each step leaves an error of 5."""
    return _with_verdicts(lambda asked: [5.0 if asked.count(asked[-1]) == 1 else 0.0, -1.0])


def stopping() -> Any:
    """A mass that meets a stop between the ends of two steps."""
    model = mass(position=0.2, speed=-1.0)
    friction_or_stop(model, useLimitStops=True, limitStopsUpper=10.0, limitStopsStiffness=200.0)
    return assembled(model)


def rejecting() -> Any:
    """The first step has to be repeated, with any smaller size."""
    return _with_verdicts(lambda asked: [5.0 if len(asked) == 1 else 0.0, -1.0])


def recommending() -> Any:
    """The first step has to be repeated, with a fiftieth of a second."""
    return _with_verdicts(lambda asked: [5.0, 0.02] if len(asked) == 1 else [0.0, -1.0])


def reading_another() -> Any:
    """The force of one spring depends on where the other mass is, which no item says."""
    model = spring()
    other = _second_mass(model.mbs)

    def law(mbs: Any, t: float, item: int, u: float, v: float, k: float, d: float, offset: float) -> float:
        return 80.0 * (u - float(mbs.GetNodeOutput(model.node, Variable.Coordinates)))

    model.mbs.AddObject(
        exu.ObjectConnectorCoordinateSpringDamper(markerNumbers=[model.ground, other], springForceUserFunction=law)
    )
    return assembled(model)


def pendulum(length: float = 1, rate: float = 0) -> Any:
    """A point on a rod, at a distance of 1 that changes at the given rate, drawn by a spring."""
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.AddObject(exu.ObjectGround())
    node = mbs.AddNode(exu.NodePoint(referenceCoordinates=[1, 0, 0], initialVelocities=[rate, 0, 0]))
    mbs.AddObject(exu.ObjectMassPoint(nodeNumber=node, physicsMass=1))
    point = mbs.AddMarker(exu.MarkerNodePosition(nodeNumber=node))
    center = mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=ground))
    mbs.AddObject(exu.ObjectConnectorDistance(markerNumbers=[center, point], distance=length))
    mbs.AddObject(exu.ObjectConnectorCartesianSpringDamper(markerNumbers=[center, point], stiffness=[1, 20, 20]))
    mbs.AddLoad(exu.LoadForceVector(markerNumber=point, loadVector=[0, -9.81, 1]))
    mbs.AddSensor(SensorNode(nodeNumber=node, storeInternal=True, outputVariableType=Variable.Position))
    mbs.Assemble()
    return mbs


def truss(height: float = 0.5, load: float = 200.0) -> Any:
    """Two springs that meet above the line between their supports, in a plane, and a load that presses them through."""
    mbs = exu.SystemContainer().AddSystem()
    node = mbs.AddNode(exu.NodePoint2D(referenceCoordinates=[0, height]))
    mbs.AddObject(exu.ObjectMassPoint2D(nodeNumber=node, physicsMass=1))
    apex = mbs.AddMarker(exu.MarkerNodePosition(nodeNumber=node))
    for x in (-1, 1):
        support = mbs.AddMarker(
            exu.MarkerBodyPosition(bodyNumber=mbs.AddObject(exu.ObjectGround(referencePosition=[x, 0, 0])))
        )
        bar = {"stiffness": 1000, "referenceLength": float(np.hypot(1, height))}
        mbs.AddObject(exu.ObjectConnectorSpringDamper(markerNumbers=[support, apex], **bar))
    mbs.AddLoad(exu.LoadForceVector(markerNumber=apex, loadVector=[0, -load, 0]))
    mbs.AddSensor(SensorNode(nodeNumber=node, storeInternal=True, outputVariableType=Variable.Position))
    mbs.Assemble()
    return mbs


def steep_truss() -> Any:
    """Its apex sways aside before it snaps through."""
    return truss(3.0, 3000.0)


def open_pendulum() -> Any:
    return pendulum(length=1.05)


def stretching_pendulum() -> Any:
    return pendulum(rate=0.1)


def following_load() -> Any:
    model = spring()

    def force(mbs: Any, t: float, load: float) -> float:
        return -300.0 * float(mbs.GetNodeOutput(model.node, Variable.Coordinates)) ** 3

    model.mbs.AddLoad(LoadCoordinate(markerNumber=model.marker, load=1.0, loadUserFunction=force))
    return assembled(model)


def accelerated() -> Any:
    mbs = oscillation()
    mbs.systemData.SetODE2Coordinates_tt([3.0], configuration=exu.ConfigurationType.Initial)
    return mbs


def top() -> Any:
    """A body with rotation vector, turning about no principal axis, on springs to ground."""
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.CreateGround()
    body = mbs.CreateRigidBody(
        inertia=exu.utilities.InertiaCuboid(1000, [0.4, 0.2, 0.1]),
        nodeType=exu.NodeType.RotationRotationVector,
        initialAngularVelocity=[3, 7, 1],
    )
    for point in ([1, 0, 0], [0, 1, 0]):
        mbs.CreateCartesianSpringDamper(bodyNumbers=[ground, body], localPosition1=point, stiffness=[50, 60, 70])
    mbs.AddSensor(SensorNode(nodeNumber=0, storeInternal=True, outputVariableType=Variable.Rotation))
    mbs.Assemble()
    return mbs
