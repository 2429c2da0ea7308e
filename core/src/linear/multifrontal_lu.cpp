#include "multifrontal_lu.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "elimination_tree.hpp"

namespace dalembert {

namespace {

// Smallest admissible pivots, relative to the largest entry of their columns. Small pivots keep the factors sparse
// and are usually accurate; otherwise the search is repeated with a larger ratio.
constexpr double smallest_ratios[] = {1e-6, 1e-4, 1e-2};
// Residual of a test solution, relative to the sizes of matrix and solution.
constexpr double largest_residual = 1e-12;
// Fronts of a stricter search may have so many times the rows of those of the first one.
constexpr int harmless_fill = 3;
// Largest admissible growth of the entries of L in a repeated factorization, relative to that with the selected pivots,
// which bounds the loss of digits. If L exceeds the size, which costs five digits, it may only grow a little further.
constexpr double largest_growth = 1e3, largest_size = 1e5, smallest_growth = 10;

}  // namespace

MultifrontalLu::MultifrontalLu(const Pattern& pattern, const LinearSolverOptions& options, std::vector<int> slots)
    : pattern_(pattern),
      options_(options),
      slots_(std::move(slots)),
      kernels_(front_kernels(options.instructions)),
      size_(pattern.size()) {}

LinearSolverStatistics MultifrontalLu::statistics() const { return statistics_; }

int MultifrontalLu::factorize(std::span<const double> given) {
  ++statistics_.factorizations;
  // Dropped unknowns depend on the values.
  if (planned_ && !options_.ignore_singular && repeat(given)) return success;
  return start_again(given);
}

int MultifrontalLu::start_again(std::span<const double> given) {
  ++statistics_.pivot_searches;
  std::vector<double> gathered(slots_.size());
  std::ranges::transform(slots_, gathered.begin(), [&](int slot) { return given[slot]; });
  const std::span<const double> values = slots_.empty() ? given : gathered;
  std::vector<double> pivots_alone;  // the values without negligible diagonal entries
  if (!options_.tiny_diagonal.empty()) {
    pivots_alone.assign(values.begin(), values.end());
    for (const int j : options_.tiny_diagonal) pivots_alone[static_cast<std::size_t>(pattern_.slot(j, j))] = 0;
  }
  const std::span<const double> structure = pivots_alone.empty() ? values : pivots_alone;
  if (!tree_) tree_ = elimination_tree(pattern_, structure, options_.dependent);
  scaling_ = balance(pattern_, structure);
  // The search is usually trivial without multipliers.
  planned_ = !options_.ignore_singular && std::ranges::none_of(scaling_.multiplier, [](char m) { return m != 0; }) &&
             adopt(pivots_in_order(*tree_), values, given) <= largest_residual && growth_ <= harmless_growth &&
             regular();
  if (planned_) return success;
  return search_and_adopt(values, given);
}

// If no search passes the test, because of weak constraints, a stricter search may only fill the factors: the best
// pivots are used, and a search whose fronts outgrow those of the first one is abandoned.
int MultifrontalLu::search_and_adopt(std::span<const double> values, std::span<const double> given) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  int singular = success, largest_front = pattern_.size();
  double best = 0, in_place = 0, least = infinite;
  const auto adopt_by = [&](double ratio) {  // the residual of the test; infinite: pivots are as before
    PivotSearch search = search_pivots(pattern_, *tree_, values, scaling_, ratio, options_, kernels_, largest_front);
    if (search.outgrown) return infinite;
    singular = search.singular_column;
    if (singular != success) return infinite;
    if (in_place == 0) largest_front = harmless_fill * search.largest_front;
    in_place = ratio;
    return adopt(std::move(search.fronts), values, given);
  };
  for (const double ratio : smallest_ratios) {
    const double residual = adopt_by(ratio);
    if (residual < least) {
      least = residual;
      best = ratio;
    }
    if (residual <= largest_residual) break;
  }
  planned_ = in_place > 0;
  if (best > 0 && best != in_place) adopt_by(best);
  return planned_ ? success : singular;
}

// Factorizes with these pivots, and tests them.
double MultifrontalLu::adopt(std::vector<PivotedFront> fronts, std::span<const double> values,
                             std::span<const double> given) {
  plan(std::move(fronts));
  repeat(given);
  planned_growth_ = std::max(growth_, 1.0);
  return residual_of_test(values);
}

// Residual for a right-hand side with a known solution of size one, in scaled unknowns and equations.
double MultifrontalLu::residual_of_test(std::span<const double> values) {
  const auto starts = pattern_.column_start(), rows = pattern_.row_index();
  std::vector<double> x(static_cast<std::size_t>(size_), 0.0), size(x);
  const auto for_each_entry = [&](auto&& f) {
    for (int j = 0; j < size_; ++j) {
      for (int k = starts[j]; k < starts[j + 1]; ++k) f(rows[k], j, values[k]);
    }
  };
  for_each_entry([&](int i, int j, double value) {
    const double term = value * scaling_.column(j);
    x[i] += j % 2 == 0 ? term : -term;
    size[i] += std::abs(term);
  });
  std::vector<double> b = x;
  solve(x);
  for_each_entry([&](int i, int j, double value) { b[i] -= value * x[j]; });
  double largest_x = 1, residual = 0, largest = 0;
  const auto include = [](double& so_far, double number) {  // NaN counts as the largest
    if (!(number <= so_far)) so_far = number;
  };
  for (int j = 0; j < size_; ++j) {
    include(largest_x, std::abs(x[j]) / scaling_.column(j));
    include(residual, std::abs(b[j]) * scaling_.row(j));
    include(largest, size[j] * scaling_.row(j));
  }
  return residual / (largest * largest_x);
}

// The same steps with other values. False: entries of the factors are too large, or a pivot is too small.
bool MultifrontalLu::repeat(std::span<const double> given) {
  growth_ = 0;
  for (const Front& front : fronts_) {
    assemble(front, given);
    double* panel = columns(front);
    double* right = panel + static_cast<std::ptrdiff_t>(front.length) * front.pivots;
    double* inverse = inverse_pivot_.data() + front.first_slot;
    growth_ = std::max(growth_, kernels_.factorize(panel, front.pivots, front.length, inverse));
    kernels_.eliminate(panel, front.pivots, front.length, right, front.updates);
    kernels_.pack(panel, {front.pivots, front.updates}, front.length, right, inverse, factor(front.lower),
                  factor(front.upper));
  }
  const double limit =
      std::max(std::min(largest_growth * planned_growth_, largest_size), smallest_growth * planned_growth_);
  return growth_ <= limit && regular();
}

// All pivots are larger than the threshold.
bool MultifrontalLu::regular() const {
  bool all = true;
  for (int k = 0; k < pivot_slots_; ++k)
    all &= std::abs(inverse_pivot_[k]) * least_pivot_[k] < 1;  // not if it is not finite
  return all;
}

// Runs of this length and of shorter ones.
template <int Length>
void MultifrontalLu::take_runs(const Front& front, const double* given, double* to) const {
  const int *end = front.end_of_entries.data() + (longest_run - Length),
            first = Length == longest_run ? front.first_entry : end[-1];
  for (const Entry& entry : std::span(entries_).subspan(first, *end - first))
    std::memcpy(to + entry.target, given + entry.slot, Length * sizeof(double));
  if constexpr (Length > 1) take_runs<Length - 1>(front, given, to);
}

void MultifrontalLu::assemble(const Front& front, std::span<const double> given) {
  double* to = columns(front);
  std::fill_n(to, static_cast<std::size_t>(front.length) * (front.pivots + front.updates), 0.0);
  take_runs<longest_run>(front, given.data(), to);
  for (std::size_t kind = 0; kind < scales_.size(); ++kind) {
    const int* end = front.end_of_entries.data() + longest_run + kind;
    for (int k = end[-1]; k < *end; ++k)
      to[entries_[k].target] = given[static_cast<std::size_t>(entries_[k].slot)] * scales_[kind];
  }
  for (int c = front.children; c < front.end_of_children; ++c) take_over(fronts_[children_[c]], to);
}

// Adds the update matrix of a child.
void MultifrontalLu::take_over(const Front& child, double* to) {
  const double* from = columns(child) + static_cast<std::ptrdiff_t>(child.length) * child.pivots;
  const std::span runs = std::span(runs_).subspan(child.runs, child.end_of_runs - child.runs);
  kernels_.add_columns(from, child.length, child.updates, runs, places_.data() + child.first_update, to);
}

template <class Place>
void MultifrontalLu::solve_at(Place&& place, std::span<double> b) {
  double* const x = unknowns_.data();
  double* const end = x + pivot_slots_;
  for (std::size_t k = 0; k < unknowns_.size(); ++k) x[k] = b[place(row_of_slot_[k])] * row_scale_[k];
  kernels_.forward(sizes_, factor(0), row_slot_.data(), x, work_.data());
  std::fill(end, x + unknowns_.size(), 0.0);
  kernels_.backward(sizes_, factor(first_upper_), column_slot_.data() + column_slot_.size(), x, end);
  for (int j = 0; j < size_; ++j) b[place(j)] = x[slot_of_column_[j]] * column_scale_[j];
}

void MultifrontalLu::solve(std::span<double> b) {
  solve_at([](int j) { return j; }, b);
}

void MultifrontalLu::solve_for(std::span<const int> places, std::span<double> x) {
  solve_at([places](int j) { return places[static_cast<std::size_t>(j)]; }, x);
}

}  // namespace dalembert
