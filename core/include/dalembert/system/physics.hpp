// Connection of items of one type with the equations: makes batches from records. One object per ready item type,
// made by the templates in batches/ and named by the generated ItemType.
#pragma once

#include <memory>
#include <numeric>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "dalembert/model/errors.hpp"
#include "dalembert/reflection/item_type.hpp"
#include "dalembert/system/term.hpp"

namespace dalembert {

class System;

struct Physics {
  virtual ~Physics() = default;
  // Refuses parameters that contradict each other; `item` is how errors name it.
  virtual void check_values(const void* /*record*/, const ItemLabel& /*item*/) const {}
  // Warning about parameters that no real system has, although they can be computed; empty if there is none.
  virtual std::string doubt(const void* /*record*/) const { return {}; }
  // Refuses parameters that do not fit the nodes and markers of the item.
  virtual void check(const void* /*record*/, const Placement&, const Ports&, const ItemLabel& /*item*/) const {}
  // Checks the parameters again after a change of one row.
  virtual void check_row(const void* record, const Placement& on, const Ports& ports, const ItemLabel& item,
                         const Row& /*row*/) const {
    check(record, on, ports, item);
  }
  // The item does not need its data node with these parameters.
  virtual bool works_without_data(const void* /*record*/) const { return false; }
};

inline std::vector<int> all_positions(const std::vector<int>& of) {
  std::vector<int> all(of.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

// Type of the frame of a marker.
enum class FrameShape { point, rigid, mass };

// Start values of a node, as its parameters state them.
struct NodeValues {
  std::vector<double> reference, displacement, velocity;  // ODE2
  std::vector<double> reference_ode1, ode1;
  std::vector<double> algebraic, data;

  void clear() {  // the lists keep their memory
    for (auto* list : {&reference, &displacement, &velocity, &reference_ode1, &ode1, &algebraic, &data}) list->clear();
  }
};

// A node's coordinates in some state, totals and displacements.
struct NodeView {
  std::span<const double> q, u, v, a;  // ODE2
  std::span<const double> y, y_total, y_t;
  std::span<const double> lambda, data;
};

struct NodePhysics : Physics {
  virtual Sizes sizes(const void* record) const = 0;
  virtual void values(const void* record, NodeValues& values) const = 0;
  // First of the three rotation coordinates of a Lie-group node, relative to its own; -1: additive.
  virtual int lie_rotation() const { return -1; }
  // Number of leading coordinates that are components of the position, whose other components are zero; 0: none.
  virtual int translations() const { return 0; }
  virtual std::unique_ptr<Term> make_condition() const { return nullptr; }
  virtual std::unique_ptr<RotatingNodeBatch> make_rotating() const { return nullptr; }
  virtual std::unique_ptr<MarkerBatch> make_marker(FrameShape) const { return nullptr; }
  virtual bool motion(const void* /*record*/, const NodeView&, Motion<double>&) const { return false; }
  // Outputs that are neither coordinates nor follow from `motion`.
  virtual bool output(const void* /*record*/, OutputVariableType, const NodeView&, std::vector<double>&) const {
    return false;
  }
};

// A weighted mean of mesh nodes, as the parameters of a marker state it.
struct MeshMean {
  enum class Rotation { none, linear, exponential, exact };  // the last one with a rate to match
  std::vector<int> nodes;  // numbered within the body
  std::vector<double> weights;
  Rotation rotation = Rotation::none;
  bool of_momentum = false;  // the rotation follows from the angular momentum of the nodes, not from squared distances
  Vec3<double> offset{};  // offset of the marker in the frame, if it has a rotation
};
using MeshMeanReader = MeshMean (*)(const void* record);

// Properties of a constraint that need no evaluation: it is inactive, or keeps linear combinations of coordinates at
// zero.
enum class Holding { unknown, nothing, zero };

struct ObjectPhysics : Physics {
  virtual std::unique_ptr<Term> make_batch(std::span<const ItemType* const> nodes) const = 0;
  virtual std::unique_ptr<MarkerBatch> make_marker(FrameShape, std::span<const ItemType* const> /*nodes*/) const {
    return nullptr;
  }
  // Super elements: how many mesh nodes there are, which coordinates (positions in Placement::dofs) move some of them,
  // and markers that rest on several of them.
  virtual int mesh_nodes(const void* /*record*/, const Placement&) const { return 0; }
  virtual std::vector<int> mesh_coordinates(const void* /*record*/, const Placement& on,
                                            std::span<const int> /*mesh_nodes*/) const {
    return all_positions(on.dofs);
  }
  virtual std::unique_ptr<MarkerBatch> make_mesh_marker(FrameShape, std::span<const ItemType* const> /*nodes*/,
                                                        MeshMeanReader) const {
    return nullptr;
  }
  // Whether Assemble finds some of the parameters, and the record that has them too.
  virtual bool completes() const { return false; }
  virtual std::shared_ptr<const void> completed(const void* /*record*/, const Placement&,
                                                const ItemLabel& /*item*/) const {
    return nullptr;
  }
  virtual int algebraic_equations(const void* /*record*/, std::span<const int> /*marker coordinates*/) const {
    return 0;
  }
  virtual Holding holds(const void* /*record*/) const { return Holding::unknown; }
};

// The item and the output variable that a sensor names.
struct SensorSubject {
  // Part of an object with several parts; `object` is the name of such objects in error texts.
  struct Link {
    int number;
    std::string_view object;
  };
  ItemKind kind = ItemKind::node;
  int number = -1;
  OutputVariableType variable = OutputVariableType::_None;
  std::optional<Link> link = {};
  bool is_value = false;  // the sensor measures the output variable itself, which may be read from the state
};

struct SensorPhysics : Physics {
  virtual void measure(System& system, const void* record, int sensor, ConfigurationType configuration,
                       std::vector<double>& values) const = 0;
  virtual std::optional<SensorSubject> subject(
      const void* record) const = 0;  // none: its values are not those of one item
};

struct LoadPhysics : Physics {
  // Follower loads read the rotation of their marker; other loads also accept markers without rotation.
  virtual bool body_fixed(const void* /*record*/) const { return false; }
  virtual std::unique_ptr<Term> make_batch(bool body_fixed) const = 0;
  virtual std::vector<double> values(const void* record, double time) const = 0;
};

struct MarkerPhysics : Physics {
  // Markers with the frame of a body or node return its shape; other markers make their own batch.
  virtual bool passes_frame(FrameShape&, Vec3<double>& /*local*/, const void* /*record*/) const { return false; }
  // Coordinates of first order have no rate of their own: connectors cannot use their markers.
  virtual bool has_rate() const { return true; }
  // Coordinates of its node or object that move it, as positions in Placement::dofs; these then become the dofs.
  virtual std::vector<int> coordinates(const void* /*record*/, const Placement& on) const {
    return all_positions(on.dofs);
  }
  // `item`: type of the node or object that the marker sits on, `nodes`: types of its nodes.
  virtual std::unique_ptr<MarkerBatch> make_batch(const ItemType& item,
                                                  std::span<const ItemType* const> nodes) const = 0;
};

}  // namespace dalembert
