"""Friction laws and stresses."""

import numpy as np
import pytest

from dalembert import physics


def test_stribeck_curve():
    law = lambda v: physics.StribeckFunction(v, 0.3, 0.1, 0.05, expVel=0.01, regVel=0.001)  # noqa: E731
    assert law(0.0005) == pytest.approx(0.2)
    assert law(0.001) == pytest.approx(0.4)
    assert law(0.011) == pytest.approx(0.3 + 0.1 / np.e + 0.05 * 0.01)
    assert law(-2) == -law(2) == pytest.approx(-(0.3 + 0.05 * 1.999))
    assert physics.StribeckFunction(0, 0.3, 0.1, regVel=0) == 0


def test_regularized_friction_is_continuous_and_odd():
    law = lambda v: physics.RegularizedFriction(v, 0.3, 0.1, 0.01, 0.2, muViscous=0.5)  # noqa: E731
    assert [law(v) for v in (0, 0.01, 0.2, 1.2)] == pytest.approx([0, 0.4, 0.3, 0.8])
    for v in (0.005, 0.01, 0.1, 0.2, 0.7):
        assert law(-v) == pytest.approx(-law(v))
        assert law(v + 1e-9) == pytest.approx(law(v - 1e-9), abs=1e-6)
    assert physics.RegularizedFrictionStep(0.5, 0, 2, 1, 6) == 4
    assert physics.RegularizedFrictionStep(-1, 0, 2, 1, 6) == 2
    assert physics.RegularizedFrictionStep(3, 0, 2, 1, 6) == 6


class Sensors:
    def GetSensorValues(self, sensor, configuration):
        return sensor


def test_von_mises_stress_against_the_deviator():
    stress = np.random.default_rng(1).normal(size=(5, 6))
    for s, mises in zip(stress, physics.VonMisesStress(stress), strict=True):
        tensor = np.array([[s[0], s[5], s[4]], [s[5], s[1], s[3]], [s[4], s[3], s[2]]])
        deviator = tensor - np.trace(tensor) / 3 * np.eye(3)
        assert mises == pytest.approx(np.sqrt(1.5) * np.linalg.norm(deviator))
        assert physics.VonMisesStress(s) == pytest.approx(mises)
    assert physics.UFvonMisesStress(Sensors(), 0, [stress[0], 9.0], [], None) == [9]
    assert physics.UFvonMisesStress(Sensors(), 0, list(stress), [], None)[0] == physics.VonMisesStress(stress).max()
    with pytest.raises(ValueError, match="stress6D: expected 6 stress components"):
        physics.VonMisesStress([1, 2, 3])
