// Where an entry of the system matrix lives: fixed at Assemble, for dense and for compressed-column storage alike.
#pragma once

#include <span>
#include <vector>

namespace dalembert {

class Pattern {
 public:
  static Pattern dense(int size);
  // `entries`: (row, column) pairs, repeated as they come; the pattern is made structurally symmetric and has the full diagonal.
  static Pattern sparse(int size, std::span<const std::pair<int, int>> entries);

  bool is_dense() const { return column_start_.empty(); }
  int size() const { return size_; }
  int values() const { return is_dense() ? size_ * size_ : column_start_.back(); }
  bool contains(int row, int column) const;
  // Index into the values; the entry must be in the pattern. Dense storage is by columns.
  int slot(int row, int column) const;

  std::span<const int> column_start() const { return column_start_; }
  std::span<const int> row_index() const { return row_index_; }

 private:
  int size_ = 0;
  std::vector<int> column_start_, row_index_;  // empty when dense
};

}  // namespace dalembert
