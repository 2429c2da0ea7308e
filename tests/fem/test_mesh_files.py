"""Meshes and matrices in files: ABAQUS, ANSYS, meshio, and our own."""

import meshes
import meshio
import numpy as np
import pytest
import scipy.io
import scipy.sparse

import dalembert as exu
from dalembert import FEM
from dalembert._fem.elements import KINDS

TYPES = {"Tet4": "C3D4", "Tet10": "C3D10", "Hex8": "C3D8R", "Hex20": "C3D20", "Wedge6": "C3D6", "Wedge15": "C3D15"}
HEAD = "*Heading\n** comment\n*Part, name=Block\n*Node\n"
TAIL = """*Nset, nset=Ends, generate
 10, 20, 5
*Elset, elset=All, generate
 100, 9999, 1
*Solid Section, elset=All, material=Steel
,
*End Part
*Material, name=Steel
*Density
7850.,
*Elastic
2.1e+11, 0.3
"""


def abaqus_text(positions, elements, first=1):
    """An input file whose nodes are numbered from `first`, and whose elements from 100."""
    lines = [f"{i + first}, {x}, {y}, {z}" for i, (x, y, z) in enumerate(positions.tolist())]
    number = 100
    for kind, nodes in elements.items():
        lines.append(f"*Element, type={TYPES[kind]}")
        for row in (nodes + first).tolist():
            words = [str(number), *map(str, row)]
            lines += [", ".join(words[:16]) + ("," if len(words) > 16 else "")]
            lines += [", ".join(words[16:])] if len(words) > 16 else []
            number += 1
    return HEAD + "\n".join(lines) + "\n" + TAIL


@pytest.mark.parametrize("kind", TYPES)
def test_abaqus_meshes(kind, tmp_path):
    positions, elements = meshes.block(kind, (2, 2, 1))
    (tmp_path / "block.inp").write_text(abaqus_text(positions, elements, first=5))
    fem = FEM.FEMinterface()
    read = fem.ImportFromAbaqusInputFile(str(tmp_path / "block.inp"), name="Block")
    np.testing.assert_allclose(read, positions)
    assert (fem.elements[0][kind] == elements[kind]).all()
    assert [s["NodeNumbers"].tolist() for s in fem.nodeSets] == [[5, 10, 15]]
    fem.AssembleMatrices()  # the material of the file
    np.testing.assert_allclose(fem.GetMassMatrix().sum(), 3 * 7850)
    assert (fem.GetSurfaceTriangles() == np.array(meshes.solid(kind, (2, 2, 1)).GetSurfaceTriangles())).all()
    every = FEM.FEMinterface()
    every.ImportFromAbaqusInputFile(str(tmp_path / "block.inp"), surfaceTrigsAll=True)
    assert len(every.GetSurfaceTriangles()) > len(fem.GetSurfaceTriangles())


def test_nodes_of_abaqus_alone(tmp_path):
    positions, elements = meshes.block("Hex8")
    (tmp_path / "block.inp").write_text(abaqus_text(positions, elements))
    file = str(tmp_path / "block.inp")
    np.testing.assert_allclose(FEM.ReadNodesFromAbaqusInp(file), positions)
    _, read, _ = FEM.ReadNodesFromAbaqusInp(file, exportElements=True)
    assert (read["elements"] == elements["Hex8"] + 1).all()
    assert read["elementTypes"] == ["Hex8"] * 8


def test_instances_of_abaqus(tmp_path):
    text = abaqus_text(*meshes.block("Tet4")).replace(
        "*Part, name=Block\n", "*Part, name=B\n*End Part\n*Instance, name=B-1\n"
    )
    (tmp_path / "block.inp").write_text(
        text.replace("material=Steel\n,\n*End Part", "material=Steel\n,\n*End Instance")
    )
    fem = FEM.FEMinterface()
    with pytest.raises(ValueError, match=r"\*Part in line 3 has no \*Node; nodes may be in parts or instances"):
        fem.ImportFromAbaqusInputFile(str(tmp_path / "block.inp"))
    fem.ImportFromAbaqusInputFile(str(tmp_path / "block.inp"), typeName="Instance", name="B-1")
    assert fem.NumberOfNodes() == 27


WRONG = {
    "four coordinates": (
        "27, 1.0, 1.0, 1.0",
        "27, 1.0, 1.0, 1.0, 1.0",
        r"block.inp, line 31: expected a node number and up",
    ),
    "no number": (
        "27, 1.0, 1.0, 1.0",
        "27, 1.0, 1.0, x",
        r"line 31: expected a node number and up to three coordinates, found",
    ),
    "node twice": ("27, 1.0, 1.0, 1.0", "26, 1.0, 1.0, 1.0", "node 26 is given more than once"),
    "unknown node": ("100, 1, 10", "100, 99, 10", "line 33: element 100 has node 99, which does not exist"),
    "short element": ("100, 1, 10, ", "100, 10, ", "line 33: expected an element number and 8 nodes of C3D8R, found 8"),
    "shells": ("type=C3D8R", "type=S4R", "line 32: elements of type 'S4R' are not known"),
    "other part": (
        "name=Block",
        "name=B\n*End Part\n*Part, name=C",
        r"no \*Part with name='Part-1'; there are 'B', 'C'",
    ),
    "inverted": (
        "100, 1, 10, 13, 4, 2, 11, 14, 5",
        "100, 2, 11, 14, 5, 1, 10, 13, 4",
        r"element 0 \(number 100 in block.inp\) of kind Hex8 is inv",
    ),
    "node twice in element": (
        "100, 1, 10, 13",
        "100, 1, 1, 13",
        r"element 0 \(number 100 in block.inp\) has a node twice",
    ),
}


@pytest.mark.parametrize("case", WRONG)
def test_wrong_abaqus_files(case, tmp_path):
    old, new, message = WRONG[case]
    text = abaqus_text(*meshes.block("Hex8"))
    assert old in text
    (tmp_path / "block.inp").write_text(text.replace(old, new, 1))
    with pytest.raises(ValueError, match=message):
        FEM.FEMinterface().ImportFromAbaqusInputFile(str(tmp_path / "block.inp"))


def triplets(matrix, half=False):
    entries = scipy.sparse.tril(matrix).tocoo() if half else matrix.tocoo()
    return zip(entries.row.tolist(), entries.col.tolist(), entries.data.tolist(), strict=True)


def test_matrices_of_abaqus(tmp_path):
    fem, read = meshes.solid("Hex8"), FEM.FEMinterface()
    read.nodes = fem.nodes
    mass, stiffness = fem.GetMassMatrix(), fem.GetStiffnessMatrix()
    (tmp_path / "m.mtx").write_text("".join(f"{i + 1} {j + 1}  {v!r}\n" for i, j, v in triplets(mass)))
    lines = (f"{i // 3 + 1},{i % 3 + 1},{j // 3 + 1},{j % 3 + 1},{v!r}\n" for i, j, v in triplets(stiffness, half=True))
    (tmp_path / "k.mtx").write_text("".join(lines))
    read.ReadMassMatrixFromAbaqus(str(tmp_path / "m.mtx"))
    read.ReadStiffnessMatrixFromAbaqus(str(tmp_path / "k.mtx"))
    assert abs(read.GetMassMatrix() - mass).max() == 0
    assert abs(read.GetStiffnessMatrix() - stiffness).max() == 0
    read.nodes = {"Position": fem.nodes["Position"][:20]}
    with pytest.raises(ValueError, match=r"m.mtx has 81 rows, but 20 nodes have 60 coordinates"):
        read.ReadMassMatrixFromAbaqus(str(tmp_path / "m.mtx"))
    (tmp_path / "wrong.mtx").write_text("1 1 1.0\n1 two 3\n")
    with pytest.raises(ValueError, match=r"wrong.mtx: expected lines with row, column and value"):
        read.ReadMassMatrixFromAbaqus(str(tmp_path / "wrong.mtx"))
    (tmp_path / "fixed.mtx").write_text("1 1 1.0\n5 5 1e36\n")
    with pytest.raises(ValueError, match=r"coordinate 1 of node 1 is fixed; export matrices without boundary cond"):
        read.ReadStiffnessMatrixFromAbaqus(str(tmp_path / "fixed.mtx"))


def test_ansys(tmp_path):
    fem, read = meshes.solid("Hex8", (2, 1, 1)), FEM.FEMinterface()
    points, order = fem.GetNodePositionsAsArray(), np.random.default_rng(2).permutation(12)
    name = lambda part: str(tmp_path / part)  # noqa: E731
    rows = [f"{i + 1}\t" + "\t".join(f"{x:g}".replace(".", ",") for x in points[i]) for i in order]
    (tmp_path / "nodes.txt").write_text("Knotennummer\tX\tY\tZ\n" + "\n".join(rows) + "\n")
    elements = fem.elements[0]["Hex8"] + 1
    rows = [f"{i + 1}\tHex8\t" + "\t".join(map(str, row)) for i, row in enumerate(elements.tolist())]
    (tmp_path / "elements.txt").write_text("Elementnummer\tElementtyp\tKnoten\n" + "\n".join(rows) + "\n")
    (tmp_path / "order.txt").write_text("%%MatrixMarket\n12 1\n" + "\n".join(map(str, order + 1)) + "\n")
    places = (3 * order[:, None] + np.arange(3)).ravel()
    mass, stiffness = fem.GetMassMatrix()[places][:, places], fem.GetStiffnessMatrix()[places][:, places]
    scipy.io.mmwrite(name("mass.mtx"), mass.tocoo(), symmetry="symmetric", precision=17)
    np.savetxt(name("stiffness.csv"), stiffness.toarray(), delimiter=",", fmt="%.17e")
    read.ReadNodalCoordinatesFromAnsys(name("nodes.txt"))
    read.ReadElementsFromAnsys(name("elements.txt"))
    read.ReadMassMatrixFromAnsys(name("mass.mtx"), name("order.txt"))
    read.ReadStiffnessMatrixFromAnsys(name("stiffness.csv"), name("order.txt"), sparse=False)
    np.testing.assert_allclose(read.GetNodePositionsAsArray(), points)
    assert read.GetSurfaceTriangles() == fem.GetSurfaceTriangles()
    assert abs(read.GetMassMatrix() - fem.GetMassMatrix()).max() < 1e-12 * abs(mass).max()
    assert abs(read.GetStiffnessMatrix() - fem.GetStiffnessMatrix()).max() < 1e-12 * abs(stiffness).max()
    (tmp_path / "elements.txt").write_text("title\n1 Hex8 1 2 3\n")
    with pytest.raises(ValueError, match=r"elements.txt, line 2: expected 8 nodes of Hex8, found 3"):
        read.ReadElementsFromAnsys(name("elements.txt"))
    (tmp_path / "order.txt").write_text("4 1\n1\n2\n3\n4\n")
    with pytest.raises(ValueError, match=r"mass.mtx has 36 rows, but .*order.txt has 12 coordinates"):
        read.ReadMassMatrixFromAnsys(name("mass.mtx"), name("order.txt"))


MESHIO = {"Tet4": "tetra", "Tet10": "tetra10", "Hex8": "hexahedron", "Hex20": "hexahedron20", "Wedge6": "wedge"}


@pytest.mark.parametrize("kind", MESHIO)
@pytest.mark.parametrize("ending", [".vtk", ".vtu", ".inp"])
def test_meshes_of_other_programs(kind, ending, tmp_path):
    positions, elements = meshes.block(kind, (2, 2, 1))
    points = np.vstack([positions, [[9.0, 9, 9]]])  # a node that no element has is left out
    triangles = ("triangle", np.array([[0, 1, 2]]))
    file = str(tmp_path / f"block{ending}")
    meshio.Mesh(1000 * points, [(MESHIO[kind], elements[kind]), triangles]).write(file)
    fem = FEM.FEMinterface()
    fem.ImportFromMeshio(file, scale=1e-3)
    np.testing.assert_allclose(fem.GetNodePositionsAsArray(), positions, rtol=1e-12, atol=1e-12)
    fem.AssembleMatrices(meshes.STEEL)
    assert abs(fem.GetStiffnessMatrix() - meshes.solid(kind, (2, 2, 1)).GetStiffnessMatrix()).max() < 1e-2


def test_groups_of_meshio():
    positions, elements = meshes.block("Hex8", (2, 1, 1))
    cells = [
        ("hexahedron", elements["Hex8"][:1]),
        ("triangle", np.array([[0, 1, 2]])),
        ("hexahedron", elements["Hex8"][1:]),
    ]
    tags = {"gmsh:physical": [np.array([7]), np.array([9]), np.array([8])]}
    names = {"left": np.array([7, 3]), "right": np.array([8, 3]), "face": np.array([9, 2])}
    mesh = meshio.Mesh(positions, cells, cell_data=tags, field_data=names, point_sets={"end": np.array([0, 1])})
    fem = FEM.FEMinterface()
    fem.ImportFromMeshio(mesh)
    assert {s["Name"]: s["ElementNumbers"].tolist() for s in fem.elementSets} == {"left": [0], "right": [1]}
    assert fem.nodeSets[0]["NodeNumbers"].tolist() == [0, 1]
    with pytest.raises(ValueError, match="there are no solid elements; found: triangle"):
        fem.ImportFromMeshio(meshio.Mesh(positions, cells[1:2]))


@pytest.mark.parametrize("ending", ["", ".npz", ".pkl", ".hdf5", ".npy"])
def test_our_own_files(ending, tmp_path):
    fem, read = meshes.solid("Tet10", (2, 1, 1)), FEM.FEMinterface()
    fem.AddBoundary("left", fem.GetNodesInPlane([0, 0, 0], [1, 0, 0]))
    fem.ComputeEigenmodes(3, 6)
    fem.ComputePostProcessingModes(meshes.STEEL, exu.OutputVariableType.StressLocal)
    fem.elementSets = [{"Name": "all", "ElementNumbers": np.arange(3)}]
    file = str(tmp_path / "folder" / f"mesh{ending}")
    fem.SaveToFile(file)
    assert read.LoadFromFile(file) == 4
    assert abs(read.GetStiffnessMatrix() - fem.GetStiffnessMatrix()).max() == 0
    assert (read.nodes["Position"] == fem.nodes["Position"]).all()
    assert (read.elements[0]["Tet10"] == fem.elements[0]["Tet10"]).all()
    assert read.GetSurfaceTriangles() == fem.GetSurfaceTriangles()
    assert read.nodeSets[0]["Name"] == "left"
    assert (read.nodeSets[0]["NodeWeights"] == fem.nodeSets[0]["NodeWeights"]).all()
    assert (read.modeBasis["matrix"] == fem.modeBasis["matrix"]).all()
    assert (read.eigenValues == fem.eigenValues).all()
    assert (read.postProcessingModes["matrix"] == fem.postProcessingModes["matrix"]).all()
    assert read.metaData["source"] == "user"
    modal = FEM.ObjectFFRFreducedOrderInterface(read)
    assert modal.totalMass == pytest.approx(7850, rel=1e-12)


def test_files_that_are_not_ours(tmp_path):
    np.savez(tmp_path / "other.npz", nodes=3)
    with pytest.raises(ValueError, match=r"other.npz: there is no elements, no massMatrix"):
        FEM.FEMinterface().LoadFromFile(str(tmp_path / "other.npz"))
    with pytest.raises(ValueError, match="fileVersion: expected an integer from 1 to 4, received 9"):
        meshes.solid("Tet4").SaveToFile(str(tmp_path / "mesh"), fileVersion=9)


def test_all_kinds_have_a_name_in_files():
    assert set(TYPES) | {"Hex27"} == set(KINDS)
