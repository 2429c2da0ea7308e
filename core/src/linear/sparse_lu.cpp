#include "sparse_lu.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace dalembert {

SparseLu::SparseLu(const Pattern& pattern, const LinearSolverOptions& options)
    : pattern_(pattern), options_(options), matrix_(pattern.size(), pattern.size()), solution_(pattern.size()) {
  const auto starts = pattern.column_start(), rows = pattern.row_index();
  matrix_.resizeNonZeros(static_cast<Eigen::Index>(rows.size()));
  std::copy(starts.begin(), starts.end(), matrix_.outerIndexPtr());
  std::copy(rows.begin(), rows.end(), matrix_.innerIndexPtr());
  if (options.pivot_threshold > 0) lu_.setPivotThreshold(options.pivot_threshold);
}

int SparseLu::factorize(std::span<const double> values) {
  std::copy(values.begin(), values.end(), matrix_.valuePtr());
  if (const int column = empty_column(values); column != success) return column;
  if (!analyzed_) {
    lu_.analyzePattern(matrix_);
    analyzed_ = true;
  }
  lu_.factorize(matrix_);
  return lu_.info() == Eigen::Success ? success : singular_column();
}

int SparseLu::empty_column(std::span<const double> values) const {
  const auto starts = pattern_.column_start();
  for (int j = 0; j < pattern_.size(); ++j) {
    const auto column = values.subspan(starts[j], starts[j + 1] - starts[j]);
    if (std::all_of(column.begin(), column.end(), [](double x) { return !(std::abs(x) > 0); })) return j;
  }
  return success;
}

// Eigen reports the failing column only at the end of a sentence, counted in its own order of columns.
int SparseLu::singular_column() const {
  const std::string message = lu_.lastErrorMessage();
  const auto digit = message.find_first_of("0123456789");
  if (digit == std::string::npos) return 0;
  const int permuted = std::atoi(message.c_str() + digit);
  const auto& order = lu_.colsPermutation().indices();
  for (int j = 0; j < order.size(); ++j) {
    if (order[j] == permuted) return j;
  }
  return 0;
}

void SparseLu::solve(std::span<double> x) {
  Eigen::Map<Eigen::VectorXd> map(x.data(), static_cast<Eigen::Index>(x.size()));
  solution_ = lu_.solve(map);
  map = solution_;
}

}  // namespace dalembert
