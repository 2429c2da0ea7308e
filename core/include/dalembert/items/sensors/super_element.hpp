// SensorSuperElement, specs/sensors/super_element.toml
#pragma once

#include "dalembert/contracts/sensor.hpp"
#include "dalembert/sensors/super_element_parameters.hpp"

namespace dalembert {

struct SensorSuperElement : NoSubject {
  using Parameters = SensorSuperElementParameters;

  static void measure(System& system, const Parameters& p, int, ConfigurationType configuration,
                      std::vector<double>& values) {
    system.super_element_output(p.bodyNumber.value, p.outputVariableType, p.meshNodeNumber, configuration, values);
  }
};

}  // namespace dalembert
