// The whole analysis of a sparse pattern: an order of elimination, its fronts, and a root in their middle.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "assembly_tree.hpp"

namespace dalembert {

// For matrices with a diagonal like that of `values`, where the `dependent` multipliers follow from others. What has been found is kept with the pattern: initial accelerations, the steps
// after them and the next solution ask for the same.
std::shared_ptr<const std::vector<FrontStructure>> elimination_tree(const Pattern& pattern, std::span<const double> values,
                                                                     std::span<const int> dependent);

}  // namespace dalembert
