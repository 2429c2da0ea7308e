"""DifferentiableModel as a function of JAX and PyTorch, where they are installed."""

from __future__ import annotations

import sys
from typing import Any

import numpy as np
import pytest

import dalembert as exu
from dalembert.itemInterface import (
    CoordinateSpringDamper,
    MarkerNodeCoordinate,
    Mass1D,
    Node1D,
    NodePointGround,
    SensorNode,
)


def model(method: str = "auto") -> Any:
    """A mass on a spring and a damper: places at two times, and the velocity at the end."""
    mbs = exu.SystemContainer().AddSystem()
    node = mbs.AddNode(Node1D(referenceCoordinates=[0], initialCoordinates=[0.1], name="node"))
    mbs.AddObject(Mass1D(physicsMass=2, nodeNumber=node))
    ends = [
        mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=each, coordinate=0))
        for each in (mbs.AddNode(NodePointGround()), node)
    ]
    mbs.AddObject(CoordinateSpringDamper(markerNumbers=ends, stiffness=50, damping=0.5, name="spring"))
    mbs.AddSensor(SensorNode(nodeNumber=node, outputVariableType=exu.OutputVariableType.Coordinates, name="x"))
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.endTime, settings.timeIntegration.numberOfSteps = 0.4, 40
    parameters = {"k": ("spring", "stiffness"), "d": ("spring", "damping")}
    return exu.DifferentiableModel(
        mbs, parameters, {"x": exu.At("x", [0.2, 0.4]), "v": exu.Final(0, 1)}, settings, method=method
    )


def expected(x: Any) -> tuple[Any, Any]:
    found = model().Sensitivities(x)
    return np.concatenate([np.atleast_1d(value) for value in found.values.values()]), found.matrix


def test_jax() -> None:
    jax = pytest.importorskip("jax", reason="jax is installed by the extra [gradients]")
    with pytest.raises(ValueError, match="jax_enable_x64"):
        model().JaxFunction()
    jax.config.update("jax_enable_x64", True)
    try:
        function, x = model().JaxFunction(), np.array([52.0, 0.6])
        values, matrix = expected(x)
        np.testing.assert_allclose(function(x), values, rtol=1e-14)
        np.testing.assert_allclose(jax.jacrev(function)(x), matrix, rtol=1e-13)
        np.testing.assert_allclose(jax.jacfwd(function)(x), matrix, rtol=1e-13)

        def cost(p: Any) -> Any:
            return jax.numpy.sum(function(p * p) ** 2)

        slope = jax.jit(jax.grad(cost))(np.sqrt(x))
        np.testing.assert_allclose(slope, 2 * values @ matrix * 2 * np.sqrt(x), rtol=1e-12)
        several = jax.vmap(function)(np.array([x, 1.1 * x]))
        np.testing.assert_allclose(several[1], expected(1.1 * x)[0], rtol=1e-14)
    finally:
        jax.config.update("jax_enable_x64", False)


def test_torch() -> None:
    torch = pytest.importorskip("torch", reason="torch is installed by the extra [gradients]")
    function, x = model().TorchFunction(), torch.tensor([52.0, 0.6], dtype=torch.float64, requires_grad=True)
    values, matrix = expected(x.detach().numpy())
    y = function(x)
    np.testing.assert_allclose(y.detach().numpy(), values, rtol=1e-14)
    (y**2).sum().backward()
    np.testing.assert_allclose(x.grad.numpy(), 2 * values @ matrix, rtol=1e-12)
    with pytest.raises(ValueError, match=r"received a tensor of torch.float32.*expected torch.float64"):
        function(x.detach().float())


@pytest.mark.parametrize(("package", "function"), [("jax", "JaxFunction"), ("torch", "TorchFunction")])
def test_missing_packages_are_named(package: str, function: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, package, None)
    with pytest.raises(ImportError, match=f"{function}: {package} is not installed: pip install {package}"):
        getattr(model(), function)()
