// Joint forces that a motion of a tree needs: inertia forces of the links, summed up from the leaves to the base (recursive
// Newton-Euler method; J. Y. S. Luh, M. W. Walker, R. P. C. Paul, 1980).
#pragma once

#include "dalembert/trees/tree.hpp"

namespace dalembert {

// A force at the origin of a link, and a moment.
template <class S>
struct LinkWrench {
  Vec3<S> force{}, moment{};

  LinkWrench& operator+=(const LinkWrench& w) {
    force += w.force;
    moment += w.moment;
    return *this;
  }
};

namespace trees {

// Wrench about a point; `arm` leads from there to the previous point.
template <class S>
DALEMBERT_INLINE inline LinkWrench<S> shifted(const LinkWrench<S>& w, const Vec3<S>& arm) {
  return {w.force, w.moment + cross(arm, w.force)};
}

// Component of a wrench along the joint.
template <class S>
DALEMBERT_INLINE inline S along_joint(const TreeLink& link, const Vec3<S>& axis, const LinkWrench<S>& w) {
  return dot(axis, link.slides ? w.force : w.moment);
}

// Force that gives the link its motion.
template <class S>
DALEMBERT_INLINE inline LinkWrench<S> inertia_force(const TreeLink& link, const LinkMass<S>& mass,
                                                    const LinkMotion<S>& motion) {
  return {link.mass * motion.acceleration +
              crosses(motion.spin_rate, mass.moment, motion.spin, cross(motion.spin, mass.moment)),
          mass.inertia * motion.spin_rate +
              crosses(mass.moment, motion.acceleration, motion.spin, mass.inertia * motion.spin)};
}

// Each wrench becomes the sum over its link and all behind; f(i, force of joint i).
template <class S, class F>
DALEMBERT_INLINE inline void sum_to_base(const Tree& tree, std::span<const LinkPlace<S>> places,
                                         std::span<LinkWrench<S>> wrenches, const F& f) {
  LinkWrench<S> behind{};  // wrench of the next link, if its parent is this one: sums along chains stay in registers
  for (std::size_t i = tree.links.size(); i-- > 0;) {
    const TreeLink& link = tree.links[i];
    LinkWrench<S> sum = wrenches[i];
    sum += behind;
    wrenches[i] = sum;
    f(i, along_joint(link, places[i].axis, sum));
    behind = shifted(sum, places[i].arm);
    if (link.parent + 1 == static_cast<int>(i)) continue;
    if (link.parent >= 0) wrenches[static_cast<std::size_t>(link.parent)] += behind;
    behind = {};
  }
}

}  // namespace trees
}  // namespace dalembert
