"""Flexible multibody dynamics: models of nodes, objects, markers, loads and sensors, and solvers for them.

import dalembert as exu
SC = exu.SystemContainer()
mbs = SC.AddSystem()
"""

# ruff: noqa: I001  `as` says to type checkers what users import from here

from __future__ import annotations

import gc as _gc
import sys as _sys
from typing import TYPE_CHECKING, Any

_collects = _gc.isenabled()
_gc.disable()  # importing makes many objects that stay: looking at them takes a sixth of the time
try:
    try:
        from dalembert import _core as _core
    except ImportError as _error:
        raise ImportError(
            f"the compiled module dalembert._core cannot be loaded ({_error}); "
            "install the package, e.g. by 'pip install .' in the source folder"
        ) from _error
    from dalembert import _planned
    from dalembert._tools import completion as _completion, missing_names as _missing_names
    from dalembert._tools import user_interface as _user_interface  # noqa: F401  importing it reads the environment
    from dalembert._core import *
    from dalembert._planned import (
        SolverFileData as SolverFileData,
        SolverLocalData as SolverLocalData,
    )
    from dalembert._version import (
        RequireVersion as RequireVersion,
        __version__ as __version__,
        interface_version as interface_version,
    )
    from dalembert import mainSystemExtensions as _extensions  # noqa: F401  importing it extends MainSystem
    from dalembert._solving.diagnosis import FinishedNotTrusted as FinishedNotTrusted, SolverError as SolverError
    from dalembert._geometry.rigid_transformation import HT as HT
    from dalembert._solving.item_computations import (
        ComputeItemType as ComputeItemType,
        InspectType as InspectType,
        MarkerType as MarkerType,
    )
    from dalembert.solver import (
        ComputeLinearizedSystem as ComputeLinearizedSystem,
        ComputeODE2Eigenvalues as ComputeODE2Eigenvalues,
        ComputeSystemDegreeOfFreedom as ComputeSystemDegreeOfFreedom,
        SolveDynamic as SolveDynamic,
        SolverSuccess as SolverSuccess,
        SolveStatic as SolveStatic,
    )
finally:
    if _collects:
        _gc.enable()

if TYPE_CHECKING:
    from dalembert._io.model_files import ModelFileError as ModelFileError
    from dalembert._model.model import Model as Model
    from dalembert._model.solution import Solution as Solution, SolutionWarning as SolutionWarning
    from dalembert._studies.design_parameters import DesignParameter as DesignParameter
    from dalembert._studies.differentiable_model import DifferentiableModel as DifferentiableModel
    from dalembert._studies.differentiable_outputs import (
        At as At,
        BucklingLoad as BucklingLoad,
        Eigenvalue as Eigenvalue,
        EventTime as EventTime,
        Final as Final,
        FrequencyResponse as FrequencyResponse,
        Function as Function,
        Integral as Integral,
        Reaction as Reaction,
    )
    from dalembert._studies.not_differentiable import NotDifferentiable as NotDifferentiable

_completion.tell_ipython()

# Modules that are loaded when they are first used, as attribute or by import.
_submodules = frozenset(
    (
        "FEM",
        "GUI",
        "advancedUtilities",
        "alias",
        "artificialIntelligence",
        "basicUtilities",
        "beams",
        "compiled",
        "control",
        "demos",
        "graphics",
        "graphicsDataUtilities",
        "handles",
        "interactive",
        "itemInterface",
        "kinematicTree",
        "laws",
        "lieGroupBasics",
        "lieGroupIntegration",
        "machines",
        "mainSystemExtensions",
        "misc",
        "particles",
        "physics",
        "plot",
        "processing",
        "results",
        "resultsMonitor",
        "rigidBodyUtilities",
        "robotics",
        "shells",
        "signalProcessing",
        "solver",
        "treeDynamics",
        "types",
        "utilities",
    )
)
_renamed = {"exudynCPP": _core}
# Names of these modules, likewise.
_classes = {
    "ModelFileError": "_io.model_files",
    "Model": "_model.model",
    "Solution": "_model.solution",
    "SolutionWarning": "_model.solution",
    "DesignParameter": "_studies.design_parameters",
    "DifferentiableModel": "_studies.differentiable_model",
    "At": "_studies.differentiable_outputs",
    "BucklingLoad": "_studies.differentiable_outputs",
    "Eigenvalue": "_studies.differentiable_outputs",
    "EventTime": "_studies.differentiable_outputs",
    "FrequencyResponse": "_studies.differentiable_outputs",
    "Final": "_studies.differentiable_outputs",
    "Function": "_studies.differentiable_outputs",
    "Integral": "_studies.differentiable_outputs",
    "Reaction": "_studies.differentiable_outputs",
    "NotDifferentiable": "_studies.not_differentiable",
}

if TYPE_CHECKING:
    from dalembert import (
        FEM as FEM,
        GUI as GUI,
        _core as exudynCPP,  # noqa: F401
        advancedUtilities as advancedUtilities,
        alias as alias,
        artificialIntelligence as artificialIntelligence,
        basicUtilities as basicUtilities,
        beams as beams,
        compiled as compiled,
        control as control,
        demos as demos,
        graphics as graphics,
        graphicsDataUtilities as graphicsDataUtilities,
        handles as handles,
        interactive as interactive,
        itemInterface as itemInterface,
        kinematicTree as kinematicTree,
        lieGroupBasics as lieGroupBasics,
        laws as laws,
        lieGroupIntegration as lieGroupIntegration,
        machines as machines,
        mainSystemExtensions as mainSystemExtensions,
        misc as misc,
        particles as particles,
        physics as physics,
        plot as plot,
        processing as processing,
        results as results,
        resultsMonitor as resultsMonitor,
        rigidBodyUtilities as rigidBodyUtilities,
        robotics as robotics,
        shells as shells,
        signalProcessing as signalProcessing,
        solver as solver,
        treeDynamics as treeDynamics,
        types as types,
        utilities as utilities,
    )
else:
    __all__ = [  # noqa: PLE0604
        "ComputeItemType",
        "ComputeLinearizedSystem",
        "ComputeODE2Eigenvalues",
        "ComputeSystemDegreeOfFreedom",
        "FinishedNotTrusted",
        "HT",
        "InspectType",
        "MarkerType",
        "RequireVersion",
        "SolveDynamic",
        "SolveStatic",
        "SolverError",
        "SolverFileData",
        "SolverLocalData",
        "SolverSuccess",
        "__version__",
        "interface_version",
        *_classes,
        *[name for name in vars(_core) if not name.startswith("_")],
    ]

    def __getattr__(name: str) -> Any:
        """Load a submodule on first use."""
        if name in _renamed:
            return _renamed[name]
        if name in _submodules:
            from importlib import import_module

            return import_module(f"dalembert.{name}")
        if name in _classes:
            from importlib import import_module

            return getattr(import_module(f"dalembert.{_classes[name]}"), name)
        if text := _planned.module_text(name):
            raise AttributeError(text)
        raise _missing_names.missing_in(_sys.modules[__name__], name)

    def __dir__() -> list[str]:
        return sorted({*globals(), *_submodules, *_classes})

    _missing_names.explain_module(_sys.modules[__name__])
