"""Positions and velocities at the start that fulfil all constraints."""

# ruff: noqa: B006  (empty lists as defaults; they are never written to)
from __future__ import annotations

import warnings
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from dalembert._checks import FloatArray, IntArray
from dalembert._core import ConfigurationType, SimulationSettings, testing
from dalembert._solving.diagnosis import listed
from dalembert._solving.half_turns import warn_of_half_turns
from dalembert._solving.projection import REGULAR, SMALLER, SMALLEST, LinearizedConstraints, weights
from dalembert._solving.quiet import assemble_if_needed, given_or_default

_NAME = "ComputeConsistentInitialConditions"
_ROUND_OFF = 1e-10  # gaps of this size, relative to that of mechanisms, are accepted where nothing makes them smaller
_LARGEST_TURN = 1.0  # rad in one step
_CONTRADICTING_SHARE = 0.5  # relative size of a gap that no motion closes
_LEFT_BY_GAPS, _NOTICEABLE = 1e5, 1e-3  # eps for steps, relative to the square of gaps, and at most
_CLOSE_JOINTS = 10  # the size of mechanisms, in distances of joints that turn each other when they do not fit


@dataclass(frozen=True)
class ConsistentInitialConditions:
    """Results of ComputeConsistentInitialConditions.

    positionGaps, velocityGaps: the largest gap (m, rad) and rate of a gap (m/s, rad/s) before and after.
    contradictions: violated constraints of the initial values, one text per equation, the worst first.
    iterations: steps that closed the gaps of positions.
    equations: number of constraint equations; redundantEquations: number of redundant ones at the new positions.
    displacements, velocityChanges: the largest change of a coordinate of each node that was changed, by node number.
    """

    positionGaps: tuple[float, float]
    velocityGaps: tuple[float, float]
    contradictions: list[str]
    iterations: int
    equations: int
    redundantEquations: int
    displacements: dict[int, float]
    velocityChanges: dict[int, float]

    def __str__(self) -> str:
        def change(values: dict[int, float]) -> str:
            node = max(values, key=lambda n: values[n], default=None)
            return "none" if node is None else f"{len(values)} nodes, node {node} the most, by {values[node]:.3g}"

        lines = [
            "positions: largest gap {:.3g}, was {:.3g}; moved: ".format(*reversed(self.positionGaps))
            + change(self.displacements),
            "velocities: largest rate of a gap {:.3g}, was {:.3g}; changed: ".format(*reversed(self.velocityGaps))
            + change(self.velocityChanges),
            f"{self.equations} equations, {self.redundantEquations} of them redundant; {self.iterations} iterations",
        ]
        return "\n".join(lines)


class _Nodes:
    """Masks of rotation coordinates that are not additive, and of fixed coordinates."""

    def __init__(self, mbs: Any, fixedCoordinates: Sequence[int], fixedNodes: Sequence[Any]) -> None:
        self.coordinates: dict[int, list[int]] = {}
        turning: dict[str, list[list[int]]] = {"RigidBodyEP": [], "RigidBodyRotVecLG": []}
        for node in range(mbs.systemData.NumberOfNodes()):
            numbers = mbs.systemData.GetNodeLTGODE2(node)
            if numbers:
                self.coordinates[node] = numbers
                turning.get(mbs.GetNode(node)["nodeType"], []).append(numbers[3:])
        self.held = np.zeros(len(mbs.systemData.GetODE2Coordinates()))
        for node in fixedNodes:
            self.held[mbs.systemData.GetNodeLTGODE2(node)] = 1
        for i in fixedCoordinates:
            if not 0 <= i < len(self.held):
                raise ValueError(
                    f"{_NAME}: fixedCoordinates: expected ODE2 indices below {len(self.held)}, received {i}"
                )
            self.held[i] = 1
        lie = np.array(turning["RigidBodyRotVecLG"], dtype=int).reshape(-1, 3)
        parts = lie[~np.isin(self.held[lie].sum(axis=1), (0, 3))]
        if len(parts):
            raise ValueError(
                f"{_NAME}: fixedCoordinates: received a part of {parts[0].tolist()}, the rotation vector of a Lie "
                "group node; expected all of its components, or none: they do not change one by one"
            )
        units = np.array(turning["RigidBodyEP"], dtype=int).reshape(-1, 4)
        self.units: IntArray = units[self.held[units].sum(axis=1) == 0]
        self.lie: IntArray = lie

    def largest_turn(self, increment: FloatArray) -> float:
        """Return the largest angle by which a body turns, in rad."""
        turns = [np.linalg.norm(increment[self.lie], axis=1), 2 * np.linalg.norm(increment[self.units], axis=1)]
        return float(np.concatenate(turns).max(initial=0.0))

    def normalized(self, q: FloatArray, reference: FloatArray) -> FloatArray:
        """Return coordinates with Euler parameters of unit length."""
        units = (q + reference)[self.units]
        lengths = np.linalg.norm(units, axis=1, keepdims=True)
        result = q.copy()
        result[self.units] = np.where(lengths == 1, q[self.units], units / lengths - reference[self.units])
        return result

    def moved(self, mbs: Any, state: Any, increment: FloatArray, reference: FloatArray) -> FloatArray:
        """Return coordinates after an increment; rotations go along great circles, whichever their parameters are."""
        q = np.asarray(testing.compose(mbs, state, increment))
        units, steps = (state.q + reference)[self.units], increment[self.units]
        steps = steps - np.sum(steps * units, axis=1, keepdims=True) * units
        angles = np.linalg.norm(steps, axis=1, keepdims=True)
        turned = np.cos(angles) * units + np.sinc(angles / np.pi) * steps
        q[self.units] = np.where(angles == 0, state.q[self.units], turned - reference[self.units])
        q[self.held == 1] = state.q[self.held == 1]
        return q

    def changes(self, change: FloatArray) -> dict[int, float]:
        """Return the largest change among the coordinates of each node that was changed."""
        found = {node: float(np.abs(change[numbers]).max()) for node, numbers in self.coordinates.items()}
        return {node: value for node, value in found.items() if value > 0}


class _Projection:
    """A state that is moved onto the constraints."""

    def __init__(self, mbs: Any, nodes: _Nodes, time: float | None, tolerance: float, misfit: float) -> None:
        data, initial = mbs.systemData, ConfigurationType.Initial
        self.mbs, self.nodes = mbs, nodes
        self.reference = np.array(data.GetODE2Coordinates(ConfigurationType.Reference))
        self.state = testing.State(mbs)
        self.state.q, self.state.v = data.GetODE2Coordinates(initial), data.GetODE2Coordinates_t(initial)
        self.state.y, self.state.data = data.GetODE1Coordinates(initial), data.GetDataCoordinates(initial)
        self.state.lam = np.zeros_like(self.state.lam)
        self.state.t = data.GetTime(initial) if time is None else time
        self.of_velocities = testing.constraint_rates(mbs, self.state)[2] == 1
        self.misfit = misfit  # tolerated inconsistency of redundant joints, relative to the size of the model
        self.contradicts = False  # whether some do
        self.apart = 0.0  # remaining inconsistency
        self.units = testing.constraint_metric(mbs, self.state)[1]  # of gaps: sizes of mechanisms, radians
        self.tolerance = tolerance
        self.round_off = max(tolerance, _ROUND_OFF)

    def size(self, gaps: FloatArray) -> float:
        """Return the largest of gaps, or of their rates, in units of their equations."""
        return _largest(gaps / self.units)

    def gaps(self, q: FloatArray | None = None) -> FloatArray:
        """Return the gaps of positions; zeros for equations of velocities."""
        state = self.state
        if q is not None:
            state = state.copy()
            state.q = q
        return np.where(self.of_velocities, 0.0, testing.gaps(self.mbs, state))

    def rates(self) -> FloatArray:
        return np.asarray(testing.constraint_rates(self.mbs, self.state)[0])

    def linearized(self, rate_level: bool, held: FloatArray | None = None) -> LinearizedConstraints:
        from scipy.sparse import coo_array

        size, equations = len(self.state.q), len(self.of_velocities)
        first = size + len(self.state.y)
        state = self.state.copy()
        state.rate_level = rate_level
        rows, columns, values = testing.tangent_entries(self.mbs, state, cq=1 - rate_level, cv=float(rate_level))
        wanted = (rows >= first) & (columns < size)
        if not rate_level:
            wanted &= ~self.of_velocities[np.maximum(rows - first, 0)]
        gradient = coo_array((values[wanted], (rows[wanted] - first, columns[wanted])), shape=(equations, size))
        rows, columns, values = testing.mass_entries(self.mbs, state)
        mass = coo_array((values, (rows, columns)), shape=(size, size))
        # Inconsistent redundant joints share the remaining gap, as in solvers.
        shares = testing.constraint_metric(self.mbs, state)[0] if self.contradicts else np.zeros(equations)
        return LinearizedConstraints(weights(mass), gradient.tocsr(), self.nodes.held if held is None else held, shares)

    def close_gaps(self, maxIterations: int) -> int:
        """Move positions until all gaps are closed; return the number of steps."""
        if self.size(self.gaps()) <= self.tolerance:
            return 0
        self.state.q = start = self.nodes.normalized(self.state.q, self.reference)
        iterations, is_smallest = self._close(maxIterations)
        if is_smallest and self._contradict_each_other_a_little():
            self.state.q, self.contradicts = start, True
            iterations, is_smallest = self._close(maxIterations)
            is_smallest = is_smallest and self._contradict_each_other_a_little()
            self.apart = self.size(self.gaps())
        if self.size(self.gaps()) > self.round_off and not (self.contradicts and is_smallest):
            raise ValueError(self._refusal("positions", rates=False))
        return iterations

    def _close(self, maxIterations: int) -> tuple[int, bool]:
        """Make gaps smaller; return the number of steps, and whether nothing makes gaps smaller that are open."""
        gaps, damping, scale = self.gaps(), 0.0, None
        for iteration in range(maxIterations):
            if self.size(gaps) <= self.tolerance:
                return iteration, False
            constraints = self.linearized(rate_level=False)
            if scale is None:  # scale of all steps, which are compared
                scale = constraints.scale
            moved = self._better(constraints, self._closable(constraints, gaps), scale, damping)
            if moved is None:
                return iteration + 1, self.size(gaps) > self.round_off
            self.state.q, gaps, damping = moved
        return maxIterations, False

    def _contradict_each_other_a_little(self) -> bool:
        """Return whether gaps are within the tolerance of solvers and no motion closes them, for any fixed
        coordinates."""
        of_all = self.linearized(rate_level=False, held=np.zeros_like(self.nodes.held))
        return self._is_small() and of_all.left_open(self.gaps())[1] > _CONTRADICTING_SHARE

    def _is_small(self) -> bool:
        return not testing.open_constraints(self.mbs, self.state, self.misfit, 1e-9, False)

    def _closable(self, constraints: LinearizedConstraints, gaps: FloatArray) -> FloatArray:
        """Return gaps without those of joints that contradict each other: steps that close these would go far."""
        if not (self.contradicts and self._is_small()):
            return gaps
        left, share = constraints.left_open(gaps)
        return gaps - left if share > _CONTRADICTING_SHARE else gaps

    def _better(
        self, constraints: LinearizedConstraints, gaps: FloatArray, scale: FloatArray, damping: float
    ) -> tuple[FloatArray, FloatArray, float] | None:
        """Return positions with smaller gaps, their gaps, and the damping of the next step; None if no such positions
        were found."""
        merit = np.linalg.norm(scale * self.gaps())

        def moved(eps: float) -> tuple[float, FloatArray, FloatArray]:
            step = constraints.solver(eps)(-gaps)
            step *= min(1.0, _LARGEST_TURN / max(self.nodes.largest_turn(step), 1e-300))
            q = self.nodes.moved(self.mbs, self.state, step, self.reference)
            after = self.gaps(q)
            return float(np.linalg.norm(scale * after)), q, after

        apart = self._left_by_gaps(self.size(gaps))
        while damping <= 1e4:
            found = moved(max(damping, REGULAR, apart))
            if apart > max(damping, REGULAR) and not found[0] < merit / 2:  # constraints may be as weak
                found = min(found, moved(max(damping, REGULAR)), key=lambda x: x[0])
            if found[0] < (1 - 1e-6) * merit:
                return found[1], found[2], damping / 100
            damping = max(100 * damping, 1e-8)
        return None

    def _left_by_gaps(self, gap: float) -> float:
        """Return eps for joints that are apart.

        Gaps make redundant equations independent, in proportion to their square: inconsistent ones would cause large
        displacements along the motion.
        """
        if not self.contradicts:
            return 0.0
        return float(min(_LEFT_BY_GAPS * gap**2, _NOTICEABLE))

    def project_velocities(self) -> None:
        """Change velocities such that gaps remain constant; later passes remove the remaining error."""
        rates = self.rates()
        if self.size(rates) <= self.tolerance:
            return
        constraints = self.linearized(rate_level=True)
        of_joints_apart = self._left_by_gaps(self.apart)
        for eps in (of_joints_apart,) if of_joints_apart > REGULAR else (REGULAR, SMALLER, SMALLEST):
            rates = self._passes(constraints.solver(eps), rates)
            if self.size(rates) <= self.tolerance:
                return
        rates, speeds, _ = testing.constraint_rates(self.mbs, self.state)
        if (np.abs(rates) > max(self.round_off, _CLOSE_JOINTS * self.apart) * np.maximum(speeds, self.units)).any():
            raise ValueError(self._refusal("velocities", rates=True))

    def _passes(self, solve: Callable[[FloatArray], FloatArray], rates: FloatArray) -> FloatArray:
        """Change velocities as long as rates become much smaller; return the remaining rates."""
        while True:
            before = self.state.v
            v = before + solve(-rates)
            v[self.nodes.held == 1] = before[self.nodes.held == 1]
            self.state.v = v
            after = self.rates()
            if not self.size(after) < self.size(rates) / 2:
                self.state.v = before
                return rates
            rates = after

    def _refusal(self, what: str, rates: bool) -> str:
        return "\n".join(
            [
                f"mbs.{_NAME}: no {what} near the initial values fulfil all constraints; what remains:",
                *listed(self.contradictions(rates)),
                "These constraints contradict each other or what is held, or the initial values are too far away: "
                "correct them, or hold less. The system is as it was.",
            ]
        )

    def warn_of_contradictions(self) -> None:
        """Name the joints that no positions fit."""
        first = f"mbs.{_NAME}: constraints contradict each other; what the closest fit leaves open:"
        warnings.warn("\n".join([first, *listed(self.contradictions(rates=False))]), stacklevel=3)

    def contradictions(self, rates: bool = True) -> list[str]:
        found = testing.open_constraints(self.mbs, self.state, self.tolerance, 1e-9, rates)
        return [text for _, of_rate, _, _, text in found if rates or not of_rate]


def _largest(values: FloatArray) -> float:
    return float(np.abs(values).max(initial=0.0))


def _store(mbs: Any, projection: _Projection, changed: Sequence[int]) -> None:
    """Make the state the initial values of the nodes."""
    for node in changed:
        numbers = projection.nodes.coordinates[node]
        known = mbs.GetNode(node)
        velocities = "initialVelocities" if "initialVelocities" in known else "initialCoordinates_t"
        mbs.SetNodeParameter(node, "initialCoordinates", projection.state.q[numbers].tolist())
        mbs.SetNodeParameter(node, velocities, projection.state.v[numbers].tolist())


def ComputeConsistentInitialConditions(
    mbs: Any,
    simulationSettings: SimulationSettings | None = None,
    positions: bool = True,
    velocities: bool = True,
    fixedCoordinates: Sequence[int] = [],
    fixedNodes: Sequence[Any] = [],
    tolerance: float = 1e-12,
    maxIterations: int = 50,
    storeInNodes: bool = True,
    autoAssemble: bool = True,
) -> ConsistentInitialConditions:
    """Change initial positions and velocities such that all constraints are fulfilled, and return the changes.

    Positions are projected onto the constraints in steps, each of which is the smallest in the metric of the mass
    matrix: heavy bodies move less than light ones. Velocities change once, as in a plastic impact. Coordinates without
    mass are treated as if their mass were 1. Constraints may be redundant; those that contradict each other by no more
    than solvers tolerate (simulationSettings.redundantConstraints.largestMisfit) are fitted as closely as possible,
    with a warning that names them. Initial and current configuration hold the result; accelerations and multipliers
    follow when a solver starts.

    simulationSettings: constraints that change with time are taken at timeIntegration.startTime.
    positions, velocities: flags of the quantities that may change.
    fixedCoordinates, fixedNodes: ODE2 coordinates (global indices) and nodes that keep their exact values.
    tolerance: of the gaps, relative to the size of their mechanism, or in rad.
    storeInNodes: write the result to initialCoordinates and initialVelocities of the nodes; otherwise the next
        mbs.Assemble() restores the previous values.

    ValueError names the constraints that cannot be fulfilled, and their remaining gaps; the system does not change.
    """
    assemble_if_needed(_NAME, mbs, autoAssemble)
    nodes = _Nodes(mbs, fixedCoordinates, fixedNodes)
    given = given_or_default("ComputeConsistentInitialConditions", simulationSettings)
    time = None if simulationSettings is None else given.timeIntegration.startTime
    projection = _Projection(mbs, nodes, time, tolerance, given.redundantConstraints.largestMisfit)
    state = projection.state
    q, v = np.array(state.q), np.array(state.v)
    contradictions = projection.contradictions()
    gap, rate = _largest(projection.gaps()), _largest(projection.rates())
    iterations = projection.close_gaps(maxIterations) if positions else 0
    if velocities:
        projection.project_velocities()
    redundant = testing.redundant_constraints(mbs, state)["count"]
    if projection.apart > 0:
        projection.warn_of_contradictions()
    displacements, velocityChanges = nodes.changes(state.q - q), nodes.changes(state.v - v)
    for configuration in (ConfigurationType.Initial, ConfigurationType.Current):
        mbs.systemData.SetODE2Coordinates(state.q, configuration)
        mbs.systemData.SetODE2Coordinates_t(state.v, configuration)
    warn_of_half_turns(_NAME, mbs, ConfigurationType.Initial, "as found")
    if storeInNodes:
        _store(mbs, projection, sorted(displacements.keys() | velocityChanges.keys()))
    return ConsistentInitialConditions(
        positionGaps=(gap, _largest(projection.gaps())),
        velocityGaps=(rate, _largest(projection.rates())),
        contradictions=contradictions,
        iterations=iterations,
        equations=len(projection.of_velocities),
        redundantEquations=redundant,
        displacements=displacements,
        velocityChanges=velocityChanges,
    )
