#include "dalembert/solvers/constrained_motion.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "constraints/constraint_states.hpp"
#include "dalembert/solvers/numerical_tangent.hpp"
#include "dalembert/solvers/open_constraints.hpp"

namespace dalembert {

namespace {

// Gaps relative to the size of the model: `closed` is round-off. Gaps up to `accepted` may remain if projections do not
// reduce them further, because redundant constraints may contradict each other.
constexpr double closed = 1e-13, accepted = 1e-9;
constexpr int most_projections = 10;

// Writes the rows of the constraints.
//
// Gradients are those of the rates by the velocities: Euler parameters turn a frame without their own lengthening, which
// the gradient of a gap contains. Constraints of velocities are their own rates, so they are differentiated once, not twice.
void add_gradients(System& system, const State& state, Conditions conditions, const Pattern& pattern,
                   std::span<double> matrix, std::span<double> part) {
  const int end_of_ode2 = system.sizes().ode2, first_ae = system.sizes().first_ae();
  conditions.rate_level = true;
  system.tangent(state, conditions, along_velocities, pattern, part);
  for (int j = 0; j < end_of_ode2; ++j) {
    const ColumnRange column = column_range(pattern, j, first_ae);
    std::copy(part.data() + column.middle, part.data() + column.end, matrix.data() + column.middle);
  }
}

// If accelerations change velocities by h and positions by h^2, they change the accelerations of gaps by
// G + 2 h dG/dt + h^2 d^2G/dt^2, which is computed by differences along the motion. Near a singular position G is small in
// some directions, so that its changes dominate.
void add_changes_of_gradients(System& system, const State& still, Conditions conditions, double h,
                              const Pattern& pattern, std::span<double> matrix, std::span<double> part) {
  conditions.rate_level = true;
  double speed = 0, size = 1;
  for (const double v : still.v) speed = std::max(speed, std::abs(v));
  for (const double q : still.q) size = std::max(size, std::abs(q));
  if (!(speed > 1e-10)) return;
  const double tau = 1e-4 * size / speed, first = h / tau, second = first * first;
  const auto add = [&](double time, double factor) {
    State moved = still;
    std::vector<double> step(still.q.size());
    for (std::size_t i = 0; i < step.size(); ++i) step[i] = time * (still.v[i] + 0.5 * time * still.a[i]);
    move_positions(system, step, moved.q);
    system.tangent(moved, conditions, along_velocities, pattern, part);
    for (int j = 0; j < system.sizes().ode2; ++j) {
      const ColumnRange column = column_range(pattern, j, system.sizes().first_ae());
      for (std::size_t k = column.middle; k < column.end; ++k) matrix[k] += factor * part[k];
    }
  };
  add(tau, first + second);
  add(-tau, second - first);
  add(0, -2 * second);
}

// The columns of the multipliers, around the mass matrix.
void add_forces_of_multipliers(System& system, const State& state, const Conditions& conditions, const Pattern& pattern,
                               std::span<double> matrix, std::span<double> part) {
  const int end_of_ode2 = system.sizes().ode2, first_ae = system.sizes().first_ae();
  system.tangent(state, conditions, along_positions, pattern, part);
  for (int j = end_of_ode2; j < pattern.size(); ++j) {
    const ColumnRange column = column_range(pattern, j, first_ae);
    const std::size_t begin = j < first_ae ? column.middle : column.begin;
    std::copy(part.data() + begin, part.data() + column.end, matrix.data() + begin);
  }
}

}  // namespace

void ConstrainedMotion::prepare(System& system, LinearSolverType type, const LinearSolverOptions& options,
                                const RedundantConstraintsSettings& settings, double end_time) {
  *this = ConstrainedMotion();
  type_ = type;
  options_ = options;
  settings_ = settings;
  end_time_ = end_time;
  treats_redundancy_ = system.sizes().ae > 0 && settings.treat && !options.ignore_singular;
  pattern_ = &system.pattern(is_dense(type));
  ode2_ = system.sizes().ode2;
  first_ae_ = system.sizes().first_ae();
  matrix_.resize(static_cast<std::size_t>(pattern_->values()));
  x_.resize(static_cast<std::size_t>(system.sizes().total()));
  factors_ = make_linear_solver(*pattern_, type, options);
}

void ConstrainedMotion::free_memory() {
  factors_.reset();
  for (std::vector<double>* numbers : {&matrix_, &part_, &x_}) *numbers = {};
}

void ConstrainedMotion::fill(System& system, const State& state, const Conditions& conditions) {
  const State still = without_multipliers(state);
  const Conditions of_positions = at_level(conditions, false);
  system.mass_matrix(still, *pattern_, matrix_);
  if (system.sizes().ae > 0) {
    part_.resize(matrix_.size());
    add_forces_of_multipliers(system, still, of_positions, *pattern_, matrix_, part_);
    add_gradients(system, still, of_positions, *pattern_, matrix_, part_);
  }
  leave_out_ode1(system.sizes(), *pattern_, matrix_);
}

int ConstrainedMotion::factorize(System& system, const State& state, const Conditions& conditions) {
  fill(system, state, conditions);
  return factorize_filled(system, state, conditions);
}

int ConstrainedMotion::factorize_with_all_masses(System& system, const State& state, const Conditions& conditions) {
  fill_for_constraints(system, state, conditions);
  return factorize_filled(system, state, conditions);
}

int ConstrainedMotion::factorize_around_matrix(System& system, const State& state, const Conditions& conditions,
                                               double step) {
  part_.resize(matrix_.size());
  if (system.sizes().ae > 0) {
    const State still = without_multipliers(state);
    add_gradients(system, still, conditions, *pattern_, matrix_, part_);
    if (step > 0) add_changes_of_gradients(system, still, conditions, step, *pattern_, matrix_, part_);
  }
  return factorize_filled(system, state, conditions);
}

void ConstrainedMotion::examine_anew() {
  constraints_.forget();
  driven_.clear();
  of_velocities_.clear();
}

void ConstrainedMotion::solve_as_regular() {
  constraints_.deactivate();
  factors_ = make_linear_solver(*pattern_, type_, options_);
}

int ConstrainedMotion::factorize_filled(System& system, const State& state, const Conditions& conditions) {
  if (!constraints_.is_prepared()) [[unlikely]]
    begin_step(system, state, conditions);
  const auto regularize = [&] {
    constraints_.choose(constraints_.largest(gaps_of_positions(system, state, conditions)));
    constraints_.regularize(*pattern_, matrix_, 1, 1, false);
  };
  if (constraints_.active()) regularize();
  const int singular = factors_->factorize(matrix_);
  if (singular == LinearSolver::success || !constraints_.activate()) return singular;
  factors_ = make_linear_solver(*pattern_, type_, constraints_.options(options_));
  regularize();
  return factors_->factorize(matrix_);
}

void ConstrainedMotion::begin_step(System& system, const State& start, const Conditions& conditions) {
  if (!constraints_.is_prepared()) [[unlikely]] {
    constraints_.prepare(system, start, conditions, settings_, treats_redundancy_,
                         ConstraintSolver::Matrix::accelerations);
    if (constraints_.active()) factors_ = make_linear_solver(*pattern_, type_, constraints_.options(options_));
  }
  if (constraints_.active()) constraints_.remember(constraints_.largest(gaps_of_positions(system, start, conditions)));
}

// The metric of the masses, with substitutes for coordinates without mass.
void ConstrainedMotion::fill_for_constraints(System& system, const State& state, const Conditions& conditions) {
  fill(system, state, conditions);
  const auto mass = [&](int j) -> double& { return matrix_[static_cast<std::size_t>(pattern_->slot(j, j))]; };
  std::vector<double> masses;
  for (int j = 0; j < ode2_; ++j) masses.push_back(mass(j));
  fill_in_masses(system, masses);
  for (int j = 0; j < ode2_; ++j) mass(j) = masses[static_cast<std::size_t>(j)];
}

void ConstrainedMotion::solve(std::span<double> x) {
  if (constraints_.active())
    constraints_.solve(*factors_, x);
  else
    factors_->solve(x);
}

void ConstrainedMotion::make_smallest(std::span<double> lambda) {
  if (constraints_.active()) constraints_.make_smallest(*factors_, lambda);
}

std::vector<double> ConstrainedMotion::gap_acceleration(System& system, const State& state,
                                                        const Conditions& conditions) {
  const std::size_t n = state.lambda.size();
  std::vector<double> before(n), after(n), step(state.q.size());
  double speed = 0;
  for (const double v : state.v) speed += v * v;
  speed = std::sqrt(speed);
  if (n == 0 || speed <= 1e-10) return before;
  double size = 1;
  for (const double q : state.q) size = std::max(size, std::abs(q));
  const double eps = 1e-5 * size / speed;
  State moved = state;
  const auto evaluate = [&](double factor, std::vector<double>& rates) {
    for (std::size_t i = 0; i < step.size(); ++i) {
      step[i] = factor * state.v[i];
      moved.q[i] = state.q[i] + step[i];
    }
    if (system.has_lie_nodes()) system.compose(state.q, step, moved.q);
    system.gaps(moved, at_level(conditions, true), rates);
  };
  evaluate(-eps, before);
  evaluate(eps, after);
  for (std::size_t i = 0; i < n; ++i) after[i] = (after[i] - before[i]) / (2 * eps);
  return after;
}

std::vector<double> ConstrainedMotion::gap_accelerations_of_velocities(System& system, const State& still,
                                                                       const Conditions& conditions) {
  std::vector<double> gap = gap_acceleration(system, still, conditions);
  find_driven(system, still, conditions);
  if (is_driven_) add_driving(system, still, conditions, gap);
  return gap;
}

void ConstrainedMotion::find_driven(System& system, const State& state, const Conditions& conditions) {
  if (driven_.size() == state.lambda.size()) return;
  driven_ = driven_equations(system, state, conditions, end_time_);
  is_driven_ = std::ranges::any_of(driven_, [](char d) { return d != 0; });
}

namespace {

// Adds the effect of accelerations to second derivatives of gaps along constant velocities: rates are linear in velocities.
void add_accelerations(System& system, const State& state, const Conditions& conditions, std::vector<double>& gap) {
  State moved = without_multipliers(state);
  std::vector<double> rates(gap.size());
  system.gaps(moved, at_level(conditions, true), rates);
  for (std::size_t k = 0; k < gap.size(); ++k) gap[k] -= rates[k];
  for (std::size_t i = 0; i < moved.v.size(); ++i) moved.v[i] += state.a[i];
  moved.lambda = state.lambda;
  system.gaps(moved, at_level(conditions, true), rates);
  for (std::size_t k = 0; k < gap.size(); ++k) gap[k] += rates[k];
}

}  // namespace

std::vector<double> ConstrainedMotion::gap_accelerations(System& system, const State& state,
                                                         const Conditions& conditions) {
  std::vector<double> gap = gap_accelerations_of_velocities(system, without_multipliers(state), conditions);
  add_accelerations(system, state, conditions, gap);
  return gap;
}

std::vector<double> ConstrainedMotion::gap_accelerations_without_driving(System& system, const State& state,
                                                                         const Conditions& conditions) {
  std::vector<double> gap = gap_acceleration(system, without_multipliers(state), conditions);
  add_accelerations(system, state, conditions, gap);
  return gap;
}

void ConstrainedMotion::accelerations(System& system, const State& state, const Conditions& conditions,
                                      std::span<double> a, std::span<double> lambda) {
  const State still = without_multipliers(state);
  const std::vector<double> gap = gap_accelerations_of_velocities(system, still, conditions);
  std::vector<double> now(gap.size());
  if (!std::ranges::all_of(system.static_signs(), [](double sign) { return sign < 0; }))
    system.gaps(still, at_level(conditions, false), now);
  std::ranges::fill(x_, 0.0);
  std::ranges::copy(a, x_.begin());
  for (std::size_t k = 0; k < gap.size(); ++k)
    x_[static_cast<std::size_t>(first_ae_) + k] = system.constrains_motion(static_cast<int>(k)) ? -gap[k] : -now[k];
  solve(x_);
  std::copy_n(x_.begin(), a.size(), a.begin());
  std::copy(x_.begin() + first_ae_, x_.end(), lambda.begin());
  make_smallest(lambda);
}

// The mean of both sides has an error of second order in the distance, the extrapolation of two distances one of fourth order.
bool ConstrainedMotion::follow_motion(System& system, const State& start, const Conditions& conditions,
                                      std::vector<double>& a, std::vector<double>& lambda, const Find& find) {
  constexpr double distance = 1e-3;            // relative to the size of the model
  constexpr double same = 1e-4, agree = 0.1;  // relative differences of accelerations
  const std::vector<double>& direction = largest(start.v) > at_rest ? start.v : a;
  if (!constraints_.active()) return true;
  const double size = relative_size(system, direction);
  if (!(size > at_rest)) return true;
  const auto move_by = [&](double part, State& moved) {
    std::vector<double> step = direction;
    for (double& x : step) x *= part / size;
    move_positions(system, step, moved.q);
    return factorize(system, moved, conditions) == LinearSolver::success && project(system, moved, conditions);
  };
  if (State beside = start;
      move_by(distance, beside) && constraints_.compare_rank(system, beside, conditions, settings_))
    return factorize(system, start, conditions) == LinearSolver::success;
  std::vector<double> spread(a.size());
  const auto mean = [&](double part) {
    std::pair<std::vector<double>, std::vector<double>> sum{std::vector<double>(a.size()),
                                                            std::vector<double>(lambda.size())};
    for (const double side : {-1.0, 1.0}) {
      State moved = start;
      if (!move_by(side * part, moved) || factorize(system, moved, conditions) != LinearSolver::success)
        return std::pair<std::vector<double>, std::vector<double>>{a, lambda};
      std::vector<double> of_side(a.size()), forces(lambda.size());
      find(moved, of_side, forces);
      for (std::size_t i = 0; i < a.size(); ++i) {
        sum.first[i] += 0.5 * of_side[i];
        spread[i] += side * of_side[i];
      }
      for (std::size_t k = 0; k < lambda.size(); ++k) sum.second[k] += 0.5 * forces[k];
    }
    return sum;
  };
  const auto difference = [&](const std::vector<double>& other) {
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(other[i] - a[i]));
    return most;
  };
  const auto near = mean(distance);
  if (!(difference(near.first) > same * std::max(largest(a), largest(near.first))))
    return factorize(system, start, conditions) == LinearSolver::success;
  const bool agrees = largest(spread) <= agree * largest(near.first);
  const auto far = mean(2 * distance);
  for (std::size_t i = 0; i < a.size(); ++i) a[i] = (4 * near.first[i] - far.first[i]) / 3;
  for (std::size_t k = 0; k < lambda.size(); ++k) lambda[k] = (4 * near.second[k] - far.second[k]) / 3;
  return factorize(system, start, conditions) == LinearSolver::success && agrees;
}

void ConstrainedMotion::make_smallest(const ConstraintSolver& metric, System& system, const State& state,
                                      const Conditions& conditions, std::span<double> lambda) {
  fill_for_constraints(system, state, conditions);
  replace_gradients_by_forces(system.sizes(), *pattern_, matrix_);
  if (!constraints_.is_prepared()) factors_ = make_linear_solver(*pattern_, type_, metric.options(options_));
  constraints_ = metric;
  constraints_.hold_dependent();
  constraints_.pattern_revised();
  constraints_.choose(0);
  constraints_.regularize(*pattern_, matrix_, 1, 1, false);
  if (factors_->factorize(matrix_) == LinearSolver::success) constraints_.make_smallest(*factors_, lambda);
}

// Compares user functions at a few times.
std::vector<char> driven_equations(System& system, const State& state, const Conditions& conditions, double end_time) {
  State moved = without_multipliers(state);
  std::vector<char> driven(state.lambda.size(), 0);
  std::vector<double> now(driven.size()), later(driven.size());
  system.gaps(moved, at_level(conditions, false), now);
  for (const double after : {1e-3, 0.1, 1.0, 10.0}) {
    moved.time = std::min(state.time + after, end_time);
    system.gaps(moved, at_level(conditions, false), later);
    for (std::size_t k = 0; k < driven.size(); ++k) driven[k] |= later[k] != now[k];
  }
  return driven;
}

void ConstrainedMotion::find_constraints_of_velocities(System& system, const State& still,
                                                       const Conditions& conditions) {
  if (!of_velocities_.empty()) return;
  of_velocities_.assign(still.lambda.size(), 0);
  part_.resize(matrix_.size());
  system.tangent(still, at_level(conditions, false), along_velocities, *pattern_, part_);
  for_each_entry(*pattern_, [&](int row, int column, std::size_t slot) {
    if (row >= first_ae_ && column < ode2_ && part_[slot] != 0) of_velocities_[row - first_ae_] = 1;
  });
}

// Adds the contribution of prescribed functions of time along the motion, by first differences of rates and second
// differences of gaps. The difference to the gaps at a fixed time is taken because Euler parameters that move along a line
// become longer, which changes gaps but not their rates.
void ConstrainedMotion::add_driving(System& system, const State& still, const Conditions& conditions,
                                    std::vector<double>& gap) {
  find_constraints_of_velocities(system, still, conditions);
  constexpr double tau = 1e-4;
  std::vector<double> before(gap.size()), after(gap.size());
  const auto evaluate = [&](double by, std::vector<double>& in_time) {
    State moved = still;
    std::vector<double> step = still.v;
    for (double& x : step) x *= by;
    move_positions(system, step, moved.q);
    std::vector<double> now(gap.size());
    system.gaps(moved, at_level(conditions, false), now);
    moved.time += by;
    system.gaps(moved, at_level(conditions, false), in_time);
    for (std::size_t k = 0; k < gap.size(); ++k) in_time[k] -= now[k];
  };
  evaluate(-tau, before);
  evaluate(tau, after);
  for (std::size_t k = 0; k < gap.size(); ++k)
    if (driven_[k])
      gap[k] += of_velocities_[k] ? (after[k] - before[k]) / (2 * tau) : (after[k] + before[k]) / (tau * tau);
}

std::span<const double> ConstrainedMotion::move(std::span<const double> gaps) {
  std::ranges::fill(x_, 0.0);
  for (std::size_t k = 0; k < gaps.size(); ++k) x_[static_cast<std::size_t>(first_ae_) + k] = -gaps[k];
  solve(x_);
  return std::span(x_).first(static_cast<std::size_t>(ode2_));
}

bool ConstrainedMotion::project(System& system, State& state, const Conditions& conditions) {
  const auto n = static_cast<std::size_t>(system.sizes().ae);
  State still = without_multipliers(state);
  find_constraints_of_velocities(system, still, conditions);
  find_driven(system, still, conditions);
  std::vector<double> gaps(n);
  // Repeats corrections while gaps become smaller, and returns the remaining gap in units of `size`. A correction of the
  // length of Euler parameters opens joints by as much, which the next correction closes: every second gap is compared.
  const auto close = [&](bool of_rates, double size, auto&& apply) {
    double left = 0, before = 0;
    for (int i = 0; i < most_projections; ++i) {
      if (of_rates && is_driven_)
        gaps = constraint_rates(system, still, at_level(conditions, false)).rates;
      else
        system.gaps(still, at_level(conditions, of_rates), gaps);
      for (std::size_t k = 0; k < n; ++k)
        if (!system.constrains_motion(static_cast<int>(k)) || (!of_rates && of_velocities_[k])) gaps[k] = 0;
      const double open = constraints_.active() && !of_rates ? constraints_.largest_of_all(gaps) : largest(gaps) / size;
      const bool settled = i > 1 && !(open < 0.5 * before);
      before = std::exchange(left, open);
      if (settled || left <= closed) break;
      apply(move(gaps));
    }
    return left;
  };
  const double of_positions =
      close(false, system.extent(), [&](std::span<const double> step) { move_positions(system, step, still.q); });
  const double of_velocities = close(true, std::max(1.0, largest(still.v)), [&](std::span<const double> step) {
    for (std::size_t i = 0; i < still.v.size(); ++i) still.v[i] += step[i];
  });
  if (constraints_.active()) largest_misfit_ = std::max(largest_misfit_, of_positions);
  state.q = still.q;  // in place: Python and other threads have views of these numbers
  state.v = still.v;
  const double limit = constraints_.active() ? std::max(accepted, settings_.largestMisfit) : accepted;
  return std::max(of_positions, of_velocities) <= limit;
}

std::vector<double> ConstrainedMotion::misfit(System& system, const State& state, const Conditions& conditions) {
  if (!constraints_.active() || !(largest_misfit_ > ConstraintSolver::silent_misfit)) return {};
  std::vector<double> open = constraints_.misfit(*factors_, gaps_of_positions(system, state, conditions));
  if (!(constraints_.largest(open) > ConstraintSolver::silent_misfit)) open.clear();
  return open;
}

}  // namespace dalembert
