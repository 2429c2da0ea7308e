// Consequences of a gap equation: its rate along the motion of the frames, and the forces that do its virtual work. A
// kernel whose gap follows a prescribed motion defines `offsets`, `offset(p, c)` and `offset_rate(p, c)`; its gap
// takes the offset as last argument.
#pragma once

#include <array>

#include "dalembert/contracts/context.hpp"
#include "dalembert/frames.hpp"
#include "dalembert/math/rotations.hpp"

namespace dalembert {

template <class K>
concept FollowsOffset = requires {
  { K::offsets } -> std::convertible_to<int>;
};

// Closed forms of a gap.
template <class K>
concept StatesGapRate =
    requires(const typename K::Parameters& p, const Context& c, const typename K::Port::template Frame<double>& m) {
      { K::template gap_rate<double>(p, c, m, m) } -> std::same_as<Vec<double, K::equations>>;
    };
template <class K>
concept StatesReaction =
    requires(const typename K::Parameters& p, const Context& c, const typename K::Port::template Frame<double>& m,
             const Vec<double, K::equations>& lambda) {
      {
        K::template reaction<double>(p, c, m, m, lambda)
      } -> std::same_as<std::array<typename K::Port::template Force<double>, 2>>;
    };

template <class K, class S, class Frame>
auto gap(const typename K::Parameters& p, const Context& c, const Frame& m0, const Frame& m1) {
  if constexpr (FollowsOffset<K>) {
    const Vec<double, K::offsets> offset = K::offset(p, c);
    Vec<S, K::offsets> o;
    for (int i = 0; i < K::offsets; ++i) o[i] = S(offset[i]);
    return K::template gap<S>(p, c, m0, m1, o);
  } else {
    return K::template gap<S>(p, c, m0, m1);
  }
}

// ---- frames that move: a first derivative in direction `i`, of a dual of T over scalars of type S ---------------------
template <class T, class S>
Vec3<T> lifted(const Vec3<S>& v) {
  Vec3<T> r;
  for (int i = 0; i < 3; ++i) r[i].value = v[i];
  return r;
}
template <class T, class S>
Mat3<T> lifted(const Mat3<S>& m) {
  Mat3<T> r;
  for (int i = 0; i < 9; ++i) r.x[i].value = m.x[i];
  return r;
}
// d(rotation) = skew(turn) rotation in direction i.
template <class T, class S>
void turn(Mat3<T>& rotation, const Mat3<S>& at, const Vec3<S>& rate, int i) {
  const Mat3<S> d = skew(rate) * at;
  for (int k = 0; k < 9; ++k) rotation.x[k].d[i] = d.x[k];
}

template <class T, class S>
PointFrame<T> in_motion(const PointFrame<S>& f) {
  PointFrame<T> r{lifted<T>(f.position), lifted<T>(f.velocity)};
  for (int i = 0; i < 3; ++i) r.position[i].d[0] = f.velocity[i];
  return r;
}
template <class T, class S>
RigidFrame<T> in_motion(const RigidFrame<S>& f) {
  RigidFrame<T> r{lifted<T>(f.position), lifted<T>(f.velocity), lifted<T>(f.rotation), lifted<T>(f.angular_velocity)};
  for (int i = 0; i < 3; ++i) r.position[i].d[0] = f.velocity[i];
  turn(r.rotation, f.rotation, f.angular_velocity, 0);
  return r;
}
template <class T, class S>
ScalarFrame<T> in_motion(const ScalarFrame<S>& f) {
  ScalarFrame<T> r;
  r.value.value = f.value;
  r.value.d[0] = f.rate;
  r.rate.value = f.rate;
  return r;
}

// d(gap)/dt, without the accelerations of the frames.
template <class K, class S, class Frame>
Vec<S, K::equations> gap_rate(const typename K::Parameters& p, const Context& c, const Frame& m0, const Frame& m1) {
  if constexpr (StatesGapRate<K>) {
    return K::template gap_rate<S>(p, c, m0, m1);
  } else {
    using T = Dual<1, S>;
    Vec<T, K::equations> g;
    if constexpr (FollowsOffset<K>) {
      const Vec<double, K::offsets> offset = K::offset(p, c), rate = K::offset_rate(p, c);
      Vec<T, K::offsets> o;
      for (int i = 0; i < K::offsets; ++i) o[i].value = S(offset[i]), o[i].d[0] = S(rate[i]);
      g = K::template gap<T>(p, c, in_motion<T>(m0), in_motion<T>(m1), o);
    } else {
      g = K::template gap<T>(p, c, in_motion<T>(m0), in_motion<T>(m1));
    }
    Vec<S, K::equations> r;
    for (int k = 0; k < K::equations; ++k) r[k] = g[k].d[0];
    return r;
  }
}

// Virtual displacements: position 3, rotation 3 (global axes) or the value of a coordinate, from direction `first` on.
template <class T, class S>
PointFrame<T> varied(const PointFrame<S>& f, int first) {
  PointFrame<T> r{lifted<T>(f.position), lifted<T>(f.velocity)};
  for (int i = 0; i < 3; ++i) r.position[i].d[first + i] = S(1);
  return r;
}
template <class T, class S>
RigidFrame<T> varied(const RigidFrame<S>& f, int first) {
  RigidFrame<T> r{lifted<T>(f.position), lifted<T>(f.velocity), lifted<T>(f.rotation), lifted<T>(f.angular_velocity)};
  for (int i = 0; i < 3; ++i) {
    r.position[i].d[first + i] = S(1);
    Vec3<S> axis{};
    axis[i] = S(1);
    turn(r.rotation, f.rotation, axis, first + 3 + i);
  }
  return r;
}
template <class T, class S>
ScalarFrame<T> varied(const ScalarFrame<S>& f, int first) {
  ScalarFrame<T> r;
  r.value.value = f.value;
  r.value.d[first] = S(1);
  r.rate.value = f.rate;
  return r;
}

// Forces G^T lambda on both frames.
template <class K, class S, class Frame, class L>
std::array<typename K::Port::template Force<S>, 2> virtual_work(const typename K::Parameters& p, const Context& c,
                                                                const Frame& m0, const Frame& m1,
                                                                const Vec<L, K::equations>& lambda) {
  constexpr int n = K::Port::forces;
  using T = Dual<2 * n, S>;
  const auto g = gap<K, T>(p, c, varied<T>(m0, 0), varied<T>(m1, n));
  std::array<typename K::Port::template Force<S>, 2> forces{};
  for (int i = 0; i < 2; ++i) {
    S* to = reinterpret_cast<S*>(&forces[i]);
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < K::equations; ++k) to[j] += lambda[k] * g[k].d[i * n + j];
  }
  return forces;
}

}  // namespace dalembert
