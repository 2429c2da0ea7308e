// Points and weights of quadrature on the interval from 0 to 1.
#pragma once

#include <array>
#include <cstddef>

namespace dalembert {

struct QuadratureRule {
  static constexpr std::size_t most = 5;
  int count = 0;
  std::array<double, most> position{}, weight{};
};

namespace detail {
// Tabulated rules: on [-1, 1], symmetric, from the middle outwards.
constexpr QuadratureRule symmetric_rule(int count, const std::array<double, 3>& position,
                                        const std::array<double, 3>& weight) {
  QuadratureRule rule{.count = count};
  const int lower = count / 2, odd = count % 2;
  for (int i = 0; i < count; ++i) {
    const int outwards = i < lower ? lower - 1 - i + odd : i - lower;
    rule.position[i] = 0.5 + (i < lower ? -0.5 : 0.5) * position[outwards];
    rule.weight[i] = 0.5 * weight[outwards];
  }
  return rule;
}
}  // namespace detail

// Gauss: exact to degree 2 n - 1.
inline constexpr QuadratureRule gauss_1 = detail::symmetric_rule(1, {0}, {2});
inline constexpr QuadratureRule gauss_2 = detail::symmetric_rule(2, {0.57735026918962576}, {1});
inline constexpr QuadratureRule gauss_3 = detail::symmetric_rule(3, {0, 0.77459666924148338}, {8. / 9, 5. / 9});
inline constexpr QuadratureRule gauss_4 =
    detail::symmetric_rule(4, {0.33998104358485626, 0.86113631159405258}, {0.65214515486254614, 0.34785484513745386});
inline constexpr QuadratureRule gauss_5 = detail::symmetric_rule(
    5, {0, 0.53846931010568309, 0.90617984593866399}, {128. / 225, 0.47862867049936647, 0.23692688505618909});
// Rules that include both ends: exact to degree 2 n - 3.
inline constexpr QuadratureRule lobatto_2 = detail::symmetric_rule(2, {1}, {1});
inline constexpr QuadratureRule lobatto_3 = detail::symmetric_rule(3, {0, 1}, {4. / 3, 1. / 3});

}  // namespace dalembert
