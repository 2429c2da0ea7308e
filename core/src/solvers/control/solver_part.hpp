// Base class of the parts of a solver. Each part has one task and its own data: output, events, restart, singular positions,
// diagnosis. A part refers to the states, settings, counters and flags of its solver, by the same names.
#pragma once

#include <string>
#include <string_view>

#include "dalembert/solvers/solver.hpp"

namespace dalembert {

class SolverPart {
 public:
  SolverPart(const SolverPart&) = delete;
  SolverPart& operator=(const SolverPart&) = delete;

 protected:
  explicit SolverPart(Solver& solver)
      : solver_(solver),
        it(solver.it),
        conv(solver.conv),
        output(solver.output),
        timer(solver.timer),
        steps_(solver.steps_),
        sizes_(solver.sizes_),
        conditions_(solver.conditions_),
        diagnosis_(solver.diagnosis_),
        stop_(solver.stop_) {}
  ~SolverPart() = default;

  System& system() { return solver_.system(); }
  const System& system() const { return std::as_const(solver_).system(); }
  const SimulationSettings& settings() const { return solver_.settings(); }
  const SolverHooks& hooks() const { return solver_.hooks(); }
  const Model* model() const { return solver_.environment_->model; }
  State& current() { return solver_.current(); }
  State& start_of_step() { return solver_.start_of_step(); }
  const State& initial() { return solver_.initial(); }
  const ConstraintSolver& constraint_solver() const { return solver_.constraint_solver(); }
  std::string name() const { return solver_.name(); }
  bool is_static() const { return solver_.is_static(); }
  double same_time() const { return solver_.same_time(); }
  bool verbose(int level) const { return solver_.verbose(level); }
  void say(int level, std::string_view text) { solver_.say(level, text); }
  void warn(std::string_view text) { solver_.warn(text); }
  std::string number(double value) const { return solver_.number(value); }

  Solver& solver_;
  SolverIterationData& it;
  SolverConvergenceData& conv;
  SolverOutputData& output;
  SolverTimer& timer;
  StepController& steps_;
  const Sizes& sizes_;
  const Conditions& conditions_;
  Diagnosis& diagnosis_;
  bool& stop_;  // the solution ends after this step
};

}  // namespace dalembert
