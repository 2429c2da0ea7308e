"""Small pictures of known models, which tests compare with those of the folder `references`.

`python tests/pictures/reference_pictures.py` makes the stored ones anew. Look at them before they are committed.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
from PIL import Image as Pillow

import dalembert as exu
import dalembert.itemInterface as eii
from dalembert import graphics
from dalembert.utilities import InertiaCuboid, InertiaSphere, RotationMatrixX

FOLDER = Path(__file__).parent / "references"
SIZE = (96, 72)
Image = npt.NDArray[np.uint8]


def bodies(SC: Any, mbs: Any) -> None:
    """Solids, joints, a spring and a load."""
    ground = mbs.CreateGround(graphicsDataList=[graphics.CheckerBoard(point=[0.3, 0, -0.6], size=2, nTiles=4)])
    shapes = [
        graphics.Brick(size=[1, 0.4, 0.3], color=graphics.color.orange, addEdges=True),
        graphics.Cylinder(pAxis=[0, 0, 0], vAxis=[0, 0, 0.5], radius=0.18, color=graphics.color.steelblue),
    ]
    body = mbs.CreateRigidBody(
        referencePosition=[0.5, 0, 0],
        referenceRotationMatrix=RotationMatrixX(0.4),
        inertia=InertiaCuboid(1000, [1, 0.4, 0.3]),
        graphicsDataList=shapes,
    )
    mbs.CreateRevoluteJoint(
        bodyNumbers=[ground, body], position=[0, 0, 0], axis=[0, 1, 0], axisRadius=0.1, axisLength=0.6
    )
    mass = mbs.CreateMassPoint(referencePosition=[0.9, 0.9, 0.3], physicsMass=1, drawSize=0.4, color=graphics.color.red)
    mbs.CreateSpringDamper(bodyNumbers=[body, mass], localPosition0=[0.5, 0, 0], stiffness=10, drawSize=0.15)
    mbs.CreateForce(bodyNumber=mass, loadVector=[0, 0, 0.5])


def beams(SC: Any, mbs: Any) -> None:
    """A cable, bent to a quarter of a circle, with the contour of its curvature and the bar of colors."""
    angles = np.linspace(0, np.pi / 2, 5)
    nodes = [
        mbs.AddNode(eii.NodePoint2DSlope1(referenceCoordinates=[np.sin(a), 1 - np.cos(a), np.cos(a), np.sin(a)]))
        for a in angles
    ]
    for k in range(4):
        mbs.AddObject(
            eii.ObjectANCFCable2D(
                nodeNumbers=nodes[k : k + 2],
                physicsLength=np.pi / 8,
                physicsMassPerLength=1,
                physicsBendingStiffness=1,
                physicsAxialStiffness=100,
                visualization=eii.VObjectANCFCable2D(drawHeight=0.1),
            )
        )
    SC.visualizationSettings.contour.outputVariable = exu.OutputVariableType.Position
    SC.visualizationSettings.contour.outputVariableComponent = 1
    SC.visualizationSettings.contour.advanced.colorBarPrecision = 2
    SC.visualizationSettings.view0.window.globalFontSize = 5


def contact(SC: Any, mbs: Any) -> None:
    """Spheres of general contact above a transparent floor."""
    floor = graphics.Brick(centerPoint=[0, 0, -0.1], size=[2, 2, 0.2], color=[0.4, 0.6, 0.9, 0.4])
    ground = mbs.CreateGround(graphicsDataList=[floor])
    contact = mbs.AddGeneralContact()
    contact.SetFrictionPairings([[0.3]])
    marker = mbs.AddMarker(eii.MarkerBodyRigid(bodyNumber=ground))
    contact.AddTrianglesRigidBodyBased(marker, 1e4, 1, 0, [[-1, -1, 0], [1, -1, 0], [0, 1, 0]], [[0, 1, 2]])
    for k in range(5):
        ball = mbs.CreateRigidBody(
            referencePosition=[np.cos(1.3 * k) * 0.6, np.sin(1.3 * k) * 0.6, 0.2 + 0.1 * k],
            inertia=InertiaSphere(1, 0.2),
        )
        contact.AddSphereWithMarker(mbs.AddMarker(eii.MarkerBodyRigid(bodyNumber=ball)), 0.2, 1e4, 1, 0)
    SC.visualizationSettings.contact.showSpheres = SC.visualizationSettings.contact.showTriangles = True
    SC.visualizationSettings.contact.showBoundingBoxes = True


def rays(SC: Any, mbs: Any) -> None:
    """A sphere of chrome and a glass brick on a checkerboard, by the ray tracer, with a soft shadow."""
    material = graphics.material
    shapes = [
        graphics.CheckerBoard(point=[0, 0, 0], size=3, nTiles=6),
        graphics.Sphere(point=[-0.6, 0.3, 0.6], radius=0.6, nTiles=24, color=[0.8, 0.8, 0.8, material.indexChrome]),
        graphics.Brick(centerPoint=[0.7, -0.2, 0.5], size=[0.7, 0.7, 1], color=[0.5, 0.8, 0.6, 0.5], addEdges=True),
    ]
    mbs.CreateGround(graphicsDataList=shapes)
    SC.visualizationSettings.view0.camera.useRaytracer = True
    light = SC.visualizationSettings.openGL.light0
    light.position, light.shadow, light.lightRadius = [2.0, -3.0, 6.0, 1.0], 1.0, 0.5
    SC.visualizationSettings.raytracer.lightRadiusVariations = 5


def text(SC: Any, mbs: Any) -> None:
    """Texts of graphics data, numbers of items and names of axes."""
    mbs.CreateGround(graphicsDataList=[graphics.Text(point=[0, 0.8, 0], text="Ψ = 7", color=graphics.color.blue)])
    for x in (0, 1, 2):
        mbs.AddNode(eii.NodePoint(referenceCoordinates=[x, 0.2 * x, 0]))
        mbs.AddObject(eii.ObjectMassPoint(nodeNumber=x, physicsMass=1))
    SC.visualizationSettings.nodes.showNumbers = True
    SC.visualizationSettings.view0.window.globalFontSize = 9


MODELS: dict[str, Callable[[Any, Any], None]] = {f.__name__: f for f in (bodies, beams, contact, rays, text)}


def drawn(name: str, change: Callable[[Any], None] = lambda SC: None) -> Image:
    """Return the picture of a model; `change` gets its container before it is drawn."""
    SC = exu.SystemContainer()
    mbs = SC.AddSystem()
    MODELS[name](SC, mbs)
    mbs.Assemble()
    change(SC)
    return np.asarray(mbs.Draw(windowSize=SIZE))


def stored(name: str) -> Image:
    """Return the stored picture of a model."""
    with Pillow.open(FOLDER / f"{name}.png") as image:
        return np.asarray(image.convert("RGB"))


if __name__ == "__main__":
    FOLDER.mkdir(exist_ok=True)
    for name in MODELS:
        Pillow.fromarray(drawn(name)).save(FOLDER / f"{name}.png", optimize=True)
