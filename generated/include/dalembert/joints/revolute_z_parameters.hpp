// Generated from specs/joints/revolute_z.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// A revolute joint between two rigid body markers, free to rotate about the z axis of the joint frame
struct ObjectJointRevoluteZParameters {
  std::vector<MarkerIndex> markerNumbers = std::vector<MarkerIndex>(2);
  Mat<double, 3, 3> rotationMarker0 = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
  Mat<double, 3, 3> rotationMarker1 = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
  bool activeConnector = true;
};

struct ObjectJointRevoluteZVisualization {
  bool show = true;
  double axisRadius = 0.1;
  double axisLength = 0.4;
  Vec<double, 4> color = {-1.0, -1.0, -1.0, -1.0};
};

struct ObjectJointRevoluteZRecord {
  std::string name;
  ObjectJointRevoluteZParameters parameters;
  ObjectJointRevoluteZVisualization visualization;
};

}  // namespace dalembert
