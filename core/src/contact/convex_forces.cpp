// Forces of convex shapes and planes: each place where they touch has its part of the stiffness of the pair.
#include <algorithm>
#include <cmath>

#include "meetings.hpp"

namespace dalembert {

ContactPairing GeneralContact::convex_pairing(const ConvexTouch& t) const { return set_->pairing(scene_.surface(t.first), scene_.surface(t.second)).part(t.share); }

void GeneralContact::follow_convex(const Ports& ports) const {
  renew_shapes();
  std::vector<RigidFrame<double>>& frames = scene_.frames();
  frames.clear();
  for (int i = 0; i < scene_.participants(); ++i) frames.push_back(frame_of(scene_.marker(i), ports));
  if (scene_.follow()) ++convex_lists_;
}

// Those that push.
void GeneralContact::find_convex(const Ports& ports, std::vector<ConvexTouch>& found) const {
  found.clear();
  renew_shapes();
  if (!has_convex()) return;
  follow_convex(ports);
  scene_.find(found);
  if (!convex_bristles_.empty())
    for (auto begin = found.begin(); begin != found.end();) {
      const auto end = std::find_if(begin, found.end(), [&](const ConvexTouch& t) { return t.first != begin->first || t.second != begin->second; });
      pass_bristles_on({begin, end});
      begin = end;
    }
  std::erase_if(found, [&](ConvexTouch& t) {
    const RigidFrame<double>&frame0 = scene_.frame(t.first), &frame1 = scene_.frame(t.second);
    const Meeting<double> at = meeting_of(t, frame0, frame1);
    const Vec3<double> velocity = relative_velocity(frame0, frame1, at);
    const double away = dot(at.normal, velocity);
    const ContactPairing pairing = convex_pairing(t);
    t.sticks = pairing.friction == 0 || norm(velocity - away * at.normal) < set_->proportional_zone;
    if (set_->bristles.grow()) {
      const Bristle* bristle = bristle_of(t);
      t.sticks = pairing.friction == 0 || bristle == nullptr || !bristle->slides;
    }
    return !(pairing.pressure(at.gap, away) > 0);
  });
}

void GeneralContact::add_convex(const ConvexTouch& t, Ports& ports, std::optional<bool> sticks) const {
  const int marker0 = scene_.marker(t.first), marker1 = scene_.marker(t.second);
  const RigidFrame<double> frame0 = frame_of(marker0, ports), frame1 = frame_of(marker1, ports);
  const Meeting<double> at = meeting_of(t, frame0, frame1);
  const Vec3<double> velocity = relative_velocity(frame0, frame1, at);
  const Vec3<double> f = convex_force(t, at, velocity, frame0, frame1, sticks);
  const auto push = [&](int marker, const Vec3<double>& force, const Vec3<double>& moment) {
    double* to = ports.force(marker);
    add_vector(to, 1.0, force);
    if (has_rotation(ports, marker)) add_vector(to + 3, 1.0, moment);
  };
  push(marker0, f, cross(at.arm0, f));
  push(marker1, -f, -cross(at.arm1, f));
}

int GeneralContact::global_number(int participant) const {
  if (participant >= scene_.first_plane()) return set_->first_plane() + participant - scene_.first_plane();
  if (participant >= scene_.first_carrier()) {
    const auto& all = set_->triangles;
    return set_->first_triangle() + static_cast<int>(std::ranges::find(all, participant - scene_.first_carrier(), &ContactTriangle::carrier) - all.begin());
  }
  return participant >= scene_.first_ball() ? participant - scene_.first_ball() : set_->first_convex() + participant;
}

std::vector<GeneralContact::ConvexPlace> GeneralContact::convex_places(const Ports& ports) {
  find_convex(ports, convex_found_);
  std::vector<ConvexPlace> places;
  for (const ConvexTouch& t : convex_found_) {
    const RigidFrame<double>&frame0 = scene_.frame(t.first), &frame1 = scene_.frame(t.second);
    const Meeting<double> at = meeting_of(t, frame0, frame1);
    const Vec3<double> velocity = relative_velocity(frame0, frame1, at);
    places.push_back({global_number(t.first), global_number(t.second), frame0.position + at.arm0, at.normal, convex_force(t, at, velocity, frame0, frame1, {}), at.gap, t.share});
  }
  return places;
}

std::vector<GeneralContact::ConvexPair> GeneralContact::convex_pairs() const {
  std::vector<ConvexPair> pairs;
  for (const ConvexTouch& t : convex_touching_) {
    const int first = global_number(t.first), second = global_number(t.second);
    if (pairs.empty() || pairs.back().first != first || pairs.back().second != second) pairs.push_back({first, second, true});
    pairs.back().sticks = pairs.back().sticks && t.sticks;
  }
  return pairs;
}

// Of all pairs that are near each other.
std::size_t GeneralContact::list_convex_blocks(const Ports& ports, std::size_t slot) {
  convex_blocks_.clear();
  if (scene_.empty()) return slot;
  for (const auto& [first, second] : scene_.near()) {
    convex_blocks_.push_back({first, second, slot});
    const auto count = [&](int participant) { return static_cast<std::size_t>(ports.ports[static_cast<std::size_t>(scene_.marker(participant))].n); };
    const std::size_t total = count(first) + count(second);
    slot += total * total;
  }
  return slot;
}

void GeneralContact::add_convex_tangent(const Ports& ports, double* values) const {
  for (const ConvexTouch& t : convex_held_) {
    const auto block = std::ranges::lower_bound(convex_blocks_, std::pair(t.first, t.second), {}, [](const ConvexBlock& b) { return std::pair(b.first, b.second); });
    const int marker0 = scene_.marker(t.first), marker1 = scene_.marker(t.second);
    const Columns<2> columns(ports, {marker0, marker1});
    const int* slot = slots.data() + block->first_slot;
    for (int first = 0; first < columns.total; first += sweep_width) {
      const RigidFrame<SweepDual> m0 = moving_frame(ports, marker0, columns.offset[0], first), m1 = moving_frame(ports, marker1, columns.offset[1], first);
      const Meeting<SweepDual> at = meeting_of(t, m0, m1);
      const Vec3<SweepDual> velocity = relative_velocity(m0, m1, at);
      const Vec3<SweepDual> f = convex_force(t, at, velocity, m0, m1, t.sticks);
      scatter(ports, marker0, columns.offset[0], columns.total, first, {f, cross(at.arm0, f)}, slot, values);
      scatter(ports, marker1, columns.offset[1], columns.total, first, {-f, -cross(at.arm1, f)}, slot, values);
    }
  }
}

// How many places have begun or ended to push.
double GeneralContact::convex_changes() const {
  std::size_t common = 0;
  for (std::size_t i = 0, j = 0; i < convex_touching_.size() && j < convex_held_.size();) {
    const auto a = convex_touching_[i].order(), b = convex_held_[j].order();
    common += a == b ? 1 : 0;
    i += a <= b ? 1 : 0;
    j += b <= a ? 1 : 0;
  }
  return static_cast<double>(convex_touching_.size() + convex_held_.size() - 2 * common);
}

}  // namespace dalembert
