"""mbs.SaveHTML(): a motion as one file that every browser opens, without a server and without a network."""

from __future__ import annotations

import gzip
from base64 import b64encode
from pathlib import Path
from typing import TYPE_CHECKING, Any

from dalembert._io.files import file_to_write, replacing

if TYPE_CHECKING:
    from dalembert._pictures.motion import Motion, Still


def SaveHTML(
    mbs: Any,
    fileName: str,
    solution: dict[str, Any] | None = None,
    framesPerSecond: float = 25,
    speed: float = 1.0,
    view: Any = None,
    title: str = "",
) -> None:
    """Save the motion of a solution (from LoadSolutionFile), or of the last simulation, as a single HTML file.

    The file needs neither a network nor this package: it plays, rotates, zooms, and names items under the mouse.
    If there is no solution, it shows the visualization state. `speed` is the time of the solution that passes in a
    second, `view` that of Draw(); settings are those of SC.visualizationSettings.
    """
    from dalembert._pictures.motion import Motion

    path = Path(file_to_write("SaveHTML: fileName", fileName, newFolder=True))
    if path.suffix.lower() not in (".html", ".htm"):
        raise ValueError(f"SaveHTML: fileName: expected a name that ends with .html, received '{fileName}'")
    motion = Motion(mbs, "SaveHTML", solution, framesPerSecond, speed, view, (1024, 768), optional=True, page=True)
    path.parent.mkdir(parents=True, exist_ok=True)
    with replacing(path) as written:
        Path(written).write_text(page(motion, {"title": title or path.stem, "plays": True, "again": True}), "utf-8")


def page(motion: Motion | Still, words: dict[str, Any]) -> str:
    """Return the HTML of a motion; words: its title, whether it plays when it is opened, and whether it repeats.

    Texts of the model are in its packed data, not in the HTML code.
    """
    folder = Path(__file__).parent / "page"
    text = (folder / "page.html").read_text("utf-8").replace("@STYLE@", (folder / "style.css").read_text("utf-8"))
    code = gzip.compress((folder / "bundle.js").read_bytes(), 9, mtime=0)
    return text.replace("@DATA@", data(motion, words)).replace("@CODE@", _base64(code))


def data(motion: Motion | Still, words: dict[str, Any]) -> str:
    """Return the motion itself, as the page has it."""
    from dalembert._pictures.replay import pack

    return _base64(pack(motion, words))


def _base64(data: bytes) -> str:
    return b64encode(data).decode()


def page_of_state(container: Any) -> str:
    """Return the HTML of the visualization state of all systems of a container."""
    from dalembert._pictures.motion import Still

    return page(Still(container), {"title": "dalembert", "plays": False, "again": False})
