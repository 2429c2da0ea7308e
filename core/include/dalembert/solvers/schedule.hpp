// Scheduled actions, such as those of sampled controllers: steps end at their times.
#pragma once

#include <span>
#include <vector>

#include "dalembert/system/state.hpp"

namespace dalembert {

class Schedule {
 public:
  virtual ~Schedule() = default;
  // Starts a solution from this state; static solutions are rejected.
  virtual void begin(const State& state, bool is_static) = 0;
  // Returns the time of the next action, after all completed ones.
  virtual double next() const = 0;
  // Executes the action that is due in this state, and returns whether forces have jumped.
  virtual bool act(const State& state) = 0;
  // Returns its memory, for a restart file.
  virtual std::vector<double> numbers() const = 0;
  virtual void take_numbers(std::span<const double> numbers) = 0;
};

}  // namespace dalembert
