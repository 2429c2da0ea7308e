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

// What inertia forces see of a node. The acceleration is in global axes, spin and its rate are in the node's own.
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

// What bodies and markers read of the node they are on, and what they leave there, once for all of them.
struct NodeMotion {
  Vec3<double> position{}, velocity{};
  SpinMotion<double> spin_motion{};
  Vec3<double> angular_velocity{};
};
// The sum of forces at points of the node, moments in global axes and moments in its own.
struct NodeLoad {
  Vec3<double> force{}, moment{}, own_moment{};
  Mat3<double> lever{};  // sum of point force^T, points in own axes

  void add(const Vec3<double>& point, const Vec3<double>& f) {
    force += f;
    if (is_zero(point)) return;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) lever(i, j) += point[i] * f[j];
  }
  // Moment of the forces, in own axes of this rotation; linear in it.
  Vec3<double> moment_of_forces(const Mat3<double>& rotation) const {
    const Mat3<double> turned = lever * rotation;
    return {turned(1, 2) - turned(2, 1), turned(2, 0) - turned(0, 2), turned(0, 1) - turned(1, 0)};
  }
};

template <class N>
concept SpinNode = requires(const Coordinates<double, N::size>& x, const Vec3<double>& m) {
  { N::template spin_motion<double>(x) } -> std::same_as<SpinMotion<double>>;
  { N::template pull_back_spin<double>(x, m) } -> std::same_as<Vec<double, N::size - 3>>;  // of a moment in own axes
};

// Derivatives by R rotation coordinates. Maps are per rate, tangents along the weights.
template <int R>
struct RotationTangent {
  Mat3<double> rotation{};
  std::array<Mat3<double>, R> turn{};                    // of the rotation, along the weight of q
  Vec3<double> spin{};
  Mat<double, 3, R> spin_map{}, angular_map{};             // rates to spin, rates to angular velocity in global axes
  Mat<double, 3, R> spin_tangent{}, spin_rate_tangent{}, angular_tangent{};
};

template <class N>
concept RotatingNode =
    SpinNode<N> && requires(const Coordinates<double, N::size>& x, const Vec3<double>& m, const Weights& w) {
      { N::template motion<double>(x) } -> std::same_as<Motion<double>>;
      { N::rotation_tangent(x, w) } -> std::same_as<RotationTangent<N::size - 3>>;
      // of the pull-back of a moment in own axes and one in global axes, held fixed
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

template <class B>
concept SpinBody = requires(const typename B::Parameters& p, const SpinMotion<double>& m) {
  { B::template inertia<double>(p, m) } -> std::same_as<SpinWrench<double>>;
  { B::inertia_tangent(p, m) } -> std::same_as<InertiaTangent>;
  { B::centre(p) } -> std::convertible_to<const Vec3<double>&>;
  { B::mass(p) } -> std::convertible_to<double>;
};

}  // namespace dalembert
