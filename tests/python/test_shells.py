"""Meshes of shells: positions of nodes, elements, and rejected arguments."""

import numpy as np
import pytest

import dalembert as exu
from dalembert.shells import ShellMesh


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
