"""Files of solvers, and functions that read them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from oscillators import Variable, dynamic_settings, friction_or_stop, oscillator

import dalembert as exu
from dalembert.itemInterface import SensorNode
from dalembert.utilities import InertiaCuboid, InitializeFromRestartFile, LoadSolutionFile


def settings_of(end: float, steps: int, **solution: Any) -> Any:
    settings = dynamic_settings(end, steps, tolerance=1e-10)
    for name, value in {"writeSolutionToFile": True, "coordinatesSolutionFileName": "solution.txt", **solution}.items():
        setattr(settings.solutionSettings, name, value)
    return settings


def with_history() -> Any:
    model = oscillator()
    friction_or_stop(model, stiffness=0.0, fDynamicFriction=0.5, stickingStiffness=1e3, stickingDamping=5.0)
    model.mbs.Assemble()
    return model


@pytest.mark.parametrize("binary", [False, True])
def test_solution_file(binary: bool) -> None:
    model = with_history()
    name = "solution.sol" if binary else "solution.txt"
    settings = settings_of(1.0, 20, solutionWritePeriod=0.1, coordinatesSolutionFileName=name, outputPrecision=16)
    settings.solutionSettings.binarySolutionFile = binary
    settings.solutionSettings.exportAccelerations = True
    settings.solutionSettings.exportDataCoordinates = True
    model.mbs.SolveDynamic(settings)
    solution = LoadSolutionFile(name, verbose=False)
    # [ODE2, velocities, accelerations, ODE1, rates, algebraic, data]
    assert list(solution["columnsExported"]) == [1, 1, 1, 0, 0, 0, 3]
    digits = 1e-7 if binary else 1e-15  # single precision, or 16 digits
    np.testing.assert_allclose(solution["data"][:, 0], np.linspace(0, 1, 11), rtol=digits, atol=1e-12)
    data = model.mbs.systemData
    last = np.concatenate(
        [
            data.GetODE2Coordinates(),
            data.GetODE2Coordinates_t(),
            data.GetODE2Coordinates_tt(),
            data.GetDataCoordinates(),
        ]
    )
    np.testing.assert_allclose(solution["data"][-1, 1:], last, rtol=digits, atol=0)


def test_layout_of_the_solution_file() -> None:
    model = oscillator()
    model.mbs.Assemble()
    model.mbs.SolveDynamic(settings_of(1.0, 4, solutionWritePeriod=0.25, solutionInformation="free text"))
    lines = Path("solution.txt").read_text().splitlines()
    header = [line for line in lines if line.startswith("#")]
    rows = [line for line in lines if not line.startswith("#")]
    assert any("free text" in line for line in header)
    assert "#number of system coordinates [nODE2, nODE1, nAlgebraic, nData] = [1,0,0,0]" in header
    assert (
        "#number of written coordinates [nODE2, nVel2, nAcc2, nODE1, nVel1, nAlgebraic, nData] = [1,1,1,0,0,0,0]"
        in header
    )
    assert [row.split(",")[0] for row in rows] == ["0", "0.25", "0.5", "0.75", "1"]
    assert {len(row.split(",")) for row in rows} == {4}


def test_without_a_solution_file() -> None:
    model = oscillator()
    model.mbs.Assemble()
    model.mbs.SolveDynamic(settings_of(1.0, 4, writeSolutionToFile=False))
    assert list(Path().iterdir()) == []


def test_appended_solutions_follow_each_other() -> None:
    model = oscillator()
    model.mbs.Assemble()
    settings = settings_of(1.0, 4, solutionWritePeriod=0.25, appendToFile=True)
    for _ in range(2):
        model.mbs.SolveDynamic(settings)
    rows = [line for line in Path("solution.txt").read_text().splitlines() if line and not line.startswith("#")]
    assert len(rows) == 10


def test_sensor_file_has_the_stored_values() -> None:
    model = oscillator()
    model.mbs.AddSensor(
        SensorNode(nodeNumber=model.node, fileName="folder/sensor.txt", outputVariableType=Variable.Coordinates)
    )
    model.mbs.Assemble()
    model.mbs.SolveDynamic(settings_of(1.0, 10, sensorsWritePeriod=0.2))
    table = np.loadtxt("folder/sensor.txt", comments="#", delimiter=",")
    assert table.shape == (6, 2)
    np.testing.assert_allclose(table[:, 0], np.linspace(0, 1, 6), rtol=0, atol=1e-10)
    np.testing.assert_allclose(table, model.table(), rtol=1e-9, atol=1e-12)  # ten digits


def spinning_body() -> Any:
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.CreateGround()
    body = mbs.CreateRigidBody(
        inertia=InertiaCuboid(1000, [1, 0.2, 0.1]),
        referencePosition=[0.5, 0, 0],
        initialAngularVelocity=[0, 2, 5],
        initialVelocity=[0, 2.5, -1],
        gravity=[0, 0, -9.81],
    )
    mbs.CreateSphericalJoint(bodyNumbers=[ground, body], position=[0, 0, 0])
    mbs.Assemble()
    return mbs


def test_restart_continues_bit_for_bit() -> None:
    whole = spinning_body()
    whole.SolveDynamic(settings_of(1.0, 128))
    settings = settings_of(0.5, 64, writeRestartFile=True, restartFileName="restart.txt", restartWritePeriod=0.25)
    spinning_body().SolveDynamic(settings)
    rest = spinning_body()
    solver = exu.MainSolverImplicitSecondOrder()
    solver.ContinueFromRestartFile(rest, "restart.txt")
    settings = settings_of(1.0, 64)
    settings.timeIntegration.startTime = rest.systemData.GetTime(exu.ConfigurationType.Initial)
    assert settings.timeIntegration.startTime == 0.5
    assert solver.SolveSystem(rest, settings)
    # Steps of 1/128 and times are binary fractions: no rounding separates the two.
    np.testing.assert_array_equal(rest.systemData.GetODE2Coordinates(), whole.systemData.GetODE2Coordinates())
    np.testing.assert_array_equal(rest.systemData.GetODE2Coordinates_t(), whole.systemData.GetODE2Coordinates_t())


@pytest.mark.parametrize(
    ("solver", "tolerance"),
    # Explicit schemes have nothing but the state. The trapezoidal rule starts with the accelerations of the equations of
    # motion, which are its own but for the tolerance of Newton's method, 1e-10.
    [(exu.DynamicSolverType.RK44, 0.0), (exu.DynamicSolverType.TrapezoidalIndex2, 1e-8)],
    ids=str,
)
def test_going_on_from_a_restart_file(solver: Any, tolerance: float) -> None:
    whole = with_history()
    whole.mbs.SolveDynamic(settings_of(1.0, 128), solverType=solver)
    settings = settings_of(0.5, 64, writeRestartFile=True, restartFileName="restart.txt")
    with_history().mbs.SolveDynamic(settings, solverType=solver)
    rest, settings = with_history(), settings_of(1.0, 64)
    InitializeFromRestartFile(rest.mbs, settings, "restart.txt")
    assert settings.timeIntegration.startTime == 0.5
    for configuration in (exu.ConfigurationType.Current, exu.ConfigurationType.Visualization):
        assert rest.mbs.systemData.GetTime(configuration) == 0.5
    rest.mbs.SolveDynamic(settings, solverType=solver)
    for state, wanted in zip(*(m.mbs.systemData.GetSystemState() for m in (rest, whole)), strict=True):
        np.testing.assert_allclose(state, wanted, rtol=0, atol=tolerance)


@pytest.mark.parametrize(
    ("text", "error", "message"),
    [
        ("something else\n", ValueError, "line 1: expected"),
        ("#dalembert restart file 5\n", ValueError, "line 2"),
        (None, FileNotFoundError, "restart file cannot be opened: No such file or directory: 'restart.txt'"),
        ("folder", IsADirectoryError, "restart file cannot be read"),
    ],
)
def test_damaged_restart_files_are_refused(text: str | None, error: type[Exception], message: str) -> None:
    if text == "folder":
        Path("restart.txt").mkdir()
    elif text is not None:
        Path("restart.txt").write_text(text)
    with pytest.raises(error, match=message):
        exu.MainSolverImplicitSecondOrder().ContinueFromRestartFile(spinning_body(), "restart.txt")
