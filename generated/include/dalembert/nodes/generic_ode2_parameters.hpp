// Generated from specs/nodes/generic_ode2.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// node with a chosen number of coordinates of second order differential equations, without a meaning in space
struct NodeGenericODE2Parameters {
  std::vector<double> referenceCoordinates;
  std::vector<double> initialCoordinates;
  std::vector<double> initialCoordinates_t;
  int numberOfODE2Coordinates = 0;
};

struct NodeGenericODE2Visualization {
  bool show = false;
};

struct NodeGenericODE2Record {
  std::string name;
  NodeGenericODE2Parameters parameters;
  NodeGenericODE2Visualization visualization;
};

}  // namespace dalembert
