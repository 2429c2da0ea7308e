"""The methods that containers and systems had before there was SC.renderer."""

from __future__ import annotations

from typing import Any


def AttachToRenderEngine(container: Any) -> bool:
    """Earlier name of SC.renderer.Attach."""
    return bool(container.renderer.Attach())


def DetachFromRenderEngine(container: Any) -> bool:
    """Earlier name of SC.renderer.Detach."""
    return bool(container.renderer.Detach())


def GetCurrentMouseCoordinates(container: Any, useOpenGLcoordinates: bool = False) -> list[float]:
    """Earlier name of SC.renderer.GetMouseCoordinates."""
    return list(container.renderer.GetMouseCoordinates(useOpenGLcoordinates))


def GetRenderState(container: Any) -> dict[str, Any]:
    """Earlier name of SC.renderer.GetState."""
    return dict(container.renderer.GetState())


def RedrawAndSaveImage(container: Any) -> None:
    """Earlier name of SC.renderer.RedrawAndSaveImage."""
    container.renderer.RedrawAndSaveImage()


def RenderEngineZoomAll(container: Any) -> None:
    """Earlier name of SC.renderer.ZoomAll."""
    container.renderer.ZoomAll()


def SendRedrawSignal(container: Any) -> None:
    """Earlier name of SC.renderer.SendRedrawSignal."""
    container.renderer.SendRedrawSignal()


def SetRenderState(container: Any, renderState: dict[str, Any]) -> None:
    """Earlier name of SC.renderer.SetState."""
    container.renderer.SetState(renderState)


def WaitForRenderEngineStopFlag(container: Any) -> bool:
    """Earlier name of SC.renderer.DoIdleTasks."""
    return bool(container.renderer.DoIdleTasks())


def WaitForUserToContinue(mbs: Any, printMessage: bool = True) -> None:
    """Earlier name of SC.renderer.DoIdleTasks."""
    mbs.GetSystemContainer().renderer.DoIdleTasks(printPauseMessage=printMessage)


def SendRedrawSignalOfSystem(mbs: Any) -> None:
    """Update the viewer to the visualization state."""
    mbs.GetSystemContainer().renderer.SendRedrawSignal()


def _ipython_display_(container: Any) -> None:
    """Show the live view in a notebook; NotImplementedError elsewhere."""
    from dalembert._pictures.showing import show_widget

    show_widget(container)


METHODS = (
    _ipython_display_,
    AttachToRenderEngine,
    DetachFromRenderEngine,
    GetCurrentMouseCoordinates,
    GetRenderState,
    RedrawAndSaveImage,
    RenderEngineZoomAll,
    SendRedrawSignal,
    SetRenderState,
    WaitForRenderEngineStopFlag,
)
SYSTEM_METHODS = {"SendRedrawSignal": SendRedrawSignalOfSystem, "WaitForUserToContinue": WaitForUserToContinue}
