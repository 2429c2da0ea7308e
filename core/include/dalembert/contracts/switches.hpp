// Items that switch: contact that opens or closes, friction that sticks or slides, stops. Their data coordinates
// define the state, which is valid until a function of the state changes its sign. Solvers may end a step there
// (EventControl::end_step), or detect it afterwards, by `update`.
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
// Works like `update`. `settle`, with the same arguments, replaces it in the discontinuous iteration, for gradual
// changes without an event.
struct SwitchesAndSettles {
  static constexpr bool has_switches = true, switches_by_update = true, settles = true;
};

}  // namespace dalembert
