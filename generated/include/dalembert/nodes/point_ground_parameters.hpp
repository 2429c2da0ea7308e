// Generated from specs/nodes/point_ground.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// fixed point without coordinates, as the other end of springs and constraints on coordinates or points
struct NodePointGroundParameters {
  Vec<double, 3> referenceCoordinates = {};
};

struct NodePointGroundVisualization {
  bool show = true;
  double drawSize = -1.0;
  Vec<double, 4> color = {-1.0, -1.0, -1.0, -1.0};
};

struct NodePointGroundRecord {
  std::string name;
  NodePointGroundParameters parameters;
  NodePointGroundVisualization visualization;
};

}  // namespace dalembert
