// Loops over vectors that hold a few numbers in small systems and very many in large ones.
#pragma once

#include <algorithm>
#include <cstddef>

#include "dalembert/math/inline.hpp"
#include "dalembert/math/wide_registers.hpp"

namespace dalembert {

// Small loops are unrolled number by number up to this count. Dispatching to wide registers or calling memcpy would
// take longer, and numbers written one by one cannot be forwarded to wide loads.
constexpr std::size_t few_numbers = 8;

// Keeps the compiler from turning the loop around it into another one.
DALEMBERT_INLINE inline void keep_loop() { asm volatile(""); }

// Calls f(i) for all i below `count`, which is few, in any order. They are spelt out, as a jump takes as long as several numbers do.
template <class F>
DALEMBERT_INLINE inline void each_of_few(std::size_t count, F&& f) {
  static_assert(few_numbers == 8);
  switch (count) {
    case 8: f(7); [[fallthrough]];
    case 7: f(6); [[fallthrough]];
    case 6: f(5); [[fallthrough]];
    case 5: f(4); [[fallthrough]];
    case 4: f(3); [[fallthrough]];
    case 3: f(2); [[fallthrough]];
    case 2: f(1); [[fallthrough]];
    case 1: f(0); [[fallthrough]];
    default: break;
  }
}

// Calls f(i) for all i below `count`, in any order: calls must be independent, and f is copied.
template <class F>
DALEMBERT_INLINE inline void each_number(std::size_t count, F&& f) {
  if (count <= few_numbers) return each_of_few(count, f);
  in_registers_of_four([f, count] {
#pragma GCC ivdep
    for (std::size_t i = 0; i < count; ++i) f(i);
  });
}

inline void copy_numbers(const double* from, std::size_t count, double* to) {
  if (count > few_numbers) {
    std::copy_n(from, count, to);
  } else {
    each_number(count, [=](std::size_t i) { to[i] = from[i]; });
  }
}

inline void clear_numbers(double* x, std::size_t count) {
  if (count > few_numbers) {
    std::fill_n(x, count, 0.0);
  } else {
    each_number(count, [=](std::size_t i) { x[i] = 0; });
  }
}

}  // namespace dalembert
