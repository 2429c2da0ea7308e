// Contact search for pairs with convex shapes or planes: neighbours, and current contact points.
#pragma once

#include <span>
#include <vector>

#include "dalembert/contact/convex_mesh.hpp"
#include "dalembert/contact/contact_set.hpp"
#include "dalembert/contact/sphere_neighbours.hpp"
#include "dalembert/system/workers.hpp"

namespace dalembert {

class ConvexScene {
 public:
  // Participants: convex shapes, spheres, bodies with triangles, planes.
  void build(const ContactSet& set, const std::vector<Triangle>& triangles, const std::vector<Facet>& facets,
             const std::vector<BoxTree>& trees);
  bool empty() const { return convex_ == 0 && planes_ == 0; }
  int participants() const { return first_plane() + planes_; }
  int first_ball() const { return convex_; }
  int first_carrier() const { return convex_ + balls_; }
  int first_plane() const { return first_carrier() + carriers_; }
  int marker(int participant) const { return markers_[static_cast<std::size_t>(participant)]; }
  const ContactSurface& surface(int participant) const { return surfaces_[static_cast<std::size_t>(participant)]; }

  // Frames of participants, to be filled before. True: pairs that are near each other have been listed anew.
  std::vector<RigidFrame<double>>& frames() { return frames_; }
  bool follow(Workers* workers);
  const std::vector<std::pair<int, int>>& near() const { return near_; }  // ascending
  // Consecutive pairs: threads share batches, which depend only on the list.
  struct Batch {
    std::size_t begin = 0, end = 0;
    std::vector<ConvexTouch> found, kept;
    std::vector<double> clearances;  // lower bounds of the distances of its pairs
    ConvexPairs pairs;
    ConvexMesh::Scratch in_triangles;
    ConvexNow in_mesh;
  };
  std::vector<Batch>& batches() { return batches_; }
  // All that overlaps of a batch, in ascending order.
  void find(Batch& batch) const;
  // How far those of a pair are from each other that do not touch, or from a plane or triangles; large: nothing is known of it.
  double clearance(std::size_t pair, Batch& batch) const;
  void forget() { at_list_.clear(); }

  const ConvexShape& shape(int thing) const { return shapes_[static_cast<std::size_t>(thing)]; }
  const ConvexNow& now(int thing) const { return now_[static_cast<std::size_t>(thing)]; }
  const RigidFrame<double>& frame(int participant) const { return frames_[static_cast<std::size_t>(participant)]; }

 private:
  double moved() const;
  void list(Workers* workers);

  const ContactSet* set_ = nullptr;
  const std::vector<Triangle>* triangles_ = nullptr;
  const std::vector<Facet>* facets_ = nullptr;
  const std::vector<BoxTree>* trees_ = nullptr;
  int convex_ = 0, balls_ = 0, carriers_ = 0, planes_ = 0;
  std::vector<ConvexShape> shapes_;  // convex shapes and spheres
  std::vector<int> markers_;
  std::vector<ContactSurface> surfaces_;
  std::vector<ConvexMesh> meshes_;
  std::vector<RigidFrame<double>> frames_, at_list_;
  std::vector<ConvexNow> now_;
  std::vector<Batch> batches_;
  SphereNeighbours neighbours_;
  std::vector<std::pair<int, int>> near_;
  std::vector<std::vector<int>> near_triangles_;  // candidate triangles of pairs
  double skin_ = 0;
};

}  // namespace dalembert
