"""Models of the benchmarks, written with what dalembert and Exudyn share, so that either package runs them."""

from __future__ import annotations

import importlib
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np


@dataclass(frozen=True)
class Package:
    """A package under test: its module and the modules of its items and utilities."""

    exu: Any
    items: Any
    utilities: Any

    @classmethod
    def load(cls, name: str) -> Package:
        """Import the package of that name."""
        return cls(*(importlib.import_module(name + part) for part in ("", ".itemInterface", ".utilities")))


@dataclass(frozen=True)
class Job:
    """A model that is assembled: `solve` is what is measured, `result` a number to compare.

    `iterations` tells how many iterations of Newton's method a dynamic solution has taken, `timer` how long its parts
    took. `settings` may be changed before.
    """

    solve: Callable[[], Any]
    result: Callable[[], float]
    iterations: Callable[[], int] = lambda: 0
    timer: Callable[[], Any] = lambda: None
    settings: Any = None
    mbs: Any = None


@dataclass(frozen=True)
class Case:
    """One line of the table: `build` makes the job anew for every repetition, which takes so many steps."""

    title: str
    build: Callable[[Package], Job]
    steps: int


def _settings(exu: Any, step: float, steps: int, modified_newton: bool = False) -> Any:
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = steps
    settings.timeIntegration.endTime = step * steps
    settings.timeIntegration.newton.useModifiedNewton = modified_newton
    settings.timeIntegration.verboseMode = 0
    settings.staticSolver.verboseMode = 0
    settings.solutionSettings.writeSolutionToFile = False
    settings.linearSolverType = exu.LinearSolverType.EigenSparse
    return settings


def _job(p: Package, mbs: Any, settings: Any, solver: str = "GeneralizedAlpha") -> Job:
    mbs.Assemble()
    solver_type = getattr(p.exu.DynamicSolverType, solver)
    return Job(
        solve=lambda: mbs.SolveDynamic(settings, solverType=solver_type),
        result=lambda: float(np.sum(mbs.systemData.GetODE2Coordinates())),
        iterations=lambda: int(mbs.sys["dynamicSolver"].it.newtonStepsCount),
        timer=lambda: mbs.sys["dynamicSolver"].timer,
        settings=settings,
        mbs=mbs,
    )


def oscillator(p: Package, steps: int) -> Job:
    """Build a mass on a spring, integrated by the explicit Euler method."""
    mbs = p.exu.SystemContainer().AddSystem()
    node = mbs.AddNode(p.items.NodePoint(initialCoordinates=[0.1, 0, 0]))
    mbs.AddObject(p.items.ObjectMassPoint(nodeNumber=node, physicsMass=2))
    ground = mbs.AddMarker(p.items.MarkerNodePosition(nodeNumber=mbs.AddNode(p.items.NodePointGround())))
    mass = mbs.AddMarker(p.items.MarkerNodePosition(nodeNumber=node))
    mbs.AddObject(
        p.items.ObjectConnectorCartesianSpringDamper(
            markerNumbers=[ground, mass], stiffness=[200] * 3, damping=[0.5] * 3
        )
    )
    settings = _settings(p.exu, 1e-4, steps)
    settings.linearSolverType = p.exu.LinearSolverType.EXUdense
    return _job(p, mbs, settings, "ExplicitEuler")


def top(p: Package, steps: int) -> Job:
    """Build a spinning top with Euler parameters on a spherical joint."""
    mbs = p.exu.SystemContainer().AddSystem()
    inertia = p.utilities.InertiaCylinder(density=2000, length=0.1, outerRadius=0.1, axis=2)
    body = mbs.CreateRigidBody(
        inertia=inertia, referencePosition=[0, 0, 0.2], initialAngularVelocity=[0, 0, 100], gravity=[0, 0, -9.81]
    )
    ground = mbs.AddObject(p.items.ObjectGround())
    markers = [
        mbs.AddMarker(p.items.MarkerBodyRigid(bodyNumber=ground)),
        mbs.AddMarker(p.items.MarkerBodyRigid(bodyNumber=body, localPosition=[0, 0, -0.2])),
    ]
    mbs.AddObject(p.items.ObjectJointSpherical(markerNumbers=markers))
    settings = _settings(p.exu, 1e-4, steps)
    settings.linearSolverType = p.exu.LinearSolverType.EXUdense
    return _job(p, mbs, settings)


def chain(p: Package, bodies: int, steps: int, modified_newton: bool = False) -> Job:
    """Build a chain of rigid bodies with revolute joints whose axes alternate."""
    exu, items = p.exu, p.items
    mbs = exu.SystemContainer().AddSystem()
    inertia = p.utilities.InertiaCuboid(density=2000, sideLengths=[0.2, 0.04, 0.04])
    axes = [np.eye(3), np.array([[1, 0, 0], [0, 0, 1], [0, -1, 0]], dtype=float)]
    previous, end = mbs.AddObject(items.ObjectGround()), 0.0
    for i in range(bodies):
        body = mbs.CreateRigidBody(
            inertia=inertia,
            referencePosition=[0.2 * i + 0.1, 0, 0],
            gravity=[0, -9.81, 2],
            nodeType=exu.NodeType.RotationEulerParameters,
        )
        markers = [
            mbs.AddMarker(items.MarkerBodyRigid(bodyNumber=previous, localPosition=[end, 0, 0])),
            mbs.AddMarker(items.MarkerBodyRigid(bodyNumber=body, localPosition=[-0.1, 0, 0])),
        ]
        turn = axes[i % 2]
        mbs.AddObject(items.ObjectJointRevoluteZ(markerNumbers=markers, rotationMarker0=turn, rotationMarker1=turn))
        previous, end = body, 0.1
    return _job(p, mbs, _settings(exu, 1e-3, steps, modified_newton))


def grid(p: Package, side: int, steps: int, solver: str, modified_newton: bool = False) -> Job:
    """Build a square net of point masses and spring-dampers, held at one edge."""
    items = p.items
    mbs = p.exu.SystemContainer().AddSystem()
    markers = {}
    for i in range(side):
        for j in range(side):
            where = [0.1 * i, 0.1 * j, 0.002 * np.sin(i + 2.0 * j)]
            if i == 0:
                node = mbs.AddNode(items.NodePointGround(referenceCoordinates=where))
            else:
                node = mbs.AddNode(items.NodePoint(referenceCoordinates=where))
                mbs.AddObject(items.ObjectMassPoint(nodeNumber=node, physicsMass=0.02))
            markers[i, j] = mbs.AddMarker(items.MarkerNodePosition(nodeNumber=node))
            if i > 0:
                mbs.AddLoad(items.LoadForceVector(markerNumber=markers[i, j], loadVector=[0, 0, -0.2]))
    for (i, j), marker in markers.items():
        for other, length in (((i + 1, j), 0.1), ((i, j + 1), 0.1), ((i + 1, j + 1), 0.1 * np.sqrt(2))):
            if other in markers and not (i == 0 and other[0] == 0):
                mbs.AddObject(
                    items.ObjectConnectorSpringDamper(
                        markerNumbers=[marker, markers[other]], stiffness=200, damping=0.05, referenceLength=length
                    )
                )
    step = 2e-3 if solver == "GeneralizedAlpha" else 2e-4
    return _job(p, mbs, _settings(p.exu, step, steps, modified_newton), solver)


def _cable(p: Package, elements: int, length: float, gravity: float) -> tuple[Any, list[Any]]:
    """Build a straight cable along x under gravity along y, and return the system and its nodes."""
    items = p.items
    mbs = p.exu.SystemContainer().AddSystem()
    size = length / elements
    nodes = [
        mbs.AddNode(items.NodePoint2DSlope1(referenceCoordinates=[i * size, 0, 1, 0])) for i in range(elements + 1)
    ]
    for pair in zip(nodes[:-1], nodes[1:], strict=True):
        cable = mbs.AddObject(
            items.ObjectANCFCable2D(
                nodeNumbers=list(pair),
                physicsLength=size,
                physicsMassPerLength=1.2,
                physicsBendingStiffness=40,
                physicsAxialStiffness=2e5,
            )
        )
        weight = mbs.AddMarker(items.MarkerBodyMass(bodyNumber=cable))
        mbs.AddLoad(items.LoadMassProportional(markerNumber=weight, loadVector=[0, gravity, 0]))
    return mbs, nodes


def _fix(p: Package, mbs: Any, node: Any, coordinates: tuple[int, ...]) -> None:
    ground = mbs.AddMarker(
        p.items.MarkerNodeCoordinate(nodeNumber=mbs.AddNode(p.items.NodePointGround()), coordinate=0)
    )
    for c in coordinates:
        marker = mbs.AddMarker(p.items.MarkerNodeCoordinate(nodeNumber=node, coordinate=c))
        mbs.AddObject(p.items.ObjectConnectorCoordinate(markerNumbers=[ground, marker]))


def cable(p: Package, elements: int, steps: int, modified_newton: bool = False) -> Job:
    """Build a cable that swings from one end."""
    mbs, nodes = _cable(p, elements, 2.0, -9.81)
    _fix(p, mbs, nodes[0], (0, 1))
    return _job(p, mbs, _settings(p.exu, 1e-3, steps, modified_newton))


def cantilever(p: Package, elements: int, steps: int) -> Job:
    """Build a cantilever with a force at its tip, which is raised in steps."""
    mbs, nodes = _cable(p, elements, 2.0, 0)
    _fix(p, mbs, nodes[0], (0, 1, 3))
    tip = mbs.AddMarker(p.items.MarkerNodePosition(nodeNumber=nodes[-1]))
    mbs.AddLoad(p.items.LoadForceVector(markerNumber=tip, loadVector=[0, -10, 0]))
    mbs.Assemble()
    settings = _settings(p.exu, 1, 1)
    settings.staticSolver.numberOfLoadSteps = steps
    settings.staticSolver.newton.relativeTolerance = 1e-7  # Exudyn stalls in rounding errors at 1e-8
    return Job(
        solve=lambda: mbs.SolveStatic(settings),
        result=lambda: float(mbs.systemData.GetODE2Coordinates()[-3]),  # deflection of the tip
    )


CASES = {
    "oscillator": Case("mass on a spring, explicit Euler", lambda p: oscillator(p, 200_000), 200_000),
    "top": Case("spinning top, implicit", lambda p: top(p, 5_000), 5_000),
    "chain10": Case("chain of 10 bodies", lambda p: chain(p, 10, 200), 200),
    "chain100": Case("chain of 100 bodies", lambda p: chain(p, 100, 200), 200),
    "chain1000": Case("chain of 1000 bodies", lambda p: chain(p, 1000, 50), 50),
    "chain100m": Case("chain of 100 bodies, modified Newton", lambda p: chain(p, 100, 200, True), 200),
    "grid30v": Case("net of 30 x 30, velocity Verlet", lambda p: grid(p, 30, 1000, "VelocityVerlet"), 1000),
    "grid100v": Case("net of 100 x 100, velocity Verlet", lambda p: grid(p, 100, 100, "VelocityVerlet"), 100),
    "grid30rk": Case("net of 30 x 30, Runge-Kutta 4", lambda p: grid(p, 30, 200, "RK44"), 200),
    "grid30i": Case("net of 30 x 30, implicit", lambda p: grid(p, 30, 20, "GeneralizedAlpha"), 20),
    "grid30m": Case("net of 30 x 30, modified Newton", lambda p: grid(p, 30, 50, "GeneralizedAlpha", True), 50),
    "cable10": Case("cable of 10 elements", lambda p: cable(p, 10, 200), 200),
    "cable100": Case("cable of 100 elements", lambda p: cable(p, 100, 200), 200),
    "cable1000": Case("cable of 1000 elements", lambda p: cable(p, 1000, 50), 50),
    "cantilever": Case("static cantilever of 256 elements", lambda p: cantilever(p, 256, 10), 10),
}
