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
// 6 P^2 - 8 P^3 + 3 P^4 = 1 - (1 - P)^3 (1 + 3 P) is nearly one for P near one, and 6 P^2 for constraints with small P.
constexpr double misfit_factors[] = {0, 6, -8, 3};
// Newton's method leaves gaps up to this size in joints that fit.
constexpr double fitting_gap = 1e-11;
constexpr double visible_part =
    1e-3;  // of eps in the strength of a constraint, which is an estimate: errors of reactions above 1 %
constexpr double eps_of_free = 1e3;  // of equations that are left free
constexpr int most_refinements = 12;  // joints that fit need 2 to 4
constexpr double refined = 1e-12;
// If the removed null-space part is larger than this, relative to the rest, its round-off requires another pass.
constexpr double large_part = 1e-3;
constexpr int most_passes = 4;

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
  const ConstraintRank rank(system, state, conditions, metric);
  active_ = rank.count() > 0 || !rank.certain();
  dependent_ = rank.dependent();
  frees_ = kind == Matrix::statics && !dependent_.empty() && rank.certain() &&
           metric.largest(gaps_of_positions(system, state, conditions)) <= fitting_gap;
  metric_ = metric.weights;
  units_ = metric.units;
  for (std::size_t k = 0; k < metric_.size(); ++k)
    if (metric_[k] > 0) rows_.push_back(static_cast<int>(k));
  of_velocities_.assign(metric_.size(), 0);
  const Pattern& pattern = system.pattern(false);
  std::vector<double> part(static_cast<std::size_t>(pattern.values()));
  system.tangent(without_multipliers(state), at_level(conditions, false), along_velocities, pattern, part);
  for_each_entry(pattern, [&](int row, int column, std::size_t slot) {
    if (row >= first_ae_ && column < system.sizes().ode2 && part[slot] != 0)
      of_velocities_[static_cast<std::size_t>(row - first_ae_)] = 1;
  });
  entries_.assign(metric_.size(), 0.0);
  strength_ = rank.strength();
  eps_ = regular_eps_ = std::clamp(eps_per_strength * strength_, smallest_eps, regular_eps);
}

bool ConstraintSolver::activate() {
  if (active_ || rows_.empty()) return false;
  return active_ = true;
}

double ConstraintSolver::largest(std::span<const double> gaps) const {
  double size = 0;
  for (const int k : rows_)
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
  hides_constraints_ |= active_ && moves && eps_ > regular_eps_ && eps_ > visible_part * strength_;
}

LinearSolverOptions ConstraintSolver::options(LinearSolverOptions options) const {
  if (!active_) return options;
  for (const int k : rows_) options.tiny_diagonal.push_back(first_ae_ + k);
  for (const int k : dependent_) options.dependent.push_back(first_ae_ + k);
  return options;
}

void ConstraintSolver::regularize(const Pattern& pattern, std::span<double> values, double scale, double rate,
                                  bool all_rates) {
  if (slots_.empty())
    for (const int k : rows_) slots_.push_back(pattern.slot(first_ae_ + k, first_ae_ + k));
  std::vector<char> is_free(metric_.size(), 0);
  if (frees_)
    for (const int k : dependent_) is_free[static_cast<std::size_t>(k)] = 1;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const auto k = static_cast<std::size_t>(rows_[i]);
    double& value = values[static_cast<std::size_t>(slots_[i])];
    entries_[k] = 0;
    if (value != 0) continue;  // an inactive equation defines its multiplier
    const double eps = !frees_ ? eps_ : is_free[k] ? eps_of_free : 0;
    value = entries_[k] = -eps * scale * metric_[k] * (all_rates || of_velocities_[k] ? rate : 1);
  }
}

std::span<double> ConstraintSolver::solve_for(LinearSolver& factors, std::span<const double> gaps) {
  x_.assign(static_cast<std::size_t>(first_ae_) + gaps.size(), 0.0);
  std::ranges::copy(gaps, x_.begin() + first_ae_);
  factors.solve(x_);
  return x_;
}

std::vector<double> ConstraintSolver::misfit(LinearSolver& factors, std::span<const double> gaps) {
  std::vector<double> power(gaps.begin(), gaps.end()), open(gaps.size(), 0.0);
  for (std::size_t k = 0; k < power.size(); ++k)
    if (!(metric_[k] > 0)) power[k] = 0;
  for (const double factor : misfit_factors) {
    const std::span<const double> x = solve_for(factors, power);
    for (std::size_t k = 0; k < power.size(); ++k) {
      power[k] = entries_[k] * x[static_cast<std::size_t>(first_ae_) + k];
      open[k] += factor * power[k];
    }
  }
  return open;
}

// Iterative refinement. The residual of the exact constraints after a solution is -eps D lambda: no product with the
// matrix is needed.
void ConstraintSolver::solve(LinearSolver& factors, std::span<double> x) {
  const auto first = static_cast<std::size_t>(first_ae_);
  const auto squared_motion = [&](std::span<const double> numbers) {
    double sum = 0;
    for (std::size_t i = 0; i < first; ++i) sum += numbers[i] * numbers[i];
    return sum;
  };
  const auto subtract_misfit = [&](std::span<double> gaps) {
    if (fit_) return;
    const std::vector<double> open = misfit(factors, gaps);
    for (std::size_t k = 0; k < open.size(); ++k) gaps[k] -= open[k];
  };
  subtract_misfit(x.subspan(first));
  factors.solve(x);
  rest_.assign(x.size() - first, 0.0);
  for (const int k : rows_) rest_[static_cast<std::size_t>(k)] = entry(k) * x[first + static_cast<std::size_t>(k)];
  for (int i = 1; i < most_refinements; ++i) {
    subtract_misfit(rest_);
    const std::span<const double> change = solve_for(factors, rest_);
    for (std::size_t j = 0; j < x.size(); ++j) x[j] += change[j];
    for (std::size_t k = 0; k < rest_.size(); ++k) rest_[k] = entries_[k] * change[first + k];
    if (!(squared_motion(change) > refined * refined * squared_motion(x))) break;
  }
}

// Applies 1 - (4 P^3 - 3 P^4), which vanishes with its derivative at P = 1, so that round-off of P has no influence.
// Multipliers of a weak constraint, with P = 1e-3, change by 4e-9.
void ConstraintSolver::make_smallest(LinearSolver& factors, std::span<double> multipliers) {
  const auto apply = [&](std::span<const double> from) {
    std::vector<double> to(from.size());
    for (const int k : rows_) to[static_cast<std::size_t>(k)] = entry(k) * from[static_cast<std::size_t>(k)];
    const std::span<const double> x = solve_for(factors, to);
    std::copy(x.begin() + first_ae_, x.end(), to.begin());
    for (std::size_t k = 0; k < to.size(); ++k)
      if (!(metric_[k] > 0)) to[k] = x[static_cast<std::size_t>(first_ae_) + k];
    return to;
  };
  for (int pass = 0; pass < most_passes; ++pass) {
    const std::vector<double> cubed = apply(apply(apply(multipliers))), fourth = apply(cubed);
    double removed = 0, left = 0;
    for (std::size_t k = 0; k < multipliers.size(); ++k) {
      const double part = 4 * cubed[k] - 3 * fourth[k];
      multipliers[k] -= part;
      removed += metric_[k] * part * part;
      left += metric_[k] * multipliers[k] * multipliers[k];
    }
    if (!(removed > large_part * large_part * left)) break;
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
