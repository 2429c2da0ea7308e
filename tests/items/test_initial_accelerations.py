"""A time integration starts with the accelerations of the equations of motion, differentiated exactly."""

from __future__ import annotations

import numpy as np
import pytest

import dalembert as exu
from dalembert._core import testing
from dalembert.testing.exemptions import NOT_OF_RATES, NOT_OF_VALUES, OUT_OF_THE_PLANE
from dalembert.testing.invariance import accelerations
from dalembert.testing.scenes import ITEMS, of_one_coordinate, rests
from dalembert.testing.variants import Variant
from dalembert.testing.virtual_work import CONSTRAINTS


def has_motion(variant: Variant) -> bool:
    """Equations that leave a motion, and that are independent at the start."""
    item = ITEMS[variant.item]
    flat = variant.planar and "Orientation" in item.requested_markers and not item.scene.planar
    flat |= variant.planar and item.name in OUT_OF_THE_PLANE
    fixed = any(rests(c) for _, c in variant.pairs) and "Coordinate" not in item.requested_markers
    return not (flat or fixed)


# Functions of time are outside the solver's equations for the start; the rate of a rotation coordinate is not the rate of its
# value.
START = [v for v in CONSTRAINTS if has_motion(v) and not v.functions and not v.uses & {*NOT_OF_VALUES, *NOT_OF_RATES}]


def fulfil_constraints_of_velocities(mbs: exu.MainSystem) -> None:
    """Take the least velocities off that make such equations hold, which are linear in the velocities; other equations
    are not changed."""
    s = testing.State(mbs)
    n, first = len(s.q), len(s.q) + len(s.y)
    slopes = testing.tangent(mbs, s, cq=0, cv=1, ca=0)[first:, :n]
    rows = slopes.any(axis=1)
    off = np.linalg.lstsq(slopes[rows], testing.gaps(mbs, s)[rows], rcond=None)[0]
    for configuration in (exu.ConfigurationType.Initial, exu.ConfigurationType.Current):
        mbs.systemData.SetODE2Coordinates_t(s.v - off, configuration)


@pytest.mark.parametrize("variant", START, ids=lambda variant: variant.id)
def test_accelerations_at_the_start(variant: Variant) -> None:
    """The solver takes second derivatives of constraints by differences of rates: 1e-10 of their size is rounding."""
    moving = variant.build(seed=81, closed=not any(of_one_coordinate(carrier) for _, carrier in variant.pairs))
    mbs = moving.mbs
    nodes = [i for i in range(mbs.systemData.NumberOfNodes()) if len(mbs.systemData.GetNodeLTGODE2(i))]
    sensors = [
        mbs.AddSensor(
            exu.SensorNode(
                nodeNumber=i,
                outputVariableType=exu.OutputVariableType.Coordinates_tt,
                storeInternal=True,
                writeToFile=False,
            )
        )
        for i in nodes
    ]
    mbs.Assemble()
    fulfil_constraints_of_velocities(mbs)
    wanted = accelerations(moving, testing.State(mbs))
    s = exu.SimulationSettings()
    s.timeIntegration.endTime, s.timeIntegration.numberOfSteps, s.timeIntegration.verboseMode = 1e-9, 1, 0
    s.timeIntegration.newton.absoluteTolerance = 1e6  # the first step itself does not matter
    s.solutionSettings.writeSolutionToFile = False
    mbs.SolveDynamic(s)
    told = np.concatenate([np.atleast_2d(mbs.GetSensorStoredData(sensor))[0, 1:] for sensor in sensors])
    scale = np.abs(wanted).max()
    assert scale > 0.01
    np.testing.assert_allclose(told, wanted[: len(told)], rtol=0, atol=1e-6 * scale)
