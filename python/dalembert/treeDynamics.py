"""Mechanics of kinematic trees as functions of states: inverse and forward dynamics, mass matrix, Jacobians, energies.

States are arrays whose last axis has one number per joint. Any number of states is computed at once, several side by
side in the registers of the processor, and without Python's lock.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from dalembert import itemInterface as items
from dalembert._checks import FloatArray, as_vector, shape_error
from dalembert._core import SystemContainer, _TreeFunctions
from dalembert._solving.recognised_trees import RecogniseTrees as RecogniseTrees


def _assembled(tree: Any) -> tuple[Any, Any]:
    """Return a system with nothing but the tree, and its number there."""
    mbs = SystemContainer().AddSystem()
    given = tree.GetDictionary() if hasattr(tree, "GetDictionary") else dict(tree)
    given["nodeNumber"] = mbs.AddNode(items.NodeGenericODE2(numberOfODE2Coordinates=len(given["jointTypes"])))
    number = mbs.AddObject(given)
    mbs.Assemble()
    return mbs, number


class TreeDynamics:
    """Functions of the joint coordinates q, velocities v and accelerations a (or forces) of one kinematic tree.

    TreeDynamics(mbs, objectNumber) uses the tree of an assembled system, with its current parameters;
    TreeDynamics(ObjectKinematicTree(...)) needs no system. Coordinates are total ones: rad or m. Gravity is the only
    applied force; controllers, user functions, jointForceVector, linkForces and linkTorques are
    ignored. linkNumbers maps names to numbers of links: those of the tree, or of the robot (Robot.Dynamics).
    """

    def __init__(self, tree: Any, objectNumber: Any = None) -> None:
        mbs, number = _assembled(tree) if objectNumber is None else (tree, objectNumber)
        self._functions = _TreeFunctions(mbs, number)
        self.numberOfLinks: int = self._functions.links()
        self._masses, self._centers = (
            np.asarray(mbs.GetObjectParameter(number, name), dtype=float) for name in ("linkMasses", "linkCOMs")
        )
        self.linkNumbers: dict[str, int] = {
            name: i
            # if a link and another joint have the same name, the link is used
            for parameter in ("jointNames", "linkNames")
            for i, name in enumerate(mbs.GetObjectParameter(number, parameter))
            if name
        }

    def _array(self, name: str, values: npt.ArrayLike) -> FloatArray:
        expected = f"an array whose last axis has {self.numberOfLinks} numbers, one per joint"
        try:
            array = np.asarray(values, dtype=float)
        except (TypeError, ValueError):
            raise shape_error(f"TreeDynamics: {name}", expected, values) from None
        if array.ndim == 0 or array.shape[-1] != self.numberOfLinks:
            raise shape_error(f"TreeDynamics: {name}", expected, values)
        if not np.isfinite(array).all():
            raise shape_error(f"TreeDynamics: {name}", "finite numbers", values)
        return array

    def _states(self, **given: npt.ArrayLike) -> tuple[list[FloatArray], tuple[int, ...]]:
        """Return states as rows, broadcast against each other, and the shape that results begin with."""
        arrays = {name: self._array(name, values) for name, values in given.items()}
        shapes = {array.shape for array in arrays.values()}
        if len(shapes) == 1:
            return [array.reshape(-1, self.numberOfLinks) for array in arrays.values()], shapes.pop()[:-1]
        try:
            shape = np.broadcast_shapes(*shapes)
        except ValueError:
            received = ", ".join(f"{name} {array.shape}" for name, array in arrays.items())
            expected = "the same number of states in all, or one state"
            raise ValueError(f"TreeDynamics: expected {expected}; received the shapes {received}") from None
        rows = [np.broadcast_to(array, shape).reshape(-1, self.numberOfLinks) for array in arrays.values()]
        return rows, shape[:-1]

    def InverseDynamics(self, q: npt.ArrayLike, v: npt.ArrayLike, a: npt.ArrayLike) -> FloatArray:
        """Return the joint forces (Nm or N) that the accelerations need."""
        (q, v, a), shape = self._states(q=q, v=v, a=a)
        return self._functions.inverse_dynamics(q, v, a).reshape(*shape, self.numberOfLinks)

    def BiasForces(self, q: npt.ArrayLike, v: npt.ArrayLike) -> FloatArray:
        """Return the joint forces without accelerations: Coriolis and centrifugal forces, and minus the weight."""
        (q, v), shape = self._states(q=q, v=v)
        return self._functions.inverse_dynamics(q, v, None).reshape(*shape, self.numberOfLinks)

    def GravityForces(self, q: npt.ArrayLike) -> FloatArray:
        """Return the joint forces that hold the tree at rest against its weight."""
        return self.BiasForces(q, np.zeros(self.numberOfLinks))

    def ForwardDynamics(self, q: npt.ArrayLike, v: npt.ArrayLike, forces: npt.ArrayLike) -> FloatArray:
        """Return the accelerations (rad/s^2 or m/s^2) that joint forces cause."""
        (q, v, forces), shape = self._states(q=q, v=v, forces=forces)
        return self._functions.forward_dynamics(q, v, forces).reshape(*shape, self.numberOfLinks)

    def MassMatrix(self, q: npt.ArrayLike) -> FloatArray:
        """Return the mass matrix, n x n."""
        (q,), shape = self._states(q=q)
        return self._functions.mass_matrix(q).reshape(*shape, self.numberOfLinks, self.numberOfLinks)

    def MassMatrixDerivatives(self, q: npt.ArrayLike) -> FloatArray:
        """Return the derivatives of the mass matrix by q, n x n x n: the last axis counts the coordinate."""
        q = np.asarray(q, dtype=float)[..., None, :]  # accelerations of one joint after the other: the columns
        by_q = self._inertiaDerivatives(q, np.eye(self.numberOfLinks))
        return np.asarray(np.swapaxes(by_q, -3, -2))

    def _inertiaDerivatives(self, q: npt.ArrayLike, a: npt.ArrayLike) -> FloatArray:
        """Return the derivatives of M(q) a by q."""
        rest = np.zeros(self.numberOfLinks)
        with_a, without = (self.InverseDynamicsDerivatives(q, rest, given)[0] for given in (a, rest))
        return np.asarray(with_a - without)

    def InverseDynamicsDerivatives(
        self, q: npt.ArrayLike, v: npt.ArrayLike, a: npt.ArrayLike
    ) -> tuple[FloatArray, FloatArray]:
        """Return the derivatives of the joint forces with respect to q and v, n x n each; that for a is the mass
        matrix.

        If accelerations are not given, they are those of BiasForces.
        """
        (q, v, a), shape = self._states(q=q, v=v, a=a)
        by_q, by_v = self._functions.derivatives(q, v, a)
        n = self.numberOfLinks
        return by_q.reshape(*shape, n, n), by_v.reshape(*shape, n, n)

    def ForwardDynamicsDerivatives(
        self, q: npt.ArrayLike, v: npt.ArrayLike, forces: npt.ArrayLike
    ) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Return the derivatives of the accelerations by q, by v and by the joint forces, n x n each."""
        by_q, by_v = self.InverseDynamicsDerivatives(q, v, self.ForwardDynamics(q, v, forces))
        inverse = np.linalg.inv(np.broadcast_to(self.MassMatrix(q), by_q.shape))
        return -inverse @ by_q, -inverse @ by_v, inverse

    def LinkFrames(self, q: npt.ArrayLike) -> tuple[FloatArray, FloatArray]:
        """Return rotation matrices (n x 3 x 3) and origins (n x 3, in m) of the frames of all links."""
        (q,), shape = self._states(q=q)
        rotations, origins = self._functions.frames(q)
        n = self.numberOfLinks
        return rotations.reshape(*shape, n, 3, 3), origins.reshape(*shape, n, 3)

    def Jacobian(self, q: npt.ArrayLike, linkNumber: int | str, localPosition: npt.ArrayLike = [0, 0, 0]) -> FloatArray:
        """Return 6 x n: velocity of a point of a link, then angular velocity, by joint velocities; in global axes."""
        number = self.linkNumbers.get(linkNumber, -1) if isinstance(linkNumber, str) else linkNumber
        if not 0 <= number < self.numberOfLinks:
            names = f", or one of {', '.join(self.linkNumbers)}" if self.linkNumbers else ""
            expected = f"expected 0 to {self.numberOfLinks - 1}{names}"
            raise ValueError(f"TreeDynamics: linkNumber: received {linkNumber}; {expected}")
        (q,), shape = self._states(q=q)
        local = as_vector("TreeDynamics: localPosition", localPosition, 3)
        return self._functions.jacobian(q, number, local).reshape(*shape, 6, self.numberOfLinks)

    def JacobianDerivatives(
        self, q: npt.ArrayLike, linkNumber: int | str, localPosition: npt.ArrayLike = [0, 0, 0]
    ) -> FloatArray:
        """Return the derivatives of the Jacobian by q, 6 x n x n: the last axis counts the coordinate."""
        J = self.Jacobian(q, linkNumber, localPosition)
        velocity, spin = np.swapaxes(J[..., :3, :], -1, -2), np.swapaxes(J[..., 3:, :], -1, -2)
        # A joint rotates all columns of joints behind it, and itself; it moves the point if it is behind.
        turned = [np.cross(spin[..., None, :, :], of[..., :, None, :]) for of in (velocity, spin)]
        moved = np.cross(spin[..., :, None, :], velocity[..., None, :, :])
        behind = np.triu(np.ones((self.numberOfLinks, self.numberOfLinks)), 1)[:, :, None]
        rows = [turned[0] * (1 - behind) + moved * behind, turned[1] * (1 - behind)]
        return np.concatenate([np.moveaxis(part, -1, -3) for part in rows], axis=-3)

    def CenterOfMass(self, q: npt.ArrayLike) -> FloatArray:
        """Return the centre of mass of all links (m), in the global frame."""
        (q,), shape = self._states(q=q)
        return self._functions.centre_of_mass(q).reshape(*shape, 3)

    def CenterOfMassJacobian(self, q: npt.ArrayLike) -> FloatArray:
        """Return the derivatives of the centre of mass by q, 3 x n: its velocity by joint velocities."""
        weighted = (
            mass * self.Jacobian(q, i, self._centers[i])[..., :3, :] for i, mass in enumerate(self._masses) if mass
        )
        return np.asarray(sum(weighted) / self._masses.sum())

    def KineticEnergy(self, q: npt.ArrayLike, v: npt.ArrayLike) -> FloatArray:
        """Return the kinetic energy (J)."""
        (q, v), shape = self._states(q=q, v=v)
        return self._functions.kinetic_energy(q, v).reshape(shape)

    def KineticEnergyDerivatives(self, q: npt.ArrayLike, v: npt.ArrayLike) -> tuple[FloatArray, FloatArray]:
        """Return the derivatives of the kinetic energy by q, and by v, which are the momenta of the joints."""
        momenta = self.InverseDynamics(q, np.zeros(self.numberOfLinks), v) - self.GravityForces(q)
        by_q = 0.5 * np.einsum("...i,...ij->...j", np.asarray(v, dtype=float), self._inertiaDerivatives(q, v))
        return by_q, momenta

    def PotentialEnergy(self, q: npt.ArrayLike) -> FloatArray:
        """Return the potential energy of the weight (J); zero where the centre of mass is in the global origin.

        Its derivatives by q are GravityForces.
        """
        (q,), shape = self._states(q=q)
        return self._functions.potential_energy(q).reshape(shape)
