"""Linear elastic materials, and the tetrahedron with linear displacements."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import numpy.typing as npt

from dalembert._checks import FloatArray, shape_error


class MaterialBaseClass:
    """Young's modulus, Poisson's ratio and density of a material."""

    def __init__(self, youngsModulus: float | None, poissonsRatio: float | None, density: float) -> None:
        self.youngsModulus = youngsModulus
        self.poissonsRatio = poissonsRatio
        self.density = density


class KirchhoffMaterial(MaterialBaseClass):
    """Linear elastic material; strain vectors are (xx, yy, zz, yz, xz, xy), with engineering shear strains."""

    def __init__(
        self,
        youngsModulus: float | None = None,
        poissonsRatio: float | None = None,
        density: float = 0,
        materials: Any = None,
        fes: Any = None,
        planeStress: bool = True,
    ) -> None:
        super().__init__(youngsModulus, poissonsRatio, density)
        self.planeStress = planeStress
        self.useMaterials = materials is not None
        if materials is not None:
            self._take_by_region(materials, fes)
            return
        _check_constants("KirchhoffMaterial", youngsModulus, poissonsRatio, density)
        mu, lame = self.LameParameters()
        self.elasticityTensor = np.diag([2 * mu] * 3 + [mu] * 3)
        self.elasticityTensor[:3, :3] += lame
        coupling = 2 * mu * lame / (2 * mu + lame) if planeStress else lame
        self.elasticityTensor2D = np.diag([2 * mu, 2 * mu, mu])
        self.elasticityTensor2D[:2, :2] += coupling

    def _take_by_region(self, materials: Mapping[str, Mapping[str, float]], fes: Any) -> None:
        """Take constants that differ from region to region of a mesh, as coefficient functions of NGsolve."""
        if self.youngsModulus is not None or self.poissonsRatio is not None or self.density:
            raise ValueError("KirchhoffMaterial: give either materials, or youngsModulus, poissonsRatio and density")
        if fes is None:
            raise ValueError("KirchhoffMaterial: materials need fes, the space that ImportMeshFromNGsolve returns")
        constants = coefficient_functions("KirchhoffMaterial", fes.mesh, materials)
        self.materials, self.fes = materials, fes
        self.density, self.youngsModulus, self.poissonsRatio = constants

    def LameParameters(self) -> list[float]:
        """[mu, lambda]: shear modulus and first Lame parameter."""
        assert self.youngsModulus is not None and self.poissonsRatio is not None
        E, nu = self.youngsModulus, self.poissonsRatio
        return [E / (2 * (1 + nu)), E * nu / ((1 + nu) * (1 - 2 * nu))]

    def Strain2Stress(self, strain: npt.ArrayLike) -> FloatArray:
        """Stress tensor (3x3) of a strain tensor (3x3)."""
        self._refuse_regions("Strain2Stress")
        mu, lame = self.LameParameters()
        tensor = np.asarray(strain, dtype=float)
        return 2 * mu * tensor + lame * np.trace(tensor) * np.eye(3)

    def StrainVector2StressVector(self, strainVector: npt.ArrayLike) -> FloatArray:
        """Stress vector (6) of a strain vector (6)."""
        self._refuse_regions("StrainVector2StressVector")
        return self.elasticityTensor @ np.asarray(strainVector, dtype=float)

    def StrainVector2StressVector2D(self, strainVector2D: npt.ArrayLike) -> FloatArray:
        """Stress vector (3) of a strain vector (xx, yy, xy) in the plane."""
        self._refuse_regions("StrainVector2StressVector2D")
        return self.elasticityTensor2D @ np.asarray(strainVector2D, dtype=float)

    def _refuse_regions(self, function: str) -> None:
        if self.useMaterials:
            raise ValueError(f"KirchhoffMaterial.{function}: constants differ from region to region; use one material")


class FiniteElement:
    """A finite element of a material."""

    def __init__(self, material: KirchhoffMaterial) -> None:
        self.material = material


class Tet4(FiniteElement):
    """Tetrahedron with 4 nodes and linear displacements."""

    def ComputeMatrices(
        self, nodalReferenceCoordinates: npt.ArrayLike, nodalDisplacements: npt.ArrayLike
    ) -> list[FloatArray]:
        """Strain and stress vectors (one line per node), derivatives of shape functions, displacement gradient."""
        corners = np.asarray(nodalReferenceCoordinates, dtype=float).reshape(4, 3)
        shape = np.linalg.inv(np.column_stack([np.ones(4), corners]))[1:].T
        gradient = np.asarray(nodalDisplacements, dtype=float).reshape(4, 3).T @ shape
        strain = strain_vector(gradient)
        stress = self.material.StrainVector2StressVector(strain)
        return [np.tile(strain, (4, 1)), np.tile(stress, (4, 1)), shape, gradient]


def strain_vector(gradient: FloatArray) -> FloatArray:
    """(xx, yy, zz, yz, xz, xy) of displacement gradients (..., 3, 3), with engineering shear strains."""
    g = gradient
    shear = (g[..., 1, 2] + g[..., 2, 1], g[..., 0, 2] + g[..., 2, 0], g[..., 0, 1] + g[..., 1, 0])
    return np.stack([g[..., 0, 0], g[..., 1, 1], g[..., 2, 2], *shear], axis=-1)


def as_material(where: str, material: Any) -> KirchhoffMaterial:
    """A material, or a dictionary with youngsModulus, poissonsRatio and density."""
    if isinstance(material, KirchhoffMaterial):
        return material
    try:
        return KirchhoffMaterial(*(material[name] for name in _CONSTANTS))
    except (TypeError, KeyError):
        expected = f"a KirchhoffMaterial, or a dictionary with {', '.join(_CONSTANTS)}"
        raise shape_error(where, expected, material) from None


def coefficient_functions(where: str, mesh: Any, materials: Mapping[str, Mapping[str, float]]) -> list[Any]:
    """Density, Young's modulus and Poisson's ratio by region of an NGsolve mesh."""
    import ngsolve

    regions = list(mesh.GetMaterials())
    if missing := [name for name in regions if name not in materials]:
        raise ValueError(f"{where}: no material is given for the regions {', '.join(map(repr, missing))} of the mesh")
    names = ("density", "youngsModulus", "poissonsRatio")
    return [ngsolve.CoefficientFunction([materials[region][name] for region in regions]) for name in names]


_CONSTANTS = ("youngsModulus", "poissonsRatio", "density")


def _check_constants(where: str, youngsModulus: Any, poissonsRatio: Any, density: Any) -> None:
    if youngsModulus is None or poissonsRatio is None:
        raise ValueError(f"{where}: youngsModulus and poissonsRatio are needed")
    if not np.isfinite(youngsModulus) or youngsModulus <= 0:
        raise shape_error(f"{where}: youngsModulus", "a positive number", youngsModulus)
    if not -1 < poissonsRatio < 0.5:
        raise shape_error(f"{where}: poissonsRatio", "a number between -1 and 0.5 (excluded)", poissonsRatio)
    if density is None or not np.isfinite(density) or density < 0:
        raise shape_error(f"{where}: density", "a number that is not negative", density)
