// The law of contact, of single numbers, of duals, and of several contacts at once: pressure by stiffness and damping, and friction that grows
// with the slip in a proportional zone.
#pragma once

#include <array>

#include "dalembert/laws/friction.hpp"

namespace dalembert {

// All that two surfaces make together.
template <class K>
struct ContactPairingOf {
  K stiffness, damping, friction;

  // What presses two things together; negative where their damping would pull.
  template <class S>
  DALEMBERT_INLINE S pressure(const S& gap, const S& away) const {
    return -(stiffness * gap) - damping * away;
  }
  // What the second thing, which slips against the first, drags this along with.
  template <class S, class... Sticks>
  DALEMBERT_INLINE Vec3<S> drag(const S& pressure, const Vec3<S>& slip, double zone, const Sticks&... sticks) const {
    return (friction * pressure * inverse_slip(dot(slip, slip), zone, sticks...)) * slip;
  }
  ContactPairingOf part(double share) const { return {share * stiffness, share * damping, friction}; }
};
using ContactPairing = ContactPairingOf<double>;

template <std::size_t N>
DALEMBERT_INLINE inline auto side_by_side(const std::array<ContactPairing, N>& all) {
  using P = Pack<static_cast<int>(N)>;
  const auto numbers = [&all](double ContactPairing::*number) DALEMBERT_INLINE {
    return P::of_each([&](int lane) DALEMBERT_INLINE { return all[static_cast<std::size_t>(lane)].*number; });
  };
  return ContactPairingOf<P>{numbers(&ContactPairing::stiffness), numbers(&ContactPairing::damping), numbers(&ContactPairing::friction)};
}

}  // namespace dalembert
