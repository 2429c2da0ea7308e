"""Shared parts of the tests of live pages: a page without a browser, and solutions that take long."""

from __future__ import annotations

import json
import threading
import time
from typing import Any

import numpy as np
from websockets.sync.client import connect

import dalembert as exu
from dalembert._live.viewer import Viewer


def unpacked(data: bytes) -> tuple[dict[str, Any], list[Any]]:
    """Head and arrays of a message."""
    length = int(np.frombuffer(data[:4], "<u4")[0])
    head, offset, arrays = json.loads(data[4 : 4 + length]), 4 + length, []
    for entry in head["arrays"]:
        if entry is None:
            arrays.append(None)
            continue
        kind, count = entry
        part = np.frombuffer(data, {"f4": "<f4", "u4": "<u4", "u1": "u1", "r6": "<u4"}[kind], count, offset)
        offset += -(-part.nbytes // 4) * 4
        arrays.append(turned(part) if kind == "r6" else part)
    assert offset == len(data) and (4 + length) % 8 == 0
    return head, arrays


def turned(words: Any) -> Any:
    """Places in 12 numbers each, of six words."""
    words = words.reshape(-1, 6)
    rows = np.empty((len(words), 3, 4))
    rows[:, :, 3] = words[:, :3].copy().view("<f4")
    rows[:, :2, :3] = words[:, 3:].copy().view("<i2").reshape(-1, 2, 3) / 32000
    rows[:, 2, :3] = np.cross(rows[:, 0, :3], rows[:, 1, :3])
    return rows.ravel()


class Reader:
    """A page, as seen by the server."""

    def __init__(self, viewer: Viewer, token: str | None = None, **headers: str) -> None:
        port = viewer.server.port
        origin = headers.pop("origin", f"http://127.0.0.1:{port}")
        address = f"ws://{headers.pop('host', '127.0.0.1')}:{port}/socket"
        self.socket = connect(address, origin=origin, proxy=None, max_size=None, compression=None).__enter__()  # type: ignore[arg-type]
        self.send("hello", token=viewer.server.token if token is None else token)

    def send(self, kind: str, **words: Any) -> None:
        self.socket.send(json.dumps({"kind": kind, **words}))

    def press(self, key: str, **held: bool) -> None:
        self.send("key", key=key, control=held.get("control", False), shift=held.get("shift", False), action=1)

    def message(self, kind: str, seconds: float = 20) -> Any:
        """The next message of a kind; every picture is acknowledged."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            data = self.socket.recv(timeout=seconds)
            if isinstance(data, bytes):
                head, arrays = unpacked(data)
                self.send("shown")
                if head["kind"] == kind:
                    return head, arrays
            elif (words := json.loads(data))["kind"] == kind:
                return words
        raise AssertionError(f"no message '{kind}'")

    def picture(self) -> tuple[dict[str, Any], list[Any]]:
        """The next picture, whole or not."""
        while not isinstance(data := self.socket.recv(timeout=20), bytes):
            pass
        self.send("shown")
        return unpacked(data)

    def until(self, true: Any, seconds: float = 20) -> None:
        """Read until something is true."""
        end = time.monotonic() + seconds
        while not true():
            assert time.monotonic() < end
            try:
                if isinstance(self.socket.recv(timeout=0.05), bytes):
                    self.send("shown")
            except TimeoutError:
                pass


def settings(steps: int, end: float = 1.0) -> Any:
    result = exu.SimulationSettings()
    result.timeIntegration.endTime = end
    result.timeIntegration.numberOfSteps = steps
    result.timeIntegration.verboseMode = 0
    result.solutionSettings.writeSolutionToFile = False
    return result


def solving(mbs: Any, steps: int = 1_000_000, end: float = 1000.0) -> threading.Thread:
    """A thread that solves, for a long time."""
    thread = threading.Thread(target=lambda: mbs.SolveDynamic(settings(steps, end)), daemon=True)
    thread.start()
    return thread
