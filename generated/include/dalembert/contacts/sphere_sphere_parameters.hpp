// Generated from specs/contacts/sphere_sphere.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// Contact of two spheres, or of a sphere inside a hollow sphere, with friction, restitution and adhesion
struct ObjectContactSphereSphereParameters {
  std::vector<MarkerIndex> markerNumbers = std::vector<MarkerIndex>(2);
  NodeIndex nodeNumber;
  Vec<double, 2> spheresRadii = {-1.0, -1.0};
  bool isHollowSphere1 = false;
  double dynamicFriction = 0.0;
  double frictionProportionalZone = 0.001;
  double contactStiffness = 0.0;
  double contactDamping = 0.0;
  double contactStiffnessExponent = 1.0;
  double constantPullOffForce = 0.0;
  double contactPlasticityRatio = 0.0;
  double adhesionCoefficient = 0.0;
  double adhesionExponent = 1.0;
  double restitutionCoefficient = 1.0;
  double minimumImpactVelocity = 0.0;
  int impactModel = 0;
  bool activeConnector = true;
  bool limitDamping = false;
};

struct ObjectContactSphereSphereVisualization {
  bool show = false;
  Vec<double, 4> color = {0.7, 0.7, 0.7, 1.0};
};

struct ObjectContactSphereSphereRecord {
  std::string name;
  ObjectContactSphereSphereParameters parameters;
  ObjectContactSphereSphereVisualization visualization;
};

}  // namespace dalembert
