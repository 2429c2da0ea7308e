// Combinations of constraint equations that vanish, by block inverse iteration: P has the eigenvalue one for them, and eps/(eps + s)
// for all others.
#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include "dalembert/math/decompositions.hpp"
#include "dalembert/output/numbers.hpp"
#include "dalembert/solvers/numerical_tangent.hpp"
#include "dalembert/solvers/redundant_constraints.hpp"

namespace dalembert {

namespace {

constexpr int block_size = 8;
constexpr int iterations = 2;
constexpr int most_refinements = 2;         // of solutions
constexpr double accurate = 1e-5;           // corrections of multipliers that change nothing of what is found
constexpr double evidently_regular = 1e-3;  // eigenvalues of combinations that do not vanish
constexpr double removable_share = 1e-10;  // squared: of the equations of an item in combinations that vanish

using Block = Eigen::MatrixXd;

}  // namespace

bool RedundantConstraints::find(const Pattern& pattern, std::span<const double> values, double eps, LinearSolverType type,
                                LinearSolverOptions linear_options) {
  linear_options.unsettled_matrices = 0;
  std::vector<double> matrix(values.begin(), values.end());
  const double in_use = std::exchange(eps_, eps);
  regularize(pattern, matrix, rate_factor_);
  eps_ = in_use;
  const auto factors = make_linear_solver(pattern, type, linear_options);
  if (factors->factorize(matrix) != LinearSolver::success) return false;

  const auto m = static_cast<Eigen::Index>(rows_.size());
  Eigen::VectorXd root(m);
  for (Eigen::Index i = 0; i < m; ++i) root[i] = std::sqrt(weight_[rows_[i]]);
  std::vector<double> lambda(weight_.size()), wanted, rest;
  const auto largest_multiplier = [&](const std::vector<double>& x) {
    double size = 0;
    for (const int k : rows_) size = std::max(size, std::abs(x[static_cast<std::size_t>(first_ae_ + k)]));
    return size;
  };
  // As `apply`; in large systems, factors alone leave too much of the small numbers that count here, as the first solution shows.
  int refinements = most_refinements;
  const auto apply_with_care = [&](std::vector<double>& multipliers) {
    wanted.assign(x_.size(), 0.0);
    for (const int k : rows_) wanted[static_cast<std::size_t>(first_ae_ + k)] = -eps * row_factor(k) * weight_[k] * multipliers[static_cast<std::size_t>(k)];
    std::ranges::fill(x_, 0.0);
    for (int time = 0; time <= refinements; ++time) {
      rest = wanted;
      if (time > 0) for_each_entry(pattern, [&](int row, int column, std::size_t slot) { rest[row] -= matrix[slot] * x_[column]; });
      factors->solve(rest);
      for (std::size_t i = 0; i < x_.size(); ++i) x_[i] += rest[i];
      if (time > 0 && largest_multiplier(rest) < accurate * largest_multiplier(x_)) refinements = time - 1;
    }
    for (std::size_t k = 0; k < multipliers.size(); ++k) multipliers[k] = multiplier_[k] ? x_[static_cast<std::size_t>(first_ae_) + k] : 0;
  };
  const auto image = [&](Block block) {
    for (Eigen::Index j = 0; j < block.cols(); ++j) {
      std::ranges::fill(lambda, 0.0);
      for (Eigen::Index i = 0; i < m; ++i) lambda[rows_[i]] = block(i, j) / root[i];
      apply_with_care(lambda);
      for (Eigen::Index i = 0; i < m; ++i) block(i, j) = lambda[rows_[i]] * root[i];
    }
    return block;
  };

  std::mt19937 random(1);
  Block known(m, 0);
  rest_ = 0;
  while (known.cols() < m) {
    Block block(m, std::min<Eigen::Index>(block_size, m - known.cols()));
    for (double& x : block.reshaped()) x = static_cast<double>(random()) / 2147483648.0 - 1;
    block = orthonormal_beside(known, block);
    for (int i = 0; i < iterations; ++i) block = orthonormal_beside(known, image(block));
    const Block small = block.transpose() * image(block);
    if (!small.allFinite()) return false;
    const SymmetricEigenpairs shares = symmetric_eigenpairs((small + small.transpose()) / 2);
    const auto vanishing = static_cast<Eigen::Index>(std::ranges::count_if(shares.values, [](double x) { return x > 0.5; }));
    rest_ = vanishing < block.cols() ? std::max(0.0, shares.values[block.cols() - vanishing - 1]) : 0;
    Block more(m, known.cols() + vanishing);
    more << known, block * shares.vectors.rightCols(vanishing);
    known = std::move(more);
    // Round-off may have spoilt some of those before, but not where factors do by themselves.
    if (vanishing == 0 || (vanishing < block.cols() && rest_ < evidently_regular && refinements == 0)) break;
  }
  count_ = static_cast<int>(known.cols());
  weakest_ = rest_ > 0 ? eps * (1 / rest_ - 1) : 1;
  combinations_.assign(known.data(), known.data() + known.size());
  return true;
}

// Equations of one item can be left out as long as the rest of the combinations stays independent of them: as many as the rank of
// their part of the combinations.
std::vector<RedundantConstraints::Item> RedundantConstraints::items(const System& system) const {
  std::vector<Item> found;
  if (count_ == 0) return found;
  const Eigen::Map<const Block> all(combinations_.data(), static_cast<Eigen::Index>(rows_.size()), count_);
  for (const System::EquationOwner& owner : system.equation_owners()) {
    const auto begin = std::ranges::lower_bound(rows_, owner.first), end = std::ranges::lower_bound(rows_, owner.first + owner.count);
    if (begin == end) continue;
    const Block part = all.middleRows(begin - rows_.begin(), end - begin);
    if (!(part.squaredNorm() > removable_share)) continue;
    const auto rank = std::ranges::count_if(symmetric_eigenvalues(part * part.transpose()), [](double x) { return x > removable_share; });
    const auto acting = std::count(acting_.begin() + owner.first, acting_.begin() + owner.first + owner.count, 1);
    found.push_back({owner.number, system.describe(owner), owner.first, owner.count, static_cast<int>(acting), static_cast<int>(rank)});
  }
  return found;
}

// What vanishes of a gap is the same wherever it is: the smallest gap of the item alone that has as much of it.
std::vector<std::string> RedundantConstraints::contradictions(std::span<const double> misfit, const System& system) const {
  constexpr double not_all = 1e-2;
  std::vector<std::string> lines;
  if (count_ == 0) return lines;
  const Eigen::Map<const Block> all(combinations_.data(), static_cast<Eigen::Index>(rows_.size()), count_);
  Eigen::VectorXd scaled(all.rows());
  for (Eigen::Index i = 0; i < scaled.size(); ++i) scaled[i] = misfit[rows_[i]] / std::sqrt(weight_[rows_[i]]);
  const Eigen::VectorXd whole = all.transpose() * scaled;
  for (const Item& item : items(system)) {
    const auto first = std::ranges::lower_bound(rows_, item.first) - rows_.begin();
    const auto count = std::ranges::lower_bound(rows_, item.first + item.rows) - rows_.begin() - first;
    Eigen::VectorXd gap = smallest_solution(all.middleRows(first, count).transpose(), whole);
    if ((all.middleRows(first, count).transpose() * gap - whole).norm() > not_all * whole.norm()) continue;
    for (Eigen::Index i = 0; i < count; ++i) gap[i] *= std::sqrt(weight_[rows_[first + i]]);
    Eigen::Index worst = 0;
    gap.cwiseAbs().maxCoeff(&worst);
    const int equation = rows_[first + worst];
    const char* unit = units_[equation] == CoordinateUnit::meter ? " m" : units_[equation] == CoordinateUnit::radian ? " rad" : "";
    lines.push_back(item.item + ", equation " + std::to_string(equation - item.first) + ": " + format_number(gap[worst]) + unit);
  }
  return lines;
}

}  // namespace dalembert
