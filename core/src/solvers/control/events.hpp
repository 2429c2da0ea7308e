// Event functions: changes of sign within a step.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "dalembert/solvers/hooks.hpp"
#include "observers/dense_output.hpp"

namespace dalembert {

// The value of a user event function or of an item event.
struct WatchedValue : EventValue {
  bool holds = false;  // one-sided: the value must not be negative; a negative one makes the item switch
  double noise = 0;    // tolerance just after an event
};

// Values of event functions at the start of a step. After a change of sign, a function is ignored until it has left a
// dead band around zero.
class EventWatch {
 public:
  struct Event {
    int number;
    int direction;  // 1: rising, -1: falling
    double left;    // value just after the event
  };

  // Starts a solution.
  void begin(std::vector<WatchedValue> values);
  // Updates the values after a step without events.
  void go_on(const std::vector<WatchedValue>& values);
  // Updates the values after events and their actions.
  void events_over(const std::vector<WatchedValue>& values);
  // Returns the functions that have changed their sign since the start of the step, in the requested direction.
  std::vector<Event> changed(std::span<const WatchedValue> values) const;
  double at_start(int event) const { return start_[static_cast<std::size_t>(event)].value; }
  std::size_t count() const { return start_.size(); }
  bool just_after_event() const;
  // Counts events in close succession. Returns the number of a function with too many of them, or a negative number.
  int count_repeated(double time);

  // State for a restart file.
  static constexpr std::size_t numbers_per_function = 4;
  std::vector<double> numbers() const;
  void take_numbers(std::span<const double> numbers, const std::string& file);

  // Events at the end of the current step; empty if there are none.
  std::vector<Event> events;
  std::optional<std::size_t> users;  // number of user functions; item functions follow
  double regular_step_size = 0;  // step size after the event
  double unscheduled_step_size = 0;  // step size before a scheduled time has reduced it

 private:
  bool counts(int event, double value) const;
  std::vector<WatchedValue> start_;
  std::vector<double> dead_band_;  // half width; negative: the function is active
  std::vector<double> last_time_;  // time of the last event
  std::vector<int> in_a_row_;      // number of events, each within a regular step of the previous one
};

// Work space for event location.
struct EventLook {
  std::vector<WatchedValue> values, at_end;  // the last sample; the end of the step that was solved last
  State end;
  EventWatch seen;  // the watch after the step, if it is accepted
  StepInterpolation between;
};

}  // namespace dalembert
