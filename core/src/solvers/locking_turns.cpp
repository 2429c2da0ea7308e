// Three angles that stand for a ball joint, near where they lock: there, the first and the last turn against each other, the faster the closer,
// by up to half a turn while the second comes and goes. Steps that do not see this give wrong motions.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "dalembert/output/numbers.hpp"
#include "dalembert/solvers/solver.hpp"

namespace dalembert {

namespace {

constexpr double close_to_lock = 0.2;  // cosine of the second angle
constexpr double largest_turn = 0.3;   // rad, of the first one in a step
constexpr double no_turn = 1e-6;       // straight through: about one axis, as in a plane

std::string text_of(const LockingTurns& turns, double second_angle) {
  return turns.name + " is three turns in its tree, which lock where the second is at 90 degrees; it came to " +
         format_number(second_angle * 180 / std::numbers::pi);
}
const char* const remedy = "solve the system that was given to RecogniseTrees, as Euler parameters do not lock";

}  // namespace

void Solver::watch_locking_turns() {
  if (is_static()) return;
  const State &now = current(), &start = start_of_step();
  const std::vector<double>& reference = system_->state(ConfigurationType::Reference).q;
  const double h = now.time - start.time;
  for (const LockingTurns& turns : hooks().locking_turns) {
    const std::size_t first = turns.first, second = first + 1;
    const double angle = reference[second] + now.q[second], before = reference[second] + start.q[second],
                 turn = std::max({std::abs(now.q[first] - start.q[first]), h * std::abs(now.v[first]), h * std::abs(start.v[first])});
    // A second angle that goes beyond a quarter turn, while the first moves, has missed what happens there.
    const bool goes_beyond = std::cos(angle) * std::cos(before) < 0 && turn > no_turn,
               turns_far = std::min(std::abs(std::cos(angle)), std::abs(std::cos(before))) < close_to_lock && turn > largest_turn;
    // Error control has seen to it that what turns far does so rightly, but not what it has jumped over.
    if (!goes_beyond && (it.automaticStepSize || !turns_far)) continue;
    const auto known = std::ranges::find(locks_, turns.first, &Lock::first);
    if (known == locks_.end()) locks_.push_back({turns.first, 1, it.currentTime, angle});
    else ++known->steps;
  }
}

void Solver::doubt_locking_turns() {
  const std::string steps = it.automaticStepSize ? "smaller tolerances" : "more steps there, error control (exu.DynamicSolverType.DOPRI5)";
  for (const LockingTurns& turns : hooks().locking_turns) {
    const auto lock = std::ranges::find(locks_, turns.first, &Lock::first);
    if (lock == locks_.end()) continue;
    doubts_.push_back(text_of(turns, lock->second_angle) + " at time " + format_number(lock->time) + "; " + std::to_string(lock->steps) +
                      (lock->steps == 1 ? " step was" : " steps were") + " too large for it: use " + steps + ", or " + remedy);
    if (!verbose(1)) warn(doubts_.back());
  }
}

// What has been missed before, or may be what has failed now.
void Solver::advise_on_locking_turns() {
  const State& last = current();
  const std::vector<double>& reference = system_->state(ConfigurationType::Reference).q;
  std::vector<std::string>& advice = diagnosis_.advice;
  for (const LockingTurns& turns : hooks().locking_turns) {
    const double angle = reference[turns.first + 1] + last.q[turns.first + 1];
    const auto known = std::ranges::find(locks_, turns.first, &Lock::first);
    if (known == locks_.end() && std::abs(std::cos(angle)) > close_to_lock) continue;
    const std::string text = known != locks_.end() ? text_of(turns, known->second_angle) + " at time " + format_number(known->time) : text_of(turns, angle);
    advice.insert(advice.begin(), text + ": use smaller steps, or " + remedy);
  }
}

}  // namespace dalembert
