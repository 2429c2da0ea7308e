// Dry friction: the laws of items and of general contact, and the switches between stick and slip.
//
// Symbols: v is the slip velocity, N the normal force, mu the coefficient of friction, and v_0 the proportional zone (m/s).
//
// 1. Regularised Coulomb friction needs no memory. The friction force grows linearly with v in the zone, and is mu N along v beyond it:
//
//      f = mu N v / max(|v|, v_0)
//
//    A StribeckCurve takes the place of mu N where the static peak is higher than sliding friction.
// 2. Stick-slip friction has an anchor x_a where the contact sticks (Cundall, Strack 1979). A tangential spring and a damper hold it there, and the
//    limit mu N bounds their force; while the contact slides, the anchor follows at the limit:
//
//      stick: f = k (x - x_a) + c v,  |f| <= mu N         slip: k |x - x_a| = mu N
//
// Armstrong-Helouvry, Dupont, Canudas de Wit: A survey of models, analysis tools and compensation methods for the control of machines with friction,
//   Automatica 30 (1994).
// Cundall, Strack: A discrete numerical model for granular assemblies, Geotechnique 29 (1979).
#pragma once

#include <cmath>
#include <optional>

#include "dalembert/math/direction.hpp"
#include "dalembert/math/dual.hpp"
#include "dalembert/math/fixed.hpp"
#include "dalembert/math/pack.hpp"
#include "dalembert/system/switches.hpp"

namespace dalembert {

// ---- regularised Coulomb friction ---------------------------------------------------------------------------------------

// Whether the linear branch of the law acts; it is never active without a zone, for any speed in the data
// coordinates.
inline bool in_zone(double speed, double zone) { return zone != 0 && speed < zone; }

// Returns v / max(|v|, v_0). The caller selects the branch, which Newton's method keeps; the direction is zero
// without slip.
template <class S, int N>
Vec<S, N> coulomb_direction(const Vec<S, N>& slip, double zone, bool sticks) {
  return sticks ? (1 / zone) * slip : direction(slip);
}
template <class S>
S coulomb_direction(const S& slip, double zone, bool sticks) {
  return sticks ? (1 / zone) * slip : slip > 0.0 ? S(1) : slip < 0.0 ? S(-1) : S(0);
}

// Only the factor 1 / max(|v|, v_0), from |v|^2; `sticks` selects the branch, otherwise v decides.
template <class S>
S inverse_slip(const S& square, double zone, std::optional<bool> sticks = {}) {
  const bool sticking = sticks ? *sticks : value_of(square) < zone * zone;
  using std::sqrt;
  return sticking ? S(1 / zone) : value_of(square) > 0 ? S(1.0 / sqrt(square)) : S(0);
}
template <int N>
DALEMBERT_INLINE inline Pack<N> inverse_slip(const Pack<N>& square, double zone) {
  const Pack<N> within(1 / zone), beyond = 1.0 / sqrt(one_for_zero(square));
  return Pack<N>::chosen(less(square, Pack<N>(zone * zone)), within, beyond);
}

// Error of friction that was computed with the wrong branch: difference between the force of its branch and the limit
// mu N.
inline double coulomb_error(double limit, double zone, double speed_before, double speed) {
  return in_zone(speed, zone) == in_zone(speed_before, zone) ? 0 : std::abs(limit / zone * (speed - zone));
}

// Stick becomes slip where the slip leaves the zone; `speed_before` is that of the last update, whose branch acts.
inline void find_coulomb_switch(bool has_friction, double speed_before, double speed, double zone, Switches& switches) {
  if (!has_friction || zone == 0) return switches.none();
  const bool slides = !in_zone(speed_before, zone);
  switches.holds("friction", slides, slides ? speed - zone : zone - speed);
}

// Friction force of a velocity: linear in the zone up to the static peak, which decays to dynamic friction beyond it.
struct StribeckCurve {
  double dynamic = 0, static_offset = 0, viscous = 0, decay_velocity = 1e-3, zone = 0;

  double peak() const { return dynamic + static_offset; }
  template <class S>
  S operator()(const S& velocity) const {
    using std::abs;
    using std::exp;
    const S speed = abs(velocity);
    if (!(speed > zone)) return zone == 0 ? S(0) : (peak() / zone) * velocity;
    const S excess = speed - zone;
    const S force = dynamic + static_offset * exp((-1 / decay_velocity) * excess) + viscous * excess;
    return velocity < 0.0 ? -force : force;
  }
  // The force has no data coordinates: it has a kink at the end of the zone.
  void find_kink(double speed, Switches& switches) const { switches.kink("friction", speed - zone); }
};

// ---- stick-slip friction with an anchor ---------------------------------------------------------------------------------

// A vector, or its direction with the length `limit` if it is longer.
template <class S>
Vec3<S> at_most(const Vec3<S>& v, const S& limit) {
  const S square = dot(v, v);
  using std::sqrt;
  if (!(square > limit * limit)) return v;
  return (limit / sqrt(square)) * v;
}

// Tangential spring and damper between a contact and its anchor. `stretch` is x - x_a, `limit` the largest friction force.
struct StickSlip {
  // tolerance of forces just after the transition from slip to stick, relative to the limit
  static constexpr double rounding = 1e-9;

  double stiffness = 0, damping = 0;

  // The force that would hold the contact, as long as it sticks.
  template <class S>
  S holding_force(const S& stretch, const S& slip) const {
    return stiffness * stretch + damping * slip;
  }
  // Bounded friction in a plane: the spring alone is limited, and again the sum with the damper. Friction always
  // dissipates energy, because a limited force loses a part along the slip.
  template <class S>
  Vec3<S> bounded_force(const Vec3<S>& stretch, const Vec3<S>& slip, const S& limit) const {
    return at_most(at_most(stiffness * stretch, limit) + damping * slip, limit);
  }
  // x_a such that `force` acts at x = `position`.
  double anchor(double position, double slip, double force) const {
    return position - (force - damping * slip) / stiffness;
  }

  // Stick ends where the holding force reaches the limit, and slip where it turns back. `direction`: sign of the sliding force, 0 for stick.
  void find_switch(double direction, double holding_force, double slip, double limit, Switches& switches) const {
    if (direction == 0)
      switches.holds("friction", false, limit - std::abs(holding_force), rounding * limit);
    else
      switches.holds("friction", true, direction * slip);
  }
};

}  // namespace dalembert
