#include "lockstep.hpp"

#include <algorithm>
#include <cmath>

#include "dalembert/system/traced_equations.hpp"
#include "steppers/velocity_lead.hpp"

namespace dalembert {

namespace {

constexpr double nothing = 0;  // value in empty lanes

// Calls f(number, place) for the numbers of a state that noted equations depend on.
template <class F>
void each_input(const State& state, F&& f) {
  std::size_t k = 0;
  for (const auto* part : {&state.q, &state.v, &state.a, &state.lambda})
    for (const double& x : *part) f(k++, &x);
}

}  // namespace

std::string Lockstep::obstacle(SecondOrderSolver& solver) {
  const std::string_view of_solver = solver.lockstep_obstacle();
  return of_solver.empty() ? TracedEquations::obstacle(solver.system()) : std::string(of_solver);
}

template <class F>
void Lockstep::each(const Lanes& wanted, F&& f) {
  for (int i = 0; i < most; ++i)
    if (Lane& lane = lanes_[static_cast<std::size_t>(i)]; wanted[static_cast<std::size_t>(i)] && lane.here) f(i, lane);
}

template <class F>
Lockstep::Lanes Lockstep::which(const Lanes& among, F&& f) {
  Lanes result{};
  each(among, [&](int i, Lane& lane) { result[static_cast<std::size_t>(i)] = f(lane); });
  return result;
}

Lockstep::Lanes Lockstep::all_here() const {
  Lanes all{};
  std::ranges::transform(lanes_, all.begin(), [](const Lane& lane) { return lane.here; });
  return all;
}

// The constants of a lane, for its step size; false: its operations differ from those of the other lanes.
bool Lockstep::note(Lane& lane) {
  lane.step_size = lane.solver->it.currentStepSize;
  trace_.begin();
  lane.solver->trace(trace_);
  const bool same = trace_.end();
  lane.constants = trace_.constants;
  return same && std::ranges::none_of(lane.constants, [](double x) { return std::isnan(x); });
}

void Lockstep::compile() {
  bool refined = !compiled_;
  each(all_here(), [&](int, Lane& lane) { refined |= classes_.refine(lane.constants); });
  if (refined) {
    program_ = LaneProgram(trace_, classes_);
    // Factors know which entries are always zero.
    factors_.clear();
    each(all_here(), [](int, Lane& lane) { lane.here = lane.factors == nullptr; });
    compiled_ = true;
  }
  each(all_here(), [&](int i, Lane& lane) { program_.set_constants(i, lane.constants); });
}

std::vector<bool> Lockstep::solve_steps(std::span<SecondOrderSolver* const> solvers) {
  lanes_ = {};
  inputs_.clear();
  unknowns_ = solvers.front()->sizes().total();
  for (std::size_t i = 0; i < solvers.size(); ++i) {
    Lane& lane = lanes_[i];
    lane.solver = solvers[i];
    lane.solver->start_steps();
    each_input(lane.solver->current(), [&](std::size_t k, const double* x) {
      if (k == inputs_.size()) inputs_.emplace_back().fill(&nothing);
      inputs_[k][i] = x;
    });
    lane.here = note(lane);
  }
  compile();
  for (;;) {
    const Lanes going = which(all_here(), [](Lane& lane) { return lane.solver->next_step(); });
    if (std::ranges::none_of(going, [](bool x) { return x; })) break;
    take_step(going);
  }
  std::vector<bool> solved(solvers.size());
  for (std::size_t i = 0; i < solvers.size(); ++i) {
    solved[i] = lanes_[i].here;
    if (solved[i]) lanes_[i].solver->end_steps();
  }
  return solved;
}

void Lockstep::take_step(const Lanes& lanes) {
  bool changed = false;
  each(lanes, [&](int, Lane& lane) {
    lane.solver->begin_step();
    if (lane.solver->it.currentStepSize == lane.step_size) return;
    lane.here = note(lane);
    changed = true;
  });
  if (changed) compile();
  each(lanes, [](int, Lane& lane) {
    lane.solver->begin_discontinuous_iteration();
    lane.solver->begin_newton();
  });
  find_residuals(lanes);
  each(lanes, [](int, Lane& lane) { lane.solver->judge_start(lane.norm); });
  for (;;) {
    const Lanes iterating = which(lanes, [](Lane& lane) { return lane.solver->goes_on(); });
    if (std::ranges::none_of(iterating, [](bool x) { return x; })) break;
    iterate(iterating);
  }
  correct_motion(which(lanes, [](Lane& lane) { return lane.solver->succeeded() && lane.solver->leaves_correction(); }));
  each(lanes, [](int, Lane& lane) {
    lane.here = lane.solver->succeeded();
    if (!lane.here) return;
    lane.solver->accept_newton();
    lane.solver->conv.discontinuousIterationSuccessful = true;
    lane.here = !lane.solver->lead_->watches() || !lane.solver->lead_->accelerations_alternate() ||
                lane.solver->lead_->closes_gaps_of_start();
    lane.solver->step_succeeded();
  });
}

// A modified Newton method that has become a full one, or restarted, leaves the group; so does one that fails.
bool Lockstep::is_usual(const SecondOrderSolver& solver) {
  return !solver.loop_.restarted && solver.full_newton_ == !solver.newton_settings.useModifiedNewton &&
         (solver.goes_on() || solver.succeeded());
}

void Lockstep::iterate(const Lanes& lanes) {
  renew_factors(which(lanes, [](Lane& lane) { return lane.solver->begin_iteration(); }));
  correct_motion(lanes);
  find_residuals(lanes);
  each(lanes, [](int, Lane& lane) {
    lane.solver->judge(lane.norm);
    lane.here = is_usual(*lane.solver);
  });
}

// States and residuals of lanes that no longer iterate do not change.
void Lockstep::find_residuals(const Lanes& lanes) {
  program_.read(inputs_);
  program_.run(0);
  each(lanes, [&](int i, Lane& lane) { lane.norm = program_.output(unknowns_)[i]; });
}

// The residual and its norm come before it.
int Lockstep::matrix_output(int k) const { return unknowns_ + 1 + k; }

// Pivots of the last factorization are tried, and searched again for where DenseLu would do so.
void Lockstep::renew_factors(const Lanes& lanes) {
  if (std::ranges::none_of(lanes, [](bool x) { return x; })) return;
  program_.run(1);
  const Lanes known = which(lanes, [](Lane& lane) { return lane.factors != nullptr; });
  factorize(known);
  Lanes searched{};
  each(lanes, [&](int i, Lane& lane) {
    if (lane.factors && lane.factors->usable(i, lane.solver->linear_->largest_inverse())) return;
    searched[static_cast<std::size_t>(i)] = true;
    search_pivots(i);
  });
  factorize(searched);
  each(lanes, [](int, Lane& lane) { lane.solver->jacobian_renewed(); });
}

void Lockstep::search_pivots(int i) {
  Lane& lane = lanes_[static_cast<std::size_t>(i)];
  // the check for contradictory redundant constraints reads the residual
  const std::span<double> residual = lane.solver->residual();
  for (std::size_t k = 0; k < residual.size(); ++k) residual[k] = program_.output(static_cast<int>(k))[i];
  const std::span<double> values = lane.solver->jacobian_values();
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = program_.output(matrix_output(static_cast<int>(k)))[i];
  lane.here = lane.solver->factorize() && !lane.solver->constraint_solver().active();
  if (lane.here) lane.factors = &factors_for(lane.solver->linear_->listed_rows());
}

LaneFactors& Lockstep::factors_for(std::span<const int> row_of_step) {
  const auto known =
      std::ranges::find_if(factors_, [&](const auto& f) { return std::ranges::equal(f->row_of_step(), row_of_step); });
  if (known != factors_.end()) return **known;
  const int n = static_cast<int>(row_of_step.size());
  std::vector<char> occupied(static_cast<std::size_t>(n * n));
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      if (!program_.is_zero(matrix_output(j * n + i)))
        for (const int place : {j * n + i, i * n + j}) occupied[static_cast<std::size_t>(place)] = 1;
  return *factors_.emplace_back(std::make_unique<LaneFactors>(row_of_step, occupied));
}

void Lockstep::factorize(const Lanes& lanes) {
  for (const auto& factors : factors_) {
    const Lanes mine = which(all_here(), [&](Lane& lane) { return lane.factors == factors.get(); });
    const Lanes wanted = which(lanes, [&](Lane& lane) { return lane.factors == factors.get(); });
    if (std::ranges::none_of(wanted, [](bool x) { return x; })) continue;
    factors->factorize(wanted, wanted != mine,
                       [this](int k) -> const LaneBlock& { return program_.output(matrix_output(k)); });
  }
}

void Lockstep::correct_motion(const Lanes& lanes) {
  find_increments(lanes);
  each(lanes, [](int, Lane& lane) { lane.solver->compute_update(false); });
}

void Lockstep::find_increments(const Lanes& lanes) {
  for (const auto& factors : factors_) {
    const Lanes mine = which(lanes, [&](Lane& lane) { return lane.factors == factors.get(); });
    if (std::ranges::none_of(mine, [](bool x) { return x; })) continue;
    const std::vector<LaneBlock>& x = factors->solve([this](int k) -> const LaneBlock& { return program_.output(k); });
    each(mine, [&](int i, Lane& lane) {
      const std::span<double> increment = lane.solver->increment();
      for (std::size_t k = 0; k < increment.size(); ++k) increment[k] = x[k][i];
    });
  }
}

}  // namespace dalembert
