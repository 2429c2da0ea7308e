"""The system linearized about its initial state: mass, stiffness and damping matrices, eigenvalues, redundancy."""

from __future__ import annotations

import warnings
from typing import Any, NamedTuple

import numpy as np

from dalembert import _core
from dalembert._checks import FloatArray
from dalembert._core import SimulationSettings, testing
from dalembert._solving.diagnosis import SolverError, listed
from dalembert._solving.preload import stiffness_of_reactions, warn_of_turning
from dalembert._solving.quiet import assemble_if_needed, quiet_static_solver
from dalembert._solving.sparse_factors import sparse_solver


class _Matrices(NamedTuple):
    """M x_tt + D x_t + K x + C lambda = 0 for small ODE2 motions x."""

    M: FloatArray
    K: FloatArray
    D: FloatArray
    C: FloatArray  # transposed constraint Jacobian, one column per constraint
    algebraic: FloatArray  # derivative of the constraints with respect to the multipliers


def _dense(matrix: Any) -> FloatArray:
    return np.array(matrix.toarray() if hasattr(matrix, "toarray") else matrix, dtype=float)


def _linearize(
    function: str, mbs: Any, simulationSettings: Any, autoAssemble: bool, counts_only: bool = False
) -> _Matrices:
    """Compute all matrices of the linearized system; ODE1 coordinates are left out, with a warning."""
    with quiet_static_solver(function, mbs, simulationSettings, autoAssemble) as solver:
        n2, n1 = solver.GetODE2size(), solver.GetODE1size()
        if n1 != 0:
            _core.Print(f"WARNING: {function}: the {n1} ODE1 coordinates are left out of the linearized system")
        solver.ComputeMassMatrix(mbs)
        M = _dense(solver.GetSystemMassMatrix())[:n2, :n2]
        solver.ComputeJacobianODE2RHS(mbs, scalarFactor_ODE2=-1, scalarFactor_ODE2_t=0, scalarFactor_ODE1=0)
        if solver.GetAEsize() != 0:
            solver.ComputeJacobianAE(
                mbs, scalarFactor_ODE2=1, scalarFactor_ODE2_t=0, scalarFactor_ODE1=1, velocityLevel=False
            )
        jacobian = _dense(solver.GetSystemJacobian())
        solver.ComputeJacobianODE2RHS(mbs, scalarFactor_ODE2=0, scalarFactor_ODE2_t=-1, scalarFactor_ODE1=0)
        D = _dense(solver.GetSystemJacobian())[:n2, :n2]
    first, K, state = n2 + n1, jacobian[:n2, :n2], _initial_state(mbs)
    if counts_only:  # scales of constraints and coordinates, independent of the stiffness
        return _Matrices(M, K, D, jacobian[:n2, first:], jacobian[first:, first:])
    warn_of_turning(function, mbs, state)
    if (more := stiffness_of_reactions(function, mbs, state)) is not None:
        K = K + more
    return _Matrices(M, K, D, jacobian[:n2, first:], jacobian[first:, first:])


# Equations that are so much smaller than others act by round-off alone.
_ROUND_OFF_OF_EQUATIONS = 1e-12
# Redundant equations with gaps have singular values of up to this multiple of the gaps, at most the second value.
_MULTIPLE_OF_GAPS, _HIDES_MOST = 10.0, 1e-3
_LIKELY_CAUSE = 1e-2  # gap, relative to the size of its mechanism, or in rad, after which solutions may go astray
_LARGE_GAP = (
    # relative to the size of the mechanism, or in rad: gaps of this size hide redundant constraints, here and in
    # solvers
    1e-4
)


def _scaled(equations: FloatArray) -> FloatArray:
    """Return equations, in columns, of size one: units and factors do not make one of them smaller than others."""
    sizes = np.linalg.norm(equations, axis=0)
    acts = sizes > _ROUND_OFF_OF_EQUATIONS * sizes.max(initial=0.0)
    return np.asarray(np.where(acts, equations / np.where(acts, sizes, 1.0), 0.0))


def _rank(singularValues: Any, tolerance: float) -> int:
    """Round-off grows with the largest singular value, thus the tolerance as well."""
    return int((singularValues > tolerance * singularValues.max(initial=0.0)).sum())


def _initial_state(mbs: Any) -> Any:
    state, data, initial = testing.State(mbs), mbs.systemData, _core.ConfigurationType.Initial
    state.q, state.v = data.GetODE2Coordinates(initial), data.GetODE2Coordinates_t(initial)
    state.y, state.data = data.GetODE1Coordinates(initial), data.GetDataCoordinates(initial)
    state.lam, state.t = np.zeros_like(state.lam), data.GetTime(initial)
    return state


def gaps_at_start(mbs: Any) -> list[str]:
    """Return texts on constraints with gaps in the initial state that are large for their mechanism."""
    if mbs.systemData.AEsize() == 0:
        return []
    gaps = testing.open_constraints(mbs, _initial_state(mbs), _LIKELY_CAUSE, _LIKELY_CAUSE, False)
    return [text for *_, text in gaps]


def _joints_apart(mbs: Any, state: Any, tolerance: float) -> tuple[float, str]:
    """Return the largest of gaps, relative to the size of its mechanism or in rad, and lines on them with advice."""
    gaps = testing.open_constraints(mbs, state, tolerance, tolerance, False)
    if not gaps:
        return 0.0, ""
    units = testing.constraint_metric(mbs, state)[1]
    advice = "mbs.ComputeConsistentInitialConditions() finds initial values where they fit, if there are any"
    lines = [*listed([text for *_, text in gaps]), f"  {advice}"]
    return max(abs(gap) / float(units[row]) for row, _, gap, _, _ in gaps), "\n".join(lines)


def _allow_for_gaps(name: str, mbs: Any, singularValues: Any, tolerance: float) -> float:
    """Return the threshold of zero singular values: gaps increase those of redundant constraints."""
    largest = singularValues.max(initial=0.0)
    doubtful = singularValues[(singularValues > tolerance * largest) & (singularValues <= _HIDES_MOST * largest)]
    gap, lines = _joints_apart(mbs, _initial_state(mbs), tolerance) if len(doubtful) else (0.0, "")
    hides = min(_MULTIPLE_OF_GAPS * gap, _HIDES_MOST)
    hidden = int((doubtful <= hides * largest).sum())
    if hidden == 0:
        return tolerance
    warnings.warn(
        f"{name}: joints are apart, and {hidden} of the constraint equations follow from others nearly: they are taken "
        f"for redundant.\n{lines}",
        stacklevel=4,
    )
    return hides


def _nullspace(name: str, mbs: Any, C: FloatArray, tolerance: float) -> FloatArray:
    """Return an orthonormal basis, in rows, of the motions that the constraints permit."""
    from scipy.linalg import svd

    U, singularValues, _ = svd(_scaled(C))
    return np.asarray(U[:, _rank(singularValues, _allow_for_gaps(name, mbs, singularValues, tolerance)) :].T)


def ComputeLinearizedSystem(
    mbs: Any,
    simulationSettings: SimulationSettings | None = None,
    projectIntoConstraintNullspace: bool = False,
    singularValuesTolerance: float = 1e-12,
    returnConstraintJacobian: bool = False,
    returnConstraintNullspace: bool = False,
    autoAssemble: bool = True,
) -> list[Any]:
    """Return [M, K, D]: mass, stiffness and damping matrix of the system linearized about the initial state.

    Constraint forces add to the stiffness in an equilibrium; in other states they are neglected, with a warning.
    Rotating bodies give a warning: ComputeVibrationModes has gyroscopic modes in a rotating frame.
    The ODE2 coordinates count (n x n), or the motions that the constraints permit if projectIntoConstraintNullspace.
    If there are constraints, returnConstraintJacobian or -Nullspace append C (n x constraints, or []) and
    the nullspace N (motions x n, or []); N C = 0. Singular values of the equations, scaled to size one, are taken for
    zero below singularValuesTolerance times the largest.
    """
    system = _linearize("ComputeLinearizedSystem", mbs, simulationSettings, autoAssemble)
    matrices: list[Any] = [system.M, system.K, system.D]
    wants_nullspace = projectIntoConstraintNullspace or returnConstraintNullspace
    if system.C.shape[1] == 0 or not (wants_nullspace or returnConstraintJacobian):
        return matrices
    extra: list[Any] = [system.C if returnConstraintJacobian else []]
    if wants_nullspace:
        N = _nullspace("ComputeLinearizedSystem", mbs, system.C, singularValuesTolerance)
        extra.append(N if returnConstraintNullspace else [])
        if projectIntoConstraintNullspace:
            matrices = [N @ matrix @ N.T for matrix in matrices]
    return matrices + extra


def _eigenvalue_error(reason: str, problem: str, advice: str) -> SolverError:
    """Return the error of an eigenvalue solver that cannot go on."""
    name = "ComputeODE2Eigenvalues"
    return SolverError(f"{name}: {problem}", advice, reason=reason, solverName=name, advice=[advice])


def _want_of_mass(problem: str, M: FloatArray) -> SolverError:
    massless = [int(i) for i in np.flatnonzero(np.diag(M) <= 0.0)]
    advice = f"give every coordinate mass or inertia (coordinates without: {massless})"
    return _eigenvalue_error("massMatrix", problem, f"{advice}, or exclude them by constrainedCoordinates")


def _undamped_modes(K: FloatArray, M: FloatArray) -> Any:
    """Return eigenvalues omega^2 (rad^2/s^2) and eigenvectors, in columns, of K x = omega^2 M x."""
    from scipy.linalg import LinAlgError, eigh

    try:
        return eigh(K, M)
    except LinAlgError as error:
        raise _want_of_mass("the mass matrix is not positive definite", M) from error


def _damped_modes(K: FloatArray, D: FloatArray, M: FloatArray) -> Any:
    """Return eigenvalues lambda (1/s) and eigenvectors [x, lambda x] (columns) of (lambda^2 M + lambda D + K) x = 0."""
    from scipy.linalg import eig

    n = len(M)
    try:
        lower = [-np.linalg.solve(M, K), -np.linalg.solve(M, D)]
    except np.linalg.LinAlgError as error:
        raise _want_of_mass("the mass matrix is singular", M) from error
    return eig(np.block([[np.zeros((n, n)), np.eye(n)], lower]))


def _sparse_modes(K: FloatArray, M: FloatArray, number: int) -> Any:
    """Return the `number` eigenvalues omega^2 nearest to zero and their eigenvectors, by shift-inverted Lanczos."""
    from scipy.sparse import csc_matrix
    from scipy.sparse.linalg import LinearOperator, eigsh

    stiffness = csc_matrix(K)
    try:
        inverse = LinearOperator(K.shape, matvec=sparse_solver(stiffness), dtype=float)
        return eigsh(stiffness, k=number, M=csc_matrix(M), which="LM", sigma=0, mode="normal", OPinv=inverse)
    except (RuntimeError, np.linalg.LinAlgError) as error:  # no convergence, or no factors
        advice = "set useSparseSolver=False, or hold coordinates that no spring holds by constrainedCoordinates"
        raise _eigenvalue_error("singularMatrix", f"no factors of the stiffness matrix ({error})", advice) from error


def ComputeODE2Eigenvalues(
    mbs: Any,
    simulationSettings: SimulationSettings | None = None,
    useSparseSolver: bool = False,
    numberOfEigenvalues: int = 0,
    constrainedCoordinates: list[int] = [],
    convert2Frequencies: bool = False,
    useAbsoluteValues: bool = True,
    computeComplexEigenvalues: bool = False,
    ignoreAlgebraicEquations: bool = False,
    singularValuesTolerance: float = 1e-12,
    autoAssemble: bool = True,
) -> list[Any]:
    """Return [eigenvalues, eigenvectors in columns] of the system linearized about its initial state, sorted.

    Eigenvalues are omega^2 (rad^2/s^2), frequencies in Hz if convert2Frequencies, or the complex lambda (1/s) of the
    damped system if computeComplexEigenvalues. Forces of constraints count in an equilibrium; elsewhere, and where
    bodies turn, a warning names ComputeVibrationModes. useAbsoluteValues sorts and returns magnitudes.
    numberOfEigenvalues limits the number (0: all). Constraints are projected out, unless ignoreAlgebraicEquations;
    constrainedCoordinates lists ODE2 coordinates that are held. Complex eigenvectors without constraints are
    [x, lambda x].
    """
    name = "ComputeODE2Eigenvalues"
    if not isinstance(numberOfEigenvalues, (int, np.integer)) or numberOfEigenvalues < 0:
        expected = "a number of eigenvalues, or 0 for all"
        raise ValueError(f"{name}: numberOfEigenvalues: received {numberOfEigenvalues!r}, but expected {expected}")
    if computeComplexEigenvalues and convert2Frequencies:
        raise ValueError(f"{name}: complex eigenvalues are no frequencies: set convert2Frequencies=False")
    if computeComplexEigenvalues and useSparseSolver:
        raise ValueError(f"{name}: complex eigenvalues need the dense solver: set useSparseSolver=False")
    system = _linearize(name, mbs, simulationSettings, autoAssemble)
    n = len(system.M)
    held = [int(i) for i in constrainedCoordinates]
    if any(not -n <= i < n for i in held):
        raise ValueError(f"{name}: constrainedCoordinates: expected indices of the {n} ODE2 coordinates, got {held}")
    has_constraints = system.C.shape[1] != 0 and not ignoreAlgebraicEquations
    if has_constraints and held:
        raise ValueError(f"{name}: with constraints, set ignoreAlgebraicEquations=True or constrainedCoordinates=[]")
    if has_constraints and useSparseSolver:
        raise ValueError(f"{name}: with constraints, set ignoreAlgebraicEquations=True or useSparseSolver=False")

    M, K, D = system.M, system.K, system.D
    basis: FloatArray | None = None  # x = basis @ y leaves free coordinates y
    if has_constraints or held:
        basis = (
            _nullspace(name, mbs, system.C, singularValuesTolerance).T
            if has_constraints
            else np.delete(np.eye(n), held, 1)
        )
        M, K, D = (basis.T @ matrix @ basis for matrix in (M, K, D))
    if computeComplexEigenvalues:
        values, vectors = _damped_modes(K, D, M)
        parts = [vectors[: len(M)]] if has_constraints else [vectors[: len(M)], vectors[len(M) :]]
    elif useSparseSolver:
        values, vectors = _sparse_modes(K, M, numberOfEigenvalues or len(M))
        parts = [vectors]
    else:
        values, vectors = _undamped_modes(K, M)
        parts = [vectors]
    vectors = np.vstack(parts if basis is None else [basis @ part for part in parts])

    order = np.argsort(np.abs(values) if useAbsoluteValues else values)
    if numberOfEigenvalues > 0:
        order = order[:numberOfEigenvalues]
    values = np.abs(values[order]) if useAbsoluteValues else values[order]
    if convert2Frequencies:
        values = np.sqrt(values) / (2 * np.pi)
    return [values, vectors[:, order]]


def _summary(mbs: Any, n2: int, constraints: int, redundant: int, pure: int) -> dict[str, Any]:
    return {
        "degreeOfFreedom": n2 - (constraints - pure) + redundant,
        "redundantConstraints": redundant,
        "nODE2": n2,
        "nODE1": mbs.systemData.ODE1Size(),
        "nAE": constraints,
        "nPureAE": pure,
    }


def _counts_by_singular_values(
    name: str, mbs: Any, simulationSettings: Any, threshold: float, verbose: bool | int, autoAssemble: bool
) -> dict[str, Any]:
    system = _linearize(name, mbs, simulationSettings, autoAssemble, counts_only=True)
    n2, constraints = system.C.shape
    if constraints == 0:
        return _summary(mbs, n2, 0, 0, 0)
    both = (_scaled(np.vstack([system.C, system.algebraic])), system.algebraic)
    values, pure_values = (np.linalg.svd(matrix, compute_uv=False) for matrix in both)
    if verbose:
        _core.Print(
            f"singular values of the constraints, scaled to size one: {values}\nof the multipliers alone: {pure_values}"
        )
    redundant = constraints - _rank(values, _allow_for_gaps(name, mbs, values, threshold))
    return _summary(mbs, n2, constraints, redundant, _rank(pure_values, threshold))


def _rank_of_algebraic(rows: Any, columns: Any, values: FloatArray) -> int:
    """Return the rank of the derivatives of constraints with respect to multipliers, which are few or a diagonal."""
    if len(rows) == 0 or (rows == columns).all():
        return len(rows)
    row_numbers, row_places = np.unique(rows, return_inverse=True)
    column_numbers, column_places = np.unique(columns, return_inverse=True)
    matrix = np.zeros((len(row_numbers), len(column_numbers)))
    matrix[row_places, column_places] = values
    return int(np.linalg.matrix_rank(matrix))


_LARGEST_TO_BE_CHECKED = 10_000  # entries, of which singular values take a millisecond
_CERTAINLY_ZERO, _CERTAINLY_NOT = 1e-10, 1e-4


def _may_be(redundant: int, n2: int, first: int, constraints: int, rows: Any, columns: Any, values: FloatArray) -> bool:
    """Return whether singular values that may or may not be zero allow for this number; True for large systems."""
    if n2 * constraints > _LARGEST_TO_BE_CHECKED:
        return True
    equations = np.zeros((first + constraints, constraints))
    held = (columns >= first) & ((rows < n2) | (rows >= first))
    equations[rows[held], columns[held] - first] = values[held]
    largest = np.abs(equations).max(axis=1, keepdims=True)  # largest entries of coordinates, whose units do not matter
    sizes = np.linalg.svd(_scaled(equations / np.where(largest > 0, largest, 1)), compute_uv=False)
    fewest, most = (constraints - _rank(sizes, tolerance) for tolerance in (_CERTAINLY_ZERO, _CERTAINLY_NOT))
    return fewest <= redundant <= most


def _equations_of(mbs: Any, item: dict[str, Any]) -> int:
    """Return the number of equations of an object, also of those in which no coordinate takes part."""
    number = item["object"]
    return max(item["equations"], len(mbs.systemData.GetObjectLTGAE(number)) if number >= 0 else 0)


def _counts(name: str, mbs: Any, autoAssemble: bool) -> dict[str, Any]:
    assemble_if_needed(name, mbs, autoAssemble)
    state = _initial_state(mbs)
    n2, constraints = len(state.q), len(state.lam)
    if constraints == 0:
        return _summary(mbs, n2, 0, 0, 0)
    found = testing.redundant_constraints(mbs, state)
    if lines := _joints_apart(mbs, state, _LARGE_GAP)[1]:
        warnings.warn(
            f"{name}: joints are apart, which may hide that some constraint equations follow from others: the numbers "
            f"of redundant ones and of degrees of freedom may be those of this state alone.\n{lines}",
            stacklevel=3,
        )
    elif not found["certain"]:
        warnings.warn(
            f"{name}: some constraint equations are hardly independent of others (by {found['weakest']:.1g}): the "
            "numbers of redundant ones and of degrees of freedom may be wrong; useSVD=True counts by singular values",
            stacklevel=3,
        )
    rows, columns, values = testing.tangent_entries(mbs, state)
    if not _may_be(found["count"], n2, n2 + len(state.y), constraints, rows, columns, values):
        warnings.warn(
            f"{name}: singular values of the constraints do not tell as many redundant ones, {found['count']}: with "
            "these units of length and mass, round-off of forces hides moments, or these hide forces; useSVD=True "
            "counts by singular values",
            stacklevel=3,
        )
    algebraic = (rows >= n2 + len(state.y)) & (columns >= n2 + len(state.y))
    pure = _rank_of_algebraic(rows[algebraic], columns[algebraic], values[algebraic])
    counts = _summary(mbs, n2, constraints, found["count"], pure)
    removable = {item["object"]: [item["removable"], _equations_of(mbs, item)] for item in found["items"]}
    return counts | {"removableEquations": removable}


def ComputeSystemDegreeOfFreedom(
    mbs: Any,
    simulationSettings: SimulationSettings | None = None,
    threshold: float = 1e-12,
    verbose: bool | int = False,
    useSVD: bool = False,
    autoAssemble: bool = True,
) -> dict[str, Any]:
    """Count the degrees of freedom and the redundant constraints of the system in its initial state.

    The dict has degreeOfFreedom, redundantConstraints, nODE2, nODE1, nAE (all constraints) and nPureAE (constraints on
    multipliers only). Redundant constraints do not increase the rank of the constraint Jacobian, which a sparse
    QR factorization finds; removableEquations then has [removable, all] equations by object number: the number that
    could be removed in this object alone. A warning reports equations that are hardly independent, as in large nets of
    loops. useSVD counts singular values below `threshold`, for small systems. verbose prints the counts, and the
    singular values if useSVD is set.
    """
    name = "ComputeSystemDegreeOfFreedom"
    counts = (
        _counts_by_singular_values(name, mbs, simulationSettings, threshold, verbose, autoAssemble)
        if useSVD
        else _counts(name, mbs, autoAssemble)
    )
    if verbose:
        _core.Print(
            "ODE2 coordinates {nODE2}, constraints {nAE}, redundant {redundantConstraints}, on multipliers only "
            "{nPureAE}: {degreeOfFreedom} degrees of freedom".format(**counts)
        )
        for number, (removable, all_equations) in counts.get("removableEquations", {}).items():
            _core.Print(f"object {number}: {removable} of {all_equations} equations are removable")
    return counts
