// Generated from specs/markers/node_rigid.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// A marker at a node with position and orientation
struct MarkerNodeRigidParameters {
  NodeIndex nodeNumber;
  Mat<double, 3, 3> localRotation = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
};

struct MarkerNodeRigidVisualization {
  bool show = true;
};

struct MarkerNodeRigidRecord {
  std::string name;
  MarkerNodeRigidParameters parameters;
  MarkerNodeRigidVisualization visualization;
};

}  // namespace dalembert
