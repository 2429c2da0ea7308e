// MarkerBodyCable2DCoordinates, specs/markers/body_cable_2d_coordinates.toml
#pragma once

#include "dalembert/items/markers/cable_coordinates.hpp"
#include "dalembert/markers/body_cable_2d_coordinates_parameters.hpp"

namespace dalembert {

struct MarkerBodyCable2DCoordinates : CableCoordinates<MarkerBodyCable2DCoordinatesParameters, 2> {};

}  // namespace dalembert
