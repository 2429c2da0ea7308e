// Generated from specs/joints/rolling_disc.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// A rigid disc that rolls on a plane without slip, by constraints on the velocity of the contact point
struct ObjectJointRollingDiscParameters {
  std::vector<MarkerIndex> markerNumbers = std::vector<MarkerIndex>(2);
  std::vector<int> constrainedAxes = {1, 1, 1};
  bool activeConnector = true;
  double discRadius = 0.0;
  Vec<double, 3> discAxis = {1.0, 0.0, 0.0};
  Vec<double, 3> planeNormal = {0.0, 0.0, 1.0};
};

struct ObjectJointRollingDiscVisualization {
  bool show = true;
  double discWidth = 0.1;
  Vec<double, 4> color = {-1.0, -1.0, -1.0, -1.0};
};

struct ObjectJointRollingDiscRecord {
  std::string name;
  ObjectJointRollingDiscParameters parameters;
  ObjectJointRollingDiscVisualization visualization;
};

}  // namespace dalembert
