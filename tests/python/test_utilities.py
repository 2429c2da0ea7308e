"""Names of the star import, solution files, sensors, graphs, joints at markers, TCP/IP, dialogs, cables, demos."""

import socket
import struct
import threading

import numpy as np
import pytest

import dalembert as exu
from dalembert import beams, demos, interactive, lieGroupIntegration, utilities
from dalembert import itemInterface as items
from dalembert.utilities import InertiaCuboid, RotationMatrixX

ROWS = 11


@pytest.fixture
def model(tmp_path):
    """A hinged bar, simulated; its solution is in solution.txt and solution.sol."""
    container = exu.SystemContainer()
    mbs = container.AddSystem()
    ground = mbs.CreateGround(name="ground")
    bar = mbs.CreateRigidBody(name="bar", referencePosition=[0.5, 0, 0], inertia=InertiaCuboid(1000, [1, 0.1, 0.2]))
    mbs.CreateRevoluteJoint(name="hinge", bodyNumbers=[ground, bar], position=[0, 0, 0], axis=[0, 0, 1])
    mbs.CreateForce(bodyNumber=bar, loadVector=[0, 10, 0])
    mbs.AddSensor(items.SensorBody(bodyNumber=bar, outputVariableType=exu.OutputVariableType.Position))
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.endTime = 0.1
    settings.timeIntegration.numberOfSteps = ROWS - 1
    settings.solutionSettings.solutionWritePeriod = 0.01
    settings.solutionSettings.sensorsStoreAndWriteFiles = False
    for binary, name in ((True, "solution.sol"), (False, "solution.txt")):
        settings.solutionSettings.binarySolutionFile = binary
        settings.solutionSettings.coordinatesSolutionFileName = str(tmp_path / name)
        mbs.SolveDynamic(settings)
    yield mbs, bar, settings


# ---- names ----------------------------------------------------------------------------------------------------------


def test_star_import_has_all_names_of_models():
    names = {}
    exec("from dalembert.utilities import *", names)
    expected = (
        "np exu exudyn graphics eii sin cos sqrt pi g sqrt2 math copy NodePoint VNodePoint MassPoint Force "
        "RotationMatrixX HT0 InertiaCuboid NormL2 VAdd eulerParameters0 color4red GraphicsDataSphere GenerateStraightBeam "
        "LoadSolutionFile DrawSystemGraph IIDiagMatrix SmoothStep"
    )
    assert set(expected.split()) <= set(names)
    assert "color" not in names and "Any" not in names
    assert names["MassPoint"] is items.ObjectMassPoint


def test_submodules_load_on_first_use():
    assert exu.graphics is exu.utilities.graphics
    assert "utilities" in dir(exu)
    with pytest.raises(AttributeError, match="no attribute 'nonsense'"):
        _ = exu.nonsense


def test_required_versions():
    exu.RequireVersion("1.6.31")
    exu.RequireVersion("1.11.0")
    with pytest.raises(RuntimeError, match=r"2\.0\.0"):
        exu.RequireVersion("2.0.0")
    with pytest.raises(ValueError, match="version"):
        exu.RequireVersion("new")


# ---- solution files -------------------------------------------------------------------------------------------------


def test_text_and_binary_files_hold_the_same(model, tmp_path):
    text = utilities.LoadSolutionFile(tmp_path / "solution.txt", verbose=False)
    binary = utilities.LoadSolutionFile(tmp_path / "solution.sol", verbose=False)
    assert text["nRows"] == binary["nRows"] == ROWS
    assert list(text["columnsExported"]) == list(binary["columnsExported"])
    assert text["nColumns"] == sum(text["columnsExported"])
    motion = slice(1, 15)  # positions and velocities
    assert np.allclose(text["data"][:, motion], binary["data"][:, motion], rtol=1e-8, atol=1e-8)
    assert np.allclose(text["data"][:, 0], np.linspace(0, 0.1, ROWS))
    for name in ("solution.txt", "solution.sol"):
        for rows in (3, np.int64(3), np.float64(3), np.array(3)):
            assert utilities.LoadSolutionFile(tmp_path / name, maxRows=rows, verbose=0)["nRows"] == 3


def test_damaged_rows_are_left_out(model, tmp_path):
    lines = (tmp_path / "solution.txt").read_text().splitlines(keepends=True)
    first = next(i for i, line in enumerate(lines) if not line.startswith("#"))
    lines[first + 2] = lines[first + 2][:20] + "\n"
    (tmp_path / "damaged.txt").write_text("".join(lines))
    safe = utilities.LoadSolutionFile(tmp_path / "damaged.txt", safeMode=True, verbose=False)
    utilities.RecoverSolutionFile(tmp_path / "damaged.txt", tmp_path / "recovered.txt")
    recovered = utilities.LoadSolutionFile(tmp_path / "recovered.txt", verbose=False)
    assert safe["nRows"] == recovered["nRows"] == ROWS - 1
    assert np.array_equal(safe["data"], recovered["data"])


def test_files_without_header(tmp_path):
    (tmp_path / "plain.txt").write_text("0,1,2\n0.1,3,4\n")
    plain = utilities.LoadSolutionFile(tmp_path / "plain.txt", hasHeader=False, verbose=False)
    assert plain["nColumns"] == 2 and plain["columnsExported"] == []
    with pytest.raises(ValueError, match="number of written coordinates"):
        utilities.LoadSolutionFile(tmp_path / "plain.txt")


def test_binary_files_that_end_early(model, tmp_path, capfd):
    content = (tmp_path / "solution.sol").read_bytes()
    (tmp_path / "short.sol").write_bytes(content[: len(content) // 2])
    with pytest.raises(ValueError, match=r"short\.sol, byte \d+: row \d: .* ends inside of this row"):
        utilities.LoadSolutionFile(tmp_path / "short.sol", verbose=False)
    short = utilities.LoadSolutionFile(tmp_path / "short.sol", verbose=False, safeMode=True)
    assert 0 < short["nRows"] < ROWS
    assert "ends early" in capfd.readouterr().out
    with pytest.raises(ValueError, match="EXUBIN"):
        utilities.LoadBinarySolutionFile(tmp_path / "solution.txt")


def test_codes_of_characters():
    assert utilities.NumpyInt8ArrayToString(np.array([65, 66], np.int8)) == "AB"
    assert utilities.NumpyInt8ArrayToString([]) == ""
    for codes in (None, [[1, 2], [3]], ["A"]):
        with pytest.raises(ValueError, match="NumpyInt8ArrayToString: npArray: expected a vector of numbers"):
            utilities.NumpyInt8ArrayToString(codes)
    with pytest.raises(ValueError, match="NumpyInt8ArrayToString: npArray: expected codes of characters, from 0"):
        utilities.NumpyInt8ArrayToString([-1])


def test_invalid_systems_and_solutions_are_named(model, tmp_path):
    with pytest.raises(ValueError, match="SetSolutionState: mbs: expected a system"):
        utilities.SetSolutionState(None, {}, 0)
    with pytest.raises(ValueError, match="AnimateSolution: solution: expected the result of LoadSolutionFile"):
        utilities.AnimateSolution(exu.SystemContainer().AddSystem(), None)
    with pytest.raises(ValueError, match="InitializeFromRestartFile: mbs: expected a system"):
        utilities.InitializeFromRestartFile(None, exu.SimulationSettings(), tmp_path / "a")
    with pytest.raises(TypeError, match="InitializeFromRestartFile: simulationSettings: expected a SimulationSettings"):
        utilities.InitializeFromRestartFile(exu.SystemContainer().AddSystem(), None, tmp_path / "a")
    with pytest.raises(ValueError, match="DrawSystemGraph: mbs: expected a system"):
        utilities.DrawSystemGraph(None)
    with pytest.raises(ValueError, match="LoadSolutionFile: maxRows: expected an integer"):
        utilities.LoadSolutionFile(tmp_path / "a", maxRows=1.5)


def test_rows_become_states(model, tmp_path):
    mbs, bar, _settings = model
    solution = utilities.LoadSolutionFile(tmp_path / "solution.txt", verbose=False)
    end = mbs.GetObjectOutputBody(bar, exu.OutputVariableType.Position, [0.5, 0, 0])
    utilities.SetSolutionState(mbs, solution, 0)
    assert np.allclose(mbs.GetObjectOutputBody(bar, exu.OutputVariableType.Position, [0.5, 0, 0]), [1, 0, 0])
    utilities.SetSolutionState(mbs, solution, ROWS - 1)
    assert np.allclose(mbs.GetObjectOutputBody(bar, exu.OutputVariableType.Position, [0.5, 0, 0]), end, atol=1e-8)
    utilities.SetSolutionState(mbs, solution, 5, exu.ConfigurationType.Visualization)
    assert mbs.systemData.GetTime(exu.ConfigurationType.Visualization) == pytest.approx(0.05)
    with pytest.raises(IndexError, match="row 11"):
        utilities.SetSolutionState(mbs, solution, ROWS)


def test_going_on_from_a_file(model, tmp_path):
    mbs, bar, settings = model
    lines = (tmp_path / "solution.txt").read_text().splitlines(keepends=True)
    rows = [i for i, line in enumerate(lines) if not line.startswith("#")]
    (tmp_path / "half.txt").write_text("".join(lines[: rows[5] + 1]))
    end = mbs.GetObjectOutputBody(bar, exu.OutputVariableType.Position, [0.5, 0, 0])
    utilities.InitializeFromRestartFile(mbs, settings, tmp_path / "half.txt", verbose=False)
    assert settings.timeIntegration.startTime == pytest.approx(0.05)
    settings.timeIntegration.numberOfSteps = 5
    settings.solutionSettings.writeSolutionToFile = False
    mbs.SolveDynamic(settings)
    assert np.allclose(mbs.GetObjectOutputBody(bar, exu.OutputVariableType.Position, [0.5, 0, 0]), end, atol=1e-5)


def test_windows_are_not_needed(model, tmp_path, capfd):
    mbs, _, _ = model
    solution = utilities.LoadSolutionFile(tmp_path / "solution.txt", verbose=False)
    utilities.AnimateSolution(mbs, solution, runLoop=True)
    mbs.SolutionViewer(solution)
    mbs.SolutionViewer()  # of the last simulation
    assert capfd.readouterr().out.count("SolutionViewer: there is no window") == 1
    with pytest.raises(ValueError, match="rowIncrement"):
        utilities.AnimateSolution(mbs, solution, rowIncrement=0)
    for name, value in {"rowIncrement": 12, "runMode": 3, "timeout": 0, "title": None, "mainSystem": None}.items():
        arguments = {"mainSystem": mbs, "solution": solution, name: value}
        with pytest.raises((TypeError, ValueError), match=f"SolutionViewer: {name}"):
            interactive.SolutionViewer(**arguments)


# ---- sensors, joints, visibility ------------------------------------------------------------------------------------


def test_recorded_sensors(model):
    mbs, _bar, settings = model
    utilities.AddSensorRecorder(mbs, 0, 0.1, 0.01)
    mbs.Assemble()
    settings.solutionSettings.sensorsStoreAndWriteFiles = True
    settings.solutionSettings.sensorsWritePeriod = 0.01
    mbs.SolveDynamic(settings)
    record = mbs.variables["sensorRecord0"]
    assert record.shape == (ROWS, 4)
    assert np.allclose(record[-1, 1:], mbs.GetSensorValues(0))


def test_joint_arguments_from_one_marker(model):
    mbs, bar, _ = model
    marker = mbs.AddMarker(items.MarkerBodyRigid(bodyNumber=bar, localPosition=[0.1, 0.2, 0]))
    ground = exu.ObjectIndex(0)
    given = RotationMatrixX(0.3)
    arguments = utilities.GetJointArgs(mbs, markerNumber0=marker, rotationMarker0=given, bodyNumber1=ground)
    assert arguments["markerNumbers"][0] == marker
    assert np.allclose(arguments["rotationMarker0"], given) and np.allclose(arguments["rotationMarker1"], given)
    assert np.allclose(mbs.GetMarker(arguments["markerNumbers"][1])["localPosition"], [0.6, 0.2, 0])
    swapped = utilities.GetJointArgs(mbs, markerNumber1=marker, bodyNumber0=ground)
    assert swapped["markerNumbers"][1] == marker
    other = utilities.GetOtherMarker(mbs, ground, marker)
    assert np.allclose(mbs.GetMarker(other)["localPosition"], [0.6, 0.2, 0])
    with pytest.raises(ValueError, match="exactly one"):
        utilities.GetJointArgs(mbs, markerNumber0=marker, markerNumber1=marker, bodyNumber1=ground)
    with pytest.raises(ValueError, match="bodyNumber0 must be given"):
        utilities.GetJointArgs(mbs, markerNumber1=marker)


def test_visibility_and_highlights(model):
    mbs, _, _ = model
    shown = lambda: [mbs.GetObject(i)["Vshow"] for i in range(mbs.systemData.NumberOfObjects())]  # noqa: E731
    utilities.ShowOnlyObjects(mbs, 1)
    assert shown() == [False, True, False]
    utilities.ShowOnlyObjects(mbs, [1], showOthers=True)
    assert shown() == [True, False, True]
    utilities.ShowOnlyObjects(mbs)
    assert shown() == [True, True, True]
    container = mbs.GetSystemContainer()
    utilities.HighlightItem(container, mbs, 1, exu.ItemType.Marker)
    assert container.visualizationSettings.interactive.highlightItemIndex == 1
    assert container.visualizationSettings.markers.showNumbers
    assert not container.visualizationSettings.nodes.showNumbers


# ---- graph ----------------------------------------------------------------------------------------------------------


def test_graph_of_the_system(model):
    mbs, _, _ = model
    _, graph, texts = mbs.DrawSystemGraph(showGraph=False, addItemData=True, addAnnotations=True)
    assert texts is None
    assert {"Node0", "Object0", "Object1", "Ojoint2", "Marker0", "Load0", "Sensor0"} <= set(graph.nodes)
    assert {frozenset(edge) for edge in graph.edges} >= {
        frozenset(("Object1", "Node0")),
        frozenset(("Ojoint2", "Marker0")),
        frozenset(("Marker0", "Object0")),
        frozenset(("Sensor0", "Object1")),
    }
    assert graph.nodes["Ojoint2"]["type"] == "ObjectJointRevoluteZ" and graph.nodes["Ojoint2"]["name"] == "hinge"
    assert "rotationMarker0" in graph.nodes["Ojoint2"]["annotations"]
    _, named, _ = mbs.DrawSystemGraph(showGraph=False, useItemTypes=True, showLoads=False, showSensors=False)
    assert "ObjectJointRevoluteZ2" in named.nodes and not any("Load" in node for node in named.nodes)


def test_graph_is_drawn(model, tmp_path):
    import matplotlib.pyplot as plt

    _, graph, texts = model[0].DrawSystemGraph(useItemTypes=True, layoutIterations=5)
    assert set(texts) == set(graph.nodes) and "Node-\nRigidBodyEP0" not in texts
    plt.savefig(tmp_path / "graph.png")
    plt.close("all")


# ---- TCP/IP ---------------------------------------------------------------------------------------------------------


def test_numbers_go_both_ways():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]

    def other_side():
        for _ in range(200):
            try:
                connection = socket.create_connection(("127.0.0.1", port), timeout=5)
                break
            except ConnectionRefusedError:
                threading.Event().wait(0.01)
        with connection:
            a, b = struct.unpack("<2d", connection.recv(16))
            packed = struct.pack("<3d", a + b, a - b, a * b)
            connection.sendall(packed[:5])
            threading.Event().wait(0.02)
            connection.sendall(packed[5:])

    thread = threading.Thread(target=other_side)
    thread.start()
    data = utilities.CreateTCPIPconnection(2, 3, port=port)
    assert utilities.TCPIPsendReceive(data, [3.0, 4.0]) == (7.0, -1.0, 12.0)
    thread.join()
    utilities.CloseTCPIPconnection(data)


# ---- dialogs --------------------------------------------------------------------------------------------------------


def test_a_dialog_without_window_runs_the_simulation(model):
    mbs, _, settings = model
    settings.solutionSettings.writeSolutionToFile = False
    settings.timeIntegration.numberOfSteps = 100
    seen, changed = [], []
    dialog_items = [
        {"type": "label", "text": "speed"},
        {"type": "slider", "range": (0, 4), "value": 7, "variable": "speed"},
        {"type": "radio", "textValueList": [("a", 1), ("b", 2)], "value": 2, "variable": "choice"},
    ]
    dialog_items.append({"type": "label", "text": "no periods yet"})

    def period(mbs, dialog):
        seen.append(mbs.variables["speed"])
        dialog.labelStringVariables[-1].set(f"{len(seen)} periods")

    dialog = interactive.InteractiveDialog(
        mbs,
        settings,
        period,
        dialog_items,
        period=0.02,
        runOnStart=True,
        addLabelStringVariables=True,
        userOnChange=lambda mbs, dialog: changed.append(mbs.variables["choice"]),
    )
    assert seen == [2.0] * 5 and changed == [2]
    assert dialog.labelStringVariables[-1].get() == dialog_items[-1]["text"] == "5 periods"
    assert mbs.systemData.GetTime() == pytest.approx(0.1)


@pytest.mark.parametrize(
    ("items", "words"),
    [
        ("label", "dialogItems: expected a list of dictionaries"),
        ([{"type": "knob"}], r"dialogItems\[0\]: type: expected label or button or .*, received 'knob'"),
        ([{"type": "label", "text": "a"}, {"type": "slider"}], r"dialogItems\[1\]: a slider needs 'variable'"),
        ([{"type": "button", "text": "a"}], r"dialogItems\[0\]: a button needs 'callFunction'"),
    ],
)
def test_dialog_items_that_cannot_be_shown_are_refused_before_anything_runs(model, items, words):
    mbs, _, settings = model
    with pytest.raises(ValueError, match=words):
        interactive.InteractiveDialog(mbs, settings, lambda mbs, dialog: None, items)
    with pytest.raises(TypeError, match="InteractiveDialog: simulationSettings"):
        interactive.InteractiveDialog(mbs, 5, lambda mbs, dialog: None, [])


def test_modes_become_visible_states(model):
    mbs, _, _ = model
    modes = np.eye(7)
    container = mbs.GetSystemContainer()
    interactive.AnimateModes(container, mbs, None, systemEigenVectors=modes, scaleAmplitude=2)
    shown = mbs.systemData.GetODE2Coordinates(exu.ConfigurationType.Visualization)
    assert np.allclose(shown, 0.1 * modes[0])
    with pytest.raises(ValueError, match="systemEigenVectors"):
        interactive.AnimateModes(container, mbs, None)


@pytest.mark.parametrize(
    ("name", "value", "error"),
    [
        ("systemContainer", None, TypeError),
        ("mainSystem", 3, TypeError),
        ("nodeNumber", 1.5, TypeError),
        ("period", "fast", ValueError),
        ("period", 0, ValueError),
        ("stepsPerPeriod", 2.5, TypeError),
        ("stepsPerPeriod", 0, ValueError),
        ("runMode", "once", TypeError),
        ("runMode", 4, ValueError),
        ("scaleAmplitude", None, ValueError),
        ("title", 3, TypeError),
        ("systemEigenVectors", 3, ValueError),
        ("systemEigenVectors", [1, 2], ValueError),
        ("systemEigenVectors", ["first"], ValueError),
        ("systemEigenVectors", np.full((7, 7), np.nan), ValueError),
        ("systemEigenVectors", np.eye(6), ValueError),
    ],
)
def test_wrong_arguments_of_modes_are_named(model, name, value, error):
    mbs, _, _ = model
    good = {"systemContainer": mbs.GetSystemContainer(), "mainSystem": mbs, "nodeNumber": None}
    before = mbs.systemData.GetODE2Coordinates(exu.ConfigurationType.Visualization)
    with pytest.raises(error, match=f"AnimateModes: {name}"):
        interactive.AnimateModes(**(good | {"systemEigenVectors": np.eye(7), name: value}))
    assert np.array_equal(mbs.systemData.GetODE2Coordinates(exu.ConfigurationType.Visualization), before)


# ---- cables, rotations, demos ---------------------------------------------------------------------------------------


def cable():
    return items.ObjectANCFCable2D(physicsMassPerLength=1, physicsBendingStiffness=1, physicsAxialStiffness=100)


def test_cable_along_a_line():
    container = exu.SystemContainer()
    mbs = container.AddSystem()
    nodes, elements, loads, positions, constraints = beams.GenerateStraightLineANCFCable2D(
        mbs, [0, 0, 0], [3, 4, 0], 5, cable(), [0, -9.81, 0], [1, 1, 0, 1], [0, 1, 0, 0]
    )
    assert [len(x) for x in (nodes, elements, loads, positions, constraints)] == [6, 5, 5, 6, 4]
    assert mbs.GetObject(elements[4])["physicsLength"] == pytest.approx(1)
    assert [int(n) for n in mbs.GetObject(elements[4])["nodeNumbers"]] == [4, 5]
    assert np.allclose(mbs.GetNode(nodes[2])["referenceCoordinates"], [1.2, 1.6, 0.6, 0.8])
    assert np.allclose(positions[5], [3, 4, 0])


def test_cable_along_an_arc():
    container = exu.SystemContainer()
    mbs = container.AddSystem()
    template = cable()
    nodes, elements, *_ = beams.GenerateCircularArcANCFCable2D(mbs, [0, 0, 0], 2, 0, np.pi / 2, 3, template)
    assert np.allclose(mbs.GetNode(nodes[-1])["referenceCoordinates"], [2, 2, 0, 1])
    assert mbs.GetObject(elements[0])["physicsReferenceCurvature"] == pytest.approx(0.5)
    assert template.physicsReferenceCurvature == 0


@pytest.mark.parametrize(
    "change, text",
    [
        ({"numberOfElements": 0}, "numberOfElements.*positive"),
        ({"positionOfNode1": [0, 0, 0]}, "positionOfNode1"),
        ({"beamTemplate": 3}, "beamTemplate.*ObjectANCFCable2D"),
        ({"fixedConstraintsNode0": [1, 1]}, "fixedConstraintsNode0.*4 flags"),
    ],
)
def test_wrong_beams_are_refused(change, text):
    container = exu.SystemContainer()
    mbs = container.AddSystem()
    right = {"positionOfNode0": [0, 0, 0], "positionOfNode1": [1, 0, 0], "numberOfElements": 2, "beamTemplate": cable()}
    with pytest.raises(ValueError, match=text):
        beams.GenerateStraightBeam(mbs, **(right | change))
    assert mbs.systemData.NumberOfNodes() == 0


def test_belt_around_two_equal_wheels():
    curve = beams.CreateReevingCurve([[[0, 0], 0.5, "L"], [[2, 0], 0.5, "L"]], numberOfANCFnodes=16, closedCurve=True)
    assert curve["totalLength"] == pytest.approx(4 + np.pi)
    assert len(curve["ancfPointsSlopes"]) == 17 and len(curve["elementLengths"]) == 16
    assert np.allclose(curve["ancfPointsSlopes"][0], curve["ancfPointsSlopes"][-1])
    assert set(np.round(np.abs(curve["elementCurvatures"]), 12)) == {0.0, 2.0}
    with pytest.raises(ValueError, match="radius"):
        beams.CreateReevingCurve([[[0, 0], 0, "L"], [[2, 0], 1, "L"]], numberOfANCFnodes=4)


@pytest.mark.parametrize("method, order", [("RK1", 1), ("RK4", 4)])
def test_order_of_rotation_integrators(method, order):
    inertia = np.array([1.0, 2.0, 3.0])
    start = np.array([1.0, 2.0, 0.5])

    def acceleration(v, w):
        return -np.cross(w, inertia * w) / inertia

    def end(steps):
        run = lieGroupIntegration.RK_SolveEulersEOMWithProposedApproach
        solution = run(acceleration, np.zeros(3), start, 0.5, steps, method)
        return np.concatenate([solution["rotationVector"][-1], solution["angularVelocity"][-1]])

    steps = 400 if order == 1 else 20
    coarse, fine, finest = end(steps), end(2 * steps), end(64 * steps)
    assert np.log2(np.linalg.norm(coarse - finest) / np.linalg.norm(fine - finest)) == pytest.approx(order, abs=0.15)


def test_explicit_steps_in_place_of_newton(model):
    container = exu.SystemContainer()
    mbs = container.AddSystem()
    kind = exu.NodeType.RotationRotationVector
    bar = mbs.CreateRigidBody(
        inertia=InertiaCuboid(1000, [1, 0.1, 0.2]), nodeType=kind, initialAngularVelocity=[5, 1, 2]
    )
    mass = mbs.CreateMassPoint(physicsMass=1, initialVelocity=[1, 0, 0])
    mbs.CreateCoordinateConstraint(bodyNumbers=[None, mass], coordinates=[None, 2])
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.endTime = 0.2
    settings.timeIntegration.numberOfSteps = 100
    settings.solutionSettings.writeSolutionToFile = False
    energy = lambda: mbs.GetObjectOutputBody(bar, exu.OutputVariableType.AngularVelocityLocal, [0, 0, 0])  # noqa: E731
    tensor = InertiaCuboid(1000, [1, 0.1, 0.2]).InertiaCOM()
    before = energy() @ tensor @ energy()
    solver = exu.MainSolverImplicitSecondOrder()
    lieGroupIntegration.LieGroupExplicitRKInitialize(mbs)
    assert mbs.sys["constrainedToGroundCoordinatesList"] == [8]
    solver.SetUserFunctionNewton(mbs, lieGroupIntegration.UserFunctionNewtonLieGroupRK4)
    assert solver.SolveSystem(mbs, settings)
    assert energy() @ tensor @ energy() == pytest.approx(before, rel=1e-8)
    assert mbs.GetObjectOutputBody(mass, exu.OutputVariableType.Position, [0, 0, 0])[0] == pytest.approx(0.2)


def test_demos(capfd, monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    mbs, _container = demos.Demo1(showAll=False)
    assert mbs.GetNodeOutput(exu.NodeIndex(0), exu.OutputVariableType.Displacement)[0] == pytest.approx(5e-5)
    mbs, _container = demos.Demo2(showAll=False)
    assert mbs.ComputeSystemDegreeOfFreedom()["degreeOfFreedom"] == 36
    assert not list(tmp_path.iterdir())
