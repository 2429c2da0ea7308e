"""The steps of a recorded motion: their sizes, the events at their ends, and the accelerations after these."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from dalembert import _core
from dalembert._checks import FloatArray
from dalembert._studies.design_parameters import describe
from dalembert._studies.generalized_alpha import Scheme
from dalembert._studies.not_differentiable import INSTEAD, NotDifferentiable
from dalembert._studies.stored_rows import Rows

_SAME_SIZE = 1e-9  # relative
_BALANCED = 1e-6  # residual of a step, relative to its terms
OF_DATA = 1e-3  # relative steps of data coordinates
OF_MASS = (0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0)  # weights of derivatives in the matrix of the accelerations


class Event(NamedTuple):
    """number: of the switch; item: the object, or -1."""

    number: int
    item: int
    what: str


class Steps(NamedTuple):
    """Sizes of all steps (index 0 is not used), and what starts them.

    a, b: accelerations at the start of each step; ratio: size relative to that of the step before, by which b has been
    moved; 0 after an event, and in the first step. multipliers: those after events.
    """

    sizes: FloatArray
    regular: float
    a: Rows
    b: Rows
    ratios: FloatArray
    events: dict[int, Event]
    multipliers: dict[int, FloatArray]

    @property
    def moves(self) -> bool:
        return bool(self.events)

    @property
    def equal(self) -> bool:
        return bool(np.all(self.sizes[1:-1] == self.regular))

    def is_regular(self, step: int) -> bool:
        return bool(self.sizes[step] == self.regular)


def with_data(z: FloatArray, data: FloatArray) -> FloatArray:
    """Return a state with other data coordinates, which are its last ones."""
    made = z.copy()
    made[len(z) - len(data) :] = data
    return made


def find_steps(
    times: FloatArray,
    states: Rows,
    scheme: Scheme,
    regular: float,
    derivatives: Any,
    mbs: Any,
    *,
    watches: bool,
    memory: float,
    has_stages: bool = False,
    rate_level: bool = False,
) -> Steps:
    """Find events, and the accelerations after them; refuse steps that are not explained by them.

    has_stages: steps are those of a Runge-Kutta method, whose ends are checked with their stages.
    rate_level: velocities fulfil constraints at the ends of steps. Otherwise, generalized alpha projects them after an
    event, and changes them to those of equal steps, by differences of the motion ahead.
    """
    n, _, m, nd = derivatives.sizes
    count = len(times)
    sizes = np.diff(times, prepend=times[0])
    sizes[np.abs(sizes - regular) < _SAME_SIZE * regular] = regular
    a, b, ratios = Rows(n, memory), Rows(n, memory), np.zeros(count)
    a.append(np.zeros(n))
    b.append(np.zeros(n))
    events: dict[int, Event] = {}
    multipliers: dict[int, FloatArray] = {}
    before: list[Any] = []
    z_before = states[0]
    a_now, b_now, size = z_before[2 * n : 3 * n], z_before[2 * n : 3 * n], 0.0
    for i in range(1, count):
        h, time = float(sizes[i]), float(times[i])
        own = scheme if h == scheme.h else replace(scheme, h=h)
        z_after = states[i]
        data = z_before[len(z_before) - nd :]
        z = with_data(z_after, data) if nd else z_after
        if not has_stages:
            _check_balance(derivatives, z, time, h, mbs)
        if not before and watches:
            before = list(derivatives.switches(z_before, float(times[i - 1]), h))
        regular_step, last = h == regular, i == count - 1
        now = list(derivatives.switches(z, time, h)) if watches else []
        found = _switched(now, before, True)
        if not found and not regular_step and not last:
            found = _switched(now, before, False)
        if len(found) > 1 and len({event.item for event in found}) + len({event.what for event in found}) > 2:
            raise NotDifferentiable(
                "two events come at the same time",
                item=name_of(mbs, found[1]),
                time=time,
                advice="change the start a little, so that one comes first",
            )
        if size > 0:
            ratios[i] = h / size if found or last or h == size else 0.0  # repeated and recovered steps take b as it is
            if ratios[i] not in (0.0, 1.0) and not scheme.newmark:
                b_now = a_now + ratios[i] * (b_now - a_now)
        a.append(a_now)
        b.append(b_now)
        a_end = z_after[2 * n : 3 * n]
        a_now, b_now, size = a_end, own.algorithmic(a_now, b_now, a_end), h
        if found:
            if m > 0 and not has_stages and not rate_level:
                raise NotDifferentiable(
                    "generalized alpha changes velocities after events in systems with constraints",
                    item=name_of(mbs, found[0]),
                    time=time,
                    advice="use exu.DynamicSolverType.ESDIRK43, an explicit Runge-Kutta method, or TrapezoidalIndex2",
                )
            events[i] = found[0]
            with of_accelerations(derivatives):
                a_now, multipliers[i] = accelerations(derivatives, z_after, time, h)
            b_now, size = a_now, 0.0
        before = list(derivatives.switches(z_after, time, h)) if watches else []
        z_before = z_after
    return Steps(sizes, regular, a, b, ratios, events, multipliers)


def _switched(now: list[Any], before: list[Any], beyond_noise: bool) -> list[Event]:
    """Return events at the end of a step."""
    return [
        Event(k, item, what)
        for k, ((value, kink, noise, item, what), old) in enumerate(zip(now, before, strict=True))
        if (value * old[0] < 0 if kink else value < (-noise if beyond_noise else 0.0))
    ]


def name_of(mbs: Any, event: Event) -> str:
    name = describe(mbs, _core.ObjectIndex(event.item)) if event.item >= 0 else "system"
    return f"event '{event.what}' of {name}"


def only_states_of_items(times: FloatArray, states: Rows, h: float, derivatives: Any, mbs: Any) -> bool:
    """Return whether residuals of equal steps depend on states of items alone, such as turns of a spring.

    These do not vary. Values of data coordinates, such as the place where friction sticks, do.
    """
    return all(_data_do_not_vary(times, states, h, derivatives, mbs, part) for part in states.blocks(1))


def _data_do_not_vary(times: FloatArray, states: Rows, h: float, derivatives: Any, mbs: Any, part: slice) -> bool:
    n, _, _, nd = derivatives.sizes
    data = slice(states.width - nd, None)
    ends = states[part].copy()
    ends[:, data] = states[part.start - 1 : part.stop - 1][:, data]
    still = ends.copy()
    still[:, 2 * n : 3 * n] = 0.0
    residuals = derivatives.residuals(ends, times[part], h)
    terms = np.abs(derivatives.residuals(still, times[part], h))[:, :n].max(axis=1, initial=0.0)
    unbalanced = np.abs(residuals)[:, :n].max(axis=1, initial=0.0) > _BALANCED * np.maximum(terms, 1e-9)
    if np.any(unbalanced):
        i = int(np.argmax(unbalanced))
        _check_balance(derivatives, ends[i], float(times[part.start + i]), h, mbs)
    ends[:, data] *= 1 + OF_DATA
    return bool(np.all(derivatives.residuals(ends, times[part], h) == residuals))


def _check_balance(derivatives: Any, z: FloatArray, time: float, h: float, mbs: Any) -> None:
    """Refuse a step that was not solved with the data coordinates of its start."""
    n = derivatives.sizes[0]
    residual = np.abs(derivatives.residual(z, time, h))[:n]
    still = z.copy()
    still[2 * n : 3 * n] = 0.0
    terms = np.abs(derivatives.residual(still, time, h))[:n].max(initial=0.0)
    if residual.max(initial=0.0) > _BALANCED * max(terms, 1e-9):
        raise NotDifferentiable(
            "its history, such as of contact or friction, has changed within the step",
            item=_item_with_history(mbs),
            time=time,
            advice="set simulationSettings.events.ofItems = True, or " + INSTEAD,
        )


def _item_with_history(mbs: Any) -> str:
    """Return the name of the first object with data coordinates."""
    data = mbs.systemData
    for number in range(data.NumberOfObjects()):
        for value in mbs.GetObject(number).values():
            for each in value if isinstance(value, (list, tuple)) else [value]:
                if isinstance(each, _core.NodeIndex) and data.GetNodeLTGData(int(each)):
                    return describe(mbs, _core.ObjectIndex(number))
    return "time integration"


@contextmanager
def of_accelerations(*systems: Any) -> Iterator[None]:
    """Take constraints of accelerations."""
    before = [system.acceleration_level for system in systems]
    for system in systems:
        system.acceleration_level = True
    try:
        yield
    finally:
        for system, level in zip(systems, before, strict=True):
            system.acceleration_level = level


def accelerations(derivatives: Any, z: FloatArray, time: float, h: float) -> tuple[FloatArray, FloatArray]:
    """Return accelerations and multipliers of the equations of motion, with constraints of accelerations."""
    n, n1, m, _ = derivatives.sizes
    still = z.copy()
    still[2 * n : 3 * n] = still[3 * n + 2 * n1 : 3 * n + 2 * n1 + m] = 0.0
    found = over_mass(derivatives, still, time, h, np.asarray(derivatives.residual(still, time, h))[None])[0]
    return found[:n], found[n + n1 :]


def over_mass(derivatives: Any, z: FloatArray, time: float, h: float, right: FloatArray) -> FloatArray:
    """Return solutions a and lambda of M a + G^T lambda = - right, G a = - right, in rows."""
    n, n1, _, _ = derivatives.sizes
    derivatives.linearize(z, time, h)
    failed = derivatives.factorize(OF_MASS)
    if failed >= 0:
        raise NotDifferentiable("the mass matrix is singular", item="accelerations after an event", time=time)
    padded = right.copy()
    padded[:, n : n + n1] = 0.0
    return -np.asarray(derivatives.solve(padded))
