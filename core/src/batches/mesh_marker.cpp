#include "dalembert/batches/mesh_marker.hpp"

#include <algorithm>

#include "dalembert/markers/super_element_position_parameters.hpp"
#include "dalembert/model/errors.hpp"

namespace dalembert {

int InnerMarkers::add(const ItemType& node, FrameShape shape, const void* record, std::span<const int> dofs) {
  return add({&node, record, {}, {}, static_cast<int>(dofs.size())}, shape, dofs, {});
}

int InnerMarkers::add(const MarkerOwner& owner, FrameShape shape, std::span<const int> dofs, const Vec3<double>& local) {
  auto group = std::ranges::find_if(
      groups_, [&](const Group& g) { return g.owner == owner.type && g.nodes == owner.nodes && g.shape == shape; });
  if (group == groups_.end()) {
    const auto* node = dynamic_cast<const NodePhysics*>(owner.type->physics);
    auto batch = node != nullptr ? node->make_marker(shape)
                                 : dynamic_cast<const ObjectPhysics&>(*owner.type->physics).make_marker(shape, owner.nodes);
    if (batch == nullptr) return -1;
    groups_.push_back({owner.type, owner.nodes, shape, std::move(batch)});
    group = groups_.end() - 1;
  }
  Placement p;
  p.item = static_cast<int>(members_.size());
  p.owner = owner.record;
  p.owner_type = owner.type;
  p.node_records = owner.node_records;
  p.dofs.assign(dofs.begin(), dofs.end());
  ports.append(group->batch->value_count(&local, p), group->batch->force_count(&local, p), p.dofs);
  group->batch->add(&local, p, ports);
  members_.push_back({static_cast<int>(group - groups_.begin()), group->count++});
  return p.item;
}

void InnerMarkers::refresh(int port, const Vec3<double>& local) {
  const Member& member = members_[static_cast<std::size_t>(port)];
  groups_[static_cast<std::size_t>(member.group)].batch->refresh(member.entry, &local);
}
void InnerMarkers::refresh_owner(int port, const void* record) {
  const Member& member = members_[static_cast<std::size_t>(port)];
  groups_[static_cast<std::size_t>(member.group)].batch->refresh_owner(member.entry, record);
}

void InnerMarkers::visit(BlockVisitor& visitor) const {
  for (const Group& g : groups_) g.batch->visit(visitor, ports);
}
void InnerMarkers::evaluate(const Evaluation& evaluation) {
  for (const Group& g : groups_) g.batch->evaluate(evaluation, ports);
}
void InnerMarkers::evaluate_tangent(const Evaluation& evaluation, const Weights& weights) {
  ports.differentiate();
  for (const Group& g : groups_) g.batch->evaluate_tangent(evaluation, weights, ports);
}
void InnerMarkers::clear_forces() { std::ranges::fill(ports.forces, 0.0); }
void InnerMarkers::pull_back(const Evaluation& evaluation, double* r) {
  for (const Group& g : groups_) g.batch->pull_back(evaluation, ports, r);
}

namespace {

class Counter final : public BlockVisitor {
 public:
  void entry(int, int) override { ++count; }
  std::ptrdiff_t count = 0;
};

}  // namespace

void InnerMarkers::geometric(const Evaluation& evaluation, const Weights& weights, std::span<const int> slots, double* values) {
  auto next = slots.begin();
  for (const Group& g : groups_) {
    Counter counter;
    g.batch->visit(counter, ports);
    g.batch->slots.assign(next, next + counter.count);
    next += counter.count;
    g.batch->geometric(evaluation, weights, ports, values);
  }
}
bool InnerMarkers::motion(int port, const Evaluation& evaluation, Motion<double>& m) const {
  const Member& member = members_[static_cast<std::size_t>(port)];
  return groups_[static_cast<std::size_t>(member.group)].batch->motion(member.entry, evaluation, m);
}

std::vector<int> node_coordinates(const Placement& on, std::span<const int> mesh_nodes) {
  std::vector<int> positions;
  for (const int node : mesh_nodes) {
    int first = 0;
    for (int i = 0; i < node; ++i) first += on.node_sizes[i];
    for (int i = 0; i < on.node_sizes[node]; ++i) positions.push_back(first + i);
  }
  return positions;
}

namespace {

// Position and velocity of the marker are sums over its nodes, a force is shared out by the same weights.
class MeshPositionBatch final : public MarkerBatch {
 public:
  explicit MeshPositionBatch(std::span<const ItemType* const> nodes) : types_(nodes.begin(), nodes.end()) {}

  int value_count(const void*, const Placement&) const override { return PointPort::values; }
  int force_count(const void*, const Placement&) const override { return PointPort::forces; }

  void add(const void* record, const Placement& placement, const Ports&) override {
    const auto& p = static_cast<const MarkerSuperElementPositionRecord*>(record)->parameters;
    Entry e;
    e.marker = placement.item;
    e.weights = p.weightingFactors;
    auto dof = placement.dofs.begin();
    for (const int node : p.meshNodeNumbers) {
      const int size = placement.node_sizes[node];
      e.ports.push_back(nodes_.add(*types_[node], FrameShape::point, placement.node_records[node], {dof, dof + size}));
      if (e.ports.back() < 0)
        refuse(ErrorKind::value,
               {"marker " + std::to_string(e.marker) + " (MarkerSuperElementPosition)", "meshNodeNumbers",
                "mesh node " + std::to_string(node) + " is a " + std::string(types_[node]->name) +
                    ", which has no position",
                "", "mesh nodes with a position", ""});
      dof += size;
    }
    entries_.push_back(std::move(e));
  }
  void refresh(int entry, const void* record) override {
    entries_[entry].weights = static_cast<const MarkerSuperElementPositionRecord*>(record)->parameters.weightingFactors;
  }
  void visit(BlockVisitor& visitor, const Ports&) const override { nodes_.visit(visitor); }

  void evaluate(const Evaluation& evaluation, Ports& ports) const override {
    nodes_.evaluate(evaluation);
    for (const Entry& e : entries_) {
      double* frame = ports.frame(e.marker);
      std::fill_n(frame, PointPort::values, 0.0);
      for (std::size_t k = 0; k < e.ports.size(); ++k) {
        const double* node = nodes_.ports.frame(e.ports[k]);
        for (int i = 0; i < PointPort::values; ++i) frame[i] += e.weights[k] * node[i];
      }
    }
  }
  void evaluate_tangent(const Evaluation& evaluation, const Weights& weights, Ports& ports) const override {
    nodes_.evaluate_tangent(evaluation, weights);
    for (const Entry& e : entries_) {
      const int n = ports.ports[e.marker].n;
      double* derivative = ports.derivative(e.marker);
      double* jacobian = ports.jacobian(e.marker);
      for (std::size_t k = 0; k < e.ports.size(); ++k) {
        const int own = nodes_.ports.ports[e.ports[k]].n;
        copy_columns(PointPort::values, own, n, e.weights[k], nodes_.ports.derivative(e.ports[k]), derivative);
        copy_columns(PointPort::forces, own, n, e.weights[k], nodes_.ports.jacobian(e.ports[k]), jacobian);
        derivative += own;
        jacobian += own;
      }
    }
  }
  void pull_back(const Evaluation& evaluation, Ports& ports, double* r) const override {
    share_forces(ports);
    nodes_.pull_back(evaluation, r);
  }
  void geometric(const Evaluation& evaluation, const Weights& weights, const Ports& ports,
                 double* values) const override {
    share_forces(ports);
    nodes_.geometric(evaluation, weights, slots, values);
  }
  bool motion(int entry, const Evaluation& evaluation, Motion<double>& m) const override {
    const Entry& e = entries_[entry];
    m = {};
    for (std::size_t k = 0; k < e.ports.size(); ++k) {
      Motion<double> node;
      nodes_.motion(e.ports[k], evaluation, node);
      m.position += e.weights[k] * node.position;
      m.velocity += e.weights[k] * node.velocity;
      m.acceleration += e.weights[k] * node.acceleration;
    }
    return true;
  }

 private:
  struct Entry {
    int marker = -1;
    std::vector<double> weights;
    std::vector<int> ports;  // one per mesh node
  };

  // `to` is the first of `own` columns within rows of n.
  static void copy_columns(int rows, int own, int n, double weight, const double* from, double* to) {
    for (int i = 0; i < rows; ++i)
      for (int j = 0; j < own; ++j) to[i * n + j] = weight * from[i * own + j];
  }
  void share_forces(const Ports& ports) const {
    nodes_.clear_forces();
    for (const Entry& e : entries_)
      for (std::size_t k = 0; k < e.ports.size(); ++k)
        for (int i = 0; i < PointPort::forces; ++i)
          nodes_.ports.force(e.ports[k])[i] += e.weights[k] * ports.force(e.marker)[i];
  }

  std::vector<const ItemType*> types_;
  std::vector<Entry> entries_;
  mutable InnerMarkers nodes_;  // its ports are work space
};

}  // namespace

std::unique_ptr<MarkerBatch> make_mesh_position_marker(std::span<const ItemType* const> nodes) {
  return std::make_unique<MeshPositionBatch>(nodes);
}

}  // namespace dalembert
