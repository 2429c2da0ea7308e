// MarkerBodyBeamShape, specs/markers/body_beam_shape.toml
#pragma once

#include "dalembert/items/markers/cable_coordinates.hpp"
#include "dalembert/markers/body_beam_shape_parameters.hpp"

namespace dalembert {

struct MarkerBodyBeamShape : CableCoordinates<MarkerBodyBeamShapeParameters, 3> {};

}  // namespace dalembert
