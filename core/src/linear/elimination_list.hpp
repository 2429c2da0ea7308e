// LU factors of a small matrix with many zeros: the operations on nonzero entries, listed once for an order of
// pivots. They are those of the dense kernels, in the same order: skipping zeros does not change results.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace dalembert {

// Rows or columns as bits. Up to so many, the dense kernels eliminate without blocks, pivot by pivot.
using StepMask = std::uint32_t;

class EliminationList {
 public:
  static constexpr int largest_size = 32;
  // x[target] -= a[factor] y[of]
  struct Update {
    std::uint16_t target, factor, of;
  };
  // Back substitution goes by groups of as many unknowns as the dense kernels take at once: within a group factors are
  // scaled by the pivots; it acts on the unknowns before it when its own are known. Ends are those in `within` and `before`.
  struct Group {
    std::uint16_t first, end, within_end, before_end;
  };
  struct Source {
    std::uint16_t from, to;  // place in the matrix, by columns, and in the factors
  };

  // Row k of the factors is row_of_step[k] of the matrix; `occupied` marks entries, by columns, that may differ from
  // zero.
  EliminationList(std::span<const int> row_of_step, std::span<const char> occupied);
  // Whether it takes less time than the dense kernels.
  bool pays() const { return updates.size() <= static_cast<std::size_t>(size) * static_cast<std::size_t>(size); }

  int size = 0;
  int entries = 0;  // entries of the factors: pivots first, then L column by column, then U
  std::vector<Source> sources;
  std::vector<std::uint16_t> fill;                     // places without a source
  std::vector<std::int64_t> unoccupied;  // by position in the matrix: mask of bits that must be zero
  std::vector<std::uint16_t> lower_ends, update_ends;  // by pivot
  std::vector<Update> updates;  // updates of the factors, pivot by pivot
  std::vector<Update> forward;  // updates of a right-hand side
  std::vector<Update> within, before;
  std::vector<Group> groups;

 private:
  void list_sources(std::span<const int> row_of_step, std::span<const char> occupied);
  void list_factorization();
  void list_back_substitution();
  std::uint16_t& place(int i, int j) {
    return places_[static_cast<std::size_t>(j) * static_cast<std::size_t>(size) + static_cast<std::size_t>(i)];
  }

  std::vector<StepMask> rows_, columns_;  // pattern of the factors
  std::vector<std::uint16_t> places_;
};

}  // namespace dalembert
