"""Stiffness and mass of a beam from its cross section, by Saint-Venant's problem [Saint-Venant 1856, Pilkey 2002].

The warping functions of torsion and of bending with shear force are found by quadratic triangles. Shear compliances are
those of the energy of shear stresses, so that factors of shear depend on Poisson's ratio, as they do in reality. The
shear centre is the one without work between shear force and twist [Trefftz 1935].
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from dalembert._checks import FloatArray, as_vector, shape_error
from dalembert._fem.materials import as_material
from dalembert._fem.section_mesh import SectionMesh, mesh_of
from dalembert._fem.section_outlines import SectionOutline
from dalembert.basicUtilities import gaussIntegrationPoints, gaussIntegrationWeights

# Gauss points of a triangle, from a collapsed square
_X, _W = np.array(gaussIntegrationPoints[3]), np.array(gaussIntegrationWeights[3])
_U, _V = (axis.ravel() for axis in np.meshgrid((_X + 1) / 2, (_X + 1) / 2, indexing="ij"))
_POINTS = np.stack([_U, _V * (1 - _U)], axis=1)
_WEIGHTS = np.outer(_W, _W).ravel() / 4 * (1 - _U)


@dataclass(frozen=True)
class SectionConstants:
    """Constants of a cross section; y and z are its axes, x is the axis of the beam.

    centroid, shearCenter: [y, z] (m) in the axes of the outline. secondMoments (m^4), about the centroid: [[int y^2,
    int y z], [int y z, int z^2]]. torsionConstant (m^4), warpingConstant (m^6) about the shear centre.
    shearCompliance (1/m^2): compliance for forces through the shear centre, times G; shearFactors: 1 / (area times
    its diagonal). stiffnessMatrix:
    from [axial strain, shear y, z, twist, curvature y, z] to [N, Qy, Qz, Mx, My, Mz], and massMatrix: from [velocity,
    angular velocity] to momenta, per length; both refer to referencePoint.
    """

    area: float
    centroid: FloatArray
    secondMoments: FloatArray
    torsionConstant: float
    warpingConstant: float
    shearCenter: FloatArray
    shearCompliance: FloatArray
    referencePoint: FloatArray
    stiffnessMatrix: FloatArray
    massMatrix: FloatArray
    boundary: FloatArray

    @property
    def shearFactors(self) -> FloatArray:
        """Factors of shear in y and z: area that shears uniformly, divided by the area."""
        return np.asarray(1 / (self.area * np.diag(self.shearCompliance)), dtype=float)

    @property
    def principalAngle(self) -> float:
        """Angle (rad) from y to the axis along which the section is longest: its largest second moment."""
        (yy, yz), (_, zz) = self.secondMoments
        return float(0.5 * np.arctan2(2 * yz, yy - zz))

    def BeamSection(self) -> Any:
        """The section as parameter sectionData of beams with 6x6 stiffness."""
        from dalembert import BeamSection

        section = BeamSection()
        section.stiffnessMatrix = self.stiffnessMatrix
        section.massPerLength = float(self.massMatrix[0, 0])
        section.inertia = self.massMatrix[3:, 3:]
        return section

    def BeamSectionGeometry(self) -> Any:
        """The outer boundary as parameter sectionGeometry, for drawing and contact."""
        from dalembert import BeamSectionGeometry, CrossSectionType

        geometry = BeamSectionGeometry()
        geometry.crossSectionType = CrossSectionType.Polygon
        geometry.polygonalPoints = (self.boundary - self.referencePoint).tolist()
        return geometry


def ComputeSectionConstants(
    outline: SectionOutline, material: Any, referencePoint: Sequence[float] | str = "centroid", fineness: float = 24
) -> SectionConstants:
    """Constants of a section (SectionRectangle, SectionI, ...) of one isotropic material.

    `material` is a KirchhoffMaterial, or a dictionary with youngsModulus, poissonsRatio and density. The axis of the
    beam goes through the referencePoint: 'centroid', 'shearCenter', or [y, z]. Triangles have about a `fineness`-th of
    the size of the section; twice as fine, errors fall by four about.
    """
    where = "ComputeSectionConstants"
    if not isinstance(outline, SectionOutline):
        raise shape_error(f"{where}: outline", "a section, such as SectionRectangle(0.1, 0.2)", outline)
    if not np.isfinite(fineness) or fineness < 4:
        raise shape_error(f"{where}: fineness", "a number of at least 4", fineness)
    chosen = as_material(f"{where}: material", material)
    modulus, ratio = float(chosen.youngsModulus or 0.0), float(chosen.poissonsRatio or 0.0)
    integrals = _Integrals(mesh_of(outline, fineness))
    torsion, warping, centre = integrals.torsion()
    compliance = integrals.shear(ratio)
    through_centre = compliance[:2, :2] - np.outer(compliance[:2, 2], compliance[2, :2]) / compliance[2, 2]
    points: dict[str, FloatArray] = {"centroid": integrals.centroid, "shearCenter": integrals.centroid + centre}
    if isinstance(referencePoint, str):
        if referencePoint not in points:
            raise shape_error(f"{where}: referencePoint", "'centroid', 'shearCenter' or [y, z]", referencePoint)
        point = points[referencePoint]
    else:
        point = as_vector(f"{where}: referencePoint", referencePoint, 2)
    offset = point - integrals.centroid
    return SectionConstants(
        area=integrals.area,
        centroid=integrals.centroid,
        secondMoments=integrals.moments,
        torsionConstant=torsion,
        warpingConstant=warping,
        shearCenter=points["shearCenter"],
        shearCompliance=through_centre,
        referencePoint=point,
        stiffnessMatrix=_stiffness(integrals, modulus, modulus / (2 * (1 + ratio)), compliance, offset),
        massMatrix=float(chosen.density) * _mass(integrals, offset),
        boundary=outline.loops[0].points,
    )


def _stiffness(
    integrals: _Integrals, modulus: float, shear: float, compliance: FloatArray, offset: FloatArray
) -> FloatArray:
    """6x6 matrix about a point at an offset from the centroid; compliance is that of Qy, Qz, Mx, times G."""
    area, (y, z) = integrals.area, -offset  # the centroid, as seen from the point
    (yy, yz), (_, zz) = integrals.moments + area * np.outer(-offset, -offset)
    matrix = np.zeros((6, 6))
    normal = [[area, area * z, -area * y], [area * z, zz, -yz], [-area * y, -yz, yy]]
    matrix[np.ix_([0, 4, 5], [0, 4, 5])] = modulus * np.array(normal)
    moved = np.array([[1, 0, 0], [0, 1, 0], [-offset[1], offset[0], 1.0]])  # moment about the centroid
    matrix[1:4, 1:4] = shear * np.linalg.inv(moved.T @ compliance @ moved)
    return matrix


def _mass(integrals: _Integrals, offset: FloatArray) -> FloatArray:
    """6x6 matrix of momenta per length and density."""
    area, (y, z) = integrals.area, -offset
    (yy, yz), (_, zz) = integrals.moments + area * np.outer(-offset, -offset)
    matrix = np.zeros((6, 6))
    matrix[:3, :3] = area * np.eye(3)
    matrix[:3, 3:] = area * np.array([[0, z, -y], [-z, 0, 0], [y, 0, 0]])
    matrix[3:, :3] = matrix[:3, 3:].T
    matrix[3:, 3:] = [[yy + zz, 0, 0], [0, zz, -yz], [0, -yz, yy]]
    return matrix


class _Integrals:
    """Integrals over the triangles of a section, about its centroid, and Laplace's equation on them."""

    def __init__(self, mesh: SectionMesh) -> None:
        self._mesh, corners = mesh, mesh.points[mesh.triangles]
        s, t = _POINTS.T
        r = 1 - s - t
        self._values = np.stack(
            [r * (2 * r - 1), s * (2 * s - 1), t * (2 * t - 1), 4 * r * s, 4 * s * t, 4 * t * r], axis=1
        )
        by_s = np.stack([1 - 4 * r, 4 * s - 1, 0 * s, 4 * (r - s), 4 * t, -4 * t], axis=1)
        by_t = np.stack([1 - 4 * r, 0 * s, 4 * t - 1, -4 * s, 4 * s, 4 * (r - t)], axis=1)
        local = np.stack([by_s, by_t], axis=1)
        jacobians = np.einsum("qdn,enx->eqdx", local, corners)
        self._gradients = np.linalg.solve(jacobians, np.broadcast_to(local, (len(corners), *local.shape)))
        self._weights = np.linalg.det(jacobians) * _WEIGHTS
        places = np.einsum("qn,enx->eqx", self._values, corners)
        self.area = float(self._weights.sum())
        self.centroid = np.einsum("eq,eqx->x", self._weights, places) / self.area
        self._places = places - self.centroid
        self.moments = np.einsum("eq,eqx,eqw->xw", self._weights, self._places, self._places)
        self._solve = self._laplace()
        self._warping = self._field(vectors=self._turned() * [1, -1])

    def _turned(self) -> FloatArray:
        return np.asarray(self._places[..., ::-1])  # z, y

    def _laplace(self) -> Any:
        """Factors of the matrix of Laplace's equation; the first value is 0."""
        from scipy.sparse import csc_matrix  # here, as all models import this file and few need sections
        from scipy.sparse.linalg import splu

        n, triangles = len(self._mesh.points), self._mesh.triangles
        flat = self._gradients.reshape(len(triangles), -1, 6)
        weighted = (self._gradients * self._weights[..., None, None]).reshape(flat.shape)
        entries = weighted.transpose(0, 2, 1) @ flat
        rows, columns = np.repeat(triangles, 6, axis=1), np.tile(triangles, (1, 6))
        self._used = np.unique(triangles)[1:]
        matrix = csc_matrix((entries.ravel(), (rows.ravel(), columns.ravel())), shape=(n, n))
        return splu(matrix[self._used][:, self._used].tocsc())

    def _field(self, vectors: Any = None, sources: Any = None) -> FloatArray:
        """Field u with int grad u . grad v = int vectors . grad v + int sources v for all v; values at the nodes."""
        right = np.zeros(len(self._mesh.points))
        if vectors is not None:
            parts = np.einsum("eq,eqx,eqxn->en", self._weights, vectors, self._gradients)
            np.add.at(right, self._mesh.triangles, parts)
        if sources is not None:
            np.add.at(right, self._mesh.triangles, np.einsum("eq,eq,qn->en", self._weights, sources, self._values))
        field = np.zeros(len(right))
        field[self._used] = self._solve.solve(right[self._used])
        return field

    def _at_points(self, field: FloatArray) -> FloatArray:
        return np.einsum("qn,en->eq", self._values, field[self._mesh.triangles])

    def _slopes(self, field: FloatArray) -> FloatArray:
        return np.einsum("eqxn,en->eqx", self._gradients, field[self._mesh.triangles])

    def _twist(self) -> FloatArray:
        """Shear stress of a unit twist, divided by G."""
        return self._slopes(self._warping) + self._turned() * [-1, 1]

    def torsion(self) -> tuple[float, float, FloatArray]:
        """Torsion constant, warping constant about the shear centre, and shear centre, as seen from the centroid."""
        y, z = self._places[..., 0], self._places[..., 1]
        stress = self._twist()
        constant = float(np.sum(self._weights * (y * stress[..., 1] - z * stress[..., 0])))
        warping = self._at_points(self._warping)
        products = np.einsum("eq,eq,eqx->x", self._weights, warping, self._places)
        a, b = np.linalg.solve(self.moments, products)  # warping without its linear part
        rest = warping - a * y - b * z
        rest = rest - np.sum(self._weights * rest) / self.area
        return constant, float(np.sum(self._weights * rest**2)), np.array([-b, a])

    def shear(self, ratio: float) -> FloatArray:
        """Compliance of shear forces Qy, Qz and of the torsional moment about the centroid, times G."""
        y, z = self._places[..., 0], self._places[..., 1]
        twist = self._twist()
        constant = np.sum(self._weights * (y * twist[..., 1] - z * twist[..., 0]))
        fields = []
        for force in np.linalg.inv(self.moments):  # gradient of the normal stress: force . (y, z)
            a, b = force
            source = a * y + b * z
            contraction = ratio * np.stack(
                [a * (y**2 - z**2) / 2 + b * y * z, a * y * z + b * (z**2 - y**2) / 2], axis=-1
            )
            field = self._field(contraction, 2 * (1 + ratio) * source)
            stress = (self._slopes(field) - contraction) / (2 * (1 + ratio))
            moment = np.sum(self._weights * (y * stress[..., 1] - z * stress[..., 0]))
            fields.append(stress - moment / constant * twist)
        stresses = np.stack([*fields, twist / constant])
        return np.einsum("eq,ieqx,jeqx->ij", self._weights, stresses, stresses)
