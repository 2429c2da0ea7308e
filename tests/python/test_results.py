"""Results for other tools: pandas, xarray, HDF5, with units; plots with units, phase plots, spectra, several systems."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import matplotlib.pyplot
import numpy as np
import pytest

import dalembert as exu
from dalembert import plot, results
from dalembert.rigidBodyUtilities import InertiaCylinder

RATE = 5.0  # rad/s: more than one turn in two seconds


@pytest.fixture(scope="module")
def solved(tmp_path_factory: pytest.TempPathFactory) -> Any:
    """A wheel that turns about z, as body in space and in the plane, and a weight on a spring."""
    mbs = exu.SystemContainer().AddSystem()
    wheel = {"inertia": InertiaCylinder(1000, 0.1, 0.2, axis=2), "initialAngularVelocity": [0, 0, RATE]}
    bodies = {
        "wheel": mbs.CreateRigidBody("wheel", **wheel),
        "disc": mbs.CreateRigidBody("disc", create2D=True, **wheel),
    }
    mass = mbs.CreateMassPoint("mass", [1, 0, 0], physicsMass=1, initialVelocity=[0.5, 0, 0])
    spring = mbs.CreateSpringDamper("spring", [mbs.CreateGround(), mass], stiffness=400)
    types = exu.OutputVariableType
    for name, body in bodies.items():
        mbs.AddSensor(exu.SensorBody(name, body, [0, 0, 0], outputVariableType=types.Rotation, storeInternal=True))
    for name, kind in (("place", types.Position), ("speed", types.Velocity)):
        mbs.AddSensor(exu.SensorBody(name, mass, [0, 0, 0], outputVariableType=kind, storeInternal=True))
    mbs.AddSensor(exu.SensorObject("force", spring, outputVariableType=types.ForceLocal, storeInternal=True))
    mbs.AddSensor(exu.SensorNode("silent", 0, outputVariableType=types.Position, writeToFile=False))
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.endTime, settings.timeIntegration.numberOfSteps = 2, 400
    settings.solutionSettings.sensorsWritePeriod = 0.005
    settings.solutionSettings.solutionWritePeriod = 0.1
    settings.solutionSettings.coordinatesSolutionFileName = str(tmp_path_factory.mktemp("s") / "solution.txt")
    mbs.SolveDynamic(settings)
    yield mbs, settings
    matplotlib.pyplot.close("all")


def test_pandas(solved: Any) -> None:
    mbs, _ = solved
    frame = results.SensorsToPandas(mbs)
    assert list(frame.columns[:4]) == ["wheel.X", "wheel.Y", "wheel.Z", "disc"] and "silent.X" not in frame
    assert frame.index.name == "time" and len(frame) == 401
    assert np.array_equal(frame[["place.X", "place.Y", "place.Z"]], mbs.GetSensorStoredData("place")[:, 1:])
    units = frame.attrs["units"]
    assert [units[name] for name in ("wheel.X", "place.X", "speed.Z", "force")] == ["rad", "m", "m/s", "N"]
    assert list(results.SensorsToPandas(mbs, ["force"]).columns) == ["force"]
    with pytest.raises(ValueError, match="sensor 5 'silent' keeps no data: give it storeInternal=True"):
        results.SensorsToPandas(mbs, ["silent"])
    with pytest.raises(
        ValueError, match="received 'forces', but no sensor of the system has this name. Did you mean 'force'"
    ):
        results.SensorsToPandas(mbs, ["forces"])


def test_angles_do_not_jump(solved: Any) -> None:
    mbs, _ = solved
    for column in ("wheel.Z", "disc"):
        plain = results.SensorsToPandas(mbs)[column]
        going_on = results.SensorsToPandas(mbs, continuousAngles=True)[column]
        assert going_on.iloc[-1] == pytest.approx(2 * RATE, rel=6e-5)
        assert np.allclose(np.exp(1j * plain), np.exp(1j * going_on))
    assert np.abs(np.diff(results.SensorsToPandas(mbs)["wheel.Z"])).max() > 6


def test_xarray(solved: Any) -> None:
    mbs, settings = solved
    data = results.SensorsToXarray(mbs)
    assert data["place"].attrs == {"units": "m", "long_name": "Position"} and data["time"].attrs["units"] == "s"
    assert list(data["place"].coords["place_component"].values) == ["X", "Y", "Z"]
    assert np.array_equal(data["force"], mbs.GetSensorStoredData("force")[:, 1])
    solution = results.SolutionToXarray(settings.solutionSettings.coordinatesSolutionFileName)
    assert solution["ODE2Coordinates"].shape == (21, mbs.systemData.ODE2Size())
    assert float(solution["time"][-1]) == pytest.approx(2)
    assert np.allclose(solution["ODE2Coordinates"][-1], mbs.systemData.GetODE2Coordinates(), atol=1e-9)
    frame = results.SolutionToPandas(settings.solutionSettings.coordinatesSolutionFileName)
    assert (frame.index.name, frame.attrs["units"]["ODE2Coordinates_t.0"]) == ("time", "various/s")
    assert list(frame.columns[:2]) == ["ODE2Coordinates.0", "ODE2Coordinates.1"]
    columns = [f"ODE2Coordinates.{i}" for i in range(mbs.systemData.ODE2Size())]
    assert np.array_equal(frame[columns], solution["ODE2Coordinates"])


def test_hdf5(solved: Any, tmp_path: Path) -> None:
    mbs, settings = solved
    file = tmp_path / "results.h5"
    results.SaveHDF5(mbs, file, settings, solutionFile=settings.solutionSettings.coordinatesSolutionFileName)
    read = results.LoadHDF5(file)
    assert read["version"] == exu.__version__ and read["settings"]["timeIntegration"]["endTime"] == 2
    place = read["sensors"]["place"]
    assert (place["unit"], place["variable"], place["components"]) == ("m", "Position", ["X", "Y", "Z"])
    assert np.array_equal(place["values"], mbs.GetSensorStoredData("place")[:, 1:])
    assert read["solution"]["time"]["unit"] == "s" and len(read["solution"]["ODE2Coordinates"]["values"]) == 21
    results.SaveHDF5(mbs, tmp_path / "last.h5")  # with the settings of the last simulation
    assert results.LoadHDF5(tmp_path / "last.h5")["settings"] == read["settings"]
    again = exu.SimulationSettings()
    again.SetDictionary(read["settings"])
    assert repr(again) == repr(settings)
    (tmp_path / "other.h5").write_bytes(b"nothing")
    with pytest.raises(OSError, match="other.h5"):
        results.LoadHDF5(tmp_path / "other.h5")


@pytest.mark.parametrize("package", ["pandas", "xarray", "h5py"])
def test_missing_packages_are_reported(
    solved: Any, package: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, package, None)
    calls: dict[str, Any] = {
        "pandas": lambda: results.SensorsToPandas(solved[0]),
        "xarray": lambda: results.SensorsToXarray(solved[0]),
        "h5py": lambda: results.SaveHDF5(solved[0], tmp_path / "x.h5"),
    }
    with pytest.raises(ImportError, match=f"the package {package} is needed; install it with 'pip install {package}'"):
        calls[package]()


def test_axes_show_units(solved: Any) -> None:
    mbs, _ = solved
    axes = mbs.PlotSensor("place")[2]
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("time (s)", "Position (m)")
    assert mbs.PlotSensor("place", factors=1000)[2].get_ylabel() == "Position"
    assert mbs.PlotSensor(["place", "force"])[2].get_ylabel() == "Position (m), ForceLocal (N)"
    assert mbs.PlotSensor("disc")[2].get_lines()[0].get_label() == "disc, RotationZ"
    line = mbs.PlotSensor("wheel", components=2, continuousAngles=True)[2].get_lines()[0]
    assert line.get_ydata()[-1] == pytest.approx(2 * RATE, rel=6e-5)


def test_several_systems_in_one_plot(solved: Any) -> None:
    mbs, _ = solved
    axes = plot.PlotSensor([mbs, mbs], ["place", "speed"])[2]
    labels = [line.get_label() for line in axes.get_lines()]
    assert labels == [
        f"{n}, {v}X"
        for s in (0, 1)
        for n, v in ((f"place of system {s}", "Position"), (f"speed of system {s}", "Velocity"))
    ]


def test_labels_are_said_once(solved: Any) -> None:
    mbs, _ = solved
    axes = plot.PlotSensor([mbs, mbs], ["place", "speed"])[2]
    assert axes.get_ylabel() == "Position (m), Velocity (m/s)"
    assert mbs.PlotSensor(["place", "place"], components=[0, 1])[2].get_ylabel() == "Position (m)"


def test_phase_and_spectrum_of_several_systems(solved: Any) -> None:
    mbs, _ = solved
    for axes in (plot.PlotPhase([mbs, mbs], "place", "speed"), plot.PlotSensorFFT([mbs, mbs], "speed")):
        assert [text.get_text() for text in axes.get_legend().get_texts()] == ["system 0", "system 1"]
        first, second = (line.get_xydata() for line in axes.get_lines())
        assert len(first) > 10 and np.array_equal(first, second)
        assert "system" not in axes.get_xlabel() + axes.get_ylabel()
    with pytest.raises(FileNotFoundError, match="neither a sensor nor a file named 'spede'. Did you mean 'speed'"):
        plot.PlotPhase([mbs, mbs], "place", "spede")


def test_phase_and_spectrum(solved: Any, tmp_path: Path) -> None:
    """The phase curve of an oscillator without damping is an ellipse with the half axes v/omega and v, omega = 20."""
    mbs, _ = solved
    axes = plot.PlotPhase(mbs, "place", "speed", fileName=str(tmp_path / "phase.png"))
    (line,) = axes.get_lines()
    x, y = line.get_xdata() - 1, line.get_ydata()
    assert np.allclose((x / 0.025) ** 2 + (y / 0.5) ** 2, 1, atol=0.02)
    assert axes.get_xlabel() == "place, PositionX (m)" and (tmp_path / "phase.png").exists()
    axes = plot.PlotSensorFFT(mbs, "speed")
    frequency, amplitude = axes.get_lines()[0].get_data()
    assert frequency[np.argmax(amplitude)] == pytest.approx(20 / (2 * np.pi), abs=0.5)
    with pytest.raises(ValueError, match="PlotSensorFFT: array 0 has steps from"):
        plot.PlotSensorFFT(None, np.array([[0.0, 1], [1, 2], [3, 4]]))
