// Generated from specs/loads/torque_vector.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// A torque vector on a body or node with orientation
struct LoadTorqueVectorParameters {
  MarkerIndex markerNumber;
  Vec<double, 3> loadVector = {};
  bool bodyFixed = false;
  UserFunction loadVectorUserFunction;
};

struct LoadTorqueVectorVisualization {
  bool show = true;
};

struct LoadTorqueVectorRecord {
  std::string name;
  LoadTorqueVectorParameters parameters;
  LoadTorqueVectorVisualization visualization;
};

}  // namespace dalembert
