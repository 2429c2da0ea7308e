// Generated from specs/markers/node_coordinate.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// A marker on a single coordinate of a node
struct MarkerNodeCoordinateParameters {
  NodeIndex nodeNumber;
  int coordinate = -1;
};

struct MarkerNodeCoordinateVisualization {
  bool show = true;
};

struct MarkerNodeCoordinateRecord {
  std::string name;
  MarkerNodeCoordinateParameters parameters;
  MarkerNodeCoordinateVisualization visualization;
};

}  // namespace dalembert
