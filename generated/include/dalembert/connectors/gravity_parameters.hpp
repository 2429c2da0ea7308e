// Generated from specs/connectors/gravity.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// Newtonian gravitation between two masses, for celestial bodies and satellites; the weight on earth is LoadMassProportional
struct ObjectConnectorGravityParameters {
  std::vector<MarkerIndex> markerNumbers = std::vector<MarkerIndex>(2);
  double gravitationalConstant = 6.6743e-11;
  double mass0 = 0.0;
  double mass1 = 0.0;
  double minDistanceRegularization = 0.0;
  bool activeConnector = true;
};

struct ObjectConnectorGravityVisualization {
  bool show = false;
  double drawSize = -1.0;
  Vec<double, 4> color = {-1.0, -1.0, -1.0, -1.0};
};

struct ObjectConnectorGravityRecord {
  std::string name;
  ObjectConnectorGravityParameters parameters;
  ObjectConnectorGravityVisualization visualization;
};

}  // namespace dalembert
