// SensorNode, specs/sensors/node.toml
#pragma once

#include "dalembert/contracts/sensor.hpp"
#include "dalembert/sensors/node_parameters.hpp"

namespace dalembert {

struct SensorNode {
  using Parameters = SensorNodeParameters;

  static void measure(System& system, const Parameters& p, int, ConfigurationType configuration,
                      std::vector<double>& values) {
    system.node_output(p.nodeNumber.value, p.outputVariableType, configuration, values);
  }
  static std::optional<SensorSubject> subject(const Parameters& p) {
    return SensorSubject{
        .kind = ItemKind::node, .number = p.nodeNumber.value, .variable = p.outputVariableType, .is_value = true};
  }
};

}  // namespace dalembert
