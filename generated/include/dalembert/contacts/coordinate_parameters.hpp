// Generated from specs/contacts/coordinate.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// Contact of two coordinates, a one-sided spring and damper
struct ObjectContactCoordinateParameters {
  std::vector<MarkerIndex> markerNumbers = std::vector<MarkerIndex>(2);
  NodeIndex nodeNumber;
  double contactStiffness = 0.0;
  double contactDamping = 0.0;
  double offset = 0.0;
  bool activeConnector = true;
  double contactStiffnessExponent = 1.0;
  double restitutionCoefficient = 1.0;
  double minimumImpactVelocity = 0.0;
  int impactModel = 0;
};

struct ObjectContactCoordinateVisualization {
  bool show = true;
  double drawSize = -1.0;
  Vec<double, 4> color = {-1.0, -1.0, -1.0, -1.0};
};

struct ObjectContactCoordinateRecord {
  std::string name;
  ObjectContactCoordinateParameters parameters;
  ObjectContactCoordinateVisualization visualization;
};

}  // namespace dalembert
