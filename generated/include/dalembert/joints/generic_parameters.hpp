// Generated from specs/joints/generic.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// A joint between two rigid body markers that constrains any choice of three translations and three rotations
struct ObjectJointGenericParameters {
  std::vector<MarkerIndex> markerNumbers = std::vector<MarkerIndex>(2);
  std::vector<int> constrainedAxes = {1, 1, 1, 1, 1, 1};
  Mat<double, 3, 3> rotationMarker0 = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
  Mat<double, 3, 3> rotationMarker1 = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
  bool activeConnector = true;
  Vec<double, 6> offsetUserFunctionParameters = {};
  UserFunction offsetUserFunction;
  UserFunction offsetUserFunction_t;
  bool alternativeConstraints = false;
};

struct ObjectJointGenericVisualization {
  bool show = true;
  double axesRadius = 0.1;
  double axesLength = 0.4;
  Vec<double, 4> color = {-1.0, -1.0, -1.0, -1.0};
};

struct ObjectJointGenericRecord {
  std::string name;
  ObjectJointGenericParameters parameters;
  ObjectJointGenericVisualization visualization;
};

}  // namespace dalembert
