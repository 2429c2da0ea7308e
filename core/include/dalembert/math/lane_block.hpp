// The same number of several computations side by side, in memory: lists of operations run over all of them at once.
#pragma once

#include <vector>

#include "dalembert/math/wide_registers.hpp"

namespace dalembert {

inline constexpr int block_lanes = 8;

struct alignas(block_lanes * sizeof(double)) LaneBlock {
  double x[block_lanes]{};

  double& operator[](int lane) { return x[lane]; }
  double operator[](int lane) const { return x[lane]; }
};

// As one register, or as many as the processor needs for it.
using LaneVector = double __attribute__((vector_size(block_lanes * sizeof(double)), may_alias));

inline LaneVector* vectors(std::vector<LaneBlock>& blocks) { return reinterpret_cast<LaneVector*>(blocks.data()); }

// Runs a loop over such vectors in the widest registers. Products and sums of one expression are fused, if the processor can.
template <class Loop>
void in_block_registers(const Loop& loop) {
  numbers_in_register() == block_lanes ? run_in_widest_registers(loop) : in_wide_registers(loop);
}

}  // namespace dalembert
