// Joints whose equations are products of axes fixed in the markers' frames: a table of them says the gap, the reaction and
// their derivatives in closed form.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>

#include "dalembert/frames.hpp"
#include "dalembert/math/rotations.hpp"

namespace dalembert {

struct JointEquation {
  enum class Kind {
    displacement,  // of the second point against the first, along a global axis
    along,         // the same along an axis of the first frame
    product,       // of an axis of the first frame and one of the second, which are normal to each other
  };
  Kind kind = Kind::displacement;
  Vec3<double> first{}, second{};  // axes; of a frame: in the marker's own coordinates
};

// A kernel without equations along axes that turn says `fixed_directions`: translations do not vary its reaction.
// A kernel may leave single parameter sets to the sweep of dual numbers by `tabulated(p)`.
template <class K>
concept TabulatedJoint = requires(const typename K::Parameters& p) {
  { K::table(p) } -> std::same_as<std::array<JointEquation, K::equations>>;
};

// Gaps of a table, and the forces on both frames that do the virtual work of the multipliers.
template <class S, std::size_t M>
struct JointSums {
  Vec<S, static_cast<int>(M)> gap;
  std::array<Wrench<S>, 2> reaction;
};
template <class S, std::size_t M>
JointSums<S, M> joint_sums(const std::array<JointEquation, M>& table, const RigidFrame<S>& m0, const RigidFrame<S>& m1,
                           const double* multipliers) {
  using enum JointEquation::Kind;
  const Vec3<S> span = m1.position - m0.position;
  Vec<S, static_cast<int>(M)> gap;
  Vec3<S> force{}, turning{}, moment{};  // forces along axes that turn under the displacement, in addition
  for (std::size_t k = 0; k < M;) {
    const JointEquation& e = table[k];
    const Vec3<S> axis = e.kind == displacement ? Vec3<S>{S(e.first[0]), S(e.first[1]), S(e.first[2])} : m0.rotation * e.first;
    if (e.kind == product) {  // those with the same first axis together, in the axes of the second frame
      const Vec3<S> seen = transposed_times(m1.rotation, axis);
      Vec3<double> sum{};
      do {
        gap[static_cast<int>(k)] = dot(table[k].second, seen);
        sum += multipliers[k] * table[k].second;
      } while (++k < M && table[k].kind == product && table[k].first.x == e.first.x);
      moment += cross(axis, m1.rotation * sum);
    } else {
      gap[static_cast<int>(k)] = dot(axis, span);
      const Vec3<S> along_axis = multipliers[k] * axis;
      force += along_axis;
      if (e.kind == along) turning += along_axis;
      ++k;
    }
  }
  return {gap, {Wrench<S>{-force, moment - cross(span, turning)}, Wrench<S>{force, -moment}}};
}

// Gap and reaction of a joint that is nothing but its table.
template <class K>
struct JointOfTable {
  static constexpr bool is_table = true;

  template <class S>
  static auto gap(const auto& p, const auto&, const RigidFrame<S>& m0, const RigidFrame<S>& m1) {
    const auto table = K::table(p);
    constexpr std::array<double, table.size()> none{};
    return joint_sums(table, m0, m1, none.data()).gap;
  }
  template <class S>
  static std::array<Wrench<S>, 2> reaction(const auto& p, const auto&, const RigidFrame<S>& m0, const RigidFrame<S>& m1,
                                           const auto& lambda) {
    return joint_sums(K::table(p), m0, m1, lambda.x.data()).reaction;
  }
};

}  // namespace dalembert
