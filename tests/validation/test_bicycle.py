"""Whipple bicycle: published eigenvalues of small motions, and energy in the manoeuvres of the IFToMM benchmark."""

from __future__ import annotations

import numpy as np
import pytest
from bicycle import BASE, FRONT, REAR, Bicycle, eigenvalues
from scipy.optimize import brentq
from solving import Variable

PUBLISHED = {
    0.0: [-5.5309437177, -3.1316432479, 3.1316432479, 5.5309437177],
    5.0: [-14.0783896928, -0.7753418822 - 4.4648677138j, -0.7753418822 + 4.4648677138j, -0.322866429],
}
WEAVE, CAPSIZE = 4.29238253634111, 6.02426201538837
MANOEUVRES = [(4.0, 0.05), (4.6, 0.5), (8.0, 0.05)]  # speed, rate of roll
each_manoeuvre = pytest.mark.parametrize(("speed", "roll_rate"), MANOEUVRES)


@pytest.mark.parametrize("speed", PUBLISHED)
def test_eigenvalues(speed: float) -> None:
    """The map of a step of 0.25 ms has errors of second order, (14 / 4000)^2 / 12 = 1e-6 of each eigenvalue; divided by the small
    part that the slow motion has in the samples, 3e-5."""
    np.testing.assert_allclose(eigenvalues(speed), PUBLISHED[speed], rtol=0, atol=1e-4)


@pytest.mark.parametrize(("published", "oscillates"), [(WEAVE, True), (CAPSIZE, False)], ids=["weave", "capsize"])
def test_limits_of_stability(published: float, oscillates: bool) -> None:
    """Errors of 3e-5 in an eigenvalue that changes by 0.2 to 1.7 per m/s."""

    def slowest(speed: float) -> float:
        values = eigenvalues(speed)
        return float(values[(np.abs(values.imag) > 1) == oscillates].real.max())

    speed = brentq(slowest, published - 0.1, published + 0.1, xtol=1e-5, rtol=1e-5)
    assert speed == pytest.approx(published, abs=3e-4)


@each_manoeuvre
def test_energy(speed: float, roll_rate: float) -> None:
    """The benchmark asks for a drift below 1e-3 percent. The trapezoidal rule has a relative error of about (omega h)^2
    / 12 of the exchanged energy."""
    bicycle = Bicycle(speed, roll_rate)
    bicycle.ride(5.0, 2500)
    energy = bicycle.energy()
    assert 100 * np.ptp(energy) / energy[0] < 1e-4
    assert np.ptp(energy) > 1e-13 * energy[0]


@each_manoeuvre
def test_discs_stay_on_the_plane(speed: float, roll_rate: float) -> None:
    """Normal directions are constrained by velocities; positions drift with the second order of the method."""
    bicycle = Bicycle(speed, roll_rate)
    bicycle.ride(2.0, 1000)
    for name, radius in (("rear wheel", REAR), ("front wheel", FRONT)):
        body = bicycle.bodies[name]
        centre = bicycle.mbs.GetObjectOutputBody(body, Variable.Position, [0, 0, 0])
        axis = np.reshape(bicycle.mbs.GetObjectOutputBody(body, Variable.RotationMatrix, [0, 0, 0]), (3, 3))[:, 1]
        assert centre[2] == pytest.approx(radius * np.hypot(axis[0], axis[1]), abs=1e-6)
    rear = bicycle.mbs.GetObjectOutputBody(bicycle.bodies["rear wheel"], Variable.Position, [0, 0, 0])
    front = bicycle.mbs.GetObjectOutputBody(bicycle.bodies["front wheel"], Variable.Position, [0, 0, 0])
    assert np.linalg.norm(front - rear) == pytest.approx(np.hypot(BASE, FRONT - REAR), abs=2e-3)
