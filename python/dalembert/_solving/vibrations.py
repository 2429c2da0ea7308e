"""Small motions about a preloaded or steadily rotating state: complex modes with gyroscopic terms and constraints."""

from __future__ import annotations

import warnings
from dataclasses import dataclass
from typing import Any

import numpy as np

from dalembert._checks import ComplexArray, FloatArray
from dalembert._core import ConfigurationType, SimulationSettings, testing
from dalembert._solving.coordinate_parts import CoordinateParts
from dalembert._solving.diagnosis import SolverError, listed
from dalembert._solving.quiet import assemble_if_needed
from dalembert._solving.reduced_pencil import INFINITE, ReducedPencil, solve_the_equations
from dalembert._solving.rotating_frame import RotatingFrame
from dalembert._solving.sparse_factors import constrained_factors

_NAME = "ComputeVibrationModes"
_DENSE = 250  # numbers of the first order system up to which all eigenvalues are computed
# relative to the largest frequency: rigid-body modes are not singular, and the lowest frequencies come first
_SHIFT = 1e-5
_LEAST_SHIFT = 1e-7  # its square is above round-off, so that rigid-body modes remain regular
_ITERATIONS = 50
_LARGEST_TURN, _LARGEST_MOVE = 0.5, 1.0  # limits of one step of Newton's method: rad, and sizes of the model
_FAR_TURN, _FAR_MOVE = 1.5, 2.0  # limits beyond which an equilibrium counts as far from the initial state
_SHORTER_STEPS = 8  # tries with more inertia until a step is short enough
_BALANCE = 1e-10  # residual, relative to the largest one that Newton's method has met
_CLOSED, _NOTICEABLE = 1e-11, 1e-10  # gaps of joints, relative to the size of their mechanism, or in rad
_EPS = 1e-11  # of constraints, relative to the compliance that they meet
_EPS_PER_SQUARED_GAP, _LEAST_EPS_APART, _LARGEST_EPS = 1e6, 1e-8, 1e-7
_ROUND_OFF = 1e3 * np.finfo(float).eps
_MORE = 4  # eigenvalues that are computed besides those asked for
_BASIS = 4  # vectors of Arnoldi's method per eigenvalue: two may not separate pairs of equal size
_RESTARTS = 30  # of Arnoldi's method, which needs a few for a good shift
_LAST_DIGITS = 8  # lost in sums of elements, and in factors
_DROWNED, _RIGID = 0.1, 0.01  # uncertainties, relative to eigenvalues of their own, and to the smallest elastic one
_LONGEST_CHAIN = 3  # length of chains of infinite eigenvalues of constraints


@dataclass(frozen=True)
class VibrationModes:
    """Results of ComputeVibrationModes, the lowest frequencies first.

    eigenvalues: complex lambda (1/s) of motions exp(lambda t), one of each conjugate pair, with imaginary part >= 0.
    frequencies: imaginary parts in Hz, in the rotating frame.
    dampingRatios: - Re(lambda) / |lambda|; negative ones grow. 0 for lambda = 0.
    uncertainties: bound of the effect of round-off of the stiffnesses on each eigenvalue (1/s). It grows with the
    ratio of
        the largest to the smallest stiffness and with the square of the number of elements; those of rigid-body modes
        are not larger.
    modes: complex ODE2 motions, one column per eigenvalue; the entry of largest magnitude is 1. Rotations of Lie-group
        nodes are small rotation vectors in the axes of the node.
    coordinates: ODE2 coordinates of the state about which the system vibrates.
    """

    eigenvalues: ComplexArray
    frequencies: FloatArray
    dampingRatios: FloatArray
    uncertainties: FloatArray
    modes: ComplexArray
    coordinates: FloatArray


def _error(reason: str, problem: str, advice: str) -> SolverError:
    return SolverError(f"{_NAME}: {problem}", advice, reason=reason, solverName=_NAME, advice=[advice])


def _square(entries: Any, size: int) -> Any:
    from scipy.sparse import csr_array

    rows, columns, values = entries
    return csr_array((values, (rows, columns)), shape=(size, size))


def _matrices(mbs: Any, state: Any, rotation: RotatingFrame) -> tuple[Any, Any, Any]:
    """Return M and G of the ODE2 coordinates, and K with the constraints, as seen from the rotating frame."""
    from scipy.sparse import block_diag, csr_array, vstack

    n, size = len(state.q), len(state.q) + len(state.lam)
    v_by, a_by, rates = rotation.apply(state)
    saddle = _square(testing.tangent_entries(mbs, state, cq=1, cv=0), size)
    by_rates = _square(testing.tangent_entries(mbs, state, cq=0, cv=1), size)
    D = by_rates[:n, :n]
    if size > n and by_rates[n:, :n].nnz:  # small motions that constraints of velocities permit, as of rolling
        saddle = saddle + vstack([csr_array((n, size)), by_rates[n:]], format="csr")
    M = _square(testing.mass_entries(mbs, state), size)[:n, :n]
    more = D @ v_by + M @ a_by
    K = saddle + block_diag([more, csr_array((size - n, size - n))], format="csr") if size > n else saddle + more
    return M, D + M @ rates, K


def _start(mbs: Any) -> Any:
    data, initial, state = mbs.systemData, ConfigurationType.Initial, testing.State(mbs)
    if len(state.y) > 0:
        raise ValueError(f"{_NAME}: expected a system without ODE1 coordinates, received {len(state.y)} of them")
    state.q, state.data = data.GetODE2Coordinates(initial), data.GetDataCoordinates(initial)
    state.t, state.lam = data.GetTime(initial), np.zeros(len(state.lam))
    return state


class _Factors:
    """Factors of a matrix of n small motions and their constraints.

    Springs along the constraints, as stiff as what these hold, do not change the solution. They make the matrix of the
    motions regular. The metric of the constraints is the compliance of the springs.

    apart: part of the gaps of joints that no motion closes, relative to the size of their mechanism, or in rad. They
    make redundant equations independent by the square of the gap; a multiple of it makes their effect negligible.
    """

    def __init__(self, matrix: Any, n: int, apart: float) -> None:
        from scipy.sparse import block_diag, csr_array, diags_array

        own, forces = matrix.diagonal()[n:] != 0, matrix[:n, n:]  # own: equations that define their multipliers
        largest = (diags_array(np.abs(matrix.diagonal()[:n])) @ abs(forces).sign()).max(axis=0).toarray().ravel()
        squares = np.asarray(forces.power(2).sum(axis=0)).ravel()
        held = (largest > 0) & (squares > 0) & ~own
        compliance = np.where(own, 0.0, np.divide(squares, largest, out=np.ones(len(own)), where=held))
        self._n, self._springs = n, forces @ diags_array(held / np.where(held, compliance, 1.0))
        eps = _EPS if apart <= _CLOSED else min(_LARGEST_EPS, max(_LEAST_EPS_APART, _EPS_PER_SQUARED_GAP * apart**2))
        if len(own):
            matrix = matrix + block_diag(
                [self._springs @ matrix[n:, :n], csr_array((len(own), len(own)))], format="csr"
            )
        try:
            self._factors = constrained_factors(matrix, compliance, eps)
        except np.linalg.LinAlgError as error:
            problem = f"the matrix of small motions is singular ({error})"
            raise _error("singularMatrix", problem, "give all coordinates stiffness or mass") from error

    def solve(self, right: FloatArray, fit: bool) -> FloatArray:
        """Return the solution. fit = False: what no motion closes of the gaps is left open."""
        n = self._n
        return self._factors.solve(np.append(right[:n] + self._springs @ right[n:], right[n:]), fit)


def _shifted(M: Any, G: Any, K: Any, shift: float) -> Any:
    """Return K + s G + s^2 M with the constraints below."""
    from scipy.sparse import block_diag, csr_array

    rest = K.shape[0] - M.shape[0]
    more = shift * G + shift**2 * M
    return K + (block_diag([more, csr_array((rest, rest))], format="csr") if rest else more)


def _shift_of(M: Any, K: Any, parts: CoordinateParts) -> float:
    mass = M.diagonal()
    if not (mass > 0).any():
        raise _error("massMatrix", "no coordinate has mass", "give the bodies mass")
    highest = parts.highest_frequency(mass, K.diagonal()[: M.shape[0]])
    return _SHIFT * highest if highest > 0 else 1.0


def _step(
    matrices: tuple[Any, Any, Any], residual: FloatArray, parts: CoordinateParts, gap: float, is_closed: bool
) -> FloatArray:
    """Return the increment of Newton's method; if it is too long, a mass term regularizes it to a descent direction.

    Rigid-body modes are not changed.
    """
    M, G, K = matrices
    n, shift = M.shape[0], _shift_of(M, K, parts)
    for _ in range(_SHORTER_STEPS):
        factors = _Factors(_shifted(M, G * 0, K, shift), n, gap if is_closed else 0.0)
        increment = -factors.solve(residual, fit=gap <= _CLOSED)
        moves, turns = parts.sizes(increment[:n])
        excess = max(moves.max(initial=0.0) / _LARGEST_MOVE, turns.max(initial=0.0) / _LARGEST_TURN)
        if not excess > 1.0:
            return increment
        shift *= max(2.0, 1.2 * np.sqrt(excess))
    increment[:n] /= excess
    return increment


def _find_balance(mbs: Any, state: Any, rotation: RotatingFrame, parts: CoordinateParts) -> float:
    """Move the state to where all forces, those of the rotation among them, are in balance, and joints fit.

    Return the remaining gap of inconsistent joints, relative to the size of their mechanism, or in rad.
    """
    n, largest, before, open_before = len(state.q), 0.0, np.inf, np.inf
    units = testing.constraint_metric(mbs, state)[1]
    for _ in range(_ITERATIONS):
        M, G, K = _matrices(mbs, state, rotation)
        residual = np.asarray(testing.residual(mbs, state))
        size, gap = float(np.linalg.norm(residual[:n])), float(np.abs(residual[n:] / units).max(initial=0.0))
        magnitudes = np.abs(np.concatenate([rotation.reference + state.q, state.lam]))
        magnitudes[:n] = np.maximum(magnitudes[:n], parts.extent)  # positions of other points are rounded as well
        round_off = _ROUND_OFF * float(np.linalg.norm((abs(K) @ magnitudes)[:n]))
        largest = max(largest, size)
        if not np.isfinite(size + gap):
            break
        is_closed = gap <= _CLOSED or gap > open_before / 2  # nothing makes it smaller
        if is_closed and (size <= _BALANCE * largest or (size <= round_off and size > before / 2)):
            return gap
        before, open_before = size, gap
        increment = _step((M, G, K), residual, parts, gap, is_closed)
        state.q = testing.compose(mbs, state, increment[:n])
        state.lam = np.asarray(state.lam) + increment[n:]
    advice = (
        "start closer to the equilibrium: mbs.SolveStatic(..., updateInitialValues=True), or a lower angularVelocity "
        "with updateInitialValues=True first"
    )
    raise _error("newton", f"no balance of forces after {_ITERATIONS} iterations (residual {size:.3g})", advice)


def _warn_of_turning(mbs: Any, parts: CoordinateParts, rotation: RotatingFrame) -> None:
    """Warn of initial velocities that turn bodies, which count in a rotating frame only."""
    rates = mbs.systemData.GetODE2Coordinates_t(ConfigurationType.Initial)
    moving = parts.turning[rates[parts.turning] != 0]
    if len(moving) and not rotation.rotates:
        warnings.warn(
            f"{_NAME}: initial velocities are ignored, and so are gyroscopic effects of bodies that turn "
            f"({testing.describe_row(mbs, int(moving[0]))}); angularVelocity gives the speed of a rotating frame",
            RuntimeWarning,
            stacklevel=3,
        )


def _warn_if_far(mbs: Any, state: Any, parts: CoordinateParts) -> None:
    """Warn of an equilibrium that is not the one a user expects next to the initial state."""
    change = np.array(state.q) - mbs.systemData.GetODE2Coordinates(ConfigurationType.Initial)
    moves, turns = parts.sizes(change)
    for sizes, limit, how in (
        (turns, _FAR_TURN, "{:.3g} rad"),
        (moves, _FAR_MOVE, "{:.3g} times the size of the model"),
    ):
        if sizes.max(initial=0.0) > limit:
            place = int(np.argmax(sizes))
            away, where = how.format(sizes[place]), testing.describe_row(mbs, place)
            warnings.warn(
                f"{_NAME}: the equilibrium found is {away} away from the initial state, at {where}. "
                "Modes are those about this equilibrium; coordinates has its values",
                RuntimeWarning,
                stacklevel=3,
            )
            return


def _check_that_joints_fit(mbs: Any, state: Any) -> None:
    """Raise an error for gaps beyond the tolerance of solvers, and warn of smaller ones."""

    def left_open(tolerance: float) -> list[str]:
        return listed([text for *_, text in testing.open_constraints(mbs, state, tolerance, tolerance, False)])

    problem = "constraints contradict each other; what the closest fit leaves open:"
    if refused := left_open(SimulationSettings().redundantConstraints.largestMisfit):
        advice = "move or turn the markers of these joints until they fit, or free equations that others state as well"
        raise _error("contradictoryConstraints", "\n".join([problem, *refused]), advice)
    if some := left_open(_NOTICEABLE):
        warnings.warn("\n".join([f"{_NAME}: {problem}", *some]), RuntimeWarning, stacklevel=3)


def _eigenpairs(
    M: Any, G: Any, K: Any, count: int, parts: CoordinateParts, apart: float
) -> tuple[ComplexArray, ComplexArray]:
    """Return lambda and x of lambda^2 M x + lambda G x + K x + C^T mu = 0, C x = 0, those nearest to zero first."""
    shift, n = _shift_of(M, K, parts), M.shape[0]
    if 2 * n <= max(_DENSE, 2 * count + _MORE + 2):
        return _dense(M, G, K, shift, apart)
    least = _LEAST_SHIFT / _SHIFT * shift
    while True:
        found = _nearest(M, G, K, count, shift, apart)
        if found is not None and len(found[0]) == 0 and shift <= least:
            return found  # constraints hold everything
        smallest = float(np.abs(found[0]).min()) if found is not None and len(found[0]) else 0.0
        if found is not None and shift <= max(smallest, least):
            return found
        if shift <= least:
            advice = "make the model less stiff, or its elements longer: motions of interest are lost in rounding"
            raise _error("newton", "no modes were found", advice)
        shift = max(shift / 10, smallest / 2, least)  # low frequencies are not separated far from a shift


def _nearest(
    M: Any, G: Any, K: Any, count: int, shift: float, apart: float
) -> tuple[ComplexArray, ComplexArray] | None:
    """Return eigenvalues next to the shift, and their vectors; None if they are not separated.

    Constraints have infinite eigenvalues in chains, whose rounding looks like fast motions: small systems are reduced
    to the motions that constraints permit, and pairs that do not solve the equations of motion are dropped.
    """
    from scipy.sparse.linalg import ArpackNoConvergence, LinearOperator, eigs

    n, size = M.shape[0], K.shape[0]
    factors, fit = _Factors(_shifted(M, G, K, shift), n, apart), apart <= _CLOSED
    damped = G + shift * M

    def inverse(y: FloatArray) -> FloatArray:
        right = np.zeros(size)
        right[:n] = -(M @ y[n:]) - damped @ y[:n]
        x = factors.solve(right, fit)[:n]
        return np.append(x, shift * x + y[:n])

    wanted = 2 * count + _MORE
    operator = LinearOperator((2 * n, 2 * n), matvec=lambda y: inverse(y.ravel()), dtype=float)
    # vectors in the range of the operator fulfil the constraints
    first = np.random.default_rng(1).normal(size=2 * n)
    for _ in range(_LONGEST_CHAIN):
        first = inverse(first)
        first /= np.linalg.norm(first)
    try:
        inverses, vectors = eigs(operator, k=wanted, ncv=min(_BASIS * wanted, 2 * n), v0=first, maxiter=_RESTARTS)
    except ArpackNoConvergence:
        return None
    finite = np.abs(inverses) > INFINITE * np.abs(inverses).max()
    values, vectors = shift + 1 / inverses[finite], vectors[:n, finite]
    solves = solve_the_equations(M, G, K[:n, :n], values, vectors, shift)
    return values[solves], vectors[:, solves]


def _dense(M: Any, G: Any, K: Any, shift: float, apart: float) -> tuple[ComplexArray, ComplexArray]:
    try:
        return ReducedPencil(M, G, K, apart).nearest(shift)
    except np.linalg.LinAlgError as error:
        problem = f"the matrix of small motions is singular ({error})"
        raise _error("singularMatrix", problem, "give all coordinates stiffness or mass") from error


def _uncertainties(M: Any, G: Any, K: Any, values: ComplexArray, vectors: ComplexArray) -> FloatArray:
    """Return the effect of round-off in all entries of K on the eigenvalues, to first order of their squares."""
    n = M.shape[0]
    magnitudes = np.abs(vectors)
    rounding = _LAST_DIGITS * np.finfo(float).eps * np.sum(magnitudes * (abs(K[:n, :n]) @ magnitudes), axis=0)
    mass = np.maximum(np.abs(np.sum(vectors.conj() * (M @ vectors), axis=0)), np.finfo(float).tiny)
    slope = np.abs(np.sum(vectors.conj() * (2 * (M @ vectors) * values + G @ vectors), axis=0)) / (2 * mass)
    change = rounding / mass
    return np.asarray(change / (slope + np.sqrt(slope**2 + change) + np.finfo(float).tiny))


def _warn_of_rounding(values: ComplexArray, uncertainties: FloatArray) -> None:
    """Warn if eigenvalues drown in rounding, unless they are as small against others as those of rigid motions are."""
    sizes = np.abs(values)
    lost = uncertainties > _DROWNED * sizes
    elastic = sizes[~lost].min(initial=np.inf)
    if not lost.any() or uncertainties[lost].max() < _RIGID * elastic < np.inf:
        return
    warnings.warn(
        f"{_NAME}: rounding may have moved {lost.sum()} of {len(values)} eigenvalues by up to "
        f"{uncertainties[lost].max():.2g} 1/s, more than {_DROWNED:g} of their size; see uncertainties. Take fewer "
        "elements, or lower the largest stiffness (axial, shear), which such motions do not feel",
        RuntimeWarning,
        stacklevel=3,
    )


def ComputeVibrationModes(
    mbs: Any,
    numberOfModes: int = 10,
    angularVelocity: Any = (0.0, 0.0, 0.0),
    center: Any = (0.0, 0.0, 0.0),
    updateInitialValues: bool = False,
    autoAssemble: bool = True,
) -> VibrationModes:
    """Return the lowest complex modes of small motions about the equilibrium next to the initial state.

    There are fewer if the system has fewer degrees of freedom. A warning reports an equilibrium that is far away.
    All forces count at their full values: preloads, gyroscopic and centrifugal forces, damping, and geometric terms of
    forces in bodies, connectors and constraints. If an angularVelocity (rad/s, global axes) about center (m) is
    given, the motion of the whole model, including ground
    and the directions of loads, is described in a rotating frame: its steady state is found
    by Newton's method from the initial state, and motions are those relative to the frame. Bodies with a floating frame
    turn with that; ObjectGenericODE2 rotates if its nodes are points or rigid bodies. Dampers between bodies and
    ground see the speed of the rotation. Constraints may be redundant. updateInitialValues makes that state the initial
    one. Matrices are sparse: the time grows with the number of modes and, nearly linearly, with the size of the system.
    """
    speed, middle = np.asarray(angularVelocity, dtype=float), np.asarray(center, dtype=float)
    for name, vector in (("angularVelocity", speed), ("center", middle)):
        if vector.shape != (3,) or not np.isfinite(vector).all():
            raise ValueError(f"{_NAME}: {name}: expected 3 finite numbers, received {vector.tolist()}")
    if numberOfModes < 1:
        raise ValueError(f"{_NAME}: numberOfModes: expected a positive number, received {numberOfModes}")
    assemble_if_needed(_NAME, mbs, autoAssemble)
    state = _start(mbs)
    rotation = RotatingFrame(mbs, speed, middle)
    parts = CoordinateParts(mbs, state)
    _warn_of_turning(mbs, parts, rotation)
    apart = _find_balance(mbs, state, rotation, parts)
    _warn_if_far(mbs, state, parts)
    _check_that_joints_fit(mbs, state)
    M, G, K = _matrices(mbs, state, rotation)
    values, vectors = _eigenpairs(M, G, K, numberOfModes, parts, apart)
    upper = values.imag >= 0
    values, vectors = values[upper], vectors[:, upper]
    order = np.argsort(np.abs(values))[:numberOfModes]
    values, vectors = values[order], vectors[:, order]
    places = np.argmax(np.abs(vectors), axis=0)
    vectors = vectors / vectors[places, np.arange(len(values))]
    sizes = np.abs(values)
    uncertainties = _uncertainties(M, G, K, values, vectors)
    _warn_of_rounding(values, uncertainties)
    damping = np.divide(-values.real, sizes, out=np.zeros(len(values)), where=sizes > 0)
    if updateInitialValues:
        mbs.systemData.SetODE2Coordinates(state.q, ConfigurationType.Initial)
    return VibrationModes(values, values.imag / (2 * np.pi), damping, uncertainties, vectors, np.array(state.q))
