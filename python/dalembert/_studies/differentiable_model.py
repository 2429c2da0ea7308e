"""A model as a differentiable function of its parameters, for optimizers."""

from __future__ import annotations

import copy
import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike

from dalembert._checks import FloatArray, as_vector, shape_error
from dalembert._core import DynamicSolverType, MainSystem, SimulationSettings
from dalembert._solving.quiet import assemble_if_needed, given_or_default
from dalembert._studies.design_parameters import Parameter
from dalembert._studies.difference_formulas import CENTRAL
from dalembert._studies.exact_sensitivities import Method, Problem, read_outputs
from dalembert._studies.exact_sensitivities import Sensitivities as Found


class DifferentiableModel:
    """Outputs of an assembled model as a function of its parameters, with derivatives: see mbs.ComputeSensitivities.

    Parameters are given as vectors in the order of `names`, or as dictionaries. The model is copied: mbs does not
    change. The last solution is kept, so that a value and its gradient at one point need one solution.

    steps: if tolerances choose the steps, 'frozen': they choose them anew in each solution, and derivatives are those
    with these steps; 'replay': all solutions have the steps of the first one, so that derivatives are those of the
    function that is computed.

    names, x0: names and present values of the parameters; bounds: (lower, upper), infinite where an item accepts
    everything.
    """

    __module__ = "dalembert"

    def __init__(
        self,
        mbs: MainSystem,
        parameters: Mapping[str, Any],
        outputs: Mapping[str, Any],
        simulationSettings: SimulationSettings | None = None,
        solverType: Any = DynamicSolverType.GeneralizedAlpha,
        method: Method = "auto",
        *,
        consistentStart: bool = False,
        maximumMemory: float | None = None,
        steps: Literal["frozen", "replay"] = "frozen",
    ) -> None:
        assemble_if_needed("DifferentiableModel", mbs, True)
        self._settings = copy.deepcopy(given_or_default("DifferentiableModel", simulationSettings))
        if steps not in ("frozen", "replay"):
            raise ValueError(f"DifferentiableModel: steps: received {steps!r}, but expected 'frozen' or 'replay'")
        if steps == "replay" and solverType == "static":
            raise ValueError("DifferentiableModel: steps='replay' needs a time integration")
        self._replays = steps == "replay"
        self._ends: FloatArray | None = None  # of steps, by the first solution
        self._options = solverType, consistentStart, maximumMemory
        Problem(mbs, parameters, outputs, self._settings, *self._options)  # checks
        self._mbs = copy.copy(mbs)
        self._given, self._outputs = dict(parameters), read_outputs(outputs)
        self._method: Method = method
        self._parameters = [Parameter(self._mbs, name, each, self._settings) for name, each in parameters.items()]
        self.names = list(parameters)
        self.x0 = np.array([parameter.value for parameter in self._parameters])
        self._point: FloatArray | None = None
        self._found: Found | None = None

    @property
    def bounds(self) -> tuple[FloatArray, FloatArray]:
        """Lower and upper bounds: 0 for parameters that may not be negative."""
        lower = [0.0 if self._refuses(parameter, -1.0) else -math.inf for parameter in self._parameters]
        return np.array(lower), np.full(len(lower), math.inf)

    def _refuses(self, parameter: Parameter, sign: float) -> bool:
        trial = copy.copy(self._mbs)
        if not parameter.changes_model:  # an end time, or a frequency
            return True
        try:
            parameter.set(trial, sign * max(1.0, abs(parameter.value)))
        except (ValueError, RuntimeError):
            return True
        return False

    def _vector(self, x: ArrayLike | Mapping[str, float]) -> FloatArray:
        if isinstance(x, Mapping):
            unknown = [name for name in x if name not in self.names]
            missing = [name for name in self.names if name not in x]
            if unknown or missing:
                raise ValueError(f"DifferentiableModel: received parameters {list(x)}, but expected {self.names}")
            x = [x[name] for name in self.names]
        return as_vector("DifferentiableModel: x", x, len(self.names))

    def Sensitivities(self, x: ArrayLike | Mapping[str, float]) -> Found:
        """Return values and derivatives of all outputs."""
        point = self._vector(x)
        if self._found is None or self._point is None or not np.array_equal(point, self._point):
            mbs, settings = copy.copy(self._mbs), copy.deepcopy(self._settings)
            for parameter, value in zip(self._parameters, point, strict=True):
                if parameter.is_end_time:
                    settings.timeIntegration.endTime = float(value)
                parameter.set(mbs, float(value))
            mbs.Assemble()
            given = {
                name: _moved(each, float(value)) for (name, each), value in zip(self._given.items(), point, strict=True)
            }

            def solved() -> Found:
                ends = self._ends_until(settings.timeIntegration.endTime)
                return Problem(mbs, given, self._outputs, settings, *self._options, ends).solve(self._method)

            if self._replays and self._ends is None:
                self._ends = solved()._ends
            self._found, self._point = solved(), point.copy()
        return self._found

    def _ends_until(self, end: float) -> FloatArray | None:
        """Return the ends of steps of the first solution, in a duration that may be a parameter."""
        if self._ends is None:
            return None
        first = self._ends[0]
        times = first + (self._ends[1:] - first) * ((end - first) / (self._ends[-1] - first))
        times[-1] = end
        return np.asarray(times)

    def __call__(self, parameterSet: Mapping[str, Any]) -> Any:
        """Return all numbers of the outputs, or a number if there is one, for the functions of dalembert.processing.

        Parameters that are not given have their present values.
        """
        values = self._values(self.Sensitivities(self._completed(parameterSet)))
        return float(values[0]) if len(values) == 1 else values

    def slopes(self, parameterSet: Mapping[str, Any], names: Sequence[str]) -> FloatArray:
        """Return derivatives, a row for each of these parameters and a column for each number of the outputs."""
        found = self.Sensitivities(self._completed(parameterSet)).matrix
        return np.asarray(found[:, [self.names.index(name) for name in names]].T)

    def _completed(self, parameterSet: Mapping[str, Any]) -> dict[str, Any]:
        given = {name: x for name, x in parameterSet.items() if name not in ("computationIndex", "functionData")}
        return dict(zip(self.names, self.x0.tolist(), strict=True)) | given

    def Values(self, x: ArrayLike | Mapping[str, float]) -> dict[str, Any]:
        """Return values of all outputs by name."""
        return self.Sensitivities(x).values

    def _values(self, found: Found) -> FloatArray:
        return np.concatenate([np.atleast_1d(value) for value in found.values.values()])

    def _weights(self, weights: Mapping[str, Any] | None, found: Found) -> FloatArray:
        """Return one weight per number of the outputs."""
        if weights is None:
            if len(found.values) > 1:
                raise ValueError(
                    "DifferentiableModel: there are several outputs; pass weights, such as "
                    f"{{'{next(iter(found.values))}': 1}}"
                )
            weights = dict.fromkeys(found.values, 1.0)
        for name in weights:
            if name not in found.values:
                raise ValueError(
                    f"DifferentiableModel: weights: received output '{name}', but there are {', '.join(found.values)}"
                )
        return np.concatenate(
            [
                np.broadcast_to(weights.get(name, 0.0), np.shape(np.atleast_1d(value)))
                for name, value in found.values.items()
            ]
        ).astype(float)

    def ValueAndGradient(
        self, x: ArrayLike | Mapping[str, float], weights: Mapping[str, Any] | None = None
    ) -> tuple[float, FloatArray]:
        """Return the weighted sum of outputs and its gradient, for scipy.optimize.minimize(..., jac=True)."""
        found = self.Sensitivities(x)
        factors = self._weights(weights, found)
        return float(factors @ self._values(found)), factors @ found.matrix

    def Residuals(
        self, x: ArrayLike | Mapping[str, float], data: Mapping[str, ArrayLike] | None = None
    ) -> tuple[FloatArray, FloatArray]:
        """Return outputs minus data (by name), and their Jacobian; without data, all outputs."""
        found = self.Sensitivities(x)
        names = list(found.values) if data is None else list(data)
        parts, rows = [], []
        for name in names:
            if name not in found.values:
                raise ValueError(f"Residuals: received data of '{name}', but the outputs are {', '.join(found.values)}")
            value = np.atleast_1d(found.values[name])
            measured = (
                np.zeros(len(value))
                if data is None
                else as_vector(f"Residuals: data['{name}']", np.atleast_1d(data[name]), len(value))
            )
            parts.append(value - measured)
            rows.append(found.matrix[found._rows[name]])
        return np.concatenate(parts), np.vstack(rows)

    def LeastSquares(
        self, data: Mapping[str, ArrayLike]
    ) -> tuple[Callable[[ArrayLike], FloatArray], Callable[[ArrayLike], FloatArray]]:
        """Return functions for scipy.optimize.least_squares(residuals, x0, jac=jacobian)."""
        return lambda x: self.Residuals(x, data)[0], lambda x: self.Residuals(x, data)[1]

    def Jvp(self, x: ArrayLike | Mapping[str, float], dx: ArrayLike) -> FloatArray:
        """Return the change of all outputs with a change of the parameters."""
        return np.asarray(self.Sensitivities(x).matrix @ as_vector("Jvp: dx", dx, len(self.names)))

    def Vjp(self, x: ArrayLike | Mapping[str, float], weights: Mapping[str, Any]) -> FloatArray:
        """Return the gradient of a weighted sum of outputs."""
        found = self.Sensitivities(x)
        return np.asarray(self._weights(weights, found) @ found.matrix)

    def JaxFunction(self) -> Callable[[Any], Any]:
        """Return the model as a function of JAX: from an array of parameters to one of all numbers of the outputs.

        It works with grad, jvp, jacobian, jit and vmap. JAX has to compute with 64 bits. The order is that of
        Sensitivities(x).outputs.
        """
        from dalembert._studies.autograd_adapters import jax_function

        return jax_function(self)

    def TorchFunction(self) -> Callable[[Any], Any]:
        """Return the model as a function of PyTorch: from a tensor of parameters to one of all numbers of the outputs.

        Tensors are of torch.float64; the order is that of Sensitivities(x).outputs.
        """
        from dalembert._studies.autograd_adapters import torch_function

        return torch_function(self)

    @property
    def _size(self) -> int:
        return sum(output.size for output in self._outputs.values())

    def Covariance(self, x: ArrayLike | Mapping[str, float], sigma: float | ArrayLike = 1.0) -> FloatArray:
        """Return the covariance of parameters that are fitted to data of all outputs.

        sigma: standard deviations of the data. The covariance is that of the linearized least-squares problem: the
        inverse of J^T S^-1 J.
        """
        jacobian = self.Sensitivities(x).matrix
        deviations = np.broadcast_to(np.asarray(sigma, dtype=float), len(jacobian))
        if not np.all(deviations > 0):
            raise shape_error("Covariance: sigma", "positive standard deviations", sigma)
        weighted = jacobian / deviations[:, None]
        scale = np.linalg.norm(weighted, axis=0)
        singular = np.linalg.svd(weighted / np.where(scale > 0, scale, 1.0), compute_uv=False)
        if len(weighted) < len(self.names) or np.any(scale == 0) or singular[-1] < 1e-10 * singular[0]:
            raise ValueError(
                "Covariance: the outputs do not determine all parameters; add outputs, or leave out parameters"
            )
        return np.asarray(np.linalg.inv(weighted.T @ weighted))

    def Check(self, x: ArrayLike | Mapping[str, float], digits: int = 6) -> str:
        """Compare derivatives with differences of whole solutions; return those that disagree, '' if there are none."""
        point = self._vector(x)
        found = self.Sensitivities(point)
        lines = []
        for k, (name, parameter) in enumerate(zip(self.names, self._parameters, strict=True)):
            step = 1e-3 * (abs(point[k]) if point[k] != 0 else parameter.step / 1e-3)
            unit = np.eye(len(point))[k]
            differences = sum(
                weight / step * self._solved(point + multiple * step * unit) for multiple, weight in CENTRAL.items()
            )
            size = np.abs(found.matrix).max(axis=1) + 1e-300
            for row, (exact, compared) in enumerate(zip(found.matrix[:, k], np.asarray(differences), strict=True)):
                if abs(exact - compared) > 10.0**-digits * max(size[row], abs(compared)):
                    lines.append(f"d {found.outputs[row]}/d {name}: {exact:.10g}, by differences {compared:.10g}")
        self._found, self._point = found, point
        return "\n".join(lines)

    def _solved(self, x: FloatArray) -> FloatArray:
        return self._values(self.Sensitivities(x))


def _moved(given: Any, value: float) -> Any:
    """Return what stands for a parameter at another value."""
    from dalembert._studies.design_parameters import DesignParameter

    return DesignParameter(value, given.targets or None) if isinstance(given, DesignParameter) else given
