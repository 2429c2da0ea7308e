// Texts of specs about items, for help(): stored separately from the rows that simulations read.
#pragma once

#include <span>
#include <string_view>

#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

struct OutputText {
  std::string_view name;
  int size;  // 0: depends on the item
  std::string_view unit, text;
};

struct ItemText {
  std::string_view summary;
  std::span<const std::string_view> rows;  // same order as ItemType::rows
  std::span<const OutputText> outputs;  // same order as ItemType::outputs
  std::string_view more;                   // user functions, Create functions, example, page
};

// Same order as item_types().
std::span<const ItemText> item_texts();

}  // namespace dalembert
