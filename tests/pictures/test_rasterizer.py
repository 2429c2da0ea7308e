"""Drawings of the core: silhouettes have the areas and places that geometry gives, and the same bytes every time."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from dalembert import _core

FRONT = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0]  # to the right, up, away from the viewer
LIGHT = [([0, 0, -1], 0.6, 0.0)]
GREY = [0.5, 0.5, 0.5, 1]


def picture(width: int = 200, height: int = 200, samples: int = 1, scale: float = 50, **changes: Any) -> Any:
    values: dict[str, Any] = {"view": FRONT, "perspective": 0.0, "lights": LIGHT, "ambient": 0.4, "shininess": 32}
    return _core._Picture(width=width, height=height, samples=samples, scale=scale, **(values | changes))


def square(p: Any, x0: float, y0: float, x1: float, y1: float, z: float = 0, color: Any = GREY, item: int = 0) -> None:
    points = [[x0, y0, z], [x1, y0, z], [x1, y1, z], [x0, y1, z]]
    p.triangles(points, None, [color] * 4, [[0, 1, 2], [0, 2, 3]], [item, item])


def covered(p: Any) -> Any:
    p.develop()
    return p.items() >= 0


@pytest.mark.parametrize("radius", [0.3, 1.0, 1.9])
def test_area_of_a_sphere(radius: float) -> None:
    p = picture()
    p.spheres([[0.02, 0.01, 0.3]], [radius], [GREY], [7])
    seen = covered(p)
    # the error is that of counting pixels along the outline: a part of its length
    assert abs(seen.sum() - np.pi * (50 * radius) ** 2) < 0.3 * 2 * np.pi * 50 * radius
    rows, columns = np.nonzero(seen)
    assert columns.mean() + 0.5 == pytest.approx(100 + 50 * 0.02, abs=0.1)
    assert rows.mean() + 0.5 == pytest.approx(100 - 50 * 0.01, abs=0.1)
    assert set(p.items()[seen]) == {7}


def test_area_and_place_of_a_square() -> None:
    p = picture()
    square(p, -1, -0.5, 1, 0.5)
    seen = covered(p)
    assert seen.sum() == 100 * 50
    rows, columns = np.nonzero(seen)
    assert (columns.min(), columns.max(), rows.min(), rows.max()) == (50, 149, 75, 124)


def test_triangles_side_by_side_leave_no_gap_and_overlap_nowhere() -> None:
    """Sheets that are seen through would show both: each pixel is passed by one of them."""
    rng = np.random.default_rng(5)
    n = 12
    x, y = np.meshgrid(np.linspace(-1.5, 1.5, n), np.linspace(-1.5, 1.5, n))
    inner = np.zeros((n, n, 1))
    inner[1:-1, 1:-1] = 1
    points = np.stack([x, y, 0 * x], -1) + inner * rng.uniform(-0.1, 0.1, (n, n, 3)) * [1, 1, 0]
    index = np.arange(n * n).reshape(n, n)
    a, b, c, d = (k.ravel() for k in (index[:-1, :-1], index[:-1, 1:], index[1:, 1:], index[1:, :-1]))
    triangles = np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])
    p = picture(lights=[], ambient=1.0)
    p.background([1, 1, 1, 1], [1, 1, 1, 1])
    p.triangles(points.reshape(-1, 3), None, np.tile([0, 0, 0, 0.5], (n * n, 1)), triangles, np.zeros(len(triangles)))
    image = p.develop()
    assert set(image[25:175, 25:175, 0].ravel()) == {128}  # half of white, once
    assert (image[:, :24] == 255).all()


def test_near_objects_hide_far_ones_in_any_order() -> None:
    for order in ((0, 1), (1, 0)):
        p = picture()
        for k in order:
            square(p, -1, -1, 1 - k, 1, z=float(k), item=k)
        p.develop()
        assert p.items()[100, 60] == 1  # the one with the larger z, towards the viewer
        assert p.items()[100, 140] == 0


def test_surfaces_that_cut_each_other_meet_in_a_line() -> None:
    p = picture()
    square(p, -1, -1, 1, 1, z=0.0, item=0)
    points = [[-1, -1, -1], [1, -1, 1], [1, 1, 1], [-1, 1, -1]]  # z = x
    p.triangles(points, None, [GREY] * 4, [[0, 1, 2], [0, 2, 3]], [1, 1])
    p.develop()
    row = p.items()[100]
    assert (row[50:99] == 0).all() and (row[101:150] == 1).all()


def test_brightness_follows_the_cosine() -> None:
    """Ambient 0.4 and 0.6 times the cosine between normal and light, of a color of 0.5."""
    for angle in (0.0, 0.5, 1.0, 1.3):
        p = picture()
        c, s = np.cos(angle), np.sin(angle)
        points = [[-c, -1, -s], [c, -1, s], [c, 1, s], [-c, 1, -s]]
        p.triangles(points, None, [GREY] * 4, [[0, 1, 2], [0, 2, 3]], [0, 0])
        assert int(p.develop()[100, 100, 0]) == pytest.approx(255 * 0.5 * (0.4 + 0.6 * c), abs=1)


def test_both_sides_of_a_face_are_lit() -> None:
    for triangles in ([[0, 1, 2]], [[0, 2, 1]]):
        p = picture()
        p.triangles([[-1, -1, 0], [1, -1, 0], [0, 1, 0]], None, [GREY] * 3, triangles, [0])
        assert int(p.develop()[110, 100, 0]) == pytest.approx(127.5, abs=1)


def test_perspective_makes_far_things_smaller() -> None:
    """An object at twice the distance of the viewer from the center has half the size."""
    for z, size in ((0.0, 100), (-4.0, 50)):
        p = picture(perspective=0.25)
        square(p, -1, -1, 1, 1, z=z)
        seen = covered(p)
        assert np.count_nonzero(seen[100]) == pytest.approx(size, abs=1)


def test_perspective_divides_depth_too() -> None:
    """A floor to the horizon: the middle of a line is not in the middle of the picture."""
    p = picture(perspective=0.5, lights=[], ambient=1.0)
    points = [[-1, -1, 0], [1, -1, 0], [1, -1, -8], [-1, -1, -8]]
    p.triangles(points, None, [[0, 0, 0, 1], [0, 0, 0, 1], [1, 1, 1, 1], [1, 1, 1, 1]], [[0, 1, 2], [0, 2, 3]], [0, 0])
    image = p.develop()
    z = 3.0
    row = int(100 + 50 / (1 + 0.5 * z))
    assert image[row, 100, 0] == pytest.approx(255 * z / 8, abs=6)


def test_objects_behind_the_viewer_are_clipped() -> None:
    p = picture(perspective=0.5)
    p.triangles([[-1, -1, 50], [1, -1, 50], [0, -1, -8]], None, [GREY] * 3, [[0, 1, 2]], [0])
    seen = covered(p)
    # row 199.5 is 99.5 pixels below the middle, where 1 + 0.5 z = 50 / 99.5; there the triangle is as wide as its place between base and tip
    weight = 50 / 99.5
    wide = 2 * 50 / weight * (8 - 2 * (weight - 1)) / 58
    assert np.count_nonzero(seen[199]) == pytest.approx(wide, abs=1)
    assert not seen[:100].any()


def test_clipping_plane() -> None:
    p = picture()
    p.clip([-1, 0, 0, 0.5])  # x <= 0.5
    square(p, -1, -1, 1, 1)
    p.lines([[-1, 1.2, 0, 1, 1.2, 0]], [GREY], 1, 0, [3])
    seen = covered(p)
    assert np.nonzero(seen[100])[0].max() == pytest.approx(100 + 25 - 1, abs=1)
    assert np.nonzero(seen[38:42].any(axis=0))[0].max() == pytest.approx(100 + 25 - 1, abs=1)


@pytest.mark.parametrize("end", [[1, 0], [0, 1], [1, 1], [-1, 0.3], [0.2, -1]])
def test_width_of_lines(end: list[float]) -> None:
    p = picture(samples=4)
    p.lines([[0, 0, 0, *end, 0]], [[0, 0, 0, 1]], 3.0, 0.0, [0])
    dark = (255 - p.develop()[..., 0].astype(float)).sum() / 255
    length = 50 * np.hypot(*end)
    assert dark == pytest.approx(3 * (length + 1.5), rel=0.08)


def test_lines_on_faces_are_seen_on_one_side() -> None:
    for z, seen in ((0.0, True), (-0.2, False)):
        p = picture()
        square(p, -1, -1, 1, 1, item=0)
        p.lines([[-0.5, 0, z, 0.5, 0, z]], [[0, 0, 0, 1]], 2, 0.05, [1])
        p.develop()
        assert bool(p.items()[100, 100] == 1) is seen


def test_samples_smooth_edges() -> None:
    p = picture(samples=4, lights=[], ambient=1.0)
    p.background([1, 1, 1, 1], [1, 1, 1, 1])
    points = [[-1, -1, 0], [1, -1, 0], [1, 0.7, 0]]
    p.triangles(points, None, [[0, 0, 0, 1]] * 3, [[0, 1, 2]], [0])
    image = p.develop()[..., 0]
    assert len(set(image.ravel())) > 4
    assert (255.0 - image).sum() / 255 == pytest.approx(100 * 85 / 2, rel=0.01)


def test_sheets_are_blended_from_the_back_to_the_front() -> None:
    for order in ((0, 1), (1, 0)):
        p = picture(lights=[], ambient=1.0)
        p.background([0, 0, 0, 1], [0, 0, 0, 1])
        for k in order:
            square(p, -1, -1, 1, 1, z=float(k), color=[1 - k, k, 0, 0.5])
        red, green, _ = (int(v) for v in p.develop()[100, 100])
        assert (red, green) == (pytest.approx(64, abs=1), pytest.approx(128, abs=1))


def curved(p: Any, tiles: int = 12) -> None:
    """A part of a sphere as a smooth mesh with colors that change."""
    x, y = np.meshgrid(np.linspace(-1, 1, tiles), np.linspace(-1, 1, tiles))
    points = np.stack([x, y, np.sqrt(4 - x**2 - y**2)], -1).reshape(-1, 3)
    colors = np.stack([0.5 + 0.3 * x, 0.5 + 0.3 * y, 0.5 + 0 * x, 1 + 0 * x], -1).reshape(-1, 4)
    index = np.arange(tiles * tiles).reshape(tiles, tiles)
    a, b, c, d = (k.ravel() for k in (index[:-1, :-1], index[:-1, 1:], index[1:, 1:], index[1:, :-1]))
    triangles = np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])
    p.triangles(points, points / 2, colors, triangles, np.zeros(len(triangles)))


@pytest.mark.parametrize("samples", [2, 3, 4])
def test_shading_does_not_depend_on_the_number_of_samples(samples: int) -> None:
    """Samples of one pixel share a color and a light; it is that of its middle."""
    lights = [([0.0, 0.3, -0.95], 0.5, 0.4)]
    images = []
    for n in (1, samples):
        p = picture(samples=n, lights=lights)
        curved(p)
        images.append(p.develop()[55:145, 55:145].astype(int))
    assert np.abs(images[0] - images[1]).max() <= 2
    assert np.ptp(images[0]) > 60


def test_faces_that_meet_in_a_pixel_are_lit_by_themselves() -> None:
    """A roof with its ridge in the middle of a pixel: half of its samples have the brightness of each side."""
    p = picture(samples=2, lights=[([0.8, 0.0, -0.6], 0.6, 0.0)], width=201)
    for side in (-1.0, 1.0):
        points = [[0, -1, 1], [0, 1, 1], [side, 1, 0], [side, -1, 0]]
        p.triangles(points, None, [GREY] * 4, [[0, 1, 2], [0, 2, 3]], [0, 0])
    row = p.develop()[100, :, 0].astype(int)
    dark, bright = row[80], row[120]
    assert bright - dark > 40
    assert row[100] == pytest.approx((dark + bright) / 2, abs=1)


def test_rims_of_items_are_darker() -> None:
    p = picture(samples=2)
    square(p, -1, -1, 1, 1, z=0.0, item=0)
    square(p, -0.5, -0.5, 0.5, 0.5, z=0.5, item=1)
    image = p.develop()[..., 0].astype(int)
    assert image[100, 75] == pytest.approx(
        0.75 * image[100, 100], abs=1
    )  # the object in front: half a pixel, half as bright
    assert image[100, 76] == image[100, 100] == image[100, 60]


def test_same_bytes_every_time() -> None:
    def drawn() -> bytes:
        rng = np.random.default_rng(1)
        p = picture(samples=2)
        points = rng.uniform(-1.5, 1.5, (300, 3))
        colors = rng.uniform(0, 1, (300, 4))
        p.triangles(points, rng.normal(size=(300, 3)), colors, np.arange(300).reshape(-1, 3), np.arange(100))
        p.spheres(points, np.full(300, 0.05), colors, np.arange(300))
        return bytes(p.develop())

    assert drawn() == drawn()


def test_wrong_arrays_are_refused() -> None:
    p = picture()
    with pytest.raises(IndexError, match="there is no point 3"):
        p.triangles(np.zeros((3, 3)), None, np.zeros((3, 4)), [[0, 1, 3]], [0])
    with pytest.raises(ValueError, match="colors: expected 12 numbers, received 8"):
        p.triangles(np.zeros((3, 3)), None, np.zeros((2, 4)), [[0, 1, 2]], [0])
    with pytest.raises(ValueError, match="1 to 32768 samples"):
        picture(width=0)


def test_points_that_are_nowhere_are_not_drawn() -> None:
    p = picture()
    for value in (np.nan, np.inf, 1e300, -1e300):
        p.triangles([[value, 0, 0], [1, 0, 0], [0, 1, 0]], None, [GREY] * 3, [[0, 1, 2]], [0])
        p.spheres([[value, 0, 0]], [1], [GREY], [0])
        p.lines([[value, 0, 0, 1, 1, 0]], [GREY], 2, 0, [0])
    assert not covered(p).any()


def test_many_spheres_are_drawn_as_few_are() -> None:
    """A thousand or more are drawn in another order; the nearest is seen in any."""
    rng = np.random.default_rng(3)
    n = 1200
    centers, radii = rng.uniform(-2, 2, (n, 3)), rng.uniform(0.02, 0.3, n)
    colors = np.column_stack([rng.uniform(0, 1, (n, 3)), np.ones(n)])
    images = []
    for step in (n, n // 3):
        p = picture(samples=2, perspective=0.1)
        for k in range(0, n, step):
            part = slice(k, k + step)
            p.spheres(centers[part], radii[part], colors[part], np.arange(n)[part])
        images.append((p.develop(), p.items()))
    np.testing.assert_array_equal(images[0][0], images[1][0])
    np.testing.assert_array_equal(images[0][1], images[1][1])
    assert len(np.unique(images[0][1])) > 100


@pytest.mark.parametrize(
    ("scale", "changes", "plane"),
    [(50, {}, None), (400, {}, None), (300, {"perspective": 0.5}, None), (80, {}, [0.3, 0.2, 1, 0])],
    ids=["whole", "inside", "perspective", "cut open"],
)
def test_triangles_that_others_hide_are_left_out(scale: float, changes: Any, plane: Any) -> None:
    """If there are very many, back faces are skipped where everything is covered: the picture is that of few at a
    time."""
    n = 120
    u, v = np.meshgrid(np.linspace(0, 2 * np.pi, n), np.linspace(0, np.pi, n // 2), indexing="ij")
    points = np.stack([np.cos(u) * np.sin(v), np.sin(u) * np.sin(v), np.cos(v)], -1).reshape(-1, 3)
    colors = np.column_stack([0.5 + 0.5 * points, np.ones(len(points))])
    index = np.arange(n * (n // 2)).reshape(n, n // 2)
    a, b, c, d = (k.ravel() for k in (index[:-1, :-1], index[1:, :-1], index[1:, 1:], index[:-1, 1:]))
    triangles = np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])
    images = []
    for step in (len(triangles), 400):
        p = picture(samples=2, scale=scale, **changes)
        if plane is not None:
            p.clip(plane)
        for k in range(0, len(triangles), step):
            part = triangles[k : k + step]
            p.triangles(points, points, colors, part, np.arange(k, k + len(part)))
        images.append((p.develop(), p.items()))
    # a triangle is shaded in the middle of the samples that it wins, before others may take some of them
    np.testing.assert_allclose(images[0][0].astype(int), images[1][0].astype(int), atol=2)
    np.testing.assert_array_equal(images[0][1], images[1][1])
    assert len(np.unique(images[0][1])) > 100


@pytest.mark.parametrize("samples", [2, 3])
def test_small_triangles_leave_no_gap_and_have_their_area(samples: int) -> None:
    """Two samples in each direction are covered side by side, others one by one: a patch of triangles of a pixel or less, turned."""
    n, side, angle = 60, 0.8, 0.3
    x, y = (side * (2 * k / (n - 1) - 1) for k in np.meshgrid(np.arange(n), np.arange(n)))
    points = np.stack([x * np.cos(angle) - y * np.sin(angle), x * np.sin(angle) + y * np.cos(angle), 0 * x], -1)
    index = np.arange(n * n).reshape(n, n)
    a, b, c, d = (k.ravel() for k in (index[:-1, :-1], index[:-1, 1:], index[1:, 1:], index[1:, :-1]))
    triangles = np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])
    p = picture(samples=samples, lights=[], ambient=1.0)
    p.background([1, 1, 1, 1], [1, 1, 1, 1])
    p.triangles(points.reshape(-1, 3), None, np.tile([0, 0, 0, 1.0], (n * n, 1)), triangles, np.zeros(len(triangles)))
    dark = (255 - p.develop()[..., 0].astype(float)) / 255
    # the error is that of counting samples along the outline: a part of its length
    assert abs(dark.sum() - (100 * side) ** 2) < 0.3 * 8 * 50 * side / samples
    rows, columns = np.mgrid[0:200, 0:200] + 0.5 - 100
    inner = (
        np.maximum(
            abs(columns * np.cos(angle) - rows * np.sin(angle)), abs(columns * np.sin(angle) + rows * np.cos(angle))
        )
        < 50 * side - 1
    )
    assert (dark[inner] == 1).all()
