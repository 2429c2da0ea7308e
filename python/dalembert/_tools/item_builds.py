"""Packages with items of their own: they are started, built and tested.

The compiled part of a package, _items, is generated from specs/ and kernels/ and compiled against the headers of this
dalembert.
"""

from __future__ import annotations

import hashlib
import os
import shlex
import shutil
import subprocess
import sys
import sysconfig
import tomllib
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from dalembert import _core
from dalembert._version import __version__

COMPILED = "_items.abi3.so"
# Flags of the core (CMakeLists.txt) that matter for the speed of items.
FLAGS = ("-std=c++20", "-O3", "-fno-math-errno", "-fPIC", "-fvisibility=hidden", "-fvisibility-inlines-hidden")
WARNINGS = ("-Wall", "-Wextra")  # of the package's own sources; headers of dalembert are system headers
GNU_FLAGS = ("-Wno-psabi", "-Wno-restrict", "-fno-gcse-after-reload")
STRATEGY = "vector_loop:512:noalign,libcall:-1:noalign"
X86_FLAGS = ("-march=x86-64-v2",)
GNU_X86_FLAGS = (f"-mmemset-strategy={STRATEGY}", f"-mmemcpy-strategy={STRATEGY}")


class BuildError(Exception):
    """A package cannot be built; the text has the reason."""


def home() -> Path:
    """Return the directory with headers, specs and the generator: of the wheel, or the repository."""
    package = Path(__file__).resolve().parents[1]
    for place in (package / "_items", Path(str(_core.__file__)).resolve().parent / "_items", package.parents[1]):
        if (place / "codegen" / "headers.py").is_file():
            return place
    raise BuildError("this dalembert was installed without headers and specs, so item packages cannot be built")


def module_name(directory: Path) -> str:
    """Return the name of the module of a package, from its pyproject.toml."""
    project = directory / "pyproject.toml"
    if not project.is_file():
        raise BuildError(f"{directory}: there is no pyproject.toml; `dalembert items new` makes a package")
    name: str = tomllib.loads(project.read_text("utf-8")).get("project", {}).get("name", "")
    if not name:
        raise BuildError(f"{project}: [project] has no name")
    return name.replace("-", "_")


def _generator(*arguments: str) -> str:
    """Run the generator and return its output; its errors are raised."""
    environment = os.environ | {"PYTHONPATH": str(home()), "PYTHONDONTWRITEBYTECODE": "1"}
    command = [sys.executable, "-m", "codegen.item_package", *arguments]
    done = subprocess.run(command, capture_output=True, text=True, env=environment, check=False, cwd=home())
    if done.returncode != 0:
        text = done.stderr.strip()
        if "No module named 'jinja2'" in text:
            text = "jinja2 is missing: pip install dalembert[items]"
        raise BuildError(text)
    return done.stdout


def new(directory: Path, kind: str, name: str) -> list[str]:
    """Start an item, and its package if there is none; return the paths of the files that were written."""
    directory.mkdir(parents=True, exist_ok=True)
    version = ".".join(__version__.split(".")[:2])
    return _generator("new", str(directory.resolve()), kind, name, version).split("\n")[:-1]


@dataclass(frozen=True)
class Compiler:
    command: tuple[str, ...]
    flags: tuple[str, ...]


def _compiler() -> Compiler:
    """Return the compiler of the environment variable CXX, or c++, g++ or clang++; with flags that it accepts."""
    given = shlex.split(os.environ.get("CXX", ""))
    command = given or [name for name in ("c++", "g++", "clang++") if shutil.which(name)][:1]
    if not command or shutil.which(command[0]) is None:
        what = f"CXX={' '.join(given)} was not found" if given else "no C++ compiler was found (c++, g++, clang++)"
        raise BuildError(f"{what}: install one that compiles C++20, such as g++ 11 or clang++ 14")
    asked = [*command, "-x", "c++", "-std=c++20", "-dM", "-E", os.devnull]
    done = subprocess.run(asked, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise BuildError(f"{' '.join(command)} does not compile C++20: {done.stderr.strip()}")
    gnu, x86 = "__clang__" not in done.stdout, "__x86_64__" in done.stdout
    flags = [*FLAGS, *(GNU_FLAGS if gnu else ()), *(X86_FLAGS if x86 else ()), *(GNU_X86_FLAGS if gnu and x86 else ())]
    return Compiler(tuple(command), tuple(flags))


def _header_tool() -> Any:
    """Return codegen/headers.py as a module."""
    from importlib.util import module_from_spec, spec_from_file_location

    spec = spec_from_file_location("_dalembert_headers", home() / "codegen" / "headers.py")
    assert spec is not None and spec.loader is not None
    tool = module_from_spec(spec)
    spec.loader.exec_module(tool)
    return tool


@dataclass(frozen=True)
class _Unit:
    """A source that is compiled alone, with a key of all that its object depends on."""

    source: Path
    object: Path
    command: tuple[str, ...]
    key: str

    def compile(self) -> str:
        """Compile it if it has changed; return the compiler's warnings. Its errors are raised."""
        stored = self.object.with_suffix(".key")
        if self.object.exists() and stored.exists() and stored.read_text("utf-8") == self.key:
            return ""
        self.object.parent.mkdir(parents=True, exist_ok=True)
        stored.unlink(missing_ok=True)
        done = subprocess.run(self.command, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise BuildError(_explained(done.stderr))
        stored.write_text(self.key, "utf-8")
        return done.stderr


def build(directory: Path, output: Path | None = None) -> Path:
    """Generate and compile a package in its directory; return the extension module.

    The module, its stubs and its tables go to `output`; by default, next to the Python files of the package. Warnings
    of the compiler about the package's own sources are written to stderr.
    """
    directory = directory.resolve()
    module = module_name(directory)
    if output is None:
        output = next((place for place in (directory / module, directory / "src" / module) if place.is_dir()), None)
        if output is None:
            raise BuildError(f"{directory}: there is no folder {module} with the Python files of the package")
        work, rebuild = directory / "build" / "items", "dalembert items build"
    else:
        work = output.resolve().parent / f"{output.name}.work"
        rebuild = "pip install --force-reinstall --no-deps --no-build-isolation"
    generated = work / "generated"
    compiler = _compiler()
    _generator(str(directory), module, str(generated))
    units = _units(directory, module, work, compiler, rebuild)
    with ThreadPoolExecutor(os.cpu_count()) as threads:
        for text in threads.map(_Unit.compile, units):
            sys.stderr.write(text)
    output.mkdir(parents=True, exist_ok=True)
    made = work / COMPILED
    link = [*compiler.command, "-shared", *(["-undefined", "dynamic_lookup"] if sys.platform == "darwin" else [])]
    done = subprocess.run(
        [*link, "-o", str(made), *(str(unit.object) for unit in units)], capture_output=True, text=True, check=False
    )
    if done.returncode != 0:
        raise BuildError(done.stderr)
    for file in (made, *(generated / "python").iterdir()):
        written = output / f".{file.name}.new"  # a module that is loaded keeps its file
        shutil.copyfile(file, written)
        written.replace(output / file.name)
    return output / COMPILED


def _units(directory: Path, module: str, work: Path, compiler: Compiler, rebuild: str) -> list[_Unit]:
    tool, place, generated = _header_tool(), home(), work / "generated"
    kernels = directory / "kernels"
    include = [f"-I{kernels}"]
    for headers in (generated / "include", *(place / each for each in tool.INCLUDES)):
        include += ["-isystem", str(headers)]
    own = sorted(file for folder in (kernels, generated / "include") for file in folder.rglob("*") if file.is_file())
    folders = {file.relative_to(generated / "src").parts[0] for file in (generated / "src").rglob("*/*.cpp")}
    support = [*tool.SOURCES, *(source for each in sorted(folders) for source in tool.FURTHER_SOURCES.get(each, ()))]
    own_sources = [*sorted((generated / "src").rglob("*.cpp")), *sorted(kernels.rglob("*.cpp"))]
    stamp = tool.digest(place)
    of_core, of_package = hashlib.sha256(stamp.encode()), hashlib.sha256(stamp.encode())
    for file in own:
        of_package.update(file.read_bytes())
    python = sysconfig.get_path("include")
    if not Path(python, "Python.h").is_file():
        raise BuildError(f"there is no Python.h in {python}: install the headers of Python")
    texts = {"MODULE": module, "SOURCE": directory.as_posix(), "REBUILD": rebuild}
    of_module = (
        f"-I{python}",
        *(f'-DDALEMBERT_ITEM_{key}="{value}"' for key, value in texts.items()),
        f'-DDALEMBERT_HEADERS="{stamp}"',
    )
    units = []
    for source in (*own_sources, *(place / each for each in (tool.SUPPORT, *support))):
        is_own = source in own_sources
        further = (*(WARNINGS if is_own else ("-w",)), *(of_module if source == place / tool.SUPPORT else ()))
        top = next((top for top in (generated / "src", kernels) if source.is_relative_to(top)), source.parent)
        kind = "support" if not is_own else "kernels" if top == kernels else "items"
        object_file = work / "objects" / kind / source.relative_to(top).with_suffix(".o")
        command = (*compiler.command, *compiler.flags, *include, *further)
        command = (*command, "-c", str(source), "-o", str(object_file))
        key = (of_package if is_own else of_core).copy()
        key.update("\0".join(command).encode() + source.read_bytes())
        units.append(_Unit(source, object_file, command, key.hexdigest()))
    return sorted(units, key=lambda unit: "finite_elements" not in unit.source.parts)  # the longest first


def _explained(text: str) -> str:
    """Return messages of a compiler, which begin with the first error in a kernel."""
    lines = text.splitlines()
    first = next((line for line in lines if "error:" in line), "")
    return f"{first}\n\n{text}" if first and lines[0] != first else text


def check(directory: Path, arguments: Iterable[str] = ()) -> int:
    """Build a package and run its tests with pytest; return the exit code."""
    directory = directory.resolve()
    built = build(directory)
    path = os.pathsep.join([str(built.parents[1]), *filter(None, [os.environ.get("PYTHONPATH")])])
    command = [sys.executable, "-m", "pytest", str(directory / "tests"), *arguments]
    return subprocess.run(command, cwd=directory, env=os.environ | {"PYTHONPATH": path}, check=False).returncode
