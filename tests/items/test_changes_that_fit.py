"""Changed parameters of an assembled system have to fit nodes and markers as at Assemble(); else nothing changes."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from codegen.model import Item
from dalembert._core import testing
from dalembert.testing.outputs import find
from dalembert.testing.refused_changes import accessors, assert_unchanged, snapshot
from dalembert.testing.scenes import ITEMS, Scene
from dalembert.testing.variants import variants_with

VECTOR = "ObjectConnectorCoordinateVector"
DO_NOT_FIT: list[tuple[str, str, Any]] = [
    ("ObjectGenericODE1", "rhsVector", [1.0]),
    ("ObjectGenericODE1", "systemMatrix", [[1.0]]),
    ("ObjectGenericODE2", "forceVector", [1.0, 2.0]),
    ("ObjectGenericODE2", "massMatrix", np.eye(2)),
    (VECTOR, "scalingMarker0", np.ones((2, 1))),
    (VECTOR, "quadraticTermMarker1", np.ones((2, 5))),
    (VECTOR, "offset", [1.0]),
    ("ObjectConnectorReevingSystemSprings", "sheavesRadii", [0.1]),
    ("ObjectConnectorReevingSystemSprings", "sheavesAxes", [[1.0, 0.0, 0.0]]),
    ("MarkerSuperElementPosition", "weightingFactors", [1.0]),
    ("MarkerSuperElementRigid", "weightingFactors", [0.5, 0.5]),
    ("MarkerBodiesRelativeTranslationCoordinate", "axis0", [2.0, 0.0, 0.0]),
]
STRUCTURAL: list[tuple[str, str, Any]] = [
    ("MarkerNodeCoordinate", "coordinate", 1000),
    ("MarkerNodeODE1Coordinate", "coordinate", 1000),
    ("MarkerSuperElementPosition", "meshNodeNumbers", [0]),
    ("MarkerSuperElementRigid", "meshNodeNumbers", [0, 1, 2]),
    ("NodeGenericODE1", "numberOfODE1Coordinates", 1000),
    ("NodeGenericODE2", "numberOfODE2Coordinates", 1000),
    ("NodeGenericData", "numberOfDataCoordinates", 1000),
    ("NodeRigidBodyEP", "addConstraintEquation", False),
]


def model(name: str) -> tuple[Scene, int, Item]:
    item = ITEMS[name]
    scene = next(v for v in variants_with(item) if not v.functions).build(seed=72)
    return scene, find(scene, item), item


def residual(scene: Scene) -> np.ndarray:
    return testing.residual(scene.mbs, scene.state())


@pytest.mark.parametrize(("name", "parameter", "value"), DO_NOT_FIT, ids=lambda x: x if isinstance(x, str) else "")
def test_values_that_do_not_fit_are_refused(name: str, parameter: str, value: Any) -> None:
    scene, number, item = model(name)
    before, at_first = snapshot(scene), residual(scene)
    with pytest.raises((ValueError, RuntimeError), match=rf"{item.kind} {number} .*{name}"):
        accessors(scene, item)[1](number, parameter, value)
    assert_unchanged(scene, before)
    np.testing.assert_array_equal(residual(scene), at_first)


@pytest.mark.parametrize(("name", "parameter", "value"), STRUCTURAL, ids=lambda x: x if isinstance(x, str) else "")
def test_changes_of_coordinates_need_assemble(name: str, parameter: str, value: Any) -> None:
    scene, number, item = model(name)
    accessors(scene, item)[1](number, parameter, value)
    assert not scene.mbs.systemIsConsistent
    with pytest.raises(RuntimeError, match=r"Call mbs\.Assemble\(\)"):
        scene.mbs.systemData.GetODE2Coordinates()


def test_matrices_with_entries_at_other_places_are_refused() -> None:
    """The pattern of the system matrix stays; they are taken with the next Assemble()."""
    scene, number, _ = model("ObjectGenericODE2")
    n = len(scene.mbs.systemData.GetObjectLTGODE2(number))
    before, at_first = snapshot(scene), residual(scene)
    import scipy.sparse as sp

    sparse = sp.csr_matrix(np.diag(np.arange(1.0, n + 1)))
    with pytest.raises(RuntimeError, match=r"entries at other places.*ModifyObject.*Assemble"):
        scene.mbs.SetObjectParameter(number, "massMatrix", sparse)
    assert_unchanged(scene, before)
    np.testing.assert_array_equal(residual(scene), at_first)
    scene.mbs.ModifyObject(number, {"massMatrix": sparse})
    scene.mbs.Assemble()
    assert not np.array_equal(residual(scene), at_first)
