// ObjectJointPrismaticX, specs/joints/prismatic_x.toml
#pragma once

#include "dalembert/contracts/context.hpp"
#include "dalembert/contracts/joint_frames.hpp"
#include "dalembert/joints/prismatic_x_parameters.hpp"

namespace dalembert {

struct ObjectJointPrismaticX {
  using Parameters = ObjectJointPrismaticXParameters;
  using Port = RigidPort;
  static constexpr int equations = 5;

  // No displacement along y and z of the first frame; the axes of both frames stay normal to each other.
  template <class S>
  static Vec<S, 5> gap(const Parameters& p, const Context&, const RigidFrame<S>& m0, const RigidFrame<S>& m1) {
    const JointAxes<S> axes(p, m0, m1);
    const Vec3<S> along = transposed_times(axes.first, m1.position - m0.position);
    const Vec3<S> x0 = column(axes.first, 0), z0 = column(axes.first, 2), x1 = column(axes.second, 0), y1 = column(axes.second, 1);
    return {along[1], along[2], dot(z0, y1), dot(z0, x1), dot(x0, y1)};
  }
  template <class S>
  static std::array<Wrench<S>, 2> reaction(const Parameters& p, const Context&, const RigidFrame<S>& m0, const RigidFrame<S>& m1,
                                           const Vec<double, 5>& lambda) {
    const JointAxes<S> axes(p, m0, m1);
    const Vec3<S> x0 = column(axes.first, 0), z0 = column(axes.first, 2), x1 = column(axes.second, 0), y1 = column(axes.second, 1);
    const Vec3<S> f = lambda[0] * column(axes.first, 1) + lambda[1] * z0;
    const Vec3<S> lever = cross(m1.position - m0.position, f);  // the axes turn under the displacement
    std::array<Wrench<S>, 2> forces{Wrench<S>{.force = -f, .moment = -lever}, Wrench<S>{.force = f}};
    add_moment_of_product(z0, y1, lambda[2], forces);
    add_moment_of_product(z0, x1, lambda[3], forces);
    add_moment_of_product(x0, y1, lambda[4], forces);
    return forces;
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
