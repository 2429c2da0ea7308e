// Joints whose equations are products of axes fixed in the markers' frames: a table of them says the gap, the reaction and
// their derivatives in closed form.
#pragma once

#include <array>
#include <concepts>

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

// The gap; adds to `reaction`, if it is asked for, the forces on both frames that do the virtual work of the multiplier.
template <class S>
S joint_gap(const JointEquation& e, const RigidFrame<S>& m0, const RigidFrame<S>& m1, double multiplier = 0,
            std::array<Wrench<S>, 2>* reaction = nullptr) {
  using enum JointEquation::Kind;
  if (e.kind == product) {
    const Vec3<S> a = m0.rotation * e.first, b = m1.rotation * e.second;
    if (reaction != nullptr) {
      const Vec3<S> moment = multiplier * cross(a, b);
      (*reaction)[0].moment += moment;
      (*reaction)[1].moment -= moment;
    }
    return dot(a, b);
  }
  const Vec3<S> span = m1.position - m0.position;
  if (e.kind == displacement) {
    if (reaction != nullptr) {
      const Vec3<double> force = multiplier * e.first;
      (*reaction)[0].force -= force;
      (*reaction)[1].force += force;
    }
    return dot(e.first, span);
  }
  const Vec3<S> axis = m0.rotation * e.first;
  if (reaction != nullptr) {
    const Vec3<S> force = multiplier * axis;
    (*reaction)[0].force -= force;
    (*reaction)[0].moment -= cross(span, force);  // the axis turns under the displacement
    (*reaction)[1].force += force;
  }
  return dot(axis, span);
}

// Gap and reaction of a joint that is nothing but its table.
template <class K>
struct JointOfTable {
  static constexpr bool is_table = true;

  template <class S>
  static auto gap(const auto& p, const auto&, const RigidFrame<S>& m0, const RigidFrame<S>& m1) {
    const auto table = K::table(p);
    Vec<S, static_cast<int>(table.size())> g;
    for (std::size_t k = 0; k < table.size(); ++k) g[static_cast<int>(k)] = joint_gap(table[k], m0, m1);
    return g;
  }
  template <class S>
  static std::array<Wrench<S>, 2> reaction(const auto& p, const auto&, const RigidFrame<S>& m0, const RigidFrame<S>& m1,
                                           const auto& lambda) {
    const auto table = K::table(p);
    std::array<Wrench<S>, 2> forces{};
    for (std::size_t k = 0; k < table.size(); ++k) joint_gap(table[k], m0, m1, lambda[static_cast<int>(k)], &forces);
    return forces;
  }
};

}  // namespace dalembert
