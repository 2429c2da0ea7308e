// Generated from specs/finite_elements/ale_ancf_cable_2d.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// planar cable through which material moves along the axis, on two nodes with slope and one node with the axial coordinate
struct ObjectALEANCFCable2DParameters {
  double physicsLength = 0.0;
  double physicsMassPerLength = 0.0;
  double physicsMovingMassFactor = 1.0;
  double physicsBendingStiffness = 0.0;
  double physicsAxialStiffness = 0.0;
  double physicsBendingDamping = 0.0;
  double physicsAxialDamping = 0.0;
  double physicsReferenceAxialStrain = 0.0;
  double physicsReferenceCurvature = 0.0;
  bool physicsUseCouplingTerms = true;
  bool physicsAddALEvariation = true;
  std::vector<NodeIndex> nodeNumbers = std::vector<NodeIndex>(3);
  int useReducedOrderIntegration = 0;
  double strainIsRelativeToReference = 0.0;
};

struct ObjectALEANCFCable2DVisualization {
  bool show = true;
  double drawHeight = 0.0;
  Vec<double, 4> color = {-1.0, -1.0, -1.0, -1.0};
};

struct ObjectALEANCFCable2DRecord {
  std::string name;
  ObjectALEANCFCable2DParameters parameters;
  ObjectALEANCFCable2DVisualization visualization;
};

}  // namespace dalembert
