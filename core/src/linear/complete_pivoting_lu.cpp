#include "complete_pivoting_lu.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "dalembert/math/wide_registers.hpp"

namespace dalembert {

CompletePivotingLu::CompletePivotingLu(int size, const LinearSolverOptions& options)
    : size_(size),
      pivot_threshold_(options.pivot_threshold),
      values_(static_cast<std::size_t>(size) * size),
      inverse_pivot_(size),
      largest_(size),
      row_exchange_(size),
      column_exchange_(size) {}

namespace {

// The bits of an absolute value, which are ordered as the values are: loops over integers can use wide registers.
std::int64_t magnitude(double x) { return std::bit_cast<std::int64_t>(x) & std::numeric_limits<std::int64_t>::max(); }

}  // namespace

// Elimination with the largest entry of the rest as pivot; it stops where the rest is round-off, and solutions are zero there.
int CompletePivotingLu::factorize(std::span<const double> values) {
  ++factorizations_;
  std::copy(values.begin(), values.end(), values_.begin());
  const int n = size_;
  for (int j = 0; j < n; ++j)
    largest_[j] = std::transform_reduce(
        column(j), column(j) + n, std::int64_t{0}, [](std::int64_t a, std::int64_t b) { return std::max(a, b); },
        magnitude);
  double first = 0;
  for (rank_ = 0; rank_ < n; ++rank_) {
    const int k = rank_;
    const int q = static_cast<int>(std::max_element(largest_.begin() + k, largest_.end()) - largest_.begin());
    const double largest = std::bit_cast<double>(largest_[q]);
    if (k == 0) first = largest;
    if (!(largest > std::max(pivot_threshold_, first * std::numeric_limits<double>::epsilon() * n))) break;
    const double* const rest =
        std::find_if(column(q) + k, column(q) + n, [&](double x) { return std::abs(x) == largest; });
    const int p = static_cast<int>(rest - column(q));
    row_exchange_[k] = p;
    column_exchange_[k] = q;
    exchange_rows(k, p);
    exchange_columns(k, q);
    double* c = column(k);
    inverse_pivot_[k] = 1 / c[k];
    for (int i = k + 1; i < n; ++i) c[i] *= inverse_pivot_[k];
    in_registers_of_four([this, c, k, n] {
      for (int j = k + 1; j < n; ++j) {
        double* d = column(j);
        const double times = d[k];
        if (times == 0) continue;  // its largest entry stays
        std::int64_t largest = 0;
        for (int i = k + 1; i < n; ++i) {
          d[i] -= times * c[i];
          largest = std::max(largest, magnitude(d[i]));
        }
        largest_[j] = largest;
      }
    });
  }
  return success;
}

void CompletePivotingLu::exchange_rows(int i, int j) {
  if (i == j) return;
  for (int k = 0; k < size_; ++k) std::swap(column(k)[i], column(k)[j]);
}

void CompletePivotingLu::exchange_columns(int i, int j) {
  if (i == j) return;
  std::swap_ranges(column(i), column(i) + size_, column(j));
  std::swap(largest_[i], largest_[j]);
}

void CompletePivotingLu::solve(std::span<double> x) {
  const int n = size_;
  for (int k = 0; k < rank_; ++k) std::swap(x[k], x[row_exchange_[k]]);
  for (int k = 0; k < rank_; ++k) {
    const double* c = column(k);
    for (int i = k + 1; i < n; ++i) x[i] -= x[k] * c[i];
  }
  for (int k = rank_; k < n; ++k) x[k] = 0;
  for (int k = rank_ - 1; k >= 0; --k) {
    const double* c = column(k);
    x[k] *= inverse_pivot_[k];
    for (int i = 0; i < k; ++i) x[i] -= x[k] * c[i];
  }
  for (int k = rank_ - 1; k >= 0; --k) std::swap(x[k], x[column_exchange_[k]]);
}

}  // namespace dalembert
