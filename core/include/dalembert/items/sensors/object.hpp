// SensorObject, specs/sensors/object.toml
#pragma once

#include "dalembert/contracts/sensor.hpp"
#include "dalembert/sensors/object_parameters.hpp"

namespace dalembert {

struct SensorObject {
  using Parameters = SensorObjectParameters;

  static void measure(System& system, const Parameters& p, int, ConfigurationType configuration,
                      std::vector<double>& values) {
    system.object_output(p.objectNumber.value, p.outputVariableType, configuration, values);
  }
  static std::optional<SensorSubject> subject(const Parameters& p) {
    return SensorSubject{ItemKind::object, p.objectNumber.value, p.outputVariableType};
  }
};

}  // namespace dalembert
