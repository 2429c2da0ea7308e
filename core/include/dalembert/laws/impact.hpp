// Normal force of a contact: a power of the penetration, with damping that makes impacts lose energy.
//
// Hunt, Crossley: Coefficient of restitution interpreted as damping in vibroimpact, Journal of Applied Mechanics 42 (1975).
// Gonthier, McPhee, Lange, Piedboeuf: A regularized contact model with asymmetric damping and dwell-time dependent friction,
//   Multibody System Dynamics 11 (2004).
// Carvalho, Martins: Exact restitution and generalizations for the Hunt-Crossley contact model, Mechanism and Machine
//   Theory 139 (2019).
#pragma once

#include <algorithm>
#include <cmath>

#include "dalembert/math/dual.hpp"

namespace dalembert {

// A power that negative numbers, which Newton's method may try as penetrations, continue in an odd way.
template <class S>
S odd_power(const S& x, double exponent) {
  using std::abs;
  using std::exp;
  using std::log;
  if (exponent == 1 || value_of(x) == 0) return x;
  const S magnitude = exp(exponent * log(abs(x)));
  return x < 0.0 ? -magnitude : magnitude;
}

// Losses hold back bodies that separate. If they are limited, they never pull: the normal force is then negative only if it is negative without losses,
// because of attraction, or of a negative penetration that Newton's method tries.
template <class S>
S with_losses(bool limited, const S& lossless, const S& losses) {
  const S normal_force = lossless + losses;
  if (!limited || !(normal_force < 0.0) || !(losses < 0.0)) return normal_force;
  return lossless < 0.0 ? lossless : S(0);
}

// Changes its sign where the limitation of losses begins.
inline double pull_margin(bool limited, double lossless, double losses) {
  return limited ? lossless + losses - std::min(lossless, 0.0) : 1;
}

struct ImpactLaw {
  double stiffness = 0, exponent = 1, damping = 0;
  double restitution_damping = 0;  // chi: the power law is multiplied by 1 + chi * rate
  bool limited = false;

  // `impact_velocity`: rate of penetration at the begin of the contact.
  template <class Parameters>
  ImpactLaw(const Parameters& p, double impact_velocity)
      : stiffness(p.contactStiffness), exponent(p.contactStiffnessExponent), damping(p.contactDamping) {
    if constexpr (requires { p.limitDamping; }) limited = p.limitDamping;
    const double velocity = std::max(p.minimumImpactVelocity, impact_velocity), e = p.restitutionCoefficient;
    if (p.impactModel == 0 || !(velocity > 0)) return;
    double loss = 1.5 * (1 - e);
    if (p.impactModel == 2) loss = e > 1.0 / 3 ? loss * (11 - e) / (1 + 9 * e) : (1 - e * e) / e;
    restitution_damping = loss / velocity;
  }

  // A force that pushes is positive.
  template <class S>
  S normal_force(const S& penetration, const S& rate) const {
    const S elastic = stiffness * odd_power(penetration, exponent);
    return with_losses<S>(limited, elastic, losses(elastic, rate));
  }
  double pull_margin(double penetration, double rate) const {
    const double elastic = stiffness * odd_power(penetration, exponent);
    return dalembert::pull_margin(limited, elastic, losses(elastic, rate));
  }

 private:
  template <class S>
  S losses(const S& elastic, const S& rate) const {
    return (restitution_damping * elastic + damping) * rate;
  }
};

}  // namespace dalembert
