// Generated from specs/connectors/hydraulic_actuator_simple.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// A double-acting hydraulic cylinder between two points, with the build-up of pressure in both chambers
struct ObjectConnectorHydraulicActuatorSimpleParameters {
  std::vector<MarkerIndex> markerNumbers = std::vector<MarkerIndex>(2);
  std::vector<NodeIndex> nodeNumbers;
  double offsetLength = 0.0;
  double strokeLength = 0.0;
  double chamberCrossSection0 = 0.0;
  double chamberCrossSection1 = 0.0;
  double hoseVolume0 = 0.0;
  double hoseVolume1 = 0.0;
  double valveOpening0 = 0.0;
  double valveOpening1 = 0.0;
  double actuatorDamping = 0.0;
  double oilBulkModulus = 0.0;
  double cylinderBulkModulus = 0.0;
  double hoseBulkModulus = 0.0;
  double nominalFlow = 0.0;
  double systemPressure = 0.0;
  double tankPressure = 0.0;
  bool useChamberVolumeChange = false;
  bool activeConnector = true;
};

struct ObjectConnectorHydraulicActuatorSimpleVisualization {
  bool show = true;
  double cylinderRadius = 0.05;
  double rodRadius = 0.03;
  double pistonRadius = 0.04;
  double pistonLength = 0.001;
  double rodMountRadius = 0.0;
  double baseMountRadius = 0.0;
  double baseMountLength = 0.0;
  Vec<double, 4> colorCylinder = {-1.0, -1.0, -1.0, -1.0};
  Vec<double, 4> colorPiston = {0.8, 0.8, 0.8, 1.0};
};

struct ObjectConnectorHydraulicActuatorSimpleRecord {
  std::string name;
  ObjectConnectorHydraulicActuatorSimpleParameters parameters;
  ObjectConnectorHydraulicActuatorSimpleVisualization visualization;
};

}  // namespace dalembert
