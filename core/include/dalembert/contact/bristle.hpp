// Tangential springs that let friction hold, after Cundall and Strack (1979). A bristle is rooted in both bodies. What lies between its roots in
// the plane of contact stretches it; it gives way where it would pull stronger than friction can.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "dalembert/frames.hpp"

namespace dalembert {

struct Bristle {
  Vec3<double> root0, root1;  // from the markers, in their frames
  bool slides = false;        // it has given way in the last step
};

// Bristles of pairs in ascending order: they read as they were at the start of a step.
class BristleList {
 public:
  struct Entry {
    int sphere = -1, other = -1;  // global numbers
    Bristle bristle;
  };

  std::span<const Entry> of(int sphere) const {
    const auto first = std::ranges::lower_bound(entries_, sphere, {}, &Entry::sphere);
    auto last = first;
    while (last != entries_.end() && last->sphere == sphere) ++last;
    return {first, last};
  }
  const Bristle* find(int sphere, int other) const {
    for (const Entry& entry : of(sphere))
      if (entry.other == other) return &entry.bristle;
    return nullptr;
  }
  const std::vector<Entry>& all() const { return entries_; }
  bool empty() const { return entries_.empty(); }
  // Takes the place of what was known; the memory goes back and forth.
  void take(std::vector<Entry>& entries) { entries_.swap(entries); }
  void clear() { entries_.clear(); }

 private:
  std::vector<Entry> entries_;
};

// A vector, or its direction with the given length if it is longer.
template <class S>
Vec3<S> at_most(const Vec3<S>& v, const S& length) {
  const S square = dot(v, v);
  using std::sqrt;
  if (!(square > length * length)) return v;
  return (length / sqrt(square)) * v;
}

}  // namespace dalembert
