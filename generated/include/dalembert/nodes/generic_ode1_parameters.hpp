// Generated from specs/nodes/generic_ode1.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// node with a chosen number of coordinates of first order differential equations, for controllers, hydraulics and state-space models
struct NodeGenericODE1Parameters {
  std::vector<double> referenceCoordinates;
  std::vector<double> initialCoordinates;
  int numberOfODE1Coordinates = 0;
};

struct NodeGenericODE1Visualization {
  bool show = false;
};

struct NodeGenericODE1Record {
  std::string name;
  NodeGenericODE1Parameters parameters;
  NodeGenericODE1Visualization visualization;
};

}  // namespace dalembert
