#include "dense_lu.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dalembert {

DenseLu::DenseLu(int size, const LinearSolverOptions& options)
    : size_(size), rank_(size), options_(options), values_(static_cast<std::size_t>(size) * size), work_(size),
      inverse_pivot_(size), row_exchange_(size), column_exchange_(size) {}

int DenseLu::factorize(std::span<const double> values) {
  std::copy(values.begin(), values.end(), values_.begin());
  rank_ = size_;
  return options_.ignore_singular ? eliminate_all_pivots() : eliminate();
}

// Right-looking elimination with the largest entry of each column as pivot.
int DenseLu::eliminate() {
  const int n = size_;
  for (int k = 0; k < n; ++k) {
    double* c = column(k);
    int p = k;
    double largest = std::abs(c[k]);
    for (int i = k + 1; i < n; ++i) {
      if (const double x = std::abs(c[i]); x > largest) {
        largest = x;
        p = i;
      }
    }
    if (!(largest > options_.pivot_threshold)) return k;
    row_exchange_[k] = p;
    if (p != k) exchange_rows(k, p);
    const double inverse = 1 / c[k];
    inverse_pivot_[k] = inverse;
    for (int i = k + 1; i < n; ++i) c[i] *= inverse;
    for (int j = k + 1; j < n; ++j) {
      double* d = column(j);
      const double u = d[k];
      if (u == 0) continue;
      for (int i = k + 1; i < n; ++i) d[i] -= u * c[i];
    }
  }
  return success;
}

// Elimination with the largest entry of the rest as pivot; it stops where the rest is round-off, and solutions are zero there.
int DenseLu::eliminate_all_pivots() {
  const int n = size_;
  double first = 0;
  for (int k = 0; k < n; ++k) {
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
    if (!(largest > std::max(options_.pivot_threshold, first * 2.2e-16 * n))) {
      rank_ = k;
      break;
    }
    row_exchange_[k] = p;
    column_exchange_[k] = q;
    if (p != k) exchange_rows(k, p);
    if (q != k) exchange_columns(k, q);
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

void DenseLu::exchange_rows(int i, int j) {
  double* a = values_.data() + i;
  double* b = values_.data() + j;
  for (int k = 0; k < size_; ++k, a += size_, b += size_) std::swap(*a, *b);
}

void DenseLu::exchange_columns(int i, int j) { std::swap_ranges(column(i), column(i) + size_, column(j)); }

void DenseLu::solve(std::span<double> x) {
  const int n = size_;
  for (int k = 0; k < rank_; ++k) {
    if (row_exchange_[k] != k) std::swap(x[k], x[row_exchange_[k]]);
  }
  for (int k = 0; k < rank_; ++k) {
    const double u = x[k];
    if (u == 0) continue;
    const double* c = column(k);
    for (int i = k + 1; i < n; ++i) x[i] -= u * c[i];
  }
  for (int k = rank_; k < n; ++k) x[k] = 0;
  for (int k = rank_ - 1; k >= 0; --k) {
    const double* c = column(k);
    const double u = x[k] *= inverse_pivot_[k];
    if (u == 0) continue;
    for (int i = 0; i < k; ++i) x[i] -= u * c[i];
  }
  if (!options_.ignore_singular) return;
  for (int k = rank_ - 1; k >= 0; --k) {
    if (column_exchange_[k] != k) std::swap(x[k], x[column_exchange_[k]]);
  }
}

}  // namespace dalembert
