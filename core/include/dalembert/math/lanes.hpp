// Four numbers side by side: kernels that are templates over the scalar compute four elements at once with it.
//
// The compiler knows such a vector on any processor; where it has registers for all four, loops that run in the widest
// registers (math/wide_registers.hpp) use them.
#pragma once

#include <cmath>

#include "dalembert/math/dual.hpp"

#define DALEMBERT_INLINE [[gnu::always_inline]]

namespace dalembert {

// To be passed between inlined functions only: how a vector is passed to others depends on the processor.
struct Lanes {
  static constexpr int count = 4;
  using Register = double __attribute__((vector_size(count * sizeof(double))));
  Register x{};

  DALEMBERT_INLINE Lanes() = default;
  DALEMBERT_INLINE Lanes(Register all) : x(all) {}
  DALEMBERT_INLINE Lanes(double all) : x{all, all, all, all} {}
  DALEMBERT_INLINE Lanes(double a, double b, double c, double d) : x{a, b, c, d} {}
  DALEMBERT_INLINE double operator[](int lane) const { return x[lane]; }

  DALEMBERT_INLINE friend Lanes operator-(const Lanes& a) { return -a.x; }
  DALEMBERT_INLINE friend Lanes operator+(const Lanes& a, const Lanes& b) { return a.x + b.x; }
  DALEMBERT_INLINE friend Lanes operator-(const Lanes& a, const Lanes& b) { return a.x - b.x; }
  DALEMBERT_INLINE friend Lanes operator*(const Lanes& a, const Lanes& b) { return a.x * b.x; }
  DALEMBERT_INLINE friend Lanes operator/(const Lanes& a, const Lanes& b) { return a.x / b.x; }
  DALEMBERT_INLINE Lanes& operator+=(const Lanes& b) { return *this = *this + b; }
  DALEMBERT_INLINE Lanes& operator-=(const Lanes& b) { return *this = *this - b; }
  DALEMBERT_INLINE Lanes& operator*=(const Lanes& b) { return *this = *this * b; }
  DALEMBERT_INLINE friend Lanes sqrt(const Lanes& a) {
    return {std::sqrt(a.x[0]), std::sqrt(a.x[1]), std::sqrt(a.x[2]), std::sqrt(a.x[3])};
  }
};

// Scalars that stand for one number and its derivatives: what a user function can be called with.
template <class S>
inline constexpr bool holds_lanes = false;
template <>
inline constexpr bool holds_lanes<Lanes> = true;
template <int N, class T>
inline constexpr bool holds_lanes<Dual<N, T>> = holds_lanes<T>;
template <class S>
concept OneNumber = !holds_lanes<S>;

}  // namespace dalembert
