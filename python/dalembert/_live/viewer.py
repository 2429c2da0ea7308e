"""A viewer shows the systems of a container on pages, while solvers work on them or scripts wait.

It draws copies of the systems (shadows), in a thread of its own: solvers only copy their state now and then, and
nothing that is drawn can change a result. Readers can: they set parameters, and pull bodies with the mouse.
"""

from __future__ import annotations

import atexit
import copy
import queue
import threading
import time
from collections.abc import Callable
from typing import Any

import numpy as np

from dalembert import _core
from dalembert._live import details, keys, views
from dalembert._live.histories import History
from dalembert._live.messages import Stage
from dalembert._live.opening import PATIENCE, RETURN
from dalembert._live.pulls import Pull, released
from dalembert._live.records import Past, Plots
from dalembert._live.server import PageServer
from dalembert._live.widget import WidgetLink
from dalembert._pictures import draw, forces
from dalembert._pictures.camera import PERSPECTIVE_OF_PAGES, Camera
from dalembert._pictures.flow import Flow
from dalembert._pictures.looks import Looks
from dalembert._pictures.notices import tell_settings_of_pictures
from dalembert._pictures.renderer import state_of
from dalembert._pictures.studio import Studio

SHORTEST = 1 / 30  # s between pictures, unless settings say otherwise
SHARE = 0.25  # maximum fraction of the time for pictures: other threads need the interpreter
LARGE = 50_000  # objects, whose scene takes seconds
LONGEST_NAME = 40  # characters of a drag
OFTEN = 0.5  # s between polls of changes without a signal: settings that scripts change, outputs of the selected item

Receive = Callable[[int, dict[str, Any]], None]
Link = PageServer | WidgetLink
_viewers: list[Viewer] = []


def viewer_of(container: Any) -> Viewer | None:
    """Return the viewer of a container, if it has one."""
    return next((viewer for viewer in _viewers if viewer.container is container), None)


def start(container: Any, port: int = 0, link: Callable[[Receive], Link] | None = None) -> Viewer:
    """Return the viewer of a container; starts it if necessary."""
    viewer = viewer_of(container)
    if viewer is None:
        viewer = Viewer(container, link or (lambda receive: PageServer(receive, port)))
        _viewers.append(viewer)
    return viewer


@atexit.register
def stop_all() -> None:
    """Close all pages: the interpreter ends."""
    for viewer in list(_viewers):
        viewer.stop()


class Viewer:
    """Browsers, their systems, and user actions."""

    def __init__(self, container: Any, link: Callable[[Receive], Link]) -> None:
        """`link` reaches pages: a server of this machine, or the channel of a notebook."""
        self.container, self.settings = container, container.visualizationSettings
        self.shadows: list[Any] = []
        self._histories: list[History] = []
        self.past, self.plots = Past(), Plots()
        self.studio: Studio | None = None
        self.stage = Stage()
        self.selection: tuple[int, str, int, float] | None = None
        self.mouse, self.mouse_place = [0.0, 0.0], [0.0, 0.0]
        self.pictures = 0
        self.values: dict[str, Any] = {}  # values of the controls of a dialog
        self.pressed: list[str] = []  # buttons of a dialog, in their order
        self._controls: dict[str, Any] = {}
        self._messages: queue.SimpleQueue[tuple[int, dict[str, Any]]] = queue.SimpleQueue()
        self._calls: queue.SimpleQueue[Callable[[], object]] = queue.SimpleQueue()
        self._wake, self._released, self._stopped = threading.Event(), threading.Event(), threading.Event()
        self._dirty = self._home = self._views = True
        self._paused = self._waits = False
        self._stale = False  # items have changed since the studio was made
        self._lacks = False  # more of the states than where items are is wanted, and not known
        self._made = self._checked = self._next = 0.0
        self._known_settings = copy.copy(self.settings)
        self._interval = self._wanted_interval()
        self._complaint = ""
        self._changes: dict[tuple[int, str, int, str], float] = {}  # parameters that pages want to have other values
        self._told: dict[str, Any] = {}  # last message of the state
        self._told_times: dict[str, Any] = {}  # last message of the recorded times
        self._flow: Flow | None = None  # if nothing but places may have changed
        self._words: dict[Any, dict[str, Any]] = {}  # last message of the settings, by what else is in it
        self._pull: Pull | None = None  # the body that a reader pulls
        self._forces = bool(state_of(container.renderer, 0).get("showForces"))  # their arrows are drawn
        self._seen = 0.0  # when a page was there, or is expected
        self.expect(PATIENCE["browser"])
        self.at_end: Callable[[], object] = lambda: None
        self.server = link(self._receive)
        self._thread = threading.Thread(target=self._work, name="dalembert viewer", daemon=True)
        self._thread.start()

    # ---- for scripts

    def expect(self, seconds: float) -> None:
        """Count on a page that is opened within so many seconds."""
        self._seen = time.monotonic() + seconds - RETURN

    @property
    def watched(self) -> bool:
        """Return whether a page is open, or about to be."""
        if self.server.pages:
            self._seen = time.monotonic()
        return not self._stopped.is_set() and time.monotonic() - self._seen < RETURN

    def stop(self) -> None:
        """Close all pages."""
        if self in _viewers:
            _viewers.remove(self)
        self._stopped.set()
        self._pause(False)
        self._released.set()
        self._wake.set()
        self.server.tell({"kind": "stopped"})
        if threading.current_thread() is not self._thread:
            self._thread.join(2.0)
        self._end_pull()
        self.at_end()
        self.server.stop()

    def redraw(self, home: bool = False) -> None:
        """Draw again, although no state has changed; `home` fits the view to the scene."""
        self._dirty = True
        self._home = self._home or home
        self._wake.set()

    def show_views(self) -> None:
        """Let pages show the other views that are enabled, as the render state says."""
        self._views = True
        self.redraw()

    def set_camera(self) -> None:
        """Let pages look as the render state says."""
        state = state_of(self.container.renderer, 0)
        if {"zoom", "modelRotation", "centerPoint"} <= state.keys() and float(state["zoom"]) > 0:
            rotation = np.asarray(state["modelRotation"], float).reshape(3, 3).T
            seen = Camera(rotation, np.asarray(state["centerPoint"], float), float(state["zoom"]))
            self.server.tell({"kind": "camera", "camera": seen.words()})
        else:
            self.redraw(home=True)

    def idle(self, seconds: float, announce: bool) -> bool:
        """Wait for this time or, if it is negative, until the user continues; return whether a browser is connected."""
        self._released.clear()
        self.redraw()
        forever = seconds < 0
        end = time.monotonic() + seconds
        if forever and not self.server.answers():
            _core.Print("dalembert: pages cannot be heard while this cell runs; nothing waits for them.")
            return self.watched
        if forever:
            self._waits = True
            self._tell_state()
            if announce:
                first = "" if self.server.pages else "open the page, and "
                _core.Print(f"Computation paused: {first}press SPACE on the page to continue.")
        try:
            while self.watched:
                self.run_calls()
                left = 0.05 if forever else min(end - time.monotonic(), 0.05)
                if left <= 0 or self._released.wait(left):
                    break
        finally:
            self._waits = False
            if forever:
                self._tell_state()
        if forever and announce and not self.watched and not self._stopped.is_set():
            _core.Print("dalembert: no page is open; the computation goes on.")
        return self.watched

    def run_calls(self) -> None:
        """Run functions of the user that pages have asked for."""
        while not self._calls.empty():
            self._calls.get()()

    def show_controls(self, controls: dict[str, Any], values: dict[str, Any]) -> None:
        """Show the widgets of a dialog: title, items, plots."""
        self._controls, self.values, self.pressed = controls, dict(values), []
        self.server.tell({"kind": "controls", **controls})

    def tell(self, message: dict[str, Any]) -> None:
        """Send a message to all pages."""
        self.server.tell(message)

    # ---- called in the thread of the viewer --------------------------------------------------------------------------

    def _receive(self, page: int, message: dict[str, Any]) -> None:
        """Receive a message; called in the thread of the server."""
        self._messages.put((page, message))
        self._wake.set()

    def _work(self) -> None:
        self._prepare()
        while not self._stopped.is_set():
            begin, used = time.monotonic(), time.thread_time()
            interval = self._interval
            try:
                while not self._messages.empty():
                    self._answer(*self._messages.get())
                if self.server.wanted and (self._dirty or begin >= self._next) and self._look():
                    self._next = begin + interval
            except Exception as error:  # errors of a user function, or of graphics data
                self._complain(error)
            spent, used = time.monotonic() - begin, time.thread_time() - used
            pause = max(min(interval, SHORTEST) - spent, used / SHARE - used, 0.001)
            time.sleep(pause) if pause < 2 * SHORTEST else self._stopped.wait(pause)
            if not self.server.pages:
                self._wake.wait(1.0)
                self._wake.clear()

    def _prepare(self) -> None:
        """Draw a first scene, so that it is there when the first page is; large ones wait for a reader."""
        self._dirty, self._known_settings = False, copy.copy(self.settings)
        try:
            systems = [self.container.GetSystem(i) for i in range(self.container.NumberOfSystems())]
            if sum(mbs.systemData.NumberOfObjects() for mbs in systems) >= LARGE:
                return  # copying their items would keep the script waiting as well
            self._follow()
            if self.studio is not None and not self._stopped.is_set():
                self.studio.flow()
        except Exception as error:
            self._complain(error)

    def _wanted_interval(self) -> float:
        path = "general.graphicsUpdateInterval"
        looks = Looks(self.settings)
        return SHORTEST if looks.is_default(path) else max(float(looks.setting(path)), 0.01)

    def _complain(self, error: Exception) -> None:
        """Report an error once."""
        words = f"{type(error).__name__}: {error}"
        if words != self._complaint:
            self._complaint = words
            _core.Print(f"dalembert, page: {words}")
            self.server.tell({"kind": "notice", "text": words})

    def _look(self) -> bool:
        """Draw if something has changed; return whether it has."""
        news = self._follow()
        self._check_now_and_then()
        if not (news or self._dirty or self._views or self._lacks):
            return False
        assert self.studio is not None
        if self._flow is not None and not (self._dirty or self._views):
            moved = self.stage.moved(self._flow)
            if moved is not None:
                self.server.publish(moved)
                self.pictures += 1
                self._tell_pull()
                return True
        self._lacks = not self._knows_states()
        if self._lacks:
            return False
        if self._dirty:
            self.studio.settings_changed()
            self._words = {}
        self._dirty = False
        scene = self.studio.flow()
        self._know_settings()  # settings of the scene may change back before the next poll
        studio = self.studio

        def camera() -> Camera:
            return draw.camera_for(studio, scene, None, (1024, 768), 1.0)

        looks = self.studio.makers[0].looks if self.studio.makers else Looks(self.settings)
        if not self._words:
            tell_settings_of_pictures(self.settings)
        scales = [maker.forces.words(maker.looks.size) for maker in self.studio.makers if maker.forces is not None]
        known = scene.value_name, *scales
        others = {"forces": "\n".join(scales), "upwards": self.studio.upwards()}
        words = self._words.get(known) or views.words(self.settings, scene, looks) | others
        self._words = {known: words}
        self.server.publish(self.stage.messages(scene, looks, words, camera))
        self.pictures += 1
        self._tell_pull()
        if self._home:
            self._home = False
            self.server.tell({"kind": "camera", "camera": camera().words()})
        if self._views:
            self._views = False
            self.server.tell({"kind": "views", "views": views.beside(self.container, self.studio, scene)})
        return True

    def _only_moving(self) -> Flow | None:
        """Return the flow if only positions of items may have changed."""
        if self._dirty or self._home or self._views or self._lacks or self.studio is None:
            return None
        return self.studio.moving()

    def _knows_states(self) -> bool:
        """Return whether all of the states is known; otherwise solvers have been asked for it."""
        return all(shadow.complete for shadow in self.shadows)

    def _follow(self) -> bool:
        """Let the shadows follow their systems; return whether there is something new."""
        count = self.container.NumberOfSystems()
        changed = len(self.shadows) != count
        if changed:
            systems = [self.container.GetSystem(i) for i in range(count)]
            self.shadows = [_core._Shadow(mbs) for mbs in systems]
            self._histories = [History(*both, self.settings) for both in zip(systems, self.shadows, strict=True)]
        self._flow = self._only_moving()
        places = self.selection is None and self._flow is not None and not self.past.is_due()
        news = [shadow.follow(places) for shadow in self.shadows]
        moved, items, structure = [new[0] for new in news], any(new[1] for new in news), any(new[2] for new in news)
        if changed or structure:
            self.past.begin(self.shadows)
            self.plots.drop()
            self._end_pull()
        state = self.past.take(moved)
        for history in self._histories:
            history.rests = self.past.time is not None
        self._stale = self._stale or items
        now = time.monotonic()
        again = changed or structure or self.studio is None or (self._stale and now - self._made > OFTEN)
        if again:
            self._made, self._stale = now, False
            self.studio = Studio(self.container, [shadow.system for shadow in self.shadows])
            self.studio.perspective = PERSPECTIVE_OF_PAGES
            for maker, history in zip(self.studio.makers, self._histories, strict=True):
                maker.stored = history.rows
                maker.show_forces(self._forces)
                history.forget_frames()
            self._home = self._home or changed or structure
        if again or items:
            self._flow = None
        return again or items or state

    def _check_now_and_then(self) -> None:
        now = time.monotonic()
        if now - self._checked < OFTEN:
            return
        self._checked = now
        self._know_settings()
        if self.selection is not None and self._knows_states():
            self._tell_details(*self.selection[:3])
        if self._state() != self._told:
            self._tell_state()
        self._tell_times()
        self._tell_plots()

    def _know_settings(self) -> None:
        if not self.settings._equals(self._known_settings):
            self._known_settings, self._dirty = copy.copy(self.settings), True
            self._interval = self._wanted_interval()

    # ---- messages of pages

    def _answer(self, page: int, message: dict[str, Any]) -> None:
        action = getattr(self, f"_on_{message['kind']}", None)
        if action is None:
            return
        try:
            action(page, message)
        except (KeyError, TypeError, ValueError, IndexError, AttributeError, OverflowError) as error:
            self.server.tell({"kind": "notice", "text": f"{message['kind']}: {error}"}, page)

    def _on_opened(self, page: int, message: dict[str, Any]) -> None:
        self._views = True
        self._tell_state(page)
        self.server.tell(self.past.words(), page)
        if curves := self.plots.curves(self.shadows):
            self.server.tell({"kind": "outputs", "curves": curves}, page)
        if self._controls:
            self.server.tell({"kind": "controls", **self._controls, "values": self.values}, page)

    def _on_closed(self, page: int, message: dict[str, Any]) -> None:
        if self._pull is not None and self._pull.page == page:
            self._end_pull()

    def _on_key(self, page: int, message: dict[str, Any]) -> None:
        key, control, shift = str(message["key"]), bool(message["control"]), bool(message["shift"])
        held = int(shift) + 2 * control + 4 * bool(message.get("alt"))
        action = int(message.get("action", 1))
        ignores = bool(self.settings.interactive.ignoreKeys)
        if ignores and key not in ("F2", "Escape"):
            function = self.settings.interactive.keyPressUserFunction
            if callable(function) and keys.code(key):
                self._leave(lambda: function(keys.code(key), action, held))
            return
        if action == 0:
            return
        if key == " ":
            self._space()
        elif key.lower() == "a":
            self._see_all()
        elif key.lower() == "q":
            self._stop_solvers()
        elif key == "Escape":
            self._stop_solvers()
            self._close()
        elif keys.press(self.settings, key, control or bool(message.get("alt")) or (shift and key.isalpha())):
            self._dirty = True
        self._tell_state()

    def _on_camera(self, page: int, message: dict[str, Any]) -> None:
        rotation = np.asarray(message["rotation"], float).reshape(3, 3)
        center, zoom = np.asarray(message["center"], float).reshape(3), float(message["zoom"])
        if not (np.isfinite(rotation).all() and np.isfinite(center).all() and 0 < zoom < np.inf):
            raise ValueError("expected finite numbers")
        number = int(message.get("view", 0))
        if number not in range(4):
            raise ValueError(f"expected a view from 0 to 3, received {number}")
        state = state_of(self.container.renderer, number)
        if number and not state.get("viewEnabled"):
            return  # the page alone has it
        state.update({"modelRotation": rotation.T.copy(), "centerPoint": center, "zoom": zoom})

    def _on_mouse(self, page: int, message: dict[str, Any]) -> None:
        self.mouse = [float(x) for x in message["pixels"]][:2]
        self.mouse_place = [float(x) for x in message["place"]][:2]

    def _on_select(self, page: int, message: dict[str, Any]) -> None:
        """Store the picked item, and send its details; item -1 clears the selection."""
        advanced = self.settings.interactive.advanced
        picked = self.stage.item(int(message["scene"]), int(message["item"]))
        if picked is None or not advanced.selectionLeftMouse:
            self.selection = None
            return
        kind, item, _, _, system = picked
        kind = forces.owner(picked) if kind == forces.KIND else kind
        if kind not in details.KINDS or not int(advanced.selectionLeftMouseItemTypes) >> details.KINDS.index(kind) & 1:
            self.selection = None
            return
        self.selection = (system, kind, item, float(message["depth"]))
        if self._knows_states():  # otherwise, soon
            self._tell_details(system, kind, item)

    def _on_settings(self, page: int, message: dict[str, Any]) -> None:
        self.server.tell({"kind": "settings", "rows": keys.rows(self.settings)}, page)

    def _on_set(self, page: int, message: dict[str, Any]) -> None:
        refused = keys.change(self.settings, str(message["path"]), str(message["value"]))
        self._dirty = True
        if refused:
            self.server.tell({"kind": "notice", "text": refused}, page)

    def _on_control(self, page: int, message: dict[str, Any]) -> None:
        """Take the value of a widget of a dialog, if there is such a widget."""
        name = str(message["name"])
        if message.get("pressed"):
            self.pressed.append(name)
        elif name in self.values:
            value = message["value"]
            if not isinstance(value, (bool, int, float, str)):
                raise ValueError("expected a number or a text")
            self.values[name] = value

    def _on_plot(self, page: int, message: dict[str, Any]) -> None:
        """Plot an output of the selected item, or no longer plot one."""
        if "drop" in message:
            self.plots.drop(message["drop"] if message["drop"] is None else int(message["drop"]))
        elif self.selection is not None:
            system, kind, number, _ = self.selection
            name = str(message["name"])
            if details.output(self.shadows[system].system, kind, number, name) is not None:
                self.plots.choose(system, kind, number, name)
        self._tell_plots()

    def _on_parameter(self, page: int, message: dict[str, Any]) -> None:
        """Change a parameter of an item: between two steps, or while a script waits."""
        system, kind, number = int(message["system"]), str(message["item"]), int(message["number"])
        name, value = str(message["name"]), float(message["value"])
        known = details.numbers(self.shadows[system].system, kind, number) if kind in details.KINDS else {}
        if name not in known or not np.isfinite(value):
            raise ValueError(f"{kind} {number} has no number '{name}' that pages can change to {value}")
        self._changes[system, kind, number, name] = value
        self._leave(self._change)

    def _change(self) -> None:
        """Give parameters the values that pages want; called where the systems may be changed."""
        while self._changes:
            (system, kind, number, name), value = self._changes.popitem()
            getattr(self.container.GetSystem(system), f"Set{kind}Parameter")(number, name, value)

    def _on_forces(self, page: int, message: dict[str, Any]) -> None:
        """Draw arrows of forces, or none."""
        self._forces = not self._forces
        state_of(self.container.renderer, 0)["showForces"] = self._forces  # images follow
        for maker in self.studio.makers if self.studio is not None else []:
            maker.show_forces(self._forces)
        self._dirty = True

    def _on_seek(self, page: int, message: dict[str, Any]) -> None:
        """Look back, or at the present state."""
        when, speed = message["time"], float(message.get("speed", 1.0))
        if when is not None and not np.isfinite(float(when)) or not 0 < speed < np.inf:
            raise ValueError("expected finite numbers, and a positive speed")
        when = None if when is None else float(when)
        self._end_pull()
        self.past.seek(when, int(message.get("step", 0)), bool(message.get("plays")), speed)
        self._tell_times()

    def _on_pull(self, page: int, message: dict[str, Any]) -> None:
        """Pull a body: the first message of a drag names item and point, all have the position of the mouse."""
        target, strength = np.asarray(message["target"], float).reshape(3), float(message["strength"])
        try:
            if not (np.isfinite(target).all() and 0 < strength < np.inf):
                raise ValueError("expected finite numbers, and a positive strength")
            if "item" in message:
                self._hold(page, message)
            if self._is_held(page, message):
                assert self._pull is not None
                self._pull.pull(target.tolist(), strength)
                self._tell_pull()
        except (RuntimeError, ValueError) as error:  # an item that cannot be pulled
            self._on_release(page, message)
            self.server.tell(released(_drag(message)), page)
            raise ValueError(str(error)) from error

    def _hold(self, page: int, message: dict[str, Any]) -> None:
        """Hold the body that a page has picked, in place of the one that was held before."""
        picked = self.stage.item(int(message["scene"]), int(message["item"]))
        point, time = np.asarray(message["point"], float).reshape(3), float(message["time"])
        if picked is None or not np.isfinite(point).all():
            raise ValueError("the item is not there any more")
        if self.past.time is not None:
            raise ValueError("an earlier state is shown; go back to the live view to pull bodies")
        shadow = self.shadows[picked.system]
        if not (shadow.solving or self._controls):
            raise ValueError("no solver is running; bodies are pulled while one runs or is paused")
        self._end_pull()
        assert self.studio is not None
        maker, record = self.studio.makers[picked.system], self.past.record_of(picked.system)
        self._pull = Pull(page, _drag(message), shadow, maker, picked, point, record, time)

    def _on_release(self, page: int, message: dict[str, Any]) -> None:
        """Let go of the body that a page pulls."""
        if self._is_held(page, message):
            self._end_pull()

    def _is_held(self, page: int, message: dict[str, Any]) -> bool:
        """Return whether a message is about the body that is held now: pages may be late."""
        return self._pull is not None and (self._pull.page, self._pull.name) == (page, _drag(message))

    # ---- what they lead to

    def _end_pull(self) -> None:
        """Let go of the body that a page pulls."""
        if self._pull is not None:
            pull, self._pull = self._pull, None
            pull.end()
            self.server.tell(released(pull.name))

    def _tell_pull(self) -> None:
        if self._pull is not None:
            self.server.tell(self._pull.words())

    def _leave(self, call: Callable[[], object]) -> None:
        """Leave a function of the user for the thread that works on the systems, or waits."""

        def guarded() -> None:
            try:
                call()
            except Exception as error:
                self._complain(error)

        self._calls.put(guarded)
        for shadow in self.shadows:
            shadow.ask()

    def _space(self) -> None:
        if self._waits:
            self._released.set()
        elif self.settings.interactive.advanced.pauseWithSpacebar:
            self._pause(not self._paused)

    def _see_all(self) -> None:
        """Let pages see all from where they look."""
        for name in ("zoom", "centerPoint"):
            state_of(self.container.renderer, 0).pop(name, None)
        self.redraw(home=True)

    def _pause(self, flag: bool) -> None:
        self._paused = flag
        for shadow in self.shadows:
            shadow.pause(flag)

    def _stop_solvers(self) -> None:
        for i in range(self.container.NumberOfSystems()):
            self.container.GetSystem(i).SetRenderEngineStopFlag(True)
        self._pause(False)
        self._released.set()

    def _close(self) -> None:
        """Close all pages at the wish of a reader."""
        self.stop()

    def _state(self) -> dict[str, Any]:
        solving = any(shadow.solving for shadow in self.shadows)
        words = "waits: press space to continue" if self._waits else "paused" if self._paused else ""
        return {"kind": "state", "solving": solving, "text": words or ("solving" if solving else "")}

    def _tell_state(self, page: int | None = None) -> None:
        state = self._state()
        if page is None:
            self._told = state
        self.server.tell(state, page)

    def _tell_times(self) -> None:
        words = self.past.words()
        if words != self._told_times:
            self._told_times = words
            self.server.tell(words)

    def _tell_plots(self) -> None:
        if (curves := self.plots.renewed(self.shadows, self.past)) is not None:
            self.server.tell({"kind": "outputs", "curves": curves})

    def _tell_details(self, system: int, kind: str, number: int) -> None:
        mbs = self.shadows[system].system
        graphics = bool(self.settings.interactive.advanced.selectionRightMouseGraphicsData)
        words: dict[str, Any] = {"title": f"{kind.lower()} {number}", "units": details.units(mbs, kind, number)}
        words |= {"parameters": details.parameters(mbs, kind, number, graphics)}
        words |= {"numbers": details.numbers(mbs, kind, number), "item": [system, kind, number]}
        words |= {"outputs": details.outputs(mbs, kind, number), "time": mbs.systemData.GetTime(details.SHOWN)}
        self.server.tell({"kind": "details", **words})


def _drag(message: dict[str, Any]) -> str:
    """Return the name that a page has given to a drag."""
    return str(message["id"])[:LONGEST_NAME]
