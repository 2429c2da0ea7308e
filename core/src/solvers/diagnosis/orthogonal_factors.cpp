#include "diagnosis/orthogonal_factors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

namespace dalembert {

namespace {

constexpr double round_off =
    1e-15;  // smaller entries of a row that has been rotated are dropped; columns have unit length

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// An order of the columns with few nonzeros in R.
std::vector<int> elimination_order(const std::vector<OrthogonalFactors::Vector>& columns, int rows) {
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t j = 0; j < columns.size(); ++j)
    for (const auto& [row, value] : columns[j]) entries.emplace_back(row, static_cast<int>(j), value);
  Eigen::SparseMatrix<double> matrix(rows, static_cast<Eigen::Index>(columns.size()));
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::COLAMDOrdering<int>::PermutationType position;
  Eigen::COLAMDOrdering<int>()(matrix, position);
  std::vector<int> order(columns.size());
  for (std::size_t j = 0; j < order.size(); ++j)
    order[at(position.indices()[static_cast<Eigen::Index>(j)])] = static_cast<int>(j);
  return order;
}

}  // namespace

OrthogonalFactors::OrthogonalFactors(const std::vector<Vector>& columns, int rows, double tolerance)
    : order_(elimination_order(columns, rows)), rows_(columns.size()) {
  std::vector<Vector> of_matrix(at(rows));
  for (std::size_t k = 0; k < order_.size(); ++k)
    for (const auto& [row, value] : columns[at(order_[k])]) of_matrix[at(row)].push_back({static_cast<int>(k), value});
  // Rows that end early first, so that intermediate rows stay short (George and Heath 1980).
  std::ranges::stable_sort(of_matrix, {}, [](const Vector& row) { return row.empty() ? -1 : row.back().index; });
  for (Vector& row : of_matrix) rotate_in(std::move(row));

  for (std::size_t k = 0; k < rows_.size(); ++k) {
    const double pivot = rows_[k].empty() ? 0 : rows_[k].front().value * rows_[k].front().value;
    if (pivot > tolerance) {
      smallest_pivot_ = smallest_pivot_ == 0 ? pivot : std::min(smallest_pivot_, pivot);
      continue;
    }
    dependent_.push_back(order_[k]);
    if (rows_[k].empty()) continue;
    Vector rest(rows_[k].begin() + 1, rows_[k].end());
    rows_[k].clear();
    rotate_in(std::move(rest));
  }
}

void OrthogonalFactors::rotate_in(Vector row) {
  while (!row.empty()) {
    Vector& pivot = rows_[at(row.front().index)];
    if (pivot.empty()) {
      pivot = std::move(row);
      return;
    }
    const double length = std::hypot(pivot.front().value, row.front().value);
    const double c = length > 0 ? pivot.front().value / length : 1, s = length > 0 ? row.front().value / length : 0;
    pivot_.clear();
    other_.clear();
    pivot_.push_back({pivot.front().index, length});
    for (auto p = pivot.begin() + 1, r = row.begin() + 1; p != pivot.end() || r != row.end();) {
      const bool of_pivot = r == row.end() || (p != pivot.end() && p->index <= r->index);
      const bool of_row = p == pivot.end() || (r != row.end() && r->index <= p->index);
      const int index = of_pivot ? p->index : r->index;
      const double a = of_pivot ? (p++)->value : 0, b = of_row ? (r++)->value : 0;
      pivot_.push_back({index, c * a + s * b});
      if (const double rest = c * b - s * a; std::abs(rest) > round_off) other_.push_back({index, rest});
    }
    pivot.swap(pivot_);
    row.swap(other_);
  }
}

double OrthogonalFactors::smallest_pivot(std::span<const double> factors) const {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < rows_.size(); ++k)
    if (!rows_[k].empty())
      least = std::min(least, factors[at(order_[k])] * rows_[k].front().value * rows_[k].front().value);
  return least;
}

std::vector<double> OrthogonalFactors::null_vector(std::span<const double> of_dependent) const {
  std::vector<double> vector(order_.size(), 0.0);
  for (std::size_t i = 0; i < dependent_.size(); ++i) vector[at(dependent_[i])] = of_dependent[i];
  for (std::size_t k = rows_.size(); k-- > 0;) {
    if (rows_[k].empty()) continue;
    double sum = 0;
    for (const auto& [position, value] : std::span(rows_[k]).subspan(1))
      sum += value * vector[at(order_[at(position)])];
    vector[at(order_[k])] = -sum / rows_[k].front().value;
  }
  return vector;
}

// C^T C = R^T R for the independent columns.
std::vector<double> OrthogonalFactors::solve_normal_equations(std::span<const double> b) const {
  std::vector<double> y(b.begin(), b.end());
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    double& value = y[at(order_[k])];
    if (rows_[k].empty()) {
      value = 0;
      continue;
    }
    value /= rows_[k].front().value;
    for (const auto& [position, entry] : std::span(rows_[k]).subspan(1)) y[at(order_[at(position)])] -= entry * value;
  }
  for (std::size_t k = rows_.size(); k-- > 0;) {
    if (rows_[k].empty()) continue;
    double& value = y[at(order_[k])];
    for (const auto& [position, entry] : std::span(rows_[k]).subspan(1)) value -= entry * y[at(order_[at(position)])];
    value /= rows_[k].front().value;
  }
  return y;
}

}  // namespace dalembert
