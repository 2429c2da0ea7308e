// The step-size controller: the only code that assigns the size of a step. Solvers, events and error estimates reject steps or propose sizes.
#pragma once

#include <array>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "dalembert/solvers/data.hpp"

namespace dalembert {

// Factors of the settings, read once per solution.
struct StepFactors {
  double decrease = 0.5, increase = 2;  // after a failed step; after `recovery_steps` easy steps
  double largest_increase = 2;  // for error control
  int recovery_steps = 10, recovery_iterations = 10;  // a step is easy if it takes at most this number of iterations
};

// Tolerances of estimated errors, and the share of the step size that the estimate allows.
struct ErrorTolerances {
  double absolute = 0, relative = 0, safety = 1;

  double of(double value) const { return absolute + relative * std::abs(value); }
};

class StepController {
 public:
  static constexpr double aside = 0.7;  // relative size of a step that is repeated close to a singular configuration
  static constexpr std::size_t restart_size = 6;

  explicit StepController(SolverIterationData& it) : it_(it) {}

  // ---- a solution -------------------------------------------------------------------------------------------------------
  void start(const StepFactors& factors);
  void resume(double size, std::span<const double> numbers);  // after start(): continues from a restart file
  std::array<double, restart_size> restart_numbers() const;
  // Lets steps end at these increasing times, of which the last one is the end of the solution. Steps that are rejected,
  // or end at events, are shorter. Estimated errors have no effect.
  void prescribe_ends(std::vector<double> times) { ends_ = std::move(times); }
  bool ends_are_prescribed() const { return !ends_.empty(); }
  // Time at the end of the step. The last step is shortened to the end of the solution.
  double end_of_step();

  // ---- repeated steps, not below the smallest size
  // -------------------------------------------------------------------
  bool at_minimum() const { return !(it_.currentStepSize > it_.minStepSize); }
  // Rejects a step of size `failed`: it is repeated with the recommended size, or `factor` times its own size.
  void reject() { reject(it_.currentStepSize, factors_.decrease); }
  void reject(double failed, double factor);
  double decrease() const { return factors_.decrease; }
  // Rejects and counts a step with a large error: the next attempt has the same size, `factor` times the size, or the
  // size of the error estimate.
  void repeat_by_error();
  void shrink_by_error(double factor);
  void reject_by_error(double wanted);
  bool take_rejection_by_error() { return std::exchange(rejected_by_error_, false); }

  // ---- steps that end at an event or a singular point, with exactly this size
  // ---------------------------------------------
  void use(double size) { it_.currentStepSize = size; }

  // ---- the next step ----------------------------------------------------------------------------------------------------
  // `wanted` is the ratio of step sizes by the error estimate.
  void accept(double wanted);
  void propose(double size);  // bounded by the smallest size and the largest increase
  void recover();  // increases the size by a fixed factor, up to the maximum
  bool is_recovered();  // after a step: whether the size may increase
  void count_rejection() { since_rejection_ = 0; }
  void count_accepted(double size);  // by error control
  // Returns the number of successive steps with an error above the tolerances.
  int above_tolerance() const { return above_tolerance_; }
  void within_tolerance() { above_tolerance_ = 0; }
  bool hold_above_tolerance();  // returns false if there are too many

 private:
  SolverIterationData& it_;
  StepFactors factors_;
  // Steps of equal size are counted, not summed, so that times do not drift.
  struct EqualSteps {
    double start = 0, size = 0, time = 0;  // time: end of the last one
    StepCount before = 0;
  };
  EqualSteps equal_;
  double prescribed_end();
  std::vector<double> ends_;
  StepCount prescribed_step_ = -1;  // index of the step whose size has been set
  StepCount since_rejection_ = 0;
  int above_tolerance_ = 0;
  bool rejected_by_error_ = false;
};

}  // namespace dalembert
