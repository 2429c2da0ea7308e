// Frames between items: the motion of a point, of a rigid frame or of a coordinate. Vectors are in global axes.
//
// If several frames occur, names show the frame, like the symbols of the pages: A_0b turns components in the axes of frame b into global
// ones, f_b is the vector f by its components in b. Letters that stand side by side cancel:
//
//      f_0 = A_0b f_b            f_b = transposed_times(A_0b, f_0)            A_0c = A_0b A_bc
#pragma once

#include <algorithm>

#include "dalembert/math/fixed.hpp"

namespace dalembert {

// Complete motion of a point of a node or a body.
template <class S>
struct Motion {
  Vec3<S> position{}, velocity{}, acceleration{};
  Mat3<S> rotation = identity<S>();  // local to global
  Vec3<S> angular_velocity{}, angular_acceleration{};
};

// The rows of rotation and position, 3 x 4 numbers, which pictures ask for.
template <class S>
Vec<S, 12> pose_numbers(const Vec3<S>& position, const Mat3<S>& rotation) {
  return vector_of<12>([&](int i) { return i % 4 < 3 ? rotation(i / 4, i % 4) : position[i / 4]; });
}
inline void write_pose(const Vec3<double>& position, const Mat3<double>& rotation, double* rows) {
  const Vec<double, 12> numbers = pose_numbers(position, rotation);
  std::ranges::copy(numbers.x, rows);
}

// Frames of markers for connectors, loads and constraints. Their numbers are contiguous: ports copy them in and out,
// and several are gathered at once (batches/groups.hpp).
template <class S>
struct PointFrame {
  Vec3<S> position, velocity;
};
template <class S>
struct RigidFrame {
  Vec3<S> position, velocity;
  Mat3<S> rotation;
  Vec3<S> angular_velocity;

  static constexpr int count = 18;
  static RigidFrame of(const Vec<S, count>& x) {
    return {segment<3>(x, 0), segment<3>(x, 3), matrix_segment<3, 3>(x, 6), segment<3>(x, 15)};
  }
};
template <class S>
struct ScalarFrame {
  S value, rate;
};
// A body as a whole, for loads proportional to its mass: nothing to read.
template <class S>
struct MassFrame {};

// Power conjugates of the frames.
template <class S>
struct Force {
  Vec3<S> force{};
};
template <class S>
struct Wrench {
  Vec3<S> force{}, moment{};
};
template <class S>
struct ScalarForce {
  S force{};
};

// A port is a frame with its conjugate: the type that a connector requests of its markers.
struct PointPort {
  template <class S>
  using Frame = PointFrame<S>;
  template <class S>
  using Force = dalembert::Force<S>;
  static constexpr int values = 6, forces = 3;
};
struct RigidPort {
  template <class S>
  using Frame = RigidFrame<S>;
  template <class S>
  using Force = Wrench<S>;
  static constexpr int values = 18, forces = 6;
};
struct ScalarPort {
  template <class S>
  using Frame = ScalarFrame<S>;
  template <class S>
  using Force = ScalarForce<S>;
  static constexpr int values = 2, forces = 1;
};
// The force is an acceleration: a load per unit mass.
struct MassPort {
  template <class S>
  using Frame = MassFrame<S>;
  template <class S>
  using Force = dalembert::Force<S>;
  static constexpr int values = 0, forces = 3;
};

// The coordinates of an element: totals, rates and accelerations.
template <class S, int N>
struct Coordinates {
  Vec<S, N> q, v, a;
};

// The same point of a rigid frame, `arm` away in global axes.
template <class S>
Motion<S> moved(const Motion<S>& from, const Vec3<S>& arm) {
  Motion<S> r = from;
  const Vec3<S> swing = cross(from.angular_velocity, arm);
  r.position += arm;
  r.velocity += swing;
  r.acceleration += cross(from.angular_acceleration, arm) + cross(from.angular_velocity, swing);
  return r;
}

}  // namespace dalembert
