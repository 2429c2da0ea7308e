// Eigenvalues of a system matrix close to zero, by subspace iteration with its factors.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>
#include <vector>

namespace dalembert {

inline double dot(std::span<const double> x, std::span<const double> y) {
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += x[i] * y[i];
  return sum;
}

// Pairs of J x = mu B x, where B selects the ODE2 part: eigenvectors fulfil the constraints, and real eigenvalues have
// the sign of the stiffness on the null space of the constraints. K. J. Bathe, Finite Element Procedures, 2nd ed.,
// 2014, section 11.6.
class NearestModes {
 public:
  struct Mode {
    double eigenvalue;
    std::vector<double> vector;  // ODE2 coordinates, with norm 1
  };
  using Solve = std::function<void(std::span<double>)>;  // solves with the factors of J, in place

  // Starts from the modes found before, if there are any.
  void find(const Solve& solve, std::size_t ode2, std::size_t total);
  // Modes by increasing magnitude, without complex ones.
  const std::vector<Mode>& modes() const { return modes_; }
  // Returns the mode with the largest correlation with x, or null.
  template <class Modes>
  static auto most_like(Modes& modes, std::span<const double> x) -> decltype(modes.data()) {
    const auto likeness = [&](const Mode& mode) { return std::abs(dot(mode.vector, x)); };
    const auto best = std::ranges::max_element(modes, {}, likeness);
    return best == modes.end() ? nullptr : &*best;
  }

 private:
  std::vector<std::vector<double>> basis_;
  std::vector<Mode> modes_;
};

}  // namespace dalembert
