"""mbs.Inspect: what items provide and request; mbs.ComputeItem: Jacobians and mass matrices of single items."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from enum import IntEnum, IntFlag
from typing import Any

import numpy as np

from dalembert._checks import FloatArray, as_vector, shape_error
from dalembert._core import (
    LoadIndex,
    MarkerIndex,
    NodeIndex,
    NodeType,
    ObjectIndex,
    ObjectType,
    OutputVariableType,
    SensorIndex,
    testing,
)

_ENERGIES = ("KineticEnergy", "PotentialEnergy")


class InspectType(IntEnum):
    """Subjects of mbs.Inspect. AccessFunctions are not available."""

    OutputVariables = 1
    ObjectType = 2
    NodeType = 3
    RequestedNodeTypes = 4
    MarkerType = 5
    RequestedMarkerTypes = 6
    AccessFunctions = 7


class ComputeItemType(IntEnum):
    """Results of mbs.ComputeItem; mbs.ComputeItem(item) returns those that are available for an item."""

    PositionJacobian = 1
    RotationJacobian = 2
    JacobianTTimesVectorDerivative = 3
    MassWeightedPositionJacobian = 4
    ODE2LHS = 5
    MassMatrix = 6
    AlgebraicEquations = 7
    ConstraintJacobian = 8
    ReactionForces = 9
    Kinematics = 10
    CoordinateJacobian = 11
    JacobianODE2 = 12
    JacobianODE2_t = 13


class MarkerType(IntFlag):
    """Capabilities of markers."""

    _None = 0
    Body = 1
    Node = 2
    Object = 4
    SuperElement = 8
    KinematicTree = 16
    Position = 32
    Orientation = 64
    Coordinate = 128
    Coordinates = 256
    BodyLine = 512
    BodySurface = 1024
    BodyVolume = 2048
    BodyMass = 4096
    BodySurfaceNormal = 8192
    MultiNodal = 16384
    ReducedCoordinates = 32768
    ODE1 = 65536
    JacobianDerivativeNonZero = 131072
    JacobianDerivativeAvailable = 262144
    HasPostNewton = 524288
    Beam2DShape = 1048576
    Beam3DShape = 2097152


for _class in (InspectType, ComputeItemType, MarkerType):
    _class.__module__ = "dalembert"

_KINDS = {
    NodeIndex: "Node",
    ObjectIndex: "Object",
    MarkerIndex: "Marker",
    LoadIndex: "Load",
    SensorIndex: "Sensor",
}


def _kind_of(function: str, itemIndex: Any) -> str:
    for index, kind in _KINDS.items():
        if isinstance(itemIndex, index):
            return kind
    raise shape_error(f"mbs.{function}(...): itemIndex", "the index of an item, such as ObjectIndex(0)", itemIndex)


def _facts_of(mbs: Any, kind: str, itemIndex: Any) -> dict[str, Any]:
    from dalembert.types import items

    content = getattr(mbs, f"Get{kind}")(itemIndex)
    name = str(content[f"{kind.lower()}Type"])
    return items[name if name in items else kind + name]


def _members(enumeration: Any, names: list[str]) -> list[Any]:
    return [enumeration[name] for name in names if name in enumeration.__members__]


def _chosen(function: str, what: Any, available: dict[Any, Callable[[], Any]], kind: str, itemIndex: Any) -> Any:
    if what not in available:
        known = ", ".join(str(each.name) for each in available) or "nothing"
        name = getattr(what, "name", repr(what))
        raise ValueError(
            f"mbs.{function}(...): what: {name} is not available for {kind.lower()} {int(itemIndex)}; "
            f"available: {known}"
        )
    return available[what]()


def Inspect(mbs: Any, itemIndex: Any, what: InspectType | None = None) -> Any:
    """Return what an item provides and requests: a list of members of enumerations; a dictionary of all for None.

    Energies are among the output variables only if they can be computed. Requested types have a list for each node,
    or each of two markers.
    """
    kind = _kind_of("Inspect", itemIndex)
    facts = _facts_of(mbs, kind, itemIndex)

    def outputs() -> list[Any]:
        names = [name for name in facts["outputVariables"] if name not in _ENERGIES or _computes(name)]
        return _members(OutputVariableType, names)

    def _computes(name: str) -> bool:
        try:
            mbs.GetObjectOutput(itemIndex, OutputVariableType[name])
        except ValueError:
            return False
        return True

    def requested(enumeration: Any, key: str, count: int) -> list[list[Any]]:
        return [_members(enumeration, facts[key])] * count

    available: dict[Any, Callable[[], Any]] = {}
    if kind in ("Node", "Object", "Marker"):
        available[InspectType.OutputVariables] = outputs
    if kind == "Object":
        available[InspectType.ObjectType] = lambda: _members(ObjectType, facts["types"])
        if facts["requestedNodeTypes"]:
            content = mbs.GetObject(itemIndex)
            nodes = len(content["nodeNumbers"]) if "nodeNumbers" in content else 1
            available[InspectType.RequestedNodeTypes] = lambda: requested(NodeType, "requestedNodeTypes", nodes)
        if facts["requestedMarkerTypes"]:
            markers = len(mbs.GetObject(itemIndex)["markerNumbers"])
            available[InspectType.RequestedMarkerTypes] = lambda: requested(MarkerType, "requestedMarkerTypes", markers)
    if kind == "Node":
        available[InspectType.NodeType] = lambda: _members(NodeType, facts["types"])
    if kind == "Marker":
        available[InspectType.MarkerType] = lambda: _members(MarkerType, facts["types"])
    if kind == "Load":
        available[InspectType.RequestedMarkerTypes] = lambda: requested(MarkerType, "requestedMarkerTypes", 1)
    if what is None:
        return {each: make() for each, make in available.items()}
    return _chosen("Inspect", what, available, kind, itemIndex)


@contextmanager
def _velocities_kept(mbs: Any) -> Iterator[FloatArray]:
    start = np.array(mbs.systemData.GetODE2Coordinates_t())
    try:
        yield start
    finally:
        mbs.systemData.SetODE2Coordinates_t(start)


def _coordinates(mbs: Any, kind: str, itemIndex: Any) -> list[int]:
    from dalembert._solving.item_derivatives import ItemODE2Coordinates

    if kind != "Marker":
        return ItemODE2Coordinates(mbs, itemIndex)
    content = mbs.GetMarker(itemIndex)
    for key in ("bodyNumber", "objectNumber"):
        if key in content:
            return ItemODE2Coordinates(mbs, content[key])
    return ItemODE2Coordinates(mbs, content["nodeNumber"])


def _columns(mbs: Any, coordinates: list[int], output: Callable[[], Any]) -> FloatArray:
    """Return the matrix of an output that is linear in the velocities: its values for unit velocities."""
    columns = []
    with _velocities_kept(mbs) as start:
        for i in coordinates:
            unit = np.zeros_like(start)
            unit[i] = 1
            mbs.systemData.SetODE2Coordinates_t(unit)
            columns.append(np.asarray(output(), dtype=float))
    return np.array(columns).T.reshape(3, len(coordinates))


def ComputeItem(
    mbs: Any,
    itemIndex: Any,
    what: ComputeItemType | None = None,
    localPosition: Any = (0.0, 0.0, 0.0),
    vector: Any = None,
) -> Any:
    """Return Jacobians, the mass matrix, or equations of an item in the current state, or the kinematics of a marker.

    Columns belong to the coordinates of the item, see exu.advancedUtilities.ItemODE2Coordinates. what=None: a list of
    what is available for the item; other members of ComputeItemType raise ValueError. ODE2LHS has the terms of an
    object in the equations of motion, on the left-hand side, without accelerations, loads and Lagrange multipliers;
    JacobianODE2 and JacobianODE2_t are its derivatives by coordinates and velocities. ReactionForces is the transposed
    ConstraintJacobian times the Lagrange multipliers. vector: force and torque, six numbers, for
    JacobianTTimesVectorDerivative, the derivative of their forces on the coordinates of the item by these.
    """
    kind = _kind_of("ComputeItem", itemIndex)
    if kind in ("Load", "Sensor"):
        raise shape_error("mbs.ComputeItem(...): itemIndex", "the index of a node, object or marker", itemIndex)
    coordinates = _coordinates(mbs, kind, itemIndex)
    V = OutputVariableType

    def output(variable: OutputVariableType) -> Any:
        if kind == "Node":
            return mbs.GetNodeOutput(itemIndex, variable)
        if kind == "Marker":
            return mbs.GetMarkerOutput(itemIndex, variable)
        return mbs.GetObjectOutputBody(itemIndex, variable, localPosition)

    def kinematics() -> dict[str, Any]:
        found = {"position": output(V.Position), "velocity": output(V.Velocity)}
        if turns:
            found["rotationMatrix"] = np.reshape(output(V.RotationMatrix), (3, 3))
            found["angularVelocityLocal"] = output(V.AngularVelocityLocal)
        return found

    def has(variable: OutputVariableType) -> bool:
        try:
            output(variable)
        except ValueError:
            return False
        return True

    def forces() -> FloatArray:
        acting = as_vector("mbs.ComputeItem(...): vector", vector, 6)
        found = acting[:3] @ _columns(mbs, coordinates, lambda: output(V.Velocity))
        if turns:
            found = found + acting[3:] @ _columns(mbs, coordinates, lambda: output(V.AngularVelocity))
        return np.asarray(found)

    def derivative() -> FloatArray:
        from dalembert._solving.item_derivatives import NumericalJacobian

        return NumericalJacobian(mbs, forces, coordinates)

    def mass_weighted() -> FloatArray:
        content = mbs.GetObject(itemIndex)
        center = content.get("physicsCenterOfMass", (0.0, 0.0, 0.0))
        center = [*center, 0.0][:3]
        at_center = lambda: mbs.GetObjectOutputBody(itemIndex, V.Velocity, center)  # noqa: E731
        return float(content["physicsMass"]) * _columns(mbs, coordinates, at_center)

    def tangent(**weights: float) -> FloatArray:
        return testing.object_tangent(mbs, int(itemIndex), **weights)

    facts, n = _facts_of(mbs, kind, itemIndex), len(coordinates)
    moves = "Connector" not in facts["types"] and has(V.Velocity)
    turns = moves and has(V.AngularVelocity) and (kind != "Marker" or "Orientation" in facts["types"])
    available: dict[Any, Callable[[], Any]] = {}
    if moves and kind == "Marker":
        available[ComputeItemType.Kinematics] = kinematics
    if moves:
        available[ComputeItemType.PositionJacobian] = lambda: _columns(mbs, coordinates, lambda: output(V.Velocity))
    if turns:
        available[ComputeItemType.RotationJacobian] = lambda: _columns(
            mbs, coordinates, lambda: output(V.AngularVelocity)
        )
    if kind == "Object" and coordinates and "Constraint" not in facts["types"]:
        available[ComputeItemType.ODE2LHS] = lambda: testing.object_residual(mbs, int(itemIndex))[0]
        if "Connector" not in facts["types"]:
            available[ComputeItemType.MassMatrix] = lambda: testing.object_mass_matrix(mbs, int(itemIndex))
        available[ComputeItemType.JacobianODE2] = lambda: tangent()[:n]
        available[ComputeItemType.JacobianODE2_t] = lambda: tangent(cq=0, cv=1)[:n]
    if moves:
        available[ComputeItemType.JacobianTTimesVectorDerivative] = derivative
    if kind == "Object" and {"physicsMass", "physicsCenterOfMass"} & mbs.GetObject(itemIndex).keys() and moves:
        available[ComputeItemType.MassWeightedPositionJacobian] = mass_weighted
    if kind == "Object" and "Constraint" in facts["types"]:
        equations = [int(i) for i in mbs.systemData.GetObjectLTGAE(itemIndex)]
        multipliers = np.array(mbs.systemData.GetAECoordinates())[equations]
        available[ComputeItemType.AlgebraicEquations] = lambda: testing.object_residual(mbs, int(itemIndex))[1]
        available[ComputeItemType.ConstraintJacobian] = lambda: tangent()[n:]
        available[ComputeItemType.ReactionForces] = lambda: tangent()[n:].T @ multipliers
    if kind == "Marker" and "coordinate" in mbs.GetMarker(itemIndex) and "Node" in facts["types"]:
        row = np.zeros((1, len(coordinates)))
        row[0, mbs.GetMarker(itemIndex)["coordinate"]] = 1
        available[ComputeItemType.CoordinateJacobian] = row.copy
    if what is None:
        return list(available)
    return _chosen("ComputeItem", what, available, kind, itemIndex)
