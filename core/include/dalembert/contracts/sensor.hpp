// Sensors: a kernel defines the measured value, and names the item and output variable. No member is optional: a
// sensor whose values are not those of one item derives from NoSubject.
#pragma once

#include <concepts>
#include <optional>
#include <vector>

#include "dalembert/system/physics.hpp"
#include "dalembert/system/system.hpp"

namespace dalembert {

struct NoSubject {
  static std::optional<SensorSubject> subject(const auto&) { return {}; }
};

template <class K>
concept SensorKernel = requires(System& system, const typename K::Parameters& p, ConfigurationType configuration,
                                std::vector<double>& values) {
  { K::measure(system, p, 0, configuration, values) } -> std::same_as<void>;  // 0: the number of the sensor
  { K::subject(p) } -> std::same_as<std::optional<SensorSubject>>;
};

}  // namespace dalembert
