"""Inverse kinematics by damped least squares, within the limits of the joints.

Steps of Levenberg and Marquardt, weighted by stiffnesses of the joints, make the error of position and rotation small:
C. W. Wampler, Manipulator inverse kinematic solutions based on vector formulations and damped least-squares methods,
IEEE Trans. Systems, Man, and Cybernetics 16, 1986. A robot with more joints than needed then moves within the null
space, until its joints are as near to the start as they can be: the state of least energy of springs in the joints.
A joint at a limit, which a step would leave, rests for that step.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from dalembert._checks import FloatArray, as_transformation, as_vector, shape_error
from dalembert._core import _reach_pose
from dalembert._geometry.rigid_transformation import HT, of_matrix
from dalembert._geometry.rotations import RotationMatrix2RotationVector, RotationVector2RotationMatrix
from dalembert._geometry.transformations import HomogeneousTransformation
from dalembert.robotics._denavit_hartenberg import projectAngleToPMPi
from dalembert.robotics._parts import is_revolute
from dalembert.robotics._robot import Robot

TOLERANCE = 1e-10  # m and rad
OTHER_STARTS = 20


class InverseKinematicsNumerical:
    """Finds coordinates of the joints of a robot for a pose of its tool, starting from those found before.

    jointStiffness, a number or one per joint, weights the motion of the joints. limits=True keeps them within the
    jointLimits of the links. link may name another link, or a frame, than the tool. flagDebug=True prints what happens;
    useRenderer and useAlternativeConstraints change nothing: there is no window, and no system.
    """

    def __init__(
        self,
        robot: Robot,
        jointStiffness: float | Sequence[float] = 1.0,
        useRenderer: bool = False,
        flagDebug: bool = False,
        useAlternativeConstraints: bool = False,
        limits: bool = False,
        link: str = "tool",
        maxIterations: int = 100,
    ) -> None:
        n = robot.NumberOfLinks()
        stiffness = np.broadcast_to(np.asarray(jointStiffness, dtype=float), (n,))
        if not (stiffness > 0).all():
            raise shape_error("InverseKinematicsNumerical: jointStiffness", "positive numbers", jointStiffness)
        self.robot, self.flagDebug, self.link, self.maxIterations = robot, flagDebug, link, maxIterations
        self._compliance = 1.0 / stiffness
        self._turning = np.array([is_revolute(link.jointType) for link in robot.links])
        bounds = [link.jointLimits if limits else None for link in robot.links]
        self._lower = np.array([-np.inf if b is None else b[0] for b in bounds])
        self._upper = np.array([np.inf if b is None else b[1] for b in bounds])
        self._carrier = robot.FrameLink(link)
        self.q = np.clip(robot.referenceConfiguration[:n], self._lower, self._upper)

    @staticmethod
    def createVector(p0: npt.ArrayLike, p01: npt.ArrayLike) -> tuple[list[float], ...]:
        """Return the x, y and z values of both ends of a line from p0 along p01, for plots."""
        start, way = (
            as_vector("InverseKinematicsNumerical.createVector: p0", p0, 3),
            as_vector("InverseKinematicsNumerical.createVector: p01", p01, 3),
        )
        return tuple([float(a), float(a + b)] for a, b in zip(start, way, strict=True))

    def GetCurrentRobotHT(self) -> Any:
        """Return the pose of the tool at the coordinates found last."""
        return self.robot.FrameHT(self.link, self.q)

    def InterpolateHTs(
        self, T1: npt.ArrayLike, T2: npt.ArrayLike, rotStep: float = np.pi / 16, minSteps: int = 1
    ) -> list[HT]:
        """Return poses on the way from T1 to T2, the last of them T2: straight, and turning about one axis.

        They are not more than rotStep (rad) apart, and not fewer than minSteps.
        """
        start, end = (
            as_transformation("InverseKinematicsNumerical.InterpolateHTs: T1", T1),
            as_transformation("InverseKinematicsNumerical.InterpolateHTs: T2", T2),
        )
        turn = RotationMatrix2RotationVector(start[:3, :3].T @ end[:3, :3])
        way = end[:3, 3] - start[:3, 3]
        n = max(minSteps, int(np.ceil(np.linalg.norm(turn) / rotStep)))
        between = [
            HomogeneousTransformation(start[:3, :3] @ RotationVector2RotationMatrix(s * turn), start[:3, 3] + s * way)
            for s in np.arange(1, n) / n
        ]
        return [of_matrix(pose) for pose in (*between, end)]

    def SolveSafe(self, T: npt.ArrayLike, q0: npt.ArrayLike | None = None) -> list[Any]:
        """Return [q, success] like Solve; if it fails, by small steps from the initial pose to T, and then
        from a fixed list of other initial values."""
        start = self._start(q0)
        q, success = self.Solve(T, start)
        for rotStep, minSteps in ((np.pi / 20, 8), (np.pi / 80, 64)):
            if success:
                break
            self._say("SolveSafe: in smaller steps")
            q = start
            for pose in self.InterpolateHTs(self.robot.FrameHT(self.link, start), T, rotStep, minSteps):
                q, success = self.Solve(pose, q)
                if not success:
                    break
        trials = np.random.default_rng(0).uniform(-1.0, 1.0, (OTHER_STARTS, len(start)))
        lower, upper = np.maximum(self._lower, start - np.pi), np.minimum(self._upper, start + np.pi)
        for trial in trials if not success else ():
            q, success = self.Solve(T, lower + 0.5 * (trial + 1.0) * (upper - lower))
            if success:
                break
        return [q, success]

    def Solve(self, T: npt.ArrayLike, q0: npt.ArrayLike | None = None) -> list[Any]:
        """Return [q, success], the coordinates of the joints for the pose T of the tool, in the global frame.

        The iteration starts with q0, or the coordinates found last. Angles are between -pi and pi unless limits of a
        joint are others. q is None if no coordinates within the limits were found to 1e-10 (m and rad).
        """
        goal, start = as_transformation("InverseKinematicsNumerical.Solve: T", T), self._start(q0)
        robot = self.robot
        q, error = _reach_pose(
            robot.links,
            robot.base.HT,
            robot.GetLinkIndex(self._carrier),
            robot._frameLocalHT(self.link),
            goal,
            start,
            self._compliance,
            self._lower,
            self._upper,
            self.maxIterations,
        )
        if error > TOLERANCE:
            self._say("Solve: pose not reached")
            return [None, False]
        if np.abs(q).max(initial=0.0) >= np.pi:
            projected = projectAngleToPMPi(q)
            within = self._turning & (projected >= self._lower) & (projected <= self._upper)
            q = np.where(within, projected, q)
        self.q = q
        return [q.copy(), True]

    def _start(self, q0: npt.ArrayLike | None) -> FloatArray:
        q = self.q if q0 is None else as_vector("InverseKinematicsNumerical: q0", q0, len(self.q))
        return np.minimum(np.maximum(q, self._lower), self._upper)

    def _say(self, text: str) -> None:
        if self.flagDebug:
            print(f"InverseKinematicsNumerical.{text}")
