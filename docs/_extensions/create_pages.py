"""A page per Create function: the added items, its arguments, an example, and further reading."""

from __future__ import annotations

import inspect
from importlib.util import find_spec
from pathlib import Path
from textwrap import indent
from types import ModuleType
from typing import Any

from item_pictures import draw, figure
from plain_docstrings import as_rst, escaped

from codegen.names import snake_case

EXAMPLES = Path(__file__).parents[2] / "examples"
PICTURES = "create/pictures"

INTRO = """\
A Create function is a method of ``MainSystem`` that adds a body, a connector, a joint, a load, a sensor or a robot with
what belongs to it: nodes, markers, weight. It returns the number of the item, by which its parameters can be read and
set, or a dictionary with several.

``dalembert.Model`` has the same functions with names in snake_case: ``model.create_motor`` is ``CreateMotor``, with
``body_numbers`` for ``bodyNumbers``. It returns handles, see :doc:`/tutorial/first_steps`.
"""


def heading(title: str, mark: str = "=") -> str:
    return f"{title}\n{mark * len(title)}\n"


def row(argument: Any) -> str:
    check, _, unit = argument.facts.partition(";")[0].removeprefix(", ").partition("unit ")
    text = argument.text[0].upper() + argument.text[1:] if argument.text[:2].islower() else argument.text
    default = f"``{argument.default}``" if argument.default else "(required)"
    cells = (
        f"``{argument.name}``",
        escaped(", ".join(part for part in (argument.type, check.rstrip(", ")) if part)),
        f"{default} {unit if unit != '1' else ''}".rstrip(),
        f"{escaped(text)}.",
    )
    return "   * - " + "\n     - ".join(cells) + "\n"


def page(name: str, function: Any, create: ModuleType, examples: dict[str, str], drawn: set[str]) -> str:
    plain, mirrors = inspect.unwrap(function), create._mirrors
    items = ", ".join(f":ref:`{item} <item-{item}>`" for item in mirrors.MIRRORS.get(name, ()))
    calls = [f".{each}(" for each in (name, snake_case(name))]
    used = [stem for stem, code in examples.items() if any(call in code for call in calls)]
    return "\n".join(
        (
            f".. _create-{name}:\n\n{heading(name)}",
            figure(PICTURES, f"{name}.png", "The model of the example.") if name in drawn else "",
            *as_rst(inspect.getdoc(plain).splitlines()),
            f"\n:Items: {items or ':doc:`general contact </general_contact>`'}\n",
            heading("Arguments", "-"),
            f"``mbs.{name}(...)`` takes these arguments, by name. ``model.{snake_case(name)}(...)`` takes them in "
            "snake_case, such as ``body_numbers`` for ``bodyNumbers``, and returns handles.\n",
            ".. list-table::\n   :header-rows: 1\n   :class: rows\n",
            "   * - name\n     - type\n     - default\n     - description",
            "".join(map(row, mirrors.arguments(plain, create.checks(plain)))),
            f".. _create-example-{name}:\n",
            f"{heading('Example', '-')}\nBefore it, ``mbs`` is an empty system.\n\n.. code-block:: python\n",
            indent(mirrors.EXAMPLES[name].strip(), "   "),
            f"\n{heading('See also', '-')}" if used else "",
            "".join(f"* :ref:`example-{stem}`\n" for stem in used),
        )
    )


def create_pages() -> dict[str, str]:
    if find_spec("dalembert") is None:
        return {"create/index.rst": f".. _create:\n\n{heading('Create functions')}\n{INTRO}"}
    from dalembert import create

    examples = {path.stem: path.read_text("utf-8") for path in sorted(EXAMPLES.glob("*.py"))}
    functions = create.functions
    drawn = draw(PICTURES, {name: create._mirrors.EXAMPLES[name] for name in functions})
    pages = {f"create/{name}.rst": page(name, functions[name], create, examples, drawn) for name in functions}
    rows = "".join(
        f"   * - :ref:`{name} <create-{name}>`\n     - {escaped((function.__doc__ or '').splitlines()[0])}\n"
        for name, function in functions.items()
    )
    table = f".. list-table::\n   :header-rows: 1\n   :class: rows\n\n   * - function\n     - what it does\n{rows}"
    tree = ".. toctree::\n   :hidden:\n\n" + "".join(f"   {name}\n" for name in functions)
    return pages | {"create/index.rst": f".. _create:\n\n{heading('Create functions')}\n{INTRO}\n{tree}\n{table}"}
