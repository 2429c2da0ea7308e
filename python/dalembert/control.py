"""Controllers that run without Python: PD, computed torque, user-defined laws in C, each continuous or sampled.

A controller takes the place of forceUserFunction of an ObjectKinematicTree or an ObjectGenericODE2, also in
CreateKinematicTree and CreateRobot. It gives one force per coordinate (N for coordinates in m, Nm for those in rad),
from total coordinates, which include the reference values. Implicit solvers differentiate continuous controllers like
other compiled user functions; outputs that are held between samples have no derivatives.

The desired motion of the coordinates is given by constant numbers, by a Trajectory of dalembert.robotics.motion (at
jumps
of accelerations, the later ones are used), or by a C function with the signature
compiled.numba_signature("Controller", "desired"): it receives the time, the number of coordinates, and three arrays to
write to, for coordinates, velocities and accelerations.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from dalembert import compiled
from dalembert._checks import FloatArray, as_array, as_number, as_vector, shape_error
from dalembert._core import _Controller, _DesiredMotion
from dalembert.robotics.motion import Trajectory

if TYPE_CHECKING:
    from dalembert.treeDynamics import TreeDynamics


class Controller(_Controller):
    """Base class of all controllers."""

    def Forces(self, t: float, q: npt.ArrayLike, q_t: npt.ArrayLike) -> FloatArray:
        """Return the forces of the law for a time (s), total coordinates and velocities: one per coordinate."""
        where = f"{type(self).__name__}.Forces"
        coordinates = as_vector(f"{where}: q", q, self._count or None)
        velocities = as_vector(f"{where}: q_t", q_t, len(coordinates))
        return np.array(self._forces(as_number(f"{where}: t", t), coordinates, velocities))

    def __call__(self, mbs: Any, t: float, itemNumber: int, q: npt.ArrayLike, q_t: npt.ArrayLike) -> FloatArray:
        """Same as Forces, with the arguments of a force user function."""
        return self.Forces(t, q, q_t)

    _count = 0  # of coordinates; 0: any


class PDController(Controller):
    """Law forces + stiffness * (q_d - q) + damping * (v_d - v), independently for each coordinate.

    desired: desired motion of the coordinates q, see the start of this page; n coordinates
    stiffness: Nm/rad or N/m, one number for all or n
    damping: Nm s/rad or Ns/m, one number for all or n
    forces: feed-forward (Nm or N), one number for all or n; for example the weight at the desired position
    raises ValueError for values of other shapes or that are not finite
    """

    def __init__(
        self,
        desired: Any,
        stiffness: npt.ArrayLike,
        damping: npt.ArrayLike,
        forces: npt.ArrayLike = 0.0,
    ) -> None:
        motion, n = _motion("PDController", desired, stiffness)
        super().__init__(
            motion,
            _per_coordinate("PDController: stiffness", stiffness, n),
            _per_coordinate("PDController: damping", damping, n),
            _per_coordinate("PDController: forces", forces, n),
        )
        self._count, self._desired = n, desired  # kept alive, because it may be a function


class ComputedTorque(Controller):
    """Inverse dynamics for the accelerations a_d + damping * (v_d - v) + stiffness * (q_d - q).

    If tree is the controlled tree, each error e follows e_tt + damping e_t + stiffness e = 0. Drives,
    friction and loads that tree does not contain are model errors, as in a machine.

    tree: TreeDynamics of the controlled tree, or of the controller's model of it; n coordinates
    desired: desired motion of the coordinates q, see the start of this page
    stiffness: 1/s^2, one number for all or n
    damping: 1/s, one number for all or n
    raises ValueError for values of other shapes or that are not finite

    J. Y. S. Luh, M. W. Walker, R. P. C. Paul, Resolved-acceleration control of mechanical manipulators, IEEE
    Transactions on Automatic Control 25, 1980.
    """

    def __init__(self, tree: TreeDynamics, desired: Any, stiffness: npt.ArrayLike, damping: npt.ArrayLike) -> None:
        n = tree.numberOfLinks
        motion, _ = _motion("ComputedTorque", desired, np.zeros(n))
        factors = _per_coordinate("ComputedTorque: stiffness", stiffness, n)
        super().__init__(motion, factors, _per_coordinate("ComputedTorque: damping", damping, n), tree._functions)
        self._count, self._desired = n, desired


class CompiledController(Controller):
    """A law of one's own: a C function with the signature of a forceUserFunction, by numba or another compiler.

    Its signature is compiled.numba_signature(exu.ObjectKinematicTree, "forceUserFunction"). Here, unlike in a
    forceUserFunction, coordinates include reference values; and the law may be sampled.

    law: callback of numba, function pointer of ctypes or scipy.LowLevelCallable
    raises TypeError if it is something else, or has another signature
    """

    def __init__(self, law: Any) -> None:
        super().__init__(
            _address("CompiledController: law", law, compiled.c_signature("ObjectKinematicTree", "forceUserFunction"))
        )
        self._law = law  # keeps it alive


class SampledController(Controller):
    """A controller that samples at equal intervals, and holds its output until the next sample.

    It measures at the start of a solution and then once per period. Its output acts deadTime later, which may be
    longer than a period; initially, forces are zero. Steps of dynamic solvers end at measurements and
    changes of forces, for any step size. Static solutions and SolveVariations are rejected. Each
    solution starts anew, except continued ones (simulationSettings.continuation): restart files contain pending
    outputs.

    law: PDController, ComputedTorque or CompiledController
    period: s, between measurements
    deadTime: s, between a measurement and its effect
    raises ValueError for other numbers, TypeError for something else as law
    """

    def __init__(self, law: Controller, period: float, deadTime: float = 0.0) -> None:
        if not isinstance(law, Controller) or isinstance(law, SampledController):
            expected = (
                "a controller, such as ComputedTorque(...) or CompiledController(...), that is not sampled itself"
            )
            raise TypeError(f"SampledController: law: expected {expected}, received {law!r}")
        interval = as_number("SampledController: period", period)
        if not interval > 0:
            raise shape_error("SampledController: period", "a positive number", period)
        super().__init__(law, interval, as_number("SampledController: deadTime", deadTime, negative=False))
        self._count = law._count
        self._law = law  # keeps it alive


def _per_coordinate(name: str, values: npt.ArrayLike, n: int) -> FloatArray:
    """Return n numbers, which may be given by one."""
    array = as_array(name, values)
    if array.ndim == 0:
        array = np.full(n, float(array))
    if array.shape != (n,) or not np.isfinite(array).all():
        raise shape_error(name, f"a finite number, or {n}, one per coordinate", values)
    return array


def _address(name: str, function: Any, signature: str) -> int:
    found = compiled._recognized(function)
    if found is None or found[1] != signature:
        got = f"received {function!r}" if found is None else f"that of this one is {found[1] or 'not known'}"
        raise TypeError(f"{name}: expected a C function with the signature {signature}; {got}")
    return found[0]


def _motion(name: str, desired: Any, gains: npt.ArrayLike) -> tuple[_DesiredMotion, int]:
    """Return the motion and the number of its coordinates."""
    if isinstance(desired, Trajectory):
        return _polynomials(desired), _checked(name, len(desired.initialCoordinates), gains)
    if compiled._recognized(desired) is not None:
        n = np.size(gains)
        if np.ndim(gains) != 1:
            raise shape_error(f"{name}: stiffness", "one number per coordinate, as desired is a function", gains)
        address = _address(f"{name}: desired", desired, compiled.c_signature("Controller", "desired"))
        return _DesiredMotion(n, address), n
    place = as_vector(f"{name}: desired", desired)
    if not np.isfinite(place).all():
        raise shape_error(f"{name}: desired", "finite numbers, a Trajectory or a C function", desired)
    rest = np.concatenate([place, np.zeros(2 * len(place))])
    return _DesiredMotion(len(place), [], [], [*rest, *rest]), _checked(name, len(place), gains)


def _checked(name: str, n: int, gains: npt.ArrayLike) -> int:
    if np.ndim(gains) == 1 and np.size(gains) != n:
        raise ValueError(f"{name}: desired has {n} coordinates; expected {np.size(gains)}")
    return n


def _polynomials(trajectory: Trajectory) -> _DesiredMotion:
    """Return a trajectory as it is now: cubic polynomials between its breaks, and rest before and after."""
    breaks = trajectory.GetBreaks()
    times = [breaks[0]] + [t for before, t in zip(breaks, breaks[1:], strict=False) if t - before > 1e-12]
    rows = []
    for start, end in zip(times, times[1:], strict=False):
        half = 0.5 * (end - start)
        s, v, a = trajectory.Evaluate(start + half)
        jerk = (trajectory.Evaluate(start + 1.5 * half)[2] - trajectory.Evaluate(start + 0.5 * half)[2]) / half
        back = -half
        rows.append(
            np.stack(
                [
                    s + back * (v + back * (a / 2 + back * jerk / 6)),
                    v + back * (a + back * jerk / 2),
                    (a + back * jerk) / 2,
                    jerk / 6,
                ],
                axis=1,
            )
        )
    rest = np.zeros(2 * len(trajectory.initialCoordinates))
    ends = [*trajectory.initialCoordinates, *rest, *trajectory.GetFinalCoordinates(), *rest]
    coefficients = np.array(rows).ravel() if rows else np.zeros(0)
    return _DesiredMotion(len(trajectory.initialCoordinates), times if rows else [], coefficients, ends)
