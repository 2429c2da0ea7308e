// Generated from specs/sensors/kinematic_tree.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/enums.hpp"
#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// Measures an output variable of a link of a kinematic tree at a local position
struct SensorKinematicTreeParameters {
  ObjectIndex objectNumber;
  int linkNumber = -1;
  Vec<double, 3> localPosition = {};
  bool writeToFile = true;
  std::string fileName = "";
  OutputVariableType outputVariableType = OutputVariableType::_None;
  bool storeInternal = false;
};

struct SensorKinematicTreeVisualization {
  bool show = true;
};

struct SensorKinematicTreeRecord {
  std::string name;
  SensorKinematicTreeParameters parameters;
  SensorKinematicTreeVisualization visualization;
};

}  // namespace dalembert
