// Generated from specs/nodes/generic_ae.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// node with a chosen number of algebraic variables, for equations that hold without time derivatives
struct NodeGenericAEParameters {
  std::vector<double> referenceCoordinates;
  std::vector<double> initialCoordinates;
  int numberOfAECoordinates = 0;
};

struct NodeGenericAEVisualization {
  bool show = false;
};

struct NodeGenericAERecord {
  std::string name;
  NodeGenericAEParameters parameters;
  NodeGenericAEVisualization visualization;
};

}  // namespace dalembert
