"""Kinetic and potential energy of a system, and the power that goes in and out of it.

Potential energy is the work of all forces but those of velocities, on a path from the reference configuration:
rotations are about fixed axes, all other coordinates are linear. If forces have a potential, the path does not matter.
"""

from __future__ import annotations

import warnings
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from typing import Any, NamedTuple

import numpy as np

from dalembert._checks import FloatArray, IntArray
from dalembert._core import ConfigurationType, OutputVariableType, testing
from dalembert._solving.consistent import _Nodes
from dalembert._solving.half_turns import objects_of_types
from dalembert._solving.quiet import assemble_if_needed

_NAME = "ComputeEnergies"
_POINTS = 6  # Gauss points per part of the path
_MOST_PARTS = 64
_TOLERANCE = 1e-12  # tolerance of the work, relative to the sum of its magnitudes


class Energies(NamedTuple):
    """Energies in J and powers in W, of a configuration.

    kinetic, kineticPerNode: of velocities, and the share of each node, by node number.
    potential: work that weight, loads, springs and bodies have stored since the reference configuration.
    total: kinetic + potential; constant as long as no power goes in or out.
    dissipatedPower: taken out by forces that depend on velocities, such as those of dampers.
    potentialError: difference between the last two refinements of the path; large if forces jump.
    """

    kinetic: float
    potential: float
    total: float
    dissipatedPower: float
    potentialError: float
    kineticPerNode: dict[int, float]


class _Path:
    """Path from the reference configuration to a state: coordinates and their derivatives at s in [0, 1]."""

    def __init__(self, mbs: Any, q: FloatArray) -> None:
        nodes = _Nodes(mbs, [], [])
        self.q, self.lie, self.units = q, nodes.lie, nodes.units
        self.reference = np.array(mbs.systemData.GetODE2Coordinates(ConfigurationType.Reference))
        self.start = self.reference[self.units]
        end = (q + self.reference)[self.units]
        self.end = end * np.where(np.sum(self.start * end, axis=1, keepdims=True) < 0, -1, 1)  # the shorter way
        cosines = np.sum(self.start * self.end, axis=1, keepdims=True)
        self.angles = np.arctan2(np.linalg.norm(self.end - cosines * self.start, axis=1, keepdims=True), cosines)
        # Euler parameters are as far from each other as half of the angle between them.

    def at(self, s: float) -> tuple[FloatArray, FloatArray]:
        """Return displacements, and their derivative by s; that of Lie-group nodes is a spin in local axes."""
        q, rate = s * self.q, self.q.copy()
        sine = np.sin(self.angles)
        small = sine < 1e-9
        sine = np.where(small, 1.0, sine)
        first = np.where(small, 1 - s, np.sin((1 - s) * self.angles) / sine)
        last = np.where(small, s, np.sin(s * self.angles) / sine)
        q[self.units] = first * self.start + last * self.end - self.start
        first_rate = np.where(small, -1.0, -self.angles * np.cos((1 - s) * self.angles) / sine)
        last_rate = np.where(small, 1.0, self.angles * np.cos(s * self.angles) / sine)
        rate[self.units] = first_rate * self.start + last_rate * self.end
        for block in self.lie:
            rate[block] = _tangent_operator(self.reference[block] + q[block]) @ self.q[block]
        return q, rate


def TotalMass(mbs: Any) -> float:
    """Return the mass (kg) of all that stands on nodes with a position: twice its kinetic energy at 1 m/s along x."""
    data, state = mbs.systemData, testing.State(mbs)
    along_x = np.zeros(len(state.q))
    for node in range(data.NumberOfNodes()):
        numbers = data.GetNodeLTGODE2(node)
        try:
            mbs.GetNodeOutput(node, OutputVariableType.Velocity)
        except ValueError:
            continue
        if len(numbers) > 1:
            along_x[numbers[0]] = 1
    rows, columns, values = testing.mass_entries(mbs, state)
    return float(np.sum(along_x[rows] * values * along_x[columns]))


def _tangent_operator(turn: FloatArray) -> FloatArray:
    """Return the matrix from rates of a rotation vector to the spin in axes of the body."""
    angle = float(np.linalg.norm(turn))
    x, y, z = turn
    skew = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    if angle < 1e-4:
        return np.eye(3) - skew / 2 + skew @ skew / 6
    return np.eye(3) - (1 - np.cos(angle)) / angle**2 * skew + (angle - np.sin(angle)) / angle**3 * skew @ skew


class MovingSystem:
    """Forces and masses of a system in states at rest and in motion."""

    def __init__(self, mbs: Any, configuration: ConfigurationType) -> None:
        data, self.configuration = mbs.systemData, configuration
        self.mbs, self.state = mbs, testing.State(mbs)
        self.state.q = data.GetODE2Coordinates(configuration)
        self.state.v = data.GetODE2Coordinates_t(configuration)
        self.state.y, self.state.data = data.GetODE1Coordinates(configuration), data.GetDataCoordinates(configuration)
        self.state.t = data.GetTime(configuration)
        self.state.lam, self.state.a = np.zeros_like(self.state.lam), np.zeros_like(self.state.a)

    def forces(self, q: FloatArray, v: FloatArray) -> FloatArray:
        state = self.state.copy()
        state.q, state.v = q, v
        return np.asarray(testing.forces(self.mbs, state))

    def momentum(self, q: FloatArray, v: FloatArray) -> FloatArray:
        state = self.state.copy()
        state.q = q
        rows, columns, values = testing.mass_entries(self.mbs, state)
        return np.asarray(np.bincount(rows, weights=values * v[columns], minlength=len(q)), dtype=float)

    def work(self, path: _Path) -> tuple[float, float]:
        """Return the work of forces along the path and its error."""
        points, weights = np.polynomial.legendre.leggauss(_POINTS)
        parts, before = 2, np.nan
        while True:
            work = size = 0.0
            state = self.state.copy()
            state.v = np.zeros_like(state.v)
            for part in range(parts):
                for point, weight in zip(points, weights, strict=True):
                    state.q, rate = path.at((part + (point + 1) / 2) / parts)
                    testing.switch_over(self.mbs, state)  # contacts that are open on this part of the path
                    power = np.asarray(testing.forces(self.mbs, state)) * rate * weight / (2 * parts)
                    work += float(power.sum())
                    size += float(np.abs(power).sum())
            error = abs(work - before)
            if error <= _TOLERANCE * size or parts >= _MOST_PARTS or not np.isfinite(work):
                return work, error
            before, parts = work, 2 * parts

    def stored_by_turns(self) -> dict[int, float]:
        """Return the potential energy of connectors that count turns, which the path does not have, by number.

        These are torsional springs that are turned by more than half a turn, and ropes that pulleys take up.
        """
        mbs, angle = self.mbs, OutputVariableType.Rotation
        turned = bool((np.abs(self.state.data) > np.pi).any())
        stored = {}
        for i in objects_of_types(mbs, ("ConnectorTorsionalSpringDamper", "ConnectorReevingSystemSprings")):
            item = mbs.GetObject(i)
            if turned and item["objectType"] == "ConnectorTorsionalSpringDamper" and item["activeConnector"]:
                at_rest = float(mbs.GetObjectOutput(i, angle, ConfigurationType.Reference))
                end = float(mbs.GetObjectOutput(i, angle, self.configuration))
                if abs(end) > np.pi:
                    start = float(np.remainder(at_rest + np.pi, 2 * np.pi) - np.pi)
                    stored[i] = _stored_by_torque(mbs, i, start, end, self.state.t)
            takes_up = item["objectType"] == "ConnectorReevingSystemSprings" and item["hasCoordinateMarkers"]
            if takes_up and item["activeConnector"]:
                configurations = (self.configuration, ConfigurationType.Reference)
                now, at_rest = (_stored_by_rope(mbs, i, item, each) for each in configurations)
                stored[i] = now - at_rest
        return stored

    def rows_with_history(self) -> IntArray:
        """Return the rows whose forces in the reference configuration depend on the past, such as the sticking point of
        friction: the work on the path is no energy that these forces have stored."""
        state = self.state.copy()
        state.q, state.v = np.zeros_like(state.q), np.zeros_like(state.v)
        forces = []
        for data in (state.data, self.mbs.systemData.GetDataCoordinates(ConfigurationType.Initial)):
            state.data = data
            testing.switch_over(self.mbs, state)
            forces.append(np.asarray(testing.forces(self.mbs, state)))
        change = np.abs(forces[0] - forces[1])
        return np.flatnonzero(change > _TOLERANCE * np.abs(forces).max(initial=0.0))

    def dissipated_power(self) -> float:
        """Return the power of forces of velocities, without that of inertia: -v (Q(v) - Q(0)) - v M_t v / 2."""
        q, v = np.asarray(self.state.q), np.asarray(self.state.v)
        speed = float(np.abs(v).max(initial=0.0))
        if speed == 0:
            return 0.0
        step = 1e-5 * max(1.0, float(np.abs(q).max(initial=0.0))) / speed
        moved = [np.asarray(testing.compose(self.mbs, self.state, sign * step * v)) for sign in (1, -1)]
        inertia = [v @ self.momentum(x, v) for x in moved]
        power = v @ (self.forces(q, v) - self.forces(q, 0 * v))
        return float(-power - (inertia[0] - inertia[1]) / (4 * step))


def _stored_by_torque(mbs: Any, number: int, start: float, end: float, time: float) -> float:
    """Return the work of a torsional spring against a rotation from one angle to another one."""
    item = mbs.GetObject(number)
    k, d, offset = item["stiffness"], item["damping"], item["offset"]
    function = item["springTorqueUserFunction"]

    def torque(angle: float) -> float:
        if function:
            return float(function(mbs, time, number, angle, 0.0, k, d, offset))
        return float(k * (angle - offset) - d * item["velocityOffset"] + item["torque"])

    points, weights = np.polynomial.legendre.leggauss(_POINTS)
    parts = int(np.ceil(abs(end - start) / np.pi)) * (16 if function else 1)
    half = (end - start) / parts / 2
    places = start + half * (1 + points + 2 * np.arange(parts)[:, None])
    return half * float(sum(weights @ [torque(float(angle)) for angle in row] for row in places))


def _stored_by_rope(mbs: Any, number: int, item: dict[str, Any], configuration: ConfigurationType) -> float:
    """Return the energy of the stretch of a rope whose ends are taken up by two coordinates."""
    own = item["referenceLength"]
    for factor, marker in zip(item["coordinateFactors"], item["markerNumbers"][-2:], strict=True):
        own += factor * float(np.ravel(mbs.GetMarkerOutput(marker, OutputVariableType.Coordinates, configuration))[0])
    stretch = float(mbs.GetObjectOutput(number, OutputVariableType.Distance, configuration)) - own
    k, limit = item["stiffnessPerLength"] * (1 / own if own != 0 else 1e3), item["regularizationForce"]
    if stretch >= 0 or limit < 0 or k == 0:
        return float(k * stretch**2 / 2)
    ratio = k * stretch / limit  # of compression, whose force is limit * tanh(ratio)
    return float(limit**2 / k * (np.logaddexp(ratio, -ratio) - np.log(2)))


@contextmanager
def _inactive(mbs: Any, connectors: Iterable[int]) -> Iterator[None]:
    for number in connectors:
        mbs.SetObjectParameter(number, "activeConnector", False)
    try:
        yield
    finally:
        for number in connectors:
            mbs.SetObjectParameter(number, "activeConnector", True)


def ComputeEnergies(
    mbs: Any, configuration: ConfigurationType = ConfigurationType.Current, autoAssemble: bool = True
) -> Energies:
    """Return kinetic and potential energy of the system, and the power that it dissipates, in a configuration.

    Potential energy is the work since the reference configuration against weight, loads and all forces of connectors
    and bodies, as they are at the time of the configuration: items need no formula of their own. If a force has no
    potential, such as friction or a follower load, the result depends on the path. A warning names forces with a
    history, such as sticking friction.
    """
    assemble_if_needed(_NAME, mbs, autoAssemble)
    return energies_of(MovingSystem(mbs, configuration))


def energies_of(system: MovingSystem) -> Energies:
    """Return the energies of a system in the state that it holds."""
    stored = system.stored_by_turns()
    power = system.dissipated_power()
    with _inactive(system.mbs, stored):
        return _energies_on_path(system, sum(stored.values()), power)


def _energies_on_path(system: MovingSystem, stored: float, power: float) -> Energies:
    mbs = system.mbs
    q, v = np.asarray(system.state.q), np.asarray(system.state.v)
    shares = v * system.momentum(q, v) / 2
    per_node = {}
    for node in range(mbs.systemData.NumberOfNodes()):
        if numbers := mbs.systemData.GetNodeLTGODE2(node):
            per_node[node] = float(shares[numbers].sum())
    if len(rows := system.rows_with_history()):
        warnings.warn(
            f"{_NAME}: forces on {testing.describe_row(mbs, int(rows[0]))} depend on the past, such as those of "
            "sticking friction or plastic springs. Their work is counted as potential energy, which it is not",
            RuntimeWarning,
            stacklevel=4,
        )
    work, error = system.work(_Path(mbs, q))
    kinetic, potential = float(shares.sum()), stored - work
    return Energies(kinetic, potential, kinetic + potential, power, error, per_node)
