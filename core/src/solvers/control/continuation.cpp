// Continuation from a restart file: the solution is bit-identical to an uninterrupted one.
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
#include "dalembert/solvers/solver.hpp"
#include "observers/dense_output.hpp"
#include "control/events.hpp"

namespace dalembert {

namespace {

// Numbers of the loop over steps, in the order of the restart file. The numbers of the solver, the counts and the
// gimbal-lock records follow.
enum RunNumber : std::size_t {
  start_time, step_index, last_step_size, solution_written, sensors_written, image_recorded, singular_position_step, passing_steps, largest_misfit,
  smallest_step_size, largest_step_size, first_of_sizes, count = first_of_sizes + StepController::restart_size
};

double as_number(StepCount n) { return static_cast<double>(n); }

// The file to go on from; empty: the initial values.
std::string file_of(const SimulationSettings& settings) {
  const std::string& asked = settings.continuation.restartFileName;
  const std::string own = output_path(settings.solutionSettings.restartFileName);
  return asked.empty() && settings.continuation.ifAvailable && std::filesystem::exists(own) ? own : asked;
}

}  // namespace

Solver::Solver() = default;
Solver::~Solver() = default;

void Solver::read_continuation() {
  continuation_.reset();
  const std::string name = file_of(*settings_);
  if (name.empty()) return;
  auto data = std::make_unique<RestartData>(read_restart_file(name));
  if (data->solver != this->name()) {
    throw ModelError(ErrorKind::value, "continuation.restartFileName: '" + name + "' was written by " + data->solver + "; expected " +
                                           this->name() + ". Go on with the solver that has begun");
  }
  continuation_ = std::move(data);
}

// Copies the restart data into the current state; output files are open.
void Solver::take_continuation() {
  const std::string name = file_of(*settings_);
  const RestartData& data = *continuation_;
  require_fitting(data, current(), name);
  const std::size_t without_locks = RunNumber::count + restart_numbers().size() + SolverIterationData::counts.size();
  if (data.run.size() < without_locks || (data.run.size() - without_locks) % LockingAngles::numbers_per_lock != 0) {
    throw ModelError(ErrorKind::value, "restart file '" + name + "': received " + std::to_string(data.run.size()) +
                                           " numbers about the run; expected " + std::to_string(without_locks));
  }
  if (data.run[start_time] != it.startTime) {
    throw ModelError(ErrorKind::value, "continuation.restartFileName: the solution in '" + name + "' has begun at time " +
                                           format_number(data.run[start_time], 17) + "; received a start time of " +
                                           format_number(it.startTime, 17) + ". Start time, end time and number of steps are those of the whole");
  }
  if (!system_->take_history(data.history)) {
    throw ModelError(ErrorKind::value, "restart file '" + name + "': the history of contacts does not belong to this system. Go on with the model and settings of before");
  }
  current() = data.state;
  it.currentTime = last_restart_ = data.state.time;
  start_of_step() = current();
  compare_constraints_with(current());
}

void Solver::continue_steps() {
  const std::vector<double>& run = continuation_->run;
  steps_.resume(continuation_->step_size, std::span(run).subspan(first_of_sizes, StepController::restart_size));
  it.currentStepIndex = output.lastVerboseStepIndex = static_cast<StepCount>(run[step_index]);
  it.lastStepSize = run[last_step_size];
  output.lastSolutionWritten = run[solution_written];
  output.lastSensorsWritten = run[sensors_written];
  output.lastImageRecorded = run[image_recorded];
  singular_position_step_ = static_cast<StepCount>(run[RunNumber::singular_position_step]);
  passing_steps_ = static_cast<int>(run[RunNumber::passing_steps]);
  largest_misfit_ = run[RunNumber::largest_misfit];
  it.smallestStepSize = run[smallest_step_size];
  it.largestStepSize = run[largest_step_size];
  take_counts(run);
  // The restart file has events.
  if (!watch_ && !continuation_->events.empty()) watch_ = std::make_unique<EventWatch>();
  if (watch_) {
    const std::span<const double> numbers(continuation_->events);
    const std::size_t all = numbers.size(), of_events = hooks().schedule ? std::min(all, EventWatch::numbers_per_function * watch_->count()) : all;
    watch_->take_numbers(numbers.first(of_events), file_of(*settings_));
    if (hooks().schedule) hooks().schedule->take_numbers(numbers.subspan(of_events));
  }
  if (verbose(1)) say(1, "  going on from '" + file_of(*settings_) + "' at time " + number(it.currentTime) + "\n");
  ++it.currentStepIndex;
  end_reached_ = ends_here();
}

void Solver::take_counts(std::span<const double> run) {
  std::size_t next = RunNumber::count + restart_numbers().size();
  for (const auto counter : SolverIterationData::counts) it.*counter = static_cast<StepCount>(run[next++]);
  output.lastNewtonStepsCount = it.newtonStepsCount;
  output.lastNewtonJacobiCount = it.newtonJacobiCount;
  output.lastDiscontinuousIterationsCount = it.discontinuousIterationsCount;
  angles_.take_numbers(run.subspan(next));
}

RestartData Solver::restart_data() {
  std::array<double, RunNumber::count> run{it.startTime, as_number(it.currentStepIndex), it.lastStepSize, output.lastSolutionWritten,
                                           output.lastSensorsWritten, output.lastImageRecorded, as_number(singular_position_step_),
                                           as_number(passing_steps_), largest_misfit_, it.smallestStepSize, it.largestStepSize};
  std::ranges::copy(steps_.restart_numbers(), run.begin() + first_of_sizes);
  const std::span<const double> values = restart_values();
  RestartData data{.solver = name(), .state = current(), .algorithmic_accelerations = {values.begin(), values.end()},
                   .step_size = it.currentStepSize, .run = {run.begin(), run.end()}, .events = {}, .history = system_->history(), .files = {solution_file_.length()}};
  if (watch_) data.events = watch_->numbers();
  if (hooks().schedule) std::ranges::copy(hooks().schedule->numbers(), std::back_inserter(data.events));
  std::ranges::copy(restart_numbers(), std::back_inserter(data.run));
  for (const auto counter : SolverIterationData::counts) data.run.push_back(as_number(it.*counter));
  angles_.add_numbers(data.run);
  std::ranges::copy(sensors_.lengths(), std::back_inserter(data.files));
  return data;
}

const std::vector<double>& Solver::continued_values() const { return continuation_->algorithmic_accelerations; }
double Solver::continued_number(std::size_t i) const { return continuation_->run[RunNumber::count + i]; }

// ---- output at requested times -----------------------------------------------------------------------------------------

// Returns the number of completed periods, with a tolerance of a millionth of a period.
double Solver::requested(double time, double period) const { return std::floor((time - it.startTime) / period + 1e-6); }

// Calls `write` with all requested times in the last step, and with its end at the end of the simulation.
template <class Write>
void Solver::write_between(double period, Write&& write) {
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

[[gnu::noinline]] void Solver::write_requested() {
  const auto& s = settings_->solutionSettings;
  const TimedPart time(timer, timer.writeSolution);
  if (!between_) between_ = std::make_unique<StepInterpolation>();
  const State end = current();
  const auto [accelerations, rates] = complete_ends();
  between_->prepare(*system_, start_of_step(), end, accelerations, rates);
  const auto at = [&](double when) {
    if (when == end.time) current() = end;
    else between_->evaluate(when, current());
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

}  // namespace dalembert
