#include "occupied_lu.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dalembert {

namespace {

// Leaving out fewer entries saves less than a second analysis may cost.
constexpr double largest_share = 0.5;

}  // namespace

OccupiedLu::OccupiedLu(const Pattern& pattern, const LinearSolverOptions& options)
    : pattern_(pattern), options_(options), unsettled_(options.unsettled_matrices) {
  take_whole_pattern();
}

int OccupiedLu::factorize(std::span<const double> values) {
  if (!chosen_ && unsettled_-- == 0) {
    chosen_ = true;
    if (mostly_zeros(values)) {
      take(occupied_slots(values));
      return factorize_occupied(values);
    }
  }
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
  const int singular = solver_->factorize(values);
  return singular == success ? success : coupled_[singular];
}

void OccupiedLu::solve(std::span<double> x) {
  if (static_cast<int>(coupled_.size()) == pattern_.size() || !occupied_) return solver_->solve(x);
  for (const Lone& lone : lone_) x[lone.unknown] *= lone.inverse;
  solver_->solve_for(coupled_, x);
}

LinearSolverStatistics OccupiedLu::statistics() const {
  LinearSolverStatistics all = solver_->statistics();
  all.factorizations += earlier_.factorizations;
  all.pivot_searches += earlier_.pivot_searches;
  all.entries += lone_.size();
  return all;
}

// Called before another solver replaces this one.
void OccupiedLu::count_as_earlier() {
  if (!solver_) return;
  const LinearSolverStatistics last = solver_->statistics();
  earlier_.factorizations += last.factorizations;
  earlier_.pivot_searches += last.pivot_searches;
}

bool OccupiedLu::mostly_zeros(std::span<const double> values) const {
  const auto occupied = std::ranges::count_if(values, [](double x) { return x != 0; });
  return static_cast<double>(occupied) <= largest_share * static_cast<double>(values.size());
}

void OccupiedLu::take(const std::vector<char>& occupied) {
  find_neighbours(occupied);
  const auto starts = pattern_.column_start(), rows = pattern_.row_index();
  std::vector<int> place(static_cast<std::size_t>(pattern_.size()), -1);
  for (std::size_t k = 0; k < coupled_.size(); ++k) place[coupled_[k]] = static_cast<int>(k);
  std::vector<int> occupied_starts{0}, occupied_rows, slots;
  for (const int j : coupled_) {
    for (int slot = starts[j]; slot < starts[j + 1]; ++slot) {
      if (!occupied[slot]) continue;
      slots.push_back(slot);
      occupied_rows.push_back(place[rows[slot]]);
    }
    occupied_starts.push_back(static_cast<int>(occupied_rows.size()));
  }
  zeros_.clear();
  pattern_.for_each_transposed([&](int slot, int) {
    if (!occupied[slot]) zeros_.push_back(slot);
  });
  occupied_ = Pattern::sparse(std::move(occupied_starts), std::move(occupied_rows));
  count_as_earlier();
  LinearSolverOptions options = options_;
  for (std::vector<int>* unknowns : {&options.tiny_diagonal, &options.dependent}) {
    std::erase_if(*unknowns, [&](int j) { return place[j] < 0; });
    for (int& j : *unknowns) j = place[j];
  }
  solver_ = std::make_unique<MultifrontalLu>(*occupied_, options, std::move(slots));
}

// Slots of nonzero entries, of their transposed entries, and of the diagonal.
std::vector<char> OccupiedLu::occupied_slots(std::span<const double> values) const {
  std::vector<char> occupied(values.size(), 0);
  pattern_.for_each_transposed([&, to = occupied.data()](int slot, int transposed) {
    if (values[slot] != 0 || slot == transposed) to[slot] = to[transposed] = 1;
  });
  return occupied;
}

void OccupiedLu::find_neighbours(const std::vector<char>& occupied) {
  const auto starts = pattern_.column_start();
  lone_.clear();
  coupled_.clear();
  for (int j = 0; j < pattern_.size(); ++j) {
    const auto begin = occupied.begin() + starts[j], end = occupied.begin() + starts[j + 1];
    if (std::count(begin, end, 1) > 1) {
      coupled_.push_back(j);
    } else {
      lone_.push_back({j, static_cast<int>(std::find(begin, end, 1) - occupied.begin()), 0});
    }
  }
}

void OccupiedLu::take_whole_pattern() {
  count_as_earlier();
  solver_ = std::make_unique<MultifrontalLu>(pattern_, options_);
  occupied_.reset();
  lone_ = {};
  coupled_ = zeros_ = {};
}

}  // namespace dalembert
