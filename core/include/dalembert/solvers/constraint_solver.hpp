// The regularization of constraints that may be redundant: which equations get which eps in the equations of
// `ProximalEquations`.
//
// If joints have gaps of relative size g, a redundant constraint becomes a weak one with the strength g^2. The mechanism
// has to move as if this constraint did not exist, which needs a larger eps (`choose`).
#pragma once

#include <span>
#include <string>
#include <vector>

#include "dalembert/linear/linear_solver.hpp"
#include "dalembert/simulation_settings.hpp"
#include "dalembert/solvers/constraint_rank.hpp"
#include "dalembert/solvers/proximal_equations.hpp"
#include "dalembert/system/system.hpp"

namespace dalembert {

class ConstraintSolver {
 public:
  // Kind of matrix: time steps, accelerations at a state, or static equilibria. Static iterates violate constraints more.
  enum class Matrix { motion, accelerations, statics };
  // Misfits below this size, relative to the mechanism, are not reported.
  static constexpr double silent_misfit = 1e-10;

  // Computes the metric at a state. The solver becomes active if constraints are redundant, or nearly redundant. It does
  // not change the numbers of regular models. `treats` = false disables it.
  void prepare(System& system, const State& state, const Conditions& conditions,
               const RedundantConstraintsSettings& settings, bool treats, Matrix kind);
  // Takes over the metric and the rank of another solver at the same state, for another kind of matrix.
  void prepare(const ConstraintSolver& known, Matrix kind) {
    *this = known;
    kind_ = kind;
    slots_.clear();
  }
  void forget() { *this = ConstraintSolver(); }
  bool is_prepared() const { return prepared_; }
  bool active() const { return active_; }
  // Activates the solver after a singular matrix or a failure of Newton's method, because a loop of joints may be in a
  // singular position. Returns false if the model has no loops, or if the solver is active already.
  bool activate();
  void deactivate() { active_ = false; }
  const ConstraintRank& rank() const { return rank_; }  // at the state of `prepare`
  // Whether as many constraints are redundant at a state near that of `prepare`, so that this one is not singular.
  bool rank_holds_nearby() const { return rank_holds_nearby_; }
  bool compare_rank(System& system, const State& near, const Conditions& conditions,
                    const RedundantConstraintsSettings& settings);

  // ---- gaps -------------------------------------------------------------------------------------------------------
  // Largest position gap, relative to the size of the mechanism or in radians.
  double largest(std::span<const double> gaps) const;
  // The same including equations that are never redundant, such as unit lengths of Euler parameters.
  double largest_of_all(std::span<const double> gaps) const;
  double unit(int equation) const { return units_[static_cast<std::size_t>(equation)]; }
  std::span<const double> units() const { return units_; }
  // Registers the gap at the start of a step. The largest one determines eps of all later steps.
  void remember(double gap) { largest_gap_ = std::max(largest_gap_, gap); }
  double largest_gap() const { return largest_gap_; }
  // Selects eps for an iterate with this gap.
  void choose(double gap, bool of_rates = false);
  // Static solutions whose joints fit at the start leave dependent equations free instead of using eps for all equations. The
  // dependent equations hold again at the equilibrium. If they do not, all equations get eps from then on.
  bool frees_dependent() const { return frees_; }
  void hold_dependent() { frees_ = false; }
  // False: misfits have to be subtracted.
  bool joints_fit() const { return fit_; }

  // ---- matrices and solutions -------------------------------------------------------------------------------------
  // Options of the linear solver for the regularized matrix.
  LinearSolverOptions options(LinearSolverOptions options) const;
  // Writes -eps D to zeros on the diagonal. Rows of velocity constraints (all rows if `all_rates`) are multiplied by
  // `rate` in the matrix. `scale` is the size of A^-1 relative to the inverse masses.
  void regularize(const Pattern& pattern, std::span<double> values, double scale, double rate, bool all_rates);
  void pattern_revised() { slots_.clear(); }
  // The part of constraint violations that no motion can close, by equation. `factors` are those of the regularized matrix.
  std::vector<double> misfit(LinearSolver& factors, std::span<const double> gaps) {
    return equations_.misfit(factors, gaps);
  }
  // Solves for all unknowns with exact constraints. Multipliers are not unique.
  void solve(LinearSolver& factors, std::span<double> x) { equations_.solve(factors, x, fit_); }
  // Replaces multipliers by those with minimum norm in the metric that exert the same forces.
  void make_smallest(LinearSolver& factors, std::span<double> multipliers) {
    equations_.make_smallest(factors, multipliers);
  }

  double eps() const { return eps_; }
  // Whether eps had to be so large, because of gaps, that reactions of the weakest constraints have errors above 1 %.
  bool hides_constraints() const { return hides_constraints_; }
  std::span<const int> rows() const { return equations_.rows(); }

 private:
  bool prepared_ = false, active_ = false, fit_ = true, frees_ = false, rank_holds_nearby_ = false;
  Matrix kind_ = Matrix::motion;
  double eps_ = 0, regular_eps_ = 0, largest_gap_ = 0;
  bool hides_constraints_ = false;
  int first_ae_ = 0;
  ProximalEquations equations_;
  ConstraintRank rank_;
  std::vector<double> units_;  // units of gaps, by equation
  std::vector<char> of_velocities_;  // velocity constraints, by equation
  std::vector<int> slots_;  // slots of the diagonal entries, by rows()
};

// Size of A^-1 relative to the inverse masses: the median of M_jj / |A_jj|.
double scale_of_masses(std::span<const double> masses, const Pattern& pattern, std::span<const double> matrix,
                       int ode2);

}  // namespace dalembert
