"""Trees against Lagrange's equations, with kinetic and potential energy from homogeneous transformations."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from dalembert import kinematicTree as kt
from dalembert.rigidBodyUtilities import HT, RigidBodyInertia, RotationTranslation2T66Inverse, Skew2Vec

rng = np.random.default_rng(2)
N, GRAVITY = 4, np.array([1.0, -2.0, -9.81])
ROTATIONS = [Rotation.random(random_state=i).as_matrix() for i in range(N)]
OFFSETS, COMS = rng.normal(size=(N, 3)), rng.normal(size=(N, 3))
MASSES, INERTIAS = [1.0, 2, 3, 4], [np.diag(rng.uniform(1, 1.5, 3)) for _ in range(N)]  # about the centre of mass
Q, Q_T = rng.normal(size=N), rng.normal(size=N)
TREES = [(["Rx", "Ry", "Rz", "Rx"], []), (["Rx", "Pz", "Ry", "Px"], []), (["Py", "Rz", "Pz", "Ry"], [-1, 0, 0, 2])]


def trees(types, parents):
    X = [RotationTranslation2T66Inverse(A, p) for A, p in zip(ROTATIONS, OFFSETS, strict=True)]
    inertias = [kt.MassCOMinertia2T66(*args) for args in zip(MASSES, COMS, INERTIAS, strict=True)]
    atJoint = [inertia[:3, :3] for inertia in inertias]
    return (
        kt.KinematicTree66(types, X, inertias, parents, GRAVITY),
        kt.KinematicTree33(types, ROTATIONS, OFFSETS, atJoint, COMS, MASSES, parents, GRAVITY),
    )


def frames(types, parents, q):
    result = []
    for i, kind in enumerate(types):
        e = np.eye(3)["xyz".index(kind[1])]
        joint = HT(Rotation.from_rotvec(q[i] * e).as_matrix(), [0, 0, 0]) if kind[0] == "R" else HT(np.eye(3), q[i] * e)
        parent = parents[i] if parents else i - 1
        base = np.eye(4) if parent == -1 else result[parent]
        result.append(base @ HT(ROTATIONS[i], OFFSETS[i]) @ joint)
    return result


def mass_matrix(types, parents, q, h=1e-4):
    M = np.zeros((N, N))
    T = frames(types, parents, q)
    ends = [(frames(types, parents, q + h * e), frames(types, parents, q - h * e)) for e in np.eye(N)]
    for i in range(N):
        T_q = [(plus[i] - minus[i]) / (2 * h) for plus, minus in ends]
        velocity = np.array([D[:3, :3] @ COMS[i] + D[:3, 3] for D in T_q])
        omega = np.array([Skew2Vec(T[i][:3, :3].T @ D[:3, :3]) for D in T_q])
        M += MASSES[i] * velocity @ velocity.T + omega @ INERTIAS[i] @ omega.T
    return M


def potential(types, parents, q):
    centres = [T[:3, :3] @ com + T[:3, 3] for T, com in zip(frames(types, parents, q), COMS, strict=True)]
    return -sum(m * GRAVITY @ c for m, c in zip(MASSES, centres, strict=True))


@pytest.mark.parametrize(("types", "parents"), TREES)
def test_equations_of_motion_are_those_of_lagrange(types, parents):
    h = 1e-3

    def gradient(function):
        steps = h * np.eye(N)
        return [(function(types, parents, Q + e) - function(types, parents, Q - e)) / (2 * h) for e in steps]

    dM, dV = gradient(mass_matrix), gradient(potential)
    M_t = sum(D * rate for D, rate in zip(dM, Q_T, strict=True))
    expected = M_t @ Q_T - 0.5 * np.array([Q_T @ D @ Q_T for D in dM]) + dV
    for tree in trees(types, parents):
        M, f = tree.ComputeMassMatrixAndForceTerms(Q, Q_T)
        np.testing.assert_allclose(M, mass_matrix(types, parents, Q), atol=1e-5)
        np.testing.assert_allclose(f, expected, atol=2e-3)
        q_tt = tree.ForwardDynamicsCRB(Q, Q_T, torques=np.arange(N))
        np.testing.assert_allclose(M @ q_tt + f, np.arange(N), atol=1e-9)


@pytest.mark.parametrize(("types", "parents"), TREES)
def test_external_forces_do_the_work_of_forces_on_the_links(types, parents):
    """A force F at the ground origin on each link, as wrench [0, F] in ground coordinates."""
    h, force = 1e-5, np.array([0.0, 0, 0, 1, 2, 3])
    tree, _ = trees(types, parents)
    f0 = tree.ComputeMassMatrixAndForceTerms(Q, 0 * Q)[1]
    f = tree.ComputeMassMatrixAndForceTerms(Q, 0 * Q, [force] * N)[1]
    T = frames(types, parents, Q)
    for k, e in enumerate(np.eye(N)):
        plus, minus = frames(types, parents, Q + h * e), frames(types, parents, Q - h * e)
        touched = [(p - m) / (2 * h) @ np.linalg.inv(t) @ [0, 0, 0, 1] for p, m, t in zip(plus, minus, T, strict=True)]
        assert f[k] - f0[k] == pytest.approx(sum(force[3:] @ v[:3] for v in touched), abs=1e-7)


def test_inertia_conversions():
    I66 = kt.MassCOMinertia2T66(2, COMS[0], INERTIAS[0])
    mass, com, J = kt.Inertia66toMassCOMinertia(I66)
    assert mass == 2
    np.testing.assert_allclose(com, COMS[0])
    np.testing.assert_allclose(J, INERTIAS[0], atol=1e-12)
    body = RigidBodyInertia(2, INERTIAS[0], COMS[0], inertiaTensorAtCOM=True)
    np.testing.assert_allclose(kt.Inertia2T66(body), I66, atol=1e-12)


def test_cross_products_are_dual():
    v, m, f = rng.normal(size=(3, 6))
    np.testing.assert_allclose((kt.CRM(v) @ m) @ f, -m @ (kt.CRF(v) @ f))
    np.testing.assert_allclose(kt.CRM(v) @ v, 0, atol=1e-12)


def test_wrong_trees_are_refused():
    types = ["Rz"] * N
    X, J = [np.eye(6)] * N, [np.eye(6)] * N
    with pytest.raises(ValueError, match=r"listOfParents\[1\]: expected a parent index from -1 to 0, received 1"):
        kt.KinematicTree66(types, X, J, [-1, 1, 0, 0])
    with pytest.raises(ValueError, match="listOfInertias: expected 4 entries"):
        kt.KinematicTree66(types, X, J[1:])
    with pytest.raises(ValueError, match="jointType: expected one of Rx"):
        kt.JointTransformMotionSubspace("Q", 0)
    with pytest.raises(ValueError, match="q_t: expected a vector with 4 components"):
        kt.KinematicTree66(types, X, J).ComputeMassMatrixAndForceTerms(Q, [0])


@pytest.mark.parametrize("axis", "XYZ")
def test_inverse_transformations(axis):
    for kind in ("Rotation", "Translation"):
        from dalembert import rigidBodyUtilities as rbu

        X = getattr(rbu, f"{kind}{axis}2T66")(0.7)
        np.testing.assert_allclose(getattr(kt, f"{kind}{axis}2T66Inverse")(0.7) @ X, np.eye(6), atol=1e-14)
