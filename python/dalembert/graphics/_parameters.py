"""Descriptions of the parameters of graphics functions, which are inserted into their docstrings."""

from __future__ import annotations

from inspect import cleandoc, signature
from types import FunctionType

# Common to all functions; a function may override them below.
_COMMON = {
    "point": "centre point (m)",
    "pAxis": "point at which the axis begins (m)",
    "vAxis": "vector along the axis; where nothing else is said, its length (m) is that of the shape",
    "pList": "list of points [x, y, z] (m)",
    "centerPoint": "centre point (m)",
    "rotationMatrix": "3x3 rotation matrix from the axes of the shape to those of the body",
    "radius": "radius (m)",
    "width": "size along the axis (m)",
    "color": "red, green, blue and opacity from 0 to 1, as graphics.color.red; or a material in the place of opacity",
    "alternatingColor": "second color, in turns with the first",
    "nTiles": "number of flat tiles around the circumference",
    "nTilesCylinder": "number of flat tiles around a bore",
    "addEdges": "True or a number greater than 0: edges are drawn",
    "edgeColor": "color of the edges",
    "addFaces": "False: only edges are drawn",
    "addNormals": "True: every face has corners and normals of its own, so that it is drawn flat",
    "smoothNormals": "True: normals change smoothly along the mantle; False: tiles are drawn flat",
    "headFactor": "radius of the head of an arrow, in radii of the shaft",
    "headStretch": "length of the head, in radii of the head",
    "length": "length of each arrow (m)",
    "colors": "three colors, of x, y and z",
    "graphicsData": "a dictionary that a function of this module has returned",
    "g": "a dictionary that a function of this module has returned",
    "fileName": "name of the file, with its path",
    "verbose": "True: counts of points and triangles are printed",
    "invertNormals": "True: normals point to the other side",
    "invertTriangles": "True: triangles are inverted, inside becomes outside",
    "normalizeNormals": "True: normals get length one",
    "pOff": "vector (m) by which points are shifted at the end",
    "Aoff": "3x3 matrix that turns points before they are shifted; None: they are not turned",
    "scale": "factor of all lengths, 0.001 for files in mm",
}

_RACK = {
    "module": "pitch divided by pi (m)",
    "nTeeth": "number of teeth",
    "width": "size along z (m)",
    "toothHeight": "from the foot to the tip of a tooth (m)",
    "rackBaseHeight": "height below the teeth (m)",
    "pressureAngleDeg": "angle of the flanks (degrees)",
    "centerPoint": "where the begin of the rack is (m)",
    "nTilesCylinder": "without effect: a rack has no bore",
}
_BEARING = {
    "axis": "axis of rotation",
    "outsideDiameter": "diameter of the outer ring at its outside (m)",
    "boreDiameter": "diameter of the inner ring at its inside (m)",
    "width": "size of the rings along the axis (m)",
    "radiusCage": "mean radius of the cage (m)",
    "innerRingShoulderRadius": "outer radius of the inner ring next to its groove (m)",
    "outerRingShoulderRadius": "inner radius of the outer ring next to its groove (m)",
    "widthCage": "size of the cage along the axis (m)",
    "heightCage": "size of the cage along the radius (m)",
    "innerEdgeChamfer": "chamfer of the edges of the inner ring (m)",
    "outerEdgeChamfer": "chamfer of the edges of the outer ring (m)",
    "innerGrooveRadius": "radius of the section of the inner groove (m)",
    "outerGrooveRadius": "radius of the section of the outer groove (m)",
    "innerGrooveTorusRadius": "radius of the circle of the centers of the inner groove's section (m)",
    "outerGrooveTorusRadius": "the same of the outer groove (m)",
    "nTilesRings": "number of flat tiles around the rings",
    "nTilesGrooves": "number of flat tiles across a groove",
    "colorCage": "color of the cage",
    "colorInnerRing": "color of the inner ring",
    "colorOuterRing": "color of the outer ring",
}

_OWN: dict[str, dict[str, str]] = {
    "Text": {
        "point": "where the text stands (m)",
        "text": "the text itself",
        "fontSize": "size of letters; 0: that of the settings",
        "offset": "shift to the right and up, in sizes of letters",
    },
    "Lines": {"shape": "'linear': straight lines; 'quadratic': parabolas"},
    "Spheres": {
        "points": "list of centre points (m)",
        "radii": "a radius, or one for each point (m)",
        "colors": "a color, or one for each point",
        "nTiles": "number of tiles along a meridian",
    },
    "Sphere": {
        "nTiles": "number of tiles along a meridian; the equator has twice as many",
        "addEdges": "number of circles that are drawn on a full sphere; True stands for 3",
        "majorAngleMin": "latitude (rad) at which a zone begins",
        "majorAngleMax": "latitude (rad) at which it ends",
        "innerRadius": "inner radius of a shell (m); None: the sphere is full",
    },
    "Cuboid": {
        "pList": "8 corners (m): 4 of the bottom, counter-clockwise seen from above, and 4 of the top",
        "faces": "six numbers, 1 for each face that is drawn: bottom, top, and the sides in the order of the corners",
    },
    "BrickXYZ": {
        "xMin": "smallest x (m)",
        "yMin": "smallest y (m)",
        "zMin": "smallest z (m)",
        "xMax": "largest x (m)",
        "yMax": "largest y (m)",
        "zMax": "largest z (m)",
    },
    "Brick": {
        "size": "side lengths along x, y and z (m)",
        "roundness": "0: a block; 1: an ellipsoid; between them, a block with rounded corners and no edges",
        "nTiles": "number of tiles along the equator of a rounded block",
    },
    "Cylinder": {
        "radiusInner": "radius of a bore (m); None: there is none",
        "angleRange": "begin and end (rad) of the part that is drawn",
        "lastFace": "False: the cut remains open",
        "cutPlain": "True: a plane through both cut lines closes it; False: two planes to the axis",
        "addEdges": "number of lines along the mantle; True: circles only",
        "alternatingColor": "color of the second half",
    },
    "Tube": {"points": "list of points (m) along the tube", "axes": "direction of the tube at each of them"},
    "Torus": {
        "axis": "axis of rotation",
        "radiusMajor": "radius of the circle that centers of sections lie on (m)",
        "radiusMinor": "radius of a section (m)",
        "nTilesMajor": "number of tiles along the ring",
        "nTilesMinor": "number of tiles around a section",
        "minorAngleStart": "angle (rad) at which a section begins; 0 is the outside",
        "minorAngleEnd": "angle (rad) at which it ends",
        "invert": "True: its visible side is the inner one",
    },
    "RigidLink": {
        "p0": "first joint (m)",
        "p1": "second joint (m)",
        "axis0": "axis of the first joint; zero: a sphere is drawn",
        "axis1": "axis of the second joint",
        "radius": "radii of the joints (m)",
        "thickness": "diameter of the bar (m)",
        "width": "lengths of the cylinders of the joints (m)",
    },
    "Quad": {
        "alternatingColor": "second color of a checkerboard",
        "pList": "4 corners (m), counter-clockwise",
        "nTiles": "number of tiles along the first side; 10 with an alternatingColor",
        "nTilesY": "number of tiles along the second side; where nothing is said, nTiles",
    },
    "CheckerBoard": {
        "normal": "direction that the board is seen from",
        "size": "side length (m)",
        "nTiles": "number of tiles along the first side",
        "size2": "length of the second side (m); where nothing is said, size",
        "nTiles2": "number of tiles along the second side; where nothing is said, nTiles",
        "materialIndex": "index of a material, in the place of the opacity",
    },
    "SolidExtrusion": {
        "vertices": "points [x, y] of outlines (m)",
        "segments": "pairs of indices of vertices, closed curves: the outer one counter-clockwise, holes clockwise",
        "height": "distance of the copy along z (m)",
        "rot": "3x3 matrix that turns all points at the end",
        "relRot": "3x3 matrix that turns the copy",
        "relOff": "vector (m) by which the copy is shifted",
        "addEdges": "True: edges of bottom and top are drawn; 2: those along the mantle, too",
    },
    "LinkedCylinders": {
        "point0": "center of the first cylinder, at its bottom (m)",
        "point1": "center of the second cylinder (m)",
        "axisCylinder": "direction of both axes; its length (m) is their height",
        "radius0": "radius of the first cylinder (m)",
        "radius1": "radius of the second cylinder (m)",
        "radiusInner0": "radius of a hole in the first (m); 0: none",
        "radiusInner1": "radius of a hole in the second (m); 0: none",
    },
    "InvoluteGear": {
        "involuteGear": "a machines.InvoluteGear: module, number of teeth and flanks",
        "helixAngleDeg": "angle of the teeth to the axis (degrees); 0: they are straight",
        "radius": "radius of the bore, or outer radius of an internal gear (m)",
        "relativeAngleOffset": "turns the gear by so many angles of a tooth",
    },
    "ToothedRack": _RACK,
    "BallBearingRings": _BEARING,
    "SolidOfRevolution": {
        "contour": "points [axial, radial] (m); seen along growing axial numbers, the solid is to their right",
        "vAxis": "direction of the axis; its length does not count",
        "smoothContour": "True: normals of segments that follow each other are averaged",
        "smoothingAngle": "angle (rad) between segments from which on they are not",
        "addEdges": "number of lines along the contour; True: circles only",
        "alternatingColor": "color of the second half",
    },
    "Basis": {
        "origin": "where the arrows begin (m)",
        "rotationMatrix": "3x3 matrix whose columns the arrows follow",
        "radius": "radius of the shafts (m); where nothing is said, 0.01 length",
        "labels": "three texts at the tips",
    },
    "Frame": {
        "HT": "4x4 homogeneous transformation of the frame",
        "radius": "radius of the shafts (m); where nothing is said, 0.01 length",
    },
    "FromSTLfile": {
        "density": "density (kg/m^3), 0: only graphics are returned; else properties of the solid, too",
    },
    "FromPyMeshlabFile": {
        "defaultColor": "color of parts without a color in the file",
        "useDefaultColor": "True: colors of the file are not used",
    },
    "NGsolveMesh2PointsAndTrigs": {
        "mesh": "a mesh of NGsolve",
        "ngMesh": "a mesh of netgen, in its place",
        "meshOrder": "1: linear; 2: the mesh is made quadratic, and each surface element gives 4 triangles",
        "addNormals": "True: normals are returned, too",
    },
    "ExportSTL": {"solidName": "name of the solid in the file"},
    "FromPointsAndTrigs": {
        "points": "n points [x, y, z] (m)",
        "triangles": "three indices of points each, counter-clockwise seen from outside",
        "color": "one color, or n colors",
        "normals": "n normals, or None",
    },
    "Transform": {
        "translation": "vector (m) by which points are shifted; None: none",
        "rotation": "3x3 matrix that turns points and normals; None: none",
        "scale": "factor of all lengths",
        "warn": "True: a warning counts normals of length zero",
    },
    "Move": {"pOff": "vector (m) by which points are shifted"},
    "MergeTriangleLists": {"g1": "a TriangleList", "g2": "another one"},
    "AddEdgesAndSmoothenNormals": {
        "edgeAngle": "angle (rad) between triangles from which on there is an edge",
        "addEdges": "False: normals only",
        "smoothNormals": "False: edges only",
        "roundDigits": "points that agree in so many digits, relative to the size of the geometry, are one",
        "triangleColor": "color of all triangles; empty: colors stay",
    },
}


def describe(function: FunctionType) -> None:
    """Append the parameters of a graphics function to its docstring, those that it takes by ** among them."""
    own = _OWN.get(function.__name__, {})
    texts = _COMMON | own
    parameters = signature(function).parameters.values()
    named = [each.name for each in parameters if each.kind is not each.VAR_KEYWORD]
    names = [*named, *(name for name in own if name not in named)]
    entries = [f"{name}: {texts[name]}" for name in names]
    function.__doc__ = "\n".join([cleandoc(function.__doc__ or ""), "", *entries])
