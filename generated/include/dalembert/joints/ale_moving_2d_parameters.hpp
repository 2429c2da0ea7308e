// Generated from specs/joints/ale_moving_2d.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// A body attached to an axially moving ANCF cable, whose sliding coordinate is shared by all elements of the cable
struct ObjectJointALEMoving2DParameters {
  std::vector<MarkerIndex> markerNumbers = std::vector<MarkerIndex>(2);
  std::vector<MarkerIndex> slidingMarkerNumbers;
  std::vector<double> slidingMarkerOffsets;
  double slidingOffset = 0.0;
  std::vector<NodeIndex> nodeNumbers = std::vector<NodeIndex>(2);
  bool usePenaltyFormulation = false;
  double penaltyStiffness = 0.0;
  bool activeConnector = true;
};

struct ObjectJointALEMoving2DVisualization {
  bool show = true;
  double drawSize = -1.0;
  Vec<double, 4> color = {-1.0, -1.0, -1.0, -1.0};
};

struct ObjectJointALEMoving2DRecord {
  std::string name;
  ObjectJointALEMoving2DParameters parameters;
  ObjectJointALEMoving2DVisualization visualization;
};

}  // namespace dalembert
