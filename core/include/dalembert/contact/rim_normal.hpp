// The direction of least overlap of a circle and a line, or of two circles: a stationary point of the overlap.
//
// A circle of radius r around an axis n extends along u by r |u - (u.n) n| from its center. Let w point from the second
// feature to the center of the first. The overlap is F(u) = w.u + r |u - (u.n) n| + ..., whose gradient and Hessian on the
// sphere of directions have closed forms. Newton's method computes the direction from a nearby one; derivatives follow from
// one more step with dual numbers.
#pragma once

#include <algorithm>
#include <cmath>

#include "dalembert/math/direction.hpp"

namespace dalembert {

template <class S>
struct Rim {
  Vec3<S> centre, axis;  // unit vectors
  double radius = 0;

  // The farthest point along u, seen from its center: a direction, and the in-plane part of u.
  struct Reach {
    Vec3<S> out;
    S sine;
  };
  Reach reach(const Vec3<S>& u) const {
    const Vec3<S> in_plane = u - dot(u, axis) * axis;
    const S sine = norm(in_plane);
    return {(1.0 / sine) * in_plane, sine};
  }
};

namespace rim_normals {

constexpr int most_steps = 30;
constexpr double longest_step = 0.3, rounding = 1e-15;
// smaller steps are followed by a single one of round-off, which carries derivatives
constexpr double converged = 1e-6;

template <class S>
Vec3<double> value_of_vector(const Vec3<S>& v) {
  return vector_of<3>([&](int i) { return value_of(v[i]); });
}
template <class S>
Rim<double> value_of_rim(const Rim<S>& rim) {
  return {value_of_vector(rim.centre), value_of_vector(rim.axis), rim.radius};
}

// How F grows along `t`, across u, and the part of its curvature there that the circle is the cause of.
template <class S>
S slope(const Rim<S>& rim, const typename Rim<S>::Reach& reach, const Vec3<S>& w, const Vec3<S>& t) {
  return dot(t, w + rim.radius * reach.out);
}
inline double bend(const Rim<double>& rim, const Rim<double>::Reach& reach, const Vec3<double>& s,
                   const Vec3<double>& t) {
  const Vec3<double> side = cross(rim.axis, reach.out);
  return rim.radius * dot(side, s) * dot(side, t) / reach.sine;
}

struct Newton1 {
  double slope, curvature;
};
inline Newton1 across_line(const Rim<double>& rim, const Vec3<double>& w, const Vec3<double>& along,
                           const Vec3<double>& u) {
  const Rim<double>::Reach reach = rim.reach(u);
  const Vec3<double> t = cross(along, u);
  return {slope(rim, reach, w, t), bend(rim, reach, t, t) - dot(w, u) - rim.radius * reach.sine};
}

// Newton's method for two circles, in two directions perpendicular to u.
struct Newton2 {
  Vec3<double> s, t;
  double curvature[3];  // ss, st, tt
  double determinant;
  bool is_least() const { return curvature[0] > 0 && determinant > 0; }
  template <class S>
  Vec3<S> step(const S& gs, const S& gt) const {
    const double k = -1 / determinant;
    const S ds = k * (curvature[2] * gs - curvature[1] * gt), dt = k * (curvature[0] * gt - curvature[1] * gs);
    return vector_of<3>([&](int i) { return ds * s[i] + dt * t[i]; });
  }
};
inline Newton2 between_rims(const Rim<double>& a, const Rim<double>& b, const Vec3<double>& w, const Vec3<double>& u) {
  const Rim<double>::Reach ra = a.reach(u), rb = b.reach(u);
  Newton2 n{direction(cross(a.axis, u)), {}, {}, 0};
  n.t = cross(u, n.s);
  const double level = dot(w, u) + a.radius * ra.sine + b.radius * rb.sine;
  const auto both = [&](const Vec3<double>& x, const Vec3<double>& y) { return bend(a, ra, x, y) + bend(b, rb, x, y); };
  n.curvature[0] = both(n.s, n.s) - level;
  n.curvature[1] = both(n.s, n.t);
  n.curvature[2] = both(n.t, n.t) - level;
  n.determinant = n.curvature[0] * n.curvature[2] - n.curvature[1] * n.curvature[1];
  return n;
}

// Starts from u, evaluated at u.
template <class S>
Vec3<S> step_between(const Newton2& at, const Rim<S>& a, const Rim<S>& b, const Vec3<S>& u) {
  const Vec3<S> pull = a.centre - b.centre + a.radius * a.reach(u).out + b.radius * b.reach(u).out;
  return at.step(dot(at.s, pull), dot(at.t, pull));
}
inline Vec3<double> not_longer(const Vec3<double>& step, double length) {
  return length > longest_step ? (longest_step / length) * step : step;
}

}  // namespace rim_normals

// Direction from the rim to the line and perpendicular to it; `point` is any point of the line. Adding a multiple of
// the line direction has no effect.
template <class S>
Vec3<S> normal_of_rim_and_line(const Rim<S>& rim, const Vec3<S>& point, const Vec3<S>& along,
                               const Vec3<double>& nearby) {
  using namespace rim_normals;
  const Rim<double> now = value_of_rim(rim);
  const Vec3<double> d = value_of_vector(along), w = now.centre - value_of_vector(point);
  Vec3<double> u = direction(nearby - dot(nearby, d) * d);
  double curvature = 0, step = longest_step;
  for (int k = 0; k < most_steps && std::abs(step) > rounding; ++k) {
    const Newton1 at = across_line(now, w, d, u);
    curvature = at.curvature;
    if (!(curvature > 0)) break;
    step = std::clamp(-at.slope / curvature, -longest_step, longest_step);
    u = direction(u + step * cross(d, u));
  }
  const Vec3<S> across = u - dot(u, along) * along, t = cross(along, across);
  if (!(curvature > 0 && std::abs(step) < converged)) return across;
  return across + ((-1 / curvature) * slope(rim, rim.reach(across), rim.centre - point, t)) * t;
}

// Direction from the first to the second.
template <class S>
Vec3<S> normal_of_rims(const Rim<S>& a, const Rim<S>& b, const Vec3<double>& nearby) {
  using namespace rim_normals;
  const Rim<double> now_a = value_of_rim(a), now_b = value_of_rim(b);
  const Vec3<double> w = now_a.centre - now_b.centre;
  Vec3<double> u = direction(nearby);
  double length = longest_step;
  for (int k = 0; k < most_steps && length > rounding; ++k) {
    const Newton2 at = between_rims(now_a, now_b, w, u);
    length = longest_step;
    if (!at.is_least()) break;
    const Vec3<double> step = step_between(at, now_a, now_b, u);
    length = norm(step);
    u = direction(u + not_longer(step, length));
  }
  const Vec3<S> fixed = vector_of<3>([&](int i) { return S(u[i]); });
  if (!(length < converged)) return fixed;
  return fixed + step_between(between_rims(now_a, now_b, w, u), a, b, fixed);
}

}  // namespace dalembert
