// Blocks of numbers in which equal blocks are stored once: machines have repeated parts, and shared blocks stay in
// caches.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "dalembert/math/lane_block.hpp"

namespace dalembert {

template <int Count>
class SharedBlocks {
 public:
  using Blocks = std::array<LaneBlock, Count>;

  const Blocks& operator[](int place) const { return kept_[static_cast<std::size_t>(place)].blocks; }

  // The place of new blocks, all zeros, with one user.
  int add() { return add({}); }

  // Returns a block that one of its users may change: a shared block is copied.
  Blocks& own(int& place) {
    if (kept(place).users > 1) {
      --kept(place).users;
      place = add(Blocks(kept(place).blocks));
    }
    return kept(place).blocks;
  }
  // A block with one user is replaced by an equal shared block, if there is one; otherwise it becomes shareable.
  void share(int& place) {
    const int known = places_.try_emplace(std::hash<std::string_view>()(bytes(place)), place).first->second;
    // released or changed by other users
    if (known == place || kept(known).users == 0 || bytes(known) != bytes(place)) return;
    kept(place).users = 0;
    free_.push_back(place);
    place = known;
    ++kept(place).users;
  }

 private:
  struct Kept {
    Blocks blocks;
    int users;
  };

  Kept& kept(int place) { return kept_[static_cast<std::size_t>(place)]; }
  std::string_view bytes(int place) { return {reinterpret_cast<const char*>(&kept(place).blocks), sizeof(Blocks)}; }

  int add(const Blocks& blocks) {
    if (free_.empty()) {
      kept_.push_back({blocks, 1});
      return static_cast<int>(kept_.size()) - 1;
    }
    const int place = free_.back();
    free_.pop_back();
    kept(place) = {blocks, 1};
    return place;
  }

  std::vector<Kept> kept_;
  std::vector<int> free_;
  std::unordered_map<std::size_t, int> places_;  // lookup by the hash of the shared contents
};

}  // namespace dalembert
