"""Actions at switches of items (events.ofItems): errors, notices, actions of users, and the end of a solution."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from oscillators import MASS, friction_or_stop, mass
from test_events_of_items import (
    AFTER_TWO_SECONDS,
    GRAVITY,
    HEIGHT,
    Solver,
    height,
    in_general_contact,
    on_plane,
    on_sphere,
    solve,
)

import dalembert as exu
from dalembert.solver import SolverError

# ---- errors, and actions without effect
# --------------------------------------------------------------------------------


def floor_of(mbs: Any) -> int:
    return next(i for i in range(mbs.systemData.NumberOfObjects()) if mbs.GetObject(i)["name"] == "floor")


def test_ever_faster_events_name_the_item() -> None:
    """Bounces without losses that are shorter than a step, and contacts that are shorter still."""
    mbs, ball = on_sphere()
    contact = floor_of(mbs)
    mbs.SetObjectParameter(contact, "contactDamping", 0)
    mbs.SetObjectParameter(contact, "contactStiffness", 2e6)
    height_of_fall = 3e-5 - HEIGHT
    mbs.SetNodeParameter(mbs.GetObject(ball)["nodeNumber"], "initialCoordinates", [0, 0, height_of_fall, 0, 0, 0, 0])
    mbs.Assemble()
    with pytest.raises(
        SolverError,
        match=rf"event 'contact' of object {contact} 'floor' \(ObjectContactSphereSphere\) has come 20 times",
    ) as caught:
        solve(mbs, 1, 100, damped=False)
    assert caught.value.reason == "eventChatter"


def test_an_item_that_is_switched_off_has_no_events() -> None:
    mbs, ball = on_sphere()
    mbs.Assemble()
    mbs.SetObjectParameter(floor_of(mbs), "activeConnector", False)
    it = solve(mbs, 1, 100)
    assert it.eventsCount == 0
    assert height(mbs, ball) == pytest.approx(HEIGHT - GRAVITY / 2, abs=1e-10)


def test_models_without_such_items_say_so(capsys: pytest.CaptureFixture[str]) -> None:
    model = mass()
    model.mbs.Assemble()
    solve(model.mbs, 1, 10)
    assert "events.ofItems has no effect: no item of this model has events of its own" in "".join(capsys.readouterr())


def test_wrong_data_at_the_start_are_settled() -> None:
    """The data say that the ball touches; it does not."""
    mbs, ball = on_sphere()
    mbs.SetNodeParameter(mbs.GetObject(floor_of(mbs))["nodeNumber"], "initialCoordinates", [-1, 0, 0, 0])
    mbs.Assemble()
    it = solve(mbs, 0.3, 30)
    assert it.eventsCount == 0
    assert height(mbs, ball) == pytest.approx(HEIGHT - GRAVITY * 0.3**2 / 2, abs=1e-10)


# ---- actions ---------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("build", [on_sphere, on_plane, in_general_contact])
@pytest.mark.parametrize("solver", [Solver.GeneralizedAlpha, Solver.DOPRI5, Solver.ESDIRK43])
def test_impacts_by_a_law_where_items_touch(build: Callable[[], Any], solver: Any) -> None:
    """Each impact leaves 0.8 of the speed, so that forces of the contact have no time: parabolas, which all methods solve exactly."""
    mbs, ball = build()
    restitution, events = 0.8, []

    def bounce(mbs: Any, t: float, item: Any, event: str, direction: int) -> bool:
        events.append((t, item, event, direction))
        if event == "contact" and direction == 1:
            velocities = mbs.systemData.GetODE2Coordinates_t()
            velocities[2] *= -restitution
            mbs.systemData.SetODE2Coordinates_t(velocities)
        return True

    mbs.SetItemEventActionUserFunction(bounce)
    mbs.Assemble()
    solve(mbs, 1.5, 15, solver, automaticStepSize=False)
    fall = np.sqrt(2 * HEIGHT / GRAVITY)
    impacts = fall * (1 + np.array([0, 2 * restitution, 2 * restitution + 2 * restitution**2]))
    closing = [(t, item) for t, item, event, direction in events if (event, direction) == ("contact", 1)]
    # Steps end 1e-11 of their size beyond; the contact acts for as long as the ball takes to leave that.
    np.testing.assert_allclose([t for t, _ in closing], impacts, rtol=0, atol=1e-8)
    objects = [mbs.GetObject(i)["objectType"] for i in range(mbs.systemData.NumberOfObjects())]
    contacts = [i for i, name in enumerate(objects) if "Contact" in name]
    assert all(item in contacts or str(item).startswith("sphere ") for _, item in closing)
    speed, after = restitution**3 * GRAVITY * fall, 1.5 - impacts[-1]
    assert height(mbs, ball) == pytest.approx(speed * after - GRAVITY * after**2 / 2, abs=1e-7)


def test_the_end_where_a_stop_is_met() -> None:
    """Half a meter at 1 m/s; the stop is met, not left."""
    model = mass(position=0.5, speed=-1)
    stop = friction_or_stop(
        model, useLimitStops=True, limitStopsLower=0.0, limitStopsUpper=10.0, limitStopsStiffness=1e4
    )
    events: list[Any] = []

    def end(mbs: Any, t: float, item: int, event: str, direction: int) -> bool:
        events.append((t, item, event, direction))
        return False

    model.mbs.SetItemEventActionUserFunction(end)
    model.mbs.Assemble()
    it = solve(model.mbs, 1, 7)
    assert events == [(pytest.approx(0.5, abs=1e-10), stop, "stop", 1)]
    assert it.currentTime == events[0][0] and model.position == pytest.approx(0, abs=1e-10)
    assert model.mbs.sys["dynamicSolver"].output.simulationStoppedByUserFunction


def test_the_end_where_friction_holds() -> None:
    """A mass that a force of 3 N drives slides against 5 N until it stands, after m v / (5 N - 3 N)."""
    drive, friction, speed = 3.0, 5.0, 2.0
    model = mass(position=0.0, speed=speed)
    model.load(drive)
    item = friction_or_stop(model, 1, stiffness=0.0, fDynamicFriction=friction, stickingStiffness=1e4)
    events: list[Any] = []

    def end(mbs: Any, t: float, number: int, event: str, direction: int) -> bool:
        events.append((t, number, event, direction))
        return False

    model.mbs.SetItemEventActionUserFunction(end)
    model.mbs.Assemble()
    stands = MASS * speed / (friction - drive)
    it = solve(model.mbs, 2 * stands, 30)
    # Constant forces are exact in steps of any size; the place is found to 1e-11 of them.
    assert events == [(pytest.approx(stands, abs=1e-9), item, "friction", -1)]
    assert it.currentTime == events[0][0] and model.position == pytest.approx(speed * stands / 2, abs=1e-9)


def test_actions_without_events_of_items_say_so(capsys: pytest.CaptureFixture[str]) -> None:
    mbs, _ = on_sphere()
    mbs.SetItemEventActionUserFunction(lambda mbs, t, item, event, direction: True)
    mbs.Assemble()
    solve(mbs, 0.1, 10, located=False)
    assert "mbs.ItemEventActionUserFunction has no effect: events of items are not looked for" in "".join(
        capsys.readouterr()
    )


@pytest.mark.parametrize("solver", [Solver.DOPRI5, Solver.DOP853])
def test_errors_outside_of_tolerances_are_reported(solver: Any, capsys: pytest.CaptureFixture[str]) -> None:
    """A ball comes down on a floor of 10^5 N/m, with steps that only its flight bounds; the floor holds it from the end of a step on."""
    errors = {}
    for located in (False, True):
        mbs, ball = on_sphere()
        mbs.Assemble()
        solve(mbs, 2.0, 400, solver, located, automaticStepSize=True, absoluteTolerance=1e-8, relativeTolerance=1e-8)
        place = mbs.GetObjectOutputBody(ball, exu.OutputVariableType.Position)[2]
        errors[located] = abs(place - AFTER_TWO_SECONDS)
        told = "event 'contact' of object 2 'floor' (ObjectContactSphereSphere) lies within the step of"
        assert (told in "".join(capsys.readouterr())) == (not located)
    assert errors[True] < 1e-6 < 1e-5 < errors[False]


def test_equal_steps_promise_no_tolerance(capsys: pytest.CaptureFixture[str]) -> None:
    mbs, _ = on_sphere()
    mbs.Assemble()
    solve(mbs, 0.5, 1000, Solver.RK44, located=False)
    assert "lies within the step" not in "".join(capsys.readouterr())
