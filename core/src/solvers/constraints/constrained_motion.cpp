#include "dalembert/solvers/constrained_motion.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "constraints/constraint_states.hpp"
#include "dalembert/solvers/numerical_tangent.hpp"
#include "dalembert/solvers/open_constraints.hpp"

namespace dalembert {

namespace {

// Gaps of this size, relative to that of the model, are round-off; larger ones are accepted where nothing makes them smaller: redundant
// constraints may contradict each other.
constexpr double closed = 1e-13, accepted = 1e-9;
constexpr int most_projections = 10;
// The rows of the constraints.
//
// Gradients are those of the rates by the velocities: Euler parameters turn a frame without their own lengthening, which
// the gradient of a gap contains. Constraints of velocities are their own rates, so they are differentiated once, not twice.
void add_gradients(System& system, const State& state, Conditions conditions, const Pattern& pattern, std::span<double> matrix,
                   std::span<double> part) {
  const int end_of_ode2 = system.sizes().ode2, first_ae = system.sizes().first_ae();
  conditions.rate_level = true;
  system.tangent(state, conditions, along_velocities, pattern, part);
  for (int j = 0; j < end_of_ode2; ++j) {
    const ColumnRange column = column_range(pattern, j, first_ae);
    std::copy(part.data() + column.middle, part.data() + column.end, matrix.data() + column.middle);
  }
}

// Accelerations that change velocities by h, and positions by h^2, change those of gaps by G + 2 h dG/dt + h^2 d^2G/dt^2, which is found by
// differences along the motion. Beside a singular position, where G hardly acts in some directions, its changes are more than itself.
void add_changes_of_gradients(System& system, const State& still, Conditions conditions, double h, const Pattern& pattern, std::span<double> matrix,
                              std::span<double> part) {
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
void add_forces_of_multipliers(System& system, const State& state, const Conditions& conditions, const Pattern& pattern, std::span<double> matrix,
                               std::span<double> part) {
  const int end_of_ode2 = system.sizes().ode2, first_ae = system.sizes().first_ae();
  system.tangent(state, conditions, along_positions, pattern, part);
  for (int j = end_of_ode2; j < pattern.size(); ++j) {
    const ColumnRange column = column_range(pattern, j, first_ae);
    const std::size_t begin = j < first_ae ? column.middle : column.begin;
    std::copy(part.data() + begin, part.data() + column.end, matrix.data() + begin);
  }
}

// Rows of constraints as if forces acted along the gradients, as most do: which multipliers exert none is seen by these forces alone.
void replace_gradients_by_forces(const Sizes& s, const Pattern& pattern, std::span<double> matrix) {
  for_each_entry(pattern, [&](int row, int column, std::size_t slot) {
    if (column >= s.first_ae() && row < s.ode2) matrix[static_cast<std::size_t>(pattern.slot(column, row))] = matrix[slot];
  });
}

}  // namespace

void ConstrainedMotion::prepare(System& system, LinearSolverType type, const LinearSolverOptions& options,
                                const RedundantConstraintsSettings& settings, double end_time) {
  *this = ConstrainedMotion();
  type_ = type;
  options_ = options;
  settings_ = settings;
  end_time_ = end_time;
  treats_redundancy_ = treats_redundancy(system.sizes(), settings, options.ignore_singular);
  pattern_ = &system.pattern(is_dense(type));
  ode2_ = system.sizes().ode2;
  first_ae_ = system.sizes().first_ae();
  matrix_.resize(static_cast<std::size_t>(pattern_->values()));
  x_.resize(static_cast<std::size_t>(system.sizes().total()));
  factors_ = make_linear_solver(*pattern_, type, options);
}

void ConstrainedMotion::free_memory() {
  factors_.reset();
  for (std::vector<double>* numbers : {&matrix_, &part_, &x_, &rest_}) *numbers = {};
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
  if (knowledge_ == Knowledge::beside && state.time == examined_at_) [[unlikely]] {  // the step is repeated
    redundant_ = RedundantConstraints();
    factors_ = make_linear_solver(*pattern_, type_, options_);
    return examine_filled(system, state, conditions);
  }
  return factorize_filled(system, state, conditions);
}

int ConstrainedMotion::factorize_around_matrix(System& system, const State& state, const Conditions& conditions, double step) {
  part_.resize(matrix_.size());
  if (system.sizes().ae > 0) {
    const State still = without_multipliers(state);
    add_gradients(system, still, conditions, *pattern_, matrix_, part_);
    if (step > 0) add_changes_of_gradients(system, still, conditions, step, *pattern_, matrix_, part_);
    if (redundant_.in_use()) weigh_again(system);
  }
  return factorize_filled(system, state, conditions);
}

int ConstrainedMotion::factorize_filled(System& system, const State& state, const Conditions& conditions) {
  if (!is_examined()) return examine_filled(system, state, conditions);
  if (redundant_.in_use()) redundant_.regularize(*pattern_, matrix_, 1);
  const int singular = factors_->factorize(matrix_);
  return singular == LinearSolver::success || !treats_redundancy_ || redundant_.in_use() ? singular : pass_singular_matrix(system, singular);
}

bool ConstrainedMotion::to_be_examined(const State& start_of_step) const {
  if (!treats_redundancy_) return false;
  if (examines_anew_ || knowledge_ == Knowledge::none || knowledge_ == Knowledge::passing) return true;
  return redundant_.in_use() && knowledge_ != Knowledge::confirmed && start_of_step.time != examined_at_;
}

// In the metric of the masses, with others where there are none.
void ConstrainedMotion::fill_for_constraints(System& system, const State& state, const Conditions& conditions) {
  fill(system, state, conditions);
  const auto mass = [&](int j) -> double& { return matrix_[static_cast<std::size_t>(pattern_->slot(j, j))]; };
  std::vector<double> masses;
  for (int j = 0; j < ode2_; ++j) masses.push_back(mass(j));
  fill_in_masses(system, masses);
  for (int j = 0; j < ode2_; ++j) mass(j) = masses[static_cast<std::size_t>(j)];
}

bool ConstrainedMotion::examine(System& system, const State& start_of_step, const Conditions& conditions) {
  const auto fill_with_masses = [&] { fill_for_constraints(system, start_of_step, conditions); };
  const bool treated = redundant_.in_use(), anew = std::exchange(examines_anew_, false) || redundant_.allows_for_gaps();  // which have been closed
  const bool again = treated && !anew && knowledge_ != Knowledge::passing;
  fill_with_masses();
  if (again) {
    knowledge_ = Knowledge::confirmed;
    weigh_again(system);
    redundant_.regularize(*pattern_, matrix_, 1);
    const auto factors = make_linear_solver(*pattern_, type_, redundant_.options(options_));
    if (factors->factorize(matrix_) == LinearSolver::success && redundant_.confirm(*pattern_, matrix_, *factors)) return false;
    fill_with_masses();
  }
  redundant_ = RedundantConstraints();
  auto factors = std::exchange(factors_, make_linear_solver(*pattern_, type_, options_));
  examine_filled(system, start_of_step, conditions);
  if (again && knowledge_ == Knowledge::first) knowledge_ = Knowledge::confirmed;
  if (treated || redundant_.in_use()) factors = make_linear_solver(*pattern_, type_, redundant_.options(options_));
  factors_ = std::move(factors);
  return treated || redundant_.in_use();
}

// As far as numbers and entries of equations tell. As many as coordinates leave no motion, unless some follow from others.
bool ConstrainedMotion::follow_from_others(System& system, const State& state, const Conditions& conditions) {
  const int beyond = RedundantConstraints::equations_beyond_coordinates(system, *pattern_, matrix_);
  if (beyond < 0 || (beyond == 0 && RedundantConstraints::evidently_none(system, *pattern_, matrix_))) return false;
  if (!measure_redundancy(system, state, conditions)) return false;
  return (redundant_.find_locally(*pattern_, matrix_) && redundant_.count() > 0) || beyond > 0;
}

bool ConstrainedMotion::measure_redundancy(System& system, const State& state, const Conditions& conditions) {
  if (!redundant_.measure(system, *pattern_, matrix_, settings_.momentLength, 1)) return false;
  gaps_ = gaps_of_positions(system, state, conditions);
  redundant_.allow_for(gaps_);
  return true;
}

int ConstrainedMotion::examine_filled(System& system, const State& state, const Conditions& conditions) {
  knowledge_ = Knowledge::first;
  examined_at_ = state.time;
  system.reactions_are_known({});
  int singular = 0;  // factors that must fail are not made
  if (treats_redundancy_ && follow_from_others(system, state, conditions) && treat_redundancy(system, state, conditions, singular)) return singular;
  singular = factors_->factorize(matrix_);
  if (treats_redundancy_) look_for_redundancy(system, state, conditions, singular);
  return singular;
}

// Stages and iterations lead to matrices that are singular for a moment, or because they are far from any state of the system.
int ConstrainedMotion::pass_singular_matrix(System& system, int singular) {
  if (!redundant_.measure(system, *pattern_, matrix_, settings_.momentLength, 1)) return singular;
  redundant_.use(RedundantConstraints::passing_eps);
  redundant_.regularize(*pattern_, matrix_, 1);
  auto factors = make_linear_solver(*pattern_, type_, redundant_.options(options_));
  if (factors->factorize(matrix_) != LinearSolver::success) {
    redundant_.use(0);
    return singular;
  }
  knowledge_ = Knowledge::passing;
  factors_ = std::move(factors);
  return LinearSolver::success;
}

// Combinations are those of all matrices with these constraints, weights are not: steps of other sizes have others.
void ConstrainedMotion::weigh_again(System& system) {
  const RedundantConstraints found = std::exchange(redundant_, {});
  if (redundant_.measure(system, *pattern_, matrix_, settings_.momentLength, 1) && redundant_.take_over(found)) redundant_.use(found.eps());
  else knowledge_ = Knowledge::none;
}

// A matrix that is singular without redundancy belongs to a singular position, which is passed all the same. Whether there are new factors.
bool ConstrainedMotion::look_for_redundancy(System& system, const State& state, const Conditions& conditions, int& singular) {
  const bool regular = singular == LinearSolver::success;
  if (regular && RedundantConstraints::evidently_none(system, *pattern_, matrix_)) return false;
  if (!measure_redundancy(system, state, conditions) || (regular && !redundant_.suspected(*factors_))) return false;
  if (redundant_.find_locally(*pattern_, matrix_) && regular && redundant_.count() == 0) return false;
  return treat_redundancy(system, state, conditions, singular);
}

// Measured, and found by entries as far as these tell.
bool ConstrainedMotion::treat_redundancy(System& system, const State& state, const Conditions& conditions, int& singular) {
  const bool regular = singular == LinearSolver::success;
  constexpr double eps = RedundantConstraints::regular_eps;
  auto factors = make_linear_solver(*pattern_, type_, redundant_.options(redundant_.options_to_find(options_)));
  std::unique_ptr<LinearSolver> closer;
  const bool local = redundant_.is_local(), at_once = redundant_.find_at_once(*pattern_, matrix_, eps, *factors);
  if (!at_once) {
    closer = make_linear_solver(*pattern_, type_, redundant_.options_to_find(options_));
    if (!redundant_.find(*pattern_, matrix_, redundant_.counting(), *closer)) return false;
  }
  if (regular && redundant_.count() == 0) return false;
  system.reactions_are_known(redundant_.equations());
  if (redundant_.count() == 0) return pass(singular);
  redundant_.use(redundant_.eps_for_gaps(gaps_, true, [&](double nearly) { redundant_.find(*pattern_, matrix_, nearly, closer ? *closer : *factors); }));
  const std::vector<double> plain = matrix_;
  redundant_.regularize(*pattern_, matrix_, 1);
  const bool serve = at_once || (local && redundant_.is_local());  // pivots, of the same combinations
  factors_ = serve ? std::move(factors) : make_linear_solver(*pattern_, type_, redundant_.options(options_));
  singular = at_once && redundant_.eps() == eps ? LinearSolver::success : factors_->factorize(matrix_);
  if (singular != LinearSolver::success || !looks_beside_ || !fewer_follow_beside(system, state, conditions)) return true;
  matrix_ = plain;
  redundant_.measure(system, *pattern_, matrix_, settings_.momentLength, 1);  // none of the combinations lasts
  return pass(singular);
}

bool ConstrainedMotion::pass(int& singular) {
  knowledge_ = Knowledge::passing;
  redundant_.use(RedundantConstraints::passing_eps);
  redundant_.regularize(*pattern_, matrix_, 1);
  factors_ = make_linear_solver(*pattern_, type_, redundant_.options(options_));
  singular = factors_->factorize(matrix_);
  return true;
}

// Accelerations do not depend on which of the redundant equations hold a body; multipliers become the smallest ones. What eps leaves
// open is closed by a second solution.
void ConstrainedMotion::solve(std::span<double> x) {
  begin_iterations();
  solve_increment(x);
}

void ConstrainedMotion::solve_increment(std::span<double> x) {
  if (!redundant_.in_use()) return factors_->solve(x);
  const auto multipliers = x.subspan(static_cast<std::size_t>(first_ae_));
  kept_.resize(multipliers.size(), 0.0);
  for (std::size_t k = 0; k < kept_.size(); ++k) multipliers[k] -= kept_[k];
  factors_->solve(x);
  // Factors may be those of a state in which joints are further apart than at ends of steps.
  close_what_eps_leaves(1 + redundant_.take_off_idle_solution(*factors_, x, kept_), x);
}

// As much as its multipliers tell, and as much again for each solution by which the idle part has been taken off.
void ConstrainedMotion::close_what_eps_leaves(int times, std::span<double> x) {
  const auto first = static_cast<std::size_t>(first_ae_);
  rest_.assign(x.size(), 0.0);
  for (const int k : redundant_.rows()) rest_[first + k] = -times * redundant_.left_open(k, x[first + k]);
  factors_->solve(rest_);
  redundant_.take_off_idle_solution(*factors_, rest_);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += rest_[i];
}

std::vector<double> ConstrainedMotion::gap_acceleration(System& system, const State& state, const Conditions& conditions) {
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

std::vector<double> ConstrainedMotion::gap_accelerations_of_velocities(System& system, const State& still, const Conditions& conditions) {
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

// To second derivatives of gaps along constant velocities, what accelerations change: rates are linear in the velocities.
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

std::vector<double> ConstrainedMotion::gap_accelerations(System& system, const State& state, const Conditions& conditions) {
  std::vector<double> gap = gap_accelerations_of_velocities(system, without_multipliers(state), conditions);
  add_accelerations(system, state, conditions, gap);
  return gap;
}

std::vector<double> ConstrainedMotion::gap_accelerations_without_driving(System& system, const State& state, const Conditions& conditions) {
  std::vector<double> gap = gap_acceleration(system, without_multipliers(state), conditions);
  add_accelerations(system, state, conditions, gap);
  return gap;
}

bool ConstrainedMotion::accelerations(System& system, const State& state, const Conditions& conditions, std::span<double> a,
                                      std::span<double> lambda) {
  const State still = without_multipliers(state);
  const std::vector<double> gap = gap_accelerations_of_velocities(system, still, conditions);
  std::vector<double> now(gap.size());
  if (!std::ranges::all_of(system.static_signs(), [](double sign) { return sign < 0; })) system.gaps(still, at_level(conditions, false), now);
  std::ranges::fill(x_, 0.0);
  std::ranges::copy(a, x_.begin());
  for (std::size_t k = 0; k < gap.size(); ++k)
    x_[static_cast<std::size_t>(first_ae_) + k] = system.constrains_motion(static_cast<int>(k)) ? -gap[k] : -now[k];
  solve(x_);
  std::copy_n(x_.begin(), a.size(), a.begin());
  std::copy(x_.begin() + first_ae_, x_.end(), lambda.begin());
  const bool at_start = redundant_.in_use() && knowledge_ != Knowledge::confirmed && state.time == examined_at_;
  return !at_start || leave_singular_position(system, state, conditions, a, lambda);
}

int ConstrainedMotion::factorize(const RedundantConstraints& known, System& system, const State& state, const Conditions& conditions) {
  fill_for_constraints(system, state, conditions);
  const int before = redundant_.count();
  redundant_ = known;
  if (redundant_.in_use()) weigh_again(system);
  if (redundant_.in_use()) {
    if (redundant_.count() != before) factors_ = make_linear_solver(*pattern_, type_, redundant_.options(options_));
    redundant_.regularize(*pattern_, matrix_, 1);
  }
  return factors_->factorize(matrix_);
}

// Combinations only tell the solver in which order to take the equations.
void ConstrainedMotion::take_off_idle_part(const RedundantConstraints& known, System& system, const State& state, const Conditions& conditions,
                                           std::span<double> lambda) {
  fill_for_constraints(system, state, conditions);
  replace_gradients_by_forces(system.sizes(), *pattern_, matrix_);
  if (!redundant_.measure(system, *pattern_, matrix_, settings_.momentLength, 1) || !redundant_.serve_as(known)) return;
  redundant_.regularize(*pattern_, matrix_, 1);
  if (std::exchange(followed_, known.count()) != known.count()) factors_ = make_linear_solver(*pattern_, type_, known.options(options_));
  if (factors_->factorize(matrix_) == LinearSolver::success) redundant_.take_off_idle_part(*factors_, lambda);
}

// User functions are asked at a few times: one that is constant there does not drive.
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

void ConstrainedMotion::find_constraints_of_velocities(System& system, const State& still, const Conditions& conditions) {
  if (!of_velocities_.empty()) return;
  of_velocities_.assign(still.lambda.size(), 0);
  part_.resize(matrix_.size());
  system.tangent(still, at_level(conditions, false), along_velocities, *pattern_, part_);
  for_each_entry(*pattern_, [&](int row, int column, std::size_t slot) {
    if (row >= first_ae_ && column < ode2_ && part_[slot] != 0) of_velocities_[row - first_ae_] = 1;
  });
}

// What time adds along the motion, by differences; first ones of rates, second ones of gaps. Without it, Euler parameters that move along a line get
// longer, which gaps show and their rates do not.
void ConstrainedMotion::add_driving(System& system, const State& still, const Conditions& conditions, std::vector<double>& gap) {
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
    if (driven_[k]) gap[k] += of_velocities_[k] ? (after[k] - before[k]) / (2 * tau) : (after[k] + before[k]) / (tau * tau);
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
  // As long as gaps become smaller; what is left of them, in units of `size`. Where Euler parameters get their length back, gaps of joints open
  // by as much, and the next one closes them: two steps are compared.
  const auto close = [&](bool of_rates, double size, auto&& apply) {
    double left = 0, before = 0;
    for (int i = 0; i < most_projections; ++i) {
      if (of_rates && is_driven_) gaps = constraint_rates(system, still, at_level(conditions, false)).rates;
      else system.gaps(still, at_level(conditions, of_rates), gaps);
      for (std::size_t k = 0; k < n; ++k)
        if (!system.constrains_motion(static_cast<int>(k)) || (!of_rates && of_velocities_[k])) gaps[k] = 0;
      const double open = redundant_.in_use() && !of_rates ? redundant_.largest_of_all(gaps) : largest(gaps) / size;
      const bool settled = i > 1 && !(open < 0.5 * before);
      before = std::exchange(left, open);
      if (settled || left <= closed) break;
      apply(move(gaps));
    }
    return left;
  };
  const double of_positions = close(false, system.extent(), [&](std::span<const double> step) { move_positions(system, step, still.q); });
  const double of_velocities = close(true, std::max(1.0, largest(still.v)), [&](std::span<const double> step) {
    for (std::size_t i = 0; i < still.v.size(); ++i) still.v[i] += step[i];
  });
  const bool lasts = redundant_.in_use() && knowledge_ != Knowledge::passing;
  if (lasts) largest_misfit_ = std::max(largest_misfit_, of_positions);
  state.q = still.q;  // in place: Python and other threads have views of these numbers
  state.v = still.v;
  const double limit = lasts ? std::max(accepted, settings_.largestMisfit) : accepted;
  return std::max(of_positions, of_velocities) <= limit;
}

std::vector<double> ConstrainedMotion::misfit(System& system, const State& state, const Conditions& conditions) const {
  if (!redundant_.in_use() || redundant_.count() == 0 || !(largest_misfit_ > RedundantConstraints::silent_misfit)) return {};
  std::vector<double> open = redundant_.misfit(gaps_of_positions(system, state, conditions));
  if (!(redundant_.largest(open) > RedundantConstraints::silent_misfit)) open.clear();
  return open;
}

}  // namespace dalembert
