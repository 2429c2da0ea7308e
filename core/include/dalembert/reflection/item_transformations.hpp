// Rigid transformations as another way to give a position and a rotation, from the specs.
#pragma once

#include <span>
#include <string_view>

namespace dalembert {

struct ItemTransformation {
  std::string_view item, name;          // "MarkerBodyRigid", "localHT"
  std::string_view position, rotation;  // its parameters; empty: it has no position
};

std::span<const ItemTransformation> item_transformations();

}  // namespace dalembert
