// Factors of the rows and columns of a matrix that make its entries comparable, so that pivots can be compared.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "dalembert/system/pattern.hpp"

namespace dalembert {

// Powers of two: they change no digit of a result.
struct Scaling {
  std::vector<char> multiplier;               // which unknowns have no diagonal entry
  double row_factor = 1, column_factor = 1;   // of their rows and columns

  double row(int i) const { return multiplier[static_cast<std::size_t>(i)] ? row_factor : 1; }
  double column(int j) const { return multiplier[static_cast<std::size_t>(j)] ? column_factor : 1; }
};

// One factor for all unknowns without a diagonal entry (multipliers), which makes the gradients of constraints in general as
// large as the diagonal: their ratio is a power of the step size. Factors of their own for each unknown would follow
// directions without inertia, as the lengths of Euler parameters, to useless extremes.
Scaling balance(const Pattern& pattern, std::span<const double> values);

}  // namespace dalembert
