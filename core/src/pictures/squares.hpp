// Tiles of a picture: drawing tile by tile finds the samples in the cache.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
#include <vector>

#include "dalembert/math/large_memory.hpp"
#include "points.hpp"

namespace dalembert {

class Squares {
 public:
  static constexpr std::size_t many = 1000;  // smaller numbers are not sorted
  static constexpr int side = 32;            // samples, of 16 bytes each, which stay in the nearest cache

  Squares(int columns, int rows)
      : columns_(columns), rows_(rows), across_(columns / side + 1), count_(across_ * (rows / side + 1)) {}

  int across() const { return across_; }
  int count() const { return count_; }
  // Column and row of the tile of a point in samples.
  DALEMBERT_INLINE FourWhole of(Point place) const {
    return whole(first_samples(Four{place.x, place.y}, Four{static_cast<float>(columns_), static_cast<float>(rows_)})) /
           side;
  }

  // Sorts by tiles, row by row; the order within a tile is kept. place_of: a point in samples. Returns the end of
  // each tile.
  template <class T, class PlaceOf>
  std::vector<std::size_t> sort(std::span<T> list, const PlaceOf& place_of) const {
    LargeVector<std::uint32_t> square(list.size());
    std::vector<std::size_t> starts(static_cast<std::size_t>(count_) + 1);
    for (std::size_t i = 0; i < list.size(); ++i) {
      const FourWhole at = of(place_of(list[i]));
      square[i] = static_cast<std::uint32_t>(at[1] * across_ + at[0]);
      ++starts[square[i] + 1];
    }
    std::partial_sum(starts.begin(), starts.end(), starts.begin());
    LargeVector<T> sorted(list.size());
    for (std::size_t i = 0; i < list.size(); ++i) sorted[starts[square[i]]++] = list[i];
    std::ranges::copy(sorted, list.begin());
    starts.pop_back();  // they have moved on to the ends
    return starts;
  }

 private:
  int columns_, rows_, across_, count_;
};

}  // namespace dalembert
