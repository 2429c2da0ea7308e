// Sensors on mesh nodes in a floating frame: such nodes return their outputs in components of the frame.
#pragma once

#include <vector>

#include "dalembert/model/model.hpp"

namespace dalembert {

// The node of the frame, by number of the sensor; -1: values of the sensor are global.
std::vector<int> floating_frames_of_sensors(const Model& model);

}  // namespace dalembert
