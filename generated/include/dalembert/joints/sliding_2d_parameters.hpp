// Generated from specs/joints/sliding_2d.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// A body that slides along a chain of planar ANCF cable elements
struct ObjectJointSliding2DParameters {
  std::vector<MarkerIndex> markerNumbers = std::vector<MarkerIndex>(2);
  std::vector<MarkerIndex> slidingMarkerNumbers;
  std::vector<double> slidingMarkerOffsets;
  NodeIndex nodeNumber;
  bool classicalFormulation = true;
  bool constrainRotation = false;
  double axialForce = 0.0;
  bool activeConnector = true;
};

struct ObjectJointSliding2DVisualization {
  bool show = true;
  double drawSize = -1.0;
  Vec<double, 4> color = {-1.0, -1.0, -1.0, -1.0};
};

struct ObjectJointSliding2DRecord {
  std::string name;
  ObjectJointSliding2DParameters parameters;
  ObjectJointSliding2DVisualization visualization;
};

}  // namespace dalembert
