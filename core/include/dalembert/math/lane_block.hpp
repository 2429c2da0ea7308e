// The same number of several computations side by side, in memory: lists of operations run over all of them at once.
#pragma once

#include "dalembert/math/pack.hpp"
#include "dalembert/math/wide_registers.hpp"

namespace dalembert {

inline constexpr int block_lanes = 8;

// One register, or as many as the processor needs; aligned for the widest loads.
struct alignas(block_lanes * sizeof(double)) LaneBlock : Pack<block_lanes> {
  using Pack::Pack;
  LaneBlock() = default;
  DALEMBERT_INLINE LaneBlock(const Pack& lanes) : Pack(lanes) {}

  double& at(int lane) { return reinterpret_cast<double*>(&x)[lane]; }
};

// Runs a loop over blocks in the widest registers. Products and sums of one expression are fused, if the processor can.
template <class Loop>
void in_block_registers(const Loop& loop) {
  numbers_in_register() == block_lanes ? run_in_widest_registers(loop) : in_wide_registers(loop);
}

}  // namespace dalembert
