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

// ---- what follows for nodes -----------------------------------------------------------------------------------------
template <RotatingNode Node>
NodeMotion node_motion(const Coordinates<double, Node::size>& x) {
  return {.position = segment<3>(x.q, 0),
          .velocity = segment<3>(x.v, 0),
          .spin_motion = Node::template spin_motion<double>(x),
          .angular_velocity = Node::template motion<double>(x).angular_velocity};
}
// Of the generalised forces of a load that is held fixed: by the rotation coordinates, in their rows.
template <RotatingNode Node>
Mat<double, Node::size - 3, Node::size - 3> load_tangent(const NodeLoad& load, const Coordinates<double, Node::size>& x,
                                                         const RotationTangent<Node::size - 3>& t, const Weights& w) {
  constexpr int r = Node::size - 3;
  Mat<double, r, r> k = Node::moment_tangent(x, load.own_moment + load.moment_of_forces(t.rotation), load.moment, w);
  for (int j = 0; j < r; ++j) {
    const Vec3<double> turned = load.moment_of_forces(t.turn[j]);
    for (int i = 0; i < r; ++i) k(i, j) += t.spin_map(0, i) * turned[0] + t.spin_map(1, i) * turned[1] + t.spin_map(2, i) * turned[2];
  }
  return k;
}

// ---- what follows for bodies ----------------------------------------------------------------------------------------
// The wrench is held fixed in the maps to coordinates; see load_tangent.
template <SpinBody Body, RotatingNode Node>
Mat<double, Node::size, Node::size> inertia_tangent(const typename Body::Parameters& p, const SpinMotion<double>& motion,
                                                    const RotationTangent<Node::size - 3>& t, const Weights& w) {
  constexpr int n = Node::size, r = n - 3;
  const InertiaTangent b = Body::inertia_tangent(p, motion);
  Mat<double, n, n> k;
  Mat<double, 3, n> moment = {};  // of the moment in own axes
  for (int i = 0; i < 3; ++i) k(i, i) = w.a * b.mass;
  const Mat<double, 3, r> turning = b.moment_by_spin * t.spin_tangent + b.moment_by_spin_rate * t.spin_rate_tangent;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < r; ++j) moment(i, 3 + j) = turning(i, j);
  if (b.eccentric) {
    const Mat<double, 3, r> swing = t.rotation * (b.swing_by_spin * t.spin_tangent + b.swing_by_spin_rate * t.spin_rate_tangent);
    const Mat3<double> by_acceleration = b.moment_by_acceleration * transpose(t.rotation);
    for (int j = 0; j < r; ++j) {
      const Vec3<double> turned = t.turn[j] * b.swing;
      const Vec3<double> lever = b.moment_by_acceleration * transposed_times(t.turn[j], motion.acceleration);
      for (int i = 0; i < 3; ++i) {
        k(i, 3 + j) = turned[i] + swing(i, j);
        moment(i, 3 + j) += lever[i];
      }
    }
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) moment(i, j) = w.a * by_acceleration(i, j);
  }
  for (int i = 0; i < r; ++i)
    for (int j = 0; j < n; ++j)
      k(3 + i, j) = t.spin_map(0, i) * moment(0, j) + t.spin_map(1, i) * moment(1, j) + t.spin_map(2, i) * moment(2, j);
  return k;
}

// ---- what follows for markers at a point, `local` in own axes -------------------------------------------------------
// Rows: position, velocity and, of 18 Values, the rotation row by row and the angular velocity, all in global axes.
// Writes what can differ from zero of a matrix row by row.
template <int Values, RotatingNode Node>
void write_frame_tangent(const RotationTangent<Node::size - 3>& t, const Vec3<double>& local, const Weights& w, double* d) {
  constexpr int n = Node::size;
  const auto put = [&](int row, int j, const Vec3<double>& v) {
    for (int i = 0; i < 3; ++i) d[(row + i) * n + 3 + j] = v[i];
  };
  const Vec3<double> swing = cross(t.spin, local);
  for (int i = 0; i < 3; ++i) {
    d[i * n + i] = w.q;
    d[(3 + i) * n + i] = w.v;
  }
  for (int j = 0; j < n - 3; ++j) {
    put(0, j, t.turn[j] * local);
    put(3, j, t.turn[j] * swing + t.rotation * cross(column(t.spin_tangent, j), local));
    if constexpr (Values == 18) {
      for (int i = 0; i < 9; ++i) d[(6 + i) * n + 3 + j] = t.turn[j].x[i];
      put(15, j, column(t.angular_tangent, j));
    }
  }
}
// Rows: generalised force of forces of size `scale` and, of 6 Forces, of unit moments, in global axes; written likewise.
template <int Forces, RotatingNode Node>
void write_force_map(const RotationTangent<Node::size - 3>& t, const Vec3<double>& local, double scale, double* map) {
  constexpr int n = Node::size;
  for (int i = 0; i < 3; ++i) map[i * n + i] = scale;
  for (int j = 0; j < n - 3; ++j) {
    const Vec3<double> speed = t.rotation * cross(column(t.spin_map, j), local);
    for (int i = 0; i < 3; ++i) {
      map[i * n + 3 + j] = scale * speed[i];
      if constexpr (Forces == 6) map[(3 + i) * n + 3 + j] = t.angular_map(i, j);
    }
  }
}

}  // namespace dalembert
