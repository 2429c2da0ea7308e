"""Time per state of a chain of links: steps of RK44, states side by side, and MuJoCo and Pinocchio where installed.

Run it as `python benchmarks/tree_states.py [LINKS ...]` (pip install mujoco pin, in an environment of their own). A
step of RK44 is four states; MuJoCo's is one, as its method is Euler's, and its files are not nested deeper than 100
links. Pinocchio is called from Python: some 1.5 microseconds of each state are the call; its data grow with the cube of
the links.
"""

from __future__ import annotations

import importlib.util
import sys
import time
from collections.abc import Callable
from typing import Any

import numpy as np

import dalembert as exu
from dalembert import itemInterface as items
from dalembert.treeDynamics import TreeDynamics

LENGTH, SIDE, MASS, GRAVITY = 0.2, 0.04, 0.64, [0.0, -9.81, 2.0]
COM = [LENGTH / 2, 0, 0]
INERTIA = MASS / 12 * np.diag([2 * SIDE**2, LENGTH**2 + SIDE**2, LENGTH**2 + SIDE**2])
TURN = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]])  # from each axis to the next


def transformation(i: int) -> Any:
    """Axes of link i in those of the link before: the axes of the joints alternate."""
    return np.eye(3) if i == 0 else (TURN if i % 2 else TURN.T)


def offset(i: int) -> list[float]:
    return [LENGTH if i else 0, 0, 0]


def start(links: int) -> Any:
    return 0.1 * (-1.0) ** np.arange(links)


def chain(links: int, **node: Any) -> Any:
    return items.ObjectKinematicTree(
        jointTypes=[exu.JointType.RevoluteZ] * links,
        linkParents=list(range(-1, links - 1)),
        jointTransformations=exu.Matrix3DList([transformation(i) for i in range(links)]),
        jointOffsets=exu.Vector3DList([offset(i) for i in range(links)]),
        linkInertiasCOM=exu.Matrix3DList([INERTIA] * links),
        linkCOMs=exu.Vector3DList([COM] * links),
        linkMasses=[MASS] * links,
        gravity=GRAVITY,
        **node,
    )


def shortest(solve: Callable[[], Any], states: int, repeat: int = 5) -> float:
    """Return microseconds per state."""
    times = []
    for _ in range(repeat):
        before = time.perf_counter()
        solve()
        times.append(time.perf_counter() - before)
    return 1e6 * min(times) / states


def in_steps(links: int, steps: int) -> float:
    mbs = exu.SystemContainer().AddSystem()
    values = {"initialCoordinates": start(links), "initialCoordinates_t": np.zeros(links)}
    node = items.NodeGenericODE2(referenceCoordinates=np.zeros(links), numberOfODE2Coordinates=links, **values)
    mbs.AddObject(chain(links, nodeNumber=mbs.AddNode(node)))
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = steps
    settings.timeIntegration.endTime = 2e-4 * steps
    settings.timeIntegration.verboseMode = 0
    settings.solutionSettings.writeSolutionToFile = False
    return shortest(lambda: mbs.SolveDynamic(settings, solverType=exu.DynamicSolverType.RK44), 4 * steps)


def side_by_side(links: int, states: int) -> float:
    tree = TreeDynamics(chain(links))
    q, v, forces = np.random.default_rng(0).uniform(-1, 1, (3, states, links))
    return shortest(lambda: tree.ForwardDynamics(q, v, forces), states)


def in_mujoco(links: int, steps: int) -> float:
    import mujoco

    bodies = ""
    for i in reversed(range(links)):
        quaternion = np.empty(4)
        mujoco.mju_mat2Quat(quaternion, transformation(i).ravel())
        numbers = {"pos": offset(i), "quat": quaternion}
        place = " ".join(f'{key}="{" ".join(map(str, value))}"' for key, value in numbers.items())
        mass = f'mass="{MASS}" pos="{LENGTH / 2} 0 0" diaginertia="{" ".join(map(str, np.diag(INERTIA)))}"'
        bodies = f'<body {place}><inertial {mass}/><joint type="hinge" axis="0 0 1"/>{bodies}</body>'
    option = f'<option gravity="{" ".join(map(str, GRAVITY))}" timestep="0.0002" integrator="Euler"/>'
    model = mujoco.MjModel.from_xml_string(f"<mujoco>{option}<worldbody>{bodies}</worldbody></mujoco>")
    data = mujoco.MjData(model)
    data.qpos = start(links)
    return shortest(lambda: mujoco.mj_step(model, data, steps), steps)


def in_pinocchio(links: int, states: int) -> float:
    import pinocchio as pin

    model, joint = pin.Model(), 0
    model.gravity.linear = np.array(GRAVITY)
    for i in range(links):
        frame = pin.SE3(transformation(i), np.array(offset(i), dtype=float))
        joint = model.addJoint(joint, pin.JointModelRZ(), frame, f"joint{i}")
        model.appendBodyToJoint(joint, pin.Inertia(MASS, np.array(COM), INERTIA), pin.SE3.Identity())
    data, q, v, forces = model.createData(), start(links), np.zeros(links), np.zeros(links)

    def solve() -> None:
        for _ in range(states):
            pin.aba(model, data, q, v, forces)

    return shortest(solve, states)


def main() -> None:
    print("microseconds per state\n\n links    RK44   side by side   MuJoCo   Pinocchio")
    for links in [int(given) for given in sys.argv[1:]] or [7, 30, 100, 300, 1000]:
        count = max(100, 40000 // links)
        others = [("mujoco", in_mujoco, 100), ("pinocchio", in_pinocchio, 300)]
        times = [
            solve(links, count) if importlib.util.find_spec(name) and links <= most else np.nan
            for name, solve, most in others
        ]
        own = f"{in_steps(links, count):7.3f} {side_by_side(links, 4096):14.3f}"
        print(f"{links:6d} {own} {times[0]:8.3f} {times[1]:11.3f}")


if __name__ == "__main__":
    main()
