// Hopcroft, Tarjan: Efficient algorithms for graph manipulation, Communications of the ACM 16 (1973), for blocks of a graph.
#include "constraints/constraint_blocks.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "dalembert/math/disjoint_sets.hpp"
#include "dalembert/solvers/numerical_tangent.hpp"

namespace dalembert {

namespace {

// Of an undirected graph without parallel edges: the block of each edge. The last vertex is the root where it can be; blocks nearer to a root
// have higher numbers.
class GraphBlocks {
 public:
  GraphBlocks(int vertices, const std::vector<std::pair<int, int>>& edges)
      : edges_(edges), at_(static_cast<std::size_t>(vertices)), number_(at_.size(), 0), low_(at_.size(), 0), next_(at_.size(), 0), block_(edges.size(), -1) {
    for (int e = 0; e < static_cast<int>(edges.size()); ++e) {
      at_[edges[e].first].push_back(e);
      at_[edges[e].second].push_back(e);
    }
    for (int v = vertices - 1; v >= 0; --v)
      if (number_[v] == 0) search(v);
  }
  const std::vector<int>& of_edges() const { return block_; }
  int hangs_on(int block) const { return hangs_on_[block]; }

 private:
  struct Visit {
    int vertex, by;  // edge; -1: the first one
  };
  void search(int root) {
    std::vector<Visit> path{{root, -1}};
    number_[root] = low_[root] = ++visited_;
    while (!path.empty()) {
      const auto [v, by] = path.back();
      if (next_[v] < at_[v].size()) {
        go_along(at_[v][next_[v]++], v, by, path);
        continue;
      }
      path.pop_back();
      if (by < 0) continue;
      const int u = path.back().vertex;
      low_[u] = std::min(low_[u], low_[v]);
      if (low_[v] >= number_[u]) close_block(by, u);
    }
  }
  void go_along(int edge, int v, int by, std::vector<Visit>& path) {
    const int w = edges_[edge].first == v ? edges_[edge].second : edges_[edge].first;
    if (edge == by || (number_[w] != 0 && number_[w] >= number_[v])) return;
    open_.push_back(edge);
    if (number_[w] != 0) {
      low_[v] = std::min(low_[v], number_[w]);
      return;
    }
    number_[w] = low_[w] = ++visited_;
    path.push_back({w, edge});
  }
  void close_block(int first, int vertex) {
    int edge = -1;
    do {
      edge = open_.back();
      open_.pop_back();
      block_[edge] = blocks_;
    } while (edge != first);
    hangs_on_.push_back(vertex);
    ++blocks_;
  }

  const std::vector<std::pair<int, int>>& edges_;
  std::vector<std::vector<int>> at_;
  std::vector<int> number_, low_;
  std::vector<std::size_t> next_;
  std::vector<int> open_, block_, hangs_on_;
  int visited_ = 0, blocks_ = 0;
};

// The group of each row, in the order in which groups begin.
std::vector<ConstraintBlock> lists_of(DisjointSets& groups, int rows) {
  std::vector<ConstraintBlock> lists;
  std::vector<int> list(static_cast<std::size_t>(rows), -1);
  for (int i = 0; i < rows; ++i) {
    int& number = list[groups.of(i)];
    if (number < 0) {
      number = static_cast<int>(lists.size());
      lists.emplace_back();
    }
    lists[number].rows.push_back(i);
  }
  return lists;
}

}  // namespace

std::vector<ConstraintBlock> constraint_blocks(BlocksOf kind, const Pattern& pattern, std::span<const double> values, int first_ae,
                                               std::span<const int> nodes, std::span<const int> rows) {
  const int count = static_cast<int>(rows.size()), ode2 = static_cast<int>(nodes.size());
  std::vector<int> place(static_cast<std::size_t>(pattern.size() - first_ae), -1);
  for (int i = 0; i < count; ++i) place[rows[i]] = i;
  std::vector<std::vector<int>> coordinates(rows.size());
  for_each_entry(pattern, [&](int row, int column, std::size_t slot) {
    if (row < ode2 && column >= first_ae && place[column - first_ae] >= 0 && values[slot] != 0) coordinates[place[column - first_ae]].push_back(row);
  });
  DisjointSets groups(count);
  if (kind == BlocksOf::coordinates) {
    std::vector<int> acts(static_cast<std::size_t>(ode2), -1);
    for (int i = 0; i < count; ++i)
      for (const int j : coordinates[i]) {
        if (acts[j] >= 0) groups.join(i, acts[j]);
        acts[j] = i;
      }
    return lists_of(groups, count);
  }
  // Equations are edges between nodes, or from a node to the ground, which comes last.
  const int ground = nodes.empty() ? 0 : *std::ranges::max_element(nodes) + 1;
  std::map<std::pair<int, int>, int> numbers;
  std::vector<std::pair<int, int>> edges;
  std::vector<std::vector<int>> edges_of(rows.size());
  for (int i = 0; i < count; ++i) {
    std::vector<int> on;
    for (const int j : coordinates[i]) on.push_back(nodes[j]);
    std::ranges::sort(on);
    on.erase(std::unique(on.begin(), on.end()), on.end());
    if (on.size() == 1) on.push_back(ground);
    for (std::size_t k = 1; k < on.size(); ++k) {
      const auto [known, is_new] = numbers.try_emplace({on[k - 1], on[k]}, static_cast<int>(edges.size()));
      if (is_new) edges.push_back(known->first);
      edges_of[i].push_back(known->second);
    }
  }
  const GraphBlocks graph(ground + 1, edges);
  std::vector<int> first_of_block(edges.size(), -1), block_of(rows.size(), -1);
  for (int i = 0; i < count; ++i)
    for (const int e : edges_of[i]) {
      const int block = graph.of_edges()[e];
      int& first = first_of_block[block];
      if (first >= 0) groups.join(i, first);
      first = i;
      block_of[i] = std::max(block_of[i], block);
    }
  std::vector<ConstraintBlock> blocks = lists_of(groups, count);
  for (ConstraintBlock& block : blocks) {
    int nearest = -1;
    for (const int i : block.rows) nearest = std::max(nearest, block_of[i]);
    if (nearest >= 0 && graph.hangs_on(nearest) != ground) block.hangs_on = graph.hangs_on(nearest);
  }
  return blocks;
}

}  // namespace dalembert
