"""Involute functions, gear outlines and bearing dimensions."""

import warnings

import numpy as np
import pytest
from matplotlib.path import Path

from dalembert import machines


@pytest.mark.parametrize("y", [0.0, 1e-12, 1e-5, 0.02, 0.49, 0.51, 1.0, 1.977, 2.1, 50, 1e4, -0.3, -1.9])
def test_inverse_involute(y):
    assert machines.Involute(machines.InvInvolute(y)) == pytest.approx(y, rel=1e-8, abs=1e-15)


def test_involute_series_fits_at_its_limit():
    assert machines.ApproxInvolute(0.02) == pytest.approx(np.tan(0.02) - 0.02, rel=1e-9)


@pytest.mark.parametrize("internal", [False, True])
def test_gear_outline_has_teeth_between_root_and_tip(internal):
    gear = machines.InvoluteGear(module=0.1, nTeeth=24, isInternalGear=internal)
    outline = gear.GenerateGear()
    radius = np.linalg.norm(outline, axis=1)
    assert radius.min() == pytest.approx(gear.rootRadius)
    assert radius.max() == pytest.approx(gear.outerRadius)
    above = radius > gear.pitchRadius
    assert np.count_nonzero(above != np.roll(above, 1)) == 48
    assert np.linalg.norm(np.diff(outline, axis=0), axis=1).min() >= gear.tolerance


@pytest.mark.parametrize("internal", [False, True])
@pytest.mark.parametrize("steps", [100, 1000])
def test_flanks_are_involutes_at_the_analytic_angle(internal, steps):
    """A flank is at half the width of the tooth at the pitch circle plus inv(20 deg) - inv(alpha), with
    cos(alpha) = base radius / radius; the space of an internal gear has the outline of a tooth. Any number of steps
    gives points of the exact curve."""
    backlash = 0.01
    gear = machines.InvoluteGear(0.1, 24, backlash=backlash, maxSteps=steps, isInternalGear=internal)
    x, y = gear.GenerateTooth()
    radius, angle = np.hypot(x, y), np.abs(np.arctan2(y, x))
    flank = (radius > max(gear.baseRadius, gear.rootRadius) * (1 + 1e-9)) & (radius < gear.outerRadius * (1 - 1e-9))
    assert np.count_nonzero(flank) > steps / 50
    width = np.pi * 0.1 / 2 + (0.5 if internal else -0.5) * backlash
    alpha = np.arccos(gear.baseRadius / radius[flank])
    exact = 0.5 * width / gear.pitchRadius + machines.Involute(np.radians(20)) - (np.tan(alpha) - alpha)
    np.testing.assert_allclose(angle[flank], exact, rtol=0, atol=1e-12)


def distance_to(outline, points):
    """Return the distance of each point to an outline."""
    side = np.roll(outline, -1, axis=0) - outline
    along = np.clip(((points[:, None] - outline) * side).sum(2) / (side**2).sum(1), 0, 1)
    return np.linalg.norm(points[:, None] - outline - along[..., None] * side, axis=2).min(1, initial=np.inf)


@pytest.mark.parametrize("internal", [False, True])
def test_meshing_gears_touch_and_do_not_overlap(internal):
    """Gears turn by the ratio of their teeth. Without backlash, flanks touch at any angle: chords of 0.16 mm of a curve
    with a radius of 20 mm are 0.2 micrometers off. The outline of the internal gear is that of its hollow."""
    pinion = machines.InvoluteGear(4e-3, 30, arcStepSize=4e-4, maxSteps=400)
    gear = machines.InvoluteGear(4e-3, 75, arcStepSize=4e-4, maxSteps=400, isInternalGear=internal)
    distance = gear.pitchRadius + (-1 if internal else 1) * pinion.pitchRadius
    for turn in np.linspace(0, pinion.angleToothAndGap, 4):
        small = pinion.GenerateGear() @ pinion.RotationMatrix2D(turn).T + [distance, 0]
        angle = 0.4 * turn if internal else 0.5 * gear.angleToothAndGap - 0.4 * turn  # a gap is where a tooth is
        large = gear.GenerateGear() @ gear.RotationMatrix2D(angle).T
        near = small[np.linalg.norm(small - [gear.pitchRadius, 0], axis=1) < 0.02]
        away = distance_to(large, near)
        wrong = Path(large).contains_points(near) != internal
        assert away[wrong].max(initial=0) < 1e-6
        assert away.min() < 1e-6


def test_gear_helpers():
    gear = machines.InvoluteGear()
    point = gear.PolarToCartesian([2, 0.3])
    np.testing.assert_allclose(gear.CartesianToPolar(point), [2, 0.3])
    np.testing.assert_allclose(gear.RotationMatrix2D(0.1) @ gear.PolarToCartesian([2, 0.2]), point)
    fillet = machines.InvoluteGear(nTeeth=20, fillet=0.2, arcStepSize=0.01).GenerateHalfRoot()
    radius = np.linalg.norm(fillet, axis=0)
    assert radius[0] == pytest.approx(9 - 0.157 + 0.2)
    assert radius[-1] == pytest.approx(9 - 0.157)
    with pytest.raises(ValueError, match="does not reach the middle of the tooth"):
        machines.InvoluteGear(nTeeth=20, maxSteps=2).GenerateGear()


def test_bearing_grooves_touch_the_balls():
    data = machines.GetBallBearingData([0, 0, 2], 0.08, 0.04, 0.02, 6, radiusBalls=0.005, ballsAngleOffset=0.1)
    positions = np.array(data["ballPositions"])
    np.testing.assert_allclose(data["axis"], [0, 0, 1])
    np.testing.assert_allclose(np.linalg.norm(positions, axis=1), 0.03)
    np.testing.assert_allclose(positions[:, 2], 0, atol=1e-15)
    first = np.arctan2(positions[0, 1], positions[0, 0])
    assert abs(first) == pytest.approx(0.1)
    assert data["innerGrooveTorusRadius"] - data["innerGrooveRadius"] == pytest.approx(0.025)
    assert data["outerGrooveTorusRadius"] + data["outerGrooveRadius"] == pytest.approx(0.035)


def test_balls_that_do_not_fit_are_announced():
    """The default is that of Exudyn, balls of 16 mm between radii that are 13.5 mm apart; those of type 6204 have 8 mm."""
    bearing = {"axis": [1, 0, 0], "outsideDiameter": 0.047, "boreDiameter": 0.02, "width": 0.014, "nBalls": 8}
    with pytest.warns(UserWarning, match="radiusBalls: balls of radius 0.00783 m .* do not fit .* usual is 0.003915 m"):
        machines.GetBallBearingData(**bearing)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        machines.GetBallBearingData(**bearing, radiusBalls=7.938e-3 / 2)


def test_numbers_of_involutes_that_are_none_are_named():
    for function in (machines.Involute, machines.ApproxInvolute, machines.InvInvolute):
        with pytest.raises(ValueError, match=rf"{function.__name__}: .: expected a finite number, received None"):
            function(None)
    for name in ("pressureAngleDeg", "backlash", "dedendumFactor", "addendumFactor"):
        with pytest.raises(ValueError, match=f"InvoluteGear: {name}: expected a finite number"):
            machines.InvoluteGear(**{name: "text"})
