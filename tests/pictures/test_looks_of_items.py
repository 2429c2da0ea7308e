"""No row of visualization is accepted and ignored: a change of each is seen in the picture of a system in which only such items are shown."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from test_items import BARE, READY, of_type, run
from test_meshes_in_frames import add_mesh_in_a_frame

import dalembert as exu
from codegen.model import Item, Parameter
from dalembert import graphics
from dalembert._pictures.making import WITHOUT_PLACE
from dalembert._pictures.painting import Image
from dalembert._pictures.studio import Studio
from dalembert.utilities import RotationMatrixX, RotationMatrixY

KINDS = ("Node", "Object", "Marker", "Load", "Sensor")
SHAPES = [graphics.Brick(size=[0.3, 0.4, 0.5])]
SECTION = exu.BeamSectionGeometry()
SECTION.polygonalPoints = [[0.1, 0], [0, 0.2], [-0.1, 0]]
# Parameters that are no flag, length or color.
OTHER: dict[str, Any] = {
    "graphicsData": SHAPES,
    "graphicsDataList": [SHAPES],
    "graphicsDataUserFunction": lambda mbs, number: SHAPES,
    "sectionGeometry": SECTION,
    "triangleMesh": [[0, 1, 3], [1, 2, 3]],
}
ROWS = [(item, row) for item in READY for row in item.visualization]


def mesh_without_frame(mbs: Any) -> None:
    """Add an ObjectGenericODE2 with nodes that have places."""
    nodes = [mbs.AddNode(exu.NodePoint(referenceCoordinates=np.eye(4, 3)[i])) for i in range(4)]
    unit = exu.MatrixContainer()
    unit.SetWithDenseMatrix(np.eye(12))
    looks = {"triangleMesh": [[0, 1, 2]]}
    mbs.AddObject(exu.ObjectGenericODE2(nodeNumbers=nodes, massMatrix=unit, stiffnessMatrix=unit, visualization=looks))


# Examples without all parts of their rows.
MODELS: dict[str, Any] = {"ObjectGenericODE2": mesh_without_frame, "ObjectFFRF": add_mesh_in_a_frame}


def system_with(item: Item) -> tuple[Any, Any]:
    """Return container and system of a model with an item."""
    if item.name not in MODELS:
        return run(item)
    SC = exu.SystemContainer()
    mbs = SC.AddSystem()
    MODELS[item.name](mbs)
    mbs.Assemble()
    return SC, mbs


def set_row(mbs: Any, found: list[tuple[str, int]], name: str, value: Any) -> None:
    for kind, number in found:
        getattr(mbs, f"Set{kind}Parameter")(number, f"V{name}", value)


def other(row: Parameter, value: Any) -> Any:
    """Another value of a row."""
    if row.name in OTHER:
        return OTHER[row.name]
    match row.type.storage:
        case "boolean":
            return not value
        case "real":
            return 1.7 * value + 0.1 if value > 0 else 0.3
    return [0.9, 0.1, 0.2, 1.0]


@pytest.mark.parametrize("item", READY, ids=lambda item: item.name)
def test_rows_of_visualization_act(item: Item) -> None:
    SC, mbs = system_with(item)
    found = of_type(mbs, item.name)
    for kind in KINDS:
        everything = [(kind, n) for n in range(getattr(mbs.systemData, f"NumberOf{kind}s")())]
        set_row(mbs, everything, "show", False)
    set_row(mbs, found, "show", True)
    settings = SC.visualizationSettings
    settings.view0.window.renderWindowSize = [320, 240]
    settings.openGL.advanced.initialModelRotation = RotationMatrixX(0.5) @ RotationMatrixY(0.6)
    first = Studio(SC)
    camera = first.camera(first.scene())

    def picture() -> Image:
        return Studio(SC).image(Studio(SC).scene(), camera)

    before = picture()
    for row in item.visualization:
        kind, number = found[0]
        value = getattr(mbs, f"Get{kind}Parameter")(number, f"V{row.name}")
        set_row(mbs, found, row.name, other(row, value))
        is_seen = not np.array_equal(picture(), before)
        set_row(mbs, found, row.name, value)
        assert is_seen is not (row.name == "show" and item.name in {*WITHOUT_PLACE, *BARE}), row.name
