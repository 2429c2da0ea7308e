"""The ray tracer: shadows, mirror images and refraction are where geometry has them, and settings have their effect."""

from __future__ import annotations

from operator import attrgetter
from typing import Any

import numpy as np
import pytest

import dalembert as exu
from dalembert import _core, graphics

FRONT = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0]  # to the right, up, away from the viewer
GREY = [0.5, 0.5, 0.5, 1]
MATT = ([0, 0, 0], [0, 0, 0], 1.0, 0.0, 1.0)  # specular, emission, shininess, reflectivity, index of refraction
MIRROR = ([0, 0, 0], [0, 0, 0], 1.0, 1.0, 1.0)
GLASS = ([0, 0, 0], [0, 0, 0], 1.0, 0.0, 1.5)
BLACK = [0, 0, 0, 1]
WHITE = [1, 1, 1, 1]


def light(place: Any, far: bool = True, shadow: float = 0.0, radius: float = 0.0, fading: Any = (1, 0, 0)) -> Any:
    """A light in coordinates of the scene of FRONT, whose third axis points towards the viewer."""
    place = np.asarray(place, float) * [1, 1, -1]
    return (place / np.linalg.norm(place) if far else place, far, [0.6, 0.0, shadow, radius], fading)


def tracer(lights: Any = (), size: int = 200, scale: float = 50, perspective: float = 0.0, **changes: Any) -> Any:
    options = _core._RayOptions()
    options.ambient = 0.4 if lights else 1.0
    for name, value in changes.items():
        setattr(options, name, value)
    return _core._RayTracer(size, size, FRONT, scale, perspective, list(lights), [MATT, MIRROR, GLASS], options)


def quad(t: Any, corners: Any, color: Any = GREY, material: int = 0) -> None:
    t.triangles(corners, None, [color] * 4, [[0, 1, 2], [0, 2, 3]], [material] * 2)


def floor(t: Any, half: float = 9.0, z: float = 0.0, color: Any = GREY) -> None:
    quad(t, [[-half, -half, z], [half, -half, z], [half, half, z], [-half, half, z]], color)


def places(seen: Any, scale: float) -> tuple[float, float, float]:
    """Area and center of the visible part, in lengths of the scene."""
    rows, columns = np.nonzero(seen)
    size = len(seen)
    return seen.sum() / scale**2, (columns.mean() + 0.5 - size / 2) / scale, (size / 2 - rows.mean() - 0.5) / scale


@pytest.mark.parametrize("radius", [0.3, 1.0, 1.9])
def test_area_of_a_sphere(radius: float) -> None:
    t = tracer()
    t.spheres([[0.02, 0.01, 0.3]], [radius], [GREY])
    area, x, y = places(t.develop()[..., 0] < 200, 50)
    # the error is that of counting pixels along the outline: a part of its length
    assert abs(area - np.pi * radius**2) < 0.3 * 2 * np.pi * radius / 50
    assert (x, y) == (pytest.approx(0.02, abs=0.002), pytest.approx(0.01, abs=0.002))


def test_area_of_a_sphere_in_perspective() -> None:
    """The cone of rays that touch it: its radius in the plane through the center of the view is r / sqrt(1 - r^2 p^2)."""
    t = tracer(perspective=0.5)
    t.spheres([[0, 0, 0]], [1.0], [GREY])
    area, _, _ = places(t.develop()[..., 0] < 200, 50)
    seen = 1 / np.sqrt(1 - 0.25)
    assert abs(area - np.pi * seen**2) < 0.3 * 2 * np.pi * seen / 50


@pytest.mark.parametrize("end", [[1, 0], [0, 1], [-1, 0.3]])
def test_lines_are_as_wide_as_they_say(end: list[float]) -> None:
    t = tracer()
    t.lines([[0, 0, 0, *end, 0]], [BLACK], 8.0)
    area, _, _ = places(t.develop()[..., 0] < 128, 50)
    length, radius = np.hypot(*end), 0.08
    assert abs(area - (2 * radius * length + np.pi * radius**2)) < 0.3 * (2 * length + 2 * np.pi * radius) / 50


def test_brightness_follows_the_cosine() -> None:
    for angle in (0.0, 0.5, 1.0, 1.3):
        t = tracer([light([0, 0, 1])])
        c, s = np.cos(angle), np.sin(angle)
        quad(t, [[-c, -1, -s], [c, -1, s], [c, 1, s], [-c, 1, -s]])
        assert int(t.develop()[100, 100, 0]) == pytest.approx(255 * 0.5 * (0.4 + 0.6 * c), abs=1)


def test_shadow_of_a_sphere_by_a_light_at_infinity() -> None:
    """An ellipse: the cylinder of rays that touch the sphere meets the floor at 45 degrees."""
    radius, height, scale = 0.3, 2.0, 25
    t = tracer([light([1, 0, 1], shadow=1)], scale=scale)
    floor(t)
    t.spheres([[1, 0.5, height]], [radius], [WHITE])
    image = t.develop()[..., 0]
    dark = image == round(255 * 0.5 * 0.4)
    area, x, y = places(dark, scale)
    assert abs(area - np.pi * radius**2 * np.sqrt(2)) < 0.3 * 2 * np.pi * 1.2 * radius / scale
    assert (x, y) == (pytest.approx(1 - height, abs=0.01), pytest.approx(0.5, abs=0.01))
    assert image[100, 40] == pytest.approx(255 * 0.5 * (0.4 + 0.6 * np.sqrt(0.5)), abs=1)  # outside, at x = -2.4


def test_shadow_of_a_sphere_by_a_lamp() -> None:
    """A disc: the cone of rays that touch the sphere, cut by the floor; half as dark if half the light is taken."""
    radius, height, lamp, scale = 0.3, 1.0, 2.0, 50
    t = tracer([light([0, 0, lamp], far=False, shadow=0.5)], scale=scale)
    floor(t)
    t.spheres([[0, 0, height]], [radius], [WHITE])
    image = t.develop()[..., 0].astype(float)
    edge = lamp * np.tan(np.arcsin(radius / (lamp - height)))
    rows, columns = np.mgrid[0:200, 0:200] + 0.5 - 100
    away = np.hypot(rows, columns) / scale
    cosine = lamp / np.hypot(lamp, away)
    expected = 255 * 0.5 * (0.4 + 0.6 * cosine * np.where(away < edge, 0.5, 1.0))
    clear = (abs(away - edge) > 1.5 / scale) & (away > radius + 1.5 / scale)
    assert np.abs(image - expected)[clear].max() <= 1
    assert (clear & (away < edge)).sum() > 1000


def test_soft_shadows_are_as_wide_as_the_light() -> None:
    """Behind an edge at height h, light that is 2 r wide at distance 1 fades over 2 r h; a half of it passes in the middle."""
    radius, height, scale = 0.2, 1.5, 50
    t = tracer([light([0, 0, 1], shadow=1, radius=radius)], scale=scale, light_places=256)
    floor(t)
    quad(t, [[0, -9, height], [9, -9, height], [9, 9, height], [0, 9, height]], color=[1, 1, 1, 1])
    row = t.develop()[100, :100, 0].astype(float)  # x < 0: the floor
    part = (row / (255 * 0.5) - 0.4) / 0.6  # part of the light that passes
    x = -(np.arange(100) + 0.5 - 100) / scale / (radius * height)  # distance from the edge, in radii of the light
    passing = 1 - np.where(x < 1, (np.arccos(np.minimum(x, 1)) - x * np.sqrt(np.maximum(1 - x**2, 0))) / np.pi, 0)
    # 256 places on a disc: a strip of it holds a 256th more or less, and some of those at its two ends
    assert np.abs(part - passing).max() < 0.03
    assert part[99] == pytest.approx(0.5, abs=0.05)


def test_a_mirror_reflects_its_neighbour() -> None:
    """A mirror at 45 degrees: an object at height z to the right of it appears at x = -z, in the same size."""
    t = tracer(around=[0, 0, 0])
    quad(t, [[-1.5, -1.5, 1.5], [1.5, -1.5, -1.5], [1.5, 1.5, -1.5], [-1.5, 1.5, 1.5]], BLACK, 1)
    t.spheres([[5, 0.3, 0.4]], [0.5], [WHITE])
    seen = t.develop()[..., 0] > 128
    seen[:25], seen[175:], seen[:, :25], seen[:, 175:] = False, False, False, False  # the background around the mirror
    area, x, y = places(seen, 50)
    assert abs(area - np.pi * 0.25) < 0.3 * np.pi / 50
    assert (x, y) == (pytest.approx(-0.4, abs=0.005), pytest.approx(0.3, abs=0.005))


@pytest.mark.parametrize(("reflections", "seen"), [(0, 51), (1, 102), (2, 255)])
def test_mirrors_reflect_as_often_as_is_asked(reflections: int, seen: int) -> None:
    """Down to a mirror, to the right to another one, up to a white sheet; a mirror that ends the way has its own color."""
    t = tracer(reflections=reflections)
    quad(t, [[-1, -1, 1], [1, -1, -1], [1, 1, -1], [-1, 1, 1]], [0.2, 0.2, 0.2, 1], 1)
    quad(t, [[2, -1, -1], [4, -1, 1], [4, 1, 1], [2, 1, -1]], [0.4, 0.4, 0.4, 1], 1)
    quad(t, [[2.5, -1, 5], [3.5, -1, 5], [3.5, 1, 5], [2.5, 1, 5]], WHITE)
    assert int(t.develop()[100, 100, 0]) == seen


def test_glass_shifts_the_background() -> None:
    """A slab of thickness d, turned by a: rays leave it parallel, with an offset of d sin(a - b) / cos(b), n sin b =
    sin a."""
    thickness, angle, index, scale = 0.8, 0.6, 1.5, 50
    edges = []
    for material, opacity in ((2, 0.0), (0, 0.0)):
        t = tracer(scale=scale, transparencies=4)
        quad(t, [[-9, -9, -3], [0, -9, -3], [0, 9, -3], [-9, 9, -3]], BLACK)
        along, normal = np.array([np.cos(angle), 0, np.sin(angle)]), np.array([-np.sin(angle), 0, np.cos(angle)])
        for side in (0.5, -0.5):  # both with normals to the outside
            a, b = -2 * along, 2 * along
            if side < 0:
                a, b = b, a
            corners = [a + [0, -3, 0], b + [0, -3, 0], b + [0, 3, 0], a + [0, 3, 0]]
            quad(t, np.array(corners) + side * thickness * normal, [0, 0, 0, opacity], material)
        row = t.develop()[100, :, 0] > 128
        edges.append((np.argmax(row[30:]) + 30 - 100) / scale)
    inside = np.arcsin(np.sin(angle) / index)
    shift = thickness * np.sin(angle - inside) / np.cos(inside)
    assert edges[1] == pytest.approx(0, abs=1 / scale)
    assert abs(edges[0]) == pytest.approx(shift, abs=1.01 / scale)


def test_sheets_let_light_pass() -> None:
    """A half-transparent object: half of the background is visible, and half of the light passes."""
    t = tracer([light([0, 0, 1], shadow=1)])
    floor(t)
    quad(t, [[-1, -1, 1], [1, -1, 1], [1, 1, 1], [-1, 1, 1]], [0, 0, 0, 0.5])
    image = t.develop()[..., 0]
    assert int(image[100, 100]) == pytest.approx(255 * 0.5 * 0.5 * (0.4 + 0.5 * 0.6), abs=1)
    assert int(image[100, 20]) == pytest.approx(255 * 0.5, abs=1)
    t = tracer(transparencies=0)
    floor(t)
    quad(t, [[-1, -1, 1], [1, -1, 1], [1, 1, 1], [-1, 1, 1]], [0, 0, 0, 0.5])
    assert int(t.develop()[100, 100, 0]) == 0  # rays that pass no sheet end there


def test_lamps_fade_with_distance() -> None:
    for fading, part in (((1, 0, 0), 1.0), ((1, 0.5, 0), 0.5), ((1, 0, 0.25), 0.5), ((0, 0, 1), 0.25)):
        t = tracer([light([0.01, 0.01, 2], far=False, fading=fading)])
        floor(t)
        assert int(t.develop()[100, 100, 0]) == pytest.approx(255 * 0.5 * (0.4 + 0.6 * part), abs=1)


def test_fog_hides_far_objects() -> None:
    t = tracer(fog=[1, 1, 1], fog_density=0.3)
    quad(t, [[-1, -1, 2], [0, -1, 2], [0, 1, 2], [-1, 1, 2]], BLACK)
    quad(t, [[0, -1, -1], [1, -1, -1], [1, 1, -1], [0, 1, -1]], BLACK)
    near, far = (int(t_) for t_ in t.develop()[100, [75, 125], 0])
    assert near == pytest.approx(0, abs=1) and far == pytest.approx(255 * (1 - np.exp(-0.9)), abs=1)


def test_clipping_shows_the_inner_side() -> None:
    t = tracer([light([0, 0, 1])])
    t.clip([0, 0, 1, 0])  # a point farther away than the center
    t.spheres([[0, 0, 0]], [1.0], [GREY])
    image = t.develop()[..., 0]
    area, _, _ = places(image < 200, 50)
    assert abs(area - np.pi) < 0.3 * 2 * np.pi / 50
    assert int(image[100, 100]) == pytest.approx(127.5, abs=1)  # its bottom faces the viewer


def crowd(threads: int, tiles: int) -> bytes:
    rng = np.random.default_rng(7)
    t = tracer(
        [light([1, 2, 3], shadow=0.7, radius=0.1)],
        size=64,
        scale=16,
        threads=threads,
        tiles_per_thread=tiles,
        samples=2,
    )
    points, colors = rng.uniform(-1.5, 1.5, (90, 3)), rng.uniform(0, 1, (90, 4))
    t.triangles(points, rng.normal(size=(90, 3)), colors, np.arange(90).reshape(-1, 3), np.arange(30) % 3)
    t.spheres(rng.uniform(-1.5, 1.5, (20, 3)), rng.uniform(0.05, 0.4, 20), rng.uniform(0, 1, (20, 4)))
    t.lines(rng.uniform(-1.5, 1.5, (10, 6)), rng.uniform(0, 1, (10, 4)), 2.0)
    return bytes(t.develop())


def test_same_bytes_with_any_number_of_threads() -> None:
    assert len({crowd(1, 12), crowd(2, 12), crowd(3, 1), crowd(1, 1)}) == 1


def test_wrong_arrays_are_refused() -> None:
    t = tracer()
    with pytest.raises(IndexError, match="there is no point 3"):
        t.triangles(np.zeros((3, 3)), None, np.zeros((3, 4)), [[0, 1, 3]], [0])
    with pytest.raises(IndexError, match="there is no material 3"):
        t.triangles(np.zeros((3, 3)), None, np.zeros((3, 4)), [[0, 1, 2]], [3])


# ---- the settings


def scene(SC: Any, mbs: Any) -> Any:
    """A floor that reflects, and things of several materials above it."""
    chrome, red = graphics.material.indexChrome, [1, 0, 0, 1]
    board = graphics.CheckerBoard(point=[0, 0, -0.6], size=6, nTiles=4, color=[0.9, 0.9, 0.9, chrome])
    glass = graphics.Sphere(point=[-0.8, -1.2, 0.2], radius=0.5, color=graphics.material.glass, nTiles=12)
    brick = graphics.Brick(centerPoint=[0.5, 0, 0], size=[0.9, 0.7, 0.6], color=red, addEdges=True)
    sheet = graphics.Brick(centerPoint=[0.2, -1.5, 0.3], size=[0.8, 0.02, 0.8], color=graphics.material.transparent)
    mbs.CreateGround(graphicsDataList=[board, glass, brick, sheet, graphics.Text(point=[0, 0, 1], text="here")])
    mbs.Assemble()
    settings = SC.visualizationSettings
    settings.view0.window.renderWindowSize = [120, 90]
    settings.openGL.light0.shadow = 0.5
    settings.openGL.light1.position = [2, -3, 4, 1]
    SC.renderer.SetModelView(2.5, [-1.0, 0, 0])
    return settings


CHANGES = {
    "raytracer.globalFogDensity": 0.5,
    "raytracer.imageSizeFactor": 2,
    "raytracer.maxReflectionDepth": 0,
    "raytracer.maxTransparencyDepth": 0,
    "raytracer.multiSampling": 2,
    "raytracer.advanced.backgroundColorReflections": [1.0, 0.0, 0.0, 1.0],
    "raytracer.advanced.showText": False,
    "raytracer.advanced.zBiasLines": 0.3,
    "raytracer.material4.reflectivity": 0.9,
    "raytracer.material6.alpha": 0.9,
    "raytracer.material7.baseColor": [0.0, 0.5, 0.0],
    "raytracer.material7.emission": [0.5, 0.0, 0.0],
    "raytracer.material7.ior": 1.0,
    "raytracer.material7.shininess": 2.0,
    "raytracer.material7.specular": [0.0, 0.0, 0.0],
    "openGL.light0.shadow": 0.0,
    "openGL.light1.useCameraFrame": True,
    "openGL.light1.constantAttenuation": 2.0,
    "openGL.light1.linearAttenuation": 1.0,
    "openGL.light1.quadraticAttenuation": 1.0,
}


def change(settings: Any, path: str, value: Any) -> None:
    group, _, name = path.rpartition(".")
    setattr(attrgetter(group)(settings), name, value)


def test_settings_have_their_effect(SC: Any, mbs: Any) -> None:
    settings = scene(SC, mbs)
    usual = {path: attrgetter(path)(settings) for path in CHANGES}
    before = SC.renderer.RedrawAndGetImage(useRaytracer=True)
    for path, value in CHANGES.items():
        change(settings, path, value)
        after = SC.renderer.RedrawAndGetImage(useRaytracer=True)
        assert after.shape != before.shape or np.abs(after.astype(int) - before).max() > 8, path
        change(settings, path, usual[path])
    np.testing.assert_array_equal(SC.renderer.RedrawAndGetImage(useRaytracer=True), before)
    settings.raytracer.numberOfThreads, settings.raytracer.advanced.tilesPerThread = 1, 3
    np.testing.assert_array_equal(SC.renderer.RedrawAndGetImage(useRaytracer=True), before)
    settings.raytracer.globalFogDensity = 0.5
    foggy = SC.renderer.RedrawAndGetImage(useRaytracer=True)
    settings.raytracer.globalFogColor = [1.0, 1.0, 0.0, 1.0]
    assert np.abs(SC.renderer.RedrawAndGetImage(useRaytracer=True).astype(int) - foggy).max() > 8


def others(value: Any) -> list[Any]:
    """Other values of a setting of a material."""
    if isinstance(value, list):
        return [[1 - part for part in value], [0.5 * part + 0.3 for part in value]]
    return [0.5 * value + 0.7, 0.2 * value, 3 * value + 0.5]


@pytest.mark.parametrize("number", range(10))
def test_each_setting_of_each_material_has_its_effect(SC: Any, mbs: Any, number: int) -> None:
    """A ball of the material, which can be seen through, in front of a checkerboard."""
    board = graphics.CheckerBoard(
        point=[0, 0, -1.5], size=4, nTiles=5, color=[0.9, 0.2, 0.2, 1], alternatingColor=[0.1, 0.3, 0.9, 1]
    )
    ball = graphics.Sphere(radius=1, color=[-1, 0, 0, graphics.material.indexBase + number], nTiles=24)
    mbs.CreateGround(graphicsDataList=[board, ball])
    mbs.Assemble()
    settings = SC.visualizationSettings
    settings.view0.window.renderWindowSize = [90, 80]
    SC.renderer.SetModelView(1.5, [0, 0, 0])
    material = getattr(settings.raytracer, f"material{number}")
    material.alpha, material.emission = min(material.alpha, 0.6), [0.1, 0.1, 0.1]  # nothing is as bright as it can be
    usual = material.GetDictionary()
    before = SC.renderer.RedrawAndGetImage(useRaytracer=True)
    assert set(usual) == {"name", "baseColor", "specular", "emission", "shininess", "reflectivity", "alpha", "ior"}
    for name in sorted(set(usual) - {"name"}):
        changes = []
        for value in others(usual[name]):
            setattr(material, name, value)
            changes.append(np.abs(SC.renderer.RedrawAndGetImage(useRaytracer=True).astype(int) - before).max())
        assert max(changes) > 2, name
        setattr(material, name, usual[name])
    np.testing.assert_array_equal(SC.renderer.RedrawAndGetImage(useRaytracer=True), before)


def test_it_reports_progress_on_request(SC: Any, mbs: Any, capfd: Any) -> None:
    scene(SC, mbs)
    for verbose in (0, 1):
        SC.visualizationSettings.raytracer.verbose = verbose
        SC.renderer.RedrawAndGetImage(useRaytracer=True)
        told = [line for line in capfd.readouterr().out.splitlines() if line.startswith("ray tracer:")]
        assert len(told) == verbose and all("pixels" in line and "shapes" in line for line in told)


def test_lights_have_a_size(SC: Any, mbs: Any) -> None:
    settings = scene(SC, mbs)
    settings.openGL.light0.lightRadius, settings.raytracer.lightRadiusVariations = 2.0, 9
    soft = SC.renderer.RedrawAndGetImage(useRaytracer=True)
    for path, value in (("raytracer.lightRadiusVariations", 1), ("openGL.light0.lightRadius", 0.0)):
        settings.openGL.light0.lightRadius, settings.raytracer.lightRadiusVariations = 2.0, 9
        change(settings, path, value)
        assert np.abs(SC.renderer.RedrawAndGetImage(useRaytracer=True).astype(int) - soft).max() > 8, path


def test_a_light_casts_shadows_or_not(SC: Any, mbs: Any) -> None:
    """Settings that were chosen for other renderers give the strength of shadows, which is physical here."""
    settings, images = scene(SC, mbs), []
    for shadow in (0.01, 0.5, 1.0):
        settings.openGL.light0.shadow = shadow
        images.append(SC.renderer.RedrawAndGetImage(useRaytracer=True))
    np.testing.assert_array_equal(images[0], images[1])
    np.testing.assert_array_equal(images[0], images[2])


def test_materials_of_the_renderer_come_before_those_of_the_settings(SC: Any, mbs: Any) -> None:
    settings = scene(SC, mbs)
    material = SC.renderer.materials.Get("glass")
    material.baseColor = [0.0, 0.0, 1.0]
    SC.renderer.materials.Set("glass", material)
    blue = SC.renderer.RedrawAndGetImage(useRaytracer=True)
    settings.raytracer.material7.baseColor = [1.0, 0.0, 0.0]
    np.testing.assert_array_equal(SC.renderer.RedrawAndGetImage(useRaytracer=True), blue)
    SC.renderer.materials.Reset()
    assert (SC.renderer.RedrawAndGetImage(useRaytracer=True) != blue).any()


def test_it_agrees_with_the_rasterizer_without_reflections_and_shadows(SC: Any, mbs: Any) -> None:
    """Apart from edges, which have other samples and rims, at most a few pixels of a hundred."""
    wheel = graphics.Cylinder(pAxis=[0, 0, -0.1], vAxis=[0, 0, 0.2], radius=0.6, nTiles=32, color=[0.2, 0.5, 0.9, 1])
    brick = graphics.Brick(centerPoint=[0.7, 0.2, 0.3], size=[0.9, 0.7, 0.6], color=[0.9, 0.6, 0.1, 1], addEdges=True)
    mbs.CreateGround(graphicsDataList=[wheel, brick])
    mbs.Assemble()
    settings = SC.visualizationSettings
    settings.view0.window.renderWindowSize, settings.raytracer.multiSampling = [200, 150], 2
    SC.renderer.SetModelView(1.2, [-1.0, 0.2, 0.1])
    drawn = SC.renderer.RedrawAndGetImage().astype(int)
    traced = SC.renderer.RedrawAndGetImage(useRaytracer=True).astype(int)
    settings.view0.camera.useRaytracer = True
    np.testing.assert_array_equal(SC.renderer.RedrawAndGetImage(), traced)
    differ = np.abs(drawn - traced).max(axis=2) > 4
    assert 0 < differ.mean() < 0.05
    assert (drawn < 250).any(axis=2).mean() > 0.15  # of the image is covered


def test_lights_that_only_rays_cast_are_named(SC: Any, mbs: Any, capsys: Any) -> None:
    from dalembert._pictures import notices

    notices._told.clear()
    scene(SC, mbs)
    SC.renderer.RedrawAndGetImage(useRaytracer=True)
    assert "no effect" not in capsys.readouterr().out
    SC.renderer.RedrawAndGetImage()
    assert "no effect of openGL.light0.shadow: only the ray tracer has it" in capsys.readouterr().out


def test_views_without_systems_are_empty() -> None:
    SC = exu.SystemContainer()
    assert (SC.renderer.RedrawAndGetImage(useRaytracer=True) == 255).all()
