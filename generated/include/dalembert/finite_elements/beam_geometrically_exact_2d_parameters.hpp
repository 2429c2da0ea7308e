// Generated from specs/finite_elements/beam_geometrically_exact_2d.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// planar geometrically exact beam with shear deformation, on two or three rigid body nodes
struct ObjectBeamGeometricallyExact2DParameters {
  std::vector<NodeIndex> nodeNumbers;
  double physicsLength = 0.0;
  double physicsMassPerLength = 0.0;
  double physicsCrossSectionInertia = 0.0;
  double physicsBendingStiffness = 0.0;
  double physicsAxialStiffness = 0.0;
  double physicsShearStiffness = 0.0;
  double physicsBendingDamping = 0.0;
  double physicsAxialDamping = 0.0;
  double physicsShearDamping = 0.0;
  double physicsReferenceCurvature = 0.0;
  bool includeReferenceRotations = false;
};

struct ObjectBeamGeometricallyExact2DVisualization {
  bool show = true;
  double drawHeight = 0.0;
  Vec<double, 4> color = {-1.0, -1.0, -1.0, -1.0};
};

struct ObjectBeamGeometricallyExact2DRecord {
  std::string name;
  ObjectBeamGeometricallyExact2DParameters parameters;
  ObjectBeamGeometricallyExact2DVisualization visualization;
};

}  // namespace dalembert
