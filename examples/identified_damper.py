"""Spring and damper of a wheel suspension, identified from measured accelerations of a vehicle on a bumpy road.

A quarter of a vehicle, with the mass of the body above that of the wheel, drives over a bump at a constant speed. The
measurement is a solution with other numbers, and with noise. A fit by least squares needs derivatives of all measured
values with respect to the parameters: they come with the solution, and also tell how well the parameters are known.
"""

import numpy as np
from scipy.optimize import least_squares

import dalembert as exu
from dalembert.utilities import *

body, wheel, tyre = 320.0, 40.0, 1.8e5  # kg, kg, N/m
exact, guess = {"stiffness": 21000.0, "damping": 1600.0}, {"stiffness": 15000.0, "damping": 700.0}  # N/m, Ns/m
noise = 0.3  # m/s^2, standard deviation
height, duration = 0.05, 0.12  # of the bump: m, s

mbs = exu.SystemContainer().AddSystem()
markers = [mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.AddNode(NodePointGround()), coordinate=0))]
for name, mass in (("wheel", wheel), ("body", body)):
    node = mbs.AddNode(Node1D(name=name))
    mbs.AddObject(Mass1D(physicsMass=mass, nodeNumber=node))
    markers.append(mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=node, coordinate=0)))
mbs.AddObject(CoordinateSpringDamper(name="suspension", markerNumbers=markers[1:], **guess))


def bump(mbs, t, itemNumber, u, v, stiffness, damping, offset):
    """The force of the tyre, whose lower end follows a bump (1 - cos)/2."""
    phase = t / duration
    road = 0.5 * height * (1 - exu.symbolic.cos(2 * np.pi * phase)) * exu.symbolic.IfThenElse(phase < 1, 1, 0)
    return stiffness * (u - road)


contact = mbs.AddObject(CoordinateSpringDamper(name="tyre", markerNumbers=markers[:2], stiffness=tyre))
law = CreateSymbolicUserFunction(mbs, bump, "springForceUserFunction", contact)
mbs.SetObjectParameter(contact, "springForceUserFunction", law)
kind = exu.OutputVariableType.Coordinates_tt
mbs.AddSensor(SensorNode(name="acceleration", nodeNumber="body", outputVariableType=kind))
mbs.Assemble()

settings = exu.SimulationSettings()
settings.timeIntegration.endTime, settings.timeIntegration.numberOfSteps = 1.0, 1000
times = np.linspace(0.01, 1, 100)
parameters = {name: ("suspension", name) for name in exact}
model = exu.DifferentiableModel(mbs, parameters, {"a": exu.At("acceleration", times)}, settings)
measured = model.Values(exact)["a"] + np.random.default_rng(1).normal(0, noise, len(times))

residuals, jacobian = model.LeastSquares({"a": measured})
fit = least_squares(residuals, model.x0, jac=jacobian, x_scale="jac")
deviation = np.sqrt(np.diag(model.Covariance(fit.x, noise)))
for name, unit, value, error in zip(exact, ("N/m", "Ns/m"), fit.x, deviation, strict=True):
    print(f"{name}: {value:.1f} {unit}, with a deviation of {error:.1f} {unit}; measured with {exact[name]:.1f} {unit}")

curves = [np.column_stack([times, values]) for values in (measured, model.Values(guess)["a"], model.Values(fit.x)["a"])]
mbs.PlotSensor(curves, labels=["measured", "before", "after"], lineStyles=["", "--", "-"], markerStyles=["o", "", ""],
               markerDensity=None, yLabel="acceleration of the body (m/s$^2$)", fileName="identified_damper.png",
               closeAll=True)  # fmt: skip
