# Generated from specs/settings/ by codegen/templates/core_settings.pyi.j2. Do not edit; run `python -m codegen`.
# tests/codegen/test_freshness.py compares this file with its sources.

from collections.abc import Callable, Sequence
from typing import Any, Literal

from numpy.typing import ArrayLike

from dalembert._core_enums import DynamicSolverType, ItemType, LinearSolverType, OutputVariableType

class NewtonNumericalDifferentiationSettings:
    """NewtonNumericalDifferentiationSettings"""

    addReferenceCoordinatesToEpsilon: bool
    """addReferenceCoordinatesToEpsilon; default: False"""
    doSystemWideDifferentiation: bool
    """doSystemWideDifferentiation; default: False"""
    forAE: bool
    """forAE; default: False"""
    forODE2: bool
    """forODE2; default: False"""
    forODE2connectors: bool
    """forODE2connectors; default: False"""
    jacobianConnectorDerivative: bool
    """jacobianConnectorDerivative; default: True"""
    minimumCoordinateSize: float
    """minimumCoordinateSize; default: 0.01"""
    relativeEpsilon: float
    """relativeEpsilon; default: 1e-07"""
    def __init__(self) -> None: ...
    def GetDictionary(self) -> dict[str, Any]: ...
    def SetDictionary(self, dictionary: dict[str, Any]) -> None: ...

class NewtonSettings:
    """NewtonSettings"""

    absoluteTolerance: float
    """absoluteTolerance; default: 1e-10"""
    adaptInitialResidual: bool
    """adaptInitialResidual; default: True"""
    maximumSolutionNorm: float
    """maximumSolutionNorm; default: 1e+38"""
    maxIterations: int
    """maxIterations; default: 25"""
    maxModifiedNewtonIterations: int
    """maxModifiedNewtonIterations; default: 8"""
    maxModifiedNewtonRestartIterations: int
    """maxModifiedNewtonRestartIterations; default: 7"""
    modifiedNewtonContractivity: float
    """modifiedNewtonContractivity; default: 0.5"""
    modifiedNewtonJacUpdatePerStep: bool
    """modifiedNewtonJacUpdatePerStep; default: False"""
    newtonResidualMode: int
    """newtonResidualMode; default: 0"""
    relativeTolerance: float
    """relativeTolerance; default: 1e-08"""
    useModifiedNewton: bool
    """useModifiedNewton; default: False"""
    useNewtonSolver: bool
    """useNewtonSolver; default: True"""
    weightTolerancePerCoordinate: bool
    """weightTolerancePerCoordinate; default: False"""
    numericalDifferentiation: NewtonNumericalDifferentiationSettings
    def __init__(self) -> None: ...
    def GetDictionary(self) -> dict[str, Any]: ...
    def SetDictionary(self, dictionary: dict[str, Any]) -> None: ...

class DiscontinuousSettings:
    """DiscontinuousSettings"""

    ignoreMaxIterations: bool
    """ignoreMaxIterations; default: True"""
    iterationTolerance: float
    """iterationTolerance; default: 1.0"""
    maxIterations: int
    """maxIterations; default: 5"""
    useRecommendedStepSize: bool
    """useRecommendedStepSize; default: True"""
    def __init__(self) -> None: ...
    def GetDictionary(self) -> dict[str, Any]: ...
    def SetDictionary(self, dictionary: dict[str, Any]) -> None: ...

class LinearSolverSettings:
    """LinearSolverSettings"""

    ignoreSingularJacobian: bool
    """ignoreSingularJacobian; default: False"""
    pivotThreshold: float
    """pivotThreshold; default: 0.0"""
    reuseAnalyzedPattern: bool
    """reuseAnalyzedPattern; default: False"""
    showCausingItems: bool
    """showCausingItems; default: True"""
    def __init__(self) -> None: ...
    def GetDictionary(self) -> dict[str, Any]: ...
    def SetDictionary(self, dictionary: dict[str, Any]) -> None: ...

class ParallelSettings:
    """ParallelSettings"""

    multithreadedLLimitJacobians: int
    """multithreadedLLimitJacobians; default: 20"""
    multithreadedLLimitLoads: int
    """multithreadedLLimitLoads; default: 20"""
    multithreadedLLimitMassMatrices: int
    """multithreadedLLimitMassMatrices; default: 20"""
    multithreadedLLimitResiduals: int
    """multithreadedLLimitResiduals; default: 20"""
    numberOfThreads: int
    """numberOfThreads; default: 1"""
    taskSplitMinItems: int
    """taskSplitMinItems; default: 50"""
    taskSplitTasksPerThread: int
    """taskSplitTasksPerThread; default: 16"""
    useLoadBalancing: bool
    """useLoadBalancing; default: True"""
    def __init__(self) -> None: ...
    def GetDictionary(self) -> dict[str, Any]: ...
    def SetDictionary(self, dictionary: dict[str, Any]) -> None: ...

class SolutionSettings:
    """SolutionSettings"""

    appendToFile: bool
    """appendToFile; default: False"""
    binarySolutionFile: bool
    """binarySolutionFile; default: False"""
    coordinatesSolutionFileName: str
    """coordinatesSolutionFileName; default: 'coordinatesSolution'"""
    exportAccelerations: bool
    """exportAccelerations; default: True"""
    exportAlgebraicCoordinates: bool
    """exportAlgebraicCoordinates; default: True"""
    exportDataCoordinates: bool
    """exportDataCoordinates; default: True"""
    exportODE1Velocities: bool
    """exportODE1Velocities; default: True"""
    exportVelocities: bool
    """exportVelocities; default: True"""
    flushFilesDOF: int
    """flushFilesDOF; default: 10000"""
    flushFilesImmediately: bool
    """flushFilesImmediately; default: False"""
    outputPrecision: int
    """outputPrecision; default: 10"""
    recordImagesInterval: float
    """recordImagesInterval; default: -1.0"""
    restartFileName: str
    """restartFileName; default: 'restartFile.txt'"""
    restartWritePeriod: float
    """restartWritePeriod; default: 0.01"""
    sensorsAppendToFile: bool
    """sensorsAppendToFile; default: False"""
    sensorsStoreAndWriteFiles: bool
    """sensorsStoreAndWriteFiles; default: True"""
    sensorsWriteFileFooter: bool
    """sensorsWriteFileFooter; default: False"""
    sensorsWriteFileHeader: bool
    """sensorsWriteFileHeader; default: True"""
    sensorsWritePeriod: float
    """sensorsWritePeriod; default: 0.01"""
    solutionInformation: str
    """solutionInformation; default: ''"""
    solutionWritePeriod: float
    """solutionWritePeriod; default: 0.01"""
    solverInformationFileName: str
    """solverInformationFileName; default: 'solverInformation.txt'"""
    writeFileFooter: bool
    """writeFileFooter; default: True"""
    writeFileHeader: bool
    """writeFileHeader; default: True"""
    writeInitialValues: bool
    """writeInitialValues; default: True"""
    writeRestartFile: bool
    """writeRestartFile; default: False"""
    writeSolutionToFile: bool
    """writeSolutionToFile; default: True"""
    def __init__(self) -> None: ...
    def GetDictionary(self) -> dict[str, Any]: ...
    def SetDictionary(self, dictionary: dict[str, Any]) -> None: ...

class StaticSolverSettings:
    """StaticSolverSettings"""

    adaptiveStep: bool
    """adaptiveStep; default: True"""
    adaptiveStepDecrease: float
    """adaptiveStepDecrease; default: 0.25"""
    adaptiveStepIncrease: float
    """adaptiveStepIncrease; default: 2.0"""
    adaptiveStepRecoveryIterations: int
    """adaptiveStepRecoveryIterations; default: 7"""
    adaptiveStepRecoverySteps: int
    """adaptiveStepRecoverySteps; default: 4"""
    computeLoadsJacobian: bool
    """computeLoadsJacobian; default: True"""
    constrainODE1coordinates: bool
    """constrainODE1coordinates; default: True"""
    loadStepDuration: float
    """loadStepDuration; default: 1.0"""
    loadStepGeometric: bool
    """loadStepGeometric; default: False"""
    loadStepGeometricRange: float
    """loadStepGeometricRange; default: 1000.0"""
    loadStepStart: float
    """loadStepStart; default: 0.0"""
    minimumStepSize: float
    """minimumStepSize; default: 1e-08"""
    numberOfLoadSteps: int
    """numberOfLoadSteps; default: 1"""
    stabilizerODE2term: float
    """stabilizerODE2term; default: 0.0"""
    stepInformation: int
    """stepInformation; default: 67"""
    useLoadFactor: bool
    """useLoadFactor; default: True"""
    verboseMode: int
    """verboseMode; default: 1"""
    verboseModeFile: int
    """verboseModeFile; default: 0"""
    discontinuous: DiscontinuousSettings
    newton: NewtonSettings
    def __init__(self) -> None: ...
    def GetDictionary(self) -> dict[str, Any]: ...
    def SetDictionary(self, dictionary: dict[str, Any]) -> None: ...

class TimeIntegrationExplicitIntegrationSettings:
    """TimeIntegrationExplicitIntegrationSettings"""

    computeEndOfStepAccelerations: bool
    """computeEndOfStepAccelerations; default: True"""
    computeMassMatrixInversePerBody: bool
    """computeMassMatrixInversePerBody; default: False"""
    dynamicSolverType: DynamicSolverType
    """dynamicSolverType; default: DynamicSolverType.DOPRI5"""
    eliminateConstraints: bool
    """eliminateConstraints; default: True"""
    useLieGroupIntegration: bool
    """useLieGroupIntegration; default: True"""
    def __init__(self) -> None: ...
    def GetDictionary(self) -> dict[str, Any]: ...
    def SetDictionary(self, dictionary: dict[str, Any]) -> None: ...

class TimeIntegrationGeneralizedAlphaSettings:
    """TimeIntegrationGeneralizedAlphaSettings"""

    computeInitialAccelerations: bool
    """computeInitialAccelerations; default: True"""
    lieGroupAddTangentOperator: bool
    """lieGroupAddTangentOperator; default: True"""
    lieGroupSimplifiedKinematicRelations: bool
    """lieGroupSimplifiedKinematicRelations; default: False"""
    newmarkBeta: float
    """newmarkBeta; default: 0.25"""
    newmarkGamma: float
    """newmarkGamma; default: 0.5"""
    resetAccelerations: bool
    """resetAccelerations; default: False"""
    spectralRadius: float
    """spectralRadius; default: 0.9"""
    storeInitialAlgebraicCoordinates: bool
    """storeInitialAlgebraicCoordinates; default: True"""
    useIndex2Constraints: bool
    """useIndex2Constraints; default: False"""
    useNewmark: bool
    """useNewmark; default: False"""
    def __init__(self) -> None: ...
    def GetDictionary(self) -> dict[str, Any]: ...
    def SetDictionary(self, dictionary: dict[str, Any]) -> None: ...

class TimeIntegrationSettings:
    """TimeIntegrationSettings"""

    absoluteTolerance: float
    """absoluteTolerance; default: 1e-08"""
    adaptiveStep: bool
    """adaptiveStep; default: True"""
    adaptiveStepDecrease: float
    """adaptiveStepDecrease; default: 0.5"""
    adaptiveStepIncrease: float
    """adaptiveStepIncrease; default: 2.0"""
    adaptiveStepRecoveryIterations: int
    """adaptiveStepRecoveryIterations; default: 7"""
    adaptiveStepRecoverySteps: int
    """adaptiveStepRecoverySteps; default: 10"""
    automaticStepSize: bool
    """automaticStepSize; default: True"""
    computeLoadsJacobian: int
    """computeLoadsJacobian; default: 0"""
    endTime: float
    """endTime; default: 1.0"""
    initialStepSize: float
    """initialStepSize; default: 0.0"""
    minimumStepSize: float
    """minimumStepSize; default: 1e-08"""
    numberOfSteps: float
    """numberOfSteps; default: 100.0"""
    realtimeFactor: float
    """realtimeFactor; default: 1.0"""
    realtimeWaitMicroseconds: int
    """realtimeWaitMicroseconds; default: 1000"""
    relativeTolerance: float
    """relativeTolerance; default: 1e-08"""
    reuseConstantMassMatrix: bool
    """reuseConstantMassMatrix; default: True"""
    simulateInRealtime: bool
    """simulateInRealtime; default: False"""
    startTime: float
    """startTime; default: 0.0"""
    stepInformation: int
    """stepInformation; default: 67"""
    stepSizeMaxIncrease: float
    """stepSizeMaxIncrease; default: 2.0"""
    stepSizeSafety: float
    """stepSizeSafety; default: 0.9"""
    verboseMode: int
    """verboseMode; default: 0"""
    verboseModeFile: int
    """verboseModeFile; default: 0"""
    discontinuous: DiscontinuousSettings
    explicitIntegration: TimeIntegrationExplicitIntegrationSettings
    generalizedAlpha: TimeIntegrationGeneralizedAlphaSettings
    newton: NewtonSettings
    def __init__(self) -> None: ...
    def GetDictionary(self) -> dict[str, Any]: ...
    def SetDictionary(self, dictionary: dict[str, Any]) -> None: ...

class SimulationSettings:
    """SimulationSettings"""

    cleanUpMemory: bool
    """cleanUpMemory; default: False"""
    displayComputationTime: bool
    """displayComputationTime; default: False"""
    displayGlobalTimers: bool
    """displayGlobalTimers; default: True"""
    displayStatistics: bool
    """displayStatistics; default: False"""
    linearSolverType: LinearSolverType
    """linearSolverType; default: LinearSolverType.EXUdense"""
    outputPrecision: int
    """outputPrecision; default: 6"""
    pauseAfterEachStep: bool
    """pauseAfterEachStep; default: False"""
    linearSolverSettings: LinearSolverSettings
    parallel: ParallelSettings
    solutionSettings: SolutionSettings
    staticSolver: StaticSolverSettings
    timeIntegration: TimeIntegrationSettings
    def __init__(self) -> None: ...
    def GetDictionary(self) -> dict[str, Any]: ...
    def SetDictionary(self, dictionary: dict[str, Any]) -> None: ...

class VSettingsViewCamera:
    """VSettingsViewCamera"""

    cameraPosition: ArrayLike
    """cameraPosition [3]; default: [0.0, 0.0, 0.0]"""
    clippingPlaneDistance: float
    """clippingPlaneDistance; default: 0.0"""
    clippingPlaneNormal: ArrayLike
    """clippingPlaneNormal [3]; default: [0.0, 0.0, 0.0]"""
    modelCentricView: bool
    """modelCentricView; default: True"""
    nearFarPlaneOffset: ArrayLike
    """nearFarPlaneOffset [3]; default: [0.0, 0.0, 0.0]"""
    perspective: float
    """perspective; default: 0.0"""
    trackMarker: int
    """trackMarker; default: -1"""
    trackMarkerMbsNumber: int
    """trackMarkerMbsNumber; default: 0"""
    trackMarkerOrientation: ArrayLike
    """trackMarkerOrientation [3]; default: [0.0, 0.0, 0.0]"""
    trackMarkerPosition: ArrayLike
    """trackMarkerPosition [3]; default: [1.0, 1.0, 1.0]"""
    useRaytracer: bool
    """useRaytracer; default: False"""
    def __init__(self) -> None: ...
    def GetDictionary(self) -> dict[str, Any]: ...
    def SetDictionary(self, dictionary: dict[str, Any]) -> None: ...

class VSettingsViewScene:
    """VSettingsViewScene"""

    drawCoordinateSystem: int
    """drawCoordinateSystem; default: 2"""
    drawWorldBasis: bool
    """drawWorldBasis; default: False"""
    facesTransparent: bool
    """facesTransparent; default: False"""
    showFaceEdges: bool
    """showFaceEdges; default: False"""
    showFaces: bool
    """showFaces; default: True"""
    showLines: bool
    """showLines; default: True"""
    showMeshEdges: bool
    """showMeshEdges; default: True"""
    showMeshFaces: bool
    """showMeshFaces; default: True"""
    worldBasisSize: float
    """worldBasisSize; default: 1.0"""
    def __init__(self) -> None: ...
    def GetDictionary(self) -> dict[str, Any]: ...
    def SetDictionary(self, dictionary: dict[str, Any]) -> None: ...

class VSettingsViewWindow:
    """VSettingsViewWindow"""

    alwaysOnTop: bool
    """alwaysOnTop; default: False"""
    globalFontSize: float
    """globalFontSize; default: 12.0"""
    lockModelView: bool
    """lockModelView; default: False"""
    maximize: bool
    """maximize; default: False"""
    renderWindowSize: Sequence[int]
    """renderWindowSize [2]; default: [1024, 768]"""
    showComputationInfo: bool
    """showComputationInfo; default: True"""
    showMouseCoordinates: bool
    """showMouseCoordinates; default: False"""
    showRenderStateInfo: bool
    """showRenderStateInfo; default: False"""
    showWindow: bool
    """showWindow; default: True"""
    def __init__(self) -> None: ...
    def GetDictionary(self) -> dict[str, Any]: ...
    def SetDictionary(self, dictionary: dict[str, Any]) -> None: ...

class VSettingsView:
    """VSettingsView"""

    camera: VSettingsViewCamera
    scene: VSettingsViewScene
    window: VSettingsViewWindow
    def __init__(self) -> None: ...
    def GetDictionary(self) -> dict[str, Any]: ...
    def SetDictionary(self, dictionary: dict[str, Any]) -> None: ...

class VSettingsLight:
    """VSettingsLight"""

    constantAttenuation: float
    """constantAttenuation; default: 1.0"""
    diffuse: float
    """diffuse; default: 0.5"""
    enable: bool
    """enable; default: True"""
    lightRadius: float
    """lightRadius; default: 0.1"""
    linearAttenuation: float
    """linearAttenuation; default: 0.0"""
    position: ArrayLike
    """position [4]; default: [2.0, 2.0, 10.0, 0.0]"""
    quadraticAttenuation: float
    """quadraticAttenuation; default: 0.0"""
    shadow: float
    """shadow; default: 0.0"""
    specular: float
    """specular; default: 0.5"""
    useCameraFrame: bool
    """useCameraFrame; default: False"""
    def __init__(self) -> None: ...
    def GetDictionary(self) -> dict[str, Any]: ...
    def SetDictionary(self, dictionary: dict[str, Any]) -> None: ...

class VSettingsMaterial:
    """VSettingsMaterial"""

    alpha: float
    """alpha; default: 1.0"""
    baseColor: ArrayLike
    """baseColor [3]; default: [0.4, 0.4, 0.9]"""
    emission: ArrayLike
    """emission [3]; default: [0.0, 0.0, 0.0]"""
    ior: float
    """ior; default: 1.0"""
    name: str
    """name; default: 'default'"""
    reflectivity: float
    """reflectivity; default: 0.0"""
    shininess: float
    """shininess; default: 32.0"""
    specular: ArrayLike
    """specular [3]; default: [0.6, 0.6, 0.6]"""
    def __init__(self) -> None: ...
    def GetDictionary(self) -> dict[str, Any]: ...
    def SetDictionary(self, dictionary: dict[str, Any]) -> None: ...

class VSettingsNodes:
    """VSettingsNodes"""

    basisSize: float
    """basisSize; default: 0.2"""
    defaultColor: ArrayLike
    """defaultColor [4]; default: [0.2, 0.2, 1.0, 1.0]"""
    defaultSize: float
    """defaultSize; default: -1.0"""
    drawNodesAsPoint: bool
    """drawNodesAsPoint; default: True"""
    show: bool
    """show; default: True"""
    showBasis: bool
    """showBasis; default: False"""
    showNodalSlopes: int
    """showNodalSlopes; default: 0"""
    showNumbers: bool
    """showNumbers; default: False"""
    tiling: int
    """tiling; default: 4"""
    def __init__(self) -> None: ...
    def GetDictionary(self) -> dict[str, Any]: ...
    def SetDictionary(self, dictionary: dict[str, Any]) -> None: ...

class VSettingsBodiesBeams:
    """VSettingsBodiesBeams"""

    axialTiling: int
    """axialTiling; default: 8"""
    crossSectionFilled: bool
    """crossSectionFilled; default: True"""
    crossSectionTiling: int
    """crossSectionTiling; default: 4"""
    drawVertical: bool
    """drawVertical; default: False"""
    drawVerticalColor: ArrayLike
    """drawVerticalColor [4]; default: [0.2, 0.2, 0.2, 1.0]"""
    drawVerticalFactor: float
    """drawVerticalFactor; default: 1.0"""
    drawVerticalLines: bool
    """drawVerticalLines; default: True"""
    drawVerticalOffset: float
    """drawVerticalOffset; default: 0.0"""
    drawVerticalValues: bool
    """drawVerticalValues; default: False"""
    reducedAxialInterploation: bool
    """reducedAxialInterploation; default: True"""
    def __init__(self) -> None: ...
    def GetDictionary(self) -> dict[str, Any]: ...
    def SetDictionary(self, dictionary: dict[str, Any]) -> None: ...

class VSettingsBodiesKinematicTree:
    """VSettingsBodiesKinematicTree"""

    frameSize: float
    """frameSize; default: 0.2"""
    showCOMframes: bool
    """showCOMframes; default: False"""
    showFramesNumbers: bool
    """showFramesNumbers; default: False"""
    showJointFrames: bool
    """showJointFrames; default: True"""
    def __init__(self) -> None: ...
    def GetDictionary(self) -> dict[str, Any]: ...
    def SetDictionary(self, dictionary: dict[str, Any]) -> None: ...

class VSettingsBodiesShells:
    """VSettingsBodiesShells"""

    drawSolid: bool
    """drawSolid; default: True"""
    thicknessFactor: float
    """thicknessFactor; default: 1.0"""
    def __init__(self) -> None: ...
    def GetDictionary(self) -> dict[str, Any]: ...
    def SetDictionary(self, dictionary: dict[str, Any]) -> None: ...

class VSettingsBodies:
    """VSettingsBodies"""

    defaultColor: ArrayLike
    """defaultColor [4]; default: [0.3, 0.3, 1.0, 1.0]"""
    defaultSize: ArrayLike
    """defaultSize [3]; default: [1.0, 1.0, 1.0]"""
    deformationScaleFactor: float
    """deformationScaleFactor; default: 1.0"""
    show: bool
    """show; default: True"""
    showNumbers: bool
    """showNumbers; default: False"""
    beams: VSettingsBodiesBeams
    kinematicTree: VSettingsBodiesKinematicTree
    shells: VSettingsBodiesShells
    def __init__(self) -> None: ...
    def GetDictionary(self) -> dict[str, Any]: ...
    def SetDictionary(self, dictionary: dict[str, Any]) -> None: ...

class VSettingsConnectors:
    """VSettingsConnectors"""

    contactPointsDefaultSize: float
    """contactPointsDefaultSize; default: 0.02"""
    defaultColor: ArrayLike
    """defaultColor [4]; default: [0.2, 0.2, 1.0, 1.0]"""
    defaultSize: float
    """defaultSize; default: 0.1"""
    jointAxesLength: float
    """jointAxesLength; default: 0.2"""
    jointAxesRadius: float
    """jointAxesRadius; default: 0.02"""
    show: bool
    """show; default: True"""
    showContact: bool
    """showContact; default: False"""
    showJointAxes: bool
    """showJointAxes; default: False"""
    showNumbers: bool
    """showNumbers; default: False"""
    springNumberOfWindings: int
    """springNumberOfWindings; default: 8"""
    def __init__(self) -> None: ...
    def GetDictionary(self) -> dict[str, Any]: ...
    def SetDictionary(self, dictionary: dict[str, Any]) -> None: ...

class VSettingsMarkers:
    """VSettingsMarkers"""

    defaultColor: ArrayLike
    """defaultColor [4]; default: [0.1, 0.5, 0.1, 1.0]"""
    defaultSize: float
    """defaultSize; default: -1.0"""
    drawSimplified: bool
    """drawSimplified; default: True"""
    show: bool
    """show; default: True"""
    showNumbers: bool
    """showNumbers; default: False"""
    def __init__(self) -> None: ...
    def GetDictionary(self) -> dict[str, Any]: ...
    def SetDictionary(self, dictionary: dict[str, Any]) -> None: ...

class VSettingsLoads:
    """VSettingsLoads"""

    defaultColor: ArrayLike
    """defaultColor [4]; default: [0.7, 0.1, 0.1, 1.0]"""
    defaultRadius: float
    """defaultRadius; default: 0.005"""
    defaultSize: float
    """defaultSize; default: 0.2"""
    drawSimplified: bool
    """drawSimplified; default: True"""
    drawWithUserFunction: bool
    """drawWithUserFunction; default: True"""
    fixedLoadSize: bool
    """fixedLoadSize; default: True"""
    loadSizeFactor: float
    """loadSizeFactor; default: 0.1"""
    show: bool
    """show; default: True"""
    showNumbers: bool
    """showNumbers; default: False"""
    def __init__(self) -> None: ...
    def GetDictionary(self) -> dict[str, Any]: ...
    def SetDictionary(self, dictionary: dict[str, Any]) -> None: ...

class VSettingsSensorsTraces:
    """VSettingsSensorsTraces"""

    lineWidth: float
    """lineWidth; default: 2.0"""
    listOfPositionSensors: Sequence[int]
    """listOfPositionSensors [n]; default: []"""
    listOfTriadSensors: Sequence[int]
    """listOfTriadSensors [n]; default: []"""
    listOfVectorSensors: Sequence[int]
    """listOfVectorSensors [n]; default: []"""
    positionsShowEvery: int
    """positionsShowEvery; default: 1"""
    sensorsMbsNumber: int
    """sensorsMbsNumber; default: 0"""
    showCurrent: bool
    """showCurrent; default: True"""
    showFuture: bool
    """showFuture; default: False"""
    showPast: bool
    """showPast; default: True"""
    showPositionTrace: bool
    """showPositionTrace; default: False"""
    showTriads: bool
    """showTriads; default: False"""
    showVectors: bool
    """showVectors; default: False"""
    timeSpan: float
    """timeSpan; default: 0.0"""
    traceColors: ArrayLike
    """traceColors [n]; default: [0.2, 0.2, 0.2, 1.0, 0.8, 0.2, 0.2, 1.0, 0.2, 0.8, 0.2, 1.0, 0.2, 0.2, 0.8, 1.0, 0.2, 0.8, 0.8, 1.0, 0.8, 0.2, 0.8, 1.0, 0.8, 0.4, 0.1, 1.0]"""
    triadSize: float
    """triadSize; default: 0.1"""
    triadsShowEvery: int
    """triadsShowEvery; default: 1"""
    vectorScaling: float
    """vectorScaling; default: 0.01"""
    vectorsShowEvery: int
    """vectorsShowEvery; default: 1"""
    def __init__(self) -> None: ...
    def GetDictionary(self) -> dict[str, Any]: ...
    def SetDictionary(self, dictionary: dict[str, Any]) -> None: ...

class VSettingsSensors:
    """VSettingsSensors"""

    defaultColor: ArrayLike
    """defaultColor [4]; default: [0.6, 0.6, 0.1, 1.0]"""
    defaultSize: float
    """defaultSize; default: -1.0"""
    drawSimplified: bool
    """drawSimplified; default: True"""
    show: bool
    """show; default: True"""
    showNumbers: bool
    """showNumbers; default: False"""
    traces: VSettingsSensorsTraces
    def __init__(self) -> None: ...
    def GetDictionary(self) -> dict[str, Any]: ...
    def SetDictionary(self, dictionary: dict[str, Any]) -> None: ...

class VSettingsContourAdvanced:
    """VSettingsContourAdvanced"""

    colorBarPrecision: int
    """colorBarPrecision; default: 4"""
    colorBarTiling: int
    """colorBarTiling; default: 12"""
    contourColor0: ArrayLike
    """contourColor0 [4]; default: [0.1, 0.1, 0.9, 1.0]"""
    contourColor1: ArrayLike
    """contourColor1 [4]; default: [0.1, 0.9, 0.9, 1.0]"""
    contourColor2: ArrayLike
    """contourColor2 [4]; default: [0.1, 0.9, 0.1, 1.0]"""
    contourColor3: ArrayLike
    """contourColor3 [4]; default: [0.9, 0.9, 0.1, 1.0]"""
    contourColor4: ArrayLike
    """contourColor4 [4]; default: [0.9, 0.1, 0.1, 1.0]"""
    contourColorMax: ArrayLike
    """contourColorMax [4]; default: [0.9, 0.9, 0.9, 1.0]"""
    contourColorMin: ArrayLike
    """contourColorMin [4]; default: [0.1, 0.1, 0.1, 1.0]"""
    showColorBar: bool
    """showColorBar; default: True"""
    def __init__(self) -> None: ...
    def GetDictionary(self) -> dict[str, Any]: ...
    def SetDictionary(self, dictionary: dict[str, Any]) -> None: ...

class VSettingsContour:
    """VSettingsContour"""

    alphaTransparency: float
    """alphaTransparency; default: 1.0"""
    automaticRange: bool
    """automaticRange; default: True"""
    maxValue: float
    """maxValue; default: 1.0"""
    minValue: float
    """minValue; default: 0.0"""
    nodesColored: bool
    """nodesColored; default: True"""
    outputVariable: OutputVariableType
    """outputVariable; default: OutputVariableType._None"""
    outputVariableComponent: int
    """outputVariableComponent; default: 0"""
    reduceRange: bool
    """reduceRange; default: True"""
    rigidBodiesColored: bool
    """rigidBodiesColored; default: True"""
    advanced: VSettingsContourAdvanced
    def __init__(self) -> None: ...
    def GetDictionary(self) -> dict[str, Any]: ...
    def SetDictionary(self, dictionary: dict[str, Any]) -> None: ...

class VSettingsContact:
    """VSettingsContact"""

    colorBoundingBoxes: ArrayLike
    """colorBoundingBoxes [4]; default: [0.9, 0.1, 0.1, 1.0]"""
    colorSearchTree: ArrayLike
    """colorSearchTree [4]; default: [0.1, 0.1, 0.9, 1.0]"""
    colorSpheres: ArrayLike
    """colorSpheres [4]; default: [0.8, 0.5, 0.2, 1.0]"""
    colorTori: ArrayLike
    """colorTori [4]; default: [0.8, 0.2, 0.8, 1.0]"""
    colorTriangles: ArrayLike
    """colorTriangles [4]; default: [0.5, 0.5, 0.5, 1.0]"""
    contactForcesFactor: float
    """contactForcesFactor; default: 0.001"""
    contactPointsDefaultSize: float
    """contactPointsDefaultSize; default: 0.001"""
    showBoundingBoxes: bool
    """showBoundingBoxes; default: False"""
    showContactForces: bool
    """showContactForces; default: False"""
    showContactForcesValues: bool
    """showContactForcesValues; default: False"""
    showSearchTree: bool
    """showSearchTree; default: False"""
    showSearchTreeCells: bool
    """showSearchTreeCells; default: False"""
    showSpheres: bool
    """showSpheres; default: False"""
    showTori: bool
    """showTori; default: False"""
    showTriangles: bool
    """showTriangles; default: False"""
    tilingCurves: int
    """tilingCurves; default: 8"""
    tilingSpheres: int
    """tilingSpheres; default: 4"""
    def __init__(self) -> None: ...
    def GetDictionary(self) -> dict[str, Any]: ...
    def SetDictionary(self, dictionary: dict[str, Any]) -> None: ...

class VSettingsOpenGLAdvanced:
    """VSettingsOpenGLAdvanced"""

    clippingPlaneColor: ArrayLike
    """clippingPlaneColor [4]; default: [0.7, 0.5, 0.5, 0.0]"""
    depthSorting: bool
    """depthSorting; default: False"""
    enableLighting: bool
    """enableLighting; default: True"""
    faceNormalsColor: ArrayLike
    """faceNormalsColor [4]; default: [0.8, 0.2, 0.2, 1.0]"""
    initialCenterPoint: ArrayLike
    """initialCenterPoint [3]; default: [0.0, 0.0, 0.0]"""
    initialMaxSceneSize: float
    """initialMaxSceneSize; default: 1.0"""
    initialModelRotation: ArrayLike
    """initialModelRotation [3 x 3]; default: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]"""
    initialZoom: float
    """initialZoom; default: 1.0"""
    lightModelLocalViewer: bool
    """lightModelLocalViewer; default: False"""
    lightModelTwoSide: bool
    """lightModelTwoSide; default: False"""
    lineSmooth: bool
    """lineSmooth; default: True"""
    polygonOffset: float
    """polygonOffset; default: 0.05"""
    shadeModelSmooth: bool
    """shadeModelSmooth; default: True"""
    shadowPolygonOffset: float
    """shadowPolygonOffset; default: 0.1"""
    showBoundingBox: bool
    """showBoundingBox; default: False"""
    textLineSmooth: bool
    """textLineSmooth; default: False"""
    textLineWidth: float
    """textLineWidth; default: 1.0"""
    vertexNormalsColor: ArrayLike
    """vertexNormalsColor [4]; default: [0.8, 0.2, 0.2, 1.0]"""
    def __init__(self) -> None: ...
    def GetDictionary(self) -> dict[str, Any]: ...
    def SetDictionary(self, dictionary: dict[str, Any]) -> None: ...

class VSettingsOpenGL:
    """VSettingsOpenGL"""

    drawFaceNormals: bool
    """drawFaceNormals; default: False"""
    drawNormalsLength: float
    """drawNormalsLength; default: 0.1"""
    drawVertexNormals: bool
    """drawVertexNormals; default: False"""
    faceEdgesColor: ArrayLike
    """faceEdgesColor [4]; default: [0.2, 0.2, 0.2, 1.0]"""
    faceTransparencyGlobal: float
    """faceTransparencyGlobal; default: 0.4"""
    lightModelAmbient: ArrayLike
    """lightModelAmbient [4]; default: [0.4, 0.4, 0.4, 1.0]"""
    lineWidth: float
    """lineWidth; default: 1.0"""
    materialShininess: float
    """materialShininess; default: 32.0"""
    materialSpecular: ArrayLike
    """materialSpecular [4]; default: [0.6, 0.6, 0.6, 1.0]"""
    multiSampling: int
    """multiSampling; default: 1"""
    zMaxSceneFactor: float
    """zMaxSceneFactor; default: 2.0"""
    advanced: VSettingsOpenGLAdvanced
    light0: VSettingsLight
    light1: VSettingsLight
    light2: VSettingsLight
    light3: VSettingsLight
    def __init__(self) -> None: ...
    def GetDictionary(self) -> dict[str, Any]: ...
    def SetDictionary(self, dictionary: dict[str, Any]) -> None: ...

class VSettingsRaytracerAdvanced:
    """VSettingsRaytracerAdvanced"""

    backgroundColorReflections: ArrayLike
    """backgroundColorReflections [4]; default: [0.4, 0.4, 0.4, 1.0]"""
    searchTreeFactor: int
    """searchTreeFactor; default: 1"""
    shadowScalingFactor: int
    """shadowScalingFactor; default: 3"""
    shadowSmoothingSteps: int
    """shadowSmoothingSteps; default: 3"""
    showText: bool
    """showText; default: True"""
    tilesPerThread: int
    """tilesPerThread; default: 12"""
    zBiasLines: float
    """zBiasLines; default: 0.001"""
    def __init__(self) -> None: ...
    def GetDictionary(self) -> dict[str, Any]: ...
    def SetDictionary(self, dictionary: dict[str, Any]) -> None: ...

class VSettingsRaytracer:
    """VSettingsRaytracer"""

    globalFogColor: ArrayLike
    """globalFogColor [4]; default: [0.5, 0.5, 0.5, 1.0]"""
    globalFogDensity: float
    """globalFogDensity; default: 0.0"""
    imageSizeFactor: int
    """imageSizeFactor; default: 1"""
    keepWindowActive: bool
    """keepWindowActive; default: False"""
    lightRadiusVariations: int
    """lightRadiusVariations; default: 1"""
    maxReflectionDepth: int
    """maxReflectionDepth; default: 2"""
    maxTransparencyDepth: int
    """maxTransparencyDepth; default: 2"""
    multiSampling: int
    """multiSampling; default: 1"""
    numberOfThreads: int
    """numberOfThreads; default: 8"""
    verbose: int
    """verbose; default: 0"""
    advanced: VSettingsRaytracerAdvanced
    material0: VSettingsMaterial
    material1: VSettingsMaterial
    material2: VSettingsMaterial
    material3: VSettingsMaterial
    material4: VSettingsMaterial
    material5: VSettingsMaterial
    material6: VSettingsMaterial
    material7: VSettingsMaterial
    material8: VSettingsMaterial
    material9: VSettingsMaterial
    def __init__(self) -> None: ...
    def GetDictionary(self) -> dict[str, Any]: ...
    def SetDictionary(self, dictionary: dict[str, Any]) -> None: ...

class VSettingsGeneral:
    """VSettingsGeneral"""

    autoFitScene: bool
    """autoFitScene; default: True"""
    axesTiling: int
    """axesTiling; default: 12"""
    backgroundColor: ArrayLike
    """backgroundColor [4]; default: [1.0, 1.0, 1.0, 1.0]"""
    backgroundColorBottom: ArrayLike
    """backgroundColorBottom [4]; default: [0.8, 0.8, 1.0, 1.0]"""
    boundingBoxZoomAllFactor: float
    """boundingBoxZoomAllFactor; default: 1.2"""
    boundingBoxZoomAllOffset: float
    """boundingBoxZoomAllOffset; default: 0.01"""
    circleTiling: int
    """circleTiling; default: 16"""
    coordinateSystemSize: float
    """coordinateSystemSize; default: 5.0"""
    cylinderTiling: int
    """cylinderTiling; default: 16"""
    graphicsUpdateInterval: float
    """graphicsUpdateInterval; default: 0.1"""
    limitWindowToScreenSize: bool
    """limitWindowToScreenSize; default: True"""
    linuxDisplayScaleFactor: float
    """linuxDisplayScaleFactor; default: 1.0"""
    minSceneSize: float
    """minSceneSize; default: 0.1"""
    pointSize: float
    """pointSize; default: 0.01"""
    reallyQuitTimeLimit: float
    """reallyQuitTimeLimit; default: 900.0"""
    rendererPrecision: int
    """rendererPrecision; default: 4"""
    rendererStartupTimeout: int
    """rendererStartupTimeout; default: 2500"""
    renderWindowString: str
    """renderWindowString; default: ''"""
    showHelpOnStartup: int
    """showHelpOnStartup; default: 5"""
    showSolutionInformation: bool
    """showSolutionInformation; default: True"""
    showSolverInformation: bool
    """showSolverInformation; default: True"""
    showSolverTime: bool
    """showSolverTime; default: True"""
    sphereTiling: int
    """sphereTiling; default: 6"""
    textAlwaysInFront: bool
    """textAlwaysInFront; default: True"""
    textColor: ArrayLike
    """textColor [4]; default: [0.0, 0.0, 0.0, 1.0]"""
    textHasBackground: bool
    """textHasBackground; default: False"""
    textOffsetFactor: float
    """textOffsetFactor; default: 0.005"""
    threadSafeGraphicsUpdate: bool
    """threadSafeGraphicsUpdate; default: True"""
    useBitmapText: bool
    """useBitmapText; default: True"""
    useGradientBackground: bool
    """useGradientBackground; default: False"""
    useMultiThreadedRendering: bool
    """useMultiThreadedRendering; default: True"""
    useWindowsDisplayScaleFactor: bool
    """useWindowsDisplayScaleFactor; default: True"""
    zoomAllUseBoundingBox: bool
    """zoomAllUseBoundingBox; default: True"""
    def __init__(self) -> None: ...
    def GetDictionary(self) -> dict[str, Any]: ...
    def SetDictionary(self, dictionary: dict[str, Any]) -> None: ...

class VSettingsInteractiveAdvanced:
    """VSettingsInteractiveAdvanced"""

    highlightColor: ArrayLike
    """highlightColor [4]; default: [0.8, 0.05, 0.05, 0.75]"""
    highlightOtherColor: ArrayLike
    """highlightOtherColor [4]; default: [0.5, 0.5, 0.5, 0.4]"""
    joystickScaleRotation: float
    """joystickScaleRotation; default: 200.0"""
    joystickScaleTranslation: float
    """joystickScaleTranslation; default: 6.0"""
    keypressRotationStep: float
    """keypressRotationStep; default: 5.0"""
    keypressTranslationStep: float
    """keypressTranslationStep; default: 0.1"""
    mouseMoveRotationFactor: float
    """mouseMoveRotationFactor; default: 1.0"""
    pauseWithSpacebar: bool
    """pauseWithSpacebar; default: True"""
    selectionHighlights: bool
    """selectionHighlights; default: True"""
    selectionLeftMouse: bool
    """selectionLeftMouse; default: True"""
    selectionLeftMouseItemTypes: int
    """selectionLeftMouseItemTypes; default: 31"""
    selectionRightMouse: bool
    """selectionRightMouse; default: True"""
    selectionRightMouseGraphicsData: bool
    """selectionRightMouseGraphicsData; default: False"""
    zoomStepFactor: float
    """zoomStepFactor; default: 1.15"""
    def __init__(self) -> None: ...
    def GetDictionary(self) -> dict[str, Any]: ...
    def SetDictionary(self, dictionary: dict[str, Any]) -> None: ...

class VSettingsInteractiveOpenVR:
    """VSettingsInteractiveOpenVR"""

    actionManifestFileName: str
    """actionManifestFileName; default: 'C:/openVRactionsManifest.json'"""
    enable: bool
    """enable; default: False"""
    logLevel: int
    """logLevel; default: 1"""
    showCompanionWindow: bool
    """showCompanionWindow; default: True"""
    def __init__(self) -> None: ...
    def GetDictionary(self) -> dict[str, Any]: ...
    def SetDictionary(self, dictionary: dict[str, Any]) -> None: ...

class VSettingsInteractive:
    """VSettingsInteractive"""

    autoRotateModelView: bool
    """autoRotateModelView; default: False"""
    autoRotationVelocity: ArrayLike
    """autoRotationVelocity [3]; default: [0.0, 0.0, 1.047198]"""
    highlightItemIndex: int
    """highlightItemIndex; default: -1"""
    highlightItemType: ItemType
    """highlightItemType; default: ItemType._None"""
    highlightMbsNumber: int
    """highlightMbsNumber; default: 0"""
    ignoreKeys: bool
    """ignoreKeys; default: False"""
    logMouseCoordinates: bool
    """logMouseCoordinates; default: True"""
    useJoystickInput: bool
    """useJoystickInput; default: True"""
    advanced: VSettingsInteractiveAdvanced
    openVR: VSettingsInteractiveOpenVR
    def __init__(self) -> None: ...
    def GetDictionary(self) -> dict[str, Any]: ...
    def SetDictionary(self, dictionary: dict[str, Any]) -> None: ...

class VSettingsDialogs:
    """VSettingsDialogs"""

    alphaTransparency: float
    """alphaTransparency; default: 0.94"""
    alwaysTopmost: bool
    """alwaysTopmost; default: True"""
    fontScalingMacOS: float
    """fontScalingMacOS; default: 1.35"""
    multiThreadedDialogs: bool
    """multiThreadedDialogs; default: True"""
    openTreeView: bool
    """openTreeView; default: False"""
    def __init__(self) -> None: ...
    def GetDictionary(self) -> dict[str, Any]: ...
    def SetDictionary(self, dictionary: dict[str, Any]) -> None: ...

class VSettingsExportImages:
    """VSettingsExportImages"""

    heightAlignment: int
    """heightAlignment; default: 2"""
    saveImageAsTextCircles: bool
    """saveImageAsTextCircles; default: True"""
    saveImageAsTextLines: bool
    """saveImageAsTextLines; default: True"""
    saveImageAsTextTexts: bool
    """saveImageAsTextTexts; default: False"""
    saveImageAsTextTriangles: bool
    """saveImageAsTextTriangles; default: False"""
    saveImageFileCounter: int
    """saveImageFileCounter; default: 0"""
    saveImageFileName: str
    """saveImageFileName; default: 'images/frame'"""
    saveImageFormat: str
    """saveImageFormat; default: 'PNG'"""
    saveImageSingleFile: bool
    """saveImageSingleFile; default: False"""
    saveImageTimeOut: int
    """saveImageTimeOut; default: 5000"""
    widthAlignment: int
    """widthAlignment; default: 4"""
    def __init__(self) -> None: ...
    def GetDictionary(self) -> dict[str, Any]: ...
    def SetDictionary(self, dictionary: dict[str, Any]) -> None: ...

class VisualizationSettings:
    """VisualizationSettings"""

    nodes: VSettingsNodes
    bodies: VSettingsBodies
    connectors: VSettingsConnectors
    markers: VSettingsMarkers
    loads: VSettingsLoads
    sensors: VSettingsSensors
    contour: VSettingsContour
    contact: VSettingsContact
    view0: VSettingsView
    view1: VSettingsView
    view2: VSettingsView
    view3: VSettingsView
    openGL: VSettingsOpenGL
    raytracer: VSettingsRaytracer
    general: VSettingsGeneral
    interactive: VSettingsInteractive
    dialogs: VSettingsDialogs
    exportImages: VSettingsExportImages
    def __init__(self) -> None: ...
    def GetDictionary(self) -> dict[str, Any]: ...
    def SetDictionary(self, dictionary: dict[str, Any]) -> None: ...
