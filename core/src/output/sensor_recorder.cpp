#include "dalembert/output/sensor_recorder.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "dalembert/output/rounded_text.hpp"

namespace dalembert {
namespace {

constexpr double most_reserved = 1e4;  // rows; longer tables grow

}  // namespace

void SensorRecorder::open(const SimulationSettings& settings, const std::vector<SensorChannel>& channels,
                          SensorStorage* storage, double rows, std::span<const double> lengths) {
  close();
  const auto& s = settings.solutionSettings;
  active_ = s.sensorsStoreAndWriteFiles && !channels.empty();
  if (!active_) return;
  channels_ = channels;
  flush_ = s.flushFilesImmediately;
  headers_ = s.sensorsWriteFileHeader && lengths.empty();
  precision_ = s.outputPrecision;
  rows_ = static_cast<std::size_t>(std::clamp(rows, 0.0, most_reserved));
  files_.resize(channels.size());
  targets_.resize(channels.size());
  columns_.assign(channels.size(), {});
  if (storage != nullptr && !s.sensorsAppendToFile) storage->clear();
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const SensorChannel& c = channels[i];
    if (c.write_to_file && !c.file_name.empty()) {
      const std::string purpose = "file of sensor " + std::to_string(i);
      if (i < lengths.size())
        files_[i].resume(output_path(c.file_name), lengths[i], purpose);
      else
        files_[i].open(output_path(c.file_name), s.sensorsAppendToFile, purpose);
      targets_[i].file = &files_[i];
    }
    if (storage == nullptr || !c.store_internal) continue;
    targets_[i].stored = true;
    storage_ = storage;
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
  row_.assign(1, time);
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    const int sensor = static_cast<int>(i);
    system.sensor_values(sensor, ConfigurationType::Current, values_);
    if (targets_[i].file != nullptr) write(*targets_[i].file, time);
    if (targets_[i].stored) store(system, sensor);
  }
  if (storage_ == nullptr) return;
  if (!begun_) storage_->begin(columns_, rows_);
  begun_ = true;
  storage_->append(row_);
}

void SensorRecorder::write(OutputFile& file, double time) {
  std::string& t = file.text();
  append_rounded(t, time, precision_);
  for (const double x : values_) {
    t += ',';
    append_rounded(t, x, precision_);
  }
  t += '\n';
  flush_ ? file.flush() : file.written();
}

void SensorRecorder::store(System& system, int sensor) {
  SensorColumns& columns = columns_[static_cast<std::size_t>(sensor)];
  const int count = static_cast<int>(values_.size());
  const SensorColumns before = begun_ ? columns : storage_->columns(sensor);
  if (before.first >= 0 && before.count != count) {
    throw std::runtime_error("sensor " + std::to_string(sensor) + ": the number of values changed from " +
                             std::to_string(before.count) + " to " + std::to_string(count) +
                             ", which storeInternal=True cannot keep; write this sensor to a file instead");
  }
  const int frame = channels_[static_cast<std::size_t>(sensor)].frame_node;
  columns = {static_cast<int>(row_.size()), count, frame >= 0};
  row_.insert(row_.end(), values_.begin(), values_.end());
  if (frame < 0) return;
  for (const OutputVariableType part : {OutputVariableType::Position, OutputVariableType::RotationMatrix}) {
    system.node_output(frame, part, ConfigurationType::Current, values_);
    row_.insert(row_.end(), values_.begin(), values_.end());
  }
}

std::vector<double> SensorRecorder::lengths() {
  std::vector<double> lengths;
  for (OutputFile& file : files_) lengths.push_back(file.length());
  return lengths;
}

void SensorRecorder::write_footer(const std::string& footer) {
  for (OutputFile& file : files_) {
    if (file.is_open()) file.text() += footer;
  }
}

void SensorRecorder::close() {
  std::vector<OutputFile> files = std::exchange(files_, {});
  targets_.clear();
  channels_.clear();
  storage_ = nullptr;
  active_ = begun_ = false;
  close_all(files);
}

void SensorStorage::begin(const std::vector<SensorColumns>& columns, std::size_t rows) {
  Chunk& chunk = chunks_.emplace_back(Chunk{columns, 1, std::max<std::size_t>(rows, 1), {}});
  for (const SensorColumns& c : chunk.columns) chunk.width += static_cast<std::size_t>(c.width());
  chunk.values.reserve(chunk.rows * chunk.width);
}

// A chunk that is full stays where it is, so that long recordings are not copied as they grow.
void SensorStorage::append(const std::vector<double>& row) {
  if (chunks_.back().values.size() >= chunks_.back().rows * chunks_.back().width)
    begin(chunks_.back().columns, chunks_.back().rows);
  std::vector<double>& values = chunks_.back().values;
  values.insert(values.end(), row.begin(), row.end());
}

SensorColumns SensorStorage::columns(int sensor) const {
  const auto i = static_cast<std::size_t>(sensor);
  for (auto chunk = chunks_.rbegin(); chunk != chunks_.rend(); ++chunk)
    if (i < chunk->columns.size() && chunk->columns[i].first >= 0) return chunk->columns[i];
  return {};
}

SensorTable SensorStorage::table(int sensor) const {
  const auto i = static_cast<std::size_t>(sensor);
  const auto has_sensor = [i](const Chunk& chunk) { return i < chunk.columns.size() && chunk.columns[i].first >= 0; };
  SensorTable table;
  std::size_t size = 0;
  for (const Chunk& chunk : chunks_) {
    if (!has_sensor(chunk)) continue;
    table.columns = chunk.columns[i].count + 1;
    size += chunk.values.size() / chunk.width * static_cast<std::size_t>(table.columns);
  }
  table.values.resize(size);
  double* to = table.values.data();
  for (const Chunk& chunk : chunks_) {
    if (!has_sensor(chunk)) continue;
    const auto [first, count, framed] = chunk.columns[i];
    if (chunk.width == static_cast<std::size_t>(count) + 1) {  // no other sensor
      to = std::ranges::copy(chunk.values, to).out;
      continue;
    }
    const double* const end = chunk.values.data() + chunk.values.size();
    for (const double* row = chunk.values.data(); row != end; row += chunk.width) {
      *to++ = *row;
      for (int k = first; k < first + count; ++k) *to++ = row[k];
    }
  }
  return table;
}

// A node that was not yet in a floating frame has global positions.
SensorTable SensorStorage::frames(int sensor) const {
  constexpr std::array<double, SensorColumns::frame> global{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  const auto i = static_cast<std::size_t>(sensor);
  SensorTable table;
  if (!columns(sensor).framed) return table;
  table.columns = SensorColumns::frame;
  for (const Chunk& chunk : chunks_) {
    if (i >= chunk.columns.size() || chunk.columns[i].first < 0) continue;
    const SensorColumns& c = chunk.columns[i];
    for (auto row = chunk.values.begin(); row != chunk.values.end(); row += static_cast<std::ptrdiff_t>(chunk.width)) {
      const double* const frame = c.framed ? &*row + c.first + c.count : global.data();
      table.values.insert(table.values.end(), frame, frame + SensorColumns::frame);
    }
  }
  return table;
}

}  // namespace dalembert
