// SensorLoad, specs/sensors/load.toml
#pragma once

#include "dalembert/contracts/sensor.hpp"
#include "dalembert/sensors/load_parameters.hpp"

namespace dalembert {

struct SensorLoad : NoSubject {
  using Parameters = SensorLoadParameters;

  static void measure(System& system, const Parameters& p, int, ConfigurationType configuration,
                      std::vector<double>& values) {
    system.load_values(p.loadNumber.value, system.state(configuration).time, values);
  }
};

}  // namespace dalembert
