// The tangent of a connector whose forces are opposite, between two markers: J^T (K dspan + D drate).
#pragma once

#include <array>

#include "dalembert/contracts/span_forces.hpp"
#include "dalembert/system/ports.hpp"

namespace dalembert {

// Tangent for markers whose coordinates are the components of the vector: one block, added four times.
template <int N, class S, class T>
void add_between_points(const S& span_weight, const S& rate_weight, const SpanTangent<N, T>& t, const int* slots,
                        S* values) {
  Mat<S, N, N> block;
  for (int k = 0; k < N * N; ++k) block.x[k] = span_weight * t.by_span.x[k] + rate_weight * t.by_rate.x[k];
  for (int i = 0; i < 2; ++i)
    for (int row = 0; row < N; ++row)
      for (int j = 0; j < 2; ++j)
        for (int column = 0; column < N; ++column, ++slots)
          values[*slots] += (i == j ? 1.0 : -1.0) * block(row, column);
}

// Adds to values[slots[row * total + column]]. Frames begin with the vector whose span counts, and its rate.
template <int N, class S, class T>
void add_span_tangent(const PortsOf<S>& ports, const std::array<int, 2>& markers, const SpanTangent<N, T>& t,
                      const int* slots, S* values) {
  const std::array<int, 2> n{ports.ports[markers[0]].n, ports.ports[markers[1]].n};
  const auto is_point = [&](int marker) { return ports.ports[marker].n == N && ports.ports[marker].translations == N; };
  if (is_point(markers[0]) && is_point(markers[1])) {
    const S* derivative = ports.derivative(markers[0]);
    return add_between_points(derivative[0], derivative[N * N], t, slots, values);
  }
  const int total = n[0] + n[1];
  for (int j = 0; j < 2; ++j) {
    const S* derivative = ports.derivative(markers[j]);
    for (int c = 0; c < n[j]; ++c) {
      Vec<S, N> span, rate;
      for (int i = 0; i < N; ++i) {
        span[i] = derivative[i * n[j] + c];
        rate[i] = derivative[(N + i) * n[j] + c];
      }
      const Vec<S, N> force = t.by_span * span + t.by_rate * rate;
      const int* slot = slots + (j == 0 ? 0 : n[0]) + c;
      for (int i = 0; i < 2; ++i) {
        const double sign = i == j ? 1 : -1;
        const S* jacobian = ports.jacobian(markers[i]);
        for (int row = 0; row < n[i]; ++row, slot += total) {
          S sum = 0;
          for (int f = 0; f < N; ++f) sum += jacobian[f * n[i] + row] * force[f];
          values[*slot] += sign * sum;
        }
      }
    }
  }
}

}  // namespace dalembert
