// The whole analysis of a sparse pattern: an order of elimination, its fronts, and a root in their middle.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "assembly_tree.hpp"

namespace dalembert {

// Elimination tree for matrices with a diagonal like that of `values` and redundant multipliers `dependent`. Results
// are cached with the pattern: initial accelerations, later steps and the next solution need the same tree.
std::shared_ptr<const std::vector<FrontStructure>> elimination_tree(const Pattern& pattern,
                                                                    std::span<const double> values,
                                                                    std::span<const int> dependent);

}  // namespace dalembert
