"""Create function of flexible bodies: frame, modes, body, weight, and markers on its interfaces in one call."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from dalembert import itemInterface as items
from dalembert.create._arguments import (
    FLAG,
    NOT_NEGATIVE,
    ZERO3,
    Check,
    Matrix,
    Vector,
    argument_error,
    color,
    rotation_matrix,
    vector,
)

if TYPE_CHECKING:
    from dalembert.FEM import FEMinterface


def CreateFFRFReducedOrderObject(
    mbs: Any,
    name: str | None,
    femInterface: FEMinterface,
    referencePosition: Vector = ZERO3,
    initialVelocity: Vector = ZERO3,
    referenceRotationMatrix: Matrix = np.eye(3),
    initialAngularVelocity: Vector = ZERO3,
    massProportionalDamping: float = 0.0,
    stiffnessProportionalDamping: float = 0.0,
    gravity: Vector = ZERO3,
    color: Vector = [0.0, 1.0, 0.0, 1.0],
    superElementRigidMarkersOffsets: Any = None,
    showMarkers: bool = True,
    verbose: bool = False,
) -> dict[str, Any]:
    """Add a flexible body with the modes of a mesh, and a rigid marker on each node set of type 'boundary'.

    Returns the numbers of the markers by their names, 'name:boundary', and under 'FFRFReducedOrderObjectDict' those of
    nRigidBody, nGenericODE2, oFFRFreducedOrder and loadGravity. Free modes ('NormalModes') have no markers.
    """
    from dalembert._fem.modal_body import ObjectFFRFreducedOrderInterface

    function = "CreateFFRFReducedOrderObject"
    if "matrix" not in getattr(femInterface, "modeBasis", {}):
        expected = "a FEMinterface with modes, such as those of ComputeHurtyCraigBamptonModes"
        raise argument_error(function, "femInterface", expected, femInterface)
    has_interfaces = femInterface.modeBasis["type"] == "HCBmodes"
    sets = [s for s in femInterface.nodeSets if s.get("type") == "boundary"] if has_interfaces else []
    offsets = _offsets(function, superElementRigidMarkersOffsets, len(sets))
    markers = [f"{name}:{s['Name']}" if name is not None else s["Name"] for s in sets]
    for marker in markers:
        if int(mbs.GetMarkerNumber(marker)) != -1:
            raise argument_error(function, "name", f"a new name, since the marker '{marker}' exists", name)
    body = ObjectFFRFreducedOrderInterface(femInterface).AddObjectFFRFreducedOrder(
        mbs,
        name=name or "",
        positionRef=referencePosition,
        initialVelocity=initialVelocity,
        rotationMatrixRef=np.asarray(referenceRotationMatrix),
        initialAngularVelocity=initialAngularVelocity,
        massProportionalDamping=massProportionalDamping,
        stiffnessProportionalDamping=stiffnessProportionalDamping,
        gravity=gravity,
        color=list(color),
    )
    result: dict[str, Any] = {"FFRFReducedOrderObjectDict": body}
    for marker, nodes, offset in zip(markers, sets, offsets, strict=True):
        result[marker] = mbs.AddMarker(
            items.MarkerSuperElementRigid(
                name=marker,
                bodyNumber=body["oFFRFreducedOrder"],
                meshNodeNumbers=nodes["NodeNumbers"],
                weightingFactors=nodes["NodeWeights"],
                offset=offset,
                visualization={"show": showMarkers},
            )
        )
        if verbose:
            print(f"marker '{marker}': {result[marker]}")
    return result


def _offsets(function: str, given: Any, count: int) -> Any:
    """Return a vector for each marker."""
    if given is None:
        return np.zeros((count, 3))
    try:
        rows = np.atleast_2d(np.asarray(given, dtype=float))
    except (TypeError, ValueError):
        rows = np.zeros((0, 0))
    if rows.shape != (count, 3) or not np.isfinite(rows).all():
        expected = f"{count} vectors with 3 components, one for each marker"
        raise argument_error(function, "superElementRigidMarkersOffsets", expected, given)
    return rows


CHECKS: dict[str, dict[str, Check]] = {
    "CreateFFRFReducedOrderObject": {
        "name": Check(lambda value: value is None or (isinstance(value, str) and value != ""), "a name, or None"),
        "referencePosition": vector(3),
        "initialVelocity": vector(3),
        "referenceRotationMatrix": rotation_matrix(),
        "initialAngularVelocity": vector(3),
        "massProportionalDamping": NOT_NEGATIVE,
        "stiffnessProportionalDamping": NOT_NEGATIVE,
        "gravity": vector(3),
        "color": color(),
        "showMarkers": FLAG,
        "verbose": FLAG,
    },
}
