// Generated tables of the items of one extension module: the core, or a package.
#pragma once

#include "dalembert/reflection/item_texts.hpp"
#include "dalembert/reflection/item_transformations.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

std::span<const ItemType* const> own_item_types();
std::span<const ItemText> own_item_texts();  // same order
std::span<const ItemTransformation> own_item_transformations();

}  // namespace dalembert
