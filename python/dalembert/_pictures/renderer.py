"""The methods of SC.renderer. Drawing modules are loaded with the first picture."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Any

import numpy as np

from dalembert import _core
from dalembert._checks import as_matrix, as_number, as_vector, shape_error

if TYPE_CHECKING:
    from collections.abc import Callable

    from dalembert._live.viewer import Viewer
    from dalembert._pictures.painting import Image
    from dalembert._pictures.studio import Studio


def state_of(renderer: Any, number: int) -> dict[str, Any]:
    """Return the state of a view; that of view 0 is stored in the container."""
    state: dict[str, Any] = renderer._state
    return state if number == 0 else state.setdefault(f"view{number}", {})


def _studio(renderer: Any, method: str) -> Studio:
    container = renderer._container
    if container is None:
        raise RuntimeError(
            f"SC.renderer.{method}(...): the SystemContainer does not exist any more; keep it in a variable"
        )
    from dalembert._pictures.studio import Studio

    return Studio(container)


def _view_number(method: str, viewID: Any) -> int:
    if isinstance(viewID, (int, np.integer)) and 0 <= viewID <= 3:
        return int(viewID)
    raise ValueError(f"SC.renderer.{method}(...): viewID: expected 0, 1, 2 or 3, received {viewID!r}")


def _viewer(renderer: Any) -> Viewer | None:
    """Return the running viewer; None if there is none. Does not load its modules."""
    module = sys.modules.get("dalembert._live.viewer")
    container = renderer._container
    return None if module is None or container is None else module.viewer_of(container)


_noticed = False


def Start(self: Any, verbose: int = 0) -> bool:
    """Open the live viewer in the browser; it shows all systems of the container, also while they are being solved.

    Returns False if there is no display, or DALEMBERT_VIEWER=off, or CI is set: no function waits for the viewer then.
    Notebooks show it below the cell; terminals of other machines (SSH) print its address.
    """
    global _noticed
    from dalembert._pictures.showing import where_pages_open

    where = where_pages_open()
    if where == "nowhere":
        if not _noticed:
            _noticed = True
            _core.Print("dalembert: there is no window; mbs.Draw() and SC.renderer.RedrawAndSaveImage() make pictures.")
        return False
    container = self._container
    if container is None:
        raise RuntimeError("SC.renderer.Start(...): the SystemContainer does not exist any more; keep it in a variable")
    from dalembert._live import opening

    opening.open_page(container, where, verbose)
    return True


def Stop(self: Any) -> None:
    """Close all pages; exu.sys['renderState'] gets the state of the main view, see RestoreSavedState."""
    viewer = _viewer(self)
    if viewer is not None:
        _core.sys["renderState"] = GetState(self)
        viewer.stop()


def RestoreSavedState(self: Any, viewID: int = 0) -> bool:
    """Set the view to that of exu.sys['renderState'], from the Stop of a viewer before; return whether there is one."""
    _view_number("RestoreSavedState", viewID)
    saved = _core.sys.get("renderState")
    if saved is None:
        return False
    SetState(self, saved, viewID=viewID)
    return True


def StopSimulation(self: Any, forceQuit: bool = True) -> None:
    """Let running solvers of all systems end soon, as closing the viewer does.

    forceQuit has no effect: solvers that start later run.
    """
    container = self._container
    for i in range(0 if container is None else container.NumberOfSystems()):
        container.GetSystem(i).SetRenderEngineStopFlag(True)


def IsActive(self: Any) -> bool:
    """Return whether a page is open, or is being opened."""
    viewer = _viewer(self)
    return viewer is not None and viewer.watched


def Attach(self: Any) -> bool:
    """Return whether a page is open: it shows this container anyway."""
    return IsActive(self)


def Detach(self: Any) -> bool:
    """Return whether a page is open; it goes on showing this container."""
    return IsActive(self)


def DoIdleTasks(self: Any, waitSeconds: float = -1.0, printPauseMessage: bool = True) -> bool:
    """Wait until space, 'Q' or escape is pressed in the viewer, or it is closed; returns at once if no viewer is open.

    A waitSeconds of 0 or more limits the time. Returns whether a viewer is open.
    """
    viewer = _viewer(self)
    return viewer is not None and viewer.idle(float(waitSeconds), printPauseMessage)


def EnableView(self: Any, viewID: int, createWindow: bool = True) -> None:
    """Show an additional view from 1 to 3 in the viewer, in its own window, unless createWindow is False."""
    number = _view_number("EnableView", viewID)
    state_of(self, number)["viewEnabled"] = bool(createWindow)
    _tell_pages(self, number)


def DisableView(self: Any, viewID: int) -> None:
    """Let pages show this view no longer; the main one stays, and images of all views can be made at any time."""
    number = _view_number("DisableView", viewID)
    state_of(self, number)["viewEnabled"] = False
    _tell_pages(self, number)


def SendRedrawSignal(self: Any) -> None:
    """Update the viewer to the visualization state; images are always up to date."""
    viewer = _viewer(self)
    if viewer is not None:
        viewer.redraw()


def RedrawAndGetImage(self: Any, useRaytracer: bool = False, viewID: int = 0) -> Image:
    """Return an image, height x width x 3 bytes, of all systems; size, colors and camera are those of the settings.

    useRaytracer, or the setting of that name of the view, selects the ray tracer. Arrows of forces and a floor are
    drawn if the state of view 0 has showForces and showFloor, see SetState.
    """
    number = _view_number("RedrawAndGetImage", viewID)
    studio = _studio(self, "RedrawAndGetImage")
    studio.show()
    self._state["renderCount"] = int(self._state.get("renderCount", 0)) + 1
    return studio.picture(number, bool(useRaytracer))


def RedrawAndSaveImage(self: Any, viewID: int = 0) -> None:
    """Save an image to exportImages.saveImageFileName, with a number unless saveImageSingleFile is set."""
    number = _view_number("RedrawAndSaveImage", viewID)
    studio = _studio(self, "RedrawAndSaveImage")
    studio.show()
    self._state["renderCount"] = int(self._state.get("renderCount", 0)) + 1
    from dalembert._pictures.studio import save_next

    save_next(studio.settings.exportImages, studio.picture(number))


def _tell_pages(renderer: Any, number: int) -> None:
    """Let pages look from where a view does."""
    viewer = _viewer(renderer)
    if viewer is None:
        return
    if number == 0:
        viewer.set_camera()
    else:
        viewer.show_views()


def ZoomAll(self: Any, computeMaxScene: bool = True, viewID: int = 0) -> None:
    """Let the view show the whole scene from now on."""
    state = state_of(self, _view_number("ZoomAll", viewID))
    state.pop("zoom", None)
    state.pop("centerPoint", None)
    _tell_pages(self, viewID)


def SetModelView(
    self: Any, zoom: float = 0, rotationVector: Any = [0, 0, 0], centerPoint: Any = [0, 0, 0], viewID: int = 0
) -> None:
    """Set the view: half the height of the image in lengths of the scene (0: all is shown), rotation and center."""
    state = state_of(self, _view_number("SetModelView", viewID))
    vector = as_vector("SC.renderer.SetModelView(...): rotationVector", rotationVector, 3)
    center = as_vector("SC.renderer.SetModelView(...): centerPoint", centerPoint, 3)
    if not np.isfinite(zoom) or zoom < 0:
        raise ValueError(f"SC.renderer.SetModelView(...): zoom: expected a length, or 0 to show all, received {zoom}")
    state["zoom"] = float(zoom)
    from dalembert._pictures.camera import turned

    state["modelRotation"] = turned(vector).T
    state["centerPoint"] = center
    _tell_pages(self, viewID)


def GetState(self: Any, viewID: int = 0) -> dict[str, Any]:
    """Return the view: that of SetState or SetModelView, otherwise the default from settings and scene.

    A point p is seen at modelRotation.T @ (p - centerPoint): to the right, up, towards the viewer.
    """
    number = _view_number("GetState", viewID)
    from dalembert._pictures.scene import Scene

    studio = _studio(self, "GetState")
    known = {"zoom", "modelRotation", "centerPoint"} <= state_of(self, number).keys()
    seen = studio.camera(Scene() if known else studio.scene(), number)
    is_open = IsActive(self) and (number == 0 or bool(state_of(self, number).get("viewEnabled")))
    result: dict[str, Any] = {
        "viewEnabled": is_open,
        "windowOpen": is_open,
        "centerPoint": seen.center,
        "rotationCenterPoint": np.zeros(3),
        "maxSceneSize": max((maker.looks.size for maker in studio.makers), default=1.0),
        "zoom": seen.zoom,
        "currentWindowSize": np.array(studio.size(number)),
        "displayScaling": 1.0,
        "modelRotation": seen.rotation.T,
        "projectionMatrix": np.eye(4),
        "mouseCoordinates": np.zeros(2),
        "openGLcoordinates": np.zeros(2),
    }
    return result | {k: v for k, v in state_of(self, number).items() if not k.startswith("view") and k != "renderCount"}


def SetState(self: Any, renderState: dict[str, Any], waitForRendererFullStartup: bool = True, viewID: int = 0) -> None:
    """Set the view, with entries of the dictionary that GetState gives.

    showForces and showFloor let images have arrows of forces and a floor; both are False by default. They are those of
    all views, and set for view 0 only.
    """
    number = _view_number("SetState", viewID)
    here = "SC.renderer.SetState(...)"
    if not isinstance(renderState, dict):
        raise shape_error(f"{here}: renderState", "a dictionary, as of GetState", renderState)
    if "modelRotation" in renderState:
        rotation = as_matrix(f"{here}: modelRotation", renderState["modelRotation"], (3, 3))
        if not np.allclose(rotation @ rotation.T, np.eye(3), rtol=0, atol=1e-3):  # states may be rounded
            raise shape_error(f"{here}: modelRotation", "a rotation matrix", renderState["modelRotation"])
    if "centerPoint" in renderState:
        as_vector(f"{here}: centerPoint", renderState["centerPoint"], 3)
    if "zoom" in renderState:
        as_number(f"{here}: zoom", renderState["zoom"])
    ours = {"showForces", "showFloor"} & renderState.keys()
    for name in ours:
        if not isinstance(renderState[name], (bool, np.bool_)):
            raise shape_error(f"{here}: {name}", "True or False", renderState[name])
    others = {name: value for name, value in renderState.items() if name not in ours}
    state_of(self, number).update(renderState if number == 0 else others)
    _tell_pages(self, number)


def ResetState(self: Any) -> None:
    """Forget the views; the settings say the next ones."""
    self._state.clear()
    _tell_pages(self, 1)


def GetRenderCount(self: Any) -> int:
    """Return how many images have been made, those of pages among them."""
    viewer = _viewer(self)
    return int(self._state.get("renderCount", 0)) + (0 if viewer is None else viewer.pictures)


def GetMouseCoordinates(self: Any, useOpenGLcoordinates: bool = False, viewID: int = 0) -> list[float]:
    """Return the last mouse position in the viewer, in pixels from its upper left corner; zeros without a viewer.

    useOpenGLcoordinates selects coordinates in the plane through the center of the view: right and up, in m.
    """
    viewer = _viewer(self)
    if viewer is None:
        return [0.0, 0.0]
    return list(viewer.mouse_place if useOpenGLcoordinates else viewer.mouse)


def GetItemSelection(self: Any, resetSelection: bool = True, viewID: int = 0) -> tuple[int, int, int, float]:
    """Return number of the system, type and number of the clicked item, and its distance.

    The type is a number of exu.ItemType; the result is (-1, -1, -1, 0) if there is no selection.
    """
    viewer = _viewer(self)
    if viewer is None or viewer.selection is None:
        return (-1, -1, -1, 0.0)
    system, kind, number, depth = viewer.selection
    if resetSelection:
        viewer.selection = None
    return (system, int(getattr(_core.ItemType, kind)), number, depth)


def _ipython_display_(self: Any) -> None:
    """Show the live view in a notebook; NotImplementedError elsewhere."""
    from dalembert._pictures.showing import show_widget

    show_widget(self._container)


METHODS: tuple[Callable[..., Any], ...] = (
    _ipython_display_,
    Start,
    Stop,
    IsActive,
    Attach,
    Detach,
    DoIdleTasks,
    EnableView,
    DisableView,
    ZoomAll,
    SetModelView,
    RedrawAndSaveImage,
    RedrawAndGetImage,
    GetState,
    SetState,
    RestoreSavedState,
    StopSimulation,
    GetMouseCoordinates,
    GetItemSelection,
    ResetState,
    SendRedrawSignal,
    GetRenderCount,
)
