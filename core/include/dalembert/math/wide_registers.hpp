// Loops that are compiled twice: for any processor, and for registers of four numbers (AVX2). Products and sums are
// fused in the latter, so results differ by rounding. Loops over eight numbers require AVX-512.
#pragma once

#include "dalembert/math/processor.hpp"

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define DALEMBERT_FOUR gnu::target("avx2"),
#define DALEMBERT_WIDE gnu::target("avx2,fma"),
#define DALEMBERT_EIGHT gnu::target("avx2,fma,avx512f,avx512vl,avx512dq"),
#else
#define DALEMBERT_FOUR
#define DALEMBERT_WIDE
#define DALEMBERT_EIGHT
#endif

namespace dalembert {

template <class Loop>
[[DALEMBERT_EIGHT gnu::flatten]] void run_in_widest_registers(const Loop& loop) {
  loop();
}
template <class Loop>
[[DALEMBERT_WIDE gnu::flatten]] void run_in_wide_registers(const Loop& loop) {
  loop();
}
// Four numbers at once, where nothing is fused. The copy of the loop stays in registers.
template <class Loop>
[[DALEMBERT_FOUR gnu::flatten]] void run_in_registers_of_four(const Loop& loop) {
  const Loop copy = loop;
  copy();
}
template <class Loop>
[[gnu::flatten]] void run_in_any_registers(const Loop& loop) {
  loop();
}

// How many numbers the widest registers hold.
inline int numbers_in_register() {
  static const int numbers = instructions() == Instructions::avx512 ? 8 : instructions() == Instructions::avx2 ? 4 : 2;
  return numbers;
}
inline bool has_wide_registers() { return numbers_in_register() > 2; }

template <class Loop>
void in_wide_registers(const Loop& loop) {
  has_wide_registers() ? run_in_wide_registers(loop) : run_in_any_registers(loop);
}

// Results are the same on all processors.
template <class Loop>
void in_registers_of_four(const Loop& loop) {
  has_wide_registers() ? run_in_registers_of_four(loop) : run_in_any_registers(loop);
}

}  // namespace dalembert

#undef DALEMBERT_FOUR
#undef DALEMBERT_WIDE
#undef DALEMBERT_EIGHT
