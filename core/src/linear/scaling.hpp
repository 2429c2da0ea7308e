// Factors of the rows and columns of a matrix that make its entries comparable, so that pivots can be compared.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "dalembert/system/pattern.hpp"

namespace dalembert {

// Powers of two: they change no digit of a result.
struct Scaling {
  std::vector<char> multiplier;  // unknowns without diagonal entry
  double row_factor = 1, column_factor = 1;  // scales of their rows and columns

  double row(int i) const { return multiplier[static_cast<std::size_t>(i)] ? row_factor : 1; }
  double column(int j) const { return multiplier[static_cast<std::size_t>(j)] ? column_factor : 1; }
};

// One factor for all unknowns without a diagonal entry (multipliers), which scales constraint gradients to the size
// of the diagonal: their ratio is a power of the step size. Individual factors would become extreme for directions
// without inertia, such as the lengths of Euler parameters.
Scaling balance(const Pattern& pattern, std::span<const double> values);

}  // namespace dalembert
