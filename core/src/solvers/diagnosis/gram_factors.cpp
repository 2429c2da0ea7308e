#include "diagnosis/gram_factors.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <Eigen/SparseQR>

namespace dalembert {

namespace {

// Pivots have round-off of this size. Larger ones that are not clearly below the tolerance, but small enough to be
// inaccurate, are computed again from the columns.
constexpr double round_off = 1e-14, clearly_below = 0.1, ambiguous = 1e-7;
constexpr int corrections = 1;
constexpr int most_accurate = 100;  // each takes as long as a solution
constexpr int largest_of_qr = 400;  // columns

}  // namespace

GramFactors::GramFactors(const std::vector<Column>& columns, int rows, double tolerance)
    : size_(static_cast<int>(columns.size())), rows_(rows), lower_(columns.size()), pivots_(columns.size(), 0.0) {
  if (size_ <= largest_of_qr) {
    factorize_accurately(columns, tolerance);
    return;
  }
  std::vector<Eigen::Triplet<double>> entries;
  for (int j = 0; j < size_; ++j)
    for (const auto& [row, value] : columns[static_cast<std::size_t>(j)]) entries.emplace_back(row, j, value);
  Eigen::SparseMatrix<double> matrix(rows, size_);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SparseMatrix<double> gram = matrix.transpose() * matrix;
  Eigen::AMDOrdering<int>::PermutationType permutation;
  Eigen::AMDOrdering<int>()(gram, permutation);  // the inverse: position to column
  order_.assign(permutation.indices().begin(), permutation.indices().end());
  std::vector<int> position(columns.size());
  for (int k = 0; k < size_; ++k) position[static_cast<std::size_t>(order_[static_cast<std::size_t>(k)])] = k;
  for (const int j : order_) columns_.push_back(columns[static_cast<std::size_t>(j)]);

  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  std::vector<int> parent(columns.size(), -1), visited(columns.size(), -1), path, reach;
  std::vector<double> y(columns.size(), 0.0);
  int left = most_accurate;
  for (int k = 0; k < size_; ++k) {
    double pivot = 0;
    reach.clear();
    visited[at(k)] = k;
    // Nonzeros of row k of L: all nodes on the paths of the elimination tree from the entries of column k to k.
    for (Eigen::SparseMatrix<double>::InnerIterator it(gram, order_[at(k)]); it; ++it) {
      int i = position[at(static_cast<int>(it.row()))];
      if (i == k) pivot = it.value();
      if (i >= k) continue;
      y[at(i)] += it.value();
      path.clear();
      for (; visited[at(i)] != k; i = parent[at(i)]) {
        if (parent[at(i)] < 0) parent[at(i)] = k;
        path.push_back(i);
        visited[at(i)] = k;
      }
      reach.insert(reach.end(), path.rbegin(), path.rend());
    }
    // Descendants stand after their ancestors in `reach`.
    for (auto node = reach.rbegin(); node != reach.rend(); ++node) {
      const double entry = y[at(*node)];
      y[at(*node)] = 0;
      if (pivots_[at(*node)] == 0) continue;
      for (const auto& [row, value] : lower_[at(*node)]) y[at(row)] -= value * entry;
      const double scaled = entry / pivots_[at(*node)];
      pivot -= scaled * entry;
      lower_[at(*node)].push_back({k, scaled});
    }
    if (pivot > std::max(round_off, clearly_below * tolerance) && pivot < ambiguous && left-- > 0) pivot = accurate_remainder(k);
    if (pivot > tolerance && pivot > round_off * round_off) {
      pivots_[at(k)] = pivot;
      smallest_pivot_ = smallest_pivot_ == 0 ? pivot : std::min(smallest_pivot_, pivot);
    } else {
      dropped_.push_back(k);
      dependent_.push_back(order_[at(k)]);
    }
  }
}

void GramFactors::factorize_accurately(const std::vector<Column>& columns, double tolerance) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int j = 0; j < size_; ++j)
    for (const auto& [row, value] : columns[static_cast<std::size_t>(j)]) entries.emplace_back(row, j, value);
  Eigen::SparseMatrix<double> matrix(std::max(rows_, size_), size_);
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::SparseQR<Eigen::SparseMatrix<double>, Eigen::COLAMDOrdering<int>> qr;
  qr.setPivotThreshold(std::sqrt(tolerance));
  qr.compute(matrix);
  const auto rank = static_cast<int>(qr.rank());
  const auto& order = qr.colsPermutation().indices();
  const Eigen::SparseMatrix<double> triangle = qr.matrixR();
  for (int i = 0; i < rank; ++i) {
    const double pivot = triangle.coeff(i, i) * triangle.coeff(i, i);
    smallest_pivot_ = i == 0 ? pivot : std::min(smallest_pivot_, pivot);
  }
  if (rank == size_) return;
  const Eigen::SparseMatrix<double> independent = triangle.topLeftCorner(rank, rank);
  const Eigen::MatrixXd others = Eigen::MatrixXd(triangle.topRightCorner(rank, size_ - rank));
  const Eigen::MatrixXd combined = independent.triangularView<Eigen::Upper>().solve(others);
  for (int i = rank; i < size_; ++i) {
    dependent_.push_back(order[i]);
    std::vector<double>& vector = null_vectors_.emplace_back(columns.size(), 0.0);
    vector[static_cast<std::size_t>(order[i])] = 1;
    for (int j = 0; j < rank; ++j) vector[static_cast<std::size_t>(order[j])] = -combined(j, i - rank);
  }
}

void GramFactors::solve(std::span<double> x, int end) const {
  const auto columns = static_cast<std::size_t>(end);
  for (std::size_t i = 0; i < columns; ++i) {
    if (pivots_[i] == 0) {
      x[i] = 0;
      continue;
    }
    for (const auto& [row, value] : lower_[i])
      if (row < end) x[static_cast<std::size_t>(row)] -= value * x[i];
  }
  for (std::size_t i = columns; i-- > 0;) {
    if (pivots_[i] == 0) continue;
    x[i] /= pivots_[i];
    for (const auto& [row, value] : lower_[i])
      if (row < end) x[i] -= value * x[static_cast<std::size_t>(row)];
  }
}

std::vector<double> GramFactors::combination(std::vector<double>& x, int end) const {
  const auto columns = static_cast<std::size_t>(end);
  std::vector<double> sum(columns, 0.0), change(columns);
  for (int pass = 0; pass <= corrections; ++pass) {
    for (std::size_t i = 0; i < columns; ++i) {
      change[i] = 0;
      for (const auto& [row, value] : columns_[i]) change[i] += value * x[static_cast<std::size_t>(row)];
    }
    solve(change, end);
    for (std::size_t i = 0; i < columns; ++i) {
      sum[i] += change[i];
      if (change[i] == 0) continue;
      for (const auto& [row, value] : columns_[i]) x[static_cast<std::size_t>(row)] -= value * change[i];
    }
  }
  return sum;
}

double GramFactors::accurate_remainder(int k) const {
  std::vector<double> x(static_cast<std::size_t>(rows_), 0.0);
  for (const auto& [row, value] : columns_[static_cast<std::size_t>(k)]) x[static_cast<std::size_t>(row)] = value;
  combination(x, k);
  double squares = 0;
  for (const double value : x) squares += value * value;
  return squares;
}

std::vector<double> GramFactors::null_vector(std::span<const double> of_dependent) const {
  std::vector<double> x(static_cast<std::size_t>(rows_), 0.0), vector(static_cast<std::size_t>(size_), 0.0);
  for (std::size_t i = 0; i < null_vectors_.size(); ++i)
    for (std::size_t j = 0; j < vector.size(); ++j) vector[j] += of_dependent[i] * null_vectors_[i][j];
  if (dropped_.empty()) return vector;
  for (std::size_t i = 0; i < dropped_.size(); ++i) {
    vector[static_cast<std::size_t>(dependent_[i])] = of_dependent[i];
    for (const auto& [row, value] : columns_[static_cast<std::size_t>(dropped_[i])]) x[static_cast<std::size_t>(row)] += of_dependent[i] * value;
  }
  const std::vector<double> sum = combination(x, size_);
  for (std::size_t i = 0; i < sum.size(); ++i)
    if (pivots_[i] != 0) vector[static_cast<std::size_t>(order_[i])] = -sum[i];
  return vector;
}

}  // namespace dalembert
