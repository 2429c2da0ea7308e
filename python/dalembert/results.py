"""Results for other tools, with units: tables of pandas, data sets of xarray, HDF5 files.

pandas, xarray and h5py are extras: pip install 'dalembert[results]'.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Mapping
from enum import Enum
from types import ModuleType
from typing import Any, NamedTuple

import numpy as np

from dalembert import _version
from dalembert._checks import FloatArray, shape_error
from dalembert._core import MainSystem, SensorIndex, SimulationSettings
from dalembert._io.files import file_to_read, file_to_write, naming, replacing
from dalembert._io.solution_rows import COLUMNS
from dalembert._io.solution_states import LoadSolutionFile
from dalembert._tools.found_items import find_item
from dalembert._tools.sensor_facts import component_name, continuous, unit_of, variable_of

__all__ = ["LoadHDF5", "SaveHDF5", "SensorsToPandas", "SensorsToXarray", "SolutionToPandas", "SolutionToXarray"]

_SOLUTION_UNITS = ("various", "various/s", "various/s^2", "various", "various/s", "various", "various")


class _Measured(NamedTuple):
    """The stored values of one sensor."""

    name: str
    variable: str
    unit: str
    components: list[str]
    time: FloatArray
    values: FloatArray  # a row per time


def _extra(name: str, where: str) -> ModuleType:
    from importlib import import_module

    try:
        return import_module(name)
    except ImportError:
        raise ImportError(f"{where}: the package {name} is needed; install it with 'pip install {name}'") from None


def _measured(mbs: Any, sensors: Any, continuousAngles: bool, where: str) -> Iterator[_Measured]:
    """Return the stored values of sensors; None selects all sensors with stored values."""
    if not isinstance(mbs, MainSystem):
        raise TypeError(str(shape_error(f"{where}: mbs", "a system, such as SC.AddSystem() returns", mbs)))
    single = isinstance(sensors, (str, SensorIndex, int))
    wanted = range(mbs.systemData.NumberOfSensors()) if sensors is None else [sensors] if single else sensors
    for sensor in wanted:
        number = int(find_item(mbs, sensor, ("Sensor",), where) if isinstance(sensor, str) else sensor)
        information = mbs.GetSensor(number)
        if not information["storeInternal"]:
            if sensors is None:
                continue
            raise ValueError(
                f"{where}: sensor {number} '{information['name']}' keeps no data: give it storeInternal=True"
            )
        data = np.atleast_2d(mbs.GetSensorStoredData(number))
        if data.size == 0:
            raise ValueError(f"{where}: sensor {number} '{information['name']}' has stored nothing yet: solve first")
        variable = variable_of(mbs, information)
        values = continuous(variable, data[:, 1:]) if continuousAngles else data[:, 1:]
        components = [component_name(variable, i, values.shape[1]) for i in range(values.shape[1])]
        yield _Measured(information["name"], variable, unit_of(mbs, information), components, data[:, 0], values)


def SensorsToPandas(mbs: Any, sensors: Any = None, continuousAngles: bool = False) -> Any:
    """Return the stored values of sensors as a pandas.DataFrame over time, with a column per component: 'tip.X'.

    sensors: indices or names, or one of them; None: all with storeInternal=True. Units, by column, are in
    frame.attrs['units'].
    continuousAngles: angles go on beyond pi instead of jumping.
    """
    pandas = _extra("pandas", "SensorsToPandas")
    series: list[Any] = []
    units: dict[str, str] = {}
    for each in _measured(mbs, sensors, continuousAngles, "SensorsToPandas"):
        single = len(each.components) == 1
        columns = [each.name if single else f"{each.name}.{component}" for component in each.components]
        index = pandas.Index(each.time, name="time")
        series.append(pandas.DataFrame(each.values, index=index, columns=columns))
        units |= dict.fromkeys(columns, each.unit)
    frame = pandas.concat(series, axis=1) if series else pandas.DataFrame()
    frame.attrs = {"units": units, "time": "s", "dalembert": _version.__version__}
    return frame


def SensorsToXarray(mbs: Any, sensors: Any = None, continuousAngles: bool = False) -> Any:
    """Return the stored values of sensors as an xarray.Dataset with a variable per sensor, over time and component.

    Variables have the attributes 'units' and 'long_name' for plots of xarray and packages for units. sensors and
    continuousAngles: see SensorsToPandas.
    """
    xarray = _extra("xarray", "SensorsToXarray")
    parts = []
    for each in _measured(mbs, sensors, continuousAngles, "SensorsToXarray"):
        facts = {"units": each.unit, "long_name": each.variable}
        axis = f"{each.name}_component"
        single = len(each.components) == 1
        values = (("time",), each.values[:, 0]) if single else (("time", axis), each.values)
        coordinates = {"time": each.time} | ({} if single else {axis: each.components})
        parts.append(xarray.Dataset({each.name: (*values, facts)}, coords=coordinates))
    data = xarray.merge(parts, join="outer") if parts else xarray.Dataset()
    if "time" in data.coords:
        data["time"].attrs = {"units": "s"}
    data.attrs = {"dalembert": _version.__version__}
    return data


class _Coordinates(NamedTuple):
    """All coordinates of one kind in a solution file."""

    name: str
    unit: str
    values: FloatArray  # a row per time


def _solution(fileName: str | os.PathLike[str], where: str) -> tuple[FloatArray, list[_Coordinates]]:
    """Return the times in a solution file, and the kinds of coordinates that it has."""
    solution = LoadSolutionFile(file_to_read(f"{where}: fileName", fileName), verbose=False)
    data, start, found = np.atleast_2d(solution["data"]), 1, []
    for name, count, unit in zip(COLUMNS, solution["columnsExported"], _SOLUTION_UNITS, strict=False):
        if count:
            found.append(_Coordinates(name, unit, data[:, start : start + count]))
        start += count
    return data[:, 0], found


def SolutionToPandas(fileName: str | os.PathLike[str]) -> Any:
    """Return a solution file as a pandas.DataFrame over time, with a column per coordinate: 'ODE2Coordinates.0'.

    Units are in frame.attrs['units'], by column; coordinates of one kind have various ones.
    """
    pandas = _extra("pandas", "SolutionToPandas")
    time, kinds = _solution(fileName, "SolutionToPandas")
    columns = {f"{kind.name}.{i}": kind.unit for kind in kinds for i in range(kind.values.shape[1])}
    values = np.hstack([kind.values for kind in kinds]) if kinds else np.zeros((len(time), 0))
    frame = pandas.DataFrame(values, index=pandas.Index(time, name="time"), columns=list(columns))
    frame.attrs = {"units": columns, "time": "s", "dalembert": _version.__version__, "file": os.fspath(fileName)}
    return frame


def SolutionToXarray(fileName: str | os.PathLike[str]) -> Any:
    """Return a solution file as an xarray.Dataset: ODE2Coordinates and further coordinates, over time and
    coordinate."""
    xarray = _extra("xarray", "SolutionToXarray")
    time, kinds = _solution(fileName, "SolutionToXarray")
    variables = {
        kind.name: (("time", kind.name.partition("Coord")[0] + "_coordinate"), kind.values, {"units": kind.unit})
        for kind in kinds
    }
    made = xarray.Dataset(variables, coords={"time": ("time", time, {"units": "s"})})
    made.attrs = {"dalembert": _version.__version__, "file": os.fspath(fileName)}
    return made


def _with_names(settings: Any) -> Any:
    """Return settings as a file has them: members of enumerations by their names."""
    if isinstance(settings, Mapping):
        return {key: _with_names(value) for key, value in settings.items()}
    return settings.name if isinstance(settings, Enum) else settings


def _with_members(settings: Any, known: Any) -> Any:
    """Return settings of a file as SetDictionary takes them."""
    if isinstance(settings, Mapping) and isinstance(known, Mapping):
        return {key: _with_members(value, known.get(key)) for key, value in settings.items()}
    kind = type(known)
    return kind[settings] if isinstance(known, Enum) and settings in kind.__members__ else settings


def SaveHDF5(
    mbs: Any,
    fileName: str | os.PathLike[str],
    simulationSettings: SimulationSettings | None = None,
    sensors: Any = None,
    solutionFile: str | os.PathLike[str] | None = None,
    continuousAngles: bool = False,
) -> None:
    """Write stored sensor values, and optionally a solution file, to an HDF5 file, with units, settings and version.

    /sensors/NAME has the datasets time and values; attributes are variable, unit and components. /solution has a
    dataset per kind of coordinates. The settings, by default those of the last simulation, are stored as JSON in the
    attribute settings of the file.
    """
    h5py = _extra("h5py", "SaveHDF5")
    fileName = file_to_write("SaveHDF5: fileName", fileName)
    if solutionFile is not None:
        solutionFile = file_to_read("SaveHDF5: solutionFile", solutionFile)
    found = list(_measured(mbs, sensors, continuousAngles, "SaveHDF5"))
    solution = None if solutionFile is None else SolutionToXarray(solutionFile)
    with replacing(fileName) as written, h5py.File(written, "w") as file:
        file.attrs["dalembert"] = _version.__version__
        simulationSettings = simulationSettings or mbs.sys.get("simulationSettings")
        if simulationSettings is not None:
            file.attrs["settings"] = json.dumps(_with_names(simulationSettings.GetDictionary()), default=str)
        for each in found:
            group = file.create_group(f"sensors/{each.name.replace('/', '|')}")
            group.attrs.update(variable=each.variable, unit=each.unit, components=each.components)
            group["time"], group["values"] = each.time, each.values
            group["time"].attrs["unit"], group["values"].attrs["unit"] = "s", each.unit
        if solution is not None:
            group = file.create_group("solution")
            for name, array in [("time", solution["time"]), *solution.data_vars.items()]:
                group[name] = np.asarray(array)
                group[name].attrs["unit"] = array.attrs["units"]


def LoadHDF5(fileName: str | os.PathLike[str]) -> dict[str, Any]:
    """Read a file of SaveHDF5: version, settings (a dictionary), sensors and solution, with units.

    result['sensors']['tip'] has time, values, variable, unit and components; SetDictionary(result['settings']) of
    settings makes them those of the simulation.
    """
    h5py = _extra("h5py", "LoadHDF5")
    fileName = file_to_read("LoadHDF5: fileName", fileName)
    with naming(fileName), h5py.File(fileName, "r") as file:
        if "dalembert" not in file.attrs:
            raise ValueError(
                f"{os.fspath(fileName)}: SaveHDF5 has not written this file: it has no attribute 'dalembert'"
            )
        result: dict[str, Any] = {"version": str(file.attrs["dalembert"]), "sensors": {}, "solution": {}}
        result["settings"] = None
        if "settings" in file.attrs:
            result["settings"] = _with_members(json.loads(file.attrs["settings"]), SimulationSettings().GetDictionary())
        for name, group in file.get("sensors", {}).items():
            facts: dict[str, Any] = {"variable": str(group.attrs["variable"]), "unit": str(group.attrs["unit"])}
            facts["components"] = [str(component) for component in group.attrs["components"]]
            result["sensors"][name] = facts | {"time": group["time"][:], "values": group["values"][:]}
        for name, dataset in file.get("solution", {}).items():
            result["solution"][name] = {"values": dataset[:], "unit": str(dataset.attrs["unit"])}
    return result
