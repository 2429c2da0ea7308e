"""Pages that are made of the repository at build time, below docs/_generated: item reference, examples, Python modules.

The reference is copied from generated/docs; a page for each example and module is written from its name and docstring.
"""

from __future__ import annotations

import ast
import importlib
import pkgutil
from pathlib import Path

from sphinx.application import Sphinx

ROOT = Path(__file__).parents[2]
TARGET = ROOT / "docs/_generated"

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
    "MainSolverExplicit": "solvers",
}
CORE_TITLES = {"system": "Systems", "data": "Matrices and lists", "solvers": "Solver objects"}


def heading(title: str, mark: str = "=") -> str:
    return f"{title}\n{mark * len(title)}\n"


def toctree(names: list[str], depth: int = 1) -> str:
    return f".. toctree::\n   :maxdepth: {depth}\n\n" + "".join(f"   {name}\n" for name in names)


def reference_pages() -> dict[str, str]:
    source = ROOT / "generated/docs"
    return {f"reference/{p.relative_to(source).as_posix()}": p.read_text("utf-8") for p in source.rglob("*.rst")}


def example_pages() -> dict[str, str]:
    """A page per file in examples/: its docstring, and the code after it."""
    pages = {}
    for path in sorted((ROOT / "examples").glob("*.py")):
        module = ast.parse(path.read_text("utf-8"))
        first = module.body[1]
        title = path.stem.replace("_", " ").capitalize()
        pages[f"examples/{path.stem}.rst"] = (
            f".. _example-{path.stem}:\n\n{heading(title)}\n{ast.get_docstring(module)}\n\n"
            f"The file is ``examples/{path.name}``.\n\n"
            f".. literalinclude:: ../../../examples/{path.name}\n   :language: python\n   :lines: {first.lineno}-\n"
        )
    names = [Path(page).stem for page in pages]
    intro = "Complete models, each one file; they run in the tests.\n"
    pages["examples/index.rst"] = f".. _examples:\n\n{heading('Examples')}\n{intro}\n{toctree(names)}"
    return pages


def module_pages() -> dict[str, str]:
    """A page per public Python module, and the classes of the compiled core."""
    head = f".. _api:\n\n{heading('Python interface')}\n"
    try:
        package = importlib.import_module("dalembert")
    except ImportError:
        return {"api/index.rst": head + NOT_BUILT}
    core = importlib.import_module("dalembert._core")
    pages = {}
    for stem, title in CORE_TITLES.items():
        names = [name for name, page in CORE.items() if page == stem and hasattr(core, name)]
        classes = (f"{heading(name, '-')}\n.. autoclass:: dalembert.{name}\n   :members:\n" for name in names)
        pages[f"api/{stem}.rst"] = f"{heading(title)}\n" + "\n".join(classes)
    modules = [m.name for m in pkgutil.iter_modules(package.__path__) if not m.name.startswith("_")]
    modules = [name for name in modules if name not in ("itemInterface", "cli")]
    for name in modules:
        text = f".. automodule:: dalembert.{name}\n   :members:\n"
        pages[f"api/{name}.rst"] = f"{heading('dalembert.' + name)}\n{text}"
    pages["api/index.rst"] = f"{head}{toctree(list(CORE_TITLES))}\n{toctree(modules)}"
    return pages


def write(app: Sphinx) -> None:
    """Touch only what differs, so that Sphinx reads only what changed; remove what is no longer made."""
    wanted = {TARGET / path: text for path, text in (reference_pages() | example_pages() | module_pages()).items()}
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
