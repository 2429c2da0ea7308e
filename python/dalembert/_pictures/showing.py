"""Places to show a viewer or HTML file: the running notebook, a browser, or none."""

from __future__ import annotations

import os
import sys
import tempfile
import webbrowser
from html import escape
from pathlib import Path
from typing import Any

from dalembert._tools.user_interface import UIWindowSuppressed, user_interface


def show_solution(
    mbs: Any,
    solution: dict[str, Any],
    pause: float,
    title: str,
    plays: bool,
    mode: int,
    captions: list[str] | None = None,
) -> bool:
    """Show the rows of a solution one after the other, `pause` seconds apart; False if there is nowhere to show it.

    It is a page of its own where one can be opened, and otherwise in front of the live page that somebody has open.
    Captions stand instead of the times of the rows.
    """
    notebook, display = in_notebook(), has_display()
    viewer = None if notebook or display else _open_viewer(mbs.GetSystemContainer())
    if not (notebook or display or viewer):
        return False
    from dalembert._pictures import html
    from dalembert._pictures.motion import Motion

    motion = Motion(
        mbs, "SolutionViewer", solution, 1 / max(pause, 1e-3), 1.0, None, (1024, 768), every_row=True, page=True
    )
    words = {"title": title, "plays": plays, "again": mode > 0} | ({"captions": captions} if captions else {})
    if notebook:
        _show_in_notebook(html.page(motion, words))
    elif viewer is None:
        _open_in_browser(html.page(motion, words))
    else:
        viewer.tell({"kind": "motion", "data": html.data(motion, words)})
    return True


def _open_viewer(container: Any) -> Any:
    """Return the viewer of a container if somebody has its page open."""
    module = sys.modules.get("dalembert._live.viewer")
    viewer = None if module is None else module.viewer_of(container)
    return viewer if viewer is not None and viewer.server.pages else None


def in_notebook() -> bool:
    """Return whether output is displayed in cells of a notebook."""
    ipython = sys.modules.get("IPython")
    shell = ipython.get_ipython() if ipython is not None else None
    kind = type(shell)
    return kind.__name__ == "ZMQInteractiveShell" or kind.__module__.startswith("google.colab")


def where_pages_open() -> str:
    """Return "browser", "notebook", "address" (it is printed, and somebody else opens it) or "nowhere"."""
    if UIWindowSuppressed("Renderer"):
        return "nowhere"
    if os.environ.get("DALEMBERT_VIEWER") == "on":
        return "address"
    if in_notebook() and os.environ.get("DALEMBERT_VIEWER") != "off":
        return "notebook"
    if has_display():
        return "browser"
    from_afar = "SSH_CONNECTION" in os.environ and sys.stdout is not None and sys.stdout.isatty()
    return "address" if from_afar and not _silent() else "nowhere"


def _silent() -> bool:
    """Return whether opening windows is disabled: in tests, if CI is set, or by the user."""
    environment = os.environ
    off = environment.get("DALEMBERT_VIEWER") == "off" or user_interface.suppressRenderer
    return off or bool(environment.get("CI")) or "PYTEST_CURRENT_TEST" in environment


def show_widget(container: Any) -> None:
    """Show a widget with all systems of a container below the cell that is running; NotImplementedError elsewhere.

    That error lets IPython show objects as it would without this.
    """
    if where_pages_open() == "notebook":
        from dalembert._live import widget

        if widget.is_installed():
            from dalembert._live import notebook

            notebook.show(container)
            return
    raise NotImplementedError("widgets are shown in notebooks, with anywidget")


def has_display() -> bool:
    """Return whether a browser has a place for its window; never in tests, where CI is set, or DALEMBERT_VIEWER=off."""
    if _silent():
        return False
    if sys.platform in ("win32", "darwin"):
        return True
    return bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))


def _show_in_notebook(text: str) -> None:
    from importlib import import_module

    shown = import_module("IPython.display")
    shown.display(shown.HTML(frame(text)))


def frame(text: str) -> str:
    """Return a page in a frame of its own, which can reach neither the notebook nor the network."""
    return (
        f'<div><iframe sandbox="allow-scripts allow-downloads" srcdoc="{escape(text)}" width="100%" height="480" '
        f'style="border: 0"></iframe></div>'
    )


def _open_in_browser(text: str) -> None:
    """Write a page to a folder that only this user can read, and open it."""
    path = Path(tempfile.mkdtemp(prefix="dalembert-"), "solution.html")
    path.write_text(text, "utf-8")
    webbrowser.open(path.as_uri())
