# Generated from specs/ by codegen/templates/item_handles.pyi.j2. Do not edit; run `python -m codegen`.
# tests/codegen/test_freshness.py compares this file with its sources.

from collections.abc import Callable, Sequence
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from dalembert._core import (
    BeamSection,
    BeamSectionGeometry,
    ConfigurationType,
    JointType,
    LoadIndex,
    MainSystem,
    MarkerIndex,
    Matrix3DList,
    MatrixContainer,
    NodeIndex,
    ObjectIndex,
    OutputVariableType,
    SensorIndex,
    Vector3DList,
    Vector6DList,
)
from dalembert._core_types import Array, MatrixLike
from dalembert._geometry.rigid_transformation import HT
from dalembert._model.handle import LoadHandle, MarkerHandle, NodeHandle, ObjectHandle, SensorHandle

class NodeGenericAE(NodeHandle):
    """Handle: node with a chosen number of algebraic variables, for equations that hold without time derivatives"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def reference_coordinates(self) -> Array:
        """reference values; their number is ``numberOfAECoordinates``; units are those of the equations that use the node [n; various]"""
    @reference_coordinates.setter
    def reference_coordinates(self, value: ArrayLike) -> None: ...
    @property
    def referenceCoordinates(self) -> Array:
        """reference values; their number is ``numberOfAECoordinates``; units are those of the equations that use the node [n; various]"""
    @referenceCoordinates.setter
    def referenceCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initial_coordinates(self) -> Array:
        """start values of the solver, relative to the reference values; their number is ``numberOfAECoordinates`` [n; various]"""
    @initial_coordinates.setter
    def initial_coordinates(self, value: ArrayLike) -> None: ...
    @property
    def initialCoordinates(self) -> Array:
        """start values of the solver, relative to the reference values; their number is ``numberOfAECoordinates`` [n; various]"""
    @initialCoordinates.setter
    def initialCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def number_of_ae_coordinates(self) -> int:
        """number of algebraic variables; at least 1"""
    @number_of_ae_coordinates.setter
    def number_of_ae_coordinates(self, value: int) -> None: ...
    @property
    def numberOfAECoordinates(self) -> int:
        """number of algebraic variables; at least 1"""
    @numberOfAECoordinates.setter
    def numberOfAECoordinates(self, value: int) -> None: ...
    @property
    def coordinates(self) -> Array:
        """algebraic variables, relative to the reference values [various]"""

class NodeGenericData(NodeHandle):
    """Handle: node with a chosen number of data variables: states that are kept from step to step and are not unknowns of the solver"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def initial_coordinates(self) -> Array:
        """values at the start of a computation; their number is ``numberOfDataCoordinates``, or zero (all values are zero); other lengths are rejected; their meaning and units are those of the object that uses the node [n; various]"""
    @initial_coordinates.setter
    def initial_coordinates(self, value: ArrayLike) -> None: ...
    @property
    def initialCoordinates(self) -> Array:
        """values at the start of a computation; their number is ``numberOfDataCoordinates``, or zero (all values are zero); other lengths are rejected; their meaning and units are those of the object that uses the node [n; various]"""
    @initialCoordinates.setter
    def initialCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def number_of_data_coordinates(self) -> int:
        """number of data variables; objects that need a data node say how many they expect"""
    @number_of_data_coordinates.setter
    def number_of_data_coordinates(self, value: int) -> None: ...
    @property
    def numberOfDataCoordinates(self) -> int:
        """number of data variables; objects that need a data node say how many they expect"""
    @numberOfDataCoordinates.setter
    def numberOfDataCoordinates(self, value: int) -> None: ...
    @property
    def coordinates(self) -> Array:
        """data variables; there are no reference values and no time derivatives [various]"""

class NodeGenericODE1(NodeHandle):
    """Handle: node with a chosen number of coordinates of first order differential equations, for controllers, hydraulics and state-space models"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def reference_coordinates(self) -> Array:
        """constant values to which the coordinates are added; their number is ``numberOfODE1Coordinates``, or zero (all values are zero); other lengths are rejected; units are those of the equations that use the node [n; various]"""
    @reference_coordinates.setter
    def reference_coordinates(self, value: ArrayLike) -> None: ...
    @property
    def referenceCoordinates(self) -> Array:
        """constant values to which the coordinates are added; their number is ``numberOfODE1Coordinates``, or zero (all values are zero); other lengths are rejected; units are those of the equations that use the node [n; various]"""
    @referenceCoordinates.setter
    def referenceCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initial_coordinates(self) -> Array:
        """values at the start, relative to the reference values; their number is ``numberOfODE1Coordinates`` [n; various]"""
    @initial_coordinates.setter
    def initial_coordinates(self, value: ArrayLike) -> None: ...
    @property
    def initialCoordinates(self) -> Array:
        """values at the start, relative to the reference values; their number is ``numberOfODE1Coordinates`` [n; various]"""
    @initialCoordinates.setter
    def initialCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def number_of_ode1_coordinates(self) -> int:
        """number of coordinates, each with a first order differential equation; at least 1"""
    @number_of_ode1_coordinates.setter
    def number_of_ode1_coordinates(self, value: int) -> None: ...
    @property
    def numberOfODE1Coordinates(self) -> int:
        """number of coordinates, each with a first order differential equation; at least 1"""
    @numberOfODE1Coordinates.setter
    def numberOfODE1Coordinates(self, value: int) -> None: ...
    @property
    def coordinates_total(self) -> Array:
        """coordinates plus reference coordinates [various]"""
    @property
    def coordinates(self) -> Array:
        """coordinates without the reference coordinates, so zero in the reference configuration [various]"""
    @property
    def coordinates_t(self) -> Array:
        """first time derivative of the coordinates [various]"""

class NodeGenericODE2(NodeHandle):
    """Handle: node with a chosen number of coordinates of second order differential equations, without a meaning in space"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def reference_coordinates(self) -> Array:
        """constant values to which the coordinates are added; their number is ``numberOfODE2Coordinates``, or zero (all values are zero); other lengths are rejected; units are those of the equations that use the node [n; various]"""
    @reference_coordinates.setter
    def reference_coordinates(self, value: ArrayLike) -> None: ...
    @property
    def referenceCoordinates(self) -> Array:
        """constant values to which the coordinates are added; their number is ``numberOfODE2Coordinates``, or zero (all values are zero); other lengths are rejected; units are those of the equations that use the node [n; various]"""
    @referenceCoordinates.setter
    def referenceCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initial_coordinates(self) -> Array:
        """values at the start, relative to the reference values; their number is ``numberOfODE2Coordinates`` [n; various]"""
    @initial_coordinates.setter
    def initial_coordinates(self, value: ArrayLike) -> None: ...
    @property
    def initialCoordinates(self) -> Array:
        """values at the start, relative to the reference values; their number is ``numberOfODE2Coordinates`` [n; various]"""
    @initialCoordinates.setter
    def initialCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initial_coordinates_t(self) -> Array:
        """time derivatives of the coordinates at the start; their number is ``numberOfODE2Coordinates`` [n; various]"""
    @initial_coordinates_t.setter
    def initial_coordinates_t(self, value: ArrayLike) -> None: ...
    @property
    def initialCoordinates_t(self) -> Array:
        """time derivatives of the coordinates at the start; their number is ``numberOfODE2Coordinates`` [n; various]"""
    @initialCoordinates_t.setter
    def initialCoordinates_t(self, value: ArrayLike) -> None: ...
    @property
    def number_of_ode2_coordinates(self) -> int:
        """number of coordinates, each with a second order differential equation; at least 1"""
    @number_of_ode2_coordinates.setter
    def number_of_ode2_coordinates(self, value: int) -> None: ...
    @property
    def numberOfODE2Coordinates(self) -> int:
        """number of coordinates, each with a second order differential equation; at least 1"""
    @numberOfODE2Coordinates.setter
    def numberOfODE2Coordinates(self, value: int) -> None: ...
    @property
    def coordinates_total(self) -> Array:
        """coordinates plus reference coordinates [various]"""
    @property
    def coordinates(self) -> Array:
        """coordinates without the reference coordinates, so zero in the reference configuration [various]"""
    @property
    def coordinates_t(self) -> Array:
        """first time derivative of the coordinates [various]"""
    @property
    def coordinates_tt(self) -> Array:
        """second time derivative of the coordinates [various]"""

class Node1D(NodeHandle):
    """Handle: node with one coordinate of a second order differential equation, for motion along a line or about a fixed axis"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def reference_coordinates(self) -> Array:
        """reference value of the coordinate, a list of length 1, or an empty one for zero; m for a translation, rad for a rotation, as the body on the node says [n; various]"""
    @reference_coordinates.setter
    def reference_coordinates(self, value: ArrayLike) -> None: ...
    @property
    def referenceCoordinates(self) -> Array:
        """reference value of the coordinate, a list of length 1, or an empty one for zero; m for a translation, rad for a rotation, as the body on the node says [n; various]"""
    @referenceCoordinates.setter
    def referenceCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initial_coordinates(self) -> Array:
        """coordinate at the start, relative to the reference value, a list of length 1, or an empty one for zero [n; various]"""
    @initial_coordinates.setter
    def initial_coordinates(self, value: ArrayLike) -> None: ...
    @property
    def initialCoordinates(self) -> Array:
        """coordinate at the start, relative to the reference value, a list of length 1, or an empty one for zero [n; various]"""
    @initialCoordinates.setter
    def initialCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initial_velocities(self) -> Array:
        """time derivative of the coordinate at the start, a list of length 1, or an empty one for zero [n; various]"""
    @initial_velocities.setter
    def initial_velocities(self, value: ArrayLike) -> None: ...
    @property
    def initialVelocities(self) -> Array:
        """time derivative of the coordinate at the start, a list of length 1, or an empty one for zero [n; various]"""
    @initialVelocities.setter
    def initialVelocities(self, value: ArrayLike) -> None: ...
    @property
    def coordinates_total(self) -> Array:
        """coordinates plus reference coordinates [various]"""
    @property
    def coordinates(self) -> Array:
        """coordinates without the reference coordinates, so zero in the reference configuration [various]"""
    @property
    def coordinates_t(self) -> Array:
        """first time derivative of the coordinates [various]"""
    @property
    def coordinates_tt(self) -> Array:
        """second time derivative of the coordinates [various]"""

class NodePoint(NodeHandle):
    """Handle: node with the three displacements of a point in space"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def reference_coordinates(self) -> Array:
        """global position of the node without displacement [3; m]"""
    @reference_coordinates.setter
    def reference_coordinates(self, value: ArrayLike) -> None: ...
    @property
    def referenceCoordinates(self) -> Array:
        """global position of the node without displacement [3; m]"""
    @referenceCoordinates.setter
    def referenceCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initial_coordinates(self) -> Array:
        """displacement from the reference position at the start [3; m]"""
    @initial_coordinates.setter
    def initial_coordinates(self, value: ArrayLike) -> None: ...
    @property
    def initialCoordinates(self) -> Array:
        """displacement from the reference position at the start [3; m]"""
    @initialCoordinates.setter
    def initialCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initial_velocities(self) -> Array:
        """global velocity at the start [3; m/s]"""
    @initial_velocities.setter
    def initial_velocities(self, value: ArrayLike) -> None: ...
    @property
    def initialVelocities(self) -> Array:
        """global velocity at the start [3; m/s]"""
    @initialVelocities.setter
    def initialVelocities(self, value: ArrayLike) -> None: ...
    @property
    def position(self) -> Array:
        """global position vector [m]"""
    @property
    def displacement(self) -> Array:
        """global position minus the global position in the reference configuration [m]"""
    @property
    def velocity(self) -> Array:
        """global velocity [m/s]"""
    @property
    def acceleration(self) -> Array:
        """global acceleration [m/s^2]"""
    @property
    def coordinates_total(self) -> Array:
        """coordinates plus reference coordinates [m]"""
    @property
    def coordinates(self) -> Array:
        """coordinates without the reference coordinates, so zero in the reference configuration [m]"""
    @property
    def coordinates_t(self) -> Array:
        """first time derivative of the coordinates [m/s]"""
    @property
    def coordinates_tt(self) -> Array:
        """second time derivative of the coordinates [m/s^2]"""
    @property
    def rotation_matrix(self) -> Array:
        """identity matrix, row by row, as the node has no orientation [1]"""
    @property
    def rotation(self) -> Array:
        """zero, as the node has no orientation; there for completeness [rad]"""
    @property
    def angular_velocity(self) -> Array:
        """zero, as the node has no orientation; there for completeness [rad/s]"""
    @property
    def angular_velocity_local(self) -> Array:
        """zero, as the node has no orientation; there for completeness [rad/s]"""
    @property
    def homogeneous_transformation(self) -> HT:
        """position and rotation as a 4 x 4 matrix, row by row; output functions return ``exu.HT`` [various]"""

class NodePoint2D(NodeHandle):
    """Handle: node with the two displacements of a point in the global x-y plane"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def reference_coordinates(self) -> Array:
        """global x and y position of the node without displacement; z is zero [2; m]"""
    @reference_coordinates.setter
    def reference_coordinates(self, value: ArrayLike) -> None: ...
    @property
    def referenceCoordinates(self) -> Array:
        """global x and y position of the node without displacement; z is zero [2; m]"""
    @referenceCoordinates.setter
    def referenceCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initial_coordinates(self) -> Array:
        """displacement in x and y from the reference position at the start [2; m]"""
    @initial_coordinates.setter
    def initial_coordinates(self, value: ArrayLike) -> None: ...
    @property
    def initialCoordinates(self) -> Array:
        """displacement in x and y from the reference position at the start [2; m]"""
    @initialCoordinates.setter
    def initialCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initial_velocities(self) -> Array:
        """global velocity in x and y at the start [2; m/s]"""
    @initial_velocities.setter
    def initial_velocities(self, value: ArrayLike) -> None: ...
    @property
    def initialVelocities(self) -> Array:
        """global velocity in x and y at the start [2; m/s]"""
    @initialVelocities.setter
    def initialVelocities(self, value: ArrayLike) -> None: ...
    @property
    def position(self) -> Array:
        """global position; the third component is zero [m]"""
    @property
    def displacement(self) -> Array:
        """global displacement; the third component is zero [m]"""
    @property
    def velocity(self) -> Array:
        """global velocity; the third component is zero [m/s]"""
    @property
    def acceleration(self) -> Array:
        """global acceleration; the third component is zero [m/s^2]"""
    @property
    def coordinates_total(self) -> Array:
        """coordinates plus reference coordinates [m]"""
    @property
    def coordinates(self) -> Array:
        """coordinates without the reference coordinates, so zero in the reference configuration [m]"""
    @property
    def coordinates_t(self) -> Array:
        """first time derivative of the coordinates [m/s]"""
    @property
    def coordinates_tt(self) -> Array:
        """second time derivative of the coordinates [m/s^2]"""
    @property
    def rotation_matrix(self) -> Array:
        """identity matrix, row by row, as the node has no orientation [1]"""
    @property
    def rotation(self) -> Array:
        """zero, as the node has no orientation; there for completeness [rad]"""
    @property
    def angular_velocity(self) -> Array:
        """zero, as the node has no orientation; there for completeness [rad/s]"""
    @property
    def angular_velocity_local(self) -> Array:
        """zero, as the node has no orientation; there for completeness [rad/s]"""
    @property
    def homogeneous_transformation(self) -> HT:
        """position and rotation as a 4 x 4 matrix, row by row; output functions return ``exu.HT`` [various]"""

class NodePoint2DSlope1(NodeHandle):
    """Handle: node of planar cable elements: position and axial slope vector in the global x-y plane"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def reference_coordinates(self) -> Array:
        """x and y position (m), then x and y component of the slope vector (1); a unit vector along the axis for an element that is not stretched in the reference configuration [4; various]"""
    @reference_coordinates.setter
    def reference_coordinates(self, value: ArrayLike) -> None: ...
    @property
    def referenceCoordinates(self) -> Array:
        """x and y position (m), then x and y component of the slope vector (1); a unit vector along the axis for an element that is not stretched in the reference configuration [4; various]"""
    @referenceCoordinates.setter
    def referenceCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initial_coordinates(self) -> Array:
        """displacement (m) and change of the slope vector (1) at the start, relative to the reference coordinates [4; various]"""
    @initial_coordinates.setter
    def initial_coordinates(self, value: ArrayLike) -> None: ...
    @property
    def initialCoordinates(self) -> Array:
        """displacement (m) and change of the slope vector (1) at the start, relative to the reference coordinates [4; various]"""
    @initialCoordinates.setter
    def initialCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initial_velocities(self) -> Array:
        """velocity (m/s) and rate of the slope vector (1/s) at the start [4; various]"""
    @initial_velocities.setter
    def initial_velocities(self, value: ArrayLike) -> None: ...
    @property
    def initialVelocities(self) -> Array:
        """velocity (m/s) and rate of the slope vector (1/s) at the start [4; various]"""
    @initialVelocities.setter
    def initialVelocities(self, value: ArrayLike) -> None: ...
    @property
    def position(self) -> Array:
        """global position vector [m]"""
    @property
    def displacement(self) -> Array:
        """global position minus the global position in the reference configuration [m]"""
    @property
    def velocity(self) -> Array:
        """global velocity [m/s]"""
    @property
    def acceleration(self) -> Array:
        """global acceleration [m/s^2]"""
    @property
    def coordinates_total(self) -> Array:
        """x and y position (m), then the slope vector (1) [various]"""
    @property
    def coordinates(self) -> Array:
        """displacement (m) and change of the slope vector (1), relative to the reference coordinates [various]"""
    @property
    def coordinates_t(self) -> Array:
        """velocity (m/s) and rate of the slope vector (1/s) [various]"""
    @property
    def coordinates_tt(self) -> Array:
        """acceleration (m/s^2) and second rate of the slope vector (1/s^2) [various]"""

class NodePointGround(NodeHandle):
    """Handle: fixed point without coordinates, as the other end of springs and constraints on coordinates or points"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def reference_coordinates(self) -> Array:
        """global position of the node [3; m]"""
    @reference_coordinates.setter
    def reference_coordinates(self, value: ArrayLike) -> None: ...
    @property
    def referenceCoordinates(self) -> Array:
        """global position of the node [3; m]"""
    @referenceCoordinates.setter
    def referenceCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def position(self) -> Array:
        """global position; always the reference position [m]"""
    @property
    def displacement(self) -> Array:
        """zero [m]"""
    @property
    def velocity(self) -> Array:
        """zero [m/s]"""
    @property
    def coordinates_total(self) -> Array:
        """empty, as the node has no coordinates [various]"""
    @property
    def coordinates(self) -> Array:
        """empty, as the node has no coordinates [various]"""
    @property
    def coordinates_t(self) -> Array:
        """empty, as the node has no coordinates [various]"""
    @property
    def rotation_matrix(self) -> Array:
        """identity matrix, row by row, as the node has no orientation [1]"""
    @property
    def rotation(self) -> Array:
        """zero, as the node has no orientation; there for completeness [rad]"""
    @property
    def angular_velocity(self) -> Array:
        """zero, as the node has no orientation; there for completeness [rad/s]"""
    @property
    def angular_velocity_local(self) -> Array:
        """zero, as the node has no orientation; there for completeness [rad/s]"""
    @property
    def homogeneous_transformation(self) -> HT:
        """position and rotation as a 4 x 4 matrix, row by row; output functions return ``exu.HT`` [various]"""

class NodePointSlope1(NodeHandle):
    """Handle: node of spatial cable elements: position and axial slope vector"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def reference_coordinates(self) -> Array:
        """global position (m), then the slope vector (1); a unit vector along the axis for an element that is not stretched in the reference configuration [6; various]"""
    @reference_coordinates.setter
    def reference_coordinates(self, value: ArrayLike) -> None: ...
    @property
    def referenceCoordinates(self) -> Array:
        """global position (m), then the slope vector (1); a unit vector along the axis for an element that is not stretched in the reference configuration [6; various]"""
    @referenceCoordinates.setter
    def referenceCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initial_coordinates(self) -> Array:
        """displacement (m) and change of the slope vector (1) at the start, relative to the reference coordinates [6; various]"""
    @initial_coordinates.setter
    def initial_coordinates(self, value: ArrayLike) -> None: ...
    @property
    def initialCoordinates(self) -> Array:
        """displacement (m) and change of the slope vector (1) at the start, relative to the reference coordinates [6; various]"""
    @initialCoordinates.setter
    def initialCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initial_velocities(self) -> Array:
        """velocity (m/s) and rate of the slope vector (1/s) at the start [6; various]"""
    @initial_velocities.setter
    def initial_velocities(self, value: ArrayLike) -> None: ...
    @property
    def initialVelocities(self) -> Array:
        """velocity (m/s) and rate of the slope vector (1/s) at the start [6; various]"""
    @initialVelocities.setter
    def initialVelocities(self, value: ArrayLike) -> None: ...
    @property
    def position(self) -> Array:
        """global position vector [m]"""
    @property
    def displacement(self) -> Array:
        """global position minus the global position in the reference configuration [m]"""
    @property
    def velocity(self) -> Array:
        """global velocity [m/s]"""
    @property
    def acceleration(self) -> Array:
        """global acceleration [m/s^2]"""
    @property
    def coordinates_total(self) -> Array:
        """position (m), then the slope vector (1) [various]"""
    @property
    def coordinates(self) -> Array:
        """displacement (m) and change of the slope vector (1), relative to the reference coordinates [various]"""
    @property
    def coordinates_t(self) -> Array:
        """velocity (m/s) and rate of the slope vector (1/s) [various]"""
    @property
    def coordinates_tt(self) -> Array:
        """acceleration (m/s^2) and second rate of the slope vector (1/s^2) [various]"""

class NodePointSlope12(NodeHandle):
    """Handle: node of thin plate elements: position and the two slope vectors in the plane of the plate"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def reference_coordinates(self) -> Array:
        """global position (m), then the slope vectors in x and y (1); the two default slopes are parallel and so span no frame: give independent ones [9; various]"""
    @reference_coordinates.setter
    def reference_coordinates(self, value: ArrayLike) -> None: ...
    @property
    def referenceCoordinates(self) -> Array:
        """global position (m), then the slope vectors in x and y (1); the two default slopes are parallel and so span no frame: give independent ones [9; various]"""
    @referenceCoordinates.setter
    def referenceCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initial_coordinates(self) -> Array:
        """displacement (m) and change of the slope vectors (1) at the start, relative to the reference coordinates [9; various]"""
    @initial_coordinates.setter
    def initial_coordinates(self, value: ArrayLike) -> None: ...
    @property
    def initialCoordinates(self) -> Array:
        """displacement (m) and change of the slope vectors (1) at the start, relative to the reference coordinates [9; various]"""
    @initialCoordinates.setter
    def initialCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initial_velocities(self) -> Array:
        """velocity (m/s) and rates of the slope vectors (1/s) at the start [9; various]"""
    @initial_velocities.setter
    def initial_velocities(self, value: ArrayLike) -> None: ...
    @property
    def initialVelocities(self) -> Array:
        """velocity (m/s) and rates of the slope vectors (1/s) at the start [9; various]"""
    @initialVelocities.setter
    def initialVelocities(self, value: ArrayLike) -> None: ...
    @property
    def position(self) -> Array:
        """global position vector [m]"""
    @property
    def displacement(self) -> Array:
        """global position minus the global position in the reference configuration [m]"""
    @property
    def velocity(self) -> Array:
        """global velocity [m/s]"""
    @property
    def acceleration(self) -> Array:
        """global acceleration [m/s^2]"""
    @property
    def coordinates_total(self) -> Array:
        """position (m), then the two slope vectors (1) [various]"""
    @property
    def coordinates(self) -> Array:
        """displacement (m) and change of the slope vectors (1), relative to the reference coordinates [various]"""
    @property
    def coordinates_t(self) -> Array:
        """velocity (m/s) and rates of the slope vectors (1/s) [various]"""
    @property
    def coordinates_tt(self) -> Array:
        """acceleration (m/s^2) and second rates of the slope vectors (1/s^2) [various]"""
    @property
    def rotation_matrix(self) -> Array:
        """rotation matrix from the body frame to the global frame, row by row [1]"""
    @property
    def rotation(self) -> Array:
        """Tait-Bryan angles of the rotation matrix, for rotations about x, y and z in turn [rad]"""
    @property
    def angular_velocity(self) -> Array:
        """angular velocity in global coordinates [rad/s]"""
    @property
    def angular_velocity_local(self) -> Array:
        """angular velocity in body coordinates [rad/s]"""
    @property
    def homogeneous_transformation(self) -> HT:
        """position and rotation as a 4 x 4 matrix, row by row; output functions return ``exu.HT`` [various]"""

class NodePointSlope23(NodeHandle):
    """Handle: node of shear and cross-section deformable beam elements: position and the two slope vectors in the cross section"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def reference_coordinates(self) -> Array:
        """global position (m), then the slope vectors in y and z (1); the two default slopes are parallel and so span no frame: give independent ones [9; various]"""
    @reference_coordinates.setter
    def reference_coordinates(self, value: ArrayLike) -> None: ...
    @property
    def referenceCoordinates(self) -> Array:
        """global position (m), then the slope vectors in y and z (1); the two default slopes are parallel and so span no frame: give independent ones [9; various]"""
    @referenceCoordinates.setter
    def referenceCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initial_coordinates(self) -> Array:
        """displacement (m) and change of the slope vectors (1) at the start, relative to the reference coordinates [9; various]"""
    @initial_coordinates.setter
    def initial_coordinates(self, value: ArrayLike) -> None: ...
    @property
    def initialCoordinates(self) -> Array:
        """displacement (m) and change of the slope vectors (1) at the start, relative to the reference coordinates [9; various]"""
    @initialCoordinates.setter
    def initialCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initial_velocities(self) -> Array:
        """velocity (m/s) and rates of the slope vectors (1/s) at the start [9; various]"""
    @initial_velocities.setter
    def initial_velocities(self, value: ArrayLike) -> None: ...
    @property
    def initialVelocities(self) -> Array:
        """velocity (m/s) and rates of the slope vectors (1/s) at the start [9; various]"""
    @initialVelocities.setter
    def initialVelocities(self, value: ArrayLike) -> None: ...
    @property
    def position(self) -> Array:
        """global position vector [m]"""
    @property
    def displacement(self) -> Array:
        """global position minus the global position in the reference configuration [m]"""
    @property
    def velocity(self) -> Array:
        """global velocity [m/s]"""
    @property
    def acceleration(self) -> Array:
        """global acceleration [m/s^2]"""
    @property
    def coordinates_total(self) -> Array:
        """position (m), then the two slope vectors (1) [various]"""
    @property
    def coordinates(self) -> Array:
        """displacement (m) and change of the slope vectors (1), relative to the reference coordinates [various]"""
    @property
    def coordinates_t(self) -> Array:
        """velocity (m/s) and rates of the slope vectors (1/s) [various]"""
    @property
    def coordinates_tt(self) -> Array:
        """acceleration (m/s^2) and second rates of the slope vectors (1/s^2) [various]"""
    @property
    def rotation_matrix(self) -> Array:
        """rotation matrix from the body frame to the global frame, row by row [1]"""
    @property
    def rotation(self) -> Array:
        """Tait-Bryan angles of the rotation matrix, for rotations about x, y and z in turn [rad]"""
    @property
    def angular_velocity(self) -> Array:
        """angular velocity in global coordinates [rad/s]"""
    @property
    def angular_velocity_local(self) -> Array:
        """angular velocity in body coordinates [rad/s]"""
    @property
    def homogeneous_transformation(self) -> HT:
        """position and rotation as a 4 x 4 matrix, row by row; output functions return ``exu.HT`` [various]"""

class NodeRigidBody2D(NodeHandle):
    """Handle: node of a rigid body that moves in the global x-y plane: two displacements and the angle about z"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def reference_coordinates(self) -> Array:
        """x and y position of the reference point (m) and the angle about z (rad) without displacement and rotation [3; various]"""
    @reference_coordinates.setter
    def reference_coordinates(self, value: ArrayLike) -> None: ...
    @property
    def referenceCoordinates(self) -> Array:
        """x and y position of the reference point (m) and the angle about z (rad) without displacement and rotation [3; various]"""
    @referenceCoordinates.setter
    def referenceCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initial_coordinates(self) -> Array:
        """displacement in x and y (m) and rotation about z (rad) at the start, relative to the reference coordinates [3; various]"""
    @initial_coordinates.setter
    def initial_coordinates(self, value: ArrayLike) -> None: ...
    @property
    def initialCoordinates(self) -> Array:
        """displacement in x and y (m) and rotation about z (rad) at the start, relative to the reference coordinates [3; various]"""
    @initialCoordinates.setter
    def initialCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initial_velocities(self) -> Array:
        """velocity in x and y (m/s) and angular velocity about z (rad/s) at the start [3; various]"""
    @initial_velocities.setter
    def initial_velocities(self, value: ArrayLike) -> None: ...
    @property
    def initialVelocities(self) -> Array:
        """velocity in x and y (m/s) and angular velocity about z (rad/s) at the start [3; various]"""
    @initialVelocities.setter
    def initialVelocities(self, value: ArrayLike) -> None: ...
    @property
    def position(self) -> Array:
        """global position; the third component is zero [m]"""
    @property
    def displacement(self) -> Array:
        """global position minus the global position in the reference configuration [m]"""
    @property
    def velocity(self) -> Array:
        """global velocity [m/s]"""
    @property
    def acceleration(self) -> Array:
        """global acceleration [m/s^2]"""
    @property
    def angular_velocity(self) -> Array:
        """angular velocity in global coordinates [rad/s]"""
    @property
    def coordinates_total(self) -> Array:
        """x and y position (m) and angle about z (rad) [various]"""
    @property
    def coordinates(self) -> Array:
        """displacement (m) and rotation about z (rad), relative to the reference coordinates [various]"""
    @property
    def coordinates_t(self) -> Array:
        """velocity (m/s) and angular velocity (rad/s) [various]"""
    @property
    def coordinates_tt(self) -> Array:
        """acceleration (m/s^2) and angular acceleration (rad/s^2) [various]"""
    @property
    def rotation_matrix(self) -> Array:
        """rotation matrix from the body frame to the global frame, row by row [1]"""
    @property
    def rotation(self) -> Array:
        """only the third component is not zero: the angle about z, including its reference value [rad]"""
    @property
    def angular_velocity_local(self) -> Array:
        """angular velocity in body coordinates [rad/s]"""
    @property
    def angular_acceleration(self) -> Array:
        """angular acceleration in global coordinates [rad/s^2]"""
    @property
    def homogeneous_transformation(self) -> HT:
        """position and rotation as a 4 x 4 matrix, row by row; output functions return ``exu.HT`` [various]"""

class NodeRigidBodyEP(NodeHandle):
    """Handle: node of a rigid body in space: three displacements and four Euler parameters (unit quaternion)"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def reference_coordinates(self) -> Array:
        """position of the reference point (m) and four Euler parameters (1), the scalar one first; their norm must be 1, so that the default of zeros is refused; [1, 0, 0, 0] is no rotation [7; various]"""
    @reference_coordinates.setter
    def reference_coordinates(self, value: ArrayLike) -> None: ...
    @property
    def referenceCoordinates(self) -> Array:
        """position of the reference point (m) and four Euler parameters (1), the scalar one first; their norm must be 1, so that the default of zeros is refused; [1, 0, 0, 0] is no rotation [7; various]"""
    @referenceCoordinates.setter
    def referenceCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initial_coordinates(self) -> Array:
        """displacement (m) and change of the Euler parameters (1) at the start; the sum of reference and initial Euler parameters must have norm 1 [7; various]"""
    @initial_coordinates.setter
    def initial_coordinates(self, value: ArrayLike) -> None: ...
    @property
    def initialCoordinates(self) -> Array:
        """displacement (m) and change of the Euler parameters (1) at the start; the sum of reference and initial Euler parameters must have norm 1 [7; various]"""
    @initialCoordinates.setter
    def initialCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initial_velocities(self) -> Array:
        """velocity (m/s) and time derivatives of the Euler parameters (1/s) at the start; for a given angular velocity they are :math:`\\tfrac{1}{4}\\, {}^{b}\\mathbf{G}^{\\mathsf{T}}\\, {}^{b}\\boldsymbol{\\omega}` [7; various]"""
    @initial_velocities.setter
    def initial_velocities(self, value: ArrayLike) -> None: ...
    @property
    def initialVelocities(self) -> Array:
        """velocity (m/s) and time derivatives of the Euler parameters (1/s) at the start; for a given angular velocity they are :math:`\\tfrac{1}{4}\\, {}^{b}\\mathbf{G}^{\\mathsf{T}}\\, {}^{b}\\boldsymbol{\\omega}` [7; various]"""
    @initialVelocities.setter
    def initialVelocities(self, value: ArrayLike) -> None: ...
    @property
    def add_constraint_equation(self) -> bool:
        """true: the node adds the equation that keeps the norm of the Euler parameters, with one algebraic variable; false: the norm has to be kept by a constraint of the model"""
    @add_constraint_equation.setter
    def add_constraint_equation(self, value: bool) -> None: ...
    @property
    def addConstraintEquation(self) -> bool:
        """true: the node adds the equation that keeps the norm of the Euler parameters, with one algebraic variable; false: the norm has to be kept by a constraint of the model"""
    @addConstraintEquation.setter
    def addConstraintEquation(self, value: bool) -> None: ...
    @property
    def position(self) -> Array:
        """global position vector [m]"""
    @property
    def displacement(self) -> Array:
        """global position minus the global position in the reference configuration [m]"""
    @property
    def velocity(self) -> Array:
        """global velocity [m/s]"""
    @property
    def acceleration(self) -> Array:
        """global acceleration [m/s^2]"""
    @property
    def coordinates_total(self) -> Array:
        """position (m) and Euler parameters (1) [various]"""
    @property
    def coordinates(self) -> Array:
        """displacement (m) and Euler parameters (1), relative to the reference coordinates [various]"""
    @property
    def coordinates_t(self) -> Array:
        """velocity (m/s) and time derivatives of the Euler parameters (1/s) [various]"""
    @property
    def coordinates_tt(self) -> Array:
        """acceleration (m/s^2) and second time derivatives of the Euler parameters (1/s^2) [various]"""
    @property
    def rotation_matrix(self) -> Array:
        """rotation matrix from the body frame to the global frame, row by row [1]"""
    @property
    def rotation(self) -> Array:
        """Tait-Bryan angles of the rotation matrix, for rotations about x, y and z in turn [rad]"""
    @property
    def angular_velocity(self) -> Array:
        """angular velocity in global coordinates [rad/s]"""
    @property
    def angular_velocity_local(self) -> Array:
        """angular velocity in body coordinates [rad/s]"""
    @property
    def angular_acceleration(self) -> Array:
        """angular acceleration in global coordinates [rad/s^2]"""
    @property
    def homogeneous_transformation(self) -> HT:
        """position and rotation as a 4 x 4 matrix, row by row; output functions return ``exu.HT`` [various]"""

class NodeRigidBodyRotVecLG(NodeHandle):
    """Handle: node of a rigid body in space: three displacements and a rotation vector that is integrated by Lie group methods"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def reference_coordinates(self) -> Array:
        """position of the reference point (m) and rotation vector (rad) without displacement and rotation [6; various]"""
    @reference_coordinates.setter
    def reference_coordinates(self, value: ArrayLike) -> None: ...
    @property
    def referenceCoordinates(self) -> Array:
        """position of the reference point (m) and rotation vector (rad) without displacement and rotation [6; various]"""
    @referenceCoordinates.setter
    def referenceCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initial_coordinates(self) -> Array:
        """displacement (m) and change of the rotation vector (rad) at the start; reference and initial rotation vector are added as vectors [6; various]"""
    @initial_coordinates.setter
    def initial_coordinates(self, value: ArrayLike) -> None: ...
    @property
    def initialCoordinates(self) -> Array:
        """displacement (m) and change of the rotation vector (rad) at the start; reference and initial rotation vector are added as vectors [6; various]"""
    @initialCoordinates.setter
    def initialCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initial_velocities(self) -> Array:
        """velocity (m/s) and angular velocity in body coordinates (rad/s) at the start [6; various]"""
    @initial_velocities.setter
    def initial_velocities(self, value: ArrayLike) -> None: ...
    @property
    def initialVelocities(self) -> Array:
        """velocity (m/s) and angular velocity in body coordinates (rad/s) at the start [6; various]"""
    @initialVelocities.setter
    def initialVelocities(self, value: ArrayLike) -> None: ...
    @property
    def position(self) -> Array:
        """global position vector [m]"""
    @property
    def displacement(self) -> Array:
        """global position minus the global position in the reference configuration [m]"""
    @property
    def velocity(self) -> Array:
        """global velocity [m/s]"""
    @property
    def acceleration(self) -> Array:
        """global acceleration [m/s^2]"""
    @property
    def coordinates_total(self) -> Array:
        """position (m) and rotation vector (rad) [various]"""
    @property
    def coordinates(self) -> Array:
        """displacement (m) and rotation vector (rad), relative to the reference coordinates [various]"""
    @property
    def coordinates_t(self) -> Array:
        """velocity (m/s) and angular velocity in body coordinates (rad/s) [various]"""
    @property
    def rotation_matrix(self) -> Array:
        """rotation matrix from the body frame to the global frame, row by row [1]"""
    @property
    def rotation(self) -> Array:
        """Tait-Bryan angles of the rotation matrix, for rotations about x, y and z in turn [rad]"""
    @property
    def angular_velocity(self) -> Array:
        """angular velocity in global coordinates [rad/s]"""
    @property
    def angular_velocity_local(self) -> Array:
        """angular velocity in body coordinates [rad/s]"""
    @property
    def homogeneous_transformation(self) -> HT:
        """position and rotation as a 4 x 4 matrix, row by row; output functions return ``exu.HT`` [various]"""

class NodeRigidBodyRxyz(NodeHandle):
    """Handle: node of a rigid body in space: three displacements and three Tait-Bryan angles about x, y and z in turn"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def reference_coordinates(self) -> Array:
        """position of the reference point (m) and the angles (rad) without displacement and rotation [6; various]"""
    @reference_coordinates.setter
    def reference_coordinates(self, value: ArrayLike) -> None: ...
    @property
    def referenceCoordinates(self) -> Array:
        """position of the reference point (m) and the angles (rad) without displacement and rotation [6; various]"""
    @referenceCoordinates.setter
    def referenceCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initial_coordinates(self) -> Array:
        """displacement (m) and change of the angles (rad) at the start, relative to the reference coordinates [6; various]"""
    @initial_coordinates.setter
    def initial_coordinates(self, value: ArrayLike) -> None: ...
    @property
    def initialCoordinates(self) -> Array:
        """displacement (m) and change of the angles (rad) at the start, relative to the reference coordinates [6; various]"""
    @initialCoordinates.setter
    def initialCoordinates(self, value: ArrayLike) -> None: ...
    @property
    def initial_velocities(self) -> Array:
        """velocity (m/s) and time derivatives of the angles (rad/s) at the start; the latter are not the components of the angular velocity, except at zero angles [6; various]"""
    @initial_velocities.setter
    def initial_velocities(self, value: ArrayLike) -> None: ...
    @property
    def initialVelocities(self) -> Array:
        """velocity (m/s) and time derivatives of the angles (rad/s) at the start; the latter are not the components of the angular velocity, except at zero angles [6; various]"""
    @initialVelocities.setter
    def initialVelocities(self, value: ArrayLike) -> None: ...
    @property
    def position(self) -> Array:
        """global position vector [m]"""
    @property
    def displacement(self) -> Array:
        """global position minus the global position in the reference configuration [m]"""
    @property
    def velocity(self) -> Array:
        """global velocity [m/s]"""
    @property
    def acceleration(self) -> Array:
        """global acceleration [m/s^2]"""
    @property
    def coordinates_total(self) -> Array:
        """position (m) and angles (rad) [various]"""
    @property
    def coordinates(self) -> Array:
        """displacement (m) and angles (rad), relative to the reference coordinates [various]"""
    @property
    def coordinates_t(self) -> Array:
        """velocity (m/s) and time derivatives of the angles (rad/s) [various]"""
    @property
    def coordinates_tt(self) -> Array:
        """acceleration (m/s^2) and second time derivatives of the angles (rad/s^2) [various]"""
    @property
    def rotation_matrix(self) -> Array:
        """rotation matrix from the body frame to the global frame, row by row [1]"""
    @property
    def rotation(self) -> Array:
        """total Tait-Bryan angles of the node, as given by its coordinates; not reduced to one turn [rad]"""
    @property
    def angular_velocity(self) -> Array:
        """angular velocity in global coordinates [rad/s]"""
    @property
    def angular_velocity_local(self) -> Array:
        """angular velocity in body coordinates [rad/s]"""
    @property
    def angular_acceleration(self) -> Array:
        """angular acceleration in global coordinates [rad/s^2]"""
    @property
    def homogeneous_transformation(self) -> HT:
        """position and rotation as a 4 x 4 matrix, row by row; output functions return ``exu.HT`` [various]"""

class ObjectGenericODE1(ObjectHandle):
    """Handle: system of first order differential equations with a constant matrix, a constant vector and a user function"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def node_numbers(self) -> tuple[NodeHandle, ...]:
        """nodes with first order coordinates; their coordinates in this order form the vector of the object [n]"""
    @node_numbers.setter
    def node_numbers(self, value: Sequence[NodeIndex | int | str]) -> None: ...
    @property
    def nodeNumbers(self) -> tuple[NodeHandle, ...]:
        """nodes with first order coordinates; their coordinates in this order form the vector of the object [n]"""
    @nodeNumbers.setter
    def nodeNumbers(self, value: Sequence[NodeIndex | int | str]) -> None: ...
    @property
    def system_matrix(self) -> Array:
        """constant system matrix; n rows and n columns for n coordinates, or empty for zero; other sizes are refused [n x m; various]"""
    @system_matrix.setter
    def system_matrix(self, value: ArrayLike) -> None: ...
    @property
    def systemMatrix(self) -> Array:
        """constant system matrix; n rows and n columns for n coordinates, or empty for zero; other sizes are refused [n x m; various]"""
    @systemMatrix.setter
    def systemMatrix(self, value: ArrayLike) -> None: ...
    @property
    def rhs_vector(self) -> Array:
        """constant right hand side; length n, or empty for zero [n; various]"""
    @rhs_vector.setter
    def rhs_vector(self, value: ArrayLike) -> None: ...
    @property
    def rhsVector(self) -> Array:
        """constant right hand side; length n, or empty for zero [n; various]"""
    @rhsVector.setter
    def rhsVector(self, value: ArrayLike) -> None: ...
    @property
    def rhs_user_function(self) -> Callable[[MainSystem, float, int, Array], ArrayLike] | Literal[0]:
        """function that gives a further right hand side, of time and coordinates"""
    @rhs_user_function.setter
    def rhs_user_function(self, value: Callable[[MainSystem, float, int, Array], ArrayLike] | Literal[0]) -> None: ...
    @property
    def rhsUserFunction(self) -> Callable[[MainSystem, float, int, Array], ArrayLike] | Literal[0]:
        """function that gives a further right hand side, of time and coordinates"""
    @rhsUserFunction.setter
    def rhsUserFunction(self, value: Callable[[MainSystem, float, int, Array], ArrayLike] | Literal[0]) -> None: ...
    @property
    def coordinates_total(self) -> Array:
        """coordinates of all nodes of the object, including the reference values [various]"""
    @property
    def coordinates(self) -> Array:
        """coordinates of all nodes of the object, relative to the reference values [various]"""
    @property
    def coordinates_t(self) -> Array:
        """time derivatives of the coordinates of all nodes of the object [various]"""

class ObjectGround(ObjectHandle):
    """Handle: body that does not move: the fixed end of joints, connectors and markers"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def reference_position(self) -> Array:
        """global position of the origin of the ground frame; local positions of markers count from here [3; m]"""
    @reference_position.setter
    def reference_position(self, value: ArrayLike) -> None: ...
    @property
    def referencePosition(self) -> Array:
        """global position of the origin of the ground frame; local positions of markers count from here [3; m]"""
    @referencePosition.setter
    def referencePosition(self, value: ArrayLike) -> None: ...
    @property
    def reference_rotation(self) -> Array:
        """rotation matrix from the ground frame to the global frame [3 x 3; 1]"""
    @reference_rotation.setter
    def reference_rotation(self, value: ArrayLike) -> None: ...
    @property
    def referenceRotation(self) -> Array:
        """rotation matrix from the ground frame to the global frame [3 x 3; 1]"""
    @referenceRotation.setter
    def referenceRotation(self, value: ArrayLike) -> None: ...
    @property
    def position(self) -> Array:
        """global position of the local point [m]"""
    def position_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def displacement(self) -> Array:
        """zero [m]"""
    def displacement_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def velocity(self) -> Array:
        """zero [m/s]"""
    def velocity_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def angular_velocity(self) -> Array:
        """zero [rad/s]"""
    def angular_velocity_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def rotation_matrix(self) -> Array:
        """rotation matrix from the body frame to the global frame, row by row [1]"""
    def rotation_matrix_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def homogeneous_transformation(self) -> HT:
        """position and rotation as a 4 x 4 matrix, row by row; output functions return ``exu.HT`` [various]"""
    def homogeneous_transformation_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> HT: ...

class ObjectMass1D(ObjectHandle):
    """Handle: mass that is guided along a line: one translation along the local x-axis"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def physics_mass(self) -> float:
        """mass; zero is allowed if something else makes the equation of the node regular [kg]"""
    @physics_mass.setter
    def physics_mass(self, value: float) -> None: ...
    @property
    def physicsMass(self) -> float:
        """mass; zero is allowed if something else makes the equation of the node regular [kg]"""
    @physicsMass.setter
    def physicsMass(self, value: float) -> None: ...
    @property
    def mass(self) -> float:
        """mass; zero is allowed if something else makes the equation of the node regular [kg]"""
    @mass.setter
    def mass(self, value: float) -> None: ...
    @property
    def node_number(self) -> NodeHandle:
        """node with one coordinate of second order, which is the way (m) along the local x-axis"""
    @node_number.setter
    def node_number(self, value: NodeIndex | int | str) -> None: ...
    @property
    def nodeNumber(self) -> NodeHandle:
        """node with one coordinate of second order, which is the way (m) along the local x-axis"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    @property
    def reference_position(self) -> Array:
        """global position of the body at coordinate zero [3; m]"""
    @reference_position.setter
    def reference_position(self, value: ArrayLike) -> None: ...
    @property
    def referencePosition(self) -> Array:
        """global position of the body at coordinate zero [3; m]"""
    @referencePosition.setter
    def referencePosition(self, value: ArrayLike) -> None: ...
    @property
    def reference_rotation(self) -> Array:
        """constant rotation matrix from the body frame to the global frame; its first column is the direction of motion; a reflection gives a warning [3 x 3; 1]"""
    @reference_rotation.setter
    def reference_rotation(self, value: ArrayLike) -> None: ...
    @property
    def referenceRotation(self) -> Array:
        """constant rotation matrix from the body frame to the global frame; its first column is the direction of motion; a reflection gives a warning [3 x 3; 1]"""
    @referenceRotation.setter
    def referenceRotation(self, value: ArrayLike) -> None: ...
    @property
    def position(self) -> Array:
        """global position vector [m]"""
    def position_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def displacement(self) -> Array:
        """global position minus the global position in the reference configuration [m]"""
    def displacement_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def velocity(self) -> Array:
        """global velocity [m/s]"""
    def velocity_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def rotation_matrix(self) -> Array:
        """the parameter ``referenceRotation``, row by row [1]"""
    def rotation_matrix_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def rotation(self) -> Array:
        """Tait-Bryan angles of the rotation matrix, for rotations about x, y and z in turn [rad]"""
    def rotation_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def angular_velocity(self) -> Array:
        """zero [rad/s]"""
    def angular_velocity_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def angular_velocity_local(self) -> Array:
        """zero [rad/s]"""
    def angular_velocity_local_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def homogeneous_transformation(self) -> HT:
        """position and rotation as a 4 x 4 matrix, row by row; output functions return ``exu.HT`` [various]"""
    def homogeneous_transformation_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> HT: ...
    @property
    def kinetic_energy(self) -> float:
        """kinetic energy of the whole body; the local position has no influence [J]"""
    @property
    def potential_energy(self) -> float:
        """zero: a point has no strains, and weight is a load [J]"""

class ObjectMassPoint(ObjectHandle):
    """Handle: point mass in space on a node with position"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def physics_mass(self) -> float:
        """mass; zero is allowed if something else makes the equations of the node regular [kg]"""
    @physics_mass.setter
    def physics_mass(self, value: float) -> None: ...
    @property
    def physicsMass(self) -> float:
        """mass; zero is allowed if something else makes the equations of the node regular [kg]"""
    @physicsMass.setter
    def physicsMass(self, value: float) -> None: ...
    @property
    def mass(self) -> float:
        """mass; zero is allowed if something else makes the equations of the node regular [kg]"""
    @mass.setter
    def mass(self, value: float) -> None: ...
    @property
    def node_number(self) -> NodeHandle:
        """node with a position in space and three displacement coordinates"""
    @node_number.setter
    def node_number(self, value: NodeIndex | int | str) -> None: ...
    @property
    def nodeNumber(self) -> NodeHandle:
        """node with a position in space and three displacement coordinates"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    @property
    def position(self) -> Array:
        """global position of the local point [m]"""
    def position_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def displacement(self) -> Array:
        """global displacement, the same for all local points [m]"""
    def displacement_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def velocity(self) -> Array:
        """global velocity [m/s]"""
    def velocity_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def acceleration(self) -> Array:
        """global acceleration [m/s^2]"""
    def acceleration_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def rotation_matrix(self) -> Array:
        """identity matrix, row by row, as the body does not rotate [1]"""
    def rotation_matrix_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def rotation(self) -> Array:
        """zero, as the body does not rotate; there for completeness [rad]"""
    def rotation_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def angular_velocity(self) -> Array:
        """zero, as the body does not rotate; there for completeness [rad/s]"""
    def angular_velocity_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def angular_velocity_local(self) -> Array:
        """zero, as the body does not rotate; there for completeness [rad/s]"""
    def angular_velocity_local_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def homogeneous_transformation(self) -> HT:
        """position and rotation as a 4 x 4 matrix, row by row; output functions return ``exu.HT`` [various]"""
    def homogeneous_transformation_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> HT: ...
    @property
    def kinetic_energy(self) -> float:
        """kinetic energy of the whole body; the local position has no influence [J]"""
    @property
    def potential_energy(self) -> float:
        """zero: a point has no strains, and weight is a load [J]"""

class ObjectMassPoint2D(ObjectHandle):
    """Handle: point mass in the global x-y plane on a planar node"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def physics_mass(self) -> float:
        """mass; zero is allowed if something else makes the equations of the node regular [kg]"""
    @physics_mass.setter
    def physics_mass(self, value: float) -> None: ...
    @property
    def physicsMass(self) -> float:
        """mass; zero is allowed if something else makes the equations of the node regular [kg]"""
    @physicsMass.setter
    def physicsMass(self, value: float) -> None: ...
    @property
    def mass(self) -> float:
        """mass; zero is allowed if something else makes the equations of the node regular [kg]"""
    @mass.setter
    def mass(self, value: float) -> None: ...
    @property
    def node_number(self) -> NodeHandle:
        """node with a position in the plane and two displacement coordinates"""
    @node_number.setter
    def node_number(self, value: NodeIndex | int | str) -> None: ...
    @property
    def nodeNumber(self) -> NodeHandle:
        """node with a position in the plane and two displacement coordinates"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    @property
    def position(self) -> Array:
        """global position of the local point [m]"""
    def position_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def displacement(self) -> Array:
        """global displacement, the same for all local points; the third component is zero [m]"""
    def displacement_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def velocity(self) -> Array:
        """global velocity; the third component is zero [m/s]"""
    def velocity_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def acceleration(self) -> Array:
        """global acceleration; the third component is zero [m/s^2]"""
    def acceleration_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def rotation_matrix(self) -> Array:
        """identity matrix, row by row, as the body does not rotate [1]"""
    def rotation_matrix_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def rotation(self) -> Array:
        """zero, as the body does not rotate; there for completeness [rad]"""
    def rotation_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def angular_velocity(self) -> Array:
        """zero, as the body does not rotate; there for completeness [rad/s]"""
    def angular_velocity_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def angular_velocity_local(self) -> Array:
        """zero, as the body does not rotate; there for completeness [rad/s]"""
    def angular_velocity_local_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def homogeneous_transformation(self) -> HT:
        """position and rotation as a 4 x 4 matrix, row by row; output functions return ``exu.HT`` [various]"""
    def homogeneous_transformation_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> HT: ...
    @property
    def kinetic_energy(self) -> float:
        """kinetic energy of the whole body; the local position has no influence [J]"""
    @property
    def potential_energy(self) -> float:
        """zero: a point has no strains, and weight is a load [J]"""

class ObjectRigidBody(ObjectHandle):
    """Handle: rigid body in space with any center of mass, on a node with position and orientation"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def physics_mass(self) -> float:
        """mass [kg]"""
    @physics_mass.setter
    def physics_mass(self, value: float) -> None: ...
    @property
    def physicsMass(self) -> float:
        """mass [kg]"""
    @physicsMass.setter
    def physicsMass(self, value: float) -> None: ...
    @property
    def mass(self) -> float:
        """mass [kg]"""
    @mass.setter
    def mass(self, value: float) -> None: ...
    @property
    def physics_inertia(self) -> Array:
        """components :math:`[J_{xx}, J_{yy}, J_{zz}, J_{yz}, J_{xz}, J_{xy}]` of the inertia tensor in the body frame about the reference point, which is the node, and not about the center of mass; off-diagonal components are those of the tensor, :math:`J_{xy} = -\\int x y \\,\\mathrm{d}m` [6; kg m^2]"""
    @physics_inertia.setter
    def physics_inertia(self, value: ArrayLike) -> None: ...
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
    def physics_center_of_mass(self) -> Array:
        """position of the center of mass in the body frame, counted from the node [3; m]"""
    @physics_center_of_mass.setter
    def physics_center_of_mass(self, value: ArrayLike) -> None: ...
    @property
    def physicsCenterOfMass(self) -> Array:
        """position of the center of mass in the body frame, counted from the node [3; m]"""
    @physicsCenterOfMass.setter
    def physicsCenterOfMass(self, value: ArrayLike) -> None: ...
    @property
    def center_of_mass(self) -> Array:
        """position of the center of mass in the body frame, counted from the node [3; m]"""
    @center_of_mass.setter
    def center_of_mass(self, value: ArrayLike) -> None: ...
    @property
    def centerOfMass(self) -> Array:
        """position of the center of mass in the body frame, counted from the node [3; m]"""
    @centerOfMass.setter
    def centerOfMass(self, value: ArrayLike) -> None: ...
    @property
    def node_number(self) -> NodeHandle:
        """node of a rigid body in space"""
    @node_number.setter
    def node_number(self, value: NodeIndex | int | str) -> None: ...
    @property
    def nodeNumber(self) -> NodeHandle:
        """node of a rigid body in space"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    @property
    def position(self) -> Array:
        """global position of the local point [m]"""
    def position_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def displacement(self) -> Array:
        """global displacement of the local point from its place in the reference configuration [m]"""
    def displacement_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def velocity(self) -> Array:
        """global velocity of the local point [m/s]"""
    def velocity_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def velocity_local(self) -> Array:
        """velocity of the local point in body coordinates [m/s]"""
    def velocity_local_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def rotation_matrix(self) -> Array:
        """rotation matrix from the body frame to the global frame, row by row [1]"""
    def rotation_matrix_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def rotation(self) -> Array:
        """Tait-Bryan angles of the rotation matrix, for rotations about x, y and z in turn [rad]"""
    def rotation_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def angular_velocity(self) -> Array:
        """angular velocity in global coordinates [rad/s]"""
    def angular_velocity_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def angular_velocity_local(self) -> Array:
        """angular velocity in body coordinates [rad/s]"""
    def angular_velocity_local_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def acceleration(self) -> Array:
        """global acceleration of the local point [m/s^2]"""
    def acceleration_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def acceleration_local(self) -> Array:
        """acceleration of the local point in body coordinates [m/s^2]"""
    def acceleration_local_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def angular_acceleration(self) -> Array:
        """angular acceleration in global coordinates [rad/s^2]"""
    def angular_acceleration_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def angular_acceleration_local(self) -> Array:
        """angular acceleration in body coordinates [rad/s^2]"""
    def angular_acceleration_local_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def homogeneous_transformation(self) -> HT:
        """position and rotation as a 4 x 4 matrix, row by row; output functions return ``exu.HT`` [various]"""
    def homogeneous_transformation_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> HT: ...
    @property
    def kinetic_energy(self) -> float:
        """kinetic energy of the whole body; the local position has no influence [J]"""
    @property
    def potential_energy(self) -> float:
        """zero: a rigid body has no strains, and weight is a load [J]"""

class ObjectRigidBody2D(ObjectHandle):
    """Handle: rigid body that moves in the global x-y plane, with any center of mass"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def physics_mass(self) -> float:
        """mass [kg]"""
    @physics_mass.setter
    def physics_mass(self, value: float) -> None: ...
    @property
    def physicsMass(self) -> float:
        """mass [kg]"""
    @physicsMass.setter
    def physicsMass(self, value: float) -> None: ...
    @property
    def mass(self) -> float:
        """mass [kg]"""
    @mass.setter
    def mass(self, value: float) -> None: ...
    @property
    def physics_inertia(self) -> float:
        """moment of inertia about the z-axis through the reference point, which is the node, and not through the center of mass [kg m^2]"""
    @physics_inertia.setter
    def physics_inertia(self, value: float) -> None: ...
    @property
    def physicsInertia(self) -> float:
        """moment of inertia about the z-axis through the reference point, which is the node, and not through the center of mass [kg m^2]"""
    @physicsInertia.setter
    def physicsInertia(self, value: float) -> None: ...
    @property
    def inertia(self) -> float:
        """moment of inertia about the z-axis through the reference point, which is the node, and not through the center of mass [kg m^2]"""
    @inertia.setter
    def inertia(self, value: float) -> None: ...
    @property
    def physics_center_of_mass(self) -> Array:
        """x and y position of the center of mass in the body frame, counted from the node [2; m]"""
    @physics_center_of_mass.setter
    def physics_center_of_mass(self, value: ArrayLike) -> None: ...
    @property
    def physicsCenterOfMass(self) -> Array:
        """x and y position of the center of mass in the body frame, counted from the node [2; m]"""
    @physicsCenterOfMass.setter
    def physicsCenterOfMass(self, value: ArrayLike) -> None: ...
    @property
    def center_of_mass(self) -> Array:
        """x and y position of the center of mass in the body frame, counted from the node [2; m]"""
    @center_of_mass.setter
    def center_of_mass(self, value: ArrayLike) -> None: ...
    @property
    def centerOfMass(self) -> Array:
        """x and y position of the center of mass in the body frame, counted from the node [2; m]"""
    @centerOfMass.setter
    def centerOfMass(self, value: ArrayLike) -> None: ...
    @property
    def node_number(self) -> NodeHandle:
        """node of a rigid body in the plane"""
    @node_number.setter
    def node_number(self, value: NodeIndex | int | str) -> None: ...
    @property
    def nodeNumber(self) -> NodeHandle:
        """node of a rigid body in the plane"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    @property
    def position(self) -> Array:
        """global position of the local point [m]"""
    def position_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def displacement(self) -> Array:
        """global displacement of the local point from its place in the reference configuration [m]"""
    def displacement_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def velocity(self) -> Array:
        """global velocity of the local point [m/s]"""
    def velocity_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def velocity_local(self) -> Array:
        """velocity of the local point in body coordinates [m/s]"""
    def velocity_local_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def rotation_matrix(self) -> Array:
        """rotation matrix from the body frame to the global frame, row by row [1]"""
    def rotation_matrix_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def rotation(self) -> float:
        """angle about z, counted from the reference configuration, in which it is the reference angle; not reduced to one turn (the node's output includes the reference angle) [rad]"""
    def rotation_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> float: ...
    @property
    def angular_velocity(self) -> Array:
        """angular velocity in global coordinates [rad/s]"""
    def angular_velocity_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def angular_velocity_local(self) -> Array:
        """angular velocity in body coordinates [rad/s]"""
    def angular_velocity_local_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def acceleration(self) -> Array:
        """global acceleration of the local point [m/s^2]"""
    def acceleration_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def acceleration_local(self) -> Array:
        """acceleration of the local point in body coordinates [m/s^2]"""
    def acceleration_local_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def angular_acceleration(self) -> Array:
        """angular acceleration in global coordinates [rad/s^2]"""
    def angular_acceleration_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def angular_acceleration_local(self) -> Array:
        """angular acceleration in body coordinates [rad/s^2]"""
    def angular_acceleration_local_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def homogeneous_transformation(self) -> HT:
        """position and rotation as a 4 x 4 matrix, row by row; output functions return ``exu.HT`` [various]"""
    def homogeneous_transformation_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> HT: ...
    @property
    def kinetic_energy(self) -> float:
        """kinetic energy of the whole body; the local position has no influence [J]"""
    @property
    def potential_energy(self) -> float:
        """zero: a rigid body has no strains, and weight is a load [J]"""

class ObjectRotationalMass1D(ObjectHandle):
    """Handle: rotor about a fixed axis: one rotation about the local z-axis"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def physics_inertia(self) -> float:
        """moment of inertia about the axis of rotation [kg m^2]"""
    @physics_inertia.setter
    def physics_inertia(self, value: float) -> None: ...
    @property
    def physicsInertia(self) -> float:
        """moment of inertia about the axis of rotation [kg m^2]"""
    @physicsInertia.setter
    def physicsInertia(self, value: float) -> None: ...
    @property
    def inertia(self) -> float:
        """moment of inertia about the axis of rotation [kg m^2]"""
    @inertia.setter
    def inertia(self, value: float) -> None: ...
    @property
    def node_number(self) -> NodeHandle:
        """node with one coordinate of second order, which is the angle (rad) about the local z-axis"""
    @node_number.setter
    def node_number(self, value: NodeIndex | int | str) -> None: ...
    @property
    def nodeNumber(self) -> NodeHandle:
        """node with one coordinate of second order, which is the angle (rad) about the local z-axis"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    @property
    def reference_position(self) -> Array:
        """global position of the body frame, a fixed point of the axis [3; m]"""
    @reference_position.setter
    def reference_position(self, value: ArrayLike) -> None: ...
    @property
    def referencePosition(self) -> Array:
        """global position of the body frame, a fixed point of the axis [3; m]"""
    @referencePosition.setter
    def referencePosition(self, value: ArrayLike) -> None: ...
    @property
    def reference_rotation(self) -> Array:
        """constant rotation matrix from the frame at angle zero to the global frame; its third column is the axis of rotation [3 x 3; 1]"""
    @reference_rotation.setter
    def reference_rotation(self, value: ArrayLike) -> None: ...
    @property
    def referenceRotation(self) -> Array:
        """constant rotation matrix from the frame at angle zero to the global frame; its third column is the axis of rotation [3 x 3; 1]"""
    @referenceRotation.setter
    def referenceRotation(self, value: ArrayLike) -> None: ...
    @property
    def position(self) -> Array:
        """global position of the local point, which turns with the body [m]"""
    def position_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def displacement(self) -> Array:
        """global position minus the global position in the reference configuration [m]"""
    def displacement_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def velocity(self) -> Array:
        """global velocity [m/s]"""
    def velocity_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def rotation_matrix(self) -> Array:
        """rotation matrix from the body frame to the global frame, row by row [1]"""
    def rotation_matrix_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def rotation(self) -> float:
        """angle about the axis, including its reference value; not reduced to one turn [rad]"""
    def rotation_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> float: ...
    @property
    def angular_velocity(self) -> Array:
        """angular velocity in global coordinates [rad/s]"""
    def angular_velocity_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def angular_velocity_local(self) -> Array:
        """angular velocity in body coordinates; only the third component is not zero [rad/s]"""
    def angular_velocity_local_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def homogeneous_transformation(self) -> HT:
        """position and rotation as a 4 x 4 matrix, row by row; output functions return ``exu.HT`` [various]"""
    def homogeneous_transformation_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> HT: ...
    @property
    def kinetic_energy(self) -> float:
        """kinetic energy of the whole body; the local position has no influence [J]"""
    @property
    def potential_energy(self) -> float:
        """zero: a rigid body has no strains, and weight is a load [J]"""

class ObjectFFRF(ObjectHandle):
    """Handle: flexible body with the nodal coordinates of a finite element mesh in a floating frame of reference"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def node_numbers(self) -> tuple[NodeHandle, ...]:
        """first the rigid body node of the body frame, then the points of the mesh, each a NodePoint; reference positions and displacements of the latter are components in the body frame [n]"""
    @node_numbers.setter
    def node_numbers(self, value: Sequence[NodeIndex | int | str]) -> None: ...
    @property
    def nodeNumbers(self) -> tuple[NodeHandle, ...]:
        """first the rigid body node of the body frame, then the points of the mesh, each a NodePoint; reference positions and displacements of the latter are components in the body frame [n]"""
    @nodeNumbers.setter
    def nodeNumbers(self, value: Sequence[NodeIndex | int | str]) -> None: ...
    @property
    def mass_matrix_ff(self) -> MatrixContainer:
        """mass matrix of the free mesh, without the coordinates of the body frame; three rows and columns per mesh node, with the same masses in all directions [n x m; various]"""
    @mass_matrix_ff.setter
    def mass_matrix_ff(self, value: MatrixLike | None) -> None: ...
    @property
    def massMatrixFF(self) -> MatrixContainer:
        """mass matrix of the free mesh, without the coordinates of the body frame; three rows and columns per mesh node, with the same masses in all directions [n x m; various]"""
    @massMatrixFF.setter
    def massMatrixFF(self, value: MatrixLike | None) -> None: ...
    @property
    def stiffness_matrix_ff(self) -> MatrixContainer:
        """stiffness matrix of the free mesh in the body frame; three rows and columns per mesh node [n x m; various]"""
    @stiffness_matrix_ff.setter
    def stiffness_matrix_ff(self, value: MatrixLike | None) -> None: ...
    @property
    def stiffnessMatrixFF(self) -> MatrixContainer:
        """stiffness matrix of the free mesh in the body frame; three rows and columns per mesh node [n x m; various]"""
    @stiffnessMatrixFF.setter
    def stiffnessMatrixFF(self, value: MatrixLike | None) -> None: ...
    @property
    def damping_matrix_ff(self) -> MatrixContainer:
        """damping matrix of the free mesh in the body frame; three rows and columns per mesh node, or empty for zero [n x m; various]"""
    @damping_matrix_ff.setter
    def damping_matrix_ff(self, value: MatrixLike | None) -> None: ...
    @property
    def dampingMatrixFF(self) -> MatrixContainer:
        """damping matrix of the free mesh in the body frame; three rows and columns per mesh node, or empty for zero [n x m; various]"""
    @dampingMatrixFF.setter
    def dampingMatrixFF(self, value: MatrixLike | None) -> None: ...
    @property
    def force_vector(self) -> Array:
        """constant generalized forces on the right hand side, for body frame and mesh, in global components; those of the mesh are turned into the body frame; empty for zero [n; various]"""
    @force_vector.setter
    def force_vector(self, value: ArrayLike) -> None: ...
    @property
    def forceVector(self) -> Array:
        """constant generalized forces on the right hand side, for body frame and mesh, in global components; those of the mesh are turned into the body frame; empty for zero [n; various]"""
    @forceVector.setter
    def forceVector(self, value: ArrayLike) -> None: ...
    @property
    def force_user_function(self) -> Callable[[MainSystem, float, int, Array, Array], ArrayLike] | Literal[0]:
        """function that gives further generalized forces on the right hand side"""
    @force_user_function.setter
    def force_user_function(self, value: Callable[[MainSystem, float, int, Array, Array], ArrayLike] | Literal[0]) -> None: ...
    @property
    def forceUserFunction(self) -> Callable[[MainSystem, float, int, Array, Array], ArrayLike] | Literal[0]:
        """function that gives further generalized forces on the right hand side"""
    @forceUserFunction.setter
    def forceUserFunction(self, value: Callable[[MainSystem, float, int, Array, Array], ArrayLike] | Literal[0]) -> None: ...
    @property
    def mass_matrix_user_function(self) -> Callable[[MainSystem, float, int, Array, Array], ArrayLike] | Literal[0]:
        """function that gives an additional mass matrix for all coordinates; its dependence on them is left out of the tangent"""
    @mass_matrix_user_function.setter
    def mass_matrix_user_function(self, value: Callable[[MainSystem, float, int, Array, Array], ArrayLike] | Literal[0]) -> None: ...
    @property
    def massMatrixUserFunction(self) -> Callable[[MainSystem, float, int, Array, Array], ArrayLike] | Literal[0]:
        """function that gives an additional mass matrix for all coordinates; its dependence on them is left out of the tangent"""
    @massMatrixUserFunction.setter
    def massMatrixUserFunction(self, value: Callable[[MainSystem, float, int, Array, Array], ArrayLike] | Literal[0]) -> None: ...
    @property
    def compute_ffrf_terms(self) -> bool:
        """true: inertia, stiffness and damping of rigid body motion and deformation are computed by the object; false: the user functions supply all forces and the mass matrix"""
    @compute_ffrf_terms.setter
    def compute_ffrf_terms(self, value: bool) -> None: ...
    @property
    def computeFFRFterms(self) -> bool:
        """true: inertia, stiffness and damping of rigid body motion and deformation are computed by the object; false: the user functions supply all forces and the mass matrix"""
    @computeFFRFterms.setter
    def computeFFRFterms(self, value: bool) -> None: ...
    @property
    def object_is_initialized(self) -> bool:
        """leave it at false; the object sets it when its constant matrices are computed in ``Assemble()``, and setting it back to false has them computed anew"""
    @object_is_initialized.setter
    def object_is_initialized(self, value: bool) -> None: ...
    @property
    def objectIsInitialized(self) -> bool:
        """leave it at false; the object sets it when its constant matrices are computed in ``Assemble()``, and setting it back to false has them computed anew"""
    @objectIsInitialized.setter
    def objectIsInitialized(self, value: bool) -> None: ...
    @property
    def coordinates(self) -> Array:
        """coordinates of all nodes of the object, relative to the reference values [various]"""
    @property
    def coordinates_t(self) -> Array:
        """first time derivatives of the coordinates of all nodes [various]"""
    @property
    def coordinates_tt(self) -> Array:
        """second time derivatives of the coordinates of all nodes [various]"""
    @property
    def force(self) -> Array:
        """generalized forces of the object without inertia, one per coordinate, as they stand on the left hand side of the equations of motion [various]"""
    @property
    def kinetic_energy(self) -> float:
        """kinetic energy of the whole body; the local position has no influence [J]"""
    @property
    def potential_energy(self) -> float:
        """strain energy of the mesh; not available with a force user function [J]"""

class ObjectFFRFreducedOrder(ObjectHandle):
    """Handle: flexible body with modal coordinates in a floating frame of reference"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def node_numbers(self) -> tuple[NodeHandle, ...]:
        """two nodes: the rigid body node of the body frame, and a ``NodeGenericODE2`` with the modal coordinates, whose reference coordinates are zero [n]"""
    @node_numbers.setter
    def node_numbers(self, value: Sequence[NodeIndex | int | str]) -> None: ...
    @property
    def nodeNumbers(self) -> tuple[NodeHandle, ...]:
        """two nodes: the rigid body node of the body frame, and a ``NodeGenericODE2`` with the modal coordinates, whose reference coordinates are zero [n]"""
    @nodeNumbers.setter
    def nodeNumbers(self, value: Sequence[NodeIndex | int | str]) -> None: ...
    @property
    def mass_matrix_reduced(self) -> MatrixContainer:
        """modal mass matrix, one row and column per mode, dense or sparse [n x m; various]"""
    @mass_matrix_reduced.setter
    def mass_matrix_reduced(self, value: MatrixLike | None) -> None: ...
    @property
    def massMatrixReduced(self) -> MatrixContainer:
        """modal mass matrix, one row and column per mode, dense or sparse [n x m; various]"""
    @massMatrixReduced.setter
    def massMatrixReduced(self, value: MatrixLike | None) -> None: ...
    @property
    def stiffness_matrix_reduced(self) -> MatrixContainer:
        """modal stiffness matrix, one row and column per mode, dense or sparse; empty for zero [n x m; various]"""
    @stiffness_matrix_reduced.setter
    def stiffness_matrix_reduced(self, value: MatrixLike | None) -> None: ...
    @property
    def stiffnessMatrixReduced(self) -> MatrixContainer:
        """modal stiffness matrix, one row and column per mode, dense or sparse; empty for zero [n x m; various]"""
    @stiffnessMatrixReduced.setter
    def stiffnessMatrixReduced(self, value: MatrixLike | None) -> None: ...
    @property
    def damping_matrix_reduced(self) -> MatrixContainer:
        """modal damping matrix, one row and column per mode; empty for zero [n x m; various]"""
    @damping_matrix_reduced.setter
    def damping_matrix_reduced(self, value: MatrixLike | None) -> None: ...
    @property
    def dampingMatrixReduced(self) -> MatrixContainer:
        """modal damping matrix, one row and column per mode; empty for zero [n x m; various]"""
    @dampingMatrixReduced.setter
    def dampingMatrixReduced(self, value: MatrixLike | None) -> None: ...
    @property
    def force_user_function(self) -> Callable[[MainSystem, float, int, Array, Array], ArrayLike] | Literal[0]:
        """function that gives generalized forces on the right hand side"""
    @force_user_function.setter
    def force_user_function(self, value: Callable[[MainSystem, float, int, Array, Array], ArrayLike] | Literal[0]) -> None: ...
    @property
    def forceUserFunction(self) -> Callable[[MainSystem, float, int, Array, Array], ArrayLike] | Literal[0]:
        """function that gives generalized forces on the right hand side"""
    @forceUserFunction.setter
    def forceUserFunction(self, value: Callable[[MainSystem, float, int, Array, Array], ArrayLike] | Literal[0]) -> None: ...
    @property
    def mass_matrix_user_function(self) -> Callable[[MainSystem, float, int, Array, Array], ArrayLike] | Literal[0]:
        """function that gives an additional mass matrix for all coordinates; its dependence on them is left out of the tangent"""
    @mass_matrix_user_function.setter
    def mass_matrix_user_function(self, value: Callable[[MainSystem, float, int, Array, Array], ArrayLike] | Literal[0]) -> None: ...
    @property
    def massMatrixUserFunction(self) -> Callable[[MainSystem, float, int, Array, Array], ArrayLike] | Literal[0]:
        """function that gives an additional mass matrix for all coordinates; its dependence on them is left out of the tangent"""
    @massMatrixUserFunction.setter
    def massMatrixUserFunction(self, value: Callable[[MainSystem, float, int, Array, Array], ArrayLike] | Literal[0]) -> None: ...
    @property
    def compute_ffrf_terms(self) -> bool:
        """True: the object computes inertia with its coupling of rigid body motion and deformation, stiffness and damping; False: only the user functions act"""
    @compute_ffrf_terms.setter
    def compute_ffrf_terms(self, value: bool) -> None: ...
    @property
    def computeFFRFterms(self) -> bool:
        """True: the object computes inertia with its coupling of rigid body motion and deformation, stiffness and damping; False: only the user functions act"""
    @computeFFRFterms.setter
    def computeFFRFterms(self, value: bool) -> None: ...
    @property
    def mode_basis(self) -> Array:
        """one column per mode, three rows per mesh node: displacements of the mesh in the body frame for a unit modal coordinate [n x m; various]"""
    @mode_basis.setter
    def mode_basis(self, value: ArrayLike) -> None: ...
    @property
    def modeBasis(self) -> Array:
        """one column per mode, three rows per mesh node: displacements of the mesh in the body frame for a unit modal coordinate [n x m; various]"""
    @modeBasis.setter
    def modeBasis(self, value: ArrayLike) -> None: ...
    @property
    def output_variable_mode_basis(self) -> Array:
        """values of an output variable per unit modal coordinate, one row per mesh node; each mode has six columns, its components; empty: not used [n x m; various]"""
    @output_variable_mode_basis.setter
    def output_variable_mode_basis(self, value: ArrayLike) -> None: ...
    @property
    def outputVariableModeBasis(self) -> Array:
        """values of an output variable per unit modal coordinate, one row per mesh node; each mode has six columns, its components; empty: not used [n x m; various]"""
    @outputVariableModeBasis.setter
    def outputVariableModeBasis(self, value: ArrayLike) -> None: ...
    @property
    def output_variable_type_mode_basis(self) -> OutputVariableType:
        """output variable that ``outputVariableModeBasis`` holds: ``StressLocal``, ``StrainLocal``, or ``_None``"""
    @output_variable_type_mode_basis.setter
    def output_variable_type_mode_basis(self, value: OutputVariableType | str) -> None: ...
    @property
    def outputVariableTypeModeBasis(self) -> OutputVariableType:
        """output variable that ``outputVariableModeBasis`` holds: ``StressLocal``, ``StrainLocal``, or ``_None``"""
    @outputVariableTypeModeBasis.setter
    def outputVariableTypeModeBasis(self, value: OutputVariableType | str) -> None: ...
    @property
    def reference_positions(self) -> Array:
        """reference positions of the mesh nodes in the body frame, three per node [n; m]"""
    @reference_positions.setter
    def reference_positions(self, value: ArrayLike) -> None: ...
    @property
    def referencePositions(self) -> Array:
        """reference positions of the mesh nodes in the body frame, three per node [n; m]"""
    @referencePositions.setter
    def referencePositions(self, value: ArrayLike) -> None: ...
    @property
    def object_is_initialized(self) -> bool:
        """leave it at False; ``Assemble()`` sets it, when it has found the parameters that follow from others"""
    @object_is_initialized.setter
    def object_is_initialized(self, value: bool) -> None: ...
    @property
    def objectIsInitialized(self) -> bool:
        """leave it at False; ``Assemble()`` sets it, when it has found the parameters that follow from others"""
    @objectIsInitialized.setter
    def objectIsInitialized(self, value: bool) -> None: ...
    @property
    def physics_mass(self) -> float:
        """total mass [kg]"""
    @physics_mass.setter
    def physics_mass(self, value: float) -> None: ...
    @property
    def physicsMass(self) -> float:
        """total mass [kg]"""
    @physicsMass.setter
    def physicsMass(self, value: float) -> None: ...
    @property
    def mass(self) -> float:
        """total mass [kg]"""
    @mass.setter
    def mass(self, value: float) -> None: ...
    @property
    def physics_inertia(self) -> Array:
        """inertia tensor of the undeformed body about the origin of the body frame [3 x 3; kg m^2]"""
    @physics_inertia.setter
    def physics_inertia(self, value: ArrayLike) -> None: ...
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
    def physics_center_of_mass(self) -> Array:
        """center of mass of the undeformed body in the body frame [3; m]"""
    @physics_center_of_mass.setter
    def physics_center_of_mass(self, value: ArrayLike) -> None: ...
    @property
    def physicsCenterOfMass(self) -> Array:
        """center of mass of the undeformed body in the body frame [3; m]"""
    @physicsCenterOfMass.setter
    def physicsCenterOfMass(self, value: ArrayLike) -> None: ...
    @property
    def center_of_mass(self) -> Array:
        """center of mass of the undeformed body in the body frame [3; m]"""
    @center_of_mass.setter
    def center_of_mass(self, value: ArrayLike) -> None: ...
    @property
    def centerOfMass(self) -> Array:
        """center of mass of the undeformed body in the body frame [3; m]"""
    @centerOfMass.setter
    def centerOfMass(self, value: ArrayLike) -> None: ...
    @property
    def m_psi_tilde_psi(self) -> Array:
        """coupling of rotations and modes that changes with deformation: block :math:`i, j` is :math:`-\\int \\boldsymbol{\\psi}_i \\times \\boldsymbol{\\psi}_j\\, \\mathrm{d}m`; empty: ``Assemble()`` finds it from ``mPsiTildePsiTilde`` [n x m; various]"""
    @m_psi_tilde_psi.setter
    def m_psi_tilde_psi(self, value: ArrayLike) -> None: ...
    @property
    def mPsiTildePsi(self) -> Array:
        """coupling of rotations and modes that changes with deformation: block :math:`i, j` is :math:`-\\int \\boldsymbol{\\psi}_i \\times \\boldsymbol{\\psi}_j\\, \\mathrm{d}m`; empty: ``Assemble()`` finds it from ``mPsiTildePsiTilde`` [n x m; various]"""
    @mPsiTildePsi.setter
    def mPsiTildePsi(self, value: ArrayLike) -> None: ...
    @property
    def m_psi_tilde_psi_tilde(self) -> Array:
        """inertia of the deformation: block :math:`i, j` is :math:`-\\int \\tilde{\\boldsymbol{\\psi}}_i \\tilde{\\boldsymbol{\\psi}}_j\\, \\mathrm{d}m` [n x m; various]"""
    @m_psi_tilde_psi_tilde.setter
    def m_psi_tilde_psi_tilde(self, value: ArrayLike) -> None: ...
    @property
    def mPsiTildePsiTilde(self) -> Array:
        """inertia of the deformation: block :math:`i, j` is :math:`-\\int \\tilde{\\boldsymbol{\\psi}}_i \\tilde{\\boldsymbol{\\psi}}_j\\, \\mathrm{d}m` [n x m; various]"""
    @mPsiTildePsiTilde.setter
    def mPsiTildePsiTilde(self, value: ArrayLike) -> None: ...
    @property
    def m_phit_t_psi(self) -> Array:
        """coupling of translations and modes: column :math:`j` is :math:`\\int \\boldsymbol{\\psi}_j\\, \\mathrm{d}m` [n x m; various]"""
    @m_phit_t_psi.setter
    def m_phit_t_psi(self, value: ArrayLike) -> None: ...
    @property
    def mPhitTPsi(self) -> Array:
        """coupling of translations and modes: column :math:`j` is :math:`\\int \\boldsymbol{\\psi}_j\\, \\mathrm{d}m` [n x m; various]"""
    @mPhitTPsi.setter
    def mPhitTPsi(self, value: ArrayLike) -> None: ...
    @property
    def m_phit_t_psi_tilde(self) -> Array:
        """the skew symmetric matrices of the columns of ``mPhitTPsi``; empty: ``Assemble()`` finds it [n x m; various]"""
    @m_phit_t_psi_tilde.setter
    def m_phit_t_psi_tilde(self, value: ArrayLike) -> None: ...
    @property
    def mPhitTPsiTilde(self) -> Array:
        """the skew symmetric matrices of the columns of ``mPhitTPsi``; empty: ``Assemble()`` finds it [n x m; various]"""
    @mPhitTPsiTilde.setter
    def mPhitTPsiTilde(self, value: ArrayLike) -> None: ...
    @property
    def m_x_ref_tilde_psi(self) -> Array:
        """coupling of rotations and modes: column :math:`j` is :math:`-\\int \\mathbf{x} \\times \\boldsymbol{\\psi}_j\\, \\mathrm{d}m`; empty: ``Assemble()`` finds it from ``mXRefTildePsiTilde`` [n x m; various]"""
    @m_x_ref_tilde_psi.setter
    def m_x_ref_tilde_psi(self, value: ArrayLike) -> None: ...
    @property
    def mXRefTildePsi(self) -> Array:
        """coupling of rotations and modes: column :math:`j` is :math:`-\\int \\mathbf{x} \\times \\boldsymbol{\\psi}_j\\, \\mathrm{d}m`; empty: ``Assemble()`` finds it from ``mXRefTildePsiTilde`` [n x m; various]"""
    @mXRefTildePsi.setter
    def mXRefTildePsi(self, value: ArrayLike) -> None: ...
    @property
    def m_x_ref_tilde_psi_tilde(self) -> Array:
        """what deformation does to the inertia: block :math:`j` is :math:`-\\int \\tilde{\\mathbf{x}}\\, \\tilde{\\boldsymbol{\\psi}}_j\\, \\mathrm{d}m` [n x m; various]"""
    @m_x_ref_tilde_psi_tilde.setter
    def m_x_ref_tilde_psi_tilde(self, value: ArrayLike) -> None: ...
    @property
    def mXRefTildePsiTilde(self) -> Array:
        """what deformation does to the inertia: block :math:`j` is :math:`-\\int \\tilde{\\mathbf{x}}\\, \\tilde{\\boldsymbol{\\psi}}_j\\, \\mathrm{d}m` [n x m; various]"""
    @mXRefTildePsiTilde.setter
    def mXRefTildePsiTilde(self, value: ArrayLike) -> None: ...
    @property
    def physics_center_of_mass_tilde(self) -> Array:
        """skew symmetric matrix of the center of mass, found by ``Assemble()`` [3 x 3; m]"""
    @physics_center_of_mass_tilde.setter
    def physics_center_of_mass_tilde(self, value: ArrayLike) -> None: ...
    @property
    def physicsCenterOfMassTilde(self) -> Array:
        """skew symmetric matrix of the center of mass, found by ``Assemble()`` [3 x 3; m]"""
    @physicsCenterOfMassTilde.setter
    def physicsCenterOfMassTilde(self, value: ArrayLike) -> None: ...
    @property
    def center_of_mass_tilde(self) -> Array:
        """skew symmetric matrix of the center of mass, found by ``Assemble()`` [3 x 3; m]"""
    @center_of_mass_tilde.setter
    def center_of_mass_tilde(self, value: ArrayLike) -> None: ...
    @property
    def centerOfMassTilde(self) -> Array:
        """skew symmetric matrix of the center of mass, found by ``Assemble()`` [3 x 3; m]"""
    @centerOfMassTilde.setter
    def centerOfMassTilde(self, value: ArrayLike) -> None: ...
    @property
    def coordinates(self) -> Array:
        """coordinates of both nodes, relative to the reference values [various]"""
    @property
    def coordinates_t(self) -> Array:
        """first time derivatives of the coordinates of both nodes [various]"""
    @property
    def force(self) -> Array:
        """generalized forces of the object without accelerations, one per coordinate, as they stand on the left hand side of the equations of motion: elastic forces and those that are quadratic in velocities [various]"""
    @property
    def kinetic_energy(self) -> float:
        """kinetic energy of the whole body; the local position has no influence [J]"""
    @property
    def potential_energy(self) -> float:
        """strain energy of the modes; not available with a force user function [J]"""

class ObjectGenericODE2(ObjectHandle):
    """Handle: system of second order differential equations with constant matrices and user functions, on any nodes"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def node_numbers(self) -> tuple[NodeHandle, ...]:
        """nodes with second order coordinates; their coordinates in this order form the vector of the object [n]"""
    @node_numbers.setter
    def node_numbers(self, value: Sequence[NodeIndex | int | str]) -> None: ...
    @property
    def nodeNumbers(self) -> tuple[NodeHandle, ...]:
        """nodes with second order coordinates; their coordinates in this order form the vector of the object [n]"""
    @nodeNumbers.setter
    def nodeNumbers(self, value: Sequence[NodeIndex | int | str]) -> None: ...
    @property
    def mass_matrix(self) -> MatrixContainer:
        """constant mass matrix; n rows and n columns for n coordinates, dense or sparse, or empty for zero; other sizes are refused [n x m; various]"""
    @mass_matrix.setter
    def mass_matrix(self, value: MatrixLike | None) -> None: ...
    @property
    def massMatrix(self) -> MatrixContainer:
        """constant mass matrix; n rows and n columns for n coordinates, dense or sparse, or empty for zero; other sizes are refused [n x m; various]"""
    @massMatrix.setter
    def massMatrix(self, value: MatrixLike | None) -> None: ...
    @property
    def stiffness_matrix(self) -> MatrixContainer:
        """constant stiffness matrix; n rows and n columns, or empty for zero; dense or sparse, in the same form as the damping matrix [n x m; various]"""
    @stiffness_matrix.setter
    def stiffness_matrix(self, value: MatrixLike | None) -> None: ...
    @property
    def stiffnessMatrix(self) -> MatrixContainer:
        """constant stiffness matrix; n rows and n columns, or empty for zero; dense or sparse, in the same form as the damping matrix [n x m; various]"""
    @stiffnessMatrix.setter
    def stiffnessMatrix(self, value: MatrixLike | None) -> None: ...
    @property
    def damping_matrix(self) -> MatrixContainer:
        """constant damping matrix; n rows and n columns, or empty for zero; dense or sparse, in the same form as the stiffness matrix [n x m; various]"""
    @damping_matrix.setter
    def damping_matrix(self, value: MatrixLike | None) -> None: ...
    @property
    def dampingMatrix(self) -> MatrixContainer:
        """constant damping matrix; n rows and n columns, or empty for zero; dense or sparse, in the same form as the stiffness matrix [n x m; various]"""
    @dampingMatrix.setter
    def dampingMatrix(self, value: MatrixLike | None) -> None: ...
    @property
    def force_vector(self) -> Array:
        """constant generalized forces on the right hand side; length n, or empty for zero [n; various]"""
    @force_vector.setter
    def force_vector(self, value: ArrayLike) -> None: ...
    @property
    def forceVector(self) -> Array:
        """constant generalized forces on the right hand side; length n, or empty for zero [n; various]"""
    @forceVector.setter
    def forceVector(self, value: ArrayLike) -> None: ...
    @property
    def force_user_function(self) -> Callable[[MainSystem, float, int, Array, Array], ArrayLike] | Literal[0]:
        """function that gives further generalized forces on the right hand side"""
    @force_user_function.setter
    def force_user_function(self, value: Callable[[MainSystem, float, int, Array, Array], ArrayLike] | Literal[0]) -> None: ...
    @property
    def forceUserFunction(self) -> Callable[[MainSystem, float, int, Array, Array], ArrayLike] | Literal[0]:
        """function that gives further generalized forces on the right hand side"""
    @forceUserFunction.setter
    def forceUserFunction(self, value: Callable[[MainSystem, float, int, Array, Array], ArrayLike] | Literal[0]) -> None: ...
    @property
    def mass_matrix_user_function(self) -> Callable[[MainSystem, float, int, Array, Array], MatrixLike] | Literal[0]:
        """function that gives the mass matrix; it replaces ``massMatrix``"""
    @mass_matrix_user_function.setter
    def mass_matrix_user_function(self, value: Callable[[MainSystem, float, int, Array, Array], MatrixLike] | Literal[0]) -> None: ...
    @property
    def massMatrixUserFunction(self) -> Callable[[MainSystem, float, int, Array, Array], MatrixLike] | Literal[0]:
        """function that gives the mass matrix; it replaces ``massMatrix``"""
    @massMatrixUserFunction.setter
    def massMatrixUserFunction(self, value: Callable[[MainSystem, float, int, Array, Array], MatrixLike] | Literal[0]) -> None: ...
    @property
    def jacobian_user_function(self) -> Callable[[MainSystem, float, int, Array, Array, float, float], MatrixLike] | Literal[0]:
        """function that returns the derivatives of the user forces; the default is numerical differentiation"""
    @jacobian_user_function.setter
    def jacobian_user_function(self, value: Callable[[MainSystem, float, int, Array, Array, float, float], MatrixLike] | Literal[0]) -> None: ...
    @property
    def jacobianUserFunction(self) -> Callable[[MainSystem, float, int, Array, Array, float, float], MatrixLike] | Literal[0]:
        """function that returns the derivatives of the user forces; the default is numerical differentiation"""
    @jacobianUserFunction.setter
    def jacobianUserFunction(self, value: Callable[[MainSystem, float, int, Array, Array, float, float], MatrixLike] | Literal[0]) -> None: ...
    @property
    def coordinates_total(self) -> Array:
        """coordinates of all nodes of the object, including the reference values [various]"""
    @property
    def coordinates(self) -> Array:
        """coordinates of all nodes of the object, relative to the reference values [various]"""
    @property
    def coordinates_t(self) -> Array:
        """first time derivatives of the coordinates of all nodes [various]"""
    @property
    def coordinates_tt(self) -> Array:
        """second time derivatives of the coordinates of all nodes [various]"""
    @property
    def force(self) -> Array:
        """generalized forces of the object without inertia, one per coordinate, as they stand on the left hand side of the equations of motion [various]"""
    @property
    def kinetic_energy(self) -> float:
        """kinetic energy of the whole body; the local position has no influence [J]"""
    @property
    def potential_energy(self) -> float:
        """stiffness times displacements, and the constant force vector, as work since the reference configuration; not available with a force user function [J]"""

class ObjectKinematicTree(ObjectHandle):
    """Handle: open tree of rigid bodies in minimal coordinates, one joint coordinate per link"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def node_number(self) -> NodeHandle:
        """generic node of second order with one coordinate per joint: rad for revolute, m for prismatic joints"""
    @node_number.setter
    def node_number(self, value: NodeIndex | int | str) -> None: ...
    @property
    def nodeNumber(self) -> NodeHandle:
        """generic node of second order with one coordinate per joint: rad for revolute, m for prismatic joints"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    @property
    def gravity(self) -> Array:
        """gravity in global components; mass proportional loads do not act on this object [3; m/s^2]"""
    @gravity.setter
    def gravity(self, value: ArrayLike) -> None: ...
    @property
    def base_offset(self) -> Array:
        """global position of the base frame [3; m]"""
    @base_offset.setter
    def base_offset(self, value: ArrayLike) -> None: ...
    @property
    def baseOffset(self) -> Array:
        """global position of the base frame [3; m]"""
    @baseOffset.setter
    def baseOffset(self, value: ArrayLike) -> None: ...
    @property
    def joint_types(self) -> tuple[JointType, ...]:
        """type of each joint, one per link; required [n]"""
    @joint_types.setter
    def joint_types(self, value: Sequence[JointType]) -> None: ...
    @property
    def jointTypes(self) -> tuple[JointType, ...]:
        """type of each joint, one per link; required [n]"""
    @jointTypes.setter
    def jointTypes(self, value: Sequence[JointType]) -> None: ...
    @property
    def link_parents(self) -> tuple[int, ...]:
        """number of the parent link of each link, -1 for the base; a parent has a smaller number than its links; required [n]"""
    @link_parents.setter
    def link_parents(self, value: Sequence[int]) -> None: ...
    @property
    def linkParents(self) -> tuple[int, ...]:
        """number of the parent link of each link, -1 for the base; a parent has a smaller number than its links; required [n]"""
    @linkParents.setter
    def linkParents(self, value: Sequence[int]) -> None: ...
    @property
    def joint_transformations(self) -> Matrix3DList:
        """the rotation matrix from its joint frame, at coordinate zero, to the frame of the parent; required [n x 3 x 3; 1]"""
    @joint_transformations.setter
    def joint_transformations(self, value: Sequence[ArrayLike] | Matrix3DList) -> None: ...
    @property
    def jointTransformations(self) -> Matrix3DList:
        """the rotation matrix from its joint frame, at coordinate zero, to the frame of the parent; required [n x 3 x 3; 1]"""
    @jointTransformations.setter
    def jointTransformations(self, value: Sequence[ArrayLike] | Matrix3DList) -> None: ...
    @property
    def joint_offsets(self) -> Vector3DList:
        """the origin of its joint frame in the frame of the parent, for the base in the base frame; required [n x 3; m]"""
    @joint_offsets.setter
    def joint_offsets(self, value: Sequence[ArrayLike] | Vector3DList) -> None: ...
    @property
    def jointOffsets(self) -> Vector3DList:
        """the origin of its joint frame in the frame of the parent, for the base in the base frame; required [n x 3; m]"""
    @jointOffsets.setter
    def jointOffsets(self, value: Sequence[ArrayLike] | Vector3DList) -> None: ...
    @property
    def link_inertias_com(self) -> Matrix3DList:
        """the inertia tensor about its center of mass, in the frame of the link; required [n x 3 x 3; kg m^2]"""
    @link_inertias_com.setter
    def link_inertias_com(self, value: Sequence[ArrayLike] | Matrix3DList) -> None: ...
    @property
    def linkInertiasCOM(self) -> Matrix3DList:
        """the inertia tensor about its center of mass, in the frame of the link; required [n x 3 x 3; kg m^2]"""
    @linkInertiasCOM.setter
    def linkInertiasCOM(self, value: Sequence[ArrayLike] | Matrix3DList) -> None: ...
    @property
    def link_coms(self) -> Vector3DList:
        """the center of mass in the frame of the link; required [n x 3; m]"""
    @link_coms.setter
    def link_coms(self, value: Sequence[ArrayLike] | Vector3DList) -> None: ...
    @property
    def linkCOMs(self) -> Vector3DList:
        """the center of mass in the frame of the link; required [n x 3; m]"""
    @linkCOMs.setter
    def linkCOMs(self, value: Sequence[ArrayLike] | Vector3DList) -> None: ...
    @property
    def link_masses(self) -> Array:
        """mass of each link; required [n; kg]"""
    @link_masses.setter
    def link_masses(self, value: ArrayLike) -> None: ...
    @property
    def linkMasses(self) -> Array:
        """mass of each link; required [n; kg]"""
    @linkMasses.setter
    def linkMasses(self, value: ArrayLike) -> None: ...
    @property
    def link_forces(self) -> Vector3DList:
        """a force in global components at the origin of its joint frame; empty for zero [n x 3; N]"""
    @link_forces.setter
    def link_forces(self, value: Sequence[ArrayLike] | Vector3DList) -> None: ...
    @property
    def linkForces(self) -> Vector3DList:
        """a force in global components at the origin of its joint frame; empty for zero [n x 3; N]"""
    @linkForces.setter
    def linkForces(self, value: Sequence[ArrayLike] | Vector3DList) -> None: ...
    @property
    def link_torques(self) -> Vector3DList:
        """a torque in global components; empty for zero [n x 3; Nm]"""
    @link_torques.setter
    def link_torques(self, value: Sequence[ArrayLike] | Vector3DList) -> None: ...
    @property
    def linkTorques(self) -> Vector3DList:
        """a torque in global components; empty for zero [n x 3; Nm]"""
    @linkTorques.setter
    def linkTorques(self, value: Sequence[ArrayLike] | Vector3DList) -> None: ...
    @property
    def joint_force_vector(self) -> Array:
        """a torque (Nm) or force (N) about or along its axis, positive on the link and negative on its parent; empty for zero [n; various]"""
    @joint_force_vector.setter
    def joint_force_vector(self, value: ArrayLike) -> None: ...
    @property
    def jointForceVector(self) -> Array:
        """a torque (Nm) or force (N) about or along its axis, positive on the link and negative on its parent; empty for zero [n; various]"""
    @jointForceVector.setter
    def jointForceVector(self, value: ArrayLike) -> None: ...
    @property
    def joint_position_offset_vector(self) -> Array:
        """desired joint coordinates of the position control (rad or m); empty for zero [n; various]"""
    @joint_position_offset_vector.setter
    def joint_position_offset_vector(self, value: ArrayLike) -> None: ...
    @property
    def jointPositionOffsetVector(self) -> Array:
        """desired joint coordinates of the position control (rad or m); empty for zero [n; various]"""
    @jointPositionOffsetVector.setter
    def jointPositionOffsetVector(self, value: ArrayLike) -> None: ...
    @property
    def joint_velocity_offset_vector(self) -> Array:
        """desired joint velocities of the velocity control (rad/s or m/s); empty for zero [n; various]"""
    @joint_velocity_offset_vector.setter
    def joint_velocity_offset_vector(self, value: ArrayLike) -> None: ...
    @property
    def jointVelocityOffsetVector(self) -> Array:
        """desired joint velocities of the velocity control (rad/s or m/s); empty for zero [n; various]"""
    @jointVelocityOffsetVector.setter
    def jointVelocityOffsetVector(self, value: ArrayLike) -> None: ...
    @property
    def joint_p_control_vector(self) -> Array:
        """proportional gain of each joint (Nm/rad or N/m); empty for zero [n; various]"""
    @joint_p_control_vector.setter
    def joint_p_control_vector(self, value: ArrayLike) -> None: ...
    @property
    def jointPControlVector(self) -> Array:
        """proportional gain of each joint (Nm/rad or N/m); empty for zero [n; various]"""
    @jointPControlVector.setter
    def jointPControlVector(self, value: ArrayLike) -> None: ...
    @property
    def joint_d_control_vector(self) -> Array:
        """derivative gain of each joint (Nm s/rad or Ns/m); empty for zero [n; various]"""
    @joint_d_control_vector.setter
    def joint_d_control_vector(self, value: ArrayLike) -> None: ...
    @property
    def jointDControlVector(self) -> Array:
        """derivative gain of each joint (Nm s/rad or Ns/m); empty for zero [n; various]"""
    @jointDControlVector.setter
    def jointDControlVector(self, value: ArrayLike) -> None: ...
    @property
    def force_user_function(self) -> Callable[[MainSystem, float, int, Array, Array], ArrayLike] | Literal[0]:
        """function that gives further joint forces, which act as those of ``jointForceVector``"""
    @force_user_function.setter
    def force_user_function(self, value: Callable[[MainSystem, float, int, Array, Array], ArrayLike] | Literal[0]) -> None: ...
    @property
    def forceUserFunction(self) -> Callable[[MainSystem, float, int, Array, Array], ArrayLike] | Literal[0]:
        """function that gives further joint forces, which act as those of ``jointForceVector``"""
    @forceUserFunction.setter
    def forceUserFunction(self, value: Callable[[MainSystem, float, int, Array, Array], ArrayLike] | Literal[0]) -> None: ...
    @property
    def link_names(self) -> tuple[str, ...]:
        """a name, which may stand wherever the number of a link is asked for, or an empty string; empty for no names [n]"""
    @link_names.setter
    def link_names(self, value: Sequence[str]) -> None: ...
    @property
    def linkNames(self) -> tuple[str, ...]:
        """a name, which may stand wherever the number of a link is asked for, or an empty string; empty for no names [n]"""
    @linkNames.setter
    def linkNames(self, value: Sequence[str]) -> None: ...
    @property
    def joint_names(self) -> tuple[str, ...]:
        """a name, which may stand for the number of the joint and for that of the link which it carries, or an empty string; empty for no names [n]"""
    @joint_names.setter
    def joint_names(self, value: Sequence[str]) -> None: ...
    @property
    def jointNames(self) -> tuple[str, ...]:
        """a name, which may stand for the number of the joint and for that of the link which it carries, or an empty string; empty for no names [n]"""
    @jointNames.setter
    def jointNames(self, value: Sequence[str]) -> None: ...
    @property
    def coordinates(self) -> Array:
        """joint coordinates, including the reference values (unlike the output of the same name of the node) [various]"""
    @property
    def coordinates_t(self) -> Array:
        """joint velocities [various]"""
    @property
    def coordinates_tt(self) -> Array:
        """joint accelerations [various]"""
    @property
    def force(self) -> Array:
        """generalized forces of the object without inertia, one per coordinate, as they stand on the left hand side of the equations of motion [various]"""
    @property
    def kinetic_energy(self) -> float:
        """kinetic energy of the whole body; the local position has no influence [J]"""
    @property
    def potential_energy(self) -> float:
        """work against weight, link forces and joint forces since the reference configuration, and the springs of joint controllers; not available with a force user function [J]"""

class ObjectALEANCFCable2D(ObjectHandle):
    """Handle: planar cable through which material moves along the axis, on two nodes with slope and one node with the axial coordinate"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def physics_length(self) -> float:
        """length of the element in its undeformed state; must be positive [m]"""
    @physics_length.setter
    def physics_length(self, value: float) -> None: ...
    @property
    def physicsLength(self) -> float:
        """length of the element in its undeformed state; must be positive [m]"""
    @physicsLength.setter
    def physicsLength(self, value: float) -> None: ...
    @property
    def length(self) -> float:
        """length of the element in its undeformed state; must be positive [m]"""
    @length.setter
    def length(self, value: float) -> None: ...
    @property
    def physics_mass_per_length(self) -> float:
        """total mass per undeformed length, of the resting and the moving part [kg/m]"""
    @physics_mass_per_length.setter
    def physics_mass_per_length(self, value: float) -> None: ...
    @property
    def physicsMassPerLength(self) -> float:
        """total mass per undeformed length, of the resting and the moving part [kg/m]"""
    @physicsMassPerLength.setter
    def physicsMassPerLength(self, value: float) -> None: ...
    @property
    def mass_per_length(self) -> float:
        """total mass per undeformed length, of the resting and the moving part [kg/m]"""
    @mass_per_length.setter
    def mass_per_length(self, value: float) -> None: ...
    @property
    def massPerLength(self) -> float:
        """total mass per undeformed length, of the resting and the moving part [kg/m]"""
    @massPerLength.setter
    def massPerLength(self, value: float) -> None: ...
    @property
    def physics_moving_mass_factor(self) -> float:
        """share of the mass per length that moves along the axis: 1: axially moving beam, 0: no motion; a pipe with fluid lies between [1]"""
    @physics_moving_mass_factor.setter
    def physics_moving_mass_factor(self, value: float) -> None: ...
    @property
    def physicsMovingMassFactor(self) -> float:
        """share of the mass per length that moves along the axis: 1: axially moving beam, 0: no motion; a pipe with fluid lies between [1]"""
    @physicsMovingMassFactor.setter
    def physicsMovingMassFactor(self, value: float) -> None: ...
    @property
    def moving_mass_factor(self) -> float:
        """share of the mass per length that moves along the axis: 1: axially moving beam, 0: no motion; a pipe with fluid lies between [1]"""
    @moving_mass_factor.setter
    def moving_mass_factor(self, value: float) -> None: ...
    @property
    def movingMassFactor(self) -> float:
        """share of the mass per length that moves along the axis: 1: axially moving beam, 0: no motion; a pipe with fluid lies between [1]"""
    @movingMassFactor.setter
    def movingMassFactor(self, value: float) -> None: ...
    @property
    def physics_bending_stiffness(self) -> float:
        """bending stiffness: bending moment per curvature [N m^2]"""
    @physics_bending_stiffness.setter
    def physics_bending_stiffness(self, value: float) -> None: ...
    @property
    def physicsBendingStiffness(self) -> float:
        """bending stiffness: bending moment per curvature [N m^2]"""
    @physicsBendingStiffness.setter
    def physicsBendingStiffness(self, value: float) -> None: ...
    @property
    def bending_stiffness(self) -> float:
        """bending stiffness: bending moment per curvature [N m^2]"""
    @bending_stiffness.setter
    def bending_stiffness(self, value: float) -> None: ...
    @property
    def bendingStiffness(self) -> float:
        """bending stiffness: bending moment per curvature [N m^2]"""
    @bendingStiffness.setter
    def bendingStiffness(self, value: float) -> None: ...
    @property
    def physics_axial_stiffness(self) -> float:
        """axial stiffness: axial force per axial strain [N]"""
    @physics_axial_stiffness.setter
    def physics_axial_stiffness(self, value: float) -> None: ...
    @property
    def physicsAxialStiffness(self) -> float:
        """axial stiffness: axial force per axial strain [N]"""
    @physicsAxialStiffness.setter
    def physicsAxialStiffness(self, value: float) -> None: ...
    @property
    def axial_stiffness(self) -> float:
        """axial stiffness: axial force per axial strain [N]"""
    @axial_stiffness.setter
    def axial_stiffness(self, value: float) -> None: ...
    @property
    def axialStiffness(self) -> float:
        """axial stiffness: axial force per axial strain [N]"""
    @axialStiffness.setter
    def axialStiffness(self, value: float) -> None: ...
    @property
    def physics_bending_damping(self) -> float:
        """viscous damping of bending: bending moment per rate of curvature [N m^2 s]"""
    @physics_bending_damping.setter
    def physics_bending_damping(self, value: float) -> None: ...
    @property
    def physicsBendingDamping(self) -> float:
        """viscous damping of bending: bending moment per rate of curvature [N m^2 s]"""
    @physicsBendingDamping.setter
    def physicsBendingDamping(self, value: float) -> None: ...
    @property
    def bending_damping(self) -> float:
        """viscous damping of bending: bending moment per rate of curvature [N m^2 s]"""
    @bending_damping.setter
    def bending_damping(self, value: float) -> None: ...
    @property
    def bendingDamping(self) -> float:
        """viscous damping of bending: bending moment per rate of curvature [N m^2 s]"""
    @bendingDamping.setter
    def bendingDamping(self, value: float) -> None: ...
    @property
    def physics_axial_damping(self) -> float:
        """viscous damping of stretching: axial force per rate of axial strain [N s]"""
    @physics_axial_damping.setter
    def physics_axial_damping(self, value: float) -> None: ...
    @property
    def physicsAxialDamping(self) -> float:
        """viscous damping of stretching: axial force per rate of axial strain [N s]"""
    @physicsAxialDamping.setter
    def physicsAxialDamping(self, value: float) -> None: ...
    @property
    def axial_damping(self) -> float:
        """viscous damping of stretching: axial force per rate of axial strain [N s]"""
    @axial_damping.setter
    def axial_damping(self, value: float) -> None: ...
    @property
    def axialDamping(self) -> float:
        """viscous damping of stretching: axial force per rate of axial strain [N s]"""
    @axialDamping.setter
    def axialDamping(self, value: float) -> None: ...
    @property
    def physics_reference_axial_strain(self) -> float:
        """axial strain at which the axial force is zero [1]"""
    @physics_reference_axial_strain.setter
    def physics_reference_axial_strain(self, value: float) -> None: ...
    @property
    def physicsReferenceAxialStrain(self) -> float:
        """axial strain at which the axial force is zero [1]"""
    @physicsReferenceAxialStrain.setter
    def physicsReferenceAxialStrain(self, value: float) -> None: ...
    @property
    def reference_axial_strain(self) -> float:
        """axial strain at which the axial force is zero [1]"""
    @reference_axial_strain.setter
    def reference_axial_strain(self, value: float) -> None: ...
    @property
    def referenceAxialStrain(self) -> float:
        """axial strain at which the axial force is zero [1]"""
    @referenceAxialStrain.setter
    def referenceAxialStrain(self, value: float) -> None: ...
    @property
    def physics_reference_curvature(self) -> float:
        """curvature at which the bending moment is zero; positive for a left turn along the axis [1/m]"""
    @physics_reference_curvature.setter
    def physics_reference_curvature(self, value: float) -> None: ...
    @property
    def physicsReferenceCurvature(self) -> float:
        """curvature at which the bending moment is zero; positive for a left turn along the axis [1/m]"""
    @physicsReferenceCurvature.setter
    def physicsReferenceCurvature(self, value: float) -> None: ...
    @property
    def reference_curvature(self) -> float:
        """curvature at which the bending moment is zero; positive for a left turn along the axis [1/m]"""
    @reference_curvature.setter
    def reference_curvature(self, value: float) -> None: ...
    @property
    def referenceCurvature(self) -> float:
        """curvature at which the bending moment is zero; positive for a left turn along the axis [1/m]"""
    @referenceCurvature.setter
    def referenceCurvature(self, value: float) -> None: ...
    @property
    def physics_use_coupling_terms(self) -> bool:
        """true: all inertia terms of the axial motion act; false: accelerations of cable and axial coordinate are not coupled, and the latter has a constant mass"""
    @physics_use_coupling_terms.setter
    def physics_use_coupling_terms(self, value: bool) -> None: ...
    @property
    def physicsUseCouplingTerms(self) -> bool:
        """true: all inertia terms of the axial motion act; false: accelerations of cable and axial coordinate are not coupled, and the latter has a constant mass"""
    @physicsUseCouplingTerms.setter
    def physicsUseCouplingTerms(self, value: bool) -> None: ...
    @property
    def use_coupling_terms(self) -> bool:
        """true: all inertia terms of the axial motion act; false: accelerations of cable and axial coordinate are not coupled, and the latter has a constant mass"""
    @use_coupling_terms.setter
    def use_coupling_terms(self, value: bool) -> None: ...
    @property
    def useCouplingTerms(self) -> bool:
        """true: all inertia terms of the axial motion act; false: accelerations of cable and axial coordinate are not coupled, and the latter has a constant mass"""
    @useCouplingTerms.setter
    def useCouplingTerms(self, value: bool) -> None: ...
    @property
    def physics_add_ale_variation(self) -> bool:
        """true: the axial coordinate feels the change of strain and curvature energy that its motion brings about; false: this term is left out"""
    @physics_add_ale_variation.setter
    def physics_add_ale_variation(self, value: bool) -> None: ...
    @property
    def physicsAddALEvariation(self) -> bool:
        """true: the axial coordinate feels the change of strain and curvature energy that its motion brings about; false: this term is left out"""
    @physicsAddALEvariation.setter
    def physicsAddALEvariation(self, value: bool) -> None: ...
    @property
    def add_ale_variation(self) -> bool:
        """true: the axial coordinate feels the change of strain and curvature energy that its motion brings about; false: this term is left out"""
    @add_ale_variation.setter
    def add_ale_variation(self, value: bool) -> None: ...
    @property
    def addALEvariation(self) -> bool:
        """true: the axial coordinate feels the change of strain and curvature energy that its motion brings about; false: this term is left out"""
    @addALEvariation.setter
    def addALEvariation(self, value: bool) -> None: ...
    @property
    def node_numbers(self) -> tuple[NodeHandle, ...]:
        """node at axial position 0, node at axial position L (both with position and slope in the plane), and a generic node of second order whose coordinate is the axial displacement of the material [3]"""
    @node_numbers.setter
    def node_numbers(self, value: Sequence[NodeIndex | int | str]) -> None: ...
    @property
    def nodeNumbers(self) -> tuple[NodeHandle, ...]:
        """node at axial position 0, node at axial position L (both with position and slope in the plane), and a generic node of second order whose coordinate is the axial displacement of the material [3]"""
    @nodeNumbers.setter
    def nodeNumbers(self, value: Sequence[NodeIndex | int | str]) -> None: ...
    @property
    def use_reduced_order_integration(self) -> int:
        """integration of the elastic forces along the axis: 0: 5 Gauss points for stretching and 3 for bending; 1: 4 and 2; 2: 3 Lobatto points for stretching and 2 Gauss points for bending"""
    @use_reduced_order_integration.setter
    def use_reduced_order_integration(self, value: int) -> None: ...
    @property
    def useReducedOrderIntegration(self) -> int:
        """integration of the elastic forces along the axis: 0: 5 Gauss points for stretching and 3 for bending; 1: 4 and 2; 2: 3 Lobatto points for stretching and 2 Gauss points for bending"""
    @useReducedOrderIntegration.setter
    def useReducedOrderIntegration(self, value: int) -> None: ...
    @property
    def strain_is_relative_to_reference(self) -> float:
        """share of the strains of the reference configuration that are free of stress: 0 for an element that is straight and of length L without stress, 1 for a reference configuration without stress; values between serve for a transition [1]"""
    @strain_is_relative_to_reference.setter
    def strain_is_relative_to_reference(self, value: float) -> None: ...
    @property
    def strainIsRelativeToReference(self) -> float:
        """share of the strains of the reference configuration that are free of stress: 0 for an element that is straight and of length L without stress, 1 for a reference configuration without stress; values between serve for a transition [1]"""
    @strainIsRelativeToReference.setter
    def strainIsRelativeToReference(self, value: float) -> None: ...
    @property
    def position(self) -> Array:
        """global position of the local point [m]"""
    def position_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def displacement(self) -> Array:
        """global displacement of the local point [m]"""
    def displacement_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def velocity(self) -> Array:
        """global velocity of the material at the local point [m/s]"""
    def velocity_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def velocity_local(self) -> Array:
        """velocity of the material at the local point in the frame of the cross section [m/s]"""
    def velocity_local_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def rotation(self) -> float:
        """angle from the global x-axis to the slope vector, positive about z [rad]"""
    def rotation_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> float: ...
    @property
    def director1(self) -> Array:
        """slope vector of the axis; its length is 1 + axial strain [1]"""
    def director1_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def strain_local(self) -> float:
        """axial strain of the axis [1]"""
    def strain_local_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> float: ...
    @property
    def curvature_local(self) -> float:
        """material curvature of the axis; positive for a left turn along the axis [1/m]"""
    def curvature_local_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> float: ...
    @property
    def force_local(self) -> float:
        """axial force, positive for tension; oscillates along the element when bending dominates [N]"""
    def force_local_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> float: ...
    @property
    def torque_local(self) -> float:
        """bending moment, positive with positive curvature [Nm]"""
    def torque_local_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> float: ...
    @property
    def kinetic_energy(self) -> float:
        """kinetic energy of the whole body; the local position has no influence [J]"""
    @property
    def potential_energy(self) -> float:
        """energy of the strains; the local position has no influence, and loads are not included [J]"""

class ObjectANCFBeam(ObjectHandle):
    """Handle: spatial beam with shear and cross section deformation, on two nodes with position and two slopes"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def node_numbers(self) -> tuple[NodeHandle, ...]:
        """node at the negative and node at the positive end of the axis, each with position and the slopes of the cross section [2]"""
    @node_numbers.setter
    def node_numbers(self, value: Sequence[NodeIndex | int | str]) -> None: ...
    @property
    def nodeNumbers(self) -> tuple[NodeHandle, ...]:
        """node at the negative and node at the positive end of the axis, each with position and the slopes of the cross section [2]"""
    @nodeNumbers.setter
    def nodeNumbers(self, value: Sequence[NodeIndex | int | str]) -> None: ...
    @property
    def physics_length(self) -> float:
        """length of the element in its undeformed state; must be positive [m]"""
    @physics_length.setter
    def physics_length(self, value: float) -> None: ...
    @property
    def physicsLength(self) -> float:
        """length of the element in its undeformed state; must be positive [m]"""
    @physicsLength.setter
    def physicsLength(self, value: float) -> None: ...
    @property
    def length(self) -> float:
        """length of the element in its undeformed state; must be positive [m]"""
    @length.setter
    def length(self, value: float) -> None: ...
    @property
    def section_data(self) -> BeamSection:
        """cross section with inertia, stiffness and damping matrices, as a ``BeamSection``"""
    @section_data.setter
    def section_data(self, value: BeamSection) -> None: ...
    @property
    def sectionData(self) -> BeamSection:
        """cross section with inertia, stiffness and damping matrices, as a ``BeamSection``"""
    @sectionData.setter
    def sectionData(self, value: BeamSection) -> None: ...
    @property
    def cross_section_penalty_factor(self) -> Array:
        """factors of the stiffness against stretching of the cross section in y and z (times the axial stiffness) and against its distortion (times the sum of the shear stiffnesses) [3; 1]"""
    @cross_section_penalty_factor.setter
    def cross_section_penalty_factor(self, value: ArrayLike) -> None: ...
    @property
    def crossSectionPenaltyFactor(self) -> Array:
        """factors of the stiffness against stretching of the cross section in y and z (times the axial stiffness) and against its distortion (times the sum of the shear stiffnesses) [3; 1]"""
    @crossSectionPenaltyFactor.setter
    def crossSectionPenaltyFactor(self, value: ArrayLike) -> None: ...
    @property
    def cross_section_damping(self) -> Array:
        """damping of the same deformations, as factors of the stiffness; 0 for none [3; s]"""
    @cross_section_damping.setter
    def cross_section_damping(self, value: ArrayLike) -> None: ...
    @property
    def crossSectionDamping(self) -> Array:
        """damping of the same deformations, as factors of the stiffness; 0 for none [3; s]"""
    @crossSectionDamping.setter
    def crossSectionDamping(self, value: ArrayLike) -> None: ...
    @property
    def position(self) -> Array:
        """global position of the local point [m]"""
    def position_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def displacement(self) -> Array:
        """global displacement of the local point [m]"""
    def displacement_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def velocity(self) -> Array:
        """global velocity of the local point [m/s]"""
    def velocity_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def velocity_local(self) -> Array:
        """velocity of the local point in the frame of the cross section [m/s]"""
    def velocity_local_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def angular_velocity(self) -> Array:
        """angular velocity of the cross section in global coordinates [rad/s]"""
    def angular_velocity_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def angular_velocity_local(self) -> Array:
        """angular velocity of the cross section in its own frame [rad/s]"""
    def angular_velocity_local_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def acceleration(self) -> Array:
        """global acceleration of the local point [m/s^2]"""
    def acceleration_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def rotation(self) -> Array:
        """Tait-Bryan angles of the frame of the cross section [rad]"""
    def rotation_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def rotation_matrix(self) -> Array:
        """rotation matrix from the frame of the cross section to the global frame, row by row [1]"""
    def rotation_matrix_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def homogeneous_transformation(self) -> HT:
        """position and rotation as a 4 x 4 matrix, row by row; output functions return ``exu.HT`` [various]"""
    def homogeneous_transformation_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> HT: ...
    @property
    def kinetic_energy(self) -> float:
        """kinetic energy of the whole body; the local position has no influence [J]"""
    @property
    def potential_energy(self) -> float:
        """energy of the strains; the local position has no influence, and loads are not included [J]"""

class ObjectANCFCable(ObjectHandle):
    """Handle: spatial cable or thin beam without torsion and shear deformation, on two nodes with position and slope"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def physics_length(self) -> float:
        """length of the element in its undeformed state; must be positive [m]"""
    @physics_length.setter
    def physics_length(self, value: float) -> None: ...
    @property
    def physicsLength(self) -> float:
        """length of the element in its undeformed state; must be positive [m]"""
    @physicsLength.setter
    def physicsLength(self, value: float) -> None: ...
    @property
    def length(self) -> float:
        """length of the element in its undeformed state; must be positive [m]"""
    @length.setter
    def length(self, value: float) -> None: ...
    @property
    def physics_mass_per_length(self) -> float:
        """mass per undeformed length [kg/m]"""
    @physics_mass_per_length.setter
    def physics_mass_per_length(self, value: float) -> None: ...
    @property
    def physicsMassPerLength(self) -> float:
        """mass per undeformed length [kg/m]"""
    @physicsMassPerLength.setter
    def physicsMassPerLength(self, value: float) -> None: ...
    @property
    def mass_per_length(self) -> float:
        """mass per undeformed length [kg/m]"""
    @mass_per_length.setter
    def mass_per_length(self, value: float) -> None: ...
    @property
    def massPerLength(self) -> float:
        """mass per undeformed length [kg/m]"""
    @massPerLength.setter
    def massPerLength(self, value: float) -> None: ...
    @property
    def physics_bending_stiffness(self) -> float:
        """bending stiffness: bending moment per curvature [N m^2]"""
    @physics_bending_stiffness.setter
    def physics_bending_stiffness(self, value: float) -> None: ...
    @property
    def physicsBendingStiffness(self) -> float:
        """bending stiffness: bending moment per curvature [N m^2]"""
    @physicsBendingStiffness.setter
    def physicsBendingStiffness(self, value: float) -> None: ...
    @property
    def bending_stiffness(self) -> float:
        """bending stiffness: bending moment per curvature [N m^2]"""
    @bending_stiffness.setter
    def bending_stiffness(self, value: float) -> None: ...
    @property
    def bendingStiffness(self) -> float:
        """bending stiffness: bending moment per curvature [N m^2]"""
    @bendingStiffness.setter
    def bendingStiffness(self, value: float) -> None: ...
    @property
    def physics_axial_stiffness(self) -> float:
        """axial stiffness: axial force per axial strain [N]"""
    @physics_axial_stiffness.setter
    def physics_axial_stiffness(self, value: float) -> None: ...
    @property
    def physicsAxialStiffness(self) -> float:
        """axial stiffness: axial force per axial strain [N]"""
    @physicsAxialStiffness.setter
    def physicsAxialStiffness(self, value: float) -> None: ...
    @property
    def axial_stiffness(self) -> float:
        """axial stiffness: axial force per axial strain [N]"""
    @axial_stiffness.setter
    def axial_stiffness(self, value: float) -> None: ...
    @property
    def axialStiffness(self) -> float:
        """axial stiffness: axial force per axial strain [N]"""
    @axialStiffness.setter
    def axialStiffness(self, value: float) -> None: ...
    @property
    def physics_bending_damping(self) -> float:
        """viscous damping of bending: bending moment per rate of curvature [N m^2 s]"""
    @physics_bending_damping.setter
    def physics_bending_damping(self, value: float) -> None: ...
    @property
    def physicsBendingDamping(self) -> float:
        """viscous damping of bending: bending moment per rate of curvature [N m^2 s]"""
    @physicsBendingDamping.setter
    def physicsBendingDamping(self, value: float) -> None: ...
    @property
    def bending_damping(self) -> float:
        """viscous damping of bending: bending moment per rate of curvature [N m^2 s]"""
    @bending_damping.setter
    def bending_damping(self, value: float) -> None: ...
    @property
    def bendingDamping(self) -> float:
        """viscous damping of bending: bending moment per rate of curvature [N m^2 s]"""
    @bendingDamping.setter
    def bendingDamping(self, value: float) -> None: ...
    @property
    def physics_axial_damping(self) -> float:
        """viscous damping of stretching: axial force per rate of axial strain [N s]"""
    @physics_axial_damping.setter
    def physics_axial_damping(self, value: float) -> None: ...
    @property
    def physicsAxialDamping(self) -> float:
        """viscous damping of stretching: axial force per rate of axial strain [N s]"""
    @physicsAxialDamping.setter
    def physicsAxialDamping(self, value: float) -> None: ...
    @property
    def axial_damping(self) -> float:
        """viscous damping of stretching: axial force per rate of axial strain [N s]"""
    @axial_damping.setter
    def axial_damping(self, value: float) -> None: ...
    @property
    def axialDamping(self) -> float:
        """viscous damping of stretching: axial force per rate of axial strain [N s]"""
    @axialDamping.setter
    def axialDamping(self, value: float) -> None: ...
    @property
    def physics_reference_axial_strain(self) -> float:
        """axial strain at which the axial force is zero [1]"""
    @physics_reference_axial_strain.setter
    def physics_reference_axial_strain(self, value: float) -> None: ...
    @property
    def physicsReferenceAxialStrain(self) -> float:
        """axial strain at which the axial force is zero [1]"""
    @physicsReferenceAxialStrain.setter
    def physicsReferenceAxialStrain(self, value: float) -> None: ...
    @property
    def reference_axial_strain(self) -> float:
        """axial strain at which the axial force is zero [1]"""
    @reference_axial_strain.setter
    def reference_axial_strain(self, value: float) -> None: ...
    @property
    def referenceAxialStrain(self) -> float:
        """axial strain at which the axial force is zero [1]"""
    @referenceAxialStrain.setter
    def referenceAxialStrain(self, value: float) -> None: ...
    @property
    def strain_is_relative_to_reference(self) -> float:
        """share of the strains of the reference configuration that are free of stress: 0 for an element that is straight and of length L without stress, 1 for a reference configuration without stress; values between serve for a transition [1]"""
    @strain_is_relative_to_reference.setter
    def strain_is_relative_to_reference(self, value: float) -> None: ...
    @property
    def strainIsRelativeToReference(self) -> float:
        """share of the strains of the reference configuration that are free of stress: 0 for an element that is straight and of length L without stress, 1 for a reference configuration without stress; values between serve for a transition [1]"""
    @strainIsRelativeToReference.setter
    def strainIsRelativeToReference(self, value: float) -> None: ...
    @property
    def node_numbers(self) -> tuple[NodeHandle, ...]:
        """node at axial position 0 and node at axial position L, both with position and one slope [2]"""
    @node_numbers.setter
    def node_numbers(self, value: Sequence[NodeIndex | int | str]) -> None: ...
    @property
    def nodeNumbers(self) -> tuple[NodeHandle, ...]:
        """node at axial position 0 and node at axial position L, both with position and one slope [2]"""
    @nodeNumbers.setter
    def nodeNumbers(self, value: Sequence[NodeIndex | int | str]) -> None: ...
    @property
    def use_reduced_order_integration(self) -> int:
        """integration of the elastic forces along the axis: 0: 5 Gauss points for stretching and 3 for bending; 1: 4 and 2; 2: 3 Lobatto points for stretching and 2 Gauss points for bending, with smoother axial forces but possibly modes without stiffness"""
    @use_reduced_order_integration.setter
    def use_reduced_order_integration(self, value: int) -> None: ...
    @property
    def useReducedOrderIntegration(self) -> int:
        """integration of the elastic forces along the axis: 0: 5 Gauss points for stretching and 3 for bending; 1: 4 and 2; 2: 3 Lobatto points for stretching and 2 Gauss points for bending, with smoother axial forces but possibly modes without stiffness"""
    @useReducedOrderIntegration.setter
    def useReducedOrderIntegration(self, value: int) -> None: ...
    @property
    def position(self) -> Array:
        """global position of the axis [m]"""
    def position_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def displacement(self) -> Array:
        """global displacement of the axis [m]"""
    def displacement_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def velocity(self) -> Array:
        """global velocity of the axis [m/s]"""
    def velocity_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def director1(self) -> Array:
        """slope vector of the axis; its length is 1 + axial strain [1]"""
    def director1_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def strain_local(self) -> float:
        """axial strain of the axis [1]"""
    def strain_local_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> float: ...
    @property
    def curvature_local(self) -> Array:
        """curvature vector [1/m]"""
    def curvature_local_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def force_local(self) -> float:
        """axial force, positive for tension; oscillates along the element when bending dominates [N]"""
    def force_local_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> float: ...
    @property
    def torque_local(self) -> Array:
        """bending moments; there is no torsional moment [Nm]"""
    def torque_local_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def acceleration(self) -> Array:
        """global acceleration of the axis [m/s^2]"""
    def acceleration_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def kinetic_energy(self) -> float:
        """kinetic energy of the whole body; the local position has no influence [J]"""
    @property
    def potential_energy(self) -> float:
        """energy of the strains; the local position has no influence, and loads are not included [J]"""

class ObjectANCFCable2D(ObjectHandle):
    """Handle: planar cable or thin beam without shear deformation for large deformation, on two nodes with position and slope"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def physics_length(self) -> float:
        """length of the element in its undeformed state; must be positive [m]"""
    @physics_length.setter
    def physics_length(self, value: float) -> None: ...
    @property
    def physicsLength(self) -> float:
        """length of the element in its undeformed state; must be positive [m]"""
    @physicsLength.setter
    def physicsLength(self, value: float) -> None: ...
    @property
    def length(self) -> float:
        """length of the element in its undeformed state; must be positive [m]"""
    @length.setter
    def length(self, value: float) -> None: ...
    @property
    def physics_mass_per_length(self) -> float:
        """mass per undeformed length [kg/m]"""
    @physics_mass_per_length.setter
    def physics_mass_per_length(self, value: float) -> None: ...
    @property
    def physicsMassPerLength(self) -> float:
        """mass per undeformed length [kg/m]"""
    @physicsMassPerLength.setter
    def physicsMassPerLength(self, value: float) -> None: ...
    @property
    def mass_per_length(self) -> float:
        """mass per undeformed length [kg/m]"""
    @mass_per_length.setter
    def mass_per_length(self, value: float) -> None: ...
    @property
    def massPerLength(self) -> float:
        """mass per undeformed length [kg/m]"""
    @massPerLength.setter
    def massPerLength(self, value: float) -> None: ...
    @property
    def physics_bending_stiffness(self) -> float:
        """bending stiffness: bending moment per curvature [N m^2]"""
    @physics_bending_stiffness.setter
    def physics_bending_stiffness(self, value: float) -> None: ...
    @property
    def physicsBendingStiffness(self) -> float:
        """bending stiffness: bending moment per curvature [N m^2]"""
    @physicsBendingStiffness.setter
    def physicsBendingStiffness(self, value: float) -> None: ...
    @property
    def bending_stiffness(self) -> float:
        """bending stiffness: bending moment per curvature [N m^2]"""
    @bending_stiffness.setter
    def bending_stiffness(self, value: float) -> None: ...
    @property
    def bendingStiffness(self) -> float:
        """bending stiffness: bending moment per curvature [N m^2]"""
    @bendingStiffness.setter
    def bendingStiffness(self, value: float) -> None: ...
    @property
    def physics_axial_stiffness(self) -> float:
        """axial stiffness: axial force per axial strain [N]"""
    @physics_axial_stiffness.setter
    def physics_axial_stiffness(self, value: float) -> None: ...
    @property
    def physicsAxialStiffness(self) -> float:
        """axial stiffness: axial force per axial strain [N]"""
    @physicsAxialStiffness.setter
    def physicsAxialStiffness(self, value: float) -> None: ...
    @property
    def axial_stiffness(self) -> float:
        """axial stiffness: axial force per axial strain [N]"""
    @axial_stiffness.setter
    def axial_stiffness(self, value: float) -> None: ...
    @property
    def axialStiffness(self) -> float:
        """axial stiffness: axial force per axial strain [N]"""
    @axialStiffness.setter
    def axialStiffness(self, value: float) -> None: ...
    @property
    def physics_bending_damping(self) -> float:
        """viscous damping of bending: bending moment per rate of curvature [N m^2 s]"""
    @physics_bending_damping.setter
    def physics_bending_damping(self, value: float) -> None: ...
    @property
    def physicsBendingDamping(self) -> float:
        """viscous damping of bending: bending moment per rate of curvature [N m^2 s]"""
    @physicsBendingDamping.setter
    def physicsBendingDamping(self, value: float) -> None: ...
    @property
    def bending_damping(self) -> float:
        """viscous damping of bending: bending moment per rate of curvature [N m^2 s]"""
    @bending_damping.setter
    def bending_damping(self, value: float) -> None: ...
    @property
    def bendingDamping(self) -> float:
        """viscous damping of bending: bending moment per rate of curvature [N m^2 s]"""
    @bendingDamping.setter
    def bendingDamping(self, value: float) -> None: ...
    @property
    def physics_axial_damping(self) -> float:
        """viscous damping of stretching: axial force per rate of axial strain [N s]"""
    @physics_axial_damping.setter
    def physics_axial_damping(self, value: float) -> None: ...
    @property
    def physicsAxialDamping(self) -> float:
        """viscous damping of stretching: axial force per rate of axial strain [N s]"""
    @physicsAxialDamping.setter
    def physicsAxialDamping(self, value: float) -> None: ...
    @property
    def axial_damping(self) -> float:
        """viscous damping of stretching: axial force per rate of axial strain [N s]"""
    @axial_damping.setter
    def axial_damping(self, value: float) -> None: ...
    @property
    def axialDamping(self) -> float:
        """viscous damping of stretching: axial force per rate of axial strain [N s]"""
    @axialDamping.setter
    def axialDamping(self, value: float) -> None: ...
    @property
    def physics_reference_axial_strain(self) -> float:
        """axial strain at which the axial force is zero [1]"""
    @physics_reference_axial_strain.setter
    def physics_reference_axial_strain(self, value: float) -> None: ...
    @property
    def physicsReferenceAxialStrain(self) -> float:
        """axial strain at which the axial force is zero [1]"""
    @physicsReferenceAxialStrain.setter
    def physicsReferenceAxialStrain(self, value: float) -> None: ...
    @property
    def reference_axial_strain(self) -> float:
        """axial strain at which the axial force is zero [1]"""
    @reference_axial_strain.setter
    def reference_axial_strain(self, value: float) -> None: ...
    @property
    def referenceAxialStrain(self) -> float:
        """axial strain at which the axial force is zero [1]"""
    @referenceAxialStrain.setter
    def referenceAxialStrain(self, value: float) -> None: ...
    @property
    def physics_reference_curvature(self) -> float:
        """curvature at which the bending moment is zero; positive for a left turn along the axis [1/m]"""
    @physics_reference_curvature.setter
    def physics_reference_curvature(self, value: float) -> None: ...
    @property
    def physicsReferenceCurvature(self) -> float:
        """curvature at which the bending moment is zero; positive for a left turn along the axis [1/m]"""
    @physicsReferenceCurvature.setter
    def physicsReferenceCurvature(self, value: float) -> None: ...
    @property
    def reference_curvature(self) -> float:
        """curvature at which the bending moment is zero; positive for a left turn along the axis [1/m]"""
    @reference_curvature.setter
    def reference_curvature(self, value: float) -> None: ...
    @property
    def referenceCurvature(self) -> float:
        """curvature at which the bending moment is zero; positive for a left turn along the axis [1/m]"""
    @referenceCurvature.setter
    def referenceCurvature(self, value: float) -> None: ...
    @property
    def strain_is_relative_to_reference(self) -> float:
        """share of the strains of the reference configuration that are free of stress: 0 for an element that is straight and of length L without stress, 1 for a reference configuration without stress; values between serve for a transition [1]"""
    @strain_is_relative_to_reference.setter
    def strain_is_relative_to_reference(self, value: float) -> None: ...
    @property
    def strainIsRelativeToReference(self) -> float:
        """share of the strains of the reference configuration that are free of stress: 0 for an element that is straight and of length L without stress, 1 for a reference configuration without stress; values between serve for a transition [1]"""
    @strainIsRelativeToReference.setter
    def strainIsRelativeToReference(self, value: float) -> None: ...
    @property
    def node_numbers(self) -> tuple[NodeHandle, ...]:
        """node at axial position 0 and node at axial position L, both with position and slope in the plane [2]"""
    @node_numbers.setter
    def node_numbers(self, value: Sequence[NodeIndex | int | str]) -> None: ...
    @property
    def nodeNumbers(self) -> tuple[NodeHandle, ...]:
        """node at axial position 0 and node at axial position L, both with position and slope in the plane [2]"""
    @nodeNumbers.setter
    def nodeNumbers(self, value: Sequence[NodeIndex | int | str]) -> None: ...
    @property
    def use_reduced_order_integration(self) -> int:
        """integration of the elastic forces along the axis: 0: 5 Gauss points for stretching and 3 for bending; 1: 4 and 2; 2: 3 Lobatto points for stretching and 2 Gauss points for bending, with smoother axial forces but possibly modes without stiffness"""
    @use_reduced_order_integration.setter
    def use_reduced_order_integration(self, value: int) -> None: ...
    @property
    def useReducedOrderIntegration(self) -> int:
        """integration of the elastic forces along the axis: 0: 5 Gauss points for stretching and 3 for bending; 1: 4 and 2; 2: 3 Lobatto points for stretching and 2 Gauss points for bending, with smoother axial forces but possibly modes without stiffness"""
    @useReducedOrderIntegration.setter
    def useReducedOrderIntegration(self, value: int) -> None: ...
    @property
    def axial_force_user_function(self) -> Callable[[MainSystem, float, int, float, float, float, float, float, float, float, float, float], float] | Literal[0]:
        """function that gives the axial force in place of the linear law"""
    @axial_force_user_function.setter
    def axial_force_user_function(self, value: Callable[[MainSystem, float, int, float, float, float, float, float, float, float, float, float], float] | Literal[0]) -> None: ...
    @property
    def axialForceUserFunction(self) -> Callable[[MainSystem, float, int, float, float, float, float, float, float, float, float, float], float] | Literal[0]:
        """function that gives the axial force in place of the linear law"""
    @axialForceUserFunction.setter
    def axialForceUserFunction(self, value: Callable[[MainSystem, float, int, float, float, float, float, float, float, float, float, float], float] | Literal[0]) -> None: ...
    @property
    def bending_moment_user_function(self) -> Callable[[MainSystem, float, int, float, float, float, float, float, float, float, float, float], float] | Literal[0]:
        """function that gives the bending moment in place of the linear law"""
    @bending_moment_user_function.setter
    def bending_moment_user_function(self, value: Callable[[MainSystem, float, int, float, float, float, float, float, float, float, float, float], float] | Literal[0]) -> None: ...
    @property
    def bendingMomentUserFunction(self) -> Callable[[MainSystem, float, int, float, float, float, float, float, float, float, float, float], float] | Literal[0]:
        """function that gives the bending moment in place of the linear law"""
    @bendingMomentUserFunction.setter
    def bendingMomentUserFunction(self, value: Callable[[MainSystem, float, int, float, float, float, float, float, float, float, float, float], float] | Literal[0]) -> None: ...
    @property
    def position(self) -> Array:
        """global position of the local point [m]"""
    def position_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def displacement(self) -> Array:
        """global displacement of the local point [m]"""
    def displacement_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def velocity(self) -> Array:
        """global velocity of the local point [m/s]"""
    def velocity_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def velocity_local(self) -> Array:
        """velocity of the local point in the frame of the cross section [m/s]"""
    def velocity_local_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def rotation(self) -> float:
        """angle from the global x-axis to the slope vector, positive about z [rad]"""
    def rotation_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> float: ...
    @property
    def director1(self) -> Array:
        """slope vector of the axis; its length is 1 + axial strain [1]"""
    def director1_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def strain_local(self) -> float:
        """axial strain at the local point: that of the axis, minus the distance y from it times the curvature [1]"""
    def strain_local_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> float: ...
    @property
    def curvature_local(self) -> float:
        """material curvature of the axis; positive for a left turn along the axis [1/m]"""
    def curvature_local_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> float: ...
    @property
    def force_local(self) -> float:
        """axial force, positive for tension; oscillates along the element when bending dominates [N]"""
    def force_local_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> float: ...
    @property
    def torque_local(self) -> float:
        """bending moment, positive with positive curvature [Nm]"""
    def torque_local_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> float: ...
    @property
    def angular_velocity(self) -> Array:
        """angular velocity of the cross section; only the third component is not zero [rad/s]"""
    def angular_velocity_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def angular_velocity_local(self) -> Array:
        """the same vector, because the cross section rotates about z [rad/s]"""
    def angular_velocity_local_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def acceleration(self) -> Array:
        """global acceleration of the local point [m/s^2]"""
    def acceleration_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def angular_acceleration(self) -> Array:
        """angular acceleration of the cross section; only the third component is not zero [rad/s^2]"""
    def angular_acceleration_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def kinetic_energy(self) -> float:
        """kinetic energy of the whole body; the local position has no influence [J]"""
    @property
    def potential_energy(self) -> float:
        """energy of the strains; the local position has no influence, and loads are not included [J]"""

class ObjectANCFThinPlate(ObjectHandle):
    """Handle: thin plate without shear deformation, on four nodes with position and two slopes"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def physics_thickness(self) -> Array:
        """thickness of the plate: a value, or interpolated values of the nodes [n; m]"""
    @physics_thickness.setter
    def physics_thickness(self, value: ArrayLike) -> None: ...
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
    @property
    def physics_density(self) -> float:
        """mass per volume [kg/m^3]"""
    @physics_density.setter
    def physics_density(self, value: float) -> None: ...
    @property
    def physicsDensity(self) -> float:
        """mass per volume [kg/m^3]"""
    @physicsDensity.setter
    def physicsDensity(self, value: float) -> None: ...
    @property
    def density(self) -> float:
        """mass per volume [kg/m^3]"""
    @density.setter
    def density(self, value: float) -> None: ...
    @property
    def physics_mass_proportional_damping(self) -> float:
        """damping forces are this factor times mass matrix times velocity [1/s]"""
    @physics_mass_proportional_damping.setter
    def physics_mass_proportional_damping(self, value: float) -> None: ...
    @property
    def physicsMassProportionalDamping(self) -> float:
        """damping forces are this factor times mass matrix times velocity [1/s]"""
    @physicsMassProportionalDamping.setter
    def physicsMassProportionalDamping(self, value: float) -> None: ...
    @property
    def mass_proportional_damping(self) -> float:
        """damping forces are this factor times mass matrix times velocity [1/s]"""
    @mass_proportional_damping.setter
    def mass_proportional_damping(self, value: float) -> None: ...
    @property
    def massProportionalDamping(self) -> float:
        """damping forces are this factor times mass matrix times velocity [1/s]"""
    @massProportionalDamping.setter
    def massProportionalDamping(self, value: float) -> None: ...
    @property
    def physics_strain_coefficients(self) -> Matrix3DList:
        """stiffness against the strains in the plane, integrated over the thickness; a matrix, or one per node [n x 3 x 3; N/m]"""
    @physics_strain_coefficients.setter
    def physics_strain_coefficients(self, value: Sequence[ArrayLike] | Matrix3DList) -> None: ...
    @property
    def physicsStrainCoefficients(self) -> Matrix3DList:
        """stiffness against the strains in the plane, integrated over the thickness; a matrix, or one per node [n x 3 x 3; N/m]"""
    @physicsStrainCoefficients.setter
    def physicsStrainCoefficients(self, value: Sequence[ArrayLike] | Matrix3DList) -> None: ...
    @property
    def strain_coefficients(self) -> Matrix3DList:
        """stiffness against the strains in the plane, integrated over the thickness; a matrix, or one per node [n x 3 x 3; N/m]"""
    @strain_coefficients.setter
    def strain_coefficients(self, value: Sequence[ArrayLike] | Matrix3DList) -> None: ...
    @property
    def strainCoefficients(self) -> Matrix3DList:
        """stiffness against the strains in the plane, integrated over the thickness; a matrix, or one per node [n x 3 x 3; N/m]"""
    @strainCoefficients.setter
    def strainCoefficients(self, value: Sequence[ArrayLike] | Matrix3DList) -> None: ...
    @property
    def physics_curvature_coefficients(self) -> Matrix3DList:
        """stiffness against curvatures and twist, integrated over the thickness; a matrix, or one per node [n x 3 x 3; Nm]"""
    @physics_curvature_coefficients.setter
    def physics_curvature_coefficients(self, value: Sequence[ArrayLike] | Matrix3DList) -> None: ...
    @property
    def physicsCurvatureCoefficients(self) -> Matrix3DList:
        """stiffness against curvatures and twist, integrated over the thickness; a matrix, or one per node [n x 3 x 3; Nm]"""
    @physicsCurvatureCoefficients.setter
    def physicsCurvatureCoefficients(self, value: Sequence[ArrayLike] | Matrix3DList) -> None: ...
    @property
    def curvature_coefficients(self) -> Matrix3DList:
        """stiffness against curvatures and twist, integrated over the thickness; a matrix, or one per node [n x 3 x 3; Nm]"""
    @curvature_coefficients.setter
    def curvature_coefficients(self, value: Sequence[ArrayLike] | Matrix3DList) -> None: ...
    @property
    def curvatureCoefficients(self) -> Matrix3DList:
        """stiffness against curvatures and twist, integrated over the thickness; a matrix, or one per node [n x 3 x 3; Nm]"""
    @curvatureCoefficients.setter
    def curvatureCoefficients(self, value: Sequence[ArrayLike] | Matrix3DList) -> None: ...
    @property
    def strain_is_relative_to_reference(self) -> float:
        """share of the strains of the reference configuration that are free of stress: 0 for a plate that is flat without stress, 1 for a reference configuration without stress [1]"""
    @strain_is_relative_to_reference.setter
    def strain_is_relative_to_reference(self, value: float) -> None: ...
    @property
    def strainIsRelativeToReference(self) -> float:
        """share of the strains of the reference configuration that are free of stress: 0 for a plate that is flat without stress, 1 for a reference configuration without stress [1]"""
    @strainIsRelativeToReference.setter
    def strainIsRelativeToReference(self, value: float) -> None: ...
    @property
    def slopes_scaling_x(self) -> Array:
        """for each node the length of the side in x that belongs to a unit slope, the distance of the nodes for a flat rectangle; not positive: that distance [4; m]"""
    @slopes_scaling_x.setter
    def slopes_scaling_x(self, value: ArrayLike) -> None: ...
    @property
    def slopesScalingX(self) -> Array:
        """for each node the length of the side in x that belongs to a unit slope, the distance of the nodes for a flat rectangle; not positive: that distance [4; m]"""
    @slopesScalingX.setter
    def slopesScalingX(self, value: ArrayLike) -> None: ...
    @property
    def slopes_scaling_y(self) -> Array:
        """for each node the length of the side in y that belongs to a unit slope; not positive: the distance of the nodes [4; m]"""
    @slopes_scaling_y.setter
    def slopes_scaling_y(self, value: ArrayLike) -> None: ...
    @property
    def slopesScalingY(self) -> Array:
        """for each node the length of the side in y that belongs to a unit slope; not positive: the distance of the nodes [4; m]"""
    @slopesScalingY.setter
    def slopesScalingY(self, value: ArrayLike) -> None: ...
    @property
    def node_numbers(self) -> tuple[NodeHandle, ...]:
        """four nodes with position and two slopes, at the local corners (-1, -1), (1, -1), (1, 1), (-1, 1) [4]"""
    @node_numbers.setter
    def node_numbers(self, value: Sequence[NodeIndex | int | str]) -> None: ...
    @property
    def nodeNumbers(self) -> tuple[NodeHandle, ...]:
        """four nodes with position and two slopes, at the local corners (-1, -1), (1, -1), (1, 1), (-1, 1) [4]"""
    @nodeNumbers.setter
    def nodeNumbers(self, value: Sequence[NodeIndex | int | str]) -> None: ...
    @property
    def use_reduced_order_integration(self) -> int:
        """integration of the elastic forces: 0: 4 by 4 Gauss points, 1: 3 by 3"""
    @use_reduced_order_integration.setter
    def use_reduced_order_integration(self, value: int) -> None: ...
    @property
    def useReducedOrderIntegration(self) -> int:
        """integration of the elastic forces: 0: 4 by 4 Gauss points, 1: 3 by 3"""
    @useReducedOrderIntegration.setter
    def useReducedOrderIntegration(self, value: int) -> None: ...
    @property
    def stiffness_proportional_damping(self) -> float:
        """membrane forces of damping are this factor times membrane stiffness times strain rates [s]"""
    @stiffness_proportional_damping.setter
    def stiffness_proportional_damping(self, value: float) -> None: ...
    @property
    def stiffnessProportionalDamping(self) -> float:
        """membrane forces of damping are this factor times membrane stiffness times strain rates [s]"""
    @stiffnessProportionalDamping.setter
    def stiffnessProportionalDamping(self, value: float) -> None: ...
    @property
    def bending_stiffness_proportional_damping(self) -> float:
        """the same for bending stiffness and rates of curvature; negative: ``stiffnessProportionalDamping`` [s]"""
    @bending_stiffness_proportional_damping.setter
    def bending_stiffness_proportional_damping(self, value: float) -> None: ...
    @property
    def bendingStiffnessProportionalDamping(self) -> float:
        """the same for bending stiffness and rates of curvature; negative: ``stiffnessProportionalDamping`` [s]"""
    @bendingStiffnessProportionalDamping.setter
    def bendingStiffnessProportionalDamping(self, value: float) -> None: ...
    @property
    def position(self) -> Array:
        """global position of the local point; local coordinates run from -1 to 1, the third one over the thickness [m]"""
    def position_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def displacement(self) -> Array:
        """global displacement of the local point [m]"""
    def displacement_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def velocity(self) -> Array:
        """global velocity of the local point [m/s]"""
    def velocity_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def director1(self) -> Array:
        """slope vector in the first direction of the mid-surface [1]"""
    def director1_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def director2(self) -> Array:
        """slope vector in the second direction of the mid-surface [1]"""
    def director2_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def strain_local(self) -> Array:
        """strains of the mid-surface: two normal strains and the shear strain; strains without stress are subtracted [1]"""
    def strain_local_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def curvature_local(self) -> Array:
        """curvatures about the x and y axis, and twice the twist of the mid-surface; strains without stress are subtracted [1/m]"""
    def curvature_local_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def force_local(self) -> Array:
        """membrane forces per length, two normal forces and the shear force [N/m]"""
    def force_local_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def torque_local(self) -> Array:
        """moments per length, two bending moments and the twisting moment, of the curvatures along x and y [N]"""
    def torque_local_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def stress_local(self) -> Array:
        """stress components xx, yy, zz, yz, xz, xy at the local point; out-of-plane components are zero [N/m^2]"""
    def stress_local_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def acceleration(self) -> Array:
        """global acceleration of the local point [m/s^2]"""
    def acceleration_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def kinetic_energy(self) -> float:
        """kinetic energy of the whole body; the local position has no influence [J]"""
    @property
    def potential_energy(self) -> float:
        """energy of the strains; the local position has no influence, and loads are not included [J]"""

class ObjectBeamGeometricallyExact(ObjectHandle):
    """Handle: spatial geometrically exact beam with shear deformation, on two rigid body nodes"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def node_numbers(self) -> tuple[NodeHandle, ...]:
        """node at the negative and node at the positive end of the axis, both with position and orientation [2]"""
    @node_numbers.setter
    def node_numbers(self, value: Sequence[NodeIndex | int | str]) -> None: ...
    @property
    def nodeNumbers(self) -> tuple[NodeHandle, ...]:
        """node at the negative and node at the positive end of the axis, both with position and orientation [2]"""
    @nodeNumbers.setter
    def nodeNumbers(self, value: Sequence[NodeIndex | int | str]) -> None: ...
    @property
    def physics_length(self) -> float:
        """length of the element in its undeformed state; must be positive [m]"""
    @physics_length.setter
    def physics_length(self, value: float) -> None: ...
    @property
    def physicsLength(self) -> float:
        """length of the element in its undeformed state; must be positive [m]"""
    @physicsLength.setter
    def physicsLength(self, value: float) -> None: ...
    @property
    def length(self) -> float:
        """length of the element in its undeformed state; must be positive [m]"""
    @length.setter
    def length(self, value: float) -> None: ...
    @property
    def section_data(self) -> BeamSection:
        """cross section with inertia, stiffness and damping matrices, as a ``BeamSection``"""
    @section_data.setter
    def section_data(self, value: BeamSection) -> None: ...
    @property
    def sectionData(self) -> BeamSection:
        """cross section with inertia, stiffness and damping matrices, as a ``BeamSection``"""
    @sectionData.setter
    def sectionData(self, value: BeamSection) -> None: ...
    @property
    def position(self) -> Array:
        """global position of the local point [m]"""
    def position_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def displacement(self) -> Array:
        """global displacement of the local point [m]"""
    def displacement_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def velocity(self) -> Array:
        """global velocity of the local point [m/s]"""
    def velocity_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def rotation(self) -> Array:
        """Tait-Bryan angles of the frame of the cross section [rad]"""
    def rotation_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def strain_local(self) -> Array:
        """strains in the frame of the cross section: xx, yy, zz, yz, xz, xy, of which xx, xz and xy can differ from zero [1]"""
    def strain_local_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def curvature_local(self) -> Array:
        """twist and the two curvatures in the frame of the cross section [1/m]"""
    def curvature_local_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def rotation_matrix(self) -> Array:
        """rotation matrix from the frame of the cross section to the global frame, row by row [1]"""
    def rotation_matrix_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def angular_velocity(self) -> Array:
        """global angular velocity of the cross section [rad/s]"""
    def angular_velocity_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def angular_velocity_local(self) -> Array:
        """angular velocity of the cross section in its own frame [rad/s]"""
    def angular_velocity_local_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def force_local(self) -> Array:
        """axial force and the two shear forces in the frame of the cross section [N]"""
    def force_local_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def torque_local(self) -> Array:
        """torsional moment and the two bending moments in the frame of the cross section [Nm]"""
    def torque_local_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def homogeneous_transformation(self) -> HT:
        """position and rotation as a 4 x 4 matrix, row by row; output functions return ``exu.HT`` [various]"""
    def homogeneous_transformation_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> HT: ...
    @property
    def kinetic_energy(self) -> float:
        """kinetic energy of the whole body; the local position has no influence [J]"""
    @property
    def potential_energy(self) -> float:
        """energy of the strains; the local position has no influence, and loads are not included [J]"""

class ObjectBeamGeometricallyExact2D(ObjectHandle):
    """Handle: planar geometrically exact beam with shear deformation, on two or three rigid body nodes"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def node_numbers(self) -> tuple[NodeHandle, ...]:
        """two or three nodes of rigid bodies in the plane, in the order in which they follow along the axis [n]"""
    @node_numbers.setter
    def node_numbers(self, value: Sequence[NodeIndex | int | str]) -> None: ...
    @property
    def nodeNumbers(self) -> tuple[NodeHandle, ...]:
        """two or three nodes of rigid bodies in the plane, in the order in which they follow along the axis [n]"""
    @nodeNumbers.setter
    def nodeNumbers(self, value: Sequence[NodeIndex | int | str]) -> None: ...
    @property
    def physics_length(self) -> float:
        """length of the element in its undeformed state; must be positive [m]"""
    @physics_length.setter
    def physics_length(self, value: float) -> None: ...
    @property
    def physicsLength(self) -> float:
        """length of the element in its undeformed state; must be positive [m]"""
    @physicsLength.setter
    def physicsLength(self, value: float) -> None: ...
    @property
    def length(self) -> float:
        """length of the element in its undeformed state; must be positive [m]"""
    @length.setter
    def length(self, value: float) -> None: ...
    @property
    def physics_mass_per_length(self) -> float:
        """mass per undeformed length [kg/m]"""
    @physics_mass_per_length.setter
    def physics_mass_per_length(self, value: float) -> None: ...
    @property
    def physicsMassPerLength(self) -> float:
        """mass per undeformed length [kg/m]"""
    @physicsMassPerLength.setter
    def physicsMassPerLength(self, value: float) -> None: ...
    @property
    def mass_per_length(self) -> float:
        """mass per undeformed length [kg/m]"""
    @mass_per_length.setter
    def mass_per_length(self, value: float) -> None: ...
    @property
    def massPerLength(self) -> float:
        """mass per undeformed length [kg/m]"""
    @massPerLength.setter
    def massPerLength(self, value: float) -> None: ...
    @property
    def physics_cross_section_inertia(self) -> float:
        """mass moment of inertia of the cross section per length, against its rotation [kg m]"""
    @physics_cross_section_inertia.setter
    def physics_cross_section_inertia(self, value: float) -> None: ...
    @property
    def physicsCrossSectionInertia(self) -> float:
        """mass moment of inertia of the cross section per length, against its rotation [kg m]"""
    @physicsCrossSectionInertia.setter
    def physicsCrossSectionInertia(self, value: float) -> None: ...
    @property
    def cross_section_inertia(self) -> float:
        """mass moment of inertia of the cross section per length, against its rotation [kg m]"""
    @cross_section_inertia.setter
    def cross_section_inertia(self, value: float) -> None: ...
    @property
    def crossSectionInertia(self) -> float:
        """mass moment of inertia of the cross section per length, against its rotation [kg m]"""
    @crossSectionInertia.setter
    def crossSectionInertia(self, value: float) -> None: ...
    @property
    def physics_bending_stiffness(self) -> float:
        """bending stiffness: bending moment per curvature [N m^2]"""
    @physics_bending_stiffness.setter
    def physics_bending_stiffness(self, value: float) -> None: ...
    @property
    def physicsBendingStiffness(self) -> float:
        """bending stiffness: bending moment per curvature [N m^2]"""
    @physicsBendingStiffness.setter
    def physicsBendingStiffness(self, value: float) -> None: ...
    @property
    def bending_stiffness(self) -> float:
        """bending stiffness: bending moment per curvature [N m^2]"""
    @bending_stiffness.setter
    def bending_stiffness(self, value: float) -> None: ...
    @property
    def bendingStiffness(self) -> float:
        """bending stiffness: bending moment per curvature [N m^2]"""
    @bendingStiffness.setter
    def bendingStiffness(self, value: float) -> None: ...
    @property
    def physics_axial_stiffness(self) -> float:
        """axial stiffness: axial force per axial strain [N]"""
    @physics_axial_stiffness.setter
    def physics_axial_stiffness(self, value: float) -> None: ...
    @property
    def physicsAxialStiffness(self) -> float:
        """axial stiffness: axial force per axial strain [N]"""
    @physicsAxialStiffness.setter
    def physicsAxialStiffness(self, value: float) -> None: ...
    @property
    def axial_stiffness(self) -> float:
        """axial stiffness: axial force per axial strain [N]"""
    @axial_stiffness.setter
    def axial_stiffness(self, value: float) -> None: ...
    @property
    def axialStiffness(self) -> float:
        """axial stiffness: axial force per axial strain [N]"""
    @axialStiffness.setter
    def axialStiffness(self, value: float) -> None: ...
    @property
    def physics_shear_stiffness(self) -> float:
        """shear stiffness, including the shear correction factor [N]"""
    @physics_shear_stiffness.setter
    def physics_shear_stiffness(self, value: float) -> None: ...
    @property
    def physicsShearStiffness(self) -> float:
        """shear stiffness, including the shear correction factor [N]"""
    @physicsShearStiffness.setter
    def physicsShearStiffness(self, value: float) -> None: ...
    @property
    def shear_stiffness(self) -> float:
        """shear stiffness, including the shear correction factor [N]"""
    @shear_stiffness.setter
    def shear_stiffness(self, value: float) -> None: ...
    @property
    def shearStiffness(self) -> float:
        """shear stiffness, including the shear correction factor [N]"""
    @shearStiffness.setter
    def shearStiffness(self, value: float) -> None: ...
    @property
    def physics_bending_damping(self) -> float:
        """viscous damping of bending: bending moment per rate of curvature [N m^2 s]"""
    @physics_bending_damping.setter
    def physics_bending_damping(self, value: float) -> None: ...
    @property
    def physicsBendingDamping(self) -> float:
        """viscous damping of bending: bending moment per rate of curvature [N m^2 s]"""
    @physicsBendingDamping.setter
    def physicsBendingDamping(self, value: float) -> None: ...
    @property
    def bending_damping(self) -> float:
        """viscous damping of bending: bending moment per rate of curvature [N m^2 s]"""
    @bending_damping.setter
    def bending_damping(self, value: float) -> None: ...
    @property
    def bendingDamping(self) -> float:
        """viscous damping of bending: bending moment per rate of curvature [N m^2 s]"""
    @bendingDamping.setter
    def bendingDamping(self, value: float) -> None: ...
    @property
    def physics_axial_damping(self) -> float:
        """viscous damping of stretching: axial force per rate of axial strain [N s]"""
    @physics_axial_damping.setter
    def physics_axial_damping(self, value: float) -> None: ...
    @property
    def physicsAxialDamping(self) -> float:
        """viscous damping of stretching: axial force per rate of axial strain [N s]"""
    @physicsAxialDamping.setter
    def physicsAxialDamping(self, value: float) -> None: ...
    @property
    def axial_damping(self) -> float:
        """viscous damping of stretching: axial force per rate of axial strain [N s]"""
    @axial_damping.setter
    def axial_damping(self, value: float) -> None: ...
    @property
    def axialDamping(self) -> float:
        """viscous damping of stretching: axial force per rate of axial strain [N s]"""
    @axialDamping.setter
    def axialDamping(self, value: float) -> None: ...
    @property
    def physics_shear_damping(self) -> float:
        """viscous damping of shear: shear force per rate of shear strain [N s]"""
    @physics_shear_damping.setter
    def physics_shear_damping(self, value: float) -> None: ...
    @property
    def physicsShearDamping(self) -> float:
        """viscous damping of shear: shear force per rate of shear strain [N s]"""
    @physicsShearDamping.setter
    def physicsShearDamping(self, value: float) -> None: ...
    @property
    def shear_damping(self) -> float:
        """viscous damping of shear: shear force per rate of shear strain [N s]"""
    @shear_damping.setter
    def shear_damping(self, value: float) -> None: ...
    @property
    def shearDamping(self) -> float:
        """viscous damping of shear: shear force per rate of shear strain [N s]"""
    @shearDamping.setter
    def shearDamping(self, value: float) -> None: ...
    @property
    def physics_reference_curvature(self) -> float:
        """curvature at which the bending moment is zero [1/m]"""
    @physics_reference_curvature.setter
    def physics_reference_curvature(self, value: float) -> None: ...
    @property
    def physicsReferenceCurvature(self) -> float:
        """curvature at which the bending moment is zero [1/m]"""
    @physicsReferenceCurvature.setter
    def physicsReferenceCurvature(self, value: float) -> None: ...
    @property
    def reference_curvature(self) -> float:
        """curvature at which the bending moment is zero [1/m]"""
    @reference_curvature.setter
    def reference_curvature(self, value: float) -> None: ...
    @property
    def referenceCurvature(self) -> float:
        """curvature at which the bending moment is zero [1/m]"""
    @referenceCurvature.setter
    def referenceCurvature(self, value: float) -> None: ...
    @property
    def include_reference_rotations(self) -> bool:
        """true: the reference angles of the nodes are the angles of the cross sections; false: only rotations relative to the reference configuration count, and the cross sections are normal to the reference axis"""
    @include_reference_rotations.setter
    def include_reference_rotations(self, value: bool) -> None: ...
    @property
    def includeReferenceRotations(self) -> bool:
        """true: the reference angles of the nodes are the angles of the cross sections; false: only rotations relative to the reference configuration count, and the cross sections are normal to the reference axis"""
    @includeReferenceRotations.setter
    def includeReferenceRotations(self, value: bool) -> None: ...
    @property
    def position(self) -> Array:
        """global position of the local point [m]"""
    def position_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def displacement(self) -> Array:
        """global displacement of the local point [m]"""
    def displacement_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def velocity(self) -> Array:
        """global velocity of the local point [m/s]"""
    def velocity_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def rotation(self) -> Array:
        """only the third component is not zero: the angle of the cross section about z [rad]"""
    def rotation_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def strain_local(self) -> Array:
        """strains of the axis: axial strain first, shear strain last; the others are zero [1]"""
    def strain_local_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def curvature_local(self) -> Array:
        """only the third component is not zero: the curvature that moments act against [1/m]"""
    def curvature_local_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def force_local(self) -> Array:
        """axial force, shear force, zero; in the frame of the cross section [N]"""
    def force_local_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def torque_local(self) -> Array:
        """only the third component is not zero: the bending moment [Nm]"""
    def torque_local_at(
        self, local_position: ArrayLike, configuration: str | ConfigurationType = "current"
    ) -> Array: ...
    @property
    def kinetic_energy(self) -> float:
        """kinetic energy of the whole body; the local position has no influence [J]"""
    @property
    def potential_energy(self) -> float:
        """energy of the strains; the local position has no influence, and loads are not included [J]"""

class ObjectConnectorCartesianSpringDamper(ObjectHandle):
    """Handle: Three springs and dampers that act between two points in the directions of the global axes"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def marker_numbers(self) -> tuple[MarkerHandle, ...]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @marker_numbers.setter
    def marker_numbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def markerNumbers(self) -> tuple[MarkerHandle, ...]:
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
    @property
    def spring_force_user_function(self) -> Callable[[MainSystem, float, int, Array, Array, Array, Array, Array], ArrayLike] | Literal[0]:
        """Python function that replaces the linear law of springs and dampers; called only while the connector is active"""
    @spring_force_user_function.setter
    def spring_force_user_function(self, value: Callable[[MainSystem, float, int, Array, Array, Array, Array, Array], ArrayLike] | Literal[0]) -> None: ...
    @property
    def springForceUserFunction(self) -> Callable[[MainSystem, float, int, Array, Array, Array, Array, Array], ArrayLike] | Literal[0]:
        """Python function that replaces the linear law of springs and dampers; called only while the connector is active"""
    @springForceUserFunction.setter
    def springForceUserFunction(self, value: Callable[[MainSystem, float, int, Array, Array, Array, Array, Array], ArrayLike] | Literal[0]) -> None: ...
    @property
    def active_connector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @active_connector.setter
    def active_connector(self, value: bool) -> None: ...
    @property
    def activeConnector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @activeConnector.setter
    def activeConnector(self, value: bool) -> None: ...
    @property
    def displacement(self) -> Array:
        """global position of marker m1 relative to marker m0, minus ``offset`` [m]"""
    @property
    def distance(self) -> float:
        """length of that displacement, so zero where the springs carry no force [m]"""
    @property
    def velocity(self) -> Array:
        """global velocity of marker m1 relative to marker m0 [m/s]"""
    @property
    def force(self) -> Array:
        """global force vector that acts on marker m0; its negative acts on marker m1 [N]"""
    @property
    def potential_energy(self) -> float:
        """energy of spring and constant force, zero where the spring is relaxed; not available with a user function [J]"""
    def force_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """force on one of the two bodies or markers, in global axes [3; N]"""
    def torque_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """torque on one of the two bodies or markers, in global axes [3; Nm]"""

class ObjectConnectorCoordinateSpringDamper(ObjectHandle):
    """Handle: A scalar spring and damper between two coordinates"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def marker_numbers(self) -> tuple[MarkerHandle, ...]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @marker_numbers.setter
    def marker_numbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def markerNumbers(self) -> tuple[MarkerHandle, ...]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def stiffness(self) -> float:
        """stiffness; N/m for coordinates that are lengths, Nm/rad for angles [various]"""
    @stiffness.setter
    def stiffness(self, value: float) -> None: ...
    @property
    def damping(self) -> float:
        """damping coefficient; Ns/m for coordinates that are lengths, Nms/rad for angles [various]"""
    @damping.setter
    def damping(self, value: float) -> None: ...
    @property
    def offset(self) -> float:
        """difference of the coordinates at which the spring carries no force; unit of the coordinates [various]"""
    @offset.setter
    def offset(self, value: float) -> None: ...
    @property
    def active_connector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @active_connector.setter
    def active_connector(self, value: bool) -> None: ...
    @property
    def activeConnector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @activeConnector.setter
    def activeConnector(self, value: bool) -> None: ...
    @property
    def spring_force_user_function(self) -> Callable[[MainSystem, float, int, float, float, float, float, float], float] | Literal[0]:
        """Python function that replaces the law of spring and damper; called only while the connector is active"""
    @spring_force_user_function.setter
    def spring_force_user_function(self, value: Callable[[MainSystem, float, int, float, float, float, float, float], float] | Literal[0]) -> None: ...
    @property
    def springForceUserFunction(self) -> Callable[[MainSystem, float, int, float, float, float, float, float], float] | Literal[0]:
        """Python function that replaces the law of spring and damper; called only while the connector is active"""
    @springForceUserFunction.setter
    def springForceUserFunction(self, value: Callable[[MainSystem, float, int, float, float, float, float, float], float] | Literal[0]) -> None: ...
    @property
    def displacement(self) -> float:
        """difference of the marker coordinates, not reduced by ``offset`` [various]"""
    @property
    def velocity(self) -> float:
        """difference of the marker velocity coordinates [various]"""
    @property
    def force(self) -> float:
        """generalized force of spring and damper, positive if it draws the coordinates together after extension [various]"""
    @property
    def potential_energy(self) -> float:
        """energy of spring and constant force, zero where the spring is relaxed; not available with a user function [J]"""
    def force_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """force on one of the two bodies or markers, in global axes [3; N]"""
    def torque_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """torque on one of the two bodies or markers, in global axes [3; Nm]"""

class ObjectConnectorCoordinateSpringDamperExt(ObjectHandle):
    """Handle: A scalar spring and damper between two coordinates, with gear factors, friction and limit stops"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def marker_numbers(self) -> tuple[MarkerHandle, ...]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @marker_numbers.setter
    def marker_numbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def markerNumbers(self) -> tuple[MarkerHandle, ...]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def node_number(self) -> NodeHandle:
        """NodeGenericData with three data coordinates: friction state, last sticking position, limit stop state; needed for friction with ``frictionProportionalZone`` = 0 and for limit stops, else it may stay unset"""
    @node_number.setter
    def node_number(self, value: NodeIndex | int | str) -> None: ...
    @property
    def nodeNumber(self) -> NodeHandle:
        """NodeGenericData with three data coordinates: friction state, last sticking position, limit stop state; needed for friction with ``frictionProportionalZone`` = 0 and for limit stops, else it may stay unset"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    @property
    def stiffness(self) -> float:
        """stiffness; N/m if the weighted coordinates are lengths, Nm/rad if they are angles; other units of this item follow in the same way [various]"""
    @stiffness.setter
    def stiffness(self, value: float) -> None: ...
    @property
    def damping(self) -> float:
        """damping coefficient; Ns/m for lengths [various]"""
    @damping.setter
    def damping(self, value: float) -> None: ...
    @property
    def offset(self) -> float:
        """weighted difference of the coordinates at which the spring carries no force; m for lengths; may serve as the set value of a position control [various]"""
    @offset.setter
    def offset(self, value: float) -> None: ...
    @property
    def velocity_offset(self) -> float:
        """weighted difference of the velocities at which the damper carries no force; m/s for lengths; may serve as the set value of a velocity control [various]"""
    @velocity_offset.setter
    def velocity_offset(self, value: float) -> None: ...
    @property
    def velocityOffset(self) -> float:
        """weighted difference of the velocities at which the damper carries no force; m/s for lengths; may serve as the set value of a velocity control [various]"""
    @velocityOffset.setter
    def velocityOffset(self, value: float) -> None: ...
    @property
    def factor0(self) -> float:
        """factor of the coordinate of marker m0, such as a gear ratio [1]"""
    @factor0.setter
    def factor0(self, value: float) -> None: ...
    @property
    def factor1(self) -> float:
        """factor of the coordinate of marker m1 [1]"""
    @factor1.setter
    def factor1(self, value: float) -> None: ...
    @property
    def f_dynamic_friction(self) -> float:
        """friction force in sliding, N for lengths: friction coefficient times a constant normal force [various]"""
    @f_dynamic_friction.setter
    def f_dynamic_friction(self, value: float) -> None: ...
    @property
    def fDynamicFriction(self) -> float:
        """friction force in sliding, N for lengths: friction coefficient times a constant normal force [various]"""
    @fDynamicFriction.setter
    def fDynamicFriction(self, value: float) -> None: ...
    @property
    def dynamic_friction_force(self) -> float:
        """friction force in sliding, N for lengths: friction coefficient times a constant normal force [various]"""
    @dynamic_friction_force.setter
    def dynamic_friction_force(self, value: float) -> None: ...
    @property
    def dynamicFrictionForce(self) -> float:
        """friction force in sliding, N for lengths: friction coefficient times a constant normal force [various]"""
    @dynamicFrictionForce.setter
    def dynamicFrictionForce(self, value: float) -> None: ...
    @property
    def f_static_friction_offset(self) -> float:
        """difference of the largest static and the dynamic friction force, N for lengths; sticking ends at the sum of both [various]"""
    @f_static_friction_offset.setter
    def f_static_friction_offset(self, value: float) -> None: ...
    @property
    def fStaticFrictionOffset(self) -> float:
        """difference of the largest static and the dynamic friction force, N for lengths; sticking ends at the sum of both [various]"""
    @fStaticFrictionOffset.setter
    def fStaticFrictionOffset(self, value: float) -> None: ...
    @property
    def static_friction_offset_force(self) -> float:
        """difference of the largest static and the dynamic friction force, N for lengths; sticking ends at the sum of both [various]"""
    @static_friction_offset_force.setter
    def static_friction_offset_force(self, value: float) -> None: ...
    @property
    def staticFrictionOffsetForce(self) -> float:
        """difference of the largest static and the dynamic friction force, N for lengths; sticking ends at the sum of both [various]"""
    @staticFrictionOffsetForce.setter
    def staticFrictionOffsetForce(self, value: float) -> None: ...
    @property
    def sticking_stiffness(self) -> float:
        """stiffness of the bristles in sticking, N/m for lengths; must be positive for friction with ``frictionProportionalZone`` = 0 [various]"""
    @sticking_stiffness.setter
    def sticking_stiffness(self, value: float) -> None: ...
    @property
    def stickingStiffness(self) -> float:
        """stiffness of the bristles in sticking, N/m for lengths; must be positive for friction with ``frictionProportionalZone`` = 0 [various]"""
    @stickingStiffness.setter
    def stickingStiffness(self, value: float) -> None: ...
    @property
    def sticking_damping(self) -> float:
        """damping coefficient of the bristles in sticking, Ns/m for lengths [various]"""
    @sticking_damping.setter
    def sticking_damping(self, value: float) -> None: ...
    @property
    def stickingDamping(self) -> float:
        """damping coefficient of the bristles in sticking, Ns/m for lengths [various]"""
    @stickingDamping.setter
    def stickingDamping(self, value: float) -> None: ...
    @property
    def exponential_decay_static(self) -> float:
        """speed by which the static offset falls to 1/e = 36.8 % of its value, m/s for lengths [various]"""
    @exponential_decay_static.setter
    def exponential_decay_static(self, value: float) -> None: ...
    @property
    def exponentialDecayStatic(self) -> float:
        """speed by which the static offset falls to 1/e = 36.8 % of its value, m/s for lengths [various]"""
    @exponentialDecayStatic.setter
    def exponentialDecayStatic(self, value: float) -> None: ...
    @property
    def f_viscous_friction(self) -> float:
        """growth of the friction force with the speed of sliding, Ns/m for lengths; may be negative [various]"""
    @f_viscous_friction.setter
    def f_viscous_friction(self, value: float) -> None: ...
    @property
    def fViscousFriction(self) -> float:
        """growth of the friction force with the speed of sliding, Ns/m for lengths; may be negative [various]"""
    @fViscousFriction.setter
    def fViscousFriction(self, value: float) -> None: ...
    @property
    def viscous_friction_factor(self) -> float:
        """growth of the friction force with the speed of sliding, Ns/m for lengths; may be negative [various]"""
    @viscous_friction_factor.setter
    def viscous_friction_factor(self, value: float) -> None: ...
    @property
    def viscousFrictionFactor(self) -> float:
        """growth of the friction force with the speed of sliding, Ns/m for lengths; may be negative [various]"""
    @viscousFrictionFactor.setter
    def viscousFrictionFactor(self, value: float) -> None: ...
    @property
    def friction_proportional_zone(self) -> float:
        """speed up to which friction is proportional to velocity, m/s for lengths; 0: bristle model with stick and slip, which needs the data node [various]"""
    @friction_proportional_zone.setter
    def friction_proportional_zone(self, value: float) -> None: ...
    @property
    def frictionProportionalZone(self) -> float:
        """speed up to which friction is proportional to velocity, m/s for lengths; 0: bristle model with stick and slip, which needs the data node [various]"""
    @frictionProportionalZone.setter
    def frictionProportionalZone(self, value: float) -> None: ...
    @property
    def limit_stops_upper(self) -> float:
        """upper limit of the weighted difference of coordinates, m for lengths; the upper stop acts above it [various]"""
    @limit_stops_upper.setter
    def limit_stops_upper(self, value: float) -> None: ...
    @property
    def limitStopsUpper(self) -> float:
        """upper limit of the weighted difference of coordinates, m for lengths; the upper stop acts above it [various]"""
    @limitStopsUpper.setter
    def limitStopsUpper(self, value: float) -> None: ...
    @property
    def limit_stops_lower(self) -> float:
        """lower limit of the weighted difference of coordinates, m for lengths; the lower stop acts below it [various]"""
    @limit_stops_lower.setter
    def limit_stops_lower(self, value: float) -> None: ...
    @property
    def limitStopsLower(self) -> float:
        """lower limit of the weighted difference of coordinates, m for lengths; the lower stop acts below it [various]"""
    @limitStopsLower.setter
    def limitStopsLower(self, value: float) -> None: ...
    @property
    def limit_stops_stiffness(self) -> float:
        """contact stiffness of the stops, N/m for lengths [various]"""
    @limit_stops_stiffness.setter
    def limit_stops_stiffness(self, value: float) -> None: ...
    @property
    def limitStopsStiffness(self) -> float:
        """contact stiffness of the stops, N/m for lengths [various]"""
    @limitStopsStiffness.setter
    def limitStopsStiffness(self, value: float) -> None: ...
    @property
    def limit_stops_damping(self) -> float:
        """contact damping of the stops, Ns/m for lengths [various]"""
    @limit_stops_damping.setter
    def limit_stops_damping(self, value: float) -> None: ...
    @property
    def limitStopsDamping(self) -> float:
        """contact damping of the stops, Ns/m for lengths [various]"""
    @limitStopsDamping.setter
    def limitStopsDamping(self, value: float) -> None: ...
    @property
    def use_limit_stops(self) -> bool:
        """True: limit stops are active, and the data node is needed"""
    @use_limit_stops.setter
    def use_limit_stops(self, value: bool) -> None: ...
    @property
    def useLimitStops(self) -> bool:
        """True: limit stops are active, and the data node is needed"""
    @useLimitStops.setter
    def useLimitStops(self, value: bool) -> None: ...
    @property
    def active_connector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @active_connector.setter
    def active_connector(self, value: bool) -> None: ...
    @property
    def activeConnector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @activeConnector.setter
    def activeConnector(self, value: bool) -> None: ...
    @property
    def spring_force_user_function(self) -> Callable[[MainSystem, float, int, float, float, float, float, float, float, float, float, float, float, float], float] | Literal[0]:
        """Python function that replaces spring, damper, friction and limit stops altogether; called only while the connector is active"""
    @spring_force_user_function.setter
    def spring_force_user_function(self, value: Callable[[MainSystem, float, int, float, float, float, float, float, float, float, float, float, float, float], float] | Literal[0]) -> None: ...
    @property
    def springForceUserFunction(self) -> Callable[[MainSystem, float, int, float, float, float, float, float, float, float, float, float, float, float], float] | Literal[0]:
        """Python function that replaces spring, damper, friction and limit stops altogether; called only while the connector is active"""
    @springForceUserFunction.setter
    def springForceUserFunction(self, value: Callable[[MainSystem, float, int, float, float, float, float, float, float, float, float, float, float, float], float] | Literal[0]) -> None: ...
    @property
    def displacement(self) -> float:
        """weighted difference of the marker coordinates, not reduced by ``offset`` [various]"""
    @property
    def velocity(self) -> float:
        """weighted difference of the marker velocity coordinates [various]"""
    @property
    def force(self) -> float:
        """total generalized force, with friction and limit stops [various]"""
    def force_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """force on one of the two bodies or markers, in global axes [3; N]"""
    def torque_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """torque on one of the two bodies or markers, in global axes [3; Nm]"""

class ObjectConnectorGravity(ObjectHandle):
    """Handle: Newtonian gravitation between two masses, for celestial bodies and satellites; the weight on earth is LoadMassProportional"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def marker_numbers(self) -> tuple[MarkerHandle, ...]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @marker_numbers.setter
    def marker_numbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def markerNumbers(self) -> tuple[MarkerHandle, ...]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def gravitational_constant(self) -> float:
        """constant of gravitation; a negative value means repulsion [m^3/(kg s^2)]"""
    @gravitational_constant.setter
    def gravitational_constant(self, value: float) -> None: ...
    @property
    def gravitationalConstant(self) -> float:
        """constant of gravitation; a negative value means repulsion [m^3/(kg s^2)]"""
    @gravitationalConstant.setter
    def gravitationalConstant(self, value: float) -> None: ...
    @property
    def mass0(self) -> float:
        """mass that attracts at marker m0; not taken from the body [kg]"""
    @mass0.setter
    def mass0(self, value: float) -> None: ...
    @property
    def mass1(self) -> float:
        """mass that attracts at marker m1; not taken from the body [kg]"""
    @mass1.setter
    def mass1(self, value: float) -> None: ...
    @property
    def min_distance_regularization(self) -> float:
        """distance below which the force is regularized; 0: no regularization, and coinciding markers are an error [m]"""
    @min_distance_regularization.setter
    def min_distance_regularization(self, value: float) -> None: ...
    @property
    def minDistanceRegularization(self) -> float:
        """distance below which the force is regularized; 0: no regularization, and coinciding markers are an error [m]"""
    @minDistanceRegularization.setter
    def minDistanceRegularization(self, value: float) -> None: ...
    @property
    def active_connector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @active_connector.setter
    def active_connector(self, value: bool) -> None: ...
    @property
    def activeConnector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @activeConnector.setter
    def activeConnector(self, value: bool) -> None: ...
    @property
    def distance(self) -> float:
        """distance of the markers [m]"""
    @property
    def displacement(self) -> Array:
        """global vector from marker m0 to marker m1 [m]"""
    @property
    def force(self) -> Array:
        """global force on marker m0, towards marker m1; its negative acts on marker m1 [N]"""
    @property
    def potential_energy(self) -> float:
        """energy of the attraction, zero at infinite distance [J]"""
    def force_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """force on one of the two bodies or markers, in global axes [3; N]"""
    def torque_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """torque on one of the two bodies or markers, in global axes [3; Nm]"""

class ObjectConnectorHydraulicActuatorSimple(ObjectHandle):
    """Handle: A double-acting hydraulic cylinder between two points, with the build-up of pressure in both chambers"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def marker_numbers(self) -> tuple[MarkerHandle, ...]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @marker_numbers.setter
    def marker_numbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def markerNumbers(self) -> tuple[MarkerHandle, ...]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def node_numbers(self) -> tuple[NodeHandle, ...]:
        """list with one NodeGenericODE1 whose two coordinates are the chamber pressures (Pa); its reference coordinates must be zero [n]"""
    @node_numbers.setter
    def node_numbers(self, value: Sequence[NodeIndex | int | str]) -> None: ...
    @property
    def nodeNumbers(self) -> tuple[NodeHandle, ...]:
        """list with one NodeGenericODE1 whose two coordinates are the chamber pressures (Pa); its reference coordinates must be zero [n]"""
    @nodeNumbers.setter
    def nodeNumbers(self, value: Sequence[NodeIndex | int | str]) -> None: ...
    @property
    def offset_length(self) -> float:
        """distance of the markers at stroke zero, the shortest length of the actuator [m]"""
    @offset_length.setter
    def offset_length(self, value: float) -> None: ...
    @property
    def offsetLength(self) -> float:
        """distance of the markers at stroke zero, the shortest length of the actuator [m]"""
    @offsetLength.setter
    def offsetLength(self, value: float) -> None: ...
    @property
    def stroke_length(self) -> float:
        """largest stroke; the markers are ``offsetLength`` plus ``strokeLength`` apart in the fully extended actuator [m]"""
    @stroke_length.setter
    def stroke_length(self, value: float) -> None: ...
    @property
    def strokeLength(self) -> float:
        """largest stroke; the markers are ``offsetLength`` plus ``strokeLength`` apart in the fully extended actuator [m]"""
    @strokeLength.setter
    def strokeLength(self, value: float) -> None: ...
    @property
    def chamber_cross_section0(self) -> float:
        """area of the piston in chamber 0, on the side of the piston head [m^2]"""
    @chamber_cross_section0.setter
    def chamber_cross_section0(self, value: float) -> None: ...
    @property
    def chamberCrossSection0(self) -> float:
        """area of the piston in chamber 0, on the side of the piston head [m^2]"""
    @chamberCrossSection0.setter
    def chamberCrossSection0(self, value: float) -> None: ...
    @property
    def chamber_cross_section1(self) -> float:
        """area of the piston in chamber 1, on the side of the rod; usually smaller [m^2]"""
    @chamber_cross_section1.setter
    def chamber_cross_section1(self, value: float) -> None: ...
    @property
    def chamberCrossSection1(self) -> float:
        """area of the piston in chamber 1, on the side of the rod; usually smaller [m^2]"""
    @chamberCrossSection1.setter
    def chamberCrossSection1(self, value: float) -> None: ...
    @property
    def hose_volume0(self) -> float:
        """volume of the hose of chamber 0; must be positive, as the stiffness of the oil would be unbounded at stroke zero [m^3]"""
    @hose_volume0.setter
    def hose_volume0(self, value: float) -> None: ...
    @property
    def hoseVolume0(self) -> float:
        """volume of the hose of chamber 0; must be positive, as the stiffness of the oil would be unbounded at stroke zero [m^3]"""
    @hoseVolume0.setter
    def hoseVolume0(self, value: float) -> None: ...
    @property
    def hose_volume1(self) -> float:
        """volume of the hose of chamber 1; must be positive, as the stiffness of the oil would be unbounded at full stroke [m^3]"""
    @hose_volume1.setter
    def hose_volume1(self, value: float) -> None: ...
    @property
    def hoseVolume1(self) -> float:
        """volume of the hose of chamber 1; must be positive, as the stiffness of the oil would be unbounded at full stroke [m^3]"""
    @hoseVolume1.setter
    def hoseVolume1(self, value: float) -> None: ...
    @property
    def valve_opening0(self) -> float:
        """opening of the valve of chamber 0, from -1 to 1: positive towards system pressure, negative towards tank pressure, 0 closed; changed during a simulation to control the actuator [1]"""
    @valve_opening0.setter
    def valve_opening0(self, value: float) -> None: ...
    @property
    def valveOpening0(self) -> float:
        """opening of the valve of chamber 0, from -1 to 1: positive towards system pressure, negative towards tank pressure, 0 closed; changed during a simulation to control the actuator [1]"""
    @valveOpening0.setter
    def valveOpening0(self, value: float) -> None: ...
    @property
    def valve_opening1(self) -> float:
        """opening of the valve of chamber 1, with the same meaning [1]"""
    @valve_opening1.setter
    def valve_opening1(self, value: float) -> None: ...
    @property
    def valveOpening1(self) -> float:
        """opening of the valve of chamber 1, with the same meaning [1]"""
    @valveOpening1.setter
    def valveOpening1(self, value: float) -> None: ...
    @property
    def actuator_damping(self) -> float:
        """viscous damping against the stroke velocity [Ns/m]"""
    @actuator_damping.setter
    def actuator_damping(self, value: float) -> None: ...
    @property
    def actuatorDamping(self) -> float:
        """viscous damping against the stroke velocity [Ns/m]"""
    @actuatorDamping.setter
    def actuatorDamping(self, value: float) -> None: ...
    @property
    def oil_bulk_modulus(self) -> float:
        """bulk modulus of the oil [Pa]"""
    @oil_bulk_modulus.setter
    def oil_bulk_modulus(self, value: float) -> None: ...
    @property
    def oilBulkModulus(self) -> float:
        """bulk modulus of the oil [Pa]"""
    @oilBulkModulus.setter
    def oilBulkModulus(self, value: float) -> None: ...
    @property
    def cylinder_bulk_modulus(self) -> float:
        """bulk modulus that stands for the compliance of the cylinder; 0: rigid cylinder [Pa]"""
    @cylinder_bulk_modulus.setter
    def cylinder_bulk_modulus(self, value: float) -> None: ...
    @property
    def cylinderBulkModulus(self) -> float:
        """bulk modulus that stands for the compliance of the cylinder; 0: rigid cylinder [Pa]"""
    @cylinderBulkModulus.setter
    def cylinderBulkModulus(self, value: float) -> None: ...
    @property
    def hose_bulk_modulus(self) -> float:
        """bulk modulus that stands for the compliance of the hoses; 0: rigid hoses [Pa]"""
    @hose_bulk_modulus.setter
    def hose_bulk_modulus(self, value: float) -> None: ...
    @property
    def hoseBulkModulus(self) -> float:
        """bulk modulus that stands for the compliance of the hoses; 0: rigid hoses [Pa]"""
    @hoseBulkModulus.setter
    def hoseBulkModulus(self, value: float) -> None: ...
    @property
    def nominal_flow(self) -> float:
        """flow through the fully open valve per square root of the pressure difference [m^3/(s Pa^(1/2))]"""
    @nominal_flow.setter
    def nominal_flow(self, value: float) -> None: ...
    @property
    def nominalFlow(self) -> float:
        """flow through the fully open valve per square root of the pressure difference [m^3/(s Pa^(1/2))]"""
    @nominalFlow.setter
    def nominalFlow(self, value: float) -> None: ...
    @property
    def system_pressure(self) -> float:
        """pressure of the supply [Pa]"""
    @system_pressure.setter
    def system_pressure(self, value: float) -> None: ...
    @property
    def systemPressure(self) -> float:
        """pressure of the supply [Pa]"""
    @systemPressure.setter
    def systemPressure(self, value: float) -> None: ...
    @property
    def tank_pressure(self) -> float:
        """pressure of the tank [Pa]"""
    @tank_pressure.setter
    def tank_pressure(self, value: float) -> None: ...
    @property
    def tankPressure(self) -> float:
        """pressure of the tank [Pa]"""
    @tankPressure.setter
    def tankPressure(self, value: float) -> None: ...
    @property
    def use_chamber_volume_change(self) -> bool:
        """True: volumes and stiffness of the oil change with the stroke; False: hose volumes and ``oilBulkModulus`` alone"""
    @use_chamber_volume_change.setter
    def use_chamber_volume_change(self, value: bool) -> None: ...
    @property
    def useChamberVolumeChange(self) -> bool:
        """True: volumes and stiffness of the oil change with the stroke; False: hose volumes and ``oilBulkModulus`` alone"""
    @useChamberVolumeChange.setter
    def useChamberVolumeChange(self, value: bool) -> None: ...
    @property
    def active_connector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @active_connector.setter
    def active_connector(self, value: bool) -> None: ...
    @property
    def activeConnector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @activeConnector.setter
    def activeConnector(self, value: bool) -> None: ...
    @property
    def distance(self) -> float:
        """distance of the markers, the length of the actuator [m]"""
    @property
    def displacement(self) -> Array:
        """global vector from marker m0 to marker m1 [m]"""
    @property
    def velocity(self) -> Array:
        """global velocity of marker m1 relative to marker m0 [m/s]"""
    @property
    def velocity_local(self) -> float:
        """rate of the length of the actuator, positive in extension [m/s]"""
    @property
    def force(self) -> Array:
        """global force on marker m0, from chamber pressures and damping [N]"""
    def force_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """force on one of the two bodies or markers, in global axes [3; N]"""
    def torque_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """torque on one of the two bodies or markers, in global axes [3; Nm]"""

class ObjectConnectorLaw(ObjectHandle):
    """Handle: Force law between two markers with states of its own, given by user functions"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def marker_numbers(self) -> tuple[MarkerHandle, ...]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @marker_numbers.setter
    def marker_numbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def markerNumbers(self) -> tuple[MarkerHandle, ...]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def node_numbers(self) -> tuple[NodeHandle, ...]:
        """nodes of the states: a NodeGenericODE1, whose coordinates have the rates of ``stateRateUserFunction``; a NodeGenericData, whose coordinates ``historyUserFunction`` computes once per step; or one of both [n]"""
    @node_numbers.setter
    def node_numbers(self, value: Sequence[NodeIndex | int | str]) -> None: ...
    @property
    def nodeNumbers(self) -> tuple[NodeHandle, ...]:
        """nodes of the states: a NodeGenericODE1, whose coordinates have the rates of ``stateRateUserFunction``; a NodeGenericData, whose coordinates ``historyUserFunction`` computes once per step; or one of both [n]"""
    @nodeNumbers.setter
    def nodeNumbers(self, value: Sequence[NodeIndex | int | str]) -> None: ...
    @property
    def number_of_coordinates(self) -> int:
        """size of the relative motion. 1: difference of two coordinates; 3: relative position in global axes; 6: relative position and Tait-Bryan angles in the joint frame of marker m0"""
    @number_of_coordinates.setter
    def number_of_coordinates(self, value: int) -> None: ...
    @property
    def numberOfCoordinates(self) -> int:
        """size of the relative motion. 1: difference of two coordinates; 3: relative position in global axes; 6: relative position and Tait-Bryan angles in the joint frame of marker m0"""
    @numberOfCoordinates.setter
    def numberOfCoordinates(self, value: int) -> None: ...
    @property
    def rotation_marker0(self) -> Array:
        """axes of the joint frame of marker m0 in the marker's frame; used if ``numberOfCoordinates`` is 6 [3 x 3; 1]"""
    @rotation_marker0.setter
    def rotation_marker0(self, value: ArrayLike) -> None: ...
    @property
    def rotationMarker0(self) -> Array:
        """axes of the joint frame of marker m0 in the marker's frame; used if ``numberOfCoordinates`` is 6 [3 x 3; 1]"""
    @rotationMarker0.setter
    def rotationMarker0(self, value: ArrayLike) -> None: ...
    @property
    def rotation_marker1(self) -> Array:
        """axes of the joint frame of marker m1 in the marker's frame; used if ``numberOfCoordinates`` is 6 [3 x 3; 1]"""
    @rotation_marker1.setter
    def rotation_marker1(self, value: ArrayLike) -> None: ...
    @property
    def rotationMarker1(self) -> Array:
        """axes of the joint frame of marker m1 in the marker's frame; used if ``numberOfCoordinates`` is 6 [3 x 3; 1]"""
    @rotationMarker1.setter
    def rotationMarker1(self, value: ArrayLike) -> None: ...
    @property
    def force_user_function(self) -> Callable[[MainSystem, float, int, Array, Array, Array], ArrayLike] | Literal[0]:
        """function that computes the force; no force without it"""
    @force_user_function.setter
    def force_user_function(self, value: Callable[[MainSystem, float, int, Array, Array, Array], ArrayLike] | Literal[0]) -> None: ...
    @property
    def forceUserFunction(self) -> Callable[[MainSystem, float, int, Array, Array, Array], ArrayLike] | Literal[0]:
        """function that computes the force; no force without it"""
    @forceUserFunction.setter
    def forceUserFunction(self, value: Callable[[MainSystem, float, int, Array, Array, Array], ArrayLike] | Literal[0]) -> None: ...
    @property
    def state_rate_user_function(self) -> Callable[[MainSystem, float, int, Array, Array, Array], ArrayLike] | Literal[0]:
        """function that computes the rates of the first-order coordinates; they are constant without it"""
    @state_rate_user_function.setter
    def state_rate_user_function(self, value: Callable[[MainSystem, float, int, Array, Array, Array], ArrayLike] | Literal[0]) -> None: ...
    @property
    def stateRateUserFunction(self) -> Callable[[MainSystem, float, int, Array, Array, Array], ArrayLike] | Literal[0]:
        """function that computes the rates of the first-order coordinates; they are constant without it"""
    @stateRateUserFunction.setter
    def stateRateUserFunction(self, value: Callable[[MainSystem, float, int, Array, Array, Array], ArrayLike] | Literal[0]) -> None: ...
    @property
    def history_user_function(self) -> Callable[[MainSystem, float, int, Array, Array, Array], ArrayLike] | Literal[0]:
        """function that computes the data coordinates at the end of a step; they are constant without it"""
    @history_user_function.setter
    def history_user_function(self, value: Callable[[MainSystem, float, int, Array, Array, Array], ArrayLike] | Literal[0]) -> None: ...
    @property
    def historyUserFunction(self) -> Callable[[MainSystem, float, int, Array, Array, Array], ArrayLike] | Literal[0]:
        """function that computes the data coordinates at the end of a step; they are constant without it"""
    @historyUserFunction.setter
    def historyUserFunction(self, value: Callable[[MainSystem, float, int, Array, Array, Array], ArrayLike] | Literal[0]) -> None: ...
    @property
    def active_connector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @active_connector.setter
    def active_connector(self, value: bool) -> None: ...
    @property
    def activeConnector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @activeConnector.setter
    def activeConnector(self, value: bool) -> None: ...
    @property
    def displacement(self) -> Array:
        """relative position; for frames in the joint frame, followed by the Tait-Bryan angles [various]"""
    @property
    def velocity(self) -> Array:
        """relative velocity; for frames in the joint frame, followed by the relative angular velocity [various]"""
    @property
    def force(self) -> Array:
        """force on marker m0; for frames in the joint frame, followed by the torque [various]"""
    def force_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """force on one of the two bodies or markers, in global axes [3; N]"""
    def torque_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """torque on one of the two bodies or markers, in global axes [3; Nm]"""

class ObjectConnectorLinearSpringDamper(ObjectHandle):
    """Handle: A spring and damper along an axis that is fixed to the first marker, as in a prismatic joint"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def marker_numbers(self) -> tuple[MarkerHandle, ...]:
        """marker m0, to which the axis is fixed, and marker m1 [2]"""
    @marker_numbers.setter
    def marker_numbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def markerNumbers(self) -> tuple[MarkerHandle, ...]:
        """marker m0, to which the axis is fixed, and marker m1 [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def stiffness(self) -> float:
        """stiffness along the axis [N/m]"""
    @stiffness.setter
    def stiffness(self, value: float) -> None: ...
    @property
    def damping(self) -> float:
        """damping coefficient along the axis [Ns/m]"""
    @damping.setter
    def damping(self, value: float) -> None: ...
    @property
    def axis_marker0(self) -> Array:
        """axis in the frame of marker m0, a unit vector; it turns with that marker [3; 1]"""
    @axis_marker0.setter
    def axis_marker0(self, value: ArrayLike | str) -> None: ...
    @property
    def axisMarker0(self) -> Array:
        """axis in the frame of marker m0, a unit vector; it turns with that marker [3; 1]"""
    @axisMarker0.setter
    def axisMarker0(self, value: ArrayLike | str) -> None: ...
    @property
    def offset(self) -> float:
        """relative position along the axis at which the spring carries no force; may be changed during a simulation as the set value of a drive [m]"""
    @offset.setter
    def offset(self, value: float) -> None: ...
    @property
    def velocity_offset(self) -> float:
        """relative velocity along the axis at which the damper carries no force; set value of a velocity control [m/s]"""
    @velocity_offset.setter
    def velocity_offset(self, value: float) -> None: ...
    @property
    def velocityOffset(self) -> float:
        """relative velocity along the axis at which the damper carries no force; set value of a velocity control [m/s]"""
    @velocityOffset.setter
    def velocityOffset(self, value: float) -> None: ...
    @property
    def active_connector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @active_connector.setter
    def active_connector(self, value: bool) -> None: ...
    @property
    def activeConnector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @activeConnector.setter
    def activeConnector(self, value: bool) -> None: ...
    @property
    def spring_force_user_function(self) -> Callable[[MainSystem, float, int, float, float, float, float, float], float] | Literal[0]:
        """Python function that replaces the law of spring, damper and constant force; called only while the connector is active"""
    @spring_force_user_function.setter
    def spring_force_user_function(self, value: Callable[[MainSystem, float, int, float, float, float, float, float], float] | Literal[0]) -> None: ...
    @property
    def springForceUserFunction(self) -> Callable[[MainSystem, float, int, float, float, float, float, float], float] | Literal[0]:
        """Python function that replaces the law of spring, damper and constant force; called only while the connector is active"""
    @springForceUserFunction.setter
    def springForceUserFunction(self, value: Callable[[MainSystem, float, int, float, float, float, float, float], float] | Literal[0]) -> None: ...
    @property
    def displacement_local(self) -> float:
        """relative position of the markers along the axis [m]"""
    @property
    def velocity_local(self) -> float:
        """relative velocity of the markers along the axis [m/s]"""
    @property
    def force_local(self) -> float:
        """scalar force on marker m0 in the direction of the axis [N]"""
    @property
    def potential_energy(self) -> float:
        """energy of spring and constant force, zero where the spring is relaxed; not available with a user function [J]"""
    @property
    def homogeneous_transformation_local(self) -> HT:
        """relative position and rotation of marker m1 in the axes of marker m0 as a 4 x 4 matrix, row by row; output functions return ``exu.HT`` [various]"""
    @property
    def displacement(self) -> Array:
        """global position of marker m1 relative to marker m0 [m]"""
    def force_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """force on one of the two bodies or markers, in global axes [3; N]"""
    def torque_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """torque on one of the two bodies or markers, in global axes [3; Nm]"""

class ObjectConnectorReevingSystemSprings(ObjectHandle):
    """Handle: A massless elastic rope that runs without friction over sheaves and joins two end points"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def marker_numbers(self) -> tuple[MarkerHandle, ...]:
        """rigid body markers along the rope: the first and the last are its ends, those between carry sheaves or deflection points; if ``hasCoordinateMarkers`` is set, two coordinate markers follow [n]"""
    @marker_numbers.setter
    def marker_numbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def markerNumbers(self) -> tuple[MarkerHandle, ...]:
        """rigid body markers along the rope: the first and the last are its ends, those between carry sheaves or deflection points; if ``hasCoordinateMarkers`` is set, two coordinate markers follow [n]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def has_coordinate_markers(self) -> bool:
        """True: the last two markers are coordinate markers that add rope at the start and at the end"""
    @has_coordinate_markers.setter
    def has_coordinate_markers(self, value: bool) -> None: ...
    @property
    def hasCoordinateMarkers(self) -> bool:
        """True: the last two markers are coordinate markers that add rope at the start and at the end"""
    @hasCoordinateMarkers.setter
    def hasCoordinateMarkers(self, value: bool) -> None: ...
    @property
    def turning_ends(self) -> bool:
        """True: the bodies of the first and the last marker are pulleys that turn with the rope. The coordinate markers measure their rotations, without forces on these coordinates: the rope acts on the pulleys where it touches them"""
    @turning_ends.setter
    def turning_ends(self, value: bool) -> None: ...
    @property
    def turningEnds(self) -> bool:
        """True: the bodies of the first and the last marker are pulleys that turn with the rope. The coordinate markers measure their rotations, without forces on these coordinates: the rope acts on the pulleys where it touches them"""
    @turningEnds.setter
    def turningEnds(self, value: bool) -> None: ...
    @property
    def coordinate_factors(self) -> Array:
        """factors of the two coordinate markers: 1 for lengths, a radius (m) for the angle of a winch [2; various]"""
    @coordinate_factors.setter
    def coordinate_factors(self, value: ArrayLike) -> None: ...
    @property
    def coordinateFactors(self) -> Array:
        """factors of the two coordinate markers: 1 for lengths, a radius (m) for the angle of a winch [2; various]"""
    @coordinateFactors.setter
    def coordinateFactors(self, value: ArrayLike) -> None: ...
    @property
    def stiffness_per_length(self) -> float:
        """axial stiffness of the rope, modulus times cross section; divided by the length it is the stiffness of the rope [N]"""
    @stiffness_per_length.setter
    def stiffness_per_length(self, value: float) -> None: ...
    @property
    def stiffnessPerLength(self) -> float:
        """axial stiffness of the rope, modulus times cross section; divided by the length it is the stiffness of the rope [N]"""
    @stiffnessPerLength.setter
    def stiffnessPerLength(self, value: float) -> None: ...
    @property
    def damping_per_length(self) -> float:
        """axial damping of the rope; divided by the length it is the damping coefficient of the rope [Ns]"""
    @damping_per_length.setter
    def damping_per_length(self, value: float) -> None: ...
    @property
    def dampingPerLength(self) -> float:
        """axial damping of the rope; divided by the length it is the damping coefficient of the rope [Ns]"""
    @dampingPerLength.setter
    def dampingPerLength(self, value: float) -> None: ...
    @property
    def damping_torsional(self) -> float:
        """damping of the relative rotation of neighbouring sheaves about the rope; experimental [Nms]"""
    @damping_torsional.setter
    def damping_torsional(self, value: float) -> None: ...
    @property
    def dampingTorsional(self) -> float:
        """damping of the relative rotation of neighbouring sheaves about the rope; experimental [Nms]"""
    @dampingTorsional.setter
    def dampingTorsional(self, value: float) -> None: ...
    @property
    def damping_shear(self) -> float:
        """damping of the relative motion of neighbouring sheaves across the rope; experimental [Ns]"""
    @damping_shear.setter
    def damping_shear(self, value: float) -> None: ...
    @property
    def dampingShear(self) -> float:
        """damping of the relative motion of neighbouring sheaves across the rope; experimental [Ns]"""
    @dampingShear.setter
    def dampingShear(self, value: float) -> None: ...
    @property
    def regularization_force(self) -> float:
        """positive: largest compressive force, approached smoothly; negative: the rope carries compression like a spring [N]"""
    @regularization_force.setter
    def regularization_force(self, value: float) -> None: ...
    @property
    def regularizationForce(self) -> float:
        """positive: largest compressive force, approached smoothly; negative: the rope carries compression like a spring [N]"""
    @regularizationForce.setter
    def regularizationForce(self, value: float) -> None: ...
    @property
    def reference_length(self) -> float:
        """length of the rope without force [m]"""
    @reference_length.setter
    def reference_length(self, value: float) -> None: ...
    @property
    def referenceLength(self) -> float:
        """length of the rope without force [m]"""
    @referenceLength.setter
    def referenceLength(self, value: float) -> None: ...
    @property
    def sheaves_axes(self) -> Vector3DList:
        """axis of every sheave in the frame of its marker; the sign chooses the side at which the rope runs; it must not be parallel to the line to the next center [n x 3; 1]"""
    @sheaves_axes.setter
    def sheaves_axes(self, value: Sequence[ArrayLike] | Vector3DList | str) -> None: ...
    @property
    def sheavesAxes(self) -> Vector3DList:
        """axis of every sheave in the frame of its marker; the sign chooses the side at which the rope runs; it must not be parallel to the line to the next center [n x 3; 1]"""
    @sheavesAxes.setter
    def sheavesAxes(self, value: Sequence[ArrayLike] | Vector3DList | str) -> None: ...
    @property
    def sheaves_radii(self) -> Array:
        """radius of every sheave; 0: a point. At an end with a radius, the moment of the rope about the center acts on the body of the marker [n; m]"""
    @sheaves_radii.setter
    def sheaves_radii(self, value: ArrayLike) -> None: ...
    @property
    def sheavesRadii(self) -> Array:
        """radius of every sheave; 0: a point. At an end with a radius, the moment of the rope about the center acts on the body of the marker [n; m]"""
    @sheavesRadii.setter
    def sheavesRadii(self, value: ArrayLike) -> None: ...
    @property
    def active_connector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @active_connector.setter
    def active_connector(self, value: bool) -> None: ...
    @property
    def activeConnector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @activeConnector.setter
    def activeConnector(self, value: bool) -> None: ...
    @property
    def distance(self) -> float:
        """length of the rope along spans and sheaves [m]"""
    @property
    def velocity_local(self) -> float:
        """rate of that length [m/s]"""
    @property
    def force_local(self) -> float:
        """tensile force, the same all along the rope [N]"""
    def force_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """force on one of the two bodies or markers, in global axes [3; N]"""
    def torque_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """torque on one of the two bodies or markers, in global axes [3; Nm]"""

class ObjectConnectorRigidBodySpringDamper(ObjectHandle):
    """Handle: A spring and damper with six components, against relative translation and rotation of two rigid body markers"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def marker_numbers(self) -> tuple[MarkerHandle, ...]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @marker_numbers.setter
    def marker_numbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def markerNumbers(self) -> tuple[MarkerHandle, ...]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def node_number(self) -> NodeHandle:
        """NodeGenericData whose data coordinates the user functions may use, for instance for friction or contact states; not set: no data coordinates"""
    @node_number.setter
    def node_number(self, value: NodeIndex | int | str) -> None: ...
    @property
    def nodeNumber(self) -> NodeHandle:
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
    def rotation_marker0(self) -> Array:
        """rotation matrix from joint frame J0 to the frame of marker m0; turns the axes in which stiffness, damping and offset are given [3 x 3; 1]"""
    @rotation_marker0.setter
    def rotation_marker0(self, value: ArrayLike) -> None: ...
    @property
    def rotationMarker0(self) -> Array:
        """rotation matrix from joint frame J0 to the frame of marker m0; turns the axes in which stiffness, damping and offset are given [3 x 3; 1]"""
    @rotationMarker0.setter
    def rotationMarker0(self, value: ArrayLike) -> None: ...
    @property
    def rotation_marker1(self) -> Array:
        """rotation matrix from joint frame J1 to the frame of marker m1; without rotation offset, the springs carry no torque if J0 and J1 are parallel [3 x 3; 1]"""
    @rotation_marker1.setter
    def rotation_marker1(self, value: ArrayLike) -> None: ...
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
    @property
    def intrinsic_formulation(self) -> bool:
        """True: relative motion is measured by the logarithm on SE(3), and forces act in the frame half-way between the markers, such that exchanging the markers changes nothing; False: all is measured in frame J0"""
    @intrinsic_formulation.setter
    def intrinsic_formulation(self, value: bool) -> None: ...
    @property
    def intrinsicFormulation(self) -> bool:
        """True: relative motion is measured by the logarithm on SE(3), and forces act in the frame half-way between the markers, such that exchanging the markers changes nothing; False: all is measured in frame J0"""
    @intrinsicFormulation.setter
    def intrinsicFormulation(self, value: bool) -> None: ...
    @property
    def use_intrinsic_formulation(self) -> bool:
        """True: relative motion is measured by the logarithm on SE(3), and forces act in the frame half-way between the markers, such that exchanging the markers changes nothing; False: all is measured in frame J0"""
    @use_intrinsic_formulation.setter
    def use_intrinsic_formulation(self, value: bool) -> None: ...
    @property
    def useIntrinsicFormulation(self) -> bool:
        """True: relative motion is measured by the logarithm on SE(3), and forces act in the frame half-way between the markers, such that exchanging the markers changes nothing; False: all is measured in frame J0"""
    @useIntrinsicFormulation.setter
    def useIntrinsicFormulation(self, value: bool) -> None: ...
    @property
    def active_connector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @active_connector.setter
    def active_connector(self, value: bool) -> None: ...
    @property
    def activeConnector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @activeConnector.setter
    def activeConnector(self, value: bool) -> None: ...
    @property
    def spring_force_torque_user_function(self) -> Callable[[MainSystem, float, int, Array, Array, Array, Array, Array, Array, Array, Array, Array], ArrayLike] | Literal[0]:
        """Python function that replaces the linear law of force and torque; called only while the connector is active"""
    @spring_force_torque_user_function.setter
    def spring_force_torque_user_function(self, value: Callable[[MainSystem, float, int, Array, Array, Array, Array, Array, Array, Array, Array, Array], ArrayLike] | Literal[0]) -> None: ...
    @property
    def springForceTorqueUserFunction(self) -> Callable[[MainSystem, float, int, Array, Array, Array, Array, Array, Array, Array, Array, Array], ArrayLike] | Literal[0]:
        """Python function that replaces the linear law of force and torque; called only while the connector is active"""
    @springForceTorqueUserFunction.setter
    def springForceTorqueUserFunction(self, value: Callable[[MainSystem, float, int, Array, Array, Array, Array, Array, Array, Array, Array, Array], ArrayLike] | Literal[0]) -> None: ...
    @property
    def post_newton_step_user_function(self) -> Callable[[MainSystem, float, int, Array, Array, Array, Array, Array, Array, Array, Array, Array, Array], ArrayLike] | Literal[0]:
        """Python function that updates the data coordinates of ``nodeNumber`` after each Newton iteration has converged; called only with a data node and while the connector is active"""
    @post_newton_step_user_function.setter
    def post_newton_step_user_function(self, value: Callable[[MainSystem, float, int, Array, Array, Array, Array, Array, Array, Array, Array, Array, Array], ArrayLike] | Literal[0]) -> None: ...
    @property
    def postNewtonStepUserFunction(self) -> Callable[[MainSystem, float, int, Array, Array, Array, Array, Array, Array, Array, Array, Array, Array], ArrayLike] | Literal[0]:
        """Python function that updates the data coordinates of ``nodeNumber`` after each Newton iteration has converged; called only with a data node and while the connector is active"""
    @postNewtonStepUserFunction.setter
    def postNewtonStepUserFunction(self, value: Callable[[MainSystem, float, int, Array, Array, Array, Array, Array, Array, Array, Array, Array, Array], ArrayLike] | Literal[0]) -> None: ...
    @property
    def displacement_local(self) -> Array:
        """position of marker m1 relative to marker m0 in frame J0; the translational part of the logarithm with ``intrinsicFormulation`` [m]"""
    @property
    def velocity_local(self) -> Array:
        """global velocity of marker m1 minus that of marker m0, in frame J0; if ``intrinsicFormulation`` is set, in the mid-frame [m/s]"""
    @property
    def rotation(self) -> Array:
        """Tait-Bryan angles (about x, y, z in turn) of J1 relative to J0; the rotation vector with ``intrinsicFormulation`` [rad]"""
    @property
    def angular_velocity_local(self) -> Array:
        """angular velocity of marker m1 relative to marker m0, in frame J0; if ``intrinsicFormulation`` is set, in the mid-frame [rad/s]"""
    @property
    def force_local(self) -> Array:
        """force on marker m0, in frame J0; if ``intrinsicFormulation`` is set, in the mid-frame [N]"""
    @property
    def torque_local(self) -> Array:
        """torque on marker m0, in frame J0; with ``intrinsicFormulation`` in the mid-frame, without the moment of the force [Nm]"""
    @property
    def potential_energy(self) -> float:
        """energy of spring and constant force, zero where the spring is relaxed; not available with a user function [J]"""
    @property
    def homogeneous_transformation_local(self) -> HT:
        """relative position and rotation of joint frame J1 in joint frame J0 as a 4 x 4 matrix, row by row; output functions return ``exu.HT`` [various]"""
    @property
    def displacement(self) -> Array:
        """global position of marker m1 relative to marker m0 [m]"""
    @property
    def force(self) -> Array:
        """force on the first body, in global axes [3; N]"""
    @property
    def torque(self) -> Array:
        """torque on the first body, in global axes [3; Nm]"""
    def force_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """force on one of the two bodies or markers, in global axes [3; N]"""
    def torque_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """torque on one of the two bodies or markers, in global axes [3; Nm]"""

class ObjectConnectorRollingDiscPenalty(ObjectHandle):
    """Handle: A disc that rolls or slides with friction on a plane, with elastic contact instead of constraints"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def marker_numbers(self) -> tuple[MarkerHandle, ...]:
        """marker m0 on the plane and marker m1 at the center of the disc [2]"""
    @marker_numbers.setter
    def marker_numbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def markerNumbers(self) -> tuple[MarkerHandle, ...]:
        """marker m0 on the plane and marker m1 at the center of the disc [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def node_number(self) -> NodeHandle:
        """NodeGenericData with three data coordinates: slip velocity in lateral and in forward direction, and gap, of the last update"""
    @node_number.setter
    def node_number(self, value: NodeIndex | int | str) -> None: ...
    @property
    def nodeNumber(self) -> NodeHandle:
        """NodeGenericData with three data coordinates: slip velocity in lateral and in forward direction, and gap, of the last update"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    @property
    def disc_radius(self) -> float:
        """radius of the disc [m]"""
    @disc_radius.setter
    def disc_radius(self, value: float) -> None: ...
    @property
    def discRadius(self) -> float:
        """radius of the disc [m]"""
    @discRadius.setter
    def discRadius(self, value: float) -> None: ...
    @property
    def disc_axis(self) -> Array:
        """axis of the disc in the frame of marker m1, a unit vector; must not become parallel to the normal of the plane [3; 1]"""
    @disc_axis.setter
    def disc_axis(self, value: ArrayLike | str) -> None: ...
    @property
    def discAxis(self) -> Array:
        """axis of the disc in the frame of marker m1, a unit vector; must not become parallel to the normal of the plane [3; 1]"""
    @discAxis.setter
    def discAxis(self, value: ArrayLike | str) -> None: ...
    @property
    def plane_normal(self) -> Array:
        """normal of the plane in the frame of marker m0, a unit vector; the plane contains the position of marker m0 [3; 1]"""
    @plane_normal.setter
    def plane_normal(self, value: ArrayLike | str) -> None: ...
    @property
    def planeNormal(self) -> Array:
        """normal of the plane in the frame of marker m0, a unit vector; the plane contains the position of marker m0 [3; 1]"""
    @planeNormal.setter
    def planeNormal(self, value: ArrayLike | str) -> None: ...
    @property
    def dry_friction_angle(self) -> float:
        """rotation of the directions of ``dryFriction`` in the plane, such as the angle of the rollers of a Mecanum wheel [rad]"""
    @dry_friction_angle.setter
    def dry_friction_angle(self, value: float) -> None: ...
    @property
    def dryFrictionAngle(self) -> float:
        """rotation of the directions of ``dryFriction`` in the plane, such as the angle of the rollers of a Mecanum wheel [rad]"""
    @dryFrictionAngle.setter
    def dryFrictionAngle(self, value: float) -> None: ...
    @property
    def contact_stiffness(self) -> float:
        """stiffness normal to the plane [N/m]"""
    @contact_stiffness.setter
    def contact_stiffness(self, value: float) -> None: ...
    @property
    def contactStiffness(self) -> float:
        """stiffness normal to the plane [N/m]"""
    @contactStiffness.setter
    def contactStiffness(self, value: float) -> None: ...
    @property
    def contact_damping(self) -> float:
        """damping coefficient normal to the plane [Ns/m]"""
    @contact_damping.setter
    def contact_damping(self, value: float) -> None: ...
    @property
    def contactDamping(self) -> float:
        """damping coefficient normal to the plane [Ns/m]"""
    @contactDamping.setter
    def contactDamping(self, value: float) -> None: ...
    @property
    def dry_friction(self) -> Array:
        """friction coefficients in lateral and in forward direction [2; 1]"""
    @dry_friction.setter
    def dry_friction(self, value: ArrayLike) -> None: ...
    @property
    def dryFriction(self) -> Array:
        """friction coefficients in lateral and in forward direction [2; 1]"""
    @dryFriction.setter
    def dryFriction(self, value: ArrayLike) -> None: ...
    @property
    def dry_friction_proportional_zone(self) -> float:
        """slip speed up to which friction is regularized; 0: none [m/s]"""
    @dry_friction_proportional_zone.setter
    def dry_friction_proportional_zone(self, value: float) -> None: ...
    @property
    def dryFrictionProportionalZone(self) -> float:
        """slip speed up to which friction is regularized; 0: none [m/s]"""
    @dryFrictionProportionalZone.setter
    def dryFrictionProportionalZone(self, value: float) -> None: ...
    @property
    def viscous_friction(self) -> Array:
        """growth of the friction coefficients with the slip speed, in lateral and in forward direction [2; s/m]"""
    @viscous_friction.setter
    def viscous_friction(self, value: ArrayLike) -> None: ...
    @property
    def viscousFriction(self) -> Array:
        """growth of the friction coefficients with the slip speed, in lateral and in forward direction [2; s/m]"""
    @viscousFriction.setter
    def viscousFriction(self, value: ArrayLike) -> None: ...
    @property
    def rolling_friction_viscous(self) -> float:
        """rolling resistance per normal force and per speed of the disc center along the plane; only for a disc with its axis parallel to the plane [s/m]"""
    @rolling_friction_viscous.setter
    def rolling_friction_viscous(self, value: float) -> None: ...
    @property
    def rollingFrictionViscous(self) -> float:
        """rolling resistance per normal force and per speed of the disc center along the plane; only for a disc with its axis parallel to the plane [s/m]"""
    @rollingFrictionViscous.setter
    def rollingFrictionViscous(self, value: float) -> None: ...
    @property
    def rolling_viscous_friction(self) -> float:
        """rolling resistance per normal force and per speed of the disc center along the plane; only for a disc with its axis parallel to the plane [s/m]"""
    @rolling_viscous_friction.setter
    def rolling_viscous_friction(self, value: float) -> None: ...
    @property
    def rollingViscousFriction(self) -> float:
        """rolling resistance per normal force and per speed of the disc center along the plane; only for a disc with its axis parallel to the plane [s/m]"""
    @rollingViscousFriction.setter
    def rollingViscousFriction(self, value: float) -> None: ...
    @property
    def use_linear_proportional_zone(self) -> bool:
        """True: friction grows linearly in the proportional zone, with a constant tangent in sticking; False: quadratically, with a smooth end of the zone"""
    @use_linear_proportional_zone.setter
    def use_linear_proportional_zone(self, value: bool) -> None: ...
    @property
    def useLinearProportionalZone(self) -> bool:
        """True: friction grows linearly in the proportional zone, with a constant tangent in sticking; False: quadratically, with a smooth end of the zone"""
    @useLinearProportionalZone.setter
    def useLinearProportionalZone(self, value: bool) -> None: ...
    @property
    def active_connector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @active_connector.setter
    def active_connector(self, value: bool) -> None: ...
    @property
    def activeConnector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @activeConnector.setter
    def activeConnector(self, value: bool) -> None: ...
    @property
    def position(self) -> Array:
        """contact point relative to marker m0, in global axes [m]"""
    @property
    def velocity(self) -> Array:
        """global velocity at which the contact point moves along its trail; not the velocity of the disc at that point [m/s]"""
    @property
    def velocity_local(self) -> Array:
        """slip velocity of disc against plane at the contact point, in frame J1 [m/s]"""
    @property
    def force_local(self) -> Array:
        """contact force on the disc in frame J1: lateral, forward, normal; without the rolling resistance, which acts at the center of the disc [N]"""
    @property
    def rotation_matrix(self) -> Array:
        """rotation matrix from frame J1 (lateral, forward, normal) to the global frame, row by row [1]"""
    @property
    def force(self) -> Array:
        """force on the first body, in global axes [3; N]"""
    def force_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """force on one of the two bodies or markers, in global axes [3; N]"""
    def torque_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """torque on one of the two bodies or markers, in global axes [3; Nm]"""

class ObjectConnectorSpringDamper(ObjectHandle):
    """Handle: A spring and a damper that act along the line between two points"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def marker_numbers(self) -> tuple[MarkerHandle, ...]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @marker_numbers.setter
    def marker_numbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def markerNumbers(self) -> tuple[MarkerHandle, ...]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def reference_length(self) -> float:
        """length at which the spring itself carries no force [m]"""
    @reference_length.setter
    def reference_length(self, value: float) -> None: ...
    @property
    def referenceLength(self) -> float:
        """length at which the spring itself carries no force [m]"""
    @referenceLength.setter
    def referenceLength(self, value: float) -> None: ...
    @property
    def stiffness(self) -> float:
        """stiffness of the spring, force per elongation [N/m]"""
    @stiffness.setter
    def stiffness(self, value: float) -> None: ...
    @property
    def damping(self) -> float:
        """coefficient of the damper, force per rate of length [Ns/m]"""
    @damping.setter
    def damping(self, value: float) -> None: ...
    @property
    def velocity_offset(self) -> float:
        """rate of length at which the damper carries no force, for instance the rate at which ``referenceLength`` is changed [m/s]"""
    @velocity_offset.setter
    def velocity_offset(self, value: float) -> None: ...
    @property
    def velocityOffset(self) -> float:
        """rate of length at which the damper carries no force, for instance the rate at which ``referenceLength`` is changed [m/s]"""
    @velocityOffset.setter
    def velocityOffset(self, value: float) -> None: ...
    @property
    def active_connector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @active_connector.setter
    def active_connector(self, value: bool) -> None: ...
    @property
    def activeConnector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @activeConnector.setter
    def activeConnector(self, value: bool) -> None: ...
    @property
    def spring_force_user_function(self) -> Callable[[MainSystem, float, int, float, float, float, float, float], float] | Literal[0]:
        """Python function that replaces the law of spring, damper and constant force; called only while the connector is active"""
    @spring_force_user_function.setter
    def spring_force_user_function(self, value: Callable[[MainSystem, float, int, float, float, float, float, float], float] | Literal[0]) -> None: ...
    @property
    def springForceUserFunction(self) -> Callable[[MainSystem, float, int, float, float, float, float, float], float] | Literal[0]:
        """Python function that replaces the law of spring, damper and constant force; called only while the connector is active"""
    @springForceUserFunction.setter
    def springForceUserFunction(self, value: Callable[[MainSystem, float, int, float, float, float, float, float], float] | Literal[0]) -> None: ...
    @property
    def distance(self) -> float:
        """distance of the two markers, the current length of the spring [m]"""
    @property
    def displacement(self) -> Array:
        """global vector from marker m0 to marker m1 [m]"""
    @property
    def velocity(self) -> Array:
        """global velocity of marker m1 relative to marker m0 [m/s]"""
    @property
    def force_local(self) -> float:
        """scalar force, positive in tension [N]"""
    @property
    def potential_energy(self) -> float:
        """energy of spring and constant force, zero where the spring is relaxed; not available with a user function [J]"""
    def force_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """force on one of the two bodies or markers, in global axes [3; N]"""
    def torque_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """torque on one of the two bodies or markers, in global axes [3; Nm]"""

class ObjectConnectorTorsionalSpringDamper(ObjectHandle):
    """Handle: A torsional spring and damper about the z axis of a joint frame"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def marker_numbers(self) -> tuple[MarkerHandle, ...]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @marker_numbers.setter
    def marker_numbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def markerNumbers(self) -> tuple[MarkerHandle, ...]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def node_number(self) -> NodeHandle:
        """NodeGenericData with one data coordinate that holds the angle of the last step and makes the measured angle continuous beyond half a turn; not set: the angle jumps"""
    @node_number.setter
    def node_number(self, value: NodeIndex | int | str) -> None: ...
    @property
    def nodeNumber(self) -> NodeHandle:
        """NodeGenericData with one data coordinate that holds the angle of the last step and makes the measured angle continuous beyond half a turn; not set: the angle jumps"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    @property
    def stiffness(self) -> float:
        """torsional stiffness [Nm/rad]"""
    @stiffness.setter
    def stiffness(self, value: float) -> None: ...
    @property
    def damping(self) -> float:
        """torsional damping coefficient [Nms/rad]"""
    @damping.setter
    def damping(self, value: float) -> None: ...
    @property
    def rotation_marker0(self) -> Array:
        """rotation matrix from joint frame J0 to the frame of marker m0; its third column is the axis of rotation [3 x 3; 1]"""
    @rotation_marker0.setter
    def rotation_marker0(self, value: ArrayLike) -> None: ...
    @property
    def rotationMarker0(self) -> Array:
        """rotation matrix from joint frame J0 to the frame of marker m0; its third column is the axis of rotation [3 x 3; 1]"""
    @rotationMarker0.setter
    def rotationMarker0(self, value: ArrayLike) -> None: ...
    @property
    def rotation_marker1(self) -> Array:
        """rotation matrix from joint frame J1 to the frame of marker m1; the angle is zero if J0 and J1 are parallel [3 x 3; 1]"""
    @rotation_marker1.setter
    def rotation_marker1(self, value: ArrayLike) -> None: ...
    @property
    def rotationMarker1(self) -> Array:
        """rotation matrix from joint frame J1 to the frame of marker m1; the angle is zero if J0 and J1 are parallel [3 x 3; 1]"""
    @rotationMarker1.setter
    def rotationMarker1(self, value: ArrayLike) -> None: ...
    @property
    def offset(self) -> float:
        """angle at which the spring carries no torque; may be changed during a simulation as the set value of a drive [rad]"""
    @offset.setter
    def offset(self, value: float) -> None: ...
    @property
    def velocity_offset(self) -> float:
        """relative angular velocity at which the damper carries no torque; set value of a velocity control [rad/s]"""
    @velocity_offset.setter
    def velocity_offset(self, value: float) -> None: ...
    @property
    def velocityOffset(self) -> float:
        """relative angular velocity at which the damper carries no torque; set value of a velocity control [rad/s]"""
    @velocityOffset.setter
    def velocityOffset(self, value: float) -> None: ...
    @property
    def active_connector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @active_connector.setter
    def active_connector(self, value: bool) -> None: ...
    @property
    def activeConnector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @activeConnector.setter
    def activeConnector(self, value: bool) -> None: ...
    @property
    def spring_torque_user_function(self) -> Callable[[MainSystem, float, int, float, float, float, float, float], float] | Literal[0]:
        """Python function that replaces the law of spring, damper and constant torque; called only while the connector is active"""
    @spring_torque_user_function.setter
    def spring_torque_user_function(self, value: Callable[[MainSystem, float, int, float, float, float, float, float], float] | Literal[0]) -> None: ...
    @property
    def springTorqueUserFunction(self) -> Callable[[MainSystem, float, int, float, float, float, float, float], float] | Literal[0]:
        """Python function that replaces the law of spring, damper and constant torque; called only while the connector is active"""
    @springTorqueUserFunction.setter
    def springTorqueUserFunction(self, value: Callable[[MainSystem, float, int, float, float, float, float, float], float] | Literal[0]) -> None: ...
    @property
    def rotation(self) -> float:
        """angle of J1 relative to J0 about the z axis of J0; in the range of half a turn to both sides, or continuous with a data node [rad]"""
    @property
    def angular_velocity_local(self) -> float:
        """z component in J0 of the angular velocity of marker m1 relative to marker m0 [rad/s]"""
    @property
    def torque_local(self) -> float:
        """torque on marker m0 about the z axis of J0; its negative acts on marker m1 [Nm]"""
    @property
    def potential_energy(self) -> float:
        """energy of spring and constant force, zero where the spring is relaxed; not available with a user function [J]"""
    def force_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """force on one of the two bodies or markers, in global axes [3; N]"""
    def torque_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """torque on one of the two bodies or markers, in global axes [3; Nm]"""

class ObjectConnectorCoordinate(ObjectHandle):
    """Handle: Couples two coordinates, or fixes one of them to a value or to a function of time"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def marker_numbers(self) -> tuple[MarkerHandle, ...]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @marker_numbers.setter
    def marker_numbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def markerNumbers(self) -> tuple[MarkerHandle, ...]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def offset(self) -> float:
        """prescribed value of ``factorValue1`` times the second coordinate minus the first one; with ``velocityLevel`` the same for the velocity coordinates [various]"""
    @offset.setter
    def offset(self, value: float) -> None: ...
    @property
    def factor_value1(self) -> float:
        """factor of the coordinate of marker m1, such as a gear ratio [1]"""
    @factor_value1.setter
    def factor_value1(self, value: float) -> None: ...
    @property
    def factorValue1(self) -> float:
        """factor of the coordinate of marker m1, such as a gear ratio [1]"""
    @factorValue1.setter
    def factorValue1(self, value: float) -> None: ...
    @property
    def factor1(self) -> float:
        """factor of the coordinate of marker m1, such as a gear ratio [1]"""
    @factor1.setter
    def factor1(self, value: float) -> None: ...
    @property
    def velocity_level(self) -> bool:
        """True: the constraint is set for the velocity coordinates, and ``offset`` is a velocity; ``offsetUserFunction`` is then ignored; only for coordinates of second order equations"""
    @velocity_level.setter
    def velocity_level(self, value: bool) -> None: ...
    @property
    def velocityLevel(self) -> bool:
        """True: the constraint is set for the velocity coordinates, and ``offset`` is a velocity; ``offsetUserFunction`` is then ignored; only for coordinates of second order equations"""
    @velocityLevel.setter
    def velocityLevel(self, value: bool) -> None: ...
    @property
    def offset_user_function(self) -> Callable[[MainSystem, float, int, float], float] | Literal[0]:
        """Python function that replaces ``offset`` by a function of time, on position level"""
    @offset_user_function.setter
    def offset_user_function(self, value: Callable[[MainSystem, float, int, float], float] | Literal[0]) -> None: ...
    @property
    def offsetUserFunction(self) -> Callable[[MainSystem, float, int, float], float] | Literal[0]:
        """Python function that replaces ``offset`` by a function of time, on position level"""
    @offsetUserFunction.setter
    def offsetUserFunction(self, value: Callable[[MainSystem, float, int, float], float] | Literal[0]) -> None: ...
    @property
    def offset_user_function_t(self) -> Callable[[MainSystem, float, int, float], float] | Literal[0]:
        """Python function, the time derivative of ``offsetUserFunction``; used wherever the constraint is evaluated on velocity level"""
    @offset_user_function_t.setter
    def offset_user_function_t(self, value: Callable[[MainSystem, float, int, float], float] | Literal[0]) -> None: ...
    @property
    def offsetUserFunction_t(self) -> Callable[[MainSystem, float, int, float], float] | Literal[0]:
        """Python function, the time derivative of ``offsetUserFunction``; used wherever the constraint is evaluated on velocity level"""
    @offsetUserFunction_t.setter
    def offsetUserFunction_t(self, value: Callable[[MainSystem, float, int, float], float] | Literal[0]) -> None: ...
    @property
    def active_connector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @active_connector.setter
    def active_connector(self, value: bool) -> None: ...
    @property
    def activeConnector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @activeConnector.setter
    def activeConnector(self, value: bool) -> None: ...
    @property
    def displacement(self) -> float:
        """difference of the marker coordinates, without ``factorValue1`` [various]"""
    @property
    def velocity(self) -> float:
        """difference of the marker velocity coordinates, without ``factorValue1`` [various]"""
    @property
    def constraint_equation(self) -> float:
        """residual of the constraint on position level, or on velocity level with ``velocityLevel`` [various]"""
    @property
    def force(self) -> float:
        """Lagrange multiplier, the generalized constraint force; N for lengths, Nm for angles [various]"""
    def force_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """force on one of the two bodies or markers, in global axes [3; N]"""
    def torque_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """torque on one of the two bodies or markers, in global axes [3; Nm]"""

class ObjectConnectorCoordinateVector(ObjectHandle):
    """Handle: Couples the coordinate vectors of two markers by linear and quadratic equations, or by a user function"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def marker_numbers(self) -> tuple[MarkerHandle, ...]:
        """two markers on coordinate vectors; the equations are those of m1 minus those of m0 [2]"""
    @marker_numbers.setter
    def marker_numbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def markerNumbers(self) -> tuple[MarkerHandle, ...]:
        """two markers on coordinate vectors; the equations are those of m1 minus those of m0 [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def scaling_marker0(self) -> Array:
        """matrix of linear factors of the coordinates of marker m0, one row per equation and one column per coordinate; empty: no such term [n x m; various]"""
    @scaling_marker0.setter
    def scaling_marker0(self, value: ArrayLike) -> None: ...
    @property
    def scalingMarker0(self) -> Array:
        """matrix of linear factors of the coordinates of marker m0, one row per equation and one column per coordinate; empty: no such term [n x m; various]"""
    @scalingMarker0.setter
    def scalingMarker0(self, value: ArrayLike) -> None: ...
    @property
    def scaling_marker1(self) -> Array:
        """matrix of linear factors of the coordinates of marker m1; empty: no such term [n x m; various]"""
    @scaling_marker1.setter
    def scaling_marker1(self, value: ArrayLike) -> None: ...
    @property
    def scalingMarker1(self) -> Array:
        """matrix of linear factors of the coordinates of marker m1; empty: no such term [n x m; various]"""
    @scalingMarker1.setter
    def scalingMarker1(self, value: ArrayLike) -> None: ...
    @property
    def quadratic_term_marker0(self) -> Array:
        """matrix of factors of the squared coordinates of marker m0; empty: no such term [n x m; various]"""
    @quadratic_term_marker0.setter
    def quadratic_term_marker0(self, value: ArrayLike) -> None: ...
    @property
    def quadraticTermMarker0(self) -> Array:
        """matrix of factors of the squared coordinates of marker m0; empty: no such term [n x m; various]"""
    @quadraticTermMarker0.setter
    def quadraticTermMarker0(self, value: ArrayLike) -> None: ...
    @property
    def quadratic_term_marker1(self) -> Array:
        """matrix of factors of the squared coordinates of marker m1; empty: no such term [n x m; various]"""
    @quadratic_term_marker1.setter
    def quadratic_term_marker1(self, value: ArrayLike) -> None: ...
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
    @property
    def velocity_level(self) -> bool:
        """True: the equations are set for the velocity coordinates, and ``offset`` is a velocity; only for coordinates of second order equations"""
    @velocity_level.setter
    def velocity_level(self, value: bool) -> None: ...
    @property
    def velocityLevel(self) -> bool:
        """True: the equations are set for the velocity coordinates, and ``offset`` is a velocity; only for coordinates of second order equations"""
    @velocityLevel.setter
    def velocityLevel(self, value: bool) -> None: ...
    @property
    def constraint_user_function(self) -> Callable[[MainSystem, float, int, Array, Array, bool], ArrayLike] | Literal[0]:
        """Python function that replaces all equations; ``jacobianUserFunction`` is needed as well, and ``scalingMarker0`` tells the number of equations by its number of rows, as in ``np.zeros((2, 1))``"""
    @constraint_user_function.setter
    def constraint_user_function(self, value: Callable[[MainSystem, float, int, Array, Array, bool], ArrayLike] | Literal[0]) -> None: ...
    @property
    def constraintUserFunction(self) -> Callable[[MainSystem, float, int, Array, Array, bool], ArrayLike] | Literal[0]:
        """Python function that replaces all equations; ``jacobianUserFunction`` is needed as well, and ``scalingMarker0`` tells the number of equations by its number of rows, as in ``np.zeros((2, 1))``"""
    @constraintUserFunction.setter
    def constraintUserFunction(self, value: Callable[[MainSystem, float, int, Array, Array, bool], ArrayLike] | Literal[0]) -> None: ...
    @property
    def jacobian_user_function(self) -> Callable[[MainSystem, float, int, Array, Array, bool], MatrixLike] | Literal[0]:
        """Python function, the derivative of ``constraintUserFunction`` with respect to the coordinates (or velocity coordinates with ``velocityLevel``)"""
    @jacobian_user_function.setter
    def jacobian_user_function(self, value: Callable[[MainSystem, float, int, Array, Array, bool], MatrixLike] | Literal[0]) -> None: ...
    @property
    def jacobianUserFunction(self) -> Callable[[MainSystem, float, int, Array, Array, bool], MatrixLike] | Literal[0]:
        """Python function, the derivative of ``constraintUserFunction`` with respect to the coordinates (or velocity coordinates with ``velocityLevel``)"""
    @jacobianUserFunction.setter
    def jacobianUserFunction(self, value: Callable[[MainSystem, float, int, Array, Array, bool], MatrixLike] | Literal[0]) -> None: ...
    @property
    def active_connector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @active_connector.setter
    def active_connector(self, value: bool) -> None: ...
    @property
    def activeConnector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @activeConnector.setter
    def activeConnector(self, value: bool) -> None: ...
    @property
    def displacement(self) -> Array:
        """coordinates of marker m1 minus those of marker m0, without factors; size: number of coordinates of a marker [various]"""
    @property
    def velocity(self) -> Array:
        """velocity coordinates of marker m1 minus those of marker m0, without factors; size: number of coordinates of a marker [various]"""
    @property
    def constraint_equation(self) -> Array:
        """residual of the equations on position level, or on velocity level with ``velocityLevel``; size: number of equations [various]"""
    @property
    def force(self) -> Array:
        """Lagrange multipliers; size: number of equations [various]"""
    def force_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """force on one of the two bodies or markers, in global axes [3; N]"""
    def torque_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """torque on one of the two bodies or markers, in global axes [3; Nm]"""

class ObjectConnectorDistance(ObjectHandle):
    """Handle: Keeps the distance of two points constant, like a massless rigid rod between two ball joints"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def marker_numbers(self) -> tuple[MarkerHandle, ...]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @marker_numbers.setter
    def marker_numbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def markerNumbers(self) -> tuple[MarkerHandle, ...]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def active_connector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @active_connector.setter
    def active_connector(self, value: bool) -> None: ...
    @property
    def activeConnector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @activeConnector.setter
    def activeConnector(self, value: bool) -> None: ...
    @property
    def displacement(self) -> Array:
        """global vector from marker m0 to marker m1 [m]"""
    @property
    def velocity(self) -> Array:
        """global velocity of marker m1 relative to marker m0 [m/s]"""
    @property
    def force(self) -> float:
        """Lagrange multiplier, the force in the rod, positive in tension [N]"""
    def force_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """force on one of the two bodies or markers, in global axes [3; N]"""
    def torque_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """torque on one of the two bodies or markers, in global axes [3; Nm]"""

class ObjectContactCircleCable2D(ObjectHandle):
    """Handle: Contact without friction of a planar cable element with a circle"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def marker_numbers(self) -> tuple[MarkerHandle, ...]:
        """marker m0 at the center of the circle and marker m1, the shape of the cable [2]"""
    @marker_numbers.setter
    def marker_numbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def markerNumbers(self) -> tuple[MarkerHandle, ...]:
        """marker m0 at the center of the circle and marker m1, the shape of the cable [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def node_number(self) -> NodeHandle:
        """NodeGenericData with one data coordinate per segment, the gap when contact opened or closed last; a segment is in contact while it is not positive"""
    @node_number.setter
    def node_number(self, value: NodeIndex | int | str) -> None: ...
    @property
    def nodeNumber(self) -> NodeHandle:
        """NodeGenericData with one data coordinate per segment, the gap when contact opened or closed last; a segment is in contact while it is not positive"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    @property
    def number_of_contact_segments(self) -> int:
        """number of segments; must be that of the shape marker"""
    @number_of_contact_segments.setter
    def number_of_contact_segments(self, value: int) -> None: ...
    @property
    def numberOfContactSegments(self) -> int:
        """number of segments; must be that of the shape marker"""
    @numberOfContactSegments.setter
    def numberOfContactSegments(self, value: int) -> None: ...
    @property
    def contact_stiffness(self) -> float:
        """contact stiffness per segment [N/m]"""
    @contact_stiffness.setter
    def contact_stiffness(self, value: float) -> None: ...
    @property
    def contactStiffness(self) -> float:
        """contact stiffness per segment [N/m]"""
    @contactStiffness.setter
    def contactStiffness(self, value: float) -> None: ...
    @property
    def contact_damping(self) -> float:
        """contact damping coefficient per segment [Ns/m]"""
    @contact_damping.setter
    def contact_damping(self, value: float) -> None: ...
    @property
    def contactDamping(self) -> float:
        """contact damping coefficient per segment [Ns/m]"""
    @contactDamping.setter
    def contactDamping(self, value: float) -> None: ...
    @property
    def circle_radius(self) -> float:
        """radius of the circle [m]"""
    @circle_radius.setter
    def circle_radius(self, value: float) -> None: ...
    @property
    def circleRadius(self) -> float:
        """radius of the circle [m]"""
    @circleRadius.setter
    def circleRadius(self, value: float) -> None: ...
    @property
    def offset(self) -> float:
        """distance that is added to the radius of the circle, such as half the thickness of the cable [m]"""
    @offset.setter
    def offset(self, value: float) -> None: ...
    @property
    def active_connector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @active_connector.setter
    def active_connector(self, value: bool) -> None: ...
    @property
    def activeConnector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @activeConnector.setter
    def activeConnector(self, value: bool) -> None: ...
    def force_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """force on one of the two bodies or markers, in global axes [3; N]"""
    def torque_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """torque on one of the two bodies or markers, in global axes [3; Nm]"""

class ObjectContactConvexRoll(ObjectHandle):
    """Handle: Contact of a convex roll, a body of revolution with a polynomial profile, with the ground plane"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def marker_numbers(self) -> tuple[MarkerHandle, ...]:
        """marker m0 on the ground, whose x and y axes span the plane, and marker m1 at the center of the roll, with the x axis along it [2]"""
    @marker_numbers.setter
    def marker_numbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def markerNumbers(self) -> tuple[MarkerHandle, ...]:
        """marker m0 on the ground, whose x and y axes span the plane, and marker m1 at the center of the roll, with the x axis along it [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def node_number(self) -> NodeHandle:
        """NodeGenericData with three data coordinates of the last update: gap, and slip velocity along the x and y axes of marker m0"""
    @node_number.setter
    def node_number(self, value: NodeIndex | int | str) -> None: ...
    @property
    def nodeNumber(self) -> NodeHandle:
        """NodeGenericData with three data coordinates of the last update: gap, and slip velocity along the x and y axes of marker m0"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    @property
    def contact_stiffness(self) -> float:
        """stiffness normal to the plane [N/m]"""
    @contact_stiffness.setter
    def contact_stiffness(self, value: float) -> None: ...
    @property
    def contactStiffness(self) -> float:
        """stiffness normal to the plane [N/m]"""
    @contactStiffness.setter
    def contactStiffness(self, value: float) -> None: ...
    @property
    def contact_damping(self) -> float:
        """damping coefficient normal to the plane [Ns/m]"""
    @contact_damping.setter
    def contact_damping(self, value: float) -> None: ...
    @property
    def contactDamping(self) -> float:
        """damping coefficient normal to the plane [Ns/m]"""
    @contactDamping.setter
    def contactDamping(self, value: float) -> None: ...
    @property
    def dynamic_friction(self) -> float:
        """coefficient of friction in sliding [1]"""
    @dynamic_friction.setter
    def dynamic_friction(self, value: float) -> None: ...
    @property
    def dynamicFriction(self) -> float:
        """coefficient of friction in sliding [1]"""
    @dynamicFriction.setter
    def dynamicFriction(self, value: float) -> None: ...
    @property
    def static_friction_offset(self) -> float:
        """difference of the coefficients of static and dynamic friction [1]"""
    @static_friction_offset.setter
    def static_friction_offset(self, value: float) -> None: ...
    @property
    def staticFrictionOffset(self) -> float:
        """difference of the coefficients of static and dynamic friction [1]"""
    @staticFrictionOffset.setter
    def staticFrictionOffset(self, value: float) -> None: ...
    @property
    def viscous_friction(self) -> float:
        """growth of the friction coefficient with the slip speed [s/m]"""
    @viscous_friction.setter
    def viscous_friction(self, value: float) -> None: ...
    @property
    def viscousFriction(self) -> float:
        """growth of the friction coefficient with the slip speed [s/m]"""
    @viscousFriction.setter
    def viscousFriction(self, value: float) -> None: ...
    @property
    def exponential_decay_static(self) -> float:
        """slip speed by which the static offset falls to 1/e [m/s]"""
    @exponential_decay_static.setter
    def exponential_decay_static(self, value: float) -> None: ...
    @property
    def exponentialDecayStatic(self) -> float:
        """slip speed by which the static offset falls to 1/e [m/s]"""
    @exponentialDecayStatic.setter
    def exponentialDecayStatic(self, value: float) -> None: ...
    @property
    def friction_proportional_zone(self) -> float:
        """slip speed up to which friction is proportional to it [m/s]"""
    @friction_proportional_zone.setter
    def friction_proportional_zone(self, value: float) -> None: ...
    @property
    def frictionProportionalZone(self) -> float:
        """slip speed up to which friction is proportional to it [m/s]"""
    @frictionProportionalZone.setter
    def frictionProportionalZone(self, value: float) -> None: ...
    @property
    def roll_length(self) -> float:
        """length of the roll, symmetric about its center [m]"""
    @roll_length.setter
    def roll_length(self, value: float) -> None: ...
    @property
    def rollLength(self) -> float:
        """length of the roll, symmetric about its center [m]"""
    @rollLength.setter
    def rollLength(self, value: float) -> None: ...
    @property
    def coefficients_hull(self) -> Array:
        """coefficients of the polynomial radius over the position x on the axis, highest power first; the profile must be convex [n; various]"""
    @coefficients_hull.setter
    def coefficients_hull(self, value: ArrayLike) -> None: ...
    @property
    def coefficientsHull(self) -> Array:
        """coefficients of the polynomial radius over the position x on the axis, highest power first; the profile must be convex [n; various]"""
    @coefficientsHull.setter
    def coefficientsHull(self, value: ArrayLike) -> None: ...
    @property
    def r_bounding_sphere(self) -> float:
        """radius of spheres at both ends that exclude contact by a cheap test; no effect here, because the lowest point of the profile is always computed [m]"""
    @r_bounding_sphere.setter
    def r_bounding_sphere(self, value: float) -> None: ...
    @property
    def rBoundingSphere(self) -> float:
        """radius of spheres at both ends that exclude contact by a cheap test; no effect here, because the lowest point of the profile is always computed [m]"""
    @rBoundingSphere.setter
    def rBoundingSphere(self, value: float) -> None: ...
    @property
    def active_connector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @active_connector.setter
    def active_connector(self, value: bool) -> None: ...
    @property
    def activeConnector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @activeConnector.setter
    def activeConnector(self, value: bool) -> None: ...
    @property
    def limit_damping(self) -> bool:
        """True: the force is never tensile; it is zero if damping would make it tensile. False: damping also acts in tension until the gap is open"""
    @limit_damping.setter
    def limit_damping(self, value: bool) -> None: ...
    @property
    def limitDamping(self) -> bool:
        """True: the force is never tensile; it is zero if damping would make it tensile. False: damping also acts in tension until the gap is open"""
    @limitDamping.setter
    def limitDamping(self, value: bool) -> None: ...
    @property
    def position(self) -> Array:
        """global contact point [m]"""
    @property
    def velocity(self) -> Array:
        """global slip velocity of the roll against the ground at the contact point [m/s]"""
    @property
    def force(self) -> Array:
        """global force of the ground on the roll [N]"""
    @property
    def torque(self) -> Array:
        """global torque of that force about the center of the roll [Nm]"""
    def force_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """force on one of the two bodies or markers, in global axes [3; N]"""
    def torque_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """torque on one of the two bodies or markers, in global axes [3; Nm]"""

class ObjectContactCoordinate(ObjectHandle):
    """Handle: Contact of two coordinates, a one-sided spring and damper"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def marker_numbers(self) -> tuple[MarkerHandle, ...]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @marker_numbers.setter
    def marker_numbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def markerNumbers(self) -> tuple[MarkerHandle, ...]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def node_number(self) -> NodeHandle:
        """NodeGenericData with one data coordinate, the gap of the last update, which must not be positive if the simulation begins in contact; with an ``impactModel`` other than 0 a second one, the impact velocity"""
    @node_number.setter
    def node_number(self, value: NodeIndex | int | str) -> None: ...
    @property
    def nodeNumber(self) -> NodeHandle:
        """NodeGenericData with one data coordinate, the gap of the last update, which must not be positive if the simulation begins in contact; with an ``impactModel`` other than 0 a second one, the impact velocity"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    @property
    def contact_stiffness(self) -> float:
        """contact stiffness; N/m for coordinates that are lengths [various]"""
    @contact_stiffness.setter
    def contact_stiffness(self, value: float) -> None: ...
    @property
    def contactStiffness(self) -> float:
        """contact stiffness; N/m for coordinates that are lengths [various]"""
    @contactStiffness.setter
    def contactStiffness(self, value: float) -> None: ...
    @property
    def contact_damping(self) -> float:
        """contact damping coefficient; Ns/m for coordinates that are lengths [various]"""
    @contact_damping.setter
    def contact_damping(self, value: float) -> None: ...
    @property
    def contactDamping(self) -> float:
        """contact damping coefficient; Ns/m for coordinates that are lengths [various]"""
    @contactDamping.setter
    def contactDamping(self, value: float) -> None: ...
    @property
    def offset(self) -> float:
        """difference of the coordinates at which contact begins; m for lengths [various]"""
    @offset.setter
    def offset(self, value: float) -> None: ...
    @property
    def active_connector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @active_connector.setter
    def active_connector(self, value: bool) -> None: ...
    @property
    def activeConnector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @activeConnector.setter
    def activeConnector(self, value: bool) -> None: ...
    @property
    def contact_stiffness_exponent(self) -> float:
        """exponent n of the penetration in the normal force; 1.5 for Hertzian contact [1]"""
    @contact_stiffness_exponent.setter
    def contact_stiffness_exponent(self, value: float) -> None: ...
    @property
    def contactStiffnessExponent(self) -> float:
        """exponent n of the penetration in the normal force; 1.5 for Hertzian contact [1]"""
    @contactStiffnessExponent.setter
    def contactStiffnessExponent(self, value: float) -> None: ...
    @property
    def restitution_coefficient(self) -> float:
        """ratio of normal speeds after and before an impact, for ``impactModel`` 1 and 2; positive, 1: elastic [1]"""
    @restitution_coefficient.setter
    def restitution_coefficient(self, value: float) -> None: ...
    @property
    def restitutionCoefficient(self) -> float:
        """ratio of normal speeds after and before an impact, for ``impactModel`` 1 and 2; positive, 1: elastic [1]"""
    @restitutionCoefficient.setter
    def restitutionCoefficient(self, value: float) -> None: ...
    @property
    def minimum_impact_velocity(self) -> float:
        """lower bound of the impact velocity in the restitution law; larger values damp slow and lasting contacts more [various]"""
    @minimum_impact_velocity.setter
    def minimum_impact_velocity(self, value: float) -> None: ...
    @property
    def minimumImpactVelocity(self) -> float:
        """lower bound of the impact velocity in the restitution law; larger values damp slow and lasting contacts more [various]"""
    @minimumImpactVelocity.setter
    def minimumImpactVelocity(self, value: float) -> None: ...
    @property
    def impact_model(self) -> int:
        """0: elastic contact with linear damping; 1: Hunt-Crossley, for restitution near 1; 2: Carvalho-Martins and Gonthier, for all restitution coefficients"""
    @impact_model.setter
    def impact_model(self, value: int) -> None: ...
    @property
    def impactModel(self) -> int:
        """0: elastic contact with linear damping; 1: Hunt-Crossley, for restitution near 1; 2: Carvalho-Martins and Gonthier, for all restitution coefficients"""
    @impactModel.setter
    def impactModel(self, value: int) -> None: ...
    @property
    def distance(self) -> float:
        """gap, the difference of the coordinates minus the offset; negative in contact [various]"""
    def force_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """force on one of the two bodies or markers, in global axes [3; N]"""
    def torque_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """torque on one of the two bodies or markers, in global axes [3; Nm]"""

class ObjectContactCurveCircles(ObjectHandle):
    """Handle: Contact of a planar curve with circles, as of a cam with its followers"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def marker_numbers(self) -> tuple[MarkerHandle, ...]:
        """rigid body marker that carries the curve, followed by one marker per circle [n]"""
    @marker_numbers.setter
    def marker_numbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def markerNumbers(self) -> tuple[MarkerHandle, ...]:
        """rigid body marker that carries the curve, followed by one marker per circle [n]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def node_number(self) -> NodeHandle:
        """NodeGenericData with three data coordinates per segment: number of the circle in contact, gap, tangential velocity, of the last update"""
    @node_number.setter
    def node_number(self, value: NodeIndex | int | str) -> None: ...
    @property
    def nodeNumber(self) -> NodeHandle:
        """NodeGenericData with three data coordinates per segment: number of the circle in contact, gap, tangential velocity, of the last update"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    @property
    def circles_radii(self) -> Array:
        """radius of every circle, as many as circle markers [n; m]"""
    @circles_radii.setter
    def circles_radii(self, value: ArrayLike) -> None: ...
    @property
    def circlesRadii(self) -> Array:
        """radius of every circle, as many as circle markers [n; m]"""
    @circlesRadii.setter
    def circlesRadii(self, value: ArrayLike) -> None: ...
    @property
    def segments_data(self) -> MatrixContainer:
        """one row per segment with the planar coordinates of its begin and end, [x0, y0, x1, y1], in the frame of the curve; the outer side lies to the right when going from begin to end [n x m; m]"""
    @segments_data.setter
    def segments_data(self, value: MatrixLike | None) -> None: ...
    @property
    def segmentsData(self) -> MatrixContainer:
        """one row per segment with the planar coordinates of its begin and end, [x0, y0, x1, y1], in the frame of the curve; the outer side lies to the right when going from begin to end [n x m; m]"""
    @segmentsData.setter
    def segmentsData(self, value: MatrixLike | None) -> None: ...
    @property
    def polynomial_data(self) -> MatrixContainer:
        """one row per segment with slopes at its begin and end (1) and curvatures at its begin and end (1/m), in the frame of the segment; to be left empty: segments are straight [n x m; various]"""
    @polynomial_data.setter
    def polynomial_data(self, value: MatrixLike | None) -> None: ...
    @property
    def polynomialData(self) -> MatrixContainer:
        """one row per segment with slopes at its begin and end (1) and curvatures at its begin and end (1/m), in the frame of the segment; to be left empty: segments are straight [n x m; various]"""
    @polynomialData.setter
    def polynomialData(self, value: MatrixLike | None) -> None: ...
    @property
    def rotation_marker0(self) -> Array:
        """rotation matrix from the frame of the curve, in whose x-y plane it lies, to the frame of the first marker [3 x 3; 1]"""
    @rotation_marker0.setter
    def rotation_marker0(self, value: ArrayLike) -> None: ...
    @property
    def rotationMarker0(self) -> Array:
        """rotation matrix from the frame of the curve, in whose x-y plane it lies, to the frame of the first marker [3 x 3; 1]"""
    @rotationMarker0.setter
    def rotationMarker0(self, value: ArrayLike) -> None: ...
    @property
    def dynamic_friction(self) -> float:
        """coefficient of friction in sliding [1]"""
    @dynamic_friction.setter
    def dynamic_friction(self, value: float) -> None: ...
    @property
    def dynamicFriction(self) -> float:
        """coefficient of friction in sliding [1]"""
    @dynamicFriction.setter
    def dynamicFriction(self, value: float) -> None: ...
    @property
    def friction_proportional_zone(self) -> float:
        """slip speed up to which friction is proportional to it [m/s]"""
    @friction_proportional_zone.setter
    def friction_proportional_zone(self, value: float) -> None: ...
    @property
    def frictionProportionalZone(self) -> float:
        """slip speed up to which friction is proportional to it [m/s]"""
    @frictionProportionalZone.setter
    def frictionProportionalZone(self, value: float) -> None: ...
    @property
    def contact_stiffness(self) -> float:
        """stiffness of the normal contact per length of segment [N/m^2]"""
    @contact_stiffness.setter
    def contact_stiffness(self, value: float) -> None: ...
    @property
    def contactStiffness(self) -> float:
        """stiffness of the normal contact per length of segment [N/m^2]"""
    @contactStiffness.setter
    def contactStiffness(self, value: float) -> None: ...
    @property
    def contact_damping(self) -> float:
        """damping coefficient of the normal contact per length of segment [Ns/m^2]"""
    @contact_damping.setter
    def contact_damping(self, value: float) -> None: ...
    @property
    def contactDamping(self) -> float:
        """damping coefficient of the normal contact per length of segment [Ns/m^2]"""
    @contactDamping.setter
    def contactDamping(self, value: float) -> None: ...
    @property
    def contact_model(self) -> int:
        """0: force by penetration of the segment, robust but with jumps between segments; 1: force by the area of penetration, smooth in sliding"""
    @contact_model.setter
    def contact_model(self, value: int) -> None: ...
    @property
    def contactModel(self) -> int:
        """0: force by penetration of the segment, robust but with jumps between segments; 1: force by the area of penetration, smooth in sliding"""
    @contactModel.setter
    def contactModel(self, value: int) -> None: ...
    @property
    def active_connector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @active_connector.setter
    def active_connector(self, value: bool) -> None: ...
    @property
    def activeConnector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @activeConnector.setter
    def activeConnector(self, value: bool) -> None: ...
    @property
    def displacement_local(self) -> Array:
        """smallest gap of every circle, negative in contact; size: number of circles [m]"""
    @property
    def velocity_local(self) -> Array:
        """rate of that gap of every circle; size: number of circles [m/s]"""
    @property
    def force_local(self) -> Array:
        """normal and tangential force for every circle; size: twice the number of circles [N]"""
    def force_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """force on one of the two bodies or markers, in global axes [3; N]"""
    def torque_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """torque on one of the two bodies or markers, in global axes [3; Nm]"""

class ObjectContactFrictionCircleCable2D(ObjectHandle):
    """Handle: Contact with friction of a planar cable element with a circle, such as of a belt on a pulley"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def marker_numbers(self) -> tuple[MarkerHandle, ...]:
        """marker m0 at the center of the circle and marker m1, the shape of the cable [2]"""
    @marker_numbers.setter
    def marker_numbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def markerNumbers(self) -> tuple[MarkerHandle, ...]:
        """marker m0 at the center of the circle and marker m1, the shape of the cable [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def node_number(self) -> NodeHandle:
        """NodeGenericData with three data coordinates per segment: all gaps, then all friction states (-1 and 1 slip, 0 stick, -2 undefined), then all last sticking positions; begin for instance with 0.1, -2, 0 for no contact"""
    @node_number.setter
    def node_number(self, value: NodeIndex | int | str) -> None: ...
    @property
    def nodeNumber(self) -> NodeHandle:
        """NodeGenericData with three data coordinates per segment: all gaps, then all friction states (-1 and 1 slip, 0 stick, -2 undefined), then all last sticking positions; begin for instance with 0.1, -2, 0 for no contact"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    @property
    def number_of_contact_segments(self) -> int:
        """number of segments; must be that of the shape marker"""
    @number_of_contact_segments.setter
    def number_of_contact_segments(self, value: int) -> None: ...
    @property
    def numberOfContactSegments(self) -> int:
        """number of segments; must be that of the shape marker"""
    @numberOfContactSegments.setter
    def numberOfContactSegments(self, value: int) -> None: ...
    @property
    def contact_stiffness(self) -> float:
        """contact stiffness per segment [N/m]"""
    @contact_stiffness.setter
    def contact_stiffness(self, value: float) -> None: ...
    @property
    def contactStiffness(self) -> float:
        """contact stiffness per segment [N/m]"""
    @contactStiffness.setter
    def contactStiffness(self, value: float) -> None: ...
    @property
    def contact_damping(self) -> float:
        """contact damping coefficient per segment [Ns/m]"""
    @contact_damping.setter
    def contact_damping(self, value: float) -> None: ...
    @property
    def contactDamping(self) -> float:
        """contact damping coefficient per segment [Ns/m]"""
    @contactDamping.setter
    def contactDamping(self, value: float) -> None: ...
    @property
    def friction_velocity_penalty(self) -> float:
        """tangential force per tangential velocity, per segment [Ns/m]"""
    @friction_velocity_penalty.setter
    def friction_velocity_penalty(self, value: float) -> None: ...
    @property
    def frictionVelocityPenalty(self) -> float:
        """tangential force per tangential velocity, per segment [Ns/m]"""
    @frictionVelocityPenalty.setter
    def frictionVelocityPenalty(self, value: float) -> None: ...
    @property
    def friction_stiffness(self) -> float:
        """tangential force per displacement from the last sticking position, per segment; 0: no sticking, friction by velocity only [N/m]"""
    @friction_stiffness.setter
    def friction_stiffness(self, value: float) -> None: ...
    @property
    def frictionStiffness(self) -> float:
        """tangential force per displacement from the last sticking position, per segment; 0: no sticking, friction by velocity only [N/m]"""
    @frictionStiffness.setter
    def frictionStiffness(self, value: float) -> None: ...
    @property
    def friction_coefficient(self) -> float:
        """coefficient of dry friction, the bound of the tangential to the normal force [1]"""
    @friction_coefficient.setter
    def friction_coefficient(self, value: float) -> None: ...
    @property
    def frictionCoefficient(self) -> float:
        """coefficient of dry friction, the bound of the tangential to the normal force [1]"""
    @frictionCoefficient.setter
    def frictionCoefficient(self, value: float) -> None: ...
    @property
    def circle_radius(self) -> float:
        """radius of the circle [m]"""
    @circle_radius.setter
    def circle_radius(self, value: float) -> None: ...
    @property
    def circleRadius(self) -> float:
        """radius of the circle [m]"""
    @circleRadius.setter
    def circleRadius(self, value: float) -> None: ...
    @property
    def use_segment_normals(self) -> bool:
        """True: normal and tangent are those of the segment, for segments that are long against the circle; False: those of the circle at the points of the segment, for short segments"""
    @use_segment_normals.setter
    def use_segment_normals(self, value: bool) -> None: ...
    @property
    def useSegmentNormals(self) -> bool:
        """True: normal and tangent are those of the segment, for segments that are long against the circle; False: those of the circle at the points of the segment, for short segments"""
    @useSegmentNormals.setter
    def useSegmentNormals(self, value: bool) -> None: ...
    @property
    def active_connector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @active_connector.setter
    def active_connector(self, value: bool) -> None: ...
    @property
    def activeConnector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @activeConnector.setter
    def activeConnector(self, value: bool) -> None: ...
    @property
    def limit_damping(self) -> bool:
        """True: the force is never tensile; it is zero if damping would make it tensile. False: damping also acts in tension until the gap is open"""
    @limit_damping.setter
    def limit_damping(self, value: bool) -> None: ...
    @property
    def limitDamping(self) -> bool:
        """True: the force is never tensile; it is zero if damping would make it tensile. False: damping also acts in tension until the gap is open"""
    @limitDamping.setter
    def limitDamping(self, value: bool) -> None: ...
    @property
    def coordinates(self) -> Array:
        """tangential displacement from the last sticking position and gap, in turn for every segment, 0 without contact; size: twice the number of segments [m]"""
    @property
    def coordinates_t(self) -> Array:
        """tangential and normal relative velocity, in turn for every segment, 0 without contact; size: twice the number of segments [m/s]"""
    @property
    def force_local(self) -> Array:
        """tangential and normal force, in turn for every segment; size: twice the number of segments [N]"""
    def force_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """force on one of the two bodies or markers, in global axes [3; N]"""
    def torque_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """torque on one of the two bodies or markers, in global axes [3; Nm]"""

class ObjectContactSphereSphere(ObjectHandle):
    """Handle: Contact of two spheres, or of a sphere inside a hollow sphere, with friction, restitution and adhesion"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def marker_numbers(self) -> tuple[MarkerHandle, ...]:
        """markers at the centers of the two spheres [2]"""
    @marker_numbers.setter
    def marker_numbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def markerNumbers(self) -> tuple[MarkerHandle, ...]:
        """markers at the centers of the two spheres [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def node_number(self) -> NodeHandle:
        """NodeGenericData with four data coordinates of the last update: gap, tangential speed, impact velocity, plastic overlap; initial gap positive: no contact"""
    @node_number.setter
    def node_number(self, value: NodeIndex | int | str) -> None: ...
    @property
    def nodeNumber(self) -> NodeHandle:
        """NodeGenericData with four data coordinates of the last update: gap, tangential speed, impact velocity, plastic overlap; initial gap positive: no contact"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    @property
    def spheres_radii(self) -> Array:
        """radii of the spheres at marker m0 and marker m1; must be positive [2; m]"""
    @spheres_radii.setter
    def spheres_radii(self, value: ArrayLike) -> None: ...
    @property
    def spheresRadii(self) -> Array:
        """radii of the spheres at marker m0 and marker m1; must be positive [2; m]"""
    @spheresRadii.setter
    def spheresRadii(self, value: ArrayLike) -> None: ...
    @property
    def is_hollow_sphere1(self) -> bool:
        """True: the sphere of marker m1 is hollow, and the other one touches it from inside"""
    @is_hollow_sphere1.setter
    def is_hollow_sphere1(self, value: bool) -> None: ...
    @property
    def isHollowSphere1(self) -> bool:
        """True: the sphere of marker m1 is hollow, and the other one touches it from inside"""
    @isHollowSphere1.setter
    def isHollowSphere1(self, value: bool) -> None: ...
    @property
    def dynamic_friction(self) -> float:
        """coefficient of dry friction; 0: no friction, and no torques [1]"""
    @dynamic_friction.setter
    def dynamic_friction(self, value: float) -> None: ...
    @property
    def dynamicFriction(self) -> float:
        """coefficient of dry friction; 0: no friction, and no torques [1]"""
    @dynamicFriction.setter
    def dynamicFriction(self, value: float) -> None: ...
    @property
    def friction_proportional_zone(self) -> float:
        """tangential speed up to which friction is proportional to it [m/s]"""
    @friction_proportional_zone.setter
    def friction_proportional_zone(self, value: float) -> None: ...
    @property
    def frictionProportionalZone(self) -> float:
        """tangential speed up to which friction is proportional to it [m/s]"""
    @frictionProportionalZone.setter
    def frictionProportionalZone(self, value: float) -> None: ...
    @property
    def contact_stiffness(self) -> float:
        """stiffness of the normal contact; n is ``contactStiffnessExponent`` [N/m^n]"""
    @contact_stiffness.setter
    def contact_stiffness(self, value: float) -> None: ...
    @property
    def contactStiffness(self) -> float:
        """stiffness of the normal contact; n is ``contactStiffnessExponent`` [N/m^n]"""
    @contactStiffness.setter
    def contactStiffness(self, value: float) -> None: ...
    @property
    def contact_damping(self) -> float:
        """linear damping coefficient in normal direction, added in all impact models; leave it 0 for a restitution coefficient below 1 [Ns/m]"""
    @contact_damping.setter
    def contact_damping(self, value: float) -> None: ...
    @property
    def contactDamping(self) -> float:
        """linear damping coefficient in normal direction, added in all impact models; leave it 0 for a restitution coefficient below 1 [Ns/m]"""
    @contactDamping.setter
    def contactDamping(self, value: float) -> None: ...
    @property
    def contact_stiffness_exponent(self) -> float:
        """exponent n of the penetration in the normal force; 1.5 for Hertzian contact [1]"""
    @contact_stiffness_exponent.setter
    def contact_stiffness_exponent(self, value: float) -> None: ...
    @property
    def contactStiffnessExponent(self) -> float:
        """exponent n of the penetration in the normal force; 1.5 for Hertzian contact [1]"""
    @contactStiffnessExponent.setter
    def contactStiffnessExponent(self, value: float) -> None: ...
    @property
    def constant_pull_off_force(self) -> float:
        """constant adhesive force in contact, for ``impactModel`` 0 [N]"""
    @constant_pull_off_force.setter
    def constant_pull_off_force(self, value: float) -> None: ...
    @property
    def constantPullOffForce(self) -> float:
        """constant adhesive force in contact, for ``impactModel`` 0 [N]"""
    @constantPullOffForce.setter
    def constantPullOffForce(self, value: float) -> None: ...
    @property
    def contact_plasticity_ratio(self) -> float:
        """one minus the ratio of the stiffness at first loading to that at unloading, from 0 to below 1; 0: no plastic overlap [1]"""
    @contact_plasticity_ratio.setter
    def contact_plasticity_ratio(self, value: float) -> None: ...
    @property
    def contactPlasticityRatio(self) -> float:
        """one minus the ratio of the stiffness at first loading to that at unloading, from 0 to below 1; 0: no plastic overlap [1]"""
    @contactPlasticityRatio.setter
    def contactPlasticityRatio(self, value: float) -> None: ...
    @property
    def adhesion_coefficient(self) -> float:
        """coefficient of the adhesive force that grows with penetration (N/m for an exponent of 1); 0: none. It acts in unloading after a plastic overlap, so with ``contactPlasticityRatio`` and ``impactModel`` 0 only [various]"""
    @adhesion_coefficient.setter
    def adhesion_coefficient(self, value: float) -> None: ...
    @property
    def adhesionCoefficient(self) -> float:
        """coefficient of the adhesive force that grows with penetration (N/m for an exponent of 1); 0: none. It acts in unloading after a plastic overlap, so with ``contactPlasticityRatio`` and ``impactModel`` 0 only [various]"""
    @adhesionCoefficient.setter
    def adhesionCoefficient(self, value: float) -> None: ...
    @property
    def adhesion_exponent(self) -> float:
        """exponent of the penetration in the adhesive force [1]"""
    @adhesion_exponent.setter
    def adhesion_exponent(self, value: float) -> None: ...
    @property
    def adhesionExponent(self) -> float:
        """exponent of the penetration in the adhesive force [1]"""
    @adhesionExponent.setter
    def adhesionExponent(self, value: float) -> None: ...
    @property
    def restitution_coefficient(self) -> float:
        """ratio of normal speeds after and before an impact, for ``impactModel`` 1 and 2; positive, 1: elastic [1]"""
    @restitution_coefficient.setter
    def restitution_coefficient(self, value: float) -> None: ...
    @property
    def restitutionCoefficient(self) -> float:
        """ratio of normal speeds after and before an impact, for ``impactModel`` 1 and 2; positive, 1: elastic [1]"""
    @restitutionCoefficient.setter
    def restitutionCoefficient(self, value: float) -> None: ...
    @property
    def minimum_impact_velocity(self) -> float:
        """lower bound of the impact velocity in the restitution law; larger values damp slow and lasting contacts more [m/s]"""
    @minimum_impact_velocity.setter
    def minimum_impact_velocity(self, value: float) -> None: ...
    @property
    def minimumImpactVelocity(self) -> float:
        """lower bound of the impact velocity in the restitution law; larger values damp slow and lasting contacts more [m/s]"""
    @minimumImpactVelocity.setter
    def minimumImpactVelocity(self, value: float) -> None: ...
    @property
    def impact_model(self) -> int:
        """0: elastic contact with linear damping; 1: Hunt-Crossley, for restitution near 1; 2: Carvalho-Martins and Gonthier, for all restitution coefficients"""
    @impact_model.setter
    def impact_model(self, value: int) -> None: ...
    @property
    def impactModel(self) -> int:
        """0: elastic contact with linear damping; 1: Hunt-Crossley, for restitution near 1; 2: Carvalho-Martins and Gonthier, for all restitution coefficients"""
    @impactModel.setter
    def impactModel(self, value: int) -> None: ...
    @property
    def active_connector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @active_connector.setter
    def active_connector(self, value: bool) -> None: ...
    @property
    def activeConnector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @activeConnector.setter
    def activeConnector(self, value: bool) -> None: ...
    @property
    def limit_damping(self) -> bool:
        """True: the force is never tensile; it is zero if damping would make it tensile. False: damping also acts in tension until the gap is open"""
    @limit_damping.setter
    def limit_damping(self, value: bool) -> None: ...
    @property
    def limitDamping(self) -> bool:
        """True: the force is never tensile; it is zero if damping would make it tensile. False: damping also acts in tension until the gap is open"""
    @limitDamping.setter
    def limitDamping(self, value: bool) -> None: ...
    @property
    def position(self) -> Array:
        """global contact point, in the middle of the overlap or gap [m]"""
    @property
    def displacement(self) -> Array:
        """global vector from marker m0 to marker m1 [m]"""
    @property
    def displacement_local(self) -> float:
        """gap, negative in contact [m]"""
    @property
    def velocity(self) -> Array:
        """global relative velocity of the surfaces at the contact point [m/s]"""
    @property
    def force(self) -> Array:
        """global contact force on marker m0, with friction; its negative acts on marker m1; 0 without contact [N]"""
    @property
    def director1(self) -> Array:
        """unit vector from marker m0 to the contact point [1]"""
    @property
    def torque(self) -> Array:
        """global vector whose negative is the torque of the contact force about marker m0 [Nm]"""
    def force_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """force on one of the two bodies or markers, in global axes [3; N]"""
    def torque_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """torque on one of the two bodies or markers, in global axes [3; Nm]"""

class ObjectContactSphereTorus(ObjectHandle):
    """Handle: Contact of a sphere inside the tube of a torus, as of a ball in the groove of a bearing"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def marker_numbers(self) -> tuple[MarkerHandle, ...]:
        """marker m0 at the center of the sphere and marker m1 at the center of the torus [2]"""
    @marker_numbers.setter
    def marker_numbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def markerNumbers(self) -> tuple[MarkerHandle, ...]:
        """marker m0 at the center of the sphere and marker m1 at the center of the torus [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def node_number(self) -> NodeHandle:
        """NodeGenericData with four data coordinates of the last update: gap, tangential speed, impact velocity, and one that is not used"""
    @node_number.setter
    def node_number(self, value: NodeIndex | int | str) -> None: ...
    @property
    def nodeNumber(self) -> NodeHandle:
        """NodeGenericData with four data coordinates of the last update: gap, tangential speed, impact velocity, and one that is not used"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    @property
    def radius_sphere(self) -> float:
        """radius of the sphere at marker m0 [m]"""
    @radius_sphere.setter
    def radius_sphere(self, value: float) -> None: ...
    @property
    def radiusSphere(self) -> float:
        """radius of the sphere at marker m0 [m]"""
    @radiusSphere.setter
    def radiusSphere(self, value: float) -> None: ...
    @property
    def sphere_radius(self) -> float:
        """radius of the sphere at marker m0 [m]"""
    @sphere_radius.setter
    def sphere_radius(self, value: float) -> None: ...
    @property
    def sphereRadius(self) -> float:
        """radius of the sphere at marker m0 [m]"""
    @sphereRadius.setter
    def sphereRadius(self, value: float) -> None: ...
    @property
    def torus_major_radius(self) -> float:
        """radius of the center line of the torus [m]"""
    @torus_major_radius.setter
    def torus_major_radius(self, value: float) -> None: ...
    @property
    def torusMajorRadius(self) -> float:
        """radius of the center line of the torus [m]"""
    @torusMajorRadius.setter
    def torusMajorRadius(self, value: float) -> None: ...
    @property
    def torus_minor_radius(self) -> float:
        """radius of the tube, larger than that of the sphere [m]"""
    @torus_minor_radius.setter
    def torus_minor_radius(self, value: float) -> None: ...
    @property
    def torusMinorRadius(self) -> float:
        """radius of the tube, larger than that of the sphere [m]"""
    @torusMinorRadius.setter
    def torusMinorRadius(self, value: float) -> None: ...
    @property
    def torus_axis(self) -> Array:
        """axis of the torus in the frame of marker m1, a unit vector [3; 1]"""
    @torus_axis.setter
    def torus_axis(self, value: ArrayLike | str) -> None: ...
    @property
    def torusAxis(self) -> Array:
        """axis of the torus in the frame of marker m1, a unit vector [3; 1]"""
    @torusAxis.setter
    def torusAxis(self, value: ArrayLike | str) -> None: ...
    @property
    def dynamic_friction(self) -> float:
        """coefficient of dry friction [1]"""
    @dynamic_friction.setter
    def dynamic_friction(self, value: float) -> None: ...
    @property
    def dynamicFriction(self) -> float:
        """coefficient of dry friction [1]"""
    @dynamicFriction.setter
    def dynamicFriction(self, value: float) -> None: ...
    @property
    def friction_proportional_zone(self) -> float:
        """tangential speed up to which friction is proportional to it [m/s]"""
    @friction_proportional_zone.setter
    def friction_proportional_zone(self, value: float) -> None: ...
    @property
    def frictionProportionalZone(self) -> float:
        """tangential speed up to which friction is proportional to it [m/s]"""
    @frictionProportionalZone.setter
    def frictionProportionalZone(self, value: float) -> None: ...
    @property
    def contact_stiffness(self) -> float:
        """stiffness of the normal contact; n is ``contactStiffnessExponent`` [N/m^n]"""
    @contact_stiffness.setter
    def contact_stiffness(self, value: float) -> None: ...
    @property
    def contactStiffness(self) -> float:
        """stiffness of the normal contact; n is ``contactStiffnessExponent`` [N/m^n]"""
    @contactStiffness.setter
    def contactStiffness(self, value: float) -> None: ...
    @property
    def contact_damping(self) -> float:
        """linear damping coefficient in normal direction, added in all impact models; leave it 0 for a restitution coefficient below 1 [Ns/m]"""
    @contact_damping.setter
    def contact_damping(self, value: float) -> None: ...
    @property
    def contactDamping(self) -> float:
        """linear damping coefficient in normal direction, added in all impact models; leave it 0 for a restitution coefficient below 1 [Ns/m]"""
    @contactDamping.setter
    def contactDamping(self, value: float) -> None: ...
    @property
    def contact_stiffness_exponent(self) -> float:
        """exponent n of the penetration in the normal force; 1.5 for Hertzian contact [1]"""
    @contact_stiffness_exponent.setter
    def contact_stiffness_exponent(self, value: float) -> None: ...
    @property
    def contactStiffnessExponent(self) -> float:
        """exponent n of the penetration in the normal force; 1.5 for Hertzian contact [1]"""
    @contactStiffnessExponent.setter
    def contactStiffnessExponent(self, value: float) -> None: ...
    @property
    def restitution_coefficient(self) -> float:
        """ratio of normal speeds after and before an impact, for ``impactModel`` 1 and 2; positive, 1: elastic [1]"""
    @restitution_coefficient.setter
    def restitution_coefficient(self, value: float) -> None: ...
    @property
    def restitutionCoefficient(self) -> float:
        """ratio of normal speeds after and before an impact, for ``impactModel`` 1 and 2; positive, 1: elastic [1]"""
    @restitutionCoefficient.setter
    def restitutionCoefficient(self, value: float) -> None: ...
    @property
    def minimum_impact_velocity(self) -> float:
        """lower bound of the impact velocity in the restitution law; larger values damp slow and lasting contacts more [m/s]"""
    @minimum_impact_velocity.setter
    def minimum_impact_velocity(self, value: float) -> None: ...
    @property
    def minimumImpactVelocity(self) -> float:
        """lower bound of the impact velocity in the restitution law; larger values damp slow and lasting contacts more [m/s]"""
    @minimumImpactVelocity.setter
    def minimumImpactVelocity(self, value: float) -> None: ...
    @property
    def impact_model(self) -> int:
        """0: elastic contact with linear damping; 1: Hunt-Crossley, for restitution near 1; 2: Carvalho-Martins and Gonthier, for all restitution coefficients"""
    @impact_model.setter
    def impact_model(self, value: int) -> None: ...
    @property
    def impactModel(self) -> int:
        """0: elastic contact with linear damping; 1: Hunt-Crossley, for restitution near 1; 2: Carvalho-Martins and Gonthier, for all restitution coefficients"""
    @impactModel.setter
    def impactModel(self, value: int) -> None: ...
    @property
    def active_connector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @active_connector.setter
    def active_connector(self, value: bool) -> None: ...
    @property
    def activeConnector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @activeConnector.setter
    def activeConnector(self, value: bool) -> None: ...
    @property
    def limit_damping(self) -> bool:
        """True: the force is never tensile; it is zero if damping would make it tensile. False: damping also acts in tension until the gap is open"""
    @limit_damping.setter
    def limit_damping(self, value: bool) -> None: ...
    @property
    def limitDamping(self) -> bool:
        """True: the force is never tensile; it is zero if damping would make it tensile. False: damping also acts in tension until the gap is open"""
    @limitDamping.setter
    def limitDamping(self, value: bool) -> None: ...
    @property
    def position(self) -> Array:
        """global contact point, in the middle of the overlap or gap [m]"""
    @property
    def displacement(self) -> Array:
        """global vector from marker m0 to marker m1 [m]"""
    @property
    def displacement_local(self) -> float:
        """gap, negative in contact [m]"""
    @property
    def director1(self) -> Array:
        """unit vector from marker m0 to marker m1 [1]"""
    @property
    def director2(self) -> Array:
        """unit vector from the center of the torus to the nearest point of its center line [1]"""
    @property
    def director3(self) -> Array:
        """contact normal, unit vector from the center line of the torus to the center of the sphere [1]"""
    @property
    def force(self) -> Array:
        """global contact force on marker m0, with friction; its negative acts on marker m1; 0 without contact [N]"""
    @property
    def torque(self) -> Array:
        """global vector whose negative is the torque of the contact force about marker m0 [Nm]"""
    @property
    def velocity(self) -> Array:
        """global velocity of the torus relative to the sphere at the contact point [m/s]"""
    def force_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """force on one of the two bodies or markers, in global axes [3; N]"""
    def torque_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """torque on one of the two bodies or markers, in global axes [3; Nm]"""

class ObjectContactSphereTriangle(ObjectHandle):
    """Handle: Contact of a sphere with a triangle, its face and chosen edges"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def marker_numbers(self) -> tuple[MarkerHandle, ...]:
        """marker m0 at the center of the sphere and marker m1 on the body that carries the triangle [2]"""
    @marker_numbers.setter
    def marker_numbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def markerNumbers(self) -> tuple[MarkerHandle, ...]:
        """marker m0 at the center of the sphere and marker m1 on the body that carries the triangle [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def node_number(self) -> NodeHandle:
        """NodeGenericData with four data coordinates of the last update: gap, tangential speed, impact velocity, and one that is not used"""
    @node_number.setter
    def node_number(self, value: NodeIndex | int | str) -> None: ...
    @property
    def nodeNumber(self) -> NodeHandle:
        """NodeGenericData with four data coordinates of the last update: gap, tangential speed, impact velocity, and one that is not used"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    @property
    def radius_sphere(self) -> float:
        """radius of the sphere at marker m0 [m]"""
    @radius_sphere.setter
    def radius_sphere(self, value: float) -> None: ...
    @property
    def radiusSphere(self) -> float:
        """radius of the sphere at marker m0 [m]"""
    @radiusSphere.setter
    def radiusSphere(self, value: float) -> None: ...
    @property
    def sphere_radius(self) -> float:
        """radius of the sphere at marker m0 [m]"""
    @sphere_radius.setter
    def sphere_radius(self, value: float) -> None: ...
    @property
    def sphereRadius(self) -> float:
        """radius of the sphere at marker m0 [m]"""
    @sphereRadius.setter
    def sphereRadius(self, value: float) -> None: ...
    @property
    def triangle_points(self) -> Vector3DList:
        """three points in the frame of marker m1 [n x 3; m]"""
    @triangle_points.setter
    def triangle_points(self, value: Sequence[ArrayLike] | Vector3DList) -> None: ...
    @property
    def trianglePoints(self) -> Vector3DList:
        """three points in the frame of marker m1 [n x 3; m]"""
    @trianglePoints.setter
    def trianglePoints(self, value: Sequence[ArrayLike] | Vector3DList) -> None: ...
    @property
    def include_edges(self) -> int:
        """sum of 1, 2 and 4 for contact with edge 0 (points 0 and 1), edge 1 (points 1 and 2) and edge 2 (points 2 and 0); 7: all edges; edges between triangles of a smooth surface are left out"""
    @include_edges.setter
    def include_edges(self, value: int) -> None: ...
    @property
    def includeEdges(self) -> int:
        """sum of 1, 2 and 4 for contact with edge 0 (points 0 and 1), edge 1 (points 1 and 2) and edge 2 (points 2 and 0); 7: all edges; edges between triangles of a smooth surface are left out"""
    @includeEdges.setter
    def includeEdges(self, value: int) -> None: ...
    @property
    def dynamic_friction(self) -> float:
        """coefficient of dry friction; 0: no friction, and no torques [1]"""
    @dynamic_friction.setter
    def dynamic_friction(self, value: float) -> None: ...
    @property
    def dynamicFriction(self) -> float:
        """coefficient of dry friction; 0: no friction, and no torques [1]"""
    @dynamicFriction.setter
    def dynamicFriction(self, value: float) -> None: ...
    @property
    def friction_proportional_zone(self) -> float:
        """tangential speed up to which friction is proportional to it [m/s]"""
    @friction_proportional_zone.setter
    def friction_proportional_zone(self, value: float) -> None: ...
    @property
    def frictionProportionalZone(self) -> float:
        """tangential speed up to which friction is proportional to it [m/s]"""
    @frictionProportionalZone.setter
    def frictionProportionalZone(self, value: float) -> None: ...
    @property
    def contact_stiffness(self) -> float:
        """stiffness of the normal contact; n is ``contactStiffnessExponent`` [N/m^n]"""
    @contact_stiffness.setter
    def contact_stiffness(self, value: float) -> None: ...
    @property
    def contactStiffness(self) -> float:
        """stiffness of the normal contact; n is ``contactStiffnessExponent`` [N/m^n]"""
    @contactStiffness.setter
    def contactStiffness(self, value: float) -> None: ...
    @property
    def contact_damping(self) -> float:
        """linear damping coefficient in normal direction, added in all impact models; leave it 0 for a restitution coefficient below 1 [Ns/m]"""
    @contact_damping.setter
    def contact_damping(self, value: float) -> None: ...
    @property
    def contactDamping(self) -> float:
        """linear damping coefficient in normal direction, added in all impact models; leave it 0 for a restitution coefficient below 1 [Ns/m]"""
    @contactDamping.setter
    def contactDamping(self, value: float) -> None: ...
    @property
    def contact_stiffness_exponent(self) -> float:
        """exponent n of the penetration in the normal force; 1.5 for Hertzian contact [1]"""
    @contact_stiffness_exponent.setter
    def contact_stiffness_exponent(self, value: float) -> None: ...
    @property
    def contactStiffnessExponent(self) -> float:
        """exponent n of the penetration in the normal force; 1.5 for Hertzian contact [1]"""
    @contactStiffnessExponent.setter
    def contactStiffnessExponent(self, value: float) -> None: ...
    @property
    def restitution_coefficient(self) -> float:
        """ratio of normal speeds after and before an impact, for ``impactModel`` 1 and 2; positive, 1: elastic [1]"""
    @restitution_coefficient.setter
    def restitution_coefficient(self, value: float) -> None: ...
    @property
    def restitutionCoefficient(self) -> float:
        """ratio of normal speeds after and before an impact, for ``impactModel`` 1 and 2; positive, 1: elastic [1]"""
    @restitutionCoefficient.setter
    def restitutionCoefficient(self, value: float) -> None: ...
    @property
    def minimum_impact_velocity(self) -> float:
        """lower bound of the impact velocity in the restitution law; larger values damp slow and lasting contacts more [m/s]"""
    @minimum_impact_velocity.setter
    def minimum_impact_velocity(self, value: float) -> None: ...
    @property
    def minimumImpactVelocity(self) -> float:
        """lower bound of the impact velocity in the restitution law; larger values damp slow and lasting contacts more [m/s]"""
    @minimumImpactVelocity.setter
    def minimumImpactVelocity(self, value: float) -> None: ...
    @property
    def impact_model(self) -> int:
        """0: elastic contact with linear damping; 1: Hunt-Crossley, for restitution near 1; 2: Carvalho-Martins and Gonthier, for all restitution coefficients"""
    @impact_model.setter
    def impact_model(self, value: int) -> None: ...
    @property
    def impactModel(self) -> int:
        """0: elastic contact with linear damping; 1: Hunt-Crossley, for restitution near 1; 2: Carvalho-Martins and Gonthier, for all restitution coefficients"""
    @impactModel.setter
    def impactModel(self, value: int) -> None: ...
    @property
    def active_connector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @active_connector.setter
    def active_connector(self, value: bool) -> None: ...
    @property
    def activeConnector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @activeConnector.setter
    def activeConnector(self, value: bool) -> None: ...
    @property
    def limit_damping(self) -> bool:
        """True: the force is never tensile; it is zero if damping would make it tensile. False: damping also acts in tension until the gap is open"""
    @limit_damping.setter
    def limit_damping(self, value: bool) -> None: ...
    @property
    def limitDamping(self) -> bool:
        """True: the force is never tensile; it is zero if damping would make it tensile. False: damping also acts in tension until the gap is open"""
    @limitDamping.setter
    def limitDamping(self, value: bool) -> None: ...
    @property
    def position(self) -> Array:
        """global contact point, in the middle of the overlap or gap [m]"""
    @property
    def displacement(self) -> Array:
        """global vector from marker m0 to the nearest point of the triangle [m]"""
    @property
    def displacement_local(self) -> float:
        """gap, negative in contact [m]"""
    @property
    def director1(self) -> Array:
        """unit vector from marker m0 to the nearest point of the triangle [1]"""
    @property
    def force(self) -> Array:
        """global contact force on marker m0, with friction; its negative acts on marker m1; 0 without contact [N]"""
    @property
    def torque(self) -> Array:
        """global vector whose negative is the torque of the contact force about marker m0 [Nm]"""
    @property
    def velocity(self) -> Array:
        """global velocity of the nearest point of the triangle relative to the center of the sphere [m/s]"""
    def force_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """force on one of the two bodies or markers, in global axes [3; N]"""
    def torque_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """torque on one of the two bodies or markers, in global axes [3; Nm]"""

class ObjectJointALEMoving2D(ObjectHandle):
    """Handle: A body attached to an axially moving ANCF cable, whose sliding coordinate is shared by all elements of the cable"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def marker_numbers(self) -> tuple[MarkerHandle, ...]:
        """marker m0 of the sliding body, and marker m1 of the cable element on which it begins, one of ``slidingMarkerNumbers``; the data node has the current element [2]"""
    @marker_numbers.setter
    def marker_numbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def markerNumbers(self) -> tuple[MarkerHandle, ...]:
        """marker m0 of the sliding body, and marker m1 of the cable element on which it begins, one of ``slidingMarkerNumbers``; the data node has the current element [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def sliding_marker_numbers(self) -> tuple[MarkerHandle, ...]:
        """coordinate markers of all cable elements in the order in which they follow each other: the end of one element is the begin of the next [n]"""
    @sliding_marker_numbers.setter
    def sliding_marker_numbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def slidingMarkerNumbers(self) -> tuple[MarkerHandle, ...]:
        """coordinate markers of all cable elements in the order in which they follow each other: the end of one element is the begin of the next [n]"""
    @slidingMarkerNumbers.setter
    def slidingMarkerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def sliding_marker_offsets(self) -> Array:
        """for each of these elements, the sum of the reference lengths of all elements before it; the first is 0; one for each of ``slidingMarkerNumbers`` [n; m]"""
    @sliding_marker_offsets.setter
    def sliding_marker_offsets(self, value: ArrayLike) -> None: ...
    @property
    def slidingMarkerOffsets(self) -> Array:
        """for each of these elements, the sum of the reference lengths of all elements before it; the first is 0; one for each of ``slidingMarkerNumbers`` [n; m]"""
    @slidingMarkerOffsets.setter
    def slidingMarkerOffsets(self, value: ArrayLike) -> None: ...
    @property
    def sliding_offset(self) -> float:
        """reference arc length that is added to the sliding coordinate [m]"""
    @sliding_offset.setter
    def sliding_offset(self, value: float) -> None: ...
    @property
    def slidingOffset(self) -> float:
        """reference arc length that is added to the sliding coordinate [m]"""
    @slidingOffset.setter
    def slidingOffset(self, value: float) -> None: ...
    @property
    def node_numbers(self) -> tuple[NodeHandle, ...]:
        """NodeGenericData with one data coordinate (index of the current element), and the NodeGenericODE2 with the sliding coordinate of the cable, the third node of its elements [2]"""
    @node_numbers.setter
    def node_numbers(self, value: Sequence[NodeIndex | int | str]) -> None: ...
    @property
    def nodeNumbers(self) -> tuple[NodeHandle, ...]:
        """NodeGenericData with one data coordinate (index of the current element), and the NodeGenericODE2 with the sliding coordinate of the cable, the third node of its elements [2]"""
    @nodeNumbers.setter
    def nodeNumbers(self, value: Sequence[NodeIndex | int | str]) -> None: ...
    @property
    def use_penalty_formulation(self) -> bool:
        """True: the constraint is softened by ``penaltyStiffness``, still with multipliers as unknowns"""
    @use_penalty_formulation.setter
    def use_penalty_formulation(self, value: bool) -> None: ...
    @property
    def usePenaltyFormulation(self) -> bool:
        """True: the constraint is softened by ``penaltyStiffness``, still with multipliers as unknowns"""
    @usePenaltyFormulation.setter
    def usePenaltyFormulation(self, value: bool) -> None: ...
    @property
    def penalty_stiffness(self) -> float:
        """stiffness of the softened constraint [N/m]"""
    @penalty_stiffness.setter
    def penalty_stiffness(self, value: float) -> None: ...
    @property
    def penaltyStiffness(self) -> float:
        """stiffness of the softened constraint [N/m]"""
    @penaltyStiffness.setter
    def penaltyStiffness(self, value: float) -> None: ...
    @property
    def active_connector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @active_connector.setter
    def active_connector(self, value: bool) -> None: ...
    @property
    def activeConnector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @activeConnector.setter
    def activeConnector(self, value: bool) -> None: ...
    @property
    def position(self) -> Array:
        """global position of marker m0 [m]"""
    @property
    def velocity(self) -> Array:
        """global velocity of marker m0 [m/s]"""
    @property
    def sliding_coordinate(self) -> float:
        """sliding coordinate of the cable plus offset; without its reference coordinate [m]"""
    @property
    def coordinates(self) -> Array:
        """index of the current element (1), and sliding coordinate of the cable (m) [various]"""
    @property
    def coordinates_t(self) -> float:
        """sliding velocity of the cable [m/s]"""
    @property
    def force(self) -> Array:
        """Lagrange multipliers, the global joint force; the third value is 0 [N]"""
    def force_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """force on one of the two bodies or markers, in global axes [3; N]"""
    def torque_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """torque on one of the two bodies or markers, in global axes [3; Nm]"""

class ObjectJointGeneric(ObjectHandle):
    """Handle: A joint between two rigid body markers that constrains any choice of three translations and three rotations"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def marker_numbers(self) -> tuple[MarkerHandle, ...]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @marker_numbers.setter
    def marker_numbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def markerNumbers(self) -> tuple[MarkerHandle, ...]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def constrained_axes(self) -> tuple[int, ...]:
        """six flags, 1 constrained and 0 free: translation along the x, y, z axis of frame J0, rotation about them; other values are refused [6]"""
    @constrained_axes.setter
    def constrained_axes(self, value: Sequence[int]) -> None: ...
    @property
    def constrainedAxes(self) -> tuple[int, ...]:
        """six flags, 1 constrained and 0 free: translation along the x, y, z axis of frame J0, rotation about them; other values are refused [6]"""
    @constrainedAxes.setter
    def constrainedAxes(self, value: Sequence[int]) -> None: ...
    @property
    def rotation_marker0(self) -> Array:
        """rotation matrix from joint frame J0 to the frame of marker m0; turns the axes of the joint [3 x 3; 1]"""
    @rotation_marker0.setter
    def rotation_marker0(self, value: ArrayLike) -> None: ...
    @property
    def rotationMarker0(self) -> Array:
        """rotation matrix from joint frame J0 to the frame of marker m0; turns the axes of the joint [3 x 3; 1]"""
    @rotationMarker0.setter
    def rotationMarker0(self, value: ArrayLike) -> None: ...
    @property
    def rotation_marker1(self) -> Array:
        """rotation matrix from joint frame J1 to the frame of marker m1; the joint is in its zero position if J0 and J1 are parallel [3 x 3; 1]"""
    @rotation_marker1.setter
    def rotation_marker1(self, value: ArrayLike) -> None: ...
    @property
    def rotationMarker1(self) -> Array:
        """rotation matrix from joint frame J1 to the frame of marker m1; the joint is in its zero position if J0 and J1 are parallel [3 x 3; 1]"""
    @rotationMarker1.setter
    def rotationMarker1(self, value: ArrayLike) -> None: ...
    @property
    def active_connector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @active_connector.setter
    def active_connector(self, value: bool) -> None: ...
    @property
    def activeConnector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @activeConnector.setter
    def activeConnector(self, value: bool) -> None: ...
    @property
    def offset_user_function_parameters(self) -> Array:
        """six values that are passed to the user functions, of free meaning [6; various]"""
    @offset_user_function_parameters.setter
    def offset_user_function_parameters(self, value: ArrayLike) -> None: ...
    @property
    def offsetUserFunctionParameters(self) -> Array:
        """six values that are passed to the user functions, of free meaning [6; various]"""
    @offsetUserFunctionParameters.setter
    def offsetUserFunctionParameters(self, value: ArrayLike) -> None: ...
    @property
    def offset_user_function(self) -> Callable[[MainSystem, float, int, Array], ArrayLike] | Literal[0]:
        """Python function that prescribes relative translation and rotation in the constrained directions, on position level"""
    @offset_user_function.setter
    def offset_user_function(self, value: Callable[[MainSystem, float, int, Array], ArrayLike] | Literal[0]) -> None: ...
    @property
    def offsetUserFunction(self) -> Callable[[MainSystem, float, int, Array], ArrayLike] | Literal[0]:
        """Python function that prescribes relative translation and rotation in the constrained directions, on position level"""
    @offsetUserFunction.setter
    def offsetUserFunction(self, value: Callable[[MainSystem, float, int, Array], ArrayLike] | Literal[0]) -> None: ...
    @property
    def offset_user_function_t(self) -> Callable[[MainSystem, float, int, Array], ArrayLike] | Literal[0]:
        """Python function, the time derivative of ``offsetUserFunction``; index 2 integrators follow it alone"""
    @offset_user_function_t.setter
    def offset_user_function_t(self, value: Callable[[MainSystem, float, int, Array], ArrayLike] | Literal[0]) -> None: ...
    @property
    def offsetUserFunction_t(self) -> Callable[[MainSystem, float, int, Array], ArrayLike] | Literal[0]:
        """Python function, the time derivative of ``offsetUserFunction``; index 2 integrators follow it alone"""
    @offsetUserFunction_t.setter
    def offsetUserFunction_t(self, value: Callable[[MainSystem, float, int, Array], ArrayLike] | Literal[0]) -> None: ...
    @property
    def alternative_constraints(self) -> bool:
        """True: other equations for three constrained rotations, which keep static solutions from flipping by half a turn; experimental"""
    @alternative_constraints.setter
    def alternative_constraints(self, value: bool) -> None: ...
    @property
    def alternativeConstraints(self) -> bool:
        """True: other equations for three constrained rotations, which keep static solutions from flipping by half a turn; experimental"""
    @alternativeConstraints.setter
    def alternativeConstraints(self, value: bool) -> None: ...
    @property
    def position(self) -> Array:
        """global position of marker m0 [m]"""
    @property
    def velocity(self) -> Array:
        """global velocity of marker m0 [m/s]"""
    @property
    def displacement_local(self) -> Array:
        """position of marker m1 relative to marker m0 in frame J0; constrained components show the error of the constraint [m]"""
    @property
    def velocity_local(self) -> Array:
        """global velocity of marker m1 minus that of marker m0, in frame J0 [m/s]"""
    @property
    def rotation(self) -> Array:
        """Tait-Bryan angles (about x, y, z in turn) of J1 relative to J0; the angle of rotation for a single free axis [rad]"""
    @property
    def angular_velocity_local(self) -> Array:
        """angular velocity of marker m1 relative to marker m0, in frame J0 [rad/s]"""
    @property
    def force_local(self) -> Array:
        """Lagrange multipliers of the translations in frame J0: the force on marker m0; 0 in free directions [N]"""
    @property
    def torque_local(self) -> Array:
        """Lagrange multipliers of the rotations in the order of the equations, signs and axes as given there; 0 where there is no equation [Nm]"""
    @property
    def homogeneous_transformation(self) -> HT:
        """position and rotation of joint frame J0 as a 4 x 4 matrix, row by row; output functions return ``exu.HT`` [various]"""
    @property
    def homogeneous_transformation_local(self) -> HT:
        """relative position and rotation of joint frame J1 in joint frame J0 as a 4 x 4 matrix, row by row; output functions return ``exu.HT`` [various]"""
    @property
    def force(self) -> Array:
        """force on the first body, in global axes [3; N]"""
    @property
    def torque(self) -> Array:
        """torque on the first body, in global axes [3; Nm]"""
    def force_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """force on one of the two bodies or markers, in global axes [3; N]"""
    def torque_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """torque on one of the two bodies or markers, in global axes [3; Nm]"""

class ObjectJointPrismatic2D(ObjectHandle):
    """Handle: A prismatic joint of planar bodies: one point moves on a line that is fixed to the other body"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def marker_numbers(self) -> tuple[MarkerHandle, ...]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @marker_numbers.setter
    def marker_numbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def markerNumbers(self) -> tuple[MarkerHandle, ...]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def axis_marker0(self) -> Array:
        """direction of the axis in the frame of marker m0, a unit vector in the x-y plane [3; 1]"""
    @axis_marker0.setter
    def axis_marker0(self, value: ArrayLike | str) -> None: ...
    @property
    def axisMarker0(self) -> Array:
        """direction of the axis in the frame of marker m0, a unit vector in the x-y plane [3; 1]"""
    @axisMarker0.setter
    def axisMarker0(self, value: ArrayLike | str) -> None: ...
    @property
    def normal_marker1(self) -> Array:
        """normal of the axis in the frame of marker m1, a unit vector in the x-y plane; perpendicular to the axis in the initial position [3; 1]"""
    @normal_marker1.setter
    def normal_marker1(self, value: ArrayLike | str) -> None: ...
    @property
    def normalMarker1(self) -> Array:
        """normal of the axis in the frame of marker m1, a unit vector in the x-y plane; perpendicular to the axis in the initial position [3; 1]"""
    @normalMarker1.setter
    def normalMarker1(self, value: ArrayLike | str) -> None: ...
    @property
    def constrain_rotation(self) -> bool:
        """True: the bodies do not rotate relative to each other; False: relative rotation is free"""
    @constrain_rotation.setter
    def constrain_rotation(self, value: bool) -> None: ...
    @property
    def constrainRotation(self) -> bool:
        """True: the bodies do not rotate relative to each other; False: relative rotation is free"""
    @constrainRotation.setter
    def constrainRotation(self, value: bool) -> None: ...
    @property
    def active_connector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @active_connector.setter
    def active_connector(self, value: bool) -> None: ...
    @property
    def activeConnector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @activeConnector.setter
    def activeConnector(self, value: bool) -> None: ...
    @property
    def position(self) -> Array:
        """global position of marker m0 [m]"""
    @property
    def velocity(self) -> Array:
        """global velocity of marker m0 [m/s]"""
    @property
    def displacement_local(self) -> Array:
        """position of marker m1 relative to marker m0 in the axes of marker m0 [m]"""
    @property
    def distance(self) -> float:
        """component of DisplacementLocal along ``axisMarker0`` [m]"""
    @property
    def rotation(self) -> float:
        """angle of marker m1 relative to marker m0, the error of the constraint for rotations [rad]"""
    @property
    def force_local(self) -> Array:
        """joint force on marker m0 in its axes [N]"""
    @property
    def homogeneous_transformation(self) -> HT:
        """position and rotation of marker m0 as a 4 x 4 matrix, row by row; output functions return ``exu.HT`` [various]"""
    @property
    def homogeneous_transformation_local(self) -> HT:
        """relative position and rotation of marker m1 in the axes of marker m0 as a 4 x 4 matrix, row by row; output functions return ``exu.HT`` [various]"""
    @property
    def force(self) -> Array:
        """force on the first body, in global axes [3; N]"""
    def force_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """force on one of the two bodies or markers, in global axes [3; N]"""
    def torque_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """torque on one of the two bodies or markers, in global axes [3; Nm]"""

class ObjectJointPrismaticX(ObjectHandle):
    """Handle: A prismatic joint between two rigid body markers, free to translate along the x axis of the joint frame"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def marker_numbers(self) -> tuple[MarkerHandle, ...]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @marker_numbers.setter
    def marker_numbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def markerNumbers(self) -> tuple[MarkerHandle, ...]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def rotation_marker0(self) -> Array:
        """rotation matrix from joint frame J0 to the frame of marker m0; turns the axes of the joint [3 x 3; 1]"""
    @rotation_marker0.setter
    def rotation_marker0(self, value: ArrayLike) -> None: ...
    @property
    def rotationMarker0(self) -> Array:
        """rotation matrix from joint frame J0 to the frame of marker m0; turns the axes of the joint [3 x 3; 1]"""
    @rotationMarker0.setter
    def rotationMarker0(self, value: ArrayLike) -> None: ...
    @property
    def rotation_marker1(self) -> Array:
        """rotation matrix from joint frame J1 to the frame of marker m1; the joint is in its zero position if J0 and J1 are parallel [3 x 3; 1]"""
    @rotation_marker1.setter
    def rotation_marker1(self, value: ArrayLike) -> None: ...
    @property
    def rotationMarker1(self) -> Array:
        """rotation matrix from joint frame J1 to the frame of marker m1; the joint is in its zero position if J0 and J1 are parallel [3 x 3; 1]"""
    @rotationMarker1.setter
    def rotationMarker1(self, value: ArrayLike) -> None: ...
    @property
    def active_connector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @active_connector.setter
    def active_connector(self, value: bool) -> None: ...
    @property
    def activeConnector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @activeConnector.setter
    def activeConnector(self, value: bool) -> None: ...
    @property
    def position(self) -> Array:
        """global position of marker m0 [m]"""
    @property
    def velocity(self) -> Array:
        """global velocity of marker m0 [m/s]"""
    @property
    def displacement_local(self) -> Array:
        """position of marker m1 relative to marker m0 in frame J0; constrained components show the error of the constraint [m]"""
    @property
    def velocity_local(self) -> Array:
        """global velocity of marker m1 minus that of marker m0, in frame J0 [m/s]"""
    @property
    def rotation(self) -> Array:
        """Tait-Bryan angles (about x, y, z in turn) of J1 relative to J0, the error of the constraint [rad]"""
    @property
    def angular_velocity_local(self) -> Array:
        """angular velocity of marker m1 relative to marker m0, in frame J0 [rad/s]"""
    @property
    def force_local(self) -> Array:
        """joint force on marker m0, in frame J0; the first value is 0 [N]"""
    @property
    def torque_local(self) -> Array:
        """Lagrange multipliers of the three rotations: about the x axis, the negative y axis and the negative z axis [Nm]"""
    @property
    def homogeneous_transformation(self) -> HT:
        """position and rotation of joint frame J0 as a 4 x 4 matrix, row by row; output functions return ``exu.HT`` [various]"""
    @property
    def homogeneous_transformation_local(self) -> HT:
        """relative position and rotation of joint frame J1 in joint frame J0 as a 4 x 4 matrix, row by row; output functions return ``exu.HT`` [various]"""
    @property
    def force(self) -> Array:
        """force on the first body, in global axes [3; N]"""
    @property
    def torque(self) -> Array:
        """torque on the first body, in global axes [3; Nm]"""
    def force_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """force on one of the two bodies or markers, in global axes [3; N]"""
    def torque_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """torque on one of the two bodies or markers, in global axes [3; Nm]"""

class ObjectJointRevolute2D(ObjectHandle):
    """Handle: A revolute joint of planar bodies: keeps two points together in the x-y plane"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def marker_numbers(self) -> tuple[MarkerHandle, ...]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @marker_numbers.setter
    def marker_numbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def markerNumbers(self) -> tuple[MarkerHandle, ...]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def active_connector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @active_connector.setter
    def active_connector(self, value: bool) -> None: ...
    @property
    def activeConnector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @activeConnector.setter
    def activeConnector(self, value: bool) -> None: ...
    @property
    def position(self) -> Array:
        """global position of marker m0 [m]"""
    @property
    def velocity(self) -> Array:
        """global velocity of marker m0 [m/s]"""
    @property
    def displacement(self) -> Array:
        """global position of marker m1 relative to marker m0, the error of the constraint [m]"""
    @property
    def force(self) -> Array:
        """Lagrange multipliers, the global joint force on marker m0; the third value is 0 [N]"""
    def force_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """force on one of the two bodies or markers, in global axes [3; N]"""
    def torque_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """torque on one of the two bodies or markers, in global axes [3; Nm]"""

class ObjectJointRevoluteZ(ObjectHandle):
    """Handle: A revolute joint between two rigid body markers, free to rotate about the z axis of the joint frame"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def marker_numbers(self) -> tuple[MarkerHandle, ...]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @marker_numbers.setter
    def marker_numbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def markerNumbers(self) -> tuple[MarkerHandle, ...]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def rotation_marker0(self) -> Array:
        """rotation matrix from joint frame J0 to the frame of marker m0; turns the axes of the joint [3 x 3; 1]"""
    @rotation_marker0.setter
    def rotation_marker0(self, value: ArrayLike) -> None: ...
    @property
    def rotationMarker0(self) -> Array:
        """rotation matrix from joint frame J0 to the frame of marker m0; turns the axes of the joint [3 x 3; 1]"""
    @rotationMarker0.setter
    def rotationMarker0(self, value: ArrayLike) -> None: ...
    @property
    def rotation_marker1(self) -> Array:
        """rotation matrix from joint frame J1 to the frame of marker m1; the joint is in its zero position if J0 and J1 are parallel [3 x 3; 1]"""
    @rotation_marker1.setter
    def rotation_marker1(self, value: ArrayLike) -> None: ...
    @property
    def rotationMarker1(self) -> Array:
        """rotation matrix from joint frame J1 to the frame of marker m1; the joint is in its zero position if J0 and J1 are parallel [3 x 3; 1]"""
    @rotationMarker1.setter
    def rotationMarker1(self, value: ArrayLike) -> None: ...
    @property
    def active_connector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @active_connector.setter
    def active_connector(self, value: bool) -> None: ...
    @property
    def activeConnector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @activeConnector.setter
    def activeConnector(self, value: bool) -> None: ...
    @property
    def position(self) -> Array:
        """global position of marker m0 [m]"""
    @property
    def velocity(self) -> Array:
        """global velocity of marker m0 [m/s]"""
    @property
    def displacement_local(self) -> Array:
        """position of marker m1 relative to marker m0 in frame J0; constrained components show the error of the constraint [m]"""
    @property
    def velocity_local(self) -> Array:
        """global velocity of marker m1 minus that of marker m0, in frame J0 [m/s]"""
    @property
    def rotation(self) -> Array:
        """Tait-Bryan angles (about x, y, z in turn) of J1 relative to J0; the third one is the angle of the joint, the others show the error of the constraint [rad]"""
    @property
    def angular_velocity_local(self) -> Array:
        """angular velocity of marker m1 relative to marker m0, in frame J0 [rad/s]"""
    @property
    def force_local(self) -> Array:
        """joint force on marker m0, in frame J0 [N]"""
    @property
    def torque_local(self) -> Array:
        """Lagrange multipliers of the two rotations, the first one about the negative y axis, the second one about the x axis; the third value is 0 [Nm]"""
    @property
    def homogeneous_transformation(self) -> HT:
        """position and rotation of joint frame J0 as a 4 x 4 matrix, row by row; output functions return ``exu.HT`` [various]"""
    @property
    def homogeneous_transformation_local(self) -> HT:
        """relative position and rotation of joint frame J1 in joint frame J0 as a 4 x 4 matrix, row by row; output functions return ``exu.HT`` [various]"""
    @property
    def force(self) -> Array:
        """force on the first body, in global axes [3; N]"""
    @property
    def torque(self) -> Array:
        """torque on the first body, in global axes [3; Nm]"""
    def force_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """force on one of the two bodies or markers, in global axes [3; N]"""
    def torque_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """torque on one of the two bodies or markers, in global axes [3; Nm]"""

class ObjectJointRollingDisc(ObjectHandle):
    """Handle: A rigid disc that rolls on a plane without slip, by constraints on the velocity of the contact point"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def marker_numbers(self) -> tuple[MarkerHandle, ...]:
        """marker m0 on the plane and marker m1 at the center of the disc [2]"""
    @marker_numbers.setter
    def marker_numbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def markerNumbers(self) -> tuple[MarkerHandle, ...]:
        """marker m0 on the plane and marker m1 at the center of the disc [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def constrained_axes(self) -> tuple[int, ...]:
        """three flags, 1 constrained and 0 free: lateral, forward and normal velocity of the contact point; other values are refused [3]"""
    @constrained_axes.setter
    def constrained_axes(self, value: Sequence[int]) -> None: ...
    @property
    def constrainedAxes(self) -> tuple[int, ...]:
        """three flags, 1 constrained and 0 free: lateral, forward and normal velocity of the contact point; other values are refused [3]"""
    @constrainedAxes.setter
    def constrainedAxes(self, value: Sequence[int]) -> None: ...
    @property
    def active_connector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @active_connector.setter
    def active_connector(self, value: bool) -> None: ...
    @property
    def activeConnector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @activeConnector.setter
    def activeConnector(self, value: bool) -> None: ...
    @property
    def disc_radius(self) -> float:
        """radius of the disc [m]"""
    @disc_radius.setter
    def disc_radius(self, value: float) -> None: ...
    @property
    def discRadius(self) -> float:
        """radius of the disc [m]"""
    @discRadius.setter
    def discRadius(self, value: float) -> None: ...
    @property
    def disc_axis(self) -> Array:
        """axis of the disc in the frame of marker m1, a unit vector; must not become parallel to the normal of the plane [3; 1]"""
    @disc_axis.setter
    def disc_axis(self, value: ArrayLike | str) -> None: ...
    @property
    def discAxis(self) -> Array:
        """axis of the disc in the frame of marker m1, a unit vector; must not become parallel to the normal of the plane [3; 1]"""
    @discAxis.setter
    def discAxis(self, value: ArrayLike | str) -> None: ...
    @property
    def plane_normal(self) -> Array:
        """normal of the plane in the frame of marker m0, a unit vector [3; 1]"""
    @plane_normal.setter
    def plane_normal(self, value: ArrayLike | str) -> None: ...
    @property
    def planeNormal(self) -> Array:
        """normal of the plane in the frame of marker m0, a unit vector [3; 1]"""
    @planeNormal.setter
    def planeNormal(self, value: ArrayLike | str) -> None: ...
    @property
    def position(self) -> Array:
        """global position of the contact point [m]"""
    @property
    def velocity(self) -> Array:
        """global velocity at which the contact point moves along its trail; not the velocity of the disc at that point [m/s]"""
    @property
    def force_local(self) -> Array:
        """contact force on the disc in frame J1: lateral, forward, normal [N]"""
    @property
    def rotation_matrix(self) -> Array:
        """rotation matrix from frame J1 (lateral, forward, normal) to the global frame, row by row [1]"""
    @property
    def force(self) -> Array:
        """force on the first body, in global axes [3; N]"""
    def force_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """force on one of the two bodies or markers, in global axes [3; N]"""
    def torque_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """torque on one of the two bodies or markers, in global axes [3; Nm]"""

class ObjectJointSliding(ObjectHandle):
    """Handle: A body that slides along a chain of ANCF cable elements in space"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def marker_numbers(self) -> tuple[MarkerHandle, ...]:
        """marker m0 of the sliding body, and marker m1 of the cable element on which it begins, one of ``slidingMarkerNumbers``; the data node has the current element [2]"""
    @marker_numbers.setter
    def marker_numbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def markerNumbers(self) -> tuple[MarkerHandle, ...]:
        """marker m0 of the sliding body, and marker m1 of the cable element on which it begins, one of ``slidingMarkerNumbers``; the data node has the current element [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def sliding_marker_numbers(self) -> tuple[MarkerHandle, ...]:
        """shape markers of all cable elements in the order in which they follow each other: the end of one element is the begin of the next [n]"""
    @sliding_marker_numbers.setter
    def sliding_marker_numbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def slidingMarkerNumbers(self) -> tuple[MarkerHandle, ...]:
        """shape markers of all cable elements in the order in which they follow each other: the end of one element is the begin of the next [n]"""
    @slidingMarkerNumbers.setter
    def slidingMarkerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def sliding_marker_offsets(self) -> Array:
        """for each of these elements, the sum of the reference lengths of all elements before it; the first is 0; one for each of ``slidingMarkerNumbers`` [n; m]"""
    @sliding_marker_offsets.setter
    def sliding_marker_offsets(self, value: ArrayLike) -> None: ...
    @property
    def slidingMarkerOffsets(self) -> Array:
        """for each of these elements, the sum of the reference lengths of all elements before it; the first is 0; one for each of ``slidingMarkerNumbers`` [n; m]"""
    @slidingMarkerOffsets.setter
    def slidingMarkerOffsets(self, value: ArrayLike) -> None: ...
    @property
    def node_number(self) -> NodeHandle:
        """NodeGenericData with two data coordinates: index of the current element in ``slidingMarkerNumbers``, and sliding coordinate at the begin of the step"""
    @node_number.setter
    def node_number(self, value: NodeIndex | int | str) -> None: ...
    @property
    def nodeNumber(self) -> NodeHandle:
        """NodeGenericData with two data coordinates: index of the current element in ``slidingMarkerNumbers``, and sliding coordinate at the begin of the step"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    @property
    def constrain_rotations(self) -> tuple[int, ...]:
        """three flags, 1 constrained and 0 free: rotation of marker m0, then a rigid body marker, about its x, y and z axis; cables do not tell how they are twisted, so that the first flag has to be 0 [3]"""
    @constrain_rotations.setter
    def constrain_rotations(self, value: Sequence[int]) -> None: ...
    @property
    def constrainRotations(self) -> tuple[int, ...]:
        """three flags, 1 constrained and 0 free: rotation of marker m0, then a rigid body marker, about its x, y and z axis; cables do not tell how they are twisted, so that the first flag has to be 0 [3]"""
    @constrainRotations.setter
    def constrainRotations(self, value: Sequence[int]) -> None: ...
    @property
    def constrain_translations(self) -> tuple[int, ...]:
        """three flags, 1 constrained and 0 free: translation of marker m0 relative to the cable along the global axes [3]"""
    @constrain_translations.setter
    def constrain_translations(self, value: Sequence[int]) -> None: ...
    @property
    def constrainTranslations(self) -> tuple[int, ...]:
        """three flags, 1 constrained and 0 free: translation of marker m0 relative to the cable along the global axes [3]"""
    @constrainTranslations.setter
    def constrainTranslations(self, value: Sequence[int]) -> None: ...
    @property
    def axial_force(self) -> float:
        """force along the cable that drives the body; changed during a simulation to move the body [N]"""
    @axial_force.setter
    def axial_force(self, value: float) -> None: ...
    @property
    def axialForce(self) -> float:
        """force along the cable that drives the body; changed during a simulation to move the body [N]"""
    @axialForce.setter
    def axialForce(self, value: float) -> None: ...
    @property
    def active_connector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @active_connector.setter
    def active_connector(self, value: bool) -> None: ...
    @property
    def activeConnector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @activeConnector.setter
    def activeConnector(self, value: bool) -> None: ...
    @property
    def position(self) -> Array:
        """global position of marker m0 [m]"""
    @property
    def velocity(self) -> Array:
        """global velocity of marker m0 [m/s]"""
    @property
    def sliding_coordinate(self) -> float:
        """sliding coordinate along all elements, from 0 to the sum of their reference lengths [m]"""
    @property
    def force(self) -> Array:
        """Lagrange multipliers of the position constraint, the joint force [N]"""
    def force_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """force on one of the two bodies or markers, in global axes [3; N]"""
    def torque_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """torque on one of the two bodies or markers, in global axes [3; Nm]"""

class ObjectJointSliding2D(ObjectHandle):
    """Handle: A body that slides along a chain of planar ANCF cable elements"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def marker_numbers(self) -> tuple[MarkerHandle, ...]:
        """marker m0 of the sliding body, and marker m1 of the cable element on which it begins, one of ``slidingMarkerNumbers``; the data node has the current element [2]"""
    @marker_numbers.setter
    def marker_numbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def markerNumbers(self) -> tuple[MarkerHandle, ...]:
        """marker m0 of the sliding body, and marker m1 of the cable element on which it begins, one of ``slidingMarkerNumbers``; the data node has the current element [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def sliding_marker_numbers(self) -> tuple[MarkerHandle, ...]:
        """coordinate markers of all cable elements in the order in which they follow each other: the end of one element is the begin of the next [n]"""
    @sliding_marker_numbers.setter
    def sliding_marker_numbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def slidingMarkerNumbers(self) -> tuple[MarkerHandle, ...]:
        """coordinate markers of all cable elements in the order in which they follow each other: the end of one element is the begin of the next [n]"""
    @slidingMarkerNumbers.setter
    def slidingMarkerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def sliding_marker_offsets(self) -> Array:
        """for each of these elements, the sum of the reference lengths of all elements before it; the first is 0; one for each of ``slidingMarkerNumbers`` [n; m]"""
    @sliding_marker_offsets.setter
    def sliding_marker_offsets(self, value: ArrayLike) -> None: ...
    @property
    def slidingMarkerOffsets(self) -> Array:
        """for each of these elements, the sum of the reference lengths of all elements before it; the first is 0; one for each of ``slidingMarkerNumbers`` [n; m]"""
    @slidingMarkerOffsets.setter
    def slidingMarkerOffsets(self, value: ArrayLike) -> None: ...
    @property
    def node_number(self) -> NodeHandle:
        """NodeGenericData with two data coordinates: index of the current element in ``slidingMarkerNumbers``, and sliding coordinate at the begin of the step"""
    @node_number.setter
    def node_number(self, value: NodeIndex | int | str) -> None: ...
    @property
    def nodeNumber(self) -> NodeHandle:
        """NodeGenericData with two data coordinates: index of the current element in ``slidingMarkerNumbers``, and sliding coordinate at the begin of the step"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    @property
    def classical_formulation(self) -> bool:
        """True: the force along the cable is prescribed, and both components of position are constrained; False: only the normal direction is constrained, by one multiplier"""
    @classical_formulation.setter
    def classical_formulation(self, value: bool) -> None: ...
    @property
    def classicalFormulation(self) -> bool:
        """True: the force along the cable is prescribed, and both components of position are constrained; False: only the normal direction is constrained, by one multiplier"""
    @classicalFormulation.setter
    def classicalFormulation(self, value: bool) -> None: ...
    @property
    def use_classical_formulation(self) -> bool:
        """True: the force along the cable is prescribed, and both components of position are constrained; False: only the normal direction is constrained, by one multiplier"""
    @use_classical_formulation.setter
    def use_classical_formulation(self, value: bool) -> None: ...
    @property
    def useClassicalFormulation(self) -> bool:
        """True: the force along the cable is prescribed, and both components of position are constrained; False: only the normal direction is constrained, by one multiplier"""
    @useClassicalFormulation.setter
    def useClassicalFormulation(self, value: bool) -> None: ...
    @property
    def constrain_rotation(self) -> bool:
        """True: marker m0, then a rigid body marker, keeps its orientation relative to the slope of the cable; False: it rotates freely"""
    @constrain_rotation.setter
    def constrain_rotation(self, value: bool) -> None: ...
    @property
    def constrainRotation(self) -> bool:
        """True: marker m0, then a rigid body marker, keeps its orientation relative to the slope of the cable; False: it rotates freely"""
    @constrainRotation.setter
    def constrainRotation(self, value: bool) -> None: ...
    @property
    def axial_force(self) -> float:
        """force along the cable that drives the body; only for ``classicalFormulation``; changed during a simulation to move the body [N]"""
    @axial_force.setter
    def axial_force(self, value: float) -> None: ...
    @property
    def axialForce(self) -> float:
        """force along the cable that drives the body; only for ``classicalFormulation``; changed during a simulation to move the body [N]"""
    @axialForce.setter
    def axialForce(self, value: float) -> None: ...
    @property
    def active_connector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @active_connector.setter
    def active_connector(self, value: bool) -> None: ...
    @property
    def activeConnector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @activeConnector.setter
    def activeConnector(self, value: bool) -> None: ...
    @property
    def position(self) -> Array:
        """global position of marker m0 [m]"""
    @property
    def velocity(self) -> Array:
        """global velocity of marker m0 [m/s]"""
    @property
    def sliding_coordinate(self) -> float:
        """sliding coordinate along all elements, from 0 to the sum of their reference lengths [m]"""
    @property
    def force(self) -> Array:
        """Lagrange multipliers of the position constraint, the joint force [N]"""
    @property
    def displacement_local(self) -> Array:
        """position of the cable at the sliding coordinate relative to the body, along and normal to the slope of the cable; the third value is 0 [m]"""
    def force_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """force on one of the two bodies or markers, in global axes [3; N]"""
    def torque_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """torque on one of the two bodies or markers, in global axes [3; Nm]"""

class ObjectJointSpherical(ObjectHandle):
    """Handle: A ball joint: keeps two points together, or their chosen global components"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def marker_numbers(self) -> tuple[MarkerHandle, ...]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @marker_numbers.setter
    def marker_numbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def markerNumbers(self) -> tuple[MarkerHandle, ...]:
        """the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0 [2]"""
    @markerNumbers.setter
    def markerNumbers(self, value: Sequence[MarkerIndex | int | str]) -> None: ...
    @property
    def constrained_axes(self) -> tuple[int, ...]:
        """three flags, 1 constrained and 0 free: relative translation along the global x, y and z axis; other values are refused [3]"""
    @constrained_axes.setter
    def constrained_axes(self, value: Sequence[int]) -> None: ...
    @property
    def constrainedAxes(self) -> tuple[int, ...]:
        """three flags, 1 constrained and 0 free: relative translation along the global x, y and z axis; other values are refused [3]"""
    @constrainedAxes.setter
    def constrainedAxes(self, value: Sequence[int]) -> None: ...
    @property
    def active_connector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @active_connector.setter
    def active_connector(self, value: bool) -> None: ...
    @property
    def activeConnector(self) -> bool:
        """False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero"""
    @activeConnector.setter
    def activeConnector(self, value: bool) -> None: ...
    @property
    def position(self) -> Array:
        """global position of marker m0 [m]"""
    @property
    def velocity(self) -> Array:
        """global velocity of marker m0 [m/s]"""
    @property
    def displacement(self) -> Array:
        """global position of marker m1 relative to marker m0; constrained components show the error of the constraint [m]"""
    @property
    def force(self) -> Array:
        """Lagrange multipliers, the global joint force on marker m0; 0 in free directions [N]"""
    def force_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """force on one of the two bodies or markers, in global axes [3; N]"""
    def torque_on(self, body: ObjectIndex | MarkerIndex | str) -> Array:
        """torque on one of the two bodies or markers, in global axes [3; Nm]"""

class MarkerBodiesRelativeRotationCoordinate(MarkerHandle):
    """Handle: A coordinate marker on the relative rotation of two bodies about an axis"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def body_numbers(self) -> tuple[ObjectHandle, ...]:
        """the two bodies whose relative motion is the coordinate [2]"""
    @body_numbers.setter
    def body_numbers(self, value: Sequence[ObjectIndex | int | str]) -> None: ...
    @property
    def bodyNumbers(self) -> tuple[ObjectHandle, ...]:
        """the two bodies whose relative motion is the coordinate [2]"""
    @bodyNumbers.setter
    def bodyNumbers(self, value: Sequence[ObjectIndex | int | str]) -> None: ...
    @property
    def node_number(self) -> NodeHandle:
        """NodeGenericData with one data coordinate that holds the last angle and makes the coordinate continuous beyond half a turn; not set: the angle jumps"""
    @node_number.setter
    def node_number(self, value: NodeIndex | int | str) -> None: ...
    @property
    def nodeNumber(self) -> NodeHandle:
        """NodeGenericData with one data coordinate that holds the last angle and makes the coordinate continuous beyond half a turn; not set: the angle jumps"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    @property
    def local_position0(self) -> Array:
        """point in the frame of the first body, which is the position of the marker; the angle does not depend on it [3; m]"""
    @local_position0.setter
    def local_position0(self, value: ArrayLike) -> None: ...
    @property
    def localPosition0(self) -> Array:
        """point in the frame of the first body, which is the position of the marker; the angle does not depend on it [3; m]"""
    @localPosition0.setter
    def localPosition0(self, value: ArrayLike) -> None: ...
    @property
    def local_position1(self) -> Array:
        """point in the frame of the second body; no effect, because the angle does not depend on it [3; m]"""
    @local_position1.setter
    def local_position1(self, value: ArrayLike) -> None: ...
    @property
    def localPosition1(self) -> Array:
        """point in the frame of the second body; no effect, because the angle does not depend on it [3; m]"""
    @localPosition1.setter
    def localPosition1(self, value: ArrayLike) -> None: ...
    @property
    def axis0(self) -> Array:
        """axis of rotation in the frame of the first body, a unit vector [3; 1]"""
    @axis0.setter
    def axis0(self, value: ArrayLike | str) -> None: ...
    @property
    def offset(self) -> float:
        """angle that is subtracted from the measured one [rad]"""
    @offset.setter
    def offset(self, value: float) -> None: ...

class MarkerBodiesRelativeTranslationCoordinate(MarkerHandle):
    """Handle: A coordinate marker on the relative translation of two bodies along an axis"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def body_numbers(self) -> tuple[ObjectHandle, ...]:
        """the two bodies whose relative motion is the coordinate [2]"""
    @body_numbers.setter
    def body_numbers(self, value: Sequence[ObjectIndex | int | str]) -> None: ...
    @property
    def bodyNumbers(self) -> tuple[ObjectHandle, ...]:
        """the two bodies whose relative motion is the coordinate [2]"""
    @bodyNumbers.setter
    def bodyNumbers(self, value: Sequence[ObjectIndex | int | str]) -> None: ...
    @property
    def local_position0(self) -> Array:
        """point in the frame of the first body [3; m]"""
    @local_position0.setter
    def local_position0(self, value: ArrayLike) -> None: ...
    @property
    def localPosition0(self) -> Array:
        """point in the frame of the first body [3; m]"""
    @localPosition0.setter
    def localPosition0(self, value: ArrayLike) -> None: ...
    @property
    def local_position1(self) -> Array:
        """point in the frame of the second body [3; m]"""
    @local_position1.setter
    def local_position1(self, value: ArrayLike) -> None: ...
    @property
    def localPosition1(self) -> Array:
        """point in the frame of the second body [3; m]"""
    @localPosition1.setter
    def localPosition1(self, value: ArrayLike) -> None: ...
    @property
    def axis0(self) -> Array:
        """axis of translation in the frame of the first body, a unit vector [3; 1]"""
    @axis0.setter
    def axis0(self, value: ArrayLike | str) -> None: ...
    @property
    def offset(self) -> float:
        """length that is subtracted from the measured one [m]"""
    @offset.setter
    def offset(self, value: float) -> None: ...

class MarkerBodyBeamShape(MarkerHandle):
    """Handle: A marker that gives joints and contacts access to the shape of a beam element"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def body_number(self) -> ObjectHandle:
        """spatial cable element to which the marker is attached"""
    @body_number.setter
    def body_number(self, value: ObjectIndex | int | str) -> None: ...
    @property
    def bodyNumber(self) -> ObjectHandle:
        """spatial cable element to which the marker is attached"""
    @bodyNumber.setter
    def bodyNumber(self, value: ObjectIndex | int | str) -> None: ...

class MarkerBodyCable2DCoordinates(MarkerHandle):
    """Handle: A marker on all coordinates of a planar ANCF cable element, for sliding joints"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def body_number(self) -> ObjectHandle:
        """planar cable element to which the marker is attached"""
    @body_number.setter
    def body_number(self, value: ObjectIndex | int | str) -> None: ...
    @property
    def bodyNumber(self) -> ObjectHandle:
        """planar cable element to which the marker is attached"""
    @bodyNumber.setter
    def bodyNumber(self, value: ObjectIndex | int | str) -> None: ...

class MarkerBodyCable2DShape(MarkerHandle):
    """Handle: A marker that divides a planar ANCF cable element into straight segments, for contact with circles"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def body_number(self) -> ObjectHandle:
        """planar cable element to which the marker is attached"""
    @body_number.setter
    def body_number(self, value: ObjectIndex | int | str) -> None: ...
    @property
    def bodyNumber(self) -> ObjectHandle:
        """planar cable element to which the marker is attached"""
    @bodyNumber.setter
    def bodyNumber(self, value: ObjectIndex | int | str) -> None: ...
    @property
    def number_of_segments(self) -> int:
        """number of segments; must be that of the contact that uses the marker"""
    @number_of_segments.setter
    def number_of_segments(self, value: int) -> None: ...
    @property
    def numberOfSegments(self) -> int:
        """number of segments; must be that of the contact that uses the marker"""
    @numberOfSegments.setter
    def numberOfSegments(self, value: int) -> None: ...
    @property
    def vertical_offset(self) -> float:
        """distance of the segments from the axis of the cable in direction of its local y axis, such as half the thickness of a belt [m]"""
    @vertical_offset.setter
    def vertical_offset(self, value: float) -> None: ...
    @property
    def verticalOffset(self) -> float:
        """distance of the segments from the axis of the cable in direction of its local y axis, such as half the thickness of a belt [m]"""
    @verticalOffset.setter
    def verticalOffset(self, value: float) -> None: ...

class MarkerBodyMass(MarkerHandle):
    """Handle: A marker on the mass of a body, for loads that are proportional to mass such as gravity"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def body_number(self) -> ObjectHandle:
        """body with a mass to which the marker is attached"""
    @body_number.setter
    def body_number(self, value: ObjectIndex | int | str) -> None: ...
    @property
    def bodyNumber(self) -> ObjectHandle:
        """body with a mass to which the marker is attached"""
    @bodyNumber.setter
    def bodyNumber(self, value: ObjectIndex | int | str) -> None: ...

class MarkerBodyPosition(MarkerHandle):
    """Handle: A marker at a point that is fixed to a body, with its position but without orientation"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def body_number(self) -> ObjectHandle:
        """body to which the marker is attached"""
    @body_number.setter
    def body_number(self, value: ObjectIndex | int | str) -> None: ...
    @property
    def bodyNumber(self) -> ObjectHandle:
        """body to which the marker is attached"""
    @bodyNumber.setter
    def bodyNumber(self, value: ObjectIndex | int | str) -> None: ...
    @property
    def local_position(self) -> Array:
        """position of the marker in the body frame, relative to the reference point of the body [3; m]"""
    @local_position.setter
    def local_position(self, value: ArrayLike) -> None: ...
    @property
    def localPosition(self) -> Array:
        """position of the marker in the body frame, relative to the reference point of the body [3; m]"""
    @localPosition.setter
    def localPosition(self, value: ArrayLike) -> None: ...

class MarkerBodyRigid(MarkerHandle):
    """Handle: A marker at a point that is fixed to a body, with its position and orientation"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def body_number(self) -> ObjectHandle:
        """body to which the marker is attached"""
    @body_number.setter
    def body_number(self, value: ObjectIndex | int | str) -> None: ...
    @property
    def bodyNumber(self) -> ObjectHandle:
        """body to which the marker is attached"""
    @bodyNumber.setter
    def bodyNumber(self, value: ObjectIndex | int | str) -> None: ...
    @property
    def local_position(self) -> Array:
        """position of the marker in the body frame, relative to the reference point of the body [3; m]"""
    @local_position.setter
    def local_position(self, value: ArrayLike) -> None: ...
    @property
    def localPosition(self) -> Array:
        """position of the marker in the body frame, relative to the reference point of the body [3; m]"""
    @localPosition.setter
    def localPosition(self, value: ArrayLike) -> None: ...
    @property
    def local_rotation(self) -> Array:
        """rotation of the marker in the frame that it would have without: joints and body-fixed loads use the turned axes. ``localHT`` sets position and rotation [3 x 3; 1]"""
    @local_rotation.setter
    def local_rotation(self, value: ArrayLike) -> None: ...
    @property
    def localRotation(self) -> Array:
        """rotation of the marker in the frame that it would have without: joints and body-fixed loads use the turned axes. ``localHT`` sets position and rotation [3 x 3; 1]"""
    @localRotation.setter
    def localRotation(self, value: ArrayLike) -> None: ...

class MarkerKinematicTreeRigid(MarkerHandle):
    """Handle: A marker at a point that is fixed to a link of a kinematic tree, with position and orientation"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def object_number(self) -> ObjectHandle:
        """kinematic tree to which the marker is attached"""
    @object_number.setter
    def object_number(self, value: ObjectIndex | int | str) -> None: ...
    @property
    def objectNumber(self) -> ObjectHandle:
        """kinematic tree to which the marker is attached"""
    @objectNumber.setter
    def objectNumber(self, value: ObjectIndex | int | str) -> None: ...
    @property
    def link_number(self) -> int | str:
        """number of the link within the tree, from 0, or its name, or that of its joint; -1 means not set and is rejected"""
    @link_number.setter
    def link_number(self, value: int | str) -> None: ...
    @property
    def linkNumber(self) -> int | str:
        """number of the link within the tree, from 0, or its name, or that of its joint; -1 means not set and is rejected"""
    @linkNumber.setter
    def linkNumber(self, value: int | str) -> None: ...
    @property
    def local_position(self) -> Array:
        """position of the marker in the frame of the link [3; m]"""
    @local_position.setter
    def local_position(self, value: ArrayLike) -> None: ...
    @property
    def localPosition(self) -> Array:
        """position of the marker in the frame of the link [3; m]"""
    @localPosition.setter
    def localPosition(self, value: ArrayLike) -> None: ...
    @property
    def local_rotation(self) -> Array:
        """rotation of the marker in the frame that it would have without: joints and body-fixed loads use the turned axes. ``localHT`` sets position and rotation [3 x 3; 1]"""
    @local_rotation.setter
    def local_rotation(self, value: ArrayLike) -> None: ...
    @property
    def localRotation(self) -> Array:
        """rotation of the marker in the frame that it would have without: joints and body-fixed loads use the turned axes. ``localHT`` sets position and rotation [3 x 3; 1]"""
    @localRotation.setter
    def localRotation(self, value: ArrayLike) -> None: ...

class MarkerNodeCoordinate(MarkerHandle):
    """Handle: A marker on a single coordinate of a node"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def node_number(self) -> NodeHandle:
        """node to which the marker is attached"""
    @node_number.setter
    def node_number(self, value: NodeIndex | int | str) -> None: ...
    @property
    def nodeNumber(self) -> NodeHandle:
        """node to which the marker is attached"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    @property
    def coordinate(self) -> int | str:
        """number of the coordinate within the node, from 0, or the name of a joint of the kinematic tree on the node; -1 means not set and is rejected; any number reads zero at a ground node"""
    @coordinate.setter
    def coordinate(self, value: int | str) -> None: ...

class MarkerNodeCoordinates(MarkerHandle):
    """Handle: A marker on all coordinates of a node, as a vector"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def node_number(self) -> NodeHandle:
        """node to which the marker is attached"""
    @node_number.setter
    def node_number(self, value: NodeIndex | int | str) -> None: ...
    @property
    def nodeNumber(self) -> NodeHandle:
        """node to which the marker is attached"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...

class MarkerNodeODE1Coordinate(MarkerHandle):
    """Handle: A marker on a single coordinate of a node with first order equations"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def node_number(self) -> NodeHandle:
        """NodeGenericODE1 to which the marker is attached"""
    @node_number.setter
    def node_number(self, value: NodeIndex | int | str) -> None: ...
    @property
    def nodeNumber(self) -> NodeHandle:
        """NodeGenericODE1 to which the marker is attached"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    @property
    def coordinate(self) -> int:
        """number of the coordinate within the node, from 0; -1 means not set and is rejected"""
    @coordinate.setter
    def coordinate(self, value: int) -> None: ...

class MarkerNodePosition(MarkerHandle):
    """Handle: A marker at the position of a node"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def node_number(self) -> NodeHandle:
        """node with a position to which the marker is attached"""
    @node_number.setter
    def node_number(self, value: NodeIndex | int | str) -> None: ...
    @property
    def nodeNumber(self) -> NodeHandle:
        """node with a position to which the marker is attached"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...

class MarkerNodeRigid(MarkerHandle):
    """Handle: A marker at a node with position and orientation"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def node_number(self) -> NodeHandle:
        """node with position and orientation, such as a rigid body node, to which the marker is attached"""
    @node_number.setter
    def node_number(self, value: NodeIndex | int | str) -> None: ...
    @property
    def nodeNumber(self) -> NodeHandle:
        """node with position and orientation, such as a rigid body node, to which the marker is attached"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    @property
    def local_rotation(self) -> Array:
        """rotation of the marker in the frame that it would have without: joints and body-fixed loads use the turned axes. ``localHT`` sets position and rotation [3 x 3; 1]"""
    @local_rotation.setter
    def local_rotation(self, value: ArrayLike) -> None: ...
    @property
    def localRotation(self) -> Array:
        """rotation of the marker in the frame that it would have without: joints and body-fixed loads use the turned axes. ``localHT`` sets position and rotation [3 x 3; 1]"""
    @localRotation.setter
    def localRotation(self, value: ArrayLike) -> None: ...

class MarkerNodeRotationCoordinate(MarkerHandle):
    """Handle: A marker on the rotation of a node about one global axis"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def node_number(self) -> NodeHandle:
        """node with an orientation in space to which the marker is attached; planar nodes are refused, use MarkerNodeCoordinate for them"""
    @node_number.setter
    def node_number(self, value: NodeIndex | int | str) -> None: ...
    @property
    def nodeNumber(self) -> NodeHandle:
        """node with an orientation in space to which the marker is attached; planar nodes are refused, use MarkerNodeCoordinate for them"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    @property
    def rotation_coordinate(self) -> int:
        """axis of rotation: 0 for x, 1 for y, 2 for z; -1 means not set and is rejected"""
    @rotation_coordinate.setter
    def rotation_coordinate(self, value: int) -> None: ...
    @property
    def rotationCoordinate(self) -> int:
        """axis of rotation: 0 for x, 1 for y, 2 for z; -1 means not set and is rejected"""
    @rotationCoordinate.setter
    def rotationCoordinate(self, value: int) -> None: ...

class MarkerObjectODE2Coordinates(MarkerHandle):
    """Handle: A marker on all second order coordinates of an object, as a vector"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def object_number(self) -> ObjectHandle:
        """body to which the marker is attached"""
    @object_number.setter
    def object_number(self, value: ObjectIndex | int | str) -> None: ...
    @property
    def objectNumber(self) -> ObjectHandle:
        """body to which the marker is attached"""
    @objectNumber.setter
    def objectNumber(self, value: ObjectIndex | int | str) -> None: ...

class MarkerSuperElementPosition(MarkerHandle):
    """Handle: A marker at the weighted mean position of mesh nodes of a super element"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def body_number(self) -> ObjectHandle:
        """super element to which the marker is attached"""
    @body_number.setter
    def body_number(self, value: ObjectIndex | int | str) -> None: ...
    @property
    def bodyNumber(self) -> ObjectHandle:
        """super element to which the marker is attached"""
    @bodyNumber.setter
    def bodyNumber(self, value: ObjectIndex | int | str) -> None: ...
    @property
    def mesh_node_numbers(self) -> tuple[int, ...]:
        """mesh nodes of the super element, numbered within it from 0; each must have a position [n]"""
    @mesh_node_numbers.setter
    def mesh_node_numbers(self, value: Sequence[int]) -> None: ...
    @property
    def meshNodeNumbers(self) -> tuple[int, ...]:
        """mesh nodes of the super element, numbered within it from 0; each must have a position [n]"""
    @meshNodeNumbers.setter
    def meshNodeNumbers(self, value: Sequence[int]) -> None: ...
    @property
    def weighting_factors(self) -> Array:
        """weight of every mesh node, as many as mesh nodes; should sum up to 1, such that the marker moves with a rigid translation of the nodes [n; 1]"""
    @weighting_factors.setter
    def weighting_factors(self, value: ArrayLike) -> None: ...
    @property
    def weightingFactors(self) -> Array:
        """weight of every mesh node, as many as mesh nodes; should sum up to 1, such that the marker moves with a rigid translation of the nodes [n; 1]"""
    @weightingFactors.setter
    def weightingFactors(self, value: ArrayLike) -> None: ...

class MarkerSuperElementRigid(MarkerHandle):
    """Handle: A marker with the weighted mean position and rotation of mesh nodes of a super element"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def body_number(self) -> ObjectHandle:
        """super element to which the marker is attached"""
    @body_number.setter
    def body_number(self, value: ObjectIndex | int | str) -> None: ...
    @property
    def bodyNumber(self) -> ObjectHandle:
        """super element to which the marker is attached"""
    @bodyNumber.setter
    def bodyNumber(self, value: ObjectIndex | int | str) -> None: ...
    @property
    def offset(self) -> Array:
        """correction of the marker position in the reference frame of the super element, if the mean of the mesh nodes is not the wanted point; should be small [3; m]"""
    @offset.setter
    def offset(self, value: ArrayLike) -> None: ...
    @property
    def mesh_node_numbers(self) -> tuple[int, ...]:
        """mesh nodes of the super element, numbered within it from 0; each must have a position [n]"""
    @mesh_node_numbers.setter
    def mesh_node_numbers(self, value: Sequence[int]) -> None: ...
    @property
    def meshNodeNumbers(self) -> tuple[int, ...]:
        """mesh nodes of the super element, numbered within it from 0; each must have a position [n]"""
    @meshNodeNumbers.setter
    def meshNodeNumbers(self, value: Sequence[int]) -> None: ...
    @property
    def weighting_factors(self) -> Array:
        """weight of every mesh node, as many as mesh nodes; should sum up to 1, for instance parts of the area of an interface [n; 1]"""
    @weighting_factors.setter
    def weighting_factors(self, value: ArrayLike) -> None: ...
    @property
    def weightingFactors(self) -> Array:
        """weight of every mesh node, as many as mesh nodes; should sum up to 1, for instance parts of the area of an interface [n; 1]"""
    @weightingFactors.setter
    def weightingFactors(self, value: ArrayLike) -> None: ...
    @property
    def use_alternative_approach(self) -> bool:
        """True: the mean rotation follows from the angular momentum of the weighted nodes; False: it is a mean weighted by squared distances"""
    @use_alternative_approach.setter
    def use_alternative_approach(self, value: bool) -> None: ...
    @property
    def useAlternativeApproach(self) -> bool:
        """True: the mean rotation follows from the angular momentum of the weighted nodes; False: it is a mean weighted by squared distances"""
    @useAlternativeApproach.setter
    def useAlternativeApproach(self, value: bool) -> None: ...
    @property
    def rotations_exponential_map(self) -> int:
        """0: rotation and angular velocity are linearized; 1: rotation by the exponential map; 2: rotation by the exponential map and angular velocity by its tangent map, the consistent choice"""
    @rotations_exponential_map.setter
    def rotations_exponential_map(self, value: int) -> None: ...
    @property
    def rotationsExponentialMap(self) -> int:
        """0: rotation and angular velocity are linearized; 1: rotation by the exponential map; 2: rotation by the exponential map and angular velocity by its tangent map, the consistent choice"""
    @rotationsExponentialMap.setter
    def rotationsExponentialMap(self, value: int) -> None: ...
    @property
    def local_rotation(self) -> Array:
        """rotation of the marker in the frame that it would have without: joints and body-fixed loads use the turned axes. ``localHT`` sets position and rotation [3 x 3; 1]"""
    @local_rotation.setter
    def local_rotation(self, value: ArrayLike) -> None: ...
    @property
    def localRotation(self) -> Array:
        """rotation of the marker in the frame that it would have without: joints and body-fixed loads use the turned axes. ``localHT`` sets position and rotation [3 x 3; 1]"""
    @localRotation.setter
    def localRotation(self, value: ArrayLike) -> None: ...

class LoadCoordinate(LoadHandle):
    """Handle: A generalized force on a single coordinate"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def marker_number(self) -> MarkerHandle:
        """coordinate marker to which the load is applied"""
    @marker_number.setter
    def marker_number(self, value: MarkerIndex | int | str) -> None: ...
    @property
    def markerNumber(self) -> MarkerHandle:
        """coordinate marker to which the load is applied"""
    @markerNumber.setter
    def markerNumber(self, value: MarkerIndex | int | str) -> None: ...
    @property
    def load(self) -> float:
        """generalized force: N on a coordinate that is a length, Nm on an angle; ignored if there is a user function, which receives it as an argument [various]"""
    @load.setter
    def load(self, value: float) -> None: ...
    @property
    def load_user_function(self) -> Callable[[MainSystem, float, float], float] | Literal[0]:
        """Python function that computes the load as a function of time"""
    @load_user_function.setter
    def load_user_function(self, value: Callable[[MainSystem, float, float], float] | Literal[0]) -> None: ...
    @property
    def loadUserFunction(self) -> Callable[[MainSystem, float, float], float] | Literal[0]:
        """Python function that computes the load as a function of time"""
    @loadUserFunction.setter
    def loadUserFunction(self, value: Callable[[MainSystem, float, float], float] | Literal[0]) -> None: ...

class LoadForceVector(LoadHandle):
    """Handle: A force vector at a point of a body or at a node"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def marker_number(self) -> MarkerHandle:
        """marker with a position to which the force is applied; with ``bodyFixed`` it must have an orientation as well"""
    @marker_number.setter
    def marker_number(self, value: MarkerIndex | int | str) -> None: ...
    @property
    def markerNumber(self) -> MarkerHandle:
        """marker with a position to which the force is applied; with ``bodyFixed`` it must have an orientation as well"""
    @markerNumber.setter
    def markerNumber(self, value: MarkerIndex | int | str) -> None: ...
    @property
    def load_vector(self) -> Array:
        """force vector in global coordinates, or in the marker frame with ``bodyFixed``; ignored if there is a user function, which receives it as an argument [3; N]"""
    @load_vector.setter
    def load_vector(self, value: ArrayLike) -> None: ...
    @property
    def loadVector(self) -> Array:
        """force vector in global coordinates, or in the marker frame with ``bodyFixed``; ignored if there is a user function, which receives it as an argument [3; N]"""
    @loadVector.setter
    def loadVector(self, value: ArrayLike) -> None: ...
    @property
    def body_fixed(self) -> bool:
        """True: the vector is given in the frame of the marker and turns with the body, a follower force; False: in global coordinates"""
    @body_fixed.setter
    def body_fixed(self, value: bool) -> None: ...
    @property
    def bodyFixed(self) -> bool:
        """True: the vector is given in the frame of the marker and turns with the body, a follower force; False: in global coordinates"""
    @bodyFixed.setter
    def bodyFixed(self, value: bool) -> None: ...
    @property
    def load_vector_user_function(self) -> Callable[[MainSystem, float, Array], ArrayLike] | Literal[0]:
        """Python function that computes the force vector as a function of time"""
    @load_vector_user_function.setter
    def load_vector_user_function(self, value: Callable[[MainSystem, float, Array], ArrayLike] | Literal[0]) -> None: ...
    @property
    def loadVectorUserFunction(self) -> Callable[[MainSystem, float, Array], ArrayLike] | Literal[0]:
        """Python function that computes the force vector as a function of time"""
    @loadVectorUserFunction.setter
    def loadVectorUserFunction(self, value: Callable[[MainSystem, float, Array], ArrayLike] | Literal[0]) -> None: ...

class LoadMassProportional(LoadHandle):
    """Handle: A distributed load proportional to mass, such as gravity"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def marker_number(self) -> MarkerHandle:
        """marker of type BodyMass on the body to which the load is applied"""
    @marker_number.setter
    def marker_number(self, value: MarkerIndex | int | str) -> None: ...
    @property
    def markerNumber(self) -> MarkerHandle:
        """marker of type BodyMass on the body to which the load is applied"""
    @markerNumber.setter
    def markerNumber(self, value: MarkerIndex | int | str) -> None: ...
    @property
    def load_vector(self) -> Array:
        """force per mass in global coordinates, such as the gravitational acceleration ``[0, 0, -9.81]``; ignored if there is a user function, which receives it as an argument [3; m/s^2]"""
    @load_vector.setter
    def load_vector(self, value: ArrayLike) -> None: ...
    @property
    def loadVector(self) -> Array:
        """force per mass in global coordinates, such as the gravitational acceleration ``[0, 0, -9.81]``; ignored if there is a user function, which receives it as an argument [3; m/s^2]"""
    @loadVector.setter
    def loadVector(self, value: ArrayLike) -> None: ...
    @property
    def load_vector_user_function(self) -> Callable[[MainSystem, float, Array], ArrayLike] | Literal[0]:
        """Python function that computes the vector as a function of time"""
    @load_vector_user_function.setter
    def load_vector_user_function(self, value: Callable[[MainSystem, float, Array], ArrayLike] | Literal[0]) -> None: ...
    @property
    def loadVectorUserFunction(self) -> Callable[[MainSystem, float, Array], ArrayLike] | Literal[0]:
        """Python function that computes the vector as a function of time"""
    @loadVectorUserFunction.setter
    def loadVectorUserFunction(self, value: Callable[[MainSystem, float, Array], ArrayLike] | Literal[0]) -> None: ...

class LoadTorqueVector(LoadHandle):
    """Handle: A torque vector on a body or node with orientation"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def marker_number(self) -> MarkerHandle:
        """marker with an orientation to which the torque is applied"""
    @marker_number.setter
    def marker_number(self, value: MarkerIndex | int | str) -> None: ...
    @property
    def markerNumber(self) -> MarkerHandle:
        """marker with an orientation to which the torque is applied"""
    @markerNumber.setter
    def markerNumber(self, value: MarkerIndex | int | str) -> None: ...
    @property
    def load_vector(self) -> Array:
        """torque vector in global coordinates, or in the marker frame with ``bodyFixed``; ignored if there is a user function, which receives it as an argument [3; Nm]"""
    @load_vector.setter
    def load_vector(self, value: ArrayLike) -> None: ...
    @property
    def loadVector(self) -> Array:
        """torque vector in global coordinates, or in the marker frame with ``bodyFixed``; ignored if there is a user function, which receives it as an argument [3; Nm]"""
    @loadVector.setter
    def loadVector(self, value: ArrayLike) -> None: ...
    @property
    def body_fixed(self) -> bool:
        """True: the vector is given in the frame of the marker and turns with the body; False: in global coordinates"""
    @body_fixed.setter
    def body_fixed(self, value: bool) -> None: ...
    @property
    def bodyFixed(self) -> bool:
        """True: the vector is given in the frame of the marker and turns with the body; False: in global coordinates"""
    @bodyFixed.setter
    def bodyFixed(self, value: bool) -> None: ...
    @property
    def load_vector_user_function(self) -> Callable[[MainSystem, float, Array], ArrayLike] | Literal[0]:
        """Python function that computes the torque vector as a function of time"""
    @load_vector_user_function.setter
    def load_vector_user_function(self, value: Callable[[MainSystem, float, Array], ArrayLike] | Literal[0]) -> None: ...
    @property
    def loadVectorUserFunction(self) -> Callable[[MainSystem, float, Array], ArrayLike] | Literal[0]:
        """Python function that computes the torque vector as a function of time"""
    @loadVectorUserFunction.setter
    def loadVectorUserFunction(self, value: Callable[[MainSystem, float, Array], ArrayLike] | Literal[0]) -> None: ...

class SensorBody(SensorHandle):
    """Handle: Measures an output variable of a body at a local position"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def body_number(self) -> ObjectHandle:
        """body that is measured"""
    @body_number.setter
    def body_number(self, value: ObjectIndex | int | str) -> None: ...
    @property
    def bodyNumber(self) -> ObjectHandle:
        """body that is measured"""
    @bodyNumber.setter
    def bodyNumber(self, value: ObjectIndex | int | str) -> None: ...
    @property
    def local_position(self) -> Array:
        """point in the body frame, relative to the reference point; the x component of beams and cables is the position along the axis [3; m]"""
    @local_position.setter
    def local_position(self, value: ArrayLike) -> None: ...
    @property
    def localPosition(self) -> Array:
        """point in the body frame, relative to the reference point; the x component of beams and cables is the position along the axis [3; m]"""
    @localPosition.setter
    def localPosition(self, value: ArrayLike) -> None: ...
    @property
    def write_to_file(self) -> bool:
        """write the measured values to a file while a solver runs; no effect if ``fileName`` is empty"""
    @write_to_file.setter
    def write_to_file(self, value: bool) -> None: ...
    @property
    def writeToFile(self) -> bool:
        """write the measured values to a file while a solver runs; no effect if ``fileName`` is empty"""
    @writeToFile.setter
    def writeToFile(self, value: bool) -> None: ...
    @property
    def file_name(self) -> str:
        """file with the time in the first and the values in the further columns; the path is relative to the working directory, missing directories are created"""
    @file_name.setter
    def file_name(self, value: str) -> None: ...
    @property
    def fileName(self) -> str:
        """file with the time in the first and the values in the further columns; the path is relative to the working directory, missing directories are created"""
    @fileName.setter
    def fileName(self, value: str) -> None: ...
    @property
    def output_variable_type(self) -> OutputVariableType:
        """output variable that is measured; one that the measured item does not provide is refused in Assemble"""
    @output_variable_type.setter
    def output_variable_type(self, value: OutputVariableType | str) -> None: ...
    @property
    def outputVariableType(self) -> OutputVariableType:
        """output variable that is measured; one that the measured item does not provide is refused in Assemble"""
    @outputVariableType.setter
    def outputVariableType(self, value: OutputVariableType | str) -> None: ...
    @property
    def store_internal(self) -> bool:
        """keep time and values in memory, to be read with ``mbs.GetSensorStoredData`` during or after the solution"""
    @store_internal.setter
    def store_internal(self, value: bool) -> None: ...
    @property
    def storeInternal(self) -> bool:
        """keep time and values in memory, to be read with ``mbs.GetSensorStoredData`` during or after the solution"""
    @storeInternal.setter
    def storeInternal(self, value: bool) -> None: ...

class SensorKinematicTree(SensorHandle):
    """Handle: Measures an output variable of a link of a kinematic tree at a local position"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def object_number(self) -> ObjectHandle:
        """kinematic tree that is measured"""
    @object_number.setter
    def object_number(self, value: ObjectIndex | int | str) -> None: ...
    @property
    def objectNumber(self) -> ObjectHandle:
        """kinematic tree that is measured"""
    @objectNumber.setter
    def objectNumber(self, value: ObjectIndex | int | str) -> None: ...
    @property
    def link_number(self) -> int | str:
        """link, numbered within the tree from 0, or its name, or that of its joint; -1 means not set and is rejected"""
    @link_number.setter
    def link_number(self, value: int | str) -> None: ...
    @property
    def linkNumber(self) -> int | str:
        """link, numbered within the tree from 0, or its name, or that of its joint; -1 means not set and is rejected"""
    @linkNumber.setter
    def linkNumber(self, value: int | str) -> None: ...
    @property
    def local_position(self) -> Array:
        """point in the frame of the link [3; m]"""
    @local_position.setter
    def local_position(self, value: ArrayLike) -> None: ...
    @property
    def localPosition(self) -> Array:
        """point in the frame of the link [3; m]"""
    @localPosition.setter
    def localPosition(self, value: ArrayLike) -> None: ...
    @property
    def write_to_file(self) -> bool:
        """write the measured values to a file while a solver runs; no effect if ``fileName`` is empty"""
    @write_to_file.setter
    def write_to_file(self, value: bool) -> None: ...
    @property
    def writeToFile(self) -> bool:
        """write the measured values to a file while a solver runs; no effect if ``fileName`` is empty"""
    @writeToFile.setter
    def writeToFile(self, value: bool) -> None: ...
    @property
    def file_name(self) -> str:
        """file with the time in the first and the values in the further columns; the path is relative to the working directory, missing directories are created"""
    @file_name.setter
    def file_name(self, value: str) -> None: ...
    @property
    def fileName(self) -> str:
        """file with the time in the first and the values in the further columns; the path is relative to the working directory, missing directories are created"""
    @fileName.setter
    def fileName(self, value: str) -> None: ...
    @property
    def output_variable_type(self) -> OutputVariableType:
        """output variable that is measured; one that the measured item does not provide is refused in Assemble"""
    @output_variable_type.setter
    def output_variable_type(self, value: OutputVariableType | str) -> None: ...
    @property
    def outputVariableType(self) -> OutputVariableType:
        """output variable that is measured; one that the measured item does not provide is refused in Assemble"""
    @outputVariableType.setter
    def outputVariableType(self, value: OutputVariableType | str) -> None: ...
    @property
    def store_internal(self) -> bool:
        """keep time and values in memory, to be read with ``mbs.GetSensorStoredData`` during or after the solution"""
    @store_internal.setter
    def store_internal(self, value: bool) -> None: ...
    @property
    def storeInternal(self) -> bool:
        """keep time and values in memory, to be read with ``mbs.GetSensorStoredData`` during or after the solution"""
    @storeInternal.setter
    def storeInternal(self, value: bool) -> None: ...

class SensorLoad(SensorHandle):
    """Handle: Measures the value of a load"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def load_number(self) -> LoadHandle:
        """load that is measured"""
    @load_number.setter
    def load_number(self, value: LoadIndex | int | str) -> None: ...
    @property
    def loadNumber(self) -> LoadHandle:
        """load that is measured"""
    @loadNumber.setter
    def loadNumber(self, value: LoadIndex | int | str) -> None: ...
    @property
    def write_to_file(self) -> bool:
        """write the measured values to a file while a solver runs; no effect if ``fileName`` is empty"""
    @write_to_file.setter
    def write_to_file(self, value: bool) -> None: ...
    @property
    def writeToFile(self) -> bool:
        """write the measured values to a file while a solver runs; no effect if ``fileName`` is empty"""
    @writeToFile.setter
    def writeToFile(self, value: bool) -> None: ...
    @property
    def file_name(self) -> str:
        """file with the time in the first and the values in the further columns; the path is relative to the working directory, missing directories are created"""
    @file_name.setter
    def file_name(self, value: str) -> None: ...
    @property
    def fileName(self) -> str:
        """file with the time in the first and the values in the further columns; the path is relative to the working directory, missing directories are created"""
    @fileName.setter
    def fileName(self, value: str) -> None: ...
    @property
    def store_internal(self) -> bool:
        """keep time and values in memory, to be read with ``mbs.GetSensorStoredData`` during or after the solution"""
    @store_internal.setter
    def store_internal(self, value: bool) -> None: ...
    @property
    def storeInternal(self) -> bool:
        """keep time and values in memory, to be read with ``mbs.GetSensorStoredData`` during or after the solution"""
    @storeInternal.setter
    def storeInternal(self, value: bool) -> None: ...

class SensorMarker(SensorHandle):
    """Handle: Measures an output variable of a marker"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def marker_number(self) -> MarkerHandle:
        """marker that is measured"""
    @marker_number.setter
    def marker_number(self, value: MarkerIndex | int | str) -> None: ...
    @property
    def markerNumber(self) -> MarkerHandle:
        """marker that is measured"""
    @markerNumber.setter
    def markerNumber(self, value: MarkerIndex | int | str) -> None: ...
    @property
    def write_to_file(self) -> bool:
        """write the measured values to a file while a solver runs; no effect if ``fileName`` is empty"""
    @write_to_file.setter
    def write_to_file(self, value: bool) -> None: ...
    @property
    def writeToFile(self) -> bool:
        """write the measured values to a file while a solver runs; no effect if ``fileName`` is empty"""
    @writeToFile.setter
    def writeToFile(self, value: bool) -> None: ...
    @property
    def file_name(self) -> str:
        """file with the time in the first and the values in the further columns; the path is relative to the working directory, missing directories are created"""
    @file_name.setter
    def file_name(self, value: str) -> None: ...
    @property
    def fileName(self) -> str:
        """file with the time in the first and the values in the further columns; the path is relative to the working directory, missing directories are created"""
    @fileName.setter
    def fileName(self, value: str) -> None: ...
    @property
    def output_variable_type(self) -> OutputVariableType:
        """output variable that is measured; one that the measured item does not provide is refused in Assemble"""
    @output_variable_type.setter
    def output_variable_type(self, value: OutputVariableType | str) -> None: ...
    @property
    def outputVariableType(self) -> OutputVariableType:
        """output variable that is measured; one that the measured item does not provide is refused in Assemble"""
    @outputVariableType.setter
    def outputVariableType(self, value: OutputVariableType | str) -> None: ...
    @property
    def store_internal(self) -> bool:
        """keep time and values in memory, to be read with ``mbs.GetSensorStoredData`` during or after the solution"""
    @store_internal.setter
    def store_internal(self, value: bool) -> None: ...
    @property
    def storeInternal(self) -> bool:
        """keep time and values in memory, to be read with ``mbs.GetSensorStoredData`` during or after the solution"""
    @storeInternal.setter
    def storeInternal(self, value: bool) -> None: ...

class SensorNode(SensorHandle):
    """Handle: Measures an output variable of a node"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def node_number(self) -> NodeHandle:
        """node that is measured"""
    @node_number.setter
    def node_number(self, value: NodeIndex | int | str) -> None: ...
    @property
    def nodeNumber(self) -> NodeHandle:
        """node that is measured"""
    @nodeNumber.setter
    def nodeNumber(self, value: NodeIndex | int | str) -> None: ...
    @property
    def write_to_file(self) -> bool:
        """write the measured values to a file while a solver runs; no effect if ``fileName`` is empty"""
    @write_to_file.setter
    def write_to_file(self, value: bool) -> None: ...
    @property
    def writeToFile(self) -> bool:
        """write the measured values to a file while a solver runs; no effect if ``fileName`` is empty"""
    @writeToFile.setter
    def writeToFile(self, value: bool) -> None: ...
    @property
    def file_name(self) -> str:
        """file with the time in the first and the values in the further columns; the path is relative to the working directory, missing directories are created"""
    @file_name.setter
    def file_name(self, value: str) -> None: ...
    @property
    def fileName(self) -> str:
        """file with the time in the first and the values in the further columns; the path is relative to the working directory, missing directories are created"""
    @fileName.setter
    def fileName(self, value: str) -> None: ...
    @property
    def output_variable_type(self) -> OutputVariableType:
        """output variable that is measured; one that the measured item does not provide is refused in Assemble"""
    @output_variable_type.setter
    def output_variable_type(self, value: OutputVariableType | str) -> None: ...
    @property
    def outputVariableType(self) -> OutputVariableType:
        """output variable that is measured; one that the measured item does not provide is refused in Assemble"""
    @outputVariableType.setter
    def outputVariableType(self, value: OutputVariableType | str) -> None: ...
    @property
    def store_internal(self) -> bool:
        """keep time and values in memory, to be read with ``mbs.GetSensorStoredData`` during or after the solution"""
    @store_internal.setter
    def store_internal(self, value: bool) -> None: ...
    @property
    def storeInternal(self) -> bool:
        """keep time and values in memory, to be read with ``mbs.GetSensorStoredData`` during or after the solution"""
    @storeInternal.setter
    def storeInternal(self, value: bool) -> None: ...

class SensorObject(SensorHandle):
    """Handle: Measures an output variable of a connector, constraint, joint or contact"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def object_number(self) -> ObjectHandle:
        """object that is measured; a body is refused for variables that need a local position, use SensorBody for it"""
    @object_number.setter
    def object_number(self, value: ObjectIndex | int | str) -> None: ...
    @property
    def objectNumber(self) -> ObjectHandle:
        """object that is measured; a body is refused for variables that need a local position, use SensorBody for it"""
    @objectNumber.setter
    def objectNumber(self, value: ObjectIndex | int | str) -> None: ...
    @property
    def write_to_file(self) -> bool:
        """write the measured values to a file while a solver runs; no effect if ``fileName`` is empty"""
    @write_to_file.setter
    def write_to_file(self, value: bool) -> None: ...
    @property
    def writeToFile(self) -> bool:
        """write the measured values to a file while a solver runs; no effect if ``fileName`` is empty"""
    @writeToFile.setter
    def writeToFile(self, value: bool) -> None: ...
    @property
    def file_name(self) -> str:
        """file with the time in the first and the values in the further columns; the path is relative to the working directory, missing directories are created"""
    @file_name.setter
    def file_name(self, value: str) -> None: ...
    @property
    def fileName(self) -> str:
        """file with the time in the first and the values in the further columns; the path is relative to the working directory, missing directories are created"""
    @fileName.setter
    def fileName(self, value: str) -> None: ...
    @property
    def output_variable_type(self) -> OutputVariableType:
        """output variable that is measured; one that the measured item does not provide is refused in Assemble"""
    @output_variable_type.setter
    def output_variable_type(self, value: OutputVariableType | str) -> None: ...
    @property
    def outputVariableType(self) -> OutputVariableType:
        """output variable that is measured; one that the measured item does not provide is refused in Assemble"""
    @outputVariableType.setter
    def outputVariableType(self, value: OutputVariableType | str) -> None: ...
    @property
    def store_internal(self) -> bool:
        """keep time and values in memory, to be read with ``mbs.GetSensorStoredData`` during or after the solution"""
    @store_internal.setter
    def store_internal(self, value: bool) -> None: ...
    @property
    def storeInternal(self) -> bool:
        """keep time and values in memory, to be read with ``mbs.GetSensorStoredData`` during or after the solution"""
    @storeInternal.setter
    def storeInternal(self, value: bool) -> None: ...

class SensorSuperElement(SensorHandle):
    """Handle: Measures an output variable at a mesh node of a super element"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def body_number(self) -> ObjectHandle:
        """super element that is measured"""
    @body_number.setter
    def body_number(self, value: ObjectIndex | int | str) -> None: ...
    @property
    def bodyNumber(self) -> ObjectHandle:
        """super element that is measured"""
    @bodyNumber.setter
    def bodyNumber(self, value: ObjectIndex | int | str) -> None: ...
    @property
    def mesh_node_number(self) -> int | str:
        """mesh node, numbered within the super element from 0, or the name of a link of a kinematic tree; -1 means not set and is rejected"""
    @mesh_node_number.setter
    def mesh_node_number(self, value: int | str) -> None: ...
    @property
    def meshNodeNumber(self) -> int | str:
        """mesh node, numbered within the super element from 0, or the name of a link of a kinematic tree; -1 means not set and is rejected"""
    @meshNodeNumber.setter
    def meshNodeNumber(self, value: int | str) -> None: ...
    @property
    def write_to_file(self) -> bool:
        """write the measured values to a file while a solver runs; no effect if ``fileName`` is empty"""
    @write_to_file.setter
    def write_to_file(self, value: bool) -> None: ...
    @property
    def writeToFile(self) -> bool:
        """write the measured values to a file while a solver runs; no effect if ``fileName`` is empty"""
    @writeToFile.setter
    def writeToFile(self, value: bool) -> None: ...
    @property
    def file_name(self) -> str:
        """file with the time in the first and the values in the further columns; the path is relative to the working directory, missing directories are created"""
    @file_name.setter
    def file_name(self, value: str) -> None: ...
    @property
    def fileName(self) -> str:
        """file with the time in the first and the values in the further columns; the path is relative to the working directory, missing directories are created"""
    @fileName.setter
    def fileName(self, value: str) -> None: ...
    @property
    def output_variable_type(self) -> OutputVariableType:
        """output variable that is measured; one that the measured item does not provide is refused in Assemble"""
    @output_variable_type.setter
    def output_variable_type(self, value: OutputVariableType | str) -> None: ...
    @property
    def outputVariableType(self) -> OutputVariableType:
        """output variable that is measured; one that the measured item does not provide is refused in Assemble"""
    @outputVariableType.setter
    def outputVariableType(self, value: OutputVariableType | str) -> None: ...
    @property
    def store_internal(self) -> bool:
        """keep time and values in memory, to be read with ``mbs.GetSensorStoredData`` during or after the solution"""
    @store_internal.setter
    def store_internal(self, value: bool) -> None: ...
    @property
    def storeInternal(self) -> bool:
        """keep time and values in memory, to be read with ``mbs.GetSensorStoredData`` during or after the solution"""
    @storeInternal.setter
    def storeInternal(self, value: bool) -> None: ...

class SensorUserFunction(SensorHandle):
    """Handle: Computes its values by a Python function, for instance from other sensors"""

    @property
    def name(self) -> str:
        """name of the item, unique within its kind; if empty, a name is made from kind and number"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def sensor_numbers(self) -> tuple[SensorHandle, ...]:
        """sensors that the user function may evaluate; may be empty [n]"""
    @sensor_numbers.setter
    def sensor_numbers(self, value: Sequence[SensorIndex | int | str]) -> None: ...
    @property
    def sensorNumbers(self) -> tuple[SensorHandle, ...]:
        """sensors that the user function may evaluate; may be empty [n]"""
    @sensorNumbers.setter
    def sensorNumbers(self, value: Sequence[SensorIndex | int | str]) -> None: ...
    @property
    def factors(self) -> Array:
        """values that are passed to the user function, of free meaning, such as weights or conversions of units [n; various]"""
    @factors.setter
    def factors(self, value: ArrayLike) -> None: ...
    @property
    def write_to_file(self) -> bool:
        """write the measured values to a file while a solver runs; no effect if ``fileName`` is empty"""
    @write_to_file.setter
    def write_to_file(self, value: bool) -> None: ...
    @property
    def writeToFile(self) -> bool:
        """write the measured values to a file while a solver runs; no effect if ``fileName`` is empty"""
    @writeToFile.setter
    def writeToFile(self, value: bool) -> None: ...
    @property
    def file_name(self) -> str:
        """file with the time in the first and the values in the further columns; the path is relative to the working directory, missing directories are created"""
    @file_name.setter
    def file_name(self, value: str) -> None: ...
    @property
    def fileName(self) -> str:
        """file with the time in the first and the values in the further columns; the path is relative to the working directory, missing directories are created"""
    @fileName.setter
    def fileName(self, value: str) -> None: ...
    @property
    def sensor_user_function(self) -> Callable[[MainSystem, float, list[int], Array, ConfigurationType], ArrayLike] | Literal[0]:
        """Python function that returns the values of the sensor"""
    @sensor_user_function.setter
    def sensor_user_function(self, value: Callable[[MainSystem, float, list[int], Array, ConfigurationType], ArrayLike] | Literal[0]) -> None: ...
    @property
    def sensorUserFunction(self) -> Callable[[MainSystem, float, list[int], Array, ConfigurationType], ArrayLike] | Literal[0]:
        """Python function that returns the values of the sensor"""
    @sensorUserFunction.setter
    def sensorUserFunction(self, value: Callable[[MainSystem, float, list[int], Array, ConfigurationType], ArrayLike] | Literal[0]) -> None: ...
    @property
    def store_internal(self) -> bool:
        """keep time and values in memory, to be read with ``mbs.GetSensorStoredData`` during or after the solution"""
    @store_internal.setter
    def store_internal(self, value: bool) -> None: ...
    @property
    def storeInternal(self) -> bool:
        """keep time and values in memory, to be read with ``mbs.GetSensorStoredData`` during or after the solution"""
    @storeInternal.setter
    def storeInternal(self, value: bool) -> None: ...
