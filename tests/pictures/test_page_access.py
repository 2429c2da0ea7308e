"""Access to a live page, and rights of pages."""

from __future__ import annotations

import socket
import time
import urllib.error
import urllib.request
from pathlib import Path
from typing import Any

import pytest
from page_reader import Reader
from websockets.exceptions import ConnectionClosed, InvalidStatus
from websockets.sync.client import connect

import dalembert as exu
from dalembert._live import server as serving
from dalembert._live.viewer import Viewer

Shown = exu.ConfigurationType.Visualization
FOLDER = Path(exu.__file__).resolve().parent / "_pictures/page"


def asked(viewer: Viewer, path: str, **headers: str) -> Any:
    request = urllib.request.Request(f"http://127.0.0.1:{viewer.server.port}{path}", headers=headers)
    return urllib.request.build_opener(urllib.request.ProxyHandler({})).open(request, timeout=10)


def test_the_port_is_of_this_machine_only(viewer: Viewer) -> None:
    addresses = {row[4][0] for row in socket.getaddrinfo(socket.gethostname(), None, socket.AF_INET)} - {"127.0.0.1"}
    for address in addresses | {"127.0.0.2"}:  # Linux has it, so that a server of all addresses answers there
        with pytest.raises(OSError):
            socket.create_connection((address, viewer.server.port), timeout=2).close()
    socket.create_connection(("127.0.0.1", viewer.server.port), timeout=2).close()


def test_the_page_reveals_nothing_of_the_model_and_allows_nothing(viewer: Viewer) -> None:
    answer = asked(viewer, "/")
    text = answer.read().decode()
    assert viewer.server.token not in text and "brick" not in text and "@" not in text
    policy = answer.headers["Content-Security-Policy"]
    assert "default-src 'none'" in policy and "script-src 'self';" in policy and "frame-ancestors 'none'" in policy
    assert answer.headers["Referrer-Policy"] == "no-referrer" and answer.headers["Cache-Control"] == "no-store"
    assert asked(viewer, "/bundle.js").read() == (FOLDER / "bundle.js").read_bytes()


@pytest.mark.parametrize("path", ["/server.py", "/../html.py", "/%2e%2e/html.py", "//etc/passwd", "/page.html", "/?x"])
def test_there_are_no_other_files(viewer: Viewer, path: str) -> None:
    with pytest.raises(urllib.error.HTTPError, match="404"):
        asked(viewer, path)


def test_another_name_of_the_host_is_refused(viewer: Viewer) -> None:
    """A page of elsewhere whose name is made to lead here (DNS rebinding)."""
    for path in ("/", "/bundle.js"):
        with pytest.raises(urllib.error.HTTPError, match="403"):
            asked(viewer, path, Host="evil.example:80")


@pytest.mark.parametrize("origin", ["http://evil.example", "null", None])
def test_pages_of_elsewhere_are_refused(viewer: Viewer, origin: str | None) -> None:
    with pytest.raises(InvalidStatus, match="403"):
        Reader(viewer, origin=origin)  # type: ignore[arg-type]


@pytest.mark.parametrize("token", ["", "x" * 32, "wrong"])
def test_nothing_is_sent_without_the_token(viewer: Viewer, token: str) -> None:
    reader = Reader(viewer, token)
    with pytest.raises(ConnectionClosed) as closed:
        reader.socket.recv(timeout=10)
    assert closed.value.rcvd is not None and closed.value.rcvd.code == 1008
    assert viewer.server.pages == 0 and len(viewer.server.token) == 32


def test_tokens_differ_and_are_compared_in_constant_time(
    SC: Any, viewer: Viewer, monkeypatch: pytest.MonkeyPatch
) -> None:
    compared: list[tuple[bytes, bytes]] = []
    monkeypatch.setattr(serving.hmac, "compare_digest", lambda a, b: compared.append((a, b)) or a == b)
    with pytest.raises(ConnectionClosed):
        Reader(viewer, "wrong").socket.recv(timeout=10)
    assert compared == [(b"wrong", viewer.server.token.encode())]
    other = serving.PageServer(lambda page, message: None, 0)
    try:
        assert other.token != viewer.server.token
    finally:
        other.stop()


def test_a_server_is_not_closed_under_a_thread_that_wakes_it(monkeypatch: pytest.MonkeyPatch) -> None:
    """The socket for that could be another file by the time that the thread writes to it."""
    server, closed = serving.PageServer(lambda page, message: None), []
    wake = server._loop.call_soon_threadsafe

    def slowly(*arguments: Any, **options: Any) -> None:
        wake(*arguments, **options)
        time.sleep(0.5)
        closed.append(server._loop.is_closed())

    monkeypatch.setattr(server._loop, "call_soon_threadsafe", slowly)
    server.stop()
    assert closed == [False] and server._loop.is_closed()
    server.tell({"kind": "notice"})  # nobody
    assert closed == [False]


def test_silent_connections_are_closed(viewer: Viewer, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(serving, "PATIENCE", 0.2)
    port = viewer.server.port
    address, origin = f"ws://127.0.0.1:{port}/socket", f"http://127.0.0.1:{port}"
    with connect(address, origin=origin, proxy=None) as silent, pytest.raises(ConnectionClosed):  # type: ignore[arg-type]
        silent.recv(timeout=10)


def test_there_are_not_too_many_pages(viewer: Viewer, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(serving, "PAGES", 2)
    first, second = Reader(viewer), Reader(viewer)
    first.message("scene")
    second.message("scene")
    with pytest.raises(ConnectionClosed) as closed:
        Reader(viewer).message("scene")
    assert closed.value.rcvd is not None and closed.value.rcvd.code == 1013


def test_long_messages_are_refused(viewer: Viewer) -> None:
    reader = Reader(viewer)
    reader.message("scene")
    reader.send("set", path="x" * (serving.LONGEST + 1), value="")
    with pytest.raises(ConnectionClosed) as closed:
        while True:
            reader.socket.recv(timeout=10)
    assert closed.value.rcvd is not None and closed.value.rcvd.code == 1009
    assert Reader(viewer).message("scene")  # other pages continue


HOSTILE = [
    "", "no json", "[]", "3", '{"kind": 3}', '{"kind": "opened.__class__"}', '{"kind": "__init__"}', "[" * 10000,
    '{"kind": "key"}', '{"kind": "key", "key": {}, "control": [], "shift": null}', '{"kind": "select", "item": 1e99, "scene": 1}',
    '{"kind": "select", "item": 99999, "scene": 1, "depth": 0}', '{"kind": "camera", "rotation": [], "center": 0, "zoom": 0}',
    '{"kind": "camera", "rotation": [1,0,0,0,1,0,0,0,1], "center": [NaN,0,0], "zoom": 1}', '{"kind": "mouse"}',
    '{"kind": "set", "path": "__class__.__name__", "value": "x"}', '{"kind": "set", "path": "", "value": "1"}',
    '{"kind": "control", "name": "x", "value": {"__reduce__": 1}}',
]  # fmt: skip


def test_nonsense_is_answered_or_ignored(viewer: Viewer) -> None:
    reader = Reader(viewer)
    reader.message("scene")
    for text in HOSTILE:
        reader.socket.send(text)
    reader.socket.send(b"\x80\x04cos\nsystem\n.")  # a pickle
    reader.press("n")
    reader.until(lambda: not viewer.settings.nodes.show)


@pytest.mark.parametrize(
    ("path", "value"),
    [
        ("exportImages.saveImageFileName", "/tmp/elsewhere"),
        ("interactive.openVR.actionManifestFileName", "/etc/passwd"),
        ("interactive.keyPressUserFunction", "print"),
        ("nodes.defaultSize", "__import__('os').getpid()"),
        ("nodes.nothing", "1"),
        ("nodes", "1"),
    ],
)
def test_settings_that_pages_may_not_change(viewer: Viewer, path: str, value: str) -> None:
    before = repr(viewer.settings.GetDictionary())
    reader = Reader(viewer)
    reader.send("set", path=path, value=value)
    assert reader.message("notice")["text"]
    assert repr(viewer.settings.GetDictionary()) == before


def test_settings_that_pages_may_change(viewer: Viewer) -> None:
    reader = Reader(viewer)
    reader.send("settings")
    rows = {row["path"]: row for row in reader.message("settings")["rows"]}
    assert rows["nodes.show"]["choices"] == ["True", "False"] and rows["nodes"]["branch"]
    assert "Displacement" in rows["contour.outputVariable"]["choices"]
    assert "exportImages.saveImageFileName" not in rows and len(rows) > 400
    reader.send("set", path="contour.outputVariable", value="Displacement")
    reader.send("set", path="nodes.defaultColor", value="[0, 1, 0, 1]")
    while not ((contour := reader.picture()[0].get("contour")) and contour["name"].startswith("Displacement")):
        pass
    reader.until(lambda: list(viewer.settings.nodes.defaultColor) == [0, 1, 0, 1])
    assert viewer.settings.contour.outputVariable == exu.OutputVariableType.Displacement
