// Diagnosis of failures.
#include "diagnosis/diagnostics.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <numeric>
#include <utility>

#include "constraints/constraint_states.hpp"
#include "dalembert/model/model.hpp"
#include "dalembert/output/numbers.hpp"
#include "dalembert/solvers/constrained_motion.hpp"
#include "dalembert/solvers/constraint_solver.hpp"
#include "dalembert/solvers/open_constraints.hpp"
#include "constraints/dependent_equations.hpp"
#include "diagnosis/finite.hpp"
#include "constraints/singular_positions.hpp"
#include "observers/output_writer.hpp"

namespace dalembert {

namespace {

constexpr std::size_t most_named = 5, most_items = 10;

struct Part {
  const char* name;  // as in methods of systemData
  std::vector<double> State::* vector;
};
// Causes are listed before their consequences.
constexpr Part parts[] = {{"Data", &State::data}, {"ODE2", &State::q},    {"ODE2_t", &State::v},  {"ODE1", &State::y},
                          {"AE", &State::lambda}, {"ODE2_tt", &State::a}, {"ODE1_t", &State::y_t}};

int first_row_of(const Sizes& sizes, std::vector<double> State::* vector) {
  if (vector == &State::y || vector == &State::y_t) return sizes.ode2;
  return vector == &State::lambda ? sizes.first_ae() : 0;
}

// Outputs of connectors and joints that act on their markers.
constexpr OutputVariableType efforts[] = {OutputVariableType::Force, OutputVariableType::Torque,
                                          OutputVariableType::ForceLocal, OutputVariableType::TorqueLocal};

// Returns whether `read(values)` gives a number that is not finite. Outputs that cannot be read are not a cause.
template <class Read>
bool gives_not_finite(Read&& read) {
  std::vector<double> values;
  try {
    read(values);
  } catch (const std::exception&) {
    return false;
  }
  return !all_finite(values);
}

// Returns one line per item with its equations. Descriptions of equations of one item differ after the last blank only.
std::vector<std::string> describe_equations(const System& system, std::span<const int> rows) {
  std::vector<std::string> lines;
  std::string item, numbers, text;
  const auto finish = [&] {
    if (!numbers.empty()) lines.push_back("rows " + numbers + ": " + text);
  };
  for (const int row : rows) {
    const std::string described = system.describe_row(row);
    const auto blank = described.rfind(' ');
    if (const std::string owner = described.substr(0, blank); owner == item) {
      numbers += ", " + std::to_string(row);
      text += "," + described.substr(blank);
    } else {
      finish();
      item = owner;
      numbers = std::to_string(row);
      text = described;
    }
  }
  finish();
  return lines;
}

}  // namespace

std::string indented(std::vector<std::string> lines) {
  shorten(lines);
  std::string text;
  for (const std::string& line : lines) text += "\n  " + line;
  return text;
}

void shorten(std::vector<std::string>& lines) {
  if (lines.size() <= most_items) return;
  const std::size_t more = lines.size() - most_items;
  lines.resize(most_items);
  lines.push_back("and " + std::to_string(more) + " more");
}

void Diagnostics::begin() {
  contradiction_text_.clear();
  closing_at_start_.clear();
}

Diagnosis& Diagnostics::diagnose(FailureReason reason) {
  diagnosis_ = Diagnosis();
  Diagnosis& d = diagnosis_;
  d.reason = reason;
  d.solver = name();
  d.step = it.currentStepIndex;
  d.newton_iteration = it.newtonSteps;
  d.time = it.currentTime;
  d.step_size = it.currentStepSize;
  d.load_factor = is_static() ? solver_.load_factor() : 1;
  d.residual = conv.residual;
  d.relative_residual = solver_.initial_residual_ > 0 ? conv.residual / solver_.initial_residual_ : 0;
  d.tolerance_relative = solver_.newton_settings.relativeTolerance;
  d.tolerance_absolute = solver_.newton_settings.absoluteTolerance;
  if (conv.linearSolverFailed && conv.linearSolverCausingRow >= 0) {
    d.singular_row = conv.linearSolverCausingRow;
    if (settings().linearSolverSettings.showCausingItems) d.singular_items = system().describe_row(d.singular_row);
    d.advice = {
        "look for redundant constraints, coordinates without mass or stiffness, and zero parameters at these items",
        settings().redundantConstraints.treat
            ? "hold what can move without inertia or stiffness, by a constraint or a weak spring: redundant "
              "constraints alone are no obstacle"
            : "use redundantConstraints.treat=True to go on with redundant constraints"};
  }
  return d;
}

void Diagnostics::diagnose(FailureReason reason, std::span<const double> residual) {
  Diagnosis& d = diagnose(reason);
  if (reason == FailureReason::discontinuous) {
    d.residual = conv.discontinuousIterationError;
    d.newton_iteration = it.discontinuousIteration;
    d.relative_residual = d.tolerance_relative = 0;
    d.tolerance_absolute = solver_.discontinuous.iterationTolerance;
  }
  add_largest(d.values, residual, "equation", 0);
  d.advice.push_back(is_static() ? "use more load steps (staticSolver.numberOfLoadSteps)"
                                 : "use smaller steps (timeIntegration.numberOfSteps)");
  d.advice.push_back("check initial values, and parameters of the items named above for wrong units");
  if (solver_.newton_settings.useModifiedNewton) d.advice.push_back("use full Newton (newton.useModifiedNewton=False)");
  if (reason == FailureReason::discontinuous) d.advice.push_back("allow more discontinuous.maxIterations");
}

[[gnu::noinline]] void Diagnostics::diagnose_singular_matrix(const Pattern& pattern, std::span<const double> values) {
  std::vector<int> free = free_unknowns(pattern, values);
  std::erase_if(free, [this](int row) { return row >= sizes_.first_ae(); });
  diagnose(free.empty() ? FailureReason::singular_matrix : FailureReason::free_direction);
  if (!settings().linearSolverSettings.showCausingItems) return;
  diagnosis_.free = describe_equations(system(), free);
  diagnosis_.dependent = describe_equations(system(), dependent_equations(pattern, values));
}

[[gnu::noinline]] void Diagnostics::warn_of_free_motion(std::span<const int> rows) {
  warn(name() + ": other states are in balance as well, as nothing resists a motion of:" +
       indented(describe_equations(system(), rows)) +
       "\n  Hold it by a constraint or a weak spring, unless any of these states will do.");
}

[[gnu::noinline]] void Diagnostics::warn_of_instability(int directions, std::span<const int> rows) {
  warn(name() + ": the equilibrium is unstable: the smallest disturbance leaves it in " + std::to_string(directions) +
       (directions == 1 ? " direction" : " directions, one of them") +
       " with its largest share in:" + indented(describe_equations(system(), rows)) +
       "\n  For a stable equilibrium, begin with initial values or a small load that moves the system to that side, or "
       "use SolveDynamic with damping.");
}

[[gnu::noinline]] void Diagnostics::warn_of_velocities(std::span<const int> rows, double largest_force) {
  warn(name() +
       ": velocities are not zero, and what answers them (damping, inertia) is part of this balance, with up to " +
       number(largest_force) + " in:" + indented(describe_equations(system(), rows)) +
       "\n  For an equilibrium at rest, begin without velocities (initialVelocities, "
       "mbs.systemData.SetODE2Coordinates_t).");
}

[[gnu::noinline]] void Diagnostics::diagnose_open_gaps() {
  std::vector<double> gaps(static_cast<std::size_t>(sizes_.ae));
  system().gaps(current(), conditions_, gaps);
  const ConstraintSolver& constraints = constraint_solver();
  if (!solver_.rank_known_) solver_.find_rank(start_of_step());
  if (constraints.active() && solver_.constraint_rank().count() > 0) {
    const std::vector<double> misfit = solver_.constraint_rank().misfit(gaps);
    if (2 * constraints.largest(misfit) > constraints.largest(gaps)) return diagnose_contradiction(misfit);
  }
  if (solver_.singular_->has_weak_constraints()) return solver_.singular_->report();
  Diagnosis& d = diagnose(FailureReason::open_constraints);
  add_largest(d.values, gaps, "equation", sizes_.first_ae());
  d.advice = {"use smaller steps (timeIntegration.numberOfSteps, minimumStepSize)",
              "check initial values of the items named above: mbs.ComputeConsistentInitialConditions() finds some that "
              "fulfil all constraints"};
}

// Returns whether joints opened by the motion: they fitted at the start, and are not driven. Velocity constraints are
// not conclusive, because their residuals are not gaps of positions. Static solutions close gaps of the start.
bool Diagnostics::has_left_constraints(std::span<const double> misfit) {
  return have_fitted(is_static() ? start_of_step() : initial(), misfit) &&
         std::ranges::none_of(driven_equations(system(), initial(), conditions_, solver_.last_time()),
                              [](char d) { return d != 0; });
}

bool Diagnostics::have_fitted(const State& at, std::span<const double> misfit) {
  constexpr double none = 1e-3;
  const ConstraintSolver& constraints = constraint_solver();
  const auto apart = [&](const State& state) {
    return constraints.largest(gaps_of_positions(system(), state, conditions_));
  };
  return apart(at) < none * (conditions_.rate_level ? apart(current()) : constraints.largest(misfit));
}

[[gnu::noinline]] void Diagnostics::diagnose_contradiction(std::span<const double> misfit) {
  // An action may have closed an inconsistent joint.
  const bool begun_before =
      solver_.largest_misfit_ > ConstraintSolver::silent_misfit || have_fitted(start_of_step(), misfit);
  if (begun_before && has_left_constraints(misfit)) {
    Diagnosis& d = diagnose(FailureReason::open_constraints);
    add_largest(d.values, misfit, "equation", sizes_.first_ae());
    if (is_static()) {
      d.advice = {
          "joints have fitted together before this step; Newton's method has gone to where they do not: use more load "
          "steps "
          "(staticSolver.numberOfLoadSteps), which may become as small as staticSolver.minimumStepSize says",
          "where the mechanism is to snap through, or has to swing far, find the equilibrium by a dynamic solution "
          "with damping"};
      return;
    }
    d.advice = {
        "joints have fitted together at the start; the motion has left what they allow, more with each step: use "
        "smaller steps "
        "(timeIntegration.numberOfSteps), or numerical damping (generalizedAlpha.spectralRadius below 1)",
        "let steps end on the constraints (exu.DynamicSolverType.ESDIRK43, DOPRI5)",
        "see how far the energy has drifted (mbs.Report())"};
    return;
  }
  if (!solver_.rank_known_) solver_.find_rank(start_of_step());
  Diagnosis& d = diagnose(FailureReason::contradiction);
  add_largest(d.values, misfit, "equation", sizes_.first_ae());
  d.dependent = solver_.constraint_rank().contradictions(misfit, system());
  d.advice = {
      "move or turn the markers of the joints named above until they fit, or free equations that others state as well",
      "if a gap of this size is meant, raise redundantConstraints.largestMisfit (relative to the size of the "
      "mechanism)"};
}

// Warns with one line per item: its equation with the largest residual.
[[gnu::noinline]] void Diagnostics::warn_of_contradiction(std::span<const double> misfit) {
  if (!contradiction_text_.empty() || (is_static() && has_left_constraints(misfit))) return;
  const ConstraintSolver& constraints = constraint_solver();
  std::vector<std::string> lines;
  for (const System::EquationOwner& owner : system().equation_owners()) {
    int worst = -1;
    double largest = ConstraintSolver::silent_misfit;
    for (int k = owner.first; k < owner.first + owner.count; ++k) {
      const double size = std::abs(misfit[static_cast<std::size_t>(k)]) / constraints.unit(k);
      if (size > largest) {
        largest = size;
        worst = k;
      }
    }
    if (worst >= 0)
      lines.push_back(system().describe(owner) + ", equation " + std::to_string(worst - owner.first) + ": " +
                      format_number(misfit[static_cast<std::size_t>(worst)]));
  }
  const char* text = has_left_constraints(misfit)
                         ? "the motion leaves what redundant constraints allow, although they have fitted together at "
                           "the start; by now by:"
                         : "redundant constraints contradict each other; what the closest fit leaves open:";
  contradiction_text_ = text + indented(std::move(lines));
  if (is_static())
    contradiction_text_ +=
        "\n  Forces that these joints exert on each other are not determined: their reactions are uncertain";
  warn(name() + ": " + contradiction_text_);
}

// Adds advice if round-off hides redundant constraints, so that it was amplified. Gaps of joints may hide them as well,
// and have their own warning.
[[gnu::noinline]] void Diagnostics::advise_on_weak_constraints() {
  if (!solver_.rank_known_) solver_.find_rank(start_of_step());
  const ConstraintRank& constraints = solver_.constraint_rank();
  if (constraints.certain() || constraints.allows_for_gaps()) return;
  Diagnosis& d = diagnosis_;
  if (d.dependent.empty()) {
    for (const auto& item : constraints.items(system()))
      d.dependent.push_back(item.item + ": " + std::to_string(item.removable) + " of " +
                            std::to_string(item.equations) + " could be left out");
    shorten(d.dependent);
  }
  d.advice.insert(d.advice.begin(),
                  "some constraint equations are hardly independent of others (by " + number(constraints.weakest()) +
                      "), so that round-off may hide which are redundant: free equations that others state as well "
                      "(mbs.ComputeSystemDegreeOfFreedom() lists them by object), or make one body of those that "
                      "cannot move against each other");
}

void Diagnostics::add_largest(std::vector<NamedValue>& list, std::span<const double> numbers, const char* vector,
                              int first_row) const {
  const auto larger = [](double x, double y) {  // by magnitude; NaN first
    if (std::isnan(x) || std::isnan(y)) return std::isnan(x) && !std::isnan(y);
    return std::abs(x) > std::abs(y);
  };
  std::vector<int> order(numbers.size());
  std::iota(order.begin(), order.end(), 0);
  const auto count = std::min(order.size(), most_named);
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), order.end(),
                    [&](int i, int j) { return larger(numbers[i], numbers[j]); });
  for (const int i : std::span(order).first(count)) {
    if (numbers[i] != 0) list.push_back({i, numbers[i], vector, system().describe_row(first_row + i)});
  }
  std::ranges::stable_sort(list, larger, &NamedValue::value);
  list.resize(std::min(list.size(), most_named));
}

std::vector<NamedValue> Diagnostics::not_finite(const State& state) const {
  std::vector<NamedValue> found;
  for (const Part& part : parts) {
    const std::vector<double>& numbers = state.*part.vector;
    if (all_finite(numbers)) continue;
    for (std::size_t i = 0; i < numbers.size() && found.size() < most_named; ++i) {
      if (std::isfinite(numbers[i])) continue;
      const int index = static_cast<int>(i);
      found.push_back({index, numbers[i], part.name,
                       part.vector == &State::data ? describe_data(index)
                                                   : system().describe_row(first_row_of(sizes_, part.vector) + index)});
    }
  }
  return found;
}

std::string Diagnostics::describe_data(int index) const {
  if (model() == nullptr) return "";
  for (int node = 0; node < model()->count(ItemKind::node); ++node) {
    const std::vector<int> own = system().node_ltg(node, System::Coordinates::data);
    if (const auto at = std::ranges::find(own, index); at != own.end())
      return model()->describe(ItemKind::node, node) + ", data coordinate " + std::to_string(at - own.begin());
  }
  return "";
}

void Diagnostics::diagnose_not_finite(std::span<const double> residual) {
  std::vector<NamedValue> values = not_finite(current());
  const bool follows = values.empty() || values.front().vector == "ODE2_tt" || values.front().vector == "ODE1_t";
  std::vector<std::string> sources;
  if (follows) sources = sources_of_not_finite();
  if (values.empty()) add_largest(values, residual, "equation", 0);
  const bool finite = std::ranges::all_of(values, [](const NamedValue& v) { return std::isfinite(v.value); });
  Diagnosis& d = diagnose(finite ? FailureReason::unbounded : FailureReason::not_finite);
  d.values = std::move(values);
  d.sources = std::move(sources);
  d.singular_row = -1;
  d.advice.clear();
  if (it.currentStepIndex > 0) solver_.advise_on_growth();
  d.advice.push_back(
      "check initial values, parameters and user functions of the items named above: divisions by zero, roots of "
      "negative "
      "numbers, wrong units");
}

// Returns loads and connectors with values that are not finite although the coordinates are finite.
std::vector<std::string> Diagnostics::sources_of_not_finite() {
  std::vector<std::string> found;
  const Model* items = model();
  if (items == nullptr) return found;
  const auto ask = [&](ItemKind kind, int number, auto&& read) {
    if (found.size() < most_named && gives_not_finite(read)) found.push_back(items->describe(kind, number));
    return found.size() < most_named;
  };
  for (int i = 0; i < items->count(ItemKind::load); ++i) {
    if (!ask(ItemKind::load, i, [&](std::vector<double>& x) { system().load_values(i, current().time, x); }))
      return found;
  }
  for (int i = 0; i < items->count(ItemKind::object); ++i) {
    const auto outputs = items->item(ItemKind::object, i).type->outputs;
    const auto effort = std::ranges::find_first_of(outputs, efforts);
    if (effort == outputs.end()) continue;
    if (!ask(ItemKind::object, i,
             [&](std::vector<double>& x) { system().object_output(i, *effort, ConfigurationType::Current, x); }))
      break;
  }
  return found;
}

bool Diagnostics::starts_finite() {
  const State& first = system().state(ConfigurationType::Initial);
  std::vector<NamedValue> values = not_finite(first);
  if (values.empty()) return true;
  it.currentTime = is_static() ? settings().staticSolver.loadStepStart : settings().timeIntegration.startTime;
  Diagnosis& d = diagnose(FailureReason::not_finite);
  d.values = std::move(values);
  d.advice = {
      "set finite initial values: initialCoordinates and initialVelocities of the nodes named above, or "
      "mbs.systemData.SetODE2Coordinates(..., exu.ConfigurationType.Initial) and its siblings"};
  return false;
}

[[gnu::noinline]] void Diagnostics::time_is_over() {
  stop_ = output.simulationTimeout = true;
  const std::string limit = format_number(hooks().timeout) + " seconds";
  diagnose(FailureReason::time_limit).advice = {
      "raise exu.special.solver.timeout (" + limit + "), or set it to -1 for no limit",
      "go on from the state that was reached: updateInitialValues and timeIntegration.startTime"};
  warn(name() + ": the time limit of " + limit + " (exu.special.solver.timeout) is reached at time " +
       format_number(it.currentTime) + ", before the end of the simulation: the solver stops");
}

// Static solvers are allowed to close gaps.
void Diagnostics::check_constraints() {
  const auto& s = settings().initialConditions;
  if (!s.checkConstraints || sizes_.ae == 0 || !solver_.enforces_constraints()) return;
  const auto open =
      open_constraints(system(), current(), conditions_, {s.positionTolerance, s.velocityTolerance, !is_static()});
  if (open.empty()) return;
  const bool any_rate = std::ranges::any_of(open, &OpenConstraint::of_rate),
             any_gap = !std::ranges::all_of(open, &OpenConstraint::of_rate);
  std::string text = name() + ": the initial values contradict " + listed(open, system()) + "\n ";
  if (any_gap && is_static()) text += " The load steps close the gaps.";
  if (any_gap && !is_static()) {
    text += conditions_.rate_level ? " Gaps stay: velocities alone are constrained here."
                                   : " Gaps close in the first step, with large velocities and forces.";
  }
  if (any_rate) text += " Velocities against constraints vanish in the first step.";
  text +=
      " mbs.ComputeConsistentInitialConditions() finds initial values that fulfil all constraints; "
      "simulationSettings.initialConditions says what is tolerated.";
  if (s.inconsistentIsError) throw ModelError(ErrorKind::value, text);
  if (is_static())
    say(1, text + "\n");
  else
    warn(text);
}

// A first step that closes larger gaps than the tolerances has large errors, independently of the step size.
[[gnu::noinline]] void Diagnostics::look_for_gaps_at_start() {
  if (sizes_.ae == 0 || !solver_.enforces_constraints()) return;
  const double tolerance = settings().timeIntegration.absoluteTolerance;
  const auto open = open_constraints(system(), initial(), conditions_, {tolerance, tolerance, true});
  if (open.empty()) return;
  closing_at_start_ = "the first steps close what initial values leave open by more than the tolerances, of " +
                      listed(open, system()) + "\n  ";
  closing_at_start_ += contradiction_text_.empty()
                           ? "Begin with mbs.ComputeConsistentInitialConditions(), or allow larger errors"
                           : "No state fulfils all: " + contradiction_text_ +
                                 "\n  Move or turn the markers of these joints until they fit, free equations that "
                                 "others state as well, or allow larger errors";
}

}  // namespace dalembert
