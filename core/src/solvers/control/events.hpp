// Events: steps that end where a user function changes its sign, where an item switches, or at a scheduled time.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "control/solver_part.hpp"
#include "dalembert/solvers/hooks.hpp"
#include "observers/dense_output.hpp"

namespace dalembert {

// The value of a user event function or of an item event.
struct WatchedValue : EventValue {
  bool holds =
      false;  // the item keeps its state while the value is not negative, and switches when it becomes negative
  double noise = 0;    // smaller values count as zero just after an event
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

// States and values that event location needs within a step.
struct EventLook {
  std::vector<WatchedValue> values, at_end;  // the last sample; the end of the step that was solved last
  State end;
  EventWatch seen;  // the watch after the step, if it is accepted
  StepInterpolation between;
};

class EventControl : public SolverPart {
 public:
  explicit EventControl(Solver& solver) : SolverPart(solver) {}

  void begin();  // a solution
  bool any() const { return watch_ != nullptr; }
  bool locates_switches() const { return iterates_without_ != System::Updates::all; }
  // Items whose switches are events are left out of discontinuous iterations.
  System::Updates iterates_without() const { return iterates_without_; }

  void end_as_scheduled();  // shortens a step to a scheduled time
  // Locates the first event in a solved step and ends the step just after it. Returns false if a repeated step fails.
  bool end_step();
  void switch_over();  // sets the states of all items at the end of a step
  bool reached() const;
  // Calls the user's actions at the end of a written step, and restarts from the resulting state.
  void act();
  std::string describe_switch(const Switch& at) const;

  std::vector<double> restart_numbers() const;
  void resume(std::span<const double> numbers, const std::string& file);

 private:
  const std::vector<WatchedValue>& event_values() { return event_values(switches_); }
  const std::vector<WatchedValue>& event_values(std::vector<Switch>& of_items);
  void warn_of_missing_switches(bool located);
  void settle_switches();  // switches items until all are consistent
  double look_into_step(double& before);
  bool solve_again(double step_size);
  void act_as_scheduled();  // calls scheduled actions
  bool step_was_cut() const;  // shortened so much for an event that its size says nothing about the next step
  bool let_user_act(int event, int direction);
  std::vector<double> gaps_and_rates();
  void end_velocities_against_constraints(bool keeps_positions);
  void warn_of_actions_against_constraints(int singular_row);
  void diagnose_chatter(int event);
  std::string describe_event(int event) const;

  std::unique_ptr<EventWatch> watch_;  // null without events
  std::unique_ptr<EventLook> look_;  // null without events
  std::vector<Switch> switches_;  // switches of items at the last evaluated state
  System::Updates iterates_without_ = System::Updates::all;
  bool warned_of_actions_ = false;
};

}  // namespace dalembert
