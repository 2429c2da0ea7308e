// ObjectJointRevoluteZ, specs/joints/revolute_z.toml
#pragma once

#include "dalembert/contracts/joint_equations.hpp"
#include "dalembert/contracts/joint_frames.hpp"
#include "dalembert/contracts/pair.hpp"
#include "dalembert/joints/revolute_z_parameters.hpp"

namespace dalembert {

struct ObjectJointRevoluteZ : JointOfTable<ObjectJointRevoluteZ>, ConstrainsAll, Holonomic {
  using Parameters = ObjectJointRevoluteZParameters;
  using Port = RigidPort;
  static constexpr ConstraintForms closed_forms{.reaction = true, .table = true};
  static constexpr int equations = 5;
  static constexpr bool fixed_directions = true;  // directions of the translations

  static constexpr std::array<JointRow, 5> rows{JointRow{JointEquation::Kind::displacement, 0},
                                                {JointEquation::Kind::displacement, 1},
                                                {JointEquation::Kind::displacement, 2},
                                                {JointEquation::Kind::product},
                                                {.kind = JointEquation::Kind::product, .same_first = true}};

  // The points coincide; the z-axis of the first frame is normal to the x- and y-axis of the second.
  static std::array<JointEquation, 5> table(const Parameters& p) {
    using enum JointEquation::Kind;
    const Vec3<double> z0 = column(p.rotationMarker0, 2);
    return {JointEquation{displacement, {1, 0, 0}},
            {displacement, {0, 1, 0}},
            {displacement, {0, 0, 1}},
            {product, z0, column(p.rotationMarker1, 0)},
            {product, z0, column(p.rotationMarker1, 1)}};
  }

  static bool output(const Parameters& p, const Context&, const RigidFrame<double>& m0, const RigidFrame<double>& m1,
                     const Vec<double, 5>& lambda, OutputVariableType variable, std::vector<double>& values) {
    if (variable == OutputVariableType::ForceLocal) {
      const Vec3<double> force = transposed_times(JointAxes<double>(p, m0, m1).A_0i, segment<3>(lambda, 0));
      values.assign(force.x.begin(), force.x.end());
      return true;
    }
    if (variable == OutputVariableType::TorqueLocal) {
      values = {lambda[3], lambda[4], 0};
      return true;
    }
    return joint_motion_output(p, m0, m1, variable, values);
  }
};

}  // namespace dalembert
