// What is known of a settings structure at run time: its rows, and the structures inside it. Written by the generator.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "dalembert/reflection/row.hpp"

namespace dalembert {

struct SettingsGroup;

// A structure inside a structure.
struct SettingsChild {
  std::string_view name;       // of the member
  const SettingsGroup* group;  // its type
  std::uint32_t offset;        // in the structure that contains it
};

struct SettingsGroup {
  std::string_view name;  // of the C++ structure and of the Python class
  std::span<const Row> rows;  // offsets from the start of this structure
  std::span<const SettingsChild> children;
};

}  // namespace dalembert
