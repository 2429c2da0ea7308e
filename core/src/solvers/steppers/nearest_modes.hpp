// Eigenvalues of a system matrix next to zero, by subspace iteration with its factors.
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

// Pairs of J x = mu B x, where B takes the ODE2 part: eigenvectors fulfil the constraints, and the signs of real eigenvalues are those
// of the stiffness that is left. K. J. Bathe, Finite Element Procedures, 2nd ed., 2014, section 11.6.
class NearestModes {
 public:
  struct Mode {
    double eigenvalue;
    std::vector<double> vector;  // of ODE2 coordinates, with norm 1
  };
  using Solve = std::function<void(std::span<double>)>;  // with the factors of J, in place

  // Starts from what has been found before, if anything.
  void find(const Solve& solve, std::size_t ode2, std::size_t total);
  // Sorted by magnitude; complex ones are left out.
  const std::vector<Mode>& modes() const { return modes_; }
  // That with the direction most like x; null if there is none.
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
