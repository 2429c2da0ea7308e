#include "dalembert/solvers/diagonally_implicit.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "dalembert/model/errors.hpp"
#include "dalembert/solvers/numerical_tangent.hpp"
#include "steppers/combination.hpp"
#include "diagnosis/finite.hpp"
#include "steppers/rotation_increments.hpp"
#include "constraints/singular_positions.hpp"
#include "diagnosis/diagnostics.hpp"

namespace dalembert {

namespace {

constexpr std::size_t stages = 6;  // the first one is the end of the previous step
constexpr double gamma = 1.0 / 4;
// ESDIRK4(3)6L[2]SA: entries below the diagonal; the diagonal is gamma. The last row has the weights of the solution.
constexpr double coefficients[stages][stages - 1] = {
    {},
    {1.0 / 4},
    {8611.0 / 62500, -1743.0 / 31250},
    {5012029.0 / 34652500, -654441.0 / 2922500, 174375.0 / 388108},
    {15267082809.0 / 155376265600, -71443401.0 / 120774400, 730878875.0 / 902184768, 2285395.0 / 8070912},
    {82889.0 / 524892, 0, 15625.0 / 83664, 69875.0 / 102672, -2260.0 / 8211}};
constexpr double nodes[stages] = {0, 1.0 / 2, 83.0 / 250, 31.0 / 50, 17.0 / 20, 1};

constexpr double still_good = 0.2;      // contraction of an iteration below which the next step reuses the matrix
constexpr double too_slow = 0.5;        // contraction above which the matrix is updated at once
constexpr double other_step = 0.15;     // relative change of the step size for which the matrix is still used
constexpr int most_iterations = 10;     // with a matrix of an earlier state
// The estimated contraction decreases with each step whose stages take a single iteration, because such a step gives no
// information on an older matrix: E. Hairer and G. Wanner, Solving Ordinary Differential Equations II.
constexpr double forgetting = 0.8, least_rate = 1e-10;
constexpr double part_of_tolerance = 0.01;  // tolerance of Newton's method relative to that of errors
constexpr double negligible = 1e-11;  // change of velocities relative to the largest one: round-off of accelerations

// Returns the weight of stage j in the polynomial through all previous stages, at the node of a stage.
double extrapolation(std::size_t stage, std::size_t j) {
  double weight = 1;
  for (std::size_t m = 0; m < stage; ++m)
    if (m != j) weight *= (nodes[stage] - nodes[m]) / (nodes[j] - nodes[m]);
  return weight;
}

double size_of(std::span<const double> numbers) {
  double size = 0;
  for (const double x : numbers) size = std::max(size, std::abs(x));
  return size;
}

}  // namespace

double DiagonallyImplicitSolver::diagonal() const { return gamma * it.currentStepSize; }

void DiagonallyImplicitSolver::initialize_data() {
  Solver::initialize_data();
  system().complete_pattern();
  const auto n = static_cast<std::size_t>(sizes_.ode2), n1 = static_cast<std::size_t>(sizes_.ode1);
  for (std::size_t i = 0; i < stages; ++i) {
    stage_q_[i].assign(n, 0.0);
    stage_v_[i].assign(n, 0.0);
    stage_y_[i].assign(n1, 0.0);
    stage_lambda_[i].assign(static_cast<std::size_t>(sizes_.ae), 0.0);
  }
  lie_ = system().has_lie_nodes();
  for (Vector* numbers : {&base_q_, &base_v_, &base_turn_, &turn_}) numbers->assign(n, 0.0);
  base_y_.assign(n1, 0.0);
  x_.assign(static_cast<std::size_t>(sizes_.total()), 0.0);
  conditions_ = {.rate_level = false, .inertia = true};
  warned_of_masses_ = false;
  misfit_at_end_ = misfit_at_start_ = 0;
}

void DiagonallyImplicitSolver::post_initialize() {
  require_no_algebraic_coordinates();
  prepare_factors();
  const SolverHooks& h = hooks();
  interferes_ =
      system().has_discontinuities(conditions_) || system().searches() || h.pre_step || h.post_step || h.post_newton;
  State& now = current();
  if (continues()) {
    misfit_at_end_ = continued_number(0);
    after_jump_ = continued_number(1) != 0;
  } else {
    after_jump_ = true;
    std::ranges::fill(now.lambda, 0.0);
    find_accelerations();
    if (interferes_) misfit_at_end_ = misfit_of_accelerations();
  }
  start_of_step() = now;
}

void DiagonallyImplicitSolver::require_no_algebraic_coordinates() const {
  for (int k = 0; k < sizes_.ae; ++k) {
    if (system().constrains_motion(k)) continue;
    throw ModelError(
        ErrorKind::value,
        name() + ": " + system().describe_row(sizes_.first_ae() + k) +
            " says what an algebraic coordinate is; expected constraints of coordinates or velocities only. "
            "Use exu.DynamicSolverType.GeneralizedAlpha with stepSizeControl.implicitSolvers=True");
  }
}

void DiagonallyImplicitSolver::prepare_factors() {
  prepare(motion_);
  masses_ready_ = false;
  smallest_ = {};
  factorized_for_ = slowest_ = 0;
  rate_ = 1;
  unassessed_stages_ = 0;
}

// Discards the factors, which depend on pivots of earlier matrices.
void DiagonallyImplicitSolver::forget() {
  Solver::forget();
  prepare_factors();
}

void DiagonallyImplicitSolver::solve_as_regular() {
  motion_.solve_as_regular();
  factorized_for_ = 0;
}

void DiagonallyImplicitSolver::pattern_revised() { prepare_factors(); }

void DiagonallyImplicitSolver::save_start_of_step() {
  Solver::save_start_of_step();
  misfit_at_start_ = misfit_at_end_;
}

ConstrainedMotion* DiagonallyImplicitSolver::motion_under_constraints() {
  if (!std::exchange(masses_ready_, true)) prepare(masses_);
  return &masses_;
}

// Stages add increments of minimum-norm multipliers. The component of their sum in the null space rotates with the
// bodies, and is removed here.
const std::vector<double>* DiagonallyImplicitSolver::minimum_norm_multipliers() {
  const State& now = current();
  if (!motion_.constraints().active()) return nullptr;
  if (!smallest_.ready) prepare(smallest_.motion);
  if (!std::exchange(smallest_.ready, true) || smallest_.q != now.q || smallest_.lambda != now.lambda) {
    smallest_.q = now.q;
    smallest_.lambda = smallest_.reported = now.lambda;
    smallest_.motion.make_smallest(motion_.constraints(), system(), now, conditions_, smallest_.reported);
  }
  return &smallest_.reported;
}

// Computes accelerations, rates and multipliers of the current state.
void DiagonallyImplicitSolver::find_accelerations() {
  State& state = current();
  motion_under_constraints();
  const int row = masses_.factorize(system(), state, conditions_);
  system().right_hand_sides(state, conditions_, state.a, state.y_t);
  if (row == LinearSolver::success) {
    masses_.accelerations(system(), state, conditions_, state.a, state.lambda);
    const auto find = [&](const State& at, Vector& a, Vector& lambda) {
      Vector y_t(state.y_t.size());
      system().right_hand_sides(at, conditions_, a, y_t);
      masses_.accelerations(system(), at, conditions_, a, lambda);
    };
    if (it.currentStepIndex <= 1 && !masses_.follow_motion(system(), state, conditions_, state.a, state.lambda, find))
      singular_->warn_of_undecided_start();
  } else if (!find_accelerations_without_masses() && !std::exchange(warned_of_masses_, true)) {
    warn(name() + ": accelerations at the start are set to zero: mass matrix and constraints are singular at unknown " +
         std::to_string(row) + " (" + system().describe_row(row) + ")");
  }
}

// Coordinates without mass move to equilibrium, by one iteration of a very short step from the current state.
bool DiagonallyImplicitSolver::find_accelerations_without_masses() {
  constexpr double very_short = 1e-3;
  State& now = current();
  const double h = it.currentStepSize;
  steps_.use(very_short * (h > 0 ? h : it.automaticStepSize ? it.initialStepSize : it.maxStepSize));
  std::ranges::fill(now.a, 0.0);
  std::ranges::fill(now.lambda, 0.0);
  const bool regular = factorize();
  if (regular) {
    evaluate_residual();
    motion_.solve(x_);
    subtract(system(), now.a, 1, x_.data());
    subtract(system(), now.lambda, 1, x_.data() + sizes_.first_ae());
  }
  steps_.use(h);
  factorized_for_ = 0;
  return regular;
}

double DiagonallyImplicitSolver::misfit_of_accelerations() {
  system().residual(current(), conditions_, x_);
  return sum_of_squares(system(), std::span<const double>(x_).first(static_cast<std::size_t>(sizes_.first_ae())));
}

// The first stage is the end of the previous step, unless user functions, contact or friction have changed forces in
// between.
void DiagonallyImplicitSolver::accelerations_that_fit() {
  State &now = current(), &start = start_of_step();
  now.time = start.time;
  const bool moved = now.q != start.q || now.v != start.v || now.y != start.y;
  if (moved || misfit_of_accelerations() != misfit_at_start_) {
    find_accelerations();
    start = now;
    misfit_at_start_ = misfit_of_accelerations();
  }
  now.time = it.currentTime;
}

// ---- stages
// ------------------------------------------------------------------------------------------------------------

bool DiagonallyImplicitSolver::newton() {
  conv.linearSolverFailed = conv.newtonConverged = conv.newtonSolutionDiverged = conv.newtonStagnated =
      conv.stopNewton = false;
  conv.linearSolverCausingRow = -1;
  it.newtonSteps = 0;
  if (sizes_.ae > 0) motion_.begin_step(system(), start_of_step(), conditions_);
  if (!solve_stages()) return false;
  if (it.automaticStepSize) it.automaticStepSizeError = estimated_error();
  if (!back_onto_constraints()) return false;
  if (interferes_) misfit_at_end_ = misfit_of_accelerations();
  if (!rank_known_) find_rank();
  return conv.newtonConverged = true;
}

bool DiagonallyImplicitSolver::solve_stages() {
  const State& start = start_of_step();
  stage_q_[0] = start.v;
  stage_v_[0] = start.a;
  stage_y_[0] = start.y_t;
  stage_lambda_[0] = start.lambda;
  if (slowest_ > still_good) factorized_for_ = 0;
  slowest_ = 0;
  for (int stage = 1; stage < static_cast<int>(stages); ++stage) {
    if (sizes_.total() > 200) poll_interrupt();
    if (const Outcome outcome = solve_stage(stage); outcome != Outcome::solved) return fail(outcome);
    keep_rates(stage);
  }
  return true;
}

DiagonallyImplicitSolver::Outcome DiagonallyImplicitSolver::solve_stage(int stage) {
  begin_stage(stage);
  predict(stage);
  fresh_ = false;
  if (!factors_serve() && !factorize()) return Outcome::singular;
  Outcome outcome = iterate(stage, fresh_ ? newton_settings.maxIterations : most_iterations);
  if (outcome != Outcome::solved && !fresh_) {
    predict(stage);
    if (!factorize()) return Outcome::singular;
    outcome = iterate(stage, newton_settings.maxIterations);
  }
  if (outcome != Outcome::slow || sizes_.ae == 0) return outcome;
  predict(stage);
  const bool regular = factorize(true);
  if (regular) outcome = iterate(stage, newton_settings.maxIterations);
  factorized_for_ = 0;  // the factors are not valid for another stage
  return regular ? outcome : Outcome::singular;
}

bool DiagonallyImplicitSolver::factors_serve() const {
  const bool requested = hooks().jacobian_update_requested && hooks().jacobian_update_requested();
  return factorized_for_ > 0 && std::abs(diagonal() / factorized_for_ - 1) <= other_step &&
         !conv.jacobianUpdateRequested && !requested;
}

void DiagonallyImplicitSolver::begin_stage(int stage) {
  const State& start = start_of_step();
  const double h = it.currentStepSize;
  std::array<WeightedVector, stages> terms;
  const auto sum = [&](Vector& x, const Vector& from, const std::array<Vector, stages>& rates) {
    for (std::size_t j = 0; j < static_cast<std::size_t>(stage); ++j)
      terms[j] = {h * coefficients[stage][j], rates[j].data()};
    combine(system(), x, from, std::span(terms.data(), static_cast<std::size_t>(stage)));
  };
  sum(base_q_, start.q, stage_q_);
  sum(base_v_, start.v, stage_v_);
  sum(base_y_, start.y, stage_y_);
  current().time = stage + 1 == static_cast<int>(stages) ? it.currentTime : start.time + h * nodes[stage];
  if (!lie_) return;
  std::ranges::fill(turn_, 0.0);
  sum(base_turn_, turn_, stage_q_);
}

// Extrapolates accelerations and multipliers from the previous stages.
void DiagonallyImplicitSolver::predict(int stage) {
  State& now = current();
  const auto last = static_cast<std::size_t>(stage);
  std::array<WeightedVector, stages> terms;
  const auto extrapolate = [&](Vector& x, const std::array<Vector, stages>& values) {
    for (std::size_t j = 0; j < last; ++j) terms[j] = {extrapolation(last, j), values[j].data()};
    std::ranges::fill(x, 0.0);
    combine(system(), x, x, std::span(terms.data(), last));
  };
  extrapolate(now.a, stage_v_);
  extrapolate(now.y_t, stage_y_);
  extrapolate(now.lambda, stage_lambda_);
  follow_rates();
}

void DiagonallyImplicitSolver::follow_rates() {
  State& now = current();
  const double g = diagonal();
  each_number(system(), now.q.size(),
              [=, q0 = base_q_.data(), v0 = base_v_.data(), a = now.a.data(), v = now.v.data(),
               q = now.q.data()](std::size_t i) {
                v[i] = v0[i] + g * a[i];
                q[i] = q0[i] + g * v[i];
              });
  for (std::size_t i = 0; i < now.y.size(); ++i) now.y[i] = base_y_[i] + g * now.y_t[i];
  if (lie_) turn_rotations();
}

// Solves x = X + gamma h T(x)^-1 omega with q = q_n o exp(x) by fixed-point iteration; the equation is almost explicit.
[[gnu::noinline]] void DiagonallyImplicitSolver::turn_rotations() {
  constexpr int most = 20;
  State& now = current();
  for (std::size_t i = 0; i < turn_.size(); ++i) turn_[i] = base_turn_[i] + diagonal() * now.v[i];
  for (const System::LieBlock& block : system().lie_blocks()) {
    const auto r = static_cast<std::size_t>(block.rotation);
    const Vec3<double> base = load<double, 3>(&base_turn_[r]), omega = load<double, 3>(&now.v[r]);
    Vec3<double> x = load<double, 3>(&turn_[r]);
    for (int k = 0; k < most; ++k) {
      const Vec3<double> before = x;
      x = base + diagonal() * (inverse_tangent_operator(&x[0]) * omega);
      const Vec3<double> change = x - before;
      if (dot(change, change) <= 1e-32 * dot(x, x)) break;
    }
    for (std::size_t k = 0; k < 3; ++k) turn_[r + k] = x[static_cast<int>(k)];
  }
  system().compose(start_of_step().q, turn_, now.q);
}

void DiagonallyImplicitSolver::keep_rates(int stage) {
  const State& now = current();
  const auto s = static_cast<std::size_t>(stage);
  stage_q_[s] = now.v;
  stage_v_[s] = now.a;
  stage_y_[s] = now.y_t;
  stage_lambda_[s] = now.lambda;
  if (!lie_) return;
  for (const System::LieBlock& block : system().lie_blocks()) {
    const auto r = static_cast<std::size_t>(block.rotation);
    const Vec3<double> rate = inverse_tangent_operator(&turn_[r]) * load<double, 3>(&now.v[r]);
    for (std::size_t k = 0; k < 3; ++k) stage_q_[s][r + k] = rate[static_cast<int>(k)];
  }
}

// ---- Newton's method ---------------------------------------------------------------------------------------------------

void DiagonallyImplicitSolver::evaluate_residual() {
  if (hooks().pre_newton_residual) {
    const TimedPart time(timer, timer.python);
    hooks().pre_newton_residual(current().time, it.newtonSteps, it.discontinuousIteration);
  }
  const TimedPart time(timer, timer.ODE2RHS);
  system().residual(current(), conditions_, x_);
  if (sizes_.ae > 0)
    std::ranges::copy(motion_.gap_accelerations(system(), current(), conditions_), x_.begin() + sizes_.first_ae());
}

// `constraints_follow_motion` adds the change of constraints along the motion, for convergence close to singular
// configurations.
bool DiagonallyImplicitSolver::factorize(bool constraints_follow_motion) {
  const double g = diagonal();
  const Weights weights{.q = g * g, .v = g, .a = 1, .y = g, .y_t = 1};
  Conditions conditions = conditions_;
  conditions.load_dependencies = loads_jacobian_;
  {
    const TimedPart time(timer, timer.totalJacobian);
    const auto& differences = newton_settings.numericalDifferentiation;
    if (wants_differences(differences)) {
      numerical_tangent(system(), current(), conditions, weights, differences, motion_.pattern(), motion_.matrix());
    } else {
      system().tangent(current(), conditions, weights, motion_.pattern(), motion_.matrix());
    }
    add_user_jacobian(motion_.pattern(), motion_.matrix(), {-g * g, -g, -g});
  }
  const TimedPart time(timer, timer.factorization);
  conv.linearSolverCausingRow =
      motion_.factorize_around_matrix(system(), current(), conditions_, constraints_follow_motion ? g : 0);
  conv.linearSolverFailed = conv.linearSolverCausingRow != LinearSolver::success;
  conv.jacobianUpdateRequested = false;
  ++it.newtonJacobiCount;
  factorized_for_ = conv.linearSolverFailed ? 0 : g;
  slowest_ = 0;
  rate_ = 1;
  unassessed_stages_ = 0;
  fresh_ = true;
  return !conv.linearSolverFailed;
}

DiagonallyImplicitSolver::Outcome DiagonallyImplicitSolver::iterate(int stage, int most) {
  State& now = current();
  const double enough = it.automaticStepSize ? part_of_tolerance : 1;
  double last = 0;
  const int steps = unassessed_stages_ / static_cast<int>(stages - 1);
  const double known_rate = steps > 0 ? std::pow(std::max(rate_, least_rate), std::pow(forgetting, steps)) : rate_;
  for (int k = 1; k <= most; ++k) {
    evaluate_residual();
    {
      const TimedPart time(timer, timer.newtonIncrement);
      motion_.solve(x_);
    }
    subtract(system(), now.a, 1, x_.data());
    subtract(system(), now.y_t, 1, x_.data() + sizes_.ode2);
    subtract(system(), now.lambda, 1, x_.data() + sizes_.first_ae());
    follow_rates();
    ++it.newtonSteps;
    ++it.newtonStepsCount;
    const double size = conv.residual = increment_size();
    if (verbose(2))
      say(2, "    stage " + std::to_string(stage + 1) + ", iteration " + std::to_string(k) +
                 ": increment = " + number(size) + "\n");
    if (!(size < unbounded)) return Outcome::lost;
    const double ratio = k > 1 ? size / last : 0;
    if (k > 1) {
      rate_ = std::max(0.3 * rate_, ratio);
      unassessed_stages_ = 0;
      if (size > enough * still_good * still_good) slowest_ = std::max(slowest_, ratio);
    }
    if (size * std::min(1.0, k > 1 ? rate_ : known_rate) <= enough) {
      unassessed_stages_ += k == 1;
      return Outcome::solved;
    }
    if (k > 2 && ratio > still_good && at_round_off()) {
      conv.newtonStagnated = true;
      ++it.stagnatedNewtonSteps;
      return Outcome::solved;
    }
    if (ratio > 2 || (!fresh_ && ratio > too_slow)) return Outcome::slow;
    last = size;
  }
  return Outcome::slow;
}

bool DiagonallyImplicitSolver::at_round_off() const {
  const State& now = system().state(ConfigurationType::Current);
  return diagonal() * size_of(std::span(x_).first(now.v.size())) <= negligible * std::max(1.0, size_of(now.v));
}

// Returns the root mean square of the increment in units of the tolerance of Newton's method.
double DiagonallyImplicitSolver::increment_size() const {
  const State &now = system().state(ConfigurationType::Current),
              &start = system().state(ConfigurationType::StartOfStep);
  const double g = diagonal();
  double sum = 0;
  for (std::size_t i = 0; i < now.q.size(); ++i) {
    const double of_q = g * g * x_[i] / weight(now.q[i], start.q[i]), of_v = g * x_[i] / weight(now.v[i], start.v[i]);
    sum += of_q * of_q + of_v * of_v;
  }
  for (std::size_t i = 0; i < now.y.size(); ++i) {
    const double e = g * x_[static_cast<std::size_t>(sizes_.ode2) + i] / weight(now.y[i], start.y[i]);
    sum += e * e;
  }
  return std::sqrt(sum / std::max(1, 2 * sizes_.ode2 + sizes_.ode1));
}

// Equal steps have no error tolerances, and use those of Newton's method.
double DiagonallyImplicitSolver::weight(double value, double before) const {
  const double size = std::max(std::abs(value), std::abs(before));
  return it.automaticStepSize ? tolerances_.of(size)
                              : newton_settings.absoluteTolerance + newton_settings.relativeTolerance * size;
}

// Always returns false. The next attempt uses new factors.
[[gnu::noinline]] bool DiagonallyImplicitSolver::fail(Outcome outcome) {
  factorized_for_ = 0;
  if (outcome == Outcome::singular) {
    conv.stopNewton = true;
    if (all_finite(motion_.matrix()))
      diagnostics_->diagnose_singular_matrix(motion_.pattern(), motion_.matrix());
    else
      outcome = Outcome::lost;
  }
  if (outcome == Outcome::lost) {
    conv.linearSolverFailed = false;
    diagnostics_->diagnose_not_finite(x_);
  }
  if (outcome == Outcome::slow) {
    system().residual(current(), conditions_, x_);
    diagnostics_->diagnose(FailureReason::newton, x_);
  }
  return false;
}

// Projects onto the constraints with the present factors, or with new ones, which the next step reuses.
bool DiagonallyImplicitSolver::back_onto_constraints() {
  if (sizes_.ae == 0) return true;
  if (!motion_.project(system(), current(), conditions_)) {
    if (!factorize()) return fail(Outcome::singular);
    if (!motion_.project(system(), current(), conditions_)) return leave_open_gaps();
  }
  largest_misfit_ = std::max(largest_misfit_, motion_.largest_misfit());
  if (diagnostics_->contradiction_text().empty())
    if (const std::vector<double> misfit = motion_.misfit(system(), current(), conditions_); !misfit.empty())
        [[unlikely]]
      diagnostics_->warn_of_contradiction(misfit);
  return true;
}

// Always returns false. Close to a singular configuration, steps of other sizes may end where gaps can be closed.
[[gnu::noinline]] bool DiagonallyImplicitSolver::leave_open_gaps() {
  diagnostics_->diagnose_open_gaps();
  const bool may_be_reduced = (it.adaptiveStep || it.automaticStepSize) && !steps_.at_minimum();
  if (may_be_reduced && diagnosis_.reason == FailureReason::singular_position)
    diagnosis_.reason = FailureReason::open_constraints;
  return false;
}

void DiagonallyImplicitSolver::free_memory() {
  for (auto* parts : {&stage_q_, &stage_v_, &stage_y_, &stage_lambda_})
    for (Vector& numbers : *parts) numbers = {};
  for (Vector* numbers : {&base_q_, &base_v_, &base_y_, &base_turn_, &turn_, &x_}) *numbers = {};
  motion_.free_memory();
  masses_ = {};
  masses_ready_ = false;
  smallest_ = {};
}

}  // namespace dalembert
