// Base class of all solvers: the loop over steps, step sizes, discontinuous iterations, output and messages.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <exception>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "dalembert/linear/linear_solver.hpp"
#include "dalembert/output/sensor_recorder.hpp"
#include "dalembert/output/solution_file.hpp"
#include "dalembert/simulation_settings.hpp"
#include "dalembert/solvers/data.hpp"
#include "dalembert/solvers/error.hpp"
#include "dalembert/solvers/hooks.hpp"
#include "dalembert/solvers/locking_angles.hpp"
#include "dalembert/solvers/rebounds.hpp"
#include "dalembert/solvers/step_controller.hpp"
#include "dalembert/solvers/constraint_rank.hpp"
#include "dalembert/system/system.hpp"

namespace dalembert {

class ConstrainedMotion;
class ConstraintSolver;
class Continuation;
class Diagnostics;
class EventControl;
class Model;
class OutputWriter;
class SingularPositions;
class SolverPart;

// Data that a solver receives from its caller: user functions, sensors, text for file headers.
struct SolverEnvironment {
  SolverHooks hooks;
  std::vector<SensorChannel> sensors;
  SensorStorage* sensor_storage = nullptr;
  std::string build;  // version of program, Python and platform, for file headers
  const Model* model = nullptr;  // model of the system, to name items in a diagnosis
};
const SolverEnvironment& no_environment();

// Call `attach` before any function that needs a system. The steps of a solution are virtual functions, so that users can
// replace single ones.
class Solver {
 public:
  Solver();
  virtual ~Solver();
  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;

  // All arguments must exist until the next `attach`; the environment until `forget_environment`.
  void attach(System& system, const SimulationSettings& settings, const SolverEnvironment& environment);
  void forget_environment();

  // ---- a whole solution ------------------------------------------------------------------------------------------
  // Initializes, solves all steps, finalizes. Returns false on failure (see diagnosis()). Exceptions of hooks, items and files
  // pass through with the state of the last completed step.
  bool solve_system();
  bool initialize();
  bool solve_steps();
  void finalize();
  // Fills in accelerations and ODE1 rates at both ends of the step, for interpolation. The result says which of them are
  // derivatives of the motion.
  struct KnownDerivatives {
    bool accelerations, rates;
  };
  virtual KnownDerivatives complete_ends() { return {it.currentStepIndex > 1, it.currentStepIndex > 1}; }
  // Releases the memory of the last solution.
  virtual void free_memory() {}

  // Copies the settings that the steps use; called by attach.
  virtual void read_settings();

  // Lets the steps of the next solutions end at these times (StepController::prescribe_ends).
  void prescribe_ends_of_steps(std::vector<double> times);

  // ---- parts of initialize, in this order --------------------------------------------------------------------------
  virtual void pre_initialize() {}
  void initialize_output();
  bool check_system();
  virtual void initialize_data();
  virtual void initial_conditions();
  virtual void post_initialize() {}

  // ---- parts of a step ---------------------------------------------------------------------------------------------
  virtual void update_current_time();
  virtual void initialize_step();
  virtual bool discontinuous_iteration();
  virtual bool newton() = 0;
  virtual void finalize_newton() {}
  virtual double post_newton();
  virtual void finish_step(bool write);
  virtual bool reduce_step_size();
  virtual void increase_step_size();
  // Collects doubts about a finished solution.
  virtual void look_back();

  // ---- properties --------------------------------------------------------------------------------------------------
  virtual bool is_static() const { return false; }
  virtual std::string name() const = 0;
  virtual bool controls_step_size() const { return false; }
  virtual bool enforces_constraints() const { return true; }
  virtual double load_factor() const { return 1; }
  // Rank of the constraints; count() is the number of redundant equations.
  const ConstraintRank& constraint_rank() const { return rank_; }
  virtual const ConstraintSolver& constraint_solver() const = 0;
  double largest_misfit() const { return largest_misfit_; }  // relative to the size of the model
  double end_time() const;

  // ---- output ------------------------------------------------------------------------------------------------------
  bool verbose(int level) const { return output.verboseMode >= level || output.verboseModeFile >= level; }
  void say(int level, std::string_view text);
  void write_solution_header();
  void write_coordinates();

  // Text of the error; empty after success.
  std::string error_string() const;
  // Reasons not to trust a finished solution.
  const std::vector<std::string>& doubts() const { return doubts_; }
  const Diagnosis& diagnosis() const { return diagnosis_; }

  LinearSolverType linear_type() const { return linear_type_; }  // given by settings or by the size of the system
  const Sizes& sizes() const { return sizes_; }
  System& system() { return *system_; }
  const System& system() const { return *system_; }
  const SimulationSettings& settings() const { return *settings_; }

  SolverIterationData it;
  SolverConvergenceData conv;
  SolverOutputData output;
  SolverTimer timer;
  NewtonSettings newton_settings;       // settings of staticSolver or timeIntegration
  DiscontinuousSettings discontinuous;

 protected:
  State& current() { return system_->state(ConfigurationType::Current); }
  State& start_of_step() { return system_->state(ConfigurationType::StartOfStep); }
  const State& initial() { return system_->state(ConfigurationType::Initial); }
  const SolverHooks& hooks() const { return environment_->hooks; }
  bool dense() const { return is_dense(linear_type_); }
  LinearSolverOptions linear_options() const;  // given by settings
  void prepare(ConstrainedMotion& motion) const;
  double last_time() const;  // end of the solution; user functions may be undefined later
  // Restores the state of a discontinuous iteration, except data coordinates.
  virtual void reset_to_start_of_step();
  virtual void save_start_of_step();
  // Runs the searches of terms that are not items, such as contact detection.
  void search();
  virtual void pattern_revised() {}
  void save_all_but_motion();  // q, v and a are left to the caller
  // ---- restart -----------------------------------------------------------------------------------------------------
  bool continues() const;
  // Data in addition to the state, such as algorithmic accelerations.
  virtual std::span<const double> restart_values() const { return {}; }
  virtual std::vector<double> restart_numbers() const { return {}; }
  const std::vector<double>& continued_values() const;
  double continued_number(std::size_t i) const;
  // Whether steps enforce position constraints, not their derivatives.
  virtual bool keeps_positions() const { return false; }
  // A step that is larger than the last one by more than this ratio starts anew: velocities and accelerations of the short
  // step have too much round-off for it.
  static constexpr double largest_growth = 2;
  // Recomputes forces and accelerations after a jump of the state.
  virtual void renew_accelerations() {}
  // The solver's own factors of masses and constraints; null if it has none.
  virtual ConstrainedMotion* motion_under_constraints() { return nullptr; }
  // Called after actions and user functions that may have switched constraints on or off.
  virtual void examine_constraints_anew() {}
  // Called when a restart file is written: discards all data that are not in it, because later results must not depend on them.
  virtual void forget();
  // Smaller differences of times are ignored.
  double same_time() const { return std::min(1e-10, 1e-3 * it.currentStepSize); }
  // Minimum-norm multipliers of the current state, if the solver continues with other ones. Null: those of the state have
  // minimum norm after this call.
  virtual const std::vector<double>* minimum_norm_multipliers() { return nullptr; }
  void keep_minimum_norm_multipliers();  // writes them to the state
  // True if multipliers are read only while a `ReportedMultipliers` object exists, so that they may be computed late.
  bool multipliers_may_wait() const { return multipliers_may_wait_; }
  // The current state has minimum-norm multipliers during the lifetime of this object.
  class ReportedMultipliers {
   public:
    explicit ReportedMultipliers(Solver& solver);
    ~ReportedMultipliers();
    ReportedMultipliers(const ReportedMultipliers&) = delete;
    ReportedMultipliers& operator=(const ReportedMultipliers&) = delete;

   private:
    Solver& solver_;
    const std::vector<double>* reported_;
    std::vector<double> own_;
  };
  // Whether a user function replaces a part of the step.
  virtual bool has_replaced_parts() const { return false; }
  void warn(std::string_view text);
  // Number in the format of the console.
  std::string number(double value) const;
  // Whether the step that has been solved is the last one.
  bool ends_here() const { return path_ends_ ? *path_ends_ : it.currentTime >= it.endTime - 1e-6 * it.lastStepSize; }
  // Whether each step is written, also if its time is below that of the last row, as on a path with limit points.
  virtual bool writes_each_step() const { return false; }
  virtual void advise_on_growth();  // adds advice to the diagnosis
  // Adds the user's system Jacobian, with these weights of derivatives by q, v and ODE1 coordinates.
  void add_user_jacobian(const Pattern& pattern, std::span<double> values, const std::array<double, 3>& weights);
  // Whether a step of minimum size is accepted although its error is above the tolerances. Warns; diagnoses too many of them.
  bool hold_at_minimum();
  virtual void diagnose_error_control();
  double largest_misfit_ = 0;
  void find_rank() { find_rank(current()); }
  void find_rank(const State& at);
  void take_rank(ConstraintRank rank);
  // Called if constraints are redundant at the start only because it is a singular position.
  virtual void solve_as_regular() {}
  ConstraintRank rank_;
  bool rank_known_ = false, announced_rank_ = false;
  // Asks the hooks whether to stop; called where a few milliseconds may have passed.
  void poll_interrupt();

  const bool* path_ends_ = nullptr;  // set by arc-length continuation: whether the path has ended
  Sizes sizes_;
  Conditions conditions_;
  Diagnosis diagnosis_;
  std::vector<std::string> doubts_;
  bool stop_ = false;
  double initial_residual_ = 0;
  ErrorTolerances tolerances_;  // for automatic step sizes
  StepFactors factors_;  // for the step controller
  int loads_jacobian_ = 0;  // timeIntegration.computeLoadsJacobian
  StepController steps_{it};
  std::unique_ptr<OutputWriter> writer_;
  std::unique_ptr<Continuation> continuation_;
  std::unique_ptr<EventControl> events_;
  std::unique_ptr<Diagnostics> diagnostics_;
  std::unique_ptr<SingularPositions> singular_;

 private:
  friend class Lockstep;
  friend class SolverPart;
  friend class SingularPositions;
  friend class EventControl;
  friend class Continuation;
  friend class Diagnostics;
  friend class OutputWriter;
  void choose_linear_solver();
  LockingAngles angles_;
  Rebounds rebounds_;
  bool watches_rebounds_ = false;
  // ---- the parts of solve_steps ------------------------------------------------------------------------------------
  void start_steps();
  bool next_step();
  void take_step();
  bool try_step();
  void begin_step();
  void begin_discontinuous_iteration();
  void accept_newton();  // continues a discontinuous iteration after convergence
  void step_failed();
  void step_succeeded();
  void end_steps();
  // Functions that few steps need.
  void warn_of_step_sizes();
  void announce_step();
  void announce_discontinuous_iteration();
  void announce_increase();
  void call_pre_step();
  void look_for_switched_joints();
  void joints_are_examined();
  void poll();
  void show(bool record_image);
  bool time_to_look();
  bool steps_end_silently() const;
  bool asks_for_multipliers_in_steps() const;
  void return_to_start_of_step();
  void wait_for_real_time();
  void summarize();
  void leave();  // closes files and ends threads
  void abandon();  // the same while an exception ends the simulation
  std::string position_text() const;

  LinearSolverType linear_type_ = LinearSolverType::EXUdense;
  System* system_ = nullptr;
  const SimulationSettings* settings_ = nullptr;
  const SolverEnvironment* environment_ = &no_environment();
  // The clock is read every (look_mask_ + 1)-th step, that is every few milliseconds.
  std::uint32_t steps_taken_ = 0, look_mask_ = 0;
  double last_look_ = 0;
  bool end_reached_ = false;
  std::uint64_t renewed_constraints_ = 0;  // revision of the last check of constraints
  std::vector<char> equations_off_;  // inactive equations; empty if unknown
  bool warned_minimum_ = false;
  bool step_completed_ = false;  // the state is the end of an accepted step
  bool silent_ = false;  // no output at the ends of steps
  bool multipliers_may_wait_ = false, start_has_minimum_norm_ = false;
};

}  // namespace dalembert
