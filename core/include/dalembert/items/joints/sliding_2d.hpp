// ObjectJointSliding2D, specs/joints/sliding_2d.toml
#pragma once

#include "dalembert/items/joints/sliding_along_cable.hpp"
#include "dalembert/joints/sliding_2d_parameters.hpp"

namespace dalembert {

struct ObjectJointSliding2D : SlidingAlongCable<ObjectJointSliding2DParameters, 2, 2> {
  using Parameters = ObjectJointSliding2DParameters;

  // ---- unknowns: two multipliers, the way within the step, and a multiplier for the rotation -----------------------------------
  static int algebraic_equations(const Parameters& p, std::span<const int>) { return p.constrainRotation ? 4 : 3; }

  template <class S>
  static void evaluate(const Parameters& p, const Context& c, Exchange<S>& x) {
    const Cable<S> here(p, c, x, x.unknowns[way]);
    const Vec<S, 2> normal = across(here.slope);
    const Vec<S, 2> multipliers{x.unknowns[0], x.unknowns[1]};
    // Forces on the position and the slope of the cable; the body receives the opposite of the force.
    Vec<S, 2> force, couple{};
    if (p.classicalFormulation) {
      force = -multipliers;
    } else {
      force = -multipliers[1] * normal;
      couple = multipliers[1] * across(here.gap);
    }
    if (p.constrainRotation) add_rotation(p, x, here, force, couple);
    set_equations(p, c, x, here, normal, multipliers);
    x.apply(body, Vec<S, 2>(-force));
    const std::span<S> on_cable = x.forces(cable);
    for (int i = 0; i < 4; ++i)
      for (int d = 0; d < 2; ++d)
        on_cable[2 * i + d] += here.weights.value[i] * force[d] + here.weights.slope[i] * couple[d];
  }

  static bool output(const Parameters& p, const Context& c, const Exchange<double>& x, OutputVariableType variable,
                     std::vector<double>& values) {
    if (variable == OutputVariableType::DisplacementLocal) {
      const Cable<double> here(p, c, x, x.unknowns[way]);
      const double length = norm(here.slope);
      values = {dot(here.gap, here.slope) / length, dot(here.gap, across(here.slope)) / length, 0};
      return true;
    }
    if (variable != OutputVariableType::Force) return output_of_motion(c, x, variable, values);
    values = {x.unknowns[0], x.unknowns[1], 0};
    return true;
  }

  static void check(const Parameters& p, const Connections& on) {
    on.require(p.constrainRotation ? on.gives<RigidPort>(0) : on.gives<PointPort>(0), 0, "markerNumbers",
               p.constrainRotation ? "a rigid body marker for the body" : "a marker with a position for the body");
    check_cables(p, on, "MarkerBodyCable2DCoordinates");
    on.require_data(2);
  }

 private:
  static constexpr std::size_t rotation = 3;  // number of its multiplier

  template <class S>
  static Vec<S, 2> across(const Vec<S, 2>& v) {
    return {-v[1], v[0]};
  }
  template <class S>
  static Vec<S, 2> planar(const Vec3<S>& v) {
    return {v[0], v[1]};
  }

  // The y axis of the body is normal to the slope: t n = 0. The body rotates when it slides along a curved cable, so
  // the moment is accompanied by a force along the cable: the joint does no work.
  template <class S>
  static void add_rotation(const Parameters& p, Exchange<S>& x, const Cable<S>& here, Vec<S, 2>& force,
                           Vec<S, 2>& couple) {
    const S& multiplier = x.unknowns[rotation];
    const Vec3<S> y = column(x.template frame<RigidPort>(body).rotation, 1);
    couple -= multiplier * planar(y);
    x.forces(body)[5] -= multiplier * (here.slope[1] * y[0] - here.slope[0] * y[1]);
    if (!p.classicalFormulation)
      force += (multiplier * dot(here.bend, planar(y)) / dot(here.slope, here.slope)) * here.slope;
  }

  template <class S>
  static void set_equations(const Parameters& p, const Context& c, Exchange<S>& x, const Cable<S>& here,
                            const Vec<S, 2>& normal, const Vec<S, 2>& multipliers) {
    const S along = dot(here.gap, here.slope);
    if (x.rate_level) {
      set_rates(p, c, x, here, along);
    } else if (p.classicalFormulation) {
      x.equations[0] = here.gap[0];
      x.equations[1] = here.gap[1];
    } else {
      x.equations[1] = dot(here.gap, normal);
    }
    if (!p.classicalFormulation) {
      x.equations[0] = multipliers[0];
      x.equations[way] = along;
    } else {
      x.equations[way] = dot(multipliers, here.slope);
      if (p.axialForce != 0) x.equations[way] -= p.axialForce * norm(here.slope);
    }
    if (!p.constrainRotation) return;
    const Vec<S, 2> y = planar(column(x.template frame<RigidPort>(body).rotation, 1));
    if (p.classicalFormulation) x.equations[way] += x.unknowns[rotation] * dot(here.bend, y);
    if (!x.rate_level) x.equations[rotation] = dot(here.slope, y);
  }

  // Rates across the cable, at the place nearest to the body: they are those of the constraint from which the way is eliminated.
  template <class S>
  static void set_rates(const Parameters& p, const Context& c, Exchange<S>& x, const Cable<S>& here, const S& along) {
    const Cable<S> foot(p, c, x, here.nearest(x.unknowns[way]));
    const auto rates = foot.rates(x);
    const Vec<S, 2> normal = across(foot.slope);
    const S closing = dot(rates.gap, normal) + dot(foot.gap, across(rates.slope));
    if (p.classicalFormulation) {
      const S square = dot(foot.slope, foot.slope);
      const Vec<S, 2> both = (closing / square) * normal + (along / square) * foot.slope;
      x.equations[0] = both[0];
      x.equations[1] = both[1];
    } else {
      x.equations[1] = closing;
    }
    if (!p.constrainRotation) return;
    const RigidFrame<S>& frame = x.template frame<RigidPort>(body);
    const Vec3<S> y = column(frame.rotation, 1);
    x.equations[rotation] = dot(rates.slope + rates.slide * foot.bend, planar(y)) +
                            dot(foot.slope, planar(cross(frame.angular_velocity, y)));
  }
};

}  // namespace dalembert
