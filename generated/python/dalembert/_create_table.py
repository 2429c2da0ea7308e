# Generated from specs/ by codegen/templates/create_table.py.j2. Do not edit; run `python -m codegen`.
# tests/codegen/test_freshness.py compares this file with its sources.
"""The items whose parameters a Create function passes on; the first that has a parameter describes it."""

MIRRORS: dict[str, tuple[str, ...]] = {
    "CreateCartesianSpringDamper": ("ObjectConnectorCartesianSpringDamper",),
    "CreateCoordinateConstraint": ("ObjectConnectorCoordinate",),
    "CreateDistanceConstraint": ("ObjectConnectorDistance",),
    "CreateDistanceSensor": ("SensorUserFunction",),
    "CreateFFRFReducedOrderObject": ("ObjectFFRFreducedOrder",),
    "CreateForce": ("LoadForceVector",),
    "CreateGenericJoint": ("ObjectJointGeneric",),
    "CreateGround": ("ObjectGround",),
    "CreateKinematicTree": ("ObjectKinematicTree", "NodeGenericODE2",),
    "CreateLinearSpringDamper": ("ObjectConnectorLinearSpringDamper",),
    "CreateMassPoint": ("ObjectMassPoint", "ObjectMassPoint2D", "NodePoint", "NodePoint2D",),
    "CreatePrismaticJoint": ("ObjectJointPrismaticX",),
    "CreateRevoluteJoint": ("ObjectJointRevoluteZ",),
    "CreateRigidBody": ("ObjectRigidBody", "ObjectRigidBody2D", "NodeRigidBodyEP", "NodeRigidBodyRotVecLG", "NodeRigidBodyRxyz", "NodeRigidBody2D",),
    "CreateRigidBodySpringDamper": ("ObjectConnectorRigidBodySpringDamper",),
    "CreateRobot": ("ObjectKinematicTree",),
    "CreateRollingDisc": ("ObjectJointRollingDisc",),
    "CreateRollingDiscPenalty": ("ObjectConnectorRollingDiscPenalty",),
    "CreateSphereQuadContact": ("ObjectContactSphereTriangle",),
    "CreateSphereSphereContact": ("ObjectContactSphereSphere",),
    "CreateSphereTriangleContact": ("ObjectContactSphereTriangle",),
    "CreateSphericalJoint": ("ObjectJointSpherical",),
    "CreateSpringDamper": ("ObjectConnectorSpringDamper",),
    "CreateTorque": ("LoadTorqueVector",),
    "CreateTorsionalSpringDamper": ("ObjectConnectorTorsionalSpringDamper",),
}
