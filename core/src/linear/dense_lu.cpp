#include "dense_lu.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "dalembert/math/few_numbers.hpp"

namespace dalembert {

DenseLu::DenseLu(int size, const LinearSolverOptions& options)
    : size_(size),
      length_(padded(size)),
      largest_inverse_(options.pivot_threshold > 0 ? 1 / options.pivot_threshold
                                                   : std::numeric_limits<double>::infinity()),
      kernels_(front_kernels(options.instructions)),
      factors_(static_cast<std::size_t>(length_) * size),
      inverse_pivot_(length_),
      work_(length_),
      row_of_step_(size) {
  statistics_.entries = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
}

// Inlined as a whole, because the function calls would take as long as the factorization of a small matrix.
[[gnu::flatten]] int DenseLu::factorize(std::span<const double> values) {
  ++statistics_.factorizations;
  if (searched_ && repeat(values)) return success;
  return factorize_anew(values);
}

[[gnu::noinline]] int DenseLu::factorize_anew(std::span<const double> values) {
  const int failed = search(values);
  searched_ = failed == success;
  if (!searched_ || size_ <= tiny) return failed;
  use(find_list());
  is_listed() ? factorize_repeated(values) : factorize_whole(values);  // same rounding as in later factorizations
  return failed;
}

bool DenseLu::may_be_listed() const { return size_ <= EliminationList::largest_size; }

DenseLu::Listed* DenseLu::find_list() {
  const auto found = std::ranges::find(lists_, row_of_step_, &Listed::row_of_step);
  return found == lists_.end() ? nullptr : &*found;
}

void DenseLu::use(Listed* list) {
  list_ = list;
  operations_ = list != nullptr && list->operations ? &*list->operations : nullptr;
}

[[gnu::noinline]] void DenseLu::list_operations(std::span<const double> values) {
  if (list_ == nullptr) {
    lists_.reserve(most_lists);
    if (lists_.size() < most_lists) lists_.emplace_back();
    list_ = &lists_[made_++ % most_lists];
    list_->row_of_step = row_of_step_;
  }
  list_->operations.reset();
  use(list_);
  if (!may_be_listed()) return;
  occupied_.resize(values.size());
  for (int j = 0; j < size_; ++j)
    for (int i = 0; i < size_; ++i)
      if (values[j * size_ + i] != 0) occupied_[j * size_ + i] = occupied_[i * size_ + j] = true;
  list_->operations.emplace(row_of_step_, occupied_);
  if (!list_->operations->pays()) list_->operations.reset();
  use(list_);
}

double DenseLu::factorize_repeated(std::span<const double> values) {
  const auto taken = [&] { return is_listed() && kernels_.take_listed(*operations_, values.data(), factors_.data()); };
  if (!taken() && (is_listed() || list_ == nullptr)) {
    list_operations(values);
    taken();
  }
  return is_listed() ? kernels_.factorize_listed(*operations_, factors_.data(), inverse_pivot_.data())
                     : factorize_whole(values);
}

[[gnu::noinline]] double DenseLu::factorize_whole(std::span<const double> values) {
  const double* from = values.data();
  for (int j = 0; j < size_; ++j, from += size_) {
    double* to = column(j);
    for (int k = 0; k < size_; ++k) to[k] = from[row_of_step_[k]];
  }
  return kernels_.factorize(factors_.data(), size_, length_, inverse_pivot_.data());
}

// Same operations as in the search, with the rows in the found order.
double DenseLu::factorize_tiny(const double* values) {
  const int n = size_;
  double growth = 0;
  for (int j = 0; j < n; ++j)
    for (int k = 0; k < n; ++k) column(j)[k] = values[j * n + row_of_step_[k]];
  for (int k = 0; k < n; ++k) {
    double* const c = column(k);
    const double inverse = inverse_pivot_[k] = 1 / c[k];
    for (int i = k + 1; i < n; ++i) {
      c[i] *= inverse;
      growth = std::max(growth, std::abs(c[i]));
    }
    for (int j = k + 1; j < n; ++j)
      for (int i = k + 1; i < n; ++i) column(j)[i] -= column(j)[k] * c[i];
  }
  return growth;
}

bool DenseLu::repeat(std::span<const double> values) {
  const double growth = size_ <= tiny ? factorize_tiny(values.data()) : factorize_repeated(values);
  const auto usable = [&](double inverse) { return std::abs(inverse) < largest_inverse_; };
  return growth <= largest_growth && std::all_of(inverse_pivot_.begin(), inverse_pivot_.begin() + size_, usable);
}

// Elimination with the largest entry of each column as pivot.
[[gnu::noinline]] int DenseLu::search(std::span<const double> values) {
  ++statistics_.pivot_searches;
  const int n = size_;
  std::iota(row_of_step_.begin(), row_of_step_.end(), 0);
  for (int j = 0; j < n; ++j) std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(j) * n, n, column(j));
  for (int k = 0; k < n; ++k) {
    double* c = column(k);
    const auto smaller = [](double a, double b) { return std::abs(a) < std::abs(b); };
    const int p = static_cast<int>(std::max_element(c + k, c + n, smaller) - c);
    const double inverse = inverse_pivot_[k] = 1 / c[p];
    if (!(std::abs(inverse) < largest_inverse_)) return k;
    exchange_rows(k, p);
    for (int i = k + 1; i < n; ++i) c[i] *= inverse;
    for (int j = k + 1; j < n; ++j) {
      double* d = column(j);
      if (d[k] == 0) continue;
      for (int i = k + 1; i < n; ++i) d[i] -= d[k] * c[i];
    }
  }
  return success;
}

void DenseLu::exchange_rows(int i, int j) {
  if (i == j) return;
  std::swap(row_of_step_[i], row_of_step_[j]);
  for (int k = 0; k < size_; ++k) std::swap(column(k)[i], column(k)[j]);
}

void DenseLu::solve(std::span<double> x) {
  double* const w = work_.data();
  for (int k = 0; k < size_; ++k) w[k] = x[row_of_step_[k]];
  if (size_ <= tiny) {
    solve_tiny(w);
  } else if (is_listed()) {
    kernels_.solve_listed(*operations_, factors_.data(), inverse_pivot_.data(), w);
  } else {
    kernels_.eliminate(factors_.data(), size_, length_, w, 1);
    kernels_.substitute(factors_.data(), size_, length_, inverse_pivot_.data(), w);
  }
  copy_numbers(w, x.size(), x.data());
}

// The operations of a list (substitute_listed).
void DenseLu::solve_tiny(double* x) {
  for (int k = 0; k < size_; ++k)
    for (int i = k + 1; i < size_; ++i) x[i] -= column(k)[i] * x[k];
  for (int k = size_ - 1; k >= 0; --k) {
    for (int i = 0; i < k; ++i) x[i] -= column(k)[i] * inverse_pivot_[k] * x[k];
    x[k] *= inverse_pivot_[k];
  }
}

}  // namespace dalembert
