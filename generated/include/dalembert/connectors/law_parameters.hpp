// Generated from specs/connectors/law.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// Force law between two markers with states of its own, given by user functions
struct ObjectConnectorLawParameters {
  std::vector<MarkerIndex> markerNumbers = std::vector<MarkerIndex>(2);
  std::vector<NodeIndex> nodeNumbers;
  int numberOfCoordinates = 3;
  Mat<double, 3, 3> rotationMarker0 = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
  Mat<double, 3, 3> rotationMarker1 = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
  UserFunction forceUserFunction;
  UserFunction stateRateUserFunction;
  UserFunction historyUserFunction;
  bool activeConnector = true;
};

struct ObjectConnectorLawVisualization {
  bool show = true;
  double drawSize = -1.0;
  Vec<double, 4> color = {-1.0, -1.0, -1.0, -1.0};
};

struct ObjectConnectorLawRecord {
  std::string name;
  ObjectConnectorLawParameters parameters;
  ObjectConnectorLawVisualization visualization;
};

}  // namespace dalembert
