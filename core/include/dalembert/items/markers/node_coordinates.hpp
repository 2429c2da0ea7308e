// MarkerNodeCoordinates, specs/markers/node_coordinates.toml
#pragma once

#include <numeric>
#include <vector>

#include "dalembert/markers/node_coordinates_parameters.hpp"

namespace dalembert {

struct MarkerNodeCoordinates {
  using Parameters = MarkerNodeCoordinatesParameters;
  static constexpr bool totals = true;  // reference coordinates are included

  static std::vector<int> coordinates(const Parameters&, int available) {
    std::vector<int> all(static_cast<std::size_t>(available));
    std::iota(all.begin(), all.end(), 0);
    return all;
  }
};

}  // namespace dalembert
