// Generated from specs/markers/body_position.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// A marker at a point that is fixed to a body, with its position but without orientation
struct MarkerBodyPositionParameters {
  ObjectIndex bodyNumber;
  Vec<double, 3> localPosition = {};
};

struct MarkerBodyPositionVisualization {
  bool show = true;
};

struct MarkerBodyPositionRecord {
  std::string name;
  MarkerBodyPositionParameters parameters;
  MarkerBodyPositionVisualization visualization;
};

}  // namespace dalembert
