"""Symbolic expressions against numpy and math, and as user functions against the Python function itself."""

import math

import numpy as np
import pytest

import dalembert as exu
from dalembert.utilities import ConvertFunctionToSymbolic, CreateSymbolicUserFunction

sym = exu.symbolic

UNARY = {
    "abs": abs, "sign": np.sign, "exp": math.exp, "sqrt": math.sqrt, "log": math.log, "sin": math.sin, "cos": math.cos,
    "tan": math.tan, "asin": math.asin, "acos": math.acos, "atan": math.atan, "sinh": math.sinh, "cosh": math.cosh,
    "tanh": math.tanh, "asinh": math.asinh, "acosh": math.acosh, "atanh": math.atanh, "ceil": math.ceil, "floor": math.floor,
    "round": round, "isfinite": math.isfinite, "Not": lambda x: not x,
}  # fmt: skip
BINARY = {"pow": math.pow, "atan2": math.atan2, "mod": math.fmod, "min": min, "max": max}


@pytest.fixture(autouse=True, params=[True, False], ids=["recording", "at once"])
def recording(request):
    stored = sym.GetRecording()
    sym.SetRecording(request.param)
    yield request.param
    sym.SetRecording(stored)


@pytest.mark.parametrize("name", UNARY)
def test_functions_of_one(name):
    for x in (0.4, 1.7) if name != "acosh" else (1.7,):
        if name in ("asin", "acos", "atanh") and x > 1:
            continue
        assert getattr(sym, name)(sym.Real(x)).Evaluate() == pytest.approx(float(UNARY[name](x)), rel=1e-15)
        assert getattr(sym, name)(x).Evaluate() == pytest.approx(float(UNARY[name](x)), rel=1e-15)


@pytest.mark.parametrize("name", BINARY)
def test_functions_of_two(name):
    for x, y in ((2.5, 1.5), (-2.0, 3.0)):
        assert getattr(sym, name)(sym.Real(x), y).Evaluate() == BINARY[name](x, y)


@pytest.mark.parametrize("x", [-7.5, -2.5, -0.25, 0.0, 0.25, 2.5, 7.5])
@pytest.mark.parametrize("y", [-3.0, -0.1, 0.1, 3.0])
def test_operators_of_python_on_negative_numbers(x, y):
    """Python's remainder has the sign of the divisor, its quotient is rounded down, and halves are rounded to even numbers."""
    a, b = sym.Real("a", x), sym.Real("b", y)
    assert float(a % b) == x % y and float(x % b) == x % y and float(a % y) == x % y
    assert float(a // b) == x // y and float(x // b) == x // y
    assert float(round(a)) == round(x) and float(sym.round(a)) == round(x)
    assert float(sym.mod(a, b)) == math.fmod(x, y)
    if sym.GetRecording():
        assert (a % b).Diff(a) == 1 and (a % b).Diff(b) == -(x // y) and (a // b).Diff(a) == 0


def test_scalars():
    a, b = sym.Real("a", 2.0), sym.Real("b", -0.7)
    cases = [
        (a + b, 1.3), (1 + a, 3), (a - b, 2.7), (1 - a, -1), (a * b, -1.4), (3 * a, 6), (a / b, 2 / -0.7), (1 / a, 0.5),
        (a**3, 8), (2**a, 4), (-a, -2), (+a, 2), (abs(b), 0.7), (a < b, 0), (a > 1, 1), (a <= 2, 1), (a >= 3, 0),
        (a == 2, 1), (a != 2, 0), (sym.IfThenElse(a < b, a, b), -0.7), (np.float64(2) * a, 4), (a % 1.5, 0.5),
    ]  # fmt: skip
    for expression, value in cases:
        assert float(expression) == pytest.approx(value, rel=1e-15), str(expression)
    c = a
    c += 1
    c *= b
    assert c.Evaluate() == pytest.approx(-2.1, rel=1e-15)


def test_vectors_and_matrices():
    v, w = np.array([1.0, -2.0, 0.5]), np.array([0.3, 4.0, 2.0])
    M, N = np.arange(9.0).reshape(3, 3), np.array([[1, 2, 0], [0.5, -1, 3], [2, 2, 2.0]])
    a, x, y, A, B = sym.Real(1.5), sym.Vector(v), sym.Vector(w), sym.Matrix(M), sym.Matrix(N.tolist())
    cases = [
        (x + y, v + w), (x - y, v - w), (x * y, v @ w), (a * x, 1.5 * v), (x * 2, 2 * v), (-x, -v), (x / 2, v / 2),
        (x.NormL2(), np.linalg.norm(v)), (x.MultComponents(y), v * w), (x[1], v[1]), (x[-1], v[-1]), (x == x, 1), (x != y, 1),
        (A + B, M + N), (A - B, M - N), (A * B, M @ N), (A * x, M @ v), (x * A, v @ M), (a * A, 1.5 * M), (A[2, 1], 7),
        (np.float64(2) * x, 2 * v), (sym.Vector([a, 2, x[0]]), [1.5, 2, 1]), (sym.Matrix([[a, 1], [0, a]]), [[1.5, 1], [0, 1.5]]),
        (sym.IfThenElse(a > 1, x, y), v),
    ]  # fmt: skip
    for expression, value in cases:
        np.testing.assert_allclose(expression.Evaluate(), value, rtol=1e-15, err_msg=str(expression))
    assert (len(x), x.NumberOfItems(), A.NumberOfRows(), A.NumberOfColumns()) == (3, 3, 3, 3)
    assert [float(entry) for entry in x] == v.tolist()


def test_components_are_set(recording):
    x, a = sym.Vector([1, 2]), sym.Real("a", 4)
    x[0] = 3
    x[1] += a * 2
    assert x.Evaluate().tolist() == [3, 10]
    a.SetValue(5)
    assert x.Evaluate().tolist() == [3, 12 if recording else 10]
    A = sym.Matrix(np.eye(2))
    A[0, 1] = 7
    A += A
    assert A.Evaluate().tolist() == [[2, 14], [0, 2]]


def test_expressions_follow_their_variables(recording):
    a, v = sym.Real("a", 1.0), sym.Vector("v", [1, 2])
    e = a * v.NormL2() + 3
    a.SetValue(2)
    v.SetVector([3, 4])
    assert e.Evaluate() == (13 if recording else pytest.approx(3 + math.sqrt(5)))
    assert str(e) == ("((a * NormL2(v)) + 3)" if recording else "5.23606797749979")


def test_derivative(recording):
    if not recording:
        return
    x = sym.Real("x", 0.7)
    e = (
        sym.sin(x) ** 2 / (1 + sym.exp(-x))
        + sym.IfThenElse(x > 0, sym.atan2(x, 2), 0)
        + sym.Vector([x, 2 * x]).NormL2()
    )

    def f(x):
        return math.sin(x) ** 2 / (1 + math.exp(-x)) + math.atan2(x, 2) + math.sqrt(5) * x

    assert e.Diff(x) == pytest.approx((f(0.7 + 1e-6) - f(0.7 - 1e-6)) / 2e-6, rel=1e-8)


@pytest.mark.parametrize(
    ("wrong", "error", "text"),
    [
        (
            lambda: sym.Vector([1, 2]) + sym.Vector([1, 2, 3]),
            ValueError,
            "a vector of length 2 and a vector of length 3",
        ),
        (lambda: sym.Matrix(np.eye(2)) * sym.Vector([1, 2, 3]), ValueError, r"\* is not defined for a matrix of 2 x 2"),
        (lambda: sym.Vector([]), ValueError, "at least one component"),
        (lambda: sym.Matrix([[1, 2], [3]]), ValueError, "same length"),
        (lambda: sym.Vector([1, 2])[2], IndexError, "index 2 is out of range; the length is 2"),
        (lambda: sym.Matrix(np.eye(2))[0, 2], IndexError, r"index \(0, 2\) is out of range"),
        (lambda: sym.sin(sym.Vector([1])), TypeError, "expected a number or symbolic.Real"),
        (lambda: sym.Real(1) + "x", TypeError, "unsupported operand"),
        (lambda: sym.VariableSet().Get("x"), KeyError, "there is no variable 'x'"),
        (lambda: sym.UserFunction().Evaluate(1), ValueError, "it is empty"),
    ],
    ids=range(10),
)
def test_mistakes(wrong, error, text):
    with pytest.raises(error, match=text):
        wrong()


def test_truth_of_an_expression_cannot_be_recorded(recording):
    if recording:
        with pytest.raises(TypeError, match="use symbolic.IfThenElse"):
            bool(sym.Real(1) < 2)
    else:
        assert bool(sym.Real(1) < 2)


def test_variables():
    variables = sym.VariableSet()
    variables.Set("x", 1)
    variables["y"] = 2
    e = variables.Get("x") + variables["y"]
    assert e.Evaluate() == 3
    assert variables.GetNames() == ["x", "y"]
    assert variables.Exists("x")
    with pytest.raises(ValueError, match="exists already"):
        variables.Add("x", 3)
    variables.Reset()
    assert variables.NumberOfItems() == 0


def spring_model():
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.CreateGround()
    mass = mbs.CreateMassPoint(referencePosition=[1.05, 0, 0], physicsMass=1)
    spring = mbs.CreateSpringDamper(bodyNumbers=[ground, mass], referenceLength=0.9, stiffness=100, damping=1)
    force = mbs.CreateForce(bodyNumber=mass, loadVector=[10, 0, 0])
    return mbs, mass, spring, force


def position(mbs, mass):
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = 100
    settings.timeIntegration.endTime = 0.5
    settings.solutionSettings.writeSolutionToFile = False
    settings.timeIntegration.verboseMode = 0
    mbs.SolveDynamic(settings)
    return mbs.GetObjectOutputBody(mass, exu.OutputVariableType.Position, [0, 0, 0]).tolist()


def test_user_functions_agree_with_python_functions():
    sym.variables.Set("factor", 0.5)

    def spring_force(library, factor):
        def f(mbs, t, itemNumber, deltaL, deltaL_t, stiffness, damping, force):
            return factor() * stiffness * library.sign(deltaL) * library.abs(deltaL) ** 1.2 + damping * deltaL_t + force

        return f

    def load(library):
        def f(mbs, t, loadVector):
            return [loadVector[0] * library.cos(3 * t), 0, 0.1 * t]

        return f

    results = []
    for library in (np, sym):
        mbs, mass, spring, force = spring_model()
        factor = (lambda: 0.5) if library is np else (lambda: sym.variables["factor"])
        functions = [
            (spring, "springForceUserFunction", spring_force(library, factor)),
            (force, "loadVectorUserFunction", load(library)),
        ]
        for item, name, function in functions:
            if library is sym:
                function = CreateSymbolicUserFunction(mbs, function, name, item)
            (mbs.SetObjectParameter if item == spring else mbs.SetLoadParameter)(item, name, function)
        results.append(position(mbs, mass))
    assert results[0] == pytest.approx(results[1], rel=1e-12)
    assert results[0][2] != 0
    sym.variables.Reset()


def test_symbols_in_results_of_python_functions():
    """Functions of numbers give scalars that are numbers."""
    mbs = exu.SystemContainer().AddSystem()
    node = mbs.AddNode(exu.NodePoint())
    mbs.AddObject(exu.MassPoint(physicsMass=2, nodeNumber=node))
    marker = mbs.AddMarker(exu.MarkerNodePosition(nodeNumber=node))
    sym.SetRecording(False)
    mbs.AddLoad(
        exu.Force(markerNumber=marker, loadVectorUserFunction=lambda mbs, t, load: [4 * sym.sign(-3.0), sym.abs(-2), 0])
    )
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.solutionSettings.writeSolutionToFile = False
    mbs.SolveDynamic(settings, solverType=exu.DynamicSolverType.RK44)
    moved = mbs.GetNodeOutput(node, exu.OutputVariableType.Displacement)
    np.testing.assert_allclose(moved, [-1, 0.5, 0], rtol=0, atol=1e-13)


def test_user_function_objects(recording):
    mbs, mass, spring, _ = spring_model()

    def f(mbs, t, itemNumber, u, v, k, d, f0):
        return k * u + d * v + sym.sin(t)

    data = ConvertFunctionToSymbolic(mbs, f, "springForceUserFunction", itemTypeName="ObjectConnectorSpringDamper")
    assert sym.GetRecording() is recording
    assert data["functionName"] == "f"
    assert data["argTypeList"] == ["MainSystem", "Real", "Index", "Real", "Real", "Real", "Real", "Real"]
    function = sym.UserFunction()
    function.SetUserFunctionFromDict(mbs, data, "springForceUserFunction", None, "ObjectConnectorSpringDamper")
    assert str(function) == "(((k * u) + (d * v)) + sin(t))"
    assert function.Evaluate(mbs, 0.5, 0, 1.0, 2.0, 3.0, 4.0, 5.0) == pytest.approx(11 + math.sin(0.5))
    function.TransferUserFunction2Item(mbs, spring, "springForceUserFunction")
    assert mbs.GetObjectParameter(spring, "springForceUserFunction") is function
    with pytest.raises(ValueError, match="has no user function 'force'"):
        ConvertFunctionToSymbolic(mbs, f, "force", spring)
    with pytest.raises(ValueError, match="is called with mbs and 7 further arguments"):
        ConvertFunctionToSymbolic(mbs, lambda mbs, t: t, "springForceUserFunction", spring)
    vector = CreateSymbolicUserFunction(
        mbs, lambda mbs, t, item, u, v, k, d, f0: [u, v], "springForceUserFunction", spring
    )
    with pytest.raises(ValueError, match="a symbolic function that gives a scalar"):
        mbs.SetObjectParameter(spring, "springForceUserFunction", vector)
