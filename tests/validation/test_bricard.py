"""IFToMM benchmark A04: the mechanism of Bricard, six revolute joints in a closed loop of which one equation is redundant."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from bricard_reference import AXES, CORNERS, GRAVITY, MASS, WIDTH, third_corners
from solving import Variable, new_system, orders, settings

from dalembert.rigidBodyUtilities import InertiaCuboid
from dalembert.solver import SolverError


class Bricard:
    """Rods between the corners; flags of the joints that are freed besides their axes make it regular."""

    def __init__(self, freed: dict[int, int]) -> None:
        self.mbs = new_system()
        ground = self.mbs.CreateGround()
        self.rods = [self.rod(*ends) for ends in zip(CORNERS[:-1], CORNERS[1:], strict=True)]
        bodies = [ground, *self.rods, ground]
        for i, (corner, axis) in enumerate(zip(CORNERS, AXES, strict=True)):
            flags = [1] * 6
            flags[3 + "xyz".index(axis)] = 0
            if i in freed:
                flags[freed[i]] = 0
            self.mbs.CreateGenericJoint(bodyNumbers=bodies[i : i + 2], position=corner, constrainedAxes=flags)
        self.mbs.Assemble()

    def rod(self, start: np.ndarray, end: np.ndarray) -> Any:
        size = np.where(start == end, WIDTH, 1.0)
        return self.mbs.CreateRigidBody(
            referencePosition=(start + end) / 2,
            inertia=InertiaCuboid(density=MASS / np.prod(size), sideLengths=size),
            gravity=[0, -GRAVITY, 0],
        )

    def third_corner(self) -> np.ndarray:
        return np.asarray(self.mbs.GetObjectOutputBody(self.rods[2], Variable.Position, [0, 0, 0.5]))

    def energy(self) -> float:
        """Relative to the start, where the rods are at rest at heights 0, -1/2, -1, -1, -1/2."""
        total = 3 * GRAVITY
        for rod in self.rods:
            place, velocity, omega = (
                self.mbs.GetObjectOutputBody(rod, v, [0, 0, 0])
                for v in (Variable.Position, Variable.Velocity, Variable.AngularVelocityLocal)
            )
            xx, yy, zz = self.mbs.GetObjectParameter(rod, "physicsInertia")[:3]
            total += velocity @ velocity / 2 + GRAVITY * place[1] + np.array([xx, yy, zz]) @ omega**2 / 2
        return float(total)


def final(freed: dict[int, int], end: float, steps: int) -> np.ndarray:
    bricard = Bricard(freed)
    bricard.mbs.SolveDynamic(settings(end, steps))
    return bricard.third_corner()


def test_one_equation_is_redundant() -> None:
    for freed, redundant in (({}, 1), ({5: 0}, 0)):
        counts = Bricard(freed).mbs.ComputeSystemDegreeOfFreedom()
        assert (counts["degreeOfFreedom"], counts["redundantConstraints"]) == (1, redundant)


@pytest.mark.parametrize("freed", [{5: 0}, {5: 4}, {0: 3}], ids=["translation", "rotation", "first joint"])
@pytest.mark.parametrize("end", third_corners())
def test_regular_without_one_equation(freed: dict[int, int], end: float) -> None:
    """The loop holds the freed direction as well. Second order: the error is 8e-7 at 0.5 s and 3.4e-6 at 1 s for h = 2
    ms."""
    wanted = third_corners()[end]
    assert 4e-7 < np.linalg.norm(final(freed, end, int(500 * end)) - wanted) < 7e-6


def test_second_order() -> None:
    """Down to errors of 1e-7, where the reference has ten digits."""
    wanted = third_corners()[1.0]
    for order in orders(lambda n: final({5: 0}, 1.0, n) - wanted, [125, 250, 500]):
        assert order == pytest.approx(2, abs=0.1)


def test_six_revolute_joints() -> None:
    """Redundant forces are not determined, motions are: the same as without the redundant equation, also by full pivoting."""
    bricard, s = Bricard({}), settings(1.0, 250)
    s.linearSolverSettings.ignoreSingularJacobian = True
    bricard.mbs.SolveDynamic(s)
    np.testing.assert_allclose(bricard.third_corner(), final({5: 0}, 1.0, 250), rtol=0, atol=1e-9)


def test_energy_of_ten_seconds() -> None:
    """Some 20 J go to and fro; the damping of the method is of third order, (omega h)^3 = 1e-6 at 5 rad/s, and smaller still here."""
    bricard = Bricard({5: 0})
    bricard.mbs.SolveDynamic(settings(10.0, 5000))
    assert 1e-12 < abs(bricard.energy()) < 1e-6


def test_a_singular_matrix_names_the_joints() -> None:
    """Whether a redundant equation leaves an exact zero is up to round-off; it is rejected with a threshold, and the
    text has the dependent equations, some of every joint, and advice."""
    bricard, s = Bricard({}), settings(1.0, 100)
    s.linearSolverSettings.pivotThreshold = 1e-10
    s.redundantConstraints.treat = False
    with pytest.raises(SolverError) as caught:
        bricard.mbs.SolveDynamic(s)
    text, _, dependent = caught.value.diagnosis.partition("equations that depend on each other:")
    assert "the system matrix is singular in step 1" in text
    assert dependent.count("(ObjectJointGeneric)") == len(AXES) and "NodeRigidBody" not in dependent
    assert "redundantConstraints.treat=True" in dependent
