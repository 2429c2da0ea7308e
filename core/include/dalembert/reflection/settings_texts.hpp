// What specs say about settings and enumerations in words, for help() and its like.
#pragma once

#include <span>
#include <string_view>

namespace dalembert {

struct SettingsText {
  std::string_view name, summary;
  std::span<const std::string_view> rows;  // in the order of SettingsGroup::rows
};

// One per structure.
std::span<const SettingsText> settings_texts();

struct EnumText {
  std::string_view summary;
  std::span<const std::string_view> values;  // in the order of EnumTable::entries
};

// In the order of enum_tables().
std::span<const EnumText> enum_texts();

}  // namespace dalembert
