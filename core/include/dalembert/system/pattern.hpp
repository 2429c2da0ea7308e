// Where an entry of the system matrix lives: fixed at Assemble, for dense and for compressed-column storage alike.
//
// Slots: a batch tells which entries it writes, always in one order, by `visit`. Once to make the pattern, once more to learn where
// each of them is stored; from then on its tangent adds to known places, in that order.
//
//     visit:      entry(4, 7)  entry(7, 4)  entry(7, 7) ...     rows and columns of the system
//     slots:      31           52           55          ...     places in the values, looked up once
//     tangent:    values[31] += k_0,  values[52] += k_1,  values[55] += k_2, ...
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace dalembert {

// Couplings between unknowns, from which sparse patterns are made.
class Couplings {
 public:
  // Each of the rows with each of the columns.
  void add(std::span<const int> rows, std::span<const int> columns);
  // Best one row after the other.
  void add(int row, int column);

  // Calls f(unknowns, others) with lists that couple each unknown with each of `others`, until both directions are
  // covered.
  template <class F>
  void for_each(F&& f) const {
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      const std::size_t end = b + 1 < blocks_.size() ? blocks_[b + 1].rows : unknowns_.size();
      const std::span all(unknowns_);
      const auto rows = all.subspan(blocks_[b].rows, blocks_[b].columns - blocks_[b].rows);
      const auto columns = all.subspan(blocks_[b].columns, end - blocks_[b].columns);
      if (rows.empty()) {
        f(columns, columns);
      } else {
        f(rows, columns);
        f(columns, rows);
      }
    }
  }

 private:
  // Starts; rows that equal the columns are stored once.
  struct Block {
    std::size_t rows, columns;
  };
  std::vector<int> unknowns_;
  std::vector<Block> blocks_;
  bool open_ = false;  // the last block has one row, and columns may follow
};

struct FrontStructure;

// How a pattern is eliminated (linear/elimination_tree.hpp).
struct EliminationTree {
  // unknowns with a pivot; if constraints are redundant, also those that neither have nor need one
  std::vector<bool> made_for;
  std::shared_ptr<const std::vector<FrontStructure>> fronts;
};

class Pattern {
 public:
  static Pattern dense(int size);
  // Structurally symmetric and with the full diagonal.
  static Pattern sparse(int size, const Couplings& couplings);
  // Makes a pattern from sorted columns, rows in ascending order.
  static Pattern sparse(std::vector<int> column_start, std::vector<int> row_index);

  bool is_dense() const { return column_start_.empty(); }
  int size() const { return size_; }
  int values() const { return is_dense() ? size_ * size_ : column_start_.back(); }
  bool contains(int row, int column) const;
  // Index into the values; the entry must be in the pattern. Dense storage is by columns.
  int slot(int row, int column) const;
  // First slot of a column in the values; at size(), the end.
  std::size_t first_slot(std::size_t column) const {
    return is_dense() ? column * static_cast<std::size_t>(size_) : static_cast<std::size_t>(column_start_[column]);
  }
  // Calls f(slot) for rows of one column. Rows that follow each other take no search.
  template <class F>
  void for_each_slot(std::span<const int> rows, int column, F&& f) const {
    if (is_dense()) {
      for (const int row : rows) f(column * size_ + row);
      return;
    }
    const int* const stored = row_index_.data();
    const int end = column_start_[column + 1];
    int next = column_start_[column];
    for (const int row : rows) {
      if (next == end || stored[next] != row) next = slot(row, column);
      f(next++);
    }
  }
  // Calls f(slot, transposed) for each slot of a sparse pattern, with that of the entry whose row and column are exchanged.
  template <class F>
  void for_each_transposed(F&& f) const {
    // Columns are visited in the order of the rows opposite to them.
    std::vector<int> next(column_start_.begin(), column_start_.end() - 1);
    int* const slots = next.data();
    const int* const rows = row_index_.data();
    for (int slot = 0, end = values(); slot < end; ++slot) f(slot, slots[rows[slot]]++);
  }

  std::span<const int> column_start() const { return column_start_; }
  std::span<const int> row_index() const { return row_index_; }

  // Cache of elimination trees for later linear solvers. Like its system, a pattern has one user at a time.
  std::vector<EliminationTree>& known_trees() const { return known_trees_; }

 private:
  int size_ = 0;
  std::vector<int> column_start_, row_index_;  // empty when dense
  mutable std::vector<EliminationTree> known_trees_;
};

}  // namespace dalembert
