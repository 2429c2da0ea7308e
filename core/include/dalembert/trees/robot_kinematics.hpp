// Kinematics of the links of a robot, which have frames of their own besides those of their joints: poses, Jacobians, weights, and
// coordinates of the joints for a given pose.
#pragma once

#include <span>
#include <vector>

#include "dalembert/math/fixed.hpp"

namespace dalembert::robots {

// The transformation [[A, r], [0, 1]].
struct Pose {
  Mat3<double> A = identity<double>();
  Vec3<double> r{};
};
inline Pose operator*(const Pose& a, const Pose& b) { return {a.A * b.A, a.r + a.A * b.r}; }

struct Link {
  int parent = -1;  // -1: the base; parents come before their children
  bool slides = false;  // along the axis of its joint; otherwise it turns about it
  int axis = 0;  // x, y or z of the frame of its joint
  Pose before;  // from the frame of the parent link to the joint
  Pose behind;  // from the joint, after its motion, to the frame of the link
  double mass = 0;
  Vec3<double> centre{};  // of mass, in the frame of the link
};

// Joints after their motion, in the global frame.
void place_joints(std::span<const Link> links, const Pose& base, const double* q, std::span<Pose> joints);

// Rates of the joints to the velocity and the angular velocity of a point of a link: six rows with a number for each of `joints`.
void find_jacobian(std::span<const Link> links, std::span<const Pose> joints, int link, const Vec3<double>& point,
                   double* jacobian);

// Forces and torques of the weight in all joints.
void find_static_torques(std::span<const Link> links, std::span<const Pose> joints, const Vec3<double>& gravity,
                         double* torques);

// The error of `pose` with respect to `goal`: translation and rotation vector, in the global frame.
Vec<double, 6> pose_error(const Pose& goal, const Pose& pose);

// A search for coordinates of the joints, see reach().
struct Reach {
  Pose base, goal;
  int carrier = -1;  // the link that is to reach the goal,
  Pose local;  // with this frame of it
  std::vector<double> start, compliance, lower, upper;  // a number for each joint
  int most_iterations = 100;
};
// Coordinates for a pose, among several those near the start; or those of the nearest pose. `error` is the norm of pose_error.
std::vector<double> reach(std::span<const Link> links, const Reach& task, std::vector<double> q, double& error);

}  // namespace dalembert::robots
