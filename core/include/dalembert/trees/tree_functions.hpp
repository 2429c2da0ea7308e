// Mechanics of one tree as functions of many states, which are computed side by side. States lie one after the other, those of all
// joints together; results likewise.
#pragma once

#include <cstddef>

#include "dalembert/trees/lane_dynamics.hpp"

namespace dalembert {

class TreeFunctions {
 public:
  TreeFunctions(Tree tree, const Vec3<double>& gravity)
      : tree_(std::move(tree)), lanes_(lane_links(tree_)), gravity_(gravity) {}
  const Tree& tree() const { return tree_; }
  const Vec3<double>& gravity() const { return gravity_; }

  // Joint forces for the accelerations; null: zero accelerations, which gives weight and velocity-dependent forces.
  void inverse_dynamics(std::size_t states, const double* q, const double* v, const double* a, double* forces) const;
  // Accelerations; returns a joint that nothing resists, or -1.
  int forward_dynamics(std::size_t states, const double* q, const double* v, const double* forces, double* a) const;
  void mass_matrix(std::size_t states, const double* q, double* matrices) const;
  // Derivatives of the joint forces with respect to coordinates and velocities: row by row.
  void derivatives(std::size_t states, const double* q, const double* v, const double* a, double* by_q,
                   double* by_v) const;
  // Rotation matrix and origin of each link.
  void frames(std::size_t states, const double* q, double* rotations, double* origins) const;
  // Velocity of a point of a link, and angular velocity, by joint velocities: six rows.
  void jacobian(std::size_t states, const double* q, int link, const Vec3<double>& local, double* matrices) const;
  void centre_of_mass(std::size_t states, const double* q, double* points) const;
  // Kinetic and potential, which is zero where the centre of mass is in the global origin; either may be null, then v may be, too.
  void energies(std::size_t states, const double* q, const double* v, double* kinetic, double* potential) const;

 private:
  Tree tree_;
  std::vector<LaneLink> lanes_;
  Vec3<double> gravity_;
};

}  // namespace dalembert
