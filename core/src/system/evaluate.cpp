// Residuals and tangents of the whole system: markers move frames out, terms add, markers pull forces back.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "dalembert/math/inline.hpp"
#include "dalembert/system/large_vectors.hpp"
#include "dalembert/system/parts.hpp"
#include "plan.hpp"

namespace dalembert {
namespace {

template <class Batches, class F>
void each(const Batches& batches, F&& f) {
  for (const auto& batch : batches) f(*batch);
}

// Parts of an evaluation are inlined: for small systems, a call takes as long as the computation. Collects the
// pointers and conditions of an evaluation. The caller computes the totals at q.
DALEMBERT_INLINE inline Evaluation view_of(const SystemParts& parts, const State& state, const Conditions& conditions) {
  const bool rests = &state == &parts.states[static_cast<std::size_t>(ConfigurationType::Reference)];
  const double* zeros = parts.work.data() + parts.sizes.total();
  return {.q = parts.total.data(),
          .u = rests ? zeros : state.q.data(),
          .reference = parts.states[static_cast<std::size_t>(ConfigurationType::Reference)].q.data(),
          .v = rests ? zeros : state.v.data(),
          .a = rests ? zeros : state.a.data(),
          .y = state.y.data(),
          .y_t = state.y_t.data(),
          .lambda = state.lambda.data(),
          .data = state.data.data(),
          .time = state.time,
          .load_factor = conditions.load_factor,
          .step_size = conditions.step_size,
          .rate_level = conditions.rate_level,
          .inertia = conditions.inertia,
          .direct = conditions.direct,
          .of_reference = rests};
}

// Computed per region: the data is still in the cache of its thread.
DALEMBERT_INLINE inline void find_totals(SystemParts& parts, const RegionPlan& region, const Evaluation& e) {
  region.numbers.coordinates.each(
      [reference = e.reference, u = e.u, q = parts.total.data()](std::size_t first, std::size_t count) {
        each_number(count,
                    [q = q + first, from = reference + first, u = u + first](std::size_t i) { q[i] = from[i] + u[i]; });
      });
}

// For outputs; the totals at q are left to the caller.
Evaluation output_view(SystemParts& parts, const State& state) {
  parts.output_total.resize(parts.total.size());
  Evaluation e = view_of(parts, state, {});
  e.q = parts.output_total.data();
  return e;
}

}  // namespace

Evaluation SystemParts::evaluation(const State& state, const Conditions& conditions) {
  const Evaluation e = view_of(*this, state, conditions);
  each_region([this, &e](const RegionPlan& region) { find_totals(*this, region, e); });
  return e;
}

Evaluation SystemParts::output_evaluation(const State& state, std::span<const int> dofs) {
  const Evaluation e = output_view(*this, state);
  for (const int i : dofs) output_total[i] = this->state(ConfigurationType::Reference).q[i] + e.u[i];
  return e;
}

Evaluation SystemParts::output_evaluation(const State& state, std::vector<double>& totals) {
  const std::vector<double>& reference = this->state(ConfigurationType::Reference).q;
  Evaluation e = view_of(*this, state, {});
  totals.resize(total.size());
  each_number(total.size(),
              [q = totals.data(), from = reference.data(), u = e.u](std::size_t i) { q[i] = from[i] + u[i]; });
  e.q = totals.data();
  return e;
}

Evaluation SystemParts::output_evaluation(const State& state) {
  const Evaluation e = output_view(*this, state);
  const double* reference = this->state(ConfigurationType::Reference).q.data();
  each_number(total.size(),
              [q = output_total.data(), reference, u = e.u](std::size_t i) { q[i] = reference[i] + u[i]; });
  return e;
}

void SystemParts::update_ports(const Evaluation& e) {
  evaluate_resting(e);
  each_region([this, &e](const RegionPlan& region) { update_frames(region, e); });
}

void SystemParts::evaluate_resting(const Evaluation& e) {
  if (plan.resting_evaluated) return;
  each(plan.resting, [&](const MarkerBatch& batch) { batch.evaluate(e, ports); });
  evaluate_constant_loads();
  plan.resting_evaluated = true;
}

// Uses the reference configuration, because the result is the same for all states.
void SystemParts::evaluate_constant_loads() {
  ConstantLoads& constant = plan.constant;
  constant.residual.assign(constant.loads.empty() ? 0 : static_cast<std::size_t>(sizes.total()), 0.0);
  if (constant.loads.empty()) return;
  const State& reference = state(ConfigurationType::Reference);
  Evaluation e = view_of(*this, reference, {});
  e.q = reference.q.data();
  double* r = constant.residual.data();
  ports.clear_forces();
  each(constant.loads, [&](const Term& load) { load.residual(e, ports, r); });
  each(constant.markers, [&](const MarkerBatch& batch) { batch.pull_back(e, ports, r); });
  each(rotating_nodes, [&](const RotatingNodeBatch& nodes) {
    nodes.evaluate(e, ports);
    nodes.pull_back(e, ports, r);
  });
}

void SystemParts::update_frames(const RegionPlan& region, const Evaluation& e) {
  const auto evaluate = [&](const auto& batch) { batch.evaluate(e, ports); };
  each(region.nodes, evaluate);
  each(e.reads_nodes ? region.needed : region.moving, evaluate);
}

namespace {

// True for as long as it lives, also when a user function throws.
class Flagged {
 public:
  explicit Flagged(bool& flag) : flag_(flag) { flag_ = true; }
  ~Flagged() { flag_ = false; }
  Flagged(const Flagged&) = delete;
  Flagged& operator=(const Flagged&) = delete;

 private:
  bool& flag_;
};

// Constant loads are there from the start.
DALEMBERT_INLINE inline void begin_residual(SystemParts& parts, const RegionPlan& region, const Evaluation& e,
                                            bool loads, double* r) {
  const double* constant =
      loads && !parts.plan.constant.residual.empty() ? parts.plan.constant.residual.data() : nullptr;
  region.numbers.rows.each([=](std::size_t first, std::size_t count) {
    if (constant == nullptr) return clear_numbers(r + first, count);
    each_number(count, [load_factor = e.load_factor, from = constant + first, to = r + first](std::size_t i) {
      to[i] = load_factor * from[i];
    });
  });
  Ports& ports = parts.ports;
  if (!e.reads_nodes || !region.needed.empty())
    region.numbers.forces.each(
        [&](std::size_t first, std::size_t count) { clear_numbers(ports.forces.data() + first, count); });
  region.numbers.node_loads.each([&](std::size_t first, std::size_t count) {
    clear_numbers(reinterpret_cast<double*>(ports.node_loads.data() + first),
                  count * sizeof(NodeLoad) / sizeof(double));
  });
}

[[gnu::noinline, gnu::cold]] void add_pull(const SystemParts& parts, double* r) {
  for (const auto& [row, value] : parts.pull_forces) r[row] -= value;
}

enum class Rows { all, algebraic };
template <Rows rows = Rows::all>
DALEMBERT_INLINE inline void find_residual(SystemParts& parts, const Evaluation& e, double* r, bool loads = true) {
  const Flagged evaluating(parts.evaluating);
  parts.evaluate_resting(e);
  parts.each_region([&parts, &e, r, loads](const RegionPlan& region) DALEMBERT_INLINE {
    if (!e.reads_nodes || parts.needs_totals) find_totals(parts, region, e);
    begin_residual(parts, region, e, loads, r);
    parts.update_frames(region, e);
    const auto add = [&](const Term& term) { term.residual(e, parts.ports, r); };
    each(rows == Rows::all ? region.terms : region.with_equations, add);
    if (loads) each(region.changing_loads, add);
  });
  if constexpr (rows == Rows::algebraic) return;
  parts.each_region([&parts, &e, r](const RegionPlan& region) {
    const auto pull_back = [&](const auto& batch) { batch.pull_back(e, parts.ports, r); };
    each(e.reads_nodes ? region.needed_pulled : region.pulled, pull_back);
    each(region.nodes, pull_back);
  });
  for (int i = 0; i < parts.sizes.ode1; ++i) r[parts.sizes.ode2 + i] -= e.y_t[i];
  if (parts.is_pulled) [[unlikely]]
    add_pull(parts, r);
}

void clear_columns(const RegionPlan& region, const Pattern& pattern, double* values) {
  region.numbers.rows.each([&](std::size_t first, std::size_t count) {
    const std::size_t begin = pattern.first_slot(first), end = pattern.first_slot(first + count);
    clear_numbers(values + begin, end - begin);
  });
}

// Used by infrequent callers.
[[gnu::noinline]] void find_residual_in_work(SystemParts& parts, const Evaluation& e, bool loads) {
  find_residual(parts, e, parts.work.data(), loads);
}
[[gnu::noinline]] void find_gaps_in_work(SystemParts& parts, const Evaluation& e) {
  find_residual<Rows::algebraic>(parts, e, parts.work.data(), false);
}

}  // namespace

void System::residual(const State& state, const Conditions& conditions, std::span<double> r) {
  if (late_ != nullptr) [[unlikely]]
    refresh(*late_);
  ++evaluations_;
  ports_hold(nullptr);
  find_residual(*parts_, view_of(*parts_, state, conditions), r.data(), conditions.loads);
  ports_hold(&state);
}

void System::tangent(const State& state, const Conditions& conditions, const Weights& weights, const Pattern& pattern,
                     std::span<double> values) {
  SystemParts& parts = *parts_;
  parts.bind(pattern);
  Evaluation e = view_of(parts, state, conditions);
  if (!conditions.follows_residual || evaluated_ != &state) {
    find_residual_in_work(parts, e, conditions.loads);  // the forces on markers, for the geometric part
    ports_hold(nullptr);
  }
  e.same_state = true;
  const Flagged evaluating(parts.evaluating);
  parts.ports.differentiate();
  parts.each_region([&parts, &e, &weights, loads = conditions.loads, &pattern, values](const RegionPlan& region) {
    clear_columns(region, pattern, values.data());
    Ports& ports = parts.ports;
    const auto differentiate = [&](const auto& batch) { batch.evaluate_tangent(e, weights, ports); };
    each(region.nodes, differentiate);
    each(region.differentiated, differentiate);
    const auto add = [&](const Term& term) { term.tangent(e, weights, ports, values.data()); };
    each(region.terms, add);
    if (loads) each(region.loads, add);
    const auto add_geometric = [&](const auto& batch) { batch.geometric(e, weights, ports, values.data()); };
    each(region.moving, add_geometric);
    each(region.nodes, add_geometric);
  });
  for (const int slot : parts.rate_slots) values[slot] -= weights.y_t;
  if (conditions.load_dependencies > 0 && !parts.load_dependencies.empty())
    dalembert::add_load_dependencies(*this, parts, e, weights, conditions.load_dependencies > 1, values.data());
}

void System::mass_matrix(const State& state, const Pattern& pattern, std::span<double> values) {
  SystemParts& parts = *parts_;
  parts.bind(pattern);
  ports_hold(nullptr);
  const Evaluation e = view_of(parts, state, {});
  const bool all = !parts.mass_pattern || &pattern != &*parts.mass_pattern || parts.without_matrix.empty();
  parts.each_region([&parts, &e, &pattern, values, all](const RegionPlan& region) {
    find_totals(parts, region, e);
    clear_columns(region, pattern, values.data());
    for (const Term* term : region.terms)
      if (term->has_mass() && (all || !parts.is_without_matrix(*term))) term->mass(e, parts.ports, values.data());
  });
}

bool System::add_diagonal_masses(const State& state, std::span<double> diagonal) {
  ports_hold(nullptr);
  const Evaluation e = parts_->evaluation(state, {});
  return std::ranges::all_of(parts_->terms,
                             [&](const auto& term) { return term->add_diagonal_masses(e, diagonal.data()); });
}

// Totals are those of right_hand_sides or mass_matrix of this state, which come before.
int System::solve_masses(const State& state, std::span<double> x) {
  SystemParts& parts = *parts_;
  const Evaluation e = view_of(parts, state, {});
  for (const MassSolver* solver : parts.mass_solvers)
    if (const int loose = solver->solve_masses(e, x.data()); loose >= 0) return loose;
  return -1;
}

void System::forces(const State& state, const Conditions& conditions, std::span<double> rhs) {
  right_hand_sides(state, conditions, rhs, {});
}

void System::rates(const State& state, const Conditions& conditions, std::span<double> y_t) {
  right_hand_sides(state, conditions, {}, y_t);
}

std::span<const double> System::negative_forces(const State& state, const Conditions& conditions) {
  if (late_ != nullptr) [[unlikely]]
    refresh(*late_);
  ports_hold(nullptr);
  ++evaluations_;
  SystemParts& parts = *parts_;
  const std::span<double> residual(parts.work.data(), static_cast<std::size_t>(sizes_.total()));
  Evaluation e = view_of(parts, state, conditions);
  e.inertia = false;
  e.direct = !conditions.holds_contact;
  e.lambda = residual.data() + residual.size();  // zeros
  if (e.direct && conditions.unseen && !parts.system_terms.empty()) {
    if (!parts.knows_needed_markers) [[unlikely]]
      find_nodes_of_terms();
    e.reads_nodes = parts.leaves_markers_to_terms &&
                    std::ranges::all_of(parts.system_terms, [](const SystemTerm* term) { return term->reads_nodes(); });
  }
  find_residual(parts, e, residual.data());
  return residual;
}

[[gnu::flatten]] void System::right_hand_sides(const State& state, const Conditions& conditions, std::span<double> rhs,
                                               std::span<double> y_t) {
  const std::span<const double> residual = negative_forces(state, conditions);
  each_number(*this, rhs.size(), [to = rhs.data(), from = residual.data()](std::size_t i) { to[i] = -from[i]; });
  for (std::size_t i = 0; i < y_t.size(); ++i) y_t[i] = residual[sizes_.ode2 + i] + state.y_t[i];
}

void System::gaps(const State& state, const Conditions& conditions, std::span<double> g) {
  ports_hold(nullptr);
  SystemParts& parts = *parts_;
  if (!parts.knows_terms_with_equations) find_terms_with_equations(parts);
  find_gaps_in_work(parts, view_of(parts, state, conditions));
  for (int i = 0; i < sizes_.ae; ++i) g[i] = parts.work[sizes_.first_ae() + i];
}

void System::restore_unit_lengths(State& state, int power_of_rates) const {
  const std::vector<double>& reference = parts_->state(ConfigurationType::Reference).q;
  for (const auto& [first, size] : parts_->unit_vectors) {
    double square = 0;
    for (int i = first; i < first + size; ++i) square += (reference[i] + state.q[i]) * (reference[i] + state.q[i]);
    const double length = std::sqrt(square);
    for (int i = first; i < first + size; ++i) {
      state.q[i] = (reference[i] + state.q[i]) / length - reference[i];
      state.v[i] /= power_of_rates == 2 ? square : length;
      state.a[i] /= length;
    }
  }
}

Discontinuity System::post_newton(State& state, const Conditions& conditions, Updates updates) {
  ports_hold(nullptr);
  SystemParts& parts = *parts_;
  PostNewton verdict;
  if (!has_discontinuities(conditions)) return {};
  const Evaluation e = parts.evaluation(state, conditions);
  parts.update_ports(e);
  const double* start = parts.state(ConfigurationType::StartOfStep).data.data();
  for (const auto& term : parts.terms) {
    if (!term->has_history()) continue;
    const bool settles = updates == Updates::without_switches && term->has_switches();
    double *data = state.data.data(), *lambda = state.lambda.data();
    verdict.add(settles ? term->settle(e, parts.ports, start, data, lambda)
                        : term->post_newton(e, parts.ports, start, data, lambda));
  }
  each(parts.marker_batches, [&](const MarkerBatch& batch) { batch.post_newton(e, parts.ports, state.data.data()); });
  return {verdict.error, verdict.recommended_step_size};
}

void System::find_switches(const State& state, const Conditions& conditions, std::vector<Switch>& found) {
  ports_hold(nullptr);
  SystemParts& parts = *parts_;
  const Evaluation e = parts.evaluation(state, conditions);
  parts.update_ports(e);
  Switches switches(found);
  for (const auto& term : parts.terms) term->find_switches(e, parts.ports, switches);
}

void System::switch_over(State& state, const Conditions& conditions) {
  ports_hold(nullptr);
  SystemParts& parts = *parts_;
  parts.data_before.assign(state.data.begin(), state.data.end());
  const Evaluation e = parts.evaluation(state, conditions);
  parts.update_ports(e);
  for (const auto& term : parts.terms)
    term->switch_over(e, parts.ports, parts.data_before.data(), state.data.data(), state.lambda.data());
}

}  // namespace dalembert
