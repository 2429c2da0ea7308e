"""help() shows the texts of specs: texts of item classes, of their parameters and of Create functions."""

from __future__ import annotations

import inspect
import re
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).parents[2]))

from codegen.load import load
from codegen.model import Item, Parameter
from codegen.views.cpp import one_line
from dalembert import create
from dalembert import itemInterface as items
from dalembert.create._mirrors import MIRRORS, arguments, mirrored
from dalembert.create.contacts import TRIANGLE

ITEMS = load(Path(__file__).parents[2]).items
# Defaults that the reference has otherwise than those of the item: the function finds a value, or has another habit.
OTHER_DEFAULTS = {
    ("CreateSpringDamper", "referenceLength"): None,
    ("CreateDistanceConstraint", "distance"): None,
    ("CreateRigidBodySpringDamper", "intrinsicFormulation"): True,
    ("CreateKinematicTree", "linkForces"): None,
    ("CreateKinematicTree", "linkTorques"): None,
    ("CreateFFRFReducedOrderObject", "name"): inspect.Parameter.empty,
    ("CreateFFRFReducedOrderObject", "color"): [0, 1, 0, 1],
    ("CreateSphereQuadContact", "includeEdges"): 15,
    ("CreateSphereTriangleContact", "trianglePoints"): TRIANGLE,
    **{
        ("CreateHydraulicCylinder", argument): value
        for argument, value in (
            *(("strokeLength", 0.5), ("systemPressure", 1e7), ("tankPressure", 1e5)),
            *(("nominalFlow", 2e-7), ("oilBulkModulus", 1.5e9)),
        )
    },
    **{(f"CreateSphere{other}Contact", "color"): [-1, -1, -1, -1] for other in ("Sphere", "Triangle", "Quad")},
}


line = one_line  # the output of terminals


def lines_of(thing: Any) -> list[str]:
    return [text.strip() for text in (thing.__doc__ or "").splitlines()]


@pytest.mark.parametrize("item", ITEMS, ids=lambda item: item.name)
def test_classes(item: Item) -> None:
    """Summary, parameters with type, unit and meaning, outputs."""
    classes = (getattr(items, item.name), item.parameters), (getattr(items, f"V{item.name}"), item.visualization)
    assert lines_of(classes[0][0])[0] == line(item.summary)
    for cls, rows in classes:
        told = lines_of(cls)
        for row in rows:
            assert getattr(cls, row.name).__doc__.splitlines()[1] == line(row.doc)
            if not row.internal:
                assert_described(told, row)
    told = lines_of(classes[0][0])
    for output in item.outputs:
        first = next(
            i for i, text in enumerate(told) if text.startswith(f"{output.name}: ") and told[i + 1] == line(output.doc)
        )
        assert told[first].endswith(f", unit {output.unit}")


def assert_described(told: list[str], row: Parameter) -> None:
    first = next(i for i, text in enumerate(told) if text.startswith(f"{row.name}: "))
    assert " = " in told[first]
    assert not row.unit or f", unit {row.unit}" in told[first]
    assert told[first + 1] == line(row.doc)


@pytest.mark.parametrize("name", create.functions)
def test_create_functions(name: str) -> None:
    """Each argument is described; arguments that correspond to parameters have the default and the text of the spec."""
    function = create.functions[name]
    told, rows = lines_of(function), mirrored(function)
    classes = [getattr(items, prefix + item)() for item in MIRRORS.get(name, ()) for prefix in ("", "V")]
    for argument, parameter in list(inspect.signature(function).parameters.items())[1:]:
        first = next(i for i, text in enumerate(told) if text.startswith(f"{argument}: "))
        assert told[first + 1]
        if argument in rows:
            assert told[first + 1] == rows[argument].text
            default = next(getattr(cls, rows[argument].name) for cls in classes if hasattr(cls, rows[argument].name))
            np.testing.assert_equal(parameter.default, OTHER_DEFAULTS.get((name, argument), default))


@pytest.mark.parametrize("name", create.functions)
def test_types_of_arguments_are_said_in_words(name: str) -> None:
    plain = inspect.unwrap(create.functions[name])
    for argument in arguments(plain, create.checks(plain)):
        assert not re.search(r"\b(Any|npt|Sequence|Callable|list\[)|\||^list$", argument.type), argument
        assert "array(" not in argument.default


def test_every_create_function_mirrors_an_item() -> None:
    of_no_item = {"CreateDistanceSensorGeometry"}  # general contact is none
    assert set(MIRRORS) == set(create.functions) - of_no_item


def test_other_defaults_are_others() -> None:
    for (name, argument), default in OTHER_DEFAULTS.items():
        classes = [getattr(items, prefix + MIRRORS[name][0])() for prefix in ("", "V")]
        of_item = next(getattr(cls, argument) for cls in classes if hasattr(cls, argument))
        np.testing.assert_equal(inspect.signature(create.functions[name]).parameters[argument].default, default)
        assert not np.array_equal(of_item, default)


def test_checks_are_those_of_the_spec() -> None:
    """No check is said for a negative stiffness in the functions themselves."""
    import dalembert as exu

    mbs = exu.SystemContainer().AddSystem()
    with pytest.raises(ValueError, match=r"CreateSpringDamper\(...\): argument 'stiffness': .*not negative.*-1"):
        mbs.CreateSpringDamper(bodyNumbers=[0, 1], stiffness=-1)
