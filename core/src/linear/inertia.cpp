// Bunch, Kaufman: Some stable methods for calculating inertia and solving symmetric linear systems, Math. Comp. 31 (1977).
#include "dalembert/linear/inertia.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "occupied_lu.hpp"

namespace dalembert {

namespace {

constexpr double rounding = 1e-10;  // of the terms that cancel in a pivot
constexpr int largest_dense = 64;  // unknowns
constexpr double harmless = 1e3;  // growth of entries of L, relative to that with the values that chose the pivots

// The largest entry of each row and column becomes about one.
void equilibrate(std::span<double> a, int n) {
  std::vector<double> scale(static_cast<std::size_t>(n), 0.0);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) scale[j] = std::max(scale[j], std::abs(a[j * n + i]));
  for (double& s : scale) s = s > 0 ? 1 / std::sqrt(s) : 1;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) a[j * n + i] *= scale[i] * scale[j];
}

// The lower triangle, by columns; rows and columns before `k` are eliminated.
class Elimination {
 public:
  Elimination(double* a, int n) : a_(a), n_(n) {}

  std::optional<int> negative() {
    constexpr double limit =
        0.6403882032022076;  // (1 + sqrt(17)) / 8: pivots of one or two rows let entries grow alike
    for (k_ = 0; k_ < n_;) {
      const auto [r, below] = largest_below(k_);
      const double own = std::abs(at(k_, k_));
      if (std::max(own, below) <= rounding) return {};
      if (own >= limit * below) {
        if (!eliminate_one()) return {};
        continue;
      }
      const double across = largest_across(r);
      if (own * across >= limit * below * below) {
        if (!eliminate_one()) return {};
      } else if (std::abs(at(r, r)) >= limit * across) {
        exchange(k_, r);
        if (!eliminate_one()) return {};
      } else {
        exchange(k_ + 1, r);
        if (!eliminate_two()) return {};
      }
    }
    return count_;
  }

 private:
  double& at(int i, int j) { return a_[static_cast<std::ptrdiff_t>(j) * n_ + i]; }

  std::pair<int, double> largest_below(int k) {
    int place = k;
    double largest = 0;
    for (int i = k + 1; i < n_; ++i)
      if (const double x = std::abs(at(i, k)); x > largest) largest = x, place = i;
    return {place, largest};
  }
  double largest_across(int r) {
    double largest = largest_below(r).second;
    for (int j = k_; j < r; ++j) largest = std::max(largest, std::abs(at(r, j)));
    return largest;
  }
  void exchange(int k, int r) {
    if (k == r) return;
    for (int j = k_; j < k; ++j) std::swap(at(k, j), at(r, j));
    for (int j = k + 1; j < r; ++j) std::swap(at(j, k), at(r, j));
    for (int i = r + 1; i < n_; ++i) std::swap(at(i, k), at(i, r));
    std::swap(at(k, k), at(r, r));
  }
  // False: the pivot counts as zero.
  bool eliminate_one() {
    const double pivot = at(k_, k_);
    if (!(std::abs(pivot) > rounding)) return false;
    count_ += pivot < 0 ? 1 : 0;
    for (int j = k_ + 1; j < n_; ++j) {
      const double factor = at(j, k_) / pivot;
      if (factor == 0) continue;
      for (int i = j; i < n_; ++i) at(i, j) -= factor * at(i, k_);
    }
    ++k_;
    return true;
  }
  // Two rows whose entry beside the diagonal outweighs those on it: one eigenvalue is negative, the other is positive.
  bool eliminate_two() {
    const double a = at(k_, k_), b = at(k_ + 1, k_), c = at(k_ + 1, k_ + 1), determinant = a * c - b * b;
    if (!(determinant < 0)) return false;
    ++count_;
    for (int j = k_ + 2; j < n_; ++j) {
      const double x = at(j, k_), y = at(j, k_ + 1);
      const double first = (c * x - b * y) / determinant, second = (a * y - b * x) / determinant;
      if (first == 0 && second == 0) continue;
      for (int i = j; i < n_; ++i) at(i, j) -= first * at(i, k_) + second * at(i, k_ + 1);
    }
    k_ += 2;
    return true;
  }

  double* a_;
  int n_, k_ = 0, count_ = 0;
};

}  // namespace

std::optional<int> negative_eigenvalues(std::span<double> symmetric, int size) {
  equilibrate(symmetric, size);
  return Elimination(symmetric.data(), size).negative();
}

// The pivots of one front, with its complete rows and columns; its pivots are eliminated as always.
std::optional<int> MultifrontalLu::negative_pivots(const Front& front, double* panel) {
  const int n = front.pivots, first = front.first_slot;
  const auto row = [&](int k) { return row_of_slot_[static_cast<std::size_t>(first + k)]; };
  const auto column_place = [&](int unknown) { return slot_of_column_[static_cast<std::size_t>(unknown)] - first; };
  std::vector<int> place(static_cast<std::size_t>(n));  // column of the unknown whose equation row k is
  bool in_order = true;
  for (int k = 0; k < n; ++k) {
    place[k] = column_place(row(k));
    if (place[k] < 0 || place[k] >= n) return {};
    in_order = in_order && place[k] == k;
  }
  std::vector<double> before;
  if (in_order) {
    for (int k = 0; k < n; ++k) before.push_back(panel[static_cast<std::ptrdiff_t>(k) * front.length + k]);
  } else {
    before.resize(static_cast<std::size_t>(n) * n);
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k) {
        const double scale =
            column_scale_[static_cast<std::size_t>(row(k))] / row_scale_[static_cast<std::size_t>(first + k)];
        before[j * n + place[k]] = panel[static_cast<std::ptrdiff_t>(j) * front.length + k] * scale;
      }
  }
  double* inverse = inverse_pivot_.data() + first;
  growth_ = std::max(growth_, kernels_.factorize(panel, n, front.length, inverse));
  if (!in_order) return dalembert::negative_eigenvalues(before, n);
  int count = 0;
  for (int k = 0; k < n; ++k) {
    if (!(std::abs(1 / inverse[k]) > rounding * std::abs(before[k]))) return {};
    count += inverse[k] < 0 ? 1 : 0;
  }
  return count;
}

// As `repeat`, without keeping the factors.
std::optional<int> MultifrontalLu::negative_eigenvalues(std::span<const double> given) {
  if (!planned_ || options_.ignore_singular || !options_.dependent.empty() || !options_.tiny_diagonal.empty())
    return {};
  const std::vector<double> inverse = inverse_pivot_;
  const double growth = std::exchange(growth_, 0.0);
  std::optional<int> count = 0;
  for (const Front& front : fronts_) {
    assemble(front, given);
    double* panel = columns(front);
    const std::optional<int> here = negative_pivots(front, panel);
    if (!here) {
      count = {};
      break;
    }
    *count += *here;
    kernels_.eliminate(panel, front.pivots, front.length,
                       panel + static_cast<std::ptrdiff_t>(front.length) * front.pivots, front.updates);
  }
  if (!(growth_ <= harmless * planned_growth_)) count = {};
  inverse_pivot_ = inverse;
  growth_ = growth;
  return count;
}

std::optional<int> OccupiedLu::negative_eigenvalues(std::span<const double> values) const {
  if (!occupied_) return solver_->negative_eigenvalues(values);
  if (std::ranges::any_of(zeros_, [&](int slot) { return values[slot] != 0; })) return {};
  int count = 0;
  for (const Lone& lone : lone_) {
    if (values[lone.slot] == 0) return {};
    count += values[lone.slot] < 0 ? 1 : 0;
  }
  const std::optional<int> others = solver_->negative_eigenvalues(values);
  if (!others) return {};
  return count + *others;
}

std::optional<int> negative_eigenvalues(const LinearSolver& solver, const Pattern& pattern,
                                        std::span<const double> values) {
  if (const auto* sparse = dynamic_cast<const OccupiedLu*>(&solver)) return sparse->negative_eigenvalues(values);
  if (!pattern.is_dense() || pattern.size() > largest_dense) return {};
  std::vector<double> matrix(values.begin(), values.end());
  return negative_eigenvalues(matrix, pattern.size());
}

}  // namespace dalembert
