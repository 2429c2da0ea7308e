#include "dalembert/solvers/static.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "steppers/arc_length.hpp"
#include "constraints/constraint_states.hpp"
#include "dalembert/solvers/numerical_tangent.hpp"
#include "diagnosis/diagnostics.hpp"

namespace dalembert {

// Differences of times below this part of the duration are round-off.
constexpr double time_tolerance = 1e-10;
constexpr double negligible_share = 1e-3;  // of velocity-dependent forces, relative to the largest force

void StaticSolver::read_settings() {
  Solver::read_settings();
  const auto& s = options_ = settings().staticSolver;
  factors_ = {.decrease = s.adaptiveStepDecrease,
              .increase = s.adaptiveStepIncrease,
              .recovery_steps = s.adaptiveStepRecoverySteps,
              .recovery_iterations = s.adaptiveStepRecoveryIterations};
}

double StaticSolver::load_factor() const { return (it.currentTime - it.startTime) / options_.loadStepDuration; }

void StaticSolver::pre_initialize() { conditions_ = {.load_factor = 1, .rate_level = false, .inertia = false}; }

void StaticSolver::initial_conditions() {
  Solver::initial_conditions();
  if (options_.loadStepGeometric && it.numberOfSteps <= 1) {
    warn("staticSolver.loadStepGeometric needs at least 2 load steps; 2 are computed");
    it.numberOfSteps = 2;
  }
  geometric_factor_ = it.numberOfSteps > 1
                          ? std::pow(options_.loadStepGeometricRange, 1.0 / static_cast<double>(it.numberOfSteps - 1))
                          : 1.0;
  begin_path();
}

// Load steps have equal size, or each load is a multiple of the previous one: a step of half the size has the root of the factor.
void StaticSolver::update_current_time() {
  current().sign = MultiplierSign::statics;
  if (path_) return begin_path_step();
  const double duration = options_.loadStepDuration, tolerance = time_tolerance * duration;
  double time = it.currentTime - it.startTime;
  if (!options_.loadStepGeometric) {
    time += it.currentStepSize;
  } else {
    const double share = it.currentStepSize / it.maxStepSize;
    time = time <= tolerance ? share * duration / options_.loadStepGeometricRange
                             : time * (share == 1 ? geometric_factor_ : std::pow(geometric_factor_, share));
  }
  if (time + tolerance >= duration) time = duration;
  it.currentTime = time + it.startTime;
  conditions_.load_factor = options_.useLoadFactor ? load_factor() : 1.0;
}

void StaticSolver::set_quasi_time(double time) {
  it.currentTime = current().time = time;
  conditions_.load_factor = options_.useLoadFactor ? load_factor() : 1.0;
}

void StaticSolver::increase_step_size() {
  if (!path_) steps_.recover();  // arc-length continuation has selected the next step size
}

// Decreases to zero at full load.
double StaticSolver::stabilizer() const {
  const double factor = load_factor();
  return (1 - factor * factor) * options_.stabilizerODE2term;
}

void StaticSolver::compute_mass_matrix() {
  const TimedPart time(timer, timer.massMatrix);
  mass_.resize(jacobian_.size());
  system().mass_matrix(current(), pattern(), mass_);
}

double StaticSolver::metric_scale() {
  std::vector<double> matrix(jacobian_.size()), masses;
  system().mass_matrix(system().state(ConfigurationType::StartOfStep), *pattern_, matrix);
  for (int j = 0; j < sizes_.ode2; ++j) masses.push_back(matrix[static_cast<std::size_t>(pattern_->slot(j, j))]);
  fill_in_masses(system(), masses);
  return scale_of_masses(masses, *pattern_, jacobian_, sizes_.ode2);
}

// Initial velocities are kept: with damping or gyroscopic forces, this is the steady state of a moving system.
void StaticSolver::look_for_motion() {
  State& now = current();
  if (std::ranges::all_of(now.v, [](double rate) { return rate == 0; })) return;
  compute_residual();
  const std::vector<double> moving = residual_;
  std::vector<double> velocities(now.v.size());
  velocities.swap(now.v);
  compute_residual();
  velocities.swap(now.v);
  std::vector<double> forces = std::exchange(residual_, moving);
  double largest = 0;
  for (std::size_t i = 0; i < forces.size(); ++i) {
    forces[i] = moving[i] - forces[i];
    largest = std::max(largest, std::abs(forces[i]));
  }
  if (norm_of(forces) <=
      std::max(newton_settings.relativeTolerance * initial_residual_, newton_settings.absoluteTolerance))
    return;
  std::vector<int> rows;
  for (int i = 0; i < sizes_.first_ae(); ++i)
    if (std::abs(forces[static_cast<std::size_t>(i)]) > negligible_share * largest) rows.push_back(i);
  diagnostics_->warn_of_velocities(rows, largest);
}

// Static multipliers have the opposite sign: applied forces + G^T lambda = 0.
void StaticSolver::turn_multipliers() {
  const std::span<const double> signs = system().static_signs();
  std::vector<double>& lambda = current().lambda;
  for (std::size_t i = 0; i < lambda.size(); ++i) lambda[i] *= signs[i];
}

double StaticSolver::compute_residual() {
  const TimedPart time(timer, timer.ODE2RHS);
  turn_multipliers();
  system().residual(current(), conditions_, residual_);
  turn_multipliers();
  const State& now = current();
  if (options_.constrainODE1coordinates) {
    for (std::size_t i = 0; i < now.y.size(); ++i) {
      residual_[static_cast<std::size_t>(sizes_.ode2) + i] = now.y[i] - initial().y[i];
    }
  }
  if (options_.stabilizerODE2term != 0) {
    compute_mass_matrix();
    const double factor = stabilizer();
    const State& start = start_of_step();
    for_each_entry(pattern(), [&](int row, int column, std::size_t slot) {
      if (row >= sizes_.ode2 || column >= sizes_.ode2) return;
      const auto i = static_cast<std::size_t>(column);
      residual_[static_cast<std::size_t>(row)] += factor * mass_[slot] * (now.q[i] - start.q[i]);
    });
  }
  return norm_of(residual_);
}

void StaticSolver::compute_update(bool initial) {
  if (path_ && initial) return predict_on_path();
  if (path_ && !path_->end_known) return correct_on_path();
  if (initial) return;
  for (double& number : increment_) number = -number;
  move(increment_);
  for (double& number : increment_) number = -number;
}

void StaticSolver::move(std::span<const double> step) {
  State& now = current();
  const auto ode2 = static_cast<std::size_t>(sizes_.ode2);
  if (system().has_lie_nodes()) {
    const std::vector<double> before = now.q, own(step.begin(), step.begin() + sizes_.ode2);
    for (std::size_t i = 0; i < ode2; ++i) now.q[i] += own[i];
    system().compose(before, own, now.q);
  } else {
    for (std::size_t i = 0; i < ode2; ++i) now.q[i] += step[i];
  }
  for (std::size_t i = 0; i < now.y.size(); ++i) now.y[i] += step[ode2 + i];
  const std::span<const double> signs = system().static_signs();
  for (std::size_t i = 0; i < now.lambda.size(); ++i)
    now.lambda[i] += signs[i] * step[static_cast<std::size_t>(sizes_.first_ae()) + i];
}

void StaticSolver::compute_jacobian() { compute_jacobian(options_.computeLoadsJacobian ? 1 : 0); }

void StaticSolver::compute_jacobian(double load_dependencies) {
  turn_multipliers();
  Conditions conditions = conditions_;
  conditions.load_dependencies = load_dependencies;
  if (wants_differences(newton_settings.numericalDifferentiation)) {
    numerical_tangent(system(), current(), conditions, along_positions, newton_settings.numericalDifferentiation,
                      pattern(), jacobian_);
  } else {
    system().tangent(current(), conditions, along_positions, pattern(), jacobian_);
  }
  turn_multipliers();
  const bool constrain = options_.constrainODE1coordinates && sizes_.ode1 > 0;
  const double factor = options_.stabilizerODE2term != 0 ? stabilizer() : 0.0;
  if (factor != 0) {
    compute_mass_matrix();
    for (std::size_t k = 0; k < jacobian_.size(); ++k) jacobian_[k] += factor * mass_[k];
  }
  if (constrain) {
    for_each_entry(pattern(), [&](int row, int column, std::size_t slot) {
      if (row >= sizes_.ode2 && row < sizes_.first_ae()) jacobian_[slot] = row == column ? 1.0 : 0.0;
    });
  }
  add_user_jacobian(pattern(), jacobian_, {-1, 0, -1});
}

}  // namespace dalembert
