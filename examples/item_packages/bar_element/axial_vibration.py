"""The axial vibration of a bar that is fixed at one end: its frequency by finite elements, and the exact one."""

import numpy as np
from bar_element import Bar

import dalembert as exu
from dalembert.itemInterface import *

length, stiffness, massPerLength, n = 1.0, 1e4, 0.5, 16
mbs = exu.SystemContainer().AddSystem()
ground = mbs.AddNode(NodePointGround())
rest = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=ground, coordinate=0))
nodes = [mbs.AddNode(NodePoint(referenceCoordinates=[x, 0, 0])) for x in np.linspace(0, length, n + 1)]
for pair in zip(nodes, nodes[1:], strict=False):
    mbs.AddObject(
        Bar(
            physicsLength=length / n,
            physicsMassPerLength=massPerLength,
            physicsAxialStiffness=stiffness,
            nodeNumbers=pair,
        )
    )
for node in nodes:  # moves along x, the first one not at all
    for coordinate in range(3) if node == nodes[0] else (1, 2):
        marker = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=node, coordinate=coordinate))
        mbs.AddObject(CoordinateConstraint(markerNumbers=[rest, marker]))
mbs.Assemble()
found = float(mbs.ComputeODE2Eigenvalues(numberOfEigenvalues=1, convert2Frequencies=True)[0][0])
exact = np.sqrt(stiffness / massPerLength) / (4 * length)
print(f"frequency {found:.4f} Hz, exact {exact:.4f} Hz")
