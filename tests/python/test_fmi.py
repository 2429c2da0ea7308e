"""FMUs of models, simulated by fmpy, beside solutions of the models; FMUs as controllers, beside exact sampled motion."""

from __future__ import annotations

import importlib
import os
import pickle
import re
import subprocess
import sys
import threading
import warnings
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.linalg import expm

import dalembert as db

fmpy = pytest.importorskip("fmpy")
validate_fmu = pytest.importorskip("fmpy.validation").validate_fmu
pytest.importorskip("pythonfmu")
pytest.importorskip("pythonfmu3")

OMEGA, DAMPING, MASS = 20.0, 0.1, 1.5  # undamped angular frequency (rad/s), damping ratio, mass (kg)
VERSIONS = ("2.0", "3.0")
PERIOD, SAMPLES = 5e-3, 200  # s, of a controller
STIFFNESS, GAIN = 300.0, 8.0  # N/m, Ns/m, of a PD controller


def oscillator() -> Any:
    """Return a mass on a spring and damper along x, at rest 0.1 m from its equilibrium, with a force and a sensor."""
    model = db.Model()
    mass = model.create_mass_point("mass", reference_position=[1, 0, 0], initial_displacement=[0.1, 0, 0], mass=MASS)
    model.create_cartesian_spring_damper(
        name="spring",
        body_numbers=["ground", mass],
        local_position0=[1, 0, 0],
        stiffness=[MASS * OMEGA**2, 1, 1],
        damping=[2 * DAMPING * OMEGA * MASS, 0, 0],
    )
    model.create_force("push", mass)
    model.create_sensor("mass", "velocity", name="speed")
    return model


def displacement(t: Any) -> Any:
    """Return the free vibration from 0.1 m at rest."""
    damped = OMEGA * np.sqrt(1 - DAMPING**2)
    decay = 0.1 * np.exp(-DAMPING * OMEGA * t)
    return decay * (np.cos(damped * t) + DAMPING * OMEGA / damped * np.sin(damped * t))


def sampled(law: Any) -> Any:
    """Return displacements and velocities at samples of the oscillator with a force that is held between them."""
    system = np.array([[0, 1, 0], [-(OMEGA**2), -2 * DAMPING * OMEGA, 1 / MASS], [0, 0, 0]])
    step, states = expm(PERIOD * system), [np.array([0.1, 0.0])]
    for k in range(SAMPLES):
        states.append((step @ [*states[-1], law(k * PERIOD, *states[-1])])[:2])
    return np.array(states)


SLAVE = """
from pythonfmu{other} import Fmi{n}Slave, {real}, Boolean, Fmi{n}Causality as causality, Fmi{n}Variability as variability

class Controller(Fmi{n}Slave):
    def __init__(self, **options):
        super().__init__(**options)
        self.x = self.v = self.force = self.time = 0.0
        self.stiffness, self.gain, self.on = 1.0, 0.0, True
        for name in ("x", "v"):
            self.register_variable({real}(name, causality=causality.input))
        self.register_variable({real}("force", causality=causality.output))
        for name in ("stiffness", "gain"):
            self.register_variable({real}(name, causality=causality.parameter, variability=variability.tunable))
        self.register_variable(Boolean("on", causality=causality.input, variability=variability.discrete))
        if "{n}" == "3":
            self.register_variable({real}("time", causality=causality.independent))

    def do_step(self, t, h):
        {body}
"""
LAW = "self.force = -self.stiffness * self.x - self.gain * self.v\n        return True"


def controller(folder: Path, version: str, body: str = LAW) -> Path:
    """Return the file of an FMU with a controller of force = -stiffness x - gain v, or of another law."""
    n, other = version[0], "" if version == "2.0" else "3"
    script = folder / "controller.py"
    script.write_text(SLAVE.format(n=n, other=other, real="Real" if n == "2" else "Float64", body=body))
    paths = list(sys.path)
    try:
        return Path(importlib.import_module(f"pythonfmu{other}.builder").FmuBuilder.build_FMU(script, folder))
    finally:
        sys.path[:] = paths
        sys.modules.pop("controller", None)


def controlled(fmu: Path) -> Any:
    model = oscillator()
    values = {"stiffness": STIFFNESS, "gain": GAIN}
    model.add_fmu(
        fmu, {"x": ("mass", "displacement", 0), "v": ("speed", 0)}, {"force": ("push", 0)}, PERIOD, values=values
    )
    return model


def at_samples(solution: Any) -> Any:
    rows = [np.abs(solution.times - k * PERIOD).argmin() for k in range(SAMPLES + 1)]
    assert np.abs(solution.times[rows] - PERIOD * np.arange(SAMPLES + 1)).max() < 1e-9 * PERIOD
    return solution["mass"].displacement[rows, 0]


# ---- models as FMUs


@pytest.mark.parametrize("version", VERSIONS)
@pytest.mark.parametrize("method", ["generalized_alpha", "rk44"])
def test_an_exported_model_moves_like_the_model(tmp_path: Path, version: Any, method: str) -> None:
    """The solution has the bits of that of the model, and is near the analytic one.

    Errors are 0.1 m (omega h)^4 / 120 per radian of RK44, and 0.1 m (omega h)^2 / 12 of generalized alpha, over 20 rad.
    """
    model = oscillator()
    outputs = {"x": ("mass", "displacement", 0), "v": "speed", "a": ("mass", "acceleration", 0)}
    model.export_fmu(tmp_path / "oscillator.fmu", {}, outputs, 1e-3, version=version, method=method)
    own = model.solve(1, 1e-3, method=method)
    before = threading.enumerate()
    found = fmpy.simulate_fmu(str(tmp_path / "oscillator.fmu"), stop_time=1, output_interval=0.01)
    assert found.dtype.names == ("time", "x", "v[1]", "v[2]", "v[3]", "a")
    assert np.array_equal(found["x"], own["mass"].displacement[::10, 0])
    assert np.array_equal(found["v[1]"], own["speed"].values[::10, 0])
    assert np.array_equal(found["a"], own["mass"].acceleration[::10, 0])
    accuracy = 1e-8 if method == "rk44" else 1e-4
    assert np.abs(found["x"] - displacement(found["time"])).max() < accuracy
    assert threading.enumerate() == before


@pytest.mark.parametrize("version", VERSIONS)
def test_inputs_and_parameters_of_an_exported_model(tmp_path: Path, version: Any) -> None:
    """A force that is held during communication steps moves the oscillator like the exact solution of sampled motion."""
    oscillator().export_fmu(
        tmp_path / "a model.fmu",
        {"force": ("push", "load_vector", 0)},
        {"x": ("mass", "displacement", 0), "load": ("push", "value")},
        1e-3,
        parameters={"mass": ("mass", "physics_mass"), "k": ("spring", "stiffness")},
        version=version,
        method="rk44",
    )
    assert validate_fmu(str(tmp_path / "a model.fmu")) == []
    times = PERIOD * np.arange(SAMPLES + 1)
    forces = 50 * np.sin(7 * times + 0.5)
    signals = np.array(list(zip(times, forces, strict=True)), dtype=[("time", float), ("force", float)])
    expected = sampled(lambda t, x, v: forces[round(t / PERIOD)])
    for start_values, factor in (({}, 1.0), ({"mass": 2 * MASS, "k[1]": 2 * MASS * OMEGA**2}, 0.5)):
        found = fmpy.simulate_fmu(
            str(tmp_path / "a model.fmu"),
            stop_time=times[-1],
            output_interval=PERIOD,
            input=signals,
            start_values=start_values,
        )
        if factor == 1:
            # Forces are those of the beginning of steps, and 20 rad/s with steps of 1 ms have an error of 1e-8.
            assert np.abs(found["x"] - expected[:, 0]).max() < 1e-8
            assert np.abs(found["load[1]"][1:] - forces[:-1]).max() < 1e-12
        else:
            system = [[0, 1, 0], [-(OMEGA**2), -DAMPING * OMEGA, 0.5 / MASS], [0, 0, 0]]
            state, step = np.array([0.1, 0.0]), expm(PERIOD * np.array(system))
            for k in range(SAMPLES):
                state = (step @ [*state, forces[k]])[:2]
            assert abs(found["x"][-1] - state[0]) < 1e-8


@pytest.mark.parametrize("interval", [0.02, 0.1])
def test_steps_of_error_control_end_at_communication_points(tmp_path: Path, interval: float) -> None:
    model = oscillator()
    settings = db.SimulationSettings()
    settings.timeIntegration.relativeTolerance = settings.timeIntegration.absoluteTolerance = 1e-10
    signals: Any = {"x": ("mass", "displacement", 0)}
    model.export_fmu(tmp_path / "o.fmu", {}, signals, 0.02, method="dopri5", settings=settings)
    found = fmpy.simulate_fmu(str(tmp_path / "o.fmu"), stop_time=2, output_interval=interval)
    assert len(found) == round(2 / interval) + 1
    assert np.abs(found["x"] - displacement(found["time"])).max() < 1e-9


@pytest.mark.parametrize("version", VERSIONS)
def test_steps_that_leave_the_grid_end_at_communication_points(tmp_path: Path, version: Any) -> None:
    """An event of the model at an odd time switches a force on; steps of equal size go on from there."""
    model = oscillator()
    model.system.SetEventsUserFunction(odd_time)
    model.system.SetEventActionUserFunction(switch_on)
    model.export_fmu(tmp_path / "o.fmu", {}, {"x": ("mass", "displacement", 0)}, 1e-3, version=version, method="rk44")
    found = fmpy.simulate_fmu(str(tmp_path / "o.fmu"), stop_time=0.5, output_interval=5e-3)
    system = np.array([[0, 1, 0], [-(OMEGA**2), -2 * DAMPING * OMEGA, 30 / MASS], [0, 0, 0]])
    before = [expm(system * min(t, 0.1234)) @ [0.1, 0, 0] for t in found["time"]]
    states = [expm(system * max(t - 0.1234, 0)) @ [x, v, 1] for t, (x, v, _) in zip(found["time"], before, strict=True)]
    assert np.abs(found["x"] - np.array(states)[:, 0]).max() < 1e-8
    assert found["time"][-1] == 0.5


def odd_time(mbs: Any, t: float) -> Any:
    return [t - 0.1234]


def switch_on(mbs: Any, t: float, event: int, direction: int) -> bool:
    assert event == 0
    mbs.SetLoadParameter("push", "loadVector", [30, 0, 0])
    return True


@pytest.mark.parametrize("version", VERSIONS)
def test_an_exported_model_starts_where_the_model_would(tmp_path: Path, version: Any) -> None:
    """The initial state of an earlier solution, user functions and the start time are those of the model."""
    model = oscillator()
    model["spring"].spring_force_user_function = spring
    model.solve(0.3, 1e-3, method="rk44", update_initial_values=True)
    signals: Any = {"x": ("mass", "displacement", 0)}
    model.export_fmu(tmp_path / "o.fmu", {}, signals, 1e-3, version=version, method="rk44")
    found = fmpy.simulate_fmu(str(tmp_path / "o.fmu"), start_time=0.3, stop_time=0.8, output_interval=0.01)
    own = model.solve(0.8, 1e-3, start_time=0.3, method="rk44")
    assert np.abs(found["x"] - own["mass"].displacement[::10, 0]).max() < 1e-14


def spring(mbs: Any, t: float, item: int, u: Any, v: Any, k: Any, d: Any, offset: Any) -> Any:
    return [k[0] * u[0] + 1e4 * u[0] ** 3, k[1] * u[1], k[2] * u[2] + 0 * np.cos(t)]


@pytest.mark.parametrize("version", VERSIONS)
def test_an_exported_model_in_a_model(tmp_path: Path, version: Any) -> None:
    """The displacement of a mass under a constant force, at the end of each period, is a force on the other mass."""
    inner = db.Model()
    inner.create_mass_point("mass", mass=1)
    inner.create_force("push", "mass")
    signals: Any = ({"force": ("push", 0)}, {"x": ("mass", "displacement", 0)})
    inner.export_fmu(tmp_path / "inner.fmu", *signals, 1e-3, version=version, method="rk44")
    before = threading.enumerate()
    model = oscillator()
    model["spring"].stiffness = [MASS * OMEGA**2, 0, 0]
    model.create_force("constant", "mass", load_vector=[0, 2, 0])
    model.create_sensor("constant", name="two")
    model.add_fmu(tmp_path / "inner.fmu", {"force": ("two", 1)}, {"x": ("push", 2)}, PERIOD)
    z = speed = 0.0
    for k in range(1, SAMPLES + 1):
        force = (k * PERIOD) ** 2
        z, speed = z + PERIOD * speed + PERIOD**2 / 2 * force / MASS, speed + PERIOD * force / MASS
    for _ in range(2):
        solution = model.solve(PERIOD * SAMPLES, PERIOD, method="rk44")
        assert abs(solution["mass"].displacement[-1, 2] - z) < 1e-12
    assert threading.enumerate() == before


@pytest.mark.parametrize("version", VERSIONS)
def test_errors_of_exported_models(tmp_path: Path, version: Any) -> None:
    """Messages reach the simulator: steps of wrong size, and solvers that fail."""
    model = oscillator()
    model["spring"].spring_force_user_function = failing
    model.export_fmu(tmp_path / "o.fmu", {}, {"x": ("mass", "displacement", 0)}, 1e-2, version=version, method="rk44")
    for interval, text in ((0.015, "multiple of the step size of the model, 0.01 s"), (0.01, "beyond 0.2 s")):
        messages: list[str] = []
        with pytest.raises(Exception, match=r"DoStep failed with status [34] \((error|fatal)\)"):
            fmpy.simulate_fmu(
                str(tmp_path / "o.fmu"),
                stop_time=0.6,
                output_interval=interval,
                debug_logging=True,
                logger=lambda *given, messages=messages: messages.append(str(given[-1])),
            )
        assert text in messages[0], messages


def failing(mbs: Any, t: float, item: int, u: Any, v: Any, k: Any, d: Any, offset: Any) -> Any:
    if t > 0.2:
        raise ValueError("the spring is beyond 0.2 s")
    return [k[0] * u[0], 0, 0]


def test_an_instance_that_is_not_terminated_does_not_hold_the_process(tmp_path: Path) -> None:
    oscillator().export_fmu(tmp_path / "o.fmu", {}, {"x": ("mass", "displacement", 0)}, 1e-2)
    script = f"""
import fmpy
from fmpy.simulation import instantiate_fmu
file = {str(tmp_path / "o.fmu")!r}
fmu = instantiate_fmu(fmpy.extract(file, {str(tmp_path / "files")!r}), fmpy.read_model_description(file))
fmu.setupExperiment(startTime=0.0)
fmu.enterInitializationMode()
fmu.exitInitializationMode()
fmu.doStep(0.0, 0.1)
print(fmu.getReal([0]))
"""
    run = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=60, check=True)
    # generalized alpha with steps of 0.01 s, omega h = 0.2: 1 % of the amplitude
    assert abs(float(run.stdout.strip("[]\n")) - displacement(0.1)) < 2e-3


def continued() -> db.SimulationSettings:
    settings = db.SimulationSettings()
    settings.continuation.restartFileName = "restart.txt"
    return settings


@pytest.mark.parametrize(
    ("arguments", "text"),
    [
        ({"version": "1.0"}, "version: received '1.0', but expected '2.0' or '3.0'"),
        ({"step_size": 0}, "step_size: expected a positive number"),
        ({"method": "dopri6"}, "method: received 'dopri6'. Expected one of 'GeneralizedAlpha'"),
        ({"inputs": {"2x": "push"}}, "inputs: received the name '2x'; expected letters, digits and _"),
        ({"inputs": {"f": "spring"}}, "CartesianSpringDamper 'spring'.*without a parameter"),
        ({"inputs": {"f": ("spring", "stifness")}}, "no parameter 'stifness'. Did you mean 'stiffness'"),
        ({"inputs": {"f": ("push", 3)}}, "load_vector: received entry 3, but expected 0 to 2"),
        ({"inputs": {"f": ("push", "body_fixed")}}, "body_fixed is False, but expected a real number or a vector"),
        ({"inputs": {"f": ("mass", "physics_mass", 0)}}, "physics_mass is one number, without entry 0"),
        (
            {"inputs": {"f": "push", "g": ("push", 1)}},
            r"inputs\['g'\]: 'f\[2\]' sets load_vector of .*'push'.* as well",
        ),
        ({"settings": continued()}, "settings.continuation: a solution of an FMU cannot be continued"),
        ({"inputs": {"f": ("pushh", 0)}}, "no item 'pushh'. Did you mean 'push'"),
        ({"outputs": {"x": ("mass", "placement", 0)}}, "no output 'placement'"),
        ({"outputs": {"x": ("speed", 3)}}, "values: received entry 3, but expected 0 to 2"),
        ({"outputs": {"f": ("speed", 0)}, "inputs": {"f": ("push", 0)}}, "outputs: 'f' is also the name of an input"),
        ({"file_name": "no folder/o.fmu"}, "there is no folder"),
    ],
)
def test_wrong_exports_are_refused(tmp_path: Path, arguments: dict[str, Any], text: str) -> None:
    given = {"file_name": tmp_path / "o.fmu", "inputs": {}, "outputs": {"x": ("speed", 0)}, "step_size": 1e-3}
    with pytest.raises((ValueError, KeyError, OSError), match=text):
        oscillator().export_fmu(**(given | arguments))
    assert not list(tmp_path.iterdir())


def driven(**motor: Any) -> db.Model:
    """Return an arm of 2 kg and 1 m on a hinge, with a motor whose law is recorded."""
    model = db.Model()
    arm = model.create_box("arm", size=[1, 0.1, 0.1], reference_position=[0.5, 0, 0], mass=2)
    hinge: Any = {"body_numbers": ["ground", arm], "position": [0, 0, 0], "axis": "z"}
    model.create_revolute_joint(**hinge)
    model.create_motor("motor", **hinge, **motor)
    model.create_sensor(arm, "angular_velocity", name="speed")
    return model


@pytest.mark.parametrize("given", [("arm", "mass"), ("arm", "physics_mass"), ("arm", "center_of_mass", 0)])
def test_a_mass_without_its_inertia_is_announced(tmp_path: Path, given: Any) -> None:
    """The inertia of a body does not follow its mass; a mass point has none."""
    signals: Any = ({}, {"w": ("speed", 2)}, 1e-3)
    what = "center_of_mass" if "center_of_mass" in given else "mass"
    text = rf"export_fmu: <RigidBody 'arm' .*another {what} does not change the inertia.*Add \('arm', 'inertia'\)"
    with pytest.warns(UserWarning, match=text):
        driven(torque=1.0).export_fmu(tmp_path / "a.fmu", *signals, parameters={"m": given})
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        both = {"m": given, "J": ("arm", "inertia")}
        driven(torque=1.0).export_fmu(tmp_path / "a.fmu", *signals, parameters=both)


def test_mass_and_inertia_of_an_exported_body(tmp_path: Path) -> None:
    """A torque of 1 Nm about the end of a bar of mass m and moment J about its middle: w = t / (J + m / 4)."""
    parameters = {"m": ("arm", "mass"), "J": ("arm", "inertia", 2)}
    driven(torque=1.0).export_fmu(tmp_path / "a.fmu", {}, {"w": ("speed", 2)}, 1e-3, parameters=parameters)
    found = fmpy.simulate_fmu(str(tmp_path / "a.fmu"), start_values={"m": 4.0, "J": 0.5}, stop_time=0.5)
    assert found["w"][-1] == pytest.approx(0.5 / (0.5 + 4 / 4), rel=1e-7)  # second order: 3e-4 rad in a step


def test_constants_of_laws_are_parameters(tmp_path: Path) -> None:
    """The speed of a motor tends to its set point w0: w = w0 (1 - exp(-d t / J)); other parameters have no effect."""
    model = driven(speed=3.0, damping=0.5)
    signals: Any = ({}, {"w": ("speed", 2)}, 1e-3)
    model.export_fmu(tmp_path / "a.fmu", *signals, parameters={"d": ("motor", "damping")})
    inertia = 2 * (1 + 0.1**2) / 12 + 2 * 0.5**2
    for d in (0.5, 2.0):
        found = fmpy.simulate_fmu(str(tmp_path / "a.fmu"), start_values={"d": d}, stop_time=0.5)
        assert found["w"][-1] == pytest.approx(3 * (1 - np.exp(-d * 0.5 / inertia)), rel=1e-4)  # second order, 1 ms
    for name in ("stiffness", "offset", "torque"):
        text = f"'motor'.*{name} has no effect, because the law.*replaces it. Set a constant of the law: '.*damping'"
        with pytest.raises(ValueError, match=text):
            model.export_fmu(tmp_path / "b.fmu", *signals, parameters={"p": ("motor", name)})
    load = model.create_force_from_table("wind", "arm", table=[[0, 1], [1, 2]])
    with pytest.raises(ValueError, match="'wind'.*load_vector has no effect.*Create the item with another law"):
        model.export_fmu(tmp_path / "b.fmu", {"f": load}, *signals[1:])


# ---- FMUs in models


@pytest.mark.parametrize("version", VERSIONS)
@pytest.mark.parametrize(
    ("method", "steps", "accuracy"),
    # (omega h)^5 / 120 per step of RK44; tolerances of 1e-8 of DOPRI5; second order of generalized alpha, also from
    # sample to sample: (omega h)^2 / 12 of 0.1 m, over 20 rad.
    [("rk44", 5, 1e-9), ("dopri5", 1, 1e-8), ("generalized_alpha", 10, 4e-6), ("generalized_alpha", 20, 1e-6)],
)
def test_an_fmu_as_controller(tmp_path: Path, version: str, method: str, steps: int, accuracy: float) -> None:
    model = controlled(controller(tmp_path, version))
    expected = sampled(lambda t, x, v: -STIFFNESS * x - GAIN * v)[:, 0]
    first = model.solve(PERIOD * SAMPLES, PERIOD / steps, method=method)
    assert np.abs(at_samples(first) - expected).max() < accuracy
    assert model["push"].load_vector.tolist() == [0, 0, 0]
    again = model.solve(PERIOD * SAMPLES, PERIOD / steps, method=method)
    assert np.array_equal(again["mass"].displacement, first["mass"].displacement)
    copied = pickle.loads(pickle.dumps(model)).solve(PERIOD * SAMPLES, PERIOD / steps, method=method)
    assert np.array_equal(copied["mass"].displacement, first["mass"].displacement)


def test_steps_need_not_fit_into_those_of_an_fmu(tmp_path: Path) -> None:
    """Steps end at all samples, with events of the user beside."""
    model = oscillator()
    seen: list[float] = []
    model.system.SetEventsUserFunction(lambda mbs, t: [t - 0.1234])
    model.system.SetEventActionUserFunction(lambda mbs, t, event, direction: not seen.append((t, event)))
    fmu = controller(tmp_path, "2.0")
    values = {"stiffness": STIFFNESS, "gain": GAIN}
    signals: Any = ({"x": ("mass", "displacement", 0), "v": ("speed", 0)}, {"force": ("push", 0)}, PERIOD)
    model.add_fmu(fmu, *signals, values=values)
    expected = sampled(lambda t, x, v: -STIFFNESS * x - GAIN * v)[:, 0]
    solution = model.solve(PERIOD * SAMPLES, 0.7 * PERIOD, method="rk44")
    assert np.abs(at_samples(solution) - expected).max() < 1e-6  # (omega h)^4 / 120
    assert np.allclose(seen, [(0.1234, 0)], rtol=0, atol=1e-9)


@pytest.mark.parametrize("version", VERSIONS)
def test_an_fmu_with_a_state_starts_anew(tmp_path: Path, version: str) -> None:
    """Its integral begins at zero in each solution; refused steps of error control do not advance it."""
    body = f"self.time += self.x * h; self.force = -{STIFFNESS} * self.x - 500 * self.time; return True"
    model = oscillator()
    fmu = controller(tmp_path, version, body)
    model.add_fmu(fmu, {"x": ("mass", "displacement", 0)}, {"force": ("push", 0)}, PERIOD)
    integral = 0.0

    def law(t: float, x: float, v: float) -> float:
        nonlocal integral
        integral += x * PERIOD
        return -STIFFNESS * x - 500 * integral

    expected = sampled(law)[:, 0]
    settings = db.SimulationSettings()
    settings.timeIntegration.relativeTolerance = settings.timeIntegration.absoluteTolerance = 1e-13
    for _ in range(2):
        solution = model.solve(PERIOD * SAMPLES, method="dopri5", settings=settings)
        assert solution.statistics["rejected_steps"] > 0
        assert np.abs(at_samples(solution) - expected).max() < 1e-10


def test_the_first_and_the_last_measurement(tmp_path: Path) -> None:
    """The first one includes accelerations; the end of a solution is not the beginning of a step of the FMU."""
    body = (
        "self.force = self.x if t == 0 else self.force\n        if t > 0.999: raise ValueError(t)\n        return True"
    )
    model = oscillator()
    model.add_fmu(controller(tmp_path, "2.0", body), {"x": ("mass", "acceleration", 0)}, {"force": ("push", 0)}, PERIOD)
    model["push"].load_vector = [15, 0, 0]  # acts until the FMU does
    solution = model.solve(1, PERIOD / 5, method="rk44")
    expected = sampled(lambda t, x, v: -(OMEGA**2) * 0.1 + 15 / MASS)[:, 0]
    assert np.abs(at_samples(solution) - expected).max() < 1e-9
    assert model["push"].load_vector.tolist() == [15, 0, 0]


@pytest.mark.parametrize("version", VERSIONS)
def test_fmus_of_one_name_are_different(tmp_path: Path, version: str) -> None:
    """Instances have the code of their own file, although Python keeps modules by name."""
    for number in (1.0, 2.0):
        folder = tmp_path / str(number)
        folder.mkdir()
        fmu = controller(folder, version, f"self.force = {number}; return True")
        model = oscillator()
        model.add_fmu(fmu, {}, {"force": ("push", 2)}, 0.1)
        model["spring"].stiffness = [1, 1, 0]
        solution = model.solve(1, 0.05)
        assert abs(solution["mass"].displacement[-1, 2] - number / MASS / 2) < 1e-10
        assert not [each for each in sys.path if not os.path.exists(each) and "dalembert" in each]


@pytest.mark.parametrize("version", VERSIONS)
def test_errors_of_an_fmu_name_it(tmp_path: Path, version: str) -> None:
    body = f"""from pythonfmu{version[0].strip("2")}.enums import Fmi{version[0]}Status
        self.log("the tank is empty", Fmi{version[0]}Status.error)
        return t < 0.1"""
    model = controlled(controller(tmp_path, version, body))
    text = r"FMU 'Controller.fmu': step at time 0.1 s: fmi\dDoStep failed with status 2 \(discard\); the tank is empty"
    with pytest.raises(RuntimeError, match=text):
        model.solve(1, PERIOD)
    assert model["push"].load_vector.tolist() == [0, 0, 0]


def test_other_solvers_refuse_models_with_fmus(tmp_path: Path) -> None:
    model = controlled(controller(tmp_path, "2.0"))
    for solve in (lambda: model.system.SolveDynamic(db.SimulationSettings()), model.solve_static):
        with pytest.raises(
            RuntimeError, match=re.escape("has FMUs ('Controller.fmu'), which only model.solve(...) steps")
        ):
            solve()
    with pytest.raises(ValueError, match="steps of 0.1 s are longer than 0.005 s, the step size of an FMU"):
        model.solve(1, 0.1)
    settings = db.SimulationSettings()
    settings.continuation.restartFileName = "restart.txt"
    with pytest.raises(ValueError, match="settings.continuation: a solution with FMUs cannot be continued"):
        model.solve(1, 1e-3, settings=settings)
    with pytest.raises(ValueError, match="model files do not keep FMUs"):
        model.save(tmp_path / "m.json")
    with pytest.raises(ValueError, match="the model has FMUs itself"):
        model.export_fmu(tmp_path / "m.fmu", {}, {"x": ("speed", 0)}, 1e-3)
    model.system.SetEventsUserFunction(lambda mbs, t: [1.0])
    with pytest.raises(RuntimeError, match="Events or EventAction user function has been replaced"):
        model.solve(1, 1e-3)


@pytest.mark.parametrize(
    ("arguments", "text"),
    [
        ({"file_name": "nothing.fmu"}, "nothing.fmu"),
        ({"step_size": -1}, "step_size: expected a positive number"),
        ({"inputs": {"y": ("speed", 0)}}, "inputs: FMU 'Controller.fmu' has no input 'y'.*x"),
        ({"inputs": {"force": ("speed", 0)}}, "has no input 'force'"),
        ({"inputs": {"on": ("speed", 0)}}, "'on' of FMU 'Controller.fmu' is Boolean, but expected one real number"),
        ({"inputs": {"x": "speed"}}, "values has 3 components; add the number of one, from 0, such as .sensor, 0."),
        (
            {"outputs": {"force": "push"}},
            "load_vector has 3 entries; write .'push', 'load_vector', 0. for the first one",
        ),
        ({"values": {"force": 1}}, "a start value of 'force' has no effect, because the FMU computes it"),
        ({"values": {"x": 1}}, "a start value of 'x' has no effect, because it is measured, as one of inputs"),
        ({"values": {"stifness": 1}}, "no variable 'stifness'. Did you mean 'stiffness'"),
        ({"outputs": []}, "outputs: expected variables of the FMU by name"),
    ],
)
def test_wrong_fmus_are_refused(tmp_path: Path, arguments: dict[str, Any], text: str) -> None:
    fmu = controller(tmp_path, "2.0")
    given = {"file_name": fmu, "inputs": {"x": ("speed", 0)}, "outputs": {"force": ("push", 0)}, "step_size": PERIOD}
    with pytest.raises((ValueError, TypeError, OSError), match=text):
        oscillator().add_fmu(**(given | arguments))


def test_other_files_are_refused(tmp_path: Path) -> None:
    file = tmp_path / "text.fmu"
    file.write_text("nothing")
    with pytest.raises(ValueError, match="is no FMU that can be read"):
        oscillator().add_fmu(file, {}, {}, 0.1)
    model = controlled(controller(tmp_path, "2.0"))
    with pytest.raises(ValueError, match="another output of an FMU sets load_vector of 'push'"):
        model.add_fmu(tmp_path / "Controller.fmu", {}, {"force": ("push", 0)}, 0.1)


@pytest.mark.parametrize("package", ["pythonfmu", "pythonfmu3", "fmpy"])
def test_missing_packages_are_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, package: str) -> None:
    fmu = controller(tmp_path, "2.0")
    for each in [name for name in sys.modules if name.partition(".")[0] == package]:
        monkeypatch.delitem(sys.modules, each)
    monkeypatch.setitem(sys.modules, package, None)
    with pytest.raises(
        ImportError, match=re.escape(f"the package {package} is needed; install it with \"pip install '")
    ):
        if package == "fmpy":
            oscillator().add_fmu(fmu, {}, {}, 0.1)
        else:
            version: Any = "2.0" if package == "pythonfmu" else "3.0"
            oscillator().export_fmu(tmp_path / "o.fmu", {}, {"x": ("speed", 0)}, 0.1, version=version)


OUTSIDE = 5.0


def test_models_that_cannot_start_are_not_exported(tmp_path: Path) -> None:
    def constant(mbs: Any, t: float, load: Any) -> list[float]:
        return [OUTSIDE, 0, 0]

    model = db.Model()
    model.create_mass_point("mass", mass=1)
    model.create_force("force", "mass", load_vector=[1, 0, 0])
    model["force"].load_vector_user_function = constant
    with pytest.raises(
        RuntimeError, match="cannot start: name 'OUTSIDE' is not defined; functions must define or import"
    ):
        model.export_fmu(tmp_path / "mass.fmu", {}, {"x": ("mass", "position", 0)}, 1e-3)
    with pytest.raises(ValueError, match=r"file_name: expected a name that ends with \.fmu"):
        model.export_fmu(tmp_path / "mass", {}, {"x": ("mass", "position", 0)}, 1e-3)
