# The multibody system: adding, reading and changing items, outputs, solving.

from collections.abc import Callable, Sequence
from typing import Any, Literal, NoReturn, overload

from numpy.typing import ArrayLike

from dalembert import _distance_sensor as distance_sensor
from dalembert import _linearized as linearized
from dalembert import _system_graph as system_graph
from dalembert import _variations as variations
from dalembert import interactive, plot, solver
from dalembert._core import SystemContainer
from dalembert._core_base import *
from dalembert._core_base import _Bound
from dalembert._core_enums import *
from dalembert._core_items import *
from dalembert._core_items import _Load, _Marker, _Node, _Object, _Sensor
from dalembert._core_settings import *
from dalembert._core_system_data import SystemData
from dalembert._core_types import Array, Matrix, MatrixLike, Vector
from dalembert._inertia import RigidBodyInertia

# What Create functions connect: bodies, nodes or markers by number.
_Connected = ObjectIndex | NodeIndex | MarkerIndex | int

# Functions that solvers call. Step functions return whether to go on, PostNewton [error, recommended step size].
_StepFunction = Callable[[MainSystem, float], bool]
_PostNewtonFunction = Callable[[MainSystem, float], ArrayLike]
_PreNewtonResidualFunction = Callable[[MainSystem, float, int, int], Any]
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
    def SetSystemJacobianUserFunction(
        self, value: _SystemJacobianFunction | dict[str, Any] | Literal[0] | None
    ) -> None: ...
    def GetSystemJacobianUserFunction(self, asDict: bool = False) -> Any: ...
    def GetDictionary(mbs) -> dict[str, Any]: ...
    def SetDictionary(self, systemDict: dict[str, Any]) -> None: ...
    def Reset(self) -> None: ...
    def SendRedrawSignal(self) -> None: ...
    def ActivateRendering(self, flag: bool = True) -> None: ...
    def GetRenderEngineStopFlag(self) -> bool: ...
    def SetRenderEngineStopFlag(self, stopFlag: bool) -> None: ...
    def WaitForUserToContinue(self, printMessage: bool = True) -> None: ...
    def AddGeneralContact(self, *args: Any, **kwargs: Any) -> NoReturn: ...
    def GetGeneralContact(self, *args: Any, **kwargs: Any) -> NoReturn: ...
    def DeleteGeneralContact(self, *args: Any, **kwargs: Any) -> NoReturn: ...
    def NumberOfGeneralContacts(self) -> int: ...
    def AddNode(self, pyObject: _Node | dict[str, Any], /) -> NodeIndex: ...
    def AddObject(self, pyObject: _Object | dict[str, Any], /) -> ObjectIndex: ...
    def AddMarker(self, pyObject: _Marker | dict[str, Any], /) -> MarkerIndex: ...
    def AddLoad(self, pyObject: _Load | dict[str, Any], /) -> LoadIndex: ...
    def AddSensor(self, pyObject: _Sensor | dict[str, Any], /) -> SensorIndex: ...
    def GetNodeNumber(self, nodeName: str) -> NodeIndex: ...
    def GetNode(self, nodeNumber: NodeIndex | int) -> dict[str, Any]: ...
    def GetNodeDefaults(self, typeName: str) -> dict[str, Any]: ...
    def GetNodeParameter(self, nodeNumber: NodeIndex | int, parameterName: str) -> Any: ...
    def SetNodeParameter(self, nodeNumber: NodeIndex | int, parameterName: str, value: Any) -> None: ...
    def ModifyNode(self, nodeNumber: NodeIndex | int, nodeDict: dict[str, Any]) -> None: ...
    def DeleteNode(self, nodeNumber: NodeIndex | int, suppressWarnings: bool = False) -> None: ...
    def GetObjectNumber(self, objectName: str) -> ObjectIndex: ...
    def GetObject(self, objectNumber: ObjectIndex | int, addGraphicsData: bool = False) -> dict[str, Any]: ...
    def GetObjectDefaults(self, typeName: str) -> dict[str, Any]: ...
    def GetObjectParameter(self, objectNumber: ObjectIndex | int, parameterName: str) -> Any: ...
    def SetObjectParameter(self, objectNumber: ObjectIndex | int, parameterName: str, value: Any) -> None: ...
    def ModifyObject(self, objectNumber: ObjectIndex | int, objectDict: dict[str, Any]) -> None: ...
    def DeleteObject(
        self, objectNumber: ObjectIndex | int, deleteDependentItems: bool = True, suppressWarnings: bool = False
    ) -> None: ...
    def GetMarkerNumber(self, markerName: str) -> MarkerIndex: ...
    def GetMarker(self, markerNumber: MarkerIndex | int) -> dict[str, Any]: ...
    def GetMarkerDefaults(self, typeName: str) -> dict[str, Any]: ...
    def GetMarkerParameter(self, markerNumber: MarkerIndex | int, parameterName: str) -> Any: ...
    def SetMarkerParameter(self, markerNumber: MarkerIndex | int, parameterName: str, value: Any) -> None: ...
    def ModifyMarker(self, markerNumber: MarkerIndex | int, markerDict: dict[str, Any]) -> None: ...
    def DeleteMarker(self, markerNumber: MarkerIndex | int, suppressWarnings: bool = False) -> None: ...
    def GetLoadNumber(self, loadName: str) -> LoadIndex: ...
    def GetLoad(self, loadNumber: LoadIndex | int) -> dict[str, Any]: ...
    def GetLoadDefaults(self, typeName: str) -> dict[str, Any]: ...
    def GetLoadParameter(self, loadNumber: LoadIndex | int, parameterName: str) -> Any: ...
    def SetLoadParameter(self, loadNumber: LoadIndex | int, parameterName: str, value: Any) -> None: ...
    def ModifyLoad(self, loadNumber: LoadIndex | int, loadDict: dict[str, Any]) -> None: ...
    def DeleteLoad(
        self, loadNumber: LoadIndex | int, deleteDependentMarkers: bool = True, suppressWarnings: bool = False
    ) -> None: ...
    def GetSensorNumber(self, sensorName: str) -> SensorIndex: ...
    def GetSensor(self, sensorNumber: SensorIndex | int) -> dict[str, Any]: ...
    def GetSensorDefaults(self, typeName: str) -> dict[str, Any]: ...
    def GetSensorParameter(self, sensorNumber: SensorIndex | int, parameterName: str) -> Any: ...
    def SetSensorParameter(self, sensorNumber: SensorIndex | int, parameterName: str, value: Any) -> None: ...
    def ModifySensor(self, sensorNumber: SensorIndex | int, sensorDict: dict[str, Any]) -> None: ...
    def DeleteSensor(self, sensorNumber: SensorIndex | int, suppressWarnings: bool = False) -> None: ...
    def GetAvailableFactoryItems(self) -> dict[str, list[str]]: ...
    def Assemble(self) -> None: ...
    def AssembleCoordinates(self) -> None: ...
    def AssembleLTGLists(self) -> None: ...
    def AssembleInitializeSystemCoordinates(self) -> None: ...
    def AssembleSystemInitialize(self) -> None: ...
    # A number if there is one component, else an array.
    def GetNodeOutput(
        self,
        nodeNumber: NodeIndex | int,
        variableType: OutputVariableType,
        configuration: ConfigurationType | None = None,
    ) -> Any: ...
    def GetObjectOutput(
        self,
        objectNumber: ObjectIndex | int,
        variableType: OutputVariableType,
        configuration: ConfigurationType | None = None,
    ) -> Any: ...
    def GetObjectOutputBody(
        self,
        objectNumber: ObjectIndex | int,
        variableType: OutputVariableType,
        localPosition: ArrayLike = [0.0, 0.0, 0.0],
        configuration: ConfigurationType | None = None,
    ) -> Any: ...
    def GetObjectOutputSuperElement(
        self,
        objectNumber: ObjectIndex | int,
        variableType: OutputVariableType,
        meshNodeNumber: int,
        configuration: ConfigurationType | None = None,
    ) -> Any: ...
    def GetMarkerOutput(
        self,
        markerNumber: MarkerIndex | int,
        variableType: OutputVariableType,
        configuration: ConfigurationType | None = None,
    ) -> Array: ...
    def GetLoadValues(self, loadNumber: LoadIndex | int) -> Any: ...
    def GetSensorValues(
        self, sensorNumber: SensorIndex | int, configuration: ConfigurationType | None = None
    ) -> Any: ...
    def GetSensorStoredData(self, sensorNumber: SensorIndex | int) -> Array: ...
    def GetNodeODE2Index(self, nodeNumber: NodeIndex | int) -> int: ...
    def GetNodeODE1Index(self, nodeNumber: NodeIndex | int) -> int: ...
    def GetNodeAEIndex(self, nodeNumber: NodeIndex | int) -> int: ...
    def GetSystemContainer(self) -> SystemContainer: ...

    # ---- written in Python, attached by dalembert.mainSystemExtensions
    def __copy__(mbs) -> MainSystem: ...
    def __deepcopy__(mbs, memo: dict[int, Any]) -> MainSystem: ...
    def __reduce__(mbs) -> tuple[Callable[[bytes], MainSystem], tuple[bytes]]: ...
    def _repr_html_(mbs) -> str: ...
    def CreateGround(
        mbs,
        name: str = "",
        referencePosition: Vector = [0.0, 0.0, 0.0],
        referenceRotationMatrix: Matrix = ...,
        graphicsDataList: list[dict[str, Any]] = [],
        graphicsDataUserFunction: Callable[..., Any] | Literal[0] = 0,
        show: bool = True,
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
    ) -> dict[str, Any]: ...
    def CreateSpringDamper(
        mbs,
        name: str = "",
        bodyNumbers: Sequence[_Connected] = ...,
        localPosition0: Vector = [0.0, 0.0, 0.0],
        localPosition1: Vector = [0.0, 0.0, 0.0],
        referenceLength: float | None = None,
        stiffness: float = 0.0,
        damping: float = 0.0,
        force: float = 0.0,
        velocityOffset: float = 0.0,
        springForceUserFunction: Callable[..., Any] | Literal[0] = 0,
        bodyOrNodeList: Sequence[_Connected] = ...,
        bodyList: Sequence[_Connected] = ...,
        show: bool = True,
        drawSize: float = -1,
        color: Vector = [-1.0, -1.0, -1.0, -1.0],
    ) -> ObjectIndex: ...
    def CreateCartesianSpringDamper(
        mbs,
        name: str = "",
        bodyNumbers: Sequence[_Connected] = ...,
        localPosition0: Vector = [0.0, 0.0, 0.0],
        localPosition1: Vector = [0.0, 0.0, 0.0],
        stiffness: Vector = [0.0, 0.0, 0.0],
        damping: Vector = [0.0, 0.0, 0.0],
        offset: Vector = [0.0, 0.0, 0.0],
        springForceUserFunction: Callable[..., Any] | Literal[0] = 0,
        bodyOrNodeList: Sequence[_Connected] = ...,
        bodyList: Sequence[_Connected] = ...,
        show: bool = True,
        drawSize: float = -1,
        color: Vector = [-1.0, -1.0, -1.0, -1.0],
    ) -> ObjectIndex: ...
    def CreateRigidBodySpringDamper(
        mbs,
        name: str = "",
        bodyNumbers: Sequence[_Connected] = ...,
        localPosition0: Vector = [0.0, 0.0, 0.0],
        localPosition1: Vector = [0.0, 0.0, 0.0],
        stiffness: Matrix = ...,
        damping: Matrix = ...,
        offset: Vector = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        rotationMatrixJoint: Matrix = ...,
        useGlobalFrame: bool = True,
        intrinsicFormulation: bool = True,
        springForceTorqueUserFunction: Callable[..., Any] | Literal[0] = 0,
        postNewtonStepUserFunction: Callable[..., Any] | Literal[0] = 0,
        bodyOrNodeList: Sequence[_Connected] = ...,
        bodyList: Sequence[_Connected] = ...,
        show: bool = True,
        drawSize: float = -1,
        color: Vector = [-1.0, -1.0, -1.0, -1.0],
    ) -> ObjectIndex: ...
    def CreateTorsionalSpringDamper(
        mbs,
        name: str = "",
        bodyNumbers: Sequence[_Connected] = ...,
        position: Vector = [0.0, 0.0, 0.0],
        axis: Vector = [0.0, 0.0, 0.0],
        stiffness: float = 0.0,
        damping: float = 0.0,
        offset: float = 0.0,
        velocityOffset: float = 0.0,
        torque: float = 0.0,
        useGlobalFrame: bool = True,
        springTorqueUserFunction: Callable[..., Any] | Literal[0] = 0,
        unlimitedRotations: bool = True,
        show: bool = True,
        drawSize: float = -1,
        color: Vector = [-1.0, -1.0, -1.0, -1.0],
    ) -> ObjectIndex: ...
    def CreateDistanceConstraint(
        mbs,
        name: str = "",
        bodyNumbers: Sequence[_Connected] = ...,
        localPosition0: Vector = [0.0, 0.0, 0.0],
        localPosition1: Vector = [0.0, 0.0, 0.0],
        distance: float | None = None,
        bodyOrNodeList: Sequence[_Connected] = ...,
        bodyList: Sequence[_Connected] = ...,
        show: bool = True,
        drawSize: float = -1.0,
        color: Vector = [-1.0, -1.0, -1.0, -1.0],
    ) -> ObjectIndex: ...
    def CreateCoordinateConstraint(
        mbs,
        name: str = "",
        bodyNumbers: Sequence[ObjectIndex | int | None] = [None, None],
        coordinates: Sequence[int | None] = [None, None],
        offset: float = 0.0,
        factorValue1: float = 1.0,
        velocityLevel: bool = False,
        offsetUserFunction: Callable[..., Any] | Literal[0] = 0,
        offsetUserFunction_t: Callable[..., Any] | Literal[0] = 0,
        show: bool = True,
        drawSize: float = -1.0,
        color: Vector = [-1.0, -1.0, -1.0, -1.0],
    ) -> ObjectIndex: ...
    def CreateRevoluteJoint(
        mbs,
        name: str = "",
        bodyNumbers: Sequence[_Connected] = ...,
        position: Vector = [],
        axis: Vector = [],
        useGlobalFrame: bool = True,
        show: bool = True,
        axisRadius: float = 0.1,
        axisLength: float = 0.4,
        color: Vector = [-1.0, -1.0, -1.0, -1.0],
    ) -> ObjectIndex: ...
    def CreatePrismaticJoint(
        mbs,
        name: str = "",
        bodyNumbers: Sequence[_Connected] = ...,
        position: Vector = [],
        axis: Vector = [],
        useGlobalFrame: bool = True,
        show: bool = True,
        axisRadius: float = 0.1,
        axisLength: float = 0.4,
        color: Vector = [-1.0, -1.0, -1.0, -1.0],
    ) -> ObjectIndex: ...
    def CreateSphericalJoint(
        mbs,
        name: str = "",
        bodyNumbers: Sequence[_Connected] = ...,
        position: Vector = [],
        constrainedAxes: Sequence[int] = [1, 1, 1],
        useGlobalFrame: bool = True,
        show: bool = True,
        jointRadius: float = 0.1,
        color: Vector = [-1.0, -1.0, -1.0, -1.0],
    ) -> ObjectIndex: ...
    def CreateGenericJoint(
        mbs,
        name: str = "",
        bodyNumbers: Sequence[_Connected] = ...,
        position: Vector = [],
        rotationMatrixAxes: Matrix = ...,
        constrainedAxes: Sequence[int] = [1, 1, 1, 1, 1, 1],
        useGlobalFrame: bool = True,
        offsetUserFunction: Callable[..., Any] | Literal[0] = 0,
        offsetUserFunction_t: Callable[..., Any] | Literal[0] = 0,
        show: bool = True,
        axesRadius: float = 0.1,
        axesLength: float = 0.4,
        color: Vector = [-1.0, -1.0, -1.0, -1.0],
    ) -> ObjectIndex: ...
    def CreateRollingDisc(
        mbs,
        name: str = "",
        bodyNumbers: Sequence[_Connected] = ...,
        axisPosition: Vector = [],
        axisVector: Vector = [1, 0, 0],
        discRadius: float = 0.0,
        planePosition: Vector = [0, 0, 0],
        planeNormal: Vector = [0, 0, 1],
        constrainedAxes: Sequence[int] = [1, 1, 1],
        activeConnector: bool = True,
        show: bool = True,
        discWidth: float = 0.1,
        color: Vector = [-1.0, -1.0, -1.0, -1.0],
    ) -> ObjectIndex: ...
    def CreateRollingDiscPenalty(
        mbs,
        name: str = "",
        bodyNumbers: Sequence[_Connected] = ...,
        axisPosition: Vector = [],
        axisVector: Vector = [1, 0, 0],
        discRadius: float = 0.0,
        planePosition: Vector = [0, 0, 0],
        planeNormal: Vector = [0, 0, 1],
        contactStiffness: float = 0.0,
        contactDamping: float = 0.0,
        dryFriction: Vector = [0, 0],
        dryFrictionAngle: float = 0.0,
        dryFrictionProportionalZone: float = 0.0,
        viscousFriction: Vector = [0, 0],
        rollingFrictionViscous: float = 0.0,
        useLinearProportionalZone: bool = False,
        activeConnector: bool = True,
        show: bool = True,
        discWidth: float = 0.1,
        color: Vector = [-1.0, -1.0, -1.0, -1.0],
    ) -> ObjectIndex: ...
    def CreateForce(
        mbs,
        name: str = "",
        bodyNumber: ObjectIndex | MarkerIndex | int | None = None,
        loadVector: Vector = [0.0, 0.0, 0.0],
        localPosition: Vector = [0.0, 0.0, 0.0],
        bodyFixed: bool = False,
        loadVectorUserFunction: Callable[..., Any] | Literal[0] = 0,
        show: bool = True,
    ) -> LoadIndex: ...
    def CreateTorque(
        mbs,
        name: str = "",
        bodyNumber: ObjectIndex | MarkerIndex | int | None = None,
        loadVector: Vector = [0.0, 0.0, 0.0],
        localPosition: Vector = [0.0, 0.0, 0.0],
        bodyFixed: bool = False,
        loadVectorUserFunction: Callable[..., Any] | Literal[0] = 0,
        show: bool = True,
    ) -> LoadIndex: ...
    def CreateSphereSphereContact(mbs, *args: Any, **kwargs: Any) -> NoReturn: ...
    def CreateSphereQuadContact(mbs, *args: Any, **kwargs: Any) -> NoReturn: ...
    def CreateSphereTriangleContact(mbs, *args: Any, **kwargs: Any) -> NoReturn: ...
    def CreateKinematicTree(mbs, *args: Any, **kwargs: Any) -> NoReturn: ...
    def CreateFFRFReducedOrderObject(mbs, *args: Any, **kwargs: Any) -> NoReturn: ...
    CreateDistanceSensor = distance_sensor.CreateDistanceSensor
    CreateDistanceSensorGeometry = distance_sensor.CreateDistanceSensorGeometry
    DrawSystemGraph = system_graph.DrawSystemGraph
    PlotSensor = plot.PlotSensor
    SolutionViewer = interactive.SolutionViewer
    ComputeLinearizedSystem = linearized.ComputeLinearizedSystem
    ComputeODE2Eigenvalues = linearized.ComputeODE2Eigenvalues
    ComputeSystemDegreeOfFreedom = linearized.ComputeSystemDegreeOfFreedom
    SolveDynamic = solver.SolveDynamic
    SolveStatic = solver.SolveStatic
    SolveVariations = variations.SolveVariations
