"""Pages of the examples: docstring, pictures, output, and code.

Examples are run when pages are built, side by side.
"""

from __future__ import annotations

import ast
import os
from concurrent.futures import ThreadPoolExecutor
from importlib.util import find_spec
from pathlib import Path

from example_runs import EXAMPLES, RUNS, run

INTRO = """\
Complete models, each in one file, which run by ``dalembert run examples/name.py`` or by Python. Most print a result
with
its theoretical value; tests compare them.
"""


def pictures(path: Path) -> list[str]:
    """Names of the files that the example has drawn. The first stands for it: the model, if it is drawn."""
    names = [file.name for file in (RUNS / path.stem).iterdir() if file.suffix in (".png", ".gif")]
    return sorted(names, key=lambda name: ("_picture" not in name, name))


def title(path: Path) -> str:
    return path.stem.replace("_", " ").capitalize()


def page(path: Path, with_results: bool) -> str:
    module = ast.parse(path.read_text("utf-8"))
    name = title(path)
    parts = [f".. _example-{path.stem}:\n\n{name}\n{'=' * len(name)}\n\n{ast.get_docstring(module)}\n"]
    if with_results:
        parts += [f".. image:: {path.stem}/{picture}\n   :width: 49%\n" for picture in pictures(path)]
        parts.append(f"It prints\n\n.. literalinclude:: {path.stem}/printed.txt\n   :language: none\n")
    parts.append(
        f"The file is ``examples/{path.name}``.\n\n.. literalinclude:: ../../../examples/{path.name}\n"
        f"   :language: python\n   :lines: {module.body[1].lineno}-\n"
    )
    return "\n".join(parts)


def thumbnail(path: Path) -> str:
    """The first picture, with title and summary of the example."""
    summary = ast.get_docstring(ast.parse(path.read_text("utf-8"))).splitlines()[0]
    return (
        f"   .. figure:: {path.stem}/{pictures(path)[0]}\n      :target: {path.stem}.html\n"
        f"      :alt: {title(path)}\n\n      :ref:`{title(path)} <example-{path.stem}>`. {summary}\n"
    )


def index(with_results: bool) -> str:
    names = "".join(f"   {path.stem}\n" for path in EXAMPLES)
    thumbnails = ".. container:: thumbnails\n\n" + "\n".join(map(thumbnail, EXAMPLES)) if with_results else ""
    hidden = "   :hidden:\n" if with_results else ""
    return f".. _examples:\n\nExamples\n========\n\n{INTRO}\n.. toctree::\n{hidden}\n{names}\n{thumbnails}"


def example_pages() -> dict[str, str]:
    """A page per file in examples/, and their index; results require the compiled package."""
    built = find_spec("dalembert") is not None
    if built:
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            list(pool.map(run, EXAMPLES))
    pages = {f"examples/{path.stem}.rst": page(path, built) for path in EXAMPLES}
    return pages | {"examples/index.rst": index(built)}
