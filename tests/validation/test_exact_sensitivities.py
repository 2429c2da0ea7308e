"""Derivatives of solutions: reference values, both methods against each other, and differences of the same solution."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
import scipy.optimize
from validation.sensitivity_problems import (
    DYNAMIC,
    EVENTS,
    FIXED_POINTS,
    INTERVAL,
    OPTIMUM,
    STATIC,
    Problem,
    absorber_problem,
    buckling,
    cantilever_problem,
    elastica,
    reference,
    vibrating_cantilever,
)

import dalembert as exu
from dalembert.itemInterface import (
    CoordinateConstraint,
    LoadForceVector,
    MarkerNodeCoordinate,
    MarkerNodePosition,
    MassPoint2D,
    NodePoint2DSlope1,
    NodePointGround,
    ObjectANCFCable2D,
)

CENTRAL = {-2: 1 / 12, -1: -8 / 12, 1: 8 / 12, 2: -1 / 12}
Solver = exu.DynamicSolverType


def numbers_of(result: Any) -> Any:
    return np.concatenate([np.atleast_1d(value) for value in result.values.values()])


def relative(problem: Problem, difference: Any, compared: Any) -> Any:
    """Errors times parameters, relative to the largest derivative of each output times its parameter."""
    sizes = np.abs(np.array([problem.numbers[name] for name in problem.numbers]))
    return np.max(np.abs(difference) * sizes, axis=1) / np.max(np.abs(compared) * sizes, axis=1)


def known(name: str, problem: Problem) -> tuple[Any, Any]:
    """Values and derivatives of the reference, in the order of outputs and parameters."""
    block = reference(name if name.startswith("P8") else name.split()[0])
    if name == "P10":  # the mass leaves the spring at its end: its height is v^2/(2g) then
        (height, by), g = block["bounce height"], problem.numbers["g"]
        speed = np.sqrt(2 * g * height)
        block["speed"] = (
            speed,
            {key: (g * x + (height if key == "g" else 0.0)) / speed for key, x in by.items()},
        )
    if name == "P17":  # costs of the forces themselves are no output of the model
        value, by = block["cost"]
        forces = {key: x for key, x in problem.numbers.items() if key[0] == "u"}
        value -= sum(0.01 * INTERVAL * u**2 for u in forces.values())
        block["cost"] = value, {key: x - 0.02 * INTERVAL * forces.get(key, 0.0) for key, x in by.items()}
    return (
        np.array([block[output][0] for output in problem.outputs]),
        np.array([[block[output][1][parameter] for parameter in problem.numbers] for output in problem.outputs]),
    )


def by_differences(problem: Problem, steps: int | None = None) -> Any:
    """Differences of fourth order of whole solutions, of models that are built anew."""
    columns = []
    for name, value in problem.numbers.items():
        step = 1e-3 * (abs(value) if value else 1.0)
        varied: list[Any] = []
        for multiple, weight in CENTRAL.items():
            numbers = {**problem.numbers, name: value + multiple * step}
            # The cheapest derivatives: only values are used.
            cheap = {next(iter(problem.parameters(numbers))): next(iter(problem.parameters(numbers).values()))}
            found = problem.build(numbers).ComputeSensitivities(
                cheap, problem.outputs, problem.settings(steps, numbers), problem.solver, "forward"
            )
            varied.append(weight / step * numbers_of(found))
        columns.append(np.sum(varied, axis=0))
    return np.array(columns).T


@pytest.mark.parametrize("name", STATIC)
def test_static_derivatives_are_those_of_closed_forms(name: str) -> None:
    problem = STATIC[name]
    forward, adjoint = problem.solve(method="forward"), problem.solve(method="adjoint")
    values, derivatives = known(name, problem)
    np.testing.assert_allclose(numbers_of(forward), values, rtol=1e-9)
    assert np.all(relative(problem, forward.matrix - derivatives, derivatives) < 1e-9)
    assert np.all(relative(problem, forward.matrix - adjoint.matrix, derivatives) < 1e-12)


def test_what_does_not_act_has_no_derivative() -> None:
    # The weight of the crank acts on its pin and on the motor: horizontal forces of the pins do not feel it.
    found = STATIC["P3"].solve()
    assert abs(found.Derivative("Ax", "m1")) < 1e-12
    assert abs(found.Derivative("Dx", "m1")) < 1e-12


# Extrapolated from solutions with n and 2 n steps, and 4 n where the start makes an error of first order: rates of first-order
# coordinates, and accelerations of prescribed coordinates, start from zero. In P17, forces jump between steps.
FIRST_ORDER = {"P12", "P17", "P20"}


def limit_of(parts: list[Any], order: int) -> Any:
    """Richardson extrapolation of two results, the second one with twice as many steps or elements."""
    coarse, fine = parts
    return fine + (fine - coarse) / (2**order - 1)


def extrapolated(problem: Problem, first_order: bool) -> tuple[Any, Any]:
    counts = (1, 2, 4) if first_order else (1, 2)
    found = [problem.solve(count * problem.steps, method="adjoint") for count in counts]
    values, matrices = [numbers_of(each) for each in found], [each.matrix for each in found]

    def limit(parts: list[Any]) -> Any:
        if first_order:
            parts = [limit_of(list(pair), 1) for pair in zip(parts[:-1], parts[1:], strict=True)]
        return limit_of(parts, 2)

    return limit(values), limit(matrices)


@pytest.mark.parametrize("name", DYNAMIC)
def test_derivatives_of_motions_converge_to_the_reference(name: str) -> None:
    problem = DYNAMIC[name]
    values, matrix = extrapolated(problem, name in FIRST_ORDER)
    expected, derivatives = known(name, problem)
    assert np.all(np.abs(values - expected) < 2e-6 * np.maximum(np.abs(expected), 0.1))
    assert np.all(relative(problem, matrix - derivatives, derivatives) < 1e-6)


@pytest.mark.parametrize("name", [*DYNAMIC, *EVENTS])
def test_derivatives_are_those_of_the_computed_solution(name: str) -> None:
    # In coarse steps, too, whose own errors are up to some percent.
    problem = {**DYNAMIC, **EVENTS}[name]
    forward, adjoint = problem.solve(60, method="forward"), problem.solve(60, method="adjoint")
    assert np.all(relative(problem, forward.matrix - adjoint.matrix, forward.matrix) < 1e-10)
    differences = by_differences(problem, 60)
    assert np.all(relative(problem, forward.matrix - differences, forward.matrix) < 1e-7)


def test_stop_of_a_sliding_block() -> None:
    # Friction is constant until the block stops: steps of the solver have no error.
    problem = EVENTS["P9"]
    values, derivatives = known("P9", problem)
    for method in ("forward", "adjoint"):
        found = problem.solve(method=method)
        np.testing.assert_allclose(numbers_of(found), values, rtol=1e-10)
        assert np.all(relative(problem, found.matrix - derivatives, derivatives) < 1e-9)


def test_drop_on_a_spring() -> None:
    # Before the contact, steps have no error; after it, that of the place of the event in a step is of first order.
    problem = EVENTS["P10"]
    block = reference("P10")
    coarse, fine = problem.solve(1400), problem.solve(11200)
    for output, largest in (("t(touch)", 1e-11), ("t(leave)", 5e-6), ("gap at t=0.7", 5e-5)):
        expected = np.array([block[output][1][name] for name in problem.numbers])
        sizes = np.array(list(problem.numbers.values()))
        errors = [
            np.max(np.abs(found.matrix[found.outputs.index(output)] - expected) * sizes)
            / np.max(np.abs(expected * sizes))
            for found in (coarse, fine)
        ]
        assert errors[1] < largest and errors[1] < max(0.25 * errors[0], 1e-11)
    assert abs(fine.Derivative("t(touch)", "k")) < 1e-15  # the contact has not begun


@pytest.mark.parametrize(("name", "steps"), [("P10", 900), ("P12", 30), ("P13", 60)])
@pytest.mark.parametrize("method", ["forward", "adjoint"])
def test_explicit_methods(name: str, steps: int, method: str) -> None:
    # RK67 has order 6: a few steps are enough, also across the events of P10.
    problem = replace({**DYNAMIC, **EVENTS}[name], solver=Solver.RK67)
    values, derivatives = known(name, problem)
    found = problem.solve(steps, method=method)
    np.testing.assert_allclose(numbers_of(found), values, rtol=1e-8)
    assert np.all(relative(problem, found.matrix - derivatives, derivatives) < 1e-8)


@pytest.mark.parametrize("method", ["forward", "adjoint"])
@pytest.mark.parametrize(
    ("name", "build", "elements"), [("P4b", elastica, 24), ("P5", buckling, 4), ("P6", vibrating_cantilever, 8)]
)
def test_derivatives_of_meshes_converge_to_the_reference(name: str, build: Any, elements: int, method: str) -> None:
    # Errors of elements fall with the fourth power of their size.
    problems = [build(elements), build(2 * elements)]
    values, derivatives = known(name, problems[0])
    found = [each.solve(method=method) for each in problems]
    np.testing.assert_allclose(limit_of([numbers_of(each) for each in found], 4), values, rtol=1e-5)
    matrix = limit_of([each.matrix for each in found], 4)
    assert np.all(relative(problems[0], matrix - derivatives, derivatives) < 1e-5)


def test_large_deflection_scales_with_load_length_and_stiffness() -> None:
    # w/L is a function of F L^2/EI and EA L^2/EI, on any mesh: Euler's identities of its derivatives.
    numbers = {"F": 4.0, "L": 1.0, "EI": 2.0, "EA": 1e5, "rhoA": 1.0, "M": 1.0}
    found = cantilever_problem(numbers, 4, {"w": exu.At("tip", component=1)}).solve()
    w, by = found.values["w"], {name: numbers[name] * found.Derivative("w", name) for name in numbers}
    assert abs(by["F"] + by["EI"] + by["EA"]) < 1e-9 * abs(by["L"])
    # Forces of 1e5 N cancel in differences along the length: 1e-16 * 1e5/1e-3 of a derivative of 1.
    assert abs(by["L"] - w - 2 * by["F"] - 2 * by["EA"]) < 2e-7 * abs(by["L"])
    assert abs(by["M"]) + abs(by["rhoA"]) < 1e-12  # there is no weight


def test_frequencies_of_a_beam_with_a_mass() -> None:
    numbers = {"F": 0.0, "L": 1.2, "EI": 50.0, "EA": 1e7, "rhoA": 2.0, "M": 0.8}
    outputs = {f"omega_{k + 1}": exu.Function(np.sqrt, outputs=[exu.Eigenvalue(k)]) for k in (0, 1)}
    coarse, fine = (cantilever_problem(numbers, elements, outputs).solve() for elements in (8, 16))
    by = {name: numbers[name] * fine.matrix[:, fine.parameters.index(name)] for name in numbers}
    omega = numbers_of(fine)
    # On any mesh: omega^2 is linear in both stiffnesses together, and 1/omega^2 in both masses.
    # (rounding errors of differences: the axial stiffness is 1e5 times that of bending)
    np.testing.assert_allclose(by["EI"] + by["EA"], omega / 2, rtol=2e-8)
    np.testing.assert_allclose(by["rhoA"] + by["M"], -omega / 2, rtol=2e-8)
    for output, (_, derivatives) in reference("P6").items():
        for parameter, expected in derivatives.items():
            # Errors fall with the fourth power of the size of elements.
            ends = [each.Derivative(output, parameter) for each in (coarse, fine)]
            assert ends[1] + (ends[1] - ends[0]) / 15 == pytest.approx(expected, rel=1e-5)


def test_buckling_load_of_a_cantilever() -> None:
    # On any mesh: P/EI and P L^2/EI depend on EA L^2/EI alone; errors of elements fall with the fourth power of their size.
    numbers = {"F": 0.0, "L": 1.5, "EI": 20.0, "EA": 1e7, "rhoA": 1.0, "M": 1.0}
    value, derivatives = reference("P5")["P"]
    found = []
    for elements in (4, 8):
        problem = cantilever_problem(numbers, elements, {"P": exu.BucklingLoad()})
        mbs = problem.build(numbers)
        tip = mbs.AddMarker(MarkerNodePosition(nodeNumber=mbs.GetNodeNumber(f"end {elements}")))
        mbs.AddLoad(LoadForceVector(markerNumber=tip, loadVector=[-1, 0, 0], name="pressure"))
        mbs.Assemble()
        found.append(mbs.ComputeSensitivities(problem.parameters(numbers), problem.outputs, solverType="static"))
        load = found[-1].values["P"]
        assert load == pytest.approx(mbs.ComputeBucklingLoads().factors[0], rel=1e-6)
        by = {name: numbers[name] * found[-1].Derivative("P", name) / load for name in numbers}
        assert by["EI"] + by["EA"] == pytest.approx(1, rel=1e-7)
        assert by["L"] == pytest.approx(-2 * by["EI"], rel=1e-7)
        assert abs(by["F"]) + abs(by["rhoA"]) + abs(by["M"]) < 1e-9
    limit = [fine + (fine - coarse) / 15 for coarse, fine in zip(found[0].matrix[0], found[1].matrix[0], strict=True)]
    by = dict(zip(numbers, limit, strict=True))
    assert found[1].values["P"] + (found[1].values["P"] - found[0].values["P"]) / 15 == pytest.approx(value, rel=1e-5)
    assert by["L"] == pytest.approx(derivatives["L"], rel=1e-5)
    assert by["EI"] == pytest.approx(derivatives["EI"], rel=1e-5)


@pytest.mark.parametrize("side", FIXED_POINTS)
def test_response_at_fixed_points_of_an_absorber(side: int) -> None:
    # Den Hartog: there, the amplitude does not depend on the damping.
    omega = FIXED_POINTS[side]
    problem = absorber_problem(omega)
    found = problem.solve()
    values = {name: value for name, value in reference(f"P8 {side:+d}")["X"][1].items() if name in problem.numbers}
    assert found.values["X"] == pytest.approx(np.sqrt(1 + 2 * 10 / 0.5) / 4000, rel=1e-9)
    sizes = np.array(list(problem.numbers.values()))
    expected = np.array([values[name] for name in problem.numbers])
    assert np.max(np.abs(found.matrix[0] - expected) * sizes) < 1e-9 * np.max(np.abs(expected) * sizes)
    assert abs(found.Derivative("X", "c2")) * OPTIMUM["c2"] < 1e-9 * found.values["X"]


@pytest.mark.parametrize("side", FIXED_POINTS)
def test_response_by_its_frequency(side: int) -> None:
    problem = absorber_problem(FIXED_POINTS[side])
    _, by = reference(f"P8 {side:+d}")["X"]
    omega = exu.DesignParameter(FIXED_POINTS[side])
    outputs = {"X": exu.FrequencyResponse("force", "x", "w")}
    parameters = {"w": omega, "k2": ("spring2", "stiffness")}
    found = problem.build(problem.numbers).ComputeSensitivities(parameters, outputs, solverType="static")
    assert found.Derivative("X", "w") == pytest.approx(by["w"], rel=1e-9)
    assert found.Derivative("X", "k2") == pytest.approx(by["k2"], rel=1e-9)
    # A number that acts on the model and on the frequency: both parts are added.
    both = exu.DesignParameter(omega.value, {("spring2", "stiffness"): OPTIMUM["k2"] / omega.value})
    found = problem.build(problem.numbers).ComputeSensitivities({"w": both}, outputs, solverType="static")
    expected = by["w"] + by["k2"] * OPTIMUM["k2"] / omega.value
    assert found.Derivative("X", "w") == pytest.approx(expected, rel=1e-8)
    model = exu.DifferentiableModel(problem.build(problem.numbers), parameters, outputs, solverType="static")
    assert model.bounds[0][0] == 0.0
    assert model.Check([omega.value + 0.5, 170.0]) == ""  # near a peak, to six digits


def test_search_finds_the_optimal_absorber() -> None:
    # Den Hartog, Brock: at the best stiffness, both fixed points have one amplitude. The curve is level at one of them for
    # one damping each; the optimum is the mean of their squares.
    numbers = {**absorber_problem(18.0).numbers, "c2": 1.0, "k2": 150.0}

    def response(omega: float, k2: float, c2: float) -> Any:
        problem = replace(absorber_problem(omega), numbers={**numbers, "k2": k2, "c2": c2})
        return problem.solve()

    def by_damping(omega: float, k2: float) -> float:
        return float(response(omega, k2, 1.0).Derivative("X", "c2"))

    def fixed_points(k2: float) -> list[float]:
        own = np.sqrt(k2 / 0.5)  # between both
        ends = ((own - 2, own - 0.2), (own + 0.2, own + 4))
        return [scipy.optimize.brentq(by_damping, *end, args=(k2,), xtol=1e-8) for end in ends]

    def difference(k2: float) -> float:
        return float(np.subtract(*(response(omega, k2, 1.0).values["X"] for omega in fixed_points(k2))))

    k2 = scipy.optimize.brentq(difference, 175.0, 190.0, xtol=1e-4)
    first, second = fixed_points(k2)
    assert k2 == pytest.approx(OPTIMUM["k2"], rel=1e-5)
    step = 1e-3

    def slope(c2: float, omega: float) -> float:
        return float(response(omega + step, k2, c2).values["X"] - response(omega - step, k2, c2).values["X"])

    level = [scipy.optimize.brentq(slope, 1.5, 4.0, args=(omega,), xtol=1e-10) for omega in (first, second)]
    assert np.sqrt(np.mean(np.square(level))) == pytest.approx(OPTIMUM["c2"], rel=1e-5)


def test_repeated_eigenvalues_are_refused() -> None:
    numbers = {"F": 0.0, "L": 1.2, "EI": 50.0, "EA": 1e7, "rhoA": 2.0, "M": 0.8}
    mbs = cantilever_problem(numbers, 2, {}).build(numbers)
    twin = [mbs.AddNode(NodePoint2DSlope1(referenceCoordinates=[x, 5, 1, 0])) for x in np.linspace(0, 1.2, 3)]
    for i in range(2):
        copied = mbs.GetObject(i)
        mbs.AddObject(
            ObjectANCFCable2D(
                **{
                    **{k: v for k, v in copied.items() if k.startswith("physics")},
                    "nodeNumbers": twin[i : i + 2],
                }
            )
        )
    for k in (0, 1, 3):
        marker = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=twin[0], coordinate=k))
        ground = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.AddNode(NodePointGround()), coordinate=0))
        mbs.AddObject(CoordinateConstraint(markerNumbers=[ground, marker]))
    mbs.AddObject(MassPoint2D(physicsMass=0.8, nodeNumber=twin[-1]))
    mbs.Assemble()
    with pytest.raises(exu.NotDifferentiable, match="eigenvalue 0: it coincides with another one"):
        mbs.ComputeSensitivities({"M": ("mass", "physicsMass")}, {"w": exu.Eigenvalue(0)}, solverType="static")
    with pytest.raises(exu.NotDifferentiable, match="use solverType='static'"):
        mbs.ComputeSensitivities({"M": ("mass", "physicsMass")}, {"w": exu.Eigenvalue(0)})
