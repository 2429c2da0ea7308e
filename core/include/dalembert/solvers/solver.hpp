// What all solvers share: the loop over steps with its step sizes, discontinuous iterations, output and messages.
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
#include "dalembert/solvers/step_controller.hpp"
#include "dalembert/solvers/constraint_rank.hpp"
#include "dalembert/system/system.hpp"

namespace dalembert {

struct EventLook;
class EventWatch;
struct WatchedValue;
class ConstrainedMotion;
class ConstraintSolver;
class Model;
class StepInterpolation;
struct RestartData;

// What surrounds a system while it is solved.
struct SolverEnvironment {
  SolverHooks hooks;
  std::vector<SensorChannel> sensors;
  SensorStorage* sensor_storage = nullptr;
  std::string build;  // version of program, Python and platform, for file headers
  const Model* model = nullptr;  // that the system was assembled from, to name items in a diagnosis
};
const SolverEnvironment& no_environment();

// Every public function that works on a system needs `attach` before. The steps of a solution are virtual functions, so
// that a user may replace single ones.
class Solver {
 public:
  Solver();
  virtual ~Solver();
  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;

  // All three must live until the next attach, or the environment until it is to be forgotten.
  void attach(System& system, const SimulationSettings& settings, const SolverEnvironment& environment);
  void forget_environment();

  // ---- a whole solution ------------------------------------------------------------------------------------------
  // Initialize, solve all steps, finalize. False: failed, see diagnosis(). Exceptions of hooks, items and files pass through,
  // with the state of the last completed step.
  bool solve_system();
  bool initialize();
  bool solve_steps();
  void finalize();
  // Takes what is known of accelerations and rates at the start of the step into its state; whether they, and those at the end, are those
  // of the motion.
  struct KnownDerivatives {
    bool accelerations, rates;
  };
  virtual KnownDerivatives complete_ends() { return {it.currentStepIndex > 1, it.currentStepIndex > 1}; }
  // What was needed for the last solution alone; `initialize` makes it anew.
  virtual void free_memory() {}

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
  // After a solution that has finished: what speaks against it.
  virtual void look_back();

  // ---- what it is --------------------------------------------------------------------------------------------------
  virtual bool is_static() const { return false; }
  virtual std::string name() const = 0;
  virtual bool controls_step_size() const { return false; }
  virtual bool enforces_constraints() const { return true; }
  virtual double load_factor() const { return 1; }
  // What has been found of constraints that follow from others; count() is zero if there are none.
  const ConstraintRank& constraint_rank() const { return rank_; }
  virtual const ConstraintSolver& constraint_solver() const = 0;
  double largest_misfit() const { return largest_misfit_; }  // that they have left open, relative to the size of the model
  double end_time() const;

  // ---- output ------------------------------------------------------------------------------------------------------
  bool verbose(int level) const { return output.verboseMode >= level || output.verboseModeFile >= level; }
  void say(int level, std::string_view text);
  void write_solution_header();
  void write_coordinates();
  void write_sensors();
  void write_restart();

  // Empty after success.
  std::string error_string() const;
  // Why a solution that has finished is not to be trusted.
  const std::vector<std::string>& doubts() const { return doubts_; }
  const Diagnosis& diagnosis() const { return diagnosis_; }

  LinearSolverType linear_type() const { return linear_type_; }  // of the settings, or chosen by the size of the system
  const Sizes& sizes() const { return sizes_; }
  System& system() { return *system_; }
  const System& system() const { return *system_; }
  const SimulationSettings& settings() const { return *settings_; }

  SolverIterationData it;
  SolverConvergenceData conv;
  SolverOutputData output;
  SolverTimer timer;
  NewtonSettings newton_settings;       // of staticSolver or timeIntegration, whichever this solver has
  DiscontinuousSettings discontinuous;

 protected:
  State& current() { return system_->state(ConfigurationType::Current); }
  State& start_of_step() { return system_->state(ConfigurationType::StartOfStep); }
  const State& initial() { return system_->state(ConfigurationType::Initial); }
  const SolverHooks& hooks() const { return environment_->hooks; }
  bool dense() const { return is_dense(linear_type_); }
  LinearSolverOptions linear_options() const;  // of the settings
  void prepare(ConstrainedMotion& motion) const;
  double last_time() const;  // of the solution, after which user functions may not be defined
  // Sets back what a discontinuous iteration has moved: everything except data.
  virtual void reset_to_start_of_step();
  virtual void save_start_of_step();
  // Terms that are no items look for what acts in the current state.
  void search();
  virtual void pattern_revised() {}
  void save_all_but_motion();  // q, v and a are left to the caller
  // ---- going on from a restart file --------------------------------------------------------------------------------
  bool continues() const { return continuation_ != nullptr; }
  // What it needs besides the state: algorithmic accelerations, and some numbers more.
  virtual std::span<const double> restart_values() const { return {}; }
  virtual std::vector<double> restart_numbers() const { return {}; }
  const std::vector<double>& continued_values() const;
  double continued_number(std::size_t i) const;
  // ---- control of the step size: singular positions (singular_positions.cpp) ----------------------------------------
  // Whether the constraints of this step nearly depend on each other, as they did not at the start.
  bool near_singular_position();
  double growth_of_multipliers(const State& state);
  bool has_weak_constraints();  // as beside a singular position
  void compare_constraints_with(const State& state);  // from now on
  // Whether a step is kept although its error, in units of the tolerances, has been estimated to be above them.
  bool passes_singular_position(double error);
  void warn_of_rest();
  void passing_singular_position();  // counts and tells it
  // Whether so many steps have passed it that none will be the last; with the diagnosis.
  bool stays_in_singular_position();
  void diagnose_singular_position();
  // Of a solution that has failed where constraints nearly depend on each other that do not elsewhere: this is the reason, with the items.
  void name_singular_position();
  State moved_along_velocities(const State& at, double part);
  std::vector<std::string> items_in_singular_position();
  std::vector<std::string> advice_on_singular_position() const;
  // Whether constraints of positions are equations of each step, not of their derivatives.
  virtual bool keeps_positions() const { return false; }
  // Whether a step that is lost beside such a position is to be tried with another size that is not much smaller: a few times.
  bool steps_aside();
  StepCount singular_position_step_ = -2;  // the last one that passed it
  // Of a step beside the one before, for which implicit methods correct what that has left in accelerations and velocities, with its round-off.
  static constexpr double largest_growth = 2;
  // The state has jumped: forces and accelerations have to be found anew.
  virtual void renew_accelerations() {}
  // Around the masses, where the solver keeps it anyway; null: it does not.
  virtual ConstrainedMotion* motion_under_constraints() { return nullptr; }
  // After actions and functions of the user that may have switched constraints on or off.
  virtual void examine_constraints_anew() {}
  // After a restart file has been written: nothing that follows may depend on what is not in it.
  virtual void forget();
  // Times that are closer to each other are the same.
  double same_time() const { return std::min(1e-10, 1e-3 * it.currentStepSize); }
  // Where the solver goes on with multipliers that are not the smallest ones: those of the current state that everybody else is told. Null: the state
  // has them, now at the latest.
  virtual const std::vector<double>* told_multipliers() { return nullptr; }
  void keep_told_multipliers();  // in the state
  // Whether multipliers matter only while somebody is `Told`.
  bool multipliers_may_wait() const { return multipliers_may_wait_; }
  // While others look at the current state.
  class Told {
   public:
    explicit Told(Solver& solver);
    ~Told();
    Told(const Told&) = delete;
    Told& operator=(const Told&) = delete;

   private:
    Solver& solver_;
    const std::vector<double>* told_;
    std::vector<double> own_;
  };
  // Whether the user has replaced a part of a step, which may change what the solver does.
  virtual bool has_replaced_parts() const { return false; }
  virtual StepFactors step_factors() const;
  void warn(std::string_view text);
  std::string describe_switch(const Switch& at) const;
  // As the console shows it.
  std::string number(double value) const;
  // ---- diagnosis: what is known at this point ----------------------------------------------------------------------
  Diagnosis& diagnose(FailureReason reason);
  // With what can move freely, and equations that depend on each other.
  void diagnose_singular_matrix(const Pattern& pattern, std::span<const double> values);
  void diagnose_open_gaps();  // that no motion onto the constraints has closed
  // Of redundant constraints, by what no motion closes of their gaps.
  bool has_left_constraints(std::span<const double> misfit);
  bool have_fitted(const State& at, std::span<const double> misfit);  // beside this misfit
  void diagnose_contradiction(std::span<const double> misfit);
  void warn_of_contradiction(std::span<const double> misfit);  // once
  void warn_of_undecided_start();  // once
  void warn_of_free_motion(std::span<const int> rows);
  void warn_of_instability(int directions, std::span<const int> rows);
  void warn_of_velocities(std::span<const int> rows, double largest_force);  // in statics
  // With the equations that have the largest residuals.
  void diagnose(FailureReason reason, std::span<const double> residual);
  // Names what is not finite in the current state or, if there is nothing, in `residual`, with the items that it comes from.
  void diagnose_not_finite(std::span<const double> residual = {});
  // Adds the largest of the numbers, with the items of their rows; the list stays short and begins with the largest.
  void add_largest(std::vector<NamedValue>& list, std::span<const double> numbers, const char* vector, int first_row) const;
  // Whether the step that has been solved is the last one.
  bool ends_here() const { return path_ends_ ? *path_ends_ : it.currentTime >= it.endTime - 1e-6 * it.lastStepSize; }
  // Times that may fall leave no other choice.
  virtual bool writes_each_step() const { return false; }
  virtual void advise_on_growth();  // adds what to do about it
  // Adds what the user's system Jacobian function gives, for derivatives by q, v and ODE1 coordinates with these weights.
  void add_user_jacobian(const Pattern& pattern, std::span<double> values, const std::array<double, 3>& weights);
  // Whether a step is kept although its error is above the tolerances; with a warning, and a diagnosis where there are too many.
  bool hold_at_minimum();
  virtual void diagnose_error_control();
  std::string told_contradiction_;  // of redundant constraints, as it has been told
  bool warned_of_undecided_start_ = false, warned_of_actions_ = false, warned_of_rest_ = false;
  double largest_misfit_ = 0;
  void find_rank() { find_rank(current()); }
  // Called if constraints depend on each other only in the singular position of the start.
  virtual void solve_as_regular() {}
  void find_rank(const State& at);
  ConstraintRank rank_;
  bool rank_known_ = false, announced_rank_ = false;
  // Asks the hooks whether to stop; called where a few milliseconds may have passed.
  void poll_interrupt();

  const bool* path_ends_ = nullptr;  // of a path that does not end at a time
  Sizes sizes_;
  Conditions conditions_;
  Diagnosis diagnosis_;
  std::vector<std::string> doubts_;
  bool stop_ = false;
  double initial_residual_ = 0;
  StepController steps_{it};

 private:
  friend class Lockstep;
  void choose_linear_solver();
  void check_constraints();  // warns of initial values that do not fulfil them, or refuses these
  std::string constraints_that_close_at_start();
  // ---- going on from a restart file (continuation.cpp) -------------------------------------------------------------
  void read_continuation();
  void take_continuation();
  void continue_steps();
  RestartData restart_data();
  void take_counts(std::span<const double> run);
  // ---- output at requested times -----------------------------------------------------------------------------------
  void write_requested();
  void write_solution_row();
  void record_sensors(double time);
  double requested(double time, double period) const;
  template <class Write>
  void write_between(double period, Write&& write);
  // ---- events (events.cpp) -----------------------------------------------------------------------------------------
  void begin_to_watch_events();
  void warn_of_missing_switches(bool located);
  void settle_switches();
  void switch_over();
  const std::vector<WatchedValue>& event_values() { return event_values(switches_); }
  const std::vector<WatchedValue>& event_values(std::vector<Switch>& of_items);
  bool locates_switches() const { return iterates_without_ != System::Updates::all; }
  bool let_user_act(int event, int direction);
  std::vector<double> gaps_and_rates();
  void end_velocities_against_constraints(bool keeps_positions);
  void warn_of_actions_against_constraints(int singular_row);
  void diagnose_chatter(int event);
  std::string describe_event(int event) const;
  double look_into_step(double& before);
  bool solve_again(double step_size);
  bool end_with_event();
  bool event_reached() const;
  void act_on_events();
  void end_as_scheduled();  // a step that would go further
  void act_as_scheduled();
  bool step_was_cut() const;  // and left nothing that the next one, of the usual size, could begin with
  void advise_on_weak_constraints();
  // ---- angles that lock (locking_angles.cpp) -----------------------------------------------------------------------
  void find_angles();
  void watch_angles();
  void doubt_angles();
  void doubt_equilibrium_of_angles();
  void advise_on_angles();
  // Three, one after the other: of a node, or turns of a tree in the place of a ball joint.
  struct Angles {
    int node;           // -1: of a tree
    std::size_t first;  // coordinate
  };
  std::string text_of(const Angles& angles, double second_angle) const;
  std::vector<Angles> angles_;
  struct Lock {
    std::size_t first;  // coordinate
    StepCount steps;    // that were too large; the first of them, and the second angle there
    double time, second_angle;
  };
  std::vector<Lock> locks_;
  // ---- contacts that add energy (rebounds.cpp) ---------------------------------------------------------------------
  void watch_rebounds();
  void doubt_rebounds();
  struct Rebound {
    StepCount closed_at = -1, steps = 0;  // steps: in contact, at the largest growth
    double approach = 0;                  // velocity before the step that has closed it
    double growth = 0, largest = 0;       // logarithm of velocities after over before, since these were smallest
    double time = 0;
    Switch what{""};
  };
  std::vector<Rebound> rebounds_;  // by switch of items
  bool watches_rebounds_ = false;
  // ---- the parts of solve_steps ------------------------------------------------------------------------------------
  void start_steps();
  bool next_step();
  void take_step();
  bool try_step();
  void begin_step();
  void begin_discontinuous_iteration();
  void accept_newton();  // it has converged: what follows in a discontinuous iteration
  void step_failed();
  void step_succeeded();
  void end_steps();
  // Out of the way of steps that need none of them.
  void warn_of_step_sizes();
  void announce_step();
  void announce_discontinuous_iteration();
  void announce_increase();
  bool starts_finite();
  void time_is_over();
  std::vector<NamedValue> not_finite(const State& state) const;
  std::vector<std::string> sources_of_not_finite();
  std::string describe_data(int index) const;
  void call_pre_step();
  void look_for_switched_joints();
  void joints_are_examined();
  void poll();
  void show(bool record_image);
  bool time_to_look();
  bool steps_end_silently() const;
  bool asks_for_multipliers_in_steps() const;
  void return_to_start_of_step();
  void write_end_of_step();
  void print_progress(bool to_console, bool to_file);
  void wait_for_real_time();
  void summarize();
  void warn_of_files_written_twice();
  template <class File>
  void close(File& file);
  void announce_end();
  void close_files();
  void announce_solution();
  void leave();
  void abandon();
  std::string unwritten_text() const;
  std::string position_text() const;
  RunDescription run_description() const;

  LinearSolverType linear_type_ = LinearSolverType::EXUdense;
  System* system_ = nullptr;
  const SimulationSettings* settings_ = nullptr;
  const SolverEnvironment* environment_ = &no_environment();
  SolutionFile solution_file_;
  SensorRecorder sensors_;
  OutputFile information_file_;
  std::unique_ptr<RestartData> continuation_;  // null: from the initial values
  std::unique_ptr<StepInterpolation> between_;
  std::unique_ptr<EventWatch> watch_;  // null: there are no events
  std::unique_ptr<EventLook> look_;    // with it
  std::vector<Switch> switches_;       // of items, of the last solution that they have been asked about
  System::Updates iterates_without_ = System::Updates::all;  // items whose switches are events
  std::exception_ptr unwritten_;  // the first FileError of the run
  // The clock is read every (look_mask_ + 1)-th step only, as seldom as a few milliseconds allow.
  std::uint32_t steps_taken_ = 0, look_mask_ = 0;
  double last_look_ = 0;
  double last_restart_ = 0;
  StepCount aside_step_ = -2;
  State compared_with_;     // constraints as they usually are, until a number has been made of it
  double usual_growth_ = 0;
  int times_aside_ = 0, passing_steps_ = 0;  // the latter with few others in between
  bool end_reached_ = false;
  std::uint64_t renewed_constraints_ = 0;  // when they have been looked at last
  std::vector<char> equations_off_;        // empty: it is not known which
  bool warned_minimum_ = false;
  std::string closing_at_start_;  // why errors of the first steps are above the tolerances
  bool step_completed_ = false;  // the state is that of the end of a step, not one that is tried
  bool silent_ = false;  // while all steps are solved: nothing happens at their ends
  bool multipliers_may_wait_ = false, start_is_told_ = false;
};

}  // namespace dalembert
