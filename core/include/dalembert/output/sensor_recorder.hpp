// Values of sensors over time: into files, one per sensor, and into memory.
#pragma once

#include <string>
#include <vector>

#include "dalembert/output/output_file.hpp"
#include "dalembert/output/solution_file.hpp"
#include "dalembert/simulation_settings.hpp"
#include "dalembert/system/system.hpp"

namespace dalembert {

// How one sensor of the model is recorded; one per sensor, in the order of their numbers.
struct SensorChannel {
  std::string file_name;
  bool write_to_file = true, store_internal = false;
  std::string measured;  // "Node number = 3"; "UserFunction"
  std::string variable;  // "Position"
};

// Rows of time and values, one after the other.
struct SensorTable {
  int columns = 0;
  std::vector<double> values;
  int rows() const { return columns == 0 ? 0 : static_cast<int>(values.size()) / columns; }
};

// What sensors with storeInternal have recorded; belongs to the main system and outlives the solver.
struct SensorStorage {
  std::vector<SensorTable> tables;  // by sensor number
};

class SensorRecorder {
 public:
  // Opens files and empties the storage, both unless data is to be appended. `rows`: how many are expected at most.
  void open(const SimulationSettings& settings, const std::vector<SensorChannel>& channels, SensorStorage* storage,
            double rows);
  bool active() const { return active_; }
  void write_headers(const RunDescription& run, System& system);
  void record(System& system, double time);
  void write_footer(const std::string& footer);
  void close();

 private:
  // Where the values of one sensor go; null: not there.
  struct Target {
    OutputFile* file = nullptr;
    SensorTable* table = nullptr;
  };
  void write(OutputFile& file, double time);
  void store(SensorTable& table, int sensor, double time);

  std::vector<SensorChannel> channels_;
  std::vector<OutputFile> files_;
  std::vector<Target> targets_;
  std::vector<double> values_;  // of the sensor being recorded
  bool active_ = false, flush_ = false, headers_ = false;
  int precision_ = 10;
  std::size_t rows_ = 0;
};

}  // namespace dalembert
