"""List helpers and integration rules."""

import math

import numpy as np
import pytest

from dalembert import basicUtilities as bu


def test_vector_helpers_return_lists():
    assert bu.VAdd([1, 2], np.array([3, 4])) == [4, 6]
    assert bu.VSub([1, 2], [3, 5]) == [-2, -3]
    assert bu.VMult([1, 2], [3, 4]) == 11
    assert bu.ScalarMult(2, [1, 2]) == [2, 4]
    assert bu.VSum([1, 2, 3]) == 6
    assert bu.NormL2([3, 4]) == 5
    assert bu.Normalize([0, 3, 4]) == pytest.approx([0, 0.6, 0.8])
    assert bu.Normalize([0, 0]) == [0, 0]
    assert bu.DiagonalMatrix(2, 3) == [[3, 0], [0, 3]]
    assert all(isinstance(x, list) for x in (bu.VAdd([1], [2]), bu.Normalize(np.ones(2)), bu.eye3D))


@pytest.mark.parametrize("function", [bu.VAdd, bu.VSub, bu.VMult])
def test_different_lengths_are_refused(function):
    with pytest.raises(ValueError, match=rf"{function.__name__}: v1: expected a vector with 2 components as v0"):
        function([1, 2], [1, 2, 3])


def test_skew_lists_are_deprecated():
    with pytest.warns(DeprecationWarning, match="Skew"):
        skew = bu.Vec2Tilde([1, 2, 3])
    assert skew == [[0, -3, 2], [3, 0, -1], [-2, 1, 0]]
    with pytest.warns(DeprecationWarning, match="Skew2Vec"):
        assert bu.Tilde2Vec(skew) == [1, 2, 3]


@pytest.mark.parametrize(
    ("x", "prec", "text"),
    [(1.23456, 3, "1.23"), (123.4, 3, "123."), (1000, 3, "1000"), (1e6, 2, "1e+06"), (1e-7, 3, "1e-07"), (5, 3, "5")],
)
def test_smart_round(x, prec, text):
    assert bu.SmartRound2String(x, prec) == text


def test_smart_round_keeps_infinity():
    assert bu.SmartRound2String(math.inf) == "inf"


def test_values_that_are_no_numbers_are_named():
    with pytest.raises(ValueError, match="SmartRound2String: x: expected a number, received None"):
        bu.SmartRound2String(None)
    with pytest.raises(TypeError, match="SmartRound2String: prec: expected an integer, 0 or more"):
        bu.SmartRound2String(1.5, "a")
    for vector in (3, ["a"]):
        with pytest.raises(ValueError, match="VSum: vector: expected a vector of numbers"):
            bu.VSum(vector)


@pytest.mark.parametrize(("rule", "orders"), [(bu.GaussIntegrate, (1, 3, 5, 7, 9)), (bu.LobattoIntegrate, (1, 3, 5))])
def test_rules_are_exact_up_to_their_order_and_not_beyond(rule, orders):
    a, b = -0.3, 1.7
    for order in orders:
        for k in range(order + 1):
            exact = (b ** (k + 1) - a ** (k + 1)) / (k + 1)
            assert rule(lambda x, k=k: x**k, order, a, b) == pytest.approx(exact, rel=1e-13)
        k = order + 1
        exact = (b ** (k + 1) - a ** (k + 1)) / (k + 1)
        assert abs(rule(lambda x, k=k: x**k, order, a, b) - exact) > 1e-6


def test_integrals_of_matrices():
    result = bu.GaussIntegrate(lambda x: np.array([[x, 1], [0, x**2]]), 3, 0, 3)
    np.testing.assert_allclose(result, [[4.5, 3], [0, 9]], atol=1e-14)


@pytest.mark.parametrize(("rule", "order"), [(bu.GaussIntegrate, 11), (bu.GaussIntegrate, 2), (bu.LobattoIntegrate, 7)])
def test_unknown_orders_are_refused(rule, order):
    with pytest.raises(ValueError, match=f"integrationOrder: expected one of 1, 3, 5.*received {order}"):
        rule(lambda x: x, order, 0, 1)


def test_clear_workspace_keeps_functions_modules_and_private_names():
    scope = {"ClearWorkspace": bu.ClearWorkspace, "np": np, "x": 1, "_y": 2, "__builtins__": __builtins__}
    exec("ClearWorkspace()", scope)
    assert set(scope) == {"ClearWorkspace", "np", "_y", "__builtins__"}


def test_vectors_that_are_none_are_named():
    with pytest.raises(ValueError, match=r"NormL2: vector: expected a vector of numbers, received \[\[1, 2\]\]"):
        bu.NormL2([[1, 2]])
    with pytest.raises(ValueError, match="Tilde2Vec: a row of m: expected a vector with 3 components"):
        bu.Tilde2Vec([[1, 2], [3, 4], [5, 6]])
    with pytest.raises(ValueError, match="Vec2Tilde: v: expected a vector with 3 components"):
        bu.Vec2Tilde([1, 2, 3, 4])
    with pytest.raises(ValueError, match="VAdd: v0: expected a vector, received 1"):
        bu.VAdd(1, 2)
