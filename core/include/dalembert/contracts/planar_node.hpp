// Nodes in the plane: two displacements and optionally an angle about z, with rates as velocities. Closed forms for
// their bodies and markers are short.
#pragma once

#include <cmath>
#include <concepts>

#include "dalembert/frames.hpp"
#include "dalembert/math/fixed.hpp"
#include "dalembert/system/evaluation.hpp"

namespace dalembert {

template <class N>
concept PlanarNode =
    requires { requires N::traits.planar; } && N::traits.translations == 2 && (N::size == 2 || N::size == 3);

// A body on a planar node, whose residual it differentiates.
template <class B, class N>
concept PlanarBody = PlanarNode<N> && requires(const typename B::Parameters& p, const Coordinates<double, N::size>& x,
                                               const Weights& w) {
  { B::planar_tangent(p, x, w) } -> std::same_as<Mat<double, N::size, N::size>>;
};

template <class S>
using Arm = Vec<S, 2>;  // from the node to a point, in global axes

template <class S>
struct PlanarRotation {
  S cosine = 1, sine = 0;

  static PlanarRotation by(const S& angle) {
    using std::cos;
    using std::sin;
    return {cos(angle), sin(angle)};
  }
  static PlanarRotation of(const RigidFrame<S>& f) { return {f.rotation(0, 0), f.rotation(1, 0)}; }
  Arm<S> arm(const Vec3<double>& local) const {
    return {cosine * local[0] - sine * local[1], sine * local[0] + cosine * local[1]};
  }
};

// ---- a point at the arm, `height` above the plane -------------------------------------------------------------------
template <class S, int N>
PointFrame<S> planar_point(const Coordinates<S, N>& x, const Arm<S>& arm, double height) {
  PointFrame<S> f{{x.q[0] + arm[0], x.q[1] + arm[1], height}, {x.v[0], x.v[1], 0}};
  if constexpr (N == 3) {
    f.velocity[0] -= x.v[2] * arm[1];
    f.velocity[1] += x.v[2] * arm[0];
  }
  return f;
}
template <class S, int N>
RigidFrame<S> planar_frame(const Coordinates<S, N>& x, const PlanarRotation<S>& r, const Arm<S>& arm, double height) {
  const auto [position, velocity] = planar_point(x, arm, height);
  RigidFrame<S> f{position, velocity, {r.cosine, -r.sine, 0, r.sine, r.cosine, 0, 0, 0, 1}, {}};
  if constexpr (N == 3) f.angular_velocity[2] = x.v[2];
  return f;
}
// Nonzero part of the frame's derivatives, whose rows are those of 6 or 18 Values.
template <int Values, class S, int N>
void write_planar_frame_tangent(const Coordinates<S, N>& x, const PlanarRotation<S>& r, const Arm<S>& arm,
                                const Weights& w, S* d) {
  for (int i = 0; i < 2; ++i) {
    d[i * N + i] = w.q;
    d[(3 + i) * N + i] = w.v;
  }
  if constexpr (N == 3) {
    const auto by_angle = [&](int row) -> S& { return d[row * N + 2]; };
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
template <int Forces, int N, class S>
void write_planar_force_map(const Arm<S>& arm, double scale, S* map) {
  map[0] = map[N + 1] = scale;
  if constexpr (N == 3) {
    map[2] = -scale * arm[1];
    map[N + 2] = scale * arm[0];
    if constexpr (Forces == 6) map[5 * N + 2] = 1;
  }
}

}  // namespace dalembert
