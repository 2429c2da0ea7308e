// Generated from specs/contacts/sphere_triangle.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// Contact of a sphere with a triangle, its face and chosen edges
struct ObjectContactSphereTriangleParameters {
  std::vector<MarkerIndex> markerNumbers = std::vector<MarkerIndex>(2);
  NodeIndex nodeNumber;
  double radiusSphere = 0.0;
  std::vector<Vec<double, 3>> trianglePoints;
  int includeEdges = 7;
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

struct ObjectContactSphereTriangleVisualization {
  bool show = false;
  Vec<double, 4> color = {0.7, 0.7, 0.7, 1.0};
};

struct ObjectContactSphereTriangleRecord {
  std::string name;
  ObjectContactSphereTriangleParameters parameters;
  ObjectContactSphereTriangleVisualization visualization;
};

}  // namespace dalembert
