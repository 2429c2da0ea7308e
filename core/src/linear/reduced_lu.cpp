#include "reduced_lu.hpp"

#include <algorithm>

namespace dalembert {

namespace {

std::vector<int> all_but(const std::vector<int>& left_out, int size) {
  std::vector<int> kept;
  for (int j = 0; j < size; ++j)
    if (std::ranges::find(left_out, j) == left_out.end()) kept.push_back(j);
  return kept;
}

}  // namespace

ReducedLu::ReducedLu(int size, LinearSolverType type, const LinearSolverOptions& options)
    : size_(size),
      kept_(all_but(options.left_out, size)),
      pattern_(Pattern::dense(static_cast<int>(kept_.size()))),
      values_(static_cast<std::size_t>(pattern_.values())),
      x_(kept_.size()) {
  LinearSolverOptions others = options;
  others.left_out.clear();
  others.tiny_diagonal.clear();  // options of sparse matrices, as is `dependent`
  others.dependent.clear();
  solver_ = make_linear_solver(pattern_, type, others);
}

int ReducedLu::factorize(std::span<const double> values) {
  double* to = values_.data();
  for (const int j : kept_) {
    const double* column = values.data() + static_cast<std::ptrdiff_t>(j) * size_;
    for (const int i : kept_) *to++ = column[i];
  }
  const int singular = solver_->factorize(values_);
  return singular == success ? success : kept_[static_cast<std::size_t>(singular)];
}

void ReducedLu::solve(std::span<double> x) {
  for (std::size_t k = 0; k < kept_.size(); ++k) x_[k] = x[static_cast<std::size_t>(kept_[k])];
  solver_->solve(x_);
  std::ranges::fill(x, 0.0);
  for (std::size_t k = 0; k < kept_.size(); ++k) x[static_cast<std::size_t>(kept_[k])] = x_[k];
}

}  // namespace dalembert
