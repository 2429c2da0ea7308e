"""Model: items by name, create methods made of Create functions, errors; Solution: outputs, files, warnings."""

from __future__ import annotations

import inspect
import os
import pickle
import re
import subprocess
import sys
import time
import warnings
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

import dalembert as db
from dalembert import create
from dalembert._snake_case import snake_case

OMEGA, DAMPING, MASS = 20.0, 0.1, 1.5  # undamped angular frequency (rad/s), damping ratio, mass (kg)


def oscillator() -> Any:
    """Return a mass on a spring and damper along x, at rest 0.1 m from its equilibrium."""
    model = db.Model()
    mass = model.create_mass_point(
        name="mass", reference_position=[1, 0, 0], initial_displacement=[0.1, 0, 0], mass=MASS
    )
    model.create_cartesian_spring_damper(
        name="spring",
        body_numbers=["ground", mass],
        local_position0=[1, 0, 0],
        stiffness=[MASS * OMEGA**2, 1, 1],
        damping=[2 * DAMPING * OMEGA * MASS, 0, 0],
    )
    return model


def displacement(t: Any) -> Any:
    """Return the free vibration from 0.1 m at rest, and its velocity."""
    damped = OMEGA * np.sqrt(1 - DAMPING**2)
    decay = 0.1 * np.exp(-DAMPING * OMEGA * t)
    x = decay * (np.cos(damped * t) + DAMPING * OMEGA / damped * np.sin(damped * t))
    return x, -decay * OMEGA**2 / damped * np.sin(damped * t)


# ---- items


def test_items_are_found() -> None:
    model = oscillator()
    model.create_sensor("mass", "velocity", name="speed")
    assert [each.name for each in model] == ["ground", "mass", "spring", "speed"]
    assert len(model) == 4
    assert "mass" in model
    assert "mas" not in model
    assert model["mass"] in model
    assert model.bodies["mass"] == model.bodies[0] == model["mass"]
    assert [each.name for each in model.bodies] == ["mass"]
    assert [each.name for each in model.connectors] == ["spring"]
    assert [each.name for each in model.sensors] == ["speed"]
    assert len(model.joints) == len(model.loads) == 0
    assert "mass" in model.bodies
    assert len(model.bodies[:1]) == 1
    assert model.ground == model["ground"]
    assert len(model.nodes) == 1
    assert repr(model) == "<Model: 1 bodies, 0 joints, 1 connectors, 0 loads, 1 sensors>"
    assert "<table>" in model._repr_html_()


def test_missing_items() -> None:
    model = oscillator()
    with pytest.raises(KeyError, match=r"no item 'mas'\. Did you mean 'mass'\?"):
        model["mas"]
    with pytest.raises(KeyError, match=r"no item 'wheel'; there are 'ground', 'mass', 'spring'"):
        model["wheel"]
    with pytest.raises(KeyError, match="there is no joint 'hinge'; there are none"):
        model.joints["hinge"]
    with pytest.raises(TypeError, match="expected the name of an item, received 3"):
        model[3]
    with pytest.raises(ValueError, match="name: 'mass' is the name of <MassPoint 'mass'"):
        model.create_mass_point(name="mass", mass=1)
    assert len(model) == 3
    with pytest.raises(AttributeError, match="use model.create_ground"):
        model.CreateGround()
    with pytest.raises(AttributeError, match="'compute_vibration_modes'; use model.system.ComputeVibrationModes"):
        _ = model.compute_vibration_modes
    with pytest.raises(AttributeError, match="use model.system.GetObject"):
        model.GetObject(0)
    with pytest.raises(AttributeError, match="Did you mean 'create_rigid_body'"):
        model.create_rigid_bdy()
    with pytest.raises(TypeError, match="expected a MainSystem"):
        db.Model("model.json")


def test_errors_of_create_methods_have_their_names() -> None:
    model = oscillator()
    with pytest.raises(TypeError, match=r"model.create_mass_point: unknown argument 'colour'.*'color'"):
        model.create_mass_point(colour="red")
    with pytest.raises(ValueError, match=r"model.create_mass_point: argument 'physics_mass': .*received -1"):
        model.create_mass_point(mass=-1)
    with pytest.raises(
        ValueError, match=r"model.create_spring_damper: argument 'body_numbers\[1\]': received 'mas'.*'mass'"
    ):
        model.create_spring_damper(body_numbers=["ground", "mas"])
    with pytest.raises(ValueError, match=r"model.create_force: body_number: <MassPoint 'mass'.*another model"):
        model.create_force(body_number=oscillator()["mass"], load_vector=[1, 0, 0])
    with pytest.raises(ValueError, match=r"model.create_mass_point: color: received 'rad'"):
        model.create_mass_point(color="rad")
    with pytest.raises(
        ValueError, match=r"model.create_rigid_body: node_type: received 'Euler'.*'RotationEulerParameters'"
    ):
        model.create_rigid_body(node_type="Euler")
    with pytest.raises(ValueError, match=r"model.create_box: argument 'initial_velocity'.*without z component"):
        model.create_box(mass=1, create_2d=True, initial_velocity=[0, 0, 1])
    with pytest.raises(TypeError, match="'name' is given twice"):
        model.create_mass_point("name", name="other")
    with pytest.raises(ValueError, match=r"model.create_sensor of <MassPoint 'mass'.*no output 'positon'.*'position'"):
        model.create_sensor("mass", "positon")
    ball = model.create_sphere("ball", mass=1)
    joint = model.create_revolute_joint(body_numbers=["ground", ball], position=[0, 0, 0], axis="z")
    with pytest.raises(
        ValueError, match="output: 'force' is a part of 'wrench_on_marker0', 3 numbers of force and 3 of"
    ):
        model.create_sensor(joint, "force")
    cable = model.create_cable()
    text = r"body_numbers: expected a body or a marker, .* its ends are \['start'\] and \['end'\]"
    with pytest.raises(ValueError, match=f"model.create_spherical_joint: {text}"):
        model.create_spherical_joint(body_numbers=[cable, ball], position=[0, 0, 0])
    with pytest.raises(
        ValueError, match=r"'body_numbers\[0\]': expected a body or marker with position and orientation"
    ):
        model.create_spherical_joint(body_numbers=[cable["elements"][-1], ball], position=[0, 0, 0])


def test_create_methods_are_those_of_the_system() -> None:
    names = {snake_case(name): name for group in create.MODULES.values() for name in group}
    for name, original in names.items():
        method = getattr(db.Model, name)
        wanted = [snake_case(each) for each in list(inspect.signature(create.method(original)).parameters)[1:]]
        old = {"return_dict", "body_list", "body_or_node_list"}
        assert list(inspect.signature(method).parameters)[1:] == [each for each in wanted if each not in old]
        assert method.__name__ == name
        assert "Arguments:" in method.__doc__
        assert not old & set(method.__doc__.replace(":", " ").split())


def test_a_model_of_a_system_that_exists() -> None:
    mbs = db.SystemContainer().AddSystem()
    mbs.CreateGround()
    mass = mbs.CreateMassPoint("mass", physicsMass=2)
    model = db.Model(mbs)
    assert model["mass"] == mass
    assert model["ground"].type == "Ground"  # the only one needs no name
    spring = model.create_spring_damper(body_numbers=["ground", mass], reference_length=1)
    assert mbs.GetObjectParameter(spring, "referenceLength") == 1


def test_single_items_are_added() -> None:
    model = db.Model()
    node = model.add(db.NodePoint(referenceCoordinates=[1, 0, 0], name="node"))
    body = model.add(db.MassPoint(nodeNumber=node, physicsMass=1, name="body"))
    assert body.node_number == node
    assert model["node"] == node
    assert node.position == pytest.approx([1, 0, 0], abs=0)
    with pytest.raises(TypeError, match="model.add: expected an item"):
        model.add("node")


def test_model_files(tmp_path: Path) -> None:
    model = oscillator()
    model.save(tmp_path / "model.json")
    again = db.Model.load(tmp_path / "model.json")
    assert again["mass"].mass == MASS
    assert [each.name for each in again] == [each.name for each in model]


# ---- solutions


def test_solution_of_an_oscillator(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    model = oscillator()
    mass = model["mass"]
    solution = model.solve(end_time=1, step_size=1e-3, outputs=[(mass, "displacement"), "mass.velocity"])
    x, v = displacement(solution.times)
    assert solution.times == pytest.approx(np.linspace(0, 1, 1001), abs=1e-12)
    assert solution[mass].displacement[:, 0] == pytest.approx(x, abs=5e-5)  # second order, omega h = 0.02
    assert solution["mass"].velocity[:, 0] == pytest.approx(v, abs=1e-3)
    assert solution[mass].position[:, 0] == pytest.approx(1 + solution[mass].displacement[:, 0], abs=1e-14)
    spring = MASS * OMEGA**2 * x + 2 * DAMPING * OMEGA * MASS * v
    assert solution["spring"].force[:, 0] == pytest.approx(spring, abs=0.06)  # of 60 N
    energies = solution.energies
    assert energies.kinetic == pytest.approx(MASS / 2 * solution[mass].velocity[:, 0] ** 2, rel=1e-12, abs=1e-15)
    assert energies.total[0] == pytest.approx(MASS * OMEGA**2 * 0.1**2 / 2, rel=1e-9)
    assert np.all(np.diff(energies.total) < 1e-6)
    assert solution.states["coordinates"].shape == (1001, 3)
    assert solution.statistics["steps"] == 1000
    assert solution.statistics["finished"]
    assert solution.warnings == ()
    assert repr(solution) == "<Solution: 1001 states from 0 s to 1 s, GeneralizedAlpha>"
    assert mass.displacement == pytest.approx(solution[mass].displacement[-1], abs=0)
    assert os.listdir(tmp_path) == []


def test_forces_on_a_body_over_time() -> None:
    """A rod that swings down: weight and centripetal force; recorded functions give no warning."""
    model = db.Model()
    rod = model.create_box(size=[1, 0.1, 0.1], mass=3, reference_position=[0.5, 0, 0], gravity=[0, -10, 0])
    place = {"body_numbers": ["ground", rod], "position": [0, 0, 0], "axis": "z"}
    hinge = model.create_revolute_joint(name="hinge", **place)
    motor = model.create_motor(**place, torque=0)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        solution = model.solve(end_time=0.3, step_size=1e-3, outputs=[(motor, "rotation")])
        inertia = 3 * (solution[rod].acceleration - [0, -10, 0])
        np.testing.assert_allclose(solution[hinge].force_on(rod), inertia, atol=1e-9)
        np.testing.assert_allclose(solution[hinge].force_on("ground"), -inertia, atol=1e-9)
    with pytest.raises(ValueError, match="expected one of its two bodies"):
        solution[hinge].force_on(hinge)
    with pytest.raises(KeyError, match=r"there is no body or marker 'rod'"):
        solution[hinge].torque_on("rod")
    assert "force_on" in dir(solution[hinge])


def test_forces_of_planar_joints_and_springs() -> None:
    """A hanging planar body: its weight is on the hinge, or on the spring."""
    for planar in (True, False):
        model = db.Model()
        body = model.create_box(name="b", size=[1, 1, 1], mass=2, gravity=[0, -10, 0], create_2d=planar)
        hinge = model.create_revolute_joint(body_numbers=["ground", body], position=[0, 0.5, 0], axis="z")
        solution = model.solve(end_time=0.1, step_size=1e-2)
        for on in (body, "b"):
            np.testing.assert_allclose(hinge.force_on(on), [0, 20, 0], atol=1e-9)
            np.testing.assert_allclose(solution[hinge].force_on(on)[-1], [0, 20, 0], atol=1e-9)
    model = db.Model()
    ball = model.create_sphere(mass=2, gravity=[0, 0, -10], reference_position=[0, 0, -1])
    spring = model.create_spring_damper(body_numbers=["ground", ball], reference_length=0.9, stiffness=200)
    model.solve(end_time=0.01, step_size=1e-2)
    np.testing.assert_allclose(spring.force_on(ball), [0, 0, 20], atol=1e-9)
    assert "force_on" in dir(spring)


def test_items_of_one_name_and_deleted_items() -> None:
    """Outputs belong to items, not to their names or numbers."""
    model = db.Model()
    first = model.create_mass_point(name="first", mass=1, reference_position=[1, 0, 0])
    last = model.create_mass_point(name="last", mass=1, reference_position=[3, 0, 0])
    node = model.nodes[0]
    node.name = "last"
    solution = model.solve(end_time=0.1, step_size=0.1)
    assert solution[node].position[0, 0] == 1 and solution[last].position[0, 0] == 3
    model.delete(first)
    assert solution[model["last"]].position[0, 0] == 3
    added = model.create_mass_point(name="new", mass=1)
    with pytest.raises(KeyError, match="'new'.*was added or renamed after the solution"):
        _ = solution[added].position


def test_solutions_do_not_follow_later_changes() -> None:
    model = oscillator()
    solution = model.solve(end_time=0.1, step_size=1e-3)
    expected = (
        MASS * OMEGA**2 * solution["mass"].displacement[:, 0]
        + 2 * DAMPING * OMEGA * MASS * solution["mass"].velocity[:, 0]
    )
    model["spring"].stiffness = [1, 1, 1]
    model.create_mass_point(name="another", mass=1)
    assert solution["spring"].force[:, 0] == pytest.approx(expected, rel=1e-9, abs=1e-9)


def test_outputs_agree_with_sensors() -> None:
    """Sensors measure while the solver runs, outputs are computed from the states."""
    model = db.Model()
    inertia = db.rigidBodyUtilities.InertiaCuboid(1000, [0.4, 0.1, 0.1])
    arm = model.create_rigid_body(name="arm", reference_position=[0.2, 0, 0], inertia=inertia, gravity=[0, -9.81, 0])
    hinge = model.create_revolute_joint(name="hinge", body_numbers=["ground", arm], position=[0, 0, 0], axis="z")
    tip = model.create_sensor(arm, "velocity", local_position=[0.2, 0, 0], name="tip")
    wrench = model.create_sensor(hinge, "wrench_on_marker0", name="wrench")
    spin = model.create_sensor(arm, "angular_velocity", name="spin")
    solution = model.solve(end_time=0.2, step_size=1e-3, outputs=[tip])
    assert solution[arm].velocity_at([0.2, 0, 0]) == pytest.approx(tip.values, abs=1e-13)
    assert solution[hinge].force == pytest.approx(wrench.values[:, :3], rel=1e-9, abs=1e-9)
    assert solution[hinge].torque == pytest.approx(wrench.values[:, 3:], rel=1e-9, abs=1e-9)
    assert solution[arm].angular_velocity == pytest.approx(spin.values, abs=1e-13)
    assert solution[tip].values == pytest.approx(tip.values, abs=0)
    assert solution["tip"].time == pytest.approx(solution.times, abs=1e-15)
    assert solution[hinge].force_local.shape == (201, 3)
    with pytest.raises(ValueError, match=r"'force' is a part of 'wrench_on_marker0'"):
        model.create_sensor(hinge, "force")


@pytest.mark.parametrize("method", ["dopri5", "rk44", "esdirk43", "trapezoidal_index2"])
def test_methods_and_intervals(method: str) -> None:
    solution = oscillator().solve(1, 1e-3, method=method, every=0.125)
    assert solution.times == pytest.approx(np.linspace(0, 1, 9), abs=1e-12)
    x, _ = displacement(solution.times)
    # Fixed steps of second order; the other methods are far more accurate.
    tolerance = 5e-5 if method == "trapezoidal_index2" else 1e-7
    assert solution["mass"].displacement[:, 0] == pytest.approx(x, abs=tolerance)


def test_static_solution() -> None:
    model = oscillator()
    model.create_force(body_number="mass", load_vector=[3, 0, 0])
    solution = model.solve_static(outputs=["mass.displacement"])
    assert solution["mass"].displacement[-1, 0] == pytest.approx(3 / (MASS * OMEGA**2), rel=1e-10)
    assert model["mass"].displacement[0] == pytest.approx(3 / (MASS * OMEGA**2), rel=1e-10)


def test_integral_parts_of_controllers_rest_in_statics() -> None:
    """P (0.5 - phi) = m g l cos(phi): the integral part of the controller is held, with a warning."""
    model = db.Model()
    arm = model.create_box(mass=6, gravity=[0, -9.81, 0], reference_position=[0.5, 0, 0])
    place = {"body_numbers": ["ground", arm], "position": [0, 0, 0], "axis": "z"}
    model.create_revolute_joint(**place)
    controller = model.create_pid_controller(name="pid", **place, set_point=0.5, P=60, I=100)
    with pytest.warns(db.SolutionWarning, match=r"such as the integral part .* keep .* The rate of 'node1' is 0\.49"):
        solution = model.solve_static()
    angle = solution[arm].rotation[-1, 2]
    assert 60 * (0.5 - angle) == pytest.approx(6 * 9.81 * 0.5 * np.cos(angle), rel=1e-8)
    controller.parameters["forceUserFunction.P"] = 0.0
    with pytest.raises(db.SolverError) as it:
        model.solve_static()
    assert "an integral part alone resists no motion" in it.value.__notes__[0]


def test_motions_without_stiffness_are_named() -> None:
    """A beam on two hinges turns about its own axis: coordinate 3 of its nodes is a rotation about x."""
    model = db.Model()
    line: dict[str, Any] = {"end": [2, 0, 0], "diameter": 0.02, "gravity": [0, 0, -9.81], "number_of_elements": 8}
    model.create_beam(**line, supports=["hinged", "hinged"])
    with pytest.raises(db.SolverError) as it:
        model.solve_static()
    assert "nothing resists a motion of node" in it.value.__notes__[0]
    assert "(NodeRigidBodyRotVecLG), coordinate 3" in it.value.__notes__[0]
    held = db.Model()
    held.create_beam(**line, supports=["clamped", "free"])
    settings = db.SimulationSettings(staticSolver={"newton": {"maxIterations": 1}, "adaptiveStep": False})
    with pytest.raises(db.SolverError) as it:
        held.solve_static(settings=settings)
    assert not hasattr(it.value, "__notes__")


def test_directions_have_names() -> None:
    model = db.Model()
    mass = model.create_mass_point(mass=2)
    model.create_force_from_table(body_number=mass, table=6, direction="-z")
    solution = model.solve(1, 1e-2)
    assert solution[mass].velocity[-1] == pytest.approx([0, 0, -3], rel=1e-12)


def test_constants_of_recorded_functions_are_parameters() -> None:
    model = db.Model()
    wheel = model.create_cylinder(mass=1)
    place = {"body_numbers": ["ground", wheel], "position": [0, 0, 0], "axis": "z"}
    motor = model.create_motor(**place, speed=3, damping=2)
    motor.parameters["spring_torque_user_function.damping"] = 5
    assert motor.parameters["springTorqueUserFunction.damping"] == 5
    with pytest.raises(KeyError, match="has no parameter .springTorque.damping"):
        motor.parameters["springTorque.damping"]
    with pytest.raises(Exception, match="stiffness"):
        motor.parameters["springTorqueUserFunction.stiffness"]
    assert motor.damping == 5
    motor.damping = 4.0
    assert motor.parameters["springTorqueUserFunction.damping"] == motor.damping == 4


def test_energies_of_springs_that_turn_several_times() -> None:
    """A wheel on a torsional spring turns by 20 rad; kinetic energy becomes potential energy, 0.5 k phi^2."""
    for nonlinear in (False, True):
        model = db.Model()
        wheel = model.create_cylinder(mass=2, radius=1, initial_angular_velocity=[0, 0, 20])
        place = {"body_numbers": ["ground", wheel], "position": [0, 0, 0], "axis": "z"}
        model.create_revolute_joint(**place)
        spring = model.create_torsional_spring_damper(name="spring", **place, stiffness=1.0)
        if nonlinear:
            spring.parameters["springTorqueUserFunction"] = lambda mbs, t, i, phi, w, k, d, offset: k * phi
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            solution = model.solve(3, 1e-3, every=0.3)
            energies = solution.energies
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of user functions: this one has no data of its own
            angle = solution["spring"].rotation
        assert np.abs(angle).max() > 15
        assert energies.potential == pytest.approx(0.5 * angle**2, rel=1e-9, abs=1e-9)
        assert energies.total == pytest.approx(200.0, rel=1e-4)  # steps of 1e-3 s at 1 rad/s


def test_solutions_go_on_from_the_last_state() -> None:
    model = oscillator()
    model.solve(0.5, 1e-3, update_initial_values=True)
    solution = model.solve(1, 1e-3, start_time=0.5)
    assert solution.times[[0, -1]] == pytest.approx([0.5, 1], abs=1e-12)
    assert solution["mass"].displacement[-1, 0] == pytest.approx(displacement(1.0)[0], abs=5e-5)


def test_states_of_solvers_become_initial_values(tmp_path: Path) -> None:
    model = oscillator()
    at_rest = model.solve_static(update_initial_values=True)["mass"].position[-1]
    node = model["mass"].nodes[0]
    assert node.initial_coordinates == pytest.approx(at_rest - [1, 0, 0], abs=1e-15)
    sensor = model.create_sensor("mass", "position")
    model.solve(0.1, 1e-3)
    assert sensor.values[[0, -1]] == pytest.approx(np.array([at_rest] * 2), abs=1e-9)  # tolerance of the static solver
    model.save(tmp_path / "model.json")
    assert db.Model.load(tmp_path / "model.json")["mass"].position == pytest.approx(at_rest, abs=0)
    twin = model.differentiable({"m": ("mass", "mass")}, {"x": db.At(sensor, 0.0)}, 0.1, 1e-3)
    assert twin.Values([MASS])["x"] == pytest.approx(at_rest[0], abs=1e-12)
    node.initial_velocities = [0, 1, 0]
    solution = model.solve(0.1, 1e-3)
    assert solution["mass"].velocity[0] == pytest.approx([0, 1, 0], abs=0)
    assert solution["mass"].position[0] == pytest.approx(at_rest, abs=0)
    model.create_mass_point(name="second", mass=1, initial_displacement=[0.2, 0, 0])
    model.delete("spring")
    solution = model.solve(0.1, 1e-3, update_initial_values=True)
    assert solution["mass"].position[0] == pytest.approx(at_rest, abs=0)
    assert solution["second"].position[0] == pytest.approx([0.2, 0, 0], abs=0)
    node.initial_coordinates = [0, 0, 0]
    solution = model.solve(0.1, 1e-3)
    assert solution["mass"].position[0] == pytest.approx([1, 0, 0], abs=0)
    assert solution["mass"].velocity[0] == pytest.approx([0, 1, 0], abs=1e-9)  # it was free, without forces


@pytest.mark.parametrize("node_type", ["RotationEulerParameters", "RotationRxyz", "RotationRotationVector"])
def test_rotating_bodies_go_on(node_type: str) -> None:
    """A free body, whose rotation is far from its reference: a pause with new items changes nothing."""
    turned = []
    for pause in (False, True):
        model = db.Model()
        body = model.create_rigid_body(
            inertia=db.utilities.InertiaCuboid(1000, [0.1, 0.2, 0.3]), initial_angular_velocity=[1, 2, 3],
            node_type=node_type,
        )  # fmt: skip
        if pause:
            model.solve(0.5, 1e-3, update_initial_values=True)
            model.create_sensor(body, "rotation")
            turned.append(model.solve(1, 1e-3, start_time=0.5)[body].rotation_matrix[-1])
        else:
            turned.append(model.solve(1, 1e-3)[body].rotation_matrix[-1])
    assert turned[0] == pytest.approx(turned[1], abs=1e-7)  # accelerations of generalized alpha begin anew


def test_tables_and_files(tmp_path: Path) -> None:
    model = oscillator()
    speed = model.create_sensor("mass", "velocity", name="speed")
    solution = model.solve(0.2, 1e-3, outputs=[("mass", "displacement", [0, 0, 0]), "mass.kinetic_energy"])
    frame = solution.to_pandas()
    assert list(frame.columns) == [
        "speed.X", "speed.Y", "speed.Z", "mass.displacement(0, 0, 0).X", "mass.displacement(0, 0, 0).Y",
        "mass.displacement(0, 0, 0).Z", "mass.kinetic_energy",
    ]  # fmt: skip
    assert frame.attrs["units"]["mass.kinetic_energy"] == "J"
    data = solution.to_xarray()
    assert data["speed"].attrs["units"] == "m/s"
    assert data["mass.kinetic_energy"].to_numpy() == pytest.approx(solution["mass"].kinetic_energy, abs=0)
    _ = solution.energies
    solution.save(tmp_path / "run.h5")
    again = db.Solution.load(tmp_path / "run.h5")
    assert again["mass"].kinetic_energy == pytest.approx(solution["mass"].kinetic_energy, abs=0)
    assert again["speed"].values == pytest.approx(speed.values, abs=0)
    assert again.energies.total == pytest.approx(solution.energies.total, abs=0)
    assert again.statistics == solution.statistics
    with pytest.raises(AttributeError, match="has no output 'position'"):
        _ = again["mass"].position
    with pytest.raises(KeyError, match="no outputs of 'spring'; there are mass, speed. Load it with model="):
        again["spring"]
    with_model = db.Solution.load(tmp_path / "run.h5", model=model)
    assert with_model["spring"].force == pytest.approx(solution["spring"].force, abs=0)
    with pytest.raises(ValueError, match="it belongs to another model"):
        db.Solution.load(tmp_path / "run.h5", model=db.Model())
    other = oscillator()
    other["mass"].physics_mass = 2 * MASS
    with pytest.raises(ValueError, match=r"model: object 1 'mass' .MassPoint. has other parameters; .*another model"):
        db.Solution.load(tmp_path / "run.h5", model=other)
    model["mass"].nodes[0].initial_velocities = [1, 0, 0]
    db.Solution.load(tmp_path / "run.h5", model=model)
    (tmp_path / "other.h5").write_text("text")
    with pytest.raises(OSError, match=r"other\.h5: .*signature not found"):
        db.Solution.load(tmp_path / "other.h5")


def test_files_that_settings_name_are_written(tmp_path: Path) -> None:
    settings = db.SimulationSettings()
    settings.solutionSettings.coordinatesSolutionFileName = str(tmp_path / "named")
    solution = oscillator().solve(0.1, 1e-3, settings=settings, every=0.05)
    assert os.listdir(tmp_path) == ["named.txt"]
    assert solution.times == pytest.approx([0, 0.05, 0.1], abs=1e-12)
    assert settings.timeIntegration.endTime == db.SimulationSettings().timeIntegration.endTime  # a copy was changed


def test_differentiable_models() -> None:
    """The free vibration from 0.1 m; derivatives by its formula. Errors of the scheme: (h omega)^2 / 12, times 20 rad."""
    model = oscillator()
    model.create_sensor("mass", "displacement", name="x")
    places = {"k": ("spring", "stiffness", 0), "c": (model["spring"], "damping", 0), "m": ("mass", "mass")}
    found = model.differentiable(places, {"x": db.At("x")}, end_time=1, step_size=1e-3).Sensitivities(
        [MASS * OMEGA**2, 2 * DAMPING * OMEGA * MASS, MASS]
    )

    def end(k: float, c: float, m: float) -> float:
        decay = c / (2 * m)
        omega = np.sqrt(k / m - decay**2)
        return float(0.1 * np.exp(-decay) * (np.cos(omega) + decay / omega * np.sin(omega)))

    at = np.array([MASS * OMEGA**2, 2 * DAMPING * OMEGA * MASS, MASS])
    wanted = [(end(*(at + d)) - end(*(at - d))) / 2e-4 for d in 1e-4 * np.eye(3)]
    assert found.matrix[0] == pytest.approx(wanted, rel=5e-3, abs=1e-3 * np.abs(wanted).max())
    with pytest.raises(KeyError, match="no item 'sprin'. Did you mean 'spring'"):
        model.differentiable({"k": ("sprin", "stiffness")}, {"x": db.At("x")}, 1, 1e-3)
    with pytest.raises(TypeError, match="parameters: expected .*, received 'k'"):
        model.differentiable("k", {}, 1, 1e-3)
    with pytest.raises(ValueError, match="model.differentiable: step_size: GeneralizedAlpha has equal steps"):
        model.differentiable({"k": ("spring", "stiffness", 0)}, {"x": db.At("x")}, 1)


def test_progress_bars(capfd: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    """The bar shows the time that the solver has reached, and goes at the end; files and pipes get none."""
    monkeypatch.setattr("dalembert._model.progress._DELAY", 0)
    model = oscillator()
    model.system.SetPreStepUserFunction(lambda mbs, t: time.sleep(0.05) or True)
    for _ in range(2):  # the second solver replaces the first
        model.solve(end_time=0.8, step_size=0.1, progress=True)
        bar = capfd.readouterr().err
        times = [float(each) for each in re.findall(r"([0-9.e-]+)/0.8 s", bar)]
        assert 0 < max(times[:-1]) < 0.8 and times == sorted(times)
        assert bar.endswith("\r")
    model.solve(end_time=0.2, step_size=0.1)
    assert capfd.readouterr().err == ""


def test_plots() -> None:
    model = oscillator()
    solution = model.solve(0.1, 1e-3)
    with pytest.raises(ValueError, match="no outputs yet"):
        solution.plot()
    ax = solution.plot("mass.displacement", (model["mass"], "position"))
    assert len(ax.lines) == 6 == len({line.get_color() for line in ax.lines})
    assert not ax.spines["top"].get_visible() and ax.get_xlim() == (0, pytest.approx(0.1))
    assert ax.lines[0].get_ydata() == pytest.approx(solution["mass"].displacement[:, 0], abs=0)


def test_states_at_a_time() -> None:
    model = oscillator()
    speed = model.create_sensor("mass", "velocity", name="speed")
    solution = model.solve(0.1, 1e-3, outputs=["mass.displacement"])
    state = solution.at(0.0502)
    assert state.times == pytest.approx([0.05], rel=1e-12) and len(state) == 1
    assert state["mass"].displacement[0] == pytest.approx(solution["mass"].displacement[50], abs=0)
    assert state["mass"].velocity[0] == pytest.approx(speed.values[50], abs=0)
    assert state["speed"].values[0] == pytest.approx(speed.values[50], abs=0)
    assert state.energies.total[0] == pytest.approx(solution.energies.total[50], abs=0)
    for outside in (-0.01, 0.11, np.nan):
        with pytest.raises(ValueError, match="solution.at: time: expected"):
            solution.at(outside)


def test_motions_are_written(tmp_path: Path) -> None:
    model = oscillator()
    solution = model.solve(0.1, 1e-3)
    solution.animate(tmp_path / "motion.gif", speed=0.1, frames_per_second=10, window_size=[120, 90])
    with Image.open(tmp_path / "motion.gif") as film:
        assert film.n_frames == 11 and film.size == (120, 90)  # one second, with both ends
    solution.animate(tmp_path / "motion.html", title="oscillator")
    assert "<html" in (tmp_path / "motion.html").read_text("utf-8")
    solution.animate(tmp_path / "motion.glb", speed=0.1)
    solution.animate(tmp_path / "grids" / "motion.pvd", speed=0.1, frames_per_second=10)
    assert b'"animations"' in (tmp_path / "motion.glb").read_bytes()  # of a motion, not of a state alone
    assert (tmp_path / "grids" / "motion.pvd").read_text("utf-8").count("timestep=") == 11
    with pytest.raises(TypeError, match=r"solution\.animate\(.*\): unknown argument 'speeds'"):
        solution.animate(tmp_path / "motion.gif", speeds=2)
    with pytest.raises(TypeError, match=r"solution\.animate\(.*\): unknown argument 'solution'"):
        solution.animate(tmp_path / "motion.gif", solution={})
    with pytest.raises(
        TypeError, match=r"animate\(\) without a file: unknown argument 'speed'; known are: row_increment"
    ):
        solution.animate(speed=2)
    model.container.visualizationSettings.nodes.show = False
    before = (tmp_path / "motion.gif").read_bytes()
    model.delete("mass")  # the solution has a model of its own
    options = {"speed": 0.1, "frames_per_second": 10, "window_size": [120, 90]}
    solution.animate(tmp_path / "without_nodes.gif", **options)
    assert (tmp_path / "without_nodes.gif").read_bytes() != before
    model.container.visualizationSettings.nodes.show = True
    solution.animate(tmp_path / "again.gif", **options)
    assert (tmp_path / "again.gif").read_bytes() == before


def test_wrong_arguments_of_solve() -> None:
    model = oscillator()
    for arguments, expected in (
        ({"end_time": 1}, "step_size: GeneralizedAlpha has equal steps: give their size"),
        ({"end_time": -1, "step_size": 0.1}, "end_time: received -1, but expected a time after 0"),
        ({"end_time": 1, "step_size": 0}, "step_size: expected a positive number"),
        (
            {"end_time": 1, "step_size": 0.1, "method": "alpha"},
            "method: received 'alpha'. Did you mean 'GeneralizedAlpha'",
        ),
        (
            {"end_time": 1, "step_size": 0.1, "outputs": [("mass", "positon")]},
            "'mass'.*no output 'positon'.*'position'",
        ),
        (
            {"end_time": 1, "step_size": 0.1, "outputs": ["mass.position.x"]},
            r"received 'mass.position.x', but expected 'mass.position', .* solution\['mass'\].position\[:, 0\] is the",
        ),
        (
            {"end_time": 1, "step_size": 0.1, "outputs": [("mass", "position", 0)]},
            "expected a point with 3 numbers as third entry, received 0",
        ),
        ({"end_time": 1, "step_size": 0.1, "outputs": ["mass"]}, r"write \(mass, 'position'\) for example"),
        ({"end_time": 1, "step_size": 0.1, "every": -1}, "every: expected a finite number that is not negative"),
    ):
        with pytest.raises(ValueError, match=f"model.solve: .*{expected}"):
            model.solve(**arguments)
    with pytest.raises(TypeError, match=r"settings: received 3, but expected db.SimulationSettings\(\)"):
        model.solve(1, 0.1, settings=3)
    solution = model.solve(0.01, 1e-3)
    with pytest.raises(AttributeError, match=r"solution\['mass'\] has no output 'positon'. Did you mean 'position'"):
        _ = solution["mass"].positon
    with pytest.raises(ValueError, match="belongs to another model"):
        solution[oscillator()["mass"]]


def test_doubts_are_warnings() -> None:
    """A spring that is far too stiff for the steps: the solver finishes, and does not trust the result."""
    model = db.Model()
    model.create_mass_point(name="mass", reference_position=[1, 0, 0], initial_displacement=[1e-3, 0, 0], mass=1)
    model.create_cartesian_spring_damper(
        body_numbers=["ground", "mass"], local_position0=[1, 0, 0], stiffness=[1e8, 1e8, 1e8]
    )
    settings = db.SimulationSettings()
    settings.timeIntegration.newton.relativeTolerance = settings.timeIntegration.newton.absoluteTolerance = 1e-30
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        solution = model.solve(1, 0.05, settings=settings)
    assert [str(each.message) for each in caught] == list(solution.warnings)


def test_warnings_of_solvers_are_those_of_python(capfd: pytest.CaptureFixture[str]) -> None:
    """A velocity that contradicts a joint, if the solution succeeds, and if it fails."""
    for end in (0.1, -1.0):
        model = db.Model()
        rod = model.create_box(size=[1, 0.1, 0.1], mass=3, reference_position=[0.5, 0, 0], initial_velocity=[0, 1, 0])
        model.create_revolute_joint(body_numbers=["ground", rod], position=[0, 0, 0], axis="z")
        if end < 0:
            model.create_force(
                body_number=rod, load_vector_user_function=lambda mbs, t, load: [0, np.nan if t > 0.05 else 0.0, 0]
            )
        with pytest.warns(db.SolutionWarning, match="the initial values contradict"):
            if end > 0:
                solution = model.solve(end_time=0.1, step_size=1e-2)
                assert "the initial values contradict" in solution.warnings[0]
            else:
                with pytest.raises(db.ModelError, match="loadVectorUserFunction"):
                    model.solve(end_time=0.1, step_size=1e-2)
    assert "Warning: " not in capfd.readouterr().out


def test_outputs_that_user_functions_may_change_are_announced() -> None:
    model = oscillator()

    def force(mbs: Any, t: float, number: int, u: Any, v: Any, k: Any, d: Any, offset: Any) -> list[float]:
        return [k[i] * u[i] for i in range(3)]

    model["spring"].spring_force_user_function = force
    solution = model.solve(0.01, 1e-3)
    with pytest.warns(db.SolutionWarning, match=r"solution\['spring'\].*spring_force_user_function keeps data"):
        assert solution["spring"].force.shape == (11, 3)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert solution["mass"].position.shape == (11, 3)
        assert solution["spring"].displacement.shape == (11, 3)  # it has been announced once


def test_failures_have_their_diagnosis() -> None:
    model = db.Model()
    model.create_mass_point(name="free", mass=1, gravity=[0, 0, -9.81])
    with pytest.raises(db.SolverError, match="free"):
        model.solve_static()


def test_solutions_are_pickled_with_their_model() -> None:
    model = oscillator()
    solution = model.solve(0.05, 1e-3)
    expected = solution["spring"].force
    other, again = pickle.loads(pickle.dumps((model, solution)))
    assert again["spring"].force == pytest.approx(expected, abs=0)
    assert again[other["mass"]].position == pytest.approx(solution["mass"].position, abs=0)


def test_the_package_loads_models_when_they_are_used() -> None:
    script = "import sys, dalembert; print(*(m for m in sys.modules if '._model' in m or m.endswith('_item_table')))"
    run = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    assert run.stdout.split() == []
