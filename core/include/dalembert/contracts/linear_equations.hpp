// Constraints that are linear in the frames of their markers: their derivatives are constant.
#pragma once

#include <array>
#include <concepts>

namespace dalembert {

// factor[0] x0 + factor[1] x1 = ..., where x is one component of the position (or the coordinate) of each marker. Its rate is
// an equation of the velocities, and a multiplier a force along the same component.
struct LinearEquation {
  int component = 0;
  std::array<double, 2> factor{-1, 1};
};

template <class K>
concept LinearConstraint = requires(const typename K::Parameters& p) {
  { K::linear(p) } -> std::same_as<std::array<LinearEquation, K::equations>>;
  { K::is_homogeneous(p) } -> std::same_as<bool>;  // the right-hand side is zero at all times
};

}  // namespace dalembert
