"""The interface of Exudyn 1.13, by the published names: each is there, or in the list of what is left out."""

from __future__ import annotations

import importlib
import inspect
import json
from pathlib import Path
from typing import Any

import pytest

import dalembert as exu
from dalembert import cli, create
from dalembert._planned_table import LEFT_OUT
from dalembert.create._mirrors import other_names
from dalembert.types import ItemInfo

ROOT = Path(__file__).parents[2]
REFERENCE: dict[str, list[str]] = json.loads((ROOT / "tests/data/reference/exudyn_1_13.json").read_text())
ENVIRONMENT = ("EXUDYN_OUTPUTDIRECTORY", "EXUDYN_SUPPRESS_UI_WINDOW_OPEN")  # see test_user_interface.py
RENAMED = {
    "misc.GUI": "GUI",
    "misc.mainSystemExtensions": "mainSystemExtensions",
    "misc.resultsMonitor": "resultsMonitor",
}
# Methods of MainSystem that the reference has as functions of a module, too.
AS_METHODS = {"mainSystemExtensions.CreateDistanceSensor", "mainSystemExtensions.CreateDistanceSensorGeometry"}
# Attributes of objects, not of their classes.
MADE = {
    "robotics.roboticsCore.RobotBase": lambda: exu.robotics.RobotBase(),
    "robotics.roboticsCore.RobotTool": lambda: exu.robotics.RobotTool(),
    "robotics.roboticsCore.RobotLink": lambda: exu.robotics.RobotLink(1, [0, 0, 0], [[1, 0, 0], [0, 1, 0], [0, 0, 1]]),
}


def find(name: str) -> Any:
    """Return what a published name stands for; AttributeError or ImportError if it is nothing."""
    for old, new in RENAMED.items():
        if name == old or name.startswith(f"{old}."):
            name = new + name.removeprefix(old)
    if name in AS_METHODS:
        name = f"MainSystem.{name.rpartition('.')[2]}"
    owner, _, member = name.rpartition(".")
    if owner in MADE:
        return getattr(MADE[owner](), member)
    thing: Any = exu
    words = name.split(".")
    while words and (thing is exu or inspect.ismodule(thing)):
        try:
            thing = getattr(thing, words[0])
        except AttributeError:
            thing = importlib.import_module(f"{thing.__name__}.{words[0]}")
        words.pop(0)
    for word in words:
        thing = getattr(thing, word)
    return thing


def takes(name: str) -> bool:
    """Whether a function takes an argument, by this name or another one of it: 'module.function(argument)'."""
    function, _, argument = name.removesuffix(")").partition("(")
    made = create.functions.get(function.removeprefix("MainSystem."))
    found = find(function) if made is None else inspect.unwrap(made)
    return argument in inspect.signature(found).parameters or (made is not None and argument in other_names(found))


def has_parameter(name: str) -> bool:
    item, _, parameter = name.partition(".")
    return parameter in inspect.signature(getattr(exu.itemInterface, item)).parameters or hasattr(
        getattr(exu.itemInterface, item), parameter
    )


def has_setting(name: str) -> bool:
    settings, *words = name.split(".")
    thing: Any = getattr(exu, settings)()
    for word in words:
        thing = getattr(thing, word)
    return True


def is_there(kind: str, name: str) -> bool:
    try:
        if kind == "argument":
            return takes(name)
        if kind == "item parameter":
            return has_parameter(name)
        if kind == "setting":
            return has_setting(name)
        if kind == "output variable":
            item, _, output = name.partition(": ")
            return output in ItemInfo(item)["outputVariables"]
        if kind == "command":
            word = name.split()[-1]
            return word == "--version" or f"{{{word}" in cli._parser().format_usage() or word in cli_commands()
        if kind == "environment variable":
            return name in ENVIRONMENT
        find(name)
    except (AttributeError, ImportError):
        return False
    return True


def cli_commands() -> list[str]:
    actions = [action for action in cli._parser()._actions if action.dest == "command" or action.choices]
    return [name for action in actions for name in action.choices or ()]


def entries(name: str) -> list[str]:
    words = name.split(".")
    wide = [".".join(words[:i]) + ".*" for i in range(len(words), 0, -1)]
    return [entry for entry in (name, *wide) if entry in LEFT_OUT]


PAIRS = [(kind, name) for kind, names in REFERENCE.items() for name in names]


@pytest.mark.parametrize("kind", REFERENCE)
def test_names_are_there_or_left_out(kind: str) -> None:
    missing = {name for name in REFERENCE[kind] if not is_there(kind, name)}
    assert {name for name in missing if not entries(name)} == set()
    if kind != "command":  # that of dialogs refuses
        assert {name for name in REFERENCE[kind] if name in LEFT_OUT and name not in missing} == set()


def test_left_out_names_are_published() -> None:
    assert LEFT_OUT.keys() - {entry for _, name in PAIRS for entry in entries(name)} == set()


def test_messages_say_what_there_is_instead() -> None:
    with pytest.raises(
        AttributeError, match="attribute 'overrideSettings'; left out here, instead: settings in the model"
    ):
        exu.misc.overrideSettings  # noqa: B018
    with pytest.raises(AttributeError, match="'ShowImage'; left out here, instead: the page in the browser"):
        exu.interactive.ShowImage  # noqa: B018
    with pytest.raises(AttributeError, match="'GetGraphicsData'; left out here, instead: mbs.Draw, "):
        exu.SystemContainer().renderer.GetGraphicsData()  # type: ignore[attr-defined]
    with pytest.raises(ImportError, match="cannot import name 'StorePlotWindowGeometry' .* left out here, instead"):
        exec("from dalembert.plot import StorePlotWindowGeometry")
