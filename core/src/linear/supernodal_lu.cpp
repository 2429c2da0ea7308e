#include "supernodal_lu.hpp"

#include <algorithm>

namespace dalembert {

SupernodalLu::SupernodalLu(const Pattern& pattern) {
  const auto starts = pattern.column_start(), rows = pattern.row_index();
  matrix_.resize(pattern.size(), pattern.size());
  matrix_.resizeNonZeros(static_cast<Eigen::Index>(rows.size()));
  std::copy(starts.begin(), starts.end(), matrix_.outerIndexPtr());
  std::copy(rows.begin(), rows.end(), matrix_.innerIndexPtr());
  std::fill_n(matrix_.valuePtr(), rows.size(), 1.0);
  lu_.analyzePattern(matrix_);
}

bool SupernodalLu::factorize(std::span<const double> values) {
  std::copy(values.begin(), values.end(), matrix_.valuePtr());
  lu_.factorize(matrix_);
  return lu_.info() == Eigen::Success;
}

void SupernodalLu::solve(std::span<double> x) {
  Eigen::Map<Eigen::VectorXd> vector(x.data(), static_cast<Eigen::Index>(x.size()));
  solution_ = lu_.solve(vector);
  vector = solution_;
}

}  // namespace dalembert
