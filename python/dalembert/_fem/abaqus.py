"""Readers for input files and matrices of ABAQUS; other programs write the same format, such as CalculiX and gmsh."""

from __future__ import annotations

import os
import warnings
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from dalembert._checks import FloatArray, IntArray
from dalembert._fem.elements import KINDS
from dalembert._io.files import file_to_read

# Types of ABAQUS by their prefix; the suffix defines the integration, which does not matter for a mesh.
_TYPES = {"C3D4": "Tet4", "C3D10": "Tet10", "C3D8": "Hex8", "C3D20": "Hex20", "C3D6": "Wedge6", "C3D15": "Wedge15"}
_SUFFIXES = ("", "R", "H", "RH", "I", "IH", "M", "MH", "HS", "MHS", "S", "T", "RT", "E", "P")


@dataclass
class _Block:
    """A keyword with its options, and its lines of data with their numbers."""

    keyword: str
    options: dict[str, str]
    line: int
    rows: list[tuple[int, str]] = field(default_factory=list)


@dataclass
class AbaqusMesh:
    """Nodes and elements of a part, numbered from 0, with the numbers of the file as labels."""

    positions: FloatArray
    node_labels: IntArray
    elements: dict[str, IntArray]
    element_labels: IntArray
    node_sets: dict[str, IntArray]
    element_sets: dict[str, IntArray]
    sections: dict[str, str]  # element set: material
    materials: dict[str, dict[str, float]]

    def material_of(self, elementSet: str) -> dict[str, float]:
        """Return the material of the section of a set, as far as the file has it; names may differ in case."""
        sections = {name.lower(): material for name, material in self.sections.items()}
        materials = {name.lower(): values for name, values in self.materials.items()}
        return materials.get(sections.get(elementSet.lower(), "").lower(), {})


def _blocks(fileName: str, within: tuple[str, ...] = ()) -> list[_Block]:
    blocks: list[_Block] = []
    with open(fileName, encoding="utf-8", errors="replace") as file:
        for number, line in enumerate(file, 1):
            text = line.strip()
            if not text or text.startswith("**"):
                continue
            if text.startswith("*"):
                keyword, *options = (word.strip() for word in text[1:].split(","))
                pairs = (option.partition("=") for option in options if option)
                values = {key.strip().lower(): value.strip() for key, _, value in pairs}
                if keyword.lower() == "include":
                    blocks += _included(fileName, number, values.get("input", "").strip("\"'"), within)
                else:
                    blocks.append(_Block(" ".join(keyword.lower().split()), values, number))
            elif blocks:
                blocks[-1].rows.append((number, text))
    return blocks


def _included(fileName: str, line: int, name: str, within: tuple[str, ...]) -> list[_Block]:
    """Return the blocks of a file that another one includes, whose folder its name counts from."""
    path = os.path.join(os.path.dirname(fileName), name)
    if not os.path.isfile(path) or path in within:
        raise ValueError(f"{fileName}, line {line}: *Include: there is no file '{name}', or it includes itself")
    return _blocks(path, (*within, fileName))


def _within(blocks: Sequence[_Block], fileName: str, typeName: str, name: str) -> list[_Block]:
    """Blocks of a part or an instance; all of them if the file has none."""
    kind = typeName.lower()
    starts = [i for i, block in enumerate(blocks) if block.keyword == kind]
    if not starts:
        others = [word for word in ("part", "instance") if any(block.keyword == word for block in blocks)]
        if others:
            raise ValueError(
                f"{fileName}: there is no keyword *{typeName}; there is *{others[0].title()}, see typeName"
            )
        return list(blocks)
    chosen = [i for i in starts if blocks[i].options.get("name", "").lower() == name.lower()]
    if not chosen and len(starts) > 1:
        names = ", ".join(repr(blocks[i].options.get("name", "")) for i in starts)
        raise ValueError(f"{fileName}: there is no *{typeName} with name={name!r}; there are {names}")
    first = (chosen or starts)[0]
    ends = [i for i in range(first, len(blocks)) if blocks[i].keyword == f"end {kind}"]
    inside = list(blocks[first + 1 : ends[0] if ends else None])
    if not any(block.keyword == "node" for block in inside):
        line = f"*{typeName} in line {blocks[first].line}"
        raise ValueError(f"{fileName}: {line} has no *Node; nodes may be in parts or instances, see typeName and name")
    return inside


def _numbers(fileName: str, line: int, text: str, kind: Any, expected: str) -> list[Any]:
    try:
        return [kind(word) for word in text.rstrip(", ").split(",")]
    except ValueError:
        raise ValueError(f"{fileName}, line {line}: expected {expected}, found '{text}'") from None


def _read_nodes(fileName: str, blocks: Iterable[_Block]) -> tuple[IntArray, FloatArray]:
    rows, expected = [], "a node number and up to three coordinates"
    for block in blocks:
        for line, text in block.rows:
            row = _numbers(fileName, line, text, float, expected)
            if not 2 <= len(row) <= 4:
                raise ValueError(f"{fileName}, line {line}: expected {expected}, found '{text}'")
            rows.append(row + [0.0] * (4 - len(row)))
    table = np.array(rows, dtype=float).reshape(-1, 4)
    labels = table[:, 0].astype(np.int64)
    unique, counts = np.unique(labels, return_counts=True)
    if (counts > 1).any():
        raise ValueError(f"{fileName}: node {unique[counts > 1][0]} is given more than once")
    return labels, table[:, 1:]


def _kind_of(block: _Block) -> str | None:
    """Return our name of a type of solid elements; None for others."""
    given = block.options.get("type", "").upper()
    for name, kind in sorted(_TYPES.items(), reverse=True):  # C3D10 before C3D
        if given.startswith(name) and given[len(name) :] in _SUFFIXES:
            return kind
    return None


def _read_elements(fileName: str, block: _Block, kind: str, nodes: dict[int, int]) -> tuple[list[int], list[list[int]]]:
    count = KINDS[kind].count + 1
    labels, connectivity = [], []
    text, first = "", 0
    for line, part in block.rows:
        first = first if text else line
        text += part
        if part.endswith(",") and text.rstrip(",").count(",") + 1 < count:
            continue  # an element goes on in the next line
        row = _numbers(fileName, first, text, int, "integers")
        if len(row) != count:
            expected = f"an element number and {count - 1} nodes of {block.options.get('type')}"
            raise ValueError(f"{fileName}, line {first}: expected {expected}, found {len(row)} numbers")
        missing = [node for node in row[1:] if node not in nodes]
        if missing:
            raise ValueError(f"{fileName}, line {first}: element {row[0]} has node {missing[0]}, which does not exist")
        labels.append(row[0])
        connectivity.append([nodes[node] for node in row[1:]])
        text = ""
    if text:
        raise ValueError(f"{fileName}, line {first}: the element is not complete: '{text}'")
    return labels, connectivity


def _read_sets(fileName: str, blocks: Iterable[_Block], option: str, numbers: dict[int, int]) -> dict[str, IntArray]:
    """Sets of nodes or elements; a set may name others, in any case of letters. Members of other parts are left out."""
    sets: dict[str, list[int]] = {}
    names: dict[str, str] = {}  # original spelling
    for block in blocks:
        name = block.options.get(option, "")
        members = sets.setdefault(names.setdefault(name.lower(), name), [])
        if block.keyword == "node":
            members += [int(word) for word in _labels(block)]
            continue
        for line, text in block.rows:
            words = [word.strip() for word in text.split(",") if word.strip()]
            if "generate" in block.options:
                first, last, *step = _numbers(fileName, line, text, int, "first, last and step")
                words = [str(i) for i in range(first, last + 1, *step)]
            for word in words:
                if word.lstrip("-").isdigit():
                    members.append(int(word))
                elif word.lower() in names:
                    members += sets[names[word.lower()]]
                else:
                    warnings.warn(
                        f"{fileName}, line {line}: set '{word}' is not known, and left out of '{name}'", stacklevel=5
                    )
    kept = {name: [numbers[i] for i in dict.fromkeys(members) if i in numbers] for name, members in sets.items()}
    return {name: np.array(members, dtype=np.int64) for name, members in kept.items() if members}


def _labels(block: _Block) -> list[str]:
    """Return the numbers of the nodes that a block defines."""
    return [text.split(",")[0] for _, text in block.rows]


def _read_materials(fileName: str, blocks: Sequence[_Block]) -> dict[str, dict[str, float]]:
    materials: dict[str, dict[str, float]] = {}
    current: dict[str, float] = {}
    for block in blocks:
        if block.keyword == "material":
            current = materials.setdefault(block.options.get("name", ""), {})
        elif block.keyword in ("elastic", "density") and block.rows:
            line, text = block.rows[0]
            row = _numbers(fileName, line, text, float, "numbers")
            names = ("youngsModulus", "poissonsRatio") if block.keyword == "elastic" else ("density",)
            if block.keyword == "elastic" and block.options.get("type", "isotropic").lower() not in (
                "isotropic",
                "iso",
            ):
                kind = block.options["type"]
                warnings.warn(
                    f"{fileName}, line {block.line}: *Elastic, type={kind} is not read; give this material to "
                    "AssembleMatrices",
                    stacklevel=4,
                )
                continue
            current |= dict(zip(names, row, strict=False))
    return materials


def _report_others(fileName: str, others: Sequence[_Block], has_solids: bool) -> None:
    """Warn of elements that are no solids; refuse a file that has no others."""
    types = ", ".join(dict.fromkeys(f"'{block.options.get('type', '').upper()}'" for block in others))
    if has_solids:
        if others:
            line = others[0].line
            warnings.warn(
                f"{fileName}, line {line}: elements of types {types} are left out; solids are read", stacklevel=4
            )
        return
    if not others:
        raise ValueError(f"{fileName}: there is no keyword *Element with solid elements")
    known = ", ".join(_TYPES)
    text = f"elements of type {types} are not known; known are solid elements {known}, also with R, H, I, M, S"
    raise ValueError(f"{fileName}, line {others[0].line}: {text}")


def read_abaqus(fileName: str, typeName: str, name: str) -> AbaqusMesh:
    """Nodes, solid elements, sets, sections and materials of an input file."""
    every = _blocks(fileName)
    inside = _within(every, fileName, typeName, name)
    labels, positions = _read_nodes(fileName, (block for block in inside if block.keyword == "node"))
    if len(labels) == 0:
        raise ValueError(f"{fileName}: there are no nodes")
    nodes = {int(label): i for i, label in enumerate(labels)}
    by_kind: dict[str, tuple[list[int], list[list[int]]]] = {}
    own_sets: dict[str, list[int]] = {}
    others: list[_Block] = []
    for block in inside:
        if block.keyword == "element":
            kind = _kind_of(block)
            if kind is None:
                others.append(block)
                continue
            found = _read_elements(fileName, block, kind, nodes)
            into = by_kind.setdefault(kind, ([], []))
            into[0].extend(found[0])
            into[1].extend(found[1])
            if "elset" in block.options:
                own_name = next((n for n in own_sets if n.lower() == block.options["elset"].lower()), None)
                own_sets.setdefault(own_name or block.options["elset"], []).extend(found[0])
    _report_others(fileName, others, bool(by_kind))
    ordered = {kind: by_kind[kind] for kind in KINDS if kind in by_kind}
    element_labels = np.array([label for part in ordered.values() for label in part[0]], dtype=np.int64)
    elements = {int(label): i for i, label in enumerate(element_labels)}
    assembly = [block for block in every if block not in inside and "instance" in block.options]
    sets = [
        _read_sets(
            fileName,
            (b for b in [*inside, *assembly] if b.keyword in keywords and option in b.options),
            option,
            numbers,
        )
        for option, keywords, numbers in (("nset", ("nset", "node"), nodes), ("elset", ("elset",), elements))
    ]
    sets[1] |= {key: np.array([elements[i] for i in value], dtype=np.int64) for key, value in own_sets.items()}
    sections = {
        b.options.get("elset", ""): b.options.get("material", "") for b in inside if b.keyword == "solid section"
    }
    connectivity = {kind: np.array(part[1], dtype=np.int64) for kind, part in ordered.items()}
    materials = _read_materials(fileName, every)
    return AbaqusMesh(positions, labels, connectivity, element_labels, sets[0], sets[1], sections, materials)


def read_abaqus_matrix(fileName: str) -> FloatArray:
    """Array of [row, column, value], counted from 0, of a matrix in one of the formats COORDINATE or MATRIX INPUT.

    The latter has lines of node, coordinate, node, coordinate, value, of one half of the matrix.
    """
    with open(fileName, encoding="utf-8") as file:
        first = next((line for line in file if line.strip() and not line.startswith("*")), "")
    delimiter = "," if "," in first else None
    try:
        table = np.loadtxt(fileName, delimiter=delimiter, comments="*", ndmin=2)
    except ValueError as error:
        raise ValueError(f"{fileName}: expected lines with row, column and value: {error}") from None
    if table.shape[1] == 5:
        table = np.column_stack([3 * (table[:, 0] - 1) + table[:, 1], 3 * (table[:, 2] - 1) + table[:, 3], table[:, 4]])
    if table.shape[1] != 3:
        raise ValueError(f"{fileName}: expected lines with row, column and value, found {table.shape[1]} columns")
    table[:, :2] -= 1
    if len(table) and (table[:, :2].min() < 0 or (table[:, :2] % 1).any()):
        raise ValueError(f"{fileName}: rows and columns must be integers from 1 on")
    if len(table) and np.abs(table[:, 2]).max() >= 1e30:
        where = int(table[np.abs(table[:, 2]).argmax(), 0])
        text = f"coordinate {where % 3} of node {where // 3} is fixed; export matrices without boundary conditions"
        raise ValueError(f"{fileName}: {text}")
    above, below = table[:, 0] < table[:, 1], table[:, 0] > table[:, 1]
    if above.any() != below.any():  # only one half was written
        half = table[above | below]
        table = np.vstack([table, half[:, [1, 0, 2]]])
    return np.asarray(table, dtype=float)


def ReadNodesFromAbaqusInp(
    fileName: str, typeName: str = "Part", name: str = "Part-1", exportElements: bool = False
) -> Any:
    """Positions of nodes of an input file; with exportElements [positions, elements, surface elements].

    Elements are a dictionary with their nodes, in the numbering of the file, and their types; FEMinterface reads more.
    """
    mesh = read_abaqus(file_to_read("ReadNodesFromAbaqusInp: fileName", fileName), typeName, name)
    if not exportElements:
        return mesh.positions
    rows = [row for nodes in mesh.elements.values() for row in mesh.node_labels[nodes].astype(float).tolist()]
    types = [kind for kind, nodes in mesh.elements.items() for _ in nodes]
    same = len({len(row) for row in rows}) == 1
    elements = {"elements": np.array(rows, dtype=float if same else object), "elementTypes": types}
    return [mesh.positions, elements, {"elements": np.zeros((0, 3)), "elementTypes": []}]
