// Generated from specs/sensors/object.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/enums.hpp"
#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// Measures an output variable of a connector, constraint, joint or contact
struct SensorObjectParameters {
  ObjectIndex objectNumber;
  bool writeToFile = true;
  std::string fileName = "";
  OutputVariableType outputVariableType = OutputVariableType::_None;
  bool storeInternal = false;
};

struct SensorObjectVisualization {
  bool show = true;
};

struct SensorObjectRecord {
  std::string name;
  SensorObjectParameters parameters;
  SensorObjectVisualization visualization;
};

}  // namespace dalembert
