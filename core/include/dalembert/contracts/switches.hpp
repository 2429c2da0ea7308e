// Items that switch: contact that opens or closes, friction that sticks or slides, stops. Their data coordinates tell what they do, until a
// function of the state says that it is over. Solvers may end a step there (Solver::end_with_event), or find it afterwards, by `update`.
#pragma once

#include "dalembert/contracts/context.hpp"
#include "dalembert/system/term.hpp"

namespace dalembert {

struct NoSwitches {
  static constexpr bool has_switches = false, switches_by_update = true, settles = false;
};
// `update`, called where a function has become negative, switches.
struct SwitchesByUpdate {
  static constexpr bool has_switches = true, switches_by_update = true, settles = false;
};
// `switch_over` does, of the same arguments.
struct SwitchesByItself {
  static constexpr bool has_switches = true, switches_by_update = false, settles = false;
};
// As by `update`; `settle`, of the same arguments, takes its place in the discontinuous iteration, for what changes at no place of its own.
struct SwitchesAndSettles {
  static constexpr bool has_switches = true, switches_by_update = true, settles = true;
};

}  // namespace dalembert
