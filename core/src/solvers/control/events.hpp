// Where functions of the state change their sign within a step.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "dalembert/solvers/hooks.hpp"
#include "observers/dense_output.hpp"

namespace dalembert {

// Of a function of the user, or of an item.
struct WatchedValue : EventValue {
  bool holds = false;  // it must not be negative: where it is, its item has to switch
  double noise = 0;    // just after an event
};

// What is known of event functions at the start of a step. A function that has just changed its sign is watched again when it has left
// zero.
class EventWatch {
 public:
  struct Event {
    int number;
    int direction;  // 1: the function rises
    double left;    // its value there, beyond zero
  };

  // At the start of a solution.
  void begin(std::vector<WatchedValue> values);
  // After a step without events.
  void go_on(const std::vector<WatchedValue>& values);
  // After events and what they have changed.
  void events_over(const std::vector<WatchedValue>& values);
  // Those that have changed their sign since the start of the step, the wanted way.
  std::vector<Event> changed(std::span<const WatchedValue> values) const;
  double at_start(int event) const { return start_[static_cast<std::size_t>(event)].value; }
  std::size_t count() const { return start_.size(); }
  bool just_after_event() const;
  // Counts those that follow each other closely, and returns the one that has done so too often; negative: none has.
  int count_repeated(double time);

  // The state for a restart file.
  static constexpr std::size_t numbers_per_function = 4;
  std::vector<double> numbers() const;
  void take_numbers(std::span<const double> numbers, const std::string& file);

  // Of the step that ends with them; empty: it ends with none.
  std::vector<Event> events;
  std::optional<std::size_t> users;  // so many of the functions are of the user; the others are of items
  double regular_step_size = 0;  // to go on with
  double unscheduled_step_size = 0;  // of steps that a schedule has made shorter

 private:
  bool counts(int event, double value) const;
  std::vector<WatchedValue> start_;
  std::vector<double> dead_band_;  // negative: the function is watched
  std::vector<double> last_time_;  // of its last event
  std::vector<int> in_a_row_;      // of its events, each within a regular step of the one before
};

// Memory for looks into steps.
struct EventLook {
  std::vector<WatchedValue> values, at_end;  // of the last look; at the end of the step that was solved last
  State end;
  EventWatch seen;  // what would be known after the step
  StepInterpolation between;
};

}  // namespace dalembert
