// Generated from specs/markers/bodies_relative_translation_coordinate.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// A coordinate marker on the relative translation of two bodies along an axis
struct MarkerBodiesRelativeTranslationCoordinateParameters {
  std::vector<ObjectIndex> bodyNumbers = std::vector<ObjectIndex>(2);
  Vec<double, 3> localPosition0 = {};
  Vec<double, 3> localPosition1 = {};
  Vec<double, 3> axis0 = {1.0, 0.0, 0.0};
  double offset = 0.0;
};

struct MarkerBodiesRelativeTranslationCoordinateVisualization {
  bool show = true;
};

struct MarkerBodiesRelativeTranslationCoordinateRecord {
  std::string name;
  MarkerBodiesRelativeTranslationCoordinateParameters parameters;
  MarkerBodiesRelativeTranslationCoordinateVisualization visualization;
};

}  // namespace dalembert
