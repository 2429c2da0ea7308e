// Numbers side by side: kernels that are templates over the scalar compute several elements at once with them.
//
// The compiler knows such a vector on any processor; where it has registers for all of it, loops that run in the widest
// registers (math/wide_registers.hpp) use them.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "dalembert/math/dual.hpp"
#include "dalembert/math/inline.hpp"

namespace dalembert {

// The compiler wants sizes that do not depend on a template.
template <int N>
struct RegisterOf;
template <>
struct RegisterOf<2> {
  using Type [[gnu::vector_size(2 * sizeof(double))]] = double;
};
template <>
struct RegisterOf<4> {
  using Type [[gnu::vector_size(4 * sizeof(double))]] = double;
};
template <>
struct RegisterOf<8> {
  using Type [[gnu::vector_size(8 * sizeof(double))]] = double;
};

// To be passed between inlined functions only: how a vector is passed to others depends on the processor.
template <int N>
struct Lanes {
  static constexpr int count = N;
  using Register = typename RegisterOf<N>::Type;
  Register x{};

  DALEMBERT_INLINE Lanes() = default;
  // Copied as a register: the compiler takes what it may copy as memory through other registers.
  DALEMBERT_INLINE Lanes(const Lanes& other) : x(other.x) {}
  DALEMBERT_INLINE Lanes& operator=(const Lanes& other) {
    x = other.x;
    return *this;
  }
  DALEMBERT_INLINE Lanes(Register all) : x(all) {}
  DALEMBERT_INLINE Lanes(double all) : x(all - Register{}) {}
  DALEMBERT_INLINE double operator[](int lane) const { return x[lane]; }
  DALEMBERT_INLINE static Lanes of_place(const double* place) {
    using Unaligned [[gnu::vector_size(N * sizeof(double)), gnu::aligned(alignof(double)), gnu::may_alias]] = double;
    return Lanes(Register(*reinterpret_cast<const Unaligned*>(place)));
  }

  DALEMBERT_INLINE friend Lanes operator-(const Lanes& a) { return -a.x; }
  DALEMBERT_INLINE friend Lanes operator+(const Lanes& a, const Lanes& b) { return a.x + b.x; }
  DALEMBERT_INLINE friend Lanes operator-(const Lanes& a, const Lanes& b) { return a.x - b.x; }
  DALEMBERT_INLINE friend Lanes operator*(const Lanes& a, const Lanes& b) { return a.x * b.x; }
  DALEMBERT_INLINE friend Lanes operator/(const Lanes& a, const Lanes& b) { return a.x / b.x; }
  // A number that is not stored as a vector before fills a register at once.
  DALEMBERT_INLINE friend Lanes operator+(const Lanes& a, double b) { return a.x + b; }
  DALEMBERT_INLINE friend Lanes operator-(const Lanes& a, double b) { return a.x - b; }
  DALEMBERT_INLINE friend Lanes operator*(double a, const Lanes& b) { return a * b.x; }
  DALEMBERT_INLINE friend Lanes operator/(double a, const Lanes& b) { return a / b.x; }
  DALEMBERT_INLINE Lanes& operator+=(const Lanes& b) { return *this = *this + b; }
  DALEMBERT_INLINE Lanes& operator-=(const Lanes& b) { return *this = *this - b; }
  DALEMBERT_INLINE Lanes& operator*=(const Lanes& b) { return *this = *this * b; }
  DALEMBERT_INLINE friend bool is_zero(const Lanes& a) {
    const auto differs = a.x != Register{};
    auto any = differs[0];
    for (int lane = 1; lane < N; ++lane) any |= differs[lane];
    return any == 0;
  }
  DALEMBERT_INLINE friend Lanes sqrt(const Lanes& a) {
    return of_each([&a](int lane) { return std::sqrt(a.x[lane]); });
  }
  // A divisor where there would be none.
  DALEMBERT_INLINE friend Lanes one_for_zero(const Lanes& a) { return a.x == 0.0 ? 1.0 - Register{} : a.x; }

  template <class F>
  DALEMBERT_INLINE static Lanes of_each(const F& number) {
    return [&number]<int... Lane>(std::integer_sequence<int, Lane...>) {
      return Lanes(Register{number(Lane)...});
    }(std::make_integer_sequence<int, N>{});
  }
  // Lane i of the result is number pick(i) of these and of those of `more`, which follow them.
  template <auto pick>
  DALEMBERT_INLINE Lanes picked(const Lanes& more) const {
    return [&]<int... Lane>(std::integer_sequence<int, Lane...>) {
      return Lanes(__builtin_shufflevector(x, more.x, pick(Lane)...));
    }(std::make_integer_sequence<int, N>{});
  }
};

// Four numbers side by side in memory.
using FourNumbers [[gnu::vector_size(4 * sizeof(double)), gnu::aligned(alignof(double)), gnu::may_alias]] = double;

// Every four lanes of four vectors are a matrix: all of these transposed.
template <int N>
DALEMBERT_INLINE inline std::array<Lanes<N>, 4> transposed(const std::array<Lanes<N>, 4>& m) {
  constexpr auto even = [](int i) { return i % 2 == 0 ? i : N + i - 1; };
  constexpr auto odd = [](int i) { return i % 2 == 0 ? i + 1 : N + i; };
  constexpr auto low = [](int i) { return i % 4 < 2 ? i : N + i - 2; };
  constexpr auto high = [](int i) { return i % 4 < 2 ? i + 2 : N + i; };
  const Lanes<N> even01 = m[0].template picked<even>(m[1]), odd01 = m[0].template picked<odd>(m[1]);
  const Lanes<N> even23 = m[2].template picked<even>(m[3]), odd23 = m[2].template picked<odd>(m[3]);
  return {even01.template picked<low>(even23), odd01.template picked<low>(odd23), even01.template picked<high>(even23),
          odd01.template picked<high>(odd23)};
}
// Number j of row(lane), which has four, in lane `lane` of vector j.
template <int N, class Row>
DALEMBERT_INLINE inline std::array<Lanes<N>, 4> columns_of(const Row& row) {
  std::array<Lanes<N>, 4> numbers;
  if constexpr (N == 2) {
    const FourNumbers rows[2] = {row(0), row(1)};
    for (int j = 0; j < 4; ++j) numbers[j] = Lanes<N>::of_each([&](int lane) { return rows[lane][j]; });
    return numbers;
  } else {
    for (int i = 0; i < 4; ++i) {
      if constexpr (N == 4) numbers[i] = Lanes<N>(row(i));
      else numbers[i] = Lanes<N>(__builtin_shufflevector(row(i), row(i + 4), 0, 1, 2, 3, 4, 5, 6, 7));
    }
    return transposed(numbers);
  }
}
DALEMBERT_INLINE inline FourNumbers& four_numbers(double* place) { return *reinterpret_cast<FourNumbers*>(place); }
DALEMBERT_INLINE inline const FourNumbers& four_numbers(const double* place) {
  return *reinterpret_cast<const FourNumbers*>(place);
}
// Number j from all places, as vector j.
template <int N>
DALEMBERT_INLINE inline std::array<Lanes<N>, 4> gather_fours(const std::array<const double*, N>& places) {
  return columns_of<N>([&places](int lane) -> const FourNumbers& { return four_numbers(places[lane]); });
}
// The inverse of columns_of: what lane i of the vectors holds, as row i.
template <int N>
DALEMBERT_INLINE inline std::array<Lanes<4>, N> rows_of(std::array<Lanes<N>, 4> numbers) {
  std::array<Lanes<4>, N> rows;
  if constexpr (N > 2) numbers = transposed(numbers);
  for (int lane = 0; lane < N; ++lane) {
    const auto& four = numbers[lane % 4].x;
    if constexpr (N == 2) rows[lane] = Lanes<4>::of_each([&](int j) { return numbers[j][lane]; });
    else if constexpr (N == 4) rows[lane] = numbers[lane];
    else rows[lane] = lane < 4 ? __builtin_shufflevector(four, four, 0, 1, 2, 3) : __builtin_shufflevector(four, four, 4, 5, 6, 7);
  }
  return rows;
}
// Calls f(lane, row) for the first `count` rows, one after the other; spelt out, so that rows stay in registers.
template <int N, class F>
DALEMBERT_INLINE inline void each_row(const std::array<Lanes<N>, 4>& numbers, int count, const F& f) {
  const std::array<Lanes<4>, N> rows = rows_of(numbers);
  [&]<int... lane>(std::integer_sequence<int, lane...>) DALEMBERT_INLINE {
    (void)((lane < count && (f(lane, rows[lane].x), true)) && ...);
  }(std::make_integer_sequence<int, N>{});
}
// Adds number j of the first `count` lanes at their places, one place after the other.
template <int N>
DALEMBERT_INLINE inline void scatter_fours(const std::array<Lanes<N>, 4>& numbers, const std::array<double*, N>& places, int count) {
  each_row<N>(numbers, count, [&](int lane, const auto& row) DALEMBERT_INLINE { four_numbers(places[lane]) += row; });
}

// Scalars that stand for one number and its derivatives: what a user function can be called with.
template <class S>
inline constexpr bool holds_lanes = false;
template <int N>
inline constexpr bool holds_lanes<Lanes<N>> = true;
template <int N, class T>
inline constexpr bool holds_lanes<Dual<N, T>> = holds_lanes<T>;
template <class S>
concept OneNumber = !holds_lanes<S>;
template <OneNumber S>
const S& one_for_zero(const S& a) {  // kernels ask a single number before they divide
  return a;
}

}  // namespace dalembert
