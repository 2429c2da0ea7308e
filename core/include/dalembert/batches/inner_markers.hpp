// Frames of nodes or bodies of any types, for markers that are made of several.
#pragma once

#include <memory>
#include <vector>

#include "dalembert/system/physics.hpp"

namespace dalembert {

// Frame markers on nodes and bodies of any types, inside another marker: they have ports of their own.
class InnerMarkers {
 public:
  // The number of the new marker's port; -1: the node or body has no such frame.
  int add(const ItemType& node, FrameShape shape, const void* record, std::span<const int> dofs);
  int add(const MarkerOwner& owner, FrameShape shape, std::span<const int> dofs, const Vec3<double>& local);
  void refresh(int port, const Vec3<double>& local);
  void refresh_owner(int port, const void* record);

  void visit(BlockVisitor& visitor) const;
  void evaluate(const Evaluation& evaluation);
  void evaluate_tangent(const Evaluation& evaluation, const Weights& weights);
  void clear_forces();
  void pull_back(const Evaluation& evaluation, double* r);
  // `slots` are those of the entries that `visit` named.
  void geometric(const Evaluation& evaluation, const Weights& weights, std::span<const int> slots, double* values);
  bool motion(int port, const Evaluation& evaluation, Motion<double>& m) const;

  Ports ports;

 private:
  struct Group {
    const ItemType* owner;
    std::vector<const ItemType*> nodes;
    FrameShape shape;
    std::unique_ptr<MarkerBatch> batch;
    int count = 0;
  };
  struct Member {
    int group, entry;
  };
  std::vector<Group> groups_;
  std::vector<Member> members_;  // by port
};

}  // namespace dalembert
