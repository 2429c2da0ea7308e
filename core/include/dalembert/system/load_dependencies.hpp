// Loads whose user functions read coordinates: their contribution to the tangent.
#pragma once

#include <memory>
#include <vector>

#include "dalembert/system/term.hpp"

namespace dalembert {

class Model;
class Pattern;
class System;
struct SystemParts;

struct LoadDependency {
  int load = -1;
  std::unique_ptr<Term> term;  // number of the load
  std::vector<int> rows, columns;   // ODE2 coordinates that it acts on, and that its value depends on
  std::vector<int> slots;  // slots of the block, by rows; empty: not in the tangent
};

// A load with a user function depends on the coordinates on which it acts, until further ones are added.
void make_load_dependencies(SystemParts& parts, const Model& model);
// Takes over changed parameters of a load, which may have got a user function.
void refresh_load_dependency(SystemParts& parts, int load);

// No slots: the pattern is older than the dependency and lacks some of its entries.
void find_slots(LoadDependency& dependency, const Pattern& pattern);

// Adds the derivative of the loads' values, with fixed frames of their markers, to the tangent. It uses finite
// differences of user functions, which read the current state; derivatives with respect to velocities are optional.
void add_load_dependencies(System& system, SystemParts& parts, Evaluation evaluation, const Weights& weights,
                           bool by_velocities, double* values);

}  // namespace dalembert
