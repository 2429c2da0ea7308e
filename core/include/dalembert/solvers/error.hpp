// Why a solver gave up.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace dalembert {

enum class FailureReason {
  none,
  newton,            // no convergence, and the step could not be made smaller
  singular_matrix,   // the system matrix cannot be factorized
  mass_matrix,       // explicit: the mass matrix cannot be inverted
  discontinuous,     // friction or contact did not settle
  step_size,         // automatic step size would have to fall below the minimum
  stopped
};

struct WorstRow {
  int row;
  double residual;
  std::string items;  // which items act there
};

struct Diagnosis {
  FailureReason reason = FailureReason::none;
  std::string solver;
  int step = 0, newton_iteration = 0;
  double time = 0, step_size = 0, load_factor = 1;
  double residual = 0, relative_residual = 0, tolerance_relative = 0, tolerance_absolute = 0;
  std::vector<WorstRow> worst_rows;    // largest first
  int singular_row = -1;
  std::string singular_items;
  std::vector<std::string> dependent;  // equations of which a combination vanishes, item by item
  std::vector<std::string> advice;     // what to try, one sentence each

  std::string text() const;
};

class SolverError : public std::runtime_error {
 public:
  explicit SolverError(Diagnosis diagnosis) : std::runtime_error(diagnosis.text()), diagnosis_(std::move(diagnosis)) {}
  const Diagnosis& diagnosis() const { return diagnosis_; }

 private:
  Diagnosis diagnosis_;
};

}  // namespace dalembert
