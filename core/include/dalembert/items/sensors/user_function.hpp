// SensorUserFunction, specs/sensors/user_function.toml
#pragma once

#include "dalembert/contracts/sensor.hpp"
#include "dalembert/reflection/callback.hpp"
#include "dalembert/sensors/user_function_parameters.hpp"

namespace dalembert {

struct SensorUserFunction : NoSubject {
  using Parameters = SensorUserFunctionParameters;

  static void measure(System& system, const Parameters& p, int sensor, ConfigurationType configuration,
                      std::vector<double>& values) {
    values.clear();
    if (!p.sensorUserFunction) return;
    std::vector<double> numbers;
    for (const SensorIndex& index : p.sensorNumbers) numbers.push_back(index.value);
    const double kind = static_cast<double>(configuration);
    const Argument arguments[] = {{numbers.data(), static_cast<int>(numbers.size()), 0},
                                  {p.factors.data(), static_cast<int>(p.factors.size()), 0},
                                  {&kind, 0, 0}};
    values = p.sensorUserFunction.callback->call_any(system.state(configuration).time, sensor, arguments);
    system.state_may_have_changed();
  }
};

}  // namespace dalembert
