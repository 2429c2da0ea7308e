// MarkerObjectODE2Coordinates, specs/markers/object_ode2_coordinates.toml
#pragma once

#include <numeric>
#include <vector>

#include "dalembert/markers/object_ode2_coordinates_parameters.hpp"

namespace dalembert {

struct MarkerObjectODE2Coordinates {
  using Parameters = MarkerObjectODE2CoordinatesParameters;
  static constexpr bool totals = true;  // reference coordinates are included

  static std::vector<int> coordinates(const Parameters&, int available) {
    std::vector<int> all(static_cast<std::size_t>(available));
    std::iota(all.begin(), all.end(), 0);
    return all;
  }
};

}  // namespace dalembert
