"""Pages that are made of the repository at build time, below docs/_generated: item reference, Create
functions, examples, Python modules.

The reference is copied from generated/docs; a page for each module is written from its name and docstring.
"""

from __future__ import annotations

import importlib
import pkgutil
from importlib.util import find_spec
from inspect import isroutine
from pathlib import Path
from types import FunctionType, ModuleType

from create_pages import create_pages, heading
from example_pages import example_pages
from item_pictures import draw_pages, with_pictures
from sphinx.application import Sphinx
from theory_figures import draw_figures

ROOT = Path(__file__).parents[2]
TARGET = ROOT / "docs/_generated"
FIRST_SETTINGS = Path(__file__).parent / "first_settings"  # what everybody sets, above the table of all settings

NOT_BUILT = """\
.. note::

   These pages were built without the compiled package; install it, and build them again to see its modules.
"""
# Classes of the compiled core that users meet; items, enumerations and settings have pages of their own.
CORE = {
    "MainSystem": "system",
    "SystemContainer": "system",
    "SystemData": "system",
    "MatrixContainer": "data",
    "PyMatrixContainer": "data",
    "Vector3DList": "data",
    "Matrix3DList": "data",
    "Vector2DList": "data",
    "Vector6DList": "data",
    "Matrix6DList": "data",
    "BeamSection": "data",
    "BeamSectionGeometry": "data",
    "MainSolverStatic": "solvers",
    "MainSolverImplicitSecondOrder": "solvers",
    "MainSolverDiagonallyImplicit": "solvers",
    "MainSolverExplicit": "solvers",
}
# Modules with pages of another kind; Create... and the like are methods of MainSystem.
ELSEWHERE = ("cli", "create", "itemInterface", "mainSystemExtensions", "robotics.roboticsCore")
CORE_TITLES = {"system": "Systems", "data": "Matrices and lists", "solvers": "Solver objects"}


def toctree(names: list[str], depth: int = 1) -> str:
    return f".. toctree::\n   :maxdepth: {depth}\n\n" + "".join(f"   {name}\n" for name in names)


def reference_pages() -> dict[str, str]:
    source = ROOT / "generated/docs"
    pages = {f"reference/{p.relative_to(source).as_posix()}": p.read_text("utf-8") for p in source.rglob("*.rst")}
    for file in FIRST_SETTINGS.glob("*.rst"):
        label = f".. _settings-{file.stem}-{file.stem}:"
        words = f"{file.read_text('utf-8')}\n{label}\n\n{heading('All settings', '-')}"
        pages = {path: text.replace(label, words) for path, text in pages.items()}
    return with_pictures(pages)


def documented(module: ModuleType, seen: set[int]) -> list[str]:
    """Names of the functions and classes of a module, also of private ones behind it; each is shown once."""
    names = []
    for name in getattr(module, "__all__", vars(module)):
        thing = getattr(module, name)
        if name.startswith("_") or id(thing) in seen or not isinstance(thing, type | FunctionType):
            continue
        owner = thing.__module__
        private = owner.startswith("dalembert._") and not owner.startswith("dalembert._core")
        if private or f"{owner}.".startswith(f"{module.__name__}."):
            seen.add(id(thing))
            names.append(name)
    return names


def member(module: str, name: str, thing: object) -> str:
    kind = "autoclass" if isinstance(thing, type) else "autofunction"
    members = "   :members:\n" if kind == "autoclass" else ""
    if isinstance(thing, type) and any(base.__module__.startswith("dalembert._fem.") for base in thing.__mro__[1:]):
        members += "   :inherited-members:\n"  # parts that are no classes of their own to users
    return f".. {kind}:: {module}.{name}\n{members}"


def core_pages(core: ModuleType) -> dict[str, str]:
    """The classes of the compiled core, in groups, and its functions."""
    pages = {}
    for stem, title in CORE_TITLES.items():
        names = [name for name, page in CORE.items() if page == stem and hasattr(core, name)]
        classes = (f"{heading(name, '-')}\n{member('dalembert', name, getattr(core, name))}" for name in names)
        pages[f"api/{stem}.rst"] = f"{heading(title)}\n" + "\n".join(classes)
    functions = [name for name, thing in vars(core).items() if isroutine(thing) and not name.startswith("_")]
    texts = (member("dalembert", name, getattr(core, name)) for name in functions)
    pages["api/functions.rst"] = f"{heading('Functions of the package')}\n" + "\n".join(texts)
    return pages


def module_pages() -> dict[str, str]:
    """A page per public Python module, and those of the compiled core."""
    head = f".. _api:\n\n{heading('Python interface')}\n"
    try:
        package = importlib.import_module("dalembert")
    except ImportError:
        return {"api/index.rst": head + NOT_BUILT}
    pages = core_pages(importlib.import_module("dalembert._core"))
    modules, seen = [], set[int]()
    for info in pkgutil.walk_packages(package.__path__, "dalembert."):
        name = info.name.removeprefix("dalembert.")
        if any(part.startswith("_") for part in name.split(".")) or name in ELSEWHERE:
            continue
        module = importlib.import_module(info.name)
        members = (member(info.name, thing, getattr(module, thing)) for thing in documented(module, seen))
        pages[f"api/{name}.rst"] = f"{heading(info.name)}\n.. automodule:: {info.name}\n\n" + "\n".join(members)
        modules.append(name)
    pages["api/index.rst"] = f"{head}{toctree([*CORE_TITLES, 'functions'])}\n{toctree(modules)}"
    return pages


def write(app: Sphinx) -> None:
    """Write only changed files, so that Sphinx reads only these; remove outdated files."""
    draw_figures()
    if find_spec("dalembert") is not None:
        draw_pages()
    pages = reference_pages() | create_pages() | example_pages() | module_pages()
    wanted = {TARGET / path: text for path, text in pages.items()}
    for path in TARGET.rglob("*.rst"):
        if path not in wanted:
            path.unlink()
    for path, text in wanted.items():
        path.parent.mkdir(parents=True, exist_ok=True)
        if not path.exists() or path.read_text("utf-8") != text:
            path.write_text(text, "utf-8")


def setup(app: Sphinx) -> dict[str, bool]:
    app.connect("builder-inited", write)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
