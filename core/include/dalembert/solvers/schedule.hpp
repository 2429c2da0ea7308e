// What acts at times that it knows beforehand, such as controllers that sample: steps end there.
#pragma once

#include <span>
#include <vector>

#include "dalembert/system/state.hpp"

namespace dalembert {

class Schedule {
 public:
  virtual ~Schedule() = default;
  // A solution starts from this state; static ones are refused.
  virtual void begin(const State& state, bool is_static) = 0;
  // When it acts next, later than all that it has done.
  virtual double next() const = 0;
  // Does what is due in this state. Whether forces have jumped.
  virtual bool act(const State& state) = 0;
  // What it remembers, for a restart file.
  virtual std::vector<double> numbers() const = 0;
  virtual void take_numbers(std::span<const double> numbers) = 0;
};

}  // namespace dalembert
