// Reasons of failures of a solver.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace dalembert {

enum class FailureReason {
  none,
  newton,           // no convergence, and the step could not be reduced further
  open_constraints,  // a step ended with gaps that cannot be closed
  singular_matrix,  // the system matrix cannot be factorized
  free_direction,   // coordinates can move without inertia, stiffness or constraint
  contradiction,    // no motion fulfils all constraints
  mass_matrix,      // explicit: the mass matrix cannot be inverted
  discontinuous,    // friction or contact did not converge
  event_chatter,    // events follow each other ever faster
  error_control,    // the estimated error remains above the tolerances at the smallest step size
  stiff,            // explicit: likewise, because steps of this size are unstable
  singular_position,  // the solution does not leave it: there are several branches
  round_off,        // tolerances are below round-off
  not_finite,       // a coordinate or a term of an equation is infinite or not a number
  unbounded,        // the solution is larger than any physical quantity
  path_length,      // staticSolver.arcLength.maximumSteps
  time_limit        // exu.special.solver.timeout
};
std::string_view name_of(FailureReason reason);  // name in the interface: "singularMatrix"

// A component of a vector, with its name.
struct NamedValue {
  int index;
  double value;
  std::string vector;  // "equation", or a vector of the state: "ODE2_t"
  std::string items;   // items to which it belongs
};

struct Diagnosis {
  FailureReason reason = FailureReason::none;
  std::string solver;
  std::int64_t step = 0;
  int newton_iteration = 0;
  double time = 0, step_size = 0, load_factor = 1;
  double residual = 0, relative_residual = 0, tolerance_relative = 0, tolerance_absolute = 0;
  std::vector<NamedValue> values;      // the largest ones: residuals, errors, or numbers that are not finite
  std::vector<std::string> sources;    // items with values that are not finite
  int singular_row = -1;
  std::string singular_items;
  std::vector<std::string> dependent;  // linearly dependent equations, item by item
  std::vector<std::string> free;       // free coordinates, item by item
  std::vector<std::string> advice;     // remedies, one sentence each

  bool failed() const { return reason != FailureReason::none; }
  std::string headline() const;  // failure and step
  std::string text() const;
};

}  // namespace dalembert
