"""The methods of MainSystem that are written in Python, attached to the compiled class when the package is imported."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from dalembert import _pickling, _planned, create, solver
from dalembert._consistent import ComputeConsistentInitialConditions
from dalembert._core import MainSystem
from dalembert._distance_sensor import CreateDistanceSensor, CreateDistanceSensorGeometry
from dalembert._repr_html import _repr_html_
from dalembert._system_graph import DrawSystemGraph
from dalembert._variations import SolveVariations
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
    | {
        function.__name__: function
        for function in (
            ComputeConsistentInitialConditions,
            CreateDistanceSensor,
            CreateDistanceSensorGeometry,
            DrawSystemGraph,
            PlotSensor,
            SolutionViewer,
            _pickling.GetDictionary,
            _pickling.__copy__,
            _pickling.__deepcopy__,
            _pickling.__reduce__,
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

# Functions of the module, MainSystemCreateGround(mbs, ...) and so on.
globals().update({f"MainSystem{name}": function for name, function in methods.items() if name.startswith("Create")})
