#include "dalembert/system/pattern.hpp"

#include <algorithm>
#include <stdexcept>

namespace dalembert {

Pattern Pattern::dense(int size) {
  Pattern p;
  p.size_ = size;
  return p;
}

Pattern Pattern::sparse(int size, std::span<const std::pair<int, int>> entries) {
  // Both triangles and the diagonal, bucketed by column, then sorted and made unique within each column.
  Pattern p;
  p.size_ = size;
  std::vector<int> start(static_cast<std::size_t>(size) + 1, 0);
  const auto count = [&](int column) { ++start[static_cast<std::size_t>(column) + 1]; };
  for (const auto& [row, column] : entries) {
    count(column);
    if (row != column) count(row);
  }
  for (int i = 0; i < size; ++i) count(i);
  for (int i = 0; i < size; ++i) start[i + 1] += start[i];
  std::vector<int> rows(static_cast<std::size_t>(start[size])), next(start.begin(), start.end() - 1);
  for (const auto& [row, column] : entries) {
    rows[next[column]++] = row;
    if (row != column) rows[next[row]++] = column;
  }
  for (int i = 0; i < size; ++i) rows[next[i]++] = i;
  p.column_start_.assign(1, 0);
  p.column_start_.reserve(static_cast<std::size_t>(size) + 1);
  for (int i = 0; i < size; ++i) {
    const auto begin = rows.begin() + start[i], end = rows.begin() + start[i + 1];
    std::sort(begin, end);
    p.row_index_.insert(p.row_index_.end(), begin, std::unique(begin, end));
    p.column_start_.push_back(static_cast<int>(p.row_index_.size()));
  }
  return p;
}

bool Pattern::contains(int row, int column) const {
  if (is_dense()) return true;
  return std::binary_search(row_index_.begin() + column_start_[column], row_index_.begin() + column_start_[column + 1], row);
}

int Pattern::slot(int row, int column) const {
  if (is_dense()) return column * size_ + row;
  const auto begin = row_index_.begin() + column_start_[column], end = row_index_.begin() + column_start_[column + 1];
  const auto found = std::lower_bound(begin, end, row);
  if (found == end || *found != row) throw std::logic_error("an entry outside the pattern of the system matrix");
  return static_cast<int>(found - row_index_.begin());
}

}  // namespace dalembert
