"""Create functions of cables and beams between two points, and of hydraulic cylinders."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Literal

import numpy as np

from dalembert import itemInterface as items
from dalembert._checks import FloatArray
from dalembert._core import MainSystem, ObjectIndex
from dalembert.create._arguments import (
    DEFAULT_COLOR,
    FLAG,
    NO_PAIR,
    NOT_NEGATIVE,
    POSITIVE,
    ZERO3,
    Check,
    Connected,
    Vector,
    argument_error,
    vector,
)
from dalembert.create._arguments import color as color_check
from dalembert.create._frames import (
    add_end_markers,
    connector_ends,
    end_distance,
)
from dalembert.rigidBodyUtilities import ComputeOrthonormalBasis

Support = Literal["free", "hinged", "clamped"]
_SUPPORTS = ("free", "hinged", "clamped")


def _require_line(function: str, start: Vector, end: Vector, supports: Sequence[str], numberOfElements: Any) -> None:
    if np.array_equal(start, end):
        raise argument_error(function, "end", "another point than start", list(end))
    if (
        not isinstance(numberOfElements, (int, np.integer))
        or isinstance(numberOfElements, bool)
        or numberOfElements < 1
    ):
        raise argument_error(function, "numberOfElements", "a whole number greater than zero", numberOfElements)
    if len(supports) != 2 or any(each not in _SUPPORTS for each in supports):
        raise argument_error(function, "supports", "two of 'free', 'hinged' and 'clamped'", supports)


def _flags(support: str, clamped: list[int]) -> list[int] | None:
    """Return which of the six coordinates of an end node are fixed; the first three are its position."""
    return {"free": None, "hinged": [1, 1, 1, 0, 0, 0], "clamped": clamped}[support]


def _hold_slope(mbs: Any, node: Any, line: FloatArray) -> None:
    """Fix the direction of a slope, not its length, which is the axial strain."""
    across = ComputeOrthonormalBasis(line)[:, 1:].T
    ground = mbs.AddNode(items.NodePointGround(visualization=items.VNodePointGround(show=False)))
    markers = [mbs.AddMarker(items.MarkerNodeCoordinates(nodeNumber=each)) for each in (ground, node)]
    mbs.AddObject(
        items.ObjectConnectorCoordinateVector(
            markerNumbers=markers,
            scalingMarker0=np.zeros((2, 0)),
            scalingMarker1=np.hstack([np.zeros((2, 3)), across]),
            visualization=items.VObjectConnectorCoordinateVector(show=False),
        )
    )


def _result(mbs: Any, chain: Any, name: str, rigid: bool) -> dict[str, Any]:
    marker = items.MarkerNodeRigid if rigid else items.MarkerNodePosition
    ends = {
        place: mbs.AddMarker(marker(name=f"{name}:{place}" if name else "", nodeNumber=node))
        for place, node in (("start", chain[0][0]), ("end", chain[0][-1]))
    }
    return {"nodes": chain[0], "elements": chain[1], "loads": chain[2], **ends}


def CreateCable(
    mbs: MainSystem,
    name: str = "",
    start: Vector = ZERO3,
    end: Vector = [1, 0, 0],
    numberOfElements: int = 10,
    diameter: float = 0.01,
    youngsModulus: float = 2.1e11,
    density: float = 7850.0,
    axialStiffness: float | None = None,
    bendingStiffness: float | None = None,
    massPerLength: float | None = None,
    axialDamping: float = 0.0,
    bendingDamping: float = 0.0,
    gravity: Vector = ZERO3,
    supports: Sequence[Support] = ("free", "free"),
    color: Vector = DEFAULT_COLOR,
    show: bool = True,
) -> dict[str, Any]:
    """Add a straight cable or thin rod of ANCF elements between two points (m), without torsion.

    Stiffnesses and mass are those of a round bar, unless they are given. Returns a dictionary: nodes, elements, loads,
    and the markers start and end of the end points, for joints and loads.
    """
    from dalembert.beams import GenerateStraightBeam

    _require_line("CreateCable", start, end, supports, numberOfElements)
    area = np.pi / 4 * diameter**2
    given: dict[str, Any] = {
        "physicsAxialStiffness": (axialStiffness, youngsModulus * area),
        "physicsBendingStiffness": (bendingStiffness, youngsModulus * np.pi / 64 * diameter**4),
        "physicsMassPerLength": (massPerLength, density * area),
    }
    template = items.ObjectANCFCable(
        physicsAxialDamping=axialDamping,
        physicsBendingDamping=bendingDamping,
        visualization=items.VObjectANCFCable(show=show, radius=diameter / 2, color=color),
        **{key: default if value is None else value for key, (value, default) in given.items()},
    )
    chain = GenerateStraightBeam(
        mbs, list(start), list(end), int(numberOfElements), template, gravity,
        *(_flags(each, [1, 1, 1, 0, 0, 0]) for each in supports),
    )  # fmt: skip
    for support, node in zip(supports, (chain[0][0], chain[0][-1]), strict=True):
        if support == "clamped":
            _hold_slope(mbs, node, np.subtract(end, start))
    return _result(mbs, chain, name, rigid=False)


def CreateBeam(
    mbs: MainSystem,
    name: str = "",
    start: Vector = ZERO3,
    end: Vector = [1, 0, 0],
    numberOfElements: int = 10,
    width: float | None = None,
    height: float | None = None,
    diameter: float | None = None,
    section: Any = None,
    youngsModulus: float = 2.1e11,
    poissonsRatio: float = 0.3,
    density: float = 7850.0,
    gravity: Vector = ZERO3,
    supports: Sequence[Support] = ("free", "free"),
    color: Vector = DEFAULT_COLOR,
    show: bool = True,
) -> dict[str, Any]:
    """Add a straight beam of geometrically exact elements between two points (m): bending, shear, torsion, tension.

    The section is a rectangle of width and height, a circle of a diameter, or an outline such as SectionI(...) of
    dalembert.beams. The beam axis is x of the section, width is along y, height along z; a section on a line along x
    has the global axes, others turn from there by the shortest way. Returns a dictionary: nodes, elements, loads, and
    the rigid markers start and end of the end nodes, for joints and loads.
    """
    from dalembert.beams import ComputeSectionConstants, GenerateStraightBeam, SectionCircle, SectionRectangle

    function = "CreateBeam"
    _require_line(function, start, end, supports, numberOfElements)
    given = [section is not None, diameter is not None, width is not None or height is not None]
    if sum(given) != 1 or (given[2] and (width is None or height is None)):
        expected = "one of width and height, diameter, and section"
        raise argument_error(function, "width", expected, {"width": width, "height": height, "diameter": diameter})
    if diameter is not None:
        section = SectionCircle(diameter / 2)
    elif width is not None and height is not None:
        section = SectionRectangle(width, height)
    elif not hasattr(section, "loops"):
        raise argument_error(function, "section", "an outline such as SectionI(...) of dalembert.beams", section)
    constants = ComputeSectionConstants(
        section, {"youngsModulus": youngsModulus, "poissonsRatio": poissonsRatio, "density": density}
    )
    template = items.ObjectBeamGeometricallyExact(
        sectionData=constants.BeamSection(),
        visualization=items.VObjectBeamGeometricallyExact(
            show=show, sectionGeometry=constants.BeamSectionGeometry(), color=color
        ),
    )
    chain = GenerateStraightBeam(
        mbs, list(start), list(end), int(numberOfElements), template, gravity,
        *(_flags(each, [1] * 6) for each in supports),
    )  # fmt: skip
    return _result(mbs, chain, name, rigid=True)


def CreateHydraulicCylinder(
    mbs: MainSystem,
    name: str = "",
    bodyNumbers: Sequence[Connected] = NO_PAIR,
    localPosition0: Vector = ZERO3,
    localPosition1: Vector = ZERO3,
    pistonDiameter: float = 0.05,
    rodDiameter: float = 0.03,
    strokeLength: float = 0.5,
    offsetLength: float | None = None,
    systemPressure: float = 1e7,
    tankPressure: float = 1e5,
    initialForce: float = 0.0,
    nominalFlow: float = 2e-7,
    oilBulkModulus: float = 1.5e9,
    hoseVolume: float = 5e-4,
    actuatorDamping: float = 0.0,
    useChamberVolumeChange: bool = False,
    show: bool = True,
    color: Vector = DEFAULT_COLOR,
) -> ObjectIndex:
    """Add a double-acting hydraulic cylinder between points of two bodies or markers, with the pressures in it.

    At the start, it carries initialForce (N), which pushes the points apart; negative: pulls them together. One chamber
    has the pressure for it, the other one that of the tank. offsetLength is the distance of the points at zero stroke;
    by default, the piston starts in the middle. The stroke has no stops. The valves are closed: set valveOpening0 and
    valveOpening1, from -1 (tank) to 1 (pump). Returns the ObjectIndex.
    """
    function = "CreateHydraulicCylinder"
    if not rodDiameter < pistonDiameter:
        raise argument_error(
            function, "rodDiameter", f"a diameter below pistonDiameter={pistonDiameter:g}", rodDiameter
        )
    ends = connector_ends(function, bodyNumbers, localPosition0, localPosition1, NO_PAIR, NO_PAIR)
    distance = end_distance(mbs, function, ends)
    if offsetLength is None:
        offsetLength = distance - 0.5 * strokeLength
    stroke = distance - offsetLength
    if offsetLength < 0 or not 0 <= stroke <= strokeLength:
        expected = f"a length such that the stroke is from 0 to {strokeLength:g}: the points are {distance:g} m apart"
        raise argument_error(function, "offsetLength", expected, offsetLength)
    piston, rod = (np.pi / 4 * each**2 for each in (pistonDiameter, rodDiameter))
    if tankPressure >= systemPressure:
        raise argument_error(
            function, "tankPressure", f"a pressure below systemPressure={systemPressure:g}", tankPressure
        )
    # the chamber that does not carry the force has the pressure of the tank
    pressures = [tankPressure, tankPressure]
    if initialForce >= -tankPressure * rod:
        pressures[0] = (initialForce + tankPressure * (piston - rod)) / piston
    else:
        pressures[1] = (tankPressure * piston - initialForce) / (piston - rod)
    pressures[0] = max(pressures[0], 0.0)
    if max(pressures) > systemPressure:
        expected = f"a force that systemPressure={systemPressure:g} can carry (it takes {max(pressures):.3g} Pa)"
        raise argument_error(function, "initialForce", expected, initialForce)
    node = mbs.AddNode(
        items.NodeGenericODE1(numberOfODE1Coordinates=2, referenceCoordinates=[0, 0], initialCoordinates=pressures)
    )
    return mbs.AddObject(
        items.ObjectConnectorHydraulicActuatorSimple(
            name=name,
            markerNumbers=add_end_markers(mbs, ends, name),
            nodeNumbers=[node],
            offsetLength=offsetLength,
            strokeLength=strokeLength,
            chamberCrossSection0=piston,
            chamberCrossSection1=piston - rod,
            hoseVolume0=hoseVolume,
            hoseVolume1=hoseVolume,
            actuatorDamping=actuatorDamping,
            oilBulkModulus=oilBulkModulus,
            nominalFlow=nominalFlow,
            systemPressure=systemPressure,
            tankPressure=tankPressure,
            useChamberVolumeChange=useChamberVolumeChange,
            visualization=items.VObjectConnectorHydraulicActuatorSimple(
                show=show,
                cylinderRadius=0.6 * pistonDiameter,
                rodRadius=0.5 * rodDiameter,
                pistonRadius=0.5 * pistonDiameter,
                colorCylinder=color,
            ),
        )
    )


_LINE = {
    "start": "first end, in the global frame (m)",
    "end": "second end, in the global frame (m)",
    "numberOfElements": "number of elements of equal length",
    "youngsModulus": "Young's modulus (Pa)",
    "density": "density (kg/m^3)",
    "supports": "how both ends are held by the ground: 'free', 'hinged' (position fixed) or 'clamped'",
    "name": "name of the markers of the ends, which get ':start' and ':end'",
}
TEXTS = {
    "CreateCable": {
        **_LINE,
        "diameter": "diameter (m), also of the drawing",
        "axialStiffness": "EA (N), in place of that of a round bar",
        "bendingStiffness": "EI (Nm^2), in place of that of a round bar",
        "massPerLength": "mass per length (kg/m), in place of that of a round bar",
        "axialDamping": "force per rate of strain (Ns)",
        "bendingDamping": "moment per rate of curvature (Nm^2 s)",
    },
    "CreateBeam": {
        **_LINE,
        "width": "width of a rectangle, along y of the section (m)",
        "height": "height of a rectangle, along z of the section (m)",
        "diameter": "diameter of a round bar (m)",
        "section": "outline of the section, such as SectionI(...) of dalembert.beams",
        "poissonsRatio": "Poisson's ratio",
    },
    "CreateHydraulicCylinder": {
        "pistonDiameter": "diameter of the piston (m)",
        "rodDiameter": "diameter of the rod (m)",
        "initialForce": "force at the start that pushes the points apart (N)",
        "hoseVolume": "volume of the hose of each chamber (m^3)",
        "color": "red, green, blue and opacity of the cylinder; a negative red selects the default",
        "offsetLength": "distance of the points at zero stroke (m); None: the piston starts in the middle",
    },
}
_ENDS: dict[str, Check] = {"start": vector(3), "end": vector(3), "gravity": vector(3), "show": FLAG}
_MATERIAL = {"youngsModulus": POSITIVE, "density": POSITIVE}
# Requirements on arguments besides those of the mirrored item and COMMON.
CHECKS: dict[str, dict[str, Check]] = {
    "CreateCable": {
        **_ENDS,
        **_MATERIAL,
        "diameter": POSITIVE,
        "axialStiffness": POSITIVE.optional(),
        "bendingStiffness": POSITIVE.optional(),
        "massPerLength": POSITIVE.optional(),
        "axialDamping": NOT_NEGATIVE,
        "bendingDamping": NOT_NEGATIVE,
    },
    "CreateBeam": {
        **_ENDS,
        **_MATERIAL,
        "width": POSITIVE.optional(),
        "height": POSITIVE.optional(),
        "diameter": POSITIVE.optional(),
    },
    "CreateHydraulicCylinder": {
        "color": color_check(),
        "pistonDiameter": POSITIVE,
        "rodDiameter": POSITIVE,
        "strokeLength": POSITIVE,
        "hoseVolume": POSITIVE,
    },
}
