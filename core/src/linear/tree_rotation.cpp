// Liu: Equivalent sparse matrix reorderings by elimination tree rotations, SIAM J. Sci. Stat. Comput. 9 (1988).
#include "tree_rotation.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

namespace dalembert {

namespace {

// Shorter longest paths are not worth a rotation.
constexpr int shortest_path = 8;

std::size_t entries(const FrontStructure& front) {
  return front.pivots.size() * (front.pivots.size() + 2 * front.updates.size());
}

// Fronts stand in an order where each subtree is a range that ends with its root.
class TreeRotation {
 public:
  TreeRotation(std::vector<FrontStructure> tree, const PivotSurplus& brought);
  std::vector<FrontStructure> run();

 private:
  // The fronts between two roots, from the old one on, as they become, and the new root.
  struct Turn {
    std::vector<int> path;  // the last is the new root
    std::vector<FrontStructure> fronts;
  };

  int begin_of_subtree(int f) const { return f - count_[f] + 1; }
  Turn turn(int root);
  void split(const FrontStructure& front, const std::vector<int>& kept, FrontStructure& to);
  bool worth(const Turn& turn) const;
  bool has_pivots(const Turn& turn) const;
  int surplus(const std::vector<int>& unknowns) const;
  void append(std::vector<int>& order, int begin, int end) const;
  void append_turned(const Turn& turn);
  std::vector<FrontStructure> sorted();

  std::vector<FrontStructure> tree_;
  const PivotSurplus& brought_;
  // Per subtree: its fronts, those on its longest path, the child on that path, and the longest path without that
  // child.
  std::vector<int> count_, height_, deepest_, other_height_;
  std::vector<int> surplus_;  // per subtree: unknowns with a pivot minus those without
  std::vector<int> mark_;
  std::vector<int> order_;
};

TreeRotation::TreeRotation(std::vector<FrontStructure> tree, const PivotSurplus& brought)
    : tree_(std::move(tree)),
      brought_(brought),
      count_(tree_.size(), 1),
      height_(tree_.size(), 1),
      deepest_(tree_.size(), -1),
      other_height_(tree_.size(), 1),
      surplus_(tree_.size(), 0),
      mark_(brought.size(), -1) {
  for (int f = 0; f < static_cast<int>(tree_.size()); ++f) {
    surplus_[f] += surplus(tree_[f].pivots);
    const int parent = tree_[f].parent;
    if (parent < 0) continue;
    count_[parent] += count_[f];
    surplus_[parent] += surplus_[f];
    if (height_[f] < height_[parent]) {
      other_height_[parent] = std::max(other_height_[parent], height_[f] + 1);
    } else {
      other_height_[parent] = std::exchange(height_[parent], height_[f] + 1);
      deepest_[parent] = f;
    }
  }
}

int TreeRotation::surplus(const std::vector<int>& unknowns) const {
  int sum = 0;
  for (const int j : unknowns) sum += brought_[static_cast<std::size_t>(j)];
  return sum;
}

std::vector<FrontStructure> TreeRotation::run() {
  for (int root = 0; root < static_cast<int>(tree_.size()); ++root) {
    if (tree_[root].parent >= 0) continue;
    Turn turned = turn(root);
    if (!worth(turned) || !has_pivots(turned)) {
      append(order_, begin_of_subtree(root), root + 1);
      continue;
    }
    append_turned(turned);
    for (std::size_t i = 0; i < turned.path.size(); ++i) tree_[turned.path[i]] = std::move(turned.fronts[i]);
  }
  return sorted();
}

// Each front reverses the edge to its former child. The new root has no parent.
TreeRotation::Turn TreeRotation::turn(int root) {
  Turn turn{{root}, {}};
  for (int f = root; height_[f] > height_[root] / 2 + 1;) turn.path.push_back(f = deepest_[f]);
  for (std::size_t i = 0; i < turn.path.size(); ++i) {
    const bool last = i + 1 == turn.path.size();
    FrontStructure& to = turn.fronts.emplace_back();
    if (!last) to.parent = turn.path[i + 1];
    split(tree_[turn.path[i]], last ? std::vector<int>{} : tree_[turn.path[i + 1]].updates, to);
  }
  return turn;
}

void TreeRotation::split(const FrontStructure& front, const std::vector<int>& kept, FrontStructure& to) {
  for (const int j : kept) mark_[j] = kept.front();
  for (const auto& unknowns : {front.pivots, front.updates}) {
    for (const int j : unknowns) (!kept.empty() && mark_[j] == kept.front() ? to.updates : to.pivots).push_back(j);
  }
  for (const int j : kept) mark_[j] = -1;
}

// Shorter by a quarter at least, and no larger.
bool TreeRotation::worth(const Turn& turn) const {
  int height = 0;  // height of the rotated part
  std::size_t old_entries = 0, new_entries = 0;
  for (std::size_t i = 0; i < turn.path.size(); ++i) {
    const int f = turn.path[i];
    if (turn.fronts[i].pivots.empty()) return false;
    height = std::max(height + 1, other_height_[f]);
    old_entries += entries(tree_[f]);
    new_entries += entries(turn.fronts[i]);
  }
  const int before = height_[turn.path.front()], after = std::max(height, height_[turn.path.back()]);
  return before >= shortest_path && 4 * after <= 3 * before && new_entries <= old_entries;
}

bool TreeRotation::has_pivots(const Turn& turn) const {
  int from_before = 0;
  for (std::size_t i = 0; i + 1 < turn.path.size(); ++i) {
    const int f = turn.path[i], child = turn.path[i + 1];
    const int others = surplus_[f] - surplus_[child] - surplus(tree_[f].pivots);
    from_before += others + surplus(turn.fronts[i].pivots);
    if (from_before < 0) return false;
  }
  return true;
}

void TreeRotation::append(std::vector<int>& order, int begin, int end) const {
  order.resize(order.size() + static_cast<std::size_t>(end - begin));
  std::iota(order.end() - (end - begin), order.end(), begin);
}

void TreeRotation::append_turned(const Turn& turn) {
  std::vector<int> half, other;
  for (std::size_t i = 0; i + 1 < turn.path.size(); ++i) {
    const int f = turn.path[i], child = turn.path[i + 1];
    append(half, begin_of_subtree(f), begin_of_subtree(child));
    append(half, child + 1, f + 1);
  }
  const int root = turn.path.back(), child = deepest_[root];
  append(other, begin_of_subtree(child), child + 1);
  append(order_, begin_of_subtree(root), begin_of_subtree(child));
  append(order_, child + 1, root);
  for (std::size_t a = 0, b = 0; a < half.size() || b < other.size();) {
    const bool first = b * half.size() >= a * other.size() && a < half.size();
    order_.push_back(first ? half[a++] : other[b++]);
  }
  order_.push_back(root);
}

std::vector<FrontStructure> TreeRotation::sorted() {
  std::vector<int> place(order_.size());
  for (std::size_t k = 0; k < order_.size(); ++k) place[order_[k]] = static_cast<int>(k);
  std::vector<FrontStructure> fronts;
  fronts.reserve(order_.size());
  for (const int f : order_) {
    FrontStructure& front = fronts.emplace_back(std::move(tree_[f]));
    if (front.parent >= 0) front.parent = place[front.parent];
  }
  return fronts;
}

}  // namespace

std::vector<FrontStructure> balanced(std::vector<FrontStructure> tree, const PivotSurplus& brought) {
  return TreeRotation(std::move(tree), brought).run();
}

}  // namespace dalembert
