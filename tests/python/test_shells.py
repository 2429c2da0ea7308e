"""Meshes of shells: positions of nodes, elements, and rejected arguments."""

import numpy as np
import pytest

import dalembert as exu
from dalembert import shells
from dalembert.shells import ShellMesh, SurfaceMap


class Recorder:
    """Takes items as a system does, and keeps them."""

    def __init__(self):
        self.nodes, self.objects = [], []

    def AddNode(self, node):
        self.nodes.append(node)
        return exu.NodeIndex(len(self.nodes) - 1)

    def AddObject(self, item):
        self.objects.append(item)
        return exu.ObjectIndex(len(self.objects) - 1)


@pytest.fixture
def mesh():
    data = {"youngsModulus": 2e11, "poissonsRatio": 0.3, "density": 7800.0, "thickness": 0.01}
    return ShellMesh([[0, 0, 0], [2, 0, 0], [2, 1, 0], [0, 1, 0]], 4, 2, **data)


def test_a_plane_mesh(mesh):
    system = Recorder()
    mesh.CreateANCFThinPlateElements(system)
    assert (mesh.NumberOfNodes(), len(mesh.elementNumbers)) == (15, 8)
    assert [int(i) for i in mesh.vertexNodeNumbers] == [0, 4, 14, 10]
    sides = {side: [int(i) for i in nodes] for side, nodes in mesh.boundaryNodeNumbers.items()}
    assert sides["left"] == [0, 5, 10]
    assert sides["top"] == [10, 11, 12, 13, 14]
    assert len(sides["all"]) == 12
    np.testing.assert_allclose(system.nodes[6].referenceCoordinates, [0.5, 0.5, 0, 1, 0, 0, 0, 1, 0])
    plate = system.objects[5]
    assert [int(i) for i in plate.nodeNumbers] == [6, 7, 12, 11]
    stretch = 2e11 * 0.01 / 0.91 * np.array([[1, 0.3, 0], [0.3, 1, 0], [0, 0, 0.35]])
    np.testing.assert_allclose(plate.physicsStrainCoefficients[0], stretch, rtol=1e-12)
    np.testing.assert_allclose(plate.physicsCurvatureCoefficients[0], stretch * 1e-4 / 12, rtol=1e-12)
    assert (plate.physicsThickness, plate.physicsDensity) == ([0.01], 7800)
    mesh.CreateANCFThinPlateElements(Recorder())
    assert mesh.NumberOfNodes() == 15


def cylinder(sin, cos):
    return lambda p: [2 * sin(p[0] / 2), p[1], 2 * cos(p[0] / 2)]


@pytest.mark.parametrize(
    "functions", [(exu.symbolic.sin, exu.symbolic.cos), (np.sin, np.cos)], ids=["symbolic", "numpy"]
)
def test_a_cylinder(mesh, functions):
    mesh.vertexMapping = cylinder(*functions)
    mesh.vertexTransformation = np.array([[0, -1, 0, 5], [1, 0, 0, 6], [0, 0, 1, 7], [0, 0, 0, 1.0]])
    system = Recorder()
    mesh.CreateANCFThinPlateElements(system)
    s, c = np.sin(0.25), np.cos(0.25)
    expected = [5 - 0.5, 6 + 2 * s, 7 + 2 * c, 0, c, -s, -1, 0, 0]
    np.testing.assert_allclose(system.nodes[6].referenceCoordinates, expected, rtol=0, atol=1e-9)


def test_thickness_at_nodes(mesh):
    mesh.thicknessAtNodes = 0.01 + 0.001 * np.arange(15)
    system = Recorder()
    mesh.CreateANCFThinPlateElements(system)
    np.testing.assert_allclose(system.objects[5].physicsThickness, [0.016, 0.017, 0.022, 0.021])
    assert len(system.objects[5].physicsCurvatureCoefficients) == 4


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"thickness": None}, r"thickness: expected a positive thickness \(m\), received \[None\]"),
        ({"thicknessAtNodes": [0.1] * 3}, "thicknessAtNodes: expected a vector with 15 components"),
        ({"thicknessAtNodes": [-0.1] * 15}, "thicknessAtNodes: expected positive thicknesses"),
        ({"youngsModulus": None}, "youngsModulus: expected a positive number, received None"),
        ({"poissonsRatio": 1.0}, "poissonsRatio: expected a number between -1 and 0.5, received 1.0"),
        ({"vertexMapping": lambda p: [0.0, p[1], 0.0]}, r"vertexMapping has no tangent at its point \[0"),
        ({"vertexMapping": lambda p: [p[0], p[1]]}, "vertexMapping: expected a vector with 3 components"),
    ],
)
def test_rejected_arguments(mesh, change, message):
    for name, value in change.items():
        setattr(mesh, name, value)
    system = Recorder()
    with pytest.raises(ValueError, match=message):
        mesh.CreateANCFThinPlateElements(system)
    assert system.nodes == []


def test_wrong_sizes():
    with pytest.raises(ValueError, match="numberOfElementsY: expected a positive integer, received 0"):
        ShellMesh(numberOfElementsY=0)
    with pytest.raises(ValueError, match="vertices: expected a 4x3 matrix"):
        ShellMesh(vertices=[[0, 0], [1, 0], [1, 1], [0, 1]])


# ---- maps, supports, hinges and loads of edges


@pytest.mark.parametrize(
    ("mapping", "surface"),
    [  # a quantity that is constant on the surface
        (SurfaceMap.Cylinder(2, 1, 0.7, thetaCenterDeg=30), lambda p: np.hypot(p[1], p[2]) - 0.7),
        (SurfaceMap.ConeFrustum(2, 1, 0.5, 1), lambda p: np.hypot(p[1], p[2]) - 0.5 - 0.25 * p[0]),
        (SurfaceMap.HemisphericalShell(2, 1, 3, 0.3, [1, 2, 3]), lambda p: np.linalg.norm(p - [1, 2, 3]) - 3),
        (SurfaceMap.ToroidalPanel(2, 1), lambda p: np.hypot(np.hypot(p[0], p[1]) - 1.5, p[2]) - 0.5),
    ],
    ids=["cylinder", "cone", "sphere", "torus"],
)
def test_nodes_and_slopes_lie_on_the_surface(mesh, mapping, surface):
    mesh.surfaceMap = mapping
    system = Recorder()
    mesh.CreateANCFThinPlateElements(system)
    h = 1e-6
    for node in system.nodes:
        p, *slopes = np.reshape(node.referenceCoordinates, (3, 3))
        assert surface(p) == pytest.approx(0, abs=1e-12)
        for slope in slopes:  # unit tangents: no change of first order along them
            assert np.linalg.norm(slope) == pytest.approx(1, abs=1e-12)
            assert (surface(p + h * slope) - surface(p - h * slope)) / (2 * h) == pytest.approx(0, abs=1e-8)


def test_lengths_along_a_curve_and_around_a_cylinder():
    points = [0, 0, 0], [1, 0, 0], [2, 1, 0.3], [3, 1, 0.5]
    strip = SurfaceMap.BezierStrip(*points, Lx=2, Ly=1)
    places = np.array([strip(x, 0.5) for x in np.linspace(0, 2, 401)])
    steps = np.linalg.norm(np.diff(places, axis=0), axis=1)
    assert np.ptp(steps) < 2e-3 * steps.mean()  # equal lengths, up to those of 400 chords
    np.testing.assert_allclose(places[[0, -1]], [points[0], points[3]], atol=1e-12)
    assert np.subtract(strip(0.7, 1), strip(0.7, 0)) @ np.subtract(strip(0.701, 0.5), strip(0.7, 0.5)) < 1e-6
    a, b = (np.array([float(v) for v in SurfaceMap.Cylinder(2, 1, 0.7)(0.3, y)]) for y in (0, 0.7 * np.pi / 2))
    np.testing.assert_allclose([a, b], [[0.3, 0.7, 0], [0.3, 0, 0.7]], atol=1e-12)


def test_plane_maps():
    assert SurfaceMap.SkewParallelogram(0.2, 0.3)(1, 2) == [1.4, 2.3, 0]
    assert SurfaceMap.Trapezoid(2, 1, 0.5)(0, 1) == [0.5, 1, 0]
    assert SurfaceMap.Trapezoid(2, 1, 0.5, aboutMidline=False)(2, 1) == [1, 1, 0]
    wave = SurfaceMap.CurvedEdge(2, 1, 0.1, "bottom", "parabola", aboutMidline=False)
    np.testing.assert_allclose([wave(1, 0), wave(1, 1), wave(2, 0)], [[1.1, 0, 0], [1, 1, 0], [2, 0, 0]])
    assert float(SurfaceMap.CurvedEdge(2, 1, 0.1)(1, 1)[0]) == pytest.approx(1.1 - 0.1 / np.pi)
    assert float(SurfaceMap.OutOfPlaneWarp(2, 1, 0.2)(1, 0.5)[2]) == pytest.approx(0.2)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("Cylinder", 2, 0, 1), "SurfaceMap: Ly: expected a positive number, received 0"),
        (("ConeFrustum", 2, 1, 1, 1, 20, 0, True, "arc"), "yMode: expected 'arclength' or 'angle', received 'arc'"),
        (("HemisphericalShell", 2, 1, 1, 2), "alpha: expected an angle from 0 to less than pi/2"),
        (("CurvedEdge", 2, 1, 0.1, "left"), "mode: expected 'top' or 'bottom', received 'left'"),
        (("BezierStrip", [1, 1, 1], [1, 1, 1], [1, 1, 1], [1, 1, 1], 2, 1), "the curve of P0 to P3 has no length"),
    ],
)
def test_rejected_maps(arguments, message):
    with pytest.raises(ValueError, match=message):
        getattr(SurfaceMap, arguments[0])(*arguments[1:])


def test_two_maps_are_rejected(mesh):
    mesh.surfaceMap, mesh.vertexMapping = SurfaceMap.Cylinder(2, 1, 1), cylinder(np.sin, np.cos)
    with pytest.raises(ValueError, match="vertexMapping and surfaceMap: expected one of them"):
        mesh.CreateANCFThinPlateElements(Recorder())


@pytest.mark.parametrize("sine", [exu.symbolic.sin, np.sin], ids=["symbolic", "numpy"])
def test_a_function_of_the_thickness(mesh, sine):
    mesh.thicknessFunction = lambda x, y: 0.01 + 0.002 * sine(x) + 0.001 * y
    mesh.stiffnessProportionalDamping = 0.003
    system = Recorder()
    mesh.CreateANCFThinPlateElements(system, useReducedOrderIntegration=1)
    plate = system.objects[5]  # from [0.5, 0.5] to [1, 1]
    expected = [0.01 + 0.002 * np.sin(x) + 0.001 * y for x, y in ((0.5, 0.5), (1, 0.5), (1, 1), (0.5, 1))]
    np.testing.assert_allclose(plate.physicsThickness, expected, rtol=1e-12)
    np.testing.assert_allclose(mesh.thicknessGradientAtNodes[6, 1:], [0.002 * np.cos(0.5), 0.001], rtol=1e-6)
    assert (plate.stiffnessProportionalDamping, plate.useReducedOrderIntegration) == (0.003, 1)


def strip(columns=8, rows=1, width=0.2, length=1.0):
    """A strip of Poisson ratio 0 along x: a beam of stiffness EI = 1e9 * width * h^3 / 12."""
    mbs = exu.SystemContainer().AddSystem()
    corners = [[0, 0, 0], [length, 0, 0], [length, width, 0], [0, width, 0]]
    mesh = ShellMesh(corners, columns, rows, 1e9, 0.0, 1000.0, 0.01)
    mesh.CreateANCFThinPlateElements(mbs)
    return mbs, mesh


STIFFNESS = 1e9 * 0.2 * 0.01**3 / 12


def solved(mbs):
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.solutionSettings.writeSolutionToFile = False
    mbs.SolveStatic(settings)
    return lambda node: mbs.GetNodeOutput(node, exu.OutputVariableType.Displacement)


@pytest.mark.parametrize("distributed", [False, True])
def test_a_force_at_the_edge_bends_a_clamped_strip(distributed):
    mbs, mesh = strip()
    for node in mesh.boundaryNodeNumbers["left"]:
        assert len(shells.AddClampToGround(mbs, node)) == 9
    force = 3 * STIFFNESS * 0.001  # deflection 1 mm
    loads = shells.ApplyEdgeLoad(mbs, mesh, "right", [0, 0, force], distributed=distributed)
    assert len(loads) == 2
    moved = solved(mbs)
    for node in mesh.boundaryNodeNumbers["right"]:
        assert moved(node)[2] == pytest.approx(0.001, rel=1e-4)  # the rest is the nonlinearity (w/L)^2


def test_a_torque_at_the_edge_bends_to_a_circle():
    mbs, mesh = strip()
    for node in mesh.boundaryNodeNumbers["left"]:
        shells.AddClampToGround(mbs, node, [1, 1, 1, 0, 1, 1, 1, 0, 1])
    shells.ApplyEdgeLoad(mbs, mesh, "right", torqueVector=[0, -STIFFNESS * 0.1, 0])  # curvature 0.1/m
    assert solved(mbs)(mesh.vertexNodeNumbers[1])[2] == pytest.approx((1 - np.cos(0.1)) / 0.1, rel=1e-4)


@pytest.mark.parametrize(("distributed", "factor"), [(True, 1 / 8), (False, 13 / 96)])
def test_a_load_along_a_clamped_beam(distributed, factor):
    """Cubic elements are exact at their nodes for work-equivalent loads: F L^3 / (8 EI); halves and quarters of the
    load at the nodes of two elements give 13/96 instead."""
    mbs, mesh = strip(columns=2)
    for node in mesh.boundaryNodeNumbers["left"]:
        shells.AddClampToGround(mbs, node)
    force = 1e-3 * STIFFNESS / factor
    for side in ("top", "bottom"):
        shells.ApplyEdgeLoad(mbs, mesh, side, [0, 0, force / 2], distributed=distributed)
    assert solved(mbs)(mesh.vertexNodeNumbers[1])[2] == pytest.approx(1e-3, rel=1e-4)


def test_supports_of_both_ends():
    mbs, mesh = strip()
    for side in ("left", "right"):
        for node in mesh.boundaryNodeNumbers[side]:
            assert len(shells.AddSphericalJointToGround(mbs, node)) == 3
    middle = mesh.nodeNumbers[4]
    across = [mesh.nodeNumbers[4], mesh.nodeNumbers[13]]
    for node in across:
        marker = mbs.AddMarker(exu.itemInterface.MarkerNodePosition(nodeNumber=node))
        mbs.AddLoad(exu.itemInterface.Force(markerNumber=marker, loadVector=[0, 0, 0.5 * 48 * STIFFNESS * 1e-5]))
    assert solved(mbs)(middle)[2] == pytest.approx(1e-5, rel=1e-3)  # F L^3 / (48 EI)


@pytest.mark.parametrize("stiffness", [STIFFNESS, 10 * STIFFNESS])
def test_a_hinge_with_a_spring(stiffness):
    """Two halves, joined by positions and a rotational spring: angles of a clamp, a spring and a force at the end."""
    mbs, first = strip(4, length=0.5)
    second = ShellMesh([[0.5, 0, 0], [1, 0, 0], [1, 0.2, 0], [0.5, 0.2, 0]], 4, 1, 1e9, 0.0, 1000.0, 0.01)
    second.CreateANCFThinPlateElements(mbs)
    for node in first.boundaryNodeNumbers["left"]:
        shells.AddClampToGround(mbs, node)
    ours, others = first.boundaryNodeNumbers["right"], second.boundaryNodeNumbers["left"]
    for own, other in zip(ours, others, strict=True):
        shells.AddNodeConstraints(mbs, other, [0, 1, 2], own)
        shells.AddNodeConstraints(mbs, other, [7], own)
    springs = shells.AddEdgeSpringDamper(mbs, ours, others, [3, 4, 5], stiffness, 0.5)
    assert len(springs) == 6
    assert mbs.GetObjectParameter(springs[0], "stiffness") == pytest.approx(stiffness / 2)
    force = 3e-4 * STIFFNESS
    shells.ApplyEdgeLoad(mbs, second, "right", [0, 0, force])
    bent, turned = force / (3 * STIFFNESS), force * 0.5 / stiffness * 0.5
    assert solved(mbs)(second.vertexNodeNumbers[1])[2] == pytest.approx(bent + turned, rel=1e-4)


def slope_between(mbs, element, component):
    """Deviation of the slope along x at the middle of the left side from the mean of its ends, by differences."""
    h = 1e-6

    def place(xi, eta):
        return mbs.GetObjectOutputBody(element, exu.OutputVariableType.Position, [xi, eta, 0])[component]

    slopes = [(place(-1 + h, eta) - place(-1, eta)) / h for eta in (-1, 0, 1)]
    return slopes[1] - (slopes[0] + slopes[2]) / 2


@pytest.mark.parametrize("constrain", ["nothing", "edge", "mesh"])
def test_slopes_across_a_side_are_linear(constrain):
    mbs = exu.SystemContainer().AddSystem()
    mesh = ShellMesh([[0, 0, 0], [1, 0, 0], [1.2, 1, 0], [0, 0.8, 0]], 2, 1, 1e9, 0.3, 1000.0, 0.01)
    mesh.CreateANCFThinPlateElements(mbs)
    for node in mesh.boundaryNodeNumbers["left"]:
        shells.AddClampToGround(mbs, node)
    if constrain == "edge":
        assert len(shells.AddDistributedClampToEdge(mbs, mesh, "left", [2])) == 1
    if constrain == "mesh":
        assert len(shells.AddSlopeConformityConstraints(mbs, mesh, "x", [2])) == 2
    shells.ApplyEdgeLoad(mbs, mesh, "right", [0, 0, 5], [3, 0, 0])
    solved(mbs)
    deviations = [abs(slope_between(mbs, element, 2)) for element in mesh.elementNumbers]
    limits = {"nothing": (0, 0), "edge": (1, 0), "mesh": (1, 1)}[constrain]
    for deviation, limited in zip(deviations, limits, strict=True):
        assert (deviation < 1e-8) if limited else (deviation > 1e-5)


def test_rejected_supports():
    mbs, mesh = strip()
    with pytest.raises(ValueError, match="fixedConstraints: expected nine numbers 0 or 1"):
        shells.AddClampToGround(mbs, mesh.nodeNumbers[0], [1, 1, 1])
    with pytest.raises(ValueError, match="direction: expected 'x', 'y' or 'both', received 'z'"):
        shells.AddSlopeConformityConstraints(mbs, mesh, "z")
    with pytest.raises(ValueError, match="edgeKey: expected 'left', 'right', 'bottom' or 'top', received 'all'"):
        shells.ApplyEdgeLoad(mbs, mesh, "all", [0, 0, 1])
    with pytest.raises(ValueError, match="expected a mesh with elements"):
        shells.ApplyEdgeLoad(mbs, ShellMesh(), "left", [0, 0, 1])
    with pytest.raises(ValueError, match="expected as many nodes in both, at least two; received 2 and 1"):
        shells.AddEdgeSpringDamper(mbs, mesh.nodeNumbers[:2], mesh.nodeNumbers[:1], [5], 1.0)
