"""Pictures for the pages of items: the model of the mini example, as it is after it has run.

They are made when pages are built, all in one process, and not again before examples or compiled package have changed.
"""

from __future__ import annotations

import json
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

from codegen.load import load
from codegen.model import Item

ROOT = Path(__file__).parents[2]
FOLDER = ROOT / "docs/_generated/reference/items/pictures"
# Run in a process of its own: a folder, then a name and an example per item, all by standard input.
DRAWING = """
import sys, json
import numpy as np
import dalembert as exu
from dalembert import itemInterface
from dalembert._pictures.studio import Studio

names = {name: value for name, value in vars(itemInterface).items() if not name.startswith("_")}
folder, examples = json.load(sys.stdin)


KINDS = ("Node", "Object", "Marker", "Load", "Sensor")


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
    for group in ("bodies", "connectors") if kind == "Object" else (f"{kind.lower()}s",):
        getattr(settings, group).showNumbers = True
    return is_single


for item, code in examples.items():
    SC = exu.SystemContainer()
    mbs = SC.AddSystem()
    exec(code, names | {"exu": exu, "np": np, "SC": SC, "mbs": mbs})
    show(mbs, item)
    scene = Studio(SC).scene()
    if scene.instances or scene.spheres or scene.lines:
        zoom = 0.7 if add_symbols(SC, scene, item) else 0.95
        mbs.Draw(f"{folder}/{item}.png", windowSize=[560, 380], zoom=zoom)
"""


def draw(items: list[Item]) -> set[str]:
    """Draw the examples of items; return the names of those that have anything to be seen."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    core = Path(find_spec("dalembert._core").origin)
    examples = {item.name: item.example.code for item in items}
    state = json.dumps([core.stat().st_mtime_ns, examples])
    done = FOLDER / "done.txt"
    if not done.exists() or done.read_text("utf-8") != state:
        for old in FOLDER.glob("*.png"):
            old.unlink()
        text = json.dumps([str(FOLDER), examples])
        subprocess.run(
            [sys.executable, "-c", DRAWING], input=text, text=True, check=True, stdout=subprocess.DEVNULL, cwd=FOLDER
        )
        for left in FOLDER.glob("coordinatesSolution*"):
            left.unlink()
        done.write_text(state, "utf-8")
    return {path.stem for path in FOLDER.glob("*.png")}


def with_pictures(pages: dict[str, str]) -> dict[str, str]:
    """Put the picture of each item below the summary on its page; without the compiled package there are none."""
    if find_spec("dalembert") is None:
        return pages
    items = [item for item in load(ROOT).items if item.ready and item.example is not None]
    drawn = draw(items)
    for item in items:
        path = f"reference/items/{item.stem}.rst"
        if item.name in drawn and path in pages:
            figure = (
                f".. figure:: /_generated/reference/items/pictures/{item.name}.png\n   :width: 50%\n   :align: right\n"
            )
            words = f"   :alt: {item.name}\n\n   The model of the example below.\n\n"
            pages[path] = pages[path].replace(":Kind: ", f"{figure}{words}:Kind: ", 1)
    return pages
