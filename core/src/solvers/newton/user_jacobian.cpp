// Contribution of the user's system Jacobian function to the system matrix.
#include "dalembert/model/errors.hpp"
#include "dalembert/solvers/solver.hpp"

namespace dalembert {

namespace {

// Refuses entries that the system matrix has no place for.
void check_entry(const Pattern& pattern, const MatrixEntry& entry) {
  const bool inside =
      entry.row >= 0 && entry.column >= 0 && entry.row < pattern.size() && entry.column < pattern.size();
  if (inside && pattern.contains(entry.row, entry.column)) return;
  const std::string place = "SystemJacobianUserFunction: received an entry in row " + std::to_string(entry.row) +
                            ", column " + std::to_string(entry.column) + "; expected ";
  if (!inside) throw ModelError(ErrorKind::index, place + "indices below " + std::to_string(pattern.size()));
  throw ModelError(ErrorKind::value,
                   place + "coordinates that items of the model couple. Use linearSolverType=EigenDense.");
}

}  // namespace

void Solver::add_user_jacobian(const Pattern& pattern, std::span<double> values, const std::array<double, 3>& weights) {
  if (!hooks().system_jacobian) return;
  const TimedPart time(timer, timer.python);
  for (const MatrixEntry& entry : hooks().system_jacobian(it.currentTime, weights[0], weights[1], weights[2])) {
    check_entry(pattern, entry);
    values[static_cast<std::size_t>(pattern.slot(entry.row, entry.column))] += entry.value;
  }
}

}  // namespace dalembert
