// Gimbal lock of three angles: at 90 degrees of the second angle, the axes of the first and third rotation coincide.
// Close to it, both angles rotate by up to half a turn in opposite directions within a short time. Steps that are too
// large for this produce wrong motions. Torques about the lost direction do no work on the angles, so that these may be
// in equilibrium although the body is not.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "dalembert/model/model.hpp"
#include "dalembert/output/numbers.hpp"
#include "dalembert/solvers/solver.hpp"

namespace dalembert {

namespace {

constexpr double close_to_lock = 0.2;  // rad, distance of the second angle from 90 degrees
constexpr double largest_turn = 0.3;   // rad, change of the other angles in a step
constexpr double no_turn = 1e-6;       // rad: motion about a single axis, or about two axes as in a gimbal
constexpr double at_lock = 1e-6;       // rad, accuracy of Newton's method at gimbal lock
constexpr std::size_t most_told = 3;

// Position of the second angle: the nearest multiple of half a turn, and the distance from it.
struct Place {
  double half_turns, beside;
  explicit Place(double angle) : half_turns(std::nearbyint(angle / std::numbers::pi)), beside(std::abs(angle - half_turns * std::numbers::pi)) {}
  bool is_close_to_lock(double by = close_to_lock) const { return beside > std::numbers::pi / 2 - by; }
};
bool is_odd(double number) { return std::abs(std::remainder(number, 2)) > 0.5; }

const char* remedy_of(int node) {
  return node < 0 ? "solve the system that was given to RecogniseTrees, as Euler parameters do not lock"
                  : "turn the body by Euler parameters (exu.NodeType.RotationEulerParameters), which do not lock";
}

}  // namespace

void Solver::find_angles() {
  angles_.clear();
  const Model* model = environment_->model;
  if (model == nullptr) return;
  for (const LockingTurns& turns : hooks().locking_turns) angles_.push_back({-1, turns.first});
  constexpr std::size_t translations = 3;
  const ItemType* last = nullptr;
  bool lock = false;
  for (int node = 0; node < model->count(ItemKind::node); ++node) {
    const ItemType* type = model->item(ItemKind::node, node).type;
    if (type != last) lock = provides(*type, "RotationRxyz");
    last = type;
    if (lock) angles_.push_back({node, static_cast<std::size_t>(system_->node_index(node, System::Coordinates::ode2)) + translations});
  }
}

std::string Solver::text_of(const Angles& angles, double second_angle) const {
  const std::string what = angles.node < 0 ? std::ranges::find(hooks().locking_turns, angles.first, &LockingTurns::first)->joint + " is three turns in its tree"
                                           : environment_->model->describe(ItemKind::node, angles.node) + " turns by three angles";
  return what + ", which lock where the second is at 90 degrees; it came to " + format_number(second_angle * 180 / std::numbers::pi);
}

void Solver::watch_angles() {
  if (is_static()) return;
  const State &now = current(), &start = start_of_step();
  const std::vector<double>& reference = system_->state(ConfigurationType::Reference).q;
  const double h = now.time - start.time;
  const auto turn = [&](std::size_t k) { return std::max({std::abs(now.q[k] - start.q[k]), h * std::abs(now.v[k]), h * std::abs(start.v[k])}); };
  for (const Angles& angles : angles_) {
    const std::size_t first = angles.first, second = first + 1, third = first + 2;
    const double angle = reference[second] + now.q[second];
    const Place place(angle), before(reference[second] + start.q[second]);
    const bool goes_beyond = is_odd(place.half_turns - before.half_turns);
    if (!goes_beyond && !place.is_close_to_lock() && !before.is_close_to_lock()) [[likely]] continue;
    // The motion near gimbal lock was missed if the second angle passes a quarter turn while the other ones move. Error
    // control resolves large rotations, but may step over the lock.
    const double turns = std::min(turn(first), turn(third));
    if (!(turns > (goes_beyond ? no_turn : largest_turn)) || (!goes_beyond && it.automaticStepSize)) continue;
    const auto known = std::ranges::find(locks_, first, &Lock::first);
    if (known == locks_.end()) locks_.push_back({first, 1, it.currentTime, angle});
    else ++known->steps;
  }
}

// A user who places a body at gimbal lock may know that it is in equilibrium, so only solutions that reach it are
// reported.
void Solver::doubt_equilibrium_of_angles() {
  const std::vector<double>& reference = system_->state(ConfigurationType::Reference).q;
  for (const Angles& angles : angles_) {
    const std::size_t second = angles.first + 1;
    const double angle = reference[second] + current().q[second];
    if (!Place(angle).is_close_to_lock(at_lock) || Place(reference[second] + initial().q[second]).is_close_to_lock(at_lock)) continue;
    doubts_.push_back(text_of(angles, angle) + ", where forces on angles may be in equilibrium although those on the body are not: " + remedy_of(angles.node));
    if (!verbose(1)) warn(doubts_.back());
  }
}

void Solver::doubt_angles() {
  if (is_static()) return doubt_equilibrium_of_angles();
  const std::string steps = it.automaticStepSize ? "smaller tolerances" : "more steps there, error control (exu.DynamicSolverType.DOPRI5)";
  const std::size_t told = std::min(locks_.size(), most_told), others = locks_.size() - told;
  for (const Lock& lock : std::span(locks_).first(told)) {
    const auto angles = std::ranges::find(angles_, lock.first, &Angles::first);
    if (angles == angles_.end()) continue;  // the solution continues another model
    doubts_.push_back(text_of(*angles, lock.second_angle) + " at time " + format_number(lock.time) + "; " + std::to_string(lock.steps) +
                      (lock.steps == 1 ? " step was" : " steps were") + " too large for it: use " + steps + ", or " + remedy_of(angles->node));
    if (&lock == &locks_[told - 1] && others > 0) doubts_.back() += "; the same of " + std::to_string(others) + (others == 1 ? " other" : " others");
    if (!verbose(1)) warn(doubts_.back());
  }
}

// Adds advice on gimbal lock, found earlier or at the time of the failure.
[[gnu::noinline]] void Solver::advise_on_angles() {
  const State& last = current();
  const std::vector<double>& reference = system_->state(ConfigurationType::Reference).q;
  std::vector<std::string>& advice = diagnosis_.advice;
  const std::size_t others = advice.size();
  for (const Angles& angles : angles_) {
    if (advice.size() == others + most_told) break;
    const double angle = reference[angles.first + 1] + last.q[angles.first + 1];
    const auto known = std::ranges::find(locks_, angles.first, &Lock::first);
    if (known == locks_.end() && !Place(angle).is_close_to_lock()) continue;
    const std::string text = known != locks_.end() ? text_of(angles, known->second_angle) + " at time " + format_number(known->time) : text_of(angles, angle);
    advice.insert(advice.begin(), text + ": use smaller steps, or " + remedy_of(angles.node));
  }
}

}  // namespace dalembert
