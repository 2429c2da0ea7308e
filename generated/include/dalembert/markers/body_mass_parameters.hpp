// Generated from specs/markers/body_mass.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// A marker on the mass of a body, for loads that are proportional to mass such as gravity
struct MarkerBodyMassParameters {
  ObjectIndex bodyNumber;
};

struct MarkerBodyMassVisualization {
  bool show = true;
};

struct MarkerBodyMassRecord {
  std::string name;
  MarkerBodyMassParameters parameters;
  MarkerBodyMassVisualization visualization;
};

}  // namespace dalembert
