// Generated from specs/sensors/body.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/enums.hpp"
#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// Measures an output variable of a body at a local position
struct SensorBodyParameters {
  ObjectIndex bodyNumber;
  Vec<double, 3> localPosition = {};
  bool writeToFile = true;
  std::string fileName = "";
  OutputVariableType outputVariableType = OutputVariableType::_None;
  bool storeInternal = false;
};

struct SensorBodyVisualization {
  bool show = true;
};

struct SensorBodyRecord {
  std::string name;
  SensorBodyParameters parameters;
  SensorBodyVisualization visualization;
};

}  // namespace dalembert
