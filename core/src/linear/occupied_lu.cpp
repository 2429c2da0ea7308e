#include "occupied_lu.hpp"

#include <algorithm>
#include <cmath>

namespace dalembert {

namespace {

// Leaving out fewer entries saves less than a second analysis may cost.
constexpr double largest_share = 0.5;

}  // namespace

int OccupiedLu::factorize(std::span<const double> values) {
  if (!chosen_ && mostly_zeros(values)) select(values);
  chosen_ = true;
  if (!occupied_) return solver_->factorize(values);
  if (std::ranges::none_of(zeros_, [&](int slot) { return values[slot] != 0; })) return factorize_occupied(values);
  take_whole_pattern();
  return solver_->factorize(values);
}

int OccupiedLu::factorize_occupied(std::span<const double> values) {
  for (Lone& lone : lone_) {
    const double pivot = values[lone.slot];
    const bool singular = !(std::abs(pivot) > options_.pivot_threshold);
    if (singular && !options_.ignore_singular) return lone.unknown;
    lone.inverse = singular ? 0 : 1 / pivot;
  }
  std::ranges::transform(slots_, gathered_.begin(), [&](int slot) { return values[slot]; });
  const int singular = solver_->factorize(gathered_);
  return singular == success ? success : coupled_[singular];
}

void OccupiedLu::solve(std::span<double> x) {
  if (!occupied_) return solver_->solve(x);
  for (const Lone& lone : lone_) x[lone.unknown] *= lone.inverse;
  for (std::size_t k = 0; k < coupled_.size(); ++k) x_[k] = x[coupled_[k]];
  solver_->solve(x_);
  for (std::size_t k = 0; k < coupled_.size(); ++k) x[coupled_[k]] = x_[k];
}

LinearSolverStatistics OccupiedLu::statistics() const {
  LinearSolverStatistics all = solver_->statistics();
  all.factorizations += earlier_.factorizations;
  all.pivot_searches += earlier_.pivot_searches;
  all.entries += lone_.size();
  return all;
}

bool OccupiedLu::mostly_zeros(std::span<const double> values) const {
  const auto occupied = std::ranges::count_if(values, [](double x) { return x != 0; });
  return static_cast<double>(occupied) <= largest_share * static_cast<double>(values.size());
}

void OccupiedLu::select(std::span<const double> values) {
  find_neighbours(values);
  std::vector<int> place(static_cast<std::size_t>(pattern_.size()), -1);
  for (std::size_t k = 0; k < coupled_.size(); ++k) place[coupled_[k]] = static_cast<int>(k);
  std::vector<std::pair<int, int>> entries;
  for (const int j : coupled_) {
    for (int k = pattern_.column_start()[j]; k < pattern_.column_start()[j + 1]; ++k) {
      if (values[k] != 0) entries.emplace_back(place[pattern_.row_index()[k]], place[j]);
    }
  }
  occupied_ = Pattern::sparse(static_cast<int>(coupled_.size()), entries);
  select_slots();
  solver_ = std::make_unique<MultifrontalLu>(*occupied_, options_);
}

void OccupiedLu::find_neighbours(std::span<const double> values) {
  const auto starts = pattern_.column_start(), rows = pattern_.row_index();
  std::vector<bool> coupled(static_cast<std::size_t>(pattern_.size()));
  for (int j = 0; j < pattern_.size(); ++j) {
    for (int k = starts[j]; k < starts[j + 1]; ++k) {
      if (rows[k] != j && values[k] != 0) coupled[j] = coupled[rows[k]] = true;
    }
  }
  for (int j = 0; j < pattern_.size(); ++j) {
    if (coupled[j]) {
      coupled_.push_back(j);
    } else {
      lone_.push_back({j, pattern_.slot(j, j), 0});
    }
  }
  x_.resize(coupled_.size());
}

// Both patterns have their rows in the same order.
void OccupiedLu::select_slots() {
  std::vector<bool> kept(static_cast<std::size_t>(pattern_.values()));
  for (const Lone& lone : lone_) kept[lone.slot] = true;
  for (int j = 0; j < occupied_->size(); ++j) {
    int slot = pattern_.column_start()[coupled_[j]];
    for (int k = occupied_->column_start()[j]; k < occupied_->column_start()[j + 1]; ++k, ++slot) {
      while (pattern_.row_index()[slot] != coupled_[occupied_->row_index()[k]]) ++slot;
      slots_.push_back(slot);
      kept[slot] = true;
    }
  }
  for (int slot = 0; slot < pattern_.values(); ++slot) {
    if (!kept[slot]) zeros_.push_back(slot);
  }
  gathered_.resize(slots_.size());
}

void OccupiedLu::take_whole_pattern() {
  earlier_ = solver_->statistics();
  solver_ = std::make_unique<MultifrontalLu>(pattern_, options_);
  occupied_.reset();
  lone_ = {};
  coupled_ = slots_ = zeros_ = {};
  gathered_ = x_ = {};
}

}  // namespace dalembert
