"""Contents of other programs' decks in addition to a plain mesh: carried over, named in a warning, or refused with the
file."""

from __future__ import annotations

import warnings
from pathlib import Path
from typing import Any

import meshes
import meshio
import numpy as np
import pytest

from dalembert import FEM, graphics

DECK = """*NODE, NSET=NALL
1, 0., 0., 0.
2, 1.
3, 0., 1.
4, 0., 0., 1.
*ELEMENT, TYPE=C3D4, ELSET=Body
1, 1, 2, 3, 4
*NSET, NSET=Fix
1, 2
*NSET, NSET=Both
FIX, 3
*MATERIAL, NAME=Steel
*ELASTIC
2e11, 0.3
*DENSITY
7800
*SOLID SECTION, ELSET=BODY, MATERIAL=STEEL
"""


def read(path: Path, text: str) -> tuple[FEM.FEMinterface, list[str]]:
    path.write_text(text)
    fem = FEM.FEMinterface()
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        fem.ImportFromAbaqusInputFile(str(path))
    return fem, [str(warning.message) for warning in told]


def sets(fem: FEM.FEMinterface) -> dict[str, list[int]]:
    return {s["Name"]: s["NodeNumbers"].tolist() for s in fem.nodeSets}


def test_names_differ_in_case_and_coordinates_may_be_missing(tmp_path: Path) -> None:
    fem, told = read(tmp_path / "deck.inp", DECK)
    assert told == []
    assert sets(fem) == {"NALL": [0, 1, 2, 3], "Fix": [0, 1], "Both": [0, 1, 2]}
    np.testing.assert_array_equal(fem.GetNodePositionsAsArray(), [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
    fem.AssembleMatrices()  # the material of the section; case does not matter
    assert fem.GetMassMatrix().sum() == pytest.approx(3 * 7800 / 6)


def test_unknown_members_of_sets_are_named(tmp_path: Path) -> None:
    fem, told = read(tmp_path / "deck.inp", DECK.replace("FIX, 3", "Fxi, 3"))
    assert sets(fem)["Both"] == [2]
    assert len(told) == 1 and "deck.inp, line 11: set 'Fxi' is not known, and left out of 'Both'" in told[0]


@pytest.mark.parametrize("kind", ["MASS", "SPRINGA", "S4R"])
def test_other_elements_are_left_out(kind: str, tmp_path: Path) -> None:
    fem, told = read(tmp_path / "deck.inp", DECK + f"*ELEMENT, TYPE={kind}, ELSET=Other\n2, 4\n")
    assert fem.NumberOfElements() == 1 and [s["Name"] for s in fem.elementSets] == ["Body"]
    assert len(told) == 1 and f"deck.inp, line 18: elements of types '{kind}' are left out" in told[0]


def test_included_files(tmp_path: Path) -> None:
    (tmp_path / "meshes").mkdir()
    first, second = DECK.split("*MATERIAL")
    (tmp_path / "meshes/mesh.inp").write_text(first)
    fem, _ = read(tmp_path / "deck.inp", "*INCLUDE, INPUT=meshes/mesh.inp\n*MATERIAL" + second)
    assert sets(fem)["NALL"] == [0, 1, 2, 3] and "Material" in fem.elementSets[0]
    for name in ("none.inp", "deck.inp"):
        with pytest.raises(
            ValueError, match=rf"deck.inp, line 1: \*Include: there is no file '{name}', or it includes"
        ):
            read(tmp_path / "deck.inp", f"*INCLUDE, INPUT={name}\n" + DECK)


def test_laws_of_materials_that_are_not_read_are_named(tmp_path: Path) -> None:
    fem, told = read(tmp_path / "deck.inp", DECK.replace("*ELASTIC", "*ELASTIC, TYPE=ORTHO"))
    assert "Material" not in fem.elementSets[0]
    assert len(told) == 1 and "*Elastic, type=ORTHO is not read; give this material to AssembleMatrices" in told[0]


# ---- meshio ------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["bad.vtk", "bad.vtu", "bad.msh", "bad.mesh", "bad.bdf", "bad.med"])
def test_files_that_meshio_cannot_read_do_not_end_python(name: str, tmp_path: Path) -> None:
    (tmp_path / name).write_text("not a mesh")
    with pytest.raises(
        ValueError, match=rf"ImportFromMeshio: .*{name}: (meshio cannot read this file|there are no solid)"
    ):
        FEM.FEMinterface().ImportFromMeshio(str(tmp_path / name))


BULK = """CEND
BEGIN BULK
CORD2R  5               0.      0.      0.      0.      0.      1.
        0.      1.      0.
{system}
GRID    1       {cp}       0.      0.      0.
GRID    2       {cp}       1.      0.      0.
GRID    3       {cp}       0.      2.      0.
GRID    4       {cp}       0.      0.      3.
GRID    5               1.      2.      3.
CTETRA  1       1       1       2       3       4
CTETRA  2       2       2       3       4       5
PSOLID  1       1
PSOLID  2       2
MAT1    1       2.+11           .3      7800.
MAT1    2       7.+10           .3      2700.
ENDDATA
"""


@pytest.mark.parametrize(
    ("cp", "system", "expected"),
    [
        (5, "", [[0, 0, 0], [0, 1, 0], [-2, 0, 0], [0, 0, 3]]),
        # defined by system 5, with NASTRAN's numbers, in free format
        (6, "CORD2R,6,5,1.,0.,0.,1.,0.,1.,,\n,2.+0,0.,0.", [[0, 1, 0], [0, 2, 0], [-2, 1, 0], [0, 1, 3]]),
        # radius, degrees, height; radius, degrees from the axis, degrees about it
        (7, "CORD2C,7,0,0.,0.,0.,0.,0.,1.,,\n,1.,0.,0.", [[0, 0, 0], [1, 0, 0], [0, 0, 0], [0, 0, 3]]),
        (8, "CORD2S,8,0,0.,0.,0.,0.,0.,1.,,\n,1.,0.,0.", [[0, 0, 0], [0, 0, 1], [0, 0, 0], [0, 0, 0]]),
    ],
)  # fmt: skip
def test_coordinate_systems_of_grid_points(cp: int, system: str, expected: Any, tmp_path: Path) -> None:
    """Points in rotated, shifted, cylindrical and spherical systems; by formulas."""
    from dalembert._fem import nastran

    path = tmp_path / "deck.bdf"
    path.write_text(BULK.format(cp=cp, system=system))
    points = np.array([[0.0, 0, 0], [1, 0, 0], [0, 2, 0], [0, 0, 3], [1, 2, 3]])
    found = nastran.global_positions(str(path), points)
    np.testing.assert_allclose(found, [*expected, [1, 2, 3]], atol=1e-14)


def test_nastran_decks_keep_positions_and_properties(tmp_path: Path) -> None:
    path = tmp_path / "deck.bdf"
    path.write_text(BULK.format(cp=5, system="$"))
    fem = FEM.FEMinterface()
    found = fem.ImportFromMeshio(str(path), scale=0.1)
    np.testing.assert_allclose(
        found, 0.1 * np.array([[0, 0, 0], [0, 1, 0], [-2, 0, 0], [0, 0, 3], [1, 2, 3]]), atol=1e-15
    )
    assert {s["Name"]: s["ElementNumbers"].tolist() for s in fem.elementSets} == {
        "nastran:ref:1": [0], "nastran:ref:2": [1],
    }  # fmt: skip
    path.write_text(BULK.format(cp=9, system="CORD1R  9       1       2       3"))
    with pytest.raises(ValueError, match=r"deck.bdf: GRID 1 is in coordinate system 9 \(CORD1R\), which is not read"):
        FEM.FEMinterface().ImportFromMeshio(str(path))


def test_numbered_regions_take_materials(tmp_path: Path) -> None:
    """Two halves of a block, marked by numbers as in files of medit, have the masses of their materials."""
    positions, elements = meshes.block("Hex8", (2, 1, 1))
    numbers = np.arange(len(elements["Hex8"])) % 2
    mesh = meshio.Mesh(positions, [("hexahedron", elements["Hex8"])], cell_data={"medit:ref": [numbers]})
    fem = FEM.FEMinterface()
    fem.ImportFromMeshio(mesh)
    light, heavy = ({"youngsModulus": 1e9, "poissonsRatio": 0.3, "density": density} for density in (1000, 3000))
    fem.AssembleMatrices(materials={"medit:ref:0": light, "medit:ref:1": heavy})
    volume = np.prod(np.ptp(positions, axis=0))
    assert fem.GetMassMatrix().sum() == pytest.approx(3 * 2000 * volume)


# ---- surfaces ----------------------------------------------------------------------------------------------------------


def stl(path: Path, corners: np.ndarray) -> str:
    facets = [
        "facet normal 0 0 0\nouter loop\n"
        + "".join(f"vertex {x} {y} {z}\n" for x, y, z in triangle)
        + "endloop\nendfacet\n"
        for triangle in corners.tolist()
    ]
    path.write_text("solid s\n" + "".join(facets) + "endsolid s\n")
    return str(path)


def test_masses_of_surfaces(tmp_path: Path) -> None:
    """A closed surface weighs the same whichever way it is turned; open and mixed ones give a warning."""
    points, triangles = graphics.ToPointsAndTrigs(graphics.Brick([0.5, 0, 0], [1, 2, 3]))
    corners = np.asarray(points, dtype=float)[np.asarray(triangles)]
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for turned in (corners, corners[:, ::-1]):
            found = graphics.FromSTLfile(stl(tmp_path / "brick.stl", turned), density=10)[1]
            assert found["mass"] == pytest.approx(60, rel=1e-6)
            np.testing.assert_allclose(np.diag(found["inertia"]), 5 * np.array([13, 10, 5]), rtol=1e-6)
            np.testing.assert_allclose(found["COM"], [0.5, 0, 0], atol=1e-6)
    mixed = corners.copy()
    mixed[0] = mixed[0, ::-1]
    with pytest.warns(UserWarning, match=r"brick.stl: triangles at 3 edges are turned against each other"):
        graphics.FromSTLfile(stl(tmp_path / "brick.stl", mixed), density=10)
    with pytest.warns(UserWarning, match=r"brick.stl: the surface is open at 3 edges: mass and inertia may be wrong"):
        graphics.FromSTLfile(stl(tmp_path / "brick.stl", corners[1:]), density=10)
