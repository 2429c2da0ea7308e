// Generated from specs/finite_elements/beam_geometrically_exact.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// spatial geometrically exact beam with shear deformation, on two rigid body nodes
struct ObjectBeamGeometricallyExactParameters {
  std::vector<NodeIndex> nodeNumbers = std::vector<NodeIndex>(2);
  double physicsLength = 0.0;
  BeamSection sectionData;
};

struct ObjectBeamGeometricallyExactVisualization {
  bool show = true;
  Opaque sectionGeometry;
  Vec<double, 4> color = {-1.0, -1.0, -1.0, -1.0};
};

struct ObjectBeamGeometricallyExactRecord {
  std::string name;
  ObjectBeamGeometricallyExactParameters parameters;
  ObjectBeamGeometricallyExactVisualization visualization;
};

}  // namespace dalembert
