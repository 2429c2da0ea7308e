// NodePointSlope23, specs/nodes/point_slope23.toml
#pragma once

#include "dalembert/items/nodes/slopes.hpp"
#include "dalembert/nodes/point_slope23_parameters.hpp"

namespace dalembert {

struct NodePointSlope23 : NodeWithSlopes<AxesOfSection> {
  using Parameters = NodePointSlope23Parameters;
  static constexpr std::string_view item = "NodePointSlope23";

  static void check(const Parameters& p, const ItemLabel& item) {
    check_slopes(p.referenceCoordinates, p.initialCoordinates, item);
  }
};

}  // namespace dalembert
