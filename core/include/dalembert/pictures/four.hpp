// Four numbers of a picture in one register: a color, a normal with its weight, or a quantity at four samples.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>

#include "dalembert/math/inline.hpp"

namespace dalembert {

using Four [[gnu::vector_size(16)]] = float;
using FourWhole [[gnu::vector_size(16)]] = std::int32_t;

DALEMBERT_INLINE inline Four four(float x) { return x - Four{}; }
DALEMBERT_INLINE inline FourWhole four(std::int32_t x) { return x - FourWhole{}; }
DALEMBERT_INLINE inline Four smaller(Four a, Four b) { return a < b ? a : b; }
DALEMBERT_INLINE inline Four larger(Four a, Four b) { return a > b ? a : b; }
DALEMBERT_INLINE inline Four root(Four a) { return Four{std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3])}; }
DALEMBERT_INLINE inline Four as_numbers(FourWhole a) { return __builtin_convertvector(a, Four); }
DALEMBERT_INLINE inline FourWhole whole(Four a) { return __builtin_convertvector(a, FourWhole); }

// Which lanes of a comparison hold, one bit each.
DALEMBERT_INLINE inline std::uint32_t bits(FourWhole flags) {
  const FourWhole b = flags & FourWhole{1, 2, 4, 8};
  using Halves [[gnu::vector_size(16)]] = std::uint64_t;
  const Halves h = reinterpret_cast<Halves>(b);
  const std::uint64_t sum = h[0] | h[1];
  return static_cast<std::uint32_t>(sum) | static_cast<std::uint32_t>(sum >> 32);
}

// The four samples of a square: two of a row, and the two below them.
template <class V, class T>
DALEMBERT_INLINE inline V load_square(const T* upper, const T* lower) {
  using Halves [[gnu::vector_size(16)]] = double;
  double a, b;
  std::memcpy(&a, upper, sizeof a);
  std::memcpy(&b, lower, sizeof b);
  return reinterpret_cast<V>(Halves{a, b});
}
template <class V, class T>
DALEMBERT_INLINE inline void store_square(V values, T* upper, T* lower) {
  using Halves [[gnu::vector_size(16)]] = double;
  const Halves h = reinterpret_cast<Halves>(values);
  const double a = h[0], b = h[1];
  std::memcpy(upper, &a, sizeof a);
  std::memcpy(lower, &b, sizeof b);
}

// Four samples of a row, at any place.
template <class V, class T>
DALEMBERT_INLINE inline V load_row(const T* from) {
  V values;
  std::memcpy(&values, from, sizeof values);
  return values;
}
template <class V, class T>
DALEMBERT_INLINE inline void store_row(V values, T* to) { std::memcpy(to, &values, sizeof values); }

}  // namespace dalembert
