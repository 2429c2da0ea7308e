"""Factorization and solution of matrices of mechanical systems, thousands of times with one pattern.

    python benchmarks/linear_solvers.py [--only TEXT] [--seconds S]

For each matrix: microseconds per unknown of a repeated factorization and of a solution and bytes of the factors per
unknown, for each instruction set of this processor, and for what else is installed: SuperLU (scipy), and KLU, UMFPACK
and CHOLMOD (kvxopt), which are given the analysis of the pattern. CHOLMOD, which needs symmetric positive definite
matrices, gets A + A' of grids. Times are the smallest of many; the machine should be quiet.
"""

from __future__ import annotations

import argparse
import importlib.util
import time
from collections.abc import Callable, Iterator

import numpy as np
import scipy.sparse as sp
import scipy.sparse.linalg

import dalembert as exu
from dalembert._core import testing
from dalembert.beams import GenerateStraightLineANCFCable2D
from dalembert.itemInterface import Cable2D
from dalembert.utilities import InertiaCuboid

Matrix = sp.csc_array


def tangent(mbs: exu.MainSystem, step: float) -> Matrix:
    """Of an implicit step: M + step/2 D + step^2/4 K, and the constraints."""
    mbs.Assemble()
    state = testing.State(mbs)
    state.q = state.q + 1e-3 * np.sin(np.arange(state.q.size))
    state.lam = np.cos(np.arange(state.lam.size))
    matrix = testing.tangent(mbs, state, cq=step**2 / 4, cv=step / 2, ca=1.0, dense=False)
    return sp.csc_array(matrix)


def chain(bodies: int) -> Matrix:
    """Rigid bodies with Euler parameters and revolute joints in a row."""
    mbs = exu.SystemContainer().AddSystem()
    previous = mbs.CreateGround()
    for i in range(bodies):
        inertia = InertiaCuboid(density=2000, sideLengths=[0.2, 0.04, 0.04])
        body = mbs.CreateRigidBody(inertia=inertia, referencePosition=[0.2 * i + 0.1, 0, 0])
        axis = [0, 0, 1] if i % 2 == 0 else [0, 1, 0]
        mbs.CreateRevoluteJoint(bodyNumbers=[previous, body], position=[0.2 * i, 0, 0], axis=axis)
        previous = body
    return tangent(mbs, 1e-3)


def cable(elements: int) -> Matrix:
    """Cable elements of a clamped beam in the plane."""
    mbs = exu.SystemContainer().AddSystem()
    template = Cable2D(physicsMassPerLength=1, physicsBendingStiffness=1, physicsAxialStiffness=1e4)
    GenerateStraightLineANCFCable2D(
        mbs=mbs,
        positionOfNode0=[0, 0, 0],
        positionOfNode1=[0.02 * elements, 0, 0],
        numberOfElements=elements,
        cableTemplate=template,
        fixedConstraintsNode0=[1, 1, 0, 1],
    )
    return tangent(mbs, 1e-3)


def grid(side: int) -> Matrix:
    """Masses at the points of a square grid, three coordinates each, springs and dampers between neighbours."""
    line = sp.diags_array([np.ones(side - 1), np.ones(side - 1)], offsets=[-1, 1])
    eye = sp.eye_array(side)
    neighbours = sp.kron(line, eye) + sp.kron(eye, line) + sp.kron(eye, eye)
    matrix = sp.csc_array(sp.kron(neighbours, np.ones((3, 3))))
    matrix.data = np.random.default_rng(0).uniform(-1, 1, matrix.nnz)
    return sp.csc_array(matrix + sp.diags_array(np.full(matrix.shape[0], 8.0)))


MATRICES: dict[str, Callable[[], Matrix]] = {
    "chain of 10 bodies": lambda: chain(10),
    "chain of 100 bodies": lambda: chain(100),
    "cable of 256 elements": lambda: cable(256),
    "cable of 1000 elements": lambda: cable(1000),
    "grid 28 x 28": lambda: grid(28),
    "grid 98 x 98": lambda: grid(98),
}


def complete(matrix: Matrix) -> Matrix:
    """With explicit zeros where only the transposed entry is not zero, and on the diagonal, as systems have them."""
    pattern = sp.csc_array(abs(matrix) + abs(matrix.T) + sp.eye_array(matrix.shape[0]))
    pattern.sort_indices()
    columns = np.repeat(np.arange(matrix.shape[1]), np.diff(pattern.indptr))
    pattern.data = np.asarray(matrix[pattern.indices, columns]).ravel()
    return pattern


# Factorization, solution, and numbers in the factors.
Candidate = tuple[Callable[[], object], Callable[[], object], int | None]


def own(matrix: Matrix, instructions: str) -> Candidate:
    solver = testing.LinearSolver(matrix.indptr, matrix.indices, instructions=instructions)
    solver.factorize(matrix.data)
    b = np.ones(matrix.shape[0])
    return lambda: solver.factorize(matrix.data), lambda: solver.solve(b), solver.statistics["entries"]


def superlu(matrix: Matrix) -> Candidate:
    def factorize() -> scipy.sparse.linalg.SuperLU:
        return scipy.sparse.linalg.splu(matrix, permc_spec="MMD_AT_PLUS_A", options={"SymmetricMode": True})

    lu, b = factorize(), np.ones(matrix.shape[0])
    return factorize, lambda: lu.solve(b), lu.L.nnz + lu.U.nnz


def suitesparse(matrix: Matrix, name: str) -> Candidate:
    import kvxopt

    module = importlib.import_module(f"kvxopt.{name}")
    if name == "cholmod":
        matrix = sp.csc_array(matrix + matrix.T)
    columns = np.repeat(np.arange(matrix.shape[1]), np.diff(matrix.indptr))
    a = kvxopt.spmatrix(matrix.data.tolist(), matrix.indices.tolist(), columns.tolist(), matrix.shape)
    b = kvxopt.matrix(1.0, (matrix.shape[0], 1))
    symbolic = module.symbolic(a)
    if name == "cholmod":
        module.numeric(a, symbolic)
        return lambda: module.numeric(a, symbolic), lambda: module.solve(symbolic, b), None
    numeric = module.numeric(a, symbolic)
    solve = (lambda: module.solve(a, symbolic, numeric, b)) if name == "klu" else (lambda: module.solve(a, numeric, b))
    return lambda: module.numeric(a, symbolic), solve, None


def candidates(matrix: Matrix, label: str) -> Iterator[tuple[str, Candidate]]:
    for instructions in testing.instruction_sets():
        yield f"dalembert, {instructions}", own(matrix, instructions)
    yield "SuperLU", superlu(matrix)
    if importlib.util.find_spec("kvxopt") is None:
        return
    for name in ("klu", "umfpack", *(["cholmod"] if "grid" in label else [])):
        yield name.upper(), suitesparse(matrix, name)


def shortest(call: Callable[[], object], seconds: float) -> float:
    best, end = np.inf, time.perf_counter() + seconds
    while time.perf_counter() < end or best == np.inf:
        start = time.perf_counter()
        call()
        best = min(best, time.perf_counter() - start)
    return best


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", default="", help="matrices whose names contain this")
    parser.add_argument("--seconds", type=float, default=0.5, help="per measurement")
    arguments = parser.parse_args()
    print(f"{'matrix':24}{'unknowns':>9}  {'solver':22}{'factorize':>10}{'solve':>8}  us per unknown, ratios; bytes")
    for label, build in MATRICES.items():
        if arguments.only not in label:
            continue
        matrix = complete(build())
        first = (0.0, 0.0)
        for solver, (factorize, solve, entries) in candidates(matrix, label):
            times = tuple(shortest(call, arguments.seconds) / matrix.shape[0] * 1e6 for call in (factorize, solve))
            first = times if first[0] == 0 else first
            ratios = f"{times[0] / first[0]:8.1f}{times[1] / first[1]:8.1f}"
            size = "" if entries is None else f"{8 * entries / matrix.shape[0]:8.0f}"
            print(f"{label:24}{matrix.shape[0]:9}  {solver:22}{times[0]:10.3f}{times[1]:8.3f}{ratios}{size}")


if __name__ == "__main__":
    main()
