// Generated from specs/bodies/ground.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// body that does not move: the fixed end of joints, connectors and markers
struct ObjectGroundParameters {
  Vec<double, 3> referencePosition = {};
  Mat<double, 3, 3> referenceRotation = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
};

struct ObjectGroundVisualization {
  bool show = true;
  Opaque graphicsDataUserFunction;
  Opaque graphicsData;
};

struct ObjectGroundRecord {
  std::string name;
  ObjectGroundParameters parameters;
  ObjectGroundVisualization visualization;
};

}  // namespace dalembert
