"""How links, bases and tools of robots are drawn where the user gives no graphics."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

import dalembert
from dalembert import itemInterface as items
from dalembert._checks import FloatArray
from dalembert.robotics._parts import GraphicsList, VRobotLink

if TYPE_CHECKING:
    from dalembert.robotics._robot import Robot


def moved(parts: GraphicsList, T: Any) -> GraphicsList:
    """Return graphics moved from the frame that T leads to."""
    return [dalembert.graphics.Move(part, T[:3, 3], T[:3, :3]) for part in parts]


def center_of_mass(com: FloatArray, view: VRobotLink) -> GraphicsList:
    """Return a small cube, darker than the link."""
    if not view.showCOM:
        return []
    darker = [*(0.75 * np.array(view.linkColor[:3])), view.linkColor[3]]
    return [dalembert.graphics.Brick(com, [0.2 * view.jointRadius] * 3, darker)]


def joint(axis: FloatArray, view: VRobotLink) -> GraphicsList:
    """Return a cylinder about the axis of a joint at the origin."""
    if not view.showMBSjoint or view.jointRadius == 0:
        return []
    along = view.jointWidth * axis
    return [dalembert.graphics.Cylinder(-0.5 * along, along, view.jointRadius, dalembert.graphics.color.grey)]


def bar(start: FloatArray, end: FloatArray, view: VRobotLink) -> GraphicsList:
    """Return a cylinder from one point to another; nothing if they coincide."""
    if np.linalg.norm(end - start) < 1e-15 or view.linkWidth == 0:
        return []
    return [dalembert.graphics.Cylinder(start, end - start, 0.5 * view.linkWidth, view.linkColor)]


def link_between(
    com: FloatArray,
    points: tuple[FloatArray, FloatArray],
    axes: tuple[FloatArray, FloatArray],
    view: VRobotLink,
    is_first: bool,
) -> GraphicsList:
    """Return a link as half a cylinder at each of two joints and a bar between them; the base draws the first joint."""
    parts = center_of_mass(com, view)
    if view.jointRadius == 0:
        return parts
    half = 0.5 * view.jointWidth
    ends = [(points[1], half * axes[1])] if is_first else [(points[0], -half * axes[0]), (points[1], half * axes[1])]
    parts += [dalembert.graphics.Cylinder(p, v, view.jointRadius, view.linkColor) for p, v in ends if np.any(v)]
    return parts + bar(points[1], points[0], view)


def add_base(robot: Robot, mbs: Any) -> Any:
    """Add a ground that draws the base; return it, or None if there is nothing to draw."""
    shown = robot.base.visualization.graphicsData
    if not shown:
        return None
    turned = np.eye(4)
    turned[:3, :3] = robot.base.HT[:3, :3]
    view = items.VObjectGround(graphicsData=moved(shown, turned))
    return mbs.AddObject(items.ObjectGround(referencePosition=robot.base.HT[:3, 3], visualization=view))


def tool(robot: Robot, i: int) -> GraphicsList:
    """Return the graphics of the tool in the frame of link i, if that carries it."""
    return moved(robot.tool.visualization.graphicsData, robot.tool.HT) if i == len(robot.links) - 1 else []
