// Accelerations from forces: the mass matrix in independent blocks, and items that need no matrix. There is no matrix
// if all masses are diagonal, as of mass points and of many bodies.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "dalembert/linear/linear_solver.hpp"
#include "dalembert/math/disjoint_sets.hpp"
#include "dalembert/system/large_vectors.hpp"

namespace dalembert {

class MassOperator {
 public:
  // Resets the operator; `type` selects dense or sparse factors of large blocks.
  void prepare(System& system, LinearSolverType type, const LinearSolverOptions& options);
  // Computes and factorizes the mass matrix of this state. Returns success or the coordinate without a pivot, as does
  // `solve`.
  int update(System& system, const State& state);
  // Replaces forces by accelerations.
  int solve(System& system, const State& state, std::span<double> x) {
    if (without_matrix_ > 0) {
      if (const int loose = system.solve_masses(state, x); loose >= 0) return loose;
    }
    if (blocks_.empty()) {
      each_number(system, x.size(),
                  [numbers = x.data(), factors = inverse_.data()](std::size_t i) { numbers[i] *= factors[i]; });
    } else {
      solve_blocks(x);
    }
    return LinearSolver::success;
  }

  // Returns the inverse masses if all coordinates are independent, otherwise null.
  const double* factors() const { return without_matrix_ == 0 && blocks_.empty() ? inverse_.data() : nullptr; }

 private:
  struct Entry {
    int row, column;
    std::size_t slot;
  };
  struct Block {
    std::vector<int> coordinates;
    std::vector<std::size_t> from, to;  // slots in the system's values, and in the values of the block
    std::unique_ptr<Pattern> pattern;
    std::unique_ptr<LinearSolver> solver;
    std::vector<double> values, x;
  };
  void prepare_matrix(System& system);
  int invert(int coordinate, double mass);
  template <class F>
  void each_coupling(F&& f) const;
  bool join_blocks();
  void build_blocks();
  void solve_blocks(std::span<double> x);

  const Pattern* pattern_ = nullptr;  // null: masses have been diagonal so far
  LinearSolverType type_ = LinearSolverType::EXUdense;
  LinearSolverOptions options_;
  int size_ = 0, without_matrix_ = 0;  // numbers of coordinates
  std::vector<double> values_, inverse_;   // inverse_: for independent coordinates, otherwise 0
  std::vector<std::size_t> diagonal_;
  DisjointSets coupled_;                   // coordinates
  std::vector<char> alone_;
  std::vector<Block> blocks_;
};

}  // namespace dalembert
