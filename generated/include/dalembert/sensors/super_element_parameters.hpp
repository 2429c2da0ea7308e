// Generated from specs/sensors/super_element.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/enums.hpp"
#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// Measures an output variable at a mesh node of a super element
struct SensorSuperElementParameters {
  ObjectIndex bodyNumber;
  int meshNodeNumber = -1;
  bool writeToFile = true;
  std::string fileName = "";
  OutputVariableType outputVariableType = OutputVariableType::_None;
  bool storeInternal = false;
};

struct SensorSuperElementVisualization {
  bool show = true;
};

struct SensorSuperElementRecord {
  std::string name;
  SensorSuperElementParameters parameters;
  SensorSuperElementVisualization visualization;
};

}  // namespace dalembert
