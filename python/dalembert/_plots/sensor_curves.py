"""Data of the curves of PlotSensor: sensors, files or arrays become labelled data."""

from __future__ import annotations

import operator
import os
from collections.abc import Mapping
from dataclasses import dataclass
from itertools import islice
from typing import Any, NamedTuple

import numpy as np

from dalembert._checks import FloatArray, check_system, shape_error
from dalembert._core import MainSystem
from dalembert._io.files import file_to_read, read_table, require_last_line
from dalembert._io.output_paths import OutputFilePath
from dalembert._io.result_files import ParseOutputFileHeader
from dalembert._tools.found_items import names_of
from dalembert._tools.missing_names import nearest
from dalembert._tools.sensor_facts import component_name, continuous, unit_of, variable_of

# Instead of a component number: the norm of all values of a sensor.
componentNorm = -2


TIME = "time (s)"  # on axes


@dataclass
class Curve:
    """Data of one curve of PlotSensor."""

    name: str  # name in errors
    label: str
    variable: str  # name of the output variable
    data: FloatArray  # rows of [time, values]
    component: int
    component_x: int
    unit: str = ""
    name_x: str = ""  # variable and component on the x-axis

    @property
    def title(self) -> str:
        """The variable with its unit, for the y-axis."""
        return TIME if self.component == -1 else self._with_unit(self.variable)

    @property
    def title_x(self) -> str:
        """The same for the x-axis, with the component."""
        return TIME if self.component_x == -1 else self._with_unit(self.name_x)

    def _with_unit(self, name: str) -> str:
        return f"{name} ({self.unit})" if self.unit else name


class Of(NamedTuple):
    """A sensor of one of several systems that are compared."""

    mbs: Any
    sensor: Any
    system: int


def is_empty(value: Any) -> bool:
    return value is None or (not isinstance(value, (str, bytes)) and hasattr(value, "__len__") and len(value) == 0)


def is_list(value: Any) -> bool:
    return isinstance(value, (list, tuple, np.ndarray))


def per_curve(name: str, value: Any, n: int, fallback: Any, single: tuple[type, ...]) -> list[Any]:
    """Return one value per curve from nothing, a single value for all, or a list with at least n entries."""
    if is_empty(value):
        return [fallback] * n
    if isinstance(value, single) and not isinstance(value, bool):
        return [value] * n
    if is_list(value) and len(value) >= n:
        return list(value[:n])
    raise ValueError(
        f"PlotSensor: {name} must be a single value or a list with one entry per curve ({n}), not {value!r}"
    )


def match_lengths(sensorNumbers: Any, components: Any, componentsX: Any) -> list[tuple[Any, int, int]]:
    """Return (sensor, component, component of x) per curve; single values are repeated."""
    # A numpy array with two axes is data of one sensor.
    is_data = isinstance(sensorNumbers, np.ndarray) and sensorNumbers.ndim > 1
    sensors = list(sensorNumbers) if is_list(sensorNumbers) and not is_data else [sensorNumbers]
    if any(isinstance(sensor, MainSystem) for sensor in sensors):
        raise ValueError(
            "PlotSensor: sensorNumbers: received systems; several are compared by "
            "dalembert.plot.PlotSensor([mbs, other], sensorNumbers)"
        )
    values = list(components) if is_list(components) else [components]
    if len(values) == 1:
        values *= len(sensors)
    elif len(sensors) == 1:
        sensors *= len(values)
    if len(values) != len(sensors):
        raise ValueError(
            f"PlotSensor: {len(sensors)} sensorNumbers and {len(values)} components: give as many of both, "
            "or a single one of either"
        )
    if is_empty(componentsX):
        x_values = [-1] * len(sensors)
    else:
        x_values = list(componentsX) if is_list(componentsX) else [componentsX]
        if len(x_values) == 1:
            x_values *= len(sensors)
    if len(x_values) != len(sensors):
        raise ValueError(f"PlotSensor: componentsX has {len(x_values)} entries, but there are {len(sensors)} curves")
    components = [_component("components", value) for value in values]
    return list(zip(sensors, components, [_component("componentsX", value) for value in x_values], strict=True))


def _component(name: str, given: Any) -> int:
    try:
        return operator.index(given)
    except TypeError:
        if isinstance(given, (float, np.floating)) and float(given).is_integer():
            return int(given)
        expected = "numbers of components, 0 for the first, -1 for time, componentNorm for the norm of all"
        raise ValueError(f"PlotSensor: {name}: received {given!r}, but expected {expected}") from None


def _file_information(where: str, fileName: str, comments: str, delimiter: str) -> tuple[str, str, FloatArray]:
    """Return name, output variable and data of a sensor or solution file."""
    fileName = file_to_read(where, fileName)
    with open(fileName, errors="replace") as file:
        header = ParseOutputFileHeader(list(islice(file, 20)))
    name = os.path.basename(fileName.replace("\\", "/")).split(".")[0]
    variable = "Coordinates" if header.get("type") == "solution" else header.get("outputVariableType", "")
    return name, variable, _file_data(fileName, header, comments, delimiter)


def columns_of_file(where: str, fileName: str) -> int:
    """Return the number of columns of a sensor or solution file, without that of time."""
    return int(_file_information(where, fileName, "#", ",")[-1].shape[1]) - 1


def _file_data(fileName: str, header: Mapping[str, Any], comments: str, delimiter: str) -> FloatArray:
    """Return the rows of a file; files of solvers must be complete and agree with the header."""
    known = header.get("type") in ("sensor", "solution")
    if known:
        require_last_line(fileName)
    return read_table(
        fileName, comments, delimiter, len(header["columns"]) if known and len(header["columns"]) > 1 else None
    )


def _sensor_information(
    where: str, mbs: Any, sensor: Any, comments: str, delimiter: str
) -> tuple[str, str, FloatArray, str]:
    """Return name, output variable, data and unit of a sensor of a system."""
    try:
        number = operator.index(int(sensor) if hasattr(sensor, "GetTypeString") else sensor)
    except TypeError:
        expected = "indices or numbers of sensors, names of files, or arrays of numpy"
        raise shape_error(where, expected, sensor) from None
    check_system(f"{where.partition(':')[0]}: mbs", mbs)
    try:
        information = mbs.GetSensor(number)
    except (IndexError, TypeError, ValueError) as error:
        raise type(error)(f"{where}: {str(error).removeprefix('mbs.GetSensor(...): ')}") from None
    if information["storeInternal"]:
        data = np.atleast_2d(mbs.GetSensorStoredData(number))
    elif information["writeToFile"] and information["fileName"]:
        data = _file_information(where, OutputFilePath(information["fileName"]), comments, delimiter)[2]
    else:
        raise ValueError(
            f"{where}: sensor {number} {information['name']!r} keeps no data: "
            "create it with storeInternal=True, or with writeToFile=True and a fileName"
        )
    return information["name"], variable_of(mbs, information), data, unit_of(mbs, information)


def make_curves(
    mbs: Any,
    matched: list[tuple[Any, int, int]],
    useXYZcomponents: bool,
    comments: str,
    delimiter: str,
    continuousAngles: bool = False,
    where: str = "PlotSensor: sensorNumbers",
) -> list[Curve]:
    """Return the curves; errors begin with `where`, the function and its argument for sensors."""
    curves, function = [], where.partition(":")[0]
    for i, (sensor, component, component_x) in enumerate(matched):
        system, unit, number = mbs, "", None
        if isinstance(sensor, Of):
            system, sensor, number = sensor
        if isinstance(sensor, str) and system is not None:
            check_system(f"{function}: mbs", system)
        if isinstance(sensor, str) and system is not None and int(system.GetSensorNumber(sensor)) >= 0:
            sensor = system.GetSensorNumber(sensor)
        if isinstance(sensor, str):
            if system is not None and not os.path.exists(sensor):
                hint = nearest(sensor, names_of(system, ["Sensor"]))
                raise FileNotFoundError(f"{where}: there is neither a sensor nor a file named {sensor!r}{hint}")
            title = f"file {sensor!r}"
            name, variable, data = _file_information(where, sensor, comments, delimiter)
        elif isinstance(sensor, np.ndarray) and sensor.ndim > 0:
            title, name, variable, data = f"array {i}", "", "", np.atleast_2d(sensor)
        else:
            title = f"sensor {sensor}"
            name, variable, data, unit = _sensor_information(where, system, sensor, comments, delimiter)
        if number is not None:
            name += f" of system {number}"
        if data.shape[1] < 2:
            raise ValueError(f"{where}: {title} has no values yet; solve first")
        for column in {component, component_x} - {componentNorm}:
            if not 0 <= column + 1 < data.shape[1]:
                raise ValueError(
                    f"{function}: {title} has components 0 to {data.shape[1] - 2} (-1: time), but not {column}"
                )
        if continuousAngles:
            data = np.hstack((data[:, :1], continuous(variable, data[:, 1:])))

        def named(column: int, size: int = data.shape[1] - 1, variable: str = variable) -> str:
            written = component_name(variable, column, size) if useXYZcomponents else str(column)
            return f"{variable}{'norm' if column == componentNorm else written}"

        which = named(component)
        label = f"{name}, {which}" if name else which if len(matched) > 1 else ""  # an array has no name
        curves.append(Curve(title, label, variable, data, component, component_x, unit, named(component_x)))
    return curves


def coordinates(curve: Curve, offset: Any, factor: float) -> tuple[FloatArray, FloatArray]:
    """Return x and factor * (y + offset) of a curve; an array as offset also moves x, except for time."""
    x = curve.data[:, curve.component_x + 1]
    if curve.component == componentNorm:
        y = np.linalg.norm(curve.data[:, 1:], axis=1)
    else:
        y = curve.data[:, curve.component + 1]
    if np.ndim(offset) == 0:
        return x, factor * (y + float(offset))
    offset = np.asarray(offset, dtype=float)
    if curve.component == componentNorm:
        raise ValueError(f"PlotSensor: {curve.name}: the norm goes with scalar offsets only")
    if offset.shape != curve.data.shape:
        raise ValueError(
            f"PlotSensor: {curve.name}: offset has shape {offset.shape}, but the data has {curve.data.shape}"
        )
    if curve.component_x != -1:
        x = x + offset[:, curve.component_x + 1]
    return x, factor * (y + offset[:, curve.component + 1])


def shift_list(name: str, value: Any, n: int, fallback: float) -> list[Any]:
    """Return one offset or factor per curve; a numpy array with two axes is one offset for all curves."""
    if isinstance(value, np.ndarray) and value.ndim == 2:
        return [value] * n
    if is_list(value) and len(value) not in (0, n):
        raise ValueError(f"PlotSensor: {name} must be a number or a list with {n} entries, not {len(value)}")
    return per_curve(name, value, n, fallback, (int, float, np.number))
