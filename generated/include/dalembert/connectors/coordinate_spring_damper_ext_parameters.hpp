// Generated from specs/connectors/coordinate_spring_damper_ext.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// A scalar spring and damper between two coordinates, with gear factors, friction and limit stops
struct ObjectConnectorCoordinateSpringDamperExtParameters {
  std::vector<MarkerIndex> markerNumbers = std::vector<MarkerIndex>(2);
  NodeIndex nodeNumber;
  double stiffness = 0.0;
  double damping = 0.0;
  double offset = 0.0;
  double velocityOffset = 0.0;
  double factor0 = 1.0;
  double factor1 = 1.0;
  double fDynamicFriction = 0.0;
  double fStaticFrictionOffset = 0.0;
  double stickingStiffness = 0.0;
  double stickingDamping = 0.0;
  double exponentialDecayStatic = 0.001;
  double fViscousFriction = 0.0;
  double frictionProportionalZone = 0.0;
  double limitStopsUpper = 0.0;
  double limitStopsLower = 0.0;
  double limitStopsStiffness = 0.0;
  double limitStopsDamping = 0.0;
  bool useLimitStops = false;
  bool activeConnector = true;
  UserFunction springForceUserFunction;
};

struct ObjectConnectorCoordinateSpringDamperExtVisualization {
  bool show = true;
  double drawSize = -1.0;
  Vec<double, 4> color = {-1.0, -1.0, -1.0, -1.0};
};

struct ObjectConnectorCoordinateSpringDamperExtRecord {
  std::string name;
  ObjectConnectorCoordinateSpringDamperExtParameters parameters;
  ObjectConnectorCoordinateSpringDamperExtVisualization visualization;
};

}  // namespace dalembert
