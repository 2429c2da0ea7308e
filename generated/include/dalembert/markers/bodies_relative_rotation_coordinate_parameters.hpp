// Generated from specs/markers/bodies_relative_rotation_coordinate.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// A coordinate marker on the relative rotation of two bodies about an axis
struct MarkerBodiesRelativeRotationCoordinateParameters {
  std::vector<ObjectIndex> bodyNumbers = std::vector<ObjectIndex>(2);
  NodeIndex nodeNumber;
  Vec<double, 3> localPosition0 = {};
  Vec<double, 3> localPosition1 = {};
  Vec<double, 3> axis0 = {1.0, 0.0, 0.0};
  double offset = 0.0;
};

struct MarkerBodiesRelativeRotationCoordinateVisualization {
  bool show = true;
};

struct MarkerBodiesRelativeRotationCoordinateRecord {
  std::string name;
  MarkerBodiesRelativeRotationCoordinateParameters parameters;
  MarkerBodiesRelativeRotationCoordinateVisualization visualization;
};

}  // namespace dalembert
