// Generated from specs/finite_elements/ancf_thin_plate.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// thin plate without shear deformation, on four nodes with position and two slopes
struct ObjectANCFThinPlateParameters {
  std::vector<double> physicsThickness;
  double physicsDensity = 0.0;
  double physicsMassProportionalDamping = 0.0;
  std::vector<Mat<double, 3, 3>> physicsStrainCoefficients;
  std::vector<Mat<double, 3, 3>> physicsCurvatureCoefficients;
  double strainIsRelativeToReference = 1.0;
  Vec<double, 4> slopesScalingX = {-1.0, -1.0, -1.0, -1.0};
  Vec<double, 4> slopesScalingY = {-1.0, -1.0, -1.0, -1.0};
  std::vector<NodeIndex> nodeNumbers = std::vector<NodeIndex>(4);
  int useReducedOrderIntegration = 0;
  double stiffnessProportionalDamping = 0.0;
  double bendingStiffnessProportionalDamping = -1.0;
};

struct ObjectANCFThinPlateVisualization {
  bool show = true;
  Vec<double, 4> color = {-1.0, -1.0, -1.0, -1.0};
};

struct ObjectANCFThinPlateRecord {
  std::string name;
  ObjectANCFThinPlateParameters parameters;
  ObjectANCFThinPlateVisualization visualization;
};

}  // namespace dalembert
