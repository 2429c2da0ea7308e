// ObjectJointRevoluteZ, specs/joints/revolute_z.toml
#pragma once

#include "dalembert/contracts/context.hpp"
#include "dalembert/contracts/joint_frames.hpp"
#include "dalembert/joints/revolute_z_parameters.hpp"

namespace dalembert {

struct ObjectJointRevoluteZ {
  using Parameters = ObjectJointRevoluteZParameters;
  using Port = RigidPort;
  static constexpr int equations = 5;

  // The points coincide; the z-axis of the first frame is normal to the x- and y-axis of the second.
  template <class S>
  static Vec<S, 5> gap(const Parameters& p, const Context&, const RigidFrame<S>& m0, const RigidFrame<S>& m1) {
    const JointAxes<S> axes(p, m0, m1);
    const Vec3<S> span = m1.position - m0.position, z0 = column(axes.first, 2);
    return {span[0], span[1], span[2], dot(z0, column(axes.second, 0)), dot(z0, column(axes.second, 1))};
  }
  template <class S>
  static std::array<Wrench<S>, 2> reaction(const Parameters& p, const Context&, const RigidFrame<S>& m0, const RigidFrame<S>& m1,
                                           const Vec<double, 5>& lambda) {
    const JointAxes<S> axes(p, m0, m1);
    const Vec3<S> f{S(lambda[0]), S(lambda[1]), S(lambda[2])}, z0 = column(axes.first, 2);
    std::array<Wrench<S>, 2> forces{Wrench<S>{.force = -f}, Wrench<S>{.force = f}};
    add_moment_of_product(z0, column(axes.second, 0), lambda[3], forces);
    add_moment_of_product(z0, column(axes.second, 1), lambda[4], forces);
    return forces;
  }

  static bool output(const Parameters& p, const Context&, const RigidFrame<double>& m0, const RigidFrame<double>& m1,
                     const Vec<double, 5>& lambda, OutputVariableType variable, std::vector<double>& values) {
    if (variable == OutputVariableType::ForceLocal) {
      const Vec3<double> force = transposed_times(JointAxes<double>(p, m0, m1).first, segment<3>(lambda, 0));
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
