// Checks of settings that depend on each other.
#pragma once

#include <functional>
#include <string_view>

#include "dalembert/simulation_settings.hpp"

namespace dalembert {

// Raises a ModelError if the duration is not positive.
void require_duration(double start_time, double end_time);

// Reports settings without effect that differ from their defaults, with the reason, by `warn`: each once per process. A
// setting is not marked as reported if `warn` is empty.
void tell_settings_without_effect(const SimulationSettings& settings,
                                  const std::function<void(std::string_view)>& warn);

// Warns, once per setting, of tolerances that differ from their defaults if the solver takes equal steps.
void warn_of_unused_tolerances(const SimulationSettings& settings, const std::function<void(std::string_view)>& warn);

}  // namespace dalembert
