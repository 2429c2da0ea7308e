// Where functions of the state change their sign within a step.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "dalembert/solvers/hooks.hpp"

namespace dalembert {

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
  void begin(std::vector<EventValue> values);
  // After a step without events.
  void go_on(const std::vector<EventValue>& values);
  // After events and what they have changed.
  void events_over(const std::vector<EventValue>& values);
  // Those that have changed their sign since the start of the step, the wanted way.
  std::vector<Event> changed(std::span<const EventValue> values) const;
  double at_start(int event) const { return start_[static_cast<std::size_t>(event)].value; }
  void require_as_many(std::size_t count) const;
  std::size_t count() const { return start_.size(); }
  bool just_after_event() const;

  // The state for a restart file.
  std::vector<double> numbers() const;
  void take_numbers(std::span<const double> numbers);

  // Of the step that ends with them; empty: it ends with none.
  std::vector<Event> events;
  double regular_step_size = 0;  // to go on with
  double last_time = 0;          // of the last event
  int in_a_row = 0;              // events that followed each other within a regular step
  double unscheduled_step_size = 0;  // of steps that a schedule has made shorter

 private:
  bool counts(int event, double value) const;
  std::vector<EventValue> start_;
  std::vector<double> dead_band_;  // negative: the function is watched
};

}  // namespace dalembert
