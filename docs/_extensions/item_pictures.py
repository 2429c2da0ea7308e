"""Pictures for the pages of items, Create functions and others: the model of the example, as it is after it has run.

They are made when pages are built, all in one process, and not again before examples or compiled package have changed.
"""

from __future__ import annotations

import json
import re
import subprocess
import sys
import textwrap
from importlib.util import find_spec
from pathlib import Path

from item_drawings import DRAWINGS, draw_items

from codegen.load import load

ROOT = Path(__file__).parents[2]
GENERATED = ROOT / "docs/_generated"
CODE = re.compile(r"^\.\. code-block:: python\n\n((?:(?:   .*)?\n)+)", re.MULTILINE)
# Run in a process of its own: a folder, then a name and an example per page, all by standard input.
DRAWING = """
import sys, json
import numpy as np
import dalembert as exu
from dalembert import itemInterface, utilities
from dalembert._pictures import painting
from dalembert._pictures.draw import camera_for
from dalembert._pictures.studio import Studio

names = {name: value for module in (utilities, itemInterface) for name, value in vars(module).items() if name[0] != "_"}
folder, examples = json.load(sys.stdin)


KINDS = ("Node", "Object", "Marker", "Load", "Sensor")
SIZE = 560, 380  # pixels


def show(mbs, item):
    # Items of the type that the page is about, also those that are hidden unless somebody asks for them. Constraints of
    # single coordinates only hold what else is there.
    for number in range(mbs.systemData.NumberOfObjects()):
        if mbs.GetObject(number)["objectType"] == "ConnectorCoordinate":
            mbs.SetObjectParameter(number, "Vshow", item == "ObjectConnectorCoordinate")
    kind = next(kind for kind in KINDS if item.startswith(kind))
    for number in range(getattr(mbs.systemData, f"NumberOf{kind}s")()):
        parameters = getattr(mbs, f"Get{kind}")(number)
        if kind + parameters[f"{kind.lower()}Type"] == item and "Vshow" in parameters:
            getattr(mbs, f"Set{kind}Parameter")(number, "Vshow", True)


def add_symbols(SC, scene, item):
    # The frames of nodes, and the numbers of all items of the kind of this one.
    # Return whether axes are longer than what is seen besides.
    settings, box = SC.visualizationSettings, scene.box()
    sides = np.ones(3) if box is None else box[1] - box[0]
    is_single = sides.min() > 0.5 * sides.max()
    settings.nodes.showBasis = True
    settings.nodes.basisSize = sides.max() * (0.85 if is_single else 0.12)
    kind = next(kind for kind in KINDS if item.startswith(kind))
    if kind == "Marker":
        settings.markers.defaultSize = sides.max() * 0.05
        settings.nodes.showBasis = is_single  # where there is anything else, frames hide what is about as large
    for group in ("bodies", "connectors") if kind == "Object" else (f"{kind.lower()}s",):
        getattr(settings, group).showNumbers = True
    return is_single


def fill_picture(SC, zoom):
    # The camera is set where the box of the scene is not what is seen: what lies along its diagonal fills little of the
    # picture, and axes of nodes reach beyond it.
    studio = Studio(SC)
    scene = studio.scene()
    camera = camera_for(studio, scene, None, SIZE, 0.5 * zoom)
    seen = np.argwhere(painting.items(scene, camera, studio.makers[0].looks, studio.view(0), SIZE) >= 0)
    (top, left), (bottom, right) = seen.min(axis=0), seen.max(axis=0)
    part = 2 * max((right - left) / SIZE[0], (bottom - top) / SIZE[1])
    if not 0.6 < part < 0.97:
        shift = np.array([left + right - SIZE[0], SIZE[1] - top - bottom, 0]) * camera.zoom / SIZE[1]
        state = {"modelRotation": camera.rotation.T, "centerPoint": camera.center + shift @ camera.rotation}
        SC.renderer.SetState(state | {"zoom": 0.5 * part / 0.8 * zoom * camera.zoom})


for item, code in examples.items():
    SC = exu.SystemContainer()
    mbs = SC.AddSystem()
    exec(code, scope := names | {"exu": exu, "np": np, "SC": SC, "mbs": mbs})
    if "model" in scope:
        mbs, SC = scope["model"].system, scope["model"].container
    if is_item := item.startswith(KINDS):
        show(mbs, item)
    elif not mbs.systemIsConsistent:
        mbs.Assemble()
    scene = Studio(SC).scene()
    if scene.instances or scene.spheres or scene.lines:
        zoom = 0.7 if is_item and add_symbols(SC, scene, item) else 0.95
        fill_picture(SC, zoom)
        mbs.Draw(f"{folder}/{item}.png", windowSize=SIZE, zoom=zoom)
"""


def draw(folder: str, examples: dict[str, str]) -> set[str]:
    """Draw examples into a folder of the generated pages; return the names of those that have anything to be seen."""
    path = GENERATED / folder
    path.mkdir(parents=True, exist_ok=True)
    core = Path(find_spec("dalembert._core").origin)
    state = json.dumps([core.stat().st_mtime_ns, examples])
    done = path / "done.txt"
    if not done.exists() or done.read_text("utf-8") != state:
        for old in path.glob("*.png"):
            old.unlink()
        text = json.dumps([str(path), examples])
        subprocess.run(
            [sys.executable, "-c", DRAWING], input=text, text=True, check=True, stdout=subprocess.DEVNULL, cwd=path
        )
        for left in path.glob("coordinatesSolution*"):
            left.unlink()
        done.write_text(state, "utf-8")
    return {file.stem for file in path.glob("*.png")}


def draw_pages() -> None:
    """Draw the models of written pages: `.. image:: /_generated/PAGE/NAME.png` shows the code of the page above it."""
    for page in sorted((ROOT / "docs").glob("*.rst")):
        parts = re.split(rf"^\.\. image:: /_generated/{page.stem}/(\w+)\.png$", page.read_text("utf-8"), flags=re.M)
        above, examples = "", {}
        for text, name in zip(parts[::2], parts[1::2], strict=False):
            above += "\n".join(textwrap.dedent(code) for code in CODE.findall(text))
            examples[name] = above
        if examples:
            draw(page.stem, examples)


def figure(folder: str, file: str, words: str) -> str:
    place = f".. figure:: /_generated/{folder}/{file}\n   :width: 50%\n   :align: right\n"
    return f"{place}   :alt: {Path(file).stem}\n\n   {words}\n\n"


def with_pictures(pages: dict[str, str]) -> dict[str, str]:
    """Put a figure below the summary of each item: its annotated drawing, or else the picture of its mini example.

    The picture of an item with a drawing is next to the example. Pictures require the compiled package.
    """
    items = [item for item in load(ROOT).items if item.ready and item.example is not None]
    pictures, examples = "reference/items/pictures", {item.name: item.example.code for item in items}
    drawn = draw(pictures, examples) if find_spec("dalembert") is not None else set()
    draw_items()
    for item in items:
        path = f"reference/items/{item.stem}.rst"
        place = ":Kind: "
        if item.name in DRAWINGS:
            sketch = figure("reference/items/drawings", f"{item.name}.svg", "Symbols of the equations below.")
            pages[path] = pages[path].replace(place, sketch + place, 1)
            place = "Before it, ``mbs`` is an empty system;"
        if item.name in drawn:
            picture = figure(pictures, f"{item.name}.png", "The model of the mini example.")
            pages[path] = pages[path].replace(place, picture + place, 1)
    return pages
