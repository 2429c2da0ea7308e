// Generated from specs/loads/coordinate.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// A generalized force on a single coordinate
struct LoadCoordinateParameters {
  MarkerIndex markerNumber;
  double load = 0.0;
  UserFunction loadUserFunction;
};

struct LoadCoordinateVisualization {
  bool show = true;
};

struct LoadCoordinateRecord {
  std::string name;
  LoadCoordinateParameters parameters;
  LoadCoordinateVisualization visualization;
};

}  // namespace dalembert
