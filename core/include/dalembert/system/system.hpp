// The assembled system: equations of all items, evaluated batch by batch. Solvers see only this.
//
//   ODE2   r = M(q) a + f(q, v, t) + G(q)^T lambda = 0     (applied forces enter f with a minus sign)
//   ODE1   r = f(y, t) - y_t = 0
//   AE     r = gap(q, t) = 0, or its rate
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "dalembert/enums.hpp"
#include "dalembert/math/large_memory.hpp"
#include "dalembert/system/evaluation.hpp"
#include "dalembert/system/node_frame.hpp"
#include "dalembert/system/pattern.hpp"
#include "dalembert/system/pull.hpp"
#include "dalembert/system/regions.hpp"
#include "dalembert/reflection/storage.hpp"
#include "dalembert/system/state.hpp"
#include "dalembert/system/switches.hpp"

namespace dalembert {

struct WeightedVector {
  double factor;
  const double* x;
};

class Model;
class Ports;
class SystemTerm;
class Workers;
struct SystemParts;  // batches and index tables; dalembert/system/parts.hpp

// Options of an evaluation besides the state: level of constraints and loads.
struct Conditions {
  double load_factor = 1;
  double step_size = 0;
  bool rate_level = false;
  bool inertia = true;
  bool loads = true;
  bool direct = false;  // explicit integration: no step is iterated, and nothing has to be held for that
  bool unseen = false;  // no user function can query the system during evaluations
  bool holds_contact = false;  // right-hand sides: contacts are those of the start of the step
  int load_dependencies = 0;  // tangent: dependence of loads on coordinates: 0 none, 1 positions, 2 velocities as well
  bool follows_residual =
      false;  // tangent: the last call was `residual`, of this state: forces on markers are in place
};

// The verdict of one discontinuous iteration.
struct Discontinuity {
  double error = 0;  // 0: nothing changed
  double recommended_step_size = -1;  // -1: no recommendation
};

enum class CoordinateUnit { unknown, radian, meter };  // the more is known, the greater

class System {
 public:
  System();
  ~System();
  System(const System&) = delete;
  System& operator=(const System&) = delete;

  // Build batches, index tables and all configurations from the model. Throws ModelError; the old system stays then.
  void assemble(const Model& model, const Division& division = {});
  bool assembled() const;
  // Take over changed parameters of items (of the same structure) from the model.
  void refresh(const Model& model);
  // The same from the next evaluation on, for functions that are called in the middle of one. The model has to live as long.
  void refresh_later(const Model& model) { late_ = &model; }
  // Objects with parameters that assembling finds, and their records with these.
  std::vector<std::pair<int, std::shared_ptr<const void>>> completed_records() const;
  // Take over added, deleted and changed sensors; false: other items have changed as well.
  bool renew_sensors(const Model& model);
  // Counts the assemblings: who keeps anything of a system has to look for it again when it has grown.
  std::uint64_t version() const { return version_; }

  // Sets the number of threads for evaluations until the next Assemble; small systems use fewer. Results are
  // bit-identical.
  void use_threads(int count);
  int threads() const;
  Workers* workers() const;  // null: one thread only

  const Sizes& sizes() const { return sizes_; }
  // Current, Initial, Reference (q and y only), StartOfStep, Visualization.
  State& state(ConfigurationType configuration) {
    if (configuration == ConfigurationType::Current) ++touches_;
    return state_of(states_, configuration);
  }
  const State& state(ConfigurationType configuration) const { return state_of(states_, configuration); }
  // Keeps the vectors of all states at their address, also after the next assembly, which makes new ones. The caller
  // may write to them.
  std::shared_ptr<const void> hold_states() const;

  // r has sizes().total() entries and is overwritten. Not const: markers and work space are kept.
  void residual(const State& state, const Conditions& conditions, std::span<double> r);
  // Values in pattern order, overwritten: the derivative of the residual along `weights`, columns [dq, dy, dlambda].
  void tangent(const State& state, const Conditions& conditions, const Weights& weights, const Pattern& pattern,
               std::span<double> values);
  // The pattern of the tangent, made on first use after Assemble.
  const Pattern& pattern(bool dense);
  // Called when a solver starts: makes another pattern if load dependencies were added after the last one was made.
  void complete_pattern();
  // Sparse pattern of the mass matrix, of the size of the system; excludes items that compute accelerations without a
  // matrix.
  const Pattern& mass_pattern();
  std::span<const int> coordinates_without_matrix();  // ascending
  // Converts forces to accelerations at these coordinates. Returns a coordinate without mass, or -1.
  int solve_masses(const State& state, std::span<double> x);
  // Only M(q), in the leading ode2 x ode2 block of `pattern`; everything else is zero.
  void mass_matrix(const State& state, const Pattern& pattern, std::span<double> values);
  // Adds the mass matrix to a diagonal if it is diagonal in this state; otherwise returns false, and the sum is
  // invalid.
  bool add_diagonal_masses(const State& state, std::span<double> diagonal);
  bool constant_mass_matrix() const;
  NodeFrame node_frame(int marker) const;
  bool calls_user_functions() const;  // user functions of objects and loads in evaluations
  std::uint64_t renewed_objects() const { return renewed_objects_; }  // increased if an object has new parameters
  std::uint64_t renewed_constraints();  // the same of those with algebraic equations
  // Generalised forces Q of M a = Q, without constraint forces; rhs has sizes().ode2 entries. Used by explicit
  // integrators.
  void forces(const State& state, const Conditions& conditions, std::span<double> rhs);
  // ODE1 right-hand side only; sizes().ode1 entries.
  void rates(const State& state, const Conditions& conditions, std::span<double> y_t);
  // Both at once; empty arrays are skipped.
  void right_hand_sides(const State& state, const Conditions& conditions, std::span<double> rhs, std::span<double> y_t);
  // Returns -Q without a copy, valid until the next evaluation.
  std::span<const double> negative_forces(const State& state, const Conditions& conditions);
  // Constraint equations only; sizes().ae entries.
  void gaps(const State& state, const Conditions& conditions, std::span<double> g);
  // Unit of each ODE2 coordinate: components of positions, other coordinates of such nodes, or unknown.
  std::vector<CoordinateUnit> coordinate_units() const;
  std::vector<int> nodes_of_coordinates() const;  // ODE2
  // The same number for those of all nodes that bodies connect, such as the elements of a beam.
  std::vector<int> bodies_of_coordinates() const;
  // The diagonal of the box around all markers, nodes and meshes in space, in m, as the last evaluation has left them; 1 if all is one point.
  double extent() const;
  // Extents of the parts that move with ODE2 coordinates of each group, by the group of each coordinate (-1: none); 0
  // if all points coincide.
  std::vector<double> extents(std::span<const int> groups, int count) const;

  // Coordinates that linear constraints simply keep at zero, for explicit integrators that eliminate them; empty optional: there
  // are other constraints.
  std::optional<std::vector<int>> fixed_coordinates() const;

  // Lie-group nodes: their coordinates are not additive. For those nodes q = q0 o exp(increment), composition on the
  // group; all other entries of q do not change.
  bool has_lie_nodes() const;
  void compose(std::span<const double> q0, std::span<const WeightedVector> increment, std::span<double> q) const;
  void compose(std::span<const double> q0, std::span<const double> increment, std::span<double> q) const;
  struct LieBlock {
    int rotation;  // first of the three rotation coordinates in the ODE2 vector
  };
  std::span<const LieBlock> lie_blocks() const;
  // Divides vectors of length one, such as Euler parameters, by their length, their accelerations too, and their rates by the given power of it.
  // The first power keeps the rate of the direction. The second power is for steps of the trapezoidal rule, which keep
  // |p|^2 + h^2 |p_t|^2 / 4: the angular velocity then stays right over many steps.
  void restore_unit_lengths(State& state, int power_of_rates) const;

  // One factor per algebraic variable: -1 for multipliers, whose sign is opposite in static solvers, 1 for algebraic
  // coordinates.
  std::span<const double> static_signs() const;
  // Equations that define algebraic coordinates do not constrain the motion.
  bool constrains_motion(int equation) const { return static_signs()[static_cast<std::size_t>(equation)] < 0; }

  // A contribution that is no item (system/system_term.hpp), to an assembled system; the next Assemble makes a system without it.
  void add(std::unique_ptr<SystemTerm> term);
  // Lets such terms update their contacts. Returns true if the sparse pattern has changed, and has to be analysed
  // again.
  bool search(const State& state, const Conditions& conditions);
  // The next search begins as that of a system that was assembled just now, and so does its pattern: a solution that goes on from
  // a file has the bytes of one that was not stopped.
  void forget_searches();
  bool searches() const { return searches_; }  // whether there are any
  int pattern_revisions() const { return pattern_revisions_; }
  // In the order in which the sources of the model make them.
  SystemTerm& term(int number);
  // Generalised forces of a single term, in the current state; sizes().ode2 entries.
  void forces_of_term(int number, std::span<double> forces);
  // Frames of markers in the current state, for queries of such terms: cached while the state cannot have changed.
  const Ports& current_ports();
  // Cached data for the ports is valid while this number does not change; 0: no caching.
  std::uint64_t number_of_current_ports() const;
  // The same in any configuration, as long as `look` runs.
  void with_ports(ConfigurationType configuration, const std::function<void(const Ports&)>& look);
  // History of such terms, which is no part of a state: a step begins, or begins again.
  void keep_history();
  void restore_history();
  // ... a solution begins; numbers for a restart file, and from there. False: they belong to another system.
  void begin_history();
  std::vector<double> history() const;
  bool take_history(std::span<const double> numbers);

  // Update data coordinates after a converged Newton loop (friction, contact, post-Newton user functions of items).
  // Items that switch may be left to `switch_over`.
  enum class Updates { all, without_switches };
  Discontinuity post_newton(State& state, const Conditions& conditions, Updates updates = Updates::all);
  bool has_discontinuities(const Conditions& conditions = {}) const;
  // Items with switches: functions of the state for switching, and data coordinates after a step.
  bool has_switches() const;
  void find_switches(const State& state, const Conditions& conditions, std::vector<Switch>& found);
  void switch_over(State& state, const Conditions& conditions);
  // Terms that are not items watch the switches that they find next.
  void forget_switches();

  // Items that act on a row of the system vector, for diagnoses: "object 3 'joint' (JointRevoluteZ), equation 2".
  std::string describe_row(int row) const;

  // The items with constraint equations, in the order of these.
  struct EquationOwner {
    bool of_node;  // otherwise of an object
    int number;
    int first, count;  // equations
  };
  std::vector<EquationOwner> equation_owners() const;
  std::string describe(const EquationOwner& owner) const;  // "object 3 'joint' (JointRevoluteZ)"
  // Stores the equations with non-unique multipliers for outputs of the objects; all other multipliers are unique.
  void reactions_are_known(std::span<const int> not_unique);
  void reactions_are_unknown();  // until a solver has looked

  // ---- results: written into `values`, whose memory is used again ----------------------------------------------
  using Values = std::vector<double>;
  void node_output(int node, OutputVariableType variable, ConfigurationType configuration, Values& values);
  void wrench_output(int object, OutputVariableType variable, ConfigurationType configuration, Values& values);
  void object_output(int object, OutputVariableType variable, ConfigurationType configuration, Values& values);
  void body_output(int object, OutputVariableType variable, std::array<double, 3> local,
                   ConfigurationType configuration, Values& values);
  void super_element_output(int object, OutputVariableType variable, int mesh_node, ConfigurationType configuration,
                            Values& values);
  // Output of a point of a link of a kinematic tree.
  void link_output(int object, OutputVariableType variable, int link, std::array<double, 3> local,
                   ConfigurationType configuration, Values& values);
  void marker_output(int marker, OutputVariableType variable, ConfigurationType configuration, Values& values);
  // Poses of all items of a kind for pictures: the rows of rotation and position (3 x 4) of each. NaN: an item has no
  // position, or no orientation. The memory belongs to the caller; data of solvers does not change.
  struct Poses {
    LargeVector<double> rows;
    Values totals;
  };
  void poses(ItemKind kind, ConfigurationType configuration, Poses& poses) const;
  // pose of one of them
  std::array<double, 12> pose(int object, ConfigurationType configuration, Values& totals) const;
  // An output variable of all mesh nodes of a super element, one after the other; returns how many nodes, 0: they do not have it.
  int mesh_outputs(int object, OutputVariableType variable, ConfigurationType configuration, Values& totals,
                   Values& values) const;
  void load_values(int load, double time, Values& values);
  void sensor_values(int sensor, ConfigurationType configuration, Values& values);
  // While one lives, outputs of several items share the frames of markers, until the state may have changed.
  void state_may_have_changed();
  class Recording {
   public:
    explicit Recording(System& system);
    ~Recording();
    Recording(const Recording&) = delete;
    Recording& operator=(const Recording&) = delete;

   private:
    System& system_;
  };

  // The point of an object that is nearest to `point`; refuses objects that have no position, no mass, or rest. `link`: of a
  // kinematic tree.
  Grip grip(int object, const Vec3<double>& point, int link, ConfigurationType configuration);
  Vec3<double> position_of(const Grip& grip, ConfigurationType configuration);
  // Acts from the next step until it is replaced; empty: no pull.
  void pull(const std::optional<Pull>& pull);
  bool is_pulled() const { return pulled_; }
  void renew_pull(const State& state, double step_size);  // forces of the step that begins at this state

  // The value of a load depends on these coordinates, besides those that it acts on.
  void add_load_dependencies(int load, std::span<const int> coordinates);
  std::span<const int> load_dependencies(int load) const;

  // ---- index tables: global coordinate numbers ------------------------------------------------------------------
  enum class Coordinates { ode2, ode1, ae, data };
  std::vector<int> object_ltg(int object, Coordinates kind) const;
  std::vector<int> node_ltg(int node, Coordinates kind) const;
  int node_index(int node, Coordinates kind) const;  // -1: the node has no coordinates of that kind

  int evaluations() const { return evaluations_; }

 private:
  friend class TracedEquations;

  // An assembly gives the same parts as the last one: nothing but their states may have changed. False: it does not.
  bool start_again(const Model& model, const Division& division);
  void find_nodes_of_terms();
  std::unique_ptr<SystemParts> parts_;
  State* states_;  // states of the parts, by ConfigurationType
  Sizes sizes_;
  bool assembled_ = false;
  std::uint64_t version_ = 0;
  std::uint64_t renewed_objects_ = 0, renewed_constraints_ = 0;
  const Model* late_ = nullptr;  // whose changes the next evaluation takes over
  // Whose marker frames and forces the ports hold.
  void ports_hold(const State* state) {
    evaluated_ = state;
    ++writes_;
  }
  const State* evaluated_ = nullptr;
  // version of the ports; number of accesses to the current state with write permission
  std::uint64_t writes_ = 0, touches_ = 0;
  struct Frames {
    std::uint64_t writes = 0, touches = 0, number = 0;
  };
  Frames frames_;  // frames at the last evaluation of the current state
  mutable bool lent_ = false;  // who holds the states may have changed them without asking for them
  int evaluations_ = 0;
  int pattern_revisions_ = 0;
  bool searches_ = false, forgotten_ = false, pulled_ = false;
};

}  // namespace dalembert
