"""Every real parameter of every item: derivatives of equations are those of a model that is built with other values.

Copies of a model are varied in groups, as in mbs.ComputeSensitivities; here each model is built anew, changed before it
is assembled, and differentiated with steps of another size.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import dalembert as exu
import dalembert.itemInterface as items
from codegen.load import load
from dalembert._core import testing
from dalembert._studies.design_parameters import Parameter, Parameters

CENTRAL = {-2: 1 / 12, -1: -8 / 12, 1: 8 / 12, 2: -1 / 12}
KINDS = ("Node", "Object", "Marker", "Load")
INDEX = {"Node": exu.NodeIndex, "Object": exu.ObjectIndex, "Marker": exu.MarkerIndex, "Load": exu.LoadIndex}
READY = [
    item
    for item in load(Path(__file__).parents[2]).items
    if item.ready and item.example and item.name.startswith(KINDS)
]


def build(item: Any) -> Any:
    """Run the example of the page of an item."""
    SC = exu.SystemContainer()
    names = {name: value for name, value in vars(items).items() if not name.startswith("_")}
    mbs = SC.AddSystem()
    exec(compile(item.example.code, item.path, "exec"), names | {"exu": exu, "np": np, "SC": SC, "mbs": mbs})
    mbs.Assemble()
    return mbs


def state_of(mbs: Any) -> Any:
    """A state near the start, at which nothing vanishes."""
    data = mbs.systemData
    n, n1, m = data.ODE2Size(), data.ODE1Size(), data.AEsize()
    random = np.random.default_rng(3)
    parts = [data.GetODE2Coordinates() + 1e-2 * random.uniform(0.5, 1, n), random.uniform(0.1, 0.2, n), random.normal(size=n),
             data.GetODE1Coordinates() + 1e-2 * random.normal(size=n1), random.normal(size=n1), random.normal(size=m),
             data.GetDataCoordinates()]  # fmt: skip
    return np.concatenate(parts)


def numbers_of(mbs: Any, item: Any) -> tuple[str, list[int]]:
    kind = next(kind for kind in KINDS if item.name.startswith(kind))
    name = item.name.removeprefix(kind)
    count = getattr(mbs.systemData, f"NumberOf{kind}s")()
    return kind, [n for n in range(count) if getattr(mbs, f"Get{kind}")(n)[f"{kind.lower()}Type"] == name]


def cases_of(mbs: Any, item: Any) -> list[tuple[str, Any, tuple[Any, ...]]]:
    """(kind, index, (parameter, entry)) of the first entry of each real parameter that is set, which is not zero."""
    kind, numbers = numbers_of(mbs, item)
    found = []
    for row in item.parameters:
        if row.internal or not numbers:
            continue
        value = getattr(mbs, f"Get{kind}Parameter")(numbers[0], row.name)
        if isinstance(value, bool) or not isinstance(value, (float, list, np.ndarray)):
            continue
        try:
            array = np.asarray(value)
        except ValueError:
            continue
        if array.size == 0 or array.dtype.kind != "f":
            continue
        entry: tuple[Any, ...] = ()
        if array.ndim:
            places = np.argwhere(array != 0)
            place = tuple(int(i) for i in (places[0] if len(places) else np.zeros(array.ndim, dtype=int)))
            entry = (place if len(place) > 1 else place[0],)
        found.append((kind, INDEX[kind](numbers[0]), (row.name, *entry)))
    return found


def residual_of(item: Any, kind: str, index: Any, name: str, entry: Any, change: float, z: Any) -> Any:
    """Residual of a model that is built anew with another value; total rotations stay as they are."""
    mbs = build(item)
    reference = mbs.systemData.GetODE2Coordinates(exu.ConfigurationType.Reference)
    value = getattr(mbs, f"Get{kind}Parameter")(index, name)
    if entry:
        value = np.array(value, dtype=float)
        value[entry[0]] += change
    else:
        value += change
    getattr(mbs, f"Set{kind}Parameter")(index, name, value)
    mbs.Assemble()
    derivatives = testing.SystemDerivatives(mbs)
    z = z.copy()
    moved = mbs.systemData.GetODE2Coordinates(exu.ConfigurationType.Reference) - reference
    turned = (np.array(derivatives.rotations, dtype=int)[:, None] + np.arange(3)).ravel()
    z[turned] -= moved[turned]
    return np.asarray(derivatives.residual(z, 0.1, 0.01))


# A single entry of these cannot vary; a DesignParameter that moves all of them can.
UNIT = ("columns are unit vectors", "expected a vector of length 1", "expected four Euler parameters")
REFUSED = {
    "ObjectContactSphereSphere.contactPlasticityRatio": "switches something on or off at 0",
    **{
        f"Marker{kind}Rigid.localRotation": "cannot change in an assembled model"
        for kind in ("Body", "KinematicTree", "Node", "SuperElement")
    },
    "ObjectFFRFreducedOrder.modeBasis": "cannot change in an assembled model",
    "ObjectFFRFreducedOrder.referencePositions": "cannot change in an assembled model",
    "ObjectFFRFreducedOrder.mPsiTildePsi": "it does not belong to mPsiTildePsiTilde",
    "ObjectFFRFreducedOrder.mPhitTPsi": "it does not belong to mPhitTPsi",
    "ObjectFFRFreducedOrder.mPhitTPsiTilde": "it does not belong to mPhitTPsi",
    "ObjectFFRFreducedOrder.mXRefTildePsi": "it does not belong to mXRefTildePsiTilde",
}


@pytest.mark.parametrize("item", READY, ids=lambda item: item.name)
def test_derivatives_by_every_real_parameter(item: Any) -> None:
    mbs = build(item)
    z = state_of(mbs)
    for kind, index, (name, *entry) in cases_of(mbs, item):
        label = f"{item.name}.{name}"
        try:
            parameter = Parameter(mbs, "p", (index, name, *entry))
            parameters = Parameters(mbs, [parameter], [], {}, (z, 0.1))
        except exu.NotDifferentiable as refused:
            if not any(text in str(refused) for text in UNIT):
                assert REFUSED.get(label, "not listed") in str(refused), label
            continue
        assert label not in REFUSED
        found = parameters.rates(parameters.residual_at(z, 0.1, 0.01))[0]
        step = 0.5 * parameter.step
        expected: Any = 0.0
        largest = 0.0
        for multiple, weight in parameter.formula.items():
            residual = residual_of(item, kind, index, name, entry, multiple * step, z)
            largest = max(largest, float(np.abs(residual).max(initial=0.0)))
            expected = expected + weight / step * residual
        noise = 1e-11 * largest / step
        assert np.all(np.abs(found - expected) <= 1e-6 * np.abs(expected).max(initial=0.0) + noise), label
