// Output of a solver: files, messages, statistics.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>
#include <thread>

#include "dalembert/output/numbers.hpp"
#include "dalembert/output/restart_file.hpp"
#include "dalembert/solvers/solver.hpp"
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

RunDescription Solver::run_description() const {
  RunDescription run{.solver_name = name(), .is_static = is_static(), .build = environment_->build};
  return run;
}

void Solver::initialize_output() {
  const auto& s = settings_->solutionSettings;
  if (is_static()) {
    const auto& o = settings_->staticSolver;
    output.verboseMode = o.verboseMode;
    output.verboseModeFile = o.verboseModeFile;
    output.stepInformation = o.stepInformation;
    newton_settings = o.newton;
    discontinuous = o.discontinuous;
  } else {
    const auto& o = settings_->timeIntegration;
    output.verboseMode = o.verboseMode;
    output.verboseModeFile = o.verboseModeFile;
    output.stepInformation = o.stepInformation;
    newton_settings = o.newton;
    discontinuous = o.discontinuous;
  }
  close_files();
  output.writeToSolutionFile = s.writeSolutionToFile && !s.coordinatesSolutionFileName.empty();
  const std::span<const double> lengths = continues() ? std::span<const double>(continuation_->files) : std::span<const double>();
  if (output.writeToSolutionFile) lengths.empty() ? solution_file_.open(*settings_) : solution_file_.resume(*settings_, lengths.front());
  output.writeToSolverFile = output.verboseModeFile > 0 && !s.solverInformationFileName.empty();
  if (output.writeToSolverFile) {
    information_file_.open(output_path(s.solverInformationFileName), s.appendToFile, "solver information file");
  }
  if (s.writeRestartFile) check_restart_file(output_path(s.restartFileName));
  sensors_.open(*settings_, environment_->sensors, environment_->sensor_storage, expected_sensor_rows(*settings_, is_static()),
                lengths.subspan(lengths.empty() ? 0 : 1));
  warn_of_files_written_twice();
  if (verbose(1)) say(1, "+++++++++++++++++++++++++++++++\ndalembert solver: " + name() + "\n");
}

// Warns if two outputs write the same file, which destroys both.
void Solver::warn_of_files_written_twice() {
  std::vector<const OutputFile*> files{&solution_file_.file(), &information_file_};
  for (const OutputFile& file : sensors_.files()) files.push_back(&file);
  std::erase_if(files, [](const OutputFile* file) { return !file->is_open(); });
  std::set<FileIdentity> known;
  const auto check = [&](const std::string& name) {
    const FileIdentity identity = identity_of(name);
    if (identity != FileIdentity() && !known.insert(identity).second)
      warn("file '" + name + "' is written twice in this simulation, and what is in it cannot be used; give solution, restart "
           "file and every sensor a name of its own");
  };
  for (const OutputFile* file : files) check(file->name());
  if (!files.empty() && settings_->solutionSettings.writeRestartFile) check(output_path(settings_->solutionSettings.restartFileName));
}

void Solver::say(int level, std::string_view text) {
  if (output.verboseMode >= level && hooks().print) hooks().print(text);
  if (output.verboseModeFile >= level && information_file_.is_open()) {
    information_file_.text() += text;
    information_file_.written();
  }
}

std::string Solver::number(double value) const { return format_number(value, settings_->outputPrecision); }

void Solver::warn(std::string_view text) {
  if (hooks().warn) hooks().warn(text);
  if (information_file_.is_open()) information_file_.text() += "WARNING: " + std::string(text) + "\n";
}

std::string Solver::position_text() const {
  if (is_static()) return ", load factor = " + number(load_factor());
  return ", t = " + number(it.currentTime);
}

// Returns whether a step ends without messages, files, pauses, and user functions that could read the state.
bool Solver::steps_end_silently() const {
  const auto& s = settings_->solutionSettings;
  const bool speaks = output.verboseMode != 0 || output.verboseModeFile != 0 || (output.stepInformation & step_information::every_step);
  const bool writes = output.writeToSolutionFile || sensors_.active() || s.writeRestartFile || s.recordImagesInterval >= 0;
  const bool waits = settings_->pauseAfterEachStep || settings_->timeIntegration.simulateInRealtime;
  return !speaks && !writes && !waits && !hooks().pre_step && !hooks().post_step && !has_replaced_parts();
}

// Returns whether multipliers within the solution must be minimum-norm ones at each step. States that nobody reads only
// need forces of the motion; interpolated states need multipliers at both ends.
bool Solver::asks_for_multipliers_in_steps() const {
  const bool within = watch_ || it.automaticStepSize || settings_->denseOutput.atRequestedTimes;
  return is_static() || within || hooks().pre_step || hooks().post_newton || has_replaced_parts() || system_->has_discontinuities(conditions_);
}

// Reports minimum-norm multipliers in place, because other objects refer to the vector.
Solver::Told::Told(Solver& solver) : solver_(solver), told_(solver.told_multipliers()) {
  if (told_ == nullptr) return;
  own_ = solver.current().lambda;
  std::ranges::copy(*told_, solver.current().lambda.begin());
}

// Restores the multipliers, except values that the user has changed.
Solver::Told::~Told() {
  std::vector<double>& lambda = solver_.current().lambda;
  if (told_ != nullptr && lambda == *told_) std::ranges::copy(own_, lambda.begin());
}

void Solver::finish_step(bool write) {
  if (silent_) return;
  const double t = current().time;
  const bool end_reached = it.currentTime + same_time() >= it.endTime;
  const bool every_step = output.stepInformation & step_information::every_step;
  const bool to_console = output.verboseMode >= 2 || every_step || (output.verboseMode == 1 && end_reached);
  const bool to_file = output.verboseModeFile >= 2 || every_step || (output.verboseModeFile == 1 && end_reached);
  if (settings_->timeIntegration.simulateInRealtime) wait_for_real_time();
  if (to_console || to_file) print_progress(to_console, to_file);
  if (verbose(3)) announce_solution();
  if (hooks().post_step) {
    const TimedPart time(timer, timer.python);
    const Told told(*this);
    if (!hooks().post_step(it.currentTime)) {
      say(1, "PostStepUserFunction returned False: the solver stops\n");
      stop_ = output.simulationStoppedByUserFunction = true;
    }
  }
  const bool between = settings_->denseOutput.atRequestedTimes && !is_static() && it.currentStepIndex > 0;
  if (write) between ? write_requested() : write_end_of_step();
  const double interval = settings_->solutionSettings.recordImagesInterval;
  if (interval >= 0 && t >= output.lastImageRecorded + interval) {
    output.lastImageRecorded += interval;
    if (hooks().show) show(true);
  }
  if (settings_->pauseAfterEachStep && hooks().pause) {
    const Told told(*this);
    hooks().pause();
  }
}

void Solver::write_end_of_step() {
  const bool last = std::abs(current().time - it.endTime) <= same_time();  // the last step is always written
  if (writes_each_step()) output.lastSolutionWritten = output.lastSensorsWritten = current().time;
  if (output.writeToSolutionFile) {
    if (last) output.lastSolutionWritten = it.endTime - it.currentStepSize;
    write_coordinates();
  }
  if (sensors_.active()) {
    if (last) output.lastSensorsWritten = it.endTime - it.currentStepSize;
    write_sensors();
  }
}

void Solver::wait_for_real_time() {
  const TimedPart time(timer, timer.realtimeIdleCPU);
  const auto& s = settings_->timeIntegration;
  const double simulated = current().time - it.startTime;
  while (s.realtimeFactor * (SolverTimer::now() - output.cpuSolverStartTime) < simulated) {
    if (s.realtimeWaitMicroseconds > 0) {
      std::this_thread::sleep_for(std::chrono::microseconds(s.realtimeWaitMicroseconds));
    }
    poll_interrupt();
    if (stop_) return;
  }
}

void Solver::print_progress(bool to_console, bool to_file) {
  if (!to_console && !to_file) return;
  using namespace step_information;
  const TimedPart time(timer, timer.overhead);
  const double elapsed = SolverTimer::now() - output.cpuSolverStartTime;
  const double t = it.currentTime, done = t - it.startTime, whole = it.endTime - it.startTime;
  const int info = output.stepInformation, digits = settings_->outputPrecision;
  std::string text = "STEP" + std::to_string(it.currentStepIndex) +
                     (is_static() ? ", factor = " + number(load_factor()) : ", t = " + number(t) + "s");
  const bool at_end = it.currentTime + same_time() >= it.endTime;
  if (!is_static() && whole > 0) text += " (" + number(at_end ? 100 : std::floor(1000 * done / whole) / 10) + " %)";
  const bool other_step = !at_end && std::abs(it.currentStepSize - it.maxStepSize) > 1e-6 * it.maxStepSize;
  if ((info & step_size) || (info && other_step)) text += ", dt = " + duration(it.currentStepSize, digits);
  const bool known = elapsed > 0.2 && done > std::min(10 * it.initialStepSize, 1e-5 * whole) && it.currentStepIndex != 0;
  if ((info & time_to_go) && known && !at_end) text += ", timeToGo = " + duration((it.endTime - t) * elapsed / done, 3);
  if (info & cpu_time) text += ", tCPU=" + duration(elapsed, digits);
  const StepCount steps = it.currentStepIndex - output.lastVerboseStepIndex;
  const auto per_step = [&](int flag, const char* words, StepCount count, StepCount& last) {
    if ((info & flag) && steps != 0) text += words + number(static_cast<double>(count - last) / static_cast<double>(steps));
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
[[gnu::noinline]] void Solver::announce_solution() {
  const Told told(*this);
  const State& now = current();
  const std::pair<const char*, const std::vector<double>*> parts[] = {
      {"ODE2", &now.q}, {"ODE2_t", &now.v}, {"ODE1", &now.y}, {"AE", &now.lambda}, {"data", &now.data}};
  for (const auto& [name, values] : parts) {
    if (!values->empty()) say(3, std::string("  ") + name + " = " + vector_text(*values, settings_->outputPrecision) + "\n");
  }
}

void Solver::write_solution_header() {
  if (output.writeToSolutionFile) solution_file_.write_header(*settings_, run_description(), sizes_);
  sensors_.write_headers(run_description(), *system_);
}

// Writes a row at the start, and after each period.
void Solver::write_coordinates() {
  const double t = current().time;
  if (!solution_file_.is_open() || (t != it.startTime && t - output.lastSolutionWritten < -same_time())) return;
  const TimedPart time(timer, timer.writeSolution);
  output.lastSolutionWritten = std::max(output.lastSolutionWritten + settings_->solutionSettings.solutionWritePeriod, t);
  write_solution_row();
}

void Solver::write_solution_row() {
  if (!settings_->solutionSettings.exportAlgebraicCoordinates) return solution_file_.write_row(*settings_, current());
  const Told told(*this);
  solution_file_.write_row(*settings_, current());
}

void Solver::record_sensors(double time) {
  const Told told(*this);
  sensors_.record(*system_, time);
}

void Solver::write_sensors() {
  const double t = current().time;
  if (t != it.startTime && t - output.lastSensorsWritten < -same_time()) return;
  const TimedPart time(timer, timer.writeSolution);
  output.lastSensorsWritten = std::max(output.lastSensorsWritten + settings_->solutionSettings.sensorsWritePeriod, t);
  record_sensors(t);
}

void Solver::forget() {
  system_->forget_searches();
  joints_are_examined();
  rank_known_ = false;
}

void Solver::write_restart() {
  const double t = current().time;
  const bool last = std::abs(t - it.endTime) <= same_time();
  if (!last && t - last_restart_ < settings_->solutionSettings.restartWritePeriod - same_time()) return;
  const TimedPart time(timer, timer.writeSolution);
  last_restart_ = t;
  if (multipliers_may_wait_) told_multipliers();  // the solver continues with the multipliers of the restart file
  write_restart_file(output_path(settings_->solutionSettings.restartFileName), restart_data());
  if (last) return;
  forget();
  compare_constraints_with(current());
}

// A file that cannot be written is an error, or a warning if the simulation has failed already.
void Solver::finalize() {
  const auto& s = settings_->solutionSettings;
  const std::string footer = solution_footer(it, conv, timer.total);
  if (s.writeFileFooter && output.writeToSolutionFile) solution_file_.write_footer(footer, it, conv);
  if (s.sensorsWriteFileFooter) sensors_.write_footer(footer);
  close(solution_file_);
  close(sensors_);
  if (unwritten_) output.finishedSuccessfully = false;
  summarize();
  leave();
  if (!unwritten_) return;
  output.finishedSuccessfully = false;
  if (!conv.stepReductionFailed) std::rethrow_exception(unwritten_);
  warn(unwritten_text());
}

// Closes files and ends threads: no threads may exist when the user's process forks.
void Solver::leave() {
  close_files();
  system_->use_threads(1);
}

// Closes files while an exception ends the simulation.
void Solver::abandon() {
  try {
    throw;
  } catch (const FileError&) {
    unwritten_ = std::current_exception();
  } catch (...) {
  }
  const bool told = unwritten_ != nullptr;
  leave();
  if (unwritten_ && !told) warn(unwritten_text());
}

template <class File>
void Solver::close(File& file) {
  try {
    file.close();
  } catch (const FileError&) {
    if (!unwritten_) unwritten_ = std::current_exception();
  }
}

std::string Solver::unwritten_text() const {
  try {
    std::rethrow_exception(unwritten_);
  } catch (const FileError& error) {
    return error.what();
  }
}

void Solver::summarize() {
  if (verbose(1)) announce_end();
  if (settings_->displayComputationTime) say(0, timer.to_string());
  if (settings_->displayStatistics) say(0, it.to_string());
}

void Solver::announce_end() {
  const std::string seconds = " after " + number(timer.total) + " seconds.\n";
  if (stop_) {
    const char* reason = output.simulationStoppedByUserFunction ? "by user function"
                         : output.simulationTimeout             ? "by time limit"
                                                                : "by user";
    say(1, std::string("Solver stopped ") + reason + seconds);
  } else {
    say(1, std::string("Solver terminated ") + (output.finishedSuccessfully ? "successfully" : "unsuccessfully") + seconds);
    for (const std::string& doubt : doubts_) say(1, "  not to be trusted: " + doubt + "\n");
    if (diagnosis_.failed()) say(1, diagnosis_.headline() + "\n");
    if (diagnosis_.failed() && information_file_.is_open()) information_file_.text() += diagnosis_.text() + "\n";
  }
}

void Solver::close_files() {
  close(solution_file_);
  close(sensors_);
  close(information_file_);
}

double Solver::end_time() const {
  return is_static() ? settings_->staticSolver.loadStepDuration : settings_->timeIntegration.endTime;
}

}  // namespace dalembert
