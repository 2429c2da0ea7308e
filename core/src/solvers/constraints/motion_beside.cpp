// Motions beside a singular position: what is redundant there as well, and along which of the ways out of it the motion goes on.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "constraints/constraint_states.hpp"
#include "dalembert/solvers/constrained_motion.hpp"
#include "steppers/number_sequence.hpp"

namespace dalembert {

namespace {

// What counts as beside a position: far enough that what is singular there shows, and so close that constraints are left open by little.
constexpr double little = 1e-4;

// Of a motion in each mechanism: so much, relative to the size of it or to a radian; of all at once, relative to that of the model, where none are known.
void add_part(const System& system, double part, std::span<const double> direction, std::span<double> step, std::span<const int> mechanisms = {},
              std::span<const double> lengths = {}) {
  const std::vector<CoordinateUnit> units = system.coordinate_units();
  const double extent = system.extent();
  std::vector<double> sizes(lengths.size() + 1);  // of those that belong to none at last
  const auto mechanism = [&](std::size_t i) { return mechanisms.empty() || mechanisms[i] < 0 ? lengths.size() : static_cast<std::size_t>(mechanisms[i]); };
  for (std::size_t i = 0; i < direction.size(); ++i) {
    const std::size_t m = mechanism(i);
    const double length = m < lengths.size() && lengths[m] > 0 ? lengths[m] : extent;
    sizes[m] = std::max(sizes[m], std::abs(direction[i]) / (units[i] == CoordinateUnit::meter ? length : 1));
  }
  for (std::size_t i = 0; i < direction.size(); ++i)
    if (const double size = sizes[mechanism(i)]; size > at_rest) step[i] += part * direction[i] / size;
}

}  // namespace

// The factors at a state beside another one.
bool ConstrainedMotion::is_regular_beside(const ConstrainedMotion& other, System& system, const State& at, const Conditions& conditions,
                                          std::span<const double> step) {
  State moved = at;
  move_positions(system, step, moved.q);
  prepare(system, other.type_, other.options_, other.settings_);
  looks_beside_ = false;
  return factorize(system, moved, conditions) == LinearSolver::success && knowledge_ != Knowledge::passing;
}

void ConstrainedMotion::add_free_motion(double part, const System& system, const State& at, std::span<double> step) {
  const auto n = static_cast<std::size_t>(ode2_);
  NumberSequence random;
  std::vector<double> x(x_.size(), 0.0);
  for (std::size_t i = 0; i < n; ++i) x[i] = matrix_[static_cast<std::size_t>(pattern_->slot(static_cast<int>(i), static_cast<int>(i)))] * random();
  solve(x);
  const auto add = [&](std::span<const double> direction) {
    if (redundant_.in_use()) add_part(system, part, direction, step, redundant_.mechanisms(), redundant_.lengths());
    else add_part(system, part, direction, step);
  };
  add(std::span<const double>(x).first(n));
  if (std::inner_product(step.begin(), step.end(), at.v.begin(), 0.0) < 0)  // where there is one motion alone, they would cancel
    for (double& s : step) s = -s;
  add(at.v);
}

State ConstrainedMotion::moved_by(double part, System& system, const State& at, const Conditions& conditions) {
  State moved = at;
  std::vector<double> step(static_cast<std::size_t>(ode2_));
  if (factorize(system, at, conditions) != LinearSolver::success) return moved;
  add_free_motion(part, system, at, step);
  ConstrainedMotion there;
  if (there.is_regular_beside(*this, system, at, conditions, step)) {
    move_positions(system, step, moved.q);
    there.project(system, moved, conditions);
  }
  return moved;
}

// By pivots at hand, as far as this is evident. What vanishes in a singular position alone is far above this eps.
bool ConstrainedMotion::same_follow_beside(System& system, const State& at, const Conditions& conditions, std::span<const double> step) {
  const std::vector<double> here = matrix_;
  State moved = at;
  move_positions(system, step, moved.q);
  fill(system, moved, conditions);
  RedundantConstraints there = redundant_;
  bool same = there.confirm_locally(*pattern_, matrix_);
  if (same) {
    redundant_.found_beside();
  } else if (there.measure(system, *pattern_, matrix_, settings_.momentLength, 1) && there.take_over(redundant_)) {
    there.use(redundant_.counting());
    there.regularize(*pattern_, matrix_, 1);
    same = factors_->factorize(matrix_) == LinearSolver::success && there.confirm(*pattern_, matrix_, *factors_);
    factors_->factorize(here);
  }
  matrix_ = here;
  return same;
}

// Redundancy that lasts is also there a little further on, along the velocities and where any forces would lead: off the constraints by the square
// of that, equations are independent by its fourth power, beside a singular position by its square.
bool ConstrainedMotion::fewer_follow_beside(System& system, const State& at, const Conditions& conditions) {
  std::vector<double> step(static_cast<std::size_t>(ode2_));
  add_free_motion(little, system, at, step);
  if (same_follow_beside(system, at, conditions, step)) return false;
  ConstrainedMotion beside;
  const bool regular = beside.is_regular_beside(*this, system, at, conditions, step);
  system.reactions_are_known(redundant_.equations());
  return regular && beside.redundant_.count() < redundant_.count();
}

// Of the motion with constant accelerations from the start on: beside a singular position, gaps open by their change of velocities as much as
// by themselves.
bool ConstrainedMotion::accelerations_after(double time, System& system, const State& start, const Conditions& conditions, std::vector<double>& a,
                                            std::vector<double>& lambda) {
  constexpr int most = 20;
  constexpr double exact = 1e-10, good = 1e-5;
  State moved = start;
  moved.time += time;
  double last = 0;
  for (int i = 0; i < most; ++i) {
    std::vector<double> step(a.size());
    for (std::size_t j = 0; j < a.size(); ++j) {
      step[j] = time * (start.v[j] + 0.5 * time * a[j]);
      moved.v[j] = start.v[j] + time * a[j];
    }
    moved.q = start.q;
    move_positions(system, step, moved.q);
    moved.a = a;
    moved.lambda = lambda;
    system.tangent(moved, conditions, {.q = 0.5 * time * time, .v = time, .a = 1, .y = 0, .y_t = 1}, *pattern_, matrix_);
    leave_out_ode1(system.sizes(), *pattern_, matrix_);
    if (factorize_around_matrix(system, moved, conditions, time) != LinearSolver::success) return false;
    std::vector<double> x(x_.size());
    system.residual(moved, conditions, x);
    std::fill(x.begin() + ode2_, x.begin() + first_ae_, 0.0);
    std::ranges::copy(gap_accelerations(system, moved, conditions), x.begin() + first_ae_);
    solve(x);
    for (std::size_t j = 0; j < a.size(); ++j) a[j] -= x[j];
    for (std::size_t k = 0; k < lambda.size(); ++k) lambda[k] -= x[static_cast<std::size_t>(first_ae_) + k];
    const double change = largest(std::span(x).first(a.size())) / std::max(1.0, largest(a));
    if (change <= exact || (i > 0 && change <= good && change > 0.1 * last)) return true;  // the latter: of what is left, differences are round-off
    last = change;
  }
  return false;
}

namespace {

// A start in a singular position is looked at after moments in which the motion covers this part of the size of the model ...
constexpr double part_of_motion = 1e-3;
// ... and velocities do not change by more than this part of them.
constexpr double change_of_velocity = 0.03;
// By how much accelerations at three moments may be off a straight line, relative to their size.
constexpr double smooth = 1e-2;

double moment_after(const State& start, std::span<const double> a) {
  const double speed = largest(start.v), moment = part_of_motion * std::max(1.0, largest(start.q)) / speed;
  return std::min(moment, change_of_velocity * speed / std::max(largest(a), 1e-300));
}

// Of values at three moments in a row: the parabola one moment before, and how much it is bent.
double bend(const std::vector<double>* x, std::size_t i) { return x[0][i] - 2 * x[1][i] + x[2][i]; }
void extrapolate(const std::vector<double>* x, std::span<double> to) {
  for (std::size_t i = 0; i < to.size(); ++i) to[i] = 2 * x[0][i] - x[1][i] + bend(x, i);
}
bool is_smooth(const std::vector<double>* x) {
  const double most = smooth * std::max(1.0, largest(x[0]));
  for (std::size_t i = 0; i < x[0].size(); ++i)
    if (!(std::abs(bend(x, i)) <= most)) return false;
  return true;
}

}  // namespace

// A state further along the velocities, which do not change on the way there, on the constraints.
bool ConstrainedMotion::accelerations_beside(double part, const ConstrainedMotion& other, System& system, const State& start, const Conditions& conditions,
                                             std::vector<double>& a, std::vector<double>& lambda) {
  std::vector<double> step(start.v.size());
  add_part(system, part, start.v, step);
  if (!is_regular_beside(other, system, start, conditions, step)) return false;
  State moved = start;
  move_positions(system, step, moved.q);
  if (!project(system, moved, conditions) || factorize(system, moved, conditions) != LinearSolver::success) return false;
  std::vector<double> y_t(start.y.size());
  a.resize(start.v.size());
  lambda.resize(start.lambda.size());
  system.right_hand_sides(moved, conditions, a, y_t);
  return accelerations(system, moved, conditions, a, lambda);
}

// Where forces turn velocities before these have led away from a singular position, they still tell along which of the ways out of it accelerations lie.
void ConstrainedMotion::follow_velocities(System& system, const State& start, const Conditions& conditions, std::span<double> a, std::span<double> lambda) {
  std::vector<double> accelerations[3], multipliers[3];
  for (int i = 0; i < 3; ++i) {
    ConstrainedMotion beside;
    if (!beside.accelerations_beside((i + 1) * part_of_motion, *this, system, start, conditions, accelerations[i], multipliers[i])) return;
  }
  if (!is_smooth(accelerations)) return;
  extrapolate(accelerations, a);
  extrapolate(multipliers, lambda);
}

// From three moments after the start, by a parabola. While constraints are still dependent to round-off, the motion could well be another one.
bool ConstrainedMotion::leave_singular_position(System& system, const State& start, Conditions conditions, std::span<double> a,
                                                std::span<double> lambda) {
  constexpr std::size_t moments = 3;
  if (knowledge_ != Knowledge::passing) return true;
  if (!(largest(start.v) > at_rest)) return false;
  const double moment = moment_after(start, a);
  conditions.inertia = true;
  conditions.rate_level = false;
  std::vector<double> step(start.v.size()), first_step = start.v;
  add_part(system, little, start.v, step);
  for (double& x : first_step) x *= moment;
  ConstrainedMotion beside, soon;
  bool leaves = beside.is_regular_beside(*this, system, start, conditions, step);
  const bool leaves_soon = leaves && soon.is_regular_beside(*this, system, start, conditions, first_step) && soon.redundant_.count() == beside.redundant_.count();
  std::vector<double> accelerations[moments], multipliers[moments];
  for (std::size_t i = 0; i < moments && leaves; ++i) {
    accelerations[i] = i > 0 ? accelerations[i - 1] : std::vector<double>(a.begin(), a.end());
    multipliers[i] = i > 0 ? multipliers[i - 1] : std::vector<double>(lambda.begin(), lambda.end());
    leaves = beside.accelerations_after(static_cast<double>(i + 1) * moment, system, start, conditions, accelerations[i], multipliers[i]);
  }
  if (!leaves || !is_smooth(accelerations)) {
    follow_velocities(system, start, conditions, a, lambda);
    system.reactions_are_known(redundant_.equations());
    return false;
  }
  extrapolate(accelerations, a);
  extrapolate(multipliers, lambda);
  if (!leaves_soon) follow_velocities(system, start, conditions, a, lambda);
  redundant_ = std::move(beside.redundant_);
  factors_ = std::move(beside.factors_);
  system.reactions_are_known(redundant_.equations());
  knowledge_ = Knowledge::beside;
  return leaves_soon;
}

}  // namespace dalembert
