// Interface of batches for the assembler. A term adds to the equations; a marker batch distributes frames and
// collects forces.
#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <vector>

#include "dalembert/enums.hpp"
#include "dalembert/frames.hpp"
#include "dalembert/math/traced.hpp"
#include "dalembert/system/evaluation.hpp"
#include "dalembert/system/node_frame.hpp"
#include "dalembert/system/ports.hpp"
#include "dalembert/system/state.hpp"
#include "dalembert/system/switches.hpp"

namespace dalembert {

struct ItemType;
struct Row;

// Visits the entries of the tangent that a batch writes, always in the same order: once to make the pattern, once to
// look up the slots. Rows and columns are numbers in the system vector [ODE2, ODE1, AE].
class BlockVisitor {
 public:
  virtual ~BlockVisitor() = default;
  virtual void entry(int row, int column) = 0;
  // Replaces an entry that is always zero; its slot is -1.
  virtual void zero() {}

  virtual void block(std::span<const int> rows, std::span<const int> columns) {
    for (const int row : rows)
      for (const int column : columns) entry(row, column);
  }
  // The transposed block, in the order of the block itself.
  virtual void mirror(std::span<const int> rows, std::span<const int> columns) {
    for (const int row : rows)
      for (const int column : columns) entry(column, row);
  }
};

// The slots of a batch, consumed in the order in which the blocks were visited.
template <class S>
class SlotCursorOf {
 public:
  SlotCursorOf(const int* slots, S* values) : slot_(slots), values_(values) {}
  void add(const S& x) { values_[*slot_++] += x; }
  void skip(int count) { slot_ += count; }

 private:
  const int* slot_;
  S* values_;
};
using SlotCursor = SlotCursorOf<double>;

using TracedEvaluation = EvaluationOf<Traced>;
using TracedPorts = PortsOf<Traced>;

// One of the functions of a batch, recorded instead of computed (math/traced.hpp): by the same template, with another
// scalar.
struct TracedCall {
  enum class Function { residual, tangent, evaluate, evaluate_tangent, pull_back, geometric } function;
  const TracedEvaluation& evaluation;
  const Weights& weights;  // of tangents
  TracedPorts& ports;
  Traced* sums;  // sums that are added to: rows of the residual, values of the tangent
};

struct PostNewton {
  double error = 0;
  double recommended_step_size = -1;

  // The larger error, the smaller of the recommended steps.
  void add(const PostNewton& other) {
    error = std::max(error, other.error);
    const double step = other.recommended_step_size;
    if (step >= 0 && (recommended_step_size < 0 || step < recommended_step_size)) recommended_step_size = step;
  }
};

// A body or node that a marker sits on.
struct MarkerOwner {
  const ItemType* type = nullptr;
  const void* record = nullptr;
  std::vector<const ItemType*> nodes;  // types of a body's nodes
  std::vector<const void*> node_records;
  std::vector<double> reference;       // values of its coordinates
  int dofs = 0;                        // how many of Placement::dofs are its own
};

// Things that batches need to know of the system when an item enters.
struct Placement {
  int item = -1;                     // number of the object, load, ...
  const void* owner = nullptr;       // markers: record of the body or node that they sit on,
  const ItemType* owner_type = nullptr;  // its type
  int owner_number = -1;                 // and its number; -1: it is not known
  std::vector<MarkerOwner> owners;  // markers between bodies: all carriers; otherwise empty
  std::vector<int> dofs;             // its nodes' ODE2 coordinates, one node after the other
  std::vector<double> reference;     // their reference values
  std::vector<int> ode1;             // ODE1 coordinates
  int selected = 0;  // coordinate markers: number of their coordinates; ground coordinates have no dofs
  std::vector<int> nodes;            // node numbers
  std::vector<const void*> node_records;
  std::vector<int> node_sizes;       // ODE2 coordinates per node
  int rotating_node = -1;            // its only node, if that is one of the rotating nodes of the ports
  std::vector<int> markers;
  std::vector<const ItemType*> marker_types;
  int first_data = -1;               // data coordinates, of its data node
  int data_count = 0;
  int first_ae = -1;                 // its algebraic equations, in the AE vector
  int ae_offset = 0;  // start of the AE vector in the system vector
  int ode1_offset = 0;  // start of the ODE1 vector in the system vector

  void clear() {  // the lists keep their memory
    for (auto* list : {&dofs, &ode1, &nodes, &node_sizes, &markers}) list->clear();
    owners.clear();
    marker_types.clear();
    reference.clear();
    node_records.clear();
    owner = nullptr;
    owner_type = nullptr;
    item = owner_number = first_data = first_ae = rotating_node = -1;
    selected = data_count = ae_offset = ode1_offset = 0;
  }
};

// Energy of one item: of its velocities, or stored by its strains and its own weight.
enum class Energy { kinetic, potential };

class Batch {
 public:
  virtual ~Batch() = default;
  // Expected number of items.
  virtual void reserve(int /*entries*/) {}
  virtual void add(const void* record, const Placement& placement, const Ports& ports) = 0;
  virtual void refresh(int entry, const void* record) = 0;
  // Updates the entry after a change of one row of its record.
  virtual void refresh_row(int entry, const void* record, const Row& /*row*/) { refresh(entry, record); }
  // Nodes without coordinates, under the entry, have new parameters.
  virtual void refresh_resting(int /*entry*/, const void* /*record*/, const Placement& /*placement*/) {}
  // Entries of the tangent, in the order in which `tangent` writes.
  virtual void visit(BlockVisitor& visitor, const Ports& ports) const = 0;
  virtual bool traceable() const { return false; }
  virtual void trace(const TracedCall&) const {}

  std::vector<int> slots;  // bound to the pattern in use by the system
};

// Bodies, connectors, constraints, loads, conditions of nodes.
class Term : public Batch {
 public:
  // Adds to r [ODE2, ODE1, AE] and to the forces of the ports.
  virtual void residual(const Evaluation& evaluation, Ports& ports, double* r) const = 0;
  // Derivative of the contribution of `residual`, with port forces converted to generalised forces.
  virtual void tangent(const Evaluation& evaluation, const Weights& weights, Ports& ports, double* values) const = 0;
  // False: the contribution of `residual` is constant, and derivatives of markers are not needed.
  virtual bool has_tangent() const { return true; }
  // False: it adds to the first three port forces only.
  virtual bool has_moments() const { return true; }
  // Adds the mass matrix only; writes the same blocks as `tangent`.
  virtual void mass(const Evaluation&, Ports&, double*) const {}
  virtual bool has_mass() const { return false; }
  // False: its residual does not read total coordinates if inertia is not included.
  virtual bool reads_totals() const { return true; }
  // Adds its masses by coordinate if they are not coupled in this state; otherwise returns false, and the sum is
  // invalid.
  virtual bool add_diagonal_masses(const Evaluation&, double* /*diagonal*/) const { return !has_mass(); }
  virtual bool constant_mass() const { return true; }

  // History: new data coordinates after Newton. `start` has the data at the start of the step. Algebraic unknowns
  // that are transferred to data are reset.
  virtual PostNewton post_newton(const Evaluation&, const Ports&, const double* /*start*/, double* /*data*/,
                                 double* /*lambda*/) {
    return {};
  }
  virtual bool has_history() const { return false; }
  // Switching functions of its items, and the new data coordinates. Solvers that end steps at switches do not need
  // `post_newton`.
  virtual bool has_switches() const { return false; }
  virtual void find_switches(const Evaluation&, const Ports&, Switches&) const {}
  virtual void switch_over(const Evaluation&, const Ports&, const double* /*before*/, double* /*data*/,
                           double* /*lambda*/) {}
  // Iteration that such solvers still need.
  virtual PostNewton settle(const Evaluation&, const Ports&, const double* /*start*/, double* /*data*/,
                            double* /*lambda*/) {
    return {};
  }

  // Outputs. `motion` for bodies; `output` for variables of the item; false: not an output of this item.
  virtual bool motion(int /*entry*/, const Evaluation&, const Vec3<double>& /*local*/, Motion<double>&) const {
    return false;
  }
  // Position and rotation of the origins of consecutive entries: 3 x 4 numbers each, row by row; NaN: undefined.
  virtual void poses(int first, int count, const Evaluation& evaluation, double* rows) const;
  virtual bool output(int /*entry*/, OutputVariableType, const Vec3<double>& /*local*/, const Evaluation&, const Ports&,
                      std::vector<double>&) const {
    return false;
  }
  // Energy of an entry in J; false: it is not known, e.g. with a user function.
  virtual bool energy(int /*entry*/, Energy, const Evaluation&, double& /*value*/) const { return false; }
  // Mesh nodes that are not at the positions of system nodes: their number, and outputs of a range of them, row by
  // row.
  virtual int mesh_nodes(int /*entry*/) const { return 0; }
  virtual bool mesh_outputs(int /*entry*/, int /*first*/, int /*count*/, OutputVariableType, const Evaluation&,
                            std::vector<double>&) const {
    return false;
  }
  // They are all nodes of the item but the first, whose own outputs are in its frame.
  virtual bool has_nodes_in_frame() const { return false; }
};

// Nodes whose rotations have closed-form derivatives: their bodies and markers share the motion, and sum their forces
// there.
class RotatingNodeBatch : public Batch {
 public:
  virtual void evaluate(const Evaluation& evaluation, Ports& ports) const = 0;
  // False: these nodes compute total coordinates themselves if terms do so.
  virtual bool reads_totals() const { return true; }
  virtual void evaluate_tangent(const Evaluation& evaluation, const Weights& weights, Ports& ports) const = 0;
  // r -= generalised forces of the loads; values -= their derivatives with the loads held fixed.
  virtual void pull_back(const Evaluation& evaluation, const Ports& ports, double* r) const = 0;
  virtual void geometric(const Evaluation& evaluation, const Weights& weights, Ports& ports, double* values) const = 0;
};

class MarkerBatch : public Batch {
 public:
  virtual NodeFrame node_frame(int /*entry*/) const { return {}; }
  // The body or node under a marker has new parameters.
  virtual void refresh_owner(int /*entry*/, const void* /*record*/) {}
  // Variant for markers between bodies; `which` is an index in Placement::owners.
  virtual void refresh_owners(int entry, int which, const void* record) {
    if (which == 0) refresh_owner(entry, record);
  }
  // Layout of one marker's port, before it is appended.
  virtual int value_count(const void* record, const Placement& placement) const = 0;
  virtual int force_count(const void* record, const Placement& placement) const = 0;
  virtual int translations() const { return 0; }  // see PortLayout
  // Its values are those of its coordinates, one by one, and their rates.
  virtual bool shows_coordinates() const { return false; }

  virtual void evaluate(const Evaluation& evaluation, Ports& ports) const = 0;
  // Derivatives and Jacobians of the ports, for the terms' tangents.
  virtual void evaluate_tangent(const Evaluation& evaluation, const Weights& weights, Ports& ports) const = 0;
  // r -= J^T force.
  virtual void pull_back(const Evaluation& evaluation, Ports& ports, double* r) const = 0;
  // J, or its rows of forces, is independent of coordinates and other variables; rows of moments are not queried if
  // there are no moments.
  virtual bool constant_pull_back(bool /*of_moments*/) const { return false; }
  // Whether one marker has a constant pull-back; the value of the batch holds for all of its markers.
  virtual bool passes_constantly(int /*entry*/, bool of_moments) const { return constant_pull_back(of_moments); }
  // values -= d(J^T force) with the force held fixed.
  virtual void geometric(const Evaluation& evaluation, const Weights& weights, const Ports& ports,
                         double* values) const = 0;
  // Whether `geometric` uses results of `evaluate_tangent`.
  virtual bool geometric_follows_tangent() const { return true; }
  // History: new data coordinates after Newton, from the ports.
  virtual void post_newton(const Evaluation&, const Ports&, double* /*data*/) const {}
  virtual bool has_history() const { return false; }
  // Full motion of a marker, for outputs.
  virtual bool motion(int /*entry*/, const Evaluation&, Motion<double>&) const { return false; }
};

}  // namespace dalembert
