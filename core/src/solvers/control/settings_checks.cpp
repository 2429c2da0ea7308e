#include "control/settings_checks.hpp"

#include <algorithm>
#include <mutex>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "dalembert/model/errors.hpp"
#include "dalembert/model/member.hpp"
#include "dalembert/output/numbers.hpp"

namespace dalembert {

void require_duration(double start_time, double end_time) {
  if (end_time > start_time) return;
  throw ModelError(ErrorKind::value, "timeIntegration.endTime: received " + format_number(end_time) +
                                         " with startTime=" + format_number(start_time) +
                                         "; there is nothing to integrate. Expected a time after " +
                                         "startTime: set endTime = startTime + duration.");
}

namespace {

struct Idle {
  std::size_t offset;  // offset in SimulationSettings
  Storage storage;
  const SettingRule* rule;
  std::vector<std::size_t> flags;  // offsets of flags: the setting acts if one of them is set
};

void collect(const SettingsGroup& group, std::size_t offset, std::vector<Idle>& found) {
  for (const SettingRule& rule : group.rules) {
    if (rule.no_effect.empty() && rule.acts_with.empty()) continue;
    const auto row = [&group](std::string_view name) -> const Row& {
      return *std::ranges::find(group.rows, name, &Row::name);
    };
    const Row& own = row(rule.name);
    Idle& idle = found.emplace_back(offset + own.offset, own.storage, &rule);
    for (const std::string_view flag : rule.acts_with) idle.flags.push_back(offset + row(flag).offset);
  }
  for (const SettingsChild& child : group.children) collect(*child.group, offset + child.offset, found);
}

std::vector<Idle> all_without_effect() {
  std::vector<Idle> found;
  collect(simulation_settings_group(), 0, found);
  return found;
}

// The path of a setting below a group; empty: it is not there.
std::string path_of(const Idle& setting, const SettingsGroup& group, std::size_t offset) {
  for (const SettingRule& rule : group.rules) {
    if (&rule != setting.rule) continue;
    const Row& row = *std::ranges::find(group.rows, rule.name, &Row::name);
    if (offset + row.offset == setting.offset) return std::string(rule.name);  // groups may occur several times
  }
  for (const SettingsChild& child : group.children) {
    const std::string path = path_of(setting, *child.group, offset + child.offset);
    if (!path.empty()) return std::string(child.name) + "." + path;
  }
  return "";
}

bool equal(const Idle& setting, const SimulationSettings& a, const SimulationSettings& b) {
  const auto at = [&](const SimulationSettings& s) { return reinterpret_cast<const char*>(&s) + setting.offset; };
  return with_type(setting.storage, [&]<class T>(TypeTag<T>) -> bool {
    if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T> || std::is_same_v<T, std::string>) {
      return *reinterpret_cast<const T*>(at(a)) == *reinterpret_cast<const T*>(at(b));
    } else {
      throw std::logic_error("a setting without effect that is no single value");
    }
  });
}

bool acts(const Idle& setting, const SimulationSettings& settings) {
  const char* const start = reinterpret_cast<const char*>(&settings);
  return std::ranges::any_of(setting.flags,
                             [start](std::size_t offset) { return *reinterpret_cast<const bool*>(start + offset); });
}

bool is_new(const std::string& path) {
  static std::mutex mutex;
  static std::set<std::string> known;
  const std::scoped_lock lock(mutex);
  return known.insert(path).second;
}

}  // namespace

void tell_settings_without_effect(const SimulationSettings& settings,
                                  const std::function<void(std::string_view)>& warn) {
  static const std::vector<Idle> idle = all_without_effect();
  static const SimulationSettings defaults;
  if (!warn) return;
  for (const Idle& setting : idle) {
    if (equal(setting, settings, defaults) || acts(setting, settings)) continue;
    const std::string path = "simulationSettings." + path_of(setting, simulation_settings_group(), 0);
    if (!is_new(path)) continue;
    const SettingRule& rule = *setting.rule;
    warn(path + " has no effect: " + (rule.no_effect.empty() ? "it " + rule.condition() : std::string(rule.no_effect)));
  }
}

void warn_of_unused_tolerances(const SimulationSettings& settings, const std::function<void(std::string_view)>& warn) {
  static const SimulationSettings defaults;
  if (!warn) return;
  const auto check = [&](double TimeIntegrationSettings::* tolerance, const std::string& name) {
    const std::string path = "simulationSettings.timeIntegration." + name;
    if (settings.timeIntegration.*tolerance == defaults.timeIntegration.*tolerance || !is_new(path)) return;
    warn(
        path +
        " has no effect: this solver takes steps of equal size. Implicit solvers choose their steps by tolerances with "
        "stepSizeControl.implicitSolvers=True and timeIntegration.automaticStepSize=True, explicit ones such as "
        "exu.DynamicSolverType.DOPRI5 with the latter alone");
  };
  check(&TimeIntegrationSettings::relativeTolerance, "relativeTolerance");
  check(&TimeIntegrationSettings::absoluteTolerance, "absoluteTolerance");
}

}  // namespace dalembert
