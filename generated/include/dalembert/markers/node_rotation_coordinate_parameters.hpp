// Generated from specs/markers/node_rotation_coordinate.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// A marker on the rotation of a node about one global axis
struct MarkerNodeRotationCoordinateParameters {
  NodeIndex nodeNumber;
  int rotationCoordinate = -1;
};

struct MarkerNodeRotationCoordinateVisualization {
  bool show = true;
};

struct MarkerNodeRotationCoordinateRecord {
  std::string name;
  MarkerNodeRotationCoordinateParameters parameters;
  MarkerNodeRotationCoordinateVisualization visualization;
};

}  // namespace dalembert
