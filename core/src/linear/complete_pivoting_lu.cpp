#include "complete_pivoting_lu.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace dalembert {

CompletePivotingLu::CompletePivotingLu(int size, const LinearSolverOptions& options)
    : size_(size),
      pivot_threshold_(options.pivot_threshold),
      values_(static_cast<std::size_t>(size) * size),
      inverse_pivot_(size),
      row_exchange_(size),
      column_exchange_(size) {}

// Elimination with the largest entry of the rest as pivot; it stops where the rest is round-off, and solutions are zero there.
int CompletePivotingLu::factorize(std::span<const double> values) {
  ++factorizations_;
  std::copy(values.begin(), values.end(), values_.begin());
  const int n = size_;
  double first = 0;
  for (rank_ = 0; rank_ < n; ++rank_) {
    const int k = rank_;
    int p = k, q = k;
    double largest = 0;
    for (int j = k; j < n; ++j) {
      for (int i = k; i < n; ++i) {
        if (const double x = std::abs(column(j)[i]); x > largest) {
          largest = x;
          p = i;
          q = j;
        }
      }
    }
    if (k == 0) first = largest;
    if (!(largest > std::max(pivot_threshold_, first * std::numeric_limits<double>::epsilon() * n))) break;
    row_exchange_[k] = p;
    column_exchange_[k] = q;
    exchange_rows(k, p);
    exchange_columns(k, q);
    double* c = column(k);
    inverse_pivot_[k] = 1 / c[k];
    for (int i = k + 1; i < n; ++i) c[i] *= inverse_pivot_[k];
    for (int j = k + 1; j < n; ++j) {
      double* d = column(j);
      for (int i = k + 1; i < n; ++i) d[i] -= d[k] * c[i];
    }
  }
  return success;
}

void CompletePivotingLu::exchange_rows(int i, int j) {
  if (i == j) return;
  for (int k = 0; k < size_; ++k) std::swap(column(k)[i], column(k)[j]);
}

void CompletePivotingLu::exchange_columns(int i, int j) {
  if (i != j) std::swap_ranges(column(i), column(i) + size_, column(j));
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
