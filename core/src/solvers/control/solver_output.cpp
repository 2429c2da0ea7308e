// Ends of steps and of solutions, as the user sees them.
#include <algorithm>
#include <chrono>
#include <iterator>
#include <thread>

#include "control/continuation.hpp"
#include "control/events.hpp"
#include "dalembert/output/numbers.hpp"
#include "dalembert/solvers/constraint_solver.hpp"
#include "dalembert/solvers/open_constraints.hpp"
#include "dalembert/solvers/solver.hpp"
#include "observers/output_writer.hpp"
#include "diagnosis/diagnostics.hpp"

namespace dalembert {

namespace {

// Factor of the position tolerance for solvers with velocity constraints, whose drift is an integration error.
constexpr double tolerated_drift = 1000;

}  // namespace

void Solver::initialize_output() {
  const auto take = [this](const auto& options) {
    output.verboseMode = options.verboseMode;
    output.verboseModeFile = options.verboseModeFile;
    output.stepInformation = options.stepInformation;
    newton_settings = options.newton;
    discontinuous = options.discontinuous;
  };
  if (is_static())
    take(settings_->staticSolver);
  else
    take(settings_->timeIntegration);
  writer_->close();
  writer_->open(continues() ? std::span<const double>(continuation_->file_lengths()) : std::span<const double>());
  if (verbose(1)) say(1, "+++++++++++++++++++++++++++++++\ndalembert solver: " + name() + "\n");
}

void Solver::say(int level, std::string_view text) { writer_->say(level, text); }

void Solver::warn(std::string_view text) { writer_->warn(text); }

std::string Solver::number(double value) const { return format_number(value, settings_->outputPrecision); }

std::string Solver::position_text() const {
  if (is_static()) return ", load factor = " + number(load_factor());
  return ", t = " + number(it.currentTime);
}

// Returns whether a step ends without messages, files, pauses, and user functions that could read the state.
bool Solver::steps_end_silently() const {
  const auto& s = settings_->solutionSettings;
  const bool writes = writer_->needs_steps() || s.writeRestartFile || s.recordImagesInterval >= 0;
  const bool waits = settings_->pauseAfterEachStep || settings_->timeIntegration.simulateInRealtime;
  return !writes && !waits && !hooks().pre_step && !hooks().post_step && !has_replaced_parts();
}

// Returns whether multipliers within the solution must be minimum-norm ones at each step. States that nobody reads only
// need forces of the motion; interpolated states need multipliers at both ends.
bool Solver::asks_for_multipliers_in_steps() const {
  const bool within = events_->any() || it.automaticStepSize || settings_->denseOutput.atRequestedTimes;
  return is_static() || within || hooks().pre_step || hooks().post_newton || has_replaced_parts() ||
         system_->has_discontinuities(conditions_);
}

// Reports minimum-norm multipliers in place, because other objects refer to the vector.
Solver::ReportedMultipliers::ReportedMultipliers(Solver& solver)
    : solver_(solver), reported_(solver.minimum_norm_multipliers()) {
  if (reported_ == nullptr) return;
  own_ = solver.current().lambda;
  std::ranges::copy(*reported_, solver.current().lambda.begin());
}

// Restores the multipliers, except values that the user has changed.
Solver::ReportedMultipliers::~ReportedMultipliers() {
  std::vector<double>& lambda = solver_.current().lambda;
  if (reported_ != nullptr && lambda == *reported_) std::ranges::copy(own_, lambda.begin());
}

void Solver::finish_step(bool write) {
  if (silent_) return;
  const double t = current().time;
  const bool end_reached = it.currentTime + same_time() >= it.endTime;
  const bool every_step = output.stepInformation & step_information::every_step;
  const bool to_console = output.verboseMode >= 2 || every_step || (output.verboseMode == 1 && end_reached);
  const bool to_file = output.verboseModeFile >= 2 || every_step || (output.verboseModeFile == 1 && end_reached);
  if (settings_->timeIntegration.simulateInRealtime) wait_for_real_time();
  if (to_console || to_file) writer_->print_progress(to_console, to_file);
  if (verbose(3)) writer_->announce_solution();
  if (hooks().post_step) {
    const TimedPart time(timer, timer.python);
    const ReportedMultipliers reported(*this);
    if (!hooks().post_step(it.currentTime)) {
      say(1, "PostStepUserFunction returned False: the solver stops\n");
      stop_ = output.simulationStoppedByUserFunction = true;
    }
  }
  const bool between = settings_->denseOutput.atRequestedTimes && !is_static() && it.currentStepIndex > 0;
  if (write) between ? writer_->write_requested() : writer_->write_end_of_step();
  const double interval = settings_->solutionSettings.recordImagesInterval;
  if (interval >= 0 && t >= output.lastImageRecorded + interval) {
    output.lastImageRecorded += interval;
    if (hooks().show) show(true);
  }
  if (settings_->pauseAfterEachStep && hooks().pause) {
    const ReportedMultipliers reported(*this);
    hooks().pause();
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

void Solver::write_solution_header() { writer_->write_headers(); }

void Solver::write_coordinates() { writer_->write_coordinates(); }

bool Solver::continues() const { return continuation_->exists(); }
const std::vector<double>& Solver::continued_values() const { return continuation_->values(); }
double Solver::continued_number(std::size_t i) const { return continuation_->number_of_solver(i); }

void Solver::forget() {
  system_->forget_searches();
  joints_are_examined();
  rank_known_ = false;
}

// A file that cannot be written is an error, or a warning if the simulation has failed already.
void Solver::finalize() {
  writer_->write_footers();
  if (writer_->error()) output.finishedSuccessfully = false;
  summarize();
  leave();
  if (!writer_->error()) return;
  output.finishedSuccessfully = false;  // closing may have failed as well
  if (!conv.stepReductionFailed) std::rethrow_exception(writer_->error());
  warn(writer_->error_text());
}

// Closes files and ends threads: no threads may exist when the user's process forks.
void Solver::leave() {
  writer_->close();
  system_->use_threads(1);
}

// Closes files while an exception ends the simulation.
void Solver::abandon() {
  try {
    throw;
  } catch (const FileError&) {
    writer_->note_error(std::current_exception());
  } catch (...) {
  }
  const bool raised = writer_->error() != nullptr;
  leave();
  if (writer_->error() && !raised) warn(writer_->error_text());
}

void Solver::summarize() {
  if (verbose(1)) writer_->announce_end(doubts_);
  if (settings_->displayComputationTime) say(0, timer.to_string());
  if (settings_->displayStatistics) say(0, it.to_string());
}

void Solver::look_back() {
  const auto steps = [](StepCount n) { return std::to_string(n) + (n == 1 ? " step" : " steps"); };
  if (it.stepsAboveTolerance > 0) {
    doubts_.push_back("errors above the tolerances in " + steps(it.stepsAboveTolerance) + ": " +
                      (diagnostics_->closing_at_start().empty()
                           ? "look for jumps, or lower timeIntegration.minimumStepSize; a mechanism that "
                             "passes a singular position cannot be computed more accurately there"
                           : diagnostics_->closing_at_start()));
  }
  if (it.unsettledSteps > 0) {
    doubts_.push_back("contact or friction that has not settled in " + steps(it.unsettledSteps) +
                      ": use smaller steps, or more discontinuous.maxIterations");
  }
  if (constraint_solver().hides_constraints()) {
    doubts_.push_back(
        "redundant joints do not fit exactly, and masses or constraints differ by orders of magnitude: reactions of "
        "light bodies may have "
        "errors above 1 %; use smaller steps, a solver that keeps constraints of positions, or joints without "
        "redundant equations");
  }
  std::vector<std::string> observed =
      is_static() ? angles_.doubts_of_equilibrium(*system_) : angles_.doubts(it.automaticStepSize);
  std::ranges::copy(rebounds_.doubts([this](const Switch& at) { return events_->describe_switch(at); }),
                    std::back_inserter(observed));
  if (conditions_.rate_level && !is_static() && system_->calls_user_functions()) {
    const std::vector<int> found = equations_without_rates(*system_, current(), conditions_, it.startTime);
    if (!found.empty())
      observed.push_back(
          system_->describe_row(sizes_.first_ae() + found.front()) +
          ": a function of time moves the position, but its rate is zero, and index 2 solvers follow the "
          "rate. Give offsetUserFunction_t as well, or use a solver that keeps positions");
  }
  for (std::string& doubt : observed) {
    if (!verbose(1)) warn(doubt);
    doubts_.push_back(std::move(doubt));
  }
  const auto& s = settings_->initialConditions;
  if (s.checkConstraints && sizes_.ae > 0) {
    const double tolerance = (conditions_.rate_level ? tolerated_drift : 1) * s.positionTolerance;
    // Regularization may open the rates of constraints that are very weak relative to others.
    const auto open = open_constraints(*system_, current(), conditions_,
                                       {tolerance, s.velocityTolerance, constraint_solver().active()});
    if (!open.empty())
      doubts_.push_back("open at the end: " + listed(open, *system_) +
                        "\n  Use smaller steps, or a solver that keeps constraints of positions");
  }
  output.trusted = doubts_.empty();
}

void Solver::advise_on_growth() {
  diagnosis_.advice.push_back(is_static() ? "use more load steps (staticSolver.numberOfLoadSteps)"
                                          : "use smaller steps (timeIntegration.numberOfSteps)");
}

std::string Solver::error_string() const {
  if (output.finishedSuccessfully) return "";
  if (diagnosis_.failed()) return diagnosis_.headline();
  if (writer_->error()) return writer_->error_text();
  if (!output.initializationSuccessful) return "initialization not successful";
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

double Solver::end_time() const {
  return is_static() ? settings_->staticSolver.loadStepDuration : settings_->timeIntegration.endTime;
}

}  // namespace dalembert
