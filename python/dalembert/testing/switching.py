"""Items switched on and off while a solver runs, for every connector, contact, constraint and joint."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

import dalembert as exu
from codegen.model import Item
from dalembert._core import testing
from dalembert.testing.repeated_solves import build, final, joins, settings, solvable
from dalembert.testing.scenes import UNDER_TEST, Scene
from dalembert.testing.variants import Variant, variants_with

SWITCHED = [
    item
    for item in UNDER_TEST
    if item.kind == "object" and any(row.name == "activeConnector" for row in item.parameters)
]
each_item = pytest.mark.parametrize("item", SWITCHED, ids=lambda item: item.name)
TOUCHING = -0.2  # a data coordinate of a contact
Step = Callable[[exu.MainSystem, float], bool]


def variant_of(item: Item) -> Variant:
    return next(v for v in variants_with(item) if solvable(v) and v.item == item.name)


def scene_of(item: Item) -> Scene:
    """Contacts act; bodies of joints are pulled in different directions."""
    variant = variant_of(item)
    scene = build(variant, seed=81)
    mbs, data = scene.mbs, scene.mbs.systemData
    if joins(variant):
        for k, body in enumerate(scene.bodies):
            if mbs.GetObject(body)["objectType"] != "GenericODE2":
                marker = mbs.AddMarker(exu.MarkerBodyMass(bodyNumber=body))
                mbs.AddLoad(exu.LoadMassProportional(markerNumber=marker, loadVector=[5 - 9 * k, 3 * k, 4]))
        mbs.Assemble()
    else:
        data.SetDataCoordinates(np.full(data.DataSize(), TOUCHING), exu.ConfigurationType.Initial)
    return scene


def switch(scene: Scene, active: bool) -> None:
    scene.mbs.SetObjectParameter(scene.target[1], "activeConnector", active)


def run(scene: Scene, step: Step | None = None) -> list[np.ndarray]:
    if step is not None:
        scene.mbs.SetPreStepUserFunction(step)
    s = settings()
    s.timeIntegration.generalizedAlpha.computeInitialAccelerations = False  # they belong to the item as it starts
    scene.mbs.SolveDynamic(s)
    return final(scene)


@each_item
@pytest.mark.parametrize("active", [True, False], ids=["on", "off"])
def test_switching_before_the_first_step_is_being_switched_from_the_start(item: Item, active: bool) -> None:
    """Results are bit-identical, and the item has an effect."""
    scene = scene_of(item)
    switch(scene, active)
    expected = run(scene)
    scene = scene_of(item)
    switch(scene, not active)

    def step(mbs: exu.MainSystem, t: float) -> bool:
        switch(scene, active)
        return True

    for found, wanted in zip(run(scene, step), expected, strict=True):
        np.testing.assert_array_equal(found, wanted)
    scene = scene_of(item)
    switch(scene, not active)
    other = run(scene)
    assert any(not np.array_equal(a, b) for a, b in zip(other, expected, strict=True)), "it makes no difference"


@each_item
def test_effects_vanish_and_return(item: Item) -> None:
    """Off in the second and third of five steps: the item's part of the residual, and its multipliers, are zero then."""
    scene = scene_of(item)
    mbs = scene.mbs
    rows = mbs.systemData.GetObjectLTGAE(scene.target[1])
    plan = [True, False, False, True, True]
    states: list[testing.State] = []
    count = iter(range(len(plan)))

    def before(mbs: exu.MainSystem, t: float) -> bool:
        switch(scene, plan[next(count)])
        return True

    def after(mbs: exu.MainSystem, t: float) -> bool:
        if t > 0:  # not for the initial state
            states.append(testing.State(mbs))
        return True

    def effect(s: testing.State, active: bool) -> float:
        if len(rows) > 0 and item.object_type in ("Constraint", "Joint"):
            return float(np.abs(s.lam[rows]).max())
        s.data = np.full(len(s.data), TOUCHING)
        parts = []
        for on in (active, False):
            switch(scene, on)
            parts.append(testing.residual(mbs, s))
        return float(np.abs(parts[0] - parts[1]).max())

    mbs.SetPostStepUserFunction(after)
    run(scene, before)
    effects = [effect(s, active) for s, active in zip(states, plan, strict=True)]
    for active, size in zip(plan, effects, strict=True):
        assert (size > 1e-12) if active else (size == 0), effects
