// Generated from specs/markers/super_element_rigid.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// A marker with the weighted mean position and rotation of mesh nodes of a super element
struct MarkerSuperElementRigidParameters {
  ObjectIndex bodyNumber;
  Vec<double, 3> offset = {};
  std::vector<int> meshNodeNumbers;
  std::vector<double> weightingFactors;
  bool useAlternativeApproach = true;
  int rotationsExponentialMap = 2;
  Mat<double, 3, 3> localRotation = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
};

struct MarkerSuperElementRigidVisualization {
  bool show = true;
  bool showMarkerNodes = true;
};

struct MarkerSuperElementRigidRecord {
  std::string name;
  MarkerSuperElementRigidParameters parameters;
  MarkerSuperElementRigidVisualization visualization;
};

}  // namespace dalembert
