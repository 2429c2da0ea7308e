// A point of a body that deforms in a frame. Its displacement u and its small rotation theta are linear in the coordinates of
// the body, with constant rows that are prepared once for any number of mesh nodes. The frame F is at p, with rotation A_0F:
//
//      position    p + A_0F (rest + u)           u = translation x,      theta = rotation x
//      rotation    A_0F exp(theta)
//
// A force and a moment on it go back by the same rows. Shabana, Dynamics of Multibody Systems, chapter 5; weighted nodes: as the
// RBE3 elements of NASTRAN.
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "dalembert/contracts/sized_coordinates.hpp"

namespace dalembert {

// The frame of a body that deforms in global axes.
struct NoFrame {
  static constexpr int size = 0;
};

// d(rotation vector)/dt to angular velocity in the turned axes, for the exponential map.
template <class S>
Mat3<S> rotation_vector_tangent(const Vec3<S>& rotation) {
  S sinc, versine, residue;
  const S square = dot(rotation, rotation);
  RodriguesSeries::terms(square, sinc, versine, residue);
  const Mat3<S> k = skew(rotation), kk = k * k;
  Mat3<S> t = identity<S>();
  for (int i = 0; i < 9; ++i) t.x[i] += residue * kk.x[i] - versine * k.x[i];
  return t;
}

// Frame of the body; global axes if there is no frame.
template <class Frame, class S>
Motion<S> frame_motion(const SizedCoordinates<S>& x) {
  if constexpr (Frame::size > 0) return Frame::template motion<S>(x.template of_first<Frame>());
  return {};
}

// Position, velocity and acceleration of a point at y in a moving frame, with relative velocity y_t and acceleration
// y_tt, all in the axes of the frame.
template <class S>
Motion<S> motion_in(const Motion<S>& frame, const Vec3<S>& y, const Vec3<S>& y_t, const Vec3<S>& y_tt) {
  const Vec3<S> rate_0 = frame.rotation * y_t;
  Motion<S> m = moved(frame, frame.rotation * y);
  m.velocity += rate_0;
  m.acceleration += frame.rotation * y_tt + 2.0 * cross(frame.angular_velocity, rate_0);
  return m;
}

struct FramePlace {
  double scale = 1;  // factor of the force on the frame
  Vec3<double> rest{};  // in the frame
  std::vector<double> translation = {}, rotation = {};  // three rows each, of the first coordinates; empty: none
  bool exponential_map = true;  // else rotations are linear
  bool exact_rate = true;  // the angular velocity is that of the exponential map
  bool turns_moments = true;  // moments act through the tangent of the exponential map

  template <class Frame, class S>
  Motion<S> motion(const SizedCoordinates<S>& x) const {
    const Motion<S> frame = frame_motion<Frame>(x);
    Motion<S> m = motion_in(frame, rest + by(translation, x.u), by(translation, x.v), by(translation, x.a));
    if (rotation.empty()) return m;
    const Vec3<S> angle = by(rotation, x.u);
    Vec3<S> turning = by(rotation, x.v);
    if (exact_rate) turning = rotation_vector_tangent(angle) * turning;
    m.rotation = frame.rotation * (exponential_map ? rotation_vector_rotation(angle) : identity<S>() + skew(angle));
    m.angular_velocity += m.rotation * turning;
    return m;
  }

  // Generalized forces of a force and a moment in global axes.
  template <class Frame, class S>
  void pull_back(const SizedCoordinates<S>& x, const Vec3<double>& force, const Vec3<double>& moment,
                 std::span<S> q) const {
    const Mat3<S> A_0F = frame_motion<Frame>(x).rotation;
    for (S& entry : q) entry = S(0);
    add(translation, transposed_times(A_0F, force), q);
    if (!rotation.empty()) {
      Vec3<S> moment_F = transposed_times(A_0F, moment);
      if (turns_moments) moment_F = transposed_times(rotation_vector_tangent(by(rotation, x.u)), moment_F);
      add(rotation, moment_F, q);
    }
    if constexpr (Frame::size > 0) {
      const Vec3<S> arm = A_0F * (rest + by(translation, x.u));
      const auto whole = Frame::template pull_back<S>(x.template of_first<Frame>(), lifted_force<S>(force),
                                                      lifted_force<S>(moment) + cross(arm, force));
      for (int i = 0; i < Frame::size; ++i) q[i] += whole[i];
    }
  }

 private:
  template <class S>
  Vec3<S> lifted_force(const Vec3<double>& f) const {
    return {S(scale * f[0]), S(scale * f[1]), S(scale * f[2])};
  }
  template <class S>
  static Vec3<S> by(const std::vector<double>& rows, const SizedVector<S>& x) {
    return rows.empty() ? Vec3<S>{} : SizedCoordinates<S>::combined(x, rows, 0);
  }
  template <class S>
  static void add(const std::vector<double>& rows, const Vec3<S>& f, std::span<S> q) {
    if (rows.empty()) return;
    const std::size_t n = rows.size() / 3;
    for (std::size_t i = 0; i < n; ++i) q[i] += rows[i] * f[0] + rows[n + i] * f[1] + rows[2 * n + i] * f[2];
  }
};

}  // namespace dalembert
