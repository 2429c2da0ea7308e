// Variations of one model, solved side by side: every thread has a model, a system and settings of its own.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "dalembert/model/model.hpp"
#include "dalembert/output/sensor_recorder.hpp"
#include "dalembert/simulation_settings.hpp"
#include "dalembert/solvers/solver.hpp"
#include "dalembert/system/state.hpp"

namespace dalembert {

// What one parameter or setting is in each variation, kept in the type of the member.
class VariedValues {
 public:
  virtual ~VariedValues() = default;
  virtual void keep(int variation, const void* member) = 0;
  virtual void write(int variation, void* member) const = 0;
};
std::unique_ptr<VariedValues> make_varied_values(Storage storage, int variations);

struct VariedParameter {
  ItemKind kind = ItemKind::node;
  int number = -1;
  const Row* row = nullptr;
  std::unique_ptr<VariedValues> values;
};

struct VariedSetting {
  std::size_t offset = 0;  // of the member in SimulationSettings
  std::unique_ptr<VariedValues> values;
};

// Initial values of one vector of the state, variation by variation.
struct VariedCoordinates {
  std::vector<double> State::*part = nullptr;
  std::vector<double> values;
};

struct Ensemble {
  int variations = 0;
  std::vector<VariedParameter> parameters = {};
  std::vector<VariedSetting> settings = {};
  std::vector<VariedCoordinates> coordinates = {};
  SimulationSettings simulation = {};
  std::function<std::unique_ptr<Solver>()> make_solver = {};
  std::vector<int> sensors = {};  // whose values at the end are wanted
  bool histories = false;    // their values over time as well
  bool states = false;       // and the state at the end
  double timeout = -1;       // seconds for one variation; negative: none
};

struct VariationResult {
  bool solved = false;
  std::string alone;                   // why it was not solved with others, in the lanes of registers; empty if it was
  std::string message;                 // why it was not solved
  std::string warnings;                // of its solver, one per line
  double time = 0;                     // that was reached
  std::vector<double> values;          // of the sensors, one after the other; empty if not solved
  std::vector<SensorTable> histories;  // by sensor number, until the end or the failure
  State state;                         // at the end; empty if not wanted or not solved
};

// Solves all variations of `model` on so many threads; results do not depend on how many, nor on what is side by side. They
// start from `initial`, or from the values of the nodes if parameters of nodes vary. The caller waits and calls `poll` now and
// then; what it throws ends the work and passes through.
std::vector<VariationResult> solve_ensemble(const Ensemble& ensemble, const Model& model, const State& initial, int threads,
                                            const std::function<void()>& poll);

}  // namespace dalembert
