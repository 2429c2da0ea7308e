// Generated from specs/joints/revolute_2d.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// A revolute joint of planar bodies: keeps two points together in the x-y plane
struct ObjectJointRevolute2DParameters {
  std::vector<MarkerIndex> markerNumbers = std::vector<MarkerIndex>(2);
  bool activeConnector = true;
};

struct ObjectJointRevolute2DVisualization {
  bool show = true;
  double drawSize = -1.0;
  Vec<double, 4> color = {-1.0, -1.0, -1.0, -1.0};
};

struct ObjectJointRevolute2DRecord {
  std::string name;
  ObjectJointRevolute2DParameters parameters;
  ObjectJointRevolute2DVisualization visualization;
};

}  // namespace dalembert
