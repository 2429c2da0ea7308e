"""Contact, friction and stops of items whose switching ends steps (events.ofItems)."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from oscillators import MASS, dynamic_settings, friction_or_stop, mass
from scipy.integrate import solve_ivp

import dalembert as exu
from dalembert import itemInterface as eii
from dalembert.utilities import InertiaSphere

Solver = exu.DynamicSolverType
GRAVITY, STIFFNESS, DAMPING, HEIGHT, RADIUS = 9.81, 1e5, 50.0, 0.5, 0.1
AFTER_TWO_SECONDS = 0.0074473638  # a ball on a floor without tension: pieces of exact motion, twelve digits


def solve(
    mbs: Any,
    end: float,
    steps: int,
    solver: Any = Solver.GeneralizedAlpha,
    located: bool = True,
    damped: bool = True,
    **options: Any,
) -> Any:
    settings = dynamic_settings(end, steps)
    settings.events.ofItems = located
    settings.timeIntegration.generalizedAlpha.spectralRadius = 0.8 if damped else 1.0
    settings.timeIntegration.verboseMode = 0
    for name, value in options.items():
        setattr(settings.timeIntegration, name, value)
    mbs.SolveDynamic(settings, solverType=solver)
    return mbs.sys["dynamicSolver"].it


# ---- a ball that falls: contacts with the same law of force ----------------------------------------------------------------

SURFACE = {"contactStiffness": STIFFNESS, "contactDamping": DAMPING}
LAW = SURFACE | {"limitDamping": True}


def falling() -> tuple[Any, Any]:
    mbs = exu.SystemContainer().AddSystem()
    inertia = InertiaSphere(1, RADIUS)
    return mbs, mbs.CreateRigidBody(referencePosition=[0, 0, HEIGHT], inertia=inertia, gravity=[0, 0, -GRAVITY])


def on_sphere() -> tuple[Any, Any]:
    mbs, ball = falling()
    mbs.CreateSphereSphereContact(
        name="floor",
        bodyNumbers=[ball, mbs.CreateGround(referencePosition=[0, 0, -2 * RADIUS])],
        spheresRadii=[RADIUS, RADIUS],
        dataInitialCoordinates=[1, 0, 0, 0],
        **LAW,
    )
    return mbs, ball


def with_markers(ground: list[float], data: int = 3) -> tuple[Any, Any, dict[str, Any]]:
    mbs, ball = falling()
    on = [
        mbs.AddMarker(eii.MarkerBodyRigid(bodyNumber=b))
        for b in (mbs.AddObject(eii.ObjectGround(referencePosition=ground)), ball)
    ]
    node = mbs.AddNode(eii.NodeGenericData(initialCoordinates=[1] + [0] * (data - 1), numberOfDataCoordinates=data))
    return mbs, ball, {"markerNumbers": on, "nodeNumber": node}


def on_triangle() -> tuple[Any, Any]:
    mbs, ball, on = with_markers(ground=[0, 0, -RADIUS], data=4)
    on["markerNumbers"].reverse()
    mbs.AddObject(
        eii.ObjectContactSphereTriangle(
            **on, radiusSphere=RADIUS, trianglePoints=[[-1, -1, 0], [2, -1, 0], [-1, 2, 0]], **LAW
        )
    )
    return mbs, ball


def on_plane() -> tuple[Any, Any]:
    """A roll, whose lowest point is under its centre."""
    mbs, ball, on = with_markers(ground=[0, 0, -RADIUS])
    mbs.AddObject(
        eii.ObjectContactConvexRoll(**on, rollLength=1, coefficientsHull=[-0.1, 0, RADIUS], dynamicFriction=0, **LAW)
    )
    return mbs, ball


def in_torus() -> tuple[Any, Any]:
    """The floor is the lowest place of the tube."""
    mbs, ball, on = with_markers(ground=[0, 0, 3.6], data=4)
    on["markerNumbers"].reverse()
    mbs.AddObject(
        eii.ObjectContactSphereTorus(
            **on,
            radiusSphere=RADIUS,
            torusMajorRadius=3,
            torusMinorRadius=0.6 + RADIUS,
            torusAxis=[0, 1, 0],
            **LAW,
        )
    )
    return mbs, ball


def on_curve() -> tuple[Any, Any]:
    mbs, ball, on = with_markers(ground=[0, 0, -RADIUS])
    turned = exu.utilities.RotationMatrixX(np.pi / 2)
    mbs.AddObject(
        eii.ObjectContactCurveCircles(
            **on,
            circlesRadii=[RADIUS],
            segmentsData=exu.MatrixContainer(np.array([[0.5, 0, -0.5, 0]])),
            rotationMarker0=turned,
            **SURFACE,
        )
    )
    return mbs, ball


def in_general_contact(on_mesh: bool = False) -> tuple[Any, Any]:
    mbs, ball = falling()
    contact = mbs.AddGeneralContact()
    contact.SetFrictionPairings(np.zeros((1, 1)))
    surface = (2 * STIFFNESS, DAMPING / 2, 0)  # springs in series, dampers side by side
    contact.AddSphereWithMarker(mbs.AddMarker(eii.MarkerBodyRigid(bodyNumber=ball)), RADIUS, *surface)
    ground = mbs.CreateGround(referencePosition=[0, 0, -RADIUS if on_mesh else -2 * RADIUS])
    marker = mbs.AddMarker(eii.MarkerBodyRigid(bodyNumber=ground))
    if on_mesh:
        floor = [[-1, -1, 0], [2, -1, 0], [-1, 2, 0]]
        contact.AddTrianglesRigidBodyBased(marker, *surface, floor, [[0, 1, 2]])
    else:
        contact.AddSphereWithMarker(marker, RADIUS, *surface)
    return mbs, ball


def on_mesh() -> tuple[Any, Any]:
    return in_general_contact(on_mesh=True)


def convex_on(shape: str, floor: str) -> Callable[[], Any]:
    """A shape that is as high as the ball, and touches the floor in several places at once."""

    def build() -> tuple[Any, Any]:
        mbs, body = falling()
        contact = mbs.AddGeneralContact()
        contact.SetFrictionPairings(np.zeros((1, 1)))
        surface = (2 * STIFFNESS, DAMPING / 2, 0)
        marker = mbs.AddMarker(eii.MarkerBodyRigid(bodyNumber=body))
        if shape == "box":
            contact.AddBoxWithMarker(marker, [0.3, 0.4, 2 * RADIUS], *surface)
        elif shape == "capsule":
            contact.AddCapsuleWithMarker(marker, RADIUS, [0.3, 0.1, 0], *surface)
        else:
            contact.AddCylinderWithMarker(marker, RADIUS, [0.3, 0.1, 0], *surface)
        below = mbs.CreateGround(referencePosition=[0.01, 0.02, -RADIUS])
        ground = mbs.AddMarker(eii.MarkerBodyRigid(bodyNumber=below))
        if floor == "plane":
            contact.AddPlane(ground, [0, 0, 1], *surface)
        elif floor == "mesh":
            contact.AddHeightField(ground, np.zeros((5, 5)), [0.5, 0.5], *surface, origin=[-1, -1, 0])
        else:
            contact.AddBoxWithMarker(ground, [2, 2, 1], *surface, centerPoint=[0, 0, -0.5])
        return mbs, body

    build.__name__ = f"{shape}_on_{floor}"
    return build


CONVEX = tuple(
    convex_on(shape, floor) for shape in ("box", "capsule", "cylinder") for floor in ("plane", "mesh", "box")
)
MODELS = (on_sphere, on_triangle, on_plane, in_torus, on_curve, in_general_contact, on_mesh, *CONVEX)


def height(mbs: Any, ball: Any) -> float:
    return float(mbs.GetObjectOutputBody(ball, exu.OutputVariableType.Position, [0, 0, 0])[2])


@pytest.mark.parametrize("build", MODELS)
def test_second_order_although_forces_jump(build: Callable[[], Any]) -> None:
    """The same as acceptance number P8, whose bounds these are, with events of items."""
    steps = [4000, 8000, 16000]
    errors = []
    for n in steps:
        mbs, ball = build()
        mbs.Assemble()
        it = solve(mbs, 2, n)
        errors.append(abs(height(mbs, ball) - AFTER_TWO_SECONDS))
    for coarse, fine in zip(errors[:-1], errors[1:], strict=True):
        assert np.log2(coarse / fine) == pytest.approx(2, abs=0.2)
    assert errors[-1] < 3e-4
    assert it.eventsCount > 4
    assert it.currentStepIndex - 1 + it.eventSolutions - it.eventsCount <= 1.01 * steps[-1]


@pytest.mark.parametrize("build", [on_sphere, in_general_contact, CONVEX[0], CONVEX[5], CONVEX[7]])
@pytest.mark.parametrize(
    ("solver", "tolerance", "bound"),
    [
        (Solver.DOPRI5, 1e-10, 1e-7),
        (Solver.DOP853, 1e-11, 1e-8),
        (Solver.ESDIRK43, 1e-10, 1e-7),
        (Solver.ODE23, 1e-9, 1e-5),
    ],
    ids=str,
)
def test_steps_with_error_control_find_events(
    build: Callable[[], Any], solver: Any, tolerance: float, bound: float
) -> None:
    mbs, ball = build()
    mbs.Assemble()
    it = solve(mbs, 2, 20, solver, automaticStepSize=True, absoluteTolerance=tolerance, relativeTolerance=tolerance)
    assert height(mbs, ball) == pytest.approx(AFTER_TWO_SECONDS, abs=bound)
    assert it.eventsCount > 4


def test_it_is_a_choice() -> None:
    """Items without events switch at the ends of steps, which reduces the order; and solvers do not look for events."""
    errors = []
    for n in (16000, 32000):
        mbs, ball = on_sphere()
        mbs.Assemble()
        it = solve(mbs, 2, n, located=False)
        errors.append(abs(height(mbs, ball) - AFTER_TWO_SECONDS))
    assert it.eventsCount == 0
    assert errors[1] > errors[0] / 2


# ---- friction and stops ----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("speed", [2.0, -2.0])
@pytest.mark.parametrize("steps", [17, 170])
def test_friction_stops_a_mass(speed: float, steps: int) -> None:
    """It slides v^2 m / (2 F): times are exact for all steps; stiction holds springs by up to F / k, subject to
    numerical damping."""
    friction, stiffness = 5.0, 1e3
    model = mass(position=0.0, speed=speed)
    friction_or_stop(
        model,
        np.sign(speed),
        stiffness=0.0,
        fDynamicFriction=friction,
        stickingStiffness=stiffness,
        stickingDamping=200.0,
    )
    model.mbs.Assemble()
    it = solve(model.mbs, 5, steps)
    assert it.eventsCount == 1
    slid = speed**2 * MASS / (2 * friction)
    left = friction / stiffness * 0.8 ** (0.8 * steps) + 1e-9
    assert model.position == pytest.approx(np.sign(speed) * (slid - friction / stiffness), abs=left)


def stick_and_slip(t: float, y: np.ndarray) -> list[float]:
    return [y[1], (3 * np.sin(2 * t) - 2.0 - 0.5 * y[1]) / MASS]


def test_slip_begins_and_ends() -> None:
    """A mass on a bristle that a growing load tears off: order 2 against pieces of smooth motion."""
    bound, stiffness, damping, viscous = 2.0, 400.0, 20.0, 0.5

    def stick(t: float, y: np.ndarray) -> list[float]:
        return [y[1], (3 * np.sin(2 * t) - stiffness * y[0] - damping * y[1]) / MASS]

    def torn(t: float, y: np.ndarray) -> float:
        return float(stiffness * y[0] + damping * y[1] - bound)

    def stands(t: float, y: np.ndarray) -> float:
        return float(y[1])

    torn.terminal, stands.terminal = True, True  # type: ignore[attr-defined]
    precise = {"method": "DOP853", "rtol": 1e-12, "atol": 1e-13}
    first = solve_ivp(stick, [0, 1.5], [0, 0], events=torn, **precise)
    second = solve_ivp(stick_and_slip, [first.t[-1], 2], first.y[:, -1], events=stands, **precise)
    assert first.status == second.status == 1
    place = second.y[0, -1] - bound / stiffness

    def stick_again(t: float, y: np.ndarray) -> list[float]:
        return [y[1], (3 * np.sin(2 * t) - stiffness * (y[0] - place) - damping * y[1]) / MASS]

    end = second.t[-1] + 0.1
    third = solve_ivp(stick_again, [second.t[-1], end], second.y[:, -1], **precise)
    errors = []
    for steps in (200, 400, 800):
        model = mass(position=0.0, speed=0.0)
        friction_or_stop(
            model,
            stiffness=0.0,
            fDynamicFriction=bound,
            fViscousFriction=viscous,
            stickingStiffness=stiffness,
            stickingDamping=damping,
        )
        model.mbs.AddLoad(
            eii.LoadCoordinate(
                markerNumber=model.marker, load=3, loadUserFunction=lambda mbs, t, load: load * float(np.sin(2 * t))
            )
        )
        model.mbs.Assemble()
        it = solve(model.mbs, end, steps)
        assert it.eventsCount == 2
        errors.append(abs(model.position - third.y[0, -1]))
    assert errors[-1] < 1e-4
    for coarse, fine in zip(errors[:-1], errors[1:], strict=True):
        assert np.log2(coarse / fine) == pytest.approx(2, abs=0.3)


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_a_stop_throws_back(side: float) -> None:
    """Half a period at the stop without losses, then back with the same speed: two events, order 2."""
    errors = []
    for steps in (400, 800, 1600):
        model = mass(position=0.2 * side, speed=-side)
        friction_or_stop(
            model,
            useLimitStops=True,
            limitStopsLower=0.0 if side > 0 else -10.0,
            limitStopsUpper=10.0 if side > 0 else 0.0,
            limitStopsStiffness=1e4,
        )
        model.mbs.Assemble()
        it = solve(model.mbs, 0.4, steps)
        assert it.eventsCount == 2
        contact = np.pi * np.sqrt(MASS / 1e4)
        errors.append(abs(side * model.position - (0.4 - 0.2 - contact)))
    for coarse, fine in zip(errors[:-1], errors[1:], strict=True):
        assert np.log2(coarse / fine) == pytest.approx(2, abs=0.3)


def test_coordinates_that_touch() -> None:
    """ObjectContactCoordinate pulls as well: a damped oscillation about m g / k while the gap is closed."""
    model = mass(position=0.1, speed=0, physics_mass=1)
    model.load(-GRAVITY)
    stiffness, damping = 1e3, 5.0
    node = model.mbs.AddNode(eii.NodeGenericData(initialCoordinates=[1], numberOfDataCoordinates=1))
    model.mbs.AddObject(
        eii.ObjectContactCoordinate(
            markerNumbers=[model.ground, model.marker],
            nodeNumber=node,
            contactStiffness=stiffness,
            contactDamping=damping,
        )
    )
    model.mbs.Assemble()
    events = [lambda t, y: y[0]]
    events[0].terminal = True  # type: ignore[attr-defined]
    t, y, touches = 0.0, np.array([0.1, 0.0]), False
    while t < 1:

        def motion(t: float, y: np.ndarray, touches: bool = touches) -> list[float]:
            return [y[1], -GRAVITY - touches * (stiffness * y[0] + damping * y[1])]

        piece = solve_ivp(motion, [t, 1], y, method="DOP853", rtol=1e-12, atol=1e-14, events=events)
        t, y, touches = piece.t[-1], piece.y[:, -1], not touches
        if piece.status == 1:
            y[0] = 1e-15 * np.sign(y[1])
    errors = []
    for steps in (500, 1000, 2000):
        model.mbs.Assemble()
        solve(model.mbs, 1, steps)
        errors.append(abs(model.position - y[0]))
    for coarse, fine in zip(errors[:-1], errors[1:], strict=True):
        assert np.log2(coarse / fine) == pytest.approx(2, abs=0.3)


# ---- rolling and sliding ---------------------------------------------------------------------------------------------------


DISC_RADIUS, DISC_MASS, DISC_INERTIA = 0.2, 2.0, 0.04


def disc(height: float, speed: list[float], spin: float, guided: bool = False, **contact: Any) -> tuple[Any, Any]:
    """It stands upright on a plane and rolls along y."""
    mbs = exu.SystemContainer().AddSystem()
    inertia = exu.utilities.RigidBodyInertia(mass=DISC_MASS, inertiaTensor=np.diag([DISC_INERTIA, 0.03, 0.03]))
    body = mbs.CreateRigidBody(
        referencePosition=[0, 0, height],
        initialVelocity=speed,
        initialAngularVelocity=[spin, 0, 0],
        inertia=inertia,
        gravity=[0, 0, -GRAVITY],
    )
    ground = mbs.CreateGround()
    on = [mbs.AddMarker(eii.MarkerBodyRigid(bodyNumber=b)) for b in (ground, body)]
    data = mbs.AddNode(eii.NodeGenericData(initialCoordinates=[0, 0, 1], numberOfDataCoordinates=3))
    mbs.AddObject(
        eii.ObjectConnectorRollingDiscPenalty(markerNumbers=on, nodeNumber=data, discRadius=DISC_RADIUS, **contact)
    )
    if guided:
        mbs.CreateGenericJoint(bodyNumbers=[ground, body], position=[0, 0, height], constrainedAxes=[0, 0, 0, 0, 1, 1])
    mbs.Assemble()
    return mbs, body


def test_a_disc_falls_slides_and_rolls() -> None:
    """It bounces once; friction turns it until it hardly slips: pieces of smooth motion in the plane y, z."""
    stiffness, damping, friction, zone, end = 1e4, 60.0, 0.4, 0.3, 0.35

    def motion(t: float, x: np.ndarray) -> list[float]:
        gap, slip = x[1] - DISC_RADIUS, x[3] + DISC_RADIUS * x[5]
        normal_force = -(stiffness * gap + damping * x[4]) if gap < 0 else 0.0
        force = -friction * abs(normal_force) * float(np.clip(slip / zone, -1, 1))
        return [*x[3:], force / DISC_MASS, normal_force / DISC_MASS - GRAVITY, DISC_RADIUS * force / DISC_INERTIA]

    start = np.array([0, DISC_RADIUS + 0.01, 0, 1.0, 0, 5.0])
    exact = solve_ivp(motion, [0, end], start, method="LSODA", rtol=1e-10, atol=1e-12, max_step=1e-4).y[:, -1]
    errors = []
    for steps in (1000, 2000, 4000):
        mbs, body = disc(
            start[1], [0, 1, 0], 5, contactStiffness=stiffness, contactDamping=damping, dryFriction=[friction] * 2,
            dryFrictionProportionalZone=zone, useLinearProportionalZone=True,
        )  # fmt: skip
        it = solve(mbs, end, steps)
        assert it.eventsCount > 3
        place = mbs.GetObjectOutputBody(body, exu.OutputVariableType.Position, [0, 0, 0])
        errors.append(np.abs(place[1:] - exact[:2]).max())
    assert errors[-1] < 1e-4
    for coarse, fine in zip(errors[:-1], errors[1:], strict=True):
        assert np.log2(coarse / fine) == pytest.approx(2, abs=0.3)


def test_the_direction_of_slip_turns() -> None:
    """A disc slides along its axis and rolls up at the same time: friction follows the direction, which has no
    event."""
    stiffness, friction, end = 1e4, 0.3, 0.3

    def motion(t: float, x: np.ndarray) -> np.ndarray:
        slip = np.array([x[2], x[3] + DISC_RADIUS * x[4]])
        force = -friction * DISC_MASS * GRAVITY * slip / np.linalg.norm(slip)
        return np.array([x[2], x[3], *(force / DISC_MASS), DISC_RADIUS * force[1] / DISC_INERTIA])

    exact = solve_ivp(motion, [0, end], [0, 0, 2.0, 3.0, 0], rtol=1e-11, atol=1e-12).y[:2, -1]
    errors = []
    for steps in (60, 120, 240):
        mbs, body = disc(
            DISC_RADIUS - DISC_MASS * GRAVITY / stiffness, [2, 3, 0], 0, guided=True, contactStiffness=stiffness,
            dryFriction=[friction] * 2, dryFrictionProportionalZone=1e-3,
        )  # fmt: skip
        settings = dynamic_settings(end, steps)
        settings.events.ofItems = True
        settings.timeIntegration.verboseMode = 0
        settings.timeIntegration.discontinuous.iterationTolerance = 1e-6
        mbs.SolveDynamic(settings)
        place = mbs.GetObjectOutputBody(body, exu.OutputVariableType.Position, [0, 0, 0])
        errors.append(np.abs(place[:2] - exact).max())
    for coarse, fine in zip(errors[:-1], errors[1:], strict=True):
        assert np.log2(coarse / fine) == pytest.approx(2, abs=0.3)


def test_a_circle_sticks_and_slides_on_a_cable() -> None:
    """The mass on a bristle above, without viscous friction: the weight presses the circle on a cable that does not
    move."""
    bound, stiffness, damping, contact, radius = 2.0, 400.0, 20.0, 1e4, 0.2

    def pulled(force: Callable[[np.ndarray], float]) -> Callable[[float, np.ndarray], list[float]]:
        return lambda t, y: [y[1], (3 * np.sin(2 * t) - force(y)) / MASS]

    def torn(t: float, y: np.ndarray) -> float:
        return float(stiffness * y[0] + damping * y[1] - bound)

    def stands(t: float, y: np.ndarray) -> float:
        return float(y[1])

    torn.terminal, stands.terminal = True, True  # type: ignore[attr-defined]
    precise = {"method": "DOP853", "rtol": 1e-12, "atol": 1e-13}
    first = solve_ivp(pulled(lambda y: torn(0, y) + bound), [0, 1.5], [0, 0], events=torn, **precise)
    second = solve_ivp(pulled(lambda y: bound), [first.t[-1], 2], first.y[:, -1], events=stands, **precise)
    assert first.status == second.status == 1
    place = second.y[0, -1] - bound / stiffness
    end = second.t[-1] + 0.1
    again = pulled(lambda y: stiffness * (y[0] - place) + damping * y[1])
    exact = solve_ivp(again, [second.t[-1], end], second.y[:, -1], **precise).y[0, -1]
    errors = []
    for steps in (200, 400, 800):
        mbs = exu.SystemContainer().AddSystem()
        ground = mbs.AddMarker(eii.MarkerNodeCoordinate(nodeNumber=mbs.AddNode(eii.NodePointGround()), coordinate=0))
        nodes = [mbs.AddNode(eii.NodePoint2DSlope1(referenceCoordinates=[x, 0, 1, 0])) for x in (-2, 2)]
        circle = mbs.AddNode(eii.NodeRigidBody2D(referenceCoordinates=[0, radius - MASS * GRAVITY / contact, 0]))
        held = [(node, k) for node in nodes for k in range(4)] + [(circle, 2)]
        for node, k in held:
            marker = mbs.AddMarker(eii.MarkerNodeCoordinate(nodeNumber=node, coordinate=k))
            mbs.AddObject(eii.ObjectConnectorCoordinate(markerNumbers=[ground, marker]))
        cable = mbs.AddObject(
            eii.ObjectANCFCable2D(
                physicsLength=4, physicsMassPerLength=1, physicsBendingStiffness=1, physicsAxialStiffness=1, nodeNumbers=nodes
            )
        )  # fmt: skip
        body = mbs.AddObject(eii.ObjectRigidBody2D(physicsMass=MASS, physicsInertia=1, nodeNumber=circle))
        centre = mbs.AddMarker(eii.MarkerBodyRigid(bodyNumber=body))
        mbs.AddLoad(
            eii.LoadForceVector(
                markerNumber=centre, loadVector=[3, -MASS * GRAVITY, 0],
                loadVectorUserFunction=lambda mbs, t, load: [load[0] * float(np.sin(2 * t)), load[1], 0],
            )
        )  # fmt: skip
        mbs.AddObject(
            eii.ObjectContactFrictionCircleCable2D(
                markerNumbers=[centre, mbs.AddMarker(eii.MarkerBodyCable2DShape(bodyNumber=cable, numberOfSegments=1))],
                nodeNumber=mbs.AddNode(eii.NodeGenericData(initialCoordinates=[-1e-3, -2, 0], numberOfDataCoordinates=3)),
                numberOfContactSegments=1, circleRadius=radius, contactStiffness=contact, frictionStiffness=stiffness,
                frictionVelocityPenalty=damping, frictionCoefficient=bound / (MASS * GRAVITY),
            )
        )  # fmt: skip
        mbs.Assemble()
        it = solve(mbs, end, steps)
        assert it.eventsCount == 2
        errors.append(abs(float(mbs.GetNodeOutput(circle, exu.OutputVariableType.Coordinates)[0]) - exact))
    assert errors[-1] < 1e-4
    for coarse, fine in zip(errors[:-1], errors[1:], strict=True):
        assert np.log2(coarse / fine) == pytest.approx(2, abs=0.3)


def test_a_disc_bounces_on_a_cable_in_general_contact() -> None:
    """The cable is straight and does not move; the normal force acts along the chord of the disc, by the rule of Simpson."""
    radius, half, stiffness, end, height = 0.2, 0.01, 1e5, 0.5, 0.2 + 0.01 + 0.1
    reach = radius + half

    def motion(t: float, y: np.ndarray) -> list[float]:
        depth, chord = reach - y[0], 2 * np.sqrt(max(reach**2 - y[0] ** 2, 0))
        return [y[1], -GRAVITY + stiffness * max(depth, 0.0) * 4 / 6 * chord]

    exact = solve_ivp(motion, [0, end], [height, 0], method="LSODA", rtol=1e-11, atol=1e-13, max_step=1e-4).y[0, -1]
    errors = []
    for steps in (1000, 2000, 4000):
        mbs = exu.SystemContainer().AddSystem()
        contact = mbs.AddGeneralContact()
        contact.SetFrictionPairings(np.zeros((1, 1)))
        disc = mbs.CreateMassPoint(referencePosition=[0, height, 0], physicsMass=1, gravity=[0, -GRAVITY, 0])
        marker = mbs.AddMarker(eii.MarkerBodyPosition(bodyNumber=disc))
        contact.AddSphereWithMarker(marker, radius, 2 * stiffness, 0, 0)
        nodes = [mbs.AddNode(eii.NodePoint2DSlope1(referenceCoordinates=[x, 0, 1, 0])) for x in (-0.5, 0.5)]
        ground = mbs.AddMarker(eii.MarkerNodeCoordinate(nodeNumber=mbs.AddNode(eii.NodePointGround()), coordinate=0))
        for node in nodes:
            for k in range(4):
                held = mbs.AddMarker(eii.MarkerNodeCoordinate(nodeNumber=node, coordinate=k))
                mbs.AddObject(eii.ObjectConnectorCoordinate(markerNumbers=[ground, held]))
        cable = mbs.AddObject(
            eii.ObjectANCFCable2D(
                nodeNumbers=nodes, physicsLength=1, physicsMassPerLength=1, physicsBendingStiffness=1, physicsAxialStiffness=1
            )
        )  # fmt: skip
        contact.AddANCFCable(cable, half, 2 * stiffness, 0, 0)
        mbs.Assemble()
        it = solve(mbs, end, steps)
        assert it.eventsCount > 1
        place = mbs.GetObjectOutputBody(disc, exu.OutputVariableType.Position, [0, 0, 0])
        errors.append(abs(place[1] - exact))
    for coarse, fine in zip(errors[:-1], errors[1:], strict=True):
        assert np.log2(coarse / fine) == pytest.approx(2, abs=0.3)
