// Additional functions of batches of trees: motion of links, and accelerations without a mass matrix.
#pragma once

#include "dalembert/system/term.hpp"

namespace dalembert {

// Bodies of many links, each with a frame of its own.
class LinkedBodies {
 public:
  virtual ~LinkedBodies() = default;
  virtual int links(int entry) const = 0;
  // Length from the base to the farthest joint or center of mass of the stretched chain of links.
  virtual double reach(int entry) const = 0;
  virtual Motion<double> link_motion(int entry, int link, const Vec3<double>& local,
                                     const Evaluation& evaluation) const = 0;
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
