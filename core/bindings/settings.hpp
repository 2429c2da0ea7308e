// Settings in Python: objects that refer into one structure, their attributes made from the reflection rows.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "dalembert/reflection/item_type.hpp"
#include "dalembert/reflection/settings.hpp"
#include "dalembert/simulation_settings.hpp"
#include "dalembert/visualization_settings.hpp"

namespace dalembert {

namespace py = pybind11;

// The structures behind Python objects, shared with them. TypeError if `object` is something else.
std::shared_ptr<SimulationSettings> simulation_settings_of(py::handle object);
std::shared_ptr<VisualizationSettings> visualization_settings_of(py::handle object);

// Another name for a parameter or a structure, both as dotted paths.
struct SettingsAlias {
  std::string_view path, target;
};
std::span<const SettingsAlias> simulation_aliases();
std::span<const SettingsAlias> visualization_aliases();

// The tree of one class: SimulationSettings() or VisualizationSettings().
struct SettingsTree {
  const SettingsGroup* group = nullptr;
  RecordOperations operations{};
  std::span<const SettingsAlias> aliases = {};
};

// A structure within the memory of its root.
struct SettingsView {
  const SettingsTree* tree = nullptr;
  const SettingsGroup* group = nullptr;
  std::shared_ptr<void> root;
  void* data = nullptr;
  std::string path;  // empty: the root

  // "SimulationSettings.timeIntegration"
  std::string title() const;
  std::string path_to(std::string_view name) const;
  SettingsView child(const SettingsChild& child) const;
};

// The meaning of a name below a structure; all members are empty if it is unknown. Aliases are resolved.
struct SettingsField {
  SettingsView view;  // that has the field
  const Row* row = nullptr;
  const SettingsChild* child = nullptr;
  bool without_effect = false;
  bool only_names = false;  // `view` has no members of its own, but is the beginning of other names
  explicit operator bool() const { return row != nullptr || child != nullptr || without_effect || only_names; }
};
// The structure without members.
const SettingsGroup& names_group();
SettingsField find_field(const SettingsView& view, std::string_view name);
[[noreturn]] void refuse_unknown(const SettingsView& view, std::string_view name);

// Values, see settings_values.cpp. Writing an invalid value throws and changes nothing.
py::object read_setting(const SettingsView& view, const Row& row);
void write_setting(const SettingsView& view, const Row& row, PyObject* value);
void assign_settings(const SettingsGroup& group, void* target, const void* source);
bool equal_settings(const SettingsGroup& group, const void* a, const void* b);
py::dict settings_dictionary(const SettingsView& view);
py::dict settings_dictionary_with_types(const SettingsView& view);
// Finds settings that never have an effect, with the reason, by their paths.
void find_settings_without_effect(const SettingsGroup& group, std::string_view SettingRule::* reason,
                                  const std::string& path, py::dict& found);
void set_settings_dictionary(const SettingsView& view, const py::dict& values);
std::string settings_text(const SettingsView& view);
std::string settings_differences(const SettingsView& view, const SettingsView& defaults);
// Texts: summary of a structure; description of a parameter; its type, range and unit.
std::string settings_summary(const SettingsGroup& group);
std::string setting_text(const SettingsGroup& group, const Row& row);
std::string setting_doc(const SettingsGroup& group, const Row& row);

}  // namespace dalembert
