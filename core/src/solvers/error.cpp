#include "dalembert/solvers/error.hpp"

#include "dalembert/output/numbers.hpp"

namespace dalembert {

namespace {

const char* sentence(FailureReason reason) {
  switch (reason) {
    case FailureReason::newton: return "Newton's method did not converge";
    case FailureReason::singular_matrix: return "the system matrix is singular";
    case FailureReason::mass_matrix: return "the mass matrix is singular";
    case FailureReason::discontinuous: return "the discontinuous iteration (contact, friction) did not settle";
    case FailureReason::step_size: return "the step size reached its minimum";
    case FailureReason::stopped: return "the solver was stopped";
    case FailureReason::none: break;
  }
  return "no failure";
}

}  // namespace

std::string Diagnosis::text() const {
  std::string t = solver + ": " + sentence(reason) + " in step " + std::to_string(step) + " at time " +
                  format_number(time) + " (step size " + format_number(step_size) + ")";
  if (load_factor != 1) t += ", load factor " + format_number(load_factor);
  t += '.';
  if (reason == FailureReason::newton || reason == FailureReason::discontinuous) {
    t += "\n  residual " + format_number(residual) + " after " + std::to_string(newton_iteration) +
         " iterations; relative " + format_number(relative_residual) + " (allowed " +
         format_number(tolerance_relative) + ", or absolute " + format_number(tolerance_absolute) + ")";
  }
  if (singular_row >= 0) {
    t += "\n  no pivot for unknown " + std::to_string(singular_row);
    if (!singular_items.empty()) t += ": " + singular_items;
  }
  if (!dependent.empty()) t += "\n  equations that depend on each other:";
  for (const std::string& d : dependent) t += "\n    " + d;
  if (!worst_rows.empty()) t += "\n  largest residuals:";
  for (const WorstRow& w : worst_rows) {
    t += "\n    equation " + std::to_string(w.row) + ": " + format_number(w.residual) +
         (w.items.empty() ? "" : "  (" + w.items + ")");
  }
  if (!advice.empty()) t += "\n  what to try:";
  for (const std::string& a : advice) t += "\n    - " + a;
  return t;
}

}  // namespace dalembert
