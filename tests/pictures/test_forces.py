"""Arrows of forces: their places, directions and lengths, and that nothing is computed for them unless they are shown."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from page_reader import Reader, settings

import dalembert as exu
from dalembert import graphics
from dalembert._live.viewer import Viewer
from dalembert._pictures.flow import Flow
from dalembert._pictures.forces import KIND, LONGEST, Forces
from dalembert._pictures.making import SceneMaker
from dalembert._pictures.scene import Scene

Shown = exu.ConfigurationType.Visualization
GRAVITY = 9.81


@pytest.fixture
def hanging(mbs: Any) -> Any:
    """A mass of 2 kg that hangs on a spring; it is pulled by 5 N, and turned by 3 Nm."""
    ground = mbs.CreateGround()
    mass = mbs.CreateRigidBody(
        name="mass", referencePosition=[1, 0, 0], gravity=[0, -GRAVITY, 0],
        inertia=exu.utilities.InertiaCuboid(2 / 0.008, [0.2, 0.2, 0.2]), graphicsDataList=[graphics.Brick(size=[0.2, 0.2, 0.2])],
    )  # fmt: skip
    mbs.CreateRigidBodySpringDamper(bodyNumbers=[ground, mass], stiffness=1e3 * np.eye(6), localPosition0=[1, 0, 0])
    mbs.CreateForce(bodyNumber=mass, loadVector=[5, 0, 0])
    mbs.CreateTorque(bodyNumber=mass, loadVector=[0, 0, 3])
    mbs.Assemble()
    return mbs


def maker_of(mbs: Any) -> SceneMaker:
    maker = SceneMaker(mbs, mbs.GetSystemContainer().visualizationSettings)
    maker.show_forces(True)
    return maker


def solved(mbs: Any) -> None:
    static = exu.SimulationSettings()
    static.staticSolver.verboseMode = 0
    mbs.SolveStatic(static)


def reach(scene: Scene, type_name: str) -> Any:
    """The point of an arrow that is farthest from its marker, relative to it."""
    scene = scene.unbound()
    number = next(n for n, i in enumerate(scene.items) if (i.kind, i.type_name) == (KIND, type_name))
    parts = [part for part in scene.instances if part.item == number]
    points = np.concatenate([part.mesh.points @ part.matrix.T + part.place for part in parts]) - parts[0].place
    return points[np.argmax(np.linalg.norm(points, axis=1))]


def test_lengths_are_in_proportion_to_forces(hanging: Any) -> None:
    """Equilibrium: the spring pulls by (-5, 19.62, 0) N and turns by -3 Nm; 20 N and 5 Nm have the full length."""
    solved(hanging)
    maker = maker_of(hanging)
    scene = maker.scene()
    length = LONGEST * maker.looks.size
    assert maker.forces is not None
    assert maker.forces.references.tolist() == [50.0, 5.0]
    assert maker.forces.words(maker.looks.size) == f"arrows: {length:.3g} m for 50 N or 5 Nm"
    np.testing.assert_allclose(reach(scene, "LoadForceVector"), [length * 5 / 50, 0, 0], atol=1e-9)
    actions = maker.forces._actions["Object", 2][0]
    np.testing.assert_allclose(actions.force, [-5, 2 * GRAVITY, 0], atol=1e-7)
    np.testing.assert_allclose(actions.torque, [0, 0, -3], atol=1e-7)
    types = {item.type_name for item in scene.items if item.kind == KIND}
    assert types == {"ObjectConnectorRigidBodySpringDamper", "LoadForceVector", "LoadTorqueVector"}  # no weight


def test_a_force_that_is_zero_at_first_appears_and_the_scale_follows_the_largest(hanging: Any) -> None:
    maker = maker_of(hanging)
    flow = Flow(maker)
    number = next(n for n, item in enumerate(flow.scene().items) if item.type_name.startswith("ObjectConnector"))
    assert maker.forces is not None and maker.forces.references.tolist() == [5.0, 5.0]
    assert not any(part.item == number for part in flow.scene().unbound().instances)
    solved(hanging)
    assert any(part.item == number for part in flow.scene().unbound().instances)
    assert maker.forces.references[0] == 50.0
    solved_with_less = hanging.systemData.GetODE2Coordinates(Shown) * 0.1
    hanging.systemData.SetODE2Coordinates(solved_with_less, Shown)
    flow.scene()
    assert maker.forces.references[0] == 50.0  # one scale for all times


def test_loads_are_drawn_once_and_those_of_unknown_value_as_before(hanging: Any) -> None:
    def pull(mbs: Any, t: float, load: Any) -> Any:
        raise AssertionError("not called for pictures")

    hanging.AddLoad(exu.LoadForceVector(markerNumber=1, loadVector=[0, 0, 7], loadVectorUserFunction=pull))
    hanging.Assemble()
    scene = maker_of(hanging).scene().unbound()
    drawn = {part.item for part in scene.instances}
    found = [(item.kind, item.number) for number, item in enumerate(scene.items) if number in drawn]
    forces = [number for kind, number in found if kind == KIND]
    loads = [number for kind, number in found if kind == "Load"]
    weight = next(n for n in range(4) if hanging.GetLoad(n)["loadType"] == "MassProportional")
    assert sorted(loads) == sorted([weight, 3]) and set(forces) == {0, 1, 2} - {weight}


def test_contact_forces_have_the_same_scale(mbs: Any) -> None:
    """A sphere that is pressed 1 mm into another by a contact of 1e4 N/m: 10 N."""
    contact = mbs.AddGeneralContact()
    contact.SetFrictionPairings(np.zeros((1, 1)))
    for x in (0.0, 0.199):
        node = mbs.AddNode(exu.NodePoint(referenceCoordinates=[x, 0, 0]))
        mbs.AddObject(exu.ObjectMassPoint(physicsMass=1, nodeNumber=node))
        marker = mbs.AddMarker(exu.MarkerNodePosition(nodeNumber=node))
        contact.AddSphereWithMarker(marker, radius=0.1, contactStiffness=2e4, contactDamping=0, frictionMaterialIndex=0)
    mbs.Assemble()
    maker = maker_of(mbs)
    maker.scene()
    assert maker.forces is not None
    (action,) = maker.forces._actions["GeneralContact", 0]
    assert np.linalg.norm(action.force) == pytest.approx(10, rel=1e-9)
    assert maker.forces.references.tolist() == [10.0, 0.0]


def test_nothing_has_a_force(mbs: Any) -> None:
    assert Forces().words(1.0) == "no forces"


def test_pages_show_them_on_request_and_nothing_is_computed_otherwise(swinging: Any, viewer: Viewer) -> None:
    def moves() -> bool:
        """Whether only places are computed for the next picture."""
        swinging.SolveDynamic(settings(10, 0.01))
        return viewer.studio is not None and viewer.studio.moving() is not None

    reader = Reader(viewer)
    head, _ = reader.message("scene")
    assert head["forces"] == "" and all(item[0] != KIND for item in head["items"])
    reader.until(moves)
    reader.send("forces")
    while not (head := reader.message("scene")[0])["forces"]:
        pass
    (shown,) = (item for item in head["items"] if item[0] == KIND)
    assert head["forces"].startswith("arrows: ")
    reader.send("select", item=head["items"].index(shown), scene=head["scene"], depth=1.0)
    assert reader.message("details")["title"] == "object 2"
    reader.send("select", item=-1, scene=head["scene"], depth=0.0)
    assert not moves()
    reader.send("forces")
    while (head := reader.message("scene")[0])["forces"]:
        pass
    reader.until(moves)
