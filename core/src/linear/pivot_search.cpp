// Duff, Reid: The multifrontal solution of unsymmetric sets of linear equations, SIAM J. Sci. Stat. Comput. 5 (1984).
#include "pivot_search.hpp"

#include <algorithm>
#include <cmath>

namespace dalembert {

namespace {

// Larger fronts try the given order first.
constexpr int small_front = 16;
// If singular matrices are allowed, smaller entries relative to the column of the matrix are round-off.
constexpr double round_off = 1e-14;
// Inverses of triangles that solutions multiply by are exact to so many times the round-off of their entries.
constexpr double harmless_ratio = 1e3;

// One front as a square matrix; the first `candidates` rows and columns are complete and may be eliminated.
class DenseFront {
 public:
  DenseFront(std::vector<int> rows, std::vector<int> columns, int candidates)
      : rows_(std::move(rows)),
        columns_(std::move(columns)),
        candidates_(candidates),
        size_(static_cast<int>(rows_.size())),
        length_(padded(size_)),
        values_(static_cast<std::size_t>(length_) * size_, 0.0) {}

  double& at(int row, int column) { return values_[static_cast<std::size_t>(column) * length_ + row]; }

  // `usable(row, column, size, below)`: acceptable as pivot, `below` being the largest entry of the update rows.
  // `tiny_last`: pivots that are tiny relative to their rows come last.
  template <class Usable>
  void eliminate(Usable&& usable, const FrontKernels& kernels, bool tiny_last) {
    if (candidates_ <= small_front || !eliminate_in_order(usable, kernels, tiny_last)) {
      if (tiny_last) eliminate_all(usable, true);
      eliminate_all(usable, false);
    }
    kernels.eliminate(values_.data(), pivots_, length_, column(candidates_), size_ - candidates_);
  }

  int left() const { return candidates_ - pivots_; }  // candidates without pivot
  double* column(int j) { return values_.data() + static_cast<std::size_t>(j) * length_; }
  // The front; only its values are kept.
  PivotedFront take_order() { return {std::move(rows_), std::move(columns_), pivots_}; }

 private:
  // Without exchanges. False, and nothing has happened, if one is called for.
  template <class Usable>
  bool eliminate_in_order(Usable&& usable, const FrontKernels& kernels, bool without_tiny) {
    const std::vector<double> before(column(0), column(candidates_));
    std::vector<double> inverse(static_cast<std::size_t>(candidates_));
    bool good = kernels.factorize(column(0), candidates_, length_, inverse.data()) <= harmless_growth;
    for (int k = 0; k < candidates_; ++k) good &= usable(rows_[k], columns_[k], 1 / std::abs(inverse[k]), 0);
    for (int k = 0; k < candidates_ && good && without_tiny; ++k) good = !is_tiny(k, k, std::abs(at(k, k)));
    if (good) {
      pivots_ = candidates_;
    } else {
      std::copy(before.begin(), before.end(), column(0));
    }
    return good;
  }

  // Columns that fail are tried again once another pivot has been found.
  template <class Usable>
  void eliminate_all(Usable&& usable, bool without_tiny) {
    for (int before = -1; before < pivots_ && pivots_ < candidates_;) {
      before = pivots_;
      for (int end = candidates_; pivots_ < end;) {
        if (!eliminate_next(usable, without_tiny)) exchange_columns(pivots_, --end);
      }
    }
  }

  // Compares with the entries of its row behind column k.
  bool is_tiny(int row, int k, double pivot) {
    double largest = 0;
    for (int j = k + 1; j < candidates_; ++j) largest = std::max(largest, std::abs(at(row, j)));
    return harmless_ratio * pivot < largest;
  }

  template <class Usable>
  bool eliminate_next(Usable&& usable, bool without_tiny) {
    const int k = pivots_;
    double* c = column(k);
    int best = k;
    double largest = 0, below = 0;
    for (int i = k; i < candidates_; ++i) {
      if (const double x = std::abs(c[i]); x > largest) {
        largest = x;
        best = i;
      }
    }
    for (int i = candidates_; i < size_; ++i) below = std::max(below, std::abs(c[i]));
    if (!usable(rows_[best], columns_[k], largest, below) || (without_tiny && is_tiny(best, k, largest))) return false;
    exchange_rows(k, best);
    const double inverse = 1 / c[k];
    for (int i = k + 1; i < size_; ++i) c[i] *= inverse;
    for (int j = k + 1; j < candidates_; ++j) {
      double* d = column(j);
      const double u = d[k];
      if (u == 0) continue;
      for (int i = k + 1; i < size_; ++i) d[i] -= u * c[i];
    }
    ++pivots_;
    return true;
  }

  void exchange_rows(int i, int j) {
    if (i == j) return;
    std::swap(rows_[i], rows_[j]);
    for (int k = 0; k < size_; ++k) std::swap(at(i, k), at(j, k));
  }

  void exchange_columns(int i, int j) {
    if (i == j) return;
    std::swap(columns_[i], columns_[j]);
    std::swap_ranges(column(i), column(i) + length_, column(j));
  }

  std::vector<int> rows_, columns_;
  int candidates_, size_, length_;
  int pivots_ = 0;
  std::vector<double> values_;
};

class Search {
 public:
  Search(const Pattern& pattern, const std::vector<FrontStructure>& tree, std::span<const double> values,
         const Scaling& scaling, double smallest_ratio, const LinearSolverOptions& options, const FrontKernels& kernels)
      : tree_(tree),
        values_(values),
        scaling_(scaling),
        smallest_ratio_(smallest_ratio),
        kernels_(kernels),
        entries_(pattern, tree),
        waiting_(tree.size()),
        row_place_(pattern.size()),
        column_place_(pattern.size()),
        threshold_(options.pivot_threshold),
        smallest_(pattern.size(), 0.0),
        ignore_singular_(options.ignore_singular),
        tiny_last_(!options.tiny_diagonal.empty()) {
    if (!options.ignore_singular) return;
    for (int j = 0; j < pattern.size(); ++j) {
      double largest = 0;
      for (int k = pattern.column_start()[j]; k < pattern.column_start()[j + 1]; ++k) {
        largest = std::max(largest, std::abs(values[k]) * scaling.row(pattern.row_index()[k]));
      }
      smallest_[j] = round_off * largest * scaling.column(j);
    }
  }

  PivotSearch run(int most_rows) {
    fronts_.reserve(tree_.size());
    int largest_front = 0;
    for (int f = 0; f < static_cast<int>(tree_.size()); ++f) {
      const int rows = rows_of(f);
      if (rows > most_rows) return {.fronts = {}, .outgrown = true};
      largest_front = std::max(largest_front, rows);
      DenseFront front = assemble(f);
      front.eliminate(
          [&](int row, int column, double pivot, double below) {
            return pivot >= smallest_ratio_ * below && pivot > smallest_[column] &&
                   pivot > threshold_ * scaling_.row(row) * scaling_.column(column);
          },
          kernels_, tiny_last_);
      const int parent = tree_[f].parent;
      fronts_.push_back(front.take_order());
      if (parent < 0 && front.left() > 0 && !ignore_singular_) {
        const int singular = fronts_.back().columns[fronts_.back().pivots];
        return {std::move(fronts_), singular, largest_front};
      }
      if (parent >= 0) waiting_[parent].push_back({f, std::move(front)});
    }
    return {std::move(fronts_), LinearSolver::success, largest_front};
  }

 private:
  // Update matrix of a child.
  struct Child {
    int front;
    DenseFront values;
  };

  int rows_of(int f) const {
    std::size_t rows = tree_[f].pivots.size() + tree_[f].updates.size();
    for (const Child& child : waiting_[f]) rows += static_cast<std::size_t>(child.values.left());
    return static_cast<int>(rows);
  }

  DenseFront assemble(int f) {
    const FrontStructure& structure = tree_[f];
    std::vector<Child>& children = waiting_[f];
    std::vector<int> rows = structure.pivots, columns = structure.pivots;
    for (const Child& child : children) {
      const PivotedFront& order = fronts_[child.front];
      const auto add = [&](std::vector<int>& to, const std::vector<int>& from) {
        to.insert(to.end(), from.begin() + order.pivots, from.begin() + order.pivots + child.values.left());
      };
      add(rows, order.rows);
      add(columns, order.columns);
    }
    const int candidates = static_cast<int>(rows.size());
    rows.insert(rows.end(), structure.updates.begin(), structure.updates.end());
    columns.insert(columns.end(), structure.updates.begin(), structure.updates.end());
    for (int k = 0; k < static_cast<int>(rows.size()); ++k) {
      row_place_[rows[k]] = k;
      column_place_[columns[k]] = k;
    }
    DenseFront front(std::move(rows), std::move(columns), candidates);
    entries_.for_each(f, [&](int i, int j, int slot) {
      front.at(row_place_[i], column_place_[j]) = values_[slot] * (scaling_.row(i) * scaling_.column(j));
    });
    for (Child& child : children) {
      const PivotedFront& order = fronts_[child.front];
      for (std::size_t j = order.pivots; j < order.columns.size(); ++j) {
        double* to = front.column(column_place_[order.columns[j]]);
        const double* from = child.values.column(static_cast<int>(j));
        for (std::size_t i = order.pivots; i < order.rows.size(); ++i) to[row_place_[order.rows[i]]] += from[i];
      }
    }
    children = {};
    return front;
  }

  const std::vector<FrontStructure>& tree_;
  std::span<const double> values_;
  const Scaling& scaling_;
  double smallest_ratio_;
  const FrontKernels& kernels_;
  FrontEntries entries_;
  std::vector<PivotedFront> fronts_;
  std::vector<std::vector<Child>> waiting_;  // children of each front, until it adds their update matrices
  std::vector<int> row_place_, column_place_;  // positions in the current front
  double threshold_;
  std::vector<double> smallest_;
  bool ignore_singular_, tiny_last_;
};

}  // namespace

std::vector<PivotedFront> pivots_in_order(const std::vector<FrontStructure>& tree) {
  std::vector<PivotedFront> fronts;
  fronts.reserve(tree.size());
  for (const FrontStructure& front : tree) {
    std::vector<int> unknowns = front.pivots;
    unknowns.insert(unknowns.end(), front.updates.begin(), front.updates.end());
    fronts.push_back({unknowns, std::move(unknowns), static_cast<int>(front.pivots.size())});
  }
  return fronts;
}

PivotSearch search_pivots(const Pattern& pattern, const std::vector<FrontStructure>& tree,
                          std::span<const double> values, const Scaling& scaling, double smallest_ratio,
                          const LinearSolverOptions& options, const FrontKernels& kernels, int most_rows) {
  return Search(pattern, tree, values, scaling, smallest_ratio, options, kernels).run(most_rows);
}

}  // namespace dalembert
