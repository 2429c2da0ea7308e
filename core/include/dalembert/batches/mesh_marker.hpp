// Markers that are made of frames of several nodes or bodies.
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

// The weighted mean of the positions of mesh nodes that are the object's own nodes; the markers' record is that of
// MarkerSuperElementPosition.
std::unique_ptr<MarkerBatch> make_mesh_position_marker(std::span<const ItemType* const> nodes);
// The weighted mean of their positions and rotation; the markers' record is that of MarkerSuperElementRigid.
std::unique_ptr<MarkerBatch> make_mesh_rigid_marker(std::span<const ItemType* const> nodes);
// Positions in Placement::dofs of the coordinates of some of the object's nodes, one node after the other.
std::vector<int> node_coordinates(const Placement& on, std::span<const int> mesh_nodes);

}  // namespace dalembert
