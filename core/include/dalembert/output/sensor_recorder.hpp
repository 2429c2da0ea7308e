// Values of sensors over time: into files, one per sensor, and into memory.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "dalembert/output/output_file.hpp"
#include "dalembert/output/solution_file.hpp"
#include "dalembert/simulation_settings.hpp"
#include "dalembert/system/system.hpp"

namespace dalembert {

// Recording of one sensor of the model; one per sensor, in the order of their numbers.
struct SensorChannel {
  std::string file_name;
  bool write_to_file = true, store_internal = false;
  std::string measured;  // "Node number = 3"; "UserFunction"
  std::string variable;  // "Position"
  int frame_node = -1;  // floating frame in whose components the sensor's node has its values; -1: global
};

// Rows of time and values, one after the other.
struct SensorTable {
  int columns = 0;
  std::vector<double> values;
  int rows() const { return columns == 0 ? 0 : static_cast<int>(values.size()) / columns; }
};

// Columns of a sensor in a row of all sensors.
struct SensorColumns {
  int first = -1, count = 0;  // first < 0: the sensor is not stored
  bool framed = false;        // position and rotation of the floating frame follow, for traces in space
  static constexpr int frame = 12;
  int width() const { return count + (framed ? frame : 0); }
};

// Recorded values of sensors with storeInternal; owned by the main system, it outlives the solver. A row has the time
// and the values of all sensors, which are recorded together.
class SensorStorage {
 public:
  void clear() { chunks_.clear(); }
  // Rows that follow have these columns; `rows`: how many are expected.
  void begin(const std::vector<SensorColumns>& columns, std::size_t rows);
  void append(const std::vector<double>& row);
  SensorColumns columns(int sensor) const;  // columns in the last rows that contain the sensor
  SensorTable table(int sensor) const;
  SensorTable frames(
      int sensor) const;  // position and rotation of the floating frame, row by row; no columns: values are global

 private:
  struct Chunk {
    std::vector<SensorColumns> columns;  // indexed by sensor number
    std::size_t width = 0, rows = 0;  // rows: capacity
    std::vector<double> values;
  };
  std::vector<Chunk> chunks_;
};

class SensorRecorder {
 public:
  // Opens files and clears the storage, unless data is to be appended. `rows` is the expected maximum. With
  // `lengths`, by sensor, files continue at these lengths, without another header.
  void open(const SimulationSettings& settings, const std::vector<SensorChannel>& channels, SensorStorage* storage,
            double rows, std::span<const double> lengths = {});
  std::vector<double> lengths();
  bool active() const { return active_; }
  const std::vector<OutputFile>& files() const { return files_; }
  void write_headers(const RunDescription& run, System& system);
  void record(System& system, double time);
  void write_footer(const std::string& footer);
  void close();  // throws FileError when all are closed

 private:
  // Destination of the values of one sensor.
  struct Target {
    OutputFile* file = nullptr;
    bool stored = false;
  };
  void write(OutputFile& file, double time);
  void store(System& system, int sensor);

  std::vector<SensorChannel> channels_;
  std::vector<OutputFile> files_;
  std::vector<Target> targets_;
  std::vector<double> values_, row_;  // values of the current sensor or frame, and of all stored sensors
  SensorStorage* storage_ = nullptr;  // null: nothing is stored
  std::vector<SensorColumns> columns_;
  bool active_ = false, flush_ = false, headers_ = false, begun_ = false;
  int precision_ = 10;
  std::size_t rows_ = 0;
};

}  // namespace dalembert
