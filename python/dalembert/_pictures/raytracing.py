"""Ray tracing of a scene: lights, materials and fog of the settings `raytracer`."""

from __future__ import annotations

import os
import time
from dataclasses import replace
from typing import Any

import numpy as np

from dalembert import _core
from dalembert._checks import FloatArray
from dalembert._pictures import overlay, painting
from dalembert._pictures.camera import Camera
from dalembert._pictures.looks import Looks, rgba
from dalembert._pictures.painting import LIGHTS, Image
from dalembert._pictures.scene import Faces, Scene

MATERIALS = 10  # materials of the settings
DEEPEST = 32  # reflections, and transparent faces
TOWARDS_EYE = np.array([1.0, 1.0, -1.0])  # right, up, towards the viewer -> right, up, away from the viewer


def paint(scene: Scene, camera: Camera, looks: Looks, view: Any, size: tuple[int, int], materials: list[Any]) -> Image:
    """Return an image (height x width x 3), smaller than the size by raytracer.imageSizeFactor; view: its settings."""
    settings = looks.setting("raytracer")
    factor = int(np.clip(settings.imageSizeFactor, 1, 16))
    size = (max(size[0] // factor, 1), max(size[1] // factor, 1))
    begin = time.perf_counter()
    tracer = _core._RayTracer(
        size[0],
        size[1],
        camera.view().ravel(),
        0.5 * size[1] / camera.zoom,
        max(camera.perspective, 0.0) / camera.zoom,
        lights(camera, looks),
        [_plain(looks), *(_row(material) for material in materials)],
        _options(looks),
    )
    if (plane := painting.clipping_plane(camera, view)) is not None:
        tracer.clip(plane)
    count = _add(tracer, scene, looks, view, materials)
    image: Image = tracer.develop()
    if settings.verbose > 0:
        _core.Print(f"ray tracer: {size[0]} x {size[1]} pixels, {count} shapes, {time.perf_counter() - begin:.2f} s")
    if not settings.advanced.showText:
        scene = replace(scene, labels=[])
    return overlay.add(image, scene, camera, looks, view)


def materials_of(container: Any) -> list[Any]:
    """Return the materials of SC.renderer; unchanged ones are replaced by those of the settings."""
    settings, made = container.visualizationSettings.raytracer, _core.GraphicsMaterialList()
    known = container.renderer.materials
    found = [known[i] for i in range(len(known))]
    for i in range(min(MATERIALS, len(found))):
        if found[i].GetDictionary() == made[i].GetDictionary():
            found[i] = getattr(settings, f"material{i}")
    return found


def lights(camera: Camera, looks: Looks) -> list[Any]:
    """Return lights in eye coordinates.

    Lights with the default position move with the camera; other lights are fixed to the model, unless useCameraFrame is
    set, at a position or at infinity. Shadows are on or off for each light: their darkness follows from the other
    lights.
    """
    found, gl, rows = [], looks.setting("openGL"), camera.view()
    for name, usual in (("light0", LIGHTS[0]), ("light1", LIGHTS[1]), ("light2", None), ("light3", None)):
        light = getattr(gl, name)
        place, far = np.asarray(light.position, float)[:3], float(light.position[3]) == 0
        if not light.enable or not gl.advanced.enableLighting or not (length := float(np.linalg.norm(place))):
            continue
        if usual is not None and looks.is_default(f"openGL.{name}.position"):
            place, far = np.asarray(usual) * TOWARDS_EYE, True
        elif light.useCameraFrame:
            place = place * TOWARDS_EYE
        else:
            place = rows[:, :3] @ place + (0 if far else rows[:, 3])
        size = float(light.lightRadius) / (length if far else 1.0)
        if far:
            place = place / np.linalg.norm(place)
        fading = [light.constantAttenuation, light.linearAttenuation, light.quadraticAttenuation]
        found.append((place, far, [light.diffuse, light.specular, float(light.shadow > 0), size], fading))
    return found


def _row(material: Any) -> tuple[Any, ...]:
    return (material.specular, material.emission, material.shininess, min(material.reflectivity, 1.0), material.ior)


def _plain(looks: Looks) -> tuple[Any, ...]:
    """Return the default material of faces."""
    gl = looks.setting("openGL")
    return (np.asarray(gl.materialSpecular, float)[:3], (0.0, 0.0, 0.0), gl.materialShininess, 0.0, 1.0)


def _options(looks: Looks) -> Any:
    settings, general, options = looks.setting("raytracer"), looks.setting("general"), _core._RayOptions()
    options.samples = int(np.clip(settings.multiSampling, 1, 4))
    options.threads = int(np.clip(settings.numberOfThreads, 1, os.cpu_count() or 1))
    options.tiles_per_thread = int(settings.advanced.tilesPerThread)
    options.reflections = min(int(settings.maxReflectionDepth), DEEPEST)
    options.transparencies = min(int(settings.maxTransparencyDepth), DEEPEST)
    options.light_places = int(np.clip(settings.lightRadiusVariations, 1, 256))
    options.lift = float(settings.advanced.zBiasLines) * looks.size
    lit = any(getattr(looks.setting("openGL"), f"light{i}").enable for i in range(4))
    lit = lit and looks.setting("openGL").advanced.enableLighting
    options.ambient = float(np.mean(np.asarray(looks.setting("openGL").lightModelAmbient, float)[:3])) if lit else 1.0
    options.top = general.backgroundColor[:3]
    options.bottom = (general.backgroundColorBottom if general.useGradientBackground else general.backgroundColor)[:3]
    options.around = settings.advanced.backgroundColorReflections[:3]
    options.fog = settings.globalFogColor[:3]
    options.fog_density = float(settings.globalFogDensity) / looks.size
    return options


def _add(tracer: Any, scene: Scene, looks: Looks, view: Any, materials: list[Any]) -> int:
    """Give all that is drawn to the tracer; return how many triangles, spheres and lines there are."""
    count = 0
    if view.scene.showFaces:
        opacity = float(looks.setting("openGL.faceTransparencyGlobal")) if view.scene.facesTransparent else 1.0
        for found in painting.all_faces(scene, looks, view):
            colors, numbers = of_materials(found, materials, opacity)
            normals = found.normals if looks.setting("openGL.advanced.shadeModelSmooth") else None
            tracer.triangles(found.points, normals, colors, found.triangles, numbers)
            count += len(found.triangles)
        for centers, radii, shades, _ in painting.all_spheres(scene):
            tracer.spheres(centers, radii, shades)
            count += len(radii)
    if view.scene.showLines:
        edges = rgba(looks.setting("openGL.faceEdgesColor")) if view.scene.showFaceEdges else None
        for width, segments, shades, _ in painting.all_lines(scene, looks, edges):
            tracer.lines(segments, shades, width)
            count += len(segments)
    return count


def of_materials(found: Faces, materials: list[Any], opacity: float = 1.0) -> tuple[FloatArray, Any]:
    """Return colors of points, and the material of each triangle.

    Materials say their opacity, which is multiplied by the one that is given, and colors of points without their own.
    Numbers of materials beyond the last one stand for the last one; triangles without a material have the number 0.
    """
    if found.materials is None:
        return found.colors, np.zeros(len(found.triangles), np.int32)
    colors = found.colors.copy()
    number = np.minimum(np.abs(found.materials), len(materials))
    base = np.array([[*material.baseColor, material.alpha] for material in materials], float)
    own = found.materials < 0
    colors[own, :3] = base[number[own] - 1, :3]
    colors[number > 0, 3] = opacity * base[number[number > 0] - 1, 3]
    return np.clip(colors, 0, 1), number[found.triangles[:, 0]].astype(np.int32)
