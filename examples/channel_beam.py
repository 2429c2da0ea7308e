"""A cantilever with a channel section: its weight twists it, because the shear centre lies outside of the section.

Stiffness and mass of the section are computed from its outline. The axis of the beam goes through the centroid; forces
that act there bend and twist, unless they act in the shear centre.
"""

import dalembert as exu
from dalembert.beams import ComputeSectionConstants, GenerateBeamElementsAlongLine, SectionPolygon
from dalembert.utilities import *

length, elements = 2.0, 32  # m
height, width, wall = 0.08, 0.04, 0.004  # m
steel = {"youngsModulus": 2.1e11, "poissonsRatio": 0.3, "density": 7850}
E, G = 2.1e11, 2.1e11 / 2.6
force = 40.0  # N

# the outline in y and z, counter-clockwise: a web along z, two flanges along y
outline = SectionPolygon(
    [[0, 0], [width, 0], [width, wall], [wall, wall]]
    + [[wall, height - wall], [width, height - wall], [width, height], [0, height]]
)
section = ComputeSectionConstants(outline, steel)
arm = section.centroid[0] - section.shearCenter[0]


def cantilever(offset):
    """The system, bent by an eccentric force, and sensors of rotations along the beam."""
    mbs = exu.SystemContainer().AddSystem()
    drawn = VObjectBeamGeometricallyExact(sectionGeometry=section.BeamSectionGeometry())
    template = ObjectBeamGeometricallyExact(sectionData=section.BeamSection(), visualization=drawn)
    beam = GenerateBeamElementsAlongLine(
        mbs, [0, 0, 0], [length, 0, 0], elements, template, groundConstraintsStart=[1] * 6
    )
    # the force, and its moment about the axis
    tip = mbs.AddMarker(MarkerNodeRigid(nodeNumber=beam["nodes"][-1]))
    mbs.AddLoad(LoadForceVector(markerNumber=tip, loadVector=[0, 0, -force]))
    mbs.AddLoad(LoadTorqueVector(markerNumber=tip, loadVector=[-offset * force, 0, 0]))
    variable = exu.OutputVariableType.Rotation
    sensors = [
        mbs.AddSensor(SensorNode(nodeNumber=node, outputVariableType=variable, storeInternal=True))
        for node in beam["nodes"][elements // 4 :: elements // 4]
    ]
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.staticSolver.numberOfLoadSteps = 4
    mbs.SolveStatic(settings)
    return mbs, beam["nodes"][-1], sensors


mbs, tip, sensors = cantilever(-arm)
deflection = mbs.GetNodeOutput(tip, exu.OutputVariableType.Displacement)[2]
inertia, area = section.secondMoments[1, 1], section.shearFactors[1] * section.area
theory = -force * length**3 / (3 * E * inertia) - force * length / (G * area)
print(f"shear centre: {-1e3 * section.shearCenter[0]:.2f} mm before the web")
print(f"deflection, force in the shear centre: {1e3 * deflection:.4f} mm, theory of beams {1e3 * theory:.4f} mm")

mbs, tip, sensors = cantilever(0.0)
turned = mbs.GetSensorValues(sensors[-1])[0]
twist = -force * arm * length / (G * section.torsionConstant)
print(f"angle of twist, force in the centroid: {turned:.6f} rad, theory of torsion {twist:.6f} rad")
quarters = [f"{i}/4 of the length" for i in range(1, 5)]
mbs.PlotSensor(sensors, components=0, labels=quarters, yLabel="twist (rad)", fileName="channel_twist.png")
mbs.Draw(fileName="channel_picture.png")
