#include "sparse_lu.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace dalembert {

namespace {

// The diagonal is taken as pivot if it is not smaller than this part of the largest entry.
constexpr double diagonal_preference = 1e-3;
// A repeated factorization is given up if a pivot is smaller than this part of the largest entry below it.
constexpr double smallest_ratio = 1e-6;
// From so many entries per column on, dense blocks pay; small systems are worth a second order instead.
constexpr std::size_t crowded_column = 60;
constexpr int large_system = 5000;

}  // namespace

SparseLu::SparseLu(const Pattern& pattern, const LinearSolverOptions& options)
    : pattern_(pattern), options_(options), size_(pattern.size()), step_of_row_(size_), inverse_pivot_(size_),
      work_(size_, 0.0), reached_(size_), stack_(size_), position_(size_), marked_(size_, 0) {}

int SparseLu::factorize(std::span<const double> values) {
  if (supernodal_ != nullptr) {
    if (supernodal_->factorize(values)) return success;
    supernodal_.reset();  // a pivot is missing: the search below names it
  }
  if (factorized_ && repeat(values)) return success;
  if (order_.empty()) {
    if (size_ > large_system && try_supernodes(values)) return success;
    choose_order(values);
  }
  const int failed = factorize_with_pivots(values, order_);
  factorized_ = failed == success;
  if (factorized_) {
    number_rows_by_steps();
    plan_repetition();
  }
  return failed;
}

// The order with fewer entries in the factors is kept.
void SparseLu::choose_order(std::span<const double> values) {
  order_ = paired_minimum_degree_order(pattern_, values);
  if (size_ > large_system) return;
  const int failed = factorize_with_pivots(values, order_);
  const std::size_t size = entries();
  EliminationOrder other = column_order(pattern_);
  const bool other_works = factorize_with_pivots(values, other) == success;
  if (other_works && (failed != success || entries() < size)) order_ = std::move(other);
}

// True if the factors are crowded, so that dense blocks pay.
bool SparseLu::try_supernodes(std::span<const double> values) {
  auto candidate = std::make_unique<SupernodalLu>(pattern_);
  if (!candidate->factorize(values) || candidate->entries() < crowded_column * static_cast<std::size_t>(size_)) return false;
  supernodal_ = std::move(candidate);
  return true;
}

// Left-looking: each column is solved with the columns of L found so far, then its pivot is chosen.
int SparseLu::factorize_with_pivots(std::span<const double> values, const EliminationOrder& order) {
  std::fill(step_of_row_.begin(), step_of_row_.end(), -1);
  lower_.clear();
  upper_.clear();
  const auto starts = pattern_.column_start(), rows = pattern_.row_index();
  for (int step = 0; step < size_; ++step) {
    const int column = order[static_cast<std::size_t>(step)];
    reach(column);
    for (int k = starts[column]; k < starts[column + 1]; ++k) work_[rows[k]] = values[k];
    for (int k = top_; k < size_; ++k) {
      const int row = reached_[k], j = step_of_row_[row];
      if (j < 0) continue;
      const double x = work_[row];
      for (int p = lower_.start[j]; p < lower_.start[j + 1]; ++p) work_[lower_.rows[p]] -= x * lower_.values[p];
    }
    const int pivot_row = choose_pivot(step, column);
    if (pivot_row < 0) {
      for (int k = top_; k < size_; ++k) work_[reached_[k]] = 0;
      return column;
    }
    store_column(step, pivot_row);
  }
  return success;
}

// All rows that may be nonzero in L^-1 A(:, column): a depth-first search through the graph of L.
void SparseLu::reach(int column) {
  top_ = size_;
  const auto starts = pattern_.column_start(), rows = pattern_.row_index();
  for (int k = starts[column]; k < starts[column + 1]; ++k) {
    if (!marked_[rows[k]]) visit(rows[k]);
  }
  for (int k = top_; k < size_; ++k) marked_[reached_[k]] = 0;
}

void SparseLu::visit(int first) {
  int depth = 0;
  stack_[0] = first;
  marked_[first] = 1;
  position_[0] = step_of_row_[first] < 0 ? 0 : lower_.start[step_of_row_[first]];
  while (depth >= 0) {
    const int row = stack_[depth], j = step_of_row_[row];
    const int end = j < 0 ? 0 : lower_.start[j + 1];
    int next = -1;
    while (j >= 0 && position_[depth] < end && next < 0) {
      const int candidate = lower_.rows[position_[depth]++];
      if (!marked_[candidate]) next = candidate;
    }
    if (next < 0) {
      reached_[--top_] = row;
      --depth;
    } else {
      marked_[next] = 1;
      stack_[++depth] = next;
      position_[depth] = step_of_row_[next] < 0 ? 0 : lower_.start[step_of_row_[next]];
    }
  }
}

// -1: there is none.
int SparseLu::choose_pivot(int step, int column) {
  double largest = 0, scale = 0;
  int best = -1, any = -1;
  for (int k = top_; k < size_; ++k) {
    const int row = reached_[k];
    const double x = std::abs(work_[row]);
    scale = std::max(scale, x);
    if (step_of_row_[row] >= 0) continue;
    any = row;
    if (x > largest) {
      largest = x;
      best = row;
    }
  }
  const bool singular = !(largest > std::max(options_.pivot_threshold, options_.ignore_singular ? 1e-14 * scale : 0.0));
  if (singular) {
    if (!options_.ignore_singular) return -1;
    // The unknown stays zero: any row that is left takes the place of the pivot.
    if (step_of_row_[column] < 0) any = column;
    for (int row = 0; any < 0; ++row) any = step_of_row_[row] < 0 ? row : -1;
    inverse_pivot_[step] = 0;
    return any;
  }
  if (step_of_row_[column] < 0 && std::abs(work_[column]) >= diagonal_preference * largest) best = column;
  inverse_pivot_[step] = 1 / work_[best];
  return best;
}

void SparseLu::store_column(int step, int pivot_row) {
  for (int k = top_; k < size_; ++k) {
    const int row = reached_[k];
    const double x = work_[row];
    work_[row] = 0;
    if (row == pivot_row) continue;
    if (step_of_row_[row] >= 0) {
      upper_.rows.push_back(step_of_row_[row]);
      upper_.values.push_back(x);
    } else {
      lower_.rows.push_back(row);
      lower_.values.push_back(x * inverse_pivot_[step]);
    }
  }
  step_of_row_[pivot_row] = step;
  upper_.start.push_back(static_cast<int>(upper_.rows.size()));
  lower_.start.push_back(static_cast<int>(lower_.rows.size()));
}

void SparseLu::number_rows_by_steps() {
  for (int& row : lower_.rows) row = step_of_row_[row];
  // Ascending rows are an order in which a column can be solved without a search.
  std::vector<int> place;
  const auto sort_columns = [&](Columns& columns) {
    for (int j = 0; j < size_; ++j) {
      const int begin = columns.start[j], end = columns.start[j + 1];
      place.resize(static_cast<std::size_t>(end - begin));
      std::iota(place.begin(), place.end(), begin);
      std::sort(place.begin(), place.end(), [&](int a, int b) { return columns.rows[a] < columns.rows[b]; });
      std::vector<int> rows;
      std::vector<double> values;
      for (const int k : place) {
        rows.push_back(columns.rows[k]);
        values.push_back(columns.values[k]);
      }
      std::copy(rows.begin(), rows.end(), columns.rows.begin() + begin);
      std::copy(values.begin(), values.end(), columns.values.begin() + begin);
    }
  };
  sort_columns(upper_);
  sort_columns(lower_);
}

void SparseLu::plan_repetition() {
  const auto starts = pattern_.column_start(), rows = pattern_.row_index();
  source_.clear();
  target_.clear();
  source_start_.assign(1, 0);
  for (const int column : order_) {
    for (int k = starts[column]; k < starts[column + 1]; ++k) {
      source_.push_back(static_cast<std::size_t>(k));
      target_.push_back(step_of_row_[rows[k]]);
    }
    source_start_.push_back(static_cast<int>(source_.size()));
  }
}

// The same steps with other values. False: a pivot is too small; the factors are useless then.
bool SparseLu::repeat(std::span<const double> values) {
  double* const x = work_.data();
  for (int step = 0; step < size_; ++step) {
    for (int k = source_start_[step]; k < source_start_[step + 1]; ++k) x[target_[k]] = values[source_[k]];
    for (int k = upper_.start[step]; k < upper_.start[step + 1]; ++k) {
      const int j = upper_.rows[k];
      const double u = x[j];
      x[j] = 0;
      upper_.values[k] = u;
      const int* row = lower_.rows.data() + lower_.start[j];
      const double* value = lower_.values.data() + lower_.start[j];
      for (int p = lower_.start[j + 1] - lower_.start[j]; p > 0; --p) x[*row++] -= u * *value++;
    }
    const double pivot = x[step];
    x[step] = 0;
    double largest = 0;
    const double inverse = inverse_pivot_[step] == 0 ? 0 : 1 / pivot;
    for (int k = lower_.start[step]; k < lower_.start[step + 1]; ++k) {
      const double entry = x[lower_.rows[k]];
      x[lower_.rows[k]] = 0;
      largest = std::max(largest, std::abs(entry));
      lower_.values[k] = entry * inverse;
    }
    if (inverse_pivot_[step] == 0) {
      if (std::max(largest, std::abs(pivot)) == 0) continue;
      std::fill(work_.begin(), work_.end(), 0.0);
      return false;
    }
    if (!(std::abs(pivot) > std::max(options_.pivot_threshold, smallest_ratio * largest))) {
      std::fill(work_.begin(), work_.end(), 0.0);
      return false;
    }
    inverse_pivot_[step] = inverse;
  }
  return true;
}

void SparseLu::solve(std::span<double> b) {
  if (supernodal_ != nullptr) return supernodal_->solve(b);
  double* const x = work_.data();
  for (int i = 0; i < size_; ++i) x[step_of_row_[i]] = b[i];
  for (int j = 0; j < size_; ++j) {
    const double u = x[j];
    if (u == 0) continue;
    for (int k = lower_.start[j]; k < lower_.start[j + 1]; ++k) x[lower_.rows[k]] -= u * lower_.values[k];
  }
  for (int j = size_ - 1; j >= 0; --j) {
    const double u = x[j] * inverse_pivot_[j];
    b[order_[j]] = u;
    x[j] = 0;
    if (u == 0) continue;
    for (int k = upper_.start[j]; k < upper_.start[j + 1]; ++k) x[upper_.rows[k]] -= u * upper_.values[k];
  }
}

}  // namespace dalembert
