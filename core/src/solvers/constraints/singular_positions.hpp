// Mechanisms that pass singular positions, from which several motions are possible, such as that of a flat four-bar.
#pragma once

#include <string>
#include <vector>

#include "control/solver_part.hpp"

namespace dalembert {

class SingularPositions : public SolverPart {
 public:
  explicit SingularPositions(Solver& solver) : SolverPart(solver) {}

  void begin();                             // a solution
  void compare_with(const State& state);    // sets the reference for is_near
  void resume(StepCount last_step, int passing_steps);
  StepCount last_step() const { return last_step_; }  // in a singular position
  int passing_steps() const { return passing_steps_; }

  // Whether constraints are nearly redundant in this step, in contrast to the start.
  bool is_near();
  bool has_weak_constraints();
  // Whether a step is accepted although its estimated error, in units of the tolerances, is above them.
  bool passes(double error);
  // Whether too many successive steps were in a singular position. Writes the diagnosis.
  bool stays();
  // Whether a failed step near a singular position is repeated with a slightly different size. Limited to a few times.
  bool steps_aside();
  void report();
  // Changes the diagnosis of a failed solution if its reason is a singular position, and lists the items.
  void name_in_diagnosis();
  void warn_of_undecided_start();  // once
  // The state moved by this part of the size of the model, and projected onto the constraints if possible.
  State moved_along_velocities(const State& at, double part);

 private:
  double growth_of_multipliers(const State& state);
  std::vector<std::string> items();
  std::vector<std::string> advice() const;
  void count_step();  // prints a message as well
  void warn_of_rest();

  State compared_with_;      // reference state, until usual_growth_ is computed
  double usual_growth_ = 0;
  StepCount last_step_ = -2, aside_step_ = -2;
  int passing_steps_ = 0, times_aside_ = 0;
  bool warned_of_rest_ = false, warned_of_undecided_start_ = false;
};

}  // namespace dalembert
