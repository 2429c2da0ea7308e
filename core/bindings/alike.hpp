// Items that look alike: of one type, with equal parameters of visualization.
#pragma once

#include <cstdint>
#include <vector>

#include "dalembert/model/model.hpp"

namespace dalembert {

// For each item of a kind the number of the first one that looks like it; its own, if there is none among those that were seen lately.
std::vector<std::int32_t> alike(const Model& model, ItemKind kind);

}  // namespace dalembert
