// Generated from specs/contacts/friction_circle_cable_2d.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// Contact with friction of a planar cable element with a circle, such as of a belt on a pulley
struct ObjectContactFrictionCircleCable2DParameters {
  std::vector<MarkerIndex> markerNumbers = std::vector<MarkerIndex>(2);
  NodeIndex nodeNumber;
  int numberOfContactSegments = 3;
  double contactStiffness = 0.0;
  double contactDamping = 0.0;
  double frictionVelocityPenalty = 0.0;
  double frictionStiffness = 0.0;
  double frictionCoefficient = 0.0;
  double circleRadius = 0.0;
  bool useSegmentNormals = true;
  bool activeConnector = true;
  bool limitDamping = false;
};

struct ObjectContactFrictionCircleCable2DVisualization {
  bool show = true;
  bool showContactCircle = true;
  double drawSize = -1.0;
  Vec<double, 4> color = {-1.0, -1.0, -1.0, -1.0};
};

struct ObjectContactFrictionCircleCable2DRecord {
  std::string name;
  ObjectContactFrictionCircleCable2DParameters parameters;
  ObjectContactFrictionCircleCable2DVisualization visualization;
};

}  // namespace dalembert
