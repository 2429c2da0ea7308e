// Generated from specs/contacts/curve_circles.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// Contact of a planar curve with circles, as of a cam with its followers
struct ObjectContactCurveCirclesParameters {
  std::vector<MarkerIndex> markerNumbers = std::vector<MarkerIndex>(2);
  NodeIndex nodeNumber;
  std::vector<double> circlesRadii;
  MatrixContainer segmentsData;
  MatrixContainer polynomialData;
  Mat<double, 3, 3> rotationMarker0 = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
  double dynamicFriction = 0.0;
  double frictionProportionalZone = 0.001;
  double contactStiffness = 0.0;
  double contactDamping = 0.0;
  int contactModel = 0;
  bool activeConnector = true;
  std::vector<double> gapPerSegment;
  std::vector<double> gapPerSegment_t;
  std::vector<double> segmentsForceLocalX;
  std::vector<double> segmentsForceLocalY;
};

struct ObjectContactCurveCirclesVisualization {
  bool show = true;
  Vec<double, 4> color = {-1.0, -1.0, -1.0, -1.0};
};

struct ObjectContactCurveCirclesRecord {
  std::string name;
  ObjectContactCurveCirclesParameters parameters;
  ObjectContactCurveCirclesVisualization visualization;
};

}  // namespace dalembert
