"""Belts around pulleys: frequencies and tensions by formulas, energy, and ratios of speeds."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import dalembert as db

RADII, DISTANCE, STIFFNESS = np.array([0.05, 0.1]), 0.4, 5e4


def drive(sizes: Any = RADII, points: Any = ((0, 0, 0), (DISTANCE, 0, 0)), **belt: Any) -> tuple[db.Model, Any, Any]:
    """Return pulleys of steel on the ground, with a belt; the model, the pulleys, the spans."""
    model = db.Model()
    pulleys = []
    for i, (radius, point) in enumerate(zip(sizes, points, strict=True)):
        pulleys.append(
            model.create_cylinder(
                name=f"p{i}", radius=abs(radius), length=0.02, axis="z", density=7850, reference_position=point
            )
        )
        model.create_revolute_joint(body_numbers=["ground", pulleys[i]], position=point, axis="z")
    given = {"body_numbers": pulleys, "positions": points, "radii": sizes, **belt}  # the ground carries them
    return model, pulleys, model.create_belt(**{"stiffness": STIFFNESS, **given})


def free_length(pull: float) -> float:
    """Length of a span without force between the pulleys of `drive`."""
    return float(np.sqrt(DISTANCE**2 - (RADII[1] - RADII[0]) ** 2) / (1 + pull / STIFFNESS))


def inertia(radius: float) -> float:
    return 7850 * np.pi * radius**4 * 0.02 / 2


def test_pulleys_swing_against_each_other() -> None:
    """Spans of length L give F = EA (L / l - 1), where l changes by x = r0 phi0 - r1 phi1: k = EA L / l^2 each, and
    omega^2 = 2 k (r0^2 / J0 + r1^2 / J1).
    """
    pull = 200.0
    model, pulleys, _ = drive(pretension=pull)
    stiffness = (STIFFNESS + pull) / free_length(pull)
    expected = np.sqrt(2 * stiffness * np.sum(RADII**2 / [inertia(each) for each in RADII]))
    model.assemble()
    frequencies = np.sqrt(np.abs(model.system.ComputeODE2Eigenvalues()[0]))
    # the other mode is the rotation of the whole belt; its eigenvalue is zero up to rounding errors
    assert frequencies[-1] == pytest.approx(expected, rel=1e-7)  # the tangent of the spans: differences of 1e-8
    assert frequencies[0] < 1e-3 * expected


def test_tensions_carry_the_torque() -> None:
    """At rest: T1 - T0 = M / r; belt of length x goes from one span to the other: T = EA (L / (l -+ x) - 1)."""
    pull, torque = 300.0, 8.0
    model, pulleys, spans = drive(pretension=pull)
    model.create_fixed_joint(body_numbers=["ground", pulleys[0]], position=[0, 0, 0])
    model.create_torque(body_number=pulleys[1], load_vector=[0, 0, -torque])
    solution = model.solve_static()
    tension = [float(solution[each].force_local[-1]) for each in spans]
    assert tension[1] - tension[0] == pytest.approx(torque / RADII[1], rel=1e-9)
    lengths = (STIFFNESS + pull) / (STIFFNESS + np.array(tension))
    assert lengths.sum() == pytest.approx(2, rel=1e-12)


def test_the_slack_span_carries_nothing() -> None:
    """Without pretension, one span carries the torque."""
    model, pulleys, spans = drive()
    model.create_fixed_joint(body_numbers=["ground", pulleys[0]], position=[0, 0, 0])
    model.create_torque(body_number=pulleys[1], load_vector=[0, 0, -8])
    solution = model.solve_static(load_steps=10)
    tension = [float(solution[each].force_local[-1]) for each in spans]
    # regularizationForce of the spans: -0.1 N at most
    assert tension[1] == pytest.approx(8 / RADII[1] + tension[0], rel=1e-9)
    assert -0.1001 < tension[0] < 0


def test_joints_of_pulleys_bear_the_pull() -> None:
    """Both spans of length l pull with the same force, inclined to the line of centers: cos = l / d."""
    pull = 200.0
    model, pulleys, _ = drive(pretension=pull)
    solution = model.solve(0.01, 1e-3)
    along = 2 * pull * np.sqrt(1 - ((RADII[1] - RADII[0]) / DISTANCE) ** 2)
    for joint, pulley, force in zip(model.joints, pulleys, (-along, along), strict=True):
        np.testing.assert_allclose(solution[joint].force_on(pulley)[-1], [force, 0, 0], rtol=0, atol=1e-9 * along)


def test_energy_is_kept_on_a_moving_carrier() -> None:
    """A frame swings, with both pulleys on it, and one of them spins: gravity, springs and motion exchange energy."""
    model = db.Model()
    frame = model.create_box(
        size=[0.5, 0.05, 0.01], density=7850, reference_position=[0.2, 0, 0], gravity=[0, -9.81, 0]
    )
    model.create_revolute_joint(body_numbers=["ground", frame], position=[-0.05, 0, 0], axis="z")
    pulleys = []
    for radius, x in zip(RADII, (0, DISTANCE), strict=True):
        pulleys.append(
            model.create_cylinder(
                radius=radius, length=0.02, axis="z", density=7850, reference_position=[x, 0, 0],
                gravity=[0, -9.81, 0], initial_angular_velocity=[0, 0, 10.0] if x else [0, 0, 0],
            )
        )  # fmt: skip
        model.create_revolute_joint(body_numbers=[frame, pulleys[-1]], position=[x, 0, 0], axis="z")
    model.create_belt(
        body_numbers=pulleys, positions=[[0, 0, 0], [DISTANCE, 0, 0]], radii=RADII, carrier_number=frame,
        stiffness=STIFFNESS, pretension=300,
    )  # fmt: skip
    solution = model.solve(end_time=0.5, step_size=5e-4, method="RK67")
    spin = inertia(RADII[1]) * 10**2 / 2
    assert np.ptp(solution.energies.kinetic) > 10 * spin
    # the energy of the spans neglects terms of the order of their strain, which is at most 1 %
    assert np.ptp(solution.energies.total) < 5e-3 * spin


@pytest.mark.parametrize(
    ("radii", "points", "ratios"),
    [
        ((0.05, -0.1), ((0, 0, 0), (0.4, 0, 0)), (1, -0.5)),  # crossed
        ((0.05, 0.1, -0.02), ((0, 0, 0), (0.4, 0, 0), (0.2, -0.05, 0)), (1, 0.5, -2.5)),  # with an idler
    ],
)
def test_ratios_of_speeds(radii: Any, points: Any, ratios: Any) -> None:
    model, pulleys, _ = drive(radii, points, damping=50, pretension=100)
    model.create_motor(body_numbers=["ground", pulleys[0]], position=[0, 0, 0], axis="z", speed=20, ramp=0.1, damping=5)
    solution = model.solve(end_time=0.5, step_size=2e-4)
    speeds = np.array([solution[each].angular_velocity[-1, 2] for each in pulleys])
    assert speeds == pytest.approx(20 * np.array(ratios), rel=1e-4)  # rotations of 4e-3 to 1e-2 in a step


@pytest.mark.parametrize(
    ("given", "text"),
    [
        ({"body_numbers": ["ground"]}, "'body_numbers': expected a list of at least two body numbers"),
        ({"positions": [[0, 0, 0]]}, "'positions': expected a point for each of the 2 bodies"),
        ({"radii": [0.05, 0.0]}, "'radii': expected a radius other than 0 for each of the 2 pulleys"),
        ({"radii": [0.05]}, "'radii': expected a radius other than 0 for each of the 2 pulleys"),
        ({"radii": [0.05, -0.4]}, "'positions': expected points 0 and 1 more than 0.45 m apart"),
        ({"carrier_number": "p0"}, "'body_numbers': expected different pulleys, without the carrier"),
        ({"body_numbers": ["p0", "p0"]}, "'body_numbers': expected different pulleys"),
        ({"axis": "y"}, r"'axis': expected the axis of joint \d+ of pulley 0, \[0. 0. 1.\]"),
        ({"positions": [[0, 0, 0], [0.5, 0, 0]]}, r"'positions\[1\]': expected a point on the axis of joint \d+"),
        ({"pretension": -1.0}, "'pretension': expected a finite number that is not negative"),
        ({"axis": [0, 0, 0]}, "'axis': expected a vector with 3 components that is not zero"),
    ],
)
def test_wrong_belts_are_refused(given: dict[str, Any], text: str) -> None:
    with pytest.raises(ValueError, match=f"create_belt.*{text}"):
        drive(**given)


def test_several_belts_in_one_model() -> None:
    """Belts need no names; names of belts differ, and a refused belt leaves nothing in the model."""
    model, pulleys, spans = drive(pretension=100)
    given = {"body_numbers": pulleys, "positions": [each.position for each in pulleys], "radii": RADII}
    spans += model.create_belt(**given, pretension=300, stiffness=STIFFNESS)
    spans += model.create_belt("belt", **given, pretension=500, stiffness=STIFFNESS)
    sizes = len(model.markers), len(model.nodes), len(model)
    text = "model.create_belt: argument 'name': expected a name that is not in use, received 'belt': .*'Marker0:belt'"
    with pytest.raises(ValueError, match=text):
        model.create_belt("belt", **given)
    assert (len(model.markers), len(model.nodes), len(model)) == sizes
    model.assemble()
    assert [float(each.force_local) for each in spans] == pytest.approx(np.repeat([100, 300, 500], 2), rel=1e-9)


def test_the_order_of_pulleys_follows_the_axis() -> None:
    """Without the check, a belt with this order would cross itself between all pulleys."""
    points = ((0, 0, 0), (0.2, 0.3, 0), (0.4, 0, 0))
    with pytest.raises(ValueError, match="'body_numbers': expected pulleys in the order in which the belt turns"):
        drive((0.05, 0.05, 0.05), points)
    for sizes, order in (((0.05,) * 3, points[::-1]), ((-0.05,) * 3, points)):
        model, _, spans = drive(sizes, order, pretension=100)
        model.assemble()
        # three circles of one radius: the belt is the polygon of centers, and a circle
        assert [span.distance for span in spans] == pytest.approx(
            [np.linalg.norm(np.subtract(order[i], order[(i + 1) % 3])) for i in range(3)], rel=1e-12
        )


def test_pulleys_on_a_turning_frame() -> None:
    """One pulley is held by the ground, in the middle of a frame that turns: the other one keeps its direction."""
    model = db.Model()
    frame = model.create_box("frame", size=[0.5, 0.02, 0.02], density=7850, reference_position=[0.2, 0, 0])
    model.create_revolute_joint(body_numbers=["ground", frame], position=[0, 0, 0], axis="z")
    pulleys = [
        model.create_cylinder(radius=0.05, length=0.02, axis="z", density=7850, reference_position=[x, 0, 0])
        for x in (0, DISTANCE)
    ]
    model.create_fixed_joint(body_numbers=["ground", pulleys[0]], position=[0, 0, 0])
    model.create_revolute_joint(body_numbers=[frame, pulleys[1]], position=[DISTANCE, 0, 0], axis="z")
    model.create_belt(
        body_numbers=pulleys, positions=[[0, 0, 0], [DISTANCE, 0, 0]], radii=[0.05, 0.05], carrier_number=frame,
        stiffness=STIFFNESS, damping=50, pretension=300,
    )  # fmt: skip
    model.create_motor(body_numbers=["ground", frame], position=[0, 0, 0], axis="z", speed=2, ramp=0.2, damping=50)
    solution = model.solve(end_time=1, step_size=5e-4)
    assert solution[frame].angular_velocity[-1, 2] == pytest.approx(2, rel=1e-4)
    assert solution[pulleys[1]].angular_velocity[-1, 2] == pytest.approx(0, abs=1e-3)


def test_sensitivities_of_belts_with_pretension() -> None:
    """Round-off of the pretension is larger than the tolerance that derivatives want: small loads were refused."""
    found = []
    for torque in (0.0, 0.05, 0.5):
        model, pulleys, _ = drive(pretension=100, damping=50)
        model.create_torque("torque", pulleys[1], load_vector=[0, 0, torque])
        model.create_sensor(pulleys[0], "angular_velocity", name="speed")
        output = {"w": db.At("speed", 0.03, component=2)}
        twin = model.differentiable({"M": ("torque", "load_vector", 2)}, output, 0.03, 1e-3)
        found.append(twin.Sensitivities(twin.x0).Derivative("w", "M"))
        differences = [float(twin.Values([torque + step])["w"]) for step in (1e-3, -1e-3)]
        assert found[-1] == pytest.approx((differences[0] - differences[1]) / 2e-3, rel=1e-6)
    assert found == pytest.approx([found[0]] * 3, rel=1e-6)  # nearly linear: the angles are small
