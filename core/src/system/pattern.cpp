#include "dalembert/system/pattern.hpp"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <span>
#include <stdexcept>
#include <utility>

#include "dalembert/model/errors.hpp"

namespace dalembert {

void Couplings::add(std::span<const int> rows, std::span<const int> columns) {
  if (rows.empty() || columns.empty()) return;
  open_ = false;
  const std::size_t begin = unknowns_.size();
  if (!std::ranges::equal(rows, columns)) unknowns_.insert(unknowns_.end(), rows.begin(), rows.end());
  blocks_.push_back({begin, unknowns_.size()});
  unknowns_.insert(unknowns_.end(), columns.begin(), columns.end());
}

void Couplings::add(int row, int column) {
  if (row == column) return;  // the diagonal is there in any case
  if (!open_ || unknowns_[blocks_.back().rows] != row) {
    blocks_.push_back({unknowns_.size(), unknowns_.size() + 1});
    unknowns_.push_back(row);
    open_ = true;
  }
  unknowns_.push_back(column);
}

namespace {

// Places in a matrix are counted by int.
void check_entries(std::int64_t entries, int size, const char* storage, const char* advice) {
  constexpr std::int64_t most = std::numeric_limits<int>::max();
  if (entries <= most) return;
  const std::int64_t gigabytes = entries * static_cast<std::int64_t>(sizeof(double)) / 1'000'000'000;
  refuse(ErrorKind::value,
         {.item = std::string("the ") + storage + " system matrix of " + std::to_string(size) + " unknowns",
          .problem = "it is too large: it would take " + std::to_string(gigabytes) + " GB",
          .received = std::to_string(entries) + " entries",
          .expected = std::to_string(most) + " at most",
          .advice = advice});
}
void check_sparse(std::int64_t entries, int size) {
  check_entries(entries, size, "sparse",
                "Use items that couple fewer coordinates with each other, e.g. a reduced model.");
}

// The unknowns that each unknown is coupled with.
class Neighbours {
 public:
  Neighbours(int size, const Couplings& couplings) : first_(static_cast<std::size_t>(size) + 2, 0) {
    couplings.for_each([&](auto unknowns, auto others) {
      for (const int i : unknowns) are_columns_ = ++first_[static_cast<std::size_t>(i) + 2] == 1 && are_columns_;
      are_columns_ = are_columns_ && unknowns.data() == others.data() &&
                     std::ranges::adjacent_find(others, std::greater_equal()) == others.end();
    });
    for (std::size_t i = 2; i < first_.size(); ++i) first_[i] += first_[i - 1];
    lists_.resize(static_cast<std::size_t>(first_.back()));
    couplings.for_each([&](auto unknowns, auto others) {
      for (const int i : unknowns) lists_[static_cast<std::size_t>(first_[static_cast<std::size_t>(i) + 1]++)] = others;
    });
  }
  // Calls f with each of them, itself among them, once or more often.
  template <class F>
  void for_each(int i, F&& f) const {
    f(i);
    for (int k = first_[i]; k < first_[i + 1]; ++k)
      for (const int other : lists_[k]) f(other);
  }
  // Whether each unknown has at most one sorted list, which contains it: true if each body has its own unknowns.
  bool are_columns() const { return are_columns_; }
  std::span<const int> list(int i) const {
    return first_[i] < first_[i + 1] ? lists_[first_[i]] : std::span<const int>();
  }

 private:
  bool are_columns_ = true;
  std::vector<int> first_;  // start in lists_, and the end
  std::vector<std::span<const int>> lists_;
};

Pattern pattern_of_columns(int size, const Neighbours& neighbours) {
  std::vector<int> start(static_cast<std::size_t>(size) + 1, 0), rows;
  std::int64_t entries = 0;
  for (int j = 0; j < size; ++j) entries += std::max<std::int64_t>(1, std::ssize(neighbours.list(j)));
  check_sparse(entries, size);
  rows.reserve(static_cast<std::size_t>(entries));
  for (int j = 0; j < size; ++j) {
    const std::span<const int> column = neighbours.list(j);
    rows.insert(rows.end(), column.begin(), column.end());
    if (column.empty()) rows.push_back(j);
    start[static_cast<std::size_t>(j) + 1] = static_cast<int>(rows.size());
  }
  return Pattern::sparse(std::move(start), std::move(rows));
}

}  // namespace

Pattern Pattern::dense(int size) {
  check_entries(std::int64_t{size} * size, size, "dense",
                "Use simulationSettings.linearSolverType = exu.LinearSolverType.EigenSparse.");
  Pattern p;
  p.size_ = size;
  return p;
}

// Each column is appended to its rows: since columns come in ascending order, so do the entries of each row, which are by symmetry
// those of a column.
Pattern Pattern::sparse(int size, const Couplings& couplings) {
  couplings.for_each([size](auto unknowns, auto others) {
    check_sparse(static_cast<std::int64_t>(unknowns.size()) * static_cast<std::int64_t>(others.size()), size);
  });
  const Neighbours neighbours(size, couplings);
  if (neighbours.are_columns()) return pattern_of_columns(size, neighbours);
  std::vector<int> start(static_cast<std::size_t>(size) + 1, 0), last(static_cast<std::size_t>(size), -1);
  const auto for_each_entry = [&](auto&& f) {
    std::ranges::fill(last, -1);
    for (int j = 0; j < size; ++j) {
      neighbours.for_each(j, [&](int i) {
        if (std::exchange(last[i], j) != j) f(i, j);
      });
    }
  };
  for_each_entry([&](int, int j) { ++start[j + 1]; });
  std::int64_t entries = 0;
  for (const int in_column : start) entries += in_column;
  check_sparse(entries, size);
  for (int j = 0; j < size; ++j) start[j + 1] += start[j];
  std::vector<int> next(start.begin(), start.end() - 1), rows(static_cast<std::size_t>(start[size]));
  for_each_entry([&](int i, int j) { rows[next[i]++] = j; });
  return sparse(std::move(start), std::move(rows));
}

Pattern Pattern::sparse(std::vector<int> column_start, std::vector<int> row_index) {
  Pattern p;
  p.size_ = static_cast<int>(column_start.size()) - 1;
  p.column_start_ = std::move(column_start);
  p.row_index_ = std::move(row_index);
  return p;
}

bool Pattern::contains(int row, int column) const {
  if (is_dense()) return true;
  return std::binary_search(row_index_.begin() + column_start_[column], row_index_.begin() + column_start_[column + 1],
                            row);
}

int Pattern::slot(int row, int column) const {
  if (is_dense()) return column * size_ + row;
  const auto begin = row_index_.begin() + column_start_[column], end = row_index_.begin() + column_start_[column + 1];
  const auto found = std::lower_bound(begin, end, row);
  if (found == end || *found != row) throw std::logic_error("an entry outside the pattern of the system matrix");
  return static_cast<int>(found - row_index_.begin());
}

}  // namespace dalembert
