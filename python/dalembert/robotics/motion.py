"""Trajectories of coordinates, such as those of the joints of a robot, made of profiles that follow each other.

A profile says where coordinates are to go; Trajectory.Add finds from it, and from where the profile before has ended, a
motion: pieces of polynomials with coordinates, velocities and accelerations at any time. Units are those of the
coordinates (m or rad) and s.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any, Protocol

import numpy as np
import numpy.typing as npt

from dalembert._checks import FloatArray, as_vector, shape_error


def _positive(where: str, values: npt.ArrayLike) -> FloatArray:
    """Return limits as vector, which may be empty; ValueError unless all are positive."""
    limits = as_vector(where, values)
    if not (limits > 0).all():
        raise shape_error(where, "positive numbers", values)
    return limits


def _smallest(where: str, n: int, *limits: npt.ArrayLike) -> FloatArray | None:
    """Return the smallest of the given limits; None if there are none."""
    given = [limit for limit in (_positive(where, values) for values in limits) if limit.size]
    for limit in given:
        if limit.size != n:
            raise shape_error(where, f"{n} numbers, one per coordinate", limit)
    return np.min(given, axis=0) if given else None


class Motion(Protocol):
    """Interface of a part of a trajectory."""

    finalTime: float

    def GetInitialCoordinates(self) -> FloatArray: ...
    def GetFinalCoordinates(self) -> FloatArray: ...
    def Evaluate(self, time: float) -> list[FloatArray]: ...
    def EvaluateCoordinate(self, time: float, coordinate: int) -> list[float]: ...
    def GetBreaks(self) -> list[float]: ...


class Profile(Protocol):
    """Interface of the argument of Trajectory.Add."""

    def GetBasicProfile(
        self,
        initialTime: float,
        initialCoordinates: npt.ArrayLike,
        globalMaxVelocities: npt.ArrayLike,
        globalMaxAccelerations: npt.ArrayLike,
    ) -> Motion: ...


class _Inspectable:
    """Gives attributes by name, as a dictionary would."""

    def __iter__(self) -> Iterator[tuple[str, Any]]:
        return iter(vars(self).items())

    def __getitem__(self, key: str) -> Any:
        return vars(self)[key]

    def __repr__(self) -> str:
        return str(vars(self))


class BasicProfile(_Inspectable):
    """A motion from rest to rest: constant acceleration, constant velocity, constant deceleration, for each coordinate.

    coordinateSets are the coordinates at both ends. Accelerating and decelerating take accelerationTimes (s), at
    maxAccelerations, and lead to maxVelocities.
    """

    def __init__(
        self,
        coordinateSets: Sequence[npt.ArrayLike],
        initialTime: float,
        finalTime: float,
        accelerationTimes: npt.ArrayLike,
        maxVelocities: npt.ArrayLike,
        maxAccelerations: npt.ArrayLike,
    ) -> None:
        self.initialTime = initialTime
        self.finalTime = finalTime
        self.accelerationTimes = as_vector("BasicProfile: accelerationTimes", accelerationTimes)
        self.maxVelocities = as_vector("BasicProfile: maxVelocities", maxVelocities)
        self.maxAccelerations = as_vector("BasicProfile: maxAccelerations", maxAccelerations)
        self.coordinateSets = [as_vector("BasicProfile: coordinateSets", values).copy() for values in coordinateSets]
        self.distances = self.coordinateSets[1] - self.coordinateSets[0]

    def GetInitialCoordinates(self) -> FloatArray:
        """Return the coordinates at the start."""
        return self.coordinateSets[0]

    def GetFinalCoordinates(self) -> FloatArray:
        """Return the coordinates at the end."""
        return self.coordinateSets[-1]

    def GetBreaks(self) -> list[float]:
        """Return the times (s) between which each coordinate is one polynomial of at most third order."""
        ramps = self.accelerationTimes
        return [self.initialTime, *(self.initialTime + ramps), *(self.finalTime - ramps), self.finalTime]

    def Evaluate(self, time: float) -> list[FloatArray]:
        """Return coordinates, velocities and accelerations; the robot rests before the start and after the end."""
        values = np.array([self.EvaluateCoordinate(time, i) for i in range(len(self.distances))]).reshape(-1, 3)
        return list(values.T.copy())

    def EvaluateCoordinate(self, time: float, coordinate: int) -> list[float]:
        """Return the value of a coordinate, its velocity and acceleration."""
        t, duration = time - self.initialTime, self.finalTime - self.initialTime
        sign = float(np.sign(self.distances[coordinate]))
        ramp = float(self.accelerationTimes[coordinate])
        v, a = sign * float(self.maxVelocities[coordinate]), sign * float(self.maxAccelerations[coordinate])
        start, end = (float(values[coordinate]) for values in self.coordinateSets)
        left = duration - t
        if t < 0:
            return [start, 0.0, 0.0]
        if left < 0:
            return [end, 0.0, 0.0]
        if t < ramp:
            return [start + 0.5 * a * t * t, a * t, a]
        if left > ramp:
            return [start + 0.5 * a * ramp * ramp + v * (t - ramp), v, 0.0]
        return [end - 0.5 * a * left * left, a * left, -a]


class BasicProfileLinearAcceleration(_Inspectable):
    """A motion with accelerations that are linear in time between the points of a list, starting with no velocity."""

    def __init__(
        self,
        initialCoordinates: npt.ArrayLike,
        initialTime: float,
        accelerationList: Sequence[tuple[float, npt.ArrayLike]],
    ) -> None:
        self.initialTime = initialTime
        self.accelerationList = accelerationList
        start = as_vector("BasicProfileLinearAcceleration: initialCoordinates", initialCoordinates)
        self.coordinateSets = [start.copy()]
        self.coordinateSets_t = [np.zeros_like(self.coordinateSets[0])]
        self.Initialize()

    def Initialize(self) -> None:
        """Find coordinates and velocities at the points of the list."""
        where = "ProfileLinearAccelerationsList: accelerationList"
        n = len(self.coordinateSets[0])
        if len(self.accelerationList) < 2:
            raise shape_error(where, "at least two pairs of time and accelerations", self.accelerationList)
        times = np.array([time for time, _ in self.accelerationList], dtype=float)
        if times[0] != 0.0 or (np.diff(times) < 0).any():
            raise shape_error(where, "times that start with zero and do not decrease", times.tolist())
        self._times = times
        self._accelerations = np.array([as_vector(where, values, n) for _, values in self.accelerationList])
        self.coordinateSets, self.coordinateSets_t = self.coordinateSets[:1], self.coordinateSets_t[:1]
        for i, duration in enumerate(np.diff(times)):
            s, v, _ = self._within(i, duration)
            self.coordinateSets.append(s)
            self.coordinateSets_t.append(v)
        self.finalTime = self.initialTime + float(times[-1])
        self.distances = self.coordinateSets[-1] - self.coordinateSets[0]

    def _within(self, i: int, t: float) -> list[FloatArray]:
        """Return coordinates, velocities and accelerations at a time after point i."""
        a0, a1 = self._accelerations[i : i + 2]
        duration = self._times[i + 1] - self._times[i]
        jerk = (a1 - a0) / duration if duration > 0 else np.zeros_like(a0)  # a jump
        s0, v0 = self.coordinateSets[i], self.coordinateSets_t[i]
        return [
            s0 + t * (v0 + t * (a0 / 2 + t * jerk / 6)),
            v0 + t * (a0 + t * jerk / 2),
            a0 + t * jerk,
        ]

    def GetInitialCoordinates(self) -> FloatArray:
        """Return the coordinates at the start."""
        return self.coordinateSets[0]

    def GetFinalCoordinates(self) -> FloatArray:
        """Return the coordinates at the end."""
        return self.coordinateSets[-1]

    def GetBreaks(self) -> list[float]:
        """Return the times (s) between which each coordinate is one polynomial of at most third order."""
        return [self.initialTime + float(time) for time in self._times]

    def Evaluate(self, time: float) -> list[FloatArray]:
        """Return coordinates, velocities and accelerations; constant extrapolation before the start and after the
        end."""
        t = min(max(time - self.initialTime, 0.0), float(self._times[-1]))
        i = min(int(np.searchsorted(self._times, t, side="right")) - 1, len(self._times) - 2)
        return self._within(i, t - float(self._times[i]))

    def EvaluateCoordinate(self, time: float, coordinate: int) -> list[float]:
        """Return the value of a coordinate, its velocity and acceleration."""
        return [float(values[coordinate]) for values in self.Evaluate(time)]


class ProfileConstantAcceleration:
    """Goes to finalCoordinates in a duration (s): half of it accelerating, half decelerating; no limits count."""

    def __init__(self, finalCoordinates: npt.ArrayLike, duration: float) -> None:
        self.duration = float(_positive("ProfileConstantAcceleration: duration", [duration])[0])
        self.finalCoordinates = as_vector("ProfileConstantAcceleration: finalCoordinates", finalCoordinates).copy()

    def GetBasicProfile(
        self,
        initialTime: float,
        initialCoordinates: npt.ArrayLike,
        globalMaxVelocities: npt.ArrayLike,
        globalMaxAccelerations: npt.ArrayLike,
    ) -> BasicProfile:
        """Return the motion from given coordinates on."""
        start = as_vector("ProfileConstantAcceleration: coordinates", initialCoordinates, len(self.finalCoordinates))
        a = np.abs(4.0 * (self.finalCoordinates - start) / self.duration**2)
        half = 0.5 * self.duration
        ends = [start, self.finalCoordinates]
        return BasicProfile(ends, initialTime, initialTime + self.duration, np.full(len(a), half), a * half, a)


class ProfileLinearAccelerationsList:
    """Follows accelerations that are linear in time between the points of a list; no limits count.

    accelerationList has pairs of time (s, from the start of the profile, the first one zero) and accelerations; two
    pairs of one time are a jump.
    """

    def __init__(self, accelerationList: Sequence[tuple[float, npt.ArrayLike]]) -> None:
        size = np.size(accelerationList[0][1]) if accelerationList else 0
        BasicProfileLinearAcceleration(np.zeros(size), 0, accelerationList)  # checks the list
        self.accelerationList = accelerationList

    def GetBasicProfile(
        self,
        initialTime: float,
        initialCoordinates: npt.ArrayLike,
        globalMaxVelocities: npt.ArrayLike,
        globalMaxAccelerations: npt.ArrayLike,
    ) -> BasicProfileLinearAcceleration:
        """Return the motion from given coordinates on."""
        return BasicProfileLinearAcceleration(initialCoordinates, initialTime, self.accelerationList)


class ProfilePTP:
    """Goes from point to point, in the time of the slowest coordinate with its limits of velocity and acceleration.

    All coordinates start and arrive together, each with its full acceleration and a velocity that fits; with
    syncAccTimes=True they also accelerate, and decelerate, together. Limits hold for this profile, besides those of the
    trajectory; limits of acceleration there must be.
    """

    def __init__(
        self,
        finalCoordinates: npt.ArrayLike,
        syncAccTimes: bool = True,
        maxVelocities: npt.ArrayLike = [],
        maxAccelerations: npt.ArrayLike = [],
    ) -> None:
        self.finalCoordinates = as_vector("ProfilePTP: finalCoordinates", finalCoordinates).copy()
        self.syncAccTimes = syncAccTimes
        self.maxVelocities = _positive("ProfilePTP: maxVelocities", maxVelocities)
        self.maxAccelerations = _positive("ProfilePTP: maxAccelerations", maxAccelerations)

    def GetBasicProfile(
        self,
        initialTime: float,
        initialCoordinates: npt.ArrayLike,
        globalMaxVelocities: npt.ArrayLike,
        globalMaxAccelerations: npt.ArrayLike,
    ) -> BasicProfile:
        """Return the motion from given coordinates on."""
        n = len(self.finalCoordinates)
        start = as_vector("ProfilePTP: coordinates", initialCoordinates, n)
        v = _smallest("ProfilePTP: maxVelocities", n, globalMaxVelocities, self.maxVelocities)
        a = _smallest("ProfilePTP: maxAccelerations", n, globalMaxAccelerations, self.maxAccelerations)
        if a is None:
            raise ValueError("ProfilePTP: no limits of acceleration; give maxAccelerations here or to Trajectory")
        distance = np.abs(self.finalCoordinates - start)
        peak = np.sqrt(a * distance) if v is None else np.minimum(np.sqrt(a * distance), v)
        moved = distance > 0
        times = np.zeros(n)  # that each coordinate would need alone
        times[moved] = distance[moved] / peak[moved] + peak[moved] / a[moved]
        duration = float(times.max(initial=0.0))
        if self.syncAccTimes:
            peak, a, ramps = self._together(distance, peak, a)
            duration = float(ramps[0] + (distance[moved] / peak[moved])[0]) if moved.any() else 0.0
        else:
            # peak (duration - peak / a) = distance, the smaller root; rounding must not make it complex
            root = np.sqrt(np.maximum((a * duration) ** 2 - 4.0 * a * distance, 0.0))
            peak = np.minimum(2.0 * a * distance / np.maximum(a * duration + root, np.finfo(float).tiny), peak)
            ramps = peak / a
        return BasicProfile([start, self.finalCoordinates], initialTime, initialTime + duration, ramps, peak, a)

    @staticmethod
    def _together(distance: FloatArray, peak: FloatArray, a: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Return velocities, accelerations and times of acceleration of one motion along the straight line.

        The line is run through as one coordinate from 0 to 1, with the limits of velocity and acceleration that the
        distances leave to it.
        """
        moved = distance > 0
        if not moved.any():
            return np.zeros_like(a), a, np.zeros_like(a)
        acceleration = (a[moved] / distance[moved]).min()
        velocity = (peak[moved] / distance[moved]).min()
        return velocity * distance, acceleration * distance, np.full(len(a), velocity / acceleration)


class Trajectory:
    """A motion of coordinates, made of profiles; it rests before the first and after the last of them.

    maxVelocities and maxAccelerations are limits for those profiles that have limits.
    """

    def __init__(
        self,
        initialCoordinates: npt.ArrayLike,
        initialTime: float = 0,
        maxVelocities: npt.ArrayLike = [],
        maxAccelerations: npt.ArrayLike = [],
    ) -> None:
        self.initialTime = initialTime
        self.initialCoordinates = as_vector("Trajectory: initialCoordinates", initialCoordinates).copy()
        self.globalMaxVelocities = _positive("Trajectory: maxVelocities", maxVelocities)
        self.globalMaxAccelerations = _positive("Trajectory: maxAccelerations", maxAccelerations)
        self.profiles: list[Motion] = []
        self.timesList = [initialTime]

    def GetFinalCoordinates(self) -> FloatArray:
        """Return the coordinates at the end."""
        return self.profiles[-1].GetFinalCoordinates() if self.profiles else self.initialCoordinates

    def Add(self, profile: Profile) -> None:
        """Add a profile at the end."""
        if not hasattr(profile, "GetBasicProfile"):
            raise TypeError(
                f"Trajectory.Add: profile: expected a profile, such as ProfilePTP(...), received {profile!r}"
            )
        limits = self.globalMaxVelocities, self.globalMaxAccelerations
        motion = profile.GetBasicProfile(self.timesList[-1], self.GetFinalCoordinates(), *limits)
        if len(motion.GetFinalCoordinates()) != len(self.initialCoordinates):
            expected = f"{len(self.initialCoordinates)} coordinates, as the trajectory has"
            raise shape_error("Trajectory.Add: profile", expected, motion.GetFinalCoordinates())
        self.profiles.append(motion)
        self.Initialize()

    def GetTimes(self) -> list[float]:
        """Return the times at which profiles start and end."""
        return [self.initialTime, *(profile.finalTime for profile in self.profiles)]

    def GetBreaks(self) -> list[float]:
        """Return the times (s) between which each coordinate is one polynomial of at most third order, ascending."""
        return sorted({self.initialTime, *(time for profile in self.profiles for time in profile.GetBreaks())})

    def Initialize(self) -> None:
        """Take the times of the profiles over; Add does so."""
        self.timesList = self.GetTimes()

    def _at(self, t: float) -> int:
        """Return the index of the profile at a time; -1 before the first and after the last one."""
        i = int(np.searchsorted(self.timesList, t, side="left"))
        return i - 1 if 0 < i < len(self.timesList) else -1

    def _rest(self, t: float) -> FloatArray:
        return self.initialCoordinates if t <= self.initialTime else self.GetFinalCoordinates()

    def Evaluate(self, t: float) -> list[FloatArray]:
        """Return coordinates, velocities and accelerations at a time (s)."""
        if (i := self._at(t)) >= 0:
            return self.profiles[i].Evaluate(t)
        rest = self._rest(t)
        return [rest.copy(), np.zeros_like(rest), np.zeros_like(rest)]

    def EvaluateCoordinate(self, t: float, coordinate: int) -> list[float]:
        """Return the value of a coordinate, its velocity and acceleration at a time (s)."""
        if (i := self._at(t)) >= 0:
            return self.profiles[i].EvaluateCoordinate(t, coordinate)
        return [float(self._rest(t)[coordinate]), 0.0, 0.0]

    def __iter__(self) -> Iterator[Motion]:
        return iter(self.profiles)

    def __getitem__(self, key: int) -> Motion:
        return self.profiles[key]

    def __len__(self) -> int:
        return len(self.profiles)

    def __repr__(self) -> str:
        return str(self.profiles)
