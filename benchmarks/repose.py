"""Angle of repose of a bed of spheres that is tilted: friction with bristles, and no resistance to rolling.

`python benchmarks/repose.py [spheres]` fills a box with walls that do not rub in front and behind, and a floor of
spheres that are fixed; lets the spheres come to rest; then turns gravity by 35 degrees within a second, so that they
slide down to the lower wall until their surface stands by itself. It prints the angle of the surface against the
horizontal plane, for friction of 0.1 and 0.5, and how fast the spheres still are.

Simulations of spheres with friction of 0.5 on rough planes, with springs for the friction and no resistance to rolling,
come to rest below 18 to 21 degrees and flow faster and faster above 26 (Silbert et al., Phys. Rev. E 64, 051302, 2001,
and Phys. Fluids 15, 1, 2003; Weinhart et al., Granul. Matter 14, 531, 2012): a heap that came to rest is between.
"""

from __future__ import annotations

import sys
import time

import numpy as np

import dalembert as exu
from dalembert.utilities import Force, InertiaSphere, MarkerBodyRigid

RADIUS, DENSITY, GRAVITY, TILT = 0.01, 2500.0, 9.81, np.radians(35)
STIFFNESS, RESTITUTION = 2e4, 0.7  # N/m of a pair, 1
MASS = DENSITY * 4 / 3 * np.pi * RADIUS**3
STEP = 1e-4  # a twentieth of a contact
PUBLISHED = (18.0, 26.0)  # degrees, friction of 0.5


def damping() -> float:
    """Of a pair of spheres whose impact has that restitution."""
    logarithm = np.log(RESTITUTION)
    ratio = -logarithm / np.hypot(np.pi, logarithm)
    return 2 * ratio * np.sqrt(STIFFNESS * MASS / 2)


def angle_of_repose(count: int, friction: float, seed: int = 1) -> tuple[float, float]:
    """Angle in degrees, and the mean speed of the last 10 ms in radii per second."""
    random = np.random.default_rng(seed)
    mbs = exu.SystemContainer().AddSystem()
    contact = mbs.AddGeneralContact()
    contact.SetFrictionPairings([[friction, 0], [0, 0]])
    contact.SetFrictionBristles(2 / 7, 0.5)
    surface = {"contactStiffness": 2 * STIFFNESS, "contactDamping": damping() / 2, "frictionMaterialIndex": 0}
    smooth = surface | {"frictionMaterialIndex": 1}
    pitch, wide = 2.05 * RADIUS, 5
    layers = max(4, round((count / (3 * wide)) ** 0.5))
    long = -(-count // (wide * layers))
    length, width = long * pitch, wide * pitch
    ground = mbs.AddMarker(MarkerBodyRigid(bodyNumber=mbs.CreateGround()))
    for normal, point in (([0, 1, 0], [0, 0, 0]), ([0, -1, 0], [0, width, 0])):
        contact.AddPlane(ground, normal=normal, point=point, **smooth)
    for normal, point in (([1, 0, 0], [0, 0, 0]), ([-1, 0, 0], [length, 0, 0])):
        contact.AddPlane(ground, normal=normal, point=point, **surface)
    for i in range(long):
        for j in range(wide):
            place = pitch * np.array([i + 0.5, j + 0.5, 0]) + RADIUS * np.append(random.uniform(-0.3, 0.3, 2), 0)
            fixed = mbs.AddMarker(MarkerBodyRigid(bodyNumber=mbs.CreateGround(referencePosition=place)))
            contact.AddSphereWithMarker(fixed, radius=RADIUS, **surface)
    nodes, loads = [], []
    inertia = InertiaSphere(MASS, RADIUS)
    for k in range(1, layers + 1):
        for i in range(long):
            for j in range(wide):
                place = pitch * np.array([i + 0.5, j + 0.5, k]) + RADIUS * random.uniform(-0.02, 0.02, 3)
                body = mbs.CreateRigidBody(
                    referencePosition=place, inertia=inertia, nodeType=exu.NodeType.RotationRotationVector
                )
                marker = mbs.AddMarker(MarkerBodyRigid(bodyNumber=body))
                contact.AddSphereWithMarker(marker, radius=RADIUS * random.uniform(0.9, 1.0), **surface)
                loads.append(mbs.AddLoad(Force(markerNumber=marker, loadVector=[0, 0, -MASS * GRAVITY])))
                nodes.append(mbs.GetObject(body)["nodeNumber"])
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.solutionSettings.writeSolutionToFile = False
    settings.timeIntegration.verboseMode = 0

    def solve(begin: float, end: float, tilt: float) -> None:
        pull = MASS * GRAVITY * np.array([-np.sin(tilt), 0, -np.cos(tilt)])
        for load in loads:
            mbs.SetLoadParameter(load, "loadVector", pull)
        settings.timeIntegration.startTime, settings.timeIntegration.endTime = begin, end
        settings.timeIntegration.numberOfSteps = round((end - begin) / STEP)
        mbs.SolveDynamic(settings, solverType=exu.DynamicSolverType.VelocityVerlet)
        state = mbs.systemData.GetSystemState(exu.ConfigurationType.Current)
        mbs.systemData.SetSystemState(state, exu.ConfigurationType.Initial)

    def of_nodes(kind: exu.OutputVariableType) -> np.ndarray:
        return np.array([mbs.GetNodeOutput(node, kind) for node in nodes])

    solve(0, 0.5, 0)
    for k in range(50):
        solve(0.5 + 0.02 * k, 0.52 + 0.02 * k, TILT * (k + 1) / 50)
    solve(1.5, 3.0, TILT)
    speed = np.linalg.norm(of_nodes(exu.OutputVariableType.Velocity), axis=1).mean() / RADIUS
    x, z = of_nodes(exu.OutputVariableType.Position)[:, [0, 2]].T
    bins = np.linspace(0.1 * length, 0.9 * length, 13)
    at = np.digitize(x, bins)
    middles, heights = [], []
    for k in range(1, len(bins)):
        inside = np.sort(z[at == k])[-wide:]  # the highest ones
        if len(inside) == wide:
            middles.append(0.5 * (bins[k - 1] + bins[k]))
            heights.append(inside.mean())
    slope = np.polyfit(middles, heights, 1)[0]
    return float(np.degrees(TILT + np.arctan(slope))), float(speed)


def main() -> None:
    """Print the angles."""
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 1000
    for friction in (0.1, 0.5):
        began = time.process_time()
        angle, speed = angle_of_repose(count, friction)
        took = time.process_time() - began
        print(f"friction {friction}: {angle:.1f} degrees, mean speed {speed:.1e} radii/s, {took:.0f} s")
    print(f"published for 0.5: {PUBLISHED[0]:.0f} to {PUBLISHED[1]:.0f} degrees")


if __name__ == "__main__":
    main()
