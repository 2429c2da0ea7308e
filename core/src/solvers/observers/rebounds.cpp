#include "dalembert/solvers/rebounds.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "dalembert/output/numbers.hpp"

namespace dalembert {

namespace {

constexpr StepCount few_steps_in_contact = 6;       // duration of a contact
constexpr double noticeable_gain = 1.05; // ratio of velocities over all contacts since the velocity was smallest
constexpr double part_of_step = 1e-4;           // part of a step, for finite differences
constexpr std::size_t most_rebounds = 3;

bool is_contact(const Switch& at) {
  const std::string_view what = at.what;
  return at.owner == nullptr && (what == "contact" || what == "stop");
}
// Returns the gap; it is negative if bodies overlap.
double gap(const Switch& at) { return at.direction > 0 ? at.value : -at.value; }
bool is_open(const Switch& at) { return at.direction > 0; }

}  // namespace

[[gnu::noinline]] void Rebounds::watch(System& system, const Conditions& conditions, const SolverIterationData& it) {
  const State &start = system.state(ConfigurationType::StartOfStep), &now = system.state(ConfigurationType::Current);
  std::vector<Switch>&before = before_, &after = after_;
  before.clear();
  after.clear();
  system.find_switches(start, conditions, before);
  system.find_switches(now, conditions, after);
  rebounds_.resize(std::max(rebounds_.size(), after.size()));
  const auto switched = [&](std::size_t i) {
    return is_contact(after[i]) && is_contact(before[i]) && is_open(before[i]) != is_open(after[i]);
  };
  std::vector<Switch> moved_before, moved_after;
  const auto rate = [&](const State& at, const std::vector<Switch>& switches, std::vector<Switch>& moved,
                        std::size_t i) {
    const double time = part_of_step * conditions.step_size;
    if (moved.empty()) {
      State next = at;
      std::vector<double> own(at.v.size());
      for (std::size_t k = 0; k < own.size(); ++k) own[k] = time * at.v[k], next.q[k] += own[k];
      if (system.has_lie_nodes()) system.compose(at.q, own, next.q);
      system.find_switches(next, conditions, moved);
    }
    return (gap(moved[i]) - gap(switches[i])) / time;
  };
  for (std::size_t i = 0; i < after.size(); ++i) {
    if (!switched(i)) continue;
    Rebound& rebound = rebounds_[i];
    if (is_open(before[i])) {
      rebound.closed_at = it.currentStepIndex;
      rebound.approach = -rate(start, before, moved_before, i);
      continue;
    }
    const StepCount steps = it.currentStepIndex - rebound.closed_at;
    const double leaves = rate(now, after, moved_after, i), comes = rebound.approach;
    if (rebound.closed_at < 0 || steps > few_steps_in_contact || !(comes > 0 && leaves > 0)) continue;
    rebound.growth = std::max(0.0, rebound.growth + std::log(leaves / comes));
    if (rebound.growth <= rebound.largest) continue;
    rebound.largest = rebound.growth;
    rebound.steps = steps;
    rebound.time = it.currentTime;
    rebound.what = after[i];
  }
}

std::vector<std::string> Rebounds::doubts(const std::function<std::string(const Switch&)>& describe) const {
  std::vector<std::string> doubts;
  std::size_t listed = 0;
  for (const Rebound& rebound : rebounds_) {
    if (rebound.largest < std::log(noticeable_gain) || listed++ >= most_rebounds) continue;
    doubts.push_back(describe(rebound.what) + ": bodies leave contact " + format_number(std::exp(rebound.largest), 3) +
                     " times as fast as they came, at time " + format_number(rebound.time, 4) + " after " +
                     std::to_string(std::max<StepCount>(rebound.steps, 1)) + (rebound.steps > 1 ? " steps" : " step") +
                     " in contact: steps are too large for its stiffness and add energy. Use more than " +
                     std::to_string(few_steps_in_contact) +
                     " steps per contact, or simulationSettings.events.ofItems=True");
  }
  return doubts;
}

}  // namespace dalembert
