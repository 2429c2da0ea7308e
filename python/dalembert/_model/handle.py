"""Handles: indices of items that know their system, with parameters and outputs of the item as attributes.

A handle is an index, such as an ObjectIndex: it equals it, hashes like it, and functions with indices accept it.

* It refers to its system strongly, like the results of Create functions: `arm.position` works as long as `arm`
  exists, also if nothing else refers to the model. Systems do not refer to handles, unless users store some in
  mbs.variables.
* Pickles and deep copies contain the system. A model and its handles that are pickled or copied together, for example
  as a tuple, stay together. `int(handle)` is the number alone. `copy.copy(handle)` belongs to the same system.
* Handles of different systems are equal if their numbers are, because they are indices. Methods of Model refuse
  handles of other models.
* Deleting an item changes the numbers behind it. A handle remembers the name of its item, and raises ReferenceError if
  the name is found elsewhere or items have disappeared. Model gives a new handle.

The class of a handle is made when it is first needed, from the tables of parameters and outputs of the core; it is
named after the class of the item: dalembert.handles.ObjectRigidBody. handles.pyi has the same classes for editors.
The snake_case names follow from one rule, codegen/names.py. A name that could mean a parameter or an output, such as
`force` of a spring, raises an AttributeError that names `parameters.force` and `outputs.force`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import cache
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np

from dalembert import _core
from dalembert._checks import FloatArray
from dalembert._core import ConfigurationType, OutputVariableType
from dalembert._model import words
from dalembert._model.assembly import assemble_if_needed, needs_assembly
from dalembert._snake_case import snake_case
from dalembert._tools.item_facts import OF_WHOLE_BODY, Output, Row, facts_of, is_body
from dalembert._tools.item_packages import item_class
from dalembert._tools.missing_names import missing, nearest
from dalembert.create._created import CreatedObject

KINDS = ("Node", "Object", "Marker", "Load", "Sensor")
_INDICES = (_core.NodeIndex, _core.ObjectIndex, _core.MarkerIndex, _core.LoadIndex, _core.SensorIndex)


def class_name(mbs: Any, kind: str, number: int) -> str:
    """Return the name of the class of an item, such as 'ObjectMassPoint'."""
    return kind + str(getattr(mbs, f"Get{kind}")(number)[f"{kind.lower()}Type"])


def handle_of(mbs: Any, index: Any) -> Any:
    """Return the handle of an item; an index that is not set (-1) stays as it is."""
    kind = kind_of(index)
    return index if int(index) < 0 else handle_class(class_name(mbs, kind, int(index)))(mbs, int(index))


def kind_of(index: Any) -> str:
    """Return 'Node', 'Object', 'Marker', 'Load' or 'Sensor' of an index."""
    return KINDS[next(i for i, cls in enumerate(_INDICES) if isinstance(index, cls))]


def wrapped(mbs: Any, value: Any) -> Any:
    """Return a result of the interface with indices: handles in place of indices, also in lists and dictionaries."""
    if isinstance(value, _INDICES):
        return handle_of(mbs, value)
    if isinstance(value, dict):
        return {key: wrapped(mbs, each) for key, each in value.items()}
    if isinstance(value, (list, tuple)) and any(isinstance(each, _INDICES) for each in value):
        return [wrapped(mbs, each) for each in value]
    return value


def _readable(mbs: Any, value: Any) -> Any:
    """Return the value of a parameter such that changes of its entries, which had no effect, are refused."""
    if isinstance(value, list) and value and all(isinstance(each, (float, np.floating)) for each in value):
        value = np.array(value)
    if isinstance(value, np.ndarray):
        value = value.copy()
        value.setflags(write=False)
        return value
    value = wrapped(mbs, value)
    return tuple(value) if isinstance(value, list) else value


class _Group(Mapping[str, Any]):
    """A group of values of an item, by attribute and by key."""

    __slots__ = ("_handle",)

    def __init__(self, handle: Handle) -> None:
        object.__setattr__(self, "_handle", handle)

    def _names(self) -> list[str]:
        raise NotImplementedError

    def _get(self, name: str) -> Any:
        raise NotImplementedError

    def _set(self, name: str, value: Any) -> None:
        raise AttributeError(f"{self._handle!r}: output '{name}' cannot be set; solvers compute it")

    def _unknown(self, name: str) -> str:
        noun = type(self).__name__.lstrip("_").lower().rstrip("s").replace("drawing", "visualization parameter")
        known = self._names()
        hint = nearest(name, known) or f". Known are: {', '.join(known)}" if known else ""
        return f"{self._handle!r} has no {noun} '{name}'{hint}"

    def _found(self, name: str) -> str:
        known = self._names()
        return name if name in known else next((each for each in known if each == snake_case(name)), "")

    def __getitem__(self, name: str) -> Any:
        if not (found := self._found(name)):
            raise KeyError(self._unknown(name))
        return self._get(found)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_") or not (found := self._found(name)):
            raise missing(self._unknown(name), "", name, None)
        return self._get(found)

    def __setattr__(self, name: str, value: Any) -> None:
        if not (found := self._found(name)):
            raise missing(self._unknown(name), "", name, None)
        self._set(found, value)

    __setitem__ = __setattr__

    def __iter__(self) -> Iterator[str]:
        return iter(self._names())

    def __len__(self) -> int:
        return len(self._names())

    def __dir__(self) -> list[str]:
        return self._names()

    def __reduce__(self) -> Any:
        return type(self), (self._handle,)

    def __repr__(self) -> str:
        return f"{type(self).__name__.lstrip('_').lower()} of {self._handle!r}: {', '.join(self._names())}"


class _Parameters(_Group):
    """Parameters, and constants of recorded functions: parameters["spring_force_user_function.stiffness"]."""

    __slots__ = ()

    def _found(self, name: str) -> str:
        row, dot, constant = name.partition(".")
        found = super()._found(row)
        return f"{found}.{constant}" if found and dot else found

    def _names(self) -> list[str]:
        return list(facts_of(self._handle._item).parameters)

    def _row(self, name: str) -> Row:
        parameter, dot, constant = name.partition(".")
        row = facts_of(self._handle._item).parameters[parameter]
        return Row(f"{row.name}.{constant}", "float", "", "", row.text) if dot else row

    def _get(self, name: str) -> Any:
        return self._handle._get(self._row(name).name)

    def _set(self, name: str, value: Any) -> None:
        self._handle._set(self._row(name), value)


class _Drawing(_Group):
    __slots__ = ()

    def _names(self) -> list[str]:
        return list(facts_of(self._handle._item).visualization)

    def _get(self, name: str) -> Any:
        return self._handle._get(f"V{facts_of(self._handle._item).visualization[name].name}")

    def _set(self, name: str, value: Any) -> None:
        row = facts_of(self._handle._item).visualization[name]
        self._handle._set(row, value, "V")


class _Outputs(_Group):
    __slots__ = ()

    def _names(self) -> list[str]:
        return list(facts_of(self._handle._item).outputs)

    def _get(self, name: str) -> Any:
        return self._handle.output(facts_of(self._handle._item).outputs[name].name)


class Handle:
    """An item of a system: an index with the parameters and outputs of the item as attributes."""

    __slots__ = ()
    _mbs: Any
    _name: str
    _count: int
    _item: ClassVar[str] = ""
    _kind: ClassVar[str] = ""
    _shown: ClassVar[tuple[str, ...]] = ()  # names for completion

    def __new__(cls, mbs: Any, number: int) -> Any:
        if not cls._item:
            raise TypeError(f"{cls.__name__} is a base class; model['name'] and model.create_... return handles")
        made: Any = super().__new__(cls, number)  # type: ignore[call-arg]
        object.__setattr__(made, "_mbs", mbs)
        object.__setattr__(made, "_name", getattr(mbs, f"Get{cls._kind}Parameter")(number, "name"))
        object.__setattr__(made, "_count", getattr(mbs.systemData, f"NumberOf{cls._kind}s")())
        return made

    def __init__(self, mbs: Any, number: int) -> None:
        pass

    if TYPE_CHECKING:

        @property
        def name(self) -> str:
            """name of the item"""

        @name.setter
        def name(self, value: str) -> None: ...

    # ---- the item in the system

    def _number(self) -> int:
        """Return the number; ReferenceError if it belongs to another item now."""
        number, kind = int(self), self._kind  # type: ignore[call-overload]
        count = getattr(self._mbs.systemData, f"NumberOf{kind}s")()
        name = getattr(self._mbs, f"Get{kind}Parameter")(number, "name") if number < count else None
        if name != self._name:
            elsewhere = int(getattr(self._mbs, f"Get{kind}Number")(self._name)) >= 0
            if elsewhere or count < self._count or class_name(self._mbs, kind, number) != self._item:
                advice = f"model['{self._name}'] returns its new handle" if elsewhere else "it was deleted"
                raise ReferenceError(
                    f"this handle is no longer valid: items were deleted, and {kind.lower()} {number} is not "
                    f"'{self._name}' any more; {advice}"
                )
            object.__setattr__(self, "_name", name)  # renamed by the interface with indices
        return number

    def _get(self, name: str) -> Any:
        return _readable(self._mbs, getattr(self._mbs, f"Get{self._kind}Parameter")(self._number(), name))

    def _recorded(self) -> dict[str, _core.symbolic.UserFunction]:
        """Return the recorded functions by the names of their parameters."""
        functions = [row.name for row in facts_of(self._item).parameters.values() if row.type == "function or 0"]
        given = {each: getattr(self._mbs, f"Get{self._kind}Parameter")(self._number(), each) for each in functions}
        return {each: law for each, law in given.items() if isinstance(law, _core.symbolic.UserFunction)}

    def _constants(self, name: str) -> list[str]:
        """Return the full names of the constant of this name of recorded functions, which replaces a parameter."""
        return [f"{each}.{name}" for each, law in self._recorded().items() if name in law._Variables()]

    def _unread(self, name: str) -> str:
        """Return why a parameter has no effect, as a law of dalembert.laws takes its place, or an empty text."""
        if not (recorded := self._recorded()) or self._constants(name):
            return ""
        from dalembert.laws import unread_parameters

        for function, law in recorded.items():
            if name in unread_parameters(self._item, function, law):
                own_name = snake_case(function)
                known = ", ".join(f"'{own_name}.{each}'" for each in law._Variables())
                remedy = f"Set a constant of the law: {known}" if known else "Create the item with another law"
                return f"{snake_case(name)} has no effect, because the law in {own_name} replaces it. {remedy}"
        return ""

    def _set(self, row: Row, value: Any, prefix: str = "") -> None:
        number = self._number()
        if not prefix and (reason := self._unread(row.name)):
            raise ValueError(f"{self!r}: {reason}")
        where = f"{self!r}: {snake_case(row.name)}"
        value = words.value_of(own(self._mbs, value, where), row.type, row.check, where)
        getattr(self._mbs, f"Set{self._kind}Parameter")(number, prefix + row.name, value)
        if self._kind == "Node" and row.name.startswith(("initial", "reference")):
            needs_assembly(self._mbs)
        if row.name == "name" and not prefix:
            object.__setattr__(self, "_name", value)

    @property
    def type(self) -> str:
        """type of the item, such as 'MassPoint'"""
        return self._item.removeprefix(self._kind)

    @property
    def parameters(self) -> Any:
        """parameters by name, of which some have the same name as an output: spring.parameters.force"""
        return _Parameters(self)

    @property
    def outputs(self) -> Any:
        """current outputs by name: spring.outputs.force"""
        return _Outputs(self)

    @property
    def visualization(self) -> Any:
        """how the item is drawn: spring.visualization.color = 'red'"""
        return _Drawing(self)

    def show(self) -> None:
        """Draw the item."""
        self._set(Row("show", "bool", "", "", ""), True, "V")

    def hide(self) -> None:
        """Do not draw the item."""
        self._set(Row("show", "bool", "", "", ""), False, "V")

    # ---- outputs

    def _arguments(self, local_position: Any, mesh_node: Any) -> tuple[str, tuple[Any, ...]]:
        """Return the function of the system that computes outputs of the item, and its arguments in the middle."""
        if local_position is not None or mesh_node is not None:
            raise TypeError(
                f"{self!r}: only outputs of bodies have a local_position, only those of super elements a mesh_node"
            )
        return f"Get{self._kind}Output", ()

    def output(
        self, variable: Any, *, local_position: Any = None, configuration: Any = "current", mesh_node: Any = None
    ) -> Any:
        """Return an output variable, such as 'position', in a configuration, such as 'reference' or 'initial'.

        local_position: point of a body, in its frame (m). mesh_node: node of a super element, by number. The system is
        assembled if it has been changed.
        """
        where = f"{self!r}: output"
        own_output = facts_of(self._item).outputs.get(snake_case(variable)) if isinstance(variable, str) else None
        part = own_output.part if own_output else slice(None)
        try:
            variable = words.member(OutputVariableType, own_output and own_output.source or variable, where)
        except ValueError:
            known = list(facts_of(self._item).outputs)
            hint = nearest(snake_case(variable), known) or f". It has {', '.join(known) or 'none'}"
            raise ValueError(f"{self!r} has no output '{variable}'{hint}") from None
        configuration = words.member(ConfigurationType, configuration, f"{where}: configuration")
        number = self._number()
        assemble_if_needed(self._mbs)
        function, arguments = self._arguments(local_position, mesh_node)
        value = getattr(self._mbs, function)(number, variable, *arguments, configuration=configuration)
        return shaped(variable, value if part == slice(None) else value[part])

    # ---- the handle as an object

    if not TYPE_CHECKING:  # type checkers find misspelt names themselves

        def __getattr__(self, name: str) -> Any:
            text = f"{self._description()} has no attribute '{name}'"
            if name.startswith("_"):
                raise AttributeError(text, name=name, obj=None)
            if output := facts_of(self._item).ambiguous.get(snake_case(name)):
                hint = f"'{name}' could be the parameter or the output: write parameters.{name} or outputs.{output}"
                raise missing(f"{self._description()}: ", hint, name, None)
            hint = nearest(name, self._shown) or f". It has {', '.join(self._shown)}"
            if snake_case(name) in facts_of(self._item).visualization:
                hint = f"; write visualization.{snake_case(name)}"
            raise missing(text, hint, name, None)

        def __setattr__(self, name: str, value: Any) -> None:
            member = getattr(type(self), name, None)
            if member is None:
                self.__getattr__(name)  # which explains
            if not isinstance(member, property) or member.fset is None:
                raise AttributeError(f"{self!r}: '{name}' cannot be set")
            member.fset(self, value)

    def __dir__(self) -> list[str]:
        return list(self._shown)

    def __reduce__(self) -> Any:
        return _restored, (self._mbs, self._kind, int(self))  # type: ignore[call-overload]

    def _description(self) -> str:
        return f"{self.type} '{self._name}' ({self._kind.lower()} {int(self)})"  # type: ignore[call-overload]

    def __repr__(self) -> str:
        return f"<{self._description()}>"

    __str__ = __repr__

    def _repr_html_(self) -> str:
        """Return a table of parameters and, if the system is assembled, of outputs."""
        from html import escape

        from dalembert._plots.repr_html import _table

        facts = facts_of(self._item)
        rows = [
            (name, _short(self._get(row.name)), row.facts.partition("unit ")[2].partition(";")[0], row.text)
            for name, row in facts.parameters.items()
            if name == snake_case(row.name)
        ]
        page = f"<p>{escape(self._description())}</p>{_table(('parameter', 'value', 'unit', 'meaning'), tuple(rows))}"
        if facts.outputs and self._mbs.systemIsConsistent:
            rows = [
                (name, _short(self._try_output(each.name)), each.unit, each.text)
                for name, each in facts.outputs.items()
            ]
            page += _table(("output", "value", "unit", "meaning"), tuple(rows))
        return f"<div>{page}</div>"

    def _try_output(self, name: str) -> Any:
        try:
            return self.output(name)
        except (ValueError, RuntimeError) as error:  # some need a mesh node, for example
            return f"({str(error).partition(': ')[2] or error})"


def shaped(variable: OutputVariableType, value: Any) -> Any:
    """Return an output: rotation matrices have three rows."""
    if variable == OutputVariableType.RotationMatrix and np.size(value) == 9:
        return np.asarray(value).reshape(3, 3)
    return value


def own(mbs: Any, value: Any, where: str) -> Any:
    """Return the value; ValueError for handles of another system."""
    for each in value if isinstance(value, (list, tuple)) else (value,):
        if isinstance(each, Handle) and each._mbs is not mbs:
            raise ValueError(f"{where}: {each!r} belongs to another model")
        if isinstance(each, Handle):
            each._number()
    return value


def _short(value: Any) -> str:
    text = np.array2string(value, precision=6, threshold=20) if isinstance(value, np.ndarray) else str(value)
    return text if len(text) <= 80 else f"{text[:77]}..."


def _restored(mbs: Any, kind: str, number: int) -> Any:
    return handle_of(mbs, getattr(_core, f"{kind}Index")(number))


class NodeHandle(Handle, _core.NodeIndex):
    """A node."""

    __slots__ = ("_count", "_mbs", "_name")
    _kind = "Node"

    @property
    def markers(self) -> list[Any]:
        """markers on the node"""
        return _referring(self, "Marker", "nodeNumber")

    @property
    def bodies(self) -> list[Any]:
        """bodies with this node"""
        return _referring(self, "Object", "nodeNumber")


class ObjectHandle(Handle, _core.ObjectIndex):
    """A body, connector or joint."""

    __slots__ = ("_count", "_mbs", "_name")
    _kind = "Object"

    @property
    def nodes(self) -> list[Any]:
        """nodes with the coordinates of the object"""
        self._number()
        return _handles(self._mbs, CreatedObject.nodes.fget(self))  # type: ignore[attr-defined]

    @property
    def markers(self) -> list[Any]:
        """markers of a connector or joint, or markers on a body or on its nodes"""
        self._number()
        return _handles(self._mbs, CreatedObject.markers.fget(self))  # type: ignore[attr-defined]

    @property
    def loads(self) -> list[Any]:
        """loads on a body, including its weight"""
        self._number()
        return _handles(self._mbs, CreatedObject.loads.fget(self))  # type: ignore[attr-defined]

    @property
    def sensors(self) -> list[Any]:
        """sensors that measure the object"""
        return _referring(self, "Sensor", "objectNumber") + _referring(self, "Sensor", "bodyNumber")

    def _arguments(self, local_position: Any, mesh_node: Any) -> tuple[str, tuple[Any, ...]]:
        if mesh_node is not None:
            return "GetObjectOutputSuperElement", (mesh_node,)
        if is_body(self._item) and self._item != "ObjectGenericODE1":
            return "GetObjectOutputBody", ([0.0, 0.0, 0.0] if local_position is None else local_position,)
        return super()._arguments(local_position, mesh_node)


class MarkerHandle(Handle, _core.MarkerIndex):
    """A marker."""

    __slots__ = ("_count", "_mbs", "_name")
    _kind = "Marker"

    @property
    def loads(self) -> list[Any]:
        """loads on the marker"""
        return _referring(self, "Load", "markerNumber")


class LoadHandle(Handle, _core.LoadIndex):
    """A load."""

    __slots__ = ("_count", "_mbs", "_name")
    _kind = "Load"

    @property
    def value(self) -> Any:
        """current value of the load"""
        number = self._number()
        assemble_if_needed(self._mbs)
        return self._mbs.GetLoadValues(number)


class SensorHandle(Handle, _core.SensorIndex):
    """A sensor."""

    __slots__ = ("_count", "_mbs", "_name")
    _kind = "Sensor"

    @property
    def value(self) -> Any:
        """current value"""
        number = self._number()
        assemble_if_needed(self._mbs)
        return self._mbs.GetSensorValues(number)

    def _stored(self) -> FloatArray:
        number = self._number()
        if not self._mbs.GetSensorParameter(number, "storeInternal"):
            raise ValueError(f"{self!r} stores no values: set its store_internal = True and solve")
        data = np.atleast_2d(self._mbs.GetSensorStoredData(number))
        if data.size == 0:
            raise ValueError(f"{self!r} has no values yet: call model.solve(...)")
        return data

    @property
    def time(self) -> FloatArray:
        """times of the stored values (s)"""
        return self._stored()[:, 0]

    @property
    def values(self) -> FloatArray:
        """stored values, a row per time; a vector if there is one component"""
        data = self._stored()[:, 1:]
        return data[:, 0] if data.shape[1] == 1 else data

    @property
    def unit(self) -> str:
        """unit of the values; '' if it depends on the component"""
        from dalembert._tools.sensor_facts import unit_of

        return unit_of(self._mbs, self._mbs.GetSensor(self._number()))

    def plot(self, ax: Any = None) -> Any:
        """Plot all components over time; return the axes of matplotlib."""
        from dalembert._model.curves import plot_curves
        from dalembert._tools.sensor_facts import variable_of

        variable = variable_of(self._mbs, self._mbs.GetSensor(self._number()))
        return plot_curves(ax, self.time, self._stored()[:, 1:], self._name, variable, self.unit)


_BASES: dict[str, type[Handle]] = {
    base._kind: base for base in (NodeHandle, ObjectHandle, MarkerHandle, LoadHandle, SensorHandle)
}


def _handles(mbs: Any, indices: list[Any]) -> list[Any]:
    return [handle_of(mbs, index) for index in indices]


def _referring(handle: Any, kind: str, key: str) -> list[Any]:
    """Return the items of a kind whose parameter `key`, or its plural, contains the number of the handle."""
    from dalembert.create._created import _items, _numbers

    number, mbs = handle._number(), handle._mbs
    index = getattr(_core, f"{kind}Index")
    found = [i for i, item in _items(mbs, kind) if number in [int(each) for each in _numbers(item, key)]]
    return [handle_of(mbs, index(i)) for i in found]


@cache
def handle_class(item: str) -> type[Any]:
    """Return the class of handles of an item type, made from the tables of the core."""
    kind = next(each for each in KINDS if item.startswith(each))
    facts, base = facts_of(item), _BASES[kind]
    members: dict[str, Any] = {}
    for name, row in facts.parameters.items():
        if name not in facts.ambiguous:
            members[name] = members[row.spelled] = _parameter(row)
    for name, each in facts.outputs.items():
        if name not in facts.ambiguous:
            members[name] = _output(each)
        if kind == "Object" and is_body(item) and each.name not in OF_WHOLE_BODY:
            members[f"{name}_at"] = _output_at(each)
    if kind == "Object" and "marker_numbers" in facts.parameters:
        members |= {"force_on": _force_on, "torque_on": _torque_on}
    shown = [name for name in members if name == snake_case(name)]
    general = [name for cls in base.__mro__[:2] for name in vars(cls) if not name.startswith("_")]
    if clash := set(members) & set(general):
        raise AssertionError(f"{item}: {', '.join(sorted(clash))} are also members of all handles")
    members |= {
        "__slots__": (),
        "__doc__": item_class(item).__doc__,
        "__module__": "dalembert.handles",
        "_item": item,
        "_shown": tuple(sorted({*shown, *general})),
    }
    return type(item, (base,), members)


def _parameter(row: Row) -> property:
    def read(self: Handle) -> Any:
        return self._get(next(iter(self._constants(row.name)), row.name))

    def write(self: Handle, value: Any) -> None:
        for name in self._constants(row.name) or [row.name]:
            self._set(row._replace(name=name), value)

    return property(read, write, doc=f"{row.text} ({row.type}{row.facts})")


def _output(each: Output) -> property:
    def read(self: Handle) -> Any:
        return self.output(each.name)

    return property(read, doc=f"{each.text} ({each.unit})")


def _output_at(each: Output) -> Callable[..., Any]:
    def output_at(self: Handle, local_position: Any, configuration: Any = "current") -> Any:
        return self.output(each.name, local_position=local_position, configuration=configuration)

    output_at.__name__ = output_at.__qualname__ = f"{snake_case(each.name)}_at"
    output_at.__doc__ = (
        f"Return the {snake_case(each.name).replace('_', ' ')} of a point in the frame of the body ({each.unit})."
    )
    return output_at


def _force_on(self: Any, body: Any) -> FloatArray:
    """Return the force (N) that a connector or joint exerts on one of its two bodies, in global axes."""
    return _wrench_on(self, body)[:3]


def _torque_on(self: Any, body: Any) -> FloatArray:
    """Return the torque (Nm) that a connector or joint exerts on one of its two bodies, in global axes."""
    return _wrench_on(self, body)[3:]


def _wrench_on(handle: Any, body: Any) -> FloatArray:
    return np.asarray(handle.output(f"WrenchOnMarker{side_of(handle, body)}"), dtype=float)


def side_of(handle: Any, body: Any) -> int:
    """Return 0 or 1: whether a body, or a marker, is the first or the second one of a connector or joint."""
    mbs, where = handle._mbs, f"{handle!r}: body"
    if isinstance(body, str):
        found = [index for kind in ("Object", "Marker") if int(index := getattr(mbs, f"Get{kind}Number")(body)) >= 0]
        if not found:
            raise KeyError(f"{where}: there is no body or marker '{body}'")
        body = found[0]
    own_markers = [int(marker) for marker in handle.marker_numbers]
    if isinstance(body, _core.MarkerIndex):
        on_body = {int(own(mbs, body, where))}
    else:
        body = handle_of(mbs, own(mbs, body, where))
        on_body = {int(marker) for marker in CreatedObject.markers.fget(body)}  # type: ignore[attr-defined]
    sides = [i for i, marker in enumerate(own_markers[:2]) if marker in on_body]
    if len(sides) != 1:
        raise ValueError(f"{handle!r}: expected one of its two bodies or markers, received {body!r}")
    return sides[0]
