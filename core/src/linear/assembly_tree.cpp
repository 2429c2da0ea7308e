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

// Nanoseconds, roughly, of a front with p pivots and u updates: its own, per entry, per entry handed on, per operation.
// Entries handed on count for more than their time: where there are multipliers, larger fronts have better pivots to choose from.
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
  void group_equal_columns(const Pattern& pattern);
  void connect(const Pattern& pattern);
  void find_parents();
  void sort_by_tree();
  std::vector<int> count_entries();
  void find_supernodes();
  void find_updates();
  void unite();
  void sort_children();

  // Calls f with the position of each neighbour of the group at a position.
  template <class F>
  void neighbours(int position, F&& f) const {
    const int g = order_[position];
    for (int k = first_neighbour_[g]; k < first_neighbour_[g + 1]; ++k) f(position_[neighbours_[k]]);
  }
  int unknowns_at(int position) const { return first_unknown_[order_[position] + 1] - first_unknown_[order_[position]]; }
  int count_unknowns(const std::vector<int>& positions) const;

  struct Supernode {
    std::vector<int> pivots, updates, children;  // positions; supernodes
    int parent = -1;
    int pivot_count = 0, update_count = 0;  // of unknowns
    double left = 0, peak = 0;  // memory, of what the parent takes over, and the most that the elimination of the subtree needs
  };

  const EliminationOrder& unknowns_;
  std::vector<int> first_unknown_, first_neighbour_, neighbours_;  // of each group, and the end
  int size_;                                                       // number of groups
  std::vector<int> order_, position_, parent_;
  std::vector<Supernode> supernodes_;
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

int TreeBuilder::count_unknowns(const std::vector<int>& positions) const {
  int count = 0;
  for (const int k : positions) count += unknowns_at(k);
  return count;
}

// The elimination tree: the parent of a group is the first one that its elimination couples with others.
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
    if (!continues) supernodes_.emplace_back();
    supernodes_.back().pivots.push_back(k);
    of[k] = static_cast<int>(supernodes_.size()) - 1;
  }
  for (int s = 0; s < static_cast<int>(supernodes_.size()); ++s) {
    const int above = parent_[supernodes_[s].pivots.back()];
    if (above < 0) continue;
    supernodes_[s].parent = of[above];
    supernodes_[of[above]].children.push_back(s);
  }
}

void TreeBuilder::find_updates() {
  std::vector<int> mark(static_cast<std::size_t>(size_), -1);
  for (int s = 0; s < static_cast<int>(supernodes_.size()); ++s) {
    Supernode& node = supernodes_[s];
    const int last = node.pivots.back();
    const auto add = [&](int k) {
      if (k <= last || mark[k] == s) return;
      mark[k] = s;
      node.updates.push_back(k);
    };
    for (const int k : node.pivots) neighbours(k, add);
    for (const int child : node.children) std::ranges::for_each(supernodes_[child].updates, add);
    std::sort(node.updates.begin(), node.updates.end());
    node.pivot_count = count_unknowns(node.pivots);
    node.update_count = count_unknowns(node.updates);
  }
}

// From the leaves on, each front takes in the children that are cheaper as a part of it.
void TreeBuilder::unite() {
  for (Supernode& node : supernodes_) {
    for (;;) {
      const double p = node.pivot_count, u = node.update_count;
      double best = 0;
      int taken = -1;
      for (const int c : node.children) {
        const Supernode& child = supernodes_[c];
        const double more = child.pivot_count;
        const double gain = cost(p, u) + cost(more, child.update_count) - cost(p + more, u);
        if (gain > best) {
          best = gain;
          taken = c;
        }
      }
      if (taken < 0) break;
      Supernode& child = supernodes_[taken];
      node.pivot_count += child.pivot_count;
      node.pivots.insert(node.pivots.begin(), child.pivots.begin(), child.pivots.end());
      std::erase(node.children, taken);
      node.children.insert(node.children.end(), child.children.begin(), child.children.end());
    }
  }
}

// Children in the order that needs the least memory for what waits for the parent. Liu: On the storage requirement in the
// out-of-core multifrontal method for sparse factorization, ACM TOMS 12 (1986).
void TreeBuilder::sort_children() {
  for (Supernode& node : supernodes_) {
    std::ranges::sort(node.children, std::greater(), [&](int c) { return supernodes_[c].peak - supernodes_[c].left; });
    double waiting = 0;
    for (const int c : node.children) {
      node.peak = std::max(node.peak, waiting + supernodes_[c].peak);
      waiting += supernodes_[c].left;
    }
    const double size = node.pivot_count + node.update_count;
    node.left = size * node.update_count;
    node.peak = std::max(node.peak, waiting + size * size);
  }
}

std::vector<FrontStructure> TreeBuilder::build() {
  find_parents();
  sort_by_tree();
  find_supernodes();
  find_updates();
  unite();
  sort_children();
  std::vector<FrontStructure> fronts;
  std::vector<int> front_of(supernodes_.size(), -1), stack;
  std::vector<std::size_t> visited(supernodes_.size(), 0);
  const auto unknowns = [&](const std::vector<int>& positions) {
    std::vector<int> result;
    for (const int k : positions) {
      const auto first = unknowns_.begin() + first_unknown_[order_[k]];
      result.insert(result.end(), first, first + unknowns_at(k));
    }
    return result;
  };
  for (int root = 0; root < static_cast<int>(supernodes_.size()); ++root) {
    if (supernodes_[root].parent >= 0) continue;
    stack.push_back(root);
    while (!stack.empty()) {
      const int s = stack.back();
      const Supernode& node = supernodes_[s];
      if (visited[s] < node.children.size()) {
        stack.push_back(node.children[visited[s]++]);
        continue;
      }
      stack.pop_back();
      front_of[s] = static_cast<int>(fronts.size());
      for (const int child : node.children) fronts[front_of[child]].parent = front_of[s];
      fronts.push_back({unknowns(node.pivots), unknowns(node.updates), -1});
    }
  }
  return fronts;
}

}  // namespace

std::vector<FrontStructure> assembly_tree(const Pattern& pattern, const EliminationOrder& order) {
  return TreeBuilder(pattern, order).build();
}

FrontEntries::FrontEntries(const Pattern& pattern, const std::vector<FrontStructure>& tree)
    : pattern_(pattern), tree_(tree), owner_(static_cast<std::size_t>(pattern.size())) {
  // Columns are visited in the order of the rows opposite to them.
  const auto starts = pattern.column_start();
  std::vector<int> next(starts.begin(), starts.end() - 1);
  transposed_.reserve(pattern.row_index().size());
  for (const int row : pattern.row_index()) transposed_.push_back(next[row]++);
  for (int f = 0; f < static_cast<int>(tree.size()); ++f) {
    for (const int j : tree[f].pivots) owner_[j] = f;
  }
}

}  // namespace dalembert
