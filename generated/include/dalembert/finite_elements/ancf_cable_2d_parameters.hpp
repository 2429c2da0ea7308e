// Generated from specs/finite_elements/ancf_cable_2d.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// planar cable or thin beam without shear deformation for large deformation, on two nodes with position and slope
struct ObjectANCFCable2DParameters {
  double physicsLength = 0.0;
  double physicsMassPerLength = 0.0;
  double physicsBendingStiffness = 0.0;
  double physicsAxialStiffness = 0.0;
  double physicsBendingDamping = 0.0;
  double physicsAxialDamping = 0.0;
  double physicsReferenceAxialStrain = 0.0;
  double physicsReferenceCurvature = 0.0;
  double strainIsRelativeToReference = 0.0;
  std::vector<NodeIndex> nodeNumbers = std::vector<NodeIndex>(2);
  int useReducedOrderIntegration = 0;
  UserFunction axialForceUserFunction;
  UserFunction bendingMomentUserFunction;
};

struct ObjectANCFCable2DVisualization {
  bool show = true;
  double drawHeight = 0.0;
  Vec<double, 4> color = {-1.0, -1.0, -1.0, -1.0};
};

struct ObjectANCFCable2DRecord {
  std::string name;
  ObjectANCFCable2DParameters parameters;
  ObjectANCFCable2DVisualization visualization;
};

}  // namespace dalembert
