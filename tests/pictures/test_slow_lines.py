"""Pages on slow lines show the present state, at the rate of the line: pictures do not wait in a row, and solvers do
not wait for pages."""

from __future__ import annotations

import contextlib
import json
import socket
import threading
import time
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from page_reader import Reader, settings

from dalembert import graphics
from dalembert._live.messages import Picture
from dalembert._live.server import PageServer
from dalembert._live.viewer import Viewer
from dalembert.utilities import InertiaCuboid

RATE = 1e6 / 8  # bytes per second: 1 Mbit/s
PART = 1250  # bytes that are sent at once: a hundredth of a second


@pytest.fixture
def swinging(mbs: Any) -> Any:
    """Bricks that fall and turn: 600 places of twelve numbers, so that a picture takes a quarter of a second on the line."""
    brick = [graphics.Brick(size=[0.4, 0.2, 0.1])]
    inertia = InertiaCuboid(1000, [0.4, 0.2, 0.1])
    for i in range(600):
        mbs.CreateRigidBody(
            referencePosition=[i % 20, i // 20, 0], initialAngularVelocity=[1, 0.1 * i, 0.2],
            inertia=inertia, graphicsDataList=brick,
        )  # fmt: skip
    mbs.Assemble()
    return mbs


class Line(threading.Thread):
    """Lets a connection pass: the proxy sends to the server at once, to the page with a rate, without own memory."""

    def __init__(self, port: int) -> None:
        super().__init__(daemon=True)
        self._port, self._listener = port, socket.create_server(("127.0.0.1", 0))
        self.port = self._listener.getsockname()[1]
        self.carried = 0
        self.start()

    def run(self) -> None:
        page, _ = self._listener.accept()
        server = socket.create_connection(("127.0.0.1", self._port))
        server.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4 * PART)
        threading.Thread(target=self._pass, args=(page, server, float("inf")), daemon=True).start()
        self._pass(server, page, RATE)

    def _pass(self, source: socket.socket, target: socket.socket, rate: float) -> None:
        with contextlib.suppress(OSError):
            while data := source.recv(PART):
                time.sleep(len(data) / rate)
                target.sendall(data)
                self.carried += len(data)


class Far(Reader):
    """A page at the other end of a line."""

    def __init__(self, viewer: Viewer, line: Line) -> None:
        from websockets.sync.client import connect

        origin, port = f"http://127.0.0.1:{viewer.server.port}", viewer.server.port
        slow = socket.create_connection(("127.0.0.1", line.port))
        self.socket = connect(
            f"ws://127.0.0.1:{port}/socket",
            sock=slow,
            origin=origin,
            proxy=None,
            max_size=None,
            close_timeout=1,  # data on the line is then obsolete
            compression=None,  # type: ignore[arg-type]
        ).__enter__()
        self.send("hello", token=viewer.server.token)


@pytest.fixture
def far(viewer: Viewer) -> Iterator[Far]:
    page = Far(viewer, Line(viewer.server.port))
    yield page
    page.socket.close()


def test_a_picture_on_a_slow_line_is_as_old_as_its_way_is_long(swinging: Any, viewer: Viewer, far: Far) -> None:
    passed: list[tuple[float, float]] = []  # time of the solution, and when it was

    def note(mbs: Any, t: float) -> bool:
        passed.append((t, time.monotonic()))
        time.sleep(0.002)
        return True

    swinging.SetPreStepUserFunction(note)
    far.message("scene")
    thread = threading.Thread(target=lambda: swinging.SolveDynamic(settings(100_000, 1000.0)))
    thread.start()
    ages, trips, asked = [], [], time.monotonic()
    for _ in range(12):
        head, arrays = far.picture()
        now = time.monotonic()
        times, moments = np.array(passed).T
        ages.append(now - float(np.interp(head["time"], times, moments)))
        trips.append(now - asked)
        asked = now
    far.press("q")
    thread.join(20)
    assert not thread.is_alive()
    sent = sum(part.nbytes for part in arrays if part is not None)
    assert np.median(trips) > 0.8 * sent / RATE > 0.1  # the line is slow
    # beyond its way, a picture is older by the 50 ms that copies of states may wait
    beyond = np.array(ages[2:]) - np.array(trips[2:])
    assert -0.5 < np.median(beyond) < 0.05


def test_a_slow_line_delays_neither_the_solver_nor_other_pages(swinging: Any, viewer: Viewer, far: Far) -> None:
    near = Reader(viewer)
    near.message("scene")
    solution = threading.Thread(target=lambda: swinging.SolveDynamic(settings(1_000_000, 1000.0)))
    solution.start()
    count = {"near": 0, "far": 0}
    end = time.monotonic() + 3

    def read(name: str, page: Reader) -> None:
        while time.monotonic() < end:
            page.picture()
            count[name] += 1

    readers = [threading.Thread(target=read, args=pair) for pair in (("near", near), ("far", far))]
    for reader in readers:
        reader.start()
    for reader in readers:
        reader.join(30)
    near.press("q")
    solution.join(20)
    assert not solution.is_alive()
    assert count["far"] >= 2  # it goes on
    assert count["near"] > 2 * count["far"]


@pytest.mark.parametrize("at_once", [True, False])
def test_messages_stay_complete_when_the_page_reads_late(at_once: bool) -> None:
    """Larger than the buffer of the system, while another thread sends texts; also where that thread writes all, as on
    Windows."""
    from websockets.sync.client import connect

    server = PageServer(lambda page, message: None)
    origin, address = f"http://127.0.0.1:{server.port}", f"ws://127.0.0.1:{server.port}/socket"
    pictures = [bytes([number]) * (9_000_000 + number) for number in range(1, 6)]
    with connect(address, origin=origin, proxy=None, max_size=None, compression=None) as page:  # type: ignore[arg-type]
        page.send(json.dumps({"kind": "hello", "token": server.token}))
        while not server.pages:
            time.sleep(0.001)
        shown = next(iter(server._pages.values()))
        shown.scene = 1  # it gets frames
        if not at_once:
            shown.connection.end_pictures()
        words = []
        for data in pictures:
            server.publish(Picture(1, lambda data=data: data, [data[:100], memoryview(data)[100:]]))  # type: ignore[misc]
            for _ in range(10):
                server.tell({"kind": "state", "text": str(len(words))})
                words.append(str(len(words)))
            time.sleep(0.05)  # it waits in the line
            told = []
            while not isinstance(found := page.recv(timeout=20), bytes):
                told.append(json.loads(found)["text"])
            assert found == data
            while len(told) < 10:
                told.append(json.loads(page.recv(timeout=20))["text"])
            assert told == words[-10:]
            page.send('{"kind":"shown"}')
            while not server.wanted:
                time.sleep(0.001)
    server.stop()


def test_a_large_scene_has_the_time_that_a_slow_line_needs(viewer: Viewer) -> None:
    """Answers to the server's signs of life wait behind it."""
    reader = Reader(viewer)
    reader.message("scene")
    connection = next(iter(viewer.server._pages.values())).connection
    assert 50e6 / RATE < (connection.ping_timeout or 0) < 3600
