// Which spheres are near each other: a list of pairs that stays good as long as no sphere has moved farther than half of a skin.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dalembert/math/fixed.hpp"
#include "dalembert/system/workers.hpp"

namespace dalembert {

struct alignas(32) SphereAt {
  double x, y, z, radius;
};

class SphereNeighbours {
 public:
  // Pairs with a gap of up to `margin`, for these places. Threads share the search; what is found does not depend on them.
  void build(std::span<const SphereAt> spheres, double margin, Workers* workers);
  // Those of a sphere with larger numbers, ascending.
  std::span<const int> behind(int sphere) const {
    const std::size_t first = first_[static_cast<std::size_t>(sphere)];
    return {seconds_.data() + first, first_[static_cast<std::size_t>(sphere) + 1] - first};
  }
  std::size_t pairs() const { return seconds_.size(); }
  void clear(std::size_t spheres);

 private:
  struct Grid;
  struct Pair {
    int first, second;
  };
  std::vector<std::size_t> first_;
  std::vector<int> seconds_;
  std::vector<std::vector<Pair>> found_;  // by stretches of spheres in the order of cells
};

}  // namespace dalembert
