"""Spring and damper of a wheel suspension, identified from measured accelerations on a bumpy road.

A fit by least squares uses exact derivatives of the solution, which also tell how well the parameters are known.
"""

import matplotlib.pyplot as plt
import numpy as np
from scipy.optimize import least_squares

import dalembert as db

exact, noise = {"stiffness": 21000.0, "damping": 1600.0}, 0.3  # N/m, Ns/m; standard deviation in m/s^2
times, measured_at = np.linspace(0, 1, 1001), np.linspace(0.01, 1, 100)
bump = np.column_stack([times, 0.05 * np.exp(-(((times - 0.2) / 0.03) ** 2))])  # s, m

model = db.Model()
for name, mass, height in (("road", 1, 0.0), ("wheel", 40, 0.3), ("body", 320, 0.9)):
    model.create_box(name=name, size=[0.8, 0.4, 0.1], mass=mass, reference_position=[0, 0, height])
    model.create_prismatic_joint(body_numbers=["ground", name], position=[0, 0, 0], axis="z")
model.create_prescribed_motion(body_numbers=["ground", "road"], position=[0, 0, 0], axis="z", motion=bump)
model.create_spring_damper(name="tyre", body_numbers=["road", "wheel"], stiffness=1.8e5)
model.create_spring_damper(name="suspension", body_numbers=["wheel", "body"], stiffness=15000, damping=700)
model.create_sensor("body", "acceleration", name="acceleration")

output = {"a": db.At("acceleration", measured_at, component=2)}
twin = model.differentiable({name: ("suspension", name) for name in exact}, output, end_time=1, step_size=1e-3)
measured = twin.Values(exact)["a"] + np.random.default_rng(1).normal(0, noise, len(measured_at))
residuals, jacobian = twin.LeastSquares({"a": measured})
fit = least_squares(residuals, twin.x0, jac=jacobian, x_scale="jac")
deviations = np.sqrt(np.diag(twin.Covariance(fit.x, noise)))
for name, unit, value, deviation in zip(exact, ("N/m", "Ns/m"), fit.x, deviations, strict=True):
    print(f"{name}: {value:.1f} {unit}, with a deviation of {deviation:.1f}; measured with {exact[name]:.1f} {unit}")

for x, style, label in ((twin.x0, "--", "before"), (fit.x, "-", "after")):
    plt.plot(measured_at, twin.Values(x)["a"], style, label=label)
plt.plot(measured_at, measured, "o", markersize=3, label="measured")
plt.gca().set(xlabel="time (s)", ylabel="acceleration of the body (m/s$^2$)")
plt.legend()
plt.savefig("identified_damper.png")
