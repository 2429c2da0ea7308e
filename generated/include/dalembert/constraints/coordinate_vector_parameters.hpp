// Generated from specs/constraints/coordinate_vector.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// Couples the coordinate vectors of two markers by linear and quadratic equations, or by a user function
struct ObjectConnectorCoordinateVectorParameters {
  std::vector<MarkerIndex> markerNumbers = std::vector<MarkerIndex>(2);
  DynamicMatrix<double> scalingMarker0;
  DynamicMatrix<double> scalingMarker1;
  DynamicMatrix<double> quadraticTermMarker0;
  DynamicMatrix<double> quadraticTermMarker1;
  std::vector<double> offset;
  bool velocityLevel = false;
  UserFunction constraintUserFunction;
  UserFunction jacobianUserFunction;
  bool activeConnector = true;
};

struct ObjectConnectorCoordinateVectorVisualization {
  bool show = true;
  Vec<double, 4> color = {-1.0, -1.0, -1.0, -1.0};
};

struct ObjectConnectorCoordinateVectorRecord {
  std::string name;
  ObjectConnectorCoordinateVectorParameters parameters;
  ObjectConnectorCoordinateVectorVisualization visualization;
};

}  // namespace dalembert
