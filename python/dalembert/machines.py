"""Machine elements: involute gears and ball bearings. Lengths in m, angles in rad unless named Deg."""

from __future__ import annotations

import warnings
from math import atan, atan2, cbrt, copysign, cos, hypot, pi, radians, sin, tan
from typing import Any

import numpy as np
import numpy.typing as npt

from dalembert._calls import checked
from dalembert._checks import FloatArray, as_number, as_vector, shape_error, unit_vector
from dalembert._geometry.rotations import ComputeOrthonormalBasis, ComputeOrthonormalBasisVectors, RotationMatrix2D

_SMALL = 0.02  # below this, the series of the involute is more accurate than tan(x) - x


@checked
def ApproxInvolute(x: float) -> float:
    """Return the series of tan(x) - x up to x^7, for small angles x."""
    return x**3 * (1.0 / 3.0 + x**2 * (2.0 / 15.0 + x**2 * (17.0 / 315.0)))


@checked
def Involute(x: float) -> float:
    """Return the involute function tan(x) - x of a pressure angle x, accurate also for small angles."""
    return ApproxInvolute(x) if abs(x) < _SMALL else tan(x) - x


@checked
def InvInvolute(y: float, warn: bool = True) -> float:
    """Return the angle x with tan(x) - x = y, by Newton's method.

    Raises ValueError if it does not converge in 10 steps; warn=False returns the last value instead.
    """
    x = atan(y + atan(y + copysign(1.0, y))) if abs(y) > 0.5 else cbrt(3 * y) - 0.4 * y
    for _ in range(10):
        if x == 0.0:
            return x
        step = (y - Involute(x)) / tan(x) ** 2
        x += step
        if abs(step) < 1e-13:
            return x
    if warn:
        raise ValueError(f"InvInvolute: no convergence for y={y}, the last value is {x}")
    return x


class InvoluteGear:
    """Outline of a spur gear with involute teeth, external or internal.

    The involute of the base circle runs between root and tip circle, given by module and the factors of addendum and
    dedendum; backlash is the circumferential play of two such gears at the pitch circle, fillet the radius at the root
    (external gears only); maxSteps points are tried along the involute, arcStepSize is the length of the steps at the
    root; points of the outline closer than tolerance are merged.
    """

    def __init__(
        self,
        module: float = 1,
        nTeeth: int = 12,
        pressureAngleDeg: float = 20,
        fillet: float = 0,
        backlash: float = 0,
        maxSteps: int = 100,
        arcStepSize: float = 0.1,
        reductionToleranceDeg: float = 0,
        dedendumFactor: float = 1.157,
        addendumFactor: float = 1.0,
        isInternalGear: bool = False,
        tolerance: float = 1e-6,
    ) -> None:
        for name, value in (
            ("pressureAngleDeg", pressureAngleDeg),
            ("fillet", fillet),
            ("backlash", backlash),
            ("reductionToleranceDeg", reductionToleranceDeg),
            ("dedendumFactor", dedendumFactor),
            ("addendumFactor", addendumFactor),
        ):
            as_number(f"InvoluteGear: {name}", value)
        for name, value in (("module", module), ("nTeeth", nTeeth)):
            if as_number(f"InvoluteGear: {name}", value) <= 0:
                raise shape_error(f"InvoluteGear: {name}", "a number greater than zero", value)
        self.module = module
        self.nTeeth = nTeeth
        self.pressureAngle = radians(pressureAngleDeg)
        self.reductionTolerance = radians(reductionToleranceDeg)
        self.isInternalGear = isInternalGear
        self.tolerance = tolerance
        self.maxSteps = maxSteps
        self.arcStepSize = arcStepSize

        above, below = (dedendumFactor, addendumFactor) if isInternalGear else (addendumFactor, dedendumFactor)
        self.addendum, self.dedendum = above * module, below * module
        self.pitchRadius = 0.5 * module * nTeeth
        self.baseRadius = self.pitchRadius * cos(self.pressureAngle)
        self.outerRadius = self.pitchRadius + self.addendum
        self.rootRadius = self.pitchRadius - self.dedendum
        self.filletRadius = 0 if isInternalGear else fillet

        self.angleToothAndGap = 2 * pi / nTeeth
        angularBacklash = backlash / (2 * self.pitchRadius)
        # teeth of an external gear, spaces of an internal one: their outlines are the same
        self.angleTooth = 0.5 * self.angleToothAndGap + (angularBacklash if isInternalGear else -angularBacklash)
        self.anglePitchIntersect: float | None = None
        self.angleFullTooth: float | None = None

    def MirrorMatrixV(self) -> npt.NDArray[np.int64]:
        """Return the 2x2 matrix that mirrors at the x axis."""
        return np.diag([1, -1])

    def RotationMatrix2D(self, angleRad: float) -> FloatArray:
        """Return the 2x2 rotation matrix of an angle in rad."""
        return RotationMatrix2D(angleRad)

    def PolarToCartesian(self, polarCoordinates: npt.ArrayLike) -> FloatArray:
        """Return [x, y] of polar coordinates [radius, angle]."""
        r, angle = as_vector("InvoluteGear.PolarToCartesian: polarCoordinates", polarCoordinates, 2)
        return np.array([r * cos(angle), r * sin(angle)])

    def CartesianToPolar(self, cartesianCoordinates: npt.ArrayLike) -> FloatArray:
        """Return polar coordinates [radius, angle] of [x, y]."""
        x, y = as_vector("InvoluteGear.CartesianToPolar: cartesianCoordinates", cartesianCoordinates, 2)
        return np.array([hypot(x, y), atan2(y, x)])

    def GenerateHalfTooth(self) -> FloatArray:
        """Return the flank from root to the middle of the tip as 2 x n matrix, starting at the polar angle 0.

        Raises ValueError if the involute does not reach pitch circle and middle of the tooth.
        """
        phi = np.linspace(0, pi, self.maxSteps)
        radius, theta = self.baseRadius * np.hypot(1.0, phi), phi - np.arctan(phi)
        beyondPitch = np.flatnonzero(radius >= self.pitchRadius)
        if len(beyondPitch):
            first = beyondPitch[0]
            self.anglePitchIntersect = Involute(self.pressureAngle)
            self.angleFullTooth = 2 * self.anglePitchIntersect + self.angleTooth
            beyondTooth = np.flatnonzero(theta[first + 1 :] >= 0.5 * self.angleFullTooth)
            if len(beyondTooth):
                n = first + 1 + beyondTooth[0]
                r = np.clip(radius[:n], self.rootRadius, self.outerRadius)
                return r * np.array([np.cos(theta[:n]), np.sin(theta[:n])])
        raise ValueError(
            "InvoluteGear: the involute does not reach the middle of the tooth; check module, nTeeth and backlash"
        )

    def _tooth_angle(self) -> float:
        if self.angleFullTooth is None:
            self.GenerateHalfTooth()
        assert self.angleFullTooth is not None
        return self.angleFullTooth

    def GenerateHalfRoot(self) -> FloatArray:
        """Return the root from the end of a tooth to the middle of the gap as 2 x n matrix, with its fillet."""
        tooth = self._tooth_angle()
        arcLength = (self.angleToothAndGap - tooth) * self.rootRadius
        theta = np.arange(tooth, 0.5 * (self.angleToothAndGap + tooth), self.arcStepSize / self.rootRadius)
        arc = (theta - tooth) * self.rootRadius
        intoFillet = np.maximum(self.filletRadius - np.minimum(arc, arcLength - arc), 0.0)
        depth = np.sqrt(np.maximum(self.filletRadius**2 - intoFillet**2, 0.0))
        r = self.rootRadius + self.filletRadius - depth
        return r * np.array([np.cos(theta), np.sin(theta)])

    def GenerateRoots(self) -> list[FloatArray]:
        """Return the roots before and after the tooth in the x direction, each as 2 x n matrix."""
        half = RotationMatrix2D(-0.5 * self._tooth_angle()) @ self.GenerateHalfRoot()
        return [(self.MirrorMatrixV() @ half)[:, ::-1], half]

    def GenerateTooth(self) -> FloatArray:
        """Return both flanks of the tooth in the x direction as 2 x n matrix."""
        half = self.GenerateHalfTooth()
        half = RotationMatrix2D(-0.5 * self._tooth_angle()) @ half
        return np.hstack([half, (self.MirrorMatrixV() @ half)[:, ::-1]])

    def GenerateToothAndGap(self) -> FloatArray:
        """Return the tooth in the x direction with half a gap on both sides as 2 x n matrix."""
        tooth = self.GenerateTooth()
        before, after = self.GenerateRoots()
        return np.hstack([before, tooth, after])

    def GenerateGear(self) -> FloatArray:
        """Return the counter-clockwise outline of the gear as n x 2 matrix, without points closer than tolerance."""
        pattern = self.GenerateToothAndGap()
        outline = np.hstack([RotationMatrix2D(self.angleToothAndGap * k) @ pattern for k in range(self.nTeeth)]).T
        kept, last = [], outline[0]
        for point in outline[1:]:
            if hypot(*(point - last)) >= self.tolerance:
                kept.append(point)
                last = point
        return np.array(kept)


def GetBallBearingData(
    axis: npt.ArrayLike,
    outsideDiameter: float,
    boreDiameter: float,
    width: float,
    nBalls: int,
    radiusBalls: float | None = None,
    ballsAngleOffset: float = 0,
    radiusCage: float | None = None,
    innerGrooveRadius: float | None = None,
    outerGrooveRadius: float | None = None,
    innerRingShoulderRadius: float | None = None,
    outerRingShoulderRadius: float | None = None,
    widthCage: float | None = None,
    heightCage: float | None = None,
    innerEdgeChamfer: float | None = None,
    outerEdgeChamfer: float | None = None,
) -> dict[str, Any]:
    """Return the dimensions of a ball bearing, with defaults for values of None, and the ball positions.

    Pass radiusBalls: the default, which is that of Exudyn, does not fit between bore and outside. Usual is
    0.145 (outsideDiameter - boreDiameter).

    ballPositions are in the frame of the bearing, turned by ballsAngleOffset about the axis, which is normalized; the
    grooves are parts of tori with innerGrooveTorusRadius and outerGrooveTorusRadius as larger radius.
    """
    if nBalls < 1:
        raise shape_error("GetBallBearingData: nBalls", "a positive number of balls", nBalls)
    e = unit_vector("GetBallBearingData: axis", axis)
    outer, inner = 0.5 * outsideDiameter, 0.5 * boreDiameter

    def default(value: float | None, proposal: float) -> float:
        return proposal if value is None else value

    rBall = default(radiusBalls, 0.58 * (outer - inner))
    rCage = default(radiusCage, 0.5 * (outer + inner))
    if not inner < rCage - rBall < rCage + rBall < outer:
        text = (
            f"GetBallBearingData: radiusBalls: balls of radius {rBall:.4g} m at radiusCage {rCage:.4g} m do not fit "
            f"between bore and outside, radii {inner:.4g} and {outer:.4g} m. The default is that of Exudyn; usual is "
            f"{0.29 * (outer - inner):.4g} m"
        )
        warnings.warn(text, stacklevel=2)
    innerGroove = default(innerGrooveRadius, 1.04 * rBall)
    outerGroove = default(outerGrooveRadius, 1.04 * rBall)
    innerShoulder = default(innerRingShoulderRadius, rCage - 0.3 * rBall)
    outerShoulder = default(outerRingShoulderRadius, rCage + 0.3 * rBall)
    phi = ballsAngleOffset + 2 * pi * np.arange(nBalls) / nBalls
    _, n1, n2 = ComputeOrthonormalBasisVectors(e)
    return {
        "axis": e,
        "outsideDiameter": outsideDiameter,
        "boreDiameter": boreDiameter,
        "width": width,
        "nBalls": nBalls,
        "radiusBalls": rBall,
        "radiusCage": rCage,
        "innerGrooveRadius": innerGroove,
        "outerGrooveRadius": outerGroove,
        "innerRingShoulderRadius": innerShoulder,
        "outerRingShoulderRadius": outerShoulder,
        "widthCage": default(widthCage, 2.5 * rBall),
        "heightCage": default(heightCage, 0.7 * (outerShoulder - innerShoulder)),
        "innerEdgeChamfer": default(innerEdgeChamfer, rBall / 8),
        "outerEdgeChamfer": default(outerEdgeChamfer, rBall / 8),
        "innerGrooveTorusRadius": rCage + innerGroove - rBall,
        "outerGrooveTorusRadius": rCage + rBall - outerGroove,
        "ballPositions": list(rCage * (np.outer(np.cos(phi), n1) + np.outer(np.sin(phi), n2))),
    }


def _add_ring_contacts(
    mbs: Any, bearingData: dict[str, Any], ball: Any, rings: list[Any], parameters: dict[str, Any]
) -> list[Any]:
    """Add the contacts of one ball with the inner and the outer ring; return both objects."""
    from dalembert import itemInterface as eii

    mBall = mbs.AddMarker(eii.MarkerBodyRigid(bodyNumber=ball))
    contacts = []
    for side, ring in zip(("inner", "outer"), rings, strict=True):
        node = mbs.AddNode(eii.NodeGenericData(initialCoordinates=[0, 0, 0, 0], numberOfDataCoordinates=4))
        contact = eii.ObjectContactSphereTorus(
            markerNumbers=[mBall, ring],
            nodeNumber=node,
            radiusSphere=bearingData["radiusBalls"],
            torusMajorRadius=bearingData[side + "GrooveTorusRadius"],
            torusMinorRadius=bearingData[side + "GrooveRadius"],
            torusAxis=bearingData["axis"],
            **parameters,
            visualization=eii.VObjectContactSphereTorus(show=False),
        )
        contacts.append(mbs.AddObject(contact))
    return contacts


def CreateBallBearing(
    mbs: Any,
    bearingData: dict[str, Any],
    markerInnerRing: Any,
    markerOuterRing: Any,
    densityBalls: float,
    densityCage: float,
    cageInitialAngularVelocity: npt.ArrayLike = [0, 0, 0],
    ballsInitialAngularVelocity: npt.ArrayLike = [0, 0, 0],
    gravity: npt.ArrayLike = [0, 0, 0],
    springStiffnessCage: float = 0,
    springDampingCage: float = 0,
    contactParametersRingBalls: dict[str, Any] = {
        "contactStiffness": 2000000.0,
        "contactDamping": 200.0,
        "dynamicFriction": 0.2,
        "contactStiffnessExponent": 1,
    },
    nTilesRings: int = 32,
    nTilesGrooves: int = 12,
    colorCage: npt.ArrayLike = [0.6, 0.57, 0.4, 0.4],
    colorInnerRing: npt.ArrayLike = [0.5, 0.5, 0.5, 1],
    colorOuterRing: npt.ArrayLike = [0.5, 0.5, 0.5, 1],
    nTilesBalls: int = 32,
    colorBalls: npt.ArrayLike = [0.6, 0.6, 0.65, 1],
    addBallsBasis: bool = False,
    ballsDrawRadiusFactor: float = 1,
) -> dict[str, Any]:
    """Add balls, cage, and sphere-torus contacts of a ball bearing between two rigid body markers.

    bearingData comes from GetBallBearingData, in the frame of the inner ring's marker; angular velocities (rad/s) and
    gravity (m/s^2) are in the global frame; springs between balls and cage are added if their stiffness or damping is
    not zero. Returns the new items: objectsBalls, objectCage, objectsCageBallContact, innerRingBallContacts,
    outerRingBallContacts.
    """
    import dalembert as exu
    from dalembert import graphics
    from dalembert.rigidBodyUtilities import InertiaCylinder, InertiaSphere

    reference = exu.ConfigurationType.Reference
    center = mbs.GetMarkerOutput(markerInnerRing, exu.OutputVariableType.Position, configuration=reference)
    A = mbs.GetMarkerOutput(markerInnerRing, exu.OutputVariableType.RotationMatrix, configuration=reference)
    center, A = np.asarray(center), np.asarray(A).reshape(3, 3)
    omegaCage = as_vector("CreateBallBearing: cageInitialAngularVelocity", cageInitialAngularVelocity, 3)
    radius, positions = bearingData["radiusBalls"], bearingData["ballPositions"]

    ballGraphics: list[Any] = [graphics.Sphere([0, 0, 0], radius * ballsDrawRadiusFactor, colorBalls, nTilesBalls)]
    if addBallsBasis:
        ballGraphics.append(graphics.Basis(length=1.3 * radius))
    balls = [
        mbs.CreateRigidBody(
            referencePosition=center + A @ position,
            initialVelocity=np.cross(omegaCage, A @ position),
            initialAngularVelocity=ballsInitialAngularVelocity,
            inertia=InertiaSphere(density=densityBalls, radius=radius),
            gravity=gravity,
            graphicsDataList=list(ballGraphics),
        )
        for position in positions
    ]
    mean, height = bearingData["radiusCage"], bearingData["heightCage"]
    rimOuter, rimInner = mean + 0.5 * height, mean - 0.5 * height
    inertia = InertiaCylinder(densityCage, bearingData["widthCage"], rimOuter, axis=0, innerRadius=rimInner)
    drawing = graphics.BallBearingRings(
        **bearingData, nTilesRings=2 * nTilesRings, nTilesGrooves=nTilesGrooves, colorCage=colorCage
    )
    cage = mbs.CreateRigidBody(
        referencePosition=center,
        referenceRotationMatrix=A,
        inertia=inertia.Rotated(ComputeOrthonormalBasis(bearingData["axis"])),
        initialAngularVelocity=omegaCage,
        gravity=gravity,
        graphicsDataList=[drawing["cageGraphics"]],
    )
    springs = []
    if springStiffnessCage != 0 or springDampingCage != 0:
        springs = [
            mbs.CreateCartesianSpringDamper(
                bodyNumbers=[ball, cage],
                localPosition0=[0, 0, 0],
                localPosition1=position,
                stiffness=[springStiffnessCage] * 3,
                damping=[springDampingCage] * 3,
                drawSize=0.2 * radius,
            )
            for ball, position in zip(balls, positions, strict=True)
        ]
    rings = [markerInnerRing, markerOuterRing]
    contacts = [_add_ring_contacts(mbs, bearingData, ball, rings, contactParametersRingBalls) for ball in balls]
    return {
        "objectsBalls": balls,
        "objectCage": cage,
        "objectsCageBallContact": springs,
        "innerRingBallContacts": [inner for inner, _ in contacts],
        "outerRingBallContacts": [outer for _, outer in contacts],
    }
