// Generated from specs/markers/object_ode2_coordinates.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// MarkerObjectODE2Coordinates
struct MarkerObjectODE2CoordinatesParameters {
  ObjectIndex objectNumber;
};

struct MarkerObjectODE2CoordinatesVisualization {
  bool show = true;
};

struct MarkerObjectODE2CoordinatesRecord {
  std::string name;
  MarkerObjectODE2CoordinatesParameters parameters;
  MarkerObjectODE2CoordinatesVisualization visualization;
};

}  // namespace dalembert
