"""Involute functions, gear outlines and bearing dimensions."""

import warnings

import numpy as np
import pytest

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
    if internal:  # the spaces between the teeth are pointed
        assert gear.pitchRadius < radius.max() < gear.outerRadius
    else:
        assert radius.max() == pytest.approx(gear.outerRadius)
    above = radius > gear.pitchRadius
    assert np.count_nonzero(above != np.roll(above, 1)) == 48
    assert np.linalg.norm(np.diff(outline, axis=0), axis=1).min() >= gear.tolerance


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
