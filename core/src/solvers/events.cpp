// Steps that end where functions of the user change their sign, or at times that are known beforehand.
//
// The place is found first on the Hermite polynomial through both ends of the step, then by steps that end there: the method of
// Dowell and Jarratt (Illinois), BIT 11 (1971).
#include "events.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "dalembert/model/errors.hpp"
#include "dalembert/solvers/solver.hpp"
#include "dense_output.hpp"

namespace dalembert {

namespace {

constexpr int most_solutions = 40;    // for one event; each takes as much as a step
constexpr int most_in_a_row = 20;     // events, each within a step of the one before
constexpr int inner_points = 3;       // of a step, where functions may have changed their sign twice
constexpr double leaves_zero = 10;    // times what was left at the event

int sign(double x) { return (x > 0) - (x < 0); }

// A place between two values of different sign.
struct Bracket {
  double a = 0, b = 1, at_a = 0, at_b = 0;
  int moved = 0;  // last, to the right or to the left
  double estimate() const { return at_a == at_b ? 0.5 * (a + b) : b - at_b * (b - a) / (at_b - at_a); }
  // The value of the end that stays is halved when it stays a second time.
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

// ---- what is known at the start of a step ------------------------------------------------------------------------------

void EventWatch::begin(std::vector<EventValue> values) {
  start_ = std::move(values);
  dead_band_.assign(start_.size(), -1);
}

void EventWatch::require_as_many(std::size_t count) const {
  if (count == start_.size()) return;
  throw ModelError(ErrorKind::value, "mbs.EventsUserFunction: received " + std::to_string(count) + " values; expected " +
                                         std::to_string(start_.size()) + ", as at the start. Return one value per event, always");
}

bool EventWatch::just_after_event() const {
  return std::ranges::any_of(dead_band_, [](double band) { return band >= 0; });
}

bool EventWatch::counts(int event, double value) const { return std::abs(value) > dead_band_[static_cast<std::size_t>(event)]; }

// The sign of zero is that of the next value.
void EventWatch::go_on(const std::vector<EventValue>& values) {
  for (std::size_t i = 0; i < start_.size(); ++i) {
    if (values[i].value == 0 || !counts(static_cast<int>(i), values[i].value)) continue;
    start_[i] = values[i];
    dead_band_[i] = -1;
  }
}

void EventWatch::events_over(const std::vector<EventValue>& values) {
  for (const Event& event : events) {
    const auto i = static_cast<std::size_t>(event.number);
    start_[i].value = 0;
    dead_band_[i] = leaves_zero * std::abs(event.left);
  }
  events.clear();
  go_on(values);
}

std::vector<EventWatch::Event> EventWatch::changed(std::span<const EventValue> values) const {
  std::vector<Event> found;
  for (std::size_t i = 0; i < start_.size(); ++i) {
    const int before = sign(start_[i].value), direction = sign(values[i].value) - before;
    if (before == 0 || direction == 0 || values[i].direction * direction < 0) continue;
    found.push_back({static_cast<int>(i), sign(direction), values[i].value});
  }
  return found;
}

std::vector<double> EventWatch::numbers() const {
  std::vector<double> numbers{last_time, static_cast<double>(in_a_row)};
  for (std::size_t i = 0; i < start_.size(); ++i) numbers.insert(numbers.end(), {start_[i].value, dead_band_[i]});
  return numbers;
}

void EventWatch::take_numbers(std::span<const double> numbers) {
  last_time = numbers[0];
  in_a_row = static_cast<int>(numbers[1]);
  for (std::size_t i = 0; i < start_.size(); ++i) {
    start_[i].value = numbers[2 + 2 * i];
    dead_band_[i] = numbers[3 + 2 * i];
  }
}

// ---- steps -------------------------------------------------------------------------------------------------------------

std::vector<EventValue> Solver::event_values() {
  if (!hooks().events) return {};
  const TimedPart time(timer, timer.python);
  return hooks().events(current().time);
}

void Solver::begin_to_watch_events() {
  watch_.reset();
  if (!hooks().events && !hooks().schedule) return;
  watch_ = std::make_unique<EventWatch>();
  watch_->begin(event_values());
  watch_->last_time = -std::numeric_limits<double>::infinity();
  if (!hooks().schedule) return;
  hooks().schedule->begin(current(), is_static());
  if (continues()) return;
  hooks().schedule->act(current());
  renew_accelerations();  // those that are known may be under forces of the last solution
}

// ---- times that are known beforehand -----------------------------------------------------------------------------------

namespace {

double round_off_of(double time) { return 8 * std::numeric_limits<double>::epsilon() * std::abs(time); }

}  // namespace

void Solver::end_as_scheduled() {
  if (!watch_) throw ModelError(ErrorKind::state, name() + ": sampled controllers act while solver.SolveSteps(...) solves the steps, not in single parts of it");
  constexpr double last_stretch = 1e-6;  // of a step, which no step is made for
  const double end = hooks().schedule->next(), start = start_of_step().time;
  if (end > it.endTime || it.currentTime < end - std::max(round_off_of(end), last_stretch * it.currentStepSize)) return;
  if (std::abs(it.currentTime - end) > round_off_of(end)) {
    watch_->unscheduled_step_size = std::max(watch_->unscheduled_step_size, it.currentStepSize);
    it.currentStepSize = conditions_.step_size = end - start;
  }
  it.currentTime = current().time = end;
}

// What it changes are forces: accelerations jump.
void Solver::act_as_scheduled() {
  if (hooks().schedule->act(current())) renew_accelerations();
  it.currentStepSize = std::max(it.currentStepSize, std::exchange(watch_->unscheduled_step_size, 0.0));
}

// Another end for the step that has just been solved; false: it fails.
bool Solver::solve_again(double step_size) {
  current() = start_of_step();
  reset_to_start_of_step();
  if (system_->searches()) system_->restore_history();
  it.currentTime = start_of_step().time;
  it.currentStepSize = step_size;
  ++it.eventSolutions;
  return try_step();
}

namespace {

// Places of the step, as parts of it, where functions are looked at. One that was zero at an event may be so again very soon.
std::vector<double> places_to_look(bool after_event) {
  std::vector<double> places;
  for (double part = 1e-7; after_event && part < 1.0 / inner_points; part *= 10) places.push_back(part);
  for (int i = 1; i <= inner_points + 1; ++i) places.push_back(i / (inner_points + 1.0));
  std::ranges::sort(places);
  return places;
}

}  // namespace

// Part of the step after which functions have changed their sign, as far as the Hermite polynomial tells; negative: none. `seen` becomes
// what is known of them at the last place before, at part `before`.
double Solver::look_into_step(const State& end, EventWatch& seen, double& before) {
  StepInterpolation between;
  between.prepare(*system_, start_of_step(), end, false, false);
  const double start = start_of_step().time, h = end.time - start;
  const auto values_at = [&](double part) {
    if (part == 1) current() = end;
    else between.evaluate(start + part * h, current());
    return event_values();
  };
  double found = -1;
  before = 0;
  for (const double part : places_to_look(seen.just_after_event())) {
    const std::vector<EventValue> values = values_at(part);
    const auto changed = seen.changed(values);
    if (changed.empty()) {
      seen.go_on(values);
      before = part;
      continue;
    }
    const int event = changed.front().number;
    const int sign_before = sign(seen.at_start(event));
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

// After a step has been solved: it ends with the first event, on its far side. False: a step on the way has failed.
bool Solver::end_with_event() {
  if (!hooks().events) return true;
  EventWatch& watch = *watch_;
  watch.events.clear();
  std::vector<EventValue> values = event_values();
  watch.require_as_many(values.size());
  const State end = current();
  const double whole = end.time - start_of_step().time, next = it.currentStepSize;
  EventWatch seen = watch;
  double before = 0;
  const double guess = look_into_step(end, seen, before);
  if (guess < 0) {
    watch = std::move(seen);
    return true;
  }
  watch.regular_step_size = it.automaticStepSize ? std::min(next, std::max(whole, it.minStepSize)) : next;
  const double close = std::max(1e-11 * whole, 8 * std::numeric_limits<double>::epsilon() * std::abs(end.time));
  double a = before * whole, b = whole, x = std::clamp(guess * whole + close, close, whole);
  std::vector<Bracket> brackets;
  for (std::size_t i = 0; i < values.size(); ++i) brackets.push_back({.a = a, .b = b, .at_a = seen.at_start(static_cast<int>(i)), .at_b = values[i].value});
  watch.events = seen.changed(values);
  bool beyond = !watch.events.empty();
  for (int i = 0; i < most_solutions; ++i) {
    if (x < b || watch.events.empty()) {
      if (!solve_again(x)) return false;
      values = event_values();
      const auto changed = seen.changed(values);
      beyond = !changed.empty();
      if (beyond) watch.events = changed;
      (beyond ? b : a) = x;
      for (std::size_t k = 0; k < brackets.size(); ++k) brackets[k].take(x, values[k].value, beyond);
    }
    if (watch.events.empty()) {  // the polynomial was wrong
      if (!solve_again(whole)) return false;
      it.currentStepSize = next;
      watch.go_on(event_values());
      return true;
    }
    double root = b;
    for (const EventWatch::Event& event : watch.events) root = std::min(root, brackets[static_cast<std::size_t>(event.number)].estimate());
    if (b - std::max(root, a) <= 2 * close || b - a <= 2 * close) break;
    x = std::clamp(root + close, a + close, b - close);
  }
  if (!beyond) {
    if (!solve_again(b)) return false;
    watch.events = seen.changed(event_values());
  }
  it.currentStepSize = watch.regular_step_size;
  return true;
}

bool Solver::event_reached() const {
  return !watch_->events.empty() || (hooks().schedule && it.currentTime >= hooks().schedule->next());
}

// At the end of a step, which has been written: actions of the user, and a new start from the state that they leave.
[[gnu::noinline]] void Solver::act_on_events() {
  EventWatch& watch = *watch_;
  const double time = current().time;
  if (hooks().schedule && time >= hooks().schedule->next()) act_as_scheduled();
  if (watch.events.empty()) return;
  it.eventsCount += static_cast<StepCount>(watch.events.size());
  watch.in_a_row = time - watch.last_time <= watch.regular_step_size ? watch.in_a_row + 1 : 0;
  watch.last_time = time;
  for (const EventWatch::Event& event : watch.events) {
    if (verbose(2)) say(2, "  event " + std::to_string(event.number) + (event.direction > 0 ? " (rising)" : " (falling)") + position_text() + "\n");
    if (!hooks().event_action) continue;
    const TimedPart part(timer, timer.python);
    if (hooks().event_action(time, event.number, event.direction)) continue;
    say(1, "EventActionUserFunction returned False: the solver stops\n");
    stop_ = output.simulationStoppedByUserFunction = true;
  }
  if (hooks().event_action) {
    conv.jacobianUpdateRequested = true;
    renew_accelerations();
  }
  if (watch.in_a_row >= most_in_a_row) {
    conv.stepReductionFailed = true;
    Diagnosis& d = diagnose(FailureReason::event_chatter);
    d.advice = {"event " + std::to_string(watch.events.front().number) + " of mbs.EventsUserFunction has come " + std::to_string(most_in_a_row) +
                    " times, each within a step of the one before: let its action end what repeats ever faster, for example bring the "
                    "body to rest below a small velocity",
                "check that the action does not leave the value of the event function at zero"};
  }
  watch.events_over(event_values());
}

}  // namespace dalembert
