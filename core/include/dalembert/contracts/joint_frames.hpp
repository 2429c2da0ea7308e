// The frames of a joint: those of its markers, rotated by the joint's parameters, and the relative motion in the axes
// of the first frame.
#pragma once

#include <vector>

#include "dalembert/enums.hpp"
#include "dalembert/frames.hpp"
#include "dalembert/math/rotations.hpp"

namespace dalembert {

// Joint frames i and j on both markers, with the notation of frames.hpp: their axes are the columns.
template <class S>
struct JointAxes {
  Mat3<S> A_0i, A_0j;

  template <class Parameters>
  JointAxes(const Parameters& p, const RigidFrame<S>& m0, const RigidFrame<S>& m1)
      : A_0i(m0.rotation * p.rotationMarker0), A_0j(m1.rotation * p.rotationMarker1) {}
};

// d(a . b) for an axis a that turns with the first frame and b with the second, per unit multiplier: a moment a x b on the
// first frame and the opposite on the second.
template <class S>
void add_moment_of_product(const Vec3<S>& a, const Vec3<S>& b, double lambda, std::array<Wrench<S>, 2>& forces) {
  const Vec3<S> moment = lambda * cross(a, b);
  forces[0].moment += moment;
  forces[1].moment -= moment;
}

// Outputs of joints of two points, with the force on the first one.
inline bool point_joint_output(const PointFrame<double>& m0, const PointFrame<double>& m1, const Vec3<double>& force,
                               OutputVariableType variable, std::vector<double>& values) {
  const auto vector = [&](const Vec3<double>& v) { values.assign(v.x.begin(), v.x.end()); };
  switch (variable) {
    case OutputVariableType::Position: vector(m0.position); return true;
    case OutputVariableType::Velocity: vector(m0.velocity); return true;
    case OutputVariableType::Displacement: vector(m1.position - m0.position); return true;
    case OutputVariableType::Force: vector(force); return true;
    default: return false;
  }
}

// Outputs that all joints with two rigid frames share.
template <class Parameters>
bool joint_motion_output(const Parameters& p, const RigidFrame<double>& m0, const RigidFrame<double>& m1,
                         OutputVariableType variable, std::vector<double>& values) {
  const JointAxes<double> axes(p, m0, m1);
  const auto vector = [&](const Vec3<double>& v) { values.assign(v.x.begin(), v.x.end()); };
  const auto local = [&](const Vec3<double>& v_0) { vector(transposed_times(axes.A_0i, v_0)); };
  switch (variable) {
    case OutputVariableType::Position: vector(m0.position); return true;
    case OutputVariableType::Velocity: vector(m0.velocity); return true;
    case OutputVariableType::DisplacementLocal: local(m1.position - m0.position); return true;
    case OutputVariableType::VelocityLocal: local(m1.velocity - m0.velocity); return true;
    case OutputVariableType::Rotation: vector(tait_bryan_angles(transpose(axes.A_0i) * axes.A_0j)); return true;
    case OutputVariableType::AngularVelocityLocal: local(m1.angular_velocity - m0.angular_velocity); return true;
    default: return false;
  }
}

}  // namespace dalembert
