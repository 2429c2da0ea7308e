// Event location: a step ends where a user function changes its sign, where an item switches, or at a scheduled time.
//
// The time is located on the Hermite polynomial through both ends of the step first, and then by steps that end there,
// with the method of Dowell and Jarratt (Illinois), BIT 11 (1971).
#include "control/events.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>
#include <utility>

#include "constraints/constraint_states.hpp"
#include "dalembert/model/errors.hpp"
#include "dalembert/model/model.hpp"
#include "dalembert/solvers/constrained_motion.hpp"
#include "dalembert/solvers/open_constraints.hpp"
#include "dalembert/system/system_term.hpp"
#include "diagnosis/diagnostics.hpp"

namespace dalembert {

namespace {

constexpr int most_solutions = 40;    // solutions of a step for one event
constexpr int most_in_a_row = 20;     // successive events of one function, close to each other
// In steps; a contact that is shorter than a step lasts little longer.
constexpr double close_of_user = 1, close_of_item = 2;
constexpr int most_rounds = 10;       // iterations until the items are consistent at the start
constexpr int inner_points = 3;       // samples inside a step, to detect two changes of sign
constexpr double leaves_zero = 10;    // relative to the value that remained at the event
// Relative to the value at the start of the step. A smaller value at its end counts as zero with round-off.
constexpr double on_zero = 1e-10;

int sign(double x) { return (x > 0) - (x < 0); }

// An interval with a change of sign, as parts of a step.
struct Bracket {
  double a = 0, b = 1, at_a = 0, at_b = 0;
  int moved = 0;  // the end that moved last: 1 right, -1 left
  // A function that is zero at the start has no earlier root.
  double estimate() const { return at_a == 0 ? b : at_a == at_b ? 0.5 * (a + b) : b - at_b * (b - a) / (at_b - at_a); }
  // Illinois method: halve the value of an end that remains twice in succession.
  void take(double x, double value, bool beyond) {
    if (beyond) {
      if (moved > 0) at_a *= 0.5;
      b = x;
      at_b = value;
    } else {
      if (moved < 0) at_b *= 0.5;
      a = x;
      at_a = value;
    }
    moved = beyond ? 1 : -1;
  }
};

}  // namespace

// ---- values at the start of a step
// -------------------------------------------------------------------------------------

void EventWatch::begin(std::vector<WatchedValue> values) {
  start_ = std::move(values);
  dead_band_.assign(start_.size(), -1);
  last_time_.assign(start_.size(), -std::numeric_limits<double>::infinity());
  in_a_row_.assign(start_.size(), 0);
  events_over(std::vector(start_));
}

bool EventWatch::just_after_event() const {
  return std::ranges::any_of(dead_band_, [](double band) { return band >= 0; });
}

bool EventWatch::counts(int event, double value) const {
  return std::abs(value) > dead_band_[static_cast<std::size_t>(event)];
}

// A function that is zero keeps its previous sign.
void EventWatch::go_on(const std::vector<WatchedValue>& values) {
  for (std::size_t i = 0; i < start_.size(); ++i) {
    if (values[i].value == 0 || !counts(static_cast<int>(i), values[i].value)) continue;
    start_[i] = values[i];
    dead_band_[i] = -1;
  }
}

void EventWatch::events_over(const std::vector<WatchedValue>& values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!values[i].holds) continue;
    const double size = std::abs(values[i].value);
    if (values[i].value > values[i].noise) continue;
    start_[i].value = 0;
    dead_band_[i] = std::max(leaves_zero * size, values[i].noise);
  }
  for (const Event& event : events) {
    const auto i = static_cast<std::size_t>(event.number);
    if (values[i].holds) continue;
    start_[i].value = 0;
    dead_band_[i] = leaves_zero * std::abs(event.left);
  }
  events.clear();
  go_on(values);
}

int EventWatch::count_repeated(double time) {
  int repeated = -1;
  for (const Event& event : events) {
    const auto i = static_cast<std::size_t>(event.number);
    const double steps = i < users.value_or(0) ? close_of_user : close_of_item;
    in_a_row_[i] = time - last_time_[i] <= steps * regular_step_size ? in_a_row_[i] + 1 : 0;
    last_time_[i] = time;
    if (in_a_row_[i] >= most_in_a_row) repeated = event.number;
  }
  return repeated;
}

std::vector<EventWatch::Event> EventWatch::changed(std::span<const WatchedValue> values) const {
  std::vector<Event> found;
  for (std::size_t i = 0; i < start_.size(); ++i) {
    if (values[i].holds) {
      if (values[i].value < 0 && counts(static_cast<int>(i), values[i].value))
        found.push_back({static_cast<int>(i), -1, values[i].value});
      continue;
    }
    const bool lands = i < users.value_or(0) && std::abs(values[i].value) <= on_zero * std::abs(start_[i].value);
    const int before = sign(start_[i].value), direction = (lands ? -before : sign(values[i].value)) - before;
    if (before == 0 || direction == 0 || values[i].direction * direction < 0) continue;
    found.push_back({static_cast<int>(i), sign(direction), values[i].value});
  }
  return found;
}

std::vector<double> EventWatch::numbers() const {
  std::vector<double> numbers;
  for (std::size_t i = 0; i < start_.size(); ++i)
    numbers.insert(numbers.end(), {start_[i].value, dead_band_[i], last_time_[i], static_cast<double>(in_a_row_[i])});
  return numbers;
}

void EventWatch::take_numbers(std::span<const double> numbers, const std::string& file) {
  if (numbers.size() != numbers_per_function * start_.size()) {
    throw ModelError(ErrorKind::value, "restart file '" + file + "': received " +
                                           std::to_string(numbers.size() / numbers_per_function) +
                                           " event functions; expected " + std::to_string(start_.size()) +
                                           ". Go on with the model and settings of before");
  }
  for (std::size_t i = 0; i < start_.size(); ++i) {
    const double* own = &numbers[numbers_per_function * i];
    start_[i].value = own[0];
    dead_band_[i] = own[1];
    last_time_[i] = own[2];
    in_a_row_[i] = static_cast<int>(own[3]);
  }
}

// ---- steps -------------------------------------------------------------------------------------------------------------

// Returns the values of user events, then of item events; the reference is valid until the next call.
const std::vector<WatchedValue>& EventControl::event_values(std::vector<Switch>& of_items) {
  std::vector<WatchedValue>& values = look_->values;
  values.clear();
  if (hooks().events) {
    const TimedPart time(timer, timer.python);
    const Solver::ReportedMultipliers reported(solver_);
    for (const EventValue& value : hooks().events(current().time)) values.push_back({value});
  }
  std::optional<std::size_t>& users = watch_->users;
  if (!users) users = values.size();
  if (values.size() != *users) {
    throw ModelError(ErrorKind::value, "mbs.EventsUserFunction: received " + std::to_string(values.size()) +
                                           " values; expected " + std::to_string(*users) +
                                           ", as at the start. Return one value per event, always");
  }
  if (!locates_switches()) return values;
  of_items.clear();
  system().find_switches(current(), conditions_, of_items);
  for (const Switch& at : of_items) values.push_back({{at.value, at.kink ? 0 : -1}, !at.kink, at.noise});
  return values;
}

void EventControl::warn_of_missing_switches(bool located) {
  const bool wanted = settings().events.ofItems;
  if (located || !(wanted || hooks().item_event_action)) return;
  const std::string who = hooks().item_event_action ? "mbs.ItemEventActionUserFunction" : "events.ofItems";
  warn(who + " has no effect: " +
       (!wanted       ? "events of items are not looked for (simulationSettings.events.ofItems=False)"
        : is_static() ? "static solvers have no events"
                      : "no item of this model has events of its own"));
}

void EventControl::begin() {
  watch_.reset();
  warned_of_actions_ = false;
  const bool locates = settings().events.ofItems && !is_static() && system().has_switches();
  warn_of_missing_switches(locates);
  iterates_without_ = locates ? System::Updates::without_switches : System::Updates::all;
  if (!hooks().events && !hooks().schedule && !locates) return;
  watch_ = std::make_unique<EventWatch>();
  look_ = std::make_unique<EventLook>();
  system().forget_switches();
  const auto wrong = [](const WatchedValue& value) { return value.holds && value.value < 0; };
  // The initial data coordinates contradict the positions: items have to switch before the first step.
  if (locates && !solver_.continues() && std::ranges::any_of(event_values(), wrong)) {
    settle_switches();
    solver_.renew_accelerations();
  }
  watch_->begin(event_values());
  if (!hooks().schedule) return;
  hooks().schedule->begin(current(), is_static());
  if (solver_.continues()) return;
  hooks().schedule->act(current());
  solver_.renew_accelerations();  // the stored accelerations may belong to loads of the previous solution
}

// ---- scheduled times
// ---------------------------------------------------------------------------------------------------

namespace {

double round_off_of(double time) { return 8 * std::numeric_limits<double>::epsilon() * std::abs(time); }

}  // namespace

void EventControl::end_as_scheduled() {
  if (!watch_)
    throw ModelError(
        ErrorKind::state,
        name() + ": sampled controllers act while solver.SolveSteps(...) solves the steps, not in single parts of it");
  constexpr double last_stretch = 1e-6;  // part of a step; the remainder is not a step of its own
  const double end = hooks().schedule->next(), start = start_of_step().time;
  if (end > it.endTime || it.currentTime < end - std::max(round_off_of(end), last_stretch * it.currentStepSize)) return;
  if (std::abs(it.currentTime - end) > round_off_of(end)) {
    watch_->unscheduled_step_size = std::max(watch_->unscheduled_step_size, it.currentStepSize);
    steps_.use(solver_.conditions_.step_size = end - start);
  }
  it.currentTime = current().time = end;
}

// Scheduled actions change forces, so accelerations jump.
void EventControl::act_as_scheduled() {
  steps_.use(std::max(it.currentStepSize, std::exchange(watch_->unscheduled_step_size, 0.0)));
  if (hooks().schedule->act(current()) || step_was_cut()) solver_.renew_accelerations();
}

bool EventControl::step_was_cut() const {
  return !it.automaticStepSize && it.currentStepSize > Solver::largest_growth * conditions_.step_size;
}

// ---- switches of items ---------------------------------------------------------------------------------------------------

// An item that switches may cause others to switch.
void EventControl::settle_switches() {
  const auto unsettled = [](const WatchedValue& value) { return value.holds && value.value < -value.noise; };
  int rounds = 0;
  do switch_over();
  while (++rounds < most_rounds && std::ranges::any_of(event_values(), unsettled));
  if (system().searches()) solver_.search();
}

// Sets the states of all items at the end of a step.
[[gnu::noinline]] void EventControl::switch_over() {
  if (locates_switches()) system().switch_over(current(), conditions_);
}

// Repeats the step that has just been solved with another size. Returns false if it fails.
bool EventControl::solve_again(double step_size) {
  solver_.reset_to_start_of_step();
  current().data = start_of_step().data;
  if (system().searches()) system().restore_history();
  it.currentTime = current().time = start_of_step().time;
  steps_.use(step_size);
  ++it.eventSolutions;
  return solver_.try_step();
}

namespace {

// Returns the sampled parts of a step. Short distances are included after an event, because the function may return to
// zero soon.
std::span<const double> places_to_look(bool after_event) {
  static constexpr std::array places{1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1, 0.25, 0.5, 0.75, 1.0};
  return std::span(places).last(after_event ? places.size() : inner_points + 1);
}

}  // namespace

// Returns the part of the step at which a function has changed its sign, on the Hermite polynomial; negative if there
// is no such function. `seen` receives the values at the previous sample, `before` its part of the step.
double EventControl::look_into_step(double& before) {
  const State& end = look_->end;
  EventWatch& seen = look_->seen;
  StepInterpolation& between = look_->between;
  between.prepare(system(), start_of_step(), end, false, false);
  const double start = start_of_step().time, h = end.time - start;
  const auto values_at = [&](double part) -> const std::vector<WatchedValue>& {
    if (part == 1)
      current() = end;
    else
      between.evaluate(start + part * h, current());
    return event_values();
  };
  double found = -1;
  before = 0;
  for (const double part : places_to_look(seen.just_after_event())) {
    const std::vector<WatchedValue>& values = values_at(part);
    const auto changed = seen.changed(values);
    if (changed.empty()) {
      seen.go_on(values);
      before = part;
      continue;
    }
    const int event = changed.front().number;
    const int sign_before = sign(seen.at_start(event));
    if (sign_before == 0) {
      found = part;
      break;
    }
    Bracket bracket{.a = before, .b = part, .at_a = seen.at_start(event), .at_b = changed.front().left};
    for (int k = 0; k < most_solutions && bracket.b - bracket.a > 1e-12; ++k) {
      const double x = std::clamp(bracket.estimate() + 1e-12, bracket.a, bracket.b);
      const double value = values_at(x)[static_cast<std::size_t>(event)].value;
      bracket.take(x, value, sign(value) != sign_before);
      if (std::abs(bracket.estimate() - x) < 1e-12) break;
    }
    found = bracket.b;
    break;
  }
  current() = end;
  return found;
}

// Locates the first event in a solved step and ends the step on its far side. Returns false if a repeated step fails.
bool EventControl::end_step() {
  if (!hooks().events && !locates_switches()) return true;
  EventWatch& watch = *watch_;
  watch.events.clear();
  std::vector<WatchedValue>& values = look_->at_end;
  EventWatch& seen = look_->seen;
  values = event_values();
  look_->end = current();
  seen = watch;
  const double end = current().time, whole = end - start_of_step().time, next = it.currentStepSize;
  double before = 0;
  const double guess = look_into_step(before);
  if (guess < 0) {
    std::swap(watch, seen);
    return true;
  }
  watch.regular_step_size = it.automaticStepSize ? std::min(next, std::max(whole, it.minStepSize)) : next;
  const double close = std::max(1e-11 * whole, 8 * std::numeric_limits<double>::epsilon() * std::abs(end));
  double a = before * whole, b = whole, x = std::clamp(guess * whole + close, close, whole);
  std::vector<Bracket> brackets;
  for (std::size_t i = 0; i < values.size(); ++i)
    brackets.push_back({.a = a, .b = b, .at_a = seen.at_start(static_cast<int>(i)), .at_b = values[i].value});
  watch.events = seen.changed(values);
  bool beyond = !watch.events.empty(), before_is_known = a == 0;  // or it follows from the polynomial
  for (int i = 0; i < most_solutions; ++i) {
    if (x < b || watch.events.empty()) {
      if (!solve_again(x)) return false;
      values = event_values();
      const auto changed = seen.changed(values);
      beyond = !changed.empty();
      if (beyond) watch.events = changed;
      (beyond ? b : a) = x;
      before_is_known |= !beyond;
      for (std::size_t k = 0; k < brackets.size(); ++k) brackets[k].take(x, values[k].value, beyond);
    }
    if (watch.events.empty()) {  // the polynomial was inaccurate: no event
      if (!solve_again(whole)) return false;
      steps_.use(next);
      watch.go_on(event_values());
      return true;
    }
    double root = b;
    for (const EventWatch::Event& event : watch.events)
      root = std::min(root, brackets[static_cast<std::size_t>(event.number)].estimate());
    if (b - std::max(root, a) <= 2 * close || b - a <= 2 * close) {
      if (std::exchange(before_is_known, true)) break;
      a = root = 0;
      for (Bracket& bracket : brackets) bracket = {.a = 0, .b = b, .at_a = bracket.at_a, .at_b = bracket.at_b};
      x = 0.5 * b;
      continue;
    }
    x = std::clamp(root + close, a + close, b - close);
  }
  if (!beyond) {
    if (!solve_again(b)) return false;
    watch.events = seen.changed(event_values());
  }
  steps_.use(watch.regular_step_size);
  return true;
}

bool EventControl::reached() const {
  return !watch_->events.empty() || (hooks().schedule && it.currentTime >= hooks().schedule->next());
}

namespace {

// Returns whether an action has changed states of items such that they must switch without passing zero.
bool jumps(const std::vector<WatchedValue>& values, const std::vector<WatchedValue>& before) {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (values[i].holds && values[i].value < std::min(before[i].value, -values[i].noise)) return true;
  return false;
}

}  // namespace

// Calls the user's actions at the end of a written step, and restarts from the resulting state.
[[gnu::noinline]] void EventControl::act() {
  EventWatch& watch = *watch_;
  const double time = current().time;
  if (hooks().schedule && time >= hooks().schedule->next()) act_as_scheduled();
  if (watch.events.empty()) return;
  it.eventsCount += static_cast<StepCount>(watch.events.size());
  const int repeated = watch.count_repeated(time);
  const bool acts = hooks().event_action || hooks().item_event_action, settles = acts && locates_switches();
  const std::vector<double> gaps = acts ? gaps_and_rates() : std::vector<double>();
  const std::vector<double> positions = acts ? current().q : std::vector<double>();
  std::vector<Switch> at_end;  // switches of the events, with their states at the event
  const std::vector<WatchedValue> before = settles ? event_values(at_end) : std::vector<WatchedValue>();
  for (const EventWatch::Event& event : watch.events) {
    if (verbose(2))
      say(2, "  " + describe_event(event.number) + (event.direction > 0 ? " (rising)" : " (falling)") +
                 solver_.position_text() + "\n");
    if (!let_user_act(event.number, event.direction)) stop_ = output.simulationStoppedByUserFunction = true;
  }
  const bool changed = acts || locates_switches();
  if (changed) {
    conv.jacobianUpdateRequested = true;
    if (system().searches()) solver_.search();
    if (acts) {
      solver_.joints_are_examined();
      solver_.examine_constraints_anew();
    }
    if (acts && gaps_and_rates() != gaps) end_velocities_against_constraints(current().q == positions);
    if (settles && jumps(event_values(), before)) {
      start_of_step() = current();
      settle_switches();
    }
  }
  if (changed || step_was_cut()) solver_.renew_accelerations();
  if (repeated >= 0) diagnose_chatter(repeated);
  watch.events_over(event_values());
}

// Returns false if the solver has to stop.
bool EventControl::let_user_act(int event, int direction) {
  const bool of_user = event < static_cast<int>(*watch_->users);
  if (of_user ? !hooks().event_action : !hooks().item_event_action) return true;
  const TimedPart part(timer, timer.python);
  const Solver::ReportedMultipliers reported(solver_);
  bool goes_on = true;
  if (of_user) {
    goes_on = hooks().event_action(current().time, event, direction);
  } else {
    const Switch& at = switches_[static_cast<std::size_t>(event) - *watch_->users];
    goes_on =
        hooks().item_event_action(current().time, {at.item, at.owner == nullptr ? "" : at.owner->name_of_part(at.part),
                                                   at.what, at.kink ? direction : at.direction});
  }
  if (!goes_on)
    say(1,
        std::string(of_user ? "EventAction" : "ItemEventAction") + "UserFunction returned False: the solver stops\n");
  return goes_on;
}

std::vector<double> EventControl::gaps_and_rates() {
  const auto n = static_cast<std::size_t>(sizes_.ae);
  std::vector<double> gaps(2 * n);
  if (n == 0) return gaps;
  const State still = without_multipliers(current());
  for (const bool of_rates : {false, true})
    system().gaps(still, at_level(conditions_, of_rates), std::span(gaps).subspan(of_rates ? n : 0, n));
  return gaps;
}

// Removes velocities across constraints after an action, like a plastic impact: the change is minimal in the metric of
// the mass matrix.
[[gnu::noinline]] void EventControl::end_velocities_against_constraints(bool keeps_positions) {
  if (sizes_.ae == 0 || is_static() || !solver_.enforces_constraints()) return;
  State moved = current();
  ConstrainedMotion own, *motion = solver_.motion_under_constraints();
  if (motion == nullptr) {
    solver_.prepare(own);
    motion = &own;
  } else {
    motion->examine_anew();  // actions may have switched constraints
  }
  const int row = motion->factorize(system(), moved, conditions_);
  if (row == LinearSolver::success && motion->project(system(), moved, conditions_)) {
    std::ranges::copy(moved.v, current().v.begin());  // in place: other objects refer to these vectors
    if (!keeps_positions) std::ranges::copy(moved.q, current().q.begin());
  }
  warn_of_actions_against_constraints(row);
}

std::string EventControl::describe_event(int event) const {
  const auto users = static_cast<int>(*watch_->users);
  if (event < users) return "event " + std::to_string(event) + " of mbs.EventsUserFunction";
  return describe_switch(switches_[static_cast<std::size_t>(event - users)]);
}

std::string EventControl::describe_switch(const Switch& at) const {
  if (at.owner != nullptr) return std::string("event '") + at.what + "' of " + at.owner->name_of_part(at.part);
  const std::string item =
      model() == nullptr ? "object " + std::to_string(at.item) : model()->describe(ItemKind::object, at.item);
  return std::string("event '") + at.what + "' of " + item;
}

[[gnu::noinline]] void EventControl::diagnose_chatter(int event) {
  conv.stepReductionFailed = true;
  const std::string what = describe_event(event) + " has come " + std::to_string(most_in_a_row) +
                           " times, each within " +
                           (event < static_cast<int>(*watch_->users) ? "a step" : "two steps") + " of the one before: ";
  Diagnosis& d = solver_.diagnostics_->diagnose(FailureReason::event_chatter);
  if (event < static_cast<int>(*watch_->users)) {
    d.advice = {
        what + "let its action end what repeats ever faster, for example bring the body to rest below a small velocity",
        "check that the action does not leave the value of the event function at zero"};
  } else {
    d.advice = {what + "give the item damping that ends what repeats, or less stiffness",
                "use smaller steps (timeIntegration.numberOfSteps), or settle many changes at once, in the step that "
                "they lie in (events.ofItems=False)"};
  }
}

// Called after actions of an event and the projection onto the constraints.
[[gnu::noinline]] void EventControl::warn_of_actions_against_constraints(int singular_row) {
  const auto& s = settings().initialConditions;
  if (!s.checkConstraints || warned_of_actions_) return;
  const auto open =
      open_constraints(system(), current(), conditions_, {s.positionTolerance, s.velocityTolerance, true});
  if (open.empty()) return;
  warned_of_actions_ = true;
  std::string text =
      name() + ": the action of an event contradicts " + listed(open, system()) + "\n  That cannot be mended at once";
  if (singular_row != LinearSolver::success)
    text += ", as mass matrix and constraints are singular at unknown " + std::to_string(singular_row) + " (" +
            system().describe_row(singular_row) + ")";
  warn(text +
       ", and leads to large velocities and forces in the next step: let the action leave positions and velocities "
       "that fulfil all constraints.");
}

// ---- restart -----------------------------------------------------------------------------------------------------------

std::vector<double> EventControl::restart_numbers() const {
  std::vector<double> numbers = watch_ ? watch_->numbers() : std::vector<double>();
  if (hooks().schedule) std::ranges::copy(hooks().schedule->numbers(), std::back_inserter(numbers));
  return numbers;
}

void EventControl::resume(std::span<const double> numbers, const std::string& file) {
  if (!watch_ && !numbers.empty()) watch_ = std::make_unique<EventWatch>();
  if (!watch_) return;
  const std::size_t all = numbers.size(),
                    of_events =
                        hooks().schedule ? std::min(all, EventWatch::numbers_per_function * watch_->count()) : all;
  watch_->take_numbers(numbers.first(of_events), file);
  if (hooks().schedule) hooks().schedule->take_numbers(numbers.subspan(of_events));
}

}  // namespace dalembert
