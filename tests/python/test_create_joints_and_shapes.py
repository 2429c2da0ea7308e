"""Fixed, cylindrical and universal joints, planar joints, and bodies in the shape of boxes, cylinders and spheres."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import dalembert as exu
from dalembert.rigidBodyUtilities import RotationMatrixX, RotationMatrixY, RotationMatrixZ
from dalembert.utilities import InertiaCuboid

Variable = exu.OutputVariableType


def solve(mbs: Any, end: float, steps: int) -> None:
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.solutionSettings.writeSolutionToFile = False
    settings.timeIntegration.endTime, settings.timeIntegration.numberOfSteps = end, steps
    assert mbs.SolveDynamic(settings)


def output(mbs: Any, body: Any, variable: Any, at: Any = (0.0, 0.0, 0.0)) -> Any:
    return np.asarray(mbs.GetObjectOutputBody(body, variable, at))


@pytest.fixture
def mbs() -> Any:
    return exu.SystemContainer().AddSystem()


# ---- shapes ----------------------------------------------------------------------------------------------------------
def test_inertia_of_shapes(mbs: Any) -> None:
    """Formulas of textbooks: m/12 (b^2 + c^2), m/2 (R^2 + r^2), 2/5 m R^2."""
    box = mbs.CreateBox(size=[1, 2, 3], density=10)
    tube = mbs.CreateCylinder(radius=0.4, innerRadius=0.3, length=2, axis=[0, 1, 0], mass=5)
    ball = mbs.CreateSphere(radius=0.2, mass=3)
    assert mbs.GetObjectParameter(box, "physicsMass") == pytest.approx(60, rel=1e-15)
    expected = {
        box: [60 / 12 * 13, 60 / 12 * 10, 60 / 12 * 5],
        tube: [5 / 12 * (3 * 0.25 + 4), 5 / 2 * 0.25, 5 / 12 * (3 * 0.25 + 4)],
        ball: [2 / 5 * 3 * 0.04] * 3,
    }
    for body, inertia in expected.items():
        assert mbs.GetObjectParameter(body, "physicsInertia")[:3] == pytest.approx(inertia, rel=1e-14)


def test_shapes_are_drawn(mbs: Any) -> None:
    for name, arguments, size in (
        ("CreateBox", {"size": [1, 2, 3], "mass": 1, "color": [1, 0, 0, 1]}, [1, 2, 3]),
        ("CreateCylinder", {"radius": 0.5, "length": 3, "axis": [1, 0, 0], "mass": 1}, [3, 1, 1]),
        ("CreateSphere", {"radius": 2, "mass": 1}, [4, 4, 4]),
    ):
        body = getattr(mbs, name)(**arguments)
        points = np.reshape(mbs.GetObject(body, True)["VgraphicsData"][0]["points"], (-1, 3))
        np.testing.assert_allclose(np.ptp(points, axis=0), size, rtol=0.02)  # round shapes consist of triangles


def test_neighbours_have_different_colors_unless_they_are_given(mbs: Any) -> None:
    def color(**arguments: Any) -> tuple[float, ...]:
        body = mbs.CreateSphere(radius=1, mass=1, **arguments)
        return tuple(np.round(np.reshape(mbs.GetObject(body, True)["VgraphicsData"][0]["colors"], (-1, 4))[0], 6))

    assert len({color() for _ in range(8)}) == 8
    assert color(color=[1, 0, 0, 1]) == (1, 0, 0, 1)


def test_planar_shapes(mbs: Any) -> None:
    mbs.CreateBox(size=[1, 2, 3], density=10, create2D=True)
    assert mbs.GetObject(0)["objectType"] == "RigidBody2D"
    assert mbs.GetObjectParameter(0, "physicsInertia") == pytest.approx(60 / 12 * 5, rel=1e-15)


@pytest.mark.parametrize(
    ("name", "arguments", "text"),
    [
        ("CreateBox", {"size": [1, 1, 1]}, "argument 'density': expected density or mass, one of them"),
        ("CreateBox", {"size": [1, 1, 1], "density": 1, "mass": 1}, "density or mass, one of them"),
        ("CreateBox", {"size": [1, 0, 1], "density": 1}, "argument 'size'.*greater than zero"),
        ("CreateBox", {"size": [1, 1], "density": 1}, "argument 'size'.*3 finite components"),
        ("CreateCylinder", {"axis": [1, 1, 0], "density": 1}, "argument 'axis'.*referenceRotationMatrix rotates"),
        ("CreateCylinder", {"radius": 1, "innerRadius": 1, "density": 1}, "argument 'innerRadius'.*less than 1"),
        ("CreateSphere", {"radius": -1, "density": 1}, "argument 'radius'.*greater than zero"),
    ],
)
def test_wrong_shapes_are_refused(mbs: Any, name: str, arguments: dict[str, Any], text: str) -> None:
    with pytest.raises(ValueError, match=text):
        getattr(mbs, name)(**arguments)
    assert mbs.systemData.NumberOfObjects() == 0


# ---- joints ----------------------------------------------------------------------------------------------------------
def test_a_fixed_joint_makes_one_body_of_two(mbs: Any) -> None:
    """A physical pendulum: two bodies that are joined have the period of one body, and the joint carries the weight of the outer
    one when it hangs at rest."""
    ground = mbs.CreateGround()
    arm = mbs.CreateBox(size=[1, 0.1, 0.1], density=1000, referencePosition=[0, 0, -0.5], gravity=[0, 0, -10],
                        referenceRotationMatrix=RotationMatrixY(np.pi / 2))  # fmt: skip
    bob = mbs.CreateSphere(radius=0.2, mass=8, referencePosition=[0, 0, -1.2], gravity=[0, 0, -10])
    mbs.CreateRevoluteJoint(bodyNumbers=[ground, arm], position=[0, 0, 0], axis=[0, 1, 0])
    joint = mbs.CreateFixedJoint(bodyNumbers=[arm, bob])
    solve(mbs, 0.1, 10)
    assert output(mbs, bob, Variable.Position) == pytest.approx([0, 0, -1.2], abs=1e-10)
    assert mbs.GetObjectOutput(joint, Variable.WrenchOnMarker0)[:3] == pytest.approx([0, 0, -80], abs=1e-6)
    inertia = 10 / 3 + 10 / 12 * 0.01 + 8 * (1.2**2 + 0.4 * 0.04)
    found = mbs.ComputeODE2Eigenvalues()[0]
    assert np.sqrt(found[-1]) == pytest.approx(np.sqrt((10 * 0.5 + 8 * 1.2) * 10 / inertia), rel=1e-6)


def test_a_fixed_joint_at_a_marker(mbs: Any) -> None:
    """The marker sets the position, as in all joints: [] and None are the same."""
    bodies = [mbs.CreateSphere(mass=1, referencePosition=[x, 0, 0]) for x in (0, 1)]
    marker = mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=bodies[0], localPosition=[0.3, 0, 0]))
    joints = [mbs.CreateFixedJoint(bodyNumbers=[marker, bodies[1]], **given) for given in ({}, {"position": []})]
    mbs.Assemble()
    for joint in joints:
        other = mbs.GetObjectParameter(joint, "markerNumbers")[1]
        assert mbs.GetMarkerOutput(other, Variable.Position) == pytest.approx([0.3, 0, 0])
    with pytest.raises(ValueError, match="CreateFixedJoint.*expected a vector with 3 finite components, or None"):
        mbs.CreateFixedJoint(bodyNumbers=[marker, bodies[1]], position=[0, 0])


def test_a_sleeve_turns_and_falls(mbs: Any) -> None:
    """A cylindrical joint leaves rotation and translation along its axis free: g cos(a) along, constant rotation about."""
    tilt = RotationMatrixX(0.5)
    axis = tilt @ [0, 0, 1]
    sleeve = mbs.CreateCylinder(
        radius=0.2,
        length=1,
        density=100,
        referenceRotationMatrix=tilt,
        initialAngularVelocity=6 * axis,
        gravity=[0, 0, -10],
    )
    mbs.CreateCylindricalJoint(bodyNumbers=[mbs.CreateGround(), sleeve], position=[0, 0, 0], axis=axis)
    solve(mbs, 0.5, 50)
    along = -0.5 * 10 * np.cos(0.5) * 0.25
    assert output(mbs, sleeve, Variable.Position) == pytest.approx(along * axis, abs=1e-9)
    assert output(mbs, sleeve, Variable.AngularVelocity) == pytest.approx(
        6 * axis, rel=1e-5, abs=1e-9
    )  # second order: steps of 60 mrad


@pytest.mark.parametrize("is_global", [True, False])
def test_a_universal_joint_has_the_speed_ratio_of_cardan(mbs: Any, is_global: bool) -> None:
    """If the pin of the first shaft is normal to the plane of both shafts at the start, tan(theta2) = cos(bend) tan(theta1):
    the speeds have the ratio cos(bend) / (1 - sin(bend)^2 sin(theta1)^2)."""
    bend, speed, time = 0.6, 4.0, 0.5
    turned = RotationMatrixZ(bend)
    ground = mbs.CreateGround()
    shaft = mbs.CreateCylinder(radius=0.1, length=1, axis=[1, 0, 0], mass=1e4, referencePosition=[-1, 0, 0],
                               initialAngularVelocity=[speed, 0, 0])  # fmt: skip
    start = speed * np.cos(bend)
    driven = mbs.CreateCylinder(radius=0.1, length=1, axis=[1, 0, 0], mass=1e-3, referencePosition=turned @ [1, 0, 0],
                                referenceRotationMatrix=turned, initialAngularVelocity=start * turned[:, 0])  # fmt: skip
    mbs.CreateRevoluteJoint(bodyNumbers=[ground, shaft], position=[-1, 0, 0], axis=[1, 0, 0])
    position = [0, 0, 0] if is_global else [1, 0, 0]
    mbs.CreateUniversalJoint(bodyNumbers=[shaft, driven], position=position, axis0=[0, 0, 2],
                             axis1=turned[:, 1] if not is_global else list(turned[:, 1]), useGlobalFrame=is_global)  # fmt: skip
    mbs.CreateCylindricalJoint(bodyNumbers=[ground, driven], position=turned @ [1, 0, 0], axis=turned[:, 0])
    solve(mbs, time, 2000)
    angle = speed * time
    ratio = np.cos(bend) / (1 - np.sin(bend) ** 2 * np.sin(angle) ** 2)
    found = output(mbs, driven, Variable.AngularVelocity) @ turned[:, 0]
    assert found == pytest.approx(speed * ratio, rel=1e-4)  # second order: steps of 1 mrad
    assert output(mbs, shaft, Variable.AngularVelocity)[0] == pytest.approx(speed, rel=1e-5)


# ---- planar joints ---------------------------------------------------------------------------------------------------
def test_planar_bodies_get_planar_joints(mbs: Any) -> None:
    """A slider-crank of planar bodies has no redundant equation."""
    ground = mbs.CreateGround()
    bar = InertiaCuboid(1000, [1, 0.1, 0.1])
    crank = mbs.CreateRigidBody(inertia=bar, referencePosition=[0.5, 0, 0], create2D=True, gravity=[0, -10, 0])
    rod = mbs.CreateRigidBody(inertia=bar, referencePosition=[1.5, 0, 0], create2D=True)
    slider = mbs.CreateBox(size=[0.1, 0.1, 0.1], density=1000, referencePosition=[2, 0, 0], create2D=True)
    joints = [
        mbs.CreateRevoluteJoint(bodyNumbers=[ground, crank], position=[0, 0, 0], axis=[0, 0, 1]),
        mbs.CreateRevoluteJoint(bodyNumbers=[crank, rod], position=[1, 0, 0], axis=[0, 0, 2]),
        mbs.CreateRevoluteJoint(bodyNumbers=[rod, slider], position=[2, 0, 0], axis=[0, 0, 1]),
        mbs.CreatePrismaticJoint(bodyNumbers=[ground, slider], position=[2, 0, 0], axis=[3, 0, 0]),
    ]
    kinds = [mbs.GetObject(joint)["objectType"] for joint in joints]
    assert kinds == ["JointRevolute2D"] * 3 + ["JointPrismatic2D"]
    mbs.Assemble()
    dof = mbs.ComputeSystemDegreeOfFreedom()
    assert dof["degreeOfFreedom"] == 1 and dof["redundantConstraints"] == 0


def test_a_planar_slider_moves_along_a_tilted_axis(mbs: Any) -> None:
    """g sin(a) along the axis; the body does not rotate, and the normal force acts through the joint."""
    ground = mbs.CreateGround()
    slider = mbs.CreateBox(
        size=[1, 1, 1], mass=2, create2D=True, gravity=[0, -10, 0], referenceRotationMatrix=RotationMatrixZ(0.3)
    )
    axis = np.array([np.cos(0.7), np.sin(0.7), 0])
    joint = mbs.CreatePrismaticJoint(bodyNumbers=[ground, slider], position=[0.2, 0, 0], axis=5 * axis)
    solve(mbs, 0.5, 50)
    along = -0.5 * 10 * np.sin(0.7) * 0.25
    assert output(mbs, slider, Variable.Position)[:2] == pytest.approx(along * axis[:2], abs=1e-9)
    assert mbs.GetNodeOutput(0, Variable.Coordinates)[2] == pytest.approx(0, abs=1e-9)
    force = mbs.GetObjectOutput(joint, Variable.WrenchOnMarker1)[:2]
    assert force == pytest.approx(20 * np.cos(0.7) * np.array([-axis[1], axis[0]]), abs=1e-7)


def test_a_fixed_joint_in_the_plane_has_three_equations(mbs: Any) -> None:
    """A cantilever of two planar boxes: weight and moment at the wall."""
    ground = mbs.CreateGround()
    first = mbs.CreateBox(size=[1, 0.1, 0.1], mass=3, referencePosition=[0.5, 0, 0], create2D=True, gravity=[0, -10, 0])
    second = mbs.CreateBox(
        size=[1, 0.1, 0.1], mass=1, referencePosition=[1.5, 0, 0], create2D=True, gravity=[0, -10, 0]
    )
    wall = mbs.CreateFixedJoint(bodyNumbers=[ground, first], position=[0, 0, 0])
    mbs.CreateFixedJoint(bodyNumbers=[first, second])
    solve(mbs, 0.1, 10)
    wrench = mbs.GetObjectOutput(wall, Variable.WrenchOnMarker1)
    assert wrench[1] == pytest.approx(40, abs=1e-7) and wrench[5] == pytest.approx(30 * 0.5 + 10 * 1.5, abs=1e-7)
    assert mbs.ComputeSystemDegreeOfFreedom()["redundantConstraints"] == 0


@pytest.mark.parametrize(
    ("name", "arguments", "text"),
    [
        ("CreateFixedJoint", {"bodyNumbers": [0, 7]}, "bodyNumbers.1.*an object of this MainSystem, which has 3"),
        ("CreateFixedJoint", {"bodyNumbers": [1, 1]}, "two different bodies"),
        ("CreateCylindricalJoint", {"bodyNumbers": [0, 1], "position": [0, 0, 0]}, "argument 'axis'"),
        ("CreateCylindricalJoint", {"bodyNumbers": [0, 2], "position": [0, 0, 0], "axis": [1, 0, 0]}, "xy plane"),
        ("CreateUniversalJoint", {"bodyNumbers": [0, 1], "position": [0, 0, 0], "axis1": [1, 1, 0]}, "perpendicular"),
        ("CreateUniversalJoint", {"bodyNumbers": [0, 1], "position": [0, 0, 0], "axis0": [0, 0, 0]}, "axis0.*not zero"),
        ("CreateRevoluteJoint", {"bodyNumbers": [0, 2], "position": [0, 0, 0], "axis": [1, 0, 0]}, "axis of the plane"),
    ],
)
def test_wrong_joints_are_refused(mbs: Any, name: str, arguments: dict[str, Any], text: str) -> None:
    mbs.CreateGround()
    mbs.CreateBox(mass=1)
    mbs.CreateBox(mass=1, create2D=True)
    with pytest.raises(ValueError, match=text):
        getattr(mbs, name)(**arguments)
    assert mbs.systemData.NumberOfObjects() == 3 and mbs.systemData.NumberOfMarkers() == 0
