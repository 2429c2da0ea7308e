"""Every output variable of every item: there in all configurations, of the size that its spec states."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import dalembert as exu
from codegen.model import Item, Output
from dalembert.testing.motions import tait_bryan
from dalembert.testing.scenes import ITEMS, RIGID, UNDER_TEST, Scene, carriers_of, is_ground, on_markers
from dalembert.testing.variants import ALL_VARIANTS, Variant, variants_with

Configuration = exu.ConfigurationType
CONFIGURATIONS = [Configuration.Current, Configuration.Initial, Configuration.Reference, Configuration.StartOfStep]
WITH_OUTPUTS = [(item, output) for item in UNDER_TEST for output in item.outputs]


def find(scene: Scene, item: Item) -> Any:
    """Number of an item of this type in the model."""
    data = scene.mbs.GetDictionary()[f"{item.kind}List"]
    return next(i for i, entry in enumerate(data) if entry[f"{item.kind}Type"] == item.type_name)


def scene_with(item: Item) -> Scene:
    if is_ground((item.name, "")):
        scene = Variant("ObjectMassPoint", (("", RIGID["NodeRigidBodyEP"]),)).build()
        scene.mbs.AddObject(exu.ObjectGround(referencePosition=[1, 2, 3]))
        scene.mbs.Assemble()
        return scene
    return variants_with(item)[0].build(seed=54)


def reader(scene: Scene, item: Item) -> Callable[..., Any]:
    number = find(scene, item)
    if item.kind == "node":
        return lambda variable, configuration: scene.mbs.GetNodeOutput(number, variable, configuration)
    if item.object_type in ("Body", "FiniteElement"):
        return lambda variable, configuration: scene.mbs.GetObjectOutputBody(
            number, variable, [0.1, 0.2, 0], configuration
        )
    return lambda variable, configuration: scene.mbs.GetObjectOutput(number, variable, configuration)


def coordinates(scene: Scene, item: Item) -> int:
    """How many values `Coordinates` have."""
    number, data = find(scene, item), scene.mbs.systemData
    if item.kind == "object":
        return len(data.GetObjectLTGODE2(number)) + len(data.GetObjectLTGODE1(number))
    row = next((r for r in item.parameters if r.name.startswith("numberOf")), None)
    if row:
        return int(scene.mbs.GetNode(number)[row.name])
    return 0 if "Ground" in item.provides else len(scene.mbs.GetNode(number)["referenceCoordinates"])


@pytest.mark.parametrize(("item", "output"), WITH_OUTPUTS, ids=[f"{i.name}.{o.name}" for i, o in WITH_OUTPUTS])
def test_size_in_every_configuration(item: Item, output: Output) -> None:
    scene = scene_with(item)
    read = reader(scene, item)
    sizes = set()
    for configuration in CONFIGURATIONS:
        value = read(getattr(exu.OutputVariableType, output.name), configuration)
        assert np.all(np.isfinite(value))
        sizes.add(np.size(value))
    assert len(sizes) == 1
    if output.size != "n":
        assert sizes == {output.size}
        assert isinstance(value, float) == (output.size == 1)
    elif output.name.startswith("Coordinates") and item.object_type != "Connector":
        assert sizes == {coordinates(scene, item)}
    else:
        assert min(sizes) > 0


def with_reference_coordinates(item: Item) -> bool:
    return "referenceCoordinates" in {row.name for row in item.parameters} and "Ground" not in item.provides


@pytest.mark.parametrize("item", list(filter(with_reference_coordinates, UNDER_TEST)), ids=lambda item: item.name)
def test_coordinates_of_the_reference_are_its_own(item: Item) -> None:
    """Other configurations are relative to the reference configuration."""
    scene = scene_with(item)
    read = reader(scene, item)
    reference = scene.mbs.GetNode(find(scene, item))["referenceCoordinates"]
    variable = exu.OutputVariableType
    np.testing.assert_array_equal(read(variable.Coordinates, Configuration.Reference), np.squeeze(reference))
    total = read(variable.CoordinatesTotal, Configuration.Current)
    np.testing.assert_allclose(total - reference, read(variable.Coordinates, Configuration.Current), rtol=0, atol=1e-15)


@pytest.mark.parametrize("item", [item for item in UNDER_TEST if item.outputs], ids=lambda item: item.name)
def test_missing_outputs_are_rejected(item: Item) -> None:
    scene = scene_with(item)
    missing = next(v for v in ("StressLocal", "SlidingCoordinate") if v not in [o.name for o in item.outputs])
    with pytest.raises(
        ValueError, match=rf"{item.kind} {find(scene, item)} '.*' \({item.name}\).*no output variable {missing}"
    ):
        reader(scene, item)(getattr(exu.OutputVariableType, missing), Configuration.Current)


@pytest.mark.parametrize("carrier", carriers_of(ITEMS["ObjectRigidBody"]), ids="/".join)
def test_outputs_of_rigid_bodies(carrier: tuple[str, str]) -> None:
    """Output at a local point, from the motion of which the model was made."""
    scene = Variant("ObjectRigidBody", (("", carrier), ("", carrier))).build(seed=52)
    scene.mbs.systemData.SetODE2Coordinates_tt(scene.state().a, Configuration.Current)
    local = np.array([0.3, -0.2, 0.5])
    for body, (_, _, m) in zip(scene.bodies, scene.nodes, strict=True):
        arm, omega, alpha = m.rotation @ local, m.angular_velocity, m.angular_acceleration
        wanted = {
            "Position": m.point(local),
            "Velocity": m.velocity + np.cross(omega, arm),
            "Acceleration": m.acceleration + np.cross(alpha, arm) + np.cross(omega, np.cross(omega, arm)),
            "RotationMatrix": m.rotation.ravel(),
            "Rotation": tait_bryan(m.rotation),
            "AngularVelocity": omega,
            "AngularAcceleration": alpha,
        }
        for name in ("Velocity", "Acceleration", "AngularVelocity", "AngularAcceleration"):
            wanted[f"{name}Local"] = m.rotation.T @ wanted[name]
        for name, value in wanted.items():
            told = scene.mbs.GetObjectOutputBody(body, getattr(exu.OutputVariableType, name), local)
            np.testing.assert_allclose(told, value, rtol=0, atol=1e-12 * max(1, np.abs(value).max()), err_msg=name)


@pytest.mark.parametrize("item", [item for item in UNDER_TEST if item.kind == "marker"], ids=lambda item: item.name)
def test_outputs_of_markers(item: Item) -> None:
    scene = next(v for v in ALL_VARIANTS if item.name in [m for m, _ in v.pairs]).build(seed=53)
    number = find(scene, item)
    names = [name for name in ("Position", "Orientation", "Coordinate") if name in item.provides]
    variables = {"Position": {"Position": 3, "Velocity": 3}, "Orientation": {"RotationMatrix": 9, "AngularVelocity": 3}}
    for name in names:
        for variable, size in variables.get(name, {}).items():
            assert np.size(scene.mbs.GetMarkerOutput(number, getattr(exu.OutputVariableType, variable))) == size
        if name == "Coordinate":
            values = [
                scene.mbs.GetMarkerOutput(number, getattr(exu.OutputVariableType, f"Coordinates{t}"))
                for t in ("", "_t")
            ]
            assert len(values[0]) == len(values[1]) > 0
    if not names:
        assert item.name in ("MarkerBodyMass", "MarkerBodyBeamShape")  # read by loads, by joints


def test_total_of_a_coordinate_that_a_marker_passes_on() -> None:
    """Reference plus displacement, as the node says it; the coordinate of a ground node rests at zero."""
    mbs = exu.SystemContainer().AddSystem()
    node = mbs.AddNode(exu.NodePoint(referenceCoordinates=[1, 2, 3], initialCoordinates=[0.25, 0.5, 0.75]))
    mbs.AddObject(exu.ObjectMassPoint(physicsMass=1, nodeNumber=node))
    marker = mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=node, coordinate=1))
    ground = mbs.AddNode(exu.NodePointGround(referenceCoordinates=[1, 2, 3]))
    rest = mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=ground, coordinate=0))
    total = exu.OutputVariableType.CoordinatesTotal
    sensor = mbs.AddSensor(exu.SensorMarker(markerNumber=marker, outputVariableType=total, storeInternal=True))
    mbs.Assemble()
    assert mbs.GetMarkerOutput(marker, total) == [2.5]
    assert mbs.GetMarkerOutput(marker, total, exu.ConfigurationType.Reference) == [2.0]
    assert mbs.GetMarkerOutput(rest, total) == [0.0]
    assert mbs.GetSensorValues(sensor) == 2.5


def test_every_ready_item_is_in_a_model() -> None:
    """Each output is tested by models: items, and each of their user functions."""
    sensors = {item.name for item in UNDER_TEST if item.kind == "sensor"}
    assert {item.name for item in UNDER_TEST if not variants_with(item)} == sensors | (
        {i.name for i in UNDER_TEST if is_ground((i.name, ""))} - {n for v in ALL_VARIANTS for n in v.uses}
    )
    with_functions = {v.item for v in ALL_VARIANTS if v.functions}
    called = {i.name for i in UNDER_TEST if any(r.type.function for r in i.parameters) and i.kind != "sensor"}
    assert called <= with_functions
    assert all(any(v.item == item.name for v in ALL_VARIANTS) for item in UNDER_TEST if on_markers(item))
    assert set(ITEMS) >= {v.item for v in ALL_VARIANTS}


def test_the_angle_of_planar_bodies_counts_from_the_reference_and_is_its_own_there() -> None:
    """The initial angle differs from the reference by 0.05 rad; both are given, so that nothing is rounded but their sum."""
    mbs = exu.SystemContainer().AddSystem()
    node = mbs.AddNode(
        exu.itemInterface.NodeRigidBody2D(referenceCoordinates=[1, 2, 0.3], initialCoordinates=[0.1, 0.2, 0.05])
    )
    body = mbs.AddObject(exu.itemInterface.ObjectRigidBody2D(nodeNumber=node, physicsMass=1, physicsInertia=1))
    mbs.Assemble()
    configurations = exu.ConfigurationType
    for configuration, angle in (
        (configurations.Reference, 0.3),
        (configurations.Initial, 0.05),
        (configurations.Current, 0.05),
    ):
        found = mbs.GetObjectOutputBody(body, exu.OutputVariableType.Rotation, [0, 0, 0], configuration)
        assert found == pytest.approx(angle, rel=0, abs=1e-16)


def test_angles_that_are_coordinates_count_full_turns() -> None:
    """Two seconds at 5 rad/s about an axis of symmetry; the rotation of the body agrees with its rotation matrix."""
    mbs = exu.SystemContainer().AddSystem()
    body = mbs.CreateRigidBody(
        inertia=exu.utilities.InertiaSphere(1, 1),
        initialAngularVelocity=[5, 0, 0],
        nodeType=exu.NodeType.RotationRxyz,
    )
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.endTime, settings.timeIntegration.numberOfSteps = 2, 100
    settings.solutionSettings.writeSolutionToFile = False
    mbs.SolveDynamic(settings)
    variable = exu.OutputVariableType.Rotation
    np.testing.assert_allclose(mbs.GetNodeOutput(0, variable), [10, 0, 0], rtol=0, atol=1e-12)
    np.testing.assert_allclose(mbs.GetObjectOutputBody(body, variable), [10 - 4 * np.pi, 0, 0], rtol=0, atol=1e-12)
