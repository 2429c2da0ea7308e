// Which things are near each other: lists that are renewed when something has moved farther than the skin.
#include "dalembert/contact/general_contact.hpp"

#include <algorithm>
#include <cmath>

#include "meetings.hpp"

namespace dalembert {

namespace {
constexpr int chunk_size = 1000;
}  // namespace

void GeneralContact::take_places(const Ports& ports) const {
  const int n = spheres();
  if (static_cast<int>(at_.size()) != n || chunks_.empty()) {
    at_.resize(static_cast<std::size_t>(n));
    const int count = shares_markers_ ? 1 : std::clamp(n / chunk_size, 1, 1000);
    chunks_.assign(static_cast<std::size_t>(count), Chunk());
    for (int c = 0; c < count; ++c) {
      chunks_[static_cast<std::size_t>(c)].begin = static_cast<int>(std::int64_t{n} * c / count);
      chunks_[static_cast<std::size_t>(c)].end = static_cast<int>(std::int64_t{n} * (c + 1) / count);
    }
  }
  each_chunk([&](const Chunk& chunk) {
    for (int i = chunk.begin; i < chunk.end; ++i) {
      const ContactSphere& s = sphere(i);
      const double* x = ports.frame(s.marker);
      at_[static_cast<std::size_t>(i)] = {x[0], x[1], x[2], s.radius};
    }
  });
}

void GeneralContact::renew_shapes() const {
  if (shapes_ == set_->shapes) return;
  shapes_ = set_->shapes;
  std::vector<std::vector<int>> of_carrier(set_->carriers.size());
  local_.clear();
  for (std::size_t i = 0; i < set_->triangles.size(); ++i) {
    local_.push_back(set_->triangles[i].points);
    of_carrier[static_cast<std::size_t>(set_->triangles[i].carrier)].push_back(static_cast<int>(i));
  }
  trees_.resize(of_carrier.size());
  for (std::size_t c = 0; c < trees_.size(); ++c) trees_[c].build(of_carrier[c], local_);
  at_list_.clear();  // the lists are of other shapes
}

// How much nearer two things may have come since the lists were made.
double GeneralContact::moved(const Ports& ports) const {
  double square = 0;
  for (std::size_t i = 0; i < at_.size(); ++i) {
    const double dx = at_[i].x - at_list_[i].x, dy = at_[i].y - at_list_[i].y, dz = at_[i].z - at_list_[i].z;
    square = std::max(square, dx * dx + dy * dy + dz * dz);
  }
  double carriers = 0;  // no point of a box moves farther than one of its corners
  for (std::size_t c = 0; c < trees_.size(); ++c) {
    if (trees_[c].empty()) continue;
    const RigidFrame<double> now = frame_of(set_->carriers[c].marker, ports);
    const RigidFrame<double>& then = carriers_at_list_[c];
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
  ++since_list_;
  if (at_list_.size() == at_.size() && moved(ports) <= skin_) return;
  renew_lists(ports);
}

// The skin grows until lists last for some twenty evaluations, and shrinks where they last much longer.
void GeneralContact::renew_lists(const Ports& ports) const {
  const std::size_t n = at_.size();
  double mean = 0;
  for (const SphereAt& s : at_) mean += s.radius / static_cast<double>(n);
  if (skin_ == 0) skin_ = 0.1 * mean;
  else if (since_list_ < 20) skin_ = std::min(1.5 * skin_, 0.5 * mean);
  else if (since_list_ > 80) skin_ = std::max(0.7 * skin_, 0.01 * mean);
  since_list_ = 0;
  ++lists_;
  at_list_ = at_;
  carriers_at_list_.clear();
  for (const ContactCarrier& c : set_->carriers) carriers_at_list_.push_back(frame_of(c.marker, ports));
  if (set_->spheres_touch) neighbours_.build(at_, skin_);
  else neighbours_.clear(n);
  first_triangle_.assign(1, 0);
  near_triangles_.clear();
  for (const SphereAt& s : at_) {
    const std::size_t first = near_triangles_.size();
    for (std::size_t c = 0; c < trees_.size(); ++c) {
      if (trees_[c].empty()) continue;
      const Vec3<double> centre = into(carriers_at_list_[c], {s.x, s.y, s.z});
      const double reach = s.radius + skin_;
      trees_[c].each_near(centre, reach, [&](int t) {
        const Vec3<double> nearest = nearest_point(local_[static_cast<std::size_t>(t)], nearest_feature(local_[static_cast<std::size_t>(t)], centre), centre);
        if (dot(nearest - centre, nearest - centre) <= reach * reach) near_triangles_.push_back(t);
      });
    }
    std::sort(near_triangles_.begin() + static_cast<std::ptrdiff_t>(first), near_triangles_.end());
    first_triangle_.push_back(near_triangles_.size());
  }
}

}  // namespace dalembert
