"""Messages for mistakes of new users: planar hinges, gaps, weight out of the plane, forces on ground, the name
ground."""

from __future__ import annotations

import time
import warnings
from typing import Any

import numpy as np
import pytest

import dalembert as exu
from dalembert.utilities import InertiaCuboid, RotationMatrixZ


def four_bar(spatial: bool) -> exu.MainSystem:
    """A planar four-bar linkage on hinges of CreateRevoluteJoint, or on spatial ones, which state three equations too
    many each."""
    mbs = exu.SystemContainer().AddSystem()
    ground, points = mbs.CreateGround(), np.array([[0, 0, 0], [0, 0.1, 0], [0.5, 0.2, 0], [0.4, 0, 0.0]])
    bodies = [ground]
    for a, b in zip(points[:-1], points[1:], strict=True):
        length, angle = np.linalg.norm(b - a), np.arctan2(*(b - a)[1::-1])
        bodies.append(
            mbs.CreateRigidBody(
                referencePosition=(a + b) / 2,
                referenceRotationMatrix=RotationMatrixZ(angle),
                inertia=InertiaCuboid(1000, [length, 0.02, 0.02]),
                gravity=[0, -9.81, 0],
                create2D=True,
            )
        )
    bodies.append(ground)
    for name, pair, point in zip("ABCD", zip(bodies[:-1], bodies[1:], strict=True), points, strict=True):
        if not spatial:
            mbs.CreateRevoluteJoint(name=name, bodyNumbers=list(pair), position=point, axis=[0, 0, 1])
            continue
        markers = []
        for body in pair:
            place, turn = (
                mbs.GetObjectOutputBody(body, variable, [0, 0, 0], exu.ConfigurationType.Reference)
                for variable in (exu.OutputVariableType.Position, exu.OutputVariableType.RotationMatrix)
            )
            local = np.reshape(turn, (3, 3)).T @ (point - place)
            markers.append(mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=body, localPosition=local)))
        mbs.AddObject(exu.ObjectJointRevoluteZ(name=name, markerNumbers=markers))
    mbs.Assemble()
    return mbs


def test_planar_hinges_are_not_redundant() -> None:
    counts = four_bar(spatial=False).ComputeSystemDegreeOfFreedom()
    assert (counts["degreeOfFreedom"], counts["redundantConstraints"]) == (1, 0)


def test_spatial_hinges_in_the_plane_are_counted_without_alarm() -> None:
    mbs = four_bar(spatial=True)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        counts, report = mbs.ComputeSystemDegreeOfFreedom(), mbs.Report()
    assert (counts["degreeOfFreedom"], counts["redundantConstraints"]) == (1, 12)
    assert list(counts["removableEquations"].values()) == [[3, 5]] * 4
    assert "object 4 'A': 3 of 5 equations are removable" in report


def arm(above: float) -> exu.MainSystem:
    """An arm on a ball joint that is open by so much."""
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.CreateGround()
    body = mbs.CreateRigidBody(
        referencePosition=[0.5, 0, 0], inertia=InertiaCuboid(1000, [1, 0.1, 0.1]), gravity=[0, -9.81, 0]
    )
    ends = ((ground, [0, 0, above]), (body, [-0.5, 0, 0]))
    markers = [mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=b, localPosition=p)) for b, p in ends]
    mbs.AddObject(exu.SphericalJoint(name="ball", markerNumbers=markers))
    mbs.Assemble()
    return mbs


def steps(end: float, number: int) -> exu.SimulationSettings:
    settings = exu.SimulationSettings()
    settings.solutionSettings.writeSolutionToFile = False
    settings.timeIntegration.endTime, settings.timeIntegration.numberOfSteps = end, number
    return settings


def test_errors_name_gaps_at_the_start() -> None:
    """If a motion diverges after a gap at its start, the error repeats the initial warning."""
    settings = steps(1e5, 1)  # a step that no Newton iteration survives
    settings.timeIntegration.adaptiveStep = False
    settings.timeIntegration.newton.maxIterations = 2
    with pytest.raises(
        exu.SolverError, match="open at the start, which is a likely cause(?s:.*)'ball'.*gap -0.1 m"
    ) as it:
        arm(0.1).SolveDynamic(settings)
    assert any("ComputeConsistentInitialConditions" in text for text in it.value.advice)
    with pytest.raises(exu.SolverError) as it:
        arm(0.0).SolveDynamic(settings)
    assert "open at the start" not in str(it.value)


def test_reports_of_index_3_solutions_name_no_faults() -> None:
    """Rates of gaps of generalized alpha, 1e-4 of velocities, are no open constraints; a gap of positions is one."""
    mbs = arm(0.0)
    mbs.SolveDynamic(steps(1, 1000))
    assert "constraints: closed" in mbs.Report()
    assert "constraint violations:" in arm(1e-3).Report()


@pytest.mark.parametrize("create", ["CreateRigidBody", "CreateMassPoint"])
def test_weight_across_the_plane_is_named(create: str) -> None:
    mbs = exu.SystemContainer().AddSystem()
    body: dict[str, Any] = (
        {"inertia": InertiaCuboid(1, [1, 1, 1])} if create == "CreateRigidBody" else {"physicsMass": 1}
    )
    getattr(mbs, create)(gravity=[0, -9.81, 0], create2D=True, **body)
    getattr(mbs, create)(gravity=[0, 0, -9.81], **body)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        mbs.Assemble()
    getattr(mbs, create)(gravity=[0, 0, -9.81], create2D=True, **body)
    with pytest.warns(UserWarning, match=r"load 2 .*its component along z has no effect, .* in the xy plane"):
        mbs.Assemble()


@pytest.mark.parametrize(
    ("create", "vector", "warned"),
    [
        ("CreateForce", [0, 0, 2], "its component along z has no effect"),
        ("CreateForce", [1, 2, 0], ""),
        ("CreateTorque", [1, 0, 2], "its components along x and y have no effect"),
        ("CreateTorque", [0, 0, 2], ""),
    ],
)
def test_loads_across_the_plane_are_named(create: str, vector: list[float], warned: str) -> None:
    mbs = exu.SystemContainer().AddSystem()
    body = mbs.CreateRigidBody(inertia=InertiaCuboid(1, [1, 1, 1]), create2D=True)
    getattr(mbs, create)(name="pull", bodyNumber=body, loadVector=vector)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        if not warned:
            mbs.Assemble()
            return
    with pytest.warns(UserWarning, match=f"load 0 'pull' .*: {warned}, because what it acts on moves in the xy plane"):
        mbs.Assemble()


def test_axes_out_of_the_plane_are_refused() -> None:
    """A planar body turns about z and slides in x and y; an axis that locks it is a mistake."""
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.CreateGround()
    inertia = InertiaCuboid(1, [1, 1, 1])
    planar = mbs.CreateRigidBody(inertia=inertia, create2D=True)
    spatial = mbs.CreateRigidBody(inertia=inertia)
    place: dict[str, Any] = {"bodyNumbers": [ground, planar], "position": [0, 0, 0]}
    with pytest.raises(ValueError, match=r"CreateRevoluteJoint.*'axis'.*turns about z only: \[0, 0, 1\]"):
        mbs.CreateRevoluteJoint(**place, axis=[1, 0, 0])
    with pytest.raises(ValueError, match=r"CreatePrismaticJoint.*'axis'.*moves in x and y only: \[x, y, 0\]"):
        mbs.CreatePrismaticJoint(**place, axis=[0, 1, 1])
    mbs.CreateRevoluteJoint(**place, axis=[0, 0, -2])
    mbs.CreatePrismaticJoint(**place, axis=[3, 4, 0])
    mbs.CreateRevoluteJoint(bodyNumbers=[planar, spatial], position=[0, 0, 0], axis=[1, 0, 0])


@pytest.mark.parametrize("create", ["CreateForce", "CreateTorque"])
def test_loads_on_ground_are_named(create: str) -> None:
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.CreateGround()
    with pytest.warns(UserWarning, match=rf"{create}\(...\): bodyNumber is ground: the load has no effect"):
        getattr(mbs, create)(bodyNumber=ground, loadVector=[1, 0, 0])


def test_the_only_ground_is_called_ground() -> None:
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.CreateGround()
    mbs.CreateMassPoint(name="stone", referencePosition=[1, 0, 0], physicsMass=1)
    spring = mbs.CreateSpringDamper(bodyNumbers=["ground", "stone"], stiffness=1)
    marker = mbs.GetObject(spring)["markerNumbers"][0]
    assert mbs.GetMarker(marker)["bodyNumber"] == ground
    mbs.CreateGround(name="other")
    with pytest.raises(ValueError, match="there is no object, marker or node named 'ground'|'ground'"):
        mbs.CreateSpringDamper(bodyNumbers=["ground", "stone"], stiffness=1)


def test_viewers_wait_for_pages_as_long_as_their_kind_needs(monkeypatch: pytest.MonkeyPatch, capfd: Any) -> None:
    """An address in a terminal has to be opened by a person: no limit. A line explains this after the waiting time of a
    browser."""
    from dalembert._live import opening, viewer

    shown: list[str] = []
    monkeypatch.setattr(opening, "bring", lambda server, where: shown.append(where))
    monkeypatch.setitem(opening.PATIENCE, "browser", 0.2)
    for where, waits in (("address", True), ("browser", False)):
        container = exu.SystemContainer()
        container.AddSystem()
        opening.open_page(container, where)
        found = viewer.viewer_of(container)
        assert found is not None
        try:
            time.sleep(0.3)
            assert found.watched is waits
            if not waits:
                assert found.idle(-1, announce=True) is False
                assert "no page is open; the computation goes on" in capfd.readouterr().out
        finally:
            found.stop()
    assert shown == ["address", "browser"]


def test_restitution_that_is_ignored_is_named() -> None:
    mbs = exu.SystemContainer().AddSystem()
    pair = [mbs.CreateMassPoint(referencePosition=[x, 0, 0], physicsMass=1) for x in (0, 1)]
    law: dict[str, Any] = {"bodyNumbers": pair, "spheresRadii": [0.1, 0.1], "contactStiffness": 1e5}
    with pytest.warns(UserWarning, match="restitutionCoefficient: received 0.5, which impactModel=0 ignores"):
        mbs.CreateSphereSphereContact(restitutionCoefficient=0.5, **law)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        mbs.CreateSphereSphereContact(restitutionCoefficient=0.5, impactModel=2, **law)
        mbs.CreateSphereSphereContact(**law)
