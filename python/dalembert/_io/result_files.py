"""Headers of text files with results: sensors, solutions, parameter variations and optimizations."""

from __future__ import annotations

import ast
import os
from collections.abc import Sequence
from itertools import pairwise
from typing import Any

from dalembert._checks import shape_error
from dalembert._io.files import file_to_read, file_to_write, replacing

_MAXIMUM_HEADER = 10


def _columns_below(header: Sequence[str], title: str) -> str:
    """Return the line after the one that starts with the title, without '#'; '' if it does not exist."""
    for line, following in pairwise(header):
        if line.startswith(title):
            return following.strip().lstrip("#")
    return ""


def _value(line: str) -> str:
    """Return the text after the last '=' of a line."""
    return line.rsplit("=", 1)[-1].strip()


def _bracketed(text: str) -> list[str]:
    """Return the comma separated entries of the first [...] in a text."""
    return [entry.strip() for entry in text.partition("[")[2].partition("]")[0].split(",")]


def _ranges(text: str) -> list[list[float]]:
    """Return [begin, end, number of values] for each ';'-separated range (tuple) or list of values in a text."""
    ranges = []
    for entry in filter(None, (part.strip() for part in text.split(";"))):
        values = ast.literal_eval(entry)
        if isinstance(values, tuple):
            ranges.append([float(values[0]), float(values[1]), *(int(n) for n in values[2:3])])
        else:
            ranges.append([float(min(values)), float(max(values)), len(values)])
    return ranges


def _parse_variation(header: Sequence[str], output: dict[str, Any]) -> None:
    columns = _columns_below(header, "#columns:")
    output["columns"] = [name.strip() for name in columns.split(",")] if columns else []
    if output["type"] == "parameterVariation":
        output["variableRanges"] = _ranges(_columns_below(header, "#parameter ranges"))


def _parse_sensor(header: Sequence[str], output: dict[str, Any]) -> None:
    variable = ""
    for line in header:
        if line.startswith("#measure"):
            words = line.split()
            output["sensorType"] = words[1] if len(words) > 1 else ""
            output["itemNumber"] = int(_value(line)) if "=" in line else -1
        elif "Object number" in line:
            output["objectNumber"] = int(_value(line))
        elif "OutputVariableType" in line:
            variable = output["outputVariableType"] = _value(line)
        elif "number of sensor values" in line:
            output["numberOfSensors"] = int(_value(line))
    output["columns"] = ["time"] + [f"{variable}{i}" for i in range(output.get("numberOfSensors", 0))]


def _parse_solution(header: Sequence[str], output: dict[str, Any]) -> None:
    for line in header:
        if "number of written coordinates" in line:
            names, _, sizes = line.partition("=")
            output["columns"] = ["time"] + [
                f"{name.strip('n')}-{i}"
                for name, size in zip(_bracketed(names), _bracketed(sizes), strict=True)
                for i in range(int(size))
            ]
        elif "number of time steps" in line:
            output["numberOfSteps"] = int(_value(line))


def ParseOutputFileHeader(lines: Sequence[str]) -> dict[str, Any]:
    """Read the header of a result file, given as the list of its lines.

    The result has 'type' ('sensor', 'solution', 'geneticOptimization', 'parameterVariation' or 'unknown'), 'columns'
    (names of the columns), 'variableRanges' ([begin, end, number] per varied parameter) and further data of the header:
    'outputVariableType', 'sensorType', 'itemNumber', 'numberOfSensors', 'numberOfSteps'. It is empty for an empty file.
    """
    if not isinstance(lines, (list, tuple)) or not all(isinstance(line, str) for line in lines[:_MAXIMUM_HEADER]):
        raise shape_error("ParseOutputFileHeader: lines", "a list of lines of text", lines)
    if len(lines) == 0:
        return {}
    header: list[str] = []
    for line in lines[:_MAXIMUM_HEADER]:
        if header and not line.startswith(("#", "functionData")):
            break
        header.append(line)
    output: dict[str, Any] = {"type": "unknown", "columns": [], "variableRanges": []}
    first = header[0]
    if "genetic optimization results file" in first:
        output["type"] = "geneticOptimization"
        _parse_variation(header, output)
    elif "parameter variation results file" in first:
        output["type"] = "parameterVariation"
        _parse_variation(header, output)
    elif "sensor output file" in first:
        output["type"] = "sensor"
        _parse_sensor(header, output)
    elif "solution file" in first:
        output["type"] = "solution"
        _parse_solution(header, output)
    return output


def FileStripSpaces(filename: str, outputFilename: str, fileCommentChar: str = "", removeDoubleChars: str = "") -> None:
    """Copy a text file without spaces at the ends of its lines.

    Lines that start with `fileCommentChar` are copied as they are; repetitions of the string `removeDoubleChars`
    become one, e.g. ' ' turns '1.0   3.0' into '1.0 3.0'.
    """
    filename = file_to_read("FileStripSpaces: filename", filename, empty=True)
    outputFilename = file_to_write("FileStripSpaces: outputFilename", outputFilename)
    if filename == outputFilename or (os.path.exists(outputFilename) and os.path.samefile(filename, outputFilename)):
        raise ValueError(f"FileStripSpaces: filename and outputFilename must differ, both are {filename!r}")
    with open(filename) as file:
        lines = file.readlines()
    with replacing(outputFilename) as written, open(written, "w") as file:
        for line in lines:
            if not fileCommentChar or not line.startswith(fileCommentChar):
                line = line.strip("\n").strip(" ") + "\n"
                while removeDoubleChars and removeDoubleChars * 2 in line:
                    line = line.replace(removeDoubleChars * 2, removeDoubleChars)
            file.write(line)
