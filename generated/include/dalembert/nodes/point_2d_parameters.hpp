// Generated from specs/nodes/point_2d.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// node with the two displacements of a point in the global x-y plane
struct NodePoint2DParameters {
  Vec<double, 2> referenceCoordinates = {};
  Vec<double, 2> initialCoordinates = {};
  Vec<double, 2> initialVelocities = {};
};

struct NodePoint2DVisualization {
  bool show = true;
  double drawSize = -1.0;
  Vec<double, 4> color = {-1.0, -1.0, -1.0, -1.0};
};

struct NodePoint2DRecord {
  std::string name;
  NodePoint2DParameters parameters;
  NodePoint2DVisualization visualization;
};

}  // namespace dalembert
