// Neighbouring spheres: a list of pairs that is valid until a sphere has moved farther than half of a skin.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dalembert/math/fixed.hpp"
#include "dalembert/math/large_memory.hpp"
#include "dalembert/system/workers.hpp"

namespace dalembert {

// Calls task(i) for all i below `tasks`; without workers, one after the other.
template <class Task>
void share_tasks(Workers* workers, int tasks, Task&& task) {
  if (workers != nullptr && tasks > 1) return workers->run(tasks, task);
  for (int i = 0; i < tasks; ++i) task(i);
}

struct alignas(32) SphereAt {
  double x, y, z, radius;
};

class SphereNeighbours {
 public:
  // Computes pairs with a gap of up to `margin`. Threads share the search; the result does not depend on them.
  void build(std::span<const SphereAt> spheres, double margin, Workers* workers);
  // Neighbours of a sphere with larger numbers, ascending.
  std::span<const int> behind(int sphere) const { return behind(sphere, sphere + 1); }
  // Neighbours of the spheres from `begin` to `end`, one after the other.
  std::span<const int> behind(int begin, int end) const {
    const std::size_t first = first_[static_cast<std::size_t>(begin)];
    return {seconds_.data() + first, first_[static_cast<std::size_t>(end)] - first};
  }
  std::size_t pairs() const { return seconds_.size(); }
  void clear(std::size_t spheres);

 private:
  struct Pair {
    int first, second;
  };
  void sort_pairs(std::size_t spheres, Workers* workers);

  std::vector<std::size_t> first_;
  LargeVector<int> seconds_;
  std::vector<LargeVector<Pair>> found_;  // found pairs by range of spheres
};

}  // namespace dalembert
