// What batches of trees can do besides: they know how links move, and accelerations without a mass matrix.
#pragma once

#include "dalembert/system/term.hpp"

namespace dalembert {

// Bodies of many links, each with a frame of its own.
class LinkedBodies {
 public:
  virtual ~LinkedBodies() = default;
  virtual int links(int entry) const = 0;
  // From the base to the farthest joint or centre of mass, if links were stretched.
  virtual double reach(int entry) const = 0;
  virtual Motion<double> link_motion(int entry, int link, const Vec3<double>& local, const Evaluation& evaluation) const = 0;
};

// Terms whose masses need no matrix, as long as no other term has mass at the same coordinates.
class MassSolver {
 public:
  virtual ~MassSolver() = default;
  // Whether each coordinate is that of one entry only.
  virtual bool is_separate() const = 0;
  // Forces become accelerations, at its coordinates. Returns a coordinate that nothing resists, or -1.
  virtual int solve_masses(const Evaluation& evaluation, double* x) const = 0;
};

}  // namespace dalembert
