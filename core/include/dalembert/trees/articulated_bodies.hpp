// Accelerations from joint forces without a mass matrix, in a number of operations that grows with the number of links: the articulated body method
// (Featherstone 2008, chapter 7), for forces in which those of velocities are contained.
#pragma once

#include "dalembert/trees/inverse_dynamics.hpp"

namespace dalembert {

// How a link with all behind it, whose joints give way, answers an acceleration a of its origin and a spin rate b:
// force M a + H^T b, moment H a + J b.
template <class S>
struct ArticulatedBody {
  Mat3<S> translation, coupling, rotation;  // M, H, J
  LinkWrench<S> along;  // the answer to a unit acceleration of the joint
  S inverse{};  // reciprocal of the inertia along the joint
};

namespace trees {

template <class S>
DALEMBERT_INLINE inline void set_free(ArticulatedBody<S>& body, const TreeLink& link, const LinkMass<S>& mass) {
  body.translation = diagonal(S(link.mass));
  body.coupling = crossed(mass.moment);
  body.rotation = mass.inertia;
}

// Articulated inertia for a free joint, about the origin of the parent.
template <class S>
DALEMBERT_INLINE inline void add_to_parent(ArticulatedBody<S>& parent, const ArticulatedBody<S>& body,
                                           const Vec3<S>& arm) {
  const Vec3<S>&f = body.along.force, &n = body.along.moment, scaled_f = body.inverse * f, scaled_n = body.inverse * n;
  const Mat3<S> m = without_product(body.translation, f, scaled_f), h = without_product(body.coupling, n, scaled_f),
                j = without_product(body.rotation, n, scaled_n), shift = crossed(arm, m),
                turned = crossed(arm, transpose(h + 0.5 * shift));
  parent.translation = parent.translation + m;
  parent.coupling = parent.coupling + (h + shift);
  parent.rotation = parent.rotation + (j + (turned + transpose(turned)));
}

template <class S>
DALEMBERT_INLINE inline bool is_positive(const S& x) {
  if constexpr (holds_packs<S>) {
    for (int lane = 0; lane < S::count; ++lane)
      if (!(x[lane] > 0)) return false;
    return true;
  } else {
    return value_of(number(x)) > 0;
  }
}

// Forces of the joints become accelerations; `bodies` and `wrenches` are room, one per link. Returns the first joint from the leaves on
// that nothing resists, or -1.
template <class S>
DALEMBERT_INLINE inline int accelerate(const Tree& tree, std::span<const LinkPlace<S>> places,
                                       std::span<const LinkMass<S>> masses, std::span<ArticulatedBody<S>> bodies,
                                       std::span<LinkWrench<S>> wrenches, NumberOf<S>* x) {
  int loose = -1;
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    set_free(bodies[i], tree.links[i], masses[i]);
    wrenches[i] = {};
  }
  for (std::size_t i = tree.links.size(); i-- > 0;) {
    const TreeLink& link = tree.links[i];
    ArticulatedBody<S>& body = bodies[i];
    const Vec3<S>&e = places[i].axis, &arm = places[i].arm;
    if (link.slides)
      body.along = {body.translation * e, body.coupling * e};
    else
      body.along = {transposed_times(body.coupling, e), body.rotation * e};
    const S resistance = along_joint(link, e, body.along);
    if (loose < 0 && !is_positive(resistance)) loose = static_cast<int>(i);
    body.inverse = S(1.0) / resistance;
    const S share = (x[i] - along_joint(link, e, wrenches[i])) * body.inverse;
    x[i] = number(share);
    if (link.parent < 0) continue;
    const auto parent = static_cast<std::size_t>(link.parent);
    wrenches[i] += {share * body.along.force, share * body.along.moment};
    wrenches[parent] += shifted(wrenches[i], arm);
    add_to_parent(bodies[parent], body, arm);
  }
  // Acceleration of the origin, and spin rate, in the following sweep.
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    const TreeLink& link = tree.links[i];
    const Vec3<S>&axis = places[i].axis, &arm = places[i].arm;
    LinkWrench<S>& a = wrenches[i];
    a = {};
    if (link.parent >= 0) {
      const LinkWrench<S>& parent = wrenches[static_cast<std::size_t>(link.parent)];
      a = {parent.force + cross(parent.moment, arm), parent.moment};
    }
    const S own =
        x[i] - bodies[i].inverse * (dot(bodies[i].along.force, a.force) + dot(bodies[i].along.moment, a.moment));
    x[i] = number(own);
    (link.slides ? a.force : a.moment) += own * axis;
  }
  return loose;
}

}  // namespace trees
}  // namespace dalembert
