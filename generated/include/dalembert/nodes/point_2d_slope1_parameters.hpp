// Generated from specs/nodes/point_2d_slope1.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// node of planar cable elements: position and axial slope vector in the global x-y plane
struct NodePoint2DSlope1Parameters {
  Vec<double, 4> referenceCoordinates = {0.0, 0.0, 1.0, 0.0};
  Vec<double, 4> initialCoordinates = {};
  Vec<double, 4> initialVelocities = {};
};

struct NodePoint2DSlope1Visualization {
  bool show = true;
  double drawSize = -1.0;
  Vec<double, 4> color = {-1.0, -1.0, -1.0, -1.0};
};

struct NodePoint2DSlope1Record {
  std::string name;
  NodePoint2DSlope1Parameters parameters;
  NodePoint2DSlope1Visualization visualization;
};

}  // namespace dalembert
