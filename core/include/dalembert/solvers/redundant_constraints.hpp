// Constraint equations that follow from others, such as those of the second hinge of a door.
//
// In the system matrix [[A, G^T], [G, 0]], -eps D takes the place of the zeros; residuals stay exact, so that Newton's method
// arrives at the solution of the constraints as they are. With S = G A^-1 G^T, the operator P = eps (S + eps D)^-1 D leaves
// multipliers from which no force comes as they are, and takes a factor of about eps from all others: it finds the combinations of
// equations that vanish, and takes off multipliers what makes them larger than need be.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "dalembert/linear/linear_solver.hpp"
#include "dalembert/solvers/left_out_equations.hpp"
#include "dalembert/simulation_settings.hpp"
#include "dalembert/system/system.hpp"

namespace dalembert {

class RedundantConstraints {
 public:
  // For counting: combinations of equations of which less than this is left vanish.
  static constexpr double counting_eps = 1e-12;

  struct Item {
    int object;
    std::string item;  // "object 3 'joint' (JointRevoluteZ)"
    int first, rows;   // equations, also those that are off
    int equations;     // that act
    int removable;     // so many of them follow from what all other items state
  };

  // ---- what constraints are like -------------------------------------------------------------------------------------
  // Whether none can be redundant, since each equation in turn has a coordinate that no other acts on. Reads entries of constraints
  // only.
  static bool evidently_none(const System& system, const Pattern& pattern, std::span<const double> values);
  // How many more equations there are than coordinates that they act on: so many must be.
  static int equations_beyond_coordinates(const System& system, const Pattern& pattern, std::span<const double> values);
  // Finds D for a matrix: one number for all forces of a mechanism, and the same by the square of a length for all moments. Rows of constraints of
  // velocities are multiplied by `rate_factor` in the matrix. False: no equation could be redundant.
  bool measure(System& system, const Pattern& pattern, std::span<const double> values, double moment_length, double rate_factor);
  // By how much multipliers outgrow what they state, for a mixture of all; inverse to the weakest of the constraints. One solution.
  double growth(LinearSolver& factors);
  // Whether some may be redundant, as far as the factors of the matrix tell, after `allow_for`.
  bool suspected(LinearSolver& factors);
  // Finds the combinations that vanish; factorizes the matrix with this eps, by a solver with `options_to_find`. To count, each equation has a weight
  // of its own, which leaves most of what is weak above round-off. Those that are known from a state
  // close by are only looked at again. False: the matrix is singular for other reasons as well.
  LinearSolverOptions options_to_find(LinearSolverOptions options) const;
  bool find(const Pattern& pattern, std::span<const double> values, double eps, LinearSolver& factors);
  // How far others are from vanishing, where combinations have been taken over. False: the matrix is singular for other reasons as well.
  bool find_rest(const Pattern& pattern, std::span<const double> values, LinearSolver& factors);
  // The same without factors, by entries alone. False: they do not tell.
  bool find_locally(const Pattern& pattern, std::span<const double> values);
  // The same where it is evident, in a fraction of the time, after `find_locally`: factors with `options` and this eps, which solutions can go
  // on with. False: it is not.
  bool find_at_once(const Pattern& pattern, std::span<const double> values, double eps, LinearSolver& factors);
  // Whether what is known is what vanishes of the regularized matrix as well, evidently; its factors are at hand.
  bool confirm(const Pattern& pattern, std::span<const double> values, LinearSolver& factors);
  // The same by the entries of the matrix alone, without eps and without factors. False: it is not, or entries do not tell.
  bool confirm_locally(const Pattern& pattern, std::span<const double> values);
  // After `measure`: combinations that have been found for the same equations around another matrix. False: other equations have been measured.
  bool take_over(const RedundantConstraints& found);
  // After `measure`: the same for taking off idle parts alone, for which no combinations are needed.
  bool serve_as(const RedundantConstraints& found);
  // Found by entries beside the state as well: it is not that of a singular position.
  bool lasts() const { return lasts_; }
  void found_beside() { lasts_ = true; }
  bool is_local() const { return local_; }  // entries of the matrix alone have told
  int count() const { return count_; }
  double weakest() const { return weakest_; }  // the smallest eigenvalue of D^-1 S that is not zero
  // Whether combinations that vanish could be told from others, in spite of round-off.
  bool certain() const { return certain_; }
  std::vector<Item> items(const System& system) const;
  // As many equations as follow from others, such that the rest is independent; of each part of the system with some.
  std::vector<DependentEquations> dependent() const;
  int most_of_a_part() const;
  // Equations whose multipliers are not unique.
  std::vector<int> equations() const;
  // What no motion closes of these gaps.
  std::vector<double> misfit(std::span<const double> gaps) const;
  // By ODE2 coordinate: which mechanism it belongs to, and its size; -1: to none.
  std::span<const int> mechanisms() const { return mechanism_of_coordinate_; }
  std::span<const double> lengths() const { return lengths_; }
  // The largest of gaps, in units of their equations.
  double largest(std::span<const double> gaps) const;
  // Of positions, also of equations that none follows from.
  double largest_of_all(std::span<const double> gaps) const;
  // What no motion closes of gaps, by factors of the regularized matrix.
  std::vector<double> left_open(LinearSolver& factors, std::span<const double> gaps);
  // The largest of positions, where solutions may count rates; and of what no motion closes of them.
  double largest_apart(std::span<const double> gaps) const;
  double largest_left_open(LinearSolver& factors, std::span<const double> gaps);

  // Between combinations that vanish and others: joints that are apart by gaps leave some of what vanishes where they fit.
  void allow_for(std::span<const double> gaps);
  double counting() const { return counting_; }
  bool allows_for_gaps() const { return counting_ > counting_eps; }

  // By how much each item would be apart if all others were fulfilled, of those that could be: lines for a diagnosis.
  std::vector<std::string> contradictions(std::span<const double> misfit, const System& system) const;

  // ---- solutions in spite of them ------------------------------------------------------------------------------------
  // A contradiction that is not worth a word, and what gaps are round-off below, in units of the equations.
  static constexpr double silent_misfit = 1e-11, round_off_of_gaps = 1e-12;
  static constexpr double passing_eps = 1e-11;  // in positions that are singular for a moment
  static constexpr double regular_eps = 1e-9;   // of redundancy that lasts, unless something speaks against it
  static constexpr double largest_eps = 1e-7;
  // For combinations that have been found, and a misfit of that size; `of_rates`: of constraints of velocities, which drift.
  double eps_for(double misfit, bool of_rates) const;
  // The same after a look at the gaps: where they contradict each other, `find` is to find combinations of which less than an eps is left as well.
  double eps_for_gaps(std::span<const double> gaps, bool of_rates, const std::function<void(double)>& find);
  // Whether these gaps did not contradict each other.
  bool consistent() const { return consistent_; }
  bool in_use() const { return eps_ > 0; }
  double eps() const { return eps_; }
  void use(double eps) {  // zero: not any more
    eps_ = eps;
    entries_.clear();
    harmless_.clear();
  }
  LinearSolverOptions options(LinearSolverOptions options) const;
  void regularize(const Pattern& pattern, std::span<double> values, double rate_factor);
  void pattern_revised() { slots_.clear(); }
  // From multipliers, with factors of the regularized matrix: the part from which no force comes.
  void take_off_idle_part(LinearSolver& factors, std::span<double> multipliers);
  // From a solution for all unknowns: the same, and what this part has moved, as equations that no longer vanish exactly let it do.
  void take_off_idle_solution(LinearSolver& factors, std::span<double> unknowns);
  static constexpr int many_times = 8;
  // The same as long as that is worth it; what idle parts would have closed is taken from `kept`. How often that was.
  int take_off_idle_solution(LinearSolver& factors, std::span<double> unknowns, std::span<double> kept, int most_times = many_times);
  // Whether these multipliers leave more than a share of one in the gap of any equation.
  bool leaves_open(std::span<const double> multipliers, double share) const;
  // The gap that an equation is left with by its multiplier.
  double left_open(int equation, double multiplier) const {
    return eps_ * row_factor(equation) * weight_[static_cast<std::size_t>(equation)] * multiplier;
  }
  // What counts as one in the gap of an equation: the size of its mechanism, or a radian; where rates count, within a step.
  double unit(int equation) const { return row_factor(equation) * unit_[static_cast<std::size_t>(equation)]; }
  std::span<const int> rows() const { return rows_; }
  const std::vector<double>& weights() const { return weight_; }
  void count_rates(double rate_factor) { rate_factor_ = rate_factor; }
  const std::vector<double>& units() const { return unit_; }

 private:
  static constexpr std::size_t few_rows = 40;  // not worth to be taken apart

  double row_factor(int equation) const { return of_rate_[static_cast<std::size_t>(equation)] ? rate_factor_ : 1; }
  // What takes the place of a zero.
  double entry_of(int equation) const { return -eps_ * row_factor(equation) * weight_[static_cast<std::size_t>(equation)]; }
  std::vector<int> unknowns() const;  // multipliers of rows_
  double largest_weighed(std::span<const double> multipliers) const;  // forces and moments in one unit
  std::vector<double> without_eps(std::span<const double> values) const;
  // P with another eps and D, for all equations with a weight.
  void apply(LinearSolver& factors, double eps, std::span<const double> weights, std::span<double> multipliers);
  // Of equations and of coordinates: those that act on a body in common belong to one mechanism. How many there are.
  int find_mechanisms(const Pattern& pattern, std::span<const double> values, std::span<const int> bodies);
  void find_weights(const std::vector<double>& ratios, const std::vector<CoordinateUnit>& units, double moment_length);
  void scale_weights(double factor);
  void find_scales(const Pattern& pattern, std::span<const double> values, std::span<const CoordinateUnit> units);
  std::span<const int> slots(const Pattern& pattern);
  class Search;
  // Combinations that vanish, of equations that may follow from each other.
  class Part {
   public:
    explicit Part(std::vector<int> places, int node = -1) : rows(std::move(places)), hangs_on(node) {}
    std::vector<int> rows;  // places in rows_
    int hangs_on;           // of loops, see ConstraintBlock
    int count = 0;
    void take(std::span<const double> found);
    void rescale(std::span<const int> equations, std::span<const double> from, std::span<const double> to);  // into another metric
    // One after the other, orthonormal in sqrt(D) lambda.
    std::span<const double> combinations() const;
    std::span<const double> combination(int k) const { return combinations().subspan(rows.size() * static_cast<std::size_t>(k), rows.size()); }
    bool has(std::size_t i) const;  // whether this row has a share in any
    // As many equations as combinations, that tell these apart; found when they are asked for first.
    std::span<const int> leading() const;
    void lead_as(const Part& other) { leading_ = other.leading_; }  // with the same combinations

   private:
    mutable std::vector<double> combinations_;  // in the metric that they were asked for in last
    mutable std::vector<double> factors_;       // of rows, from that metric to the one of now; none: it is the same
    mutable std::vector<int> leading_;
  };
  std::vector<Part> all_in_one() const;
  // `is_local`: with the combinations of each, which are all that there are.
  std::vector<Part> apart(bool by_loops, const Pattern& pattern, std::span<const double> values, bool& is_local) const;
  // The combinations of each are all that there are. False: entries do not tell.
  bool take_local_combinations(std::vector<Part>& parts, const Pattern& pattern, std::span<const double> values) const;
  void count_parts();
  bool take_if_as_many(std::vector<Part> parts);
  static bool as_many(const std::vector<Part>& some, const std::vector<Part>& others);
  template <class F>
  void each_owner(F&& f, const System& system) const;

  int first_ae_ = 0;
  std::vector<int> nodes_;           // of ODE2 coordinates
  double length_ = 1;                // the size of the model
  std::vector<double> lengths_;      // of each mechanism; 0: it is in one point
  std::vector<int> mechanism_, mechanism_of_coordinate_;  // of each equation
  std::vector<double> weight_;       // D, by equation; zero: it is never redundant
  std::vector<double> own_weight_;   // the same as if there were no other equation
  std::vector<double> unit_;
  std::vector<CoordinateUnit> units_;
  std::vector<double> arms_;         // of moments, by mechanism
  std::vector<double> scales_;       // by coordinate: what equations state of these is of one size, in units of length or none
  // Whether an equation constrains velocities, has a multiplier, and acts on anything.
  std::vector<char> of_rate_, multiplier_, acting_;
  std::vector<int> rows_;            // equations with a weight
  double rate_factor_ = 1, eps_ = 0, weakest_ = 0;
  double weight_scale_ = 1;          // D in units of what the matrix alone would make of it
  double weakest_by_masses_ = 0;     // where combinations have been found around these, and not around the matrix; 0: they have not
  int count_ = 0;
  bool consistent_ = true, certain_ = true, lasts_ = false;
  std::vector<Part> parts_;
  double counting_ = counting_eps;
  bool local_ = false;              // combinations of parts are those of their entries
  std::vector<double> x_, idle_;
  std::vector<int> slots_;  // of the diagonal, by rows_
  std::vector<double> entries_;  // that take the place of zeros there
  mutable std::vector<double> harmless_;  // multipliers that leave one in the gap, by rows_
};

// Whether solvers go on in spite of them.
bool treats_redundancy(const Sizes& sizes, const RedundantConstraintsSettings& settings, bool ignores_singular);
// Of the constraints as they are in a state, as far as gaps hide none; with an eps, of those of which less is left.
RedundantConstraints redundant_constraints(System& system, const State& state, Conditions conditions, double moment_length, double eps = 0);
// By equation, around the masses: D, zero where an equation is never redundant, and what counts as one in its gap.
struct ConstraintMetric {
  std::vector<double> weights, units;
};
double smallest_unit(const System& system);  // none is smaller
ConstraintMetric constraint_metric(System& system, const State& state, Conditions conditions);
// See RedundantConstraints::growth; masses, stiffness and step sizes have no part in it.
double growth_of_multipliers(System& system, const State& state, Conditions conditions);

}  // namespace dalembert
