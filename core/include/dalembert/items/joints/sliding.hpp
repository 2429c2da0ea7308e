// ObjectJointSliding, specs/joints/sliding.toml
#pragma once

#include "dalembert/items/joints/sliding_along_cable.hpp"
#include "dalembert/joints/sliding_parameters.hpp"

namespace dalembert {

struct ObjectJointSliding : SlidingAlongCable<ObjectJointSlidingParameters, 3, 0> {
  using Parameters = ObjectJointSlidingParameters;

  // ---- unknowns: the way within the step, multipliers of the position, multipliers of the rotation -------------------------------
  static int algebraic_equations(const Parameters& p, std::span<const int>) { return turns(p) ? 7 : 4; }

  template <class S>
  static void evaluate(const Parameters& p, const Context& c, Exchange<S>& x) {
    const Cable<S> here(p, c, x, x.unknowns[way]);
    Vec3<S> force, couple;  // on position and slope of the cable; the body receives the opposite of the force
    for (int i = 0; i < 3; ++i)
      if (p.constrainTranslations[static_cast<std::size_t>(i)])
        force[i] = -x.unknowns[static_cast<std::size_t>(first_force + i)];
    each_axis(p, x, [&](const Vec3<S>& axis, const S& multiplier, int) { couple -= multiplier * axis; });
    set_equations(p, c, x, here, force);
    x.apply(body, Vec3<S>(-force));
    each_axis(p, x, [&](const Vec3<S>& axis, const S& multiplier, int) {
      const Vec3<S> moment = multiplier * cross(here.slope, axis);
      for (int i = 0; i < 3; ++i) x.forces(body)[static_cast<std::size_t>(3 + i)] += moment[i];
    });
    const std::span<S> on_cable = x.forces(cable);
    for (int i = 0; i < 4; ++i)
      for (int d = 0; d < 3; ++d)
        on_cable[static_cast<std::size_t>(3 * i + d)] +=
            here.weights.value[i] * force[d] + here.weights.slope[i] * couple[d];
  }

  static bool output(const Parameters&, const Context& c, const Exchange<double>& x, OutputVariableType variable,
                     std::vector<double>& values) {
    if (variable != OutputVariableType::Force) return output_of_motion(c, x, variable, values);
    values.assign(&x.unknowns[first_force], &x.unknowns[first_force] + 3);
    return true;
  }

  static void check(const Parameters& p, const Connections& on) {
    if (p.constrainRotations[0])
      on.refuse("constrainRotations", "a rotation about the x axis that is constrained",
                "0 as first flag: a cable has no torsion");
    on.require(turns(p) ? on.gives<RigidPort>(0) : on.gives<PointPort>(0), 0, "markerNumbers",
               turns(p) ? "a rigid body marker for the body, as rotations are constrained"
                        : "a marker with a position for the body");
    check_cables(p, on, "MarkerBodyBeamShape");
    on.require_data(2);
  }

 private:
  enum Unknown { first_force = 1, first_moment = 4 };

  static bool turns(const Parameters& p) { return p.constrainRotations[1] || p.constrainRotations[2]; }
  static bool holds(const Parameters& p) {
    return p.constrainTranslations[0] && p.constrainTranslations[1] && p.constrainTranslations[2];
  }
  // Axes of the body that stay normal to the slope, with their multipliers: z does not turn about y, y not about z.
  template <class S, class Call>
  static void each_axis(const Parameters& p, const Exchange<S>& x, const Call& call) {
    for (int i = 1; i < 3; ++i)
      if (p.constrainRotations[static_cast<std::size_t>(i)])
        call(column(x.template frame<RigidPort>(body).rotation, 3 - i),
             x.unknowns[static_cast<std::size_t>(first_moment + i)], first_moment + i);
  }

  template <class S>
  static void set_equations(const Parameters& p, const Context& c, Exchange<S>& x, const Cable<S>& here,
                            const Vec3<S>& force) {
    for (std::size_t i = turns(p) ? 7 : 4; i-- > 1;) x.equations[i] = x.unknowns[i];  // inactive equations
    x.equations[way] = -dot(force, here.slope);
    if (p.axialForce != 0) x.equations[way] -= p.axialForce * norm(here.slope);
    each_axis(p, x, [&](const Vec3<S>& axis, const S& multiplier, int row) {
      x.equations[way] += multiplier * dot(here.bend, axis);
      x.equations[static_cast<std::size_t>(row)] = dot(here.slope, axis);
    });
    if (x.rate_level && holds(p)) return set_rates(p, c, x, here);
    for (int i = 0; i < 3; ++i)
      if (p.constrainTranslations[static_cast<std::size_t>(i)])
        x.equations[static_cast<std::size_t>(first_force + i)] = here.gap[i];
  }

  // Rates across the cable, at the place nearest to the body, and the position along it.
  template <class S>
  static void set_rates(const Parameters& p, const Context& c, Exchange<S>& x, const Cable<S>& here) {
    const Cable<S> foot(p, c, x, here.nearest(x.unknowns[way]));
    const auto rates = foot.rates(x);
    const S square = dot(foot.slope, foot.slope);
    const Vec3<S> closing = cross(rates.slope, foot.gap) + cross(foot.slope, rates.gap);
    const Vec3<S> both =
        (1.0 / square) * cross(closing, foot.slope) + (dot(here.gap, here.slope) / square) * foot.slope;
    for (int i = 0; i < 3; ++i) x.equations[static_cast<std::size_t>(first_force + i)] = both[i];
    each_axis(p, x, [&](const Vec3<S>& axis, const S&, int row) {
      const Vec3<S>& spin = x.template frame<RigidPort>(body).angular_velocity;
      x.equations[static_cast<std::size_t>(row)] =
          dot(rates.slope + rates.slide * foot.bend, axis) + dot(foot.slope, cross(spin, axis));
    });
  }
};

}  // namespace dalembert
