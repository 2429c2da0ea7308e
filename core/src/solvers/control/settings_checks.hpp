// What solvers look for in settings that are each within their range.
#pragma once

#include <functional>
#include <string_view>

#include "dalembert/simulation_settings.hpp"

namespace dalembert {

// ModelError if there is nothing to integrate.
void require_duration(double start_time, double end_time);

// Settings that differ from their defaults although nothing depends on them are told to `warn`, with the reason: each once in
// the life of the process. Without `warn`, none counts as told.
void tell_settings_without_effect(const SimulationSettings& settings, const std::function<void(std::string_view)>& warn);

// Warns, once for each setting, of tolerances that differ from their defaults although the solver takes steps of equal size.
void warn_of_unused_tolerances(const SimulationSettings& settings, const std::function<void(std::string_view)>& warn);

}  // namespace dalembert
