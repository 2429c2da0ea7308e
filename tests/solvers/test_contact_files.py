"""General contact in model files, and solutions with friction that go on from a restart file: nothing is lost, to the last bit."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from test_general_contact import EXPLICIT, IMPLICIT, World, cloud, grid_mesh

import dalembert as exu
from dalembert import itemInterface as eii
from dalembert._io import model_files

SCALES = [i / 7 for i in range(1, 9)]  # no short binary numbers


def filled() -> World:
    """Everything that a contact may have, with settings that are not the defaults."""
    world = World(friction=[[0.1, 1 / 3], [1 / 3, 0.7]], zone=0.013)
    for i, scale in enumerate(SCALES):
        world.ball([i, 0.1 * scale, 2], [0, 0, -scale], surface={"stiffness": 1e4 * scale, "damping": scale})
        world.sphere(world.ground, scale, material=i % 2)
    world.mesh(*grid_mesh(1.0, 3), material=1, damping=1 / 9)
    world.mesh([[0, 0, 1 / 3], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
    cable = exu.utilities.Cable2D(physicsMassPerLength=1, physicsBendingStiffness=1, physicsAxialStiffness=1e4)
    made = exu.utilities.GenerateStraightLineANCFCable2D(world.mbs, [0, 0, 0], [2, 0, 0], 3, cable)
    for element in made[1]:
        world.contact.AddANCFCable(element, 0.01, 1e4, 0.3, 0)
    surface = {"contactStiffness": 1e4 / 3, "contactDamping": 1 / 7, "frictionMaterialIndex": 1}
    world.contact.AddBoxWithMarker(world.ground, [1 / 3, 1 / 7, 2], centerPoint=[0.1, 0.2, 0.3], **surface)
    world.contact.AddCapsuleWithMarker(world.ground, 1 / 9, [1 / 3, 0, 1], **surface)
    world.contact.AddConvexHullWithMarker(world.ground, np.random.default_rng(3).normal(0, 1, (20, 3)), **surface)
    world.contact.AddCylinderWithMarker(world.ground, 1 / 9, [1 / 3, 0, 1], pAxis=[1 / 7, 0, 0], **surface)
    world.contact.AddPlane(world.ground, [1, 2, 3], point=[0, 0, 1 / 3], **surface)
    world.contact.AddHeightField(world.ground, np.arange(6).reshape(2, 3) / 7, [0.1, 0.3], **surface)
    world.contact.SetFrictionBristles(2 / 7, 1 / 3, 4 / 3)
    world.contact.minRelDistanceSpheresTriangles = 1e-7
    world.contact.sphereSphereContact = False
    world.contact.isActive = False
    world.contact.verboseMode = 3
    world.contact.computeContactForces = True
    world.contact.SetSearchTreeCellSize([3, 4, 5])
    world.contact.SetSearchTreeBox([-1, -2, -1 / 3], [1, 2, 3])
    return world


def contacts(mbs: Any) -> Any:
    """All numbers of the contacts of a system, with their types."""

    def plain(value: Any) -> Any:
        if isinstance(value, dict):
            return {key: plain(entry) for key, entry in value.items()}
        return (
            (value.dtype.str, value.shape, value.tobytes()) if isinstance(value, np.ndarray) else (type(value), value)
        )

    return [plain(dict(entry)) for entry in mbs.GetDictionary().get("generalContactList", [])]


def empty() -> Any:
    return exu.SystemContainer().AddSystem()


def test_round_trip(tmp_path: Path) -> None:
    jsonschema = pytest.importorskip("jsonschema")
    world, other = filled(), empty()
    world.mbs.AddGeneralContact()  # nothing in it
    world.mbs.Save(tmp_path / "model.json")
    content = json.loads((tmp_path / "model.json").read_text())
    assert content["generalContacts"][1] == {}
    assert content["generalContacts"][0]["spheres"]["radius"][1] == SCALES[0]
    jsonschema.Draft202012Validator(json.loads(model_files.SCHEMA.read_text())).validate(content)
    other.Load(tmp_path / "model.json")
    assert contacts(other) == contacts(world.mbs)
    assert len(contacts(other)) == 2
    kept = other.GetGeneralContact(0)
    assert (kept.verboseMode, kept.computeContactForces, kept.isActive, kept.sphereSphereContact) == (
        3,
        True,
        False,
        False,
    )
    other.Save(tmp_path / "again.json")
    assert (tmp_path / "again.json").read_text() == (tmp_path / "model.json").read_text()


def test_settings_of_the_schema_are_those_of_the_class() -> None:
    properties = json.loads(model_files.SCHEMA.read_text())["$defs"]["generalContact"]["properties"]
    attributes = {name for name, value in vars(exu.GeneralContact).items() if isinstance(value, property)}
    groups = {"spheres", "cables", "triangleBodies", "triangles"}
    groups |= {"convexShapes", "convexPoints", "convexTriangles", "planes"}
    others = {"frictionPairings", "frictionBristles", "searchTreeSize", "searchTreeBox"}  # set by methods
    assert set(properties) - groups - others == attributes - {"visualization"}


def test_large_contacts_are_separate(tmp_path: Path) -> None:
    world, other = World(), empty()
    for i in range(1100):
        world.sphere(world.ground, 1 + i / 7)
    world.mbs.Save(tmp_path / "model.json")
    assert json.loads((tmp_path / "model.json").read_text())["generalContacts"][0]["spheres"]["radius"] == {
        "npz": "generalContacts.0.spheres.radius"
    }
    other.Load(tmp_path / "model.json")
    assert contacts(other) == contacts(world.mbs)


@pytest.mark.parametrize("solver", [EXPLICIT, IMPLICIT])
def test_solutions_of_loaded_models_are_the_same(solver: Any, tmp_path: Path) -> None:
    world, _ = cloud(0.3)
    world.mbs.Save(tmp_path / "model.json")
    other = World()
    other.mbs = empty()
    other.mbs.Load(tmp_path / "model.json")
    before = world.mbs.systemData
    results = []
    for each in (world, other):
        each.solve(0.05, 100, solver)
        data = each.mbs.systemData
        results.append(data.GetODE2Coordinates().tobytes() + data.GetODE2Coordinates_t().tobytes())
    assert np.abs(before.GetODE2Coordinates_t()).max() > 0.1
    assert results[0] == results[1]


WRONG: list[tuple[str, str, Any, str]] = [
    ("spheres", "radius", [0.1, 0.0], r"generalContacts\[0\]: .*spheres\[1\], parameter 'radius': received 0.0"),
    ("spheres", "contactStiffness", [1, -1], r"spheres\[1\], parameter 'contactStiffness': received -1.0"),
    ("spheres", "contactDamping", [1, -1], r"spheres\[1\], parameter 'contactDamping': received -1.0"),
    ("spheres", "frictionMaterialIndex", [0, 0.5], r"spheres\[1\], parameter 'frictionMaterialIndex': received 0.5"),
    ("spheres", "frictionMaterialIndex", [0, -2], r"spheres\[1\].*'frictionMaterialIndex': received -2"),
    ("spheres", "markerIndex", [0, 9], r"generalContacts\[0\].spheres.markerIndex: received 9, but the file has 1 markers"),
    ("spheres", "markerIndex", ["foot", 0], r"spheres.markerIndex: there is no marker named 'foot'"),
    ("spheres", "radius", [0.1], r"'spheres.radius': received a list of length 1, but expected length 2"),
    ("spheres", "radius", "wide", r"'spheres.radius': received .*, but expected a list of numbers"),
    ("spheres", "radius", None, r"'spheres.radius': received .*, but expected a list of numbers"),
    ("spheres", "mass", [1, 1], r"'spheres.mass': received an unknown key"),
    ("triangles", "points", [[[0, 0, 0], [1, 0, 0], [2, 0, 0]]], r"triangles\[0\], parameter 'points'.*an area"),
    ("triangles", "contactRigidBodyIndex", [1], r"triangles\[0\].*received 1, but expected the number of one of the 1"),
    ("", "frictionPairings", [[0.1, 0.2]], r"'frictionPairings': .*a square matrix"),
    ("", "frictionProportionalZone", 0.0, r"'frictionProportionalZone': received 0.0"),
    ("", "isActive", "yes", r"'isActive': received 'yes'.*True or False"),
    ("", "frictionZone", 1.0, r"'frictionZone': received an unknown key"),
    ("", "spheres", [1], r"'spheres': received \[1\].*a dictionary"),
]  # fmt: skip


@pytest.mark.parametrize(("group", "key", "value", "text"), WRONG, ids=lambda x: str(x)[:30])
def test_wrong_contacts_are_refused_with_the_place(group: str, key: str, value: Any, text: str, tmp_path: Path) -> None:
    world = World()
    world.sphere(world.ground, 0.1)
    world.sphere(world.ground, 0.2)
    world.mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
    file = tmp_path / "model.json"
    world.mbs.Save(file)
    content = json.loads(file.read_text())
    (content["generalContacts"][0][group] if group else content["generalContacts"][0])[key] = value
    file.write_text(json.dumps(content))
    mbs = filled().mbs
    before = contacts(mbs)
    with pytest.raises(exu.ModelFileError, match=f"model.json: .*{text}"):
        mbs.Load(file)
    assert contacts(mbs) == before


def test_markers_may_be_named(tmp_path: Path) -> None:
    world = World()
    world.mbs.AddMarker(eii.MarkerBodyRigid(name="foot", bodyNumber=0))
    world.sphere(world.ground, 0.1)
    file = tmp_path / "model.json"
    world.mbs.Save(file)
    content = json.loads(file.read_text())
    content["generalContacts"][0]["spheres"]["markerIndex"] = ["foot"]
    file.write_text(json.dumps(content))
    mbs = empty()
    mbs.Load(file)
    mbs.Assemble()
    assert int(mbs.GetGeneralContact(0).GetSphereMarkerBased(0, addData=True)["markerIndex"]) == 1


# ---- once more ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("linear", [exu.LinearSolverType.EXUdense, exu.LinearSolverType.EigenSparse])
def test_a_ball_that_rests_begins_without_acceleration(linear: Any) -> None:
    """Accelerations at the start know of the contact, also where the system has been solved, and lists are those of another place."""
    world = World()
    body = world.ball([0, 0, 0.1 - 9.81 / 1e4], gravity=[0, 0, -9.81])
    world.mesh(*grid_mesh(2.0, 2))
    world.mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.solutionSettings.writeSolutionToFile = False
    settings.linearSolverType = linear
    settings.timeIntegration.endTime, settings.timeIntegration.numberOfSteps = 0.01, 10
    for shift in (0.0, 0.7, 0.0):
        world.mbs.systemData.SetODE2Coordinates([shift, 0, 0, 0, 0, 0], exu.ConfigurationType.Initial)
        world.mbs.SolveDynamic(settings)
        np.testing.assert_allclose(world.output(body, "Velocity"), 0, atol=1e-12)


@pytest.mark.parametrize("solver", [EXPLICIT, IMPLICIT])
def test_solutions_do_not_depend_on_earlier_ones(solver: Any) -> None:
    """The sparse pattern, too, is that of a system that was assembled just now."""
    mbs = sliding_cloud()
    settings = exu.SimulationSettings()
    settings.solutionSettings.writeSolutionToFile = False
    settings.linearSolverType = exu.LinearSolverType.EigenSparse
    settings.timeIntegration.endTime, settings.timeIntegration.numberOfSteps = 0.1, 100
    results = []
    for _ in range(2):
        mbs.SolveDynamic(settings, solverType=solver)
        results.append(mbs.systemData.GetODE2Coordinates().tobytes() + mbs.systemData.GetODE2Coordinates_t().tobytes())
    assert results[0] == results[1]


def sliding_cloud(grips: bool = False) -> Any:
    """Balls that rub on each other and on triangles; neighbours in the second half differ from those in the first."""
    world, bodies = cloud(0.3, gravity=[0, 0, -9.81])
    if grips:
        world.contact.SetFrictionBristles(0.8, 1.0, 1.2)
    world.mesh(*grid_mesh(2.0, 5), stiffness=5e3, damping=20.0)
    world.mbs.AddSensor(
        eii.SensorBody(bodyNumber=bodies[0], fileName="sensor.txt", outputVariableType=exu.OutputVariableType.Position)
    )
    world.mbs.Assemble()
    return world.mbs


SPARSE, DENSE = exu.LinearSolverType.EigenSparse, exu.LinearSolverType.EXUdense


@pytest.mark.parametrize("grips", [False, True])
@pytest.mark.parametrize(
    ("solver", "linear"),
    [(EXPLICIT, SPARSE), (exu.DynamicSolverType.VelocityVerlet, SPARSE), (IMPLICIT, SPARSE), (IMPLICIT, DENSE)],
)
def test_restart_continues_bit_for_bit(
    solver: Any, linear: Any, grips: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    settings = exu.SimulationSettings()
    settings.linearSolverType = linear
    time, solution = settings.timeIntegration, settings.solutionSettings
    time.endTime, time.numberOfSteps = 0.2, 200
    solution.coordinatesSolutionFileName, solution.solutionWritePeriod = "solution.txt", 0.01
    solution.outputPrecision, solution.writeFileFooter = 16, False
    solution.writeRestartFile, solution.restartFileName, solution.restartWritePeriod = True, "restart.txt", 0.12

    def files() -> dict[str, list[bytes]]:
        lines = {path.name: path.read_bytes().split(b"\n") for path in Path().glob("*.txt")}
        return {
            name: [line for line in each if not line.startswith(b"#simulation started")] for name, each in lines.items()
        }

    mbs = sliding_cloud(grips)
    mbs.SolveDynamic(settings, solverType=solver)
    whole = files()
    contact = mbs.GetGeneralContact(0)
    contact.UpdateContacts(mbs)
    assert contact.GetActiveContacts(exu.ContactTypeIndex.IndexSpheresMarkerBased, -1).sum() > 10
    os.replace("restart.txt.bck", "middle.txt")
    Path("restart.txt").unlink()
    settings.continuation.restartFileName = "middle.txt"
    sliding_cloud(grips).SolveDynamic(settings, solverType=solver)
    Path("middle.txt").unlink()
    assert files() == whole
