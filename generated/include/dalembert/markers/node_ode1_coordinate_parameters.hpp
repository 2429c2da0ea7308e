// Generated from specs/markers/node_ode1_coordinate.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// A marker on a single coordinate of a node with first order equations
struct MarkerNodeODE1CoordinateParameters {
  NodeIndex nodeNumber;
  int coordinate = -1;
};

struct MarkerNodeODE1CoordinateVisualization {
  bool show = false;
};

struct MarkerNodeODE1CoordinateRecord {
  std::string name;
  MarkerNodeODE1CoordinateParameters parameters;
  MarkerNodeODE1CoordinateVisualization visualization;
};

}  // namespace dalembert
