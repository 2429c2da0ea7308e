// Generated from specs/ by codegen/templates/item_texts.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/reflection/own_items.hpp"

#include <array>

namespace dalembert {
namespace item_texts_of {

constexpr std::array<std::string_view, 5> NodeGenericAE_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "reference values; their number is ``numberOfAECoordinates``; units are those of the equations that use the node",
    "start values of the solver, relative to the reference values; their number is ``numberOfAECoordinates``",
    "number of algebraic variables; at least 1",
    "True: the item is drawn",
};
constexpr std::array<OutputText, 1> NodeGenericAE_outputs{{
    {"Coordinates", 0, "various", "algebraic variables, relative to the reference values"},
}};

constexpr std::array<std::string_view, 4> NodeGenericData_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "values at the start of a computation; their number is ``numberOfDataCoordinates``, or zero (all values are zero); other lengths are rejected; their meaning and units are those of the object that uses the node",
    "number of data variables; objects that need a data node say how many they expect",
    "True: the item is drawn",
};
constexpr std::array<OutputText, 1> NodeGenericData_outputs{{
    {"Coordinates", 0, "various", "data variables; there are no reference values and no time derivatives"},
}};

constexpr std::array<std::string_view, 5> NodeGenericODE1_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "constant values to which the coordinates are added; their number is ``numberOfODE1Coordinates``, or zero (all values are zero); other lengths are rejected; units are those of the equations that use the node",
    "values at the start, relative to the reference values; their number is ``numberOfODE1Coordinates``",
    "number of coordinates, each with a first order differential equation; at least 1",
    "True: the item is drawn",
};
constexpr std::array<OutputText, 3> NodeGenericODE1_outputs{{
    {"CoordinatesTotal", 0, "various", "coordinates plus reference coordinates"},
    {"Coordinates", 0, "various", "coordinates without the reference coordinates, so zero in the reference configuration"},
    {"Coordinates_t", 0, "various", "first time derivative of the coordinates"},
}};

constexpr std::array<std::string_view, 6> NodeGenericODE2_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "constant values to which the coordinates are added; their number is ``numberOfODE2Coordinates``, or zero (all values are zero); other lengths are rejected; units are those of the equations that use the node",
    "values at the start, relative to the reference values; their number is ``numberOfODE2Coordinates``",
    "time derivatives of the coordinates at the start; their number is ``numberOfODE2Coordinates``",
    "number of coordinates, each with a second order differential equation; at least 1",
    "True: the item is drawn",
};
constexpr std::array<OutputText, 4> NodeGenericODE2_outputs{{
    {"CoordinatesTotal", 0, "various", "coordinates plus reference coordinates"},
    {"Coordinates", 0, "various", "coordinates without the reference coordinates, so zero in the reference configuration"},
    {"Coordinates_t", 0, "various", "first time derivative of the coordinates"},
    {"Coordinates_tt", 0, "various", "second time derivative of the coordinates"},
}};

constexpr std::array<std::string_view, 5> Node1D_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "reference value of the coordinate, a list of length 1, or an empty one for zero; m for a translation, rad for a rotation, as the body on the node says",
    "coordinate at the start, relative to the reference value, a list of length 1, or an empty one for zero",
    "time derivative of the coordinate at the start, a list of length 1, or an empty one for zero",
    "True: the item is drawn",
};
constexpr std::array<OutputText, 4> Node1D_outputs{{
    {"CoordinatesTotal", 0, "various", "coordinates plus reference coordinates"},
    {"Coordinates", 0, "various", "coordinates without the reference coordinates, so zero in the reference configuration"},
    {"Coordinates_t", 0, "various", "first time derivative of the coordinates"},
    {"Coordinates_tt", 0, "various", "second time derivative of the coordinates"},
}};

constexpr std::array<std::string_view, 7> NodePoint_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "global position of the node without displacement",
    "displacement from the reference position at the start",
    "global velocity at the start",
    "False: the item is not drawn",
    "size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 13> NodePoint_outputs{{
    {"Position", 3, "m", "global position vector"},
    {"Displacement", 3, "m", "global position minus the global position in the reference configuration"},
    {"Velocity", 3, "m/s", "global velocity"},
    {"Acceleration", 3, "m/s^2", "global acceleration"},
    {"CoordinatesTotal", 0, "m", "coordinates plus reference coordinates"},
    {"Coordinates", 0, "m", "coordinates without the reference coordinates, so zero in the reference configuration"},
    {"Coordinates_t", 0, "m/s", "first time derivative of the coordinates"},
    {"Coordinates_tt", 0, "m/s^2", "second time derivative of the coordinates"},
    {"RotationMatrix", 9, "1", "identity matrix, row by row, as the node has no orientation"},
    {"Rotation", 3, "rad", "zero, as the node has no orientation; there for completeness"},
    {"AngularVelocity", 3, "rad/s", "zero, as the node has no orientation; there for completeness"},
    {"AngularVelocityLocal", 3, "rad/s", "zero, as the node has no orientation; there for completeness"},
    {"HomogeneousTransformation", 16, "various", "position and rotation as a 4 x 4 matrix, row by row; output functions return ``exu.HT``"},
}};

constexpr std::array<std::string_view, 7> NodePoint2D_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "global x and y position of the node without displacement; z is zero",
    "displacement in x and y from the reference position at the start",
    "global velocity in x and y at the start",
    "False: the item is not drawn",
    "size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 13> NodePoint2D_outputs{{
    {"Position", 3, "m", "global position; the third component is zero"},
    {"Displacement", 3, "m", "global displacement; the third component is zero"},
    {"Velocity", 3, "m/s", "global velocity; the third component is zero"},
    {"Acceleration", 3, "m/s^2", "global acceleration; the third component is zero"},
    {"CoordinatesTotal", 0, "m", "coordinates plus reference coordinates"},
    {"Coordinates", 0, "m", "coordinates without the reference coordinates, so zero in the reference configuration"},
    {"Coordinates_t", 0, "m/s", "first time derivative of the coordinates"},
    {"Coordinates_tt", 0, "m/s^2", "second time derivative of the coordinates"},
    {"RotationMatrix", 9, "1", "identity matrix, row by row, as the node has no orientation"},
    {"Rotation", 3, "rad", "zero, as the node has no orientation; there for completeness"},
    {"AngularVelocity", 3, "rad/s", "zero, as the node has no orientation; there for completeness"},
    {"AngularVelocityLocal", 3, "rad/s", "zero, as the node has no orientation; there for completeness"},
    {"HomogeneousTransformation", 16, "various", "position and rotation as a 4 x 4 matrix, row by row; output functions return ``exu.HT``"},
}};

constexpr std::array<std::string_view, 7> NodePoint2DSlope1_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "x and y position (m), then x and y component of the slope vector (1); a unit vector along the axis for an element that is not stretched in the reference configuration",
    "displacement (m) and change of the slope vector (1) at the start, relative to the reference coordinates",
    "velocity (m/s) and rate of the slope vector (1/s) at the start",
    "False: the item is not drawn",
    "size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 8> NodePoint2DSlope1_outputs{{
    {"Position", 3, "m", "global position vector"},
    {"Displacement", 3, "m", "global position minus the global position in the reference configuration"},
    {"Velocity", 3, "m/s", "global velocity"},
    {"Acceleration", 3, "m/s^2", "global acceleration"},
    {"CoordinatesTotal", 0, "various", "x and y position (m), then the slope vector (1)"},
    {"Coordinates", 0, "various", "displacement (m) and change of the slope vector (1), relative to the reference coordinates"},
    {"Coordinates_t", 0, "various", "velocity (m/s) and rate of the slope vector (1/s)"},
    {"Coordinates_tt", 0, "various", "acceleration (m/s^2) and second rate of the slope vector (1/s^2)"},
}};

constexpr std::array<std::string_view, 5> NodePointGround_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "global position of the node",
    "False: the item is not drawn",
    "size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 11> NodePointGround_outputs{{
    {"Position", 3, "m", "global position; always the reference position"},
    {"Displacement", 3, "m", "zero"},
    {"Velocity", 3, "m/s", "zero"},
    {"CoordinatesTotal", 0, "various", "empty, as the node has no coordinates"},
    {"Coordinates", 0, "various", "empty, as the node has no coordinates"},
    {"Coordinates_t", 0, "various", "empty, as the node has no coordinates"},
    {"RotationMatrix", 9, "1", "identity matrix, row by row, as the node has no orientation"},
    {"Rotation", 3, "rad", "zero, as the node has no orientation; there for completeness"},
    {"AngularVelocity", 3, "rad/s", "zero, as the node has no orientation; there for completeness"},
    {"AngularVelocityLocal", 3, "rad/s", "zero, as the node has no orientation; there for completeness"},
    {"HomogeneousTransformation", 16, "various", "position and rotation as a 4 x 4 matrix, row by row; output functions return ``exu.HT``"},
}};

constexpr std::array<std::string_view, 7> NodePointSlope1_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "global position (m), then the slope vector (1); a unit vector along the axis for an element that is not stretched in the reference configuration",
    "displacement (m) and change of the slope vector (1) at the start, relative to the reference coordinates",
    "velocity (m/s) and rate of the slope vector (1/s) at the start",
    "False: the item is not drawn",
    "size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 8> NodePointSlope1_outputs{{
    {"Position", 3, "m", "global position vector"},
    {"Displacement", 3, "m", "global position minus the global position in the reference configuration"},
    {"Velocity", 3, "m/s", "global velocity"},
    {"Acceleration", 3, "m/s^2", "global acceleration"},
    {"CoordinatesTotal", 0, "various", "position (m), then the slope vector (1)"},
    {"Coordinates", 0, "various", "displacement (m) and change of the slope vector (1), relative to the reference coordinates"},
    {"Coordinates_t", 0, "various", "velocity (m/s) and rate of the slope vector (1/s)"},
    {"Coordinates_tt", 0, "various", "acceleration (m/s^2) and second rate of the slope vector (1/s^2)"},
}};

constexpr std::array<std::string_view, 7> NodePointSlope12_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "global position (m), then the slope vectors in x and y (1); the two default slopes are parallel and so span no frame: give independent ones",
    "displacement (m) and change of the slope vectors (1) at the start, relative to the reference coordinates",
    "velocity (m/s) and rates of the slope vectors (1/s) at the start",
    "False: the item is not drawn",
    "size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 13> NodePointSlope12_outputs{{
    {"Position", 3, "m", "global position vector"},
    {"Displacement", 3, "m", "global position minus the global position in the reference configuration"},
    {"Velocity", 3, "m/s", "global velocity"},
    {"Acceleration", 3, "m/s^2", "global acceleration"},
    {"CoordinatesTotal", 0, "various", "position (m), then the two slope vectors (1)"},
    {"Coordinates", 0, "various", "displacement (m) and change of the slope vectors (1), relative to the reference coordinates"},
    {"Coordinates_t", 0, "various", "velocity (m/s) and rates of the slope vectors (1/s)"},
    {"Coordinates_tt", 0, "various", "acceleration (m/s^2) and second rates of the slope vectors (1/s^2)"},
    {"RotationMatrix", 9, "1", "rotation matrix from the body frame to the global frame, row by row"},
    {"Rotation", 3, "rad", "Tait-Bryan angles of the rotation matrix, for rotations about x, y and z in turn"},
    {"AngularVelocity", 3, "rad/s", "angular velocity in global coordinates"},
    {"AngularVelocityLocal", 3, "rad/s", "angular velocity in body coordinates"},
    {"HomogeneousTransformation", 16, "various", "position and rotation as a 4 x 4 matrix, row by row; output functions return ``exu.HT``"},
}};

constexpr std::array<std::string_view, 7> NodePointSlope23_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "global position (m), then the slope vectors in y and z (1); the two default slopes are parallel and so span no frame: give independent ones",
    "displacement (m) and change of the slope vectors (1) at the start, relative to the reference coordinates",
    "velocity (m/s) and rates of the slope vectors (1/s) at the start",
    "False: the item is not drawn",
    "size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 13> NodePointSlope23_outputs{{
    {"Position", 3, "m", "global position vector"},
    {"Displacement", 3, "m", "global position minus the global position in the reference configuration"},
    {"Velocity", 3, "m/s", "global velocity"},
    {"Acceleration", 3, "m/s^2", "global acceleration"},
    {"CoordinatesTotal", 0, "various", "position (m), then the two slope vectors (1)"},
    {"Coordinates", 0, "various", "displacement (m) and change of the slope vectors (1), relative to the reference coordinates"},
    {"Coordinates_t", 0, "various", "velocity (m/s) and rates of the slope vectors (1/s)"},
    {"Coordinates_tt", 0, "various", "acceleration (m/s^2) and second rates of the slope vectors (1/s^2)"},
    {"RotationMatrix", 9, "1", "rotation matrix from the body frame to the global frame, row by row"},
    {"Rotation", 3, "rad", "Tait-Bryan angles of the rotation matrix, for rotations about x, y and z in turn"},
    {"AngularVelocity", 3, "rad/s", "angular velocity in global coordinates"},
    {"AngularVelocityLocal", 3, "rad/s", "angular velocity in body coordinates"},
    {"HomogeneousTransformation", 16, "various", "position and rotation as a 4 x 4 matrix, row by row; output functions return ``exu.HT``"},
}};

constexpr std::array<std::string_view, 7> NodeRigidBody2D_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "x and y position of the reference point (m) and the angle about z (rad) without displacement and rotation",
    "displacement in x and y (m) and rotation about z (rad) at the start, relative to the reference coordinates",
    "velocity in x and y (m/s) and angular velocity about z (rad/s) at the start",
    "False: the item is not drawn",
    "size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 14> NodeRigidBody2D_outputs{{
    {"Position", 3, "m", "global position; the third component is zero"},
    {"Displacement", 3, "m", "global position minus the global position in the reference configuration"},
    {"Velocity", 3, "m/s", "global velocity"},
    {"Acceleration", 3, "m/s^2", "global acceleration"},
    {"AngularVelocity", 3, "rad/s", "angular velocity in global coordinates"},
    {"CoordinatesTotal", 0, "various", "x and y position (m) and angle about z (rad)"},
    {"Coordinates", 0, "various", "displacement (m) and rotation about z (rad), relative to the reference coordinates"},
    {"Coordinates_t", 0, "various", "velocity (m/s) and angular velocity (rad/s)"},
    {"Coordinates_tt", 0, "various", "acceleration (m/s^2) and angular acceleration (rad/s^2)"},
    {"RotationMatrix", 9, "1", "rotation matrix from the body frame to the global frame, row by row"},
    {"Rotation", 3, "rad", "only the third component is not zero: the angle about z, including its reference value"},
    {"AngularVelocityLocal", 3, "rad/s", "angular velocity in body coordinates"},
    {"AngularAcceleration", 3, "rad/s^2", "angular acceleration in global coordinates"},
    {"HomogeneousTransformation", 16, "various", "position and rotation as a 4 x 4 matrix, row by row; output functions return ``exu.HT``"},
}};

constexpr std::array<std::string_view, 8> NodeRigidBodyEP_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "position of the reference point (m) and four Euler parameters (1), the scalar one first; their norm must be 1, so that the default of zeros is refused; [1, 0, 0, 0] is no rotation",
    "displacement (m) and change of the Euler parameters (1) at the start; the sum of reference and initial Euler parameters must have norm 1",
    "velocity (m/s) and time derivatives of the Euler parameters (1/s) at the start; for a given angular velocity they are 1/4 ^bG^T ^bω",
    "true: the node adds the equation that keeps the norm of the Euler parameters, with one algebraic variable; false: the norm has to be kept by a constraint of the model",
    "False: the item is not drawn",
    "size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 14> NodeRigidBodyEP_outputs{{
    {"Position", 3, "m", "global position vector"},
    {"Displacement", 3, "m", "global position minus the global position in the reference configuration"},
    {"Velocity", 3, "m/s", "global velocity"},
    {"Acceleration", 3, "m/s^2", "global acceleration"},
    {"CoordinatesTotal", 0, "various", "position (m) and Euler parameters (1)"},
    {"Coordinates", 0, "various", "displacement (m) and Euler parameters (1), relative to the reference coordinates"},
    {"Coordinates_t", 0, "various", "velocity (m/s) and time derivatives of the Euler parameters (1/s)"},
    {"Coordinates_tt", 0, "various", "acceleration (m/s^2) and second time derivatives of the Euler parameters (1/s^2)"},
    {"RotationMatrix", 9, "1", "rotation matrix from the body frame to the global frame, row by row"},
    {"Rotation", 3, "rad", "Tait-Bryan angles of the rotation matrix, for rotations about x, y and z in turn"},
    {"AngularVelocity", 3, "rad/s", "angular velocity in global coordinates"},
    {"AngularVelocityLocal", 3, "rad/s", "angular velocity in body coordinates"},
    {"AngularAcceleration", 3, "rad/s^2", "angular acceleration in global coordinates"},
    {"HomogeneousTransformation", 16, "various", "position and rotation as a 4 x 4 matrix, row by row; output functions return ``exu.HT``"},
}};

constexpr std::array<std::string_view, 7> NodeRigidBodyRotVecLG_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "position of the reference point (m) and rotation vector (rad) without displacement and rotation",
    "displacement (m) and change of the rotation vector (rad) at the start; reference and initial rotation vector are added as vectors",
    "velocity (m/s) and angular velocity in body coordinates (rad/s) at the start",
    "False: the item is not drawn",
    "size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 12> NodeRigidBodyRotVecLG_outputs{{
    {"Position", 3, "m", "global position vector"},
    {"Displacement", 3, "m", "global position minus the global position in the reference configuration"},
    {"Velocity", 3, "m/s", "global velocity"},
    {"Acceleration", 3, "m/s^2", "global acceleration"},
    {"CoordinatesTotal", 0, "various", "position (m) and rotation vector (rad)"},
    {"Coordinates", 0, "various", "displacement (m) and rotation vector (rad), relative to the reference coordinates"},
    {"Coordinates_t", 0, "various", "velocity (m/s) and angular velocity in body coordinates (rad/s)"},
    {"RotationMatrix", 9, "1", "rotation matrix from the body frame to the global frame, row by row"},
    {"Rotation", 3, "rad", "Tait-Bryan angles of the rotation matrix, for rotations about x, y and z in turn"},
    {"AngularVelocity", 3, "rad/s", "angular velocity in global coordinates"},
    {"AngularVelocityLocal", 3, "rad/s", "angular velocity in body coordinates"},
    {"HomogeneousTransformation", 16, "various", "position and rotation as a 4 x 4 matrix, row by row; output functions return ``exu.HT``"},
}};

constexpr std::array<std::string_view, 7> NodeRigidBodyRxyz_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "position of the reference point (m) and the angles (rad) without displacement and rotation",
    "displacement (m) and change of the angles (rad) at the start, relative to the reference coordinates",
    "velocity (m/s) and time derivatives of the angles (rad/s) at the start; the latter are not the components of the angular velocity, except at zero angles",
    "False: the item is not drawn",
    "size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 14> NodeRigidBodyRxyz_outputs{{
    {"Position", 3, "m", "global position vector"},
    {"Displacement", 3, "m", "global position minus the global position in the reference configuration"},
    {"Velocity", 3, "m/s", "global velocity"},
    {"Acceleration", 3, "m/s^2", "global acceleration"},
    {"CoordinatesTotal", 0, "various", "position (m) and angles (rad)"},
    {"Coordinates", 0, "various", "displacement (m) and angles (rad), relative to the reference coordinates"},
    {"Coordinates_t", 0, "various", "velocity (m/s) and time derivatives of the angles (rad/s)"},
    {"Coordinates_tt", 0, "various", "acceleration (m/s^2) and second time derivatives of the angles (rad/s^2)"},
    {"RotationMatrix", 9, "1", "rotation matrix from the body frame to the global frame, row by row"},
    {"Rotation", 3, "rad", "total Tait-Bryan angles of the node, as given by its coordinates; not reduced to one turn"},
    {"AngularVelocity", 3, "rad/s", "angular velocity in global coordinates"},
    {"AngularVelocityLocal", 3, "rad/s", "angular velocity in body coordinates"},
    {"AngularAcceleration", 3, "rad/s^2", "angular acceleration in global coordinates"},
    {"HomogeneousTransformation", 16, "various", "position and rotation as a 4 x 4 matrix, row by row; output functions return ``exu.HT``"},
}};

constexpr std::array<std::string_view, 9> ObjectGenericODE1_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "nodes with first order coordinates; their coordinates in this order form the vector of the object",
    "constant system matrix; n rows and n columns for n coordinates, or empty for zero; other sizes are refused",
    "constant right hand side; length n, or empty for zero",
    "function that gives a further right hand side, of time and coordinates",
    "index of the first coordinate of each node in the vector of the object",
    "coordinates, a work space of the object",
    "time derivatives of the coordinates, a work space of the object",
    "False: the item is not drawn",
};
constexpr std::array<OutputText, 3> ObjectGenericODE1_outputs{{
    {"CoordinatesTotal", 0, "various", "coordinates of all nodes of the object, including the reference values"},
    {"Coordinates", 0, "various", "coordinates of all nodes of the object, relative to the reference values"},
    {"Coordinates_t", 0, "various", "time derivatives of the coordinates of all nodes of the object"},
}};

constexpr std::array<std::string_view, 6> ObjectGround_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "global position of the origin of the ground frame; local positions of markers count from here",
    "rotation matrix from the ground frame to the global frame",
    "False: the item is not drawn",
    "function that returns the shapes to be drawn, called at every redraw; shapes are given in the frame of the body",
    "shapes attached to the body frame, as made by the functions of the graphics module",
};
constexpr std::array<OutputText, 6> ObjectGround_outputs{{
    {"Position", 3, "m", "global position of the local point"},
    {"Displacement", 3, "m", "zero"},
    {"Velocity", 3, "m/s", "zero"},
    {"AngularVelocity", 3, "rad/s", "zero"},
    {"RotationMatrix", 9, "1", "rotation matrix from the body frame to the global frame, row by row"},
    {"HomogeneousTransformation", 16, "various", "position and rotation as a 4 x 4 matrix, row by row; output functions return ``exu.HT``"},
}};

constexpr std::array<std::string_view, 7> ObjectMass1D_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "mass; zero is allowed if something else makes the equation of the node regular",
    "node with one coordinate of second order, which is the way (m) along the local x-axis",
    "global position of the body at coordinate zero",
    "constant rotation matrix from the body frame to the global frame; its first column is the direction of motion; a reflection gives a warning",
    "False: the item is not drawn",
    "shapes attached to the body frame, as made by the functions of the graphics module",
};
constexpr std::array<OutputText, 10> ObjectMass1D_outputs{{
    {"Position", 3, "m", "global position vector"},
    {"Displacement", 3, "m", "global position minus the global position in the reference configuration"},
    {"Velocity", 3, "m/s", "global velocity"},
    {"RotationMatrix", 9, "1", "the parameter ``referenceRotation``, row by row"},
    {"Rotation", 3, "rad", "Tait-Bryan angles of the rotation matrix, for rotations about x, y and z in turn"},
    {"AngularVelocity", 3, "rad/s", "zero"},
    {"AngularVelocityLocal", 3, "rad/s", "zero"},
    {"HomogeneousTransformation", 16, "various", "position and rotation as a 4 x 4 matrix, row by row; output functions return ``exu.HT``"},
    {"KineticEnergy", 1, "J", "kinetic energy of the whole body; the local position has no influence"},
    {"PotentialEnergy", 1, "J", "zero: a point has no strains, and weight is a load"},
}};

constexpr std::array<std::string_view, 5> ObjectMassPoint_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "mass; zero is allowed if something else makes the equations of the node regular",
    "node with a position in space and three displacement coordinates",
    "False: the item is not drawn",
    "shapes attached to the body frame, as made by the functions of the graphics module",
};
constexpr std::array<OutputText, 11> ObjectMassPoint_outputs{{
    {"Position", 3, "m", "global position of the local point"},
    {"Displacement", 3, "m", "global displacement, the same for all local points"},
    {"Velocity", 3, "m/s", "global velocity"},
    {"Acceleration", 3, "m/s^2", "global acceleration"},
    {"RotationMatrix", 9, "1", "identity matrix, row by row, as the body does not rotate"},
    {"Rotation", 3, "rad", "zero, as the body does not rotate; there for completeness"},
    {"AngularVelocity", 3, "rad/s", "zero, as the body does not rotate; there for completeness"},
    {"AngularVelocityLocal", 3, "rad/s", "zero, as the body does not rotate; there for completeness"},
    {"HomogeneousTransformation", 16, "various", "position and rotation as a 4 x 4 matrix, row by row; output functions return ``exu.HT``"},
    {"KineticEnergy", 1, "J", "kinetic energy of the whole body; the local position has no influence"},
    {"PotentialEnergy", 1, "J", "zero: a point has no strains, and weight is a load"},
}};

constexpr std::array<std::string_view, 5> ObjectMassPoint2D_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "mass; zero is allowed if something else makes the equations of the node regular",
    "node with a position in the plane and two displacement coordinates",
    "False: the item is not drawn",
    "shapes attached to the body frame, as made by the functions of the graphics module",
};
constexpr std::array<OutputText, 11> ObjectMassPoint2D_outputs{{
    {"Position", 3, "m", "global position of the local point"},
    {"Displacement", 3, "m", "global displacement, the same for all local points; the third component is zero"},
    {"Velocity", 3, "m/s", "global velocity; the third component is zero"},
    {"Acceleration", 3, "m/s^2", "global acceleration; the third component is zero"},
    {"RotationMatrix", 9, "1", "identity matrix, row by row, as the body does not rotate"},
    {"Rotation", 3, "rad", "zero, as the body does not rotate; there for completeness"},
    {"AngularVelocity", 3, "rad/s", "zero, as the body does not rotate; there for completeness"},
    {"AngularVelocityLocal", 3, "rad/s", "zero, as the body does not rotate; there for completeness"},
    {"HomogeneousTransformation", 16, "various", "position and rotation as a 4 x 4 matrix, row by row; output functions return ``exu.HT``"},
    {"KineticEnergy", 1, "J", "kinetic energy of the whole body; the local position has no influence"},
    {"PotentialEnergy", 1, "J", "zero: a point has no strains, and weight is a load"},
}};

constexpr std::array<std::string_view, 8> ObjectRigidBody_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "mass",
    "components [J_xx, J_yy, J_zz, J_yz, J_xz, J_xy] of the inertia tensor in the body frame about the reference point, which is the node, and not about the center of mass; off-diagonal components are those of the tensor, J_xy = -∫ x y dm",
    "position of the center of mass in the body frame, counted from the node",
    "node of a rigid body in space",
    "False: the item is not drawn",
    "function that returns the shapes to be drawn, called at every redraw; shapes are given in the frame of the body",
    "shapes attached to the body frame, as made by the functions of the graphics module",
};
constexpr std::array<OutputText, 15> ObjectRigidBody_outputs{{
    {"Position", 3, "m", "global position of the local point"},
    {"Displacement", 3, "m", "global displacement of the local point from its place in the reference configuration"},
    {"Velocity", 3, "m/s", "global velocity of the local point"},
    {"VelocityLocal", 3, "m/s", "velocity of the local point in body coordinates"},
    {"RotationMatrix", 9, "1", "rotation matrix from the body frame to the global frame, row by row"},
    {"Rotation", 3, "rad", "Tait-Bryan angles of the rotation matrix, for rotations about x, y and z in turn"},
    {"AngularVelocity", 3, "rad/s", "angular velocity in global coordinates"},
    {"AngularVelocityLocal", 3, "rad/s", "angular velocity in body coordinates"},
    {"Acceleration", 3, "m/s^2", "global acceleration of the local point"},
    {"AccelerationLocal", 3, "m/s^2", "acceleration of the local point in body coordinates"},
    {"AngularAcceleration", 3, "rad/s^2", "angular acceleration in global coordinates"},
    {"AngularAccelerationLocal", 3, "rad/s^2", "angular acceleration in body coordinates"},
    {"HomogeneousTransformation", 16, "various", "position and rotation as a 4 x 4 matrix, row by row; output functions return ``exu.HT``"},
    {"KineticEnergy", 1, "J", "kinetic energy of the whole body; the local position has no influence"},
    {"PotentialEnergy", 1, "J", "zero: a rigid body has no strains, and weight is a load"},
}};

constexpr std::array<std::string_view, 8> ObjectRigidBody2D_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "mass",
    "moment of inertia about the z-axis through the reference point, which is the node, and not through the center of mass",
    "x and y position of the center of mass in the body frame, counted from the node",
    "node of a rigid body in the plane",
    "False: the item is not drawn",
    "function that returns the shapes to be drawn, called at every redraw; shapes are given in the frame of the body",
    "shapes attached to the body frame, as made by the functions of the graphics module",
};
constexpr std::array<OutputText, 15> ObjectRigidBody2D_outputs{{
    {"Position", 3, "m", "global position of the local point"},
    {"Displacement", 3, "m", "global displacement of the local point from its place in the reference configuration"},
    {"Velocity", 3, "m/s", "global velocity of the local point"},
    {"VelocityLocal", 3, "m/s", "velocity of the local point in body coordinates"},
    {"RotationMatrix", 9, "1", "rotation matrix from the body frame to the global frame, row by row"},
    {"Rotation", 1, "rad", "angle about z, counted from the reference configuration, in which it is the reference angle; not reduced to one turn (the node's output includes the reference angle)"},
    {"AngularVelocity", 3, "rad/s", "angular velocity in global coordinates"},
    {"AngularVelocityLocal", 3, "rad/s", "angular velocity in body coordinates"},
    {"Acceleration", 3, "m/s^2", "global acceleration of the local point"},
    {"AccelerationLocal", 3, "m/s^2", "acceleration of the local point in body coordinates"},
    {"AngularAcceleration", 3, "rad/s^2", "angular acceleration in global coordinates"},
    {"AngularAccelerationLocal", 3, "rad/s^2", "angular acceleration in body coordinates"},
    {"HomogeneousTransformation", 16, "various", "position and rotation as a 4 x 4 matrix, row by row; output functions return ``exu.HT``"},
    {"KineticEnergy", 1, "J", "kinetic energy of the whole body; the local position has no influence"},
    {"PotentialEnergy", 1, "J", "zero: a rigid body has no strains, and weight is a load"},
}};

constexpr std::array<std::string_view, 7> ObjectRotationalMass1D_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "moment of inertia about the axis of rotation",
    "node with one coordinate of second order, which is the angle (rad) about the local z-axis",
    "global position of the body frame, a fixed point of the axis",
    "constant rotation matrix from the frame at angle zero to the global frame; its third column is the axis of rotation",
    "False: the item is not drawn",
    "shapes attached to the body frame, as made by the functions of the graphics module",
};
constexpr std::array<OutputText, 10> ObjectRotationalMass1D_outputs{{
    {"Position", 3, "m", "global position of the local point, which turns with the body"},
    {"Displacement", 3, "m", "global position minus the global position in the reference configuration"},
    {"Velocity", 3, "m/s", "global velocity"},
    {"RotationMatrix", 9, "1", "rotation matrix from the body frame to the global frame, row by row"},
    {"Rotation", 1, "rad", "angle about the axis, including its reference value; not reduced to one turn"},
    {"AngularVelocity", 3, "rad/s", "angular velocity in global coordinates"},
    {"AngularVelocityLocal", 3, "rad/s", "angular velocity in body coordinates; only the third component is not zero"},
    {"HomogeneousTransformation", 16, "various", "position and rotation as a 4 x 4 matrix, row by row; output functions return ``exu.HT``"},
    {"KineticEnergy", 1, "J", "kinetic energy of the whole body; the local position has no influence"},
    {"PotentialEnergy", 1, "J", "zero: a rigid body has no strains, and weight is a load"},
}};

constexpr std::array<std::string_view, 25> ObjectFFRF_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "first the rigid body node of the body frame, then the points of the mesh, each a NodePoint; reference positions and displacements of the latter are components in the body frame",
    "mass matrix of the free mesh, without the coordinates of the body frame; three rows and columns per mesh node, with the same masses in all directions",
    "stiffness matrix of the free mesh in the body frame; three rows and columns per mesh node",
    "damping matrix of the free mesh in the body frame; three rows and columns per mesh node, or empty for zero",
    "constant generalized forces on the right hand side, for body frame and mesh, in global components; those of the mesh are turned into the body frame; empty for zero",
    "function that gives further generalized forces on the right hand side",
    "function that gives an additional mass matrix for all coordinates; its dependence on them is left out of the tangent",
    "true: inertia, stiffness and damping of rigid body motion and deformation are computed by the object; false: the user functions supply all forces and the mass matrix",
    "index of the first coordinate of each node in the vector of the object",
    "leave it at false; the object sets it when its constant matrices are computed in ``Assemble()``, and setting it back to false has them computed anew",
    "total mass, from the mass matrix",
    "inertia tensor of the undeformed body about the origin of the body frame, from the mass matrix",
    "center of mass of the undeformed body in the body frame, from the mass matrix",
    "product of the transposed translation modes and the mass matrix, a work space of the object",
    "reference positions of the mesh nodes in the body frame, three per node",
    "work space of the object",
    "flexible coordinates, a work space of the object",
    "rates of the flexible coordinates, a work space of the object",
    "skew symmetric matrices of the deformed local positions, a work space of the object",
    "skew symmetric matrices of the local velocities, a work space of the object",
    "False: the item is not drawn",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
    "surface triangles, one row with three positions in ``nodeNumbers`` each (counted from 0); empty: no surface is drawn",
    "draw the nodes of the object at their deformed positions, whether or not the nodes themselves are shown",
};
constexpr std::array<OutputText, 6> ObjectFFRF_outputs{{
    {"Coordinates", 0, "various", "coordinates of all nodes of the object, relative to the reference values"},
    {"Coordinates_t", 0, "various", "first time derivatives of the coordinates of all nodes"},
    {"Coordinates_tt", 0, "various", "second time derivatives of the coordinates of all nodes"},
    {"Force", 0, "various", "generalized forces of the object without inertia, one per coordinate, as they stand on the left hand side of the equations of motion"},
    {"KineticEnergy", 1, "J", "kinetic energy of the whole body; the local position has no influence"},
    {"PotentialEnergy", 1, "J", "strain energy of the mesh; not available with a force user function"},
}};

constexpr std::array<std::string_view, 28> ObjectFFRFreducedOrder_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "two nodes: the rigid body node of the body frame, and a ``NodeGenericODE2`` with the modal coordinates, whose reference coordinates are zero",
    "modal mass matrix, one row and column per mode, dense or sparse",
    "modal stiffness matrix, one row and column per mode, dense or sparse; empty for zero",
    "modal damping matrix, one row and column per mode; empty for zero",
    "function that gives generalized forces on the right hand side",
    "function that gives an additional mass matrix for all coordinates; its dependence on them is left out of the tangent",
    "True: the object computes inertia with its coupling of rigid body motion and deformation, stiffness and damping; False: only the user functions act",
    "one column per mode, three rows per mesh node: displacements of the mesh in the body frame for a unit modal coordinate",
    "values of an output variable per unit modal coordinate, one row per mesh node; each mode has six columns, its components; empty: not used",
    "output variable that ``outputVariableModeBasis`` holds: ``StressLocal``, ``StrainLocal``, or ``_None``",
    "reference positions of the mesh nodes in the body frame, three per node",
    "leave it at False; ``Assemble()`` sets it, when it has found the parameters that follow from others",
    "total mass",
    "inertia tensor of the undeformed body about the origin of the body frame",
    "center of mass of the undeformed body in the body frame",
    "coupling of rotations and modes that changes with deformation: block i, j is -∫ ψ_i × ψ_j dm; empty: ``Assemble()`` finds it from ``mPsiTildePsiTilde``",
    "inertia of the deformation: block i, j is -∫ ψ_i ψ_j dm",
    "coupling of translations and modes: column j is ∫ ψ_j dm",
    "the skew symmetric matrices of the columns of ``mPhitTPsi``; empty: ``Assemble()`` finds it",
    "coupling of rotations and modes: column j is -∫ x × ψ_j dm; empty: ``Assemble()`` finds it from ``mXRefTildePsiTilde``",
    "what deformation does to the inertia: block j is -∫ x ψ_j dm",
    "skew symmetric matrix of the center of mass, found by ``Assemble()``",
    "user forces, a work space of the object",
    "False: the item is not drawn",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
    "surface triangles, one row with three positions in ``nodeNumbers`` each (counted from 0); empty: no surface is drawn",
    "draw the mesh nodes at their deformed positions",
};
constexpr std::array<OutputText, 5> ObjectFFRFreducedOrder_outputs{{
    {"Coordinates", 0, "various", "coordinates of both nodes, relative to the reference values"},
    {"Coordinates_t", 0, "various", "first time derivatives of the coordinates of both nodes"},
    {"Force", 0, "various", "generalized forces of the object without accelerations, one per coordinate, as they stand on the left hand side of the equations of motion: elastic forces and those that are quadratic in velocities"},
    {"KineticEnergy", 1, "J", "kinetic energy of the whole body; the local position has no influence"},
    {"PotentialEnergy", 1, "J", "strain energy of the modes; not available with a force user function"},
}};

constexpr std::array<std::string_view, 18> ObjectGenericODE2_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "nodes with second order coordinates; their coordinates in this order form the vector of the object",
    "constant mass matrix; n rows and n columns for n coordinates, dense or sparse, or empty for zero; other sizes are refused",
    "constant stiffness matrix; n rows and n columns, or empty for zero; dense or sparse, in the same form as the damping matrix",
    "constant damping matrix; n rows and n columns, or empty for zero; dense or sparse, in the same form as the stiffness matrix",
    "constant generalized forces on the right hand side; length n, or empty for zero",
    "function that gives further generalized forces on the right hand side",
    "function that gives the mass matrix; it replaces ``massMatrix``",
    "function that returns the derivatives of the user forces; the default is numerical differentiation",
    "index of the first coordinate of each node in the vector of the object",
    "coordinates, a work space of the object",
    "velocities, a work space of the object",
    "accelerations, a work space of the object",
    "False: the item is not drawn",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
    "surface triangles, one row with three positions in ``nodeNumbers`` each (counted from 0); empty: no surface is drawn",
    "draw the nodes of the object at their deformed positions, whether or not the nodes themselves are shown",
    "function that returns the shapes to be drawn, called at every redraw; shapes are given in the global frame",
};
constexpr std::array<OutputText, 7> ObjectGenericODE2_outputs{{
    {"CoordinatesTotal", 0, "various", "coordinates of all nodes of the object, including the reference values"},
    {"Coordinates", 0, "various", "coordinates of all nodes of the object, relative to the reference values"},
    {"Coordinates_t", 0, "various", "first time derivatives of the coordinates of all nodes"},
    {"Coordinates_tt", 0, "various", "second time derivatives of the coordinates of all nodes"},
    {"Force", 0, "various", "generalized forces of the object without inertia, one per coordinate, as they stand on the left hand side of the equations of motion"},
    {"KineticEnergy", 1, "J", "kinetic energy of the whole body; the local position has no influence"},
    {"PotentialEnergy", 1, "J", "stiffness times displacements, and the constant force vector, as work since the reference configuration; not available with a force user function"},
}};

constexpr std::array<std::string_view, 26> ObjectKinematicTree_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "generic node of second order with one coordinate per joint: rad for revolute, m for prismatic joints",
    "gravity in global components; mass proportional loads do not act on this object",
    "global position of the base frame",
    "type of each joint, one per link; required",
    "number of the parent link of each link, -1 for the base; a parent has a smaller number than its links; required",
    "the rotation matrix from its joint frame, at coordinate zero, to the frame of the parent; required",
    "the origin of its joint frame in the frame of the parent, for the base in the base frame; required",
    "the inertia tensor about its center of mass, in the frame of the link; required",
    "the center of mass in the frame of the link; required",
    "mass of each link; required",
    "a force in global components at the origin of its joint frame; empty for zero",
    "a torque in global components; empty for zero",
    "a torque (Nm) or force (N) about or along its axis, positive on the link and negative on its parent; empty for zero",
    "desired joint coordinates of the position control (rad or m); empty for zero",
    "desired joint velocities of the velocity control (rad/s or m/s); empty for zero",
    "proportional gain of each joint (Nm/rad or N/m); empty for zero",
    "derivative gain of each joint (Nm s/rad or Ns/m); empty for zero",
    "function that gives further joint forces, which act as those of ``jointForceVector``",
    "a name, which may stand wherever the number of a link is asked for, or an empty string; empty for no names",
    "a name, which may stand for the number of the joint and for that of the link which it carries, or an empty string; empty for no names",
    "False: the item is not drawn",
    "draw the links, as given by ``graphicsDataList`` or, if that is empty, as cylinders between the joints",
    "draw the joints in a standard form; only if ``graphicsDataList`` is empty",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
    "a list of shapes in the frame of the link; empty, or as long as there are links",
};
constexpr std::array<OutputText, 6> ObjectKinematicTree_outputs{{
    {"Coordinates", 0, "various", "joint coordinates, including the reference values (unlike the output of the same name of the node)"},
    {"Coordinates_t", 0, "various", "joint velocities"},
    {"Coordinates_tt", 0, "various", "joint accelerations"},
    {"Force", 0, "various", "generalized forces of the object without inertia, one per coordinate, as they stand on the left hand side of the equations of motion"},
    {"KineticEnergy", 1, "J", "kinetic energy of the whole body; the local position has no influence"},
    {"PotentialEnergy", 1, "J", "work against weight, link forces and joint forces since the reference configuration, and the springs of joint controllers; not available with a force user function"},
}};

constexpr std::array<std::string_view, 18> ObjectALEANCFCable2D_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "length of the element in its undeformed state; must be positive",
    "total mass per undeformed length, of the resting and the moving part",
    "share of the mass per length that moves along the axis: 1: axially moving beam, 0: no motion; a pipe with fluid lies between",
    "bending stiffness: bending moment per curvature",
    "axial stiffness: axial force per axial strain",
    "viscous damping of bending: bending moment per rate of curvature",
    "viscous damping of stretching: axial force per rate of axial strain",
    "axial strain at which the axial force is zero",
    "curvature at which the bending moment is zero; positive for a left turn along the axis",
    "true: all inertia terms of the axial motion act; false: accelerations of cable and axial coordinate are not coupled, and the latter has a constant mass",
    "true: the axial coordinate feels the change of strain and curvature energy that its motion brings about; false: this term is left out",
    "node at axial position 0, node at axial position L (both with position and slope in the plane), and a generic node of second order whose coordinate is the axial displacement of the material",
    "integration of the elastic forces along the axis: 0: 5 Gauss points for stretching and 3 for bending; 1: 4 and 2; 2: 3 Lobatto points for stretching and 2 Gauss points for bending",
    "share of the strains of the reference configuration that are free of stress: 0 for an element that is straight and of length L without stress, 1 for a reference configuration without stress; values between serve for a transition",
    "False: the item is not drawn",
    "height of the rectangle that is drawn; 0 draws the axis only",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 12> ObjectALEANCFCable2D_outputs{{
    {"Position", 3, "m", "global position of the local point"},
    {"Displacement", 3, "m", "global displacement of the local point"},
    {"Velocity", 3, "m/s", "global velocity of the material at the local point"},
    {"VelocityLocal", 3, "m/s", "velocity of the material at the local point in the frame of the cross section"},
    {"Rotation", 1, "rad", "angle from the global x-axis to the slope vector, positive about z"},
    {"Director1", 3, "1", "slope vector of the axis; its length is 1 + axial strain"},
    {"StrainLocal", 1, "1", "axial strain of the axis"},
    {"CurvatureLocal", 1, "1/m", "material curvature of the axis; positive for a left turn along the axis"},
    {"ForceLocal", 1, "N", "axial force, positive for tension; oscillates along the element when bending dominates"},
    {"TorqueLocal", 1, "Nm", "bending moment, positive with positive curvature"},
    {"KineticEnergy", 1, "J", "kinetic energy of the whole body; the local position has no influence"},
    {"PotentialEnergy", 1, "J", "energy of the strains; the local position has no influence, and loads are not included"},
}};

constexpr std::array<std::string_view, 9> ObjectANCFBeam_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "node at the negative and node at the positive end of the axis, each with position and the slopes of the cross section",
    "length of the element in its undeformed state; must be positive",
    "cross section with inertia, stiffness and damping matrices, as a ``BeamSection``",
    "factors of the stiffness against stretching of the cross section in y and z (times the axial stiffness) and against its distortion (times the sum of the shear stiffnesses)",
    "damping of the same deformations, as factors of the stiffness; 0 for none",
    "False: the item is not drawn",
    "outline of the cross section for drawing and contact, as a ``BeamSectionGeometry``",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 12> ObjectANCFBeam_outputs{{
    {"Position", 3, "m", "global position of the local point"},
    {"Displacement", 3, "m", "global displacement of the local point"},
    {"Velocity", 3, "m/s", "global velocity of the local point"},
    {"VelocityLocal", 3, "m/s", "velocity of the local point in the frame of the cross section"},
    {"AngularVelocity", 3, "rad/s", "angular velocity of the cross section in global coordinates"},
    {"AngularVelocityLocal", 3, "rad/s", "angular velocity of the cross section in its own frame"},
    {"Acceleration", 3, "m/s^2", "global acceleration of the local point"},
    {"Rotation", 3, "rad", "Tait-Bryan angles of the frame of the cross section"},
    {"RotationMatrix", 9, "1", "rotation matrix from the frame of the cross section to the global frame, row by row"},
    {"HomogeneousTransformation", 16, "various", "position and rotation as a 4 x 4 matrix, row by row; output functions return ``exu.HT``"},
    {"KineticEnergy", 1, "J", "kinetic energy of the whole body; the local position has no influence"},
    {"PotentialEnergy", 1, "J", "energy of the strains; the local position has no influence, and loads are not included"},
}};

constexpr std::array<std::string_view, 14> ObjectANCFCable_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "length of the element in its undeformed state; must be positive",
    "mass per undeformed length",
    "bending stiffness: bending moment per curvature",
    "axial stiffness: axial force per axial strain",
    "viscous damping of bending: bending moment per rate of curvature",
    "viscous damping of stretching: axial force per rate of axial strain",
    "axial strain at which the axial force is zero",
    "share of the strains of the reference configuration that are free of stress: 0 for an element that is straight and of length L without stress, 1 for a reference configuration without stress; values between serve for a transition",
    "node at axial position 0 and node at axial position L, both with position and one slope",
    "integration of the elastic forces along the axis: 0: 5 Gauss points for stretching and 3 for bending; 1: 4 and 2; 2: 3 Lobatto points for stretching and 2 Gauss points for bending, with smoother axial forces but possibly modes without stiffness",
    "False: the item is not drawn",
    "radius of the cylinder that is drawn; 0 draws the axis only",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 11> ObjectANCFCable_outputs{{
    {"Position", 3, "m", "global position of the axis"},
    {"Displacement", 3, "m", "global displacement of the axis"},
    {"Velocity", 3, "m/s", "global velocity of the axis"},
    {"Director1", 3, "1", "slope vector of the axis; its length is 1 + axial strain"},
    {"StrainLocal", 1, "1", "axial strain of the axis"},
    {"CurvatureLocal", 3, "1/m", "curvature vector"},
    {"ForceLocal", 1, "N", "axial force, positive for tension; oscillates along the element when bending dominates"},
    {"TorqueLocal", 3, "Nm", "bending moments; there is no torsional moment"},
    {"Acceleration", 3, "m/s^2", "global acceleration of the axis"},
    {"KineticEnergy", 1, "J", "kinetic energy of the whole body; the local position has no influence"},
    {"PotentialEnergy", 1, "J", "energy of the strains; the local position has no influence, and loads are not included"},
}};

constexpr std::array<std::string_view, 17> ObjectANCFCable2D_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "length of the element in its undeformed state; must be positive",
    "mass per undeformed length",
    "bending stiffness: bending moment per curvature",
    "axial stiffness: axial force per axial strain",
    "viscous damping of bending: bending moment per rate of curvature",
    "viscous damping of stretching: axial force per rate of axial strain",
    "axial strain at which the axial force is zero",
    "curvature at which the bending moment is zero; positive for a left turn along the axis",
    "share of the strains of the reference configuration that are free of stress: 0 for an element that is straight and of length L without stress, 1 for a reference configuration without stress; values between serve for a transition",
    "node at axial position 0 and node at axial position L, both with position and slope in the plane",
    "integration of the elastic forces along the axis: 0: 5 Gauss points for stretching and 3 for bending; 1: 4 and 2; 2: 3 Lobatto points for stretching and 2 Gauss points for bending, with smoother axial forces but possibly modes without stiffness",
    "function that gives the axial force in place of the linear law",
    "function that gives the bending moment in place of the linear law",
    "False: the item is not drawn",
    "height of the rectangle that is drawn; 0 draws the axis only",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 16> ObjectANCFCable2D_outputs{{
    {"Position", 3, "m", "global position of the local point"},
    {"Displacement", 3, "m", "global displacement of the local point"},
    {"Velocity", 3, "m/s", "global velocity of the local point"},
    {"VelocityLocal", 3, "m/s", "velocity of the local point in the frame of the cross section"},
    {"Rotation", 1, "rad", "angle from the global x-axis to the slope vector, positive about z"},
    {"Director1", 3, "1", "slope vector of the axis; its length is 1 + axial strain"},
    {"StrainLocal", 1, "1", "axial strain at the local point: that of the axis, minus the distance y from it times the curvature"},
    {"CurvatureLocal", 1, "1/m", "material curvature of the axis; positive for a left turn along the axis"},
    {"ForceLocal", 1, "N", "axial force, positive for tension; oscillates along the element when bending dominates"},
    {"TorqueLocal", 1, "Nm", "bending moment, positive with positive curvature"},
    {"AngularVelocity", 3, "rad/s", "angular velocity of the cross section; only the third component is not zero"},
    {"AngularVelocityLocal", 3, "rad/s", "the same vector, because the cross section rotates about z"},
    {"Acceleration", 3, "m/s^2", "global acceleration of the local point"},
    {"AngularAcceleration", 3, "rad/s^2", "angular acceleration of the cross section; only the third component is not zero"},
    {"KineticEnergy", 1, "J", "kinetic energy of the whole body; the local position has no influence"},
    {"PotentialEnergy", 1, "J", "energy of the strains; the local position has no influence, and loads are not included"},
}};

constexpr std::array<std::string_view, 15> ObjectANCFThinPlate_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "thickness of the plate: a value, or interpolated values of the nodes",
    "mass per volume",
    "damping forces are this factor times mass matrix times velocity",
    "stiffness against the strains in the plane, integrated over the thickness; a matrix, or one per node",
    "stiffness against curvatures and twist, integrated over the thickness; a matrix, or one per node",
    "share of the strains of the reference configuration that are free of stress: 0 for a plate that is flat without stress, 1 for a reference configuration without stress",
    "for each node the length of the side in x that belongs to a unit slope, the distance of the nodes for a flat rectangle; not positive: that distance",
    "for each node the length of the side in y that belongs to a unit slope; not positive: the distance of the nodes",
    "four nodes with position and two slopes, at the local corners (-1, -1), (1, -1), (1, 1), (-1, 1)",
    "integration of the elastic forces: 0: 4 by 4 Gauss points, 1: 3 by 3",
    "membrane forces of damping are this factor times membrane stiffness times strain rates",
    "the same for bending stiffness and rates of curvature; negative: ``stiffnessProportionalDamping``",
    "False: the item is not drawn",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 13> ObjectANCFThinPlate_outputs{{
    {"Position", 3, "m", "global position of the local point; local coordinates run from -1 to 1, the third one over the thickness"},
    {"Displacement", 3, "m", "global displacement of the local point"},
    {"Velocity", 3, "m/s", "global velocity of the local point"},
    {"Director1", 3, "1", "slope vector in the first direction of the mid-surface"},
    {"Director2", 3, "1", "slope vector in the second direction of the mid-surface"},
    {"StrainLocal", 3, "1", "strains of the mid-surface: two normal strains and the shear strain; strains without stress are subtracted"},
    {"CurvatureLocal", 3, "1/m", "curvatures about the x and y axis, and twice the twist of the mid-surface; strains without stress are subtracted"},
    {"ForceLocal", 3, "N/m", "membrane forces per length, two normal forces and the shear force"},
    {"TorqueLocal", 3, "N", "moments per length, two bending moments and the twisting moment, of the curvatures along x and y"},
    {"StressLocal", 6, "N/m^2", "stress components xx, yy, zz, yz, xz, xy at the local point; out-of-plane components are zero"},
    {"Acceleration", 3, "m/s^2", "global acceleration of the local point"},
    {"KineticEnergy", 1, "J", "kinetic energy of the whole body; the local position has no influence"},
    {"PotentialEnergy", 1, "J", "energy of the strains; the local position has no influence, and loads are not included"},
}};

constexpr std::array<std::string_view, 7> ObjectBeamGeometricallyExact_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "node at the negative and node at the positive end of the axis, both with position and orientation",
    "length of the element in its undeformed state; must be positive",
    "cross section with inertia, stiffness and damping matrices, as a ``BeamSection``",
    "False: the item is not drawn",
    "outline of the cross section for drawing and contact, as a ``BeamSectionGeometry``",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 14> ObjectBeamGeometricallyExact_outputs{{
    {"Position", 3, "m", "global position of the local point"},
    {"Displacement", 3, "m", "global displacement of the local point"},
    {"Velocity", 3, "m/s", "global velocity of the local point"},
    {"Rotation", 3, "rad", "Tait-Bryan angles of the frame of the cross section"},
    {"StrainLocal", 6, "1", "strains in the frame of the cross section: xx, yy, zz, yz, xz, xy, of which xx, xz and xy can differ from zero"},
    {"CurvatureLocal", 3, "1/m", "twist and the two curvatures in the frame of the cross section"},
    {"RotationMatrix", 9, "1", "rotation matrix from the frame of the cross section to the global frame, row by row"},
    {"AngularVelocity", 3, "rad/s", "global angular velocity of the cross section"},
    {"AngularVelocityLocal", 3, "rad/s", "angular velocity of the cross section in its own frame"},
    {"ForceLocal", 3, "N", "axial force and the two shear forces in the frame of the cross section"},
    {"TorqueLocal", 3, "Nm", "torsional moment and the two bending moments in the frame of the cross section"},
    {"HomogeneousTransformation", 16, "various", "position and rotation as a 4 x 4 matrix, row by row; output functions return ``exu.HT``"},
    {"KineticEnergy", 1, "J", "kinetic energy of the whole body; the local position has no influence"},
    {"PotentialEnergy", 1, "J", "energy of the strains; the local position has no influence, and loads are not included"},
}};

constexpr std::array<std::string_view, 16> ObjectBeamGeometricallyExact2D_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "two or three nodes of rigid bodies in the plane, in the order in which they follow along the axis",
    "length of the element in its undeformed state; must be positive",
    "mass per undeformed length",
    "mass moment of inertia of the cross section per length, against its rotation",
    "bending stiffness: bending moment per curvature",
    "axial stiffness: axial force per axial strain",
    "shear stiffness, including the shear correction factor",
    "viscous damping of bending: bending moment per rate of curvature",
    "viscous damping of stretching: axial force per rate of axial strain",
    "viscous damping of shear: shear force per rate of shear strain",
    "curvature at which the bending moment is zero",
    "true: the reference angles of the nodes are the angles of the cross sections; false: only rotations relative to the reference configuration count, and the cross sections are normal to the reference axis",
    "False: the item is not drawn",
    "height of the rectangle that is drawn; 0 draws the axis only",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 10> ObjectBeamGeometricallyExact2D_outputs{{
    {"Position", 3, "m", "global position of the local point"},
    {"Displacement", 3, "m", "global displacement of the local point"},
    {"Velocity", 3, "m/s", "global velocity of the local point"},
    {"Rotation", 3, "rad", "only the third component is not zero: the angle of the cross section about z"},
    {"StrainLocal", 6, "1", "strains of the axis: axial strain first, shear strain last; the others are zero"},
    {"CurvatureLocal", 3, "1/m", "only the third component is not zero: the curvature that moments act against"},
    {"ForceLocal", 3, "N", "axial force, shear force, zero; in the frame of the cross section"},
    {"TorqueLocal", 3, "Nm", "only the third component is not zero: the bending moment"},
    {"KineticEnergy", 1, "J", "kinetic energy of the whole body; the local position has no influence"},
    {"PotentialEnergy", 1, "J", "energy of the strains; the local position has no influence, and loads are not included"},
}};

constexpr std::array<std::string_view, 10> ObjectConnectorCartesianSpringDamper_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0",
    "stiffness in global x, y and z direction",
    "damping coefficient in global x, y and z direction",
    "global position of marker m1 relative to marker m0 at which the springs carry no force",
    "Python function that replaces the linear law of springs and dampers; called only while the connector is active",
    "False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero",
    "False: the item is not drawn",
    "size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 5> ObjectConnectorCartesianSpringDamper_outputs{{
    {"Displacement", 3, "m", "global position of marker m1 relative to marker m0, minus ``offset``"},
    {"Distance", 1, "m", "length of that displacement, so zero where the springs carry no force"},
    {"Velocity", 3, "m/s", "global velocity of marker m1 relative to marker m0"},
    {"Force", 3, "N", "global force vector that acts on marker m0; its negative acts on marker m1"},
    {"PotentialEnergy", 1, "J", "energy of spring and constant force, zero where the spring is relaxed; not available with a user function"},
}};

constexpr std::array<std::string_view, 10> ObjectConnectorCoordinateSpringDamper_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0",
    "stiffness; N/m for coordinates that are lengths, Nm/rad for angles",
    "damping coefficient; Ns/m for coordinates that are lengths, Nms/rad for angles",
    "difference of the coordinates at which the spring carries no force; unit of the coordinates",
    "False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero",
    "Python function that replaces the law of spring and damper; called only while the connector is active",
    "False: the item is not drawn",
    "size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 4> ObjectConnectorCoordinateSpringDamper_outputs{{
    {"Displacement", 1, "various", "difference of the marker coordinates, not reduced by ``offset``"},
    {"Velocity", 1, "various", "difference of the marker velocity coordinates"},
    {"Force", 1, "various", "generalized force of spring and damper, positive if it draws the coordinates together after extension"},
    {"PotentialEnergy", 1, "J", "energy of spring and constant force, zero where the spring is relaxed; not available with a user function"},
}};

constexpr std::array<std::string_view, 26> ObjectConnectorCoordinateSpringDamperExt_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0",
    "NodeGenericData with three data coordinates: friction state, last sticking position, limit stop state; needed for friction with ``frictionProportionalZone`` = 0 and for limit stops, else it may stay unset",
    "stiffness; N/m if the weighted coordinates are lengths, Nm/rad if they are angles; other units of this item follow in the same way",
    "damping coefficient; Ns/m for lengths",
    "weighted difference of the coordinates at which the spring carries no force; m for lengths; may serve as the set value of a position control",
    "weighted difference of the velocities at which the damper carries no force; m/s for lengths; may serve as the set value of a velocity control",
    "factor of the coordinate of marker m0, such as a gear ratio",
    "factor of the coordinate of marker m1",
    "friction force in sliding, N for lengths: friction coefficient times a constant normal force",
    "difference of the largest static and the dynamic friction force, N for lengths; sticking ends at the sum of both",
    "stiffness of the bristles in sticking, N/m for lengths; must be positive for friction with ``frictionProportionalZone`` = 0",
    "damping coefficient of the bristles in sticking, Ns/m for lengths",
    "speed by which the static offset falls to 1/e = 36.8 % of its value, m/s for lengths",
    "growth of the friction force with the speed of sliding, Ns/m for lengths; may be negative",
    "speed up to which friction is proportional to velocity, m/s for lengths; 0: bristle model with stick and slip, which needs the data node",
    "upper limit of the weighted difference of coordinates, m for lengths; the upper stop acts above it",
    "lower limit of the weighted difference of coordinates, m for lengths; the lower stop acts below it",
    "contact stiffness of the stops, N/m for lengths",
    "contact damping of the stops, Ns/m for lengths",
    "True: limit stops are active, and the data node is needed",
    "False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero",
    "Python function that replaces spring, damper, friction and limit stops altogether; called only while the connector is active",
    "False: the item is not drawn",
    "size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 3> ObjectConnectorCoordinateSpringDamperExt_outputs{{
    {"Displacement", 1, "various", "weighted difference of the marker coordinates, not reduced by ``offset``"},
    {"Velocity", 1, "various", "weighted difference of the marker velocity coordinates"},
    {"Force", 1, "various", "total generalized force, with friction and limit stops"},
}};

constexpr std::array<std::string_view, 10> ObjectConnectorGravity_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0",
    "constant of gravitation; a negative value means repulsion",
    "mass that attracts at marker m0; not taken from the body",
    "mass that attracts at marker m1; not taken from the body",
    "distance below which the force is regularized; 0: no regularization, and coinciding markers are an error",
    "False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero",
    "True: the item is drawn",
    "size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 4> ObjectConnectorGravity_outputs{{
    {"Distance", 1, "m", "distance of the markers"},
    {"Displacement", 3, "m", "global vector from marker m0 to marker m1"},
    {"Force", 3, "N", "global force on marker m0, towards marker m1; its negative acts on marker m1"},
    {"PotentialEnergy", 1, "J", "energy of the attraction, zero at infinite distance"},
}};

constexpr std::array<std::string_view, 30> ObjectConnectorHydraulicActuatorSimple_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0",
    "list with one NodeGenericODE1 whose two coordinates are the chamber pressures (Pa); its reference coordinates must be zero",
    "distance of the markers at stroke zero, the shortest length of the actuator",
    "largest stroke; the markers are ``offsetLength`` plus ``strokeLength`` apart in the fully extended actuator",
    "area of the piston in chamber 0, on the side of the piston head",
    "area of the piston in chamber 1, on the side of the rod; usually smaller",
    "volume of the hose of chamber 0; must be positive, as the stiffness of the oil would be unbounded at stroke zero",
    "volume of the hose of chamber 1; must be positive, as the stiffness of the oil would be unbounded at full stroke",
    "opening of the valve of chamber 0, from -1 to 1: positive towards system pressure, negative towards tank pressure, 0 closed; changed during a simulation to control the actuator",
    "opening of the valve of chamber 1, with the same meaning",
    "viscous damping against the stroke velocity",
    "bulk modulus of the oil",
    "bulk modulus that stands for the compliance of the cylinder; 0: rigid cylinder",
    "bulk modulus that stands for the compliance of the hoses; 0: rigid hoses",
    "flow through the fully open valve per square root of the pressure difference",
    "pressure of the supply",
    "pressure of the tank",
    "True: volumes and stiffness of the oil change with the stroke; False: hose volumes and ``oilBulkModulus`` alone",
    "False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero",
    "False: the item is not drawn",
    "radius of the drawn cylinder",
    "radius of the drawn rod",
    "radius of the drawn piston",
    "length of the drawn piston",
    "radius of the sphere drawn at the mount of the rod; 0: none",
    "radius of the sphere drawn at the mount of the cylinder; 0: none",
    "length of the part drawn between the mount and the cylinder",
    "red, green, blue and opacity of the cylinder; a negative red selects the default color of connectors",
    "red, green, blue and opacity of piston and rod",
};
constexpr std::array<OutputText, 5> ObjectConnectorHydraulicActuatorSimple_outputs{{
    {"Distance", 1, "m", "distance of the markers, the length of the actuator"},
    {"Displacement", 3, "m", "global vector from marker m0 to marker m1"},
    {"Velocity", 3, "m/s", "global velocity of marker m1 relative to marker m0"},
    {"VelocityLocal", 1, "m/s", "rate of the length of the actuator, positive in extension"},
    {"Force", 3, "N", "global force on marker m0, from chamber pressures and damping"},
}};

constexpr std::array<std::string_view, 13> ObjectConnectorLaw_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0",
    "nodes of the states: a NodeGenericODE1, whose coordinates have the rates of ``stateRateUserFunction``; a NodeGenericData, whose coordinates ``historyUserFunction`` computes once per step; or one of both",
    "size of the relative motion. 1: difference of two coordinates; 3: relative position in global axes; 6: relative position and Tait-Bryan angles in the joint frame of marker m0",
    "axes of the joint frame of marker m0 in the marker's frame; used if ``numberOfCoordinates`` is 6",
    "axes of the joint frame of marker m1 in the marker's frame; used if ``numberOfCoordinates`` is 6",
    "function that computes the force; no force without it",
    "function that computes the rates of the first-order coordinates; they are constant without it",
    "function that computes the data coordinates at the end of a step; they are constant without it",
    "False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero",
    "False: the item is not drawn",
    "size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 3> ObjectConnectorLaw_outputs{{
    {"Displacement", 0, "various", "relative position; for frames in the joint frame, followed by the Tait-Bryan angles"},
    {"Velocity", 0, "various", "relative velocity; for frames in the joint frame, followed by the relative angular velocity"},
    {"Force", 0, "various", "force on marker m0; for frames in the joint frame, followed by the torque"},
}};

constexpr std::array<std::string_view, 14> ObjectConnectorLinearSpringDamper_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "marker m0, to which the axis is fixed, and marker m1",
    "stiffness along the axis",
    "damping coefficient along the axis",
    "axis in the frame of marker m0, a unit vector; it turns with that marker",
    "relative position along the axis at which the spring carries no force; may be changed during a simulation as the set value of a drive",
    "relative velocity along the axis at which the damper carries no force; set value of a velocity control",
    "constant force added to that of spring and damper; positive: pulls marker m1 against the direction of the axis",
    "False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero",
    "Python function that replaces the law of spring, damper and constant force; called only while the connector is active",
    "False: the item is not drawn",
    "size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings",
    "True: drawn as a cylinder, which suits an actuator; False: drawn as a spring",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 6> ObjectConnectorLinearSpringDamper_outputs{{
    {"DisplacementLocal", 1, "m", "relative position of the markers along the axis"},
    {"VelocityLocal", 1, "m/s", "relative velocity of the markers along the axis"},
    {"ForceLocal", 1, "N", "scalar force on marker m0 in the direction of the axis"},
    {"PotentialEnergy", 1, "J", "energy of spring and constant force, zero where the spring is relaxed; not available with a user function"},
    {"HomogeneousTransformationLocal", 16, "various", "relative position and rotation of marker m1 in the axes of marker m0 as a 4 x 4 matrix, row by row; output functions return ``exu.HT``"},
    {"Displacement", 3, "m", "global position of marker m1 relative to marker m0"},
}};

constexpr std::array<std::string_view, 17> ObjectConnectorReevingSystemSprings_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "rigid body markers along the rope: the first and the last are its ends, those between carry sheaves or deflection points; if ``hasCoordinateMarkers`` is set, two coordinate markers follow",
    "True: the last two markers are coordinate markers that add rope at the start and at the end",
    "True: the bodies of the first and the last marker are pulleys that turn with the rope. The coordinate markers measure their rotations, without forces on these coordinates: the rope acts on the pulleys where it touches them",
    "factors of the two coordinate markers: 1 for lengths, a radius (m) for the angle of a winch",
    "axial stiffness of the rope, modulus times cross section; divided by the length it is the stiffness of the rope",
    "axial damping of the rope; divided by the length it is the damping coefficient of the rope",
    "damping of the relative rotation of neighbouring sheaves about the rope; experimental",
    "damping of the relative motion of neighbouring sheaves across the rope; experimental",
    "positive: largest compressive force, approached smoothly; negative: the rope carries compression like a spring",
    "length of the rope without force",
    "axis of every sheave in the frame of its marker; the sign chooses the side at which the rope runs; it must not be parallel to the line to the next center",
    "radius of every sheave; 0: a point. At an end with a radius, the moment of the rope about the center acts on the body of the marker",
    "False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero",
    "False: the item is not drawn",
    "radius of the drawn rope",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 3> ObjectConnectorReevingSystemSprings_outputs{{
    {"Distance", 1, "m", "length of the rope along spans and sheaves"},
    {"VelocityLocal", 1, "m/s", "rate of that length"},
    {"ForceLocal", 1, "N", "tensile force, the same all along the rope"},
}};

constexpr std::array<std::string_view, 15> ObjectConnectorRigidBodySpringDamper_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0",
    "NodeGenericData whose data coordinates the user functions may use, for instance for friction or contact states; not set: no data coordinates",
    "stiffness matrix in frame J0 for three translations (N/m) and three rotations (Nm/rad), coupling terms included; need not be symmetric",
    "damping matrix in frame J0 for the three components of velocity (Ns/m) and of angular velocity (Nms/rad)",
    "rotation matrix from joint frame J0 to the frame of marker m0; turns the axes in which stiffness, damping and offset are given",
    "rotation matrix from joint frame J1 to the frame of marker m1; without rotation offset, the springs carry no torque if J0 and J1 are parallel",
    "relative position (m) and Tait-Bryan angles (rad) in frame J0 at which the springs carry no force; the logarithm of the relative motion with ``intrinsicFormulation``",
    "True: relative motion is measured by the logarithm on SE(3), and forces act in the frame half-way between the markers, such that exchanging the markers changes nothing; False: all is measured in frame J0",
    "False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero",
    "Python function that replaces the linear law of force and torque; called only while the connector is active",
    "Python function that updates the data coordinates of ``nodeNumber`` after each Newton iteration has converged; called only with a data node and while the connector is active",
    "False: the item is not drawn",
    "size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 9> ObjectConnectorRigidBodySpringDamper_outputs{{
    {"DisplacementLocal", 3, "m", "position of marker m1 relative to marker m0 in frame J0; the translational part of the logarithm with ``intrinsicFormulation``"},
    {"VelocityLocal", 3, "m/s", "global velocity of marker m1 minus that of marker m0, in frame J0; if ``intrinsicFormulation`` is set, in the mid-frame"},
    {"Rotation", 3, "rad", "Tait-Bryan angles (about x, y, z in turn) of J1 relative to J0; the rotation vector with ``intrinsicFormulation``"},
    {"AngularVelocityLocal", 3, "rad/s", "angular velocity of marker m1 relative to marker m0, in frame J0; if ``intrinsicFormulation`` is set, in the mid-frame"},
    {"ForceLocal", 3, "N", "force on marker m0, in frame J0; if ``intrinsicFormulation`` is set, in the mid-frame"},
    {"TorqueLocal", 3, "Nm", "torque on marker m0, in frame J0; with ``intrinsicFormulation`` in the mid-frame, without the moment of the force"},
    {"PotentialEnergy", 1, "J", "energy of spring and constant force, zero where the spring is relaxed; not available with a user function"},
    {"HomogeneousTransformationLocal", 16, "various", "relative position and rotation of joint frame J1 in joint frame J0 as a 4 x 4 matrix, row by row; output functions return ``exu.HT``"},
    {"Displacement", 3, "m", "global position of marker m1 relative to marker m0"},
}};

constexpr std::array<std::string_view, 18> ObjectConnectorRollingDiscPenalty_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "marker m0 on the plane and marker m1 at the center of the disc",
    "NodeGenericData with three data coordinates: slip velocity in lateral and in forward direction, and gap, of the last update",
    "radius of the disc",
    "axis of the disc in the frame of marker m1, a unit vector; must not become parallel to the normal of the plane",
    "normal of the plane in the frame of marker m0, a unit vector; the plane contains the position of marker m0",
    "rotation of the directions of ``dryFriction`` in the plane, such as the angle of the rollers of a Mecanum wheel",
    "stiffness normal to the plane",
    "damping coefficient normal to the plane",
    "friction coefficients in lateral and in forward direction",
    "slip speed up to which friction is regularized; 0: none",
    "growth of the friction coefficients with the slip speed, in lateral and in forward direction",
    "rolling resistance per normal force and per speed of the disc center along the plane; only for a disc with its axis parallel to the plane",
    "True: friction grows linearly in the proportional zone, with a constant tangent in sticking; False: quadratically, with a smooth end of the zone",
    "False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero",
    "False: the item is not drawn",
    "width of the drawn disc",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 5> ObjectConnectorRollingDiscPenalty_outputs{{
    {"Position", 3, "m", "contact point relative to marker m0, in global axes"},
    {"Velocity", 3, "m/s", "global velocity at which the contact point moves along its trail; not the velocity of the disc at that point"},
    {"VelocityLocal", 3, "m/s", "slip velocity of disc against plane at the contact point, in frame J1"},
    {"ForceLocal", 3, "N", "contact force on the disc in frame J1: lateral, forward, normal; without the rolling resistance, which acts at the center of the disc"},
    {"RotationMatrix", 9, "1", "rotation matrix from frame J1 (lateral, forward, normal) to the global frame, row by row"},
}};

constexpr std::array<std::string_view, 12> ObjectConnectorSpringDamper_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0",
    "length at which the spring itself carries no force",
    "stiffness of the spring, force per elongation",
    "coefficient of the damper, force per rate of length",
    "constant force added to that of spring and damper; positive: tension, the markers are pulled together; may be changed during a simulation to drive an actuator",
    "rate of length at which the damper carries no force, for instance the rate at which ``referenceLength`` is changed",
    "False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero",
    "Python function that replaces the law of spring, damper and constant force; called only while the connector is active",
    "False: the item is not drawn",
    "size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 6> ObjectConnectorSpringDamper_outputs{{
    {"Distance", 1, "m", "distance of the two markers, the current length of the spring"},
    {"Displacement", 3, "m", "global vector from marker m0 to marker m1"},
    {"Velocity", 3, "m/s", "global velocity of marker m1 relative to marker m0"},
    {"Force", 3, "N", "global force vector, the scalar force times the direction from marker m0 to marker m1; it is the force on marker m0"},
    {"ForceLocal", 1, "N", "scalar force, positive in tension"},
    {"PotentialEnergy", 1, "J", "energy of spring and constant force, zero where the spring is relaxed; not available with a user function"},
}};

constexpr std::array<std::string_view, 15> ObjectConnectorTorsionalSpringDamper_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0",
    "NodeGenericData with one data coordinate that holds the angle of the last step and makes the measured angle continuous beyond half a turn; not set: the angle jumps",
    "torsional stiffness",
    "torsional damping coefficient",
    "rotation matrix from joint frame J0 to the frame of marker m0; its third column is the axis of rotation",
    "rotation matrix from joint frame J1 to the frame of marker m1; the angle is zero if J0 and J1 are parallel",
    "angle at which the spring carries no torque; may be changed during a simulation as the set value of a drive",
    "relative angular velocity at which the damper carries no torque; set value of a velocity control",
    "constant torque added to that of spring and damper; positive: acts against the rotation of marker m1 about the axis",
    "False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero",
    "Python function that replaces the law of spring, damper and constant torque; called only while the connector is active",
    "False: the item is not drawn",
    "size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 4> ObjectConnectorTorsionalSpringDamper_outputs{{
    {"Rotation", 1, "rad", "angle of J1 relative to J0 about the z axis of J0; in the range of half a turn to both sides, or continuous with a data node"},
    {"AngularVelocityLocal", 1, "rad/s", "z component in J0 of the angular velocity of marker m1 relative to marker m0"},
    {"TorqueLocal", 1, "Nm", "torque on marker m0 about the z axis of J0; its negative acts on marker m1"},
    {"PotentialEnergy", 1, "J", "energy of spring and constant force, zero where the spring is relaxed; not available with a user function"},
}};

constexpr std::array<std::string_view, 11> ObjectConnectorCoordinate_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0",
    "prescribed value of ``factorValue1`` times the second coordinate minus the first one; with ``velocityLevel`` the same for the velocity coordinates",
    "factor of the coordinate of marker m1, such as a gear ratio",
    "True: the constraint is set for the velocity coordinates, and ``offset`` is a velocity; ``offsetUserFunction`` is then ignored; only for coordinates of second order equations",
    "Python function that replaces ``offset`` by a function of time, on position level",
    "Python function, the time derivative of ``offsetUserFunction``; used wherever the constraint is evaluated on velocity level",
    "False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero",
    "False: the item is not drawn",
    "size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 4> ObjectConnectorCoordinate_outputs{{
    {"Displacement", 1, "various", "difference of the marker coordinates, without ``factorValue1``"},
    {"Velocity", 1, "various", "difference of the marker velocity coordinates, without ``factorValue1``"},
    {"ConstraintEquation", 1, "various", "residual of the constraint on position level, or on velocity level with ``velocityLevel``"},
    {"Force", 1, "various", "Lagrange multiplier, the generalized constraint force; N for lengths, Nm for angles"},
}};

constexpr std::array<std::string_view, 13> ObjectConnectorCoordinateVector_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "two markers on coordinate vectors; the equations are those of m1 minus those of m0",
    "matrix of linear factors of the coordinates of marker m0, one row per equation and one column per coordinate; empty: no such term",
    "matrix of linear factors of the coordinates of marker m1; empty: no such term",
    "matrix of factors of the squared coordinates of marker m0; empty: no such term",
    "matrix of factors of the squared coordinates of marker m1; empty: no such term",
    "vector that is subtracted from the equations, one component per equation; empty: zero; not used with a user function",
    "True: the equations are set for the velocity coordinates, and ``offset`` is a velocity; only for coordinates of second order equations",
    "Python function that replaces all equations; ``jacobianUserFunction`` is needed as well, and ``scalingMarker0`` tells the number of equations by its number of rows, as in ``np.zeros((2, 1))``",
    "Python function, the derivative of ``constraintUserFunction`` with respect to the coordinates (or velocity coordinates with ``velocityLevel``)",
    "False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero",
    "False: the item is not drawn",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 4> ObjectConnectorCoordinateVector_outputs{{
    {"Displacement", 0, "various", "coordinates of marker m1 minus those of marker m0, without factors; size: number of coordinates of a marker"},
    {"Velocity", 0, "various", "velocity coordinates of marker m1 minus those of marker m0, without factors; size: number of coordinates of a marker"},
    {"ConstraintEquation", 0, "various", "residual of the equations on position level, or on velocity level with ``velocityLevel``; size: number of equations"},
    {"Force", 0, "various", "Lagrange multipliers; size: number of equations"},
}};

constexpr std::array<std::string_view, 7> ObjectConnectorDistance_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0",
    "prescribed distance of the two markers; must be positive, and should fit the initial positions",
    "False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero",
    "False: the item is not drawn",
    "size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 4> ObjectConnectorDistance_outputs{{
    {"Displacement", 3, "m", "global vector from marker m0 to marker m1"},
    {"Velocity", 3, "m/s", "global velocity of marker m1 relative to marker m0"},
    {"Distance", 1, "m", "current distance; differs from the prescribed one by the error of the constraint"},
    {"Force", 1, "N", "Lagrange multiplier, the force in the rod, positive in tension"},
}};

constexpr std::array<std::string_view, 13> ObjectContactCircleCable2D_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "marker m0 at the center of the circle and marker m1, the shape of the cable",
    "NodeGenericData with one data coordinate per segment, the gap when contact opened or closed last; a segment is in contact while it is not positive",
    "number of segments; must be that of the shape marker",
    "contact stiffness per segment",
    "contact damping coefficient per segment",
    "radius of the circle",
    "distance that is added to the radius of the circle, such as half the thickness of the cable",
    "False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero",
    "False: the item is not drawn",
    "True: the circle is drawn",
    "size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};

constexpr std::array<std::string_view, 20> ObjectContactConvexRoll_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "marker m0 on the ground, whose x and y axes span the plane, and marker m1 at the center of the roll, with the x axis along it",
    "NodeGenericData with three data coordinates of the last update: gap, and slip velocity along the x and y axes of marker m0",
    "stiffness normal to the plane",
    "damping coefficient normal to the plane",
    "coefficient of friction in sliding",
    "difference of the coefficients of static and dynamic friction",
    "growth of the friction coefficient with the slip speed",
    "slip speed by which the static offset falls to 1/e",
    "slip speed up to which friction is proportional to it",
    "length of the roll, symmetric about its center",
    "coefficients of the polynomial radius over the position x on the axis, highest power first; the profile must be convex",
    "coefficients of the first derivative of the profile",
    "coefficients of the second derivative of the profile",
    "radius of spheres at both ends that exclude contact by a cheap test; no effect here, because the lowest point of the profile is always computed",
    "current point of possible contact; contact if its third component is negative",
    "False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero",
    "True: the force is never tensile; it is zero if damping would make it tensile. False: damping also acts in tension until the gap is open",
    "False: the item is not drawn",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 4> ObjectContactConvexRoll_outputs{{
    {"Position", 3, "m", "global contact point"},
    {"Velocity", 3, "m/s", "global slip velocity of the roll against the ground at the contact point"},
    {"Force", 3, "N", "global force of the ground on the roll"},
    {"Torque", 3, "Nm", "global torque of that force about the center of the roll"},
}};

constexpr std::array<std::string_view, 14> ObjectContactCoordinate_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0",
    "NodeGenericData with one data coordinate, the gap of the last update, which must not be positive if the simulation begins in contact; with an ``impactModel`` other than 0 a second one, the impact velocity",
    "contact stiffness; N/m for coordinates that are lengths",
    "contact damping coefficient; Ns/m for coordinates that are lengths",
    "difference of the coordinates at which contact begins; m for lengths",
    "False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero",
    "exponent n of the penetration in the normal force; 1.5 for Hertzian contact",
    "ratio of normal speeds after and before an impact, for ``impactModel`` 1 and 2; positive, 1: elastic",
    "lower bound of the impact velocity in the restitution law; larger values damp slow and lasting contacts more",
    "0: elastic contact with linear damping; 1: Hunt-Crossley, for restitution near 1; 2: Carvalho-Martins and Gonthier, for all restitution coefficients",
    "False: the item is not drawn",
    "size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 1> ObjectContactCoordinate_outputs{{
    {"Distance", 1, "various", "gap, the difference of the coordinates minus the offset; negative in contact"},
}};

constexpr std::array<std::string_view, 19> ObjectContactCurveCircles_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "rigid body marker that carries the curve, followed by one marker per circle",
    "NodeGenericData with three data coordinates per segment: number of the circle in contact, gap, tangential velocity, of the last update",
    "radius of every circle, as many as circle markers",
    "one row per segment with the planar coordinates of its begin and end, [x0, y0, x1, y1], in the frame of the curve; the outer side lies to the right when going from begin to end",
    "one row per segment with slopes at its begin and end (1) and curvatures at its begin and end (1/m), in the frame of the segment; to be left empty: segments are straight",
    "rotation matrix from the frame of the curve, in whose x-y plane it lies, to the frame of the first marker",
    "coefficient of friction in sliding",
    "slip speed up to which friction is proportional to it",
    "stiffness of the normal contact per length of segment",
    "damping coefficient of the normal contact per length of segment",
    "0: force by penetration of the segment, robust but with jumps between segments; 1: force by the area of penetration, smooth in sliding",
    "False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero",
    "gap of every segment at the last evaluation",
    "rate of gap of every segment at the last evaluation",
    "contact force of every segment in x direction of its frame, at the last evaluation",
    "contact force of every segment in y direction of its frame, at the last evaluation",
    "False: the item is not drawn",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 3> ObjectContactCurveCircles_outputs{{
    {"DisplacementLocal", 0, "m", "smallest gap of every circle, negative in contact; size: number of circles"},
    {"VelocityLocal", 0, "m/s", "rate of that gap of every circle; size: number of circles"},
    {"ForceLocal", 0, "N", "normal and tangential force for every circle; size: twice the number of circles"},
}};

constexpr std::array<std::string_view, 17> ObjectContactFrictionCircleCable2D_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "marker m0 at the center of the circle and marker m1, the shape of the cable",
    "NodeGenericData with three data coordinates per segment: all gaps, then all friction states (-1 and 1 slip, 0 stick, -2 undefined), then all last sticking positions; begin for instance with 0.1, -2, 0 for no contact",
    "number of segments; must be that of the shape marker",
    "contact stiffness per segment",
    "contact damping coefficient per segment",
    "tangential force per tangential velocity, per segment",
    "tangential force per displacement from the last sticking position, per segment; 0: no sticking, friction by velocity only",
    "coefficient of dry friction, the bound of the tangential to the normal force",
    "radius of the circle",
    "True: normal and tangent are those of the segment, for segments that are long against the circle; False: those of the circle at the points of the segment, for short segments",
    "False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero",
    "True: the force is never tensile; it is zero if damping would make it tensile. False: damping also acts in tension until the gap is open",
    "False: the item is not drawn",
    "True: the circle is drawn",
    "size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 3> ObjectContactFrictionCircleCable2D_outputs{{
    {"Coordinates", 0, "m", "tangential displacement from the last sticking position and gap, in turn for every segment, 0 without contact; size: twice the number of segments"},
    {"Coordinates_t", 0, "m/s", "tangential and normal relative velocity, in turn for every segment, 0 without contact; size: twice the number of segments"},
    {"ForceLocal", 0, "N", "tangential and normal force, in turn for every segment; size: twice the number of segments"},
}};

constexpr std::array<std::string_view, 21> ObjectContactSphereSphere_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "markers at the centers of the two spheres",
    "NodeGenericData with four data coordinates of the last update: gap, tangential speed, impact velocity, plastic overlap; initial gap positive: no contact",
    "radii of the spheres at marker m0 and marker m1; must be positive",
    "True: the sphere of marker m1 is hollow, and the other one touches it from inside",
    "coefficient of dry friction; 0: no friction, and no torques",
    "tangential speed up to which friction is proportional to it",
    "stiffness of the normal contact; n is ``contactStiffnessExponent``",
    "linear damping coefficient in normal direction, added in all impact models; leave it 0 for a restitution coefficient below 1",
    "exponent n of the penetration in the normal force; 1.5 for Hertzian contact",
    "constant adhesive force in contact, for ``impactModel`` 0",
    "one minus the ratio of the stiffness at first loading to that at unloading, from 0 to below 1; 0: no plastic overlap",
    "coefficient of the adhesive force that grows with penetration (N/m for an exponent of 1); 0: none. It acts in unloading after a plastic overlap, so with ``contactPlasticityRatio`` and ``impactModel`` 0 only",
    "exponent of the penetration in the adhesive force",
    "ratio of normal speeds after and before an impact, for ``impactModel`` 1 and 2; positive, 1: elastic",
    "lower bound of the impact velocity in the restitution law; larger values damp slow and lasting contacts more",
    "0: elastic contact with linear damping; 1: Hunt-Crossley, for restitution near 1; 2: Carvalho-Martins and Gonthier, for all restitution coefficients",
    "False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero",
    "True: the force is never tensile; it is zero if damping would make it tensile. False: damping also acts in tension until the gap is open",
    "True: the item is drawn",
    "red, green, blue and opacity of the drawn shapes",
};
constexpr std::array<OutputText, 7> ObjectContactSphereSphere_outputs{{
    {"Position", 3, "m", "global contact point, in the middle of the overlap or gap"},
    {"Displacement", 3, "m", "global vector from marker m0 to marker m1"},
    {"DisplacementLocal", 1, "m", "gap, negative in contact"},
    {"Velocity", 3, "m/s", "global relative velocity of the surfaces at the contact point"},
    {"Force", 3, "N", "global contact force on marker m0, with friction; its negative acts on marker m1; 0 without contact"},
    {"Director1", 3, "1", "unit vector from marker m0 to the contact point"},
    {"Torque", 3, "Nm", "global vector whose negative is the torque of the contact force about marker m0"},
}};

constexpr std::array<std::string_view, 19> ObjectContactSphereTorus_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "marker m0 at the center of the sphere and marker m1 at the center of the torus",
    "NodeGenericData with four data coordinates of the last update: gap, tangential speed, impact velocity, and one that is not used",
    "radius of the sphere at marker m0",
    "radius of the center line of the torus",
    "radius of the tube, larger than that of the sphere",
    "axis of the torus in the frame of marker m1, a unit vector",
    "coefficient of dry friction",
    "tangential speed up to which friction is proportional to it",
    "stiffness of the normal contact; n is ``contactStiffnessExponent``",
    "linear damping coefficient in normal direction, added in all impact models; leave it 0 for a restitution coefficient below 1",
    "exponent n of the penetration in the normal force; 1.5 for Hertzian contact",
    "ratio of normal speeds after and before an impact, for ``impactModel`` 1 and 2; positive, 1: elastic",
    "lower bound of the impact velocity in the restitution law; larger values damp slow and lasting contacts more",
    "0: elastic contact with linear damping; 1: Hunt-Crossley, for restitution near 1; 2: Carvalho-Martins and Gonthier, for all restitution coefficients",
    "False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero",
    "True: the force is never tensile; it is zero if damping would make it tensile. False: damping also acts in tension until the gap is open",
    "True: the item is drawn",
    "red, green, blue and opacity of the drawn shapes",
};
constexpr std::array<OutputText, 9> ObjectContactSphereTorus_outputs{{
    {"Position", 3, "m", "global contact point, in the middle of the overlap or gap"},
    {"Displacement", 3, "m", "global vector from marker m0 to marker m1"},
    {"DisplacementLocal", 1, "m", "gap, negative in contact"},
    {"Director1", 3, "1", "unit vector from marker m0 to marker m1"},
    {"Director2", 3, "1", "unit vector from the center of the torus to the nearest point of its center line"},
    {"Director3", 3, "1", "contact normal, unit vector from the center line of the torus to the center of the sphere"},
    {"Force", 3, "N", "global contact force on marker m0, with friction; its negative acts on marker m1; 0 without contact"},
    {"Torque", 3, "Nm", "global vector whose negative is the torque of the contact force about marker m0"},
    {"Velocity", 3, "m/s", "global velocity of the torus relative to the sphere at the contact point"},
}};

constexpr std::array<std::string_view, 18> ObjectContactSphereTriangle_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "marker m0 at the center of the sphere and marker m1 on the body that carries the triangle",
    "NodeGenericData with four data coordinates of the last update: gap, tangential speed, impact velocity, and one that is not used",
    "radius of the sphere at marker m0",
    "three points in the frame of marker m1",
    "sum of 1, 2 and 4 for contact with edge 0 (points 0 and 1), edge 1 (points 1 and 2) and edge 2 (points 2 and 0); 7: all edges; edges between triangles of a smooth surface are left out",
    "coefficient of dry friction; 0: no friction, and no torques",
    "tangential speed up to which friction is proportional to it",
    "stiffness of the normal contact; n is ``contactStiffnessExponent``",
    "linear damping coefficient in normal direction, added in all impact models; leave it 0 for a restitution coefficient below 1",
    "exponent n of the penetration in the normal force; 1.5 for Hertzian contact",
    "ratio of normal speeds after and before an impact, for ``impactModel`` 1 and 2; positive, 1: elastic",
    "lower bound of the impact velocity in the restitution law; larger values damp slow and lasting contacts more",
    "0: elastic contact with linear damping; 1: Hunt-Crossley, for restitution near 1; 2: Carvalho-Martins and Gonthier, for all restitution coefficients",
    "False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero",
    "True: the force is never tensile; it is zero if damping would make it tensile. False: damping also acts in tension until the gap is open",
    "True: the item is drawn",
    "red, green, blue and opacity of the drawn shapes",
};
constexpr std::array<OutputText, 7> ObjectContactSphereTriangle_outputs{{
    {"Position", 3, "m", "global contact point, in the middle of the overlap or gap"},
    {"Displacement", 3, "m", "global vector from marker m0 to the nearest point of the triangle"},
    {"DisplacementLocal", 1, "m", "gap, negative in contact"},
    {"Director1", 3, "1", "unit vector from marker m0 to the nearest point of the triangle"},
    {"Force", 3, "N", "global contact force on marker m0, with friction; its negative acts on marker m1; 0 without contact"},
    {"Torque", 3, "Nm", "global vector whose negative is the torque of the contact force about marker m0"},
    {"Velocity", 3, "m/s", "global velocity of the nearest point of the triangle relative to the center of the sphere"},
}};

constexpr std::array<std::string_view, 12> ObjectJointALEMoving2D_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "marker m0 of the sliding body, and marker m1 of the cable element on which it begins, one of ``slidingMarkerNumbers``; the data node has the current element",
    "coordinate markers of all cable elements in the order in which they follow each other: the end of one element is the begin of the next",
    "for each of these elements, the sum of the reference lengths of all elements before it; the first is 0; one for each of ``slidingMarkerNumbers``",
    "reference arc length that is added to the sliding coordinate",
    "NodeGenericData with one data coordinate (index of the current element), and the NodeGenericODE2 with the sliding coordinate of the cable, the third node of its elements",
    "True: the constraint is softened by ``penaltyStiffness``, still with multipliers as unknowns",
    "stiffness of the softened constraint",
    "False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero",
    "False: the item is not drawn",
    "size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 6> ObjectJointALEMoving2D_outputs{{
    {"Position", 3, "m", "global position of marker m0"},
    {"Velocity", 3, "m/s", "global velocity of marker m0"},
    {"SlidingCoordinate", 1, "m", "sliding coordinate of the cable plus offset; without its reference coordinate"},
    {"Coordinates", 2, "various", "index of the current element (1), and sliding coordinate of the cable (m)"},
    {"Coordinates_t", 1, "m/s", "sliding velocity of the cable"},
    {"Force", 3, "N", "Lagrange multipliers, the global joint force; the third value is 0"},
}};

constexpr std::array<std::string_view, 14> ObjectJointGeneric_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0",
    "six flags, 1 constrained and 0 free: translation along the x, y, z axis of frame J0, rotation about them; other values are refused",
    "rotation matrix from joint frame J0 to the frame of marker m0; turns the axes of the joint",
    "rotation matrix from joint frame J1 to the frame of marker m1; the joint is in its zero position if J0 and J1 are parallel",
    "False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero",
    "six values that are passed to the user functions, of free meaning",
    "Python function that prescribes relative translation and rotation in the constrained directions, on position level",
    "Python function, the time derivative of ``offsetUserFunction``; index 2 integrators follow it alone",
    "True: other equations for three constrained rotations, which keep static solutions from flipping by half a turn; experimental",
    "False: the item is not drawn",
    "radius of the drawn axes",
    "length of the drawn axes",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 10> ObjectJointGeneric_outputs{{
    {"Position", 3, "m", "global position of marker m0"},
    {"Velocity", 3, "m/s", "global velocity of marker m0"},
    {"DisplacementLocal", 3, "m", "position of marker m1 relative to marker m0 in frame J0; constrained components show the error of the constraint"},
    {"VelocityLocal", 3, "m/s", "global velocity of marker m1 minus that of marker m0, in frame J0"},
    {"Rotation", 3, "rad", "Tait-Bryan angles (about x, y, z in turn) of J1 relative to J0; the angle of rotation for a single free axis"},
    {"AngularVelocityLocal", 3, "rad/s", "angular velocity of marker m1 relative to marker m0, in frame J0"},
    {"ForceLocal", 3, "N", "Lagrange multipliers of the translations in frame J0: the force on marker m0; 0 in free directions"},
    {"TorqueLocal", 3, "Nm", "Lagrange multipliers of the rotations in the order of the equations, signs and axes as given there; 0 where there is no equation"},
    {"HomogeneousTransformation", 16, "various", "position and rotation of joint frame J0 as a 4 x 4 matrix, row by row; output functions return ``exu.HT``"},
    {"HomogeneousTransformationLocal", 16, "various", "relative position and rotation of joint frame J1 in joint frame J0 as a 4 x 4 matrix, row by row; output functions return ``exu.HT``"},
}};

constexpr std::array<std::string_view, 9> ObjectJointPrismatic2D_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0",
    "direction of the axis in the frame of marker m0, a unit vector in the x-y plane",
    "normal of the axis in the frame of marker m1, a unit vector in the x-y plane; perpendicular to the axis in the initial position",
    "True: the bodies do not rotate relative to each other; False: relative rotation is free",
    "False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero",
    "False: the item is not drawn",
    "size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 8> ObjectJointPrismatic2D_outputs{{
    {"Position", 3, "m", "global position of marker m0"},
    {"Velocity", 3, "m/s", "global velocity of marker m0"},
    {"DisplacementLocal", 3, "m", "position of marker m1 relative to marker m0 in the axes of marker m0"},
    {"Distance", 1, "m", "component of DisplacementLocal along ``axisMarker0``"},
    {"Rotation", 1, "rad", "angle of marker m1 relative to marker m0, the error of the constraint for rotations"},
    {"ForceLocal", 3, "N", "joint force on marker m0 in its axes"},
    {"HomogeneousTransformation", 16, "various", "position and rotation of marker m0 as a 4 x 4 matrix, row by row; output functions return ``exu.HT``"},
    {"HomogeneousTransformationLocal", 16, "various", "relative position and rotation of marker m1 in the axes of marker m0 as a 4 x 4 matrix, row by row; output functions return ``exu.HT``"},
}};

constexpr std::array<std::string_view, 9> ObjectJointPrismaticX_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0",
    "rotation matrix from joint frame J0 to the frame of marker m0; turns the axes of the joint",
    "rotation matrix from joint frame J1 to the frame of marker m1; the joint is in its zero position if J0 and J1 are parallel",
    "False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero",
    "False: the item is not drawn",
    "radius of the drawn axis",
    "length of the drawn axis",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 10> ObjectJointPrismaticX_outputs{{
    {"Position", 3, "m", "global position of marker m0"},
    {"Velocity", 3, "m/s", "global velocity of marker m0"},
    {"DisplacementLocal", 3, "m", "position of marker m1 relative to marker m0 in frame J0; constrained components show the error of the constraint"},
    {"VelocityLocal", 3, "m/s", "global velocity of marker m1 minus that of marker m0, in frame J0"},
    {"Rotation", 3, "rad", "Tait-Bryan angles (about x, y, z in turn) of J1 relative to J0, the error of the constraint"},
    {"AngularVelocityLocal", 3, "rad/s", "angular velocity of marker m1 relative to marker m0, in frame J0"},
    {"ForceLocal", 3, "N", "joint force on marker m0, in frame J0; the first value is 0"},
    {"TorqueLocal", 3, "Nm", "Lagrange multipliers of the three rotations: about the x axis, the negative y axis and the negative z axis"},
    {"HomogeneousTransformation", 16, "various", "position and rotation of joint frame J0 as a 4 x 4 matrix, row by row; output functions return ``exu.HT``"},
    {"HomogeneousTransformationLocal", 16, "various", "relative position and rotation of joint frame J1 in joint frame J0 as a 4 x 4 matrix, row by row; output functions return ``exu.HT``"},
}};

constexpr std::array<std::string_view, 6> ObjectJointRevolute2D_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0",
    "False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero",
    "False: the item is not drawn",
    "size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 4> ObjectJointRevolute2D_outputs{{
    {"Position", 3, "m", "global position of marker m0"},
    {"Velocity", 3, "m/s", "global velocity of marker m0"},
    {"Displacement", 3, "m", "global position of marker m1 relative to marker m0, the error of the constraint"},
    {"Force", 3, "N", "Lagrange multipliers, the global joint force on marker m0; the third value is 0"},
}};

constexpr std::array<std::string_view, 9> ObjectJointRevoluteZ_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0",
    "rotation matrix from joint frame J0 to the frame of marker m0; turns the axes of the joint",
    "rotation matrix from joint frame J1 to the frame of marker m1; the joint is in its zero position if J0 and J1 are parallel",
    "False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero",
    "False: the item is not drawn",
    "radius of the drawn axis",
    "length of the drawn axis",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 10> ObjectJointRevoluteZ_outputs{{
    {"Position", 3, "m", "global position of marker m0"},
    {"Velocity", 3, "m/s", "global velocity of marker m0"},
    {"DisplacementLocal", 3, "m", "position of marker m1 relative to marker m0 in frame J0; constrained components show the error of the constraint"},
    {"VelocityLocal", 3, "m/s", "global velocity of marker m1 minus that of marker m0, in frame J0"},
    {"Rotation", 3, "rad", "Tait-Bryan angles (about x, y, z in turn) of J1 relative to J0; the third one is the angle of the joint, the others show the error of the constraint"},
    {"AngularVelocityLocal", 3, "rad/s", "angular velocity of marker m1 relative to marker m0, in frame J0"},
    {"ForceLocal", 3, "N", "joint force on marker m0, in frame J0"},
    {"TorqueLocal", 3, "Nm", "Lagrange multipliers of the two rotations, the first one about the negative y axis, the second one about the x axis; the third value is 0"},
    {"HomogeneousTransformation", 16, "various", "position and rotation of joint frame J0 as a 4 x 4 matrix, row by row; output functions return ``exu.HT``"},
    {"HomogeneousTransformationLocal", 16, "various", "relative position and rotation of joint frame J1 in joint frame J0 as a 4 x 4 matrix, row by row; output functions return ``exu.HT``"},
}};

constexpr std::array<std::string_view, 10> ObjectJointRollingDisc_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "marker m0 on the plane and marker m1 at the center of the disc",
    "three flags, 1 constrained and 0 free: lateral, forward and normal velocity of the contact point; other values are refused",
    "False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero",
    "radius of the disc",
    "axis of the disc in the frame of marker m1, a unit vector; must not become parallel to the normal of the plane",
    "normal of the plane in the frame of marker m0, a unit vector",
    "False: the item is not drawn",
    "width of the drawn disc",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 4> ObjectJointRollingDisc_outputs{{
    {"Position", 3, "m", "global position of the contact point"},
    {"Velocity", 3, "m/s", "global velocity at which the contact point moves along its trail; not the velocity of the disc at that point"},
    {"ForceLocal", 3, "N", "contact force on the disc in frame J1: lateral, forward, normal"},
    {"RotationMatrix", 9, "1", "rotation matrix from frame J1 (lateral, forward, normal) to the global frame, row by row"},
}};

constexpr std::array<std::string_view, 12> ObjectJointSliding_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "marker m0 of the sliding body, and marker m1 of the cable element on which it begins, one of ``slidingMarkerNumbers``; the data node has the current element",
    "shape markers of all cable elements in the order in which they follow each other: the end of one element is the begin of the next",
    "for each of these elements, the sum of the reference lengths of all elements before it; the first is 0; one for each of ``slidingMarkerNumbers``",
    "NodeGenericData with two data coordinates: index of the current element in ``slidingMarkerNumbers``, and sliding coordinate at the begin of the step",
    "three flags, 1 constrained and 0 free: rotation of marker m0, then a rigid body marker, about its x, y and z axis; cables do not tell how they are twisted, so that the first flag has to be 0",
    "three flags, 1 constrained and 0 free: translation of marker m0 relative to the cable along the global axes",
    "force along the cable that drives the body; changed during a simulation to move the body",
    "False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero",
    "False: the item is not drawn",
    "size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 4> ObjectJointSliding_outputs{{
    {"Position", 3, "m", "global position of marker m0"},
    {"Velocity", 3, "m/s", "global velocity of marker m0"},
    {"SlidingCoordinate", 1, "m", "sliding coordinate along all elements, from 0 to the sum of their reference lengths"},
    {"Force", 3, "N", "Lagrange multipliers of the position constraint, the joint force"},
}};

constexpr std::array<std::string_view, 12> ObjectJointSliding2D_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "marker m0 of the sliding body, and marker m1 of the cable element on which it begins, one of ``slidingMarkerNumbers``; the data node has the current element",
    "coordinate markers of all cable elements in the order in which they follow each other: the end of one element is the begin of the next",
    "for each of these elements, the sum of the reference lengths of all elements before it; the first is 0; one for each of ``slidingMarkerNumbers``",
    "NodeGenericData with two data coordinates: index of the current element in ``slidingMarkerNumbers``, and sliding coordinate at the begin of the step",
    "True: the force along the cable is prescribed, and both components of position are constrained; False: only the normal direction is constrained, by one multiplier",
    "True: marker m0, then a rigid body marker, keeps its orientation relative to the slope of the cable; False: it rotates freely",
    "force along the cable that drives the body; only for ``classicalFormulation``; changed during a simulation to move the body",
    "False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero",
    "False: the item is not drawn",
    "size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 5> ObjectJointSliding2D_outputs{{
    {"Position", 3, "m", "global position of marker m0"},
    {"Velocity", 3, "m/s", "global velocity of marker m0"},
    {"SlidingCoordinate", 1, "m", "sliding coordinate along all elements, from 0 to the sum of their reference lengths"},
    {"Force", 3, "N", "Lagrange multipliers of the position constraint, the joint force"},
    {"DisplacementLocal", 3, "m", "position of the cable at the sliding coordinate relative to the body, along and normal to the slope of the cable; the third value is 0"},
}};

constexpr std::array<std::string_view, 7> ObjectJointSpherical_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0",
    "three flags, 1 constrained and 0 free: relative translation along the global x, y and z axis; other values are refused",
    "False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero",
    "False: the item is not drawn",
    "radius of the drawn joint",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 4> ObjectJointSpherical_outputs{{
    {"Position", 3, "m", "global position of marker m0"},
    {"Velocity", 3, "m/s", "global velocity of marker m0"},
    {"Displacement", 3, "m", "global position of marker m1 relative to marker m0; constrained components show the error of the constraint"},
    {"Force", 3, "N", "Lagrange multipliers, the global joint force on marker m0; 0 in free directions"},
}};

constexpr std::array<std::string_view, 8> MarkerBodiesRelativeRotationCoordinate_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "the two bodies whose relative motion is the coordinate",
    "NodeGenericData with one data coordinate that holds the last angle and makes the coordinate continuous beyond half a turn; not set: the angle jumps",
    "point in the frame of the first body, which is the position of the marker; the angle does not depend on it",
    "point in the frame of the second body; no effect, because the angle does not depend on it",
    "axis of rotation in the frame of the first body, a unit vector",
    "angle that is subtracted from the measured one",
    "False: the item is not drawn",
};

constexpr std::array<std::string_view, 7> MarkerBodiesRelativeTranslationCoordinate_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "the two bodies whose relative motion is the coordinate",
    "point in the frame of the first body",
    "point in the frame of the second body",
    "axis of translation in the frame of the first body, a unit vector",
    "length that is subtracted from the measured one",
    "False: the item is not drawn",
};

constexpr std::array<std::string_view, 3> MarkerBodyBeamShape_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "spatial cable element to which the marker is attached",
    "False: the item is not drawn",
};

constexpr std::array<std::string_view, 3> MarkerBodyCable2DCoordinates_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "planar cable element to which the marker is attached",
    "False: the item is not drawn",
};

constexpr std::array<std::string_view, 5> MarkerBodyCable2DShape_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "planar cable element to which the marker is attached",
    "number of segments; must be that of the contact that uses the marker",
    "distance of the segments from the axis of the cable in direction of its local y axis, such as half the thickness of a belt",
    "False: the item is not drawn",
};

constexpr std::array<std::string_view, 3> MarkerBodyMass_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "body with a mass to which the marker is attached",
    "False: the item is not drawn",
};

constexpr std::array<std::string_view, 4> MarkerBodyPosition_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "body to which the marker is attached",
    "position of the marker in the body frame, relative to the reference point of the body",
    "False: the item is not drawn",
};

constexpr std::array<std::string_view, 5> MarkerBodyRigid_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "body to which the marker is attached",
    "position of the marker in the body frame, relative to the reference point of the body",
    "rotation of the marker in the frame that it would have without: joints and body-fixed loads use the turned axes. ``localHT`` sets position and rotation",
    "False: the item is not drawn",
};

constexpr std::array<std::string_view, 6> MarkerKinematicTreeRigid_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "kinematic tree to which the marker is attached",
    "number of the link within the tree, from 0, or its name, or that of its joint; -1 means not set and is rejected",
    "position of the marker in the frame of the link",
    "rotation of the marker in the frame that it would have without: joints and body-fixed loads use the turned axes. ``localHT`` sets position and rotation",
    "False: the item is not drawn",
};

constexpr std::array<std::string_view, 4> MarkerNodeCoordinate_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "node to which the marker is attached",
    "number of the coordinate within the node, from 0, or the name of a joint of the kinematic tree on the node; -1 means not set and is rejected; any number reads zero at a ground node",
    "False: the item is not drawn",
};

constexpr std::array<std::string_view, 3> MarkerNodeCoordinates_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "node to which the marker is attached",
    "False: the item is not drawn",
};

constexpr std::array<std::string_view, 4> MarkerNodeODE1Coordinate_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "NodeGenericODE1 to which the marker is attached",
    "number of the coordinate within the node, from 0; -1 means not set and is rejected",
    "True: the item is drawn",
};

constexpr std::array<std::string_view, 3> MarkerNodePosition_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "node with a position to which the marker is attached",
    "False: the item is not drawn",
};

constexpr std::array<std::string_view, 4> MarkerNodeRigid_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "node with position and orientation, such as a rigid body node, to which the marker is attached",
    "rotation of the marker in the frame that it would have without: joints and body-fixed loads use the turned axes. ``localHT`` sets position and rotation",
    "False: the item is not drawn",
};

constexpr std::array<std::string_view, 4> MarkerNodeRotationCoordinate_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "node with an orientation in space to which the marker is attached; planar nodes are refused, use MarkerNodeCoordinate for them",
    "axis of rotation: 0 for x, 1 for y, 2 for z; -1 means not set and is rejected",
    "False: the item is not drawn",
};

constexpr std::array<std::string_view, 3> MarkerObjectODE2Coordinates_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "body to which the marker is attached",
    "False: the item is not drawn",
};

constexpr std::array<std::string_view, 6> MarkerSuperElementPosition_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "super element to which the marker is attached",
    "mesh nodes of the super element, numbered within it from 0; each must have a position",
    "weight of every mesh node, as many as mesh nodes; should sum up to 1, such that the marker moves with a rigid translation of the nodes",
    "False: the item is not drawn",
    "True: the mesh nodes of the marker are drawn as well",
};

constexpr std::array<std::string_view, 10> MarkerSuperElementRigid_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "super element to which the marker is attached",
    "correction of the marker position in the reference frame of the super element, if the mean of the mesh nodes is not the wanted point; should be small",
    "mesh nodes of the super element, numbered within it from 0; each must have a position",
    "weight of every mesh node, as many as mesh nodes; should sum up to 1, for instance parts of the area of an interface",
    "True: the mean rotation follows from the angular momentum of the weighted nodes; False: it is a mean weighted by squared distances",
    "0: rotation and angular velocity are linearized; 1: rotation by the exponential map; 2: rotation by the exponential map and angular velocity by its tangent map, the consistent choice",
    "rotation of the marker in the frame that it would have without: joints and body-fixed loads use the turned axes. ``localHT`` sets position and rotation",
    "False: the item is not drawn",
    "True: the mesh nodes of the marker are drawn as well",
};

constexpr std::array<std::string_view, 5> LoadCoordinate_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "coordinate marker to which the load is applied",
    "generalized force: N on a coordinate that is a length, Nm on an angle; ignored if there is a user function, which receives it as an argument",
    "Python function that computes the load as a function of time",
    "False: the item is not drawn",
};

constexpr std::array<std::string_view, 6> LoadForceVector_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "marker with a position to which the force is applied; with ``bodyFixed`` it must have an orientation as well",
    "force vector in global coordinates, or in the marker frame with ``bodyFixed``; ignored if there is a user function, which receives it as an argument",
    "True: the vector is given in the frame of the marker and turns with the body, a follower force; False: in global coordinates",
    "Python function that computes the force vector as a function of time",
    "False: the item is not drawn",
};

constexpr std::array<std::string_view, 5> LoadMassProportional_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "marker of type BodyMass on the body to which the load is applied",
    "force per mass in global coordinates, such as the gravitational acceleration ``[0, 0, -9.81]``; ignored if there is a user function, which receives it as an argument",
    "Python function that computes the vector as a function of time",
    "False: the item is not drawn",
};

constexpr std::array<std::string_view, 6> LoadTorqueVector_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "marker with an orientation to which the torque is applied",
    "torque vector in global coordinates, or in the marker frame with ``bodyFixed``; ignored if there is a user function, which receives it as an argument",
    "True: the vector is given in the frame of the marker and turns with the body; False: in global coordinates",
    "Python function that computes the torque vector as a function of time",
    "False: the item is not drawn",
};

constexpr std::array<std::string_view, 8> SensorBody_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "body that is measured",
    "point in the body frame, relative to the reference point; the x component of beams and cables is the position along the axis",
    "write the measured values to a file while a solver runs; no effect if ``fileName`` is empty",
    "file with the time in the first and the values in the further columns; the path is relative to the working directory, missing directories are created",
    "output variable that is measured; one that the measured item does not provide is refused in Assemble",
    "keep time and values in memory, to be read with ``mbs.GetSensorStoredData`` during or after the solution",
    "False: the item is not drawn",
};

constexpr std::array<std::string_view, 9> SensorKinematicTree_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "kinematic tree that is measured",
    "link, numbered within the tree from 0, or its name, or that of its joint; -1 means not set and is rejected",
    "point in the frame of the link",
    "write the measured values to a file while a solver runs; no effect if ``fileName`` is empty",
    "file with the time in the first and the values in the further columns; the path is relative to the working directory, missing directories are created",
    "output variable that is measured; one that the measured item does not provide is refused in Assemble",
    "keep time and values in memory, to be read with ``mbs.GetSensorStoredData`` during or after the solution",
    "False: the item is not drawn",
};

constexpr std::array<std::string_view, 6> SensorLoad_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "load that is measured",
    "write the measured values to a file while a solver runs; no effect if ``fileName`` is empty",
    "file with the time in the first and the values in the further columns; the path is relative to the working directory, missing directories are created",
    "keep time and values in memory, to be read with ``mbs.GetSensorStoredData`` during or after the solution",
    "False: the item is not drawn",
};

constexpr std::array<std::string_view, 7> SensorMarker_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "marker that is measured",
    "write the measured values to a file while a solver runs; no effect if ``fileName`` is empty",
    "file with the time in the first and the values in the further columns; the path is relative to the working directory, missing directories are created",
    "output variable that is measured; one that the measured item does not provide is refused in Assemble",
    "keep time and values in memory, to be read with ``mbs.GetSensorStoredData`` during or after the solution",
    "False: the item is not drawn",
};

constexpr std::array<std::string_view, 7> SensorNode_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "node that is measured",
    "write the measured values to a file while a solver runs; no effect if ``fileName`` is empty",
    "file with the time in the first and the values in the further columns; the path is relative to the working directory, missing directories are created",
    "output variable that is measured; one that the measured item does not provide is refused in Assemble",
    "keep time and values in memory, to be read with ``mbs.GetSensorStoredData`` during or after the solution",
    "False: the item is not drawn",
};

constexpr std::array<std::string_view, 7> SensorObject_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "object that is measured; a body is refused for variables that need a local position, use SensorBody for it",
    "write the measured values to a file while a solver runs; no effect if ``fileName`` is empty",
    "file with the time in the first and the values in the further columns; the path is relative to the working directory, missing directories are created",
    "output variable that is measured; one that the measured item does not provide is refused in Assemble",
    "keep time and values in memory, to be read with ``mbs.GetSensorStoredData`` during or after the solution",
    "False: the item is not drawn",
};

constexpr std::array<std::string_view, 8> SensorSuperElement_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "super element that is measured",
    "mesh node, numbered within the super element from 0, or the name of a link of a kinematic tree; -1 means not set and is rejected",
    "write the measured values to a file while a solver runs; no effect if ``fileName`` is empty",
    "file with the time in the first and the values in the further columns; the path is relative to the working directory, missing directories are created",
    "output variable that is measured; one that the measured item does not provide is refused in Assemble",
    "keep time and values in memory, to be read with ``mbs.GetSensorStoredData`` during or after the solution",
    "False: the item is not drawn",
};

constexpr std::array<std::string_view, 8> SensorUserFunction_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "sensors that the user function may evaluate; may be empty",
    "values that are passed to the user function, of free meaning, such as weights or conversions of units",
    "write the measured values to a file while a solver runs; no effect if ``fileName`` is empty",
    "file with the time in the first and the values in the further columns; the path is relative to the working directory, missing directories are created",
    "Python function that returns the values of the sensor",
    "keep time and values in memory, to be read with ``mbs.GetSensorStoredData`` during or after the solution",
    "False: the item is not drawn",
};

constexpr std::array<ItemText, 98> all{{
    {"node with a chosen number of algebraic variables, for equations that hold without time derivatives", NodeGenericAE_rows, NodeGenericAE_outputs,
     "\nPage: reference/items/nodes/generic_ae.html\n"},
    {"node with a chosen number of data variables: states that are kept from step to step and are not unknowns of the solver", NodeGenericData_rows, NodeGenericData_outputs,
     "\nExample:\n    node = mbs.AddNode(NodePoint(initialVelocities=[0, 0, 5]))\n    mbs.AddObject(MassPoint(physicsMass=1, nodeNumber=node))\n    marker = mbs.AddMarker(MarkerNodePosition(nodeNumber=node))\n    mbs.AddLoad(Force(markerNumber=marker, loadVector=[0, 0, -10]))\n    data = mbs.AddNode(NodeGenericData(initialCoordinates=[0], numberOfDataCoordinates=1))\n\n    def count_rising_steps(mbs, t):\n        if mbs.GetNodeOutput(node, exu.OutputVariableType.Velocity)[2] > 0.05:\n            mbs.systemData.SetDataCoordinates(mbs.systemData.GetDataCoordinates() + 1)\n        return True\n\n    mbs.SetPreStepUserFunction(count_rising_steps)\n    mbs.Assemble()\n    mbs.SolveDynamic()\n    # 100 steps of 0.01 s; the velocity 5 - 10 t at the begin of a step exceeds 0.05 in the first 50\n    result = mbs.GetNodeOutput(data, exu.OutputVariableType.Coordinates)\n\nPage: reference/items/nodes/generic_data.html\n"},
    {"node with a chosen number of coordinates of first order differential equations, for controllers, hydraulics and state-space models", NodeGenericODE1_rows, NodeGenericODE1_outputs,
     "\nExample:\n    node = mbs.AddNode(NodeGenericODE1(referenceCoordinates=[0], initialCoordinates=[5], numberOfODE1Coordinates=1))\n    mbs.AddObject(ObjectGenericODE1(nodeNumbers=[node], systemMatrix=[[-2]]))\n    mbs.Assemble()\n    mbs.SolveDynamic(solverType=exu.DynamicSolverType.RK44)\n    # decay y' = -2 y from y = 5: 5 exp(-2)\n    result = mbs.GetNodeOutput(node, exu.OutputVariableType.Coordinates)\n\nPage: reference/items/nodes/generic_ode1.html\n"},
    {"node with a chosen number of coordinates of second order differential equations, without a meaning in space", NodeGenericODE2_rows, NodeGenericODE2_outputs,
     "\nCreated by: mbs.CreateKinematicTree(...)\n\nExample:\n    k = 200.\n    node = mbs.AddNode(NodeGenericODE2(referenceCoordinates=[0, 0], initialCoordinates=[0, 0],\n                                       initialCoordinates_t=[0, 0], numberOfODE2Coordinates=2))\n    mbs.AddObject(ObjectGenericODE2(nodeNumbers=[node], massMatrix=np.eye(2),\n                                    stiffnessMatrix=k*np.array([[2, -1], [-1, 1]])))\n    marker = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=node, coordinate=1))\n    mbs.AddLoad(LoadCoordinate(markerNumber=marker, load=10))\n    mbs.Assemble()\n    mbs.SolveStatic()\n    # two springs in series carry the load: 10/k and 2*10/k\n    result = mbs.GetNodeOutput(node, exu.OutputVariableType.Coordinates)\n\nPage: reference/items/nodes/generic_ode2.html\n"},
    {"node with one coordinate of a second order differential equation, for motion along a line or about a fixed axis", Node1D_rows, Node1D_outputs,
     "\nExample:\n    node = mbs.AddNode(Node1D(referenceCoordinates=[0.5]))\n    ground = mbs.AddNode(NodePointGround())\n    mbs.AddObject(Mass1D(physicsMass=3, nodeNumber=node))\n    m_ground = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=ground, coordinate=0))\n    m_node = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=node, coordinate=0))\n    mbs.AddObject(CoordinateSpringDamper(markerNumbers=[m_ground, m_node], stiffness=400))\n    mbs.AddLoad(LoadCoordinate(markerNumber=m_node, load=100))\n    mbs.Assemble()\n    mbs.SolveStatic()\n    # displacement 100/400, added to the reference coordinate\n    result = mbs.GetNodeOutput(node, exu.OutputVariableType.CoordinatesTotal)\n\nPage: reference/items/nodes/one_d.html\n"},
    {"node with the three displacements of a point in space", NodePoint_rows, NodePoint_outputs,
     "\nCreated by: mbs.CreateMassPoint(...)\n\nExample:\n    node = mbs.AddNode(NodePoint(referenceCoordinates=[1, 2, 3], initialCoordinates=[0.5, 0, 0], initialVelocities=[3, 0, 4]))\n    mbs.AddObject(MassPoint(physicsMass=2, nodeNumber=node))\n    marker = mbs.AddMarker(MarkerNodePosition(nodeNumber=node))\n    mbs.AddLoad(Force(markerNumber=marker, loadVector=[0, 0, -8]))\n    mbs.Assemble()\n    mbs.SolveDynamic()\n    # throw with the constant acceleration -8/2: reference + initial + v t + a t^2/2 at t = 1\n    result = mbs.GetNodeOutput(node, exu.OutputVariableType.Position)\n\nPage: reference/items/nodes/point.html\n"},
    {"node with the two displacements of a point in the global x-y plane", NodePoint2D_rows, NodePoint2D_outputs,
     "\nCreated by: mbs.CreateMassPoint(...)\n\nExample:\n    node = mbs.AddNode(NodePoint2D(referenceCoordinates=[2, 1], initialVelocities=[-1, 3]))\n    mbs.AddObject(MassPoint2D(physicsMass=0.5, nodeNumber=node))\n    marker = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=node, coordinate=1))\n    mbs.AddLoad(LoadCoordinate(markerNumber=marker, load=-3))\n    mbs.Assemble()\n    mbs.SolveDynamic()\n    # x: 2 - t; y: 1 + 3 t - 6 t^2/2 at t = 1; z is not a coordinate\n    result = mbs.GetNodeOutput(node, exu.OutputVariableType.Position)\n\nPage: reference/items/nodes/point_2d.html\n"},
    {"node of planar cable elements: position and axial slope vector in the global x-y plane", NodePoint2DSlope1_rows, NodePoint2DSlope1_outputs,
     "\nExample:\n    nodes = [mbs.AddNode(NodePoint2DSlope1(referenceCoordinates=[x, 0, 1, 0])) for x in (0, 2)]\n    mbs.AddObject(Cable2D(physicsLength=2, physicsMassPerLength=1, physicsBendingStiffness=10,\n                          physicsAxialStiffness=500, nodeNumbers=nodes))\n    ground = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.AddNode(NodePointGround()), coordinate=0))\n    for coordinate in (0, 1, 3):\n        clamped = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=nodes[0], coordinate=coordinate))\n        mbs.AddObject(CoordinateConstraint(markerNumbers=[ground, clamped]))\n    tip = mbs.AddMarker(MarkerNodePosition(nodeNumber=nodes[1]))\n    mbs.AddLoad(Force(markerNumber=tip, loadVector=[25, 0, 0]))\n    mbs.Assemble()\n    mbs.SolveStatic()\n    # uniform strain 25/500 = 0.05: the slope [1, 0] becomes [1.05, 0], the tip moves by 0.05*2\n    result = mbs.GetNodeOutput(nodes[1], exu.OutputVariableType.CoordinatesTotal)\n\nPage: reference/items/nodes/point_2d_slope1.html\n"},
    {"fixed point without coordinates, as the other end of springs and constraints on coordinates or points", NodePointGround_rows, NodePointGround_outputs,
     "\nExample:\n    ground = mbs.AddNode(NodePointGround(referenceCoordinates=[0, 0, 1]))\n    node = mbs.AddNode(NodePoint(referenceCoordinates=[0, 0, 1]))\n    mbs.AddObject(MassPoint(physicsMass=2, nodeNumber=node))\n    m_ground = mbs.AddMarker(MarkerNodePosition(nodeNumber=ground))\n    m_node = mbs.AddMarker(MarkerNodePosition(nodeNumber=node))\n    mbs.AddObject(CartesianSpringDamper(markerNumbers=[m_ground, m_node], stiffness=[50, 100, 200]))\n    mbs.AddLoad(Force(markerNumber=m_node, loadVector=[5, 4, -20]))\n    mbs.Assemble()\n    mbs.SolveStatic()\n    # force over stiffness in each direction, measured from the fixed node\n    result = mbs.GetNodeOutput(node, exu.OutputVariableType.Position)\n\nPage: reference/items/nodes/point_ground.html\n"},
    {"node of spatial cable elements: position and axial slope vector", NodePointSlope1_rows, NodePointSlope1_outputs,
     "\nExample:\n    nodes = [mbs.AddNode(NodePointSlope1(referenceCoordinates=[0, y, 0, 0, 1, 0])) for y in (0, 2)]\n    mbs.AddObject(ObjectANCFCable(physicsLength=2, physicsMassPerLength=1, physicsBendingStiffness=10,\n                                  physicsAxialStiffness=500, nodeNumbers=nodes))\n    ground = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.AddNode(NodePointGround()), coordinate=0))\n    for coordinate in (0, 1, 2, 3, 5):\n        clamped = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=nodes[0], coordinate=coordinate))\n        mbs.AddObject(CoordinateConstraint(markerNumbers=[ground, clamped]))\n    tip = mbs.AddMarker(MarkerNodePosition(nodeNumber=nodes[1]))\n    mbs.AddLoad(Force(markerNumber=tip, loadVector=[0, 25, 0]))\n    mbs.Assemble()\n    mbs.SolveStatic()\n    # uniform strain 25/500 = 0.05: the slope [0, 1, 0] becomes [0, 1.05, 0], the tip moves by 0.05*2\n    result = mbs.GetNodeOutput(nodes[1], exu.OutputVariableType.CoordinatesTotal)\n\nPage: reference/items/nodes/point_slope1.html\n"},
    {"node of thin plate elements: position and the two slope vectors in the plane of the plate", NodePointSlope12_rows, NodePointSlope12_outputs,
     "\nExample:\n    # slopes of a plate that is turned by a right angle about z, stretched and sheared: the frame follows the first one\n    node = mbs.AddNode(NodePointSlope12(referenceCoordinates=[1, 0, 0, 0, 2, 0, -1, 0.5, 0]))\n    mbs.Assemble()\n    result = mbs.GetNodeOutput(node, exu.OutputVariableType.Rotation)\n\nPage: reference/items/nodes/point_slope12.html\n"},
    {"node of shear and cross-section deformable beam elements: position and the two slope vectors in the cross section", NodePointSlope23_rows, NodePointSlope23_outputs,
     "\nExample:\n    # a stiff beam, held by a joint at its first node and turned by an eighth of a turn about z\n    turn = np.pi/4\n    section = exu.BeamSection()\n    section.stiffnessMatrix = np.diag([1e3, 1e3, 1e3, 1e2, 1e2, 1e2])\n    nodes = [mbs.AddNode(NodePointSlope23(referenceCoordinates=[x, 0, 0, 0, 1, 0, 0, 0, 1])) for x in (0, 1)]\n    mbs.AddObject(ObjectANCFBeam(physicsLength=1, sectionData=section, nodeNumbers=nodes))\n    ground = mbs.AddMarker(MarkerBodyRigid(bodyNumber=mbs.AddObject(ObjectGround())))\n    turned = np.array([[np.cos(turn), -np.sin(turn), 0], [np.sin(turn), np.cos(turn), 0], [0, 0, 1]])\n    mbs.AddObject(GenericJoint(markerNumbers=[ground, mbs.AddMarker(MarkerNodeRigid(nodeNumber=nodes[0]))], rotationMarker0=turned))\n    mbs.Assemble()\n    mbs.SolveStatic()\n    result = mbs.GetNodeOutput(nodes[1], exu.OutputVariableType.Position)\n\nPage: reference/items/nodes/point_slope23.html\n"},
    {"node of a rigid body that moves in the global x-y plane: two displacements and the angle about z", NodeRigidBody2D_rows, NodeRigidBody2D_outputs,
     "\nCreated by: mbs.CreateRigidBody(...), mbs.CreateBox(...), mbs.CreateCylinder(...), mbs.CreateSphere(...)\n\nExample:\n    node = mbs.AddNode(NodeRigidBody2D(referenceCoordinates=[1, 2, 0.5], initialCoordinates=[0, 0, 0.25], initialVelocities=[3, -1, 2]))\n    mbs.AddObject(RigidBody2D(physicsMass=1, physicsInertia=0.2, nodeNumber=node))\n    mbs.Assemble()\n    mbs.SolveDynamic()\n    # free flight for one second: [1 + 3, 2 - 1] and the angle 0.5 + 0.25 + 2\n    result = mbs.GetNodeOutput(node, exu.OutputVariableType.CoordinatesTotal)\n\nPage: reference/items/nodes/rigid_body_2d.html\n"},
    {"node of a rigid body in space: three displacements and four Euler parameters (unit quaternion)", NodeRigidBodyEP_rows, NodeRigidBodyEP_outputs,
     "\nCreated by: mbs.CreateRigidBody(...), mbs.CreateBox(...), mbs.CreateCylinder(...), mbs.CreateSphere(...)\n\nExample:\n    omega = 0.5*np.pi    # about the global z-axis\n    node = mbs.AddNode(NodeRigidBodyEP(referenceCoordinates=[0, 0, 0, 1, 0, 0, 0],\n                                       initialVelocities=[1, 0, 0, 0, 0, 0, 0.5*omega]))\n    mbs.AddObject(RigidBody(physicsMass=2, physicsInertia=[0.1, 0.2, 0.3, 0, 0, 0], nodeNumber=node))\n    mbs.Assemble()\n    settings = exu.SimulationSettings()\n    settings.timeIntegration.numberOfSteps = 1000\n    mbs.SolveDynamic(settings)\n    # a quarter turn in one second: psi_0 = cos(pi/4), psi_3 = sin(pi/4)\n    result = mbs.GetNodeOutput(node, exu.OutputVariableType.CoordinatesTotal)\n\nPage: reference/items/nodes/rigid_body_ep.html\n"},
    {"node of a rigid body in space: three displacements and a rotation vector that is integrated by Lie group methods", NodeRigidBodyRotVecLG_rows, NodeRigidBodyRotVecLG_outputs,
     "\nCreated by: mbs.CreateRigidBody(...)\n\nExample:\n    node = mbs.AddNode(NodeRigidBodyRotVecLG(initialVelocities=[0, 0, 0, 1, 2, 2]))\n    mbs.AddObject(RigidBody(physicsMass=1, physicsInertia=[1, 1, 1, 0, 0, 0], nodeNumber=node))\n    mbs.Assemble()\n    mbs.SolveDynamic()\n    # a sphere keeps its angular velocity: rotation by 3 rad about the axis [1, 2, 2]/3 (Rodrigues' formula);\n    # first column of the rotation matrix\n    result = mbs.GetNodeOutput(node, exu.OutputVariableType.RotationMatrix)[0::3]\n\nPage: reference/items/nodes/rigid_body_rot_vec_lg.html\n"},
    {"node of a rigid body in space: three displacements and three Tait-Bryan angles about x, y and z in turn", NodeRigidBodyRxyz_rows, NodeRigidBodyRxyz_outputs,
     "\nCreated by: mbs.CreateRigidBody(...)\n\nExample:\n    node = mbs.AddNode(NodeRigidBodyRxyz(referenceCoordinates=[0, 0, 0, 0.5*np.pi, 0, 0]))\n    mbs.AddObject(RigidBody(physicsMass=1, physicsInertia=[4, 5, 6, 0, 0, 0], nodeNumber=node))\n    marker = mbs.AddMarker(MarkerNodeRigid(nodeNumber=node))\n    mbs.AddLoad(Torque(markerNumber=marker, loadVector=[2, 0, 0]))\n    mbs.Assemble()\n    mbs.SolveDynamic()\n    # constant angular acceleration 2/4 about x: the first angle grows by 0.25 in one second\n    result = mbs.GetNodeOutput(node, exu.OutputVariableType.Rotation)\n\nPage: reference/items/nodes/rigid_body_rxyz.html\n"},
    {"system of first order differential equations with a constant matrix, a constant vector and a user function", ObjectGenericODE1_rows, ObjectGenericODE1_outputs,
     "\nUser functions:\n    rhsUserFunction(mbs, t, itemNumber, q)\n        Returns a vector that is added to the right hand side. Called at every evaluation of the right hand side, and repeatedly for its derivatives in implicit solvers; it must depend on its arguments only.\n\nExample:\n    node = mbs.AddNode(NodeGenericODE1(referenceCoordinates=[0, 0], initialCoordinates=[0, 0], numberOfODE1Coordinates=2))\n    mbs.AddObject(ObjectGenericODE1(nodeNumbers=[node], systemMatrix=[[-1, 0], [1, -1]], rhsVector=[1, 0]))\n    mbs.Assemble()\n    mbs.SolveDynamic(solverType=exu.DynamicSolverType.RK44)\n    # step response of two equal lags in series: 1 - exp(-t) and 1 - (1 + t) exp(-t) at t = 1\n    result = mbs.GetNodeOutput(node, exu.OutputVariableType.Coordinates)\n\nPage: reference/items/bodies/generic_ode1.html\n"},
    {"body that does not move: the fixed end of joints, connectors and markers", ObjectGround_rows, ObjectGround_outputs,
     "\nUser functions:\n    graphicsDataUserFunction(mbs, itemNumber)\n        Returns the shapes of the item for one picture; called by the renderer, outside the solver, with the state that is drawn. Shapes are given in the ground frame. All data is copied at every call, so keep it small.\n\nCreated by: mbs.CreateGround(...)\n\nExample:\n    ground = mbs.AddObject(ObjectGround(referencePosition=[1, 0, 0], referenceRotation=[[0, -1, 0], [1, 0, 0], [0, 0, 1]]))\n    node = mbs.AddNode(NodePoint(referenceCoordinates=[1, 2, 0]))\n    mbs.AddObject(MassPoint(physicsMass=1, nodeNumber=node))\n    m_ground = mbs.AddMarker(MarkerBodyPosition(bodyNumber=ground, localPosition=[2, 0, 0]))\n    m_node = mbs.AddMarker(MarkerNodePosition(nodeNumber=node))\n    mbs.AddObject(CartesianSpringDamper(markerNumbers=[m_ground, m_node], stiffness=[100, 100, 100]))\n    mbs.AddLoad(Force(markerNumber=m_node, loadVector=[30, 0, 0]))\n    mbs.Assemble()\n    mbs.SolveStatic()\n    # the local x-axis points along the global y-axis: attached at [1, 2, 0]; the spring gives way by 30/100\n    result = mbs.GetNodeOutput(node, exu.OutputVariableType.Position)\n\nPage: reference/items/bodies/ground.html\n"},
    {"mass that is guided along a line: one translation along the local x-axis", ObjectMass1D_rows, ObjectMass1D_outputs,
     "\nExample:\n    slope = np.deg2rad(30)    # the local x-axis points downhill\n    downhill = [[np.cos(slope), np.sin(slope), 0], [-np.sin(slope), np.cos(slope), 0], [0, 0, 1]]\n    node = mbs.AddNode(Node1D())\n    body = mbs.AddObject(Mass1D(physicsMass=3, nodeNumber=node, referencePosition=[0, 5, 0], referenceRotation=downhill))\n    marker = mbs.AddMarker(MarkerBodyPosition(bodyNumber=body))\n    mbs.AddLoad(Force(markerNumber=marker, loadVector=[0, -30, 0]))\n    mbs.Assemble()\n    mbs.SolveDynamic()\n    # only the component along the slope acts: acceleration 10 sin(30 deg) = 5, way 2.5, height lost 1.25\n    result = mbs.GetObjectOutputBody(body, exu.OutputVariableType.Position, [0, 0, 0])\n\nPage: reference/items/bodies/mass_1d.html\n"},
    {"point mass in space on a node with position", ObjectMassPoint_rows, ObjectMassPoint_outputs,
     "\nCreated by: mbs.CreateMassPoint(...)\n\nExample:\n    node = mbs.AddNode(NodePoint(referenceCoordinates=[0, 0, 0], initialCoordinates=[1, 0, 0], initialVelocities=[0, 4, 0]))\n    body = mbs.AddObject(MassPoint(physicsMass=2, nodeNumber=node))\n    ground = mbs.AddMarker(MarkerBodyPosition(bodyNumber=mbs.AddObject(ObjectGround())))\n    marker = mbs.AddMarker(MarkerBodyPosition(bodyNumber=body))\n    mbs.AddObject(CartesianSpringDamper(markerNumbers=[ground, marker], stiffness=[8, 8, 8]))\n    mbs.Assemble()\n    settings = exu.SimulationSettings()\n    settings.timeIntegration.numberOfSteps = 1000\n    mbs.SolveDynamic(settings)\n    # angular frequency sqrt(8/2) = 2: the ellipse [cos(2 t), 2 sin(2 t)] at t = 1\n    result = mbs.GetObjectOutputBody(body, exu.OutputVariableType.Position, [0, 0, 0])\n\nPage: reference/items/bodies/mass_point.html\n"},
    {"point mass in the global x-y plane on a planar node", ObjectMassPoint2D_rows, ObjectMassPoint2D_outputs,
     "\nCreated by: mbs.CreateMassPoint(...)\n\nExample:\n    ground = mbs.AddObject(ObjectGround())\n    node = mbs.AddNode(NodePoint2D(referenceCoordinates=[2, 0], initialVelocities=[0, np.pi]))\n    body = mbs.AddObject(MassPoint2D(physicsMass=5, nodeNumber=node))\n    center = mbs.AddMarker(MarkerBodyPosition(bodyNumber=ground))\n    marker = mbs.AddMarker(MarkerBodyPosition(bodyNumber=body))\n    mbs.AddObject(DistanceConstraint(markerNumbers=[center, marker], distance=2))\n    mbs.Assemble()\n    settings = exu.SimulationSettings()\n    settings.timeIntegration.numberOfSteps = 1000\n    mbs.SolveDynamic(settings)\n    # uniform motion on a circle of radius 2 with the angular velocity pi/2: a quarter turn in one second\n    result = mbs.GetObjectOutputBody(body, exu.OutputVariableType.Position, [0, 0, 0])\n\nPage: reference/items/bodies/mass_point_2d.html\n"},
    {"rigid body in space with any center of mass, on a node with position and orientation", ObjectRigidBody_rows, ObjectRigidBody_outputs,
     "\nUser functions:\n    graphicsDataUserFunction(mbs, itemNumber)\n        Returns the shapes of the item for one picture; called by the renderer, outside the solver, with the state that is drawn. Shapes are given in the body frame. All data is copied at every call, so keep it small.\n\nCreated by: mbs.CreateRigidBody(...), mbs.CreateBox(...), mbs.CreateCylinder(...), mbs.CreateSphere(...)\n\nExample:\n    node = mbs.AddNode(NodeRigidBodyRotVecLG(initialVelocities=[0, -0.5*np.pi, 0, 0, 0, np.pi]))\n    body = mbs.AddObject(RigidBody(physicsMass=2, physicsInertia=[0.1, 0.6, 0.6, 0, 0, 0], physicsCenterOfMass=[0.5, 0, 0],\n                                   nodeNumber=node))\n    mbs.Assemble()\n    settings = exu.SimulationSettings()\n    settings.timeIntegration.numberOfSteps = 1000\n    mbs.SolveDynamic(settings)\n    # the center of mass stays at [0.5, 0, 0], the body makes half a turn about it: the reference point arrives at [1, 0, 0]\n    result = [*mbs.GetObjectOutputBody(body, exu.OutputVariableType.Position, [0, 0, 0]),\n              *mbs.GetObjectOutputBody(body, exu.OutputVariableType.Position, [0.5, 0, 0])]\n\nPage: reference/items/bodies/rigid_body.html\n"},
    {"rigid body that moves in the global x-y plane, with any center of mass", ObjectRigidBody2D_rows, ObjectRigidBody2D_outputs,
     "\nUser functions:\n    graphicsDataUserFunction(mbs, itemNumber)\n        Returns the shapes of the item for one picture; called by the renderer, outside the solver, with the state that is drawn. Shapes are given in the body frame. All data is copied at every call, so keep it small.\n\nCreated by: mbs.CreateRigidBody(...), mbs.CreateBox(...), mbs.CreateCylinder(...), mbs.CreateSphere(...)\n\nExample:\n    node = mbs.AddNode(NodeRigidBody2D(referenceCoordinates=[1, 1, 0]))\n    body = mbs.AddObject(RigidBody2D(physicsMass=2, physicsInertia=0.5, physicsCenterOfMass=[0.3, -0.1], nodeNumber=node))\n    marker = mbs.AddMarker(MarkerBodyPosition(bodyNumber=body, localPosition=[0.3, -0.1, 0]))\n    mbs.AddLoad(Force(markerNumber=marker, loadVector=[8, 4, 0]))\n    mbs.Assemble()\n    mbs.SolveDynamic()\n    # a force through the center of mass does not turn the body: translation with the accelerations 4 and 2 for one second\n    result = mbs.GetNodeOutput(node, exu.OutputVariableType.CoordinatesTotal)\n\nPage: reference/items/bodies/rigid_body_2d.html\n"},
    {"rotor about a fixed axis: one rotation about the local z-axis", ObjectRotationalMass1D_rows, ObjectRotationalMass1D_outputs,
     "\nExample:\n    about_x = [[0, 0, 1], [0, 1, 0], [-1, 0, 0]]    # the local z-axis, the axis of rotation, points along the global x-axis\n    node = mbs.AddNode(Node1D(initialVelocities=[1]))\n    body = mbs.AddObject(Rotor1D(physicsInertia=0.5, nodeNumber=node, referenceRotation=about_x))\n    marker = mbs.AddMarker(MarkerBodyRigid(bodyNumber=body))\n    mbs.AddLoad(Torque(markerNumber=marker, loadVector=[2, 7, 0]))\n    mbs.Assemble()\n    mbs.SolveDynamic()\n    # only the torque about the axis acts: angular acceleration 2/0.5 = 4; angle t + 4 t^2/2, angular velocity 1 + 4 t at t = 1\n    angle = mbs.GetNodeOutput(node, exu.OutputVariableType.Coordinates)\n    result = [float(angle), *mbs.GetObjectOutputBody(body, exu.OutputVariableType.AngularVelocity, [0, 0, 0])]\n\nPage: reference/items/bodies/rotational_mass_1d.html\n"},
    {"flexible body with the nodal coordinates of a finite element mesh in a floating frame of reference", ObjectFFRF_rows, ObjectFFRF_outputs,
     "\nUser functions:\n    forceUserFunction(mbs, t, itemNumber, q, q_t)\n        Returns generalized forces that are added to the right hand side. Called at every evaluation of the residual, and repeatedly for its derivatives; it must depend on its arguments only.\n    massMatrixUserFunction(mbs, t, itemNumber, q, q_t)\n        Returns a mass matrix for all coordinates of the object, including those of the body frame; it is added to the matrices that the object has itself.\n\nExample:\n    # four masses with springs to the middle, about which they turn with 5 rad/s: k x = m w^2 (1 + x)\n    m, w, k, x = 2., 5., 0., 0.1\n    k = m*w**2*(1 + x)/x\n    frame = mbs.AddNode(NodeRigidBodyRotVecLG(referenceCoordinates=[0]*6, initialVelocities=[0, 0, 0, 0, 0, w]))\n    places = np.array([[1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0]])\n    mesh = [mbs.AddNode(NodePoint(referenceCoordinates=p, initialCoordinates=x*p)) for p in places]\n    stiffness, mass = exu.MatrixContainer(), exu.MatrixContainer()\n    stiffness.SetWithDenseMatrix(np.diag([k]*12))\n    mass.SetWithDenseMatrix(np.diag([m]*12))\n    body = mbs.AddObject(ObjectFFRF(nodeNumbers=[frame, *mesh], massMatrixFF=mass, stiffnessMatrixFF=stiffness,\n                                    visualization=VObjectFFRF(triangleMesh=[[0, 1, 2], [0, 2, 3]])))\n    ground = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.AddNode(NodePointGround()), coordinate=0))\n    for node, fixed in ((frame, range(5)), *((node, (1 - k % 2, 2)) for k, node in enumerate(mesh))):\n        for coordinate in fixed:\n            mbs.AddObject(CoordinateConstraint(markerNumbers=[ground, mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=node, coordinate=coordinate))]))\n    mbs.Assemble()\n    settings = exu.SimulationSettings()\n    settings.timeIntegration.endTime = 0.4\n    settings.timeIntegration.numberOfSteps = 400\n    mbs.SolveDynamic(settings)\n    u = mbs.GetNodeOutput(mesh[0], exu.OutputVariableType.Coordinates)\n    # springs stay as long as they are; the frame has turned by 2 rad\n    turn = mbs.GetNodeOutput(frame, exu.OutputVariableType.RotationMatrix)\n    result = [u[0], -mbs.GetNodeOutput(mesh[2], exu.OutputVariableType.Coordinates)[0], np.arctan2(turn[3], turn[0]) - 2]\n\nPage: reference/items/super_elements/ffrf.html\n"},
    {"flexible body with modal coordinates in a floating frame of reference", ObjectFFRFreducedOrder_rows, ObjectFFRFreducedOrder_outputs,
     "\nUser functions:\n    forceUserFunction(mbs, t, itemNumber, q, q_t)\n        Returns generalized forces that are added to the right hand side. Called at every evaluation of the residual, and repeatedly for its derivatives; it must depend on its arguments only.\n    massMatrixUserFunction(mbs, t, itemNumber, q, q_t)\n        Returns a mass matrix for all coordinates of the object, including those of the body frame; it is added to the matrices that the object has itself.\n\nCreated by: mbs.CreateFFRFReducedOrderObject(...)\n\nExample:\n    # four masses of 1 kg on a circle breathe in one mode, in which they move outwards; as the circle spins, springs balance them\n    x = np.array([[1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0.]])\n    inertia = np.diag([2., 2, 4])\n    frame = mbs.AddNode(NodeRigidBodyEP(referenceCoordinates=[0, 0, 0, 1, 0, 0, 0], initialVelocities=[0, 0, 0, 0, 0, 0, 0.5]))\n    modes = mbs.AddNode(NodeGenericODE2(numberOfODE2Coordinates=1, referenceCoordinates=[0], initialCoordinates=[0.04],\n                                        initialCoordinates_t=[0]))\n    body = mbs.AddObject(ObjectFFRFreducedOrder(\n        nodeNumbers=[frame, modes], massMatrixReduced=[[4.]], stiffnessMatrixReduced=[[104.]], modeBasis=x.reshape(12, 1),\n        referencePositions=x.flatten(), physicsMass=4, physicsInertia=inertia,\n        mPhitTPsi=np.zeros((3, 1)), mXRefTildePsiTilde=inertia, mPsiTildePsiTilde=inertia,\n        visualization=VObjectFFRFreducedOrder(triangleMesh=[[0, 1, 2], [0, 2, 3]])))\n    mbs.Assemble()\n    settings = exu.SimulationSettings()\n    settings.timeIntegration.numberOfSteps = 1000\n    settings.timeIntegration.endTime = np.pi/2\n    mbs.SolveDynamic(settings)\n    # a quarter turn at 1 rad/s; 104 u = 4 (1 + u) omega^2\n    position = mbs.GetObjectOutputSuperElement(body, exu.OutputVariableType.Position, 0)\n    result = [position[0], position[1], mbs.GetNodeOutput(modes, exu.OutputVariableType.Coordinates)]\n\nPage: reference/items/super_elements/ffrf_reduced_order.html\n"},
    {"system of second order differential equations with constant matrices and user functions, on any nodes", ObjectGenericODE2_rows, ObjectGenericODE2_outputs,
     "\nUser functions:\n    forceUserFunction(mbs, t, itemNumber, q, q_t)\n        Returns generalized forces that are added to the right hand side, so that a restoring force is negative. Called at every evaluation of the residual, and repeatedly for its derivatives unless ``jacobianUserFunction`` is given; it must depend on its arguments only.\n    massMatrixUserFunction(mbs, t, itemNumber, q, q_t)\n        Returns the mass matrix at the given state, in place of ``massMatrix``. Velocity terms that follow from a changing mass matrix have to be given by ``forceUserFunction``.\n    jacobianUserFunction(mbs, t, itemNumber, q, q_t, fODE2, fODE2_t)\n        Returns the derivatives of the user part of the left hand side, -f_q ∂ f_user / ∂ q - f_q_t ∂ f_user / ∂ q_t; the constant stiffness and damping matrices are added by the object. Called whenever the solver computes its system matrix.\n    graphicsDataUserFunction(mbs, itemNumber)\n        Returns the shapes of the item for one picture; called by the renderer, outside the solver, with the state that is drawn. Shapes are given in the global frame. All data is copied at every call, so keep it small.\n\nExample:\n    m, k = 2., 72.\n    a, b = (mbs.AddNode(NodePoint(referenceCoordinates=[x, 0, 0], initialCoordinates=[u, 0, 0])) for x, u in ((1, 0.1), (2, -0.1)))\n    axial = np.diag([1., 0, 0])\n    mbs.AddObject(ObjectGenericODE2(nodeNumbers=[a, b], massMatrix=m*np.eye(6),\n                                    stiffnessMatrix=k*np.block([[2*axial, -axial], [-axial, 2*axial]])))\n    mbs.Assemble()\n    settings = exu.SimulationSettings()\n    settings.timeIntegration.numberOfSteps = 1000\n    settings.timeIntegration.endTime = 0.25\n    mbs.SolveDynamic(settings)\n    # wall-spring-mass-spring-mass-spring-wall in its antisymmetric mode: angular frequency sqrt(3 k/m), 0.1 cos(omega t)\n    result = [mbs.GetNodeOutput(n, exu.OutputVariableType.Displacement)[0] for n in (a, b)]\n\nPage: reference/items/super_elements/generic_ode2.html\n"},
    {"open tree of rigid bodies in minimal coordinates, one joint coordinate per link", ObjectKinematicTree_rows, ObjectKinematicTree_outputs,
     "\nUser functions:\n    forceUserFunction(mbs, t, itemNumber, q, q_t)\n        Returns joint forces and torques that are added to the right hand side. Called at every evaluation of the residual, and repeatedly for its derivatives; it must depend on its arguments only.\n\nCreated by: mbs.CreateKinematicTree(...), mbs.CreateRobot(...)\n\nExample:\n    # a rod of 1 m, released when it is level: it hangs down after K(1/2) / sqrt(3 g / (2 L)), K being the complete elliptic integral\n    g = 9.81\n    node = mbs.AddNode(NodeGenericODE2(referenceCoordinates=[0], initialCoordinates=[0], initialCoordinates_t=[0], numberOfODE2Coordinates=1))\n    mbs.AddObject(ObjectKinematicTree(nodeNumber=node, jointTypes=[exu.JointType.RevoluteZ], linkParents=[-1],\n                                      jointTransformations=exu.Matrix3DList([np.eye(3)]), jointOffsets=exu.Vector3DList([[0, 0, 0]]),\n                                      linkInertiasCOM=exu.Matrix3DList([np.diag([0, 1/12, 1/12])]), linkCOMs=exu.Vector3DList([[0.5, 0, 0]]),\n                                      linkMasses=[1], gravity=[0, -g, 0]))\n    mbs.Assemble()\n    settings = exu.SimulationSettings()\n    settings.timeIntegration.numberOfSteps = 200\n    settings.timeIntegration.endTime = 1.8540746773013719 / np.sqrt(1.5 * g)\n    mbs.SolveDynamic(settings, solverType=exu.DynamicSolverType.RK67)\n    result = [mbs.GetNodeOutput(node, variable) for variable in (exu.OutputVariableType.Coordinates, exu.OutputVariableType.Coordinates_t)]\n\nPage: reference/items/super_elements/kinematic_tree.html\n"},
    {"planar cable through which material moves along the axis, on two nodes with slope and one node with the axial coordinate", ObjectALEANCFCable2D_rows, ObjectALEANCFCable2D_outputs,
     "\nExample:\n    # a taut belt between fixed nodes, driven by a force along a slope of 30 degrees against its weight: s = 0.5 (F/m - g/2) t^2\n    L, mass, force, slope = 2., 1.5, 20., np.array([np.cos(np.pi/6), 0.5])\n    nodes = [mbs.AddNode(NodePoint2DSlope1(referenceCoordinates=[*(x*slope), *slope])) for x in (0, L)]\n    way = mbs.AddNode(NodeGenericODE2(numberOfODE2Coordinates=1, referenceCoordinates=[0], initialCoordinates=[0], initialCoordinates_t=[0]))\n    belt = mbs.AddObject(ALECable2D(physicsLength=L, physicsMassPerLength=mass/L, physicsBendingStiffness=5, physicsAxialStiffness=1e3, nodeNumbers=[*nodes, way]))\n    ground = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.AddNode(NodePointGround()), coordinate=0))\n    for node in nodes:\n        for coordinate in range(4):\n            fixed = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=node, coordinate=coordinate))\n            mbs.AddObject(CoordinateConstraint(markerNumbers=[ground, fixed]))\n    mbs.AddLoad(LoadMassProportional(markerNumber=mbs.AddMarker(MarkerBodyMass(bodyNumber=belt)), loadVector=[0, -10, 0]))\n    mbs.AddLoad(LoadCoordinate(markerNumber=mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=way, coordinate=0)), load=force))\n    mbs.Assemble()\n    settings = exu.SimulationSettings()\n    settings.timeIntegration.endTime = 0.3\n    settings.timeIntegration.numberOfSteps = 30\n    mbs.SolveDynamic(settings)\n    s, s_t = mbs.GetNodeOutput(way, exu.OutputVariableType.Coordinates), mbs.GetNodeOutput(way, exu.OutputVariableType.Coordinates_t)\n    a = force/mass - 5\n    result = [s/(a*0.3**2), s_t/(a*0.3) + 0.75]\n\nPage: reference/items/finite_elements/ale_ancf_cable_2d.html\n"},
    {"spatial beam with shear and cross section deformation, on two nodes with position and two slopes", ObjectANCFBeam_rows, ObjectANCFBeam_outputs,
     "\nExample:\n    L, EI, elements = 2., 5., 16\n    section = exu.BeamSection()\n    section.stiffnessMatrix = np.diag([1e4, 5e3, 5e3, 4, EI, EI])\n    section.massPerLength = 1\n    section.inertia = 1e-3*np.eye(3)\n    nodes = [mbs.AddNode(NodePointSlope23(referenceCoordinates=[x, 0, 0, 0, 1, 0, 0, 0, 1])) for x in np.linspace(0, L, elements + 1)]\n    for pair in zip(nodes[:-1], nodes[1:]):\n        mbs.AddObject(ObjectANCFBeam(physicsLength=L/elements, sectionData=section, nodeNumbers=list(pair)))\n    ground = mbs.AddMarker(MarkerBodyRigid(bodyNumber=mbs.AddObject(ObjectGround())))\n    mbs.AddObject(GenericJoint(markerNumbers=[ground, mbs.AddMarker(MarkerNodeRigid(nodeNumber=nodes[0]))]))\n    mbs.AddLoad(Torque(markerNumber=mbs.AddMarker(MarkerNodeRigid(nodeNumber=nodes[-1])), loadVector=[0, 0, 0.5*np.pi*EI/L]))\n    mbs.Assemble()\n    settings = exu.SimulationSettings()\n    settings.staticSolver.numberOfLoadSteps = 4\n    mbs.SolveStatic(settings)\n    # pure bending into a quarter of a circle of radius 2 L/pi: the tip is at [2 L/pi, 2 L/pi]\n    result = mbs.GetNodeOutput(nodes[-1], exu.OutputVariableType.Position)\n\nPage: reference/items/finite_elements/ancf_beam.html\n"},
    {"spatial cable or thin beam without torsion and shear deformation, on two nodes with position and slope", ObjectANCFCable_rows, ObjectANCFCable_outputs,
     "\nCreated by: mbs.CreateCable(...)\n\nExample:\n    L, EI, elements = 2., 5., 4\n    nodes = [mbs.AddNode(NodePointSlope1(referenceCoordinates=[x, 0, 0, 1, 0, 0])) for x in np.linspace(0, L, elements + 1)]\n    for pair in zip(nodes[:-1], nodes[1:]):\n        mbs.AddObject(ObjectANCFCable(physicsLength=L/elements, physicsMassPerLength=1, physicsBendingStiffness=EI,\n                                      physicsAxialStiffness=1e4, nodeNumbers=list(pair)))\n    ground = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.AddNode(NodePointGround()), coordinate=0))\n    for coordinate in (0, 1, 2, 4, 5):\n        clamped = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=nodes[0], coordinate=coordinate))\n        mbs.AddObject(CoordinateConstraint(markerNumbers=[ground, clamped]))\n    tip = mbs.AddMarker(MarkerNodePosition(nodeNumber=nodes[-1]))\n    force = np.array([0, 6e-4, 8e-4])\n    mbs.AddLoad(Force(markerNumber=tip, loadVector=force))\n    mbs.Assemble()\n    mbs.SolveStatic()\n    # a small deflection: w = force L^3/(3 EI) in its direction, and 3 w^2/(5 L) shorter along the axis\n    result = mbs.GetNodeOutput(nodes[-1], exu.OutputVariableType.Displacement)\n\nPage: reference/items/finite_elements/ancf_cable.html\n"},
    {"planar cable or thin beam without shear deformation for large deformation, on two nodes with position and slope", ObjectANCFCable2D_rows, ObjectANCFCable2D_outputs,
     "\nUser functions:\n    axialForceUserFunction(mbs, t, itemNumber, axialPositionNormalized, axialStrain, axialStrain_t, axialStrainRef, physicsAxialStiffness, physicsAxialDamping, curvature, curvature_t, curvatureRef)\n        Returns the axial force at one integration point, in place of stiffness and damping. Called at every integration point and evaluation of the elastic forces, and for their derivatives. The order of the arguments differs from that of ``bendingMomentUserFunction``.\n    bendingMomentUserFunction(mbs, t, itemNumber, axialPositionNormalized, curvature, curvature_t, curvatureRef, physicsBendingStiffness, physicsBendingDamping, axialStrain, axialStrain_t, axialStrainRef)\n        Returns the bending moment at one integration point, in place of stiffness and damping. Called at every integration point and evaluation of the elastic forces, and for their derivatives. The order of the arguments differs from that of ``axialForceUserFunction``.\n\nExample:\n    L, EI, elements = 2., 5., 8\n    nodes = [mbs.AddNode(NodePoint2DSlope1(referenceCoordinates=[x, 0, 1, 0])) for x in np.linspace(0, L, elements + 1)]\n    cables = [mbs.AddObject(Cable2D(physicsLength=L/elements, physicsMassPerLength=1, physicsBendingStiffness=EI,\n                                    physicsAxialStiffness=1e4, nodeNumbers=list(pair))) for pair in zip(nodes[:-1], nodes[1:])]\n    ground = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.AddNode(NodePointGround()), coordinate=0))\n    for coordinate in (0, 1, 3):\n        clamped = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=nodes[0], coordinate=coordinate))\n        mbs.AddObject(CoordinateConstraint(markerNumbers=[ground, clamped]))\n    tip = mbs.AddMarker(MarkerBodyRigid(bodyNumber=cables[-1], localPosition=[L/elements, 0, 0]))\n    mbs.AddLoad(Torque(markerNumber=tip, loadVector=[0, 0, 0.5*np.pi*EI/L]))\n    mbs.Assemble()\n    settings = exu.SimulationSettings()\n    settings.staticSolver.numberOfLoadSteps = 4\n    mbs.SolveStatic(settings)\n    # pure bending into a quarter of a circle of radius 2 L/pi: the tip is at [2 L/pi, 2 L/pi]\n    result = mbs.GetNodeOutput(nodes[-1], exu.OutputVariableType.Position)\n\nPage: reference/items/finite_elements/ancf_cable_2d.html\n"},
    {"thin plate without shear deformation, on four nodes with position and two slopes", ObjectANCFThinPlate_rows, ObjectANCFThinPlate_outputs,
     "\nExample:\n    # a cantilevered strip that bends like a beam, as its Poisson ratio is 0: w = F L^3 / (3 EI)\n    L, b, h, E, elements = 1., 0.2, 0.01, 1e9, 4\n    stretch = E*h*np.diag([1, 1, 0.5])\n    nodes = [[mbs.AddNode(NodePointSlope12(referenceCoordinates=[x, y, 0, 1, 0, 0, 0, 1, 0])) for y in (0, b)] for x in np.linspace(0, L, elements + 1)]\n    for (n0, n3), (n1, n2) in zip(nodes[:-1], nodes[1:]):\n        mbs.AddObject(ObjectANCFThinPlate(physicsThickness=[h], physicsDensity=1000, physicsStrainCoefficients=[stretch],\n                                          physicsCurvatureCoefficients=[h**2/12*stretch], nodeNumbers=[n0, n1, n2, n3]))\n    ground = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.AddNode(NodePointGround()), coordinate=0))\n    for node in nodes[0]:\n        for coordinate in range(9):\n            clamped = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=node, coordinate=coordinate))\n            mbs.AddObject(CoordinateConstraint(markerNumbers=[ground, clamped]))\n    for node in nodes[-1]:\n        mbs.AddLoad(Force(markerNumber=mbs.AddMarker(MarkerNodePosition(nodeNumber=node)), loadVector=[0, 0, 0.5*0.005*3*E*b*h**3/12/L**3]))\n    mbs.Assemble()\n    mbs.SolveStatic()\n    result = mbs.GetNodeOutput(nodes[-1][0], exu.OutputVariableType.Displacement)[2]\n\nPage: reference/items/finite_elements/ancf_thin_plate.html\n"},
    {"spatial geometrically exact beam with shear deformation, on two rigid body nodes", ObjectBeamGeometricallyExact_rows, ObjectBeamGeometricallyExact_outputs,
     "\nCreated by: mbs.CreateBeam(...)\n\nExample:\n    L, EI, elements = 2., 5., 4\n    section = exu.BeamSection()\n    section.stiffnessMatrix = np.diag([1e4, 5e3, 5e3, 4, EI, EI])\n    section.massPerLength = 1\n    section.inertia = 1e-3*np.eye(3)\n    nodes = [mbs.AddNode(NodeRigidBodyRotVecLG(referenceCoordinates=[x, 0, 0, 0, 0, 0])) for x in np.linspace(0, L, elements + 1)]\n    for pair in zip(nodes[:-1], nodes[1:]):\n        mbs.AddObject(ObjectBeamGeometricallyExact(physicsLength=L/elements, sectionData=section, nodeNumbers=list(pair)))\n    ground = mbs.AddMarker(MarkerBodyRigid(bodyNumber=mbs.AddObject(ObjectGround())))\n    mbs.AddObject(GenericJoint(markerNumbers=[ground, mbs.AddMarker(MarkerNodeRigid(nodeNumber=nodes[0]))]))\n    mbs.AddLoad(Torque(markerNumber=mbs.AddMarker(MarkerNodeRigid(nodeNumber=nodes[-1])), loadVector=[0, 0, 0.5*np.pi*EI/L]))\n    mbs.Assemble()\n    settings = exu.SimulationSettings()\n    settings.staticSolver.numberOfLoadSteps = 4\n    mbs.SolveStatic(settings)\n    # pure bending into a quarter of a circle of radius 2 L/pi: the tip is at [2 L/pi, 2 L/pi]\n    result = mbs.GetNodeOutput(nodes[-1], exu.OutputVariableType.Position)\n\nPage: reference/items/finite_elements/beam_geometrically_exact.html\n"},
    {"planar geometrically exact beam with shear deformation, on two or three rigid body nodes", ObjectBeamGeometricallyExact2D_rows, ObjectBeamGeometricallyExact2D_outputs,
     "\nExample:\n    L, EI, elements = 2., 5., 8\n    nodes = [mbs.AddNode(NodeRigidBody2D(referenceCoordinates=[x, 0, 0])) for x in np.linspace(0, L, 2*elements + 1)]\n    for i in range(0, 2*elements, 2):\n        mbs.AddObject(Beam2D(nodeNumbers=nodes[i:i + 3], physicsLength=L/elements, physicsMassPerLength=1, physicsCrossSectionInertia=1e-3,\n                             physicsBendingStiffness=EI, physicsAxialStiffness=1e4, physicsShearStiffness=5e3))\n    ground = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.AddNode(NodePointGround()), coordinate=0))\n    for coordinate in range(3):\n        clamped = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=nodes[0], coordinate=coordinate))\n        mbs.AddObject(CoordinateConstraint(markerNumbers=[ground, clamped]))\n    mbs.AddLoad(Torque(markerNumber=mbs.AddMarker(MarkerNodeRigid(nodeNumber=nodes[-1])), loadVector=[0, 0, 0.5*np.pi*EI/L]))\n    mbs.Assemble()\n    settings = exu.SimulationSettings()\n    settings.staticSolver.numberOfLoadSteps = 4\n    mbs.SolveStatic(settings)\n    # pure bending into a quarter of a circle of radius 2 L/pi: the tip is at [2 L/pi, 2 L/pi]\n    result = mbs.GetNodeOutput(nodes[-1], exu.OutputVariableType.Position)\n\nPage: reference/items/finite_elements/beam_geometrically_exact_2d.html\n"},
    {"Three springs and dampers that act between two points in the directions of the global axes", ObjectConnectorCartesianSpringDamper_rows, ObjectConnectorCartesianSpringDamper_outputs,
     "\nUser functions:\n    springForceUserFunction(mbs, t, itemNumber, displacement, velocity, stiffness, damping, offset)\n        computes the global force vector between the markers and replaces stiffness and damping; called at every evaluation of the residual and for its derivatives\n\nCreated by: mbs.CreateCartesianSpringDamper(...)\n\nExample:\n    # linear and uncoupled: displacement = offset + force / stiffness\n    ground = mbs.AddObject(ObjectGround())\n    node = mbs.AddNode(NodePoint())\n    mbs.AddObject(MassPoint(physicsMass=1, nodeNumber=node))\n    mGround = mbs.AddMarker(MarkerBodyPosition(bodyNumber=ground))\n    mBody = mbs.AddMarker(MarkerNodePosition(nodeNumber=node))\n    mbs.AddObject(CartesianSpringDamper(markerNumbers=[mGround, mBody], stiffness=[100, 200, 400], offset=[0.1, 0, 0]))\n    mbs.AddLoad(Force(markerNumber=mBody, loadVector=[10, -20, 40]))\n    mbs.Assemble()\n    mbs.SolveStatic()\n    result = mbs.GetNodeOutput(node, exu.OutputVariableType.Displacement)\n\nPage: reference/items/connectors/cartesian_spring_damper.html\n"},
    {"A scalar spring and damper between two coordinates", ObjectConnectorCoordinateSpringDamper_rows, ObjectConnectorCoordinateSpringDamper_outputs,
     "\nUser functions:\n    springForceUserFunction(mbs, t, itemNumber, displacement, velocity, stiffness, damping, offset)\n        computes the scalar force and replaces stiffness, damping and offset; called at every evaluation of the residual and for its derivatives\n\nExample:\n    # critically damped oscillator: q(t) = (1 + 2 t) exp(-2 t) for k = 4, d = 4, m = 1; second order method, step 0.001\n    ground = mbs.AddNode(NodePointGround())\n    node = mbs.AddNode(Node1D(initialCoordinates=[1]))\n    mbs.AddObject(Mass1D(physicsMass=1, nodeNumber=node))\n    mGround = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=ground, coordinate=0))\n    mNode = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=node, coordinate=0))\n    mbs.AddObject(CoordinateSpringDamper(markerNumbers=[mGround, mNode], stiffness=4, damping=4))\n    mbs.Assemble()\n    settings = exu.SimulationSettings()\n    settings.timeIntegration.numberOfSteps = 1000\n    mbs.SolveDynamic(settings)\n    result = mbs.GetNodeOutput(node, exu.OutputVariableType.Coordinates)\n\nPage: reference/items/connectors/coordinate_spring_damper.html\n"},
    {"A scalar spring and damper between two coordinates, with gear factors, friction and limit stops", ObjectConnectorCoordinateSpringDamperExt_rows, ObjectConnectorCoordinateSpringDamperExt_outputs,
     "\nUser functions:\n    springForceUserFunction(mbs, t, itemNumber, displacement, velocity, stiffness, damping, offset, velocityOffset, fDynamicFriction, fStaticFrictionOffset, exponentialDecayStatic, fViscousFriction, frictionProportionalZone)\n        computes the total scalar force and replaces all laws of the item; parameters that are not passed are obtained with ``mbs.GetObjectParameter(itemNumber, ...)``; called at every evaluation of the residual and for its derivatives\n\nExample:\n    # a block of mass 1 slides with 2 m/s against dry friction of 1 N: q(1) = 2 - 1/2; always beyond the proportional zone\n    ground = mbs.AddNode(NodePointGround())\n    node = mbs.AddNode(Node1D(initialVelocities=[2]))\n    mbs.AddObject(Mass1D(physicsMass=1, nodeNumber=node))\n    mGround = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=ground, coordinate=0))\n    mNode = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=node, coordinate=0))\n    mbs.AddObject(CoordinateSpringDamperExt(markerNumbers=[mGround, mNode], fDynamicFriction=1,\n                                            frictionProportionalZone=1e-3))\n    mbs.Assemble()\n    mbs.SolveDynamic()\n    result = mbs.GetNodeOutput(node, exu.OutputVariableType.Coordinates)\n\nPage: reference/items/connectors/coordinate_spring_damper_ext.html\n"},
    {"Newtonian gravitation between two masses, for celestial bodies and satellites; the weight on earth is LoadMassProportional", ObjectConnectorGravity_rows, ObjectConnectorGravity_outputs,
     "\nExample:\n    # a circular orbit of radius 1 about a fixed mass: angular velocity 1, after one second at (cos 1, sin 1)\n    node = mbs.AddNode(NodePoint(referenceCoordinates=[1, 0, 0], initialVelocities=[0, 1, 0]))\n    body = mbs.AddObject(MassPoint(physicsMass=1, nodeNumber=node))\n    m0 = mbs.AddMarker(MarkerBodyPosition(bodyNumber=mbs.AddObject(ObjectGround())))\n    m1 = mbs.AddMarker(MarkerNodePosition(nodeNumber=node))\n    mbs.AddObject(ConnectorGravity(markerNumbers=[m0, m1], gravitationalConstant=1, mass0=1, mass1=1))\n    mbs.Assemble()\n    mbs.SolveDynamic(solverType=exu.DynamicSolverType.RK44)\n    result = mbs.GetNodeOutput(node, exu.OutputVariableType.Position)\n\nPage: reference/items/connectors/gravity.html\n"},
    {"A double-acting hydraulic cylinder between two points, with the build-up of pressure in both chambers", ObjectConnectorHydraulicActuatorSimple_rows, ObjectConnectorHydraulicActuatorSimple_outputs,
     "\nCreated by: mbs.CreateHydraulicCylinder(...)\n\nExample:\n    # one chamber of a locked actuator fills: the root of the pressure difference falls from 10 by 5 per second\n    node = mbs.AddNode(NodeGenericODE1(referenceCoordinates=[0, 0], initialCoordinates=[0, 0], numberOfODE1Coordinates=2))\n    ground = mbs.AddObject(ObjectGround())\n    m0 = mbs.AddMarker(MarkerBodyPosition(bodyNumber=ground))\n    m1 = mbs.AddMarker(MarkerBodyPosition(bodyNumber=ground, localPosition=[1, 0, 0]))\n    actuator = mbs.AddObject(HydraulicActuatorSimple(markerNumbers=[m0, m1], nodeNumbers=[node], offsetLength=0.8, strokeLength=0.5,\n                                                     chamberCrossSection0=0.01, chamberCrossSection1=0.01, hoseVolume0=1, hoseVolume1=1,\n                                                     valveOpening0=1, oilBulkModulus=10, nominalFlow=1, systemPressure=100))\n    mbs.Assemble()\n    mbs.SolveDynamic(solverType=exu.DynamicSolverType.RK44)\n    result = [mbs.GetNodeOutput(node, exu.OutputVariableType.Coordinates)[0],\n              mbs.GetObjectOutput(actuator, exu.OutputVariableType.Force)[0]]\n\nPage: reference/items/connectors/hydraulic_actuator_simple.html\n"},
    {"Force law between two markers with states of its own, given by user functions", ObjectConnectorLaw_rows, ObjectConnectorLaw_outputs,
     "\nUser functions:\n    forceUserFunction(mbs, t, itemNumber, u, v, states)\n        computes the force on marker m0; marker m1 gets the opposite force\n    stateRateUserFunction(mbs, t, itemNumber, u, v, states)\n        computes the rates of the first-order coordinates\n    historyUserFunction(mbs, t, itemNumber, u, v, states)\n        computes the data coordinates at the end of a step; called when a step has converged\n\nCreated by: mbs.CreatePIDController(...)\n\nExample:\n    # relaxation of a Maxwell element that is held at an elongation of 1: spring 100 N/m, damper 100 Ns/m, after 1 s\n    def force(mbs, t, itemNumber, u, v, states):\n        return [100 * (u[0] - states[0])]\n\n    def rate(mbs, t, itemNumber, u, v, states):\n        return [u[0] - states[0]]\n\n    nodes = [mbs.AddNode(NodePointGround()), mbs.AddNode(Node1D(referenceCoordinates=[0], initialCoordinates=[1]))]\n    mbs.AddObject(Mass1D(nodeNumber=nodes[1], physicsMass=1))\n    markers = [mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=n, coordinate=0)) for n in nodes]\n    dashpot = mbs.AddNode(NodeGenericODE1(referenceCoordinates=[0], initialCoordinates=[0], numberOfODE1Coordinates=1))\n    law = mbs.AddObject(ConnectorLaw(markerNumbers=markers, nodeNumbers=[dashpot], numberOfCoordinates=1,\n                                     forceUserFunction=force, stateRateUserFunction=rate))\n    held = mbs.AddObject(CoordinateConstraint(markerNumbers=markers, offset=1))\n    mbs.Assemble()\n    settings = exu.SimulationSettings()\n    settings.timeIntegration.numberOfSteps = 2000\n    mbs.SolveDynamic(settings)\n    elongation = mbs.GetNodeOutput(dashpot, exu.OutputVariableType.Coordinates)\n    result = [1 - elongation, mbs.GetObjectOutput(law, exu.OutputVariableType.Force)]\n\nPage: reference/items/connectors/law.html\n"},
    {"A spring and damper along an axis that is fixed to the first marker, as in a prismatic joint", ObjectConnectorLinearSpringDamper_rows, ObjectConnectorLinearSpringDamper_outputs,
     "\nUser functions:\n    springForceUserFunction(mbs, t, itemNumber, displacement, velocity, stiffness, damping, offset)\n        computes the scalar force along the axis and replaces stiffness, damping, offsets and constant force; called at every evaluation of the residual and for its derivatives\n\nCreated by: mbs.CreateLinearSpringDamper(...)\n\nExample:\n    # a body on a prismatic joint along x, pushed with 5 N against a spring of 10 N/m\n    node = mbs.AddNode(NodeRigidBody2D())\n    body = mbs.AddObject(RigidBody2D(physicsMass=1, physicsInertia=1, nodeNumber=node))\n    m0 = mbs.AddMarker(MarkerBodyRigid(bodyNumber=mbs.AddObject(ObjectGround())))\n    m1 = mbs.AddMarker(MarkerBodyRigid(bodyNumber=body))\n    mbs.AddObject(PrismaticJoint2D(markerNumbers=[m0, m1]))\n    spring = mbs.AddObject(LinearSpringDamper(markerNumbers=[m0, m1], stiffness=10))\n    mbs.AddLoad(Force(markerNumber=m1, loadVector=[5, 0, 0]))\n    mbs.Assemble()\n    mbs.SolveStatic()\n    result = [mbs.GetObjectOutput(spring, exu.OutputVariableType.DisplacementLocal),\n              mbs.GetObjectOutput(spring, exu.OutputVariableType.ForceLocal)]\n\nPage: reference/items/connectors/linear_spring_damper.html\n"},
    {"A massless elastic rope that runs without friction over sheaves and joins two end points", ObjectConnectorReevingSystemSprings_rows, ObjectConnectorReevingSystemSprings_outputs,
     "\nCreated by: mbs.CreateRope(...), mbs.CreateBelt(...)\n\nExample:\n    # a rope over a sheave of radius 0.5 m, with two spans of 2 m, stretched by pi/2 + 4 - 5 from 5 m\n    ground = mbs.AddObject(ObjectGround())\n    points = [[-0.5, 0, 0], [0, 2, 0], [0.5, 0, 0]]\n    markers = [mbs.AddMarker(MarkerBodyRigid(bodyNumber=ground, localPosition=p)) for p in points]\n    rope = mbs.AddObject(ReevingSystemSprings(markerNumbers=markers, stiffnessPerLength=100, referenceLength=5,\n                                              sheavesAxes=exu.Vector3DList([[0, 0, -1]] * 3), sheavesRadii=[0, 0.5, 0]))\n    mbs.Assemble()\n    result = [mbs.GetObjectOutput(rope, exu.OutputVariableType.Distance), mbs.GetObjectOutput(rope, exu.OutputVariableType.ForceLocal)]\n\nPage: reference/items/connectors/reeving_system_springs.html\n"},
    {"A spring and damper with six components, against relative translation and rotation of two rigid body markers", ObjectConnectorRigidBodySpringDamper_rows, ObjectConnectorRigidBodySpringDamper_outputs,
     "\nUser functions:\n    springForceTorqueUserFunction(mbs, t, itemNumber, displacement, rotation, velocity, angularVelocity, stiffness, damping, rotJ0, rotJ1, offset)\n        computes force and torque in frame J0 (in the mid-frame with ``intrinsicFormulation``) and replaces stiffness, damping and offset; called at every evaluation of the residual and for its derivatives\n    postNewtonStepUserFunction(mbs, t, itemNumber, dataCoordinates, displacement, rotation, velocity, angularVelocity, stiffness, damping, rotJ0, rotJ1, offset)\n        switches states of contact, friction or plasticity: called after the Newton iteration, returns the new data coordinates and the error that the switch caused; the step is repeated as long as that error exceeds the tolerance of the discontinuous iteration\n\nCreated by: mbs.CreateRigidBodySpringDamper(...)\n\nExample:\n    # linear translations, and a large rotation about a single axis: displacement = force / stiffness\n    ground = mbs.AddObject(ObjectGround())\n    node = mbs.AddNode(NodeRigidBodyRxyz())\n    body = mbs.AddObject(RigidBody(physicsMass=1, physicsInertia=[1, 1, 1, 0, 0, 0], nodeNumber=node))\n    mGround = mbs.AddMarker(MarkerBodyRigid(bodyNumber=ground))\n    mBody = mbs.AddMarker(MarkerBodyRigid(bodyNumber=body))\n    spring = mbs.AddObject(RigidBodySpringDamper(markerNumbers=[mGround, mBody],\n                                                 stiffness=np.diag([100, 200, 300, 5, 5, 5])))\n    mbs.AddLoad(Force(markerNumber=mBody, loadVector=[1, -4, 9]))\n    mbs.AddLoad(Torque(markerNumber=mBody, loadVector=[0, 0, 2]))\n    mbs.Assemble()\n    mbs.SolveStatic()\n    result = np.hstack([mbs.GetObjectOutput(spring, exu.OutputVariableType.DisplacementLocal),\n                        mbs.GetObjectOutput(spring, exu.OutputVariableType.Rotation)])\n\nPage: reference/items/connectors/rigid_body_spring_damper.html\n"},
    {"A disc that rolls or slides with friction on a plane, with elastic contact instead of constraints", ObjectConnectorRollingDiscPenalty_rows, ObjectConnectorRollingDiscPenalty_outputs,
     "\nCreated by: mbs.CreateRollingDiscPenalty(...)\n\nExample:\n    # a homogeneous disc of radius 0.5 m that slides at 5 m/s: friction 0.2 m g slows it down with 2 m/s^2 and spins it up with\n    # 8 rad/s^2; it still slides after half a second\n    weight = 20\n    node = mbs.AddNode(NodeRigidBodyRxyz(referenceCoordinates=[0, 0, 0.5 - weight / 1e5, 0, 0, 0], initialVelocities=[0, 5, 0, 0, 0, 0]))\n    body = mbs.AddObject(RigidBody(physicsMass=2, physicsInertia=[0.25, 0.125, 0.125, 0, 0, 0], nodeNumber=node))\n    m0 = mbs.AddMarker(MarkerBodyRigid(bodyNumber=mbs.AddObject(ObjectGround())))\n    m1 = mbs.AddMarker(MarkerBodyRigid(bodyNumber=body))\n    data = mbs.AddNode(NodeGenericData(numberOfDataCoordinates=3, initialCoordinates=[0, -5, -weight / 1e5]))\n    disc = mbs.AddObject(RollingDiscPenalty(markerNumbers=[m0, m1], nodeNumber=data, discRadius=0.5, contactStiffness=1e5,\n                                            dryFriction=[0.2, 0.2], dryFrictionProportionalZone=0.01))\n    mbs.AddLoad(Force(markerNumber=m1, loadVector=[0, 0, -weight]))\n    mbs.Assemble()\n    simulationSettings = exu.SimulationSettings()\n    simulationSettings.timeIntegration.endTime = 0.5\n    mbs.SolveDynamic(simulationSettings)\n    result = [mbs.GetNodeOutput(node, exu.OutputVariableType.Position)[1],\n              mbs.GetNodeOutput(node, exu.OutputVariableType.AngularVelocity)[0],\n              mbs.GetObjectOutput(disc, exu.OutputVariableType.ForceLocal)[1]]\n\nPage: reference/items/connectors/rolling_disc_penalty.html\n"},
    {"A spring and a damper that act along the line between two points", ObjectConnectorSpringDamper_rows, ObjectConnectorSpringDamper_outputs,
     "\nUser functions:\n    springForceUserFunction(mbs, t, itemNumber, deltaL, deltaL_t, stiffness, damping, force)\n        computes the scalar force between the markers and replaces stiffness, damping and constant force; called at every evaluation of the residual, several times per step, and for its derivatives\n\nCreated by: mbs.CreateSpringDamper(...)\n\nExample:\n    # a weight in the middle of two springs: geometrically nonlinear, in balance at (0, -4) with both springs of length 5\n    ground = mbs.AddObject(ObjectGround())\n    node = mbs.AddNode(NodePoint(referenceCoordinates=[0, -3, 0]))\n    body = mbs.AddObject(MassPoint(physicsMass=1, nodeNumber=node))\n    mBody = mbs.AddMarker(MarkerNodePosition(nodeNumber=node))\n    for x in (-3, 3):\n        mGround = mbs.AddMarker(MarkerBodyPosition(bodyNumber=ground, localPosition=[x, 0, 0]))\n        mbs.AddObject(SpringDamper(markerNumbers=[mGround, mBody], referenceLength=4, stiffness=100))\n    mbs.AddLoad(Force(markerNumber=mBody, loadVector=[0, -160, 0]))  # 2 * 100 * (5 - 4) * 4/5\n    mbs.Assemble()\n    mbs.SolveStatic()\n    result = mbs.GetNodeOutput(node, exu.OutputVariableType.Position)\n\nPage: reference/items/connectors/spring_damper.html\n"},
    {"A torsional spring and damper about the z axis of a joint frame", ObjectConnectorTorsionalSpringDamper_rows, ObjectConnectorTorsionalSpringDamper_outputs,
     "\nUser functions:\n    springTorqueUserFunction(mbs, t, itemNumber, rotation, angularVelocity, stiffness, damping, offset)\n        computes the scalar torque and replaces stiffness, damping, offsets and constant torque; called at every evaluation of the residual and for its derivatives\n\nCreated by: mbs.CreateTorsionalSpringDamper(...), mbs.CreateMotor(...), mbs.CreateJointStops(...)\n\nExample:\n    # torsional oscillator: theta(t) = 0.5 cos(2 t) for k = 2, J = 0.5; second order method, step 0.001\n    ground = mbs.AddObject(ObjectGround())\n    node = mbs.AddNode(NodeRigidBody2D(initialCoordinates=[0, 0, 0.5]))\n    body = mbs.AddObject(RigidBody2D(physicsMass=1, physicsInertia=0.5, nodeNumber=node))\n    mGround = mbs.AddMarker(MarkerBodyRigid(bodyNumber=ground))\n    mBody = mbs.AddMarker(MarkerBodyRigid(bodyNumber=body))\n    spring = mbs.AddObject(TorsionalSpringDamper(markerNumbers=[mGround, mBody], stiffness=2, damping=0))\n    mbs.Assemble()\n    settings = exu.SimulationSettings()\n    settings.timeIntegration.numberOfSteps = 1000\n    mbs.SolveDynamic(settings)\n    result = mbs.GetObjectOutput(spring, exu.OutputVariableType.Rotation)\n\nPage: reference/items/connectors/torsional_spring_damper.html\n"},
    {"Couples two coordinates, or fixes one of them to a value or to a function of time", ObjectConnectorCoordinate_rows, ObjectConnectorCoordinate_outputs,
     "\nUser functions:\n    offsetUserFunction(mbs, t, itemNumber, lOffset)\n        computes the offset as a function of time, such as a prescribed motion; should be twice differentiable, and fit initial position and velocity\n    offsetUserFunction_t(mbs, t, itemNumber, lOffset)\n        computes the time derivative of the offset; called by index 2 integrators, for ``velocityLevel``, and for consistent initial accelerations\n\nCreated by: mbs.CreateCoordinateConstraint(...)\n\nExample:\n    # gear of ratio 2 between coordinates with masses 1 and 2: q0 = 2 q1, (4 * 1 + 2) q1'' = 2 * 9; the force on mass 0 is 9 - 3\n    ground = mbs.AddNode(NodePointGround())\n    node0 = mbs.AddNode(Node1D())\n    node1 = mbs.AddNode(Node1D())\n    mbs.AddObject(Mass1D(physicsMass=1, nodeNumber=node0))\n    mbs.AddObject(Mass1D(physicsMass=2, nodeNumber=node1))\n    m0 = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=node0, coordinate=0))\n    m1 = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=node1, coordinate=0))\n    gear = mbs.AddObject(CoordinateConstraint(markerNumbers=[m0, m1], factorValue1=2))\n    mbs.AddLoad(LoadCoordinate(markerNumber=m0, load=9))\n    mbs.Assemble()\n    mbs.SolveDynamic()\n    result = [mbs.GetNodeOutput(node1, exu.OutputVariableType.Coordinates), mbs.GetObjectOutput(gear, exu.OutputVariableType.Force)]\n\nPage: reference/items/constraints/coordinate.html\n"},
    {"Couples the coordinate vectors of two markers by linear and quadratic equations, or by a user function", ObjectConnectorCoordinateVector_rows, ObjectConnectorCoordinateVector_outputs,
     "\nUser functions:\n    constraintUserFunction(mbs, t, itemNumber, q, q_t, velocityLevel)\n        computes the residual of all equations; called at every evaluation of the constraints\n    jacobianUserFunction(mbs, t, itemNumber, q, q_t, velocityLevel)\n        computes the derivative of the equations; called wherever the gradient of the constraints or the system Jacobian is needed; must be exact, as it also gives the directions of the constraint forces\n\nExample:\n    # a bead on the parabola y = x^2, held by springs at (1, 1): along the tangent (1, 2 x), 2 (x - 1) + 2 x * 2 (y - 1) = 26 at x = 2\n    ground = mbs.AddObject(ObjectGround())\n    groundNode = mbs.AddNode(NodePointGround())\n    node = mbs.AddNode(NodePoint(referenceCoordinates=[1, 1, 0]))\n    mbs.AddObject(MassPoint(physicsMass=1, nodeNumber=node))\n    mGround = mbs.AddMarker(MarkerBodyPosition(bodyNumber=ground, localPosition=[1, 1, 0]))\n    mBead = mbs.AddMarker(MarkerNodePosition(nodeNumber=node))\n    mbs.AddObject(CartesianSpringDamper(markerNumbers=[mGround, mBead], stiffness=[2, 2, 2]))\n    m0 = mbs.AddMarker(MarkerNodeCoordinates(nodeNumber=groundNode))\n    m1 = mbs.AddMarker(MarkerNodeCoordinates(nodeNumber=node))\n    mbs.AddObject(CoordinateVectorConstraint(markerNumbers=[m0, m1], scalingMarker1=np.array([[0, 1, 0]]),\n                                             quadraticTermMarker1=np.array([[-1, 0, 0]])))\n    mbs.AddLoad(Force(markerNumber=mBead, loadVector=[26, 0, 0]))\n    mbs.Assemble()\n    settings = exu.SimulationSettings()\n    settings.staticSolver.numberOfLoadSteps = 5\n    mbs.SolveStatic(settings)\n    result = mbs.GetNodeOutput(node, exu.OutputVariableType.Position)\n\nPage: reference/items/constraints/coordinate_vector.html\n"},
    {"Keeps the distance of two points constant, like a massless rigid rod between two ball joints", ObjectConnectorDistance_rows, ObjectConnectorDistance_outputs,
     "\nCreated by: mbs.CreateDistanceConstraint(...)\n\nExample:\n    # a mass of 1 kg circles with 2 m/s at distance 1 m: tension m v^2 / r = 4; second order method, step 0.001\n    ground = mbs.AddObject(ObjectGround())\n    node = mbs.AddNode(NodePoint(referenceCoordinates=[1, 0, 0], initialVelocities=[0, 2, 0]))\n    mbs.AddObject(MassPoint(physicsMass=1, nodeNumber=node))\n    mGround = mbs.AddMarker(MarkerBodyPosition(bodyNumber=ground))\n    mBody = mbs.AddMarker(MarkerNodePosition(nodeNumber=node))\n    rod = mbs.AddObject(DistanceConstraint(markerNumbers=[mGround, mBody], distance=1))\n    mbs.Assemble()\n    settings = exu.SimulationSettings()\n    settings.timeIntegration.numberOfSteps = 1000\n    mbs.SolveDynamic(settings)\n    result = np.append(mbs.GetNodeOutput(node, exu.OutputVariableType.Position),\n                       mbs.GetObjectOutput(rod, exu.OutputVariableType.Force))\n\nPage: reference/items/constraints/distance.html\n"},
    {"Contact without friction of a planar cable element with a circle", ObjectContactCircleCable2D_rows, {},
     "\nExample:\n    # a circle of radius 0.2, pressed with 10 N against 1000 N/m of the second segment of a fixed cable\n    nodes = [mbs.AddNode(NodePoint2DSlope1(referenceCoordinates=[x, 0, 1, 0])) for x in (0, 1.5)]\n    cable = mbs.AddObject(Cable2D(physicsLength=1.5, physicsMassPerLength=1, physicsBendingStiffness=1, physicsAxialStiffness=1, nodeNumbers=nodes))\n    ground = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.AddNode(NodePointGround()), coordinate=0))\n    center = mbs.AddNode(NodePoint2D(referenceCoordinates=[0.75, 0.2]))\n    for node, count in [(nodes[0], 4), (nodes[1], 4), (center, 1)]:\n        for coordinate in range(count):\n            fixed = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=node, coordinate=coordinate))\n            mbs.AddObject(CoordinateConstraint(markerNumbers=[ground, fixed]))\n    circle = mbs.AddMarker(MarkerBodyPosition(bodyNumber=mbs.AddObject(MassPoint2D(physicsMass=1, nodeNumber=center))))\n    shape = mbs.AddMarker(MarkerBodyCable2DShape(bodyNumber=cable, numberOfSegments=3))\n    gaps = mbs.AddNode(NodeGenericData(numberOfDataCoordinates=3, initialCoordinates=[1, 0, 1]))\n    mbs.AddObject(ObjectContactCircleCable2D(markerNumbers=[circle, shape], nodeNumber=gaps, numberOfContactSegments=3, contactStiffness=1000,\n                                             circleRadius=0.2))\n    mbs.AddLoad(Force(markerNumber=circle, loadVector=[0, -10, 0]))\n    mbs.Assemble()\n    mbs.SolveStatic()\n    result = mbs.GetNodeOutput(center, exu.OutputVariableType.Position)[1]\n\nPage: reference/items/contacts/circle_cable_2d.html\n"},
    {"Contact of a convex roll, a body of revolution with a polynomial profile, with the ground plane", ObjectContactConvexRoll_rows, ObjectContactConvexRoll_outputs,
     "\nExample:\n    # a barrel, pressed with 10 N against 1000 N/m of the ground\n    node = mbs.AddNode(NodeRigidBodyRxyz(referenceCoordinates=[0, 0, 0.1, 0, 0, 0]))\n    barrel = mbs.AddObject(RigidBody(physicsMass=1, physicsInertia=[1, 1, 1, 0, 0, 0], nodeNumber=node))\n    mGround = mbs.AddMarker(MarkerBodyRigid(bodyNumber=mbs.AddObject(ObjectGround())))\n    mBody = mbs.AddMarker(MarkerBodyRigid(bodyNumber=barrel))\n    mbs.AddObject(GenericJoint(markerNumbers=[mGround, mBody], constrainedAxes=[1, 1, 0, 1, 1, 1]))\n    data = mbs.AddNode(NodeGenericData(numberOfDataCoordinates=3, initialCoordinates=[-0.001, 0, 0]))\n    mbs.AddObject(ObjectContactConvexRoll(markerNumbers=[mGround, mBody], nodeNumber=data, rollLength=0.2, coefficientsHull=[-1, 0, 0.1], contactStiffness=1000))\n    mbs.AddLoad(Force(markerNumber=mBody, loadVector=[0, 0, -10]))\n    mbs.Assemble()\n    mbs.SolveStatic()\n    result = mbs.GetNodeOutput(node, exu.OutputVariableType.Displacement)\n\nPage: reference/items/contacts/convex_roll.html\n"},
    {"Contact of two coordinates, a one-sided spring and damper", ObjectContactCoordinate_rows, ObjectContactCoordinate_outputs,
     "\nExample:\n    # a mass pressed with 10 N against a stop of 100 N/m at the coordinate 0.05\n    node = mbs.AddNode(Node1D())\n    mbs.AddObject(Mass1D(physicsMass=1, nodeNumber=node))\n    ground = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.AddNode(NodePointGround()), coordinate=0))\n    mass = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=node, coordinate=0))\n    data = mbs.AddNode(NodeGenericData(numberOfDataCoordinates=1, initialCoordinates=[-0.05]))\n    mbs.AddObject(ObjectContactCoordinate(markerNumbers=[ground, mass], nodeNumber=data, contactStiffness=100, offset=0.05))\n    mbs.AddLoad(LoadCoordinate(markerNumber=mass, load=-10))\n    mbs.Assemble()\n    mbs.SolveStatic()\n    result = mbs.GetNodeOutput(node, exu.OutputVariableType.Coordinates)\n\nPage: reference/items/contacts/coordinate.html\n"},
    {"Contact of a planar curve with circles, as of a cam with its followers", ObjectContactCurveCircles_rows, ObjectContactCurveCircles_outputs,
     "\nExample:\n    # a roller, pressed with 10 N against a line of length 0.8 with 1250 N/m per length\n    node = mbs.AddNode(NodeRigidBodyRxyz(referenceCoordinates=[0, 0, 0.1, 0, 0, 0]))\n    roller = mbs.AddObject(RigidBody(physicsMass=1, physicsInertia=[1, 1, 1, 0, 0, 0], nodeNumber=node))\n    mGround = mbs.AddMarker(MarkerBodyRigid(bodyNumber=mbs.AddObject(ObjectGround())))\n    mBody = mbs.AddMarker(MarkerBodyRigid(bodyNumber=roller))\n    mbs.AddObject(GenericJoint(markerNumbers=[mGround, mBody], constrainedAxes=[1, 1, 0, 1, 1, 1]))\n    data = mbs.AddNode(NodeGenericData(numberOfDataCoordinates=3, initialCoordinates=[0, -0.001, 0]))\n    line = exu.MatrixContainer([[-0.4, 0, 0.4, 0]])\n    mbs.AddObject(ObjectContactCurveCircles(markerNumbers=[mGround, mBody], nodeNumber=data, circlesRadii=[0.1], segmentsData=line,\n                                            rotationMarker0=[[1, 0, 0], [0, 0, 1], [0, -1, 0]], contactStiffness=1250))\n    mbs.AddLoad(Force(markerNumber=mBody, loadVector=[0, 0, -10]))\n    mbs.Assemble()\n    mbs.SolveStatic()\n    result = mbs.GetNodeOutput(node, exu.OutputVariableType.Displacement)\n\nPage: reference/items/contacts/curve_circles.html\n"},
    {"Contact with friction of a planar cable element with a circle, such as of a belt on a pulley", ObjectContactFrictionCircleCable2D_rows, ObjectContactFrictionCircleCable2D_outputs,
     "\nExample:\n    # a disc of radius 0.2, pressed with 10 N against 1000 N/m of the second segment of a fixed cable\n    nodes = [mbs.AddNode(NodePoint2DSlope1(referenceCoordinates=[x, 0, 1, 0])) for x in (0, 1.5)]\n    cable = mbs.AddObject(Cable2D(physicsLength=1.5, physicsMassPerLength=1, physicsBendingStiffness=1, physicsAxialStiffness=1, nodeNumbers=nodes))\n    ground = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.AddNode(NodePointGround()), coordinate=0))\n    center = mbs.AddNode(NodeRigidBody2D(referenceCoordinates=[0.75, 0.2, 0]))\n    for node, free in [(nodes[0], []), (nodes[1], []), (center, [1])]:\n        for coordinate in range(3 if node == center else 4):\n            if coordinate not in free:\n                fixed = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=node, coordinate=coordinate))\n                mbs.AddObject(CoordinateConstraint(markerNumbers=[ground, fixed]))\n    disc = mbs.AddMarker(MarkerBodyRigid(bodyNumber=mbs.AddObject(RigidBody2D(physicsMass=1, physicsInertia=1, nodeNumber=center))))\n    shape = mbs.AddMarker(MarkerBodyCable2DShape(bodyNumber=cable, numberOfSegments=3))\n    states = mbs.AddNode(NodeGenericData(numberOfDataCoordinates=9, initialCoordinates=[1, -0.001, 1, -2, 0, -2, 0, 0, 0]))\n    mbs.AddObject(ObjectContactFrictionCircleCable2D(markerNumbers=[disc, shape], nodeNumber=states, numberOfContactSegments=3, contactStiffness=1000,\n                                                     frictionVelocityPenalty=10, frictionCoefficient=0.3, circleRadius=0.2))\n    mbs.AddLoad(Force(markerNumber=disc, loadVector=[0, -10, 0]))\n    mbs.Assemble()\n    mbs.SolveStatic()\n    result = mbs.GetNodeOutput(center, exu.OutputVariableType.Position)[1]\n\nPage: reference/items/contacts/friction_circle_cable_2d.html\n"},
    {"Contact of two spheres, or of a sphere inside a hollow sphere, with friction, restitution and adhesion", ObjectContactSphereSphere_rows, ObjectContactSphereSphere_outputs,
     "\nCreated by: mbs.CreateSphereSphereContact(...)\n\nExample:\n    # a ball, pressed with 10 N against 1000 N/m of a resting ball\n    node = mbs.AddNode(NodeRigidBodyRxyz(referenceCoordinates=[0, 0, 0.2, 0, 0, 0]))\n    ball = mbs.AddObject(RigidBody(physicsMass=1, physicsInertia=[1, 1, 1, 0, 0, 0], nodeNumber=node))\n    mGround = mbs.AddMarker(MarkerBodyRigid(bodyNumber=mbs.AddObject(ObjectGround())))\n    mBody = mbs.AddMarker(MarkerBodyRigid(bodyNumber=ball))\n    mbs.AddObject(GenericJoint(markerNumbers=[mGround, mBody], constrainedAxes=[1, 1, 0, 1, 1, 1]))\n    data = mbs.AddNode(NodeGenericData(numberOfDataCoordinates=4, initialCoordinates=[-0.001, 0, 0, 0]))\n    mbs.AddObject(ObjectContactSphereSphere(markerNumbers=[mGround, mBody], nodeNumber=data, spheresRadii=[0.1, 0.1], contactStiffness=1000))\n    mbs.AddLoad(Force(markerNumber=mBody, loadVector=[0, 0, -10]))\n    mbs.Assemble()\n    mbs.SolveStatic()\n    result = mbs.GetNodeOutput(node, exu.OutputVariableType.Displacement)\n\nPage: reference/items/contacts/sphere_sphere.html\n"},
    {"Contact of a sphere inside the tube of a torus, as of a ball in the groove of a bearing", ObjectContactSphereTorus_rows, ObjectContactSphereTorus_outputs,
     "\nExample:\n    # a ball that does not turn, in the groove of a torus: pressed with 20 N in the direction (0.6, 0, 0.8) against 1000 N/m\n    node = mbs.AddNode(NodeRigidBodyRxyz(referenceCoordinates=[1.12, 0, 0.16, 0, 0, 0]))\n    ball = mbs.AddObject(RigidBody(physicsMass=1, physicsInertia=[1, 1, 1, 0, 0, 0], nodeNumber=node))\n    torus = mbs.AddMarker(MarkerBodyRigid(bodyNumber=mbs.AddObject(ObjectGround())))\n    sphere = mbs.AddMarker(MarkerBodyRigid(bodyNumber=ball))\n    mbs.AddObject(GenericJoint(markerNumbers=[torus, sphere], constrainedAxes=[0, 1, 0, 1, 1, 1]))\n    data = mbs.AddNode(NodeGenericData(numberOfDataCoordinates=4, initialCoordinates=[-0.001, 0, 0, 0]))\n    mbs.AddObject(ObjectContactSphereTorus(markerNumbers=[sphere, torus], nodeNumber=data, radiusSphere=0.1, torusMajorRadius=1,\n                                           torusMinorRadius=0.3, torusAxis=[0, 0, 1], contactStiffness=1000))\n    mbs.AddLoad(Force(markerNumber=sphere, loadVector=[12, 0, 16]))\n    mbs.Assemble()\n    mbs.SolveStatic()\n    result = mbs.GetNodeOutput(node, exu.OutputVariableType.Displacement)\n\nPage: reference/items/contacts/sphere_torus.html\n"},
    {"Contact of a sphere with a triangle, its face and chosen edges", ObjectContactSphereTriangle_rows, ObjectContactSphereTriangle_outputs,
     "\nCreated by: mbs.CreateSphereTriangleContact(...), mbs.CreateSphereQuadContact(...)\n\nExample:\n    # a ball, pressed with 10 N against 1000 N/m of a resting triangle\n    node = mbs.AddNode(NodeRigidBodyRxyz(referenceCoordinates=[0, 0, 0.1, 0, 0, 0]))\n    ball = mbs.AddObject(RigidBody(physicsMass=1, physicsInertia=[1, 1, 1, 0, 0, 0], nodeNumber=node))\n    mGround = mbs.AddMarker(MarkerBodyRigid(bodyNumber=mbs.AddObject(ObjectGround())))\n    mBody = mbs.AddMarker(MarkerBodyRigid(bodyNumber=ball))\n    mbs.AddObject(GenericJoint(markerNumbers=[mGround, mBody], constrainedAxes=[1, 1, 0, 1, 1, 1]))\n    data = mbs.AddNode(NodeGenericData(numberOfDataCoordinates=4, initialCoordinates=[-0.001, 0, 0, 0]))\n    corners = exu.Vector3DList([[-0.2, -0.2, 0], [0.4, -0.2, 0], [-0.2, 0.4, 0]])\n    mbs.AddObject(ObjectContactSphereTriangle(markerNumbers=[mBody, mGround], nodeNumber=data, radiusSphere=0.1, trianglePoints=corners, contactStiffness=1000))\n    mbs.AddLoad(Force(markerNumber=mBody, loadVector=[0, 0, -10]))\n    mbs.Assemble()\n    mbs.SolveStatic()\n    result = mbs.GetNodeOutput(node, exu.OutputVariableType.Displacement)\n\nPage: reference/items/contacts/sphere_triangle.html\n"},
    {"A body attached to an axially moving ANCF cable, whose sliding coordinate is shared by all elements of the cable", ObjectJointALEMoving2D_rows, ObjectJointALEMoving2D_outputs,
     "\nExample:\n    # a mass that a belt, which does not bend or stretch much, takes along with 2 m/s for 0.35 s, from the first element to the second\n    nodes = [mbs.AddNode(NodePoint2DSlope1(referenceCoordinates=[x, 0, 1, 0])) for x in range(3)]\n    way = mbs.AddNode(NodeGenericODE2(numberOfODE2Coordinates=1, referenceCoordinates=[0], initialCoordinates=[0], initialCoordinates_t=[2]))\n    cables = [mbs.AddObject(ALECable2D(physicsLength=1, physicsMassPerLength=1, physicsBendingStiffness=1, physicsAxialStiffness=1, nodeNumbers=[*pair, way]))\n              for pair in zip(nodes[:-1], nodes[1:])]\n    ground = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.AddNode(NodePointGround()), coordinate=0))\n    for node in nodes:\n        for coordinate in range(4):\n            fixed = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=node, coordinate=coordinate))\n            mbs.AddObject(CoordinateConstraint(markerNumbers=[ground, fixed]))\n    mass = mbs.AddNode(NodePoint2D(referenceCoordinates=[0.5, 0], initialVelocities=[2, 0]))\n    carried = mbs.AddMarker(MarkerBodyPosition(bodyNumber=mbs.AddObject(MassPoint2D(physicsMass=2, nodeNumber=mass))))\n    markers = [mbs.AddMarker(MarkerBodyCable2DCoordinates(bodyNumber=cable)) for cable in cables]\n    element = mbs.AddNode(NodeGenericData(numberOfDataCoordinates=1, initialCoordinates=[0]))\n    mbs.AddObject(ALEMovingJoint2D(markerNumbers=[carried, markers[0]], slidingMarkerNumbers=markers, slidingMarkerOffsets=[0, 1], slidingOffset=0.5,\n                                   nodeNumbers=[element, way]))\n    mbs.Assemble()\n    settings = exu.SimulationSettings()\n    settings.timeIntegration.endTime = 0.35\n    settings.timeIntegration.numberOfSteps = 35\n    mbs.SolveDynamic(settings)\n    result = mbs.GetNodeOutput(mass, exu.OutputVariableType.Position)\n\nPage: reference/items/joints/ale_moving_2d.html\n"},
    {"A joint between two rigid body markers that constrains any choice of three translations and three rotations", ObjectJointGeneric_rows, ObjectJointGeneric_outputs,
     "\nUser functions:\n    offsetUserFunction(mbs, t, itemNumber, offsetUserFunctionParameters)\n        computes the prescribed relative position and rotation; should be twice differentiable, and fit initial position and velocity; called at every evaluation of the constraints on position level\n    offsetUserFunction_t(mbs, t, itemNumber, offsetUserFunctionParameters)\n        computes the time derivative of ``offsetUserFunction``\n\nCreated by: mbs.CreateGenericJoint(...), mbs.CreateFixedJoint(...), mbs.CreateCylindricalJoint(...), mbs.CreateUniversalJoint(...), mbs.CreatePrescribedMotion(...)\n\nExample:\n    # slide inclined by 30 degrees, a force of 8 N downwards on 2 kg: s'' = -8 sin(30) / 2 = -2, normal force 8 cos(30)\n    ground = mbs.AddObject(ObjectGround())\n    node = mbs.AddNode(NodeRigidBodyRxyz())\n    body = mbs.AddObject(RigidBody(physicsMass=2, physicsInertia=[1, 1, 1, 0, 0, 0], nodeNumber=node))\n    mGround = mbs.AddMarker(MarkerBodyRigid(bodyNumber=ground))\n    mBody = mbs.AddMarker(MarkerBodyRigid(bodyNumber=body))\n    c, s = np.cos(np.pi / 6), np.sin(np.pi / 6)\n    A = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])\n    joint = mbs.AddObject(GenericJoint(markerNumbers=[mGround, mBody], constrainedAxes=[0, 1, 1, 1, 1, 1],\n                                       rotationMarker0=A, rotationMarker1=A))\n    mbs.AddLoad(Force(markerNumber=mBody, loadVector=[0, -8, 0]))\n    mbs.Assemble()\n    mbs.SolveDynamic()\n    result = [mbs.GetObjectOutput(joint, exu.OutputVariableType.DisplacementLocal)[0],\n              mbs.GetObjectOutput(joint, exu.OutputVariableType.ForceLocal)[1]]\n\nPage: reference/items/joints/generic.html\n"},
    {"A prismatic joint of planar bodies: one point moves on a line that is fixed to the other body", ObjectJointPrismatic2D_rows, ObjectJointPrismatic2D_outputs,
     "\nCreated by: mbs.CreatePrismaticJoint(...)\n\nExample:\n    # a body of 1 kg on a line in direction (3, 4), pushed with 5 N along x: 3 m/s^2 along the line\n    node = mbs.AddNode(NodeRigidBody2D())\n    body = mbs.AddObject(RigidBody2D(physicsMass=1, physicsInertia=1, nodeNumber=node))\n    m0 = mbs.AddMarker(MarkerBodyRigid(bodyNumber=mbs.AddObject(ObjectGround())))\n    m1 = mbs.AddMarker(MarkerBodyRigid(bodyNumber=body))\n    mbs.AddObject(PrismaticJoint2D(markerNumbers=[m0, m1], axisMarker0=[0.6, 0.8, 0], normalMarker1=[-0.8, 0.6, 0]))\n    mbs.AddLoad(Force(markerNumber=m1, loadVector=[5, 0, 0]))\n    mbs.Assemble()\n    mbs.SolveDynamic()\n    result = mbs.GetNodeOutput(node, exu.OutputVariableType.Coordinates)\n\nPage: reference/items/joints/prismatic_2d.html\n"},
    {"A prismatic joint between two rigid body markers, free to translate along the x axis of the joint frame", ObjectJointPrismaticX_rows, ObjectJointPrismaticX_outputs,
     "\nCreated by: mbs.CreatePrismaticJoint(...)\n\nExample:\n    # a body of 2 kg on a guide along x, pushed with (4, 3) N: x'' = 4 / 2, and the guide carries 3 N\n    inertia = [1, 1, 1, 0, 0, 0]\n    node = mbs.AddNode(NodeRigidBodyRxyz())\n    body = mbs.AddObject(RigidBody(physicsMass=2, physicsInertia=inertia, nodeNumber=node))\n    m0 = mbs.AddMarker(MarkerBodyRigid(bodyNumber=mbs.AddObject(ObjectGround())))\n    m1 = mbs.AddMarker(MarkerBodyRigid(bodyNumber=body))\n    joint = mbs.AddObject(PrismaticJointX(markerNumbers=[m0, m1]))\n    mbs.AddLoad(Force(markerNumber=m1, loadVector=[4, 3, 0]))\n    mbs.Assemble()\n    mbs.SolveDynamic()\n    result = [mbs.GetNodeOutput(node, exu.OutputVariableType.Position)[0],\n              mbs.GetObjectOutput(joint, exu.OutputVariableType.ForceLocal)[1]]\n\nPage: reference/items/joints/prismatic_x.html\n"},
    {"A revolute joint of planar bodies: keeps two points together in the x-y plane", ObjectJointRevolute2D_rows, ObjectJointRevolute2D_outputs,
     "\nCreated by: mbs.CreateRevoluteJoint(...)\n\nExample:\n    # a rod turns about its end by a torque of 3 Nm: J = 0.75 + 3 * 0.5^2 = 1.5, angle 3 / (2 * 1.5) after 1 s; step 0.001\n    ground = mbs.AddObject(ObjectGround())\n    node = mbs.AddNode(NodeRigidBody2D(referenceCoordinates=[0.5, 0, 0]))\n    rod = mbs.AddObject(RigidBody2D(physicsMass=3, physicsInertia=0.75, nodeNumber=node))\n    mGround = mbs.AddMarker(MarkerBodyPosition(bodyNumber=ground))\n    mRod = mbs.AddMarker(MarkerBodyPosition(bodyNumber=rod, localPosition=[-0.5, 0, 0]))\n    mbs.AddObject(RevoluteJoint2D(markerNumbers=[mGround, mRod]))\n    mCenter = mbs.AddMarker(MarkerBodyRigid(bodyNumber=rod))\n    mbs.AddLoad(Torque(markerNumber=mCenter, loadVector=[0, 0, 3]))\n    mbs.Assemble()\n    settings = exu.SimulationSettings()\n    settings.timeIntegration.numberOfSteps = 1000\n    mbs.SolveDynamic(settings)\n    result = mbs.GetNodeOutput(node, exu.OutputVariableType.Coordinates)[2]\n\nPage: reference/items/joints/revolute_2d.html\n"},
    {"A revolute joint between two rigid body markers, free to rotate about the z axis of the joint frame", ObjectJointRevoluteZ_rows, ObjectJointRevoluteZ_outputs,
     "\nCreated by: mbs.CreateRevoluteJoint(...)\n\nExample:\n    # a body turns about a joint at 1 m from its center, by a torque of 3 Nm: J = 0.5 + 1 * 1^2, angle 3 / (2 * 1.5) after 1 s; step 0.001\n    ground = mbs.AddObject(ObjectGround())\n    node = mbs.AddNode(NodeRigidBodyRxyz(referenceCoordinates=[1, 0, 0, 0, 0, 0]))\n    body = mbs.AddObject(RigidBody(physicsMass=1, physicsInertia=[1, 1, 0.5, 0, 0, 0], nodeNumber=node))\n    mGround = mbs.AddMarker(MarkerBodyRigid(bodyNumber=ground))\n    mBody = mbs.AddMarker(MarkerBodyRigid(bodyNumber=body, localPosition=[-1, 0, 0]))\n    joint = mbs.AddObject(RevoluteJointZ(markerNumbers=[mGround, mBody]))\n    mbs.AddLoad(Torque(markerNumber=mBody, loadVector=[0, 0, 3]))\n    mbs.Assemble()\n    settings = exu.SimulationSettings()\n    settings.timeIntegration.numberOfSteps = 1000\n    mbs.SolveDynamic(settings)\n    result = mbs.GetObjectOutput(joint, exu.OutputVariableType.Rotation)[2]\n\nPage: reference/items/joints/revolute_z.html\n"},
    {"A rigid disc that rolls on a plane without slip, by constraints on the velocity of the contact point", ObjectJointRollingDisc_rows, ObjectJointRollingDisc_outputs,
     "\nCreated by: mbs.CreateRollingDisc(...)\n\nExample:\n    # a homogeneous disc of 2 kg and radius 1 m, pushed with 6 N: acceleration 6 / (2 + 1), friction 2 N, weight 19.62 N\n    node = mbs.AddNode(NodeRigidBodyRxyz(referenceCoordinates=[0, 0, 1, 0, 0, 0]))\n    body = mbs.AddObject(RigidBody(physicsMass=2, physicsInertia=[1, 0.5, 0.5, 0, 0, 0], nodeNumber=node))\n    m0 = mbs.AddMarker(MarkerBodyRigid(bodyNumber=mbs.AddObject(ObjectGround())))\n    m1 = mbs.AddMarker(MarkerBodyRigid(bodyNumber=body))\n    joint = mbs.AddObject(RollingDiscJoint(markerNumbers=[m0, m1], discRadius=1))\n    mbs.AddLoad(Force(markerNumber=m1, loadVector=[0, 6, -19.62]))\n    mbs.Assemble()\n    mbs.SolveDynamic()\n    result = [mbs.GetNodeOutput(node, exu.OutputVariableType.Position)[1],\n              *mbs.GetObjectOutput(joint, exu.OutputVariableType.ForceLocal)]\n\nPage: reference/items/joints/rolling_disc.html\n"},
    {"A body that slides along a chain of ANCF cable elements in space", ObjectJointSliding_rows, ObjectJointSliding_outputs,
     "\nExample:\n    # a body that slides with 8 m/s^2 along a straight, fixed cable, guided by it, from the first element to the second: 0.5 + 8 * 0.5**2 / 2\n    nodes = [mbs.AddNode(NodePointSlope1(referenceCoordinates=[x, 0, 0, 1, 0, 0])) for x in range(3)]\n    cables = [mbs.AddObject(ObjectANCFCable(physicsLength=1, physicsMassPerLength=1, physicsBendingStiffness=1, physicsAxialStiffness=1, nodeNumbers=list(pair)))\n              for pair in zip(nodes[:-1], nodes[1:])]\n    ground = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.AddNode(NodePointGround()), coordinate=0))\n    for node in nodes:\n        for coordinate in range(6):\n            fixed = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=node, coordinate=coordinate))\n            mbs.AddObject(CoordinateConstraint(markerNumbers=[ground, fixed]))\n    node = mbs.AddNode(NodeRigidBodyRxyz(referenceCoordinates=[0.5, 0, 0, 0, 0, 0]))\n    body = mbs.AddObject(ObjectRigidBody(physicsMass=2, physicsInertia=[0.01, 0.02, 0.02, 0, 0, 0], nodeNumber=node))\n    slider = mbs.AddMarker(MarkerBodyRigid(bodyNumber=body))\n    mbs.AddLoad(Force(markerNumber=slider, loadVector=[16, -20, 5]))\n    mbs.AddLoad(Torque(markerNumber=slider, loadVector=[0, 0.2, 0.1]))\n    shapes = [mbs.AddMarker(MarkerBodyBeamShape(bodyNumber=cable)) for cable in cables]\n    start = mbs.AddNode(NodeGenericData(numberOfDataCoordinates=2, initialCoordinates=[0, 0.5]))\n    joint = mbs.AddObject(SlidingJoint(markerNumbers=[slider, shapes[0]], slidingMarkerNumbers=shapes, slidingMarkerOffsets=[0, 1], nodeNumber=start,\n                                       constrainRotations=[0, 1, 1]))\n    mbs.Assemble()\n    settings = exu.SimulationSettings()\n    settings.timeIntegration.endTime = 0.5\n    settings.timeIntegration.numberOfSteps = 50\n    mbs.SolveDynamic(settings)\n    result = mbs.GetObjectOutput(joint, exu.OutputVariableType.SlidingCoordinate)\n\nPage: reference/items/joints/sliding.html\n"},
    {"A body that slides along a chain of planar ANCF cable elements", ObjectJointSliding2D_rows, ObjectJointSliding2D_outputs,
     "\nExample:\n    # a mass that slides with 8 m/s^2 along a straight, fixed cable, from the first element to the second: 0.5 + 8 * 0.5**2 / 2\n    nodes = [mbs.AddNode(NodePoint2DSlope1(referenceCoordinates=[x, 0, 1, 0])) for x in range(3)]\n    cables = [mbs.AddObject(Cable2D(physicsLength=1, physicsMassPerLength=1, physicsBendingStiffness=1, physicsAxialStiffness=1, nodeNumbers=list(pair)))\n              for pair in zip(nodes[:-1], nodes[1:])]\n    ground = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.AddNode(NodePointGround()), coordinate=0))\n    for node in nodes:\n        for coordinate in range(4):\n            fixed = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=node, coordinate=coordinate))\n            mbs.AddObject(CoordinateConstraint(markerNumbers=[ground, fixed]))\n    mass = mbs.AddObject(MassPoint2D(physicsMass=2, nodeNumber=mbs.AddNode(NodePoint2D(referenceCoordinates=[0.5, 0]))))\n    slider = mbs.AddMarker(MarkerBodyPosition(bodyNumber=mass))\n    mbs.AddLoad(Force(markerNumber=slider, loadVector=[16, -20, 0]))\n    sliding = [mbs.AddMarker(MarkerBodyCable2DCoordinates(bodyNumber=cable)) for cable in cables]\n    start = mbs.AddNode(NodeGenericData(numberOfDataCoordinates=2, initialCoordinates=[0, 0.5]))\n    joint = mbs.AddObject(SlidingJoint2D(markerNumbers=[slider, sliding[0]], slidingMarkerNumbers=sliding, slidingMarkerOffsets=[0, 1], nodeNumber=start))\n    mbs.Assemble()\n    settings = exu.SimulationSettings()\n    settings.timeIntegration.endTime = 0.5\n    settings.timeIntegration.numberOfSteps = 50\n    mbs.SolveDynamic(settings)\n    result = mbs.GetObjectOutput(joint, exu.OutputVariableType.SlidingCoordinate)\n\nPage: reference/items/joints/sliding_2d.html\n"},
    {"A ball joint: keeps two points together, or their chosen global components", ObjectJointSpherical_rows, ObjectJointSpherical_outputs,
     "\nCreated by: mbs.CreateSphericalJoint(...)\n\nExample:\n    # a mass of 2 kg on a rod of 1 m that hangs from the joint goes round a circle of 0.6 m, w^2 = g / (0.8 m): half a turn, and m g / 0.8 in the rod\n    g, place = 9.81, np.array([0.6, 0, -0.8])\n    w = np.sqrt(g/0.8)\n    ground = mbs.AddObject(ObjectGround())\n    node = mbs.AddNode(NodeRigidBodyEP(referenceCoordinates=[*place, 1, 0, 0, 0], initialVelocities=[0, 0.6*w, 0, 0, 0, 0, w/2]))\n    body = mbs.AddObject(RigidBody(physicsMass=2, physicsInertia=[0.01, 0.01, 0.01, 0, 0, 0], nodeNumber=node))\n    m0 = mbs.AddMarker(MarkerBodyPosition(bodyNumber=ground))\n    m1 = mbs.AddMarker(MarkerBodyPosition(bodyNumber=body, localPosition=-place))\n    joint = mbs.AddObject(SphericalJoint(markerNumbers=[m0, m1]))\n    mbs.AddLoad(Gravity(markerNumber=mbs.AddMarker(MarkerBodyMass(bodyNumber=body)), loadVector=[0, 0, -g]))\n    mbs.Assemble()\n    settings = exu.SimulationSettings()\n    settings.timeIntegration.endTime = np.pi/w\n    settings.timeIntegration.numberOfSteps = 1000\n    mbs.SolveDynamic(settings)\n    p = mbs.GetNodeOutput(node, exu.OutputVariableType.Position)\n    result = [p[0], p[2], np.linalg.norm(mbs.GetObjectOutput(joint, exu.OutputVariableType.Force))]\n\nPage: reference/items/joints/spherical.html\n"},
    {"A coordinate marker on the relative rotation of two bodies about an axis", MarkerBodiesRelativeRotationCoordinate_rows, {},
     "\nExample:\n    # two rotors at 2 and 9 rad/s about the same axis: after one second, more than a full turn of relative rotation\n    nodes = [mbs.AddNode(NodeRigidBody2D(initialVelocities=[0, 0, w])) for w in [2, 9]]\n    bodies = [mbs.AddObject(RigidBody2D(physicsMass=1, physicsInertia=1, nodeNumber=n)) for n in nodes]\n    data = mbs.AddNode(NodeGenericData(numberOfDataCoordinates=1, initialCoordinates=[0]))\n    marker = mbs.AddMarker(MarkerBodiesRelativeRotationCoordinate(bodyNumbers=bodies, nodeNumber=data, axis0=[0, 0, 1]))\n    mbs.Assemble()\n    mbs.SolveDynamic()\n    result = [mbs.GetMarkerOutput(marker, exu.OutputVariableType.Coordinates)[0],\n              mbs.GetMarkerOutput(marker, exu.OutputVariableType.Coordinates_t)[0]]\n\nPage: reference/items/markers/bodies_relative_rotation_coordinate.html\n"},
    {"A coordinate marker on the relative translation of two bodies along an axis", MarkerBodiesRelativeTranslationCoordinate_rows, {},
     "\nExample:\n    # a slider at 5 m/s on a guide that moves with 3 m/s: after one second it is 2 m ahead, from 1 m\n    inertia = {'physicsMass': 1, 'physicsInertia': 1}\n    nodes = [mbs.AddNode(NodeRigidBody2D(referenceCoordinates=[x, 0, 0], initialVelocities=[v, 0, 0])) for x, v in [(0, 3), (1, 5)]]\n    bodies = [mbs.AddObject(RigidBody2D(nodeNumber=n, **inertia)) for n in nodes]\n    marker = mbs.AddMarker(MarkerBodiesRelativeTranslationCoordinate(bodyNumbers=bodies))\n    mbs.Assemble()\n    mbs.SolveDynamic()\n    result = [mbs.GetMarkerOutput(marker, exu.OutputVariableType.Coordinates)[0],\n              mbs.GetMarkerOutput(marker, exu.OutputVariableType.Coordinates_t)[0]]\n\nPage: reference/items/markers/bodies_relative_translation_coordinate.html\n"},
    {"A marker that gives joints and contacts access to the shape of a beam element", MarkerBodyBeamShape_rows, {},
     "\nExample:\n    # a bead that slides at 0.7 m/s along a resting cable, from the first element to the second: 0.6 + 0.7 * 0.5\n    nodes = [mbs.AddNode(NodePointSlope1(referenceCoordinates=[0, 0, z, 0, 0, 1])) for z in (0, 0.8, 2)]\n    cables = [mbs.AddObject(ObjectANCFCable(physicsLength=length, physicsMassPerLength=1, physicsBendingStiffness=1, physicsAxialStiffness=1, nodeNumbers=nodes[i:i + 2]))\n              for i, length in enumerate([0.8, 1.2])]\n    bead = mbs.AddNode(NodePoint(referenceCoordinates=[0, 0, 0.6], initialVelocities=[0, 0, 0.7]))\n    slider = mbs.AddMarker(MarkerBodyPosition(bodyNumber=mbs.AddObject(MassPoint(physicsMass=2, nodeNumber=bead))))\n    shapes = [mbs.AddMarker(MarkerBodyBeamShape(bodyNumber=cable)) for cable in cables]\n    start = mbs.AddNode(NodeGenericData(numberOfDataCoordinates=2, initialCoordinates=[0, 0.6]))\n    joint = mbs.AddObject(SlidingJoint(markerNumbers=[slider, shapes[0]], slidingMarkerNumbers=shapes, slidingMarkerOffsets=[0, 0.8],\n                                       nodeNumber=start, constrainRotations=[0, 0, 0]))\n    mbs.Assemble()\n    settings = exu.SimulationSettings()\n    settings.timeIntegration.endTime = 0.5\n    settings.timeIntegration.numberOfSteps = 50\n    mbs.SolveDynamic(settings)\n    result = mbs.GetObjectOutput(joint, exu.OutputVariableType.SlidingCoordinate)\n\nPage: reference/items/markers/body_beam_shape.html\n"},
    {"A marker on all coordinates of a planar ANCF cable element, for sliding joints", MarkerBodyCable2DCoordinates_rows, {},
     "\nExample:\n    # a cable, clamped by one constraint of its first four coordinates: the multipliers are the reactions to a force at its tip\n    nodes = [mbs.AddNode(NodePoint2DSlope1(referenceCoordinates=[x, 0, 1, 0])) for x in (0, 2)]\n    cable = mbs.AddObject(Cable2D(physicsLength=2, physicsMassPerLength=1, physicsBendingStiffness=50, physicsAxialStiffness=1e4, nodeNumbers=nodes))\n    ground = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.AddNode(NodePointGround()), coordinate=0))\n    all = mbs.AddMarker(MarkerBodyCable2DCoordinates(bodyNumber=cable))\n    clamp = mbs.AddObject(CoordinateVectorConstraint(markerNumbers=[ground, all], scalingMarker1=np.eye(4, 8), offset=[0, 0, 1, 0]))\n    tip = mbs.AddMarker(MarkerNodePosition(nodeNumber=nodes[1]))\n    mbs.AddLoad(Force(markerNumber=tip, loadVector=[-3, 4, 0]))\n    mbs.Assemble()\n    mbs.SolveStatic()\n    result = mbs.GetObjectOutput(clamp, exu.OutputVariableType.Force)[:2]\n\nPage: reference/items/markers/body_cable_2d_coordinates.html\n"},
    {"A marker that divides a planar ANCF cable element into straight segments, for contact with circles", MarkerBodyCable2DShape_rows, {},
     "\nExample:\n    # a circle of radius 0.2, pressed with 10 N against 1000 N/m of a segment that is 0.05 above the axis of a fixed cable\n    nodes = [mbs.AddNode(NodePoint2DSlope1(referenceCoordinates=[x, 0, 1, 0])) for x in (0, 1.5)]\n    cable = mbs.AddObject(Cable2D(physicsLength=1.5, physicsMassPerLength=1, physicsBendingStiffness=1, physicsAxialStiffness=1, nodeNumbers=nodes))\n    ground = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.AddNode(NodePointGround()), coordinate=0))\n    center = mbs.AddNode(NodePoint2D(referenceCoordinates=[0.75, 0.25]))\n    for node, count in [(nodes[0], 4), (nodes[1], 4), (center, 1)]:\n        for coordinate in range(count):\n            fixed = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=node, coordinate=coordinate))\n            mbs.AddObject(CoordinateConstraint(markerNumbers=[ground, fixed]))\n    circle = mbs.AddMarker(MarkerBodyPosition(bodyNumber=mbs.AddObject(MassPoint2D(physicsMass=1, nodeNumber=center))))\n    shape = mbs.AddMarker(MarkerBodyCable2DShape(bodyNumber=cable, numberOfSegments=3, verticalOffset=0.05))\n    gaps = mbs.AddNode(NodeGenericData(numberOfDataCoordinates=3, initialCoordinates=[1, 0, 1]))\n    mbs.AddObject(ObjectContactCircleCable2D(markerNumbers=[circle, shape], nodeNumber=gaps, numberOfContactSegments=3, contactStiffness=1000,\n                                             circleRadius=0.2))\n    mbs.AddLoad(Force(markerNumber=circle, loadVector=[0, -10, 0]))\n    mbs.Assemble()\n    mbs.SolveStatic()\n    result = mbs.GetNodeOutput(center, exu.OutputVariableType.Position)[1]\n\nPage: reference/items/markers/body_cable_2d_shape.html\n"},
    {"A marker on the mass of a body, for loads that are proportional to mass such as gravity", MarkerBodyMass_rows, {},
     "\nExample:\n    # free fall of a body whose center of mass is not its reference point: no rotation, the reference point falls g / 2\n    node = mbs.AddNode(NodeRigidBodyRxyz())\n    body = mbs.AddObject(RigidBody(physicsMass=2, physicsInertia=[1, 1, 1.5, 0, 0, 0], physicsCenterOfMass=[0.5, 0, 0], nodeNumber=node))\n    marker = mbs.AddMarker(MarkerBodyMass(bodyNumber=body))\n    mbs.AddLoad(LoadMassProportional(markerNumber=marker, loadVector=[0, 0, -9.81]))\n    mbs.Assemble()\n    mbs.SolveDynamic()\n    result = mbs.GetNodeOutput(node, exu.OutputVariableType.Coordinates)[[2, 4]]\n\nPage: reference/items/markers/body_mass.html\n"},
    {"A marker at a point that is fixed to a body, with its position but without orientation", MarkerBodyPosition_rows, {},
     "\nExample:\n    # local point (1, 0) of a body turned by 90 degrees: it is 1 above the reference point, moves with 2 rad/s, and gives a force a lever of 1\n    node = mbs.AddNode(NodeRigidBody2D(referenceCoordinates=[0, 1, np.pi / 2], initialVelocities=[0, 0, 2]))\n    body = mbs.AddObject(RigidBody2D(physicsMass=1, physicsInertia=1, nodeNumber=node))\n    marker = mbs.AddMarker(MarkerBodyPosition(bodyNumber=body, localPosition=[1, 0, 0]))\n    mbs.AddLoad(Force(markerNumber=marker, loadVector=[-4, 0, 0]))\n    mbs.Assemble()\n    position = mbs.GetMarkerOutput(marker, exu.OutputVariableType.Position)\n    velocity = mbs.GetMarkerOutput(marker, exu.OutputVariableType.Velocity)\n    settings = exu.SimulationSettings()\n    settings.timeIntegration.endTime = 1e-6\n    settings.timeIntegration.numberOfSteps = 1\n    mbs.SolveDynamic(settings)\n    acceleration = mbs.GetNodeOutput(node, exu.OutputVariableType.Coordinates_tt)\n    result = [position[0], position[1], velocity[0], acceleration[2]]\n\nPage: reference/items/markers/body_position.html\n"},
    {"A marker at a point that is fixed to a body, with its position and orientation", MarkerBodyRigid_rows, {},
     "\nExample:\n    # a follower force of 4 N at a lever of 1 m and a torque of -2 Nm on inertia 1: angle (4 - 2) / 2 after 1 s\n    node = mbs.AddNode(NodeRigidBody2D())\n    body = mbs.AddObject(RigidBody2D(physicsMass=1, physicsInertia=1, nodeNumber=node))\n    marker = mbs.AddMarker(MarkerBodyRigid(bodyNumber=body, localPosition=[1, 0, 0]))\n    mbs.AddLoad(Force(markerNumber=marker, loadVector=[0, 4, 0], bodyFixed=True))\n    mbs.AddLoad(Torque(markerNumber=marker, loadVector=[0, 0, -2]))\n    mbs.Assemble()\n    mbs.SolveDynamic()\n    result = [mbs.GetNodeOutput(node, exu.OutputVariableType.Coordinates)[2],\n              mbs.GetMarkerOutput(marker, exu.OutputVariableType.Rotation)[2]]\n\nPage: reference/items/markers/body_rigid.html\n"},
    {"A marker at a point that is fixed to a link of a kinematic tree, with position and orientation", MarkerKinematicTreeRigid_rows, {},
     "\nExample:\n    # a force of 5 N across the end of an arm of 2 m, held by a spring in its joint, turns it to 0.5 rad: 5 * 2 * cos(0.5) = k * 0.5\n    node = mbs.AddNode(NodeGenericODE2(referenceCoordinates=[0], initialCoordinates=[0], initialCoordinates_t=[0], numberOfODE2Coordinates=1))\n    tree = mbs.AddObject(ObjectKinematicTree(nodeNumber=node, jointTypes=[exu.JointType.RevoluteZ], linkParents=[-1],\n                                             jointTransformations=exu.Matrix3DList([np.eye(3)]), jointOffsets=exu.Vector3DList([[0, 0, 0]]),\n                                             linkInertiasCOM=exu.Matrix3DList([np.eye(3)]), linkCOMs=exu.Vector3DList([[1, 0, 0]]), linkMasses=[1],\n                                             jointPControlVector=[20 * np.cos(0.5)], jointPositionOffsetVector=[0]))\n    marker = mbs.AddMarker(MarkerKinematicTreeRigid(objectNumber=tree, linkNumber=0, localPosition=[2, 0, 0]))\n    mbs.AddLoad(Force(markerNumber=marker, loadVector=[0, 5, 0]))\n    mbs.Assemble()\n    mbs.SolveStatic()\n    result = mbs.GetNodeOutput(node, exu.OutputVariableType.Coordinates)\n\nPage: reference/items/markers/kinematic_tree_rigid.html\n"},
    {"A marker on a single coordinate of a node", MarkerNodeCoordinate_rows, {},
     "\nExample:\n    # a load on coordinate 1 of a node acts in direction y: y = 6 / (2 * 1)\n    node = mbs.AddNode(NodePoint())\n    mbs.AddObject(MassPoint(physicsMass=1, nodeNumber=node))\n    marker = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=node, coordinate=1))\n    mbs.AddLoad(LoadCoordinate(markerNumber=marker, load=6))\n    mbs.Assemble()\n    mbs.SolveDynamic()\n    result = mbs.GetNodeOutput(node, exu.OutputVariableType.Displacement)\n\nPage: reference/items/markers/node_coordinate.html\n"},
    {"A marker on all coordinates of a node, as a vector", MarkerNodeCoordinates_rows, {},
     "\nExample:\n    # a mass of 2 kg on the line x = y under a force of 8 N downwards: x'' = y'' = -2, multiplier 4\n    groundNode = mbs.AddNode(NodePointGround())\n    node = mbs.AddNode(NodePoint(referenceCoordinates=[1, 1, 0]))\n    mbs.AddObject(MassPoint(physicsMass=2, nodeNumber=node))\n    m0 = mbs.AddMarker(MarkerNodeCoordinates(nodeNumber=groundNode))\n    m1 = mbs.AddMarker(MarkerNodeCoordinates(nodeNumber=node))\n    line = mbs.AddObject(CoordinateVectorConstraint(markerNumbers=[m0, m1], scalingMarker1=np.array([[1, -1, 0]])))\n    mPoint = mbs.AddMarker(MarkerNodePosition(nodeNumber=node))\n    mbs.AddLoad(Force(markerNumber=mPoint, loadVector=[0, -8, 0]))\n    mbs.Assemble()\n    mbs.SolveDynamic()\n    result = np.append(mbs.GetNodeOutput(node, exu.OutputVariableType.Displacement),\n                       mbs.GetObjectOutput(line, exu.OutputVariableType.Force))\n\nPage: reference/items/markers/node_coordinates.html\n"},
    {"A marker on a single coordinate of a node with first order equations", MarkerNodeODE1Coordinate_rows, {},
     "\nExample:\n    # y0' = 0, y1' = 3: the load is the right-hand side\n    node = mbs.AddNode(NodeGenericODE1(referenceCoordinates=[0, 0], initialCoordinates=[0, 0], numberOfODE1Coordinates=2))\n    mbs.AddObject(ObjectGenericODE1(nodeNumbers=[node], systemMatrix=np.zeros((2, 2)), rhsVector=[0, 0]))\n    marker = mbs.AddMarker(MarkerNodeODE1Coordinate(nodeNumber=node, coordinate=1))\n    mbs.AddLoad(LoadCoordinate(markerNumber=marker, load=3))\n    mbs.Assemble()\n    mbs.SolveDynamic(solverType=exu.DynamicSolverType.RK44)\n    result = mbs.GetNodeOutput(node, exu.OutputVariableType.Coordinates)\n\nPage: reference/items/markers/node_ode1_coordinate.html\n"},
    {"A marker at the position of a node", MarkerNodePosition_rows, {},
     "\nExample:\n    # a mass of 2 kg under a constant force: displacement = force / (2 m)\n    node = mbs.AddNode(NodePoint(referenceCoordinates=[1, 1, 0], initialVelocities=[0, 2, 0]))\n    mbs.AddObject(MassPoint(physicsMass=2, nodeNumber=node))\n    marker = mbs.AddMarker(MarkerNodePosition(nodeNumber=node))\n    mbs.AddLoad(Force(markerNumber=marker, loadVector=[0, 0, -8]))\n    mbs.Assemble()\n    mbs.SolveDynamic()\n    result = mbs.GetMarkerOutput(marker, exu.OutputVariableType.Position)\n\nPage: reference/items/markers/node_position.html\n"},
    {"A marker at a node with position and orientation", MarkerNodeRigid_rows, {},
     "\nExample:\n    # force and torque at the center of mass act independently: 1 N on 1 kg, -6 Nm on inertia 2\n    node = mbs.AddNode(NodeRigidBody2D())\n    mbs.AddObject(RigidBody2D(physicsMass=1, physicsInertia=2, nodeNumber=node))\n    marker = mbs.AddMarker(MarkerNodeRigid(nodeNumber=node))\n    mbs.AddLoad(Force(markerNumber=marker, loadVector=[1, 0, 0]))\n    mbs.AddLoad(Torque(markerNumber=marker, loadVector=[0, 0, -6]))\n    mbs.Assemble()\n    mbs.SolveDynamic()\n    result = mbs.GetNodeOutput(node, exu.OutputVariableType.Coordinates)[[0, 2]]\n\nPage: reference/items/markers/node_rigid.html\n"},
    {"A marker on the rotation of a node about one global axis", MarkerNodeRotationCoordinate_rows, {},
     "\nExample:\n    # a torque of 4 Nm about z on inertia 2: angle 4 / (2 * 2) after 1 s\n    node = mbs.AddNode(NodeRigidBodyRxyz())\n    mbs.AddObject(RigidBody(physicsMass=1, physicsInertia=[1, 1, 2, 0, 0, 0], nodeNumber=node))\n    marker = mbs.AddMarker(MarkerNodeRotationCoordinate(nodeNumber=node, rotationCoordinate=2))\n    mbs.AddLoad(LoadCoordinate(markerNumber=marker, load=4))\n    mbs.Assemble()\n    mbs.SolveDynamic()\n    result = mbs.GetNodeOutput(node, exu.OutputVariableType.Rotation)[2]\n\nPage: reference/items/markers/node_rotation_coordinate.html\n"},
    {"A marker on all second order coordinates of an object, as a vector", MarkerObjectODE2Coordinates_rows, {},
     "\nExample:\n    # two points on springs 2 and 4 along x; the sum of their displacements is 3: forces on both springs are equal\n    points = [mbs.AddNode(NodePoint(referenceCoordinates=[x, 0, 0])) for x in (0, 1)]\n    body = mbs.AddObject(ObjectGenericODE2(nodeNumbers=points, stiffnessMatrix=np.diag([2, 1, 1, 4, 1, 1])))\n    ground = mbs.AddMarker(MarkerNodeCoordinates(nodeNumber=mbs.AddNode(NodePointGround())))\n    marker = mbs.AddMarker(MarkerObjectODE2Coordinates(objectNumber=body))\n    mbs.AddObject(CoordinateVectorConstraint(markerNumbers=[ground, marker], scalingMarker1=np.array([[1, 0, 0, 1, 0, 0]]),\n                                             offset=[4]))  # x of the references included\n    mbs.Assemble()\n    mbs.SolveStatic()\n    result = [mbs.GetNodeOutput(point, exu.OutputVariableType.Displacement)[0] for point in points]\n\nPage: reference/items/markers/object_ode2_coordinates.html\n"},
    {"A marker at the weighted mean position of mesh nodes of a super element", MarkerSuperElementPosition_rows, {},
     "\nExample:\n    # a force of 8 N at a marker with weights 1/4 and 3/4 on two free masses of 1 kg: accelerations 2 and 6\n    nodes = [mbs.AddNode(NodePoint()), mbs.AddNode(NodePoint(referenceCoordinates=[1, 0, 0]))]\n    body = mbs.AddObject(ObjectGenericODE2(nodeNumbers=nodes, massMatrix=np.eye(6)))\n    marker = mbs.AddMarker(MarkerSuperElementPosition(bodyNumber=body, meshNodeNumbers=[0, 1], weightingFactors=[0.25, 0.75]))\n    mbs.AddLoad(Force(markerNumber=marker, loadVector=[8, 0, 0]))\n    mbs.Assemble()\n    mbs.SolveDynamic()\n    result = [mbs.GetNodeOutput(nodes[0], exu.OutputVariableType.Displacement)[0],\n              mbs.GetNodeOutput(nodes[1], exu.OutputVariableType.Displacement)[0],\n              mbs.GetMarkerOutput(marker, exu.OutputVariableType.Position)[0]]\n\nPage: reference/items/markers/super_element_position.html\n"},
    {"A marker with the weighted mean position and rotation of mesh nodes of a super element", MarkerSuperElementRigid_rows, {},
     "\nExample:\n    # a square of four points on springs of 5 N/m each: a force of 5 N moves it by 5 / 20, a torque of 2 Nm turns its mean by\n    # 2 / (4 * 5 * 1)\n    corners = [[1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0]]\n    nodes = [mbs.AddNode(NodePoint(referenceCoordinates=c)) for c in corners]\n    body = mbs.AddObject(ObjectGenericODE2(nodeNumbers=nodes, massMatrix=np.eye(12), stiffnessMatrix=5 * np.eye(12),\n                                           visualization=VObjectGenericODE2(triangleMesh=[[0, 1, 2], [0, 2, 3]])))\n    marker = mbs.AddMarker(MarkerSuperElementRigid(bodyNumber=body, meshNodeNumbers=[0, 1, 2, 3], weightingFactors=[0.25] * 4,\n                                                   rotationsExponentialMap=0))\n    mbs.AddLoad(Force(markerNumber=marker, loadVector=[5, 0, 0]))\n    mbs.AddLoad(Torque(markerNumber=marker, loadVector=[0, 0, 2]))\n    mbs.Assemble()\n    mbs.SolveStatic()\n    position = mbs.GetMarkerOutput(marker, exu.OutputVariableType.Position)\n    result = [position[0], position[1], mbs.GetMarkerOutput(marker, exu.OutputVariableType.RotationMatrix)[3]]\n\nPage: reference/items/markers/super_element_rigid.html\n"},
    {"A generalized force on a single coordinate", LoadCoordinate_rows, {},
     "\nUser functions:\n    loadUserFunction(mbs, t, load)\n        computes the generalized force at time t; called at every evaluation of the residual; static solutions multiply neither the argument nor the returned value with the load factor; they increase t with the load factor instead\n\nExample:\n    # load 6 t on a mass of 1 kg: x = t^3; second order method, step 0.001\n    def UFload(mbs, t, load):\n        return load * t\n\n    node = mbs.AddNode(Node1D())\n    mbs.AddObject(Mass1D(physicsMass=1, nodeNumber=node))\n    marker = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=node, coordinate=0))\n    mbs.AddLoad(LoadCoordinate(markerNumber=marker, load=6, loadUserFunction=UFload))\n    mbs.Assemble()\n    settings = exu.SimulationSettings()\n    settings.timeIntegration.numberOfSteps = 1000\n    mbs.SolveDynamic(settings)\n    result = mbs.GetNodeOutput(node, exu.OutputVariableType.Coordinates)\n\nPage: reference/items/loads/coordinate.html\n"},
    {"A force vector at a point of a body or at a node", LoadForceVector_rows, {},
     "\nUser functions:\n    loadVectorUserFunction(mbs, t, loadVector)\n        computes the force vector at time t; called at every evaluation of the residual; static solutions multiply neither the argument nor the returned value with the load factor; they increase t with the load factor instead\n\nCreated by: mbs.CreateForce(...), mbs.CreateForceFromTable(...)\n\nExample:\n    # constant force on 2 kg: displacement = force / (2 m)\n    node = mbs.AddNode(NodePoint())\n    mbs.AddObject(MassPoint(physicsMass=2, nodeNumber=node))\n    marker = mbs.AddMarker(MarkerNodePosition(nodeNumber=node))\n    mbs.AddLoad(LoadForceVector(markerNumber=marker, loadVector=[4, -8, 12]))\n    mbs.Assemble()\n    mbs.SolveDynamic()\n    result = mbs.GetNodeOutput(node, exu.OutputVariableType.Displacement)\n\nPage: reference/items/loads/force_vector.html\n"},
    {"A distributed load proportional to mass, such as gravity", LoadMassProportional_rows, {},
     "\nUser functions:\n    loadVectorUserFunction(mbs, t, loadVector)\n        computes the force per mass at time t; called at every evaluation of the residual; static solutions multiply neither the argument nor the returned value with the load factor; they increase t with the load factor instead\n\nExample:\n    # free fall from rest, the same for every mass: g / 2 after 1 s\n    nodes = []\n    for mass in (1, 10):\n        node = mbs.AddNode(NodePoint())\n        body = mbs.AddObject(MassPoint(physicsMass=mass, nodeNumber=node))\n        marker = mbs.AddMarker(MarkerBodyMass(bodyNumber=body))\n        mbs.AddLoad(LoadMassProportional(markerNumber=marker, loadVector=[0, 0, -9.81]))\n        nodes.append(node)\n    mbs.Assemble()\n    mbs.SolveDynamic()\n    result = [mbs.GetNodeOutput(node, exu.OutputVariableType.Position)[2] for node in nodes]\n\nPage: reference/items/loads/mass_proportional.html\n"},
    {"A torque vector on a body or node with orientation", LoadTorqueVector_rows, {},
     "\nUser functions:\n    loadVectorUserFunction(mbs, t, loadVector)\n        computes the torque vector at time t; called at every evaluation of the residual; static solutions multiply neither the argument nor the returned value with the load factor; they increase t with the load factor instead\n\nCreated by: mbs.CreateTorque(...), mbs.CreateTorqueFromTable(...)\n\nExample:\n    # 3 Nm about z on a planar body of inertia 2: angle 3 / (2 * 2); 3 Nm about x on a body with J_xx = 1: angular velocity 3\n    node = mbs.AddNode(NodeRigidBody2D())\n    mbs.AddObject(RigidBody2D(physicsMass=1, physicsInertia=2, nodeNumber=node))\n    node1 = mbs.AddNode(NodeRigidBodyRxyz())\n    mbs.AddObject(RigidBody(physicsMass=1, physicsInertia=[1, 2, 3, 0, 0, 0], nodeNumber=node1))\n    mbs.AddLoad(LoadTorqueVector(markerNumber=mbs.AddMarker(MarkerNodeRigid(nodeNumber=node)), loadVector=[0, 0, 3]))\n    mbs.AddLoad(LoadTorqueVector(markerNumber=mbs.AddMarker(MarkerNodeRigid(nodeNumber=node1)), loadVector=[3, 0, 0], bodyFixed=True))\n    mbs.Assemble()\n    mbs.SolveDynamic()\n    result = [mbs.GetNodeOutput(node, exu.OutputVariableType.Coordinates)[2],\n              mbs.GetNodeOutput(node1, exu.OutputVariableType.AngularVelocity)[0]]\n\nPage: reference/items/loads/torque_vector.html\n"},
    {"Measures an output variable of a body at a local position", SensorBody_rows, {},
     "\nExample:\n    # velocity of the point (0, 0.5) of a body that translates with (0, 1) and turns with 3 rad/s\n    node = mbs.AddNode(NodeRigidBody2D(initialVelocities=[0, 1, 3]))\n    body = mbs.AddObject(RigidBody2D(physicsMass=1, physicsInertia=1, nodeNumber=node))\n    sensor = mbs.AddSensor(SensorBody(bodyNumber=body, localPosition=[0, 0.5, 0], outputVariableType=exu.OutputVariableType.Velocity))\n    mbs.Assemble()\n    result = mbs.GetSensorValues(sensor)\n\nPage: reference/items/sensors/body.html\n"},
    {"Measures an output variable of a link of a kinematic tree at a local position", SensorKinematicTree_rows, {},
     "\nExample:\n    # two arms of 1 m: the first has been turned by 90 degrees, the second back again; a point in the middle of the second\n    node = mbs.AddNode(NodeGenericODE2(referenceCoordinates=[np.pi / 2, 0], initialCoordinates=[0, -np.pi / 2], initialCoordinates_t=[0, 0],\n                                       numberOfODE2Coordinates=2))\n    tree = mbs.AddObject(ObjectKinematicTree(nodeNumber=node, jointTypes=[exu.JointType.RevoluteZ] * 2, linkParents=[-1, 0],\n                                             jointTransformations=exu.Matrix3DList([np.eye(3)] * 2),\n                                             jointOffsets=exu.Vector3DList([[0, 0, 0], [1, 0, 0]]), linkInertiasCOM=exu.Matrix3DList([np.eye(3)] * 2),\n                                             linkCOMs=exu.Vector3DList([[0.5, 0, 0]] * 2), linkMasses=[1, 1]))\n    sensor = mbs.AddSensor(SensorKinematicTree(objectNumber=tree, linkNumber=1, localPosition=[0.5, 0, 0],\n                                               outputVariableType=exu.OutputVariableType.Position))\n    mbs.Assemble()\n    result = mbs.GetSensorValues(sensor)\n\nPage: reference/items/sensors/kinematic_tree.html\n"},
    {"Measures the value of a load", SensorLoad_rows, {},
     "\nExample:\n    # a load that grows with time, at the end of the simulation\n    def UFforce(mbs, t, loadVector):\n        return [0, 3 * t, 0]\n\n    node = mbs.AddNode(NodePoint())\n    mbs.AddObject(MassPoint(physicsMass=1, nodeNumber=node))\n    marker = mbs.AddMarker(MarkerNodePosition(nodeNumber=node))\n    load = mbs.AddLoad(Force(markerNumber=marker, loadVectorUserFunction=UFforce))\n    sensor = mbs.AddSensor(SensorLoad(loadNumber=load, storeInternal=True))\n    mbs.Assemble()\n    mbs.SolveDynamic()\n    result = mbs.GetSensorStoredData(sensor)[-1, 1:]\n\nPage: reference/items/sensors/load.html\n"},
    {"Measures an output variable of a marker", SensorMarker_rows, {},
     "\nExample:\n    # position of the end of a rod that is turned by 90 degrees\n    node = mbs.AddNode(NodeRigidBody2D(initialCoordinates=[0, 0, np.pi / 2]))\n    rod = mbs.AddObject(RigidBody2D(physicsMass=1, physicsInertia=1, nodeNumber=node))\n    marker = mbs.AddMarker(MarkerBodyPosition(bodyNumber=rod, localPosition=[1, 0, 0]))\n    sensor = mbs.AddSensor(SensorMarker(markerNumber=marker, outputVariableType=exu.OutputVariableType.Position))\n    mbs.Assemble()\n    result = mbs.GetSensorValues(sensor)\n\nPage: reference/items/sensors/marker.html\n"},
    {"Measures an output variable of a node", SensorNode_rows, {},
     "\nExample:\n    # position of a mass that moves with constant velocity, from memory: last row, without the time\n    node = mbs.AddNode(NodePoint(referenceCoordinates=[1, 0, 0], initialVelocities=[0, 2, 0]))\n    mbs.AddObject(MassPoint(physicsMass=1, nodeNumber=node))\n    sensor = mbs.AddSensor(SensorNode(nodeNumber=node, outputVariableType=exu.OutputVariableType.Position, storeInternal=True))\n    mbs.Assemble()\n    mbs.SolveDynamic()\n    result = mbs.GetSensorStoredData(sensor)[-1, 1:]\n\nPage: reference/items/sensors/node.html\n"},
    {"Measures an output variable of a connector, constraint, joint or contact", SensorObject_rows, {},
     "\nExample:\n    # force of a spring of 100 N/m that is compressed by 0.2 m\n    ground = mbs.AddObject(ObjectGround())\n    node = mbs.AddNode(NodePoint(referenceCoordinates=[0.8, 0, 0]))\n    mbs.AddObject(MassPoint(physicsMass=1, nodeNumber=node))\n    mGround = mbs.AddMarker(MarkerBodyPosition(bodyNumber=ground))\n    mBody = mbs.AddMarker(MarkerNodePosition(nodeNumber=node))\n    spring = mbs.AddObject(SpringDamper(markerNumbers=[mGround, mBody], referenceLength=1, stiffness=100))\n    sensor = mbs.AddSensor(SensorObject(objectNumber=spring, outputVariableType=exu.OutputVariableType.ForceLocal))\n    mbs.Assemble()\n    result = mbs.GetSensorValues(sensor)\n\nPage: reference/items/sensors/object.html\n"},
    {"Measures an output variable at a mesh node of a super element", SensorSuperElement_rows, {},
     "\nExample:\n    # position of the second of two mesh nodes\n    nodes = [mbs.AddNode(NodePoint()), mbs.AddNode(NodePoint(referenceCoordinates=[1, 0, 0], initialCoordinates=[0, 0.5, 0]))]\n    body = mbs.AddObject(ObjectGenericODE2(nodeNumbers=nodes, massMatrix=np.eye(6),\n                                           stiffnessMatrix=np.kron([[1, -1], [-1, 1]], np.eye(3))))\n    sensor = mbs.AddSensor(SensorSuperElement(bodyNumber=body, meshNodeNumber=1, outputVariableType=exu.OutputVariableType.Position))\n    mbs.Assemble()\n    result = mbs.GetSensorValues(sensor)\n\nPage: reference/items/sensors/super_element.html\n"},
    {"Computes its values by a Python function, for instance from other sensors", SensorUserFunction_rows, {},
     "\nUser functions:\n    sensorUserFunction(mbs, t, sensorNumbers, factors, configuration)\n        computes the values of the sensor; called whenever the sensor is measured or evaluated\n\nCreated by: mbs.CreateDistanceSensor(...)\n\nExample:\n    # half the length of the position vector (3, 4)\n    def UFlength(mbs, t, sensorNumbers, factors, configuration):\n        return [factors[0] * np.linalg.norm(mbs.GetSensorValues(sensorNumbers[0]))]\n\n    node = mbs.AddNode(NodePoint(referenceCoordinates=[3, 4, 0]))\n    mbs.AddObject(MassPoint(physicsMass=1, nodeNumber=node))\n    position = mbs.AddSensor(SensorNode(nodeNumber=node, outputVariableType=exu.OutputVariableType.Position))\n    sensor = mbs.AddSensor(SensorUserFunction(sensorNumbers=[position], factors=[0.5], sensorUserFunction=UFlength))\n    mbs.Assemble()\n    result = mbs.GetSensorValues(sensor)\n\nPage: reference/items/sensors/user_function.html\n"},
}};

}  // namespace item_texts_of

std::span<const ItemText> own_item_texts() { return item_texts_of::all; }

}  // namespace dalembert
