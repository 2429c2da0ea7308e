// Detects contacts and stops that bodies leave faster than they came, because a contact lasts for a few steps only: the
// solver adds energy.
//
// The relative velocity along the normal does not increase in a passive contact between bodies without other forces.
// Other forces have little effect in a contact of a few steps. If they matter, such as a spring that presses a body
// against a stop, the approach is slow or the contact is long.
#include <algorithm>
#include <cmath>
#include <string_view>

#include "dalembert/output/numbers.hpp"
#include "dalembert/solvers/solver.hpp"

namespace dalembert {

namespace rebounds {

constexpr StepCount few_steps = 6;       // duration of a contact
constexpr double noticeable_gain = 1.05; // ratio of velocities over all contacts since the velocity was smallest
constexpr double probe = 1e-4;           // part of a step, for finite differences
constexpr std::size_t most_told = 3;

static bool is_contact(const Switch& at) {
  const std::string_view what = at.what;
  return at.owner == nullptr && (what == "contact" || what == "stop");
}
// Returns the gap; it is negative if bodies overlap.
static double gap(const Switch& at) { return at.direction > 0 ? at.value : -at.value; }
static bool is_open(const Switch& at) { return at.direction > 0; }

}  // namespace rebounds

// Called after steps in which an item has switched. Velocities are those before the step that closes the contact, and
// after the step that opens it.
[[gnu::noinline]] void Solver::watch_rebounds() {
  std::vector<Switch> before, after;
  system_->find_switches(start_of_step(), conditions_, before);
  system_->find_switches(current(), conditions_, after);
  rebounds_.resize(std::max(rebounds_.size(), after.size()));
  const auto switched = [&](std::size_t i) { return rebounds::is_contact(after[i]) && rebounds::is_contact(before[i]) && rebounds::is_open(before[i]) != rebounds::is_open(after[i]); };
  std::vector<Switch> moved_before, moved_after;
  const auto rate = [&](const State& at, const std::vector<Switch>& switches, std::vector<Switch>& moved, std::size_t i) {
    const double time = rebounds::probe * conditions_.step_size;
    if (moved.empty()) {
      State next = at;
      std::vector<double> own(at.v.size());
      for (std::size_t k = 0; k < own.size(); ++k) own[k] = time * at.v[k], next.q[k] += own[k];
      if (system_->has_lie_nodes()) system_->compose(at.q, own, next.q);
      system_->find_switches(next, conditions_, moved);
    }
    return (rebounds::gap(moved[i]) - rebounds::gap(switches[i])) / time;
  };
  for (std::size_t i = 0; i < after.size(); ++i) {
    if (!switched(i)) continue;
    Rebound& rebound = rebounds_[i];
    if (rebounds::is_open(before[i])) {
      rebound.closed_at = it.currentStepIndex;
      rebound.approach = -rate(start_of_step(), before, moved_before, i);
      continue;
    }
    const StepCount steps = it.currentStepIndex - rebound.closed_at;
    const double leaves = rate(current(), after, moved_after, i), comes = rebound.approach;
    if (rebound.closed_at < 0 || steps > rebounds::few_steps || !(comes > 0 && leaves > 0)) continue;
    rebound.growth = std::max(0.0, rebound.growth + std::log(leaves / comes));
    if (rebound.growth <= rebound.largest) continue;
    rebound.largest = rebound.growth;
    rebound.steps = steps;
    rebound.time = it.currentTime;
    rebound.what = after[i];
  }
}

void Solver::doubt_rebounds() {
  std::size_t told = 0;
  for (const Rebound& rebound : rebounds_) {
    if (rebound.largest < std::log(rebounds::noticeable_gain) || told++ >= rebounds::most_told) continue;
    doubts_.push_back(describe_switch(rebound.what) + ": bodies leave contact " + format_number(std::exp(rebound.largest), 3) +
                      " times as fast as they came, at time " + format_number(rebound.time, 4) + " after " + std::to_string(std::max<StepCount>(rebound.steps, 1)) +
                      (rebound.steps > 1 ? " steps" : " step") + " in contact: steps are too large for its stiffness and add energy. Use more than " +
                      std::to_string(rebounds::few_steps) + " steps per contact, or simulationSettings.events.ofItems=True");
    if (!verbose(1)) warn(doubts_.back());
  }
}

}  // namespace dalembert
