// ObjectJointSpherical, specs/joints/spherical.toml
#pragma once

#include "dalembert/contracts/joint_equations.hpp"
#include "dalembert/contracts/joint_frames.hpp"
#include "dalembert/contracts/pair.hpp"
#include "dalembert/enums.hpp"
#include "dalembert/frames.hpp"
#include "dalembert/joints/spherical_parameters.hpp"

namespace dalembert {

struct ObjectJointSpherical : Holonomic {
  using Parameters = ObjectJointSphericalParameters;
  using Port = PointPort;
  static constexpr ConstraintForms closed_forms{.gap_rate = true, .reaction = true, .table = true};
  static constexpr int equations = 3;
  static constexpr bool fixed_directions = true;

  static bool constrains(const Parameters& p, int k) { return p.constrainedAxes[static_cast<std::size_t>(k)] != 0; }

  // The points coincide, along the global axes that are constrained.
  template <class S>
  static Vec3<S> gap(const Parameters&, const Context&, const PointFrame<S>& m0, const PointFrame<S>& m1) {
    return m1.position - m0.position;
  }
  template <class S>
  static Vec3<S> gap_rate(const Parameters&, const Context&, const PointFrame<S>& m0, const PointFrame<S>& m1) {
    return m1.velocity - m0.velocity;
  }
  template <class S>
  static std::array<Force<S>, 2> reaction(const Parameters&, const Context&, const PointFrame<S>&, const PointFrame<S>&,
                                          const Vec3<double>& lambda) {
    const Vec3<S> f{S(lambda[0]), S(lambda[1]), S(lambda[2])};
    return {Force<S>{-f}, Force<S>{f}};
  }

  static bool tabulated(const Parameters&) { return true; }
  static std::array<JointEquation, 3> table(const Parameters&) {
    return {JointEquation{.first = {1, 0, 0}}, {.first = {0, 1, 0}}, {.first = {0, 0, 1}}};
  }

  static bool output(const Parameters&, const Context&, const PointFrame<double>& m0, const PointFrame<double>& m1,
                     const Vec3<double>& lambda, OutputVariableType variable, std::vector<double>& values) {
    return point_joint_output(m0, m1, lambda, variable, values);
  }
};

}  // namespace dalembert
