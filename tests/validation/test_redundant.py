"""Closed loops whose constraints follow from each other: motion, minimum-norm reactions, and reports of
contradictions."""

from __future__ import annotations

import threading
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from bricard_reference import third_corners
from scipy.spatial.transform import Rotation
from solving import Solver, Variable, new_system, settings
from test_bricard import Bricard

import dalembert as exu
from dalembert import _core
from dalembert._core import testing
from dalembert.rigidBodyUtilities import InertiaCuboid
from dalembert.solver import SolverError

Linear = exu.LinearSolverType
NODES = [
    exu.NodeType.RotationEulerParameters,
    exu.NodeType.RotationRxyz,
    exu.NodeType.RotationRotationVector,
]
LEAN = 0.2  # rad, of the axis of the door, unless a test says otherwise
MASS = 30.0
LENGTH_OF_CUBE = 3**0.5  # m, of the model of bars along its edges


def multipliers_of_joints(mbs: Any, length: float) -> tuple[np.ndarray, np.ndarray]:
    """Multipliers, and those with the same forces whose sum of squares, moments divided by a length, is smallest.

    Conditions of unit length belong to nodes: reactions normal to motions do not count.
    """
    state = testing.State(mbs)
    lam, first = np.asarray(state.lam), len(state.q) + len(state.y)
    forces = testing.tangent(mbs, state)[: len(state.q), first:]
    of_joints, meters = np.ones(len(lam), dtype=bool), np.zeros(len(state.q), dtype=bool)
    for node in range(mbs.systemData.NumberOfNodes()):
        meters[mbs.systemData.GetNodeLTGODE2(node)[:3]] = True
        of_joints[mbs.systemData.GetNodeLTGAE(node)] = False
    moments = ~(np.abs(forces[meters]) > 0).any(axis=0)
    weight = np.where(moments, length, 1.0)[of_joints]
    units = forces[:, ~of_joints]
    beside_units = np.eye(len(forces)) - units @ np.linalg.pinv(units)
    map_of_joints = beside_units @ forces[:, of_joints] * weight
    smallest = weight * (np.linalg.pinv(map_of_joints, rcond=1e-7) @ (beside_units @ forces @ lam))
    return lam[of_joints], smallest


def equations_without_unique_reactions(mbs: Any) -> int:
    """Equations of joints in combinations without a force."""
    state = testing.State(mbs)
    forces = testing.tangent(mbs, state)[: len(state.q), len(state.q) + len(state.y) :]
    sizes, combinations = np.linalg.svd(forces)[1:]
    vanishing = combinations[np.count_nonzero(sizes > 1e-7 * sizes[0]) :]
    part = np.linalg.norm(vanishing, axis=0) > 1e-6
    for node in range(mbs.systemData.NumberOfNodes()):
        part[mbs.systemData.GetNodeLTGAE(node)] = False
    return int(np.count_nonzero(part))


def assert_smallest(mbs: Any, length: float, tolerance: float = 1e-6) -> None:
    lam, smallest = multipliers_of_joints(mbs, length)
    assert np.linalg.norm(lam - smallest) <= tolerance * np.linalg.norm(smallest)


def redundancy(mbs: Any, solver: str = "dynamicSolver") -> dict[str, Any]:
    found: dict[str, Any] = mbs.sys[solver].GetRedundantConstraints()
    return found


def not_unique(mbs: Any, joints: Sequence[Any]) -> list[float]:
    """Return the number of non-unique reactions of each joint, from the last solution."""
    return [mbs.GetObjectOutput(joint, Variable.NonUniqueReactions) for joint in joints]


# ---- a door on hinges ----------------------------------------------------------------------------------------------------


class Door:
    """30 kg, 0.9 m wide and 2 m high, on an axis that leans, with hinges at these heights, the second one misplaced."""

    def __init__(
        self,
        heights: Sequence[float] = (0.3, 1.7),
        misplaced: float = 0,
        node: Any = NODES[0],
        lean: float = LEAN,
    ) -> None:
        self.mbs = new_system()
        ground = self.mbs.CreateGround()
        size = np.array([0.9, 0.04, 2.0])
        self.door = self.mbs.CreateRigidBody(
            referencePosition=[0.45, 0, 1],
            inertia=InertiaCuboid(density=MASS / np.prod(size), sideLengths=size),
            gravity=[0, 9.81 * np.sin(lean), -9.81 * np.cos(lean)],
            nodeType=node,
        )
        self.hinges = [self.hinge(ground, i, z, misplaced if i == 1 else 0.0) for i, z in enumerate(heights)]
        self.mbs.Assemble()

    def hinge(self, ground: Any, i: int, z: float, misplaced: float) -> Any:
        markers = [
            self.mbs.AddMarker(exu.itemInterface.MarkerBodyRigid(bodyNumber=body, localPosition=place))
            for body, place in ((ground, [misplaced, 0, z]), (self.door, [-0.45, 0, z - 1]))
        ]
        return self.mbs.AddObject(exu.itemInterface.ObjectJointRevoluteZ(name=f"hinge {i}", markerNumbers=markers))

    def add_spring(self) -> None:
        """Hold the edge."""
        markers = [
            self.mbs.AddMarker(exu.itemInterface.MarkerBodyPosition(bodyNumber=0, localPosition=[0.9, 0.5, 1])),
            self.mbs.AddMarker(exu.itemInterface.MarkerBodyRigid(bodyNumber=self.door, localPosition=[0.45, 0, 0])),
        ]
        self.mbs.AddObject(
            exu.itemInterface.ObjectConnectorSpringDamper(markerNumbers=markers, referenceLength=0.5, stiffness=1e4)
        )
        self.mbs.Assemble()

    def axial_forces(self) -> list[float]:
        return [abs(self.mbs.GetObjectOutput(hinge, Variable.ForceLocal)[2]) for hinge in self.hinges]

    def edge(self) -> np.ndarray:
        return np.asarray(self.mbs.GetObjectOutputBody(self.door, Variable.Position, [0.45, 0, 0]))


@pytest.mark.parametrize("linear", [Linear.EXUdense, Linear.EigenSparse])
@pytest.mark.parametrize("node", NODES)
@pytest.mark.parametrize("heights", [(0.3, 1.7), (0.3, 1.0, 1.7)])
def test_hinges_share_the_weight_of_a_door(linear: Any, node: Any, heights: Sequence[float]) -> None:
    door = Door(heights, node=node)
    s = settings(2, 200)
    s.linearSolverType = linear
    door.mbs.SolveDynamic(s)
    weight = MASS * 9.81 * np.cos(LEAN)
    assert door.axial_forces() == pytest.approx([weight / len(heights)] * len(heights), abs=1e-6)
    found = redundancy(door.mbs)
    assert found["count"] == 5 * (len(heights) - 1)
    assert [(item["removable"], item["equations"]) for item in found["items"]] == [(5, 5)] * len(heights)
    counts = door.mbs.ComputeSystemDegreeOfFreedom()
    assert counts["degreeOfFreedom"] == 1 and counts["redundantConstraints"] == found["count"]
    assert counts["removableEquations"] == {int(hinge): [5, 5] for hinge in door.hinges}
    assert not_unique(door.mbs, door.hinges) == [5] * len(heights)


@pytest.mark.parametrize("solver", [Solver.GeneralizedAlpha, Solver.DOPRI5, Solver.ESDIRK43])
def test_hinges_of_a_large_door_do_not_notice_those_of_a_small_one(solver: Any) -> None:
    """A lid of 0.2 g and a gate of 72 t: hinges of the gate differed by 6e-4 of their load with one metric for all
    mechanisms."""
    mbs = new_system()
    ground = mbs.CreateGround()
    carried = []
    for i, (scale, density) in enumerate([(1e-2, 2800), (10, 1000)]):
        place, size = np.array([20.0 * i, 0, 0]), scale * np.array([0.9, 0.04, 2.0])
        door = mbs.CreateRigidBody(
            referencePosition=place + scale * np.array([0.45, 0, 1]),
            inertia=InertiaCuboid(density=density, sideLengths=size),
            gravity=[0, 9.81 * np.sin(LEAN), -9.81 * np.cos(LEAN)],
        )
        weight = density * np.prod(size) * 9.81 * np.cos(LEAN)
        for height in (0.3, 1.7):
            ends = ((ground, place + [0, 0, scale * height]), (door, scale * np.array([-0.45, 0, height - 1])))
            markers = [mbs.AddMarker(exu.itemInterface.MarkerBodyRigid(bodyNumber=b, localPosition=p)) for b, p in ends]
            hinge = mbs.AddObject(exu.itemInterface.ObjectJointRevoluteZ(markerNumbers=markers))
            carried.append((hinge, weight / 2))
    mbs.Assemble()
    s = settings(0.5, 100)
    s.timeIntegration.automaticStepSize = False
    assert mbs.SolveDynamic(s, solverType=solver) is True
    for hinge, part in carried:
        assert abs(mbs.GetObjectOutput(hinge, Variable.ForceLocal)[2]) == pytest.approx(part, rel=1e-8)


def test_a_door_moves_as_with_one_hinge() -> None:
    two, one = Door(), Door((1.0,))
    for door in (two, one):
        door.mbs.SolveDynamic(settings(2, 200))
    assert two.edge() == pytest.approx(one.edge(), abs=1e-10)


@pytest.mark.parametrize("solver", [Solver.GeneralizedAlpha, Solver.TrapezoidalIndex2, Solver.DOPRI5, Solver.ESDIRK43])
def test_sensors_tell_of_reactions_that_are_not_unique(solver: Any) -> None:
    """A weight hangs on a ball joint, whose reactions are unique, from a door whose hinges' are not."""
    door = Door()
    mbs = door.mbs
    weight = mbs.CreateMassPoint(referencePosition=[0.9, 0, 0], physicsMass=1, gravity=[0, 0, -9.81])
    ball = mbs.CreateDistanceConstraint(bodyNumbers=[door.door, weight], localPosition0=[0.45, 0, 0])
    joints = [*door.hinges, ball]
    sensors = [
        mbs.AddSensor(
            exu.SensorObject(objectNumber=joint, outputVariableType=Variable.NonUniqueReactions, storeInternal=True)
        )
        for joint in joints
    ]
    mbs.Assemble()
    assert np.isnan(not_unique(mbs, joints)).all()  # nobody has looked
    mbs.SolveDynamic(settings(0.1, 10), solverType=solver)
    assert not_unique(mbs, joints) == [5, 5, 0]
    told = np.array([mbs.GetSensorStoredData(sensor)[:, 1] for sensor in sensors])
    assert (told[:, 1:] == np.array([[5], [5], [0]])).all()  # explicit solvers look in the first step
    with pytest.raises(ValueError, match="no output variable NonUniqueReactions"):
        mbs.GetObjectOutput(door.door, Variable.NonUniqueReactions)


def falling(steps: int = 50) -> Any:
    """Equal steps of this method, which has no others; weights of moments as in `assert_smallest`."""
    s = settings(0.5, steps)
    s.timeIntegration.automaticStepSize = False
    s.redundantConstraints.momentLength = 1.0
    return s


@pytest.mark.parametrize("node", NODES)
@pytest.mark.parametrize("linear", [Linear.EXUdense, Linear.EigenSparse])
def test_reactions_of_a_falling_door_stay_the_smallest(linear: Any, node: Any) -> None:
    """The null-space component rotates with the door. Ends of solutions are compared; sensors and user functions get
    the same values on the way."""
    told: list[Any] = []
    ends = []
    for steps in (25, 50):
        door, s = Door(node=node), falling(steps)
        s.timeIntegration.endTime = 0.01 * steps
        mbs, hinges = door.mbs, door.hinges
        sensors = [
            mbs.AddSensor(exu.SensorObject(objectNumber=h, outputVariableType=Variable.ForceLocal, storeInternal=True))
            for h in hinges
        ]
        mbs.Assemble()
        told.clear()

        def look(mbs: Any, t: float, hinges: Any = hinges) -> bool:
            told.append([mbs.GetObjectOutput(hinge, Variable.ForceLocal) for hinge in hinges])
            return True

        mbs.SetPreStepUserFunction(look)
        mbs.SetPostStepUserFunction(look)
        s.linearSolverType = linear
        assert mbs.SolveDynamic(s, solverType=Solver.ESDIRK43)
        assert_smallest(mbs, 1.0)
        ends.append([mbs.GetObjectOutput(hinge, Variable.ForceLocal) for hinge in hinges])
    stored = np.array([mbs.GetSensorStoredData(sensor)[:, 1:] for sensor in sensors]).transpose(1, 0, 2)
    np.testing.assert_array_equal(stored[[25, 50]], ends)
    np.testing.assert_array_equal(stored, told[::2])  # after each step ...
    np.testing.assert_array_equal(stored[:-1], told[1::2])  # ... and before the next one


@pytest.mark.parametrize(
    ("make", "solver"),
    [
        pytest.param(lambda: Door().mbs, Solver.GeneralizedAlpha, id="door"),
        pytest.param(lambda: Bricard({}).mbs, Solver.GeneralizedAlpha, id="Bricard"),
        pytest.param(lambda: Door().mbs, Solver.ESDIRK43, id="ESDIRK43"),
    ],
)
def test_output_has_no_influence_on_motions_with_redundant_reactions(make: Callable[[], Any], solver: Any) -> None:
    """Values are bit-identical, at times of steps and between them."""
    ends = []
    for looks in (False, True):
        mbs = make()
        s = settings(1, 500)
        if looks:
            joint = next(
                k for k in range(mbs.systemData.NumberOfObjects()) if "Joint" in mbs.GetObject(k)["objectType"]
            )
            mbs.AddSensor(
                exu.SensorObject(objectNumber=joint, outputVariableType=Variable.ForceLocal, storeInternal=True)
            )
            mbs.Assemble()
            mbs.SetPostStepUserFunction(lambda mbs, t: True)
            s.solutionSettings.sensorsWritePeriod = 0.004
            s.denseOutput.atRequestedTimes = solver != Solver.GeneralizedAlpha  # which would end steps at these times
        mbs.SolveDynamic(s, solverType=solver)
        data = mbs.systemData
        ends.append(
            [data.GetODE2Coordinates(), data.GetODE2Coordinates_t(), data.GetODE2Coordinates_tt()]
            + [data.GetAECoordinates()]
        )
    for one, other in zip(*ends, strict=True):
        np.testing.assert_array_equal(one, other)


@pytest.mark.parametrize("solver", [Solver.GeneralizedAlpha, Solver.ESDIRK43])
def test_symmetric_hinges_of_a_falling_door_have_symmetric_reactions(solver: Any) -> None:
    """The axis lies, the middle of the door between its hinges: each bears half. The third law's share of the middle one is another third."""
    for heights in ((0.3, 1.7), (0.2, 1.0, 1.8)):
        door = Door(heights, lean=np.pi / 2)
        door.mbs.SolveDynamic(falling(), solverType=solver)
        forces = [door.mbs.GetObjectOutput(hinge, Variable.ForceLocal) for hinge in door.hinges]
        for force in forces[1:]:
            assert force == pytest.approx(forces[0], abs=1e-6 * np.linalg.norm(forces[0]))


@pytest.mark.parametrize("solver", [Solver.GeneralizedAlpha, Solver.TrapezoidalIndex2, Solver.DOPRI5, Solver.ESDIRK43])
def test_hinges_that_actions_open_leave_nothing_redundant(solver: Any) -> None:
    """The second hinge opens on the way: the first one carries all of the weight along their axis from then on."""
    door = Door()
    mbs, second = door.mbs, door.hinges[1]

    def release(mbs: Any, t: float, event: int, direction: int) -> bool:
        mbs.SetObjectParameter(second, "activeConnector", False)
        return True

    mbs.SetEventsUserFunction(lambda mbs, t: [(t - 0.251, 1)])
    mbs.SetEventActionUserFunction(release)
    s = settings(0.5, 50)
    s.timeIntegration.automaticStepSize = False
    assert mbs.SolveDynamic(s, solverType=solver)
    assert door.axial_forces() == pytest.approx([MASS * 9.81 * np.cos(LEAN), 0], abs=1e-6)
    assert redundancy(mbs)["count"] == 0 and not_unique(mbs, door.hinges) == [0, 0]


@pytest.mark.parametrize(
    "solver", [Solver.GeneralizedAlpha, Solver.TrapezoidalIndex2, Solver.DOPRI5, Solver.RK44, Solver.ESDIRK43]
)
@pytest.mark.parametrize(
    "active",
    [
        [(1, 1), (1, 0), (1, 1)],
        [(1, 1), (0, 1), (1, 0)],
        [(1, 0), (1, 1), (0, 1)],
        [(0, 1), (1, 0), (1, 1)],
    ],
)
@pytest.mark.parametrize("by", ["events", "function before steps", "function after steps"])
def test_reactions_follow_hinges_that_are_switched(active: Sequence[tuple[int, int]], solver: Any, by: str) -> None:
    """Doors with alternating active hinges carry their weight, independently of earlier hinges; the motion is that on
    one of them.

    Functions before and after steps made ``ESDIRK43`` leave a hinge that joined another one without load, and numbers
    of non-unique reactions were those of before.
    """

    def moved(active: Sequence[tuple[int, int]]) -> tuple[Door, np.ndarray]:
        door = Door()
        mbs = door.mbs

        def switch(on: tuple[int, int]) -> None:
            for hinge, it_is in zip(door.hinges, on, strict=True):
                mbs.SetObjectParameter(hinge, "activeConnector", bool(it_is))

        def act(mbs: Any, t: float, event: int, direction: int) -> bool:
            switch(active[event + 1])
            return True

        switch(active[0])

        def follow(mbs: Any, t: float) -> bool:
            switch(active[(t > 0.1511) + (t > 0.3137)])
            return True

        if by == "events":
            mbs.SetEventsUserFunction(lambda mbs, t: [(t - 0.1511, 1), (t - 0.3137, 1)])
            mbs.SetEventActionUserFunction(act)
        elif by == "function before steps":
            mbs.SetPreStepUserFunction(follow)
        else:
            mbs.SetPostStepUserFunction(follow)
        sensors = [
            mbs.AddSensor(exu.SensorObject(objectNumber=hinge, outputVariableType=variable, storeInternal=True))
            for variable in (Variable.NonUniqueReactions, Variable.ForceLocal)
            for hinge in door.hinges
        ]
        mbs.Assemble()
        s = settings(0.45, 90, tolerance=1e-12)
        s.timeIntegration.automaticStepSize = False
        assert mbs.SolveDynamic(s, solverType=solver)
        stored = [mbs.GetSensorStoredData(sensor) for sensor in sensors]
        rows = [int(np.abs(stored[0][:, 0] - t).argmin()) for t in (0.1, 0.25, 0.4)]
        return door, np.array([[abs(values[row, -1]) for values in stored] for row in rows])

    door, told = moved(active)
    on = np.array(active)
    weight = MASS * 9.81 * np.cos(LEAN)
    np.testing.assert_array_equal(told[:, :2], 5 * on.all(axis=1, keepdims=True) * [1, 1])
    # ``TrapezoidalIndex2`` brings Euler parameters back to unit length at ends of steps, by the third power of the step.
    exact_to = 1e-6 * weight if solver is Solver.TrapezoidalIndex2 else 1e-6
    assert told[:, 2:] == pytest.approx(weight * on / on.sum(axis=1, keepdims=True), abs=exact_to)
    reference, _ = moved([(1, 0)] * 3)
    assert door.edge() == pytest.approx(
        reference.edge(), abs=1e-9
    )  # remaining velocities, by the tolerance of Newton's method


@pytest.mark.parametrize("node", NODES)
@pytest.mark.parametrize("steps", [2, 50])
def test_functions_that_do_nothing_change_no_reactions(steps: int, node: Any) -> None:
    """Velocity constraints, whose steps end with Euler parameters of unit length: reactions had the minimum norm for a
    slightly different state."""
    told = []
    for looks in (False, True):
        door = Door(node=node)
        sensors = [
            door.mbs.AddSensor(
                exu.SensorObject(objectNumber=h, outputVariableType=Variable.ForceLocal, storeInternal=True)
            )
            for h in door.hinges
        ]
        if looks:
            door.mbs.SetPreStepUserFunction(lambda mbs, t: True)
        door.mbs.Assemble()
        door.mbs.SolveDynamic(falling(steps), solverType=Solver.TrapezoidalIndex2)
        told.append(np.array([door.mbs.GetSensorStoredData(sensor) for sensor in sensors]))
    np.testing.assert_array_equal(told[1], told[0])


@pytest.mark.parametrize("opens", [True, False])
def test_reactions_after_events_are_of_second_order(opens: bool) -> None:
    """An event within a step leaves no swinging of reactions behind, not even without numerical damping: it was 2 N at
    10 ms and grew when it was of first order.

    Both hinges, or the remaining one, carry the load of a door on one hinge at these times, by another method with
    steps eighty times as small.
    """
    door = Door()
    door.mbs.SetObjectParameter(door.hinges[1], "activeConnector", False)
    exact = reactions_at_ends_of_steps(door, 4000, Solver.ESDIRK43)
    times, forces = exact[:, 0], exact[:, 1:]
    errors = []
    for steps in (50, 100):
        door = Door()
        h = 0.5 / steps
        at = 0.25 + 0.1 * h

        def release(mbs: Any, t: float, event: int, direction: int, door: Door = door) -> bool:
            if opens:
                mbs.SetObjectParameter(door.hinges[1], "activeConnector", False)
            return True

        door.mbs.SetEventsUserFunction(lambda mbs, t, at=at: [(t - at, 1)])
        door.mbs.SetEventActionUserFunction(release)
        found = reactions_at_ends_of_steps(door, steps, Solver.GeneralizedAlpha)
        after = found[found[:, 0] > at + 0.5 * h]
        wanted = np.column_stack([np.interp(after[:, 0], times, column) for column in forces.T])
        errors.append(np.abs(after[:, 1:] - wanted).max())
    assert errors[0] < 0.05  # N, of 294 N
    assert errors[0] > 3 * errors[1]


@pytest.mark.parametrize("part", [0.01, 0.1, 0.6])
def test_reactions_are_of_second_order_in_steps_that_are_cut(part: float) -> None:
    """An event without an action after this part of a step, or the end: reactions were off by as much as steps are
    long, and more in short ones."""
    exact = reactions_at_ends_of_steps(Door(), 4000, Solver.ESDIRK43)
    errors = []
    for steps in (50, 100):
        door = Door()
        at = 0.25 + part * 0.5 / steps
        door.mbs.SetEventsUserFunction(lambda mbs, t, at=at: [(t - at, 1)])
        found = reactions_at_ends_of_steps(door, steps, Solver.GeneralizedAlpha, 0.6)
        since = found[found[:, 0] >= at - 1e-9]
        wanted = np.column_stack([np.interp(since[:, 0], exact[:, 0], column) for column in exact[:, 1:].T])
        errors.append(np.abs(since[:, 1:] - wanted).max())
    assert errors[0] < 0.02  # N, of 294 N
    assert errors[0] > 3 * errors[1]


def reactions_at_ends_of_steps(door: Door, steps: int, solver: Any, spectral_radius: float = 1) -> np.ndarray:
    """Times and the sum of the forces in both hinges."""
    found = []

    def note(mbs: Any, t: float) -> bool:
        found.append([t, *sum(mbs.GetObjectOutput(hinge, Variable.ForceLocal) for hinge in door.hinges)])
        return True

    door.mbs.SetPostStepUserFunction(note)
    s = settings(0.5, steps, spectral_radius)
    s.timeIntegration.automaticStepSize = False
    assert door.mbs.SolveDynamic(s, solverType=solver)
    return np.array(found)


def test_viewers_see_the_smallest_reactions() -> None:
    """A solution without other readers: idle parts are taken off for them."""
    mbs = Bricard({}).mbs
    shadow, seen, ends = _core._Shadow(mbs), [], threading.Event()
    shadow.follow()

    def look() -> None:
        data, shown = shadow.system.systemData, exu.ConfigurationType.Visualization
        while not ends.wait(1e-3):
            if shadow.follow()[0]:
                seen.append([np.array(f(shown)) for f in (data.GetODE2Coordinates, data.GetAECoordinates)])

    viewer = threading.Thread(target=look)
    viewer.start()
    try:
        assert mbs.SolveDynamic(settings(100, 20_000))
    finally:
        ends.set()
        viewer.join()
    assert seen
    for q, lam in seen:
        mbs.systemData.SetODE2Coordinates(q)
        mbs.systemData.SetAECoordinates(lam)
        assert_smallest(mbs, 3**0.5)


@pytest.mark.parametrize("solver", [Solver.GeneralizedAlpha, Solver.ESDIRK43])
@pytest.mark.parametrize("end", ["last step", "exception", "stopped"])
def test_reactions_are_the_smallest_at_ends_however_solutions_end(end: str, solver: Any) -> None:
    """Idle parts are taken off only where somebody looks: after the last step and at its start, and after an
    exception."""

    def interfere(mbs: Any, t: float) -> bool:
        if t > 0.5 and end == "exception":
            raise ZeroDivisionError
        return end == "exception" or t < 0.5

    mbs = Bricard({}).mbs
    s = settings(0.75, 150, spectral_radius=1.0)
    s.timeIntegration.automaticStepSize = False
    s.redundantConstraints.momentLength = LENGTH_OF_CUBE
    if end == "exception":
        mbs.SetPreStepUserFunction(interfere)
        with pytest.raises(ZeroDivisionError):
            mbs.SolveDynamic(s, solverType=solver)
    elif end == "stopped":
        mbs.SetPostStepUserFunction(interfere)
        mbs.SolveDynamic(s, solverType=solver)
        assert mbs.systemData.GetTime() == pytest.approx(0.5)
    else:
        mbs.SolveDynamic(s, solverType=solver)
    assert_smallest(mbs, LENGTH_OF_CUBE)
    data, start = mbs.systemData, exu.ConfigurationType.StartOfStep
    q, lam = np.array(data.GetODE2Coordinates(start)), np.array(data.GetAECoordinates(start))
    data.SetODE2Coordinates(q)
    data.SetAECoordinates(lam)
    assert_smallest(mbs, LENGTH_OF_CUBE)


def test_without_treatment_a_door_is_singular() -> None:
    s = settings(0.1, 10)
    s.redundantConstraints.treat = False
    with pytest.raises(SolverError, match="singular"):
        Door().mbs.SolveDynamic(s)


def test_a_door_at_rest() -> None:
    """A spring holds it: the static solver finds the same weights."""
    door = Door()
    door.add_spring()
    s = settings(1, 1)
    s.staticSolver.verboseMode = 0
    door.mbs.SolveStatic(s)
    assert redundancy(door.mbs, "staticSolver")["count"] == 5
    total = MASS * 9.81 * np.cos(LEAN)
    first, second = door.axial_forces()
    assert first == pytest.approx(second, abs=1e-6) and first + second == pytest.approx(total, rel=1e-2)


# ---- six full joints in a loop -----------------------------------------------------------------------------------------


@pytest.mark.parametrize("linear", [Linear.EXUdense, Linear.EigenSparse])
def test_bricard_with_six_full_joints(linear: Any) -> None:
    full, freed = Bricard({}), Bricard({5: 0})
    s = settings(1, 200, spectral_radius=1.0, tolerance=1e-8)
    s.linearSolverType = linear
    for mechanism in (full, freed):
        mechanism.mbs.SolveDynamic(s)
    assert np.linalg.norm(full.third_corner() - third_corners()[1.0]) <= 2.1e-5
    assert full.third_corner() == pytest.approx(freed.third_corner(), abs=1e-10)
    assert full.mbs.sys["dynamicSolver"].it.newtonStepsCount / 200 == pytest.approx(2, abs=0.1)
    found = redundancy(full.mbs)
    assert found["count"] == 1
    assert [(item["removable"], item["equations"]) for item in found["items"]] == [(1, 5)] * 6


@pytest.mark.parametrize("level", ["index 3", "index 2"])
@pytest.mark.parametrize("modified", [False, True])
def test_bricard_by_all_kinds_of_newton(level: str, modified: bool) -> None:
    s = settings(1, 200, spectral_radius=1.0)
    s.timeIntegration.newton.useModifiedNewton = modified
    s.timeIntegration.generalizedAlpha.useIndex2Constraints = level == "index 2"
    s.timeIntegration.generalizedAlpha.useNewmark = level == "index 2"
    full, freed = Bricard({}), Bricard({5: 0})
    for mechanism in (full, freed):
        mechanism.mbs.SolveDynamic(s)
    wanted = third_corners()[1.0]
    errors = [np.linalg.norm(mechanism.third_corner() - wanted) for mechanism in (full, freed)]
    assert errors[0] < 2 * errors[1]


@pytest.mark.parametrize("solver", [Solver.GeneralizedAlpha, Solver.DOPRI5, Solver.ESDIRK43])
def test_what_is_redundant_is_known_after_the_last_restart_file(solver: Any, tmp_path: Path) -> None:
    s = settings(0.1, 20)
    s.solutionSettings.writeRestartFile = True
    s.solutionSettings.restartFileName = str(tmp_path / "restart.txt")
    s.redundantConstraints.momentLength = LENGTH_OF_CUBE
    mbs = Bricard({}).mbs
    mbs.SolveDynamic(s, solverType=solver)
    assert redundancy(mbs)["count"] == 1
    assert_smallest(mbs, LENGTH_OF_CUBE)


@pytest.mark.parametrize("level", ["index 3", "index 2"])
@pytest.mark.parametrize("modified", [False, True])
def test_reactions_are_the_smallest_with_all_kinds_of_newton(level: str, modified: bool) -> None:
    """Matrices of earlier states have other forces, and those of index 2 rows that velocities turn."""
    s = settings(0.5, 200)
    s.redundantConstraints.momentLength = LENGTH_OF_CUBE
    s.timeIntegration.newton.useModifiedNewton = modified
    s.timeIntegration.generalizedAlpha.useIndex2Constraints = level == "index 2"
    s.timeIntegration.generalizedAlpha.useNewmark = level == "index 2"
    mbs = Bricard({}).mbs
    mbs.SolveDynamic(s)
    assert_smallest(mbs, LENGTH_OF_CUBE)


# ---- random closed mechanisms ------------------------------------------------------------------------------------------


class ClosedChain:
    """Bars in a plane in space, joined to each other and to the ground by revolute joints normal to the plane.

    unit: units of length per metre.
    """

    def __init__(self, random: np.random.Generator, bars: int, node: Any, unit: float = 1) -> None:
        self.mbs, self.unit = new_system(), unit
        self.joints: list[Any] = []
        ground = self.mbs.CreateGround()
        turn = Rotation.random(random_state=random).as_matrix()
        angles = np.sort(random.uniform(0, 2 * np.pi, bars + 1)) + np.arange(bars + 1) * 1e-2
        radii = random.uniform(0.5, 1.5, bars + 1) * unit
        corners = [turn @ [r * np.cos(a), r * np.sin(a), 0] for r, a in zip(radii, angles, strict=True)]
        bodies = [ground]
        for start, end in zip(corners[:-1], corners[1:], strict=True):
            bodies.append(self.bar(start, end, turn[:, 2], random, node))
        bodies.append(ground)
        for corner, pair in zip(corners, zip(bodies[:-1], bodies[1:], strict=True), strict=True):
            joint = self.mbs.CreateRevoluteJoint(bodyNumbers=list(pair), position=corner, axis=turn[:, 2])
            self.joints.append(joint)
        self.mbs.Assemble()

    def bar(
        self, start: np.ndarray, end: np.ndarray, normal: np.ndarray, random: np.random.Generator, node: Any
    ) -> Any:
        along = (end - start) / np.linalg.norm(end - start)
        size = [float(np.linalg.norm(end - start)), 0.1 * self.unit, 0.05 * self.unit]
        return self.mbs.CreateRigidBody(
            referencePosition=(start + end) / 2,
            referenceRotationMatrix=np.column_stack([along, np.cross(normal, along), normal]),
            inertia=InertiaCuboid(density=random.uniform(500, 5000) / self.unit**3, sideLengths=size),
            gravity=[0, 0, -9.81 * self.unit],
            nodeType=node,
        )


@pytest.mark.parametrize("node", NODES)
@pytest.mark.parametrize("linear", [Linear.EXUdense, Linear.EigenSparse])
@pytest.mark.parametrize("bars", [3, 4, 5, 6, 7])
def test_planar_loops_in_space(node: Any, linear: Any, bars: int) -> None:
    """n bars and the ground: each loop has three equations too many; reactions are those of numpy's singular values."""
    random = np.random.default_rng(bars)
    for _ in range(7):
        chain = ClosedChain(random, bars, node)
        s = settings(0.02, 20, tolerance=1e-12)  # the last matrix is that of the last state
        s.linearSolverType = linear
        s.redundantConstraints.momentLength = 1.0
        chain.mbs.SolveDynamic(s)
        assert redundancy(chain.mbs)["count"] == 3
        assert_smallest(chain.mbs, 1.0)
        counts = chain.mbs.ComputeSystemDegreeOfFreedom()
        assert (counts["degreeOfFreedom"], counts["redundantConstraints"]) == (bars - 2, 3)
        assert sum(not_unique(chain.mbs, chain.joints)) == equations_without_unique_reactions(chain.mbs)


# ---- a platform on legs ------------------------------------------------------------------------------------------------


def stewart_platform(legs: int) -> Any:
    """A platform on legs of fixed lengths between spherical joints, which turn about their own axes; more than six are redundant."""
    mbs = new_system()
    ground = mbs.CreateGround()
    platform = mbs.CreateRigidBody(
        referencePosition=[0, 0, 1], inertia=InertiaCuboid(1000, [1, 1, 0.1]), gravity=[0, 0, -9.81]
    )
    for i in range(legs):
        foot_angle, head_angle = 2 * np.pi * (i + 0.3 * (-1) ** i) / legs, 2 * np.pi * (i - 0.2 * (-1) ** i) / legs
        foot = np.array([1.5 * np.cos(foot_angle), 1.5 * np.sin(foot_angle), 0])
        head = np.array([0.6 * np.cos(head_angle), 0.6 * np.sin(head_angle), 1])
        along = (head - foot) / np.linalg.norm(head - foot)
        side = np.cross([0, 0, 1], along) / np.linalg.norm(np.cross([0, 0, 1], along))
        leg = mbs.CreateRigidBody(
            referencePosition=(foot + head) / 2,
            referenceRotationMatrix=np.column_stack([along, side, np.cross(along, side)]),
            inertia=InertiaCuboid(1000, [float(np.linalg.norm(head - foot)), 0.1, 0.1]),
            gravity=[0, 0, -9.81],
        )
        mbs.CreateSphericalJoint(bodyNumbers=[ground, leg], position=foot)
        mbs.CreateSphericalJoint(bodyNumbers=[leg, platform], position=head)
    mbs.Assemble()
    return mbs


@pytest.mark.parametrize(("legs", "redundant"), [(6, 0), (8, 2), (9, 3)])
def test_stewart_platform(legs: int, redundant: int) -> None:
    mbs = stewart_platform(legs)
    counts = mbs.ComputeSystemDegreeOfFreedom()
    assert (counts["degreeOfFreedom"], counts["redundantConstraints"]) == (legs, redundant)
    mbs.SolveDynamic(settings(0.1, 20, tolerance=1e-12))
    assert redundancy(mbs)["count"] == redundant
    assert_smallest(mbs, 1.0)
    start = [0, 0, 1]
    place = mbs.GetNodeOutput(mbs.GetObject(exu.ObjectIndex(1))["nodeNumber"], Variable.Position)
    assert place == pytest.approx(start, abs=1e-9)  # it is held


@pytest.mark.parametrize("linear", [Linear.EXUdense, Linear.EigenSparse])
def test_regular_models_do_not_notice(linear: Any) -> None:
    """Bit for bit, multipliers among them."""
    results = []
    for treat in (True, False):
        bricard, s = Bricard({5: 0}), settings(0.5, 100)
        s.linearSolverType = linear
        s.redundantConstraints.treat = treat
        bricard.mbs.SolveDynamic(s)
        data = bricard.mbs.systemData
        results.append([data.GetODE2Coordinates(), data.GetODE2Coordinates_t(), data.GetAECoordinates()])
    for one, other in zip(*results, strict=True):
        assert np.array_equal(one, other)
