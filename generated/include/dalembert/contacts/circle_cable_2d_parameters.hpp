// Generated from specs/contacts/circle_cable_2d.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// Contact without friction of a planar cable element with a circle
struct ObjectContactCircleCable2DParameters {
  std::vector<MarkerIndex> markerNumbers = std::vector<MarkerIndex>(2);
  NodeIndex nodeNumber;
  int numberOfContactSegments = 3;
  double contactStiffness = 0.0;
  double contactDamping = 0.0;
  double circleRadius = 0.0;
  double offset = 0.0;
  bool activeConnector = true;
};

struct ObjectContactCircleCable2DVisualization {
  bool show = true;
  bool showContactCircle = true;
  double drawSize = -1.0;
  Vec<double, 4> color = {-1.0, -1.0, -1.0, -1.0};
};

struct ObjectContactCircleCable2DRecord {
  std::string name;
  ObjectContactCircleCable2DParameters parameters;
  ObjectContactCircleCable2DVisualization visualization;
};

}  // namespace dalembert
