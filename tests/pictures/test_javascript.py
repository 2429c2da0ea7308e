"""JavaScript reads the data that Python packs: the module of pages that does it, run by the browser."""

from __future__ import annotations

import base64
import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import test_page
from browser import Tab, running
from page_reader import unpacked
from test_live_messages import GOLDEN, moved_scene

import dalembert as exu
from dalembert._live.messages import Stage
from dalembert._pictures.camera import Camera
from dalembert._pictures.looks import Looks

READER = Path(exu.__file__).resolve().parent / "_pictures/page/data.js"

falling = test_page.falling


@pytest.fixture(scope="module")
def tab() -> Iterator[Tab]:
    """An empty page that has the functions of data.js as `reader`."""
    with running() as browser:
        tab = browser.tab()
        module = base64.b64encode(READER.read_bytes()).decode()
        tab.value(f"import('data:text/javascript;base64,{module}').then((m) => {{ window.reader = m; }})")
        yield tab


def test_javascript_reads_the_stored_messages(tab: Tab) -> None:
    sent = [path.read_bytes() for path in GOLDEN]
    read = tab.value(f"""
        {json.dumps([base64.b64encode(data).decode() for data in sent])}.map((text) => {{
          const {{ head, arrays }} = reader.message(Uint8Array.from(atob(text), (c) => c.charCodeAt(0)).buffer);
          return [head, arrays.map((a) => a && Array.from(a))];
        }})""")
    for (head, arrays), (expected, numbers) in zip(read, map(unpacked, sent), strict=True):
        assert head == expected
        for kind, array, known in zip(head["arrays"], arrays, numbers, strict=True):
            if kind is not None and kind[0] == "r6":  # there, numbers of the third row are rounded to single precision
                assert array == pytest.approx(known.tolist(), rel=1e-6, abs=1e-7)
            else:
                assert array == (None if known is None else known.tolist())


def test_traces_that_grow_are_joined_to_those_of_the_picture_before(tab: Tab) -> None:
    """Only new points of long lines are sent; static lines remain among moving ones."""
    rng, stage, before, shown = np.random.default_rng(1), Stage(), np.empty(0), 0
    whole = rng.normal(size=(300, 3)).astype("<f4").astype(float)
    for count in (60, 80, 80, 300):
        scene = moved_scene(0.1 * count)
        first, last = scene.lines[0], (whole[:count] + 1, (0, 0, 0, 1), 0.0, 0)
        scene.lines = [(whole[:count], (1, 0, 0, 1), 0.0, 0), first, last]
        picture = stage.messages(scene, Looks(exu.VisualizationSettings()), {}, Camera)
        frame, grown = picture.after(False), picture.after(True)
        lines = np.concatenate([points.ravel() for points, *_ in scene.lines])
        if grown is not frame:
            head, arrays = unpacked(b"".join(grown))
            _, complete = unpacked(b"".join(frame))
            assert complete[-3].tolist() == pytest.approx(lines, rel=1e-7)
            sent, new = arrays[-3], 2 * (count - shown) + 2  # both ends of the line between them move
            assert len(sent) == 3 * new == len(lines) - sum(size for *_, size in head["kept"])
            read = tab.value(f"""Array.from(reader.joined(
                Float32Array.from({sent.tolist()}), {head["kept"]}, Float32Array.from({before.tolist()})))""")
            assert read == pytest.approx(lines, rel=1e-6)
        assert (grown is frame) == (count == 60)
        before, shown = lines, count


def test_javascript_reads_a_saved_motion(tab: Tab, falling: Any) -> None:
    falling.SaveHTML("falling.html", framesPerSecond=10)
    data = test_page.data_of(Path("falling.html").read_text("utf-8"))
    read = tab.value(f"""
        reader.read("{base64.b64encode(data).decode()}").then(({{ head, arrays }}) => {{
          const brick = head.meshes.find((mesh) => mesh.places);
          const third = Array.from(reader.frame(arrays[brick.places[0]], 12, 3, new Float32Array(12)));
          return {{ head, third, sums: arrays.map((a) => a.reduce((s, x) => s + x, 0)) }};
        }})""")
    head, arrays = test_page.unpacked(data)
    assert read["head"] == head
    assert read["sums"] == pytest.approx([float(a.sum(dtype=float)) for a in arrays])
    places = arrays[next(mesh for mesh in head["meshes"] if "places" in mesh)["places"][0]]
    assert read["third"] == pytest.approx(places.reshape(12, -1)[:, -1 if places.size == 12 else 3])
