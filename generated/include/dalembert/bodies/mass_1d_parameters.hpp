// Generated from specs/bodies/mass_1d.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// mass that is guided along a line: one translation along the local x-axis
struct ObjectMass1DParameters {
  double physicsMass = 0.0;
  NodeIndex nodeNumber;
  Vec<double, 3> referencePosition = {};
  Mat<double, 3, 3> referenceRotation = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
};

struct ObjectMass1DVisualization {
  bool show = true;
  Opaque graphicsData;
};

struct ObjectMass1DRecord {
  std::string name;
  ObjectMass1DParameters parameters;
  ObjectMass1DVisualization visualization;
};

}  // namespace dalembert
