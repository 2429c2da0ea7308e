// Deterministic pseudo-random numbers in [-1, 1): S. Vigna's mixing of a counter (splitmix64), which needs no
// initialization.
#pragma once

#include <cstdint>

namespace dalembert {

class NumberSequence {
 public:
  double operator()() {
    std::uint64_t x = counter_ += 0x9e3779b97f4a7c15ULL;
    x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9ULL;
    x = (x ^ (x >> 27U)) * 0x94d049bb133111ebULL;
    return static_cast<double>((x ^ (x >> 31U)) >> 11U) * 0x1p-52 - 1;
  }

 private:
  std::uint64_t counter_ = 0;
};

}  // namespace dalembert
