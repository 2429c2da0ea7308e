"""Explicit steps read the nodes under spheres themselves: bit-identical to steps that evaluate their markers."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import dalembert as exu
from dalembert import itemInterface as eii
from dalembert.utilities import InertiaSphere

RADIUS = 0.1
SURFACE: dict[str, Any] = {"contactStiffness": 2e4, "contactDamping": 3.0, "frictionMaterialIndex": 0}
SOLVERS = ["ExplicitEuler", "VelocityVerlet", "RK44", "DOPRI5"]
NODES = [
    None,  # points
    exu.NodeType.RotationRotationVector,
    exu.NodeType.RotationEulerParameters,
    exu.NodeType.RotationRxyz,
]


class Heap:
    """Balls in three layers that press each other, with a sphere at a marker of each node."""

    def __init__(self, node: Any, friction: float = 0.3) -> None:
        self.mbs = exu.SystemContainer().AddSystem()
        self.turns = node is not None
        self.contact = self.mbs.AddGeneralContact()
        self.contact.SetFrictionPairings([[friction]])
        rng = np.random.default_rng(3)
        self.bodies, self.markers = [], []
        for place in np.mgrid[0:5, 0:5, 0:3].reshape(3, -1).T:
            motion: dict[str, Any] = {
                "referencePosition": list(1.95 * RADIUS * place + rng.uniform(-0.005, 0.005, 3)),
                "initialVelocity": list(rng.uniform(-1, 1, 3)),
            }
            if self.turns:
                spin, inertia = list(rng.uniform(-5, 5, 3)), InertiaSphere(1, RADIUS)
                body = self.mbs.CreateRigidBody(
                    **motion, initialAngularVelocity=spin, inertia=inertia, gravity=[0, 0, -9.81], nodeType=node
                )
            else:
                body = self.mbs.CreateMassPoint(**motion, physicsMass=1, gravity=[0, 0, -9.81])
            kind = eii.MarkerNodeRigid if self.turns else eii.MarkerNodePosition
            self.bodies.append(body)
            self.markers.append(self.mbs.AddMarker(kind(nodeNumber=self.mbs.GetObject(body)["nodeNumber"])))
            self.contact.AddSphereWithMarker(self.markers[-1], RADIUS, **SURFACE)

    def floor(self, body: Any) -> None:
        corners = [[-1, -1, -0.95 * RADIUS], [3, -1, -0.95 * RADIUS], [-1, 3, -0.95 * RADIUS]]
        marker = self.mbs.AddMarker(eii.MarkerBodyRigid(bodyNumber=body))
        self.contact.AddTrianglesRigidBodyBased(marker, pointList=corners, triangleList=[[0, 1, 2]], **SURFACE)

    def motion(self, solver: str, looked_at: bool, threads: int = 1, assemble: bool = True) -> tuple[bytes, ...]:
        """A function of the user may look at every marker after each step."""
        settings = exu.SimulationSettings()
        settings.solutionSettings.writeSolutionToFile = False
        settings.parallel.numberOfThreads = threads
        settings.timeIntegration.endTime, settings.timeIntegration.numberOfSteps = 0.02, 100
        settings.timeIntegration.verboseMode = 0
        if assemble:
            self.mbs.Assemble()
        self.mbs.SetPostStepUserFunction((lambda mbs, t: True) if looked_at else 0)
        self.mbs.SolveDynamic(settings, solverType=getattr(exu.DynamicSolverType, solver))
        data = self.mbs.systemData
        return data.GetODE2Coordinates().tobytes(), data.GetODE2Coordinates_t().tobytes()


def on_the_ground(heap: Heap) -> None:
    heap.floor(heap.mbs.CreateGround())


def on_a_plate_that_moves(heap: Heap) -> None:
    plate = heap.mbs.CreateRigidBody(
        inertia=InertiaSphere(10, 1),
        initialAngularVelocity=[0.2, 0.1, 0.3],
        nodeType=exu.NodeType.RotationRotationVector,
    )
    heap.floor(plate)


def with_springs_at_rigid_markers(heap: Heap) -> None:
    """The forces of which add up at nodes in any case."""
    ground = heap.mbs.AddMarker(eii.MarkerBodyPosition(bodyNumber=heap.mbs.CreateGround()))
    for marker in heap.markers[::3] if heap.turns else []:
        heap.mbs.AddObject(eii.CartesianSpringDamper(markerNumbers=[ground, marker], stiffness=[100, 200, 300]))


def with_loads_at_their_markers(heap: Heap) -> None:
    for k, marker in enumerate(heap.markers):
        heap.mbs.AddLoad(eii.Force(markerNumber=marker, loadVector=[k, 0, -1]))


def with_loads_that_turn_with_them(heap: Heap) -> None:
    for k, marker in enumerate(heap.markers):
        heap.mbs.AddLoad(eii.Force(markerNumber=marker, loadVector=[k, 0, -1], bodyFixed=heap.turns))


def with_spheres_at_points_of_bodies(heap: Heap) -> None:
    for body in heap.bodies[::4] if heap.turns else []:
        marker = heap.mbs.AddMarker(eii.MarkerBodyRigid(bodyNumber=body, localPosition=[0, 0, 1.2 * RADIUS]))
        heap.contact.AddSphereWithMarker(marker, RADIUS, **SURFACE)


def with_two_spheres_at_a_node(heap: Heap) -> None:
    heap.contact.AddSphereWithMarker(heap.markers[4], 1.5 * RADIUS, **SURFACE)


def in_two_contacts(heap: Heap) -> None:
    """The other of which needs all markers."""
    other = heap.mbs.AddGeneralContact()
    other.SetFrictionPairings([[0.1]])
    other.SetFrictionBristles(0.5)
    for marker in heap.markers[::2]:
        other.AddSphereWithMarker(marker, 1.2 * RADIUS, **SURFACE)


def beside_an_element(heap: Heap) -> None:
    """A read of coordinates shows the same, without a marker."""
    ends = [
        heap.mbs.AddNode(eii.NodePoint2DSlope1(referenceCoordinates=[5 + k, 0, 1, 0], initialVelocities=[0, k, 0, 0]))
        for k in (0, 1)
    ]
    stiff = {"physicsBendingStiffness": 10, "physicsAxialStiffness": 1e3}
    heap.mbs.AddObject(eii.Cable2D(nodeNumbers=ends, physicsLength=1, physicsMassPerLength=1, **stiff))


def beside_a_spring_between_coordinates(heap: Heap) -> None:
    mass = heap.mbs.AddNode(eii.Node1D(referenceCoordinates=[1.0], initialVelocities=[2.0]))
    heap.mbs.AddObject(eii.ObjectMass1D(physicsMass=1, nodeNumber=mass))
    ground = heap.mbs.AddNode(eii.NodePointGround())
    markers = [heap.mbs.AddMarker(eii.MarkerNodeCoordinate(nodeNumber=node, coordinate=0)) for node in (ground, mass)]
    heap.mbs.AddObject(eii.CoordinateSpringDamper(markerNumbers=markers, stiffness=100, offset=1))


COMPANY = [
    on_the_ground,
    on_a_plate_that_moves,
    with_springs_at_rigid_markers,
    with_loads_at_their_markers,
    with_loads_that_turn_with_them,
    with_spheres_at_points_of_bodies,
    with_two_spheres_at_a_node,
    in_two_contacts,
    beside_an_element,
    beside_a_spring_between_coordinates,
]


@pytest.mark.parametrize("company", COMPANY)
@pytest.mark.parametrize("node", NODES)
def test_heaps_move_as_with_markers_that_are_evaluated(node: Any, company: Any) -> None:
    found = []
    for looked_at in (True, False):
        heap = Heap(node)
        company(heap)
        found.append(heap.motion("ExplicitEuler", looked_at))
    assert found[0] == found[1]


@pytest.mark.parametrize("solver", SOLVERS)
@pytest.mark.parametrize("friction", [0.0, 0.3])
@pytest.mark.parametrize("node", NODES[:2])
def test_all_explicit_methods_do(node: Any, friction: float, solver: str) -> None:
    heaps = [Heap(node, friction) for _ in range(3)]
    for heap in heaps:
        on_a_plate_that_moves(heap)
    by_markers = heaps[0].motion(solver, True)
    assert heaps[1].motion(solver, False) == by_markers
    assert heaps[2].motion(solver, False, threads=2) == by_markers


def test_values_read_follow_parameters() -> None:
    """Spheres at reference points of bodies that go elsewhere need markers that nobody has needed in the solution before."""
    found = []
    for looked_at in (True, False):
        heap = Heap(NODES[1])
        markers = [heap.mbs.AddMarker(eii.MarkerBodyRigid(bodyNumber=body)) for body in heap.bodies[::4]]
        other = heap.mbs.AddGeneralContact()
        other.SetFrictionPairings([[0.1]])
        for marker in markers:
            other.AddSphereWithMarker(marker, 2 * RADIUS, **SURFACE)
        heap.motion("ExplicitEuler", looked_at)
        for marker in markers:
            heap.mbs.SetMarkerParameter(marker, "localPosition", [0, 0, 0.5 * RADIUS])
        assert heap.mbs.systemIsConsistent
        found.append(heap.motion("ExplicitEuler", looked_at, assemble=False))
    assert found[0] == found[1]


def test_points_on_springs_round_in_another_order() -> None:
    """Forces of springs and contact add up at the markers first, or at the nodes: 100 steps may change the last digits."""
    found = []
    for looked_at in (True, False):
        heap = Heap(None)
        ground = heap.mbs.AddMarker(eii.MarkerBodyPosition(bodyNumber=heap.mbs.CreateGround()))
        for marker in heap.markers[::3]:
            heap.mbs.AddObject(eii.CartesianSpringDamper(markerNumbers=[ground, marker], stiffness=[100, 200, 300]))
        heap.motion("ExplicitEuler", looked_at)
        found.append(heap.mbs.systemData.GetODE2Coordinates())
    np.testing.assert_allclose(found[1], found[0], rtol=0, atol=1e-13)  # of some 0.02 m


def test_markers_are_where_their_nodes_are_after_steps_that_did_not_need_them() -> None:
    heap = Heap(NODES[1])
    heap.motion("ExplicitEuler", False)
    position, spin = exu.OutputVariableType.Position, exu.OutputVariableType.AngularVelocity
    for body, marker in zip(heap.bodies, heap.markers, strict=True):
        node = heap.mbs.GetObject(body)["nodeNumber"]
        for output in (position, spin):
            assert heap.mbs.GetMarkerOutput(marker, output).tolist() == heap.mbs.GetNodeOutput(node, output).tolist()
