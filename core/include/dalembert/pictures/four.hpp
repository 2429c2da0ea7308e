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
DALEMBERT_INLINE inline Four root(Four a) {
  return Four{std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3])};
}
DALEMBERT_INLINE inline Four as_numbers(FourWhole a) { return __builtin_convertvector(a, Four); }
DALEMBERT_INLINE inline FourWhole whole(Four a) { return __builtin_convertvector(a, FourWhole); }

// Lanes for which a comparison is true, one bit each.
DALEMBERT_INLINE inline std::uint32_t bits(FourWhole flags) {
#ifdef __SSE__
  return static_cast<std::uint32_t>(__builtin_ia32_movmskps(reinterpret_cast<Four>(flags)));
#else
  const FourWhole b = flags & FourWhole{1, 2, 4, 8};
  using Halves [[gnu::vector_size(16)]] = std::uint64_t;
  const Halves h = reinterpret_cast<Halves>(b);
  const std::uint64_t sum = h[0] | h[1];
  return static_cast<std::uint32_t>(sum) | static_cast<std::uint32_t>(sum >> 32);
#endif
}

// Four numbers that lie side by side, at any place.
template <class V, class T>
DALEMBERT_INLINE inline V load(const T* from) {
  V values;
  std::memcpy(&values, from, sizeof values);
  return values;
}
template <class V, class T>
DALEMBERT_INLINE inline void store(V values, T* to) {
  std::memcpy(to, &values, sizeof values);
}
// Selects one of two numbers per lane; flags: result of a comparison.
template <class V>
DALEMBERT_INLINE inline V chosen(FourWhole flags, V yes, V no) {
  const auto a = reinterpret_cast<FourWhole>(yes), b = reinterpret_cast<FourWhole>(no);
  return reinterpret_cast<V>(b ^ ((a ^ b) & flags));
}
template <class V, class T>
DALEMBERT_INLINE inline void store_some(FourWhole flags, V values, T* to) {
  store(chosen(flags, values, load<V>(to)), to);
}

}  // namespace dalembert
