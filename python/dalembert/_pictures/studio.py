"""A studio draws all systems of a container, as its settings and the render state say."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from dalembert import _core
from dalembert._checks import FloatArray
from dalembert._io.files import file_to_write
from dalembert._pictures import camera, films, painting
from dalembert._pictures import floor as floors
from dalembert._pictures.camera import Camera
from dalembert._pictures.flow import Flow
from dalembert._pictures.making import SceneMaker
from dalembert._pictures.notices import tell_settings_of_rays, tell_settings_without_effect
from dalembert._pictures.painting import Image
from dalembert._pictures.places import Places
from dalembert._pictures.renderer import state_of
from dalembert._pictures.scene import DrawnItem, Instance, Scene

LARGEST = 16000  # pixels of an image, in each direction
BAR = 0.14  # part of the width that the bar of colors needs


def joined(scenes: list[Scene]) -> Scene:
    """Return one scene of those of several systems."""
    if len(scenes) == 1:
        return scenes[0]
    whole, scenes = Scene(), [scene.unbound() for scene in scenes]
    for number, scene in enumerate(scenes):
        start = len(whole.items)
        whole.items += [item._replace(system=number) for item in scene.items]
        whole.instances += [
            Instance(i.mesh, i.matrix, i.place, i.color, i.item + start, i.values) for i in scene.instances
        ]
        whole.spheres += [(center, radius, color, item + start) for center, radius, color, item in scene.spheres]
        whole.lines += [(points, color, width, item + start) for points, color, width, item in scene.lines]
        whole.labels += scene.labels
        whole.information += scene.information
        whole.time = max(whole.time, scene.time)
        whole.value_name = whole.value_name or scene.value_name
    if len(values := whole.values()):
        shown = [scene.value_range for scene in scenes if len(scene.values())]
        whole.value_range = (min(low for low, _ in shown), max(high for _, high in shown))
        assert np.isfinite(values).all()
    return whole


class Studio:
    """Draws systems of a container, by default all of them, according to its settings and render state."""

    def __init__(self, container: Any, systems: list[Any] | None = None) -> None:
        self.container = container
        self.settings = container.visualizationSettings
        known = [container.GetSystem(i) for i in range(container.NumberOfSystems())]
        self.makers = [
            SceneMaker(mbs, self.settings, known.index(mbs) if mbs in known else number)
            for number, mbs in enumerate(known if systems is None else systems)
        ]
        self._flows: list[Flow] = []
        self.floor = False  # images have a floor, below
        self.floor_box: FloatArray | None = None  # this box, or below the scene
        self.perspective: float | None = None  # that of pages; None: that of the settings
        tell_settings_without_effect(self.settings)

    def show(self, forces: bool | None = None, floor: bool | None = None) -> None:
        """Let images have arrows of forces and a floor; None: as the render state says."""
        state = state_of(self.container.renderer, 0)
        self.floor = bool(state.get("showFloor")) if floor is None else bool(floor)
        for maker in self.makers:
            maker.show_forces(bool(state.get("showForces")) if forces is None else bool(forces))

    def margin(self) -> float:
        """Return the ratio of the image size to the size of its contents."""
        return max(float(self.settings.general.boundingBoxZoomAllFactor), 0.1)

    def fit(self, seen: Camera, scene: Scene, box: FloatArray | None, size: tuple[int, int]) -> None:
        """Fit a camera to a box, with space for the color bar."""
        bar = bool(scene.value_name) and bool(self.settings.contour.advanced.showColorBar)
        seen.fit(box, *size, self.margin(), BAR if bar else 0.0)

    def upwards(self) -> int:
        """Return the axis that points upwards: 1 if weight acts along y, otherwise 2."""
        for maker in self.makers:
            for number in range(maker.mbs.systemData.NumberOfLoads()):
                load = maker.mbs.GetLoad(number)
                if load["loadType"] == "MassProportional":
                    x, y, z = np.abs(np.asarray(load["loadVector"], float))
                    return 1 if y > z else 2
        return 2

    def view(self, number: int) -> Any:
        """Return the settings of a view."""
        return getattr(self.settings, f"view{number}")

    def size(self, number: int) -> tuple[int, int]:
        """Return width and height of the images of a view, in pixels."""
        width, height = (int(n) for n in self.view(number).window.renderWindowSize)
        if min(width, height) < 1 or max(width, height) > LARGEST:
            here = f"visualizationSettings.view{number}.window.renderWindowSize"
            raise ValueError(f"{here}: expected from 1 to {LARGEST} pixels each, received {width} x {height}")
        return width, height

    def scene(self, configuration: Any = None) -> Scene:
        """Return the scene of all systems."""
        return joined([maker.scene(configuration) for maker in self.makers]) if self.makers else Scene()

    def flow(self) -> Scene:
        """Return the scene of the visualization state; rigid parts are moved, not drawn again."""
        if len(self._flows) != len(self.makers):
            self._flows = [Flow(maker) for maker in self.makers]
        return joined([flow.scene() for flow in self._flows]) if self._flows else Scene()

    def moving(self) -> Flow | None:
        """Return the flow of the only system, if all that it draws is moved and nothing is drawn again."""
        only = self._flows[0] if len(self._flows) == len(self.makers) == 1 else None
        return only if only is not None and only.moving() is not None else None

    def settings_changed(self) -> None:
        """Let flow() draw everything again."""
        self._flows = []

    def camera(self, scene: Scene, number: int = 0, size: tuple[int, int] | None = None) -> Camera:
        """Return the camera of the render state, which follows a marker if the settings say so."""
        result = self.camera_at_rest(scene, number, size)
        self.track(result, number, self.tracked(number))
        return result

    def camera_at_rest(self, scene: Scene, number: int = 0, size: tuple[int, int] | None = None) -> Camera:
        """Return the camera of the render state; defaults follow from the settings and the scene."""
        state = state_of(self.container.renderer, number)
        result = camera.of_settings(self.settings)
        result.perspective = self.perspective or float(self.view(number).camera.perspective)
        if "modelRotation" in state:
            result.rotation = np.asarray(state["modelRotation"], float).reshape(3, 3).T
        known = float(state.get("zoom", 0.0)) > 0
        if self.settings.general.autoFitScene and not known:
            self.fit(result, scene, scene.box(), size or self.size(number))
        if "centerPoint" in state and known:
            result.center = np.asarray(state["centerPoint"], float)
        if known:
            result.zoom, result.aspect = float(state["zoom"]), 0.0
        return result

    def tracked(self, number: int = 0) -> tuple[FloatArray | None, FloatArray] | None:
        """Return position and rotation matrix of the marker that the camera of a view follows; None if there is
        none."""
        follow, here = self.view(number).camera, f"visualizationSettings.view{number}.camera"
        marker, system = int(follow.trackMarker), int(follow.trackMarkerMbsNumber)
        if marker < 0 or not self.makers:
            return None
        if system >= (count := self.container.NumberOfSystems()):
            raise ValueError(
                f"{here}.trackMarkerMbsNumber: expected a number of the {count} systems, received {system}"
            )
        drawn = {maker.number: maker.mbs for maker in self.makers}
        mbs = drawn[system] if system in drawn else self.container.GetSystem(system)
        if marker >= (count := mbs.systemData.NumberOfMarkers()):
            raise ValueError(
                f"{here}.trackMarker: expected a number of the {count} markers of system {system}, received {marker}"
            )
        places = Places(mbs, _core.ConfigurationType.Visualization)
        return places.marker(marker), places.marker_rotation(marker)

    def track(self, camera: Camera, number: int, tracked: tuple[FloatArray | None, FloatArray] | None) -> None:
        """Let a camera follow the result of tracked()."""
        if tracked is None:
            return
        follow, (place, rotation) = self.view(number).camera, tracked
        if place is not None:
            chosen = np.asarray(follow.trackMarkerPosition, float) != 0
            camera.center = np.where(chosen, place, camera.center)
        if np.any(np.asarray(follow.trackMarkerOrientation, float)):
            camera.rotation = camera.rotation @ rotation.T

    def image(
        self,
        scene: Scene,
        view: Camera,
        number: int = 0,
        size: tuple[int, int] | None = None,
        raytracer: bool = False,
    ) -> Image:
        """Return the image of a scene; the argument or the settings of the view select the ray tracer."""
        settings, looks, size = self.view(number), self.makers[0].looks, size or self.size(number)
        if self.floor:
            box = scene.extent() if self.floor_box is None else self.floor_box
            grid = floors.lines(box, self.upwards(), self.settings.general.backgroundColor)
            scene = replace(scene, lines=[*scene.lines, *grid])
        if not raytracer and not settings.camera.useRaytracer:
            tell_settings_of_rays(self.settings)
            return painting.paint(scene, view, looks, settings, size)
        from dalembert._pictures import raytracing

        return raytracing.paint(scene, view, looks, settings, size, raytracing.materials_of(self.container))

    def picture(self, number: int = 0, raytracer: bool = False) -> Image:
        """Return the image of the visualization state."""
        if not self.makers:
            width, height = self.size(number)
            return np.full((height, width, 3), 255, np.uint8)
        scene = self.scene()
        return self.image(scene, self.camera(scene, number), number, raytracer=raytracer)


def save_next(export: Any, image: Image, quickly: bool = False) -> Path:
    """Save an image under the next name, quickly if it is one of a series; its size is adapted to videos."""
    height, width = (n // max(int(a), 1) * max(int(a), 1) or n for n, a in zip(
        image.shape, (export.heightAlignment, export.widthAlignment), strict=False))  # fmt: skip
    image = image[:height, :width]
    number = "" if export.saveImageSingleFile else f"{int(export.saveImageFileCounter):05d}"
    if export.saveImageFormat != "PNG":
        raise ValueError(
            f"visualizationSettings.exportImages.saveImageFormat: expected 'PNG', received '{export.saveImageFormat}'"
        )
    here = "visualizationSettings.exportImages.saveImageFileName"
    path = Path(file_to_write(here, f"{export.saveImageFileName}{number}.png", newFolder=True))
    films.save_image(image, path, quickly)
    if not export.saveImageSingleFile:
        export.saveImageFileCounter += 1
    return path


def item_at(studio: Studio, x: int, y: int, number: int = 0) -> DrawnItem | None:
    """Return the item that is seen in a pixel: column x, row y."""
    scene = studio.scene()
    seen = painting.items(
        scene, studio.camera(scene, number), studio.makers[0].looks, studio.view(number), studio.size(number)
    )
    found = int(seen[y, x])
    return scene.items[found] if found >= 0 else None
