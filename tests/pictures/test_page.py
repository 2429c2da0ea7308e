"""The page of a motion: Python and JavaScript read the packed data, and a browser shows it without a network."""

from __future__ import annotations

import base64
import gzip
import hashlib
import json
import os
import re
import shutil
from pathlib import Path
from typing import Any

import browser
import numpy as np
import pytest

import dalembert as exu
from dalembert import graphics
from dalembert._pictures import showing
from dalembert._pictures.motion import Motion
from dalembert._pictures.replay import SPARE_BITS, Packer, pack
from dalembert.itemInterface import (
    Force,
    MarkerBodyRigid,
    NodePoint2DSlope1,
    ObjectANCFCable2D,
    SensorBody,
    VObjectANCFCable2D,
)
from dalembert.utilities import InertiaCuboid

FOLDER = Path(exu.__file__).resolve().parent / "_pictures/page"


def unpacked(data: bytes) -> tuple[dict[str, Any], list[Any]]:
    """Read the output of replay.py."""
    whole = gzip.decompress(data)
    length = int(np.frombuffer(whole[:4], "<u4")[0])
    head, offset, arrays = json.loads(whole[4 : 4 + length]), 4 + length, []
    for entry in head["arrays"]:
        part = np.frombuffer(whole[offset : offset + entry["bytes"]], np.uint8)
        offset += entry["bytes"]
        if entry["kind"] != "u1":
            part = part.reshape(4, -1).T.copy().view("<u4").ravel()
        if entry["kind"] in ("f4", "carried"):  # differences of the remaining bits
            part = (np.cumsum(part, dtype="<u4") << SPARE_BITS).view("<f4")
        if entry["kind"] == "carried":
            part = _carried(arrays[entry["by"]].reshape(3, 4, -1), part, entry["form"])
            assert part.size == entry["count"]
        arrays.append(part)
    assert offset == len(whole)
    return head, arrays


def _carried(rows: Any, local: Any, form: str) -> Any:
    """Return the constant numbers of a motion (3 x 4 x frames), number by number."""
    square = np.concatenate(
        [rows.transpose(2, 0, 1), np.broadcast_to([[[0, 0, 0, 1.0]]], (rows.shape[2], 1, 4))], axis=1
    )
    if form in ("points", "ball"):
        points = np.column_stack([local[:-1] if form == "ball" else local]).reshape(-1, 3)
        moved = (square[:, :3] @ np.column_stack([points, np.ones(len(points))]).T).transpose(0, 2, 1)
        frames = moved.reshape(len(square), -1)
        radius = np.full((len(square), 1), local[-1])
        return (np.column_stack([frames, radius]) if form == "ball" else frames).T.ravel()
    part = np.concatenate([local.reshape(3, 4), [[0, 0, 0, 1.0]]])
    moved = square @ part
    if form == "place":
        moved[:, :3, :3] = part[:3, :3]
    return moved[:, :3].reshape(len(square), 12).T.ravel()


def data_of(text: str) -> bytes:
    """Return the data of a page."""
    return base64.b64decode(re.search(r'id="data">([^<]*)<', text)[1])


@pytest.fixture
def falling(mbs: Any) -> Any:
    """A falling brick with a hostile name, and a cable at rest; solved."""
    mbs.CreateRigidBody(
        name="</script><img src=x onerror=alert(1)>",
        referencePosition=[1, 0, 0],
        inertia=InertiaCuboid(1000, [0.4, 0.2, 0.1]),
        gravity=[0, -2, 0],
        graphicsDataList=[graphics.Brick(size=[0.4, 0.2, 0.1], color=graphics.color.orange)],
    )
    nodes = [mbs.AddNode(NodePoint2DSlope1(referenceCoordinates=[x, 0, 1, 0])) for x in (2, 3)]
    mbs.AddObject(
        ObjectANCFCable2D(
            nodeNumbers=nodes, physicsLength=1, physicsMassPerLength=1, physicsBendingStiffness=1,
            physicsAxialStiffness=1, visualization=VObjectANCFCable2D(drawHeight=0.1),
        )
    )  # fmt: skip
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = 100
    settings.solutionSettings.solutionWritePeriod = 0.01
    mbs.SolveDynamic(settings)
    return mbs


def _of(values: Any) -> bytes:
    packer = Packer()
    packer.floats(values)
    return packer.data({})


def test_numbers_are_kept_to_the_fifth_digit() -> None:
    packer = Packer()
    values = np.random.default_rng(1).normal(size=200) * 10.0 ** np.random.default_rng(2).integers(-6, 6, 200)
    packer.floats(values)
    assert np.isfinite(unpacked(_of([1e300, -1e300]))[1][0]).all()  # bodies that are thrown away
    packer.integers(range(300))
    packer.shades([0, 0.5, 1.0])
    packer.moving([[1, 2], [1, 2], [1, 2]])
    packer.moving([[1, 2], [1, 3], [1, 4]])
    _, (floats, integers, shades, still, moving) = unpacked(packer.data({}))
    np.testing.assert_allclose(floats, values, rtol=2e-5)
    np.testing.assert_array_equal(integers, range(300))
    np.testing.assert_array_equal(shades, [0, 128, 255])
    np.testing.assert_array_equal(still, [1, 2])
    np.testing.assert_array_equal(moving, [1, 1, 1, 2, 3, 4])  # number by number


def test_a_body_falls_in_the_data(falling: Any) -> None:
    falling.SaveHTML("falling.html", framesPerSecond=10)
    head, arrays = unpacked(data_of(Path("falling.html").read_text("utf-8")))
    assert head["times"] == pytest.approx(np.linspace(0, 1, 11))
    brick = next(mesh for mesh in head["meshes"] if head["items"][mesh["items"][0]][0] == "Object" and "places" in mesh)
    frames = arrays[brick["places"][0]].reshape(12, 11)
    np.testing.assert_allclose(frames[7], -(np.linspace(0, 1, 11) ** 2), atol=1e-4)  # -g t^2 / 2 with g = 2
    np.testing.assert_allclose(frames[3], 1, atol=1e-4)
    np.testing.assert_allclose(frames[[0, 5, 10]], 1, atol=1e-4)
    cable = next(mesh for mesh in head["meshes"] if "frames" in mesh)
    assert arrays[cable["frames"]].size == arrays[cable["points"]].size  # at rest: one frame


def test_the_visualized_state_is_afterwards_as_before(falling: Any) -> None:
    before = falling.systemData.GetODE2Coordinates(exu.ConfigurationType.Visualization)
    Motion(falling, "test", None, 10, 1.0, None, None)
    data = falling.systemData
    np.testing.assert_array_equal(data.GetODE2Coordinates(exu.ConfigurationType.Visualization), before)
    assert data.GetTime(exu.ConfigurationType.Visualization) == pytest.approx(1.0)


def test_no_text_of_the_model_is_part_of_the_page(falling: Any) -> None:
    falling.SaveHTML("falling.html", title="<b>")
    text = Path("falling.html").read_text("utf-8")
    assert "alert(1)" not in text and "<title><b>" not in text
    assert text.count("</script>") == 3  # data, code, and the decoder
    assert str(Path.home()) not in text and os.getcwd() not in text
    assert "default-src 'none'" in text
    assert not re.search(r"https?://(?!www\.w3\.org)[\w.]+/[\w./]*\.(js|css|png)", text)  # nothing to be loaded
    names = [item[3] for item in unpacked(data_of(text))[0]["items"]]
    assert "</script><img src=x onerror=alert(1)>" in names


def test_size_of_a_file() -> None:
    """Twenty bodies that fly and turn, a thousand frames: far below 1 MB, of which the code is 0.2 MB."""
    mbs = exu.SystemContainer().AddSystem()
    rng = np.random.default_rng(3)
    for k in range(20):
        mbs.CreateRigidBody(
            referencePosition=[k % 5, k // 5, 0], initialVelocity=rng.normal(size=3),
            initialAngularVelocity=3 * rng.normal(size=3), inertia=InertiaCuboid(1000, [0.4, 0.2, 0.1]),
        )  # fmt: skip
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = 1000
    settings.solutionSettings.solutionWritePeriod = 1e-3
    mbs.SolveDynamic(settings)
    mbs.SaveHTML("bodies.html", framesPerSecond=1000)
    assert len(unpacked(data_of(Path("bodies.html").read_text("utf-8")))[0]["times"]) == 1001
    assert 0.2e6 < Path("bodies.html").stat().st_size < 0.6e6


def test_items_that_move_with_a_body_add_nothing_per_frame(mbs: Any) -> None:
    """Markers, joints, axes, sensors and weight on bodies that turn are where they are in each scene of the motion."""
    body = mbs.CreateGround()
    for k in range(4):
        before, body = body, mbs.CreateRigidBody(
            referencePosition=[0.4 * k + 0.2, 0, 0], gravity=[0, 0.5, -9.81],
            inertia=InertiaCuboid(1000, [0.4, 0.2, 0.1]),
            graphicsDataList=[graphics.Brick(size=[0.4, 0.2, 0.1])],
        )  # fmt: skip
        mbs.CreateSphericalJoint(bodyNumbers=[before, body], position=[0.4 * k, 0, 0])
    mbs.AddSensor(SensorBody(bodyNumber=body, outputVariableType=exu.OutputVariableType.Position))
    end = mbs.AddMarker(MarkerBodyRigid(bodyNumber=body, localPosition=[0.2, 0, 0]))
    mbs.AddLoad(Force(markerNumber=end, loadVector=[0, 0, 1]))
    spring = mbs.CreateSpringDamper(bodyNumbers=[0, body], localPosition1=[0.2, 0, 0], stiffness=10)
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps, settings.timeIntegration.endTime = 200, 0.5
    settings.solutionSettings.solutionWritePeriod = 0.005
    mbs.SolveDynamic(settings)
    shown = mbs.GetSystemContainer().visualizationSettings
    shown.nodes.showBasis = shown.markers.show = shown.connectors.showJointAxes = shown.sensors.show = True
    motion = Motion(mbs, "test", None, 200, 1.0, None, None)
    head, arrays = unpacked(pack(motion, {}))
    count = len(motion.scenes)
    kinds = [entry["form"] for entry in head["arrays"] if entry["kind"] == "carried"]
    assert {"rows", "place", "ball"} <= set(kinds)
    moving = [
        head["items"][item][:2]
        for mesh in head["meshes"] for item, place in zip(mesh["items"], mesh.get("places", []), strict=False)
        if head["arrays"][place]["kind"] == "f4" and arrays[place].size > 12
    ]  # fmt: skip
    alone = [item for item in moving if item != ["Object", spring]]
    assert len(alone) == 4, alone  # one line per body
    found: dict[int, list[Any]] = {}
    for mesh in head["meshes"]:
        for item, place in zip(mesh["items"], mesh.get("places", []), strict=False):
            found.setdefault(item, []).append(np.broadcast_to(arrays[place].reshape(12, -1), (12, count)))
    names = [(item.kind, item.number, item.system) for item in motion.scenes[0].items]
    for at, scene in enumerate(scene.unbound() for scene in motion.scenes):
        drawn: dict[int, list[Any]] = {}
        for part in scene.instances:
            drawn.setdefault(part.item, []).append(np.column_stack([part.matrix, part.place]).ravel())
        for item, parts in drawn.items():
            assert names[item][0] == head["items"][item][0]
            if names[item][:2] == ("Object", spring):
                continue  # it is deformed
            known = np.array([part[:, at] for part in found[item]])
            for part in parts:
                seen = [2, 3, 6, 7, 10, 11]  # axis and place: parts may be round
                assert np.abs(known - part)[:, seen].max(axis=1).min() < 5e-5, names[item]
    for center, *_, item in motion.scenes[-1].unbound().spheres:
        places = [
            arrays[p].reshape(4, -1)[:3, -1]
            for p, i in zip(*map(head["spheres"].get, ("places", "items")), strict=True)
            if i == item
        ]
        assert min(np.abs(place - center).max() for place in places) < 5e-5


def test_pages_have_the_ending_that_browsers_know(mbs: Any) -> None:
    mbs.CreateMassPoint(referencePosition=[1, 2, 3], physicsMass=1)
    with pytest.raises(
        ValueError, match=r"SaveHTML: fileName: expected a name that ends with .html, received 'page.txt'"
    ):
        mbs.SaveHTML("page.txt")


def test_user_graphics_may_be_another_mesh_in_each_frame(falling: Any) -> None:
    """Models of other sizes and colors."""

    def drawn(mbs: Any, number: int) -> list[Any]:
        time = mbs.systemData.GetTime(exu.ConfigurationType.Visualization)
        if time < 0.5:
            return [graphics.Sphere(radius=0.1 + time, nTiles=4, color=[1, 0, 0, 1])]
        return [graphics.Brick(size=[time, 0.1, 0.1], color=[0, 0, 1, 1] if time < 0.8 else [0, 1, 0, 1])]

    falling.SetObjectParameter(0, "VgraphicsDataUserFunction", drawn)
    falling.SetObjectParameter(0, "VgraphicsData", [])
    falling.SaveHTML("shapes.html", framesPerSecond=10)
    head, arrays = unpacked(data_of(Path("shapes.html").read_text("utf-8")))
    own = [mesh for mesh in head["meshes"] if [head["items"][i][:2] for i in mesh["items"]] == [["Object", 0]]]
    assert [mesh["color"][:3] for mesh in own] == [[1, 0, 0], [0, 0, 1], [0, 1, 0]]
    times = np.array(head["times"])
    for mesh, shown in zip(own, (times < 0.5, (times >= 0.5) & (times < 0.8), times >= 0.8), strict=True):
        frames = arrays[mesh["frames"]].reshape(-1, len(times)).T  # number by number
        np.testing.assert_array_equal(np.any(frames != 0, axis=1), shown)


def test_without_a_solution_there_is_one_frame(mbs: Any) -> None:
    mbs.CreateMassPoint(referencePosition=[1, 2, 3], physicsMass=1)
    mbs.SaveHTML("still.html")
    head, _ = unpacked(data_of(Path("still.html").read_text("utf-8")))
    assert head["times"] == [0.0]


def test_the_bundle_is_made_of_its_sources() -> None:
    """`npm ci && npm run build` in the folder of the page makes it anew, with the versions of package-lock.json."""
    modules = [entry.name for entry in sorted(FOLDER.glob("*.js")) if entry.name != "bundle.js"]
    names = [*modules, "package.json", "package-lock.json"]

    def total(files: list[str]) -> str:
        return hashlib.sha256(b"".join((FOLDER / name).read_bytes() for name in files)).hexdigest()

    noted = dict(line.split() for line in (FOLDER / "bundle.sums").read_text().splitlines())
    assert noted == {"sources": total(names), "bundle": total(["bundle.js"])}
    assert (FOLDER / "bundle.js").stat().st_size < 800_000
    assert "SPDX-License-Identifier: MIT" in (FOLDER / "bundle.js").read_text("utf-8")  # of three.js


def test_a_browser_shows_it_offline(falling: Any) -> None:
    """The page runs, has drawn, shows the time, finds the item in the middle, and has made no request; its policy would
    refuse one."""
    falling.SaveHTML("falling.html", framesPerSecond=10, title="a brick falls")
    with browser.running() as program:
        tab = program.tab(address := Path("falling.html").resolve().as_uri())
        tab.wait("page.drawn > 0")
        tab.value("page.play(false), page.show(0)")
        assert tab.value("page.itemAt(...page.projected([1, 0, 0]))")[:3] == ["Object", 0, "RigidBody"]
        tab.value("page.show(5)")
        assert tab.value("page.time.textContent") == "t = 0.5000 s"
        assert tab.value("document.title") == "a brick falls"
        assert tab.value("performance.getEntriesByType('resource').length") == 0
        assert tab.requests == [address] and not tab.errors


def test_saved_pages_look_as_settings_say(falling: Any) -> None:
    """Edges, transparent faces, the clipping plane, and texts, which move with their items."""

    def texts(mbs: Any, number: int) -> list[Any]:
        time = mbs.systemData.GetTime(exu.ConfigurationType.Visualization)
        return [graphics.Text(point=[0, 0, 0], text="late" if time > 0.75 else "early")]

    falling.SetObjectParameter(0, "VgraphicsDataUserFunction", texts)
    settings = falling.GetSystemContainer().visualizationSettings
    view = settings.view0
    view.scene.showFaceEdges = view.scene.facesTransparent = settings.bodies.showNumbers = True
    settings.openGL.faceTransparencyGlobal = 0.25
    view.camera.clippingPlaneNormal, view.camera.clippingPlaneDistance = [0, 0, 1], 0.5
    falling.SaveHTML("looks.html", framesPerSecond=10)
    with browser.running() as program:
        tab = program.tab(Path("looks.html").resolve().as_uri())
        tab.wait("page.drawn > 0")
        opacity = tab.value("page.objects.filter((object) => object.isMesh).map((object) => object.material.opacity)")
        assert opacity and opacity == pytest.approx([0.25] * len(opacity))
        assert tab.value(
            "page.objects.filter((object) => object.userData.rim).every((object) => object.visible !== !!object.userData.hidden)"
        )
        assert tab.value("page.renderer.clippingPlanes.map(({ normal, constant }) => [normal.z, constant])") == [
            [-1, 0.5]
        ]
        words = "[...page.labels.children].filter((label) => !label.hidden).map((label) => label.textContent)"
        place = "[...page.labels.children].find((label) => label.textContent === 'O0').style.transform"
        tab.value("page.play(false), page.show(0), page.render()")
        first = tab.value(place)
        assert {"early", "O0"} < set(tab.value(words)) and "late" not in tab.value(words)
        tab.value("page.show(9), page.render()")
        assert {"late", "O0"} < set(tab.value(words)) and "early" not in tab.value(words)
        assert tab.value(place) != first
        view.scene.showFaces = False
        falling.SaveHTML("looks.html", framesPerSecond=10)
        tab.go(Path("looks.html").resolve().as_uri() + "?again")
        tab.wait(
            "page.drawn > 0 && page.objects.filter((object) => object.isMesh).every((object) => !object.material.visible)"
        )
        assert not tab.errors


def test_the_solution_viewer_shows_a_page_where_there_is_a_display(
    falling: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    opened: list[str] = []
    monkeypatch.setattr(showing, "has_display", lambda: True)
    monkeypatch.setattr(showing.webbrowser, "open", opened.append)
    falling.SolutionViewer(rowIncrement=10, timeout=0.1, runMode=0)
    (address,) = opened
    path = Path(address.removeprefix("file://"))
    assert path.parent.stat().st_mode & 0o077 == 0  # nobody else may read it
    head, _ = unpacked(data_of(path.read_text("utf-8")))
    assert (len(head["times"]), head["rate"], head["again"]) == (11, pytest.approx(10), False)
    shutil.rmtree(path.parent)


def test_where_windows_are_opened(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("PYTEST_CURRENT_TEST", raising=False)
    monkeypatch.delenv("CI", raising=False)
    monkeypatch.setattr(showing.sys, "platform", "linux")
    for name in ("DISPLAY", "WAYLAND_DISPLAY"):
        monkeypatch.delenv(name, raising=False)
    assert not showing.has_display()
    monkeypatch.setenv("DISPLAY", ":0")
    assert showing.has_display()
    monkeypatch.setenv("DALEMBERT_VIEWER", "off")
    assert not showing.has_display()
    assert not showing.in_notebook()


def test_items_are_searched_hidden_veiled_and_isolated(mbs: Any) -> None:
    """Hidden items are neither drawn nor picked; a transparent one lets those behind it shine through; weight is hidden
    until it is shown."""
    for number, color in enumerate(([1, 0, 0, 1], [0, 0, 1, 1])):
        mbs.CreateRigidBody(
            name=("front", "back")[number], referencePosition=[0, 0, -2 * number], gravity=[0, -9.81, 0],
            inertia=exu.utilities.InertiaCuboid(1000, [1, 1, 1]), graphicsDataList=[graphics.Brick(size=[1, 1, 1], color=color)],
        )  # fmt: skip
    mbs.Assemble()
    mbs.GetSystemContainer().visualizationSettings.nodes.show = False
    mbs.SaveHTML("two.html", view="front")
    with browser.running() as program:
        tab = program.tab(Path("two.html").resolve().as_uri())
        tab.wait("page.drawn > 0")
        tab.value("page.look({ ...page.looking(), zoom: 4 })")

        def middle() -> Any:
            """Red, green and blue in the middle of the picture, and the name of the item that is picked there."""
            return tab.value("""(() => {
              page.render();
              const gl = page.renderer.getContext(), pixel = new Uint8Array(4), [x, y] = page.projected([0.2, 0.2, 0.5]);
              gl.readPixels(x, page.canvas.height - y, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
              return [...pixel.slice(0, 3), page.itemAt(x, y)?.[3] ?? null];
            })()""")

        names = "[...document.querySelectorAll('.panel .item a')].map((a) => a.textContent)"
        red, _, blue, name = middle()
        assert red > 100 and blue < 60 and name == "front"
        loads = tab.value("page.items.flatMap((item, i) => (item[0] === 'Load' ? [page.opacity(i)] : []))")
        assert loads == [0, 0]
        tab.value("[...page.bar.querySelectorAll('button')].find((b) => b.textContent === 'items').click()")
        assert {"0 front", "1 back"} <= set(tab.value(names))
        press = "[...document.querySelectorAll('.panel .item')].find((r) => r.textContent.includes('{}')).{}"
        tab.value(press.format("0 front", "querySelector('[title^=transparent]').click()"))
        mixed, _, shining, name = middle()
        assert mixed < red - 20 and shining > blue + 20 and name == "front"
        tab.value(press.format("0 front", "querySelector('input').click()"))
        red, _, blue, name = middle()
        assert red < 60 and blue > 100 and name == "back"
        tab.value(press.format("0 front", "querySelector('[title$=only]').click()"))
        assert middle()[3] == "front"
        assert tab.value("page.items.filter((_, i) => page.opacity(i)).map((item) => item[3])") == ["front"]
        tab.value(press.format("1 back", "querySelector('[title^=zoom]').click()"))
        assert tab.value("page.looking().center") == pytest.approx([0, 0, -2], abs=1e-6)
        tab.value("(() => { const s = document.querySelector('.panel input'); s.value = 'BACK'; s.oninput(); })()")
        assert tab.value(names) == ["1 back"]
        tab.value("[...document.querySelectorAll('.panel button')].find((b) => b.textContent === 'show all').click()")
        assert tab.value("page.items.every((_, i) => page.opacity(i) === 1)")
        assert not tab.errors


def test_the_first_view_fits_windows_of_any_shape(falling: Any) -> None:
    """All corners of the scene are in the window, also of a telephone, with the perspective of pages."""
    falling.SaveHTML("falling.html", framesPerSecond=10)
    corners = """page.objects.filter((o) => o.isMesh).flatMap((o) => {
      o.geometry.computeBoundingBox();
      const { min, max } = o.geometry.boundingBox, points = [];
      for (let i = 0; i < 8; ++i) points.push(min.clone().set(i & 1 ? min.x : max.x, i & 2 ? min.y : max.y, i & 4 ? min.z : max.z));
      const at = (k) => { const m = o.matrixWorld.clone(); if (o.isInstancedMesh) o.getMatrixAt(k, m); return m; };
      return o.userData.items.flatMap((_, k) => points.map((p) => page.projected(p.clone().applyMatrix4(at(k)))));
    })"""
    with browser.running() as program:
        tab = program.tab()
        for width, height in ((1300, 600), (390, 800)):
            tab.call(
                "Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False
            )
            tab.go(Path("falling.html").resolve().as_uri() + f"?{width}")
            tab.wait("page.drawn > 0")
            for number in (0, 10):
                tab.value(f"page.play(false), page.show({number})")
                pixels = np.array(tab.value(corners))
                assert (pixels >= 0).all() and (pixels <= [width, height]).all(), (width, number)
            assert tab.value("document.documentElement.scrollWidth") <= width


def test_pages_have_help_coordinates_parallel_lines_and_films(falling: Any) -> None:
    falling.SaveHTML("falling.html", framesPerSecond=10)
    with browser.running() as program:
        tab = program.tab(Path("falling.html").resolve().as_uri())
        tab.wait("page.drawn > 0")
        tab.press("?")
        assert "play or pause" in tab.value("document.querySelector('[data-name=help]').textContent")
        tab.press("?")
        assert tab.value("document.querySelector('[data-name=help]') === null")
        tab.value("page.play(false), page.show(0), page.render()")
        x, y = tab.value("page.projected([1, 0, 0.05])")
        tab.call("Input.dispatchMouseEvent", type="mouseMoved", x=x, y=y)
        words = tab.value("page.hint.textContent").split("\n")
        point = [float(part) for part in words[1].removesuffix(" m").strip("()").split(",")]
        hit = tab.value(f"[...page.hit({x}, {y}).point]")
        pixel = tab.value("2 * page.looking().zoom / page.canvas.clientHeight")
        assert words[0].startswith("object 0: ") and point == pytest.approx(hit, abs=pixel)
        before = tab.value("page.looking()")

        def width(depth: float) -> float:
            """Pixels between two points 0.1 m from each other, so far behind the middle of the view."""
            right, towards = before["rotation"][:3], before["rotation"][6:]
            middle = np.array(before["center"]) - depth * np.array(towards)
            ends = [tab.value(f"page.projected({(middle + s * np.array(right)).tolist()})") for s in (0, 0.1)]
            return float(ends[1][0] - ends[0][0])

        assert width(1.0) < 0.95 * width(0.0)
        tab.press("o")
        assert tab.value("page.looking().zoom") == pytest.approx(before["zoom"])
        assert width(1.0) == pytest.approx(width(0.0), rel=0.02)
        tab.value("""(() => {
          URL.createObjectURL = (blob) => ((window.saved = blob), "blob:");
          HTMLAnchorElement.prototype.click = function () { window.name_ = this.download; };
          page.times.speed = 0.25; // time for many pictures, also on a busy machine
          page.shoot();
        })()""")
        kind, size, name = tab.wait("window.saved && [window.saved.type, window.saved.size, window.name_]")
        assert kind.startswith("video/") and size > 1000 and name == f"film.{kind[6:]}"
        assert not tab.value("page.playing") and not tab.errors


def test_a_floor_is_below_all_of_the_motion(falling: Any) -> None:
    """The grid is less than a cell below the lowest point, on the axis along which weight acts; it is not picked."""
    falling.SaveHTML("falling.html", framesPerSecond=10)
    with browser.running() as program:
        tab = program.tab(Path("falling.html").resolve().as_uri())
        tab.wait("page.drawn > 0 && !!page.floor")
        floor = tab.value("[page.floor.up, page.floor.level, page.floor.cell, page.floor.object.children.length]")
        lowest = tab.value("page.floor.box.min.getComponent(page.floor.up)")
        assert (
            floor[0] == unpacked(data_of(Path("falling.html").read_text("utf-8")))[0]["upwards"]
            and lowest - floor[2] <= floor[1] <= lowest
        )
        tab.value("page.play(false), page.look({ ...page.looking(), zoom: 100 })")
        tab.value("page.ground()")
        assert tab.value("page.floor === null")
        tab.value("page.renderer.shadowMap.enabled = true, page.ground(), page.reveal(), page.render()")
        assert tab.value("page.floor.object.children.length") == 4  # grid, lamp, its target, and what is shaded
        assert tab.value("page.objects.includes(page.floor.object)") is False and not tab.errors
