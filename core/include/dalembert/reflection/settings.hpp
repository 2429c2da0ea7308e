// Run-time description of a settings structure: its rows, and nested structures. Written by the generator.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>

#include "dalembert/reflection/row.hpp"

namespace dalembert {

struct SettingsGroup;

// A structure inside a structure.
struct SettingsChild {
  std::string_view name;  // name of the member
  const SettingsGroup* group;  // its type
  std::uint32_t offset;  // offset in the containing structure
};

// Properties of a setting beyond its row; unused texts are empty.
struct SettingRule {
  std::string_view name;
  double lower = -std::numeric_limits<double>::infinity(), upper = std::numeric_limits<double>::infinity();
  bool lower_open = false, upper_open = false;  // the bound itself is left out
  std::string_view words = {};                  // of the range: "from 0 to 1"
  std::string_view no_effect = {};              // why nothing depends on it, but for `only_in`
  std::string_view no_effect_on_pages = {},
                   no_effect_without_rays = {};  // why no page does, and no picture without the ray tracer
  std::span<const std::string_view> acts_with = {};  // related flags, one of which has to be true
  std::string_view only_in = {};  // the structure of the root whose own has an effect, for all structures like it

  constexpr bool admits(double value) const {
    return (lower_open ? value > lower : value >= lower) && (upper_open ? value < upper : value <= upper);
  }
  // "acts with a or b only"; empty: it acts by itself.
  std::string condition() const {
    std::string text;
    for (const std::string_view flag : acts_with) text += (text.empty() ? "acts with " : " or ") + std::string(flag);
    return text.empty() ? text : text + " only";
  }
};

struct SettingsGroup {
  std::string_view name;  // name of the C++ structure and of the Python class
  std::span<const Row> rows;  // offsets from the start of this structure
  std::span<const SettingsChild> children;
  std::span<const SettingRule> rules = {};

  const SettingRule* rule_of(std::string_view row) const {
    for (const SettingRule& rule : rules)
      if (rule.name == row) return &rule;
    return nullptr;
  }
};

}  // namespace dalembert
