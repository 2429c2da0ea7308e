// Amestoy, Davis, Duff: An approximate minimum degree ordering algorithm, SIAM J. Matrix Analysis 17 (1996).
// Davis, Gilbert, Larimore, Ng: A column approximate minimum degree ordering algorithm, ACM TOMS 30 (2004).
#include "elimination_order.hpp"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>

namespace dalembert {

namespace {

using Graph = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;
using Permutation = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int>;

// The neighbour with which each unknown without a diagonal entry is eliminated; -1: alone.
std::vector<int> partners(const Pattern& pattern, std::span<const double> values) {
  const int n = pattern.size();
  const auto starts = pattern.column_start(), rows = pattern.row_index();
  std::vector<double> diagonal(n, 0.0);
  for (int j = 0; j < n; ++j) diagonal[j] = std::abs(values[pattern.slot(j, j)]);
  std::vector<int> partner(n, -1);
  for (int j = 0; j < n; ++j) {
    if (diagonal[j] != 0) continue;
    double largest = 0;
    int best = -1;
    for (int k = starts[j]; k < starts[j + 1]; ++k) {
      const int i = rows[k];
      if (diagonal[i] == 0 || partner[i] != -1) continue;
      if (const double size = std::abs(values[k]); size > largest) {
        largest = size;
        best = i;
      }
    }
    if (best == -1) continue;
    partner[j] = best;
    partner[best] = j;
  }
  return partner;
}

}  // namespace

EliminationOrder paired_minimum_degree_order(const Pattern& pattern, std::span<const double> values) {
  const int n = pattern.size();
  const auto starts = pattern.column_start(), rows = pattern.row_index();
  const std::vector<int> partner = partners(pattern, values);
  std::vector<int> group(n, -1);
  std::vector<std::vector<int>> members;
  for (int j = 0; j < n; ++j) {
    if (group[j] != -1) continue;
    group[j] = static_cast<int>(members.size());
    members.push_back({j});
    if (const int p = partner[j]; p != -1) {
      group[p] = group[j];
      // The one with a diagonal entry first.
      values[pattern.slot(j, j)] != 0 ? members.back().push_back(p) : members.back().assign({p, j});
    }
  }
  std::vector<Eigen::Triplet<double>> edges;
  for (int j = 0; j < n; ++j) {
    for (int k = starts[j]; k < starts[j + 1]; ++k) edges.emplace_back(group[rows[k]], group[j], 1.0);
  }
  const int groups = static_cast<int>(members.size());
  Graph graph(groups, groups);
  graph.setFromTriplets(edges.begin(), edges.end());
  Permutation permutation;
  Eigen::AMDOrdering<int>()(graph, permutation);
  EliminationOrder order;
  order.reserve(static_cast<std::size_t>(n));
  for (int k = 0; k < groups; ++k) {
    const auto& next = members[static_cast<std::size_t>(permutation.indices()[k])];
    order.insert(order.end(), next.begin(), next.end());
  }
  return order;
}

EliminationOrder column_order(const Pattern& pattern) {
  const int n = pattern.size();
  const auto starts = pattern.column_start(), rows = pattern.row_index();
  Graph graph(n, n);
  graph.resizeNonZeros(static_cast<Eigen::Index>(rows.size()));
  std::copy(starts.begin(), starts.end(), graph.outerIndexPtr());
  std::copy(rows.begin(), rows.end(), graph.innerIndexPtr());
  std::fill_n(graph.valuePtr(), rows.size(), 1.0);
  Permutation permutation;
  Eigen::COLAMDOrdering<int>()(graph, permutation);
  EliminationOrder order(static_cast<std::size_t>(n));
  for (int j = 0; j < n; ++j) order[static_cast<std::size_t>(permutation.indices()[j])] = j;
  return order;
}

}  // namespace dalembert
