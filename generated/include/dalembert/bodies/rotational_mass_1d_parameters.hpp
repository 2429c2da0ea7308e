// Generated from specs/bodies/rotational_mass_1d.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// rotor about a fixed axis: one rotation about the local z-axis
struct ObjectRotationalMass1DParameters {
  double physicsInertia = 0.0;
  NodeIndex nodeNumber;
  Vec<double, 3> referencePosition = {};
  Mat<double, 3, 3> referenceRotation = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
};

struct ObjectRotationalMass1DVisualization {
  bool show = true;
  Opaque graphicsData;
};

struct ObjectRotationalMass1DRecord {
  std::string name;
  ObjectRotationalMass1DParameters parameters;
  ObjectRotationalMass1DVisualization visualization;
};

}  // namespace dalembert
