// What happens around a solver: the user's functions, the console, the wish to stop, and where sensors' values go.
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

// A function of the state that makes an event where it changes its sign.
struct EventValue {
  double value;
  int direction;  // 1: only where it rises, -1: only where it falls, 0: both
};

// Three angles in a tree, one after the other, in the place of a ball joint: they lock where the second is a quarter turn.
struct LockingTurns {
  std::string joint;
  std::size_t first;  // the ODE2 coordinate of the first angle
};

struct SolverHooks {
  // False: stop after this step.
  std::function<bool(double time)> pre_step, post_step;
  // Error of the discontinuous iteration and recommended step size; negative: none.
  std::function<std::array<double, 2>(double time)> post_newton;
  std::function<void(double time, int newton_iteration, int discontinuous_iteration)> pre_newton_residual;
  // Of the current state; as many each time.
  std::function<std::vector<EventValue>(double time)> events;
  // At an event, with its number, and 1 if its function rises or -1 if it falls. False: stop.
  std::function<bool(double time, int event, int direction)> event_action;
  // The same of an object, with what happens to it; or of the part of a term that is no item, by its name.
  struct ItemEvent {
    int object;
    std::string part;
    const char* what;
    int direction;  // 1: it begins, or its function rises; -1: it ends, or its function falls; 0: one takes the place of another
  };
  std::function<bool(double time, const ItemEvent& event)> item_event_action;
  // Null: nothing acts at times that are known beforehand. Otherwise there is a pre_step, which may do nothing.
  std::shared_ptr<Schedule> schedule;
  std::vector<LockingTurns> locking_turns;
  // Entries to add to the system matrix, for the given weights of derivatives by q, v and ODE1 coordinates.
  std::function<std::vector<MatrixEntry>(double time, double q, double v, double y)> system_jacobian;
  // True once: the Jacobian has to be computed anew (mbs.systemData or user functions asked for it).
  std::function<bool()> jacobian_update_requested;

  std::function<void(std::string_view text)> print;
  std::function<void(std::string_view text)> warn;
  // Called every few milliseconds between steps and in long Newton loops; true: stop. May throw (Ctrl-C).
  std::function<bool()> interrupted;
  // Called every few milliseconds after completed steps, and when a frame of an animation is due. Who looks at multipliers does so by `look`.
  using Look = std::function<void(const std::function<void()>& take)>;
  std::function<void(bool record_image, const Look& look)> show;
  // Wait until the user continues (pauseAfterEachStep).
  std::function<void()> pause;

  double timeout = -1;  // seconds; negative: none

  // Whether the user has a say in single steps.
  bool take_part_in_steps() const {
    return pre_step || post_step || post_newton || events || pre_newton_residual || system_jacobian || jacobian_update_requested || show;
  }
};

}  // namespace dalembert
