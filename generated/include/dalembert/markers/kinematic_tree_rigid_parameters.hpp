// Generated from specs/markers/kinematic_tree_rigid.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// A marker at a point that is fixed to a link of a kinematic tree, with position and orientation
struct MarkerKinematicTreeRigidParameters {
  ObjectIndex objectNumber;
  int linkNumber = -1;
  Vec<double, 3> localPosition = {};
  Mat<double, 3, 3> localRotation = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
};

struct MarkerKinematicTreeRigidVisualization {
  bool show = true;
};

struct MarkerKinematicTreeRigidRecord {
  std::string name;
  MarkerKinematicTreeRigidParameters parameters;
  MarkerKinematicTreeRigidVisualization visualization;
};

}  // namespace dalembert
