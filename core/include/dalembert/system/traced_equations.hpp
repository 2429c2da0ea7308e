// The equations of a system as lists of operations: computations of `System` are recorded (math/traced.hpp).
#pragma once

#include <span>
#include <string>
#include <vector>

#include "dalembert/math/traced.hpp"
#include "dalembert/system/system.hpp"
#include "dalembert/system/term.hpp"

namespace dalembert {

// Variables of recorded equations; everything else is constant, including time.
struct TracedState {
  std::vector<Traced> q, v, a, lambda;
};

class TracedEquations {
 public:
  // Why they cannot be noted: a batch that cannot, functions of the user, coordinates of first order or history. Empty if they can.
  static std::string obstacle(const System& system);
  explicit TracedEquations(System& system);

  // Like the functions of System; the tangent reuses the residual of the same state if the conditions allow it.
  void residual(const TracedState& state, const Conditions& conditions, std::span<Traced> r);
  void tangent(const TracedState& state, const Conditions& conditions, const Weights& weights, const Pattern& pattern,
               std::span<Traced> values);

 private:
  TracedEvaluation evaluation(const TracedState& state, const Conditions& conditions);

  SystemParts& parts_;
  TracedPorts ports_;
  std::vector<Traced> total_;
};

}  // namespace dalembert
