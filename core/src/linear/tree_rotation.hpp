// Chains are eliminated from both ends: the steps of one half need not wait for those of the other.
#pragma once

#include <vector>

#include "assembly_tree.hpp"
#include "elimination_order.hpp"

namespace dalembert {

// Makes a front in the middle of its longest path the root of each tree, if that shortens the tree, does not enlarge the
// factors and leaves to each front as many pivots as it needs. Fronts of the two halves take turns, so that the processor
// computes one while the other's results are still on their way.
std::vector<FrontStructure> balanced(std::vector<FrontStructure> tree, const PivotSurplus& brought);

}  // namespace dalembert
