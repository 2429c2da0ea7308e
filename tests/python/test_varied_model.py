"""Studies of one model: results of each set of parameters are those of a separate solution."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.optimize import differential_evolution

import dalembert as exu
from dalembert import processing
from dalembert.processing import FailedEvaluation, FailedVariation, VariedModel

MASS, FORCE, LENGTH = 2.0, 3.0, 0.5


def oscillator() -> tuple[Any, Any]:
    """A mass on a spring that is pulled: it comes to rest at FORCE / stiffness."""
    mbs = exu.SystemContainer().AddSystem()
    mass = mbs.CreateMassPoint("mass", [LENGTH, 0, 0], physicsMass=MASS)
    mbs.CreateCoordinateConstraint(bodyNumbers=[None, mass], coordinates=[None, 1])
    mbs.CreateCoordinateConstraint(bodyNumbers=[None, mass], coordinates=[None, 2])
    mbs.CreateCartesianSpringDamper(
        "spring", [mbs.CreateGround(), mass], localPosition0=[LENGTH, 0, 0], stiffness=[10, 0, 0], damping=[1, 0, 0]
    )
    mbs.CreateForce("pull", mass, [FORCE, 0, 0])
    mbs.AddSensor(exu.SensorBody(name="way", bodyNumber="mass", outputVariableType=exu.OutputVariableType.Displacement))
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = 20
    return mbs, settings


def model(**options: Any) -> VariedModel:
    mbs, settings = oscillator()
    parameters = {
        "k": ("spring", "stiffness", 0),
        "force": ("pull", "loadVector", 0),
        "time": "timeIntegration.endTime",
    }
    return VariedModel(mbs, parameters, lambda r, i: float(r.SensorValues("way")[i, 0]), settings, **options)


def alone(k: float, force: float = FORCE, time: float = 1.0) -> float:
    mbs, settings = oscillator()
    mbs.SetObjectParameter("spring", "stiffness", [k, 0, 0])
    mbs.SetLoadParameter("pull", "loadVector", [force, 0, 0])
    settings.timeIntegration.endTime = time
    mbs.SolveDynamic(settings)
    return float(mbs.GetSensorValues("way")[0])


def test_values_are_those_of_each_variation_by_itself() -> None:
    study, given = model(), {"k": [5.0, 20.0], "force": [1.0, 2.0], "time": [0.5, 1.0]}
    (columns, values) = processing.ParameterVariation(study, given, showProgress=False)
    assert len(values) == 8 and values == [
        alone(k, f, t) for k, f, t in zip(columns["k"], columns["force"], columns["time"], strict=True)
    ]
    assert study({"k": 20.0, "force": 2.0, "time": 1.0}) == values[-1]
    assert study.Values(columns).tolist() == values


def test_several_targets_get_one_value() -> None:
    mbs, settings = oscillator()
    study = VariedModel(mbs, {"both": [("spring", "stiffness", 0), ("spring", "stiffness", 1)]}, "way", settings)
    assert study({"both": 5.0})[0] == alone(5.0)


def test_all_studies_solve_it_at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """The static solution is FORCE / k: sensitivities are -FORCE / k^2; the search ends where it is 0.15."""
    study = model(solverType="static")
    sizes: list[int] = []
    solve = VariedModel.outcomes
    monkeypatch.setattr(VariedModel, "outcomes", lambda self, sets: sizes.append(len(sets)) or solve(self, sets))
    _, reference, _, sensitivity = processing.ComputeSensitivities(study, {"k": (10, 1e-4, 1)}, showProgress=False)
    assert reference == pytest.approx([FORCE / 10]) and sensitivity == pytest.approx(np.array([[-FORCE / 100]]))
    assert sizes == [3]
    to_goal = VariedModel(study.mbs, {"k": ("spring", "stiffness", 0)}, distance_to_goal, solverType="static")
    best, value, _, _ = processing.GeneticOptimization(
        to_goal, {"k": (5, 40)}, 60, 8, randomizerInitialization=1, showProgress=False
    )
    assert best["k"] == pytest.approx(20, rel=1e-2) and sizes[1:] == [60] * 8
    best, *_ = processing.Minimize(to_goal, {"k": (5, 40)}, tol=1e-8, showProgress=False)
    assert best["k"] == pytest.approx(20, rel=1e-4)
    sizes.clear()
    search = {"options": {"eps": 1e-4}, "tol": 1e-14, "showProgress": False}
    best, *_ = processing.Minimize(to_goal, {"k": (5, 40)}, method="L-BFGS-B", **search)
    assert best["k"] == pytest.approx(20, rel=1e-4) and sizes[0] == 2 and max(sizes) == 2
    sizes.clear()
    search = {"options": {"seed": 1, "maxiter": 10}, "showProgress": False}
    best, *_ = processing.Minimize(to_goal, {"k": (5, 40)}, method="differential_evolution", **search)
    assert best["k"] == pytest.approx(20, rel=1e-2) and len(sizes) == 11
    assert sizes[0] == 15 and min(sizes) > 5  # points at a bound come again
    found = differential_evolution(lambda x: to_goal.Values({"k": x[0]}), [(5, 40)], vectorized=True, seed=1)
    assert found.x[0] == pytest.approx(20, rel=1e-4)


def distance_to_goal(results: Any, variation: int) -> float:
    return float((results.SensorValues("way")[variation, 0] - 0.15) ** 2)


def test_failures_keep_their_messages() -> None:
    study = model(solverType="static")
    sets = [{"k": k} for k in (10.0, 0.0, 20.0)]
    values = processing.ProcessParameterList(study, sets, False, keepFailures=True)
    assert [values[0], values[2]] == pytest.approx([0.3, 0.15])
    assert isinstance(values[1], FailedEvaluation) and "singular" in values[1].message
    assert np.isnan(study.Values({"k": [10.0, 0.0]})).tolist() == [False, True]
    with pytest.raises(FailedVariation, match="singular"):
        study({"k": 0.0})
    with pytest.raises(ValueError, match="singular") as caught:
        processing.ProcessParameterList(study, sets, False)
    assert "evaluation 1 of 3 with parameters {'k': 0.0}" in caught.value.__notes__[0]


def test_searches_go_on_where_they_have_ended(tmp_path: Path) -> None:
    """Two of three generations are in the file, and half a line of the third."""
    study, file = model(solverType="static"), tmp_path / "search.txt"
    arguments: dict[str, Any] = {"populationSize": 5, "randomizerInitialization": 3, "showProgress": False}

    def search(function: Any, **more: Any) -> Any:
        return processing.GeneticOptimization(function, {"k": (5, 40)}, **arguments, resultsFile=str(file), **more)

    whole = search(study, numberOfGenerations=3)
    rows = file.read_text().splitlines(keepends=True)
    file.write_text("".join(rows[:-5]) + rows[-5][:7])
    called: list[float] = []
    again = search(lambda p: called.append(p["k"]) or study(p), numberOfGenerations=3, restart=True)
    assert len(called) == 5 and again[1] == whole[1] and again[3] == whole[3]
    assert file.read_text().splitlines()[-15:] == [row.rstrip("\n") for row in rows[-15:]]
    del arguments["randomizerInitialization"]
    with pytest.raises(ValueError, match="restart needs the randomizerInitialization"):
        search(study, restart=True)


@pytest.mark.parametrize(
    ("given", "text"),
    [
        (
            ("spring", "stiffness", 3),
            r"parameters\['a'\]: received entry 3 of 'stiffness', but expected an entry from 0 to 2",
        ),
        (("spring", "activeConnector", 0), "received entry 0 of 'activeConnector', but expected no entry"),
        (
            ("sprin", "stiffness"),
            r"parameters\['a'\]: received 'sprin', but no .* has this name. Did you mean 'spring'\?",
        ),
        (("spring", "stifness"), "there is no parameter 'stifness'. Did you mean 'stiffness'"),
        ((3, "stiffness"), "received 3 as item, but expected its name, or the index that it got"),
        (("spring",), r"received \('spring',\), but expected \(item, parameter\)"),
    ],
)
def test_wrong_parameters_are_refused(given: Any, text: str) -> None:
    with pytest.raises((ValueError, IndexError), match=text):
        VariedModel(oscillator()[0], {"a": given}, "way")


def test_unknown_names_are_refused() -> None:
    with pytest.raises(ValueError, match="received parameter 'mass', but expected one of k, force, time"):
        model()({"mass": 1.0})
    with pytest.raises(ValueError, match="result: received 'wy'.*Did you mean 'way'"):
        VariedModel(oscillator()[0], {"k": ("spring", "stiffness", 0)}, "wy")
