// Loops over vectors of a system: all of its threads share long ones. Results do not depend on how many there are.
#pragma once

#include <array>
#include <cstddef>
#include <numeric>
#include <span>

#include "dalembert/math/few_numbers.hpp"
#include "dalembert/math/sum_of_squares.hpp"
#include "dalembert/system/system.hpp"
#include "dalembert/system/workers.hpp"

namespace dalembert {

// Threads pay off for vectors of at least this length.
constexpr std::size_t numbers_to_share = 10000;

// Calls f(begin, end) for stretches that make up [0, count), each of which is worth a thread's while.
template <class F>
[[gnu::noinline]] void each_stretch(const System& system, std::size_t count, const F& f) {
  Workers* workers = system.workers();
  workers != nullptr ? workers->each_stretch(count, f) : f(std::size_t{0}, count);
}

// See each_number(count, f).
template <class F>
DALEMBERT_INLINE inline void each_number(const System& system, std::size_t count, F&& f) {
  if (count <= few_numbers) return each_of_few(count, f);
  if (count < numbers_to_share) return each_number(count, f);
  each_stretch(system, count, [f](std::size_t begin, std::size_t end) {
    each_number(end - begin, [f, begin](std::size_t i) { f(begin + i); });
  });
}

inline void copy_numbers(const System& system, const double* from, std::size_t count, double* to) {
  each_number(system, count, [from, to](std::size_t i) { to[i] = from[i]; });
}

// Summed in parts of one length, for any number of threads.
inline double sum_of_squares(const System& system, std::span<const double> x) {
  if (x.size() < numbers_to_share) return sum_of_squares<double>(x);
  constexpr std::size_t parts = 64;
  std::array<double, parts> sums;
  const auto begin_of = [size = x.size()](std::size_t part) { return size * part / parts; };
  each_stretch(system, parts, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      sums[i] = sum_of_squares<double>(x.subspan(begin_of(i), begin_of(i + 1) - begin_of(i)));
  });
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}

}  // namespace dalembert
