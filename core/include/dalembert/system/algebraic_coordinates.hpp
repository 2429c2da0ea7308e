// A term whose algebraic variables are not all Lagrange multipliers, as the position in a sliding joint.
#pragma once

#include <span>

namespace dalembert {

struct AlgebraicCoordinates {
  virtual ~AlgebraicCoordinates() = default;
  // Sets 1 at those variables of the term that are no multipliers; `signs` counts all algebraic variables of the system.
  virtual void mark(std::span<double> signs) const = 0;
};

}  // namespace dalembert
