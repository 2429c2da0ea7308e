"""Wherever an index is taken, a name is too: all parameters of items, all methods, all functions of the modules.

Each case is called twice on equal systems, with an index and with the name of the same item: results and effects are
the same. An error for a misspelt name has the nearest one.
"""

from __future__ import annotations

import inspect
import re
from collections.abc import Callable, Iterator
from importlib import import_module
from pathlib import Path
from typing import Any

import matplotlib as mpl
import numpy as np
import pytest

import dalembert as exu
from dalembert import (
    FEM,
    beams,
    create,
    interactive,
    machines,
    mainSystemExtensions,
    plot,
    results,
    rigidBodyUtilities,
    shells,
    utilities,
)
from dalembert._core import _parameters_of
from dalembert.advancedUtilities import CreateLoadEnergySensor, LoadPotentialEnergy
from dalembert.create import _interface
from dalembert.create._arguments import REFERENCES
from dalembert.rigidBodyUtilities import HTtranslate, InertiaCuboid
from dalembert.robotics import Robot, RobotLink, mobile
from dalembert.robotics import utilities as robots

mpl.use("Agg")

ARM = Path(__file__).parents[2] / "examples/six_axis_arm.urdf"
CABLE = {"physicsMassPerLength": 1, "physicsBendingStiffness": 1, "physicsAxialStiffness": 1}
KINDS = ("Node", "Object", "Marker", "Load", "Sensor")
POSITION, REFERENCE = exu.OutputVariableType.Position, exu.ConfigurationType.Reference
# Names and numbers of one item of each kind.
NAMES = {"Node": "foot", "Object": "arm", "Marker": "hook", "Load": "push", "Sensor": "way"}


def system() -> Any:
    """Return an assembled system with a free arm, ground, a node, markers, a load, a sensor and two cables."""
    mbs = exu.SystemContainer().AddSystem()
    mbs.CreateGround("base")
    mbs.CreateRigidBody("arm", [0.5, 0, 0], inertia=InertiaCuboid(1000, [1, 0.1, 0.1]))
    mbs.CreateRigidBody("hand", [1.5, 0, 0], inertia=InertiaCuboid(1000, [1, 0.1, 0.1]))
    mbs.AddNode(exu.NodePoint2DSlope1("foot", referenceCoordinates=[2, 0, 1, 0]))
    mbs.AddNode(exu.NodePoint2DSlope1("toe", referenceCoordinates=[3, 0, 1, 0]))
    mbs.AddObject(exu.ObjectANCFCable2D("cable", nodeNumbers=["foot", "toe"], physicsLength=1, **CABLE))
    mbs.AddMarker(exu.MarkerBodyRigid("floor", bodyNumber="base"))
    mbs.AddMarker(exu.MarkerBodyRigid("hook", bodyNumber="arm", localPosition=[0.5, 0, 0]))
    mbs.AddLoad(exu.LoadForceVector("push", markerNumber="hook", loadVector=[4, 0, 0]))
    sensor = {"bodyNumber": "arm", "outputVariableType": POSITION, "storeInternal": True}
    mbs.AddSensor(exu.SensorBody("way", **sensor))
    return mbs


def solved() -> Any:
    mbs = system()
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = 8
    settings.solutionSettings.writeSolutionToFile = False
    settings.solutionSettings.sensorsWritePeriod = 1e-9
    mbs.SolveDynamic(settings)
    return mbs


def state(mbs: Any, returned: Any) -> str:
    """Return results and effects of a call as text; figures and other objects count by their type."""
    shown = (
        returned if isinstance(returned, (int, float, str, list, dict, np.ndarray, exu.ObjectIndex)) else type(returned)
    )
    return re.sub(r" at 0x\w+", "", f"{mbs.GetDictionary()} {shown!r}")


def index(mbs: Any, kind: str, name: str) -> Any:
    return getattr(mbs, f"Get{kind}Number")(name)


# ---- parameters of items ---------------------------------------------------------------------------------------------

CLASSES = [
    cls
    for name, cls in vars(exu).items()
    if isinstance(cls, type) and cls.__name__ == name and name.startswith(KINDS) and hasattr(cls, "visualization")
]
ROWS = [
    (cls, row, match[2], bool(match[1]), int(match[3] or 1))
    for cls in CLASSES
    for row, words, *_ in _parameters_of(cls)
    if (match := re.fullmatch(r"(list of )?(\w+)Index(?: of length (\d+))?", words))
]


@pytest.mark.parametrize(
    ("cls", "row", "kind", "is_list", "length"), ROWS, ids=[f"{cls.__name__}.{row}" for cls, row, *_ in ROWS]
)
def test_items_take_names(cls: Any, row: str, kind: str, is_list: bool, length: int) -> None:
    mbs, name = system(), NAMES[kind]
    value = [name] * length if is_list else name
    item = cls(**{row: value})
    assert getattr(item, row) == value
    owner = next(each for each in KINDS if cls.__name__.startswith(each))
    with pytest.raises((ValueError, IndexError), match=f"'{row}': received '{name[:-1]}x'"):
        getattr(mbs, f"Add{owner}")(cls(**{row: [name[:-1] + "x"] * length if is_list else name[:-1] + "x"}))
    added = getattr(mbs, f"Add{owner}")(item)
    found = getattr(mbs, f"Get{owner}Parameter")(added, row)
    assert found == ([index(mbs, kind, name)] * length if is_list else index(mbs, kind, name))


def test_there_are_items_to_try() -> None:
    assert len(ROWS) >= 100


# ---- functions -------------------------------------------------------------------------------------------------------

TAKEN = re.compile(r"(node|object|marker|load|sensor)Number: object")
OTHERS: dict[str, Any] = {
    "parameterName": "name",
    "value": "renamed",
    "variableType": POSITION,
    "meshNodeNumber": 0,
    **{f"{kind.lower()}Dict": {"name": "renamed"} for kind in KINDS},
}


def compiled() -> Iterator[Any]:
    """Methods of the compiled classes whose signature has the index of an item."""
    for cls in (exu.MainSystem, exu.SystemData):
        for name, method in vars(cls).items():
            signature = (getattr(method, "__doc__", None) or "").splitlines()[:1]
            if signature and (match := TAKEN.search(signature[0])):
                others = re.findall(r"(\w+): [^=,]+(?=[,)])", signature[0].split(match[0], 1)[1].partition(" ->")[0])
                yield pytest.param(cls.__name__, name, match[1].capitalize(), others, id=f"{cls.__name__}.{name}")


def outcome(make: Callable[[], Any], call: Callable[[Any, Any], Any], kind: str, item: str, by_index: bool) -> str:
    """Return results and effects of a call, or its error; errors of misspelt names are raised."""
    mbs = make()
    given = index(mbs, kind, item) if by_index else item
    try:
        returned = call(mbs, given)
    except Exception as error:
        if "id you mean" in str(error):
            raise
        return str(error)
    return state(mbs, returned)


def check(make: Callable[[], Any], call: Callable[[Any, Any], Any], kind: str, name: str) -> None:
    assert outcome(make, call, kind, name, False) == outcome(make, call, kind, name, True)
    with pytest.raises((ValueError, IndexError, OSError), match=rf"'{name}s'.*[Dd]id you mean '{name}'"):
        outcome(make, call, kind, name + "s", False)


@pytest.mark.parametrize(("owner", "method", "kind", "others"), list(compiled()))
def test_methods_take_names(owner: str, method: str, kind: str, others: list[str]) -> None:
    def call(mbs: Any, item: Any) -> Any:
        return getattr(mbs if owner == "MainSystem" else mbs.systemData, method)(item, *map(OTHERS.get, others))

    check(solved, call, kind, NAMES[kind])


CUBE = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
BEARING = machines.GetBallBearingData([0, 0, 1], 0.1, 0.05, 0.02, 5)


def hand(mbs: Any) -> Any:
    return index(mbs, "Object", "hand")


def line(function: Callable[..., Any], cable: Any, name: str, start: float) -> Callable[[Any, Any], Any]:
    def call(mbs: Any, item: Any) -> Any:
        return function(mbs, [start, 0, 0], [start + 1, 0, 0], 2, cable(**CABLE), **{name: item})

    return call


def arc(name: str) -> Callable[[Any, Any], Any]:
    generate, cable = beams.GenerateCircularArcANCFCable2D, exu.ObjectANCFCable2D
    return lambda mbs, item: generate(mbs, [2, 0, 0], 1, 0, 1, 2, cable(**CABLE), **{name: item})


def robot(mbs: Any, item: Any) -> Any:
    arm = Robot(gravity=[0, 0, -9.81])
    arm.AddLink(RobotLink(1.0, [0.5, 0, 0], np.eye(3)))
    return arm.CreateRedundantCoordinateMBS(mbs, item)


def vehicle(mbs: Any, item: Any) -> Any:
    pose = HTtranslate([0, 0, 0.1])
    wheels = {"Type": 0, "Base": 0.4, "Track": 0.4, "Radius": 0.1, "Width": 0.05, "Mass": 2.0, "Numbers": 4}
    wheels |= {"ContactStiffness": 5e4, "ContactDamping": 5e2}
    body = {"Dimensions": [0.5, 0.7, 0.2], "Mass": 40.0, "InitialPose": pose, "Representation": "box"}
    body |= {name: [0, 0, 0] for name in ("InitialOmega", "InitialVelocity", "COM")}
    data = {f"wheel{name}": value for name, value in wheels.items()}
    data |= {f"platform{name}": value for name, value in body.items()}
    data |= {"gravity": [0, 0, -9.81], "friction": [1, 0, 0], "frictionAngle": 0.8, "viscousFrictionWheel": [0, 0]}
    data |= {"proportionalZone": 0.005, "serialRobotMountpoint": pose, "debugOffset": 0}
    return mobile.MobileRobot2MBS(mbs, data, item)


def contact(add: str, **values: Any) -> Callable[[Any, Any], Any]:
    def call(mbs: Any, item: Any) -> Any:
        made = mbs.AddGeneralContact()
        made.SetFrictionPairings(np.eye(1))
        values_ = {"contactStiffness": 1, "contactDamping": 0, "frictionMaterialIndex": 0, **values}
        return getattr(made, add)(item, **values_)

    return call


def seen_by_rays(mbs: Any) -> int:
    mbs.AddGeneralContact()
    return int(mbs.NumberOfGeneralContacts()) - 1


# Listed by function and parameter: the kind of item, and a call with it.
CASES: dict[str, tuple[str, Callable[[Any, Any], Any]]] = {
    **{
        f"{name}.body{i}": (
            "Object",
            lambda mbs, item, name=name, i=i: getattr(rigidBodyUtilities, name)(
                mbs, *([item, hand(mbs)] if i == 0 else [hand(mbs), item]), [1, 0, 0], [0, 0, 1]
            ),
        )
        for name in ("AddRevoluteJoint", "AddPrismaticJoint")
        for i in range(2)
    },
    "AddNodeConstraints.nodeNumber": ("Node", lambda mbs, item: shells.AddNodeConstraints(mbs, item, [0, 2])),
    "AddSphericalJointToGround.nodeNumber": ("Node", lambda mbs, item: shells.AddSphericalJointToGround(mbs, item)),
    "AddClampToGround.nodeNumber": (
        "Node",
        lambda mbs, item: shells.AddClampToGround(mbs, item, [1, 1, 0, 0, 0, 0, 0, 0, 0]),
    ),
    "GetOtherMarker.bodyNumber": ("Object", lambda mbs, item: utilities.GetOtherMarker(mbs, item, "floor")),
    "GetOtherMarker.existingMarker": ("Marker", lambda mbs, item: utilities.GetOtherMarker(mbs, "hand", item)),
    "GetJointArgs.markerNumber0": (
        "Marker",
        lambda mbs, item: utilities.GetJointArgs(mbs, markerNumber0=item, bodyNumber1="hand"),
    ),
    "GetJointArgs.markerNumber1": (
        "Marker",
        lambda mbs, item: utilities.GetJointArgs(mbs, markerNumber1=item, bodyNumber0="hand"),
    ),
    "GetJointArgs.bodyNumber0": (
        "Object",
        lambda mbs, item: utilities.GetJointArgs(mbs, markerNumber1="floor", bodyNumber0=item),
    ),
    "GetJointArgs.bodyNumber1": (
        "Object",
        lambda mbs, item: utilities.GetJointArgs(mbs, markerNumber0="floor", bodyNumber1=item),
    ),
    "ShowOnlyObjects.objectNumbers": ("Object", lambda mbs, item: utilities.ShowOnlyObjects(mbs, [item])),
    "HighlightItem.itemNumber": (
        "Object",
        lambda mbs, item: (
            utilities.HighlightItem(mbs.GetSystemContainer(), mbs, item),
            mbs.GetSystemContainer().visualizationSettings.interactive.highlightItemIndex,
        )[1],
    ),
    "AddSensorRecorder.sensorNumber": ("Sensor", lambda mbs, item: utilities.AddSensorRecorder(mbs, item, 1, 0.1)),
    **{
        f"{function.__name__}.{name}": ("Node", line(function, cable, name, start))
        for function, cable, names in (
            (beams.GenerateStraightBeam, exu.ObjectANCFCable2D, "nodeNumber0 nodeNumber1"),
            (beams.GenerateStraightLineANCFCable2D, exu.ObjectANCFCable2D, "nodeNumber0 nodeNumber1"),
            (beams.GenerateStraightLineANCFCable, exu.ObjectANCFCable, "nodeNumber0 nodeNumber1"),
            (beams.GenerateBeamElementsAlongLine, exu.ObjectANCFCable2D, "nodeNumberStart nodeNumberEnd"),
        )
        for name, start in zip(names.split(), (2, 1), strict=True)
    },
    "GenerateCircularArcANCFCable2D.nodeNumber0": ("Node", arc("nodeNumber0")),
    "GenerateCircularArcANCFCable2D.nodeNumber1": ("Node", arc("nodeNumber1")),
    "GenerateSlidingJoint.cableObjectList": (
        "Object:cable",
        lambda mbs, item: beams.GenerateSlidingJoint(mbs, [item], "hook"),
    ),
    "GenerateSlidingJoint.markerBodyPositionOfSlidingBody": (
        "Marker",
        lambda mbs, item: beams.GenerateSlidingJoint(mbs, ["cable"], item),
    ),
    "GenerateAleSlidingJoint.cableObjectList": (
        "Object:cable",
        lambda mbs, item: beams.GenerateAleSlidingJoint(mbs, [item], "hook", "foot"),
    ),
    "GenerateAleSlidingJoint.markerBodyPositionOfSlidingBody": (
        "Marker",
        lambda mbs, item: beams.GenerateAleSlidingJoint(mbs, ["cable"], item, "foot"),
    ),
    "GenerateAleSlidingJoint.AleNode": (
        "Node",
        lambda mbs, item: beams.GenerateAleSlidingJoint(mbs, ["cable"], "hook", item),
    ),
    "AnimateModes.nodeNumber": (
        "Node",
        lambda mbs, item: interactive.AnimateModes(mbs.GetSystemContainer(), mbs, item),
    ),
    "CreateBallBearing.markerInnerRing": (
        "Marker",
        lambda mbs, item: machines.CreateBallBearing(mbs, BEARING, item, "floor", 7800, 7800),
    ),
    "CreateBallBearing.markerOuterRing": (
        "Marker",
        lambda mbs, item: machines.CreateBallBearing(mbs, BEARING, "floor", item, 7800, 7800),
    ),
    "PlotSensor.sensorNumbers": ("Sensor", lambda mbs, item: mbs.PlotSensor([item])),
    "DataArrayFromSensorList.sensorNumbers": (
        "Sensor",
        lambda mbs, item: plot.DataArrayFromSensorList(mbs, [item]),
    ),
    "PlotPhase.sensorX": ("Sensor", lambda mbs, item: plot.PlotPhase(mbs, item, "way", 0, 1)),
    "PlotPhase.sensorY": ("Sensor", lambda mbs, item: plot.PlotPhase(mbs, "way", item, 0, 1)),
    "PlotSensorFFT.sensor": ("Sensor", lambda mbs, item: plot.PlotSensorFFT(mbs, item)),
    "SensorsToPandas.sensors": ("Sensor", lambda mbs, item: results.SensorsToPandas(mbs, [item]).to_numpy()),
    "SensorsToXarray.sensors": ("Sensor", lambda mbs, item: str(results.SensorsToXarray(mbs, [item]))),
    "SaveHDF5.sensors": ("Sensor", lambda mbs, item: results.SaveHDF5(mbs, "results.h5", sensors=[item])),
    "SolveVariations.sensors": (
        "Sensor",
        lambda mbs, item: mbs.SolveVariations({("arm", "physicsMass"): [1.0, 2.0]}, sensors=[item]).SensorValues(item),
    ),
    "SensorValues.sensor": (
        "Sensor",
        lambda mbs, item: mbs.SolveVariations({("arm", "physicsMass"): [1.0]}, sensors=["way"]).SensorValues(item),
    ),
    "ComputeConsistentInitialConditions.fixedNodes": (
        "Node",
        lambda mbs, item: mbs.ComputeConsistentInitialConditions(fixedNodes=[item]),
    ),
    "CreateDistanceSensorGeometry.rigidBodyMarkerIndex": (
        "Marker",
        lambda mbs, item: mbs.CreateDistanceSensorGeometry(CUBE, [[0, 1, 2]], item),
    ),
    "CreateDistanceSensor.positionOrMarker": (
        "Marker",
        lambda mbs, item: mbs.CreateDistanceSensor(seen_by_rays(mbs), item, [1, 0, 0]),
    ),
    "AddLidar.positionOrMarker": (
        "Marker",
        lambda mbs, item: robots.AddLidar(mbs, seen_by_rays(mbs), item, numberOfSensors=3),
    ),
    "CreateRedundantCoordinateMBS.baseMarker": ("Marker", robot),
    "CreateRobot.baseMarker": ("Marker", lambda mbs, item: mbs.CreateRobot(ARM, baseMarker=item, graphics=False)),
    "MobileRobot2MBS.markerGround": ("Marker", vehicle),
    "CMSObjectComputeNorm.objectNumber": (
        "Object",
        lambda mbs, item: FEM.CMSObjectComputeNorm(mbs, item, exu.OutputVariableType.Displacement),
    ),
    "Draw.around": ("Object", lambda mbs, item: np.asarray(mbs.Draw(around=item, windowSize=[40, 30])).sum()),
    "JointPreCheckCalcBodyMarkers.bodyNumbers": (
        "Object",
        lambda mbs, item: _interface.JointPreCheckCalcBodyMarkers(
            "Create", mbs, "", [item, "base"], [0, 0, 0], True, True
        ),
    ),
    "GetMarkersPosRot.internBodyNodeMarkerList": (
        "Marker",
        lambda mbs, item: _interface.GetMarkersPosRot(mbs, "", [item, "base"], [0] * 3, [0] * 3, True, True),
    ),
    "LoadPotentialEnergy.loadNumber": ("Load", LoadPotentialEnergy),
    "CreateLoadEnergySensor.loadNumber": ("Load", CreateLoadEnergySensor),
    "AddSphereWithMarker.markerIndex": ("Marker", contact("AddSphereWithMarker", radius=1)),
    "AddTrianglesRigidBodyBased.rigidBodyMarkerIndex": (
        "Marker",
        contact("AddTrianglesRigidBodyBased", pointList=CUBE, triangleList=[[0, 1, 2]]),
    ),
    "AddANCFCable.objectIndex": ("Object:cable", contact("AddANCFCable", halfHeight=0.1)),
}


@pytest.mark.parametrize("where", CASES)
@pytest.mark.filterwarnings("ignore::DeprecationWarning")
def test_functions_take_names(where: str, tmp_path: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    kind, _, name = CASES[where][0].partition(":")
    check(solved, CASES[where][1], kind, name or NAMES[kind])


PAIRS = [
    (name, parameter)
    for name, function in create.functions.items()
    for parameter in inspect.signature(function).parameters
    if parameter in REFERENCES
]


@pytest.mark.parametrize(("name", "parameter"), PAIRS)
def test_create_functions_take_names(name: str, parameter: str) -> None:
    mbs = system()
    given = "arms" if parameter == "bodyNumber" else ["base", "arms"]
    with pytest.raises(ValueError, match=rf"{name}.*'{parameter}.*received 'arms'.*Did you mean 'arm'"):
        getattr(mbs, name)(**{parameter: given})


# Functions that the system calls with numbers, or that count.
OTHER = {
    *("UFsensorRecord.sensorNumbers", "UFvonMisesStress.sensorNumbers"),
    *("GetMarkersPosRot.useRigidMarker", "ProcessBodyNodeMarkerLists.bodyNumbers"),  # the latter has no system to ask
    *("c_signature.item", "ctypes_signature.item", "numba_signature.item"),  # names of types
}
LIKE_AN_INDEX = re.compile(
    r"(body|object|node|marker|load|sensor|item)(Numbers?\d?|s|\d|X|Y)?|nodeNumber(Start|End)|.+Marker(Index)?|marker(Number.*|.*Ring|Ground)|.*OrMarker"
    r"|AleNode|fixedNodes|cableObjectList|around"
)


def test_no_function_is_left_out() -> None:
    modules = [import_module(f"dalembert.{name}") for name in exu._submodules if name not in ("FEM", "graphics")]
    functions = [getattr(m, name) for m in (*modules, mobile, robots) for name in getattr(m, "__all__", dir(m))]
    functions += [f for name, f in mainSystemExtensions.methods.items() if name not in create.functions]
    functions += [f for cls in (Robot, exu.MainSystem) for f in vars(cls).values() if inspect.isfunction(f)]
    taken = {
        f"{f.__name__}.{parameter}"
        for f in filter(inspect.isfunction, functions)
        if f.__module__.startswith("dalembert")
        and not f.__name__.startswith("_")
        and f.__name__ not in create.functions
        for parameter in inspect.signature(f).parameters
        if LIKE_AN_INDEX.fullmatch(parameter)
    }
    assert sorted(taken - set(CASES) - OTHER) == []
