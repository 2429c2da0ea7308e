# Generated from specs/ by codegen/templates/function_sizes.py.j2. Do not edit; run `python -m codegen`.
# tests/codegen/test_freshness.py compares this file with its sources.
"""How many entries vectors, and rows matrices, have that user functions receive, in the order of their arguments.

NODES: as many as the nodes of the item have coordinates. ASSEMBLE: what is known at Assemble() only.
"""

NODES, ASSEMBLE = -1, -2

SIZES: dict[tuple[str, str], tuple[int, ...]] = {
    ("ObjectGenericODE1", "rhsUserFunction"): (NODES,),
    ("ObjectFFRF", "forceUserFunction"): (NODES, NODES),
    ("ObjectFFRF", "massMatrixUserFunction"): (NODES, NODES),
    ("ObjectFFRFreducedOrder", "forceUserFunction"): (NODES, NODES),
    ("ObjectFFRFreducedOrder", "massMatrixUserFunction"): (NODES, NODES),
    ("ObjectGenericODE2", "forceUserFunction"): (NODES, NODES),
    ("ObjectGenericODE2", "massMatrixUserFunction"): (NODES, NODES),
    ("ObjectGenericODE2", "jacobianUserFunction"): (NODES, NODES),
    ("ObjectKinematicTree", "forceUserFunction"): (NODES, NODES),
    ("ObjectConnectorCartesianSpringDamper", "springForceUserFunction"): (3, 3, 3, 3, 3),
    ("ObjectConnectorLaw", "forceUserFunction"): (ASSEMBLE, ASSEMBLE, ASSEMBLE),
    ("ObjectConnectorLaw", "stateRateUserFunction"): (ASSEMBLE, ASSEMBLE, ASSEMBLE),
    ("ObjectConnectorLaw", "historyUserFunction"): (ASSEMBLE, ASSEMBLE, ASSEMBLE),
    ("ObjectConnectorRigidBodySpringDamper", "springForceTorqueUserFunction"): (3, 3, 3, 3, 6, 6, 3, 3, 6),
    ("ObjectConnectorRigidBodySpringDamper", "postNewtonStepUserFunction"): (ASSEMBLE, 3, 3, 3, 3, 6, 6, 3, 3, 6),
    ("ObjectConnectorCoordinateVector", "constraintUserFunction"): (ASSEMBLE, ASSEMBLE),
    ("ObjectConnectorCoordinateVector", "jacobianUserFunction"): (ASSEMBLE, ASSEMBLE),
    ("ObjectJointGeneric", "offsetUserFunction"): (6,),
    ("ObjectJointGeneric", "offsetUserFunction_t"): (6,),
    ("LoadForceVector", "loadVectorUserFunction"): (3,),
    ("LoadMassProportional", "loadVectorUserFunction"): (3,),
    ("LoadTorqueVector", "loadVectorUserFunction"): (3,),
    ("SensorUserFunction", "sensorUserFunction"): (ASSEMBLE,),
}
