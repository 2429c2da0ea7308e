"""A tapered blade of a wind turbine: how its frequencies rise with the speed of the rotor, and how the wind bends it.

Each element has the section of its middle, a hollow ellipse that gets smaller towards the tip. Centrifugal forces
stiffen the blade, out of the plane of the rotor more than in it. A reference with nothing in common: polynomials as
shapes of a beam without shear, under the pull of its mass (Ritz).
"""

import matplotlib.pyplot as plt
import numpy as np

import dalembert as db
from dalembert.beams import ComputeSectionConstants, SectionPolygon

length, elements = 30.0, 40  # m
chord, thickness, wall, taper = 1.6, 0.7, 0.03, 0.6  # m, m, m, relative reduction at the tip
laminate = {"youngsModulus": 2.2e10, "poissonsRatio": 0.3, "density": 1900}
wind = 900.0  # N/m
speeds = np.linspace(0, 24, 5)  # revolutions per minute

# sections: a hollow ellipse, its chord along y
angles = np.linspace(0, 2 * np.pi, 48, endpoint=False)


def section(place):
    size = (1 - taper * place) * np.array([chord, thickness]) / 2
    outside, inside = (half * np.column_stack([np.cos(angles), np.sin(angles)]) for half in (size, size - wall))
    return ComputeSectionConstants(SectionPolygon(outside, holes=[inside]), laminate, fineness=8)


sections = [section((i + 0.5) / elements) for i in range(elements)]

# the blade, along x
model = db.Model()
nodes = [
    model.add(db.NodeRigidBodyRotVecLG(referenceCoordinates=[x, 0, 0, 0, 0, 0]))
    for x in np.linspace(0, length, elements + 1)
]
for i, part in enumerate(sections):
    drawn = db.VObjectBeamGeometricallyExact(sectionGeometry=part.BeamSectionGeometry())
    model.add(
        db.ObjectBeamGeometricallyExact(
            physicsLength=length / elements, sectionData=part.BeamSection(), nodeNumbers=nodes[i : i + 2],
            visualization=drawn,
        )
    )  # fmt: skip
markers = [model.add(db.MarkerNodeRigid(nodeNumber=node)) for node in nodes]
model.add(db.GenericJoint(markerNumbers=[model.add(db.MarkerBodyRigid(bodyNumber=model.ground)), markers[0]]))
# shares of one element each, the last one half
gusts = [model.add(db.Force(markerNumber=marker, loadVector=[0, 0, 0])) for marker in markers[1:]]
model.assemble()

# frequencies: the rotor turns about z, so that z is out of its plane
found = np.array([model.system.ComputeVibrationModes(4, [0, 0, rpm * np.pi / 30]).frequencies for rpm in speeds])


places_of_fit = np.linspace(0, 1, 9)
sections_of_fit = [section(place) for place in places_of_fit]


def ritz(rpm, out_of_plane, terms=7):
    """Return the first two frequencies (Hz), from stiffness and mass of the sections along the blade."""
    bending = [part.stiffnessMatrix[4 if out_of_plane else 5, 4 if out_of_plane else 5] for part in sections_of_fit]
    s, weights = np.polynomial.legendre.leggauss(40)
    s, weights = (s + 1) / 2, weights / 2 * length
    stiffness = np.polyval(np.polyfit(places_of_fit, bending, 6), s)
    mass = np.polyval(np.polyfit(places_of_fit, [part.massMatrix[0, 0] for part in sections_of_fit], 6), s)
    pull = np.array([np.sum(weights * mass * s * length * (s > here)) for here in s])
    pull += 0.5 * weights * mass * s * length  # half of the weight at the position itself
    omega = rpm * np.pi / 30
    powers = np.arange(2, 2 + terms)[:, None]
    shape, slope, curve = s**powers, powers * s ** (powers - 1), powers * (powers - 1) * s ** (powers - 2)
    M = (shape * mass * weights) @ shape.T
    K = (curve * stiffness * weights) @ curve.T / length**4 + omega**2 * (slope * pull * weights) @ slope.T / length**2
    if not out_of_plane:
        K -= omega**2 * M
    return np.sort(np.sqrt(np.linalg.eigvals(np.linalg.solve(M, K)).real))[:2] / (2 * np.pi)


for k in (0, -1):
    flap, lag = ritz(speeds[k], True), ritz(speeds[k], False)
    for name, value, reference in (
        ("first flap", found[k, 0], flap[0]), ("first lag", found[k, 1], lag[0]), ("second flap", found[k, 2], flap[1])
    ):  # fmt: skip
        print(f"{name} at {speeds[k]:.0f} rpm: {value:.4f} Hz, Ritz {reference:.4f} Hz")

# the wind, at rest and at full speed
for i, gust in enumerate(gusts):
    share = 0.5 if i == elements - 1 else 1.0
    gust.load_vector = [0, 0, share * wind * length / elements]
model.assemble()
tips = []
for rpm in (0, speeds[-1]):
    bent = model.system.ComputeVibrationModes(1, [0, 0, rpm * np.pi / 30])
    model.system.systemData.SetODE2Coordinates(bent.coordinates)
    tips.append(nodes[-1].position[2])
print(f"the wind bends the tip by {tips[0]:.3f} m at rest, by {tips[1]:.3f} m at {speeds[-1]:.0f} rpm")

names = ["first flap", "first lag", "second flap", "second lag"]
plt.plot(speeds, found, label=names)
plt.gca().set(xlabel="speed of the rotor (rpm)", ylabel="frequency (Hz)")
plt.legend()
plt.savefig("blade_frequencies.png")
shown = model.container.visualizationSettings
model.system.systemData.SetODE2Coordinates(bent.coordinates, db.ConfigurationType.Visualization)
shown.nodes.show = shown.markers.show = shown.loads.show = shown.connectors.show = False
shown.contour.outputVariable, shown.contour.outputVariableComponent = db.OutputVariableType.Displacement, 2  # as color
model.container.renderer.SetModelView(zoom=15, rotationVector=[-1.1, 0.1, 0.3], centerPoint=[length / 2, 0, 0])
model.draw(file_name="blade_picture.png")
