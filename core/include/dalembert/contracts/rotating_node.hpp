// Nodes with three displacements and rotation coordinates: bodies and markers on them see the spin, the angular velocity in
// the node's own axes. A node that states its rotation's derivatives spares them the sweep of dual numbers.
//
// d(rotation) need not be skew times rotation: Euler parameters may have drifted from unit length, and stay exact here.
#pragma once

#include <array>
#include <concepts>
#include <type_traits>

#include "dalembert/frames.hpp"
#include "dalembert/math/fixed.hpp"
#include "dalembert/system/evaluation.hpp"

namespace dalembert {

// Motion of a node for inertia forces. The acceleration is in global axes, spin and its rate are in body axes.
template <class S>
struct SpinMotion {
  Vec3<S> acceleration;
  Mat3<S> rotation;
  Vec3<S> spin, spin_rate;
};
// Force in global axes, moment in the node's own.
template <class S>
struct SpinWrench {
  Vec3<S> force, moment;
};

// Shared record of a node for its bodies and markers: they read its rotation and add their forces. Records are
// numbers in this order, so that several are gathered at once (batches/groups.hpp).
template <class S>
struct NodeMotionOf {
  Vec3<S> spin, spin_rate;  // in body axes
  Mat3<S> rotation;
  Vec3<S> angular_velocity;

  Vec<S, 18> numbers() const { return joined(spin, spin_rate, rotation, angular_velocity); }
};
using NodeMotion = NodeMotionOf<double>;

// The sums of moments in own axes, and of forces and moments in global axes.
template <class S>
struct NodeLoadOf {
  Vec3<S> own_moment, force, moment;
  S beside{};  // nonzero if some forces act away from the node

  static constexpr int count = 10;
  static NodeLoadOf of(const Vec<S, count>& x) { return {segment<3>(x, 0), segment<3>(x, 3), segment<3>(x, 6), x[9]}; }
  void add_at_node(const Vec3<S>& f, const Vec3<S>& m) {
    force += f;
    moment += m;
  }
};
using NodeLoad = NodeLoadOf<double>;

// Sum of point force^T over forces away from the node, points in body axes. It is neither read nor reset without such
// forces.
template <class S>
struct PointForcesOf {
  Mat3<S> sum;

  static constexpr int count = 9;
  static PointForcesOf of(const Vec<S, count>& x) { return {{x.x}}; }
  // Moment of the forces, in own axes of this rotation; linear in it.
  Vec3<S> moment(const Mat3<S>& rotation) const {
    const Mat3<S> turned = sum * rotation;
    return {turned(1, 2) - turned(2, 1), turned(2, 0) - turned(0, 2), turned(0, 1) - turned(1, 0)};
  }
};
using PointForces = PointForcesOf<double>;

// Derivatives by R rotation coordinates. Maps are per rate, tangents along the weights.
template <int R>
struct RotationTangent {
  Mat3<double> rotation{};
  std::array<Mat3<double>, R> turn{};  // derivatives of the rotation, along the weight of q
  Vec3<double> spin{};
  Mat<double, 3, R> spin_map{}, angular_map{};  // rates to spin, rates to angular velocity in global axes
  Mat<double, 3, R> spin_tangent{}, spin_rate_tangent{}, angular_tangent{};
};

// Several nodes are computed at once (batches/groups.hpp).
template <class N>
concept NodeInPacks = requires { requires N::traits.in_packs; };

template <class N>
concept RotatingNode = requires(const Coordinates<double, N::size>& x, const Vec3<double>& m, const Weights& w) {
  { N::template motion<double>(x) } -> std::same_as<Motion<double>>;
  { N::template spin_motion<double>(x) } -> std::same_as<SpinMotion<double>>;
  // pull-back of a moment in body axes
  { N::template pull_back_spin<double>(x, m) } -> std::same_as<Vec<double, N::size - 3>>;
  { N::rotation_tangent(x, w) } -> std::same_as<RotationTangent<N::size - 3>>;
  // derivative of the pull-back of a fixed moment in body axes and a fixed one in global axes
  { N::moment_tangent(x, m, m, w) } -> std::same_as<Mat<double, N::size - 3, N::size - 3>>;
};

// Derivatives of a body's inertia forces: force = mass acceleration + rotation swing, and the moment in own axes.
struct InertiaTangent {
  double mass = 0;
  bool eccentric = false;  // else there is no swing, and the moment does not depend on the acceleration
  Vec3<double> swing{};
  Mat3<double> swing_by_spin{}, swing_by_spin_rate{};
  Mat3<double> moment_by_spin{}, moment_by_spin_rate{}, moment_by_acceleration{};  // the acceleration in own axes
};

// Rigid body: inertia tensor about the node, [Jxx, Jyy, Jzz, Jyz, Jxz, Jxy], and center of mass, in body axes.
template <class T>
struct MassProperties {
  T mass;
  Vec<T, 6> tensor;
  Vec3<T> centre;

  bool eccentric() const { return !is_zero(dot(centre, centre)); }
  // The same inertia about all axes.
  bool round() const
    requires std::same_as<T, double>
  {
    return !eccentric() && tensor[0] == tensor[1] && tensor[1] == tensor[2] && is_zero(segment<3>(tensor, 3));
  }
  static constexpr int count = 10;
  static MassProperties of(const Vec<T, count>& x) { return {x[0], segment<6>(x, 1), segment<3>(x, 7)}; }
};

template <class B>
concept RotatingBody =
    requires(const typename B::Parameters& p, const MassProperties<double>& b, const SpinMotion<double>& m) {
      { B::mass_properties(p) } -> std::same_as<MassProperties<double>>;
      { B::inertia(b, m) } -> std::same_as<SpinWrench<double>>;  // also for lane-parallel numbers
      { B::inertia_tangent(b, m) } -> std::same_as<InertiaTangent>;
      { B::centre(p) } -> std::convertible_to<const Vec3<double>&>;
      { B::mass(p) } -> std::convertible_to<double>;
    };

}  // namespace dalembert
