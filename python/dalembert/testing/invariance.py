"""A rotated and shifted model has rotated and shifted motions and outputs."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import dalembert as exu
from dalembert._core import testing
from dalembert.testing.exemptions import GLOBAL_AXES, GLOBAL_FUNCTIONS, GLOBAL_MARKER, GLOBAL_WHEN_PARTIAL
from dalembert.testing.momentum import in_touch
from dalembert.testing.motions import KINDS, Place, random_rotation
from dalembert.testing.scenes import ITEMS, Scene, moves_as_point, output_of
from dalembert.testing.variants import ALL_VARIANTS, Variant

# Single coordinates of nodes with frames are no scalars, those of other nodes and of ground are.
NOT_SCALAR = {name for name, kind in KINDS.items() if not kind.resting}


def knows_axes(variant: Variant) -> bool:
    item = ITEMS[variant.item]
    if "Coordinate" in item.requested_markers:
        return bool(variant.uses & NOT_SCALAR)
    partial = variant.item in GLOBAL_WHEN_PARTIAL and not all(dict(variant.options)["constrainedAxes"])
    functions = variant.item in GLOBAL_FUNCTIONS and variant.functions
    return bool(variant.uses & {*GLOBAL_AXES, *GLOBAL_MARKER}) or partial or functions


FREE = [v for v in ALL_VARIANTS if v.pairs and not knows_axes(v)]
each_free = pytest.mark.parametrize("variant", FREE, ids=lambda variant: variant.id)


def pair(variant: Variant, seed: int, **options: Any) -> tuple[Place, list[Scene]]:
    rng = np.random.default_rng(seed)
    shift = rng.uniform(-2, 2, 3) * (np.array([1, 1, 0]) if variant.planar else 1)
    place = Place(random_rotation(rng, variant.planar), shift)
    return place, [variant.build(seed, where, **options) for where in (None, place)]


def accelerations(scene: Scene, s: testing.State) -> np.ndarray:
    """Accelerations follow from M a + G^T lam = Q and the second derivatives of the constraints."""
    n, m = len(s.q), len(s.lam)
    s.a, s.lam = 0 * s.a, 0 * s.lam
    s.rate_level = True
    tangent = testing.tangent(scene.mbs, s, cq=0, cv=1, ca=0)
    by_time = s.copy()
    by_time.t = s.t + 1e-6
    slope = (testing.gaps(scene.mbs, by_time) - testing.gaps(scene.mbs, s)) / 1e-6
    system = np.zeros((n + m, n + m))
    system[:n, :n] = testing.mass_matrix(scene.mbs, s)
    ode1 = len(s.y)
    system[:n, n:] = tangent[:n, n + ode1 :]
    system[n:, :n] = tangent[n + ode1 :, :n]
    system[n:, n:] = tangent[n + ode1 :, n + ode1 :]
    of_motion = system[n:, :n].any(axis=1) | ~system[n:, n:].any(axis=1)  # the others return multipliers
    by_q = testing.tangent(scene.mbs, s, cq=1, cv=0, ca=0)[n + ode1 :, :n]
    residual = testing.residual(scene.mbs, s)[:n]
    right = np.concatenate([-residual, np.where(of_motion, -by_q @ s.v - slope, 0)])
    return np.linalg.lstsq(system, right, rcond=None)[0]


def check_forces(variant: Variant) -> None:
    place, scenes = pair(variant, seed=41)
    wrenches = []
    for scene in scenes:
        s = in_touch(scene, scene.state())
        wrenches.append(scene.wrenches(testing.residual(scene.mbs, s)[: len(s.q)]))
    turned = np.concatenate([wrenches[0][:, :3] @ place.turn.T, wrenches[0][:, 3:] @ place.turn.T], axis=1)
    if scenes[0].planar:
        turned[:, 2:5] = wrenches[1][:, 2:5]
    np.testing.assert_allclose(wrenches[1], turned, rtol=0, atol=1e-11 * max(1, np.abs(turned).max(initial=0)))
    others = [
        np.concatenate([coordinate_forces(scene, testing.residual(scene.mbs, in_touch(scene, scene.state())))])
        for scene in scenes
    ]
    np.testing.assert_allclose(others[1], others[0], rtol=0, atol=1e-11 * max(1, np.abs(others[0]).max(initial=0)))


@each_free
def test_forces_are_invariant(variant: Variant) -> None:
    check_forces(variant)


def coordinate_forces(scene: Scene, r: np.ndarray) -> np.ndarray:
    """Generalised forces on coordinates that do not turn: positions of nodes without frame, and lengths of slope
    vectors."""
    turning, forces = set(), []
    for number, kind, motion in scene.nodes:
        first, n = scene.mbs.GetNodeODE2Index(number), len(kind.total(motion))
        turning |= set(range(first, first + n))
        forces += list(kind.others(motion).T @ r[first : first + n])
    return np.array([r[i] for i in range(len(testing.State(scene.mbs).q)) if i not in turning] + forces)


TURNING = {
    "RelativePosition",
    "Displacement",
    "Velocity",
    "Acceleration",
    "AngularVelocity",
    "AngularAcceleration",
    "Director1",
    "Director2",
    "Director3",
    "Force",
    "Torque",
}


def told(scene: Scene) -> dict[str, np.ndarray]:
    """Outputs of the bodies and of the item under test."""
    outputs = {}
    numbers = [*scene.bodies, *([scene.target[1]] if scene.target[0] == "Object" else [])]
    for number in dict.fromkeys(numbers):
        data = scene.mbs.GetObject(number)
        item = next(i for i in ITEMS.values() if i.kind == "object" and i.type_name == data["objectType"])
        body = item.folder in ("bodies", "finite_elements")
        for output in item.outputs:
            point = moves_as_point(item)  # has no orientation
            if (
                output.source == "coordinates"
                or output.size == "n"
                or (body and output.name == "Rotation")
                or (point and "Rotation" in output.name)
            ):
                continue  # coordinates turn in their own ways
            variable = getattr(exu.OutputVariableType, output.name)
            local = (np.array([0.3, -0.2, 0 if scene.planar else 0.1]) * (not point),) if body else ()
            get = scene.mbs.GetObjectOutputBody if body else scene.mbs.GetObjectOutput
            name = "RelativePosition" if output.name in item.scene.relative_outputs else output.name
            name = "PointTransformation" if point and output.name == "HomogeneousTransformation" else name
            name = "Director1" if output.name in item.scene.global_outputs else name
            value = output_of(get, number, variable, *local)
            if value is not None:
                outputs[f"{int(number)} {name} {output.name}"] = np.atleast_1d(value)
    return outputs


def check_accelerations(variant: Variant) -> None:
    """Rounding is magnified by the condition of the equations of motion, some 1e2 to 1e3 here; a prescribed motion has its
    rate by a difference quotient of step 1e-6."""
    place, scenes = pair(variant, seed=42)
    outputs = []
    for scene in scenes:
        s = in_touch(scene, testing.State(scene.mbs))
        solution = accelerations(scene, s.copy())
        data = scene.mbs.systemData
        data.SetDataCoordinates(s.data, exu.ConfigurationType.Current)
        data.SetODE2Coordinates_tt(solution[: len(s.q)], exu.ConfigurationType.Current)
        outputs.append(told(scene))
    tolerance = 1e-6 if variant.functions else 1e-9
    for key, value in outputs[0].items():
        name = key.split()[1]
        wanted = value
        if name == "Position":
            wanted = place.point(value)
        elif name == "RotationMatrix":
            wanted = (place.turn @ value.reshape(3, 3)).ravel()
        elif name == "HomogeneousTransformation":
            wanted = exu.HT(place.turn @ value[:3, :3], place.point(value[:3, 3])).HT44()
        elif name == "PointTransformation":  # without orientation
            wanted = exu.HT(value[:3, :3], place.point(value[:3, 3])).HT44()
        elif name in TURNING and len(value) == 3:
            wanted = place.turn @ value
        scale = max(1, np.abs(value).max())
        np.testing.assert_allclose(outputs[1][key], wanted, rtol=0, atol=tolerance * scale, err_msg=key)


@each_free
def test_accelerations_and_outputs_are_invariant(variant: Variant) -> None:
    check_accelerations(variant)
