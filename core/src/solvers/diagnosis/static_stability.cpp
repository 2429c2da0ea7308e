// Stability of a static equilibrium: inertia of the stiffness matrix on the null space of the constraints.
//
// Sylvester's law of inertia: K = L D L^T has as many negative eigenvalues as D has negative entries. Constraints G
// enter as stiff springs, K + b G^T G, which for large b has as many negative eigenvalues as K has in the null space of
// G (Debreu's lemma), also with redundant constraints. A negative pivot alone may be round-off of large springs, or belong
// to a constraint that is weak in the scaled coordinates: its direction is projected onto the null space, and the
// curvature of the projection decides.
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include "dalembert/solvers/numerical_tangent.hpp"
#include "dalembert/solvers/static.hpp"
#include "diagnosis/orthogonal_factors.hpp"
#include "diagnosis/diagnostics.hpp"

namespace dalembert {

namespace stability_of_equilibria {

using Sparse = Eigen::SparseMatrix<double>;
using Vector = Eigen::VectorXd;
using Entries = std::vector<Eigen::Triplet<double>>;

// Constants for scaled coordinates, in which each stiffness is at most 1.
constexpr double spring = 1e6;  // b
constexpr double neutral = 1e-9;  // stiffness that counts as zero
constexpr double largest_asymmetry = 1e-6;  // of forces with a potential
constexpr double rounding = 1e-9;  // relative to the terms that cancel in a curvature

struct Problem {
  Sparse K, G;  // scaled
  Vector scale;  // coordinates = scale * scaled coordinates
  bool has_potential = true;
};

// Coordinates without stiffness get their scale from constraints that connect them with other coordinates.
static Vector scales(int n, const Entries& stiffness, const std::vector<Entries>& rows) {
  Vector size = Vector::Zero(n), scale = Vector::Zero(n);
  for (const auto& e : stiffness) size[e.row()] = std::max(size[e.row()], std::abs(e.value()));
  for (int i = 0; i < n; ++i)
    if (size[i] > 0) scale[i] = 1 / std::sqrt(size[i]);
  for (bool found = true; std::exchange(found, false);)
    for (const Entries& row : rows) {
      double reach = 0;
      for (const auto& e : row) reach = std::max(reach, std::abs(e.value()) * scale[e.col()]);
      if (reach == 0) continue;
      for (const auto& e : row)
        if (scale[e.col()] == 0 && e.value() != 0) scale[e.col()] = reach / std::abs(e.value()), found = true;
    }
  return scale.unaryExpr([](double x) { return x == 0 ? 1.0 : x; });
}

static Problem problem_of(const Pattern& pattern, std::span<const double> matrix, const Sizes& sizes) {
  const int n = sizes.ode2, first = sizes.first_ae();
  Entries stiffness, reactions;
  std::vector<Entries> rows(static_cast<std::size_t>(sizes.ae));
  for_each_entry(pattern, [&](int row, int column, std::size_t slot) {
    const double value = matrix[slot];
    if (value == 0) return;
    if (row < n && column < n)
      stiffness.emplace_back(row, column, value);
    else if (row >= first && column < n)
      rows[static_cast<std::size_t>(row - first)].emplace_back(row - first, column, value);
    else if (row < n && column >= first)
      reactions.emplace_back(column - first, row, value);
  });
  Problem p;
  p.scale = scales(n, stiffness, rows);
  Entries constraints;
  std::vector<double> length(rows.size(), 1.0);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    double largest = 0;
    for (const auto& e : rows[k]) largest = std::max(largest, std::abs(e.value()) * p.scale[e.col()]);
    if (largest > 0) length[k] = 1 / largest;
    for (const auto& e : rows[k]) constraints.emplace_back(e.row(), e.col(), e.value() * p.scale[e.col()] * length[k]);
  }
  for (auto& e : reactions)
    e = {e.row(), e.col(), e.value() * p.scale[e.col()] * length[static_cast<std::size_t>(e.row())]};
  for (auto& e : stiffness) e = {e.row(), e.col(), e.value() * p.scale[e.row()] * p.scale[e.col()]};
  p.K.resize(n, n);
  p.K.setFromTriplets(stiffness.begin(), stiffness.end());
  p.G.resize(sizes.ae, n);
  p.G.setFromTriplets(constraints.begin(), constraints.end());
  Sparse R(sizes.ae, n);
  R.setFromTriplets(reactions.begin(), reactions.end());
  const Sparse KT = p.K.transpose(), asymmetry = p.K - KT, beside = p.G - R;
  const auto largest = [](const Sparse& m) { return m.nonZeros() == 0 ? 0.0 : m.coeffs().abs().maxCoeff(); };
  p.has_potential = largest(asymmetry) < largest_asymmetry && largest(beside) < largest_asymmetry;
  p.K = 0.5 * (p.K + KT);
  return p;
}

// Projects vectors onto the null space of the constraint Jacobian.
class Projection {
 public:
  Projection(const Sparse& G, std::span<const int> dependent)
      : columns_(columns(G, dependent)), factors_(columns_, static_cast<int>(G.cols()), 0) {}

  // Two sweeps remove the round-off of weak constraints.
  void apply(Vector& x) const {
    for (int sweep = 0; sweep < 2; ++sweep) {
      std::vector<double> along(columns_.size(), 0.0);
      for (std::size_t k = 0; k < columns_.size(); ++k)
        for (const auto& [row, value] : columns_[k]) along[k] += value * x[row];
      const std::vector<double> part = factors_.solve_normal_equations(along);
      for (std::size_t k = 0; k < columns_.size(); ++k)
        for (const auto& [row, value] : columns_[k]) x[row] -= value * part[k];
    }
  }

 private:
  // Columns of dependent equations stay empty.
  static std::vector<OrthogonalFactors::Vector> columns(const Sparse& G, std::span<const int> dependent) {
    std::vector<OrthogonalFactors::Vector> columns(static_cast<std::size_t>(G.rows()));
    std::vector<double> squares(columns.size(), 0.0);
    for (int j = 0; j < G.outerSize(); ++j)
      for (Sparse::InnerIterator e(G, j); e; ++e) squares[static_cast<std::size_t>(e.row())] += e.value() * e.value();
    for (int j = 0; j < G.outerSize(); ++j)
      for (Sparse::InnerIterator e(G, j); e; ++e) {
        const auto k = static_cast<std::size_t>(e.row());
        if (e.value() != 0) columns[k].push_back({j, e.value() / std::sqrt(squares[k])});
      }
    for (const int k : dependent) columns[static_cast<std::size_t>(k)].clear();
    return columns;
  }

  std::vector<OrthogonalFactors::Vector> columns_;  // of unit length
  OrthogonalFactors factors_;
};

struct Found {
  int directions = 0;
  std::vector<double> direction;
};

// Counts directions with negative stiffness, and returns one of them. The result is empty for forces without a
// potential.
static Found find(const Pattern& pattern, std::span<const double> matrix, const Sizes& sizes,
                  std::span<const int> dependent) {
  const Problem p = problem_of(pattern, matrix, sizes);
  if (!p.has_potential || !p.K.coeffs().allFinite() || !p.G.coeffs().allFinite()) return {};
  Sparse shift(p.K.rows(), p.K.cols());
  shift.setIdentity();
  Sparse all = p.K + neutral * shift;
  if (p.G.nonZeros() > 0) all += spring * Sparse(p.G.transpose()) * p.G;
  const Eigen::SimplicialLDLT<Sparse> factors(all);
  if (factors.info() != Eigen::Success) return {};
  const Vector& pivots = factors.vectorD();
  if (!(pivots.array() < 0).any()) return {};
  const Projection projection(p.G, dependent);
  Found found;
  for (Eigen::Index k = 0; k < pivots.size(); ++k) {
    if (!(pivots[k] < 0)) continue;
    Vector x = Vector::Unit(pivots.size(), k);
    factors.matrixU().solveInPlace(x);
    x = factors.permutationPinv() * x;
    projection.apply(x);
    const double curvature = x.dot(p.K * x), terms = x.cwiseAbs().dot(p.K.cwiseAbs() * x.cwiseAbs());
    if (!(curvature < -rounding * terms)) continue;
    if (++found.directions > 1) continue;
    const Vector own = p.scale.cwiseProduct(x);
    found.direction.assign(own.data(), own.data() + own.size());
  }
  return found;
}

}  // namespace stability_of_equilibria

// Uses the matrix of the equilibrium, including loads.
StaticSolver::Instability StaticSolver::find_instability() {
  if (sizes_.ode1 > 0) return {};
  for (int k = 0; k < sizes_.ae; ++k)
    if (!system().constrains_motion(k)) return {};
  if (!rank_known_) find_rank();
  auto found = stability_of_equilibria::find(pattern(), jacobian_, sizes_, rank_.dependent());
  return {found.directions, std::move(found.direction)};
}

void StaticSolver::look_for_instability() {
  constexpr double large_share = 0.5;  // relative to the largest one
  const Instability found = find_instability();
  if (found.directions == 0) return;
  double largest = 0;
  for (const double x : found.direction) largest = std::max(largest, std::abs(x));
  std::vector<int> rows;
  for (std::size_t i = 0; i < found.direction.size(); ++i)
    if (std::abs(found.direction[i]) >= large_share * largest) rows.push_back(static_cast<int>(i));
  diagnostics_->warn_of_instability(found.directions, rows);
}

}  // namespace dalembert
