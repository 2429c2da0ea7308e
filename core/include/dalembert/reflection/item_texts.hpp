// What specs say about items in words, for help() and its like: beside the rows, which simulations read.
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
  std::span<const std::string_view> rows;  // in the order of ItemType::rows
  std::span<const OutputText> outputs;     // in the order of ItemType::outputs
  std::string_view more;                   // user functions, Create functions, example, page
};

// In the order of item_types().
std::span<const ItemText> item_texts();

}  // namespace dalembert
