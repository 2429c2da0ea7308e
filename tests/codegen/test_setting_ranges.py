"""Settings reject values out of the range in their spec, for each way of setting them."""

from __future__ import annotations

import copy
import math
import pickle
from collections.abc import Iterator
from typing import Any

import pytest

import dalembert as exu
from codegen.model_settings import Setting, SettingsGroup, Specs


def numbers(group: SettingsGroup, path: str = "") -> Iterator[tuple[str, Setting]]:
    for row in group.rows:
        if row.type.storage in ("integer", "real"):
            yield path + row.name, row
    for child in group.children:
        yield from numbers(child, f"{path}{child.name}.")


@pytest.fixture(scope="module")
def rows(specs: Specs) -> dict[str, Setting]:
    root = next(each.root for each in specs.settings if each.name == "SimulationSettings")
    return dict(numbers(root))


def assign(settings: Any, path: str, value: Any) -> None:
    *groups, name = path.split(".")
    for group in groups:
        settings = getattr(settings, group)
    setattr(settings, name, value)


def nested(path: str, value: Any) -> dict[str, Any]:
    for name in reversed(path.split(".")):
        value = {name: value}
    return value  # type: ignore[no-any-return]


def beyond(row: Setting) -> list[float]:
    """The nearest values outside of the range."""
    wrong: list[float] = []
    if row.range is None:
        return {"none": wrong, "non_negative": [-1], "positive": [0, -1]}[row.effective_check]
    whole = row.type.storage == "integer"
    for bound, is_open, side in (
        (row.range.lower, row.range.lower_open, -1),
        (row.range.upper, row.range.upper_open, 1),
    ):
        if not math.isinf(bound):
            outside = bound + side if whole else math.nextafter(bound, side * math.inf)
            wrong.append(bound if is_open else outside)
    return [int(value) for value in wrong] if whole else wrong


def test_values_out_of_range_are_refused(rows: dict[str, Setting]) -> None:
    defaults = exu.SimulationSettings().GetDictionary()
    assert sum(row.range is not None for row in rows.values()) >= 30
    for path, row in rows.items():
        never = [math.nan, math.inf, -math.inf] if row.type.storage == "real" else [2**31, 10**30]
        for value in [*beyond(row), *never]:
            settings = exu.SimulationSettings()
            for write in (
                lambda: assign(settings, path, value),  # noqa: B023
                lambda: settings.SetDictionary(nested(path, value)),  # noqa: B023
            ):
                with pytest.raises(ValueError, match=f"'{path}'") as error:
                    write()
                assert "SimulationSettings" in str(error.value) and "received" in str(error.value)
                if row.range and value not in never:
                    assert f"received {value!r}" in str(error.value) and row.range.words in str(error.value)
            assert settings.GetDictionary() == defaults


def test_bounds_belong_to_closed_ranges(rows: dict[str, Setting]) -> None:
    for path, row in rows.items():
        for bound in (row.range.lower, row.range.upper) if row.range else ():
            if bound in row.range:  # type: ignore[operator]
                assign(exu.SimulationSettings(), path, int(bound) if row.type.storage == "integer" else bound)


def test_ranges_are_shown_with_the_types() -> None:
    known = exu.SimulationSettings().GetDictionaryWithTypeInfo()
    assert "from 0 to 1" in known["timeIntegration"]["generalizedAlpha"]["spectralRadius"]["description"]
    assert "from 0 to 1" in (exu.TimeIntegrationGeneralizedAlphaSettings.spectralRadius.__doc__ or "")


def test_other_ways_to_write_a_setting() -> None:
    settings = exu.SimulationSettings()
    state = settings.GetDictionary()
    state["timeIntegration"]["generalizedAlpha"]["spectralRadius"] = 1.5
    with pytest.raises(ValueError, match=r"spectralRadius'.* from 0 to 1"):
        settings.__setstate__(state)
    with pytest.raises(ValueError, match=r"timeIntegration.newton.newtonResidualMode'.* from 0 to 1"):
        settings.timeIntegration.newton.residualMode = 2  # type: ignore[attr-defined]
    with pytest.raises(ValueError, match=r"'solutionSettings.outputPrecision'.* from 1 to 17"):
        settings.solution.precision = 0  # type: ignore[attr-defined]
    with pytest.raises(ValueError, match=r"'timeIntegration.newton.maxIterations'.* at least 1"):
        settings.timeIntegration.newton = {"maxIterations": 0}  # type: ignore[assignment]
    assert settings.GetDictionary() == exu.SimulationSettings().GetDictionary()
    settings.timeIntegration.generalizedAlpha.spectralRadius = 0
    for other in (copy.deepcopy(settings), pickle.loads(pickle.dumps(settings))):
        assert other.timeIntegration.generalizedAlpha.spectralRadius == 0
