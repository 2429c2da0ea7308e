// Which things are near each other: lists that are renewed when something has moved farther than the skin.
#include "dalembert/contact/general_contact.hpp"

#include <algorithm>
#include <cmath>

#include "meetings.hpp"

namespace dalembert {

namespace {
constexpr int chunk_size = 1000;
}  // namespace

// Motions of spheres and of what carries triangles, and how far spheres have moved.
void GeneralContact::take_places(const Ports& ports) const {
  const int n = spheres();
  if (chunks_.empty()) {
    const int count = std::clamp(n / chunk_size, 1, 1000);
    chunks_.assign(static_cast<std::size_t>(count), Chunk());
    for (int c = 0; c < count; ++c) {
      chunks_[static_cast<std::size_t>(c)].begin = static_cast<int>(std::int64_t{n} * c / count);
      chunks_[static_cast<std::size_t>(c)].end = static_cast<int>(std::int64_t{n} * (c + 1) / count);
    }
  }
  const bool compares = static_cast<int>(at_list_.size()) == n;
  each_chunk([&](Chunk& chunk) {
    double square = 0;
    for (int number = chunk.begin; number < chunk.end; ++number) {
      const auto i = static_cast<std::size_t>(number);
      const double* x = ports.values.data() + offsets_[i].value;
      SphereAt& at = pairs_.at[i];
      at = {x[0], x[1], x[2], at.radius};
      pairs_.velocity[i] = {x[3], x[4], x[5]};
      if (turns_[i] != 0) {
        const Vec3<double>& spin = reinterpret_cast<const RigidFrame<double>*>(x)->angular_velocity;
        pairs_.spin[i] = {spin[0], spin[1], spin[2]};
      }
      if (!compares) continue;
      const double dx = at.x - at_list_[i].x, dy = at.y - at_list_[i].y, dz = at.z - at_list_[i].z;
      square = std::max(square, dx * dx + dy * dy + dz * dz);
    }
    chunk.moved = square;
  });
  carriers_now_.clear();
  for (const ContactCarrier& c : set_->carriers) carriers_now_.push_back(frame_of(c.marker, ports));
}

void GeneralContact::renew_shapes() const {
  if (shapes_ == set_->shapes) return;
  shapes_ = set_->shapes;
  std::vector<std::vector<int>> of_carrier(set_->carriers.size());
  local_.clear();
  facets_.clear();
  for (std::size_t i = 0; i < set_->triangles.size(); ++i) {
    local_.push_back(set_->triangles[i].points);
    facets_.emplace_back(local_.back());
    of_carrier[static_cast<std::size_t>(set_->triangles[i].carrier)].push_back(static_cast<int>(i));
  }
  trees_.resize(of_carrier.size());
  for (std::size_t c = 0; c < trees_.size(); ++c) trees_[c].build(of_carrier[c], local_);
  pairs_.take(*set_);
  scene_.build(*set_, local_, facets_, trees_);
  at_list_.clear();  // the lists are of other shapes
}

// How much nearer two things may have come since the lists were made.
double GeneralContact::moved() const {
  double square = 0;
  for (const Chunk& chunk : chunks_) square = std::max(square, chunk.moved);
  double carriers = 0;  // no point of a box moves farther than one of its corners
  for (std::size_t c = 0; c < trees_.size(); ++c) {
    if (trees_[c].empty()) continue;
    const RigidFrame<double>&now = carriers_now_[c], &then = carriers_at_list_[c];
    if (now.position == then.position && now.rotation == then.rotation) continue;
    const Box& box = trees_[c].box();
    for (int k = 0; k < 8; ++k) {
      const Vec3<double> corner{(k & 1 ? box.upper : box.lower)[0], (k & 2 ? box.upper : box.lower)[1], (k & 4 ? box.upper : box.lower)[2]};
      carriers = std::max(carriers, norm(out_of(now, corner) - out_of(then, corner)));
    }
  }
  const double spheres = std::sqrt(square);
  return spheres + std::max(spheres, carriers);
}

void GeneralContact::follow(const Ports& ports) const {
  renew_shapes();
  take_places(ports);
  const bool known = at_list_.size() == pairs_.at.size();
  const double distance = known ? moved() : 0;
  if (distance > 0) ++since_list_;  // of other states: to ask twice changes nothing
  if (known && distance <= skin_) return;
  renew_lists();
}

// The skin grows until lists last for some twenty evaluations, and shrinks where they last much longer.
void GeneralContact::renew_lists() const {
  const AlignedVector<SphereAt>& at = pairs_.at;
  const std::size_t n = at.size();
  double mean = 0;
  for (const SphereAt& s : at) mean += s.radius / static_cast<double>(n);
  if (skin_ == 0) skin_ = 0.1 * mean;
  else if (since_list_ < 20) skin_ = std::min(1.5 * skin_, 0.5 * mean);
  else if (since_list_ > 80) skin_ = std::max(0.7 * skin_, 0.01 * mean);
  since_list_ = 0;
  ++lists_;
  at_list_.assign(at.begin(), at.end());
  carriers_at_list_ = carriers_now_;
  if (set_->spheres_touch) neighbours_.build(at, skin_, workers_);
  else neighbours_.clear(n);
  std::vector<int> begins{0};
  for (const Chunk& chunk : chunks_) begins.push_back(chunk.end);
  pairs_.list(neighbours_, begins);
  each_chunk([&](Chunk& chunk) { list_triangles(chunk); });
  first_triangle_.assign(1, 0);
  near_triangles_.clear();
  for (const Chunk& chunk : chunks_) {
    for (const std::size_t end : chunk.ends) first_triangle_.push_back(near_triangles_.size() + end);
    near_triangles_.insert(near_triangles_.end(), chunk.near_triangles.begin(), chunk.near_triangles.end());
  }
}

void GeneralContact::list_triangles(Chunk& chunk) const {
  std::vector<int>& near = chunk.near_triangles;
  near.clear();
  chunk.ends.clear();
  chunk.at_triangles.clear();
  for (int i = chunk.begin; i < chunk.end; ++i) {
    const SphereAt& s = pairs_.at[static_cast<std::size_t>(i)];
    const std::size_t first = near.size();
    for (std::size_t c = 0; c < trees_.size(); ++c) {
      if (trees_[c].empty()) continue;
      const Vec3<double> centre = into(carriers_at_list_[c], {s.x, s.y, s.z});
      const double reach = s.radius + skin_;
      trees_[c].each_near(centre, reach, [&](int t) {
        const Vec3<double> nearest = nearest_point(local_[static_cast<std::size_t>(t)], nearest_feature(local_[static_cast<std::size_t>(t)], centre), centre);
        if (dot(nearest - centre, nearest - centre) <= reach * reach) near.push_back(t);
      });
    }
    std::sort(near.begin() + static_cast<std::ptrdiff_t>(first), near.end());
    chunk.ends.push_back(near.size());
    if (near.size() > first) chunk.at_triangles.push_back(i);
  }
}

}  // namespace dalembert
