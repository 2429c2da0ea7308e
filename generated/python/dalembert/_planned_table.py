# Generated from specs/ by codegen/templates/planned_table.py.j2. Do not edit; run `python -m codegen`.
# tests/codegen/test_freshness.py compares this file with its sources.
"""What the interface has and the package does not have yet."""

from typing import NamedTuple


class Planned(NamedTuple):
    """What it is for, what to do until it is there, and which members are planned if it is not the whole."""

    what: str
    instead: str
    members: tuple[str, ...]


ITEMS = (
    "NodeGenericAE",
    "NodePointSlope12",
    "NodePointSlope23",
    "ObjectFFRF",
    "ObjectKinematicTree",
    "ObjectALEANCFCable2D",
    "ObjectANCFBeam",
    "ObjectANCFThinPlate",
    "ObjectBeamGeometricallyExact2D",
    "ObjectContactConvexRoll",
    "ObjectContactCurveCircles",
    "ObjectContactFrictionCircleCable2D",
    "ObjectContactSphereSphere",
    "ObjectContactSphereTriangle",
    "ObjectJointALEMoving2D",
    "ObjectJointSliding",
    "MarkerBodyBeamShape",
    "MarkerKinematicTreeRigid",
    "SensorKinematicTree",
)
MODULES = {
    "robotics.future": Planned('inverse kinematics of standard robots', '', ()),
    "robotics.mobile": Planned('vehicles with mecanum wheels', '', ()),
    "robotics.special": Planned('measures of manipulability', '', ()),
    "robotics.utilities": Planned('lidar sensors, robots from URDF files', '', ()),
    "rosInterface": Planned('publishers and subscribers of ROS', 'talk to ROS in a PreStep user function, or by CreateTCPIPconnection', ()),
}
FUNCTIONS = {
    "FEM.FEMinterface": Planned('meshes and modes for flexible bodies', 'read matrices by the Read... functions of dalembert.FEM, and add them as ObjectGenericODE2', ('CheckConsistency', 'ComputeCampbellDiagram', 'ComputeEigenModesWithBoundaryNodes', 'ComputeEigenmodesNGsolve', 'ComputeHurtyCraigBamptonModes', 'ComputeHurtyCraigBamptonModesNGsolve', 'ComputePostProcessingModes', 'ComputePostProcessingModesNGsolve', 'ConvertElementsLists2Numpy', 'ConvertSurfaceLists2Numpy', 'CreateLinearFEMObjectGenericODE2', 'CreateNGsolveBoundaryNodeSets', 'CreateNonlinearFEMObjectGenericODE2NGsolve', 'GetBoundaryNodeSetsAsLists', 'GetGyroscopicMatrix', 'GetNodeWeightsFromSurfaceAreas', 'GetNodesOfNGsolveBoundary', 'GetRigidBodyInertia', 'GetSurfaceTriangles', 'ImportFromAbaqusInputFile', 'ImportMeshFromNGsolve', 'InternalComputePostprocessingMode', 'LoadFromFile', 'NumpyArray2ListOfLists', 'ReadElementsFromAnsys', 'ReadMassMatrixFromAbaqus', 'ReadMassMatrixFromAnsys', 'ReadNodalCoordinatesFromAnsys', 'ReadStiffnessMatrixFromAbaqus', 'ReadStiffnessMatrixFromAnsys', 'SaveToFile', 'VolumeToSurfaceElements')),
    "FEM.KirchhoffMaterial": Planned('materials of NGsolve, arguments materials and fes', 'give the elastic constants as numbers', ()),
    "FEM.ObjectFFRFinterface": Planned('a flexible body with all coordinates of its mesh', 'FEM.ObjectFFRFreducedOrderInterface makes one with modes', ()),
    "FEM.ReadElementsFromAnsysTxt": Planned('elements of an exported list', '', ()),
    "FEM.ReadNodesFromAbaqusInp": Planned('nodes of an ABAQUS input file', '', ()),
    "FEM.Tet4": Planned('matrices of a tetrahedron', '', ('ComputeMatrices',)),
    "GeneralContact": Planned('contact of many spheres, triangles and cables with each other', 'a few contacts may be springs with user functions that push only, such as ObjectConnectorSpringDamper', ()),
    "MainSystem.AddGeneralContact": Planned('contact of many bodies with each other', '', ()),
    "MainSystem.CreateDistanceSensor": Planned('distances from meshes, by GeneralContact', '', ()),
    "MainSystem.CreateDistanceSensorGeometry": Planned('meshes for distance sensors, by GeneralContact', '', ()),
    "MainSystem.CreateFFRFReducedOrderObject": Planned('flexible bodies in a floating frame', 'FEM.ObjectFFRFreducedOrderInterface has AddObjectFFRFreducedOrder', ()),
    "MainSystem.CreateKinematicTree": Planned('kinematic trees', 'make links by mbs.CreateRigidBody and joints by mbs.CreateRevoluteJoint and mbs.CreatePrismaticJoint', ()),
    "MainSystem.CreateSphereQuadContact": Planned('contact of a sphere with a quadrangle', 'use mbs.CreateCartesianSpringDamper with a user function that pushes only', ()),
    "MainSystem.CreateSphereSphereContact": Planned('contact between spheres', 'use mbs.CreateSpringDamper with a user function that pushes only', ()),
    "MainSystem.CreateSphereTriangleContact": Planned('contact of a sphere with a triangle', 'use mbs.CreateCartesianSpringDamper with a user function that pushes only', ()),
    "beams.GenerateAleSlidingJoint": Planned('an ALE sliding joint along cables', '', ()),
    "beams.GenerateSlidingJoint": Planned('a sliding joint along cables', '', ()),
    "MainSystem.DeleteGeneralContact": Planned('contact of many bodies with each other', '', ()),
    "MainSystem.GetGeneralContact": Planned('contact of many bodies with each other', '', ()),
    "SolverFileData": Planned('files of a solver', '', ()),
    "SolverLocalData": Planned('vectors and matrices of a solver', 'the state of the system is in mbs.systemData, and solvers have GetSystemJacobian and GetSystemMassMatrix', ()),
    "VisuGeneralContact": Planned('how GeneralContact is drawn', '', ()),
    "shells.ShellMesh": Planned('meshes of shells', '', ()),
}
