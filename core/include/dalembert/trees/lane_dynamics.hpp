// Accelerations of many states of one tree, several side by side: articulated bodies (trees/articulated_bodies.hpp),
// or for few links the mass matrix of joints (trees/joint_masses.hpp). Eight states per entry make lists larger than
// the first-level cache even for few links. Quantities that are passed from link to link therefore stay in registers,
// only quantities for a later sweep are stored, and symmetric matrices have six entries. Second moments, the sums of
// m r r^T, replace inertias: they need fewer products to be shifted and to give the moments of inertia forces.
#pragma once

#include "dalembert/math/aligned_vector.hpp"
#include "dalembert/math/symmetric.hpp"
#include "dalembert/trees/inverse_dynamics.hpp"

namespace dalembert {

// Up to as many, the mass matrix is faster: fewer than for single states (few_links), which wait for quotients.
constexpr int few_links_in_lanes = 10;

// A link in a frame whose first axis is that of its joint.
struct LaneLink {
  int parent = -1;
  std::size_t depth = 0;  // how many links there are before it
  bool slides = false;
  bool follows = false;  // its parent is the link before
  bool forks = false;  // it has children besides the next link
  Vec3<double> axis{}, second{}, third{};  // axes of this frame in that of the parent, at coordinate zero
  Vec3<double> offset{};
  double mass = 0, mass_behind = 0;  // of the single link, and including its children
  Vec3<double> moment{};
  Symmetric<double> second_moment{};
};
std::vector<LaneLink> lane_links(const Tree& tree);

// Quantities of a link that are stored in the outward and inward sweeps.
template <class S>
struct LaneStation {
  Vec3<S> axis, arm, moment;
  Symmetric<S> second_moment;
  LinkWrench<S> wrench;  // that moves it as it would move without accelerations of joints
  LinkWrench<S> along;   // the answer of all behind the joint to its unit acceleration
  S inverse;  // reciprocal of the inertia along the joint
};

// Quantities that are passed from link to link, and stored at branches only.
template <class S>
struct LaneMotion {
  std::array<Vec3<S>, 3> axes;  // axes of its frame
  Vec3<S> spin{}, spin_rate{}, acceleration{};
  Mat3<S> field{};  // matrix that gives, times r, the acceleration at r minus that of the origin
};
// Links that move as one.
template <class S>
struct LaneMass {
  Vec3<S> moment{};
  Symmetric<S> second_moment{};
  LinkWrench<S> wrench{};
};
template <class S>
struct LaneBody {
  Symmetric<S> translation{};
  Mat3<S> coupling{};
  Symmetric<S> rotation{};
  LinkWrench<S> wrench{};
};
template <class S>
struct LaneFork {
  LaneMotion<S> motion;
  LaneBody<S> body;  // articulated body of all links behind
  LaneMass<S> mass;  // composite body of all links behind
  LinkWrench<S> answer;  // acceleration of the origin and spin rate, as forces and moments
};

namespace trees {

template <class S>
DALEMBERT_INLINE inline Vec3<S> combined(const std::array<Vec3<S>, 3>& axes, const Vec3<double>& v) {
  return v[0] * axes[0] + v[1] * axes[1] + v[2] * axes[2];
}
// sum + a x b, without a product of its own.
template <class S>
DALEMBERT_INLINE inline Vec3<S> plus_cross(const Vec3<S>& sum, const Vec3<S>& a, const Vec3<S>& b) {
  return {sum[0] + a[1] * b[2] - a[2] * b[1], sum[1] + a[2] * b[0] - a[0] * b[2], sum[2] + a[0] * b[1] - a[1] * b[0]};
}
template <class S>
DALEMBERT_INLINE inline Vec3<S> row(const Mat3<S>& m, int i) {
  return {m(i, 0), m(i, 1), m(i, 2)};
}

template <class S>
DALEMBERT_INLINE inline Symmetric<S> inertia_of(const Symmetric<S>& m) {
  return {m(1, 1) + m(2, 2), -m(0, 1), -m(0, 2), m(0, 0) + m(2, 2), -m(1, 2), m(0, 0) + m(1, 1)};
}
// Accelerations about a fixed point: centripetal ones of the spin, and those of its rate.
template <class S>
DALEMBERT_INLINE inline Mat3<S> field_of(const Vec3<S>& spin, const Vec3<S>& rate) {
  const S xx = spin[0] * spin[0], yy = spin[1] * spin[1], zz = spin[2] * spin[2], xy = spin[0] * spin[1],
          xz = spin[0] * spin[2], yz = spin[1] * spin[2];
  return {-(yy + zz),   xy - rate[2], xz + rate[1], xy + rate[2], -(xx + zz),
          yz - rate[0], xz - rate[1], yz + rate[0], -(xx + yy)};
}
// sum + m v, without a product of its own.
template <class S>
DALEMBERT_INLINE inline Vec3<S> plus_product(const Vec3<S>& sum, const Mat3<S>& m, const Vec3<S>& v) {
  return vector_of<3>([&](int i) { return sum[i] + m(i, 0) * v[0] + m(i, 1) * v[1] + m(i, 2) * v[2]; });
}
// The sum of m r x (field r), added.
template <class S>
DALEMBERT_INLINE inline Vec3<S> plus_moment(const Vec3<S>& sum, const Mat3<S>& field, const Symmetric<S>& m) {
  const auto of = [&](int i, int j, S s) {
    for (int k = 0; k < 3; ++k) s = s + field(i, k) * m(k, j) - field(j, k) * m(k, i);
    return s;
  };
  return {of(2, 1, sum[0]), of(0, 2, sum[1]), of(1, 0, sum[2])};
}
template <class S>
DALEMBERT_INLINE inline LaneBody<S> with_link(const LaneBody<S>& behind, const LaneLink& link,
                                              const LaneStation<S>& at) {
  LaneBody<S> body = behind;
  for (int i = 0; i < 3; ++i) body.translation(i, i) = body.translation(i, i) + link.mass;
  const Vec3<S>& m = at.moment;
  body.coupling(1, 0) += m[2];
  body.coupling(0, 1) -= m[2];
  body.coupling(0, 2) += m[1];
  body.coupling(2, 0) -= m[1];
  body.coupling(2, 1) += m[0];
  body.coupling(1, 2) -= m[0];
  body.rotation += inertia_of(at.second_moment);
  body.wrench += at.wrench;
  return body;
}
template <class S>
DALEMBERT_INLINE inline void add_body(LaneBody<S>& to, const LaneBody<S>& body) {
  to.translation += body.translation;
  for (std::size_t i = 0; i < 9; ++i) to.coupling.x[i] += body.coupling.x[i];
  to.rotation += body.rotation;
  to.wrench += body.wrench;
}

// Its joint gives way, with `share` for an acceleration; then about the origin of the parent.
template <class S>
DALEMBERT_INLINE inline void give_way(LaneBody<S>& body, const LaneStation<S>& at, const S& share) {
  const Vec3<S>&f = at.along.force, &n = at.along.moment, scaled_f = at.inverse * f, scaled_n = at.inverse * n,
        &arm = at.arm;
  body.wrench += {share * f, share * n};
  body.wrench.moment = plus_cross(body.wrench.moment, arm, body.wrench.force);
  subtract_product(body.translation, f, scaled_f);
  subtract_product(body.rotation, n, scaled_n);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) body.coupling(i, j) = body.coupling(i, j) - n[i] * scaled_f[j];
  Mat3<S> shifted;
  for (int j = 0; j < 3; ++j)
    set_column(shifted, j, plus_cross(column(body.coupling, j), arm, column(body.translation, j)));
  const auto entry = [&](int i, int j) {
    const int a = (i + 1) % 3, b = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
    return body.rotation(i, j) + arm[a] * shifted(j, b) - arm[b] * shifted(j, a) + arm[c] * body.coupling(i, d) -
           arm[d] * body.coupling(i, c);
  };
  body.rotation = {entry(0, 0), entry(0, 1), entry(0, 2), entry(1, 1), entry(1, 2), entry(2, 2)};
  body.coupling = shifted;
}

// Sines and cosines, velocities, and positions and accelerations of links without joint accelerations.
template <class S>
DALEMBERT_INLINE inline void go_outward(std::span<const LaneLink> links, const S* q, const S* sines, const S* cosines,
                                        const S* v, const Vec3<S>& base, std::span<LaneStation<S>> stations,
                                        std::span<LaneFork<S>> forks) {
  const LaneMotion<S> rest{{Vec3<S>{1.0, 0.0, 0.0}, Vec3<S>{0.0, 1.0, 0.0}, Vec3<S>{0.0, 0.0, 1.0}}, {}, {}, base, {}};
  LaneMotion<S> own = rest;
  for (std::size_t i = 0; i < links.size(); ++i) {
    const LaneLink& link = links[i];
    LaneStation<S>& at = stations[i];
    if (!link.follows) own = link.parent < 0 ? rest : forks[static_cast<std::size_t>(link.parent)].motion;
    // The order keeps few numbers in registers.
    const Vec3<S> axis = at.axis = combined(own.axes, link.axis);
    Vec3<S> arm = combined(own.axes, link.offset);
    if (link.slides) arm += q[i] * axis;
    at.arm = arm;
    own.acceleration = plus_product(own.acceleration, own.field, arm);
    const Vec3<S> turning = v[i] * cross(own.spin, axis), y = combined(own.axes, link.second),
                  z = combined(own.axes, link.third);
    if (link.slides) {
      own.axes = {axis, y, z};
      own.acceleration += 2.0 * turning;
    } else {
      own.axes = {axis, cosines[i] * y + sines[i] * z, cosines[i] * z - sines[i] * y};
      own.spin += v[i] * axis;
      own.spin_rate += turning;
    }
    at.second_moment = turned(own.axes, link.second_moment);
    const Vec3<S> moment = at.moment = combined(own.axes, link.moment);
    own.field = field_of(own.spin, own.spin_rate);
    at.wrench.force = plus_product(link.mass * own.acceleration, own.field, moment);
    at.wrench.moment = plus_moment(cross(moment, own.acceleration), own.field, at.second_moment);
    if (link.forks) forks[i] = {own, {}, {}, {}};
  }
}

// Forces of joints, in x, become shares of accelerations.
template <class S>
DALEMBERT_INLINE inline void go_inward(std::span<const LaneLink> links, S* x, std::span<LaneStation<S>> stations,
                                       std::span<LaneFork<S>> forks) {
  LaneBody<S> body{};  // behind the link
  for (std::size_t i = links.size(); i-- > 0;) {
    const LaneLink& link = links[i];
    LaneStation<S>& at = stations[i];
    const Vec3<S> e = at.axis;
    if (link.forks) add_body(body, forks[i].body);
    body = with_link(body, link, at);
    if (link.slides)
      at.along = {body.translation * e, body.coupling * e};
    else
      at.along = {transposed_times(body.coupling, e), body.rotation * e};
    at.inverse = 1.0 / dot(e, link.slides ? at.along.force : at.along.moment);
    const S share = x[i] = (x[i] - dot(e, link.slides ? body.wrench.force : body.wrench.moment)) * at.inverse;
    if (link.parent >= 0) give_way(body, at, share);
    if (link.follows) continue;
    if (link.parent >= 0) add_body(forks[static_cast<std::size_t>(link.parent)].body, body);
    body = {};
  }
}

// ---- few links -------------------------------------------------------------------------------------------------------

template <class S>
DALEMBERT_INLINE inline void add_mass(LaneMass<S>& to, const Vec3<S>& moment, const Symmetric<S>& second_moment,
                                      const LinkWrench<S>& wrench) {
  to.moment += moment;
  to.second_moment += second_moment;
  to.wrench += wrench;
}
// About a point from which `arm` leads to where it was.
template <class S>
DALEMBERT_INLINE inline void shift(LaneMass<S>& body, double mass, const Vec3<S>& arm) {
  const Vec3<S> before = body.moment;
  body.moment += mass * arm;
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j)
      body.second_moment(i, j) = body.second_moment(i, j) + arm[i] * body.moment[j] + before[i] * arm[j];
  body.wrench.moment = plus_cross(body.wrench.moment, arm, body.wrench.force);
}

// Forces of joints, in x, lose those of inertia without accelerations; entry d of row i answers accelerations of that
// joint on the way from the base to joint i which has d before it.
template <class S>
DALEMBERT_INLINE inline void compose(std::span<const LaneLink> links, std::span<const LaneStation<S>> stations,
                                     std::span<LaneFork<S>> forks, S* x, S* rows) {
  const std::size_t width = links.size();
  LaneMass<S> body{};
  for (std::size_t i = links.size(); i-- > 0;) {
    const LaneLink& link = links[i];
    const LaneStation<S>& at = stations[i];
    const Vec3<S> e = at.axis;
    if (link.forks) add_mass(body, forks[i].mass.moment, forks[i].mass.second_moment, forks[i].mass.wrench);
    add_mass(body, at.moment, at.second_moment, at.wrench);
    x[i] -= dot(e, link.slides ? body.wrench.force : body.wrench.moment);
    const Vec3<S> f = link.slides ? link.mass_behind * e : cross(e, body.moment);
    Vec3<S> n = link.slides ? cross(body.moment, e) : inertia_of(body.second_moment) * e;
    S* entry = rows + i * width + link.depth;
    *entry = dot(e, link.slides ? f : n);
    std::size_t behind = i;
    for (int j = link.parent; j >= 0; j = links[behind].parent) {
      n = plus_cross(n, stations[behind].arm, f);
      behind = static_cast<std::size_t>(j);
      *--entry = dot(stations[behind].axis, links[behind].slides ? f : n);
    }
    if (link.parent >= 0) shift(body, link.mass_behind, at.arm);
    if (link.follows) continue;
    if (link.parent >= 0) {
      LaneMass<S>& to = forks[static_cast<std::size_t>(link.parent)].mass;
      add_mass(to, body.moment, body.second_moment, body.wrench);
    }
    body = {};
  }
}

// Forces become accelerations: factors L^T D L of the rows, from the leaves on, which keep the zeros between branches.
template <class S>
DALEMBERT_INLINE inline void eliminate(std::span<const LaneLink> links, std::span<LaneStation<S>> stations, S* x,
                                       S* rows) {
  const std::size_t width = links.size();
  for (std::size_t k = width; k-- > 0;) {
    std::size_t depth = links[k].depth;
    S* row = rows + k * width;
    const S inverse = stations[k].inverse = 1.0 / row[depth], force = x[k];
    x[k] = force * inverse;
    for (int i = links[k].parent; i >= 0; i = links[static_cast<std::size_t>(i)].parent) {
      const auto at = static_cast<std::size_t>(i);
      S* other = rows + at * width;
      const S share = row[--depth] * inverse;
      x[at] -= share * force;
      for (std::size_t d = 0; d <= depth; ++d) other[d] -= share * row[d];
      row[depth] = share;  // only entries nearer to the base are still to be used
    }
  }
  for (std::size_t k = 0; k < width; ++k) {
    const S* share = rows + k * width + links[k].depth;
    S own = x[k];
    for (int i = links[k].parent; i >= 0; i = links[static_cast<std::size_t>(i)].parent) own -= *--share * x[i];
    x[k] = own;
  }
}

// ---- many links ------------------------------------------------------------------------------------------------------

// Shares become accelerations.
template <class S>
DALEMBERT_INLINE inline void go_outward_again(std::span<const LaneLink> links, S* x,
                                              std::span<const LaneStation<S>> stations, std::span<LaneFork<S>> forks) {
  LinkWrench<S> a{};
  for (std::size_t i = 0; i < links.size(); ++i) {
    const LaneLink& link = links[i];
    const LaneStation<S>& at = stations[i];
    if (!link.follows) a = link.parent < 0 ? LinkWrench<S>{} : forks[static_cast<std::size_t>(link.parent)].answer;
    a.force = plus_cross(a.force, a.moment, at.arm);
    const S own = x[i] = x[i] - at.inverse * (dot(at.along.force, a.force) + dot(at.along.moment, a.moment));
    (link.slides ? a.force : a.moment) += own * at.axis;
    if (link.forks) forks[i].answer = a;
  }
}

// The first joint from the leaves on that nothing resists in some state, or -1.
template <int N>
int loose_joint(std::span<const LaneStation<Pack<N>>> stations) {
  for (std::size_t i = stations.size(); i-- > 0;)
    for (int lane = 0; lane < N; ++lane)
      if (const double inverse = stations[i].inverse[lane]; !(inverse > 0 && std::isfinite(inverse)))
        return static_cast<int>(i);
  return -1;
}

}  // namespace trees
}  // namespace dalembert
