# The multibody system: adding, reading and changing items, outputs, solving.

from collections.abc import Callable, Sequence
from typing import Any, Literal, overload

from numpy.typing import ArrayLike

from dalembert import interactive, plot, solver
from dalembert._core import SystemContainer
from dalembert._core_base import *
from dalembert._core_base import _Bound
from dalembert._core_enums import *
from dalembert._core_general_contact import GeneralContact
from dalembert._core_items import *
from dalembert._core_items import _Load, _Marker, _Node, _Object, _Sensor
from dalembert._core_settings import *
from dalembert._core_system_data import SystemData
from dalembert._core_types import Array, Matrix, MatrixLike, Vector
from dalembert._geometry.inertia import RigidBodyInertia
from dalembert._geometry.rigid_transformation import HT
from dalembert._io import model_files as model_files
from dalembert._pictures import draw as draw
from dalembert._pictures import glb as glb
from dalembert._pictures import html as html
from dalembert._pictures import shortcuts as shortcuts
from dalembert._pictures import vtu as vtu
from dalembert._plots import system_graph as system_graph
from dalembert._solving import buckling as buckling
from dalembert._solving import consistent as consistent
from dalembert._solving import energies as energies
from dalembert._solving import inspection as inspection
from dalembert._solving import item_computations as item_computations
from dalembert._solving import linearized as linearized
from dalembert._solving import report as report
from dalembert._solving import vibrations as vibrations
from dalembert._studies import exact_sensitivities as exact_sensitivities
from dalembert._studies import variations as variations
from dalembert.create import (
    bodies,
    connectors,
    contacts,
    drives,
    flexible,
    joints,
    lines,
    loads,
    robots,
    ropes,
    sensors,
    shapes,
    trees,
)

# Functions that solvers call. Step functions return whether to go on, PostNewton [error, recommended step size].
_StepFunction = Callable[[MainSystem, float], bool]
_PostNewtonFunction = Callable[[MainSystem, float], ArrayLike]
_PreNewtonResidualFunction = Callable[[MainSystem, float, int, int], Any]
# Values whose changes of sign are events, perhaps with a direction; what is done then, with number and direction.
_EventsFunction = Callable[[MainSystem, float], ArrayLike | Sequence[float | tuple[float, int]]]
_EventActionFunction = Callable[[MainSystem, float, int, int], bool]
# With the number of the object, or the name of a part of GeneralContact; what switches; 1: it begins, -1: it ends.
_ItemEventActionFunction = Callable[[MainSystem, float, int | str, str, int], bool]
_SystemJacobianFunction = Callable[[MainSystem, float, float, float, float], MatrixLike]

# The first argument of what is written in Python is called mbs.
class MainSystem(_Bound):
    def __init__(self) -> None: ...
    variables: dict[Any, Any]
    sys: dict[Any, Any]
    interactiveMode: bool
    solverSignalJacobianUpdate: bool
    systemIsConsistent: bool
    @property
    def systemData(self) -> SystemData: ...
    def SetPreStepUserFunction(self, value: _StepFunction | dict[str, Any] | Literal[0] | None) -> None: ...
    def GetPreStepUserFunction(self, asDict: bool = False) -> Any: ...
    def SetPostStepUserFunction(self, value: _StepFunction | dict[str, Any] | Literal[0] | None) -> None: ...
    def GetPostStepUserFunction(self, asDict: bool = False) -> Any: ...
    def SetPostNewtonUserFunction(self, value: _PostNewtonFunction | dict[str, Any] | Literal[0] | None) -> None: ...
    def GetPostNewtonUserFunction(self, asDict: bool = False) -> Any: ...
    def SetPreNewtonResidualUserFunction(
        self, value: _PreNewtonResidualFunction | dict[str, Any] | Literal[0] | None
    ) -> None: ...
    def GetPreNewtonResidualUserFunction(self, asDict: bool = False) -> Any: ...
    def SetEventsUserFunction(self, value: _EventsFunction | dict[str, Any] | Literal[0] | None) -> None: ...
    def GetEventsUserFunction(self, asDict: bool = False) -> Any: ...
    def SetEventActionUserFunction(self, value: _EventActionFunction | dict[str, Any] | Literal[0] | None) -> None: ...
    def GetEventActionUserFunction(self, asDict: bool = False) -> Any: ...
    def SetItemEventActionUserFunction(
        self, value: _ItemEventActionFunction | dict[str, Any] | Literal[0] | None
    ) -> None: ...
    def GetItemEventActionUserFunction(self, asDict: bool = False) -> Any: ...
    def SetSystemJacobianUserFunction(
        self, value: _SystemJacobianFunction | dict[str, Any] | Literal[0] | None
    ) -> None: ...
    def GetSystemJacobianUserFunction(self, asDict: bool = False) -> Any: ...
    def GetDictionary(mbs) -> dict[str, Any]: ...
    def SetDictionary(self, systemDict: dict[str, Any]) -> None: ...
    def Reset(self) -> None: ...
    def _ConstraintsBetween(self, bodies: Sequence[int]) -> list[int]: ...
    def _RequireIdle(self, method: str) -> None: ...
    SendRedrawSignal = shortcuts.SendRedrawSignalOfSystem
    def ActivateRendering(self, flag: bool = True) -> None: ...
    def GetRenderEngineStopFlag(self) -> bool: ...
    def SetRenderEngineStopFlag(self, stopFlag: bool) -> None: ...
    WaitForUserToContinue = shortcuts.WaitForUserToContinue
    def AddGeneralContact(self) -> GeneralContact: ...
    def GetGeneralContact(self, generalContactNumber: int) -> GeneralContact: ...
    def DeleteGeneralContact(self, generalContactNumber: int) -> None: ...
    def NumberOfGeneralContacts(self) -> int: ...
    def AddNode(self, pyObject: _Node | dict[str, Any], /) -> NodeIndex: ...
    def AddObject(self, pyObject: _Object | dict[str, Any], /) -> ObjectIndex: ...
    def AddMarker(self, pyObject: _Marker | dict[str, Any], /) -> MarkerIndex: ...
    def AddLoad(self, pyObject: _Load | dict[str, Any], /) -> LoadIndex: ...
    def AddSensor(self, pyObject: _Sensor | dict[str, Any], /) -> SensorIndex: ...
    def GetNodeNumber(self, nodeName: str) -> NodeIndex: ...
    def GetNode(self, nodeNumber: NodeIndex | int | str) -> dict[str, Any]: ...
    def GetNodeDefaults(self, typeName: str) -> dict[str, Any]: ...
    def GetNodeParameter(self, nodeNumber: NodeIndex | int | str, parameterName: str) -> Any: ...
    def SetNodeParameter(self, nodeNumber: NodeIndex | int | str, parameterName: str, value: Any) -> None: ...
    def ModifyNode(self, nodeNumber: NodeIndex | int | str, nodeDict: dict[str, Any]) -> None: ...
    def DeleteNode(self, nodeNumber: NodeIndex | int | str, suppressWarnings: bool = False) -> None: ...
    def GetObjectNumber(self, objectName: str) -> ObjectIndex: ...
    def GetObject(self, objectNumber: ObjectIndex | int | str, addGraphicsData: bool = False) -> dict[str, Any]: ...
    def GetObjectDefaults(self, typeName: str) -> dict[str, Any]: ...
    def GetObjectParameter(self, objectNumber: ObjectIndex | int | str, parameterName: str) -> Any: ...
    def SetObjectParameter(self, objectNumber: ObjectIndex | int | str, parameterName: str, value: Any) -> None: ...
    def ModifyObject(self, objectNumber: ObjectIndex | int | str, objectDict: dict[str, Any]) -> None: ...
    def DeleteObject(
        self, objectNumber: ObjectIndex | int | str, deleteDependentItems: bool = True, suppressWarnings: bool = False
    ) -> None: ...
    def GetMarkerNumber(self, markerName: str) -> MarkerIndex: ...
    def GetMarker(self, markerNumber: MarkerIndex | int | str) -> dict[str, Any]: ...
    def GetMarkerDefaults(self, typeName: str) -> dict[str, Any]: ...
    def GetMarkerParameter(self, markerNumber: MarkerIndex | int | str, parameterName: str) -> Any: ...
    def SetMarkerParameter(self, markerNumber: MarkerIndex | int | str, parameterName: str, value: Any) -> None: ...
    def ModifyMarker(self, markerNumber: MarkerIndex | int | str, markerDict: dict[str, Any]) -> None: ...
    def DeleteMarker(self, markerNumber: MarkerIndex | int | str, suppressWarnings: bool = False) -> None: ...
    def GetLoadNumber(self, loadName: str) -> LoadIndex: ...
    def GetLoad(self, loadNumber: LoadIndex | int | str) -> dict[str, Any]: ...
    def GetLoadDefaults(self, typeName: str) -> dict[str, Any]: ...
    def GetLoadParameter(self, loadNumber: LoadIndex | int | str, parameterName: str) -> Any: ...
    def SetLoadParameter(self, loadNumber: LoadIndex | int | str, parameterName: str, value: Any) -> None: ...
    def ModifyLoad(self, loadNumber: LoadIndex | int | str, loadDict: dict[str, Any]) -> None: ...
    def DeleteLoad(
        self, loadNumber: LoadIndex | int | str, deleteDependentMarkers: bool = True, suppressWarnings: bool = False
    ) -> None: ...
    def GetSensorNumber(self, sensorName: str) -> SensorIndex: ...
    def GetSensor(self, sensorNumber: SensorIndex | int | str) -> dict[str, Any]: ...
    def GetSensorDefaults(self, typeName: str) -> dict[str, Any]: ...
    def GetSensorParameter(self, sensorNumber: SensorIndex | int | str, parameterName: str) -> Any: ...
    def SetSensorParameter(self, sensorNumber: SensorIndex | int | str, parameterName: str, value: Any) -> None: ...
    def ModifySensor(self, sensorNumber: SensorIndex | int | str, sensorDict: dict[str, Any]) -> None: ...
    def DeleteSensor(self, sensorNumber: SensorIndex | int | str, suppressWarnings: bool = False) -> None: ...
    def GetAvailableFactoryItems(self) -> dict[str, list[str]]: ...
    def Assemble(self) -> None: ...
    def AssembleCoordinates(self) -> None: ...
    def AssembleLTGLists(self) -> None: ...
    def AssembleInitializeSystemCoordinates(self) -> None: ...
    def AssembleSystemInitialize(self) -> None: ...
    # A number if there is one component, else an array.
    def GetNodeOutput(
        self,
        nodeNumber: NodeIndex | int | str,
        variableType: OutputVariableType,
        configuration: ConfigurationType | None = None,
    ) -> Any: ...
    def GetObjectOutput(
        self,
        objectNumber: ObjectIndex | int | str,
        variableType: OutputVariableType,
        configuration: ConfigurationType | None = None,
    ) -> Any: ...
    def GetObjectOutputBody(
        self,
        objectNumber: ObjectIndex | int | str,
        variableType: OutputVariableType,
        localPosition: ArrayLike = [0.0, 0.0, 0.0],
        configuration: ConfigurationType | None = None,
    ) -> Any: ...
    def GetObjectOutputSuperElement(
        self,
        objectNumber: ObjectIndex | int | str,
        variableType: OutputVariableType,
        meshNodeNumber: int | str,
        configuration: ConfigurationType | None = None,
    ) -> Any: ...
    def GetMarkerOutput(
        self,
        markerNumber: MarkerIndex | int | str,
        variableType: OutputVariableType,
        configuration: ConfigurationType | None = None,
    ) -> Array: ...
    def GetLoadValues(self, loadNumber: LoadIndex | int | str) -> Any: ...
    def GetSensorValues(
        self, sensorNumber: SensorIndex | int | str, configuration: ConfigurationType | None = None
    ) -> Any: ...
    def GetSensorStoredData(self, sensorNumber: SensorIndex | int | str) -> Array: ...
    def GetNodeODE2Index(self, nodeNumber: NodeIndex | int | str) -> int: ...
    def GetNodeODE1Index(self, nodeNumber: NodeIndex | int | str) -> int: ...
    def GetNodeAEIndex(self, nodeNumber: NodeIndex | int | str) -> int: ...
    def GetSystemContainer(self) -> SystemContainer: ...

    # ---- written in Python, attached by dalembert.mainSystemExtensions
    def __copy__(mbs) -> MainSystem: ...
    def __deepcopy__(mbs, memo: dict[int, Any]) -> MainSystem: ...
    def __reduce__(mbs) -> tuple[Callable[[bytes], MainSystem], tuple[bytes]]: ...
    def _repr_html_(mbs) -> str: ...
    def _ipython_display_(mbs) -> None: ...
    CreateGround = bodies.CreateGround
    @overload
    def CreateMassPoint(
        mbs,
        name: str = "",
        referencePosition: Vector = [0.0, 0.0, 0.0],
        initialDisplacement: Vector = [0.0, 0.0, 0.0],
        initialVelocity: Vector = [0.0, 0.0, 0.0],
        physicsMass: float = 0,
        gravity: Vector = [0.0, 0.0, 0.0],
        graphicsDataList: list[dict[str, Any]] = [],
        drawSize: float = -1,
        color: Vector = [-1.0, -1.0, -1.0, -1.0],
        show: bool = True,
        create2D: bool = False,
        returnDict: Literal[False] = False,
    ) -> ObjectIndex: ...
    @overload
    def CreateMassPoint(
        mbs,
        name: str = "",
        referencePosition: Vector = [0.0, 0.0, 0.0],
        initialDisplacement: Vector = [0.0, 0.0, 0.0],
        initialVelocity: Vector = [0.0, 0.0, 0.0],
        physicsMass: float = 0,
        gravity: Vector = [0.0, 0.0, 0.0],
        graphicsDataList: list[dict[str, Any]] = [],
        drawSize: float = -1,
        color: Vector = [-1.0, -1.0, -1.0, -1.0],
        show: bool = True,
        create2D: bool = False,
        *,
        returnDict: Literal[True],
    ) -> dict[str, Any]: ...
    @overload
    def CreateRigidBody(
        mbs,
        name: str = "",
        referencePosition: Vector = [0.0, 0.0, 0.0],
        referenceRotationMatrix: Matrix = ...,
        initialVelocity: Vector = [0.0, 0.0, 0.0],
        initialAngularVelocity: Vector = [0.0, 0.0, 0.0],
        initialDisplacement: Vector | None = None,
        initialRotationMatrix: Matrix | None = None,
        inertia: RigidBodyInertia | None = None,
        gravity: Vector = [0.0, 0.0, 0.0],
        nodeType: NodeType = NodeType.RotationEulerParameters,
        graphicsDataList: list[dict[str, Any]] = [],
        graphicsDataUserFunction: Callable[..., Any] | Literal[0] = 0,
        drawSize: float = -1,
        color: Vector = [-1.0, -1.0, -1.0, -1.0],
        show: bool = True,
        create2D: bool = False,
        returnDict: Literal[False] = False,
        referenceHT: HT | ArrayLike | None = None,
        initialHT: HT | ArrayLike | None = None,
    ) -> ObjectIndex: ...
    @overload
    def CreateRigidBody(
        mbs,
        name: str = "",
        referencePosition: Vector = [0.0, 0.0, 0.0],
        referenceRotationMatrix: Matrix = ...,
        initialVelocity: Vector = [0.0, 0.0, 0.0],
        initialAngularVelocity: Vector = [0.0, 0.0, 0.0],
        initialDisplacement: Vector | None = None,
        initialRotationMatrix: Matrix | None = None,
        inertia: RigidBodyInertia | None = None,
        gravity: Vector = [0.0, 0.0, 0.0],
        nodeType: NodeType = NodeType.RotationEulerParameters,
        graphicsDataList: list[dict[str, Any]] = [],
        graphicsDataUserFunction: Callable[..., Any] | Literal[0] = 0,
        drawSize: float = -1,
        color: Vector = [-1.0, -1.0, -1.0, -1.0],
        show: bool = True,
        create2D: bool = False,
        *,
        returnDict: Literal[True],
        referenceHT: HT | ArrayLike | None = None,
        initialHT: HT | ArrayLike | None = None,
    ) -> dict[str, Any]: ...
    CreateFFRFReducedOrderObject = flexible.CreateFFRFReducedOrderObject
    CreateSpringDamper = connectors.CreateSpringDamper
    CreateCartesianSpringDamper = connectors.CreateCartesianSpringDamper
    CreateRigidBodySpringDamper = connectors.CreateRigidBodySpringDamper
    CreateLinearSpringDamper = connectors.CreateLinearSpringDamper
    CreateTorsionalSpringDamper = connectors.CreateTorsionalSpringDamper
    CreateDistanceConstraint = connectors.CreateDistanceConstraint
    CreateCoordinateConstraint = connectors.CreateCoordinateConstraint
    CreateRevoluteJoint = joints.CreateRevoluteJoint
    CreatePrismaticJoint = joints.CreatePrismaticJoint
    CreateSphericalJoint = joints.CreateSphericalJoint
    CreateGenericJoint = joints.CreateGenericJoint
    CreateFixedJoint = joints.CreateFixedJoint
    CreateCylindricalJoint = joints.CreateCylindricalJoint
    CreateUniversalJoint = joints.CreateUniversalJoint
    CreateBox = shapes.CreateBox
    CreateCylinder = shapes.CreateCylinder
    CreateSphere = shapes.CreateSphere
    CreateMotor = drives.CreateMotor
    CreatePIDController = drives.CreatePIDController
    CreateJointStops = drives.CreateJointStops
    CreatePrescribedMotion = drives.CreatePrescribedMotion
    CreateForceFromTable = drives.CreateForceFromTable
    CreateTorqueFromTable = drives.CreateTorqueFromTable
    CreateCable = lines.CreateCable
    CreateBeam = lines.CreateBeam
    CreateHydraulicCylinder = lines.CreateHydraulicCylinder
    CreateRope = ropes.CreateRope
    CreateBelt = ropes.CreateBelt
    CreateRollingDisc = joints.CreateRollingDisc
    CreateRollingDiscPenalty = joints.CreateRollingDiscPenalty
    CreateSphereSphereContact = contacts.CreateSphereSphereContact
    CreateSphereTriangleContact = contacts.CreateSphereTriangleContact
    CreateSphereQuadContact = contacts.CreateSphereQuadContact
    CreateForce = loads.CreateForce
    CreateTorque = loads.CreateTorque

    CreateKinematicTree = trees.CreateKinematicTree
    CreateDistanceSensor = sensors.CreateDistanceSensor
    CreateDistanceSensorGeometry = sensors.CreateDistanceSensorGeometry
    CreateRobot = robots.CreateRobot
    DrawSystemGraph = system_graph.DrawSystemGraph
    Draw = draw.Draw
    DrawSolution = draw.DrawSolution
    Load = model_files.Load
    PlotSensor = plot.PlotSensor
    Save = model_files.Save
    SaveGLB = glb.SaveGLB
    SaveHTML = html.SaveHTML
    SaveVTU = vtu.SaveVTU
    SolutionViewer = interactive.SolutionViewer
    ComputeLinearizedSystem = linearized.ComputeLinearizedSystem
    ComputeODE2Eigenvalues = linearized.ComputeODE2Eigenvalues
    ComputeSystemDegreeOfFreedom = linearized.ComputeSystemDegreeOfFreedom
    SolveDynamic = solver.SolveDynamic
    SolveStatic = solver.SolveStatic
    SolveVariations = variations.SolveVariations
    ComputeSensitivities = exact_sensitivities.ComputeSensitivities
    ComputeBucklingLoads = buckling.ComputeBucklingLoads
    ComputeConsistentInitialConditions = consistent.ComputeConsistentInitialConditions
    ComputeEnergies = energies.ComputeEnergies
    ComputeVibrationModes = vibrations.ComputeVibrationModes
    ComputeItem = item_computations.ComputeItem
    Inspect = item_computations.Inspect
    InspectSolution = inspection.InspectSolution
    Report = report.Report
