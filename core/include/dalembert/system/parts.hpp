// The inside of a System: batches, index tables and work space.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <unordered_map>
#include <vector>

#include "dalembert/math/few_numbers.hpp"
#include "dalembert/math/rotations.hpp"
#include "dalembert/math/stretch.hpp"
#include "dalembert/model/member.hpp"
#include "dalembert/model/model.hpp"
#include "dalembert/system/load_dependencies.hpp"
#include "dalembert/system/physics.hpp"
#include "dalembert/system/regions.hpp"
#include "dalembert/system/system.hpp"
#include "dalembert/system/system_term.hpp"
#include "dalembert/system/tree_term.hpp"
#include "dalembert/system/unit_vectors.hpp"
#include "dalembert/system/workers.hpp"

namespace dalembert {

// Ranges of a node in the system vectors; -1: no coordinates of that kind.
struct NodePlace {
  const ItemType* type = nullptr;
  const NodePhysics* physics = nullptr;
  std::shared_ptr<const void> record;
  Sizes sizes;
  int ode2 = -1, ode1 = -1, ae = -1, data = -1;
  int translations = 0;  // coordinates that are components of the position
  int rotating = -1;     // among the rotating nodes of the ports

  int first(System::Coordinates kind) const { return std::array{ode2, ode1, ae, data}[static_cast<std::size_t>(kind)]; }
};

// Batch of an item, and its entry there.
template <class B>
struct Membership {
  B* batch = nullptr;
  int entry = -1;
};

inline void append_range(std::vector<int>& list, int first, int count) {
  for (int i = 0; i < count; ++i) list.push_back(first + i);
}

// Mesh nodes that stand for the size of all in space, of an object with a record.
struct OutermostNodes {
  std::shared_ptr<const void> record;
  std::vector<int> nodes;
};

struct ObjectPlace {
  const ItemType* type = nullptr;
  std::shared_ptr<const void> record;
  Membership<Term> member;
  Stretch nodes, markers;  // ranges of SystemParts::references
  int first_ae = -1, equations = 0;  // algebraic ones, counted in the AE vector
  OutermostNodes outermost{};
};

// Objects that follow each other in one batch, which are of one type.
struct ObjectRun {
  Membership<Term> first;
  int count = 0;
};

struct MarkerPlace {
  const ItemType* type = nullptr;
  std::shared_ptr<const void> record;
  Membership<MarkerBatch> member;
  int node = -1, object = -1;  // carrier of the marker, the first one if there are several
  Stretch objects;  // range of SystemParts::references
};

// A marker, and which of the bodies that it sits on is meant.
struct MarkerSeat {
  int marker = -1, which = 0;
};

struct LoadPlace {
  const ItemType* type = nullptr;
  std::shared_ptr<const void> record;
  Membership<Term> member;
  int marker = -1;
};

// Values that stand in a state as they are: components of a position, displacement, velocity or acceleration in space.
struct StateReading {
  std::vector<double> State::* from = nullptr;  // null: it does not stand there
  int first = 0, count = 0;                    // the other components are zero
  bool is_total = false;                       // reference values are added
  explicit operator bool() const { return from != nullptr; }
  void read(const State& state, const State& reference, std::vector<double>& values) const;
};
// Translation of a node's point, in states other than the reference.
StateReading translation_reading(const NodePlace& node, OutputVariableType variable);

struct SensorPlace {
  const ItemType* type = nullptr;
  std::shared_ptr<const void> record;
  StateReading reading;  // if all that it measures stands in the state
};

// False: no item of this type ever has that output variable.
bool may_have(const ItemType& type, OutputVariableType variable);
// Output variables of everything with a position and an orientation.
bool follows_from_motion(OutputVariableType variable);

// Ranges of numbers, those that follow each other as one.
class Ranges {
 public:
  void add(int first, int count) {
    if (count == 0) return;
    if (ranges_.empty() || ranges_.back().end != first) ranges_.push_back({first, first});
    ranges_.back().end += count;
  }
  // Calls f(first, count) for each of them.
  template <class F>
  void each(const F& f) const {
    for (const auto& [first, end] : ranges_) f(static_cast<std::size_t>(first), static_cast<std::size_t>(end - first));
  }

 private:
  struct Range {
    int first, end;
  };
  std::vector<Range> ranges_;
};

// Numbers that an evaluation resets in a region before summation: those that are not in a smaller region.
struct RegionNumbers {
  Ranges coordinates;  // second-order coordinates
  Ranges rows;  // rows of the residual, and columns of its tangent
  Ranges forces, node_loads;  // ranges of the ports
};

// A region, and its batches that an evaluation visits, in this order.
struct RegionPlan {
  RegionNumbers numbers;
  std::vector<const RotatingNodeBatch*> nodes;
  std::vector<const MarkerBatch*> moving;
  std::vector<const MarkerBatch*> differentiated;  // moving ones whose derivatives are used
  std::vector<const MarkerBatch*> pulled;          // moving ones on which forces act that may change
  std::vector<const MarkerBatch*> needed, needed_pulled;  // subset that is needed if terms read nodes themselves
  std::vector<const Term*> terms, loads;
  std::vector<const Term*> changing_loads;
  std::vector<const Term*> with_equations;  // terms of objects and nodes that have algebraic equations
  int entries = 0;  // sum over these batches
};

struct RegionsOfOneSize {
  std::span<const RegionPlan> regions;
  bool is_shared = false;  // among threads: there is enough to do
};

// Constant loads on markers whose pull-back is constant: their part of the residual is found once, and scaled by the load factor.
struct ConstantLoads {
  std::vector<const Term*> loads;
  std::vector<const MarkerBatch*> markers;
  std::vector<double> residual;  // empty if there are no constant loads
};

// Batches, of which there are few while many items name them, one after the other.
class BatchSet {
 public:
  void add(const Batch* batch) {
    if (batches_.empty() || batches_.back() != batch) batches_.push_back(batch);
  }
  void sort() {
    std::ranges::sort(batches_);
    batches_.erase(std::ranges::unique(batches_).begin(), batches_.end());
  }
  bool contains(const Batch* batch) const { return std::ranges::binary_search(batches_, batch); }  // after sort()
  const std::vector<const Batch*>& all() const { return batches_; }

 private:
  std::vector<const Batch*> batches_;
};

// Regions of one size share no coordinates. Markers without coordinates rest: their frames are evaluated once.
struct EvaluationPlan {
  std::vector<const MarkerBatch*> resting;
  std::vector<RegionPlan> regions;
  std::vector<RegionsOfOneSize> sizes;  // small ones first
  BatchSet connected;  // markers of objects
  ConstantLoads constant;
  bool resting_evaluated = false;  // constant loads as well
};

struct SystemParts {
  Sizes sizes;
  std::vector<NodePlace> nodes;
  std::vector<ObjectPlace> objects;
  std::vector<ObjectRun> object_runs;  // the objects, as ranges of the same type
  std::vector<MarkerPlace> markers;
  std::vector<LoadPlace> loads;
  std::vector<SensorPlace> sensors;
  std::vector<int> completed;    // objects with parameters that Assemble finds
  std::vector<int> references;  // item numbers that items refer to
  std::vector<MarkerSeat> seats;  // by objects, then nodes; computed on first use
  std::vector<std::uint32_t> seats_end;  // end of each of them
  std::array<std::unordered_map<int, std::string>, item_kinds> given_names;  // names of items that have one
  Model::Titles titles;

  // In the order of evaluation. Bodies come first: their order of entries determines the order of sums.
  std::vector<std::unique_ptr<Term>> terms;
  std::vector<SystemTerm*> system_terms;  // terms among them that are not items
  std::vector<std::unique_ptr<MarkerBatch>> marker_batches;
  std::vector<std::unique_ptr<RotatingNodeBatch>> rotating_nodes;
  std::vector<LoadDependency> load_dependencies;
  Division division;  // by which the plan was made
  EvaluationPlan plan;
  bool leaves_markers_to_terms = false;  // some are not needed, where these read nodes themselves;
  bool needs_totals = true;              // there,
  bool knows_needed_markers = false;  // for the current parameters
  bool knows_terms_with_equations = false;
  bool is_pulled = false;  // there are forces of a pull
  bool loads_are_sorted = true;  // into constant and other loads, for the current parameters
  // user functions may only be called by the thread of the solver, which then evaluates everything
  bool functions_in_regions = false;
  // user functions: of the current loads; of the types of nodes and objects
  bool loads_call_functions = false, others_take_functions = false;
  std::unique_ptr<Workers> workers;  // null: one thread only
  std::vector<System::LieBlock> lie_blocks;
  std::vector<UnitVector> unit_vectors;
  Ports ports;
  std::vector<double> static_signs;  // sign of each algebraic variable
  std::vector<char> not_unique;  // flags of non-unique multipliers, set by solvers; empty: unknown
  bool has_history = false;  // history of items, and of terms with a search in explicit integration
  bool has_direct_history = false;  // history of terms without a search in explicit integration
  bool has_switches = false;

  using States = std::array<State, 6>;  // by ConfigurationType
  std::shared_ptr<States> kept_states = std::make_shared<States>();  // views from outside keep them
  States& states = *kept_states;
  std::uint64_t structure = 0, equations = 0, values = 0, records = 0;  // changes of the model, as assembled

  std::optional<Pattern> dense_pattern, mass_pattern;  // made when asked for
  std::vector<const Term*> without_matrix;  // terms without a part in the current mass pattern
  std::vector<const MassSolver*> mass_solvers;
  std::vector<int> coordinates_without_matrix;
  // likewise; new solvers use the last one, running ones may still use earlier ones
  std::list<Pattern> sparse_patterns;
  const Pattern* bound = nullptr;  // the pattern whose slots the batches hold
  std::vector<int> rate_slots;     // diagonal places of the ODE1 coordinates

  std::vector<double> total;     // reference + displacement, of the state being evaluated
  std::vector<double>
      output_total;  // the same for outputs, which user functions ask for in the middle of an evaluation; empty before
  std::vector<int> free_numbers;  // memory for lists of outputs
  AlignedVector<double> output_forces;  // on markers, of one object
  std::vector<double> output_multipliers;  // with the sign that they have in equations of motion
  std::vector<double> work;
  std::vector<double> data_before;  // items switch over
  std::optional<Pull> pull;
  std::vector<PullForce> pull_forces;  // of this step
  bool evaluating = false;
  bool current_moved = false;  // moved away from the evaluated state to differentiate user functions
  bool recording = false;  // outputs are asked for one after the other, in one state:
  const State* recorded = nullptr;  // whose marker frames are in place

  std::string describe(ItemKind kind, int number) const;  // for diagnoses
  const ItemType& type_of(ItemKind kind, int number) const;
  SensorPlace place_sensor(const Item& item) const;
  // The markers that depend on the parameters of an object, or of a node that rests.
  std::span<const MarkerSeat> markers_on(ItemKind kind, int number);
  void check_sensors() const;  // refuses output variables that an item cannot have
  State& state(ConfigurationType c) { return state_of(states.data(), c); }
  // The global coordinates of an object's nodes, and those that its markers move.
  void list_coordinates(const ObjectPlace& object, System::Coordinates kind, std::vector<int>& list) const;
  Evaluation evaluation(const State& state, const Conditions& conditions);
  Evaluation output_evaluation(const State& state);
  Evaluation output_evaluation(const State& state, std::span<const int> dofs);  // q at these coordinates only
  Evaluation output_evaluation(const State& state, std::vector<double>& totals);  // q in memory of the caller
  void update_ports(const Evaluation& e);
  void evaluate_resting(const Evaluation& e);
  void evaluate_constant_loads();
  void update_frames(const RegionPlan& region, const Evaluation& e);
  // Calls f(region) for all regions, small ones first, regions of one size side by side. Captures of `f` should be by
  // value: they stay in registers if there is one region.
  template <class F>
  DALEMBERT_INLINE void each_region(F f) const {
    plan.regions.size() == 1 ? f(plan.regions.front()) : each_of_several_regions(f);
  }
  Pattern make_sparse_pattern() const;
  void find_masses_without_matrix();
  bool is_without_matrix(const Term& term) const {
    return std::ranges::find(without_matrix, &term) != without_matrix.end();
  }
  void add_sparse_pattern() { sparse_patterns.push_back(make_sparse_pattern()); }
  void bind(const Pattern& pattern);

  // Reads the record of an item that has changed.
  template <class Place>
  void look_for_functions(const Place& place) {
    const RegionPlan& whole = plan.regions[Regions::whole];
    const auto is_in = [&](const std::vector<const Term*>& terms) {
      return std::ranges::find(terms, place.member.batch) != terms.end();
    };
    if (!has_user_function(*place.type, place.record.get()) || is_in(whole.terms) || is_in(whole.loads)) return;
    functions_in_regions = true;
    workers.reset();
  }

 private:
  template <class F>
  [[gnu::noinline]] void each_of_several_regions(F f) const {
    for (const auto& size : plan.sizes) {
      const auto& regions = size.regions;
      if (workers && size.is_shared && regions.size() > 1) {
        workers->run(static_cast<int>(regions.size()), [&](int i) { f(regions[static_cast<std::size_t>(i)]); });
      } else {
        for (const RegionPlan& region : regions) f(region);
      }
    }
  }
};

// All batches of one assembly, built item by item.
void build(SystemParts& parts, const Model& model, const Division& division);

}  // namespace dalembert
