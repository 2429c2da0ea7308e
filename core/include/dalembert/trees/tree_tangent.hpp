// Mass matrix and derivatives of the joint forces of a tree, entry by entry: composite bodies, one for each link with
// all links behind it (Featherstone 2008, chapter 6), and closed-form derivatives as in J. Carpentier, N. Mansard,
// Analytical Derivatives of Rigid Body Dynamics Algorithms, Robotics: Science and Systems, 2018; here for
// accelerations of points. Increments of a coordinate and its rates rotate and shift everything behind the joint as
// one body, which alone changes no joint force there. The remainder is a field of accelerations, a + b x r, and
// rotations w, which add 2 w x (velocity). Two quantities of the composite body give their forces: its momentum and
// the sum of 2 r x (w x velocity) m.
#pragma once

#include "dalembert/system/evaluation.hpp"
#include "dalembert/trees/inverse_dynamics.hpp"

namespace dalembert {

// A link with all behind it, about the origin of the link.
template <class S>
struct CompositeMass {
  S mass{};
  Vec3<S> moment{};  // mass times position
  Mat3<S> inertia{};

  CompositeMass& operator+=(const CompositeMass& m) {
    mass = mass + m.mass;
    moment += m.moment;
    inertia = inertia + m.inertia;
    return *this;
  }
};
template <class S>
struct CompositeBody : CompositeMass<S> {
  Vec3<S> momentum{};
  Mat3<S> momentum_arms{};  // sum of 2 m ((r . v) I - v r^T): times w, the sum of 2 m r x (w x v)
};

// Effect of an increment of a coordinate behind its joint, besides the motion as one body.
template <class S>
struct JointIncrement {
  Vec3<S> acceleration{}, spin_rate{}, spin{};
};

namespace trees {

template <class S>
CompositeMass<S> single_mass(const TreeLink& link, const LinkMass<S>& mass) {
  return {S(link.mass), mass.moment, mass.inertia};
}
template <class S>
void add_momentum(CompositeBody<S>& body, const LinkMotion<S>& motion) {
  const Vec3<S>& w = motion.spin;
  body.momentum = body.mass * motion.velocity + cross(w, body.moment);
  // The sum of m v r^T: for the velocity of the origin, and for the spin w x r, by the sum of m r r^T.
  const S half = 0.5 * (body.inertia(0, 0) + body.inertia(1, 1) + body.inertia(2, 2));
  Mat3<S> v_r;
  for (int j = 0; j < 3; ++j) {
    Vec3<S> square{-body.inertia(0, j), -body.inertia(1, j), -body.inertia(2, j)};
    square[j] += half;
    const Vec3<S> column = body.moment[j] * motion.velocity + cross(w, square);
    for (int i = 0; i < 3; ++i) v_r(i, j) = column[i];
  }
  const S trace = v_r(0, 0) + v_r(1, 1) + v_r(2, 2);
  body.momentum_arms =
      matrix_of<3, 3>([&](int i, int j) { return i == j ? 2.0 * (trace - v_r(i, j)) : -2.0 * v_r(i, j); });
}

// About a point from which `arm` leads to where it was.
template <class S>
CompositeMass<S> shifted(const CompositeMass<S>& b, const Vec3<S>& arm) {
  const Vec3<S> moment = b.moment + b.mass * arm;
  const Mat3<S> shift =
      without_product(without_product(diagonal(dot(b.moment + moment, arm)), b.moment, arm), arm, moment);
  return {b.mass, moment, b.inertia + shift};
}
template <class S>
void add_momentum(CompositeBody<S>& to, const CompositeBody<S>& b, const Vec3<S>& arm) {
  const Mat3<S> shifted = projection(b.momentum, arm);
  to.momentum += b.momentum;
  for (std::size_t i = 0; i < 9; ++i) to.momentum_arms.x[i] += b.momentum_arms.x[i] + 2.0 * shifted.x[i];
}

// Force that gives the body a unit acceleration of its joint.
template <class S>
LinkWrench<S> inertia_along(const TreeLink& link, const Vec3<S>& axis, const CompositeMass<S>& body) {
  if (link.slides) return {body.mass * axis, cross(body.moment, axis)};
  return {cross(axis, body.moment), body.inertia * axis};
}

template <class S, class Bodies>
void compose(const Tree& tree, std::span<const LinkPlace<S>> places, std::span<const LinkMass<S>> masses,
             Bodies& bodies) {
  for (std::size_t i = 0; i < tree.links.size(); ++i)
    static_cast<CompositeMass<S>&>(bodies[i]) = single_mass(tree.links[i], masses[i]);
  CompositeMass<S> behind{};  // body of the next link, as in sum_to_base
  for (std::size_t i = tree.links.size(); i-- > 0;) {
    const int parent = tree.links[i].parent;
    bodies[i] += behind;
    behind = shifted<S>(bodies[i], places[i].arm);
    if (parent + 1 == static_cast<int>(i)) continue;
    if (parent >= 0) bodies[static_cast<std::size_t>(parent)] += behind;
    behind = {};
  }
}
template <class S>
void compose(const Tree& tree, std::span<const LinkPlace<S>> places, std::span<const LinkMass<S>> masses,
             std::span<const LinkMotion<S>> motions, std::span<CompositeBody<S>> bodies) {
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    static_cast<CompositeMass<S>&>(bodies[i]) = single_mass(tree.links[i], masses[i]);
    add_momentum(bodies[i], motions[i]);
  }
  for (std::size_t i = tree.links.size(); i-- > 0;)
    if (const int parent = tree.links[i].parent; parent >= 0) {
      CompositeBody<S>& to = bodies[static_cast<std::size_t>(parent)];
      to += shifted<S>(bodies[i], places[i].arm);
      add_momentum(to, bodies[i], places[i].arm);
    }
}

// Calls f(k, j) for joint k, then for each joint j before it, up to the base.
template <class F>
void each_pair(const Tree& tree, const F& f) {
  for (int k = 0; k < tree.count(); ++k)
    for (int j = k; j >= 0; j = tree.links[static_cast<std::size_t>(j)].parent) f(k, j);
}

// f(k, j, M_kj) for each pair.
template <class S, class F>
void mass_matrix(const Tree& tree, std::span<const LinkPlace<S>> places, std::span<const CompositeBody<S>> bodies,
                 const F& f) {
  LinkWrench<S> w;
  int at = -1;
  each_pair(tree, [&](int k, int j) {
    const auto behind = static_cast<std::size_t>(k), before = static_cast<std::size_t>(j);
    w = j == k ? inertia_along(tree.links[behind], places[behind].axis, bodies[behind])
               : shifted(w, places[static_cast<std::size_t>(at)].arm);
    at = j;
    f(k, j, along_joint(tree.links[before], places[before].axis, w));
  });
}

template <class S>
JointIncrement<S> increment_of(const TreeLink& link, const Vec3<S>& e, const LinkMotion<S>& m, const Weights& w) {
  const Vec3<S>& spin = m.spin;
  const Vec3<S> turning = cross(spin, e);  // rate of the axis
  if (link.slides)
    return {w.q * (cross(m.spin_rate, e) + cross(spin, turning)) + 2.0 * w.v * turning + w.a * e, {}, {}};
  const Vec3<S> added = w.v * e + w.q * turning;
  return {w.q * cross(m.acceleration, e) - 2.0 * cross(added, m.velocity),
          w.a * e + w.v * turning + w.q * cross(m.spin_rate, e) + cross(spin, added), added};
}

// The change of the sum of inertia forces behind the joint, about its origin held fixed. `sum` is this sum.
template <class S>
LinkWrench<S> increment_of_sum(const TreeLink& link, const Vec3<S>& e, const JointIncrement<S>& by,
                               const CompositeBody<S>& body, const LinkWrench<S>& sum, const Weights& w) {
  LinkWrench<S> change{
      body.mass * by.acceleration + cross(by.spin_rate, body.moment) + 2.0 * cross(by.spin, body.momentum),
      body.inertia * by.spin_rate + cross(body.moment, by.acceleration) + body.momentum_arms * by.spin};
  change.moment += w.q * cross(e, link.slides ? sum.force : sum.moment);
  if (!link.slides) change.force += w.q * cross(e, sum.force);
  return change;
}

// f(k, j, change of force k along j, change of force j along k) for each pair; `sums` are inertia forces, summed to the base.
template <class S, class F>
void tangent(const Tree& tree, std::span<const LinkPlace<S>> places, std::span<const CompositeBody<S>> bodies,
             std::span<const LinkWrench<S>> sums, std::span<const JointIncrement<S>> increments, const Weights& weights,
             const F& f) {
  LinkWrench<S> row, column;  // force of joint k for accelerations in front of it, and effect of its increment there
  Vec3<S> row_spin;
  int at = -1;
  each_pair(tree, [&](int k, int j) {
    const auto behind = static_cast<std::size_t>(k), before = static_cast<std::size_t>(j);
    if (j == k) {
      const TreeLink& link = tree.links[behind];
      const Vec3<S>& e = places[behind].axis;
      const CompositeBody<S>& body = bodies[behind];
      row = inertia_along(link, e, body);
      row_spin = link.slides ? 2.0 * cross(body.momentum, e) : transposed_times(body.momentum_arms, e);
      column = increment_of_sum(link, e, increments[behind], body, sums[behind], weights);
    } else {
      row = shifted(row, places[static_cast<std::size_t>(at)].arm);
      column = shifted(column, places[static_cast<std::size_t>(at)].arm);
    }
    at = j;
    const JointIncrement<S>& by = increments[before];
    f(k, j, dot(row.force, by.acceleration) + dot(row.moment, by.spin_rate) + dot(row_spin, by.spin),
      along_joint(tree.links[before], places[before].axis, column));
  });
}

}  // namespace trees
}  // namespace dalembert
