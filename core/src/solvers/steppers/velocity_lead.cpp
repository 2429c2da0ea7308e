// Generalized alpha with position constraints: velocities across the constraints.
//
// The scheme determines positions across a constraint; velocities follow a recursion with the triple root -rho. If the
// free directions rotate by th radians per step, the root splits into -rho and -rho (1 +- sqrt(3) th): for th above
// about (1/rho - 1)/sqrt(3), velocities grow with alternating signs. Prescribing the velocities in each step removes
// the triple root. The value is not G v = 0 but the lead G v = -C h^2 G da/dt, for which reactions of equal steps are
// of second order: Arnold, Bruels, Cardona: Error analysis of generalized-alpha Lie group time integration methods for
// constrained mechanical systems, Numerische Mathematik 129 (2015). docs/theory/constrained_steps.rst has the
// derivation.
#include "steppers/velocity_lead.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "constraints/constraint_states.hpp"
#include "dalembert/math/sum_of_squares.hpp"
#include "dalembert/output/numbers.hpp"
#include "dalembert/solvers/open_constraints.hpp"
#include "dalembert/system/large_vectors.hpp"

namespace dalembert {

namespace {

// For motions that start from rest: lower bound of the reference speed, in units of h |a|.
constexpr double scale_of_rest = 10;
// Growth per step of oscillations, rho (1 + sqrt(3) th) with half a radian.
constexpr double fastest_growth = 1.7, most_steps_to_wait = 50;
constexpr double negligible_way = 1e-6; // displacement within a step, relative to the size of the model
// A step is coarse if the velocities across the constraints exceed this share of the largest velocity, in the norm of the step matrix. The
// energy error is then a few percent.
constexpr double coarse_part = 0.02;
constexpr StepCount first_judged = 4;  // number of steps with lead before its size is assessed

// Returns the largest velocity across constraints, relative to the largest velocity, of a stable smooth motion: C th^2
// at the stability limit, with a margin of 5.
double tolerated_velocity(double spectral_radius, double left_out) {
  const double limit = (1 / std::max(spectral_radius, 1e-3) - 1) / std::sqrt(3.0);
  return std::clamp(5 * left_out * limit * limit, 1e-4, 0.04);
}

// Returns the number of steps until n^2 rho^n has decayed to a hundredth of its maximum: the decay of velocities across
// constraints after a jump of accelerations.
int steps_to_decay(double spectral_radius) {
  constexpr int most = 200;
  double largest = 0;
  for (int n = 1; n < most; ++n) {
    const double size = n * n * std::pow(spectral_radius, n);
    if (size < 0.01 * largest) return n;
    largest = std::max(largest, size);
  }
  return most;
}

}  // namespace

VelocityLead::VelocityLead(SecondOrderSolver& method)
    : SolverPart(method), method_(method), constraints_renewed_(system().renewed_constraints()) {}

// Called after each step of equal size.
void VelocityLead::watch() {
  if (!active_ && !velocities_oscillate()) return;
  const std::uint64_t renewed = system().renewed_constraints();
  const bool prescribed_by_parameters = std::exchange(constraints_renewed_, renewed) != renewed;
  if (!prescribed_by_parameters) {
    active_ = true;
    lead_and_judge();
  } else if (!active_) {
    count_doubt(not_led_, not_led_since_);
  }
}

// Differences of accelerations, which cost two vectors, give a first indication; the velocities across constraints
// decide. Stiff vibrations along the constraints give an indication in each step: velocities far below the tolerance
// are evaluated again only when they could have grown to it.
bool VelocityLead::velocities_oscillate() {
  const bool suspicious = accelerations_alternate();
  if (steps_to_wait_ > 0) {
    --steps_to_wait_;
    return false;
  }
  if (!suspicious || !has_factors()) {
    across_.clear();
    return false;
  }
  const double tolerated = tolerated_velocity(method_.spectral_radius, method_.left_out()) * largest_speed_;
  const auto size_of_across = [&](bool as_driven) {
    across_ = velocities_across(it.currentStepSize, as_driven);
    return std::sqrt(sum_of_squares<double>(across_));
  };
  const std::vector<double> before = across_;
  double size = size_of_across(false);
  if (size > tolerated) size = closes_gaps_of_start() ? 0 : size_of_across(true);
  if (!(size > tolerated)) {
    across_.clear();
    steps_to_wait_ = static_cast<int>(
        std::min(most_steps_to_wait, std::log(tolerated / std::max(size, 1e-300)) / std::log(fastest_growth)));
    return false;
  }
  return !before.empty() && std::inner_product(before.begin(), before.end(), across_.begin(), 0.0) < 0;
}

// Compares the changes of accelerations in two successive steps: h |change - change before| / 4 is the velocity of an
// alternating oscillation.
bool VelocityLead::accelerations_alternate() {
  const State& now = current();
  const std::vector<double>& accelerations = method_.newmark() ? now.a : method_.algorithmic_;
  const double h = it.currentStepSize;
  if (step_size_ != h) {
    equal_steps_ = 0;
    step_size_ = h;
    negligible_speed_ = negligible_way * system().extent() / h;
  }
  change_.resize(now.a.size());
  accelerations_.resize(now.a.size());
  double difference = 0, velocity = 0, acceleration = 0;
  for (std::size_t i = 0; i < now.a.size(); ++i) {
    const double change = accelerations[i] - accelerations_[i], d = change - change_[i];
    accelerations_[i] = accelerations[i];
    change_[i] = change;
    difference += d * d;
    velocity += now.v[i] * now.v[i];
    acceleration += now.a[i] * now.a[i];
  }
  largest_speed_ =
      std::max({largest_speed_, negligible_speed_, std::sqrt(velocity), scale_of_rest * h * std::sqrt(acceleration)});
  const double tolerated = tolerated_velocity(method_.spectral_radius, method_.left_out()) * largest_speed_;
  return ++equal_steps_ > 2 && 0.25 * h * std::sqrt(difference) > tolerated;
}

// Inconsistent initial values are corrected in the first step, which causes decaying velocities across constraints.
bool VelocityLead::closes_gaps_of_start() {
  if (it.currentStepIndex >= steps_to_decay(method_.spectral_radius)) return false;
  if (!begins_open_) {
    const auto& s = settings().initialConditions;
    begins_open_ =
        !open_constraints(system(), initial(), conditions_, {s.positionTolerance, s.velocityTolerance, true}).empty();
  }
  return *begins_open_;
}

// A lead that is large in the norm of the step matrix, which is close to the mass matrix, shows that steps are too
// coarse.
void VelocityLead::lead_and_judge() {
  const bool smooth = it.discontinuousIteration <= 1;  // no jump of accelerations within the step
  const double across = apply(it.currentStepSize, it.currentStepSize, smooth);
  largest_energy_ = std::max(largest_energy_, step_energy(current().v));
  if (++steps_with_lead_ > first_judged && smooth && across > coarse_part * coarse_part * largest_energy_)
    count_doubt(coarse_, coarse_since_);
}

void VelocityLead::count_doubt(StepCount& steps, double& since) const {
  if (steps++ == 0) since = it.currentTime;
}

// Replaces the velocities across constraints by the lead for the step size `next`, or by zero if accelerations have
// jumped. Returns the square of the change in the norm of the step matrix.
double VelocityLead::apply(double step_size, double next, bool smooth) {
  State& now = current();
  const double factor = smooth ? method_.left_out() * next * next / step_size : 0;
  std::vector<double> change(now.v.size());
  for (std::size_t i = 0; i < change.size(); ++i) change[i] = method_.change_of_accelerations(i, step_size);
  const std::vector<double> rates = rates_with_lead(factor, change);
  const std::span<const double> across = move_across(rates);
  for (std::size_t i = 0; i < now.v.size(); ++i) now.v[i] -= across[i];
  method_.belong_to_.velocities = smooth ? next : 0;
  double energy = 0;
  for (std::size_t k = 0; k < rates.size(); ++k)
    energy -= rates[k] * method_.increment_[static_cast<std::size_t>(sizes_.first_ae()) + k];
  return energy;
}

// Computes the part of the velocities across constraints that exceeds the lead, with the present factors. `as_driven`
// includes rates prescribed in time, at additional cost.
std::vector<double> VelocityLead::velocities_across(double step_size, bool as_driven) {
  std::vector<double> rates;
  if (as_driven) {
    rates = rates_with_lead(method_.left_out() * step_size, change_);
  } else {
    State moved = current();
    for (std::size_t i = 0; i < moved.v.size(); ++i) moved.v[i] += method_.left_out() * step_size * change_[i];
    rates.resize(moved.lambda.size());
    system().gaps(moved, at_level(conditions_, true), rates);
  }
  const std::span<const double> across = move_across(rates);
  return {across.begin(), across.end()};
}

// Computes the rates of constraints at the velocities plus `factor` times the change of accelerations. Velocity
// constraints hold at the end of each step and need no lead.
std::vector<double> VelocityLead::rates_with_lead(double factor, std::span<const double> change) {
  State moved = current();
  for (std::size_t i = 0; i < moved.v.size(); ++i) moved.v[i] += factor * change[i];
  std::vector<double> rates = rates_at(moved);
  const std::vector<char>& of_velocities = row_kinds().of_velocities;
  if (factor == 0 || std::ranges::none_of(of_velocities, [](char k) { return k != 0; })) return rates;
  std::vector<double> without_lead(rates.size());
  system().gaps(current(), at_level(conditions_, true), without_lead);
  for (std::size_t k = 0; k < rates.size(); ++k)
    if (of_velocities[k]) rates[k] = without_lead[k];
  return rates;
}

// Rates of positions that user functions prescribe in time are computed by finite differences.
std::vector<double> VelocityLead::rates_at(const State& state) {
  if (std::ranges::any_of(row_kinds().driven, [](char d) { return d != 0; }))
    return rates_of_gaps(system(), state, conditions_, method_.last_time(), row_kinds().of_velocities);
  std::vector<double> rates(state.lambda.size());
  system().gaps(state, at_level(conditions_, true), rates);
  return rates;
}

const VelocityLead::RowKinds& VelocityLead::row_kinds() {
  if (row_kinds_.driven.size() != static_cast<std::size_t>(sizes_.ae)) {
    row_kinds_.driven = driven_equations(system(), current(), conditions_, method_.last_time());
    row_kinds_.of_velocities = constraint_rates(system(), current(), conditions_, method_.last_time()).of_velocities;
  }
  return row_kinds_;
}

// Returns the velocities with these constraint rates and the smallest norm in the step matrix, with the present
// factors.
std::span<const double> VelocityLead::move_across(std::span<const double> rates) {
  const auto first = static_cast<std::size_t>(sizes_.first_ae());
  const double factor = conditions_.rate_level ? method_.rate_factor() : 1;  // scale of the rows
  std::ranges::fill(method_.increment_, 0.0);
  if (has_factors()) {
    for (std::size_t k = 0; k < rates.size(); ++k)
      if (system().constrains_motion(static_cast<int>(k))) method_.increment_[first + k] = factor * rates[k];
    method_.linear_->solve(method_.increment_);
  }
  return std::span<const double>(method_.increment_).first(current().v.size());
}

// Returns v^T J v with the ODE2 block of the step matrix: about twice the kinetic energy, times (1 - alpha_m)/(1 -
// alpha_f).
double VelocityLead::step_energy(std::span<const double> v) const {
  double energy = 0;
  for_each_entry(method_.pattern(), [&](int row, int column, std::size_t slot) {
    if (row < sizes_.ode2 && column < sizes_.ode2)
      energy += v[static_cast<std::size_t>(row)] * method_.jacobian_[slot] * v[static_cast<std::size_t>(column)];
  });
  return energy;
}

void VelocityLead::forget() {
  row_kinds_ = {};
  equal_steps_ = steps_to_wait_ = 0;
  across_.clear();
}

std::vector<double> VelocityLead::restart_numbers() const {
  return {static_cast<double>(active_),
          largest_speed_,
          largest_energy_,
          static_cast<double>(steps_with_lead_),
          static_cast<double>(coarse_),
          coarse_since_,
          static_cast<double>(not_led_),
          not_led_since_};
}

void VelocityLead::resume(const std::array<double, restart_size>& numbers) {
  active_ = numbers[0] != 0;
  largest_speed_ = numbers[1];
  largest_energy_ = numbers[2];
  steps_with_lead_ = static_cast<StepCount>(numbers[3]);
  coarse_ = static_cast<StepCount>(numbers[4]);
  coarse_since_ = numbers[5];
  not_led_ = static_cast<StepCount>(numbers[6]);
  not_led_since_ = numbers[7];
}

std::vector<std::string> VelocityLead::doubts() const {
  std::vector<std::string> doubts;
  const auto steps = [](StepCount n, double since) {
    return "in " + std::to_string(n) + (n == 1 ? " step, at time " : " steps, the first at time ") +
           format_number(since);
  };
  if (coarse_ > 0) {
    doubts.push_back("constraints turn too far " + steps(coarse_, coarse_since_) +
                     ": the velocities there have large errors; use smaller steps (now " +
                     format_number(it.currentStepSize) + " s)");
  }
  if (not_led_ > 0) {
    doubts.push_back("velocities across constraints oscillate " + steps(not_led_, not_led_since_) +
                     ", and cannot be corrected because a function changes parameters of constraints in each step: use "
                     "smaller steps, a smaller "
                     "timeIntegration.generalizedAlpha.spectralRadius, or exu.DynamicSolverType.TrapezoidalIndex2");
  }
  return doubts;
}

}  // namespace dalembert
