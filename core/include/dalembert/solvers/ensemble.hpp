// Variations of one model, solved side by side: every thread has its own model, system and settings.
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

// Values of a parameter or setting in all variations, in the type of the member.
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

// Initial values of one vector of the state, for all variations in order.
struct VariedCoordinates {
  std::vector<double> State::* part = nullptr;
  std::vector<double> values;
};

struct Ensemble {
  int variations = 0;
  std::vector<VariedParameter> parameters = {};
  std::vector<VariedSetting> settings = {};
  std::vector<VariedCoordinates> coordinates = {};
  SimulationSettings simulation = {};
  std::function<std::unique_ptr<Solver>()> make_solver = {};
  std::vector<int> sensors = {};  // sensors whose final values are requested
  bool histories = false;    // request their values over time as well
  bool states = false;       // request the final state as well
  double timeout = -1;       // seconds for one variation; negative: no limit
};

struct VariationResult {
  bool solved = false;
  std::string alone;                   // reason for a separate solution instead of lanes; empty if there is none
  std::string message;                 // reason of the failure
  std::string warnings;                // warnings of its solver, one per line
  double time = 0;                     // final time
  std::vector<double> values;          // of the sensors in order; empty if not solved
  std::vector<SensorTable> histories;  // by sensor number, until the end or the failure
  State state;                         // at the end; empty if not requested or not solved
};

// Solves all variations of `model` on the given number of threads; results do not depend on this number, nor on the
// grouping. They start from `initial`, or from the values of the nodes if parameters of nodes vary. The caller waits
// and calls `poll` periodically; an exception of `poll` ends the work and is passed on.
std::vector<VariationResult> solve_ensemble(const Ensemble& ensemble, const Model& model, const State& initial,
                                            int threads, const std::function<void()>& poll);

}  // namespace dalembert
