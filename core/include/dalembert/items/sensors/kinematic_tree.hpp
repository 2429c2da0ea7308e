// SensorKinematicTree, specs/sensors/kinematic_tree.toml
#pragma once

#include "dalembert/contracts/sensor.hpp"
#include "dalembert/sensors/kinematic_tree_parameters.hpp"

namespace dalembert {

struct SensorKinematicTree {
  using Parameters = SensorKinematicTreeParameters;

  static void measure(System& system, const Parameters& p, int, ConfigurationType configuration,
                      std::vector<double>& values) {
    system.link_output(p.objectNumber.value, p.outputVariableType, p.linkNumber, p.localPosition.x, configuration,
                       values);
  }
  static std::optional<SensorSubject> subject(const Parameters& p) {
    return SensorSubject{ItemKind::object, p.objectNumber.value, p.outputVariableType,
                         SensorSubject::Link{p.linkNumber, "an ObjectKinematicTree"}};
  }
};

}  // namespace dalembert
