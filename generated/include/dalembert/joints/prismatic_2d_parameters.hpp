// Generated from specs/joints/prismatic_2d.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// A prismatic joint of planar bodies: one point moves on a line that is fixed to the other body
struct ObjectJointPrismatic2DParameters {
  std::vector<MarkerIndex> markerNumbers = std::vector<MarkerIndex>(2);
  Vec<double, 3> axisMarker0 = {1.0, 0.0, 0.0};
  Vec<double, 3> normalMarker1 = {0.0, 1.0, 0.0};
  bool constrainRotation = true;
  bool activeConnector = true;
};

struct ObjectJointPrismatic2DVisualization {
  bool show = true;
  double drawSize = -1.0;
  Vec<double, 4> color = {-1.0, -1.0, -1.0, -1.0};
};

struct ObjectJointPrismatic2DRecord {
  std::string name;
  ObjectJointPrismatic2DParameters parameters;
  ObjectJointPrismatic2DVisualization visualization;
};

}  // namespace dalembert
