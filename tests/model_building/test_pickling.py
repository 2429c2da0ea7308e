"""Pickles and copies of systems with user functions that no module holds."""

from __future__ import annotations

import copy
import pickle
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import dalembert as exu

PROGRAM = """
import pickle, sys
import dalembert as exu

SC = exu.SystemContainer()
mbs = SC.AddSystem()
slope = 2.0

def ramp(system, t, load):
    assert mbs.variables["used"] and SC.GetSystem(0) is mbs
    return slope * t

def build():
    node = mbs.AddNode(exu.NodePoint())
    mass = mbs.AddObject(exu.MassPoint(physicsMass=4, nodeNumber=node))
    marker = mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=node, coordinate=0))
    mbs.AddLoad(exu.LoadCoordinate(markerNumber=marker, loadUserFunction=ramp))
    mbs.variables["used"] = True

build()
with open(sys.argv[1], "wb") as file:
    pickle.dump({"system": mbs, "container": SC, "dictionary": mbs.GetDictionary()}, file)
"""


def accelerated(mbs: exu.MainSystem, force: Callable[..., float]) -> None:
    """A mass of 4 kg under a force that a user function gives."""
    node = mbs.AddNode(exu.NodePoint())
    mbs.AddObject(exu.MassPoint(physicsMass=4, nodeNumber=node))
    marker = mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=node, coordinate=0))
    mbs.AddLoad(exu.LoadCoordinate(markerNumber=marker, loadUserFunction=force))


def travelled(mbs: exu.MainSystem) -> float:
    """How far the mass comes in a second."""
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.solutionSettings.writeSolutionToFile = False
    mbs.SolveDynamic(settings, solverType=exu.DynamicSolverType.RK44)
    return float(mbs.GetNodeOutput(0, exu.OutputVariableType.Displacement)[0])


def closure(slope: float) -> Callable[..., float]:
    return lambda mbs, t, load: slope * t


def from_dictionary(mbs: exu.MainSystem) -> exu.MainSystem:
    made = exu.MainSystem()
    made.SetDictionary(pickle.loads(pickle.dumps(mbs.GetDictionary())))
    return made


WAYS: list[Callable[[exu.MainSystem], exu.MainSystem]] = [
    lambda mbs: pickle.loads(pickle.dumps(mbs)),
    lambda mbs: pickle.loads(pickle.dumps(mbs.GetSystemContainer())).GetSystem(0),
    from_dictionary,
    copy.copy,
    copy.deepcopy,
]
EXACT = 2 / 4 / 6  # slope t^3 / (6 m): RK44 integrates the cubic exactly


@pytest.mark.parametrize("way", WAYS, ids=["system", "container", "dictionary", "copy", "deepcopy"])
@pytest.mark.parametrize("force", [lambda mbs, t, load: 2 * t, closure(2.0)], ids=["lambda", "closure"])
def test_functions_go_along(mbs: exu.MainSystem, way: Any, force: Callable[..., float]) -> None:
    accelerated(mbs, force)
    mbs.SetPreStepUserFunction(lambda mbs, t: True)
    other = way(mbs)
    mbs.Reset()
    np.testing.assert_allclose(travelled(other), EXACT, rtol=1e-12)  # round-off of the sums
    assert other.GetPreStepUserFunction()(other, 0.0)


def test_functions_of_a_scope_that_no_module_holds(mbs: exu.MainSystem) -> None:
    scope: dict[str, Any] = {"__name__": "__main__"}
    exec("slope = 2\ndef force(mbs, t, load): return slope * t", scope)
    accelerated(mbs, scope["force"])
    np.testing.assert_allclose(travelled(from_dictionary(mbs)), EXACT, rtol=1e-12)


def test_functions_of_another_program_and_the_system_they_refer_to(tmp_path: Path) -> None:
    file = tmp_path / "model.pkl"
    subprocess.run([sys.executable, "-c", PROGRAM, str(file)], check=True, timeout=60)
    loaded = pickle.loads(file.read_bytes())
    made = exu.SystemContainer().AddSystem()
    made.SetDictionary(loaded["dictionary"])
    for other in (loaded["system"], loaded["container"].GetSystem(0), made):
        np.testing.assert_allclose(travelled(other), EXACT, rtol=1e-12)


def test_copies_keep_their_variables_apart(mbs: exu.MainSystem) -> None:
    mbs.variables.update(values=[1], file=sys.stdout)  # a file cannot be pickled
    shallow, deep = copy.copy(mbs), copy.deepcopy(mbs)
    mbs.variables["values"].append(2)
    assert shallow.variables == {"values": [1, 2]}
    assert deep.variables == {"values": [1]}


def oscillator() -> tuple[exu.MainSystem, Any]:
    """A mass on a spring with friction, whose data coordinates are part of the state, solved for a second."""
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.CreateGround()
    body = mbs.CreateMassPoint(referencePosition=[1, 0, 0], physicsMass=1, initialVelocity=[1, 0, 0])
    mbs.CreateSpringDamper(bodyNumbers=[ground, body], stiffness=50, referenceLength=0.8)
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.endTime, settings.timeIntegration.numberOfSteps = 1, 100
    settings.solutionSettings.writeSolutionToFile = False
    mbs.SolveDynamic(settings, updateInitialValues=True)
    settings.timeIntegration.startTime, settings.timeIntegration.endTime = 1, 2
    return mbs, settings


COPIES = {"copy": copy.copy, "deepcopy": copy.deepcopy, "pickle": lambda mbs: pickle.loads(pickle.dumps(mbs))}


@pytest.mark.parametrize("way", COPIES)
def test_copies_of_solved_systems_go_on_where_they_are(way: str) -> None:
    """The second second of a copy is that of the original, bit for bit; copies started again from the model's initial values."""
    mbs, settings = oscillator()
    other = COPIES[way](mbs)
    for configuration in (exu.ConfigurationType.Initial, exu.ConfigurationType.Current):
        states = [each.systemData.GetSystemState(configuration) for each in (mbs, other)]
        for now, then in zip(*states, strict=True):
            np.testing.assert_array_equal(now, then)
        assert other.systemData.GetTime(configuration) == mbs.systemData.GetTime(configuration)
    assert other.systemData.GetTime() == 1
    ends = []
    for system in (other, mbs):
        system.SolveDynamic(settings)
        ends.append(system.systemData.GetODE2Coordinates())
    np.testing.assert_array_equal(ends[0], ends[1])
    assert np.abs(ends[0]).max() > 1e-3


@pytest.mark.parametrize("way", COPIES)
def test_copies_of_systems_that_are_not_assembled_stay_so(way: str) -> None:
    mbs, _ = oscillator()
    mbs.CreateMassPoint(physicsMass=1)
    other = COPIES[way](mbs)
    assert not other.systemIsConsistent
    other.Assemble()
    assert other.systemData.ODE2Size() == 6
