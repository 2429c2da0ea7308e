// ObjectConnectorCoordinateSpringDamperExt, specs/connectors/coordinate_spring_damper_ext.toml
#pragma once

#include <algorithm>
#include <cmath>

#include "dalembert/connectors/coordinate_spring_damper_ext_parameters.hpp"
#include "dalembert/contracts/pair.hpp"
#include "dalembert/contracts/user_function.hpp"
#include "dalembert/enums.hpp"
#include "dalembert/frames.hpp"
#include "dalembert/laws/friction.hpp"

namespace dalembert {

struct ObjectConnectorCoordinateSpringDamperExt : HasPairHistory, SwitchesByItself, NoConnectorForms {
  using Parameters = ObjectConnectorCoordinateSpringDamperExtParameters;
  using Port = ScalarPort;
  static constexpr int data_coordinates = 3;

  // Data coordinates: friction force while slipping (0: sticking), last sticking position, penetration of the stops.
  enum Data { friction = 0, stick = 1, stop = 2 };

  static bool needs_data(const Parameters& p) { return has_bristles(p) || p.useLimitStops; }

  template <class S>
  static std::array<ScalarForce<S>, 2> forces(const Parameters& p, const Context& c, const ScalarFrame<S>& m0,
                                              const ScalarFrame<S>& m1) {
    const S f = force(p, c, Difference<S>(p, m0, m1));
    return {ScalarForce<S>{p.factor0 * f}, ScalarForce<S>{-p.factor1 * f}};
  }

  static PostNewton update(const Parameters& p, const Context&, const ScalarFrame<double>& m0,
                           const ScalarFrame<double>& m1, const double* start, double* data) {
    const Difference<double> d(p, m0, m1);
    PostNewton verdict;
    if (has_bristles(p)) {
      if (data[friction] == 0) {
        update_sticking(p, d, data, verdict);
      } else {
        update_slipping(p, d, start, data, verdict);
      }
    }
    if (p.useLimitStops) update_stops(p, d, data, verdict);
    return verdict;
  }

  static int switch_count(const Parameters&) { return 2; }
  static void find_switches(const Parameters& p, const Context& c, const ScalarFrame<double>& m0,
                            const ScalarFrame<double>& m1, Switches& switches) {
    const Difference<double> d(p, m0, m1);
    if (has_bristles(p) && c.data != nullptr) {
      const double direction = c.data[friction] == 0 ? 0 : std::copysign(1.0, c.data[friction]);
      bristle(p).find_switch(direction, sticking(p, d, c.data[stick]), d.rate, curve(p).peak(), switches);
    } else if (p.frictionProportionalZone != 0) {
      curve(p).find_kink(std::abs(d.rate), switches);
    } else {
      switches.none();
    }
    if (!p.useLimitStops || c.data == nullptr)
      switches.none();
    else if (c.data[stop] == 0)
      switches.holds("stop", false, std::min(p.limitStopsUpper - d.value, d.value - p.limitStopsLower));
    else
      switches.holds("stop", true, c.data[stop] > 0 ? d.value - p.limitStopsUpper : p.limitStopsLower - d.value);
  }
  // Slip that ends where it stands still goes on as stick with the same force.
  static void switch_over(const Parameters& p, const Context& c, const ScalarFrame<double>& m0,
                          const ScalarFrame<double>& m1, const double* before, double* data) {
    const Difference<double> d(p, m0, m1);
    const bool slipped = has_bristles(p) && before[friction] != 0;
    update(p, c, m0, m1, before, data);
    if (!slipped || data[friction] != 0) return;
    data[stick] = bristle(p).anchor(d.value, d.rate, std::copysign(curve(p).peak(), before[friction]));
  }

  static bool output(const Parameters& p, const Context& c, const ScalarFrame<double>& m0,
                     const ScalarFrame<double>& m1, OutputVariableType variable, std::vector<double>& values) {
    const Difference<double> d(p, m0, m1);
    switch (variable) {
      case OutputVariableType::Displacement: values = {d.value}; return true;
      case OutputVariableType::Velocity: values = {d.rate}; return true;
      case OutputVariableType::Force: values = {p.activeConnector ? force(p, c, d) : 0.0}; return true;
      default: return false;
    }
  }

 private:
  template <class S>
  struct Difference {
    S value, rate;
    Difference(const Parameters& p, const ScalarFrame<S>& m0, const ScalarFrame<S>& m1)
        : value(p.factor1 * m1.value - p.factor0 * m0.value), rate(p.factor1 * m1.rate - p.factor0 * m0.rate) {}
  };

  static StribeckCurve curve(const Parameters& p) {
    return {p.fDynamicFriction, p.fStaticFrictionOffset, p.fViscousFriction, p.exponentialDecayStatic,
            p.frictionProportionalZone};
  }
  static StickSlip bristle(const Parameters& p) { return {p.stickingStiffness, p.stickingDamping}; }
  static bool has_bristles(const Parameters& p) {
    return p.frictionProportionalZone == 0 && (p.fDynamicFriction != 0 || p.fStaticFrictionOffset != 0);
  }
  static double limit(const Parameters& p, double state) { return state > 0 ? p.limitStopsUpper : p.limitStopsLower; }

  template <class S>
  static S sticking(const Parameters& p, const Difference<S>& d, double position) {
    return bristle(p).holding_force(d.value - position, d.rate);
  }

  template <class S>
  static S force(const Parameters& p, const Context& c, const Difference<S>& d) {
    if (p.springForceUserFunction)
      return call_scalar(p.springForceUserFunction, c, d.value, d.rate, p.stiffness, p.damping, p.offset,
                         p.velocityOffset, p.fDynamicFriction, p.fStaticFrictionOffset, p.exponentialDecayStatic,
                         p.fViscousFriction, p.frictionProportionalZone);
    S f = p.stiffness * (d.value - p.offset) + p.damping * (d.rate - p.velocityOffset);
    if (p.frictionProportionalZone != 0) f += curve(p)(d.rate);
    if (has_bristles(p) && c.data != nullptr) f += bristle_force(p, c.data, d);
    if (p.useLimitStops && c.data != nullptr && c.data[stop] != 0)
      f += p.limitStopsStiffness * (d.value - limit(p, c.data[stop])) + p.limitStopsDamping * d.rate;
    return f;
  }

  // The direction of slip is that of the last update: it does not change during a Newton iteration.
  template <class S>
  static S bristle_force(const Parameters& p, const double* data, const Difference<S>& d) {
    using std::abs;
    if (data[friction] == 0) return sticking(p, d, data[stick]);
    const S magnitude = abs(curve(p)(d.rate));
    return data[friction] < 0 ? -magnitude : magnitude;
  }

  static void update_sticking(const Parameters& p, const Difference<double>& d, double* data, PostNewton& verdict) {
    const double held = sticking(p, d, data[stick]);
    if (std::abs(held) <= curve(p).peak()) return;
    data[friction] = curve(p)(d.rate);
    verdict.error += std::abs(held) - std::abs(data[friction]);
  }

  // Slip against its previous direction becomes stick: at the position where sticking would have begun in the step,
  // or with continuous force.
  static void update_slipping(const Parameters& p, const Difference<double>& d, const double* start, double* data,
                              PostNewton& verdict) {
    const double slipping = curve(p)(d.rate);
    if (d.rate * data[friction] >= 0) {
      data[friction] = slipping;
      data[stick] = d.value;
      return;
    }
    if (start[friction] == 0) {
      verdict.error += std::abs(std::abs(slipping) - std::abs(sticking(p, d, data[stick])));
      data[stick] = start[stick];
    } else {
      verdict.error += std::abs(start[friction] - slipping);
      data[stick] = bristle(p).anchor(d.value, d.rate, start[friction]);
    }
    data[friction] = 0;
  }

  static void update_stops(const Parameters& p, const Difference<double>& d, double* data, PostNewton& verdict) {
    const double before = data[stop];
    if (before == 0) {
      if (d.value > p.limitStopsUpper) data[stop] = d.value - p.limitStopsUpper;
      if (d.value < p.limitStopsLower) data[stop] = d.value - p.limitStopsLower;
      verdict.error += std::abs(data[stop] * p.limitStopsStiffness);
      return;
    }
    data[stop] = d.value - limit(p, before);
    if (data[stop] * before < 0) {
      data[stop] = 0;
      verdict.error += std::abs(before * p.limitStopsStiffness);
    }
  }
};

}  // namespace dalembert
