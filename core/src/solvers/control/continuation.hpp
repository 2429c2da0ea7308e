// Restart files: a solution that goes on from one is identical to an uninterrupted one.
#pragma once

#include <memory>
#include <vector>

#include "control/solver_part.hpp"
#include "dalembert/output/restart_file.hpp"

namespace dalembert {

class Continuation : public SolverPart {
 public:
  explicit Continuation(Solver& solver) : SolverPart(solver) {}

  void read();  // the file, if there is one to go on from
  bool exists() const { return data_ != nullptr; }
  const std::vector<double>& file_lengths() const { return data_->files; }
  void begin(double time) { last_written_ = time; }
  void take();    // copies the data into the current state; output files are open
  void resume();  // the loop over steps
  // Data of the solver in addition to the state.
  const std::vector<double>& values() const { return data_->algorithmic_accelerations; }
  double number_of_solver(std::size_t i) const;

  void write();  // if it is due

 private:
  void take_counts(std::span<const double> run);
  RestartData data();

  std::unique_ptr<RestartData> data_;  // null without a restart
  double last_written_ = 0;
};

}  // namespace dalembert
