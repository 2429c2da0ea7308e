// The unknowns of a system, and the configurations in which it keeps them.
#pragma once

#include <array>
#include <vector>

#include "dalembert/enums.hpp"

namespace dalembert {

// Static solvers keep Lagrange multipliers with the opposite sign; of values that a user has set, the sign is not known.
enum class MultiplierSign : unsigned char { motion, statics, unknown };

// ODE2 coordinates count from the reference configuration: total = reference + q.
struct State {
  std::vector<double> q, v, a;  // ODE2: displacements, velocities, accelerations
  std::vector<double> y, y_t;   // ODE1
  std::vector<double> lambda;   // algebraic: Lagrange multipliers
  std::vector<double> data;     // history: friction, contact, ...
  double time = 0;
  MultiplierSign sign = MultiplierSign::motion;  // of lambda
  bool waits = false;  // not used since assembly: its vectors are not yet allocated
};

// By configuration, including the initial one: pending changes start with the initial values.
inline State& state_of(State* states, ConfigurationType configuration) {
  State& state = states[static_cast<std::size_t>(configuration)];
  if (state.waits) [[unlikely]]
    state = states[static_cast<std::size_t>(ConfigurationType::Initial)];
  return state;
}

struct Sizes {
  int ode2 = 0, ode1 = 0, ae = 0, data = 0;
  int total() const { return ode2 + ode1 + ae; }      // unknowns of an implicit step: [ODE2, ODE1, AE]
  int first_ae() const { return ode2 + ode1; }
};

}  // namespace dalembert
