// Forces of constant direction at points of links: their joint forces, and the derivatives with respect to
// coordinates.
#pragma once

#include "dalembert/trees/inverse_dynamics.hpp"

namespace dalembert {

// All forces F at points r from the origin of a link, and their moments.
struct LinkLoad {
  Vec3<double> force{}, couple{};  // sum of forces, of moments that act besides
  Mat3<double> arms{};             // sum of (r . F) I - F r^T, which is r x (w x F) of a turn w

  void add(const Vec3<double>& r, const Vec3<double>& f, const Vec3<double>& moment) {
    force += f;
    couple += moment;
    add_arms(r, f);
  }
  // Adds the load of a child link, whose origin is at `arm`.
  void add(const LinkLoad& behind, const Vec3<double>& arm) {
    force += behind.force;
    couple += behind.couple;
    for (std::size_t i = 0; i < arms.x.size(); ++i) arms.x[i] += behind.arms.x[i];
    add_arms(arm, behind.force);
  }
  // About the origin. The sum of r x F is that part of `arms` which is not symmetric.
  Vec3<double> moment() const {
    return couple + Vec3<double>{arms(1, 2) - arms(2, 1), arms(2, 0) - arms(0, 2), arms(0, 1) - arms(1, 0)};
  }

 private:
  void add_arms(const Vec3<double>& r, const Vec3<double>& f) {
    const double product = dot(r, f);
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) arms(i, j) -= f[i] * r[j];
      arms(i, i) += product;
    }
  }
};

namespace trees {

inline void sum_to_base(const Tree& tree, std::span<const LinkPlace<double>> places, std::span<LinkLoad> loads) {
  for (std::size_t i = tree.links.size(); i-- > 0;)
    if (const int parent = tree.links[i].parent; parent >= 0)
      loads[static_cast<std::size_t>(parent)].add(loads[i], places[i].arm);
}

// How the forces that two joints feel change, each with the coordinate of the other. The sums are those of the loads on all that moves with a joint.
struct LoadChange {
  double of_behind = 0;  // derivative of joint force k with respect to coordinate j on its path to the base
  double of_before = 0;  // derivative of joint force j with respect to coordinate k
};
// A turn w takes points along: r changes by w x r, and so the moment of F by (w x r) x F = -arms^T w. Seen from joint k, which turns
// with them, it is F that turns back.
inline LoadChange load_change(const Tree& tree, std::span<const LinkPlace<double>> places,
                              std::span<const LinkLoad> sums, int k, int j) {
  const TreeLink &behind = tree.links[static_cast<std::size_t>(k)], &before = tree.links[static_cast<std::size_t>(j)];
  const Vec3<double>&e_k = places[static_cast<std::size_t>(k)].axis, e_j = places[static_cast<std::size_t>(j)].axis;
  const LinkLoad& sum = sums[static_cast<std::size_t>(k)];
  const Vec3<double> answer = behind.slides ? cross(e_k, sum.force)
                                            : -(transposed_times(sum.arms, e_k) + cross(sum.couple, e_k)),
                     moment = behind.slides ? cross(e_k, sum.force) : -transposed_times(sum.arms, e_k);
  return {before.slides ? 0.0 : dot(e_j, answer), before.slides ? 0.0 : dot(e_j, moment)};
}

}  // namespace trees
}  // namespace dalembert
