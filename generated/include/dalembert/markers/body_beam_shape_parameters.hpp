// Generated from specs/markers/body_beam_shape.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// A marker that gives joints and contacts access to the shape of a beam element
struct MarkerBodyBeamShapeParameters {
  ObjectIndex bodyNumber;
};

struct MarkerBodyBeamShapeVisualization {
  bool show = true;
};

struct MarkerBodyBeamShapeRecord {
  std::string name;
  MarkerBodyBeamShapeParameters parameters;
  MarkerBodyBeamShapeVisualization visualization;
};

}  // namespace dalembert
