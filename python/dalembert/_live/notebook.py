"""The live view in a cell of a notebook, and a static view below it that is saved with the notebook.

The widget hides the static view while its kernel answers. If there is no kernel, the static view is visible: it shows
the
state after the last cell that has changed it, and can be rotated and zoomed.
"""

from __future__ import annotations

import secrets
from collections.abc import Callable
from functools import partial
from importlib import import_module
from typing import Any

from dalembert._live.viewer import Viewer, start, viewer_of
from dalembert._live.widget import WidgetLink, make
from dalembert._pictures import showing
from dalembert._pictures.html import page_of_state
from dalembert._pictures.renderer import state_of

LARGEST = 8_000_000  # characters of a page in a notebook; larger ones become pictures
# If the kernel is gone, JupyterLab shows an error instead of the widget; this style replaces it.
STYLE = (
    "<style>.jp-OutputArea-child:has(+ .jp-OutputArea-child [data-dalembert-still]) .jupyter-widgets:not(:has(*))"
    "{display: none}</style>"
)


def show(container: Any) -> None:
    """Show all systems of a container below the cell that is running."""
    viewer = viewer_of(container)
    if viewer is None:
        name = secrets.token_hex(8)
        viewer = start(container, link=lambda receive: WidgetLink(receive, make(name)))
        _stills[viewer] = Still(viewer, name)
    link = viewer.server
    if isinstance(link, WidgetLink):
        link.displayed()
        import_module("IPython.display").display(link.widget)
        _stills[viewer].display()


class Still:
    """The static view below a widget; it is updated after each cell if its contents change."""

    def __init__(self, viewer: Viewer, name: str) -> None:
        self._viewer, self._name = viewer, name
        self._known: object = None
        self._handle: Any = None
        self._events = import_module("IPython").get_ipython().events
        self._events.register("post_run_cell", self._after_cell)
        viewer.at_end = self.end

    def display(self) -> None:
        """Show the page below the cell that is running."""
        shown = import_module("IPython.display")
        self._known = self._seen()
        self._handle = shown.display(shown.HTML(self._text()), display_id=True)

    def end(self) -> None:
        """Keep the last view permanently."""
        self._update()
        self._events.unregister("post_run_cell", self._after_cell)
        del _stills[self._viewer]

    def _after_cell(self, result: object = None) -> None:
        del result
        if isinstance(self._viewer.server, WidgetLink):
            self._viewer.server.cell_ended()
        self._update()

    def _update(self) -> None:
        seen = self._seen()
        if self._handle is not None and seen != self._known:
            self._known = seen
            self._handle.update(import_module("IPython.display").HTML(self._text()))

    def _seen(self) -> object:
        """Return a key of the contents of the view that is fast to compute."""
        return _or_none(lambda: _state(self._viewer.container))

    def _text(self) -> str:
        container = self._viewer.container
        text = _or_none(lambda: showing.frame(page_of_state(container)))
        if text is None or len(text) > LARGEST:
            text = _or_none(lambda: _picture(container)) or "<p>There is nothing to be seen yet.</p>"
        return f'{STYLE}<div data-dalembert-still="{self._name}">{text}</div>'


_stills: dict[Viewer, Still] = {}


def _or_none(make: Callable[[], Any]) -> Any:
    """Return the result of a function, None after an error: an automatic picture must not make a cell fail."""
    try:
        return make()
    except Exception:
        return None


def _state(container: Any) -> object:
    from dalembert._core import ConfigurationType

    shown, systems = ConfigurationType.Visualization, range(container.NumberOfSystems())
    parts: list[object] = [repr(container.visualizationSettings.GetDictionary()), repr(state_of(container.renderer, 0))]
    for mbs in map(container.GetSystem, systems):
        data = mbs.systemData
        parts += [getattr(data, f"NumberOf{kind}s")() for kind in ("Node", "Object", "Marker", "Load", "Sensor")]
        state = _or_none(partial(data.GetSystemState, shown))
        parts += [None if state is None else b"".join(part.tobytes() for part in state)]
    return hash(tuple(parts))


def _picture(container: Any) -> str:
    from base64 import b64encode
    from io import BytesIO

    from PIL import Image

    file = BytesIO()
    Image.fromarray(container.renderer.RedrawAndGetImage()).save(file, "png")
    return f'<img alt="the system" src="data:image/png;base64,{b64encode(file.getvalue()).decode()}" />'
