"""Graphics of bodies as data: dictionaries with 'type' TriangleList, Line, Circle or Text.

A TriangleList has flat arrays: points (3 per point), colors (RGBA per point), triangles (3 indices each), optional
normals (3 per point) and edges (2 indices each) with one edgeColor. Triangles are counter-clockwise seen from outside.
"""

from dalembert.graphics._elements import Circle, Lines, Text
from dalembert.graphics._extrusion import (
    BallBearingRings,
    InvoluteGear,
    LinkedCylinders,
    SolidExtrusion,
    ToothedRack,
)
from dalembert.graphics._import import (
    ExportSTL,
    FromPyMeshlabFile,
    FromSTLfile,
    FromSTLfileASCII,
    NGsolveMesh2PointsAndTrigs,
)
from dalembert.graphics._operations import (
    AddEdgesAndSmoothenNormals,
    BoundingBox,
    BoundingBoxSingle,
    FromPointsAndTrigs,
    InconsistentTriangles,
    InvertTriangles,
    MergeTriangleLists,
    Move,
    ToPointsAndTrigs,
    Transform,
    Triangles6ToTriangles,
)
from dalembert.graphics._parameters import describe as _describe
from dalembert.graphics._revolution import Arrow, Basis, Frame, SolidOfRevolution
from dalembert.graphics._solids import (
    Brick,
    BrickXYZ,
    CheckerBoard,
    Cuboid,
    Cylinder,
    Quad,
    RigidLink,
    Sphere,
    Spheres,
    SpheresToTriangleList,
    Torus,
    Tube,
)
from dalembert.graphics._styles import color, colorList, material

__all__ = [
    "AddEdgesAndSmoothenNormals",
    "Arrow",
    "BallBearingRings",
    "Basis",
    "BoundingBox",
    "BoundingBoxSingle",
    "Brick",
    "BrickXYZ",
    "CheckerBoard",
    "Circle",
    "Cuboid",
    "Cylinder",
    "ExportSTL",
    "Frame",
    "FromPointsAndTrigs",
    "FromPyMeshlabFile",
    "FromSTLfile",
    "FromSTLfileASCII",
    "InconsistentTriangles",
    "InvertTriangles",
    "InvoluteGear",
    "Lines",
    "LinkedCylinders",
    "MergeTriangleLists",
    "Move",
    "NGsolveMesh2PointsAndTrigs",
    "Quad",
    "RigidLink",
    "SolidExtrusion",
    "SolidOfRevolution",
    "Sphere",
    "Spheres",
    "SpheresToTriangleList",
    "Text",
    "ToPointsAndTrigs",
    "ToothedRack",
    "Torus",
    "Transform",
    "Triangles6ToTriangles",
    "Tube",
    "color",
    "colorList",
    "material",
]

for _name in __all__:
    if _name[0].isupper():
        _describe(globals()[_name])
