// The state of a path of equilibria that is followed by its length.
#pragma once

#include <vector>

#include "dalembert/solvers/static.hpp"
#include "steppers/nearest_modes.hpp"

namespace dalembert {

// Vectors are increments of all unknowns as Newton's method has them: spins for Lie-group nodes.
struct StaticSolver::Path {
  PathTangent tangent, next;  // at the start of the step and at its end
  double length_scale = 0;            // length of a step for its size in quasi-time
  double length = 0;                  // of the step
  std::vector<double> moved;          // since the start of the step
  StepCount step = -1;                // to which `tangent` belongs
  double next_length = 0;
  bool begun = false, end_known = false, at_end = false, branched = false, has_next = false;
  double end_time = 0, share = 0;     // the path ends here, after this share of the last step
  NearestModes modes;
  std::vector<NearestModes::Mode> start_modes, end_modes;
};

}  // namespace dalembert
