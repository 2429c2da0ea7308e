"""The scenes of a solution, one for each image of a film, and the camera that sees them all."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np

from dalembert._checks import FloatArray, IntArray, as_positive
from dalembert._core import ConfigurationType
from dalembert._io.solution_states import SetSolutionState, check_solution, check_solution_of
from dalembert._pictures import draw
from dalembert._pictures.camera import PERSPECTIVE_OF_PAGES
from dalembert._pictures.films import times_of
from dalembert._pictures.looks import Looks
from dalembert._pictures.painting import Image
from dalembert._pictures.scene import Scene
from dalembert._pictures.studio import Studio
from dalembert.interactive import solution_of_last_simulation


class Motion:
    """Scenes and their camera; the visualization state is restored afterwards."""

    def __init__(
        self,
        mbs: Any,
        caller: str,
        solution: dict[str, Any] | None,
        framesPerSecond: float,
        speed: float,
        view: Any,
        size: tuple[int, int] | None,
        zoom: float = 1.0,
        optional: bool = False,
        every_row: bool = False,
        page: bool = False,
        forces: bool | None = False,
        floor: bool | None = False,
    ) -> None:
        """Make the scenes; every_row makes one for each row of the solution, otherwise they are at equal time
        intervals.

        `optional`: if there is no solution, the visualization state is the only scene. `page`: it is shown on a page.
        `forces` and `floor` are those of Studio.show.
        """
        self.rate, speed = (
            as_positive(f"{caller}: framesPerSecond", framesPerSecond),
            as_positive(f"{caller}: speed", speed),
        )
        if solution is not None:
            check_solution(caller, solution)
        self.studio = Studio(mbs.GetSystemContainer(), [mbs])
        self.studio.perspective = PERSPECTIVE_OF_PAGES if page else None
        self.studio.show(forces, floor)
        self._tracked: list[Any] = []  # pose that the camera follows, per scene
        self.size = size or self.studio.size(0)
        try:
            data = solution_of_last_simulation(mbs, caller) if solution is None else solution
        except (ValueError, OSError):
            if not optional:
                raise
            self.scenes = [self._scene()]
        else:
            check_solution_of(mbs, caller, data)
            times = np.asarray(data["data"], float)[:, 0]
            rows = np.arange(len(times)) if every_row else self._rows(times, speed, caller)
            self.scenes = self._scenes(mbs, data, rows)
        self.camera = draw.camera_for(self.studio, draw.around(self.scenes), view, self.size, zoom, where=f"{caller}: ")

    def images(self) -> Iterator[Image]:
        """Return the images; the camera follows a marker as view0.camera.trackMarker says."""
        self.studio.floor_box = draw.around(self.scenes, Scene.extent).extent()  # the floor stays where it is
        for scene, tracked in zip(self.scenes, self._tracked, strict=True):
            camera = replace(self.camera)
            self.studio.track(camera, 0, tracked)
            yield self.studio.image(scene, camera, size=self.size)

    @property
    def looks(self) -> Looks:
        """Return the sizes and colors with which the scenes were made."""
        return self.studio.makers[0].looks

    def _scene(self) -> Scene:
        self._tracked.append(self.studio.tracked())
        return self.studio.flow()

    def _rows(self, recorded: FloatArray, speed: float, caller: str) -> IntArray:
        """Return the rows that are nearest to the times of the frames."""
        times = times_of(caller, recorded[0], recorded[-1], self.rate, speed)
        order = np.argsort(recorded, kind="stable")
        middles = 0.5 * (recorded[order[1:]] + recorded[order[:-1]])
        return order[np.searchsorted(middles, times)]

    def _scenes(self, mbs: Any, data: dict[str, Any], rows: IntArray) -> list[Scene]:
        before = mbs.systemData.GetSystemState(ConfigurationType.Visualization)
        time = mbs.systemData.GetTime(ConfigurationType.Visualization)
        scenes = []
        try:
            for row in rows:
                SetSolutionState(mbs, data, int(row), ConfigurationType.Visualization)
                scenes.append(self._scene())
                scenes[-1].of_motion = True
        finally:
            mbs.systemData.SetSystemState(before, ConfigurationType.Visualization)
            mbs.systemData.SetTime(time, ConfigurationType.Visualization)
        return scenes


class Still:
    """The visualization state of all systems of a container, as the only scene of a motion."""

    def __init__(self, container: Any, size: tuple[int, int] = (1024, 768)) -> None:
        studio = self.studio = Studio(container)
        studio.perspective = PERSPECTIVE_OF_PAGES
        scene = studio.scene()
        self.rate, self.scenes = 1.0, [scene]
        self.camera = draw.camera_for(studio, scene, None, size, 1.0)
        if studio.settings.general.autoFitScene:
            studio.fit(self.camera, scene, scene.box(), size)
        self.looks = studio.makers[0].looks if studio.makers else Looks(container.visualizationSettings)
