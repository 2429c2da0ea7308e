// Linear combinations of vectors in one pass over memory; terms are added from left to right.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "dalembert/system/large_vectors.hpp"

namespace dalembert {

template <std::size_t N>
void add_weighted(const System& system, double* sum, const double* base, const WeightedVector* terms,
                  std::size_t size) {
  std::array<WeightedVector, N> t;
  std::copy_n(terms, N, t.begin());
  each_number(system, size, [=](std::size_t i) {
    double s = base[i];
    for (std::size_t k = 0; k < N; ++k) s += t[k].factor * t[k].x[i];
    sum[i] = s;
  });
}

// sum = base + all terms. `sum` must not be one of the terms.
inline void combine(const System& system, std::vector<double>& sum, const std::vector<double>& base,
                    std::span<const WeightedVector> terms) {
  const std::size_t n = sum.size();
  const double* from = base.data();
  do {
    const std::size_t count = std::min<std::size_t>(terms.size(), 4);
    switch (count) {
      case 0: copy_numbers(system, from, n, sum.data()); break;
      case 1: add_weighted<1>(system, sum.data(), from, terms.data(), n); break;
      case 2: add_weighted<2>(system, sum.data(), from, terms.data(), n); break;
      case 3: add_weighted<3>(system, sum.data(), from, terms.data(), n); break;
      default: add_weighted<4>(system, sum.data(), from, terms.data(), n); break;
    }
    from = sum.data();
    terms = terms.subspan(count);
  } while (!terms.empty());
}
inline void subtract(const System& system, std::vector<double>& x, double factor, const double* y) {
  each_number(system, x.size(), [=, rest = x.data()](std::size_t i) { rest[i] -= factor * y[i]; });
}
inline void add(const System& system, std::vector<double>& x, double factor, const std::vector<double>& y) {
  const WeightedVector term{factor, y.data()};
  add_weighted<1>(system, x.data(), x.data(), &term, x.size());
}

}  // namespace dalembert
