"""Mistakes of somebody's first models: each error has the item or function, the parameter, and the remedy."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
import pytest

import dalembert as exu
from dalembert import FEM, beams, graphics, processing
from dalembert.itemInterface import (
    LoadForceVector,
    MarkerBodyPosition,
    MarkerBodyRigid,
    MassPoint,
    NodePoint,
    RigidBody,
    SensorBody,
    SphericalJoint,
    SpringDamper,
    Torque,
    VSpringDamper,
)
from dalembert.results import SensorsToPandas
from dalembert.rigidBodyUtilities import (
    InertiaCuboid,
    InertiaMassPoint,
    InertiaRodX,
    InertiaSphere,
    RigidBodyInertia,
    RotationMatrixX,
)
from dalembert.robotics import Robot
from dalembert.robotics.utilities import GetURDFrobotData
from dalembert.utilities import TreeLink

BAR = InertiaCuboid(1000, [1, 0.1, 0.1])
Variable = exu.OutputVariableType


class Model:
    """Ground, a bar and a point mass, with a sensor that stores nothing."""

    def __init__(self) -> None:
        self.SC = exu.SystemContainer()
        self.mbs: Any = self.SC.AddSystem()
        self.ground = self.mbs.CreateGround("ground")
        self.bar = self.mbs.CreateRigidBody("bar", [0.5, 0, 0], inertia=BAR, gravity=[0, -9.81, 0])
        self.mass = self.mbs.CreateMassPoint("mass", [1, 0, 0], physicsMass=1)
        self.mbs.AddSensor(SensorBody(name="way", bodyNumber="bar", outputVariableType=Variable.Position))

    def solve(self, **settings: Any) -> None:
        self.mbs.Assemble()
        given = exu.SimulationSettings()
        for name, value in settings.items():
            setattr(given.timeIntegration, name, value)
        self.mbs.SolveDynamic(given)

    def with_force(self, function: Any) -> None:
        self.mbs.CreateForce("push", "mass", [1, 0, 0], loadVectorUserFunction=function)
        self.solve()

    def measured(self, sensor: Any) -> None:
        self.mbs.AddSensor(sensor)
        self.mbs.Assemble()

    def load_on_position_marker(self) -> None:
        marker = self.mbs.AddMarker(MarkerBodyPosition(name="end", bodyNumber="bar"))
        self.mbs.AddLoad(Torque(name="twist", markerNumber=marker, loadVector=[0, 0, 1]))
        self.mbs.Assemble()

    def table_sensor(self) -> None:
        self.mbs.AddSensor(
            SensorBody(name="s", bodyNumber="bar", outputVariableType=Variable.Position, storeInternal=True)
        )

    def table(self) -> Any:
        self.table_sensor()
        self.mbs.Assemble()
        return SensorsToPandas(self.mbs, ["s"])

    def varied(self, masses: Any = (1, 2), **options: Any) -> Any:
        self.mbs.Assemble()
        return self.mbs.SolveVariations({("mass", "physicsMass"): masses}, **options)

    def plotted(self, **options: Any) -> None:
        self.table_sensor()
        self.solve()
        self.mbs.PlotSensor("s", **options)

    def use_after_reset(self) -> None:
        self.mbs.Reset()
        self.mbs.CreateForce("push", self.mass, [1, 0, 0])
        self.mbs.Assemble()

    def joint_of_one_marker(self) -> None:
        marker = self.mbs.AddMarker(MarkerBodyRigid(bodyNumber="bar"))
        self.mbs.AddObject(SphericalJoint(name="joint", markerNumbers=[marker, marker]))
        self.mbs.Assemble()

    def cable_on_one_node(self) -> None:
        node = self.mbs.AddNode(exu.NodePoint2DSlope1(name="end", referenceCoordinates=[0, 0, 1, 0]))
        self.mbs.AddObject(exu.ObjectANCFCable2D(name="cable", physicsLength=1, nodeNumbers=[node, node]))
        self.mbs.Assemble()

    def coordinate_load(self) -> None:
        marker = self.mbs.AddMarker(MarkerBodyRigid(bodyNumber="bar"))
        self.mbs.AddLoad(exu.LoadCoordinate(name="pull", markerNumber=marker, load=1))
        self.mbs.Assemble()

    def sphere_of_no_material(self) -> None:
        marker = self.mbs.AddMarker(MarkerBodyRigid(bodyNumber="bar"))
        self.mbs.AddGeneralContact().AddSphereWithMarker(marker, 1, 1, 1, 0)
        self.mbs.Assemble()

    def still_robot(self) -> None:
        with TemporaryDirectory() as folder:
            file = Path(folder) / "block.urdf"
            file.write_text('<robot name="block"><link name="base"/></robot>')
            self.mbs.CreateRobot(file)

    def stored(self, component: Any) -> None:
        self.plotted(components=component)


def one_argument(t: float) -> list[float]:
    return [t, 0, 0]


MISTAKES: list[tuple[str, Callable[[Model], Any], list[str]]] = [
    ("gravity is a number", lambda m: m.mbs.CreateMassPoint(physicsMass=1, gravity=-9.81), ["CreateMassPoint", "'gravity'", "3 finite components", "-9.81"]),
    ("angles for a matrix", lambda m: m.mbs.CreateRigidBody(inertia=BAR, initialRotationMatrix=[0, 0, 90]), ["'initialRotationMatrix'", "3x3 rotation matrix", "[0, 0, 90]"]),
    ("mass for inertia", lambda m: m.mbs.CreateRigidBody(inertia=5), ["'inertia'", "InertiaCuboid(...)", "5 (int)"]),
    ("spring to one body", lambda m: m.mbs.CreateSpringDamper(bodyNumbers=["bar"]), ["'bodyNumbers'", "list of 2"]),
    ("negative stiffness", lambda m: m.mbs.CreateSpringDamper(bodyNumbers=["ground", "bar"], stiffness=-9), ["'stiffness'", "not negative", "-9"]),
    ("axis without length", lambda m: m.mbs.CreateRevoluteJoint(bodyNumbers=["ground", "bar"], axis=[0, 0, 0]), ["'axis'", "not zero"]),
    ("axis in the plane", lambda m: m.mbs.CreateRevoluteJoint(bodyNumbers=["ground", "bar"], axis=[0, 1]), ["'axis'", "3 finite components"]),
    ("arguments in another order", lambda m: m.mbs.CreateRevoluteJoint([m.ground, m.bar], "hinge"), ["'name'", "a string"]),
    ("hinge on a point", lambda m: (m.mbs.CreateRevoluteJoint("hinge", ["ground", "mass"], [0, 0, 0], [0, 0, 1]), m.mbs.Assemble()), ["'Marker1:hinge'", "MarkerBodyRigid", "ObjectMassPoint"]),
    ("body that is not there", lambda m: m.mbs.CreateSpringDamper(bodyNumbers=["ground", "barr"]), ["'barr'", "Did you mean 'bar'?"]),
    ("two of one name", lambda m: m.mbs.CreateGround("bar"), ["'name'", "'bar'", "belongs to object 1", "choose another one"]),
    ("force on a node", lambda m: m.mbs.CreateForce("push", exu.NodeIndex(0), [1, 0, 0]), ["'bodyNumber'", "an ObjectIndex or a MarkerIndex", "NodeIndex(0)"]),
    ("negative length", lambda m: m.mbs.CreateDistanceConstraint(bodyNumbers=["ground", "mass"], distance=-1), ["'distance'", "not negative", "-1"]),
    ("variable in quotes", lambda m: SensorBody(bodyNumber=m.bar, outputVariableType="Position"), ["'outputVariableType'", "without quotes"]),
    ("variable that a body has not", lambda m: m.measured(SensorBody(bodyNumber=m.mass, outputVariableType=Variable.Torque)), ["'outputVariableType'", "Torque", "'mass'", "Use one of Position"]),
    ("values that are not stored", lambda m: m.mbs.GetSensorStoredData(m.mbs.AddSensor(SensorBody(bodyNumber=m.mass, outputVariableType=Variable.Position))), ["(SensorBody)", "stored no values", "storeInternal=True"]),
    ("no system", lambda m: exu.SolveStatic(None), ["SolveStatic: mbs", "None", "SC.AddSystem()"]),
    ("attribute that is not there", lambda m: setattr(m.mbs, "systemdata", 3), ["'MainSystem'", "'systemdata'", "Did you mean 'systemData'?"]),
    ("color that is not there", lambda m: exu.graphics.color.lightgray, ["graphics.color", "'lightgray'", "Did you mean 'lightgrey'?"]),
    ("color of another list", lambda m: exu.graphics.color.purple, ["graphics.color", "'purple'", "known are: red"]),
    ("outputs before Assemble", lambda m: m.mbs.systemData.GetODE2Coordinates(), ["not assembled", "Call mbs.Assemble()"]),
    ("no steps", lambda m: m.solve(numberOfSteps=0), ["timeIntegration.numberOfSteps", "from 1"]),
    ("time goes back", lambda m: m.solve(endTime=-1), ["timeIntegration.endTime", "not negative"]),
    ("setting that is not there", lambda m: m.solve(tEnd=1), ["timeIntegration", "'tEnd'", "endTime"]),
    ("settings without parentheses", lambda m: m.mbs.SolveDynamic(exu.SimulationSettings), ["simulationSettings", "Put parentheses behind the class"]),
    ("end time for settings", lambda m: m.mbs.SolveDynamic(5), ["simulationSettings", "exu.SimulationSettings()", "5"]),
    ("solver in quotes", lambda m: m.mbs.SolveDynamic(exu.SimulationSettings(), solverType="RK44"), ["solverType", "'RK44'", "without quotes"]),
    ("statics of what is free", lambda m: (m.mbs.Assemble(), m.mbs.SolveStatic()), ["singular", "'Node:bar'", "what to try"]),
    ("point without mass", lambda m: (m.mbs.CreateMassPoint("light"), m.solve()), ["singular", "'Node:light'", "what to try"]),
    ("function of too few arguments", lambda m: m.with_force(one_argument), ["takes 1 positional argument but 3 were given", "'loadVectorUserFunction' of load 1 'push'"]),
    ("function that returns a number", lambda m: m.with_force(lambda mbs, t, load: 3), ["'loadVectorUserFunction' of load 1 'push'", "3 (int)", "3 numbers"]),
    ("function that returns nothing", lambda m: m.with_force(lambda mbs, t, load: None), ["load 1 'push'", "None", "3 numbers"]),
    ("function in quotes", lambda m: m.with_force("push"), ["'loadVectorUserFunction'", "'push' (str)", "Pass the function itself"]),
    ("marker of nothing", lambda m: (m.mbs.AddMarker(MarkerBodyRigid(name="end")), m.mbs.Assemble()), ["'end'", "'bodyNumber'", "invalid index -1", "Pass the index"]),
    ("torque on a position", lambda m: m.load_on_position_marker(), ["load 1 'twist'", "'markerNumber'", "'end'", "Orientation", "Use another type of marker"]),
    ("index from before", lambda m: m.use_after_reset(), ["'bodyNumber'", "expected an existing object", "Add the object first"]),
    ("plot of what is not stored", lambda m: (m.solve(), m.mbs.PlotSensor("way")), ["'way'", "storeInternal=True"]),
    ("fourth of three components", lambda m: m.stored(3), ["sensor 1", "components 0 to 2", "not 3"]),
    ("component by a letter", lambda m: m.stored("x"), ["components", "'x'", "0 for the first"]),
    ("color by its name", lambda m: graphics.Sphere(radius=1, color="red"), ["color", "'red'", "graphics.color.red"]),
    ("edge length for three", lambda m: graphics.Brick(size=1), ["Brick: size", "3 components", "1 (int)"]),
    ("graphics without list", lambda m: m.mbs.CreateGround(graphicsDataList=graphics.Sphere()), ["'graphicsDataList'", "list of graphics data"]),
    ("density below zero", lambda m: InertiaCuboid(-1000, [1, 1, 1]), ["density", "not negative", "-1000"]),
    ("arguments of inertia swapped", lambda m: InertiaCuboid([1, 1, 1], 1000), ["sideLengths", "3 components"]),
    ("text for a number", lambda m: m.mbs.SetObjectParameter("bar", "physicsMass", "heavy"), ["object 1 'bar' (ObjectRigidBody)", "'physicsMass'", "a number (unit kg)"]),
    ("function of a system", lambda m: exu.CreateGround(), ["'CreateGround'", "mbs.CreateGround(...)"]),
    ("all eigenvalues", lambda m: (m.mbs.Assemble(), m.mbs.ComputeODE2Eigenvalues(numberOfEigenvalues="all")), ["numberOfEigenvalues", "'all'", "0 for all"]),
    ("settings as arguments", lambda m: m.mbs.SolveDynamic(endTime=1), ["SolveDynamic", "'endTime'", "simulationSettings.timeIntegration.endTime"]),
    ("load steps as argument", lambda m: m.mbs.SolveStatic(numberOfLoadSteps=3), ["SolveStatic", "simulationSettings.staticSolver.numberOfLoadSteps"]),
    ("solver by another name", lambda m: m.mbs.SolveDynamic(solvertype=1), ["SolveDynamic", "'solvertype'", "Did you mean 'solverType'?"]),
    ("variable misspelt", lambda m: Variable.Postion, ["OutputVariableType", "'Postion'", "Did you mean 'Position'?"]),
    ("class misspelt", lambda m: exu.SimulationSetings(), ["'SimulationSetings'", "Did you mean 'SimulationSettings'?"]),
    ("method misspelt", lambda m: m.mbs.CreateMasPoint(), ["MainSystem", "'CreateMasPoint'", "Did you mean 'CreateMassPoint'?"]),
    ("system of a system", lambda m: m.mbs.AddSystem(), ["'AddSystem'", "a system container: SC.AddSystem"]),
    ("container assembled", lambda m: m.SC.Assemble(), ["'Assemble'", "a system: mbs.Assemble"]),
    ("data asked of the system", lambda m: m.mbs.GetODE2Coordinates(), ["'GetODE2Coordinates'", "mbs.systemData.GetODE2Coordinates"]),
    ("data misspelt", lambda m: m.mbs.systemData.GetODE2Coordinate(), ["SystemData", "Did you mean 'GetODE2Coordinates'?"]),
    ("radius as text", lambda m: InertiaSphere(mass=1, radius="0.1"), ["InertiaSphere: radius", "a finite number", "'0.1' (str)"]),
    ("mass as text", lambda m: InertiaMassPoint("1"), ["InertiaMassPoint: mass", "a finite number", "'1' (str)"]),
    ("mass in brackets", lambda m: InertiaRodX(mass=[1], length=1), ["InertiaRodX: mass", "a finite number", "[1] (list)"]),
    ("cylinder without axis", lambda m: graphics.Cylinder(vAxis=[0, 0, 0]), ["Cylinder: vAxis", "non-zero length"]),
    ("arrow without length", lambda m: graphics.Arrow([0, 0, 0], [0, 0, 0], 0.1), ["Arrow: vAxis", "non-zero length"]),
    ("sphere below zero", lambda m: graphics.Sphere(radius=-1), ["Sphere: radius", "not negative", "-1"]),
    ("side below zero", lambda m: graphics.Brick(size=[1, -1, 1]), ["Brick: size", "not negative", "[1, -1, 1]"]),
    ("outline of two points", lambda m: graphics.SolidExtrusion([[0, 0], [1, 0]], [[0, 1]], 1), ["SolidExtrusion: vertices", "at least 3 points"]),
    ("length as text", lambda m: graphics.Basis(length="a"), ["Basis: length", "a finite number", "'a' (str)"]),
    ("number as text", lambda m: graphics.Text(text=5), ["Text: text", "a string", "5 (int)"]),
    ("component for components", lambda m: m.mbs.PlotSensor("way", component=1), ["PlotSensor", "'component'", "Did you mean 'components'?"]),
    ("table of what is not solved", lambda m: m.table(), ["sensor 1 's'", "solve first"]),
    ("file for a solution", lambda m: (m.solve(), m.mbs.SolutionViewer("motion.txt")), ["SolutionViewer: solution", "LoadSolutionFile(fileName)", "'motion.txt'"]),
    ("link by its name", lambda m: Robot().AddLink("link"), ["Robot.AddLink", "'link'", "RobotLink(...)"]),
    ("several objectives", lambda m: processing.Minimize(lambda p: [1, 2], {"a": (0, 1)}, showProgress=False), ["Minimize: objectiveFunction", "[1, 2]", "a number"]),
    ("number for a function", lambda m: processing.ParameterVariation(3, {"a": (0, 1, 2)}), ["parameterFunction", "3", "a function"]),
    ("number for an objective", lambda m: processing.Minimize(3, {"a": (0, 1)}), ["Minimize: objectiveFunction", "3", "a function"]),
    ("point for an index", lambda m: MassPoint(nodeNumber=[0, 0, 0]), ["ObjectMassPoint", "'nodeNumber'", "NodeIndex"]),
    ("color up to 255", lambda m: graphics.Sphere(color=[255, 0, 0, 255]), ["color", "from 0 to 1", "Its red is 255", "Divide numbers from 0 to 255 by 255"]),
    ("color of an edge up to 255", lambda m: graphics.Brick(addEdges=True, edgeColor=[0, 0, 200, 1]), ["edgeColor", "Its blue is 200"]),
    ("colors of points up to 255", lambda m: graphics.FromPointsAndTrigs([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]], [[0, 0, 0, 1], [9, 0, 0, 1], [0, 0, 0, 1]]), ["color", "Its red is 9"]),
    ("color of a joint up to 255", lambda m: m.mbs.CreateSphericalJoint("ball", ["ground", "bar"], [0, 0, 0], color=[0, 255, 0, 1]), ["CreateSphericalJoint", "'color'", "from 0 to 1", "Its green is 255"]),
    ("color of an item up to 255", lambda m: VSpringDamper(color=[0, 0, 0, 100]), ["VObjectConnectorSpringDamper", "'Vcolor'", "from 0 to 1", "Its opacity is 100"]),
    ("color of a setting up to 255", lambda m: setattr(m.SC.visualizationSettings.nodes, "defaultColor", [128, 0, 0, 1]), ["nodes.defaultColor", "Its red is 128"]),
    ("color below zero", lambda m: graphics.Sphere(color=[0, -0.5, 0, 1]), ["color", "Its green is -0.5"]),
    ("force on a body number", lambda m: LoadForceVector(bodyNumber=1, loadVector=[1, 0, 0]), ["LoadForceVector", "'bodyNumber'", "acts on markers", "'markerNumber'", "AddMarker", "mbs.CreateForce"]),
    ("spring to body numbers", lambda m: SpringDamper(bodyNumbers=[0, 1], stiffness=1), ["ObjectConnectorSpringDamper", "'bodyNumbers'", "'markerNumbers'", "mbs.CreateSpringDamper"]),
    ("joint on a node number", lambda m: SphericalJoint(nodeNumber=1), ["ObjectJointSpherical", "'nodeNumber'", "'markerNumbers'", "AddMarker"]),
    ("markers of a Create function", lambda m: m.mbs.CreateSpringDamper(markerNumbers=[0, 1]), ["CreateSpringDamper", "'markerNumbers'", "Pass markers as 'bodyNumbers'"]),
    ("marker of a force", lambda m: m.mbs.CreateForce(markerNumber=0, loadVector=[1, 0, 0]), ["CreateForce", "'markerNumber'", "Pass markers as 'bodyNumber'"]),
    ("short name of an argument", lambda m: m.mbs.CreateSpringDamper(length=1), ["CreateSpringDamper", "'length'", "Did you mean 'referenceLength'?"]),
    ("short name of a parameter", lambda m: m.mbs.SetObjectParameter("bar", "center", 3), ["object 1 'bar'", "'center'", "Did you mean 'physicsCenterOfMass'?"]),
    ("drawing of another item", lambda m: MassPoint(nodeNumber=0, visualization=VSpringDamper(drawSize=3)), ["ObjectMassPoint", "'visualization'", "'drawSize'", "VObjectMassPoint(...)"]),
    ("torque on a mass point", lambda m: (m.mbs.CreateTorque("twist", "mass", [0, 0, 1]), m.mbs.Assemble()), ["MarkerBodyRigid", "ObjectMassPoint has no orientation", "mbs.CreateRigidBody"]),
    ("spring function of two arguments", lambda m: (m.mbs.CreateSpringDamper("spring", ["ground", "mass"], stiffness=1, springForceUserFunction=lambda u, v: u), m.solve()), ["2 positional arguments but 8", "'spring'", "called as springForceUserFunction(mbs, t, itemNumber, "]),
    ("plot before solving", lambda m: (m.table_sensor(), m.mbs.Assemble(), m.mbs.PlotSensor("s")), ["sensor 1", "no values yet", "solve first"]),
    ("picture without an ending", lambda m: m.mbs.Draw("picture"), ["'picture'", ".png, .jpg or .webp"]),
    ("film for a picture", lambda m: m.mbs.Draw("picture.mp5"), ["'picture.mp5'", ".png, .jpg or .webp"]),
    ("view by another name", lambda m: m.mbs.Draw("p.png", view="isometric"), ["view", "axonometric", "'isometric'"]),
    ("three by three inertia", lambda m: RigidBody(physicsInertia=np.eye(3), nodeNumber=0), ["ObjectRigidBody", "'physicsInertia'", "6 finite numbers", "(3, 3)"]),
    ("three moments of inertia", lambda m: RigidBody(physicsInertia=[1, 1, 1], nodeNumber=0), ["ObjectRigidBody", "'physicsInertia'", "length 3"]),
    ("same body twice", lambda m: m.mbs.CreateRevoluteJoint("hinge", ["bar", "bar"], [0, 0, 0], [0, 0, 1]), ["CreateRevoluteJoint", "'bodyNumbers'", "two different bodies"]),
    ("three axes for six", lambda m: m.mbs.CreateGenericJoint("joint", ["ground", "bar"], [0, 0, 0], constrainedAxes=[1, 1, 1]), ["'constrainedAxes'", "6 flags", "[1, 1, 1]"]),
    ("degrees for a matrix", lambda m: m.mbs.CreateRigidBody(inertia=BAR, referenceRotationMatrix=30), ["'referenceRotationMatrix'", "3x3 rotation matrix", "30"]),
    ("several bodies for one", lambda m: m.mbs.CreateForce("push", ["bar", "mass"], [1, 0, 0]), ["CreateForce", "'bodyNumber'", "an ObjectIndex"]),
    ("direction in words", lambda m: m.mbs.CreateForce("push", "bar", "down"), ["CreateForce", "'loadVector'", "3 finite components", "'down'"]),
    ("sensor without variable", lambda m: m.measured(SensorBody(name="s", bodyNumber="bar")), ["sensor 1 's'", "'outputVariableType'", "Use one of Position"]),
    ("body for a sensor", lambda m: (m.mbs.Assemble(), m.mbs.GetSensorValues("bar")), ["GetSensorValues", "'bar'", "the name of a sensor"]),
    ("object for a node", lambda m: (m.mbs.Assemble(), m.mbs.GetNodeOutput(m.bar, Variable.Position)), ["GetNodeOutput", "'nodeNumber'", "counts objects, not nodes"]),
    ("item without parentheses", lambda m: m.mbs.AddObject(RigidBody), ["AddObject", "Put parentheses behind the class"]),
    ("node for an object", lambda m: m.mbs.AddObject(NodePoint()), ["AddObject", "NodePoint is a node", "mbs.AddNode"]),
    ("half a step", lambda m: m.solve(numberOfSteps=10.5), ["timeIntegration.numberOfSteps", "10.5", "a whole number"]),
    ("time with its unit", lambda m: m.solve(endTime="1 s"), ["timeIntegration.endTime", "'1 s' (str)", "a number"]),
    ("variation of a name alone", lambda m: (m.mbs.Assemble(), m.mbs.SolveVariations({"mass": [1, 2]})), ["SolveVariations", "(item index, parameter name)", "'mass'"]),
    ("settings of no group", lambda m: setattr(exu.SimulationSettings(), "endTime", 2), ["SimulationSettings", "'endTime'", "timeIntegration.endTime"]),
    ("method of a class", lambda m: exu.SystemContainer.AddSystem(), ["SystemContainer.AddSystem(...)", "on their class", "SC = exu.SystemContainer()", "SC.AddSystem()"]),
    ("method of the class of systems", lambda m: exu.MainSystem.Assemble(), ["MainSystem.Assemble(...)", "mbs = SC.AddSystem()", "mbs.Assemble()"]),
    ("argument of Assemble", lambda m: m.mbs.Assemble(True), ["mbs.Assemble(...)", "no arguments, 1 was given", "Call mbs.Assemble()"]),
    ("argument that is missing", lambda m: m.mbs.GetNodeOutput(0), ["mbs.GetNodeOutput(...)", "'variableType' is missing", "configuration=None)"]),
    ("argument misspelt", lambda m: m.SC.GetSystem(sytemNumber=0), ["SC.GetSystem(...)", "'sytemNumber'", "Did you mean 'systemNumber'?"]),
    ("text for a number of a system", lambda m: m.SC.GetSystem("first"), ["SC.GetSystem(...)", "'systemNumber' must be an integer", "'first' (str)"]),
    ("text for digits", lambda m: setattr(exu.config, "outputPrecision", "many"), ["Config.outputPrecision", "'many' (str)", "an integer"]),
    ("switch misspelt", lambda m: setattr(exu.config, "precision", 3), ["'Config'", "'precision'", "Did you mean 'outputPrecision'?"]),
    ("true mass", lambda m: m.mbs.CreateMassPoint(physicsMass=True), ["ObjectMassPoint", "'physicsMass'", "True (bool)", "a number (unit kg)", "without a unit only"]),
    ("true in a vector", lambda m: NodePoint(referenceCoordinates=[True, 0, 0]), ["NodePoint", "'referenceCoordinates'", "3 finite numbers (unit m)", "without a unit only"]),
    ("true stiffness", lambda m: m.mbs.CreateSpringDamper(bodyNumbers=["ground", "bar"], stiffness=np.True_), ["CreateSpringDamper", "'stiffness'", "a finite number", "True"]),
    ("true end time", lambda m: m.solve(endTime=True), ["timeIntegration.endTime", "True (bool)", "without a unit only"]),
    ("spring from a point to itself", lambda m: m.mbs.CreateSpringDamper(bodyNumbers=["bar", "bar"], stiffness=9), ["CreateSpringDamper", "'bodyNumbers'", "two different points"]),
    ("vector in quotes", lambda m: m.mbs.CreateMassPoint(physicsMass=1, referencePosition="1,0,0"), ["CreateMassPoint", "'referencePosition'", "3 finite components", "'1,0,0' (str)"]),
    ("column for a vector", lambda m: m.mbs.CreateMassPoint(physicsMass=1, referencePosition=np.zeros((3, 1))), ["'referencePosition'", "3 finite components", "(3, 1)"]),
    ("complex mass", lambda m: m.mbs.CreateMassPoint(physicsMass=1j), ["CreateMassPoint", "'physicsMass'", "a finite number", "1j (complex)"]),
    ("infinite stiffness", lambda m: m.mbs.CreateSpringDamper(bodyNumbers=["ground", "bar"], stiffness=np.inf), ["CreateSpringDamper", "'stiffness'", "finite", "inf"]),
    ("disc without radius", lambda m: m.mbs.CreateRollingDisc("disc", ["ground", "bar"], axisPosition=[0, 0, 0]), ["CreateRollingDisc", "'discRadius'", "greater than zero"]),
    ("coordinate that a point has not", lambda m: m.mbs.CreateCoordinateConstraint("hold", ["ground", "mass"], coordinates=[0, 9]), ["'coordinates[1]'", "less than 3", "received 9"]),
    ("body in words", lambda m: m.mbs.CreateGround(graphicsDataList=["sphere"]), ["CreateGround", "'graphicsDataList'", "graphics.Sphere(", "['sphere']"]),
    ("shape that is not there", lambda m: graphics.Box(size=[1, 1, 1]), ["dalembert.graphics", "'Box'", "known are", "Brick"]),
    ("shape misspelt", lambda m: graphics.Sphre(radius=1), ["'Sphre'", "Did you mean 'Sphere'?"]),
    ("renderer misspelt", lambda m: m.SC.renderer.Strt(), ["'Renderer'", "'Strt'", "Did you mean 'Start'?"]),
    ("linear solver misspelt", lambda m: setattr(exu.SimulationSettings(), "linearSolverType", "EigenSparce"), ["linearSolverType", "Did you mean 'EigenSparse'?"]),
    ("linear solver by another word", lambda m: setattr(exu.SimulationSettings(), "linearSolverType", "sparse"), ["linearSolverType", "Did you mean 'EigenSparse'?"]),
    ("group of settings", lambda m: exu.SimulationSettings().newton, ["'newton'", "'staticSolver.newton' or 'timeIntegration.newton'"]),
    ("radius of the spectrum", lambda m: setattr(exu.SimulationSettings().timeIntegration.generalizedAlpha, "spectralRadius", 2), ["generalizedAlpha.spectralRadius", "from 0 to 1"]),
    ("number for settings", lambda m: (m.mbs.Assemble(), m.mbs.ComputeODE2Eigenvalues(5)), ["ComputeODE2Eigenvalues", "simulationSettings", "exu.SimulationSettings()"]),
    ("statics with an integrator", lambda m: m.mbs.SolveStatic(solverType=1), ["SolveStatic", "'solverType'", "known are", "updateInitialValues"]),
    ("degrees in quotes", lambda m: RotationMatrixX("90"), ["RotationMatrixX", "the angle in rad", "'90' (str)"]),
    ("moments below zero", lambda m: RigidBodyInertia(1, np.diag([-1, 1, 1])), ["inertiaTensor", "without negative principal moments"]),
    ("matrix that stretches", lambda m: m.mbs.CreateRigidBody(inertia=BAR, referenceRotationMatrix=2 * np.eye(3)), ["'referenceRotationMatrix'", "not orthogonal"]),
    ("Euler parameters of zero", lambda m: (m.mbs.AddNode(exu.NodeRigidBodyEP(name="n", referenceCoordinates=[0] * 7)), m.mbs.Assemble()), ["'n' (NodeRigidBodyEP)", "'referenceCoordinates'", "four Euler parameters"]),
    ("gear without module", lambda m: exu.machines.InvoluteGear(0, 12), ["InvoluteGear: module", "greater than zero"]),
    ("dictionary for a file", lambda m: m.mbs.Load({}), ["mbs.Load(...)", "the name of a file", "mbs.SetDictionary(...)"]),
    ("file of another kind", lambda m: m.mbs.SaveGLB("motion.obj"), ["SaveGLB", ".glb", "'motion.obj'"]),
    ("histories that are not kept", lambda m: m.varied().SensorHistory(0, "way"), ["SensorHistory", "storeHistories=True"]),
    ("variation that is not there", lambda m: m.varied(storeHistories=True).SensorHistory(7, "way"), ["SensorHistory", "less than 2", "7"]),
    ("negative variation", lambda m: m.varied([1, -2]), ["SolveVariations", "variation 1", "'mass'", "'physicsMass'", "not negative"]),
    ("variations of two lengths", lambda m: (m.mbs.Assemble(), m.mbs.SolveVariations({(m.mass, "physicsMass"): [1, 2], (m.bar, "physicsMass"): [1, 2, 3]})), ["SolveVariations", "one row per variation", ": 2", ": 3"]),
    ("color for a number of a color", lambda m: m.plotted(colorCodeOffset="red"), ["PlotSensor", "colorCodeOffset", "'red'", "colors=['red']"]),
    ("function without a name", lambda m: processing.ParameterVariation(lambda p: p["a"], {"a": (0, 1, 2)}, useMultiProcessing=True, showProgress=False), ["pickle", "evaluation 0", "define them with def in a file", "'threads'"]),
    ("sensor of another name", lambda m: (m.mbs.Assemble(), m.mbs.GetSensorValues("wy")), ["GetSensorValues", "'wy'", "Did you mean 'way'?"]),
    ("two sensors of one name", lambda m: m.measured(SensorBody(name="way", bodyNumber="mass", outputVariableType=Variable.Position)), ["'name'", "'way'", "belongs to sensor 0"]),
    ("version to come", lambda m: exu.RequireVersion("9.9"), ["9.9", "1.13.6"]),
    ("type of a joint in quotes", lambda m: m.mbs.CreateKinematicTree("t", [TreeLink(linkInertia=BAR, jointType="RevoluteZ")]), ["CreateKinematicTree", "'listOfTreeLinks[0].jointType'", "exu.JointType.RevoluteZ"]),
    ("range in quotes", lambda m: processing.ParameterVariation(lambda p: 0, {"a": ("0", "1", 3)}, showProgress=False), ["ParameterVariation: range of 'a'", "a finite number", "'0' (str)"]),
    ("method that scipy has not", lambda m: processing.Minimize(lambda p: p["a"], {"a": (0, 1)}, method="newton", showProgress=False), ["Minimize: method", "'newton'", "Did you mean 'newton-cg'?"]),
    ("reference in words", lambda m: processing.ComputeSensitivities(lambda p: 1, {"a": "large"}, showProgress=False), ["ComputeSensitivities: 'a'", "a finite number", "'large' (str)"]),
    ("systems for sensors", lambda m: m.mbs.PlotSensor([m.mbs, m.mbs], "way"), ["PlotSensor: sensorNumbers", "dalembert.plot.PlotSensor([mbs, other]"]),
    ("body of a mesh without modes", lambda m: FEM.ObjectFFRFreducedOrderInterface(FEM.FEMinterface()), ["femInterface", "ComputeEigenmodes(...)"]),
    ("cable without elements", lambda m: beams.GenerateStraightLineANCFCable2D(m.mbs, [0, 0, 0], [1, 0, 0], 0, exu.ObjectANCFCable2D()), ["numberOfElements", "a positive integer", "0 (int)"]),
    ("joint types for half of the tree", lambda m: (m.mbs.AddObject(exu.ObjectKinematicTree("tree", nodeNumber=m.mbs.AddNode(exu.NodeGenericODE2(numberOfODE2Coordinates=2, referenceCoordinates=[0, 0], initialCoordinates=[0, 0], initialCoordinates_t=[0, 0])), jointTypes=[exu.JointType.RevoluteZ], linkParents=[-1])), m.mbs.Assemble()), ["'tree' (ObjectKinematicTree)", "'jointTypes'", "length 1", "length 2"]),
    ("mass matrix of another size", lambda m: (m.mbs.AddObject(exu.ObjectGenericODE2("o", nodeNumbers=[m.mbs.AddNode(NodePoint())], massMatrix=np.eye(2))), m.mbs.Assemble()), ["'o' (ObjectGenericODE2)", "'massMatrix'", "2 x 2", "3 x 3"]),
    ("local position in the plane", lambda m: (m.mbs.Assemble(), m.mbs.GetObjectOutputBody("bar", Variable.Position, [0, 0])), ["GetObjectOutputBody", "'localPosition'", "3 finite numbers"]),
    ("configuration in quotes", lambda m: (m.mbs.Assemble(), m.mbs.GetNodeOutput(0, Variable.Position, "Initial")), ["'configuration'", "'Initial' (str)", "ConfigurationType.Current"]),
    ("coordinates of two", lambda m: (m.mbs.Assemble(), m.mbs.systemData.SetODE2Coordinates([0, 1])), ["SetODE2Coordinates", "10 finite numbers"]),
    ("changes in a list", lambda m: m.mbs.ModifyObject("bar", ["physicsMass", 3]), ["ModifyObject", "'objectDict'", "a dictionary"]),
    ("stiffness of a body", lambda m: m.mbs.SetObjectParameter("bar", "stiffness", 3), ["object 1 'bar'", "'stiffness'", "Known are: name, physicsMass"]),
    ("number for a group of settings", lambda m: setattr(exu.SimulationSettings().timeIntegration, "newton", 5), ["'timeIntegration.newton'", "5 (int)", "NewtonSettings or a dictionary"]),
    ("no threads", lambda m: setattr(exu.SimulationSettings().parallel, "numberOfThreads", 0), ["'parallel.numberOfThreads'", "greater than zero"]),
    ("settings misspelt in a dictionary", lambda m: exu.SimulationSettings().SetDictionary({"timeIntegration": {"endtime": 3}}), ["SimulationSettings.timeIntegration", "'endtime'", "Did you mean 'endTime'?"]),
    ("range of no values", lambda m: processing.ParameterVariation(lambda p: 0, {"a": (0, 1, 0)}), ["range of 'a'", "at least 1", "(0, 1, 0)"]),
    ("modes without matrices", lambda m: FEM.FEMinterface().ComputeEigenmodes(4), ["FEMinterface", "no mass matrix", "AssembleMatrices"]),
    ("modulus below zero", lambda m: FEM.KirchhoffMaterial(-1, 0.3, 1000), ["youngsModulus", "a positive number"]),
    ("ratio above a half", lambda m: FEM.KirchhoffMaterial(1e9, 0.7, 1000), ["poissonsRatio", "0.5", "0.7"]),
    ("spectrum of one value", lambda m: exu.signalProcessing.ComputeFFT([0], [1]), ["ComputeFFT: data", ">= 2"]),
    ("values in words", lambda m: m.varied(["a"]), ["SolveVariations", "'physicsMass'", "an array of numbers"]),
    ("name that nothing has in a study", lambda m: (m.mbs.Assemble(), processing.VariedModel(m.mbs, {"k": ("spring", "stiffness")}, lambda r, i: 0)), ["VariedModel: parameters['k']", "'spring'"]),
    ("step function that is none", lambda m: m.mbs.SetPreStepUserFunction(5), ["SetPreStepUserFunction", "5 (int)", "without calling it"]),
    ("step function without answer", lambda m: (m.mbs.SetPreStepUserFunction(lambda mbs, t: None), m.solve()), ["PreStepUserFunction", "None", "True to go on"]),
    ("axis in quotes", lambda m: m.mbs.CreatePrismaticJoint("slide", ["ground", "bar"], [0, 0, 0], "x"), ["CreatePrismaticJoint", "'axis'", "3 finite components", "'x' (str)"]),
    ("one radius for two spheres", lambda m: m.mbs.CreateSphereSphereContact("touch", ["ground", "mass"], spheresRadii=[1]), ["CreateSphereSphereContact", "'spheresRadii'", "2 finite components"]),
    ("picture around what is not there", lambda m: m.mbs.Draw(around="barr"), ["Draw: around", "'barr'", "Did you mean 'bar'?"]),
    ("one size of a picture", lambda m: m.mbs.Draw(windowSize=1024), ["windowSize", "width and height", "1024"]),
    ("spin as a number", lambda m: m.mbs.CreateRigidBody("bar2", inertia=BAR, initialAngularVelocity=5), ["CreateRigidBody", "'initialAngularVelocity'", "3 finite components"]),
    ("index beyond the last sensor", lambda m: m.mbs.GetSensorStoredData(9), ["GetSensorStoredData", "no sensor with number 9", "from 0 to 0"]),
    ("solution that is not there", lambda m: exu.utilities.LoadSolutionFile("nowhere.txt"), ["LoadSolutionFile: fileName", "there is no such file"]),
    ("link with a number for its inertia", lambda m: TreeLink(linkInertia=5), ["TreeLink: linkInertia", "InertiaCuboid(...)", "5 (int)"]),
    ("mass of a rigid body", lambda m: m.mbs.CreateRigidBody(mass=1), ["CreateRigidBody", "'mass'", "inertia=InertiaCuboid(...)"]),
    ("class for an inertia", lambda m: m.mbs.CreateRigidBody(inertia=InertiaCuboid), ["CreateRigidBody", "'inertia'", "InertiaCuboid(...)", "(type)"]),
    ("settings for what varies", lambda m: m.varied(settings=exu.SimulationSettings()), ["SolveVariations: settings", "{'timeIntegration.endTime': [1, 2]}", "simulationSettings"]),
    ("ending that matplotlib has not", lambda m: m.plotted(fileName="x.xyz"), ["PlotSensor: fileName", "png", "'x.xyz'"]),
    ("way in the plane", lambda m: graphics.Move(graphics.Sphere(), [0, 0]), ["Move: pOff", "3 components", "[0, 0]"]),
    ("page of a file", lambda m: (m.mbs.Assemble(), m.mbs.SaveHTML("x.html", solution="a.txt")), ["SaveHTML: solution", "LoadSolutionFile(fileName)", "'a.txt'"]),
    ("state of a file", lambda m: exu.utilities.SetSolutionState(m.mbs, "a.txt", 0), ["SetSolutionState: solution", "LoadSolutionFile(fileName)", "'a.txt'"]),
    ("sensors without a system", lambda m: SensorsToPandas(["way"]), ["SensorsToPandas: mbs", "SC.AddSystem()", "['way']"]),
    ("sensor that stores nothing", lambda m: (m.solve(), SensorsToPandas(m.mbs, "way")), ["SensorsToPandas", "'way'", "storeInternal=True"]),
    ("angle for three", lambda m: exu.rigidBodyUtilities.RotXYZ2RotationMatrix(90), ["RotXYZ2RotationMatrix: rot", "3 components", "90 (int)"]),
    ("way for three", lambda m: exu.rigidBodyUtilities.HTtranslate(3), ["HTtranslate: r", "3 components", "3 (int)"]),
    ("gravity of a system", lambda m: setattr(m.mbs, "gravity", [0, 0, -9.81]), ["'MainSystem'", "'gravity'", "mbs.CreateRigidBody(...)"]),
    ("time of a system", lambda m: m.mbs.time, ["'MainSystem'", "'time'", "mbs.systemData.GetTime()"]),
    ("step of a system", lambda m: m.mbs.step(), ["'MainSystem'", "'step'", "mbs.SolveDynamic(simulationSettings)"]),
    ("law that is a function", lambda m: exu.control.SampledController(lambda t: 0, period=1), ["SampledController: law", "CompiledController(...)"]),
    ("study without a function", lambda m: processing.ParameterVariation({"a": (0, 1, 5)}, lambda p: 0), ["ParameterVariation: parameterFunction", "a function of a dictionary"]),
    ("argument of a study misspelt", lambda m: processing.ParameterVariation(lambda p: 0, {"a": [1]}, useMultiprocessing=True), ["'useMultiprocessing'", "Did you mean 'useMultiProcessing'"]),
    ("marker between itself", lambda m: m.joint_of_one_marker(), ["object 3 'joint'", "'markerNumbers'", "twice", "two different markers"]),
    ("coordinate load on a body", lambda m: m.coordinate_load(), ["load 1 'pull'", "'markerNumber'", "provides Coordinate", "Use another type of marker"]),
    ("orientation of a point", lambda m: (m.mbs.AddMarker(MarkerBodyRigid(name="end", bodyNumber="mass")), m.mbs.Assemble()), ["'end'", "no orientation", "mbs.CreateRigidBody(...)"]),
    ("sensor of a node of a body", lambda m: m.measured(exu.SensorNode(name="s", nodeNumber="bar", outputVariableType=Variable.Position)), ["sensor 1 's'", "'nodeNumber'", "'bar'", "Node:bar"]),
    ("group for the settings", lambda m: (m.mbs.Assemble(), m.mbs.SolveDynamic(exu.SimulationSettings().timeIntegration)), ["SolveDynamic: simulationSettings", "exu.SimulationSettings()"]),
    ("system behind its settings", lambda m: exu.SolveDynamic(exu.SimulationSettings(), m.mbs), ["SolveDynamic: simulationSettings", "MainSystem"]),
    ("value of a dictionary", lambda m: m.mbs.SetObjectParameter("bar", {"physicsMass": 3}), ["SetObjectParameter", "'value' is missing", "objectNumber, parameterName, value"]),
    ("link for a list of links", lambda m: m.mbs.CreateKinematicTree(listOfTreeLinks=TreeLink(linkInertia=BAR)), ["CreateKinematicTree", "'listOfTreeLinks'", "a list of TreeLink"]),
    ("stiffness for three", lambda m: m.mbs.CreateCartesianSpringDamper("s", ["ground", "bar"], stiffness=100), ["CreateCartesianSpringDamper", "'stiffness'", "3 finite components", "100"]),
    ("diagonal of a matrix", lambda m: m.mbs.CreateRigidBodySpringDamper("s", ["ground", "bar"], stiffness=[1] * 6), ["CreateRigidBodySpringDamper", "'stiffness'", "a 6x6 matrix"]),
    ("length of a spring", lambda m: m.mbs.CreateSpringDamper("s", ["ground", "bar"], stiffness=1, length=2), ["CreateSpringDamper", "'length'", "Did you mean 'referenceLength'?"]),
    ("list of markers", lambda m: m.mbs.AddMarker([MarkerBodyRigid(bodyNumber="bar")]), ["AddMarker", "list of length 1", "a marker item"]),
    ("friction of one material", lambda m: m.mbs.AddGeneralContact().SetFrictionPairings([0.3]), ["SetFrictionPairings", "'frictionPairings'", "[0.3]", "a square matrix"]),
    ("body for a marker of contact", lambda m: m.mbs.AddGeneralContact().AddSphereWithMarker(m.bar, 1, 1, 1, 0), ["AddSphereWithMarker", "'markerNumber'", "counts objects, not markers"]),
    ("contact of no friction table", lambda m: m.sphere_of_no_material(), ["GeneralContact 0", "'frictionMaterialIndex'", "Call SetFrictionPairings(...)"]),
    ("end without end", lambda m: m.solve(endTime=np.inf), ["timeIntegration.endTime", "inf", "a finite number"]),
    ("function that divides by zero", lambda m: m.with_force(lambda mbs, t, load: [1 / 0, 0, 0]), ["division by zero", "'loadVectorUserFunction' of load 1 'push'", "time 0"]),
    ("type of a node in quotes", lambda m: m.mbs.CreateRigidBody(inertia=BAR, nodeType="RotationRxyz"), ["CreateRigidBody", "'nodeType'", "NodeType.RotationRxyz", "(str)"]),
    ("point for a rigid body", lambda m: (m.mbs.AddObject(RigidBody(name="r", nodeNumber="Node:mass")), m.mbs.Assemble()), ["object 3 'r'", "'nodeNumber'", "'Node:mass'", "provides Position, Orientation"]),
    ("axis of quoted numbers", lambda m: m.mbs.CreateRevoluteJoint("hinge", ["ground", "bar"], axis=["0", "0", "1"]), ["CreateRevoluteJoint", "'axis'", "3 finite components", "['0', '0', '1']"]),
    ("gravity of quoted numbers", lambda m: m.mbs.CreateMassPoint(physicsMass=1, gravity=[0, 0, "-9.81"]), ["CreateMassPoint", "'gravity'", "3 finite components", "'-9.81'"]),
    ("rotation of quoted numbers", lambda m: m.mbs.CreateRigidBody("r", inertia=BAR, referenceRotationMatrix=[["1", 0, 0], [0, 1, 0], [0, 0, 1]]), ["CreateRigidBody", "'referenceRotationMatrix'", "a 3x3 rotation matrix"]),
    ("cable on one node", lambda m: m.cable_on_one_node(), ["object 3 'cable'", "'nodeNumbers'", "node 2 'end' (NodePoint2DSlope1) twice", "different nodes"]),
    ("cable between points of a plane", lambda m: beams.GenerateStraightLineANCFCable2D(m.mbs, [0, 0], [1, 0], 4, exu.ObjectANCFCable2D()), ["positionOfNode0", "3 components", "[0, 0]"]),
    ("output in quotes", lambda m: (m.mbs.Assemble(), m.mbs.GetNodeOutput(0, "Position")), ["GetNodeOutput", "'variableType'", "Write OutputVariableType.Position without quotes"]),
    ("search of a function that returns nothing", lambda m: processing.Minimize(lambda p: None, {"a": (0, 1)}, showProgress=False), ["Minimize: objectiveFunction returned None", "a number"]),
    ("generations of a function that returns nothing", lambda m: processing.GeneticOptimization(lambda p: None, {"a": (0, 1)}, showProgress=False), ["GeneticOptimization: result of objectiveFunction", "a number", "None"]),
    ("file for a robot", lambda m: GetURDFrobotData("arm.urdf"), ["GetURDFrobotData: robot", "LoadURDFrobot(...)['robot']", "'arm.urdf'"]),
    ("view in words", lambda m: m.mbs.Draw(view="from above"), ["Draw: view", "top", "'from above'"]),
    ("width alone", lambda m: m.mbs.Draw(windowSize=400), ["Draw: windowSize", "width and height in pixels", "400"]),
    ("picture of no format", lambda m: m.mbs.Draw("bar.xyz"), ["Draw: fileName", ".png"]),
    ("frames of no format", lambda m: m.mbs.DrawSolution("frame%05d.gifs"), ["DrawSolution: fileName", ".png"]),
    ("size of steps", lambda m: setattr(exu.SimulationSettings().timeIntegration, "stepSize", 1e-3), ["timeIntegration has no parameter 'stepSize'", "numberOfSteps = int(round("]),
    ("side below zero", lambda m: InertiaCuboid(1000, [1, -1, 1]), ["InertiaCuboid: sideLengths", "not negative", "received -1.0 (float)"]),
    ("robot that cannot move", lambda m: m.still_robot(), ["CreateRobot", "'fileName'", "a joint that moves"]),
]  # fmt: skip


@pytest.mark.parametrize(("wrong", "words"), [each[1:] for each in MISTAKES], ids=[each[0] for each in MISTAKES])
def test_a_mistake_is_answered(wrong: Callable[[Model], Any], words: list[str]) -> None:
    with np.errstate(all="ignore"), pytest.raises(Exception) as caught:
        wrong(Model())
    told = "\n".join([str(caught.value), *getattr(caught.value, "__notes__", [])])
    missing = [word for word in words if word not in told]
    assert not missing, told


def test_a_minimum_of_nan_is_reported() -> None:
    with pytest.warns(UserWarning, match="objectiveFunction has returned no finite number"):
        processing.Minimize(lambda p: np.nan, {"a": (0, 1)}, showProgress=False, options={"maxiter": 2})


def test_truth_values_of_numbers_without_unit() -> None:
    """Models for Exudyn switch by them."""
    cable = exu.ObjectANCFCable2D(strainIsRelativeToReference=False)
    assert cable.strainIsRelativeToReference == 0
