// ObjectJointPrismaticX, specs/joints/prismatic_x.toml
#pragma once

#include "dalembert/contracts/joint_equations.hpp"
#include "dalembert/contracts/joint_frames.hpp"
#include "dalembert/contracts/pair.hpp"
#include "dalembert/joints/prismatic_x_parameters.hpp"

namespace dalembert {

struct ObjectJointPrismaticX : JointOfTable<ObjectJointPrismaticX>, ConstrainsAll, Holonomic, VaryingDirections {
  using Parameters = ObjectJointPrismaticXParameters;
  using Port = RigidPort;
  static constexpr ConstraintForms closed_forms{.reaction = true, .table = true};
  static constexpr int equations = 5;

  static constexpr std::array<JointRow, 5> rows{JointRow{JointEquation::Kind::along},
                                                {JointEquation::Kind::along},
                                                {JointEquation::Kind::product},
                                                {.kind = JointEquation::Kind::product, .same_first = true},
                                                {JointEquation::Kind::product}};

  // No displacement along y and z of the first frame; the axes of both frames stay normal to each other.
  static std::array<JointEquation, 5> table(const Parameters& p) {
    using enum JointEquation::Kind;
    const Mat3<double>&first = p.rotationMarker0, &second = p.rotationMarker1;
    return {JointEquation{along, column(first, 1)},
            {along, column(first, 2)},
            {product, column(first, 2), column(second, 1)},
            {product, column(first, 2), column(second, 0)},
            {product, column(first, 0), column(second, 1)}};
  }

  static bool output(const Parameters& p, const Context&, const RigidFrame<double>& m0, const RigidFrame<double>& m1,
                     const Vec<double, 5>& lambda, OutputVariableType variable, std::vector<double>& values) {
    switch (variable) {
      case OutputVariableType::ForceLocal: values = {0, lambda[0], lambda[1]}; return true;
      case OutputVariableType::TorqueLocal: values = {lambda[2], lambda[3], lambda[4]}; return true;
      default: return joint_motion_output(p, m0, m1, variable, values);
    }
  }
};

}  // namespace dalembert
