// Generated from specs/bodies/mass_point_2d.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// point mass in the global x-y plane on a planar node
struct ObjectMassPoint2DParameters {
  double physicsMass = 0.0;
  NodeIndex nodeNumber;
};

struct ObjectMassPoint2DVisualization {
  bool show = true;
  Opaque graphicsData;
};

struct ObjectMassPoint2DRecord {
  std::string name;
  ObjectMassPoint2DParameters parameters;
  ObjectMassPoint2DVisualization visualization;
};

}  // namespace dalembert
