#include "elimination_tree.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "elimination_order.hpp"
#include "tree_rotation.hpp"

namespace dalembert {

namespace {

constexpr std::size_t most_known = 2;  // that of masses and constraints, that of Newton's matrix

// Key that distinguishes trees of a pattern.
std::vector<bool> key_of(const PivotSurplus& surplus, bool some_depend) {
  std::vector<bool> key;
  std::ranges::transform(surplus, std::back_inserter(key), [](signed char s) { return s > 0; });
  if (some_depend) std::ranges::transform(surplus, std::back_inserter(key), [](signed char s) { return s == 0; });
  return key;
}

}  // namespace

std::shared_ptr<const std::vector<FrontStructure>> elimination_tree(const Pattern& pattern,
                                                                    std::span<const double> values,
                                                                    std::span<const int> dependent) {
  const PivotSurplus surplus = pivot_surplus(pattern, values, dependent);
  std::vector<bool> key = key_of(surplus, !dependent.empty());
  std::vector<EliminationTree>& known = pattern.known_trees();
  const auto found = std::ranges::find(known, key, &EliminationTree::made_for);
  if (found != known.end()) return found->fronts;
  auto fronts = std::make_shared<const std::vector<FrontStructure>>(
      balanced(assembly_tree(pattern, minimum_degree_order(pattern, surplus)), surplus));
  if (known.size() == most_known) known.erase(known.begin());
  known.push_back({std::move(key), fronts});
  return fronts;
}

}  // namespace dalembert
