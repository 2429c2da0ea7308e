#include "dalembert/batches/inner_markers.hpp"

#include <algorithm>

namespace dalembert {

int InnerMarkers::add(const ItemType& node, FrameShape shape, const void* record, std::span<const int> dofs) {
  return add({&node, record, {}, {}, {}, static_cast<int>(dofs.size())}, shape, dofs, {});
}

int InnerMarkers::add(const MarkerOwner& owner, FrameShape shape, std::span<const int> dofs,
                      const Vec3<double>& local) {
  auto group = std::ranges::find_if(
      groups_, [&](const Group& g) { return g.owner == owner.type && g.nodes == owner.nodes && g.shape == shape; });
  if (group == groups_.end()) {
    const auto* node = dynamic_cast<const NodePhysics*>(owner.type->physics);
    auto batch = node != nullptr
                     ? node->make_marker(shape)
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
  p.reference = owner.reference;
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

void InnerMarkers::geometric(const Evaluation& evaluation, const Weights& weights, std::span<const int> slots,
                             double* values) {
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

}  // namespace dalembert
