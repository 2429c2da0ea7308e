"""Packages with items of their own: the two examples are built and solved, and every mistake has its error.

The packages are built with the headers of the repository or of the installed wheel, as `dalembert items build` does.
Models run in processes of their own, because item types of a process stay.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from dalembert._core import _item_stamp
from dalembert._tools import item_builds

ROOT = Path(__file__).parents[2]
EXAMPLES = ROOT / "examples" / "item_packages"
SPEC, KERNEL = "specs/connectors/plastic_spring.toml", "kernels/connectors/plastic_spring.hpp"


def cli(*arguments: object, cwd: Path, **environment: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "dalembert", "items", *map(str, arguments)]
    given = os.environ | environment
    return subprocess.run(command, capture_output=True, text=True, cwd=cwd, env=given, check=False)


def python(code: str, cwd: Path, *packages: Path) -> subprocess.CompletedProcess[str]:
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(map(str, packages)), "MPLBACKEND": "Agg"}
    return subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, cwd=cwd, env=environment, check=False
    )


def copied(name: str, folder: Path) -> Path:
    ignored = shutil.ignore_patterns("build", "_items.*", "__pycache__")
    return Path(shutil.copytree(EXAMPLES / name, folder / name, ignore=ignored))


@pytest.fixture(scope="module")
def plastic_spring(tmp_path_factory: pytest.TempPathFactory) -> Path:
    package = copied("plastic_spring", tmp_path_factory.mktemp("packages"))
    item_builds.build(package)
    return package


@pytest.fixture
def package(plastic_spring: Path, tmp_path: Path) -> Path:
    """A copy with objects: a build compiles only changed files."""
    return Path(shutil.copytree(plastic_spring, tmp_path / "plastic_spring"))


# ---- what works --------------------------------------------------------------------------------------------------------
def test_plastic_spring(plastic_spring: Path, tmp_path: Path) -> None:
    """The yield force takes up the kinetic energy; 6000 steps follow the kinks of the force to 1e-5 m."""
    done = python((plastic_spring / "slider.py").read_text(), tmp_path, plastic_spring)
    assert done.returncode == 0, done.stderr
    plastic, expected = map(float, re.findall(r"(\d+\.\d+) m", done.stdout))
    assert expected == pytest.approx(0.44, abs=1e-12)
    assert plastic == pytest.approx(expected, abs=1e-5)
    assert (tmp_path / "plastic_spring.png").stat().st_size > 1000


def test_bar_element(tmp_path: Path) -> None:
    """Two-node elements with consistent mass are too stiff by (pi/2)^2 / (24 n^2): 4.0e-4 of the frequency for n = 16."""
    package = copied("bar_element", tmp_path)
    item_builds.build(package)
    done = python((package / "axial_vibration.py").read_text(), tmp_path, package)
    assert done.returncode == 0, done.stderr
    found, exact = map(float, re.findall(r"(\d+\.\d+) Hz", done.stdout))
    assert found / exact - 1 == pytest.approx((3.141592653589793 / 2) ** 2 / (24 * 16**2), rel=0.02)


MODEL = """
import pickle, sys
import dalembert as exu
from dalembert.itemInterface import *
from plastic_spring import PlasticSpring, VPlasticSpring
mbs = exu.SystemContainer().AddSystem()
bodies = [mbs.CreateGround(referencePosition=[x, 0, 0]) for x in (0, 2)]
markers = [mbs.AddMarker(MarkerBodyPosition(bodyNumber=body)) for body in bodies]
data = mbs.AddNode(NodeGenericData(initialCoordinates=[0], numberOfDataCoordinates=1))
spring = mbs.AddObject(PlasticSpring(markerNumbers=markers, nodeNumber=data, referenceLength=1, stiffness=10, yieldForce=3))
mbs.Assemble()
"""
FORCE = "mbs.GetObjectOutput(spring, exu.OutputVariableType.Force).tolist()"


def test_own_items_are_like_others(plastic_spring: Path, tmp_path: Path) -> None:
    """Dictionary, copy, pickle, file, schema, help, drawing and checks of an own item."""
    code = (
        MODEL
        + f"""
item = PlasticSpring(markerNumbers=markers, nodeNumber=data, stiffness=4)
assert pickle.loads(pickle.dumps(item)) == item and type(item).__module__ == "plastic_spring"
assert dict(item)["objectType"] == "ConnectorPlasticSpring"
for other in (pickle.loads(pickle.dumps(mbs)), mbs.__copy__()):
    assert other.GetObject(spring)["yieldForce"] == 3
assert mbs.GetDictionary()["itemPackages"] == ["plastic_spring"]
mbs.Save("model.json")
other = exu.SystemContainer().AddSystem()
other.Load("model.json")
other.Assemble()
assert other.GetObjectOutput(spring, exu.OutputVariableType.Force).tolist() == {FORCE} == [3, 0, 0]
from dalembert._io.model_files import Schema
schema = Schema()
assert "yieldForce" in schema["$defs"]["ObjectConnectorPlasticSpring"]["properties"]
assert "ObjectConnectorPlasticSpring" in schema["properties"]["objects"]["items"]["properties"]["type"]["enum"]
import json
import jsonschema
jsonschema.Draft202012Validator(schema).validate(json.load(open("model.json")))
assert "largest force, in tension and compression" in PlasticSpring.__doc__
bare = np.asarray(mbs.Draw(windowSize=[200, 150]))
mbs.SetObjectParameter(spring, "Vshow", False)
assert (bare != np.asarray(mbs.Draw(windowSize=[200, 150]))).any()
for wrong in (dict(stiffness=-1), dict(yieldForse=1)):
    try:
        PlasticSpring(**wrong)
    except Exception as error:
        print(error)
"""
    )
    done = python(code, tmp_path, plastic_spring)
    assert done.returncode == 0, done.stderr
    assert "parameter 'stiffness': received -1" in done.stdout and "(unit N/m)" in done.stdout
    assert "there is no parameter 'yieldForse'. Did you mean 'yieldForce'?" in done.stdout


def test_installed_packages_are_found(plastic_spring: Path, tmp_path: Path) -> None:
    """A type in a dictionary or file loads the package that has it, by the entry point of the package."""
    site = tmp_path / "site"
    shutil.copytree(plastic_spring / "plastic_spring", site / "plastic_spring")
    metadata = site / "plastic_spring-0.1.dist-info"
    metadata.mkdir()
    (metadata / "METADATA").write_text("Metadata-Version: 2.1\nName: plastic_spring\nVersion: 0.1\n")
    (metadata / "entry_points.txt").write_text("[dalembert.items]\nplastic_spring = plastic_spring\n")
    assert python(MODEL + "mbs.Save('model.json')", tmp_path, site).returncode == 0
    code = """
import dalembert as exu
mbs = exu.SystemContainer().AddSystem()
mbs.Load("model.json")
print(mbs.GetObject(2)["objectType"], mbs.GetObjectDefaults("ConnectorPlasticSpring")["yieldForce"])
"""
    done = python(code, tmp_path, site)
    assert done.stdout.split() == ["ConnectorPlasticSpring", "1.0"], done.stderr
    environment = {"PYTHONPATH": str(site)}
    listed = cli("list", cwd=tmp_path, **environment).stdout
    assert "plastic_spring 0.1" in listed and "ObjectConnectorPlasticSpring" in listed
    described = cli("PlasticSpring", cwd=tmp_path, **environment).stdout
    assert described.startswith("ObjectConnectorPlasticSpring: A spring between two points that yields")


SENSED = """
import dalembert as exu, lengths
mbs = exu.SystemContainer().AddSystem()
node = mbs.AddNode(exu.NodePoint(referenceCoordinates=[3, 4, 0]))
mbs.AddObject(exu.MassPoint(nodeNumber=node, physicsMass=1))
sensor = mbs.AddSensor(lengths.Length(nodeNumber=node, outputVariableType=exu.OutputVariableType.Position))
mbs.Assemble()
print(mbs.GetSensorValues(sensor))
mbs.SetSensorParameter(sensor, "outputVariableType", exu.OutputVariableType.StressLocal)
mbs.Assemble()
"""


def test_a_sensor_with_a_subject_measures(tmp_path: Path) -> None:
    """The output variable is checked because the sensor has a subject, and the values are those of the kernel."""
    package = tmp_path / "lengths"
    assert cli("new", package, "sensor", "Length", cwd=tmp_path).returncode == 0
    kernel = "kernels/sensors/length.hpp"
    changed(package, kernel, " : NoSubject {", " {")
    subject = """  static std::optional<SensorSubject> subject(const Parameters& p) {
    return SensorSubject{ItemKind::node, p.nodeNumber.value, p.outputVariableType};
  }

"""
    changed(package, kernel, "  // The values,", f"{subject}  // The values,")
    done = cli("build", package, cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    done = python(SENSED, tmp_path, package)
    assert done.stdout.strip() == "5.0"
    assert "an output variable of node 0" in done.stderr


LAWS = """
import numpy as np
from dalembert.laws import atan2, connector, constraint, interpolate, maximum, norm, sign, where

@connector("points")
def Hertz(u, v, t, radius=1.0, stiffness=300.0):
    length = norm(u)
    depth = maximum(radius - length, 0.0)
    return (-stiffness * depth**1.5 / length) * u + np.diag([1.0, 2.0, 3.0]) @ v * (depth > 0)

@connector("coordinates")
def Track(q, q_t, t, k=3.0, d=0.5):
    bump = np.sin(k * q) + np.exp(-q * q) * np.tanh(q) + np.sqrt(1 + q**2) + 0.1 * (q % 0.7) + (q // 0.3) + round(q)
    steps = interpolate(q, [-1, 0, 1], [2, 1, 3]) + where((q > 0) * (q < 1), q, -q) + atan2(q, 2.0) + abs(q)**1.5
    return bump * np.cos(t) + steps + d * q_t + sign(q) + 1.5**q + (1 + q * q)**(0.1 * q) + np.arctan(q)

@constraint(0, 2)
def Rod(q0, q1, t):
    return q1 @ q1 - 1

@connector("coordinates", history={"p": 0.0})
def Slider(q, q_t, t, p):
    return q - p, 0.5 * q

spring = 3
"""
COMPARED = """
import numpy as np
import dalembert as exu, hertz_items
from dalembert._core import testing
from my_laws import Hertz, Track

def numbers(make, node, body, marker):
    mbs = exu.SystemContainer().AddSystem()
    nodes = [mbs.AddNode(exu.NodePointGround()), mbs.AddNode(node)]
    mbs.AddObject(body(physicsMass=2, nodeNumber=nodes[1]))
    mbs.AddObject(make([mbs.AddMarker(marker(n)) for n in nodes]))
    mbs.Assemble()
    s = testing.State(mbs)
    s.t = 0.7
    return np.append(testing.residual(mbs, s), testing.tangent(mbs, s, cq=0.7, cv=1.3))

def compare(law, item, places, node, body, marker):
    for at in places:
        own, other = (
            numbers(make, node(at), body, marker) for make in (law, lambda markers: item(markerNumbers=markers))
        )
        np.testing.assert_allclose(other, own, rtol=0, atol=2e-14 * np.abs(own).max())
        print(np.abs(own).max())

compare(Hertz, hertz_items.Hertz, ([0.3, -0.5, 0.2], [0.1, 0.1, 1.2]),
        lambda at: exu.NodePoint(referenceCoordinates=at, initialVelocities=[0.5, 0.1, -0.3]), exu.MassPoint,
        lambda n: exu.MarkerNodePosition(nodeNumber=n))
compare(Track, hertz_items.Track, (-1.3, 0.0, 0.4, 1.7),
        lambda x: exu.Node1D(referenceCoordinates=[x], initialVelocities=[0.3]), exu.ObjectMass1D,
        lambda n: exu.MarkerNodeCoordinate(nodeNumber=n, coordinate=0))
"""


def test_items_from_laws(tmp_path: Path) -> None:
    """The kernel has the force and the tangent of the recorded law, and its generated example passes."""
    (tmp_path / "my_laws.py").write_text(LAWS)
    package = tmp_path / "hertz_items"
    for law in ("Hertz", "Track"):
        done = cli("from-law", package, f"my_laws:{law}", cwd=tmp_path)
        assert done.returncode == 0 and f"kernels/connectors/{law.lower()}.hpp" in done.stdout, done.stderr
    done = cli("check", package, "-k", "example", "-q", cwd=tmp_path)
    assert done.returncode == 0, done.stdout + done.stderr
    done = python(COMPARED, tmp_path, package, tmp_path)
    assert done.returncode == 0, done.stderr
    sizes = [float(line) for line in done.stdout.split()]
    assert sizes[0] > 100 and sizes[1] == 0 and min(sizes[2:]) > 1
    for law, message in (
        ("my_laws:Rod", "kernels can be made of laws of connector('points') and connector('coordinates')"),
        ("my_laws:Slider", "kernels can be made of laws without states; write a kernel with data coordinates"),
        ("my_laws:spring", "3 is not a law; decorate it"),
        ("my_laws:Rope", "has no attribute 'Rope'; expected module:function"),
        ("no_laws:Hertz", "No module named 'no_laws'; expected module:function"),
    ):
        done = cli("from-law", package, law, cwd=tmp_path)
        assert done.returncode == 1 and message in done.stderr, done.stderr


# ---- mistakes ----------------------------------------------------------------------------------------------------------
def changed(package: Path, path: str, old: str, new: str) -> None:
    text = (package / path).read_text()
    assert old in text
    (package / path).write_text(text.replace(old, new))


@pytest.mark.parametrize(
    ("path", "old", "new", "message"),
    [
        (
            SPEC,
            "yieldForce = {",
            "yieldForce = { units = 1,",
            "plastic_spring.toml: parameters.yieldForce: unknown key 'units'",
        ),
        (
            SPEC,
            "short_names",
            "shortnames",
            "plastic_spring.toml: unknown key 'shortnames'; did you mean 'short_names'?",
        ),
        (
            SPEC,
            '["PlasticSpring"]',
            '["SpringDamper"]',
            "short_names: 'SpringDamper' already belongs to specs/connectors/spring_damper.toml",
        ),
        (SPEC, "Distance = {", "Plasticity = {", "outputs.Plasticity: unknown name 'Plasticity'; known are"),
        (KERNEL, "p.yieldForce) return S(p", "p.yieldForse) return S(p", "has no member named ‘yieldForse’"),
        (KERNEL, "forces(const", "force(const", "PairConnectorKernel"),
    ],
    ids=["key of a row", "key", "name of the core", "output variable", "misspelt parameter", "misspelt member"],
)
def test_mistakes_in_specs_and_kernels(package: Path, path: str, old: str, new: str, message: str) -> None:
    changed(package, path, old, new)
    done = cli("build", package, cwd=package, LANG="C.UTF-8")
    assert done.returncode == 1
    assert message.replace("‘", "'").replace("’", "'") in done.stderr.replace("‘", "'").replace("’", "'")


def test_warnings_of_kernels(package: Path) -> None:
    """Warnings are about the kernel alone: nothing is printed about generated sources and headers of dalembert."""
    changed(package, KERNEL, "namespace dalembert {", "// built again\nnamespace dalembert {")
    done = cli("build", package, cwd=package)
    assert (done.returncode, done.stderr) == (0, "")
    unused = "inline int f(int unread) { int x; return 1; }\nstruct ObjectConnectorPlasticSpring"
    changed(package, KERNEL, "struct ObjectConnectorPlasticSpring", unused)
    done = cli("build", package, cwd=package, LANG="C")
    assert done.returncode == 0 and "kernels/connectors/plastic_spring.hpp" in done.stderr
    assert sorted(re.findall(r"warning: (unused \w+)", done.stderr)) == ["unused parameter", "unused variable"]


def test_a_changed_header_changes_the_stamp(package: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A package that was built against another header is refused; the command in the error mends it."""
    home = tmp_path / "home"
    tool = item_builds._header_tool()
    for file in tool.copied():
        target = home / file.relative_to(tool.ROOT)
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(file, target)
    frames = home / "core/include/dalembert/frames.hpp"
    frames.write_text(frames.read_text() + "\n// changed\n")
    monkeypatch.setattr(item_builds, "home", lambda: home)
    item_builds.build(package)
    monkeypatch.undo()
    done = python("import plastic_spring", tmp_path, package)
    error = re.sub(r"\s+", " ", done.stderr)
    found = re.search(
        r"its stamp is (\S+ \S+), but this core has (\S+ \S+)\. Build it again: dalembert items build \"(.+)\"", error
    )
    assert found is not None and "ImportError: the item package 'plastic_spring' was built for another" in error
    assert found[1] != found[2] == _item_stamp() and Path(found[3]) == package
    assert cli("build", found[3], cwd=tmp_path).returncode == 0
    assert python("import plastic_spring", tmp_path, package).returncode == 0


def test_two_packages_with_one_item(package: Path, plastic_spring: Path, tmp_path: Path) -> None:
    other = tmp_path / "other_springs"
    package.rename(other)
    (other / "plastic_spring").rename(other / "other_springs")
    changed(other, "pyproject.toml", "plastic_spring", "other_springs")
    (other / "other_springs/__init__.py").write_text("from other_springs._items import *\n")
    assert cli("build", other, cwd=tmp_path).returncode == 0
    done = python("import plastic_spring, other_springs", tmp_path, plastic_spring, other)
    assert (
        "ImportError: the item package 'other_springs' defines the item 'ObjectConnectorPlasticSpring', which exists already in"
        " 'plastic_spring'. Give it another name, or import one of both packages only."
    ) in done.stderr


def test_a_missing_package_is_named(plastic_spring: Path, tmp_path: Path) -> None:
    code = MODEL + "mbs.Save('model.json'); pickle.dump(mbs, open('model.pickle', 'wb'))"
    assert python(code, tmp_path, plastic_spring).returncode == 0
    missing = "has items of the package 'plastic_spring', which is not installed. Install it (pip install plastic_spring), or import it before."
    for load in ("exu.SystemContainer().AddSystem().Load('model.json')", "pickle.load(open('model.pickle', 'rb'))"):
        done = python(f"import pickle\nimport dalembert as exu\n{load}", tmp_path)
        assert done.returncode == 1 and missing in done.stderr
    run = subprocess.run(
        [sys.executable, "-m", "dalembert", "run", "model.json"],
        capture_output=True,
        text=True,
        cwd=tmp_path,
        check=False,
    )
    assert run.returncode == 1 and missing in run.stderr


def test_what_a_build_needs(package: Path, tmp_path: Path) -> None:
    (tmp_path / "empty").mkdir()
    for directory, environment, message in (
        (tmp_path / "empty", {}, "there is no pyproject.toml; `dalembert items new` makes a package"),
        (package, {"CXX": "no-such-compiler"}, "CXX=no-such-compiler was not found: install one that compiles C++20"),
    ):
        done = cli("build", directory, cwd=tmp_path, **environment)
        assert done.returncode == 1 and message in done.stderr
    done = cli("new", tmp_path / "springs", "conector", "Own", cwd=tmp_path)
    assert done.returncode == 1
    assert "there is no kind 'conector' of items; did you mean 'connector'?" in done.stderr
    done = cli("new", tmp_path / "springs", "connector", "SpringDamper2", cwd=tmp_path)
    assert done.returncode == 0 and "specs/connectors/spring_damper2.toml" in done.stdout.replace("_2", "2")
