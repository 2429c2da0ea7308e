#include "lane_factors.hpp"

#include <algorithm>
#include <cmath>

#include "dense_lu.hpp"
#include "listed_lu.hpp"

namespace dalembert {

namespace {

// Uses the same registers as DenseLu for this size.
template <class Loop>
void in_registers_for(int size, const Loop& loop) {
  size <= DenseLu::tiny ? run_in_any_registers(loop) : in_block_registers(loop);
}

}  // namespace

LaneFactors::LaneFactors(std::span<const int> row_of_step, std::span<const char> occupied)
    : row_of_step_(row_of_step.begin(), row_of_step.end()),
      list_(row_of_step, occupied),
      factors_(static_cast<std::size_t>(list_.entries + list_.size)),
      next_(factors_.size()),
      work_(static_cast<std::size_t>(list_.size)) {}

void LaneFactors::eliminate() {
  in_registers_for(list_.size, [&] { growth_ = eliminate_listed(list_, next_.data(), next_.data() + list_.entries); });
}

void LaneFactors::take(std::span<const bool> wanted) {
  for (std::size_t k = 0; k < factors_.size(); ++k)
    for (int lane = 0; lane < block_lanes; ++lane)
      if (wanted[static_cast<std::size_t>(lane)]) factors_[k].at(lane) = next_[k][lane];
}

bool LaneFactors::usable(int lane, double largest_inverse) const {
  if (!(growth_[lane] <= DenseLu::largest_growth)) return false;
  const auto inverse = factors_.begin() + list_.entries;
  return std::all_of(inverse, factors_.end(), [&](const LaneBlock& x) { return std::abs(x[lane]) < largest_inverse; });
}

void LaneFactors::substitute() {
  in_registers_for(list_.size,
                   [&] { substitute_listed(list_, factors_.data(), factors_.data() + list_.entries, work_.data()); });
}

}  // namespace dalembert
