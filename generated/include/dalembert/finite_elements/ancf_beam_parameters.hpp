// Generated from specs/finite_elements/ancf_beam.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// spatial beam with shear and cross section deformation, on two nodes with position and two slopes
struct ObjectANCFBeamParameters {
  std::vector<NodeIndex> nodeNumbers = std::vector<NodeIndex>(2);
  double physicsLength = 0.0;
  BeamSection sectionData;
  Vec<double, 3> crossSectionPenaltyFactor = {1.0, 1.0, 1.0};
  Vec<double, 3> crossSectionDamping = {};
};

struct ObjectANCFBeamVisualization {
  bool show = true;
  Opaque sectionGeometry;
  Vec<double, 4> color = {-1.0, -1.0, -1.0, -1.0};
};

struct ObjectANCFBeamRecord {
  std::string name;
  ObjectANCFBeamParameters parameters;
  ObjectANCFBeamVisualization visualization;
};

}  // namespace dalembert
