// Accelerations from joint forces without a mass matrix, in a number of operations that grows with the number of links: the articulated body method
// (Featherstone 2008, chapter 7), as a factorization of the mass matrix that solves for any forces.
#pragma once

#include "dalembert/trees/inverse_dynamics.hpp"

namespace dalembert {

// How a link with all behind it, whose joints give way, answers an acceleration a of its origin and a spin rate b:
// force M a + H^T b, moment H a + J b.
template <class S>
struct ArticulatedBody {
  Mat3<S> translation, coupling, rotation;  // M, H, J
  LinkWrench<S> along;                      // the answer to a unit acceleration of the joint
  S inverse{};                              // one by what of that works along the joint
};

namespace trees {

// The cross product of v with each column.
template <class S>
Mat3<S> crossed(const Vec3<S>& v, const Mat3<S>& m) {
  return {m(2, 0) * v[1] - m(1, 0) * v[2], m(2, 1) * v[1] - m(1, 1) * v[2], m(2, 2) * v[1] - m(1, 2) * v[2],
          m(0, 0) * v[2] - m(2, 0) * v[0], m(0, 1) * v[2] - m(2, 1) * v[0], m(0, 2) * v[2] - m(2, 2) * v[0],
          m(1, 0) * v[0] - m(0, 0) * v[1], m(1, 1) * v[0] - m(0, 1) * v[1], m(1, 2) * v[0] - m(0, 2) * v[1]};
}

template <class S>
void set_free(ArticulatedBody<S>& body, const TreeLink& link, const LinkMass<S>& mass) {
  const S m(link.mass), none(0.0);
  const Vec3<S>& h = mass.moment;
  body.translation = {m, none, none, none, m, none, none, none, m};
  body.coupling = {none, -h[2], h[1], h[2], none, -h[0], -h[1], h[0], none};
  body.rotation = mass.inertia;
}

// What remains of it when the joint gives way, about the origin of the parent.
template <class S>
void add_to_parent(ArticulatedBody<S>& parent, const ArticulatedBody<S>& body, const Vec3<S>& arm) {
  const Vec3<S>&f = body.along.force, &n = body.along.moment, scaled_f = body.inverse * f, scaled_n = body.inverse * n;
  Mat3<S> m, h, j, half;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) {
      m(row, column) = body.translation(row, column) - f[row] * scaled_f[column];
      h(row, column) = body.coupling(row, column) - n[row] * scaled_f[column];
      j(row, column) = body.rotation(row, column) - n[row] * scaled_n[column];
    }
  const Mat3<S> shift = crossed(arm, m);
  for (std::size_t i = 0; i < 9; ++i) {
    half.x[i] = h.x[i] + 0.5 * shift.x[i];
    parent.translation.x[i] += m.x[i];
    parent.coupling.x[i] += h.x[i] + shift.x[i];
  }
  const Mat3<S> turned = crossed(arm, transpose(half));
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) parent.rotation(row, column) += j(row, column) + (turned(row, column) + turned(column, row));
}

template <class S>
bool is_positive(const S& x) {
  if constexpr (holds_packs<S>) {
    for (int lane = 0; lane < S::count; ++lane)
      if (!(x[lane] > 0)) return false;
    return true;
  } else {
    return value_of(x) > 0;
  }
}

// Returns the first joint from the leaves on that nothing resists, or -1.
template <class S>
int factorize(const Tree& tree, std::span<const LinkPlace<S>> places, std::span<const LinkMass<S>> masses, std::span<ArticulatedBody<S>> bodies) {
  int loose = -1;
  for (std::size_t i = 0; i < tree.links.size(); ++i) set_free(bodies[i], tree.links[i], masses[i]);
  for (std::size_t i = tree.links.size(); i-- > 0;) {
    const TreeLink& link = tree.links[i];
    ArticulatedBody<S>& body = bodies[i];
    const Vec3<S>& e = places[i].axis;
    if (link.slides) body.along = {body.translation * e, body.coupling * e};
    else body.along = {transposed_times(body.coupling, e), body.rotation * e};
    const S resistance = along_joint(link, e, body.along);
    if (loose < 0 && !is_positive(resistance)) loose = static_cast<int>(i);
    body.inverse = 1.0 / resistance;
    if (link.parent >= 0) add_to_parent(bodies[static_cast<std::size_t>(link.parent)], body, places[i].arm);
  }
  return loose;
}

// Forces of the joints become accelerations; `wrenches` is room, one per link.
template <class S>
void solve(const Tree& tree, std::span<const LinkPlace<S>> places, std::span<const ArticulatedBody<S>> bodies, std::span<LinkWrench<S>> wrenches,
           S* x) {
  for (LinkWrench<S>& w : wrenches) w = {};
  for (std::size_t i = tree.links.size(); i-- > 0;) {
    const TreeLink& link = tree.links[i];
    LinkWrench<S>& w = wrenches[i];
    x[i] = (x[i] - along_joint(link, places[i].axis, w)) * bodies[i].inverse;
    if (link.parent < 0) continue;
    w.force += x[i] * bodies[i].along.force;
    w.moment += x[i] * bodies[i].along.moment;
    wrenches[static_cast<std::size_t>(link.parent)] += shifted(w, places[i].arm);
  }
  // From here on: acceleration of the origin, and spin rate.
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    const TreeLink& link = tree.links[i];
    const Vec3<S>&axis = places[i].axis, &arm = places[i].arm;
    LinkWrench<S>& a = wrenches[i];
    a = {};
    if (link.parent >= 0) {
      const LinkWrench<S>& parent = wrenches[static_cast<std::size_t>(link.parent)];
      a = {parent.force + cross(parent.moment, arm), parent.moment};
    }
    x[i] = x[i] - bodies[i].inverse * (dot(bodies[i].along.force, a.force) + dot(bodies[i].along.moment, a.moment));
    (link.slides ? a.force : a.moment) += x[i] * axis;
  }
}

}  // namespace trees
}  // namespace dalembert
