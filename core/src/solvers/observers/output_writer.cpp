#include "observers/output_writer.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include "dalembert/output/numbers.hpp"
#include "dalembert/output/restart_file.hpp"
#include "diagnosis/matrix_text.hpp"

namespace dalembert {

namespace {

std::string duration(double seconds, int precision) {
  if (seconds < 3600) return format_number(seconds, precision) + "s";
  if (seconds < 86400) return format_number(seconds / 3600, precision) + "h";
  return format_number(seconds / 86400, precision) + " days";
}

// Number of rows, including the initial values and the last step.
double expected_sensor_rows(const SimulationSettings& settings, bool is_static) {
  if (is_static) return settings.staticSolver.numberOfLoadSteps + 2.0;
  const auto& t = settings.timeIntegration;
  const double period = settings.solutionSettings.sensorsWritePeriod, steps = t.numberOfSteps;
  return (period > 0 ? std::min(steps, (t.endTime - t.startTime) / period) : steps) + 2;
}

}  // namespace

RunDescription OutputWriter::run_description() const {
  return {.solver_name = name(), .is_static = is_static(), .build = solver_.environment_->build};
}

void OutputWriter::open(std::span<const double> lengths) {
  const auto& s = settings().solutionSettings;
  output.writeToSolutionFile = s.writeSolutionToFile && !s.coordinatesSolutionFileName.empty();
  if (output.writeToSolutionFile)
    lengths.empty() ? solution_file_.open(settings()) : solution_file_.resume(settings(), lengths.front());
  output.writeToSolverFile = output.verboseModeFile > 0 && !s.solverInformationFileName.empty();
  if (output.writeToSolverFile) {
    information_file_.open(output_path(s.solverInformationFileName), s.appendToFile, "solver information file");
  }
  if (s.writeRestartFile) check_restart_file(output_path(s.restartFileName));
  sensors_.open(settings(), solver_.environment_->sensors, solver_.environment_->sensor_storage,
                expected_sensor_rows(settings(), is_static()), lengths.subspan(lengths.empty() ? 0 : 1));
  warn_of_files_written_twice();
}

std::vector<double> OutputWriter::lengths() {
  std::vector<double> lengths{solution_file_.length()};
  std::ranges::copy(sensors_.lengths(), std::back_inserter(lengths));
  return lengths;
}

// Warns if two outputs write the same file, which destroys both.
void OutputWriter::warn_of_files_written_twice() {
  std::vector<const OutputFile*> files{&solution_file_.file(), &information_file_};
  for (const OutputFile& file : sensors_.files()) files.push_back(&file);
  std::erase_if(files, [](const OutputFile* file) { return !file->is_open(); });
  std::set<FileIdentity> known;
  const auto check = [&](const std::string& name) {
    const FileIdentity identity = identity_of(name);
    if (identity != FileIdentity() && !known.insert(identity).second)
      warn("file '" + name +
           "' is written twice in this simulation, and what is in it cannot be used; give solution, restart "
           "file and every sensor a name of its own");
  };
  for (const OutputFile* file : files) check(file->name());
  if (!files.empty() && settings().solutionSettings.writeRestartFile)
    check(output_path(settings().solutionSettings.restartFileName));
}

void OutputWriter::write_headers() {
  if (output.writeToSolutionFile) solution_file_.write_header(settings(), run_description(), sizes_);
  sensors_.write_headers(run_description(), system());
}

bool OutputWriter::needs_steps() const {
  const bool speaks =
      output.verboseMode != 0 || output.verboseModeFile != 0 || (output.stepInformation & step_information::every_step);
  return speaks || output.writeToSolutionFile || sensors_.active();
}

void OutputWriter::write_end_of_step() {
  const bool last = std::abs(current().time - it.endTime) <= same_time();  // the last step is always written
  if (solver_.writes_each_step()) output.lastSolutionWritten = output.lastSensorsWritten = current().time;
  if (output.writeToSolutionFile) {
    if (last) output.lastSolutionWritten = it.endTime - it.currentStepSize;
    write_coordinates();
  }
  if (sensors_.active()) {
    if (last) output.lastSensorsWritten = it.endTime - it.currentStepSize;
    write_sensors();
  }
}

// Writes a row at the start, and after each period.
void OutputWriter::write_coordinates() {
  const double t = current().time;
  if (!solution_file_.is_open() || (t != it.startTime && t - output.lastSolutionWritten < -same_time())) return;
  const TimedPart time(timer, timer.writeSolution);
  output.lastSolutionWritten =
      std::max(output.lastSolutionWritten + settings().solutionSettings.solutionWritePeriod, t);
  write_solution_row();
}

void OutputWriter::write_solution_row() {
  if (!settings().solutionSettings.exportAlgebraicCoordinates) return solution_file_.write_row(settings(), current());
  const Solver::ReportedMultipliers reported(solver_);
  solution_file_.write_row(settings(), current());
}

void OutputWriter::record_sensors(double time) {
  const Solver::ReportedMultipliers reported(solver_);
  sensors_.record(system(), time);
}

void OutputWriter::write_sensors() {
  const double t = current().time;
  if (t != it.startTime && t - output.lastSensorsWritten < -same_time()) return;
  const TimedPart time(timer, timer.writeSolution);
  output.lastSensorsWritten = std::max(output.lastSensorsWritten + settings().solutionSettings.sensorsWritePeriod, t);
  record_sensors(t);
}

// ---- output at requested times -----------------------------------------------------------------------------------------

// Returns the number of completed periods, with a tolerance of a millionth of a period.
double OutputWriter::requested(double time, double period) const {
  return std::floor((time - it.startTime) / period + 1e-6);
}

// Calls `write` with all requested times in the last step, and with its end at the end of the simulation.
template <class Write>
void OutputWriter::write_between(double period, Write&& write) {
  const double end = current().time;
  bool written = false;
  if (period > 0) {
    const double last = requested(end, period);
    for (double k = requested(start_of_step().time, period) + 1; k <= last; ++k) {
      const double time = it.startTime + k * period;
      written = k == last && end - time < 1e-6 * period;
      write(written ? end : time);
    }
  }
  if (!written && (period <= 0 || end >= it.endTime)) write(end);
}

[[gnu::noinline]] void OutputWriter::write_requested() {
  const auto& s = settings().solutionSettings;
  const TimedPart time(timer, timer.writeSolution);
  const State end = current();
  const auto [accelerations, rates] = solver_.complete_ends();
  between_.prepare(system(), start_of_step(), end, accelerations, rates);
  const auto at = [&](double when) {
    if (when == end.time)
      current() = end;
    else
      between_.evaluate(when, current());
  };
  if (output.writeToSolutionFile) {
    write_between(s.solutionWritePeriod, [&](double when) {
      at(when);
      write_solution_row();
    });
  }
  current() = end;
  if (sensors_.active()) {
    write_between(s.sensorsWritePeriod, [&](double when) {
      at(when);
      record_sensors(when);
    });
  }
  current() = end;
}

void OutputWriter::print_progress(bool to_console, bool to_file) {
  if (!to_console && !to_file) return;
  using namespace step_information;
  const TimedPart time(timer, timer.overhead);
  const double elapsed = SolverTimer::now() - output.cpuSolverStartTime;
  const double t = it.currentTime, done = t - it.startTime, whole = it.endTime - it.startTime;
  const int info = output.stepInformation, digits = settings().outputPrecision;
  std::string text = "STEP" + std::to_string(it.currentStepIndex) +
                     (is_static() ? ", factor = " + number(solver_.load_factor()) : ", t = " + number(t) + "s");
  const bool at_end = it.currentTime + same_time() >= it.endTime;
  if (!is_static() && whole > 0) text += " (" + number(at_end ? 100 : std::floor(1000 * done / whole) / 10) + " %)";
  const bool other_step = !at_end && std::abs(it.currentStepSize - it.maxStepSize) > 1e-6 * it.maxStepSize;
  if ((info & step_size) || (info && other_step)) text += ", dt = " + duration(it.currentStepSize, digits);
  const bool known =
      elapsed > 0.2 && done > std::min(10 * it.initialStepSize, 1e-5 * whole) && it.currentStepIndex != 0;
  if ((info & time_to_go) && known && !at_end) text += ", timeToGo = " + duration((it.endTime - t) * elapsed / done, 3);
  if (info & cpu_time) text += ", tCPU=" + duration(elapsed, digits);
  const StepCount steps = it.currentStepIndex - output.lastVerboseStepIndex;
  const auto per_step = [&](int flag, const char* words, StepCount count, StepCount& last) {
    if ((info & flag) && steps != 0)
      text += words + number(static_cast<double>(count - last) / static_cast<double>(steps));
    last = count;
  };
  per_step(newton_iterations, ", Nit/step = ", it.newtonStepsCount, output.lastNewtonStepsCount);
  per_step(newton_jacobians, ", jac/step = ", it.newtonJacobiCount, output.lastNewtonJacobiCount);
  per_step(discontinuous_iterations, ", Dit/step = ", it.discontinuousIterationsCount,
           output.lastDiscontinuousIterationsCount);
  output.lastVerboseStepIndex = it.currentStepIndex;
  // Progress on the console may be overwritten by the next line.
  const bool passing = output.verboseMode == 1 && !at_end;
  if (to_console && hooks().print) hooks().print(passing ? "\r" + text : text + '\n');
  if (to_file && information_file_.is_open()) information_file_.text() += text + '\n';
}

// Prints the state (verboseMode 3).
[[gnu::noinline]] void OutputWriter::announce_solution() {
  const Solver::ReportedMultipliers reported(solver_);
  const State& now = current();
  const std::pair<const char*, const std::vector<double>*> parts[] = {
      {"ODE2", &now.q}, {"ODE2_t", &now.v}, {"ODE1", &now.y}, {"AE", &now.lambda}, {"data", &now.data}};
  for (const auto& [name, values] : parts) {
    if (!values->empty())
      say(3, std::string("  ") + name + " = " + vector_text(*values, settings().outputPrecision) + "\n");
  }
}

void OutputWriter::say(int level, std::string_view text) {
  if (output.verboseMode >= level && hooks().print) hooks().print(text);
  if (output.verboseModeFile >= level && information_file_.is_open()) {
    information_file_.text() += text;
    information_file_.written();
  }
}

void OutputWriter::warn(std::string_view text) {
  if (hooks().warn) hooks().warn(text);
  if (information_file_.is_open()) information_file_.text() += "WARNING: " + std::string(text) + "\n";
}

void OutputWriter::announce_end(const std::vector<std::string>& doubts) {
  const std::string seconds = " after " + number(timer.total) + " seconds.\n";
  if (stop_) {
    const char* reason = output.simulationStoppedByUserFunction ? "by user function"
                         : output.simulationTimeout             ? "by time limit"
                                                                : "by user";
    say(1, std::string("Solver stopped ") + reason + seconds);
  } else {
    say(1, std::string("Solver terminated ") + (output.finishedSuccessfully ? "successfully" : "unsuccessfully") +
               seconds);
    for (const std::string& doubt : doubts) say(1, "  not to be trusted: " + doubt + "\n");
    if (diagnosis_.failed()) say(1, diagnosis_.headline() + "\n");
    if (diagnosis_.failed() && information_file_.is_open()) information_file_.text() += diagnosis_.text() + "\n";
  }
}

void OutputWriter::write_footers() {
  const auto& s = settings().solutionSettings;
  const bool of_solution = s.writeFileFooter && output.writeToSolutionFile;
  const bool of_sensors = s.sensorsWriteFileFooter && !sensors_.files().empty();
  if (of_solution || of_sensors) {
    const std::string footer = solution_footer(it, conv, timer.total);
    if (of_solution) solution_file_.write_footer(footer, it, conv);
    if (of_sensors) sensors_.write_footer(footer);
  }
  close(solution_file_);
  close(sensors_);
}

template <class File>
void OutputWriter::close(File& file) {
  try {
    file.close();
  } catch (const FileError&) {
    if (!unwritten_) unwritten_ = std::current_exception();
  }
}

std::string OutputWriter::error_text() const {
  try {
    std::rethrow_exception(unwritten_);
  } catch (const FileError& error) {
    return error.what();
  }
}

void OutputWriter::close() {
  close(solution_file_);
  close(sensors_);
  close(information_file_);
}

}  // namespace dalembert
