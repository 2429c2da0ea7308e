"""The steps of a recorded motion: their sizes, the events at their ends, and the accelerations after these."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from dalembert import _core
from dalembert._checks import FloatArray
from dalembert._studies.design_parameters import describe
from dalembert._studies.generalized_alpha import Scheme
from dalembert._studies.not_differentiable import INSTEAD, NotDifferentiable
from dalembert._studies.restarted_steps import Projection, Restart, accelerations, of_accelerations
from dalembert._studies.stored_rows import Rows

_SAME_SIZE = 1e-9  # relative
_BALANCED = 1e-6  # residual of a step, relative to its terms
OF_DATA = 1e-3  # relative steps of data coordinates


class Event(NamedTuple):
    """number: of the switch; item: the object, or -1."""

    number: int
    item: int
    what: str


class Steps(NamedTuple):
    """Sizes of all steps (index 0 is not used), and what starts them.

    a, b: accelerations at the start of each step; ratio: size relative to that of the step before, by which b has been
    moved; 0 after an event, and in the first step. multipliers: those after events. velocities: those at the start of
    steps, where they are not those of the state before; moved: projections of steps whose velocities moved with their
    size; restarts: by the step before.
    """

    sizes: FloatArray
    regular: float
    a: Rows
    b: Rows
    ratios: FloatArray
    events: dict[int, Event]
    multipliers: dict[int, FloatArray]
    velocities: dict[int, FloatArray]
    moved: dict[int, Projection]
    restarts: dict[int, Restart]
    prescribed: bool = False  # the end of each step is a given time, or an event

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
    adaptive: bool = False,
    prescribed: bool = False,
) -> Steps:
    """Find events, and the accelerations after them; refuse steps that are not explained by them.

    adaptive: tolerances have chosen the sizes of steps. prescribed: steps end at given times.
    has_stages: steps are those of a Runge-Kutta method, whose ends are checked with their stages.
    rate_level: velocities fulfil constraints at the ends of steps. Otherwise, generalized alpha restarts with those of
    equal steps.
    """
    n, _, m, nd = derivatives.sizes
    restarts_steadily = m > 0 and not has_stages and not rate_level
    count = len(times)
    sizes = np.diff(times, prepend=times[0])
    sizes[np.abs(sizes - regular) < _SAME_SIZE * regular] = regular
    a, b, ratios = Rows(n, memory), Rows(n, memory), np.zeros(count)
    a.append(np.zeros(n))
    b.append(np.zeros(n))
    events: dict[int, Event] = {}
    multipliers: dict[int, FloatArray] = {}
    velocities: dict[int, FloatArray] = {}
    moved: dict[int, Projection] = {}
    restarts: dict[int, Restart] = {}
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
            # Repeated and recovered steps of equal size take b as it is.
            ratios[i] = h / size if found or last or adaptive or h == size else 0.0
            if ratios[i] not in (0.0, 1.0) and not scheme.newmark:
                b_now = a_now + ratios[i] * (b_now - a_now)
            if ratios[i] not in (0.0, 1.0) and restarts_steadily:
                start, v = float(times[i - 1]), velocities.get(i, z_before[n : 2 * n])
                with of_accelerations(derivatives):
                    moved[i] = Projection.of(derivatives, z_before, start, v, size)
                velocities[i] = v - (1 - ratios[i] ** 2) * (v - moved[i].after)
        a.append(a_now)
        b.append(b_now)
        a_end = z_after[2 * n : 3 * n]
        a_now, b_now, size = a_end, own.algorithmic(a_now, b_now, a_end), h
        if found:
            events[i] = found[0]
            with of_accelerations(derivatives):
                if restarts_steadily:
                    left = float(times[-1] - times[i - 1])
                    to_end = left < (1 - _SAME_SIZE) * regular
                    restart = Restart.of(derivatives, scheme, z_after, time, h, left if to_end else regular, to_end)
                    restarts[i], velocities[i + 1] = restart, restart.v
                    a_now, b_now, size = restart.state[2 * n : 3 * n], restart.b, restart.size
                else:
                    a_now, multipliers[i] = accelerations(derivatives, z_after, time, h)
                    b_now, size = a_now, 0.0
        before = list(derivatives.switches(z_after, time, h)) if watches else []
        z_before = z_after
    return Steps(sizes, regular, a, b, ratios, events, multipliers, velocities, moved, restarts, prescribed)


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
    residuals = derivatives.residuals(ends, times[part], h)
    unbalanced = np.abs(residuals)[:, :n].max(axis=1, initial=0.0) > _BALANCED * _forces(
        derivatives, ends, times[part], h
    )
    if np.any(unbalanced):
        i = int(np.argmax(unbalanced))
        _check_balance(derivatives, ends[i], float(times[part.start + i]), h, mbs)
    ends[:, data] *= 1 + OF_DATA
    return bool(np.all(derivatives.residuals(ends, times[part], h) == residuals))


def _forces(derivatives: Any, states: FloatArray, times: FloatArray, h: float) -> FloatArray:
    """Return the size of the forces in each state, which may balance each other: applied ones, and with reactions."""
    n, first_data = derivatives.sizes[0], states.shape[1] - derivatives.sizes[3]
    still = states.copy()
    still[:, 2 * n : 3 * n] = 0.0
    applied = still.copy()
    applied[:, first_data - derivatives.sizes[2] : first_data] = 0.0  # multipliers
    sums = [np.abs(derivatives.residuals(each, times, h))[:, :n].max(axis=1, initial=0.0) for each in (still, applied)]
    return np.maximum(np.maximum(*sums), 1e-9)


def _check_balance(derivatives: Any, z: FloatArray, time: float, h: float, mbs: Any) -> None:
    """Refuse a step that was not solved with the data coordinates of its start."""
    n = derivatives.sizes[0]
    residual = np.abs(derivatives.residual(z, time, h))[:n]
    if residual.max(initial=0.0) > _BALANCED * _forces(derivatives, z[None], np.array([time]), h)[0]:
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
