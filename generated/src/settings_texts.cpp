// Generated from specs/ by codegen/templates/settings_texts.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/reflection/settings_texts.hpp"

#include <array>

namespace dalembert {
namespace settings_texts_of {

constexpr std::array<std::string_view, 8> NewtonNumericalDifferentiationSettings_rows{
    "true: the size of a coordinate, which scales its increment, includes the reference value",
    "true: the whole system is differentiated at once, with all dependencies, at a cost that grows with the square of its size; false: item by item",
    "true: derivatives of algebraic equations by numerical differentiation, for tests; false: exact ones",
    "true: derivatives of second order equations by numerical differentiation; false: exact ones",
    "true: derivatives of connector forces by numerical differentiation, for tests; the same as ``forODE2``, because forces of connectors and bodies are differentiated together; false: see ``forODE2``",
    "true: exact derivatives of connectors include the change of the directions of their forces; false: they leave it out",
    "smallest size of a coordinate that is used for its increment, in the units of the coordinate",
    "increment of a coordinate relative to its size",
};

constexpr std::array<std::string_view, 13> NewtonSettings_rows{
    "the iteration ends if the error is below this value, in the units of the residual",
    "true: if the residual grows in the first iteration, the larger value is the one that has to be reduced by the relative tolerance; useful for steps that start with a residual near zero",
    "the solver stops with an error if the squared norm of coordinates or velocities reaches this value: explicit solvers after every step (coordinates only with values below the default), Newton's method while it has not converged",
    "number of iterations of all kinds after which a step has failed",
    "number of iterations with an old Jacobian after which it is computed anew",
    "number of iterations with a renewed Jacobian after which the step goes on with full Newton",
    "largest ratio of the errors of two iterations that an old Jacobian may show; above it the Jacobian is computed anew",
    "true: modified Newton computes the Jacobian once per step; false: only when convergence asks for it",
    "quantity that measures the error: 0 the residual, 1 the increment of the coordinates of differential equations",
    "the iteration ends if the error has fallen below this fraction of the initial one; fine steps also apply the correction of the last residual, so that smaller steps are more accurate",
    "true: the Jacobian and its factorization are kept as long as convergence allows; false: computed in every iteration",
    "true: nonlinear equations; false: one linear step",
    "true: the norm of the error is divided by the root of the number of coordinates, so that tolerances do not depend on the size of the model; false: plain norm",
};

constexpr std::array<std::string_view, 4> DiscontinuousSettings_rows{
    "true: the step is accepted when the maximum number of iterations is reached; false: it has failed",
    "largest error of the discontinuous states that is accepted; an absolute value, in the units of the contact or friction item",
    "number of discontinuous iterations in one step",
    "true: the step size follows recommendations of items, for example at the start of a contact; false: they are ignored",
};

constexpr std::array<std::string_view, 2> ContinuationSettings_rows{
    "true: ``SolveDynamic`` and ``SolveStatic`` go on from the file ``solutionSettings.restartFileName`` if it exists, else they start from the initial values; a ``restartFileName`` given here is used in any case",
    "restart file of a solution with the same model, solver and settings; its start time, end time and number of steps are those of the whole solution. Solution and sensor files continue at their position in the restart file; later rows are overwritten. Empty: start from the initial values",
};

constexpr std::array<std::string_view, 1> DenseOutputSettings_rows{
    "true: solution and sensors are written at the multiples of ``solutionWritePeriod`` and ``sensorsWritePeriod``, counted from the start, and at the end; within steps by Hermite interpolation of coordinates, velocities and accelerations. Data coordinates are those of the end of the step. False: they are written at the first end of a step at which the period is over. Static solvers write at their load steps",
};

constexpr std::array<std::string_view, 1> EventsSettings_rows{
    "true: dynamic solvers locate events of contact, friction and stops of items, GeneralContact, and sliding joints that pass from element to element: a step with an event is solved again such that it ends there, and accelerations are recomputed. An item that switches repeatedly, each time within two steps, raises an error with its name. False: items switch in the discontinuous iteration, at the end of a step",
};

constexpr std::array<std::string_view, 4> InitialConditionsSettings_rows{
    "evaluate the gap and the rate of the gap of every constraint before the first step, and name the worst of those that are not fulfilled; the static solver looks at gaps only, closes them, and says so if its verboseMode is at least 1",
    "true: constraints that are not fulfilled at the start are an error; false: a warning",
    "largest gap that is not reported: relative to the size of the mechanism, which is the diagonal of the box around the nodes and markers of bodies that constraints connect, or in rad; 1000 times as much is tolerated at the end of solutions that constrain velocities",
    "largest rate of a gap that is not reported, relative to the sum of the magnitudes of the velocities that meet in the constraint; rates that open a gap of less than positionTolerance in one second are not reported",
};

constexpr std::array<std::string_view, 1> LinearSolverChoiceSettings_rows{
    "true: dense matrices are used up to 32 unknowns and sparse ones above; setting ``linearSolverType`` makes this false",
};

constexpr std::array<std::string_view, 4> LinearSolverSettings_rows{
    "true: a singular system matrix is no error, and one of the possible solutions is taken, for example with redundant constraints; only with a dense solver with full pivoting, and to be checked with care; false: a singular matrix stops the solver",
    "a pivot below this value is treated as zero, so that an almost singular matrix is reported; dense solvers only; 0: exact zeros only",
    "true: the symbolic analysis of a sparse matrix is used for all factorizations with the same pattern",
    "name the items whose equations make the system matrix singular when the solver fails",
};

constexpr std::array<std::string_view, 8> ParallelSettings_rows{
    "number of items from which on Jacobians are evaluated in parallel",
    "number of loads from which on these are evaluated in parallel",
    "number of bodies from which on mass matrices are evaluated in parallel",
    "number of items from which on residuals are evaluated in parallel",
    "number of threads that share the evaluation of residuals, tangents and explicit right-hand sides; limited by the number of cores; results are bit-identical",
    "number of items from which on work is split into several parts per thread",
    "number of parts of work per thread",
    "true: threads that are ready take over work of others; false: fixed share per thread",
};

constexpr std::array<std::string_view, 3> RedundantConstraintsSettings_rows{
    "gap that redundant constraints which contradict each other may leave, relative to the size of their mechanism, or in rad: up to it the solver distributes it among them and warns, above it is an error",
    "the smallest reactions are those with the smallest sum of squares of forces and of moments divided by this length; 0: the size of the mechanism, which is the diagonal of the box around the nodes and markers of bodies that constraints connect, but at most 20 radii of gyration of its bodies (on average)",
    "true: find redundant constraints and solve in spite of them; false: a matrix that they make singular stops the solver, and where round-off hides that, reactions are arbitrary",
};

constexpr std::array<std::string_view, 27> SolutionSettings_rows{
    "true: solution and solver information are appended to existing files; false: existing files are replaced; binary files are always replaced",
    "true: the solution file is binary, with 8 byte numbers if ``outputPrecision`` is at least 8 and with 4 byte numbers otherwise; false: text",
    "solution file with all coordinates, with its path; directories are created; the default ending is .txt or, for a binary file, .sol",
    "write the accelerations of second order coordinates to the solution file",
    "write algebraic variables, such as Lagrange multipliers, to the solution file",
    "write data variables to the solution file",
    "write the time derivatives of first order coordinates to the solution file",
    "write the velocities of second order coordinates to the solution file",
    "number of coordinates from which on the solution file is flushed at every output, independently of ``flushFilesImmediately``",
    "true: files are complete after every output, which costs time in models with short steps; false: output is buffered",
    "number of significant digits in solution and sensor files",
    "simulated time between two images of the main view that are saved while the solver runs; negative: no images",
    "restart file, with its path; it takes the place of the one before when it is complete and on the disk, and the one before is kept under the same name with .bck behind",
    "simulated time between two updates of the restart file",
    "true: sensor values are appended to existing files and stored values; false: these are replaced",
    "false: sensors neither write files nor store values",
    "write a footer to sensor files when the solver has finished",
    "write a header to sensor files",
    "simulated time between two outputs of sensors, to file and memory; 0: every step",
    "text that is written to the header of the solution file and shown in the render window",
    "simulated time between two outputs to the solution file; 0: every step",
    "file for the information of the solver, as much as ``verboseModeFile`` says; directories are created",
    "write a footer with convergence and computation time to the solution file when the solver has finished",
    "write a header to the solution file",
    "write the state at the start to solution and sensor files; false avoids double lines when files are appended",
    "write the restart file from time to time",
    "write the solution file",
};

constexpr std::array<std::string_view, 7> StaticSolverArcLengthSettings_rows{
    "true: each step has a length, the norm of the displacements of second order coordinates, and the load factor follows; the path ends at load factor 1 or at ``lowestLoadFactor``. The first step is as long as the displacements of one load step of ``numberOfLoadSteps``, and none changes the load by much more than such a step does. Solution and sensors are written after every step, with the quasi-time that belongs to the load",
    "largest coordinate of the step along the null vector of the matrix by which the path leaves the first bifurcation point, positive or negative: two sides of a branch; 0: bifurcation points are passed",
    "number of Newton iterations that steps are meant to take: longer steps follow those that took fewer, shorter steps those that took more",
    "largest length of a step, the norm of the displacements of all second order coordinates; 0: no bound",
    "load factor below which the path ends as well, where it turns back so far",
    "number of steps after which a path that has met neither of its ends is an error",
    "true: look for steps in which an eigenvalue of the matrix changes its sign, and end a step at the point where it does; a few eigenvalues next to zero are followed",
};

constexpr std::array<std::string_view, 18> StaticSolverSettings_rows{
    "true: a load step that fails is repeated with a smaller step; false: it is an error",
    "factor of the step size when a step has failed",
    "factor of the step size when it may grow again after a reduction, up to its regular value; 1: it does not grow",
    "a step counts for recovery if it took at most this number of Newton and discontinuous iterations",
    "number of steps after a reduction before the step size is increased",
    "take derivatives of loads with respect to the coordinates into the Jacobian; needed for good convergence if loads depend on coordinates",
    "true: first order coordinates keep their initial values; false: they are found such that their time derivatives vanish",
    "quasi-time from the first to the last load step, as seen by loads that depend on time",
    "true: the load factors form a geometric series, for problems that need small first steps; false: equal load steps",
    "range of the geometric series: load factor i of n is this number to the power (i - n)/(n - 1)",
    "quasi-time at which the load steps start",
    "smallest step of the quasi-time; the solver stops with an error below it",
    "number of load steps; 1: the full load is applied at once",
    "factor of a mass proportional term that is added to the Jacobian of the second order equations, and that fades out as one minus the square of the load factor: it needs several load steps. It finds equilibria of pendulums, which have no initial stiffness; 0: not used",
    "sum of numbers that select the contents of a line about a step: 1 remaining time, 2 Newton iterations, 4 Jacobians, 8 discontinuous iterations, 16 step size, 32 CPU time, 64 warnings when a step is reduced, 128 increases of the step size, 1024 every step; 0 shows the time only",
    "true: loads are multiplied with the load factor, which goes from 0 to 1; false: loads act in full, for loads that follow the quasi-time by themselves",
    "amount of output on the console: no output (0), occasional lines (1), a line per step (2), also the solution (3), mass matrix and Jacobian (4), inverse of the Jacobian (5)",
    "amount of output in the solver information file: no output (0), occasional lines (1), a line per step (2), also the solution (3), mass matrix and Jacobian (4), inverse of the Jacobian (5)",
};

constexpr std::array<std::string_view, 1> StepSizeControlSettings_rows{
    "true: implicit solvers estimate the error of coordinates and velocities in each step, and repeat steps whose error is above the tolerances, if ``timeIntegration.automaticStepSize`` is true; false: they take equal steps",
};

constexpr std::array<std::string_view, 5> TimeIntegrationExplicitIntegrationSettings_rows{
    "true: accelerations are evaluated at the end of each step; false: those of the last stage are shown, which saves one evaluation per step",
    "true: mass matrices are inverted body by body, which is fast but wrong if bodies share nodes; false: the system mass matrix is factorized",
    "method that is used when the solver is called without one",
    "true: constraints that fix single coordinates to ground are eliminated; false: they are ignored; other constraints cannot be treated",
    "true: rotation vectors of Lie group nodes are updated by composition; needed for such nodes",
};

constexpr std::array<std::string_view, 10> TimeIntegrationGeneralizedAlphaSettings_rows{
    "true: initial accelerations, and rates of first-order coordinates, are computed from the equations of motion, without the second time derivatives of prescribed motions of user functions; false: they are taken from the system or set to zero",
    "true: the tangent operator of the Lie group nodes is part of the Jacobian, for better convergence",
    "true: kinematic relations of Lie group nodes after Brüls and Cardona; false: more accurate ones",
    "parameter beta of the Newmark method; 1/4 with gamma 1/2 is the trapezoidal rule",
    "parameter gamma of the Newmark method; 1/2 gives no numerical damping",
    "true: initial accelerations that are not computed are set to zero; false: they continue from the system; only without ``computeInitialAccelerations``",
    "spectral radius at infinite frequency: 1 no numerical damping, 0 largest; has to be below 1 for constraints on position level",
    "true: the algebraic variables that belong to the computed initial accelerations become initial values",
    "true: constraints are fulfilled on velocity level (index 2), and Euler parameters are divided by their length after each step; false: on position level (index 3)",
    "true: Newmark method with the parameters given here; false: generalized-alpha",
};

constexpr std::array<std::string_view, 24> TimeIntegrationSettings_rows{
    "absolute tolerance of the error control of explicit integrators, in the units of the coordinates",
    "true: an implicit step that fails is repeated with a smaller step size; false: it is an error",
    "factor of the step size when a step has failed",
    "factor of the step size when it may grow again after a reduction, up to its regular value; 1: it does not grow",
    "a step counts for recovery if it took at most this number of Newton and discontinuous iterations",
    "number of steps after a reduction before the step size is increased",
    "true: integrators with an error estimate choose the step size; (endTime - startTime)/numberOfSteps is its upper bound; false: constant step size",
    "derivatives of loads in the Jacobian of implicit integrators: no derivatives (0), with respect to the coordinates (1), also with respect to the velocities (2)",
    "time at which the integration ends",
    "first step size when the step size is automatic; 0: the largest step size",
    "lower bound of the step size; an implicit solver that would need a smaller one stops with an error; automatic step sizes continue at the bound with a warning, and stop with an error if 100 steps in a row exceed the tolerances",
    "number of steps of equal size from startTime to endTime; a whole number, but for rounding",
    "simulated seconds per second of real time when simulating in real time: greater than 1 is fast motion, smaller than 1 slow motion",
    "waiting time in microseconds between two looks at the clock when simulating in real time; small values are more accurate and cost more CPU time",
    "relative tolerance of the error control of explicit integrators",
    "true: mass matrices that do not depend on the state are computed once, and again when parameters of objects have changed; false: they are computed in every evaluation",
    "true: the solver waits until real time has caught up with the simulated time; it does not wait when it is too slow",
    "time at which the integration starts",
    "sum of numbers that select the contents of a line about a step: 1 remaining time, 2 Newton iterations, 4 Jacobians, 8 discontinuous iterations, 16 step size, 32 CPU time, 64 warnings when a step is reduced, 128 increases of the step size, 1024 every step; 0 shows the time only",
    "method of ``SolveDynamic`` when it is called without ``solverType``; ``MainSolverExplicit`` uses it if it is an explicit one, else ``explicitIntegration.dynamicSolverType``",
    "largest factor by which the automatic step size grows from one step to the next",
    "factor of the step size that the error estimate allows; smaller values avoid rejected steps",
    "amount of output on the console: no output (0), occasional lines (1), a line per step (2), also the solution (3), mass matrix and Jacobian (4), inverse of the Jacobian (5)",
    "amount of output in the solver information file: no output (0), occasional lines (1), a line per step (2), also the solution (3), mass matrix and Jacobian (4), inverse of the Jacobian (5)",
};

constexpr std::array<std::string_view, 7> SimulationSettings_rows{
    "true: the solver frees its memory when it has finished; false: it keeps it for the next computation",
    "print how the computation time is distributed when the solver has finished",
    "print global timers when the solver has finished",
    "print numbers of steps, iterations, Jacobians and rejected steps when the solver has finished",
    "direct solver of the linear systems",
    "number of significant digits in texts on the console",
    "wait for the space bar in the renderer after each step",
};

constexpr std::array<std::string_view, 11> VSettingsViewCamera_rows{
    "shift of the camera, in the frame of the view; relative to the tracked marker if there is one",
    "distance of the clipping plane from the origin, along its normal",
    "normal of a plane behind which faces are not drawn, the half-space in direction of the normal being cut off; zeros: no clipping",
    "true: zooming and rotating move the model and the camera sees all of it; false: the camera moves through the model",
    "nearest and farthest visible distance (m), and a number that is 1 to use them and 0 to compute them from the size of the scene",
    "amount of perspective, the tangent of half the field of view; 0: parallel projection",
    "number of the marker that the view follows; -1: none",
    "number of the system in the container that the tracked marker belongs to; the first is 0",
    "1 in all three components to follow the rotation of the marker, zeros to keep the direction of view",
    "for x, y and z: 1 to follow the marker in this direction, 0 not to",
    "true: images are made by the ray tracer",
};

constexpr std::array<std::string_view, 9> VSettingsViewScene_rows{
    "coordinate system in the corner: 0 hidden, 1 lines with text, 2 arrows, 3 arrows with text",
    "draw the global frame at the origin",
    "draw all faces transparent",
    "draw the edges of faces",
    "draw faces; faces off and edges on give a wire frame",
    "draw lines, other than edges",
    "draw the edges of finite elements",
    "draw the faces of finite elements",
    "length of the axes of the global frame",
};

constexpr std::array<std::string_view, 9> VSettingsViewWindow_rows{
    "the window stays above other windows",
    "size of the font, about in pixels",
    "mouse and keys do not change the view",
    "open the window in full size",
    "width and height of the window at the start, in pixels",
    "show version, solver and other information in the window",
    "show the position of the mouse in the model and its distance from the last click",
    "show zoom, center and rotation of the view",
    "true: the window is shown at the start; false: it starts as an icon",
};

constexpr std::array<std::string_view, 10> VSettingsLight_rows{
    "constant term of the attenuation, whose inverse weakens the light; used for lights with a position, by the ray tracer only",
    "strength of the light that is scattered by faces",
    "switch the light on",
    "radius of the light for soft shadows; a light at infinity is as large as it would be at its position",
    "term of the attenuation that grows with the distance; used for lights with a position",
    "position of the light if the fourth number is 1; direction towards a light at infinity if it is 0",
    "term of the attenuation that grows with the square of the distance; used for lights with a position",
    "whether this light casts shadows, which are those of the ray tracer: any number above 0, however large; shadows cost rendering time",
    "strength of highlights",
    "true: position and direction are fixed to the camera; false: to the model; without the ray tracer, lights turn with the viewer, as do those whose position is the default",
};

constexpr std::array<std::string_view, 8> VSettingsMaterial_rows{
    "opacity, from 0 to 1",
    "red, green and blue of faces without a color of their own",
    "red, green and blue of light that the material emits",
    "index of refraction of transparent materials; 1: none",
    "name of the material",
    "share of light that is reflected, from 0 (rough) to 1 (mirror); costs rendering time",
    "sharpness of highlights; below 5 dull, above 50 glossy",
    "red, green and blue of highlights",
};

constexpr std::array<std::string_view, 9> VSettingsNodes_rows{
    "length of the axes of node frames",
    "red, green, blue and opacity of nodes without a color of their own, each from 0 to 1",
    "size of nodes without a size of their own; negative: chosen from the size of the scene",
    "true: nodes are points of the size ``general.pointSize`` and frames are lines, which is fast; false: spheres or circles",
    "draw nodes",
    "draw the axes of nodes with orientation",
    "draw the slope vectors of nodes that have them; 0: no",
    "draw the numbers of nodes",
    "number of segments of a node that is drawn as a sphere; circles have four times as many",
};

constexpr std::array<std::string_view, 10> VSettingsBodiesBeams_rows{
    "number of segments along the axis of a beam element",
    "true: cross sections are solid, if the element can do so; false: wire frame",
    "number of faces over the height of a beam that is drawn flat",
    "draw the contour variable as a diagram normal to the beam axis",
    "red, green, blue and opacity of the diagram along the beam axis, each from 0 to 1",
    "length in the drawing (m) per unit of the contour variable",
    "draw lines from the beam axis to the diagram",
    "value that is added to the contour variable before it is scaled",
    "write values at the lines of the diagram; they are interpolated ones",
    "true: contour variables are interpolated along the axis with a lower order, which hides oscillations; false: like the element",
};

constexpr std::array<std::string_view, 4> VSettingsBodiesKinematicTree_rows{
    "length of the axes of joint and center of mass frames",
    "draw a frame at the center of mass of each link",
    "write object and link numbers at the frames",
    "draw a frame at each joint of trees without graphics data, whose links would hide it",
};

constexpr std::array<std::string_view, 2> VSettingsBodiesShells_rows{
    "true: with thickness; false: the mid-surface only",
    "factor of the thickness in the drawing",
};

constexpr std::array<std::string_view, 5> VSettingsBodies_rows{
    "red, green, blue and opacity of bodies without a color of their own, each from 0 to 1",
    "edge lengths in x, y and z of the block that stands for a body without shapes",
    "factor of the deformation of finite element meshes in floating frame bodies",
    "draw bodies",
    "draw the numbers of bodies",
};

constexpr std::array<std::string_view, 10> VSettingsConnectors_rows{
    "size of contact points; no effect, see ``contact.contactPointsDefaultSize``",
    "red, green, blue and opacity of connectors without a color of their own, each from 0 to 1",
    "size of connectors without a size of their own; negative: chosen from the size of the scene",
    "length of joint axes",
    "radius of joint axes",
    "draw connectors",
    "draw contact points and lines of contacts between circles and cables",
    "draw the axes of joints in space",
    "draw the numbers of connectors",
    "number of windings of springs; more than 500 are drawn as 500",
};

constexpr std::array<std::string_view, 5> VSettingsMarkers_rows{
    "red, green, blue and opacity of markers without a color of their own, each from 0 to 1",
    "size of markers without a size of their own; negative: chosen from the size of the scene",
    "draw markers with simple symbols",
    "draw markers",
    "draw the numbers of markers",
};

constexpr std::array<std::string_view, 9> VSettingsLoads_rows{
    "red, green, blue and opacity of loads without a color of their own, each from 0 to 1",
    "radius of load arrows",
    "size of loads without a size of their own; negative: chosen from the size of the scene",
    "draw loads with simple symbols",
    "true: loads with user functions are drawn with their current value; needs ``fixedLoadSize`` false to show more than the direction",
    "true: arrows of loads have the same length; false: the length is proportional to the load",
    "length of an arrow (m) per unit of the load (N or Nm), if ``fixedLoadSize`` is false",
    "draw loads",
    "draw the numbers of loads",
};

constexpr std::array<std::string_view, 18> VSettingsSensorsTraces_rows{
    "width of trace lines in pixels",
    "numbers of the position sensors whose traces are drawn; they have to store their values; empty: all position sensors",
    "numbers of sensors of rotation matrices whose axes are drawn along the traces; each position sensor in the list has one",
    "numbers of sensors of vectors that are drawn along the traces; each position sensor in the list has one",
    "only every position of this number is part of the trace",
    "number of the system in the container that the sensors belong to; the first is 0",
    "draw the values at the time that is shown",
    "draw the trace after the time that is shown, as far as it is known",
    "draw the trace before the time that is shown",
    "draw traces of positions",
    "draw axes along the traces",
    "draw vectors along the traces",
    "length of the trace in simulated time, into past and future; 0: not limited",
    "red, green, blue and opacity of the traces one after the other, four numbers per trace; used again from the start if there are more traces",
    "length of the axes along the traces",
    "only axes of every position of this number are drawn",
    "length in the drawing (m) per unit of the vector",
    "only vectors of every position of this number are drawn",
};

constexpr std::array<std::string_view, 5> VSettingsSensors_rows{
    "red, green, blue and opacity of sensors without a color of their own, each from 0 to 1",
    "size of sensors without a size of their own; negative: chosen from the size of the scene",
    "draw sensors with simple symbols",
    "draw sensors",
    "draw the numbers of sensors",
};

constexpr std::array<std::string_view, 10> VSettingsContourAdvanced_rows{
    "number of significant digits in the color bar, 16 at most",
    "number of steps of the color bar",
    "color at the start of the range: red, green and blue from 0 to 1; the fourth number is not used",
    "color at one quarter of the range: red, green and blue from 0 to 1; the fourth number is not used",
    "color at the middle of the range: red, green and blue from 0 to 1; the fourth number is not used",
    "color at three quarters of the range: red, green and blue from 0 to 1; the fourth number is not used",
    "color at the end of the range: red, green and blue from 0 to 1; the fourth number is not used",
    "color of values above the range: red, green and blue from 0 to 1; the fourth number is not used",
    "color of values below the range: red, green and blue from 0 to 1; the fourth number is not used",
    "show the color bar",
};

constexpr std::array<std::string_view, 9> VSettingsContour_rows{
    "opacity of contour colors, from 0 to 1",
    "true: the colors span the values that occur; false: from ``minValue`` to ``maxValue``",
    "largest value of the color scale, in the unit of the output variable",
    "smallest value of the color scale, in the unit of the output variable",
    "color nodes as well",
    "output variable that is shown as color; ``_None``: none",
    "component of the output variable, from 0; -1: its norm",
    "true: an automatic range shrinks with the values, which suits static computations; false: it only grows",
    "color rigid bodies and mass points as well",
};

constexpr std::array<std::string_view, 17> VSettingsContact_rows{
    "red, green, blue and opacity of bounding boxes, each from 0 to 1",
    "red, green, blue and opacity of the search tree, each from 0 to 1",
    "red, green, blue and opacity of contact spheres, each from 0 to 1",
    "red, green, blue and opacity of contact tori, each from 0 to 1",
    "red, green, blue and opacity of contact triangles, each from 0 to 1",
    "length of a contact force in the drawing per newton",
    "size of contact points, and twice the width of forces; negative, or not set: chosen from the size of the scene",
    "draw the bounding boxes of contact partners; slow if there are many",
    "draw points of contact in general contact, and the forces there on the spheres",
    "write the values of contact forces that are drawn, in newton",
    "draw the outer box of the search tree, where SetSearchTreeBox has given one",
    "draw all cells of the search tree, where its box and SetSearchTreeCellSize have given them, the redder the more partners they hold; slow if there are many",
    "draw contact spheres",
    "draw contact tori",
    "draw contact triangles",
    "number of segments of contact curves",
    "number of segments of contact spheres",
};

constexpr std::array<std::string_view, 18> VSettingsOpenGLAdvanced_rows{
    "red, green and blue of cut faces at a clipping plane; the fourth number chooses the color: 0 nothing is drawn, 1 this color, 2 the color of the body",
    "true: faces are sorted by depth, so that transparent ones are drawn correctly, at more cost",
    "true: faces are lit; false: plain colors",
    "red, green, blue and opacity of normals of faces, each from 0 to 1",
    "point of the model in the middle of the window at the start; only without ``general.autoFitScene`` and with a model centric view",
    "size of the scene at the start; only without ``general.autoFitScene``",
    "rotation matrix of the view at the start; only with a model centric view",
    "zoom at the start; only without ``general.autoFitScene``",
    "true: highlights are computed with the position of the camera; false: with the direction of view only",
    "light the back of faces too",
    "smooth lines",
    "shift of faces away from the viewer, so that lines on them stay visible",
    "true: shading is interpolated between the corners of faces; false: one shade per face",
    "shift of shadows against artifacts; smaller for large scenes, larger for thin bodies",
    "draw the bounding box of the scene that zooming to all uses",
    "smooth the lines of text",
    "width of the lines of text in pixels",
    "red, green, blue and opacity of normals at the corners of faces, each from 0 to 1",
};

constexpr std::array<std::string_view, 11> VSettingsOpenGL_rows{
    "draw the normals of faces, to find errors in meshes",
    "length of normals",
    "draw the normals at the corners of faces, to find errors in meshes",
    "color of the edges of faces: red, green and blue from 0 to 1; the fourth number is not used",
    "largest opacity of faces when ``scene.facesTransparent`` is set",
    "red, green and blue of light that comes from everywhere, for faces that no light reaches; used by the ray tracer as well; the fourth number is not used",
    "width of lines in pixels",
    "sharpness of highlights; larger is sharper",
    "red, green and blue of highlights; the fourth number is not used",
    "number of samples per pixel against jagged edges, of which there are at least 4 and at most 64; the next square number is taken",
    "depth of the visible space relative to the size of the scene; too small cuts near and far parts off, too large makes faces flicker",
};

constexpr std::array<std::string_view, 7> VSettingsRaytracerAdvanced_rows{
    "red, green and blue that reflected rays see where they leave the scene; the fourth number is not used",
    "factor of the number of cells of the search tree, from 1 to 128, for scenes with unevenly distributed faces",
    "factor by which the map of soft shadows is coarser than the image, from 0 to 16; 0: shadows are sampled as the image is",
    "number of smoothing steps of the map of soft shadows, from 0 to 32",
    "true: texts are part of the image; false: no text",
    "number of parts of the image per thread, for an even load; the image does not depend on it",
    "shift of lines towards the viewer relative to the size of the scene, so that lines on faces are visible",
};

constexpr std::array<std::string_view, 10> VSettingsRaytracer_rows{
    "red, green, blue and opacity of fog, each from 0 to 1",
    "density of fog relative to the size of the scene; 0: no fog",
    "factor by which the image is smaller than the window, from 1 to 16, for fast previews",
    "true: the window is kept responsive during long renderings",
    "number of positions on a light that are sampled for soft shadows, from 1 (hard shadows) to 256",
    "number of reflections that a ray follows, 32 at most",
    "number of transparent faces that a ray passes, 32 at most",
    "number of samples per pixel in each direction, from 1 to 4; the cost grows with its square",
    "number of threads, at most one for each core; the image does not depend on it",
    "amount of output on rendering: 0 no output, 1 times and counters, 2 or more details",
};

constexpr std::array<std::string_view, 33> VSettingsGeneral_rows{
    "fit the scene into the window when the renderer starts",
    "number of segments of axes and arrows",
    "red, green, blue and opacity of the background, at the top if it has a gradient, each from 0 to 1",
    "red, green, blue and opacity of the background at the bottom if it has a gradient, each from 0 to 1",
    "space around the bounding box after zooming to all, as a factor of its size",
    "smallest size of the bounding box when zooming to all",
    "number of segments of circles; the minimum is 2",
    "size of the coordinate system in the corner, relative to the font size",
    "number of segments around cylinders; the minimum is 2",
    "real time between two updates of the drawing while a solver runs",
    "true: windows are not larger than the screen; false: larger windows are allowed",
    "factor of fonts in windows and dialogs on Linux",
    "smallest size of the scene, for models without extension; positive",
    "size of points",
    "duration of a computation from which on closing the window asks for confirmation; 0: always",
    "number of significant digits in the render window, 16 at most",
    "time in milliseconds that a start of the renderer may take",
    "text that is shown in the render window",
    "seconds for which help is shown when the renderer starts; 0: none",
    "show the text of ``solutionSettings.solutionInformation``",
    "show name and state of the solver",
    "show the simulated time",
    "number of segments of spheres; the minimum is 2",
    "true: texts of items are drawn in front of everything; false: faces can hide them",
    "red, green, blue and opacity of texts of the window, each from 0 to 1",
    "draw a background behind texts of items",
    "shift of texts of items towards the viewer relative to the size of the scene; only without ``textAlwaysInFront``",
    "true: the state that is drawn is copied under a lock; false: faster, but pictures may mix two states",
    "true: texts are drawn from bitmaps; false: from lines",
    "draw the background with a vertical gradient",
    "true: the renderer runs in a thread of its own; false: in the thread of the solver; set it before the renderer starts",
    "scale fonts with the display scaling of Windows",
    "true: zooming to all uses the exact bounding box of the scene, without perspective; false: an estimate",
};

constexpr std::array<std::string_view, 14> VSettingsInteractiveAdvanced_rows{
    "red, green, blue and opacity of the highlighted item, each from 0 to 1",
    "red, green, blue and opacity of all other items while one is highlighted, each from 0 to 1",
    "factor of joystick rotations",
    "factor of joystick translations",
    "rotation of the view per key press",
    "translation of the view per key press, relative to the window",
    "rotation of the view per pixel of mouse movement",
    "the space bar pauses and continues a computation",
    "a click highlights an item",
    "a left click shows a short description of an item",
    "kinds of items that a left click selects, a sum of 1 nodes, 2 objects, 4 markers, 8 loads, 16 sensors",
    "a right click shows all parameters of an item",
    "a right click shows the graphics data as well, which may be long",
    "factor of the zoom per key press or step of the mouse wheel",
};

constexpr std::array<std::string_view, 4> VSettingsInteractiveOpenVR_rows{
    "absolute path of the file with the actions of the devices",
    "use OpenVR, if the package is built with it",
    "amount of output: -1 no output, 0 errors, 1 warnings, 2 information, 3 for debugging",
    "show the views of both eyes in a window",
};

constexpr std::array<std::string_view, 8> VSettingsInteractive_rows{
    "rotate the view by itself",
    "angular velocity of the rotating view",
    "number of the item that is highlighted; -1: none",
    "kind of the item that is highlighted",
    "number of the system in the container whose item is highlighted; the first is 0",
    "true: keys, except for escape and F2, are left to the key press user function",
    "write mouse coordinates to the console as well, if they are shown",
    "move and rotate the view with a six-axis joystick, if there is one",
};

constexpr std::array<std::string_view, 5> VSettingsDialogs_rows{
    "opacity of dialogs, from 0 to 1",
    "dialogs stay above other windows",
    "factor of fonts in dialogs on macOS",
    "true: the render window follows changes while a dialog is open; false: when it is closed",
    "open all branches of the dialog of visualization settings",
};

constexpr std::array<std::string_view, 11> VSettingsExportImages_rows{
    "the height of an image is a multiple of this number of pixels; 2 suits video encoders",
    "write circles, in the format TXT",
    "write lines, in the format TXT",
    "write texts, in the format TXT",
    "write triangles, in the format TXT",
    "number of the next image; increased with each image",
    "path and start of the names of image files, to which number and ending are added; directories are created",
    "format of images: PNG, TGA, or TXT for the lines and faces of the scene in text form",
    "true: the file name has no number, so that a new image replaces the one before; false: numbered files",
    "time in milliseconds that saving an image may take",
    "the width of an image is a multiple of this number of pixels; 4 suits video encoders",
};

constexpr std::array<SettingsText, 49> settings{{
    {"NewtonNumericalDifferentiationSettings", "Jacobians by numerical differentiation", NewtonNumericalDifferentiationSettings_rows},
    {"NewtonSettings", "Newton's method for the nonlinear equations of a step", NewtonSettings_rows},
    {"DiscontinuousSettings", "iterations for contact, friction and other discontinuous states, after Newton's method has converged", DiscontinuousSettings_rows},
    {"ContinuationSettings", "continuation of a solution that was stopped", ContinuationSettings_rows},
    {"DenseOutputSettings", "output between the ends of steps", DenseOutputSettings_rows},
    {"EventsSettings", "contact that opens or closes, friction that begins to slide or to stick, and stops", EventsSettings_rows},
    {"InitialConditionsSettings", "check of the initial values against the constraints", InitialConditionsSettings_rows},
    {"LinearSolverChoiceSettings", "selection of the linear solver", LinearSolverChoiceSettings_rows},
    {"LinearSolverSettings", "settings of the linear solver", LinearSolverSettings_rows},
    {"ParallelSettings", "computation with several threads", ParallelSettings_rows},
    {"RedundantConstraintsSettings", "constraint equations that follow from others, such as those of the second hinge of a door", RedundantConstraintsSettings_rows},
    {"SolutionSettings", "output to files: contents and intervals", SolutionSettings_rows},
    {"StaticSolverArcLengthSettings", "following a path of equilibria by its length instead of the load, over limit points and onto branches", StaticSolverArcLengthSettings_rows},
    {"StaticSolverSettings", "static solver: equilibrium under loads that are increased in steps", StaticSolverSettings_rows},
    {"StepSizeControlSettings", "step-size control by an error estimate", StepSizeControlSettings_rows},
    {"TimeIntegrationExplicitIntegrationSettings", "explicit integrators", TimeIntegrationExplicitIntegrationSettings_rows},
    {"TimeIntegrationGeneralizedAlphaSettings", "generalized-alpha, Newmark and implicit trapezoidal integrators", TimeIntegrationGeneralizedAlphaSettings_rows},
    {"TimeIntegrationSettings", "time integration", TimeIntegrationSettings_rows},
    {"SimulationSettings", "settings of the solvers: time integration, static solver, linear algebra, output and threads", SimulationSettings_rows},
    {"VSettingsViewCamera", "camera of a view", VSettingsViewCamera_rows},
    {"VSettingsViewScene", "contents of a view", VSettingsViewScene_rows},
    {"VSettingsViewWindow", "window of a view", VSettingsViewWindow_rows},
    {"VSettingsView", "a view of the model", {}},
    {"VSettingsLight", "one light", VSettingsLight_rows},
    {"VSettingsMaterial", "a material of the ray tracer", VSettingsMaterial_rows},
    {"VSettingsNodes", "drawing of nodes", VSettingsNodes_rows},
    {"VSettingsBodiesBeams", "drawing of beams and cables", VSettingsBodiesBeams_rows},
    {"VSettingsBodiesKinematicTree", "drawing of kinematic trees", VSettingsBodiesKinematicTree_rows},
    {"VSettingsBodiesShells", "drawing of plates and shells", VSettingsBodiesShells_rows},
    {"VSettingsBodies", "drawing of bodies", VSettingsBodies_rows},
    {"VSettingsConnectors", "drawing of connectors, joints and constraints", VSettingsConnectors_rows},
    {"VSettingsMarkers", "drawing of markers", VSettingsMarkers_rows},
    {"VSettingsLoads", "drawing of loads", VSettingsLoads_rows},
    {"VSettingsSensorsTraces", "traces of sensors in the render window", VSettingsSensorsTraces_rows},
    {"VSettingsSensors", "drawing of sensors", VSettingsSensors_rows},
    {"VSettingsContourAdvanced", "color scale of contours", VSettingsContourAdvanced_rows},
    {"VSettingsContour", "coloring by an output variable", VSettingsContour_rows},
    {"VSettingsContact", "drawing of general contact", VSettingsContact_rows},
    {"VSettingsOpenGLAdvanced", "OpenGL renderer: initial view, lighting and text", VSettingsOpenGLAdvanced_rows},
    {"VSettingsOpenGL", "OpenGL renderer: faces, lines and material", VSettingsOpenGL_rows},
    {"VSettingsRaytracerAdvanced", "software ray tracer: quality and speed", VSettingsRaytracerAdvanced_rows},
    {"VSettingsRaytracer", "software ray tracer", VSettingsRaytracer_rows},
    {"VSettingsGeneral", "general settings of drawing and window", VSettingsGeneral_rows},
    {"VSettingsInteractiveAdvanced", "highlighting, selection, and speed of keys and mouse", VSettingsInteractiveAdvanced_rows},
    {"VSettingsInteractiveOpenVR", "virtual reality by OpenVR", VSettingsInteractiveOpenVR_rows},
    {"VSettingsInteractive", "interaction with the render window", VSettingsInteractive_rows},
    {"VSettingsDialogs", "dialogs", VSettingsDialogs_rows},
    {"VSettingsExportImages", "export of images", VSettingsExportImages_rows},
    {"VisualizationSettings", "settings of the renderer", {}},
}};

constexpr std::array<std::string_view, 9> AccessFunctionType_values{
    "none",
    "derivative of the velocity of a local point with respect to the velocity coordinates: the Jacobian of positions",
    "derivative of the angular velocity at a local point with respect to the velocity coordinates: the Jacobian of rotations",
    "derivative of a single generalized coordinate with respect to the coordinates",
    "derivative of the integral of the displacement over a line, for loads per length",
    "derivative of the integral of the displacement over a surface, for loads per area",
    "derivative of the integral of the displacement over the volume, for loads per volume",
    "derivative of the integral of the displacement over the mass, for gravity and other mass proportional loads",
    "derivative of the integral of the displacement along the surface normal, for pressure",
};

constexpr std::array<std::string_view, 7> ConfigurationType_values{
    "no configuration; not accepted where a state is needed",
    "state at the start of a computation, as given by the initial values of the nodes",
    "state that the solver has reached; after a computation its final state",
    "undeformed state that the reference coordinates describe; velocities are zero",
    "state at the start of the step that is being computed; the last converged state",
    "state that is drawn; updated at intervals, so that it may lag behind the current one",
    "number of the values before; not a configuration",
};

constexpr std::array<std::string_view, 6> ContactTypeIndex_values{
    "spheres at markers",
    "surfaces of planar cable elements",
    "triangles fixed to rigid bodies",
    "number of the values before; not a kind of contact",
    "boxes, cylinders, capsules and convex hulls at markers",
    "planes fixed to rigid bodies",
};

constexpr std::array<std::string_view, 2> CrossSectionType_values{
    "polygon, given by its corners",
    "circle, given by its radius",
};

constexpr std::array<std::string_view, 13> DynamicSolverType_values{
    "implicit, second order with adjustable numerical damping, for all models; its parameters are in ``timeIntegration.generalizedAlpha``",
    "implicit trapezoidal rule (Newmark) with constraints on velocity level; second order, no numerical damping",
    "explicit, first order, one evaluation per step",
    "explicit, second order, two evaluations per step",
    "explicit Runge-Kutta method of order 3 with three stages and fixed step",
    "explicit Runge-Kutta method of order 4 with four stages and fixed step",
    "explicit Runge-Kutta method of order 6 with seven stages and fixed step",
    "explicit Runge-Kutta method of Bogacki and Shampine, order 3 with error estimate of order 2 and automatic step size",
    "explicit Runge-Kutta method of Dormand and Prince, order 5 with error estimate of order 4 and automatic step size",
    "named for scripts of Exudyn; no solver has it and ``solverType`` refuses it: ``DOPRI5`` and ``DOP853`` are of orders 5 and 8",
    "explicit, second order (first where forces depend on velocities), one evaluation per step; suitable for particles and contact",
    "explicit Runge-Kutta method of Dormand and Prince, order 8 with error estimates of orders 5 and 3 and automatic step size; suitable for tight tolerances",
    "diagonally implicit Runge-Kutta method of Kennedy and Carpenter, order 4 with error estimate of order 3 and automatic step size; L-stable, for stiff systems and higher accuracy than generalized alpha",
};

constexpr std::array<std::string_view, 6> ItemType_values{
    "no item",
    "node: coordinates",
    "object: body, connector, constraint, joint, contact or finite element",
    "marker: a point or frame of a node or object at which loads and connectors act",
    "load: force, torque or generalized force",
    "sensor: a measured output",
};

constexpr std::array<std::string_view, 7> JointType_values{
    "no joint; refused in a kinematic tree",
    "rotation about the x-axis, coordinate in rad",
    "rotation about the y-axis, coordinate in rad",
    "rotation about the z-axis, coordinate in rad",
    "translation along the x-axis, coordinate in m",
    "translation along the y-axis, coordinate in m",
    "translation along the z-axis, coordinate in m",
};

constexpr std::array<std::string_view, 18> KeyCode_values{
    "space bar",
    "enter key",
    "tabulator key",
    "backspace key",
    "cursor right",
    "cursor left",
    "cursor down",
    "cursor up",
    "function key F1",
    "function key F2",
    "function key F3",
    "function key F4",
    "function key F5",
    "function key F6",
    "function key F7",
    "function key F8",
    "function key F9",
    "function key F10",
};

constexpr std::array<std::string_view, 5> LinearSolverType_values{
    "no solver; refused",
    "dense factorization with partial pivoting; suitable for small systems",
    "sparse LU factorization; suitable for models with many coordinates",
    "sparse factorization for symmetric positive definite systems; not for models with constraints or unsymmetric forces",
    "dense factorization with full pivoting, which tolerates redundant constraints; slower than the other dense one",
};

constexpr std::array<std::string_view, 5> NodeGroup_values{
    "no coordinates",
    "coordinates of first order differential equations",
    "coordinates of second order differential equations",
    "algebraic variables",
    "data variables",
};

constexpr std::array<std::string_view, 19> NodeType_values{
    "nothing",
    "fixed node without coordinates",
    "position in the x-y plane",
    "rotation about z",
    "position and one slope vector in the plane",
    "position in space",
    "orientation in space",
    "displacements and rotations of a rigid body",
    "rotation by Euler parameters",
    "rotation by Tait-Bryan angles about x, y and z",
    "rotation by a rotation vector",
    "rotation that integrators update by composition on the Lie group instead of by sums",
    "second order coordinates without a meaning in space",
    "first order coordinates",
    "algebraic variables",
    "data variables",
    "position and one slope vector",
    "position and the slope vectors in x and y",
    "position and the slope vectors in y and z",
};

constexpr std::array<std::string_view, 10> ObjectType_values{
    "none of the following",
    "ground without coordinates",
    "algebraic equations between markers",
    "forces between markers; also the base of constraints and joints",
    "has local points with position, so that body markers can be attached",
    "uses one node",
    "uses several nodes",
    "finite element",
    "many mesh nodes, reached by super element markers and outputs",
    "upper bound of the values; not a kind of object",
};

constexpr std::array<std::string_view, 40> OutputVariableType_values{
    "no output variable; sensors refuse it",
    "distance between two points, or gap of a contact",
    "position in global coordinates",
    "displacement from the reference configuration in global coordinates; connectors have the relative displacement",
    "displacement in local coordinates, of body or joint",
    "velocity in global coordinates; connectors have the relative velocity",
    "velocity in local coordinates, of body or joint",
    "acceleration in global coordinates",
    "acceleration in body coordinates",
    "nine components of the rotation matrix from body to global frame, row by row",
    "angles: three Tait-Bryan angles about x, y and z, or one angle for planar items",
    "angular velocity in global coordinates",
    "angular velocity in local coordinates, of body or joint",
    "angular acceleration in global coordinates",
    "angular acceleration in body coordinates",
    "coordinates including the reference coordinates",
    "coordinates relative to the reference coordinates",
    "first time derivatives of the coordinates",
    "second time derivatives of the coordinates",
    "path along a beam or curve, of sliding joints",
    "first direction: slope or axis vector in x",
    "second direction: slope or axis vector in y",
    "third direction: slope or axis vector in z",
    "force in global coordinates; super elements have the generalized forces",
    "force in local coordinates; beams have the section forces",
    "torque in global coordinates",
    "torque in local coordinates; beams have the section moments",
    "number of equations of a constraint or joint whose reactions are not unique, because constraints are redundant; solvers return the minimum-norm ones. NaN before the first solution",
    "force (N) and torque (Nm) that a connector, joint or constraint exerts on the body of its first marker, in global axes; six components. Markers of coordinates have the generalized forces instead. The sign is the same in statics and dynamics",
    "the same for the second marker",
    "components of ``WrenchOnMarker0`` in joint frame J0, or in the frame of the marker if the item has no ``rotationMarker0``",
    "components of ``WrenchOnMarker1`` in joint frame J1, or in the frame of the marker if the item has no ``rotationMarker1``",
    "strain components in the local frame",
    "stress components in the local frame",
    "curvature and twist in the local frame",
    "residual of the constraint equations of a constraint or joint",
    "kinetic energy of a body, of all of its points",
    "energy that a body or connector stores: strain energy, and the potential of forces among its own parameters, such as the gravity of a kinematic tree; loads are not included",
    "position and rotation as a 4 x 4 matrix: from the body frame to the global frame; of joints, frame J0. Output functions return ``exu.HT``, sensors have the 16 entries, row by row",
    "relative position and rotation of joint frame J1 in joint frame J0 as a 4 x 4 matrix",
};

constexpr std::array<EnumText, 13> enumerations{{
    {"derivatives and integrals of kinematic quantities that an object offers to markers", AccessFunctionType_values},
    {"the state of the model that an output or a vector of coordinates is taken from", ConfigurationType_values},
    {"kinds of contact partners in general contact, as indices", ContactTypeIndex_values},
    {"shape of the cross section of a beam, for drawing and contact", CrossSectionType_values},
    {"time integration methods", DynamicSolverType_values},
    {"the five kinds of items", ItemType_values},
    {"joints of a kinematic tree, each with one coordinate; axes are those of the joint frame", JointType_values},
    {"keys without a character, as passed to a key press user function; keys with a character are passed as that character's code", KeyCode_values},
    {"direct solvers for linear systems of equations", LinearSolverType_values},
    {"kinds of coordinates that a node has; values can be joined", NodeGroup_values},
    {"capabilities of a node; values can be combined", NodeType_values},
    {"categories of an object; values can be combined", ObjectType_values},
    {"quantities that items offer to outputs and sensors; the page of an item lists those that it has, with size and frame", OutputVariableType_values},
}};

}  // namespace settings_texts_of

std::span<const SettingsText> settings_texts() { return settings_texts_of::settings; }
std::span<const EnumText> enum_texts() { return settings_texts_of::enumerations; }

}  // namespace dalembert
