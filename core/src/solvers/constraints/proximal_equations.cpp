#include "dalembert/solvers/proximal_equations.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dalembert {

namespace {

// 6 P^2 - 8 P^3 + 3 P^4 = 1 - (1 - P)^3 (1 + 3 P) is nearly one for P near one, and 6 P^2 for constraints with small P.
constexpr double misfit_factors[] = {0, 6, -8, 3};
constexpr int most_refinements = 12;  // joints that fit need 2 to 4
constexpr double refined = 1e-12;
// If the removed null-space part is larger than this, relative to the rest, its round-off requires another pass.
constexpr double large_part = 1e-3;
constexpr int most_passes = 4;

}  // namespace

ProximalEquations::ProximalEquations(int first, std::vector<double> metric)
    : first_(static_cast<std::size_t>(first)), metric_(std::move(metric)), entries_(metric_.size(), 0.0) {
  for (std::size_t k = 0; k < metric_.size(); ++k)
    if (metric_[k] > 0) rows_.push_back(static_cast<int>(k));
}

std::span<double> ProximalEquations::solve_for(LinearSolver& factors, std::span<const double> gaps) {
  x_.assign(first_ + gaps.size(), 0.0);
  std::ranges::copy(gaps, x_.begin() + static_cast<std::ptrdiff_t>(first_));
  factors.solve(x_);
  return x_;
}

std::vector<double> ProximalEquations::misfit(LinearSolver& factors, std::span<const double> gaps) {
  std::vector<double> power(gaps.begin(), gaps.end()), open(gaps.size(), 0.0);
  for (std::size_t k = 0; k < power.size(); ++k)
    if (!(metric_[k] > 0)) power[k] = 0;
  for (const double factor : misfit_factors) {
    const std::span<const double> x = solve_for(factors, power);
    for (std::size_t k = 0; k < power.size(); ++k) {
      power[k] = entries_[k] * x[first_ + k];
      open[k] += factor * power[k];
    }
  }
  return open;
}

// Iterative refinement. The residual of the exact constraints after a solution is -eps D lambda: no product with the
// matrix is needed.
void ProximalEquations::solve(LinearSolver& factors, std::span<double> x, bool fit) {
  const auto squared_motion = [&](std::span<const double> numbers) {
    double sum = 0;
    for (std::size_t i = 0; i < first_; ++i) sum += numbers[i] * numbers[i];
    return sum;
  };
  const auto subtract_misfit = [&](std::span<double> gaps) {
    if (fit) return;
    const std::vector<double> open = misfit(factors, gaps);
    for (std::size_t k = 0; k < open.size(); ++k) gaps[k] -= open[k];
  };
  subtract_misfit(x.subspan(first_));
  factors.solve(x);
  rest_.assign(x.size() - first_, 0.0);
  for (std::size_t k = 0; k < rest_.size(); ++k) rest_[k] = entries_[k] * x[first_ + k];
  for (int i = 1; i < most_refinements; ++i) {
    subtract_misfit(rest_);
    const std::span<const double> change = solve_for(factors, rest_);
    for (std::size_t j = 0; j < x.size(); ++j) x[j] += change[j];
    for (std::size_t k = 0; k < rest_.size(); ++k) rest_[k] = entries_[k] * change[first_ + k];
    if (!(squared_motion(change) > refined * refined * squared_motion(x))) break;
  }
}

// Applies 1 - (4 P^3 - 3 P^4), which vanishes with its derivative at P = 1, so that round-off of P has no influence.
// Multipliers of a weak constraint, with P = 1e-3, change by 4e-9.
void ProximalEquations::make_smallest(LinearSolver& factors, std::span<double> multipliers) {
  const auto apply = [&](std::span<const double> from) {
    std::vector<double> to(from.size());
    for (std::size_t k = 0; k < to.size(); ++k) to[k] = entries_[k] * from[k];
    const std::span<const double> x = solve_for(factors, to);
    std::copy(x.begin() + static_cast<std::ptrdiff_t>(first_), x.end(), to.begin());
    for (std::size_t k = 0; k < to.size(); ++k)
      if (!(metric_[k] > 0)) to[k] = x[first_ + k];
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

}  // namespace dalembert
