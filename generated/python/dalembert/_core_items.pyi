# Generated from specs/ by codegen/templates/core_items.pyi.j2. Do not edit; run `python -m codegen`.
# tests/codegen/test_freshness.py compares this file with its sources.

from collections.abc import Callable, Iterator, Sequence
from typing import Any, ClassVar, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from dalembert._core import (
    BeamSection,
    BeamSectionGeometry,
    Item,
    LoadIndex,
    MainSystem,
    MarkerIndex,
    Matrix3DList,
    MatrixContainer,
    NodeIndex,
    ObjectIndex,
    SensorIndex,
    Vector3DList,
    Vector6DList,
    Visualization,
)
from dalembert._core_enums import ConfigurationType, JointType, OutputVariableType
from dalembert._core_types import Array, MatrixLike
from dalembert._geometry.rigid_transformation import HT

class _Item(Item):
    """Items convert to dictionaries, and to equal items when pickled or copied."""

    __hash__: ClassVar[None]  # type: ignore[assignment]
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...
    def __lt__(self, other: object, /) -> bool: ...
    def __le__(self, other: object, /) -> bool: ...
    def __gt__(self, other: object, /) -> bool: ...
    def __ge__(self, other: object, /) -> bool: ...

# One class per kind, so that AddNode(...) refuses an object already in the editor. They do not exist at run time.
class _Node(_Item): ...
class _Object(_Item): ...
class _Marker(_Item): ...
class _Load(_Item): ...
class _Sensor(_Item): ...

class _Visualization(Visualization):
    """Visualization parameters are attributes and, as in a dictionary, entries."""

    __hash__: ClassVar[None]  # type: ignore[assignment]
    def __iter__(self) -> Iterator[tuple[str, Any]]: ...
    def __getitem__(self, key: str, /) -> Any: ...
    def __setitem__(self, key: str, value: Any, /) -> None: ...
    def __delitem__(self, key: str, /) -> None: ...
    def __lt__(self, other: object, /) -> bool: ...
    def __le__(self, other: object, /) -> bool: ...
    def __gt__(self, other: object, /) -> bool: ...
    def __ge__(self, other: object, /) -> bool: ...
    def keys(self) -> list[str]: ...

class VNodeGenericAE(_Visualization):
    """Visualization of NodeGenericAE."""

    show: bool
    """True: the item is drawn"""
    def __init__(
        self,
        show: bool = False,
    ) -> None: ...

class NodeGenericAE(_Node):
    """node with a chosen number of algebraic variables, for equations that hold without time derivatives"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def referenceCoordinates(self) -> Array:
        """reference values; their number is ``numberOfAECoordinates``; units are those of the equations that use the node [n; various]"""
    @referenceCoordinates.setter
    def referenceCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initialCoordinates(self) -> Array:
        """start values of the solver, relative to the reference values; their number is ``numberOfAECoordinates`` [n; various]"""
    @initialCoordinates.setter
    def initialCoordinates(self, value: ArrayLike) -> None: ...
    numberOfAECoordinates: int
    """number of algebraic variables; at least 1"""
    @property
    def visualization(self) -> VNodeGenericAE:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VNodeGenericAE | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        referenceCoordinates: ArrayLike = [],
        initialCoordinates: ArrayLike = [],
        numberOfAECoordinates: int = 0,
        visualization: VNodeGenericAE | dict[str, Any] = ...,
    ) -> None: ...

class VNodeGenericData(_Visualization):
    """Visualization of NodeGenericData."""

    show: bool
    """True: the item is drawn"""
    def __init__(
        self,
        show: bool = False,
    ) -> None: ...

class NodeGenericData(_Node):
    """node with a chosen number of data variables: states that are kept from step to step and are not unknowns of the solver"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def initialCoordinates(self) -> Array:
        """values at the start of a computation; their number is ``numberOfDataCoordinates``, or zero (all values are zero); other lengths are rejected; their meaning and units are those of the object that uses the node [n; various]"""
    @initialCoordinates.setter
    def initialCoordinates(self, value: ArrayLike) -> None: ...
    numberOfDataCoordinates: int
    """number of data variables; objects that need a data node say how many they expect"""
    @property
    def visualization(self) -> VNodeGenericData:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VNodeGenericData | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        initialCoordinates: ArrayLike = [],
        numberOfDataCoordinates: int = 0,
        visualization: VNodeGenericData | dict[str, Any] = ...,
    ) -> None: ...

class VNodeGenericODE1(_Visualization):
    """Visualization of NodeGenericODE1."""

    show: bool
    """True: the item is drawn"""
    def __init__(
        self,
        show: bool = False,
    ) -> None: ...

class NodeGenericODE1(_Node):
    """node with a chosen number of coordinates of first order differential equations, for controllers, hydraulics and state-space models"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def referenceCoordinates(self) -> Array:
        """constant values to which the coordinates are added; their number is ``numberOfODE1Coordinates``, or zero (all values are zero); other lengths are rejected; units are those of the equations that use the node [n; various]"""
    @referenceCoordinates.setter
    def referenceCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initialCoordinates(self) -> Array:
        """values at the start, relative to the reference values; their number is ``numberOfODE1Coordinates`` [n; various]"""
    @initialCoordinates.setter
    def initialCoordinates(self, value: ArrayLike) -> None: ...
    numberOfODE1Coordinates: int
    """number of coordinates, each with a first order differential equation; at least 1"""
    @property
    def visualization(self) -> VNodeGenericODE1:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VNodeGenericODE1 | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        referenceCoordinates: ArrayLike = [],
        initialCoordinates: ArrayLike = [],
        numberOfODE1Coordinates: int = 0,
        visualization: VNodeGenericODE1 | dict[str, Any] = ...,
    ) -> None: ...

class VNodeGenericODE2(_Visualization):
    """Visualization of NodeGenericODE2."""

    show: bool
    """True: the item is drawn"""
    def __init__(
        self,
        show: bool = False,
    ) -> None: ...

class NodeGenericODE2(_Node):
    """node with a chosen number of coordinates of second order differential equations, without a meaning in space"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def referenceCoordinates(self) -> Array:
        """constant values to which the coordinates are added; their number is ``numberOfODE2Coordinates``, or zero (all values are zero); other lengths are rejected; units are those of the equations that use the node [n; various]"""
    @referenceCoordinates.setter
    def referenceCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initialCoordinates(self) -> Array:
        """values at the start, relative to the reference values; their number is ``numberOfODE2Coordinates`` [n; various]"""
    @initialCoordinates.setter
    def initialCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initialCoordinates_t(self) -> Array:
        """time derivatives of the coordinates at the start; their number is ``numberOfODE2Coordinates`` [n; various]"""
    @initialCoordinates_t.setter
    def initialCoordinates_t(self, value: ArrayLike) -> None: ...
    numberOfODE2Coordinates: int
    """number of coordinates, each with a second order differential equation; at least 1"""
    @property
    def visualization(self) -> VNodeGenericODE2:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VNodeGenericODE2 | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        referenceCoordinates: ArrayLike = [],
        initialCoordinates: ArrayLike = [],
        initialCoordinates_t: ArrayLike = [],
        numberOfODE2Coordinates: int = 0,
        visualization: VNodeGenericODE2 | dict[str, Any] = ...,
    ) -> None: ...

class VNode1D(_Visualization):
    """Visualization of Node1D."""

    show: bool
    """True: the item is drawn"""
    def __init__(
        self,
        show: bool = False,
    ) -> None: ...

class Node1D(_Node):
    """node with one coordinate of a second order differential equation, for motion along a line or about a fixed axis"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def referenceCoordinates(self) -> Array:
        """reference value of the coordinate, a list of length 1, or an empty one for zero; m for a translation, rad for a rotation, as the body on the node says [n; various]"""
    @referenceCoordinates.setter
    def referenceCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initialCoordinates(self) -> Array:
        """coordinate at the start, relative to the reference value, a list of length 1, or an empty one for zero [n; various]"""
    @initialCoordinates.setter
    def initialCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initialVelocities(self) -> Array:
        """time derivative of the coordinate at the start, a list of length 1, or an empty one for zero [n; various]"""
    @initialVelocities.setter
    def initialVelocities(self, value: ArrayLike) -> None: ...
    @property
    def visualization(self) -> VNode1D:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VNode1D | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        referenceCoordinates: ArrayLike = [0.0],
        initialCoordinates: ArrayLike = [0.0],
        initialVelocities: ArrayLike = [0.0],
        visualization: VNode1D | dict[str, Any] = ...,
    ) -> None: ...

class VNodePoint(_Visualization):
    """Visualization of NodePoint."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...

class NodePoint(_Node):
    """node with the three displacements of a point in space"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def referenceCoordinates(self) -> Array:
        """global position of the node without displacement [3; m]"""
    @referenceCoordinates.setter
    def referenceCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initialCoordinates(self) -> Array:
        """displacement from the reference position at the start [3; m]"""
    @initialCoordinates.setter
    def initialCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initialVelocities(self) -> Array:
        """global velocity at the start [3; m/s]"""
    @initialVelocities.setter
    def initialVelocities(self, value: ArrayLike) -> None: ...
    @property
    def visualization(self) -> VNodePoint:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VNodePoint | dict[str, Any]) -> None: ...
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

class VNodePoint2D(_Visualization):
    """Visualization of NodePoint2D."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...

class NodePoint2D(_Node):
    """node with the two displacements of a point in the global x-y plane"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def referenceCoordinates(self) -> Array:
        """global x and y position of the node without displacement; z is zero [2; m]"""
    @referenceCoordinates.setter
    def referenceCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initialCoordinates(self) -> Array:
        """displacement in x and y from the reference position at the start [2; m]"""
    @initialCoordinates.setter
    def initialCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initialVelocities(self) -> Array:
        """global velocity in x and y at the start [2; m/s]"""
    @initialVelocities.setter
    def initialVelocities(self, value: ArrayLike) -> None: ...
    @property
    def visualization(self) -> VNodePoint2D:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VNodePoint2D | dict[str, Any]) -> None: ...
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

class VNodePoint2DSlope1(_Visualization):
    """Visualization of NodePoint2DSlope1."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...

class NodePoint2DSlope1(_Node):
    """node of planar cable elements: position and axial slope vector in the global x-y plane"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def referenceCoordinates(self) -> Array:
        """x and y position (m), then x and y component of the slope vector (1); a unit vector along the axis for an element that is not stretched in the reference configuration [4; various]"""
    @referenceCoordinates.setter
    def referenceCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initialCoordinates(self) -> Array:
        """displacement (m) and change of the slope vector (1) at the start, relative to the reference coordinates [4; various]"""
    @initialCoordinates.setter
    def initialCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initialVelocities(self) -> Array:
        """velocity (m/s) and rate of the slope vector (1/s) at the start [4; various]"""
    @initialVelocities.setter
    def initialVelocities(self, value: ArrayLike) -> None: ...
    @property
    def visualization(self) -> VNodePoint2DSlope1:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VNodePoint2DSlope1 | dict[str, Any]) -> None: ...
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

class VNodePointGround(_Visualization):
    """Visualization of NodePointGround."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...

class NodePointGround(_Node):
    """fixed point without coordinates, as the other end of springs and constraints on coordinates or points"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def referenceCoordinates(self) -> Array:
        """global position of the node [3; m]"""
    @referenceCoordinates.setter
    def referenceCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def visualization(self) -> VNodePointGround:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VNodePointGround | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        referenceCoordinates: ArrayLike = [0.0, 0.0, 0.0],
        visualization: VNodePointGround | dict[str, Any] = ...,
    ) -> None: ...

PointGround = NodePointGround
VPointGround = VNodePointGround

class VNodePointSlope1(_Visualization):
    """Visualization of NodePointSlope1."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...

class NodePointSlope1(_Node):
    """node of spatial cable elements: position and axial slope vector"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def referenceCoordinates(self) -> Array:
        """global position (m), then the slope vector (1); a unit vector along the axis for an element that is not stretched in the reference configuration [6; various]"""
    @referenceCoordinates.setter
    def referenceCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initialCoordinates(self) -> Array:
        """displacement (m) and change of the slope vector (1) at the start, relative to the reference coordinates [6; various]"""
    @initialCoordinates.setter
    def initialCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initialVelocities(self) -> Array:
        """velocity (m/s) and rate of the slope vector (1/s) at the start [6; various]"""
    @initialVelocities.setter
    def initialVelocities(self, value: ArrayLike) -> None: ...
    @property
    def visualization(self) -> VNodePointSlope1:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VNodePointSlope1 | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        referenceCoordinates: ArrayLike = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0],
        initialCoordinates: ArrayLike = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        initialVelocities: ArrayLike = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        visualization: VNodePointSlope1 | dict[str, Any] = ...,
    ) -> None: ...

class VNodePointSlope12(_Visualization):
    """Visualization of NodePointSlope12."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...

class NodePointSlope12(_Node):
    """node of thin plate elements: position and the two slope vectors in the plane of the plate"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def referenceCoordinates(self) -> Array:
        """global position (m), then the slope vectors in x and y (1); the two default slopes are parallel and so span no frame: give independent ones [9; various]"""
    @referenceCoordinates.setter
    def referenceCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initialCoordinates(self) -> Array:
        """displacement (m) and change of the slope vectors (1) at the start, relative to the reference coordinates [9; various]"""
    @initialCoordinates.setter
    def initialCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initialVelocities(self) -> Array:
        """velocity (m/s) and rates of the slope vectors (1/s) at the start [9; various]"""
    @initialVelocities.setter
    def initialVelocities(self, value: ArrayLike) -> None: ...
    @property
    def visualization(self) -> VNodePointSlope12:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VNodePointSlope12 | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        referenceCoordinates: ArrayLike = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0],
        initialCoordinates: ArrayLike = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        initialVelocities: ArrayLike = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        visualization: VNodePointSlope12 | dict[str, Any] = ...,
    ) -> None: ...

class VNodePointSlope23(_Visualization):
    """Visualization of NodePointSlope23."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...

class NodePointSlope23(_Node):
    """node of shear and cross-section deformable beam elements: position and the two slope vectors in the cross section"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def referenceCoordinates(self) -> Array:
        """global position (m), then the slope vectors in y and z (1); the two default slopes are parallel and so span no frame: give independent ones [9; various]"""
    @referenceCoordinates.setter
    def referenceCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initialCoordinates(self) -> Array:
        """displacement (m) and change of the slope vectors (1) at the start, relative to the reference coordinates [9; various]"""
    @initialCoordinates.setter
    def initialCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initialVelocities(self) -> Array:
        """velocity (m/s) and rates of the slope vectors (1/s) at the start [9; various]"""
    @initialVelocities.setter
    def initialVelocities(self, value: ArrayLike) -> None: ...
    @property
    def visualization(self) -> VNodePointSlope23:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VNodePointSlope23 | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        referenceCoordinates: ArrayLike = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0],
        initialCoordinates: ArrayLike = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        initialVelocities: ArrayLike = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        visualization: VNodePointSlope23 | dict[str, Any] = ...,
    ) -> None: ...

class VNodeRigidBody2D(_Visualization):
    """Visualization of NodeRigidBody2D."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...

class NodeRigidBody2D(_Node):
    """node of a rigid body that moves in the global x-y plane: two displacements and the angle about z"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def referenceCoordinates(self) -> Array:
        """x and y position of the reference point (m) and the angle about z (rad) without displacement and rotation [3; various]"""
    @referenceCoordinates.setter
    def referenceCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initialCoordinates(self) -> Array:
        """displacement in x and y (m) and rotation about z (rad) at the start, relative to the reference coordinates [3; various]"""
    @initialCoordinates.setter
    def initialCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initialVelocities(self) -> Array:
        """velocity in x and y (m/s) and angular velocity about z (rad/s) at the start [3; various]"""
    @initialVelocities.setter
    def initialVelocities(self, value: ArrayLike) -> None: ...
    @property
    def visualization(self) -> VNodeRigidBody2D:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VNodeRigidBody2D | dict[str, Any]) -> None: ...
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

class VNodeRigidBodyEP(_Visualization):
    """Visualization of NodeRigidBodyEP."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...

class NodeRigidBodyEP(_Node):
    """node of a rigid body in space: three displacements and four Euler parameters (unit quaternion)"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def referenceCoordinates(self) -> Array:
        """position of the reference point (m) and four Euler parameters (1), the scalar one first; their norm must be 1, so that the default of zeros is refused; [1, 0, 0, 0] is no rotation [7; various]"""
    @referenceCoordinates.setter
    def referenceCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initialCoordinates(self) -> Array:
        """displacement (m) and change of the Euler parameters (1) at the start; the sum of reference and initial Euler parameters must have norm 1 [7; various]"""
    @initialCoordinates.setter
    def initialCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initialVelocities(self) -> Array:
        """velocity (m/s) and time derivatives of the Euler parameters (1/s) at the start; for a given angular velocity they are :math:`\\tfrac{1}{4}\\, {}^{b}\\mathbf{G}^{\\mathsf{T}}\\, {}^{b}\\boldsymbol{\\omega}` [7; various]"""
    @initialVelocities.setter
    def initialVelocities(self, value: ArrayLike) -> None: ...
    addConstraintEquation: bool
    """true: the node adds the equation that keeps the norm of the Euler parameters, with one algebraic variable; false: the norm has to be kept by a constraint of the model"""
    @property
    def visualization(self) -> VNodeRigidBodyEP:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VNodeRigidBodyEP | dict[str, Any]) -> None: ...
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

class VNodeRigidBodyRotVecLG(_Visualization):
    """Visualization of NodeRigidBodyRotVecLG."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...

class NodeRigidBodyRotVecLG(_Node):
    """node of a rigid body in space: three displacements and a rotation vector that is integrated by Lie group methods"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def referenceCoordinates(self) -> Array:
        """position of the reference point (m) and rotation vector (rad) without displacement and rotation [6; various]"""
    @referenceCoordinates.setter
    def referenceCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initialCoordinates(self) -> Array:
        """displacement (m) and change of the rotation vector (rad) at the start; reference and initial rotation vector are added as vectors [6; various]"""
    @initialCoordinates.setter
    def initialCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initialVelocities(self) -> Array:
        """velocity (m/s) and angular velocity in body coordinates (rad/s) at the start [6; various]"""
    @initialVelocities.setter
    def initialVelocities(self, value: ArrayLike) -> None: ...
    @property
    def visualization(self) -> VNodeRigidBodyRotVecLG:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VNodeRigidBodyRotVecLG | dict[str, Any]) -> None: ...
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

class VNodeRigidBodyRxyz(_Visualization):
    """Visualization of NodeRigidBodyRxyz."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...

class NodeRigidBodyRxyz(_Node):
    """node of a rigid body in space: three displacements and three Tait-Bryan angles about x, y and z in turn"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def referenceCoordinates(self) -> Array:
        """position of the reference point (m) and the angles (rad) without displacement and rotation [6; various]"""
    @referenceCoordinates.setter
    def referenceCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initialCoordinates(self) -> Array:
        """displacement (m) and change of the angles (rad) at the start, relative to the reference coordinates [6; various]"""
    @initialCoordinates.setter
    def initialCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initialVelocities(self) -> Array:
        """velocity (m/s) and time derivatives of the angles (rad/s) at the start; the latter are not the components of the angular velocity, except at zero angles [6; various]"""
    @initialVelocities.setter
    def initialVelocities(self, value: ArrayLike) -> None: ...
    @property
    def visualization(self) -> VNodeRigidBodyRxyz:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VNodeRigidBodyRxyz | dict[str, Any]) -> None: ...
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

class VObjectGenericODE1(_Visualization):
    """Visualization of ObjectGenericODE1."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...

class ObjectGenericODE1(_Object):
    """system of first order differential equations with a constant matrix, a constant vector and a user function"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def nodeNumbers(self) -> list[NodeIndex]:
        """nodes with first order coordinates; their coordinates in this order form the vector of the object [n]"""
    @nodeNumbers.setter
    def nodeNumbers(self, value: Sequence[NodeIndex | int | str]) -> None: ...
    @property
    def systemMatrix(self) -> Array:
        """constant system matrix; n rows and n columns for n coordinates, or empty for zero; other sizes are refused [n x m; various]"""
    @systemMatrix.setter
    def systemMatrix(self, value: ArrayLike) -> None: ...
    @property
    def rhsVector(self) -> Array:
        """constant right hand side; length n, or empty for zero [n; various]"""
    @rhsVector.setter
    def rhsVector(self, value: ArrayLike) -> None: ...
    rhsUserFunction: Callable[[MainSystem, float, int, Array], ArrayLike] | Literal[0]
    """function that gives a further right hand side, of time and coordinates"""
    @property
    def coordinateIndexPerNode(self) -> list[int]:
        """index of the first coordinate of each node in the vector of the object [n]; computed"""
    @property
    def tempCoordinates(self) -> Array:
        """coordinates, a work space of the object [n; various]; computed"""
    @property
    def tempCoordinates_t(self) -> Array:
        """time derivatives of the coordinates, a work space of the object [n; various]; computed"""
    @property
    def visualization(self) -> VObjectGenericODE1:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectGenericODE1 | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        nodeNumbers: Sequence[NodeIndex | int | str] = [],
        systemMatrix: ArrayLike = [],
        rhsVector: ArrayLike = [],
        rhsUserFunction: Callable[[MainSystem, float, int, Array], ArrayLike] | Literal[0] = 0,
        visualization: VObjectGenericODE1 | dict[str, Any] = ...,
    ) -> None: ...

class VObjectGround(_Visualization):
    """Visualization of ObjectGround."""

    show: bool
    """False: the item is not drawn"""
    graphicsDataUserFunction: Callable[[MainSystem, int], list[dict[str, Any]]] | Literal[0]
    """function that returns the shapes to be drawn, called at every redraw; shapes are given in the frame of the body"""
    @property
    def graphicsData(self) -> list[dict[str, Any]]:
        """shapes attached to the body frame, as made by the functions of the graphics module [n]"""
    @graphicsData.setter
    def graphicsData(self, value: Sequence[dict[str, Any]]) -> None: ...
    def __init__(
        self,
        show: bool = True,
        graphicsDataUserFunction: Callable[[MainSystem, int], list[dict[str, Any]]] | Literal[0] = 0,
        graphicsData: Sequence[dict[str, Any]] = [],
    ) -> None: ...

class ObjectGround(_Object):
    """body that does not move: the fixed end of joints, connectors and markers"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def referencePosition(self) -> Array:
        """global position of the origin of the ground frame; local positions of markers count from here [3; m]"""
    @referencePosition.setter
    def referencePosition(self, value: ArrayLike) -> None: ...
    @property
    def referenceRotation(self) -> Array:
        """rotation matrix from the ground frame to the global frame [3 x 3; 1]"""
    @referenceRotation.setter
    def referenceRotation(self, value: ArrayLike) -> None: ...
    referenceHT: HT | ArrayLike
    """``referencePosition`` and ``referenceRotation`` as ``exu.HT``, or as 4 x 4 matrix"""
    @property
    def visualization(self) -> VObjectGround:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectGround | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        referencePosition: ArrayLike = [0.0, 0.0, 0.0],
        referenceRotation: ArrayLike = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        visualization: VObjectGround | dict[str, Any] = ...,
        *,
        referenceHT: HT | ArrayLike | None = None,
    ) -> None: ...

class VObjectMass1D(_Visualization):
    """Visualization of ObjectMass1D."""

    show: bool
    """False: the item is not drawn"""
    @property
    def graphicsData(self) -> list[dict[str, Any]]:
        """shapes attached to the body frame, as made by the functions of the graphics module [n]"""
    @graphicsData.setter
    def graphicsData(self, value: Sequence[dict[str, Any]]) -> None: ...
    def __init__(
        self,
        show: bool = True,
        graphicsData: Sequence[dict[str, Any]] = [],
    ) -> None: ...

class ObjectMass1D(_Object):
    """mass that is guided along a line: one translation along the local x-axis"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    physicsMass: float
    """mass; zero is allowed if something else makes the equation of the node regular [kg]"""
    mass: float
    """mass; zero is allowed if something else makes the equation of the node regular [kg]"""
    @property
    def nodeNumber(self) -> NodeIndex:
        """node with one coordinate of second order, which is the way (m) along the local x-axis"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    @property
    def referencePosition(self) -> Array:
        """global position of the body at coordinate zero [3; m]"""
    @referencePosition.setter
    def referencePosition(self, value: ArrayLike) -> None: ...
    @property
    def referenceRotation(self) -> Array:
        """constant rotation matrix from the body frame to the global frame; its first column is the direction of motion; a reflection gives a warning [3 x 3; 1]"""
    @referenceRotation.setter
    def referenceRotation(self, value: ArrayLike) -> None: ...
    @property
    def visualization(self) -> VObjectMass1D:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectMass1D | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        physicsMass: float = 0.0,
        nodeNumber: NodeIndex | int | str = -1,
        referencePosition: ArrayLike = [0.0, 0.0, 0.0],
        referenceRotation: ArrayLike = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        visualization: VObjectMass1D | dict[str, Any] = ...,
        *,
        mass: float = ...,
    ) -> None: ...

Mass1D = ObjectMass1D
VMass1D = VObjectMass1D

class VObjectMassPoint(_Visualization):
    """Visualization of ObjectMassPoint."""

    show: bool
    """False: the item is not drawn"""
    @property
    def graphicsData(self) -> list[dict[str, Any]]:
        """shapes attached to the body frame, as made by the functions of the graphics module [n]"""
    @graphicsData.setter
    def graphicsData(self, value: Sequence[dict[str, Any]]) -> None: ...
    def __init__(
        self,
        show: bool = True,
        graphicsData: Sequence[dict[str, Any]] = [],
    ) -> None: ...

class ObjectMassPoint(_Object):
    """point mass in space on a node with position"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    physicsMass: float
    """mass; zero is allowed if something else makes the equations of the node regular [kg]"""
    mass: float
    """mass; zero is allowed if something else makes the equations of the node regular [kg]"""
    @property
    def nodeNumber(self) -> NodeIndex:
        """node with a position in space and three displacement coordinates"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    @property
    def visualization(self) -> VObjectMassPoint:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectMassPoint | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        physicsMass: float = 0.0,
        nodeNumber: NodeIndex | int | str = -1,
        visualization: VObjectMassPoint | dict[str, Any] = ...,
        *,
        mass: float = ...,
    ) -> None: ...

MassPoint = ObjectMassPoint
VMassPoint = VObjectMassPoint

class VObjectMassPoint2D(_Visualization):
    """Visualization of ObjectMassPoint2D."""

    show: bool
    """False: the item is not drawn"""
    @property
    def graphicsData(self) -> list[dict[str, Any]]:
        """shapes attached to the body frame, as made by the functions of the graphics module [n]"""
    @graphicsData.setter
    def graphicsData(self, value: Sequence[dict[str, Any]]) -> None: ...
    def __init__(
        self,
        show: bool = True,
        graphicsData: Sequence[dict[str, Any]] = [],
    ) -> None: ...

class ObjectMassPoint2D(_Object):
    """point mass in the global x-y plane on a planar node"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    physicsMass: float
    """mass; zero is allowed if something else makes the equations of the node regular [kg]"""
    mass: float
    """mass; zero is allowed if something else makes the equations of the node regular [kg]"""
    @property
    def nodeNumber(self) -> NodeIndex:
        """node with a position in the plane and two displacement coordinates"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    @property
    def visualization(self) -> VObjectMassPoint2D:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectMassPoint2D | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        physicsMass: float = 0.0,
        nodeNumber: NodeIndex | int | str = -1,
        visualization: VObjectMassPoint2D | dict[str, Any] = ...,
        *,
        mass: float = ...,
    ) -> None: ...

MassPoint2D = ObjectMassPoint2D
VMassPoint2D = VObjectMassPoint2D

class VObjectRigidBody(_Visualization):
    """Visualization of ObjectRigidBody."""

    show: bool
    """False: the item is not drawn"""
    graphicsDataUserFunction: Callable[[MainSystem, int], list[dict[str, Any]]] | Literal[0]
    """function that returns the shapes to be drawn, called at every redraw; shapes are given in the frame of the body"""
    @property
    def graphicsData(self) -> list[dict[str, Any]]:
        """shapes attached to the body frame, as made by the functions of the graphics module [n]"""
    @graphicsData.setter
    def graphicsData(self, value: Sequence[dict[str, Any]]) -> None: ...
    def __init__(
        self,
        show: bool = True,
        graphicsDataUserFunction: Callable[[MainSystem, int], list[dict[str, Any]]] | Literal[0] = 0,
        graphicsData: Sequence[dict[str, Any]] = [],
    ) -> None: ...

class ObjectRigidBody(_Object):
    """rigid body in space with any center of mass, on a node with position and orientation"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    physicsMass: float
    """mass [kg]"""
    mass: float
    """mass [kg]"""
    @property
    def physicsInertia(self) -> Array:
        """components :math:`[J_{xx}, J_{yy}, J_{zz}, J_{yz}, J_{xz}, J_{xy}]` of the inertia tensor in the body frame about the reference point, which is the node, and not about the center of mass; off-diagonal components are those of the tensor, :math:`J_{xy} = -\\int x y \\,\\mathrm{d}m` [6; kg m^2]"""
    @physicsInertia.setter
    def physicsInertia(self, value: ArrayLike) -> None: ...
    @property
    def inertia(self) -> Array:
        """components :math:`[J_{xx}, J_{yy}, J_{zz}, J_{yz}, J_{xz}, J_{xy}]` of the inertia tensor in the body frame about the reference point, which is the node, and not about the center of mass; off-diagonal components are those of the tensor, :math:`J_{xy} = -\\int x y \\,\\mathrm{d}m` [6; kg m^2]"""
    @inertia.setter
    def inertia(self, value: ArrayLike) -> None: ...
    @property
    def physicsCenterOfMass(self) -> Array:
        """position of the center of mass in the body frame, counted from the node [3; m]"""
    @physicsCenterOfMass.setter
    def physicsCenterOfMass(self, value: ArrayLike) -> None: ...
    @property
    def centerOfMass(self) -> Array:
        """position of the center of mass in the body frame, counted from the node [3; m]"""
    @centerOfMass.setter
    def centerOfMass(self, value: ArrayLike) -> None: ...
    @property
    def nodeNumber(self) -> NodeIndex:
        """node of a rigid body in space"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    @property
    def visualization(self) -> VObjectRigidBody:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectRigidBody | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        physicsMass: float = 0.0,
        physicsInertia: ArrayLike = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        physicsCenterOfMass: ArrayLike = [0.0, 0.0, 0.0],
        nodeNumber: NodeIndex | int | str = -1,
        visualization: VObjectRigidBody | dict[str, Any] = ...,
        *,
        mass: float = ...,
        inertia: ArrayLike = ...,
        centerOfMass: ArrayLike = ...,
    ) -> None: ...

RigidBody = ObjectRigidBody
VRigidBody = VObjectRigidBody

class VObjectRigidBody2D(_Visualization):
    """Visualization of ObjectRigidBody2D."""

    show: bool
    """False: the item is not drawn"""
    graphicsDataUserFunction: Callable[[MainSystem, int], list[dict[str, Any]]] | Literal[0]
    """function that returns the shapes to be drawn, called at every redraw; shapes are given in the frame of the body"""
    @property
    def graphicsData(self) -> list[dict[str, Any]]:
        """shapes attached to the body frame, as made by the functions of the graphics module [n]"""
    @graphicsData.setter
    def graphicsData(self, value: Sequence[dict[str, Any]]) -> None: ...
    def __init__(
        self,
        show: bool = True,
        graphicsDataUserFunction: Callable[[MainSystem, int], list[dict[str, Any]]] | Literal[0] = 0,
        graphicsData: Sequence[dict[str, Any]] = [],
    ) -> None: ...

class ObjectRigidBody2D(_Object):
    """rigid body that moves in the global x-y plane, with any center of mass"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    physicsMass: float
    """mass [kg]"""
    mass: float
    """mass [kg]"""
    physicsInertia: float
    """moment of inertia about the z-axis through the reference point, which is the node, and not through the center of mass [kg m^2]"""
    inertia: float
    """moment of inertia about the z-axis through the reference point, which is the node, and not through the center of mass [kg m^2]"""
    @property
    def physicsCenterOfMass(self) -> Array:
        """x and y position of the center of mass in the body frame, counted from the node [2; m]"""
    @physicsCenterOfMass.setter
    def physicsCenterOfMass(self, value: ArrayLike) -> None: ...
    @property
    def centerOfMass(self) -> Array:
        """x and y position of the center of mass in the body frame, counted from the node [2; m]"""
    @centerOfMass.setter
    def centerOfMass(self, value: ArrayLike) -> None: ...
    @property
    def nodeNumber(self) -> NodeIndex:
        """node of a rigid body in the plane"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    @property
    def visualization(self) -> VObjectRigidBody2D:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectRigidBody2D | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        physicsMass: float = 0.0,
        physicsInertia: float = 0.0,
        physicsCenterOfMass: ArrayLike = [0.0, 0.0],
        nodeNumber: NodeIndex | int | str = -1,
        visualization: VObjectRigidBody2D | dict[str, Any] = ...,
        *,
        mass: float = ...,
        inertia: float = ...,
        centerOfMass: ArrayLike = ...,
    ) -> None: ...

RigidBody2D = ObjectRigidBody2D
VRigidBody2D = VObjectRigidBody2D

class VObjectRotationalMass1D(_Visualization):
    """Visualization of ObjectRotationalMass1D."""

    show: bool
    """False: the item is not drawn"""
    @property
    def graphicsData(self) -> list[dict[str, Any]]:
        """shapes attached to the body frame, as made by the functions of the graphics module [n]"""
    @graphicsData.setter
    def graphicsData(self, value: Sequence[dict[str, Any]]) -> None: ...
    def __init__(
        self,
        show: bool = True,
        graphicsData: Sequence[dict[str, Any]] = [],
    ) -> None: ...

class ObjectRotationalMass1D(_Object):
    """rotor about a fixed axis: one rotation about the local z-axis"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    physicsInertia: float
    """moment of inertia about the axis of rotation [kg m^2]"""
    inertia: float
    """moment of inertia about the axis of rotation [kg m^2]"""
    @property
    def nodeNumber(self) -> NodeIndex:
        """node with one coordinate of second order, which is the angle (rad) about the local z-axis"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    @property
    def referencePosition(self) -> Array:
        """global position of the body frame, a fixed point of the axis [3; m]"""
    @referencePosition.setter
    def referencePosition(self, value: ArrayLike) -> None: ...
    @property
    def referenceRotation(self) -> Array:
        """constant rotation matrix from the frame at angle zero to the global frame; its third column is the axis of rotation [3 x 3; 1]"""
    @referenceRotation.setter
    def referenceRotation(self, value: ArrayLike) -> None: ...
    @property
    def visualization(self) -> VObjectRotationalMass1D:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectRotationalMass1D | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        physicsInertia: float = 0.0,
        nodeNumber: NodeIndex | int | str = -1,
        referencePosition: ArrayLike = [0.0, 0.0, 0.0],
        referenceRotation: ArrayLike = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        visualization: VObjectRotationalMass1D | dict[str, Any] = ...,
        *,
        inertia: float = ...,
    ) -> None: ...

Rotor1D = ObjectRotationalMass1D
VRotor1D = VObjectRotationalMass1D

class VObjectFFRF(_Visualization):
    """Visualization of ObjectFFRF."""

    show: bool
    """False: the item is not drawn"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    @property
    def triangleMesh(self) -> NDArray[np.int32]:
        """surface triangles, one row with three positions in ``nodeNumbers`` each (counted from 0); empty: no surface is drawn [n x m]"""
    @triangleMesh.setter
    def triangleMesh(self, value: ArrayLike) -> None: ...
    showNodes: bool
    """draw the nodes of the object at their deformed positions, whether or not the nodes themselves are shown"""
    def __init__(
        self,
        show: bool = True,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
        triangleMesh: ArrayLike = [],
        showNodes: bool = False,
    ) -> None: ...

class ObjectFFRF(_Object):
    """flexible body with the nodal coordinates of a finite element mesh in a floating frame of reference"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def nodeNumbers(self) -> list[NodeIndex]:
        """first the rigid body node of the body frame, then the points of the mesh, each a NodePoint; reference positions and displacements of the latter are components in the body frame [n]"""
    @nodeNumbers.setter
    def nodeNumbers(self, value: Sequence[NodeIndex | int | str]) -> None: ...
    @property
    def massMatrixFF(self) -> MatrixContainer:
        """mass matrix of the free mesh, without the coordinates of the body frame; three rows and columns per mesh node, with the same masses in all directions [n x m; various]"""
    @massMatrixFF.setter
    def massMatrixFF(self, value: MatrixLike | None) -> None: ...
    @property
    def stiffnessMatrixFF(self) -> MatrixContainer:
        """stiffness matrix of the free mesh in the body frame; three rows and columns per mesh node [n x m; various]"""
    @stiffnessMatrixFF.setter
    def stiffnessMatrixFF(self, value: MatrixLike | None) -> None: ...
    @property
    def dampingMatrixFF(self) -> MatrixContainer:
        """damping matrix of the free mesh in the body frame; three rows and columns per mesh node, or empty for zero [n x m; various]"""
    @dampingMatrixFF.setter
    def dampingMatrixFF(self, value: MatrixLike | None) -> None: ...
    @property
    def forceVector(self) -> Array:
        """constant generalized forces on the right hand side, for body frame and mesh, in global components; those of the mesh are turned into the body frame; empty for zero [n; various]"""
    @forceVector.setter
    def forceVector(self, value: ArrayLike) -> None: ...
    forceUserFunction: Callable[[MainSystem, float, int, Array, Array], ArrayLike] | Literal[0]
    """function that gives further generalized forces on the right hand side"""
    massMatrixUserFunction: Callable[[MainSystem, float, int, Array, Array], ArrayLike] | Literal[0]
    """function that gives an additional mass matrix for all coordinates; its dependence on them is left out of the tangent"""
    computeFFRFterms: bool
    """true: inertia, stiffness and damping of rigid body motion and deformation are computed by the object; false: the user functions supply all forces and the mass matrix"""
    @property
    def coordinateIndexPerNode(self) -> list[int]:
        """index of the first coordinate of each node in the vector of the object [n]; computed"""
    objectIsInitialized: bool
    """leave it at false; the object sets it when its constant matrices are computed in ``Assemble()``, and setting it back to false has them computed anew"""
    @property
    def physicsMass(self) -> float:
        """total mass, from the mass matrix [kg]; computed"""
    @property
    def physicsInertia(self) -> Array:
        """inertia tensor of the undeformed body about the origin of the body frame, from the mass matrix [3 x 3; kg m^2]; computed"""
    @property
    def physicsCenterOfMass(self) -> Array:
        """center of mass of the undeformed body in the body frame, from the mass matrix [3; m]; computed"""
    @property
    def PHItTM(self) -> Array:
        """product of the transposed translation modes and the mass matrix, a work space of the object [n x m; various]; computed"""
    @property
    def referencePositions(self) -> Array:
        """reference positions of the mesh nodes in the body frame, three per node [n; m]; computed"""
    @property
    def tempVector(self) -> Array:
        """work space of the object [n; various]; computed"""
    @property
    def tempCoordinates(self) -> Array:
        """flexible coordinates, a work space of the object [n; m]; computed"""
    @property
    def tempCoordinates_t(self) -> Array:
        """rates of the flexible coordinates, a work space of the object [n; m/s]; computed"""
    @property
    def tempRefPosSkew(self) -> Array:
        """skew symmetric matrices of the deformed local positions, a work space of the object [n x m; m]; computed"""
    @property
    def tempVelSkew(self) -> Array:
        """skew symmetric matrices of the local velocities, a work space of the object [n x m; m/s]; computed"""
    @property
    def visualization(self) -> VObjectFFRF:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectFFRF | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        nodeNumbers: Sequence[NodeIndex | int | str] = [],
        massMatrixFF: MatrixLike | None = None,
        stiffnessMatrixFF: MatrixLike | None = None,
        dampingMatrixFF: MatrixLike | None = None,
        forceVector: ArrayLike = [],
        forceUserFunction: Callable[[MainSystem, float, int, Array, Array], ArrayLike] | Literal[0] = 0,
        massMatrixUserFunction: Callable[[MainSystem, float, int, Array, Array], ArrayLike] | Literal[0] = 0,
        computeFFRFterms: bool = True,
        objectIsInitialized: bool = False,
        visualization: VObjectFFRF | dict[str, Any] = ...,
    ) -> None: ...

class VObjectFFRFreducedOrder(_Visualization):
    """Visualization of ObjectFFRFreducedOrder."""

    show: bool
    """False: the item is not drawn"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    @property
    def triangleMesh(self) -> NDArray[np.int32]:
        """surface triangles, one row with three positions in ``nodeNumbers`` each (counted from 0); empty: no surface is drawn [n x m]"""
    @triangleMesh.setter
    def triangleMesh(self, value: ArrayLike) -> None: ...
    showNodes: bool
    """draw the mesh nodes at their deformed positions"""
    def __init__(
        self,
        show: bool = True,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
        triangleMesh: ArrayLike = [],
        showNodes: bool = False,
    ) -> None: ...

class ObjectFFRFreducedOrder(_Object):
    """flexible body with modal coordinates in a floating frame of reference"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def nodeNumbers(self) -> list[NodeIndex]:
        """two nodes: the rigid body node of the body frame, and a ``NodeGenericODE2`` with the modal coordinates, whose reference coordinates are zero [n]"""
    @nodeNumbers.setter
    def nodeNumbers(self, value: Sequence[NodeIndex | int | str]) -> None: ...
    @property
    def massMatrixReduced(self) -> MatrixContainer:
        """modal mass matrix, one row and column per mode, dense or sparse [n x m; various]"""
    @massMatrixReduced.setter
    def massMatrixReduced(self, value: MatrixLike | None) -> None: ...
    @property
    def stiffnessMatrixReduced(self) -> MatrixContainer:
        """modal stiffness matrix, one row and column per mode, dense or sparse; empty for zero [n x m; various]"""
    @stiffnessMatrixReduced.setter
    def stiffnessMatrixReduced(self, value: MatrixLike | None) -> None: ...
    @property
    def dampingMatrixReduced(self) -> MatrixContainer:
        """modal damping matrix, one row and column per mode; empty for zero [n x m; various]"""
    @dampingMatrixReduced.setter
    def dampingMatrixReduced(self, value: MatrixLike | None) -> None: ...
    forceUserFunction: Callable[[MainSystem, float, int, Array, Array], ArrayLike] | Literal[0]
    """function that gives generalized forces on the right hand side"""
    massMatrixUserFunction: Callable[[MainSystem, float, int, Array, Array], ArrayLike] | Literal[0]
    """function that gives an additional mass matrix for all coordinates; its dependence on them is left out of the tangent"""
    computeFFRFterms: bool
    """True: the object computes inertia with its coupling of rigid body motion and deformation, stiffness and damping; False: only the user functions act"""
    @property
    def modeBasis(self) -> Array:
        """one column per mode, three rows per mesh node: displacements of the mesh in the body frame for a unit modal coordinate [n x m; various]"""
    @modeBasis.setter
    def modeBasis(self, value: ArrayLike) -> None: ...
    @property
    def outputVariableModeBasis(self) -> Array:
        """values of an output variable per unit modal coordinate, one row per mesh node; each mode has six columns, its components; empty: not used [n x m; various]"""
    @outputVariableModeBasis.setter
    def outputVariableModeBasis(self, value: ArrayLike) -> None: ...
    outputVariableTypeModeBasis: OutputVariableType
    """output variable that ``outputVariableModeBasis`` holds: ``StressLocal``, ``StrainLocal``, or ``_None``"""
    @property
    def referencePositions(self) -> Array:
        """reference positions of the mesh nodes in the body frame, three per node [n; m]"""
    @referencePositions.setter
    def referencePositions(self, value: ArrayLike) -> None: ...
    objectIsInitialized: bool
    """leave it at False; ``Assemble()`` sets it, when it has found the parameters that follow from others"""
    physicsMass: float
    """total mass [kg]"""
    mass: float
    """total mass [kg]"""
    @property
    def physicsInertia(self) -> Array:
        """inertia tensor of the undeformed body about the origin of the body frame [3 x 3; kg m^2]"""
    @physicsInertia.setter
    def physicsInertia(self, value: ArrayLike) -> None: ...
    @property
    def inertia(self) -> Array:
        """inertia tensor of the undeformed body about the origin of the body frame [3 x 3; kg m^2]"""
    @inertia.setter
    def inertia(self, value: ArrayLike) -> None: ...
    @property
    def physicsCenterOfMass(self) -> Array:
        """center of mass of the undeformed body in the body frame [3; m]"""
    @physicsCenterOfMass.setter
    def physicsCenterOfMass(self, value: ArrayLike) -> None: ...
    @property
    def centerOfMass(self) -> Array:
        """center of mass of the undeformed body in the body frame [3; m]"""
    @centerOfMass.setter
    def centerOfMass(self, value: ArrayLike) -> None: ...
    @property
    def mPsiTildePsi(self) -> Array:
        """coupling of rotations and modes that changes with deformation: block :math:`i, j` is :math:`-\\int \\boldsymbol{\\psi}_i \\times \\boldsymbol{\\psi}_j\\, \\mathrm{d}m`; empty: ``Assemble()`` finds it from ``mPsiTildePsiTilde`` [n x m; various]"""
    @mPsiTildePsi.setter
    def mPsiTildePsi(self, value: ArrayLike) -> None: ...
    @property
    def mPsiTildePsiTilde(self) -> Array:
        """inertia of the deformation: block :math:`i, j` is :math:`-\\int \\tilde{\\boldsymbol{\\psi}}_i \\tilde{\\boldsymbol{\\psi}}_j\\, \\mathrm{d}m` [n x m; various]"""
    @mPsiTildePsiTilde.setter
    def mPsiTildePsiTilde(self, value: ArrayLike) -> None: ...
    @property
    def mPhitTPsi(self) -> Array:
        """coupling of translations and modes: column :math:`j` is :math:`\\int \\boldsymbol{\\psi}_j\\, \\mathrm{d}m` [n x m; various]"""
    @mPhitTPsi.setter
    def mPhitTPsi(self, value: ArrayLike) -> None: ...
    @property
    def mPhitTPsiTilde(self) -> Array:
        """the skew symmetric matrices of the columns of ``mPhitTPsi``; empty: ``Assemble()`` finds it [n x m; various]"""
    @mPhitTPsiTilde.setter
    def mPhitTPsiTilde(self, value: ArrayLike) -> None: ...
    @property
    def mXRefTildePsi(self) -> Array:
        """coupling of rotations and modes: column :math:`j` is :math:`-\\int \\mathbf{x} \\times \\boldsymbol{\\psi}_j\\, \\mathrm{d}m`; empty: ``Assemble()`` finds it from ``mXRefTildePsiTilde`` [n x m; various]"""
    @mXRefTildePsi.setter
    def mXRefTildePsi(self, value: ArrayLike) -> None: ...
    @property
    def mXRefTildePsiTilde(self) -> Array:
        """what deformation does to the inertia: block :math:`j` is :math:`-\\int \\tilde{\\mathbf{x}}\\, \\tilde{\\boldsymbol{\\psi}}_j\\, \\mathrm{d}m` [n x m; various]"""
    @mXRefTildePsiTilde.setter
    def mXRefTildePsiTilde(self, value: ArrayLike) -> None: ...
    @property
    def physicsCenterOfMassTilde(self) -> Array:
        """skew symmetric matrix of the center of mass, found by ``Assemble()`` [3 x 3; m]"""
    @physicsCenterOfMassTilde.setter
    def physicsCenterOfMassTilde(self, value: ArrayLike) -> None: ...
    @property
    def centerOfMassTilde(self) -> Array:
        """skew symmetric matrix of the center of mass, found by ``Assemble()`` [3 x 3; m]"""
    @centerOfMassTilde.setter
    def centerOfMassTilde(self, value: ArrayLike) -> None: ...
    @property
    def tempUserFunctionForce(self) -> Array:
        """user forces, a work space of the object [n; various]; computed"""
    @property
    def visualization(self) -> VObjectFFRFreducedOrder:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectFFRFreducedOrder | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        nodeNumbers: Sequence[NodeIndex | int | str] = [],
        massMatrixReduced: MatrixLike | None = None,
        stiffnessMatrixReduced: MatrixLike | None = None,
        dampingMatrixReduced: MatrixLike | None = None,
        forceUserFunction: Callable[[MainSystem, float, int, Array, Array], ArrayLike] | Literal[0] = 0,
        massMatrixUserFunction: Callable[[MainSystem, float, int, Array, Array], ArrayLike] | Literal[0] = 0,
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
        *,
        mass: float = ...,
        inertia: ArrayLike = ...,
        centerOfMass: ArrayLike = ...,
        centerOfMassTilde: ArrayLike = ...,
    ) -> None: ...

CMSobject = ObjectFFRFreducedOrder
VCMSobject = VObjectFFRFreducedOrder

class VObjectGenericODE2(_Visualization):
    """Visualization of ObjectGenericODE2."""

    show: bool
    """False: the item is not drawn"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    @property
    def triangleMesh(self) -> NDArray[np.int32]:
        """surface triangles, one row with three positions in ``nodeNumbers`` each (counted from 0); empty: no surface is drawn [n x m]"""
    @triangleMesh.setter
    def triangleMesh(self, value: ArrayLike) -> None: ...
    showNodes: bool
    """draw the nodes of the object at their deformed positions, whether or not the nodes themselves are shown"""
    graphicsDataUserFunction: Callable[[MainSystem, int], list[dict[str, Any]]] | Literal[0]
    """function that returns the shapes to be drawn, called at every redraw; shapes are given in the global frame"""
    def __init__(
        self,
        show: bool = True,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
        triangleMesh: ArrayLike = [],
        showNodes: bool = False,
        graphicsDataUserFunction: Callable[[MainSystem, int], list[dict[str, Any]]] | Literal[0] = 0,
    ) -> None: ...

class ObjectGenericODE2(_Object):
    """system of second order differential equations with constant matrices and user functions, on any nodes"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def nodeNumbers(self) -> list[NodeIndex]:
        """nodes with second order coordinates; their coordinates in this order form the vector of the object [n]"""
    @nodeNumbers.setter
    def nodeNumbers(self, value: Sequence[NodeIndex | int | str]) -> None: ...
    @property
    def massMatrix(self) -> MatrixContainer:
        """constant mass matrix; n rows and n columns for n coordinates, dense or sparse, or empty for zero; other sizes are refused [n x m; various]"""
    @massMatrix.setter
    def massMatrix(self, value: MatrixLike | None) -> None: ...
    @property
    def stiffnessMatrix(self) -> MatrixContainer:
        """constant stiffness matrix; n rows and n columns, or empty for zero; dense or sparse, in the same form as the damping matrix [n x m; various]"""
    @stiffnessMatrix.setter
    def stiffnessMatrix(self, value: MatrixLike | None) -> None: ...
    @property
    def dampingMatrix(self) -> MatrixContainer:
        """constant damping matrix; n rows and n columns, or empty for zero; dense or sparse, in the same form as the stiffness matrix [n x m; various]"""
    @dampingMatrix.setter
    def dampingMatrix(self, value: MatrixLike | None) -> None: ...
    @property
    def forceVector(self) -> Array:
        """constant generalized forces on the right hand side; length n, or empty for zero [n; various]"""
    @forceVector.setter
    def forceVector(self, value: ArrayLike) -> None: ...
    forceUserFunction: Callable[[MainSystem, float, int, Array, Array], ArrayLike] | Literal[0]
    """function that gives further generalized forces on the right hand side"""
    massMatrixUserFunction: Callable[[MainSystem, float, int, Array, Array], MatrixLike] | Literal[0]
    """function that gives the mass matrix; it replaces ``massMatrix``"""
    jacobianUserFunction: Callable[[MainSystem, float, int, Array, Array, float, float], MatrixLike] | Literal[0]
    """function that returns the derivatives of the user forces; the default is numerical differentiation"""
    @property
    def coordinateIndexPerNode(self) -> list[int]:
        """index of the first coordinate of each node in the vector of the object [n]; computed"""
    @property
    def tempCoordinates(self) -> Array:
        """coordinates, a work space of the object [n; various]; computed"""
    @property
    def tempCoordinates_t(self) -> Array:
        """velocities, a work space of the object [n; various]; computed"""
    @property
    def tempCoordinates_tt(self) -> Array:
        """accelerations, a work space of the object [n; various]; computed"""
    @property
    def visualization(self) -> VObjectGenericODE2:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectGenericODE2 | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        nodeNumbers: Sequence[NodeIndex | int | str] = [],
        massMatrix: MatrixLike | None = None,
        stiffnessMatrix: MatrixLike | None = None,
        dampingMatrix: MatrixLike | None = None,
        forceVector: ArrayLike = [],
        forceUserFunction: Callable[[MainSystem, float, int, Array, Array], ArrayLike] | Literal[0] = 0,
        massMatrixUserFunction: Callable[[MainSystem, float, int, Array, Array], MatrixLike] | Literal[0] = 0,
        jacobianUserFunction: Callable[[MainSystem, float, int, Array, Array, float, float], MatrixLike] | Literal[0] = 0,
        visualization: VObjectGenericODE2 | dict[str, Any] = ...,
    ) -> None: ...

class VObjectKinematicTree(_Visualization):
    """Visualization of ObjectKinematicTree."""

    show: bool
    """False: the item is not drawn"""
    showLinks: bool
    """draw the links, as given by ``graphicsDataList`` or, if that is empty, as cylinders between the joints"""
    showJoints: bool
    """draw the joints in a standard form; only if ``graphicsDataList`` is empty"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    @property
    def graphicsDataList(self) -> list[list[dict[str, Any]]]:
        """a list of shapes in the frame of the link; empty, or as long as there are links [n x m]"""
    @graphicsDataList.setter
    def graphicsDataList(self, value: Sequence[Sequence[dict[str, Any]]]) -> None: ...
    def __init__(
        self,
        show: bool = True,
        showLinks: bool = True,
        showJoints: bool = True,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
        graphicsDataList: Sequence[Sequence[dict[str, Any]]] = [],
    ) -> None: ...

class ObjectKinematicTree(_Object):
    """open tree of rigid bodies in minimal coordinates, one joint coordinate per link"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def nodeNumber(self) -> NodeIndex:
        """generic node of second order with one coordinate per joint: rad for revolute, m for prismatic joints"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    @property
    def gravity(self) -> Array:
        """gravity in global components; mass proportional loads do not act on this object [3; m/s^2]"""
    @gravity.setter
    def gravity(self, value: ArrayLike) -> None: ...
    @property
    def baseOffset(self) -> Array:
        """global position of the base frame [3; m]"""
    @baseOffset.setter
    def baseOffset(self, value: ArrayLike) -> None: ...
    @property
    def jointTypes(self) -> list[JointType]:
        """type of each joint, one per link; required [n]"""
    @jointTypes.setter
    def jointTypes(self, value: Sequence[JointType]) -> None: ...
    @property
    def linkParents(self) -> list[int]:
        """number of the parent link of each link, -1 for the base; a parent has a smaller number than its links; required [n]"""
    @linkParents.setter
    def linkParents(self, value: Sequence[int]) -> None: ...
    @property
    def jointTransformations(self) -> Matrix3DList:
        """the rotation matrix from its joint frame, at coordinate zero, to the frame of the parent; required [n x 3 x 3; 1]"""
    @jointTransformations.setter
    def jointTransformations(self, value: Sequence[ArrayLike] | Matrix3DList) -> None: ...
    @property
    def jointOffsets(self) -> Vector3DList:
        """the origin of its joint frame in the frame of the parent, for the base in the base frame; required [n x 3; m]"""
    @jointOffsets.setter
    def jointOffsets(self, value: Sequence[ArrayLike] | Vector3DList) -> None: ...
    @property
    def linkInertiasCOM(self) -> Matrix3DList:
        """the inertia tensor about its center of mass, in the frame of the link; required [n x 3 x 3; kg m^2]"""
    @linkInertiasCOM.setter
    def linkInertiasCOM(self, value: Sequence[ArrayLike] | Matrix3DList) -> None: ...
    @property
    def linkCOMs(self) -> Vector3DList:
        """the center of mass in the frame of the link; required [n x 3; m]"""
    @linkCOMs.setter
    def linkCOMs(self, value: Sequence[ArrayLike] | Vector3DList) -> None: ...
    @property
    def linkMasses(self) -> Array:
        """mass of each link; required [n; kg]"""
    @linkMasses.setter
    def linkMasses(self, value: ArrayLike) -> None: ...
    @property
    def linkForces(self) -> Vector3DList:
        """a force in global components at the origin of its joint frame; empty for zero [n x 3; N]"""
    @linkForces.setter
    def linkForces(self, value: Sequence[ArrayLike] | Vector3DList) -> None: ...
    @property
    def linkTorques(self) -> Vector3DList:
        """a torque in global components; empty for zero [n x 3; Nm]"""
    @linkTorques.setter
    def linkTorques(self, value: Sequence[ArrayLike] | Vector3DList) -> None: ...
    @property
    def jointForceVector(self) -> Array:
        """a torque (Nm) or force (N) about or along its axis, positive on the link and negative on its parent; empty for zero [n; various]"""
    @jointForceVector.setter
    def jointForceVector(self, value: ArrayLike) -> None: ...
    @property
    def jointPositionOffsetVector(self) -> Array:
        """desired joint coordinates of the position control (rad or m); empty for zero [n; various]"""
    @jointPositionOffsetVector.setter
    def jointPositionOffsetVector(self, value: ArrayLike) -> None: ...
    @property
    def jointVelocityOffsetVector(self) -> Array:
        """desired joint velocities of the velocity control (rad/s or m/s); empty for zero [n; various]"""
    @jointVelocityOffsetVector.setter
    def jointVelocityOffsetVector(self, value: ArrayLike) -> None: ...
    @property
    def jointPControlVector(self) -> Array:
        """proportional gain of each joint (Nm/rad or N/m); empty for zero [n; various]"""
    @jointPControlVector.setter
    def jointPControlVector(self, value: ArrayLike) -> None: ...
    @property
    def jointDControlVector(self) -> Array:
        """derivative gain of each joint (Nm s/rad or Ns/m); empty for zero [n; various]"""
    @jointDControlVector.setter
    def jointDControlVector(self, value: ArrayLike) -> None: ...
    forceUserFunction: Callable[[MainSystem, float, int, Array, Array], ArrayLike] | Literal[0]
    """function that gives further joint forces, which act as those of ``jointForceVector``"""
    @property
    def linkNames(self) -> list[str]:
        """a name, which may stand wherever the number of a link is asked for, or an empty string; empty for no names [n]"""
    @linkNames.setter
    def linkNames(self, value: Sequence[str]) -> None: ...
    @property
    def jointNames(self) -> list[str]:
        """a name, which may stand for the number of the joint and for that of the link which it carries, or an empty string; empty for no names [n]"""
    @jointNames.setter
    def jointNames(self, value: Sequence[str]) -> None: ...
    jointHTs: Sequence[HT]
    """``jointOffsets`` and ``jointTransformations`` as ``exu.HT``, or as 4 x 4 matrix"""
    @property
    def visualization(self) -> VObjectKinematicTree:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectKinematicTree | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        nodeNumber: NodeIndex | int | str = -1,
        gravity: ArrayLike = [0.0, 0.0, 0.0],
        baseOffset: ArrayLike = [0.0, 0.0, 0.0],
        jointTypes: Sequence[JointType] = [],
        linkParents: Sequence[int] = [],
        jointTransformations: Sequence[ArrayLike] | Matrix3DList = [],
        jointOffsets: Sequence[ArrayLike] | Vector3DList = [],
        linkInertiasCOM: Sequence[ArrayLike] | Matrix3DList = [],
        linkCOMs: Sequence[ArrayLike] | Vector3DList = [],
        linkMasses: ArrayLike = [],
        linkForces: Sequence[ArrayLike] | Vector3DList = [],
        linkTorques: Sequence[ArrayLike] | Vector3DList = [],
        jointForceVector: ArrayLike = [],
        jointPositionOffsetVector: ArrayLike = [],
        jointVelocityOffsetVector: ArrayLike = [],
        jointPControlVector: ArrayLike = [],
        jointDControlVector: ArrayLike = [],
        forceUserFunction: Callable[[MainSystem, float, int, Array, Array], ArrayLike] | Literal[0] = 0,
        linkNames: Sequence[str] = [],
        jointNames: Sequence[str] = [],
        visualization: VObjectKinematicTree | dict[str, Any] = ...,
        *,
        jointHTs: Sequence[HT] | None = None,
    ) -> None: ...

KinematicTree = ObjectKinematicTree
VKinematicTree = VObjectKinematicTree

class VObjectALEANCFCable2D(_Visualization):
    """Visualization of ObjectALEANCFCable2D."""

    show: bool
    """False: the item is not drawn"""
    drawHeight: float
    """height of the rectangle that is drawn; 0 draws the axis only [m]"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    def __init__(
        self,
        show: bool = True,
        drawHeight: float = 0.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...

class ObjectALEANCFCable2D(_Object):
    """planar cable through which material moves along the axis, on two nodes with slope and one node with the axial coordinate"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    physicsLength: float
    """length of the element in its undeformed state; must be positive [m]"""
    length: float
    """length of the element in its undeformed state; must be positive [m]"""
    physicsMassPerLength: float
    """total mass per undeformed length, of the resting and the moving part [kg/m]"""
    massPerLength: float
    """total mass per undeformed length, of the resting and the moving part [kg/m]"""
    physicsMovingMassFactor: float
    """share of the mass per length that moves along the axis: 1: axially moving beam, 0: no motion; a pipe with fluid lies between [1]"""
    movingMassFactor: float
    """share of the mass per length that moves along the axis: 1: axially moving beam, 0: no motion; a pipe with fluid lies between [1]"""
    physicsBendingStiffness: float
    """bending stiffness: bending moment per curvature [N m^2]"""
    bendingStiffness: float
    """bending stiffness: bending moment per curvature [N m^2]"""
    physicsAxialStiffness: float
    """axial stiffness: axial force per axial strain [N]"""
    axialStiffness: float
    """axial stiffness: axial force per axial strain [N]"""
    physicsBendingDamping: float
    """viscous damping of bending: bending moment per rate of curvature [N m^2 s]"""
    bendingDamping: float
    """viscous damping of bending: bending moment per rate of curvature [N m^2 s]"""
    physicsAxialDamping: float
    """viscous damping of stretching: axial force per rate of axial strain [N s]"""
    axialDamping: float
    """viscous damping of stretching: axial force per rate of axial strain [N s]"""
    physicsReferenceAxialStrain: float
    """axial strain at which the axial force is zero [1]"""
    referenceAxialStrain: float
    """axial strain at which the axial force is zero [1]"""
    physicsReferenceCurvature: float
    """curvature at which the bending moment is zero; positive for a left turn along the axis [1/m]"""
    referenceCurvature: float
    """curvature at which the bending moment is zero; positive for a left turn along the axis [1/m]"""
    physicsUseCouplingTerms: bool
    """true: all inertia terms of the axial motion act; false: accelerations of cable and axial coordinate are not coupled, and the latter has a constant mass"""
    useCouplingTerms: bool
    """true: all inertia terms of the axial motion act; false: accelerations of cable and axial coordinate are not coupled, and the latter has a constant mass"""
    physicsAddALEvariation: bool
    """true: the axial coordinate feels the change of strain and curvature energy that its motion brings about; false: this term is left out"""
    addALEvariation: bool
    """true: the axial coordinate feels the change of strain and curvature energy that its motion brings about; false: this term is left out"""
    @property
    def nodeNumbers(self) -> list[NodeIndex]:
        """node at axial position 0, node at axial position L (both with position and slope in the plane), and a generic node of second order whose coordinate is the axial displacement of the material [3]"""
    @nodeNumbers.setter
    def nodeNumbers(self, value: Sequence[NodeIndex | int | str]) -> None: ...
    useReducedOrderIntegration: int
    """integration of the elastic forces along the axis: 0: 5 Gauss points for stretching and 3 for bending; 1: 4 and 2; 2: 3 Lobatto points for stretching and 2 Gauss points for bending"""
    strainIsRelativeToReference: float
    """share of the strains of the reference configuration that are free of stress: 0 for an element that is straight and of length L without stress, 1 for a reference configuration without stress; values between serve for a transition [1]"""
    @property
    def visualization(self) -> VObjectALEANCFCable2D:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectALEANCFCable2D | dict[str, Any]) -> None: ...
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
        nodeNumbers: Sequence[NodeIndex | int | str] = [-1, -1, -1],
        useReducedOrderIntegration: int = 0,
        strainIsRelativeToReference: float = 0.0,
        visualization: VObjectALEANCFCable2D | dict[str, Any] = ...,
        *,
        length: float = ...,
        massPerLength: float = ...,
        movingMassFactor: float = ...,
        bendingStiffness: float = ...,
        axialStiffness: float = ...,
        bendingDamping: float = ...,
        axialDamping: float = ...,
        referenceAxialStrain: float = ...,
        referenceCurvature: float = ...,
        useCouplingTerms: bool = ...,
        addALEvariation: bool = ...,
    ) -> None: ...

ALECable2D = ObjectALEANCFCable2D
VALECable2D = VObjectALEANCFCable2D

class VObjectANCFBeam(_Visualization):
    """Visualization of ObjectANCFBeam."""

    show: bool
    """False: the item is not drawn"""
    sectionGeometry: BeamSectionGeometry
    """outline of the cross section for drawing and contact, as a ``BeamSectionGeometry``"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    def __init__(
        self,
        show: bool = True,
        sectionGeometry: BeamSectionGeometry = ...,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...

class ObjectANCFBeam(_Object):
    """spatial beam with shear and cross section deformation, on two nodes with position and two slopes"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def nodeNumbers(self) -> list[NodeIndex]:
        """node at the negative and node at the positive end of the axis, each with position and the slopes of the cross section [2]"""
    @nodeNumbers.setter
    def nodeNumbers(self, value: Sequence[NodeIndex | int | str]) -> None: ...
    physicsLength: float
    """length of the element in its undeformed state; must be positive [m]"""
    length: float
    """length of the element in its undeformed state; must be positive [m]"""
    sectionData: BeamSection
    """cross section with inertia, stiffness and damping matrices, as a ``BeamSection``"""
    @property
    def crossSectionPenaltyFactor(self) -> Array:
        """factors of the stiffness against stretching of the cross section in y and z (times the axial stiffness) and against its distortion (times the sum of the shear stiffnesses) [3; 1]"""
    @crossSectionPenaltyFactor.setter
    def crossSectionPenaltyFactor(self, value: ArrayLike) -> None: ...
    @property
    def crossSectionDamping(self) -> Array:
        """damping of the same deformations, as factors of the stiffness; 0 for none [3; s]"""
    @crossSectionDamping.setter
    def crossSectionDamping(self, value: ArrayLike) -> None: ...
    @property
    def visualization(self) -> VObjectANCFBeam:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectANCFBeam | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        nodeNumbers: Sequence[NodeIndex | int | str] = [-1, -1],
        physicsLength: float = 0.0,
        sectionData: BeamSection = ...,
        crossSectionPenaltyFactor: ArrayLike = [1.0, 1.0, 1.0],
        crossSectionDamping: ArrayLike = [0.0, 0.0, 0.0],
        visualization: VObjectANCFBeam | dict[str, Any] = ...,
        *,
        length: float = ...,
    ) -> None: ...

ANCFBeam = ObjectANCFBeam
VANCFBeam = VObjectANCFBeam

class VObjectANCFCable(_Visualization):
    """Visualization of ObjectANCFCable."""

    show: bool
    """False: the item is not drawn"""
    radius: float
    """radius of the cylinder that is drawn; 0 draws the axis only [m]"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    def __init__(
        self,
        show: bool = True,
        radius: float = 0.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...

class ObjectANCFCable(_Object):
    """spatial cable or thin beam without torsion and shear deformation, on two nodes with position and slope"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    physicsLength: float
    """length of the element in its undeformed state; must be positive [m]"""
    length: float
    """length of the element in its undeformed state; must be positive [m]"""
    physicsMassPerLength: float
    """mass per undeformed length [kg/m]"""
    massPerLength: float
    """mass per undeformed length [kg/m]"""
    physicsBendingStiffness: float
    """bending stiffness: bending moment per curvature [N m^2]"""
    bendingStiffness: float
    """bending stiffness: bending moment per curvature [N m^2]"""
    physicsAxialStiffness: float
    """axial stiffness: axial force per axial strain [N]"""
    axialStiffness: float
    """axial stiffness: axial force per axial strain [N]"""
    physicsBendingDamping: float
    """viscous damping of bending: bending moment per rate of curvature [N m^2 s]"""
    bendingDamping: float
    """viscous damping of bending: bending moment per rate of curvature [N m^2 s]"""
    physicsAxialDamping: float
    """viscous damping of stretching: axial force per rate of axial strain [N s]"""
    axialDamping: float
    """viscous damping of stretching: axial force per rate of axial strain [N s]"""
    physicsReferenceAxialStrain: float
    """axial strain at which the axial force is zero [1]"""
    referenceAxialStrain: float
    """axial strain at which the axial force is zero [1]"""
    strainIsRelativeToReference: float
    """share of the strains of the reference configuration that are free of stress: 0 for an element that is straight and of length L without stress, 1 for a reference configuration without stress; values between serve for a transition [1]"""
    @property
    def nodeNumbers(self) -> list[NodeIndex]:
        """node at axial position 0 and node at axial position L, both with position and one slope [2]"""
    @nodeNumbers.setter
    def nodeNumbers(self, value: Sequence[NodeIndex | int | str]) -> None: ...
    useReducedOrderIntegration: int
    """integration of the elastic forces along the axis: 0: 5 Gauss points for stretching and 3 for bending; 1: 4 and 2; 2: 3 Lobatto points for stretching and 2 Gauss points for bending, with smoother axial forces but possibly modes without stiffness"""
    @property
    def visualization(self) -> VObjectANCFCable:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectANCFCable | dict[str, Any]) -> None: ...
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
        nodeNumbers: Sequence[NodeIndex | int | str] = [-1, -1],
        useReducedOrderIntegration: int = 0,
        visualization: VObjectANCFCable | dict[str, Any] = ...,
        *,
        length: float = ...,
        massPerLength: float = ...,
        bendingStiffness: float = ...,
        axialStiffness: float = ...,
        bendingDamping: float = ...,
        axialDamping: float = ...,
        referenceAxialStrain: float = ...,
    ) -> None: ...

Cable = ObjectANCFCable
VCable = VObjectANCFCable

class VObjectANCFCable2D(_Visualization):
    """Visualization of ObjectANCFCable2D."""

    show: bool
    """False: the item is not drawn"""
    drawHeight: float
    """height of the rectangle that is drawn; 0 draws the axis only [m]"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    def __init__(
        self,
        show: bool = True,
        drawHeight: float = 0.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...

class ObjectANCFCable2D(_Object):
    """planar cable or thin beam without shear deformation for large deformation, on two nodes with position and slope"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    physicsLength: float
    """length of the element in its undeformed state; must be positive [m]"""
    length: float
    """length of the element in its undeformed state; must be positive [m]"""
    physicsMassPerLength: float
    """mass per undeformed length [kg/m]"""
    massPerLength: float
    """mass per undeformed length [kg/m]"""
    physicsBendingStiffness: float
    """bending stiffness: bending moment per curvature [N m^2]"""
    bendingStiffness: float
    """bending stiffness: bending moment per curvature [N m^2]"""
    physicsAxialStiffness: float
    """axial stiffness: axial force per axial strain [N]"""
    axialStiffness: float
    """axial stiffness: axial force per axial strain [N]"""
    physicsBendingDamping: float
    """viscous damping of bending: bending moment per rate of curvature [N m^2 s]"""
    bendingDamping: float
    """viscous damping of bending: bending moment per rate of curvature [N m^2 s]"""
    physicsAxialDamping: float
    """viscous damping of stretching: axial force per rate of axial strain [N s]"""
    axialDamping: float
    """viscous damping of stretching: axial force per rate of axial strain [N s]"""
    physicsReferenceAxialStrain: float
    """axial strain at which the axial force is zero [1]"""
    referenceAxialStrain: float
    """axial strain at which the axial force is zero [1]"""
    physicsReferenceCurvature: float
    """curvature at which the bending moment is zero; positive for a left turn along the axis [1/m]"""
    referenceCurvature: float
    """curvature at which the bending moment is zero; positive for a left turn along the axis [1/m]"""
    strainIsRelativeToReference: float
    """share of the strains of the reference configuration that are free of stress: 0 for an element that is straight and of length L without stress, 1 for a reference configuration without stress; values between serve for a transition [1]"""
    @property
    def nodeNumbers(self) -> list[NodeIndex]:
        """node at axial position 0 and node at axial position L, both with position and slope in the plane [2]"""
    @nodeNumbers.setter
    def nodeNumbers(self, value: Sequence[NodeIndex | int | str]) -> None: ...
    useReducedOrderIntegration: int
    """integration of the elastic forces along the axis: 0: 5 Gauss points for stretching and 3 for bending; 1: 4 and 2; 2: 3 Lobatto points for stretching and 2 Gauss points for bending, with smoother axial forces but possibly modes without stiffness"""
    axialForceUserFunction: Callable[[MainSystem, float, int, float, float, float, float, float, float, float, float, float], float] | Literal[0]
    """function that gives the axial force in place of the linear law"""
    bendingMomentUserFunction: Callable[[MainSystem, float, int, float, float, float, float, float, float, float, float, float], float] | Literal[0]
    """function that gives the bending moment in place of the linear law"""
    @property
    def visualization(self) -> VObjectANCFCable2D:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectANCFCable2D | dict[str, Any]) -> None: ...
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
        nodeNumbers: Sequence[NodeIndex | int | str] = [-1, -1],
        useReducedOrderIntegration: int = 0,
        axialForceUserFunction: Callable[[MainSystem, float, int, float, float, float, float, float, float, float, float, float], float] | Literal[0] = 0,
        bendingMomentUserFunction: Callable[[MainSystem, float, int, float, float, float, float, float, float, float, float, float], float] | Literal[0] = 0,
        visualization: VObjectANCFCable2D | dict[str, Any] = ...,
        *,
        length: float = ...,
        massPerLength: float = ...,
        bendingStiffness: float = ...,
        axialStiffness: float = ...,
        bendingDamping: float = ...,
        axialDamping: float = ...,
        referenceAxialStrain: float = ...,
        referenceCurvature: float = ...,
    ) -> None: ...

Cable2D = ObjectANCFCable2D
VCable2D = VObjectANCFCable2D

class VObjectANCFThinPlate(_Visualization):
    """Visualization of ObjectANCFThinPlate."""

    show: bool
    """False: the item is not drawn"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    def __init__(
        self,
        show: bool = True,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...

class ObjectANCFThinPlate(_Object):
    """thin plate without shear deformation, on four nodes with position and two slopes"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def physicsThickness(self) -> Array:
        """thickness of the plate: a value, or interpolated values of the nodes [n; m]"""
    @physicsThickness.setter
    def physicsThickness(self, value: ArrayLike) -> None: ...
    @property
    def thickness(self) -> Array:
        """thickness of the plate: a value, or interpolated values of the nodes [n; m]"""
    @thickness.setter
    def thickness(self, value: ArrayLike) -> None: ...
    physicsDensity: float
    """mass per volume [kg/m^3]"""
    density: float
    """mass per volume [kg/m^3]"""
    physicsMassProportionalDamping: float
    """damping forces are this factor times mass matrix times velocity [1/s]"""
    massProportionalDamping: float
    """damping forces are this factor times mass matrix times velocity [1/s]"""
    @property
    def physicsStrainCoefficients(self) -> Matrix3DList:
        """stiffness against the strains in the plane, integrated over the thickness; a matrix, or one per node [n x 3 x 3; N/m]"""
    @physicsStrainCoefficients.setter
    def physicsStrainCoefficients(self, value: Sequence[ArrayLike] | Matrix3DList) -> None: ...
    @property
    def strainCoefficients(self) -> Matrix3DList:
        """stiffness against the strains in the plane, integrated over the thickness; a matrix, or one per node [n x 3 x 3; N/m]"""
    @strainCoefficients.setter
    def strainCoefficients(self, value: Sequence[ArrayLike] | Matrix3DList) -> None: ...
    @property
    def physicsCurvatureCoefficients(self) -> Matrix3DList:
        """stiffness against curvatures and twist, integrated over the thickness; a matrix, or one per node [n x 3 x 3; Nm]"""
    @physicsCurvatureCoefficients.setter
    def physicsCurvatureCoefficients(self, value: Sequence[ArrayLike] | Matrix3DList) -> None: ...
    @property
    def curvatureCoefficients(self) -> Matrix3DList:
        """stiffness against curvatures and twist, integrated over the thickness; a matrix, or one per node [n x 3 x 3; Nm]"""
    @curvatureCoefficients.setter
    def curvatureCoefficients(self, value: Sequence[ArrayLike] | Matrix3DList) -> None: ...
    strainIsRelativeToReference: float
    """share of the strains of the reference configuration that are free of stress: 0 for a plate that is flat without stress, 1 for a reference configuration without stress [1]"""
    @property
    def slopesScalingX(self) -> Array:
        """for each node the length of the side in x that belongs to a unit slope, the distance of the nodes for a flat rectangle; not positive: that distance [4; m]"""
    @slopesScalingX.setter
    def slopesScalingX(self, value: ArrayLike) -> None: ...
    @property
    def slopesScalingY(self) -> Array:
        """for each node the length of the side in y that belongs to a unit slope; not positive: the distance of the nodes [4; m]"""
    @slopesScalingY.setter
    def slopesScalingY(self, value: ArrayLike) -> None: ...
    @property
    def nodeNumbers(self) -> list[NodeIndex]:
        """four nodes with position and two slopes, at the local corners (-1, -1), (1, -1), (1, 1), (-1, 1) [4]"""
    @nodeNumbers.setter
    def nodeNumbers(self, value: Sequence[NodeIndex | int | str]) -> None: ...
    useReducedOrderIntegration: int
    """integration of the elastic forces: 0: 4 by 4 Gauss points, 1: 3 by 3"""
    stiffnessProportionalDamping: float
    """membrane forces of damping are this factor times membrane stiffness times strain rates [s]"""
    bendingStiffnessProportionalDamping: float
    """the same for bending stiffness and rates of curvature; negative: ``stiffnessProportionalDamping`` [s]"""
    @property
    def visualization(self) -> VObjectANCFThinPlate:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectANCFThinPlate | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        physicsThickness: ArrayLike = [],
        physicsDensity: float = 0.0,
        physicsMassProportionalDamping: float = 0.0,
        physicsStrainCoefficients: Sequence[ArrayLike] | Matrix3DList = [],
        physicsCurvatureCoefficients: Sequence[ArrayLike] | Matrix3DList = [],
        strainIsRelativeToReference: float = 1.0,
        slopesScalingX: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
        slopesScalingY: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
        nodeNumbers: Sequence[NodeIndex | int | str] = [-1, -1, -1, -1],
        useReducedOrderIntegration: int = 0,
        stiffnessProportionalDamping: float = 0.0,
        bendingStiffnessProportionalDamping: float = -1.0,
        visualization: VObjectANCFThinPlate | dict[str, Any] = ...,
        *,
        thickness: ArrayLike = ...,
        density: float = ...,
        massProportionalDamping: float = ...,
        strainCoefficients: Sequence[ArrayLike] | Matrix3DList = ...,
        curvatureCoefficients: Sequence[ArrayLike] | Matrix3DList = ...,
    ) -> None: ...

class VObjectBeamGeometricallyExact(_Visualization):
    """Visualization of ObjectBeamGeometricallyExact."""

    show: bool
    """False: the item is not drawn"""
    sectionGeometry: BeamSectionGeometry
    """outline of the cross section for drawing and contact, as a ``BeamSectionGeometry``"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    def __init__(
        self,
        show: bool = True,
        sectionGeometry: BeamSectionGeometry = ...,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...

class ObjectBeamGeometricallyExact(_Object):
    """spatial geometrically exact beam with shear deformation, on two rigid body nodes"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def nodeNumbers(self) -> list[NodeIndex]:
        """node at the negative and node at the positive end of the axis, both with position and orientation [2]"""
    @nodeNumbers.setter
    def nodeNumbers(self, value: Sequence[NodeIndex | int | str]) -> None: ...
    physicsLength: float
    """length of the element in its undeformed state; must be positive [m]"""
    length: float
    """length of the element in its undeformed state; must be positive [m]"""
    sectionData: BeamSection
    """cross section with inertia, stiffness and damping matrices, as a ``BeamSection``"""
    @property
    def visualization(self) -> VObjectBeamGeometricallyExact:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectBeamGeometricallyExact | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        nodeNumbers: Sequence[NodeIndex | int | str] = [-1, -1],
        physicsLength: float = 0.0,
        sectionData: BeamSection = ...,
        visualization: VObjectBeamGeometricallyExact | dict[str, Any] = ...,
        *,
        length: float = ...,
    ) -> None: ...

Beam3D = ObjectBeamGeometricallyExact
VBeam3D = VObjectBeamGeometricallyExact

class VObjectBeamGeometricallyExact2D(_Visualization):
    """Visualization of ObjectBeamGeometricallyExact2D."""

    show: bool
    """False: the item is not drawn"""
    drawHeight: float
    """height of the rectangle that is drawn; 0 draws the axis only [m]"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    def __init__(
        self,
        show: bool = True,
        drawHeight: float = 0.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...

class ObjectBeamGeometricallyExact2D(_Object):
    """planar geometrically exact beam with shear deformation, on two or three rigid body nodes"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def nodeNumbers(self) -> list[NodeIndex]:
        """two or three nodes of rigid bodies in the plane, in the order in which they follow along the axis [n]"""
    @nodeNumbers.setter
    def nodeNumbers(self, value: Sequence[NodeIndex | int | str]) -> None: ...
    physicsLength: float
    """length of the element in its undeformed state; must be positive [m]"""
    length: float
    """length of the element in its undeformed state; must be positive [m]"""
    physicsMassPerLength: float
    """mass per undeformed length [kg/m]"""
    massPerLength: float
    """mass per undeformed length [kg/m]"""
    physicsCrossSectionInertia: float
    """mass moment of inertia of the cross section per length, against its rotation [kg m]"""
    crossSectionInertia: float
    """mass moment of inertia of the cross section per length, against its rotation [kg m]"""
    physicsBendingStiffness: float
    """bending stiffness: bending moment per curvature [N m^2]"""
    bendingStiffness: float
    """bending stiffness: bending moment per curvature [N m^2]"""
    physicsAxialStiffness: float
    """axial stiffness: axial force per axial strain [N]"""
    axialStiffness: float
    """axial stiffness: axial force per axial strain [N]"""
    physicsShearStiffness: float
    """shear stiffness, including the shear correction factor [N]"""
    shearStiffness: float
    """shear stiffness, including the shear correction factor [N]"""
    physicsBendingDamping: float
    """viscous damping of bending: bending moment per rate of curvature [N m^2 s]"""
    bendingDamping: float
    """viscous damping of bending: bending moment per rate of curvature [N m^2 s]"""
    physicsAxialDamping: float
    """viscous damping of stretching: axial force per rate of axial strain [N s]"""
    axialDamping: float
    """viscous damping of stretching: axial force per rate of axial strain [N s]"""
    physicsShearDamping: float
    """viscous damping of shear: shear force per rate of shear strain [N s]"""
    shearDamping: float
    """viscous damping of shear: shear force per rate of shear strain [N s]"""
    physicsReferenceCurvature: float
    """curvature at which the bending moment is zero [1/m]"""
    referenceCurvature: float
    """curvature at which the bending moment is zero [1/m]"""
    includeReferenceRotations: bool
    """true: the reference angles of the nodes are the angles of the cross sections; false: only rotations relative to the reference configuration count, and the cross sections are normal to the reference axis"""
    @property
    def visualization(self) -> VObjectBeamGeometricallyExact2D:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectBeamGeometricallyExact2D | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        nodeNumbers: Sequence[NodeIndex | int | str] = [],
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
        *,
        length: float = ...,
        massPerLength: float = ...,
        crossSectionInertia: float = ...,
        bendingStiffness: float = ...,
        axialStiffness: float = ...,
        shearStiffness: float = ...,
        bendingDamping: float = ...,
        axialDamping: float = ...,
        shearDamping: float = ...,
        referenceCurvature: float = ...,
    ) -> None: ...

Beam2D = ObjectBeamGeometricallyExact2D
VBeam2D = VObjectBeamGeometricallyExact2D

class VObjectConnectorCartesianSpringDamper(_Visualization):
    """Visualization of ObjectConnectorCartesianSpringDamper."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...

class ObjectConnectorCartesianSpringDamper(_Object):
    """Three springs and dampers that act between two points in the directions of the global axes"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def markerNumbers(self) -> list[MarkerIndex]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def stiffness(self) -> Array:
        """stiffness in global x, y and z direction [3; N/m]"""
    @stiffness.setter
    def stiffness(self, value: ArrayLike) -> None: ...
    @property
    def damping(self) -> Array:
        """damping coefficient in global x, y and z direction [3; Ns/m]"""
    @damping.setter
    def damping(self, value: ArrayLike) -> None: ...
    @property
    def offset(self) -> Array:
        """global position of marker m1 relative to marker m0 at which the springs carry no force [3; m]"""
    @offset.setter
    def offset(self, value: ArrayLike) -> None: ...
    springForceUserFunction: Callable[[MainSystem, float, int, Array, Array, Array, Array, Array], ArrayLike] | Literal[0]
    """Python function that replaces the linear law of springs and dampers; called only while the connector is active"""
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @property
    def visualization(self) -> VObjectConnectorCartesianSpringDamper:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectConnectorCartesianSpringDamper | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int | str] = [-1, -1],
        stiffness: ArrayLike = [0.0, 0.0, 0.0],
        damping: ArrayLike = [0.0, 0.0, 0.0],
        offset: ArrayLike = [0.0, 0.0, 0.0],
        springForceUserFunction: Callable[[MainSystem, float, int, Array, Array, Array, Array, Array], ArrayLike] | Literal[0] = 0,
        activeConnector: bool = True,
        visualization: VObjectConnectorCartesianSpringDamper | dict[str, Any] = ...,
    ) -> None: ...

CartesianSpringDamper = ObjectConnectorCartesianSpringDamper
VCartesianSpringDamper = VObjectConnectorCartesianSpringDamper

class VObjectConnectorCoordinateSpringDamper(_Visualization):
    """Visualization of ObjectConnectorCoordinateSpringDamper."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...

class ObjectConnectorCoordinateSpringDamper(_Object):
    """A scalar spring and damper between two coordinates"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def markerNumbers(self) -> list[MarkerIndex]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    stiffness: float
    """stiffness; N/m for coordinates that are lengths, Nm/rad for angles [various]"""
    damping: float
    """damping coefficient; Ns/m for coordinates that are lengths, Nms/rad for angles [various]"""
    offset: float
    """difference of the coordinates at which the spring carries no force; unit of the coordinates [various]"""
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    springForceUserFunction: Callable[[MainSystem, float, int, float, float, float, float, float], float] | Literal[0]
    """Python function that replaces the law of spring and damper; called only while the connector is active"""
    @property
    def visualization(self) -> VObjectConnectorCoordinateSpringDamper:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectConnectorCoordinateSpringDamper | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int | str] = [-1, -1],
        stiffness: float = 0.0,
        damping: float = 0.0,
        offset: float = 0.0,
        activeConnector: bool = True,
        springForceUserFunction: Callable[[MainSystem, float, int, float, float, float, float, float], float] | Literal[0] = 0,
        visualization: VObjectConnectorCoordinateSpringDamper | dict[str, Any] = ...,
    ) -> None: ...

CoordinateSpringDamper = ObjectConnectorCoordinateSpringDamper
VCoordinateSpringDamper = VObjectConnectorCoordinateSpringDamper

class VObjectConnectorCoordinateSpringDamperExt(_Visualization):
    """Visualization of ObjectConnectorCoordinateSpringDamperExt."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...

class ObjectConnectorCoordinateSpringDamperExt(_Object):
    """A scalar spring and damper between two coordinates, with gear factors, friction and limit stops"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def markerNumbers(self) -> list[MarkerIndex]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def nodeNumber(self) -> NodeIndex:
        """NodeGenericData with three data coordinates: friction state, last sticking position, limit stop state; needed for friction with ``frictionProportionalZone`` = 0 and for limit stops, else it may stay unset"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
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
    dynamicFrictionForce: float
    """friction force in sliding, N for lengths: friction coefficient times a constant normal force [various]"""
    fStaticFrictionOffset: float
    """difference of the largest static and the dynamic friction force, N for lengths; sticking ends at the sum of both [various]"""
    staticFrictionOffsetForce: float
    """difference of the largest static and the dynamic friction force, N for lengths; sticking ends at the sum of both [various]"""
    stickingStiffness: float
    """stiffness of the bristles in sticking, N/m for lengths; must be positive for friction with ``frictionProportionalZone`` = 0 [various]"""
    stickingDamping: float
    """damping coefficient of the bristles in sticking, Ns/m for lengths [various]"""
    exponentialDecayStatic: float
    """speed by which the static offset falls to 1/e = 36.8 % of its value, m/s for lengths [various]"""
    fViscousFriction: float
    """growth of the friction force with the speed of sliding, Ns/m for lengths; may be negative [various]"""
    viscousFrictionFactor: float
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
    springForceUserFunction: Callable[[MainSystem, float, int, float, float, float, float, float, float, float, float, float, float, float], float] | Literal[0]
    """Python function that replaces spring, damper, friction and limit stops altogether; called only while the connector is active"""
    @property
    def visualization(self) -> VObjectConnectorCoordinateSpringDamperExt:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectConnectorCoordinateSpringDamperExt | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int | str] = [-1, -1],
        nodeNumber: NodeIndex | int | str = -1,
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
        springForceUserFunction: Callable[[MainSystem, float, int, float, float, float, float, float, float, float, float, float, float, float], float] | Literal[0] = 0,
        visualization: VObjectConnectorCoordinateSpringDamperExt | dict[str, Any] = ...,
        *,
        dynamicFrictionForce: float = ...,
        staticFrictionOffsetForce: float = ...,
        viscousFrictionFactor: float = ...,
    ) -> None: ...

CoordinateSpringDamperExt = ObjectConnectorCoordinateSpringDamperExt
VCoordinateSpringDamperExt = VObjectConnectorCoordinateSpringDamperExt

class VObjectConnectorGravity(_Visualization):
    """Visualization of ObjectConnectorGravity."""

    show: bool
    """True: the item is drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    def __init__(
        self,
        show: bool = False,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...

class ObjectConnectorGravity(_Object):
    """Newtonian gravitation between two masses, for celestial bodies and satellites; the weight on earth is LoadMassProportional"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def markerNumbers(self) -> list[MarkerIndex]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
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
    @property
    def visualization(self) -> VObjectConnectorGravity:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectConnectorGravity | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int | str] = [-1, -1],
        gravitationalConstant: float = 6.6743e-11,
        mass0: float = 0.0,
        mass1: float = 0.0,
        minDistanceRegularization: float = 0.0,
        activeConnector: bool = True,
        visualization: VObjectConnectorGravity | dict[str, Any] = ...,
    ) -> None: ...

ConnectorGravity = ObjectConnectorGravity
VConnectorGravity = VObjectConnectorGravity

class VObjectConnectorHydraulicActuatorSimple(_Visualization):
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
    @property
    def colorCylinder(self) -> Array:
        """red, green, blue and opacity of the cylinder; a negative red selects the default color of connectors [4; 1]"""
    @colorCylinder.setter
    def colorCylinder(self, value: ArrayLike) -> None: ...
    @property
    def colorPiston(self) -> Array:
        """red, green, blue and opacity of piston and rod [4; 1]"""
    @colorPiston.setter
    def colorPiston(self, value: ArrayLike) -> None: ...
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

class ObjectConnectorHydraulicActuatorSimple(_Object):
    """A double-acting hydraulic cylinder between two points, with the build-up of pressure in both chambers"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def markerNumbers(self) -> list[MarkerIndex]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def nodeNumbers(self) -> list[NodeIndex]:
        """list with one NodeGenericODE1 whose two coordinates are the chamber pressures (Pa); its reference coordinates must be zero [n]"""
    @nodeNumbers.setter
    def nodeNumbers(self, value: Sequence[NodeIndex | int | str]) -> None: ...
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
    @property
    def visualization(self) -> VObjectConnectorHydraulicActuatorSimple:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectConnectorHydraulicActuatorSimple | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int | str] = [-1, -1],
        nodeNumbers: Sequence[NodeIndex | int | str] = [],
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

class VObjectConnectorLaw(_Visualization):
    """Visualization of ObjectConnectorLaw."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...

class ObjectConnectorLaw(_Object):
    """Force law between two markers with states of its own, given by user functions"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def markerNumbers(self) -> list[MarkerIndex]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def nodeNumbers(self) -> list[NodeIndex]:
        """nodes of the states: a NodeGenericODE1, whose coordinates have the rates of ``stateRateUserFunction``; a NodeGenericData, whose coordinates ``historyUserFunction`` computes once per step; or one of both [n]"""
    @nodeNumbers.setter
    def nodeNumbers(self, value: Sequence[NodeIndex | int | str]) -> None: ...
    numberOfCoordinates: int
    """size of the relative motion. 1: difference of two coordinates; 3: relative position in global axes; 6: relative position and Tait-Bryan angles in the joint frame of marker m0"""
    @property
    def rotationMarker0(self) -> Array:
        """axes of the joint frame of marker m0 in the marker's frame; used if ``numberOfCoordinates`` is 6 [3 x 3; 1]"""
    @rotationMarker0.setter
    def rotationMarker0(self, value: ArrayLike) -> None: ...
    @property
    def rotationMarker1(self) -> Array:
        """axes of the joint frame of marker m1 in the marker's frame; used if ``numberOfCoordinates`` is 6 [3 x 3; 1]"""
    @rotationMarker1.setter
    def rotationMarker1(self, value: ArrayLike) -> None: ...
    forceUserFunction: Callable[[MainSystem, float, int, Array, Array, Array], ArrayLike] | Literal[0]
    """function that computes the force; no force without it"""
    stateRateUserFunction: Callable[[MainSystem, float, int, Array, Array, Array], ArrayLike] | Literal[0]
    """function that computes the rates of the first-order coordinates; they are constant without it"""
    historyUserFunction: Callable[[MainSystem, float, int, Array, Array, Array], ArrayLike] | Literal[0]
    """function that computes the data coordinates at the end of a step; they are constant without it"""
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @property
    def visualization(self) -> VObjectConnectorLaw:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectConnectorLaw | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int | str] = [-1, -1],
        nodeNumbers: Sequence[NodeIndex | int | str] = [],
        numberOfCoordinates: int = 3,
        rotationMarker0: ArrayLike = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        rotationMarker1: ArrayLike = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        forceUserFunction: Callable[[MainSystem, float, int, Array, Array, Array], ArrayLike] | Literal[0] = 0,
        stateRateUserFunction: Callable[[MainSystem, float, int, Array, Array, Array], ArrayLike] | Literal[0] = 0,
        historyUserFunction: Callable[[MainSystem, float, int, Array, Array, Array], ArrayLike] | Literal[0] = 0,
        activeConnector: bool = True,
        visualization: VObjectConnectorLaw | dict[str, Any] = ...,
    ) -> None: ...

ConnectorLaw = ObjectConnectorLaw
VConnectorLaw = VObjectConnectorLaw

class VObjectConnectorLinearSpringDamper(_Visualization):
    """Visualization of ObjectConnectorLinearSpringDamper."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    drawAsCylinder: bool
    """True: drawn as a cylinder, which suits an actuator; False: drawn as a spring"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        drawAsCylinder: bool = False,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...

class ObjectConnectorLinearSpringDamper(_Object):
    """A spring and damper along an axis that is fixed to the first marker, as in a prismatic joint"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def markerNumbers(self) -> list[MarkerIndex]:
        """marker m0, to which the axis is fixed, and marker m1 [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    stiffness: float
    """stiffness along the axis [N/m]"""
    damping: float
    """damping coefficient along the axis [Ns/m]"""
    @property
    def axisMarker0(self) -> Array:
        """axis in the frame of marker m0, a unit vector; it turns with that marker [3; 1]"""
    @axisMarker0.setter
    def axisMarker0(self, value: ArrayLike) -> None: ...
    offset: float
    """relative position along the axis at which the spring carries no force; may be changed during a simulation as the set value of a drive [m]"""
    velocityOffset: float
    """relative velocity along the axis at which the damper carries no force; set value of a velocity control [m/s]"""
    force: float
    """constant force added to that of spring and damper; positive: pulls marker m1 against the direction of the axis [N]"""
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    springForceUserFunction: Callable[[MainSystem, float, int, float, float, float, float, float], float] | Literal[0]
    """Python function that replaces the law of spring, damper and constant force; called only while the connector is active"""
    @property
    def visualization(self) -> VObjectConnectorLinearSpringDamper:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectConnectorLinearSpringDamper | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int | str] = [-1, -1],
        stiffness: float = 0.0,
        damping: float = 0.0,
        axisMarker0: ArrayLike = [1.0, 0.0, 0.0],
        offset: float = 0.0,
        velocityOffset: float = 0.0,
        force: float = 0.0,
        activeConnector: bool = True,
        springForceUserFunction: Callable[[MainSystem, float, int, float, float, float, float, float], float] | Literal[0] = 0,
        visualization: VObjectConnectorLinearSpringDamper | dict[str, Any] = ...,
    ) -> None: ...

LinearSpringDamper = ObjectConnectorLinearSpringDamper
VLinearSpringDamper = VObjectConnectorLinearSpringDamper

class VObjectConnectorReevingSystemSprings(_Visualization):
    """Visualization of ObjectConnectorReevingSystemSprings."""

    show: bool
    """False: the item is not drawn"""
    ropeRadius: float
    """radius of the drawn rope [m]"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    def __init__(
        self,
        show: bool = True,
        ropeRadius: float = 0.001,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...

class ObjectConnectorReevingSystemSprings(_Object):
    """A massless elastic rope that runs without friction over sheaves and joins two end points"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def markerNumbers(self) -> list[MarkerIndex]:
        """rigid body markers along the rope: the first and the last are its ends, those between carry sheaves or deflection points; if ``hasCoordinateMarkers`` is set, two coordinate markers follow [n]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    hasCoordinateMarkers: bool
    """True: the last two markers are coordinate markers that add rope at the start and at the end"""
    turningEnds: bool
    """True: the bodies of the first and the last marker are pulleys that turn with the rope. The coordinate markers measure their rotations, without forces on these coordinates: the rope acts on the pulleys where it touches them"""
    @property
    def coordinateFactors(self) -> Array:
        """factors of the two coordinate markers: 1 for lengths, a radius (m) for the angle of a winch [2; various]"""
    @coordinateFactors.setter
    def coordinateFactors(self, value: ArrayLike) -> None: ...
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
    @property
    def sheavesAxes(self) -> Vector3DList:
        """axis of every sheave in the frame of its marker; the sign chooses the side at which the rope runs; it must not be parallel to the line to the next center [n x 3; 1]"""
    @sheavesAxes.setter
    def sheavesAxes(self, value: Sequence[ArrayLike] | Vector3DList) -> None: ...
    @property
    def sheavesRadii(self) -> Array:
        """radius of every sheave; 0: a point. At an end with a radius, the moment of the rope about the center acts on the body of the marker [n; m]"""
    @sheavesRadii.setter
    def sheavesRadii(self, value: ArrayLike) -> None: ...
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @property
    def visualization(self) -> VObjectConnectorReevingSystemSprings:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectConnectorReevingSystemSprings | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int | str] = [-1, -1],
        hasCoordinateMarkers: bool = False,
        turningEnds: bool = False,
        coordinateFactors: ArrayLike = [1.0, 1.0],
        stiffnessPerLength: float = 0.0,
        dampingPerLength: float = 0.0,
        dampingTorsional: float = 0.0,
        dampingShear: float = 0.0,
        regularizationForce: float = 0.1,
        referenceLength: float = 0.0,
        sheavesAxes: Sequence[ArrayLike] | Vector3DList = [],
        sheavesRadii: ArrayLike = [],
        activeConnector: bool = True,
        visualization: VObjectConnectorReevingSystemSprings | dict[str, Any] = ...,
    ) -> None: ...

ReevingSystemSprings = ObjectConnectorReevingSystemSprings
VReevingSystemSprings = VObjectConnectorReevingSystemSprings

class VObjectConnectorRigidBodySpringDamper(_Visualization):
    """Visualization of ObjectConnectorRigidBodySpringDamper."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...

class ObjectConnectorRigidBodySpringDamper(_Object):
    """A spring and damper with six components, against relative translation and rotation of two rigid body markers"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def markerNumbers(self) -> list[MarkerIndex]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def nodeNumber(self) -> NodeIndex:
        """NodeGenericData whose data coordinates the user functions may use, for instance for friction or contact states; not set: no data coordinates"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    @property
    def stiffness(self) -> Array:
        """stiffness matrix in frame J0 for three translations (N/m) and three rotations (Nm/rad), coupling terms included; need not be symmetric [6 x 6; various]"""
    @stiffness.setter
    def stiffness(self, value: ArrayLike) -> None: ...
    @property
    def damping(self) -> Array:
        """damping matrix in frame J0 for the three components of velocity (Ns/m) and of angular velocity (Nms/rad) [6 x 6; various]"""
    @damping.setter
    def damping(self, value: ArrayLike) -> None: ...
    @property
    def rotationMarker0(self) -> Array:
        """rotation matrix from joint frame J0 to the frame of marker m0; turns the axes in which stiffness, damping and offset are given [3 x 3; 1]"""
    @rotationMarker0.setter
    def rotationMarker0(self, value: ArrayLike) -> None: ...
    @property
    def rotationMarker1(self) -> Array:
        """rotation matrix from joint frame J1 to the frame of marker m1; without rotation offset, the springs carry no torque if J0 and J1 are parallel [3 x 3; 1]"""
    @rotationMarker1.setter
    def rotationMarker1(self, value: ArrayLike) -> None: ...
    @property
    def offset(self) -> Array:
        """relative position (m) and Tait-Bryan angles (rad) in frame J0 at which the springs carry no force; the logarithm of the relative motion with ``intrinsicFormulation`` [6; various]"""
    @offset.setter
    def offset(self, value: ArrayLike) -> None: ...
    intrinsicFormulation: bool
    """True: relative motion is measured by the logarithm on SE(3), and forces act in the frame half-way between the markers, such that exchanging the markers changes nothing; False: all is measured in frame J0"""
    useIntrinsicFormulation: bool
    """True: relative motion is measured by the logarithm on SE(3), and forces act in the frame half-way between the markers, such that exchanging the markers changes nothing; False: all is measured in frame J0"""
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    springForceTorqueUserFunction: Callable[[MainSystem, float, int, Array, Array, Array, Array, Array, Array, Array, Array, Array], ArrayLike] | Literal[0]
    """Python function that replaces the linear law of force and torque; called only while the connector is active"""
    postNewtonStepUserFunction: Callable[[MainSystem, float, int, Array, Array, Array, Array, Array, Array, Array, Array, Array, Array], ArrayLike] | Literal[0]
    """Python function that updates the data coordinates of ``nodeNumber`` after each Newton iteration has converged; called only with a data node and while the connector is active"""
    @property
    def visualization(self) -> VObjectConnectorRigidBodySpringDamper:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectConnectorRigidBodySpringDamper | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int | str] = [-1, -1],
        nodeNumber: NodeIndex | int | str = -1,
        stiffness: ArrayLike = [[0.0, 0.0, 0.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.0, 0.0, 0.0]],
        damping: ArrayLike = [[0.0, 0.0, 0.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.0, 0.0, 0.0]],
        rotationMarker0: ArrayLike = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        rotationMarker1: ArrayLike = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        offset: ArrayLike = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        intrinsicFormulation: bool = False,
        activeConnector: bool = True,
        springForceTorqueUserFunction: Callable[[MainSystem, float, int, Array, Array, Array, Array, Array, Array, Array, Array, Array], ArrayLike] | Literal[0] = 0,
        postNewtonStepUserFunction: Callable[[MainSystem, float, int, Array, Array, Array, Array, Array, Array, Array, Array, Array, Array], ArrayLike] | Literal[0] = 0,
        visualization: VObjectConnectorRigidBodySpringDamper | dict[str, Any] = ...,
        *,
        useIntrinsicFormulation: bool = ...,
    ) -> None: ...

RigidBodySpringDamper = ObjectConnectorRigidBodySpringDamper
VRigidBodySpringDamper = VObjectConnectorRigidBodySpringDamper

class VObjectConnectorRollingDiscPenalty(_Visualization):
    """Visualization of ObjectConnectorRollingDiscPenalty."""

    show: bool
    """False: the item is not drawn"""
    discWidth: float
    """width of the drawn disc [m]"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    def __init__(
        self,
        show: bool = True,
        discWidth: float = 0.1,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...

class ObjectConnectorRollingDiscPenalty(_Object):
    """A disc that rolls or slides with friction on a plane, with elastic contact instead of constraints"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def markerNumbers(self) -> list[MarkerIndex]:
        """marker m0 on the plane and marker m1 at the center of the disc [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def nodeNumber(self) -> NodeIndex:
        """NodeGenericData with three data coordinates: slip velocity in lateral and in forward direction, and gap, of the last update"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    discRadius: float
    """radius of the disc [m]"""
    @property
    def discAxis(self) -> Array:
        """axis of the disc in the frame of marker m1, a unit vector; must not become parallel to the normal of the plane [3; 1]"""
    @discAxis.setter
    def discAxis(self, value: ArrayLike) -> None: ...
    @property
    def planeNormal(self) -> Array:
        """normal of the plane in the frame of marker m0, a unit vector; the plane contains the position of marker m0 [3; 1]"""
    @planeNormal.setter
    def planeNormal(self, value: ArrayLike) -> None: ...
    dryFrictionAngle: float
    """rotation of the directions of ``dryFriction`` in the plane, such as the angle of the rollers of a Mecanum wheel [rad]"""
    contactStiffness: float
    """stiffness normal to the plane [N/m]"""
    contactDamping: float
    """damping coefficient normal to the plane [Ns/m]"""
    @property
    def dryFriction(self) -> Array:
        """friction coefficients in lateral and in forward direction [2; 1]"""
    @dryFriction.setter
    def dryFriction(self, value: ArrayLike) -> None: ...
    dryFrictionProportionalZone: float
    """slip speed up to which friction is regularized; 0: none [m/s]"""
    @property
    def viscousFriction(self) -> Array:
        """growth of the friction coefficients with the slip speed, in lateral and in forward direction [2; s/m]"""
    @viscousFriction.setter
    def viscousFriction(self, value: ArrayLike) -> None: ...
    rollingFrictionViscous: float
    """rolling resistance per normal force and per speed of the disc center along the plane; only for a disc with its axis parallel to the plane [s/m]"""
    rollingViscousFriction: float
    """rolling resistance per normal force and per speed of the disc center along the plane; only for a disc with its axis parallel to the plane [s/m]"""
    useLinearProportionalZone: bool
    """True: friction grows linearly in the proportional zone, with a constant tangent in sticking; False: quadratically, with a smooth end of the zone"""
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @property
    def visualization(self) -> VObjectConnectorRollingDiscPenalty:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectConnectorRollingDiscPenalty | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int | str] = [-1, -1],
        nodeNumber: NodeIndex | int | str = -1,
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
        *,
        rollingViscousFriction: float = ...,
    ) -> None: ...

RollingDiscPenalty = ObjectConnectorRollingDiscPenalty
VRollingDiscPenalty = VObjectConnectorRollingDiscPenalty

class VObjectConnectorSpringDamper(_Visualization):
    """Visualization of ObjectConnectorSpringDamper."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...

class ObjectConnectorSpringDamper(_Object):
    """A spring and a damper that act along the line between two points"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def markerNumbers(self) -> list[MarkerIndex]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
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
    springForceUserFunction: Callable[[MainSystem, float, int, float, float, float, float, float], float] | Literal[0]
    """Python function that replaces the law of spring, damper and constant force; called only while the connector is active"""
    @property
    def visualization(self) -> VObjectConnectorSpringDamper:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectConnectorSpringDamper | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int | str] = [-1, -1],
        referenceLength: float = 0.0,
        stiffness: float = 0.0,
        damping: float = 0.0,
        force: float = 0.0,
        velocityOffset: float = 0.0,
        activeConnector: bool = True,
        springForceUserFunction: Callable[[MainSystem, float, int, float, float, float, float, float], float] | Literal[0] = 0,
        visualization: VObjectConnectorSpringDamper | dict[str, Any] = ...,
    ) -> None: ...

SpringDamper = ObjectConnectorSpringDamper
VSpringDamper = VObjectConnectorSpringDamper

class VObjectConnectorTorsionalSpringDamper(_Visualization):
    """Visualization of ObjectConnectorTorsionalSpringDamper."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...

class ObjectConnectorTorsionalSpringDamper(_Object):
    """A torsional spring and damper about the z axis of a joint frame"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def markerNumbers(self) -> list[MarkerIndex]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def nodeNumber(self) -> NodeIndex:
        """NodeGenericData with one data coordinate that holds the angle of the last step and makes the measured angle continuous beyond half a turn; not set: the angle jumps"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    stiffness: float
    """torsional stiffness [Nm/rad]"""
    damping: float
    """torsional damping coefficient [Nms/rad]"""
    @property
    def rotationMarker0(self) -> Array:
        """rotation matrix from joint frame J0 to the frame of marker m0; its third column is the axis of rotation [3 x 3; 1]"""
    @rotationMarker0.setter
    def rotationMarker0(self, value: ArrayLike) -> None: ...
    @property
    def rotationMarker1(self) -> Array:
        """rotation matrix from joint frame J1 to the frame of marker m1; the angle is zero if J0 and J1 are parallel [3 x 3; 1]"""
    @rotationMarker1.setter
    def rotationMarker1(self, value: ArrayLike) -> None: ...
    offset: float
    """angle at which the spring carries no torque; may be changed during a simulation as the set value of a drive [rad]"""
    velocityOffset: float
    """relative angular velocity at which the damper carries no torque; set value of a velocity control [rad/s]"""
    torque: float
    """constant torque added to that of spring and damper; positive: acts against the rotation of marker m1 about the axis [Nm]"""
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    springTorqueUserFunction: Callable[[MainSystem, float, int, float, float, float, float, float], float] | Literal[0]
    """Python function that replaces the law of spring, damper and constant torque; called only while the connector is active"""
    @property
    def visualization(self) -> VObjectConnectorTorsionalSpringDamper:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectConnectorTorsionalSpringDamper | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int | str] = [-1, -1],
        nodeNumber: NodeIndex | int | str = -1,
        stiffness: float = 0.0,
        damping: float = 0.0,
        rotationMarker0: ArrayLike = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        rotationMarker1: ArrayLike = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        offset: float = 0.0,
        velocityOffset: float = 0.0,
        torque: float = 0.0,
        activeConnector: bool = True,
        springTorqueUserFunction: Callable[[MainSystem, float, int, float, float, float, float, float], float] | Literal[0] = 0,
        visualization: VObjectConnectorTorsionalSpringDamper | dict[str, Any] = ...,
    ) -> None: ...

TorsionalSpringDamper = ObjectConnectorTorsionalSpringDamper
VTorsionalSpringDamper = VObjectConnectorTorsionalSpringDamper

class VObjectConnectorCoordinate(_Visualization):
    """Visualization of ObjectConnectorCoordinate."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...

class ObjectConnectorCoordinate(_Object):
    """Couples two coordinates, or fixes one of them to a value or to a function of time"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def markerNumbers(self) -> list[MarkerIndex]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    offset: float
    """prescribed value of ``factorValue1`` times the second coordinate minus the first one; with ``velocityLevel`` the same for the velocity coordinates [various]"""
    factorValue1: float
    """factor of the coordinate of marker m1, such as a gear ratio [1]"""
    factor1: float
    """factor of the coordinate of marker m1, such as a gear ratio [1]"""
    velocityLevel: bool
    """True: the constraint is set for the velocity coordinates, and ``offset`` is a velocity; ``offsetUserFunction`` is then ignored; only for coordinates of second order equations"""
    offsetUserFunction: Callable[[MainSystem, float, int, float], float] | Literal[0]
    """Python function that replaces ``offset`` by a function of time, on position level"""
    offsetUserFunction_t: Callable[[MainSystem, float, int, float], float] | Literal[0]
    """Python function, the time derivative of ``offsetUserFunction``; used wherever the constraint is evaluated on velocity level"""
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @property
    def visualization(self) -> VObjectConnectorCoordinate:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectConnectorCoordinate | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int | str] = [-1, -1],
        offset: float = 0.0,
        factorValue1: float = 1.0,
        velocityLevel: bool = False,
        offsetUserFunction: Callable[[MainSystem, float, int, float], float] | Literal[0] = 0,
        offsetUserFunction_t: Callable[[MainSystem, float, int, float], float] | Literal[0] = 0,
        activeConnector: bool = True,
        visualization: VObjectConnectorCoordinate | dict[str, Any] = ...,
        *,
        factor1: float = ...,
    ) -> None: ...

CoordinateConstraint = ObjectConnectorCoordinate
VCoordinateConstraint = VObjectConnectorCoordinate

class VObjectConnectorCoordinateVector(_Visualization):
    """Visualization of ObjectConnectorCoordinateVector."""

    show: bool
    """False: the item is not drawn"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    def __init__(
        self,
        show: bool = True,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...

class ObjectConnectorCoordinateVector(_Object):
    """Couples the coordinate vectors of two markers by linear and quadratic equations, or by a user function"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def markerNumbers(self) -> list[MarkerIndex]:
        """two markers on coordinate vectors; the equations are those of m1 minus those of m0 [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def scalingMarker0(self) -> Array:
        """matrix of linear factors of the coordinates of marker m0, one row per equation and one column per coordinate; empty: no such term [n x m; various]"""
    @scalingMarker0.setter
    def scalingMarker0(self, value: ArrayLike) -> None: ...
    @property
    def scalingMarker1(self) -> Array:
        """matrix of linear factors of the coordinates of marker m1; empty: no such term [n x m; various]"""
    @scalingMarker1.setter
    def scalingMarker1(self, value: ArrayLike) -> None: ...
    @property
    def quadraticTermMarker0(self) -> Array:
        """matrix of factors of the squared coordinates of marker m0; empty: no such term [n x m; various]"""
    @quadraticTermMarker0.setter
    def quadraticTermMarker0(self, value: ArrayLike) -> None: ...
    @property
    def quadraticTermMarker1(self) -> Array:
        """matrix of factors of the squared coordinates of marker m1; empty: no such term [n x m; various]"""
    @quadraticTermMarker1.setter
    def quadraticTermMarker1(self, value: ArrayLike) -> None: ...
    @property
    def offset(self) -> Array:
        """vector that is subtracted from the equations, one component per equation; empty: zero; not used with a user function [n; various]"""
    @offset.setter
    def offset(self, value: ArrayLike) -> None: ...
    velocityLevel: bool
    """True: the equations are set for the velocity coordinates, and ``offset`` is a velocity; only for coordinates of second order equations"""
    constraintUserFunction: Callable[[MainSystem, float, int, Array, Array, bool], ArrayLike] | Literal[0]
    """Python function that replaces all equations; ``jacobianUserFunction`` is needed as well, and ``scalingMarker0`` tells the number of equations by its number of rows, as in ``np.zeros((2, 1))``"""
    jacobianUserFunction: Callable[[MainSystem, float, int, Array, Array, bool], MatrixLike] | Literal[0]
    """Python function, the derivative of ``constraintUserFunction`` with respect to the coordinates (or velocity coordinates with ``velocityLevel``)"""
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @property
    def visualization(self) -> VObjectConnectorCoordinateVector:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectConnectorCoordinateVector | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int | str] = [-1, -1],
        scalingMarker0: ArrayLike = [],
        scalingMarker1: ArrayLike = [],
        quadraticTermMarker0: ArrayLike = [],
        quadraticTermMarker1: ArrayLike = [],
        offset: ArrayLike = [],
        velocityLevel: bool = False,
        constraintUserFunction: Callable[[MainSystem, float, int, Array, Array, bool], ArrayLike] | Literal[0] = 0,
        jacobianUserFunction: Callable[[MainSystem, float, int, Array, Array, bool], MatrixLike] | Literal[0] = 0,
        activeConnector: bool = True,
        visualization: VObjectConnectorCoordinateVector | dict[str, Any] = ...,
    ) -> None: ...

CoordinateVectorConstraint = ObjectConnectorCoordinateVector
VCoordinateVectorConstraint = VObjectConnectorCoordinateVector

class VObjectConnectorDistance(_Visualization):
    """Visualization of ObjectConnectorDistance."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...

class ObjectConnectorDistance(_Object):
    """Keeps the distance of two points constant, like a massless rigid rod between two ball joints"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def markerNumbers(self) -> list[MarkerIndex]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    distance: float
    """prescribed distance of the two markers; must be positive, and should fit the initial positions [m]"""
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @property
    def visualization(self) -> VObjectConnectorDistance:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectConnectorDistance | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int | str] = [-1, -1],
        distance: float = 0.0,
        activeConnector: bool = True,
        visualization: VObjectConnectorDistance | dict[str, Any] = ...,
    ) -> None: ...

DistanceConstraint = ObjectConnectorDistance
VDistanceConstraint = VObjectConnectorDistance

class VObjectContactCircleCable2D(_Visualization):
    """Visualization of ObjectContactCircleCable2D."""

    show: bool
    """False: the item is not drawn"""
    showContactCircle: bool
    """True: the circle is drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    def __init__(
        self,
        show: bool = True,
        showContactCircle: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...

class ObjectContactCircleCable2D(_Object):
    """Contact without friction of a planar cable element with a circle"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def markerNumbers(self) -> list[MarkerIndex]:
        """marker m0 at the center of the circle and marker m1, the shape of the cable [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def nodeNumber(self) -> NodeIndex:
        """NodeGenericData with one data coordinate per segment, the gap when contact opened or closed last; a segment is in contact while it is not positive"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
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
    @property
    def visualization(self) -> VObjectContactCircleCable2D:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectContactCircleCable2D | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int | str] = [-1, -1],
        nodeNumber: NodeIndex | int | str = -1,
        numberOfContactSegments: int = 3,
        contactStiffness: float = 0.0,
        contactDamping: float = 0.0,
        circleRadius: float = 0.0,
        offset: float = 0.0,
        activeConnector: bool = True,
        visualization: VObjectContactCircleCable2D | dict[str, Any] = ...,
    ) -> None: ...

class VObjectContactConvexRoll(_Visualization):
    """Visualization of ObjectContactConvexRoll."""

    show: bool
    """False: the item is not drawn"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    def __init__(
        self,
        show: bool = True,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...

class ObjectContactConvexRoll(_Object):
    """Contact of a convex roll, a body of revolution with a polynomial profile, with the ground plane"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def markerNumbers(self) -> list[MarkerIndex]:
        """marker m0 on the ground, whose x and y axes span the plane, and marker m1 at the center of the roll, with the x axis along it [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def nodeNumber(self) -> NodeIndex:
        """NodeGenericData with three data coordinates of the last update: gap, and slip velocity along the x and y axes of marker m0"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    contactStiffness: float
    """stiffness normal to the plane [N/m]"""
    contactDamping: float
    """damping coefficient normal to the plane [Ns/m]"""
    dynamicFriction: float
    """coefficient of friction in sliding [1]"""
    staticFrictionOffset: float
    """difference of the coefficients of static and dynamic friction [1]"""
    viscousFriction: float
    """growth of the friction coefficient with the slip speed [s/m]"""
    exponentialDecayStatic: float
    """slip speed by which the static offset falls to 1/e [m/s]"""
    frictionProportionalZone: float
    """slip speed up to which friction is proportional to it [m/s]"""
    rollLength: float
    """length of the roll, symmetric about its center [m]"""
    @property
    def coefficientsHull(self) -> Array:
        """coefficients of the polynomial radius over the position x on the axis, highest power first; the profile must be convex [n; various]"""
    @coefficientsHull.setter
    def coefficientsHull(self, value: ArrayLike) -> None: ...
    @property
    def coefficientsHullDerivative(self) -> Array:
        """coefficients of the first derivative of the profile [n; various]; computed"""
    @property
    def coefficientsHullDDerivative(self) -> Array:
        """coefficients of the second derivative of the profile [n; various]; computed"""
    rBoundingSphere: float
    """radius of spheres at both ends that exclude contact by a cheap test; no effect here, because the lowest point of the profile is always computed [m]"""
    @property
    def pContact(self) -> Array:
        """current point of possible contact; contact if its third component is negative [3; m]; computed"""
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    limitDamping: bool
    """True: the force is never tensile; it is zero if damping would make it tensile. False: damping also acts in tension until the gap is open"""
    @property
    def visualization(self) -> VObjectContactConvexRoll:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectContactConvexRoll | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int | str] = [-1, -1],
        nodeNumber: NodeIndex | int | str = -1,
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
        limitDamping: bool = False,
        visualization: VObjectContactConvexRoll | dict[str, Any] = ...,
    ) -> None: ...

class VObjectContactCoordinate(_Visualization):
    """Visualization of ObjectContactCoordinate."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...

class ObjectContactCoordinate(_Object):
    """Contact of two coordinates, a one-sided spring and damper"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def markerNumbers(self) -> list[MarkerIndex]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def nodeNumber(self) -> NodeIndex:
        """NodeGenericData with one data coordinate, the gap of the last update, which must not be positive if the simulation begins in contact; with an ``impactModel`` other than 0 a second one, the impact velocity"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    contactStiffness: float
    """contact stiffness; N/m for coordinates that are lengths [various]"""
    contactDamping: float
    """contact damping coefficient; Ns/m for coordinates that are lengths [various]"""
    offset: float
    """difference of the coordinates at which contact begins; m for lengths [various]"""
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    contactStiffnessExponent: float
    """exponent n of the penetration in the normal force; 1.5 for Hertzian contact [1]"""
    restitutionCoefficient: float
    """ratio of normal speeds after and before an impact, for ``impactModel`` 1 and 2; positive, 1: elastic [1]"""
    minimumImpactVelocity: float
    """lower bound of the impact velocity in the restitution law; larger values damp slow and lasting contacts more [various]"""
    impactModel: int
    """0: elastic contact with linear damping; 1: Hunt-Crossley, for restitution near 1; 2: Carvalho-Martins and Gonthier, for all restitution coefficients"""
    @property
    def visualization(self) -> VObjectContactCoordinate:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectContactCoordinate | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int | str] = [-1, -1],
        nodeNumber: NodeIndex | int | str = -1,
        contactStiffness: float = 0.0,
        contactDamping: float = 0.0,
        offset: float = 0.0,
        activeConnector: bool = True,
        contactStiffnessExponent: float = 1.0,
        restitutionCoefficient: float = 1.0,
        minimumImpactVelocity: float = 0.0,
        impactModel: int = 0,
        visualization: VObjectContactCoordinate | dict[str, Any] = ...,
    ) -> None: ...

class VObjectContactCurveCircles(_Visualization):
    """Visualization of ObjectContactCurveCircles."""

    show: bool
    """False: the item is not drawn"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    def __init__(
        self,
        show: bool = True,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...

class ObjectContactCurveCircles(_Object):
    """Contact of a planar curve with circles, as of a cam with its followers"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def markerNumbers(self) -> list[MarkerIndex]:
        """rigid body marker that carries the curve, followed by one marker per circle [n]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def nodeNumber(self) -> NodeIndex:
        """NodeGenericData with three data coordinates per segment: number of the circle in contact, gap, tangential velocity, of the last update"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    @property
    def circlesRadii(self) -> Array:
        """radius of every circle, as many as circle markers [n; m]"""
    @circlesRadii.setter
    def circlesRadii(self, value: ArrayLike) -> None: ...
    @property
    def segmentsData(self) -> MatrixContainer:
        """one row per segment with the planar coordinates of its begin and end, [x0, y0, x1, y1], in the frame of the curve; the outer side lies to the right when going from begin to end [n x m; m]"""
    @segmentsData.setter
    def segmentsData(self, value: MatrixLike | None) -> None: ...
    @property
    def polynomialData(self) -> MatrixContainer:
        """one row per segment with slopes at its begin and end (1) and curvatures at its begin and end (1/m), in the frame of the segment; to be left empty: segments are straight [n x m; various]"""
    @polynomialData.setter
    def polynomialData(self, value: MatrixLike | None) -> None: ...
    @property
    def rotationMarker0(self) -> Array:
        """rotation matrix from the frame of the curve, in whose x-y plane it lies, to the frame of the first marker [3 x 3; 1]"""
    @rotationMarker0.setter
    def rotationMarker0(self, value: ArrayLike) -> None: ...
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
    @property
    def gapPerSegment(self) -> Array:
        """gap of every segment at the last evaluation [n; m]; computed"""
    @property
    def gapPerSegment_t(self) -> Array:
        """rate of gap of every segment at the last evaluation [n; m/s]; computed"""
    @property
    def segmentsForceLocalX(self) -> Array:
        """contact force of every segment in x direction of its frame, at the last evaluation [n; N]; computed"""
    @property
    def segmentsForceLocalY(self) -> Array:
        """contact force of every segment in y direction of its frame, at the last evaluation [n; N]; computed"""
    @property
    def visualization(self) -> VObjectContactCurveCircles:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectContactCurveCircles | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int | str] = [-1, -1],
        nodeNumber: NodeIndex | int | str = -1,
        circlesRadii: ArrayLike = [],
        segmentsData: MatrixLike | None = None,
        polynomialData: MatrixLike | None = None,
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

class VObjectContactFrictionCircleCable2D(_Visualization):
    """Visualization of ObjectContactFrictionCircleCable2D."""

    show: bool
    """False: the item is not drawn"""
    showContactCircle: bool
    """True: the circle is drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    def __init__(
        self,
        show: bool = True,
        showContactCircle: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...

class ObjectContactFrictionCircleCable2D(_Object):
    """Contact with friction of a planar cable element with a circle, such as of a belt on a pulley"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def markerNumbers(self) -> list[MarkerIndex]:
        """marker m0 at the center of the circle and marker m1, the shape of the cable [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def nodeNumber(self) -> NodeIndex:
        """NodeGenericData with three data coordinates per segment: all gaps, then all friction states (-1 and 1 slip, 0 stick, -2 undefined), then all last sticking positions; begin for instance with 0.1, -2, 0 for no contact"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
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
    limitDamping: bool
    """True: the force is never tensile; it is zero if damping would make it tensile. False: damping also acts in tension until the gap is open"""
    @property
    def visualization(self) -> VObjectContactFrictionCircleCable2D:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectContactFrictionCircleCable2D | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int | str] = [-1, -1],
        nodeNumber: NodeIndex | int | str = -1,
        numberOfContactSegments: int = 3,
        contactStiffness: float = 0.0,
        contactDamping: float = 0.0,
        frictionVelocityPenalty: float = 0.0,
        frictionStiffness: float = 0.0,
        frictionCoefficient: float = 0.0,
        circleRadius: float = 0.0,
        useSegmentNormals: bool = True,
        activeConnector: bool = True,
        limitDamping: bool = False,
        visualization: VObjectContactFrictionCircleCable2D | dict[str, Any] = ...,
    ) -> None: ...

class VObjectContactSphereSphere(_Visualization):
    """Visualization of ObjectContactSphereSphere."""

    show: bool
    """True: the item is drawn"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity of the drawn shapes [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    def __init__(
        self,
        show: bool = False,
        color: ArrayLike = [0.7, 0.7, 0.7, 1.0],
    ) -> None: ...

class ObjectContactSphereSphere(_Object):
    """Contact of two spheres, or of a sphere inside a hollow sphere, with friction, restitution and adhesion"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def markerNumbers(self) -> list[MarkerIndex]:
        """markers at the centers of the two spheres [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def nodeNumber(self) -> NodeIndex:
        """NodeGenericData with four data coordinates of the last update: gap, tangential speed, impact velocity, plastic overlap; initial gap positive: no contact"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    @property
    def spheresRadii(self) -> Array:
        """radii of the spheres at marker m0 and marker m1; must be positive [2; m]"""
    @spheresRadii.setter
    def spheresRadii(self, value: ArrayLike) -> None: ...
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
    """coefficient of the adhesive force that grows with penetration (N/m for an exponent of 1); 0: none. It acts in unloading after a plastic overlap, so with ``contactPlasticityRatio`` and ``impactModel`` 0 only [various]"""
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
    limitDamping: bool
    """True: the force is never tensile; it is zero if damping would make it tensile. False: damping also acts in tension until the gap is open"""
    @property
    def visualization(self) -> VObjectContactSphereSphere:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectContactSphereSphere | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int | str] = [-1, -1],
        nodeNumber: NodeIndex | int | str = -1,
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
        limitDamping: bool = False,
        visualization: VObjectContactSphereSphere | dict[str, Any] = ...,
    ) -> None: ...

class VObjectContactSphereTorus(_Visualization):
    """Visualization of ObjectContactSphereTorus."""

    show: bool
    """True: the item is drawn"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity of the drawn shapes [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    def __init__(
        self,
        show: bool = False,
        color: ArrayLike = [0.7, 0.7, 0.7, 1.0],
    ) -> None: ...

class ObjectContactSphereTorus(_Object):
    """Contact of a sphere inside the tube of a torus, as of a ball in the groove of a bearing"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def markerNumbers(self) -> list[MarkerIndex]:
        """marker m0 at the center of the sphere and marker m1 at the center of the torus [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def nodeNumber(self) -> NodeIndex:
        """NodeGenericData with four data coordinates of the last update: gap, tangential speed, impact velocity, and one that is not used"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    radiusSphere: float
    """radius of the sphere at marker m0 [m]"""
    sphereRadius: float
    """radius of the sphere at marker m0 [m]"""
    torusMajorRadius: float
    """radius of the center line of the torus [m]"""
    torusMinorRadius: float
    """radius of the tube, larger than that of the sphere [m]"""
    @property
    def torusAxis(self) -> Array:
        """axis of the torus in the frame of marker m1, a unit vector [3; 1]"""
    @torusAxis.setter
    def torusAxis(self, value: ArrayLike) -> None: ...
    dynamicFriction: float
    """coefficient of dry friction [1]"""
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
    limitDamping: bool
    """True: the force is never tensile; it is zero if damping would make it tensile. False: damping also acts in tension until the gap is open"""
    @property
    def visualization(self) -> VObjectContactSphereTorus:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectContactSphereTorus | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int | str] = [-1, -1],
        nodeNumber: NodeIndex | int | str = -1,
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
        limitDamping: bool = False,
        visualization: VObjectContactSphereTorus | dict[str, Any] = ...,
        *,
        sphereRadius: float = ...,
    ) -> None: ...

class VObjectContactSphereTriangle(_Visualization):
    """Visualization of ObjectContactSphereTriangle."""

    show: bool
    """True: the item is drawn"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity of the drawn shapes [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    def __init__(
        self,
        show: bool = False,
        color: ArrayLike = [0.7, 0.7, 0.7, 1.0],
    ) -> None: ...

class ObjectContactSphereTriangle(_Object):
    """Contact of a sphere with a triangle, its face and chosen edges"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def markerNumbers(self) -> list[MarkerIndex]:
        """marker m0 at the center of the sphere and marker m1 on the body that carries the triangle [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def nodeNumber(self) -> NodeIndex:
        """NodeGenericData with four data coordinates of the last update: gap, tangential speed, impact velocity, and one that is not used"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    radiusSphere: float
    """radius of the sphere at marker m0 [m]"""
    sphereRadius: float
    """radius of the sphere at marker m0 [m]"""
    @property
    def trianglePoints(self) -> Vector3DList:
        """three points in the frame of marker m1 [n x 3; m]"""
    @trianglePoints.setter
    def trianglePoints(self, value: Sequence[ArrayLike] | Vector3DList) -> None: ...
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
    limitDamping: bool
    """True: the force is never tensile; it is zero if damping would make it tensile. False: damping also acts in tension until the gap is open"""
    @property
    def visualization(self) -> VObjectContactSphereTriangle:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectContactSphereTriangle | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int | str] = [-1, -1],
        nodeNumber: NodeIndex | int | str = -1,
        radiusSphere: float = 0.0,
        trianglePoints: Sequence[ArrayLike] | Vector3DList = [],
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
        limitDamping: bool = False,
        visualization: VObjectContactSphereTriangle | dict[str, Any] = ...,
        *,
        sphereRadius: float = ...,
    ) -> None: ...

class VObjectJointALEMoving2D(_Visualization):
    """Visualization of ObjectJointALEMoving2D."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...

class ObjectJointALEMoving2D(_Object):
    """A body attached to an axially moving ANCF cable, whose sliding coordinate is shared by all elements of the cable"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def markerNumbers(self) -> list[MarkerIndex]:
        """marker m0 of the sliding body, and marker m1 of the cable element on which it begins, one of ``slidingMarkerNumbers``; the data node has the current element [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def slidingMarkerNumbers(self) -> list[MarkerIndex]:
        """coordinate markers of all cable elements in the order in which they follow each other: the end of one element is the begin of the next [n]"""
    @slidingMarkerNumbers.setter
    def slidingMarkerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def slidingMarkerOffsets(self) -> Array:
        """for each of these elements, the sum of the reference lengths of all elements before it; the first is 0; one for each of ``slidingMarkerNumbers`` [n; m]"""
    @slidingMarkerOffsets.setter
    def slidingMarkerOffsets(self, value: ArrayLike) -> None: ...
    slidingOffset: float
    """reference arc length that is added to the sliding coordinate [m]"""
    @property
    def nodeNumbers(self) -> list[NodeIndex]:
        """NodeGenericData with one data coordinate (index of the current element), and the NodeGenericODE2 with the sliding coordinate of the cable, the third node of its elements [2]"""
    @nodeNumbers.setter
    def nodeNumbers(self, value: Sequence[NodeIndex | int | str]) -> None: ...
    usePenaltyFormulation: bool
    """True: the constraint is softened by ``penaltyStiffness``, still with multipliers as unknowns"""
    penaltyStiffness: float
    """stiffness of the softened constraint [N/m]"""
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @property
    def visualization(self) -> VObjectJointALEMoving2D:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectJointALEMoving2D | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int | str] = [-1, -1],
        slidingMarkerNumbers: Sequence[MarkerIndex | int | str] = [],
        slidingMarkerOffsets: ArrayLike = [],
        slidingOffset: float = 0.0,
        nodeNumbers: Sequence[NodeIndex | int | str] = [-1, -1],
        usePenaltyFormulation: bool = False,
        penaltyStiffness: float = 0.0,
        activeConnector: bool = True,
        visualization: VObjectJointALEMoving2D | dict[str, Any] = ...,
    ) -> None: ...

ALEMovingJoint2D = ObjectJointALEMoving2D
VALEMovingJoint2D = VObjectJointALEMoving2D

class VObjectJointGeneric(_Visualization):
    """Visualization of ObjectJointGeneric."""

    show: bool
    """False: the item is not drawn"""
    axesRadius: float
    """radius of the drawn axes [m]"""
    axesLength: float
    """length of the drawn axes [m]"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    def __init__(
        self,
        show: bool = True,
        axesRadius: float = 0.1,
        axesLength: float = 0.4,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...

class ObjectJointGeneric(_Object):
    """A joint between two rigid body markers that constrains any choice of three translations and three rotations"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def markerNumbers(self) -> list[MarkerIndex]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def constrainedAxes(self) -> list[int]:
        """six flags, 1 constrained and 0 free: translation along the x, y, z axis of frame J0, rotation about them; other values are refused [6]"""
    @constrainedAxes.setter
    def constrainedAxes(self, value: Sequence[int]) -> None: ...
    @property
    def rotationMarker0(self) -> Array:
        """rotation matrix from joint frame J0 to the frame of marker m0; turns the axes of the joint [3 x 3; 1]"""
    @rotationMarker0.setter
    def rotationMarker0(self, value: ArrayLike) -> None: ...
    @property
    def rotationMarker1(self) -> Array:
        """rotation matrix from joint frame J1 to the frame of marker m1; the joint is in its zero position if J0 and J1 are parallel [3 x 3; 1]"""
    @rotationMarker1.setter
    def rotationMarker1(self, value: ArrayLike) -> None: ...
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @property
    def offsetUserFunctionParameters(self) -> Array:
        """six values that are passed to the user functions, of free meaning [6; various]"""
    @offsetUserFunctionParameters.setter
    def offsetUserFunctionParameters(self, value: ArrayLike) -> None: ...
    offsetUserFunction: Callable[[MainSystem, float, int, Array], ArrayLike] | Literal[0]
    """Python function that prescribes relative translation and rotation in the constrained directions, on position level"""
    offsetUserFunction_t: Callable[[MainSystem, float, int, Array], ArrayLike] | Literal[0]
    """Python function, the time derivative of ``offsetUserFunction``; index 2 integrators follow it alone"""
    alternativeConstraints: bool
    """True: other equations for three constrained rotations, which keep static solutions from flipping by half a turn; experimental"""
    @property
    def visualization(self) -> VObjectJointGeneric:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectJointGeneric | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int | str] = [-1, -1],
        constrainedAxes: Sequence[int] = [1, 1, 1, 1, 1, 1],
        rotationMarker0: ArrayLike = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        rotationMarker1: ArrayLike = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        activeConnector: bool = True,
        offsetUserFunctionParameters: ArrayLike = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        offsetUserFunction: Callable[[MainSystem, float, int, Array], ArrayLike] | Literal[0] = 0,
        offsetUserFunction_t: Callable[[MainSystem, float, int, Array], ArrayLike] | Literal[0] = 0,
        alternativeConstraints: bool = False,
        visualization: VObjectJointGeneric | dict[str, Any] = ...,
    ) -> None: ...

GenericJoint = ObjectJointGeneric
VGenericJoint = VObjectJointGeneric

class VObjectJointPrismatic2D(_Visualization):
    """Visualization of ObjectJointPrismatic2D."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...

class ObjectJointPrismatic2D(_Object):
    """A prismatic joint of planar bodies: one point moves on a line that is fixed to the other body"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def markerNumbers(self) -> list[MarkerIndex]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def axisMarker0(self) -> Array:
        """direction of the axis in the frame of marker m0, a unit vector in the x-y plane [3; 1]"""
    @axisMarker0.setter
    def axisMarker0(self, value: ArrayLike) -> None: ...
    @property
    def normalMarker1(self) -> Array:
        """normal of the axis in the frame of marker m1, a unit vector in the x-y plane; perpendicular to the axis in the initial position [3; 1]"""
    @normalMarker1.setter
    def normalMarker1(self, value: ArrayLike) -> None: ...
    constrainRotation: bool
    """True: the bodies do not rotate relative to each other; False: relative rotation is free"""
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @property
    def visualization(self) -> VObjectJointPrismatic2D:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectJointPrismatic2D | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int | str] = [-1, -1],
        axisMarker0: ArrayLike = [1.0, 0.0, 0.0],
        normalMarker1: ArrayLike = [0.0, 1.0, 0.0],
        constrainRotation: bool = True,
        activeConnector: bool = True,
        visualization: VObjectJointPrismatic2D | dict[str, Any] = ...,
    ) -> None: ...

PrismaticJoint2D = ObjectJointPrismatic2D
VPrismaticJoint2D = VObjectJointPrismatic2D

class VObjectJointPrismaticX(_Visualization):
    """Visualization of ObjectJointPrismaticX."""

    show: bool
    """False: the item is not drawn"""
    axisRadius: float
    """radius of the drawn axis [m]"""
    axisLength: float
    """length of the drawn axis [m]"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    def __init__(
        self,
        show: bool = True,
        axisRadius: float = 0.1,
        axisLength: float = 0.4,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...

class ObjectJointPrismaticX(_Object):
    """A prismatic joint between two rigid body markers, free to translate along the x axis of the joint frame"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def markerNumbers(self) -> list[MarkerIndex]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def rotationMarker0(self) -> Array:
        """rotation matrix from joint frame J0 to the frame of marker m0; turns the axes of the joint [3 x 3; 1]"""
    @rotationMarker0.setter
    def rotationMarker0(self, value: ArrayLike) -> None: ...
    @property
    def rotationMarker1(self) -> Array:
        """rotation matrix from joint frame J1 to the frame of marker m1; the joint is in its zero position if J0 and J1 are parallel [3 x 3; 1]"""
    @rotationMarker1.setter
    def rotationMarker1(self, value: ArrayLike) -> None: ...
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @property
    def visualization(self) -> VObjectJointPrismaticX:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectJointPrismaticX | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int | str] = [-1, -1],
        rotationMarker0: ArrayLike = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        rotationMarker1: ArrayLike = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        activeConnector: bool = True,
        visualization: VObjectJointPrismaticX | dict[str, Any] = ...,
    ) -> None: ...

PrismaticJointX = ObjectJointPrismaticX
VPrismaticJointX = VObjectJointPrismaticX

class VObjectJointRevolute2D(_Visualization):
    """Visualization of ObjectJointRevolute2D."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...

class ObjectJointRevolute2D(_Object):
    """A revolute joint of planar bodies: keeps two points together in the x-y plane"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def markerNumbers(self) -> list[MarkerIndex]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @property
    def visualization(self) -> VObjectJointRevolute2D:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectJointRevolute2D | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int | str] = [-1, -1],
        activeConnector: bool = True,
        visualization: VObjectJointRevolute2D | dict[str, Any] = ...,
    ) -> None: ...

RevoluteJoint2D = ObjectJointRevolute2D
VRevoluteJoint2D = VObjectJointRevolute2D

class VObjectJointRevoluteZ(_Visualization):
    """Visualization of ObjectJointRevoluteZ."""

    show: bool
    """False: the item is not drawn"""
    axisRadius: float
    """radius of the drawn axis [m]"""
    axisLength: float
    """length of the drawn axis [m]"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    def __init__(
        self,
        show: bool = True,
        axisRadius: float = 0.1,
        axisLength: float = 0.4,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...

class ObjectJointRevoluteZ(_Object):
    """A revolute joint between two rigid body markers, free to rotate about the z axis of the joint frame"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def markerNumbers(self) -> list[MarkerIndex]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def rotationMarker0(self) -> Array:
        """rotation matrix from joint frame J0 to the frame of marker m0; turns the axes of the joint [3 x 3; 1]"""
    @rotationMarker0.setter
    def rotationMarker0(self, value: ArrayLike) -> None: ...
    @property
    def rotationMarker1(self) -> Array:
        """rotation matrix from joint frame J1 to the frame of marker m1; the joint is in its zero position if J0 and J1 are parallel [3 x 3; 1]"""
    @rotationMarker1.setter
    def rotationMarker1(self, value: ArrayLike) -> None: ...
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @property
    def visualization(self) -> VObjectJointRevoluteZ:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectJointRevoluteZ | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int | str] = [-1, -1],
        rotationMarker0: ArrayLike = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        rotationMarker1: ArrayLike = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        activeConnector: bool = True,
        visualization: VObjectJointRevoluteZ | dict[str, Any] = ...,
    ) -> None: ...

RevoluteJointZ = ObjectJointRevoluteZ
VRevoluteJointZ = VObjectJointRevoluteZ

class VObjectJointRollingDisc(_Visualization):
    """Visualization of ObjectJointRollingDisc."""

    show: bool
    """False: the item is not drawn"""
    discWidth: float
    """width of the drawn disc [m]"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    def __init__(
        self,
        show: bool = True,
        discWidth: float = 0.1,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...

class ObjectJointRollingDisc(_Object):
    """A rigid disc that rolls on a plane without slip, by constraints on the velocity of the contact point"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def markerNumbers(self) -> list[MarkerIndex]:
        """marker m0 on the plane and marker m1 at the center of the disc [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def constrainedAxes(self) -> list[int]:
        """three flags, 1 constrained and 0 free: lateral, forward and normal velocity of the contact point; other values are refused [3]"""
    @constrainedAxes.setter
    def constrainedAxes(self, value: Sequence[int]) -> None: ...
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    discRadius: float
    """radius of the disc [m]"""
    @property
    def discAxis(self) -> Array:
        """axis of the disc in the frame of marker m1, a unit vector; must not become parallel to the normal of the plane [3; 1]"""
    @discAxis.setter
    def discAxis(self, value: ArrayLike) -> None: ...
    @property
    def planeNormal(self) -> Array:
        """normal of the plane in the frame of marker m0, a unit vector [3; 1]"""
    @planeNormal.setter
    def planeNormal(self, value: ArrayLike) -> None: ...
    @property
    def visualization(self) -> VObjectJointRollingDisc:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectJointRollingDisc | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int | str] = [-1, -1],
        constrainedAxes: Sequence[int] = [1, 1, 1],
        activeConnector: bool = True,
        discRadius: float = 0.0,
        discAxis: ArrayLike = [1.0, 0.0, 0.0],
        planeNormal: ArrayLike = [0.0, 0.0, 1.0],
        visualization: VObjectJointRollingDisc | dict[str, Any] = ...,
    ) -> None: ...

RollingDiscJoint = ObjectJointRollingDisc
VRollingDiscJoint = VObjectJointRollingDisc

class VObjectJointSliding(_Visualization):
    """Visualization of ObjectJointSliding."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...

class ObjectJointSliding(_Object):
    """A body that slides along a chain of ANCF cable elements in space"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def markerNumbers(self) -> list[MarkerIndex]:
        """marker m0 of the sliding body, and marker m1 of the cable element on which it begins, one of ``slidingMarkerNumbers``; the data node has the current element [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def slidingMarkerNumbers(self) -> list[MarkerIndex]:
        """shape markers of all cable elements in the order in which they follow each other: the end of one element is the begin of the next [n]"""
    @slidingMarkerNumbers.setter
    def slidingMarkerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def slidingMarkerOffsets(self) -> Array:
        """for each of these elements, the sum of the reference lengths of all elements before it; the first is 0; one for each of ``slidingMarkerNumbers`` [n; m]"""
    @slidingMarkerOffsets.setter
    def slidingMarkerOffsets(self, value: ArrayLike) -> None: ...
    @property
    def nodeNumber(self) -> NodeIndex:
        """NodeGenericData with two data coordinates: index of the current element in ``slidingMarkerNumbers``, and sliding coordinate at the begin of the step"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    @property
    def constrainRotations(self) -> list[int]:
        """three flags, 1 constrained and 0 free: rotation of marker m0, then a rigid body marker, about its x, y and z axis; cables do not tell how they are twisted, so that the first flag has to be 0 [3]"""
    @constrainRotations.setter
    def constrainRotations(self, value: Sequence[int]) -> None: ...
    @property
    def constrainTranslations(self) -> list[int]:
        """three flags, 1 constrained and 0 free: translation of marker m0 relative to the cable along the global axes [3]"""
    @constrainTranslations.setter
    def constrainTranslations(self, value: Sequence[int]) -> None: ...
    axialForce: float
    """force along the cable that drives the body; changed during a simulation to move the body [N]"""
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @property
    def visualization(self) -> VObjectJointSliding:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectJointSliding | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int | str] = [-1, -1],
        slidingMarkerNumbers: Sequence[MarkerIndex | int | str] = [],
        slidingMarkerOffsets: ArrayLike = [],
        nodeNumber: NodeIndex | int | str = -1,
        constrainRotations: Sequence[int] = [1, 1, 1],
        constrainTranslations: Sequence[int] = [1, 1, 1],
        axialForce: float = 0.0,
        activeConnector: bool = True,
        visualization: VObjectJointSliding | dict[str, Any] = ...,
    ) -> None: ...

SlidingJoint = ObjectJointSliding
VSlidingJoint = VObjectJointSliding

class VObjectJointSliding2D(_Visualization):
    """Visualization of ObjectJointSliding2D."""

    show: bool
    """False: the item is not drawn"""
    drawSize: float
    """size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings [m]"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    def __init__(
        self,
        show: bool = True,
        drawSize: float = -1.0,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...

class ObjectJointSliding2D(_Object):
    """A body that slides along a chain of planar ANCF cable elements"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def markerNumbers(self) -> list[MarkerIndex]:
        """marker m0 of the sliding body, and marker m1 of the cable element on which it begins, one of ``slidingMarkerNumbers``; the data node has the current element [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def slidingMarkerNumbers(self) -> list[MarkerIndex]:
        """coordinate markers of all cable elements in the order in which they follow each other: the end of one element is the begin of the next [n]"""
    @slidingMarkerNumbers.setter
    def slidingMarkerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def slidingMarkerOffsets(self) -> Array:
        """for each of these elements, the sum of the reference lengths of all elements before it; the first is 0; one for each of ``slidingMarkerNumbers`` [n; m]"""
    @slidingMarkerOffsets.setter
    def slidingMarkerOffsets(self, value: ArrayLike) -> None: ...
    @property
    def nodeNumber(self) -> NodeIndex:
        """NodeGenericData with two data coordinates: index of the current element in ``slidingMarkerNumbers``, and sliding coordinate at the begin of the step"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    classicalFormulation: bool
    """True: the force along the cable is prescribed, and both components of position are constrained; False: only the normal direction is constrained, by one multiplier"""
    useClassicalFormulation: bool
    """True: the force along the cable is prescribed, and both components of position are constrained; False: only the normal direction is constrained, by one multiplier"""
    constrainRotation: bool
    """True: marker m0, then a rigid body marker, keeps its orientation relative to the slope of the cable; False: it rotates freely"""
    axialForce: float
    """force along the cable that drives the body; only for ``classicalFormulation``; changed during a simulation to move the body [N]"""
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @property
    def visualization(self) -> VObjectJointSliding2D:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectJointSliding2D | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int | str] = [-1, -1],
        slidingMarkerNumbers: Sequence[MarkerIndex | int | str] = [],
        slidingMarkerOffsets: ArrayLike = [],
        nodeNumber: NodeIndex | int | str = -1,
        classicalFormulation: bool = True,
        constrainRotation: bool = False,
        axialForce: float = 0.0,
        activeConnector: bool = True,
        visualization: VObjectJointSliding2D | dict[str, Any] = ...,
        *,
        useClassicalFormulation: bool = ...,
    ) -> None: ...

SlidingJoint2D = ObjectJointSliding2D
VSlidingJoint2D = VObjectJointSliding2D

class VObjectJointSpherical(_Visualization):
    """Visualization of ObjectJointSpherical."""

    show: bool
    """False: the item is not drawn"""
    jointRadius: float
    """radius of the drawn joint [m]"""
    @property
    def color(self) -> Array:
        """red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings [4; 1]"""
    @color.setter
    def color(self, value: ArrayLike) -> None: ...
    def __init__(
        self,
        show: bool = True,
        jointRadius: float = 0.1,
        color: ArrayLike = [-1.0, -1.0, -1.0, -1.0],
    ) -> None: ...

class ObjectJointSpherical(_Object):
    """A ball joint: keeps two points together, or their chosen global components"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def markerNumbers(self) -> list[MarkerIndex]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def constrainedAxes(self) -> list[int]:
        """three flags, 1 constrained and 0 free: relative translation along the global x, y and z axis; other values are refused [3]"""
    @constrainedAxes.setter
    def constrainedAxes(self, value: Sequence[int]) -> None: ...
    activeConnector: bool
    """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @property
    def visualization(self) -> VObjectJointSpherical:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VObjectJointSpherical | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        markerNumbers: Sequence[MarkerIndex | int | str] = [-1, -1],
        constrainedAxes: Sequence[int] = [1, 1, 1],
        activeConnector: bool = True,
        visualization: VObjectJointSpherical | dict[str, Any] = ...,
    ) -> None: ...

SphericalJoint = ObjectJointSpherical
VSphericalJoint = VObjectJointSpherical

class VMarkerBodiesRelativeRotationCoordinate(_Visualization):
    """Visualization of MarkerBodiesRelativeRotationCoordinate."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...

class MarkerBodiesRelativeRotationCoordinate(_Marker):
    """A coordinate marker on the relative rotation of two bodies about an axis"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def bodyNumbers(self) -> list[ObjectIndex]:
        """the two bodies whose relative motion is the coordinate [2]"""
    @bodyNumbers.setter
    def bodyNumbers(self, value: Sequence[ObjectIndex | int | str]) -> None: ...
    @property
    def nodeNumber(self) -> NodeIndex:
        """NodeGenericData with one data coordinate that holds the last angle and makes the coordinate continuous beyond half a turn; not set: the angle jumps"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    @property
    def localPosition0(self) -> Array:
        """point in the frame of the first body, which is the position of the marker; the angle does not depend on it [3; m]"""
    @localPosition0.setter
    def localPosition0(self, value: ArrayLike) -> None: ...
    @property
    def localPosition1(self) -> Array:
        """point in the frame of the second body; no effect, because the angle does not depend on it [3; m]"""
    @localPosition1.setter
    def localPosition1(self, value: ArrayLike) -> None: ...
    @property
    def axis0(self) -> Array:
        """axis of rotation in the frame of the first body, a unit vector [3; 1]"""
    @axis0.setter
    def axis0(self, value: ArrayLike) -> None: ...
    offset: float
    """angle that is subtracted from the measured one [rad]"""
    @property
    def visualization(self) -> VMarkerBodiesRelativeRotationCoordinate:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VMarkerBodiesRelativeRotationCoordinate | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        bodyNumbers: Sequence[ObjectIndex | int | str] = [-1, -1],
        nodeNumber: NodeIndex | int | str = -1,
        localPosition0: ArrayLike = [0.0, 0.0, 0.0],
        localPosition1: ArrayLike = [0.0, 0.0, 0.0],
        axis0: ArrayLike = [1.0, 0.0, 0.0],
        offset: float = 0.0,
        visualization: VMarkerBodiesRelativeRotationCoordinate | dict[str, Any] = ...,
    ) -> None: ...

class VMarkerBodiesRelativeTranslationCoordinate(_Visualization):
    """Visualization of MarkerBodiesRelativeTranslationCoordinate."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...

class MarkerBodiesRelativeTranslationCoordinate(_Marker):
    """A coordinate marker on the relative translation of two bodies along an axis"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def bodyNumbers(self) -> list[ObjectIndex]:
        """the two bodies whose relative motion is the coordinate [2]"""
    @bodyNumbers.setter
    def bodyNumbers(self, value: Sequence[ObjectIndex | int | str]) -> None: ...
    @property
    def localPosition0(self) -> Array:
        """point in the frame of the first body [3; m]"""
    @localPosition0.setter
    def localPosition0(self, value: ArrayLike) -> None: ...
    @property
    def localPosition1(self) -> Array:
        """point in the frame of the second body [3; m]"""
    @localPosition1.setter
    def localPosition1(self, value: ArrayLike) -> None: ...
    @property
    def axis0(self) -> Array:
        """axis of translation in the frame of the first body, a unit vector [3; 1]"""
    @axis0.setter
    def axis0(self, value: ArrayLike) -> None: ...
    offset: float
    """length that is subtracted from the measured one [m]"""
    @property
    def visualization(self) -> VMarkerBodiesRelativeTranslationCoordinate:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VMarkerBodiesRelativeTranslationCoordinate | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        bodyNumbers: Sequence[ObjectIndex | int | str] = [-1, -1],
        localPosition0: ArrayLike = [0.0, 0.0, 0.0],
        localPosition1: ArrayLike = [0.0, 0.0, 0.0],
        axis0: ArrayLike = [1.0, 0.0, 0.0],
        offset: float = 0.0,
        visualization: VMarkerBodiesRelativeTranslationCoordinate | dict[str, Any] = ...,
    ) -> None: ...

class VMarkerBodyBeamShape(_Visualization):
    """Visualization of MarkerBodyBeamShape."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...

class MarkerBodyBeamShape(_Marker):
    """A marker that gives joints and contacts access to the shape of a beam element"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def bodyNumber(self) -> ObjectIndex:
        """spatial cable element to which the marker is attached"""
    @bodyNumber.setter
    def bodyNumber(self, value: ObjectIndex | int | str) -> None: ...
    @property
    def visualization(self) -> VMarkerBodyBeamShape:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VMarkerBodyBeamShape | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        bodyNumber: ObjectIndex | int | str = -1,
        visualization: VMarkerBodyBeamShape | dict[str, Any] = ...,
    ) -> None: ...

class VMarkerBodyCable2DCoordinates(_Visualization):
    """Visualization of MarkerBodyCable2DCoordinates."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...

class MarkerBodyCable2DCoordinates(_Marker):
    """A marker on all coordinates of a planar ANCF cable element, for sliding joints"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def bodyNumber(self) -> ObjectIndex:
        """planar cable element to which the marker is attached"""
    @bodyNumber.setter
    def bodyNumber(self, value: ObjectIndex | int | str) -> None: ...
    @property
    def visualization(self) -> VMarkerBodyCable2DCoordinates:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VMarkerBodyCable2DCoordinates | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        bodyNumber: ObjectIndex | int | str = -1,
        visualization: VMarkerBodyCable2DCoordinates | dict[str, Any] = ...,
    ) -> None: ...

class VMarkerBodyCable2DShape(_Visualization):
    """Visualization of MarkerBodyCable2DShape."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...

class MarkerBodyCable2DShape(_Marker):
    """A marker that divides a planar ANCF cable element into straight segments, for contact with circles"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def bodyNumber(self) -> ObjectIndex:
        """planar cable element to which the marker is attached"""
    @bodyNumber.setter
    def bodyNumber(self, value: ObjectIndex | int | str) -> None: ...
    numberOfSegments: int
    """number of segments; must be that of the contact that uses the marker"""
    verticalOffset: float
    """distance of the segments from the axis of the cable in direction of its local y axis, such as half the thickness of a belt [m]"""
    @property
    def visualization(self) -> VMarkerBodyCable2DShape:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VMarkerBodyCable2DShape | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        bodyNumber: ObjectIndex | int | str = -1,
        numberOfSegments: int = 3,
        verticalOffset: float = 0.0,
        visualization: VMarkerBodyCable2DShape | dict[str, Any] = ...,
    ) -> None: ...

class VMarkerBodyMass(_Visualization):
    """Visualization of MarkerBodyMass."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...

class MarkerBodyMass(_Marker):
    """A marker on the mass of a body, for loads that are proportional to mass such as gravity"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def bodyNumber(self) -> ObjectIndex:
        """body with a mass to which the marker is attached"""
    @bodyNumber.setter
    def bodyNumber(self, value: ObjectIndex | int | str) -> None: ...
    @property
    def visualization(self) -> VMarkerBodyMass:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VMarkerBodyMass | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        bodyNumber: ObjectIndex | int | str = -1,
        visualization: VMarkerBodyMass | dict[str, Any] = ...,
    ) -> None: ...

class VMarkerBodyPosition(_Visualization):
    """Visualization of MarkerBodyPosition."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...

class MarkerBodyPosition(_Marker):
    """A marker at a point that is fixed to a body, with its position but without orientation"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def bodyNumber(self) -> ObjectIndex:
        """body to which the marker is attached"""
    @bodyNumber.setter
    def bodyNumber(self, value: ObjectIndex | int | str) -> None: ...
    @property
    def localPosition(self) -> Array:
        """position of the marker in the body frame, relative to the reference point of the body [3; m]"""
    @localPosition.setter
    def localPosition(self, value: ArrayLike) -> None: ...
    @property
    def visualization(self) -> VMarkerBodyPosition:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VMarkerBodyPosition | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        bodyNumber: ObjectIndex | int | str = -1,
        localPosition: ArrayLike = [0.0, 0.0, 0.0],
        visualization: VMarkerBodyPosition | dict[str, Any] = ...,
    ) -> None: ...

class VMarkerBodyRigid(_Visualization):
    """Visualization of MarkerBodyRigid."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...

class MarkerBodyRigid(_Marker):
    """A marker at a point that is fixed to a body, with its position and orientation"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def bodyNumber(self) -> ObjectIndex:
        """body to which the marker is attached"""
    @bodyNumber.setter
    def bodyNumber(self, value: ObjectIndex | int | str) -> None: ...
    @property
    def localPosition(self) -> Array:
        """position of the marker in the body frame, relative to the reference point of the body [3; m]"""
    @localPosition.setter
    def localPosition(self, value: ArrayLike) -> None: ...
    @property
    def localRotation(self) -> Array:
        """rotation of the marker in the frame that it would have without: joints and body-fixed loads use the turned axes. ``localHT`` sets position and rotation [3 x 3; 1]"""
    @localRotation.setter
    def localRotation(self, value: ArrayLike) -> None: ...
    localHT: HT | ArrayLike
    """``localPosition`` and ``localRotation`` as ``exu.HT``, or as 4 x 4 matrix"""
    @property
    def visualization(self) -> VMarkerBodyRigid:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VMarkerBodyRigid | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        bodyNumber: ObjectIndex | int | str = -1,
        localPosition: ArrayLike = [0.0, 0.0, 0.0],
        localRotation: ArrayLike = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        visualization: VMarkerBodyRigid | dict[str, Any] = ...,
        *,
        localHT: HT | ArrayLike | None = None,
    ) -> None: ...

class VMarkerKinematicTreeRigid(_Visualization):
    """Visualization of MarkerKinematicTreeRigid."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...

class MarkerKinematicTreeRigid(_Marker):
    """A marker at a point that is fixed to a link of a kinematic tree, with position and orientation"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def objectNumber(self) -> ObjectIndex:
        """kinematic tree to which the marker is attached"""
    @objectNumber.setter
    def objectNumber(self, value: ObjectIndex | int | str) -> None: ...
    linkNumber: int | str
    """number of the link within the tree, from 0, or its name, or that of its joint; -1 means not set and is rejected"""
    @property
    def localPosition(self) -> Array:
        """position of the marker in the frame of the link [3; m]"""
    @localPosition.setter
    def localPosition(self, value: ArrayLike) -> None: ...
    @property
    def localRotation(self) -> Array:
        """rotation of the marker in the frame that it would have without: joints and body-fixed loads use the turned axes. ``localHT`` sets position and rotation [3 x 3; 1]"""
    @localRotation.setter
    def localRotation(self, value: ArrayLike) -> None: ...
    localHT: HT | ArrayLike
    """``localPosition`` and ``localRotation`` as ``exu.HT``, or as 4 x 4 matrix"""
    @property
    def visualization(self) -> VMarkerKinematicTreeRigid:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VMarkerKinematicTreeRigid | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        objectNumber: ObjectIndex | int | str = -1,
        linkNumber: int | str = -1,
        localPosition: ArrayLike = [0.0, 0.0, 0.0],
        localRotation: ArrayLike = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        visualization: VMarkerKinematicTreeRigid | dict[str, Any] = ...,
        *,
        localHT: HT | ArrayLike | None = None,
    ) -> None: ...

class VMarkerNodeCoordinate(_Visualization):
    """Visualization of MarkerNodeCoordinate."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...

class MarkerNodeCoordinate(_Marker):
    """A marker on a single coordinate of a node"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def nodeNumber(self) -> NodeIndex:
        """node to which the marker is attached"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    coordinate: int | str
    """number of the coordinate within the node, from 0, or the name of a joint of the kinematic tree on the node; -1 means not set and is rejected; any number reads zero at a ground node"""
    @property
    def visualization(self) -> VMarkerNodeCoordinate:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VMarkerNodeCoordinate | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        nodeNumber: NodeIndex | int | str = -1,
        coordinate: int | str = -1,
        visualization: VMarkerNodeCoordinate | dict[str, Any] = ...,
    ) -> None: ...

class VMarkerNodeCoordinates(_Visualization):
    """Visualization of MarkerNodeCoordinates."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...

class MarkerNodeCoordinates(_Marker):
    """A marker on all coordinates of a node, as a vector"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def nodeNumber(self) -> NodeIndex:
        """node to which the marker is attached"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    @property
    def visualization(self) -> VMarkerNodeCoordinates:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VMarkerNodeCoordinates | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        nodeNumber: NodeIndex | int | str = -1,
        visualization: VMarkerNodeCoordinates | dict[str, Any] = ...,
    ) -> None: ...

class VMarkerNodeODE1Coordinate(_Visualization):
    """Visualization of MarkerNodeODE1Coordinate."""

    show: bool
    """True: the item is drawn"""
    def __init__(
        self,
        show: bool = False,
    ) -> None: ...

class MarkerNodeODE1Coordinate(_Marker):
    """A marker on a single coordinate of a node with first order equations"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def nodeNumber(self) -> NodeIndex:
        """NodeGenericODE1 to which the marker is attached"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    coordinate: int
    """number of the coordinate within the node, from 0; -1 means not set and is rejected"""
    @property
    def visualization(self) -> VMarkerNodeODE1Coordinate:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VMarkerNodeODE1Coordinate | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        nodeNumber: NodeIndex | int | str = -1,
        coordinate: int = -1,
        visualization: VMarkerNodeODE1Coordinate | dict[str, Any] = ...,
    ) -> None: ...

class VMarkerNodePosition(_Visualization):
    """Visualization of MarkerNodePosition."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...

class MarkerNodePosition(_Marker):
    """A marker at the position of a node"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def nodeNumber(self) -> NodeIndex:
        """node with a position to which the marker is attached"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    @property
    def visualization(self) -> VMarkerNodePosition:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VMarkerNodePosition | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        nodeNumber: NodeIndex | int | str = -1,
        visualization: VMarkerNodePosition | dict[str, Any] = ...,
    ) -> None: ...

class VMarkerNodeRigid(_Visualization):
    """Visualization of MarkerNodeRigid."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...

class MarkerNodeRigid(_Marker):
    """A marker at a node with position and orientation"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def nodeNumber(self) -> NodeIndex:
        """node with position and orientation, such as a rigid body node, to which the marker is attached"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    @property
    def localRotation(self) -> Array:
        """rotation of the marker in the frame that it would have without: joints and body-fixed loads use the turned axes. ``localHT`` sets position and rotation [3 x 3; 1]"""
    @localRotation.setter
    def localRotation(self, value: ArrayLike) -> None: ...
    localHT: HT | ArrayLike
    """``localRotation`` as ``exu.HT``, or as 4 x 4 matrix"""
    @property
    def visualization(self) -> VMarkerNodeRigid:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VMarkerNodeRigid | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        nodeNumber: NodeIndex | int | str = -1,
        localRotation: ArrayLike = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        visualization: VMarkerNodeRigid | dict[str, Any] = ...,
        *,
        localHT: HT | ArrayLike | None = None,
    ) -> None: ...

class VMarkerNodeRotationCoordinate(_Visualization):
    """Visualization of MarkerNodeRotationCoordinate."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...

class MarkerNodeRotationCoordinate(_Marker):
    """A marker on the rotation of a node about one global axis"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def nodeNumber(self) -> NodeIndex:
        """node with an orientation in space to which the marker is attached; planar nodes are refused, use MarkerNodeCoordinate for them"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    rotationCoordinate: int
    """axis of rotation: 0 for x, 1 for y, 2 for z; -1 means not set and is rejected"""
    @property
    def visualization(self) -> VMarkerNodeRotationCoordinate:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VMarkerNodeRotationCoordinate | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        nodeNumber: NodeIndex | int | str = -1,
        rotationCoordinate: int = -1,
        visualization: VMarkerNodeRotationCoordinate | dict[str, Any] = ...,
    ) -> None: ...

class VMarkerObjectODE2Coordinates(_Visualization):
    """Visualization of MarkerObjectODE2Coordinates."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...

class MarkerObjectODE2Coordinates(_Marker):
    """A marker on all second order coordinates of an object, as a vector"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def objectNumber(self) -> ObjectIndex:
        """body to which the marker is attached"""
    @objectNumber.setter
    def objectNumber(self, value: ObjectIndex | int | str) -> None: ...
    @property
    def visualization(self) -> VMarkerObjectODE2Coordinates:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VMarkerObjectODE2Coordinates | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        objectNumber: ObjectIndex | int | str = -1,
        visualization: VMarkerObjectODE2Coordinates | dict[str, Any] = ...,
    ) -> None: ...

class VMarkerSuperElementPosition(_Visualization):
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

class MarkerSuperElementPosition(_Marker):
    """A marker at the weighted mean position of mesh nodes of a super element"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def bodyNumber(self) -> ObjectIndex:
        """super element to which the marker is attached"""
    @bodyNumber.setter
    def bodyNumber(self, value: ObjectIndex | int | str) -> None: ...
    @property
    def meshNodeNumbers(self) -> list[int]:
        """mesh nodes of the super element, numbered within it from 0; each must have a position [n]"""
    @meshNodeNumbers.setter
    def meshNodeNumbers(self, value: Sequence[int]) -> None: ...
    @property
    def weightingFactors(self) -> Array:
        """weight of every mesh node, as many as mesh nodes; should sum up to 1, such that the marker moves with a rigid translation of the nodes [n; 1]"""
    @weightingFactors.setter
    def weightingFactors(self, value: ArrayLike) -> None: ...
    @property
    def visualization(self) -> VMarkerSuperElementPosition:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VMarkerSuperElementPosition | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        bodyNumber: ObjectIndex | int | str = -1,
        meshNodeNumbers: Sequence[int] = [],
        weightingFactors: ArrayLike = [],
        visualization: VMarkerSuperElementPosition | dict[str, Any] = ...,
    ) -> None: ...

class VMarkerSuperElementRigid(_Visualization):
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

class MarkerSuperElementRigid(_Marker):
    """A marker with the weighted mean position and rotation of mesh nodes of a super element"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def bodyNumber(self) -> ObjectIndex:
        """super element to which the marker is attached"""
    @bodyNumber.setter
    def bodyNumber(self, value: ObjectIndex | int | str) -> None: ...
    @property
    def offset(self) -> Array:
        """correction of the marker position in the reference frame of the super element, if the mean of the mesh nodes is not the wanted point; should be small [3; m]"""
    @offset.setter
    def offset(self, value: ArrayLike) -> None: ...
    @property
    def meshNodeNumbers(self) -> list[int]:
        """mesh nodes of the super element, numbered within it from 0; each must have a position [n]"""
    @meshNodeNumbers.setter
    def meshNodeNumbers(self, value: Sequence[int]) -> None: ...
    @property
    def weightingFactors(self) -> Array:
        """weight of every mesh node, as many as mesh nodes; should sum up to 1, for instance parts of the area of an interface [n; 1]"""
    @weightingFactors.setter
    def weightingFactors(self, value: ArrayLike) -> None: ...
    useAlternativeApproach: bool
    """True: the mean rotation follows from the angular momentum of the weighted nodes; False: it is a mean weighted by squared distances"""
    rotationsExponentialMap: int
    """0: rotation and angular velocity are linearized; 1: rotation by the exponential map; 2: rotation by the exponential map and angular velocity by its tangent map, the consistent choice"""
    @property
    def localRotation(self) -> Array:
        """rotation of the marker in the frame that it would have without: joints and body-fixed loads use the turned axes. ``localHT`` sets position and rotation [3 x 3; 1]"""
    @localRotation.setter
    def localRotation(self, value: ArrayLike) -> None: ...
    localHT: HT | ArrayLike
    """``offset`` and ``localRotation`` as ``exu.HT``, or as 4 x 4 matrix"""
    @property
    def visualization(self) -> VMarkerSuperElementRigid:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VMarkerSuperElementRigid | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        bodyNumber: ObjectIndex | int | str = -1,
        offset: ArrayLike = [0.0, 0.0, 0.0],
        meshNodeNumbers: Sequence[int] = [],
        weightingFactors: ArrayLike = [],
        useAlternativeApproach: bool = True,
        rotationsExponentialMap: int = 2,
        localRotation: ArrayLike = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        visualization: VMarkerSuperElementRigid | dict[str, Any] = ...,
        *,
        localHT: HT | ArrayLike | None = None,
    ) -> None: ...

class VLoadCoordinate(_Visualization):
    """Visualization of LoadCoordinate."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...

class LoadCoordinate(_Load):
    """A generalized force on a single coordinate"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def markerNumber(self) -> MarkerIndex:
        """coordinate marker to which the load is applied"""
    @markerNumber.setter
    def markerNumber(self, value: MarkerIndex | int | str) -> None: ...
    load: float
    """generalized force: N on a coordinate that is a length, Nm on an angle; ignored if there is a user function, which receives it as an argument [various]"""
    loadUserFunction: Callable[[MainSystem, float, float], float] | Literal[0]
    """Python function that computes the load as a function of time"""
    @property
    def visualization(self) -> VLoadCoordinate:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VLoadCoordinate | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        markerNumber: MarkerIndex | int | str = -1,
        load: float = 0.0,
        loadUserFunction: Callable[[MainSystem, float, float], float] | Literal[0] = 0,
        visualization: VLoadCoordinate | dict[str, Any] = ...,
    ) -> None: ...

class VLoadForceVector(_Visualization):
    """Visualization of LoadForceVector."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...

class LoadForceVector(_Load):
    """A force vector at a point of a body or at a node"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def markerNumber(self) -> MarkerIndex:
        """marker with a position to which the force is applied; with ``bodyFixed`` it must have an orientation as well"""
    @markerNumber.setter
    def markerNumber(self, value: MarkerIndex | int | str) -> None: ...
    @property
    def loadVector(self) -> Array:
        """force vector in global coordinates, or in the marker frame with ``bodyFixed``; ignored if there is a user function, which receives it as an argument [3; N]"""
    @loadVector.setter
    def loadVector(self, value: ArrayLike) -> None: ...
    bodyFixed: bool
    """True: the vector is given in the frame of the marker and turns with the body, a follower force; False: in global coordinates"""
    loadVectorUserFunction: Callable[[MainSystem, float, Array], ArrayLike] | Literal[0]
    """Python function that computes the force vector as a function of time"""
    @property
    def visualization(self) -> VLoadForceVector:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VLoadForceVector | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        markerNumber: MarkerIndex | int | str = -1,
        loadVector: ArrayLike = [0.0, 0.0, 0.0],
        bodyFixed: bool = False,
        loadVectorUserFunction: Callable[[MainSystem, float, Array], ArrayLike] | Literal[0] = 0,
        visualization: VLoadForceVector | dict[str, Any] = ...,
    ) -> None: ...

Force = LoadForceVector
VForce = VLoadForceVector

class VLoadMassProportional(_Visualization):
    """Visualization of LoadMassProportional."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...

class LoadMassProportional(_Load):
    """A distributed load proportional to mass, such as gravity"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def markerNumber(self) -> MarkerIndex:
        """marker of type BodyMass on the body to which the load is applied"""
    @markerNumber.setter
    def markerNumber(self, value: MarkerIndex | int | str) -> None: ...
    @property
    def loadVector(self) -> Array:
        """force per mass in global coordinates, such as the gravitational acceleration ``[0, 0, -9.81]``; ignored if there is a user function, which receives it as an argument [3; m/s^2]"""
    @loadVector.setter
    def loadVector(self, value: ArrayLike) -> None: ...
    loadVectorUserFunction: Callable[[MainSystem, float, Array], ArrayLike] | Literal[0]
    """Python function that computes the vector as a function of time"""
    @property
    def visualization(self) -> VLoadMassProportional:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VLoadMassProportional | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        markerNumber: MarkerIndex | int | str = -1,
        loadVector: ArrayLike = [0.0, 0.0, 0.0],
        loadVectorUserFunction: Callable[[MainSystem, float, Array], ArrayLike] | Literal[0] = 0,
        visualization: VLoadMassProportional | dict[str, Any] = ...,
    ) -> None: ...

Gravity = LoadMassProportional
VGravity = VLoadMassProportional

class VLoadTorqueVector(_Visualization):
    """Visualization of LoadTorqueVector."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...

class LoadTorqueVector(_Load):
    """A torque vector on a body or node with orientation"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def markerNumber(self) -> MarkerIndex:
        """marker with an orientation to which the torque is applied"""
    @markerNumber.setter
    def markerNumber(self, value: MarkerIndex | int | str) -> None: ...
    @property
    def loadVector(self) -> Array:
        """torque vector in global coordinates, or in the marker frame with ``bodyFixed``; ignored if there is a user function, which receives it as an argument [3; Nm]"""
    @loadVector.setter
    def loadVector(self, value: ArrayLike) -> None: ...
    bodyFixed: bool
    """True: the vector is given in the frame of the marker and turns with the body; False: in global coordinates"""
    loadVectorUserFunction: Callable[[MainSystem, float, Array], ArrayLike] | Literal[0]
    """Python function that computes the torque vector as a function of time"""
    @property
    def visualization(self) -> VLoadTorqueVector:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VLoadTorqueVector | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        markerNumber: MarkerIndex | int | str = -1,
        loadVector: ArrayLike = [0.0, 0.0, 0.0],
        bodyFixed: bool = False,
        loadVectorUserFunction: Callable[[MainSystem, float, Array], ArrayLike] | Literal[0] = 0,
        visualization: VLoadTorqueVector | dict[str, Any] = ...,
    ) -> None: ...

Torque = LoadTorqueVector
VTorque = VLoadTorqueVector

class VSensorBody(_Visualization):
    """Visualization of SensorBody."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...

class SensorBody(_Sensor):
    """Measures an output variable of a body at a local position"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def bodyNumber(self) -> ObjectIndex:
        """body that is measured"""
    @bodyNumber.setter
    def bodyNumber(self, value: ObjectIndex | int | str) -> None: ...
    @property
    def localPosition(self) -> Array:
        """point in the body frame, relative to the reference point; the x component of beams and cables is the position along the axis [3; m]"""
    @localPosition.setter
    def localPosition(self, value: ArrayLike) -> None: ...
    writeToFile: bool
    """write the measured values to a file while a solver runs; no effect if ``fileName`` is empty"""
    fileName: str
    """file with the time in the first and the values in the further columns; the path is relative to the working directory, missing directories are created"""
    outputVariableType: OutputVariableType
    """output variable that is measured; one that the measured item does not provide is refused in Assemble"""
    storeInternal: bool
    """keep time and values in memory, to be read with ``mbs.GetSensorStoredData`` during or after the solution"""
    @property
    def visualization(self) -> VSensorBody:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VSensorBody | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        bodyNumber: ObjectIndex | int | str = -1,
        localPosition: ArrayLike = [0.0, 0.0, 0.0],
        writeToFile: bool = True,
        fileName: str = '',
        outputVariableType: OutputVariableType = OutputVariableType._None,
        storeInternal: bool = False,
        visualization: VSensorBody | dict[str, Any] = ...,
    ) -> None: ...

class VSensorKinematicTree(_Visualization):
    """Visualization of SensorKinematicTree."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...

class SensorKinematicTree(_Sensor):
    """Measures an output variable of a link of a kinematic tree at a local position"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def objectNumber(self) -> ObjectIndex:
        """kinematic tree that is measured"""
    @objectNumber.setter
    def objectNumber(self, value: ObjectIndex | int | str) -> None: ...
    linkNumber: int | str
    """link, numbered within the tree from 0, or its name, or that of its joint; -1 means not set and is rejected"""
    @property
    def localPosition(self) -> Array:
        """point in the frame of the link [3; m]"""
    @localPosition.setter
    def localPosition(self, value: ArrayLike) -> None: ...
    writeToFile: bool
    """write the measured values to a file while a solver runs; no effect if ``fileName`` is empty"""
    fileName: str
    """file with the time in the first and the values in the further columns; the path is relative to the working directory, missing directories are created"""
    outputVariableType: OutputVariableType
    """output variable that is measured; one that the measured item does not provide is refused in Assemble"""
    storeInternal: bool
    """keep time and values in memory, to be read with ``mbs.GetSensorStoredData`` during or after the solution"""
    @property
    def visualization(self) -> VSensorKinematicTree:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VSensorKinematicTree | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        objectNumber: ObjectIndex | int | str = -1,
        linkNumber: int | str = -1,
        localPosition: ArrayLike = [0.0, 0.0, 0.0],
        writeToFile: bool = True,
        fileName: str = '',
        outputVariableType: OutputVariableType = OutputVariableType._None,
        storeInternal: bool = False,
        visualization: VSensorKinematicTree | dict[str, Any] = ...,
    ) -> None: ...

class VSensorLoad(_Visualization):
    """Visualization of SensorLoad."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...

class SensorLoad(_Sensor):
    """Measures the value of a load"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def loadNumber(self) -> LoadIndex:
        """load that is measured"""
    @loadNumber.setter
    def loadNumber(self, value: LoadIndex | int | str) -> None: ...
    writeToFile: bool
    """write the measured values to a file while a solver runs; no effect if ``fileName`` is empty"""
    fileName: str
    """file with the time in the first and the values in the further columns; the path is relative to the working directory, missing directories are created"""
    storeInternal: bool
    """keep time and values in memory, to be read with ``mbs.GetSensorStoredData`` during or after the solution"""
    @property
    def visualization(self) -> VSensorLoad:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VSensorLoad | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        loadNumber: LoadIndex | int | str = -1,
        writeToFile: bool = True,
        fileName: str = '',
        storeInternal: bool = False,
        visualization: VSensorLoad | dict[str, Any] = ...,
    ) -> None: ...

class VSensorMarker(_Visualization):
    """Visualization of SensorMarker."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...

class SensorMarker(_Sensor):
    """Measures an output variable of a marker"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def markerNumber(self) -> MarkerIndex:
        """marker that is measured"""
    @markerNumber.setter
    def markerNumber(self, value: MarkerIndex | int | str) -> None: ...
    writeToFile: bool
    """write the measured values to a file while a solver runs; no effect if ``fileName`` is empty"""
    fileName: str
    """file with the time in the first and the values in the further columns; the path is relative to the working directory, missing directories are created"""
    outputVariableType: OutputVariableType
    """output variable that is measured; one that the measured item does not provide is refused in Assemble"""
    storeInternal: bool
    """keep time and values in memory, to be read with ``mbs.GetSensorStoredData`` during or after the solution"""
    @property
    def visualization(self) -> VSensorMarker:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VSensorMarker | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        markerNumber: MarkerIndex | int | str = -1,
        writeToFile: bool = True,
        fileName: str = '',
        outputVariableType: OutputVariableType = OutputVariableType._None,
        storeInternal: bool = False,
        visualization: VSensorMarker | dict[str, Any] = ...,
    ) -> None: ...

class VSensorNode(_Visualization):
    """Visualization of SensorNode."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...

class SensorNode(_Sensor):
    """Measures an output variable of a node"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def nodeNumber(self) -> NodeIndex:
        """node that is measured"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    writeToFile: bool
    """write the measured values to a file while a solver runs; no effect if ``fileName`` is empty"""
    fileName: str
    """file with the time in the first and the values in the further columns; the path is relative to the working directory, missing directories are created"""
    outputVariableType: OutputVariableType
    """output variable that is measured; one that the measured item does not provide is refused in Assemble"""
    storeInternal: bool
    """keep time and values in memory, to be read with ``mbs.GetSensorStoredData`` during or after the solution"""
    @property
    def visualization(self) -> VSensorNode:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VSensorNode | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        nodeNumber: NodeIndex | int | str = -1,
        writeToFile: bool = True,
        fileName: str = '',
        outputVariableType: OutputVariableType = OutputVariableType._None,
        storeInternal: bool = False,
        visualization: VSensorNode | dict[str, Any] = ...,
    ) -> None: ...

class VSensorObject(_Visualization):
    """Visualization of SensorObject."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...

class SensorObject(_Sensor):
    """Measures an output variable of a connector, constraint, joint or contact"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def objectNumber(self) -> ObjectIndex:
        """object that is measured; a body is refused for variables that need a local position, use SensorBody for it"""
    @objectNumber.setter
    def objectNumber(self, value: ObjectIndex | int | str) -> None: ...
    writeToFile: bool
    """write the measured values to a file while a solver runs; no effect if ``fileName`` is empty"""
    fileName: str
    """file with the time in the first and the values in the further columns; the path is relative to the working directory, missing directories are created"""
    outputVariableType: OutputVariableType
    """output variable that is measured; one that the measured item does not provide is refused in Assemble"""
    storeInternal: bool
    """keep time and values in memory, to be read with ``mbs.GetSensorStoredData`` during or after the solution"""
    @property
    def visualization(self) -> VSensorObject:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VSensorObject | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        objectNumber: ObjectIndex | int | str = -1,
        writeToFile: bool = True,
        fileName: str = '',
        outputVariableType: OutputVariableType = OutputVariableType._None,
        storeInternal: bool = False,
        visualization: VSensorObject | dict[str, Any] = ...,
    ) -> None: ...

class VSensorSuperElement(_Visualization):
    """Visualization of SensorSuperElement."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...

class SensorSuperElement(_Sensor):
    """Measures an output variable at a mesh node of a super element"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def bodyNumber(self) -> ObjectIndex:
        """super element that is measured"""
    @bodyNumber.setter
    def bodyNumber(self, value: ObjectIndex | int | str) -> None: ...
    meshNodeNumber: int | str
    """mesh node, numbered within the super element from 0, or the name of a link of a kinematic tree; -1 means not set and is rejected"""
    writeToFile: bool
    """write the measured values to a file while a solver runs; no effect if ``fileName`` is empty"""
    fileName: str
    """file with the time in the first and the values in the further columns; the path is relative to the working directory, missing directories are created"""
    outputVariableType: OutputVariableType
    """output variable that is measured; one that the measured item does not provide is refused in Assemble"""
    storeInternal: bool
    """keep time and values in memory, to be read with ``mbs.GetSensorStoredData`` during or after the solution"""
    @property
    def visualization(self) -> VSensorSuperElement:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VSensorSuperElement | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        bodyNumber: ObjectIndex | int | str = -1,
        meshNodeNumber: int | str = -1,
        writeToFile: bool = True,
        fileName: str = '',
        outputVariableType: OutputVariableType = OutputVariableType._None,
        storeInternal: bool = False,
        visualization: VSensorSuperElement | dict[str, Any] = ...,
    ) -> None: ...

class VSensorUserFunction(_Visualization):
    """Visualization of SensorUserFunction."""

    show: bool
    """False: the item is not drawn"""
    def __init__(
        self,
        show: bool = True,
    ) -> None: ...

class SensorUserFunction(_Sensor):
    """Computes its values by a Python function, for instance from other sensors"""

    name: str
    """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @property
    def sensorNumbers(self) -> list[SensorIndex]:
        """sensors that the user function may evaluate; may be empty [n]"""
    @sensorNumbers.setter
    def sensorNumbers(self, value: Sequence[SensorIndex | int | str]) -> None: ...
    @property
    def factors(self) -> Array:
        """values that are passed to the user function, of free meaning, such as weights or conversions of units [n; various]"""
    @factors.setter
    def factors(self, value: ArrayLike) -> None: ...
    writeToFile: bool
    """write the measured values to a file while a solver runs; no effect if ``fileName`` is empty"""
    fileName: str
    """file with the time in the first and the values in the further columns; the path is relative to the working directory, missing directories are created"""
    sensorUserFunction: Callable[[MainSystem, float, list[int], Array, ConfigurationType], ArrayLike] | Literal[0]
    """Python function that returns the values of the sensor"""
    storeInternal: bool
    """keep time and values in memory, to be read with ``mbs.GetSensorStoredData`` during or after the solution"""
    @property
    def visualization(self) -> VSensorUserFunction:
        """how the item is drawn"""
    @visualization.setter
    def visualization(self, value: VSensorUserFunction | dict[str, Any]) -> None: ...
    def __init__(
        self,
        name: str = '',
        sensorNumbers: Sequence[SensorIndex | int | str] = [],
        factors: ArrayLike = [],
        writeToFile: bool = True,
        fileName: str = '',
        sensorUserFunction: Callable[[MainSystem, float, list[int], Array, ConfigurationType], ArrayLike] | Literal[0] = 0,
        storeInternal: bool = False,
        visualization: VSensorUserFunction | dict[str, Any] = ...,
    ) -> None: ...
