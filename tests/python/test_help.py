"""Help where users type: docstrings of settings and enumerations, short texts of objects, completion, the command line."""

from __future__ import annotations

import inspect
import pydoc
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).parents[2]))

import dalembert as exu
from codegen.load import load
from codegen.model import Item
from codegen.views.settings import structs
from dalembert import graphics
from dalembert import itemInterface as items
from dalembert._tools import completion

SPECS = load(Path(__file__).parents[2])


@pytest.mark.parametrize("item", SPECS.items, ids=lambda item: item.name)
def test_items_show_functions_example_and_page(item: Item) -> None:
    text = getattr(items, item.name).__doc__
    for function in item.user_functions:
        assert f"    {function.name}({', '.join(function.argument_names)})" in text
    for name in item.create_functions:
        assert f"mbs.{name}(...)" in text
    if item.example:
        assert all(line.strip() in text for line in item.example.code.splitlines())
    assert f"Page: reference/items/{item.stem}.html" in text


def test_help_of_settings_describes_parameters() -> None:
    for file in SPECS.settings:
        for struct in structs(file):
            cls = getattr(exu, struct.name)
            for row in struct.rows:
                text = " ".join(row.doc.split())
                assert text in cls.__doc__ and text in getattr(cls, row.name).__doc__, (struct.name, row.name)
            for member in struct.members:
                assert f"    {member.name}: {member.struct}\n" in cls.__doc__
    text = type(exu.SimulationSettings().timeIntegration).__doc__
    assert "endTime: float" in text and "in s; default 1.0" in text


def test_help_of_enumerations_describes_values() -> None:
    for enum in SPECS.enums:
        cls = getattr(exu, enum.name)
        assert cls.__doc__.startswith(" ".join(enum.summary.split()))
        for value in enum.values:
            assert cls[value.name].__doc__ == " ".join(value.doc.split())


def test_help_of_methods_describes_arguments_and_results() -> None:
    for name in (
        *("PreStep", "PostStep", "PostNewton", "PreNewtonResidual", "SystemJacobian"),
        *("Events", "EventAction", "ItemEventAction"),
    ):
        assert "Set the function f(mbs, t" in getattr(exu.MainSystem, f"Set{name}UserFunction").__doc__
    assert "given by its index or name" in exu.MainSystem.SetObjectParameter.__doc__
    for name in dir(exu.MainSystem):
        method = getattr(exu.MainSystem, name)
        if not name.startswith("_") and callable(method):
            text = (inspect.getdoc(method) or "").replace(f"{name}(self: dalembert._core.MainSystem", "")
            assert len(text) > 30, name


def test_mathematics_is_readable_in_a_terminal() -> None:
    told = pydoc.render_doc(exu.ObjectRigidBody, renderer=pydoc.plaintext)
    assert "[J_xx, J_yy, J_zz, J_yz, J_xz, J_xy]" in told and "J_xy = -∫ x y dm" in told
    for name in dir(exu):
        text = getattr(exu, name).__doc__ or ""
        assert ":math:" not in text and "mathbf" not in text, name


def test_help_of_graphics_describes_parameters() -> None:
    for name in graphics.__all__:
        function = getattr(graphics, name)
        if inspect.isclass(function) or not callable(function):
            continue
        entries = [line.split(": ")[0] for line in (inspect.getdoc(function) or "").split("\n\n")[-1].splitlines()]
        named = [
            name for name, each in inspect.signature(function).parameters.items() if each.kind is not each.VAR_KEYWORD
        ]
        assert entries[: len(named)] == named, name
    assert "\nnTilesY: number of tiles along the second side" in (graphics.Quad.__doc__ or "")


def test_repr_of_settings_has_differences() -> None:
    settings = exu.SimulationSettings()
    assert repr(settings) == "SimulationSettings: all at their defaults"
    settings.timeIntegration.newton.maxIterations = 7
    assert repr(settings).splitlines()[1:] == ["  timeIntegration:", "    newton:", "      maxIterations = 7"]
    assert repr(settings.timeIntegration.newton).splitlines()[1:] == ["  maxIterations = 7"]
    assert len(str(settings).splitlines()) > 100 and "endTime = 1.0" in str(settings)


@pytest.mark.parametrize("kind", ["Node", "Object", "Marker", "Load", "Sensor"])
def test_repr_of_indices_shows_the_kind(kind: str) -> None:
    index = getattr(exu, f"{kind}Index")(3)
    assert (repr(index), str(index), eval(repr(index), vars(exu))) == (f"{kind}Index(3)", "3", index)


def test_repr_of_variations_is_a_summary() -> None:
    mbs = exu.SystemContainer().AddSystem()
    mass = mbs.CreateMassPoint(physicsMass=1, gravity=[0, 0, -9.81])
    spring = mbs.CreateSpringDamper(bodyNumbers=[mbs.CreateGround(referencePosition=[1, 0, 0]), mass], stiffness=100)
    found = mbs.SolveVariations({(spring, "stiffness"): np.linspace(1, 2, 1000)})
    assert repr(found).startswith("<VariationResults: 1000 of 1000 solved, ") and len(repr(found)) < 200


def test_completion() -> None:
    assert "numberOfSteps" in dir(exu.SimulationSettings().timeIntegration)
    assert "Position" in dir(exu.OutputVariableType)
    IPython = pytest.importorskip("IPython")
    completion.tell_ipython()  # the import of the package sets it if IPython runs
    shell = IPython.core.interactiveshell.InteractiveShell.instance()
    shell.Completer.use_jedi = False  # it guesses by types, and gives up when time is short
    SC = exu.SystemContainer()
    shell.user_ns.update(settings=exu.SimulationSettings(), exu=exu, SC=SC, mbs=SC.AddSystem())
    assert ".newton" in "".join(shell.complete("settings.timeIntegration.new")[1])
    assert shell.complete("exu.OutputVariableType.Rotat")[1]
    assert ".nodes" in shell.complete("SC.visualizationSettings.nod")[1]
    assert ".GetODE2Coordinates" in shell.complete("mbs.systemData.GetODE2")[1]


def command(*arguments: str) -> Any:
    call = [sys.executable, "-m", "dalembert", *arguments]
    return subprocess.run(call, capture_output=True, text=True, check=False)


def test_command_line() -> None:
    assert command("--version").stdout == f"dalembert {exu.__version__}\n"
    by_short, by_long = command("items", "SpringDamper").stdout, command("items", "objectconnectorspringdamper").stdout
    assert by_short == by_long and "springForceUserFunction(mbs, t, itemNumber" in by_short
    assert "Example:" in command("items", "CreateRevoluteJoint").stdout
    wrong = command("items", "CreateRevolute")
    assert wrong.returncode == 2 and "CreateRevoluteJoint" in wrong.stderr
    assert command("items", "createrobot").stdout == command("items", "CreateRobot").stdout != ""
    assert command("items", "RigidBod").stderr.endswith("did you mean RigidBody, RigidBody2D, ObjectRigidBody?\n")
    assert "help(exu.MainSystem.SolveDynamic)" in command("items", "SolveDynamic").stderr
    assert "help(exu.SimulationSettings)" in command("items", "SimulationSettings").stderr
