// Liu: The role of elimination trees in sparse factorization, SIAM J. Matrix Analysis 11 (1990).
// Ashcraft, Grimes: The influence of relaxed supernode partitions on the multifrontal method, ACM TOMS 15 (1989).
#include "assembly_tree.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <utility>

namespace dalembert {

namespace {

// Approximate time in nanoseconds of a front with p pivots and u updates: constant, per entry, per entry of the
// update matrix, per operation. Entries of the update matrix have an increased weight: if there are multipliers,
// larger fronts offer better pivots.
double cost(double p, double u) {
  const double m = p + u;
  return 60 + 0.25 * m * m + 0.7 * u * u + (m * m * m - u * u * u) * (2.0 / 3) / 20;
}

// Works with groups of unknowns that have the same columns and follow each other.
class TreeBuilder {
 public:
  TreeBuilder(const Pattern& pattern, const EliminationOrder& order);
  std::vector<FrontStructure> build();

 private:
  struct Supernode {
    int first_pivot, end_of_pivots;            // positions
    int first_update = 0, end_of_updates = 0;  // in updates_
    int parent = -1;
    int first_child = -1, last_child = -1, next_sibling = -1;
    int first_part, next_part = -1;         // supernodes whose pivots make up a front
    int pivot_count = 0, update_count = 0;  // of unknowns
    double left = 0, peak = 0;  // memory: left for the parent, and the maximum during the elimination of the subtree
  };

  void group_equal_columns(const Pattern& pattern);
  void connect(const Pattern& pattern);
  void find_parents();
  void sort_by_tree();
  std::vector<int> count_entries();
  void find_supernodes();
  void append_children(Supernode& node, int first, int last);
  void find_updates();
  void unite();
  void take_in(int s, int child);
  void sort_children();
  FrontStructure front(const Supernode& node) const;

  // Calls f with the position of each neighbour of the group at a position.
  template <class F>
  void neighbours(int position, F&& f) const {
    const int g = order_[position];
    for (int k = first_neighbour_[g]; k < first_neighbour_[g + 1]; ++k) f(position_[neighbours_[k]]);
  }
  int unknowns_at(int position) const {
    return first_unknown_[order_[position] + 1] - first_unknown_[order_[position]];
  }

  template <class F>
  void for_each_child(const Supernode& node, F&& f) const {
    for (int c = node.first_child; c >= 0; c = supernodes_[c].next_sibling) f(c);
  }

  const EliminationOrder& unknowns_;
  std::vector<int> first_unknown_, first_neighbour_, neighbours_;  // ranges of each group, and the end
  int size_;                                                       // number of groups
  std::vector<int> order_, position_, parent_;
  std::vector<Supernode> supernodes_;
  std::vector<int> updates_;  // positions
};

TreeBuilder::TreeBuilder(const Pattern& pattern, const EliminationOrder& order) : unknowns_(order) {
  group_equal_columns(pattern);
  size_ = static_cast<int>(first_unknown_.size()) - 1;
  connect(pattern);
  order_.resize(static_cast<std::size_t>(size_));
  std::iota(order_.begin(), order_.end(), 0);
  position_ = parent_ = order_;
}

void TreeBuilder::group_equal_columns(const Pattern& pattern) {
  const auto column = [&](int j) {
    const int begin = pattern.column_start()[j];
    return pattern.row_index().subspan(begin, pattern.column_start()[j + 1] - begin);
  };
  for (int k = 0; k < pattern.size(); ++k) {
    if (k == 0 || !std::ranges::equal(column(unknowns_[k - 1]), column(unknowns_[k]))) first_unknown_.push_back(k);
  }
  first_unknown_.push_back(pattern.size());
}

void TreeBuilder::connect(const Pattern& pattern) {
  std::vector<int> group(unknowns_.size()), mark(static_cast<std::size_t>(size_), -1);
  for (int g = 0; g < size_; ++g) {
    for (int k = first_unknown_[g]; k < first_unknown_[g + 1]; ++k) group[unknowns_[k]] = g;
  }
  for (int g = 0; g < size_; ++g) {
    first_neighbour_.push_back(static_cast<int>(neighbours_.size()));
    const int j = unknowns_[first_unknown_[g]];
    for (int k = pattern.column_start()[j]; k < pattern.column_start()[j + 1]; ++k) {
      const int other = group[pattern.row_index()[k]];
      if (std::exchange(mark[other], g) != g) neighbours_.push_back(other);
    }
  }
  first_neighbour_.push_back(static_cast<int>(neighbours_.size()));
}

// The elimination tree: the parent of a group is the first group in its column structure.
void TreeBuilder::find_parents() {
  for (int k = 0; k < size_; ++k) position_[order_[k]] = k;
  std::vector<int> root(static_cast<std::size_t>(size_), -1);
  std::fill(parent_.begin(), parent_.end(), -1);
  for (int k = 0; k < size_; ++k) {
    neighbours(k, [&](int i) {
      while (i >= 0 && i < k) {
        const int next = root[i];
        root[i] = k;
        if (next < 0) parent_[i] = k;
        i = next;
      }
    });
  }
}

// Changes the order so that each subtree is eliminated in one go.
void TreeBuilder::sort_by_tree() {
  std::vector<int> first_child(static_cast<std::size_t>(size_), -1), next(first_child), stack, sorted;
  for (int k = size_ - 1; k >= 0; --k) {
    if (parent_[k] < 0) continue;
    next[k] = first_child[parent_[k]];
    first_child[parent_[k]] = k;
  }
  sorted.reserve(static_cast<std::size_t>(size_));
  for (int root = 0; root < size_; ++root) {
    if (parent_[root] >= 0) continue;
    stack.push_back(root);
    while (!stack.empty()) {
      const int k = stack.back();
      if (const int child = first_child[k]; child >= 0) {
        first_child[k] = next[child];
        stack.push_back(child);
      } else {
        stack.pop_back();
        sorted.push_back(order_[k]);
      }
    }
  }
  order_ = std::move(sorted);
  find_parents();
}

// Entries of the last column of L of each group, without the diagonal.
std::vector<int> TreeBuilder::count_entries() {
  std::vector<int> count(static_cast<std::size_t>(size_), 0), mark(static_cast<std::size_t>(size_), -1);
  for (int row = 0; row < size_; ++row) {
    mark[row] = row;
    neighbours(row, [&](int k) {
      if (k > row) return;
      for (; mark[k] != row; k = parent_[k]) {
        mark[k] = row;
        count[k] += unknowns_at(row);
      }
    });
  }
  return count;
}

// Chains of the tree whose columns of L have the same rows.
void TreeBuilder::find_supernodes() {
  const std::vector<int> count = count_entries();
  std::vector<int> of(static_cast<std::size_t>(size_));
  for (int k = 0; k < size_; ++k) {
    const bool continues = k > 0 && parent_[k - 1] == k && count[k - 1] == count[k] + unknowns_at(k);
    const int next = static_cast<int>(supernodes_.size());
    if (!continues) supernodes_.push_back({.first_pivot = k, .end_of_pivots = k, .first_part = next});
    Supernode& node = supernodes_.back();
    ++node.end_of_pivots;
    node.pivot_count += unknowns_at(k);
    of[k] = static_cast<int>(supernodes_.size()) - 1;
  }
  for (int s = 0; s < static_cast<int>(supernodes_.size()); ++s) {
    const int above = parent_[supernodes_[s].end_of_pivots - 1];
    if (above < 0) continue;
    supernodes_[s].parent = of[above];
    append_children(supernodes_[of[above]], s, s);
  }
}

// A list of siblings.
void TreeBuilder::append_children(Supernode& node, int first, int last) {
  if (first < 0) return;
  (node.last_child >= 0 ? supernodes_[node.last_child].next_sibling : node.first_child) = first;
  node.last_child = last;
}

void TreeBuilder::find_updates() {
  std::vector<int> mark(static_cast<std::size_t>(size_), -1);
  for (int s = 0; s < static_cast<int>(supernodes_.size()); ++s) {
    Supernode& node = supernodes_[s];
    const int last = node.end_of_pivots - 1;
    const auto add = [&](int k) {
      if (k <= last || mark[k] == s) return;
      mark[k] = s;
      node.update_count += unknowns_at(k);
      updates_.push_back(k);
    };
    node.first_update = static_cast<int>(updates_.size());
    for (int k = node.first_pivot; k <= last; ++k) neighbours(k, add);
    for_each_child(node, [&](int child) {
      for (int k = supernodes_[child].first_update; k < supernodes_[child].end_of_updates; ++k) add(updates_[k]);
    });
    node.end_of_updates = static_cast<int>(updates_.size());
    std::sort(updates_.begin() + node.first_update, updates_.end());
  }
}

// From the leaves on, each front absorbs children if this is cheaper.
void TreeBuilder::unite() {
  for (int s = 0; s < static_cast<int>(supernodes_.size()); ++s) {
    Supernode& node = supernodes_[s];
    for (;;) {
      const double p = node.pivot_count, u = node.update_count;
      double best = 0;
      int taken = -1;
      for_each_child(node, [&](int c) {
        const double more = supernodes_[c].pivot_count;
        const double gain = cost(p, u) + cost(more, supernodes_[c].update_count) - cost(p + more, u);
        if (gain > best) {
          best = gain;
          taken = c;
        }
      });
      if (taken < 0) break;
      take_in(s, taken);
    }
  }
}

// The pivots of the child come first, its children last.
void TreeBuilder::take_in(int s, int child) {
  Supernode &node = supernodes_[s], &taken = supernodes_[child];
  node.pivot_count += taken.pivot_count;
  taken.next_part = node.first_part;
  node.first_part = taken.first_part;
  int before = -1;
  for_each_child(node, [&](int c) {
    if (supernodes_[c].next_sibling == child) before = c;
  });
  (before >= 0 ? supernodes_[before].next_sibling : node.first_child) = taken.next_sibling;
  if (node.last_child == child) node.last_child = before;
  append_children(node, std::exchange(taken.first_child, -1), std::exchange(taken.last_child, -1));
}

// Children in the order that needs the least memory for waiting update matrices. Liu: On the storage requirement in
// the out-of-core multifrontal method for sparse factorization, ACM TOMS 12 (1986).
void TreeBuilder::sort_children() {
  std::vector<int> children;
  for (Supernode& node : supernodes_) {
    children.clear();
    for_each_child(node, [&](int c) { children.push_back(c); });
    std::ranges::sort(children, std::greater(), [&](int c) { return supernodes_[c].peak - supernodes_[c].left; });
    node.first_child = node.last_child = -1;
    double waiting = 0;
    for (const int c : children) {
      supernodes_[c].next_sibling = -1;
      append_children(node, c, c);
      node.peak = std::max(node.peak, waiting + supernodes_[c].peak);
      waiting += supernodes_[c].left;
    }
    const double size = node.pivot_count + node.update_count;
    node.left = size * node.update_count;
    node.peak = std::max(node.peak, waiting + size * size);
  }
}

FrontStructure TreeBuilder::front(const Supernode& node) const {
  FrontStructure front;
  front.pivots.reserve(static_cast<std::size_t>(node.pivot_count));
  front.updates.reserve(static_cast<std::size_t>(node.update_count));
  const auto add = [&](std::vector<int>& to, int position) {
    const auto first = unknowns_.begin() + first_unknown_[order_[position]];
    to.insert(to.end(), first, first + unknowns_at(position));
  };
  for (int part = node.first_part; part >= 0; part = supernodes_[part].next_part) {
    for (int k = supernodes_[part].first_pivot; k < supernodes_[part].end_of_pivots; ++k) add(front.pivots, k);
  }
  for (int k = node.first_update; k < node.end_of_updates; ++k) add(front.updates, updates_[k]);
  return front;
}

std::vector<FrontStructure> TreeBuilder::build() {
  find_parents();
  sort_by_tree();
  find_supernodes();
  find_updates();
  unite();
  sort_children();
  std::vector<FrontStructure> fronts;
  std::vector<int> front_of(supernodes_.size(), -1), stack, next_child;
  for (const Supernode& node : supernodes_) next_child.push_back(node.first_child);
  for (int root = 0; root < static_cast<int>(supernodes_.size()); ++root) {
    if (supernodes_[root].parent >= 0) continue;
    stack.push_back(root);
    while (!stack.empty()) {
      const int s = stack.back();
      if (const int child = next_child[s]; child >= 0) {
        stack.push_back(child);
        next_child[s] = supernodes_[child].next_sibling;
        continue;
      }
      stack.pop_back();
      front_of[s] = static_cast<int>(fronts.size());
      for_each_child(supernodes_[s], [&](int child) { fronts[front_of[child]].parent = front_of[s]; });
      fronts.push_back(front(supernodes_[s]));
    }
  }
  return fronts;
}

}  // namespace

std::vector<FrontStructure> assembly_tree(const Pattern& pattern, const EliminationOrder& order) {
  return TreeBuilder(pattern, order).build();
}

FrontEntries::FrontEntries(const Pattern& pattern, const std::vector<FrontStructure>& tree)
    : pattern_(pattern),
      tree_(tree),
      owner_(static_cast<std::size_t>(pattern.size())),
      transposed_(pattern.row_index().size()) {
  pattern.for_each_transposed([to = transposed_.data()](int slot, int transposed) { to[slot] = transposed; });
  for (int f = 0; f < static_cast<int>(tree.size()); ++f) {
    for (const int j : tree[f].pivots) owner_[j] = f;
  }
}

}  // namespace dalembert
