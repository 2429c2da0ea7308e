// Stiffness detection of explicit solvers with error control: steps that are limited by stability instead of accuracy.
// Hairer, Wanner, Solving Ordinary Differential Equations II, section IV.2.
#include <algorithm>
#include <cmath>

#include "dalembert/output/numbers.hpp"
#include "dalembert/solvers/explicit.hpp"
#include "diagnosis/stability.hpp"

namespace dalembert {

namespace {

constexpr StepCount look_every = 200;    // steps between checks without indication
constexpr int sure = 15, wrong = 6;      // steps with and without indication that decide
constexpr double near_limit = 0.7;       // part of the stable step

double length_of(std::span<const double> x, std::span<const double> y) {
  double sum = 0;
  for (const double number : x) sum += number * number;
  for (const double number : y) sum += number * number;
  return std::sqrt(sum);
}

}  // namespace

// The error of a step close to the stability limit is in the direction of the fastest modes. The change of
// accelerations and rates for a small part of this error is larger by the eigenvalue, which is returned; zero if it is
// not available.
double ExplicitSolver::eigenvalue_along_error() {
  constexpr double small = 1e-6;
  State& now = current();
  const State end = now;
  const auto difference = [](const Vector& from, Vector to) {
    for (std::size_t i = 0; i < to.size(); ++i) to[i] -= from[i];
    return to;
  };
  const Vector error_q = difference(now.q, second_q_), error_v = difference(now.v, second_v_),
               error_y = difference(now.y, second_y_);
  const double length = length_of(error_v, error_y), part = small * std::max(1.0, length_of(now.v, now.y)) / length;
  if (!(length > 0) || !std::isfinite(part)) return 0;
  Vector a(now.a.size()), y_t(now.y.size()), moved_a = a, moved_y_t = y_t;
  bool known = accelerations(a, y_t);
  for (std::size_t i = 0; i < a.size(); ++i) {
    now.q[i] += part * error_q[i];
    now.v[i] += part * error_v[i];
  }
  for (std::size_t i = 0; i < y_t.size(); ++i) now.y[i] += part * error_y[i];
  known = known && accelerations(moved_a, moved_y_t);
  now = end;
  conv.linearSolverFailed = conv.massMatrixNotInvertible = false;
  return known ? length_of(difference(a, moved_a), difference(y_t, moved_y_t)) / (part * length) : 0;
}

// Returns the limit for damped modes; undamped ones are hardly stable below it.
double ExplicitSolver::stability_limit() const {
  double limit = 1;
  const auto stable = [&](double z) {
    return amplification(method_, {.frequency = z, .damping = 2 * z, .coordinate = -1}, 1.0) <= 1;
  };
  while (limit < 20 && stable(limit)) limit += 0.05;
  return limit;
}

bool ExplicitSolver::at_stability_limit(double step_size) {
  return step_size * eigenvalue_along_error() > near_limit * stability_limit();
}

// Called after an accepted step.
void ExplicitSolver::look_for_stiffness(double step_size) {
  if (warned_of_stiffness_ || (it.currentStepIndex % look_every != 0 && stiff_signs_ == 0)) return;
  if (at_stability_limit(step_size)) {
    calm_signs_ = 0;
    ++stiff_signs_;
  } else if (++calm_signs_ >= wrong) {
    stiff_signs_ = calm_signs_ = 0;
  }
  if (stiff_signs_ < sure) return;
  warned_of_stiffness_ = true;
  warn(name() + ": the system is stiff for this method: at time " + format_number(it.currentTime) + ", steps of " +
       format_number(step_size, 3) +
       " s are as large as stability allows, not accuracy. Implicit methods take larger ones: "
       "exu.DynamicSolverType.ESDIRK43, or GeneralizedAlpha "
       "with stepSizeControl.implicitSolvers=True");
}

}  // namespace dalembert
