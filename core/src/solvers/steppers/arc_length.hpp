// The state of an arc-length continuation.
#pragma once

#include <vector>

#include "dalembert/solvers/static.hpp"
#include "steppers/nearest_modes.hpp"

namespace dalembert {

// Vectors are increments of all unknowns of Newton's method; Lie-group nodes have rotation increments.
struct StaticSolver::Path {
  PathTangent tangent, next;  // at the start and at the end of the step
  double length_scale = 0;            // length of a step per quasi-time
  double length = 0;                  // of the step
  std::vector<double> moved;          // increment since the start of the step
  StepCount step = -1;                // the step to which `tangent` belongs
  double next_length = 0;
  bool begun = false, end_known = false, at_end = false, branched = false, has_next = false;
  double end_time = 0, share = 0;     // the path ends here, after this part of the last step
  NearestModes modes;
  std::vector<NearestModes::Mode> start_modes, end_modes;
};

}  // namespace dalembert
