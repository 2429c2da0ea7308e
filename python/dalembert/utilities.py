"""Names for models, imported by `from dalembert.utilities import *`: items, rotations, graphics helpers, and the
functions of this module around joints, sensors, solution files and connections to other programs."""

# ruff: noqa: F401, I001  what is imported here is what users import from here: `as` says so to type checkers

from __future__ import annotations

from enum import Enum as Enum
from math import cos as cos, sin as sin, sqrt as sqrt
from typing import TYPE_CHECKING, Any

import numpy.typing as npt

from dalembert import graphics as graphics
from dalembert._checks import FloatArray
from dalembert._core import ItemType, Print
from dalembert.create.sensors import (
    CreateDistanceSensor as CreateDistanceSensor,
    CreateDistanceSensorGeometry as CreateDistanceSensorGeometry,
)
from dalembert._io.binary_solutions import (
    BinaryReadArrayIndex as BinaryReadArrayIndex,
    BinaryReadIndex as BinaryReadIndex,
    BinaryReadReal as BinaryReadReal,
    BinaryReadRealVector as BinaryReadRealVector,
    BinaryReadString as BinaryReadString,
    LoadBinarySolutionFile as LoadBinarySolutionFile,
    NumpyInt8ArrayToString as NumpyInt8ArrayToString,
)
from dalembert._io.solution_states import (
    AnimateSolution as AnimateSolution,
    InitializeFromRestartFile as InitializeFromRestartFile,
    LoadSolutionFile as LoadSolutionFile,
    SetSolutionState as SetSolutionState,
)
from dalembert._io.text_solutions import RecoverSolutionFile as RecoverSolutionFile
from dalembert._plots.system_graph import DrawSystemGraph as DrawSystemGraph
from dalembert._tools.found_items import index_of
from dalembert._io.tcpip import (
    CloseTCPIPconnection as CloseTCPIPconnection,
    CreateTCPIPconnection as CreateTCPIPconnection,
    TCPIPdata as TCPIPdata,
    TCPIPsendReceive as TCPIPsendReceive,
)
from dalembert._names import copy as copy, eii as eii, exu as exu, exudyn as exudyn, math as math, np as np
from dalembert.advancedUtilities import *
from dalembert.basicUtilities import *
from dalembert.beams import (
    GenerateAleSlidingJoint as GenerateAleSlidingJoint,
    GenerateSlidingJoint as GenerateSlidingJoint,
    GenerateStraightBeam as GenerateStraightBeam,
    GenerateStraightLineANCFCable2D as GenerateStraightLineANCFCable2D,
)
from dalembert.create._frames import reference_position, reference_rotation
from dalembert.graphicsDataUtilities import *
from dalembert.itemInterface import *
from dalembert.rigidBodyUtilities import *

AddEdgesAndSmoothenNormals = graphics.AddEdgesAndSmoothenNormals

# Earlier names of functions in dalembert.graphics.
GraphicsDataOrthoCubePoint = graphics.Brick
GraphicsDataCube = graphics.Cuboid
GraphicsDataOrthoCube = graphics.BrickXYZ
GraphicsDataSphere = graphics.Sphere
GraphicsDataCylinder = graphics.Cylinder
GraphicsDataLine = graphics.Lines
GraphicsDataQuad = graphics.Quad
GraphicsDataCircle = graphics.Circle
GraphicsDataText = graphics.Text
GraphicsDataRigidLink = graphics.RigidLink
GraphicsDataSolidOfRevolution = graphics.SolidOfRevolution
GraphicsDataSolidExtrusion = graphics.SolidExtrusion
GraphicsDataArrow = graphics.Arrow
GraphicsDataBasis = graphics.Basis
GraphicsDataFrame = graphics.Frame
GraphicsDataCheckerBoard = graphics.CheckerBoard
GraphicsDataFromSTLfile = graphics.FromSTLfile
GraphicsDataFromSTLfileTxt = graphics.FromSTLfileASCII
GraphicsDataFromPointsAndTrigs = graphics.FromPointsAndTrigs
GraphicsData2PointsAndTrigs = graphics.ToPointsAndTrigs
ExportGraphicsData2STL = graphics.ExportSTL
MoveGraphicsData = graphics.Move
MergeGraphicsDataTriangleList = graphics.MergeTriangleLists

# ---- joints ---------------------------------------------------------------------------------------------------------


def _marker_at(where: str, mbs: Any, bodyNumber: Any, existingMarker: Any, **options: Any) -> tuple[Any, FloatArray]:
    """Add a rigid marker on a body where another marker is in the reference configuration; return it and the rotation.

    The rotation is that of the body, local to global.
    """
    bodyNumber = index_of(mbs, "Object", bodyNumber, f"{where}: body")
    existingMarker = index_of(mbs, "Marker", existingMarker, f"{where}: marker")
    rotation = reference_rotation(mbs, bodyNumber)
    local = rotation.T @ (reference_position(mbs, existingMarker) - reference_position(mbs, bodyNumber))
    return mbs.AddMarker(eii.MarkerBodyRigid(bodyNumber=bodyNumber, localPosition=local, **options)), rotation


def GetOtherMarker(mbs: Any, bodyNumber: Any, existingMarker: Any, show: bool = True) -> Any:
    """Add a rigid marker on a body, at the place of an existing marker in the reference state; return its index."""
    view = eii.VMarkerBodyRigid(show=show)
    return _marker_at("GetOtherMarker", mbs, bodyNumber, existingMarker, visualization=view)[0]


def GetJointArgs(
    mbs: Any,
    markerNumber0: Any = None,
    markerNumber1: Any = None,
    rotationMarker0: npt.ArrayLike | None = None,
    rotationMarker1: npt.ArrayLike | None = None,
    bodyNumber0: Any = None,
    bodyNumber1: Any = None,
) -> dict[str, Any]:
    """Return markerNumbers, rotationMarker0 and rotationMarker1 of a joint of which one marker exists.

    Give one marker, with the joint axes in its frame as columns of its rotation (default: identity), and the other
    body: a marker is added there and the rotation chosen such that both agree in the reference configuration.
    """
    first = markerNumber0 is not None
    existing, rotation = (markerNumber0, rotationMarker0) if first else (markerNumber1, rotationMarker1)
    body, other = (bodyNumber1, 1) if first else (bodyNumber0, 0)
    if existing is None or (first and markerNumber1 is not None):
        raise ValueError("GetJointArgs: expected exactly one of markerNumber0 and markerNumber1")
    if body is None:
        raise ValueError(f"GetJointArgs: with markerNumber{1 - other}, bodyNumber{other} must be given")

    given = np.eye(3) if rotation is None else np.asarray(rotation, dtype=float)
    existing = index_of(mbs, "Marker", existing, "GetJointArgs: marker")
    marker, bodyRotation = _marker_at("GetJointArgs", mbs, body, existing)
    found = bodyRotation.T @ reference_rotation(mbs, existing) @ given
    markers, rotations = ([existing, marker], [given, found]) if first else ([marker, existing], [found, given])
    return {"markerNumbers": markers, "rotationMarker0": rotations[0], "rotationMarker1": rotations[1]}


# ---- drawing ---------------------------------------------------------------------------------------------------------


def ShowOnlyObjects(mbs: Any, objectNumbers: Any = [], showOthers: bool = False) -> None:
    """Draw only the given objects, or all but these if showOthers; an empty list stands for all objects."""
    chosen = objectNumbers if isinstance(objectNumbers, (list, tuple)) else [objectNumbers]
    numbers = {int(index_of(mbs, "Object", number, "ShowOnlyObjects: objectNumbers")) for number in chosen}
    for i in range(mbs.systemData.NumberOfObjects()):
        if "Vshow" in mbs.GetObject(i):
            is_chosen = i in numbers or not numbers
            mbs.SetObjectParameter(i, "Vshow", is_chosen != bool(showOthers))
    mbs.GetSystemContainer().renderer.SendRedrawSignal()


def HighlightItem(
    SC: Any, mbs: Any, itemNumber: Any, itemType: Any = ItemType.Object, showNumbers: bool = True
) -> None:
    """Highlight one item, and show the numbers of all items of its kind; an itemNumber of -1 ends it."""
    settings = SC.visualizationSettings
    if isinstance(itemNumber, str) or int(itemNumber) != -1:
        itemNumber = index_of(mbs, itemType.name, itemNumber, "HighlightItem: itemNumber")
    settings.interactive.highlightItemIndex = int(itemNumber)
    settings.interactive.highlightItemType = itemType
    groups = {
        ItemType.Node: ("nodes",),
        ItemType.Object: ("bodies", "connectors"),
        ItemType.Marker: ("markers",),
        ItemType.Load: ("loads",),
        ItemType.Sensor: ("sensors",),
    }
    for kind, names in groups.items():
        for name in names:
            group = getattr(settings, name)
            group.showNumbers = bool(showNumbers) and kind == itemType
            if group.showNumbers and hasattr(group, "show"):
                group.show = True
    SC.renderer.SendRedrawSignal()


# ---- recorded sensors -----------------------------------------------------------------------------------------------


def UFsensorRecord(mbs: Any, t: float, sensorNumbers: list[Any], factors: FloatArray, configuration: Any) -> FloatArray:
    """Sensor user function of AddSensorRecorder: store time and values, one row per factors[0] seconds."""
    number = sensorNumbers[0]
    values = np.atleast_1d(mbs.GetSensorValues(number, configuration=configuration))
    record = mbs.variables[f"sensorRecord{number}"]
    row = int((t + 1e-9) / factors[0])
    if 0 <= row < len(record):
        record[row] = [t, *values]
    return values


def AddSensorRecorder(
    mbs: Any, sensorNumber: Any, endTime: float, sensorsWritePeriod: float, sensorOutputSize: int = 3
) -> Any:
    """Record a sensor in mbs.variables['sensorRecord<number>'], rows of time (s) and values; return the new sensor.

    Deprecated: sensors with storeInternal=True do the same.
    """
    Print("WARNING: AddSensorRecorder is deprecated, use sensors with storeInternal=True")
    rows = int(endTime / sensorsWritePeriod) + 1
    sensorNumber = index_of(mbs, "Sensor", sensorNumber, "AddSensorRecorder: sensorNumber")
    mbs.variables[f"sensorRecord{sensorNumber}"] = np.zeros((rows, 1 + sensorOutputSize))
    return mbs.AddSensor(
        eii.SensorUserFunction(
            sensorNumbers=[sensorNumber],
            factors=[sensorsWritePeriod],
            writeToFile=False,
            sensorUserFunction=UFsensorRecord,
        )
    )


# Internal names of other modules that users do not import.
_HIDDEN = {
    *("Any", "FloatArray", "GraphicsData", "IntArray", "ItemType", "Print", "Sequence", "TYPE_CHECKING", "annotations"),
    *("Lines", "index_of", "as_matrix", "as_points", "as_vector", "color", "colorList", "npt", "reference_position"),
    *("reference_rotation", "triangle_normals", "unit_rows", "warnings"),
}
if not TYPE_CHECKING:  # type checkers follow the imports; they would take a computed list for an empty one
    __all__ = [name for name in list(globals()) if not name.startswith("_") and name not in _HIDDEN]
