"""Read spec files into the model. A message always names file, table and row."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any, TypeVar

from codegen.load_create import load_create_functions
from codegen.load_left_out import load_left_out
from codegen.load_planned import load_planned
from codegen.load_scene import read_scene
from codegen.load_settings import load_enum, load_settings
from codegen.model import (
    STANDARD_ARGUMENTS,
    Argument,
    Example,
    Item,
    Output,
    Quantity,
    SpecError,
    Transformation,
    UserFunction,
)
from codegen.model_settings import Enum, Specs, value_type
from codegen.names import FOLDERS, nearest, snake_case
from codegen.rows import at, check_keys, known_key, parameter, parse, text
from codegen.scene import SceneTable
from codegen.views.python import create_functions

TABLES = ("parameters", "visualization", "outputs")
GROUP_TABLES = (*TABLES, "quantities", "texts")
TOP_LEVEL = (
    "name", "type_name", "object_type", "short_names", "create_functions", "summary", "provides", "requested_nodes",
    "requested_markers", "physics",
    "nodes", "sized", "irregular", "beyond_reference", *TABLES, "transformations", "user_functions", "scene", "docs",
    "example",
)  # fmt: skip
WORD_LISTS = ("short_names", "create_functions", "provides", "requested_nodes", "requested_markers", "nodes")
OUTPUT_KEYS = ("size", "unit", "from", "symbol", "doc", "beyond_reference")
ARGUMENT_KEYS = ("name", "type", "unit", "size", "doc")

T = TypeVar("T")
# group -> table -> row -> keys, or a text
Groups = Mapping[str, Mapping[str, Mapping[str, Any]]]
USE_TEXT = re.compile(r"^\.\. use:: (\w+)\.(\w+)$", re.MULTILINE)  # a line that the text of a group takes the place of


def load(root: Path) -> Specs:
    """All specs below `root`/specs, in the order of folders and files."""
    specs = root / "specs"
    _check_folders(specs)
    items, groups, enums = known_specs(root)
    items = with_examples(items, {path.stem: path.read_text("utf-8") for path in sorted(root.glob("examples/*.py"))})
    settings = _each(root, ["settings"], lambda path, content: load_settings(path, content, enums))
    planned = [one for file in _each(root, ["interface"], load_planned) for one in file]
    left_out = [one for file in _each(root, ["left_out"], load_left_out) for one in file]
    check_references(items, (), enums, root, {})
    create = load_create_functions(root / "python/dalembert/create")
    return Specs(tuple(items), tuple(enums.values()), tuple(settings), tuple(planned), tuple(left_out), create)


def known_specs(root: Path) -> tuple[list[Item], Groups, dict[str, Enum]]:
    """Items, groups and enumerations below `root`/specs; references between items are not checked."""
    enums = {enum.name: enum for enum in _each(root, ["enums"], load_enum)}
    groups = _groups(root)
    return load_items(root, enums, groups), groups, enums


def load_items(root: Path, enums: Mapping[str, Enum], groups: Groups) -> list[Item]:
    """Items below `root`/specs, with rows of these groups or of its own."""
    known = {**groups, **_groups(root)}
    return _each(root, FOLDERS, lambda path, content: load_item(path, content, known, enums))


def _groups(root: Path) -> dict[str, Mapping[str, Mapping[str, Any]]]:
    return dict(_each(root, ["groups"], lambda path, content: (Path(path).stem, load_group(path, content))))


def _each(root: Path, folders: Iterable[str], make: Callable[[str, str], T]) -> list[T]:
    """Make one thing of every file in the folders; errors of all files are reported together."""
    made, errors = [], []
    for file in (file for folder in folders for file in sorted((root / "specs" / folder).glob("*.toml"))):
        try:
            made.append(make(file.relative_to(root).as_posix(), file.read_text("utf-8")))
        except SpecError as error:
            errors.append(str(error))
    if errors:
        raise SpecError("\n".join(errors))
    return made


def load_item(path: str, content: str, groups: Groups, enums: Mapping[str, Enum]) -> Item:
    """Return an item from the text of its spec; `path` is relative to the repository."""
    with at(path):
        raw = parse(content)
        check_keys(raw, TOP_LEVEL)
        docs = raw.get("docs", {})
        check_keys(docs, ("equations", "quantities", "examples"), "docs")
        tables = {table: _splice(table, raw, groups) for table in TABLES}
        texts: dict[str, Any] = {key: text(raw, key) for key in ("name", "type_name", "summary", "physics")}
        words = {key: _words(raw, key) for key in WORD_LISTS}
        return Item(
            path=path,
            **texts,
            **words,
            object_type=raw.get("object_type", ""),
            sized=raw.get("sized", ""),
            irregular=raw.get("irregular", ""),
            beyond_reference=raw.get("beyond_reference"),
            parameters=_rows("parameters", tables, lambda n, r: parameter(n, r, enums)),
            visualization=_rows("visualization", tables, lambda n, r: parameter(n, r, enums)),
            outputs=_rows("outputs", tables, lambda n, r: _output(n, r, enums)),
            transformations=_rows("transformations", raw, _transformation),
            user_functions=_rows("user_functions", raw, _user_function),
            equations=_equations(docs.get("equations", ""), groups),
            quantities=tuple(_quantity(i, row, groups) for i, row in enumerate(docs.get("quantities", ()))),
            examples=tuple(docs.get("examples", ())),
            example=_example(raw["example"]) if "example" in raw else None,
            scene=_scene(path, raw, tables),
        )


def _scene(path: str, raw: Mapping[str, Any], tables: Mapping[str, Any]) -> SceneTable:
    with at("scene"):
        table = raw.get("scene", {})
        if not isinstance(table, Mapping):
            raise SpecError(f"a table belongs here, not {table!r}")
        kind = FOLDERS[path.split("/")[1]][0]
        return read_scene(table, kind, tables["parameters"], tables["outputs"])


def _words(raw: Mapping[str, Any], key: str) -> Any:
    value = raw.get(key, [])
    if not isinstance(value, list) or not all(isinstance(word, str) for word in value):
        raise SpecError(f"{key}: {value!r} is not a list of names")
    return tuple(value)


def _check_folders(specs: Path) -> None:
    known = (*FOLDERS, "groups", "enums", "settings", "interface", "left_out")
    for entry in sorted(specs.iterdir()):
        if entry.name not in known and not entry.name.startswith("."):
            raise SpecError(f"specs/{entry.name}: not a folder of specs; {nearest(entry.name, known)}")


def load_group(path: str, content: str) -> dict[str, Any]:
    with at(path):
        raw = parse(content)
        check_keys(raw, GROUP_TABLES)
        for table, rows in raw.items():
            for name, row in rows.items():
                if table == "texts" and not isinstance(row, str):
                    raise SpecError(f"{table}.{name}: a text belongs here, not {row!r}")
                if table != "texts" and (not isinstance(row, dict) or "use" in row):
                    raise SpecError(f"{table}.{name}: a group holds rows, and never uses a group")
        return raw


def first_of_kind(item: Item, others: Iterable[Item]) -> bool:
    return item is next(other for other in others if other.kind == item.kind)


def with_examples(items: list[Item], examples: Mapping[str, str]) -> list[Item]:
    """Items with the names of those examples that make them, besides those that their specs name."""
    mirrored = create_functions(items)
    completed = []
    for item in items:
        own = [name for name in item.create_functions if first_of_kind(item, mirrored[name])]
        calls = [f".{each}(" for name in own for each in (name, snake_case(name))]
        found = {stem for stem, code in examples.items() if item.used_in(code) or any(call in code for call in calls)}
        completed.append(replace(item, examples=tuple(sorted(found.union(item.examples)))))
    return completed


def check_references(
    items: Iterable[Item], others: Iterable[Item], enums: Mapping[str, Enum], root: Path, names: dict[str, str]
) -> None:
    """Check the names in items; they may refer to the others. `names` are taken, by the specs that have them."""
    known = {other.name: other for other in (*others, *items)}
    nodes = [item.name for item in known.values() if item.kind == "node"]
    for item in items:
        for name in {item.name, *item.short_names}:
            if name in names:
                raise SpecError(f"{item.path}: short_names: {name!r} already belongs to {names[name]}")
            names[name] = item.path
        for name in item.nodes:
            if name not in nodes:
                raise SpecError(f"{item.path}: nodes: no node item is named {name!r}; {nearest(name, nodes)}")
        _check_scene(item, known)
        for row in item.rows:
            if row.type.storage == "output_variable" and row.default not in {
                v.name for v in enums[row.type.name].values
            }:
                raise SpecError(f"{item.path}: {row.name}: default: {row.default!r} is not in {row.type.name}")
        for example in item.examples:
            if not (root / "examples" / f"{example}.py").exists():
                raise SpecError(f"{item.path}: docs.examples: there is no examples/{example}.py")


def _check_scene(item: Item, items: Mapping[str, Item]) -> None:
    """Whom the scene names: they exist, and each body stands on a node that it is made for."""
    for key, end in item.scene.ends:
        with at(f"{item.path}: scene: {key}"):
            for name in end.names:
                known_key(name, items)
            fitting = items[end.body].nodes if end.body else ()
            if end.body and end.node and end.node not in fitting:
                raise SpecError(f"{end.body} is not made for {end.node}; {nearest(end.node, fitting)}")
            if not end.node and len(fitting) > 1:
                raise SpecError(f"{end.body} needs 'on' and one of its nodes; known are {', '.join(fitting)}")
    for node in item.scene.nodes:
        with at(f"{item.path}: scene: nodes"):
            if node.type:
                known_key(node.type, [name for name, other in items.items() if other.kind == "node"])
            for name in node.values:
                known_key(name, [row.name for row in items[node.type].parameters] if node.type else [])


def _splice(table: str, raw: Mapping[str, Any], groups: Groups) -> dict[str, Any]:
    """The rows of a table with those of groups put where `use` asks for them; 'name' comes first."""
    rows: dict[str, Any] = dict(_group_rows("item", table, groups)) if table == "parameters" else {}
    for name, row in raw.get(table, {}).items():
        with at(f"{table}.{name}"):
            if name == "use":
                rows |= _group_rows(row, table, groups)
            elif not isinstance(row, dict):
                raise SpecError(f"a row is a table {{ ... }}, not {row!r}")
            elif name in rows:
                raise SpecError("declared twice; a group brings this row already")
            else:
                rows[name] = _merge(name, table, row, groups)
    return rows


def _merge(name: str, table: str, row: Mapping[str, Any], groups: Groups) -> dict[str, Any]:
    if "use" not in row:
        return dict(row)
    shared = _group_rows(row["use"], table, groups)
    if name not in shared:
        raise SpecError(f"use: group {row['use']!r} has no such row; {nearest(name, shared)}")
    return dict(shared[name]) | {key: value for key, value in row.items() if key != "use"}


def _group_rows(group: str, table: str, groups: Groups) -> Mapping[str, Any]:
    if group not in groups:
        raise SpecError(f"use: unknown group {group!r}; {nearest(str(group), groups)}")
    return groups[group].get(table, {})


def _rows(table: str, tables: Mapping[str, Any], make: Callable[[str, dict[str, Any]], T]) -> tuple[T, ...]:
    rows = []
    for name, row in tables.get(table, {}).items():
        with at(f"{table}.{name}"):
            rows.append(make(name, row))
    return tuple(rows)


def _output(name: str, row: Mapping[str, Any], enums: Mapping[str, Enum]) -> Output:
    known_key(name, [value.name for value in enums["OutputVariableType"].values])
    check_keys(row, OUTPUT_KEYS)
    return Output(
        name=name,
        size=row.get("size", 0),
        unit=row.get("unit", ""),
        source=text(row, "from"),
        doc=row.get("doc", ""),
        symbol=row.get("symbol", ""),
        beyond_reference=row.get("beyond_reference", ""),
    )


def _transformation(name: str, row: Mapping[str, Any]) -> Transformation:
    check_keys(row, ("position", "rotation"))
    return Transformation(name, row.get("position", ""), text(row, "rotation"))


def _user_function(name: str, table: Mapping[str, Any]) -> UserFunction:
    check_keys(table, ("doc", "arguments", "returns", "example"))
    arguments = table.get("arguments", [])
    standard = tuple(a for a in arguments if isinstance(a, str))
    for argument in standard:
        known_key(argument, STANDARD_ARGUMENTS)
    own = [a for a in arguments if not isinstance(a, str)]
    if arguments[: len(standard)] != list(standard):
        raise SpecError(f"arguments: {', '.join(STANDARD_ARGUMENTS)} come first")
    if "returns" not in table:
        raise SpecError("missing key 'returns'")
    return UserFunction(
        name=name,
        standard=standard,
        arguments=tuple(_argument(text(a, "name"), a) for a in own),
        returns=_argument("returns", table["returns"]),
        doc=table.get("doc", ""),
        example=table.get("example", "").strip("\n"),
    )


def _argument(name: str, row: Mapping[str, Any]) -> Argument:
    with at(f"arguments.{name}" if name != "returns" else name):
        check_keys(row, ARGUMENT_KEYS)
        type_ = value_type(text(row, "type"))
        return Argument(name, type_, row.get("doc", ""), row.get("unit", ""), row.get("size", 0))


def _equations(content: str, groups: Groups) -> str:
    def shared(use: re.Match[str]) -> str:
        texts = _group_rows(use[1], "texts", groups)
        if use[2] not in texts:
            raise SpecError(f"use: group {use[1]!r} has no such text; {nearest(use[2], texts)}")
        return str(texts[use[2]]).strip()

    with at("docs.equations"):
        return USE_TEXT.sub(shared, content).strip()


def _quantity(number: int, row: Mapping[str, Any], groups: Groups) -> Quantity:
    with at(f"docs.quantities[{number}]"):
        row = {"name": text(row, "name")} | _merge(text(row, "name"), "quantities", row, groups)
        check_keys(row, ("name", "symbol", "doc"))
        return Quantity(text(row, "name"), row.get("symbol", ""), text(row, "doc"))


def _example(table: Mapping[str, Any]) -> Example:
    with at("example"):
        check_keys(table, ("code", "expect"))
        expect = table.get("expect", {})
        check_keys(expect, ("value", "tolerance"), "expect")
        for key in ("value", "tolerance"):
            if key not in expect:
                raise SpecError(f"missing key 'expect.{key}'")
        return Example(text(table, "code").strip("\n"), expect["value"], float(expect["tolerance"]))
