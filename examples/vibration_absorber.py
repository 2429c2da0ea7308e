"""A vibration absorber on a shaken machine, tuned by derivatives of the amplitude: Den Hartog's optimum.

At two frequencies, the amplitude of the machine does not depend on the damper of the absorber. The best spring makes
the amplitudes there equal, and the best damper makes the curve level at each of them, in the mean of squares. All of
these are equations for exact derivatives of frequency responses, by the damper and by the frequency. Their solutions
are those of the formulas of Den Hartog (Mechanical Vibrations, section 3.3) and Brock.
"""

import matplotlib.pyplot as plt
import numpy as np
from scipy.optimize import brentq, least_squares

import dalembert as db

mass, stiffness, small = 10.0, 4000.0, 0.5  # kg, N/m, kg
ratio, own = small / mass, np.sqrt(stiffness / mass)

model = db.Model()
markers = [model.add(db.MarkerNodeCoordinate(nodeNumber=model.add(db.NodePointGround()), coordinate=0))]
for name, size in (("machine", mass), ("absorber", small)):
    node = model.add(db.Node1D(name=name))
    model.add(db.Mass1D(physicsMass=size, nodeNumber=node))
    markers.append(model.add(db.MarkerNodeCoordinate(nodeNumber=node, coordinate=0)))
model.add(db.CoordinateSpringDamper(markerNumbers=markers[:2], stiffness=stiffness))
absorber = {"stiffness": ratio * stiffness, "damping": 1}
model.add(db.CoordinateSpringDamper(name="coupling", markerNumbers=markers[1:], **absorber))
model.add(db.LoadCoordinate(name="shaker", markerNumber=markers[1], load=1))
model.add(db.SensorNode(name="x", nodeNumber="machine", outputVariableType=db.OutputVariableType.Coordinates))
model.assemble()

below, above = db.DesignParameter(0.9 * own), db.DesignParameter(1.05 * own)  # frequencies in rad/s
parameters = {"k": ("coupling", "stiffness"), "d": ("coupling", "damping"), "below": below, "above": above}
outputs = {name: db.FrequencyResponse("shaker", "x", omega=name) for name in ("below", "above")}
twin = db.DifferentiableModel(model.system, parameters, outputs, solverType="static")


def fixed_points(factors):
    """Return values that vanish at the best spring: derivatives by the damper, and the difference of amplitudes."""
    found = twin.Sensitivities(twin.x0 * [factors[0], 1.0, *factors[1:]])
    below, above = found.values.values()
    return [found.Derivative("below", "d") / below, found.Derivative("above", "d") / above, above / below - 1]


k, *frequencies = twin.x0[[0, 2, 3]] * least_squares(fixed_points, np.ones(3), bounds=(0.8, 1.1), gtol=1e-13).x
level = [
    brentq(lambda d, name=name: twin.Sensitivities([k, d, *frequencies]).Derivative(name, name), 0.5, 8, xtol=1e-10)
    for name in outputs
]
d = np.sqrt(np.mean(np.square(level)))

expected = ratio * stiffness / (1 + ratio) ** 2
print(f"stiffness of the absorber: {k:.5f} N/m, Den Hartog's {expected:.5f} N/m")
damper = 2 * small * own * np.sqrt(3 * ratio / (8 * (1 + ratio) ** 3))
print(f"damper of the absorber: {d:.6f} Ns/m, Den Hartog's and Brock's {damper:.6f} Ns/m")
highest = twin.Values([k, d, *frequencies])["below"]
print(f"amplitude at both frequencies: {1e3 * highest:.6f} mm/N, sqrt(1 + 2/ratio)/stiffness "
      f"{1e3 * np.sqrt(1 + 2 / ratio) / stiffness:.6f} mm/N")  # fmt: skip

grid = np.linspace(0.75, 1.25, 81) * own
for name, tuned in (("before", [ratio * stiffness, 1.0]), ("after", [k, d])):
    amplitude = [1e3 * twin.Values([*tuned, w, w])["below"] for w in grid]
    plt.plot(grid / (2 * np.pi), amplitude, label=name)
plt.gca().set(xlabel="frequency (Hz)", ylabel="amplitude (mm/N)")
plt.legend()
plt.savefig("absorber_responses.png")
