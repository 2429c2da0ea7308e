// Generated from specs/nodes/generic_data.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// node with a chosen number of data variables: states that are kept from step to step and are not unknowns of the solver
struct NodeGenericDataParameters {
  std::vector<double> initialCoordinates;
  int numberOfDataCoordinates = 0;
};

struct NodeGenericDataVisualization {
  bool show = false;
};

struct NodeGenericDataRecord {
  std::string name;
  NodeGenericDataParameters parameters;
  NodeGenericDataVisualization visualization;
};

}  // namespace dalembert
