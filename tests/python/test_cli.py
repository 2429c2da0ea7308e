"""The command dalembert: run, info, check, items, demo."""

import multiprocessing
import subprocess
import sys

import numpy as np
import pytest

from dalembert import cli

MODEL = """
import sys
import exudyn as exu
from exudyn.utilities import *
import neighbour

SC = exu.SystemContainer()
mbs = SC.AddSystem()
mbs.CreateGround()
print(__name__, sys.argv[1:], exu.__name__, mbs.systemData.NumberOfObjects(), neighbour.value)
sys.exit(int(sys.argv[1]) if len(sys.argv) > 1 else 0)
"""


def run(*arguments, cwd=None):
    command = [sys.executable, "-m", "dalembert", *arguments]
    return subprocess.run(command, capture_output=True, text=True, check=False, cwd=cwd)


def test_models_run_unchanged(tmp_path):
    (tmp_path / "model.py").write_text(MODEL)
    (tmp_path / "neighbour.py").write_text("value = 42")
    result = run("run", str(tmp_path / "model.py"), "3", "--fast", cwd=tmp_path.parent)
    assert "__main__ ['3', '--fast'] dalembert 1 42" in result.stdout, result.stderr
    assert result.returncode == 3


PROCESSES = """
import multiprocessing
from concurrent.futures import ProcessPoolExecutor
import exudyn as exu
from exudyn.utilities import *

def found(start):
    return start, multiprocessing.parent_process() is not None, exu.__name__, NodePoint.__name__

if __name__ == "__main__":
    for start in multiprocessing.get_all_start_methods():
        with ProcessPoolExecutor(1, multiprocessing.get_context(start)) as pool:
            print(*pool.submit(found, start).result())
"""


def test_processes_of_models_find_the_package(tmp_path):
    """They read the model anew, unless they are forked."""
    (tmp_path / "model.py").write_text(PROCESSES)
    result = run("run", "model.py", cwd=tmp_path)
    expected = [f"{start} True dalembert NodePoint" for start in multiprocessing.get_all_start_methods()]
    assert result.stdout.splitlines() == expected, result.stderr


COPIED = """
import copy, pickle
import exudyn as exu
from exudyn.itemInterface import *

mbs = exu.SystemContainer().AddSystem()
marker = mbs.AddMarker(MarkerNodePosition(nodeNumber=mbs.AddNode(NodePoint())))

def push(mbs, t, load):
    return [2 * x for x in load]

mbs.AddLoad(Force(markerNumber=marker, loadVector=[1, 0, 0], loadVectorUserFunction=push))
for other in (copy.copy(mbs), copy.deepcopy(mbs), pickle.loads(pickle.dumps(mbs))):
    other.Assemble()
    print(other.GetLoadValues(0).tolist())
"""


def test_models_may_pickle_systems_with_functions_of_their_own(tmp_path):
    (tmp_path / "model.py").write_text(COPIED)
    result = run("run", str(tmp_path / "model.py"))
    assert result.stdout.splitlines() == ["[2.0, 0.0, 0.0]"] * 3, result.stderr


def test_a_missing_model_is_named():
    result = run("run", "nowhere.py")
    assert result.returncode == 2 and "nowhere.py" in result.stderr and "Traceback" not in result.stderr


def test_errors_of_models_keep_their_traceback(tmp_path):
    (tmp_path / "broken.py").write_text("import exudyn\n1/0\n")
    result = run("run", str(tmp_path / "broken.py"))
    assert result.returncode == 1 and "ZeroDivisionError" in result.stderr and "broken.py" in result.stderr


def test_info(capsys):
    assert cli.main(["info"]) == 0
    out = capsys.readouterr().out
    assert "interface" in out and "1.13.6" in out and "node types" in out


def test_all_items_are_listed(capsys):
    assert cli.main(["items"]) == 0
    lines = [line.strip() for line in capsys.readouterr().out.splitlines()]
    assert {"NodePoint", "ObjectRigidBody", "MarkerBodyRigid", "LoadForceVector", "SensorBody"} <= set(lines)
    assert "VNodePoint" not in lines and "MassPoint" not in lines


def test_parameters_of_an_item(capsys):
    assert cli.main(["items", "MassPoint"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0].startswith("ObjectMassPoint")
    assert "    physicsMass: float = 0.0, >= 0, unit kg; also named mass" in lines
    assert "    Position: 3 numbers, unit m" in lines


def test_misspelled_items(capsys):
    assert cli.main(["items", "NodePoit"]) == 2
    assert "did you mean NodePoint" in capsys.readouterr().err


def test_demo_writes_a_plot(tmp_path, capsys):
    target = tmp_path / "demo.png"
    assert cli.main(["demo", "--output", str(target)]) == 0
    assert str(target) in capsys.readouterr().out
    assert target.read_bytes().startswith(b"\x89PNG")


def test_demo_opens_its_page_where_there_is_a_display(tmp_path, capsys, monkeypatch):
    opened = []
    monkeypatch.setattr("webbrowser.open", lambda address: opened.append(address) or True)
    monkeypatch.setattr("dalembert._pictures.showing.has_display", lambda: False)
    assert cli.main(["demo", "--output", str(tmp_path / "demo.png")]) == 0
    assert opened == [] and "open it in a browser" in capsys.readouterr().out
    monkeypatch.setattr("dalembert._pictures.showing.has_display", lambda: True)
    assert cli.main(["demo", "--output", str(tmp_path / "demo.png")]) == 0
    assert opened == [(tmp_path / "demo.html").as_uri()] and (tmp_path / "demo.html").is_file()
    assert "it moves in the browser" in capsys.readouterr().out


def test_a_command_is_needed(capsys):
    with pytest.raises(SystemExit):
        cli.main([])
    assert "usage: dalembert" in capsys.readouterr().err


SWING = """
import exudyn as exu
from exudyn.utilities import *

mbs = exu.SystemContainer().AddSystem()
ground = mbs.CreateGround()
arm = mbs.CreateRigidBody("arm", [0.5, 0, 0], inertia=InertiaCuboid(1000, [1, 0.1, 0.1]), gravity=[0, -9.81, 0])
mbs.CreateRevoluteJoint("hinge", [ground, arm], [0, 0, 0], [0, 0, 1])
mbs.AddSensor(SensorBody("tip", arm, outputVariableType=exu.OutputVariableType.Position, storeInternal=True))
mbs.Assemble()
settings = exu.SimulationSettings()
settings.timeIntegration.numberOfSteps = 100
settings.solutionSettings.writeSolutionToFile = False
mbs.Save("swing.json", settings)
mbs.SolveDynamic(settings)
print("solved")
"""
WRONG = """
from exudyn.utilities import *
import exudyn as exu

mbs = exu.SystemContainer().AddSystem()
ground = mbs.CreateGround()
arm = mbs.CreateRigidBody("arm", [0.5, 0, 0], inertia=RigidBodyInertia(2, 1e7 * np.eye(3)), gravity=[0, -9810, 0])
for z in (0, 0.1):
    mbs.CreateRevoluteJoint("", [ground, arm], [0, 0, z], [0, 0, 1])
mbs.SetNodeParameter(0, "initialCoordinates", [0.1] + [0] * 6)
mbs.AddNode(NodePoint(name="forgotten"))
ends = [mbs.AddMarker(MarkerBodyPosition(bodyNumber=arm)) for _ in range(2)]
mbs.AddObject(SpringDamper("loop", markerNumbers=ends, stiffness=1))
mbs.AddMarker(MarkerNodePosition(name="lost", nodeNumber=0))
mbs.AddSensor(SensorNode(
    name="deaf", nodeNumber=0, writeToFile=False, outputVariableType=exu.OutputVariableType.Position
))
mbs.SolveDynamic()
"""


def test_model_files(tmp_path):
    (tmp_path / "swing.py").write_text(SWING)
    assert run("run", "swing.py", cwd=tmp_path).stdout.splitlines()[-1] == "solved"
    done = run("run", "swing.json", cwd=tmp_path)
    assert done.returncode == 0 and done.stdout.splitlines()[-1].startswith("tip: [")
    for file in ("swing.json", "swing.py"):
        told = run("info", file, cwd=tmp_path).stdout
        assert "1 node, 3 objects, 3 markers, 1 load, 1 sensor" in told
        assert "degrees of freedom  1\n" in told and "10 kg" in told
        checked = run("check", file, cwd=tmp_path)
        assert checked.returncode == 0 and checked.stdout.endswith("nothing looks wrong\n"), checked.stdout
        assert "solved" not in checked.stdout
    (tmp_path / "swing.json").write_text("{")
    broken = run("run", "swing.json", cwd=tmp_path)
    assert (
        broken.returncode == 1 and broken.stderr.startswith("swing.json, line 1") and "Traceback" not in broken.stderr
    )


DRIVEN = """
import dalembert as exu
from dalembert.utilities import *

def push(mbs, t, load):
    return load

mbs = exu.SystemContainer().AddSystem()
body = mbs.CreateRigidBody("arm", [500, 0, 0], inertia=InertiaCuboid(1, [1, 1, 1]))
mbs.CreateForce("push", body, loadVectorUserFunction=push)
mbs.CreateRevoluteJoint("hinge", [mbs.CreateGround("ground"), body], [0, 0, 0], [0, 0, 1])
ends = [
    mbs.AddMarker(MarkerBodyRigid(bodyNumber=name, localPosition=[1, 0, 0])) for name in ("ground", "arm")
]
mbs.AddObject(SphericalJoint("ball", markerNumbers=ends))
mbs.Save("driven.json", sourceOfFunctions=True)
mbs.SolveDynamic()
"""


MOVED = """
import numpy as np

import dalembert as exu
from dalembert.utilities import *

mbs = exu.SystemContainer().AddSystem()
fixed = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.AddNode(NodePointGround()), coordinate=0))
rotor = mbs.AddNode(Node1D("rotor", initialVelocities=[2 * np.pi]))
mbs.AddObject(Rotor1D("disc", physicsInertia=1, nodeNumber=rotor))
turned = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=rotor, coordinate=0))
motor = CoordinateConstraint("motor", markerNumbers=[fixed, turned], offsetUserFunction=lambda mbs, t, i, o: 2 * np.pi * t)
mbs.AddObject(motor)
contact = mbs.AddGeneralContact()
contact.SetFrictionPairings([[0]])
ball = mbs.AddMarker(MarkerNodePosition(nodeNumber=mbs.AddNode(NodePoint("here"))))
mbs.AddObject(MassPoint("ball", physicsMass=1, nodeNumber="here"))
contact.AddSphereWithMarker(ball, radius=1, contactStiffness=1, contactDamping=0, frictionMaterialIndex=0)
mbs.SolveDynamic()
"""


def test_driven_and_touching_bodies_are_no_mistakes(tmp_path):
    """A motor leaves no degree of freedom, its speed is found by differences; markers of contact are used."""
    (tmp_path / "moved.py").write_text(MOVED)
    checked = run("check", "moved.py", cwd=tmp_path)
    assert checked.returncode == 0 and checked.stdout.endswith("nothing looks wrong\n"), checked.stdout
    still = MOVED.replace(", offsetUserFunction=lambda mbs, t, i, o: 2 * np.pi * t", "").replace("2 * np.pi", "0")
    still = still.split("contact =")[0] + "mbs.SolveDynamic()"
    (tmp_path / "still.py").write_text(still)
    assert "nothing can move" in run("check", "still.py", cwd=tmp_path).stdout


def test_loads_that_act_twice_or_not_at_all_are_reported(tmp_path):
    lines = SWING.replace(
        "mbs.Assemble()",
        "mbs.AddLoad(Gravity('again', markerNumber=0, loadVector=[0, -9.81, 0]))\n"
        "mbs.CreateForce('push', bodyNumber=ground, loadVector=[1, 0, 0])\nmbs.Assemble()",
    )
    (tmp_path / "loaded.py").write_text(lines)
    told = run("check", "loaded.py", cwd=tmp_path).stdout
    assert "and load 1 'again' both act on the mass of object 1 'arm': is its weight there twice?" in told, told
    assert "load 2 'push' is on ground, and without effect." in told and told.endswith("2 findings\n")


def test_equal_items_are_reported_together(tmp_path):
    lines = WRONG.replace("mbs.SolveDynamic()", "")
    more = "for _ in range(3):\n    mbs.AddMarker(MarkerNodePosition(nodeNumber=0))\nmbs.SolveDynamic()\n"
    (tmp_path / "wrong.py").write_text(lines + more)
    told = run("check", "wrong.py", cwd=tmp_path).stdout
    assert "'lost' and 3 others are used by nothing." in told, told


def test_initial_gaps_are_reported(tmp_path):
    """Two places of a body cannot be at one place: frames of the search for other modules are omitted."""
    (tmp_path / "driven.py").write_text(DRIVEN)
    told = run("check", "driven.py", cwd=tmp_path).stdout
    assert "contradict a constraint: object 3 'ball' (ObjectJointSpherical), equation 0: gap 500 m" in told, told
    assert "no values near these fulfil all constraints" in told and "'hinge' (ObjectJointRevoluteZ)" not in told


def test_commands_of_model_files_run_code_when_they_are_asked_to(tmp_path):
    (tmp_path / "driven.py").write_text(DRIVEN)
    run("check", "driven.py", cwd=tmp_path)  # up to its solver, after it has saved
    for command in ("info", "check", "run"):
        refused = run(command, "driven.json", cwd=tmp_path)
        assert refused.returncode == 1 and "Add --allow-code if you trust the file" in refused.stderr
    assert "mass                1 kg" in run("info", "--allow-code", "driven.json", cwd=tmp_path).stdout


FREE = """
import dalembert as exu
mbs = exu.SystemContainer().AddSystem()
mbs.AddMarker(exu.MarkerNodePosition("here", nodeNumber=mbs.AddNode(exu.NodePoint("free"))))
mbs.Save("free.json")
"""


def test_a_model_file_that_cannot_be_solved(tmp_path):
    (tmp_path / "free.py").write_text(FREE)
    checked = run("check", "free.py", cwd=tmp_path)
    assert "node 0 'free' (Point) belongs to no object" in checked.stdout and checked.returncode == 1
    failed = run("run", "free.json", cwd=tmp_path)
    assert failed.returncode == 1 and "node 0 'free'" in failed.stderr and "Traceback" not in failed.stderr


def test_readers_that_stop(tmp_path):
    command = f"{sys.executable} -m dalembert items | head -n 1; exit ${{PIPESTATUS[0]}}"
    done = subprocess.run(["bash", "-c", command], capture_output=True, text=True, check=False)
    assert done.stdout.startswith("Node (") and done.stderr == ""


def test_suspicious_models_are_reported(tmp_path):
    (tmp_path / "wrong.py").write_text(WRONG)
    checked = run("check", "wrong.py", cwd=tmp_path)
    assert checked.returncode == 1 and "WARNING" not in checked.stdout + checked.stderr
    for text in ("contradict a constraint", "5 of", "redundant", "radius of gyration", "gravity in mm/s^2", "'forgotten'",
                 "'lost'", "'deaf'", "'loop' (ConnectorSpringDamper) joins a place with itself"):  # fmt: skip
        assert text in checked.stdout, checked.stdout + checked.stderr


def test_plots_of_files(tmp_path):
    time = np.linspace(0, 1, 11)
    np.savetxt(tmp_path / "a.txt", np.column_stack([time, time**2, -time]), delimiter=",")
    result = run("plot", "a.txt", "a.txt", "--columns", "1", "--save", "plots/a.png", "--title", "fall", cwd=tmp_path)
    assert result.returncode == 0, result.stderr
    assert (tmp_path / "plots/a.png").read_bytes()[1:4] == b"PNG"
    result = run("plot", "b.txt", cwd=tmp_path)
    assert result.returncode == 1 and "b.txt" in result.stderr
    result = run("plot", "a.txt", "-c", "x", cwd=tmp_path)
    assert (result.returncode, result.stderr) == (2, "dalembert plot: --columns: expected numbers as 0,1; received x\n")


def test_dialogs_are_refused():
    result = run("dialogs", "sim")
    assert result.returncode == 2 and "there are no dialogs; the page of a model has its settings" in result.stderr
