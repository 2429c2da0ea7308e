"""The channel of a notebook: a widget whose views are pages, and messages of the kernel instead of a socket.

While a cell runs, kernels take no messages, except those that have another thread for them (subshells) and a notebook
that uses it, once it has sent a first message. Pages that do not answer get pictures at a moderate pace.
"""

from __future__ import annotations

import contextvars
import threading
import time
from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import Any

from dalembert._live.messages import Picture

FOLDER = Path(__file__).resolve().parent.parent / "_pictures" / "page"
WORDS = "live view, while the kernel runs"
PAGES = 16  # views, at most
PATIENCE = 1.0  # s until a page counts as one that does not answer
PACE = 0.2  # s between pictures for those
SPEED = 2e6  # bytes per s for those
ANSWER = 3.0  # s for a page to say that it is there


def is_installed() -> bool:
    """Return whether the packages for widgets are installed."""
    try:
        import_module("anywidget")
    except ImportError:
        return False
    return True


def code() -> str:
    """Return the module of the widget."""
    from json import dumps

    bundle = (FOLDER / "bundle.js").read_text("utf-8")
    return f"{bundle}\nexport default dalembert.widget({dumps((FOLDER / 'style.css').read_text('utf-8'))});\n"


def make(name: str) -> Any:
    """Return a widget; `name` is that of the pictures in the notebook that it stands for."""
    anywidget, traitlets = import_module("anywidget"), import_module("traitlets")
    members = {"_esm": code(), "still": traitlets.Unicode(name).tag(sync=True), "__repr__": lambda self: WORDS}
    return type("System", (anywidget.AnyWidget,), members)()


@dataclass(eq=False)
class View:
    """A view of the widget; `ready`: it has drawn the last message."""

    number: int
    name: str = ""
    ready: bool = True
    seen: bool = True
    scene: int = -1
    picture: int = 0
    answered: float = 0.0
    free: float = 0.0  # when it gets the next picture although it has not answered


class WidgetLink:
    """Counterpart of PageServer for widgets; `receive(page number, message)` is called in a thread of the kernel."""

    def __init__(self, receive: Callable[[int, dict[str, Any]], None], widget: Any) -> None:
        self.widget = widget
        self._receive, self._views, self._count = receive, dict[str, View](), 0
        self._unknown: View | None = None  # a displayed view that has not yet sent a message
        self._newest, self._published = Picture(-1, bytes, ()), 0
        self._lock, self._heard = threading.RLock(), threading.Event()
        self._context = contextvars.copy_context()
        widget.on_msg(self._take)

    def displayed(self) -> None:
        """Expect a page, although the cell that shows it may keep it from being heard."""
        self._unknown = View(0, ready=False)

    def cell_ended(self) -> None:
        """Expect nothing any more: pages can be heard now."""
        self._unknown = None

    @property
    def address(self) -> str:
        """Return "", because widgets have no address."""
        return ""

    @property
    def pages(self) -> int:
        """Return how many pages there are, or seem to be."""
        return len(self._views) + (self._unknown is not None)

    @property
    def wanted(self) -> bool:
        """Return whether a page waits for something to draw, or has been silent for long."""
        return any(self._waits(view) for view in self._all())

    def answers(self) -> bool:
        """Return whether a page can be heard now."""
        if not self._views:
            return False
        self._heard.clear()
        self.tell({"kind": "alive"})
        return self._heard.wait(ANSWER)

    def publish(self, picture: Picture) -> None:
        """Send a frame, or the whole scene to views with another scene; busy views receive it when they are ready.

        Notebooks may lose messages: messages that require the previous picture are therefore not used.
        """
        with self._lock:
            self._newest, self._published = picture, self._published + 1
            for view in self._all():
                self._show(view)

    def tell(self, message: dict[str, Any], page: int | None = None) -> None:
        """Send a message to one page, or to all."""
        if page is None:
            self._send({"words": message})
        for view in self._all():
            if view.number == page and view.name:
                self._send({"page": view.name, "words": message})

    def stop(self) -> None:
        """End the widget; the pictures that are saved in the notebook take its place."""
        self._views, self._unknown = {}, None
        self.widget.close()

    def _all(self) -> list[View]:
        return [*self._views.copy().values(), *filter(None, [self._unknown])]

    @staticmethod
    def _waits(view: View) -> bool:
        now = time.monotonic()
        return view.seen and (view.ready or (now > view.free and now > view.answered + PATIENCE))

    def _show(self, view: View) -> None:
        picture, number = self._newest, self._published
        if view.picture >= number or not self._waits(view):
            return
        data = b"".join(picture.frame) if view.scene == picture.scene else picture.whole()
        view.ready, view.picture, view.free = False, number, time.monotonic() + max(PACE, len(data) / SPEED)
        if view.name:
            view.scene = picture.scene
        self._send({"page": view.name}, [data])

    def _send(self, content: dict[str, Any], buffers: list[bytes] | None = None) -> None:
        """Send in the context of the last message, from which kernels find the thread for the answer."""
        with self._lock:
            self._context.run(self.widget.send, content, buffers)

    def _take(self, widget: Any, message: Any, buffers: Any) -> None:
        """Take a message of a page."""
        del widget, buffers
        if not isinstance(message, dict):
            return
        kind, name = message.get("kind"), message.get("page")
        if not isinstance(kind, str) or not isinstance(name, str) or not 0 < len(name) < 40:
            return
        with self._lock:
            self._context = contextvars.copy_context()
            view = self._views.get(name) or (self._open(name) if kind == "hello" else None)
            if view is None:
                return
            view.answered = time.monotonic()
            self._heard.set()
            if kind == "shown":
                view.ready = True
                self._show(view)
            elif kind == "seen":
                view.seen = message.get("flag") is True
            elif kind == "bye":
                del self._views[name]
                message = {"kind": "closed"}
        if kind != "hello":
            self._receive(view.number, message)

    def _open(self, name: str) -> View | None:
        if len(self._views) >= PAGES:
            return None
        self._count += 1
        self._unknown = None
        view = self._views[name] = View(self._count, name)
        self._receive(view.number, {"kind": "opened"})
        return view
