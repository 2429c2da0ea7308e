#include "constraints/dependent_equations.hpp"

#include "dalembert/math/decompositions.hpp"

namespace dalembert {

namespace {

constexpr int largest_size = 1000;  // takes one second
constexpr double negligible_pivot = 1e-9;
constexpr double negligible_share = 1e-4;  // smallest share of an equation in a combination

Eigen::MatrixXd dense(const Pattern& pattern, std::span<const double> values) {
  const int n = pattern.size();
  if (pattern.is_dense()) return Eigen::Map<const Eigen::MatrixXd>(values.data(), n, n);
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n, n);
  const auto start = pattern.column_start();
  for (int j = 0; j < n; ++j) {
    for (int k = start[j]; k < start[j + 1]; ++k) a(pattern.row_index()[k], j) = values[k];
  }
  return a;
}

// Scales rows and then columns to a largest entry of one, because forces and gaps have different units.
void equilibrate(Eigen::MatrixXd& a) {
  const auto inverse = [](double largest) { return largest > 0 ? 1 / largest : 1; };
  for (Eigen::Index i = 0; i < a.rows(); ++i) a.row(i) *= inverse(a.row(i).cwiseAbs().maxCoeff());
  for (Eigen::Index j = 0; j < a.cols(); ++j) a.col(j) *= inverse(a.col(j).cwiseAbs().maxCoeff());
}

// Indices of nonzero entries in the null space of the matrix or of its transpose.
std::vector<int> rows_of_kernel(const Pattern& pattern, std::span<const double> values, bool transposed) {
  std::vector<int> rows;
  if (pattern.size() > largest_size) return rows;
  Eigen::MatrixXd a = dense(pattern, values);
  if (!a.allFinite()) return rows;
  equilibrate(a);
  if (transposed) a.transposeInPlace();
  Eigen::MatrixXd combinations = kernel_of(a, negligible_pivot);
  if (combinations.cols() == 0) return rows;
  for (Eigen::Index j = 0; j < combinations.cols(); ++j) combinations.col(j).normalize();
  for (int i = 0; i < pattern.size(); ++i) {
    if (combinations.row(i).cwiseAbs().maxCoeff() > negligible_share) rows.push_back(i);
  }
  return rows;
}

}  // namespace

std::vector<int> dependent_equations(const Pattern& pattern, std::span<const double> values) {
  return rows_of_kernel(pattern, values, true);
}

std::vector<int> free_unknowns(const Pattern& pattern, std::span<const double> values) {
  return rows_of_kernel(pattern, values, false);
}

}  // namespace dalembert
