"""A cantilever with a mass at its tip: natural frequencies, and the motion after a load is applied at once."""

import numpy as np

import dalembert as db

length, width, height, side, load = 1.0, 0.03, 0.01, 0.05, 5.0  # m, N

model = db.Model()
beam = model.create_beam(
    end=[length, 0, 0],
    width=width,
    height=height,
    number_of_elements=16,
    supports=["clamped", "free"],
    color="steelblue",
)
tip = model.create_box(name="tip", size=[side] * 3, density=7850, reference_position=[length, 0, 0], color="orange")
model.create_fixed_joint(body_numbers=[beam["end"], tip], show=False)
model.create_force(name="load", body_number=tip, load_vector=[0, 0, -load])

# Rayleigh: 33/140 of the mass of the beam moves with its tip
stiffness = 3 * 2.1e11 * width * height**3 / 12 / length**3
mass = tip.physics_mass + 33 / 140 * 7850 * width * height * length
model.assemble()
found = model.system.ComputeVibrationModes(3).frequencies
rayleigh = np.sqrt(stiffness / mass) / (2 * np.pi)
print(f"first frequency {found[0]:.4f} Hz, Rayleigh {rayleigh:.4f} Hz; next {found[1:].round(2)}")

solution = model.solve(end_time=1, step_size=1e-3)
lowest = solution[tip].displacement[:, 2].min()
print(f"largest deflection {-1e3 * lowest:.2f} mm, twice the static one is {2e3 * load / stiffness:.2f} mm")
solution.plot("tip.displacement", file_name="tip_mass.png")
model.draw(file_name="tip_mass_picture.png")
