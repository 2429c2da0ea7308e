#include "elimination_tree.hpp"

#include <algorithm>
#include <utility>

#include "elimination_order.hpp"
#include "tree_rotation.hpp"

namespace dalembert {

namespace {

constexpr std::size_t most_known = 2;  // that of masses and constraints, that of Newton's matrix

}  // namespace

std::shared_ptr<const std::vector<FrontStructure>> elimination_tree(const Pattern& pattern, std::span<const double> values) {
  std::vector<bool> at_hand = pivots_at_hand(pattern, values);
  std::vector<EliminationTree>& known = pattern.known_trees();
  const auto found = std::ranges::find(known, at_hand, &EliminationTree::at_hand);
  if (found != known.end()) return found->fronts;
  auto fronts = std::make_shared<const std::vector<FrontStructure>>(
      balanced(assembly_tree(pattern, minimum_degree_order(pattern, at_hand)), at_hand));
  if (known.size() == most_known) known.erase(known.begin());
  known.push_back({std::move(at_hand), fronts});
  return fronts;
}

}  // namespace dalembert
