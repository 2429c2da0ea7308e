// What a solver writes: files, messages, statistics, the diagnosis of a failure.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>
#include <thread>

#include "dalembert/output/numbers.hpp"
#include "dalembert/output/restart_file.hpp"
#include "dalembert/solvers/solver.hpp"

namespace dalembert {

namespace {

std::string duration(double seconds) {
  if (seconds < 3600) return format_number(seconds) + "s";
  if (seconds < 86400) return format_number(seconds / 3600) + "h";
  return format_number(seconds / 86400) + " days";
}

// With the initial values and the last step.
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
  if (output.writeToSolutionFile) solution_file_.open(*settings_);
  output.writeToSolverFile = output.verboseModeFile > 0 && !s.solverInformationFileName.empty();
  if (output.writeToSolverFile) {
    information_file_.open(s.solverInformationFileName, s.appendToFile, "solver information file");
  }
  sensors_.open(*settings_, environment_->sensors, environment_->sensor_storage, expected_sensor_rows(*settings_, is_static()));
  if (verbose(1)) say(1, "+++++++++++++++++++++++++++++++\ndalembert solver: " + name() + "\n");
}

void Solver::say(int level, std::string_view text) {
  if (output.verboseMode >= level && hooks().print) hooks().print(text);
  if (output.verboseModeFile >= level && information_file_.is_open()) {
    information_file_.text() += text;
    information_file_.written();
  }
}

void Solver::warn(std::string_view text) {
  if (hooks().warn) hooks().warn(text);
  if (information_file_.is_open()) information_file_.text() += "WARNING: " + std::string(text) + "\n";
}

std::string Solver::position_text() const {
  if (is_static()) return ", load factor = " + format_number(load_factor());
  return ", t = " + format_number(it.currentTime);
}

// No messages, no files, no pauses, and no functions that could ask for them.
bool Solver::steps_end_silently() const {
  const auto& s = settings_->solutionSettings;
  const bool speaks = output.verboseMode != 0 || output.verboseModeFile != 0 || (output.stepInformation & step_information::every_step);
  const bool writes = output.writeToSolutionFile || sensors_.active() || s.writeRestartFile || s.recordImagesInterval >= 0;
  const bool waits = settings_->pauseAfterEachStep || settings_->timeIntegration.simulateInRealtime;
  return !speaks && !writes && !waits && !hooks().pre_step && !hooks().post_step && !has_replaced_parts();
}

void Solver::finish_step(bool write) {
  if (silent_) return;
  const double t = current().time;
  const bool end_reached = it.currentTime + 1e-10 >= it.endTime;
  const bool every_step = output.stepInformation & step_information::every_step;
  const bool to_console = output.verboseMode >= 2 || every_step || (output.verboseMode == 1 && end_reached);
  const bool to_file = output.verboseModeFile >= 2 || every_step || (output.verboseModeFile == 1 && end_reached);
  if (settings_->timeIntegration.simulateInRealtime) wait_for_real_time();
  if (to_console || to_file) print_progress(to_console, to_file);
  if (hooks().post_step) {
    const TimedPart time(timer, timer.python);
    if (!hooks().post_step(it.currentTime)) {
      say(1, "PostStepUserFunction returned False: the solver stops\n");
      stop_ = output.simulationStoppedByUserFunction = true;
    }
  }
  const bool last = std::abs(t - it.endTime) <= 1e-10;  // the last step is always written
  if (write && output.writeToSolutionFile) {
    if (last) output.lastSolutionWritten = it.endTime - it.currentStepSize;
    write_coordinates();
  }
  if (write && sensors_.active()) {
    if (last) output.lastSensorsWritten = it.endTime - it.currentStepSize;
    write_sensors();
  }
  if (settings_->solutionSettings.writeRestartFile && it.currentStepIndex > 0) write_restart();
  const double interval = settings_->solutionSettings.recordImagesInterval;
  if (interval >= 0 && t >= output.lastImageRecorded + interval) {
    output.lastImageRecorded += interval;
    if (hooks().show) hooks().show(true);
  }
  if (settings_->pauseAfterEachStep && hooks().pause) hooks().pause();
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
  const int info = output.stepInformation;
  std::string text = "STEP" + std::to_string(it.currentStepIndex) +
                     (is_static() ? ", factor = " + format_number(load_factor()) : ", t = " + format_number(t) + "s");
  if (info & step_size) text += ", dt = " + duration(it.currentStepSize);
  if (info & time_to_go) {
    const bool known = elapsed > 0.2 && done > std::min(10 * it.initialStepSize, 1e-5 * whole) && it.currentStepIndex != 0;
    text += ", timeToGo = " + duration(known ? (it.endTime - t) * elapsed / done : 0);
  }
  if (info & cpu_time) text += ", tCPU=" + duration(elapsed);
  const int steps = it.currentStepIndex - output.lastVerboseStepIndex;
  const auto per_step = [&](int flag, const char* words, int count, int& last) {
    if ((info & flag) && steps != 0) text += words + format_number((count - last) / static_cast<double>(steps));
    last = count;
  };
  per_step(newton_iterations, ", Nit/step = ", it.newtonStepsCount, output.lastNewtonStepsCount);
  per_step(newton_jacobians, ", jac/step = ", it.newtonJacobiCount, output.lastNewtonJacobiCount);
  per_step(discontinuous_iterations, ", Dit/step = ", it.discontinuousIterationsCount,
           output.lastDiscontinuousIterationsCount);
  output.lastVerboseStepIndex = it.currentStepIndex;
  text += '\n';
  if (to_console && hooks().print) hooks().print(text);
  if (to_file && information_file_.is_open()) information_file_.text() += text;
}

void Solver::write_solution_header() {
  if (output.writeToSolutionFile) solution_file_.write_header(*settings_, run_description(), sizes_);
  sensors_.write_headers(run_description(), *system_);
}

// Written at the first time, and whenever a period is over; time differences below 1e-10 s do not count.
void Solver::write_coordinates() {
  const double t = current().time;
  if (!solution_file_.is_open() || (t != it.startTime && t - output.lastSolutionWritten < -1e-10)) return;
  const TimedPart time(timer, timer.writeSolution);
  output.lastSolutionWritten = std::max(output.lastSolutionWritten + settings_->solutionSettings.solutionWritePeriod, t);
  solution_file_.write_row(*settings_, current());
}

void Solver::write_sensors() {
  const double t = current().time;
  if (t != it.startTime && t - output.lastSensorsWritten < -1e-10) return;
  const TimedPart time(timer, timer.writeSolution);
  output.lastSensorsWritten = std::max(output.lastSensorsWritten + settings_->solutionSettings.sensorsWritePeriod, t);
  sensors_.record(*system_, t);
}

void Solver::write_restart() {
  const double t = current().time;
  const bool last = std::abs(t - it.endTime) <= 1e-10;
  if (!last && t - last_restart_ < settings_->solutionSettings.restartWritePeriod - 1e-10) return;
  const TimedPart time(timer, timer.writeSolution);
  last_restart_ = t;
  write_restart_file(settings_->solutionSettings.restartFileName, current(), restart_values(), it.currentStepSize);
}

void Solver::finalize() {
  if (verbose(1)) summarize();
  if (settings_->solutionSettings.writeFileFooter && output.writeToSolutionFile) {
    const std::string footer = solution_footer(it, conv, timer.total);
    solution_file_.write_footer(footer, it, conv);
    if (settings_->solutionSettings.sensorsWriteFileFooter) sensors_.write_footer(footer);
  }
  leave();
}

// Threads go, too: none is there when the user's processes fork.
void Solver::leave() {
  close_files();
  system_->use_threads(1);
}

void Solver::summarize() {
  const std::string seconds = " after " + format_number(timer.total) + " seconds.\n";
  if (stop_) {
    const char* reason = output.simulationStoppedByUserFunction ? "by user function"
                         : output.simulationTimeout             ? "by time limit"
                                                                : "by user";
    say(1, std::string("Solver stopped ") + reason + seconds);
  } else {
    say(1, std::string("Solver terminated ") + (output.finishedSuccessfully ? "successfully" : "unsuccessfully") + seconds);
  }
  if (settings_->displayComputationTime) say(1, timer.to_string());
  if (settings_->displayStatistics) say(1, it.to_string());
}

void Solver::close_files() {
  solution_file_.close();
  sensors_.close();
  information_file_.close();
}

double Solver::end_time() const {
  return is_static() ? settings_->staticSolver.loadStepDuration : settings_->timeIntegration.endTime;
}

std::string Solver::error_string() const {
  if (!output.initializationSuccessful) return "initialization not successful";
  if (output.finishedSuccessfully) return "";
  std::string text;
  const auto add = [&text](bool flag, const char* words) {
    if (flag) text += (text.empty() ? "" : "; ") + std::string(words);
  };
  add(conv.linearSolverFailed, "linear solver failed (Jacobian singular)");
  add(conv.massMatrixNotInvertible, "mass matrix was not invertible");
  add(conv.stepReductionFailed, "reduction of step size reached minimum step size");
  add(conv.stopNewton, "Newton has been stopped");
  add(!conv.newtonConverged && !conv.linearSolverFailed, "Newton did not converge");
  add(conv.newtonSolutionDiverged, "solution diverged");
  add(!conv.discontinuousIterationSuccessful, "discontinuous iteration was not successful");
  return text.empty() ? "error in a user function or in an item" : text;
}

void Solver::diagnose(FailureReason reason, std::span<const double> residual) {
  diagnosis_ = Diagnosis();
  Diagnosis& d = diagnosis_;
  d.reason = reason;
  d.solver = name();
  d.step = it.currentStepIndex;
  d.newton_iteration = it.newtonSteps;
  d.time = it.currentTime;
  d.step_size = it.currentStepSize;
  d.load_factor = is_static() ? load_factor() : 1;
  d.residual = conv.residual;
  d.relative_residual = initial_residual_ > 0 ? conv.residual / initial_residual_ : 0;
  d.tolerance_relative = newton_settings.relativeTolerance;
  d.tolerance_absolute = newton_settings.absoluteTolerance;
  if (conv.linearSolverFailed && conv.linearSolverCausingRow >= 0) {
    d.singular_row = conv.linearSolverCausingRow;
    d.singular_items = system_->describe_row(d.singular_row);
    d.advice.push_back("look for redundant constraints, coordinates without mass or stiffness, and zero parameters at these items");
    d.advice.push_back("use linearSolverType=exu.LinearSolverType.EigenDense with linearSolverSettings.ignoreSingularJacobian=True "
                       "to go on with redundant constraints");
    return;
  }
  std::vector<int> order(residual.size());
  std::iota(order.begin(), order.end(), 0);
  const auto count = std::min<std::size_t>(order.size(), 5);
  const auto larger = [&](int i, int j) {  // what is not a number comes first
    const double x = std::abs(residual[i]), y = std::abs(residual[j]);
    return std::isnan(x) != std::isnan(y) ? std::isnan(x) : x > y;
  };
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), order.end(), larger);
  for (std::size_t i = 0; i < count; ++i) {
    if (residual[order[i]] != 0) d.worst_rows.push_back({order[i], residual[order[i]], system_->describe_row(order[i])});
  }
  d.advice.push_back(is_static() ? "use more load steps (staticSolver.numberOfLoadSteps)"
                                 : "use smaller steps (timeIntegration.numberOfSteps)");
  d.advice.push_back("check initial values, and parameters of the items named above for wrong units");
  if (newton_settings.useModifiedNewton) d.advice.push_back("use full Newton (newton.useModifiedNewton=False)");
  if (reason == FailureReason::discontinuous) d.advice.push_back("allow more discontinuous.maxIterations");
}

}  // namespace dalembert
