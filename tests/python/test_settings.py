"""Settings: defaults of the interface, attributes, dictionaries, copies, and errors that name path and nearest name."""

from __future__ import annotations

import copy
import functools
import pickle
from typing import Any

import pytest

import dalembert as exu

ROOTS = [exu.SimulationSettings, exu.VisualizationSettings]


def leaves(values: dict[str, Any], path: str = "") -> Any:
    for name, value in values.items():
        if isinstance(value, dict):
            yield from leaves(value, f"{path}{name}.")
        else:
            yield f"{path}{name}", value


def at(settings: Any, path: str) -> Any:
    for name in path.split("."):
        settings = getattr(settings, name)
    return settings


@pytest.mark.parametrize("root", ROOTS)
def test_every_value_is_an_attribute_and_can_be_written(root: Any) -> None:
    settings = root()
    values = dict(leaves(settings.GetDictionary()))
    assert len(values) > 100
    for path, value in values.items():
        owner, _, name = path.rpartition(".")
        target = at(settings, owner) if owner else settings
        assert getattr(target, name) == value
        setattr(target, name, value)
    chosen = {"linearSolverChoice.automatic": False} if "linearSolverType" in values else {}  # who sets a type gets it
    assert dict(leaves(settings.GetDictionary())) == values | chosen


def test_a_type_of_linear_solver_that_is_set_stays() -> None:
    settings = exu.SimulationSettings()
    assert settings.linearSolverChoice.automatic
    assert pickle.loads(pickle.dumps(settings)).linearSolverChoice.automatic
    settings.linearSolverType = exu.LinearSolverType.EXUdense
    assert not settings.linearSolverChoice.automatic
    assert not pickle.loads(pickle.dumps(settings)).linearSolverChoice.automatic


def test_nested_structures_refer_to_their_parent() -> None:
    settings = exu.SimulationSettings()
    newton = settings.timeIntegration.newton
    newton.maxIterations = 7
    settings.timeIntegration.newton.relativeTolerance = 1e-3
    assert settings.timeIntegration.newton.maxIterations == 7 and newton.relativeTolerance == 1e-3
    assert settings.staticSolver.newton.maxIterations == 25
    del settings
    assert newton.maxIterations == 7


def test_structures_are_assigned_by_value() -> None:
    settings, newton = exu.SimulationSettings(), exu.NewtonSettings()
    newton.numericalDifferentiation.forODE2 = True
    settings.timeIntegration.newton = newton
    newton.numericalDifferentiation.forODE2 = False
    assert settings.timeIntegration.newton.numericalDifferentiation.forODE2
    settings.timeIntegration = {"endTime": 3, "newton": {"maxIterations": 4}}
    assert settings.timeIntegration.endTime == 3.0 and settings.timeIntegration.newton.maxIterations == 4
    with pytest.raises(
        TypeError, match="'timeIntegration.newton': received .* but expected a NewtonSettings or a dictionary"
    ):
        settings.timeIntegration.newton = exu.DiscontinuousSettings()


def test_copies_are_independent() -> None:
    settings = exu.SimulationSettings()
    settings.timeIntegration.endTime = 5
    for other in (copy.copy(settings), copy.deepcopy(settings), pickle.loads(pickle.dumps(settings))):
        assert other.GetDictionary() == settings.GetDictionary()
        other.timeIntegration.endTime = 6
    part = copy.copy(settings.timeIntegration)
    part.endTime = 7
    assert settings.timeIntegration.endTime == 5
    assert "endTime = 5.0" in repr(settings) and "endTime = 7.0" in repr(part)


def test_dictionaries_may_be_partial_and_errors_change_nothing() -> None:
    settings = exu.SimulationSettings()
    settings.SetDictionary(
        {"timeIntegration": {"numberOfSteps": 7}, "linearSolverType": exu.LinearSolverType.EigenSparse}
    )
    assert settings.timeIntegration.numberOfSteps == 7
    before = settings.GetDictionary()
    with pytest.raises(AttributeError, match=r"SimulationSettings.timeIntegration has no parameter 'endTimee'"):
        settings.SetDictionary({"outputPrecision": 3, "timeIntegration": {"endTimee": 3}})
    with pytest.raises(TypeError, match="expected a dictionary"):
        settings.SetDictionary({"timeIntegration": 3})
    assert settings.GetDictionary() == before
    typed = settings.GetDictionaryWithTypeInfo()["timeIntegration"]["numberOfSteps"]
    assert typed["value"] == 7 and typed["size"] == [1] and typed["type"] == "float"


@pytest.mark.parametrize(
    ("path", "value", "error", "text"),
    [
        (
            "timeIntegration.endTime",
            -1,
            ValueError,
            "'timeIntegration.endTime': received -1 .int., but expected a number that is not",
        ),
        ("timeIntegration.endTime", "a", TypeError, "received 'a' .str., but expected a number"),
        ("timeIntegration.endTime", float("nan"), ValueError, "a finite number"),
        ("timeIntegration.newton.maxIterations", 1.5, TypeError, "expected an integer"),
        ("parallel.numberOfThreads", 0, ValueError, "an integer greater than zero"),
        ("displayStatistics", "yes", TypeError, "True or False"),
        ("linearSolverType", 2, TypeError, "a member of LinearSolverType"),
        ("linearSolverType", "EigenSpars", ValueError, "'EigenSpars'. Did you mean 'EigenSparse'"),
        ("linearSolverType", exu.NodeType.Position, TypeError, "a member of LinearSolverType"),
        ("solutionSettings.coordinatesSolutionFileName", 3, TypeError, "expected a string"),
    ],
)
def test_wrong_values(path: str, value: Any, error: Any, text: str) -> None:
    settings = exu.SimulationSettings()
    owner, _, name = path.rpartition(".")
    with pytest.raises(error, match=text):
        setattr(at(settings, owner) if owner else settings, name, value)
    assert settings.GetDictionary() == exu.SimulationSettings().GetDictionary()


def test_unknown_names() -> None:
    settings = exu.SimulationSettings()
    with pytest.raises(AttributeError, match="has no parameter 'endtim'. Did you mean 'endTime'?"):
        settings.timeIntegration.endtim = 3
    with pytest.raises(AttributeError, match="Did you mean 'timeIntegration.endTime'?"):
        settings.endTime = 3
    with pytest.raises(AttributeError, match="Did you mean 'newton'?"):
        settings.staticSolver.newtn.maxIterations  # noqa: B018
    assert not hasattr(settings, "something")
    with pytest.raises(TypeError, match="cannot be deleted"):
        del settings.linearSolverType
    assert "timeIntegration" in dir(settings)


def test_drawing() -> None:
    settings = exu.VisualizationSettings()
    settings.nodes.defaultColor = (1, 0, 0, 1)
    assert settings.nodes.defaultColor == [1.0, 0.0, 0.0, 1.0]
    with pytest.raises(ValueError, match="4 finite numbers"):
        settings.nodes.defaultColor = [1, 0, 0]
    settings.contour.outputVariable = exu.OutputVariableType.Displacement
    assert settings.contour.outputVariable == exu.OutputVariableType.Displacement
    assert settings.raytracer.material1.name != settings.raytracer.material0.name


def test_earlier_names() -> None:
    settings = exu.VisualizationSettings()
    settings.window.renderWindowSize = [100, 200]
    assert settings.view0.window.renderWindowSize == [100, 200] == settings.window.renderWindowSize
    settings.window.startupTimeout = 77
    assert settings.general.rendererStartupTimeout == 77
    settings.openGL.showFaces = False
    assert settings.view0.scene.showFaces is False and settings.view1.scene.showFaces is True
    settings.interactive.keyPressUserFunction = lambda key, action, mods: False
    settings.openGL.light0ambient = 0.25
    with pytest.raises(AttributeError):
        settings.view1.window.startupTimeout = 3
    settings.general.SetDictionary({"drawWorldBasis": True})
    assert settings.view0.scene.drawWorldBasis is True


def test_truth_values_and_sensors() -> None:
    settings = exu.VisualizationSettings()
    settings.general.showSolverInformation = 12
    assert settings.general.showSolverInformation is True
    settings.general.SetDictionary({"showSolverInformation": 0})
    assert settings.general.showSolverInformation is False
    mbs = exu.SystemContainer().AddSystem()
    node = mbs.AddNode(exu.NodePoint())
    sensors = [mbs.AddSensor(exu.SensorNode(nodeNumber=node, storeInternal=True)) for _ in range(2)]
    settings.sensors.traces.listOfPositionSensors = sensors
    assert settings.sensors.traces.listOfPositionSensors == [0, 1]
    with pytest.raises(TypeError, match="Item numbers do not belong here"):
        settings.sensors.traces.listOfPositionSensors = [node]


def test_the_tracked_marker_is_a_marker() -> None:
    mbs = exu.SystemContainer().AddSystem()
    camera = exu.VisualizationSettings().view0.camera
    node = mbs.AddNode(exu.NodePoint())
    camera.trackMarker = mbs.AddMarker(exu.MarkerNodePosition(nodeNumber=node))
    assert camera.trackMarker == 0
    with pytest.raises(TypeError, match=r"trackMarker"):
        camera.trackMarker = node
    with pytest.raises(TypeError, match=r"numberOfSteps"):
        exu.SimulationSettings().timeIntegration.numberOfSteps = exu.MarkerIndex(3)


def test_keywords_set_settings() -> None:
    settings = exu.SimulationSettings(
        outputPrecision=9, timeIntegration={"endTime": 2, "newton": {"useModifiedNewton": True}}
    )
    expected = exu.SimulationSettings()
    expected.outputPrecision, expected.timeIntegration.endTime = 9, 2
    expected.timeIntegration.newton.useModifiedNewton = True
    assert settings._equals(expected) and not settings._equals(exu.SimulationSettings())
    settings = exu.SimulationSettings(linearSolverType="eigen_sparse", timeIntegration={"solverType": "RK44"})
    assert settings.linearSolverType == exu.LinearSolverType.EigenSparse
    assert settings.timeIntegration.solverType == exu.DynamicSolverType.RK44
    with pytest.raises(ValueError, match=r"linearSolverType: received 'Eigen'.* Expected one of 'EXUdense'"):
        exu.SimulationSettings(linearSolverType="Eigen")
    with pytest.raises(TypeError, match="SimulationSettings: takes keywords only"):
        exu.SimulationSettings(3)
    with pytest.raises(AttributeError, match=r"endTime"):
        exu.SimulationSettings(endTime=2)
    with pytest.raises(ValueError, match=r"outputPrecision"):
        exu.SimulationSettings(outputPrecision=0)


def test_later_names() -> None:
    settings = exu.SimulationSettings()
    settings.solution.file.write = False
    settings.linearSolver.solverType = exu.LinearSolverType.EigenSparse
    settings.timeIntegration.newton.active = False
    assert settings.solutionSettings.writeSolutionToFile is False
    assert settings.linearSolverType == exu.LinearSolverType.EigenSparse == settings.linearSolver.solverType
    assert settings.timeIntegration.newton.useNewtonSolver is False
    settings.SetDictionary({"solution": {"sensors": {"writePeriod": 3}}})
    assert settings.solutionSettings.sensorsWritePeriod == 3
    with pytest.raises(AttributeError, match="solution.file has no parameter 'writ'. Did you mean 'write'?"):
        settings.solution.file.writ = 3
    with pytest.raises(TypeError, match="'solution.file': is not a structure"):
        settings.solution.file = 3


def test_settings_with_equal_values_are_distinguished_from_others():
    settings = exu.SystemContainer().visualizationSettings
    before = copy.copy(settings)
    assert settings._equals(before)
    for path, value in (
        ("nodes.show", False),
        ("openGL.light0.position", [1, 2, 3, 0]),
        ("contour.outputVariable", exu.OutputVariableType.Position),
        ("sensors.traces.listOfPositionSensors", [3]),
        ("exportImages.saveImageFileName", "other"),
    ):
        *names, name = path.split(".")
        owner = functools.reduce(getattr, names, settings)
        old = getattr(owner, name)
        setattr(owner, name, value)
        assert not settings._equals(before), path
        setattr(owner, name, old)
        assert settings._equals(before), path
    with pytest.raises(TypeError, match="settings of the same class"):
        settings._equals(settings.nodes)
