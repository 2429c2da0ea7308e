// Loops over vectors that hold a few numbers in small systems and very many in large ones.
#pragma once

#include <algorithm>
#include <cstddef>

namespace dalembert {

// So many numbers are done one by one. To sort out which of them fill registers, or to call memcpy, would take longer; and
// what has just been written number by number cannot be read at once in wide registers.
constexpr std::size_t few_numbers = 8;

// Keeps the compiler from turning the loop around it into another one.
[[gnu::always_inline]] inline void keep_loop() { asm volatile(""); }

// Calls f(i) for all i below `count`.
template <class F>
[[gnu::always_inline]] inline void each_number(std::size_t count, F&& f) {
  if (count <= few_numbers) {
#pragma GCC unroll 1
    for (std::size_t i = 0; i < count; ++i) {
      f(i);
      keep_loop();
    }
  } else {
#pragma GCC ivdep
    for (std::size_t i = 0; i < count; ++i) f(i);
  }
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
