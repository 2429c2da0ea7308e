"""Bodies with a floating frame against rods, beams and rotors, whose motion is known."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import scipy.linalg
import scipy.sparse
from solving import Variable, new_system

import dalembert as exu
from dalembert import FEM

sys.path.insert(0, str(Path(__file__).parent.parent / "fem"))
import meshes

from dalembert._fem.elements import KINDS, hexahedron_rule


def bar(elements: int, length: float, young: float, density: float) -> Any:
    """A rod along the first axis, with its center at the origin; it stretches as a rod without lateral contraction."""
    width = 0.1 * length
    material = FEM.KirchhoffMaterial(young, 0.0, density)
    return meshes.solid(
        "Hex8", (elements, 1, 1), (length, width, width), material, (-length / 2, -width / 2, -width / 2)
    )


def stretch(mbs: Any, body: Any, fem: Any, length: float, speed: float) -> float:
    """Displacement of the end in the steady state about the third axis."""
    mbs.Assemble()
    mbs.ComputeVibrationModes(1, [0, 0, speed], updateInitialValues=True)
    ends = (fem.GetNodesInPlane([x, 0, 0], [1, 0, 0]) for x in (-length / 2, length / 2))
    first, last = (
        np.mean(
            [
                mbs.GetObjectOutputSuperElement(body, Variable.DisplacementLocal, n, exu.ConfigurationType.Initial)
                for n in nodes
            ],
            axis=0,
        )
        for nodes in ends
    )
    return (last[0] - first[0]) / 2


@pytest.mark.parametrize(("young", "density", "length", "speed"), [(2.1e11, 7850, 2.0, 100.0), (1e8, 1000, 1.0, 50.0)])
def test_spinning_rod(young: float, density: float, length: float, speed: float) -> None:
    """tan(a L/2)/a - L/2 with a^2 = rho w^2 / E, as the load acts where the rod has moved to; it would be rho w^2 L^3 /
    (24 E) at its reference, 1.5e-4 and 2.5e-3 less. Errors fall with the square of the element length."""
    a = speed * np.sqrt(density / young)
    exact = np.tan(a * length / 2) / a - length / 2
    found = []
    for elements in (4, 8):
        fem, mbs = bar(elements, length, young, density), new_system()
        body = FEM.ObjectFFRFinterface(fem).AddObjectFFRF(
            exu, mbs, positionRef=[0, 0, 0], eulerParametersRef=[1, 0, 0, 0], initialVelocity=[0, 0, 0],
            initialAngularVelocity=[0, 0, 0], gravity=[0, 0, 0],
        )  # fmt: skip
        found.append(stretch(mbs, body["oFFRF"], fem, length, speed))
    errors = np.array(found) - exact
    assert np.log2(errors[0] / errors[1]) == pytest.approx(2, abs=0.1)
    assert (4 * found[1] - found[0]) / 3 == pytest.approx(exact, rel=2e-6)


# lambda = omega sqrt(rho A L^4 / E I) of a beam whose ends are interfaces, with so many modes of the clamped beam in addition:
# two of the free, the clamped and the supported beam each; Craig-Bampton bases with exact modes of the beam, eight digits.
INTERFACES = {
    0: ((26.83281573, 91.65151390), (3.53273154, 34.80689311), (10.95445115, 50.19960159)),
    1: ((22.45383666, 91.65151390), (3.51723541, 22.12648131), (9.87034088, 50.19960159)),
    4: ((22.38247200, 61.72950991), (3.51603429, 22.03757784), (9.86962545, 39.47990362)),
    8: ((22.37386611, 61.67874771), (3.51601638, 22.03471143), (9.86960472, 39.47845565)),
}


def beam_matrices(elements: int) -> Any:
    """A mesh whose nodes have stretch, deflection and slope for coordinates: cubic beams, which do not stretch in the frequencies
    that are looked at."""
    h, n = 1 / elements, 3 * (elements + 1)
    bending = np.array([[12, 6 * h, -12, 6 * h], [6 * h, 4 * h**2, -6 * h, 2 * h**2]]) / h**3
    bending = np.vstack([bending, -bending[0], [6 / h**2, 2 / h, -6 / h**2, 4 / h]])
    inertia = np.array([[156, 22 * h, 54, -13 * h], [22 * h, 4 * h**2, 13 * h, -3 * h**2]])
    inertia = np.vstack([inertia, inertia[0, [2, 3, 0, 1]] * [1, -1, 1, -1], [-13 * h, -3 * h**2, -22 * h, 4 * h**2]])
    stiffness, mass = np.zeros((2, n, n))
    for e in range(elements):
        deflections, stretches = np.ix_(*2 * [3 * e + np.array([1, 2, 4, 5])]), np.ix_(*2 * [3 * e + np.array([0, 3])])
        stiffness[deflections] += bending
        mass[deflections] += inertia * h / 420
        stiffness[stretches] += 1e6 / h * np.array([[1, -1], [-1, 1]])
        mass[stretches] += h / 6 * np.array([[2, 1], [1, 2]])
    fem = FEM.FEMinterface()
    fem.nodes = {"Position": np.outer(np.linspace(0, 1, elements + 1), [1, 0, 0])}
    fem.massMatrix, fem.stiffnessMatrix = scipy.sparse.csr_matrix(mass), scipy.sparse.csr_matrix(stiffness)
    return fem


@pytest.mark.parametrize("modes", list(INTERFACES))
def test_interface_modes_of_a_beam(modes: int) -> None:
    """Cubic elements have errors of (lambda h^2)^2 / 720: 4e-8 for the eighth clamped mode, lambda = 299, of 64 elements; rounding
    of the stiffness, 64^4 times that of the mode looked at, leaves 1e-7."""
    elements = 64
    fem = beam_matrices(elements)
    fem.ComputeHurtyCraigBamptonModes(
        [[0], [elements]], modes, computationMode=FEM.HCBstaticModeSelection.allBoundaryNodes, excludeRigidBodyMotion=False
    )  # fmt: skip
    basis = fem.modeBasis["matrix"]
    ends = basis[[1, 2, 3 * elements + 1, 3 * elements + 2]]
    free, clamped, supported = ([], [0, 1], [0, 2])  # constrained coordinates of the ends
    for held, wanted in zip((free, clamped, supported), INTERFACES[modes], strict=True):
        kept = basis @ scipy.linalg.null_space(ends[held]) if held else basis
        reduced = (kept.T @ (matrix @ kept) for matrix in (fem.stiffnessMatrix, fem.massMatrix))
        squares = scipy.linalg.eigh(*reduced, eigvals_only=True)
        found = np.sqrt(squares[squares > 1][:2])
        assert found == pytest.approx(np.array(wanted), rel=2e-7)


BEARING, LENGTHWISE = 3e8, 1e8  # N/m


@pytest.fixture(scope="module")
def shaft() -> Any:
    """Short and thick, so that it is a gyroscope as well; its square section is as stiff in all directions across. Bearings hold the
    mean of its ends."""
    fem = meshes.solid("Hex8", (6, 2, 2), (1.0, 0.3, 0.3), meshes.STEEL, (-0.5, -0.15, -0.15))
    for name, x in (("left", -0.5), ("right", 0.5)):
        fem.AddBoundary(name, fem.GetNodesInPlane([x, 0, 0], [1, 0, 0]))
    return fem


def stress_stiffness(fem: Any, displacements: np.ndarray) -> np.ndarray:
    """Mean stresses of boxes of one size, from the displacements."""
    nodes, points = fem.elements[0]["Hex8"], fem.GetNodePositionsAsArray()
    half = np.ptp(points[nodes[0]], axis=0) / 2
    rule = hexahedron_rule(2)
    gradients = KINDS["Hex8"].gradients(rule.points) / half[:, None]
    young, nu = meshes.STEEL.youngsModulus, meshes.STEEL.poissonsRatio
    shear, bulk = young / (2 + 2 * nu), young * nu / ((1 + nu) * (1 - 2 * nu))
    matrix = np.zeros((len(displacements), len(displacements)))
    for element in nodes:
        strain = gradients @ displacements.reshape(-1, 3)[element]
        strain = (strain + strain.transpose(0, 2, 1)) / 2
        stress = 2 * shear * strain + bulk * np.trace(strain, axis1=1, axis2=2)[:, None, None] * np.eye(3)
        sums = np.einsum("p,pia,pij,pjb->ab", rule.weights * half.prod(), gradients, stress, gradients)
        rows = (3 * np.asarray(element)[:, None] + np.arange(3)).ravel()
        matrix[np.ix_(rows, rows)] += np.kron(sums, np.eye(3))
    return matrix


def whirl_of_the_mesh(fem: Any, speed: float) -> np.ndarray:
    """Frequencies of all coordinates of the mesh in the frame that rotates about the first axis, with the stresses of the rotation,
    without which a body that tilts would not even be rigid."""
    mass, stiffness = fem.massMatrix.toarray(), fem.stiffnessMatrix.toarray()
    for i, (nodes, weights) in enumerate(zip(*fem.GetBoundaryNodeSetsAsLists(), strict=True)):
        mean = np.zeros((3, len(mass)))
        for d in range(3):
            mean[d, 3 * np.asarray(nodes) + d] = weights
        stiffness += mean.T @ np.diag([0 if i else LENGTHWISE, BEARING, BEARING]) @ mean
    spin = np.kron(np.eye(len(mass) // 3), speed * np.array([[0, 0, 0], [0, 0, -1], [0, 1, 0]]))
    centrifugal = -mass @ spin @ spin
    stiffness += stress_stiffness(
        fem, np.linalg.lstsq(stiffness, centrifugal @ fem.GetNodePositionsAsArray().ravel())[0]
    )
    none, one = np.zeros_like(mass), np.eye(len(mass))
    first = np.block([[none, one], [-stiffness + centrifugal, -2 * mass @ spin]])
    values = scipy.linalg.eigvals(first, np.block([[one, none], [none, mass]]))
    return np.sort(values.imag[values.imag > 1.0])


def whirl_of_the_body(fem: Any, speed: float, modes: int) -> np.ndarray:
    mbs, (lists, weights) = new_system(), fem.GetBoundaryNodeSetsAsLists()
    fem.ComputeHurtyCraigBamptonModes(
        lists, modes, boundaryNodesWeights=weights, computationMode=FEM.HCBstaticModeSelection.RBE3
    )
    body = FEM.ObjectFFRFreducedOrderInterface(fem).AddObjectFFRFreducedOrder(mbs)["oFFRFreducedOrder"]
    for x, nodes, share in zip((-0.5, 0.5), lists, weights, strict=True):
        ends = [
            mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=mbs.CreateGround(referencePosition=[x, 0, 0]))),
            mbs.AddMarker(
                exu.MarkerSuperElementPosition(bodyNumber=body, meshNodeNumbers=nodes, weightingFactors=share)
            ),
        ]
        stiffness = [LENGTHWISE if x < 0 else 0, BEARING, BEARING]
        mbs.AddObject(exu.CartesianSpringDamper(markerNumbers=ends, stiffness=stiffness))
    mbs.Assemble()
    found = mbs.ComputeVibrationModes(8, [speed, 0, 0]).eigenvalues.imag
    return np.sort(found[found > 1.0])


@pytest.mark.parametrize("speed", [0.0, 600.0])
def test_whirl_of_a_rotor(shaft: Any, speed: float) -> None:
    """A body of interface modes on bearings against the rotating mesh itself. Errors with these modes are at most half
    the square of the ratio of frequencies."""
    wanted = whirl_of_the_mesh(shaft, speed)[:4]
    for modes in (2, 16):
        errors = whirl_of_the_body(shaft, speed, modes)[:4] / wanted - 1
        kept = 2 * np.pi * shaft.GetEigenFrequenciesHz()[-1]
        assert np.max(np.abs(errors)) < 0.5 * ((wanted[-1] + speed) / kept) ** 2
