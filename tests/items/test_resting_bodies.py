"""Bodies on nodes without coordinates: no equations, outputs of a body at rest, and nothing that acts on them has an effect."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import dalembert as exu
from dalembert._core import testing
from dalembert.testing.outputs import CONFIGURATIONS
from dalembert.testing.repeated_solves import settings
from dalembert.testing.scenes import ITEMS, RESTING, RIGID, Carrier, Scene
from dalembert.testing.variants import Variant

each_resting = pytest.mark.parametrize("carrier", RESTING, ids="/".join)
LOCAL = np.array([0.3, -0.2, 0.5])


def scene_with(carrier: tuple[str, str]) -> tuple[Scene, Carrier, Carrier]:
    """A resting and a moving body, not joined."""
    scene = Variant(carrier[0]).build(seed=91)
    made = scene.carrier(*carrier), scene.carrier(*RIGID["NodePoint"])
    scene.mbs.Assemble()
    return scene, *made


@each_resting
def test_has_no_coordinates(carrier: tuple[str, str]) -> None:
    scene, resting, moving = scene_with(carrier)
    data = scene.mbs.systemData
    assert [list(data.GetObjectLTGODE2(c.body)) for c in (resting, moving)] == [[], [0, 1, 2]]
    for lists in (data.GetObjectLTGODE1, data.GetObjectLTGAE, data.GetObjectLTGData):
        assert len(lists(resting.body)) == 0
    assert len(testing.State(scene.mbs).q) == 3


@each_resting
def test_outputs_are_those_of_a_body_at_rest(carrier: tuple[str, str]) -> None:
    """Outputs in all configurations, before and after a simulation."""
    scene, resting, _ = scene_with(carrier)
    reference = scene.mbs.GetNode(resting.nodes[0])["referenceCoordinates"]
    wanted = {output.name: np.zeros(output.size) for output in ITEMS[carrier[0]].outputs}
    wanted |= {"Position": reference + LOCAL, "RotationMatrix": np.eye(3).ravel()}
    wanted["HomogeneousTransformation"] = exu.HT(translation=reference + LOCAL).HT44()
    for _ in range(2):
        for name, value in wanted.items():
            for configuration in CONFIGURATIONS:
                variable = getattr(exu.OutputVariableType, name)
                told = scene.mbs.GetObjectOutputBody(resting.body, variable, LOCAL, configuration)
                np.testing.assert_array_equal(told, value, err_msg=name)
        scene.mbs.SolveDynamic(settings())


@each_resting
@pytest.mark.parametrize("solver", [exu.DynamicSolverType.GeneralizedAlpha, exu.DynamicSolverType.RK44], ids=str)
def test_loads_on_it_have_no_effect(carrier: tuple[str, str], solver: Any) -> None:
    """Loads of all kinds that it takes; they do not affect the moving body."""
    ends = []
    for loaded in (False, True):
        scene, resting, moving = scene_with(carrier)
        mbs, before = scene.mbs, testing.residual(scene.mbs, scene.state())
        if loaded:
            at_point, at_mass = scene.marker("MarkerBodyPosition", resting), scene.marker("MarkerBodyMass", resting)
            mbs.AddLoad(exu.LoadForceVector(markerNumber=at_point, loadVector=[1, 2, 3]))
            mbs.AddLoad(exu.LoadMassProportional(markerNumber=at_mass, loadVector=[0, 0, -9.81]))
            mbs.Assemble()
            np.testing.assert_array_equal(testing.residual(mbs, scene.state()), before)
        mbs.SolveDynamic(settings(), solverType=solver)
        ends.append(mbs.GetObjectOutputBody(moving.body, exu.OutputVariableType.Position, [0, 0, 0]))
    np.testing.assert_array_equal(*ends)


@each_resting
def test_holds_a_spring_like_ground(carrier: tuple[str, str]) -> None:
    """A body at a spring to it moves as at a spring to ground in the same place."""
    ends = []
    for ground in (False, True):
        scene, resting, moving = scene_with(carrier)
        mbs, place = scene.mbs, scene.mbs.GetNode(resting.nodes[0])["referenceCoordinates"]
        fixed = mbs.AddObject(exu.ObjectGround(referencePosition=place)) if ground else resting.body
        markers = [mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=b)) for b in (fixed, moving.body)]
        mbs.AddObject(exu.ObjectConnectorSpringDamper(markerNumbers=markers, stiffness=1e6, damping=10))
        mbs.Assemble()
        mbs.SolveDynamic(settings())
        ends.append(mbs.GetObjectOutputBody(moving.body, exu.OutputVariableType.Position, [0, 0, 0]))
    np.testing.assert_array_equal(*ends)


@each_resting
def test_a_marker_between_bodies_takes_it_as_rest(carrier: tuple[str, str]) -> None:
    scene, resting, moving = scene_with(carrier)
    mbs = scene.mbs
    bodies = [resting.body, scene.carrier("ObjectRigidBody", "NodeRigidBodyEP").body]
    marker = mbs.AddMarker(exu.MarkerBodiesRelativeTranslationCoordinate(bodyNumbers=bodies, axis0=[1, 0, 0]))
    mbs.Assemble()
    origins = [mbs.GetObjectOutputBody(b, exu.OutputVariableType.Position, [0, 0, 0]) for b in bodies]
    axes = mbs.GetObjectOutputBody(bodies[0], exu.OutputVariableType.RotationMatrix, [0, 0, 0]).reshape(3, 3)
    measured = mbs.GetMarkerOutput(marker, exu.OutputVariableType.Coordinates)
    np.testing.assert_allclose(measured, axes[:, 0] @ (origins[1] - origins[0]), rtol=1e-12)


def test_the_mass_point_may_rest() -> None:
    """The list above is not empty by mistake."""
    assert ("ObjectMassPoint", "NodePointGround") in RESTING


@each_resting
def test_follows_its_node(carrier: tuple[str, str]) -> None:
    """A resting node that is put elsewhere takes the body, and markers on the body, with it at once."""
    scene, resting, _ = scene_with(carrier)
    mbs = scene.mbs
    marker = mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=resting.body, localPosition=LOCAL))
    mbs.Assemble()
    position = exu.OutputVariableType.Position
    for place in ([4.0, -5.0, 6.0], [1e-300, 0.0, 0.0]):
        mbs.SetNodeParameter(resting.nodes[0], "referenceCoordinates", place)
        assert mbs.GetObjectOutputBody(resting.body, position, LOCAL).tolist() == (place + LOCAL).tolist()
        assert mbs.GetMarkerOutput(marker, position).tolist() == (place + LOCAL).tolist()


def test_mesh_with_a_resting_node_follows_it(mbs: exu.MainSystem) -> None:
    """The mean of a moving and a resting mesh node moves by half of the displacement of the moving one."""
    nodes = [mbs.AddNode(exu.NodePoint(referenceCoordinates=[1, 0, 0])), mbs.AddNode(exu.NodePointGround())]
    mesh = mbs.AddObject(exu.ObjectGenericODE2(nodeNumbers=nodes, massMatrix=np.eye(3)))
    mean = exu.MarkerSuperElementPosition(bodyNumber=mesh, meshNodeNumbers=[0, 1], weightingFactors=[0.5, 0.5])
    marker = mbs.AddMarker(mean)
    mbs.Assemble()
    mbs.SetNodeParameter(nodes[1], "referenceCoordinates", [0, 2, -4])
    assert mbs.GetMarkerOutput(marker, exu.OutputVariableType.Position).tolist() == [0.5, 1, -2]
