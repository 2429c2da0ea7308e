// Bristles of places where convex shapes touch. A place that begins takes over the bristle of the nearest one of its pair that has ended.
#include <algorithm>
#include <cmath>

#include "meetings.hpp"

namespace dalembert {

namespace {
constexpr double far_from_convex_root = 0.5;  // relative to the bounding sphere of the shape
constexpr std::size_t numbers_per_convex_bristle = 10;
}  // namespace

const GeneralContact::ConvexBristle* GeneralContact::convex_bristle(const ConvexTouch& t, std::int64_t key) const {
  const std::tuple order(t.first, t.second, key);
  const auto found = std::ranges::lower_bound(convex_bristles_, order, {}, &ConvexBristle::order);
  return found != convex_bristles_.end() && found->order() == order ? &*found : nullptr;
}

const Bristle* GeneralContact::bristle_of(const ConvexTouch& t) const {
  const ConvexBristle* own = convex_bristle(t, t.key);
  if (own == nullptr && t.bristle >= 0) own = convex_bristle(t, t.bristle);
  return own == nullptr ? nullptr : &own->bristle;
}

// Nearest pairs of places and bristles first.
void GeneralContact::pass_bristles_on(std::span<ConvexTouch> of_pair) const {
  const ConvexTouch& any = of_pair.front();
  const auto pair = [](const ConvexBristle& b) { return std::pair(b.first, b.second); };
  const auto known = std::ranges::equal_range(convex_bristles_, std::pair(any.first, any.second), {}, pair);
  if (known.empty()) return;
  const RigidFrame<double>&frame0 = scene_.frame(any.first), &frame1 = scene_.frame(any.second);
  const auto is_taken = [&](std::int64_t key) {
    return std::ranges::any_of(of_pair, [&](const ConvexTouch& t) { return t.key == key || t.bristle == key; });
  };
  for (std::size_t turn = 0; turn < of_pair.size(); ++turn) {
    double nearest = far_from_convex_root * scene_.now(any.first).shape->bound;
    ConvexTouch* heir = nullptr;
    std::int64_t left = -1;
    for (ConvexTouch& t : of_pair) {
      if (t.bristle >= 0 || convex_bristle(t, t.key) != nullptr) continue;
      const Vec3<double> place = transposed_times(frame1.rotation, meeting_of(t, frame0, frame1).arm1);
      for (const ConvexBristle& b : known) {
        const double distance = norm(b.bristle.root1 - place);
        if (!(distance < nearest) || is_taken(b.key)) continue;
        nearest = distance;
        heir = &t;
        left = b.key;
      }
    }
    if (heir == nullptr) return;
    heir->bristle = left;
  }
}

void GeneralContact::grow_convex(const Ports& ports) {
  grown_convex_.clear();
  find_convex(ports, convex_found_, Places::pushing);
  for (const ConvexTouch& t : convex_found_) {
    const ContactPairing pairing = convex_pairing(t);
    if (pairing.friction == 0) continue;
    const RigidFrame<double>&frame0 = scene_.frame(t.first), &frame1 = scene_.frame(t.second);
    const Meeting<double> at = meeting_of(t, frame0, frame1);
    const Vec3<double> velocity = relative_velocity(frame0, frame1, at);
    const double normal_force = pairing.normal_force(at.gap, dot(at.normal, velocity));
    if (normal_force > 0)
      grown_convex_.push_back({t.first, t.second, t.key,
                               bristle_after(bristle_of(t), pairing, at, velocity, normal_force, frame0, frame1)});
  }
}

void GeneralContact::write_convex_history(std::vector<double>& numbers) const {
  if (scene_.empty()) return;
  const std::vector<ConvexBristle>& now = grown_ ? grown_convex_ : convex_bristles_;
  numbers.push_back(static_cast<double>(now.size()));
  for (const ConvexBristle& b : now) {
    numbers.insert(numbers.end(), {static_cast<double>(b.first), static_cast<double>(b.second),
                                   static_cast<double>(b.key), b.bristle.slides ? 1.0 : 0.0});
    for (const Vec3<double>* root : {&b.bristle.root0, &b.bristle.root1})
      numbers.insert(numbers.end(), root->x.begin(), root->x.end());
  }
}

bool GeneralContact::take_convex_history(std::span<const double>& numbers) {
  convex_bristles_.clear();
  if (scene_.empty()) return true;
  if (numbers.empty() || !(numbers[0] >= 0) || numbers[0] > static_cast<double>(numbers.size())) return false;
  const auto count = static_cast<std::size_t>(numbers[0]);
  numbers = numbers.subspan(1);
  if (numbers.size() < numbers_per_convex_bristle * count) return false;
  std::vector<ConvexBristle> taken;
  for (std::size_t i = 0; i < count; ++i) {
    const double* x = numbers.data() + numbers_per_convex_bristle * i;
    if (!(x[0] >= 0 && x[0] < x[1] && x[1] < scene_.participants() && x[2] >= 0 &&
          x[2] < static_cast<double>(convex_keys::end)))
      return false;
    taken.push_back({static_cast<int>(x[0]),
                     static_cast<int>(x[1]),
                     static_cast<std::int64_t>(x[2]),
                     {{x[4], x[5], x[6]}, {x[7], x[8], x[9]}, x[3] != 0}});
    if (taken.size() > 1 && !(taken[taken.size() - 2].order() < taken.back().order())) return false;
  }
  numbers = numbers.subspan(numbers_per_convex_bristle * count);
  convex_bristles_ = std::move(taken);
  return true;
}

}  // namespace dalembert
