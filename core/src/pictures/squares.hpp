// Squares of a picture: what is drawn one after the other, many at a time, finds the samples of its square in the cache.
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
  static constexpr std::size_t many = 1000;  // from so many on, sorting pays
  static constexpr int side = 32;            // samples, of 16 bytes each, which stay in the nearest cache

  Squares(int columns, int rows) : columns_(columns), rows_(rows), across_(columns / side + 1), count_(across_ * (rows / side + 1)) {}

  int across() const { return across_; }
  int count() const { return count_; }
  // Of a point in samples: its column and its row of squares, in the picture.
  DALEMBERT_INLINE FourWhole of(Point place) const {
    return whole(first_samples(Four{place.x, place.y}, Four{static_cast<float>(columns_), static_cast<float>(rows_)})) / side;
  }

  // By squares, rows of them first; in each of them, the order stays. place_of: a point in samples. Returns where each square ends.
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
