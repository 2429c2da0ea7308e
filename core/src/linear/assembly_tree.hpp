// Multifrontal elimination of a sparse symmetric pattern: pivots and update rows of each front, and its parent.
#pragma once

#include <vector>

#include "dalembert/system/pattern.hpp"
#include "elimination_order.hpp"

namespace dalembert {

struct FrontStructure {
  std::vector<int> pivots;   // unknowns, in the order of their elimination
  std::vector<int> updates;  // unknowns that are eliminated later
  int parent = -1;           // the front that takes over the updates; it comes later
};

// Fronts in an order of elimination. Small ones are united where the time of a front is more than that of the additional zeros.
std::vector<FrontStructure> assembly_tree(const Pattern& pattern, const EliminationOrder& order);

// Assigns the entries of the matrix to fronts: to the first front that eliminates one of their unknowns.
class FrontEntries {
 public:
  FrontEntries(const Pattern& pattern, const std::vector<FrontStructure>& tree);

  // Calls f(row, column, slot) for each entry of a front.
  template <class F>
  void for_each(int front, F&& f) const {
    for (const int j : tree_[front].pivots) {
      for (int k = pattern_.column_start()[j]; k < pattern_.column_start()[j + 1]; ++k) {
        const int i = pattern_.row_index()[k];
        if (owner_[i] < front) continue;
        f(i, j, k);
        if (owner_[i] > front) f(j, i, transposed_[k]);
      }
    }
  }

 private:
  const Pattern& pattern_;
  const std::vector<FrontStructure>& tree_;
  std::vector<int> owner_;
  std::vector<int> transposed_;  // slot of the entry opposite to each one
};

}  // namespace dalembert
