// Forces of convex shapes and planes: each place where they touch has its part of the stiffness of the pair.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "meetings.hpp"

namespace dalembert {

namespace {
constexpr std::size_t touches_to_share = 64;
}  // namespace

ContactPairing GeneralContact::convex_pairing(const ConvexTouch& t) const {
  return set_->pairing(scene_.surface(t.first), scene_.surface(t.second)).part(t.share);
}

void GeneralContact::follow_convex(const Ports& ports) const {
  renew_shapes();
  std::vector<RigidFrame<double>>& frames = scene_.frames();
  frames.clear();
  for (int i = 0; i < scene_.participants(); ++i) frames.push_back(frame_of(scene_.marker(i), ports));
  if (scene_.follow(workers_)) ++convex_lists_;
}

template <class F>
void GeneralContact::each_convex_batch(const F& f) const {
  std::vector<ConvexScene::Batch>& batches = scene_.batches();
  const int count = static_cast<int>(batches.size());
  if (workers_ != nullptr && count > 1) {
    workers_->run(count, [&](int b) { f(batches[static_cast<std::size_t>(b)]); });
  } else {
    for (ConvexScene::Batch& batch : batches) f(batch);
  }
}

void GeneralContact::find_convex(const Ports& ports, std::vector<ConvexTouch>& found, Places which) const {
  found.clear();
  renew_shapes();
  if (!has_convex()) return;
  follow_convex(ports);
  each_convex_batch([&](ConvexScene::Batch& batch) {
    find_overlaps(batch);
    for (ConvexTouch& t : batch.found) find_state(t);
    const auto pair_presses = [&](const ConvexTouch& t) {
      return t.second < scene_.first_carrier() &&
             std::ranges::any_of(
                 batch.found,
                 [&](const ConvexTouch& o) { return o.first == t.first && o.second == t.second && o.presses; });
    };
    std::vector<ConvexTouch>& kept = batch.kept;
    kept.clear();
    std::ranges::copy_if(batch.found, std::back_inserter(kept), [&](const ConvexTouch& t) {
      return t.presses || (which == Places::of_pushing_pairs && pair_presses(t));
    });
  });
  for (const ConvexScene::Batch& batch : scene_.batches())
    found.insert(found.end(), batch.kept.begin(), batch.kept.end());
}

// Assigns the existing bristles.
void GeneralContact::find_overlaps(ConvexScene::Batch& batch) const {
  scene_.find(batch);
  std::vector<ConvexTouch>& found = batch.found;
  if (convex_bristles_.empty()) return;
  for (auto begin = found.begin(); begin != found.end();) {
    const auto end = std::find_if(
        begin, found.end(), [&](const ConvexTouch& t) { return t.first != begin->first || t.second != begin->second; });
    pass_bristles_on({begin, end});
    begin = end;
  }
}

// Computes whether the contact pushes, and whether it sticks.
void GeneralContact::find_state(ConvexTouch& t) const {
  const RigidFrame<double>&frame0 = scene_.frame(t.first), &frame1 = scene_.frame(t.second);
  const Meeting<double> at = meeting_of(t, frame0, frame1);
  const Vec3<double> velocity = relative_velocity(frame0, frame1, at);
  const double away = dot(at.normal, velocity);
  const ContactPairing pairing = convex_pairing(t);
  t.sticks = pairing.friction == 0 || in_zone(norm(velocity - away * at.normal), set_->proportional_zone);
  if (set_->bristles.grow()) {
    const Bristle* bristle = bristle_of(t);
    t.sticks = pairing.friction == 0 || bristle == nullptr || !bristle->slides;
  }
  t.presses = pairing.normal_force(at.gap, away) > 0;
}

// Forces of all are found side by side, and added in their order.
void GeneralContact::add_convex(std::span<const ConvexTouch> touches, Ports& ports, bool direct) const {
  convex_pushes_.resize(touches.size());
  const auto find = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const ConvexTouch& t = touches[i];
      const RigidFrame<double> frame0 = frame_of(scene_.marker(t.first), ports),
                               frame1 = frame_of(scene_.marker(t.second), ports);
      const Meeting<double> at = meeting_of(t, frame0, frame1);
      const Vec3<double> velocity = relative_velocity(frame0, frame1, at);
      const Vec3<double> f = convex_force(t, at, velocity, frame0, frame1, direct ? std::optional<bool>() : t.sticks);
      convex_pushes_[i] = {f, cross(at.arm0, f), -cross(at.arm1, f)};
    }
  };
  if (workers_ != nullptr && touches.size() >= touches_to_share)
    workers_->each_stretch(touches.size(), find);
  else
    find(0, touches.size());
  const auto push = [&](int marker, const Vec3<double>& force, const Vec3<double>& moment) {
    double* to = ports.force(marker);
    add_vector(to, 1.0, force);
    if (has_rotation(ports, marker)) add_vector(to + 3, 1.0, moment);
  };
  for (std::size_t i = 0; i < touches.size(); ++i) {
    const ConvexPush& p = convex_pushes_[i];
    push(scene_.marker(touches[i].first), p.force, p.moment0);
    push(scene_.marker(touches[i].second), -p.force, p.moment1);
  }
}

int GeneralContact::global_number(int participant) const {
  if (participant >= scene_.first_plane()) return set_->first_plane() + participant - scene_.first_plane();
  if (participant >= scene_.first_carrier()) {
    const auto& all = set_->triangles;
    return set_->first_triangle() +
           static_cast<int>(std::ranges::find(all, participant - scene_.first_carrier(), &ContactTriangle::carrier) -
                            all.begin());
  }
  return participant >= scene_.first_ball() ? participant - scene_.first_ball() : set_->first_convex() + participant;
}

std::vector<GeneralContact::ConvexPlace> GeneralContact::convex_places(const Ports& ports) {
  find_convex(ports, convex_found_, Places::pushing);
  std::vector<ConvexPlace> places;
  for (const ConvexTouch& t : convex_found_) {
    const RigidFrame<double>&frame0 = scene_.frame(t.first), &frame1 = scene_.frame(t.second);
    const Meeting<double> at = meeting_of(t, frame0, frame1);
    const Vec3<double> velocity = relative_velocity(frame0, frame1, at);
    places.push_back({global_number(t.first), global_number(t.second), frame0.position + at.arm0, at.normal,
                      convex_force(t, at, velocity, frame0, frame1, {}), at.gap, t.share});
  }
  return places;
}

std::vector<GeneralContact::ConvexPair> GeneralContact::convex_pairs() const {
  std::vector<ConvexPair> pairs;
  for (const ConvexTouch& t : convex_touching_) {
    if (!t.presses) continue;
    const int first = global_number(t.first), second = global_number(t.second);
    if (pairs.empty() || pairs.back().first != first || pairs.back().second != second)
      pairs.push_back({first, second, true});
    pairs.back().sticks = pairs.back().sticks && t.sticks;
  }
  return pairs;
}

// Lists the blocks of all neighbouring pairs.
std::size_t GeneralContact::list_convex_blocks(const Ports& ports, std::size_t slot) {
  convex_blocks_.clear();
  if (scene_.empty()) return slot;
  for (const auto& [first, second] : scene_.near()) {
    convex_blocks_.push_back({first, second, slot});
    const auto count = [&](int participant) {
      return static_cast<std::size_t>(ports.ports[static_cast<std::size_t>(scene_.marker(participant))].n);
    };
    const std::size_t total = count(first) + count(second);
    slot += total * total;
  }
  return slot;
}

void GeneralContact::add_convex_tangent(const Ports& ports, double* values) const {
  for (const ConvexTouch& t : convex_held_) {
    const auto block = std::ranges::lower_bound(convex_blocks_, std::pair(t.first, t.second), {},
                                                [](const ConvexBlock& b) { return std::pair(b.first, b.second); });
    const int marker0 = scene_.marker(t.first), marker1 = scene_.marker(t.second);
    const Columns<2> columns(ports, {marker0, marker1});
    const int* slot = slots.data() + block->first_slot;
    for (int first = 0; first < columns.total; first += sweep_width) {
      const RigidFrame<SweepDual> m0 = moving_frame(ports, marker0, columns.offset[0], first),
                                  m1 = moving_frame(ports, marker1, columns.offset[1], first);
      const Meeting<SweepDual> at = meeting_of(t, m0, m1);
      const Vec3<SweepDual> velocity = relative_velocity(m0, m1, at);
      const Vec3<SweepDual> f = convex_force(t, at, velocity, m0, m1, t.sticks);
      scatter(ports, marker0, columns.offset[0], columns.total, first, {f, cross(at.arm0, f)}, slot, values);
      scatter(ports, marker1, columns.offset[1], columns.total, first, {-f, -cross(at.arm1, f)}, slot, values);
    }
  }
}

// Contact points on a plane and on triangles begin and end separately. Contact of two shapes has one event for the
// pair: points of parallel faces appear and disappear during rotation, but their forces do not jump.
void GeneralContact::add_convex_verges(const Ports& ports, std::vector<Verge>& verges) const {
  if (!has_convex()) return;
  follow_convex(ports);
  const auto& near = scene_.near();
  const auto is_single = [this](int second) { return second >= scene_.first_carrier(); };
  each_convex_batch([&](ConvexScene::Batch& batch) {
    find_overlaps(batch);
    batch.clearances.clear();
    auto touch = batch.found.begin();
    for (std::size_t pair = batch.begin; pair < batch.end; ++pair) {
      const auto begin = touch;
      while (touch != batch.found.end() && std::pair(touch->first, touch->second) == near[pair]) ++touch;
      const bool is_open = touch == begin || is_single(near[pair].second);
      batch.clearances.push_back(is_open ? scene_.clearance(pair, batch) : std::numeric_limits<double>::infinity());
    }
  });
  for (const ConvexScene::Batch& batch : scene_.batches()) {
    auto touch = batch.found.begin();
    for (std::size_t pair = batch.begin; pair < batch.end; ++pair) {
      const auto [first, second] = near[pair];
      const ContactPairing whole = set_->pairing(scene_.surface(first), scene_.surface(second));
      const int owner = first < scene_.first_ball() ? spheres() + first : first - scene_.first_ball();
      Verge& verge = verges[static_cast<std::size_t>(owner)];
      double deepest = std::numeric_limits<double>::infinity(), freest = -deepest;
      bool slides = false;
      const bool single = is_single(second);
      for (; touch != batch.found.end() && touch->first == first && touch->second == second; ++touch) {
        const RigidFrame<double>&frame0 = scene_.frame(first), &frame1 = scene_.frame(second);
        const Meeting<double> at = meeting_of(*touch, frame0, frame1);
        const Vec3<double> velocity = relative_velocity(frame0, frame1, at);
        const double away = dot(at.normal, velocity), elastic = whole.stiffness * at.gap,
                     margin = std::max(elastic, elastic + whole.damping * away);
        deepest = std::min(deepest, margin);
        if (single) verge.add(margin);
        if (!(margin < 0) || whole.friction == 0 || touch->share == 0) continue;
        double excess = norm(velocity - away * at.normal) - set_->proportional_zone;
        if (set_->bristles.grow()) {
          const Bristle* bristle = bristle_of(*touch);
          slides = slides || (bristle != nullptr && bristle->slides);
          if (bristle != nullptr && bristle->slides) continue;
          const ContactPairing pairing = whole.part(touch->share);
          excess = excess_of(bristle, pairing, at, pairing.normal_force(at.gap, away), frame0, frame1);
        }
        freest = std::max(freest, excess);
        if (single) verge.add_slip(excess);
      }
      if (!single && std::isfinite(deepest)) {
        verge.add(deepest);
        if (!slides && std::isfinite(freest)) verge.add_slip(freest);
      }
      if (const double clearance = batch.clearances[pair - batch.begin]; std::isfinite(clearance))
        verge.add(whole.stiffness * clearance);
    }
  }
}

// Places that have begun or ended to push. Places of two shapes share a force that does not jump while the pair touches.
GeneralContact::Changes GeneralContact::convex_changes() const {
  Changes changes;
  const auto change = [&](const ConvexTouch& t, const std::vector<ConvexTouch>& others) {
    ++changes.count;
    const auto pair = [](const ConvexTouch& o) { return std::pair(o.first, o.second); };
    const auto other = std::ranges::lower_bound(others, pair(t), {}, pair);
    const bool shares = t.second < scene_.first_carrier() && other != others.end() && pair(*other) == pair(t);
    if (!shares)
      changes.force =
          std::max(changes.force, convex_pairing(t).stiffness *
                                      std::abs(meeting_of(t, scene_.frame(t.first), scene_.frame(t.second)).gap));
  };
  auto now = convex_touching_.begin(), held = convex_held_.begin();
  while (now != convex_touching_.end() || held != convex_held_.end()) {
    const bool begins = held == convex_held_.end() || (now != convex_touching_.end() && now->order() < held->order());
    const bool ends = now == convex_touching_.end() || (held != convex_held_.end() && held->order() < now->order());
    if (begins) change(*now, convex_held_);
    if (ends) change(*held, convex_touching_);
    if (!ends) ++now;
    if (!begins) ++held;
  }
  return changes;
}

}  // namespace dalembert
