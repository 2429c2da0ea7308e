// Large systems are divided into regions, so that threads can work side by side without meeting.
//
// Nodes next to each other, in the order of their numbers, make up a region; two regions lie in a larger one, up to the
// whole system. An item lies in the smallest region that holds all of its coordinates. Regions of one size share no
// coordinates: their items may be evaluated at the same time, those of the larger regions around them afterwards. The
// order of the terms of each sum follows, whatever the number of threads.
#pragma once

#include <span>
#include <vector>

#include "dalembert/system/state.hpp"

namespace dalembert {

// How far a system is divided. As it stands here, evaluations gain from it.
struct Division {
  int coordinates = 2000;  // of a smallest region at least: it is worth a thread's while, and stays in its cache
  int entries = 2000;      // in regions of one size at least, if threads are to share them: calling them takes as long as some hundred
};

class Regions {
 public:
  static constexpr int whole = 0;   // the region of everything
  static constexpr int none = -1;   // of what has no coordinates

  Regions() = default;
  // Smallest regions have so many ODE2 coordinates at least.
  Regions(std::span<const Sizes> nodes, int coordinates);

  // A binary tree, level by level: regions 2 i + 1 and 2 i + 2 lie in i.
  int count() const { return 2 * smallest_ - 1; }
  int of_node(int node) const { return of_node_[static_cast<std::size_t>(node)]; }
  // About how many of so many items lie in a region: they spread over the smallest ones, but for a few on the seams.
  int expected(int region, int items) const { return region < smallest_ - 1 ? 0 : items / smallest_ + 1; }
  // The smallest region that holds two others.
  static int around(int a, int b);

 private:
  int smallest_ = 1;  // how many regions hold no others
  std::vector<int> of_node_;
};

}  // namespace dalembert
