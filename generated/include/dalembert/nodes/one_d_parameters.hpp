// Generated from specs/nodes/one_d.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// node with one coordinate of a second order differential equation, for motion along a line or about a fixed axis
struct Node1DParameters {
  std::vector<double> referenceCoordinates = {0.0};
  std::vector<double> initialCoordinates = {0.0};
  std::vector<double> initialVelocities = {0.0};
};

struct Node1DVisualization {
  bool show = false;
};

struct Node1DRecord {
  std::string name;
  Node1DParameters parameters;
  Node1DVisualization visualization;
};

}  // namespace dalembert
