"""Model: a system with its container, whose items are found by name and handled as objects."""

from __future__ import annotations

import inspect
import os
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from enum import Enum
from functools import cache
from typing import TYPE_CHECKING, Any, Literal, overload

from dalembert import _core, create
from dalembert._core import DynamicSolverType, MainSystem, OutputVariableType, SimulationSettings, SystemContainer
from dalembert._model import words
from dalembert._model.assembly import assemble, assemble_if_needed
from dalembert._model.handle import KINDS, Handle, handle_of, own, wrapped
from dalembert._model.solution import Solution, check_output
from dalembert._snake_case import snake_case
from dalembert._tools.item_facts import Output, facts_of, is_body, is_constraint
from dalembert._tools.missing_names import missing, nearest

if TYPE_CHECKING:
    from dalembert._create_methods import CreateMethods
    from dalembert._studies.differentiable_model import DifferentiableModel
else:

    class CreateMethods:
        """The create methods, which are attached below."""


GROUND = "ground"
# Five colors of the map viridis (N. Smith, S. van der Walt, 2015), whose lightness grows evenly.
_VIRIDIS = (
    (0.267, 0.005, 0.329), (0.229, 0.322, 0.546), (0.128, 0.567, 0.551), (0.369, 0.789, 0.383), (0.993, 0.906, 0.144)
)  # fmt: skip
# Arguments of Create functions that methods of Model do not have: handles and body_numbers take their place.
_OLD_ARGUMENTS = ("returnDict", "bodyList", "bodyOrNodeList")
_NAMED = ("Object", "Load", "Sensor")  # what users add; Create functions add nodes and markers
_SENSORS = {"Node": "SensorNode", "Marker": "SensorMarker", "Load": "SensorLoad"}


class Items(Sequence[Any]):
    """Handles in the order of their numbers: items[0], items["arm"], for item in items."""

    def __init__(self, handles: Iterable[Any], noun: str) -> None:
        self._handles, self._noun = tuple(handles), noun

    @overload
    def __getitem__(self, key: int | str) -> Any: ...
    @overload
    def __getitem__(self, key: slice) -> Items: ...
    def __getitem__(self, key: Any) -> Any:
        if isinstance(key, str):
            names = [each.name for each in self._handles]
            if key not in names:
                raise KeyError(_not_found(f"there is no {self._noun} '{key}'", key, names))
            return self._handles[names.index(key)]
        found = self._handles[key]
        return Items(found, self._noun) if isinstance(key, slice) else found

    def __len__(self) -> int:
        return len(self._handles)

    def __contains__(self, item: object) -> bool:
        return item in [each.name for each in self._handles] if isinstance(item, str) else item in self._handles

    def __repr__(self) -> str:
        return f"[{', '.join(map(repr, self._handles))}]"


def _not_found(text: str, name: str, names: Sequence[str]) -> str:
    known = f"; there are {', '.join(repr(each) for each in names[:20])}{', ...' * (len(names) > 20)}" if names else ""
    return f"{text}{nearest(name, names) or known or '; there are none'}"


class Model(CreateMethods):
    """A multibody model: bodies, joints, loads and sensors, its state, and solvers.

    Functions create_... add items and return handles. model["arm"] is an item by name, model.bodies lists the bodies.
    A new model contains the ground, an object with the name 'ground'.

    system: the MainSystem, for the interface with indices. container: its SystemContainer, with the settings of
    pictures. Model(system) is a model of a system that exists; its items stay as they are.
    """

    def __init__(self, system: MainSystem | None = None) -> None:
        if system is not None and not isinstance(system, MainSystem):
            raise TypeError(
                f"Model: system: received {system!r}, but expected a MainSystem, or nothing for a new model"
            )
        if system is None:
            self.container = _container()
            self.system: Any = self.container.AddSystem()
            self.system.CreateGround(name=GROUND)
        else:
            self.container = system.GetSystemContainer()
            self.system = system

    # ---- items

    def _items(self, kind: str, wanted: Callable[[str], bool] = lambda name: True) -> list[Any]:
        index, number = getattr(_core, f"{kind}Index"), getattr(self.system.systemData, f"NumberOf{kind}s")()
        handles = [handle_of(self.system, index(i)) for i in range(number)]
        return [each for each in handles if wanted(each._item)]

    @property
    def bodies(self) -> Items:
        """bodies, without the ground"""
        return Items(self._items("Object", lambda name: is_body(name) and name != "ObjectGround"), "body")

    @property
    def joints(self) -> Items:
        """joints and other constraints"""
        return Items(self._items("Object", is_constraint), "joint")

    @property
    def connectors(self) -> Items:
        """springs, dampers, contacts and other objects between bodies that are no constraints"""
        return Items(self._items("Object", lambda name: not is_body(name) and not is_constraint(name)), "connector")

    @property
    def loads(self) -> Items:
        """loads"""
        return Items(self._items("Load"), "load")

    @property
    def sensors(self) -> Items:
        """sensors"""
        return Items(self._items("Sensor"), "sensor")

    @property
    def nodes(self) -> Items:
        """nodes, of which Create functions add those of their bodies"""
        return Items(self._items("Node"), "node")

    @property
    def markers(self) -> Items:
        """markers, of which Create functions add those of their joints, connectors and loads"""
        return Items(self._items("Marker"), "marker")

    @property
    def ground(self) -> Any:
        """the ground"""
        return self[GROUND]

    def __getitem__(self, name: str) -> Any:
        if not isinstance(name, str):
            raise TypeError(f"model[...]: expected the name of an item, received {name!r}")
        for kinds in (_NAMED, ("Node", "Marker")):
            found = [index for kind in kinds if int(index := getattr(self.system, f"Get{kind}Number")(name)) >= 0]
            if len(found) > 1:
                several = " and ".join(repr(handle_of(self.system, index)) for index in found)
                raise KeyError(f"model['{name}']: {several} have this name; use model.bodies, model.loads, ...")
            if found:
                return handle_of(self.system, found[0])
        if name == GROUND and len(grounds := self._items("Object", lambda item: item == "ObjectGround")) == 1:
            return grounds[0]
        raise KeyError(_not_found(f"the model has no item '{name}'", name, [each.name for each in self]))

    def __iter__(self) -> Iterator[Any]:
        """Iterate over objects, loads and sensors; model.nodes and model.markers have the others."""
        return iter([each for kind in _NAMED for each in self._items(kind)])

    def __len__(self) -> int:
        return sum(getattr(self.system.systemData, f"NumberOf{kind}s")() for kind in _NAMED)

    def __bool__(self) -> bool:
        return True

    def __contains__(self, item: object) -> bool:
        if isinstance(item, Handle):
            return item._mbs is self.system
        if not isinstance(item, str):
            return False
        try:
            self[item]
        except KeyError:
            return False
        return True

    def add(self, item: Any) -> Any:
        """Add an item, such as db.NodePoint(...), db.MassPoint(...) or db.SensorBody(...), and return its handle."""
        name = type(item).__name__
        kind = next((each for each in KINDS if name.startswith(each)), "")
        if not kind or not isinstance(item, _core.Item):
            raise TypeError(f"model.add: expected an item, such as db.NodePoint(...), received {item!r}")
        return handle_of(self.system, getattr(self.system, f"Add{kind}")(item))

    def delete(self, item: Any) -> None:
        """Delete an item, given by its handle or name, like DeleteObject and so on of a system.

        A warning names items that refer to it and are invalid then. Handles of items with higher numbers raise
        ReferenceError: model["name"] returns a new one.
        """
        item = self._item_of(item, "model.delete")
        getattr(self.system, f"Delete{item._kind}")(item._number())

    def _item_of(self, item: Any, where: str) -> Any:
        """Return the handle of an item that is given by its handle, index or name."""
        if isinstance(item, str):
            return self[item]
        own(self.system, item, where)
        if not isinstance(item, tuple(getattr(_core, f"{kind}Index") for kind in KINDS)):
            raise TypeError(f"{where}: expected a handle or the name of an item, received {item!r}")
        return handle_of(self.system, item)

    def _require_new_name(self, where: str, name: Any) -> None:
        """Raise an error if an object, load or sensor has this name."""
        if isinstance(name, str) and name:
            found = [index for kind in _NAMED if int(index := getattr(self.system, f"Get{kind}Number")(name)) >= 0]
            if found:
                taken = handle_of(self.system, found[0])
                raise ValueError(f"{where}: name: '{name}' is the name of {taken!r}; choose another one")

    def create_sensor(
        self,
        item: Any,
        output: Any = None,
        *,
        local_position: Sequence[float] | None = None,
        mesh_node: int | None = None,
        name: str = "",
        file_name: str = "",
    ) -> Any:
        """Add a sensor that stores an output of an item, such as 'position' of a body, while a solver runs.

        item: handle or name of what is measured. output: name of the output; loads have none. local_position: point of
        a body, in its frame (m). mesh_node: node of a super element. file_name: file that is also written; '': none.
        """
        item = self._item_of(item, "model.create_sensor: item")
        self._require_new_name("model.create_sensor", name)
        common: dict[str, Any] = {
            "name": name,
            "storeInternal": True,
            "fileName": file_name,
            "writeToFile": bool(file_name),
        }
        if item._kind != "Load":
            where = f"model.create_sensor of {item!r}: output"
            if isinstance(output, str):
                check_output(item, snake_case(output), where)
                if source := facts_of(item._item).outputs.get(snake_case(output), Output("", 0, "", "")).source:
                    raise ValueError(
                        f"{where}: '{output}' is a part of '{snake_case(source)}', 3 numbers of force and 3 of torque: "
                        "create a sensor of that"
                    )
            common["outputVariableType"] = words.member(OutputVariableType, output, where)
            if not isinstance(common["outputVariableType"], OutputVariableType):
                known = ", ".join(f"'{each}'" for each in item.outputs)
                raise ValueError(f"{where}: received {output!r}, but expected one of {known}")
        body = item._kind == "Object" and is_body(item._item)
        if not body and (local_position is not None or mesh_node is not None):
            raise ValueError(f"model.create_sensor: {item!r} is no body and has no local_position or mesh_node")
        made: Any
        if mesh_node is not None:
            made = _core.SensorSuperElement(bodyNumber=item, meshNodeNumber=mesh_node, **common)
        elif body:
            made = _core.SensorBody(bodyNumber=item, localPosition=local_position or [0.0, 0.0, 0.0], **common)
        elif item._kind == "Object":
            made = _core.SensorObject(objectNumber=item, **common)
        elif item._kind in _SENSORS:
            made = getattr(_core, _SENSORS[item._kind])(**{f"{item._kind.lower()}Number": item}, **common)
        else:
            raise TypeError(f"model.create_sensor: {item!r} cannot be measured")
        return self.add(made)

    # ---- state and solution

    def assemble(self) -> None:
        """Check the model and set the state to the initial one; solvers and outputs do it if the model has changed."""
        assemble(self.system)

    @property
    def time(self) -> float:
        """time of the current state (s)"""
        assemble_if_needed(self.system)
        return float(self.system.systemData.GetTime())

    def solve(
        self,
        end_time: float,
        step_size: float | None = None,
        *,
        method: str | DynamicSolverType = "generalized_alpha",
        outputs: Sequence[Any] = (),
        every: float | None = None,
        start_time: float = 0.0,
        update_initial_values: bool = False,
        progress: bool | None = None,
        settings: SimulationSettings | None = None,
    ) -> Solution:
        """Integrate the equations of motion from the initial state to end_time (s), and return the solution.

        step_size: size of equal steps (s), or the next smaller one of which a whole number fits into the time; for
            methods with error control their largest size. method: generalized_alpha, trapezoidal_index2, esdirk43,
            explicit_euler, explicit_midpoint, rk33, rk44, rk67, velocity_verlet; with error control ode23, dopri5,
            dverk6, dop853.
        outputs: what is computed at once: [(arm, 'position'), (arm, 'velocity', [0.5, 0, 0]), 'hinge.force', sensor].
            Others can be read later: solution[arm].position.
        every: time between stored states and sensor values (s); None: all steps are stored.
        update_initial_values: True: the next solution starts from the final state, which becomes the initial values of
            the nodes; solutions start from the initial state otherwise.
        progress: show a bar after one second; None: in terminals and notebooks. Messages of the solver replace it.
        settings: all further settings; the arguments above replace those in a copy.

        SolverError has the diagnosis if a step cannot be solved. SolutionWarning: a check of the solution failed. No
        file is written, except for those named in sensors and settings.
        """
        from dalembert._model.solve import solve

        return solve(
            self,
            end_time,
            step_size,
            method=method,
            outputs=outputs,
            every=every,
            start_time=start_time,
            update_initial_values=update_initial_values,
            progress=progress,
            settings=settings,
        )

    def solve_static(
        self,
        *,
        outputs: Sequence[Any] = (),
        load_steps: int | None = None,
        update_initial_values: bool = False,
        settings: SimulationSettings | None = None,
    ) -> Solution:
        """Find the static equilibrium and return the solution; its times are load factors.

        Functions and tables of time, such as prescribed motions, are evaluated at the load factor, 1 at the end.
        load_steps: number of steps in which loads grow. update_initial_values: True: the next solution starts from the
        equilibrium. See solve for the others.
        """
        from dalembert._model.solve import solve_static

        return solve_static(
            self,
            outputs=outputs,
            load_steps=load_steps,
            update_initial_values=update_initial_values,
            settings=settings,
        )

    def differentiable(
        self,
        parameters: Mapping[str, Any],
        outputs: Mapping[str, Any],
        end_time: float,
        step_size: float | None = None,
        *,
        method: str | DynamicSolverType = "generalized_alpha",
        steps: Literal["frozen", "replay"] = "frozen",
        start_time: float = 0.0,
        settings: SimulationSettings | None = None,
    ) -> DifferentiableModel:
        """Return outputs of a solution as a function of parameters, with exact derivatives, for optimizers.

        parameters: places by name: {"k": (spring, "stiffness"), "x": (body, "reference_position", 0)}; several places
            in a list have one value. outputs: by name, such as {"a": db.At("sensor", times)}, or db.Integral("sensor").
            steps: see DifferentiableModel. See solve for the other arguments.
        """
        from dalembert._model.solve import differentiable

        return differentiable(
            self,
            parameters,
            outputs,
            end_time,
            step_size,
            method=method,
            steps=steps,
            start_time=start_time,
            settings=settings,
        )

    def draw(self, **options: Any) -> Any:
        """Return a picture of the current state; arguments of MainSystem.Draw, in snake_case too."""
        assemble_if_needed(self.system)
        return self.system.Draw(**camel_case(MainSystem.Draw, options, "model.draw"))

    def save(self, file_name: str | os.PathLike[str]) -> None:
        """Write the model to a JSON file, without FMUs."""
        from dalembert._model.fmi_import import events_of

        if events_of(self.system):
            raise ValueError("model.save: model files do not keep FMUs; save the model before model.add_fmu")
        self.system.Save(file_name)

    @classmethod
    def load(cls, file_name: str | os.PathLike[str]) -> Model:
        """Return the model of a JSON file, as save writes it."""
        system = _container().AddSystem()
        system.Load(file_name)
        return cls(system)

    def export_fmu(
        self,
        file_name: str | os.PathLike[str],
        inputs: Mapping[str, Any],
        outputs: Mapping[str, Any],
        step_size: float,
        *,
        parameters: Mapping[str, Any] | None = None,
        version: Literal["2.0", "3.0"] = "2.0",
        method: str | DynamicSolverType = "generalized_alpha",
        settings: SimulationSettings | None = None,
    ) -> None:
        """Write the model as an FMU for co-simulation, which other programs run with Python and dalembert.

        inputs: parameters by the names of the FMU: {"torque": load, "k": (spring, "stiffness"), "f": (load,
            "load_vector", 0)}; all entries of a vector are "f[1]", "f[2]", ...; constant between communications.
        outputs: {"angle": sensor, "x": (body, "position", 0), "v": "body.velocity"}: components are selected likewise.
        step_size: size of the steps, the largest one with error control (s); communication steps are multiples of it.
        parameters: like inputs, for tunable parameters of the FMU. version: of FMI. See solve for the others.
        """
        from dalembert._model.fmi_export import export_fmu

        export_fmu(
            self,
            file_name,
            inputs,
            outputs,
            step_size,
            parameters=parameters,
            version=version,
            method=method,
            settings=settings,
        )

    def add_fmu(
        self,
        file_name: str | os.PathLike[str],
        inputs: Mapping[str, Any],
        outputs: Mapping[str, Any],
        step_size: float,
        *,
        values: Mapping[str, Any] | None = None,
    ) -> Any:
        """Let an FMU for co-simulation, of FMI 2.0 or 3.0, act on the model while solve runs, such as a controller.

        At the times start_time + k step_size (s), the inputs of the FMU are measured, it advances by step_size, and its
        outputs are set, which the model holds until the next time. Each solution has a new instance of the FMU.

        inputs: what its inputs measure: {"x": sensor, "v": (body, "velocity", 0)}.
        outputs: what its outputs set: {"force": (load, "load_vector", 0), "k": (spring, "stiffness")}.
        values: start values of its parameters and other variables.
        """
        from dalembert._model.fmi_import import add_fmu

        return add_fmu(self, file_name, inputs, outputs, step_size, values=values)

    # ---- the model as an object

    if not TYPE_CHECKING:  # type checkers find misspelt names themselves

        def __getattr__(self, name: str) -> Any:
            text = f"a Model has no attribute '{name}'"
            if name.startswith("_") or name in ("system", "container"):
                raise AttributeError(text, name=name, obj=None)
            if hasattr(MainSystem, name):
                own_name = snake_case(name)
                hint = f"; use model.{own_name}" if hasattr(Model, own_name) else f"; use model.system.{name}"
            elif of_system := [each for each in dir(MainSystem) if snake_case(each) == name]:
                hint = f"; use model.system.{of_system[0]}"
            else:
                hint = nearest(name, [each for each in dir(Model) if not each.startswith("_")])
            raise missing(text, hint, name, None)

    def __reduce__(self) -> Any:
        return Model, (self.system,)

    def __repr__(self) -> str:
        numbers = ((each, len(getattr(self, each))) for each in ("bodies", "joints", "connectors", "loads", "sensors"))
        return f"<Model: {', '.join(f'{number} {name}' for name, number in numbers)}>"

    def _repr_html_(self) -> str:
        """Return a picture and a table of the items."""
        return str(self.system._repr_html_())


def _container() -> SystemContainer:
    """Return a new container, with the colors of viridis for contours."""
    container = SystemContainer()
    contour = container.visualizationSettings.contour.advanced
    for i, color in enumerate(_VIRIDIS):
        setattr(contour, f"contourColor{i}", [*color, 1.0])
    return container


def arguments_of(function: Callable[..., Any]) -> dict[str, str]:
    """Return the arguments of a function of the interface with indices, after mbs, by their snake_case names."""
    names = list(inspect.signature(function).parameters)[1:]
    return {snake_case(name): name for name in names if name not in _OLD_ARGUMENTS}


def camel_case(
    function: Callable[..., Any], given: dict[str, Any], where: str, without: Sequence[str] = ()
) -> dict[str, Any]:
    """Return arguments by the names of the interface with indices; TypeError for unknown ones and those without."""
    known = {name: own for name, own in arguments_of(function).items() if own not in without}
    result = {}
    for name, value in given.items():
        own_name = known.get(name, name)
        if own_name not in known.values() and name not in _other_names(function):
            hint = nearest(name, known) or f"; known are: {', '.join(known)}"
            raise TypeError(f"{where}: unknown argument '{name}'{hint}")
        if own_name in result:
            raise TypeError(f"{where}: argument '{name}' is given twice")
        result[own_name] = value
    return result


@cache
def _other_names(function: Callable[..., Any]) -> set[str]:
    """Return further names of arguments of Create functions, such as 'mass' of physicsMass."""
    original = inspect.unwrap(function)
    if not original.__module__.startswith("dalembert.create."):
        return set()
    from dalembert.create._mirrors import other_names

    return set(other_names(original))


def _value(function: Callable[..., Any], name: str, value: Any, where: str) -> Any:
    """Return an argument of a Create function for the interface with indices: texts for axes, colors, enumerations."""
    if not isinstance(value, str):
        return value
    lower = name.lower()
    where = f"{where}: {snake_case(name)}"
    if lower.startswith("color"):
        return words.color(value, where)
    if "axis" in lower or "normal" in lower or lower == "direction":
        return words.axis(value, where)
    parameter = inspect.signature(function).parameters.get(name)
    if parameter is not None and isinstance(parameter.default, Enum):
        return words.member(type(parameter.default), value, where)
    return value


class _Created:
    """A method of Model for a Create function; it is made when it is first used."""

    def __init__(self, name: str, create_name: str) -> None:
        self.name, self.create_name = name, create_name

    def __get__(self, instance: Any, owner: type) -> Any:
        if vars(Model).get(self.name) is self:
            setattr(Model, self.name, _create_method(self.name, self.create_name))
        return getattr(owner if instance is None else instance, self.name)


def _create_method(name: str, create_name: str) -> Callable[..., Any]:
    function = create.method(create_name)
    all_parameters = list(inspect.signature(function).parameters.values())[1:]
    parameters = [each for each in all_parameters if each.name not in _OLD_ARGUMENTS]

    def method(self: Model, *args: Any, **kwargs: Any) -> Any:
        where = f"model.{name}"
        if len(args) > len(parameters):
            raise TypeError(f"{where}: received {len(args)} positional arguments, but has only {len(parameters)}")
        given = camel_case(function, kwargs, where)
        for parameter, value in zip(parameters, args, strict=False):
            if parameter.name in given:
                raise TypeError(f"{where}: argument '{snake_case(parameter.name)}' is given twice")
            given[parameter.name] = value
        self._require_new_name(where, given.get("name"))
        for key, value in given.items():
            if "body" in key.lower():
                _require_no_parts(f"{where}: {snake_case(key)}", value)
            given[key] = _value(function, key, own(self.system, value, f"{where}: {snake_case(key)}"), where)
        try:
            return wrapped(self.system, function(self.system, **given))
        except (TypeError, ValueError) as error:
            if error.args and isinstance(error.args[0], str):
                error.args = (_renamed(error.args[0], create_name, name), *error.args[1:])
            raise

    own_parameters = [
        each.replace(name=snake_case(each.name), annotation=inspect.Parameter.empty) for each in parameters
    ]
    self_parameter = inspect.Parameter("self", inspect.Parameter.POSITIONAL_OR_KEYWORD)
    method.__signature__ = inspect.Signature([self_parameter, *own_parameters])  # type: ignore[attr-defined]
    method.__name__, method.__qualname__ = name, f"Model.{name}"
    method.__doc__ = _snake_case_text(function.__doc__ or "", [each.name for each in parameters], create_name, name)
    return method


def _require_no_parts(where: str, value: Any) -> None:
    """Raise the ValueError for the dictionary that create_beam and create_cable return, in the place of a body."""
    for each in value if isinstance(value, (list, tuple)) else (value,):
        if isinstance(each, dict):
            ends = " and ".join(f"['{name}']" for name in ("start", "end") if name in each)
            hint = f": its ends are {ends}" if ends else ""
            raise ValueError(f"{where}: expected a body or a marker, received a dictionary with its parts{hint}")


def _renamed(text: str, create_name: str, name: str) -> str:
    """Return the text of an error of a Create function with the names of Model."""
    text = text.replace(f"MainSystem.{create_name}(...)", f"model.{name}")
    return re.sub(r"(?<=argument ')\w+", lambda found: snake_case(found[0]), text)


def _snake_case_text(text: str, names: Sequence[str], create_name: str, name: str) -> str:
    """Return the documentation of a Create function without its example, with the names of Model."""
    text = re.sub(r"\s*returnDict=True[^.]*\.", "", text)
    text = text.partition("\nExample:")[0]
    for old in _OLD_ARGUMENTS:
        text = re.sub(rf"^    {old}: .*\n        .*\n", "", text, flags=re.MULTILINE)
    renamed = {each: snake_case(each) for each in names} | {f"mbs.{create_name}": f"model.{name}"}
    renamed |= {"ObjectIndex": "handle", "LoadIndex": "handle", "itemNumbers": "item_numbers"}
    for old, new in renamed.items():
        text = re.sub(rf"\b{re.escape(old)}\b", new, text)
    return text


for _functions in create.MODULES.values():
    for _function in _functions:
        setattr(Model, snake_case(_function), _Created(snake_case(_function), _function))
Model.__module__ = "dalembert"
