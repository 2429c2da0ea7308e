// Sensors have no batches: they are evaluated one by one on demand.
#pragma once

#include "dalembert/contracts/sensor.hpp"

namespace dalembert {

template <class K, class Record>
struct SensorPhysicsOf final : SensorPhysics {
  static_assert(SensorKernel<K>, "see core/include/dalembert/contracts/sensor.hpp");

  void measure(System& system, const void* record, int sensor, ConfigurationType configuration,
               std::vector<double>& values) const override {
    K::measure(system, static_cast<const Record*>(record)->parameters, sensor, configuration, values);
  }
  std::optional<SensorSubject> subject(const void* record) const override {
    return K::subject(static_cast<const Record*>(record)->parameters);
  }
};

}  // namespace dalembert
