// Generated from specs/markers/node_coordinates.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// A marker on all coordinates of a node, as a vector
struct MarkerNodeCoordinatesParameters {
  NodeIndex nodeNumber;
};

struct MarkerNodeCoordinatesVisualization {
  bool show = true;
};

struct MarkerNodeCoordinatesRecord {
  std::string name;
  MarkerNodeCoordinatesParameters parameters;
  MarkerNodeCoordinatesVisualization visualization;
};

}  // namespace dalembert
