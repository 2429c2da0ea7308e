// Generated from specs/markers/body_cable_2d_shape.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// A marker that divides a planar ANCF cable element into straight segments, for contact with circles
struct MarkerBodyCable2DShapeParameters {
  ObjectIndex bodyNumber;
  int numberOfSegments = 3;
  double verticalOffset = 0.0;
};

struct MarkerBodyCable2DShapeVisualization {
  bool show = true;
};

struct MarkerBodyCable2DShapeRecord {
  std::string name;
  MarkerBodyCable2DShapeParameters parameters;
  MarkerBodyCable2DShapeVisualization visualization;
};

}  // namespace dalembert
