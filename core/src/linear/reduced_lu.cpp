#include "reduced_lu.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace dalembert {

namespace {

std::vector<int> all_but(std::vector<int> left_out, int size) {
  std::ranges::sort(left_out);
  std::vector<int> all(static_cast<std::size_t>(size)), kept;
  std::iota(all.begin(), all.end(), 0);
  std::ranges::set_difference(all, left_out, std::back_inserter(kept));
  return kept;
}

}  // namespace

ReducedLu::ReducedLu(const Pattern& whole, LinearSolverType type, LinearSolverOptions options)
    : kept_(all_but(std::exchange(options.left_out, {}), whole.size())),
      pattern_(reduce(whole)),
      values_(static_cast<std::size_t>(pattern_.values())),
      x_(kept_.size()) {
  for (std::vector<int>* unknowns : {&options.tiny_diagonal, &options.dependent}) {
    std::erase_if(*unknowns, [&](int j) { return !std::ranges::binary_search(kept_, j); });
    for (int& j : *unknowns) j = static_cast<int>(std::ranges::lower_bound(kept_, j) - kept_.begin());
  }
  solver_ = make_linear_solver(pattern_, type, options);
}

Pattern ReducedLu::reduce(const Pattern& whole) {
  std::vector<int> place(static_cast<std::size_t>(whole.size()), -1), starts{0}, rows;
  for (std::size_t k = 0; k < kept_.size(); ++k) place[static_cast<std::size_t>(kept_[k])] = static_cast<int>(k);
  for (const int j : kept_) {
    bool follows = false;
    const std::size_t first = whole.first_slot(static_cast<std::size_t>(j)), end = whole.first_slot(static_cast<std::size_t>(j) + 1);
    for (std::size_t slot = first; slot < end; ++slot) {
      const int row = place[whole.is_dense() ? slot - first : static_cast<std::size_t>(whole.row_index()[slot])];
      if (row >= 0 && follows) ++runs_.back().length;
      else if (row >= 0) runs_.push_back({slot, 1});
      follows = row >= 0;
      if (row >= 0) rows.push_back(row);
    }
    starts.push_back(static_cast<int>(rows.size()));
  }
  return whole.is_dense() ? Pattern::dense(static_cast<int>(kept_.size())) : Pattern::sparse(std::move(starts), std::move(rows));
}

int ReducedLu::factorize(std::span<const double> values) {
  double* to = values_.data();
  for (const Run& run : runs_) to = std::copy_n(values.data() + run.from, run.length, to);
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
