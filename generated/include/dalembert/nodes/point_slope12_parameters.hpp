// Generated from specs/nodes/point_slope12.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// node of thin plate elements: position and the two slope vectors in the plane of the plate
struct NodePointSlope12Parameters {
  Vec<double, 9> referenceCoordinates = {0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0};
  Vec<double, 9> initialCoordinates = {};
  Vec<double, 9> initialVelocities = {};
};

struct NodePointSlope12Visualization {
  bool show = true;
  double drawSize = -1.0;
  Vec<double, 4> color = {-1.0, -1.0, -1.0, -1.0};
};

struct NodePointSlope12Record {
  std::string name;
  NodePointSlope12Parameters parameters;
  NodePointSlope12Visualization visualization;
};

}  // namespace dalembert
