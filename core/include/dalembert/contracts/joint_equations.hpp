// Joints whose equations are products of axes fixed in the markers' frames: a table of them gives the gap, the
// reaction and their derivatives in closed form.
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <utility>

#include "dalembert/frames.hpp"
#include "dalembert/math/rotations.hpp"

namespace dalembert {

struct JointEquation {
  enum class Kind {
    displacement,  // displacement of the second point relative to the first, along a global axis
    along,         // the same along an axis of the first frame
    product,  // scalar product of an axis of the first frame and an axis of the second, which are orthogonal
  };
  Kind kind = Kind::displacement;
  Vec3<double> first{}, second{};  // axes; axes of a frame are given in marker coordinates
};

// Properties of an equation that do not depend on parameters.
struct JointRow {
  JointEquation::Kind kind;
  int axis = 0;              // the global one, of a displacement
  bool same_first = false;  // a product whose first axis is that of the previous row, which is also a product
};

// A kernel without equations along rotating axes declares `fixed_directions`: translations do not vary its reaction.
template <class K>
concept TabulatedJoint = requires(const typename K::Parameters& p) {
  { K::table(p) } -> std::same_as<std::array<JointEquation, K::equations>>;
  { K::tabulated(p) } -> std::same_as<bool>;  // false: these parameters are left to the sweep of dual numbers
};

// Gaps of a table, and the forces on both frames that do the virtual work of the multipliers.
template <class S, std::size_t M>
struct JointSums {
  Vec<S, static_cast<int>(M)> gap;
  std::array<Wrench<S>, 2> reaction;
};
// `rows` describe the `table`, whose axes are read where parameters decide about them.
template <const auto& rows, class Table, class L, class S, int M>
JointSums<S, static_cast<std::size_t>(M)> joint_sums(const Table& table, const RigidFrame<S>& m0,
                                                     const RigidFrame<S>& m1, const Vec<L, M>& multipliers) {
  using enum JointEquation::Kind;
  const Vec3<S> span = m1.position - m0.position;
  Vec<S, M> gap;
  Vec3<S> force{}, turning{}, moment{};  // forces along axes that turn under the displacement, in addition
  Vec3<S> axis{}, seen{};  // common first axis of products, also in the axes of the second frame
  Vec3<L> sum{};                         // their second axes times multipliers
  const auto add = [&]<int k>() {
    constexpr JointRow row = rows[static_cast<std::size_t>(k)];
    const auto& e = table[static_cast<std::size_t>(k)];
    if constexpr (row.kind == displacement) {
      gap[k] = span[row.axis];
      force[row.axis] += S(multipliers[k]);
    } else if constexpr (row.kind == along) {
      const Vec3<S> direction = m0.rotation * e.first, along_axis = multipliers[k] * direction;
      gap[k] = dot(direction, span);
      force += along_axis;
      turning += along_axis;
    } else {
      if constexpr (!row.same_first) {
        axis = m0.rotation * e.first;
        seen = transposed_times(m1.rotation, axis);
        sum = {};
      }
      gap[k] = dot(e.second, seen);
      sum += multipliers[k] * e.second;
      constexpr bool goes_on = k + 1 < M && rows[static_cast<std::size_t>(std::min(k + 1, M - 1))].same_first;
      if constexpr (!goes_on) moment += cross(axis, m1.rotation * sum);
    }
  };
  [&]<int... k>(std::integer_sequence<int, k...>) {
    (add.template operator()<k>(), ...);
  }(std::make_integer_sequence<int, M>{});
  return {gap, {Wrench<S>{-force, moment - cross(span, turning)}, Wrench<S>{force, -moment}}};
}

// A joint that is fully described by its table declares the properties of its `rows`: gap and reaction follow.
template <class K>
struct JointOfTable {
  static constexpr bool is_table = true;
  static bool tabulated(const auto&) { return true; }

  template <class S>
  static auto gap(const auto& p, const auto&, const RigidFrame<S>& m0, const RigidFrame<S>& m1) {
    return joint_sums<K::rows>(K::table(p), m0, m1, Vec<double, K::equations>{}).gap;
  }
  template <class S>
  static std::array<Wrench<S>, 2> reaction(const auto& p, const auto&, const RigidFrame<S>& m0, const RigidFrame<S>& m1,
                                           const auto& lambda) {
    return joint_sums<K::rows>(K::table(p), m0, m1, lambda).reaction;
  }
};

}  // namespace dalembert
