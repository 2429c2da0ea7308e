"""A solver leaves nothing behind: two runs in a row from the same start are bit for bit two fresh runs."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import dalembert as exu
from codegen.model import Item
from dalembert._core import testing
from dalembert.testing.exemptions import ODD_IN_JOINTS
from dalembert.testing.motions import KINDS
from dalembert.testing.scenes import ITEMS, UNDER_TEST, Scene, is_ground
from dalembert.testing.variants import ALL_VARIANTS, Variant, variants_with

PLAIN = [
    item for item in UNDER_TEST if item.kind != "sensor" and not is_ground((item.name, ""))
]  # those: test_sensors.py


def joins(variant: Variant) -> bool:
    return ITEMS[variant.item].object_type in ("Constraint", "Joint")


def solvable(variant: Variant) -> bool:
    """Bodies that cannot follow a joint are left out, and Euler parameters without their condition."""
    item = ITEMS[variant.item]
    frames = "Coordinate" not in item.requested_markers
    redundant = joins(variant) and frames and variant.planar and not item.scene.planar  # equations out of the plane
    # joints along cables name no kind of marker: they go along with them
    odd = frames and item.requested_markers and variant.uses & set(ODD_IN_JOINTS)
    fits = not joins(variant) or not (odd or variant.functions)
    return fits and not redundant and dict(variant.options).get("addConstraintEquation", True)


def explicit(variant: Variant) -> bool:
    return not joins(variant) and not any(name in KINDS and KINDS[name].frame == "ep" for name in variant.uses)


def build(variant: Variant, seed: int) -> Scene:
    """Joints closed and at rest, but heavy; contacts open or closed as they are."""
    scene = variant.build(seed, closed=joins(variant), resting=joins(variant))
    if variant.data:
        s = testing.State(scene.mbs)
        testing.post_newton(scene.mbs, s)
        for configuration in (exu.ConfigurationType.Initial, exu.ConfigurationType.Current):
            scene.mbs.systemData.SetDataCoordinates(s.data, configuration)
    if joins(variant):
        for body in scene.bodies:
            if scene.mbs.GetObject(body)["objectType"] not in ("GenericODE2", "KinematicTree"):
                marker = scene.mbs.AddMarker(exu.MarkerBodyMass(bodyNumber=body))
                scene.mbs.AddLoad(exu.LoadMassProportional(markerNumber=marker, loadVector=[1, -2, 3]))
        scene.mbs.Assemble()
    return scene


def settings() -> Any:
    s = exu.SimulationSettings()
    s.timeIntegration.endTime = 1e-4
    s.timeIntegration.numberOfSteps = 5
    s.timeIntegration.verboseMode = 0
    s.solutionSettings.writeSolutionToFile = False
    return s


def final(scene: Scene) -> list[np.ndarray]:
    s = testing.State(scene.mbs)
    return [s.q, s.v, s.a, s.y, s.y_t, s.lam, s.data]


def run_twice(variant: Variant, solver: Any) -> None:
    scenes = [build(variant, seed=61) for _ in range(2)]
    start, results = final(scenes[0]), []
    for scene, times in zip(scenes, (2, 1), strict=True):
        for _ in range(times):
            scene.mbs.SolveDynamic(settings(), solverType=solver)
        results.append(final(scene))
    for first, second in zip(*results, strict=True):
        np.testing.assert_array_equal(first, second)
    assert any(not np.array_equal(a, b) for a, b in zip(start, results[0], strict=True)), "nothing moved"


SOLVABLE = [v for v in ALL_VARIANTS if solvable(v)]


@pytest.mark.parametrize("variant", SOLVABLE, ids=lambda variant: variant.id)
def test_two_implicit_solves_in_a_row(variant: Variant) -> None:
    run_twice(variant, exu.DynamicSolverType.GeneralizedAlpha)


@pytest.mark.parametrize("variant", list(filter(explicit, SOLVABLE)), ids=lambda variant: variant.id)
def test_two_explicit_solves_in_a_row(variant: Variant) -> None:
    run_twice(variant, exu.DynamicSolverType.RK44)


def test_every_item_is_solved() -> None:
    assert {item.name for item in PLAIN} <= set().union(*(v.uses for v in SOLVABLE))


@pytest.mark.parametrize("item", [i for i in PLAIN if i.kind == "object"], ids=lambda item: item.name)
def test_parameters_taken_over_between_solves(item: Item) -> None:
    """Changed and changed back: the run is that of the original."""
    variant = next(v for v in variants_with(item) if solvable(v))
    scenes = [build(variant, seed=62) for _ in range(2)]
    data = scenes[0].mbs.GetDictionary()["objectList"]
    number = next(i for i, entry in enumerate(data) if entry["objectType"] == item.type_name)
    row = next(
        (
            r
            for r in item.parameters
            if r.type.storage == "real" and r.effective_check == "non_negative" and not r.internal
        ),
        None,
    )
    if row is not None:
        value = scenes[0].mbs.GetObjectParameter(number, row.name)
        scenes[0].mbs.SetObjectParameter(number, row.name, 1.5 * value + 0.25)
        scenes[0].mbs.SolveDynamic(settings())
        scenes[0].mbs.SetObjectParameter(number, row.name, value)
    results = []
    for scene in scenes:
        scene.mbs.SolveDynamic(settings())
        results.append(final(scene))
    for first, second in zip(*results, strict=True):
        np.testing.assert_array_equal(first, second)


def without_functions(item: Item) -> Variant | None:
    return next((v for v in variants_with(item) if solvable(v) and not v.functions), None)


def varied_parameter(scene: Scene, item: Item) -> tuple[Any, str, list[float]] | None:
    """An index, the first parameter that may be any number from zero on, and three values; Return None if there is
    none."""
    row = next(
        (
            r
            for r in item.parameters
            if r.type.storage == "real" and r.effective_check == "non_negative" and not r.internal
        ),
        None,
    )
    if row is None or item.kind not in ("object", "load"):
        return None
    data = scene.mbs.GetDictionary()[f"{item.kind}List"]
    number = next(i for i, entry in enumerate(data) if entry[f"{item.kind}Type"] == item.type_name)
    value = data[number][row.name]
    return (
        {"object": exu.ObjectIndex, "load": exu.LoadIndex}[item.kind](number),
        row.name,
        [value, value + 1, 3 * value],
    )


@pytest.mark.parametrize("item", [item for item in PLAIN if without_functions(item)], ids=lambda item: item.name)
def test_variations_are_runs_of_models_of_their_own(item: Item) -> None:
    variant = without_functions(item)
    ends = [1e-3, 5e-4, 2e-3]
    scene = build(variant, seed=63)
    varied = varied_parameter(scene, item)
    parameters = {} if varied is None else {varied[:2]: varied[2]}
    together = scene.mbs.SolveVariations(
        parameters, settings(), settings={"timeIntegration.endTime": ends}, sensors=[], storeCoordinates=True
    )
    for k, end in enumerate(ends):
        scene, single = build(variant, seed=63), settings()
        single.timeIntegration.endTime = end
        if varied is not None and item.kind == "object":
            scene.mbs.SetObjectParameter(varied[0], varied[1], varied[2][k])
        elif varied is not None:
            scene.mbs.SetLoadParameter(varied[0], varied[1], varied[2][k])
        scene.mbs.SolveDynamic(single)
        assert together.success[k], together.messages[k]
        for name, alone in zip(
            ("ODE2", "ODE2_t", "ODE2_tt", "ODE1", "ODE1_t", "AE", "Data"), final(scene), strict=True
        ):
            np.testing.assert_array_equal(together.coordinates[name][k], alone)
