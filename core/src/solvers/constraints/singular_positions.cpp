// Mechanisms that pass singular positions, from which several motions are possible, such as that of a flat four-bar.
//
// Velocities determine the branch and do not jump. Accelerations and multipliers are noisy in a singular position, and the
// noise increases as steps become smaller. It dominates error estimates, and a step that ends exactly there has no unique
// continuation. Steps therefore remain large.
#include "constraints/singular_positions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "constraints/constraint_states.hpp"
#include "dalembert/solvers/constrained_motion.hpp"
#include "dalembert/system/large_vectors.hpp"
#include "diagnosis/diagnostics.hpp"

namespace dalembert {

namespace {

// Near a singular position, the strength of the weakest constraint decreases by more than `weaker_by`. If the motion starts
// in one, there is no reference value, and a fixed limit is used.
constexpr double weaker_by = 300, smallest_growth = 100, growth_beside_start = 1e4, singular_growth = 1e14;
constexpr double largest_relative_turn = 0.1;  // change of velocities in a step, relative to their size
constexpr double no_tolerance = 1e-30;  // of squared remainders
// Errors in units of the tolerances.
constexpr double most_noise = 1e4;
constexpr double not_to_be_trusted = 1000;

}  // namespace

// The inverse strength of the weakest constraint, by geometry alone: a constraint between light bodies is not weak. Zero if
// constraints are evidently independent, infinite in a singular position.
double SingularPositions::growth_of_multipliers(const State& state) {
  const Conditions conditions = at_level(conditions_, false);
  const ConstraintRank rank(system(), state, conditions,
                            constraint_metric(system(), state, conditions, 0, Inertia::lengths), no_tolerance);
  if (rank.count() > 0) return std::numeric_limits<double>::infinity();
  return rank.weakest() > 0 ? 1 / rank.weakest() : 0;
}

void SingularPositions::begin() {
  last_step_ = aside_step_ = -2;
  passing_steps_ = 0;
  warned_of_rest_ = warned_of_undecided_start_ = false;
}

void SingularPositions::resume(StepCount last_step, int passing_steps) {
  last_step_ = last_step;
  passing_steps_ = passing_steps;
}

void SingularPositions::compare_with(const State& state) {
  compared_with_ = sizes_.ae > 0 ? state : State();
  usual_growth_ = 0;
}

[[gnu::noinline]] bool SingularPositions::is_near() {
  if (sizes_.ae == 0 || solver_.constraint_rank().count() > 0) return false;
  if (usual_growth_ == 0) {
    const double growth = growth_of_multipliers(compared_with_);
    usual_growth_ = growth < singular_growth ? std::max(growth, smallest_growth) : growth_beside_start;
    compared_with_ = State();
  }
  return growth_of_multipliers(current()) > weaker_by * usual_growth_;
}

[[gnu::noinline]] bool SingularPositions::has_weak_constraints() {
  return sizes_.ae > 0 && growth_of_multipliers(current()) > weaker_by * smallest_growth;
}

[[gnu::noinline]] bool SingularPositions::passes(double error) {
  if (sizes_.ae == 0 || !(error <= most_noise)) return false;
  const State &now = current(), &start = start_of_step();
  double turn = 0, speed = 0;
  for (std::size_t i = 0; i < now.v.size(); ++i) {
    turn += (now.v[i] - start.v[i]) * (now.v[i] - start.v[i]);
    speed += start.v[i] * start.v[i];
  }
  const bool turns = !(turn <= largest_relative_turn * largest_relative_turn * speed);
  if ((turns && warned_of_rest_) || !is_near()) return false;
  if (turns) {
    warn_of_rest();
    return false;
  }
  count_step();
  if (error > not_to_be_trusted) ++it.stepsAboveTolerance;
  return true;
}

[[gnu::noinline]] bool SingularPositions::steps_aside() {
  constexpr int most_times = 6;
  if (std::exchange(aside_step_, it.currentStepIndex) != it.currentStepIndex) times_aside_ = 0;
  return times_aside_ < most_times && is_near() && ++times_aside_ > 0;
}

[[gnu::noinline]] bool SingularPositions::stays() {
  constexpr int most_steps = 1000;
  if (passing_steps_ < most_steps) return false;
  passing_steps_ = 0;
  report();
  return true;
}

void SingularPositions::report() { solver_.diagnostics_->diagnose(FailureReason::singular_position).advice = advice(); }

std::vector<std::string> SingularPositions::advice() const {
  std::vector<std::string> list = {
      "use larger steps, which lead beyond it: larger tolerances, or equal steps "
      "(timeIntegration.automaticStepSize=False)"};
  if (!solver_.keeps_positions())
    list.emplace_back(
        "keep the constraints of positions (exu.DynamicSolverType.GeneralizedAlpha): gaps blur where the mechanism can "
        "go");
  list.emplace_back(
      "where the motion starts there, start further from this position, or faster: forces that turn slow velocities "
      "within 1e-3 of the size "
      "of the model decide by round-off how it goes on");
  return list;
}

namespace {

// Limits of remainders of the rank, which are proportional to the distance from a singular position. Equations that are
// redundant at the smaller distance but not at the larger one are those of the position.
constexpr double close_to_position = 1e-3, away_from_position = 1e-2;
constexpr int most_equations = 1000;  // the diagnosis of larger models would take longer than the solution

}  // namespace

State SingularPositions::moved_along_velocities(const State& at, double part) {
  State moved = at;
  const double speed = relative_size(system(), at.v);
  if (!(speed > at_rest)) return moved;
  std::vector<double> step = at.v;
  const double factor = part / speed;
  for (double& x : step) x *= factor;
  move_positions(system(), step, moved.q);
  ConstrainedMotion motion;
  solver_.prepare(motion);
  const Conditions conditions = at_level(conditions_, false);
  motion.begin_step(system(), at, conditions);
  State projected = moved;
  const bool succeeds = motion.factorize(system(), moved, conditions) == LinearSolver::success &&
                        motion.project(system(), projected, conditions);
  return succeeds ? projected : moved;
}

std::vector<std::string> SingularPositions::items() {
  Conditions conditions = conditions_;
  conditions.rate_level = false;
  const auto rank_at = [&](const State& state) {
    return ConstraintRank(system(), state, conditions,
                          constraint_metric(system(), state, conditions, settings().redundantConstraints.momentLength),
                          close_to_position * close_to_position);
  };
  const ConstraintRank here = rank_at(current());
  if (here.count() == 0) return {};
  const State away = moved_along_velocities(current(), away_from_position);
  const ConstraintRank there = rank_at(away);
  system().reactions_are_known(here.equations());
  if (!(there.count() < here.count())) return {};
  // Items with the same number of redundant equations elsewhere are listed only if there are no others.
  const std::vector<ConstraintRank::Item> always = there.items(system());
  std::vector<std::string> more, all;
  for (const ConstraintRank::Item& item : here.items(system())) {
    const auto same = std::ranges::find(always, item.object, &ConstraintRank::Item::object);
    all.push_back(item.item + ": " + std::to_string(item.removable) + " of " + std::to_string(item.equations) +
                  " follow from others in this position");
    if (same == always.end() || same->removable < item.removable) more.push_back(all.back());
  }
  return more.empty() ? all : more;
}

[[gnu::noinline]] void SingularPositions::name_in_diagnosis() {
  const FailureReason reason = diagnosis_.reason;
  const bool may_be = reason == FailureReason::newton || reason == FailureReason::open_constraints ||
                      reason == FailureReason::error_control;
  if (is_static() || sizes_.ae == 0 || sizes_.ae > most_equations || !settings().redundantConstraints.treat) return;
  if (!may_be && reason != FailureReason::singular_position && reason != FailureReason::round_off) return;
  std::vector<std::string> named = items();
  if (named.empty()) return;
  shorten(named);
  diagnosis_.dependent = std::move(named);
  if (!may_be) return;
  diagnosis_.reason = FailureReason::singular_position;
  diagnosis_.advice = advice();
}

// Velocities that vanish do not determine the branch.
[[gnu::noinline]] void SingularPositions::warn_of_rest() {
  warned_of_rest_ = true;
  std::vector<std::string> named = sizes_.ae <= most_equations ? items() : std::vector<std::string>();
  system().reactions_are_known({});
  warn(name() +
       ": the motion comes nearly to rest beside a singular position, where the mechanism could go on in more ways "
       "than one" +
       solver_.position_text() +
       "; which one it takes may follow from errors within the tolerances. Compare with smaller ones, or with equal "
       "steps of half the size" +
       (named.empty() ? "" : ":" + indented(std::move(named))));
}

[[gnu::noinline]] void SingularPositions::warn_of_undecided_start() {
  if (std::exchange(warned_of_undecided_start_, true)) return;
  warn(name() +
       ": the motion starts in a singular position, where the mechanism could go on in more ways than one; "
       "the velocities do not decide which. Accelerations and reactions at the start follow the velocities, or are the "
       "smallest that constraints allow. Start a little beside this position, or with smaller forces and stiffness");
}

[[gnu::noinline]] void SingularPositions::count_step() {
  const StepCount last = std::exchange(last_step_, it.currentStepIndex);
  if (last == it.currentStepIndex) return;
  constexpr StepCount few = 10;
  passing_steps_ = last + few < it.currentStepIndex ? 1 : passing_steps_ + 1;
  ++it.singularPositionSteps;
  if (verbose(1) && last + 1 != it.currentStepIndex)
    say(1, "  passing a singular position, where the mechanism could go on in more ways than one" +
               solver_.position_text() + "\n");
}

}  // namespace dalembert
