"""Models as JSON files: mbs.Save('model.json') and mbs.Load('model.json').

A file has the items, by kind and in their order, with the parameters that differ from the defaults, and optionally
settings. Its schema, model.schema.json in the folder of this package, is generated from the specs. Loading reads data;
code (user functions) is only loaded on request.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from enum import Enum
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from dalembert import _version
from dalembert._core import MainSystem, SimulationSettings, _parameters_of
from dalembert._io.encoded_values import Decoder, Encoder, Refused
from dalembert._io.files import file_to_read, file_to_write, naming, replacing
from dalembert._tools import item_packages
from dalembert._tools.item_packages import item_class, item_classes

FORMAT = "dalembert model"
FORMAT_VERSION = 1
KINDS = ("Node", "Object", "Marker", "Load", "Sensor")
SCHEMA = Path(__file__).parents[1] / "model.schema.json"
_KEYS = ("$schema", "format", "formatVersion", "package", "settings", "functions", "variables")
_KEYS_OF_ITEMS = tuple(f"{kind.lower()}s" for kind in KINDS)
_CONTACTS = "generalContacts"
_NUMBERS_OF_ITEMS = {"markerIndex": "Marker", "rigidBodyMarkerIndex": "Marker", "objectIndex": "Object"}


class _Place:
    """Location of an error: file and path inside."""

    def __init__(self, file: str) -> None:
        self.file = file

    @contextmanager
    def at(self, path: str) -> Iterator[None]:
        try:
            yield
        except ModelFileError:
            raise
        except Exception as error:  # errors of a constructor, of an import, of the code of a function
            raise ModelFileError(f"{self.file}: {path}: {error}") from error


class ModelFileError(ValueError):
    """An error in a model file, with its location."""

    __module__ = "dalembert"


def Schema() -> dict[str, Any]:
    """Return the JSON Schema of model files, with the items of all installed packages."""
    item_packages.load_installed()
    schema: dict[str, Any] = json.loads(SCHEMA.read_text("utf-8"))
    for table in item_packages.facts("schema"):
        for name, definition in table.items():
            schema["$defs"][name] = definition
            kind = next(kind for kind in KINDS if name.startswith(kind))
            items = schema["properties"][f"{kind.lower()}s"]["items"]
            items["properties"]["type"]["enum"].append(name)
            condition = {"properties": {"type": {"const": name}}}
            items["allOf"].append({"if": condition, "then": {"$ref": f"#/$defs/{name}"}})
    return schema


@cache
def _types(name: str) -> tuple[dict[str, str], dict[str, str]]:
    """Return parameters of an item type, and of its visualization, with their types in words."""
    item, view = item_class(name), item_class(f"V{name}")
    return (
        {row[0]: row[1].split(" of length")[0] for row in _parameters_of(item)},
        {row[0]: row[1].split(" of length")[0] for row in _parameters_of(view)},
    )


@cache
def _further_names(cls: type) -> dict[str, str]:
    """Return the further names of parameters of an item class or visualization class."""
    return {alias: row[0] for row in _parameters_of(cls) for alias in row[5]}


def _classes(kind: str) -> dict[str, Any]:
    """Return the item classes of a kind by their full names."""
    return {name: cls for name, cls in item_classes().items() if name == cls.__name__ and name.startswith(kind)}


# ---- writing ---------------------------------------------------------------------------------------------------------


def Save(
    mbs: MainSystem,
    fileName: str | os.PathLike[str],
    simulationSettings: SimulationSettings | None = None,
    sourceOfFunctions: bool = False,
) -> None:
    """Write the model, and settings if given, into a JSON file that Load and `dalembert run` read.

    All items are written exactly, with the values that differ from the defaults. Arrays with more than 1000 entries are
    stored in a separate file with the ending .npz. User functions are written by module and name; functions of the main
    program are rejected unless sourceOfFunctions is set, which writes their code. mbs.variables are written if they are
    numbers, texts, lists and arrays; the state of a solver, and mbs.sys, are not.
    """
    path = Path(file_to_write("mbs.Save(...): fileName", fileName))
    encoder = Encoder(sourceOfFunctions)
    place = _Place("mbs.Save(...)")
    system = mbs.GetDictionary()
    content: dict[str, Any] = {"format": FORMAT, "formatVersion": FORMAT_VERSION, "package": _version.__version__}
    for kind, key in zip(KINDS, _KEYS_OF_ITEMS, strict=True):
        items = enumerate(system[f"{kind.lower()}List"])
        content[key] = [_encoded_item(encoder, place, kind, item, f"{key}[{i}]") for i, item in items]
    if packages := system.get("itemPackages"):
        content["itemPackages"] = list(packages)
    if contacts := system.get("generalContactList"):
        content[_CONTACTS] = [_encoded_contact(encoder, entry, f"{_CONTACTS}[{i}]") for i, entry in enumerate(contacts)]
    functions = {name: function for name, function in system["userFunctions"].items() if callable(function)}
    for name, function in functions.items():
        with place.at(f"functions.{name}"):
            content.setdefault("functions", {})[name] = encoder.value(function, "function", name)
    if variables := dict(_encoded_variables(encoder, system["variables"])):
        content["variables"] = variables
    if simulationSettings is not None:
        content["settings"] = _differences(simulationSettings.GetDictionary(), SimulationSettings().GetDictionary())
    beside = path.with_suffix(".npz")
    with replacing(path) as written:
        Path(written).write_text(_json_text(content), "utf-8")
        if encoder.arrays:
            with replacing(beside) as written_beside:
                np.savez_compressed(written_beside, **encoder.arrays)
        elif beside.exists() and beside != path:
            beside.unlink()  # file of an earlier model of that name


def _encoded_item(encoder: Encoder, place: _Place, kind: str, item: Mapping[str, Any], path: str) -> dict[str, Any]:
    name = kind + str(item[f"{kind.lower()}Type"])
    cls = next(cls for full, cls in _classes(kind).items() if name in (full, kind + _type_name(cls)))
    defaults = dict(cls())
    parameters, visualization = _types(cls.__name__)
    result: dict[str, Any] = {"type": cls.__name__, "name": item["name"]}
    for prefix, types in (("", parameters), ("V", visualization)):
        rows: dict[str, Any] = {}
        for row, words in types.items():
            if row == "name":
                continue
            with place.at(f"{path}.{'visualization.' if prefix else ''}{row}"):
                encoded = encoder.value(item[prefix + row], words, f"{path}.{prefix}{row}")
                default = Encoder(True).value(defaults[prefix + row], words, "")
                if repr(encoded) != repr(default) or words.startswith("BeamSection"):  # -0.0 is another number
                    rows[row] = encoded
        if prefix and rows:
            result["visualization"] = rows
        elif not prefix:
            result |= rows
    return result


@cache
def _untouched_contact() -> dict[str, Any]:
    mbs = MainSystem()
    mbs.AddGeneralContact()
    return dict(mbs.GetDictionary()["generalContactList"][0])


def _encoded_contact(encoder: Encoder, contact: Mapping[str, Any], path: str) -> dict[str, Any]:
    """Return the differences from an empty contact: columns of numbers, and settings."""
    result: dict[str, Any] = {}
    for key, value in contact.items():
        if isinstance(value, Mapping):
            if len(next(iter(value.values()))):
                result[key] = {
                    name: encoder.value(column, "", f"{path}.{key}.{name}") for name, column in value.items()
                }
        elif key not in (default := _untouched_contact()) or not np.array_equal(value, default[key]):
            result[key] = value.tolist() if isinstance(value, np.ndarray) else value
    return result


@cache
def _type_name(cls: type) -> str:
    item = dict(cls())
    return str(next(iter(item.values())))


def _encoded_variables(encoder: Encoder, variables: Mapping[Any, Any]) -> Iterator[tuple[str, Any]]:
    for name, value in variables.items():
        try:
            if isinstance(name, str) and not callable(value):
                yield name, encoder.value(value, "object", f"variables.{name}")
        except Refused:
            continue


def _differences(values: Mapping[str, Any], defaults: Mapping[str, Any]) -> dict[str, Any]:
    result: dict[str, Any] = {}
    for key, value in values.items():
        if isinstance(value, Mapping):
            if inner := _differences(value, defaults[key]):
                result[key] = inner
        elif value != defaults[key]:
            result[key] = value.name if isinstance(value, Enum) else value
    return result


def _json_text(content: Mapping[str, Any]) -> str:
    """Return JSON with a line per parameter: lists of numbers are not broken."""
    return _lines(content, "") + "\n"


def _lines(value: Any, indent: str) -> str:
    inner = indent + "  "
    nested = isinstance(value, dict) and any(isinstance(entry, (dict, list)) for entry in value.values())
    if nested and len(indent) < 8:
        rows = (f"{inner}{json.dumps(key)}: {_lines(entry, inner)}" for key, entry in value.items())
        return "{\n" + ",\n".join(rows) + f"\n{indent}}}"
    if isinstance(value, list) and value and all(isinstance(entry, dict) for entry in value) and len(indent) < 4:
        return "[\n" + ",\n".join(inner + _lines(entry, inner) for entry in value) + f"\n{indent}]"
    return json.dumps(value, allow_nan=False)


# ---- reading ---------------------------------------------------------------------------------------------------------


def Load(mbs: MainSystem, fileName: str | os.PathLike[str], allowCode: bool = False) -> SimulationSettings | None:
    """Replace the model by that of a JSON file; return the settings in it, or None if it has none.

    Nothing in the file is executed: a user function, given by module and name or as code, is rejected unless allowCode
    is set. A wrong file is rejected with the location, e.g. objects[3].physicsMass, and the model does not change.
    """
    if isinstance(fileName, dict):
        raise TypeError(
            "mbs.Load(...): fileName: expected the name of a file, received a dictionary: mbs.SetDictionary(...)"
        )
    path = Path(file_to_read("mbs.Load(...): fileName", fileName))
    place = _Place(os.fspath(fileName))
    content = _content(path, place)
    decoder = Decoder(_arrays(path.with_suffix(".npz"), place), allowCode)
    names = _names(content, place)
    with place.at("itemPackages"):
        item_packages.load(content.get("itemPackages", ()), "the file")
        if not {item.get("type") for key in _KEYS_OF_ITEMS for item in content[key]} <= item_classes().keys():
            item_packages.load_installed()
    system: dict[str, Any] = {"__version__": _version.__version__}
    for kind, key in zip(KINDS, _KEYS_OF_ITEMS, strict=True):
        classes = _classes(kind)
        system[f"{kind.lower()}List"] = [
            _decoded_item(decoder, place, classes, names, item, f"{key}[{i}]") for i, item in enumerate(content[key])
        ]
    if contacts := content.get(_CONTACTS):
        system["generalContactList"] = [
            _decoded_contact(decoder, place, names, contact, f"{_CONTACTS}[{i}]") for i, contact in enumerate(contacts)
        ]
    for key, kind in (("functions", "function"), ("variables", "object")):
        found = {}
        for name, value in content.get(key, {}).items():
            with place.at(f"{key}.{name}"):
                found[name] = decoder.value(value, kind)
        system["userFunctions" if key == "functions" else key] = found
    settings = _decoded_settings(place, content["settings"]) if "settings" in content else None
    with place.at("items"):
        mbs.SetDictionary(system)
    return settings


def _content(path: Path, place: _Place) -> dict[str, Any]:
    with naming(path):
        text = path.read_text("utf-8", errors="replace")

    def unique(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
        found = dict(pairs)
        if len(found) < len(pairs):
            keys = [key for key, _ in pairs]
            twice = next(key for key in keys if keys.count(key) > 1)
            raise ModelFileError(f"{place.file}: key '{twice}' stands twice in one object")
        return found

    def refuse_constant(name: str) -> None:
        raise ModelFileError(f"{place.file}: {name} is not a number")

    try:
        content = json.loads(text, object_pairs_hook=unique, parse_constant=refuse_constant)
    except json.JSONDecodeError as error:
        where = f"{place.file}, line {error.lineno}, column {error.colno}"
        raise ModelFileError(f"{where}: not valid JSON: {error.msg}") from None
    except RecursionError:
        raise ModelFileError(f"{place.file}: too many brackets inside each other") from None
    if not isinstance(content, dict) or content.get("format") != FORMAT:
        raise ModelFileError(f"{place.file}: format: expected '{FORMAT}': not written by mbs.Save(...)")
    version = content.get("formatVersion")
    if not isinstance(version, int) or not 1 <= version <= FORMAT_VERSION:
        raise ModelFileError(
            f"{place.file}: formatVersion: received {version!r}, but this package reads 1 to {FORMAT_VERSION}; "
            f"the file was written by version {content.get('package', '?')} of the package"
        )
    lists = (*_KEYS_OF_ITEMS, _CONTACTS, "itemPackages")
    known = (*_KEYS, *lists)
    for key, value in content.items():
        if key not in known:
            raise ModelFileError(f"{place.file}: unknown key '{key}'; known are {', '.join(known)}")
        expected = list if key in lists else dict if key in ("settings", "functions", "variables") else None
        if expected is not None and not isinstance(value, expected):
            raise ModelFileError(f"{place.file}: {key}: expected a {'list' if expected is list else 'JSON object'}")
    return {key: [] for key in _KEYS_OF_ITEMS} | content


def _arrays(path: Path, place: _Place) -> dict[str, Any]:
    if not path.exists():
        return {}
    with place.at(path.name), np.load(path, allow_pickle=False) as file:
        return dict(file)


def _names(content: Mapping[str, Any], place: _Place) -> dict[str, dict[str, int]]:
    """Return the numbers of named items by kind; a name that stands twice is refused."""
    names: dict[str, dict[str, int]] = {}
    for kind, key in zip(KINDS, _KEYS_OF_ITEMS, strict=True):
        known = names.setdefault(kind, {})
        for i, item in enumerate(content[key]):
            if not isinstance(item, dict):
                raise ModelFileError(f"{place.file}: {key}[{i}]: expected a JSON object with 'type' and parameters")
            name = item.get("name", "")
            if not isinstance(name, str):
                raise ModelFileError(f"{place.file}: {key}[{i}].name: received {name!r}, but expected a text")
            if name in known:
                other = f"{key}[{known[name]}]"
                raise ModelFileError(f"{place.file}: {key}[{i}].name: '{name}' is already the name of {other}")
            if name:
                known[name] = i
    for kind, key in zip(KINDS, _KEYS_OF_ITEMS, strict=True):
        for i in range(len(content[key])):
            names[kind].setdefault(f"{kind.lower()}{i}", i)
    return names


def _decoded_item(
    decoder: Decoder, place: _Place, classes: Mapping[str, Any], names: Any, item: Mapping[str, Any], path: str
) -> dict[str, Any]:
    name = item.get("type")
    with place.at(f"{path}.type"):
        if name not in classes:
            import difflib

            near = difflib.get_close_matches(str(name), classes, 1)
            hint = f"did you mean '{near[0]}'?" if near else "there is no such item"
            raise ValueError(f"received {name!r}; {hint}")
    types, view_types = _types(str(name))
    view = item.get("visualization", {})
    with place.at(f"{path}.visualization"):
        if not isinstance(view, dict):
            raise ValueError(f"received {view!r}, but expected a JSON object")
    cls, view_cls = classes[str(name)], item_class(f"V{name}")
    rows = {key: value for key, value in item.items() if key not in ("type", "visualization")}
    made = _made(decoder, place, cls, types, names, rows, path)
    made_view = _made(decoder, place, view_cls, view_types, names, view, f"{path}.visualization")
    with place.at(path):
        return dict(cls(**made, visualization=made_view))


def _made(
    decoder: Decoder, place: _Place, cls: Any, types: Mapping[str, str], names: Any, rows: Mapping[str, Any], path: str
) -> dict[str, Any]:
    """Return values of parameters, each of which the class accepts."""
    made: dict[str, Any] = {}
    for name, value in rows.items():
        with place.at(f"{path}.{name}"):
            row = _further_names(cls).get(name, name)
            if row in made:
                raise ValueError(f"the parameter {row} is given twice, by two of its names")
            words = types.get(row, "object")
            value = _with_numbers(names, words, value) if words.endswith("Index") else decoder.value(value, words)
            cls(**{row: value})
            made[row] = value
    return made


def _with_numbers(names: Any, words: str, value: Any) -> Any:
    """Return numbers in place of names; numbers of items that the file does not have are refused."""
    if isinstance(value, list):
        return [_with_numbers(names, words, entry) for entry in value]
    kind = words.removeprefix("list of ").removesuffix("Index")
    if isinstance(value, str):
        if value not in names[kind]:
            raise Refused(f"there is no {kind.lower()} named '{value}' in the file")
        return names[kind][value]
    count = len(set(names[kind].values()))
    if isinstance(value, int) and not isinstance(value, bool) and not -1 <= value < count:
        raise Refused(f"received {value}, but the file has {count} {kind.lower()}s")
    return value


def _decoded_contact(decoder: Decoder, place: _Place, names: Any, contact: Any, path: str) -> dict[str, Any]:
    if not isinstance(contact, dict):
        raise ModelFileError(f"{place.file}: {path}: expected a JSON object")
    result: dict[str, Any] = {}
    for key, value in contact.items():
        if not isinstance(value, dict):
            result[key] = value
            continue
        columns = result[key] = {}
        for name, column in value.items():
            with place.at(f"{path}.{key}.{name}"):
                numbers = decoder.value(column, "")
                if kind := _NUMBERS_OF_ITEMS.get(name):
                    numbers = _with_numbers(names, f"{kind}Index", np.asarray(numbers).tolist())
                columns[name] = numbers
    with place.at(path):
        MainSystem().SetDictionary({"__version__": _version.__version__, "generalContactList": [result]})
    return result


def _decoded_settings(place: _Place, values: Mapping[str, Any]) -> SimulationSettings:
    settings = SimulationSettings()

    def members(known: Mapping[str, Any], given: Any, path: str) -> Any:
        if not isinstance(given, dict):
            raise ModelFileError(f"{place.file}: {path}: expected a JSON object")
        result = {}
        for key, value in given.items():
            default = known.get(key)
            if isinstance(default, Mapping):
                result[key] = members(default, value, f"{path}.{key}")
            elif isinstance(default, Enum):
                with place.at(f"{path}.{key}"):
                    if value not in type(default).__members__:
                        raise ValueError(f"received {value!r}; known are {', '.join(type(default).__members__)}")
                    result[key] = type(default)[value]
            else:
                result[key] = value
        return result

    decoded = members(settings.GetDictionary(), values, "settings")
    with place.at("settings"):
        settings.SetDictionary(decoded)
    return settings
