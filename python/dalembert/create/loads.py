"""Create functions of forces and torques on bodies."""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np

from dalembert import itemInterface as items
from dalembert._core import LoadIndex, MainSystem, MarkerIndex, ObjectIndex
from dalembert.create._arguments import ZERO3, UserFunction, Vector, argument_error, is_body


def _load_marker(mbs: Any, function: str, bodyNumber: Any, localPosition: Vector, rigid: bool) -> Any:
    """Return the marker at which a load acts: the given one, or a new one at a local position of a body."""
    if isinstance(bodyNumber, MarkerIndex):
        if np.any(np.asarray(localPosition) != 0):
            expected = "[0,0,0], because bodyNumber is the number of a marker"
            raise argument_error(function, "localPosition", expected, localPosition)
        return bodyNumber
    if not is_body(bodyNumber):
        raise argument_error(function, "bodyNumber", "an ObjectIndex or a MarkerIndex", bodyNumber)
    exists = 0 <= int(bodyNumber) < mbs.systemData.NumberOfObjects()
    if exists and mbs.GetObject(bodyNumber)["objectType"] == "Ground":
        warnings.warn(f"MainSystem.{function}(...): bodyNumber is ground: the load has no effect", stacklevel=4)
    marker = items.MarkerBodyRigid if rigid else items.MarkerBodyPosition
    return mbs.AddMarker(marker(bodyNumber=bodyNumber, localPosition=localPosition))


def CreateForce(
    mbs: MainSystem,
    name: str = "",
    bodyNumber: ObjectIndex | MarkerIndex | int | str | None = None,
    loadVector: Vector = ZERO3,
    localPosition: Vector = ZERO3,
    bodyFixed: bool = False,
    loadVectorUserFunction: UserFunction = 0,
    show: bool = True,
) -> LoadIndex:
    """Add a force (N) at a local position (m) of a body, or at a marker; return its LoadIndex.

    The force is given in the global frame or, if bodyFixed, in the body's. The user function f(mbs, t, loadVector)
    returns the force at time t.
    """
    marker = _load_marker(mbs, "CreateForce", bodyNumber, localPosition, rigid=bool(bodyFixed))
    return mbs.AddLoad(
        items.LoadForceVector(
            name=name,
            markerNumber=marker,
            loadVector=loadVector,
            bodyFixed=bodyFixed,
            loadVectorUserFunction=loadVectorUserFunction,
            visualization={"show": show},
        )
    )


def CreateTorque(
    mbs: MainSystem,
    name: str = "",
    bodyNumber: ObjectIndex | MarkerIndex | int | str | None = None,
    loadVector: Vector = ZERO3,
    localPosition: Vector = ZERO3,
    bodyFixed: bool = False,
    loadVectorUserFunction: UserFunction = 0,
    show: bool = True,
) -> LoadIndex:
    """Add a torque (Nm) at a body, or at a marker; return its LoadIndex.

    The torque is given in the global frame or, if bodyFixed, in the body's. The user function f(mbs, t, loadVector)
    returns the torque at time t.
    """
    marker = _load_marker(mbs, "CreateTorque", bodyNumber, localPosition, rigid=True)
    return mbs.AddLoad(
        items.LoadTorqueVector(
            name=name,
            markerNumber=marker,
            loadVector=loadVector,
            bodyFixed=bodyFixed,
            loadVectorUserFunction=loadVectorUserFunction,
            visualization={"show": show},
        )
    )
