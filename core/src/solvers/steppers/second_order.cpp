#include "dalembert/solvers/second_order.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "dalembert/model/errors.hpp"
#include "dalembert/output/numbers.hpp"
#include "dalembert/solvers/constrained_motion.hpp"
#include "dalembert/solvers/numerical_tangent.hpp"
#include "dalembert/system/traced_equations.hpp"
#include "steppers/combination.hpp"
#include "steppers/rotation_increments.hpp"
#include "steppers/velocity_lead.hpp"
#include "constraints/singular_positions.hpp"

namespace dalembert {

namespace {

constexpr std::size_t own_restart_numbers = 4;

// Updates q, v and a in one loop, because most systems are small.
void subtract_motion(const System& system, std::size_t n, const double* __restrict x, double rate, double acceleration,
                     double* __restrict q, double* __restrict v, double* __restrict a) {
  each_number(system, n, [=](std::size_t i) {
    q[i] -= x[i];
    v[i] -= rate * x[i];
    a[i] -= acceleration * x[i];
  });
}

// Parameters of the scheme for the predictor.
struct Prediction {
  double h, beta, gamma, alpha_m, alpha_f;
};

// Predictor with a_{n+1} = 0. Without algorithmic accelerations (null), it is that of Newmark's method.
void predict_motion(const System& system, std::size_t n, const Prediction& scheme, double* __restrict increment,
                    double* __restrict algorithmic, double* __restrict q, double* __restrict v, double* __restrict a) {
  const double h = scheme.h, beta = scheme.beta, gamma = scheme.gamma, alpha_m = scheme.alpha_m,
               alpha_f = scheme.alpha_f;
  each_number(system, n, [=](std::size_t i) {
    double aa = algorithmic == nullptr ? a[i] : algorithmic[i];
    double dq = h * v[i] + h * h * (0.5 - beta) * aa;
    double dv = h * (1 - gamma) * aa;
    if (algorithmic != nullptr) {
      aa = (alpha_f * a[i] - alpha_m * aa) / (1 - alpha_m);
      algorithmic[i] = aa;
      dq += h * h * beta * aa;
      dv += h * gamma * aa;
    }
    increment[i] = dq;
    q[i] += dq;
    v[i] += dv;
    a[i] = 0;
  });
}

// Modified Newton's method uses a matrix in many steps, so it excludes present reactions and inertia forces.
[[gnu::noinline]] State without_momentary_forces(State state) {
  std::fill(state.lambda.begin(), state.lambda.end(), 0.0);
  std::fill(state.a.begin(), state.a.end(), 0.0);
  return state;
}

}  // namespace

SecondOrderSolver::SecondOrderSolver() = default;
SecondOrderSolver::~SecondOrderSolver() = default;

double SecondOrderSolver::row_scale() const { return newmark_beta * it.currentStepSize * it.currentStepSize; }
double SecondOrderSolver::beta_prime() const {
  const double h = it.currentStepSize;
  return (1 - alpha_m) / (h * h * newmark_beta * (1 - alpha_f));
}
double SecondOrderSolver::gamma_prime() const { return newmark_gamma / (it.currentStepSize * newmark_beta); }

void SecondOrderSolver::read_settings() {
  Solver::read_settings();
  options_ = settings().timeIntegration.generalizedAlpha;
  controls_step_size_ = settings().stepSizeControl.implicitSolvers;
}

void SecondOrderSolver::pre_initialize() {
  const auto& s = options_;
  if (s.useIndex2Constraints && !s.useNewmark) {
    throw ModelError(ErrorKind::value,
                     "timeIntegration.generalizedAlpha.useIndex2Constraints=True needs useNewmark=True");
  }
  spectral_radius = s.useNewmark ? 1.0 : s.spectralRadius;
  alpha_m = (2 * spectral_radius - 1) / (spectral_radius + 1);
  alpha_f = spectral_radius / (spectral_radius + 1);
  if (s.useNewmark) {
    newmark_beta = s.newmarkBeta;
    newmark_gamma = s.newmarkGamma;
  } else {
    newmark_gamma = 0.5 + alpha_f - alpha_m;
    newmark_beta = 0.25 * (newmark_gamma + 0.5) * (newmark_gamma + 0.5);
  }
  conditions_ = {.rate_level = s.useIndex2Constraints, .inertia = true};
}

void SecondOrderSolver::initialize_data() {
  NewtonSolver::initialize_data();
  const auto n = static_cast<std::size_t>(sizes_.ode2);
  algorithmic_.assign(n, 0.0);
  algorithmic_at_start_.assign(n, 0.0);
  increment_of_q_.assign(n, 0.0);
  lie_ = system().has_lie_nodes();
  simplified_lie_ = lie_ && options_.lieGroupSimplifiedKinematicRelations;
  lie_increment_.assign(lie_ ? n : 0, 0.0);
  previous_q_.assign(lie_ ? n : 0, 0.0);
  belong_to_ = belong_to_at_start_ = {};
  off_constraints_known_ = -1;
  lead_ = std::make_unique<VelocityLead>(*this);
  renews_ = false;
  renewed_after_ = -2;
}

void SecondOrderSolver::initial_conditions() {
  Solver::initial_conditions();
  State& now = current();
  if (continues()) {
    algorithmic_ = continued_values();
    belong_to_ = {continued_number(0), continued_number(1), continued_number(2) != 0};
    renewed_after_ = static_cast<StepCount>(continued_number(3));
    std::array<double, VelocityLead::restart_size> numbers;
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = continued_number(own_restart_numbers + i);
    lead_->resume(numbers);
    return;
  }
  std::fill(now.lambda.begin(), now.lambda.end(), 0.0);
  if (continued_.size() == now.a.size() && !continued_.empty()) {
    algorithmic_ = std::exchange(continued_, {});
    start_of_step() = now;
    return;
  }
  if (options_.computeInitialAccelerations) {
    const std::vector<double> lambda = now.lambda;
    if (!find_accelerations()) std::fill(now.a.begin(), now.a.end(), 0.0);
    if (!options_.storeInitialAlgebraicCoordinates) now.lambda = lambda;
  } else if (options_.resetAccelerations) {
    std::fill(now.a.begin(), now.a.end(), 0.0);
  }
  begin_with_accelerations();
  start_of_step() = now;
}

bool SecondOrderSolver::find_accelerations() {
  LinearSolverOptions options = linear_options();
  // Shares the symbolic analysis with Newton's first matrix; mass matrices alone are cheaper separately.
  if (full_newton_ && sizes_.ae > 0) options.unsettled_matrices = 1;
  ConstrainedMotion motion;
  motion.prepare(system(), linear_type(), options, settings().redundantConstraints, last_time());
  return find_accelerations(motion, motion.factorize(system(), current(), conditions_));
}

bool SecondOrderSolver::find_accelerations(ConstrainedMotion& motion, int singular) {
  State& now = current();
  // The trapezoidal rule of first-order coordinates needs their rates; zeros would make the whole solution first order.
  if (!now.y.empty()) system().rates(now, conditions_, now.y_t);
  if (singular != LinearSolver::success) {
    warn("initial accelerations are set to zero: mass matrix and constraints are singular at unknown " +
         std::to_string(singular) + " (" + system().describe_row(singular) + ")");
    return false;
  }
  prepare_constraints(motion.constraints());
  InitialAccelerations found = initial_accelerations(motion, system(), now, conditions_);
  if (motion.constraints().rank_holds_nearby() && !rank_known_) take_rank(motion.constraints().rank());
  if (!found.decided) singular_->warn_of_undecided_start();
  now.a = found.a;  // in place: other objects refer to the vector
  now.lambda = found.lambda;
  multipliers_renewed();
  return true;
}

// Called after an event. Previous algorithmic accelerations would reduce the order.
void SecondOrderSolver::renew_accelerations() {
  // Velocities given by users are not changed.
  if (may_start_steadily() && !it.automaticStepSize && it.currentStepIndex > 0) return start_steadily();
  if (options_.computeInitialAccelerations) find_accelerations();
  begin_with_accelerations();
}

void SecondOrderSolver::begin_with_accelerations() {
  algorithmic_ = current().a;
  belong_to_ = {.begins = it.automaticStepSize && may_start_steadily()};
  off_constraints_known_ = -1;
}

bool SecondOrderSolver::may_start_steadily() const {
  return options_.computeInitialAccelerations && sizes_.ae > 0 && !conditions_.rate_level;
}

// Projects velocities onto the constraints.
bool SecondOrderSolver::end_rates(ConstrainedMotion& motion) {
  State still = current();
  if (!motion.project(system(), still, conditions_)) return false;
  std::ranges::copy(still.v, current().v.begin());
  return true;
}

// Equal steps have velocities off the constraints of C h^2 times the rate of accelerations across them, where C h^3 is
// the local error of positions. Starting with this offset avoids errors of reactions of first order that oscillate:
// Arnold, Bruels, Cardona: Error analysis of generalized-alpha Lie group time integration methods for constrained
// mechanical systems, Numerische Mathematik 129 (2015).
void SecondOrderSolver::start_steadily() {
  ConstrainedMotion motion;
  prepare(motion);
  const int singular = motion.factorize(system(), current(), conditions_);
  const bool rests = singular == LinearSolver::success && end_rates(motion),
             found = find_accelerations(motion, singular);
  begin_with_accelerations();
  if (rests && found) lean(motion);
}

// Does the same if the size of the first step is known only at its start, and may change. Outputs have velocities
// without the offset.
[[gnu::noinline]] void SecondOrderSolver::start_steadily_in_step() {
  State& now = current();
  belong_to_ = {};
  now.time = start_of_step().time;
  ConstrainedMotion motion;
  prepare(motion);
  if (motion.factorize(system(), now, conditions_) == LinearSolver::success && end_rates(motion)) {
    now.a = initial_accelerations(motion, system(), now, conditions_).a;
    algorithmic_ = now.a;
    lean(motion);
    start_of_step().a = now.a;
    algorithmic_at_start_ = algorithmic_;
    belong_to_at_start_ = belong_to_;
    belong_to_at_start_.begins = true;  // a repetition with another size starts again
  }
  now.time = it.currentTime;
}

// Replaces accelerations and velocities of the motion by those of equal steps.
void SecondOrderSolver::lean(ConstrainedMotion& motion) {
  constexpr double moment = 1e-2;  // part of a step, for finite differences
  State& now = current();
  const double h = it.currentStepSize, tau = moment * h, shift = newmark() ? 0 : alpha_m - alpha_f;
  State moved = now;
  moved.time += tau;
  std::vector<double> step(now.q.size());
  for (std::size_t i = 0; i < step.size(); ++i) {
    step[i] = tau * (now.v[i] + 0.5 * tau * now.a[i]);
    moved.v[i] += tau * now.a[i];
    moved.q[i] += step[i];
  }
  if (lie_) system().compose(now.q, step, moved.q);
  if (motion.factorize(system(), moved, conditions_) != LinearSolver::success) return;
  const InitialAccelerations soon = initial_accelerations(motion, system(), moved, conditions_);
  State along = now;
  for (std::size_t i = 0; i < step.size(); ++i) {
    step[i] = (soon.a[i] - now.a[i]) / moment;  // within a step
    along.v[i] += step[i];
  }
  const std::vector<double> all = along.v;
  if (!motion.project(system(), along, conditions_)) return;
  for (std::size_t i = 0; i < step.size(); ++i) {
    algorithmic_[i] += shift * step[i];
    now.v[i] -= left_out() * h * (all[i] - along.v[i]);
  }
  belong_to_ = {h, h};
}

double SecondOrderSolver::left_out() const { return newmark_beta + 0.5 * (alpha_m - alpha_f) - 1.0 / 6; }

void SecondOrderSolver::post_initialize() {
  if (!verbose(2)) return;
  say(2, (newmark() ? "  Newmark: "
                    : "  generalized alpha: spectralRadius=" + number(spectral_radius) + ", alphaM=" + number(alpha_m) +
                          ", alphaF=" + number(alpha_f) + ", ") +
             std::string("beta=") + number(newmark_beta) + ", gamma=" + number(newmark_gamma) + "\n");
}

bool SecondOrderSolver::reduce_step_size() {
  it.currentTime = current().time;
  algorithmic_ = algorithmic_at_start_;
  belong_to_ = belong_to_at_start_;
  if (std::exchange(renews_, false)) {
    renew_accelerations();
    start_of_step().a = current().a;
    algorithmic_at_start_ = algorithmic_;
    belong_to_ = belong_to_at_start_ = {};
  }
  if (steps_.take_rejection_by_error()) return true;
  if (!Solver::reduce_step_size()) return false;
  belong_to_ = belong_to_at_start_ = {};  // steps fail where the motion is not smooth
  return true;
}

void SecondOrderSolver::increase_step_size() {
  if (it.automaticStepSize || it.currentStepSize == it.maxStepSize) return;
  steps_.recover();
  belong_to_ = {};
}

std::vector<double> SecondOrderSolver::restart_numbers() const {
  std::vector<double> numbers{belong_to_.accelerations, belong_to_.velocities, static_cast<double>(belong_to_.begins),
                              static_cast<double>(renewed_after_)};
  std::ranges::copy(lead_->restart_numbers(), std::back_inserter(numbers));
  return numbers;
}

void SecondOrderSolver::look_back() {
  std::ranges::copy(lead_->doubts(), std::back_inserter(doubts_));
  NewtonSolver::look_back();
}

void SecondOrderSolver::forget() {
  NewtonSolver::forget();
  lead_->forget();
}

void SecondOrderSolver::save_start_of_step() {
  Solver::save_start_of_step();
  copy_numbers(system(), algorithmic_.data(), algorithmic_.size(), algorithmic_at_start_.data());
  belong_to_at_start_ = belong_to_;
}

void SecondOrderSolver::reset_to_start_of_step() {
  Solver::reset_to_start_of_step();
  algorithmic_ = algorithmic_at_start_;
  belong_to_ = belong_to_at_start_;
}

[[gnu::flatten]] double SecondOrderSolver::compute_residual() {
  const TimedPart time(timer, timer.ODE2RHS);
  system().residual(current(), conditions_, residual_);
  return scale_residual(residual_);
}

// Computes the norm for the tolerances before ODE2 equations are scaled, so that it does not depend on the step size.
template <class S>
S SecondOrderSolver::scale_residual(std::vector<S>& residual) const {
  const S norm = norm_of(residual);
  const double scale = row_scale();
  each_number(system(), static_cast<std::size_t>(sizes_.ode2),
              [=, r = residual.data()](std::size_t i) { r[i] *= scale; });
  return norm;
}

[[gnu::flatten]] void SecondOrderSolver::compute_update(bool initial) {
  const TimedPart time(timer, timer.integrationFormula);
  initial ? predict() : correct();
}

void SecondOrderSolver::predict() {
  State& now = current();
  const double h = it.currentStepSize;
  if (lie_) previous_q_ = start_of_step().q;
  if (h != belong_to_.accelerations || h != belong_to_.velocities) [[unlikely]]
    change_step_size();
  predict_motion(system(), now.q.size(), {h, newmark_beta, newmark_gamma, alpha_m, alpha_f}, increment_of_q_.data(),
                 newmark() ? nullptr : algorithmic_.data(), now.q.data(), now.v.data(), now.a.data());
  for (std::size_t i = 0; i < now.y.size(); ++i) {
    now.y[i] += 0.5 * h * now.y_t[i];
    now.y_t[i] = 0;
  }
  if (lie_) predict_lie_rotations();
}

// Converts the values at the end of a step of another size.
[[gnu::noinline]] void SecondOrderSolver::change_step_size() {
  constexpr double negligible = 1e-6;
  if (belong_to_.begins || was_cut()) return start_steadily_in_step();
  if (belong_to_.accelerations == 0) return;
  const double ratio = it.currentStepSize / belong_to_.accelerations;
  if (ratio > largest_growth && !it.automaticStepSize) return;
  if (ratio != 1) move_algorithmic_accelerations(ratio);
  if (belong_to_.velocities == 0 || sizes_.ae == 0 || conditions_.rate_level) return;
  const double growth = it.currentStepSize / belong_to_.velocities, change = 1 - growth * growth;
  if (std::abs(change) < negligible) return;
  if (std::exchange(off_constraints_known_, it.currentStepIndex) != it.currentStepIndex)
    find_velocities_off_constraints();
  for (std::size_t i = 0; i < off_constraints_.size(); ++i) current().v[i] -= change * off_constraints_[i];
}

// Returns whether an event has shortened the previous step so much that its error terms are round-off for this step.
bool SecondOrderSolver::was_cut() const {
  return it.automaticStepSize && may_start_steadily() && belong_to_.velocities > 0 &&
         it.currentStepSize > largest_growth * belong_to_.velocities;
}

// Algorithmic accelerations are those at the time t + (alpha_m - alpha_f) h.
void SecondOrderSolver::move_algorithmic_accelerations(double ratio) {
  if (newmark()) return;
  const State& now = current();
  for (std::size_t i = 0; i < algorithmic_.size(); ++i)
    algorithmic_[i] = now.a[i] + ratio * (algorithmic_[i] - now.a[i]);
}

// `start_steadily` explains the offsets, which are zero where velocities fulfil the constraints. Error control always has factors, also after a
// failed step.
void SecondOrderSolver::find_velocities_off_constraints() {
  State still = current();
  still.time = it.currentTime - it.currentStepSize;
  off_constraints_.assign(still.v.size(), 0.0);
  if (it.automaticStepSize && factorized_) {
    std::ranges::copy(lead_->move_across(lead_->rates_at(still)), off_constraints_.begin());
    return;
  }
  ConstrainedMotion motion;
  prepare(motion);
  if (motion.factorize_with_all_masses(system(), still, conditions_) != LinearSolver::success ||
      !motion.project(system(), still, conditions_))
    return;
  for (std::size_t i = 0; i < off_constraints_.size(); ++i) off_constraints_[i] = current().v[i] - still.v[i];
}

void SecondOrderSolver::correct() {
  State& now = current();
  const double scale = row_scale();
  if (lie_) {
    previous_q_ = now.q;
    for (std::size_t i = 0; i < increment_of_q_.size(); ++i) increment_of_q_[i] = -increment_[i];
  }
  subtract_motion(system(), now.q.size(), increment_.data(), gamma_prime(), beta_prime(), now.q.data(), now.v.data(),
                  now.a.data());
  subtract(system(), now.lambda, 1 / scale, increment_.data() + sizes_.first_ae());
  if (!now.y.empty()) {
    subtract(system(), now.y, 1, increment_.data() + sizes_.ode2);
    subtract(system(), now.y_t, 2 / it.currentStepSize, increment_.data() + sizes_.ode2);
  }
  if (lie_) correct_lie_rotations();
}

// q = q_n o exp(increment). The second-order kinematic relation rotates the increment by half a step of the velocity.
[[gnu::noinline]] void SecondOrderSolver::predict_lie_rotations() {
  State& now = current();
  if (!simplified_lie_) {
    for (const System::LieBlock& block : system().lie_blocks()) {
      rotate_by_half_step(&increment_of_q_[static_cast<std::size_t>(block.rotation)],
                          &now.v[static_cast<std::size_t>(block.rotation)],
                          -0.5 * it.currentStepSize * newmark_beta / newmark_gamma);
    }
  }
  lie_increment_ = increment_of_q_;
  system().compose(previous_q_, increment_of_q_, now.q);
}

// Increments are composed with the last iterate; with simplified relations, their sum is composed with the start of the
// step.
[[gnu::noinline]] void SecondOrderSolver::correct_lie_rotations() {
  State& now = current();
  if (simplified_lie_) {
    subtract(system(), lie_increment_, 1, increment_.data());
    system().compose(start_of_step().q, lie_increment_, now.q);
  } else {
    system().compose(previous_q_, increment_of_q_, now.q);
  }
}

void SecondOrderSolver::finalize_newton() {
  belong_to_ = {it.currentStepSize, it.currentStepSize};
  add(system(), algorithmic_, (1 - alpha_f) / (1 - alpha_m), current().a);
  if (conditions_.rate_level) system().restore_unit_lengths(current(), 2);
}

Weights SecondOrderSolver::jacobian_weights() const {
  const double scale = row_scale();
  return {.q = scale, .v = scale * gamma_prime(), .a = scale * beta_prime(), .y = 1, .y_t = 2 / it.currentStepSize};
}

Conditions SecondOrderSolver::jacobian_conditions(bool momentary) const {
  Conditions conditions = conditions_;
  conditions.load_dependencies = loads_jacobian_;
  conditions.follows_residual = momentary;
  conditions.loads = momentary || loads_jacobian_ > 0;
  return conditions;
}

[[gnu::flatten]] void SecondOrderSolver::compute_jacobian() {
  const double scale = row_scale();
  const Conditions conditions = jacobian_conditions(full_newton_);
  if (full_newton_) {
    evaluate_jacobian(current(), conditions, jacobian_weights());
  } else {
    evaluate_jacobian(without_momentary_forces(current()), conditions, jacobian_weights());
  }
  scale_jacobian(jacobian_);
  add_user_jacobian(pattern(), jacobian_, {-scale, -gamma_prime() * scale, -scale});
}

void SecondOrderSolver::evaluate_jacobian(const State& state, const Conditions& conditions, const Weights& weights) {
  const auto& differences = newton_settings.numericalDifferentiation;
  if (wants_differences(differences)) {
    numerical_tangent(system(), state, conditions, weights, differences, pattern(), jacobian_);
  } else if (simplified_lie_ && options_.lieGroupAddTangentOperator) {
    simplified_lie_jacobian(state, conditions, weights);
  } else {
    system().tangent(state, conditions, weights, pattern(), jacobian_);
  }
}

// d(q_n o exp(x))/dx is the tangent operator at x, which applies only to the position part of the matrix.
[[gnu::noinline]] void SecondOrderSolver::simplified_lie_jacobian(const State& state, const Conditions& conditions,
                                                                  const Weights& weights) {
  more_values_.resize(jacobian_.size());
  Weights position = weights, rest = weights;
  position.v = position.a = 0;
  system().tangent(state, conditions, position, pattern(), jacobian_);
  apply_tangent_operator();
  rest.q = 0;
  // Constraint rows are divided by the weight of velocities if the weight of positions is zero.
  system().tangent(state, conditions, rest, pattern(), more_values_);
  const int n = sizes_.ode2, first_ae = sizes_.first_ae();
  for_each_entry(pattern(), [&](int row, int column, std::size_t slot) {
    if (column >= n) return;
    if (row < n) jacobian_[slot] += more_values_[slot];
    if (row >= first_ae) jacobian_[slot] += weights.v / weights.q * more_values_[slot];
  });
}

void SecondOrderSolver::apply_tangent_operator() {
  const Pattern& p = pattern();
  for (const System::LieBlock& block : system().lie_blocks()) {
    const auto t = tangent_operator(&lie_increment_[static_cast<std::size_t>(block.rotation)]);
    for_each_row(p, block.rotation, [&](int row) {
      std::array<double*, 3> entry{};
      std::array<double, 3> old{};
      for (int j = 0; j < 3; ++j) {
        entry[j] = &jacobian_[static_cast<std::size_t>(p.slot(row, block.rotation + j))];
        old[j] = *entry[j];
      }
      for (int j = 0; j < 3; ++j) *entry[j] = old[0] * t(0, j) + old[1] * t(1, j) + old[2] * t(2, j);
    });
  }
}

// ODE2 equations are multiplied by beta h^2 and multipliers divided by it, so that the condition number does not depend
// on h. The weights of ODE2 coordinates are scaled accordingly, without effect on constraints; the remaining entries
// are scaled here.
template <class S>
void SecondOrderSolver::scale_jacobian(std::vector<S>& values) const {
  const double scale = row_scale();
  const int n = sizes_.ode2, first_ae = sizes_.first_ae();
  const auto multiply = [&](std::size_t begin, std::size_t end, double factor) {
    for (std::size_t k = begin; k < end; ++k) values[k] *= factor;
  };
  if (sizes_.ode1 > 0) {
    for (int j = 0; j < n; ++j)
      multiply(column_range(pattern(), j, n).middle, column_range(pattern(), j, first_ae).middle, 1 / scale);
    for (int j = n; j < first_ae; ++j) {
      const ColumnRange column = column_range(pattern(), j, n);
      multiply(column.begin, column.middle, scale);
    }
  }
  each_stretch(system(), static_cast<std::size_t>(sizes_.ae), [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const ColumnRange column = column_range(pattern(), first_ae + static_cast<int>(k), n);
      multiply(column.middle, column.end, 1 / scale);
    }
  });
}

std::string_view SecondOrderSolver::lockstep_obstacle() const {
  if (it.automaticStepSize) return "steps whose size is chosen by their error";
  if (hooks().take_part_in_steps()) return "functions of the system that are called at each step";
  if (lead_->active()) return "velocities across constraints that oscillate";
  if (hooks().timeout >= 0) return "a limit of the time that solvers may take";
  if (verbose(1) || settings().displayComputationTime) return "messages of the solver";
  if (has_replaced_parts() || !newton_settings.useNewtonSolver)
    return "parts of the solver that are replaced or left out";
  if (wants_differences(newton_settings.numericalDifferentiation) || loads_jacobian_ != 0)
    return "derivatives by differences";
  if (discontinuous.iterationTolerance < 0) return "a negative discontinuous.iterationTolerance";
  if (!linear_->may_be_listed()) return "the linear solver, or more than 32 unknowns";
  return {};
}

void SecondOrderSolver::trace(Trace& trace) {
  TracedEquations equations(system());
  TracedState state;
  const State& now = current();
  const auto inputs = [&](std::vector<Traced>& to, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) to.push_back(trace.input());
  };
  inputs(state.q, now.q.size());
  inputs(state.v, now.v.size());
  inputs(state.a, now.a.size());
  inputs(state.lambda, now.lambda.size());
  std::vector<Traced> numbers(residual_.size());
  equations.residual(state, conditions_, numbers);
  numbers.push_back(scale_residual(numbers));
  trace.output(numbers);
  trace.end_part();
  const bool full = !newton_settings.useModifiedNewton;
  if (!full) {
    std::ranges::fill(state.a, Traced());
    std::ranges::fill(state.lambda, Traced());
  }
  numbers.resize(jacobian_.size());
  equations.tangent(state, jacobian_conditions(full), jacobian_weights(), pattern(), numbers);
  scale_jacobian(numbers);
  trace.output(numbers);
  trace.end_part();
}

}  // namespace dalembert
