"""Variations of a motion whose steps end at times that depend on parameters, at events or at the end.

A step from the state z to z' = Phi(z, h, D; p) has the data coordinates D of its start, which change at its end, by
D' = S(z', D; p). Its size h is

    constant, or a part of the duration         regular steps, and those that were repeated with a part of their size
    that of g(z', t', D; p) = 0                 a step that ends at an event with the switch g of an item
    T - t                                       the last step

At an event, dh = -(g_z dz' + g_t dt' + g_p dp)/(g_z z'_h + g_t), with dz' at a fixed size, and z'_h = dPhi/dh. After
it, accelerations are those of the equations of motion with the new data; see restarted_steps for generalized alpha with
constraints. The transposed maps give the gradient.

Serban, Recuero: Sensitivity analysis for hybrid systems and systems with memory, Journal of Computational and Nonlinear
Dynamics 14 (2019).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, fields, replace
from typing import Any, NamedTuple

import numpy as np

from dalembert import _core
from dalembert._checks import FloatArray
from dalembert._studies.design_parameters import Parameters, Variant, describe, weighted
from dalembert._studies.difference_formulas import CENTRAL, FORWARD, derivative
from dalembert._studies.generalized_alpha import LinearStep, Scheme, Variation, turns_of_steps
from dalembert._studies.not_differentiable import INSTEAD, NotDifferentiable
from dalembert._studies.recorded_steps import OF_DATA, Steps, name_of, with_data
from dalembert._studies.restarted_steps import factorize_mass, of_accelerations, over_mass
from dalembert._studies.stored_rows import Rows

_GRAZES = 1e-6  # rate of a switch, relative to its terms
SMALL = 1e-3  # relative to the usual steps: changes of data must not switch


@dataclass
class Moving:
    """A variation of a state, its time, the size of the step before, and tracked data coordinates; or derivatives."""

    state: Variation
    t: FloatArray
    h: FloatArray
    data: FloatArray

    @staticmethod
    def of(state: Variation, data: int) -> Moving:
        rows = len(state.q)
        return Moving(state, np.zeros(rows), np.zeros(rows), np.zeros((rows, data)))

    def plus(self, factors: FloatArray, other: Moving) -> Moving:
        """Return the sum with an outer product: each row gets its factor times the single row of the other."""
        state = Variation(
            *(
                getattr(self.state, each.name) + factors[:, None] * getattr(other.state, each.name)
                for each in fields(Variation)
            )
        )
        return Moving(state, self.t + factors * other.t[0], self.h + factors * other.h[0], self.data)

    def dot(self, other: Moving) -> FloatArray:
        """Return products of all rows with a single row."""
        total = self.t * other.t[0] + self.h * other.h[0]
        for each in fields(Variation):
            total = total + getattr(self.state, each.name) @ getattr(other.state, each.name)[0]
        return np.asarray(total)


class AtState(NamedTuple):
    """Derivatives with respect to a state: positions, velocities, first-order coordinates, time, and data."""

    q: FloatArray
    v: FloatArray
    y: FloatArray
    t: FloatArray
    data: FloatArray


class Walk:
    """Linearized steps of a motion."""

    def __init__(
        self,
        parameters: Parameters,
        times: FloatArray,
        states: Rows,
        scheme: Scheme,
        steps: Steps,
        typical: FloatArray,
        end_time: int | None,
    ) -> None:
        self.parameters, self.times, self.states = parameters, times, states
        self.scheme, self.steps, self.typical, self.end_time = scheme, steps, typical, end_time
        self.derivatives = parameters.base.derivatives
        self.n, self.n1, self.m, self.nd = self.derivatives.sizes
        self.count = 3 * self.n + 2 * self.n1 + self.m
        self.schemes: dict[float, Scheme] = {scheme.h: scheme}
        self.tracked = self._tracked()

    # ---- single steps ------------------------------------------------------------------------------------------------

    def scheme_of(self, h: float) -> Scheme:
        if h not in self.schemes:
            self.schemes[h] = replace(self.scheme, h=h)
        return self.schemes[h]

    def data(self, step: int) -> FloatArray:
        return np.asarray(self.states[step][self.count :])

    def end(self, step: int) -> FloatArray:
        """Return the state at the end, with the data of the step."""
        return with_data(self.states[step], self.data(step - 1)) if self.nd else np.asarray(self.states[step])

    def velocity_before(self, i: int) -> FloatArray:
        """Return the velocities at the start of a step."""
        n, moved = self.n, self.steps.velocities.get(i)
        return self.states[i - 1][n : 2 * n] if moved is None else moved

    def linear_step(self, i: int, transposed: bool) -> LinearStep:
        h, time = float(self.steps.sizes[i]), float(self.times[i])
        z = self.end(i)
        self.derivatives.linearize(z, time, h)
        n, scheme = self.n, self.scheme_of(h)
        start = self.velocity_before(i), self.steps.a[i], self.steps.b[i], self.states[i][2 * n : 3 * n]
        turns = turns_of_steps(scheme, *(part[None] for part in start))
        step = LinearStep(scheme, self.derivatives, turns.of_step(0))
        failed = step.factorize(transposed)
        if failed >= 0:
            raise NotDifferentiable(
                "the matrix of the step is singular",
                item=_core.testing.describe_row(self.parameters.base.mbs, failed),
                time=time,
            )
        return step

    def residual_rates(self, i: int) -> tuple[FloatArray, FloatArray]:
        """Return derivatives of the residual of a step with respect to time, and to the size of the step."""
        z, time, h = self.end(i), float(self.times[i]), float(self.steps.sizes[i])
        scale = self.steps.regular * SMALL
        by_time = derivative(lambda e: self.derivatives.residual(z, time + e, h), scale)
        by_size = derivative(lambda e: self.derivatives.residual(z, time, h + e), SMALL * h)
        return by_time, by_size

    def by_data(self, i: int) -> FloatArray:
        """Return derivatives of the residual of a step with respect to tracked data coordinates, in rows."""
        return self._by_data_at(self.end(i), float(self.times[i]), float(self.steps.sizes[i]))

    def _by_data_at(self, z: FloatArray, time: float, h: float) -> FloatArray:
        return np.array(
            [self._along_data(lambda at: self.derivatives.residual(at, time, h), z, entry) for entry in self.tracked]
        )

    def _along_data(self, function: Any, z: FloatArray, entry: int) -> FloatArray:
        value = z[self.count + entry]
        if value == 0:
            return np.zeros_like(np.asarray(function(z)))  # a state, such as sticking

        entry += self.count
        return np.asarray(derivative(lambda e: np.asarray(function(self._plus(z, entry, e))), OF_DATA * abs(value)))

    def _tracked(self) -> list[int]:
        """Return data coordinates whose values, and not only their signs, matter."""
        if self.nd == 0:
            return []
        found: set[int] = set()
        for i in range(1, len(self.times)):
            z, time, h = self.end(i), float(self.times[i]), float(self.steps.sizes[i])
            residual = np.asarray(self.derivatives.residual(z, time, h))
            for entry in set(range(self.nd)) - found:
                if z[self.count + entry] != 0:
                    moved = z.copy()
                    moved[self.count + entry] *= 1 + OF_DATA
                    if np.any(np.asarray(self.derivatives.residual(moved, time, h)) != residual):
                        found.add(entry)
        grows = bool(found)
        while grows:
            grows = False
            for i in range(1, len(self.times)):
                z, time, h = self.end(i), float(self.times[i]), float(self.steps.sizes[i])
                after = np.asarray(self.derivatives.switch_over(z, time, h))
                for entry in set(range(self.nd)) - found:
                    if z[self.count + entry] == 0:
                        continue
                    moved = z.copy()
                    moved[self.count + entry] *= 1 + OF_DATA
                    changed = np.asarray(self.derivatives.switch_over(moved, time, h)) != after
                    if any(changed[k] for k in found):
                        found.add(entry)
                        grows = True
        return sorted(found)

    # ---- events ------------------------------------------------------------------------------------------------------

    def _moved(self, z: FloatArray, entry: int, e: float) -> FloatArray:
        at = z.copy()
        if entry < self.n:
            increment = np.zeros(self.n)
            increment[entry] = e
            at[: self.n] = self.derivatives.compose(z[: self.n], increment)
        else:
            at[entry] += e
        return at

    def _plus(self, z: FloatArray, entry: int, e: float) -> FloatArray:
        at = z.copy()
        at[entry] += e
        return at

    def _without_corner(self, function: Any, step: float, i: int) -> float:
        """Return the derivative of a switch, with steps that do not reach over a corner, such as of a magnitude."""
        coarse = float(derivative(function, step))
        for _ in range(4):
            fine = float(derivative(function, 0.1 * step))
            noise = 1e-9 * max(abs(function(step)), abs(function(-step))) / step
            if abs(fine - coarse) <= 1e-6 * abs(fine) + noise:
                return coarse
            step *= 0.03
            coarse = float(derivative(function, step))
        raise NotDifferentiable(
            "its switch has a corner",
            item=name_of(self.parameters.base.mbs, self.steps.events[i]),
            time=float(self.times[i]),
            advice=INSTEAD,
        )

    def switch_gradient(self, i: int) -> tuple[FloatArray, float, FloatArray, FloatArray]:
        """Return derivatives of the switch of an event by the state, time, tracked data, and parameters."""
        number, z, time, h = self.steps.events[i].number, self.end(i), float(self.times[i]), float(self.steps.sizes[i])

        def value(at: FloatArray, when: float = time) -> float:
            return float(self.derivatives.switches(at, when, h)[number][0])

        by_state = np.array(
            [
                self._without_corner(lambda e, k=k: value(self._moved(z, k, e)), float(self.typical[k]), i)
                for k in range(self.count)
            ]
        )
        by_time = float(derivative(lambda e: value(z, time + e), self.steps.regular * SMALL))
        by_data = np.zeros(len(self.tracked))
        for row, entry in enumerate(self.tracked):
            at = float(z[self.count + entry])
            if at != 0:
                by_data[row] = self._without_corner(
                    lambda e, k=self.count + entry: value(self._plus(z, k, e)),
                    OF_DATA * abs(at),
                    i,
                )
        by_parameters = np.zeros(len(self.parameters.all))
        for group in self.parameters.groups:
            evaluate = weighted(lambda v: v.derivatives.switches(self.parameters.shifted(v, z), time, h)[number][0])
            total = float(evaluate(group))
            if total == 0:
                continue
            k = self._concerned(group, self.steps.events[i].item)
            by_parameters[k] = total / self.parameters.steps[k]
        return by_state, by_time, by_data, by_parameters

    def _concerned(self, group: Any, item: int) -> int:
        """Return the parameter of a group that acts on an object; its parameters have no common equations."""
        if len(group.members) == 1:
            return int(group.members[0])
        own = self.parameters.structure.of_object(item)
        found = [k for k in group.members if own & set(np.asarray(self.parameters.rows[k]).tolist())]
        if len(found) != 1:
            raise NotDifferentiable(
                "a parameter moves the event, and it is not clear which one",
                item=describe(self.parameters.base.mbs, _core.ObjectIndex(item)),
                advice="differentiate by one parameter at a time",
            )
        return int(found[0])

    def data_gradient(self, i: int) -> tuple[FloatArray, FloatArray, FloatArray] | None:
        """Return derivatives of tracked data after a step by the state, by tracked data before, and by parameters."""
        if not self.tracked:
            return None
        z, time, h = self.end(i), float(self.times[i]), float(self.steps.sizes[i])
        tracked = np.array(self.tracked)
        before, after = z[self.count :][tracked], self.data(i)[tracked]
        if np.all(before == after):
            return None
        event = self.steps.events.get(i)
        by_switch = self.switch_gradient(i)[0] if event is not None else np.zeros(self.count)

        def data(at: FloatArray) -> FloatArray:
            return np.asarray(self.derivatives.switch_over(at, time, h))[tracked]

        by_state = np.zeros((len(tracked), self.count))
        for k in range(self.count):
            size = float(self.typical[k]) * SMALL
            side = -np.sign(by_switch[k])
            formula = CENTRAL if side == 0 else FORWARD  # on the side where the item has switched
            by_state[:, k] = self._smooth(
                {
                    multiple * (side or 1.0): data(self._moved(z, k, multiple * (side or 1.0) * size))
                    for multiple in formula
                },
                {multiple * (side or 1.0): weight * (side or 1.0) for multiple, weight in formula.items()},
                size,
                after,
                time,
            )
        by_data = np.array([self._along_data(data, z, entry) for entry in self.tracked]).T
        by_parameters = np.zeros((len(tracked), len(self.parameters.all)))

        def at_variant(variant: Variant) -> FloatArray:
            return np.asarray(variant.derivatives.switch_over(self.parameters.shifted(variant, z), time, h))[tracked]

        for group in self.parameters.groups:
            values = {multiple: at_variant(group.variants[multiple]) for multiple in group.formula}
            total = self._smooth(values, group.formula, 1.0, after, time)
            if np.any(total != 0):
                k = self._concerned(group, event.item if event is not None else -1)
                by_parameters[:, k] = total / self.parameters.steps[k]
        return by_state, by_data, by_parameters

    def _smooth(
        self, values: dict[Any, FloatArray], formula: dict[Any, float], size: float, middle: FloatArray, time: float
    ) -> FloatArray:
        """Return differences, and refuse those across a change of the state of the item."""
        # Weights sum up to 0: without the value in the middle, what does not change has no rounding errors.
        slope = np.asarray(sum(weight * (values[multiple] - middle) for multiple, weight in formula.items()))
        for multiple, value in values.items():
            off = np.abs(value - middle - float(multiple) * slope)
            if np.any(off > 0.1 * np.abs(float(multiple) * slope) + 1e-9 * (np.abs(middle) + np.abs(value)) + 1e-300):
                raise NotDifferentiable(
                    "data coordinates change without an event, or at a corner",
                    item="time integration",
                    time=time,
                    advice=INSTEAD,
                )
        return slope / size

    # ---- forwards ----------------------------------------------------------------------------------------------------

    def _start(self, i: int, change: Moving) -> Variation:
        """Return the variation at the start of a step of fixed size, with what has moved to this size."""
        ratio, s = float(self.steps.ratios[i]), change.state
        if i in self.steps.moved:
            with of_accelerations(*self.parameters.systems):
                projected = self.steps.moved[i].vary(self, s.q, s.q, s.v)
            v = ratio**2 * s.v + (1 - ratio**2) * projected - np.outer(change.h * ratio, self._v_slope(i))
            s = replace(s, v=v)
        if (ratio in (0.0, 1.0) and not np.any(change.h)) or ratio == 0.0 or self.scheme.newmark:
            return s
        slope = self._b_slope(i)
        b = (1 - ratio) * s.a + ratio * s.b - np.outer(change.h * ratio, slope)
        return replace(s, b=b)

    def _v_slope(self, i: int) -> FloatArray:
        """Return the derivative of moved velocities by the size of a step."""
        moved = self.steps.moved[i]
        return np.asarray(2 * self.steps.ratios[i] ** 2 / self.steps.sizes[i] * (moved.before - moved.after))

    def _b_slope(self, i: int) -> FloatArray:
        """Return the derivative of moved algorithmic accelerations by the size of a step."""
        ratio = float(self.steps.ratios[i])
        if ratio == 0.0 or self.scheme.newmark:
            return np.zeros(self.n)
        return np.asarray((self.steps.b[i] - self.steps.a[i]) / self.steps.sizes[i])

    def response_to_size(self, step: LinearStep, i: int, rates: tuple[FloatArray, FloatArray]) -> Moving:
        """Return the variation of the end by the size of the step."""
        start = Variation.zeros(1, self.n, self.n1, self.m)
        start.b[0] = self._b_slope(i)
        if i in self.steps.moved:
            start.v[0] = self._v_slope(i)
        before, n, n1 = self.states[i - 1], self.n, self.n1
        state = step.forward_by_size(
            start,
            (rates[0] + rates[1])[None],
            self.velocity_before(i),
            self.steps.a[i],
            self.steps.b[i],
            self.states[i][2 * n : 3 * n],
            before[3 * n + n1 : 3 * n + 2 * n1],
            self.states[i][3 * n + n1 : 3 * n + 2 * n1],
        )
        found = Moving.of(state, self.nd and len(self.tracked))
        found.t[0] = found.h[0] = 1.0
        return found

    def forward(self, change: Moving) -> Iterator[tuple[int, Moving]]:
        """Yield variations at the ends of all steps; those of a start come first."""
        yield 0, change
        end_time = self.end_time
        for i in range(1, len(self.times)):
            is_fixed = self.ends_at_fixed_time(i)
            sized = i in self.steps.events or end_time is not None or is_fixed
            fixed, size = self.fixed_and_size(i, change, sized)
            by = np.zeros_like(change.t)
            if size is None:
                pass
            elif i in self.steps.events:
                by_state, by_time, by_data, by_parameters = self.switch_gradient(i)
                rate = self._switch_rate(i, by_state, by_time, size)
                by = -(fixed.state.z @ by_state + fixed.t * by_time + change.data @ by_data + by_parameters) / rate
            elif is_fixed:
                by = -change.t
                if end_time is not None:
                    by[end_time] += self._part_of_time(i)
            elif end_time is not None:
                by[end_time] = self._part(i)
            change = fixed.plus(by, size) if size is not None else fixed
            gradient = self.data_gradient(i)
            if gradient is not None:
                self._check_zero_data(i, change.data)
                change.data = change.state.z @ gradient[0].T + change.data @ gradient[1].T + gradient[2].T
            yield i, change
            if i in self.steps.events:
                change = self.renewed(i, change)

    def ends_at_fixed_time(self, i: int) -> bool:
        """Return whether a step that ends at no event ends at a fixed part of the duration, whenever it begins.

        The last step does, and prescribed steps after events.
        """
        if i in self.steps.events:
            return False
        if i == len(self.times) - 1:
            return bool(self.steps.events) or not self.steps.is_regular(i)
        return self.steps.prescribed and i - 1 in self.steps.events

    def _part_of_time(self, i: int) -> float:
        """Return the derivative of the end of a step by the end of the solution."""
        return float((self.times[i] - self.times[0]) / (self.times[-1] - self.times[0]))

    def fixed_and_size(self, i: int, change: Moving, sized: bool) -> tuple[Moving, Moving | None]:
        """Return the variation at the end of a step of fixed size, and, if wanted, that by the size of the step."""
        start, parameters = self._start(i, change), self.parameters  # before the factors of the step
        step = self.linear_step(i, False)
        z, time, h = self.end(i), float(self.times[i]), float(self.steps.sizes[i])
        rates = self.residual_rates(i)
        right = parameters.rates(parameters.residual_at(z, time, h)) + np.outer(change.t, rates[0])
        if self.tracked:
            right += change.data @ self.by_data(i)
        state = step.forward(start, right)
        fixed = Moving(state, change.t.copy(), np.zeros_like(change.t), change.data)
        return fixed, self.response_to_size(step, i, rates) if sized else None

    def size_alone(self, i: int) -> Moving:
        """Return the variation at the end of a step by its size."""
        return self.response_to_size(self.linear_step(i, False), i, self.residual_rates(i))

    def _part(self, i: int) -> float:
        """Return the derivative of the size of a step by the end, of which it is a constant part."""
        return float(self.steps.sizes[i]) / float(self.times[-1] - self.times[0])

    def _check_zero_data(self, i: int, change: FloatArray) -> None:
        before = self.data(i - 1)[self.tracked]
        if np.any((before == 0) & np.any(change != 0, axis=0)):
            raise NotDifferentiable("data coordinates pass zero", item="time integration", time=float(self.times[i]))

    def _switch_rate(self, i: int, by_state: FloatArray, by_time: float, size: Moving) -> float:
        rate, n, largest = float(size.state.z[0] @ by_state) + by_time, self.n, self.states.largest
        terms = float(np.abs(by_state[: 2 * n]) @ largest[n : 3 * n]) + abs(by_time)  # with the largest rates of all
        if abs(rate) <= _GRAZES * max(terms, 1e-300):
            raise NotDifferentiable(
                f"its switch grazes zero (rate {rate:.1e})",
                item=name_of(self.parameters.base.mbs, self.steps.events[i]),
                time=float(self.times[i]),
                advice="derivatives do not exist there",
            )
        return rate

    def renewed(self, i: int, change: Moving) -> Moving:
        """Return the variation after an event: accelerations follow from positions, velocities and data."""
        s, time, h = change.state, float(self.times[i]), float(self.steps.sizes[i])
        with of_accelerations(*self.parameters.systems):
            if i in self.steps.restarts:
                return self.steps.restarts[i].vary(self, change)
            a, _ = self.vary_accelerations(self._after(i), time, h, s.q, s.v, s.y, change.t, change.data)
        return replace(change, state=replace(s, a=a, b=a.copy()))

    def _after(self, i: int) -> FloatArray:
        z, n = np.array(self.states[i]), self.n
        z[2 * n : 3 * n] = self.steps.a[i + 1] if i + 1 < len(self.times) else 0.0
        z[3 * n + 2 * self.n1 : self.count] = self.steps.multipliers[i]
        return z

    def vary_accelerations(
        self,
        z: FloatArray,
        time: float,
        h: float,
        q: FloatArray,
        v: FloatArray,
        y: FloatArray,
        t: FloatArray,
        data: FloatArray,
    ) -> tuple[FloatArray, FloatArray]:
        """Return variations of the accelerations that the equations of motion have at a state, and of rates of y."""
        d, n, n1 = self.derivatives, self.n, self.n1
        by_time = derivative(lambda e: d.residual(z, time + e, h), self.steps.regular * SMALL)
        rates = self.parameters.rates(self.parameters.residual_at(z, time, h)) + np.outer(t, by_time)
        if self.tracked:
            rates += data @ self._by_data_at(z, time, h)
        d.linearize(z, time, h)
        padded = np.hstack((q, y, np.zeros((len(q), self.m))))
        rates = np.asarray(rates + d.product("K", padded) + d.product("D", v))
        return over_mass(d, z, time, h, rates)[:, :n], rates[:, n : n + n1]

    # ---- backwards ---------------------------------------------------------------------------------------------------

    def backward(self, bar: Moving, matrix: FloatArray, add_seeds: Any) -> Moving:
        """Return derivatives with respect to the start; add those with respect to parameters to the matrix."""
        end_time = self.end_time
        for i in range(len(self.times) - 1, 0, -1):
            last = i == len(self.times) - 1
            if i in self.steps.events and not last:
                self.renew_back(i, bar, matrix)
            add_seeds(i, bar, matrix)
            gradient = self.data_gradient(i)
            if gradient is not None:
                self._add_state(bar, bar.data @ gradient[0])
                matrix += bar.data @ gradient[2]
                bar.data = bar.data @ gradient[1]
            event, ends = i in self.steps.events, self.ends_at_fixed_time(i)
            follows = end_time is not None
            of_start = np.zeros_like(bar.t)
            if event or ends or follows:
                size = self.size_alone(i)
                by_size = bar.dot(size)
                if event:
                    by_state, by_time, by_data, by_parameters = self.switch_gradient(i)
                    factor = -by_size / self._switch_rate(i, by_state, by_time, size)
                    self._add_state(bar, np.outer(factor, by_state))
                    bar.t = bar.t + factor * by_time
                    if self.tracked:
                        bar.data = bar.data + np.outer(factor, by_data)
                    matrix += np.outer(factor, by_parameters)
                elif ends:
                    of_start = -by_size
                    if end_time is not None:
                        matrix[:, end_time] += by_size * self._part_of_time(i)
                else:
                    matrix[:, end_time] += by_size * self._part(i)
            bar = self.step_back(i, bar, matrix)
            bar.t = bar.t + of_start
        return bar

    def step_back(self, i: int, bar: Moving, matrix: FloatArray) -> Moving:
        """Return derivatives with respect to the start of a step of fixed size."""
        parameters, rates = self.parameters, self.residual_rates(i)
        z, time, h = self.end(i), float(self.times[i]), float(self.steps.sizes[i])
        start, w = self.linear_step(i, True).backward(bar.state)
        matrix -= parameters.weighted_rates(parameters.residual_at(z, time, h), w)
        t = bar.t - w @ rates[0]
        data = bar.data - w @ self.by_data(i).T if self.tracked else bar.data
        size_before = np.zeros_like(t)
        ratio = float(self.steps.ratios[i])
        if ratio != 0.0 and not self.scheme.newmark:
            size_before = -(start.b @ self._b_slope(i)) * ratio
            start = replace(start, a=start.a + (1 - ratio) * start.b, b=ratio * start.b)
        if i in self.steps.moved:
            size_before = size_before - (start.v @ self._v_slope(i)) * ratio
            with of_accelerations(*parameters.systems):
                forces_q, q, v = self.steps.moved[i].back(self, (1 - ratio**2) * start.v, matrix)
            start = replace(start, q=start.q + forces_q + q, v=ratio**2 * start.v + v)
        return Moving(start, t, size_before, data)

    def _add_state(self, bar: Moving, z: FloatArray) -> None:
        for row, values in enumerate(z):
            bar.state.add(row, values)

    def renew_back(self, i: int, bar: Moving, matrix: FloatArray) -> None:
        s, time, h = bar.state, float(self.times[i]), float(self.steps.sizes[i])
        with of_accelerations(*self.parameters.systems):
            if i in self.steps.restarts:
                return self.steps.restarts[i].back(self, bar, matrix)
            by = self.accelerations_back(self._after(i), time, h, s.a + s.b, None, matrix)
        zero = np.zeros_like(s.a)
        bar.state = replace(s, q=s.q + by.q, v=s.v + by.v, y=s.y + by.y, a=zero, b=zero)
        bar.t, bar.data = bar.t + by.t, bar.data + by.data
        return None

    def accelerations_back(
        self, z: FloatArray, time: float, h: float, a: FloatArray, y_t: FloatArray | None, matrix: FloatArray
    ) -> AtState:
        """Return derivatives with respect to a state from those with respect to its accelerations and rates of y."""
        d, n, n1 = self.derivatives, self.n, self.n1
        factorize_mass(d, z, time, h, True)
        w = np.asarray(d.solve(np.hstack((a, np.zeros((len(a), n1 + self.m))))))
        w[:, n : n + n1] = 0.0 if y_t is None else -y_t
        by_k, by_v = np.asarray(d.product("K", w, transposed=True)), d.product("D", w, transposed=True)
        by_time = derivative(lambda e: d.residual(z, time + e, h), self.steps.regular * SMALL)
        by_data = w @ self._by_data_at(z, time, h).T if self.tracked else np.zeros((len(w), 0))
        matrix -= self.parameters.weighted_rates(self.parameters.residual_at(z, time, h), w)
        return AtState(-by_k[:, :n], -np.asarray(by_v), -by_k[:, n : n + n1], -np.asarray(w @ by_time), -by_data)
