// Generated from specs/contacts/convex_roll.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// Contact of a convex roll, a body of revolution with a polynomial profile, with the ground plane
struct ObjectContactConvexRollParameters {
  std::vector<MarkerIndex> markerNumbers = std::vector<MarkerIndex>(2);
  NodeIndex nodeNumber;
  double contactStiffness = 0.0;
  double contactDamping = 0.0;
  double dynamicFriction = 0.0;
  double staticFrictionOffset = 0.0;
  double viscousFriction = 0.0;
  double exponentialDecayStatic = 0.001;
  double frictionProportionalZone = 0.001;
  double rollLength = 0.0;
  std::vector<double> coefficientsHull;
  std::vector<double> coefficientsHullDerivative;
  std::vector<double> coefficientsHullDDerivative;
  double rBoundingSphere = 0.0;
  Vec<double, 3> pContact = {};
  bool activeConnector = true;
  bool limitDamping = false;
};

struct ObjectContactConvexRollVisualization {
  bool show = true;
  Vec<double, 4> color = {-1.0, -1.0, -1.0, -1.0};
};

struct ObjectContactConvexRollRecord {
  std::string name;
  ObjectContactConvexRollParameters parameters;
  ObjectContactConvexRollVisualization visualization;
};

}  // namespace dalembert
