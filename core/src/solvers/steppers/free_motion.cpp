// Zero-energy modes of a static equilibrium: states along them are in equilibrium as well, so that the computed one is
// arbitrary.
#include <algorithm>
#include <cmath>
#include <limits>

#include "dalembert/linear/inertia.hpp"
#include "dalembert/solvers/numerical_tangent.hpp"
#include "dalembert/solvers/static.hpp"
#include "constraints/dependent_equations.hpp"
#include "steppers/nearest_modes.hpp"
#include "diagnosis/diagnostics.hpp"

namespace dalembert {

namespace {

// Round-off relative to the terms that cancel in the stiffness of a mode.
constexpr double rounding_errors = 100 * std::numeric_limits<double>::epsilon();
// Larger bound for errors of a mode that was computed with factors of an earlier iteration.
constexpr double suspicious = 1e4 * rounding_errors;
constexpr double much_softer = 0.3;
constexpr int sweeps = 3;
constexpr std::size_t always_counted = 1000;  // number of unknowns up to which negative eigenvalues are always counted
constexpr double negligible_share = 1e-4;  // of a coordinate in a mode

struct Stiffness {
  double sum = 0, terms = 0;  // x_i K_ij x_j and its magnitude
};
Stiffness stiffness_along(std::span<const double> x, const Pattern& pattern, std::span<const double> matrix) {
  Stiffness s;
  for_each_entry(pattern, [&](int row, int column, std::size_t slot) {
    if (std::max(row, column) >= static_cast<int>(x.size())) return;
    const double term = x[static_cast<std::size_t>(row)] * matrix[slot] * x[static_cast<std::size_t>(column)];
    s.sum += term;
    s.terms += std::abs(term);
  });
  return s;
}

// Computes the direction with the lowest stiffness by inverse iteration.
std::vector<double> softest_direction(std::size_t ode2, std::size_t total, const NearestModes::Solve& solve) {
  std::vector<double> x(ode2);
  // Components in all directions.
  for (std::size_t i = 0; i < ode2; ++i) x[i] = std::sin(1.0 + 2.7 * static_cast<double>(i));
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    x.resize(total, 0.0);
    solve(x);
    x.resize(ode2);
    const double size = std::sqrt(dot(x, x));
    for (double& number : x) number /= size;
  }
  return x;
}

// Inactive equations have positive diagonal entries.
int active_equations(const Sizes& sizes, const Pattern& pattern, std::span<const double> matrix) {
  int count = sizes.ae;
  for_each_entry(pattern, [&](int row, int column, std::size_t slot) {
    count -= row == column && row >= sizes.first_ae() && matrix[slot] > 0;
  });
  return count;
}

}  // namespace

void StaticSolver::look_back() {
  look_for_motion();
  if (sizes_.ode2 > 0 && it.newtonJacobiCount > 0) {
    const std::vector<double> last = jacobian_;  // users may request this matrix
    // Each active equation adds a negative eigenvalue. Small systems are always counted. Large systems are examined only if the softest direction
    // is unstable; this check needs no factorization.
    const auto may_be_unstable = [this] {
      const auto ode2 = static_cast<std::size_t>(sizes_.ode2), total = static_cast<std::size_t>(sizes_.total());
      if (total <= always_counted)
        return !linear_ ||
               negative_eigenvalues(*linear_, pattern(), jacobian_) != active_equations(sizes_, pattern(), jacobian_);
      return factorized_ &&
             stiffness_along(softest_direction(ode2, total, [this](std::span<double> x) { linear_->solve(x); }),
                             pattern(), jacobian_)
                     .sum < 0;
    };
    if (const std::vector<int> rows = free_coordinates(last); !rows.empty()) diagnostics_->warn_of_free_motion(rows);
    // Arc-length continuation passes unstable equilibria, and lists where they begin.
    else if (!path_ && may_be_unstable())
      look_for_instability();
    jacobian_ = last;
  }
  NewtonSolver::look_back();
}

// Used if the matrix has no factors.
std::vector<int> StaticSolver::free_of_resistance() const {
  std::vector<int> rows = free_unknowns(pattern(), jacobian_);
  std::erase_if(rows, [this](int row) { return row >= sizes_.first_ae(); });
  return rows;
}

// The last factors belong to an earlier iteration, without loads; moments there may cancel at the end.
std::vector<int> StaticSolver::free_coordinates(std::span<const double> last) {
  const auto ode2 = static_cast<std::size_t>(sizes_.ode2), total = static_cast<std::size_t>(sizes_.total());
  const auto solve = [this](std::span<double> x) { linear_->solve(x); };
  const auto factorize_now = [this] {
    const bool regular = factorize();
    conv.linearSolverFailed = false;  // the state itself is a solution
    return regular;
  };
  compute_jacobian(1);
  const bool unknown = !factorized_;
  if (unknown && !factorize_now()) return free_of_resistance();
  const std::vector<double> softest = softest_direction(ode2, total, solve);
  const double before = stiffness_along(softest, pattern(), last).sum;
  const Stiffness now = stiffness_along(softest, pattern(), jacobian_);
  std::vector<int> rows;
  if (std::abs(now.sum) > std::max(suspicious * now.terms, much_softer * std::abs(before))) return rows;
  if (!unknown && !factorize_now()) return free_of_resistance();
  NearestModes nearest;
  nearest.find(solve, ode2, total);
  std::vector<double> shares(ode2);
  for (const NearestModes::Mode& mode : nearest.modes()) {
    if (std::abs(mode.eigenvalue) > rounding_errors * stiffness_along(mode.vector, pattern(), jacobian_).terms)
      continue;
    for (std::size_t i = 0; i < ode2; ++i) shares[i] = std::max(shares[i], std::abs(mode.vector[i]));
  }
  for (std::size_t i = 0; i < ode2; ++i)
    if (shares[i] > negligible_share) rows.push_back(static_cast<int>(i));
  return rows;
}

}  // namespace dalembert
