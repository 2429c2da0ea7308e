"""Drawing of connectors, joints and contacts: connections of their markers, and symbols of their axes."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np

from dalembert._checks import FloatArray
from dalembert._pictures import meshes
from dalembert._pictures.looks import rgba
from dalembert._pictures.meshes import Rgba
from dalembert._pictures.pen import Pen
from dalembert._pictures.places import frame_along
from dalembert._tools.item_packages import drawings_of_packages

Item = dict[str, Any]
GREY = (0.8, 0.8, 0.8, 1.0)
SIZE = "connectors.defaultSize"


def _look(pen: Pen, item: Item, part: float = 0.04) -> tuple[float, Rgba]:
    """Return size and color of a connector."""
    return pen.looks.draw_size(item, SIZE, part), pen.looks.color(item, "connectors.defaultColor")


def _ends(pen: Pen, item: Item) -> list[FloatArray]:
    """Return where the markers are, those that are anywhere."""
    found = [pen.places.marker(number) for number in item["markerNumbers"]]
    return [place for place in found if place is not None]


def _joint_frame(pen: Pen, item: Item, index: int = 0) -> FloatArray:
    """Return the axes of a joint at one of its markers."""
    rotation = pen.places.marker_rotation(item["markerNumbers"][index])
    local = np.asarray(item.get(f"rotationMarker{index}", np.eye(3)), float)
    return rotation @ (local if local.shape == (3, 3) else np.eye(3))


def spring(pen: Pen, item: Item) -> None:
    """A helix between two markers; a small ball if they coincide."""
    size, color = _look(pen, item, 0.07)
    ends = _ends(pen, item)
    if len(ends) == 2 and np.linalg.norm(ends[1] - ends[0]) > 1e-3 * pen.looks.size:
        pen.stick_between(*item["markerNumbers"])
        pen.spring(ends[0], ends[1], 0.5 * size, color)
    elif ends:
        pen.sphere(ends[0], 0.25 * size, color)


def axial_spring(pen: Pen, item: Item) -> None:
    """A helix, or a telescope, along an axis of marker 0."""
    size, color = _look(pen, item)
    ends = _ends(pen, item)
    if not item.get("VdrawAsCylinder"):
        spring(pen, item)
    elif len(ends) == 2:
        axis = pen.places.marker_rotation(item["markerNumbers"][0]) @ np.asarray(item["axisMarker0"], float)
        middle = ends[0] + 0.5 * ((ends[1] - ends[0]) @ axis) * axis
        pen.cylinder(ends[0], middle, 0.5 * size, color)
        pen.cylinder(middle, ends[1], 0.25 * size, GREY)


def torsional_spring(pen: Pen, item: Item) -> None:
    """A flat coil about the z axis of the joint frame."""
    size, color = _look(pen, item, 0.06)
    ends = _ends(pen, item)
    if ends:
        s = np.linspace(0, 1, 65)
        angle = 6 * np.pi * s
        coil = np.stack([s * np.cos(angle), s * np.sin(angle), 0 * s], 1) * (0.5 * size)
        mesh = meshes.swept(coil, 0.03 * size, 6)
        pen.stick("Marker", item["markerNumbers"][0])
        pen.mesh(mesh, ends[0], _joint_frame(pen, item), color)


def axes(pen: Pen, item: Item) -> None:
    """Draw the axes in which outputs of a joint are measured, as connectors.showJointAxes says.

    They are at the markers, rotated by rotationMarker0 and rotationMarker1; those of a rolling disc are at the contact.
    """
    name = item["objectType"]
    if not pen.looks.setting("connectors.showJointAxes"):
        return
    length = pen.looks.length("connectors.jointAxesLength", 0.05)
    if DRAWINGS.get(name) is disc:
        _contact_axes(pen, item, length)
    elif name in WITH_AXES or drawings_of_packages().get(name, ("",))[0] == "joints":
        for index, marker in enumerate(item["markerNumbers"]):
            if (place := pen.places.marker(marker)) is not None:
                pen.stick("Marker", marker)
                pen.frame(place, _joint_frame(pen, item, index), length)


def _contact_axes(pen: Pen, item: Item, length: float) -> None:
    """Draw the lateral and forward direction and the normal at the contact point of a disc."""
    plane, center = item["markerNumbers"]
    if (place := pen.places.marker(center)) is None:
        return
    axis = pen.places.marker_rotation(center) @ np.asarray(item["discAxis"], float)
    normal = pen.places.marker_rotation(plane) @ np.asarray(item["planeNormal"], float)
    forward = np.cross(axis, normal)
    if (size := float(np.linalg.norm(forward))) == 0:
        return  # the disc lies on the plane
    forward = forward / size
    pen.stick()
    rotation = np.column_stack([np.cross(normal, forward), forward, normal])
    pen.frame(place + float(item["discRadius"]) * np.cross(axis, forward), rotation, length)


def rod(pen: Pen, item: Item, thickness: float = 0.24) -> None:
    """A thin rod between the markers; a small block if they coincide."""
    size, color = _look(pen, item)
    ends = _ends(pen, item)
    if len(ends) == 2 and np.linalg.norm(ends[1] - ends[0]) > 1e-6 * pen.looks.size:
        pen.stick_between(*item["markerNumbers"])
        pen.cylinder(ends[0], ends[1], 0.5 * thickness * size, color)
    elif ends:
        pen.box(ends[0], np.eye(3), 3 * [0.3 * size], color)


def coordinate(pen: Pen, item: Item) -> None:
    """A thin line between the places of two coordinates, and a small block at the second."""
    size, color = _look(pen, item)
    ends = _ends(pen, item)
    if len(ends) == 2:
        pen.line(ends, color)
    if ends:
        pen.box(ends[-1], np.eye(3), 3 * [0.35 * size], color)


def actuator(pen: Pen, item: Item) -> None:
    """A cylinder at marker 0, and the rod with its piston from marker 1."""
    ends = _ends(pen, item)
    if len(ends) != 2 or (length := float(np.linalg.norm(ends[1] - ends[0]))) == 0:
        return
    looks, axis = pen.looks, (ends[1] - ends[0]) / length
    shell = looks.color(item, "connectors.defaultColor", "VcolorCylinder")
    metal = rgba(item.get("VcolorPiston", GREY), GREY)
    outer = looks.item_length(float(item["VcylinderRadius"]), 0.05, 0.03)
    inner = looks.item_length(float(item["VrodRadius"]), 0.03, 0.018)
    base = ends[0] + axis * float(item["VbaseMountLength"])
    stroke = min(float(item["offsetLength"]), 0.95 * length) or 0.5 * length
    pen.cylinder(base, ends[0] + stroke * axis, outer, (*shell[:3], 0.6 * shell[3]))
    pen.cylinder(ends[0], base, inner, shell)
    piston = ends[1] - min(stroke, 0.9 * length) * axis
    pen.cylinder(piston, ends[1], inner, metal)
    thick = max(float(item["VpistonLength"]), 0.1 * outer)
    pen.cylinder(
        piston, piston + thick * axis, min(outer, looks.item_length(float(item["VpistonRadius"]), 0.04, 0.024)), metal
    )
    for end, name in zip(ends, ("VbaseMountRadius", "VrodMountRadius"), strict=True):
        pen.sphere(end, float(item[name]), metal)


def gravity(pen: Pen, item: Item) -> None:
    """A rod between the two masses, thinner than one that holds them."""
    rod(pen, item, 0.08)


def rope(pen: Pen, item: Item) -> None:
    """A rope from sheave to sheave, straight between them and round where it lies on them."""
    color = pen.looks.color(item, "connectors.defaultColor")
    if item["hasCoordinateMarkers"]:  # these lengthen the rope, which does not run there
        item = {**item, "markerNumbers": item["markerNumbers"][:-2]}
    ends = _ends(pen, item)
    radii = (
        np.resize(np.asarray(item["sheavesRadii"], float), len(ends))
        if len(item["sheavesRadii"])
        else np.zeros(len(ends))
    )
    axes = np.asarray(item["sheavesAxes"], float).reshape(-1, 3)
    radius = pen.looks.item_length(float(item["VropeRadius"]), 0.001, 0.004)
    turned = [
        pen.places.marker_rotation(m) @ (axes[i] if i < len(axes) else np.array([0.0, 0, 1]))
        for i, m in enumerate(item["markerNumbers"][: len(ends)])
    ]
    for i in range(len(ends) - 1):
        a, b = _tangent(ends[i], ends[i + 1], turned[i], turned[i + 1], radii[i], radii[i + 1])
        pen.cylinder(a, b, radius, color)
    for center, axis, size in zip(ends, turned, radii, strict=True):
        if size > 0:
            pen.mesh(meshes.torus(round(float(radius / size), 6), 12), center, size * frame_along(axis), color)


def _tangent(
    p: FloatArray, q: FloatArray, axis_p: FloatArray, axis_q: FloatArray, rp: float, rq: float
) -> tuple[FloatArray, FloatArray]:
    """Return the ends of the straight part of a rope that leaves the sheave at p and arrives at that at q.

    It runs on the side to which the axes turn; signs of the axes decide whether it crosses over.
    """
    line = q - p
    distance = float(np.linalg.norm(line))
    if distance <= rp + rq:
        return p, q
    along = line / distance
    side = np.cross(along, axis_p)
    side = side / max(float(np.linalg.norm(side)), 1e-300)
    sign = 1.0 if axis_p @ axis_q >= 0 else -1.0
    sine = (rp - sign * rq) / distance
    normal = sine * along + np.sqrt(1 - sine**2) * side
    return p + rp * normal, q + sign * rq * normal


def disc(pen: Pen, item: Item) -> None:
    """A disc that rolls, at marker 1."""
    if (center := pen.places.marker(item["markerNumbers"][1])) is None:
        return
    rotation = pen.places.marker_rotation(item["markerNumbers"][1])
    pen.stick("Marker", item["markerNumbers"][1])
    axis = rotation @ np.asarray(item.get("discAxis", (1, 0, 0)), float)
    axis = axis / max(float(np.linalg.norm(axis)), 1e-300)
    radius, color = float(item["discRadius"]), pen.looks.color(item, "connectors.defaultColor")
    half = 0.5 * pen.looks.item_length(float(item["VdiscWidth"]), 0.1, 0.6 * radius / pen.looks.size)
    pen.mesh(
        meshes.cylinder(2 * pen.tiles, 0.6),
        center - half * axis,
        frame_along(axis, rotation[:, 0]) * np.array([radius, radius, 2 * half]),
        color,
    )
    for spoke in np.linspace(0, np.pi, 3, endpoint=False):
        frame = frame_along(axis, rotation @ np.array([0.0, np.cos(spoke), np.sin(spoke)]))
        pen.box(center, frame, [1.3 * radius, 0.08 * radius, 1.2 * half], color)


def _axes_size(pen: Pen, item: Item, name: str) -> tuple[float, float]:
    radius = pen.looks.item_length(float(item[f"V{name}Radius"]), 0.1, 0.012)
    return radius, pen.looks.item_length(float(item[f"V{name}Length"]), 0.4, 0.07)


def revolute(pen: Pen, item: Item) -> None:
    """A cylinder along the axis of rotation."""
    if ends := _ends(pen, item):
        pen.stick("Marker", item["markerNumbers"][0])
        radius, length = _axes_size(pen, item, "axis")
        axis = 0.5 * length * _joint_frame(pen, item)[:, 2]
        pen.cylinder(ends[0] - axis, ends[0] + axis, radius, pen.looks.color(item, "connectors.defaultColor"))


def prismatic(pen: Pen, item: Item) -> None:
    """A square bar along the axis of sliding, and the block that slides."""
    if len(ends := _ends(pen, item)) == 2:
        radius, length = _axes_size(pen, item, "axis")
        color, frame = pen.looks.color(item, "connectors.defaultColor"), _joint_frame(pen, item)
        pen.cylinder(ends[0], ends[1], 0.3 * radius, color)
        pen.box(ends[0], frame, [length, 1.2 * radius, 1.2 * radius], color)
        pen.box(ends[1], frame, [0.35 * length, 2.2 * radius, 2.2 * radius], GREY)


def generic_joint(pen: Pen, item: Item) -> None:
    """A ball, with a rod along each axis of rotation and a bar along each axis of sliding.

    A thin rod leads to the displaced part.
    """
    if not (ends := _ends(pen, item)):
        return
    radius, length = _axes_size(pen, item, "axes")
    color, frame = pen.looks.color(item, "connectors.defaultColor"), _joint_frame(pen, item)
    constrained = list(item["constrainedAxes"])
    pen.stick("Marker", item["markerNumbers"][0])
    if all(constrained):
        pen.box(ends[0], frame, 3 * [2 * radius], color)
        return
    pen.sphere(ends[0], 1.3 * radius, color)
    for i in range(3):
        axis = 0.5 * length * frame[:, i]
        if not constrained[3 + i]:
            pen.cylinder(ends[0] - axis, ends[0] + axis, 0.7 * radius, color)
        if not constrained[i]:
            sizes = np.full(3, 0.7 * radius)
            sizes[i] = length
            pen.box(ends[0], frame, sizes, GREY)
    if not all(constrained[:3]) and len(ends) == 2:
        pen.stick_between(*item["markerNumbers"])
        pen.cylinder(ends[0], ends[1], 0.3 * radius, color)


def spherical(pen: Pen, item: Item) -> None:
    """A ball."""
    if ends := _ends(pen, item):
        pen.stick("Marker", item["markerNumbers"][0], turns=False)
        radius = pen.looks.item_length(float(item["VjointRadius"]), 0.1, 0.02)
        pen.sphere(ends[0], radius, pen.looks.color(item, "connectors.defaultColor"))


def planar_revolute(pen: Pen, item: Item) -> None:
    """A pin along z."""
    if ends := _ends(pen, item):
        pen.stick("Marker", item["markerNumbers"][0], turns=False)
        size, color = _look(pen, item, 0.03)
        pen.cylinder(ends[0] - [0, 0, 0.5 * size], ends[0] + [0, 0, 0.5 * size], 0.5 * size, color)


def planar_prismatic(pen: Pen, item: Item) -> None:
    """A bar along the axis at marker 0, and a block at marker 1."""
    if len(ends := _ends(pen, item)) == 2:
        size, color = _look(pen, item, 0.03)
        rotation = pen.places.marker_rotation(item["markerNumbers"][0])
        axis = rotation @ np.array([*item["axisMarker0"], 0, 0])[:3]
        frame = frame_along(np.array([0.0, 0, 1]), axis)
        pen.box(
            0.5 * (ends[0] + ends[1]),
            frame,
            [np.linalg.norm(ends[1] - ends[0]) + 2 * size, 0.3 * size, 0.3 * size],
            color,
        )
        pen.box(ends[1], frame, [size, 0.7 * size, 0.7 * size], GREY)


def sliding(pen: Pen, item: Item) -> None:
    """A ring on the cable, at the marker that slides."""
    if ends := _ends(pen, item):
        size, color = _look(pen, item, 0.03)
        pen.mesh(meshes.torus(0.3, 12), ends[0], 0.5 * size * np.eye(3), color)
        pen.sphere(ends[0], 0.2 * size, color)


def circle_contact(pen: Pen, item: Item) -> None:
    """The circle that touches a cable, in the xy plane of marker 0."""
    if (center := pen.places.marker(item["markerNumbers"][0])) is None or not item.get("VshowContactCircle", True):
        return
    size, color = _look(pen, item, 0.02)
    radius = float(item["circleRadius"])
    half = np.array([0, 0, 0.5 * size])
    pen.cylinder(center - half, center + half, radius, color, 0.85)


def sphere_contact(pen: Pen, item: Item) -> None:
    """The spheres that touch; a hollow one is seen through."""
    color = rgba(item["Vcolor"], (0.7, 0.7, 0.7, 1.0))
    ends = _ends(pen, item)
    radii = [float(r) for r in np.atleast_1d(item["spheresRadii"] if "spheresRadii" in item else item["radiusSphere"])]
    for number, (center, radius) in enumerate(zip(ends, radii, strict=False)):
        hollow = number == 1 and item.get("isHollowSphere1", False)
        pen.sphere(center, radius, (*color[:3], 0.3) if hollow else color)


def torus_contact(pen: Pen, item: Item) -> None:
    """The sphere and the torus that touch."""
    ends, color = _ends(pen, item), rgba(item["Vcolor"], (0.7, 0.7, 0.7, 1.0))
    if len(ends) == 2:
        major, minor = float(item["torusMajorRadius"]), float(item["torusMinorRadius"])
        axis = pen.places.marker_rotation(item["markerNumbers"][1]) @ np.asarray(item["torusAxis"], float)
        pen.sphere(ends[0], float(item["radiusSphere"]), color)
        pen.mesh(meshes.torus(minor / major, 16), ends[1], major * frame_along(axis), (*color[:3], 0.5))


def triangle_contact(pen: Pen, item: Item) -> None:
    """The sphere and the triangle that touch."""
    sphere_contact(pen, item)
    if len(ends := _ends(pen, item)) == 2:
        points = meshes.rows(item["trianglePoints"], 3)
        rotation = pen.places.marker_rotation(item["markerNumbers"][1])
        pen.mesh(meshes.Mesh(points, np.array([[0, 1, 2]])), ends[1], rotation, rgba(item["Vcolor"]))


def roll_contact(pen: Pen, item: Item) -> None:
    """The hull of the roll: a polynomial turned about the x axis of marker 1."""
    if (center := pen.places.marker(item["markerNumbers"][1])) is None:
        return
    x = np.linspace(-0.5, 0.5, 25) * float(item["rollLength"])
    radii = np.polyval(np.asarray(item["coefficientsHull"], float), x)
    frame = pen.places.marker_rotation(item["markerNumbers"][1]) @ np.array([[0.0, 0, 1], [1, 0, 0], [0, 1, 0]])
    pen.mesh(meshes.revolved(radii, x, 2 * pen.tiles), center, frame, pen.looks.color(item, "connectors.defaultColor"))


def curve_contact(pen: Pen, item: Item) -> None:
    """The circles, and the segments of the curve at marker 0."""
    color = pen.looks.color(item, "connectors.defaultColor")
    frame = _joint_frame(pen, item)
    places = [pen.places.marker(m) for m in item["markerNumbers"]]
    for center, radius in zip(places[1:], np.atleast_1d(item["circlesRadii"]), strict=False):
        if center is not None:
            half = 0.25 * float(radius) * frame[:, 2]
            pen.cylinder(center - half, center + half, float(radius), color)
    if places[0] is not None:
        for x0, y0, x1, y1 in np.asarray(item["segmentsData"], float).reshape(-1, 4):
            pen.line(np.array([[x0, y0, 0], [x1, y1, 0]]) @ frame.T + places[0], color, 2.0)


def markers_line(pen: Pen, item: Item) -> None:
    """A line through all markers."""
    ends = _ends(pen, item)
    if len(ends) > 1:
        pen.line(ends, _look(pen, item)[1])


def _at_markers(pen: Pen, item: Item, draw: Callable[[int, FloatArray], None]) -> None:
    for index, marker in enumerate(item["markerNumbers"]):
        if (place := pen.places.marker(marker)) is not None:
            pen.stick("Marker", marker)
            draw(index, place)


def markers_spheres(pen: Pen, item: Item) -> None:
    """A sphere at each marker."""
    size, color = _look(pen, item)
    _at_markers(pen, item, lambda _, place: pen.sphere(place, 0.5 * size, color))


def markers_boxes(pen: Pen, item: Item) -> None:
    """A box at each marker, in the axes of the joint."""
    size, color = _look(pen, item)
    _at_markers(pen, item, lambda i, place: pen.box(place, _joint_frame(pen, item, i), 3 * [size], color))


def markers_frames(pen: Pen, item: Item) -> None:
    """The axes of the joint at each marker."""
    size, _ = _look(pen, item)
    _at_markers(pen, item, lambda i, place: pen.frame(place, _joint_frame(pen, item, i), size))


Drawing = Callable[[Pen, Item], None]
DRAWINGS: dict[str, Drawing] = {
    "ConnectorSpringDamper": spring,
    "ConnectorCartesianSpringDamper": spring,
    "ConnectorLinearSpringDamper": axial_spring,
    "ConnectorRigidBodySpringDamper": spring,
    "ConnectorTorsionalSpringDamper": torsional_spring,
    "ConnectorCoordinateSpringDamper": spring,
    "ConnectorCoordinateSpringDamperExt": spring,
    "ConnectorLaw": spring,
    "ConnectorHydraulicActuatorSimple": actuator,
    "ConnectorGravity": gravity,
    "ConnectorReevingSystemSprings": rope,
    "ConnectorRollingDiscPenalty": disc,
    "ConnectorDistance": rod,
    "ConnectorCoordinate": coordinate,
    "ConnectorCoordinateVector": coordinate,
    "JointGeneric": generic_joint,
    "JointRevoluteZ": revolute,
    "JointPrismaticX": prismatic,
    "JointSpherical": spherical,
    "JointRevolute2D": planar_revolute,
    "JointPrismatic2D": planar_prismatic,
    "JointSliding": sliding,
    "JointSliding2D": sliding,
    "JointALEMoving2D": sliding,
    "JointRollingDisc": disc,
    "ContactCoordinate": coordinate,
    "ContactCircleCable2D": circle_contact,
    "ContactFrictionCircleCable2D": circle_contact,
    "ContactSphereSphere": sphere_contact,
    "ContactSphereTorus": torus_contact,
    "ContactSphereTriangle": triangle_contact,
    "ContactConvexRoll": roll_contact,
    "ContactCurveCircles": curve_contact,
}
# Their outputs are in the axes of their markers, or of frames that are rotated relative to these.
WITH_AXES = (
    "JointGeneric",
    "JointRevoluteZ",
    "JointPrismaticX",
    "JointPrismatic2D",
    "JointSpherical",
    "ConnectorRigidBodySpringDamper",
    "ConnectorTorsionalSpringDamper",
    "ConnectorLaw",
)
# Items of packages: drawings that a spec can name, and those of folders.
NAMED: dict[str, Drawing] = {
    "spring": spring,
    "rod": rod,
    "line": markers_line,
    "spheres": markers_spheres,
    "boxes": markers_boxes,
    "frames": markers_frames,
}
BY_FOLDER: dict[str, Drawing] = {"connectors": spring, "contacts": spring, "constraints": rod, "joints": rod}


@cache
def drawing(name: str) -> Drawing | None:
    """Return how a type of objects is drawn; None: it is a body."""
    folder, named = drawings_of_packages().get(name, ("", ""))
    return DRAWINGS.get(name) or NAMED.get(named) or BY_FOLDER.get(folder)
