// Generated from specs/joints/spherical.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// A ball joint: keeps two points together, or their chosen global components
struct ObjectJointSphericalParameters {
  std::vector<MarkerIndex> markerNumbers = std::vector<MarkerIndex>(2);
  std::vector<int> constrainedAxes = {1, 1, 1};
  bool activeConnector = true;
};

struct ObjectJointSphericalVisualization {
  bool show = true;
  double jointRadius = 0.1;
  Vec<double, 4> color = {-1.0, -1.0, -1.0, -1.0};
};

struct ObjectJointSphericalRecord {
  std::string name;
  ObjectJointSphericalParameters parameters;
  ObjectJointSphericalVisualization visualization;
};

}  // namespace dalembert
