"""The live page in a browser: it draws, picks, obeys keys, and asks nobody else for anything."""

from __future__ import annotations

import base64
import threading
import time
from collections.abc import Iterator
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from browser import Browser, Tab, running
from PIL import Image

import dalembert as exu
from dalembert import graphics
from dalembert._live.viewer import Viewer, viewer_of
from dalembert._pictures.html import data
from dalembert._pictures.motion import Still
from dalembert.itemInterface import SensorNode
from dalembert.utilities import InertiaCuboid

ALT, CONTROL, SHIFT = 1, 2, 8


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    with running() as started:
        yield started


@pytest.fixture
def model(mbs: Any) -> Any:
    """One item of each kind, each at its own position."""
    ground = mbs.CreateGround()
    body = mbs.CreateRigidBody(
        name="<img src=x onerror=alert(1)>", referencePosition=[1, 0, 0], inertia=InertiaCuboid(1000, [0.4, 0.4, 0.4]),
        graphicsDataList=[graphics.Brick(size=[0.4, 0.4, 0.4], color=graphics.color.orange)],
    )  # fmt: skip
    mass = mbs.CreateMassPoint(name="mass", referencePosition=[0, 1, 0], physicsMass=1, drawSize=0.3)
    mbs.CreateSpringDamper(bodyNumbers=[ground, body], stiffness=10, damping=0.01)
    mbs.CreateForce(bodyNumber=mass, loadVector=[0, 1e-3, 0])
    mbs.AddSensor(SensorNode(nodeNumber=0, outputVariableType=exu.OutputVariableType.Position, storeInternal=True))
    mbs.Assemble()
    return mbs


@pytest.fixture
def viewer(SC: Any, model: Any, monkeypatch: pytest.MonkeyPatch) -> Iterator[Viewer]:
    monkeypatch.setenv("DALEMBERT_VIEWER", "on")
    SC.renderer.Start()
    found = viewer_of(SC)
    assert found is not None
    yield found
    SC.renderer.Stop()


@pytest.fixture
def tab(browser: Browser, viewer: Viewer) -> Iterator[Tab]:
    opened = browser.tab(viewer.server.address)
    opened.wait("page.frames > 0 && page.drawn > 0")
    yield opened
    assert opened.errors == []
    opened.close()


def solving(mbs: Any, end: int = 100_000) -> threading.Thread:
    """A thread that solves until it is stopped, however long pages take."""
    settings = exu.SimulationSettings()
    settings.timeIntegration.endTime = end
    settings.timeIntegration.numberOfSteps = 1000 * end
    settings.timeIntegration.verboseMode = 0
    settings.solutionSettings.writeSolutionToFile = False
    thread = threading.Thread(target=lambda: mbs.SolveDynamic(settings), daemon=True)
    thread.start()
    return thread


def test_solutions_are_looked_through_in_front_of_it(model: Any, tab: Tab, viewer: Viewer) -> None:
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = 100
    settings.timeIntegration.verboseMode = 0
    model.SolveDynamic(settings)
    model.SolutionViewer(runOnStart=False)
    tab.wait("page.motion && page.motion.drawn > 0")
    tab.press("End")
    assert tab.value("page.motion.time.textContent") == "t = 1.000 s"
    tab.press(" ")  # plays again, and is none of the live page's
    assert tab.value("page.motion.playing") and tab.value("page.motion.frame") < 100
    tab.press("Escape")
    tab.wait("page.motion === null && document.querySelector('.replay') === null")
    assert not viewer._paused and not model.GetRenderEngineStopFlag()
    tab.press("n")
    tab.wait("page.items.every(([kind]) => kind !== 'Node')")


def test_a_click_on_an_output_plots_it_and_the_slider_looks_back(model: Any, tab: Tab, viewer: Viewer) -> None:
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = 20
    settings.timeIntegration.verboseMode = 0
    for end in (0.5, 1.0):
        settings.timeIntegration.endTime = end
        model.SolveDynamic(settings)
        tab.wait(f"page.now === {end} && Number(page.times.slider.max) === {end}")
    tab.value("page.pick({ number: page.items.findIndex((i) => i[0] === 'Object' && i[1] === 1), distance: 1 })")
    link = "[...document.querySelectorAll('[data-name=details] a')].find((a) => a.textContent === 'Position')"
    tab.wait(f"!!{link}")
    assert tab.value(f"{link}.closest('tr').lastChild.textContent") == "m"
    tab.value(f"{link}.click()")
    tab.wait("page.panels.chosen?.[0].drawn?.length === 3")
    assert tab.value("page.panels.chosen[0].data.curves[0].x") == [0, 0.5, 1]
    tab.press("[")
    tab.wait("page.now === 0.5 && page.back && page.panels.chosen[0].data.now === 0.5")
    assert tab.value("page.times.slider.value") == "0.5"
    tab.value("page.times.bar.querySelector('button:last-child').click()")
    tab.wait("page.now === 1 && !page.back")
    tab.value("document.querySelector('[data-name=outputs] > .close').click()")
    tab.wait("!document.querySelector('[data-name=outputs]')")
    end = time.monotonic() + 20
    while viewer.plots.curves(viewer.shadows):
        assert time.monotonic() < end
        time.sleep(0.02)


def test_it_follows_the_solver_until_it_is_stopped(model: Any, tab: Tab) -> None:
    thread = solving(model)
    frames = tab.value("page.frames")
    tab.wait(f"page.frames > {frames + 5} && parseFloat(page.time.textContent.slice(4)) > 0")
    assert "solving" in tab.wait("page.state.textContent")
    tab.wait("/^[0-9.e+]+ x real time$/.test(page.time.textContent.split('\\n')[1])")
    tab.press("q")
    thread.join(20)
    assert not thread.is_alive()


def test_traces_grow_and_are_bright_on_a_dark_page(SC: Any, model: Any, viewer: Viewer, tab: Tab) -> None:
    """Points of a trace on the page are those of the viewer, though only new ones are sent; black becomes light grey on
    a dark background."""
    sensor = model.AddSensor(
        exu.SensorBody(
            bodyNumber=1, outputVariableType=exu.OutputVariableType.Position, storeInternal=True, writeToFile=False
        )
    )
    model.Assemble()
    traces = SC.visualizationSettings.sensors.traces
    traces.showPositionTrace, traces.listOfPositionSensors, traces.traceColors = True, [sensor], [0, 0, 0, 1]
    thread = solving(model)
    tab.wait("page.counts && page.counts.some((count) => count > 120)", 60)
    model.SetRenderEngineStopFlag(True)
    thread.join(20)
    traces.showPositionTrace = False
    tab.wait("page.points && !page.counts.some((count) => count > 120)")
    traces.showPositionTrace = True
    tab.wait("page.counts.some((count) => count > 120)")
    shades = """(() => {
      const shape = page.objects.find((object) => object.isLineSegments && object.userData.paint).geometry;
      const count = shape.drawRange.count, colors = shape.getAttribute("color").array;
      return [colors[3 * count - 3], colors[3 * count - 1]];
    })()"""
    assert tab.value(shades) == [0, 0]
    tab.value("page.dark()")
    assert min(tab.value(shades)) > 0.5
    tab.value("page.dark()")
    assert tab.value(shades) == [0, 0]


def test_it_makes_no_other_request_and_hides_its_token(viewer: Viewer, tab: Tab) -> None:
    port = viewer.server.port
    assert {r.split("#")[0] for r in tab.requests} <= {
        f"http://127.0.0.1:{port}/", f"http://127.0.0.1:{port}/bundle.js", f"ws://127.0.0.1:{port}/socket", "data:,",
    }  # fmt: skip
    assert tab.value("location.href") == f"http://127.0.0.1:{port}/"
    tab.call("Page.reload")
    tab.wait("page.frames > 0")  # it is still known


def test_names_are_texts(model: Any, tab: Tab) -> None:
    """In the hint at the mouse, in panels of items, details, sliders and plots, in motions, and in notices."""
    name = "<img src=x onerror=alert(1)>"
    x, y = tab.value("page.projected([1, 0, 0])")
    tab.call("Input.dispatchMouseEvent", type="mouseMoved", x=x, y=y)
    assert name in tab.wait("page.hint.textContent")
    tab.click(x, y)
    tab.wait(f"document.querySelector('[data-name=details]').textContent.includes('{name}')")
    click = "[...document.querySelectorAll('[data-name=details] a')].find((a) => a.textContent === '{}').click()"
    tab.value(click.format("physicsMass"))
    tab.value(click.format("Position"))
    tab.wait(f"page.panels.chosen?.[0].data.title.includes('{name}')")
    tab.value("page.panels.items(page)")
    assert name in tab.value("document.querySelector('[data-name=items]').textContent")
    tab.value(f"page.take({{ kind: 'notice', text: '{name}' }})")
    tab.value(
        f"page.take({{ kind: 'controls', title: '{name}', widgets: [{{ type: 'label', text: '{name}', name: '0' }}] }})"
    )
    assert tab.value("document.querySelector('[data-name=controls]').textContent").count(name) == 2
    tab.value(f"page.write([['{name}', [0, 0, 0]]], new Float32Array(3))")
    assert tab.value("page.labels.textContent") == name
    model.SaveHTML("names.html", title=name)
    assert name not in Path("names.html").read_text("utf-8")
    tab.value(
        f"page.take({{ kind: 'motion', data: '{data(Still(model.GetSystemContainer()), {'title': name, 'plays': False, 'again': False})}' }})"
    )
    tab.wait(f"page.motion?.items.some((item) => item[3] === '{name}')")
    tab.value("page.motion.panels.items(page.motion)")
    assert name in tab.value("document.querySelector('.replay [data-name=items]').textContent")
    assert tab.value("document.querySelectorAll('img').length") == 0


def test_a_motion_that_comes_while_another_is_read_replaces_it(SC: Any, model: Any, tab: Tab) -> None:
    packed = data(Still(SC), {"title": "", "plays": False, "again": False})
    tab.value(f"(page.replay('{packed}'), page.replay('{packed}'))")
    tab.value(f"page.replay('{packed}')")
    assert tab.value("document.querySelectorAll('.replay').length") == 1
    tab.value("page.close()")
    assert tab.value("document.querySelectorAll('.replay').length") == 0


def test_marks_leave_nothing_on_the_graphics_card(tab: Tab) -> None:
    """A box around the picked item is made anew for each picture; edges of a mesh are shared by its places."""
    tab.value("page.pick({ number: page.items.findIndex((i) => i[0] === 'Object' && i[1] === 1), distance: 1 })")
    count = "(page.render(), page.renderer.info.memory.geometries)"
    before = tab.value(count)
    for _ in range(3):
        tab.value(
            "(page.mark(), page.measure({ point: page.camera.position.clone() }), page.measure({ point: page.controls.target }), page.render())"
        )
        tab.value("page.measure(null)")
    assert tab.value(count) == before
    rims = "page.objects.filter((object) => object.userData.rim)"
    assert tab.value(f"{rims}.length") >= tab.value(f"new Set({rims}.map((rim) => rim.geometry)).size")


def test_plots_of_one_number_with_round_off_are_drawn(tab: Tab) -> None:
    """Ticks that are closer than round-off of their numbers would never come to an end."""
    for numbers in ([1e8, 1e8 + 1.5e-8], [1.0, 1.0 + 2.3e-16], [-3.0, -3.0], [0.0, 1e-300], [5e-12, 6e-12]):
        tab.value(f"page.panels.outputs([{{ title: '', curves: [{{ name: '', x: [0, 1], y: {numbers} }}] }}])")
        assert tab.value("page.panels.chosen[0].drawn[0].length") == 2
    tab.value("page.panels.outputs([{ title: '', curves: [{ name: '', x: [0, 1], y: [1e6, 2e6] }] }])")
    for _ in range(30):  # drags that zoom in, as far as numbers go
        tab.value("((plot) => (plot.from = [200, 80], plot.to = [210, 90], plot.zoom()))(page.panels.chosen[0])")
    for low, high in np.reshape(tab.value("page.panels.chosen[0].window"), (2, 2)):
        assert high - low > 1e-11 * high


def test_a_field_without_a_number_changes_nothing_and_a_parameter_has_one_slider(tab: Tab) -> None:
    tab.value("page.sent = [], page.panels.send = (kind, words) => page.sent.push(words.value)")
    words = "{ system: 0, item: 'Object', number: 2, name: 'stiffness' }"
    for value in (10, 20):
        tab.value(f"page.panels.slider({words}, {value})")
    assert tab.value("document.querySelectorAll('[data-name=sliders] input[type=text]').length") == 1
    for text in ("", "  ", "many", "25", "1e400", "-3e2"):
        tab.value(
            f"((field) => (field.value = '{text}', field.onchange()))(document.querySelector('[data-name=sliders] input[type=text]'))"
        )
        shown = tab.value("document.querySelector('[data-name=sliders] input[type=text]').value")
        assert shown == {"25": "25", "1e400": "25.0000", "-3e2": "-3e2"}.get(text, "20.0000")
    assert tab.value("page.sent") == [25, -300]


def test_the_search_for_items_stays_while_the_same_items_are_drawn_anew(viewer: Viewer, tab: Tab) -> None:
    tab.value("page.panels.items(page), page.search = document.querySelector('[data-name=items] input')")
    number = tab.value("page.number")
    viewer.settings.general.backgroundColor = [0.9, 0.9, 1, 1]
    tab.wait(f"page.number > {number}")
    assert tab.value("page.search === document.querySelector('[data-name=items] input')")
    tab.press("n")
    tab.wait("page.search !== document.querySelector('[data-name=items] input')")


def test_texts_can_be_read_on_a_dark_page_at_once(viewer: Viewer, tab: Tab) -> None:
    tab.press("b", held=CONTROL)
    tab.wait("page.labels.children.length > 0")
    color = "getComputedStyle(page.labels.children[0]).color"
    assert tab.value(color) == "rgb(0, 0, 0)"
    tab.value("page.dark()")
    assert tab.value(color) == "rgb(221, 221, 221)"
    tab.value("page.dark()")
    assert tab.value(color) == "rgb(0, 0, 0)"


def test_a_scene_at_one_point_has_no_floor(tab: Tab) -> None:
    tab.value("page.replace([], []), page.ground(), page.ground()")
    assert tab.value("page.floor === null")


@pytest.mark.parametrize("kind", ["Node", "Object", "Marker", "Load", "Sensor"])
def test_one_item_of_each_kind_is_picked(SC: Any, viewer: Viewer, tab: Tab, kind: str) -> None:
    """All others are hidden; an item that is picked is the one shown after a click on its middle."""
    groups = {"Node": "nodes", "Object": "bodies", "Marker": "markers", "Load": "loads", "Sensor": "sensors"}
    for name in (*groups.values(), "connectors"):
        getattr(viewer.settings, name).show = name == groups[kind]
    viewer.settings.sensors.show = kind == "Sensor"
    viewer.settings.markers.defaultSize = viewer.settings.sensors.defaultSize = 0.3
    viewer.redraw()
    tab.wait(
        f"page.objects.some((o) => o.isMesh) && page.objects.filter((o) => o.isMesh).every((o) => o.userData.items.every((i) => page.items[i][0] === '{kind}'))"
    )
    middle = """(() => {
      for (const o of page.objects) if (o.isMesh) {
        o.geometry.computeBoundingBox();
        const p = o.geometry.boundingBox.getCenter(o.position.clone());
        if (o.isInstancedMesh) { const m = o.matrixWorld.clone(); o.getMatrixAt(0, m); p.applyMatrix4(m); }
        const [x, y] = page.projected([...p]), hit = page.hit(x, y);
        if (hit) return [x, y, ...page.items[hit.number]];
      }
    })()"""
    x, y, found, number = tab.wait(middle)[:4]
    assert found == kind
    tab.click(x, y)
    tab.wait(f"document.querySelector('[data-name=details] h2').textContent === '{kind.lower()} {number}'")
    assert SC.renderer.GetItemSelection()[1:3] == (int(getattr(exu.ItemType, kind)), number)
    assert tab.value("page.box !== null")
    tab.value("document.querySelector('[data-name=details] .close').click()")
    end = time.monotonic() + 20
    while viewer.selection is not None:  # otherwise, it would be reported repeatedly
        assert time.monotonic() < end
        time.sleep(0.02)
    assert tab.value("document.querySelector('[data-name=details]') === null && page.box === null")


def test_keys(viewer: Viewer, tab: Tab) -> None:
    look = "JSON.stringify(page.looking())"
    for key, code, held in [
        ("ArrowLeft", "ArrowLeft", 0), ("ArrowUp", "ArrowUp", CONTROL), (".", "Period", 0), (",", "Comma", CONTROL),
        ("4", "Numpad4", 0), ("9", "Numpad9", 0), ("2", "Digit2", ALT), ("1", "Digit1", ALT | SHIFT),
    ]:  # fmt: skip
        before = tab.value(look)
        tab.press(key, code, held)
        assert tab.value(look) != before, key
    right, up = np.reshape(tab.value("page.looking().rotation"), (3, 3))[:2]
    np.testing.assert_allclose([right, up], [[-1, 0, 0], [0, 1, 0]], atol=1e-6)
    tab.press("n")
    tab.wait("!page.items.some((item) => item[0] === 'Node')")
    tab.press("b", held=CONTROL)
    tab.wait("[...page.labels.children].some((label) => label.textContent === 'O1')")
    tab.press("n")
    tab.press("n", held=CONTROL)
    tab.wait("[...page.labels.children].some((label) => label.textContent === 'N0')")
    tops = "Object.fromEntries([...page.labels.children].map((label) => [label.textContent, label.getBoundingClientRect().top]))"
    tab.wait(f"Math.abs({tops}.N0 - {tops}.O1) > 10")  # though the node is the middle of the body
    tab.press("t")
    tab.press("v")
    tab.wait("document.querySelector('[data-name=settings]') !== null")
    tab.value("document.querySelector('.dark') || page.dark()")
    assert tab.value("page.place.classList.contains('dark')")


def test_panels_do_not_lie_on_each_other(tab: Tab) -> None:
    tab.press("v")
    tab.wait("document.querySelector('[data-name=settings]') !== null")
    tab.value("[...document.querySelectorAll('button')].find((button) => button.textContent === 'cut').click()")
    tab.wait("document.querySelector('[data-name=cut]') !== null")
    box = "((box) => [box.top, box.bottom])(document.querySelector('[data-name={}]').getBoundingClientRect())"
    (top, middle), (next_top, bottom) = sorted(tab.value(box.format(name)) for name in ("settings", "cut"))
    assert 0 <= top < middle <= next_top < bottom <= tab.value("innerHeight")


def test_all_is_seen_again_after_the_view_was_moved(SC: Any, tab: Tab) -> None:
    """The state of the renderer is that of readers; a page that is opened does not fix it."""
    assert "zoom" not in SC.renderer._state
    first = tab.value("page.looking()")
    tab.press(".", "Period")
    tab.press("4", "Numpad4")
    tab.wait("!page.turned")
    turned = tab.value("page.looking().rotation")
    while "zoom" not in SC.renderer._state or SC.renderer.GetState()["zoom"] == pytest.approx(first["zoom"]):
        tab.value("new Promise((go) => setTimeout(go, 20))")
    tab.press("a")
    tab.wait(f"page.looking().zoom > {0.95 * first['zoom']}")
    assert tab.value("page.looking().rotation") == pytest.approx(turned, abs=1e-5)
    assert "zoom" not in SC.renderer._state


def test_measuring_and_cutting(tab: Tab) -> None:
    """The brick is 0.4 wide; cut in the middle, it is not hit any more where it was."""
    tab.value("page.look({ rotation: [1, 0, 0, 0, 1, 0, 0, 0, 1], center: [1, 0, 0], zoom: 1 })")
    for x in (0.85, 1.15):
        tab.click(*tab.value(f"page.projected([{x}, 0.1, 0.2])"), held=SHIFT)
    words = tab.wait(
        "page.time.textContent.split('\\n').find((line) => line.startsWith('distance 0.30'))"
    )  # though nothing moves
    assert words.endswith(", 0, 0)")  # rounding errors of the mouse's ray are excluded
    x, y = tab.value("page.projected([1.1, 0.1, 0.2])")
    assert tab.value(f"page.hit({x}, {y}) !== null")
    tab.value("page.cut(1, 0, 0, 1.0)")
    assert tab.value(f"page.hit({x}, {y}) === null")


def test_a_saved_picture_is_the_visible_one(SC: Any, viewer: Viewer, tab: Tab) -> None:
    """The image has texts, the bar of colors and the other views, without buttons."""
    SC.visualizationSettings.contour.outputVariable = exu.OutputVariableType.Position
    viewer.redraw()
    tab.wait("document.querySelectorAll('.contour i').length > 0")
    tab.value("page.split(page.sides())")
    tab.value("HTMLAnchorElement.prototype.click = function () { window.saved = [this.download, this.href]; }")
    tab.wait("!page.wanted")
    tab.value("page.bar.querySelector('[title=\"save a picture\"]').click()")
    name, data = tab.value("window.saved")
    saved = np.asarray(Image.open(BytesIO(base64.b64decode(data.partition(",")[2]))).convert("RGB"), float)
    seen = np.asarray(Image.open(BytesIO(tab.picture())).convert("RGB"), float)
    assert name == "picture.png" and saved.shape == seen.shape
    for part in (".time", ".contour", ".pane", ".axes"):
        left, top, width, height = tab.value(
            f"((box) => [box.x, box.y, box.width, box.height].map(Math.round))(document.querySelector('{part}').getBoundingClientRect())"
        )
        ink = [(image[top : top + height, left : left + width].mean(axis=2) < 230).mean() for image in (saved, seen)]
        assert 0.005 < ink[1] == pytest.approx(ink[0], rel=0.25), part  # letters are not on the same pixels


def test_round_off_is_zero_on_the_bar_of_colors(SC: Any, viewer: Viewer, tab: Tab) -> None:
    SC.visualizationSettings.contour.outputVariable = exu.OutputVariableType.Position
    viewer.redraw()
    tab.wait("document.querySelectorAll('.contour i').length > 0")
    told = tab.value(
        "(page.range(-1.5e-28, 0.6), [...document.querySelectorAll('.contour i')].map((i) => i.textContent))"
    )
    assert told[0] == "0.6000" and told[-1] == "0" and all(float(number) > 0 for number in told[:-1])


def test_one_number_has_one_color_and_close_ones_have_digits_enough(SC: Any, viewer: Viewer, tab: Tab) -> None:
    SC.visualizationSettings.contour.outputVariable = exu.OutputVariableType.Position
    viewer.redraw()
    tab.wait("document.querySelectorAll('.contour i').length > 0")
    read = "[...document.querySelectorAll('.contour i')].filter((i) => i.offsetParent).map((i) => i.textContent)"
    rows = "[...document.querySelectorAll('.contour .row')].filter((row) => row.offsetParent).length"
    for value in (0.0, 0.25, -3.0, 25.0):
        assert tab.value(f"(page.range({value}, {value}), [{rows}, ...{read}])") == [1, f"{value:g}"]
    told = tab.value(f"(page.range(100000, 100000.1), {read})")
    assert [float(number) for number in told] == pytest.approx([1e5 + 0.025 * k for k in (4, 3, 2, 1, 0)], abs=1e-3)
    assert tab.value(f"(page.range(0, 5e-7), {read})") == ["5.000e-7", "3.750e-7", "2.500e-7", "1.250e-7", "0"]


def test_images_have_the_same_floor(SC: Any, model: Any, viewer: Viewer, tab: Tab) -> None:
    """The grid of a page and that of images, below the same box."""
    from dalembert._pictures import floor

    tab.wait("!!page.floor")
    box = np.array(tab.value("[[...page.floor.box.min], [...page.floor.box.max]]"))
    shown = tab.value("[...page.floor.object.children[0].geometry.getAttribute('position').array]")
    lines = [points for points, *_ in floor.lines(box, viewer.studio.upwards())]
    seen, expected = (
        np.array(sorted(np.round(np.sort(ends, axis=0), 4).ravel().tolist() for ends in each))
        for each in (np.reshape(shown, (-1, 2, 3)), lines)
    )
    np.testing.assert_allclose(seen, expected, atol=1e-4)  # pages have single precision


def test_two_pages(model: Any, viewer: Viewer, browser: Browser, tab: Tab) -> None:
    other = browser.tab(viewer.server.address)
    other.wait("page.frames > 0")
    thread = solving(model)
    for page in (tab, other):
        page.call("Page.bringToFront")  # browsers draw only visible pages
        frames = page.value("page.frames")
        page.wait(f"page.frames > {frames + 2}")
    other.close()
    tab.call("Page.bringToFront")
    frames = tab.value("page.frames")
    tab.wait(f"page.frames > {frames + 2}")
    tab.press("Escape")
    thread.join(20)
    assert not thread.is_alive()
    tab.wait("page.state.textContent === 'closed'")


def test_other_views_have_windows_of_their_own(SC: Any, viewer: Viewer, tab: Tab) -> None:
    """View 1 looks from above, and shows the brick where a camera there sees it; it is turned by itself."""
    SC.visualizationSettings.view1.camera.clippingPlaneNormal = [0, 0, 1]
    SC.renderer.SetModelView(zoom=1.0, centerPoint=[1, 0, 0], viewID=1)
    assert tab.value("page.panes.length") == 0
    SC.renderer.EnableView(1)
    tab.wait("page.panes.length === 1")
    seen = tab.value("page.panes[0].looking()")
    assert seen["center"] == pytest.approx([1, 0, 0]) and seen["zoom"] == pytest.approx(1.0)
    beside = "[box.x + box.width / 2 + 0.05 * box.height, box.y + 0.55 * box.height]"  # 0.1 from the middle, twice
    middle = f"((box) => {beside})(page.panes[0].window.getBoundingClientRect())"
    x, y = tab.value(middle)
    hit = tab.wait(f"page.hit({x}, {y}, page.panes[0])")
    assert hit["point"]["z"] == pytest.approx(-0.2, abs=1e-6)  # all that is above 0 has been cut away
    tab.click(x, y)
    tab.wait("document.querySelector('[data-name=details] h2')?.textContent === 'object 1'")
    main = tab.value("JSON.stringify(page.looking())")
    for kind, shift, pressed in [
        ("mousePressed", 0, 0),
        ("mouseMoved", 30, 1),
        ("mouseMoved", 60, 1),
        ("mouseReleased", 60, 0),
    ]:
        tab.call("Input.dispatchMouseEvent", type=kind, x=x + shift, y=y, button="left", buttons=pressed, clickCount=1)
    tab.wait("page.panes[0].looking().rotation[0] < 0.99")
    end = time.monotonic() + 20
    while np.allclose(SC.renderer.GetState(viewID=1)["modelRotation"], np.eye(3)):
        assert time.monotonic() < end
    assert tab.value("JSON.stringify(page.looking())") == main
    assert SC.renderer.GetState(viewID=1)["viewEnabled"] and not SC.renderer.GetState(viewID=2)["viewEnabled"]
    SC.renderer.DisableView(1)
    tab.wait("page.panes.length === 0 && document.querySelectorAll('.pane').length === 0")
    tab.value("page.split(page.sides())")
    tab.wait("page.panes.length === 3")


def test_a_rejected_page_shows_the_reason(browser: Browser, viewer: Viewer) -> None:
    opened = browser.tab(f"{viewer.server.address}x")
    opened.wait("page.state.textContent === 'refused: wrong token' && page.drawn > 0")
    picture = Image.open(BytesIO(opened.picture())).convert("RGB")
    assert picture.getpixel((400, 200)) == (255, 255, 255)
    opened.close()
