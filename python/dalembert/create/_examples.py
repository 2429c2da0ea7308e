"""An example of each Create function, for its docstring and its page; `mbs` is initially an empty system.

Tests run, assemble and solve each of them.
"""

EXAMPLES = {
    "CreateGround": """
ground = mbs.CreateGround(referencePosition=[0, 0, 1])
mass = mbs.CreateMassPoint(physicsMass=2, gravity=[0, 0, -9.81])
mbs.CreateSpringDamper(bodyNumbers=[ground, mass], stiffness=800)
""",
    "CreateMassPoint": """
mass = mbs.CreateMassPoint(
    referencePosition=[0, 2, 0], initialVelocity=[3, 0, 0], physicsMass=0.5, gravity=[0, -9.81, 0]
)
planar = mbs.CreateMassPoint(physicsMass=0.5, create2D=True, returnDict=True)
marker = mbs.AddMarker(MarkerNodePosition(nodeNumber=planar["nodeNumber"]))
mbs.AddLoad(Force(markerNumber=marker, loadVector=[1, 0, 0]))
""",
    "CreateRigidBody": """
bar = InertiaCuboid(density=7800, sideLengths=[1, 0.1, 0.1])
body = mbs.CreateRigidBody(
    referencePosition=[0.5, 0, 0],
    referenceRotationMatrix=RotationMatrixZ(0.2),
    initialAngularVelocity=[0, 0, 3],
    inertia=bar,
    gravity=[0, -9.81, 0],
)
""",
    "CreateSpringDamper": """
ground = mbs.CreateGround()
mass = mbs.CreateMassPoint(referencePosition=[0, -1, 0], physicsMass=2, gravity=[0, -9.81, 0])
mbs.CreateSpringDamper(bodyNumbers=[ground, mass], referenceLength=1, stiffness=800, damping=8)
""",
    "CreateCartesianSpringDamper": """
ground = mbs.CreateGround()
mass = mbs.CreateMassPoint(physicsMass=2, gravity=[0, 0, -9.81])
mbs.CreateCartesianSpringDamper(bodyNumbers=[ground, mass], stiffness=[800, 800, 2000], damping=[8, 8, 20])
""",
    "CreateRigidBodySpringDamper": """
ground = mbs.CreateGround()
body = mbs.CreateRigidBody(inertia=InertiaSphere(mass=2, radius=0.1), gravity=[0, 0, -9.81])
mbs.CreateRigidBodySpringDamper(
    bodyNumbers=[ground, body],
    stiffness=np.diag([800, 800, 2000, 5, 5, 5]),  # N/m and Nm/rad
    damping=np.diag([8, 8, 20, 0.1, 0.1, 0.1]),
)
""",
    "CreateTorsionalSpringDamper": """
ground = mbs.CreateGround()
disc = InertiaCylinder(7800, 0.02, 0.2, axis=2)
flywheel = mbs.CreateRigidBody(initialAngularVelocity=[0, 0, 2], inertia=disc)
mbs.CreateRevoluteJoint(bodyNumbers=[ground, flywheel], position=[0, 0, 0], axis=[0, 0, 1])
mbs.CreateTorsionalSpringDamper(bodyNumbers=[ground, flywheel], axis=[0, 0, 1], stiffness=30, damping=0.1)
""",
    "CreateLinearSpringDamper": """
ground = mbs.CreateGround()
slider = mbs.CreateRigidBody(
    inertia=InertiaCuboid(density=1000, sideLengths=[0.2, 0.1, 0.1]), referencePosition=[1, 0, 0]
)
mbs.CreatePrismaticJoint(bodyNumbers=[ground, slider], position=[1, 0, 0], axis=[1, 0, 0])
spring = mbs.CreateLinearSpringDamper(
    bodyNumbers=[ground, slider], position=[1, 0, 0], axis=[1, 0, 0], stiffness=1000, damping=10, offset=0.1
)
""",
    "CreateDistanceConstraint": """
ground = mbs.CreateGround()
mass = mbs.CreateMassPoint(referencePosition=[1, 0, 0], physicsMass=2, gravity=[0, -9.81, 0])
mbs.CreateDistanceConstraint(bodyNumbers=[ground, mass])  # a pendulum of length 1
""",
    "CreateCoordinateConstraint": """
mass = mbs.CreateMassPoint(physicsMass=2, gravity=[0, -9.81, 0], initialVelocity=[1, 0, 0])
mbs.CreateCoordinateConstraint(bodyNumbers=[None, mass], coordinates=[None, 1])  # y stays where it is
""",
    "CreateRevoluteJoint": """
ground = mbs.CreateGround()
bar = InertiaCuboid(density=7800, sideLengths=[1, 0.1, 0.1])
pendulum = mbs.CreateRigidBody(referencePosition=[0.5, 0, 0], inertia=bar, gravity=[0, -9.81, 0])
mbs.CreateRevoluteJoint(bodyNumbers=[ground, pendulum], position=[0, 0, 0], axis=[0, 0, 1])
""",
    "CreatePrismaticJoint": """
ground = mbs.CreateGround()
cube = InertiaCuboid(density=7800, sideLengths=[0.1, 0.1, 0.1])
slider = mbs.CreateRigidBody(inertia=cube, gravity=[2, 0, -9.81])
mbs.CreatePrismaticJoint(bodyNumbers=[ground, slider], position=[0, 0, 0], axis=[1, 0, 0])
""",
    "CreateSphericalJoint": """
ground = mbs.CreateGround()
top = mbs.CreateRigidBody(
    referencePosition=[0, 0, 1],
    initialAngularVelocity=[0, 0, 50],
    inertia=InertiaCylinder(7800, 0.05, 0.2, axis=2),
    gravity=[1, 0, -9.81],
)
mbs.CreateSphericalJoint(bodyNumbers=[ground, top], position=[0, 0, 0])
""",
    "CreateGenericJoint": """
ground = mbs.CreateGround()
body = mbs.CreateRigidBody(inertia=InertiaSphere(mass=2, radius=0.1), gravity=[0, 0, -9.81])
mbs.CreateGenericJoint(
    bodyNumbers=[ground, body],
    position=[0, 0, 0],
    constrainedAxes=[1, 1, 0, 1, 1, 0],  # free along and about z
)
""",
    "CreateFixedJoint": """
ground = mbs.CreateGround()
beam = mbs.CreateBox(size=[1, 0.1, 0.1], density=7800, referencePosition=[0.5, 0, 0])
weight = mbs.CreateSphere(radius=0.1, mass=20, referencePosition=[1.1, 0, 0], gravity=[0, 0, -9.81])
mbs.CreateRevoluteJoint(bodyNumbers=[ground, beam], position=[0, 0, 0], axis=[0, 1, 0])
mbs.CreateFixedJoint(bodyNumbers=[beam, weight])
""",
    "CreateCylindricalJoint": """
ground = mbs.CreateGround()
sleeve = mbs.CreateCylinder(
    radius=0.1, innerRadius=0.05, length=0.3, density=7800, initialAngularVelocity=[0, 0, 10], gravity=[0, 0, -9.81]
)
mbs.CreateCylindricalJoint(bodyNumbers=[ground, sleeve], position=[0, 0, 0], axis=[0, 0, 1])
""",
    "CreateUniversalJoint": """
ground = mbs.CreateGround()
slope = RotationMatrixY(0.4)
shaft = mbs.CreateCylinder(
    radius=0.05, length=1, axis=[1, 0, 0], density=7800,
    referencePosition=[-0.5, 0, 0], initialAngularVelocity=[10, 0, 0],
)
driven = mbs.CreateCylinder(
    radius=0.05, length=1, axis=[1, 0, 0], density=7800,
    referencePosition=slope @ [0.5, 0, 0], referenceRotationMatrix=slope,
    initialAngularVelocity=10 / np.cos(0.4) * slope[:, 0],
)
mbs.CreateRevoluteJoint(bodyNumbers=[ground, shaft], position=[-1, 0, 0], axis=[1, 0, 0])
mbs.CreateUniversalJoint(
    bodyNumbers=[shaft, driven], position=[0, 0, 0], axis0=[0, 0, 1], axis1=[0, 1, 0]
)
mbs.CreateCylindricalJoint(bodyNumbers=[ground, driven], position=slope @ [1, 0, 0], axis=slope[:, 0])
""",
    "CreateBox": """
mbs.CreateBox(size=[1, 0.2, 0.1], density=2700, gravity=[0, 0, -9.81], color=graphics.color.orange)
""",
    "CreateCylinder": """
mbs.CreateCylinder(radius=0.2, length=0.5, mass=3, initialAngularVelocity=[0, 0, 20])
""",
    "CreateSphere": """
mbs.CreateSphere(radius=0.1, density=7800, initialVelocity=[1, 0, 0])
""",
    "CreateMotor": """
ground = mbs.CreateGround()
rotor = mbs.CreateCylinder(radius=0.2, length=0.05, density=7800)
mbs.CreateRevoluteJoint(bodyNumbers=[ground, rotor], position=[0, 0, 0], axis=[0, 0, 1])
motor = mbs.CreateMotor(
    bodyNumbers=[ground, rotor], position=[0, 0, 0], axis=[0, 0, 1], speed=100, ramp=0.5, damping=20, maximumTorque=200
)
""",
    "CreatePIDController": """
ground = mbs.CreateGround()
arm = mbs.CreateBox(size=[0.5, 0.05, 0.05], density=2700, referencePosition=[0.25, 0, 0], gravity=[0, -9.81, 0])
mbs.CreateRevoluteJoint(bodyNumbers=[ground, arm], position=[0, 0, 0], axis=[0, 0, 1])
controller = mbs.CreatePIDController(
    bodyNumbers=[ground, arm], position=[0, 0, 0], axis=[0, 0, 1], setPoint=0.5, P=400, I=800, D=40, limit=50
)
""",
    "CreateJointStops": """
ground = mbs.CreateGround()
arm = mbs.CreateBox(size=[0.5, 0.05, 0.05], density=2700, referencePosition=[0.25, 0, 0], gravity=[0, -9.81, 0])
mbs.CreateRevoluteJoint(bodyNumbers=[ground, arm], position=[0, 0, 0], axis=[0, 0, 1])
mbs.CreateJointStops(
    bodyNumbers=[ground, arm], position=[0, 0, 0], axis=[0, 0, 1], lower=-0.5, stiffness=1e4, damping=100
)
""",
    "CreatePrescribedMotion": """
ground = mbs.CreateGround()
table = mbs.CreateBox(size=[1, 1, 0.1], density=7800)
mbs.CreatePrismaticJoint(bodyNumbers=[ground, table], position=[0, 0, 0], axis=[0, 0, 1])
mbs.CreatePrescribedMotion(
    bodyNumbers=[ground, table], position=[0, 0, 0], axis=[0, 0, 1], motion=lambda t: 0.01 * np.sin(20 * t), ramp=0.5
)
""",
    "CreateForceFromTable": """
cart = mbs.CreateBox(size=[1, 0.5, 0.5], mass=100)
mbs.CreateForceFromTable(bodyNumber=cart, table=[[0, 0], [0.1, 500], [0.3, 500], [0.4, 0]])
""",
    "CreateTorqueFromTable": """
wheel = mbs.CreateCylinder(radius=0.2, length=0.05, density=7800)
mbs.CreateTorqueFromTable(bodyNumber=wheel, table=[[0, 0], [0.5, 10], [1, 0]], smooth=True)
""",
    "CreateCable": """
cable = mbs.CreateCable(
    start=[0, 0, 0], end=[2, 0, 0], diameter=0.01, numberOfElements=16, supports=["hinged", "free"],
    gravity=[0, 0, -9.81],
)
ball = mbs.CreateSphere(radius=0.1, mass=1, referencePosition=[2, 0, 0], gravity=[0, 0, -9.81])
mbs.CreateSphericalJoint(bodyNumbers=[cable["end"], ball])
""",
    "CreateBeam": """
beam = mbs.CreateBeam(start=[0, 0, 0], end=[1, 0, 0], width=0.02, height=0.05, supports=["clamped", "free"])
mbs.CreateForce(bodyNumber=beam["end"], loadVector=[0, 0, -500])
""",
    "CreateRope": """
ground = mbs.CreateGround()
loads = [mbs.CreateBox(size=[0.2, 0.2, 0.2], mass=m, referencePosition=[x, -1, 0], gravity=[0, -9.81, 0])
         for m, x in ((11, -0.3), (10, 0.3))]
mbs.CreateRope(
    bodyNumbers=[loads[0], ground, loads[1]], positions=[[-0.3, -0.9, 0], [0, 0, 0], [0.3, -0.9, 0]], radii=[-0.3],
    stiffness=1e5, damping=500,
)
""",
    "CreateBelt": """
ground = mbs.CreateGround()
pulleys = [mbs.CreateCylinder(radius=r, length=0.02, axis=[0, 0, 1], density=7850, referencePosition=[x, 0, 0])
           for r, x in ((0.05, 0), (0.1, 0.4))]
for pulley, x in zip(pulleys, (0, 0.4)):
    mbs.CreateRevoluteJoint(bodyNumbers=[ground, pulley], position=[x, 0, 0], axis=[0, 0, 1])
mbs.CreateMotor(bodyNumbers=[ground, pulleys[0]], position=[0, 0, 0], axis=[0, 0, 1], speed=20, ramp=0.2, damping=5)
mbs.CreateTorque(bodyNumber=pulleys[1], loadVector=[0, 0, -10])
mbs.CreateBelt(
    bodyNumbers=pulleys, positions=[[0, 0, 0], [0.4, 0, 0]], radii=[0.05, 0.1], carrierNumber=ground,
    stiffness=5e4, damping=50, pretension=500,
)
""",
    "CreateHydraulicCylinder": """
ground = mbs.CreateGround()
boom = mbs.CreateBox(size=[2, 0.1, 0.1], density=2700, referencePosition=[1, 0, 0], gravity=[0, -9.81, 0])
mbs.CreateRevoluteJoint(bodyNumbers=[ground, boom], position=[0, 0, 0], axis=[0, 0, 1])
cylinder = mbs.CreateHydraulicCylinder(
    bodyNumbers=[ground, boom], localPosition0=[0.5, -1, 0], localPosition1=[-0.5, 0, 0], initialForce=1060,
    actuatorDamping=1e4,
)
mbs.SetObjectParameter(cylinder, "valveOpening0", 0.2)  # extends
mbs.SetObjectParameter(cylinder, "valveOpening1", -0.2)
""",
    "CreateRollingDisc": """
ground = mbs.CreateGround()
disc = mbs.CreateRigidBody(
    referencePosition=[0, 0, 0.2],
    initialVelocity=[0, 1, 0],
    initialAngularVelocity=[-5, 0, 0],
    inertia=InertiaCylinder(7800, 0.02, 0.2, axis=0),
    gravity=[0, 0, -9.81],
)
mbs.CreateRollingDisc(bodyNumbers=[ground, disc], axisPosition=[0, 0, 0], axisVector=[1, 0, 0], discRadius=0.2)
""",
    "CreateRollingDiscPenalty": """
ground = mbs.CreateGround()
disc = mbs.CreateRigidBody(
    referencePosition=[0, 0, 0.2],
    initialVelocity=[0, 1, 0],  # slips until it rolls
    inertia=InertiaCylinder(7800, 0.02, 0.2, axis=0),
    gravity=[0, 0, -9.81],
)
mbs.CreateRollingDiscPenalty(
    bodyNumbers=[ground, disc],
    axisPosition=[0, 0, 0],
    axisVector=[1, 0, 0],
    discRadius=0.2,
    contactStiffness=1e5,
    contactDamping=1e3,
    dryFriction=[0.3, 0.3],
    dryFrictionProportionalZone=0.01,
)
""",
    "CreateSphereSphereContact": """
ball = InertiaSphere(0.5, 0.1)
first = mbs.CreateRigidBody(inertia=ball, initialVelocity=[1, 0, 0])
second = mbs.CreateRigidBody(referencePosition=[0.3, 0, 0], inertia=ball)
mbs.CreateSphereSphereContact(
    bodyNumbers=[first, second],
    spheresRadii=[0.1, 0.1],
    contactStiffness=1e5,
    restitutionCoefficient=0.8,
    impactModel=2,
    dataInitialCoordinates=[0.1, 0, 0, 0],  # the gap
)
""",
    "CreateSphereTriangleContact": """
ground = mbs.CreateGround()
sphere = InertiaSphere(mass=0.5, radius=0.1)
ball = mbs.CreateRigidBody(referencePosition=[0, 0, 0.3], inertia=sphere, gravity=[0, 0, -9.81])
mbs.CreateSphereTriangleContact(
    bodyNumbers=[ball, ground],
    radiusSphere=0.1,
    trianglePoints=[[-1, -1, 0], [2, -1, 0], [-1, 2, 0]],
    contactStiffness=1e4,
    contactDamping=10,
    dataInitialCoordinates=[0.2, 0, 0, 0],  # the gap
)
""",
    "CreateSphereQuadContact": """
ground = mbs.CreateGround()
sphere = InertiaSphere(mass=0.5, radius=0.1)
ball = mbs.CreateRigidBody(referencePosition=[0, 0, 0.3], inertia=sphere, gravity=[0, 0, -9.81])
mbs.CreateSphereQuadContact(
    bodyNumbers=[ball, ground],
    radiusSphere=0.1,
    quadPoints=[[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]],
    contactStiffness=1e4,
    contactDamping=10,
    dataInitialCoordinates=[0.2, 0, 0, 0],  # the gap
)
""",
    "CreateForce": """
body = mbs.CreateRigidBody(inertia=InertiaCuboid(density=7800, sideLengths=[1, 0.1, 0.1]))
mbs.CreateForce(bodyNumber=body, loadVector=[0, 100, 0], localPosition=[0.5, 0, 0])
mbs.CreateForce(
    bodyNumber=body, loadVectorUserFunction=lambda mbs, t, load: [0, 0, 50 * np.sin(20 * t)]
)
""",
    "CreateTorque": """
ground = mbs.CreateGround()
wheel = mbs.CreateRigidBody(inertia=InertiaCylinder(7800, 0.02, 0.2, axis=2))
mbs.CreateRevoluteJoint(bodyNumbers=[ground, wheel], position=[0, 0, 0], axis=[0, 0, 1])
mbs.CreateTorque(bodyNumber=wheel, loadVector=[0, 0, 2])
""",
    "CreateFFRFReducedOrderObject": """
from dalembert.FEM import FEMinterface, KirchhoffMaterial

fem = FEMinterface()
corners = [[x, y, z] for z in (0, 0.1) for x, y in ((0, 0), (1, 0), (1, 0.1), (0, 0.1))]
fem.SetMesh(corners, {"Hex8": [range(8)]})
fem.AssembleMatrices(KirchhoffMaterial(2.1e11, 0.3, 7850))
root = {"Name": "root", "NodeNumbers": [0, 3, 4, 7], "NodeWeights": [0.25] * 4, "type": "boundary"}
fem.nodeSets.append(root)
fem.ComputeHurtyCraigBamptonModes([[0, 3, 4, 7]], nEigenModes=3)
beam = mbs.CreateFFRFReducedOrderObject("beam", fem, gravity=[0, 0, -9.81])
ground = mbs.CreateGround()
fixed = mbs.AddMarker(MarkerBodyRigid(bodyNumber=ground, localPosition=[0, 0.05, 0.05]))
mbs.AddObject(GenericJoint(markerNumbers=[fixed, beam["beam:root"]]))
""",
    "CreateKinematicTree": """
bar = InertiaCuboid(density=1000, sideLengths=[0.5, 0.05, 0.05]).Translated([0.25, 0, 0])
shoulder = TreeLink(linkInertia=bar, jointType=exu.JointType.RevoluteZ, PDcontrol=(200, 20))
elbow = TreeLink(
    linkInertia=bar, jointType=exu.JointType.RevoluteY, jointHT=HTtranslateX(0.5), PDcontrol=(50, 5)
)
arm = mbs.CreateKinematicTree(
    listOfTreeLinks=[shoulder, elbow], gravity=[0, 0, -9.81], jointPositionOffsetVector=[0.5, -0.3]
)
tip = mbs.AddMarker(
    MarkerKinematicTreeRigid(objectNumber=arm, linkNumber=1, localPosition=[0.5, 0, 0])
)
mbs.AddLoad(Force(markerNumber=tip, loadVector=[0, 0, 5]))
""",
    "CreateDistanceSensorGeometry": """
wall = graphics.Brick(centerPoint=[2, 0, 0], size=[0.1, 2, 2])
points, triangles = graphics.ToPointsAndTrigs(wall)
ground = mbs.AddMarker(MarkerBodyRigid(bodyNumber=mbs.CreateGround()))
seen = mbs.CreateDistanceSensorGeometry(points, triangles, ground)
cart = mbs.CreateMassPoint(physicsMass=1, initialVelocity=[1, 0, 0])
eye = mbs.AddMarker(MarkerBodyPosition(bodyNumber=cart))
mbs.CreateDistanceSensor(seen, positionOrMarker=eye, dirSensor=[1, 0, 0])  # 1.95 m at the start
""",
    "CreateDistanceSensor": """
ground = mbs.AddMarker(MarkerBodyRigid(bodyNumber=mbs.CreateGround()))
floor = [[-5, -5, 0], [5, -5, 0], [5, 5, 0], [-5, 5, 0]]
seen = mbs.CreateDistanceSensorGeometry(floor, [[0, 1, 2], [0, 2, 3]], ground)
drone = mbs.CreateRigidBody(
    referencePosition=[0, 0, 3], inertia=InertiaSphere(mass=1, radius=0.1), gravity=[0, 0, -9.81]
)
center = mbs.AddMarker(MarkerBodyRigid(bodyNumber=drone))
height = mbs.CreateDistanceSensor(
    seen, positionOrMarker=center, dirSensor=[0, 0, -1], minDistance=0, storeInternal=True
)
""",
    "CreateRobot": """
from pathlib import Path
from tempfile import TemporaryDirectory

urdf = '''<robot name="pendulum"><link name="base"/>
<link name="rod"><inertial><origin xyz="0.5 0 0"/><mass value="2"/>
<inertia ixx="0.01" ixy="0" ixz="0" iyy="0.2" iyz="0" izz="0.2"/></inertial></link>
<joint name="hinge" type="revolute"><parent link="base"/><child link="rod"/><axis xyz="0 1 0"/>
<limit lower="-2" upper="2" effort="50" velocity="5"/><dynamics damping="0.1"/></joint></robot>'''
with TemporaryDirectory() as folder:
    file = Path(folder, "pendulum.urdf")
    file.write_text(urdf)
    made = mbs.CreateRobot(file, referenceConfiguration=[0.3], limitStiffness=1e4)
arm = made["objectKinematicTree"]
tip = mbs.AddMarker(
    MarkerKinematicTreeRigid(objectNumber=arm, linkNumber="rod", localPosition=[1, 0, 0])
)
mbs.AddLoad(Force(markerNumber=tip, loadVector=[0, 0, 5]))
""",
}
