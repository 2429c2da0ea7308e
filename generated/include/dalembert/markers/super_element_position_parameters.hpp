// Generated from specs/markers/super_element_position.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// A marker at the weighted mean position of mesh nodes of a super element
struct MarkerSuperElementPositionParameters {
  ObjectIndex bodyNumber;
  std::vector<int> meshNodeNumbers;
  std::vector<double> weightingFactors;
};

struct MarkerSuperElementPositionVisualization {
  bool show = true;
  bool showMarkerNodes = true;
};

struct MarkerSuperElementPositionRecord {
  std::string name;
  MarkerSuperElementPositionParameters parameters;
  MarkerSuperElementPositionVisualization visualization;
};

}  // namespace dalembert
