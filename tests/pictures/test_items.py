"""Every item with a visualization is drawn, or is on the list of items without position; and not when it is not to be
shown."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import dalembert as exu
import dalembert.itemInterface as items
from codegen.load import load
from codegen.scene import DRAWINGS
from dalembert._pictures import connectors, flexible
from dalembert._pictures.making import RIGID, WITHOUT_PLACE
from dalembert._pictures.scene import Scene
from dalembert._pictures.studio import Studio

SPECS = [item for item in load(Path(__file__).parents[2]).items if item.visualization]
READY = [item for item in SPECS if item.ready]
KINDS = ("Node", "Object", "Marker", "Load", "Sensor")
# Items of the examples that are drawn, but not there: why.
BARE = {
    "ObjectGround": "it has no graphics data in its example",
}


def run(item: Any) -> tuple[Any, Any]:
    """Run the mini example of an item; return container and system."""
    SC = exu.SystemContainer()
    names = {name: value for name, value in vars(items).items() if not name.startswith("_")}
    mbs = SC.AddSystem()
    exec(compile(item.example.code, item.path, "exec"), names | {"exu": exu, "np": np, "SC": SC, "mbs": mbs})
    return SC, mbs


def of_type(mbs: Any, name: str) -> list[tuple[str, int]]:
    kind = next(kind for kind in KINDS if name.startswith(kind))
    numbers = range(getattr(mbs.systemData, f"NumberOf{kind}s")())
    return [
        (kind, n) for n in numbers if getattr(mbs, f"Get{kind}")(n)[f"{kind.lower()}Type"] == name.removeprefix(kind)
    ]


def drawn(scene: Scene) -> set[tuple[str, int]]:
    """Kind and number of the items that have left anything in a scene."""
    numbers = (
        {part.item for part in scene.instances} | {s[3] for s in scene.spheres} | {line[3] for line in scene.lines}
    )
    return {(scene.items[n].kind, scene.items[n].number) for n in numbers}


def show(mbs: Any, found: list[tuple[str, int]], flag: bool) -> None:
    for kind, number in found:
        getattr(mbs, f"Set{kind}Parameter")(number, "Vshow", flag)


@pytest.mark.parametrize("item", READY, ids=lambda item: item.name)
def test_an_item_is_drawn_where_it_is_shown(item: Any) -> None:
    SC, mbs = run(item)
    found = of_type(mbs, item.name)
    assert found
    show(mbs, found, True)
    seen = drawn(Studio(SC).scene())
    if item.name in WITHOUT_PLACE or item.name in BARE:
        assert not seen & set(found)
    else:
        assert seen & set(found)
        assert Studio(SC).picture().shape == (768, 1024, 3)
    show(mbs, found, False)
    assert not drawn(Studio(SC).scene()) & set(found)


def test_every_type_has_a_drawing() -> None:
    """Also those that are planned: nobody forgets them when they come."""
    known = {*connectors.DRAWINGS, *flexible.DRAWINGS, *flexible.MESH_BODIES, *RIGID, "Ground", "KinematicTree"}
    objects = {item.name.removeprefix("Object") for item in SPECS if item.name.startswith("Object")}
    without = {name.removeprefix("Object") for name in WITHOUT_PLACE}
    assert objects - without == known


def test_lists_name_items_only() -> None:
    names = {item.name for item in SPECS}
    assert names >= {*WITHOUT_PLACE, *BARE}


SYMBOLS = {
    "spring": lambda own: len(own.instances) >= 1,
    "rod": lambda own: len(own.instances) == 1,
    "line": lambda own: [len(points) for points, *_ in own.lines] == [2],
    "spheres": lambda own: np.allclose([center for center, *_ in own.spheres], [[0, 0, 0], [1, 2, 3]]),
    "boxes": lambda own: np.allclose([box.place for box in own.instances], [[0, 0, 0], [1, 2, 3]]),
    "frames": lambda own: len(own.instances) == 2 * 3 * 2,  # three arrows of shaft and head at each marker
}


@pytest.mark.parametrize("name", connectors.NAMED)
def test_symbols_that_specs_of_packages_name(SC: Any, mbs: Any, name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Drawn between or at the markers, and nothing else."""
    assert connectors.NAMED.keys() == SYMBOLS.keys() == set(DRAWINGS)
    ground = mbs.CreateGround()
    mass = mbs.CreateMassPoint(referencePosition=[1, 2, 3], physicsMass=1)
    number = mbs.CreateSpringDamper(bodyNumbers=[ground, mass], stiffness=1)
    mbs.Assemble()
    monkeypatch.setitem(connectors.DRAWINGS, "ConnectorSpringDamper", connectors.NAMED[name])
    connectors.drawing.cache_clear()
    scene = Studio(SC).scene()
    connectors.drawing.cache_clear()
    mine = [i for i, item in enumerate(scene.items) if (item.kind, item.number) == ("Object", int(number))]
    own = SimpleNamespace(
        instances=[part for part in scene.instances if part.item in mine],
        spheres=[sphere for sphere in scene.spheres if sphere[3] in mine],
        lines=[line for line in scene.lines if line[3] in mine],
    )
    assert SYMBOLS[name](own), own


def test_an_item_is_drawn_before_the_system_is_assembled(SC: Any, mbs: Any) -> None:
    ground = mbs.CreateGround()
    mass = mbs.CreateMassPoint(referencePosition=[1, 2, 3], physicsMass=1)
    mbs.CreateSpringDamper(bodyNumbers=[ground, mass], stiffness=1)
    scene = Studio(SC).scene()
    assert {("Object", 2), ("Node", 0)} <= drawn(scene)
    centers = [center for center, *_ in scene.spheres]
    assert any(np.allclose(center, [1, 2, 3]) for center in centers)
    assert scene.time == 0


def test_markers_on_connectors_do_not_lead_in_circles(SC: Any, mbs: Any) -> None:
    """Assemble refuses them; until then the rest is drawn."""
    mbs.CreateMassPoint(physicsMass=1)
    first, second = (mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=number)) for number in (1, 2))
    for _ in range(2):
        mbs.AddObject(exu.ObjectConnectorSpringDamper(markerNumbers=[first, second], stiffness=1))
    seen = drawn(Studio(SC).scene())
    assert ("Node", 0) in seen
    assert not {("Object", 1), ("Object", 2)} & seen
    with pytest.raises(Exception, match="marker"):
        mbs.Assemble()
