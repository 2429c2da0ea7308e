// Generated from specs/sensors/user_function.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// Computes its values by a Python function, for instance from other sensors
struct SensorUserFunctionParameters {
  std::vector<SensorIndex> sensorNumbers;
  std::vector<double> factors;
  bool writeToFile = true;
  std::string fileName = "";
  UserFunction sensorUserFunction;
  bool storeInternal = false;
};

struct SensorUserFunctionVisualization {
  bool show = true;
};

struct SensorUserFunctionRecord {
  std::string name;
  SensorUserFunctionParameters parameters;
  SensorUserFunctionVisualization visualization;
};

}  // namespace dalembert
