# Generated from specs/ by codegen/templates/itemInterface.pyi.j2. Do not edit; run `python -m codegen`.
# tests/codegen/test_freshness.py compares this file with its sources.

from collections.abc import Callable, Iterator, Sequence
from typing import Any, Literal, Protocol

from numpy.typing import ArrayLike

from dalembert._core import (
    BeamSection,
    BeamSectionGeometry,
    JointType,
    LoadIndex,
    MarkerIndex,
    MatrixContainer,
    NodeIndex,
    ObjectIndex,
    OutputVariableType,
    SensorIndex,
)

class _SparseMatrix(Protocol):
    """A sparse matrix of scipy."""

    def tocoo(self) -> Any: ...

# A matrix given densely, as triplets in a container, or as a sparse matrix.
MatrixLike = ArrayLike | MatrixContainer | _SparseMatrix

class _Item:
    """A set of parameters: item classes convert to dictionaries, and are what AddNode, AddObject, ... take."""

    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class VNodeGenericAE:
    """Visualization of NodeGenericAE."""

    show: bool
    """True: the item is drawn"""
    def __init__(
        self,
        show: bool = False,
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class NodeGenericAE(_Item):
    """node with a chosen number of algebraic variables, for equations that hold without time derivatives"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    referenceCoordinates: ArrayLike
    """reference values; as many as ``numberOfAECoordinates``, any other length is refused; units as in the equations that use the node [n; various]"""
    initialCoordinates: ArrayLike
    """start values of the solver, relative to the reference values; as many as ``numberOfAECoordinates`` [n; various]"""
    numberOfAECoordinates: int
    """number of algebraic variables; at least 1"""
    visualization: VNodeGenericAE | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        referenceCoordinates: ArrayLike = [],
        initialCoordinates: ArrayLike = [],
        numberOfAECoordinates: int = 0,
        visualization: VNodeGenericAE | dict[str, Any] = ...,
    ) -> None: ...

class VNodeGenericData:
    """Visualization of NodeGenericData."""

    show: bool
    """True: the item is drawn"""
    def __init__(
        self,
        show: bool = False,
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class NodeGenericData(_Item):
    """node with a chosen number of data variables: states that are kept from step to step and are not unknowns of the solver"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    initialCoordinates: ArrayLike
    """values at the start of a computation; as many as ``numberOfDataCoordinates``, any other length is refused; their meaning and units are those of the object that uses the node [n; various]"""
    numberOfDataCoordinates: int
    """number of data variables; objects that need a data node say how many they expect"""
    visualization: VNodeGenericData | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        initialCoordinates: ArrayLike = [],
        numberOfDataCoordinates: int = 0,
        visualization: VNodeGenericData | dict[str, Any] = ...,
    ) -> None: ...

class VNodeGenericODE1:
    """Visualization of NodeGenericODE1."""

    show: bool
    """True: the item is drawn"""
    def __init__(
        self,
        show: bool = False,
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class NodeGenericODE1(_Item):
    """node with a chosen number of coordinates of first order differential equations, for controllers, hydraulics and state-space models"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    referenceCoordinates: ArrayLike
    """constant values to which the coordinates are added; as many as ``numberOfODE1Coordinates``, any other length is refused; units as in the equations that use the node [n; various]"""
    initialCoordinates: ArrayLike
    """values at the start, relative to the reference values; as many as ``numberOfODE1Coordinates`` [n; various]"""
    numberOfODE1Coordinates: int
    """number of coordinates, each with a first order differential equation; at least 1"""
    visualization: VNodeGenericODE1 | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        referenceCoordinates: ArrayLike = [],
        initialCoordinates: ArrayLike = [],
        numberOfODE1Coordinates: int = 0,
        visualization: VNodeGenericODE1 | dict[str, Any] = ...,
    ) -> None: ...

class VNodeGenericODE2:
    """Visualization of NodeGenericODE2."""

    show: bool
    """True: the item is drawn"""
    def __init__(
        self,
        show: bool = False,
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class NodeGenericODE2(_Item):
    """node with a chosen number of coordinates of second order differential equations, without a meaning in space"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    referenceCoordinates: ArrayLike
    """constant values to which the coordinates are added; as many as ``numberOfODE2Coordinates``, any other length is refused; units as in the equations that use the node [n; various]"""
    initialCoordinates: ArrayLike
    """values at the start, relative to the reference values; as many as ``numberOfODE2Coordinates`` [n; various]"""
    initialCoordinates_t: ArrayLike
    """time derivatives of the coordinates at the start; as many as ``numberOfODE2Coordinates`` [n; various]"""
    numberOfODE2Coordinates: int
    """number of coordinates, each with a second order differential equation; at least 1"""
    visualization: VNodeGenericODE2 | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        referenceCoordinates: ArrayLike = [],
        initialCoordinates: ArrayLike = [],
        initialCoordinates_t: ArrayLike = [],
        numberOfODE2Coordinates: int = 0,
        visualization: VNodeGenericODE2 | dict[str, Any] = ...,
    ) -> None: ...

class VNode1D:
    """Visualization of Node1D."""

    show: bool
    """True: the item is drawn"""
    def __init__(
        self,
        show: bool = False,
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class Node1D(_Item):
    """node with one coordinate of a second order differential equation, for motion along a line or about a fixed axis"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    referenceCoordinates: ArrayLike
    """reference value of the coordinate, a list of length 1; m for a translation, rad for a rotation, as the body on the node says [n; various]"""
    initialCoordinates: ArrayLike
    """coordinate at the start, relative to the reference value, a list of length 1 [n; various]"""
    initialVelocities: ArrayLike
    """time derivative of the coordinate at the start, a list of length 1 [n; various]"""
    visualization: VNode1D | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        referenceCoordinates: ArrayLike = [0.0],
        initialCoordinates: ArrayLike = [0.0],
        initialVelocities: ArrayLike = [0.0],
        visualization: VNode1D | dict[str, Any] = ...,
    ) -> None: ...

class VNodePoint:
    """Visualization of NodePoint."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    color: ArrayLike
    """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class NodePoint(_Item):
    """node with the three displacements of a point in space"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    referenceCoordinates: ArrayLike
    """global position of the node without displacement [3; m]"""
    initialCoordinates: ArrayLike
    """displacement from the reference position at the start [3; m]"""
    initialVelocities: ArrayLike
    """global velocity at the start [3; m/s]"""
    visualization: VNodePoint | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        referenceCoordinates: ArrayLike = [0.0, 0.0, 0.0],
        initialCoordinates: ArrayLike = [0.0, 0.0, 0.0],
        initialVelocities: ArrayLike = [0.0, 0.0, 0.0],
        visualization: VNodePoint | dict[str, Any] = ...,
    ) -> None: ...

Point = NodePoint
VPoint = VNodePoint

class VNodePoint2D:
    """Visualization of NodePoint2D."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    color: ArrayLike
    """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class NodePoint2D(_Item):
    """node with the two displacements of a point in the global x-y plane"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    referenceCoordinates: ArrayLike
    """global x and y position of the node without displacement; z is zero [2; m]"""
    initialCoordinates: ArrayLike
    """displacement in x and y from the reference position at the start [2; m]"""
    initialVelocities: ArrayLike
    """global velocity in x and y at the start [2; m/s]"""
    visualization: VNodePoint2D | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        referenceCoordinates: ArrayLike = [0.0, 0.0],
        initialCoordinates: ArrayLike = [0.0, 0.0],
        initialVelocities: ArrayLike = [0.0, 0.0],
        visualization: VNodePoint2D | dict[str, Any] = ...,
    ) -> None: ...

Point2D = NodePoint2D
VPoint2D = VNodePoint2D

class VNodePoint2DSlope1:
    """Visualization of NodePoint2DSlope1."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    color: ArrayLike
    """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class NodePoint2DSlope1(_Item):
    """node of planar cable elements: position and axial slope vector in the global x-y plane"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    referenceCoordinates: ArrayLike
    """x and y position (m), then x and y component of the slope vector (1); a unit vector along the axis for an element that is not stretched in the reference configuration [4; various]"""
    initialCoordinates: ArrayLike
    """displacement (m) and change of the slope vector (1) at the start, relative to the reference coordinates [4; various]"""
    initialVelocities: ArrayLike
    """velocity (m/s) and rate of the slope vector (1/s) at the start [4; various]"""
    visualization: VNodePoint2DSlope1 | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        referenceCoordinates: ArrayLike = [0.0, 0.0, 1.0, 0.0],
        initialCoordinates: ArrayLike = [0.0, 0.0, 0.0, 0.0],
        initialVelocities: ArrayLike = [0.0, 0.0, 0.0, 0.0],
        visualization: VNodePoint2DSlope1 | dict[str, Any] = ...,
    ) -> None: ...

Point2DS1 = NodePoint2DSlope1
VPoint2DS1 = VNodePoint2DSlope1

class VNodePointGround:
    """Visualization of NodePointGround."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    color: ArrayLike
    """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class NodePointGround(_Item):
    """fixed point without coordinates, as the other end of springs and constraints on coordinates or points"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    referenceCoordinates: ArrayLike
    """global position of the node [3; m]"""
    visualization: VNodePointGround | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        referenceCoordinates: ArrayLike = [0.0, 0.0, 0.0],
        visualization: VNodePointGround | dict[str, Any] = ...,
    ) -> None: ...

PointGround = NodePointGround
VPointGround = VNodePointGround

class VNodePointSlope1:
    """Visualization of NodePointSlope1."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    color: ArrayLike
    """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class NodePointSlope1(_Item):
    """node of spatial cable elements: position and axial slope vector"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    referenceCoordinates: ArrayLike
    """global position (m), then the slope vector (1); a unit vector along the axis for an element that is not stretched in the reference configuration [6; various]"""
    initialCoordinates: ArrayLike
    """displacement (m) and change of the slope vector (1) at the start, relative to the reference coordinates [6; various]"""
    initialVelocities: ArrayLike
    """velocity (m/s) and rate of the slope vector (1/s) at the start [6; various]"""
    visualization: VNodePointSlope1 | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        referenceCoordinates: ArrayLike = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0],
        initialCoordinates: ArrayLike = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        initialVelocities: ArrayLike = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        visualization: VNodePointSlope1 | dict[str, Any] = ...,
    ) -> None: ...

class VNodePointSlope12:
    """Visualization of NodePointSlope12."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    color: ArrayLike
    """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class NodePointSlope12(_Item):
    """node of thin plate elements: position and the two slope vectors in the plane of the plate"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    referenceCoordinates: ArrayLike
    """global position (m), then the slope vectors in x and y (1); the two default slopes are parallel and so span no frame: give independent ones [9; various]"""
    initialCoordinates: ArrayLike
    """displacement (m) and change of the slope vectors (1) at the start, relative to the reference coordinates [9; various]"""
    initialVelocities: ArrayLike
    """velocity (m/s) and rates of the slope vectors (1/s) at the start [9; various]"""
    visualization: VNodePointSlope12 | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        referenceCoordinates: ArrayLike = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0],
        initialCoordinates: ArrayLike = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        initialVelocities: ArrayLike = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        visualization: VNodePointSlope12 | dict[str, Any] = ...,
    ) -> None: ...

class VNodePointSlope23:
    """Visualization of NodePointSlope23."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    color: ArrayLike
    """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class NodePointSlope23(_Item):
    """node of shear and cross-section deformable beam elements: position and the two slope vectors in the cross section"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    referenceCoordinates: ArrayLike
    """global position (m), then the slope vectors in y and z (1); the two default slopes are parallel and so span no frame: give independent ones [9; various]"""
    initialCoordinates: ArrayLike
    """displacement (m) and change of the slope vectors (1) at the start, relative to the reference coordinates [9; various]"""
    initialVelocities: ArrayLike
    """velocity (m/s) and rates of the slope vectors (1/s) at the start [9; various]"""
    visualization: VNodePointSlope23 | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        referenceCoordinates: ArrayLike = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0],
        initialCoordinates: ArrayLike = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        initialVelocities: ArrayLike = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        visualization: VNodePointSlope23 | dict[str, Any] = ...,
    ) -> None: ...

class VNodeRigidBody2D:
    """Visualization of NodeRigidBody2D."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    color: ArrayLike
    """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class NodeRigidBody2D(_Item):
    """node of a rigid body that moves in the global x-y plane: two displacements and the angle about z"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    referenceCoordinates: ArrayLike
    """x and y position of the reference point (m) and the angle about z (rad) without displacement and rotation [3; various]"""
    initialCoordinates: ArrayLike
    """displacement in x and y (m) and rotation about z (rad) at the start, relative to the reference coordinates [3; various]"""
    initialVelocities: ArrayLike
    """velocity in x and y (m/s) and angular velocity about z (rad/s) at the start [3; various]"""
    visualization: VNodeRigidBody2D | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        referenceCoordinates: ArrayLike = [0.0, 0.0, 0.0],
        initialCoordinates: ArrayLike = [0.0, 0.0, 0.0],
        initialVelocities: ArrayLike = [0.0, 0.0, 0.0],
        visualization: VNodeRigidBody2D | dict[str, Any] = ...,
    ) -> None: ...

Rigid2D = NodeRigidBody2D
VRigid2D = VNodeRigidBody2D

class VNodeRigidBodyEP:
    """Visualization of NodeRigidBodyEP."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    color: ArrayLike
    """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class NodeRigidBodyEP(_Item):
    """node of a rigid body in space: three displacements and four Euler parameters (unit quaternion)"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    referenceCoordinates: ArrayLike
    """position of the reference point (m) and four Euler parameters (1), the scalar one first; their norm must be 1, so that the default of zeros is refused; [1, 0, 0, 0] is no rotation [7; various]"""
    initialCoordinates: ArrayLike
    """displacement (m) and change of the Euler parameters (1) at the start; the sum of reference and initial Euler parameters must have norm 1 [7; various]"""
    initialVelocities: ArrayLike
    """velocity (m/s) and time derivatives of the Euler parameters (1/s) at the start; for a given angular velocity they are :math:`\\tfrac{1}{4}\\, {}^{b}\\mathbf{G}^{\\mathsf{T}}\\, {}^{b}\\boldsymbol{\\omega}` [7; various]"""
    addConstraintEquation: bool
    """true: the node adds the equation that keeps the norm of the Euler parameters, with one algebraic variable; false: the norm has to be kept by a constraint of the model"""
    visualization: VNodeRigidBodyEP | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        referenceCoordinates: ArrayLike = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        initialCoordinates: ArrayLike = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        initialVelocities: ArrayLike = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        addConstraintEquation: bool = True,
        visualization: VNodeRigidBodyEP | dict[str, Any] = ...,
    ) -> None: ...

RigidEP = NodeRigidBodyEP
VRigidEP = VNodeRigidBodyEP

class VNodeRigidBodyRotVecLG:
    """Visualization of NodeRigidBodyRotVecLG."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    color: ArrayLike
    """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class NodeRigidBodyRotVecLG(_Item):
    """node of a rigid body in space: three displacements and a rotation vector that is integrated by Lie group methods"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    referenceCoordinates: ArrayLike
    """position of the reference point (m) and rotation vector (rad) without displacement and rotation [6; various]"""
    initialCoordinates: ArrayLike
    """displacement (m) and change of the rotation vector (rad) at the start; reference and initial rotation vector are added as vectors [6; various]"""
    initialVelocities: ArrayLike
    """velocity (m/s) and angular velocity in body coordinates (rad/s) at the start [6; various]"""
    visualization: VNodeRigidBodyRotVecLG | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        referenceCoordinates: ArrayLike = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        initialCoordinates: ArrayLike = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        initialVelocities: ArrayLike = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        visualization: VNodeRigidBodyRotVecLG | dict[str, Any] = ...,
    ) -> None: ...

RigidRotVecLG = NodeRigidBodyRotVecLG
VRigidRotVecLG = VNodeRigidBodyRotVecLG

class VNodeRigidBodyRxyz:
    """Visualization of NodeRigidBodyRxyz."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    color: ArrayLike
    """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class NodeRigidBodyRxyz(_Item):
    """node of a rigid body in space: three displacements and three Tait-Bryan angles about x, y and z in turn"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    referenceCoordinates: ArrayLike
    """position of the reference point (m) and the angles (rad) without displacement and rotation [6; various]"""
    initialCoordinates: ArrayLike
    """displacement (m) and change of the angles (rad) at the start, relative to the reference coordinates [6; various]"""
    initialVelocities: ArrayLike
    """velocity (m/s) and time derivatives of the angles (rad/s) at the start; the latter are not the components of the angular velocity, except at zero angles [6; various]"""
    visualization: VNodeRigidBodyRxyz | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        referenceCoordinates: ArrayLike = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        initialCoordinates: ArrayLike = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        initialVelocities: ArrayLike = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        visualization: VNodeRigidBodyRxyz | dict[str, Any] = ...,
    ) -> None: ...

RigidRxyz = NodeRigidBodyRxyz
VRigidRxyz = VNodeRigidBodyRxyz

class VObjectGenericODE1:
    """Visualization of ObjectGenericODE1."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectGenericODE1(_Item):
    """system of first order differential equations with a constant matrix, a constant vector and a user function"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    nodeNumbers: Sequence[NodeIndex | int]
    """nodes with first order coordinates; their coordinates in this order form the vector of the object [n]"""
    systemMatrix: ArrayLike
    """constant system matrix; n rows and n columns for n coordinates, or empty for zero; other sizes are refused [n x m; various]"""
    rhsVector: ArrayLike
    """constant right hand side; length n, or empty for zero [n; various]"""
    rhsUserFunction: Callable[..., Any] | Literal[0]
    """function that gives a further right hand side, of time and coordinates"""
    visualization: VObjectGenericODE1 | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        nodeNumbers: Sequence[NodeIndex | int] = [],
        systemMatrix: ArrayLike = [],
        rhsVector: ArrayLike = [],
        rhsUserFunction: Callable[..., Any] | Literal[0] = 0,
        visualization: VObjectGenericODE1 | dict[str, Any] = ...,
    ) -> None: ...

class VObjectGround:
    """Visualization of ObjectGround."""

    show: bool
    """False: the item is not drawn"""
    graphicsDataUserFunction: Callable[..., Any] | Literal[0]
    """function that returns the shapes to be drawn, called at every redraw; shapes are given in the frame of the body"""
    graphicsData: Sequence[dict[str, Any]]
    """shapes attached to the body frame, as made by the functions of the graphics module [n]"""
    def __init__(
        self,
        show: bool = True,
        graphicsDataUserFunction: Callable[..., Any] | Literal[0] = 0,
        graphicsData: Sequence[dict[str, Any]] = [],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectGround(_Item):
    """body that does not move: the fixed end of joints, connectors and markers"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    referencePosition: ArrayLike
    """global position of the origin of the ground frame; local positions of markers count from here [3; m]"""
    referenceRotation: ArrayLike
    """rotation matrix from the ground frame to the global frame; has to be orthonormal [3 x 3; 1]"""
    visualization: VObjectGround | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        referencePosition: ArrayLike = [0.0, 0.0, 0.0],
        referenceRotation: ArrayLike = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        visualization: VObjectGround | dict[str, Any] = ...,
    ) -> None: ...

class VObjectMass1D:
    """Visualization of ObjectMass1D."""

    show: bool
    """False: the item is not drawn"""
    graphicsData: Sequence[dict[str, Any]]
    """shapes attached to the body frame, as made by the functions of the graphics module [n]"""
    def __init__(
        self,
        show: bool = True,
        graphicsData: Sequence[dict[str, Any]] = [],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectMass1D(_Item):
    """mass that is guided along a line: one translation along the local x-axis"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    physicsMass: float
    """mass; zero is allowed if something else makes the equation of the node regular [kg]"""
    nodeNumber: NodeIndex | int
    """node with one coordinate of second order, which is the way (m) along the local x-axis"""
    referencePosition: ArrayLike
    """global position of the body at coordinate zero [3; m]"""
    referenceRotation: ArrayLike
    """constant rotation matrix from the body frame to the global frame; its first column is the direction of motion; has to be orthonormal [3 x 3; 1]"""
    visualization: VObjectMass1D | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        physicsMass: float = 0.0,
        nodeNumber: NodeIndex | int = -1,
        referencePosition: ArrayLike = [0.0, 0.0, 0.0],
        referenceRotation: ArrayLike = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        visualization: VObjectMass1D | dict[str, Any] = ...,
    ) -> None: ...

Mass1D = ObjectMass1D
VMass1D = VObjectMass1D

class VObjectMassPoint:
    """Visualization of ObjectMassPoint."""

    show: bool
    """False: the item is not drawn"""
    graphicsData: Sequence[dict[str, Any]]
    """shapes attached to the body frame, as made by the functions of the graphics module [n]"""
    def __init__(
        self,
        show: bool = True,
        graphicsData: Sequence[dict[str, Any]] = [],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectMassPoint(_Item):
    """point mass in space on a node with position"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    physicsMass: float
    """mass; zero is allowed if something else makes the equations of the node regular [kg]"""
    nodeNumber: NodeIndex | int
    """node with a position in space and three displacement coordinates"""
    visualization: VObjectMassPoint | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        physicsMass: float = 0.0,
        nodeNumber: NodeIndex | int = -1,
        visualization: VObjectMassPoint | dict[str, Any] = ...,
    ) -> None: ...

MassPoint = ObjectMassPoint
VMassPoint = VObjectMassPoint

class VObjectMassPoint2D:
    """Visualization of ObjectMassPoint2D."""

    show: bool
    """False: the item is not drawn"""
    graphicsData: Sequence[dict[str, Any]]
    """shapes attached to the body frame, as made by the functions of the graphics module [n]"""
    def __init__(
        self,
        show: bool = True,
        graphicsData: Sequence[dict[str, Any]] = [],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectMassPoint2D(_Item):
    """point mass in the global x-y plane on a planar node"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    physicsMass: float
    """mass; zero is allowed if something else makes the equations of the node regular [kg]"""
    nodeNumber: NodeIndex | int
    """node with a position in the plane and two displacement coordinates"""
    visualization: VObjectMassPoint2D | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        physicsMass: float = 0.0,
        nodeNumber: NodeIndex | int = -1,
        visualization: VObjectMassPoint2D | dict[str, Any] = ...,
    ) -> None: ...

MassPoint2D = ObjectMassPoint2D
VMassPoint2D = VObjectMassPoint2D

class VObjectRigidBody:
    """Visualization of ObjectRigidBody."""

    show: bool
    """False: the item is not drawn"""
    graphicsDataUserFunction: Callable[..., Any] | Literal[0]
    """function that returns the shapes to be drawn, called at every redraw; shapes are given in the frame of the body"""
    graphicsData: Sequence[dict[str, Any]]
    """shapes attached to the body frame, as made by the functions of the graphics module [n]"""
    def __init__(
        self,
        show: bool = True,
        graphicsDataUserFunction: Callable[..., Any] | Literal[0] = 0,
        graphicsData: Sequence[dict[str, Any]] = [],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectRigidBody(_Item):
    """rigid body in space with any center of mass, on a node with position and orientation"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    physicsMass: float
    """mass [kg]"""
    physicsInertia: ArrayLike
    """components :math:`[J_{xx}, J_{yy}, J_{zz}, J_{yz}, J_{xz}, J_{xy}]` of the inertia tensor in the body frame about the reference point, which is the node, and not about the center of mass; off-diagonal components are those of the tensor, :math:`J_{xy} = -\\int x y \\,\\mathrm{d}m` [6; kg m^2]"""
    physicsCenterOfMass: ArrayLike
    """position of the center of mass in the body frame, counted from the node [3; m]"""
    nodeNumber: NodeIndex | int
    """node of a rigid body in space"""
    visualization: VObjectRigidBody | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        physicsMass: float = 0.0,
        physicsInertia: ArrayLike = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        physicsCenterOfMass: ArrayLike = [0.0, 0.0, 0.0],
        nodeNumber: NodeIndex | int = -1,
        visualization: VObjectRigidBody | dict[str, Any] = ...,
    ) -> None: ...

RigidBody = ObjectRigidBody
VRigidBody = VObjectRigidBody

class VObjectRigidBody2D:
    """Visualization of ObjectRigidBody2D."""

    show: bool
    """False: the item is not drawn"""
    graphicsDataUserFunction: Callable[..., Any] | Literal[0]
    """function that returns the shapes to be drawn, called at every redraw; shapes are given in the frame of the body"""
    graphicsData: Sequence[dict[str, Any]]
    """shapes attached to the body frame, as made by the functions of the graphics module [n]"""
    def __init__(
        self,
        show: bool = True,
        graphicsDataUserFunction: Callable[..., Any] | Literal[0] = 0,
        graphicsData: Sequence[dict[str, Any]] = [],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectRigidBody2D(_Item):
    """rigid body that moves in the global x-y plane, with any center of mass"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    physicsMass: float
    """mass [kg]"""
    physicsInertia: float
    """moment of inertia about the z-axis through the reference point, which is the node, and not through the center of mass [kg m^2]"""
    physicsCenterOfMass: ArrayLike
    """x and y position of the center of mass in the body frame, counted from the node [2; m]"""
    nodeNumber: NodeIndex | int
    """node of a rigid body in the plane"""
    visualization: VObjectRigidBody2D | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        physicsMass: float = 0.0,
        physicsInertia: float = 0.0,
        physicsCenterOfMass: ArrayLike = [0.0, 0.0],
        nodeNumber: NodeIndex | int = -1,
        visualization: VObjectRigidBody2D | dict[str, Any] = ...,
    ) -> None: ...

RigidBody2D = ObjectRigidBody2D
VRigidBody2D = VObjectRigidBody2D

class VObjectRotationalMass1D:
    """Visualization of ObjectRotationalMass1D."""

    show: bool
    """False: the item is not drawn"""
    graphicsData: Sequence[dict[str, Any]]
    """shapes attached to the body frame, as made by the functions of the graphics module [n]"""
    def __init__(
        self,
        show: bool = True,
        graphicsData: Sequence[dict[str, Any]] = [],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectRotationalMass1D(_Item):
    """rotor about a fixed axis: one rotation about the local z-axis"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    physicsInertia: float
    """moment of inertia about the axis of rotation [kg m^2]"""
    nodeNumber: NodeIndex | int
    """node with one coordinate of second order, which is the angle (rad) about the local z-axis"""
    referencePosition: ArrayLike
    """global position of the body frame, a fixed point of the axis [3; m]"""
    referenceRotation: ArrayLike
    """constant rotation matrix from the frame at angle zero to the global frame; its third column is the axis of rotation; has to be orthonormal [3 x 3; 1]"""
    visualization: VObjectRotationalMass1D | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        physicsInertia: float = 0.0,
        nodeNumber: NodeIndex | int = -1,
        referencePosition: ArrayLike = [0.0, 0.0, 0.0],
        referenceRotation: ArrayLike = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        visualization: VObjectRotationalMass1D | dict[str, Any] = ...,
    ) -> None: ...

Rotor1D = ObjectRotationalMass1D
VRotor1D = VObjectRotationalMass1D

class VObjectFFRF:
    """Visualization of ObjectFFRF."""

    show: bool
    """False: the item is not drawn"""
    color: ArrayLike
    """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    triangleMesh: ArrayLike
    """surface triangles, one row with three positions in ``nodeNumbers`` each (counted from 0); empty: no surface is drawn [n x m]"""
    showNodes: bool
    """draw the nodes of the object at their deformed positions, whether or not the nodes themselves are shown"""
    def __init__(
        self,
        show: bool = True,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
        triangleMesh: ArrayLike = [],
        showNodes: bool = False,
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectFFRF(_Item):
    """flexible body with the nodal coordinates of a finite element mesh in a floating frame of reference"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    nodeNumbers: Sequence[NodeIndex | int]
    """first the node of the body frame (Euler parameters), then the points of the mesh; the displacements of the latter are components in the body frame [n]"""
    massMatrixFF: MatrixLike
    """mass matrix of the free mesh, without the coordinates of the body frame; three rows and columns per mesh node [n x m; various]"""
    stiffnessMatrixFF: MatrixLike
    """stiffness matrix of the free mesh in the body frame; three rows and columns per mesh node [n x m; various]"""
    dampingMatrixFF: MatrixLike
    """damping matrix of the free mesh in the body frame; three rows and columns per mesh node, or empty for zero [n x m; various]"""
    forceVector: ArrayLike
    """constant generalized forces on the right hand side, for body frame and mesh, in global components; those of the mesh are turned into the body frame; empty for zero [n; various]"""
    forceUserFunction: Callable[..., Any] | Literal[0]
    """function that gives further generalized forces on the right hand side"""
    massMatrixUserFunction: Callable[..., Any] | Literal[0]
    """function that gives an additional mass matrix for all coordinates"""
    computeFFRFterms: bool
    """true: the inertia coupling of rigid body motion and deformation is computed by the object; false: only the given matrices act, and the user functions supply mass matrix and velocity terms"""
    objectIsInitialized: bool
    """leave it at false; the object sets it when its constant matrices are computed in ``Assemble()``, and setting it back to false has them computed anew"""
    visualization: VObjectFFRF | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        nodeNumbers: Sequence[NodeIndex | int] = [],
        massMatrixFF: MatrixLike = [],
        stiffnessMatrixFF: MatrixLike = [],
        dampingMatrixFF: MatrixLike = [],
        forceVector: ArrayLike = [],
        forceUserFunction: Callable[..., Any] | Literal[0] = 0,
        massMatrixUserFunction: Callable[..., Any] | Literal[0] = 0,
        computeFFRFterms: bool = True,
        objectIsInitialized: bool = False,
        visualization: VObjectFFRF | dict[str, Any] = ...,
    ) -> None: ...

class VObjectFFRFreducedOrder:
    """Visualization of ObjectFFRFreducedOrder."""

    show: bool
    """False: the item is not drawn"""
    color: ArrayLike
    """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    triangleMesh: ArrayLike
    """surface triangles, one row with three positions in ``nodeNumbers`` each (counted from 0); empty: no surface is drawn [n x m]"""
    showNodes: bool
    """draw the nodes of the object at their deformed positions, whether or not the nodes themselves are shown"""
    def __init__(
        self,
        show: bool = True,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
        triangleMesh: ArrayLike = [],
        showNodes: bool = False,
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectFFRFreducedOrder(_Item):
    """flexible body with modal coordinates in a floating frame of reference"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    nodeNumbers: Sequence[NodeIndex | int]
    """two nodes: the node of the body frame, and a generic node of second order with the modal coordinates [n]"""
    massMatrixReduced: MatrixLike
    """modal mass matrix, one row and column per mode [n x m; various]"""
    stiffnessMatrixReduced: MatrixLike
    """modal stiffness matrix, one row and column per mode [n x m; various]"""
    dampingMatrixReduced: MatrixLike
    """modal damping matrix, one row and column per mode; empty for zero [n x m; various]"""
    forceUserFunction: Callable[..., Any] | Literal[0]
    """function that gives generalized forces on the right hand side"""
    massMatrixUserFunction: Callable[..., Any] | Literal[0]
    """function that gives an additional mass matrix for all coordinates"""
    computeFFRFterms: bool
    """true: the inertia coupling of rigid body motion and deformation is computed by the object; false: only the given matrices act, and the user functions supply mass matrix and velocity terms"""
    modeBasis: ArrayLike
    """one column per mode, three rows per mesh node: displacements of the mesh in the body frame for a unit modal coordinate [n x m; various]"""
    outputVariableModeBasis: ArrayLike
    """values of an output variable per unit modal coordinate, one row per mesh node; for each mode as many columns as the variable has components; empty: none [n x m; various]"""
    outputVariableTypeModeBasis: OutputVariableType
    """output variable that ``outputVariableModeBasis`` holds, such as stress or strain"""
    referencePositions: ArrayLike
    """reference positions of the mesh nodes in the body frame, three per node [n; m]"""
    objectIsInitialized: bool
    """leave it at false; the object sets it when its constant matrices are computed in ``Assemble()``, and setting it back to false has them computed anew"""
    physicsMass: float
    """total mass [kg]"""
    physicsInertia: ArrayLike
    """inertia tensor of the undeformed body about the origin of the body frame [3 x 3; kg m^2]"""
    physicsCenterOfMass: ArrayLike
    """center of mass of the undeformed body in the body frame [3; m]"""
    mPsiTildePsi: ArrayLike
    """constant matrix of the inertia coupling, computed from mesh and modes by the class ``ObjectFFRFreducedOrderInterface``; empty as long as that class is not used [n x m; various]"""
    mPsiTildePsiTilde: ArrayLike
    """constant matrix of the inertia coupling, computed from mesh and modes by the class ``ObjectFFRFreducedOrderInterface``; empty as long as that class is not used [n x m; various]"""
    mPhitTPsi: ArrayLike
    """constant matrix of the inertia coupling, computed from mesh and modes by the class ``ObjectFFRFreducedOrderInterface``; empty as long as that class is not used [n x m; various]"""
    mPhitTPsiTilde: ArrayLike
    """constant matrix of the inertia coupling, computed from mesh and modes by the class ``ObjectFFRFreducedOrderInterface``; empty as long as that class is not used [n x m; various]"""
    mXRefTildePsi: ArrayLike
    """constant matrix of the inertia coupling, computed from mesh and modes by the class ``ObjectFFRFreducedOrderInterface``; empty as long as that class is not used [n x m; various]"""
    mXRefTildePsiTilde: ArrayLike
    """constant matrix of the inertia coupling, computed from mesh and modes by the class ``ObjectFFRFreducedOrderInterface``; empty as long as that class is not used [n x m; various]"""
    physicsCenterOfMassTilde: ArrayLike
    """skew symmetric matrix of the center of mass, computed by the object [3 x 3; m]"""
    visualization: VObjectFFRFreducedOrder | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        nodeNumbers: Sequence[NodeIndex | int] = [],
        massMatrixReduced: MatrixLike = [],
        stiffnessMatrixReduced: MatrixLike = [],
        dampingMatrixReduced: MatrixLike = [],
        forceUserFunction: Callable[..., Any] | Literal[0] = 0,
        massMatrixUserFunction: Callable[..., Any] | Literal[0] = 0,
        computeFFRFterms: bool = True,
        modeBasis: ArrayLike = [],
        outputVariableModeBasis: ArrayLike = [],
        outputVariableTypeModeBasis: OutputVariableType = OutputVariableType._None,
        referencePositions: ArrayLike = [],
        objectIsInitialized: bool = False,
        physicsMass: float = 0.0,
        physicsInertia: ArrayLike = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        physicsCenterOfMass: ArrayLike = [0.0, 0.0, 0.0],
        mPsiTildePsi: ArrayLike = [],
        mPsiTildePsiTilde: ArrayLike = [],
        mPhitTPsi: ArrayLike = [],
        mPhitTPsiTilde: ArrayLike = [],
        mXRefTildePsi: ArrayLike = [],
        mXRefTildePsiTilde: ArrayLike = [],
        physicsCenterOfMassTilde: ArrayLike = [[0.0, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 0.0]],
        visualization: VObjectFFRFreducedOrder | dict[str, Any] = ...,
    ) -> None: ...

CMSobject = ObjectFFRFreducedOrder
VCMSobject = VObjectFFRFreducedOrder

class VObjectGenericODE2:
    """Visualization of ObjectGenericODE2."""

    show: bool
    """False: the item is not drawn"""
    color: ArrayLike
    """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    triangleMesh: ArrayLike
    """surface triangles, one row with three positions in ``nodeNumbers`` each (counted from 0); empty: no surface is drawn [n x m]"""
    showNodes: bool
    """draw the nodes of the object at their deformed positions, whether or not the nodes themselves are shown"""
    graphicsDataUserFunction: Callable[..., Any] | Literal[0]
    """function that returns the shapes to be drawn, called at every redraw; shapes are given in the global frame"""
    def __init__(
        self,
        show: bool = True,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
        triangleMesh: ArrayLike = [],
        showNodes: bool = False,
        graphicsDataUserFunction: Callable[..., Any] | Literal[0] = 0,
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectGenericODE2(_Item):
    """system of second order differential equations with constant matrices and user functions, on any nodes"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    nodeNumbers: Sequence[NodeIndex | int]
    """nodes with second order coordinates; their coordinates in this order form the vector of the object [n]"""
    massMatrix: MatrixLike
    """constant mass matrix; n rows and n columns for n coordinates, dense or sparse, or empty for zero; other sizes are refused [n x m; various]"""
    stiffnessMatrix: MatrixLike
    """constant stiffness matrix; n rows and n columns, or empty for zero; dense or sparse, in the same form as the damping matrix [n x m; various]"""
    dampingMatrix: MatrixLike
    """constant damping matrix; n rows and n columns, or empty for zero; dense or sparse, in the same form as the stiffness matrix [n x m; various]"""
    forceVector: ArrayLike
    """constant generalized forces on the right hand side; length n, or empty for zero [n; various]"""
    forceUserFunction: Callable[..., Any] | Literal[0]
    """function that gives further generalized forces on the right hand side"""
    massMatrixUserFunction: Callable[..., Any] | Literal[0]
    """function that gives the mass matrix; it replaces ``massMatrix``"""
    jacobianUserFunction: Callable[..., Any] | Literal[0]
    """function that gives the derivatives of the user forces; without it they are found by numerical differentiation"""
    visualization: VObjectGenericODE2 | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        nodeNumbers: Sequence[NodeIndex | int] = [],
        massMatrix: MatrixLike = [],
        stiffnessMatrix: MatrixLike = [],
        dampingMatrix: MatrixLike = [],
        forceVector: ArrayLike = [],
        forceUserFunction: Callable[..., Any] | Literal[0] = 0,
        massMatrixUserFunction: Callable[..., Any] | Literal[0] = 0,
        jacobianUserFunction: Callable[..., Any] | Literal[0] = 0,
        visualization: VObjectGenericODE2 | dict[str, Any] = ...,
    ) -> None: ...

class VObjectKinematicTree:
    """Visualization of ObjectKinematicTree."""

    show: bool
    """False: the item is not drawn"""
    showLinks: bool
    """draw the links, as given by ``graphicsDataList`` or, if that is empty, as cylinders between the joints"""
    showJoints: bool
    """draw the joints in a standard form; only if ``graphicsDataList`` is empty"""
    color: ArrayLike
    """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    graphicsDataList: Sequence[Sequence[dict[str, Any]]]
    """for each link a list of shapes in the frame of the link; empty, or as long as there are links [n x m]"""
    def __init__(
        self,
        show: bool = True,
        showLinks: bool = True,
        showJoints: bool = True,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
        graphicsDataList: Sequence[Sequence[dict[str, Any]]] = [],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectKinematicTree(_Item):
    """open tree of rigid bodies in minimal coordinates, one joint coordinate per link"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    nodeNumber: NodeIndex | int
    """generic node of second order with one coordinate per joint: rad for revolute, m for prismatic joints"""
    gravity: ArrayLike
    """gravity in global components; mass proportional loads do not act on this object [3; m/s^2]"""
    baseOffset: ArrayLike
    """global position of the base frame [3; m]"""
    jointTypes: Sequence[JointType]
    """type of each joint, one per link; required [n]"""
    linkParents: Sequence[int]
    """number of the parent link of each link, -1 for the base; a parent has a smaller number than its links; required [n]"""
    jointTransformations: Sequence[ArrayLike]
    """for each link the rotation matrix from its joint frame, at coordinate zero, to the frame of the parent; required [n x 3 x 3; 1]"""
    jointOffsets: Sequence[ArrayLike]
    """for each link the origin of its joint frame in the frame of the parent, for the base in the base frame; required [n x 3; m]"""
    linkInertiasCOM: Sequence[ArrayLike]
    """for each link the inertia tensor about its center of mass, in the frame of the link; required [n x 3 x 3; kg m^2]"""
    linkCOMs: Sequence[ArrayLike]
    """for each link the center of mass in the frame of the link; required [n x 3; m]"""
    linkMasses: ArrayLike
    """mass of each link; required [n; kg]"""
    linkForces: Sequence[ArrayLike]
    """for each link a force in global components at the origin of its joint frame; empty for zero [n x 3; N]"""
    linkTorques: Sequence[ArrayLike]
    """for each link a torque in global components; empty for zero [n x 3; Nm]"""
    jointForceVector: ArrayLike
    """for each joint a torque (Nm) or force (N) about or along its axis, positive on the link and negative on its parent; empty for zero [n; various]"""
    jointPositionOffsetVector: ArrayLike
    """desired joint coordinates of the position control (rad or m); empty for zero [n; various]"""
    jointVelocityOffsetVector: ArrayLike
    """desired joint velocities of the velocity control (rad/s or m/s); empty for zero [n; various]"""
    jointPControlVector: ArrayLike
    """proportional gain of each joint (Nm/rad or N/m); empty for zero [n; various]"""
    jointDControlVector: ArrayLike
    """derivative gain of each joint (Nm s/rad or Ns/m); empty for zero [n; various]"""
    forceUserFunction: Callable[..., Any] | Literal[0]
    """function that gives further joint forces, which act as those of ``jointForceVector``"""
    visualization: VObjectKinematicTree | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        nodeNumber: NodeIndex | int = -1,
        gravity: ArrayLike = [0.0, 0.0, 0.0],
        baseOffset: ArrayLike = [0.0, 0.0, 0.0],
        jointTypes: Sequence[JointType] = [],
        linkParents: Sequence[int] = [],
        jointTransformations: Sequence[ArrayLike] = [],
        jointOffsets: Sequence[ArrayLike] = [],
        linkInertiasCOM: Sequence[ArrayLike] = [],
        linkCOMs: Sequence[ArrayLike] = [],
        linkMasses: ArrayLike = [],
        linkForces: Sequence[ArrayLike] = [],
        linkTorques: Sequence[ArrayLike] = [],
        jointForceVector: ArrayLike = [],
        jointPositionOffsetVector: ArrayLike = [],
        jointVelocityOffsetVector: ArrayLike = [],
        jointPControlVector: ArrayLike = [],
        jointDControlVector: ArrayLike = [],
        forceUserFunction: Callable[..., Any] | Literal[0] = 0,
        visualization: VObjectKinematicTree | dict[str, Any] = ...,
    ) -> None: ...

KinematicTree = ObjectKinematicTree
VKinematicTree = VObjectKinematicTree

class VObjectALEANCFCable2D:
    """Visualization of ObjectALEANCFCable2D."""

    show: bool
    """False: the item is not drawn"""
    drawHeight: float
    """height of the rectangle that is drawn; 0 draws the axis only [m]"""
    color: ArrayLike
    """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    def __init__(
        self,
        show: bool = True,
        drawHeight: float = 0.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectALEANCFCable2D(_Item):
    """planar cable through which material moves along the axis, on two nodes with slope and one node with the axial coordinate"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    physicsLength: float
    """length of the element in its undeformed state; must be positive [m]"""
    physicsMassPerLength: float
    """total mass per undeformed length, of the resting and the moving part [kg/m]"""
    physicsMovingMassFactor: float
    """share of the mass per length that moves along the axis: 1 for an axially moving beam, 0 for none, between for a pipe with fluid [1]"""
    physicsBendingStiffness: float
    """bending stiffness: bending moment per curvature [N m^2]"""
    physicsAxialStiffness: float
    """axial stiffness: axial force per axial strain [N]"""
    physicsBendingDamping: float
    """viscous damping of bending: bending moment per rate of curvature [N m^2 s]"""
    physicsAxialDamping: float
    """viscous damping of stretching: axial force per rate of axial strain [N s]"""
    physicsReferenceAxialStrain: float
    """axial strain at which the axial force is zero [1]"""
    physicsReferenceCurvature: float
    """curvature at which the bending moment is zero; positive for a left turn along the axis [1/m]"""
    physicsUseCouplingTerms: bool
    """true: all inertia terms of the axial motion act; false: the axial coordinate has its own mass only, and the element behaves like ObjectANCFCable2D"""
    physicsAddALEvariation: bool
    """true: the axial coordinate feels the change of strain and curvature energy that its motion brings about; false: this term is left out"""
    nodeNumbers: Sequence[NodeIndex | int]
    """node at axial position 0, node at axial position L (both with position and slope in the plane), and a generic node of second order whose coordinate is the axial displacement of the material [3]"""
    useReducedOrderIntegration: int
    """integration of the elastic forces along the axis: 0 with 5 Gauss points for stretching and 3 for bending, 1 with 4 and 2"""
    strainIsRelativeToReference: float
    """share of the strains of the reference configuration that are free of stress: 0 for an element that is straight and of length L without stress, 1 for a reference configuration without stress; values between serve for a transition [1]"""
    visualization: VObjectALEANCFCable2D | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        physicsLength: float = 0.0,
        physicsMassPerLength: float = 0.0,
        physicsMovingMassFactor: float = 1.0,
        physicsBendingStiffness: float = 0.0,
        physicsAxialStiffness: float = 0.0,
        physicsBendingDamping: float = 0.0,
        physicsAxialDamping: float = 0.0,
        physicsReferenceAxialStrain: float = 0.0,
        physicsReferenceCurvature: float = 0.0,
        physicsUseCouplingTerms: bool = True,
        physicsAddALEvariation: bool = True,
        nodeNumbers: Sequence[NodeIndex | int] = [-1, -1, -1],
        useReducedOrderIntegration: int = 0,
        strainIsRelativeToReference: float = 0.0,
        visualization: VObjectALEANCFCable2D | dict[str, Any] = ...,
    ) -> None: ...

ALECable2D = ObjectALEANCFCable2D
VALECable2D = VObjectALEANCFCable2D

class VObjectANCFBeam:
    """Visualization of ObjectANCFBeam."""

    show: bool
    """False: the item is not drawn"""
    sectionGeometry: BeamSectionGeometry
    """outline of the cross section for drawing and contact, as a ``BeamSectionGeometry``"""
    color: ArrayLike
    """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    def __init__(
        self,
        show: bool = True,
        sectionGeometry: BeamSectionGeometry = ...,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectANCFBeam(_Item):
    """spatial beam with shear and cross section deformation, on two nodes with position and two slopes"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    nodeNumbers: Sequence[NodeIndex | int]
    """node at the negative and node at the positive end of the axis, each with position and the slopes of the cross section [2]"""
    physicsLength: float
    """length of the element in its undeformed state; must be positive [m]"""
    sectionData: BeamSection
    """cross section with inertia, stiffness and damping matrices, as a ``BeamSection``"""
    crossSectionPenaltyFactor: ArrayLike
    """factors of the stiffness against stretching of the cross section in y and z (times the axial stiffness) and against its distortion (times the sum of the shear stiffnesses) [3; 1]"""
    crossSectionDamping: ArrayLike
    """damping of the same deformations, as factors of the stiffness; 0 for none [3; s]"""
    visualization: VObjectANCFBeam | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        nodeNumbers: Sequence[NodeIndex | int] = [-1, -1],
        physicsLength: float = 0.0,
        sectionData: BeamSection = ...,
        crossSectionPenaltyFactor: ArrayLike = [1.0, 1.0, 1.0],
        crossSectionDamping: ArrayLike = [0.0, 0.0, 0.0],
        visualization: VObjectANCFBeam | dict[str, Any] = ...,
    ) -> None: ...

ANCFBeam = ObjectANCFBeam
VANCFBeam = VObjectANCFBeam

class VObjectANCFCable:
    """Visualization of ObjectANCFCable."""

    show: bool
    """False: the item is not drawn"""
    radius: float
    """radius of the cylinder that is drawn; 0 draws the axis only [m]"""
    color: ArrayLike
    """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    def __init__(
        self,
        show: bool = True,
        radius: float = 0.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectANCFCable(_Item):
    """spatial cable or thin beam without torsion and shear deformation, on two nodes with position and slope"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    physicsLength: float
    """length of the element in its undeformed state; must be positive [m]"""
    physicsMassPerLength: float
    """mass per undeformed length [kg/m]"""
    physicsBendingStiffness: float
    """bending stiffness: bending moment per curvature [N m^2]"""
    physicsAxialStiffness: float
    """axial stiffness: axial force per axial strain [N]"""
    physicsBendingDamping: float
    """viscous damping of bending: bending moment per rate of curvature [N m^2 s]"""
    physicsAxialDamping: float
    """viscous damping of stretching: axial force per rate of axial strain [N s]"""
    physicsReferenceAxialStrain: float
    """axial strain at which the axial force is zero [1]"""
    strainIsRelativeToReference: float
    """share of the strains of the reference configuration that are free of stress: 0 for an element that is straight and of length L without stress, 1 for a reference configuration without stress; values between serve for a transition [1]"""
    nodeNumbers: Sequence[NodeIndex | int]
    """node at axial position 0 and node at axial position L, both with position and one slope [2]"""
    useReducedOrderIntegration: int
    """integration of the elastic forces along the axis: 0 with 5 Gauss points for stretching and 3 for bending, 1 with 4 and 2"""
    visualization: VObjectANCFCable | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        physicsLength: float = 0.0,
        physicsMassPerLength: float = 0.0,
        physicsBendingStiffness: float = 0.0,
        physicsAxialStiffness: float = 0.0,
        physicsBendingDamping: float = 0.0,
        physicsAxialDamping: float = 0.0,
        physicsReferenceAxialStrain: float = 0.0,
        strainIsRelativeToReference: float = 0.0,
        nodeNumbers: Sequence[NodeIndex | int] = [-1, -1],
        useReducedOrderIntegration: int = 0,
        visualization: VObjectANCFCable | dict[str, Any] = ...,
    ) -> None: ...

Cable = ObjectANCFCable
VCable = VObjectANCFCable

class VObjectANCFCable2D:
    """Visualization of ObjectANCFCable2D."""

    show: bool
    """False: the item is not drawn"""
    drawHeight: float
    """height of the rectangle that is drawn; 0 draws the axis only [m]"""
    color: ArrayLike
    """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    def __init__(
        self,
        show: bool = True,
        drawHeight: float = 0.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectANCFCable2D(_Item):
    """planar cable or thin beam without shear deformation for large deformation, on two nodes with position and slope"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    physicsLength: float
    """length of the element in its undeformed state; must be positive [m]"""
    physicsMassPerLength: float
    """mass per undeformed length [kg/m]"""
    physicsBendingStiffness: float
    """bending stiffness: bending moment per curvature [N m^2]"""
    physicsAxialStiffness: float
    """axial stiffness: axial force per axial strain [N]"""
    physicsBendingDamping: float
    """viscous damping of bending: bending moment per rate of curvature [N m^2 s]"""
    physicsAxialDamping: float
    """viscous damping of stretching: axial force per rate of axial strain [N s]"""
    physicsReferenceAxialStrain: float
    """axial strain at which the axial force is zero [1]"""
    physicsReferenceCurvature: float
    """curvature at which the bending moment is zero; positive for a left turn along the axis [1/m]"""
    strainIsRelativeToReference: float
    """share of the strains of the reference configuration that are free of stress: 0 for an element that is straight and of length L without stress, 1 for a reference configuration without stress; values between serve for a transition [1]"""
    nodeNumbers: Sequence[NodeIndex | int]
    """node at axial position 0 and node at axial position L, both with position and slope in the plane [2]"""
    useReducedOrderIntegration: int
    """integration of the elastic forces along the axis: 0 with 5 Gauss points for stretching and 3 for bending; 1 with 4 and 2; 2 with 3 Lobatto points for stretching and 2 Gauss points for bending, with smoother axial forces but possibly modes without stiffness"""
    axialForceUserFunction: Callable[..., Any] | Literal[0]
    """function that gives the axial force in place of the linear law"""
    bendingMomentUserFunction: Callable[..., Any] | Literal[0]
    """function that gives the bending moment in place of the linear law"""
    visualization: VObjectANCFCable2D | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        physicsLength: float = 0.0,
        physicsMassPerLength: float = 0.0,
        physicsBendingStiffness: float = 0.0,
        physicsAxialStiffness: float = 0.0,
        physicsBendingDamping: float = 0.0,
        physicsAxialDamping: float = 0.0,
        physicsReferenceAxialStrain: float = 0.0,
        physicsReferenceCurvature: float = 0.0,
        strainIsRelativeToReference: float = 0.0,
        nodeNumbers: Sequence[NodeIndex | int] = [-1, -1],
        useReducedOrderIntegration: int = 0,
        axialForceUserFunction: Callable[..., Any] | Literal[0] = 0,
        bendingMomentUserFunction: Callable[..., Any] | Literal[0] = 0,
        visualization: VObjectANCFCable2D | dict[str, Any] = ...,
    ) -> None: ...

Cable2D = ObjectANCFCable2D
VCable2D = VObjectANCFCable2D

class VObjectANCFThinPlate:
    """Visualization of ObjectANCFThinPlate."""

    show: bool
    """False: the item is not drawn"""
    color: ArrayLike
    """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    def __init__(
        self,
        show: bool = True,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectANCFThinPlate(_Item):
    """thin plate without shear deformation, on four nodes with position and two slopes"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    physicsThickness: ArrayLike
    """thickness of the plate: one value, or one value per node that is interpolated; as many as there are strain and curvature matrices [n; m]"""
    physicsDensity: float
    """mass per volume [kg/m^3]"""
    physicsMassProportionalDamping: float
    """damping forces are this factor times mass matrix times velocity [1/s]"""
    physicsStrainCoefficients: Sequence[ArrayLike]
    """stiffness against the strains in the plane, integrated over the thickness; one matrix, or one per node [n x 3 x 3; N/m]"""
    physicsCurvatureCoefficients: Sequence[ArrayLike]
    """stiffness against curvatures and twist, integrated over the thickness; one matrix, or one per node [n x 3 x 3; Nm]"""
    strainIsRelativeToReference: float
    """share of the strains of the reference configuration that are free of stress: 0 for a plate that is flat without stress, 1 for a reference configuration without stress [1]"""
    slopesScalingX: ArrayLike
    """for each node the length that belongs to a unit slope in x, half the side length for a flat rectangle; negative: from the distances of the nodes [4; m]"""
    slopesScalingY: ArrayLike
    """for each node the length that belongs to a unit slope in y; negative: from the distances of the nodes [4; m]"""
    nodeNumbers: Sequence[NodeIndex | int]
    """four nodes with position and two slopes, at the local corners (-1, -1), (1, -1), (1, 1), (-1, 1) [4]"""
    useReducedOrderIntegration: int
    """0: highest number of integration points; larger values use fewer"""
    visualization: VObjectANCFThinPlate | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        physicsThickness: ArrayLike = [],
        physicsDensity: float = 0.0,
        physicsMassProportionalDamping: float = 0.0,
        physicsStrainCoefficients: Sequence[ArrayLike] = [],
        physicsCurvatureCoefficients: Sequence[ArrayLike] = [],
        strainIsRelativeToReference: float = 1.0,
        slopesScalingX: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
        slopesScalingY: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
        nodeNumbers: Sequence[NodeIndex | int] = [-1, -1, -1, -1],
        useReducedOrderIntegration: int = 0,
        visualization: VObjectANCFThinPlate | dict[str, Any] = ...,
    ) -> None: ...

class VObjectBeamGeometricallyExact:
    """Visualization of ObjectBeamGeometricallyExact."""

    show: bool
    """False: the item is not drawn"""
    sectionGeometry: BeamSectionGeometry
    """outline of the cross section for drawing and contact, as a ``BeamSectionGeometry``"""
    color: ArrayLike
    """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    def __init__(
        self,
        show: bool = True,
        sectionGeometry: BeamSectionGeometry = ...,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectBeamGeometricallyExact(_Item):
    """spatial geometrically exact beam with shear deformation, on two rigid body nodes"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    nodeNumbers: Sequence[NodeIndex | int]
    """node at the negative and node at the positive end of the axis, both with position and orientation [2]"""
    physicsLength: float
    """length of the element in its undeformed state; must be positive [m]"""
    sectionData: BeamSection
    """cross section with inertia, stiffness and damping matrices, as a ``BeamSection``"""
    visualization: VObjectBeamGeometricallyExact | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        nodeNumbers: Sequence[NodeIndex | int] = [-1, -1],
        physicsLength: float = 0.0,
        sectionData: BeamSection = ...,
        visualization: VObjectBeamGeometricallyExact | dict[str, Any] = ...,
    ) -> None: ...

Beam3D = ObjectBeamGeometricallyExact
VBeam3D = VObjectBeamGeometricallyExact

class VObjectBeamGeometricallyExact2D:
    """Visualization of ObjectBeamGeometricallyExact2D."""

    show: bool
    """False: the item is not drawn"""
    drawHeight: float
    """height of the rectangle that is drawn; 0 draws the axis only [m]"""
    color: ArrayLike
    """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    def __init__(
        self,
        show: bool = True,
        drawHeight: float = 0.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectBeamGeometricallyExact2D(_Item):
    """planar geometrically exact beam with shear deformation, on two or three rigid body nodes"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    nodeNumbers: Sequence[NodeIndex | int]
    """two or three nodes of rigid bodies in the plane, in the order in which they follow along the axis [n]"""
    physicsLength: float
    """length of the element in its undeformed state; must be positive [m]"""
    physicsMassPerLength: float
    """mass per undeformed length [kg/m]"""
    physicsCrossSectionInertia: float
    """mass moment of inertia of the cross section per length, against its rotation [kg m]"""
    physicsBendingStiffness: float
    """bending stiffness: bending moment per curvature [N m^2]"""
    physicsAxialStiffness: float
    """axial stiffness: axial force per axial strain [N]"""
    physicsShearStiffness: float
    """shear stiffness, including the shear correction factor [N]"""
    physicsBendingDamping: float
    """viscous damping of bending: bending moment per rate of curvature [N m^2 s]"""
    physicsAxialDamping: float
    """viscous damping of stretching: axial force per rate of axial strain [N s]"""
    physicsShearDamping: float
    """viscous damping of shear: shear force per rate of shear strain [N s]"""
    physicsReferenceCurvature: float
    """curvature at which the bending moment is zero [1/m]"""
    includeReferenceRotations: bool
    """true: the reference angles of the nodes are the angles of the cross sections, so that a curved reference configuration is free of stress; false: only rotations relative to the reference configuration count, and the cross sections are normal to the reference axis"""
    visualization: VObjectBeamGeometricallyExact2D | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        nodeNumbers: Sequence[NodeIndex | int] = [],
        physicsLength: float = 0.0,
        physicsMassPerLength: float = 0.0,
        physicsCrossSectionInertia: float = 0.0,
        physicsBendingStiffness: float = 0.0,
        physicsAxialStiffness: float = 0.0,
        physicsShearStiffness: float = 0.0,
        physicsBendingDamping: float = 0.0,
        physicsAxialDamping: float = 0.0,
        physicsShearDamping: float = 0.0,
        physicsReferenceCurvature: float = 0.0,
        includeReferenceRotations: bool = False,
        visualization: VObjectBeamGeometricallyExact2D | dict[str, Any] = ...,
    ) -> None: ...

Beam2D = ObjectBeamGeometricallyExact2D
VBeam2D = VObjectBeamGeometricallyExact2D

class VObjectConnectorCartesianSpringDamper:
    """Visualization of ObjectConnectorCartesianSpringDamper."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    color: ArrayLike
    """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectConnectorCartesianSpringDamper(_Item):
    """Three springs and dampers that act between two points in the directions of the global axes"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    markerNumbers: Sequence[MarkerIndex | int]
    """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    stiffness: ArrayLike
    """stiffness in global x, y and z direction [3; N/m]"""
    damping: ArrayLike
    """damping coefficient in global x, y and z direction [3; Ns/m]"""
    offset: ArrayLike
    """global position of marker m1 relative to marker m0 at which the springs carry no force [3; m]"""
    springForceUserFunction: Callable[..., Any] | Literal[0]
    """Python function that replaces the linear law of springs and dampers; called only while the connector is active"""
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    visualization: VObjectConnectorCartesianSpringDamper | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int] = [-1, -1],
        stiffness: ArrayLike = [0.0, 0.0, 0.0],
        damping: ArrayLike = [0.0, 0.0, 0.0],
        offset: ArrayLike = [0.0, 0.0, 0.0],
        springForceUserFunction: Callable[..., Any] | Literal[0] = 0,
        activeConnector: bool = True,
        visualization: VObjectConnectorCartesianSpringDamper | dict[str, Any] = ...,
    ) -> None: ...

CartesianSpringDamper = ObjectConnectorCartesianSpringDamper
VCartesianSpringDamper = VObjectConnectorCartesianSpringDamper

class VObjectConnectorCoordinateSpringDamper:
    """Visualization of ObjectConnectorCoordinateSpringDamper."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    color: ArrayLike
    """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectConnectorCoordinateSpringDamper(_Item):
    """A scalar spring and damper between two coordinates"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    markerNumbers: Sequence[MarkerIndex | int]
    """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    stiffness: float
    """stiffness; N/m for coordinates that are lengths, Nm/rad for angles [various]"""
    damping: float
    """damping coefficient; Ns/m for coordinates that are lengths, Nms/rad for angles [various]"""
    offset: float
    """difference of the coordinates at which the spring carries no force; unit of the coordinates [various]"""
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    springForceUserFunction: Callable[..., Any] | Literal[0]
    """Python function that replaces the law of spring and damper; called only while the connector is active"""
    visualization: VObjectConnectorCoordinateSpringDamper | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int] = [-1, -1],
        stiffness: float = 0.0,
        damping: float = 0.0,
        offset: float = 0.0,
        activeConnector: bool = True,
        springForceUserFunction: Callable[..., Any] | Literal[0] = 0,
        visualization: VObjectConnectorCoordinateSpringDamper | dict[str, Any] = ...,
    ) -> None: ...

CoordinateSpringDamper = ObjectConnectorCoordinateSpringDamper
VCoordinateSpringDamper = VObjectConnectorCoordinateSpringDamper

class VObjectConnectorCoordinateSpringDamperExt:
    """Visualization of ObjectConnectorCoordinateSpringDamperExt."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    color: ArrayLike
    """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectConnectorCoordinateSpringDamperExt(_Item):
    """A scalar spring and damper between two coordinates, with gear factors, friction and limit stops"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    markerNumbers: Sequence[MarkerIndex | int]
    """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    nodeNumber: NodeIndex | int
    """NodeGenericData with three data coordinates: friction state, last sticking position, limit stop state; needed for friction with ``frictionProportionalZone`` = 0 and for limit stops, else it may stay unset"""
    stiffness: float
    """stiffness; N/m if the weighted coordinates are lengths, Nm/rad if they are angles; other units of this item follow in the same way [various]"""
    damping: float
    """damping coefficient; Ns/m for lengths [various]"""
    offset: float
    """weighted difference of the coordinates at which the spring carries no force; m for lengths; may serve as the set value of a position control [various]"""
    velocityOffset: float
    """weighted difference of the velocities at which the damper carries no force; m/s for lengths; may serve as the set value of a velocity control [various]"""
    factor0: float
    """factor of the coordinate of marker m0, such as a gear ratio [1]"""
    factor1: float
    """factor of the coordinate of marker m1 [1]"""
    fDynamicFriction: float
    """friction force in sliding, N for lengths: friction coefficient times a constant normal force [various]"""
    fStaticFrictionOffset: float
    """what the friction force in sticking may exceed the dynamic one, N for lengths; sticking ends at the sum of both [various]"""
    stickingStiffness: float
    """stiffness of the bristles in sticking, N/m for lengths; must be positive for friction with ``frictionProportionalZone`` = 0 [various]"""
    stickingDamping: float
    """damping coefficient of the bristles in sticking, Ns/m for lengths [various]"""
    exponentialDecayStatic: float
    """speed by which the static offset falls to 1/e = 36.8 % of its value, m/s for lengths [various]"""
    fViscousFriction: float
    """growth of the friction force with the speed of sliding, Ns/m for lengths; may be negative [various]"""
    frictionProportionalZone: float
    """speed up to which friction is proportional to velocity, m/s for lengths; 0: bristle model with stick and slip, which needs the data node [various]"""
    limitStopsUpper: float
    """upper limit of the weighted difference of coordinates, m for lengths; the upper stop acts above it [various]"""
    limitStopsLower: float
    """lower limit of the weighted difference of coordinates, m for lengths; the lower stop acts below it [various]"""
    limitStopsStiffness: float
    """contact stiffness of the stops, N/m for lengths [various]"""
    limitStopsDamping: float
    """contact damping of the stops, Ns/m for lengths [various]"""
    useLimitStops: bool
    """True: limit stops are active, and the data node is needed"""
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    springForceUserFunction: Callable[..., Any] | Literal[0]
    """Python function that replaces spring, damper, friction and limit stops altogether; called only while the connector is active"""
    visualization: VObjectConnectorCoordinateSpringDamperExt | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int] = [-1, -1],
        nodeNumber: NodeIndex | int = -1,
        stiffness: float = 0.0,
        damping: float = 0.0,
        offset: float = 0.0,
        velocityOffset: float = 0.0,
        factor0: float = 1.0,
        factor1: float = 1.0,
        fDynamicFriction: float = 0.0,
        fStaticFrictionOffset: float = 0.0,
        stickingStiffness: float = 0.0,
        stickingDamping: float = 0.0,
        exponentialDecayStatic: float = 0.001,
        fViscousFriction: float = 0.0,
        frictionProportionalZone: float = 0.0,
        limitStopsUpper: float = 0.0,
        limitStopsLower: float = 0.0,
        limitStopsStiffness: float = 0.0,
        limitStopsDamping: float = 0.0,
        useLimitStops: bool = False,
        activeConnector: bool = True,
        springForceUserFunction: Callable[..., Any] | Literal[0] = 0,
        visualization: VObjectConnectorCoordinateSpringDamperExt | dict[str, Any] = ...,
    ) -> None: ...

CoordinateSpringDamperExt = ObjectConnectorCoordinateSpringDamperExt
VCoordinateSpringDamperExt = VObjectConnectorCoordinateSpringDamperExt

class VObjectConnectorGravity:
    """Visualization of ObjectConnectorGravity."""

    show: bool
    """True: the item is drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    color: ArrayLike
    """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    def __init__(
        self,
        show: bool = False,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectConnectorGravity(_Item):
    """Newtonian gravitation between two masses, for celestial bodies and satellites; the weight on earth is LoadMassProportional"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    markerNumbers: Sequence[MarkerIndex | int]
    """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    gravitationalConstant: float
    """constant of gravitation; a negative value means repulsion [m^3/(kg s^2)]"""
    mass0: float
    """mass that attracts at marker m0; not taken from the body [kg]"""
    mass1: float
    """mass that attracts at marker m1; not taken from the body [kg]"""
    minDistanceRegularization: float
    """distance below which the force is regularized; 0: no regularization, and coinciding markers are an error [m]"""
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    visualization: VObjectConnectorGravity | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int] = [-1, -1],
        gravitationalConstant: float = 6.6743e-11,
        mass0: float = 0.0,
        mass1: float = 0.0,
        minDistanceRegularization: float = 0.0,
        activeConnector: bool = True,
        visualization: VObjectConnectorGravity | dict[str, Any] = ...,
    ) -> None: ...

ConnectorGravity = ObjectConnectorGravity
VConnectorGravity = VObjectConnectorGravity

class VObjectConnectorHydraulicActuatorSimple:
    """Visualization of ObjectConnectorHydraulicActuatorSimple."""

    show: bool
    """False: the item is not drawn"""
    cylinderRadius: float
    """radius of the drawn cylinder [m]"""
    rodRadius: float
    """radius of the drawn rod [m]"""
    pistonRadius: float
    """radius of the drawn piston [m]"""
    pistonLength: float
    """length of the drawn piston [m]"""
    rodMountRadius: float
    """radius of the sphere drawn at the mount of the rod; 0: none [m]"""
    baseMountRadius: float
    """radius of the sphere drawn at the mount of the cylinder; 0: none [m]"""
    baseMountLength: float
    """length of the part drawn between the mount and the cylinder [m]"""
    colorCylinder: ArrayLike
    """red, green, blue and opacity of the cylinder; a negative red selects the default color of connectors [4; 1]"""
    colorPiston: ArrayLike
    """red, green, blue and opacity of piston and rod [4; 1]"""
    def __init__(
        self,
        show: bool = True,
        cylinderRadius: float = 0.05,
        rodRadius: float = 0.03,
        pistonRadius: float = 0.04,
        pistonLength: float = 0.001,
        rodMountRadius: float = 0.0,
        baseMountRadius: float = 0.0,
        baseMountLength: float = 0.0,
        colorCylinder: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
        colorPiston: ArrayLike = [0.8, 0.8, 0.8, 1.0],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectConnectorHydraulicActuatorSimple(_Item):
    """A double-acting hydraulic cylinder between two points, with the build-up of pressure in both chambers"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    markerNumbers: Sequence[MarkerIndex | int]
    """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    nodeNumbers: Sequence[NodeIndex | int]
    """list with one NodeGenericODE1 whose two coordinates are the chamber pressures (Pa); its reference coordinates must be zero [n]"""
    offsetLength: float
    """distance of the markers at stroke zero, the shortest length of the actuator [m]"""
    strokeLength: float
    """largest stroke; the markers are ``offsetLength`` plus ``strokeLength`` apart in the fully extended actuator [m]"""
    chamberCrossSection0: float
    """area of the piston in chamber 0, on the side of the piston head [m^2]"""
    chamberCrossSection1: float
    """area of the piston in chamber 1, on the side of the rod; usually smaller [m^2]"""
    hoseVolume0: float
    """volume of the hose of chamber 0; must be positive, as the stiffness of the oil would be unbounded at stroke zero [m^3]"""
    hoseVolume1: float
    """volume of the hose of chamber 1; must be positive, as the stiffness of the oil would be unbounded at full stroke [m^3]"""
    valveOpening0: float
    """opening of the valve of chamber 0, from -1 to 1: positive towards system pressure, negative towards tank pressure, 0 closed; changed during a simulation to control the actuator [1]"""
    valveOpening1: float
    """opening of the valve of chamber 1, with the same meaning [1]"""
    actuatorDamping: float
    """viscous damping against the stroke velocity [Ns/m]"""
    oilBulkModulus: float
    """bulk modulus of the oil [Pa]"""
    cylinderBulkModulus: float
    """bulk modulus that stands for the compliance of the cylinder; 0: rigid cylinder [Pa]"""
    hoseBulkModulus: float
    """bulk modulus that stands for the compliance of the hoses; 0: rigid hoses [Pa]"""
    nominalFlow: float
    """flow through the fully open valve per square root of the pressure difference [m^3/(s Pa^(1/2))]"""
    systemPressure: float
    """pressure of the supply [Pa]"""
    tankPressure: float
    """pressure of the tank [Pa]"""
    useChamberVolumeChange: bool
    """True: volumes and stiffness of the oil change with the stroke; False: hose volumes and ``oilBulkModulus`` alone"""
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    visualization: VObjectConnectorHydraulicActuatorSimple | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int] = [-1, -1],
        nodeNumbers: Sequence[NodeIndex | int] = [],
        offsetLength: float = 0.0,
        strokeLength: float = 0.0,
        chamberCrossSection0: float = 0.0,
        chamberCrossSection1: float = 0.0,
        hoseVolume0: float = 0.0,
        hoseVolume1: float = 0.0,
        valveOpening0: float = 0.0,
        valveOpening1: float = 0.0,
        actuatorDamping: float = 0.0,
        oilBulkModulus: float = 0.0,
        cylinderBulkModulus: float = 0.0,
        hoseBulkModulus: float = 0.0,
        nominalFlow: float = 0.0,
        systemPressure: float = 0.0,
        tankPressure: float = 0.0,
        useChamberVolumeChange: bool = False,
        activeConnector: bool = True,
        visualization: VObjectConnectorHydraulicActuatorSimple | dict[str, Any] = ...,
    ) -> None: ...

HydraulicActuatorSimple = ObjectConnectorHydraulicActuatorSimple
VHydraulicActuatorSimple = VObjectConnectorHydraulicActuatorSimple

class VObjectConnectorLinearSpringDamper:
    """Visualization of ObjectConnectorLinearSpringDamper."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    drawAsCylinder: bool
    """True: drawn as a cylinder, which suits an actuator; False: drawn as a spring"""
    color: ArrayLike
    """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        drawAsCylinder: bool = False,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectConnectorLinearSpringDamper(_Item):
    """A spring and damper along an axis that is fixed to the first marker, as in a prismatic joint"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    markerNumbers: Sequence[MarkerIndex | int]
    """marker m0, to which the axis is fixed, and marker m1 [2]"""
    stiffness: float
    """stiffness along the axis [N/m]"""
    damping: float
    """damping coefficient along the axis [Ns/m]"""
    axisMarker0: ArrayLike
    """axis in the frame of marker m0, a unit vector; it turns with that marker [3; 1]"""
    offset: float
    """relative position along the axis at which the spring carries no force; may be changed during a simulation as the set value of a drive [m]"""
    velocityOffset: float
    """relative velocity along the axis at which the damper carries no force; set value of a velocity control [m/s]"""
    force: float
    """constant force added to that of spring and damper; positive: pulls marker m1 against the direction of the axis [N]"""
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    springForceUserFunction: Callable[..., Any] | Literal[0]
    """Python function that replaces the law of spring, damper and constant force; called only while the connector is active"""
    visualization: VObjectConnectorLinearSpringDamper | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int] = [-1, -1],
        stiffness: float = 0.0,
        damping: float = 0.0,
        axisMarker0: ArrayLike = [1.0, 0.0, 0.0],
        offset: float = 0.0,
        velocityOffset: float = 0.0,
        force: float = 0.0,
        activeConnector: bool = True,
        springForceUserFunction: Callable[..., Any] | Literal[0] = 0,
        visualization: VObjectConnectorLinearSpringDamper | dict[str, Any] = ...,
    ) -> None: ...

LinearSpringDamper = ObjectConnectorLinearSpringDamper
VLinearSpringDamper = VObjectConnectorLinearSpringDamper

class VObjectConnectorReevingSystemSprings:
    """Visualization of ObjectConnectorReevingSystemSprings."""

    show: bool
    """False: the item is not drawn"""
    ropeRadius: float
    """radius of the drawn rope [m]"""
    color: ArrayLike
    """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    def __init__(
        self,
        show: bool = True,
        ropeRadius: float = 0.001,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectConnectorReevingSystemSprings(_Item):
    """A massless elastic rope that runs without friction over sheaves and joins two end points"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    markerNumbers: Sequence[MarkerIndex | int]
    """rigid body or position markers along the rope: the first and the last are its ends, those between carry sheaves or deflection points; with ``hasCoordinateMarkers``, two coordinate markers follow [n]"""
    hasCoordinateMarkers: bool
    """True: the last two markers are coordinate markers that add rope at the start and at the end"""
    coordinateFactors: ArrayLike
    """factors of the two coordinate markers: 1 for lengths, a radius (m) for the angle of a winch [2; various]"""
    stiffnessPerLength: float
    """axial stiffness of the rope, modulus times cross section; divided by the length it is the stiffness of the rope [N]"""
    dampingPerLength: float
    """axial damping of the rope; divided by the length it is the damping coefficient of the rope [Ns]"""
    dampingTorsional: float
    """damping of the relative rotation of neighbouring sheaves about the rope; experimental [Nms]"""
    dampingShear: float
    """damping of the relative motion of neighbouring sheaves across the rope; experimental [Ns]"""
    regularizationForce: float
    """positive: largest compressive force, approached smoothly; negative: the rope carries compression like a spring [N]"""
    referenceLength: float
    """length of the rope without force [m]"""
    sheavesAxes: Sequence[ArrayLike]
    """axis of every sheave in the frame of its marker; the sign chooses the side at which the rope runs; first and last are ignored [n x 3; 1]"""
    sheavesRadii: ArrayLike
    """radius of every sheave; first and last must be zero, 0 between means a deflection point [n; m]"""
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    visualization: VObjectConnectorReevingSystemSprings | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int] = [-1, -1],
        hasCoordinateMarkers: bool = False,
        coordinateFactors: ArrayLike = [1.0, 1.0],
        stiffnessPerLength: float = 0.0,
        dampingPerLength: float = 0.0,
        dampingTorsional: float = 0.0,
        dampingShear: float = 0.0,
        regularizationForce: float = 0.1,
        referenceLength: float = 0.0,
        sheavesAxes: Sequence[ArrayLike] = [],
        sheavesRadii: ArrayLike = [],
        activeConnector: bool = True,
        visualization: VObjectConnectorReevingSystemSprings | dict[str, Any] = ...,
    ) -> None: ...

ReevingSystemSprings = ObjectConnectorReevingSystemSprings
VReevingSystemSprings = VObjectConnectorReevingSystemSprings

class VObjectConnectorRigidBodySpringDamper:
    """Visualization of ObjectConnectorRigidBodySpringDamper."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    color: ArrayLike
    """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectConnectorRigidBodySpringDamper(_Item):
    """A spring and damper with six components, against relative translation and rotation of two rigid body markers"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    markerNumbers: Sequence[MarkerIndex | int]
    """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    nodeNumber: NodeIndex | int
    """NodeGenericData whose data coordinates the user functions may use, for instance for friction or contact states; not set: no data coordinates"""
    stiffness: ArrayLike
    """stiffness matrix in frame J0 for three translations (N/m) and three rotations (Nm/rad), coupling terms included; need not be symmetric [6 x 6; various]"""
    damping: ArrayLike
    """damping matrix in frame J0 for the three components of velocity (Ns/m) and of angular velocity (Nms/rad) [6 x 6; various]"""
    rotationMarker0: ArrayLike
    """rotation matrix from joint frame J0 to the frame of marker m0; turns the axes in which stiffness, damping and offset are given [3 x 3; 1]"""
    rotationMarker1: ArrayLike
    """rotation matrix from joint frame J1 to the frame of marker m1; without rotation offset, the springs carry no torque if J0 and J1 are parallel [3 x 3; 1]"""
    offset: ArrayLike
    """relative position (m) and Tait-Bryan angles (rad) in frame J0 at which the springs carry no force [6; various]"""
    intrinsicFormulation: bool
    """True: relative motion is measured by the logarithm on SE(3), and forces act in the frame half-way between the markers, such that exchanging the markers changes nothing; False: all is measured in frame J0"""
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    springForceTorqueUserFunction: Callable[..., Any] | Literal[0]
    """Python function that replaces the linear law of force and torque; called only while the connector is active"""
    postNewtonStepUserFunction: Callable[..., Any] | Literal[0]
    """Python function that updates the data coordinates of ``nodeNumber`` after each Newton iteration has converged; called only with a data node and while the connector is active"""
    visualization: VObjectConnectorRigidBodySpringDamper | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int] = [-1, -1],
        nodeNumber: NodeIndex | int = -1,
        stiffness: ArrayLike = [[0.0, 0.0, 0.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.0, 0.0, 0.0]],
        damping: ArrayLike = [[0.0, 0.0, 0.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.0, 0.0, 0.0]],
        rotationMarker0: ArrayLike = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        rotationMarker1: ArrayLike = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        offset: ArrayLike = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        intrinsicFormulation: bool = False,
        activeConnector: bool = True,
        springForceTorqueUserFunction: Callable[..., Any] | Literal[0] = 0,
        postNewtonStepUserFunction: Callable[..., Any] | Literal[0] = 0,
        visualization: VObjectConnectorRigidBodySpringDamper | dict[str, Any] = ...,
    ) -> None: ...

RigidBodySpringDamper = ObjectConnectorRigidBodySpringDamper
VRigidBodySpringDamper = VObjectConnectorRigidBodySpringDamper

class VObjectConnectorRollingDiscPenalty:
    """Visualization of ObjectConnectorRollingDiscPenalty."""

    show: bool
    """False: the item is not drawn"""
    discWidth: float
    """width of the drawn disc [m]"""
    color: ArrayLike
    """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    def __init__(
        self,
        show: bool = True,
        discWidth: float = 0.1,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectConnectorRollingDiscPenalty(_Item):
    """A disc that rolls or slides with friction on a plane, with elastic contact instead of constraints"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    markerNumbers: Sequence[MarkerIndex | int]
    """marker m0 on the plane and marker m1 at the center of the disc [2]"""
    nodeNumber: NodeIndex | int
    """NodeGenericData with three data coordinates: slip velocity in lateral and in forward direction, and gap, of the last update"""
    discRadius: float
    """radius of the disc [m]"""
    discAxis: ArrayLike
    """axis of the disc in the frame of marker m1, a unit vector; must not become parallel to the normal of the plane [3; 1]"""
    planeNormal: ArrayLike
    """normal of the plane in the frame of marker m0, a unit vector; the plane contains the position of marker m0 [3; 1]"""
    dryFrictionAngle: float
    """rotation of the directions of ``dryFriction`` in the plane, such as the angle of the rollers of a Mecanum wheel [rad]"""
    contactStiffness: float
    """stiffness normal to the plane [N/m]"""
    contactDamping: float
    """damping coefficient normal to the plane [Ns/m]"""
    dryFriction: ArrayLike
    """friction coefficients in lateral and in forward direction [2; 1]"""
    dryFrictionProportionalZone: float
    """slip speed up to which friction is regularized; 0: none [m/s]"""
    viscousFriction: ArrayLike
    """growth of the friction coefficients with the slip speed, in lateral and in forward direction [2; s/m]"""
    rollingFrictionViscous: float
    """rolling resistance per normal force and per speed of the disc center along the plane; only for a disc with its axis parallel to the plane [s/m]"""
    useLinearProportionalZone: bool
    """True: friction grows linearly in the proportional zone, with a constant tangent in sticking; False: quadratically, with a smooth end of the zone"""
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    visualization: VObjectConnectorRollingDiscPenalty | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int] = [-1, -1],
        nodeNumber: NodeIndex | int = -1,
        discRadius: float = 0.0,
        discAxis: ArrayLike = [1.0, 0.0, 0.0],
        planeNormal: ArrayLike = [0.0, 0.0, 1.0],
        dryFrictionAngle: float = 0.0,
        contactStiffness: float = 0.0,
        contactDamping: float = 0.0,
        dryFriction: ArrayLike = [0.0, 0.0],
        dryFrictionProportionalZone: float = 0.0,
        viscousFriction: ArrayLike = [0.0, 0.0],
        rollingFrictionViscous: float = 0.0,
        useLinearProportionalZone: bool = False,
        activeConnector: bool = True,
        visualization: VObjectConnectorRollingDiscPenalty | dict[str, Any] = ...,
    ) -> None: ...

RollingDiscPenalty = ObjectConnectorRollingDiscPenalty
VRollingDiscPenalty = VObjectConnectorRollingDiscPenalty

class VObjectConnectorSpringDamper:
    """Visualization of ObjectConnectorSpringDamper."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    color: ArrayLike
    """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectConnectorSpringDamper(_Item):
    """A spring and a damper that act along the line between two points"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    markerNumbers: Sequence[MarkerIndex | int]
    """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    referenceLength: float
    """length at which the spring itself carries no force [m]"""
    stiffness: float
    """stiffness of the spring, force per elongation [N/m]"""
    damping: float
    """coefficient of the damper, force per rate of length [Ns/m]"""
    force: float
    """constant force added to that of spring and damper; positive: tension, the markers are pulled together; may be changed during a simulation to drive an actuator [N]"""
    velocityOffset: float
    """rate of length at which the damper carries no force, for instance the rate at which ``referenceLength`` is changed [m/s]"""
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    springForceUserFunction: Callable[..., Any] | Literal[0]
    """Python function that replaces the law of spring, damper and constant force; called only while the connector is active"""
    visualization: VObjectConnectorSpringDamper | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int] = [-1, -1],
        referenceLength: float = 0.0,
        stiffness: float = 0.0,
        damping: float = 0.0,
        force: float = 0.0,
        velocityOffset: float = 0.0,
        activeConnector: bool = True,
        springForceUserFunction: Callable[..., Any] | Literal[0] = 0,
        visualization: VObjectConnectorSpringDamper | dict[str, Any] = ...,
    ) -> None: ...

SpringDamper = ObjectConnectorSpringDamper
VSpringDamper = VObjectConnectorSpringDamper

class VObjectConnectorTorsionalSpringDamper:
    """Visualization of ObjectConnectorTorsionalSpringDamper."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    color: ArrayLike
    """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectConnectorTorsionalSpringDamper(_Item):
    """A torsional spring and damper about the z axis of a joint frame"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    markerNumbers: Sequence[MarkerIndex | int]
    """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    nodeNumber: NodeIndex | int
    """NodeGenericData with one data coordinate that holds the angle of the last step and makes the measured angle continuous beyond half a turn; not set: the angle jumps"""
    stiffness: float
    """torsional stiffness [Nm/rad]"""
    damping: float
    """torsional damping coefficient [Nms/rad]"""
    rotationMarker0: ArrayLike
    """rotation matrix from joint frame J0 to the frame of marker m0; its third column is the axis of rotation [3 x 3; 1]"""
    rotationMarker1: ArrayLike
    """rotation matrix from joint frame J1 to the frame of marker m1; the angle is zero if J0 and J1 are parallel [3 x 3; 1]"""
    offset: float
    """angle at which the spring carries no torque; may be changed during a simulation as the set value of a drive [rad]"""
    velocityOffset: float
    """relative angular velocity at which the damper carries no torque; set value of a velocity control [rad/s]"""
    torque: float
    """constant torque added to that of spring and damper; positive: acts against the rotation of marker m1 about the axis [Nm]"""
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    springTorqueUserFunction: Callable[..., Any] | Literal[0]
    """Python function that replaces the law of spring, damper and constant torque; called only while the connector is active"""
    visualization: VObjectConnectorTorsionalSpringDamper | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int] = [-1, -1],
        nodeNumber: NodeIndex | int = -1,
        stiffness: float = 0.0,
        damping: float = 0.0,
        rotationMarker0: ArrayLike = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        rotationMarker1: ArrayLike = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        offset: float = 0.0,
        velocityOffset: float = 0.0,
        torque: float = 0.0,
        activeConnector: bool = True,
        springTorqueUserFunction: Callable[..., Any] | Literal[0] = 0,
        visualization: VObjectConnectorTorsionalSpringDamper | dict[str, Any] = ...,
    ) -> None: ...

TorsionalSpringDamper = ObjectConnectorTorsionalSpringDamper
VTorsionalSpringDamper = VObjectConnectorTorsionalSpringDamper

class VObjectConnectorCoordinate:
    """Visualization of ObjectConnectorCoordinate."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    color: ArrayLike
    """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectConnectorCoordinate(_Item):
    """Couples two coordinates, or fixes one of them to a value or to a function of time"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    markerNumbers: Sequence[MarkerIndex | int]
    """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    offset: float
    """prescribed value of ``factorValue1`` times the second coordinate minus the first one; with ``velocityLevel`` the same for the velocity coordinates [various]"""
    factorValue1: float
    """factor of the coordinate of marker m1, such as a gear ratio [1]"""
    velocityLevel: bool
    """True: the constraint is set for the velocity coordinates, and ``offset`` is a velocity; ``offsetUserFunction`` is then ignored; only for coordinates of second order equations"""
    offsetUserFunction: Callable[..., Any] | Literal[0]
    """Python function that replaces ``offset`` by a function of time, on position level"""
    offsetUserFunction_t: Callable[..., Any] | Literal[0]
    """Python function, the time derivative of ``offsetUserFunction``; used wherever the constraint is evaluated on velocity level"""
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    visualization: VObjectConnectorCoordinate | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int] = [-1, -1],
        offset: float = 0.0,
        factorValue1: float = 1.0,
        velocityLevel: bool = False,
        offsetUserFunction: Callable[..., Any] | Literal[0] = 0,
        offsetUserFunction_t: Callable[..., Any] | Literal[0] = 0,
        activeConnector: bool = True,
        visualization: VObjectConnectorCoordinate | dict[str, Any] = ...,
    ) -> None: ...

CoordinateConstraint = ObjectConnectorCoordinate
VCoordinateConstraint = VObjectConnectorCoordinate

class VObjectConnectorCoordinateVector:
    """Visualization of ObjectConnectorCoordinateVector."""

    show: bool
    """False: the item is not drawn"""
    color: ArrayLike
    """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    def __init__(
        self,
        show: bool = True,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectConnectorCoordinateVector(_Item):
    """Couples the coordinate vectors of two markers by linear and quadratic equations, or by a user function"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    markerNumbers: Sequence[MarkerIndex | int]
    """two markers on coordinate vectors; the equations are those of m1 minus those of m0 [2]"""
    scalingMarker0: ArrayLike
    """matrix of linear factors of the coordinates of marker m0, one row per equation and one column per coordinate; empty: no such term [n x m; various]"""
    scalingMarker1: ArrayLike
    """matrix of linear factors of the coordinates of marker m1; empty: no such term [n x m; various]"""
    quadraticTermMarker0: ArrayLike
    """matrix of factors of the squared coordinates of marker m0; empty: no such term [n x m; various]"""
    quadraticTermMarker1: ArrayLike
    """matrix of factors of the squared coordinates of marker m1; empty: no such term [n x m; various]"""
    offset: ArrayLike
    """vector that is subtracted from the equations, one component per equation; empty: zero; not used with a user function [n; various]"""
    velocityLevel: bool
    """True: the equations are set for the velocity coordinates, and ``offset`` is a velocity; only for coordinates of second order equations"""
    constraintUserFunction: Callable[..., Any] | Literal[0]
    """Python function that replaces all equations; ``jacobianUserFunction`` is needed as well, and ``scalingMarker0`` tells the number of equations by its number of rows, as in ``np.zeros((2, 1))``"""
    jacobianUserFunction: Callable[..., Any] | Literal[0]
    """Python function, the derivative of ``constraintUserFunction`` with respect to the coordinates (or velocity coordinates with ``velocityLevel``)"""
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    visualization: VObjectConnectorCoordinateVector | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int] = [-1, -1],
        scalingMarker0: ArrayLike = [],
        scalingMarker1: ArrayLike = [],
        quadraticTermMarker0: ArrayLike = [],
        quadraticTermMarker1: ArrayLike = [],
        offset: ArrayLike = [],
        velocityLevel: bool = False,
        constraintUserFunction: Callable[..., Any] | Literal[0] = 0,
        jacobianUserFunction: Callable[..., Any] | Literal[0] = 0,
        activeConnector: bool = True,
        visualization: VObjectConnectorCoordinateVector | dict[str, Any] = ...,
    ) -> None: ...

CoordinateVectorConstraint = ObjectConnectorCoordinateVector
VCoordinateVectorConstraint = VObjectConnectorCoordinateVector

class VObjectConnectorDistance:
    """Visualization of ObjectConnectorDistance."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    color: ArrayLike
    """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectConnectorDistance(_Item):
    """Keeps the distance of two points constant, like a massless rigid rod between two ball joints"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    markerNumbers: Sequence[MarkerIndex | int]
    """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    distance: float
    """prescribed distance of the two markers; must be positive, and should fit the initial positions [m]"""
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    visualization: VObjectConnectorDistance | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int] = [-1, -1],
        distance: float = 0.0,
        activeConnector: bool = True,
        visualization: VObjectConnectorDistance | dict[str, Any] = ...,
    ) -> None: ...

DistanceConstraint = ObjectConnectorDistance
VDistanceConstraint = VObjectConnectorDistance

class VObjectContactCircleCable2D:
    """Visualization of ObjectContactCircleCable2D."""

    show: bool
    """False: the item is not drawn"""
    showContactCircle: bool
    """True: the circle is drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    color: ArrayLike
    """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    def __init__(
        self,
        show: bool = True,
        showContactCircle: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectContactCircleCable2D(_Item):
    """Contact without friction of a planar cable element with a circle"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    markerNumbers: Sequence[MarkerIndex | int]
    """marker m0 at the center of the circle and marker m1, the shape of the cable [2]"""
    nodeNumber: NodeIndex | int
    """NodeGenericData with one data coordinate per segment, the gap of the last update"""
    numberOfContactSegments: int
    """number of segments; must be that of the shape marker"""
    contactStiffness: float
    """contact stiffness per segment [N/m]"""
    contactDamping: float
    """contact damping coefficient per segment [Ns/m]"""
    circleRadius: float
    """radius of the circle [m]"""
    offset: float
    """distance that is added to the radius of the circle, such as half the thickness of the cable [m]"""
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    visualization: VObjectContactCircleCable2D | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int] = [-1, -1],
        nodeNumber: NodeIndex | int = -1,
        numberOfContactSegments: int = 3,
        contactStiffness: float = 0.0,
        contactDamping: float = 0.0,
        circleRadius: float = 0.0,
        offset: float = 0.0,
        activeConnector: bool = True,
        visualization: VObjectContactCircleCable2D | dict[str, Any] = ...,
    ) -> None: ...

class VObjectContactConvexRoll:
    """Visualization of ObjectContactConvexRoll."""

    show: bool
    """False: the item is not drawn"""
    color: ArrayLike
    """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    def __init__(
        self,
        show: bool = True,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectContactConvexRoll(_Item):
    """Contact of a convex roll, a body of revolution with a polynomial profile, with the ground plane"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    markerNumbers: Sequence[MarkerIndex | int]
    """marker m0 on the ground, which may translate but not rotate, and marker m1 at the center of the roll [2]"""
    nodeNumber: NodeIndex | int
    """NodeGenericData with three data coordinates: slip velocity in two directions, and gap, of the last update"""
    contactStiffness: float
    """stiffness normal to the plane [N/m]"""
    contactDamping: float
    """damping coefficient normal to the plane [Ns/m]"""
    dynamicFriction: float
    """coefficient of friction in sliding [1]"""
    staticFrictionOffset: float
    """what the coefficient of static friction exceeds the dynamic one [1]"""
    viscousFriction: float
    """growth of the friction coefficient with the slip speed [s/m]"""
    exponentialDecayStatic: float
    """slip speed by which the static offset falls to 1/e [m/s]"""
    frictionProportionalZone: float
    """slip speed up to which friction is proportional to it [m/s]"""
    rollLength: float
    """length of the roll, symmetric about its center [m]"""
    coefficientsHull: ArrayLike
    """coefficients of the polynomial radius over the position x on the axis, highest power first; the profile must be convex [n; various]"""
    rBoundingSphere: float
    """radius of spheres at both ends that exclude contact by a cheap test; follows from the profile [m]"""
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    visualization: VObjectContactConvexRoll | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int] = [-1, -1],
        nodeNumber: NodeIndex | int = -1,
        contactStiffness: float = 0.0,
        contactDamping: float = 0.0,
        dynamicFriction: float = 0.0,
        staticFrictionOffset: float = 0.0,
        viscousFriction: float = 0.0,
        exponentialDecayStatic: float = 0.001,
        frictionProportionalZone: float = 0.001,
        rollLength: float = 0.0,
        coefficientsHull: ArrayLike = [],
        rBoundingSphere: float = 0.0,
        activeConnector: bool = True,
        visualization: VObjectContactConvexRoll | dict[str, Any] = ...,
    ) -> None: ...

class VObjectContactCoordinate:
    """Visualization of ObjectContactCoordinate."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    color: ArrayLike
    """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectContactCoordinate(_Item):
    """Contact of two coordinates, a one-sided spring and damper"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    markerNumbers: Sequence[MarkerIndex | int]
    """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    nodeNumber: NodeIndex | int
    """NodeGenericData with one data coordinate, the gap of the last update; must not be positive if the simulation begins in contact"""
    contactStiffness: float
    """contact stiffness; N/m for coordinates that are lengths [various]"""
    contactDamping: float
    """contact damping coefficient; Ns/m for coordinates that are lengths [various]"""
    offset: float
    """difference of the coordinates at which contact begins; m for lengths [various]"""
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    visualization: VObjectContactCoordinate | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int] = [-1, -1],
        nodeNumber: NodeIndex | int = -1,
        contactStiffness: float = 0.0,
        contactDamping: float = 0.0,
        offset: float = 0.0,
        activeConnector: bool = True,
        visualization: VObjectContactCoordinate | dict[str, Any] = ...,
    ) -> None: ...

class VObjectContactCurveCircles:
    """Visualization of ObjectContactCurveCircles."""

    show: bool
    """False: the item is not drawn"""
    color: ArrayLike
    """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    def __init__(
        self,
        show: bool = True,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectContactCurveCircles(_Item):
    """Contact of a planar curve with circles, as of a cam with its followers"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    markerNumbers: Sequence[MarkerIndex | int]
    """rigid body marker that carries the curve, followed by one marker per circle [2]"""
    nodeNumber: NodeIndex | int
    """NodeGenericData with three data coordinates per segment: number of the circle in contact, gap, tangential velocity, of the last update"""
    circlesRadii: ArrayLike
    """radius of every circle, as many as circle markers [n; m]"""
    segmentsData: MatrixLike
    """one row per segment with the planar coordinates of its begin and end, [x0, y0, x1, y1], in the frame of the curve; the outer side lies to the right when going from begin to end [n x m; m]"""
    polynomialData: MatrixLike
    """one row per segment with slopes at its begin and end (1) and curvatures at its begin and end (1/m), in the frame of the segment; empty: straight segments [n x m; various]"""
    rotationMarker0: ArrayLike
    """rotation matrix from the frame of the curve, in whose x-y plane it lies, to the frame of the first marker [3 x 3; 1]"""
    dynamicFriction: float
    """coefficient of friction in sliding [1]"""
    frictionProportionalZone: float
    """slip speed up to which friction is proportional to it [m/s]"""
    contactStiffness: float
    """stiffness of the normal contact per length of segment [N/m^2]"""
    contactDamping: float
    """damping coefficient of the normal contact per length of segment [Ns/m^2]"""
    contactModel: int
    """0: force by penetration of the segment, robust but with jumps between segments; 1: force by the area of penetration, smooth in sliding"""
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    visualization: VObjectContactCurveCircles | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int] = [-1, -1],
        nodeNumber: NodeIndex | int = -1,
        circlesRadii: ArrayLike = [],
        segmentsData: MatrixLike = [],
        polynomialData: MatrixLike = [],
        rotationMarker0: ArrayLike = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        dynamicFriction: float = 0.0,
        frictionProportionalZone: float = 0.001,
        contactStiffness: float = 0.0,
        contactDamping: float = 0.0,
        contactModel: int = 0,
        activeConnector: bool = True,
        visualization: VObjectContactCurveCircles | dict[str, Any] = ...,
    ) -> None: ...

CamFollowerContactPlanar = ObjectContactCurveCircles
VCamFollowerContactPlanar = VObjectContactCurveCircles

class VObjectContactFrictionCircleCable2D:
    """Visualization of ObjectContactFrictionCircleCable2D."""

    show: bool
    """False: the item is not drawn"""
    showContactCircle: bool
    """True: the circle is drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    color: ArrayLike
    """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    def __init__(
        self,
        show: bool = True,
        showContactCircle: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectContactFrictionCircleCable2D(_Item):
    """Contact with friction of a planar cable element with a circle, such as of a belt on a pulley"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    markerNumbers: Sequence[MarkerIndex | int]
    """marker m0 at the center of the circle and marker m1, the shape of the cable [2]"""
    nodeNumber: NodeIndex | int
    """NodeGenericData with three data coordinates per segment: all gaps, then all friction states (-1 and 1 slip, 0 stick, -2 undefined), then all last sticking positions; begin for instance with 0.1, -2, 0 for no contact"""
    numberOfContactSegments: int
    """number of segments; must be that of the shape marker"""
    contactStiffness: float
    """contact stiffness per segment [N/m]"""
    contactDamping: float
    """contact damping coefficient per segment [Ns/m]"""
    frictionVelocityPenalty: float
    """tangential force per tangential velocity, per segment [Ns/m]"""
    frictionStiffness: float
    """tangential force per displacement from the last sticking position, per segment; 0: no sticking, friction by velocity only [N/m]"""
    frictionCoefficient: float
    """coefficient of dry friction, the bound of the tangential to the normal force [1]"""
    circleRadius: float
    """radius of the circle [m]"""
    useSegmentNormals: bool
    """True: normal and tangent are those of the segment, for segments that are long against the circle; False: those of the circle at the points of the segment, for short segments"""
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    visualization: VObjectContactFrictionCircleCable2D | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int] = [-1, -1],
        nodeNumber: NodeIndex | int = -1,
        numberOfContactSegments: int = 3,
        contactStiffness: float = 0.0,
        contactDamping: float = 0.0,
        frictionVelocityPenalty: float = 0.0,
        frictionStiffness: float = 0.0,
        frictionCoefficient: float = 0.0,
        circleRadius: float = 0.0,
        useSegmentNormals: bool = True,
        activeConnector: bool = True,
        visualization: VObjectContactFrictionCircleCable2D | dict[str, Any] = ...,
    ) -> None: ...

class VObjectContactSphereSphere:
    """Visualization of ObjectContactSphereSphere."""

    show: bool
    """True: the item is drawn"""
    color: ArrayLike
    """red, green, blue and opacity of the drawn shapes [4; 1]"""
    def __init__(
        self,
        show: bool = False,
        color: ArrayLike = [0.7, 0.7, 0.7, 1.0],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectContactSphereSphere(_Item):
    """Contact of two spheres, or of a sphere inside a hollow sphere, with friction, restitution and adhesion"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    markerNumbers: Sequence[MarkerIndex | int]
    """markers at the centers of the two spheres [2]"""
    nodeNumber: NodeIndex | int
    """NodeGenericData with four data coordinates of the last update: gap, tangential speed, impact velocity, plastic overlap; initial gap positive: no contact"""
    spheresRadii: ArrayLike
    """radii of the spheres at marker m0 and marker m1; must be positive [2; m]"""
    isHollowSphere1: bool
    """True: the sphere of marker m1 is hollow, and the other one touches it from inside"""
    dynamicFriction: float
    """coefficient of dry friction; 0: no friction, and no torques [1]"""
    frictionProportionalZone: float
    """tangential speed up to which friction is proportional to it [m/s]"""
    contactStiffness: float
    """stiffness of the normal contact; n is ``contactStiffnessExponent`` [N/m^n]"""
    contactDamping: float
    """linear damping coefficient in normal direction, added in all impact models; leave it 0 for a restitution coefficient below 1 [Ns/m]"""
    contactStiffnessExponent: float
    """exponent n of the penetration in the normal force; 1.5 for Hertzian contact [1]"""
    constantPullOffForce: float
    """constant adhesive force in contact, for ``impactModel`` 0 [N]"""
    contactPlasticityRatio: float
    """one minus the ratio of the stiffness at first loading to that at unloading, from 0 to below 1; 0: no plastic overlap [1]"""
    adhesionCoefficient: float
    """coefficient of the adhesive force that grows with penetration (N/m for an exponent of 1); 0: none [various]"""
    adhesionExponent: float
    """exponent of the penetration in the adhesive force [1]"""
    restitutionCoefficient: float
    """ratio of normal speeds after and before an impact, for ``impactModel`` 1 and 2; positive, 1: elastic [1]"""
    minimumImpactVelocity: float
    """lower bound of the impact velocity in the restitution law; larger values damp slow and lasting contacts more [m/s]"""
    impactModel: int
    """0: elastic contact with linear damping; 1: Hunt-Crossley, for restitution near 1; 2: Carvalho-Martins and Gonthier, for all restitution coefficients"""
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    visualization: VObjectContactSphereSphere | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int] = [-1, -1],
        nodeNumber: NodeIndex | int = -1,
        spheresRadii: ArrayLike = [-1.0, -1.0],
        isHollowSphere1: bool = False,
        dynamicFriction: float = 0.0,
        frictionProportionalZone: float = 0.001,
        contactStiffness: float = 0.0,
        contactDamping: float = 0.0,
        contactStiffnessExponent: float = 1.0,
        constantPullOffForce: float = 0.0,
        contactPlasticityRatio: float = 0.0,
        adhesionCoefficient: float = 0.0,
        adhesionExponent: float = 1.0,
        restitutionCoefficient: float = 1.0,
        minimumImpactVelocity: float = 0.0,
        impactModel: int = 0,
        activeConnector: bool = True,
        visualization: VObjectContactSphereSphere | dict[str, Any] = ...,
    ) -> None: ...

class VObjectContactSphereTorus:
    """Visualization of ObjectContactSphereTorus."""

    show: bool
    """True: the item is drawn"""
    color: ArrayLike
    """red, green, blue and opacity of the drawn shapes [4; 1]"""
    def __init__(
        self,
        show: bool = False,
        color: ArrayLike = [0.7, 0.7, 0.7, 1.0],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectContactSphereTorus(_Item):
    """Contact of a sphere inside the tube of a torus, as of a ball in the groove of a bearing"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    markerNumbers: Sequence[MarkerIndex | int]
    """marker m0 at the center of the sphere and marker m1 at the center of the torus [2]"""
    nodeNumber: NodeIndex | int
    """NodeGenericData with four data coordinates of the last update: gap, tangential speed, impact velocity, and one that is not used"""
    radiusSphere: float
    """radius of the sphere at marker m0 [m]"""
    torusMajorRadius: float
    """radius of the center line of the torus [m]"""
    torusMinorRadius: float
    """radius of the tube, larger than that of the sphere [m]"""
    torusAxis: ArrayLike
    """axis of the torus in the frame of marker m1, a unit vector [3; 1]"""
    dynamicFriction: float
    """coefficient of dry friction; 0: no friction, and no torques [1]"""
    frictionProportionalZone: float
    """tangential speed up to which friction is proportional to it [m/s]"""
    contactStiffness: float
    """stiffness of the normal contact; n is ``contactStiffnessExponent`` [N/m^n]"""
    contactDamping: float
    """linear damping coefficient in normal direction, added in all impact models; leave it 0 for a restitution coefficient below 1 [Ns/m]"""
    contactStiffnessExponent: float
    """exponent n of the penetration in the normal force; 1.5 for Hertzian contact [1]"""
    restitutionCoefficient: float
    """ratio of normal speeds after and before an impact, for ``impactModel`` 1 and 2; positive, 1: elastic [1]"""
    minimumImpactVelocity: float
    """lower bound of the impact velocity in the restitution law; larger values damp slow and lasting contacts more [m/s]"""
    impactModel: int
    """0: elastic contact with linear damping; 1: Hunt-Crossley, for restitution near 1; 2: Carvalho-Martins and Gonthier, for all restitution coefficients"""
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    visualization: VObjectContactSphereTorus | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int] = [-1, -1],
        nodeNumber: NodeIndex | int = -1,
        radiusSphere: float = 0.0,
        torusMajorRadius: float = 0.0,
        torusMinorRadius: float = 0.0,
        torusAxis: ArrayLike = [0.0, 0.0, 0.0],
        dynamicFriction: float = 0.0,
        frictionProportionalZone: float = 0.001,
        contactStiffness: float = 0.0,
        contactDamping: float = 0.0,
        contactStiffnessExponent: float = 1.0,
        restitutionCoefficient: float = 1.0,
        minimumImpactVelocity: float = 0.0,
        impactModel: int = 0,
        activeConnector: bool = True,
        visualization: VObjectContactSphereTorus | dict[str, Any] = ...,
    ) -> None: ...

class VObjectContactSphereTriangle:
    """Visualization of ObjectContactSphereTriangle."""

    show: bool
    """True: the item is drawn"""
    color: ArrayLike
    """red, green, blue and opacity of the drawn shapes [4; 1]"""
    def __init__(
        self,
        show: bool = False,
        color: ArrayLike = [0.7, 0.7, 0.7, 1.0],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectContactSphereTriangle(_Item):
    """Contact of a sphere with a triangle, its face and chosen edges"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    markerNumbers: Sequence[MarkerIndex | int]
    """marker m0 at the center of the sphere and marker m1 on the body that carries the triangle [2]"""
    nodeNumber: NodeIndex | int
    """NodeGenericData with four data coordinates of the last update: gap, tangential speed, impact velocity, and one that is not used"""
    radiusSphere: float
    """radius of the sphere at marker m0 [m]"""
    trianglePoints: Sequence[ArrayLike]
    """three points in the frame of marker m1 [n x 3; m]"""
    includeEdges: int
    """sum of 1, 2 and 4 for contact with edge 0 (points 0 and 1), edge 1 (points 1 and 2) and edge 2 (points 2 and 0); 7: all edges; edges between triangles of a smooth surface are left out"""
    dynamicFriction: float
    """coefficient of dry friction; 0: no friction, and no torques [1]"""
    frictionProportionalZone: float
    """tangential speed up to which friction is proportional to it [m/s]"""
    contactStiffness: float
    """stiffness of the normal contact; n is ``contactStiffnessExponent`` [N/m^n]"""
    contactDamping: float
    """linear damping coefficient in normal direction, added in all impact models; leave it 0 for a restitution coefficient below 1 [Ns/m]"""
    contactStiffnessExponent: float
    """exponent n of the penetration in the normal force; 1.5 for Hertzian contact [1]"""
    restitutionCoefficient: float
    """ratio of normal speeds after and before an impact, for ``impactModel`` 1 and 2; positive, 1: elastic [1]"""
    minimumImpactVelocity: float
    """lower bound of the impact velocity in the restitution law; larger values damp slow and lasting contacts more [m/s]"""
    impactModel: int
    """0: elastic contact with linear damping; 1: Hunt-Crossley, for restitution near 1; 2: Carvalho-Martins and Gonthier, for all restitution coefficients"""
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    visualization: VObjectContactSphereTriangle | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int] = [-1, -1],
        nodeNumber: NodeIndex | int = -1,
        radiusSphere: float = 0.0,
        trianglePoints: Sequence[ArrayLike] = [],
        includeEdges: int = 7,
        dynamicFriction: float = 0.0,
        frictionProportionalZone: float = 0.001,
        contactStiffness: float = 0.0,
        contactDamping: float = 0.0,
        contactStiffnessExponent: float = 1.0,
        restitutionCoefficient: float = 1.0,
        minimumImpactVelocity: float = 0.0,
        impactModel: int = 0,
        activeConnector: bool = True,
        visualization: VObjectContactSphereTriangle | dict[str, Any] = ...,
    ) -> None: ...

class VObjectJointALEMoving2D:
    """Visualization of ObjectJointALEMoving2D."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    color: ArrayLike
    """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectJointALEMoving2D(_Item):
    """A body attached to an axially moving ANCF cable, whose sliding coordinate is shared by all elements of the cable"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    markerNumbers: Sequence[MarkerIndex | int]
    """marker m0 of the sliding body, and marker m1 of the cable element on which it begins; m1 is updated when the body passes to a neighbouring element [2]"""
    slidingMarkerNumbers: Sequence[MarkerIndex | int]
    """shape or coordinate markers of all cable elements in the order in which they follow each other: the end of one element is the begin of the next [n]"""
    slidingMarkerOffsets: ArrayLike
    """for each of these elements, the sum of the reference lengths of all elements before it; 0 for the first [n; m]"""
    slidingOffset: float
    """reference arc length that is added to the sliding coordinate [m]"""
    nodeNumbers: Sequence[NodeIndex | int]
    """NodeGenericData with one data coordinate (index of the current element), and the NodeGenericODE2 with the sliding coordinate of the cable [2]"""
    usePenaltyFormulation: bool
    """True: the constraint is softened by ``penaltyStiffness``, still with multipliers as unknowns"""
    penaltyStiffness: float
    """stiffness of the softened constraint [N/m]"""
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    visualization: VObjectJointALEMoving2D | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int] = [-1, -1],
        slidingMarkerNumbers: Sequence[MarkerIndex | int] = [],
        slidingMarkerOffsets: ArrayLike = [],
        slidingOffset: float = 0.0,
        nodeNumbers: Sequence[NodeIndex | int] = [-1, -1],
        usePenaltyFormulation: bool = False,
        penaltyStiffness: float = 0.0,
        activeConnector: bool = True,
        visualization: VObjectJointALEMoving2D | dict[str, Any] = ...,
    ) -> None: ...

ALEMovingJoint2D = ObjectJointALEMoving2D
VALEMovingJoint2D = VObjectJointALEMoving2D

class VObjectJointGeneric:
    """Visualization of ObjectJointGeneric."""

    show: bool
    """False: the item is not drawn"""
    axesRadius: float
    """radius of the drawn axes [m]"""
    axesLength: float
    """length of the drawn axes [m]"""
    color: ArrayLike
    """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    def __init__(
        self,
        show: bool = True,
        axesRadius: float = 0.1,
        axesLength: float = 0.4,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectJointGeneric(_Item):
    """A joint between two rigid body markers that constrains any choice of three translations and three rotations"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    markerNumbers: Sequence[MarkerIndex | int]
    """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    constrainedAxes: Sequence[int]
    """six flags, 1 constrained and 0 free: translation along the x, y, z axis of frame J0, rotation about them; other values are refused [6]"""
    rotationMarker0: ArrayLike
    """rotation matrix from joint frame J0 to the frame of marker m0; turns the axes of the joint [3 x 3; 1]"""
    rotationMarker1: ArrayLike
    """rotation matrix from joint frame J1 to the frame of marker m1; the joint is in its zero position if J0 and J1 are parallel [3 x 3; 1]"""
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    offsetUserFunctionParameters: ArrayLike
    """six values that are passed to the user functions, of free meaning [6; various]"""
    offsetUserFunction: Callable[..., Any] | Literal[0]
    """Python function that prescribes relative translation and rotation in the constrained directions, on position level"""
    offsetUserFunction_t: Callable[..., Any] | Literal[0]
    """Python function, the time derivative of ``offsetUserFunction``; a joint with this function is refused on velocity level, that is by index 2 integrators"""
    alternativeConstraints: bool
    """True: other equations for three constrained rotations, which keep static solutions from flipping by half a turn; changes the meaning of the multipliers; experimental"""
    visualization: VObjectJointGeneric | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int] = [-1, -1],
        constrainedAxes: Sequence[int] = [1, 1, 1, 1, 1, 1],
        rotationMarker0: ArrayLike = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        rotationMarker1: ArrayLike = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        activeConnector: bool = True,
        offsetUserFunctionParameters: ArrayLike = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        offsetUserFunction: Callable[..., Any] | Literal[0] = 0,
        offsetUserFunction_t: Callable[..., Any] | Literal[0] = 0,
        alternativeConstraints: bool = False,
        visualization: VObjectJointGeneric | dict[str, Any] = ...,
    ) -> None: ...

GenericJoint = ObjectJointGeneric
VGenericJoint = VObjectJointGeneric

class VObjectJointPrismatic2D:
    """Visualization of ObjectJointPrismatic2D."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    color: ArrayLike
    """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectJointPrismatic2D(_Item):
    """A prismatic joint of planar bodies: one point moves on a line that is fixed to the other body"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    markerNumbers: Sequence[MarkerIndex | int]
    """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    axisMarker0: ArrayLike
    """direction of the axis in the frame of marker m0, a unit vector in the x-y plane [3; 1]"""
    normalMarker1: ArrayLike
    """normal of the axis in the frame of marker m1, a unit vector in the x-y plane; perpendicular to the axis in the initial position [3; 1]"""
    constrainRotation: bool
    """True: the bodies do not rotate relative to each other; False: relative rotation is free"""
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    visualization: VObjectJointPrismatic2D | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int] = [-1, -1],
        axisMarker0: ArrayLike = [1.0, 0.0, 0.0],
        normalMarker1: ArrayLike = [0.0, 1.0, 0.0],
        constrainRotation: bool = True,
        activeConnector: bool = True,
        visualization: VObjectJointPrismatic2D | dict[str, Any] = ...,
    ) -> None: ...

PrismaticJoint2D = ObjectJointPrismatic2D
VPrismaticJoint2D = VObjectJointPrismatic2D

class VObjectJointPrismaticX:
    """Visualization of ObjectJointPrismaticX."""

    show: bool
    """False: the item is not drawn"""
    axisRadius: float
    """radius of the drawn axis [m]"""
    axisLength: float
    """length of the drawn axis [m]"""
    color: ArrayLike
    """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    def __init__(
        self,
        show: bool = True,
        axisRadius: float = 0.1,
        axisLength: float = 0.4,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectJointPrismaticX(_Item):
    """A prismatic joint between two rigid body markers, free to translate along the x axis of the joint frame"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    markerNumbers: Sequence[MarkerIndex | int]
    """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    rotationMarker0: ArrayLike
    """rotation matrix from joint frame J0 to the frame of marker m0; turns the axes of the joint [3 x 3; 1]"""
    rotationMarker1: ArrayLike
    """rotation matrix from joint frame J1 to the frame of marker m1; the joint is in its zero position if J0 and J1 are parallel [3 x 3; 1]"""
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    visualization: VObjectJointPrismaticX | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int] = [-1, -1],
        rotationMarker0: ArrayLike = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        rotationMarker1: ArrayLike = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        activeConnector: bool = True,
        visualization: VObjectJointPrismaticX | dict[str, Any] = ...,
    ) -> None: ...

PrismaticJointX = ObjectJointPrismaticX
VPrismaticJointX = VObjectJointPrismaticX

class VObjectJointRevolute2D:
    """Visualization of ObjectJointRevolute2D."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    color: ArrayLike
    """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectJointRevolute2D(_Item):
    """A revolute joint of planar bodies: keeps two points together in the x-y plane"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    markerNumbers: Sequence[MarkerIndex | int]
    """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    visualization: VObjectJointRevolute2D | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int] = [-1, -1],
        activeConnector: bool = True,
        visualization: VObjectJointRevolute2D | dict[str, Any] = ...,
    ) -> None: ...

RevoluteJoint2D = ObjectJointRevolute2D
VRevoluteJoint2D = VObjectJointRevolute2D

class VObjectJointRevoluteZ:
    """Visualization of ObjectJointRevoluteZ."""

    show: bool
    """False: the item is not drawn"""
    axisRadius: float
    """radius of the drawn axis [m]"""
    axisLength: float
    """length of the drawn axis [m]"""
    color: ArrayLike
    """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    def __init__(
        self,
        show: bool = True,
        axisRadius: float = 0.1,
        axisLength: float = 0.4,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectJointRevoluteZ(_Item):
    """A revolute joint between two rigid body markers, free to rotate about the z axis of the joint frame"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    markerNumbers: Sequence[MarkerIndex | int]
    """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    rotationMarker0: ArrayLike
    """rotation matrix from joint frame J0 to the frame of marker m0; turns the axes of the joint [3 x 3; 1]"""
    rotationMarker1: ArrayLike
    """rotation matrix from joint frame J1 to the frame of marker m1; the joint is in its zero position if J0 and J1 are parallel [3 x 3; 1]"""
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    visualization: VObjectJointRevoluteZ | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int] = [-1, -1],
        rotationMarker0: ArrayLike = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        rotationMarker1: ArrayLike = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        activeConnector: bool = True,
        visualization: VObjectJointRevoluteZ | dict[str, Any] = ...,
    ) -> None: ...

RevoluteJointZ = ObjectJointRevoluteZ
VRevoluteJointZ = VObjectJointRevoluteZ

class VObjectJointRollingDisc:
    """Visualization of ObjectJointRollingDisc."""

    show: bool
    """False: the item is not drawn"""
    discWidth: float
    """width of the drawn disc [m]"""
    color: ArrayLike
    """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    def __init__(
        self,
        show: bool = True,
        discWidth: float = 0.1,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectJointRollingDisc(_Item):
    """A rigid disc that rolls on a plane without slip, by constraints on the velocity of the contact point"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    markerNumbers: Sequence[MarkerIndex | int]
    """marker m0 on the plane and marker m1 at the center of the disc [2]"""
    constrainedAxes: Sequence[int]
    """three flags, 1 constrained and 0 free: lateral, forward and normal velocity of the contact point; other values are refused [3]"""
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    discRadius: float
    """radius of the disc [m]"""
    discAxis: ArrayLike
    """axis of the disc in the frame of marker m1, a unit vector; must not become parallel to the normal of the plane [3; 1]"""
    planeNormal: ArrayLike
    """normal of the plane in the frame of marker m0, a unit vector [3; 1]"""
    visualization: VObjectJointRollingDisc | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int] = [-1, -1],
        constrainedAxes: Sequence[int] = [1, 1, 1],
        activeConnector: bool = True,
        discRadius: float = 0.0,
        discAxis: ArrayLike = [1.0, 0.0, 0.0],
        planeNormal: ArrayLike = [0.0, 0.0, 1.0],
        visualization: VObjectJointRollingDisc | dict[str, Any] = ...,
    ) -> None: ...

RollingDiscJoint = ObjectJointRollingDisc
VRollingDiscJoint = VObjectJointRollingDisc

class VObjectJointSliding:
    """Visualization of ObjectJointSliding."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    color: ArrayLike
    """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectJointSliding(_Item):
    """A body that slides along a chain of ANCF cable elements in space"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    markerNumbers: Sequence[MarkerIndex | int]
    """marker m0 of the sliding body, and marker m1 of the cable element on which it begins; m1 is updated when the body passes to a neighbouring element [2]"""
    slidingMarkerNumbers: Sequence[MarkerIndex | int]
    """shape or coordinate markers of all cable elements in the order in which they follow each other: the end of one element is the begin of the next [n]"""
    slidingMarkerOffsets: ArrayLike
    """for each of these elements, the sum of the reference lengths of all elements before it; 0 for the first [n; m]"""
    nodeNumber: NodeIndex | int
    """NodeGenericData with two data coordinates: index of the current element in ``slidingMarkerNumbers``, and sliding coordinate at the begin of the step"""
    constrainRotations: Sequence[int]
    """three flags, 1 constrained and 0 free: rotation of marker m0 relative to the cable about its x, y and z axis; rotation about x is not available for cables [3]"""
    constrainTranslations: Sequence[int]
    """three flags, 1 constrained and 0 free: translation of marker m0 relative to the cable along its axes [3]"""
    axialForce: float
    """force along the cable that drives the body; changed during a simulation to move it [N]"""
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    visualization: VObjectJointSliding | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int] = [-1, -1],
        slidingMarkerNumbers: Sequence[MarkerIndex | int] = [],
        slidingMarkerOffsets: ArrayLike = [],
        nodeNumber: NodeIndex | int = -1,
        constrainRotations: Sequence[int] = [1, 1, 1],
        constrainTranslations: Sequence[int] = [1, 1, 1],
        axialForce: float = 0.0,
        activeConnector: bool = True,
        visualization: VObjectJointSliding | dict[str, Any] = ...,
    ) -> None: ...

SlidingJoint = ObjectJointSliding
VSlidingJoint = VObjectJointSliding

class VObjectJointSliding2D:
    """Visualization of ObjectJointSliding2D."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    color: ArrayLike
    """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectJointSliding2D(_Item):
    """A body that slides along a chain of planar ANCF cable elements"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    markerNumbers: Sequence[MarkerIndex | int]
    """marker m0 of the sliding body, and marker m1 of the cable element on which it begins; m1 is updated when the body passes to a neighbouring element [2]"""
    slidingMarkerNumbers: Sequence[MarkerIndex | int]
    """shape or coordinate markers of all cable elements in the order in which they follow each other: the end of one element is the begin of the next [n]"""
    slidingMarkerOffsets: ArrayLike
    """for each of these elements, the sum of the reference lengths of all elements before it; 0 for the first [n; m]"""
    nodeNumber: NodeIndex | int
    """NodeGenericData with two data coordinates: index of the current element in ``slidingMarkerNumbers``, and sliding coordinate at the begin of the step"""
    classicalFormulation: bool
    """True: the force along the cable is prescribed, and both components of position are constrained; index 3 only; False: only the normal direction is constrained, which index 2 integrators can solve as well"""
    constrainRotation: bool
    """True: marker m0, then a rigid body marker, keeps its orientation relative to the slope of the cable; False: it rotates freely"""
    axialForce: float
    """force along the cable that drives the body; only for ``classicalFormulation``; changed during a simulation to move the body [N]"""
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    visualization: VObjectJointSliding2D | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int] = [-1, -1],
        slidingMarkerNumbers: Sequence[MarkerIndex | int] = [],
        slidingMarkerOffsets: ArrayLike = [],
        nodeNumber: NodeIndex | int = -1,
        classicalFormulation: bool = True,
        constrainRotation: bool = False,
        axialForce: float = 0.0,
        activeConnector: bool = True,
        visualization: VObjectJointSliding2D | dict[str, Any] = ...,
    ) -> None: ...

SlidingJoint2D = ObjectJointSliding2D
VSlidingJoint2D = VObjectJointSliding2D

class VObjectJointSpherical:
    """Visualization of ObjectJointSpherical."""

    show: bool
    """False: the item is not drawn"""
    jointRadius: float
    """radius of the drawn joint [m]"""
    color: ArrayLike
    """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    def __init__(
        self,
        show: bool = True,
        jointRadius: float = 0.1,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class ObjectJointSpherical(_Item):
    """A ball joint: keeps two points together, or their chosen global components"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    markerNumbers: Sequence[MarkerIndex | int]
    """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    constrainedAxes: Sequence[int]
    """three flags, 1 constrained and 0 free: relative translation along the global x, y and z axis; other values are refused [3]"""
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    visualization: VObjectJointSpherical | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int] = [-1, -1],
        constrainedAxes: Sequence[int] = [1, 1, 1],
        activeConnector: bool = True,
        visualization: VObjectJointSpherical | dict[str, Any] = ...,
    ) -> None: ...

SphericalJoint = ObjectJointSpherical
VSphericalJoint = VObjectJointSpherical

class VMarkerBodiesRelativeRotationCoordinate:
    """Visualization of MarkerBodiesRelativeRotationCoordinate."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class MarkerBodiesRelativeRotationCoordinate(_Item):
    """A coordinate marker on the relative rotation of two bodies about an axis"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    bodyNumbers: Sequence[ObjectIndex | int]
    """the two bodies whose relative motion is the coordinate [2]"""
    nodeNumber: NodeIndex | int
    """NodeGenericData with one data coordinate that holds the last angle and makes the coordinate continuous beyond half a turn; not set: the angle jumps"""
    localPosition0: ArrayLike
    """point in the frame of the first body [3; m]"""
    localPosition1: ArrayLike
    """point in the frame of the second body [3; m]"""
    axis0: ArrayLike
    """axis of rotation in the frame of the first body, a unit vector [3; 1]"""
    offset: float
    """angle that is subtracted from the measured one [rad]"""
    visualization: VMarkerBodiesRelativeRotationCoordinate | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        bodyNumbers: Sequence[ObjectIndex | int] = [-1, -1],
        nodeNumber: NodeIndex | int = -1,
        localPosition0: ArrayLike = [0.0, 0.0, 0.0],
        localPosition1: ArrayLike = [0.0, 0.0, 0.0],
        axis0: ArrayLike = [1.0, 0.0, 0.0],
        offset: float = 0.0,
        visualization: VMarkerBodiesRelativeRotationCoordinate | dict[str, Any] = ...,
    ) -> None: ...

class VMarkerBodiesRelativeTranslationCoordinate:
    """Visualization of MarkerBodiesRelativeTranslationCoordinate."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class MarkerBodiesRelativeTranslationCoordinate(_Item):
    """A coordinate marker on the relative translation of two bodies along an axis"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    bodyNumbers: Sequence[ObjectIndex | int]
    """the two bodies whose relative motion is the coordinate [2]"""
    localPosition0: ArrayLike
    """point in the frame of the first body [3; m]"""
    localPosition1: ArrayLike
    """point in the frame of the second body [3; m]"""
    axis0: ArrayLike
    """axis of translation in the frame of the first body, a unit vector [3; 1]"""
    offset: float
    """length that is subtracted from the measured one [m]"""
    visualization: VMarkerBodiesRelativeTranslationCoordinate | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        bodyNumbers: Sequence[ObjectIndex | int] = [-1, -1],
        localPosition0: ArrayLike = [0.0, 0.0, 0.0],
        localPosition1: ArrayLike = [0.0, 0.0, 0.0],
        axis0: ArrayLike = [1.0, 0.0, 0.0],
        offset: float = 0.0,
        visualization: VMarkerBodiesRelativeTranslationCoordinate | dict[str, Any] = ...,
    ) -> None: ...

class VMarkerBodyBeamShape:
    """Visualization of MarkerBodyBeamShape."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class MarkerBodyBeamShape(_Item):
    """A marker that gives joints and contacts access to the shape of a beam element"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    bodyNumber: ObjectIndex | int
    """beam element to which the marker is attached"""
    visualization: VMarkerBodyBeamShape | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        bodyNumber: ObjectIndex | int = -1,
        visualization: VMarkerBodyBeamShape | dict[str, Any] = ...,
    ) -> None: ...

class VMarkerBodyCable2DCoordinates:
    """Visualization of MarkerBodyCable2DCoordinates."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class MarkerBodyCable2DCoordinates(_Item):
    """A marker on all coordinates of a planar ANCF cable element, for sliding joints"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    bodyNumber: ObjectIndex | int
    """planar cable element to which the marker is attached"""
    visualization: VMarkerBodyCable2DCoordinates | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        bodyNumber: ObjectIndex | int = -1,
        visualization: VMarkerBodyCable2DCoordinates | dict[str, Any] = ...,
    ) -> None: ...

class VMarkerBodyCable2DShape:
    """Visualization of MarkerBodyCable2DShape."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class MarkerBodyCable2DShape(_Item):
    """A marker that divides a planar ANCF cable element into straight segments, for contact with circles"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    bodyNumber: ObjectIndex | int
    """planar cable element to which the marker is attached"""
    numberOfSegments: int
    """number of segments; must be that of the contact that uses the marker"""
    verticalOffset: float
    """distance of the segments from the axis of the cable in direction of its local y axis, such as half the thickness of a belt [m]"""
    visualization: VMarkerBodyCable2DShape | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        bodyNumber: ObjectIndex | int = -1,
        numberOfSegments: int = 3,
        verticalOffset: float = 0.0,
        visualization: VMarkerBodyCable2DShape | dict[str, Any] = ...,
    ) -> None: ...

class VMarkerBodyMass:
    """Visualization of MarkerBodyMass."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class MarkerBodyMass(_Item):
    """A marker on the mass of a body, for loads that are proportional to mass such as gravity"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    bodyNumber: ObjectIndex | int
    """body with a mass to which the marker is attached"""
    visualization: VMarkerBodyMass | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        bodyNumber: ObjectIndex | int = -1,
        visualization: VMarkerBodyMass | dict[str, Any] = ...,
    ) -> None: ...

class VMarkerBodyPosition:
    """Visualization of MarkerBodyPosition."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class MarkerBodyPosition(_Item):
    """A marker at a point that is fixed to a body, with its position but without orientation"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    bodyNumber: ObjectIndex | int
    """body to which the marker is attached"""
    localPosition: ArrayLike
    """position of the marker in the body frame, relative to the reference point of the body [3; m]"""
    visualization: VMarkerBodyPosition | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        bodyNumber: ObjectIndex | int = -1,
        localPosition: ArrayLike = [0.0, 0.0, 0.0],
        visualization: VMarkerBodyPosition | dict[str, Any] = ...,
    ) -> None: ...

class VMarkerBodyRigid:
    """Visualization of MarkerBodyRigid."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class MarkerBodyRigid(_Item):
    """A marker at a point that is fixed to a body, with its position and orientation"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    bodyNumber: ObjectIndex | int
    """body to which the marker is attached"""
    localPosition: ArrayLike
    """position of the marker in the body frame, relative to the reference point of the body [3; m]"""
    visualization: VMarkerBodyRigid | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        bodyNumber: ObjectIndex | int = -1,
        localPosition: ArrayLike = [0.0, 0.0, 0.0],
        visualization: VMarkerBodyRigid | dict[str, Any] = ...,
    ) -> None: ...

class VMarkerKinematicTreeRigid:
    """Visualization of MarkerKinematicTreeRigid."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class MarkerKinematicTreeRigid(_Item):
    """A marker at a point that is fixed to a link of a kinematic tree, with position and orientation"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    objectNumber: ObjectIndex | int
    """kinematic tree to which the marker is attached"""
    linkNumber: int
    """number of the link within the tree, from 0; -1 means not set and is refused"""
    localPosition: ArrayLike
    """position of the marker in the frame of the link [3; m]"""
    visualization: VMarkerKinematicTreeRigid | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        objectNumber: ObjectIndex | int = -1,
        linkNumber: int = -1,
        localPosition: ArrayLike = [0.0, 0.0, 0.0],
        visualization: VMarkerKinematicTreeRigid | dict[str, Any] = ...,
    ) -> None: ...

class VMarkerNodeCoordinate:
    """Visualization of MarkerNodeCoordinate."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class MarkerNodeCoordinate(_Item):
    """A marker on a single coordinate of a node"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    nodeNumber: NodeIndex | int
    """node to which the marker is attached"""
    coordinate: int
    """number of the coordinate within the node, from 0; -1 means not set and is refused; for a ground node only 0 has a meaning"""
    visualization: VMarkerNodeCoordinate | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        nodeNumber: NodeIndex | int = -1,
        coordinate: int = -1,
        visualization: VMarkerNodeCoordinate | dict[str, Any] = ...,
    ) -> None: ...

class VMarkerNodeCoordinates:
    """Visualization of MarkerNodeCoordinates."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class MarkerNodeCoordinates(_Item):
    """A marker on all coordinates of a node, as a vector"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    nodeNumber: NodeIndex | int
    """node to which the marker is attached"""
    visualization: VMarkerNodeCoordinates | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        nodeNumber: NodeIndex | int = -1,
        visualization: VMarkerNodeCoordinates | dict[str, Any] = ...,
    ) -> None: ...

class VMarkerNodeODE1Coordinate:
    """Visualization of MarkerNodeODE1Coordinate."""

    show: bool
    """True: the item is drawn"""
    def __init__(
        self,
        show: bool = False,
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class MarkerNodeODE1Coordinate(_Item):
    """A marker on a single coordinate of a node with first order equations"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    nodeNumber: NodeIndex | int
    """NodeGenericODE1 to which the marker is attached"""
    coordinate: int
    """number of the coordinate within the node, from 0; -1 means not set and is refused"""
    visualization: VMarkerNodeODE1Coordinate | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        nodeNumber: NodeIndex | int = -1,
        coordinate: int = -1,
        visualization: VMarkerNodeODE1Coordinate | dict[str, Any] = ...,
    ) -> None: ...

class VMarkerNodePosition:
    """Visualization of MarkerNodePosition."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class MarkerNodePosition(_Item):
    """A marker at the position of a node"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    nodeNumber: NodeIndex | int
    """node with a position to which the marker is attached"""
    visualization: VMarkerNodePosition | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        nodeNumber: NodeIndex | int = -1,
        visualization: VMarkerNodePosition | dict[str, Any] = ...,
    ) -> None: ...

class VMarkerNodeRigid:
    """Visualization of MarkerNodeRigid."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class MarkerNodeRigid(_Item):
    """A marker at a node with position and orientation"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    nodeNumber: NodeIndex | int
    """node with position and orientation, such as a rigid body node, to which the marker is attached"""
    visualization: VMarkerNodeRigid | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        nodeNumber: NodeIndex | int = -1,
        visualization: VMarkerNodeRigid | dict[str, Any] = ...,
    ) -> None: ...

class VMarkerNodeRotationCoordinate:
    """Visualization of MarkerNodeRotationCoordinate."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class MarkerNodeRotationCoordinate(_Item):
    """A marker on the rotation of a node about one global axis"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    nodeNumber: NodeIndex | int
    """node with an orientation in space to which the marker is attached; planar nodes are refused, use MarkerNodeCoordinate for them"""
    rotationCoordinate: int
    """axis of rotation: 0 for x, 1 for y, 2 for z; -1 means not set and is refused"""
    visualization: VMarkerNodeRotationCoordinate | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        nodeNumber: NodeIndex | int = -1,
        rotationCoordinate: int = -1,
        visualization: VMarkerNodeRotationCoordinate | dict[str, Any] = ...,
    ) -> None: ...

class VMarkerObjectODE2Coordinates:
    """Visualization of MarkerObjectODE2Coordinates."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class MarkerObjectODE2Coordinates(_Item):
    """A marker on all second order coordinates of an object, as a vector"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    objectNumber: ObjectIndex | int
    """body to which the marker is attached"""
    visualization: VMarkerObjectODE2Coordinates | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        objectNumber: ObjectIndex | int = -1,
        visualization: VMarkerObjectODE2Coordinates | dict[str, Any] = ...,
    ) -> None: ...

class VMarkerSuperElementPosition:
    """Visualization of MarkerSuperElementPosition."""

    show: bool
    """False: the item is not drawn"""
    showMarkerNodes: bool
    """True: the mesh nodes of the marker are drawn as well"""
    def __init__(
        self,
        show: bool = True,
        showMarkerNodes: bool = True,
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class MarkerSuperElementPosition(_Item):
    """A marker at the weighted mean position of mesh nodes of a super element"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    bodyNumber: ObjectIndex | int
    """super element to which the marker is attached"""
    meshNodeNumbers: Sequence[int]
    """mesh nodes of the super element, numbered within it from 0; each must have a position [n]"""
    weightingFactors: ArrayLike
    """weight of every mesh node, as many as mesh nodes; should sum up to 1, such that the marker moves with a rigid translation of the nodes [n; 1]"""
    visualization: VMarkerSuperElementPosition | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        bodyNumber: ObjectIndex | int = -1,
        meshNodeNumbers: Sequence[int] = [],
        weightingFactors: ArrayLike = [],
        visualization: VMarkerSuperElementPosition | dict[str, Any] = ...,
    ) -> None: ...

class VMarkerSuperElementRigid:
    """Visualization of MarkerSuperElementRigid."""

    show: bool
    """False: the item is not drawn"""
    showMarkerNodes: bool
    """True: the mesh nodes of the marker are drawn as well"""
    def __init__(
        self,
        show: bool = True,
        showMarkerNodes: bool = True,
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class MarkerSuperElementRigid(_Item):
    """A marker with the weighted mean position and rotation of mesh nodes of a super element"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    bodyNumber: ObjectIndex | int
    """super element to which the marker is attached"""
    offset: ArrayLike
    """correction of the marker position in the reference frame of the super element, if the mean of the mesh nodes is not the wanted point; should be small [3; m]"""
    meshNodeNumbers: Sequence[int]
    """mesh nodes of the super element, numbered within it from 0; each must have a position [n]"""
    weightingFactors: ArrayLike
    """weight of every mesh node, as many as mesh nodes; should sum up to 1, for instance parts of the area of an interface [n; 1]"""
    useAlternativeApproach: bool
    """True: the mean rotation follows from the angular momentum of the weighted nodes; False: it is a mean weighted by squared distances"""
    rotationsExponentialMap: int
    """0: rotation and angular velocity are linearized; 1: rotation by the exponential map; 2: rotation by the exponential map and angular velocity by its tangent map, the consistent choice"""
    visualization: VMarkerSuperElementRigid | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        bodyNumber: ObjectIndex | int = -1,
        offset: ArrayLike = [0.0, 0.0, 0.0],
        meshNodeNumbers: Sequence[int] = [],
        weightingFactors: ArrayLike = [],
        useAlternativeApproach: bool = True,
        rotationsExponentialMap: int = 2,
        visualization: VMarkerSuperElementRigid | dict[str, Any] = ...,
    ) -> None: ...

class VLoadCoordinate:
    """Visualization of LoadCoordinate."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class LoadCoordinate(_Item):
    """A generalized force on a single coordinate"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    markerNumber: MarkerIndex | int
    """coordinate marker to which the load is applied"""
    load: float
    """generalized force: N on a coordinate that is a length, Nm on an angle; without effect if there is a user function, which gets it as an argument [various]"""
    loadUserFunction: Callable[..., Any] | Literal[0]
    """Python function that computes the load as a function of time"""
    visualization: VLoadCoordinate | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        markerNumber: MarkerIndex | int = -1,
        load: float = 0.0,
        loadUserFunction: Callable[..., Any] | Literal[0] = 0,
        visualization: VLoadCoordinate | dict[str, Any] = ...,
    ) -> None: ...

class VLoadForceVector:
    """Visualization of LoadForceVector."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class LoadForceVector(_Item):
    """A force vector at a point of a body or at a node"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    markerNumber: MarkerIndex | int
    """marker with a position to which the force is applied; with ``bodyFixed`` it must have an orientation as well"""
    loadVector: ArrayLike
    """force vector in global coordinates, or in the marker frame with ``bodyFixed``; without effect if there is a user function, which gets it as an argument [3; N]"""
    bodyFixed: bool
    """True: the vector is given in the frame of the marker and turns with the body, a follower force; False: in global coordinates"""
    loadVectorUserFunction: Callable[..., Any] | Literal[0]
    """Python function that computes the force vector as a function of time"""
    visualization: VLoadForceVector | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        markerNumber: MarkerIndex | int = -1,
        loadVector: ArrayLike = [0.0, 0.0, 0.0],
        bodyFixed: bool = False,
        loadVectorUserFunction: Callable[..., Any] | Literal[0] = 0,
        visualization: VLoadForceVector | dict[str, Any] = ...,
    ) -> None: ...

Force = LoadForceVector
VForce = VLoadForceVector

class VLoadMassProportional:
    """Visualization of LoadMassProportional."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class LoadMassProportional(_Item):
    """A distributed load proportional to mass, such as gravity"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    markerNumber: MarkerIndex | int
    """marker of type BodyMass on the body to which the load is applied"""
    loadVector: ArrayLike
    """force per mass in global coordinates, such as the gravitational acceleration ``[0, 0, -9.81]``; without effect if there is a user function, which gets it as an argument [3; m/s^2]"""
    loadVectorUserFunction: Callable[..., Any] | Literal[0]
    """Python function that computes the vector as a function of time"""
    visualization: VLoadMassProportional | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        markerNumber: MarkerIndex | int = -1,
        loadVector: ArrayLike = [0.0, 0.0, 0.0],
        loadVectorUserFunction: Callable[..., Any] | Literal[0] = 0,
        visualization: VLoadMassProportional | dict[str, Any] = ...,
    ) -> None: ...

Gravity = LoadMassProportional
VGravity = VLoadMassProportional

class VLoadTorqueVector:
    """Visualization of LoadTorqueVector."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class LoadTorqueVector(_Item):
    """A torque vector on a body or node with orientation"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    markerNumber: MarkerIndex | int
    """marker with an orientation to which the torque is applied"""
    loadVector: ArrayLike
    """torque vector in global coordinates, or in the marker frame with ``bodyFixed``; without effect if there is a user function, which gets it as an argument [3; Nm]"""
    bodyFixed: bool
    """True: the vector is given in the frame of the marker and turns with the body; False: in global coordinates"""
    loadVectorUserFunction: Callable[..., Any] | Literal[0]
    """Python function that computes the torque vector as a function of time"""
    visualization: VLoadTorqueVector | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        markerNumber: MarkerIndex | int = -1,
        loadVector: ArrayLike = [0.0, 0.0, 0.0],
        bodyFixed: bool = False,
        loadVectorUserFunction: Callable[..., Any] | Literal[0] = 0,
        visualization: VLoadTorqueVector | dict[str, Any] = ...,
    ) -> None: ...

Torque = LoadTorqueVector
VTorque = VLoadTorqueVector

class VSensorBody:
    """Visualization of SensorBody."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class SensorBody(_Item):
    """Measures an output variable of a body at a local position"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    bodyNumber: ObjectIndex | int
    """body that is measured"""
    localPosition: ArrayLike
    """point in the body frame, relative to the reference point; for beams and cables the x component is the position along the axis [3; m]"""
    writeToFile: bool
    """write the measured values to a file while a solver runs; without effect if ``fileName`` is empty"""
    fileName: str
    """file with the time in the first and the values in the further columns; the path is relative to the working directory, missing directories are created"""
    outputVariableType: OutputVariableType
    """output variable that is measured; one that the measured item does not provide is refused in Assemble"""
    storeInternal: bool
    """keep time and values in memory, to be read with ``mbs.GetSensorStoredData`` during or after the solution"""
    visualization: VSensorBody | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        bodyNumber: ObjectIndex | int = -1,
        localPosition: ArrayLike = [0.0, 0.0, 0.0],
        writeToFile: bool = True,
        fileName: str = '',
        outputVariableType: OutputVariableType = OutputVariableType._None,
        storeInternal: bool = False,
        visualization: VSensorBody | dict[str, Any] = ...,
    ) -> None: ...

class VSensorKinematicTree:
    """Visualization of SensorKinematicTree."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class SensorKinematicTree(_Item):
    """Measures an output variable of a link of a kinematic tree at a local position"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    objectNumber: ObjectIndex | int
    """kinematic tree that is measured"""
    linkNumber: int
    """link, numbered within the tree from 0; -1 means not set and is refused"""
    localPosition: ArrayLike
    """point in the frame of the link [3; m]"""
    writeToFile: bool
    """write the measured values to a file while a solver runs; without effect if ``fileName`` is empty"""
    fileName: str
    """file with the time in the first and the values in the further columns; the path is relative to the working directory, missing directories are created"""
    outputVariableType: OutputVariableType
    """output variable that is measured; one that the measured item does not provide is refused in Assemble"""
    storeInternal: bool
    """keep time and values in memory, to be read with ``mbs.GetSensorStoredData`` during or after the solution"""
    visualization: VSensorKinematicTree | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        objectNumber: ObjectIndex | int = -1,
        linkNumber: int = -1,
        localPosition: ArrayLike = [0.0, 0.0, 0.0],
        writeToFile: bool = True,
        fileName: str = '',
        outputVariableType: OutputVariableType = OutputVariableType._None,
        storeInternal: bool = False,
        visualization: VSensorKinematicTree | dict[str, Any] = ...,
    ) -> None: ...

class VSensorLoad:
    """Visualization of SensorLoad."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class SensorLoad(_Item):
    """Measures the value of a load"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    loadNumber: LoadIndex | int
    """load that is measured"""
    writeToFile: bool
    """write the measured values to a file while a solver runs; without effect if ``fileName`` is empty"""
    fileName: str
    """file with the time in the first and the values in the further columns; the path is relative to the working directory, missing directories are created"""
    storeInternal: bool
    """keep time and values in memory, to be read with ``mbs.GetSensorStoredData`` during or after the solution"""
    visualization: VSensorLoad | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        loadNumber: LoadIndex | int = -1,
        writeToFile: bool = True,
        fileName: str = '',
        storeInternal: bool = False,
        visualization: VSensorLoad | dict[str, Any] = ...,
    ) -> None: ...

class VSensorMarker:
    """Visualization of SensorMarker."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class SensorMarker(_Item):
    """Measures an output variable of a marker"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    markerNumber: MarkerIndex | int
    """marker that is measured"""
    writeToFile: bool
    """write the measured values to a file while a solver runs; without effect if ``fileName`` is empty"""
    fileName: str
    """file with the time in the first and the values in the further columns; the path is relative to the working directory, missing directories are created"""
    outputVariableType: OutputVariableType
    """output variable that is measured; one that the measured item does not provide is refused in Assemble"""
    storeInternal: bool
    """keep time and values in memory, to be read with ``mbs.GetSensorStoredData`` during or after the solution"""
    visualization: VSensorMarker | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        markerNumber: MarkerIndex | int = -1,
        writeToFile: bool = True,
        fileName: str = '',
        outputVariableType: OutputVariableType = OutputVariableType._None,
        storeInternal: bool = False,
        visualization: VSensorMarker | dict[str, Any] = ...,
    ) -> None: ...

class VSensorNode:
    """Visualization of SensorNode."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class SensorNode(_Item):
    """Measures an output variable of a node"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    nodeNumber: NodeIndex | int
    """node that is measured"""
    writeToFile: bool
    """write the measured values to a file while a solver runs; without effect if ``fileName`` is empty"""
    fileName: str
    """file with the time in the first and the values in the further columns; the path is relative to the working directory, missing directories are created"""
    outputVariableType: OutputVariableType
    """output variable that is measured; one that the measured item does not provide is refused in Assemble"""
    storeInternal: bool
    """keep time and values in memory, to be read with ``mbs.GetSensorStoredData`` during or after the solution"""
    visualization: VSensorNode | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        nodeNumber: NodeIndex | int = -1,
        writeToFile: bool = True,
        fileName: str = '',
        outputVariableType: OutputVariableType = OutputVariableType._None,
        storeInternal: bool = False,
        visualization: VSensorNode | dict[str, Any] = ...,
    ) -> None: ...

class VSensorObject:
    """Visualization of SensorObject."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class SensorObject(_Item):
    """Measures an output variable of a connector, constraint, joint or contact"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    objectNumber: ObjectIndex | int
    """object that is measured; a body is refused for variables that need a local position, use SensorBody for it"""
    writeToFile: bool
    """write the measured values to a file while a solver runs; without effect if ``fileName`` is empty"""
    fileName: str
    """file with the time in the first and the values in the further columns; the path is relative to the working directory, missing directories are created"""
    outputVariableType: OutputVariableType
    """output variable that is measured; one that the measured item does not provide is refused in Assemble"""
    storeInternal: bool
    """keep time and values in memory, to be read with ``mbs.GetSensorStoredData`` during or after the solution"""
    visualization: VSensorObject | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        objectNumber: ObjectIndex | int = -1,
        writeToFile: bool = True,
        fileName: str = '',
        outputVariableType: OutputVariableType = OutputVariableType._None,
        storeInternal: bool = False,
        visualization: VSensorObject | dict[str, Any] = ...,
    ) -> None: ...

class VSensorSuperElement:
    """Visualization of SensorSuperElement."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class SensorSuperElement(_Item):
    """Measures an output variable at a mesh node of a super element"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    bodyNumber: ObjectIndex | int
    """super element that is measured"""
    meshNodeNumber: int
    """mesh node, numbered within the super element from 0; -1 means not set and is refused"""
    writeToFile: bool
    """write the measured values to a file while a solver runs; without effect if ``fileName`` is empty"""
    fileName: str
    """file with the time in the first and the values in the further columns; the path is relative to the working directory, missing directories are created"""
    outputVariableType: OutputVariableType
    """output variable that is measured; one that the measured item does not provide is refused in Assemble"""
    storeInternal: bool
    """keep time and values in memory, to be read with ``mbs.GetSensorStoredData`` during or after the solution"""
    visualization: VSensorSuperElement | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        bodyNumber: ObjectIndex | int = -1,
        meshNodeNumber: int = -1,
        writeToFile: bool = True,
        fileName: str = '',
        outputVariableType: OutputVariableType = OutputVariableType._None,
        storeInternal: bool = False,
        visualization: VSensorSuperElement | dict[str, Any] = ...,
    ) -> None: ...

class VSensorUserFunction:
    """Visualization of SensorUserFunction."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...

class SensorUserFunction(_Item):
    """Computes its values by a Python function, for instance from other sensors"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    sensorNumbers: Sequence[SensorIndex | int]
    """sensors that the user function may evaluate; may be empty [n]"""
    factors: ArrayLike
    """values that are passed to the user function, of free meaning, such as weights or conversions of units [n; various]"""
    writeToFile: bool
    """write the measured values to a file while a solver runs; without effect if ``fileName`` is empty"""
    fileName: str
    """file with the time in the first and the values in the further columns; the path is relative to the working directory, missing directories are created"""
    sensorUserFunction: Callable[..., Any] | Literal[0]
    """Python function that returns the values of the sensor"""
    storeInternal: bool
    """keep time and values in memory, to be read with ``mbs.GetSensorStoredData`` during or after the solution"""
    visualization: VSensorUserFunction | dict[str, Any]
    """how the item is drawn"""
    def __init__(
        self,
        name: str = '',
        sensorNumbers: Sequence[SensorIndex | int] = [],
        factors: ArrayLike = [],
        writeToFile: bool = True,
        fileName: str = '',
        sensorUserFunction: Callable[..., Any] | Literal[0] = 0,
        storeInternal: bool = False,
        visualization: VSensorUserFunction | dict[str, Any] = ...,
    ) -> None: ...
