// Nodes in the plane: two displacements and perhaps an angle about z, with coordinates that are rates of each other. What
// bodies and markers on them need is short in closed form.
#pragma once

#include <cmath>
#include <concepts>

#include "dalembert/frames.hpp"
#include "dalembert/math/fixed.hpp"
#include "dalembert/system/evaluation.hpp"

namespace dalembert {

template <class N>
concept PlanarNode = requires { requires N::planar; } && N::translations == 2 && (N::size == 2 || N::size == 3);

// A body on a planar node, whose residual it differentiates.
template <class B, class N>
concept PlanarBody = PlanarNode<N> && requires(const typename B::Parameters& p, const Coordinates<double, N::size>& x, const Weights& w) {
  { B::planar_tangent(p, x, w) } -> std::same_as<Mat<double, N::size, N::size>>;
};

using Arm = Vec<double, 2>;  // from the node to a point, in global axes

struct PlanarRotation {
  double cosine = 1, sine = 0;

  static PlanarRotation by(double angle) { return {std::cos(angle), std::sin(angle)}; }
  static PlanarRotation of(const RigidFrame<double>& f) { return {f.rotation(0, 0), f.rotation(1, 0)}; }
  Arm arm(const Vec3<double>& local) const {
    return {cosine * local[0] - sine * local[1], sine * local[0] + cosine * local[1]};
  }
};

// ---- a point at the arm, `height` above the plane -------------------------------------------------------------------
template <int N>
PointFrame<double> planar_point(const Coordinates<double, N>& x, const Arm& arm, double height) {
  PointFrame<double> f{{x.q[0] + arm[0], x.q[1] + arm[1], height}, {x.v[0], x.v[1], 0}};
  if constexpr (N == 3) {
    f.velocity[0] -= x.v[2] * arm[1];
    f.velocity[1] += x.v[2] * arm[0];
  }
  return f;
}
template <int N>
RigidFrame<double> planar_frame(const Coordinates<double, N>& x, const PlanarRotation& r, const Arm& arm, double height) {
  const auto [position, velocity] = planar_point(x, arm, height);
  RigidFrame<double> f{position, velocity, {r.cosine, -r.sine, 0, r.sine, r.cosine, 0, 0, 0, 1}, {}};
  if constexpr (N == 3) f.angular_velocity[2] = x.v[2];
  return f;
}
// What can differ from zero of the frame's derivatives, whose rows are those of 6 or 18 Values.
template <int Values, int N>
void write_planar_frame_tangent(const Coordinates<double, N>& x, const PlanarRotation& r, const Arm& arm, const Weights& w, double* d) {
  for (int i = 0; i < 2; ++i) {
    d[i * N + i] = w.q;
    d[(3 + i) * N + i] = w.v;
  }
  if constexpr (N == 3) {
    const auto by_angle = [&](int row) -> double& { return d[row * N + 2]; };
    by_angle(0) = -w.q * arm[1];
    by_angle(1) = w.q * arm[0];
    by_angle(3) = -w.v * arm[1] - w.q * x.v[2] * arm[0];
    by_angle(4) = w.v * arm[0] - w.q * x.v[2] * arm[1];
    if constexpr (Values == 18) {
      by_angle(6) = by_angle(10) = -w.q * r.sine;
      by_angle(9) = w.q * r.cosine;
      by_angle(7) = -w.q * r.cosine;
      by_angle(17) = w.v;
    }
  }
}
// The same of the generalised forces of forces of size `scale` and, of 6 Forces, of unit moments.
template <int Forces, int N>
void write_planar_force_map(const Arm& arm, double scale, double* map) {
  map[0] = map[N + 1] = scale;
  if constexpr (N == 3) {
    map[2] = -scale * arm[1];
    map[N + 2] = scale * arm[0];
    if constexpr (Forces == 6) map[5 * N + 2] = 1;
  }
}

}  // namespace dalembert
