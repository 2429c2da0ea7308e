"""C functions as user functions: they agree with Python functions, and wrong signatures are rejected."""

from __future__ import annotations

import ctypes
import re
from typing import Any

import numba
import numpy as np
import pytest
from scipy import LowLevelCallable

import dalembert as exu
from codegen.model import Item, UserFunction
from codegen.views.rst import c_declaration
from dalembert import compiled
from dalembert._core import testing
from dalembert.testing.scenes import ITEMS
from dalembert.testing.tangents import random_state
from dalembert.testing.user_functions import as_c_function
from dalembert.testing.variants import ALL_VARIANTS, Variant

COMPILABLE = [(item, function) for item in ITEMS.values() for function in item.user_functions if function.compilable]
SPRING = exu.ObjectConnectorCoordinateSpringDamper
FORCE = "springForceUserFunction"


@pytest.mark.parametrize(
    "variant", [v for v in ALL_VARIANTS if v.functions and ITEMS[v.item].kind != "sensor"], ids=lambda v: v.id
)
def test_compiled_functions_agree_with_python_functions(variant: Variant) -> None:
    scene = variant.build(seed=3)
    s = random_state(scene, seed=5)
    wanted = testing.residual(scene.mbs, s), testing.tangent(scene.mbs, s, cq=0.7, cv=-1.3, ca=0.4)
    kind, number = scene.target
    get, put = (getattr(scene.mbs, f"{verb}{kind}Parameter") for verb in ("Get", "Set"))
    item = ITEMS[variant.item]
    for function in (f for owner, f in COMPILABLE if owner is item):
        c = as_c_function(item, function, get(number, function.name))
        put(number, function.name, c)
        assert get(number, function.name) is c
    # The same numbers go in and out: bit for bit.
    np.testing.assert_array_equal(testing.residual(scene.mbs, s), wanted[0])
    np.testing.assert_array_equal(testing.tangent(scene.mbs, s, cq=0.7, cv=-1.3, ca=0.4), wanted[1])


@pytest.mark.parametrize(("item", "function"), COMPILABLE, ids=lambda x: x.name)
def test_pages_show_the_signature(item: Item, function: UserFunction) -> None:
    declaration = re.sub(r" \w+(?=[,)(])|const ", "", c_declaration(function)).replace("int64_t", "int64")
    assert declaration == compiled.c_signature(item.name, function.name)


def test_functions_that_need_the_system_stay_in_python() -> None:
    with pytest.raises(ValueError, match="'sensorUserFunction' of SensorUserFunction cannot be a C function"):
        compiled.c_signature(exu.SensorUserFunction, "sensorUserFunction")
    with pytest.raises(ValueError, match="ObjectMassPoint has no user function 'force'"):
        compiled.c_signature(exu.MassPoint, "force")
    with pytest.raises(
        TypeError, match=r"a Python function, or 0 for none\. This user function cannot be a C function"
    ):
        exu.SensorUserFunction(sensorUserFunction=ctypes.CFUNCTYPE(ctypes.c_double)(float))


def spring(t: float, itemNumber: int, u: float, v: float, stiffness: float, damping: float, offset: float) -> float:
    return stiffness * u + damping * v + 1e4 * u**3


WRONG = {
    "too few": (
        ctypes.CFUNCTYPE(ctypes.c_double, ctypes.c_double)(lambda t: t),
        "That of this one is double(double); ",
    ),
    "single precision": (
        ctypes.CFUNCTYPE(ctypes.c_double, ctypes.c_double, ctypes.c_int64, *5 * [ctypes.c_float])(spring),
        "That of this one is double(double, int64, c_float, c_float, c_float, c_float, c_float); ",
    ),
    "vector": (
        compiled.ctypes_signature("ObjectConnectorCartesianSpringDamper", FORCE)(lambda *_: None),
        "That of this one is void(double, int64, double*, double*, double*, double*, double*, double*); ",
    ),
    "not declared": (
        ctypes.CDLL(None).labs,
        "That of this one is not known, set its argtypes and restype; ",
    ),
}


@pytest.mark.parametrize(("function", "advice"), WRONG.values(), ids=WRONG)
def test_wrong_signatures_are_refused(function: Any, advice: str) -> None:
    with pytest.raises(TypeError) as caught:
        SPRING(springForceUserFunction=function)
    text = str(caught.value)
    assert text.startswith("ObjectConnectorCoordinateSpringDamper, parameter 'springForceUserFunction': received <")
    signature = "double(double, int64, double, double, double, double, double)"
    assert f"but expected a C function with the signature {signature}. {advice}" in text
    assert text.endswith("dalembert.compiled gives the right one to numba and ctypes.")


def oscillator(mbs: exu.MainSystem, function: Any) -> float:
    """Position after free vibration with a spring of the given law."""
    node = mbs.AddNode(exu.NodePoint(initialCoordinates=[0.1, 0, 0]))
    mbs.AddObject(exu.MassPoint(physicsMass=2, nodeNumber=node))
    ground = mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=mbs.AddNode(exu.NodePointGround()), coordinate=0))
    marker = mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=node, coordinate=0))
    mbs.AddObject(
        SPRING("law", markerNumbers=[ground, marker], stiffness=300, damping=5, springForceUserFunction=function)
    )
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps, settings.timeIntegration.endTime = 100, 0.5
    settings.solutionSettings.writeSolutionToFile = False
    mbs.SolveDynamic(settings)
    return float(mbs.GetNodeOutput(node, exu.OutputVariableType.Displacement)[0])


def new_system() -> exu.MainSystem:
    return exu.SystemContainer().AddSystem()


def test_scipy_callable_and_function_pointer_solve_alike() -> None:
    pointer = compiled.ctypes_signature(SPRING, FORCE)(spring)
    wanted = oscillator(new_system(), lambda mbs, *arguments: spring(*arguments))
    assert oscillator(new_system(), pointer) == wanted
    assert oscillator(new_system(), LowLevelCallable(pointer)) == wanted
    mbs = new_system()
    with pytest.raises(TypeError, match="double\\) with user data; "):
        SPRING(springForceUserFunction=LowLevelCallable(pointer, ctypes.c_void_p(1)))
    assert oscillator(mbs, pointer) == wanted


def test_functions_of_the_main_system() -> None:
    times: dict[str, list[float]] = {"PreStep": [], "PostStep": []}

    def noted(name: str, end: float) -> Any:
        def step(t: float) -> int:
            times[name].append(t)
            return int(t < end)

        return compiled.ctypes_signature(exu.MainSystem, f"{name}UserFunction")(step)

    mbs = new_system()
    mbs.SetPreStepUserFunction(noted("PreStep", 1))
    mbs.SetPostStepUserFunction(noted("PostStep", 0.25 - 1e-9))
    oscillator(mbs, 0)
    # Steps of 5 ms up to the end; called after each step, and at the start.
    np.testing.assert_allclose(times["PreStep"], 5e-3 * np.arange(1, 51), rtol=1e-12)
    np.testing.assert_allclose(times["PostStep"], 5e-3 * np.arange(51), rtol=1e-12)
    with pytest.raises(TypeError, match=r"SetPostStepUserFunction.*a C function with the signature int64\(double\)"):
        mbs.SetPostStepUserFunction(ctypes.CFUNCTYPE(ctypes.c_double, ctypes.c_double)(abs))


def test_function_after_newton_asks_for_iterations() -> None:
    calls = []

    def switch(t: float, result: Any) -> None:
        calls.append(t)
        result[0] = 2.0 if len(calls) % 3 else 0.0  # two of three times above discontinuous.iterationTolerance = 1

    mbs = new_system()
    mbs.SetPostNewtonUserFunction(compiled.ctypes_signature(exu.MainSystem, "PostNewtonUserFunction")(switch))
    oscillator(mbs, 0)
    np.testing.assert_allclose(calls, np.repeat(5e-3 * np.arange(1, 101), 3), rtol=1e-12)


def test_results_must_be_finite() -> None:
    mbs = new_system()
    pointer = compiled.ctypes_signature(SPRING, FORCE)(lambda *_: float("nan"))
    with pytest.raises(ValueError) as caught:
        oscillator(mbs, pointer)
    assert str(caught.value) == (
        "user function 'springForceUserFunction' of object 1 'law' (ObjectConnectorCoordinateSpringDamper): "
        "received nan as result, but expected finite numbers. Check the calculation that the value comes from."
    )


def test_numba_callback_solves_as_python_does() -> None:
    signature = compiled.numba_signature(SPRING, FORCE)
    # Compiled arithmetic may fuse products and sums: an error of rounding per step.
    assert oscillator(new_system(), numba.cfunc(signature)(spring)) == pytest.approx(
        oscillator(new_system(), lambda mbs, *arguments: spring(*arguments)), rel=1e-12
    )


def test_numba_callback_of_vectors() -> None:

    @numba.cfunc(compiled.numba_signature(exu.LoadForceVector, "loadVectorUserFunction"))
    def turning(t, load, result):  # type: ignore[no-untyped-def]
        vector = numba.carray(load, 3)
        for i in range(3):
            result[i] = t * vector[i]

    mbs = new_system()
    node = mbs.AddNode(exu.NodePoint())
    mbs.AddObject(exu.MassPoint(physicsMass=1, nodeNumber=node))
    marker = mbs.AddMarker(exu.MarkerNodePosition(nodeNumber=node))
    load = mbs.AddLoad(exu.Force(markerNumber=marker, loadVector=[1, 2, 3], loadVectorUserFunction=turning))
    mbs.Assemble()
    mbs.systemData.SetTime(0.5)
    assert mbs.GetLoadValues(load).tolist() == [0.5, 1.0, 1.5]
