"""Each output is compared with a second formula: rates with differences along the motion, local vectors with global
ones,
forces and torques with the power that they bring into the system."""

from __future__ import annotations

from collections.abc import Callable, Collection
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import dalembert as exu
from codegen.model import Item
from dalembert._core import testing
from dalembert.testing.exemptions import NO_FORCES, NOT_OF_RATES, NOT_OF_VALUES, RATE_OF_OUTPUTS
from dalembert.testing.momentum import effect, in_touch
from dalembert.testing.motions import KINDS
from dalembert.testing.scenes import ITEMS, Scene, is_ground, moves_as_point, on_one_frame, output_of
from dalembert.testing.variants import ALL_VARIANTS, Variant
from dalembert.testing.virtual_work import free_equations

Values = dict[str, np.ndarray]
Configuration = exu.ConfigurationType
# Central differences of step h: errors of h^2 / 6 of third derivatives, of the order 10 to 100 here, and rounding of eps / h.
STEP = 1e-5
TOLERANCE = 1e-7

RATES = {
    "Position": "Velocity",
    "Displacement": "Velocity",
    "DisplacementLocal": "VelocityLocal",
    "Velocity": "Acceleration",
    "AngularVelocity": "AngularAcceleration",
    "CoordinatesTotal": "Coordinates_t",
    "Coordinates": "Coordinates_t",
    "Coordinates_t": "Coordinates_tt",
}
LOCAL = ("Velocity", "Acceleration", "AngularVelocity", "AngularAcceleration")


def read_all(scene: Scene, kind: str, number: Any, item: Item, configuration: Any = Configuration.Current) -> Values:
    """Outputs of one item; outputs of bodies at a local point."""
    place: tuple[Any, ...] = ()
    if kind == "Object" and item.object_type in ("Body", "FiniteElement"):
        point = moves_as_point(item)
        place = (np.array([0.3, -0.2, 0.0 if scene.planar else 0.1]) * (not point),)
    read = getattr(scene.mbs, f"Get{kind}Output" + ("Body" if place else ""))
    found = {}
    for output in item.outputs:
        value = output_of(read, number, getattr(exu.OutputVariableType, output.name), *place, configuration)
        if value is not None:
            found[output.name] = np.atleast_1d(value)
    return found


def items_of(scene: Scene) -> list[tuple[str, int, Item]]:
    """All nodes and objects of the model."""
    data = scene.mbs.GetDictionary()
    types = {(item.kind, item.type_name): item for item in ITEMS.values()}
    return [
        (kind.capitalize(), number, types[kind, entry[f"{kind}Type"]])
        for kind in ("node", "object")
        for number, entry in enumerate(data[f"{kind}List"])
    ]


def show(scene: Scene, s: testing.State) -> None:
    """Make a state the current one."""
    data = scene.mbs.systemData
    data.SetODE2Coordinates(s.q, Configuration.Current)
    data.SetODE2Coordinates_t(s.v, Configuration.Current)
    data.SetODE2Coordinates_tt(s.a, Configuration.Current)
    data.SetODE1Coordinates(s.y, Configuration.Current)
    data.SetODE1Coordinates_t(s.y_t, Configuration.Current)
    data.SetAECoordinates(s.lam, Configuration.Current)
    data.SetDataCoordinates(s.data, Configuration.Current)
    data.SetTime(s.t, Configuration.Current)


def along(scene: Scene, s: testing.State, h: float, time: bool) -> testing.State:
    """A moment later, with constant accelerations."""
    other = s.copy()
    other.q = testing.compose(scene.mbs, s, h * s.v + h * h / 2 * s.a)
    other.v = s.v + h * s.a
    other.y = s.y + h * s.y_t
    other.t = s.t + h * time
    return other


def rates(scene: Scene, s: testing.State, read: Callable[[], Values], time: bool = True) -> Values:
    sides = []
    for h in (STEP, -STEP):
        show(scene, along(scene, s, h, time))
        sides.append(read())
    show(scene, s)
    return {name: (sides[0][name] - sides[1][name]) / (2 * STEP) for name in sides[0]}


def close(told: np.ndarray, wanted: np.ndarray, what: str, tolerance: float = TOLERANCE) -> None:
    scale = max(1.0, np.abs(wanted).max(initial=0))
    np.testing.assert_allclose(told, wanted, rtol=0, atol=tolerance * scale, err_msg=what)


def skew_part(matrix: np.ndarray) -> np.ndarray:
    return np.array([matrix[2, 1] - matrix[1, 2], matrix[0, 2] - matrix[2, 0], matrix[1, 0] - matrix[0, 1]]) / 2


def check_rates_of_outputs(variant: Variant, exempt: Collection[tuple[str, str]]) -> None:
    """Outputs of all nodes and objects of each model."""
    scene = variant.build(seed=71)
    s = scene.state()
    rng, odd_values = np.random.default_rng(72), variant.uses & set(NOT_OF_VALUES)
    s.lam, s.y_t = rng.normal(size=len(s.lam)), testing.rates(scene.mbs, s)
    show(scene, s)
    for kind, number, item in items_of(scene):
        told = read_all(scene, kind, number, item)
        slopes = rates(scene, s, lambda k=kind, n=number, i=item: read_all(scene, k, n, i))  # type: ignore[misc]
        for value, rate in RATES.items():
            left_out = (item.name, value) in exempt or (item.name == variant.item and odd_values)
            if value in told and rate in told and not left_out:
                close(told[rate], slopes[value], f"{item.name}: {rate} as the rate of {value}")
        if item.object_type not in ("Connector", "Constraint", "Joint") and "RotationMatrix" in told:
            rotation = told["RotationMatrix"].reshape(3, 3)
            turning = slopes["RotationMatrix"].reshape(3, 3) @ rotation.T
            close(told["AngularVelocity"], skew_part(turning), f"{item.name}: AngularVelocity")
            for name in LOCAL:
                if name in told and f"{name}Local" in told:
                    close(told[f"{name}Local"], rotation.T @ told[name], f"{item.name}: {name}Local", 1e-12)
            if "Rotation" in told and len(told["Rotation"]) == 3:
                close(
                    Rotation.from_euler("XYZ", told["Rotation"]).as_matrix(), rotation, f"{item.name}: Rotation", 1e-12
                )
        if item.object_type in (None, "", "Body", "FiniteElement") and {"Position", "Displacement"} <= set(told):
            reference = read_all(scene, kind, number, item, Configuration.Reference)
            close(told["Displacement"], told["Position"] - reference["Position"], f"{item.name}: Displacement", 1e-12)


@pytest.mark.parametrize("variant", ALL_VARIANTS, ids=lambda variant: variant.id)
def test_rates_and_frames_of_outputs(variant: Variant) -> None:
    check_rates_of_outputs(variant, exempt=RATE_OF_OUTPUTS)


# Items whose output velocity gives the power that they remove from the system, and items that act at a point between
# two bodies, with the force on the second one as output.
CONJUGATE = {item.name: item.scene.power for item in ITEMS.values() if item.scene.power}
ON_SECOND_BODY = {item.name: item.scene.second_body for item in ITEMS.values() if item.scene.second_body}


def follows(variant: Variant) -> bool:
    """Whether forces on the markers of a variant are those of virtual work, and values of markers have rates."""
    level = "Coordinate" in ITEMS[variant.item].requested_markers
    return not (
        variant.uses & {*NOT_OF_RATES, *NOT_OF_VALUES}
        or variant.uses & set(NO_FORCES)
        and ITEMS[variant.item].requested_markers != ("Coordinate",)
        or level
        and dict(variant.options).get("velocityLevel")
        or dict(variant.options).get("intrinsicFormulation")
    )


def is_joint(variant: Variant) -> bool:
    return ITEMS[variant.item].object_type == "Joint"


def of_bodies(variant: Variant) -> bool:
    """Both markers on rigid bodies, so that a joint can be closed."""
    return all(
        is_ground(carrier) or on_one_frame(carrier) and KINDS[carrier[1]].frame != "point"
        for _, carrier in variant.pairs
    )


WITH_POWER = [v for v in ALL_VARIANTS if v.item in CONJUGATE and follows(v) and (of_bodies(v) or not is_joint(v))]


def power_of_outputs(scene: Scene, item: Item, s: testing.State) -> float:
    def read() -> Values:
        return read_all(scene, "Object", scene.target[1], item)

    show(scene, s)
    told, slopes = read(), rates(scene, s, read, time=False)
    return sum(
        float(told[force] @ (slopes[rate.removeprefix("rate of ")] if rate.startswith("rate of ") else told[rate]))
        for force, rate in CONJUGATE[item.name]
    )


@pytest.mark.parametrize("variant", WITH_POWER, ids=lambda variant: variant.id)
def test_power_of_forces_and_torques(variant: Variant) -> None:
    """Power of joints, from their forces: their torques are multipliers of equations, not components of a vector."""
    scene = variant.build(seed=73, closed=is_joint(variant))
    s = in_touch(scene, scene.state())
    own = np.zeros(len(s.lam), dtype=bool)
    rows = scene.mbs.systemData.GetObjectLTGAE(scene.target[1])
    own[rows[: ITEMS[variant.item].scene.force_equations if is_joint(variant) else None]] = True
    s.lam = np.where(own & ~free_equations(scene, s), np.random.default_rng(74).normal(size=len(s.lam)), 0)
    power = power_of_outputs(scene, ITEMS[variant.item], s)
    taken = float(effect(scene, s) @ s.v)
    assert power == pytest.approx(taken, rel=0, abs=TOLERANCE * max(1.0, abs(taken)))


@pytest.mark.parametrize(
    "variant",
    [v for v in ALL_VARIANTS if v.item in ON_SECOND_BODY and of_bodies(v) and not v.planar],
    ids=lambda variant: variant.id,
)
def test_force_on_the_second_body(variant: Variant) -> None:
    """Contacts act at a point between the bodies: the sum of forces on the second body is the output."""
    scene = variant.build(seed=75)
    if "rollingFrictionViscous" in scene.mbs.GetObject(scene.target[1]):  # acts at the center of the disc
        scene.mbs.SetObjectParameter(scene.target[1], "rollingFrictionViscous", 0)
    s = in_touch(scene, scene.state())
    s.lam = np.random.default_rng(76).normal(size=len(s.lam))
    name = ON_SECOND_BODY[variant.item].removeprefix("-")

    def force_told() -> np.ndarray:
        show(scene, s)
        told = read_all(scene, "Object", scene.target[1], ITEMS[variant.item])
        return told["RotationMatrix"].reshape(3, 3) @ told[name] if name.endswith("Local") else told[name]

    force = force_told()
    if not force.any():  # bodies separate so fast that there is no normal force: the other way round there is
        s.v = -np.asarray(s.v)
        force = force_told()
    assert np.linalg.norm(force) > 0.01
    sign = (-1 if ON_SECOND_BODY[variant.item].startswith("-") else 1) * (-1 if is_ground(variant.pairs[1][1]) else 1)
    close(-scene.wrenches(effect(scene, s))[-1, :3], sign * force, variant.item, 1e-12)
