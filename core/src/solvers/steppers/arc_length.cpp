// Arc-length continuation of static equilibria: M. A. Crisfield, A fast incremental/iterative solution procedure that
// handles "snap-through", 1981. The constraint is linear: a plane normal to the tangent at the start of the step (E.
// Riks, 1979; H. B. Keller, 1977).
#include "steppers/arc_length.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dalembert/model/errors.hpp"
#include "dalembert/solvers/static.hpp"
#include "diagnosis/diagnostics.hpp"

namespace dalembert {

namespace {

// Part of the duration, for the finite difference of the residual with respect to the load; most loads are linear in
// it.
constexpr double probe = 1e-5;
// Largest ratio of the lengths of successive steps.
constexpr double most_growth = 2;
// Smallest correlation of a mode in two states.
constexpr double same_direction = 0.3;
// A singular point is located if its eigenvalue is this small relative to the ends of the step, or its position this
// accurate.
constexpr double small_eigenvalue = 1e-8, small_length = 1e-10;
constexpr int most_trials = 40;
// At a limit point, the rate of the load is this small relative to the start of the step.
constexpr double standstill = 1e-4;

double norm(std::span<const double> x) { return std::sqrt(dalembert::dot(x, x)); }

}  // namespace

StaticSolver::StaticSolver() = default;
StaticSolver::~StaticSolver() = default;

void StaticSolver::begin_path() {
  path_.reset();
  path_ends_ = nullptr;
  singular_points_.clear();
  least_initial_residual_ = 0;
  if (!options_.arcLength.active) return;
  const auto refuse = [](const std::string& text) {
    throw ModelError(ErrorKind::value, "staticSolver.arcLength.active: received True with " + text);
  };
  if (options_.loadStepGeometric)
    refuse("loadStepGeometric=True; the lengths of steps are not known before. Use loadStepGeometric=False.");
  if (options_.stabilizerODE2term != 0)
    refuse("stabilizerODE2term, which is made for falling loads. Use stabilizerODE2term=0.");
  if (continues())
    refuse(
        "continuation.restartFileName; restart files do not have the direction of the path. Start from the initial "
        "values.");
  if (sizes_.ode2 == 0) refuse("a system without second order coordinates, whose displacements give the length.");
  path_ = std::make_unique<Path>();
  path_ends_ = &path_->at_end;
}

// A step uses the results at the end of the previous one.
void StaticSolver::begin_path_step() {
  Path& path = *path_;
  if (path.has_next && it.currentStepIndex != path.step) {
    path.tangent = std::move(path.next);
    path.start_modes = std::move(path.end_modes);
    path.has_next = false;
    const double length = path.next_length / path.length_scale, rate = path.tangent.rate;
    steps_.use(rate == 0 ? length : std::min(length, it.maxStepSize / std::abs(rate) / path.length_scale));
  }
  path.step = it.currentStepIndex;
  path.end_known = false;
  set_quasi_time(it.currentTime +
                 (path.begun ? path.tangent.rate * path.length_scale * it.currentStepSize : it.currentStepSize));
}

// Computes the derivative of the residual with respect to quasi-time, in the current state.
std::vector<double> StaticSolver::residual_by_quasi_time() {
  const double time = it.currentTime, step = probe * options_.loadStepDuration;
  std::vector<double> kept = residual_;
  set_quasi_time(time + step);
  compute_residual();
  std::vector<double> rate = residual_;
  set_quasi_time(time);
  compute_residual();
  for (std::size_t i = 0; i < rate.size(); ++i) rate[i] = (rate[i] - residual_[i]) / step;
  residual_.swap(kept);
  return rate;
}

// Computes the tangent with the factors of the matrix of the current state.
StaticSolver::PathTangent StaticSolver::path_tangent() {
  PathTangent tangent;
  std::vector<double> response = residual_by_quasi_time();
  tangent.load = norm_of(response);
  linear_->solve(response);
  const double size = norm(displacements(response));
  for (double& number : response) number /= -size;
  tangent.direction = std::move(response);
  tangent.rate = 1 / size;
  return tangent;
}

std::span<const double> StaticSolver::displacements(std::span<const double> unknowns) const {
  return unknowns.first(static_cast<std::size_t>(sizes_.ode2));
}

void StaticSolver::find_modes() {
  if (!options_.arcLength.singularPoints) return;
  const auto solve = [this](std::span<double> x) { linear_->solve(x); };
  path_->modes.find(solve, static_cast<std::size_t>(sizes_.ode2), static_cast<std::size_t>(sizes_.total()));
}

// Computes the tangent in the initial state. Returns false, with the flags set, if there is none.
bool StaticSolver::find_first_tangent() {
  Path& path = *path_;
  set_quasi_time(start_of_step().time);
  compute_jacobian();
  if (!factorize()) {
    conv.stopNewton = true;
    return false;
  }
  path.tangent = path_tangent();
  if (!std::isfinite(path.tangent.rate)) {
    throw ModelError(
        ErrorKind::state,
        name() +
            ": staticSolver.arcLength needs loads that move the system at the start of the path; none does. "
            "Add loads, or give the load that depends on time a value that grows from the beginning.");
  }
  path.length_scale = 1 / path.tangent.rate;
  find_modes();
  path.start_modes = path.modes.modes();
  path.begun = true;
  return true;
}

// Moves along the tangent, or to the end of the path between the previous states.
void StaticSolver::predict_on_path() {
  Path& path = *path_;
  if (!path.begun && !find_first_tangent()) return;
  least_initial_residual_ = path.tangent.load * options_.loadStepDuration / static_cast<double>(it.numberOfSteps);
  current().lambda = start_of_step().lambda;
  if (path.end_known) {
    std::vector<double> step = path.moved;
    for (double& number : step) number *= path.share;
    move(step);
    set_quasi_time(path.end_time);
    return;
  }
  path.length = path.length_scale * it.currentStepSize;
  path.moved = path.tangent.direction;
  for (double& number : path.moved) number *= path.length;
  move(path.moved);
  set_quasi_time(start_of_step().time + path.tangent.rate * path.length);
}

// Combines the increment of Newton's method and the response to the load such that the step keeps its length.
void StaticSolver::correct_on_path() {
  Path& path = *path_;
  std::vector<double> response = residual_by_quasi_time();
  linear_->solve(response);
  const std::span<const double> along = displacements(path.tangent.direction);
  const double excess = dot(along, displacements(path.moved)) - dot(along, displacements(increment_)) - path.length;
  const double change = excess / dot(along, displacements(response));
  for (std::size_t i = 0; i < response.size(); ++i) {
    increment_[i] += change * response[i];
    response[i] = -increment_[i];
    path.moved[i] += response[i];
  }
  move(response);
  set_quasi_time(it.currentTime + change);
}

bool StaticSolver::discontinuous_iteration() {
  if (!path_) return Solver::discontinuous_iteration();
  if (!Solver::discontinuous_iteration()) return false;
  const double lowest = it.startTime + options_.arcLength.lowestLoadFactor * options_.loadStepDuration;
  const double length = next_length();
  if (!factorize_at_end()) return false;
  find_modes();
  const Crossing crossing = find_crossing();
  if (crossing.found && !go_to_singular_point(crossing)) return false;
  if (it.currentTime >= it.endTime) return end_path_at(it.endTime);
  if (it.currentTime <= lowest) return end_path_at(lowest);
  prepare_next_step(crossing, length);
  if (it.currentStepIndex >= static_cast<StepCount>(options_.arcLength.maximumSteps)) {
    conv.stepReductionFailed = true;
    diagnostics_->diagnose(FailureReason::path_length).advice = {
        "allow more steps (staticSolver.arcLength.maximumSteps), or longer ones (staticSolver.numberOfLoadSteps, "
        "arcLength.largestStep)",
        "end the path where the load has fallen (staticSolver.arcLength.lowestLoadFactor)"};
  }
  return true;
}

bool StaticSolver::writes_each_step() const { return path_ != nullptr; }

// Repeats the last step, which was too long, with the given load.
bool StaticSolver::end_path_at(double time) {
  Path& path = *path_;
  path.share = (time - start_of_step().time) / (it.currentTime - start_of_step().time);
  path.end_time = time;
  path.end_known = true;
  path.at_end = solve_step_again();
  return path.at_end;
}

bool StaticSolver::solve_step_again() {
  current() = start_of_step();
  if (system().searches()) system().restore_history();
  return Solver::discontinuous_iteration();
}

bool StaticSolver::factorize_at_end() {
  compute_jacobian();
  if (factorize()) return true;
  conv.linearSolverFailed = false;  // the repeated step ends in another state
  return false;
}

void StaticSolver::prepare_next_step(const Crossing& crossing, double length) {
  Path& path = *path_;
  path.next = path_tangent();
  orient(path.next);
  path.end_modes = path.modes.modes();
  path.next_length = length;
  if (crossing.found) pass_singular_point(crossing);
  path.has_next = true;
}

// Selects the sign of the tangent that continues the path.
void StaticSolver::orient(PathTangent& tangent) const {
  if (dot(displacements(tangent.direction), displacements(path_->tangent.direction)) >= 0) return;
  for (double& number : tangent.direction) number = -number;
  tangent.rate = -tangent.rate;
}

double StaticSolver::next_length() const {
  const double growth =
      std::sqrt(static_cast<double>(options_.arcLength.desiredIterations) / std::max(useful_iterations(), 1));
  const double length = path_->length * std::clamp(growth, 1 / most_growth, most_growth);
  return options_.arcLength.largestStep > 0 ? std::min(length, options_.arcLength.largestStep) : length;
}

// Finds a mode whose eigenvalue has changed its sign.
StaticSolver::Crossing StaticSolver::find_crossing() const {
  Crossing crossing;
  for (const NearestModes::Mode& now : path_->modes.modes()) {
    const NearestModes::Mode* before = nullptr;
    double likeness = same_direction;
    for (const NearestModes::Mode& mode : path_->start_modes) {
      const double like = std::abs(dot(mode.vector, now.vector));
      if (like > likeness) {
        likeness = like;
        before = &mode;
      }
    }
    if (before == nullptr || !(before->eigenvalue * now.eigenvalue < 0)) continue;
    crossing = {.found = true, .before = before->eigenvalue, .after = now.eigenvalue, .mode = now.vector};
    break;
  }
  return crossing;
}

// Shortens the step until it ends at the singular point, by regula falsi in the form of M. Dowell and P. Jarratt, 1971
// ("Illinois").
bool StaticSolver::go_to_singular_point(const Crossing& crossing) {
  Path& path = *path_;
  double low = 0, high = path.length, at_low = crossing.before, at_high = crossing.after;
  const double negligible = small_eigenvalue * std::max(std::abs(at_low), std::abs(at_high)), whole = high;
  for (int trial = 0; trial < most_trials && high - low > small_length * whole; ++trial) {
    const double length = (low * at_high - high * at_low) / (at_high - at_low);
    steps_.use(length / path.length_scale);
    if (!solve_step_again() || !factorize_at_end()) return false;
    find_modes();
    const NearestModes::Mode* mode = NearestModes::most_like(path.modes.modes(), crossing.mode);
    if (mode == nullptr) return false;
    const double value = mode->eigenvalue;
    if (std::abs(value) <= negligible) break;
    if ((value < 0) == (crossing.after < 0)) {
      if (high < whole) at_low /= 2;
      high = length;
      at_high = value;
    } else {
      if (low > 0) at_high /= 2;
      low = length;
      at_low = value;
    }
  }
  return true;
}

// The matrix is singular at this point: the path continues along its previous direction, or along the null vector to
// the branch.
void StaticSolver::pass_singular_point(const Crossing& crossing) {
  Path& path = *path_;
  NearestModes::Mode& found = *NearestModes::most_like(path.end_modes, crossing.mode);
  found.eigenvalue = std::numeric_limits<double>::quiet_NaN();  // NaN: no change of sign is possible
  const bool along_mode = std::abs(dot(displacements(path.next.direction), found.vector)) > std::sqrt(0.5);
  SingularPoint point{.step = it.currentStepIndex, .load_factor = load_factor(), .limit = false, .mode = found.vector};
  point.limit = along_mode && std::abs(path.next.rate) < standstill * std::abs(path.tangent.rate);
  const double largest = *std::ranges::max_element(point.mode, {}, [](double x) { return std::abs(x); });
  for (double& number : point.mode) number /= largest;
  if (!point.limit) leave_bifurcation(point.mode);
  if (verbose(1)) {
    say(1, std::string("  ") + (point.limit ? "limit" : "bifurcation") + " point at load factor " +
               number(point.load_factor) + "\n");
  }
  singular_points_.push_back(std::move(point));
}

void StaticSolver::leave_bifurcation(std::span<const double> mode) {
  Path& path = *path_;
  const double branch = options_.arcLength.branchStep;
  if (branch == 0 || path.branched) {
    path.next.direction = path.moved;
    const double size = norm(displacements(path.moved));
    for (double& number : path.next.direction) number /= size;
    path.next.rate = (it.currentTime - start_of_step().time) / size;
    return;
  }
  path.branched = true;
  const double size = norm(mode);
  path.next.direction.assign(static_cast<std::size_t>(sizes_.total()), 0.0);
  for (std::size_t i = 0; i < mode.size(); ++i) path.next.direction[i] = (branch < 0 ? -mode[i] : mode[i]) / size;
  path.next.rate = 0;
  path.next_length = std::abs(branch) * size;
}

}  // namespace dalembert
