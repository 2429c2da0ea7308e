// Generated from specs/nodes/point_slope1.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// node of spatial cable elements: position and axial slope vector
struct NodePointSlope1Parameters {
  Vec<double, 6> referenceCoordinates = {0.0, 0.0, 0.0, 1.0, 0.0, 0.0};
  Vec<double, 6> initialCoordinates = {};
  Vec<double, 6> initialVelocities = {};
};

struct NodePointSlope1Visualization {
  bool show = true;
  double drawSize = -1.0;
  Vec<double, 4> color = {-1.0, -1.0, -1.0, -1.0};
};

struct NodePointSlope1Record {
  std::string name;
  NodePointSlope1Parameters parameters;
  NodePointSlope1Visualization visualization;
};

}  // namespace dalembert
