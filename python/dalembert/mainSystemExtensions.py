"""The methods of MainSystem that are written in Python, attached to the compiled class when the package is imported.

Until one of them is first used, a placeholder stands for it in the class: most models need few of their modules.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from importlib import import_module
from typing import TYPE_CHECKING, Any

from dalembert import _planned, create, solver
from dalembert._core import MainSystem, Renderer, SystemContainer
from dalembert._io import pickling
from dalembert._pictures import renderer, shortcuts
from dalembert._tools import missing_names

if TYPE_CHECKING:
    methods: dict[str, Callable[..., Any]]

# Of the package, by the names of the methods.
_MODULES = {
    "_pictures.draw": ("Draw", "DrawSolution"),
    "_pictures.glb": ("SaveGLB",),
    "_pictures.html": ("SaveHTML",),
    "_pictures.vtu": ("SaveVTU",),
    "_plots.repr_html": ("_ipython_display_", "_repr_html_"),
    "_plots.system_graph": ("DrawSystemGraph",),
    "_solving.buckling": ("ComputeBucklingLoads",),
    "_solving.consistent": ("ComputeConsistentInitialConditions",),
    "_solving.energies": ("ComputeEnergies",),
    "_solving.inspection": ("InspectSolution",),
    "_solving.item_computations": ("ComputeItem", "Inspect"),
    "_solving.report": ("Report",),
    "_solving.vibrations": ("ComputeVibrationModes",),
    "_studies.exact_sensitivities": ("ComputeSensitivities",),
    "_studies.variations": ("SolveVariations",),
    "_io.model_files": ("Load", "Save"),
    "interactive": ("SolutionViewer",),
    "plot": ("PlotSensor",),
}
_MODULE_OF = {name: module for module, names in _MODULES.items() for name in names}
_CREATE = tuple(name for names in create.MODULES.values() for name in names)
_INTERFACE = (
    "GetMarkersPosRot",
    "JointPreCheckCalcBodyMarkers",
    "JointTypeToAxis",
    "ProcessBodyNodeMarkerLists",
)

_AT_HAND: dict[str, Callable[..., Any]] = (
    _planned.methods
    | shortcuts.SYSTEM_METHODS
    | {
        function.__name__: function
        for function in (
            pickling.GetDictionary,
            pickling.__copy__,
            pickling.__deepcopy__,
            pickling.__reduce__,
            solver.ComputeLinearizedSystem,
            solver.ComputeODE2Eigenvalues,
            solver.ComputeSystemDegreeOfFreedom,
            solver.SolveDynamic,
            solver.SolveStatic,
        )
    }
)


def _method(name: str) -> Callable[..., Any]:
    """Return a method from its module."""
    if name not in _MODULE_OF:
        return create.method(name)
    function: Callable[..., Any] = getattr(import_module(f"dalembert.{_MODULE_OF[name]}"), name)
    return function


class _Placeholder:
    """In the class, in the place of a method: puts that there when it is first asked for."""

    def __init__(self, name: str) -> None:
        self.name = name

    def __get__(self, instance: Any, owner: type | None = None) -> Any:
        function = _method(self.name)
        if vars(MainSystem).get(self.name) is self:
            setattr(MainSystem, self.name, function)
        return function if instance is None else function.__get__(instance, owner)


for _name, _function in _AT_HAND.items():
    setattr(MainSystem, _name, _function)
for _name in (*_MODULE_OF, *_CREATE):
    setattr(MainSystem, _name, _Placeholder(_name))

for _class, _functions in ((Renderer, renderer.METHODS), (SystemContainer, shortcuts.METHODS)):
    for _function in _functions:
        setattr(_class, _function.__name__, _function)

missing_names.explain()

# Functions of the module: MainSystemCreateGround(mbs, ...) and so on.
_FUNCTIONS = {f"MainSystem{name}": name for name in _CREATE}
__all__ = ["methods", *_FUNCTIONS, *_INTERFACE, *(name for name in _MODULE_OF if not name.startswith("_"))]  # noqa: PLE0604


def __getattr__(name: str) -> Any:
    if name == "methods":
        return _AT_HAND | {each: getattr(MainSystem, each) for each in (*_MODULE_OF, *_CREATE)}
    if name in _FUNCTIONS:
        return create.method(_FUNCTIONS[name])
    if name in _INTERFACE:
        return getattr(import_module("dalembert.create._interface"), name)
    if name in _MODULE_OF:
        return _method(name)
    raise missing_names.missing_in(sys.modules[__name__], name)


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
