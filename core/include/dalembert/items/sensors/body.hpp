// SensorBody, specs/sensors/body.toml
#pragma once

#include "dalembert/contracts/sensor.hpp"
#include "dalembert/sensors/body_parameters.hpp"

namespace dalembert {

struct SensorBody {
  using Parameters = SensorBodyParameters;

  static void measure(System& system, const Parameters& p, int, ConfigurationType configuration,
                      std::vector<double>& values) {
    system.body_output(p.bodyNumber.value, p.outputVariableType, p.localPosition.x, configuration, values);
  }
  static std::optional<SensorSubject> subject(const Parameters& p) {
    return SensorSubject{ItemKind::object, p.bodyNumber.value, p.outputVariableType};
  }
};

}  // namespace dalembert
