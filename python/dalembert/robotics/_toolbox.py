"""Robots inside the package roboticstoolbox-python: the descriptions that it reads for its own models."""

from __future__ import annotations

import importlib
from pathlib import Path
from types import ModuleType
from typing import Any, NamedTuple
from unittest.mock import patch

from dalembert._tools.missing_names import nearest

_NAME = "GetRoboticsToolboxInternalModel"


class ToolboxModel(NamedTuple):
    """The text of a URDF file, with xacro done, the file that it came from, and the folder of packages."""

    text: str
    file: Path
    packages: Path


def _toolbox(module: str) -> ModuleType:
    try:
        return importlib.import_module(f"roboticstoolbox{module}")
    except ImportError as error:
        raise ImportError(
            f"{_NAME}: models inside the package roboticstoolbox-python need it (pip install roboticstoolbox-python): "
            f"{error}; a URDF file can be given to ReadRobot or LoadURDFrobot without it"
        ) from error


def toolbox_model(modelName: str) -> ToolboxModel:
    """Return the description of a model of rtb.models.URDF, as the toolbox reads it while it makes the model.

    The toolbox has no function for it, and its folders and its expansion of xacro differ between versions.
    """
    models, parser = _toolbox("").models.URDF, _toolbox(".tools.urdf").URDF
    found = {name: kind for name, kind in vars(models).items() if isinstance(kind, type) and name != "URDFRobot"}
    names = sorted(name for name, kind in found.items() if kind.__module__.startswith(models.__name__))
    if modelName not in names:
        hint = nearest(str(modelName), names)
        raise ValueError(f"{_NAME}: modelName: expected one of {', '.join(names)}, received {modelName!r}{hint}")
    texts: list[str] = []
    load = parser.loadstr

    def note(text: Any, *arguments: Any, **named: Any) -> Any:
        texts.append(text.decode() if isinstance(text, bytes) else str(text))
        return load(text, *arguments, **named)

    with patch.object(parser, "loadstr", note):
        try:
            robot = found[modelName]()
        except Exception as error:
            raise ValueError(f"{_NAME}: the toolbox cannot make its model '{modelName}': {error}") from error
    if len(texts) != 1:
        raise ValueError(f"{_NAME}: '{modelName}' is made of {len(texts)} URDF files; expected a model of one")
    folder = Path(importlib.import_module("rtbdata").__path__[0]) / "xacro"
    return ToolboxModel(texts[0], Path(getattr(robot, "urdf_filepath", "") or modelName), folder)
