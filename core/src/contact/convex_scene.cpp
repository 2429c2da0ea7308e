#include "dalembert/contact/convex_scene.hpp"

#include <algorithm>
#include <cmath>

namespace dalembert {
namespace {

constexpr double skin_part = 0.1;  // relative to the mean radius
constexpr std::size_t pairs_in_batch = 16, most_batches = 1000, shapes_to_share = 64;

ConvexShape ball_shape(double radius) {
  ConvexDefinition ball{ConvexKind::ball, {Vec3<double>{}}, {}, radius};
  return make_shape(ball);
}

Vec3<double> out(const RigidFrame<double>& frame, const Vec3<double>& point) {
  return frame.position + frame.rotation * point;
}

// Pose of a frame relative to another one.
RigidFrame<double> seen_from(const RigidFrame<double>& base, const RigidFrame<double>& frame) {
  return {transposed_times(base.rotation, frame.position - base.position),
          {},
          transpose(base.rotation) * frame.rotation,
          {}};
}

}  // namespace

void ConvexScene::build(const ContactSet& set, const std::vector<Triangle>& triangles, const std::vector<Facet>& facets,
                        const std::vector<BoxTree>& trees) {
  set_ = &set;
  triangles_ = &triangles;
  facets_ = &facets;
  trees_ = &trees;
  convex_ = static_cast<int>(set.convex.size());
  balls_ = convex_ == 0 && set.planes.empty() ? 0 : static_cast<int>(set.spheres.size());
  carriers_ = static_cast<int>(set.carriers.size());
  planes_ = static_cast<int>(set.planes.size());
  shapes_.clear();
  markers_.clear();
  surfaces_.clear();
  at_list_.clear();
  const auto take = [&](int marker, const ContactSurface& surface) {
    markers_.push_back(marker);
    surfaces_.push_back(surface);
  };
  for (const ContactConvex& c : set.convex) {
    shapes_.push_back(make_shape(c.definition));
    take(c.marker, c.surface);
  }
  for (int i = 0; i < balls_; ++i) {
    shapes_.push_back(ball_shape(set.spheres[static_cast<std::size_t>(i)].radius));
    take(set.spheres[static_cast<std::size_t>(i)].marker, set.spheres[static_cast<std::size_t>(i)].surface);
  }
  for (const ContactCarrier& c : set.carriers) take(c.marker, c.surface);
  for (const ContactPlane& p : set.planes) take(p.marker, p.surface);
  now_.resize(shapes_.size());
  skin_ = 0;
  for (const ConvexShape& shape : shapes_) skin_ += skin_part * shape.bound / static_cast<double>(shapes_.size());
  meshes_.assign(convex_ == 0 ? 0 : set.carriers.size(), ConvexMesh());
  std::vector<std::vector<int>> members(meshes_.size());
  for (std::size_t t = 0; t < set.triangles.size() && !meshes_.empty(); ++t)
    members[static_cast<std::size_t>(set.triangles[t].carrier)].push_back(static_cast<int>(t));
  for (std::size_t c = 0; c < meshes_.size(); ++c) meshes_[c].build(members[c], triangles, facets);
}

// Upper bound of the approach of two entities: no point of a ball moves farther than its center, none of a mesh
// farther than a corner of its box.
double ConvexScene::moved() const {
  double things = 0, carriers = 0;
  for (std::size_t i = 0; i < shapes_.size(); ++i)
    things = std::max(things, norm(out(frames_[i], shapes_[i].centre) - out(at_list_[i], shapes_[i].centre)));
  for (std::size_t c = 0; c < meshes_.size(); ++c) {
    if ((*trees_)[c].empty()) continue;
    const std::size_t i = c + static_cast<std::size_t>(first_carrier());
    if (frames_[i].position == at_list_[i].position && frames_[i].rotation == at_list_[i].rotation) continue;
    const Box& box = (*trees_)[c].box();
    for (int k = 0; k < 8; ++k) {
      const Vec3<double> corner{(k & 1 ? box.upper : box.lower)[0], (k & 2 ? box.upper : box.lower)[1],
                                (k & 4 ? box.upper : box.lower)[2]};
      carriers = std::max(carriers, norm(out(frames_[i], corner) - out(at_list_[i], corner)));
    }
  }
  return things + std::max(things, carriers);
}

bool ConvexScene::follow(Workers* workers) {
  const auto place = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) now_[i].place(shapes_[i], frames_[i]);
  };
  if (workers != nullptr && shapes_.size() >= shapes_to_share)
    workers->each_stretch(shapes_.size(), place);
  else
    place(0, shapes_.size());
  if (at_list_.size() == frames_.size() && moved() <= skin_) return false;
  list(workers);
  return true;
}

// Things of one marker do not touch each other: neither would feel anything of it.
void ConvexScene::list(Workers* workers) {
  at_list_ = frames_;
  near_.clear();
  std::vector<SphereAt> balls;
  for (const ConvexNow& now : now_) balls.push_back({now.centre[0], now.centre[1], now.centre[2], now.shape->bound});
  if (convex_ > 0) {
    neighbours_.build(balls, skin_, workers);
    for (int i = 0; i < convex_; ++i)
      for (const int k : neighbours_.behind(i))
        if (marker(i) != marker(k)) near_.emplace_back(i, k);
  }
  std::vector<std::pair<std::pair<int, int>, std::vector<int>>> of_meshes;
  for (int i = 0; i < convex_; ++i)
    for (int c = 0; c < static_cast<int>(meshes_.size()); ++c) {
      const BoxTree& tree = (*trees_)[static_cast<std::size_t>(c)];
      const int carrier = first_carrier() + c;
      if (tree.empty() || marker(i) == marker(carrier)) continue;
      const RigidFrame<double>& frame = frames_[static_cast<std::size_t>(carrier)];
      std::vector<int> found;
      tree.each_near(transposed_times(frame.rotation, now(i).centre - frame.position), now(i).shape->bound + skin_,
                     [&](int t) { found.push_back(t); });
      std::ranges::sort(found);
      if (!found.empty()) of_meshes.push_back({{i, carrier}, found});
    }
  for (const auto& [pair, triangles] : of_meshes) near_.push_back(pair);
  for (int i = 0; i < first_carrier(); ++i)
    for (int p = first_plane(); p < participants(); ++p)
      if (marker(i) != marker(p)) near_.emplace_back(i, p);
  std::ranges::sort(near_);
  near_triangles_.assign(near_.size(), {});
  for (const auto& [pair, triangles] : of_meshes)
    near_triangles_[static_cast<std::size_t>(std::ranges::lower_bound(near_, pair) - near_.begin())] = triangles;
  batches_.resize(std::clamp<std::size_t>(near_.size() / pairs_in_batch, 1, most_batches));
  for (std::size_t b = 0; b < batches_.size(); ++b) {
    batches_[b].begin = near_.size() * b / batches_.size();
    batches_[b].end = near_.size() * (b + 1) / batches_.size();
  }
}

void ConvexScene::find(Batch& batch) const {
  std::vector<ConvexTouch>& found = batch.found;
  found.clear();
  for (std::size_t k = batch.begin; k < batch.end; ++k) {
    const auto [first, second] = near_[k];
    const std::size_t begin = found.size();
    if (second >= first_plane()) {
      const ContactPlane& plane = set_->planes[static_cast<std::size_t>(second - first_plane())];
      batch.pairs.with_plane(now(first), frame(second).rotation * plane.normal, out(frame(second), plane.point),
                             frame(second), found);
    } else if (second >= first_carrier()) {
      batch.in_mesh.place(shapes_[static_cast<std::size_t>(first)], seen_from(frame(second), frame(first)));
      meshes_[static_cast<std::size_t>(second - first_carrier())].find(batch.in_mesh, near_triangles_[k], *triangles_,
                                                                       *facets_, batch.in_triangles, found);
    } else {
      batch.pairs.between(now(first), now(second), found);
    }
    for (std::size_t i = begin; i < found.size(); ++i) {
      found[i].first = first;
      found[i].second = second;
    }
    std::sort(found.begin() + static_cast<std::ptrdiff_t>(begin), found.end(),
              [](const ConvexTouch& a, const ConvexTouch& b) { return a.key < b.key; });
  }
}

double ConvexScene::clearance(std::size_t pair, Batch& batch) const {
  const auto [first, second] = near_[pair];
  if (second >= first_plane()) {
    const ContactPlane& plane = set_->planes[static_cast<std::size_t>(second - first_plane())];
    return batch.pairs.clearance(now(first), frame(second).rotation * plane.normal, out(frame(second), plane.point));
  }
  if (second < first_carrier()) return batch.pairs.clearance(now(first), now(second));
  batch.in_mesh.place(shapes_[static_cast<std::size_t>(first)], seen_from(frame(second), frame(first)));
  return ConvexMesh::clearance(batch.in_mesh, near_triangles_[pair], *facets_, batch.in_triangles);
}

}  // namespace dalembert
