// Generated from specs/markers/node_position.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// A marker at the position of a node
struct MarkerNodePositionParameters {
  NodeIndex nodeNumber;
};

struct MarkerNodePositionVisualization {
  bool show = true;
};

struct MarkerNodePositionRecord {
  std::string name;
  MarkerNodePositionParameters parameters;
  MarkerNodePositionVisualization visualization;
};

}  // namespace dalembert
