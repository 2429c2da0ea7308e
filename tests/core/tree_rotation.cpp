// A chain of fronts gets its root in the middle and stays a tree of the same couplings, if every front has its pivots.
#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "../../core/src/linear/tree_rotation.cpp"

using namespace dalembert;

namespace {

constexpr int chain_fronts = 20;

// Front k eliminates two unknowns and couples the next two, which the last one eliminates as well; a further unknown hangs at
// every fourth front.
std::vector<FrontStructure> chain() {
  std::vector<FrontStructure> tree;
  int before = -1, unknowns = 2 * chain_fronts + 2;
  for (int k = 0; k < chain_fronts; ++k) {
    FrontStructure front{.pivots = {2 * k, 2 * k + 1}, .updates = {}, .parent = -1};
    std::vector<int>& next = k + 1 < chain_fronts ? front.updates : front.pivots;
    next.insert(next.end(), {2 * k + 2, 2 * k + 3});
    std::vector<int> children;
    if (before >= 0) children.push_back(before);
    if (k % 4 == 1) {
      children.push_back(static_cast<int>(tree.size()));
      tree.push_back({.pivots = {unknowns++}, .updates = {2 * k}, .parent = -1});
    }
    before = static_cast<int>(tree.size());
    for (const int child : children) tree[child].parent = before;
    tree.push_back(front);
  }
  return tree;
}

std::vector<int> unknowns_of(const FrontStructure& front) {
  std::vector<int> all = front.pivots;
  all.insert(all.end(), front.updates.begin(), front.updates.end());
  std::ranges::sort(all);
  return all;
}

int longest_path(const std::vector<FrontStructure>& tree) {
  std::vector<int> height(tree.size(), 1);
  for (std::size_t f = 0; f < tree.size(); ++f)
    if (const int parent = tree[f].parent; parent >= 0) height[parent] = std::max(height[parent], height[f] + 1);
  return *std::ranges::max_element(height);
}

// Both fronts differ only in the variables that they eliminate; a child comes before its parent, which takes over all that it leaves.
bool equivalent(const std::vector<FrontStructure>& tree, const std::vector<FrontStructure>& to) {
  std::vector<std::vector<int>> fronts, expected;
  std::vector<int> pivots, expected_pivots;
  bool good = tree.size() == to.size();
  for (std::size_t f = 0; f < tree.size() && good; ++f) {
    fronts.push_back(unknowns_of(tree[f]));
    expected.push_back(unknowns_of(to[f]));
    pivots.insert(pivots.end(), tree[f].pivots.begin(), tree[f].pivots.end());
    expected_pivots.insert(expected_pivots.end(), to[f].pivots.begin(), to[f].pivots.end());
    std::vector<int> left = tree[f].updates;
    std::ranges::sort(left);
    const int parent = tree[f].parent;
    good = parent < 0 ? left.empty()
                      : parent > static_cast<int>(f) && std::ranges::includes(unknowns_of(tree[parent]), left);
  }
  for (auto* list : {&fronts, &expected}) std::ranges::sort(*list);
  for (auto* list : {&pivots, &expected_pivots}) std::ranges::sort(*list);
  return good && fronts == expected && pivots == expected_pivots;
}

int check(bool good, const char* what) {
  if (!good) std::printf("%s\n", what);
  return good ? 0 : 1;
}

}  // namespace

int main() {
  const std::vector<FrontStructure> tree = chain();
  PivotSurplus surplus(tree.size() + chain_fronts + 2, 1);
  const std::vector<FrontStructure> turned = balanced(tree, surplus);
  int failures = check(equivalent(tree, tree), "the chain is no tree");
  failures += check(equivalent(turned, tree), "another tree");
  failures += check(longest_path(tree) == chain_fronts, "the chain is no chain");
  failures += check(std::abs(longest_path(turned) - chain_fronts / 2) <= 1, "not half as long");
  surplus[2 * chain_fronts] = surplus[2 * chain_fronts + 1] = -1;  // the last front would come first
  failures += check(longest_path(balanced(tree, surplus)) == chain_fronts, "turned, though a front lacks its pivots");
  return failures;
}
