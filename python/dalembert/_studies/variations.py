"""Many variations of one assembled model, solved by compiled code on all processors."""

# ruff: noqa: B006  (empty mappings as defaults; they are never written to)
from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import nullcontext
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from dalembert import _core
from dalembert._core import DynamicSolverType, SimulationSettings
from dalembert._solving.integrators import Kind, chosen_method, kind_of, trapezoidal_rule
from dalembert._solving.quiet import assemble_if_needed, given_or_default
from dalembert._studies.execution import number_of_threads
from dalembert._tools.found_items import find_item
from dalembert._tools.missing_names import nearest

_Parameters = Mapping[tuple[Any, str], ArrayLike]


@dataclass(frozen=True, repr=False)
class VariationResults:
    """Results of SolveVariations: arrays with a row per variation, NaN if a variation has no value.

    success: whether each variation was solved, K x bool; messages: error messages, '' if solved.
    warnings: warnings of the solver, K texts, '' if there are none.
    alone: reasons why a variation was solved separately, not in vector registers, K texts, '' if side by side.
    sideBySide: whether it was, K x bool.
    endTimes: time that was reached, K, in s.
    sensorValues: values of all sensors at the end, side by side, K x n.
    sensorHistories (storeHistories=True): time and these values at every time of writing, K x rows x (1 + n); a history
        that ends early has historyRows rows, and NaN behind.
    coordinates (storeCoordinates=True): the state at the end: an array K x size for each of 'ODE2', 'ODE2_t',
    'ODE2_tt',
        'ODE1', 'ODE1_t', 'AE', 'Data'.
    """

    success: NDArray[np.bool_]
    messages: list[str]
    warnings: list[str]
    alone: list[str]
    endTimes: NDArray[np.float64]
    sensorValues: NDArray[np.float64]
    sensorHistories: NDArray[np.float64]
    historyRows: NDArray[np.int32]
    coordinates: dict[str, NDArray[np.float64]]
    _columns: dict[int, slice]
    _names: dict[str, int]

    @property
    def sideBySide(self) -> NDArray[np.bool_]:
        """Whether each variation was solved together with others, K x bool."""
        return np.array([not reason for reason in self.alone], dtype=bool)

    def __repr__(self) -> str:
        """Number of variations, number of solved ones, stored data; and the first message if one failed."""
        solved, count = int(self.success.sum()), len(self.success)
        reason = next((f" (in the way: {text})" for text in self.alone if text), "")
        parts = [
            f"{solved} of {count} solved",
            f"{int(self.sideBySide.sum())} side by side{reason}",
            f"{len(self._columns)} sensors",
        ]
        if self.sensorHistories.size:
            parts.append(f"histories of up to {int(self.historyRows.max())} rows")
        if self.coordinates:
            parts.append("coordinates")
        failed = next((f"; variation {k}: {text}" for k, text in enumerate(self.messages) if text), "")
        return f"<VariationResults: {', '.join(parts)}{failed}>"

    def _of(self, sensor: Any) -> slice:
        if isinstance(sensor, str):
            known = ", ".join(self._names) or "none"
            if sensor not in self._names:
                hint = nearest(sensor, self._names)
                raise ValueError(f"sensor '{sensor}' was not among those that SolveVariations was given: {known}{hint}")
            return self._columns[self._names[sensor]]
        if int(sensor) not in self._columns:
            known = ", ".join(map(str, self._columns)) or "none"
            raise ValueError(f"sensor {int(sensor)} was not among those that SolveVariations was given: {known}")
        return self._columns[int(sensor)]

    def SensorValues(self, sensor: Any) -> NDArray[np.float64]:
        """Return the values of one sensor, by index or name, at the end: K x number of its values."""
        return self.sensorValues[:, self._of(sensor)]

    def SensorHistory(self, variation: int, sensor: Any) -> NDArray[np.float64]:
        """Return time and values of one sensor in one variation, as GetSensorStoredData would: rows x (1 + values)."""
        if not -len(self.success) <= variation < len(self.success):
            raise IndexError(f"SensorHistory: variation: expected less than {len(self.success)}, received {variation}")
        if not self.sensorHistories.size:
            raise ValueError("SensorHistory: there are no histories; call SolveVariations(..., storeHistories=True)")
        history = self.sensorHistories[variation, : self.historyRows[variation]]
        columns = self._of(sensor)
        return np.hstack((history[:, :1], history[:, 1 + columns.start : 1 + columns.stop]))


def _number_of_variations(arrays: Mapping[str, NDArray[Any]]) -> int:
    """Return the common number of rows."""
    if not arrays:
        raise ValueError("SolveVariations: nothing varies; give parameters, initialCoordinates or settings")
    rows = {}
    for name, values in arrays.items():
        if values.ndim == 0 or values.dtype.kind not in "biuf":
            raise ValueError(f"SolveVariations: {name}: expected an array of numbers with a row per variation")
        rows[name] = len(values)
    if len(set(rows.values())) > 1:
        text = ", ".join(f"{name}: {n}" for name, n in rows.items())
        raise ValueError(
            f"SolveVariations: expected arrays with one row per variation; the numbers of rows differ: {text}"
        )
    return next(iter(rows.values()))


def _sensor(mbs: Any, sensor: Any) -> int:
    where = "SolveVariations: sensors"
    return int(find_item(mbs, sensor, ("Sensor",), where) if isinstance(sensor, str) else sensor)


def _parameter_arrays(mbs: Any, parameters: _Parameters) -> list[tuple[Any, str, NDArray[Any]]]:
    for key in parameters:
        if not (isinstance(key, tuple) and len(key) == 2 and isinstance(key[1], str)):
            raise TypeError(
                f"SolveVariations: parameters: expected keys (item index, parameter name); received {key!r}"
            )

    def index_of(item: Any) -> Any:
        kinds = ("Object", "Node", "Load", "Marker")
        return find_item(mbs, item, kinds, "SolveVariations: parameters") if isinstance(item, str) else item

    return [(index_of(item), name, np.asarray(values)) for (item, name), values in parameters.items()]


def _kind(solverType: Any) -> Kind | Literal["static"]:
    if isinstance(solverType, str) and solverType == "static":
        return "static"
    return kind_of("SolveVariations", solverType)


def SolveVariations(
    mbs: Any,
    parameters: _Parameters = {},
    simulationSettings: SimulationSettings | None = None,
    solverType: DynamicSolverType | Literal["static"] | None = None,
    sensors: Sequence[Any] | None = None,
    initialCoordinates: Mapping[str, ArrayLike] = {},
    settings: Mapping[str, ArrayLike] = {},
    storeHistories: bool = False,
    storeCoordinates: bool = False,
    numberOfThreads: int | None = None,
    autoAssemble: bool = True,
) -> VariationResults:
    """Solve K variations of this system on all processors, in compiled code; the system does not change.

    parameters: an array per (index or name of an item, parameter name), whose row k is the value for SetObjectParameter
        or a similar function in variation k: K numbers, or K x shape for vectors and matrices.
    initialCoordinates: arrays K x size for 'ODE2' (displacements from the reference), 'ODE2_t', 'ODE2_tt', 'ODE1',
        'ODE1_t', 'AE' or 'Data'. Otherwise a variation starts from the initial state of the system or, if parameters of
        nodes vary, from the initial values of the nodes, as after Assemble().
    settings: K numbers for a path in simulationSettings, e.g. 'timeIntegration.endTime'.
    solverType: see SolveDynamic, or 'static' for SolveStatic.
    sensors: indices or names of the sensors whose values are wanted; None: all. storeHistories: values over time (see
        solutionSettings.sensorsWritePeriod); storeCoordinates: the state at the end.
    numberOfThreads: None: all processors. Results do not depend on it, bit for bit.

    A variation that cannot be solved has success False and a message; the other ones continue. Nothing is printed or
    written
    to files. Refused: unknown items and parameters, values that Set...Parameter refuses (the text names the variation),
    arrays of different lengths, and models with Python functions (RuntimeError), which would need the interpreter.
    """
    base = given_or_default("SolveVariations", simulationSettings)
    given = _parameter_arrays(mbs, parameters)
    coordinates = [(name, np.asarray(values)) for name, values in initialCoordinates.items()]
    if isinstance(settings, SimulationSettings):
        raise TypeError(
            "SolveVariations: settings: received SimulationSettings, but expected arrays by the names of settings that "
            "vary, such as {'timeIntegration.endTime': [1, 2]}; common values are in simulationSettings"
        )
    varied = [(path, np.asarray(values)) for path, values in settings.items()]
    method = base.timeIntegration.solverType if solverType is None else solverType
    kind = _kind(method)
    variations = _number_of_variations(
        {f"parameters[{index!r}, {name!r}]": values for index, name, values in given}
        | {f"initialCoordinates[{name!r}]": values for name, values in coordinates}
        | {f"settings[{path!r}]": values for path, values in varied}
    )
    assemble_if_needed("SolveVariations", mbs, autoAssemble)
    wanted = list(range(mbs.systemData.NumberOfSensors())) if sensors is None else [_sensor(mbs, s) for s in sensors]
    ends = np.cumsum([0, *(np.size(mbs.GetSensorValues(sensor)) for sensor in wanted)]).tolist()
    if kind == "explicit" and not isinstance(method, str):
        base.timeIntegration.explicitIntegration.dynamicSolverType = method
    own = base.timeIntegration.solverType if isinstance(method, str) else method
    is_trapezoidal = method == DynamicSolverType.TrapezoidalIndex2
    with chosen_method(base, own), trapezoidal_rule(base) if is_trapezoidal else nullcontext():
        found = _core._SolveVariations(
            mbs, base, kind, variations, given, varied, coordinates, wanted, storeHistories, storeCoordinates,
            number_of_threads(numberOfThreads),
        )  # fmt: skip
    columns = {sensor: slice(*ends[i : i + 2]) for i, sensor in enumerate(wanted)}
    names = {mbs.GetSensorParameter(sensor, "name"): sensor for sensor in wanted}
    return VariationResults(**found, _columns=columns, _names=names)
