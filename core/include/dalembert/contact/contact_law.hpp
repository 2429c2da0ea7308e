// The law of general contact, for single numbers, duals, and several contacts at once: the normal force follows from stiffness and damping, the friction
// force is regularised (laws/friction.hpp).
#pragma once

#include <array>

#include "dalembert/laws/friction.hpp"

namespace dalembert {

// All that two surfaces make together.
template <class K>
struct ContactPairingOf {
  K stiffness, damping, friction;

  // It is positive where it pushes, and negative where damping would pull; `away` is the rate of the gap.
  template <class S>
  DALEMBERT_INLINE S normal_force(const S& gap, const S& away) const {
    return -(stiffness * gap) - damping * away;
  }
  // It acts on the first body, along the slip of the second against the first.
  template <class S, class... Sticks>
  DALEMBERT_INLINE Vec3<S> friction_force(const S& normal_force, const Vec3<S>& slip, double zone,
                                          const Sticks&... sticks) const {
    return (friction * normal_force * inverse_slip(dot(slip, slip), zone, sticks...)) * slip;
  }
  ContactPairingOf part(double share) const { return {share * stiffness, share * damping, friction}; }
};
using ContactPairing = ContactPairingOf<double>;

template <std::size_t N>
DALEMBERT_INLINE inline auto side_by_side(const std::array<ContactPairing, N>& all) {
  using P = Pack<static_cast<int>(N)>;
  const auto numbers = [&all](double ContactPairing::* number) DALEMBERT_INLINE {
    return P::of_each([&](int lane) DALEMBERT_INLINE { return all[static_cast<std::size_t>(lane)].*number; });
  };
  return ContactPairingOf<P>{numbers(&ContactPairing::stiffness), numbers(&ContactPairing::damping),
                             numbers(&ContactPairing::friction)};
}

}  // namespace dalembert
