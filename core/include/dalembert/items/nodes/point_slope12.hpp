// NodePointSlope12, specs/nodes/point_slope12.toml
#pragma once

#include "dalembert/items/nodes/slopes.hpp"
#include "dalembert/nodes/point_slope12_parameters.hpp"

namespace dalembert {

struct NodePointSlope12 : NodeWithSlopes<AxesOfPlate> {
  using Parameters = NodePointSlope12Parameters;
  static constexpr std::string_view item = "NodePointSlope12";

  static void check(const Parameters& p, const ItemLabel& item) {
    check_slopes(p.referenceCoordinates, p.initialCoordinates, item);
  }
};

}  // namespace dalembert
