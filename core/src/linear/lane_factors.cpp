#include "lane_factors.hpp"

#include <algorithm>
#include <cmath>

#include "dense_lu.hpp"

namespace dalembert {

namespace {

// The expressions are those of the kernels of DenseLu (front_kernels.inc), and fused where those are.
[[gnu::always_inline]] inline void eliminate_all(const EliminationList& list, LaneVector* a, LaneVector* inverse, LaneVector* growth) {
  LaneVector largest{};
  const EliminationList::Update* update = list.updates.data();
  LaneVector* lower = a + list.size;
  for (int k = 0; k < list.size; ++k) {
    const LaneVector reciprocal = inverse[k] = 1 / a[k];
    for (const LaneVector* end = a + list.lower_ends[k]; lower != end; ++lower) {
      *lower *= reciprocal;
      const LaneVector size = *lower < 0 ? -*lower : *lower;
      largest = size > largest ? size : largest;
    }
    for (const auto* end = list.updates.data() + list.update_ends[k]; update != end; ++update)
      a[update->target] -= a[update->factor] * a[update->of];
  }
  *growth = largest;
}

[[gnu::always_inline]] inline void solve_all(const EliminationList& list, const LaneVector* a, const LaneVector* inverse, LaneVector* w) {
  for (const auto& u : list.forward) w[u.target] -= a[u.factor] * w[u.of];
  const EliminationList::Update *within = list.within.data(), *before = list.before.data();
  for (const EliminationList::Group& group : list.groups) {
    for (const auto* end = list.within.data() + group.within_end; within != end; ++within) {
      const LaneVector scaled = a[within->factor] * inverse[within->of];
      w[within->target] -= scaled * w[within->of];
    }
    for (int i = group.first; i < group.end; ++i) w[i] *= inverse[i];
    for (const auto* end = list.before.data() + group.before_end; before != end; ++before)
      w[before->target] -= a[before->factor] * w[before->of];
  }
}

}  // namespace

LaneFactors::LaneFactors(std::span<const int> row_of_step, std::span<const char> occupied)
    : row_of_step_(row_of_step.begin(), row_of_step.end()), list_(row_of_step, occupied),
      factors_(static_cast<std::size_t>(list_.entries + list_.size)), next_(factors_.size()),
      work_(static_cast<std::size_t>(list_.size)) {}

void LaneFactors::eliminate() {
  LaneVector* const factors = vectors(next_);
  in_block_registers([&] { eliminate_all(list_, factors, factors + list_.entries, reinterpret_cast<LaneVector*>(&growth_)); });
}

void LaneFactors::take(std::span<const bool> wanted) {
  for (std::size_t k = 0; k < factors_.size(); ++k)
    for (int lane = 0; lane < block_lanes; ++lane)
      if (wanted[static_cast<std::size_t>(lane)]) factors_[k][lane] = next_[k][lane];
}

bool LaneFactors::usable(int lane, double largest_inverse) const {
  if (!(growth_[lane] <= DenseLu::largest_growth)) return false;
  const auto inverse = factors_.begin() + list_.entries;
  return std::all_of(inverse, factors_.end(), [&](const LaneBlock& x) { return std::abs(x[lane]) < largest_inverse; });
}

const std::vector<LaneBlock>& LaneFactors::solve(const std::vector<LaneBlock>& right_hand_sides) {
  for (std::size_t k = 0; k < work_.size(); ++k) work_[k] = right_hand_sides[static_cast<std::size_t>(row_of_step_[k])];
  in_block_registers([&] { solve_all(list_, vectors(factors_), vectors(factors_) + list_.entries, vectors(work_)); });
  return work_;
}

}  // namespace dalembert
