"""Small models that show that the package works."""

from __future__ import annotations

from typing import Any

import dalembert as exu
from dalembert import graphics
from dalembert import itemInterface as eii
from dalembert.rigidBodyUtilities import InertiaCuboid


def DemoInfo() -> None:
    """Say where to go on."""
    exu.Print("The folder examples of the source holds more models; 'dalembert items' lists all items.")


def Demo1(showAll: bool = True) -> list[Any]:
    """Push a planar mass of 10 kg by 1 mN for one second; return [mbs, SC]."""
    SC = exu.SystemContainer()
    mbs = SC.AddSystem()
    node = mbs.AddNode(eii.NodePoint2D(referenceCoordinates=[0, 0]))
    mbs.AddObject(eii.ObjectMassPoint2D(physicsMass=10, nodeNumber=node))
    marker = mbs.AddMarker(eii.MarkerNodePosition(nodeNumber=node))
    mbs.AddLoad(eii.LoadForceVector(markerNumber=marker, loadVector=[0.001, 0, 0]))
    mbs.Assemble()

    settings = exu.SimulationSettings()
    settings.timeIntegration.verboseMode = int(showAll)
    settings.solutionSettings.writeSolutionToFile = bool(showAll)
    settings.solutionSettings.coordinatesSolutionFileName = "solution/demo1.txt"
    mbs.SolveDynamic(settings)
    if showAll:
        x = mbs.GetNodeOutput(node, exu.OutputVariableType.Displacement)[0]
        exu.Print(f"displacement {x:.6g} m, exact 5e-05 m; the solution is in solution/demo1.txt")
        DemoInfo()
    return [mbs, SC]


def Demo2(showAll: bool = True) -> list[Any]:
    """Let a chain of 12 rigid bodies with ball joints fall under gravity; return [mbs, SC]."""
    SC = exu.SystemContainer()
    mbs = SC.AddSystem()
    half, size, above = 0.3, 0.1, 0.1  # half the distance of joints, thickness, offset of joints from the axis, in m
    inertia = InertiaCuboid(density=1000, sideLengths=[2 * half, 2 * size, 2 * size])
    last = mbs.CreateGround(referencePosition=[0, 0, 0])
    for i in range(12):
        center = [(2 * i + 1) * half, 0, 0]
        body = mbs.CreateRigidBody(
            name=f"link{i}",
            referencePosition=center,
            inertia=inertia,
            gravity=[0, -9.81, 0],
            graphicsDataList=[graphics.Brick(size=[1.8 * half, 2 * size, 2 * size], color=graphics.color.dodgerblue)],
        )
        mbs.CreateSphericalJoint(bodyNumbers=[last, body], position=[2 * i * half, 0, above], jointRadius=0.6 * size)
        last = body
    mbs.Assemble()

    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = 2000 if showAll else 200
    settings.timeIntegration.endTime = 2.0 if showAll else 0.2
    settings.timeIntegration.verboseMode = int(showAll)
    settings.timeIntegration.newton.useModifiedNewton = True
    settings.timeIntegration.generalizedAlpha.spectralRadius = 0.6
    settings.solutionSettings.writeSolutionToFile = bool(showAll)
    settings.solutionSettings.solutionWritePeriod = settings.timeIntegration.endTime / 100
    settings.solutionSettings.coordinatesSolutionFileName = "solution/chain.txt"
    settings.linearSolverType = exu.LinearSolverType.EigenSparse
    mbs.SolveDynamic(settings)
    if showAll:
        end = mbs.GetObjectOutputBody(last, exu.OutputVariableType.Position, localPosition=[half, 0, above])
        exu.Print(f"the end of the chain is at {end} m; the solution is in solution/chain.txt")
        mbs.SolutionViewer()
        DemoInfo()
    return [mbs, SC]
