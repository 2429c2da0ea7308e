#include "dalembert/solvers/locking_angles.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "dalembert/model/model.hpp"
#include "dalembert/output/numbers.hpp"

namespace dalembert {

namespace {

constexpr double close_to_lock = 0.2;  // rad, distance of the second angle from 90 degrees
constexpr double largest_turn = 0.3;   // rad, change of the other angles in a step
constexpr double no_turn = 1e-6;       // rad: motion about a single axis, or about two axes as in a gimbal
constexpr double at_lock = 1e-6;       // rad, accuracy of Newton's method at gimbal lock
constexpr std::size_t most_listed = 3;

// Position of the second angle: the nearest multiple of half a turn, and the distance from it.
struct Place {
  double half_turns, beside;
  explicit Place(double angle)
      : half_turns(std::nearbyint(angle / std::numbers::pi)), beside(std::abs(angle - half_turns * std::numbers::pi)) {}
  bool is_close_to_lock(double by = close_to_lock) const { return beside > std::numbers::pi / 2 - by; }
};
bool is_odd(double number) { return std::abs(std::remainder(number, 2)) > 0.5; }

const char* remedy_of(int node) {
  return node < 0 ? "solve the system that was given to RecogniseTrees, as Euler parameters do not lock"
                  : "turn the body by Euler parameters (exu.NodeType.RotationEulerParameters), which do not lock";
}

}  // namespace

void LockingAngles::begin(const System& system, const Model* model, const std::vector<LockingTurns>& turns) {
  *this = LockingAngles();
  model_ = model;
  turns_ = turns;
  if (model == nullptr) return;
  for (const LockingTurns& of_tree : turns) angles_.push_back({-1, of_tree.first});
  constexpr std::size_t translations = 3;
  const ItemType* last = nullptr;
  bool lock = false;
  for (int node = 0; node < model->count(ItemKind::node); ++node) {
    const ItemType* type = model->item(ItemKind::node, node).type;
    if (type != last) lock = provides(*type, "RotationRxyz");
    last = type;
    if (lock)
      angles_.push_back(
          {node, static_cast<std::size_t>(system.node_index(node, System::Coordinates::ode2)) + translations});
  }
}

std::string LockingAngles::text_of(const Angles& angles, double second_angle) const {
  const std::string what = angles.node < 0 ? std::ranges::find(turns_, angles.first, &LockingTurns::first)->joint +
                                                 " is three turns in its tree"
                                           : model_->describe(ItemKind::node, angles.node) + " turns by three angles";
  return what + ", which lock where the second is at 90 degrees; it came to " +
         format_number(second_angle * 180 / std::numbers::pi);
}

void LockingAngles::watch(System& system, const SolverIterationData& it) {
  const State &now = system.state(ConfigurationType::Current), &start = system.state(ConfigurationType::StartOfStep);
  const std::vector<double>& reference = system.state(ConfigurationType::Reference).q;
  const double h = now.time - start.time;
  const auto turn = [&](std::size_t k) {
    return std::max({std::abs(now.q[k] - start.q[k]), h * std::abs(now.v[k]), h * std::abs(start.v[k])});
  };
  for (const Angles& angles : angles_) {
    const std::size_t first = angles.first, second = first + 1, third = first + 2;
    const double angle = reference[second] + now.q[second];
    const Place place(angle), before(reference[second] + start.q[second]);
    const bool goes_beyond = is_odd(place.half_turns - before.half_turns);
    if (!goes_beyond && !place.is_close_to_lock() && !before.is_close_to_lock()) [[likely]]
      continue;
    // The motion near gimbal lock was missed if the second angle passes a quarter turn while the other ones move. Error
    // control resolves large rotations, but may step over the lock.
    const double turns = std::min(turn(first), turn(third));
    if (!(turns > (goes_beyond ? no_turn : largest_turn)) || (!goes_beyond && it.automaticStepSize)) continue;
    const auto known = std::ranges::find(locks_, first, &Lock::first);
    if (known == locks_.end())
      locks_.push_back({first, 1, it.currentTime, angle});
    else
      ++known->steps;
  }
}

// A user who places a body at gimbal lock may know that it is in equilibrium, so only solutions that reach it are
// reported.
std::vector<std::string> LockingAngles::doubts_of_equilibrium(System& system) const {
  std::vector<std::string> doubts;
  const auto second_angle = [&](ConfigurationType at, std::size_t second) {
    return system.state(ConfigurationType::Reference).q[second] + system.state(at).q[second];
  };
  for (const Angles& angles : angles_) {
    const double angle = second_angle(ConfigurationType::Current, angles.first + 1);
    if (!Place(angle).is_close_to_lock(at_lock) ||
        Place(second_angle(ConfigurationType::Initial, angles.first + 1)).is_close_to_lock(at_lock))
      continue;
    doubts.push_back(
        text_of(angles, angle) +
        ", where forces on angles may be in equilibrium although those on the body are not: " + remedy_of(angles.node));
  }
  return doubts;
}

std::vector<std::string> LockingAngles::doubts(bool has_error_control) const {
  std::vector<std::string> doubts;
  const std::string steps =
      has_error_control ? "smaller tolerances" : "more steps there, error control (exu.DynamicSolverType.DOPRI5)";
  const std::size_t listed = std::min(locks_.size(), most_listed), others = locks_.size() - listed;
  for (const Lock& lock : std::span(locks_).first(listed)) {
    const auto angles = std::ranges::find(angles_, lock.first, &Angles::first);
    if (angles == angles_.end()) continue;  // the solution continues another model
    doubts.push_back(text_of(*angles, lock.second_angle) + " at time " + format_number(lock.time) + "; " +
                     std::to_string(lock.steps) + (lock.steps == 1 ? " step was" : " steps were") +
                     " too large for it: use " + steps + ", or " + remedy_of(angles->node));
    if (&lock == &locks_[listed - 1] && others > 0)
      doubts.back() += "; the same of " + std::to_string(others) + (others == 1 ? " other" : " others");
  }
  return doubts;
}

void LockingAngles::advise(System& system, std::vector<std::string>& advice) const {
  const State& last = system.state(ConfigurationType::Current);
  const std::vector<double>& reference = system.state(ConfigurationType::Reference).q;
  const std::size_t others = advice.size();
  for (const Angles& angles : angles_) {
    if (advice.size() == others + most_listed) break;
    const double angle = reference[angles.first + 1] + last.q[angles.first + 1];
    const auto known = std::ranges::find(locks_, angles.first, &Lock::first);
    if (known == locks_.end() && !Place(angle).is_close_to_lock()) continue;
    const std::string text = known != locks_.end()
                                 ? text_of(angles, known->second_angle) + " at time " + format_number(known->time)
                                 : text_of(angles, angle);
    advice.insert(advice.begin(), text + ": use smaller steps, or " + remedy_of(angles.node));
  }
}

void LockingAngles::add_numbers(std::vector<double>& numbers) const {
  for (const Lock& lock : locks_)
    numbers.insert(numbers.end(),
                   {static_cast<double>(lock.first), static_cast<double>(lock.steps), lock.time, lock.second_angle});
}

void LockingAngles::take_numbers(std::span<const double> numbers) {
  for (std::size_t i = 0; i + numbers_per_lock <= numbers.size(); i += numbers_per_lock)
    locks_.push_back(
        {static_cast<std::size_t>(numbers[i]), static_cast<StepCount>(numbers[i + 1]), numbers[i + 2], numbers[i + 3]});
}

}  // namespace dalembert
