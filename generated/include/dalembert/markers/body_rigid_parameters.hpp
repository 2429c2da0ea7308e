// Generated from specs/markers/body_rigid.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// A marker at a point that is fixed to a body, with its position and orientation
struct MarkerBodyRigidParameters {
  ObjectIndex bodyNumber;
  Vec<double, 3> localPosition = {};
  Mat<double, 3, 3> localRotation = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
};

struct MarkerBodyRigidVisualization {
  bool show = true;
};

struct MarkerBodyRigidRecord {
  std::string name;
  MarkerBodyRigidParameters parameters;
  MarkerBodyRigidVisualization visualization;
};

}  // namespace dalembert
