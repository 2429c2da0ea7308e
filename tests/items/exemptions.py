"""What tests of all items leave out: check by check, item by item, with the reason. `test_exemptions.py` holds each of them
against the check, so that one which is not needed any more fails."""

from __future__ import annotations

# ---- balance of moments between two bodies --------------------------------------------------------------------------------
# Laws along global axes, or on coordinates, exert no central forces: their moments do not balance.
NO_MOMENT = {
    "ObjectConnectorCartesianSpringDamper": "its forces are parallel, and not along the line through the markers",
    "ObjectConnectorRigidBodySpringDamper": "both markers get the force and the torque as they are, each at its own point",
    "ObjectConnectorReevingSystemSprings": "its dampers across and about the rope act on each sheave at its own place",
    "ObjectConnectorLinearSpringDamper": "its force acts along a prescribed axis",
    "ObjectConnectorRollingDiscPenalty": "the point of contact lies on the ground of marker 0",
}

# ---- invariance to rotations of the whole model ----------------------------------------------------------------------------
GLOBAL_AXES = {
    "ObjectConnectorCartesianSpringDamper": "stiffness and damping per global axis",
}
GLOBAL_MARKER = {
    "MarkerSuperElementRigid": "its axes are the global ones in the reference configuration, wherever the super element stands",
}

# ---- reactions as virtual work -----------------------------------------------------------------------------------------------
NONHOLONOMIC = {
    "ObjectJointRollingDisc": "its reaction is no gradient of a gap, but acts along derivatives of a rate by the velocities",
}
NOT_OF_VALUES = {
    "MarkerNodeRotationCoordinate": "the value is an angle, the rate a component of the angular velocity",
    "MarkerBodiesRelativeRotationCoordinate": "its angle is that of a rotation about the axis alone, whatever the others are",
}
NOT_OF_RATES = {
    "MarkerBodiesRelativeTranslationCoordinate": "its forces act at both points along the axis, without lever arm",
    "MarkerSuperElementRigid": "forces are distributed as for small rotations",
}
VELOCITY_LEVEL = {
    "ObjectConnectorCoordinateVector": "its equations are for velocities, the reaction acts along the slopes at the coordinates",
}

# ---- tangents ------------------------------------------------------------------------------------------------------------------
HOLDS_JACOBIAN = {
    "ObjectConnectorCoordinateVector": "the Jacobian that a user gives is held fixed: its own derivatives, times multipliers or "
    "velocities, are not in the tangent",
}

# ---- solutions -----------------------------------------------------------------------------------------------------------------
ODD_IN_JOINTS = {
    "ObjectMass1D": "cannot follow a joint of frames: it moves along one line",
    "ObjectRotationalMass1D": "cannot follow a joint of frames: it turns about one axis",
    "ObjectANCFCable": "a random state of it is no equilibrium: stiff forces tear at a joint",
    "ObjectANCFCable2D": "a random state of it is no equilibrium: stiff forces tear at a joint",
    "ObjectBeamGeometricallyExact": "a random state of it is no equilibrium: stiff forces tear at a joint",
    "ObjectGenericODE2": "its markers are those of small deformations, which random states are not",
}

# ---- outputs --------------------------------------------------------------------------------------------------------------------
_IN_J0 = "velocities of the markers in the axes of J0, without the rotation of J0 itself"
_TRAIL = "the velocity along the trail is that relative to the plane, which moves"
_LOCAL = "velocities of the node are components of the angular velocity, not rates of the rotation vector"
RATE_OF_OUTPUTS = {
    ("NodeRigidBodyRotVecLG", "Coordinates"): _LOCAL,
    ("NodeRigidBodyRotVecLG", "CoordinatesTotal"): _LOCAL,
    ("ObjectConnectorLinearSpringDamper", "DisplacementLocal"): _IN_J0,
    ("ObjectConnectorRigidBodySpringDamper", "DisplacementLocal"): _IN_J0,
    ("ObjectConnectorRollingDiscPenalty", "Position"): _TRAIL,
    ("ObjectJointGeneric", "DisplacementLocal"): _IN_J0,
    ("ObjectJointPrismaticX", "DisplacementLocal"): _IN_J0,
    ("ObjectJointRevoluteZ", "DisplacementLocal"): _IN_J0,
    ("ObjectJointRollingDisc", "Position"): _TRAIL,
    ("ObjectJointSpherical", "Displacement"): "its velocity is that of marker 0",
}
