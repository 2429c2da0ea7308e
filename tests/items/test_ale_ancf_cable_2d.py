"""ObjectALEANCFCable2D and ObjectJointALEMoving2D against axially moving beams, and against ObjectANCFCable2D."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import scipy.linalg
from test_sliding_2d import bead_on_wire, bend_after_line

import dalembert as exu
from dalembert._core import testing

Variable = exu.OutputVariableType


class Belt:
    """A straight belt of unit length, mass and bending stiffness between two supports, whose material moves with a speed."""

    def __init__(
        self, elements: int, speed: float = 0.0, pull: float = 0.0, ale: bool = True, **parameters: Any
    ) -> None:
        self.mbs = mbs = exu.SystemContainer().AddSystem()
        self.elements = elements
        stiff = 1e8
        slope = 1 + pull / stiff  # the reference configuration is taut
        self.nodes = [
            mbs.AddNode(exu.NodePoint2DSlope1(referenceCoordinates=[x, 0, slope, 0]))
            for x in np.linspace(0, slope, elements + 1)
        ]
        common = {
            "physicsLength": 1 / elements,
            "physicsMassPerLength": 1.0,
            "physicsBendingStiffness": 1.0,
            "physicsAxialStiffness": stiff,
            **parameters,
        }
        self.way = mbs.AddNode(
            exu.NodeGenericODE2(
                numberOfODE2Coordinates=1,
                referenceCoordinates=[0.3],
                initialCoordinates=[0],
                initialCoordinates_t=[speed],
            )
        )
        pairs = zip(self.nodes[:-1], self.nodes[1:], strict=True)
        self.cables = [
            mbs.AddObject(
                exu.ObjectALEANCFCable2D(nodeNumbers=[*pair, self.way], **common)
                if ale
                else exu.ObjectANCFCable2D(nodeNumbers=list(pair), **common)
            )
            for pair in pairs
        ]
        self.ground = mbs.AddMarker(
            exu.MarkerNodeCoordinate(nodeNumber=mbs.AddNode(exu.NodePointGround()), coordinate=0)
        )

    def fix(self, node: Any, *coordinates: int) -> None:
        for coordinate in coordinates:
            marker = self.mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=node, coordinate=coordinate))
            self.mbs.AddObject(exu.ObjectConnectorCoordinate(markerNumbers=[self.ground, marker]))

    def frequencies(self, count: int) -> np.ndarray:
        """Frequencies of transverse motion between simple supports, at the initial speed."""
        self.mbs.Assemble()
        s = testing.State(self.mbs)
        k, d = (testing.tangent(self.mbs, s, cq=q, cv=v, ca=0) for q, v in ((1, 0), (0, 1)))
        m = testing.mass_matrix(self.mbs, s)
        n = 4 * (self.elements + 1)
        free = [i for i in range(1, n, 2) if i not in (1, n - 3)]  # y and slope in y, without the supports
        k, d, m = (a[np.ix_(free, free)] for a in (k, d, m))
        zero, one = np.zeros_like(k), np.eye(len(k))
        first = np.block([[zero, one], [-k, -d]])
        values = scipy.linalg.eigvals(first, scipy.linalg.block_diag(one, m))
        return np.sort(values.imag[values.imag > 1e-6])[:count]


# Exact roots of the axially moving beam, EI = rho A = L = 1, by tension and speed (J. A. Wickert, C. D. Mote, 1990).
MOVING = {
    (0, 1): (9.263787277, 39.068093972),
    (0, 2): (7.305539272, 37.815241235),
    (0, 3): (2.656632067, 35.647463151),
    (25, 2): (16.992085335, 48.925661754),
    (25, 4): (12.136965868, 44.199750018),
}


@pytest.mark.parametrize(("tension", "speed"), list(MOVING))
def test_frequencies_of_a_moving_beam(tension: float, speed: float) -> None:
    """The pull of the supports is tension and centripetal force."""
    found = Belt(24, speed, tension).frequencies(2)
    assert found == pytest.approx(MOVING[tension, speed], rel=2e-4)


def test_resting_material_is_a_cable() -> None:
    """Forces are the same but for the rounding of the stretch, which is one plus the strain, times the axial stiffness."""
    state, residuals = None, []
    for ale in (True, False):
        belt = Belt(2, 0.0, ale=ale, physicsAxialDamping=3, physicsBendingDamping=2)
        belt.mbs.Assemble()
        s = testing.State(belt.mbs)
        n = 12
        if state is None:
            state = np.random.default_rng(3).normal(size=(3, n)) * [[1e-3], [1], [1]]
        for name, values in zip("qva", state, strict=True):
            all_values = np.zeros(len(s.q))
            all_values[:n] = values
            setattr(s, name, all_values)
        residuals.append(testing.residual(belt.mbs, s)[:n])
    assert residuals[0] == pytest.approx(residuals[1], rel=1e-12, abs=1e8 * np.finfo(float).eps)


def test_material_velocity_and_forces() -> None:
    belt = Belt(2, speed=2.5, pull=7.0)
    belt.mbs.Assemble()
    velocity = belt.mbs.GetObjectOutputBody(belt.cables[0], Variable.Velocity, [0.2, 0.1, 0])
    assert np.asarray(velocity) == pytest.approx([2.5, 0, 0], abs=1e-6)
    force = belt.mbs.GetObjectOutputBody(belt.cables[0], Variable.ForceLocal, [0.2, 0, 0])
    assert force == pytest.approx(7.0, rel=1e-6)


@pytest.mark.parametrize("moving", [1.0, 0.4])
def test_momentum_of_the_moving_share(moving: float) -> None:
    """The axial coordinate is accelerated by weight along a fixed belt as a body of any mass is."""
    belt = Belt(3, physicsMovingMassFactor=moving)
    for node in belt.nodes:
        belt.fix(node, 0, 1, 2, 3)
    for cable in belt.cables:
        weight = belt.mbs.AddMarker(exu.MarkerBodyMass(bodyNumber=cable))
        belt.mbs.AddLoad(exu.LoadMassProportional(markerNumber=weight, loadVector=[4.0, -1, 0]))
    belt.mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.endTime, settings.timeIntegration.numberOfSteps = 0.5, 20
    belt.mbs.SolveDynamic(settings)
    assert belt.mbs.GetNodeOutput(belt.way, Variable.Coordinates) == pytest.approx(0.5, abs=1e-8)


def carried(penalty: float, index2: bool = False, damping: bool = False) -> tuple[np.ndarray, np.ndarray, float]:
    """A mass that a fixed, moving belt takes along with 3 m/s over two elements, under its weight."""
    belt = Belt(3, 3.0)
    mbs = belt.mbs
    for node in belt.nodes:
        belt.fix(node, 0, 1, 2, 3)
    belt.fix(belt.way)
    node = mbs.AddNode(exu.NodePoint2D(referenceCoordinates=[0.1, 0], initialVelocities=[3, 0]))
    mass = mbs.AddObject(exu.ObjectMassPoint2D(physicsMass=0.5, nodeNumber=node))
    marker = mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=mass))
    mbs.AddLoad(exu.LoadForceVector(markerNumber=marker, loadVector=[0, -2, 0]))
    markers = [mbs.AddMarker(exu.MarkerBodyCable2DCoordinates(bodyNumber=cable)) for cable in belt.cables]
    data = mbs.AddNode(exu.NodeGenericData(numberOfDataCoordinates=1, initialCoordinates=[0]))
    joint = mbs.AddObject(
        exu.ObjectJointALEMoving2D(
            markerNumbers=[marker, markers[0]],
            slidingMarkerNumbers=markers,
            slidingMarkerOffsets=[0, 1 / 3, 2 / 3],
            slidingOffset=0.1,
            nodeNumbers=[data, belt.way],
            usePenaltyFormulation=penalty > 0,
            penaltyStiffness=penalty,
        )
    )
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.endTime, settings.timeIntegration.numberOfSteps = 0.15, 60
    settings.timeIntegration.generalizedAlpha.spectralRadius = 0.5
    solver = exu.DynamicSolverType.TrapezoidalIndex2 if index2 else exu.DynamicSolverType.GeneralizedAlpha
    mbs.SolveDynamic(settings, solverType=solver)
    force = np.asarray(mbs.GetObjectOutput(joint, Variable.Force))
    place = np.asarray(mbs.GetNodeOutput(node, Variable.Position))
    return place, force, float(np.asarray(mbs.GetObjectOutput(joint, Variable.Coordinates))[0])


@pytest.mark.parametrize("index2", [False, True], ids=["index3", "index2"])
def test_belt_takes_a_mass_along(index2: bool) -> None:
    place, force, element = carried(0.0, index2)
    assert place == pytest.approx([0.55, 0, 0], abs=1e-8)
    assert np.abs(force) == pytest.approx([0, 2, 0], abs=1e-6)
    assert element == 1


@pytest.mark.parametrize("index2", [False, True], ids=["index3", "index2"])
def test_steps_end_between_elements(index2: bool) -> None:
    """A weight on a belt that weighs next to nothing and does not move across: the belt is straight, then curved, and the force jumps."""
    wire, mass, start, speed, end = bend_after_line(), 2.0, 0.3, 2.0, 0.6
    wanted = bead_on_wire(wire, mass, 0, start, speed, end)

    def error(steps: int, located: bool) -> float:
        mbs = exu.SystemContainer().AddSystem()
        ground = mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=mbs.AddNode(exu.NodePointGround()), coordinate=0))
        nodes = [mbs.AddNode(exu.NodePoint2DSlope1(referenceCoordinates=row)) for row in wire.nodes]
        for node in nodes:
            for k in range(4):
                held = mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=node, coordinate=k))
                mbs.AddObject(exu.ObjectConnectorCoordinate(markerNumbers=[ground, held]))
        way = mbs.AddNode(
            exu.NodeGenericODE2(
                numberOfODE2Coordinates=1, referenceCoordinates=[0], initialCoordinates=[0], initialCoordinates_t=[speed]
            )
        )  # fmt: skip
        cables = [
            mbs.AddObject(
                exu.ObjectALEANCFCable2D(
                    nodeNumbers=[*pair, way], physicsLength=1, physicsMassPerLength=1e-9, physicsBendingStiffness=1e-9,
                    physicsAxialStiffness=1e-9,
                )
            )
            for pair in zip(nodes[:-1], nodes[1:], strict=True)
        ]  # fmt: skip
        place, slope, _ = wire.at(start)
        point = mbs.AddNode(exu.NodePoint2D(referenceCoordinates=place, initialVelocities=speed * slope))
        body = mbs.AddObject(exu.ObjectMassPoint2D(physicsMass=mass, nodeNumber=point))
        carried = mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=body))
        mbs.AddLoad(exu.LoadForceVector(markerNumber=carried, loadVector=[0, -9 * mass, 0]))
        markers = [mbs.AddMarker(exu.MarkerBodyCable2DCoordinates(bodyNumber=cable)) for cable in cables]
        data = mbs.AddNode(exu.NodeGenericData(numberOfDataCoordinates=1, initialCoordinates=[0]))
        joint = mbs.AddObject(
            exu.ObjectJointALEMoving2D(
                markerNumbers=[carried, markers[0]], slidingMarkerNumbers=markers, slidingMarkerOffsets=wire.offsets,
                slidingOffset=start, nodeNumbers=[data, way],
            )
        )  # fmt: skip
        mbs.Assemble()
        settings = exu.SimulationSettings()
        settings.solutionSettings.writeSolutionToFile = False
        settings.timeIntegration.endTime, settings.timeIntegration.numberOfSteps = end, steps
        settings.timeIntegration.newton.relativeTolerance = 1e-10
        settings.timeIntegration.discontinuous.iterationTolerance = 1e-6  # m
        settings.events.ofItems = located
        solver = exu.DynamicSolverType.TrapezoidalIndex2 if index2 else exu.DynamicSolverType.GeneralizedAlpha
        mbs.SolveDynamic(settings, solverType=solver)
        assert mbs.sys["dynamicSolver"].it.eventsCount == located
        return abs(float(mbs.GetObjectOutput(joint, Variable.SlidingCoordinate)) - wanted)

    errors = [error(steps, located=True) for steps in (50, 100, 200)]
    for coarse, fine in zip(errors[:-1], errors[1:], strict=True):
        assert np.log2(coarse / fine) == pytest.approx(2, abs=0.3)
    assert error(50, located=False) > 3 * errors[0]  # steps that end anywhere


def test_soft_joint_gives_way() -> None:
    place, _, _ = carried(1e4)
    assert place[:2] == pytest.approx([0.55, -2e-4], abs=2.5e-4)


def test_joint_needs_the_coordinate_of_its_cables() -> None:
    belt = Belt(1)
    other = belt.mbs.AddNode(
        exu.NodeGenericODE2(
            numberOfODE2Coordinates=1, referenceCoordinates=[0], initialCoordinates=[0], initialCoordinates_t=[0]
        )
    )
    ground = belt.mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=belt.mbs.AddObject(exu.ObjectGround())))
    marker = belt.mbs.AddMarker(exu.MarkerBodyCable2DCoordinates(bodyNumber=belt.cables[0]))
    data = belt.mbs.AddNode(exu.NodeGenericData(numberOfDataCoordinates=1, initialCoordinates=[0]))
    belt.mbs.AddObject(
        exu.ObjectJointALEMoving2D(
            markerNumbers=[ground, marker],
            slidingMarkerNumbers=[marker],
            slidingMarkerOffsets=[0],
            nodeNumbers=[data, other],
        )
    )
    with pytest.raises(ValueError, match=r"markerNumbers.*third node is the second one of nodeNumbers"):
        belt.mbs.Assemble()


def test_share_above_one_is_refused() -> None:
    belt = Belt(1, physicsMovingMassFactor=1.5)
    with pytest.raises(ValueError, match=r"physicsMovingMassFactor.*a share of the mass"):
        belt.mbs.Assemble()


@pytest.mark.parametrize("share", [1.0, 0.5])
@pytest.mark.parametrize("offset", [0.0, 0.02])
def test_friction_of_a_circle_brakes_the_material(share: float, offset: float) -> None:
    """A cable whose axis is held: the slip is the speed of the material, and friction is the only force on its mass."""
    mbs, speed, length = exu.SystemContainer().AddSystem(), 3.0, 1.5
    ground = mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=mbs.AddNode(exu.NodePointGround()), coordinate=0))
    nodes = [mbs.AddNode(exu.NodePoint2DSlope1(referenceCoordinates=[x, 0, 1, 0])) for x in (0, length)]
    for node, coordinate in ((node, k) for node in nodes for k in range(4)):
        held = mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=node, coordinate=coordinate))
        mbs.AddObject(exu.CoordinateConstraint(markerNumbers=[ground, held]))
    way = mbs.AddNode(
        exu.NodeGenericODE2(
            numberOfODE2Coordinates=1, referenceCoordinates=[0], initialCoordinates=[0], initialCoordinates_t=[speed]
        )
    )
    cable = mbs.AddObject(
        exu.ObjectALEANCFCable2D(
            physicsLength=length, physicsMassPerLength=2, physicsBendingStiffness=1, physicsAxialStiffness=1e3,
            physicsMovingMassFactor=share, nodeNumbers=[*nodes, way],
        )
    )  # fmt: skip
    shape = mbs.AddMarker(exu.MarkerBodyCable2DShape(bodyNumber=cable, numberOfSegments=3, verticalOffset=offset))
    disc = mbs.AddMarker(
        exu.MarkerBodyRigid(bodyNumber=mbs.AddObject(exu.ObjectGround(referencePosition=[0.75, 0.19 + offset, 0])))
    )
    states = mbs.AddNode(
        exu.NodeGenericData(numberOfDataCoordinates=9, initialCoordinates=[1, -0.01, 1, -2, 0, -2, 0, 0, 0])
    )
    contact = mbs.AddObject(
        exu.ObjectContactFrictionCircleCable2D(
            markerNumbers=[disc, shape], nodeNumber=states, numberOfContactSegments=3, contactStiffness=1000,
            frictionVelocityPenalty=0.5, frictionCoefficient=3, circleRadius=0.2,
        )
    )  # fmt: skip
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.endTime, settings.timeIntegration.numberOfSteps = 0.2, 400
    settings.timeIntegration.verboseMode, settings.solutionSettings.writeSolutionToFile = 0, False
    mbs.SolveDynamic(settings)
    left = speed * np.exp(-0.5 * 0.2 / (2 * share * length))
    assert mbs.GetNodeOutput(way, Variable.Coordinates_t) == pytest.approx(left, rel=1e-6)
    along = np.asarray(mbs.GetObjectOutput(contact, Variable.ForceLocal))
    assert along[2:4] == pytest.approx([0.5 * left, -10], rel=1e-6)
