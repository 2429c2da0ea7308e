// Why a solver gave up.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace dalembert {

enum class FailureReason {
  none,
  newton,           // no convergence, and the step could not be made smaller
  open_constraints,  // a step has left gaps that cannot be closed
  singular_matrix,  // the system matrix cannot be factorized
  free_direction,   // because coordinates can move without inertia, stiffness or constraint
  contradiction,    // no motion fulfils all constraints
  mass_matrix,      // explicit: the mass matrix cannot be inverted
  discontinuous,    // friction or contact did not settle
  event_chatter,    // events follow each other ever faster
  error_control,    // the estimated error stays above the tolerances at the smallest step size
  stiff,            // explicit: the same, because steps of this size are not stable
  singular_position,  // it is not left: the mechanism could go on in more ways than one
  round_off,        // tolerances ask for more than numbers have
  not_finite,       // a coordinate, or what an equation is made of, is infinite or not a number
  unbounded,        // the solution has grown beyond every physical quantity
  path_length,      // staticSolver.arcLength.maximumSteps
  time_limit        // exu.special.solver.timeout
};
std::string_view name_of(FailureReason reason);  // as users read it: "singularMatrix"

// One number of a vector, named where it stands out.
struct NamedValue {
  int index;
  double value;
  std::string vector;  // "equation", or a vector of the state: "ODE2_t"
  std::string items;   // which items it belongs to
};

struct Diagnosis {
  FailureReason reason = FailureReason::none;
  std::string solver;
  std::int64_t step = 0;
  int newton_iteration = 0;
  double time = 0, step_size = 0, load_factor = 1;
  double residual = 0, relative_residual = 0, tolerance_relative = 0, tolerance_absolute = 0;
  std::vector<NamedValue> values;      // the worst ones: residuals, errors, or numbers that are not finite
  std::vector<std::string> sources;    // items that give values that are not finite
  int singular_row = -1;
  std::string singular_items;
  std::vector<std::string> dependent;  // equations of which a combination vanishes, item by item
  std::vector<std::string> free;       // coordinates that can move without anything in their way, item by item
  std::vector<std::string> advice;     // what to try, one sentence each

  bool failed() const { return reason != FailureReason::none; }
  std::string headline() const;  // what happened in which step
  std::string text() const;
};

}  // namespace dalembert
