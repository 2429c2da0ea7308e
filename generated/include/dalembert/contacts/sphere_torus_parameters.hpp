// Generated from specs/contacts/sphere_torus.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// Contact of a sphere inside the tube of a torus, as of a ball in the groove of a bearing
struct ObjectContactSphereTorusParameters {
  std::vector<MarkerIndex> markerNumbers = std::vector<MarkerIndex>(2);
  NodeIndex nodeNumber;
  double radiusSphere = 0.0;
  double torusMajorRadius = 0.0;
  double torusMinorRadius = 0.0;
  Vec<double, 3> torusAxis = {};
  double dynamicFriction = 0.0;
  double frictionProportionalZone = 0.001;
  double contactStiffness = 0.0;
  double contactDamping = 0.0;
  double contactStiffnessExponent = 1.0;
  double restitutionCoefficient = 1.0;
  double minimumImpactVelocity = 0.0;
  int impactModel = 0;
  bool activeConnector = true;
  bool limitDamping = false;
};

struct ObjectContactSphereTorusVisualization {
  bool show = false;
  Vec<double, 4> color = {0.7, 0.7, 0.7, 1.0};
};

struct ObjectContactSphereTorusRecord {
  std::string name;
  ObjectContactSphereTorusParameters parameters;
  ObjectContactSphereTorusVisualization visualization;
};

}  // namespace dalembert
