// Integration points of ObjectANCFCable2D with their shape functions, specs/finite_elements/ancf_cable_2d.toml
#pragma once

#include <array>

namespace dalembert {

struct ANCFCable2DRule {
  // Factors of the chord (r1 - r0) / L and of both nodal slopes in r' and in L r''.
  struct Sample {
    double position = 0, weight = 0;  // along the axis, both from 0 to 1
    std::array<double, 3> slope{}, bend{};
  };
  int stretching_points = 0, bending_points = 0;
  std::array<Sample, 5> stretching;
  std::array<Sample, 3> bending;

  static constexpr Sample sample(double xi, double weight) {
    return {xi,
            weight,
            {6 * xi * (1 - xi), (1 - xi) * (1 - 3 * xi), xi * (3 * xi - 2)},
            {6 - 12 * xi, 6 * xi - 4, 6 * xi - 2}};
  }

  // Points and weights on [-1, 1], symmetric; those from the middle outwards are given.
  template <std::size_t Capacity>
  static constexpr int fill(std::array<Sample, Capacity>& samples, int points, const std::array<double, 3>& position,
                            const std::array<double, 3>& weight) {
    const int lower = points / 2, odd = points % 2;
    for (int i = 0; i < points; ++i) {
      const int outwards = i < lower ? lower - 1 - i + odd : i - lower;
      const double side = i < lower ? -0.5 : 0.5;
      samples[i] = sample(0.5 + side * position[outwards], 0.5 * weight[outwards]);
    }
    return points;
  }
  struct Table {
    int points;
    std::array<double, 3> position, weight;
  };
  static constexpr ANCFCable2DRule make(const Table& stretching, const Table& bending) {
    ANCFCable2DRule rule{};
    rule.stretching_points = fill(rule.stretching, stretching.points, stretching.position, stretching.weight);
    rule.bending_points = fill(rule.bending, bending.points, bending.position, bending.weight);
    return rule;
  }
};

inline constexpr ANCFCable2DRule::Table gauss_2{2, {0.57735026918962576}, {1}};
inline constexpr ANCFCable2DRule::Table gauss_3{3, {0, 0.77459666924148338}, {8. / 9, 5. / 9}};
inline constexpr ANCFCable2DRule::Table gauss_4{
    4, {0.33998104358485626, 0.86113631159405258}, {0.65214515486254614, 0.34785484513745386}};
inline constexpr ANCFCable2DRule::Table gauss_5{
    5, {0, 0.53846931010568309, 0.90617984593866399}, {128. / 225, 0.47862867049936647, 0.23692688505618909}};
inline constexpr ANCFCable2DRule::Table lobatto_3{3, {0, 1}, {4. / 3, 1. / 3}};

// By the parameter useReducedOrderIntegration.
inline constexpr std::array<ANCFCable2DRule, 3> ancf_cable_2d_rules{ANCFCable2DRule::make(gauss_5, gauss_3),
                                                                    ANCFCable2DRule::make(gauss_4, gauss_2),
                                                                    ANCFCable2DRule::make(lobatto_3, gauss_2)};

}  // namespace dalembert
