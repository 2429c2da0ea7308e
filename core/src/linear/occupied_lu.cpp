#include "occupied_lu.hpp"

#include <algorithm>

namespace dalembert {

namespace {

// Leaving out fewer entries saves less than a second analysis may cost.
constexpr double largest_share = 0.5;

}  // namespace

int OccupiedLu::factorize(std::span<const double> values) {
  if (!chosen_ && mostly_zeros(values)) select(values);
  chosen_ = true;
  if (!occupied_) return solver_->factorize(values);
  if (gather(values)) return solver_->factorize(gathered_);
  take_whole_pattern();
  return solver_->factorize(values);
}

LinearSolverStatistics OccupiedLu::statistics() const {
  LinearSolverStatistics all = solver_->statistics();
  all.factorizations += earlier_.factorizations;
  all.pivot_searches += earlier_.pivot_searches;
  return all;
}

bool OccupiedLu::mostly_zeros(std::span<const double> values) const {
  const auto occupied = std::ranges::count_if(values, [](double x) { return x != 0; });
  return static_cast<double>(occupied) <= largest_share * static_cast<double>(values.size());
}

void OccupiedLu::select(std::span<const double> values) {
  const auto starts = pattern_.column_start(), rows = pattern_.row_index();
  std::vector<std::pair<int, int>> entries;
  for (int j = 0; j < pattern_.size(); ++j) {
    for (int k = starts[j]; k < starts[j + 1]; ++k) {
      if (values[k] != 0) entries.emplace_back(rows[k], j);
    }
  }
  occupied_ = Pattern::sparse(pattern_.size(), entries);
  for (int j = 0; j < pattern_.size(); ++j) {
    int next = occupied_->column_start()[j];
    const int end = occupied_->column_start()[j + 1];
    for (int k = starts[j]; k < starts[j + 1]; ++k) {
      const bool kept = next < end && occupied_->row_index()[next] == rows[k];
      (kept ? slots_ : zeros_).push_back(k);
      next += kept;
    }
  }
  gathered_.resize(slots_.size());
  solver_ = std::make_unique<MultifrontalLu>(*occupied_, options_);
}

// False if that is not all.
bool OccupiedLu::gather(std::span<const double> values) {
  if (std::ranges::any_of(zeros_, [&](int slot) { return values[slot] != 0; })) return false;
  std::ranges::transform(slots_, gathered_.begin(), [&](int slot) { return values[slot]; });
  return true;
}

void OccupiedLu::take_whole_pattern() {
  earlier_ = solver_->statistics();
  solver_ = std::make_unique<MultifrontalLu>(pattern_, options_);
  occupied_.reset();
  slots_ = zeros_ = {};
  gathered_ = {};
}

}  // namespace dalembert
