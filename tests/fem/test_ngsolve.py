"""Meshes of NGsolve; the package is large, so these tests run where it is installed."""

import meshes
import numpy as np
import pytest

import dalembert as exu
from dalembert import FEM

ngsolve = pytest.importorskip("ngsolve", reason="ngsolve is installed by the extra [ngsolve]", exc_type=ImportError)
occ = pytest.importorskip("netgen.occ", reason="comes with ngsolve", exc_type=ImportError)

ngsolve.SetNumThreads(1)
STEEL = {"youngsModulus": 2.1e11, "poissonsRatio": 0.3, "density": 7850.0}


def bar():
    """A bar with two named ends."""
    shape = occ.Box((0, -0.05, -0.05), (1, 0.05, 0.05))
    shape.faces.Min((1, 0, 0)).name, shape.faces.Max((1, 0, 0)).name = "left", "right"
    shape.name = "steel"
    return ngsolve.Mesh(occ.OCCGeometry(shape).GenerateMesh(maxh=0.08))


@pytest.mark.parametrize("order", [1, 2])
def test_meshes_and_modes(order):
    fem, ours = FEM.FEMinterface(), FEM.FEMinterface()
    forms = fem.ImportMeshFromNGsolve(
        bar(), materials={"steel": STEEL}, boundaryNamesList=["left", "right"], meshOrder=order
    )
    fem.CheckConsistency()
    assert fem.elementSets[0]["Name"] == "steel"
    lists, weights = fem.GetBoundaryNodeSetsAsLists()
    assert [s["Name"] for s in fem.nodeSets] == ["left", "right"]
    assert [w.sum() for w in weights] == pytest.approx([1, 1])
    ours.SetMesh(fem.nodes["Position"], {k: v for k, v in fem.elements[0].items() if k != "Name"})
    ours.AssembleMatrices(STEEL)
    for matrix, other in ((fem.stiffnessMatrix, ours.stiffnessMatrix), (fem.massMatrix, ours.massMatrix)):
        assert abs(matrix - other).max() < 1e-12 * abs(other).max()
    fem.ComputeHurtyCraigBamptonModesNGsolve(*forms[:2], lists, 4)
    ours.ComputeHurtyCraigBamptonModes(lists, 4)
    np.testing.assert_allclose(fem.eigenValues, ours.eigenValues, rtol=1e-8)
    fem.ComputeEigenmodesNGsolve(*forms[:2], 3, excludeRigidBodyModes=6)
    ours.ComputeEigenmodes(3, 6)
    np.testing.assert_allclose(fem.eigenValues, ours.eigenValues, rtol=1e-8)
    fem.ComputePostProcessingModesNGsolve(forms[2], FEM.KirchhoffMaterial(materials={"steel": STEEL}, fes=forms[2]))
    ours.ComputePostProcessingModes(meshes.STEEL)
    stresses = [np.abs(f.postProcessingModes["matrix"]) for f in (fem, ours)]
    np.testing.assert_allclose(*stresses, rtol=0, atol=1e-5 * stresses[0].max())


def test_large_deformations_begin_small():
    """Free vibrations of a mesh with nonlinear forces have the frequencies of its matrices."""
    mbs = exu.SystemContainer().AddSystem()
    fem = FEM.FEMinterface()
    constants = (STEEL["density"], STEEL["youngsModulus"], STEEL["poissonsRatio"])
    number, nodes = fem.CreateNonlinearFEMObjectGenericODE2NGsolve(mbs, bar(), *constants)
    assert len(nodes) == fem.NumberOfNodes()
    mbs.Assemble()
    values = np.sort(mbs.ComputeODE2Eigenvalues()[0])
    fem.ComputeEigenmodes(3, 6)
    np.testing.assert_allclose(values[6:9], fem.eigenValues, rtol=1e-4)
    assert len(mbs.GetObjectParameter(number, "nodeNumbers")) == len(nodes)


def test_rejected_arguments():
    fem, mesh = FEM.FEMinterface(), bar()
    with pytest.raises(ValueError, match="no material is given for the regions 'steel' of the mesh"):
        fem.ImportMeshFromNGsolve(mesh, materials={"wood": STEEL})
    with pytest.raises(ValueError, match="give either materials, or density, youngsModulus and poissonsRatio"):
        fem.ImportMeshFromNGsolve(mesh, density=1.0, materials={"steel": STEEL})
    with pytest.raises(ValueError, match="meshOrder: expected 1 or 2, received 3"):
        fem.ImportMeshFromNGsolve(mesh, **STEEL, meshOrder=3)
    with pytest.raises(ValueError, match="the mesh has no boundary 'top'; there are"):
        fem.GetNodesOfNGsolveBoundary(mesh, "top")


def test_arguments_without_effect_are_reported():
    with pytest.warns(UserWarning, match="computeEigenmodes: without effect"):
        FEM.FEMinterface().ImportMeshFromNGsolve(bar(), materials={"steel": STEEL}, computeEigenmodes=False)


def test_a_mesh_of_a_surface_is_no_body():
    from netgen.meshing import MeshingStep

    shape = occ.OCCGeometry(occ.Box((0, 0, 0), (1, 1, 1)))
    surface = ngsolve.Mesh(shape.GenerateMesh(maxh=0.5, perfstepsend=MeshingStep.MESHSURFACE))
    with pytest.raises(ValueError, match="the mesh has no tetrahedra"):
        FEM.FEMinterface().ImportMeshFromNGsolve(surface, **STEEL)
