"""A cantilever with a channel section: its weight twists it, because the shear centre lies outside of the section.

Stiffness and mass of the section are computed from its outline. The axis of the beam goes through the centroid; forces
that act there bend and twist, unless they act in the shear centre.
"""

import matplotlib.pyplot as plt

import dalembert as db
from dalembert.beams import ComputeSectionConstants, GenerateBeamElementsAlongLine, SectionPolygon

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
    """Return the model, the nodes of the beam and the solution under an eccentric force."""
    model = db.Model()
    drawn = db.VObjectBeamGeometricallyExact(sectionGeometry=section.BeamSectionGeometry())
    template = db.ObjectBeamGeometricallyExact(sectionData=section.BeamSection(), visualization=drawn)
    beam = GenerateBeamElementsAlongLine(
        model.system, [0, 0, 0], [length, 0, 0], elements, template, groundConstraintsStart=[1] * 6
    )
    # the force, and its moment about the axis
    tip = model.add(db.MarkerNodeRigid(nodeNumber=beam["nodes"][-1]))
    model.add(db.LoadForceVector(markerNumber=tip, loadVector=[0, 0, -force]))
    model.add(db.LoadTorqueVector(markerNumber=tip, loadVector=[-offset * force, 0, 0]))
    return model, beam["nodes"], model.solve_static(load_steps=4)


_, nodes, solution = cantilever(-arm)
deflection = solution[nodes[-1]].displacement[-1, 2]
inertia, area = section.secondMoments[1, 1], section.shearFactors[1] * section.area
theory = -force * length**3 / (3 * E * inertia) - force * length / (G * area)
print(f"shear centre: {-1e3 * section.shearCenter[0]:.2f} mm before the web")
print(f"deflection, force in the shear centre: {1e3 * deflection:.4f} mm, theory of beams {1e3 * theory:.4f} mm")

model, nodes, solution = cantilever(0.0)
turned = solution[nodes[-1]].rotation[-1, 0]
twist = -force * arm * length / (G * section.torsionConstant)
print(f"angle of twist, force in the centroid: {turned:.6f} rad, theory of torsion {twist:.6f} rad")
for i in range(1, 5):
    node = nodes[i * elements // 4]
    plt.plot(solution.times, solution[node].rotation[:, 0], label=f"{i}/4 of the length")
plt.gca().set(xlabel="load factor (1)", ylabel="twist (rad)")
plt.legend()
plt.savefig("channel_twist.png")
model.draw(file_name="channel_picture.png")
