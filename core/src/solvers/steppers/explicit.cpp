#include "dalembert/solvers/explicit.hpp"

#include <algorithm>
#include <cmath>

#include "dalembert/model/errors.hpp"
#include "dalembert/output/numbers.hpp"
#include "steppers/combination.hpp"
#include "diagnosis/finite.hpp"
#include "diagnosis/matrix_text.hpp"
#include "steppers/rotation_increments.hpp"

namespace dalembert {

namespace {

const char* type_name(DynamicSolverType type) {
  switch (type) {
    case DynamicSolverType::ExplicitEuler: return "ExplicitEuler";
    case DynamicSolverType::ExplicitMidpoint: return "ExplicitMidpoint";
    case DynamicSolverType::RK33: return "RK33";
    case DynamicSolverType::RK44: return "RK44";
    case DynamicSolverType::RK67: return "RK67";
    case DynamicSolverType::ODE23: return "ODE23";
    case DynamicSolverType::DOPRI5: return "DOPRI5";
    case DynamicSolverType::DOP853: return "DOP853";
    case DynamicSolverType::VelocityVerlet: return "VelocityVerlet";
    default: return "no explicit method";
  }
}

// Calls `keep(i)` before number i changes.
template <class Keep>
void kick_and_drift(const System& system, State& state, double h, Keep&& keep) {
  each_number(system, state.q.size(), [=, a = state.a.data(), v = state.v.data(), q = state.q.data()](std::size_t i) {
    keep(i);
    v[i] += 0.5 * h * a[i];
    q[i] += h * v[i];
  });
}
// Updates velocities and positions in one pass over memory.
void kick_and_drift_from(const System& system, State& start, State& state, double h) {
  const auto keep = [a = state.a.data(), v = state.v.data(), q = state.q.data(), start_a = start.a.data(),
                     start_v = start.v.data(), start_q = start.q.data()](std::size_t i) {
    start_a[i] = a[i];
    start_v[i] = v[i];
    start_q[i] = q[i];
  };
  kick_and_drift(system, state, h, keep);
}

}  // namespace

std::string ExplicitSolver::name() const { return std::string("explicit time integration (") + type_name(type_) + ")"; }

void ExplicitSolver::read_settings() {
  Solver::read_settings();
  options_ = settings().timeIntegration.explicitIntegration;
  reuses_masses_ = settings().timeIntegration.reuseConstantMassMatrix;
  events_of_items_ = settings().events.ofItems;
  type_ = settings().timeIntegration.solverType;
}

void ExplicitSolver::pre_initialize() {
  const auto is_explicit = [](DynamicSolverType type) {
    return type == DynamicSolverType::VelocityVerlet || runge_kutta_method(type).stages > 0;
  };
  if (!is_explicit(type_)) type_ = options_.dynamicSolverType;
  verlet_ = type_ == DynamicSolverType::VelocityVerlet;
  method_ = runge_kutta_method(type_);
  if (!verlet_ && method_.stages == 0) {
    throw ModelError(ErrorKind::value,
                     "timeIntegration.explicitIntegration.dynamicSolverType: received an implicit method; expected "
                     "ExplicitEuler, ExplicitMidpoint, RK33, RK44, RK67, ODE23, DOPRI5, DOP853 or VelocityVerlet");
  }
  rows_.clear();
  const auto stages = static_cast<std::size_t>(method_.stages);
  for (std::size_t i = 0; i < stages; ++i) rows_.push_back(that_count({method_.a.data() + i * stages, i}));
  result_ = that_count(method_.b);
  second_ = that_count(method_.b_error);
  third_ = that_count(method_.b_third);
  end_known_ = first_stage_known_ = searching_ = warned_of_stiffness_ = false;
  stiff_signs_ = calm_signs_ = 0;
  conditions_ = {.rate_level = false, .inertia = true};
}

void ExplicitSolver::initialize_data() {
  // A step ends where the state of contact changes.
  conditions_.holds_contact = events_of_items_ && system().has_switches();
  conditions_.direct = !conditions_.holds_contact;
  Solver::initialize_data();
  const auto n = static_cast<std::size_t>(sizes_.ode2), n1 = static_cast<std::size_t>(sizes_.ode1);
  const auto stages = static_cast<std::size_t>(method_.stages);
  const auto make_room = [stages](std::vector<Vector>& of_stages, std::size_t size, std::size_t first = 0) {
    of_stages.resize(stages);
    for (std::size_t s = first; s < stages; ++s) of_stages[s].assign(size, 0.0);
  };
  make_room(stage_q_, n, 1);  // the first stage has the velocities at the start
  make_room(stage_v_, n);
  make_room(stage_y_, n1);
  const bool compares = controls_step_size(), evaluates_end = !verlet_ && options_.computeEndOfStepAccelerations;
  second_q_.assign(compares ? n : 0, 0.0);
  second_v_.assign(compares ? n : 0, 0.0);
  second_y_.assign(compares ? n1 : 0, 0.0);
  end_a_.assign(evaluates_end ? n : 0, 0.0);
  end_y_t_.assign(evaluates_end ? n1 : 0, 0.0);
  lie_ = options_.useLieGroupIntegration && system().has_lie_nodes();
  all_on_group_ = lie_ && 6 * system().lie_blocks().size() == n;
}

void ExplicitSolver::post_initialize() {
  if (!controls_step_size()) it.automaticStepSize = false;
  find_eliminated_coordinates();
  State& now = current();
  if (!continues()) {
    std::fill(now.a.begin(), now.a.end(), 0.0);
    std::fill(now.y_t.begin(), now.y_t.end(), 0.0);
    std::fill(now.lambda.begin(), now.lambda.end(), 0.0);
  }
  if (!prepare_factors()) return;
  nobody_interferes_ = !system().has_discontinuities(conditions_) && !hooks().pre_step && !hooks().post_step &&
                       !hooks().post_newton && !hooks().events;
  watches_switches_ = it.automaticStepSize && !events_of_items_ && system().has_switches();
  conditions_.unseen = nobody_interferes_ && !system().calls_user_functions();
  may_move_at_once_ = nobody_interferes_ && !verlet_ && method_.stages == 1 && eliminated_.empty() &&
                      sizes_.ode1 == 0 && conditions_.unseen && static_cast<std::size_t>(sizes_.ode2) > few_numbers &&
                      !options_.computeEndOfStepAccelerations;
  if (!continues()) {
    find_first_accelerations();
    if (verlet_ && conv.linearSolverFailed) return;
    if (constrained_) find_rank();
  }
  begin_to_watch();
  if (continues()) {
    growth_limit_ = continued_number(0);
    stiff_signs_ = static_cast<int>(continued_number(1));
    calm_signs_ = static_cast<int>(continued_number(2));
    warned_of_stiffness_ = continued_number(3) != 0;
  }
  start_of_step() = now;
}

// Computes accelerations for output of the initial state and for the first step of Verlet's method. Steps of other
// methods report coordinates without mass.
void ExplicitSolver::find_first_accelerations() {
  State& now = current();
  if (system().searches() && !conditions_.direct) search();
  if (!accelerations(now.a, verlet_ ? std::span<double>() : now.y_t) && !verlet_) {
    diagnosis_ = Diagnosis();
    conv.linearSolverFailed = conv.massMatrixNotInvertible = false;
    for (auto* part : {&now.a, &now.y_t, &now.lambda}) std::ranges::fill(*part, 0.0);
  }
  eliminate(now.a);
}

void ExplicitSolver::prepare_motion() {
  if (constrained_) prepare(motion_);
}

bool ExplicitSolver::prepare_factors() {
  prepare_motion();
  mass_.prepare(system(), linear_type(), linear_options());
  renewed_objects_ = system().renewed_objects();
  constant_mass_ = !constrained_ && system().constant_mass_matrix() && reuses_masses_;
  return !constant_mass_ || update_masses();
}

bool ExplicitSolver::update_masses() {
  const TimedPart time(timer, timer.massMatrix);
  const int row = mass_.update(system(), current());
  if (row != LinearSolver::success) [[unlikely]]
    mass_failed(row);
  return row == LinearSolver::success;
}

// Discards the factors, which depend on pivots of earlier matrices.
void ExplicitSolver::forget() {
  Solver::forget();
  first_stage_known_ = end_known_ = false;
  prepare_factors();
}

// Does nothing for Runge-Kutta methods, which compute accelerations at the start of each step.
void ExplicitSolver::renew_accelerations() {
  if (verlet_) accelerations(current().a);
}

// Accelerations and rates at the start are those of the first stage.
Solver::KnownDerivatives ExplicitSolver::complete_ends() {
  if (verlet_) return {true, it.currentStepIndex > 1};
  start_of_step().a = at_once_ ? current().a : stage_v_.front();
  start_of_step().y_t = stage_y_.front();
  eliminate(start_of_step().a);
  return {options_.computeEndOfStepAccelerations, true};
}

// Finds coordinates fixed by a constraint, which are reset to zero. Other constraints have multipliers, including those
// on coordinates that the mass matrix couples with others, because the constraint force accelerates these.
void ExplicitSolver::find_eliminated_coordinates() {
  eliminated_.clear();
  constrained_ = false;
  if (sizes_.ae == 0) return;
  if (!options_.eliminateConstraints) {
    warn(
        "explicit integration ignores all constraints "
        "(timeIntegration.explicitIntegration.eliminateConstraints=False)");
    return;
  }
  auto fixed = system().fixed_coordinates();
  if (!fixed && verlet_) {
    throw ModelError(
        ErrorKind::value,
        name() +
            ": the system has constraints that this method cannot eliminate; only CoordinateConstraint between a "
            "node's coordinate and a ground node is possible. Use a Runge-Kutta method, for example "
            "exu.DynamicSolverType.DOPRI5, which keeps all constraints, or an implicit solver");
  }
  constrained_ = !fixed || mass_couples(*fixed);
  if (fixed && (verlet_ || !constrained_)) eliminated_ = std::move(*fixed);
}

// Returns whether the mass matrix couples these coordinates with others.
bool ExplicitSolver::mass_couples(const std::vector<int>& coordinates) {
  std::vector<char> among(static_cast<std::size_t>(sizes_.total()), 0);
  for (const int i : coordinates) among[static_cast<std::size_t>(i)] = 1;
  const Pattern& pattern = system().pattern(false);
  std::vector<double> mass(static_cast<std::size_t>(pattern.values()));
  system().mass_matrix(current(), pattern, mass);
  bool couples = false;
  for_each_entry(pattern, [&](int row, int column, std::size_t slot) {
    const bool one_of_them = among[static_cast<std::size_t>(row)] != among[static_cast<std::size_t>(column)];
    couples |= one_of_them && row < sizes_.ode2 && column < sizes_.ode2 && mass[slot] != 0;
  });
  return couples;
}

void ExplicitSolver::eliminate(Vector& x) const {
  for (const int i : eliminated_) x[static_cast<std::size_t>(i)] = 0;
}

bool ExplicitSolver::reduce_step_size() {
  it.currentTime = current().time;
  if (conv.stopNewton) return false;
  if (conv.discontinuousIterationSuccessful) return true;  // error control has selected a step size
  if (!(it.lastStepSize > it.minStepSize)) return false;
  steps_.reject(it.lastStepSize, steps_.decrease());
  return true;
}

void ExplicitSolver::save_start_of_step() {
  first_stage_known_ = sums_known_ = false;
  at_once_ = may_move_at_once_ && constant_mass_ && mass_.factors() != nullptr;
  if ((verlet_ && nobody_interferes_) || at_once_) return save_all_but_motion();  // the step saves the motion
  Solver::save_start_of_step();
  if (!end_known_ || verlet_) return;
  std::swap(stage_v_[0], end_a_);
  std::swap(stage_y_[0], end_y_t_);
  first_stage_known_ = true;
  end_known_ = false;
}

bool ExplicitSolver::newton() {
  if (verbose(4)) announce_mass_matrix();
  conv.linearSolverFailed = conv.newtonSolutionDiverged = conv.stopNewton = false;
  conv.linearSolverCausingRow = -1;
  conv.newtonConverged = true;
  end_known_ = off_constraints_ = false;
  if (constrained_) [[unlikely]]
    motion_.begin_step(system(), start_of_step(), conditions_);
  compute_step();
  if (constrained_ && !rank_known_) find_rank();
  if (off_constraints_) [[unlikely]]
    return lose_constraints();
  if (conv.linearSolverFailed) [[unlikely]] {
    conv.newtonConverged = false;
    const bool singular = all_finite(current().q) && all_finite(current().v);
    return singular ? false : lose_step();
  }
  if (!stays_bounded() && outgrown()) [[unlikely]]
    return lose_step();
  return !it.automaticStepSize || control_step_size();
}

void ExplicitSolver::compute_step() {
  if (verlet_)
    verlet_step();
  else if (at_once_ && !searching_)
    step_at_once();
  else
    runge_kutta_step();
}

// Checks velocities only, since any growth shows there: forces change velocities, and velocities change coordinates.
// Velocities of Verlet's method include the accelerations at the end of the step; accelerations of other methods are
// checked separately. The last state of a solution is checked completely.
DALEMBERT_INLINE inline bool ExplicitSolver::stays_bounded() const {
  const State& now = system().state(ConfigurationType::Current);
  double motion = 0, rest = 0;
  if (sums_known_) {
    motion = sum_of_v_;
    rest = sum_of_a_;
  } else if (now.v.size() <= few_numbers) {
    each_of_few(now.v.size(), [&, v = now.v.data(), a = now.a.data()](std::size_t i) {
      motion += v[i] * v[i];
      rest += a[i] * a[i];
    });
  } else {
    motion = sum_of_squares(system(), now.v);
    if (!verlet_) rest = sum_of_squares(system(), now.a);
  }
  if (watches_coordinates_) motion += sum_of_squares(system(), now.q);
  if (!now.y.empty() && !(sum_of_squares(system(), now.y) < unbounded * unbounded)) return false;
  const bool last = it.currentTime + 0.5 * it.currentStepSize > it.endTime;
  return motion < growth_limit_ && std::isfinite(rest) && (!last || all_finite(now));
}

// Inlines its parts: calls would take as long as the computation of small systems.
[[gnu::flatten]] void ExplicitSolver::runge_kutta_step() {
  for (int stage = 0; stage < method_.stages; ++stage) {
    compute_stage(stage);
    if (conv.linearSolverFailed) return;
  }
  State& now = current();
  move_from_start(result_, now.q, now.v, now.y);
  eliminate(now.q);
  eliminate(now.v);
  now.time = it.currentTime;
  if (constrained_ && !back_onto_constraints()) return;
  end_of_step();
}

// Computes state and derivative of a stage.
void ExplicitSolver::compute_stage(int stage) {
  State& now = current();
  if (stage > 0) {
    move_from_start(rows_[static_cast<std::size_t>(stage)], now.q, now.v, now.y);
  } else if (!nobody_interferes_) {  // a discontinuous iteration may have changed the state
    const State& start = start_of_step();
    now.q = start.q;
    now.v = start.v;
    now.y = start.y;
  }
  now.time = start_of_step().time + it.currentStepSize * method_.c[static_cast<std::size_t>(stage)];
  compute_stage_rates(stage);
}

void ExplicitSolver::compute_stage_rates(int stage) {
  const auto s = static_cast<std::size_t>(stage);
  if (stage > 0 || !first_stage_known_) {
    if (!accelerations(stage_v_[s], stage_y_[s])) return;
    if (stage == 0) first_stage_known_ = nobody_interferes_;
  }
  if (stage == 0) return;
  copy_numbers(system(), current().v.data(), stage_q_[s].size(), stage_q_[s].data());
  if (lie_) turn_stage_rates(s);
}

[[gnu::noinline]] void ExplicitSolver::turn_stage_rates(std::size_t s) {
  for (const System::LieBlock& block : system().lie_blocks()) {
    const auto r = static_cast<std::size_t>(block.rotation);
    std::array<double, 3> turned{};
    for (std::size_t j = 0; j < s; ++j) {
      const double factor = method_.coefficient(static_cast<int>(s), static_cast<int>(j)) * it.currentStepSize;
      const double* rates = position_rates(j);
      for (std::size_t k = 0; k < 3; ++k) turned[k] += factor * rates[r + k];
    }
    const auto t = inverse_tangent_operator(turned.data());
    const Vec3<double> rate = t * load<double, 3>(&stage_q_[s][r]);
    for (int k = 0; k < 3; ++k) stage_q_[s][r + static_cast<std::size_t>(k)] = rate[k];
  }
}

ExplicitSolver::StageWeights ExplicitSolver::that_count(std::span<const double> weights) {
  StageWeights found;
  for (std::size_t stage = 0; stage < weights.size(); ++stage) {
    if (weights[stage] != 0) found.push_back({stage, weights[stage]});
  }
  return found;
}

const double* ExplicitSolver::position_rates(std::size_t stage) {
  return stage == 0 ? start_of_step().v.data() : stage_q_[stage].data();
}

// Adds weighted derivatives of the stages to the start of the step.
void ExplicitSolver::move_from_start(const StageWeights& weights, Vector& q, Vector& v, Vector& y) {
  const State& start = start_of_step();
  const double h = it.currentStepSize;
  std::array<WeightedVector, RungeKuttaMethod::max_stages> terms;
  const auto change = [&](auto&& rates) {
    std::size_t count = 0;
    for (const StageWeight& w : weights) {
      terms[count++] = {w.weight * h, rates(w.stage)};
      keep_loop();
    }
    return std::span<const WeightedVector>(terms.data(), count);
  };
  const auto advance = [&](Vector& x, const Vector& from, auto&& rates) {
    if (x.empty()) return;
    if (weights.size() == 1) {
      const WeightedVector term{weights.front().weight * h, rates(weights.front().stage)};
      return add_weighted<1>(system(), x.data(), from.data(), &term, x.size());
    }
    combine(system(), x, from, change(rates));
  };
  const auto of_positions = [this](std::size_t stage) { return position_rates(stage); };
  if (!all_on_group_) advance(q, start.q, of_positions);
  if (lie_) system().compose(start.q, change(of_positions), q);
  advance(v, start.v, [this](std::size_t stage) { return stage_v_[stage].data(); });
  advance(y, start.y, [this](std::size_t stage) { return stage_y_[stage].data(); });
}

void ExplicitSolver::end_of_step() {
  State& now = current();
  if (options_.computeEndOfStepAccelerations) {
    if (!accelerations(now.a, now.y_t)) return;
    end_known_ = nobody_interferes_;
    if (end_known_) {
      end_a_ = now.a;
      end_y_t_ = now.y_t;
    }
  } else {
    rates(now.y_t);
    copy_numbers(system(), stage_v_.back().data(), now.a.size(), now.a.data());
  }
  eliminate(now.a);
}

// v(t+h/2) = v + h/2 a;  q(t+h) = q + h v(t+h/2);  v(t+h) = v(t+h/2) + h/2 a(t+h). ODE1 coordinates use explicit Euler
// steps.
void ExplicitSolver::verlet_step() {
  State& now = current();
  const double h = it.currentStepSize;
  if (nobody_interferes_) {
    kick_and_drift_from(system(), start_of_step(), now, h);
  } else {
    kick_and_drift(system(), now, h, [](std::size_t) {});
  }
  if (lie_) {
    const WeightedVector change{h, now.v.data()};
    system().compose(start_of_step().q, std::span(&change, 1), now.q);
  }
  eliminate(now.q);
  eliminate(now.v);
  now.time = it.currentTime;
  if (!accelerations(now.a)) return;
  eliminate(now.a);
  add(system(), now.v, 0.5 * h, now.a);
  rates(now.y_t);
  add(system(), now.y, h, now.y_t);
}

void ExplicitSolver::rates(Vector& y_t) {
  if (sizes_.ode1 == 0) return;
  const TimedPart time(timer, timer.ODE1RHS);
  system().rates(current(), conditions_, y_t);
}

bool ExplicitSolver::accelerations(Vector& a, std::span<double> y_t) {
  if (constrained_) return constrained_accelerations(a, y_t);
  if (!constant_mass_ && !update_masses()) return false;
  {
    const TimedPart time(timer, timer.ODE2RHS);
    system().right_hand_sides(current(), conditions_, a, y_t);
  }
  return divide_by_masses(a) && (!searching_ || is_good(a, y_t));
}

// Solves for accelerations, in place of forces.
bool ExplicitSolver::divide_by_masses(Vector& a) {
  if (constant_mass_ && masses_are_old()) [[unlikely]]
    if (!prepare_factors() || !(constant_mass_ || update_masses())) return false;
  const TimedPart time(timer, timer.newtonIncrement);
  if (const int row = mass_.solve(system(), current(), a); row != LinearSolver::success) [[unlikely]] {
    mass_failed(row);
    return false;
  }
  return true;
}

[[gnu::noinline]] void ExplicitSolver::announce_mass_matrix() {
  const Pattern& pattern = system().pattern(false);
  std::vector<double> values(static_cast<std::size_t>(pattern.values()));
  system().mass_matrix(current(), pattern, values);
  say(4, "  mass matrix =\n    " +
             matrix_text(dense_rows(pattern, values, sizes_.ode2), sizes_.ode2, settings().outputPrecision) + "\n");
}

void ExplicitSolver::free_memory() {
  for (std::vector<Vector>* stages : {&stage_q_, &stage_v_, &stage_y_}) *stages = {};
  for (Vector* numbers : {&second_q_, &second_v_, &second_y_, &end_a_, &end_y_t_}) *numbers = {};
  mass_ = {};
  motion_ = {};
}

}  // namespace dalembert
