"""A differentiable model as a function of JAX or PyTorch."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np

from dalembert._checks import FloatArray

if TYPE_CHECKING:
    from dalembert._studies.differentiable_model import DifferentiableModel


def _import(package: str, function: str) -> Any:
    try:
        return __import__(package)
    except ImportError as error:
        raise ImportError(
            f"DifferentiableModel.{function}: {package} is not installed: pip install {package}"
        ) from error


def _solved(model: DifferentiableModel, x: Any) -> tuple[FloatArray, FloatArray]:
    """Return all outputs, and their Jacobian."""
    found = model.Sensitivities(np.array(x, dtype=float))
    return model._values(found), np.array(found.matrix)


def jax_function(model: DifferentiableModel) -> Callable[[Any], Any]:
    jax = _import("jax", "JaxFunction")
    if not jax.config.jax_enable_x64:
        raise ValueError(
            "DifferentiableModel.JaxFunction: JAX computes with 32 bits, which is not enough for derivatives of "
            "simulations; call jax.config.update('jax_enable_x64', True) first"
        )
    size, count = model._size, len(model.names)
    values = jax.ShapeDtypeStruct((size,), np.float64)
    jacobian = jax.ShapeDtypeStruct((size, count), np.float64)

    @jax.custom_jvp  # type: ignore[untyped-decorator, unused-ignore]
    def function(x: Any) -> Any:
        return jax.pure_callback(lambda at: _solved(model, at)[0], values, x, vmap_method="sequential")

    @function.defjvp  # type: ignore[untyped-decorator, unused-ignore]
    def derivative(at: Any, along: Any) -> Any:
        y, slopes = jax.pure_callback(lambda x: _solved(model, x), (values, jacobian), at[0], vmap_method="sequential")
        return y, slopes @ along[0]

    return function  # type: ignore[no-any-return, unused-ignore]


def torch_function(model: DifferentiableModel) -> Callable[[Any], Any]:
    torch = _import("torch", "TorchFunction")

    class Solution(torch.autograd.Function):  # type: ignore[misc, name-defined, unused-ignore]
        @staticmethod
        def forward(ctx: Any, x: Any) -> Any:
            y, slopes = _solved(model, x.detach().cpu().numpy())
            ctx.save_for_backward(torch.as_tensor(slopes, device=x.device))
            return torch.as_tensor(y, device=x.device)

        @staticmethod
        @torch.autograd.function.once_differentiable  # type: ignore[untyped-decorator, unused-ignore]
        def backward(ctx: Any, weights: Any) -> Any:
            return weights @ ctx.saved_tensors[0]

    def function(x: Any) -> Any:
        if x.dtype != torch.float64:
            raise ValueError(
                f"DifferentiableModel.TorchFunction: received a tensor of {x.dtype}, which is not enough for "
                "derivatives of simulations; expected torch.float64"
            )
        return Solution.apply(x)

    return function
