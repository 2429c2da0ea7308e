"""mbs.Draw() and mbs.DrawSolution(): a picture in one line, and a film in another."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from dalembert._checks import FloatArray, as_array, as_positive, shape_error
from dalembert._core import ConfigurationType
from dalembert._io.files import file_to_write
from dalembert._tools.found_items import index_of

if TYPE_CHECKING:
    from collections.abc import Callable

    from PIL.Image import Image as PillowImage

    from dalembert._pictures.camera import Camera
    from dalembert._pictures.scene import Scene
    from dalembert._pictures.studio import Studio

STATES = [ConfigurationType[name] for name in ("Current", "Initial", "Reference", "StartOfStep", "Visualization")]
VIEWS = ("front", "back", "left", "right", "top", "bottom", "axonometric")


def Draw(
    mbs: Any,
    fileName: str = "",
    view: Any = None,
    windowSize: Any = None,
    configuration: Any = None,
    zoom: float = 1.0,
    around: Any = None,
    forces: bool | None = None,
    floor: bool | None = None,
) -> PillowImage:
    """Return a picture of the system as it is visualized; before Assemble(), of its reference configuration.

    Notebooks show it automatically; `fileName` (.png, .jpg, .webp) saves it. `view` is 'front' (x to the right, y up),
    'back', 'left', 'right', 'top', 'bottom', 'axonometric', or a rotation matrix with the rows right, up, towards the
    viewer; the default is that of SC.renderer.SetModelView, or a view that fits the system. `windowSize` are width and
    height in pixels; `zoom` > 1 shows things larger; `around` is an object, or a list of objects, in the middle of the
    picture, by index or name; otherwise, the camera follows the marker of view0.camera.trackMarker. `forces` draws
    arrows of loads, joints, connectors and contacts, with their scale, `floor` a grid with round numbers below the
    system; both are off unless SC.renderer.SetState has set showForces or showFloor.
    SC.visualizationSettings has sizes, colors and visibility.
    """
    from PIL import Image as Pillow

    from dalembert._pictures.films import check_image_name, save_image
    from dalembert._pictures.studio import Studio

    if configuration is not None and (not isinstance(configuration, ConfigurationType) or configuration not in STATES):
        names = ", ".join(state.name for state in STATES)
        raise shape_error("Draw: configuration", f"one of ConfigurationType: {names}", configuration)
    if fileName not in ("", None):
        fileName = file_to_write("Draw: fileName", fileName, newFolder=True)
        check_image_name(fileName, "Draw: fileName")
    if around is not None:
        around = [index_of(mbs, "Object", item, "Draw: around") for item in np.atleast_1d(np.asarray(around, object))]
    _check_flags("Draw", forces, floor)
    studio = Studio(mbs.GetSystemContainer(), [mbs])
    studio.show(forces, floor)
    scene = studio.scene(configuration)
    size = studio.size(0) if windowSize is None else _size(windowSize, "Draw")
    camera = camera_for(studio, scene, view, size, zoom, around, "Draw: ")
    if around is None:
        studio.track(camera, 0, studio.tracked())
    image = studio.image(scene, camera, size=size)
    if fileName:
        save_image(image, fileName)
    return Pillow.fromarray(image)


def DrawSolution(
    mbs: Any,
    fileName: str,
    solution: dict[str, Any] | None = None,
    framesPerSecond: float = 25,
    speed: float = 1.0,
    view: Any = None,
    windowSize: Any = None,
    zoom: float = 1.0,
    forces: bool | None = None,
    floor: bool | None = None,
) -> None:
    """Make a film of a solution (from LoadSolutionFile), or of the last simulation if solution is None.

    A `fileName` with .gif or .webp needs nothing else, .mp4 the program ffmpeg; a name with a % such as
    'images/frame%05d.png' gives numbered images. `speed` is the time of the solution that passes in a second.
    View, size, zoom, forces and floor are those of Draw(); the camera shows the whole motion, or follows the marker of
    visualizationSettings.view0.camera.trackMarker.
    """
    from pathlib import Path

    from dalembert._pictures.films import check_image_name, check_name, numbered, save_film, save_image
    from dalembert._pictures.motion import Motion

    fileName = file_to_write("DrawSolution: fileName", fileName, newFolder=True)
    name_of = numbered(fileName, "DrawSolution: fileName") if "%" in fileName else None
    if name_of is None:
        check_name(Path(fileName), "DrawSolution: fileName")
    else:
        check_image_name(name_of(0), "DrawSolution: fileName")
    _check_flags("DrawSolution", forces, floor)
    size = None if windowSize is None else _size(windowSize, "DrawSolution")
    motion = Motion(mbs, "DrawSolution", solution, framesPerSecond, speed, view, size, zoom, forces=forces, floor=floor)
    if name_of is not None:
        for number, image in enumerate(motion.images()):
            save_image(image, name_of(number))
    else:
        save_film(motion.images(), fileName, framesPerSecond)


def _check_flags(caller: str, forces: Any, floor: Any) -> None:
    """Raise the ValueError for arguments that are neither True nor False nor None."""
    for name, value in (("forces", forces), ("floor", floor)):
        if value is not None and not isinstance(value, (bool, np.bool_)):
            raise shape_error(f"{caller}: {name}", "True, False, or None for the setting of the renderer", value)


def around(scenes: list[Scene], box_of: Callable[[Scene], FloatArray | None] | None = None) -> Scene:
    """Return a scene with the corners of all that is drawn in others; those of their boxes, or of another function."""
    from dalembert._pictures.scene import Scene

    boxes = [box for box in map(box_of or Scene.box, scenes) if box is not None]
    corners = np.concatenate(boxes) if boxes else np.zeros((0, 3))
    lines = [(corners, (0.0, 0.0, 0.0, 1.0), 0.0, -1)] if len(corners) else []
    return Scene(lines=lines, value_name=scenes[0].value_name)


def _size(windowSize: Any, caller: str) -> tuple[int, int]:
    from dalembert._pictures.studio import LARGEST

    name = f"{caller}: windowSize"
    size = as_array(name, windowSize, "width and height in pixels")
    if size.shape != (2,) or not (size >= 1).all() or not (size <= LARGEST).all():
        raise shape_error(name, f"width and height in pixels, each from 1 to {LARGEST}", windowSize)
    return int(size[0]), int(size[1])


def camera_for(
    studio: Studio, scene: Scene, view: Any, size: tuple[int, int], zoom: float, around: Any = None, where: str = ""
) -> Camera:
    """Return the camera for a view; that of the renderer if it was set and no other is wanted. It follows no marker.

    Errors begin with `where`.
    """
    from dalembert._pictures import camera as cameras
    from dalembert._pictures.renderer import state_of

    zoom = as_positive(f"{where}zoom", zoom)
    chosen = studio.camera_at_rest(scene, 0, size)
    start = np.asarray(studio.settings.openGL.advanced.initialModelRotation, float)
    free = bool(studio.settings.general.autoFitScene) and bool((start == np.eye(3)).all())
    free = free and "modelRotation" not in state_of(studio.container.renderer, 0)
    if view is not None or around is not None or free:
        box = (
            scene.box() if around is None else scene.box_of([int(n) for n in np.atleast_1d(np.asarray(around, object))])
        )
        if view is not None:
            chosen.rotation = cameras.named(view, studio.upwards(), where)
        elif free:
            chosen.rotation = cameras.automatic(box, studio.upwards())
        studio.fit(chosen, scene, box, size)
    chosen.zoom /= zoom
    return chosen
