"""Vehicles with four mecanum wheels, whose rollers stand at an angle to the axle: kinematics, rollers, and models.

Seen from above, x forward and y to the left, wheels are numbered front left, front right, rear left, rear right.
Rollers are in O-configuration (wheeltype 0), X-configuration (1), or absent (2). Lengths in m, angles in rad.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable
from typing import Any

import numpy as np
import numpy.typing as npt

from dalembert import graphics
from dalembert import itemInterface as items
from dalembert._checks import FloatArray, as_array, as_transformation, shape_error
from dalembert._geometry.inertia import InertiaCuboid, InertiaCylinder
from dalembert._geometry.rotations import RotationMatrixX, RotationMatrixZ
from dalembert.robotics._parts import GraphicsList

_NEEDED_OF_PLATFORM = "Dimensions Mass InitialPose InitialOmega InitialVelocity COM Representation"
_NEEDED_OF_WHEELS = "Type Base Track Radius Width Mass Numbers ContactStiffness ContactDamping"
_NEEDED = [
    *(f"platform{name}" for name in _NEEDED_OF_PLATFORM.split()),
    *(f"wheel{name}" for name in _NEEDED_OF_WHEELS.split()),
    *("gravity", "friction", "frictionAngle", "viscousFrictionWheel", "proportionalZone"),
    *("serialRobotMountpoint", "debugOffset"),
]
_ROLLERS = 8
_SIDES = np.array([[1, 1], [1, -1], [-1, 1], [-1, -1]])  # positions of the wheels, in halves of base and track


# ---- kinematics ------------------------------------------------------------------------------------------------------


def _configuration(wheeltype: int) -> int:
    """Return 1 for O and -1 for X; ValueError for wheels without rollers, which cannot go sideways."""
    if wheeltype not in (0, 1):
        raise shape_error("wheeltype", "0 (O-configuration) or 1 (X-configuration)", wheeltype)
    return 1 - 2 * wheeltype


class MobileKinematics:
    """Velocities of the platform and of its wheels, of radius R; they are lx ahead of the center and ly to its side.

    flagAdjusted uses lcx and lcy, the position of the center of mass, which distributes the load among the wheels.
    """

    def __init__(
        self,
        R: float,
        lx: float,
        ly: float,
        flagAdjusted: bool = False,
        lcx: float = 0,
        lcy: float = 0,
        wheeltype: int = 0,
    ) -> None:
        c = _configuration(wheeltype)
        sideways, turning = np.array([-1, 1, 1, -1]), np.array([-1, 1, -1, 1])
        if flagAdjusted:
            share = ((ly + lcy * np.array([1, -1, 1, -1])) * lx + ly * lcx * np.array([1, 1, -1, -1])) / (4 * lx * ly)
            offset = np.array([lcx + lcy, lcy - lcx, lcy - lcx, lcx + lcy])
            columns = [np.ones(4), sideways * share, turning * (lx + ly) + offset]
        else:
            columns = [np.ones(4), c * sideways, turning * (lx + c * ly)]
        self.Jacobian = np.stack(columns, axis=1) / R
        self.JacobianPInv = np.linalg.pinv(self.Jacobian)

    def GetWheelVelocities(self, vDes: npt.ArrayLike) -> FloatArray:
        """Return angular velocities of the wheels (rad/s) for [vx, vy, omega] of the platform, or for rows of these."""
        return self._each("vDes", vDes, self.Jacobian)

    def GetCartesianVelocities(self, w: npt.ArrayLike) -> FloatArray:
        """Return [vx, vy, omega] of the platform for angular velocities of the wheels (rad/s), or for rows of these."""
        return self._each("w", w, self.JacobianPInv)

    @staticmethod
    def _each(name: str, values: npt.ArrayLike, matrix: Any) -> FloatArray:
        array, size = as_array(name, values), matrix.shape[1]
        if array.ndim == 2 and array.shape[1] != size and array.shape[0] == size:
            array = array.T
        if array.ndim not in (1, 2) or array.shape[-1] != size:
            raise shape_error(name, f"{size} numbers, or rows of {size}", values)
        return np.asarray(array @ matrix.T)


def MecanumXYphi2WheelVelocities(
    xVel: float, yVel: float, angVel: float, R: float, Lx: float, Ly: float, wheeltype: int
) -> FloatArray:
    """Return angular velocities of the wheels, with the distances Lx and Ly between wheels; prefer MobileKinematics.

    The first and the last wheel of the X-configuration turn opposite to those of MobileKinematics.
    """
    c = _configuration(wheeltype)
    arm = 0.5 * (Lx + c * Ly)
    forward = np.ones(4) if c == 1 else np.array([-1, 1, 1, -1])
    sideways = np.array([-1, 1, 1, -1]) if c == 1 else -np.ones(4)
    columns = [forward, sideways, arm * np.array([-1, 1, -1, 1])]
    return np.asarray(np.stack(columns, axis=1) @ [xVel, yVel, angVel] / R)


def MecanumWheelVelocity2XYphi(w: npt.ArrayLike, R: float, Lx: float, Ly: float, wheeltype: int) -> FloatArray:
    """Return [vx, vy, omega] of the platform, with the distances Lx and Ly between wheels; prefer MobileKinematics."""
    c = _configuration(wheeltype)
    arm = 0.5 * (Lx + c * Ly)
    rows = np.array([[1, 1, 1, 1], [-c, c, c, -c], np.array([-1, 1, -1, 1]) / arm])
    return np.asarray(R / 4 * rows @ as_array("MecanumWheelVelocity2XYphi: w", w))


# ---- rollers ---------------------------------------------------------------------------------------------------------


def GeneratrixRoll(u: npt.ArrayLike, param: dict[str, Any]) -> tuple[FloatArray, FloatArray]:
    """Return [x, y] of the curve whose rotation about x is the surface of a roller; u is between -pi/2 and pi/2.

    param has r, the radius of the wheel, delta, the angle of rollers to the axle, and dRoll, their distance from it.
    A. Gfrerrer, Geometry and kinematics of the Mecanum wheel, Computer Aided Geometric Design 25, 2008.
    """
    r, d, delta = param["r"], param["dRoll"], param["delta"]
    slope = np.tan(u)
    x = d * np.cos(delta) ** 2 / np.sin(delta) * slope + r * np.sin(delta) * np.sin(u)
    y = np.sqrt((np.cos(delta) * slope) ** 2 + 1) * (r * np.cos(u) - d)
    return np.asarray(x), np.asarray(y)


def _on_roller(u: FloatArray, param: dict[str, Any], curve: Callable[..., Any]) -> tuple[FloatArray, FloatArray]:
    """Return the points of a curve along a roller of the length lRoll, with one beyond each end if there is one."""
    x, y = curve(u, param)
    inside = np.flatnonzero(np.abs(x) < 0.5 * param["lRoll"])
    part = slice(max(inside[0] - 1, 0), inside[-1] + 2)
    return x[part], y[part]


def Generatrix2Polynomial(
    param: dict[str, Any],
    GeneratrixFunction: Callable[..., Any],
    tol: float = 1e-14,
    nFit: int = 101,
    nTest: int = 1001,
) -> None:
    """Put the polynomial y(x) of a roller's curve into param: aPoly, highest power first.

    Its degree is even, the smallest whose error is below tol at nTest points, at most 18; with a warning that of the
    smallest error. aPoly0 is the parabola; xBoundary are the ends, dyBoundary the negative slopes there.
    """
    x, y = _on_roller(np.linspace(-np.pi / 4, np.pi / 4, nFit), param, GeneratrixFunction)
    x_test, y_test = _on_roller(np.linspace(-np.pi / 4, np.pi / 4, nTest), param, GeneratrixFunction)
    scale = np.abs(x).max()  # powers of x / scale are well conditioned
    fits, errors = [], []
    for degree in range(0, 20, 2):
        fits.append(np.polyfit(x / scale, y, degree) / scale ** np.arange(degree, -1, -1))
        errors.append(float(np.abs(y_test - np.polyval(fits[-1], x_test)).max()))
        if errors[-1] < tol:
            break
    best = int(np.argmin(errors))
    if errors[best] > tol:
        warnings.warn(f"Generatrix2Polynomial: the error {errors[best]:.2g} m is above tol={tol:g}", stacklevel=2)
    param["aPoly"] = fits[best]
    param["aPoly0"] = fits[min(1, len(fits) - 1)]
    if np.max(FunDDiffPoly(x_test, param["aPoly"])) >= 0:
        warnings.warn("Generatrix2Polynomial: the roller is not convex everywhere", stacklevel=2)
    ends = np.array([-0.5, 0.5]) * param["lRoll"]
    param["xBoundary"] = ends.tolist()
    param["dyBoundary"] = [-float(FunDiffPoly(end, param["aPoly"])) for end in ends]


def FunDiffPoly(x: npt.ArrayLike, a: npt.ArrayLike) -> FloatArray:
    """Return the derivative of a polynomial with coefficients a, highest power first."""
    return np.asarray(np.polyval(np.polyder(as_array("FunDiffPoly: a", a)), as_array("FunDiffPoly: x", x)))


def FunDDiffPoly(x: npt.ArrayLike, a: npt.ArrayLike) -> FloatArray:
    """Return the second derivative of a polynomial with coefficients a, highest power first."""
    return np.asarray(np.polyval(np.polyder(as_array("FunDDiffPoly: a", a), 2), as_array("FunDDiffPoly: x", x)))


# ---- models ----------------------------------------------------------------------------------------------------------


def _platform_graphics(robot: dict[str, Any]) -> GraphicsList:
    width, length, height = robot["platformDimensions"]
    colors = graphics.color.red, graphics.color.green, graphics.color.blue
    axes = np.diag([0.5, 0.5, 0.2])
    parts: list[Any] = [
        graphics.Cylinder([0, 0, 0], axis, 0.001, rgba) for axis, rgba in zip(axes, colors, strict=True)
    ]
    if robot["platformRepresentation"] == "stl":
        return [*parts, graphics.FromSTLfile(robot["platformStlFile"], color=[1, 1, 1, 1])]
    size = [length, width - 1.1 * robot["wheelWidth"], height]
    return [*parts, graphics.Brick([0, 0, 0], size, [*graphics.color.steelblue[:3], 0.2])]


def _wheel_graphics(robot: dict[str, Any], frictionAngle: float, rollers: bool) -> GraphicsList:
    """Return hub and rollers, whose surface is exact or a cylinder."""
    r, width = robot["wheelRadius"], robot["wheelWidth"]
    parts = [graphics.Cylinder([-0.55 * width, 0, 0], [1.1 * width, 0, 0], 0.34 * r, graphics.color.lightred)]
    roller = {"r": r, "lRoll": width, "delta": np.pi / 4, "rRoll": 0.25 * r, "dRoll": 0.75 * r}
    if rollers:
        Generatrix2Polynomial(roller, GeneratrixRoll, tol=1e-8)
        x = np.linspace(-0.5 * width, 0.5 * width, 21)
        contour = [[x[0], 0], *zip(x, np.polyval(roller["aPoly"], x), strict=True), [x[-1], 0]]
    for angle in np.linspace(0, 2 * np.pi, _ROLLERS, endpoint=False):
        turn = RotationMatrixX(-angle)
        axle = turn @ RotationMatrixZ(frictionAngle) @ [0.5 * width, 0, 0]
        center = turn @ [0, 0, -roller["dRoll"]]
        if rollers:
            blue = [*graphics.color.blue[:3], 1]
            parts.append(graphics.SolidOfRevolution(center, axle, contour, blue, nTiles=16))
        else:
            grey = graphics.color.grey if angle < np.pi else graphics.color.darkgrey
            parts.append(graphics.Cylinder(center - axle, 2 * axle, roller["rRoll"], grey))
    return parts


def _friction_angle(robot: dict[str, Any], wheel: int) -> float:
    """Return the angle of the rollers that touch the ground; neighbours have opposite ones."""
    if robot["wheelType"] == 2:
        return 0.0
    return float(robot["frictionAngle"] * _configuration(robot["wheelType"]) * (-1 if wheel in (1, 2) else 1))


def _add_platform(mbs: Any, robot: dict[str, Any], pose: FloatArray, wheels: float) -> dict[str, Any]:
    width, length, height = robot["platformDimensions"]
    density = (robot["platformMass"] - wheels) / (length * width * height)
    inertia = InertiaCuboid(density, [length, width, height]).Translated(robot["platformCOM"])
    created: dict[str, Any] = mbs.CreateRigidBody(
        inertia=inertia,
        referencePosition=pose[:3, 3],
        referenceRotationMatrix=pose[:3, :3],
        initialAngularVelocity=robot["platformInitialOmega"],
        initialVelocity=robot["platformInitialVelocity"],
        gravity=robot["gravity"],
        graphicsDataList=_platform_graphics(robot),
        returnDict=True,
    )
    mbs.SetObjectParameter(created["bodyNumber"], "name", "Base")
    mbs.SetNodeParameter(created["nodeNumber"], "name", "BaseCenter")
    return created


def _add_rolling(mbs: Any, robot: dict[str, Any], markers: list[Any], wheel: int, height: float) -> Any:
    """Add the contact of a wheel with the ground, which may overlap at the start."""
    gap = min(height - robot["wheelRadius"], 0.0)
    node = mbs.AddNode(items.NodeGenericData(initialCoordinates=[0, 0, gap], numberOfDataCoordinates=3))
    return mbs.AddObject(
        items.ObjectConnectorRollingDiscPenalty(
            name=f"wheel{wheel}",
            markerNumbers=markers,
            nodeNumber=node,
            discRadius=robot["wheelRadius"],
            dryFriction=robot["friction"][:2],
            dryFrictionAngle=_friction_angle(robot, wheel),
            viscousFriction=robot["viscousFrictionWheel"],
            dryFrictionProportionalZone=robot["proportionalZone"],
            rollingFrictionViscous=robot["friction"][2],
            useLinearProportionalZone=robot["linearRegularization"],
            contactStiffness=robot["wheelContactStiffness"],
            contactDamping=robot["wheelContactDamping"],
            visualization=items.VObjectConnectorRollingDiscPenalty(show=False),
        )
    )


def _add_wheel(mbs: Any, robot: dict[str, Any], pose: FloatArray, platform: Any, wheel: int, rollers: bool) -> Any:
    """Add a wheel on its axle; return node, body, marker, marker of the axle, joint, and the height of its centre."""
    half = 0.5 * np.array([robot["wheelBase"], robot["wheelTrack"]])
    local = np.array([*_SIDES[wheel] * half, robot["wheelRadius"] + robot["debugOffset"] - pose[2, 3]])
    position = pose[:3, 3] + pose[:3, :3] @ local
    radius, width = robot["wheelRadius"], robot["wheelWidth"]
    density = robot["wheelMass"] / (width * radius**2 * np.pi)
    created = mbs.CreateRigidBody(
        referencePosition=position,
        referenceRotationMatrix=pose[:3, :3] @ RotationMatrixZ(-np.pi / 2),
        initialVelocity=robot["platformInitialVelocity"],
        inertia=InertiaCylinder(density, width, radius, axis=0),
        gravity=robot["gravity"],
        graphicsDataList=_wheel_graphics(robot, _friction_angle(robot, wheel), rollers),
        returnDict=True,
    )
    body = created["bodyNumber"]
    marker = mbs.AddMarker(items.MarkerBodyRigid(bodyNumber=body, localPosition=[0, 0, 0]))
    axle = mbs.AddMarker(items.MarkerBodyRigid(bodyNumber=platform, localPosition=local))
    joint = mbs.CreateRevoluteJoint(
        bodyNumbers=[platform, body],
        position=local,
        axis=[0, 1, 0],
        useGlobalFrame=False,
        axisRadius=0.05 * width,
        axisLength=1.2 * width,
    )
    return created["nodeNumber"], body, marker, axle, joint, position[2]


def MobileRobot2MBS(
    mbs: Any,
    mobileRobot: dict[str, Any],
    markerGround: Any,
    flagGraphicsRollers: bool = True,
    *args: Any,
    **kwargs: Any,
) -> dict[str, Any]:
    """Add a platform with four wheels that roll on the ground to a system; rollers act by the angle of friction.

    mobileRobot has gravity; of the platform: platformDimensions [width, length, height], platformMass with that of the
    wheels, platformInitialPose (4x4), platformInitialOmega, platformInitialVelocity, platformCOM,
    platformRepresentation 'box' or 'stl' with platformStlFile, serialRobotMountpoint (4x4); of the wheels:
    wheelNumbers, wheelType, wheelBase, wheelTrack, wheelRadius, wheelWidth, wheelMass, wheelContactStiffness,
    wheelContactDamping; friction [along the axis of rollers, across it, of rolling], frictionAngle,
    viscousFrictionWheel, proportionalZone, and perhaps linearRegularization; debugOffset is the height above the
    ground. It is kept as mbs.variables['mobileRobot'].

    Returns a dict of lists: nPlatformList, bPlatformList, mPlatformList (centre, bottom, mount point), oPlatformList;
    nWheelsList, bWheelsList, mWheelsList, oRollingDiscsList, mAxlesList, oAxlesList, mAxlesBodyRot0, mAxlesBodyRot1.
    """
    if absent := [name for name in _NEEDED if name not in mobileRobot]:
        raise ValueError(f"MobileRobot2MBS: mobileRobot: there is no {', '.join(map(repr, absent))}")
    mobileRobot.setdefault("linearRegularization", True)
    mbs.variables["mobileRobot"] = mobileRobot
    pose = as_transformation("MobileRobot2MBS: platformInitialPose", mobileRobot["platformInitialPose"]).copy()
    pose[2, 3] += mobileRobot["debugOffset"]
    number = mobileRobot["wheelNumbers"]
    platform = _add_platform(mbs, mobileRobot, pose, number * mobileRobot["wheelMass"])
    body = platform["bodyNumber"]
    places = {
        "mCenterPlatform": np.zeros(3),
        "mCenterBase": np.array([0, 0, -0.5 * mobileRobot["platformDimensions"][2]]),
        "mRobotArmMounting": as_transformation(
            "MobileRobot2MBS: serialRobotMountpoint", mobileRobot["serialRobotMountpoint"]
        )[:3, 3],
    }
    markers = [
        mbs.AddMarker(items.MarkerBodyRigid(name=name, bodyNumber=body, localPosition=place))
        for name, place in places.items()
    ]
    view = items.VObjectJointGeneric(axesRadius=0.05, axesLength=2.4, color=[0.5, 1.0, 0, 0.1])
    free = items.GenericJoint(markerNumbers=[markerGround, markers[1]], constrainedAxes=[0] * 6, visualization=view)
    wheels: list[tuple[Any, ...]] = []
    result: dict[str, Any] = {
        "nPlatformList": [platform["nodeNumber"]],
        "bPlatformList": [body],
        "mPlatformList": markers,
        "oPlatformList": [mbs.AddObject(free)],
    }
    for wheel in range(number):
        *made, height = _add_wheel(mbs, mobileRobot, pose, body, wheel, flagGraphicsRollers)
        rolling = _add_rolling(mbs, mobileRobot, [markerGround, made[2]], wheel, height)
        wheels.append((*made, rolling, *mbs.GetObject(made[4])["markerNumbers"]))
    names = "nWheelsList bWheelsList mWheelsList mAxlesList oAxlesList oRollingDiscsList mAxlesBodyRot0 mAxlesBodyRot1"
    return result | {name: list(column) for name, column in zip(names.split(), zip(*wheels, strict=True), strict=True)}
