// Why a solution fails, or is doubtful: diagnoses, and warnings that name items.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "control/solver_part.hpp"

namespace dalembert {

// Shortens a long list; the last line is the number of omitted lines.
void shorten(std::vector<std::string>& lines);
// Returns a shortened list with one indented line per entry.
std::string indented(std::vector<std::string> lines);

class Diagnostics : public SolverPart {
 public:
  explicit Diagnostics(Solver& solver) : SolverPart(solver) {}

  void begin();  // a solution
  void check_constraints();  // warns of initial values that violate constraints, or refuses them
  bool starts_finite();
  // Lists the gaps of the initial values that cause errors of the first steps.
  void look_for_gaps_at_start();
  const std::string& closing_at_start() const { return closing_at_start_; }

  // ---- failures ----------------------------------------------------------------------------------------------------
  Diagnosis& diagnose(FailureReason reason);
  // Lists the equations with the largest residuals.
  void diagnose(FailureReason reason, std::span<const double> residual);
  // Lists unconstrained motions and linearly dependent equations.
  void diagnose_singular_matrix(const Pattern& pattern, std::span<const double> values);
  void diagnose_open_gaps();  // gaps that projections could not close
  void diagnose_contradiction(std::span<const double> misfit);
  // Lists numbers that are not finite, with their items, in the current state or otherwise in `residual`.
  void diagnose_not_finite(std::span<const double> residual = {});
  void time_is_over();
  // Adds the largest of the numbers, with the items of their rows; the list stays short and begins with the largest.
  void add_largest(std::vector<NamedValue>& list, std::span<const double> numbers, const char* vector,
                   int first_row) const;
  void advise_on_weak_constraints();

  // ---- warnings ----------------------------------------------------------------------------------------------------
  void warn_of_contradiction(std::span<const double> misfit);  // once
  const std::string& contradiction_text() const { return contradiction_text_; }  // of this warning
  // Whether joints with this misfit were consistent at the start of the solution.
  bool has_left_constraints(std::span<const double> misfit);
  void warn_of_free_motion(std::span<const int> rows);
  void warn_of_instability(int directions, std::span<const int> rows);
  void warn_of_velocities(std::span<const int> rows, double largest_force);  // for static solutions

 private:
  bool have_fitted(const State& at, std::span<const double> misfit);
  std::vector<NamedValue> not_finite(const State& state) const;
  std::vector<std::string> sources_of_not_finite();
  std::string describe_data(int index) const;

  std::string contradiction_text_, closing_at_start_;
};

}  // namespace dalembert
