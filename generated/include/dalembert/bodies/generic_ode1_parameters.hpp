// Generated from specs/bodies/generic_ode1.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// system of first order differential equations with a constant matrix, a constant vector and a user function
struct ObjectGenericODE1Parameters {
  std::vector<NodeIndex> nodeNumbers;
  DynamicMatrix<double> systemMatrix;
  std::vector<double> rhsVector;
  UserFunction rhsUserFunction;
  std::vector<int> coordinateIndexPerNode;
  std::vector<double> tempCoordinates;
  std::vector<double> tempCoordinates_t;
};

struct ObjectGenericODE1Visualization {
  bool show = true;
};

struct ObjectGenericODE1Record {
  std::string name;
  ObjectGenericODE1Parameters parameters;
  ObjectGenericODE1Visualization visualization;
};

}  // namespace dalembert
