// Generated from specs/sensors/node.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/enums.hpp"
#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// Measures an output variable of a node
struct SensorNodeParameters {
  NodeIndex nodeNumber;
  bool writeToFile = true;
  std::string fileName = "";
  OutputVariableType outputVariableType = OutputVariableType::_None;
  bool storeInternal = false;
};

struct SensorNodeVisualization {
  bool show = true;
};

struct SensorNodeRecord {
  std::string name;
  SensorNodeParameters parameters;
  SensorNodeVisualization visualization;
};

}  // namespace dalembert
