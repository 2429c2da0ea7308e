// Generated from specs/connectors/cartesian_spring_damper.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// Three springs and dampers that act between two points in the directions of the global axes
struct ObjectConnectorCartesianSpringDamperParameters {
  std::vector<MarkerIndex> markerNumbers = std::vector<MarkerIndex>(2);
  Vec<double, 3> stiffness = {};
  Vec<double, 3> damping = {};
  Vec<double, 3> offset = {};
  UserFunction springForceUserFunction;
  bool activeConnector = true;
};

struct ObjectConnectorCartesianSpringDamperVisualization {
  bool show = true;
  double drawSize = -1.0;
  Vec<double, 4> color = {-1.0, -1.0, -1.0, -1.0};
};

struct ObjectConnectorCartesianSpringDamperRecord {
  std::string name;
  ObjectConnectorCartesianSpringDamperParameters parameters;
  ObjectConnectorCartesianSpringDamperVisualization visualization;
};

}  // namespace dalembert
