// Neighbour lists, which are rebuilt when a displacement exceeds the skin.
#include "dalembert/contact/general_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dalembert/math/wide_registers.hpp"
#include "meetings.hpp"

namespace dalembert {

namespace {
// A chunk must be large enough for a thread. Large chunks have fewer pairs across chunks, but must fit into a cache.
constexpr int smallest_chunk = 1000, largest_chunk = 4000, some_threads = 16;
constexpr double farthest = 1 + 1e-9;  // relative to the reach of a plane: larger distances exclude contact
// displacement to or from positions that are not finite
constexpr double unknown = std::numeric_limits<double>::infinity();

PointFrame<double> frame_at(const Evaluation& e, int dof) {
  return {load<double, 3>(e.reference + dof) + load<double, 3>(e.u + dof), load<double, 3>(e.v + dof)};
}

}  // namespace

// Motions of spheres and of carriers of triangles, and displacements of spheres.
void GeneralContact::take_places(const Ports& ports, const Evaluation* nodes) const {
  const int n = spheres();
  if (chunks_.empty()) {
    const int size = std::clamp(n / some_threads, smallest_chunk, largest_chunk), count = std::clamp(n / size, 1, 1000);
    chunks_.assign(static_cast<std::size_t>(count), Chunk());
    for (int c = 0; c < count; ++c) {
      chunks_[static_cast<std::size_t>(c)].begin = static_cast<int>(std::int64_t{n} * c / count);
      chunks_[static_cast<std::size_t>(c)].end = static_cast<int>(std::int64_t{n} * (c + 1) / count);
    }
  }
  each_chunk([&](Chunk& chunk) {
    double square = 0;
    for (int number = chunk.begin; number < chunk.end; ++number) {
      const auto i = static_cast<std::size_t>(number);
      const NodeFrame node = nodes != nullptr ? at_nodes_[i] : NodeFrame();
      const double* const port = ports.values.data() + offsets_[i].value;
      const auto [x, v] = node.dof >= 0 ? frame_at(*nodes, node.dof) : read_frame<PointPort>(port);
      SphereAt& at = pairs_.at[i];
      const double dx = x[0] - at.x, dy = x[1] - at.y, dz = x[2] - at.z;
      const double way = dx * dx + dy * dy + dz * dz;
      if (!(way <= square)) square = way < unknown ? way : unknown;
      at = {x[0], x[1], x[2], at.radius};
      pairs_.velocity[i] = {v[0], v[1], v[2], 0};
      if (turns_[i] != 0) {
        const Vec3<double>& spin =
            node.dof >= 0 ? ports.node_motions[static_cast<std::size_t>(node.rotating_node)].angular_velocity
                          : read_frame<RigidPort>(port).angular_velocity;
        pairs_.spin[i] = {spin[0], spin[1], spin[2], 0};
      }
    }
    chunk.moved += std::sqrt(square);
  });
  carriers_now_.clear();
  carriers_rest_.clear();
  for (const ContactCarrier& c : set_->carriers) {
    carriers_now_.push_back(frame_of(c.marker, ports));
    carriers_rest_.push_back(ports.ports[static_cast<std::size_t>(c.marker)].n == 0 ? 1 : 0);
  }
}

void GeneralContact::renew_shapes() const {
  if (shapes_ == set_->shapes) return;
  shapes_ = set_->shapes;
  std::vector<std::vector<int>> of_carrier(set_->carriers.size());
  std::vector<Box> boxes;
  local_.clear();
  facets_.clear();
  carriers_of_triangles_.clear();
  for (std::size_t i = 0; i < set_->triangles.size(); ++i) {
    local_.push_back(set_->triangles[i].points);
    boxes.emplace_back();
    for (const Vec3<double>& point : local_.back()) boxes.back().add(point);
    facets_.emplace_back(local_.back());
    carriers_of_triangles_.push_back(set_->triangles[i].carrier);
    of_carrier[static_cast<std::size_t>(set_->triangles[i].carrier)].push_back(static_cast<int>(i));
  }
  trees_.resize(of_carrier.size());
  for (std::size_t c = 0; c < trees_.size(); ++c) trees_[c].build(of_carrier[c], boxes);
  pairs_.take(*set_);
  scene_.build(*set_, local_, facets_, trees_);
  at_list_.clear();  // the lists are of other shapes
  lines_ = {};
}

// How far spheres have moved since the lists were made.
double GeneralContact::moved_by_spheres() const {
  each_chunk([&](Chunk& chunk) {
    double square = 0;
    for (auto i = static_cast<std::size_t>(chunk.begin); i < static_cast<std::size_t>(chunk.end); ++i) {
      const double dx = pairs_.at[i].x - at_list_[i].x, dy = pairs_.at[i].y - at_list_[i].y,
                   dz = pairs_.at[i].z - at_list_[i].z;
      square = std::max(square, dx * dx + dy * dy + dz * dz);
    }
    chunk.moved = std::sqrt(square);
  });
  double moved = 0;
  for (const Chunk& chunk : chunks_) moved = std::max(moved, chunk.moved);
  return moved;
}

// Upper bound of the approach of two entities since the lists were made. Sums of sphere displacements overestimate
// it: exact displacements are computed only if the sum is too large.
double GeneralContact::moved() const {
  double carriers = 0;  // no point of a box moves farther than one of its corners
  for (std::size_t c = 0; c < trees_.size(); ++c) {
    if (trees_[c].empty()) continue;
    const RigidFrame<double>&now = carriers_now_[c], &then = carriers_at_list_[c];
    if (now.position == then.position && now.rotation == then.rotation) continue;
    const Box& box = trees_[c].box();
    for (int k = 0; k < 8; ++k) {
      const Vec3<double> corner{(k & 1 ? box.upper : box.lower)[0], (k & 2 ? box.upper : box.lower)[1],
                                (k & 4 ? box.upper : box.lower)[2]};
      carriers = std::max(carriers, norm(out_of(now, corner) - out_of(then, corner)));
    }
  }
  double spheres = 0;
  for (const Chunk& chunk : chunks_) spheres = std::max(spheres, chunk.moved);
  const auto nearer = [&] { return spheres + std::max(spheres, carriers); };
  if (nearer() > skin_) spheres = moved_by_spheres();
  return nearer();
}

void GeneralContact::follow(const Ports& ports, const Evaluation* nodes) const {
  renew_shapes();
  take_places(ports, nodes);
  const bool known = at_list_.size() == pairs_.at.size();
  const double distance = known ? moved() : 0;
  if (distance > 0) ++since_list_;  // only for other states: a repeated query changes nothing
  if (known && distance <= skin_) return;
  renew_lists();
}

// The skin grows until lists last for some forty evaluations, and shrinks where they last much longer.
void GeneralContact::renew_lists() const {
  const AlignedVector<SphereAt>& at = pairs_.at;
  const std::size_t n = at.size();
  double mean = 0;
  for (const SphereAt& s : at) mean += s.radius / static_cast<double>(n);
  if (skin_ == 0)
    skin_ = 0.2 * mean;
  else if (since_list_ < 40)
    skin_ = std::min(1.5 * skin_, 0.5 * mean);
  else if (since_list_ > 160)
    skin_ = std::max(0.7 * skin_, 0.01 * mean);
  since_list_ = 0;
  ++lists_;
  carriers_at_list_ = carriers_now_;
  if (set_->spheres_touch)
    neighbours_.build(at, skin_, workers_);
  else
    neighbours_.clear(n);
  std::vector<int> begins{0};
  for (const Chunk& chunk : chunks_) begins.push_back(chunk.end);
  pairs_.list(neighbours_, begins, workers_);
  at_list_.resize(n);
  each_chunk([&](Chunk& chunk) {
    chunk.moved = 0;
    std::copy(at.begin() + chunk.begin, at.begin() + chunk.end, at_list_.begin() + chunk.begin);
    list_triangles(chunk);
  });
  join_triangle_lists();
}

// Sphere by sphere.
void GeneralContact::join_triangle_lists() const {
  std::size_t pairs = 0;
  for (Chunk& chunk : chunks_) {
    chunk.first_near = pairs;
    pairs += chunk.near_triangles.size();
  }
  near_triangles_.resize(pairs);
  near_spheres_.resize(pairs);
  first_triangle_.resize(at_list_.size() + 1);
  first_triangle_.back() = pairs;
  each_chunk([&](const Chunk& chunk) {
    std::size_t begin = 0;
    for (std::size_t k = 0; k < chunk.ends.size(); ++k) {
      first_triangle_[static_cast<std::size_t>(chunk.begin) + k] = chunk.first_near + begin;
      for (std::size_t t = begin; t < chunk.ends[k]; ++t) {
        near_triangles_[chunk.first_near + t] = chunk.near_triangles[t];
        near_spheres_[chunk.first_near + t] = chunk.begin + static_cast<int>(k);
      }
      begin = chunk.ends[k];
    }
  });
}

// Four spheres at once: most are far from all triangles.
void GeneralContact::list_triangles(Chunk& chunk) const {
  std::vector<int>& near = chunk.near_triangles;
  std::array<std::vector<int>, 4> of_lane;
  near.clear();
  chunk.ends.clear();
  chunk.at_triangles.clear();
  for (int first = chunk.begin; first < chunk.end; first += 4) {
    const int count = std::min(4, chunk.end - first);
    in_registers_of_four([&, this] { find_near_triangles(first, count, of_lane.data()); });
    for (int lane = 0; lane < count; ++lane) {
      std::vector<int>& triangles = of_lane[static_cast<std::size_t>(lane)];
      std::ranges::sort(triangles);
      near.insert(near.end(), triangles.begin(), triangles.end());
      chunk.ends.push_back(near.size());
      if (!triangles.empty()) chunk.at_triangles.push_back(first + lane);
      triangles.clear();
    }
  }
}

DALEMBERT_INLINE inline void GeneralContact::find_near_triangles(int first, int count,
                                                                 std::vector<int>* of_lane) const {
  using P = Pack<4>;
  const auto sphere_of = [&](int lane) DALEMBERT_INLINE {
    return &pairs_.at[static_cast<std::size_t>(first + std::min(lane, count - 1))].x;
  };
  const std::array<P, 4> at = gather_fours<4>({sphere_of(0), sphere_of(1), sphere_of(2), sphere_of(3)});
  const P reach = at[3] + skin_, far = farthest * reach;
  for (std::size_t c = 0; c < trees_.size(); ++c) {
    if (trees_[c].empty()) continue;
    const Vec3<P> centres = into(carriers_at_list_[c], Vec3<P>{at[0], at[1], at[2]});
    trees_[c].each_near(centres, reach, [&](int t) DALEMBERT_INLINE {
      const P height = magnitude(facets_[static_cast<std::size_t>(t)].height(centres));
      if (is_zero(P(height.x <= far.x ? 1.0 - P::Register{} : P::Register{}))) return;
      const Triangle& corners = local_[static_cast<std::size_t>(t)];
      for (int lane = 0; lane < count; ++lane) {
        if (height[lane] > far[lane]) continue;
        const Vec3<double> centre{centres[0][lane], centres[1][lane], centres[2][lane]};
        const Vec3<double> span = nearest_point(corners, nearest_feature(corners, centre), centre) - centre;
        if (dot(span, span) <= reach[lane] * reach[lane]) of_lane[lane].push_back(t);
      }
    });
  }
}

}  // namespace dalembert
