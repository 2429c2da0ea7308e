// Generated from specs/connectors/rolling_disc_penalty.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// A disc that rolls or slides with friction on a plane, with elastic contact instead of constraints
struct ObjectConnectorRollingDiscPenaltyParameters {
  std::vector<MarkerIndex> markerNumbers = std::vector<MarkerIndex>(2);
  NodeIndex nodeNumber;
  double discRadius = 0.0;
  Vec<double, 3> discAxis = {1.0, 0.0, 0.0};
  Vec<double, 3> planeNormal = {0.0, 0.0, 1.0};
  double dryFrictionAngle = 0.0;
  double contactStiffness = 0.0;
  double contactDamping = 0.0;
  Vec<double, 2> dryFriction = {};
  double dryFrictionProportionalZone = 0.0;
  Vec<double, 2> viscousFriction = {};
  double rollingFrictionViscous = 0.0;
  bool useLinearProportionalZone = false;
  bool activeConnector = true;
};

struct ObjectConnectorRollingDiscPenaltyVisualization {
  bool show = true;
  double discWidth = 0.1;
  Vec<double, 4> color = {-1.0, -1.0, -1.0, -1.0};
};

struct ObjectConnectorRollingDiscPenaltyRecord {
  std::string name;
  ObjectConnectorRollingDiscPenaltyParameters parameters;
  ObjectConnectorRollingDiscPenaltyVisualization visualization;
};

}  // namespace dalembert
