// ObjectJointRevolute2D, specs/joints/revolute_2d.toml
#pragma once

#include "dalembert/contracts/joint_frames.hpp"
#include "dalembert/contracts/linear_equations.hpp"
#include "dalembert/contracts/pair.hpp"
#include "dalembert/enums.hpp"
#include "dalembert/frames.hpp"
#include "dalembert/joints/revolute_2d_parameters.hpp"

namespace dalembert {

struct ObjectJointRevolute2D : ConstrainsAll, Holonomic, VaryingDirections {
  using Parameters = ObjectJointRevolute2DParameters;
  using Port = PointPort;
  static constexpr ConstraintForms closed_forms{.gap_rate = true, .reaction = true, .linear = true};
  static constexpr int equations = 2;

  // The points coincide in the plane.
  template <class S>
  static Vec<S, 2> gap(const Parameters&, const Context&, const PointFrame<S>& m0, const PointFrame<S>& m1) {
    return {m1.position[0] - m0.position[0], m1.position[1] - m0.position[1]};
  }
  template <class S>
  static Vec<S, 2> gap_rate(const Parameters&, const Context&, const PointFrame<S>& m0, const PointFrame<S>& m1) {
    return {m1.velocity[0] - m0.velocity[0], m1.velocity[1] - m0.velocity[1]};
  }
  template <class S, class L>
  static std::array<Force<S>, 2> reaction(const Parameters&, const Context&, const PointFrame<S>&, const PointFrame<S>&,
                                          const Vec<L, 2>& lambda) {
    const Vec3<S> f{S(lambda[0]), S(lambda[1]), S(0)};
    return {Force<S>{-f}, Force<S>{f}};
  }
  static std::array<LinearEquation, 2> linear(const Parameters&) { return {LinearEquation{0}, LinearEquation{1}}; }
  static bool is_homogeneous(const Parameters&) { return true; }

  static bool output(const Parameters&, const Context&, const PointFrame<double>& m0, const PointFrame<double>& m1,
                     const Vec<double, 2>& lambda, OutputVariableType variable, std::vector<double>& values) {
    return point_joint_output(m0, m1, {lambda[0], lambda[1], 0}, variable, values);
  }
};

}  // namespace dalembert
