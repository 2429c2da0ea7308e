"""A browser for tests, driven by the DevTools protocol over websockets: nothing is needed besides the browser itself.

It is the one of DALEMBERT_BROWSER, or chromium of the system. Tests without a browser are skipped by name, and the
summary of pytest states this (conftest.py); they fail if DALEMBERT_BROWSER is set.
"""

from __future__ import annotations

import contextlib
import itertools
import json
import os
import shutil
import subprocess
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from websockets.sync.client import connect

MISSING = "no browser: install chromium, or name one by DALEMBERT_BROWSER (docs/developer/dependencies.rst)"
DEBIAN = "/usr/bin/chromium"  # the system's Mesa is five times as fast as the renderer of browsers
MESA = ["--use-angle=gl-egl", "--ignore-gpu-blocklist"]
OWN = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--single-process", "--no-zygote"]
OPTIONS = [
    "--headless", "--no-sandbox", "--no-first-run", "--disable-extensions", "--use-gl=angle", "--window-size=800,600",
]  # fmt: skip


def program() -> str:
    """Path of the browser; skips the test if there is none."""
    if named := os.environ.get("DALEMBERT_BROWSER"):
        if shutil.which(named) is None:
            pytest.fail(f"DALEMBERT_BROWSER: {named} is no program; {MISSING}", pytrace=False)
        return named
    found = next(filter(None, map(shutil.which, ("chromium", "google-chrome", "chrome-headless-shell"))), None)
    if found is None:
        pytest.skip(MISSING)
    return found


def command() -> list[str]:
    """Program and options of a browser without a display."""
    path = program()
    return [path, *OPTIONS, *(MESA if path == DEBIAN else OWN)]


class Tab:
    """A page in the browser."""

    def __init__(self, address: str) -> None:
        self._socket = connect(address, max_size=None, proxy=None).__enter__()
        self._numbers = itertools.count()
        self.requests: list[str] = []
        self.errors: list[str] = []
        for domain in ("Page", "Network", "Runtime"):
            self.call(f"{domain}.enable")

    def call(self, method: str, **parameters: Any) -> dict[str, Any]:
        """Send a command and return its result."""
        number = next(self._numbers)
        self._socket.send(json.dumps({"id": number, "method": method, "params": parameters}))
        while True:
            message = json.loads(self._socket.recv(timeout=60))
            self._note(message)
            if message.get("id") == number:
                assert "error" not in message, (method, message["error"])
                return message["result"]

    def _note(self, message: dict[str, Any]) -> None:
        parameters = message.get("params", {})
        if message.get("method") == "Network.requestWillBeSent":
            self.requests.append(parameters["request"]["url"])
        elif message.get("method") == "Network.webSocketCreated":
            self.requests.append(parameters["url"])
        elif message.get("method") == "Runtime.exceptionThrown":
            details = parameters["exceptionDetails"]
            self.errors.append(details.get("exception", {}).get("description") or details["text"])

    def go(self, address: str) -> None:
        """Open an address."""
        self.call("Page.navigate", url=address)

    def value(self, expression: str) -> Any:
        """Evaluate JavaScript in the page."""
        result = self.call("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        assert "exceptionDetails" not in result, result["exceptionDetails"]
        return result["result"].get("value")

    def wait(self, expression: str, seconds: float = 40) -> Any:
        """Wait until an expression is true, and return it."""
        end = time.monotonic() + seconds
        while not (value := self.value(f"(() => {{ try {{ return {expression}; }} catch {{ return null; }} }})()")):
            assert time.monotonic() < end, (expression, self.errors, self.value("document.body?.innerText"))
            time.sleep(0.05)
        return value

    def press(self, key: str, code: str = "", held: int = 0) -> None:
        """Press and release a key; held: 1 alt, 2 control, 8 shift."""
        for kind in ("keyDown", "keyUp"):
            self.call("Input.dispatchKeyEvent", type=kind, key=key, code=code, modifiers=held)

    def click(self, x: float, y: float, held: int = 0) -> None:
        """Click with the left button."""
        for kind in ("mousePressed", "mouseReleased"):
            self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", clickCount=1, modifiers=held)

    def picture(self) -> bytes:
        """A screenshot, as PNG."""
        import base64

        return base64.b64decode(self.call("Page.captureScreenshot")["data"])

    def close(self) -> None:
        self.call("Page.close")
        self._socket.close()


class Browser:
    """A running browser."""

    def __init__(self, port: int) -> None:
        self.port = port

    def tab(self, address: str = "about:blank") -> Tab:
        """Open a tab."""
        import urllib.request

        request = urllib.request.Request(f"http://127.0.0.1:{self.port}/json/new?about:blank", method="PUT")
        with urllib.request.urlopen(request, timeout=30) as answer:
            tab = Tab(json.load(answer)["webSocketDebuggerUrl"])
        tab.go(address)
        return tab


@contextlib.contextmanager
def running() -> Iterator[Browser]:
    """Start the browser, and end it."""
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        options = [f"--user-data-dir={folder}", "--remote-debugging-port=0"]
        process = subprocess.Popen(
            [*command(), *options, "about:blank"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
        )
        try:
            noted = Path(folder, "DevToolsActivePort")
            end = time.monotonic() + 60
            while not (noted.exists() and noted.read_text().count("\n") >= 1):
                assert process.poll() is None and time.monotonic() < end, f"{process.args} does not start"
                time.sleep(0.05)
            yield Browser(int(noted.read_text().split()[0]))
        finally:
            process.terminate()
            process.wait(20)
