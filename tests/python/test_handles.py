"""Handles: parameters and outputs of items as attributes, texts for values, errors, pickles and copies."""

from __future__ import annotations

import ast
import copy
import pickle
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import dalembert as db
from dalembert import handles
from dalembert._item_table import ITEMS
from dalembert._model import words
from dalembert._model.handle import handle_class
from dalembert._tools.item_facts import facts_of

PACKAGE = Path(db.__file__).parent
GENERATED = Path(__file__).parents[2] / "generated/python/dalembert"
MASS, LENGTH, G = 2.0, 0.5, 9.81


@pytest.fixture
def model() -> Any:
    """A rod that is held by a hinge at its end, and a mass on a spring."""
    made = db.Model()
    inertia = db.rigidBodyUtilities.InertiaRodX(mass=MASS, length=LENGTH)
    arm = made.create_rigid_body(name="arm", reference_position=[LENGTH / 2, 0, 0], inertia=inertia, gravity=[0, -G, 0])
    made.create_revolute_joint(name="hinge", body_numbers=["ground", arm], position=[0, 0, 0], axis="z")
    made.create_mass_point(name="mass", reference_position=[0, 0, 1], physics_mass=3)
    made.create_spring_damper(name="spring", body_numbers=["ground", "mass"], reference_length=0.75, stiffness=400)
    return made


def test_parameters_are_read_and_written_by_both_names(model: Any) -> None:
    spring, system = model["spring"], model.system
    spring.stiffness = 500
    assert system.GetObjectParameter(int(spring), "stiffness") == spring.stiffness == 500
    spring.referenceLength = 0.6
    assert spring.reference_length == spring.parameters.reference_length == spring.parameters["referenceLength"] == 0.6
    arm = model["arm"]
    arm.mass = 4
    assert arm.physics_mass == arm.physicsMass == arm.mass == system.GetObjectParameter("arm", "physicsMass") == 4
    spring.parameters.force = 7
    assert system.GetObjectParameter(int(spring), "force") == 7


def test_references_are_handles(model: Any) -> None:
    arm, hinge = model["arm"], model["hinge"]
    assert isinstance(arm.node_number, handles.NodeRigidBodyEP)
    assert arm.nodes == [arm.node_number]
    assert arm.node_number.bodies == [arm]
    assert hinge.marker_numbers == tuple(hinge.markers)
    assert [marker.body_number.name for marker in hinge.markers] == ["ground", "arm"]
    assert set(map(int, arm.loads)) == {int(load) for marker in arm.markers for load in marker.loads}
    assert len(arm.loads) == 1
    sensor = model.create_sensor(arm, "position", name="place")
    assert arm.sensors == [sensor]


def test_handles_are_indices(model: Any) -> None:
    arm = model["arm"]
    index = db.ObjectIndex(int(arm))
    assert isinstance(arm, db.ObjectIndex)
    assert arm == index
    assert hash(arm) == hash(index)
    assert {index: "found"}[arm] == "found"
    assert model.system.GetObject(arm)["name"] == "arm"
    marker = model.system.AddMarker(db.MarkerBodyRigid(bodyNumber=arm))
    assert model.system.GetMarkerParameter(marker, "bodyNumber") == arm
    assert f"{arm}" == str(int(arm))


def test_outputs_of_bodies(model: Any) -> None:
    arm = model["arm"]
    assert arm.position == pytest.approx([LENGTH / 2, 0, 0], abs=1e-15)
    model.solve(end_time=0.3, step_size=1e-3)
    center, turned = arm.position, arm.rotation_matrix
    assert turned.shape == (3, 3)
    # The tip is twice as far from the hinge as the center, and the rod is orthogonal to the velocity of both.
    assert arm.position_at([LENGTH / 2, 0, 0]) == pytest.approx(2 * center, abs=1e-9)
    assert arm.position_at([LENGTH / 2, 0, 0]) == pytest.approx(center + turned @ [LENGTH / 2, 0, 0], abs=1e-14)
    assert arm.velocity_at([LENGTH / 2, 0, 0]) == pytest.approx(2 * arm.velocity, abs=1e-4)
    assert arm.velocity @ center == pytest.approx(0, abs=1e-5)  # constraints hold for positions, of second order here
    assert arm.position_at([0, 0, 0], configuration="initial") == pytest.approx([LENGTH / 2, 0, 0], abs=1e-15)
    assert arm.output("position", configuration="reference") == pytest.approx([LENGTH / 2, 0, 0], abs=1e-15)
    # Kinetic energy of a rod about its end, m l^2 / 6 omega^2, equals the work of its weight. Velocities fulfil the
    # constraints to second order in the step only.
    work = -MASS * G * center[1]
    assert arm.kinetic_energy == pytest.approx(MASS * LENGTH**2 / 6 * arm.angular_velocity[2] ** 2, rel=2e-5)
    assert arm.kinetic_energy == pytest.approx(work, rel=1e-4)  # the method is of second order
    assert model.time == pytest.approx(0.3, abs=1e-12)


def test_force_of_a_joint_has_global_axes_and_a_sign(model: Any) -> None:
    """A rod that swings down from rest presses on its hinge by weight and centripetal force."""
    hinge, arm = model["hinge"], model["arm"]
    model.solve(end_time=0.3, step_size=1e-4)
    acceleration = arm.acceleration
    on_arm = MASS * (acceleration - [0, -G, 0])
    assert hinge.force_on(arm) == pytest.approx(on_arm, abs=1e-4)
    assert hinge.force == pytest.approx(-on_arm, abs=1e-4)  # on the ground, which is the first body
    assert hinge.force_on(model.ground) == pytest.approx(hinge.force, abs=1e-12)
    assert hinge.torque_on(arm)[2] == pytest.approx(0, abs=1e-9)
    assert hinge.outputs.force == pytest.approx(hinge.force, abs=0)
    with pytest.raises(
        ValueError, match=r"hinge.*expected one of its two bodies or markers, received <MassPoint 'mass'"
    ):
        hinge.force_on(model["mass"])


def test_names_of_parameter_and_output_are_refused_if_they_are_ambiguous(model: Any) -> None:
    spring = model["spring"]
    expected = "'force' could be the parameter or the output: write parameters.force or outputs.force"
    with pytest.raises(AttributeError, match=expected):
        _ = spring.force
    with pytest.raises(AttributeError, match=expected):
        spring.force = 3
    assert spring.outputs.force[2] == pytest.approx(400 * 0.25, rel=1e-12)
    assert spring.parameters.force == 0
    assert "force" not in dir(spring)
    ambiguous = {item: set(facts_of(item).ambiguous) for item in ITEMS if facts_of(item).ambiguous}
    assert ambiguous == {
        "ObjectConnectorLinearSpringDamper": {"force"},
        "ObjectConnectorSpringDamper": {"force"},
        "ObjectConnectorTorsionalSpringDamper": {"torque"},
        "ObjectConnectorDistance": {"distance"},
    }


def test_errors_name_the_item_and_what_exists(model: Any) -> None:
    spring = model["spring"]
    with pytest.raises(AttributeError, match=r"ConnectorSpringDamper 'spring' \(object 4\).*'stifness'.*'stiffness'\?"):
        _ = spring.stifness
    with pytest.raises(AttributeError, match=r"'spring'.*'stifness'.*'stiffness'\?"):
        spring.stifness = 3
    with pytest.raises(AttributeError, match="'spring'.*no attribute 'color'; write visualization.color"):
        spring.color = "red"
    with pytest.raises(AttributeError, match=r"'spring'.*'foo'\. It has active_connector, damping"):
        _ = spring.foo
    with pytest.raises(ValueError, match=r"'spring'.*'stiffness': received -1"):
        spring.stiffness = -1
    with pytest.raises(AttributeError, match=r"'spring'.*'distance' cannot be set"):
        spring.distance = 3
    with pytest.raises(AttributeError, match=r"'spring'.*'nodes' cannot be set"):
        spring.nodes = []
    with pytest.raises(KeyError, match=r"'spring'.*has no parameter 'damp'.*'damping'\?"):
        spring.parameters["damp"]
    with pytest.raises(AttributeError, match=r"'spring'.*output 'distance' cannot be set"):
        spring.outputs.distance = 3
    with pytest.raises(AttributeError, match=r"'spring'.*has no visualization parameter 'colour'.*'color'\?"):
        spring.visualization.colour = "red"
    with pytest.raises(
        ValueError, match=r"'spring'.*has no output 'positon'\. It has distance, displacement, velocity"
    ):
        spring.output("positon")
    with pytest.raises(TypeError, match=r"'spring'.*only outputs of bodies have a local_position"):
        spring.output("distance", local_position=[0, 0, 0])


def test_entries_of_arrays_cannot_be_changed_without_effect(model: Any) -> None:
    with pytest.raises(ValueError, match="read-only"):
        model["arm"].physics_inertia[0] = 3
    assert isinstance(model["hinge"].marker_numbers, tuple)


def test_completion_shows_the_item_and_nothing_else(model: Any) -> None:
    assert dir(model["spring"]) == [
        "active_connector", "damping", "displacement", "distance", "force_local", "force_on", "hide", "loads", "marker_numbers",
        "markers", "name", "nodes", "output", "outputs", "parameters", "potential_energy", "reference_length",
        "sensors", "show", "spring_force_user_function", "stiffness", "torque_on", "type", "velocity", "velocity_offset",
        "visualization",
    ]  # fmt: skip
    assert dir(model["spring"].visualization) == ["color", "draw_size", "show"]


def test_drawing(model: Any) -> None:
    spring = model["spring"]
    spring.visualization.color = "#ff0000"
    assert spring.visualization.color == pytest.approx([1, 0, 0, 1], abs=0)
    spring.hide()
    assert model.system.GetObjectParameter(int(spring), "Vshow") is False
    spring.show()
    assert spring.visualization.show is True


def test_texts(model: Any) -> None:
    arm = model["arm"]
    assert repr(arm) == str(arm) == "<RigidBody 'arm' (object 1)>"
    assert arm.type == "RigidBody"
    page = arm._repr_html_()
    assert "<td>physics_mass</td><td>2.0</td><td>kg</td>" in page
    assert "<td>position</td>" not in page  # the system is not assembled
    model.assemble()
    assert "<td>position</td><td>[0.25 0.   0.  ]</td><td>m</td>" in arm._repr_html_()


def test_pickles_and_copies_keep_model_and_handles_together(model: Any) -> None:
    arm = model["arm"]
    for other, its_arm in (pickle.loads(pickle.dumps((model, arm))), copy.deepcopy((model, arm))):
        assert its_arm == arm
        assert its_arm in other
        assert its_arm not in model
        its_arm.mass = 9
        assert other["arm"].mass == 9
        assert arm.mass == MASS
    assert copy.copy(arm) in model
    alone = pickle.loads(pickle.dumps(arm))
    assert alone.mass == MASS
    assert type(alone) is handles.ObjectRigidBody


def test_handles_keep_their_system() -> None:
    def body() -> Any:
        return db.Model().create_mass_point(name="alone", reference_position=[1, 2, 3], mass=1)

    assert body().position == pytest.approx([1, 2, 3], abs=0)


def test_handles_of_deleted_and_moved_items_are_refused(model: Any) -> None:
    spring, hinge, arm = model["spring"], model["hinge"], model["arm"]
    model.delete(hinge)
    assert arm.mass == MASS
    with pytest.raises(ReferenceError, match=r"object 4 is not 'spring' any more; model\['spring'\] returns its new"):
        _ = spring.stiffness
    assert model["spring"].stiffness == 400
    with pytest.raises(ReferenceError, match="'hinge' any more; it was deleted"):
        _ = hinge.active_connector


def test_renamed_items_keep_their_handles(model: Any) -> None:
    arm, same = model["arm"], model["arm"]
    arm.name = "rod"
    assert arm.name == same.name == "rod"
    assert model["rod"] == arm
    model.system.SetObjectParameter(int(arm), "name", "bar")
    assert arm.mass == MASS
    assert repr(arm) == "<RigidBody 'bar' (object 1)>"


def test_texts_for_values() -> None:
    assert words.color("red", "") == [1, 0, 0, 1]
    assert words.color("#1f77b4", "") == pytest.approx([31 / 255, 119 / 255, 180 / 255, 1])
    assert words.color("#f00", "") == [1, 0, 0, 1]
    assert words.color("#00ff0080", "") == pytest.approx([0, 1, 0, 128 / 255])
    assert words.axis("-y", "") == [0, -1, 0]
    assert words.axis("z", "") == [0, 0, 1]
    kinds = db.OutputVariableType
    for text in ("Position", "position", "POSITION"):
        assert words.member(kinds, text, "") is kinds.Position
    assert words.member(kinds, "angular_velocity_local", "") is kinds.AngularVelocityLocal
    with pytest.raises(ValueError, match=r"here: received 'w', but expected 'x', 'y', 'z'"):
        words.axis("w", "here")
    with pytest.raises(ValueError, match=r"here: received 'rad'.*'#rrggbb'"):
        words.color("rad", "here")
    with pytest.raises(ValueError, match=r"here: received '#12345'"):
        words.color("#12345", "here")
    with pytest.raises(ValueError, match=r"here: received 'Positon'\. Did you mean 'Position'\? Expected one of"):
        words.member(kinds, "Positon", "here")


def test_sensors(model: Any) -> None:
    sensor = model.create_sensor("mass", "position", name="place", local_position=[0, 0, 0])
    with pytest.raises(ValueError, match=r"'place'.*has no values yet: call model.solve"):
        _ = sensor.values
    model.solve(end_time=0.1, step_size=1e-3)
    # 0.25 m of elongation at the start; omega^2 = 400 / 3.
    expected = 0.75 + 0.25 * np.cos(np.sqrt(400 / 3) * sensor.time)
    assert sensor.values[:, 2] == pytest.approx(expected, abs=1e-5)  # second order, omega h = 0.012
    assert sensor.value == pytest.approx(sensor.values[-1], abs=0)
    assert sensor.unit == "m"
    ax = sensor.plot()
    assert [line.get_label() for line in ax.lines] == ["place X", "place Y", "place Z"]
    assert ax.get_ylabel() == "Position (m)"
    quiet = model.add(db.SensorBody("quiet", model["mass"], outputVariableType=db.OutputVariableType.Position))
    with pytest.raises(ValueError, match=r"'quiet'.*stores no values: set its store_internal = True"):
        _ = quiet.values


def test_loads(model: Any) -> None:
    force = model.create_force(name="push", body_number="mass", load_vector=[1, 2, 3])
    assert force.value == pytest.approx([1, 2, 3], abs=0)
    assert model["push"] == force
    assert [load.name for load in model["mass"].loads] == ["push"]


def _stub() -> dict[str, set[str]]:
    file = next(path for path in (PACKAGE, GENERATED) if (path / "_item_handles.pyi").exists()) / "_item_handles.pyi"
    classes = [node for node in ast.parse(file.read_text("utf-8")).body if isinstance(node, ast.ClassDef)]
    return {node.name: {each.name for each in node.body if isinstance(each, ast.FunctionDef)} for node in classes}


def test_the_stub_has_the_same_members() -> None:
    stub = _stub()
    assert set(stub) == set(ITEMS)
    for item, names in stub.items():
        members = {name for name in vars(handle_class(item)) if not name.startswith("_")}
        assert names == members, item


def test_classes_are_found_by_name() -> None:
    assert handles.ObjectMassPoint is handle_class("ObjectMassPoint")
    assert "ObjectMassPoint" in dir(handles)
    assert issubclass(handles.ObjectMassPoint, handles.ObjectHandle)
    with pytest.raises(AttributeError, match=r"no attribute 'ObjectMassPiont'\. Did you mean 'ObjectMassPoint'\?"):
        _ = handles.ObjectMassPiont
    with pytest.raises(TypeError, match="base class; model"):
        handles.ObjectHandle(None, 3)
