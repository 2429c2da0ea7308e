// Generated from specs/bodies/mass_point.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// point mass in space on a node with position
struct ObjectMassPointParameters {
  double physicsMass = 0.0;
  NodeIndex nodeNumber;
};

struct ObjectMassPointVisualization {
  bool show = true;
  Opaque graphicsData;
};

struct ObjectMassPointRecord {
  std::string name;
  ObjectMassPointParameters parameters;
  ObjectMassPointVisualization visualization;
};

}  // namespace dalembert
