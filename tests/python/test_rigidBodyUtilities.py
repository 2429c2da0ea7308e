"""Rotations, transformations and inertia against scipy, numerical differentiation and point clouds."""

import types
import warnings

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.linalg import expm
from scipy.spatial.transform import Rotation

from dalembert import rigidBodyUtilities as rbu

unit = st.floats(-1, 1, allow_subnormal=False)
vectors = st.tuples(unit, unit, unit).map(np.array)
angles = st.tuples(*[st.floats(-3, 3)] * 3).map(np.array)
rotations = st.integers(0, 10**6).map(lambda seed: Rotation.random(random_state=seed))


def vee(S):
    return np.array([S[2, 1], S[0, 2], S[1, 0]])


def rate_of(function, x, direction, h=1e-5):
    return (function(x + h * direction) - function(x - h * direction)) / (2 * h)


def close(actual, desired, atol=1e-12):
    np.testing.assert_allclose(actual, desired, rtol=0, atol=atol)


@given(vectors, vectors)
def test_skew_is_the_cross_product(v, w):
    close(rbu.Skew(v) @ w, np.cross(v, w))
    close(rbu.Skew2Vec(rbu.Skew(v)), v, 0)


def test_skew2vec_of_se3_has_translation_first():
    S = np.zeros((4, 4))
    S[:3, :3], S[:3, 3] = rbu.Skew([4, 5, 6]), [1, 2, 3]
    close(rbu.Skew2Vec(S), [1, 2, 3, 4, 5, 6], 0)


def test_skew_matrix_of_many_vectors_is_stacked():
    v = np.arange(1.0, 13).reshape(6, 2)
    expected = np.block([[rbu.Skew(v[3 * i : 3 * i + 3, j]) for j in range(2)] for i in range(2)])
    close(rbu.ComputeSkewMatrix(v), expected, 0)
    close(rbu.ComputeSkewMatrix(v[:, 0].tolist()), expected[:, :3], 0)


@pytest.mark.parametrize("v", [[1, 0, 0], [0, -2, 0], [0, 0, 3], [0.6, 0.05, 0.05], [1, 2, 3]])
def test_orthonormal_basis(v):
    A = rbu.ComputeOrthonormalBasis(v)
    close(A.T @ A, np.eye(3))
    close(np.linalg.det(A), 1)
    close(A[:, 0] * np.linalg.norm(v), v)
    close(rbu.ComputeOrthonormalBasisVectors(v), A.T, 0)


def test_gram_schmidt_is_right_handed_and_refuses_parallel_vectors():
    close(rbu.GramSchmidt([0, 0, 2], [3, 0, 5]), [[0, 0, 1], [1, 0, 0], [0, 1, 0]])
    with pytest.raises(ValueError, match="vector1: expected a vector not parallel"):
        rbu.GramSchmidt([0, 0, 2], [0, 0, -1])


@given(rotations)
def test_parameters_of_rotation_matrix_against_scipy(rotation):
    A = rotation.as_matrix()
    p = rbu.RotationMatrix2EulerParameters(A)
    close(p, rotation.as_quat(canonical=True, scalar_first=True))
    close(rbu.EulerParameters2RotationMatrix(p), A)
    close(rbu.RotationMatrix2RotationVector(A), rotation.as_rotvec(), 1e-10)
    close(rbu.RotationMatrix2RotXYZ(A), rotation.as_euler("XYZ"), 1e-10)
    close(rbu.RotationMatrix2RotZYZ(A, False), rotation.as_euler("ZYZ"), 1e-10)
    flipped = rbu.RotationMatrix2RotZYZ(A, True)
    assert flipped[1] <= 0
    close(Rotation.from_euler("ZYZ", flipped).as_matrix(), A)


@pytest.mark.parametrize("axis", [[1, 0, 0], [0, 1, 0], [0, 0, 1], [0.6, 0, 0.8], [0.6, -0.8, 0]])
def test_half_turn_is_recovered(axis):
    A = 2 * np.outer(axis, axis) - np.eye(3)
    v = rbu.RotationMatrix2RotationVector(A)
    close(np.linalg.norm(v), np.pi)
    close(rbu.RotationVector2RotationMatrix(v), A)


@pytest.mark.parametrize("sign", [1, -1])
def test_gimbal_position_keeps_the_matrix(sign):
    A = rbu.RotXYZ2RotationMatrix([0.3, sign * np.pi / 2, 0.9])
    rot = rbu.RotationMatrix2RotXYZ(A)
    assert rot[0] == 0
    close(rbu.RotXYZ2RotationMatrix(rot), A)


@given(angles)
def test_tait_bryan_angles_against_scipy(rot):
    A = Rotation.from_euler("XYZ", rot).as_matrix()
    close(rbu.RotXYZ2RotationMatrix(rot), A)
    p = rbu.RotXYZ2EulerParameters(rot)
    close(rbu.EulerParameters2RotationMatrix(p), A)
    assert (p @ rbu.RotXYZ2EulerParameters(rot + 1e-3)) > 0.99  # no jump of the sign


@given(st.floats(0, 50), vectors)
def test_rotation_vector_of_any_size_is_the_matrix_exponential(angle, v):
    w = angle * v
    close(rbu.RotationVector2RotationMatrix(w), expm(rbu.Skew(w)), 1e-9)


@given(angles, vectors)
def test_rate_matrices_of_angles_give_the_angular_velocity(rot, rot_t):
    A = rbu.RotXYZ2RotationMatrix(rot)
    A_t = rate_of(rbu.RotXYZ2RotationMatrix, rot, rot_t)
    close(rbu.RotXYZ2G(rot) @ rot_t, vee(A_t @ A.T), 1e-8)
    close(rbu.RotXYZ2GLocal(rot) @ rot_t, vee(A.T @ A_t), 1e-8)
    close(rbu.RotXYZ2G_t(rot, rot_t), rate_of(rbu.RotXYZ2G, rot, rot_t), 1e-8)
    close(rbu.RotXYZ2GLocal_t(rot, rot_t), rate_of(rbu.RotXYZ2GLocal, rot, rot_t), 1e-8)
    if abs(np.cos(rot[1])) > 1e-2:
        close(rbu.AngularVelocity2RotXYZ_t(rbu.RotXYZ2G(rot) @ rot_t, rot), rot_t, 1e-10)


def test_angle_rates_in_gimbal_position():
    rot = [0.4, np.pi / 2, 0]
    close(rbu.AngularVelocity2RotXYZ_t([0, 0, 0], rot), 0, 0)
    close(rbu.AngularVelocity2RotXYZ_t([2, np.cos(0.4), np.sin(0.4)], rot), [2, 1, 0])
    with pytest.raises(ValueError, match="singular"):
        rbu.AngularVelocity2RotXYZ_t([0, -np.sin(0.4), np.cos(0.4)], rot)


@given(rotations, vectors)
def test_rate_matrices_of_euler_parameters(rotation, omega):
    p = rotation.as_quat(canonical=True, scalar_first=True)
    p_t = rbu.AngularVelocity2EulerParameters_t(omega, p)
    close(p @ p_t, 0)
    A = rbu.EulerParameters2RotationMatrix(p)
    A_t = rate_of(rbu.EulerParameters2RotationMatrix, p, p_t)
    close(vee(A_t @ A.T), omega, 1e-8)
    close(rbu.EulerParameters2G(p) @ p_t, omega)
    close(rbu.EulerParameters2GLocal(p) @ p_t, A.T @ omega)


def test_rotation_vector_rates_are_local_angular_velocities():
    v = [0.1, 0.2, 0.3]
    close(rbu.RotationVector2GLocal(v), np.eye(3), 0)
    close(rbu.RotationVector2G(v), Rotation.from_rotvec(v).as_matrix())
    close(rbu.ComputeRotationAxisFromRotationVector([0, 3, 4]), [0, 0.6, 0.8])
    close(rbu.ComputeRotationAxisFromRotationVector([0, 0, 0]), 0, 0)


@given(rotations, vectors, vectors)
def test_homogeneous_transformations(rotation, r, x):
    A = rotation.as_matrix()
    T = rbu.HT(A, r)
    close((T @ [*x, 1])[:3], A @ x + r)
    close(rbu.InverseHT(T) @ T, np.eye(4))
    close(rbu.HT2rotationMatrix(T), A, 0)
    close(rbu.HT2translation(T), r, 0)


@pytest.mark.parametrize("axis", "XYZ")
def test_elementary_transformations(axis):
    k = "XYZ".index(axis)
    A = Rotation.from_euler(axis, 0.7).as_matrix()
    e = np.eye(3)[k]
    close(getattr(rbu, "RotationMatrix" + axis)(0.7), A)
    close(getattr(rbu, "HTrotate" + axis)(0.7), rbu.HT(A, [0, 0, 0]))
    close(getattr(rbu, "HTtranslate" + axis)(0.7), rbu.HTtranslate(0.7 * e), 0)
    close(getattr(rbu, f"Rotation{axis}2T66")(0.7), np.kron(np.eye(2), A))
    expected = np.eye(6)
    expected[3:, :3] = -rbu.Skew(0.7 * e)
    close(getattr(rbu, f"Translation{axis}2T66")(0.7), expected, 0)


@given(rotations, vectors)
def test_spatial_transformations_and_their_inverses(rotation, v):
    A = rotation.as_matrix()
    X = rbu.RotationTranslation2T66(A, v)
    close(X[3:, :3], rbu.Skew(v) @ A)
    Xinv = rbu.RotationTranslation2T66Inverse(A, v)
    close(X @ Xinv, np.eye(6))
    close(rbu.T66Inverse(X), Xinv)
    for function, matrix in ((rbu.T66toRotationTranslation, X), (rbu.InverseT66toRotationTranslation, Xinv)):
        A2, v2 = function(matrix)
        close(A2, A)
        close(v2, v)
    close(rbu.T66toHT(X), rbu.HT(A, v))
    close(rbu.HT2T66Inverse(rbu.HT(A, v)), Xinv)


def cloud(seed=3, n=40):
    rng = np.random.default_rng(seed)
    return rng.uniform(0.1, 1, n), rng.normal(size=(n, 3))


def inertia_of(masses, points):
    J = sum(m * (x @ x * np.eye(3) - np.outer(x, x)) for m, x in zip(masses, points, strict=True))
    return rbu.RigidBodyInertia(masses.sum(), J, masses @ points / masses.sum())


def same(a, b):
    close(a.Mass(), b.Mass())
    close(a.COM(), b.COM())
    close(a.Inertia(), b.Inertia(), 1e-10)


@given(rotations, vectors)
def test_moved_inertia_is_the_inertia_of_moved_points(rotation, r):
    masses, points = cloud()
    A, body = rotation.as_matrix(), inertia_of(masses, points)
    same(body.Translated(r), inertia_of(masses, points + r))
    same(body.Transformed(rbu.HT(A, r)), inertia_of(masses, points @ A.T + r))
    centred = points - body.COM()
    same(rbu.RigidBodyInertia(body.Mass(), body.InertiaCOM()).Rotated(A), inertia_of(masses, centred @ A.T))
    same(rbu.RigidBodyInertia(body.Mass(), body.InertiaCOM(), body.COM(), inertiaTensorAtCOM=True), body)
    other = rbu.RigidBodyInertia()
    other.SetWithCOMinertia(body.Mass(), body.InertiaCOM(), body.COM())
    same(other, body)


def test_sum_of_inertias_is_the_inertia_of_all_points():
    masses, points = cloud()
    total = inertia_of(masses[:10], points[:10])
    total += inertia_of(masses[10:], points[10:])
    same(total, inertia_of(masses, points))


def test_inertia_refusals():
    body = rbu.InertiaSphere(1, 0.1).Translated([1, 0, 0])
    with pytest.raises(ValueError, match=r"Rotated: expected com=\[0,0,0\], received com=\[1.0, 0.0, 0.0\]"):
        body.Rotated(np.eye(3))
    with pytest.raises(ValueError, match="inertiaTensor: expected a 3x3 matrix, received array"):
        rbu.RigidBodyInertia(1, np.eye(2))
    for wrong in ([1, 2], float("nan"), "1"):
        with pytest.raises(ValueError, match="RigidBodyInertia: mass: expected a finite number"):
            rbu.RigidBodyInertia(wrong)
    with pytest.raises(ValueError, match="RigidBodyInertia: inertiaTensor: expected a tensor of finite numbers"):
        rbu.RigidBodyInertia(1, np.full((3, 3), np.nan))
    with pytest.raises(ValueError, match="either mass or density"):
        rbu.InertiaSphere(1, 2, 3)
    with pytest.raises(ValueError, match="axis: expected 0, 1 or 2"):
        rbu.InertiaCylinder(1, 1, 1, axis=3)
    with pytest.raises(ValueError, match="masses cancel"):
        body - rbu.InertiaMassPoint(1)
    with pytest.warns(UserWarning, match="triangle inequality"):
        rbu.RigidBodyInertia(1, np.diag([1.0, 1.0, 3.0]))
    with pytest.warns(UserWarning, match="not symmetric"):
        rbu.RigidBodyInertia(1, np.eye(3) + np.eye(3, k=1))


def sampled(inside, bounds, density):
    n = 120
    h = 2 * np.array(bounds) / n
    axes = [-b + d * (np.arange(n) + 0.5) for b, d in zip(bounds, h, strict=True)]
    points = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 3)
    points = points[inside(points)]
    mass = density * h.prod() * np.ones(len(points))
    J = mass.sum() * (np.mean((points**2).sum(1)) * np.eye(3) - points.T @ points / len(points))
    return mass.sum(), J


@pytest.mark.parametrize(
    ("body", "inside", "bounds"),
    [
        (rbu.InertiaCuboid(7, [0.2, 0.4, 0.6]), lambda p: p[:, 0] < 9, [0.1, 0.2, 0.3]),
        (rbu.InertiaSphere(radius=0.5, density=7), lambda p: (p**2).sum(1) < 0.25, [0.5] * 3),
        (
            rbu.InertiaCylinder(7, 0.8, 0.5, axis=1, innerRadius=0.2),
            lambda p: np.abs(p[:, 0] ** 2 + p[:, 2] ** 2 - 0.145) < 0.105,
            [0.5, 0.4, 0.5],
        ),
    ],
)
def test_inertia_of_shapes_against_sampled_volume(body, inside, bounds):
    mass, J = sampled(inside, bounds, density=7)
    assert body.Mass() == pytest.approx(mass, rel=2e-3)
    np.testing.assert_allclose(body.Inertia(), J, atol=3e-3 * np.max(J))


def test_thin_shapes():
    close(np.diag(rbu.InertiaRodX(3, 2).Inertia()), [0, 1, 1])
    directions = np.random.default_rng(0).normal(size=(200000, 3))
    points = 0.3 * directions / np.linalg.norm(directions, axis=1)[:, None]
    J = 2 * (0.09 * np.eye(3) - points.T @ points / len(points))
    np.testing.assert_allclose(rbu.InertiaHollowSphere(2, 0.3).Inertia(), J, atol=1e-3)
    assert rbu.InertiaMassPoint(2).GetInertia6D() == [0] * 6


def test_inertia_components_are_sorted_for_rigid_bodies():
    J = np.array([[1, 6, 5], [6, 2, 4], [5, 4, 3]])
    assert rbu.InertiaTensor2Inertia6D(J) == [1, 2, 3, 4, 5, 6]
    close(rbu.Inertia6D2InertiaTensor([1, 2, 3, 4, 5, 6]), J, 0)


@pytest.mark.parametrize(
    ("call", "text"),
    [
        (lambda: rbu.Skew([1, 2]), "vector: expected a vector with 3 components, received"),
        (lambda: rbu.EulerParameters2G([1, 0, 0]), "eulerParameters: expected a vector with 4 components"),
        (lambda: rbu.RotationMatrix2EulerParameters(np.eye(4)), "rotationMatrix: expected a 3x3 matrix"),
        (lambda: rbu.InverseHT(np.eye(3)), "T: expected a 4x4 matrix"),
        (lambda: rbu.T66toHT("a"), "T66: expected a 6x6 matrix, received 'a'"),
        (lambda: rbu.ComputeSkewMatrix([1, 2, 3, 4]), "3\\*n components"),
        (lambda: rbu.Skew2Vec(np.eye(2)), "skew: expected a 3x3 or 4x4 matrix"),
    ],
)
def test_wrong_shapes_name_argument_expected_and_received(call, text):
    with pytest.raises(ValueError, match=text):
        call()


class Recorder:
    """A MainSystem that stores added items; bodies are at fixed frames."""

    def __init__(self, frames=()):
        self.items, self.frames = [], frames

    def add(self, item):
        self.items.append(item)
        return len(self.items) - 1

    AddNode = AddObject = AddMarker = AddLoad = add

    def GetObjectOutputBody(self, body, variable, localPosition, configuration):
        A, r = self.frames[body]
        return r if variable == "Position" else A.flatten()


@pytest.fixture
def items(monkeypatch):
    import sys

    import dalembert

    fake = types.ModuleType("dalembert.itemInterface")
    fake.__getattr__ = lambda name: lambda **arguments: types.SimpleNamespace(kind=name, **arguments)
    monkeypatch.setitem(sys.modules, "dalembert.itemInterface", fake)
    monkeypatch.setattr(dalembert, "itemInterface", fake, raising=False)
    names = types.SimpleNamespace
    output = names(Position="Position", RotationMatrix="RotationMatrix")
    monkeypatch.setattr(dalembert, "OutputVariableType", output, raising=False)
    monkeypatch.setattr(dalembert, "ConfigurationType", names(Reference=3), raising=False)
    members = {"RotationRxyz": 256, "_None": 0}
    monkeypatch.setattr(dalembert, "NodeType", names(__members__=members), raising=False)


@pytest.mark.usefixtures("items")
def test_rigid_body_nodes_start_with_the_given_motion():
    A, omega = Rotation.from_euler("XYZ", [0.3, -0.4, 1.2]).as_matrix(), np.array([1.0, 2, 3])
    arguments = {"position": [1, 2, 3], "velocity": [4, 5, 6], "rotationMatrix": A, "angularVelocity": omega}
    cases = {
        "NodeType.RotationEulerParameters": (rbu.EulerParameters2RotationMatrix, rbu.EulerParameters2G),
        "RotationRxyz": (rbu.RotXYZ2RotationMatrix, rbu.RotXYZ2G),
        "NodeType.LieGroupWithDirectUpdate": (rbu.RotationVector2RotationMatrix, rbu.RotationVector2G),
    }
    for name, (matrix, G) in cases.items():
        node = rbu.GetRigidBodyNode(name, **arguments)
        rotation, rate = node.referenceCoordinates[3:], node.initialVelocities[3:]
        assert node.referenceCoordinates[:3] == [1, 2, 3]
        assert node.initialVelocities[:3] == [4, 5, 6]
        close(matrix(rotation), A)
        close(G(rotation) @ rate, omega)
    with pytest.raises(ValueError, match="either rotationMatrix or rotationParameters"):
        rbu.GetRigidBodyNode("RotationRxyz", rotationParameters=[0, 0, 0], **arguments)
    with pytest.raises(ValueError, match="nodeType: expected one of RotationEulerParameters"):
        rbu.GetRigidBodyNode("Point")


@pytest.mark.usefixtures("items")
def test_add_rigid_body_adds_gravity_only_if_there_is_some():
    mbs = Recorder()
    assert rbu.AddRigidBody(mbs, rbu.InertiaCuboid(1000, [1, 1, 1])) == [0, 1]
    assert mbs.items[1].physicsMass == 1000
    rbu.AddRigidBody(mbs, rbu.InertiaMassPoint(2), gravity=[0, -9.81, 0])
    assert [item.kind for item in mbs.items[4:]] == ["MarkerBodyMass", "LoadMassProportional"]
    with pytest.raises(ValueError, match="inertia: expected a RigidBodyInertia"):
        rbu.AddRigidBody(mbs, 5.0)


@pytest.mark.usefixtures("items")
@pytest.mark.parametrize(("function", "column"), [(rbu.AddRevoluteJoint, 2), (rbu.AddPrismaticJoint, 0)])
def test_joints_have_one_frame_on_both_bodies(function, column):
    A, r = Rotation.from_rotvec([0.1, 0.7, -0.2]).as_matrix(), np.array([1.0, 2, 3])
    frames = [(np.eye(3), np.zeros(3)), (A, r)]
    axis, point = np.array([0, 3, 4]), np.array([0.5, 0, 0])
    for useGlobalFrame, bodies in ((True, [0, 1]), (False, [1, 0])):
        mbs = Recorder(frames)
        with pytest.warns(DeprecationWarning):
            result = function(mbs, *bodies, point=point, axis=axis, useGlobalFrame=useGlobalFrame)
        assert result == [2, 0, 1]
        joint, marker0, marker1 = (mbs.items[i] for i in result)
        (A0, r0), (A1, r1) = (frames[i] for i in bodies)
        close(A0 @ marker0.localPosition + r0, A1 @ marker1.localPosition + r1)
        close(A0 @ joint.rotationMarker0, A1 @ joint.rotationMarker1)
        local = joint.rotationMarker0[:, column]
        close(5 * (A0 @ local if useGlobalFrame else local), axis)
        close(marker0.localPosition, point)
        close(np.linalg.det(joint.rotationMarker0), 1)


@pytest.mark.usefixtures("items")
def test_node_type_from_text():
    assert rbu.StrNodeType2NodeType("NodeType.RotationRxyz") == 256
    with pytest.raises(ValueError, match="expected one of RotationRxyz"):
        rbu.StrNodeType2NodeType("Rotation")


def test_a_difference_cuts_a_hole_without_warning():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        ring = rbu.InertiaCylinder(7, 1, 0.5, 2) - rbu.InertiaCylinder(7, 1, 0.2, 2)
    same(ring, rbu.InertiaCylinder(7, 1, 0.5, 2, innerRadius=0.2))
