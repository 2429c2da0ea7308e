// Generated from specs/sensors/load.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// Measures the value of a load
struct SensorLoadParameters {
  LoadIndex loadNumber;
  bool writeToFile = true;
  std::string fileName = "";
  bool storeInternal = false;
};

struct SensorLoadVisualization {
  bool show = true;
};

struct SensorLoadRecord {
  std::string name;
  SensorLoadParameters parameters;
  SensorLoadVisualization visualization;
};

}  // namespace dalembert
