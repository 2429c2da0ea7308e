// Generated from specs/loads/mass_proportional.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// A distributed load proportional to mass, such as gravity
struct LoadMassProportionalParameters {
  MarkerIndex markerNumber;
  Vec<double, 3> loadVector = {};
  UserFunction loadVectorUserFunction;
};

struct LoadMassProportionalVisualization {
  bool show = true;
};

struct LoadMassProportionalRecord {
  std::string name;
  LoadMassProportionalParameters parameters;
  LoadMassProportionalVisualization visualization;
};

}  // namespace dalembert
