// Texts of specs about settings and enumerations, for help().
#pragma once

#include <span>
#include <string_view>

namespace dalembert {

struct SettingsText {
  std::string_view name, summary;
  std::span<const std::string_view> rows;  // same order as SettingsGroup::rows
};

// One entry per structure.
std::span<const SettingsText> settings_texts();

struct EnumText {
  std::string_view summary;
  std::span<const std::string_view> values;  // same order as EnumTable::entries
};

// Same order as enum_tables().
std::span<const EnumText> enum_texts();

}  // namespace dalembert
