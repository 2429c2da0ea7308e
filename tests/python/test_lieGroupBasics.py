"""Exponential maps against scipy's matrix exponential, tangent operators against numerical differentiation."""

import numpy as np
import pytest
from scipy.linalg import expm
from scipy.spatial.transform import Rotation

from dalembert import lieGroupBasics as lie
from dalembert.rigidBodyUtilities import InverseHT, RotXYZ2RotationMatrix, Skew, Skew2Vec

rng = np.random.default_rng(5)
SIZES = [0.0, 1e-9, 1e-4, 0.02, 0.3, 0.99, 1.01, 2.5, 3.1]
AXES = Rotation.random(len(SIZES), random_state=3).as_matrix()[:, 0]
MOTIONS = [np.concatenate([rng.normal(size=3), size * axis]) for size, axis in zip(SIZES, AXES, strict=True)]


def hat(x):
    H = np.zeros((4, 4))
    H[:3, :3], H[:3, 3] = Skew(x[3:]), x[:3]
    return H


def close(a, b, atol=1e-12):
    np.testing.assert_allclose(a, b, rtol=0, atol=atol)


@pytest.mark.parametrize("x", MOTIONS)
def test_exponential_maps_and_logarithms(x):
    w = x[3:]
    R, H = lie.ExpSO3(w), lie.ExpSE3(x)
    close(R, expm(Skew(w)))
    close(H, expm(hat(x)))
    close(lie.LogSO3(R), Skew(w), 1e-9)
    close(lie.LogSE3(H), hat(x), 1e-8)
    close(Rotation.from_quat(lie.ExpS3(w), scalar_first=True).as_matrix(), R)
    G = lie.ExpR3xSO3(x)
    close(lie.R3xSO3Matrix2RotationMatrix(G), R)
    close(lie.R3xSO3Matrix2Translation(G), x[:3], 0)


@pytest.mark.parametrize("x", MOTIONS)
def test_tangent_operators_are_derivatives_of_the_exponential(x):
    h, x_t = 1e-5, np.array([0.3, -0.2, 0.5, 0.7, 0.1, -0.4])
    H_t = (lie.ExpSE3(x + h * x_t) - lie.ExpSE3(x - h * x_t)) / (2 * h)
    close(Skew2Vec(InverseHT(lie.ExpSE3(x)) @ H_t), lie.TExpSE3(x) @ x_t, 1e-8)
    close(lie.TExpSE3(x)[3:, 3:], lie.TExpSO3(x[3:]), 0)
    close(lie.TExpSE3(x) @ lie.TExpSE3Inv(x), np.eye(6), 1e-11)
    close(lie.TExpSO3(x[3:]) @ lie.TExpSO3Inv(x[3:]), np.eye(3), 1e-12)
    close(lie.TExpR3xSO3(x) @ lie.TExpR3xSO3Inv(x), np.eye(6), 1e-12)
    close(lie.TExpR3xSO3(x)[3:, 3:], lie.TExpSO3(x[3:]), 0)


@pytest.mark.parametrize("increment", MOTIONS)
def test_compositions_multiply_transformations(increment):
    x, v = np.array([1.0, 2, 3]), np.array([0.3, -0.6, 0.4])
    R, dR = lie.ExpSO3(v), lie.ExpSO3(increment[3:])
    a = Rotation.from_matrix(R).as_euler("XYZ")
    local = x + R @ lie.ExpSE3(increment)[:3, 3]
    cases = {
        "S3": (lie.ExpS3(v), lambda p: Rotation.from_quat(p, scalar_first=True).as_matrix()),
        "R3RotVec": (v, lie.ExpSO3),
        "R3RotXYZAngles": (a, RotXYZ2RotationMatrix),
    }
    for name, (parameters, matrix) in cases.items():
        q = np.concatenate([x, parameters])
        direct = getattr(lie, "CompositionRuleDirectProductR3And" + name)(q, increment)
        semidirect = getattr(lie, "CompositionRuleSemiDirectProductR3And" + name)(q, increment)
        close(direct[:3], x + increment[:3])
        close(semidirect[:3], local)
        close(direct[3:], semidirect[3:], 0)
        close(matrix(direct[3:]), R @ dR, 1e-11)


def test_angles_stay_close_and_survive_the_gimbal_position():
    alpha = np.array([6.2, 0.1, -9.5])
    assert np.abs(lie.CompositionRuleRotXYZAnglesRotationVector(alpha, [0.1, 0.1, 0.1]) - alpha).max() < 0.3
    alpha = np.array([0.4, np.pi / 2 - 0.1, 0.2])
    local = RotXYZ2RotationMatrix(alpha).T @ RotXYZ2RotationMatrix([0.4, np.pi / 2, 0.7])
    new = lie.CompositionRuleRotXYZAnglesRotationVector(alpha, Rotation.from_matrix(local).as_rotvec())
    close(RotXYZ2RotationMatrix(new), RotXYZ2RotationMatrix([0.4, np.pi / 2, 0.7]), 1e-7)


def test_scalar_functions_and_wrong_sizes():
    assert lie.Sinc(0) == 1
    assert lie.Sinc(2.0) == pytest.approx(np.sinc(2 / np.pi))
    assert lie.Cot(0.5) == pytest.approx(1 / np.tan(0.5))
    with pytest.raises(ValueError, match="x: expected a vector with 6 components"):
        lie.ExpSE3([1, 2, 3])
    with pytest.raises(ValueError, match="q0: expected a vector with 7 components"):
        lie.CompositionRuleDirectProductR3AndS3(np.zeros(6), np.zeros(6))
