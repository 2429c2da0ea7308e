// Generated from specs/markers/object_ode2_coordinates.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// A marker on all second order coordinates of an object, as a vector
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
