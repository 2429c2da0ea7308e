// Loops that are compiled twice: for any processor, and for those with registers that hold four numbers (AVX2). Both round
// alike, without fused multiplications: results are the same to the last bit.
#pragma once

#include "dalembert/math/processor.hpp"

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define DALEMBERT_WIDE gnu::target("avx2"),
#else
#define DALEMBERT_WIDE
#endif

namespace dalembert {

template <class Loop>
[[DALEMBERT_WIDE gnu::flatten]] void run_in_wide_registers(const Loop& loop) {
  loop();
}
template <class Loop>
[[gnu::flatten]] void run_in_any_registers(const Loop& loop) {
  loop();
}

inline bool has_wide_registers() {
  static const bool has = instructions() >= Instructions::avx2;
  return has;
}

template <class Loop>
void in_widest_registers(const Loop& loop) {
  has_wide_registers() ? run_in_wide_registers(loop) : run_in_any_registers(loop);
}

}  // namespace dalembert

#undef DALEMBERT_WIDE
