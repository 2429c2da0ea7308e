"""Motions as files of other programs, read back by readers that know nothing of this package."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import meshio
import numpy as np
import pygltflib
import pytest
from scipy.spatial.transform import Rotation

import dalembert as exu
import dalembert.itemInterface as items
import dalembert.utilities
from dalembert import graphics
from dalembert._pictures.motion import Motion

SIZES = {5126: ("<f4", 4), 5125: ("<u4", 4), 5121: ("u1", 1)}
WIDTHS = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}


def array(file: Any, number: int) -> Any:
    """The numbers of an accessor."""
    accessor = file.accessors[number]
    view, (kind, size) = file.bufferViews[accessor.bufferView], SIZES[accessor.componentType]
    width = WIDTHS[accessor.type]
    assert view.byteOffset % 4 == 0 and view.byteLength == accessor.count * width * size
    data = file.binary_blob()[view.byteOffset : view.byteOffset + view.byteLength]
    values = np.frombuffer(data, kind).reshape(-1, width)
    if accessor.min:
        assert values.min(axis=0) == pytest.approx(accessor.min) and values.max(axis=0) == pytest.approx(accessor.max)
    return values


@pytest.fixture
def spinning(SC: Any, mbs: Any) -> Any:
    """A brick that flies and turns, a spring to ground and a cable that bends."""
    SC.visualizationSettings.loads.show = False
    ground = mbs.CreateGround()
    brick = mbs.CreateRigidBody(
        referencePosition=[1, 0, 0],
        inertia=exu.utilities.InertiaCuboid(1000, [0.4, 0.2, 0.1]),
        initialVelocity=[1, 0.5, 0],
        initialAngularVelocity=[0.3, 4, 1],
        graphicsDataList=[graphics.Brick(size=[0.4, 0.2, 0.1], color=[0.5, 0.25, 1, 1])],
    )
    mbs.SetObjectParameter(brick, "name", "brick <&>")
    mbs.CreateSpringDamper(bodyNumbers=[ground, brick], stiffness=20)
    nodes = [mbs.AddNode(items.NodePoint2DSlope1(referenceCoordinates=[x, -1, 1, 0])) for x in (0, 1)]
    mbs.AddObject(
        items.ObjectANCFCable2D(
            nodeNumbers=nodes,
            physicsLength=1,
            physicsMassPerLength=1,
            physicsBendingStiffness=1,
            physicsAxialStiffness=100,
            visualization={"drawHeight": 0.05},
        )
    )
    for coordinate in (0, 1, 3):
        marker = mbs.AddMarker(items.MarkerNodeCoordinate(nodeNumber=nodes[0], coordinate=coordinate))
        rest = mbs.AddMarker(items.MarkerNodeCoordinate(nodeNumber=mbs.AddNode(items.NodePointGround()), coordinate=0))
        mbs.AddObject(items.ObjectConnectorCoordinate(markerNumbers=[rest, marker]))
    tip = mbs.AddMarker(items.MarkerNodePosition(nodeNumber=nodes[1]))
    mbs.AddLoad(items.LoadForceVector(markerNumber=tip, loadVector=[0, -1, 0]))
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps, settings.timeIntegration.endTime = 100, 1
    settings.solutionSettings.solutionWritePeriod = 0.01
    settings.timeIntegration.verboseMode = 0
    mbs.SolveDynamic(settings)
    return mbs


def test_glb_has_the_motion(spinning: Any) -> None:
    spinning.SaveGLB("motion.glb", framesPerSecond=10)
    file = pygltflib.GLTF2().load("motion.glb")
    assert file.asset.version == "2.0"
    motion = Motion(spinning, "test", None, 10, 1.0, None, (64, 48))
    assert array(file, file.animations[0].samplers[0].input).ravel() == pytest.approx(np.arange(11) / 10)
    [number] = [n for n, node in enumerate(file.nodes) if node.name == "brick <&>.1"]
    assert file.nodes[number].extras == {"kind": "Object", "number": 1, "type": "RigidBody"}
    found = {}
    for channel in file.animations[0].channels:
        if channel.target.node == number:
            found[channel.target.path] = array(file, file.animations[0].samplers[channel.sampler].output)
    assert set(found) == {"translation", "rotation"}
    for frame, scene in enumerate(scene.unbound() for scene in motion.scenes):
        [part] = [i for i in scene.instances if scene.items[i.item].name == "brick <&>"]
        assert found["translation"][frame] == pytest.approx(part.place, abs=1e-6)
        assert Rotation.from_quat(found["rotation"][frame]).as_matrix() == pytest.approx(part.matrix, abs=1e-6)
    shape = file.meshes[file.nodes[number].mesh].primitives[0]
    corners = array(file, shape.attributes.POSITION)
    assert np.abs(corners).max(axis=0) == pytest.approx([0.2, 0.1, 0.05])
    a, b, c = (corners[array(file, shape.indices).ravel()[k::3]] for k in range(3))
    areas = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1)
    assert areas.sum() == pytest.approx(2 * (0.4 * 0.2 + 0.2 * 0.1 + 0.4 * 0.1))
    color = file.materials[shape.material].pbrMetallicRoughness.baseColorFactor
    assert color == pytest.approx([0.214041, 0.050876, 1, 1], abs=1e-5)  # 0.5, 0.25 and 1 by the formula of sRGB


def test_glb_has_deformed_items(spinning: Any) -> None:
    spinning.SaveGLB("motion.glb", framesPerSecond=10)
    file = pygltflib.GLTF2().load("motion.glb")
    motion = Motion(spinning, "test", None, 10, 1.0, None, (64, 48))
    [number] = [n for n, node in enumerate(file.nodes) if (node.extras or {}).get("type") == "ANCFCable2D"]
    mesh = file.meshes[file.nodes[number].mesh]
    [sampler] = [c.sampler for c in file.animations[0].channels if c.target.node == number]
    weights = array(file, file.animations[0].samplers[sampler].output).reshape(11, -1)
    rest = array(file, mesh.primitives[0].attributes.POSITION)
    targets = [array(file, target["POSITION"]) for target in mesh.primitives[0].targets]
    for frame, scene in enumerate(scene.unbound() for scene in motion.scenes):
        [part] = [i for i in scene.instances if scene.items[i.item].type_name == "ANCFCable2D"]
        points = rest + sum(w * t for w, t in zip(weights[frame], targets, strict=True))
        drawn = part.mesh.points[part.mesh.triangles].reshape(-1, 3)
        assert points == pytest.approx(drawn, abs=1e-6)


def test_glb_of_a_system_at_rest(mbs: Any) -> None:
    mbs.CreateGround(graphicsDataList=[graphics.Sphere(radius=0.5)])
    mbs.SaveGLB("still.glb")
    file = pygltflib.GLTF2().load("still.glb")
    assert not file.animations and len(file.nodes) == 2
    assert file.nodes[0].rotation == pytest.approx([-np.sqrt(0.5), 0, 0, np.sqrt(0.5)])  # z becomes y


MISSING = "no validator of glTF: name one by DALEMBERT_GLTF_VALIDATOR (docs/developer/dependencies.rst)"


def complaints(*files: str) -> list[Any]:
    """Messages of Khronos' validator on files: errors and warnings of each; the test is skipped without the
    validator."""
    program = os.environ.get("DALEMBERT_GLTF_VALIDATOR")
    if program is None:
        pytest.skip(MISSING)
    if shutil.which(program) is None:
        pytest.fail(f"DALEMBERT_GLTF_VALIDATOR: {program} is no program; {MISSING}", pytrace=False)
    told = subprocess.run([program, *files], capture_output=True, text=True, check=True, timeout=60).stdout.splitlines()
    reports = [json.loads(line) for line in told]
    assert len(reports) == len(files)
    return [[message for message in report["messages"] if message["severity"] < 2] for report in reports]


def test_glb_follows_its_standard(SC: Any, spinning: Any) -> None:
    """Moving bodies, a spring with large elongation, deformed and transparent items; colors of a contour, and a system
    at rest."""
    spinning.SaveGLB("motion.glb", framesPerSecond=10)
    SC.visualizationSettings.contour.outputVariable = exu.OutputVariableType.Displacement
    SC.visualizationSettings.view0.scene.facesTransparent = True
    spinning.SaveGLB("colors.glb", framesPerSecond=10)
    still = exu.SystemContainer().AddSystem()
    still.CreateGround(graphicsDataList=[graphics.Sphere(radius=0.5)])
    still.SaveGLB("still.glb")
    whole = Path("still.glb").read_bytes()
    Path("wrong.glb").write_bytes(whole.replace(b'"VEC3"', b'"VEC4"', 1))
    *right, wrong = complaints("motion.glb", "colors.glb", "still.glb", "wrong.glb")
    assert right == [[], [], []]
    assert wrong


def test_vtu_has_the_motion(SC: Any, spinning: Any) -> None:
    contour = SC.visualizationSettings.contour
    contour.outputVariable, contour.outputVariableComponent = exu.OutputVariableType.Displacement, -1
    spinning.SaveVTU("out/motion.pvd", framesPerSecond=10)
    entries = ElementTree.parse("out/motion.pvd").getroot().findall("Collection/DataSet")
    motion = Motion(spinning, "test", None, 10, 1.0, None, (64, 48))
    assert [float(e.attrib["timestep"]) for e in entries] == pytest.approx([s.time for s in motion.scenes])
    for entry, scene in zip(entries, motion.scenes, strict=True):
        grid = meshio.read(Path("out", entry.attrib["file"]))
        [part] = [i for i in scene.instances if scene.items[i.item].type_name == "ANCFCable2D"]
        number = scene.items[part.item].number
        points, values = [], []
        for block, kinds, owners in zip(grid.cells, grid.cell_data["kind"], grid.cell_data["item"], strict=True):
            chosen = (np.ravel(kinds) == 1) & (np.ravel(owners) == number)
            points.append(grid.points[block.data[chosen]].reshape(-1, 3))
            values.append(grid.point_data["Displacement, norm (m)"][block.data[chosen]].ravel())
        assert part.values is not None
        drawn = part.mesh.triangles
        assert np.concatenate(points) == pytest.approx(part.mesh.points[drawn].reshape(-1, 3), abs=1e-14)
        assert np.concatenate(values) == pytest.approx(part.values[drawn].ravel(), abs=1e-14)


def test_vtu_of_one_state(spinning: Any) -> None:
    spinning.SaveVTU("now.vtu")
    grid = meshio.read("now.vtu")
    scene = Motion(spinning, "test", None, 10, 1.0, None, (64, 48)).scenes[-1]
    assert sum(len(block.data) for block in grid.cells if block.type == "triangle") >= sum(
        len(i.mesh.triangles) for i in scene.instances
    )


def test_other_names_are_refused(mbs: Any) -> None:
    with pytest.raises(ValueError, match="expected a name that ends with .pvd or .vtu, received 'motion.vtk'"):
        mbs.SaveVTU("motion.vtk")


def test_a_spring_that_stretches_is_one_mesh(SC: Any, mbs: Any) -> None:
    """It is scaled along its axis, by 0.7 to 1.5 here; a mesh for each frame would take a hundred times as much."""
    ground = mbs.CreateGround()
    mass = mbs.CreateMassPoint(referencePosition=[1, 0, 0], initialVelocity=[0.4, 0, 0], physicsMass=1)
    mbs.CreateSpringDamper(bodyNumbers=[ground, mass], stiffness=1)
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.endTime, settings.timeIntegration.numberOfSteps = 4, 100
    mbs.SolveDynamic(settings)
    motion = Motion(mbs, "test", None, 25, 1.0, None, (80, 60))
    scenes = [scene.unbound() for scene in motion.scenes]
    parts = [part for s in scenes for part in s.instances if "Spring" in s.items[part.item].type_name]
    lengths = [np.linalg.norm(part.matrix[:, 2]) for part in parts]
    assert len(parts) == len(motion.scenes) and max(lengths) > 2**0.5 * min(lengths)
    assert len({id(part.mesh) for part in parts}) == 1
    mbs.SaveGLB("spring.glb")
    assert Path("spring.glb").stat().st_size < 200_000


def test_a_spring_that_becomes_four_times_as_long_has_some_meshes(mbs: Any) -> None:
    """Frames in sequence: each is there for its frames, and of no size in the others."""
    ground = mbs.CreateGround()
    mass = mbs.CreateMassPoint(referencePosition=[1, 0, 0], initialVelocity=[3, 0.5, 0.2], physicsMass=1)
    spring = mbs.CreateSpringDamper(bodyNumbers=[ground, mass], stiffness=0.01)
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = 100
    settings.solutionSettings.solutionWritePeriod = 0.01
    mbs.SolveDynamic(settings)
    mbs.SaveGLB("spring.glb", framesPerSecond=100)
    file = pygltflib.GLTF2().load("spring.glb")
    nodes = [
        k
        for k, node in enumerate(file.nodes)
        if node.extras.get("number") == spring and node.extras["kind"] == "Object"
    ]
    assert 2 <= len(nodes) <= 4 and not any(mesh.primitives[0].targets for mesh in file.meshes)
    lengths = np.zeros(101)
    for channel in file.animations[0].channels:
        if channel.target.node in nodes and channel.target.path == "scale":
            lengths += array(file, file.animations[0].samplers[channel.sampler].output)[:, 2]
    places = np.array([1, 0, 0]) + np.linspace(0, 1, 101)[:, None] * [3, 0.5, 0.2]
    np.testing.assert_allclose(lengths, np.linalg.norm(places, axis=1), rtol=0.02)  # it pulls a little
    assert Path("spring.glb").stat().st_size < 600_000


def image_of_settings(mbs: Any, name: str) -> None:
    SC = mbs.GetSystemContainer()
    SC.visualizationSettings.exportImages.saveImageFileName = name
    SC.renderer.RedrawAndSaveImage()


@pytest.mark.parametrize(
    ("write", "ending"),
    [
        (lambda mbs, name: mbs.Draw(name), ".png"),
        (lambda mbs, name: mbs.DrawSolution(name), ".gif"),
        (lambda mbs, name: mbs.DrawSolution(name), "%05d.png"),
        (lambda mbs, name: mbs.SaveHTML(name), ".html"),
        (lambda mbs, name: mbs.SaveGLB(name), ".glb"),
        (lambda mbs, name: mbs.SaveVTU(name), ".pvd"),
        (image_of_settings, ""),
    ],
    ids=["picture", "film", "images", "html", "glb", "vtu", "image of settings"],
)
def test_names_with_a_null_character_are_refused(spinning: Any, write: Any, ending: str) -> None:
    before = set(Path().iterdir())
    with pytest.raises(ValueError, match=r"ileName: .*a\\x00b"):
        write(spinning, f"a\0b{ending}")
    assert set(Path().iterdir()) == before
