// Generated from specs/ by codegen/templates/item_texts.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/reflection/item_texts.hpp"

#include <array>

namespace dalembert {
namespace item_texts_of {

constexpr std::array<std::string_view, 5> NodeGenericAE_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "reference values; as many as ``numberOfAECoordinates``, any other length is refused; units as in the equations that use the node",
    "start values of the solver, relative to the reference values; as many as ``numberOfAECoordinates``",
    "number of algebraic variables; at least 1",
    "True: the item is drawn",
};
constexpr std::array<OutputText, 1> NodeGenericAE_outputs{{
    {"Coordinates", 0, "various", "algebraic variables, relative to the reference values"},
}};

constexpr std::array<std::string_view, 4> NodeGenericData_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "values at the start of a computation; as many as ``numberOfDataCoordinates``, or none for zeros; any other length is refused; their meaning and units are those of the object that uses the node",
    "number of data variables; objects that need a data node say how many they expect",
    "True: the item is drawn",
};
constexpr std::array<OutputText, 1> NodeGenericData_outputs{{
    {"Coordinates", 0, "various", "data variables; there are no reference values and no time derivatives"},
}};

constexpr std::array<std::string_view, 5> NodeGenericODE1_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "constant values to which the coordinates are added; as many as ``numberOfODE1Coordinates``, or none for zeros; any other length is refused; units as in the equations that use the node",
    "values at the start, relative to the reference values; as many as ``numberOfODE1Coordinates``",
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
    "constant values to which the coordinates are added; as many as ``numberOfODE2Coordinates``, or none for zeros; any other length is refused; units as in the equations that use the node",
    "values at the start, relative to the reference values; as many as ``numberOfODE2Coordinates``",
    "time derivatives of the coordinates at the start; as many as ``numberOfODE2Coordinates``",
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
constexpr std::array<OutputText, 12> NodePoint_outputs{{
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
constexpr std::array<OutputText, 12> NodePoint2D_outputs{{
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
constexpr std::array<OutputText, 10> NodePointGround_outputs{{
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
constexpr std::array<OutputText, 12> NodePointSlope12_outputs{{
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
constexpr std::array<OutputText, 12> NodePointSlope23_outputs{{
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
constexpr std::array<OutputText, 13> NodeRigidBody2D_outputs{{
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
}};

constexpr std::array<std::string_view, 8> NodeRigidBodyEP_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "position of the reference point (m) and four Euler parameters (1), the scalar one first; their norm must be 1, so that the default of zeros is refused; [1, 0, 0, 0] is no rotation",
    "displacement (m) and change of the Euler parameters (1) at the start; the sum of reference and initial Euler parameters must have norm 1",
    "velocity (m/s) and time derivatives of the Euler parameters (1/s) at the start; for a given angular velocity they are :math:`\\tfrac{1}{4}\\, {}^{b}\\mathbf{G}^{\\mathsf{T}}\\, {}^{b}\\boldsymbol{\\omega}`",
    "true: the node adds the equation that keeps the norm of the Euler parameters, with one algebraic variable; false: the norm has to be kept by a constraint of the model",
    "False: the item is not drawn",
    "size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 13> NodeRigidBodyEP_outputs{{
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
constexpr std::array<OutputText, 11> NodeRigidBodyRotVecLG_outputs{{
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
constexpr std::array<OutputText, 13> NodeRigidBodyRxyz_outputs{{
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
constexpr std::array<OutputText, 5> ObjectGround_outputs{{
    {"Position", 3, "m", "global position of the local point"},
    {"Displacement", 3, "m", "zero"},
    {"Velocity", 3, "m/s", "zero"},
    {"AngularVelocity", 3, "rad/s", "zero"},
    {"RotationMatrix", 9, "1", "rotation matrix from the body frame to the global frame, row by row"},
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
constexpr std::array<OutputText, 7> ObjectMass1D_outputs{{
    {"Position", 3, "m", "global position vector"},
    {"Displacement", 3, "m", "global position minus the global position in the reference configuration"},
    {"Velocity", 3, "m/s", "global velocity"},
    {"RotationMatrix", 9, "1", "the parameter ``referenceRotation``, row by row"},
    {"Rotation", 3, "rad", "Tait-Bryan angles of the rotation matrix, for rotations about x, y and z in turn"},
    {"AngularVelocity", 3, "rad/s", "zero"},
    {"AngularVelocityLocal", 3, "rad/s", "zero"},
}};

constexpr std::array<std::string_view, 5> ObjectMassPoint_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "mass; zero is allowed if something else makes the equations of the node regular",
    "node with a position in space and three displacement coordinates",
    "False: the item is not drawn",
    "shapes attached to the body frame, as made by the functions of the graphics module",
};
constexpr std::array<OutputText, 8> ObjectMassPoint_outputs{{
    {"Position", 3, "m", "global position of the local point"},
    {"Displacement", 3, "m", "global displacement, the same for all local points"},
    {"Velocity", 3, "m/s", "global velocity"},
    {"Acceleration", 3, "m/s^2", "global acceleration"},
    {"RotationMatrix", 9, "1", "identity matrix, row by row, as the body does not rotate"},
    {"Rotation", 3, "rad", "zero, as the body does not rotate; there for completeness"},
    {"AngularVelocity", 3, "rad/s", "zero, as the body does not rotate; there for completeness"},
    {"AngularVelocityLocal", 3, "rad/s", "zero, as the body does not rotate; there for completeness"},
}};

constexpr std::array<std::string_view, 5> ObjectMassPoint2D_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "mass; zero is allowed if something else makes the equations of the node regular",
    "node with a position in the plane and two displacement coordinates",
    "False: the item is not drawn",
    "shapes attached to the body frame, as made by the functions of the graphics module",
};
constexpr std::array<OutputText, 8> ObjectMassPoint2D_outputs{{
    {"Position", 3, "m", "global position of the local point"},
    {"Displacement", 3, "m", "global displacement, the same for all local points; the third component is zero"},
    {"Velocity", 3, "m/s", "global velocity; the third component is zero"},
    {"Acceleration", 3, "m/s^2", "global acceleration; the third component is zero"},
    {"RotationMatrix", 9, "1", "identity matrix, row by row, as the body does not rotate"},
    {"Rotation", 3, "rad", "zero, as the body does not rotate; there for completeness"},
    {"AngularVelocity", 3, "rad/s", "zero, as the body does not rotate; there for completeness"},
    {"AngularVelocityLocal", 3, "rad/s", "zero, as the body does not rotate; there for completeness"},
}};

constexpr std::array<std::string_view, 8> ObjectRigidBody_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "mass",
    "components :math:`[J_{xx}, J_{yy}, J_{zz}, J_{yz}, J_{xz}, J_{xy}]` of the inertia tensor in the body frame about the reference point, which is the node, and not about the center of mass; off-diagonal components are those of the tensor, :math:`J_{xy} = -\\int x y \\,\\mathrm{d}m`",
    "position of the center of mass in the body frame, counted from the node",
    "node of a rigid body in space",
    "False: the item is not drawn",
    "function that returns the shapes to be drawn, called at every redraw; shapes are given in the frame of the body",
    "shapes attached to the body frame, as made by the functions of the graphics module",
};
constexpr std::array<OutputText, 12> ObjectRigidBody_outputs{{
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
constexpr std::array<OutputText, 12> ObjectRigidBody2D_outputs{{
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
constexpr std::array<OutputText, 7> ObjectRotationalMass1D_outputs{{
    {"Position", 3, "m", "global position of the local point, which turns with the body"},
    {"Displacement", 3, "m", "global position minus the global position in the reference configuration"},
    {"Velocity", 3, "m/s", "global velocity"},
    {"RotationMatrix", 9, "1", "rotation matrix from the body frame to the global frame, row by row"},
    {"Rotation", 1, "rad", "angle about the axis, including its reference value; not reduced to one turn"},
    {"AngularVelocity", 3, "rad/s", "angular velocity in global coordinates"},
    {"AngularVelocityLocal", 3, "rad/s", "angular velocity in body coordinates; only the third component is not zero"},
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
constexpr std::array<OutputText, 4> ObjectFFRF_outputs{{
    {"Coordinates", 0, "various", "coordinates of all nodes of the object, relative to the reference values"},
    {"Coordinates_t", 0, "various", "first time derivatives of the coordinates of all nodes"},
    {"Coordinates_tt", 0, "various", "second time derivatives of the coordinates of all nodes"},
    {"Force", 0, "various", "generalized forces of the object without inertia, one per coordinate, as they stand on the left hand side of the equations of motion"},
}};

constexpr std::array<std::string_view, 28> ObjectFFRFreducedOrder_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "two nodes: the rigid body node of the body frame, and a ``NodeGenericODE2`` with the modal coordinates, whose reference coordinates are zero",
    "modal mass matrix, one row and column per mode, dense or sparse",
    "modal stiffness matrix, one row and column per mode, dense or sparse; empty for zero",
    "modal damping matrix, one row and column per mode; empty for zero",
    "function that gives generalized forces on the right hand side",
    "function that gives an additional mass matrix for all coordinates; its dependence on them is left out of the tangent",
    "True: the object computes inertia with its coupling of rigid body motion and deformation, stiffness and damping; False: nothing acts but what the user functions give",
    "one column per mode, three rows per mesh node: displacements of the mesh in the body frame for a unit modal coordinate",
    "values of an output variable per unit modal coordinate, one row per mesh node; for each mode six columns, one per component; empty: none",
    "output variable that ``outputVariableModeBasis`` holds: ``StressLocal``, ``StrainLocal``, or ``_None``",
    "reference positions of the mesh nodes in the body frame, three per node",
    "leave it at False; ``Assemble()`` sets it, when it has found the parameters that follow from others",
    "total mass",
    "inertia tensor of the undeformed body about the origin of the body frame",
    "center of mass of the undeformed body in the body frame",
    "coupling of rotations and modes that changes with deformation: block :math:`i, j` is :math:`-\\int \\boldsymbol{\\psi}_i \\times \\boldsymbol{\\psi}_j\\, \\mathrm{d}m`; empty: ``Assemble()`` finds it from ``mPsiTildePsiTilde``",
    "inertia of the deformation: block :math:`i, j` is :math:`-\\int \\tilde{\\boldsymbol{\\psi}}_i \\tilde{\\boldsymbol{\\psi}}_j\\, \\mathrm{d}m`",
    "coupling of translations and modes: column :math:`j` is :math:`\\int \\boldsymbol{\\psi}_j\\, \\mathrm{d}m`",
    "the skew symmetric matrices of the columns of ``mPhitTPsi``; empty: ``Assemble()`` finds it",
    "coupling of rotations and modes: column :math:`j` is :math:`-\\int \\mathbf{x} \\times \\boldsymbol{\\psi}_j\\, \\mathrm{d}m`; empty: ``Assemble()`` finds it from ``mXRefTildePsiTilde``",
    "what deformation does to the inertia: block :math:`j` is :math:`-\\int \\tilde{\\mathbf{x}}\\, \\tilde{\\boldsymbol{\\psi}}_j\\, \\mathrm{d}m`",
    "skew symmetric matrix of the center of mass, found by ``Assemble()``",
    "user forces, a work space of the object",
    "False: the item is not drawn",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
    "surface triangles, one row with three positions in ``nodeNumbers`` each (counted from 0); empty: no surface is drawn",
    "draw the mesh nodes at their deformed positions",
};
constexpr std::array<OutputText, 3> ObjectFFRFreducedOrder_outputs{{
    {"Coordinates", 0, "various", "coordinates of both nodes, relative to the reference values"},
    {"Coordinates_t", 0, "various", "first time derivatives of the coordinates of both nodes"},
    {"Force", 0, "various", "generalized forces of the object without accelerations, one per coordinate, as they stand on the left hand side of the equations of motion: elastic forces and those that are quadratic in velocities"},
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
    "function that gives the derivatives of the user forces; without it they are found by numerical differentiation",
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
constexpr std::array<OutputText, 5> ObjectGenericODE2_outputs{{
    {"CoordinatesTotal", 0, "various", "coordinates of all nodes of the object, including the reference values"},
    {"Coordinates", 0, "various", "coordinates of all nodes of the object, relative to the reference values"},
    {"Coordinates_t", 0, "various", "first time derivatives of the coordinates of all nodes"},
    {"Coordinates_tt", 0, "various", "second time derivatives of the coordinates of all nodes"},
    {"Force", 0, "various", "generalized forces of the object without inertia, one per coordinate, as they stand on the left hand side of the equations of motion"},
}};

constexpr std::array<std::string_view, 24> ObjectKinematicTree_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "generic node of second order with one coordinate per joint: rad for revolute, m for prismatic joints",
    "gravity in global components; mass proportional loads do not act on this object",
    "global position of the base frame",
    "type of each joint, one per link; required",
    "number of the parent link of each link, -1 for the base; a parent has a smaller number than its links; required",
    "for each link the rotation matrix from its joint frame, at coordinate zero, to the frame of the parent; required",
    "for each link the origin of its joint frame in the frame of the parent, for the base in the base frame; required",
    "for each link the inertia tensor about its center of mass, in the frame of the link; required",
    "for each link the center of mass in the frame of the link; required",
    "mass of each link; required",
    "for each link a force in global components at the origin of its joint frame; empty for zero",
    "for each link a torque in global components; empty for zero",
    "for each joint a torque (Nm) or force (N) about or along its axis, positive on the link and negative on its parent; empty for zero",
    "desired joint coordinates of the position control (rad or m); empty for zero",
    "desired joint velocities of the velocity control (rad/s or m/s); empty for zero",
    "proportional gain of each joint (Nm/rad or N/m); empty for zero",
    "derivative gain of each joint (Nm s/rad or Ns/m); empty for zero",
    "function that gives further joint forces, which act as those of ``jointForceVector``",
    "False: the item is not drawn",
    "draw the links, as given by ``graphicsDataList`` or, if that is empty, as cylinders between the joints",
    "draw the joints in a standard form; only if ``graphicsDataList`` is empty",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
    "for each link a list of shapes in the frame of the link; empty, or as long as there are links",
};
constexpr std::array<OutputText, 4> ObjectKinematicTree_outputs{{
    {"Coordinates", 0, "various", "joint coordinates, including the reference values (unlike the output of the same name of the node)"},
    {"Coordinates_t", 0, "various", "joint velocities"},
    {"Coordinates_tt", 0, "various", "joint accelerations"},
    {"Force", 0, "various", "generalized forces of the object without inertia, one per coordinate, as they stand on the left hand side of the equations of motion"},
}};

constexpr std::array<std::string_view, 18> ObjectALEANCFCable2D_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "length of the element in its undeformed state; must be positive",
    "total mass per undeformed length, of the resting and the moving part",
    "share of the mass per length that moves along the axis: 1 for an axially moving beam, 0 for none, between for a pipe with fluid",
    "bending stiffness: bending moment per curvature",
    "axial stiffness: axial force per axial strain",
    "viscous damping of bending: bending moment per rate of curvature",
    "viscous damping of stretching: axial force per rate of axial strain",
    "axial strain at which the axial force is zero",
    "curvature at which the bending moment is zero; positive for a left turn along the axis",
    "true: all inertia terms of the axial motion act; false: accelerations of cable and axial coordinate are not coupled, and the latter has a constant mass",
    "true: the axial coordinate feels the change of strain and curvature energy that its motion brings about; false: this term is left out",
    "node at axial position 0, node at axial position L (both with position and slope in the plane), and a generic node of second order whose coordinate is the axial displacement of the material",
    "integration of the elastic forces along the axis: 0 with 5 Gauss points for stretching and 3 for bending; 1 with 4 and 2; 2 with 3 Lobatto points for stretching and 2 Gauss points for bending",
    "share of the strains of the reference configuration that are free of stress: 0 for an element that is straight and of length L without stress, 1 for a reference configuration without stress; values between serve for a transition",
    "False: the item is not drawn",
    "height of the rectangle that is drawn; 0 draws the axis only",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 10> ObjectALEANCFCable2D_outputs{{
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
constexpr std::array<OutputText, 9> ObjectANCFBeam_outputs{{
    {"Position", 3, "m", "global position of the local point"},
    {"Displacement", 3, "m", "global displacement of the local point"},
    {"Velocity", 3, "m/s", "global velocity of the local point"},
    {"VelocityLocal", 3, "m/s", "velocity of the local point in the frame of the cross section"},
    {"AngularVelocity", 3, "rad/s", "angular velocity of the cross section in global coordinates"},
    {"AngularVelocityLocal", 3, "rad/s", "angular velocity of the cross section in its own frame"},
    {"Acceleration", 3, "m/s^2", "global acceleration of the local point"},
    {"Rotation", 3, "rad", "Tait-Bryan angles of the frame of the cross section"},
    {"RotationMatrix", 9, "1", "rotation matrix from the frame of the cross section to the global frame, row by row"},
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
    "integration of the elastic forces along the axis: 0 with 5 Gauss points for stretching and 3 for bending; 1 with 4 and 2; 2 with 3 Lobatto points for stretching and 2 Gauss points for bending, with smoother axial forces but possibly modes without stiffness",
    "False: the item is not drawn",
    "radius of the cylinder that is drawn; 0 draws the axis only",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 9> ObjectANCFCable_outputs{{
    {"Position", 3, "m", "global position of the axis"},
    {"Displacement", 3, "m", "global displacement of the axis"},
    {"Velocity", 3, "m/s", "global velocity of the axis"},
    {"Director1", 3, "1", "slope vector of the axis; its length is 1 + axial strain"},
    {"StrainLocal", 1, "1", "axial strain of the axis"},
    {"CurvatureLocal", 3, "1/m", "curvature vector"},
    {"ForceLocal", 1, "N", "axial force, positive for tension; oscillates along the element when bending dominates"},
    {"TorqueLocal", 3, "Nm", "bending moments; there is no torsional moment"},
    {"Acceleration", 3, "m/s^2", "global acceleration of the axis"},
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
    "integration of the elastic forces along the axis: 0 with 5 Gauss points for stretching and 3 for bending; 1 with 4 and 2; 2 with 3 Lobatto points for stretching and 2 Gauss points for bending, with smoother axial forces but possibly modes without stiffness",
    "function that gives the axial force in place of the linear law",
    "function that gives the bending moment in place of the linear law",
    "False: the item is not drawn",
    "height of the rectangle that is drawn; 0 draws the axis only",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 13> ObjectANCFCable2D_outputs{{
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
    {"Acceleration", 3, "m/s^2", "global acceleration of the local point"},
    {"AngularAcceleration", 3, "rad/s^2", "angular acceleration of the cross section; only the third component is not zero"},
}};

constexpr std::array<std::string_view, 13> ObjectANCFThinPlate_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "thickness of the plate: one value, or one value per node that is interpolated",
    "mass per volume",
    "damping forces are this factor times mass matrix times velocity",
    "stiffness against the strains in the plane, integrated over the thickness; one matrix, or one per node",
    "stiffness against curvatures and twist, integrated over the thickness; one matrix, or one per node",
    "share of the strains of the reference configuration that are free of stress: 0 for a plate that is flat without stress, 1 for a reference configuration without stress",
    "for each node the length of the side in x that belongs to a unit slope, the distance of the nodes for a flat rectangle; not positive: that distance",
    "for each node the length of the side in y that belongs to a unit slope; not positive: the distance of the nodes",
    "four nodes with position and two slopes, at the local corners (-1, -1), (1, -1), (1, 1), (-1, 1)",
    "integration of the elastic forces: 0 with 4 by 4 Gauss points, 1 with 3 by 3",
    "False: the item is not drawn",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 11> ObjectANCFThinPlate_outputs{{
    {"Position", 3, "m", "global position of the local point; local coordinates run from -1 to 1, the third one over the thickness"},
    {"Displacement", 3, "m", "global displacement of the local point"},
    {"Velocity", 3, "m/s", "global velocity of the local point"},
    {"Director1", 3, "1", "slope vector in the first direction of the mid-surface"},
    {"Director2", 3, "1", "slope vector in the second direction of the mid-surface"},
    {"StrainLocal", 3, "1", "strains of the mid-surface: two normal strains and the shear strain; without what is free of stress"},
    {"CurvatureLocal", 3, "1/m", "curvatures about the x and y axis, and twice the twist of the mid-surface; without what is free of stress"},
    {"ForceLocal", 3, "N/m", "membrane forces per length, two normal forces and the shear force"},
    {"TorqueLocal", 3, "N", "moments per length, two bending moments and the twisting moment, of the curvatures along x and y"},
    {"StressLocal", 6, "N/m^2", "stress components xx, yy, zz, yz, xz, xy at the local point; those out of the plane are zero"},
    {"Acceleration", 3, "m/s^2", "global acceleration of the local point"},
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
constexpr std::array<OutputText, 6> ObjectBeamGeometricallyExact_outputs{{
    {"Position", 3, "m", "global position of the local point"},
    {"Displacement", 3, "m", "global displacement of the local point"},
    {"Velocity", 3, "m/s", "global velocity of the local point"},
    {"Rotation", 3, "rad", "Tait-Bryan angles of the frame of the cross section"},
    {"StrainLocal", 6, "1", "strains in the frame of the cross section: xx, yy, zz, yz, xz, xy, of which xx, xz and xy can differ from zero"},
    {"CurvatureLocal", 3, "1/m", "twist and the two curvatures in the frame of the cross section"},
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
constexpr std::array<OutputText, 8> ObjectBeamGeometricallyExact2D_outputs{{
    {"Position", 3, "m", "global position of the local point"},
    {"Displacement", 3, "m", "global displacement of the local point"},
    {"Velocity", 3, "m/s", "global velocity of the local point"},
    {"Rotation", 3, "rad", "only the third component is not zero: the angle of the cross section about z"},
    {"StrainLocal", 6, "1", "strains of the axis: axial strain first, shear strain last; the others are zero"},
    {"CurvatureLocal", 3, "1/m", "only the third component is not zero: the curvature that moments act against"},
    {"ForceLocal", 3, "N", "axial force, shear force, zero; in the frame of the cross section"},
    {"TorqueLocal", 3, "Nm", "only the third component is not zero: the bending moment"},
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
constexpr std::array<OutputText, 4> ObjectConnectorCartesianSpringDamper_outputs{{
    {"Displacement", 3, "m", "global position of marker m1 relative to marker m0, minus ``offset``"},
    {"Distance", 1, "m", "length of that displacement, so zero where the springs carry no force"},
    {"Velocity", 3, "m/s", "global velocity of marker m1 relative to marker m0"},
    {"Force", 3, "N", "global force vector that acts on marker m0; its negative acts on marker m1"},
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
constexpr std::array<OutputText, 3> ObjectConnectorCoordinateSpringDamper_outputs{{
    {"Displacement", 1, "various", "difference of the marker coordinates, not reduced by ``offset``"},
    {"Velocity", 1, "various", "difference of the marker velocity coordinates"},
    {"Force", 1, "various", "generalized force of spring and damper, positive if it draws the coordinates together after extension"},
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
    "what the friction force in sticking may exceed the dynamic one, N for lengths; sticking ends at the sum of both",
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
constexpr std::array<OutputText, 3> ObjectConnectorGravity_outputs{{
    {"Distance", 1, "m", "distance of the markers"},
    {"Displacement", 3, "m", "global vector from marker m0 to marker m1"},
    {"Force", 3, "N", "global force on marker m0, towards marker m1; its negative acts on marker m1"},
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
constexpr std::array<OutputText, 3> ObjectConnectorLinearSpringDamper_outputs{{
    {"DisplacementLocal", 1, "m", "relative position of the markers along the axis"},
    {"VelocityLocal", 1, "m/s", "relative velocity of the markers along the axis"},
    {"ForceLocal", 1, "N", "scalar force on marker m0 in the direction of the axis"},
}};

constexpr std::array<std::string_view, 16> ObjectConnectorReevingSystemSprings_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "rigid body markers along the rope: the first and the last are its ends, those between carry sheaves or deflection points; with ``hasCoordinateMarkers``, two coordinate markers follow",
    "True: the last two markers are coordinate markers that add rope at the start and at the end",
    "factors of the two coordinate markers: 1 for lengths, a radius (m) for the angle of a winch",
    "axial stiffness of the rope, modulus times cross section; divided by the length it is the stiffness of the rope",
    "axial damping of the rope; divided by the length it is the damping coefficient of the rope",
    "damping of the relative rotation of neighbouring sheaves about the rope; experimental",
    "damping of the relative motion of neighbouring sheaves across the rope; experimental",
    "positive: largest compressive force, approached smoothly; negative: the rope carries compression like a spring",
    "length of the rope without force",
    "axis of every sheave in the frame of its marker; the sign chooses the side at which the rope runs; none may be parallel to the line to the next center",
    "radius of every sheave; first and last must be zero, 0 between means a deflection point",
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
constexpr std::array<OutputText, 6> ObjectConnectorRigidBodySpringDamper_outputs{{
    {"DisplacementLocal", 3, "m", "position of marker m1 relative to marker m0 in frame J0; the translational part of the logarithm with ``intrinsicFormulation``"},
    {"VelocityLocal", 3, "m/s", "global velocity of marker m1 minus that of marker m0, in frame J0; in the mid-frame with ``intrinsicFormulation``"},
    {"Rotation", 3, "rad", "Tait-Bryan angles (about x, y, z in turn) of J1 relative to J0; the rotation vector with ``intrinsicFormulation``"},
    {"AngularVelocityLocal", 3, "rad/s", "angular velocity of marker m1 relative to marker m0, in frame J0; in the mid-frame with ``intrinsicFormulation``"},
    {"ForceLocal", 3, "N", "force on marker m0, in frame J0; in the mid-frame with ``intrinsicFormulation``"},
    {"TorqueLocal", 3, "Nm", "torque on marker m0, in frame J0; in the mid-frame with ``intrinsicFormulation``, without the moment of the force"},
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
constexpr std::array<OutputText, 5> ObjectConnectorSpringDamper_outputs{{
    {"Distance", 1, "m", "distance of the two markers, the current length of the spring"},
    {"Displacement", 3, "m", "global vector from marker m0 to marker m1"},
    {"Velocity", 3, "m/s", "global velocity of marker m1 relative to marker m0"},
    {"Force", 3, "N", "global force vector, the scalar force times the direction from marker m0 to marker m1; it is the force on marker m0"},
    {"ForceLocal", 1, "N", "scalar force, positive in tension"},
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
constexpr std::array<OutputText, 3> ObjectConnectorTorsionalSpringDamper_outputs{{
    {"Rotation", 1, "rad", "angle of J1 relative to J0 about the z axis of J0; in the range of half a turn to both sides, or continuous with a data node"},
    {"AngularVelocityLocal", 1, "rad/s", "z component in J0 of the angular velocity of marker m1 relative to marker m0"},
    {"TorqueLocal", 1, "Nm", "torque on marker m0 about the z axis of J0; its negative acts on marker m1"},
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

constexpr std::array<std::string_view, 19> ObjectContactConvexRoll_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "marker m0 on the ground, which may translate but not rotate, and marker m1 at the center of the roll",
    "NodeGenericData with three data coordinates: slip velocity in two directions, and gap, of the last update",
    "stiffness normal to the plane",
    "damping coefficient normal to the plane",
    "coefficient of friction in sliding",
    "what the coefficient of static friction exceeds the dynamic one",
    "growth of the friction coefficient with the slip speed",
    "slip speed by which the static offset falls to 1/e",
    "slip speed up to which friction is proportional to it",
    "length of the roll, symmetric about its center",
    "coefficients of the polynomial radius over the position x on the axis, highest power first; the profile must be convex",
    "coefficients of the first derivative of the profile",
    "coefficients of the second derivative of the profile",
    "radius of spheres at both ends that exclude contact by a cheap test; follows from the profile",
    "current point of possible contact; contact if its third component is negative",
    "False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero",
    "False: the item is not drawn",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 4> ObjectContactConvexRoll_outputs{{
    {"Position", 3, "m", "global contact point"},
    {"Velocity", 3, "m/s", "global velocity at which the contact point moves along the plane"},
    {"Force", 3, "N", "global force of the ground on the roll"},
    {"Torque", 3, "Nm", "global torque of that force about the center of the roll"},
}};

constexpr std::array<std::string_view, 10> ObjectContactCoordinate_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0",
    "NodeGenericData with one data coordinate, the gap of the last update; must not be positive if the simulation begins in contact",
    "contact stiffness; N/m for coordinates that are lengths",
    "contact damping coefficient; Ns/m for coordinates that are lengths",
    "difference of the coordinates at which contact begins; m for lengths",
    "False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero",
    "False: the item is not drawn",
    "size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};

constexpr std::array<std::string_view, 19> ObjectContactCurveCircles_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "rigid body marker that carries the curve, followed by one marker per circle",
    "NodeGenericData with three data coordinates per segment: number of the circle in contact, gap, tangential velocity, of the last update",
    "radius of every circle, as many as circle markers",
    "one row per segment with the planar coordinates of its begin and end, [x0, y0, x1, y1], in the frame of the curve; the outer side lies to the right when going from begin to end",
    "one row per segment with slopes at its begin and end (1) and curvatures at its begin and end (1/m), in the frame of the segment; empty: straight segments",
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

constexpr std::array<std::string_view, 16> ObjectContactFrictionCircleCable2D_rows{
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

constexpr std::array<std::string_view, 20> ObjectContactSphereSphere_rows{
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
    "coefficient of the adhesive force that grows with penetration (N/m for an exponent of 1); 0: none",
    "exponent of the penetration in the adhesive force",
    "ratio of normal speeds after and before an impact, for ``impactModel`` 1 and 2; positive, 1: elastic",
    "lower bound of the impact velocity in the restitution law; larger values damp slow and lasting contacts more",
    "0: elastic contact with linear damping; 1: Hunt-Crossley, for restitution near 1; 2: Carvalho-Martins and Gonthier, for all restitution coefficients",
    "False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero",
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

constexpr std::array<std::string_view, 18> ObjectContactSphereTorus_rows{
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
    "True: the item is drawn",
    "red, green, blue and opacity of the drawn shapes",
};
constexpr std::array<OutputText, 8> ObjectContactSphereTorus_outputs{{
    {"Position", 3, "m", "global contact point, in the middle of the overlap or gap"},
    {"Displacement", 3, "m", "global vector from marker m0 to marker m1"},
    {"DisplacementLocal", 1, "m", "gap, negative in contact"},
    {"Director1", 3, "1", "unit vector from marker m0 to marker m1"},
    {"Director2", 3, "1", "unit vector from the center of the torus to the nearest point of its center line"},
    {"Director3", 3, "1", "contact normal, unit vector from the center line of the torus to the center of the sphere"},
    {"Force", 3, "N", "global contact force on marker m0, with friction; its negative acts on marker m1; 0 without contact"},
    {"Torque", 3, "Nm", "global vector whose negative is the torque of the contact force about marker m0"},
}};

constexpr std::array<std::string_view, 17> ObjectContactSphereTriangle_rows{
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
    "True: the item is drawn",
    "red, green, blue and opacity of the drawn shapes",
};
constexpr std::array<OutputText, 6> ObjectContactSphereTriangle_outputs{{
    {"Position", 3, "m", "global contact point, in the middle of the overlap or gap"},
    {"Displacement", 3, "m", "global vector from marker m0 to the nearest point of the triangle"},
    {"DisplacementLocal", 1, "m", "gap, negative in contact"},
    {"Director1", 3, "1", "unit vector from marker m0 to the nearest point of the triangle"},
    {"Force", 3, "N", "global contact force on marker m0, with friction; its negative acts on marker m1; 0 without contact"},
    {"Torque", 3, "Nm", "global vector whose negative is the torque of the contact force about marker m0"},
}};

constexpr std::array<std::string_view, 12> ObjectJointALEMoving2D_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "marker m0 of the sliding body, and marker m1 of the cable element on which it begins, one of ``slidingMarkerNumbers``; which element the body is on follows from the data node",
    "coordinate markers of all cable elements in the order in which they follow each other: the end of one element is the begin of the next",
    "for each of these elements, the sum of the reference lengths of all elements before it; 0 for the first; one for each of ``slidingMarkerNumbers``",
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
    "Python function, the time derivative of ``offsetUserFunction``; a joint with this function is refused on velocity level, that is by index 2 integrators",
    "True: other equations for three constrained rotations, which keep static solutions from flipping by half a turn; experimental",
    "False: the item is not drawn",
    "radius of the drawn axes",
    "length of the drawn axes",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 8> ObjectJointGeneric_outputs{{
    {"Position", 3, "m", "global position of marker m0"},
    {"Velocity", 3, "m/s", "global velocity of marker m0"},
    {"DisplacementLocal", 3, "m", "position of marker m1 relative to marker m0 in frame J0; constrained components show the error of the constraint"},
    {"VelocityLocal", 3, "m/s", "global velocity of marker m1 minus that of marker m0, in frame J0"},
    {"Rotation", 3, "rad", "Tait-Bryan angles (about x, y, z in turn) of J1 relative to J0; the angle of rotation for a single free axis"},
    {"AngularVelocityLocal", 3, "rad/s", "angular velocity of marker m1 relative to marker m0, in frame J0"},
    {"ForceLocal", 3, "N", "Lagrange multipliers of the translations in frame J0: the force on marker m0; 0 in free directions"},
    {"TorqueLocal", 3, "Nm", "Lagrange multipliers of the rotations in the order of the equations, signs and axes as given there; 0 where there is no equation"},
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
constexpr std::array<OutputText, 8> ObjectJointPrismaticX_outputs{{
    {"Position", 3, "m", "global position of marker m0"},
    {"Velocity", 3, "m/s", "global velocity of marker m0"},
    {"DisplacementLocal", 3, "m", "position of marker m1 relative to marker m0 in frame J0; constrained components show the error of the constraint"},
    {"VelocityLocal", 3, "m/s", "global velocity of marker m1 minus that of marker m0, in frame J0"},
    {"Rotation", 3, "rad", "Tait-Bryan angles (about x, y, z in turn) of J1 relative to J0, the error of the constraint"},
    {"AngularVelocityLocal", 3, "rad/s", "angular velocity of marker m1 relative to marker m0, in frame J0"},
    {"ForceLocal", 3, "N", "joint force on marker m0, in frame J0; the first value is 0"},
    {"TorqueLocal", 3, "Nm", "Lagrange multipliers of the three rotations: about the x axis, the negative y axis and the negative z axis"},
}};

constexpr std::array<std::string_view, 6> ObjectJointRevolute2D_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "the two markers m0 and m1 that are connected; relative quantities are those of m1 minus those of m0",
    "False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero",
    "False: the item is not drawn",
    "size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};

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
constexpr std::array<OutputText, 8> ObjectJointRevoluteZ_outputs{{
    {"Position", 3, "m", "global position of marker m0"},
    {"Velocity", 3, "m/s", "global velocity of marker m0"},
    {"DisplacementLocal", 3, "m", "position of marker m1 relative to marker m0 in frame J0; constrained components show the error of the constraint"},
    {"VelocityLocal", 3, "m/s", "global velocity of marker m1 minus that of marker m0, in frame J0"},
    {"Rotation", 3, "rad", "Tait-Bryan angles (about x, y, z in turn) of J1 relative to J0; the third one is the angle of the joint, the others show the error of the constraint"},
    {"AngularVelocityLocal", 3, "rad/s", "angular velocity of marker m1 relative to marker m0, in frame J0"},
    {"ForceLocal", 3, "N", "joint force on marker m0, in frame J0"},
    {"TorqueLocal", 3, "Nm", "Lagrange multipliers of the two rotations, the first one about the negative y axis, the second one about the x axis; the third value is 0"},
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
    "marker m0 of the sliding body, and marker m1 of the cable element on which it begins, one of ``slidingMarkerNumbers``; which element the body is on follows from the data node",
    "shape markers of all cable elements in the order in which they follow each other: the end of one element is the begin of the next",
    "for each of these elements, the sum of the reference lengths of all elements before it; 0 for the first; one for each of ``slidingMarkerNumbers``",
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
    "marker m0 of the sliding body, and marker m1 of the cable element on which it begins, one of ``slidingMarkerNumbers``; which element the body is on follows from the data node",
    "coordinate markers of all cable elements in the order in which they follow each other: the end of one element is the begin of the next",
    "for each of these elements, the sum of the reference lengths of all elements before it; 0 for the first; one for each of ``slidingMarkerNumbers``",
    "NodeGenericData with two data coordinates: index of the current element in ``slidingMarkerNumbers``, and sliding coordinate at the begin of the step",
    "True: the force along the cable is prescribed, and both components of position are constrained; False: only the normal direction is constrained, by one multiplier",
    "True: marker m0, then a rigid body marker, keeps its orientation relative to the slope of the cable; False: it rotates freely",
    "force along the cable that drives the body; only for ``classicalFormulation``; changed during a simulation to move the body",
    "False switches the item off, also while a solver runs: no force; the equations of a constraint become those that set its multipliers to zero",
    "False: the item is not drawn",
    "size of the drawn symbol, such as the diameter of a spring or joint; a negative value selects the default size of the kind from the visualization settings",
    "red, green, blue and opacity, each from 0 to 1; a negative red selects the default color of the kind from the visualization settings",
};
constexpr std::array<OutputText, 4> ObjectJointSliding2D_outputs{{
    {"Position", 3, "m", "global position of marker m0"},
    {"Velocity", 3, "m/s", "global velocity of marker m0"},
    {"SlidingCoordinate", 1, "m", "sliding coordinate along all elements, from 0 to the sum of their reference lengths"},
    {"Force", 3, "N", "Lagrange multipliers of the position constraint, the joint force"},
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
    "point in the frame of the first body",
    "point in the frame of the second body",
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

constexpr std::array<std::string_view, 4> MarkerBodyRigid_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "body to which the marker is attached",
    "position of the marker in the body frame, relative to the reference point of the body",
    "False: the item is not drawn",
};

constexpr std::array<std::string_view, 5> MarkerKinematicTreeRigid_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "kinematic tree to which the marker is attached",
    "number of the link within the tree, from 0; -1 means not set and is refused",
    "position of the marker in the frame of the link",
    "False: the item is not drawn",
};

constexpr std::array<std::string_view, 4> MarkerNodeCoordinate_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "node to which the marker is attached",
    "number of the coordinate within the node, from 0; -1 means not set and is refused; any number reads zero at a ground node",
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
    "number of the coordinate within the node, from 0; -1 means not set and is refused",
    "True: the item is drawn",
};

constexpr std::array<std::string_view, 3> MarkerNodePosition_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "node with a position to which the marker is attached",
    "False: the item is not drawn",
};

constexpr std::array<std::string_view, 3> MarkerNodeRigid_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "node with position and orientation, such as a rigid body node, to which the marker is attached",
    "False: the item is not drawn",
};

constexpr std::array<std::string_view, 4> MarkerNodeRotationCoordinate_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "node with an orientation in space to which the marker is attached; planar nodes are refused, use MarkerNodeCoordinate for them",
    "axis of rotation: 0 for x, 1 for y, 2 for z; -1 means not set and is refused",
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

constexpr std::array<std::string_view, 9> MarkerSuperElementRigid_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "super element to which the marker is attached",
    "correction of the marker position in the reference frame of the super element, if the mean of the mesh nodes is not the wanted point; should be small",
    "mesh nodes of the super element, numbered within it from 0; each must have a position",
    "weight of every mesh node, as many as mesh nodes; should sum up to 1, for instance parts of the area of an interface",
    "True: the mean rotation follows from the angular momentum of the weighted nodes; False: it is a mean weighted by squared distances",
    "0: rotation and angular velocity are linearized; 1: rotation by the exponential map; 2: rotation by the exponential map and angular velocity by its tangent map, the consistent choice",
    "False: the item is not drawn",
    "True: the mesh nodes of the marker are drawn as well",
};

constexpr std::array<std::string_view, 5> LoadCoordinate_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "coordinate marker to which the load is applied",
    "generalized force: N on a coordinate that is a length, Nm on an angle; without effect if there is a user function, which gets it as an argument",
    "Python function that computes the load as a function of time",
    "False: the item is not drawn",
};

constexpr std::array<std::string_view, 6> LoadForceVector_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "marker with a position to which the force is applied; with ``bodyFixed`` it must have an orientation as well",
    "force vector in global coordinates, or in the marker frame with ``bodyFixed``; without effect if there is a user function, which gets it as an argument",
    "True: the vector is given in the frame of the marker and turns with the body, a follower force; False: in global coordinates",
    "Python function that computes the force vector as a function of time",
    "False: the item is not drawn",
};

constexpr std::array<std::string_view, 5> LoadMassProportional_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "marker of type BodyMass on the body to which the load is applied",
    "force per mass in global coordinates, such as the gravitational acceleration ``[0, 0, -9.81]``; without effect if there is a user function, which gets it as an argument",
    "Python function that computes the vector as a function of time",
    "False: the item is not drawn",
};

constexpr std::array<std::string_view, 6> LoadTorqueVector_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "marker with an orientation to which the torque is applied",
    "torque vector in global coordinates, or in the marker frame with ``bodyFixed``; without effect if there is a user function, which gets it as an argument",
    "True: the vector is given in the frame of the marker and turns with the body; False: in global coordinates",
    "Python function that computes the torque vector as a function of time",
    "False: the item is not drawn",
};

constexpr std::array<std::string_view, 8> SensorBody_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "body that is measured",
    "point in the body frame, relative to the reference point; for beams and cables the x component is the position along the axis",
    "write the measured values to a file while a solver runs; without effect if ``fileName`` is empty",
    "file with the time in the first and the values in the further columns; the path is relative to the working directory, missing directories are created",
    "output variable that is measured; one that the measured item does not provide is refused in Assemble",
    "keep time and values in memory, to be read with ``mbs.GetSensorStoredData`` during or after the solution",
    "False: the item is not drawn",
};

constexpr std::array<std::string_view, 9> SensorKinematicTree_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "kinematic tree that is measured",
    "link, numbered within the tree from 0; -1 means not set and is refused",
    "point in the frame of the link",
    "write the measured values to a file while a solver runs; without effect if ``fileName`` is empty",
    "file with the time in the first and the values in the further columns; the path is relative to the working directory, missing directories are created",
    "output variable that is measured; one that the measured item does not provide is refused in Assemble",
    "keep time and values in memory, to be read with ``mbs.GetSensorStoredData`` during or after the solution",
    "False: the item is not drawn",
};

constexpr std::array<std::string_view, 6> SensorLoad_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "load that is measured",
    "write the measured values to a file while a solver runs; without effect if ``fileName`` is empty",
    "file with the time in the first and the values in the further columns; the path is relative to the working directory, missing directories are created",
    "keep time and values in memory, to be read with ``mbs.GetSensorStoredData`` during or after the solution",
    "False: the item is not drawn",
};

constexpr std::array<std::string_view, 7> SensorMarker_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "marker that is measured",
    "write the measured values to a file while a solver runs; without effect if ``fileName`` is empty",
    "file with the time in the first and the values in the further columns; the path is relative to the working directory, missing directories are created",
    "output variable that is measured; one that the measured item does not provide is refused in Assemble",
    "keep time and values in memory, to be read with ``mbs.GetSensorStoredData`` during or after the solution",
    "False: the item is not drawn",
};

constexpr std::array<std::string_view, 7> SensorNode_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "node that is measured",
    "write the measured values to a file while a solver runs; without effect if ``fileName`` is empty",
    "file with the time in the first and the values in the further columns; the path is relative to the working directory, missing directories are created",
    "output variable that is measured; one that the measured item does not provide is refused in Assemble",
    "keep time and values in memory, to be read with ``mbs.GetSensorStoredData`` during or after the solution",
    "False: the item is not drawn",
};

constexpr std::array<std::string_view, 7> SensorObject_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "object that is measured; a body is refused for variables that need a local position, use SensorBody for it",
    "write the measured values to a file while a solver runs; without effect if ``fileName`` is empty",
    "file with the time in the first and the values in the further columns; the path is relative to the working directory, missing directories are created",
    "output variable that is measured; one that the measured item does not provide is refused in Assemble",
    "keep time and values in memory, to be read with ``mbs.GetSensorStoredData`` during or after the solution",
    "False: the item is not drawn",
};

constexpr std::array<std::string_view, 8> SensorSuperElement_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "super element that is measured",
    "mesh node, numbered within the super element from 0; -1 means not set and is refused",
    "write the measured values to a file while a solver runs; without effect if ``fileName`` is empty",
    "file with the time in the first and the values in the further columns; the path is relative to the working directory, missing directories are created",
    "output variable that is measured; one that the measured item does not provide is refused in Assemble",
    "keep time and values in memory, to be read with ``mbs.GetSensorStoredData`` during or after the solution",
    "False: the item is not drawn",
};

constexpr std::array<std::string_view, 8> SensorUserFunction_rows{
    "name of the item, unique within its kind; if empty, a name is made from kind and number",
    "sensors that the user function may evaluate; may be empty",
    "values that are passed to the user function, of free meaning, such as weights or conversions of units",
    "write the measured values to a file while a solver runs; without effect if ``fileName`` is empty",
    "file with the time in the first and the values in the further columns; the path is relative to the working directory, missing directories are created",
    "Python function that returns the values of the sensor",
    "keep time and values in memory, to be read with ``mbs.GetSensorStoredData`` during or after the solution",
    "False: the item is not drawn",
};

constexpr std::array<ItemText, 97> all{{
    {"node with a chosen number of algebraic variables, for equations that hold without time derivatives", NodeGenericAE_rows, NodeGenericAE_outputs},
    {"node with a chosen number of data variables: states that are kept from step to step and are not unknowns of the solver", NodeGenericData_rows, NodeGenericData_outputs},
    {"node with a chosen number of coordinates of first order differential equations, for controllers, hydraulics and state-space models", NodeGenericODE1_rows, NodeGenericODE1_outputs},
    {"node with a chosen number of coordinates of second order differential equations, without a meaning in space", NodeGenericODE2_rows, NodeGenericODE2_outputs},
    {"node with one coordinate of a second order differential equation, for motion along a line or about a fixed axis", Node1D_rows, Node1D_outputs},
    {"node with the three displacements of a point in space", NodePoint_rows, NodePoint_outputs},
    {"node with the two displacements of a point in the global x-y plane", NodePoint2D_rows, NodePoint2D_outputs},
    {"node of planar cable elements: position and axial slope vector in the global x-y plane", NodePoint2DSlope1_rows, NodePoint2DSlope1_outputs},
    {"fixed point without coordinates, as the other end of springs and constraints on coordinates or points", NodePointGround_rows, NodePointGround_outputs},
    {"node of spatial cable elements: position and axial slope vector", NodePointSlope1_rows, NodePointSlope1_outputs},
    {"node of thin plate elements: position and the two slope vectors in the plane of the plate", NodePointSlope12_rows, NodePointSlope12_outputs},
    {"node of shear and cross-section deformable beam elements: position and the two slope vectors in the cross section", NodePointSlope23_rows, NodePointSlope23_outputs},
    {"node of a rigid body that moves in the global x-y plane: two displacements and the angle about z", NodeRigidBody2D_rows, NodeRigidBody2D_outputs},
    {"node of a rigid body in space: three displacements and four Euler parameters (unit quaternion)", NodeRigidBodyEP_rows, NodeRigidBodyEP_outputs},
    {"node of a rigid body in space: three displacements and a rotation vector that is integrated by Lie group methods", NodeRigidBodyRotVecLG_rows, NodeRigidBodyRotVecLG_outputs},
    {"node of a rigid body in space: three displacements and three Tait-Bryan angles about x, y and z in turn", NodeRigidBodyRxyz_rows, NodeRigidBodyRxyz_outputs},
    {"system of first order differential equations with a constant matrix, a constant vector and a user function", ObjectGenericODE1_rows, ObjectGenericODE1_outputs},
    {"body that does not move: the fixed end of joints, connectors and markers", ObjectGround_rows, ObjectGround_outputs},
    {"mass that is guided along a line: one translation along the local x-axis", ObjectMass1D_rows, ObjectMass1D_outputs},
    {"point mass in space on a node with position", ObjectMassPoint_rows, ObjectMassPoint_outputs},
    {"point mass in the global x-y plane on a planar node", ObjectMassPoint2D_rows, ObjectMassPoint2D_outputs},
    {"rigid body in space with any center of mass, on a node with position and orientation", ObjectRigidBody_rows, ObjectRigidBody_outputs},
    {"rigid body that moves in the global x-y plane, with any center of mass", ObjectRigidBody2D_rows, ObjectRigidBody2D_outputs},
    {"rotor about a fixed axis: one rotation about the local z-axis", ObjectRotationalMass1D_rows, ObjectRotationalMass1D_outputs},
    {"flexible body with the nodal coordinates of a finite element mesh in a floating frame of reference", ObjectFFRF_rows, ObjectFFRF_outputs},
    {"flexible body with modal coordinates in a floating frame of reference", ObjectFFRFreducedOrder_rows, ObjectFFRFreducedOrder_outputs},
    {"system of second order differential equations with constant matrices and user functions, on any nodes", ObjectGenericODE2_rows, ObjectGenericODE2_outputs},
    {"open tree of rigid bodies in minimal coordinates, one joint coordinate per link", ObjectKinematicTree_rows, ObjectKinematicTree_outputs},
    {"planar cable through which material moves along the axis, on two nodes with slope and one node with the axial coordinate", ObjectALEANCFCable2D_rows, ObjectALEANCFCable2D_outputs},
    {"spatial beam with shear and cross section deformation, on two nodes with position and two slopes", ObjectANCFBeam_rows, ObjectANCFBeam_outputs},
    {"spatial cable or thin beam without torsion and shear deformation, on two nodes with position and slope", ObjectANCFCable_rows, ObjectANCFCable_outputs},
    {"planar cable or thin beam without shear deformation for large deformation, on two nodes with position and slope", ObjectANCFCable2D_rows, ObjectANCFCable2D_outputs},
    {"thin plate without shear deformation, on four nodes with position and two slopes", ObjectANCFThinPlate_rows, ObjectANCFThinPlate_outputs},
    {"spatial geometrically exact beam with shear deformation, on two rigid body nodes", ObjectBeamGeometricallyExact_rows, ObjectBeamGeometricallyExact_outputs},
    {"planar geometrically exact beam with shear deformation, on two or three rigid body nodes", ObjectBeamGeometricallyExact2D_rows, ObjectBeamGeometricallyExact2D_outputs},
    {"Three springs and dampers that act between two points in the directions of the global axes", ObjectConnectorCartesianSpringDamper_rows, ObjectConnectorCartesianSpringDamper_outputs},
    {"A scalar spring and damper between two coordinates", ObjectConnectorCoordinateSpringDamper_rows, ObjectConnectorCoordinateSpringDamper_outputs},
    {"A scalar spring and damper between two coordinates, with gear factors, friction and limit stops", ObjectConnectorCoordinateSpringDamperExt_rows, ObjectConnectorCoordinateSpringDamperExt_outputs},
    {"Newtonian gravitation between two masses, for celestial bodies and satellites; the weight on earth is LoadMassProportional", ObjectConnectorGravity_rows, ObjectConnectorGravity_outputs},
    {"A double-acting hydraulic cylinder between two points, with the build-up of pressure in both chambers", ObjectConnectorHydraulicActuatorSimple_rows, ObjectConnectorHydraulicActuatorSimple_outputs},
    {"A spring and damper along an axis that is fixed to the first marker, as in a prismatic joint", ObjectConnectorLinearSpringDamper_rows, ObjectConnectorLinearSpringDamper_outputs},
    {"A massless elastic rope that runs without friction over sheaves and joins two end points", ObjectConnectorReevingSystemSprings_rows, ObjectConnectorReevingSystemSprings_outputs},
    {"A spring and damper with six components, against relative translation and rotation of two rigid body markers", ObjectConnectorRigidBodySpringDamper_rows, ObjectConnectorRigidBodySpringDamper_outputs},
    {"A disc that rolls or slides with friction on a plane, with elastic contact instead of constraints", ObjectConnectorRollingDiscPenalty_rows, ObjectConnectorRollingDiscPenalty_outputs},
    {"A spring and a damper that act along the line between two points", ObjectConnectorSpringDamper_rows, ObjectConnectorSpringDamper_outputs},
    {"A torsional spring and damper about the z axis of a joint frame", ObjectConnectorTorsionalSpringDamper_rows, ObjectConnectorTorsionalSpringDamper_outputs},
    {"Couples two coordinates, or fixes one of them to a value or to a function of time", ObjectConnectorCoordinate_rows, ObjectConnectorCoordinate_outputs},
    {"Couples the coordinate vectors of two markers by linear and quadratic equations, or by a user function", ObjectConnectorCoordinateVector_rows, ObjectConnectorCoordinateVector_outputs},
    {"Keeps the distance of two points constant, like a massless rigid rod between two ball joints", ObjectConnectorDistance_rows, ObjectConnectorDistance_outputs},
    {"Contact without friction of a planar cable element with a circle", ObjectContactCircleCable2D_rows, {}},
    {"Contact of a convex roll, a body of revolution with a polynomial profile, with the ground plane", ObjectContactConvexRoll_rows, ObjectContactConvexRoll_outputs},
    {"Contact of two coordinates, a one-sided spring and damper", ObjectContactCoordinate_rows, {}},
    {"Contact of a planar curve with circles, as of a cam with its followers", ObjectContactCurveCircles_rows, ObjectContactCurveCircles_outputs},
    {"Contact with friction of a planar cable element with a circle, such as of a belt on a pulley", ObjectContactFrictionCircleCable2D_rows, ObjectContactFrictionCircleCable2D_outputs},
    {"Contact of two spheres, or of a sphere inside a hollow sphere, with friction, restitution and adhesion", ObjectContactSphereSphere_rows, ObjectContactSphereSphere_outputs},
    {"Contact of a sphere inside the tube of a torus, as of a ball in the groove of a bearing", ObjectContactSphereTorus_rows, ObjectContactSphereTorus_outputs},
    {"Contact of a sphere with a triangle, its face and chosen edges", ObjectContactSphereTriangle_rows, ObjectContactSphereTriangle_outputs},
    {"A body attached to an axially moving ANCF cable, whose sliding coordinate is shared by all elements of the cable", ObjectJointALEMoving2D_rows, ObjectJointALEMoving2D_outputs},
    {"A joint between two rigid body markers that constrains any choice of three translations and three rotations", ObjectJointGeneric_rows, ObjectJointGeneric_outputs},
    {"A prismatic joint of planar bodies: one point moves on a line that is fixed to the other body", ObjectJointPrismatic2D_rows, {}},
    {"A prismatic joint between two rigid body markers, free to translate along the x axis of the joint frame", ObjectJointPrismaticX_rows, ObjectJointPrismaticX_outputs},
    {"A revolute joint of planar bodies: keeps two points together in the x-y plane", ObjectJointRevolute2D_rows, {}},
    {"A revolute joint between two rigid body markers, free to rotate about the z axis of the joint frame", ObjectJointRevoluteZ_rows, ObjectJointRevoluteZ_outputs},
    {"A rigid disc that rolls on a plane without slip, by constraints on the velocity of the contact point", ObjectJointRollingDisc_rows, ObjectJointRollingDisc_outputs},
    {"A body that slides along a chain of ANCF cable elements in space", ObjectJointSliding_rows, ObjectJointSliding_outputs},
    {"A body that slides along a chain of planar ANCF cable elements", ObjectJointSliding2D_rows, ObjectJointSliding2D_outputs},
    {"A ball joint: keeps two points together, or their chosen global components", ObjectJointSpherical_rows, ObjectJointSpherical_outputs},
    {"A coordinate marker on the relative rotation of two bodies about an axis", MarkerBodiesRelativeRotationCoordinate_rows, {}},
    {"A coordinate marker on the relative translation of two bodies along an axis", MarkerBodiesRelativeTranslationCoordinate_rows, {}},
    {"A marker that gives joints and contacts access to the shape of a beam element", MarkerBodyBeamShape_rows, {}},
    {"A marker on all coordinates of a planar ANCF cable element, for sliding joints", MarkerBodyCable2DCoordinates_rows, {}},
    {"A marker that divides a planar ANCF cable element into straight segments, for contact with circles", MarkerBodyCable2DShape_rows, {}},
    {"A marker on the mass of a body, for loads that are proportional to mass such as gravity", MarkerBodyMass_rows, {}},
    {"A marker at a point that is fixed to a body, with its position but without orientation", MarkerBodyPosition_rows, {}},
    {"A marker at a point that is fixed to a body, with its position and orientation", MarkerBodyRigid_rows, {}},
    {"A marker at a point that is fixed to a link of a kinematic tree, with position and orientation", MarkerKinematicTreeRigid_rows, {}},
    {"A marker on a single coordinate of a node", MarkerNodeCoordinate_rows, {}},
    {"A marker on all coordinates of a node, as a vector", MarkerNodeCoordinates_rows, {}},
    {"A marker on a single coordinate of a node with first order equations", MarkerNodeODE1Coordinate_rows, {}},
    {"A marker at the position of a node", MarkerNodePosition_rows, {}},
    {"A marker at a node with position and orientation", MarkerNodeRigid_rows, {}},
    {"A marker on the rotation of a node about one global axis", MarkerNodeRotationCoordinate_rows, {}},
    {"A marker on all second order coordinates of an object, as a vector", MarkerObjectODE2Coordinates_rows, {}},
    {"A marker at the weighted mean position of mesh nodes of a super element", MarkerSuperElementPosition_rows, {}},
    {"A marker with the weighted mean position and rotation of mesh nodes of a super element", MarkerSuperElementRigid_rows, {}},
    {"A generalized force on a single coordinate", LoadCoordinate_rows, {}},
    {"A force vector at a point of a body or at a node", LoadForceVector_rows, {}},
    {"A distributed load proportional to mass, such as gravity", LoadMassProportional_rows, {}},
    {"A torque vector on a body or node with orientation", LoadTorqueVector_rows, {}},
    {"Measures an output variable of a body at a local position", SensorBody_rows, {}},
    {"Measures an output variable of a link of a kinematic tree at a local position", SensorKinematicTree_rows, {}},
    {"Measures the value of a load", SensorLoad_rows, {}},
    {"Measures an output variable of a marker", SensorMarker_rows, {}},
    {"Measures an output variable of a node", SensorNode_rows, {}},
    {"Measures an output variable of a connector, constraint, joint or contact", SensorObject_rows, {}},
    {"Measures an output variable at a mesh node of a super element", SensorSuperElement_rows, {}},
    {"Computes its values by a Python function, for instance from other sensors", SensorUserFunction_rows, {}},
}};

}  // namespace item_texts_of

std::span<const ItemText> item_texts() { return item_texts_of::all; }

}  // namespace dalembert
