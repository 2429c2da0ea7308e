// A term whose equations keep vectors of coordinates at length one, as Euler parameters.
#pragma once

#include <vector>

namespace dalembert {

struct UnitVector {
  int first, size;  // range of consecutive ODE2 coordinates
};

struct UnitVectors {
  virtual ~UnitVectors() = default;
  virtual void list(std::vector<UnitVector>& vectors) const = 0;
};

}  // namespace dalembert
