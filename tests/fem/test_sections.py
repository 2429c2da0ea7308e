"""Constants of cross sections against series, closed forms and published values."""

import numpy as np
import pytest

import dalembert as exu
from dalembert import beams


def material(nu, density=1.0):
    """Shear modulus 1."""
    return {"youngsModulus": 2 * (1 + nu), "poissonsRatio": nu, "density": density}


def constants(outline, nu=0.3, **more):
    return beams.ComputeSectionConstants(outline, material(nu), **more)


def torsion_of_rectangle(a, b):
    """Saint-Venant's series."""
    n = np.arange(1, 60, 2)
    return a * b**3 * (1 / 3 - 64 / np.pi**5 * b / a * np.sum(np.tanh(n * np.pi * a / (2 * b)) / n**5))


@pytest.mark.parametrize("height", [2.0, 1.0, 0.5, 0.25])
def test_rectangles(height):
    section = constants(beams.SectionRectangle(1.0, height))
    assert section.area == pytest.approx(height, rel=1e-12)
    np.testing.assert_allclose(section.secondMoments, np.diag([height, height**3]) / 12, rtol=1e-11, atol=1e-14)
    assert section.torsionConstant == pytest.approx(torsion_of_rectangle(1.0, height), rel=2e-4)
    np.testing.assert_allclose(np.r_[section.centroid, section.shearCenter], 0, atol=1e-6)


# Gruttmann and Wagner, Computational Mechanics 27 (2001), table 1: shear along the side h, beside a side b
GRUTTMANN = {
    (0.0, 2.0): 0.8333,
    (0.0, 1.0): 0.8333,
    (0.0, 0.5): 0.8333,
    (0.0, 0.25): 0.8333,
    (0.25, 2.0): 0.8331,
    (0.25, 1.0): 0.8295,
    (0.25, 0.5): 0.7961,
    (0.25, 0.25): 0.6308,
    (0.5, 2.0): 0.8325,
    (0.5, 1.0): 0.8228,
    (0.5, 0.5): 0.7375,
    (0.5, 0.25): 0.4404,
}


@pytest.mark.parametrize(("nu", "ratio"), GRUTTMANN)
def test_shear_factors_of_rectangles(nu, ratio):
    section = constants(beams.SectionRectangle(1.0, ratio), min(nu, 0.5 - 1e-12))
    assert section.shearFactors[1] == pytest.approx(GRUTTMANN[nu, ratio], abs=1.5e-4)


@pytest.mark.parametrize("hole", [0.0, 0.5, 0.9, 0.98])
@pytest.mark.parametrize("nu", [0.0, 0.3])
def test_circles_and_tubes(hole, nu):
    """Shear factor by energy in closed form (Renton, 1997; Pilkey, 2002)."""
    section = constants(beams.SectionTube(2.0, 2 * hole) if hole else beams.SectionCircle(2.0), nu)
    assert section.area == pytest.approx(np.pi * 4 * (1 - hole**2), rel=1e-6)
    assert section.torsionConstant == pytest.approx(np.pi / 2 * 16 * (1 - hole**4), rel=1e-6)
    m = (1 + hole**2) ** 2
    factor = 6 * (1 + nu) ** 2 * m / ((7 + 14 * nu + 8 * nu**2) * m + 4 * hole**2 * (5 + 10 * nu + 4 * nu**2))
    np.testing.assert_allclose(section.shearFactors, factor, rtol=5e-5)
    assert section.warpingConstant < 1e-9


def test_an_equilateral_triangle():
    height = np.sqrt(0.75)
    section = constants(beams.SectionPolygon([[0, 0], [1, 0], [0.5, height]]))
    assert section.torsionConstant == pytest.approx(np.sqrt(3) / 80, rel=2e-5)
    np.testing.assert_allclose(section.centroid, [0.5, height / 3], rtol=1e-12)
    np.testing.assert_allclose(section.shearCenter, [0.5, height / 3], rtol=0, atol=1e-5)
    np.testing.assert_allclose(section.secondMoments, np.eye(2) * np.sqrt(3) / 96, rtol=1e-10, atol=1e-14)


def test_an_ellipse():
    angles = 2 * np.pi * np.arange(400) / 400
    section = constants(beams.SectionPolygon(np.stack([2 * np.cos(angles), np.sin(angles)], axis=1)))
    assert section.torsionConstant == pytest.approx(np.pi * 8 / 5, rel=2e-4)
    assert section.warpingConstant == pytest.approx(
        np.pi / 24 * 8 * 9 / 25 * 1.0, rel=2e-3
    )  # ab (a^2-b^2)^2/(a^2+b^2)^2


def test_an_i_profile():
    """Thin walls: torsion of strips, warping of flanges, shear carried by the web."""
    h, b, w, f = 0.2, 0.1, 0.002, 0.002
    section = constants(beams.SectionI(h, b, w, f))
    assert section.area == pytest.approx(2 * b * f + (h - 2 * f) * w, rel=1e-12)
    assert section.torsionConstant == pytest.approx((2 * b * f**3 + (h - f) * w**3) / 3, rel=0.01)
    assert section.warpingConstant == pytest.approx((h - f) ** 2 / 4 * b**3 * f / 6, rel=0.01)
    assert section.shearFactors[1] * section.area == pytest.approx(w * (h - f), rel=0.06)
    np.testing.assert_allclose(section.shearCenter, 0, atol=1e-6 * h)


def test_an_i_profile_with_different_flanges():
    h, b, c, t = 0.2, 0.1, 0.06, 0.002
    section = constants(beams.SectionI(h, b, t, t, widthBottom=c))
    share = b**3 / (b**3 + c**3)  # of the upper flange in the second moment across
    expected = -(h - t) / 2 + share * (h - t)
    assert section.shearCenter[1] == pytest.approx(expected, abs=0.01 * h)
    assert section.warpingConstant == pytest.approx((h - t) ** 2 * t / 12 * b**3 * c**3 / (b**3 + c**3), rel=0.01)


def test_a_channel():
    """The shear centre of a thin channel lies 3 b^2 f / (h w + 6 b f) before the web."""
    h, b, t = 0.2, 0.08, 0.002
    outer = [[0, 0], [b, 0], [b, t], [t, t], [t, h - t], [b, h - t], [b, h], [0, h]]
    section = constants(beams.SectionPolygon(outer))
    middle_b, middle_h = b - t / 2, h - t
    expected = t / 2 - 3 * middle_b**2 * t / (middle_h * t + 6 * middle_b * t)
    np.testing.assert_allclose(section.shearCenter, [expected, h / 2], rtol=0, atol=0.01 * b)
    assert section.centroid[0] > 0 > section.shearCenter[0]


def test_an_angle():
    t = 0.002
    section = constants(beams.SectionL(0.1, 0.1, t))
    assert section.torsionConstant == pytest.approx((0.1 + 0.1 - t) * t**3 / 3, rel=0.01)
    np.testing.assert_allclose(section.shearCenter, t / 2, rtol=0, atol=0.1 * t)
    assert abs(section.principalAngle) == pytest.approx(np.pi / 4, rel=1e-9)
    fine = constants(beams.SectionL(0.1, 0.06, 0.01, 0.008), fineness=96)
    for fineness, tolerance in ((12, 3e-3), (24, 8e-4), (48, 3e-4)):
        section = constants(beams.SectionL(0.1, 0.06, 0.01, 0.008), fineness=fineness)
        assert section.torsionConstant == pytest.approx(fine.torsionConstant, rel=tolerance)
        np.testing.assert_allclose(section.shearFactors, fine.shearFactors, rtol=tolerance)
        np.testing.assert_allclose(section.shearCenter, fine.shearCenter, rtol=0, atol=tolerance * 0.01)


def test_a_square_box():
    """Bredt's formula for thin closed walls, and a hole that turns."""
    a, t = 0.1, 0.001
    hole = 0.5 * (a - 2 * t) * np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
    outer = 0.5 * a * np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
    section = constants(beams.SectionPolygon(outer, [hole]))
    same = constants(beams.SectionPolygon(outer[::-1], [hole[::-1]]))
    assert section.torsionConstant == pytest.approx(t * (a - t) ** 3, rel=0.02)
    assert same.torsionConstant == pytest.approx(section.torsionConstant, rel=1e-9)
    assert section.area == pytest.approx(a**2 - (a - 2 * t) ** 2, rel=1e-11)


def test_the_matrices_move_with_the_reference_point():
    outline = beams.SectionL(0.1, 0.06, 0.01)
    data = {"youngsModulus": 2e11, "poissonsRatio": 0.3, "density": 7800.0}
    centroid = beams.ComputeSectionConstants(outline, data)
    for point in ([0.02, -0.03], "shearCenter"):
        other = beams.ComputeSectionConstants(outline, data, referencePoint=point)
        y, z = other.referencePoint - centroid.centroid
        arm = np.array([[0, -z, y], [z, 0, 0], [-y, 0, 0]])  # r x
        motion = np.eye(6)  # of the centroid, for one of the other point
        motion[:3, 3:] = arm
        np.testing.assert_allclose(
            other.stiffnessMatrix, motion.T @ centroid.stiffnessMatrix @ motion, rtol=1e-9, atol=1e-2
        )
        np.testing.assert_allclose(other.massMatrix, motion.T @ centroid.massMatrix @ motion, rtol=1e-9, atol=1e-9)
    np.testing.assert_allclose(other.stiffnessMatrix[3, 1:3], 0, atol=1e-9 * other.stiffnessMatrix[1, 1])
    np.testing.assert_allclose(centroid.stiffnessMatrix[0, 4:], 0, atol=1e-9 * centroid.stiffnessMatrix[0, 0])
    assert np.linalg.eigvalsh(other.stiffnessMatrix).min() > 0


def test_a_round_section_has_a_diagonal_matrix():
    data = {"youngsModulus": 2e11, "poissonsRatio": 0.25, "density": 7800.0}
    section = beams.ComputeSectionConstants(beams.SectionCircle(0.01), data)
    area, inertia, k = np.pi * 1e-4, np.pi / 4 * 1e-8, section.shearFactors[0]
    expected = np.diag([2e11 * area, *[0.8e11 * area * k] * 2, 0.8e11 * 2 * inertia, *[2e11 * inertia] * 2])
    np.testing.assert_allclose(section.stiffnessMatrix, expected, rtol=2e-6, atol=1e-6 * expected[3, 3])
    np.testing.assert_allclose(
        np.diag(section.massMatrix), 7800 * np.array([*[area] * 3, 2 * inertia, inertia, inertia]), rtol=2e-6
    )
    item = section.BeamSection()
    assert item.massPerLength == pytest.approx(7800 * area, rel=1e-6)
    np.testing.assert_array_equal(item.stiffnessMatrix, section.stiffnessMatrix)
    np.testing.assert_array_equal(item.inertia, section.massMatrix[3:, 3:])
    geometry = section.BeamSectionGeometry()
    assert geometry.crossSectionType == exu.CrossSectionType.Polygon
    assert len(geometry.polygonalPoints) == 64


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (
            lambda: beams.SectionRectangle(0, 1),
            r"SectionRectangle: widthY: expected a positive length \(m\), received 0",
        ),
        (lambda: beams.SectionTube(1, 1), "innerRadius: expected a radius less than outerRadius=1, received 1"),
        (lambda: beams.SectionI(0.1, 0.1, 0.01, 0.05), "flangeThickness: expected less than half of height=0.1"),
        (lambda: beams.SectionI(0.1, 0.1, 0.2, 0.01), "webThickness: expected less than 0.1, the width"),
        (lambda: beams.SectionL(0.1, 0.1, 0.2), "expected less than the legs"),
        (lambda: beams.SectionPolygon([[0, 0], [1, 0]]), "points: expected at least 3 corners that enclose an area"),
        (lambda: beams.SectionPolygon([[0, 0], [1, 0], [1, 0], [0, 1]]), "points: expected corners without repetition"),
        (
            lambda: beams.SectionPolygon([[0, 0], [1, 0], [0, 1]], [[[2, 2], [3, 2], [2, 3]]]),
            r"holes\[0\]: expected corners inside of the outer boundary",
        ),
        (
            lambda: constants(beams.SectionPolygon([[0, 0], [2, 0], [0.5, 1], [2, 2], [0, 2], [1.5, 1]])),
            "crosses itself",
        ),
        (lambda: constants([1, 2]), r"outline: expected a section, such as SectionRectangle\(0.1, 0.2\)"),
        (lambda: constants(beams.SectionCircle(1), fineness=1), "fineness: expected a number of at least 4"),
        (
            lambda: constants(beams.SectionCircle(1), referencePoint="middle"),
            "referencePoint: expected 'centroid', 'shear",
        ),
        (lambda: constants(beams.SectionCircle(1), 0.7), "poissonsRatio: expected a number between -1 and 0.5"),
    ],
)
def test_wrong_sections(make, message):
    with pytest.raises(ValueError, match=message):
        make()
