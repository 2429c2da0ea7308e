// Numbers side by side: kernels that are templates over the scalar compute several elements at once with them.
//
//     Pack<4> a        | a0 | a1 | a2 | a3 |
//     Pack<4> b        | b0 | b1 | b2 | b3 |
//     a * b            | a0 b0 | a1 b1 | a2 b2 | a3 b3 |     in one instruction
//
// Lane i belongs to element i: a kernel S f(S a, S b) with S = Pack<4> is four elements. In memory the numbers of an element
// stay together: those of several elements are transposed on the way (columns_of, rows_from). There is no other type of registers.
//
// The compiler knows such a vector on any processor; where it has registers for all of it, loops that run in the widest
// registers (math/wide_registers.hpp) use them.
#pragma once

#include <array>
#include <bit>
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
  using Mask [[gnu::vector_size(2 * sizeof(double))]] = long long;
};
template <>
struct RegisterOf<4> {
  using Type [[gnu::vector_size(4 * sizeof(double))]] = double;
  using Mask [[gnu::vector_size(4 * sizeof(double))]] = long long;
};
template <>
struct RegisterOf<8> {
  using Type [[gnu::vector_size(8 * sizeof(double))]] = double;
  using Mask [[gnu::vector_size(8 * sizeof(double))]] = long long;
};

// Pass packs between inlined functions only: their calling convention and alignment depend on the processor
// (math/lane_block.hpp has packs for storage).
template <int N>
struct Pack {
  static constexpr int count = N;
  using Register = typename RegisterOf<N>::Type;
  using Mask = typename RegisterOf<N>::Mask;
  Register x{};

  DALEMBERT_INLINE Pack() = default;
  // Copied as a register: the default copy would use other registers.
  DALEMBERT_INLINE Pack(const Pack& other) : x(other.x) {}
  DALEMBERT_INLINE Pack& operator=(const Pack& other) {
    x = other.x;
    return *this;
  }
  DALEMBERT_INLINE Pack(Register all) : x(all) {}
  DALEMBERT_INLINE Pack(double all) : x(all - Register{}) {}
  DALEMBERT_INLINE double operator[](int lane) const { return x[lane]; }

  // Any place: no boundary is asked for.
  DALEMBERT_INLINE static Pack load(const double* from) {
    return Pack(Register(*reinterpret_cast<const InMemory*>(from)));
  }
  DALEMBERT_INLINE void store(double* to) const { *reinterpret_cast<InMemory*>(to) = x; }
  DALEMBERT_INLINE void add_to(double* to) const { *reinterpret_cast<InMemory*>(to) += x; }
  DALEMBERT_INLINE void subtract_from(double* to) const { *reinterpret_cast<InMemory*>(to) -= x; }

  DALEMBERT_INLINE friend Pack operator-(const Pack& a) { return -a.x; }
  DALEMBERT_INLINE friend Pack operator+(const Pack& a, const Pack& b) { return a.x + b.x; }
  DALEMBERT_INLINE friend Pack operator-(const Pack& a, const Pack& b) { return a.x - b.x; }
  DALEMBERT_INLINE friend Pack operator*(const Pack& a, const Pack& b) { return a.x * b.x; }
  DALEMBERT_INLINE friend Pack operator/(const Pack& a, const Pack& b) { return a.x / b.x; }
  // A number that is not stored as a vector before fills a register at once.
  DALEMBERT_INLINE friend Pack operator+(const Pack& a, double b) { return a.x + b; }
  DALEMBERT_INLINE friend Pack operator-(const Pack& a, double b) { return a.x - b; }
  DALEMBERT_INLINE friend Pack operator*(double a, const Pack& b) { return a * b.x; }
  DALEMBERT_INLINE friend Pack operator/(double a, const Pack& b) { return a / b.x; }
  DALEMBERT_INLINE Pack& operator+=(const Pack& b) { return *this = *this + b; }
  DALEMBERT_INLINE Pack& operator-=(const Pack& b) { return *this = *this - b; }
  DALEMBERT_INLINE Pack& operator*=(const Pack& b) { return *this = *this * b; }
  // All bits of a lane that fulfils it are one. Eight numbers are compared in halves: GCC 12 has no mask for all of
  // them in a function with a target attribute, and would process them one by one.
  DALEMBERT_INLINE friend Mask less(const Pack& a, const Pack& b) {
    if constexpr (N == 8)
      return joined(a.lower() < b.lower(), a.upper() < b.upper());
    else
      return a.x < b.x;
  }
  DALEMBERT_INLINE friend Mask equal(const Pack& a, const Pack& b) {
    if constexpr (N == 8)
      return joined(a.lower() == b.lower(), a.upper() == b.upper());
    else
      return a.x == b.x;
  }
  DALEMBERT_INLINE static Pack chosen(const Mask& first, const Pack& a, const Pack& b) {
    if constexpr (N == 8)
      return std::bit_cast<Register>((std::bit_cast<Mask>(a.x) & first) | (std::bit_cast<Mask>(b.x) & ~first));
    else
      return first ? a.x : b.x;
  }
  DALEMBERT_INLINE static bool is_none(const Mask& mask) { return is_all_zero(mask); }
  // ignores the sign
  DALEMBERT_INLINE friend bool is_zero(const Pack& a) { return is_none(std::bit_cast<Mask>(a.x) << 1); }
  DALEMBERT_INLINE friend Pack sqrt(const Pack& a) {
    return of_each([&a](int lane) { return std::sqrt(a.x[lane]); });
  }
  DALEMBERT_INLINE friend Pack magnitude(const Pack& a) { return chosen(less(a, Pack()), -a, a); }
  DALEMBERT_INLINE friend Pack larger(const Pack& a, const Pack& b) { return chosen(less(b, a), a, b); }
  // Zero in the unselected lanes, for any value there.
  DALEMBERT_INLINE friend Pack only_where(const Pack& flag, const Pack& a) {
    return chosen(equal(flag, Pack()), Pack(), a);
  }
  // Replaces zero divisors by one.
  DALEMBERT_INLINE friend Pack one_for_zero(const Pack& a) { return chosen(equal(a, Pack()), Pack(1.0), a); }

  template <class F>
  DALEMBERT_INLINE static Pack of_each(const F& number) {
    return [&number]<int... Lane>(std::integer_sequence<int, Lane...>) {
      return Pack(Register{number(Lane)...});
    }(std::make_integer_sequence<int, N>{});
  }
  // Lane i of the result is number pick(i) of these and of those of `more`, which follow them.
  template <auto pick>
  DALEMBERT_INLINE Pack picked(const Pack& more) const {
    return [&]<int... Lane>(std::integer_sequence<int, Lane...>) {
      return Pack(__builtin_shufflevector(x, more.x, pick(Lane)...));
    }(std::make_integer_sequence<int, N>{});
  }

 private:
  // Combines halves, as long as they are registers.
  template <class Bits>
  DALEMBERT_INLINE static bool is_all_zero(const Bits& bits) {
    constexpr std::size_t count = sizeof(Bits) / sizeof(long long);
    if constexpr (count == 8)
      return is_all_zero(__builtin_shufflevector(bits, bits, 0, 1, 2, 3) |
                         __builtin_shufflevector(bits, bits, 4, 5, 6, 7));
    else if constexpr (count == 4)
      return is_all_zero(__builtin_shufflevector(bits, bits, 0, 1) | __builtin_shufflevector(bits, bits, 2, 3));
#ifdef __SSE4_1__
    else
      return __builtin_ia32_ptestz128(bits, bits) != 0;
#else
    else
      return (bits[0] | bits[1]) == 0;
#endif
  }
  DALEMBERT_INLINE auto lower() const { return __builtin_shufflevector(x, x, 0, 1, 2, 3); }
  DALEMBERT_INLINE auto upper() const { return __builtin_shufflevector(x, x, 4, 5, 6, 7); }
  template <class Half>
  DALEMBERT_INLINE static Mask joined(const Half& lower, const Half& upper) {
    return std::bit_cast<Mask>(__builtin_shufflevector(lower, upper, 0, 1, 2, 3, 4, 5, 6, 7));
  }

  using InMemory [[gnu::vector_size(N * sizeof(double)), gnu::aligned(alignof(double)), gnu::may_alias]] = double;
};

// The same of single numbers, for templates over both.
inline double magnitude(double a) { return a < 0 ? -a : a; }
inline double larger(double a, double b) { return a > b ? a : b; }
inline double only_where(double flag, double a) { return flag != 0 ? a : 0; }

// Every four lanes of four vectors are a matrix: all of these transposed.
template <int N>
DALEMBERT_INLINE inline std::array<Pack<N>, 4> transposed(const std::array<Pack<N>, 4>& m) {
  constexpr auto even = [](int i) { return i % 2 == 0 ? i : N + i - 1; };
  constexpr auto odd = [](int i) { return i % 2 == 0 ? i + 1 : N + i; };
  constexpr auto low = [](int i) { return i % 4 < 2 ? i : N + i - 2; };
  constexpr auto high = [](int i) { return i % 4 < 2 ? i + 2 : N + i; };
  const Pack<N> even01 = m[0].template picked<even>(m[1]), odd01 = m[0].template picked<odd>(m[1]);
  const Pack<N> even23 = m[2].template picked<even>(m[3]), odd23 = m[2].template picked<odd>(m[3]);
  return {even01.template picked<low>(even23), odd01.template picked<low>(odd23), even01.template picked<high>(even23),
          odd01.template picked<high>(odd23)};
}
// Number j of row(lane), which has four, in lane `lane` of vector j.
template <int N, class Row>
DALEMBERT_INLINE inline std::array<Pack<N>, 4> columns_of(const Row& row) {
  std::array<Pack<N>, 4> numbers;
  if constexpr (N == 2) {
    const Pack<4> rows[2] = {row(0), row(1)};
    for (int j = 0; j < 4; ++j) numbers[j] = Pack<N>::of_each([&](int lane) { return rows[lane][j]; });
    return numbers;
  } else {
    for (int i = 0; i < 4; ++i) {
      if constexpr (N == 4)
        numbers[i] = row(i);
      else
        numbers[i] = Pack<N>(__builtin_shufflevector(row(i).x, row(i + 4).x, 0, 1, 2, 3, 4, 5, 6, 7));
    }
    return transposed(numbers);
  }
}
// Number j from all places, as vector j.
template <int N>
DALEMBERT_INLINE inline std::array<Pack<N>, 4> gather_fours(const std::array<const double*, N>& places) {
  return columns_of<N>([&places](int lane) DALEMBERT_INLINE { return Pack<4>::load(places[lane]); });
}
// The inverse of columns_of: row i has the numbers of lane i of the vectors.
template <int N>
DALEMBERT_INLINE inline std::array<Pack<4>, N> rows_from(std::array<Pack<N>, 4> numbers) {
  std::array<Pack<4>, N> rows;
  if constexpr (N > 2) numbers = transposed(numbers);
  for (int lane = 0; lane < N; ++lane) {
    const auto& four = numbers[lane % 4].x;
    if constexpr (N == 2)
      rows[lane] = Pack<4>::of_each([&](int j) { return numbers[j][lane]; });
    else if constexpr (N == 4)
      rows[lane] = numbers[lane];
    else
      rows[lane] =
          lane < 4 ? __builtin_shufflevector(four, four, 0, 1, 2, 3) : __builtin_shufflevector(four, four, 4, 5, 6, 7);
  }
  return rows;
}
// Calls f(lane, row) for the first `count` rows, one after the other; spelt out, so that rows stay in registers.
template <int N, class F>
DALEMBERT_INLINE inline void each_row(const std::array<Pack<N>, 4>& numbers, int count, const F& f) {
  const std::array<Pack<4>, N> rows = rows_from(numbers);
  [&]<int... lane>(std::integer_sequence<int, lane...>) DALEMBERT_INLINE {
    (void)((lane < count && (f(lane, rows[lane]), true)) && ...);
  }(std::make_integer_sequence<int, N>{});
}
// Scalars with one number and its derivatives: possible arguments of user functions.
template <class S>
inline constexpr bool holds_packs = false;
template <int N>
inline constexpr bool holds_packs<Pack<N>> = true;
template <int N, class T>
inline constexpr bool holds_packs<Dual<N, T>> = holds_packs<T>;
template <class S>
concept OneNumber = !holds_packs<S>;
template <OneNumber S>
const S& one_for_zero(const S& a) {  // kernels ask a single number before they divide
  return a;
}

}  // namespace dalembert
