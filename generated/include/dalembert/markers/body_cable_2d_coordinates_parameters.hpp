// Generated from specs/markers/body_cable_2d_coordinates.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// A marker on all coordinates of a planar ANCF cable element, for sliding joints
struct MarkerBodyCable2DCoordinatesParameters {
  ObjectIndex bodyNumber;
};

struct MarkerBodyCable2DCoordinatesVisualization {
  bool show = true;
};

struct MarkerBodyCable2DCoordinatesRecord {
  std::string name;
  MarkerBodyCable2DCoordinatesParameters parameters;
  MarkerBodyCable2DCoordinatesVisualization visualization;
};

}  // namespace dalembert
