// The loop over steps: start, repetition with other step sizes, discontinuous iteration.
#include "dalembert/solvers/solver.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <thread>
#include <utility>

#include "dalembert/linear/linear_solver.hpp"
#include "dalembert/model/errors.hpp"
#include "dalembert/output/numbers.hpp"
#include "dalembert/solvers/constrained_motion.hpp"
#include "dalembert/system/large_vectors.hpp"
#include "diagnosis/finite.hpp"
#include "control/settings_checks.hpp"
#include "constraints/singular_positions.hpp"
#include "control/events.hpp"
#include "control/continuation.hpp"
#include "observers/output_writer.hpp"
#include "diagnosis/diagnostics.hpp"

namespace dalembert {

namespace {

// Copies in place; both vectors have the same size.
void take(const System& system, const std::vector<double>& from, std::vector<double>& to) {
  copy_numbers(system, from.data(), from.size(), to.data());
}

DALEMBERT_INLINE inline void take_all_but_motion(const System& system, const State& from, State& to) {
  for (const auto part : {&State::y, &State::y_t, &State::lambda, &State::data})  // most systems have few of these
    if (!(from.*part).empty()) take(system, from.*part, to.*part);
  to.time = from.time;
  to.sign = from.sign;
}

}  // namespace

const SolverEnvironment& no_environment() {
  static const SolverEnvironment none;
  return none;
}

Solver::Solver()
    : writer_(std::make_unique<OutputWriter>(*this)),
      continuation_(std::make_unique<Continuation>(*this)),
      events_(std::make_unique<EventControl>(*this)),
      diagnostics_(std::make_unique<Diagnostics>(*this)),
      singular_(std::make_unique<SingularPositions>(*this)) {}
Solver::~Solver() = default;

void Solver::attach(System& system, const SimulationSettings& settings, const SolverEnvironment& environment) {
  system_ = &system;
  settings_ = &settings;
  environment_ = &environment;
  read_settings();
}

void Solver::read_settings() {
  const auto& s = settings_->timeIntegration;
  loads_jacobian_ = s.computeLoadsJacobian;
  tolerances_ = {s.absoluteTolerance, s.relativeTolerance, s.stepSizeSafety};
  factors_ = {.decrease = s.adaptiveStepDecrease,
              .increase = s.adaptiveStepIncrease,
              .largest_increase = s.stepSizeMaxIncrease,
              .recovery_steps = s.adaptiveStepRecoverySteps,
              .recovery_iterations = s.adaptiveStepRecoveryIterations};
}

void Solver::forget_environment() { environment_ = &no_environment(); }

bool Solver::solve_system() {
  if (!is_static()) require_duration(settings_->timeIntegration.startTime, settings_->timeIntegration.endTime);
  bool success = false;
  timer.total = 0;
  try {
    if (initialize()) {
      timer.reset(settings_->displayComputationTime);
      const double start = SolverTimer::now();
      output.cpuSolverStartTime = output.cpuLastTimePrinted = start;
      timer.total = -start;
      success = solve_steps();
      timer.total += SolverTimer::now();
    }
  } catch (...) {
    if (timer.total < 0) timer.total += SolverTimer::now();
    conv.stepReductionFailed = true;
    output.finishedSuccessfully = false;
    abandon();
    throw;
  }
  output.finishedSuccessfully = success;
  finalize();
  return success;
}

bool Solver::initialize() {
  output = SolverOutputData();
  diagnosis_ = Diagnosis();
  doubts_.clear();
  rebounds_ = Rebounds();
  stop_ = silent_ = false;
  writer_->forget_error();
  output.cpuStartTime = output.cpuLastTimePrinted = output.cpuSolverStartTime = SolverTimer::now();
  pre_initialize();
  continuation_->read();
  initialize_output();
  if (!check_system()) return false;
  system_->reactions_are_unknown();
  joints_are_examined();
  tell_settings_without_effect(*settings_, hooks().warn);
  if (!is_static() && !(settings_->timeIntegration.automaticStepSize && controls_step_size()))
    warn_of_unused_tolerances(*settings_, hooks().warn);
  initialize_data();
  if (!diagnostics_->starts_finite()) return false;
  angles_.begin(*system_, environment_->model, hooks().locking_turns);
  initial_conditions();
  if (!is_static()) current().sign = start_of_step().sign = MultiplierSign::motion;
  if (!continues()) diagnostics_->check_constraints();
  post_initialize();
  if (!diagnosis_.failed() && !all_finite(current())) {
    diagnostics_->diagnose_not_finite();
    current() = system_->state(ConfigurationType::Initial);
  }
  output.initializationSuccessful = !diagnosis_.failed();
  return output.initializationSuccessful;
}

LinearSolverOptions Solver::linear_options() const {
  const auto& s = settings_->linearSolverSettings;
  return {.pivot_threshold = s.pivotThreshold, .ignore_singular = s.ignoreSingularJacobian};
}

void Solver::prepare(ConstrainedMotion& motion) const {
  motion.prepare(*system_, linear_type(), linear_options(), settings_->redundantConstraints, last_time());
}

double Solver::last_time() const {
  return is_static() ? std::numeric_limits<double>::infinity() : settings_->timeIntegration.endTime;
}

bool Solver::check_system() {
  const auto refuse_system = [](const std::string& text) { throw ModelError(ErrorKind::state, text); };
  if (!system_->assembled())
    refuse_system(name() + ": the system is not assembled; call mbs.Assemble() before solving");
  sizes_ = system_->sizes();
  if (sizes_.total() == 0) {
    refuse_system(name() + ": the system has no unknowns; add at least one node with coordinates and assemble again");
  }
  choose_linear_solver();
  if (dense() && sizes_.total() + sizes_.data > 1000) {
    warn("simulationSettings.linearSolverType is dense, but the system has " + std::to_string(sizes_.total()) +
         " unknowns; exu.LinearSolverType.EigenSparse needs less memory and time");
  }
  return true;
}

// Dense factors have a list of their operations up to 32 unknowns; sparse factors are faster above. Options of dense
// solvers, and users who write into matrices, require dense ones.
void Solver::choose_linear_solver() {
  constexpr int most_dense_unknowns = 32;
  const auto& s = *settings_;
  const auto& differences = newton_settings.numericalDifferentiation;
  linear_type_ = s.linearSolverType;
  if (!s.linearSolverChoice.automatic || linear_type_ != LinearSolverType::EXUdense) return;
  const bool needs_dense = s.linearSolverSettings.ignoreSingularJacobian || s.linearSolverSettings.pivotThreshold > 0 ||
                           hooks().system_jacobian || differences.doSystemWideDifferentiation || has_replaced_parts();
  const bool sparse = sizes_.total() > most_dense_unknowns && !needs_dense;
  if (sparse) linear_type_ = LinearSolverType::EigenSparse;
  if (verbose(1))
    say(1, std::string("  linear solver: ") + (sparse ? "sparse (EigenSparse)" : "dense (EXUdense)") +
               ", as linearSolverType has not been set\n");
}

void Solver::initialize_data() {
  rank_ = {};
  rank_known_ = announced_rank_ = false;
  conv = SolverConvergenceData();
  it = SolverIterationData();
  singular_->begin();
  warned_minimum_ = false;
  diagnostics_->begin();
  largest_misfit_ = 0;
  conv.errorCoordinateFactor =
      newton_settings.weightTolerancePerCoordinate ? std::sqrt(static_cast<double>(sizes_.total())) : 1.0;
  system_->forget_searches();
  if (system_->searches()) {
    system_->begin_history();
    system_->search(initial(), conditions_);
  }
  if (continues()) system_->forget_searches();  // the search for the initial values was not the last one
  static const int cores = static_cast<int>(std::thread::hardware_concurrency());  // reads files of the system
  system_->use_threads(std::min(settings_->parallel.numberOfThreads, cores));
  output.numberOfThreadsUsed = system_->threads();
  output.lastNewtonStepsCount = output.lastNewtonJacobiCount = output.lastDiscontinuousIterationsCount = 0;
}

// Warns of contradictory step sizes; does nothing if the end time is unknown.
void Solver::warn_of_step_sizes() {
  if (!(it.maxStepSize > 0)) return;
  const std::string group = is_static() ? "staticSolver." : "timeIntegration.";
  if ((it.adaptiveStep || it.automaticStepSize) && it.minStepSize > (1 + 1e-10) * it.maxStepSize) {
    warn(group + "minimumStepSize (" + number(it.minStepSize) + " s) is larger than the step size (" +
         number(it.maxStepSize) + " s), which cannot be reduced when a step fails");
  }
  if (it.automaticStepSize && it.initialStepSize > (1 + 1e-10) * it.maxStepSize) {
    warn(group + "initialStepSize (" + number(it.initialStepSize) +
         " s) is larger than the largest step size, (endTime - startTime)/" +
         "numberOfSteps = " + number(it.maxStepSize) + " s, which is taken instead");
    it.initialStepSize = it.maxStepSize;
  }
}

void Solver::initial_conditions() {
  if (is_static()) {
    const auto& s = settings_->staticSolver;
    it.numberOfSteps = s.numberOfLoadSteps;
    it.startTime = s.loadStepStart;
    it.endTime = s.loadStepStart + s.loadStepDuration;
    it.minStepSize = s.minimumStepSize;
    it.maxStepSize = s.loadStepDuration / static_cast<double>(it.numberOfSteps);
    it.adaptiveStep = s.adaptiveStep;
    it.automaticStepSize = false;
  } else {
    const auto& s = settings_->timeIntegration;
    const double steps = s.numberOfSteps;
    if (std::abs(steps - std::round(steps)) > 2.3e-14 * steps) {
      throw ModelError(ErrorKind::value, "timeIntegration.numberOfSteps: received " + format_number(steps, 17) +
                                             "; expected a whole number; use int(round(endTime/stepSize))");
    }
    it.numberOfSteps = std::llround(steps);
    it.startTime = s.startTime;
    it.endTime = s.endTime;
    it.minStepSize = s.minimumStepSize;
    it.maxStepSize = (it.endTime - it.startTime) / static_cast<double>(it.numberOfSteps);
    if (s.automaticStepSize) it.initialStepSize = s.initialStepSize != 0 ? s.initialStepSize : it.maxStepSize;
    it.adaptiveStep = s.adaptiveStep;
    it.automaticStepSize = s.automaticStepSize && controls_step_size();
  }
  warn_of_step_sizes();
  it.currentTime = it.startTime;
  State& first = system_->state(ConfigurationType::Initial);
  first.time = it.startTime;
  first.a.resize(static_cast<std::size_t>(sizes_.ode2));
  first.y_t.resize(static_cast<std::size_t>(sizes_.ode1));
  current() = first;
  start_of_step() = first;
  singular_->compare_with(first);
  output.lastSolutionWritten = output.lastSensorsWritten = output.lastImageRecorded = it.startTime;
  continuation_->begin(it.startTime);
  write_solution_header();
  if (continues()) continuation_->take();
}

[[gnu::noinline]] void Solver::start_steps() {
  steps_.start(factors_);
  it.currentStepIndex = 0;
  output.lastVerboseStepIndex = 0;
  output.finishedSuccessfully = false;
  conv.stepReductionFailed = false;
  conv.jacobianUpdateRequested = true;
  last_look_ = SolverTimer::now();
  steps_taken_ = look_mask_ = 0;
  silent_ = steps_end_silently();
  end_reached_ = false;
  step_completed_ = true;
  events_->begin();
  watches_rebounds_ = !is_static() && !it.automaticStepSize && !events_->locates_switches() &&
                      system_->has_switches() && !system_->searches();
  multipliers_may_wait_ = !asks_for_multipliers_in_steps();
  if (continues()) return continuation_->resume();
  finish_step(settings_->solutionSettings.writeInitialValues);
  ++it.currentStepIndex;
}

// Inlines the parts of a step: calls would take as long as the work.
[[gnu::flatten]] bool Solver::solve_steps() {
  // An empty interval is allowed: users integrate piece by piece.
  if (it.endTime == it.startTime && !is_static()) return true;
  require_duration(it.startTime, it.endTime);
  if (diagnosis_.failed() && it.currentStepIndex == 0) return false;  // a part of initialize has failed
  try {
    start_steps();
    start_of_step() = current();
    while (next_step()) {
      // The start of the last step remains visible.
      start_has_minimum_norm_ = multipliers_may_wait_ && it.endTime - it.currentTime < 1.5 * it.currentStepSize;
      if (start_has_minimum_norm_) minimum_norm_multipliers();
      save_start_of_step();
      take_step();
    }
  } catch (...) {
    return_to_start_of_step();
    throw;
  }
  end_steps();
  return output.finishedSuccessfully;
}

// Called after an exception, which has priority over any other failure. Multipliers that are not minimum-norm ones
// belong to the same forces.
[[gnu::noinline]] void Solver::return_to_start_of_step() {
  if (!step_completed_) current() = start_of_step();
  try {
    keep_minimum_norm_multipliers();
    if (!step_completed_) start_of_step().lambda = current().lambda;
  } catch (...) {  // NOLINT(bugprone-empty-catch)
  }
}

void Solver::keep_minimum_norm_multipliers() {
  const std::vector<double>* smallest = minimum_norm_multipliers();
  if (smallest != nullptr) std::ranges::copy(*smallest, current().lambda.begin());
  const bool start_waits = smallest != nullptr || (multipliers_may_wait_ && !start_has_minimum_norm_);
  multipliers_may_wait_ = false;
  if (!start_waits || !step_completed_ || it.currentStepIndex < 2 || !constraint_solver().active()) return;
  ConstrainedMotion motion;
  prepare(motion);
  motion.make_smallest(constraint_solver(), *system_, start_of_step(), conditions_, start_of_step().lambda);
}

void Solver::take_step() {
  while (!conv.stepReductionFailed) {
    if (try_step() && (!events_->any() || events_->end_step())) return step_succeeded();
    step_failed();
  }
}

void Solver::save_start_of_step() {
  const State& now = current();
  State& start = start_of_step();
  take(system(), now.q, start.q);
  take(system(), now.v, start.v);
  take(system(), now.a, start.a);
  take_all_but_motion(system(), now, start);
}

void Solver::save_all_but_motion() { take_all_but_motion(system(), current(), start_of_step()); }

// Returns false at the end, or if the solver was stopped.
bool Solver::next_step() {
  if (conv.stepReductionFailed || end_reached_ || stop_) return false;
  if (time_to_look()) poll();
  return !stop_;
}

void Solver::end_steps() {
  silent_ = false;
  keep_minimum_norm_multipliers();
  output.finishedSuccessfully = !conv.stepReductionFailed && !output.simulationTimeout;
  if (output.finishedSuccessfully) look_back();
}

bool Solver::try_step() {
  begin_step();
  return discontinuous_iteration();
}

void Solver::begin_step() {
  step_completed_ = false;
  initialize_step();
  if (newton_settings.modifiedNewtonJacUpdatePerStep) conv.jacobianUpdateRequested = true;
  it.lastStepSize = it.currentStepSize;
  diagnosis_.reason = FailureReason::none;  // resets the reason of an earlier attempt
  if (system_->is_pulled()) [[unlikely]]
    system_->renew_pull(current(), it.currentStepSize);
  if (system_->searches()) [[unlikely]]
    search();
}

[[gnu::noinline]] void Solver::step_failed() {
  if (!conv.discontinuousIterationSuccessful) ++it.rejectedDiscontinuousSteps;
  // Explicit methods have no iterations.
  else if (!conv.newtonConverged && it.newtonSteps > 0)
    ++it.rejectedNewtonSteps;
  current() = start_of_step();
  if (system_->searches()) system_->restore_history();
  // Smaller steps do not mend a singular matrix, inconsistent joints, round-off, or a singular configuration. A static iterate
  // far from the equilibrium may look inconsistent where joints fit.
  const FailureReason reason = diagnosis_.reason;
  const bool beyond_repair = conv.linearSolverFailed || (reason == FailureReason::contradiction && !is_static()) ||
                             reason == FailureReason::round_off || reason == FailureReason::singular_position;
  const bool may_be_reduced = !beyond_repair && (it.adaptiveStep || it.automaticStepSize);
  if (!may_be_reduced || !reduce_step_size()) {
    conv.stepReductionFailed = true;
    if (!diagnosis_.failed()) diagnostics_->diagnose(FailureReason::discontinuous, {});
    singular_->name_in_diagnosis();
    if (!diagnostics_->closing_at_start().empty())
      diagnosis_.advice.insert(diagnosis_.advice.begin(), diagnostics_->closing_at_start());
    angles_.advise(*system_, diagnosis_.advice);
    diagnostics_->advise_on_weak_constraints();
    return;
  }
  steps_.count_rejection();
  const bool rejected_by_error_control = it.automaticStepSize && conv.newtonConverged && !conv.stopNewton;
  if (verbose(1) && (output.stepInformation & step_information::step_reductions) && !rejected_by_error_control) {
    say(1, "  step size reduced to " + number(it.currentStepSize) + position_text() + "\n");
  }
}

void Solver::step_succeeded() {
  step_completed_ = true;
  if (it.automaticStepSize) [[unlikely]]
    steps_.count_accepted(conditions_.step_size);
  if (events_->any()) [[unlikely]]
    events_->switch_over();
  if (angles_.any() && !is_static()) angles_.watch(*system_, it);
  if (watches_rebounds_ && (it.discontinuousIteration > 1 || conv.discontinuousIterationError > 0)) [[unlikely]]
    rebounds_.watch(*system_, conditions_, it);
  if (!silent_) finish_step(true);
  if (events_->any() && events_->reached()) [[unlikely]]
    events_->act();
  if (steps_.is_recovered()) {
    const double before = it.currentStepSize;
    increase_step_size();
    if (it.currentStepSize > before && it.currentTime != it.endTime && verbose(1)) announce_increase();
  }
  if (!silent_ && settings_->solutionSettings.writeRestartFile) continuation_->write();
  ++it.currentStepIndex;
  end_reached_ = ends_here();
}

void Solver::prescribe_ends_of_steps(std::vector<double> times) {
  if (times.empty() || std::ranges::adjacent_find(times, std::greater_equal<>()) != times.end())
    throw ModelError(ErrorKind::value, name() + ": received ends of steps that do not increase");
  steps_.prescribe_ends(std::move(times));
}

void Solver::update_current_time() { it.currentTime = steps_.end_of_step(); }

[[gnu::noinline]] void Solver::announce_increase() {
  if (!(output.stepInformation & step_information::step_increases) && !verbose(2)) return;
  say(1, "  step size increased to " + number(it.currentStepSize) + position_text() + "\n");
}

void Solver::initialize_step() {
  if (system_->searches()) [[unlikely]]
    system_->keep_history();
  update_current_time();
  current().time = it.currentTime;
  conditions_.step_size = it.currentStepSize;
  if (verbose(2)) announce_step();
  if (hooks().pre_step) call_pre_step();
  if (renewed_constraints_ != system_->renewed_constraints()) [[unlikely]]
    look_for_switched_joints();
}

[[gnu::noinline]] void Solver::announce_step() {
  std::string text =
      "+++++++++++++++ COMPUTE STEP +++++++++++++++\nSTEP" + std::to_string(it.currentStepIndex) + position_text();
  if (it.adaptiveStep) text += ", step size = " + number(it.currentStepSize);
  say(2, text + "\n");
}

[[gnu::noinline]] void Solver::call_pre_step() {
  if (hooks().schedule) events_->end_as_scheduled();
  const TimedPart time(timer, timer.python);
  const ReportedMultipliers reported(*this);
  if (hooks().pre_step(it.currentTime)) return;
  say(1, "PreStepUserFunction returned False: the solver stops after this step\n");
  stop_ = output.simulationStoppedByUserFunction = true;
}

bool Solver::reduce_step_size() {
  it.currentTime = current().time;
  if (steps_.at_minimum()) return false;
  steps_.reject();
  return true;
}

void Solver::increase_step_size() {
  if (!it.automaticStepSize) steps_.recover();
}

[[gnu::noinline]] bool Solver::hold_at_minimum() {
  if (!warned_minimum_) {
    warn("automatic step size reached timeIntegration.minimumStepSize at time " + format_number(it.currentTime) +
         "; the error becomes larger than the tolerances");
    warned_minimum_ = true;
    if (it.currentStepIndex <= 1) diagnostics_->look_for_gaps_at_start();
  }
  const bool holds = steps_.hold_above_tolerance();
  if (!holds) diagnose_error_control();
  return holds;
}

void Solver::diagnose_error_control() {
  diagnostics_->diagnose(FailureReason::error_control).advice = {
      "look for what jumps: contact, friction, user functions that are not continuous",
      "allow larger errors (timeIntegration.relativeTolerance, absoluteTolerance), or smaller steps "
      "(timeIntegration.minimumStepSize)"};
}

void Solver::reset_to_start_of_step() {
  State& now = current();
  const State& start = start_of_step();
  now.q = start.q;
  now.v = start.v;
  now.a = start.a;
  now.y = start.y;
  now.y_t = start.y_t;
  now.lambda = start.lambda;
}

void Solver::begin_discontinuous_iteration() {
  conv.discontinuousIterationError = 0;
  conv.discontinuousIterationSuccessful = false;
  it.discontinuousIteration = 0;
}

void Solver::accept_newton() {
  finalize_newton();
  conv.discontinuousIterationError = post_newton();
  ++it.discontinuousIteration;
  ++it.discontinuousIterationsCount;
  if (verbose(2)) announce_discontinuous_iteration();
}

[[gnu::flatten]] bool Solver::discontinuous_iteration() {
  begin_discontinuous_iteration();
  while (it.discontinuousIteration < discontinuous.maxIterations && !conv.discontinuousIterationSuccessful) {
    if (!newton()) {
      conv.discontinuousIterationError = 2 * discontinuous.iterationTolerance;
      conv.discontinuousIterationSuccessful = true;  // the failure is that of Newton's method
      return false;
    }
    accept_newton();
    if (!std::isfinite(conv.discontinuousIterationError) || !all_finite(current().data)) [[unlikely]] {
      diagnostics_->diagnose_not_finite();
      return false;
    }
    if (conv.discontinuousIterationError <= discontinuous.iterationTolerance) {
      conv.discontinuousIterationSuccessful = true;
    } else if (it.discontinuousIteration < discontinuous.maxIterations) {
      if (system_->searches()) search();
      reset_to_start_of_step();
      steps_.use(conditions_.step_size);  // error control may have set the size of the next step
      const double recommended = it.recommendedStepSize;
      if (recommended != -1 && recommended < (1 + 1e-8) * it.currentStepSize) return false;
    } else if (discontinuous.ignoreMaxIterations) {
      conv.discontinuousIterationSuccessful = true;
      ++it.unsettledSteps;
    } else {
      diagnostics_->diagnose(FailureReason::discontinuous, {});
      return false;
    }
  }
  return conv.discontinuousIterationSuccessful;
}

[[gnu::noinline]] void Solver::announce_discontinuous_iteration() {
  say(2, "  discontinuous iteration " + std::to_string(it.discontinuousIteration) +
             ": error = " + number(conv.discontinuousIterationError) +
             ", tolerance = " + number(discontinuous.iterationTolerance) + "\n");
}

// Dense patterns do not change.
void Solver::search() {
  if (system_->search(current(), conditions_) && !dense()) pattern_revised();
}

double Solver::post_newton() {
  it.recommendedStepSize = -1;
  double error = 0;
  if (hooks().post_newton) {
    const TimedPart time(timer, timer.python);
    const auto [user_error, step_size] = hooks().post_newton(it.currentTime);
    error = std::abs(user_error);
    if (step_size >= 0) it.recommendedStepSize = step_size;
  }
  if (system_->has_discontinuities(conditions_)) {
    const TimedPart time(timer, timer.postNewton);
    const Discontinuity verdict = system_->post_newton(current(), conditions_, events_->iterates_without());
    error += verdict.error;
    if (verdict.recommended_step_size >= 0 &&
        (it.recommendedStepSize == -1 || verdict.recommended_step_size < it.recommendedStepSize)) {
      it.recommendedStepSize = verdict.recommended_step_size;
    }
  }
  // A contact that closes within a step of minimum size is closed during the whole step.
  if (!discontinuous.useRecommendedStepSize || steps_.at_minimum()) it.recommendedStepSize = -1;
  return error;
}

void Solver::poll_interrupt() {
  if (hooks().interrupted && hooks().interrupted()) {
    stop_ = output.simulationStoppedByUser = true;
  }
}

// Returns whether to check the clock: at every step first, then about every 2 ms.
bool Solver::time_to_look() { return (steps_taken_++ & look_mask_) == 0; }

void Solver::show(bool record_image) {
  hooks().show(record_image, [this](const std::function<void()>& take) {
    const ReportedMultipliers reported(*this);
    take();
  });
}

[[gnu::noinline]] void Solver::poll() {
  const double now = SolverTimer::now();
  const double elapsed = now - last_look_;
  last_look_ = now;
  if (elapsed < 1e-3 && look_mask_ < (1u << 24)) look_mask_ = 2 * look_mask_ + 1;
  if (elapsed > 4e-3) look_mask_ /= 2;
  poll_interrupt();
  if (hooks().show) {
    const TimedPart time(timer, timer.visualization);
    show(false);
  }
  if (hooks().timeout >= 0 && now - output.cpuSolverStartTime > hooks().timeout) {
    diagnostics_->time_is_over();
  }
  const double delay = now - output.cpuSolverStartTime > 3600 ? 30 : 2;
  if (now - output.cpuLastTimePrinted >= delay) {
    output.cpuLastTimePrinted = now;
    writer_->print_progress(output.verboseMode == 1, output.verboseModeFile == 1);
  }
}

}  // namespace dalembert
