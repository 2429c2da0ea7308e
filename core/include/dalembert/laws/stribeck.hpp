// Friction force as a function of velocity: a steep linear zone, then a static peak that decays to dynamic friction.
// Armstrong-Helouvry, Dupont and Canudas de Wit, Automatica 30 (1994).
#pragma once

#include <cmath>

#include "dalembert/math/dual.hpp"

namespace dalembert {

struct StribeckCurve {
  double dynamic = 0, static_offset = 0, viscous = 0, decay_velocity = 1e-3, zone = 0;

  template <class S>
  S operator()(const S& velocity) const {
    using std::abs;
    using std::exp;
    const S speed = abs(velocity);
    if (!(speed > zone)) return zone == 0 ? S(0) : ((dynamic + static_offset) / zone) * velocity;
    const S excess = speed - zone;
    const S force = dynamic + static_offset * exp((-1 / decay_velocity) * excess) + viscous * excess;
    return velocity < 0.0 ? -force : force;
  }
};

}  // namespace dalembert
