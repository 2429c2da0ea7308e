# Generated from specs/enums/ by codegen/templates/core_enums.pyi.j2. Do not edit; run `python -m codegen`.
# tests/codegen/test_freshness.py compares this file with its sources.

from enum import IntEnum

class AccessFunctionType(IntEnum):
    """AccessFunctionType"""

    _None = 0
    """_None"""
    TranslationalVelocity_qt = 32
    """TranslationalVelocity_qt"""
    AngularVelocity_qt = 64
    """AngularVelocity_qt"""
    Coordinate_q = 128
    """Coordinate_q"""
    DisplacementLineIntegral_q = 512
    """DisplacementLineIntegral_q"""
    DisplacementSurfaceIntegral_q = 1024
    """DisplacementSurfaceIntegral_q"""
    DisplacementVolumeIntegral_q = 2048
    """DisplacementVolumeIntegral_q"""
    DisplacementMassIntegral_q = 4096
    """DisplacementMassIntegral_q"""
    DisplacementSurfaceNormalIntegral_q = 8192
    """DisplacementSurfaceNormalIntegral_q"""

class ConfigurationType(IntEnum):
    """ConfigurationType"""

    _None = 0
    """_None"""
    Initial = 1
    """Initial"""
    Current = 2
    """Current"""
    Reference = 3
    """Reference"""
    StartOfStep = 4
    """StartOfStep"""
    Visualization = 5
    """Visualization"""
    EndOfEnumList = 6
    """EndOfEnumList"""

class ContactTypeIndex(IntEnum):
    """ContactTypeIndex"""

    IndexSpheresMarkerBased = 0
    """IndexSpheresMarkerBased"""
    IndexANCFCable2D = 1
    """IndexANCFCable2D"""
    IndexTrigsRigidBodyBased = 2
    """IndexTrigsRigidBodyBased"""
    IndexEndOfEnumList = 3
    """IndexEndOfEnumList"""

class CrossSectionType(IntEnum):
    """CrossSectionType"""

    Polygon = 1
    """Polygon"""
    Circular = 2
    """Circular"""

class DynamicSolverType(IntEnum):
    """DynamicSolverType"""

    GeneralizedAlpha = 1
    """GeneralizedAlpha"""
    TrapezoidalIndex2 = 2
    """TrapezoidalIndex2"""
    ExplicitEuler = 3
    """ExplicitEuler"""
    ExplicitMidpoint = 4
    """ExplicitMidpoint"""
    RK33 = 5
    """RK33"""
    RK44 = 6
    """RK44"""
    RK67 = 7
    """RK67"""
    ODE23 = 8
    """ODE23"""
    DOPRI5 = 9
    """DOPRI5"""
    DVERK6 = 10
    """DVERK6"""
    VelocityVerlet = 11
    """VelocityVerlet"""

class ItemType(IntEnum):
    """ItemType"""

    _None = 0
    """_None"""
    Node = 1
    """Node"""
    Object = 2
    """Object"""
    Marker = 3
    """Marker"""
    Load = 4
    """Load"""
    Sensor = 5
    """Sensor"""

class JointType(IntEnum):
    """JointType"""

    _None = 0
    """_None"""
    RevoluteX = 1
    """RevoluteX"""
    RevoluteY = 2
    """RevoluteY"""
    RevoluteZ = 3
    """RevoluteZ"""
    PrismaticX = 4
    """PrismaticX"""
    PrismaticY = 5
    """PrismaticY"""
    PrismaticZ = 6
    """PrismaticZ"""

class KeyCode(IntEnum):
    """KeyCode"""

    SPACE = 32
    """SPACE"""
    ENTER = 257
    """ENTER"""
    TAB = 258
    """TAB"""
    BACKSPACE = 259
    """BACKSPACE"""
    RIGHT = 262
    """RIGHT"""
    LEFT = 263
    """LEFT"""
    DOWN = 264
    """DOWN"""
    UP = 265
    """UP"""
    F1 = 291
    """F1"""
    F2 = 292
    """F2"""
    F3 = 293
    """F3"""
    F4 = 294
    """F4"""
    F5 = 295
    """F5"""
    F6 = 296
    """F6"""
    F7 = 297
    """F7"""
    F8 = 298
    """F8"""
    F9 = 299
    """F9"""
    F10 = 300
    """F10"""

class LinearSolverType(IntEnum):
    """LinearSolverType"""

    _None = 0
    """_None"""
    EXUdense = 1
    """EXUdense"""
    EigenSparse = 2
    """EigenSparse"""
    EigenSparseSymmetric = 4
    """EigenSparseSymmetric"""
    EigenDense = 8
    """EigenDense"""

class NodeGroup(IntEnum):
    """NodeGroup"""

    _None = 0
    """_None"""
    ODE1variables = 1
    """ODE1variables"""
    ODE2variables = 2
    """ODE2variables"""
    AEvariables = 4
    """AEvariables"""
    DataVariables = 8
    """DataVariables"""

class NodeType(IntEnum):
    """NodeType"""

    _None = 0
    """_None"""
    Ground = 1
    """Ground"""
    Position2D = 2
    """Position2D"""
    Orientation2D = 4
    """Orientation2D"""
    Point2DSlope1 = 8
    """Point2DSlope1"""
    Position = 16
    """Position"""
    Orientation = 32
    """Orientation"""
    RigidBody = 64
    """RigidBody"""
    RotationEulerParameters = 128
    """RotationEulerParameters"""
    RotationRxyz = 256
    """RotationRxyz"""
    RotationRotationVector = 512
    """RotationRotationVector"""
    LieGroupWithDirectUpdate = 1024
    """LieGroupWithDirectUpdate"""
    GenericODE2 = 4096
    """GenericODE2"""
    GenericODE1 = 8192
    """GenericODE1"""
    GenericAE = 16384
    """GenericAE"""
    GenericData = 32768
    """GenericData"""
    PointSlope1 = 65536
    """PointSlope1"""
    PointSlope12 = 131072
    """PointSlope12"""
    PointSlope23 = 262144
    """PointSlope23"""

class ObjectType(IntEnum):
    """ObjectType"""

    _None = 0
    """_None"""
    Ground = 2
    """Ground"""
    Constraint = 4
    """Constraint"""
    Connector = 8
    """Connector"""
    Body = 16
    """Body"""
    SingleNoded = 32
    """SingleNoded"""
    MultiNoded = 64
    """MultiNoded"""
    FiniteElement = 128
    """FiniteElement"""
    SuperElement = 256
    """SuperElement"""
    EndOfEnumList = 1024
    """EndOfEnumList"""

class OutputVariableType(IntEnum):
    """OutputVariableType"""

    _None = 0
    """_None"""
    Distance = 1
    """Distance"""
    Position = 2
    """Position"""
    Displacement = 4
    """Displacement"""
    DisplacementLocal = 8
    """DisplacementLocal"""
    Velocity = 16
    """Velocity"""
    VelocityLocal = 32
    """VelocityLocal"""
    Acceleration = 64
    """Acceleration"""
    AccelerationLocal = 128
    """AccelerationLocal"""
    RotationMatrix = 256
    """RotationMatrix"""
    Rotation = 8192
    """Rotation"""
    AngularVelocity = 512
    """AngularVelocity"""
    AngularVelocityLocal = 1024
    """AngularVelocityLocal"""
    AngularAcceleration = 2048
    """AngularAcceleration"""
    AngularAccelerationLocal = 4096
    """AngularAccelerationLocal"""
    CoordinatesTotal = 16384
    """CoordinatesTotal"""
    Coordinates = 32768
    """Coordinates"""
    Coordinates_t = 65536
    """Coordinates_t"""
    Coordinates_tt = 131072
    """Coordinates_tt"""
    SlidingCoordinate = 262144
    """SlidingCoordinate"""
    Director1 = 524288
    """Director1"""
    Director2 = 1048576
    """Director2"""
    Director3 = 2097152
    """Director3"""
    Force = 4194304
    """Force"""
    ForceLocal = 8388608
    """ForceLocal"""
    Torque = 16777216
    """Torque"""
    TorqueLocal = 33554432
    """TorqueLocal"""
    StrainLocal = 268435456
    """StrainLocal"""
    StressLocal = 536870912
    """StressLocal"""
    CurvatureLocal = 1073741824
    """CurvatureLocal"""
    ConstraintEquation = 2147483648
    """ConstraintEquation"""
