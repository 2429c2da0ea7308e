// Galler, Fischer: An improved equivalence algorithm, Communications of the ACM 7 (1964).
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

namespace dalembert {

// Disjoint sets of the numbers from zero on, initially single.
class DisjointSets {
 public:
  explicit DisjointSets(int count = 0) : parent_(static_cast<std::size_t>(count)) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  // The smallest number of a set.
  int of(int i) {
    while (parent_[static_cast<std::size_t>(i)] != i)
      i = parent_[static_cast<std::size_t>(i)] =
          parent_[static_cast<std::size_t>(parent_[static_cast<std::size_t>(i)])];
    return i;
  }
  // False: they are together.
  bool join(int i, int j) {
    const int a = of(i), b = of(j);
    parent_[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
    return a != b;
  }

 private:
  std::vector<int> parent_;
};

}  // namespace dalembert
