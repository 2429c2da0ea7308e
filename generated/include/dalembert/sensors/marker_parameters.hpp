// Generated from specs/sensors/marker.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/enums.hpp"
#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// Measures an output variable of a marker
struct SensorMarkerParameters {
  MarkerIndex markerNumber;
  bool writeToFile = true;
  std::string fileName = "";
  OutputVariableType outputVariableType = OutputVariableType::_None;
  bool storeInternal = false;
};

struct SensorMarkerVisualization {
  bool show = true;
};

struct SensorMarkerRecord {
  std::string name;
  SensorMarkerParameters parameters;
  SensorMarkerVisualization visualization;
};

}  // namespace dalembert
