"""Names of output files in exu.config.outputDirectory."""

from __future__ import annotations

import os

from dalembert import _core
from dalembert._checks import shape_error


def OutputFilePath(fileName: str, callerInfo: str = "") -> str:
    """Return where a solver writes a file of this name: in exu.config.outputDirectory, if that is set.

    ValueError for an absolute name then.
    """
    directory = _core.config.outputDirectory
    if not directory or not fileName:
        return fileName
    if os.path.isabs(fileName):
        where = callerInfo or "OutputFilePath"
        expected = f"a relative name, because exu.config.outputDirectory is {directory!r}"
        raise shape_error(f"{where}: fileName", expected, fileName)
    return os.path.join(directory, fileName)


def CreateDirectoryForFile(fileName: str) -> None:
    """Make the folder of a file if it does not exist."""
    if folder := os.path.dirname(fileName):
        os.makedirs(folder, exist_ok=True)
