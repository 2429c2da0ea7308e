#include "dalembert/solvers/constraint_solver.hpp"

#include <algorithm>
#include <cmath>

#include "constraints/constraint_states.hpp"

namespace dalembert {

namespace {

// The round-off of P is u s_max / eps: 1e-10 gives ten times the noise in multipliers. 1e-8 is too large to pass a flat
// position of 400 loops.
constexpr double regular_eps = 1e-9;
// Masses that differ by orders of magnitude make constraints weak in the metric. Multipliers of these must not be lost in eps.
constexpr double eps_per_strength = 1e-4, smallest_eps = 1e-12;
// A gap g turns a redundant constraint into one of the strength (g / arm)^2, which has to be at most 1e-6 eps for
// positions. Misfit passes suffice for rates.
constexpr double eps_per_squared_gap = 1e7, eps_of_rates_per_squared_gap = 1e4;
// Solvers refuse motions with larger gaps. Static iterates violate constraints more.
constexpr double largest_eps = 1e-6, largest_eps_of_rates = 1e-3, largest_static_eps = 1e-2;
// Newton's method leaves gaps up to this size in joints that fit.
constexpr double fitting_gap = 1e-11;
constexpr double visible_part =
    1e-3;  // of eps in the strength of a constraint, which is an estimate: errors of reactions above 1 %
constexpr double eps_of_free = 1e3;  // of equations that are left free

}  // namespace

void ConstraintSolver::prepare(System& system, const State& state, const Conditions& conditions,
                               const RedundantConstraintsSettings& settings, bool treats, Matrix kind) {
  forget();
  prepared_ = true;
  kind_ = kind;
  if (!treats) return;
  const ConstraintMetric metric = constraint_metric(system, state, conditions, settings.momentLength);
  first_ae_ = system.sizes().first_ae();
  if (!metric.has_loops) return;
  rank_ = ConstraintRank(system, state, conditions, metric);
  active_ = rank_.count() > 0 || !rank_.certain();
  frees_ = kind == Matrix::statics && rank_.count() > 0 && rank_.certain() &&
           metric.largest(gaps_of_positions(system, state, conditions)) <= fitting_gap;
  equations_ = ProximalEquations(first_ae_, metric.weights);
  units_ = metric.units;
  of_velocities_.assign(units_.size(), 0);
  const Pattern& pattern = system.pattern(false);
  std::vector<double> part(static_cast<std::size_t>(pattern.values()));
  system.tangent(without_multipliers(state), at_level(conditions, false), along_velocities, pattern, part);
  for_each_entry(pattern, [&](int row, int column, std::size_t slot) {
    if (row >= first_ae_ && column < system.sizes().ode2 && part[slot] != 0)
      of_velocities_[static_cast<std::size_t>(row - first_ae_)] = 1;
  });
  eps_ = regular_eps_ = std::clamp(eps_per_strength * rank_.strength(), smallest_eps, regular_eps);
}

bool ConstraintSolver::compare_rank(System& system, const State& near, const Conditions& conditions,
                                    const RedundantConstraintsSettings& settings) {
  if (rank_.count() == 0 || !rank_.certain() || rank_.allows_for_gaps()) return false;
  const ConstraintRank other(system, near, conditions,
                             constraint_metric(system, near, conditions, settings.momentLength));
  return rank_holds_nearby_ = other.count() == rank_.count();
}

bool ConstraintSolver::activate() {
  if (active_ || rows().empty()) return false;
  return active_ = true;
}

double ConstraintSolver::largest(std::span<const double> gaps) const {
  double size = 0;
  for (const int k : rows())
    if (!of_velocities_[static_cast<std::size_t>(k)])
      size = std::max(size, std::abs(gaps[static_cast<std::size_t>(k)]) / unit(k));
  return size;
}

double ConstraintSolver::largest_of_all(std::span<const double> gaps) const {
  double size = 0;
  for (std::size_t k = 0; k < gaps.size(); ++k)
    if (!of_velocities_[k]) size = std::max(size, std::abs(gaps[k]) / units_[k]);
  return size;
}

void ConstraintSolver::choose(double gap, bool of_rates) {
  if (frees_) {
    fit_ = true;
    return;
  }
  const bool moves = kind_ != Matrix::statics;
  const double most = moves ? std::max(largest_gap_, gap) : gap;
  fit_ = !((kind_ == Matrix::motion ? largest_gap_ : most) > fitting_gap);
  eps_ = std::clamp((of_rates ? eps_of_rates_per_squared_gap : eps_per_squared_gap) * most * most, regular_eps_,
                    !moves     ? largest_static_eps
                    : of_rates ? largest_eps_of_rates
                               : largest_eps);
  hides_constraints_ |= active_ && moves && eps_ > regular_eps_ && eps_ > visible_part * rank_.strength();
}

LinearSolverOptions ConstraintSolver::options(LinearSolverOptions options) const {
  if (!active_) return options;
  for (const int k : rows()) options.tiny_diagonal.push_back(first_ae_ + k);
  for (const int k : rank_.dependent()) options.dependent.push_back(first_ae_ + k);
  return options;
}

void ConstraintSolver::regularize(const Pattern& pattern, std::span<double> values, double scale, double rate,
                                  bool all_rates) {
  if (slots_.empty())
    for (const int k : rows()) slots_.push_back(pattern.slot(first_ae_ + k, first_ae_ + k));
  std::vector<char> is_free(units_.size(), 0);
  if (frees_)
    for (const int k : rank_.dependent()) is_free[static_cast<std::size_t>(k)] = 1;
  const std::span<const double> metric = equations_.metric();
  const std::span<double> entries = equations_.entries();
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    const auto k = static_cast<std::size_t>(rows()[i]);
    double& value = values[static_cast<std::size_t>(slots_[i])];
    entries[k] = 0;
    if (value != 0) continue;  // an inactive equation defines its multiplier
    const double eps = !frees_ ? eps_ : is_free[k] ? eps_of_free : 0;
    value = entries[k] = -eps * scale * metric[k] * (all_rates || of_velocities_[k] ? rate : 1);
  }
}

double scale_of_masses(std::span<const double> masses, const Pattern& pattern, std::span<const double> matrix,
                       int ode2) {
  constexpr double round_off = 1e-10;  // smaller entries, relative to the largest, are round-off of terms that cancel
  std::vector<double> ratios;
  for (int j = 0; j < ode2; ++j) {
    const double mass = masses[static_cast<std::size_t>(j)];
    if (mass > 0) ratios.push_back(std::abs(matrix[static_cast<std::size_t>(pattern.slot(j, j))]) / mass);
  }
  const double most = ratios.empty() ? 0 : std::ranges::max(ratios);
  std::erase_if(ratios, [most](double x) { return !(x > round_off * most); });
  if (ratios.empty()) return 1;
  const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
  std::ranges::nth_element(ratios, middle);
  return 1 / *middle;
}

}  // namespace dalembert
