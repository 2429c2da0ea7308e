"""What Python packs is what JavaScript reads: the module of pages that does it, run by the browser."""

from __future__ import annotations

import base64
import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
import test_live_page
import test_page
from browser import Tab, running

import dalembert as exu

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
    sent = [path.read_bytes() for path in test_live_page.GOLDEN]
    read = tab.value(f"""
        {json.dumps([base64.b64encode(data).decode() for data in sent])}.map((text) => {{
          const {{ head, arrays }} = reader.message(Uint8Array.from(atob(text), (c) => c.charCodeAt(0)).buffer);
          return [head, arrays.map((a) => a && Array.from(a))];
        }})""")
    expected = [
        [head, [None if a is None else a.tolist() for a in arrays]]
        for head, arrays in map(test_live_page.unpacked, sent)
    ]
    assert read == expected


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
