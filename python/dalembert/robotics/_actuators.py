"""Actuators of robots: drives with a control as input, which act on a joint."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from inspect import Parameter, Signature
from typing import TYPE_CHECKING, Any

import dalembert
from dalembert._checks import FloatArray, as_number, as_vector, shape_error
from dalembert.robotics._tendons import AddMarker, add_force, place_of

if TYPE_CHECKING:
    from dalembert.robotics._robot import Robot

_DYNAMICS = ("none", "filter", "integrator")
_STOP_TIME = 1e-3  # s: integrators approach their limits with it, as a jump of the rate has no implicit solution
_ARGUMENTS = {"coordinates": ("q", "q_t"), "rotation": ("phi", "omega"), "frames": ("u", "phi", "v", "omega")}


@dataclass
class RobotActuator:
    """A drive with the force f = (g0 + g1 l + g2 l_t) u + (b0 + b1 l + b2 l_t) on a joint, or on a tendon.

    l = gear * q is the length of the transmission, and gear * f is the force or torque in the joint; u is the control.
    A motor has the gain (1, 0, 0); a position control the gain (kp, 0, 0) and the bias (0, -kp, -kv); a velocity
    control the gain (kv, 0, 0) and the bias (0, 0, -kv). Control and f stay in their ranges. control is the value at
    the start, or a function of time, which is recorded as those of dalembert.laws.

    Instead of a joint, an actuator may have a frame, a name as in Robot.FrameHT: a thruster with the force and torque
    wrench * f, six components in the axes of the frame. Its gain and bias have one number that is not zero.

    With dynamics, u is an activation: 'filter' is u_t = (control - u) / timeConstant, 'integrator' u_t = control, which
    stays in activationRange; activation is the value at the start.
    """

    name: str
    joint: str = ""
    gear: float = 1.0
    gain: Sequence[float] = (1.0, 0.0, 0.0)
    bias: Sequence[float] = (0.0, 0.0, 0.0)
    controlRange: Sequence[float] | None = None
    forceRange: Sequence[float] | None = None
    control: float | Callable[[Any], Any] = 0.0
    dynamics: str = "none"
    timeConstant: float = 1.0
    activationRange: Sequence[float] | None = None
    activation: float = 0.0
    frame: str = ""
    wrench: Sequence[float] = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)

    def __post_init__(self) -> None:
        where = f"RobotActuator '{self.name}'"
        if self.dynamics not in _DYNAMICS:
            raise shape_error(f"{where}: dynamics", f"one of {', '.join(_DYNAMICS)}", self.dynamics)
        if self.dynamics == "filter" and not self.timeConstant > 0:
            raise shape_error(f"{where}: timeConstant", "a positive number", self.timeConstant)
        for what in ("gain", "bias"):
            setattr(self, what, tuple(as_vector(f"{where}: {what}", getattr(self, what), 3).tolist()))
        if not any(self.gain) or not as_number(f"{where}: gear", self.gear):
            raise ValueError(f"{where}: expected a gear and a gain that are not zero, received {self.gear} {self.gain}")
        self.wrench = as_vector(f"{where}: wrench", self.wrench, 6).tolist()
        if bool(self.joint) == bool(self.frame):
            raise ValueError(f"{where}: expected a joint, a tendon or a frame, received {self.joint!r}, {self.frame!r}")
        if self.frame and (self.dynamics != "none" or any([*self.gain[1:], *self.bias[1:]])):
            raise ValueError(f"{where}: dynamics, and forces that depend on lengths, need a joint, not a frame")
        for what in ("controlRange", "forceRange", "activationRange"):
            given = getattr(self, what)
            if given is not None:
                lower, upper = as_vector(f"{where}: {what}", given, 2).tolist()
                if lower > upper:
                    raise shape_error(f"{where}: {what}", "[lower, upper] with lower <= upper", given)
                setattr(self, what, (lower, upper))

    def Force(self, u: Any, length: Any, rate: Any) -> Any:
        """Return f for a control or activation, the length of the transmission and its rate; arrays as well."""
        if self.dynamics == "none":
            u = clipped(u, self.controlRange)
        (g0, g1, g2), (b0, b1, b2) = self.gain, self.bias
        gain = g0 + g1 * length + g2 * rate if g1 or g2 else g0
        bias = b0 + b1 * length + b2 * rate if b1 or b2 else b0
        return clipped(gain * u + bias, self.forceRange)

    def ActivationRate(self, control: Any, u: Any) -> Any:
        """Return the rate of the activation."""
        control = clipped(control, self.controlRange)
        if self.dynamics == "filter":
            return (control - u) / self.timeConstant
        if self.activationRange is None:
            return control
        lower, upper = self.activationRange
        return dalembert.laws.maximum(
            dalembert.laws.minimum(control, (upper - u) / _STOP_TIME), (lower - u) / _STOP_TIME
        )


def clipped(value: Any, limits: Sequence[float] | None) -> Any:
    """Return a value in the limits, if there are any."""
    return value if limits is None else dalembert.laws.maximum(dalembert.laws.minimum(value, limits[1]), limits[0])


def law(
    actuator: RobotActuator, kind: str, motion: Callable[..., tuple[Any, Any]], result: Callable[[Any], Any]
) -> dalembert.laws.Law:
    """Return the law of an actuator as a connector of a kind.

    motion gives coordinate and rate of the joint from those of the connector; result gives what the law returns from
    the force in the joint.
    """
    given, has_state = actuator.control, actuator.dynamics != "none"

    def drive(*arguments: Any, **constants: Any) -> Any:
        *moved, t = arguments[:-1] if has_state else arguments
        control = constants["control"] if constants else given(t)  # type: ignore[operator]
        q, q_t = motion(*moved)
        u = arguments[-1] if has_state else control
        force = result(actuator.gear * actuator.Force(u, actuator.gear * q, actuator.gear * q_t))
        return (force, actuator.ActivationRate(control, u)) if has_state else force

    names = [*_ARGUMENTS[kind], "t", *(["activation"] if has_state else [])]
    parameters = [Parameter(name, Parameter.POSITIONAL_OR_KEYWORD) for name in names]
    if not callable(given):
        start = as_number(f"RobotActuator '{actuator.name}': control", given)
        parameters.append(Parameter("control", Parameter.POSITIONAL_OR_KEYWORD, default=start))
    vars(drive)["__signature__"] = Signature(parameters)
    return dalembert.laws.connector(kind, {"activation": actuator.activation} if has_state else None)(drive)


def add(mbs: Any, made: dalembert.laws.Law, markers: list[Any], **parameters: Any) -> Any:
    """Add an actuator between two markers."""
    if made.states:
        parameters["nodeNumbers"] = made.AddNodes(mbs)
    item = made(markers, **parameters)
    item.visualization.show = False
    return mbs.AddObject(item)


def add_to_tendon(robot: Robot, mbs: Any, node: Any, actuator: RobotActuator) -> Any:
    """Add an actuator on a tendon of a tree."""
    if actuator.dynamics != "none":
        raise ValueError(f"RobotActuator '{actuator.name}': actuators with dynamics need a joint, not a tendon")
    given = actuator.control
    constants = {} if callable(given) else {"control": as_number(f"RobotActuator '{actuator.name}': control", given)}

    def tension(length: Any, rate: Any, t: Any, control: Any = None) -> Any:
        return -actuator.Force(given(t) if callable(given) else control, length, rate)

    factors = actuator.gear * robot.tendons[actuator.joint].Factors(robot)
    return add_force(robot, mbs, node, factors, tension, constants)


def add_thruster(robot: Robot, mbs: Any, actuator: RobotActuator, marker: AddMarker) -> list[Any]:
    """Add the force and the torque of a thruster, as far as they are not zero."""
    given, (placed, A) = actuator.control, marker(*place_of(robot, actuator.frame))
    loads = []
    for kind, part in (("force", actuator.wrench[:3]), ("torque", actuator.wrench[3:])):
        direction = A @ part
        if not direction.any():
            continue

        def wrench(t: Any, direction: FloatArray = direction, **constants: Any) -> list[Any]:
            force = actuator.Force(constants["control"] if constants else given(t), 0.0, 0.0)  # type: ignore[operator]
            return [component * force for component in direction]

        parameters = [Parameter("t", Parameter.POSITIONAL_OR_KEYWORD)]
        if not callable(given):
            start = as_number(f"RobotActuator '{actuator.name}': control", given)
            parameters.append(Parameter("control", Parameter.POSITIONAL_OR_KEYWORD, default=start))
        vars(wrench)["__signature__"] = Signature(parameters)
        loads.append(mbs.AddLoad(dalembert.laws.load(kind)(wrench)(placed, bodyFixed=True)))
    return loads


def control_parameters(mbs: Any, objects: dict[str, Any]) -> dict[str, str]:
    """Return the names of the parameters that are the controls of actuators; empty where it is a function of time."""
    found = {}
    for name, item in objects.items():
        if isinstance(item, list):
            reads = [load for load in item if "control" in mbs.GetLoad(load)["loadVectorUserFunction"]._Variables()]
            found[name] = "loadVectorUserFunction.control" if reads else ""
            continue
        functions = {row: value for row, value in mbs.GetObject(item).items() if row.endswith("UserFunction") and value}
        rows = [row for row, function in functions.items() if "control" in function._Variables()]
        found[name] = f"{rows[0]}.control" if rows else ""
    return found
