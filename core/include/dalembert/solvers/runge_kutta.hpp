// Coefficients of explicit Runge-Kutta methods.
#pragma once

#include <span>
#include <vector>

#include "dalembert/enums.hpp"

namespace dalembert {

struct RungeKuttaMethod {
  static constexpr std::size_t max_stages = 12;
  int stages = 0;
  int order = 0;                // the higher order of an embedded pair
  std::vector<double> a;        // row by row, stages x stages
  std::vector<double> b, c;
  std::vector<double> b_error;  // weights of the second approximation; empty: no error control
  std::vector<double> b_third;  // weights of a third one, of lower order; may be empty

  bool controls_step_size() const { return !b_error.empty(); }
  double coefficient(int i, int j) const { return a[static_cast<std::size_t>(i * stages + j)]; }
};

// Returns an empty method (no stages) if the type is not an explicit Runge-Kutta method.
RungeKuttaMethod runge_kutta_method(DynamicSolverType type);

}  // namespace dalembert
