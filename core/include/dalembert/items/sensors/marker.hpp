// SensorMarker, specs/sensors/marker.toml
#pragma once

#include "dalembert/contracts/sensor.hpp"
#include "dalembert/sensors/marker_parameters.hpp"

namespace dalembert {

struct SensorMarker {
  using Parameters = SensorMarkerParameters;

  static void measure(System& system, const Parameters& p, int, ConfigurationType configuration,
                      std::vector<double>& values) {
    system.marker_output(p.markerNumber.value, p.outputVariableType, configuration, values);
  }
  static std::optional<SensorSubject> subject(const Parameters& p) {
    return SensorSubject{ItemKind::marker, p.markerNumber.value, p.outputVariableType};
  }
};

}  // namespace dalembert
