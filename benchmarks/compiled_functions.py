"""How long a solution takes with a spring law and a force in time in Python, and with both compiled by numba.

Needs numba. Run it as `python benchmarks/compiled_functions.py`.
"""

import math
import time

import numba

import dalembert as db
from dalembert import compiled


def spring(mbs, t, itemNumber, displacement, velocity, stiffness, damping, offset):
    return stiffness * (displacement - offset) + damping * velocity + 1e4 * displacement**3


def sweep(mbs, t, load):
    return load * math.sin(30 * t)


@numba.cfunc(compiled.numba_signature(db.ObjectConnectorCoordinateSpringDamper, "springForceUserFunction"))
def compiledSpring(t, itemNumber, displacement, velocity, stiffness, damping, offset):
    return stiffness * (displacement - offset) + damping * velocity + 1e4 * displacement**3


@numba.cfunc(compiled.numba_signature(db.LoadCoordinate, "loadUserFunction"))
def compiledSweep(t, load):
    return load * math.sin(30 * t)


def solve(springFunction, loadFunction, solverType, steps, stepSize):
    """Duration in s and final displacement in m of a mass on a spring."""
    mbs = db.SystemContainer().AddSystem()
    node = mbs.AddNode(db.NodePoint(initialCoordinates=[0.01, 0, 0]))
    mbs.AddObject(db.MassPoint(physicsMass=2, nodeNumber=node))
    rest = mbs.AddMarker(db.MarkerNodeCoordinate(nodeNumber=mbs.AddNode(db.NodePointGround()), coordinate=0))
    tip = mbs.AddMarker(db.MarkerNodeCoordinate(nodeNumber=node, coordinate=0))
    mbs.AddObject(
        db.CoordinateSpringDamper(
            markerNumbers=[rest, tip], stiffness=3000, damping=5, springForceUserFunction=springFunction
        )
    )
    mbs.AddLoad(db.LoadCoordinate(markerNumber=tip, load=20, loadUserFunction=loadFunction))
    mbs.Assemble()
    settings = db.SimulationSettings()
    settings.timeIntegration.numberOfSteps = steps
    settings.timeIntegration.endTime = steps * stepSize
    settings.timeIntegration.verboseMode = 0
    settings.solutionSettings.writeSolutionToFile = False
    start = time.perf_counter()
    mbs.SolveDynamic(settings, solverType=solverType)
    return time.perf_counter() - start, mbs.GetNodeOutput(node, db.OutputVariableType.Displacement)[0]


for solverType, steps, stepSize in [
    (db.DynamicSolverType.ExplicitEuler, 200000, 1e-5),
    (db.DynamicSolverType.GeneralizedAlpha, 50000, 1e-4),
]:
    inPython, x = min(solve(spring, sweep, solverType, steps, stepSize) for _ in range(3))
    inC, y = min(solve(compiledSpring, compiledSweep, solverType, steps, stepSize) for _ in range(3))
    print(f"{solverType}: Python {inPython:.3f} s, numba {inC:.3f} s, ratio {inPython / inC:.1f}; {x:.12g} {y:.12g}")
