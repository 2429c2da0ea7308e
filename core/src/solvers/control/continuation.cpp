// Continuation from a restart file: the solution is bit-identical to an uninterrupted one.
#include "control/continuation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <utility>

#include "dalembert/model/errors.hpp"
#include "dalembert/output/numbers.hpp"
#include "dalembert/output/output_file.hpp"
#include "dalembert/output/restart_file.hpp"
#include "control/events.hpp"
#include "constraints/singular_positions.hpp"
#include "control/continuation.hpp"
#include "observers/output_writer.hpp"

namespace dalembert {

namespace {

// Numbers of the loop over steps, in the order of the restart file. The numbers of the solver, the counts and the
// gimbal-lock records follow.
enum RunNumber : std::size_t {
  start_time,
  step_index,
  last_step_size,
  solution_written,
  sensors_written,
  image_recorded,
  singular_position_step,
  passing_steps,
  largest_misfit,
  smallest_step_size,
  largest_step_size,
  first_of_sizes,
  count = first_of_sizes + StepController::restart_size
};

double as_number(StepCount n) { return static_cast<double>(n); }

// The file to go on from; empty: the initial values.
std::string file_of(const SimulationSettings& settings) {
  const std::string& asked = settings.continuation.restartFileName;
  const std::string own = output_path(settings.solutionSettings.restartFileName);
  return asked.empty() && settings.continuation.ifAvailable && std::filesystem::exists(own) ? own : asked;
}

}  // namespace

void Continuation::read() {
  data_.reset();
  const std::string name = file_of(settings());
  if (name.empty()) return;
  auto data = std::make_unique<RestartData>(read_restart_file(name));
  if (data->solver != this->name()) {
    throw ModelError(ErrorKind::value, "continuation.restartFileName: '" + name + "' was written by " + data->solver +
                                           "; expected " + this->name() + ". Go on with the solver that has begun");
  }
  data_ = std::move(data);
}

// Copies the restart data into the current state; output files are open.
void Continuation::take() {
  const std::string name = file_of(settings());
  const RestartData& data = *data_;
  require_fitting(data, current(), name);
  const std::size_t without_locks =
      RunNumber::count + solver_.restart_numbers().size() + SolverIterationData::counts.size();
  if (data.run.size() < without_locks || (data.run.size() - without_locks) % LockingAngles::numbers_per_lock != 0) {
    throw ModelError(ErrorKind::value, "restart file '" + name + "': received " + std::to_string(data.run.size()) +
                                           " numbers about the run; expected " + std::to_string(without_locks));
  }
  if (data.run[start_time] != it.startTime) {
    throw ModelError(ErrorKind::value, "continuation.restartFileName: the solution in '" + name +
                                           "' has begun at time " + format_number(data.run[start_time], 17) +
                                           "; received a start time of " + format_number(it.startTime, 17) +
                                           ". Start time, end time and number of steps are those of the whole");
  }
  if (!system().take_history(data.history)) {
    throw ModelError(
        ErrorKind::value,
        "restart file '" + name +
            "': the history of contacts does not belong to this system. Go on with the model and settings of before");
  }
  current() = data.state;
  it.currentTime = last_written_ = data.state.time;
  start_of_step() = current();
  solver_.singular_->compare_with(current());
}

void Continuation::resume() {
  const std::vector<double>& run = data_->run;
  steps_.resume(data_->step_size, std::span(run).subspan(first_of_sizes, StepController::restart_size));
  it.currentStepIndex = output.lastVerboseStepIndex = static_cast<StepCount>(run[step_index]);
  it.lastStepSize = run[last_step_size];
  output.lastSolutionWritten = run[solution_written];
  output.lastSensorsWritten = run[sensors_written];
  output.lastImageRecorded = run[image_recorded];
  solver_.singular_->resume(static_cast<StepCount>(run[RunNumber::singular_position_step]),
                            static_cast<int>(run[RunNumber::passing_steps]));
  solver_.largest_misfit_ = run[RunNumber::largest_misfit];
  it.smallestStepSize = run[smallest_step_size];
  it.largestStepSize = run[largest_step_size];
  take_counts(run);
  solver_.events_->resume(data_->events, file_of(settings()));
  if (verbose(1)) say(1, "  going on from '" + file_of(settings()) + "' at time " + number(it.currentTime) + "\n");
  ++it.currentStepIndex;
  solver_.end_reached_ = solver_.ends_here();
}

void Continuation::take_counts(std::span<const double> run) {
  std::size_t next = RunNumber::count + solver_.restart_numbers().size();
  for (const auto counter : SolverIterationData::counts) it.*counter = static_cast<StepCount>(run[next++]);
  output.lastNewtonStepsCount = it.newtonStepsCount;
  output.lastNewtonJacobiCount = it.newtonJacobiCount;
  output.lastDiscontinuousIterationsCount = it.discontinuousIterationsCount;
  solver_.angles_.take_numbers(run.subspan(next));
}

RestartData Continuation::data() {
  std::array<double, RunNumber::count> run{it.startTime,
                                           as_number(it.currentStepIndex),
                                           it.lastStepSize,
                                           output.lastSolutionWritten,
                                           output.lastSensorsWritten,
                                           output.lastImageRecorded,
                                           as_number(solver_.singular_->last_step()),
                                           as_number(solver_.singular_->passing_steps()),
                                           solver_.largest_misfit_,
                                           it.smallestStepSize,
                                           it.largestStepSize};
  std::ranges::copy(steps_.restart_numbers(), run.begin() + first_of_sizes);
  const std::span<const double> values = solver_.restart_values();
  RestartData data{.solver = name(),
                   .state = current(),
                   .algorithmic_accelerations = {values.begin(), values.end()},
                   .step_size = it.currentStepSize,
                   .run = {run.begin(), run.end()},
                   .events = solver_.events_->restart_numbers(),
                   .history = system().history(),
                   .files = solver_.writer_->lengths()};
  std::ranges::copy(solver_.restart_numbers(), std::back_inserter(data.run));
  for (const auto counter : SolverIterationData::counts) data.run.push_back(as_number(it.*counter));
  solver_.angles_.add_numbers(data.run);
  return data;
}

void Continuation::write() {
  const double t = current().time;
  const bool last = std::abs(t - it.endTime) <= same_time();
  if (!last && t - last_written_ < settings().solutionSettings.restartWritePeriod - same_time()) return;
  const TimedPart time(timer, timer.writeSolution);
  last_written_ = t;
  if (solver_.multipliers_may_wait_)
    solver_.minimum_norm_multipliers();  // the solver continues with the multipliers of the restart file
  write_restart_file(output_path(settings().solutionSettings.restartFileName), data());
  if (last) return;
  solver_.forget();
  solver_.singular_->compare_with(current());
}

double Continuation::number_of_solver(std::size_t i) const { return data_->run[RunNumber::count + i]; }

}  // namespace dalembert
