// MarkerNodeCoordinate, specs/markers/node_coordinate.toml
#pragma once

#include <vector>

#include "dalembert/markers/node_coordinate_parameters.hpp"

namespace dalembert {

struct MarkerNodeCoordinate {
  using Parameters = MarkerNodeCoordinateParameters;
  static constexpr bool totals = false;  // reference coordinates are left out

  static std::vector<int> coordinates(const Parameters& p, int) { return {p.coordinate}; }
};

}  // namespace dalembert
