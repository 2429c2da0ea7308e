#include "dalembert/output/sensor_recorder.hpp"

#include <algorithm>
#include <stdexcept>

#include "dalembert/output/numbers.hpp"

namespace dalembert {
namespace {

constexpr double most_reserved = 1e4;  // rows; longer tables grow

}  // namespace

void SensorRecorder::open(const SimulationSettings& settings, const std::vector<SensorChannel>& channels,
                          SensorStorage* storage, double rows) {
  close();
  const auto& s = settings.solutionSettings;
  active_ = s.sensorsStoreAndWriteFiles && !channels.empty();
  if (!active_) return;
  channels_ = channels;
  flush_ = s.flushFilesImmediately;
  headers_ = s.sensorsWriteFileHeader;
  precision_ = s.outputPrecision;
  rows_ = static_cast<std::size_t>(std::clamp(rows, 0.0, most_reserved));
  files_.resize(channels.size());
  targets_.resize(channels.size());
  if (storage) storage->tables.resize(channels.size());
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const SensorChannel& c = channels[i];
    if (c.write_to_file && !c.file_name.empty()) {
      files_[i].open(c.file_name, s.sensorsAppendToFile, "file of sensor " + std::to_string(i));
      targets_[i].file = &files_[i];
    }
    if (!storage || !c.store_internal) continue;
    targets_[i].table = &storage->tables[i];
    if (!s.sensorsAppendToFile) storage->tables[i] = {};
  }
}

void SensorRecorder::write_headers(const RunDescription& run, System& system) {
  if (!active_ || !headers_) return;
  for (std::size_t i = 0; i < files_.size(); ++i) {
    if (!files_[i].is_open()) continue;
    system.sensor_values(static_cast<int>(i), ConfigurationType::Current, values_);
    files_[i].text() += "#dalembert " + run.solver_name + (run.is_static ? " static" : "") + " sensor output file\n" +
                        "#measure " + channels_[i].measured + "\n#OutputVariableType = " + channels_[i].variable +
                        "\n#simulation started = " + date_and_time() +
                        "\n#columns contain: time, comma separated sensor values (e.g, x,y,z position coordinates)" +
                        "\n#number of sensor values = " + std::to_string(values_.size()) + "\n#version = " + run.build +
                        "\n#\n";
  }
}

// Sensors that are neither written nor stored are evaluated all the same: user functions may record things themselves.
void SensorRecorder::record(System& system, double time) {
  const System::Recording recording(system);
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    const int sensor = static_cast<int>(i);
    system.sensor_values(sensor, ConfigurationType::Current, values_);
    if (targets_[i].file != nullptr) write(*targets_[i].file, time);
    if (targets_[i].table != nullptr) store(*targets_[i].table, sensor, time);
  }
}

void SensorRecorder::write(OutputFile& file, double time) {
  std::string& t = file.text();
  append_number(t, time, precision_);
  for (const double x : values_) {
    t += ',';
    append_number(t, x, precision_);
  }
  t += '\n';
  flush_ ? file.flush() : file.written();
}

void SensorRecorder::store(SensorTable& table, int sensor, double time) {
  const int columns = static_cast<int>(values_.size()) + 1;
  if (table.columns == 0) {
    table.columns = columns;
    table.values.reserve(rows_ * static_cast<std::size_t>(columns));
  }
  if (table.columns != columns) {
    throw std::runtime_error("sensor " + std::to_string(sensor) + ": the number of values changed from " +
                             std::to_string(table.columns - 1) + " to " + std::to_string(columns - 1) +
                             ", which storeInternal=True cannot keep; write this sensor to a file instead");
  }
  table.values.push_back(time);
  table.values.insert(table.values.end(), values_.begin(), values_.end());
}

void SensorRecorder::write_footer(const std::string& footer) {
  for (OutputFile& file : files_) {
    if (file.is_open()) file.text() += footer;
  }
}

void SensorRecorder::close() {
  files_.clear();
  targets_.clear();
  channels_.clear();
  active_ = false;
}

}  // namespace dalembert
