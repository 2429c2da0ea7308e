"""The methods of MainSystem that are written in Python, attached to the compiled class when the package is imported."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from dalembert import _planned, create, solver
from dalembert._core import MainSystem, Renderer, SystemContainer
from dalembert._io import model_files, pickling
from dalembert._pictures import renderer, shortcuts
from dalembert._pictures.draw import Draw, DrawSolution
from dalembert._pictures.glb import SaveGLB
from dalembert._pictures.html import SaveHTML
from dalembert._pictures.vtu import SaveVTU
from dalembert._plots.repr_html import _ipython_display_, _repr_html_
from dalembert._plots.system_graph import DrawSystemGraph
from dalembert._solving.buckling import ComputeBucklingLoads
from dalembert._solving.consistent import ComputeConsistentInitialConditions
from dalembert._solving.energies import ComputeEnergies
from dalembert._solving.inspection import InspectSolution
from dalembert._solving.report import Report
from dalembert._solving.vibrations import ComputeVibrationModes
from dalembert._studies.variations import SolveVariations
from dalembert._tools import missing_names
from dalembert.create._interface import (  # noqa: F401
    GetMarkersPosRot,
    JointPreCheckCalcBodyMarkers,
    JointTypeToAxis,
    ProcessBodyNodeMarkerLists,
)
from dalembert.interactive import SolutionViewer
from dalembert.plot import PlotSensor

methods: dict[str, Callable[..., Any]] = (
    _planned.methods
    | create.functions
    | shortcuts.SYSTEM_METHODS
    | {
        function.__name__: function
        for function in (
            ComputeBucklingLoads,
            ComputeConsistentInitialConditions,
            ComputeEnergies,
            ComputeVibrationModes,
            Draw,
            DrawSolution,
            DrawSystemGraph,
            InspectSolution,
            model_files.Load,
            model_files.Save,
            PlotSensor,
            Report,
            SaveGLB,
            SaveHTML,
            SaveVTU,
            SolutionViewer,
            pickling.GetDictionary,
            pickling.__copy__,
            pickling.__deepcopy__,
            pickling.__reduce__,
            _ipython_display_,
            _repr_html_,
            solver.ComputeLinearizedSystem,
            solver.ComputeODE2Eigenvalues,
            solver.ComputeSystemDegreeOfFreedom,
            solver.SolveDynamic,
            solver.SolveStatic,
            SolveVariations,
        )
    }
)

for _name, _method in methods.items():
    setattr(MainSystem, _name, _method)

for _class, _functions in ((Renderer, renderer.METHODS), (SystemContainer, shortcuts.METHODS)):
    for _function in _functions:
        setattr(_class, _function.__name__, _function)

missing_names.explain()

# Functions of the module, MainSystemCreateGround(mbs, ...) and so on.
globals().update({f"MainSystem{name}": function for name, function in methods.items() if name.startswith("Create")})
