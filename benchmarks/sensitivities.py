"""Cost of exact sensitivities of a chain of bodies, in units of a solution without them.

`python benchmarks/sensitivities.py > docs/data/sensitivities.txt`. Masses and stiffnesses of all links are parameters,
the place of the tip is the output. Solutions with and without derivatives take turns; the fastest of some rounds
counts, in seconds that the core has computed.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Callable
from typing import Any

import dalembert as exu
from dalembert.itemInterface import SensorBody
from dalembert.utilities import InertiaCuboid

BODIES, STEPS = 50, 500


def chain(bodies: int) -> Any:
    """A chain of bodies with hinges and torsional springs that hangs between its ends and falls."""
    mbs = exu.SystemContainer().AddSystem()
    last = mbs.CreateGround()
    for i in range(bodies):
        body = mbs.CreateRigidBody(
            f"body {i}",
            referencePosition=[i + 0.5, 0, 0],
            inertia=InertiaCuboid(1000, [1, 0.1, 0.1]),
            gravity=[0, -9.81, 0],
            nodeType=exu.NodeType.RotationRotationVector,
        )
        pair, position, axis = [last, body], [i, 0, 0], [0, 0, 1]
        mbs.CreateRevoluteJoint(bodyNumbers=pair, position=position, axis=axis)
        mbs.CreateTorsionalSpringDamper(
            f"spring {i}", bodyNumbers=pair, position=position, axis=axis, stiffness=1e4, damping=10
        )
        last = body
    mbs.AddSensor(SensorBody(bodyNumber=last, outputVariableType=exu.OutputVariableType.Position, name="tip"))
    mbs.Assemble()
    return mbs


def seconds(function: Callable[[], Any]) -> float:
    begin = time.process_time()
    function()
    return time.process_time() - begin


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bodies", type=int, default=BODIES)
    parser.add_argument("--steps", type=int, default=STEPS)
    parser.add_argument("--rounds", type=int, default=3)
    given = parser.parse_args()

    mbs = chain(given.bodies)
    settings = exu.SimulationSettings()
    settings.timeIntegration.endTime, settings.timeIntegration.numberOfSteps = 1e-3 * given.steps, given.steps
    settings.timeIntegration.generalizedAlpha.spectralRadius = 0.6
    settings.timeIntegration.verboseMode = 0
    settings.solutionSettings.writeSolutionToFile = False
    masses = {f"m{i}": (f"body {i}", "physicsMass") for i in range(given.bodies)}
    parameters = masses | {f"k{i}": (f"spring {i}", "stiffness") for i in range(given.bodies)}
    outputs = {"y": exu.At("tip", component=1)}

    def derivatives(method: Any, count: int) -> Callable[[], Any]:
        chosen = dict(list(parameters.items())[:count])
        return lambda: mbs.ComputeSensitivities(chosen, outputs, settings, method=method)

    runs: dict[str, Callable[[], Any]] = {
        "solution": lambda: mbs.SolveDynamic(settings),
        "adjoint": derivatives("adjoint", 2 * given.bodies),
        "forward": derivatives("forward", 2 * given.bodies),
        "forward, one parameter": derivatives("forward", 1),
    }
    best = dict.fromkeys(runs, float("inf"))
    for _ in range(given.rounds):
        for name, run in runs.items():
            best[name] = min(best[name], seconds(run))
    print(f"{given.bodies} bodies, {given.steps} steps, {2 * given.bodies} parameters, one output")
    print(f"{'':24s}{'seconds':>10s}{'solutions':>12s}")
    for name, taken in best.items():
        print(f"{name:24s}{taken:10.3f}{taken / best['solution']:12.2f}")
    extra = (best["forward"] - best["forward, one parameter"]) / (2 * given.bodies - 1) / best["solution"]
    print(f"{'per further parameter':24s}{'':10s}{extra:12.3f}")


if __name__ == "__main__":
    main()
