"""Rendering of a scene: the core draws faces, lines and spheres, Pillow draws texts and overlays."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
import numpy.typing as npt

from dalembert import _core
from dalembert._checks import FloatArray
from dalembert._pictures import contour, overlay
from dalembert._pictures.camera import Camera
from dalembert._pictures.looks import Looks, rgba
from dalembert._pictures.meshes import Rgba
from dalembert._pictures.scene import Faces, Scene, faces, mesh_edges

Image = npt.NDArray[np.uint8]
# Default directions of light0 and light1 in camera coordinates: right, up, towards the viewer.
LIGHTS = ((-0.5, 0.8, 1.1), (0.9, 0.1, 0.6))
LIFT = 3e-3  # offset of lines towards the viewer, relative to the height of the picture


def paint(
    scene: Scene, camera: Camera, looks: Looks, view: Any, size: tuple[int, int], decorated: bool = True
) -> Image:
    """Return an image (height x width x 3); view: its settings. Decorated images have axes, texts and a color bar."""
    image = _drawn(scene, camera, looks, view, size).develop()
    return overlay.add(image, scene, camera, looks, view) if decorated else image


def items(scene: Scene, camera: Camera, looks: Looks, view: Any, size: tuple[int, int]) -> npt.NDArray[np.int32]:
    """Return the position in scene.items of each pixel's item; -1 for background."""
    picture = _drawn(scene, camera, looks, view, size, samples=1)
    picture.develop()
    return picture.items()


def _drawn(
    scene: Scene, camera: Camera, looks: Looks, view: Any, size: tuple[int, int], samples: int | None = None
) -> Any:
    picture = _new_picture(camera, looks, size, samples or _samples(looks))
    _set_background(picture, looks)
    if (plane := clipping_plane(camera, view)) is not None:
        picture.clip(plane)
    if view.scene.showFaces:
        for found in all_faces(scene, looks, view):
            normals = found.normals if looks.setting("openGL.advanced.shadeModelSmooth") else None
            picture.triangles(found.points, normals, found.colors, found.triangles, found.items)
        for centers, radii, colors, numbers in all_spheres(scene):
            picture.spheres(centers, radii, colors, numbers)
    if view.scene.showLines:
        edges = rgba(looks.setting("openGL.faceEdgesColor")) if view.scene.showFaceEdges else None
        for width, segments, colors, numbers in all_lines(scene, looks, edges):
            picture.lines(segments, colors, width, LIFT * camera.zoom, numbers)
    return picture


def _new_picture(camera: Camera, looks: Looks, size: tuple[int, int], samples: int) -> Any:
    gl = looks.setting("openGL")
    usual = {f"light{i}": where for i, where in enumerate(LIGHTS) if looks.is_default(f"openGL.light{i}.position")}
    shine = float(np.mean(np.asarray(gl.materialSpecular, float)[:3]))
    lights = []
    for name in ("light0", "light1", "light2", "light3"):
        light = getattr(gl, name)
        direction = np.asarray(usual.get(name, light.position), float)[:3] * [1, 1, -1]
        if light.enable and gl.advanced.enableLighting and (length := float(np.linalg.norm(direction))) > 0:
            lights.append((direction / length, float(light.diffuse), shine * float(light.specular)))
    ambient = float(np.mean(np.asarray(gl.lightModelAmbient, float)[:3])) if lights else 1.0
    return _core._Picture(
        size[0],
        size[1],
        samples,
        camera.view().ravel(),
        0.5 * size[1] / camera.zoom,
        max(camera.perspective, 0.0) / camera.zoom,
        lights,
        ambient,
        float(gl.materialShininess),
    )


def _samples(looks: Looks) -> int:
    """Return samples per pixel and direction: at least two."""
    return int(np.clip(np.ceil(np.sqrt(float(looks.setting("openGL.multiSampling")))), 2, 8))


def _set_background(picture: Any, looks: Looks) -> None:
    general = looks.setting("general")
    top = list(general.backgroundColor)
    picture.background(top, list(general.backgroundColorBottom) if general.useGradientBackground else top)


def clipping_plane(camera: Camera, view: Any) -> list[float] | None:
    """Return the clipping plane, which hides the side of its normal; None if there is none."""
    normal = np.asarray(view.camera.clippingPlaneNormal, float)
    if not normal.any():
        return None
    normal = normal / np.linalg.norm(normal)
    rows = camera.view()
    turned = rows[:, :3] @ normal
    distance = float(view.camera.clippingPlaneDistance) - normal @ camera.center
    return [*(-turned), distance]


def all_faces(scene: Scene, looks: Looks, view: Any) -> Iterator[Faces]:
    """Return the faces of all meshes, first those with normals."""
    color_of = {
        number: contour.colors(looks, instance.values, scene.value_range)
        for number, instance in enumerate(scene.instances)
        if instance.values is not None
    }
    for smooth in (True, False):
        if (found := faces(scene, smooth, color_of)) is not None:
            if view.scene.facesTransparent:
                found.colors = found.colors * [1, 1, 1, float(looks.setting("openGL.faceTransparencyGlobal"))]
            yield found


def all_spheres(scene: Scene) -> Iterator[tuple[Any, Any, Any, Any]]:
    """Return centers, radii, colors and items."""
    if len(scene.balls.items):
        balls = scene.balls
        yield balls.centers, balls.radii, balls.colors, balls.items
    if scene.spheres:
        centers, radii, colors, numbers = zip(*scene.spheres, strict=True)
        yield np.array(centers), np.array(radii), np.array(colors), np.array(numbers)


def all_lines(scene: Scene, looks: Looks, sharp: Rgba | None) -> Iterator[tuple[float, FloatArray, FloatArray, Any]]:
    """Return lines and edges of meshes, all of one width at a time: width, segments, colors and items."""
    usual = float(looks.setting("openGL.lineWidth"))
    groups: dict[float, list[tuple[FloatArray, Any, int]]] = {}
    for points, color, width, item in scene.unbound().lines if len(scene.threads.items) else scene.lines:
        if len(points) > 1:
            segments = np.concatenate([points[:-1], points[1:]], axis=1)
            groups.setdefault(width or usual, []).append((segments, color, item))
    groups.setdefault(usual, []).extend(mesh_edges(scene, sharp))
    for width, group in groups.items():
        if group:
            counts = [len(segments) for segments, *_ in group]
            colors = np.repeat([color for _, color, _ in group], counts, axis=0)
            numbers = np.repeat([item for *_, item in group], counts)
            yield width, np.concatenate([segments for segments, *_ in group]), colors, numbers
