// Contacts and stops that bodies leave faster than they came, because a contact lasts for a few steps only: the solver
// adds energy.
//
// The relative velocity along the normal does not increase in a passive contact between bodies without other forces.
// Other forces have little effect in a contact of a few steps. If they matter, such as a spring that presses a body
// against a stop, the approach is slow or the contact is long.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "dalembert/solvers/data.hpp"
#include "dalembert/system/system.hpp"

namespace dalembert {

class Rebounds {
 public:
  // Called after steps in which an item has switched. Velocities are those before the step that closes the contact, and
  // after the step that opens it.
  void watch(System& system, const Conditions& conditions, const SolverIterationData& it);
  // `describe` returns the name of a switch.
  std::vector<std::string> doubts(const std::function<std::string(const Switch&)>& describe) const;

 private:
  struct Rebound {
    StepCount closed_at = -1, steps = 0;  // number of steps in contact at the largest growth
    double approach = 0;                  // velocity before the contact closed
    double growth = 0, largest = 0;       // logarithm of the ratio of velocities after and before
    double time = 0;
    Switch what{""};
  };
  std::vector<Switch> before_, after_;  // memory of the last step
  std::vector<Rebound> rebounds_;  // by switch of items
};

}  // namespace dalembert
