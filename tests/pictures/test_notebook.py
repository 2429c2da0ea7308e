"""Notebooks show systems by a widget while their kernel runs, and by a page that is saved with them afterwards."""

from __future__ import annotations

import base64
import html
import json
import os
import queue
import re
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from browser import Browser, Tab, running
from test_page import unpacked

import dalembert as exu
from dalembert import graphics
from dalembert._live import viewer as viewers
from dalembert._live import widget as widgets
from dalembert._live.messages import Picture
from dalembert._live.viewer import Viewer
from dalembert._live.widget import WidgetLink
from dalembert.utilities import InertiaCuboid

nbformat = pytest.importorskip("nbformat", reason="nbclient is not installed")
nbclient = pytest.importorskip("nbclient", reason="nbclient is not installed")
WIDGET = "application/vnd.jupyter.widget-view+json"

MODEL = """
import dalembert as exu
from dalembert.utilities import *
SC = exu.SystemContainer()
mbs = SC.AddSystem()
body = mbs.CreateRigidBody(name="<img src=x onerror=alert(1)>", inertia=InertiaCuboid(1000, [0.4, 0.2, 0.1]), gravity=[0, -2, 0])
mbs.Assemble()
"""
SOLUTION = """
settings = exu.SimulationSettings()
settings.timeIntegration.numberOfSteps = 100
settings.solutionSettings.solutionWritePeriod = 0.1
mbs.SolveDynamic(settings)
"""


def executed(*cells: str) -> list[list[Any]]:
    """Run a notebook; return the outputs of its cells."""
    notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(cell) for cell in cells])
    nbclient.NotebookClient(notebook, timeout=120, kernel_name="python3").execute()
    return [cell.outputs for cell in notebook.cells]


def pages(outputs: list[Any]) -> list[str]:
    """Return the pages in the frames of outputs."""
    texts = [output.data.get("text/html", "") for output in outputs if "data" in output]
    return [html.unescape(found) for text in texts for found in re.findall(r'srcdoc="([^"]*)"', text)]


def head_of(page: str) -> dict[str, Any]:
    found = re.search(r'id="data">([^<]*)<', page)
    assert found is not None
    return unpacked(base64.b64decode(found[1]))[0]


@pytest.fixture(scope="module")
def outputs(tmp_path_factory: pytest.TempPathFactory) -> list[list[Any]]:
    folder = tmp_path_factory.mktemp("notebook")
    before = Path.cwd()
    os.chdir(folder)
    try:
        return executed(MODEL + "mbs", "SC.renderer.Start()", SOLUTION, "mbs.SolutionViewer()", "SC.renderer.Stop()")
    finally:
        os.chdir(before)


def test_a_system_is_a_widget_a_page_and_a_table(outputs: list[list[Any]]) -> None:
    widget, still, table = outputs[0]
    assert WIDGET in widget.data and widget.data["text/plain"] == widgets.WORDS
    (page,) = pages([still])
    assert head_of(page)["times"] == [0.0]
    assert "<td>RigidBody</td>" in table.data["text/html"]


def test_the_page_shows_the_state_after_the_last_cell_that_has_changed_it(outputs: list[list[Any]]) -> None:
    """It is that of the last place; previous cells remain unchanged."""
    widget, still, result = outputs[1]
    assert WIDGET in widget.data and result.data["text/plain"] == "True"
    (page,) = pages([still])
    assert head_of(page)["times"] == [pytest.approx(1.0)]


def test_a_solution_is_a_page_that_plays(outputs: list[list[Any]]) -> None:
    (page,) = pages(outputs[3])
    head = head_of(page)
    assert head["times"] == pytest.approx([k / 10 for k in range(11)]) and head["plays"]


def test_nothing_of_the_machine_or_of_the_model_is_in_the_outputs(outputs: list[list[Any]]) -> None:
    text = json.dumps(outputs)
    assert str(Path.home()) not in text and "127.0.0.1" not in text and "onerror=alert(1)>" not in text
    assert "Warning" not in text
    assert all(len(page) < 300_000 for cell in outputs for page in pages(cell))


def test_a_browser_shows_the_saved_outputs_without_a_kernel(outputs: list[list[Any]], browser: Browser) -> None:
    """Pages in sequence, as notebooks and their exports have them; nothing is loaded."""
    texts = [output.data.get("text/html", "") for cell in outputs for output in cell if "data" in output]
    Path("saved.html").write_text("<!doctype html><body>" + "".join(texts), "utf-8")
    tab = browser.tab(Path("saved.html").resolve().as_uri())
    tab.wait("document.querySelectorAll('iframe').length === 3")
    tab.close()
    for number, page in enumerate(page for cell in outputs for page in pages(cell)):
        path = Path(f"page{number}.html")
        path.write_text(page, "utf-8")
        alone = browser.tab(path.resolve().as_uri())
        alone.wait("page.drawn > 0 && page.items.length > 0")
        assert alone.value("performance.getEntriesByType('resource').length") == 0 and alone.errors == []
        alone.close()
    assert {r.split(":")[0] for r in tab.requests} <= {"file", "about", "data", "blob"}


def test_where_widgets_are_not_wanted(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("DALEMBERT_VIEWER", "off")
    (shown,), (*_, result) = executed(MODEL + "mbs", "SC.renderer.Start(), SC.renderer.DoIdleTasks()")
    assert WIDGET not in shown.data and "<table>" in shown.data["text/html"]
    assert result.data["text/plain"] == "(False, False)"


def test_a_waiting_cell_continues_if_no_page_can_answer() -> None:
    """Nobody looks at a notebook that is executed by a program."""
    (*_, told) = executed(MODEL + "SC.renderer.Start()\nSC.renderer.DoIdleTasks()\nprint('on')")[0]
    assert "cannot be heard" in told.text and told.text.endswith("on\n")


# ---- the channel


class Widget:
    """The interface of a widget that WidgetLink uses."""

    def __init__(self) -> None:
        self.sent: queue.SimpleQueue[tuple[dict[str, Any], list[bytes]]] = queue.SimpleQueue()
        self.take: Callable[..., None] = lambda *_: None
        self.open = True

    def on_msg(self, take: Callable[..., None]) -> None:
        self.take = take

    def send(self, content: dict[str, Any], buffers: list[bytes] | None = None) -> None:
        json.dumps(content)
        self.sent.put((content, buffers or []))

    def close(self) -> None:
        self.open = False

    def say(self, **message: Any) -> None:
        self.take(self, message, [])

    def told(self) -> list[tuple[dict[str, Any], list[bytes]]]:
        found = []
        while not self.sent.empty():
            found.append(self.sent.get())
        return found


@pytest.fixture
def widget() -> Widget:
    return Widget()


@pytest.fixture
def heard() -> list[tuple[int, str]]:
    return []


@pytest.fixture
def link(widget: Widget, heard: list[tuple[int, str]]) -> WidgetLink:
    return WidgetLink(lambda page, message: heard.append((page, message["kind"])), widget)


def test_a_page_gets_the_scene_and_then_motions(widget: Widget, link: WidgetLink, heard: list[Any]) -> None:
    assert not link.wanted
    widget.say(kind="hello", page="a")
    assert link.wanted and link.pages == 1 and heard == [(1, "opened")]
    link.publish(Picture(7, lambda: b"whole", [b"fra", b"me"]))
    assert widget.told() == [({"page": "a"}, [b"whole"])]
    assert not link.wanted  # it has not drawn it yet
    link.publish(Picture(7, lambda: b"whole", [b"later"]))
    assert widget.told() == []
    widget.say(kind="shown", page="a")
    assert widget.told() == [({"page": "a"}, [b"later"])]
    widget.say(kind="bye", page="a")
    assert link.pages == 0 and heard[-1] == (1, "closed")


def test_a_silent_page_gets_pictures_slowly(widget: Widget, link: WidgetLink, monkeypatch: pytest.MonkeyPatch) -> None:
    """A running cell in a kernel without other threads; large pictures come more slowly still."""
    now = [100.0]
    monkeypatch.setattr(widgets.time, "monotonic", lambda: now[0])
    widget.say(kind="hello", page="a")
    sent = []
    for _ in range(100):
        now[0] += 0.05
        if link.wanted:
            link.publish(Picture(1, lambda: b"whole", [b"fra", b"me"]))
        sent.append(len(widget.told()))
    assert sent[:19] == [1] + 18 * [0]  # it may still answer
    assert sum(sent[20:]) == pytest.approx(80 * 0.05 / widgets.PACE, abs=4)
    now[0] += 1
    link.publish(Picture(1, lambda: b"", [bytes(10_000_000)]))
    now[0] += 4
    assert not link.wanted
    now[0] += 2
    assert link.wanted


def test_a_page_that_was_displayed_is_served_before_it_is_heard_of(
    widget: Widget, link: WidgetLink, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A script in one cell: Start() and SolveDynamic(). It gets whole scenes: nobody knows whether it has got the first."""
    now = [100.0]
    monkeypatch.setattr(widgets.time, "monotonic", lambda: now[0])
    link.displayed()
    for _ in range(2):
        now[0] += 1
        assert link.wanted and link.pages == 1
        link.publish(Picture(1, lambda: b"whole", [b"fra", b"me"]))
        assert widget.told() == [({"page": ""}, [b"whole"])]
    link.cell_ended()
    assert not link.wanted and link.pages == 0


def test_a_page_that_is_not_seen_gets_nothing(widget: Widget, link: WidgetLink) -> None:
    widget.say(kind="hello", page="a")
    widget.say(kind="seen", page="a", flag=False)
    assert not link.wanted
    widget.say(kind="seen", page="a", flag=True)
    assert link.wanted


@pytest.mark.parametrize(
    "message", [None, [], "x", {}, {"kind": 1, "page": "a"}, {"kind": "hello"}, {"kind": "key", "page": "unknown"},
                {"kind": "hello", "page": "x" * 40}, {"kind": "hello", "page": ""}, {"kind": "hello", "page": 3}],
)  # fmt: skip
def test_invalid_messages_change_nothing(widget: Widget, link: WidgetLink, heard: list[Any], message: Any) -> None:
    widget.take(widget, message, [])
    assert heard == [] and link.pages == 0 and widget.told() == []


def test_there_are_not_too_many_pages(widget: Widget, link: WidgetLink) -> None:
    for k in range(100):
        widget.say(kind="hello", page=f"page {k}")
    assert link.pages == widgets.PAGES


def test_whether_a_page_can_be_heard(widget: Widget, link: WidgetLink, monkeypatch: pytest.MonkeyPatch) -> None:
    assert not link.answers()
    widget.say(kind="hello", page="a")
    monkeypatch.setattr(widgets, "ANSWER", 0.05)
    assert not link.answers()
    send = widget.send
    monkeypatch.setattr(widget, "send", lambda *words: (send(*words), widget.say(kind="alive", page="a")))
    assert link.answers()


# ---- the code of the widget, in a browser


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    with running() as started:
        yield started


@pytest.fixture
def viewer(SC: Any, mbs: Any, widget: Widget) -> Iterator[Viewer]:
    mbs.CreateRigidBody(
        inertia=InertiaCuboid(1000, [0.4, 0.4, 0.4]), gravity=[0, -1, 0],
        graphicsDataList=[graphics.Brick(size=[0.4, 0.4, 0.4], color=graphics.color.orange)],
    )  # fmt: skip
    mbs.Assemble()
    yield viewers.start(SC, link=lambda receive: WidgetLink(receive, widget))
    SC.renderer.Stop()
    assert not widget.open


NOTEBOOK = """<!doctype html><body><div id="cell"></div><div data-dalembert-still="s">saved</div><input id="other"><script type="module">
const code = new Blob([`@CODE@`], { type: "text/javascript" });
const { default: widget } = await import(URL.createObjectURL(code));
const takers = [];
window.sent = [];
window.deliver = (content, data) => {  // as JupyterLab does: buffers need not be aligned
  const bytes = data.map((text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0)));
  const moved = bytes.map((b) => { const whole = new Uint8Array(b.length + 3); whole.set(b, 3); return new DataView(whole.buffer, 3); });
  for (const take of takers) take(content, moved);
};
const model = {
  get: () => "s", send: (message) => sent.push(message),
  on: (name, take) => takers.push(take), off: (name, take) => takers.splice(takers.indexOf(take), 1),
};
window.cell = document.getElementById("cell");
window.leave = widget.render({ model, el: cell });
</script>"""


class Notebook:
    """A page with the widget, and messages to and fro."""

    def __init__(self, tab: Tab, widget: Widget) -> None:
        self.tab, self.widget = tab, widget

    def wait(self, expression: str, seconds: float = 40) -> None:
        """Pass messages on until an expression is true."""
        end = time.monotonic() + seconds
        while True:
            for content, buffers in self.widget.told():
                data = [base64.b64encode(part).decode() for part in buffers]
                self.tab.value(f"deliver({json.dumps(content)}, {json.dumps(data)})")
            for message in self.tab.value("sent.splice(0)"):
                self.widget.say(**message)
            if self.tab.value(expression):
                return
            assert time.monotonic() < end, (expression, self.tab.errors)
            time.sleep(0.02)


@pytest.fixture
def notebook(viewer: Viewer, widget: Widget, browser: Browser) -> Iterator[Notebook]:
    code = (
        widgets.code().replace("\\", "\\\\").replace("`", "\\`").replace("${", "\\${").replace("</script", "<\\/script")
    )
    Path("notebook.html").write_text(NOTEBOOK.replace("@CODE@", code), "utf-8")
    tab = browser.tab(Path("notebook.html").resolve().as_uri())
    tab.wait("!!window.leave")
    yield Notebook(tab, widget)
    assert tab.errors == []
    tab.close()


def test_the_widget_replaces_the_saved_view(notebook: Notebook) -> None:
    still = "document.querySelector('[data-dalembert-still]').checkVisibility()"
    assert notebook.tab.value(still)  # until the kernel answers
    notebook.wait("cell.live.frames > 0 && cell.live.drawn > 0")
    assert not notebook.tab.value(still)
    assert notebook.tab.value("cell.live.itemAt(...cell.live.projected([0, 0, 0]))")[:3] == ["Object", 0, "RigidBody"]
    notebook.tab.value("leave()")
    assert notebook.tab.value(still)
    notebook.wait("true")


def test_the_widget_follows_a_solver_and_takes_keys_only_when_it_has_been_clicked(mbs: Any, notebook: Notebook) -> None:
    import threading

    notebook.wait("cell.live.frames > 0")
    settings = exu.SimulationSettings()
    settings.timeIntegration.endTime = 1000
    settings.timeIntegration.numberOfSteps = 1_000_000
    settings.solutionSettings.writeSolutionToFile = False
    thread = threading.Thread(target=lambda: mbs.SolveDynamic(settings), daemon=True)
    thread.start()
    notebook.wait("cell.live.frames > 5 && parseFloat(cell.live.time.textContent.slice(4)) > 0")
    notebook.tab.value("document.getElementById('other').focus()")
    notebook.tab.press("q")
    assert notebook.tab.value("sent.every((message) => message.kind !== 'key')")
    x, y = notebook.tab.value("[300, 100]")
    notebook.tab.click(x, y)
    notebook.tab.press("q")
    notebook.wait("cell.live.state.textContent === ''")
    thread.join(20)
    assert not thread.is_alive()
