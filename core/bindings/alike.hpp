// Groups of items with the same appearance: one type and equal visualization parameters.
#pragma once

#include <cstdint>
#include <vector>

#include "dalembert/model/model.hpp"

namespace dalembert {

// Returns, for each item of a kind, the number of the first item with the same appearance among those compared
// recently, or its own number.
std::vector<std::int32_t> alike(const Model& model, ItemKind kind);

}  // namespace dalembert
