"""Ways to open the viewer: a browser, a link in a notebook, or an address in a terminal."""

from __future__ import annotations

import atexit
import math
import os
import shutil
import tempfile
import webbrowser
from html import escape
from importlib import import_module
from pathlib import Path
from typing import Any

from dalembert._core import Print
from dalembert._live import widget
from dalembert._live.server import PageServer

RETURN = 3.0  # s until a page that was reloaded is back
PATIENCE = {"browser": 20.0, "notebook": math.inf, "address": math.inf}  # s until the first page is there


def open_page(container: Any, where: str, verbose: int = 0) -> None:
    """Start the viewer of a container, and bring a reader there; nothing more if it has one.

    Notebooks show it below the cell that is running, also if it has been shown before.
    """
    if where == "notebook" and widget.is_installed():
        from dalembert._live import notebook

        notebook.show(container)
        return
    from dalembert._live.viewer import start, viewer_of

    if viewer_of(container) is not None:
        return
    viewer = start(container, wanted_port())
    viewer.expect(PATIENCE[where])
    server = viewer.server
    assert isinstance(server, PageServer)
    bring(server, where)
    if verbose and where == "browser":
        Print(f"dalembert: the page is at {server.address}")


def bring(server: PageServer, where: str) -> None:
    """Bring a reader to a page."""
    if where == "browser":
        _open_in_browser(server.address)
    elif where == "notebook":
        shown = import_module("IPython.display")
        address = escape(server.address, quote=True)
        words = "in the notebook: pip install 'dalembert[notebook]'"
        shown.display(shown.HTML(f'<a href="{address}" target="_blank" rel="noreferrer">live view</a> ({words})'))
    else:
        Print(_words(server))


def wanted_port() -> int:
    """Return the port that the user wants, for tunnels; 0 for any."""
    text = os.environ.get("DALEMBERT_VIEWER_PORT", "0")
    if not text.isdigit() or int(text) > 65535:
        raise ValueError(f"DALEMBERT_VIEWER_PORT: expected a number from 0 to 65535, received '{text}'")
    return int(text)


def _words(server: PageServer) -> str:
    lines = [f"dalembert: the page is at {server.address}"]
    if "SSH_CONNECTION" in os.environ:
        host = os.environ["SSH_CONNECTION"].split()[2:3] or ["this-machine"]
        lines.append(f"From your own machine, run first:  ssh -L {server.port}:127.0.0.1:{server.port} {host[0]}")
    return "\n".join(lines)


def _open_in_browser(address: str) -> None:
    """Open the page by way of a file that only this user can read: arguments of programs are seen by all users."""
    folder = Path(tempfile.mkdtemp(prefix="dalembert-"))
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    path = folder / "page.html"
    address = escape(address, quote=True)
    path.write_text(
        f'<!doctype html><meta charset="utf-8"><meta name="referrer" content="no-referrer">'
        f'<meta http-equiv="refresh" content="0; url={address}"><a href="{address}">dalembert</a>',
        "utf-8",
    )
    webbrowser.open(path.as_uri())
