// Dense arithmetic of the sparse factorization: LU of the pivot columns of a front, and updates of its remaining
// columns. Matrices are stored by columns, whose length is a multiple of `front_chunk`; entries between the last row
// and the end of a column are computed but unused.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "solution_sweeps.hpp"

namespace dalembert {

class EliminationList;

inline constexpr int front_chunk = 4;
inline constexpr int front_slack = 8;

// Length of a column of `rows` numbers.
constexpr int padded(int rows) { return (rows + front_chunk - 1) / front_chunk * front_chunk; }

// Rows that stand one after the other in a child as well as in its parent.
struct RowRun {
  int from, to, length;
};

struct FrontKernels {
  const char* name;
  // Factors of the first `pivots` columns, without exchanges: L, without its unit diagonal, below the diagonal, U in the rest;
  // `inverse` receives the reciprocals of the pivots. Returns the largest entry of L.
  double (*factorize)(double* panel, int pivots, int length, double* inverse);
  // Eliminates the pivots from `count` further columns: their first `pivots` rows become U, the remaining rows the
  // Schur complement. A right-hand side is such a column.
  void (*eliminate)(const double* panel, int pivots, int length, double* columns, int count);
  // w := U^-1 w. Reads padded(pivots) numbers of w and of `inverse`.
  void (*substitute)(const double* panel, int pivots, int length, const double* inverse, double* w);
  // Adds columns of a child to those of its parent, which start at to + places[j]. Up to front_slack numbers behind a
  // run are read and written unchanged.
  void (*add_columns)(const double* from, int length, int count, std::span<const RowRun> runs, const int* places,
                      double* to);
  // A factorized and eliminated front into the streams of solution_sweeps.hpp. Reads up to front_slack numbers more than the
  // front has; `inverse` is read up to the last slot.
  void (*pack)(const double* panel, const FrontSize& front, int length, const double* columns, const double* inverse,
               double* lower, double* upper);
  // x := L^-1 x and x := U^-1 x for all fronts, by slots. `rows` and `columns` are the slots of the updates of each
  // front, `w` is work space for the longest. The backward sweep takes the ends of `columns`, and of the slots of
  // fronts.
  void (*forward)(std::span<const FrontSize> fronts, const double* lower, const int* rows, double* x, double* w);
  void (*backward)(std::span<const FrontSize> fronts, const double* upper, const int* columns_end, double* x,
                   double* x_end);
  // The three functions above for listed operations, bit-identical: gathering the entries of the factors from a
  // matrix, false if other entries are nonzero; factors and reciprocals of the pivots in place, returning the largest
  // entry of L; and w := U^-1 L^-1 w.
  bool (*take_listed)(const EliminationList& list, const double* values, double* a);
  double (*factorize_listed)(const EliminationList& list, double* a, double* inverse);
  void (*solve_listed)(const EliminationList& list, const double* a, const double* inverse, double* w);
};

// Kernels for this processor, best first.
std::span<const FrontKernels* const> available_front_kernels();
// By name; empty: the best.
const FrontKernels& front_kernels(std::string_view name);

}  // namespace dalembert
