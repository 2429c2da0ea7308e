// Large systems are divided into regions, which threads evaluate independently.
// Consecutive nodes, in the order of their numbers, make up a region; two regions form a larger one, up to the whole
// system. An item belongs to the smallest region that contains all of its coordinates. Regions of one size share no
// coordinates: their items may be evaluated at the same time, those of the larger regions around them afterwards. The
// order of the terms of each sum is therefore independent of the number of threads.
#pragma once

#include <span>
#include <vector>

#include "dalembert/system/state.hpp"

namespace dalembert {

// Granularity of the division. The defaults gave the fastest evaluations.
struct Division {
  int coordinates = 2000;  // lower bound for a smallest region: large enough for a thread, small enough for its cache
  // lower bound for regions of one size that threads share: waking threads takes as long as some hundred entries
  int entries = 2000;
  bool operator==(const Division&) const = default;
};

class Regions {
 public:
  static constexpr int whole = 0;  // the region of everything
  static constexpr int none = -1;  // region of items without coordinates

  Regions() = default;
  // Smallest regions have so many ODE2 coordinates at least.
  Regions(std::span<const Sizes> nodes, int coordinates);

  // A binary tree, level by level: regions 2 i + 1 and 2 i + 2 lie in i.
  int count() const { return 2 * smallest_ - 1; }
  int of_node(int node) const { return of_node_[static_cast<std::size_t>(node)]; }
  // About how many of so many items lie in a region: they spread over the smallest ones, but for a few on the seams.
  int expected(int region, int items) const { return region < smallest_ - 1 ? 0 : items / smallest_ + 1; }
  // The smallest region that contains two regions.
  static int around(int a, int b);

 private:
  int smallest_ = 1;  // number of smallest regions
  std::vector<int> of_node_;
};

}  // namespace dalembert
