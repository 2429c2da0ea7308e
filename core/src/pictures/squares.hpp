// Squares of a picture: what is drawn one after the other, many at a time, finds the samples of its square in the cache.
#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

#include "dalembert/math/large_memory.hpp"
#include "points.hpp"

namespace dalembert {

class Squares {
 public:
  static constexpr std::size_t many = 1000;  // from so many on, sorting pays

  Squares(int columns, int rows) : columns_(columns), rows_(rows), across_(columns / side + 1), count_(across_ * (rows / side + 1)) {}

  // By squares, rows of them first; in each of them, the order stays. place_of: a point in samples.
  template <class T, class PlaceOf>
  void sort(LargeVector<T>& list, const PlaceOf& place_of) const {
    LargeVector<std::uint32_t> square(list.size());
    std::vector<std::size_t> starts(static_cast<std::size_t>(count_) + 1);
    for (std::size_t i = 0; i < list.size(); ++i) {
      const Point place = place_of(list[i]);
      const FourWhole at = whole(first_samples(Four{place.x, place.y}, Four{static_cast<float>(columns_), static_cast<float>(rows_)})) / side;
      square[i] = static_cast<std::uint32_t>(at[1] * across_ + at[0]);
      ++starts[square[i] + 1];
    }
    std::partial_sum(starts.begin(), starts.end(), starts.begin());
    LargeVector<T> sorted(list.size());
    for (std::size_t i = 0; i < list.size(); ++i) sorted[starts[square[i]]++] = list[i];
    list.swap(sorted);
  }

 private:
  static constexpr int side = 64;  // samples

  int columns_, rows_, across_, count_;
};

}  // namespace dalembert
