// Are two members equal, as Python users see them?
#pragma once

#include "dalembert/reflection/row.hpp"

namespace dalembert {

bool equal_members(const Row& row, const void* record_a, const void* record_b);

}  // namespace dalembert
