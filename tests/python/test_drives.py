"""Motors, PID controllers, stops of joints, prescribed motion and forces from tables, beside solutions of their equations."""

from __future__ import annotations

import pickle
import warnings
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import dalembert as exu
from dalembert import itemInterface as items
from dalembert import laws
from dalembert._snake_case import snake_case
from dalembert.utilities import CreateSymbolicUserFunction

Variable = exu.OutputVariableType
INERTIA = 0.5  # of the wheel about its axis, kg m^2


@pytest.fixture
def mbs() -> Any:
    return exu.SystemContainer().AddSystem()


def wheel_of(mbs: Any, speed: float = 0.0) -> tuple[Any, dict[str, Any]]:
    """Return a wheel on a hinge about a tilted axis, and the arguments that place a drive on it."""
    axis = np.array([0.0, 0.6, 0.8])
    ground = mbs.CreateGround()
    wheel = mbs.CreateCylinder(
        radius=1, length=0.1, mass=1, referenceRotationMatrix=exu.utilities.RotationMatrixX(-np.arcsin(0.6)),
        initialAngularVelocity=speed * axis,
    )  # fmt: skip
    place = {"bodyNumbers": [ground, wheel], "position": [0, 0, 0], "axis": 2 * axis}
    mbs.CreateRevoluteJoint(**place)
    return wheel, place


def slider_of(mbs: Any, mass: float = 2.0) -> tuple[Any, dict[str, Any]]:
    axis = np.array([0.6, 0.0, 0.8])
    ground = mbs.CreateGround()
    slider = mbs.CreateBox(size=[1, 1, 1], mass=mass)
    place = {"bodyNumbers": [ground, slider], "position": [0, 0, 0], "axis": axis}
    mbs.CreatePrismaticJoint(**place)
    return slider, place


def solve(mbs: Any, end: float, steps: int) -> None:
    if not mbs.systemIsConsistent:
        mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.solutionSettings.writeSolutionToFile = False
    settings.timeIntegration.endTime, settings.timeIntegration.numberOfSteps = end, steps
    settings.timeIntegration.generalizedAlpha.spectralRadius = 1
    assert mbs.SolveDynamic(settings)


def speed_of(mbs: Any, body: Any) -> float:
    omega = np.asarray(mbs.GetObjectOutputBody(body, Variable.AngularVelocity, [0, 0, 0]))
    return float(omega @ [0, 0.6, 0.8])


def way_of(mbs: Any, body: Any) -> float:
    return float(np.asarray(mbs.GetObjectOutputBody(body, Variable.Position, [0, 0, 0])) @ [0.6, 0, 0.8])


# ---- motors ----------------------------------------------------------------------------------------------------------
def test_a_torque_accelerates_rotor_and_stator(mbs: Any) -> None:
    wheel, place = wheel_of(mbs)
    motor = mbs.CreateMotor(**place, torque=3)
    solve(mbs, 1.5, 1500)
    assert speed_of(mbs, wheel) == pytest.approx(3 / INERTIA * 1.5, rel=1e-5)  # of second order, as all rotations here
    assert mbs.GetObjectOutput(motor, Variable.Rotation) == pytest.approx(0.5 * 3 / INERTIA * 1.5**2, rel=1e-5)
    assert mbs.GetObjectOutput(motor, Variable.TorqueLocal) == pytest.approx(-3, rel=1e-14)


def test_a_torque_of_a_table(mbs: Any) -> None:
    """The angular momentum is the integral of the spline."""
    wheel, place = wheel_of(mbs)
    times = np.linspace(0, 2, 41)
    mbs.CreateMotor(**place, torque=np.column_stack([times, np.sin(3 * times)]), smooth=True)
    solve(mbs, 2, 2000)
    assert speed_of(mbs, wheel) == pytest.approx((1 - np.cos(6)) / 3 / INERTIA, abs=1e-5)


def test_speed_control_is_a_first_order_lag(mbs: Any) -> None:
    """w = w_d (1 - exp(-d t / J))."""
    wheel, place = wheel_of(mbs)
    mbs.CreateMotor(**place, speed=20, damping=2)
    solve(mbs, 0.4, 2000)
    assert speed_of(mbs, wheel) == pytest.approx(20 * (1 - np.exp(-2 * 0.4 / INERTIA)), rel=1e-6)


def test_the_torque_of_speed_control_is_limited(mbs: Any) -> None:
    wheel, place = wheel_of(mbs)
    mbs.CreateMotor(**place, speed=1000, damping=50, maximumTorque=4)
    solve(mbs, 1, 1000)
    assert speed_of(mbs, wheel) == pytest.approx(4 / INERTIA, rel=1e-5)


def test_an_angle_over_several_turns(mbs: Any) -> None:
    """A set angle that grows linearly is followed exactly after the start: the gain of the rate removes the lag."""
    wheel, place = wheel_of(mbs)
    motor = mbs.CreateMotor(**place, angle=lambda t: 10 * t, stiffness=200, damping=40)
    solve(mbs, 3, 3000)
    assert mbs.GetObjectOutput(motor, Variable.Rotation) == pytest.approx(30, abs=1e-5)
    assert speed_of(mbs, wheel) == pytest.approx(10, abs=1e-4)


def test_a_ramp_avoids_the_jump_at_the_start(mbs: Any) -> None:
    wheel, place = wheel_of(mbs)
    motor = mbs.CreateMotor(**place, torque=3, ramp=0.5)
    mbs.Assemble()
    solve(mbs, 1.0, 1000)
    assert speed_of(mbs, wheel) == pytest.approx(3 / INERTIA * (0.25 + 0.5), rel=1e-5)  # half of the ramp, then all
    assert mbs.GetObjectOutput(motor, Variable.TorqueLocal) == pytest.approx(-3, rel=1e-12)


def test_gains_are_parameters(mbs: Any) -> None:
    wheel, place = wheel_of(mbs)
    motor = mbs.CreateMotor(**place, speed=20, damping=2)
    mbs.Assemble()
    mbs.SetObjectParameter(motor, "springTorqueUserFunction.damping", 4.0)
    solve(mbs, 0.4, 2000)
    assert speed_of(mbs, wheel) == pytest.approx(20 * (1 - np.exp(-4 * 0.4 / INERTIA)), rel=1e-5)


# ---- controllers -----------------------------------------------------------------------------------------------------
def test_a_pid_controller_removes_the_error_of_a_constant_load(mbs: Any) -> None:
    """J phi'' = -D phi' + P e + I z - M with z' = e, for a constant torque M: the solution of these equations."""
    wheel, place = wheel_of(mbs)
    mbs.CreatePIDController(**place, setPoint=0.7, P=30, I=60, D=8)
    mbs.CreateTorque(bodyNumber=wheel, loadVector=[0, -5 * 0.6, -5 * 0.8])
    solve(mbs, 1.0, 4000)

    def rates(t: float, x: Any) -> list[float]:
        error = 0.7 - x[0]
        return [x[1], (30 * error + 60 * x[2] - 8 * x[1] - 5) / INERTIA, error]

    exact = solve_ivp(rates, [0, 1], [0, 0, 0], rtol=1e-11, atol=1e-12).y[:, -1]
    assert speed_of(mbs, wheel) == pytest.approx(exact[1], abs=2e-6)
    states = mbs.systemData.GetODE1Coordinates()
    assert states == pytest.approx([exact[0], exact[2]], abs=2e-6)
    solve(mbs, 20, 4000)
    assert mbs.systemData.GetODE1Coordinates() == pytest.approx([0.7, 5 / 60], abs=1e-6)


def test_a_controller_turns_several_times(mbs: Any) -> None:
    wheel, place = wheel_of(mbs)
    mbs.CreatePIDController(**place, setPoint=[[0, 0], [4, 20], [20, 20]], P=100, I=10, D=30, ramp=0.1)
    solve(mbs, 20, 10000)
    assert mbs.systemData.GetODE1Coordinates()[0] == pytest.approx(
        20, abs=0.01
    )  # counts turns, the angle itself is exact
    assert speed_of(mbs, wheel) == pytest.approx(0, abs=1e-3)


def test_a_limited_controller_does_not_wind_up(mbs: Any) -> None:
    """While the output is at its limit the slider accelerates uniformly, and the integral rests."""
    slider, place = slider_of(mbs)
    mbs.CreatePIDController(**place, setPoint=100, P=10, I=5, D=1, limit=4, kind="translation")
    solve(mbs, 2, 200)
    assert way_of(mbs, slider) == pytest.approx(0.5 * 4 / 2 * 4, rel=1e-6)
    assert mbs.systemData.GetODE1Coordinates()[0] == 0


def test_a_controller_of_a_displacement(mbs: Any) -> None:
    slider, place = slider_of(mbs)
    mbs.CreatePIDController(**place, setPoint=lambda t: np.sin(t), P=40, D=20, kind="translation")
    mbs.CreateForce(bodyNumber=slider, loadVector=[6, 0, 8])
    solve(mbs, 2, 4000)

    def rates(t: float, x: Any) -> list[float]:
        return [x[1], (40 * (np.sin(t) - x[0]) + 20 * (np.cos(t) - x[1]) + 10) / 2]

    assert way_of(mbs, slider) == pytest.approx(
        solve_ivp(rates, [0, 2], [0, 0], rtol=1e-11, atol=1e-12).y[0, -1], abs=1e-6
    )


# ---- stops -----------------------------------------------------------------------------------------------------------
def test_a_wheel_rebounds_from_a_stop(mbs: Any) -> None:
    """Without damping, it comes back with the same speed after half a period of the stop."""
    wheel, place = wheel_of(mbs, speed=2)
    mbs.CreateJointStops(**place, upper=0.5, lower=-0.5, stiffness=500)
    omega = np.sqrt(500 / INERTIA)
    solve(mbs, 0.25 + np.pi / omega + 0.1, 4000)
    assert speed_of(mbs, wheel) == pytest.approx(-2, rel=1e-4)
    angle = 0.5 - 2 * 0.1
    at = mbs.GetObjectOutputBody(wheel, Variable.RotationMatrix, [0, 0, 0]).reshape(3, 3)
    start = exu.utilities.RotationMatrixX(-np.arcsin(0.6))
    assert np.arccos((np.trace(start.T @ at) - 1) / 2) == pytest.approx(angle, abs=1e-3)


def test_a_load_rests_on_a_damped_stop(mbs: Any) -> None:
    slider, place = slider_of(mbs)
    mbs.CreateForce(bodyNumber=slider, loadVector=[-6, 0, -8])
    mbs.CreateJointStops(**place, lower=-0.1, stiffness=1000, damping=60, kind="translation")
    solve(mbs, 3, 3000)
    assert way_of(mbs, slider) == pytest.approx(-0.1 - 10 / 1000, abs=1e-6)


# ---- prescribed motion -----------------------------------------------------------------------------------------------
@pytest.mark.parametrize("given", ["function", "table"])
def test_a_prescribed_displacement_needs_the_force_of_its_acceleration(mbs: Any, given: str) -> None:
    """m a = m (-0.1 w^2 cos(w t)) of the motion 0.1 (1 - cos(w t)), which starts at rest."""
    slider, place = slider_of(mbs)
    times = np.linspace(0, 1, 201)
    motion = (lambda t: 0.1 * (1 - np.cos(8 * t))) if given == "function" else np.column_stack([times, 0.1 * (1 - np.cos(8 * times))])  # fmt: skip
    drive = mbs.CreatePrescribedMotion(**place, motion=motion)
    solve(mbs, 0.7, 2000)
    assert way_of(mbs, slider) == pytest.approx(0.1 * (1 - np.cos(5.6)), abs=1e-7)  # error of the spline
    force = np.asarray(mbs.GetObjectOutput(drive, Variable.WrenchOnMarker1))[:3] @ [0.6, 0, 0.8]
    assert force == pytest.approx(2 * 0.1 * 64 * np.cos(5.6), abs=5e-3)


def test_a_prescribed_rotation(mbs: Any) -> None:
    wheel, place = wheel_of(mbs)
    drive = mbs.CreatePrescribedMotion(**place, motion=lambda t: 0.5 * (1 - np.cos(3 * t)), kind="rotation")
    solve(mbs, 0.9, 1000)
    assert speed_of(mbs, wheel) == pytest.approx(1.5 * np.sin(2.7), abs=1e-5)
    torque = np.asarray(mbs.GetObjectOutput(drive, Variable.WrenchOnMarker1))[3:] @ [0, 0.6, 0.8]
    assert torque == pytest.approx(INERTIA * 4.5 * np.cos(2.7), abs=1e-3)


# ---- tables ----------------------------------------------------------------------------------------------------------
def test_a_force_of_a_file(mbs: Any, tmp_path: Path) -> None:
    """The impulse of a trapezoid is that of the table; header, comments and several separators are read."""
    file = tmp_path / "force.csv"
    file.write_text("time, force\n# measured\n0, 0\n0.1; 50\n0.3 50\n\n0.4,0  # end\n")
    ball = mbs.CreateSphere(radius=0.1, mass=5)
    mbs.CreateForceFromTable(bodyNumber=ball, table=file, direction=[0, 3, 4])
    solve(mbs, 0.5, 500)
    velocity = mbs.GetObjectOutputBody(ball, Variable.Velocity, [0, 0, 0])
    assert velocity == pytest.approx(15 / 5 * np.array([0, 0.6, 0.8]), rel=1e-6)


def test_rows_that_are_no_numbers_are_refused(mbs: Any, tmp_path: Path) -> None:
    for content, text in (("t,F\n0,1\nabc\n1,2\n", "numbers in line 3"), ("0,1\nnan,7\n2,3\n", "finite numbers")):
        file = tmp_path / "wrong.csv"
        file.write_text(content)
        with pytest.raises(ValueError, match=text):
            mbs.CreateForceFromTable(bodyNumber=mbs.CreateSphere(mass=1), table=file)
    file.write_bytes(b"\xef\xbb\xbft,F\n0,1\n1,2\n")  # a byte order mark
    mbs.CreateForceFromTable(bodyNumber=mbs.CreateSphere(mass=1), table=file)


def test_motors_of_planar_bodies_turn_about_z(mbs: Any) -> None:
    bodies = [mbs.CreateGround(), mbs.CreateBox(mass=1, create2D=True)]
    with pytest.raises(ValueError, match="'axis': expected an axis of the plane"):
        mbs.CreateMotor(bodyNumbers=bodies, position=[0, 0, 0], axis=[1, 0, 0], torque=1)


def test_a_torque_of_a_table_about_an_axis(mbs: Any) -> None:
    ball = mbs.CreateSphere(radius=0.5, mass=5)
    mbs.CreateTorqueFromTable(bodyNumber=ball, table=[[0, 0], [1, 2]], direction=[0, 0, 3])
    solve(mbs, 1, 1000)
    assert mbs.GetObjectOutputBody(ball, Variable.AngularVelocity, [0, 0, 0])[2] == pytest.approx(1 / 0.5, rel=1e-6)


def test_drives_are_pickled(mbs: Any) -> None:
    wheel, place = wheel_of(mbs)
    mbs.CreateMotor(**place, torque=[[0, 0], [1, 3]])
    mbs.CreatePIDController(**place, setPoint=0.3, P=10, I=5, D=1)
    mbs.Assemble()
    copied = pickle.loads(pickle.dumps(mbs))
    for each in (mbs, copied):
        solve(each, 0.5, 50)
    assert speed_of(copied, wheel) == speed_of(mbs, wheel) != 0


@pytest.mark.parametrize(
    ("name", "arguments", "text"),
    [
        ("CreateMotor", {}, "one of torque, speed and angle, received None"),
        ("CreateMotor", {"torque": 1, "speed": 2}, r"one of torque, speed and angle, received \['speed', 'torque'\]"),
        ("CreateMotor", {"speed": 2}, "'damping': expected a gain greater than zero .Nms/rad., as speed is given"),
        ("CreateMotor", {"angle": 2, "damping": 1}, "'stiffness': expected a gain greater than zero"),
        ("CreateMotor", {"torque": 2, "damping": 1}, "'damping': expected no gain, as torque is given"),
        ("CreateMotor", {"torque": [[0, 1], [0, 2]]}, r"increasing times \(row 1 does not\)"),
        ("CreateMotor", {"torque": [1, 2, 3]}, "two columns"),
        ("CreateMotor", {"torque": "nowhere.csv"}, "a file that can be read, received 'nowhere.csv: No such file"),
        ("CreateMotor", {"torque": float("nan")}, "two columns"),
        ("CreatePIDController", {"setPoint": 1}, "'P': expected a gain that is not zero"),
        ("CreatePIDController", {"P": 1, "kind": "both"}, "'rotation' or 'translation'"),
        ("CreatePIDController", {"P": 1, "limit": -1}, "'limit'.*greater than zero"),
        ("CreateJointStops", {"stiffness": 1}, "'lower': expected a number, or one for upper"),
        ("CreateJointStops", {"stiffness": 1, "lower": 1, "upper": 0}, "a number below upper=0"),
        ("CreateJointStops", {"lower": 1, "stiffness": 0}, "'stiffness'.*greater than zero"),
        ("CreatePrescribedMotion", {"motion": "a.csv"}, "a file that can be read"),
        ("CreatePrescribedMotion", {"motion": None}, "'motion'.*two columns"),
        ("CreatePrescribedMotion", {"motion": 0.0, "kind": 1}, "'rotation' or 'translation'"),
    ],
)
def test_wrong_drives_are_refused(mbs: Any, name: str, arguments: dict[str, Any], text: str) -> None:
    _, place = wheel_of(mbs)
    before = [mbs.systemData.NumberOfObjects(), mbs.systemData.NumberOfMarkers(), mbs.systemData.NumberOfNodes()]
    with pytest.raises(ValueError, match=text):
        getattr(mbs, name)(**place, **arguments)
    after = [mbs.systemData.NumberOfObjects(), mbs.systemData.NumberOfMarkers(), mbs.systemData.NumberOfNodes()]
    assert after == before


@pytest.mark.parametrize(
    ("arguments", "text"),
    [
        ({"table": [[0, 1]]}, "at least two rows"),
        ({"table": [[0, 1], [1, 2]], "direction": [0, 0, 0]}, "direction.*not zero"),
        ({"table": [[0, 1], [1, np.inf]]}, "finite numbers"),
    ],
)
def test_wrong_tables_are_refused(mbs: Any, arguments: dict[str, Any], text: str) -> None:
    with pytest.raises(ValueError, match=text):
        mbs.CreateForceFromTable(bodyNumber=mbs.CreateSphere(mass=1), **arguments)


def test_tables_are_converted_once(mbs: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    """A table of 1e5 rows takes 0.2 s or so; it is the same one in all components of a force."""
    calls: list[Any] = []
    interpolate = laws.interpolate

    def counted(*given: Any) -> Any:
        calls.append(given)
        return interpolate(*given)

    monkeypatch.setattr(laws, "interpolate", counted)
    mbs.CreateForceFromTable(bodyNumber=mbs.CreateSphere(mass=1), table=[[0, 0], [1, 2]], direction=[1, 2, 3])
    assert len(calls) == 1


def test_functions_that_cannot_be_recorded_are_refused(mbs: Any) -> None:
    _, place = wheel_of(mbs)
    for name, argument in (("CreateMotor", "torque"), ("CreatePrescribedMotion", "motion")):
        with pytest.raises(TypeError, match="cannot be recorded.*where"):
            getattr(mbs, name)(**place, **{argument: lambda t: 1.0 if t > 1 else 0.0})


def test_parameters_that_a_law_replaces_are_refused(mbs: Any) -> None:
    """They would have no effect; constants of the law, and parameters of items without one, can be set."""
    model = exu.Model(mbs)
    wheel, place = wheel_of(mbs)
    motor = model.create_motor("motor", *place.values(), speed=2.0, damping=3.0)
    push = model.create_force_from_table("push", "object1", table=[[0, 1], [1, 2]])
    spring = model.create_torsional_spring_damper("spring", *place.values(), stiffness=1.0)
    assert wheel == model.bodies[0]
    motor.damping, spring.stiffness = 4.0, 2.0
    assert motor.parameters["spring_torque_user_function.damping"] == 4.0 and spring.stiffness == 2.0
    for set_it, text in (
        (
            lambda: setattr(motor, "stiffness", 1.0),
            "'motor'.*stiffness has no effect, because the law in spring_torque_",
        ),
        (
            lambda: motor.parameters.__setitem__("torque", 1.0),
            "Set a constant of the law: 'spring_torque_user_function.d",
        ),
        (
            lambda: setattr(push, "load_vector", [1, 0, 0]),
            "'push'.*load_vector has no effect.*Create the item with ano",
        ),
    ):
        with pytest.raises(ValueError, match=text):
            set_it()
    assert motor.parameters.torque == motor.stiffness == 0


LAWS: dict[str, tuple[Any, list[str]]] = {
    "points": (lambda u, v, t: u, ["offset"]),
    "line": (lambda L, L_t, t: L, ["referenceLength"]),
    "frames": (lambda u, phi, v, omega, t: (u, phi), []),
    "rotation": (lambda phi, omega, t: phi, []),
}


@pytest.mark.parametrize("kind", LAWS)
def test_refused_parameters_are_those_without_effect(kind: str) -> None:
    """A change of any stiffness, damping, force or offset: those that change the motion can be set, and no others."""
    function, read = LAWS[kind]
    law = laws.connector(kind)(function)

    def made() -> Any:
        model = exu.Model()
        model.create_box("body", mass=1, reference_position=[1, 0.2, 0.1], initial_velocity=[0.1, 0.2, 0.3])
        mbs = model.system
        markers = [mbs.AddMarker(items.MarkerBodyRigid(bodyNumber=number)) for number in ("ground", "body")]
        turns = {}
        if kind == "rotation":
            data = items.NodeGenericData(initialCoordinates=[0], numberOfDataCoordinates=1)
            turns["nodeNumber"] = mbs.AddNode(data)
        mbs.AddObject(law(markers, name="law", **turns))
        return model

    def motion(model: Any) -> Any:
        model.solve(end_time=0.05, step_size=0.01)
        return model.system.systemData.GetODE2Coordinates()

    usual = motion(made())
    with_effect = []
    for name in made().system.GetObject("law"):
        if not name.startswith(("stiffness", "damping", "force", "torque", "offset", "velocityOffset", "reference")):
            continue
        if "Function" in name:
            continue
        model = made()
        value = np.asarray(model.system.GetObjectParameter("law", name), dtype=float) + 0.3
        model.system.SetObjectParameter("law", name, value.tolist())
        if np.abs(motion(model) - usual).max() > 1e-12:
            with_effect.append(name)
            model["law"].parameters[snake_case(name)] = value.tolist()
        else:
            with pytest.raises(ValueError, match=f"{snake_case(name)} has no effect"):
                model["law"].parameters[snake_case(name)] = value.tolist()
    assert with_effect == read


def test_parameters_that_a_recorded_user_function_reads_can_be_set(mbs: Any) -> None:
    """It is no law of dalembert.laws, and gets the parameters as arguments."""
    _, place = wheel_of(mbs)
    spring = exu.Model(mbs).create_torsional_spring_damper("spring", *place.values(), stiffness=1.0)
    number = mbs.GetObjectNumber("spring")
    function = CreateSymbolicUserFunction(
        mbs, lambda mbs, t, item, phi, omega, k, d, offset: k * phi, "springTorqueUserFunction", number
    )
    mbs.SetObjectParameter(number, "springTorqueUserFunction", function)
    spring.stiffness = 2.0
    assert mbs.GetObjectParameter(number, "stiffness") == 2.0


def test_axes_that_a_joint_does_not_allow_are_refused() -> None:
    """Such a motor would do nothing, as its torque is that of the joint."""
    model = exu.Model()
    arm = model.create_box("arm", size=[1, 0.1, 0.1], mass=2, reference_position=[0.5, 0, 0])
    place: dict[str, Any] = {"body_numbers": ["ground", arm], "position": [0, 0, 0]}
    model.create_motor(**place, axis="x", torque=1.0)  # without a joint, all axes are free
    hinge = model.create_revolute_joint("hinge", **place, axis="-z")
    for axis in ("z", "-z", [0, 0, 3]):
        model.create_motor(**place, axis=axis, torque=1.0)
    for make, given in (
        (model.create_motor, {"torque": 1.0}),
        (model.create_pid_controller, {"P": 1.0}),
        (model.create_joint_stops, {"lower": -1.0, "stiffness": 1.0}),
        (model.create_prescribed_motion, {"kind": "rotation"}),
    ):
        with pytest.raises(
            ValueError,
            match=r"'axis': expected the axis \[.*-1.*\] \(global frame\) of joint \d+ 'hinge' between these",
        ):
            make(**place, axis="x", **given)
    hinge.active_connector = False
    model.create_motor(**place, axis="x", torque=1.0)
    model.delete(hinge)
    model.create_prismatic_joint("rail", **place, axis="x")
    with pytest.raises(ValueError, match="bodies that can turn, which the prismatic joint .* 'rail' .* does not allow"):
        model.create_motor(**place, axis="x", torque=1.0)
    model.create_pid_controller(**place, axis="x", kind="translation", P=1.0)
    for axis in ("y", [0, 1, -2]):
        with pytest.raises(
            ValueError, match=r"'axis': expected the axis \[1. 0. 0.\] \(global frame\) of joint .*'rail'"
        ):
            model.create_prescribed_motion(**place, axis=axis, motion=0.1)
    model.delete("rail")
    model.create_fixed_joint("weld", body_numbers=["ground", arm])
    for kind in ("translation", "rotation"):
        with pytest.raises(ValueError, match="bodies that can move, which the fixed joint .* 'weld' .* does not allow"):
            model.create_prescribed_motion(**place, axis="x", kind=kind, motion=0.1)
    model.delete("weld")
    rail = model.create_prismatic_joint("rail", **place, axis="x")
    assert rail is not None
    with pytest.raises(ValueError, match=r"'body_numbers\[1\]': expected a body or marker with position .*'rail'"):
        model.create_motor(body_numbers=["ground", "rail"], position=[0, 0, 0], axis="x", torque=1.0)


def test_drives_of_mass_points_are_refused() -> None:
    model = exu.Model()
    place: dict[str, Any] = {"position": [0, 0, 0], "axis": "z"}
    for planar in (False, True):
        mass = model.create_mass_point(f"mass{planar}", mass=1, create_2d=planar)
        with pytest.raises(
            ValueError, match=r"'body_numbers\[1\]': expected a rigid body, such as a sphere, .*'mass(False|True)'"
        ):
            model.create_prescribed_motion(body_numbers=["ground", mass], **place, motion=0.1)


def test_drives_without_effect_are_refused_or_announced() -> None:
    model = exu.Model()
    wheel = model.create_cylinder("wheel", radius=1, length=0.1, mass=1)
    place: dict[str, Any] = {"body_numbers": ["ground", wheel], "position": [0, 0, 0], "axis": "z"}
    with pytest.raises(
        ValueError, match="create_joint_stops: argument 'stiffness': expected a number greater than zero"
    ):
        model.create_joint_stops(**place, lower=-1.0)
    for create in (model.create_force_from_table, model.create_torque_from_table):
        with pytest.raises(ValueError, match="argument 'table': expected a number, a table .*, received None"):
            create(body_number=wheel)
        create(body_number=wheel, table=0.0)  # such as the first one of a series
    with pytest.warns(
        UserWarning, match="lower=0.5, upper=1: the reference configuration, where the angle is 0, is beyo"
    ):
        model.create_joint_stops(**place, lower=0.5, upper=1, stiffness=1.0)


def test_splines_that_overshoot_are_announced() -> None:
    """The spline through a step between two long lines goes far beyond; one through samples of a sine does not."""
    model = exu.Model()
    body = model.create_box("body", mass=1)
    place: dict[str, Any] = {"body_numbers": ["ground", body], "position": [0, 0, 0], "axis": "z"}
    step = [[0, 0], [0.5, 0], [0.7, 0.05], [3, 0.05]]
    spline = laws.interpolate(np.linspace(0, 3, 2001), *np.transpose(step), True)
    with pytest.warns(
        UserWarning,
        match=r"CreatePrescribedMotion: motion: the spline through the table reaches (0\.\d+) at t = .*smooth=False",
    ) as got:
        model.create_prescribed_motion(**place, motion=step)
    reached = float(str(got[0].message).partition("reaches ")[2].split()[0])
    assert reached == pytest.approx(spline.max(), rel=0.01)  # nine samples in each part: within 1 % of the maximum
    assert got[0].filename == __file__
    t = np.linspace(0, 2, 13)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        model.create_prescribed_motion(**place, motion=np.column_stack([t, np.sin(2 * np.pi * t + 0.3)]))
        model.create_prescribed_motion(**place, motion=step, smooth=False)


def test_errors_of_functions_name_argument_and_line() -> None:
    model = exu.Model()
    wheel = model.create_cylinder("wheel", radius=1, length=0.1, mass=1)
    place: dict[str, Any] = {"body_numbers": ["ground", wheel], "position": [0, 0, 0], "axis": "z"}
    for function, text in (
        (
            lambda t: 1.0 if t > 1 else 0.0,
            r"argument 'torque' cannot be recorded: test_drives.py, line \d+ .*Use where\(",
        ),
        (lambda t: np.interp(t, [0, 1], [0, 1]), r"test_drives.py, line \d+ .*interpolate\(x, xs, ys\) .* np.interp"),
        (lambda t: None, "argument 'torque': expected a function of t that returns a number, received None"),
        (lambda: 1.0, r"argument 'torque' cannot be recorded: test_drives.py, line \d+ .*takes 0 positional"),
    ):
        with pytest.raises(TypeError, match=f"model.create_motor: .*{text}"):
            model.create_motor(**place, torque=function)
    with pytest.raises(
        TypeError, match=r"model.create_prescribed_motion: argument 'motion' cannot be recorded: test_dri"
    ):
        model.create_prescribed_motion(**place, motion=lambda t: abs(t) if t else 0)
