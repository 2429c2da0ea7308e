// Generated from specs/joints/sliding.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// A body that slides along a chain of ANCF cable elements in space
struct ObjectJointSlidingParameters {
  std::vector<MarkerIndex> markerNumbers = std::vector<MarkerIndex>(2);
  std::vector<MarkerIndex> slidingMarkerNumbers;
  std::vector<double> slidingMarkerOffsets;
  NodeIndex nodeNumber;
  std::vector<int> constrainRotations = {1, 1, 1};
  std::vector<int> constrainTranslations = {1, 1, 1};
  double axialForce = 0.0;
  bool activeConnector = true;
};

struct ObjectJointSlidingVisualization {
  bool show = true;
  double drawSize = -1.0;
  Vec<double, 4> color = {-1.0, -1.0, -1.0, -1.0};
};

struct ObjectJointSlidingRecord {
  std::string name;
  ObjectJointSlidingParameters parameters;
  ObjectJointSlidingVisualization visualization;
};

}  // namespace dalembert
