#include "dalembert/linear/linear_solver.hpp"

#include <stdexcept>

#include "complete_pivoting_lu.hpp"
#include "dense_lu.hpp"
#include "occupied_lu.hpp"

namespace dalembert {

bool is_dense(LinearSolverType type) {
  return type == LinearSolverType::EXUdense || type == LinearSolverType::EigenDense;
}

std::unique_ptr<LinearSolver> make_linear_solver(const Pattern& pattern, LinearSolverType type,
                                                 const LinearSolverOptions& options) {
  switch (type) {
    case LinearSolverType::EXUdense:
    case LinearSolverType::EigenDense:
      if (options.ignore_singular) return std::make_unique<CompletePivotingLu>(pattern.size(), options);
      return std::make_unique<DenseLu>(pattern.size(), options);
    case LinearSolverType::EigenSparse:
    case LinearSolverType::EigenSparseSymmetric: return std::make_unique<OccupiedLu>(pattern, options);
    default: break;
  }
  throw std::invalid_argument(
      "simulationSettings.linearSolverType: received LinearSolverType._None; expected EXUdense, EigenDense, "
      "EigenSparse "
      "or EigenSparseSymmetric");
}

}  // namespace dalembert
