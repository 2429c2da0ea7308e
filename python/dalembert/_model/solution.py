"""Solution: states over time, from which all outputs of all items are computed when they are asked for.

A solution keeps a copy of the system as it was when the solver started, so that later changes of the model do not
influence it. Outputs are computed from the stored states and this copy. Two kinds of items need more than states: those
with user functions that keep data of their own, and those whose parameters step functions change; a warning names
them, and a sensor has their values. Values of sensors are those that were stored while the solver ran.
"""

from __future__ import annotations

import copy
import hashlib
import itertools
import json
import os
import warnings
from collections.abc import Sequence
from enum import Enum
from typing import Any, NamedTuple

import numpy as np

from dalembert import _core, _version
from dalembert._checks import FloatArray, as_number, shape_error
from dalembert._core import ConfigurationType, OutputVariableType, symbolic
from dalembert._io.solution_rows import solution_of
from dalembert._io.solution_states import _set_row, check_solution_of
from dalembert._model.assembly import assemble_if_needed
from dalembert._model.handle import Handle, handle_of, own, side_of
from dalembert._snake_case import snake_case
from dalembert._tools.item_facts import facts_of
from dalembert._tools.missing_names import missing, nearest
from dalembert._tools.sensor_facts import component_name, variable_of

_FORMAT = "dalembert solution 1"
_STATES = ("coordinates", "velocities", "accelerations", "ode1_coordinates", "ode1_velocities", "multipliers", "data")
_INDICES = (_core.NodeIndex, _core.ObjectIndex, _core.MarkerIndex)
_STEP_FUNCTIONS = ("PreStep", "PostStep", "PostNewton", "PreNewtonResidual", "EventAction", "ItemEventAction")
_WRITERS = {".html": "SaveHTML", ".htm": "SaveHTML", ".glb": "SaveGLB", ".pvd": "SaveVTU"}  # of motions, no films


class SolutionWarning(UserWarning):
    """A solution has finished, but a check of it failed, or an output may differ from that during the solution."""


SolutionWarning.__module__ = "dalembert"


_INEXACT = 1e-4  # error of the potential energy, relative to the largest energy, that is announced


class EnergyHistory(NamedTuple):
    """Energies over time (J)."""

    kinetic: FloatArray
    potential: FloatArray
    total: FloatArray


class _Key(NamedTuple):
    """An output of an item, perhaps at a point of a body."""

    item: str
    output: str
    point: tuple[float, ...] | None = None
    kind: str = ""  # Node, Object, ...: items of several kinds may have one name

    def __str__(self) -> str:
        at = "" if self.point is None else f"({', '.join(f'{x:g}' for x in self.point)})"
        return f"{self.item}.{self.output}{at}"


class Computed(NamedTuple):
    """Values of an output over time, with the name of the variable and its unit."""

    values: FloatArray
    variable: str
    unit: str
    time: FloatArray | None = None  # None: the times of the solution


def output_of(model: Any, wanted: Any, where: str) -> tuple[Any, str, Any]:
    """Return handle, output and local position of (item, 'position'), (item, 'position', point) or 'arm.position'."""
    if isinstance(wanted, str) and "." in wanted:
        item, _, name = wanted.rpartition(".")
        first, _, output = item.partition(".")
        if output and item not in model and first in model:  # such as 'arm.position.x'
            raise ValueError(
                f"{where}: received '{wanted}', but expected '{item}', with all components; "
                f"solution['{first}'].{output}[:, 0] is the first one"
            )
        wanted = [item, name]
    if isinstance(wanted, (Handle, str)):
        handle = model._item_of(wanted, where)
        if handle._kind == "Sensor":
            return handle, "values", None
        example = next(iter(handle.outputs), "position")
        raise ValueError(
            f"{where}: received {handle!r} without an output: write ({handle.name}, '{example}') for example"
        )
    if not isinstance(wanted, (tuple, list)) or not 2 <= len(wanted) <= 3:
        raise ValueError(
            f"{where}: expected (item, 'position'), (item, 'position', point) or 'arm.position', received {wanted!r}"
        )
    handle, name = model._item_of(wanted[0], where), snake_case(str(wanted[1]))
    check_output(handle, name, where)
    if len(wanted) == 3 and wanted[2] is not None and np.shape(wanted[2]) != (3,):
        raise ValueError(f"{where}: expected a point with 3 numbers as third entry, received {wanted[2]!r}")
    return handle, name, wanted[2] if len(wanted) == 3 else None


def check_output(handle: Any, name: str, where: str) -> None:
    known = ["values"] if handle._kind == "Sensor" else list(facts_of(handle._item).outputs)
    if name not in known:
        if handle._kind == "Load" and name == "value":
            return
        if handle._kind != "Sensor" and name in map(snake_case, OutputVariableType.__members__):
            return  # such as wrench_on_marker0, which tables do not have; the item refuses what it has not
        hint = nearest(name, known) or f". It has {', '.join(known)}" if known else ". It has none"
        raise ValueError(f"{where}: {handle!r} has no output '{name}'{hint}")


class Solution:
    """Result of model.solve: times, states, outputs of all items, energies, warnings and statistics.

    solution[arm].position, solution["arm"].position: an output over time, a row per time. times: in s. states:
    coordinates, velocities, accelerations, multipliers and data by name. warnings: texts. statistics: counts of the
    solver. method: name of the solver.
    """

    times: FloatArray
    method: str
    warnings: tuple[str, ...]
    statistics: dict[str, Any]

    def __init__(self, *arguments: Any) -> None:
        raise TypeError("Solution: model.solve(...) and db.Solution.load(fileName) return one")

    @classmethod
    def _of(
        cls, model: Any, snapshot: Any, states: Any, method: str, texts: Sequence[str], statistics: dict[str, Any]
    ) -> Solution:
        made = cls.__new__(cls)
        made._states, made.times = states, np.array(states["data"][:, 0])
        made.method, made.warnings, made.statistics = method, tuple(texts), statistics
        made._system, made._snapshot = model.system, snapshot
        made._computed, made._energies, made._warned = {}, None, set()
        made._sign = model.system.systemData._GetMultiplierSign(ConfigurationType.Current)
        made._step_functions = [
            name for name in _STEP_FUNCTIONS if getattr(model.system, f"Get{name}UserFunction")() not in (0, None)
        ]
        for sensor in model.sensors:
            if sensor.store_internal and (stored := np.atleast_2d(model.system.GetSensorStoredData(int(sensor)))).size:
                facts = model.system.GetSensor(int(sensor))
                computed = Computed(stored[:, 1:], variable_of(model.system, facts), sensor.unit, stored[:, 0])
                made._computed[_Key(sensor.name, "values", None, "Sensor")] = computed
        return made

    _states: dict[str, Any]
    _system: Any
    _snapshot: Any
    _computed: dict[_Key, Computed]
    _energies: EnergyHistory | None
    _warned: set[str]
    _sign: Any  # of multipliers: it differs between statics and dynamics
    _step_functions: list[str]

    # ---- what was solved

    @property
    def states(self) -> dict[str, FloatArray]:
        """coordinates (relative to the reference values) and so on, a row per time"""
        groups = np.split(self._states["data"][:, 1:], np.cumsum(self._states["columnsExported"])[:-1], axis=1)
        return dict(zip(_STATES, groups, strict=True))

    def __len__(self) -> int:
        return len(self.times)

    def __getitem__(self, item: Any) -> ItemSolution:
        """Return the outputs of an item, given by its handle, index or name."""
        if self._snapshot is None:
            names = {key.item for key in self._computed}
            name = item if isinstance(item, str) else getattr(item, "name", item)
            if name not in names:
                hint = nearest(str(name), names) or f"; there are {', '.join(sorted(names))}"
                raise KeyError(f"the file has no outputs of '{name}'{hint}. Load it with model=... for all outputs")
            return ItemSolution(self, None, str(name))
        from dalembert._model.model import Model

        if isinstance(item, str):
            return ItemSolution(self, Model(self._snapshot)[item], item)
        if not isinstance(item, Handle) and hasattr(item, "GetTypeString"):  # an index
            item = handle_of(self._system, item)
        if isinstance(item, Handle):
            own(self._system, item, "solution[...]")
            return ItemSolution(self, self._then(item), item.name)
        raise TypeError(f"solution[...]: expected a handle or the name of an item, received {item!r}")

    def _then(self, handle: Any) -> Any:
        """Return the handle of the same item in the system of the solution; the model may have other items since."""
        kind, system = handle._kind, self._snapshot
        handle._number()
        count = getattr(system.systemData, f"NumberOf{kind}s")()
        candidates = [int(handle), int(getattr(system, f"Get{kind}Number")(handle.name))]
        for number in candidates:
            if 0 <= number < count:
                found = handle_of(system, getattr(_core, f"{kind}Index")(number))
                if found.name == handle.name and found._item == handle._item:
                    return found
        raise KeyError(f"solution[...]: {handle!r} was added or renamed after the solution")

    @property
    def energies(self) -> EnergyHistory:
        """kinetic, potential and total energy over time (J); potential energy is zero in the reference configuration

        Loads and motors count as well: their forces at rest are part of the potential energy.
        """
        if self._energies is None:
            from dalembert._solving.energies import ComputeEnergies

            self._require_model("energies")
            found, error = [], 0.0
            for row in range(len(self)):
                self._set(row)
                energies = ComputeEnergies(self._snapshot)
                found.append((energies.kinetic, energies.potential, energies.total))
                error = max(error, energies.potentialError)
            self._energies = EnergyHistory(*np.array(found).T)
            largest = float(np.abs(np.array(found)).max(initial=0.0))
            if error > _INEXACT * largest:
                text = (
                    f"solution.energies: the potential energy is inexact by about {error:.2g} J of {largest:.3g} J, "
                    "because forces have kinks or jumps, such as those of stops and contacts"
                )
                warnings.warn(text, SolutionWarning, stacklevel=2)
        return self._energies

    def at(self, time: float) -> Solution:
        """Return the solution with one row: the stored state that is nearest to a time (s)."""
        time = as_number("solution.at: time", time)
        apart = np.abs(self.times - time)
        row, step = int(apart.argmin()), float(np.abs(np.diff(self.times)).max(initial=0.0))
        if not apart[row] <= step:
            expected = f"a time from {self.times.min():g} to {self.times.max():g} s"
            raise shape_error("solution.at: time", expected, time)
        made = copy.copy(self)
        made._states = {**self._states, "data": self._states["data"][[row]], "nRows": 1}
        made.times, made._energies, made._computed = self.times[[row]], None, {}
        for key, each in self._computed.items():
            nearest_row = row if each.time is None else int(np.abs(each.time - self.times[row]).argmin())
            stored = None if each.time is None else each.time[[nearest_row]]
            made._computed[key] = each._replace(values=each.values[[nearest_row]], time=stored)
        return made

    def _require_model(self, what: str) -> None:
        if self._snapshot is None:
            raise ValueError(
                f"solution.{what}: it is not in the file; db.Solution.load(file_name, model=model) can compute it"
            )

    def _set(self, row: int) -> None:
        values = self._states["data"][row]
        _set_row(self._snapshot, values, list(self._states["columnsExported"]), ConfigurationType.Current)
        self._snapshot.systemData._SetMultiplierSign(self._sign, ConfigurationType.Current)
        self._snapshot.systemData.SetTime(float(values[0]))

    def _compute(self, wanted: Sequence[tuple[Any, str, Any]]) -> list[Computed]:
        """Return outputs over time of items, given by handles of the model or of the copy."""
        keys, missing_ones = [], []
        for handle, name, point in wanted:
            at = None if point is None else tuple(float(x) for x in point)
            key = _Key(handle.name, name, at, handle._kind)
            keys.append(key)
            if key not in self._computed:
                missing_ones.append((key, handle))
        values: dict[_Key, list[Any]] = {key: [] for key, _ in missing_ones}
        handles = {}
        for key, handle in missing_ones:
            if handle._kind == "Sensor":
                raise ValueError(
                    f"solution['{key.item}']: {handle!r} has stored no values: "
                    "set its store_internal = True and solve again"
                )
            self._require_model(str(key))
            handles[key] = self._then(handle)
            self._warn(handles[key])
        for row in range(len(self) if values else 0):
            self._set(row)
            for key, rows in values.items():
                rows.append(_output(handles[key], key))
        for key, rows in values.items():
            fact = facts_of(handles[key]._item).outputs.get(key.output)
            unit = fact.unit if fact and fact.unit not in ("1", "various") else ""
            self._computed[key] = Computed(np.array(rows, dtype=float), _camel(handles[key], key), unit)
        return [self._computed[key] for key in keys]

    def _stored(self, item: str, output: str, point: tuple[float, ...] | None = None) -> Computed | None:
        """Return what has been computed of an item by its name, whichever its kind is."""
        wanted = (item, output, point)
        return next((each for key, each in self._computed.items() if (key.item, key.output, key.point) == wanted), None)

    def _warn(self, handle: Any) -> None:
        """Warn if outputs may differ from those during the solution."""
        facts = facts_of(handle._item).parameters
        if "marker_numbers" not in facts and handle._kind != "Load":
            return
        functions = [
            name
            for name, row in facts.items()
            if row.type == "function or 0" and not isinstance(given := handle._get(row.name), symbolic.UserFunction)
            if given not in (0, None)
        ]
        if not (functions or self._step_functions) or handle.name in self._warned:
            return
        self._warned.add(handle.name)
        cause = " and ".join([*functions, *(f"the {name} user function" for name in self._step_functions)])
        text = (
            f"solution['{handle.name}']: outputs are computed from stored states, with the parameters of the start. "
            f"They differ from those during the solution if {cause} keeps data or changes parameters; "
            "model.create_sensor(...) has the exact values"
        )
        warnings.warn(text, SolutionWarning, stacklevel=5)

    # ---- for other tools

    def _tabulated(self, where: str) -> dict[_Key, Computed]:
        """Return what has been computed, on the times of the solution."""
        if not self._computed:
            raise ValueError(
                f"{where}: no outputs yet: solve with outputs=[(arm, 'position')], or read solution[arm].position"
            )
        return self._computed

    def to_pandas(self) -> Any:
        """Return a pandas.DataFrame over time: a column per component of the outputs computed so far, and of sensors.

        Outputs are those in the argument outputs of solve, and all that have been read. frame.attrs['units'] has units.
        """
        from dalembert.results import _extra

        pandas = _extra("pandas", "Solution.to_pandas")
        series: list[Any] = []
        units: dict[str, str] = {}
        for key, each in self._tabulated("Solution.to_pandas").items():
            columns, values = _columns(key, each)
            units |= dict.fromkeys(columns, each.unit)
            index = pandas.Index(self.times if each.time is None else each.time, name="time")
            series.append(pandas.DataFrame(values, index=index, columns=columns))
        frame = pandas.concat(series, axis=1)
        frame.attrs = {"units": units, "time": "s", "dalembert": _version.__version__}
        return frame

    def to_xarray(self) -> Any:
        """Return an xarray.Dataset: a variable per output, over time and component; see to_pandas."""
        from dalembert.results import _extra

        xarray = _extra("xarray", "Solution.to_xarray")
        parts = []
        for key, each in self._tabulated("Solution.to_xarray").items():
            name = str(key).removesuffix(".values")
            facts = {"units": each.unit, "long_name": each.variable}
            columns, values = _columns(key, each)
            axis = f"{name}_component"
            coordinates: dict[str, Any] = {"time": self.times if each.time is None else each.time}
            data: Any = (("time",), values[:, 0], facts)
            if len(columns) > 1:
                data = (("time", axis), values, facts)
                coordinates[axis] = [column.rpartition(".")[2] for column in columns]
            parts.append(xarray.Dataset({name: data}, coords=coordinates))
        made = xarray.merge(parts, join="outer")
        made["time"].attrs = {"units": "s"}
        made.attrs = {"dalembert": _version.__version__, "method": self.method}
        return made

    def plot(self, *outputs: Any, ax: Any = None, file_name: str | os.PathLike[str] = "") -> Any:
        """Plot outputs over time, such as solution.plot("arm.position", "arm.velocity"); return the axes.

        Without arguments, all outputs computed so far are plotted. file_name: file of a picture that is also written.
        """
        from dalembert._model.curves import plot_curves

        keys = [self._key_of(each) for each in outputs] if outputs else list(self._tabulated("Solution.plot"))
        for key in keys:
            each = self._computed[key]
            times = self.times if each.time is None else each.time
            ax = plot_curves(ax, times, each.values, str(key).removesuffix(".values"), each.variable, each.unit)
        if len({self._computed[key].variable for key in keys}) > 1:
            ax.set_ylabel("")
        if file_name:
            from dalembert._io.files import file_to_write

            ax.figure.savefig(file_to_write("Solution.plot: file_name", file_name))
        return ax

    def animate(self, file_name: str | os.PathLike[str] = "", **options: Any) -> None:
        """Show the motion, or write a film, a page (.html), or a file for Blender (.glb) or ParaView (.pvd).

        Films are .gif, .webp, .mp4, and images 'frame%04d.png'. Without a file, notebooks play the motion in the cell,
        and the browser does elsewhere. model.container has the settings of pictures. options: arguments of
        MainSystem.DrawSolution for films, of SaveHTML, SaveGLB and SaveVTU for the others, such as speed=0.2 (time of
        the solution that passes in a second) and view="axonometric", and those of SolutionViewer without a file, such
        as row_increment=2.
        """
        from dalembert._model.model import camel_case
        from dalembert._pictures.renderer import state_of

        self._require_model("animate")
        name = os.fspath(file_name)
        ending = os.path.splitext(name)[1].lower()
        kind = _WRITERS.get(ending, "DrawSolution") if name else "SolutionViewer"
        where = f"solution.animate({name!r})" if name else "solution.animate() without a file"
        named = camel_case(getattr(_core.MainSystem, kind), options, where, without=("solution", "fileName"))
        system, container = self._snapshot, self._snapshot.GetSystemContainer()
        container.visualizationSettings = self._system.GetSystemContainer().visualizationSettings
        state_of(container.renderer, 0).update(state_of(self._system.GetSystemContainer().renderer, 0))  # the camera
        file = {"fileName": name} if name else {}
        getattr(system, kind)(**file, solution=self._states, **named)

    def _key_of(self, wanted: Any) -> _Key:
        if isinstance(wanted, str) and (found := [key for key in self._computed if wanted in (str(key), key.item)]):
            return found[0]
        self._require_model("plot")
        from dalembert._model.model import Model

        if isinstance(wanted, Handle) or (isinstance(wanted, tuple) and isinstance(wanted[0], Handle)):
            own(self._system, wanted, "solution.plot")
            rest = wanted[1:] if isinstance(wanted, tuple) else ()
            handle = self._then(wanted[0] if isinstance(wanted, tuple) else wanted)
            wanted = (handle, *rest) if rest else handle
        handle, name, point = output_of(Model(self._snapshot), wanted, "solution.plot")
        self._compute([(handle, name, point)])
        return _Key(handle.name, name, None if point is None else tuple(float(x) for x in point), handle._kind)

    # ---- files

    def save(self, file_name: str | os.PathLike[str]) -> None:
        """Write states, the outputs computed so far, values of sensors, warnings and statistics to an HDF5 file."""
        from dalembert._io.files import file_to_write, replacing
        from dalembert.results import _extra

        h5py = _extra("h5py", "Solution.save")
        file_name = file_to_write("Solution.save: file_name", file_name)
        with replacing(file_name) as written, h5py.File(written, "w") as file:
            file.attrs.update(format=_FORMAT, dalembert=_version.__version__, method=self.method)
            file.attrs["warnings"], file.attrs["statistics"] = json.dumps(self.warnings), json.dumps(self.statistics)
            file.attrs["multiplier_sign"] = self._sign
            file["states"] = self._states["data"]
            file["states"].attrs["columns"] = [int(n) for n in self._states["columnsExported"]]
            if self._snapshot is not None:
                file["items"] = json.dumps(_facts_of_items(self._snapshot))
            for number, (key, each) in enumerate(self._computed.items()):
                group = file.create_group(f"outputs/{number}")
                group.attrs.update(
                    item=key.item, kind=key.kind, output=key.output, variable=each.variable, unit=each.unit
                )
                group["values"] = each.values
                if key.point is not None:
                    group.attrs["point"] = key.point
                if each.time is not None:
                    group["time"] = each.time
            if self._energies is not None:
                for name, values in self._energies._asdict().items():
                    file[f"energies/{name}"] = values

    @classmethod
    def load(cls, file_name: str | os.PathLike[str], model: Any = None) -> Solution:
        """Read a file of save. If the model is given, as it was solved, all outputs can be computed.

        ValueError if items of the model, or their parameters, are others; initial values do not matter.
        """
        from dalembert._io.files import file_to_read, naming
        from dalembert.results import _extra

        h5py = _extra("h5py", "Solution.load")
        file_name = file_to_read("Solution.load: file_name", file_name)
        with naming(file_name), h5py.File(file_name, "r") as file:
            if file.attrs.get("format") != _FORMAT:
                raise ValueError(f"{os.fspath(file_name)}: Solution.save has not written this file")
            made = cls.__new__(cls)
            made._states = solution_of(file["states"][:], [int(n) for n in file["states"].attrs["columns"]])
            made.times, made.method = made._states["data"][:, 0].copy(), str(file.attrs["method"])
            made.warnings = tuple(json.loads(file.attrs["warnings"]))
            made.statistics = json.loads(file.attrs["statistics"])
            made._computed, made._warned, made._step_functions = {}, set(), []
            made._sign = file.attrs["multiplier_sign"].item()
            for group in sorted(file.get("outputs", {}).values(), key=lambda each: int(each.name.rpartition("/")[2])):
                facts = group.attrs
                point = tuple(float(x) for x in facts["point"]) if "point" in facts else None
                time = group["time"][:] if "time" in group else None
                key = _Key(str(facts["item"]), str(facts["output"]), point, str(facts.get("kind", "")))
                made._computed[key] = Computed(group["values"][:], str(facts["variable"]), str(facts["unit"]), time)
            solved = json.loads(file["items"][()]) if "items" in file else None
            energies = file.get("energies")
            made._energies = EnergyHistory(*(energies[name][:] for name in EnergyHistory._fields)) if energies else None
        made._system = made._snapshot = None
        if model is not None:
            assemble_if_needed(model.system)
            check_solution_of(model.system, "Solution.load", made._states)
            if solved is not None:
                _require_same_items(solved, _facts_of_items(model.system), os.fspath(file_name))
            made._system, made._snapshot = model.system, copy.copy(model.system)
        return made

    def __repr__(self) -> str:
        span = f"from {self.times[0]:g} s to {self.times[-1]:g} s" if len(self) else ""
        more = f", {len(self.warnings)} warnings" if self.warnings else ""
        return f"<Solution: {len(self)} states {span}, {self.method}{more}>"

    def __reduce__(self) -> Any:
        return _restored, (vars(self),)


Solution.__module__ = "dalembert"


def _facts_of_items(system: Any) -> list[list[str]]:
    """Return kind and number, name, type and a digest of the parameters of all items, without initial values."""
    found = []
    for kind in ("Node", "Object", "Marker", "Load"):
        for number in range(getattr(system.systemData, f"NumberOf{kind}s")()):
            item = getattr(system, f"Get{kind}")(number)
            digest = hashlib.sha256()
            for key, value in item.items():
                if not key.startswith(("V", "initial", "graphicsData")):
                    digest.update(_bytes_of(value))
            found.append(
                [f"{kind.lower()} {number}", item["name"], item[f"{kind.lower()}Type"], digest.hexdigest()[:16]]
            )
    return found


def _bytes_of(value: Any) -> bytes:
    if isinstance(value, (list, tuple)):
        return b"".join(map(_bytes_of, value))
    if isinstance(value, (bool, int, float, str, np.generic, np.ndarray)):
        return np.ascontiguousarray(value).tobytes()
    return str(value).encode() if isinstance(value, (Enum, *_INDICES)) else b""


def _require_same_items(solved: list[list[str]], given: list[list[str]], file_name: str) -> None:
    for before, now in itertools.zip_longest(solved, given):
        if before != now:
            what = before or now
            how = "has other parameters" if before and now and before[:3] == now[:3] else "is another item, or missing"
            raise ValueError(
                f"Solution.load: model: {what[0]} '{what[1]}' ({what[2]}) {how}; {file_name} belongs to another model. "
                "Give the model as it was solved, or none for the stored outputs"
            )


def _restored(content: dict[str, Any]) -> Solution:
    made = Solution.__new__(Solution)
    vars(made).update(content)
    return made


def _output(handle: Any, key: _Key) -> Any:
    if handle._kind == "Load":
        return handle.value
    value = handle.output(key.output, local_position=key.point)
    return np.asarray(value.GetMatrix() if hasattr(value, "GetMatrix") else value, dtype=float)


def _camel(handle: Any, key: _Key) -> str:
    fact = facts_of(handle._item).outputs.get(key.output)
    return fact.name if fact else key.output


def _columns(key: _Key, each: Computed) -> tuple[list[str], FloatArray]:
    values = np.reshape(each.values, (len(each.values), -1))
    name, n = str(key).removesuffix(".values"), values.shape[1]
    return ([name] if n == 1 else [f"{name}.{component_name(each.variable, i, n)}" for i in range(n)]), values


class ItemSolution:
    """Outputs of an item over time: solution[arm].position, solution[arm].position_at([0.5, 0, 0])."""

    def __init__(self, solution: Solution, handle: Any, name: str) -> None:
        self._solution, self._handle, self._name = solution, handle, name

    def _known(self) -> list[str]:
        if self._handle is None:
            return [key.output for key in self._solution._computed if key.item == self._name and key.point is None]
        if self._handle._kind == "Sensor":
            return ["time", "unit", "values"]
        if self._handle._kind == "Load":
            return ["value"]
        return [*facts_of(self._handle._item).outputs]

    def __dir__(self) -> list[str]:
        points = (
            [name for name in dir(self._handle) if name.endswith(("_at", "_on"))] if self._handle is not None else []
        )
        return sorted([*self._known(), *points, "output"])

    def output(self, name: str, local_position: Any = None) -> FloatArray:
        """Return an output by its name, perhaps of a point of a body, over time."""
        if self._handle is None:
            point = None if local_position is None else tuple(float(x) for x in local_position)
            computed = self._solution._stored(self._name, snake_case(name), point)
            if computed is None:
                raise self._missing(name)
        else:
            computed = self._solution._compute([(self._handle, snake_case(name), local_position)])[0]
        values = computed.values.copy()
        return values[:, 0] if values.ndim == 2 and values.shape[1] == 1 else values

    def _wrench_on(self, body: Any) -> FloatArray:
        """Return force and torque of a joint or connector on one of its bodies, a handle or the name of a body."""
        if isinstance(body, Handle):
            own(self._solution._system, body, "force_on")
            body = self._solution._then(body)
        return self.output(f"wrench_on_marker{side_of(self._handle, body)}")

    def _missing(self, name: str) -> AttributeError:
        known = self.__dir__()
        hint = nearest(name, known) or f". It has {', '.join(known)}"
        return missing(f"solution['{self._name}'] has no output '{name}'", hint, name, None)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        if name in ("time", "unit") and (stored := self._solution._stored(self._name, "values")) is not None:
            return getattr(stored, name)
        if name in self._known():
            return self.output(name)
        if name in ("force_on", "torque_on") and self._handle is not None and hasattr(type(self._handle), name):
            return lambda body: self._wrench_on(body)[:, :3] if name == "force_on" else self._wrench_on(body)[:, 3:]
        base = name.removesuffix("_at")
        if name.endswith("_at") and self._handle is not None and hasattr(type(self._handle), name):
            return lambda local_position: self.output(base, local_position)
        if self._handle is not None and (output := facts_of(self._handle._item).outputs.get(snake_case(name))):
            return self.output(output.name)
        if self._handle is not None and snake_case(name) in map(snake_case, OutputVariableType.__members__):
            return self.output(name)
        raise self._missing(name)

    def __repr__(self) -> str:
        return f"<solution of '{self._name}': {', '.join(self._known())}>"
