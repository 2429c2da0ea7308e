"""Create functions of drives: motors, PID controllers, prescribed motion, stops of joints, forces from tables."""

from __future__ import annotations

import inspect
import warnings
from collections.abc import Callable, Sequence
from typing import Any, Literal

import numpy as np

from dalembert import itemInterface as items
from dalembert import laws
from dalembert._core import LoadIndex, MainSystem, MarkerIndex, ObjectIndex
from dalembert.create._arguments import (
    FLAG,
    NO_PAIR,
    NOT_NEGATIVE,
    NUMBER,
    POSITIVE,
    ZERO3,
    Check,
    Connected,
    Vector,
    argument_error,
    require_axis,
    vector,
)
from dalembert.create._frames import add_joint_markers, joint_place, require_axis_of_joint, require_axis_of_plane
from dalembert.create._signals import SIGNAL, Signal, rate, recorded, signal
from dalembert.create.connectors import frame_with_z
from dalembert.create.loads import _load_marker

Kind = Literal["rotation", "translation"]


def _law(
    name: str,
    kind: str,
    constants: dict[str, float],
    compute: Callable[..., Any],
    states: dict[str, float] | None = None,
) -> Any:
    """Return a law with constants; `compute` gets the arguments of its kind, its states, and the constants by name."""

    def law(*arguments: Any, **given: Any) -> Any:
        return compute(*arguments, **given)

    own = ["phi", "omega", "t"] if kind == "rotation" else ["u", "phi", "v", "omega", "t"]
    plain = inspect.Parameter.POSITIONAL_OR_KEYWORD
    parameters = [inspect.Parameter(each, plain) for each in (*own, *(states or {}))]
    parameters += [inspect.Parameter(each, plain, default=value) for each, value in constants.items()]
    law.__signature__ = inspect.Signature(parameters)  # type: ignore[attr-defined]
    law.__name__ = name
    return laws.connector(kind, states=states)(law)


def _limited(value: Any, limit: Any) -> Any:
    return value if limit is None else laws.minimum(laws.maximum(value, -limit), limit)


class _Axis:
    """Markers and joint frames of two bodies, whose z axes are the axis of a drive."""

    def __init__(
        self,
        mbs: Any,
        function: str,
        name: str,
        bodyNumbers: Sequence[Any],
        position: Vector,
        axis: Vector,
        useGlobalFrame: bool,
        is_rotation: bool,
    ) -> None:
        require_axis(function, axis)
        place = joint_place(mbs, function, bodyNumbers, position, useGlobalFrame)
        for i, number in enumerate(bodyNumbers):
            if not isinstance(number, MarkerIndex) and mbs.GetObject(number)["objectType"].startswith("MassPoint"):
                expected = "a rigid body, such as a sphere, because a mass point has no orientation"
                raise argument_error(function, f"bodyNumbers[{i}]", expected, mbs.GetObject(number)["name"])
        require_axis_of_plane(mbs, function, place, place.to_global(axis, useGlobalFrame), normal=is_rotation)
        require_axis_of_joint(mbs, function, bodyNumbers, place.to_global(axis, useGlobalFrame), is_rotation)
        frames = place.local_frames(frame_with_z(place.to_global(axis, useGlobalFrame)))
        self.frames: dict[str, Any] = {"rotationMarker0": frames[0], "rotationMarker1": frames[1]}
        self._mbs, self._place, self._name = mbs, place, name

    def markers(self) -> list[Any]:
        return add_joint_markers(self._mbs, self._place, self._name)


def _add_rotation(mbs: Any, name: str, axis: _Axis, law: Any, show: bool) -> ObjectIndex:
    """Add a torsional connector with a law, whose angle counts turns."""
    turns = mbs.AddNode(items.NodeGenericData(initialCoordinates=[0], numberOfDataCoordinates=1))
    made = law(axis.markers(), name=name, nodeNumber=turns, **axis.frames)
    made.visualization = {"show": show}
    index: ObjectIndex = mbs.AddObject(made)
    return index


def CreateMotor(
    mbs: MainSystem,
    name: str = "",
    bodyNumbers: Sequence[Connected] = NO_PAIR,
    position: Vector = [],
    axis: Vector = [],
    torque: Signal | None = None,
    speed: Signal | None = None,
    angle: Signal | None = None,
    ramp: float = 0.0,
    smooth: bool = False,
    stiffness: float = 0.0,
    damping: float = 0.0,
    maximumTorque: float | None = None,
    useGlobalFrame: bool = True,
    show: bool = True,
) -> ObjectIndex:
    """Add a motor between a stator, the first body, and a rotor; return its ObjectIndex.

    One of torque (Nm), speed (rad/s) and angle (rad) of the rotor relative to the stator is given over time: as a
    number, as a table [[t, value], ...], as a file with such columns, or as a function of t that can be recorded, see
    dalembert.laws. Speed and angle are reached by feedback: the torque is stiffness (angle - actual angle) +
    damping (speed - actual speed), up to maximumTorque. A hinge has to hold the bodies together.
    """
    function = "CreateMotor"
    given = {key: each for key, each in (("torque", torque), ("speed", speed), ("angle", angle)) if each is not None}
    if len(given) != 1:
        raise argument_error(function, "speed", "one of torque, speed and angle", sorted(given) or None)
    (what,) = given
    needed = {"torque": (), "speed": ("damping",), "angle": ("stiffness", "damping")}[what]
    gains = {"stiffness": stiffness, "damping": damping}
    for gain, value in gains.items():
        if gain in needed and value <= 0:
            unit = "Nm/rad" if gain == "stiffness" else "Nms/rad"
            raise argument_error(function, gain, f"a gain greater than zero ({unit}), as {what} is given", value)
        if gain not in needed and value != 0:
            raise argument_error(function, gain, f"no gain, as {what} is given", value)
    wanted = signal(function, what, given[what], smooth, ramp)
    constants = {gain: float(gains[gain]) for gain in needed}
    if maximumTorque is not None:
        constants["maximumTorque"] = float(maximumTorque)

    def motor(phi: Any, omega: Any, t: Any, maximumTorque: Any = None, **gain: Any) -> Any:
        value = wanted(t)
        if what == "torque":
            drive = value
        elif what == "speed":
            drive = gain["damping"] * (value - omega)
        else:
            drive = gain["stiffness"] * (value - phi) + gain["damping"] * (rate(value, t) - omega)
        return -_limited(drive, maximumTorque)

    shaft = _Axis(mbs, function, name, bodyNumbers, position, axis, useGlobalFrame, True)
    return _add_rotation(mbs, name, shaft, _law("motor", "rotation", constants, motor), show)


def CreatePIDController(
    mbs: MainSystem,
    name: str = "",
    bodyNumbers: Sequence[Connected] = NO_PAIR,
    position: Vector = [],
    axis: Vector = [],
    setPoint: Signal = 0.0,
    P: float = 0.0,
    I: float = 0.0,  # noqa: E741
    D: float = 0.0,
    limit: float | None = None,
    kind: Kind = "rotation",
    ramp: float = 0.0,
    smooth: bool = False,
    useGlobalFrame: bool = True,
    show: bool = True,
) -> ObjectIndex:
    """Add a PID controller that drives the second body relative to the first one, about or along an axis.

    The set point is an angle (rad) or, with kind='translation', a displacement (m) since the reference configuration:
    a number, a table, a file or a function of t, as in CreateMotor. The torque or force is P e + I (integral of e) +
    D (rate of e), with the error e, up to the limit, at which the integral does not grow. The
    controller acts continuously, not once per step. Returns the ObjectIndex.
    """
    function = "CreatePIDController"
    if kind not in ("rotation", "translation"):
        raise argument_error(function, "kind", "'rotation' or 'translation'", kind)
    if P == I == D == 0:
        raise argument_error(function, "P", "a gain that is not zero: P, I or D", P)
    wanted = signal(function, "setPoint", setPoint, smooth, ramp)
    constants = {key: float(value) for key, value in (("P", P), ("I", I), ("D", D)) if value != 0}
    if limit is not None:
        constants["limit"] = float(limit)

    def output(actual: Any, speed: Any, t: Any, integral: Any, limit: Any, gains: dict[str, Any]) -> tuple[Any, Any]:
        value = wanted(t)
        error = value - actual
        drive = 0.0
        for gain, each in (("P", error), ("I", integral), ("D", rate(value, t) - speed)):
            drive = drive + gains[gain] * each if gain in gains else drive
        if limit is None:
            return drive, error
        saturates = ((drive > limit) + (drive < -limit)) * (drive * error > 0)
        return _limited(drive, limit), laws.where(saturates, 0.0, error)

    def turning(phi: Any, omega: Any, t: Any, turned: Any, integral: Any, limit: Any = None, **gains: Any) -> Any:
        # phi jumps by a turn; the state only counts turns
        actual = phi + 2 * np.pi * np.round((turned - phi) / (2 * np.pi))
        drive, error = output(actual, omega, t, integral, limit, gains)
        return -drive, omega, error

    def moving(u: Any, phi: Any, v: Any, omega: Any, t: Any, integral: Any, limit: Any = None, **gains: Any) -> Any:
        drive, error = output(u[2], v[2], t, integral, limit, gains)
        return ([0, 0, -drive], [0, 0, 0]), error

    if kind == "rotation":
        law = _law("controller", "rotation", constants, turning, {"turned": 0.0, "integral": 0.0})
    else:
        law = _law("controller", "frames", constants, moving, {"integral": 0.0})
    shaft = _Axis(mbs, function, name, bodyNumbers, position, axis, useGlobalFrame, kind == "rotation")
    made = law(shaft.markers(), name=name, nodeNumbers=law.AddNodes(mbs), **shaft.frames)
    made.visualization = {"show": show}
    return mbs.AddObject(made)


def CreateJointStops(
    mbs: MainSystem,
    name: str = "",
    bodyNumbers: Sequence[Connected] = NO_PAIR,
    position: Vector = [],
    axis: Vector = [],
    lower: float | None = None,
    upper: float | None = None,
    stiffness: float = 0.0,
    damping: float = 0.0,
    kind: Kind = "rotation",
    useGlobalFrame: bool = True,
    show: bool = True,
) -> ObjectIndex:
    """Limit the angle (rad) or displacement (m) of the second body relative to the first one; return the ObjectIndex.

    Beyond lower or upper, a spring and a damper push back; they never pull. Angles and displacements are zero in the
    reference configuration. Use it together with a revolute or prismatic joint.
    """
    function = "CreateJointStops"
    if kind not in ("rotation", "translation"):
        raise argument_error(function, "kind", "'rotation' or 'translation'", kind)
    if lower is None and upper is None:
        raise argument_error(function, "lower", "a number, or one for upper", lower)
    if lower is not None and upper is not None and not lower < upper:
        raise argument_error(function, "lower", f"a number below upper={upper:g}", lower)
    if stiffness <= 0:
        raise argument_error(function, "stiffness", "a number greater than zero (Nm/rad or N/m)", stiffness)
    constants = {key: float(each) for key, each in (("lower", lower), ("upper", upper)) if each is not None}
    if constants.get("lower", 0.0) > 0 or constants.get("upper", 0.0) < 0:
        text = (
            f"{function}: lower={lower}, upper={upper}: the reference configuration, where the "
            f"{'angle' if kind == 'rotation' else 'displacement'} is 0, is beyond a stop, which pushes there"
        )
        warnings.warn(text, stacklevel=4)
    constants |= {"stiffness": float(stiffness)} | ({"damping": float(damping)} if damping else {})

    def force(way: Any, speed: Any, stiffness: Any, lower: Any = None, upper: Any = None, damping: Any = 0.0) -> Any:
        total = 0.0
        if upper is not None:
            push = laws.maximum(stiffness * (way - upper) + damping * speed, 0.0)
            total = total + laws.where(way > upper, push, 0.0)
        if lower is not None:
            push = laws.maximum(stiffness * (lower - way) - damping * speed, 0.0)
            total = total - laws.where(way < lower, push, 0.0)
        return total

    shaft = _Axis(mbs, function, name, bodyNumbers, position, axis, useGlobalFrame, kind == "rotation")
    if kind == "rotation":
        law = _law("stops", "rotation", constants, lambda phi, omega, t, **given: force(phi, omega, **given))
        return _add_rotation(mbs, name, shaft, law, show)
    law = _law(
        "stops", "frames", constants,
        lambda u, phi, v, omega, t, **given: ([0, 0, force(u[2], v[2], **given)], [0, 0, 0]),
    )  # fmt: skip
    made = law(shaft.markers(), name=name, **shaft.frames)
    made.visualization = {"show": show}
    return mbs.AddObject(made)


def CreatePrescribedMotion(
    mbs: MainSystem,
    name: str = "",
    bodyNumbers: Sequence[Connected] = NO_PAIR,
    position: Vector = [],
    axis: Vector = [],
    motion: Signal = 0.0,
    kind: Kind = "translation",
    smooth: bool = True,
    ramp: float = 0.0,
    useGlobalFrame: bool = True,
    show: bool = True,
) -> ObjectIndex:
    """Prescribe a displacement (m) along an axis, or an angle (rad) about it, between two bodies, by a constraint.

    The motion of the second body relative to the first one is given over time, as in CreateMotor, but tables are
    splines by default. It has to fit the initial position and velocity. Other directions remain free: add a joint.
    Returns the ObjectIndex.
    """
    function = "CreatePrescribedMotion"
    if kind not in ("rotation", "translation"):
        raise argument_error(function, "kind", "'rotation' or 'translation'", kind)
    place = 5 if kind == "rotation" else 2
    wanted = signal(function, "motion", motion, smooth, ramp)
    shaft = _Axis(mbs, function, name, bodyNumbers, position, axis, useGlobalFrame, kind == "rotation")

    def offset(t: Any) -> list[Any]:
        return [wanted(t) if i == place else 0.0 for i in range(6)]

    def rates(t: Any) -> list[Any]:
        return [rate(each, t) for each in offset(t)]

    functions = {
        row: recorded(function, "motion", "ObjectJointGeneric", row, compute)
        for row, compute in (("offsetUserFunction", offset), ("offsetUserFunction_t", rates))
    }
    return mbs.AddObject(
        items.ObjectJointGeneric(
            name=name,
            markerNumbers=shaft.markers(),
            constrainedAxes=[int(i == place) for i in range(6)],
            visualization=items.VObjectJointGeneric(show=show),
            **shaft.frames,
            **functions,
        )
    )


def _force(
    mbs: Any, function: str, item: Any, rigid: bool, name: str, bodyNumber: Any, table: Any, direction: Vector,
    localPosition: Vector, bodyFixed: bool, smooth: bool, show: bool,
) -> Any:  # fmt: skip
    if not any(direction):
        raise argument_error(function, "direction", "a vector with 3 components that is not zero", direction)
    if table is None:
        raise argument_error(function, "table", SIGNAL, table)
    along = np.asarray(direction, dtype=float) / np.linalg.norm(direction)
    value = signal(function, "table", table, smooth)
    name_of_item = item.__name__

    def vector_at(t: Any) -> list[Any]:
        magnitude = value(t)
        return [float(each) * magnitude for each in along]

    law = recorded(function, "table", name_of_item, "loadVectorUserFunction", vector_at)
    marker = _load_marker(mbs, function, bodyNumber, localPosition, rigid)
    return mbs.AddLoad(
        item(
            name=name,
            markerNumber=marker,
            bodyFixed=bodyFixed,
            loadVectorUserFunction=law,
            visualization={"show": show},
        )
    )


def CreateForceFromTable(
    mbs: MainSystem,
    name: str = "",
    bodyNumber: Connected | None = None,
    table: Signal | None = None,
    direction: Vector = [1, 0, 0],
    localPosition: Vector = ZERO3,
    bodyFixed: bool = False,
    smooth: bool = False,
    show: bool = True,
) -> LoadIndex:
    """Add a force (N) in a direction, whose magnitude is given over time, at a point of a body; return its LoadIndex.

    The table has rows [t, force]; it may be the name of a file with these columns, or a function of t. Between rows it
    is linear or, if smooth, a cubic spline; before and after the table, it is constant.
    """
    index: LoadIndex = _force(
        mbs, "CreateForceFromTable", items.LoadForceVector, bool(bodyFixed), name, bodyNumber, table, direction,
        localPosition, bodyFixed, smooth, show,
    )  # fmt: skip
    return index


def CreateTorqueFromTable(
    mbs: MainSystem,
    name: str = "",
    bodyNumber: Connected | None = None,
    table: Signal | None = None,
    direction: Vector = [0, 0, 1],
    bodyFixed: bool = False,
    smooth: bool = False,
    show: bool = True,
) -> LoadIndex:
    """Add a torque (Nm) about a direction, whose magnitude is given over time, on a body; return its LoadIndex.

    The table is as in CreateForceFromTable.
    """
    index: LoadIndex = _force(
        mbs, "CreateTorqueFromTable", items.LoadTorqueVector, True, name, bodyNumber, table, direction, ZERO3,
        bodyFixed, smooth, show,
    )  # fmt: skip
    return index


_TIME = "over time (" + SIGNAL + ")"
_COMMON_TEXTS = {
    "ramp": "time in which the given quantity grows smoothly from zero (s)",
    "kind": "'rotation': about the axis; 'translation': along the axis",
    "smooth": "True: tables are cubic splines, which may overshoot between rows; False: linear between rows",
    "show": "False: the item is not drawn",
    "name": "name of the item; if empty, a name is made from kind and number",
}
TEXTS = {
    "CreateMotor": {
        **_COMMON_TEXTS,
        "torque": f"torque on the rotor (Nm), {_TIME}",
        "speed": f"angular velocity of the rotor (rad/s), {_TIME}",
        "angle": f"angle of the rotor (rad), {_TIME}",
        "stiffness": "gain of the angle (Nm/rad)",
        "damping": "gain of the angular velocity (Nms/rad)",
        "maximumTorque": "limit of the torque (Nm); None: no limit",
    },
    "CreatePIDController": {
        **_COMMON_TEXTS,
        "setPoint": f"wanted angle (rad) or displacement (m), {_TIME}",
        "P": "gain of the error (Nm/rad or N/m)",
        "I": "gain of the integral of the error (Nm/(rad s) or N/(m s))",
        "D": "gain of the rate of the error (Nms/rad or Ns/m)",
        "limit": "limit of the torque (Nm) or force (N); None: no limit",
    },
    "CreateJointStops": {
        **_COMMON_TEXTS,
        "lower": "smallest angle (rad) or displacement (m); None: no limit",
        "upper": "largest angle (rad) or displacement (m); None: no limit",
        "stiffness": "stiffness of the stops (Nm/rad or N/m)",
        "damping": "damping of the stops (Nms/rad or Ns/m)",
    },
    "CreatePrescribedMotion": {**_COMMON_TEXTS, "motion": f"displacement (m) or angle (rad), {_TIME}"},
    "CreateForceFromTable": {
        **_COMMON_TEXTS,
        "table": f"force (N), {_TIME}",
        "direction": "direction of the force, of any length, in the global frame or, if bodyFixed, in that of the body",
    },
    "CreateTorqueFromTable": {
        **_COMMON_TEXTS,
        "table": f"torque (Nm), {_TIME}",
        "direction": "axis of the torque, of any length, in the global frame or, if bodyFixed, in that of the body",
    },
}
_AXIS = {"axis": vector(3), "show": FLAG}
# Requirements on arguments besides those of the mirrored item and COMMON.
CHECKS: dict[str, dict[str, Check]] = {
    "CreateMotor": {
        **_AXIS,
        "ramp": NOT_NEGATIVE,
        "stiffness": NOT_NEGATIVE,
        "damping": NOT_NEGATIVE,
        "smooth": FLAG,
        "maximumTorque": POSITIVE.optional(),
    },
    "CreatePIDController": {
        **_AXIS,
        "P": NUMBER,
        "I": NUMBER,
        "D": NUMBER,
        "limit": POSITIVE.optional(),
        "ramp": NOT_NEGATIVE,
        "smooth": FLAG,
    },
    "CreateJointStops": {
        **_AXIS,
        "lower": NUMBER.optional(),
        "upper": NUMBER.optional(),
        "stiffness": POSITIVE,
        "damping": NOT_NEGATIVE,
    },
    "CreatePrescribedMotion": {**_AXIS, "ramp": NOT_NEGATIVE, "smooth": FLAG},
    "CreateForceFromTable": {"direction": vector(3), "smooth": FLAG, "show": FLAG},
    "CreateTorqueFromTable": {"direction": vector(3), "smooth": FLAG, "show": FLAG},
}
