// The memory of stick-slip friction (StickSlip in laws/friction.hpp) in general contact. A bristle is rooted in both bodies; the distance of its roots
// in the plane of contact is its stretch.
#pragma once

#include <cstddef>
#include <numeric>
#include <span>
#include <vector>

#include "dalembert/frames.hpp"

namespace dalembert {

struct Bristle {
  Vec3<double> root0, root1;  // from the markers, in marker frames
  bool slides = false;  // it has given way in the last step
};

// Bristles of pairs in ascending order: they read as they were at the start of a step.
class BristleList {
 public:
  struct Entry {
    int sphere = -1, other = -1;  // global numbers
    Bristle bristle;
  };

  std::span<const Entry> of(int sphere) const {
    const auto i = static_cast<std::size_t>(sphere);
    if (i + 1 >= first_.size()) return {};
    return {entries_.data() + first_[i], first_[i + 1] - first_[i]};
  }
  const Bristle* find(int sphere, int other) const {
    for (const Entry& entry : of(sphere))
      if (entry.other == other) return &entry.bristle;
    return nullptr;
  }
  const std::vector<Entry>& all() const { return entries_; }
  bool empty() const { return entries_.empty(); }
  // Replaces the list; memory is exchanged.
  void take(std::vector<Entry>& entries) {
    entries_.swap(entries);
    first_.assign(entries_.empty() ? 0 : static_cast<std::size_t>(entries_.back().sphere) + 2, 0);
    for (const Entry& entry : entries_) ++first_[static_cast<std::size_t>(entry.sphere) + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
  }
  void clear() {
    entries_.clear();
    first_.clear();
  }

 private:
  std::vector<Entry> entries_;
  std::vector<std::size_t> first_;  // start of each sphere; those of the last sphere with bristles end with the list
};

}  // namespace dalembert
