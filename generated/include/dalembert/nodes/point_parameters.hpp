// Generated from specs/nodes/point.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// node with the three displacements of a point in space
struct NodePointParameters {
  Vec<double, 3> referenceCoordinates = {};
  Vec<double, 3> initialCoordinates = {};
  Vec<double, 3> initialVelocities = {};
};

struct NodePointVisualization {
  bool show = true;
  double drawSize = -1.0;
  Vec<double, 4> color = {-1.0, -1.0, -1.0, -1.0};
};

struct NodePointRecord {
  std::string name;
  NodePointParameters parameters;
  NodePointVisualization visualization;
};

}  // namespace dalembert
