"""ObjectANCFThinPlate against closed forms of plates and beams."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.linalg import eigh
from scipy.spatial.transform import Rotation

import dalembert as exu
from dalembert._core import testing

Variable = exu.OutputVariableType
TURN = Rotation.from_rotvec([0.4, -1.1, 0.7]).as_matrix()


def stretch(young: float, poisson: float, thickness: float) -> np.ndarray:
    return (
        young * thickness / (1 - poisson**2) * np.array([[1, poisson, 0], [poisson, 1, 0], [0, 0, (1 - poisson) / 2]])
    )


class Plate:
    """A rectangle of nx by ny elements, turned in space."""

    def __init__(
        self, nx: int, ny: int, a: float, b: float, thickness: float, young: float, poisson: float, turn: Any = None,
        density: float = 1.0,
    ) -> None:  # fmt: skip
        self.mbs = mbs = exu.SystemContainer().AddSystem()
        self.turn = turn = np.eye(3) if turn is None else turn
        membrane = stretch(young, poisson, thickness)
        self.nodes = [
            [
                mbs.AddNode(exu.NodePointSlope12(referenceCoordinates=[*(turn @ [x, y, 0]), *turn[:, 0], *turn[:, 1]]))
                for x in np.linspace(0, a, nx + 1)
            ]
            for y in np.linspace(0, b, ny + 1)
        ]
        self.elements = [
            mbs.AddObject(
                exu.ObjectANCFThinPlate(
                    physicsThickness=[thickness],
                    physicsDensity=density,
                    physicsStrainCoefficients=[membrane],
                    physicsCurvatureCoefficients=[thickness**2 / 12 * membrane],
                    nodeNumbers=[low[i], low[i + 1], high[i + 1], high[i]],
                )
            )
            for low, high in zip(self.nodes[:-1], self.nodes[1:], strict=True)
            for i in range(nx)
        ]
        self.ground = mbs.AddMarker(
            exu.MarkerNodeCoordinate(nodeNumber=mbs.AddNode(exu.NodePointGround()), coordinate=0)
        )

    def fix(self, node: Any, *coordinates: int) -> None:
        for coordinate in coordinates:
            marker = self.mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=node, coordinate=coordinate))
            self.mbs.AddObject(exu.ObjectConnectorCoordinate(markerNumbers=[self.ground, marker]))

    def push(self, node: Any, force: Any) -> None:
        marker = self.mbs.AddMarker(exu.MarkerNodePosition(nodeNumber=node))
        self.mbs.AddLoad(exu.LoadForceVector(markerNumber=marker, loadVector=force))

    def solve_static(self, steps: int = 1) -> None:
        self.mbs.Assemble()
        settings = exu.SimulationSettings()
        settings.staticSolver.numberOfLoadSteps = steps
        settings.staticSolver.newton.relativeTolerance = 1e-9
        self.mbs.SolveStatic(settings, updateInitialValues=True)

    def frequencies(self, count: int) -> np.ndarray:
        self.mbs.Assemble()
        state = testing.State(self.mbs)
        stiffness = testing.tangent(self.mbs, state, cq=1, cv=0, ca=0)[: len(state.q), : len(state.q)]
        mass = testing.mass_matrix(self.mbs, state)
        values = eigh((stiffness + stiffness.T) / 2, mass, eigvals_only=True)
        return np.sqrt(np.abs(values[:count]))


def test_frequencies_of_a_free_square() -> None:
    """A. W. Leissa, Vibration of plates, NASA SP-160, table 4.71 (W. Ritz 1909): w a^2 sqrt(rho h / D), Poisson ratio 0.3."""
    side, thickness, young = 1.0, 0.01, 1e9
    plate = Plate(8, 8, side, side, thickness, young, 0.3, TURN)
    rigidity = young * thickness**3 / 12 / (1 - 0.3**2)
    found = plate.frequencies(12) * side**2 * np.sqrt(thickness / rigidity)
    assert found[:6] == pytest.approx(np.zeros(6), abs=0.05)  # motion without deformation
    assert found[6:11] == pytest.approx([13.468, 19.596, 24.270, 34.801, 34.801], rel=8e-3)


def test_damping_is_proportional_to_stiffness() -> None:
    """At rest, the tangent by velocities is that by positions, times the factors of membrane and of bending."""

    def tangents(membrane: float, bending: float) -> tuple[np.ndarray, np.ndarray]:
        plate = Plate(2, 1, 1.0, 0.6, 0.1, 1e3, 0.3, TURN)
        for element in plate.elements:
            plate.mbs.SetObjectParameter(element, "stiffnessProportionalDamping", membrane)
            plate.mbs.SetObjectParameter(element, "bendingStiffnessProportionalDamping", bending)
        plate.mbs.Assemble()
        state = testing.State(plate.mbs)
        by_position, by_velocity = (
            testing.tangent(plate.mbs, state, cq=1 - which, cv=which, ca=0)[: len(state.q), : len(state.q)]
            for which in (0, 1)
        )
        return by_position, by_velocity

    stiffness, both = tangents(0.02, -1)
    scale = np.abs(stiffness).max()
    np.testing.assert_allclose(both, 0.02 * stiffness, rtol=0, atol=1e-14 * scale)
    of_membrane, of_bending = tangents(0.02, 0)[1], tangents(0, 0.05)[1]
    np.testing.assert_allclose(of_membrane + 0.4 * of_bending, both, rtol=0, atol=1e-14 * scale)
    sizes = [np.linalg.matrix_rank(D, tol=1e-10 * np.abs(D).max()) for D in (of_membrane, of_bending)]
    assert sum(sizes) >= np.linalg.matrix_rank(stiffness, tol=1e-10 * scale) and min(sizes) > 0
    assert not tangents(0, -1)[1].any()


def square(n: int, support: str, poisson: float = 0.3) -> Plate:
    """Side 1 m, thickness 1 cm; edges do not move, and do not turn if they are clamped."""
    plate = Plate(n, n, 1.0, 1.0, 0.01, 1e9, poisson)
    for j, row in enumerate(plate.nodes):
        for i, node in enumerate(row):
            held: set[int] = set()
            at_x, at_y = i in (0, n), j in (0, n)
            if support == "cantilever":
                held = {0, 1, 2, 5, 6, 7, 8} if i == 0 else set()
            else:
                held |= {3, 4, 5} if at_y else set()  # the slope along the edge
                held |= {6, 7, 8} if at_x else set()
                held |= {0, 1, 2} if at_x or at_y else set()
                held |= {5, 8} if support == "clamped" and held else set()
            plate.fix(node, *sorted(held))
    return plate


# w a^2 sqrt(rho h / D): closed form; products of Legendre polynomials with twelve digits; A. W. Leissa, 1969.
LEISSA = {
    "supported": [19.7392088, 49.3480220, 49.3480220, 78.9568352],
    "clamped": [35.985191, 73.393846, 73.393846, 108.216502],
    "cantilever": [3.4710, 8.5062, 21.284, 27.1987],
}


@pytest.mark.parametrize("support", list(LEISSA))
def test_frequencies_of_a_square(support: str) -> None:
    """Slopes do not fit between elements: errors fall with the square of their size."""
    rigidity = 1e9 * 0.01**3 / 12 / (1 - 0.3**2)
    coarse, fine = (
        square(n, support).mbs.ComputeVibrationModes(4).eigenvalues.imag * np.sqrt(0.01 / rigidity) for n in (8, 16)
    )
    wanted = np.array(LEISSA[support])
    errors = [np.linalg.norm(found / wanted - 1) for found in (coarse, fine)]
    assert errors[1] < 0.02
    assert np.log2(errors[0] / errors[1]) == pytest.approx(2, abs=0.2)
    assert (4 * fine - coarse) / 3 == pytest.approx(wanted, rel=3e-3)


@pytest.mark.parametrize(("support", "wanted"), [("supported", 0.943815), ("clamped", 0.584601)])
def test_large_deflection_of_a_square(support: str, wanted: float) -> None:
    """w / h in the middle under the pressure 50 E h^4 / a^4, edges immovable: T. von Karman's equations, by series to six digits."""
    pressure, found = 50 * 1e9 * 0.01**4, []
    for n in (6, 12):
        plate = square(n, support)
        for element in plate.elements:
            mass = plate.mbs.AddMarker(exu.MarkerBodyMass(bodyNumber=element))
            plate.mbs.AddLoad(exu.LoadMassProportional(markerNumber=mass, loadVector=[0, 0, pressure / 0.01]))
        plate.solve_static(4)
        found.append(plate.mbs.GetNodeOutput(plate.nodes[n // 2][n // 2], Variable.Displacement)[2] / 0.01)
    errors = np.array(found) / wanted - 1
    assert errors[0] / errors[1] == pytest.approx(3.7, abs=0.9)  # error: square of the element size
    assert (4 * found[1] - found[0]) / 3 == pytest.approx(wanted, rel=2e-3)


@pytest.mark.parametrize("across", [False, True], ids=["along x", "along y"])
def test_clamped_strip_bends_like_a_beam(across: bool) -> None:
    """A plate without lateral contraction has tip deflection and root stress of a beam; the side that is stretched has
    tension."""
    length, width, thickness, young, force = 1.0, 0.1, 0.01, 1e9, 1e-3
    sides = (1, 8, width, length) if across else (8, 1, length, width)
    plate = Plate(*sides, thickness, young, 0.0, TURN)
    rows = plate.nodes if across else [list(row) for row in zip(*plate.nodes, strict=True)]
    for node in rows[0]:
        plate.fix(node, *range(9))
    for node in rows[-1]:
        plate.push(node, TURN @ [0, 0, force / 2])
    plate.solve_static()
    inertia = width * thickness**3 / 12
    tip = TURN.T @ plate.mbs.GetNodeOutput(rows[-1][0], Variable.Displacement)
    assert tip[2] == pytest.approx(force * length**3 / (3 * young * inertia), rel=1e-5)
    root = [0, -1] if across else [-1, 0]
    stress = np.asarray(plate.mbs.GetObjectOutputBody(plate.elements[0], Variable.StressLocal, [*root, 1]))
    wanted = -force * length * thickness / 2 / inertia  # the upper side is pressed when the tip moves up
    assert stress[1 if across else 0] == pytest.approx(wanted, rel=1e-4)
    curvature = np.asarray(plate.mbs.GetObjectOutputBody(plate.elements[0], Variable.CurvatureLocal, [*root, 0]))
    assert curvature[0 if across else 1] == pytest.approx(
        (1 if across else -1) * force * length / (young * inertia), rel=1e-4
    )


def test_stretching_and_thickness() -> None:
    """A strip under tension: Green's strain and the force per width; points over the thickness follow the normal."""
    plate = Plate(2, 1, 1.0, 0.5, 0.02, 1e3, 0.3, TURN)
    for row in plate.nodes:
        plate.fix(row[0], 0, 1, 2)
    for row in plate.nodes:
        plate.push(row[-1], TURN @ [0.5 * 0.2, 0, 0])
    plate.mbs.Assemble()
    place = plate.mbs.GetObjectOutputBody(plate.elements[0], Variable.Position, [0, 0, 0.5])
    assert np.asarray(place) == pytest.approx(TURN @ [0.25, 0.25, 0.005], abs=1e-14)
    director = plate.mbs.GetObjectOutputBody(plate.elements[1], Variable.Director2, [0.3, 0, 0])
    assert np.asarray(director) == pytest.approx(TURN[:, 1], abs=1e-14)


def test_bending_into_an_arc() -> None:
    """Moments at the end of a long strip bend it: the angle of the end follows from the curvature, a third of a circle."""
    length, thickness, young, elements = 2.0, 0.01, 1e9, 12
    plate = Plate(elements, 1, length, 0.2, thickness, young, 0.0)
    columns = list(zip(*plate.nodes, strict=True))
    for node in columns[0]:
        plate.fix(node, *range(9))
    moment = 2 * np.pi / 3 / length * young * 0.2 * thickness**3 / 12
    for node in columns[-1]:
        marker = plate.mbs.AddMarker(exu.MarkerNodeRigid(nodeNumber=node))
        plate.mbs.AddLoad(exu.LoadTorqueVector(markerNumber=marker, loadVector=[0, -moment / 2, 0]))
    plate.solve_static(8)
    radius = length / (2 * np.pi / 3)
    wanted = [radius * np.sin(2 * np.pi / 3), 0, radius * (1 - np.cos(2 * np.pi / 3))]
    assert np.asarray(plate.mbs.GetNodeOutput(columns[-1][0], Variable.Position)) == pytest.approx(wanted, abs=2e-3)


def test_curved_reference_without_stress() -> None:
    mbs = exu.SystemContainer().AddSystem()
    angles, radius = (0.0, 0.5), 1.3
    nodes = []
    for angle, y in ((angles[0], 0), (angles[1], 0), (angles[1], 0.4), (angles[0], 0.4)):
        r = [radius * np.sin(angle), y, radius * (1 - np.cos(angle))]
        nodes.append(
            mbs.AddNode(exu.NodePointSlope12(referenceCoordinates=[*r, np.cos(angle), 0, np.sin(angle), 0, 1, 0]))
        )
    membrane = stretch(1e3, 0.3, 0.02)
    mbs.AddObject(
        exu.ObjectANCFThinPlate(
            physicsThickness=[0.02] * 4,
            physicsStrainCoefficients=[membrane] * 4,
            physicsCurvatureCoefficients=[0.02**2 / 12 * membrane],
            nodeNumbers=nodes,
        )
    )
    mbs.Assemble()
    assert np.abs(testing.residual(mbs, testing.State(mbs))).max() < 1e-13


@pytest.mark.parametrize(
    ("parameter", "value", "expected"),
    [
        ("physicsThickness", [0.1, 0.2], "2 values.*one for the plate, or four"),
        ("physicsThickness", [0.0], "positive thicknesses"),
        ("physicsStrainCoefficients", [], "0 values"),
        ("useReducedOrderIntegration", 2, "0 or 1"),
    ],
)
def test_refused(parameter: str, value: Any, expected: str) -> None:
    plate = Plate(1, 1, 1.0, 1.0, 0.1, 1e3, 0.3)
    with pytest.raises(ValueError, match=f"{parameter}.*{expected}"):
        plate.mbs.SetObjectParameter(plate.elements[0], parameter, value)
        plate.mbs.Assemble()
