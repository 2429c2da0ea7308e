"""Chains of beam and cable elements along lines, arcs and reeving curves, and sliding joints on them.

Stiffness and mass of cross sections, for beams with 6x6 sections: ComputeSectionConstants.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from importlib import import_module
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from dalembert import itemInterface as eii
from dalembert._checks import FloatArray, as_vector, shape_error
from dalembert._geometry.reeving import CreateReevingCurve
from dalembert._tools.found_items import index_of
from dalembert._tools.missing_names import missing_in

if TYPE_CHECKING:
    from dalembert._fem.section_constants import (
        ComputeSectionConstants as ComputeSectionConstants,
    )
    from dalembert._fem.section_constants import (
        SectionConstants as SectionConstants,
    )
    from dalembert._fem.section_outlines import (
        SectionCircle as SectionCircle,
    )
    from dalembert._fem.section_outlines import (
        SectionI as SectionI,
    )
    from dalembert._fem.section_outlines import (
        SectionL as SectionL,
    )
    from dalembert._fem.section_outlines import (
        SectionOutline as SectionOutline,
    )
    from dalembert._fem.section_outlines import (
        SectionPolygon as SectionPolygon,
    )
    from dalembert._fem.section_outlines import (
        SectionRectangle as SectionRectangle,
    )
    from dalembert._fem.section_outlines import (
        SectionTube as SectionTube,
    )

__all__ = [
    "ComputeSectionConstants",
    "CreateReevingCurve",
    "GenerateAleSlidingJoint",
    "GenerateBeamElementsAlongLine",
    "GenerateCircularArcANCFCable2D",
    "GenerateSlidingJoint",
    "GenerateStraightBeam",
    "GenerateStraightLineANCFCable",
    "GenerateStraightLineANCFCable2D",
    "PointsAndSlopes2ANCFCable2D",
    "SectionCircle",
    "SectionConstants",
    "SectionI",
    "SectionL",
    "SectionOutline",
    "SectionPolygon",
    "SectionRectangle",
    "SectionTube",
]

Chain = list[list[Any]]  # [nodes, elements, loads, node positions, constraints]

# Node type and number of nodal coordinates by the type of the element.
_NODES = {
    "ObjectANCFCable2D": ("NodePoint2DSlope1", 4),
    "ObjectALEANCFCable2D": ("NodePoint2DSlope1", 4),
    "ObjectANCFCable": ("NodePointSlope1", 6),
    "ObjectBeamGeometricallyExact2D": ("NodeRigidBody2D", 3),
    "ObjectBeamGeometricallyExact": ("NodeRigidBodyRotVecLG", 6),
}


def _add_element(mbs: Any, template: Any, nodes: Sequence[Any], gravity: npt.ArrayLike, chain: Chain) -> None:
    """Add a copy of the template element on the nodes, and its weight if there is gravity (m/s^2)."""
    numbers = list(template.nodeNumbers)
    numbers[: len(nodes)] = nodes
    template.nodeNumbers = numbers
    element = mbs.AddObject(template)
    chain[1].append(element)
    if np.any(np.asarray(gravity) != 0):
        marker = mbs.AddMarker(eii.MarkerBodyMass(bodyNumber=element))
        chain[2].append(mbs.AddLoad(eii.LoadMassProportional(markerNumber=marker, loadVector=gravity)))


def _ground_marker(mbs: Any, position: Sequence[float]) -> Any:
    node = mbs.AddNode(eii.NodePointGround(referenceCoordinates=position))
    return mbs.AddMarker(eii.MarkerNodeCoordinate(nodeNumber=node, coordinate=0))


def _fix(mbs: Any, ground: Any, node: Any, flags: Sequence[float], chain: Chain, **view: Any) -> None:
    """Fix those coordinates of a node whose flag is not 0."""
    for coordinate, flag in enumerate(flags):
        if flag != 0:
            marker = mbs.AddMarker(eii.MarkerNodeCoordinate(nodeNumber=node, coordinate=coordinate))
            constraint = eii.ObjectConnectorCoordinate(markerNumbers=[ground, marker], **view)
            chain[4].append(mbs.AddObject(constraint))


def _given_node(mbs: Any, node: Any, where: str) -> Any:
    """Return the index of a node given by index, number or name; None if it is not given."""
    return None if node is None or node == -1 else index_of(mbs, "Node", node, where)


def _check_number(function: str, numberOfElements: Any) -> None:
    if numberOfElements != int(numberOfElements) or numberOfElements <= 0:
        raise shape_error(f"{function}: numberOfElements", "a positive integer", numberOfElements)


def _turn_from_x(direction: FloatArray) -> list[float]:
    """Rotation vector of the smallest rotation from the x axis to a unit vector."""
    axis = np.array([0.0, -direction[2], direction[1]])
    sine = float(np.linalg.norm(axis))
    if sine == 0.0:
        return [0.0, 0.0, 0.0 if direction[0] > 0 else np.pi]
    return (np.arctan2(sine, direction[0]) / sine * axis).tolist()


def GenerateStraightBeam(
    mbs: Any,
    positionOfNode0: Sequence[float],
    positionOfNode1: Sequence[float],
    numberOfElements: int,
    beamTemplate: Any,
    gravity: npt.ArrayLike = [0, 0, 0],
    fixedConstraintsNode0: Sequence[float] | None = None,
    fixedConstraintsNode1: Sequence[float] | None = None,
    nodeNumber0: Any = -1,
    nodeNumber1: Any = -1,
) -> Chain:
    """Add equal elements along a straight line between two positions (m).

    The template is an ANCF cable (2D, 3D, ALE), a geometrically exact beam, or one in 2D with two or three nodes; its
    length and node numbers are overwritten. Spatial beams turn from x to the line by the shortest way. Flags that
    are not 0 fix coordinates of the end nodes; existing nodes may be given for the ends. Returns
    [nodes, elements, loads, node positions, constraints].
    """
    function = "GenerateStraightBeam"
    kind = type(beamTemplate).__name__
    if kind not in _NODES:
        raise shape_error(f"{function}: beamTemplate", f"one of {', '.join(_NODES)}", beamTemplate)
    node_type, size = getattr(eii, _NODES[kind][0]), _NODES[kind][1]
    _check_number(function, numberOfElements)
    for end, flags in enumerate((fixedConstraintsNode0, fixedConstraintsNode1)):
        if flags is not None and (len(flags) < size or np.any(np.asarray(flags[size:]) != 0)):
            raise shape_error(f"{function}: fixedConstraintsNode{end}", f"{size} flags for {kind}", flags)
    start = as_vector(f"{function}: positionOfNode0", positionOfNode0, 3)
    line = as_vector(f"{function}: positionOfNode1", positionOfNode1, 3) - start
    length = float(np.linalg.norm(line))
    if length == 0:
        raise shape_error(f"{function}: positionOfNode1", "another position than that of node 0", positionOfNode1)
    slope = line / length
    is_planar, is_exact = "2D" in kind, "GeometricallyExact" in kind
    if is_planar and (positionOfNode0[2] != 0 or positionOfNode1[2] != 0):
        raise shape_error(f"{function}: positionOfNode0, positionOfNode1", f"z=0 for {kind}", positionOfNode0)

    dimension = 2 if is_planar else 3
    if is_exact:
        direction = [float(np.arctan2(slope[1], slope[0]))] if is_planar else _turn_from_x(slope)
    else:
        direction = list(slope[:dimension])

    def add_node(position: Sequence[float]) -> Any:
        return mbs.AddNode(node_type(referenceCoordinates=[*position[:dimension], *direction]))

    first = _given_node(mbs, nodeNumber0, f"{function}: nodeNumber0")
    last = _given_node(mbs, nodeNumber1, f"{function}: nodeNumber1")
    chain: Chain = [[], [], [], [positionOfNode0], []]
    nodes, positions = chain[0], chain[3]
    nodes.append(add_node(positionOfNode0) if first is None else first)
    beamTemplate.physicsLength = length / numberOfElements
    # number of intervals between the ends of an element
    intervals = 2 if is_exact and len(beamTemplate.nodeNumbers) == 3 else 1
    for i in range(int(numberOfElements)):
        for j in range(1, intervals + 1):
            positions.append((start + line * ((i + j / intervals) / numberOfElements)).tolist())
            is_last = i == numberOfElements - 1 and j == intervals
            nodes.append(last if is_last and last is not None else add_node(positions[-1]))
        _add_element(mbs, beamTemplate, nodes[-intervals - 1 :], gravity, chain)

    ends = ((nodes[0], positionOfNode0, fixedConstraintsNode0), (nodes[-1], positionOfNode1, fixedConstraintsNode1))
    for node, position, flags in ends:
        if flags is not None:
            _fix(mbs, _ground_marker(mbs, position), node, flags, chain)
    return chain


def GenerateStraightLineANCFCable2D(
    mbs: Any,
    positionOfNode0: Sequence[float],
    positionOfNode1: Sequence[float],
    numberOfElements: int,
    cableTemplate: Any,
    massProportionalLoad: npt.ArrayLike = [0, 0, 0],
    fixedConstraintsNode0: Sequence[float] = [0, 0, 0, 0],
    fixedConstraintsNode1: Sequence[float] = [0, 0, 0, 0],
    nodeNumber0: Any = -1,
    nodeNumber1: Any = -1,
) -> Chain:
    """Add planar cable elements along a straight line; arguments and result as in GenerateStraightBeam."""
    constraints = (fixedConstraintsNode0, fixedConstraintsNode1, nodeNumber0, nodeNumber1)
    ends = (positionOfNode0, positionOfNode1)
    return GenerateStraightBeam(mbs, *ends, numberOfElements, cableTemplate, massProportionalLoad, *constraints)


def GenerateStraightLineANCFCable(
    mbs: Any,
    positionOfNode0: Sequence[float],
    positionOfNode1: Sequence[float],
    numberOfElements: int,
    cableTemplate: Any,
    massProportionalLoad: npt.ArrayLike = [0, 0, 0],
    fixedConstraintsNode0: Sequence[float] = [0, 0, 0, 0, 0, 0],
    fixedConstraintsNode1: Sequence[float] = [0, 0, 0, 0, 0, 0],
    nodeNumber0: Any = -1,
    nodeNumber1: Any = -1,
) -> Chain:
    """Add spatial cable elements along a straight line; arguments and result as in GenerateStraightBeam."""
    constraints = (fixedConstraintsNode0, fixedConstraintsNode1, nodeNumber0, nodeNumber1)
    ends = (positionOfNode0, positionOfNode1)
    return GenerateStraightBeam(mbs, *ends, numberOfElements, cableTemplate, massProportionalLoad, *constraints)


def GenerateBeamElementsAlongLine(
    mbs: Any,
    positionStart: Sequence[float],
    positionEnd: Sequence[float],
    numberOfElements: int,
    beamTemplate: Any = None,
    gravity: npt.ArrayLike = [0, 0, 0],
    groundConstraintsStart: Sequence[float] | None = None,
    groundConstraintsEnd: Sequence[float] | None = None,
    nodeNumberStart: Any = None,
    nodeNumberEnd: Any = None,
    EI: Any = None,
    EA: Any = None,
    GA: Any = None,
) -> dict[str, list[Any]]:
    """Add elements as GenerateStraightBeam does; return nodes, elements, nodePositions, constraintObjects and loads."""
    constraints = (groundConstraintsStart, groundConstraintsEnd, nodeNumberStart, nodeNumberEnd)
    ends = (positionStart, positionEnd)
    chain = GenerateStraightBeam(mbs, *ends, numberOfElements, beamTemplate, gravity, *constraints)
    return dict(zip(("nodes", "elements", "loads", "nodePositions", "constraintObjects"), chain, strict=True))


def GenerateCircularArcANCFCable2D(
    mbs: Any,
    positionOfNode0: Sequence[float],
    radius: float,
    startAngle: float,
    arcAngle: float,
    numberOfElements: int,
    cableTemplate: Any,
    massProportionalLoad: npt.ArrayLike = [0, 0, 0],
    fixedConstraintsNode0: Sequence[float] = [0, 0, 0, 0],
    fixedConstraintsNode1: Sequence[float] = [0, 0, 0, 0],
    nodeNumber0: Any = -1,
    nodeNumber1: Any = -1,
    setCurvedReferenceConfiguration: bool = True,
    verboseMode: bool = False,
) -> Chain:
    """Add planar cable elements along an arc that starts at a position (m) with a slope angle (rad).

    A positive arcAngle (rad) turns counter-clockwise. setCurvedReferenceConfiguration makes the arc free of stress.
    Returns [nodes, elements, loads, node positions, constraints].
    """
    function = "GenerateCircularArcANCFCable2D"
    _check_number(function, numberOfElements)
    if radius <= 0:
        raise shape_error(f"{function}: radius", "a positive number", radius)
    if arcAngle == 0:
        raise shape_error(f"{function}: arcAngle", "an angle that is not 0", arcAngle)
    signed = float(np.sign(arcAngle)) * radius
    center = np.array(positionOfNode0[:2]) + signed * np.array([-np.sin(startAngle), np.cos(startAngle)])

    def point_and_slope(angle: float) -> FloatArray:
        slope = np.array([np.cos(angle), np.sin(angle)])
        return np.concatenate([center + signed * np.array([slope[1], -slope[0]]), slope])

    def add_node(angle: float) -> Any:
        return mbs.AddNode(eii.NodePoint2DSlope1(referenceCoordinates=list(point_and_slope(angle))))

    first = _given_node(mbs, nodeNumber0, f"{function}: nodeNumber0")
    last = _given_node(mbs, nodeNumber1, f"{function}: nodeNumber1")
    chain: Chain = [[], [], [], [positionOfNode0], []]
    nodes, positions = chain[0], chain[3]
    nodes.append(add_node(startAngle) if first is None else first)
    curvature = cableTemplate.physicsReferenceCurvature
    cableTemplate.physicsLength = radius * abs(arcAngle) / numberOfElements
    if setCurvedReferenceConfiguration:
        cableTemplate.physicsReferenceCurvature = 1.0 / signed
    for i in range(1, int(numberOfElements) + 1):
        angle = startAngle + i * arcAngle / numberOfElements
        positions.append([*point_and_slope(angle)[:2].tolist(), 0.0])
        nodes.append(last if i == numberOfElements and last is not None else add_node(angle))
        _add_element(mbs, cableTemplate, nodes[-2:], massProportionalLoad, chain)
    cableTemplate.physicsReferenceCurvature = curvature

    if any(flag != 0 for flag in (*fixedConstraintsNode0, *fixedConstraintsNode1)):
        ground = _ground_marker(mbs, [0, 0, 0])
        _fix(mbs, ground, nodes[0], fixedConstraintsNode0, chain)
        _fix(mbs, ground, nodes[-1], fixedConstraintsNode1, chain)
    return chain


def PointsAndSlopes2ANCFCable2D(
    mbs: Any,
    ancfPointsSlopes: Sequence[Sequence[float]],
    elementLengths: Sequence[float],
    cableTemplate: Any,
    massProportionalLoad: npt.ArrayLike = [0, 0, 0],
    fixedConstraintsNode0: Sequence[float] = [0, 0, 0, 0],
    fixedConstraintsNode1: Sequence[float] = [0, 0, 0, 0],
    firstNodeIsLastNode: bool = True,
    elementCurvatures: Sequence[float] = [],
    graphicsSizeConstraints: float = -1,
) -> Chain:
    """Add planar cable elements between given points and slopes [x, y, x', y'], e.g. of CreateReevingCurve.

    Lengths (m) and reference curvatures (1/m) are per element; firstNodeIsLastNode closes the curve. Returns [nodes,
    elements, loads, node positions (x, y, 0 one after the other), constraints].
    """
    has_constraints = any(flag != 0 for flag in (*fixedConstraintsNode0, *fixedConstraintsNode1))
    if firstNodeIsLastNode and any(flag != 0 for flag in fixedConstraintsNode1):
        name = "PointsAndSlopes2ANCFCable2D: fixedConstraintsNode1"
        raise shape_error(name, "[0,0,0,0], because the last node is the first one", fixedConstraintsNode1)

    chain: Chain = [[], [], [], [], []]
    nodes, last = chain[0], len(ancfPointsSlopes) - 1
    for i, coordinates in enumerate(ancfPointsSlopes):
        closes = i == last and firstNodeIsLastNode and i > 0
        node = eii.NodePoint2DSlope1(referenceCoordinates=coordinates)
        nodes.append(nodes[0] if closes else mbs.AddNode(node))
        chain[3] += [coordinates[0], coordinates[1], 0]
        if i > 0:
            cableTemplate.physicsLength = elementLengths[i - 1]
            if len(elementCurvatures) != 0:
                cableTemplate.physicsReferenceCurvature = elementCurvatures[i - 1]
            _add_element(mbs, cableTemplate, nodes[-2:], massProportionalLoad, chain)
    if has_constraints:
        ground = _ground_marker(mbs, [0, 0, 0])
        view = eii.VObjectConnectorCoordinate(drawSize=graphicsSizeConstraints)
        _fix(mbs, ground, nodes[0], fixedConstraintsNode0, chain, visualization=view)
        _fix(mbs, ground, nodes[-1], fixedConstraintsNode1, chain, visualization=view)
    return chain


def _sliding_parameters(mbs: Any, cables: Sequence[Any], slidingMarker: Any, start: int) -> dict[str, Any]:
    """Add a marker per cable element; return the markers of a sliding joint, and where each element starts (m)."""
    markers = [mbs.AddMarker(eii.MarkerBodyCable2DCoordinates(bodyNumber=cable)) for cable in cables]
    lengths = [mbs.GetObjectParameter(cable, "physicsLength") for cable in cables]
    return {
        "markerNumbers": [slidingMarker, markers[start]],
        "slidingMarkerNumbers": markers,
        "slidingMarkerOffsets": [float(x) for x in np.cumsum([0.0, *lengths[:-1]])],
    }


def GenerateSlidingJoint(
    mbs: Any,
    cableObjectList: Sequence[Any],
    markerBodyPositionOfSlidingBody: Any,
    localMarkerIndexOfStartCable: int = 0,
    slidingCoordinateStartPosition: float = 0,
) -> list[Any]:
    """Let a position marker slide along planar cable elements; return a list with the joint's ObjectIndex.

    It starts on the element with the given index in the list, at a position (m) along the whole cable.
    """
    start = localMarkerIndexOfStartCable
    parameters = _sliding_parameters(mbs, cableObjectList, markerBodyPositionOfSlidingBody, start)
    state = eii.NodeGenericData(initialCoordinates=[start, slidingCoordinateStartPosition], numberOfDataCoordinates=2)
    return [mbs.AddObject(eii.ObjectJointSliding2D(**parameters, nodeNumber=mbs.AddNode(state)))]


def GenerateAleSlidingJoint(
    mbs: Any,
    cableObjectList: Sequence[Any],
    markerBodyPositionOfSlidingBody: Any,
    AleNode: Any,
    localMarkerIndexOfStartCable: int = 0,
    AleSlidingOffset: float = 0,
    activeConnector: bool = True,
    penaltyStiffness: float = 0,
) -> list[Any]:
    """Hold a position marker on a cable that moves axially (ALE elements); return a list with the joint's ObjectIndex.

    AleSlidingOffset in m; a penaltyStiffness (N/m) that is not 0 replaces the constraint by a spring.
    """
    start = localMarkerIndexOfStartCable
    parameters = _sliding_parameters(mbs, cableObjectList, markerBodyPositionOfSlidingBody, start)
    state = mbs.AddNode(eii.NodeGenericData(initialCoordinates=[start], numberOfDataCoordinates=1))
    joint = eii.ObjectJointALEMoving2D(
        **parameters,
        nodeNumbers=[state, AleNode],
        slidingOffset=AleSlidingOffset,
        activeConnector=activeConnector,
        usePenaltyFormulation=penaltyStiffness != 0,
        penaltyStiffness=penaltyStiffness,
    )
    return [mbs.AddObject(joint)]


# ---- cross sections, loaded when they are first used -----------------------------------------------------------------

if not TYPE_CHECKING:

    def __getattr__(name: str) -> Any:
        if name in __all__:
            place = "constants" if name.endswith("SectionConstants") else "outlines"
            return getattr(import_module(f"dalembert._fem.section_{place}"), name)
        raise missing_in(sys.modules[__name__], name)
