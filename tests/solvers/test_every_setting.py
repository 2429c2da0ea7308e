"""Each setting of the solvers makes a difference, or says that it makes none."""

from __future__ import annotations

import re
import subprocess
import sys
from typing import Any

import pytest
import setting_models as models
from oscillators import oscillator
from setting_cases import CASES, Case
from setting_models import Run, solve

import dalembert as exu


def settings_of(values: dict[str, Any], path: str = "") -> dict[str, dict[str, Any]]:
    """Data of each setting, by its path."""
    found: dict[str, dict[str, Any]] = {}
    for name, value in values.items():
        if "description" in value and "value" in value:
            found[path + name] = value
        else:
            found |= settings_of(value, f"{path}{name}.")
    return found


ALL = settings_of(exu.SimulationSettings().GetDictionaryWithTypeInfo())
IDLE = {path for path, known in ALL.items() if "; no effect: " in known["description"]}


def test_every_setting_is_accounted_for() -> None:
    assert len(ALL) >= 152
    assert sorted(CASES) == sorted(set(ALL) - IDLE)


def run(case: Case, change: dict[str, Any]) -> Run:
    return solve(case.model, {**case.given, **change}, case.solver, case.times)


@pytest.mark.parametrize("path", CASES)
def test_it_makes_a_difference(path: str) -> None:
    case = CASES[path]
    assert case.value != ALL[path]["value"]
    before, again, after = (case.observe(run(case, change)) for change in ({}, {}, {path: case.value}))
    assert again == before, "what is observed changes by itself"
    assert after != before


def other_value(value: Any) -> Any:
    return not value if isinstance(value, bool) else value + 1


SCRIPT = """
import dalembert as exu
mbs = exu.SystemContainer().AddSystem()
node = mbs.AddNode(exu.Node1D(referenceCoordinates=[0], initialVelocities=[1]))
mbs.AddObject(exu.ObjectMass1D(nodeNumber=node, physicsMass=1))
mbs.Assemble()
settings = exu.SimulationSettings()
settings.solutionSettings.writeSolutionToFile = False
settings.staticSolver.stabilizerODE2term = 1
settings.timeIntegration.numberOfSteps = 2
mbs.SolveDynamic(settings)
"""


def told_after(changes: dict[str, Any]) -> list[str]:
    """Settings of which two solutions say that they have no effect; a separate process is used, because warnings are
    not repeated."""
    lines = [f"settings.{path} = {value!r}" for path, value in sorted(changes.items())]
    script = "\n".join([SCRIPT, 'print("---")', *lines, "mbs.SolveDynamic(settings)", "mbs.SolveDynamic(settings)"])
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=60)
    assert done.returncode == 0, done.stderr
    before, after = done.stdout.split("---")
    assert "no effect" not in before
    told = [line for line in after.splitlines() if "has no effect" in line]
    assert all(line.partition("has no effect: ")[2] for line in told)
    return sorted(line.split()[1].removeprefix("simulationSettings.") for line in told)


def test_those_without_effect_say_so_once() -> None:
    assert told_after({path: other_value(ALL[path]["value"]) for path in IDLE}) == sorted(IDLE)


# ---- settings that act with a flag only
# ----------------------------------------------------------------------------------

FLAGS = {
    path: [f"{path.rpartition('.')[0]}.{flag}" for flag in said.group(1).split(" or ")]
    for path, known in ALL.items()
    if (said := re.search(r"; acts with (.*) only", known["description"]))
}


@pytest.mark.parametrize("path", FLAGS)
def test_without_its_flag_it_makes_no_difference(path: str) -> None:
    case = CASES[path]
    given = {**case.given, **dict.fromkeys(FLAGS[path], False)}
    before, after = (
        case.observe(solve(case.model, {**given, **change}, case.solver, case.times))
        for change in ({}, {path: case.value})
    )
    assert after == before


@pytest.mark.parametrize("on", [False, True])
def test_it_reports_the_missing_flag(on: bool) -> None:
    changes = {path: CASES[path].value for path in FLAGS}
    flags = {flag: on for all_flags in FLAGS.values() for flag in all_flags}
    assert len(FLAGS) > 20
    assert told_after({**changes, **flags}) == ([] if on else sorted(FLAGS))


# ---- settings that several solvers read, or with more than two values
# ----------------------------------------------------


@pytest.mark.parametrize(
    ("level", "solver", "shown"),
    [
        (1, "implicit", "terminated"),
        (2, "implicit", "Newton iteration"),
        (3, "implicit", "ODE2_t = ["),
        (4, "implicit", "mass matrix ="),
        (5, "implicit", "inverse of the Jacobian ="),
        (3, "RK44", "ODE2_t = ["),
        (4, "RK44", "mass matrix ="),
        (3, "static", "ODE2 = ["),
        (5, "static", "inverse of the Jacobian ="),
    ],
)
def test_verbose_modes(level: int, solver: str, shown: str) -> None:
    group = "staticSolver" if solver == "static" else "timeIntegration"
    for mode in ("verboseMode", "verboseModeFile"):
        below, at = (
            solve(models.oscillation, {f"{group}.verboseMode": 0, f"{group}.{mode}": given}, solver, 1)
            for given in (level - 1, level)
        )
        texts = [r.printed if mode == "verboseMode" else r.files.get("solverInformation.txt", "") for r in (below, at)]
        assert shown not in texts[0] and shown in texts[1]


def test_shown_matrices() -> None:
    """A mass on a spring with the trapezoidal rule: J = h^2 beta (K + D 2 / h + M 4 / h^2), and its inverse."""
    change = {
        "timeIntegration.verboseMode": 5,
        "timeIntegration.generalizedAlpha.useNewmark": True,
        "outputPrecision": 15,
    }
    printed = solve(models.oscillation, change, "implicit", 1).printed.split("\n")
    shown = [float(printed[i + 1].strip(" []")) for i, line in enumerate(printed) if line.endswith("=")]
    h = 0.1
    jacobian = h**2 / 4 * (80.0 + 1.5 * 2 / h + 2.0 * 4 / h**2)
    # Sums and products of a few numbers, shown with 15 digits.
    assert shown[:3] == pytest.approx([2.0, jacobian, 1 / jacobian], rel=1e-13)


@pytest.mark.parametrize(("name", "value"), [("adaptiveStepDecrease", 0.1), ("adaptiveStepIncrease", 1.1)])
def test_explicit_solvers_adapt_steps_by_the_given_factors(name: str, value: float) -> None:
    given = {"timeIntegration.adaptiveStepRecoverySteps": 2, "timeIntegration.discontinuous.maxIterations": 1,
             "timeIntegration.discontinuous.ignoreMaxIterations": False}  # fmt: skip
    counts = [
        solve(models.rejecting, {**given, f"timeIntegration.{name}": factor}, "RK44", 1).it.currentStepIndex
        for factor in ({"adaptiveStepDecrease": 0.5, "adaptiveStepIncrease": 2.0}[name], value)
    ]
    assert counts[0] < counts[1]


@pytest.mark.parametrize("digits", [7, 8])
def test_precision_of_binary_files(digits: int) -> None:
    change = {
        "solutionSettings.writeSolutionToFile": True,
        "solutionSettings.binarySolutionFile": True,
        "solutionSettings.outputPrecision": digits,
    }
    file = solve(models.oscillation, change, "implicit", 1).files["coordinatesSolution.sol"]
    assert ord(file[8]) == (8 if digits >= 8 else 4)  # bytes per number, in the header


# ---- settings that contradict each other ---------------------------------------------------------------------------------


@pytest.mark.parametrize(("start", "end"), [(0.0, 0.0), (1.0, 1.0), (2.0, 1.0)])
@pytest.mark.parametrize("solver", ["implicit", "RK44"])
def test_there_must_be_something_to_integrate(start: float, end: float, solver: str) -> None:
    change = {"timeIntegration.startTime": start, "timeIntegration.endTime": end}
    run = solve(models.oscillation, change, solver, 1)
    assert (
        f"timeIntegration.endTime: received {end:g} with startTime={start:g}; there is nothing to integrate"
        in run.error
    )
    assert run.files == {} and run.it.currentStepIndex == 0


def test_a_solver_may_be_initialized_before_the_end_is_known() -> None:
    """Usage of environments, which integrate piece by piece: steps to the time where it is are none."""
    mbs, settings = models.oscillation(), exu.SimulationSettings()
    settings.timeIntegration.endTime = 0
    settings.solutionSettings.writeSolutionToFile = False
    solver = exu.MainSolverImplicitSecondOrder()
    assert solver.InitializeSolver(mbs, settings)
    assert solver.SolveSteps(mbs, settings) and solver.it.currentStepIndex == 0
    settings.timeIntegration.endTime = 0.1
    solver.InitializeSolverInitialConditions(mbs, settings)
    assert solver.SolveSteps(mbs, settings) and mbs.systemData.GetTime() == pytest.approx(0.1)
    settings.timeIntegration.startTime, settings.timeIntegration.endTime = 0.2, 0.1
    solver.InitializeSolverInitialConditions(mbs, settings)
    with pytest.raises(ValueError, match="there is nothing to integrate"):
        solver.SolveSteps(mbs, settings)


@pytest.mark.parametrize(
    ("change", "solver", "warning"),
    [
        ({"minimumStepSize": 0.2}, "implicit", "minimumStepSize (0.2 s) is larger than the step size (0.1 s)"),
        ({"initialStepSize": 0.2}, "DOPRI5", "initialStepSize (0.2 s) is larger than the largest step size"),
    ],
)
def test_step_sizes_that_contradict_each_other(change: dict[str, Any], solver: str, warning: str) -> None:
    run = solve(models.oscillation, {f"timeIntegration.{name}": value for name, value in change.items()}, solver, 1)
    assert run.printed.count(warning) == 1
    assert max(b - a for (a, _), (b, _) in zip(run.table[:-1], run.table[1:], strict=True)) < 0.1 + 1e-12


def test_steps_are_counted_beyond_32_bits() -> None:
    """3e9 steps of 1 ns; a function of the user ends the run after ten."""
    model = oscillator()
    taken = []

    def count(mbs: Any, t: float) -> bool:
        taken.append(t)
        return len(taken) < 10

    model.mbs.SetPreStepUserFunction(count)
    model.mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps, settings.timeIntegration.endTime = 3e9, 3.0
    settings.solutionSettings.writeSolutionToFile = False
    solver = exu.MainSolverImplicitSecondOrder()
    solver.SolveSystem(model.mbs, settings)
    assert solver.it.numberOfSteps == 3_000_000_000
    assert taken[-1] == pytest.approx(1e-8, rel=1e-12)  # products of an integer and the step size
