# Generated from specs/enums/ by codegen/templates/core_enums.pyi.j2. Do not edit; run `python -m codegen`.
# tests/codegen/test_freshness.py compares this file with its sources.

from enum import IntEnum, IntFlag

class AccessFunctionType(IntFlag):
    """derivatives and integrals of kinematic quantities that an object offers to markers"""

    _None = 0
    """none"""
    TranslationalVelocity_qt = 32
    """derivative of the velocity of a local point with respect to the velocity coordinates: the Jacobian of positions"""
    AngularVelocity_qt = 64
    """derivative of the angular velocity at a local point with respect to the velocity coordinates: the Jacobian of rotations"""
    Coordinate_q = 128
    """derivative of a single generalized coordinate with respect to the coordinates"""
    DisplacementLineIntegral_q = 512
    """derivative of the integral of the displacement over a line, for loads per length"""
    DisplacementSurfaceIntegral_q = 1024
    """derivative of the integral of the displacement over a surface, for loads per area"""
    DisplacementVolumeIntegral_q = 2048
    """derivative of the integral of the displacement over the volume, for loads per volume"""
    DisplacementMassIntegral_q = 4096
    """derivative of the integral of the displacement over the mass, for gravity and other mass proportional loads"""
    DisplacementSurfaceNormalIntegral_q = 8192
    """derivative of the integral of the displacement along the surface normal, for pressure"""

class ConfigurationType(IntEnum):
    """the state of the model that an output or a vector of coordinates is taken from"""

    _None = 0
    """no configuration; not accepted where a state is needed"""
    Initial = 1
    """state at the start of a computation, as given by the initial values of the nodes"""
    Current = 2
    """state that the solver has reached; after a computation its final state"""
    Reference = 3
    """undeformed state that the reference coordinates describe; velocities are zero"""
    StartOfStep = 4
    """state at the start of the step that is being computed; the last converged state"""
    Visualization = 5
    """state that is drawn; updated at intervals, so that it may lag behind the current one"""
    EndOfEnumList = 6
    """number of the values before; not a configuration"""

class ContactTypeIndex(IntEnum):
    """kinds of contact partners in general contact, as indices"""

    IndexSpheresMarkerBased = 0
    """spheres at markers"""
    IndexANCFCable2D = 1
    """surfaces of planar cable elements"""
    IndexTrigsRigidBodyBased = 2
    """triangles fixed to rigid bodies"""
    IndexEndOfEnumList = 3
    """number of the values before; not a kind of contact"""
    IndexConvexMarkerBased = 4
    """boxes, cylinders, capsules and convex hulls at markers"""
    IndexPlanesRigidBodyBased = 5
    """planes fixed to rigid bodies"""

class CrossSectionType(IntEnum):
    """shape of the cross section of a beam, for drawing and contact"""

    Polygon = 1
    """polygon, given by its corners"""
    Circular = 2
    """circle, given by its radius"""

class DynamicSolverType(IntEnum):
    """time integration methods"""

    GeneralizedAlpha = 1
    """implicit, second order with adjustable numerical damping, for all models; its parameters are in ``timeIntegration.generalizedAlpha``"""
    TrapezoidalIndex2 = 2
    """implicit trapezoidal rule (Newmark) with constraints on velocity level; second order, no numerical damping"""
    ExplicitEuler = 3
    """explicit, first order, one evaluation per step"""
    ExplicitMidpoint = 4
    """explicit, second order, two evaluations per step"""
    RK33 = 5
    """explicit Runge-Kutta method of order 3 with three stages and fixed step"""
    RK44 = 6
    """explicit Runge-Kutta method of order 4 with four stages and fixed step"""
    RK67 = 7
    """explicit Runge-Kutta method of order 6 with seven stages and fixed step"""
    ODE23 = 8
    """explicit Runge-Kutta method of Bogacki and Shampine, order 3 with error estimate of order 2 and automatic step size"""
    DOPRI5 = 9
    """explicit Runge-Kutta method of Dormand and Prince, order 5 with error estimate of order 4 and automatic step size"""
    DVERK6 = 10
    """named for scripts of Exudyn; no solver has it and ``solverType`` refuses it: ``DOPRI5`` and ``DOP853`` are of orders 5 and 8"""
    VelocityVerlet = 11
    """explicit, second order (first where forces depend on velocities), one evaluation per step; suitable for particles and contact"""
    DOP853 = 12
    """explicit Runge-Kutta method of Dormand and Prince, order 8 with error estimates of orders 5 and 3 and automatic step size; suitable for tight tolerances"""
    ESDIRK43 = 13
    """diagonally implicit Runge-Kutta method of Kennedy and Carpenter, order 4 with error estimate of order 3 and automatic step size; L-stable, for stiff systems and higher accuracy than generalized alpha"""

class ItemType(IntEnum):
    """the five kinds of items"""

    _None = 0
    """no item"""
    Node = 1
    """node: coordinates"""
    Object = 2
    """object: body, connector, constraint, joint, contact or finite element"""
    Marker = 3
    """marker: a point or frame of a node or object at which loads and connectors act"""
    Load = 4
    """load: force, torque or generalized force"""
    Sensor = 5
    """sensor: a measured output"""

class JointType(IntEnum):
    """joints of a kinematic tree, each with one coordinate; axes are those of the joint frame"""

    _None = 0
    """no joint; refused in a kinematic tree"""
    RevoluteX = 1
    """rotation about the x-axis, coordinate in rad"""
    RevoluteY = 2
    """rotation about the y-axis, coordinate in rad"""
    RevoluteZ = 3
    """rotation about the z-axis, coordinate in rad"""
    PrismaticX = 4
    """translation along the x-axis, coordinate in m"""
    PrismaticY = 5
    """translation along the y-axis, coordinate in m"""
    PrismaticZ = 6
    """translation along the z-axis, coordinate in m"""

class KeyCode(IntEnum):
    """keys without a character, as passed to a key press user function; keys with a character are passed as that character's code"""

    SPACE = 32
    """space bar"""
    ENTER = 257
    """enter key"""
    TAB = 258
    """tabulator key"""
    BACKSPACE = 259
    """backspace key"""
    RIGHT = 262
    """cursor right"""
    LEFT = 263
    """cursor left"""
    DOWN = 264
    """cursor down"""
    UP = 265
    """cursor up"""
    F1 = 291
    """function key F1"""
    F2 = 292
    """function key F2"""
    F3 = 293
    """function key F3"""
    F4 = 294
    """function key F4"""
    F5 = 295
    """function key F5"""
    F6 = 296
    """function key F6"""
    F7 = 297
    """function key F7"""
    F8 = 298
    """function key F8"""
    F9 = 299
    """function key F9"""
    F10 = 300
    """function key F10"""

class LinearSolverType(IntFlag):
    """direct solvers for linear systems of equations"""

    _None = 0
    """no solver; refused"""
    EXUdense = 1
    """dense factorization with partial pivoting; suitable for small systems"""
    EigenSparse = 2
    """sparse LU factorization; suitable for models with many coordinates"""
    EigenSparseSymmetric = 4
    """sparse factorization for symmetric positive definite systems; not for models with constraints or unsymmetric forces"""
    EigenDense = 8
    """dense factorization with full pivoting, which tolerates redundant constraints; slower than the other dense one"""

class NodeGroup(IntFlag):
    """kinds of coordinates that a node has; values can be joined"""

    _None = 0
    """no coordinates"""
    ODE1variables = 1
    """coordinates of first order differential equations"""
    ODE2variables = 2
    """coordinates of second order differential equations"""
    AEvariables = 4
    """algebraic variables"""
    DataVariables = 8
    """data variables"""

class NodeType(IntFlag):
    """capabilities of a node; values can be combined"""

    _None = 0
    """nothing"""
    Ground = 1
    """fixed node without coordinates"""
    Position2D = 2
    """position in the x-y plane"""
    Orientation2D = 4
    """rotation about z"""
    Point2DSlope1 = 8
    """position and one slope vector in the plane"""
    Position = 16
    """position in space"""
    Orientation = 32
    """orientation in space"""
    RigidBody = 64
    """displacements and rotations of a rigid body"""
    RotationEulerParameters = 128
    """rotation by Euler parameters"""
    RotationRxyz = 256
    """rotation by Tait-Bryan angles about x, y and z"""
    RotationRotationVector = 512
    """rotation by a rotation vector"""
    LieGroupWithDirectUpdate = 1024
    """rotation that integrators update by composition on the Lie group instead of by sums"""
    GenericODE2 = 4096
    """second order coordinates without a meaning in space"""
    GenericODE1 = 8192
    """first order coordinates"""
    GenericAE = 16384
    """algebraic variables"""
    GenericData = 32768
    """data variables"""
    PointSlope1 = 65536
    """position and one slope vector"""
    PointSlope12 = 131072
    """position and the slope vectors in x and y"""
    PointSlope23 = 262144
    """position and the slope vectors in y and z"""

class ObjectType(IntFlag):
    """categories of an object; values can be combined"""

    _None = 0
    """none of the following"""
    Ground = 2
    """ground without coordinates"""
    Constraint = 4
    """algebraic equations between markers"""
    Connector = 8
    """forces between markers; also the base of constraints and joints"""
    Body = 16
    """has local points with position, so that body markers can be attached"""
    SingleNoded = 32
    """uses one node"""
    MultiNoded = 64
    """uses several nodes"""
    FiniteElement = 128
    """finite element"""
    SuperElement = 256
    """many mesh nodes, reached by super element markers and outputs"""
    EndOfEnumList = 1024
    """upper bound of the values; not a kind of object"""

class OutputVariableType(IntEnum):
    """quantities that items offer to outputs and sensors; the page of an item lists those that it has, with size and frame"""

    _None = 0
    """no output variable; sensors refuse it"""
    Distance = 1
    """distance between two points, or gap of a contact"""
    Position = 2
    """position in global coordinates"""
    Displacement = 4
    """displacement from the reference configuration in global coordinates; connectors have the relative displacement"""
    DisplacementLocal = 8
    """displacement in local coordinates, of body or joint"""
    Velocity = 16
    """velocity in global coordinates; connectors have the relative velocity"""
    VelocityLocal = 32
    """velocity in local coordinates, of body or joint"""
    Acceleration = 64
    """acceleration in global coordinates"""
    AccelerationLocal = 128
    """acceleration in body coordinates"""
    RotationMatrix = 256
    """nine components of the rotation matrix from body to global frame, row by row"""
    Rotation = 8192
    """angles: three Tait-Bryan angles about x, y and z, or one angle for planar items"""
    AngularVelocity = 512
    """angular velocity in global coordinates"""
    AngularVelocityLocal = 1024
    """angular velocity in local coordinates, of body or joint"""
    AngularAcceleration = 2048
    """angular acceleration in global coordinates"""
    AngularAccelerationLocal = 4096
    """angular acceleration in body coordinates"""
    CoordinatesTotal = 16384
    """coordinates including the reference coordinates"""
    Coordinates = 32768
    """coordinates relative to the reference coordinates"""
    Coordinates_t = 65536
    """first time derivatives of the coordinates"""
    Coordinates_tt = 131072
    """second time derivatives of the coordinates"""
    SlidingCoordinate = 262144
    """path along a beam or curve, of sliding joints"""
    Director1 = 524288
    """first direction: slope or axis vector in x"""
    Director2 = 1048576
    """second direction: slope or axis vector in y"""
    Director3 = 2097152
    """third direction: slope or axis vector in z"""
    Force = 4194304
    """force in global coordinates; super elements have the generalized forces"""
    ForceLocal = 8388608
    """force in local coordinates; beams have the section forces"""
    Torque = 16777216
    """torque in global coordinates"""
    TorqueLocal = 33554432
    """torque in local coordinates; beams have the section moments"""
    NonUniqueReactions = 67108864
    """number of equations of a constraint or joint whose reactions are not unique, because constraints are redundant; solvers return the minimum-norm ones. NaN before the first solution"""
    WrenchOnMarker0 = 134217728
    """force (N) and torque (Nm) that a connector, joint or constraint exerts on the body of its first marker, in global axes; six components. Markers of coordinates have the generalized forces instead. The sign is the same in statics and dynamics"""
    WrenchOnMarker1 = 134217729
    """the same for the second marker"""
    WrenchOnMarker0Local = 134217730
    """components of ``WrenchOnMarker0`` in joint frame J0, or in the frame of the marker if the item has no ``rotationMarker0``"""
    WrenchOnMarker1Local = 134217731
    """components of ``WrenchOnMarker1`` in joint frame J1, or in the frame of the marker if the item has no ``rotationMarker1``"""
    StrainLocal = 268435456
    """strain components in the local frame"""
    StressLocal = 536870912
    """stress components in the local frame"""
    CurvatureLocal = 1073741824
    """curvature and twist in the local frame"""
    ConstraintEquation = 2147483648
    """residual of the constraint equations of a constraint or joint"""
    KineticEnergy = 4294967296
    """kinetic energy of a body, of all of its points"""
    PotentialEnergy = 8589934592
    """energy that a body or connector stores: strain energy, and the potential of forces among its own parameters, such as the gravity of a kinematic tree; loads are not included"""
    HomogeneousTransformation = 17179869184
    """position and rotation as a 4 x 4 matrix: from the body frame to the global frame; of joints, frame J0. Output functions return ``exu.HT``, sensors have the 16 entries, row by row"""
    HomogeneousTransformationLocal = 34359738368
    """relative position and rotation of joint frame J1 in joint frame J0 as a 4 x 4 matrix"""
