"""Energies, type checks of arguments, sweeps and steps for excitation, sparse matrices and HDF5 storage."""

from __future__ import annotations

import sys
from importlib import import_module
from typing import Any

from dalembert._io.hdf5 import ConvertDictToScipySparse, ConvertScipySparseToDict, LoadDictFromHDF5, SaveDictToHDF5
from dalembert._solving.item_derivatives import ItemODE2Coordinates, NumericalJacobian
from dalembert._solving.item_energies import CreateLoadEnergySensor, LoadPotentialEnergy, SystemEnergy
from dalembert._tools.argument_types import (
    ExpectedType,
    IsEmptyList,
    IsInteger,
    IsIntVector,
    IsListOrArray,
    IsNone,
    IsNotNone,
    IsReal,
    IsSquareMatrix,
    IsValidBool,
    IsValidInt,
    IsValidMarkerIndex,
    IsValidNodeIndex,
    IsValidObjectIndex,
    IsValidPRealInt,
    IsValidRealInt,
    IsValidURealInt,
    IsVector,
    RaiseTypeError,
)
from dalembert._tools.excitation import FrequencySweep, SmoothStep, SmoothStepDerivative, SweepCos, SweepSin
from dalembert._tools.matrices import FillInSubMatrix, IndexFromValue, RoundMatrix
from dalembert._tools.missing_names import missing_in
from dalembert._tools.symbolic_functions import ConvertFunctionToSymbolic, CreateSymbolicUserFunction
from dalembert._tools.variables import FindNodeIndex, FindObjectIndex, PlotLineCode

__all__ = [
    "ConvertDictToScipySparse",
    "ConvertFunctionToSymbolic",
    "ConvertScipySparseToDict",
    "CreateLoadEnergySensor",
    "CreateSymbolicUserFunction",
    "ExpectedType",
    "FillInSubMatrix",
    "FindNodeIndex",
    "FindObjectIndex",
    "FrequencySweep",
    "IndexFromValue",
    "IsEmptyList",
    "IsIntVector",
    "IsInteger",
    "IsListOrArray",
    "IsNone",
    "IsNotNone",
    "IsReal",
    "IsSquareMatrix",
    "IsValidBool",
    "IsValidInt",
    "IsValidMarkerIndex",
    "IsValidNodeIndex",
    "IsValidObjectIndex",
    "IsValidPRealInt",
    "IsValidRealInt",
    "IsValidURealInt",
    "IsVector",
    "ItemODE2Coordinates",
    "LoadDictFromHDF5",
    "LoadPotentialEnergy",
    "NumericalJacobian",
    "PlotLineCode",
    "RaiseTypeError",
    "RoundMatrix",
    "SaveDictToHDF5",
    "SmoothStep",
    "SmoothStepDerivative",
    "SweepCos",
    "SweepSin",
    "SystemEnergy",
]


# Names that are here in release 1.13, and in utilities before.
_IN_UTILITIES = ("CloseTCPIPconnection", "CreateTCPIPconnection", "TCPIPdata", "TCPIPsendReceive")


def __getattr__(name: str) -> Any:
    if name in _IN_UTILITIES:
        return getattr(import_module("dalembert.utilities"), name)
    raise missing_in(sys.modules[__name__], name)
