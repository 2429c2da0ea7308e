// ObjectJointPrismatic2D, specs/joints/prismatic_2d.toml
#pragma once

#include "dalembert/contracts/joint_frames.hpp"
#include "dalembert/contracts/pair.hpp"
#include "dalembert/joints/prismatic_2d_parameters.hpp"

namespace dalembert {

struct ObjectJointPrismatic2D : Holonomic, VaryingDirections {
  using Parameters = ObjectJointPrismatic2DParameters;
  using Port = RigidPort;
  static constexpr ConstraintForms closed_forms{.reaction = true};
  static constexpr int equations = 2;

  static bool constrains(const Parameters& p, int k) { return k == 0 || p.constrainRotation; }

  // The points lie on a line normal to an axis of the second body; that axis stays normal to one of the first.
  template <class S>
  static Vec<S, 2> gap(const Parameters& p, const Context&, const RigidFrame<S>& m0, const RigidFrame<S>& m1) {
    const Vec3<S> axis = m0.rotation * p.axisMarker0, normal = m1.rotation * p.normalMarker1;
    return {dot(normal, m1.position - m0.position), dot(axis, normal)};
  }
  template <class S>
  static std::array<Wrench<S>, 2> reaction(const Parameters& p, const Context&, const RigidFrame<S>& m0,
                                           const RigidFrame<S>& m1, const Vec<double, 2>& lambda) {
    const Vec3<S> axis = m0.rotation * p.axisMarker0, normal = m1.rotation * p.normalMarker1;
    const Vec3<S> f = lambda[0] * normal;
    std::array<Wrench<S>, 2> forces{Wrench<S>{.force = -f},
                                    Wrench<S>{.force = f, .moment = -cross(m1.position - m0.position, f)}};
    add_moment_of_product(axis, normal, lambda[1], forces);
    return forces;
  }

  static bool output(const Parameters& p, const Context&, const RigidFrame<double>& m0, const RigidFrame<double>& m1,
                     const Vec<double, 2>& lambda, OutputVariableType variable, std::vector<double>& values) {
    const auto vector = [&](const Vec3<double>& v) { values.assign(v.x.begin(), v.x.end()); };
    const auto local = [&](const Vec3<double>& v_0) { return transposed_times(m0.rotation, v_0); };
    switch (variable) {
      case OutputVariableType::Position: vector(m0.position); return true;
      case OutputVariableType::Velocity: vector(m0.velocity); return true;
      case OutputVariableType::DisplacementLocal: vector(local(m1.position - m0.position)); return true;
      case OutputVariableType::Distance: values = {dot(p.axisMarker0, local(m1.position - m0.position))}; return true;
      case OutputVariableType::Rotation:
        values = {tait_bryan_angles(transpose(m0.rotation) * m1.rotation)[2]};
        return true;
      case OutputVariableType::ForceLocal: vector(local(lambda[0] * (m1.rotation * p.normalMarker1))); return true;
      default: return false;
    }
  }
};

}  // namespace dalembert
