// Generated from specs/nodes/point_slope23.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// node of shear and cross-section deformable beam elements: position and the two slope vectors in the cross section
struct NodePointSlope23Parameters {
  Vec<double, 9> referenceCoordinates = {0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0};
  Vec<double, 9> initialCoordinates = {};
  Vec<double, 9> initialVelocities = {};
};

struct NodePointSlope23Visualization {
  bool show = true;
  double drawSize = -1.0;
  Vec<double, 4> color = {-1.0, -1.0, -1.0, -1.0};
};

struct NodePointSlope23Record {
  std::string name;
  NodePointSlope23Parameters parameters;
  NodePointSlope23Visualization visualization;
};

}  // namespace dalembert
