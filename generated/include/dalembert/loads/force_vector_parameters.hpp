// Generated from specs/loads/force_vector.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// A force vector at a point of a body or at a node
struct LoadForceVectorParameters {
  MarkerIndex markerNumber;
  Vec<double, 3> loadVector = {};
  bool bodyFixed = false;
  UserFunction loadVectorUserFunction;
};

struct LoadForceVectorVisualization {
  bool show = true;
};

struct LoadForceVectorRecord {
  std::string name;
  LoadForceVectorParameters parameters;
  LoadForceVectorVisualization visualization;
};

}  // namespace dalembert
