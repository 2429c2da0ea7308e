// Interfaces of a solver to its surroundings: user functions, console, interrupts, and destinations of sensor values.
// Empty functions cost one test.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "dalembert/solvers/schedule.hpp"

namespace dalembert {

struct MatrixEntry {
  int row, column;
  double value;
};

// The value of an event function; a change of sign is an event.
struct EventValue {
  double value;
  int direction;  // 1: only if it rises, -1: only if it falls, 0: both
};

// Three successive angles of a tree that replace a ball joint. Gimbal lock occurs at a quarter turn of the second one.
struct LockingTurns {
  std::string joint;
  std::size_t first;  // the ODE2 coordinate of the first angle
};

struct SolverHooks {
  // Returning false stops the solver after this step.
  std::function<bool(double time)> pre_step, post_step;
  // Returns the error of the discontinuous iteration and the recommended step size; negative: none.
  std::function<std::array<double, 2>(double time)> post_newton;
  std::function<void(double time, int newton_iteration, int discontinuous_iteration)> pre_newton_residual;
  // Returns the event values of the current state; their number is constant.
  std::function<std::vector<EventValue>(double time)> events;
  // Called at an event, with its number, and 1 if its function rises or -1 if it falls. Returning false stops the
  // solver.
  std::function<bool(double time, int event, int direction)> event_action;
  // An event of an object, with its kind; or of a named part of a term that is not an item.
  struct ItemEvent {
    int object;
    std::string part;
    const char* what;
    int direction;  // 1: it begins, or its function rises; -1: it ends, or its function falls; 0: a replacement
  };
  std::function<bool(double time, const ItemEvent& event)> item_event_action;
  // Scheduled actions, or null. There is a pre_step function with a schedule; it may be empty.
  std::shared_ptr<Schedule> schedule;
  std::vector<LockingTurns> locking_turns;
  // Returns entries that are added to the system matrix, for the given weights of derivatives by q, v and ODE1
  // coordinates.
  std::function<std::vector<MatrixEntry>(double time, double q, double v, double y)> system_jacobian;
  // Returns true once if the Jacobian has to be updated, as requested by mbs.systemData or user functions.
  std::function<bool()> jacobian_update_requested;

  std::function<void(std::string_view text)> print;
  std::function<void(std::string_view text)> warn;
  // Called every few milliseconds between steps and in long Newton loops; true: stop. May raise (Ctrl-C).
  std::function<bool()> interrupted;
  // Called every few milliseconds after completed steps, and when a frame of an animation is due. Readers of
  // multipliers use `look`.
  using Look = std::function<void(const std::function<void()>& take)>;
  std::function<void(bool record_image, const Look& look)> show;
  // Waits until the user continues (pauseAfterEachStep).
  std::function<void()> pause;

  double timeout = -1;  // seconds; negative: no limit

  // Returns whether user functions take part in single steps.
  bool take_part_in_steps() const {
    return pre_step || post_step || post_newton || events || pre_newton_residual || system_jacobian ||
           jacobian_update_requested || show;
  }
};

}  // namespace dalembert
