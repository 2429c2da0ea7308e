// Dense arithmetic of the sparse factorization: LU of the pivot columns of a front, with what follows for its other columns.
//
// Matrices are stored by columns, which are as long as a multiple of `front_chunk`; what is between the last row and the end
// of a column takes part in the arithmetic and means nothing.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace dalembert {

class EliminationList;

inline constexpr int front_chunk = 4;

// Length of a column of `rows` numbers.
constexpr int padded(int rows) { return (rows + front_chunk - 1) / front_chunk * front_chunk; }

struct FrontKernels {
  const char* name;
  // Factors of the first `pivots` columns, without exchanges: L, without its unit diagonal, below the diagonal, U in the rest;
  // `inverse` receives the reciprocals of the pivots. Returns the largest entry of L.
  double (*factorize)(double* panel, int pivots, int length, double* inverse);
  // Eliminates the pivots from `count` further columns: their first `pivots` rows become U, the others the Schur complement.
  // A right-hand side is such a column.
  void (*eliminate)(const double* panel, int pivots, int length, double* columns, int count);
  // w := U^-1 (w - upper z), where `upper` holds `count` columns right of the pivot columns, as long as w: padded(pivots). As
  // many numbers of `inverse` are read.
  void (*substitute)(const double* panel, int pivots, int length, const double* inverse, const double* upper, int count,
                     const double* z, double* w);
  // The same of listed operations, digit by digit: the factors' entries out of a matrix, false if others differ from zero;
  // factors and reciprocals of the pivots in place of the entries, returning the largest of L; and w := U^-1 L^-1 w.
  bool (*take_listed)(const EliminationList& list, const double* values, double* a);
  double (*factorize_listed)(const EliminationList& list, double* a, double* inverse);
  void (*solve_listed)(const EliminationList& list, const double* a, const double* inverse, double* w);
};

// Those that this processor can run, best first.
std::span<const FrontKernels* const> available_front_kernels();
// By name; empty: the best.
const FrontKernels& front_kernels(std::string_view name);

}  // namespace dalembert
