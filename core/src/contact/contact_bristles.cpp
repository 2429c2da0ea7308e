// Bristles of general contact: forces between pairs of spheres, transfer between triangles, and update from step to
// step.
#include <algorithm>
#include <cmath>

#include "meetings.hpp"

namespace dalembert {

namespace {
constexpr double far_from_root = 0.5;       // in radii: the triangle there is another one
constexpr std::size_t numbers_per_bristle = 9;
}  // namespace

// Contacts that a search has found may have got a bristle of their own since.
const Bristle* GeneralContact::bristle_of(const HeldContact& c) const {
  const Bristle* own = bristles_.find(c.sphere, c.other);
  return own != nullptr || c.bristle < 0 ? own : bristles_.find(c.sphere, c.bristle);
}

// A sphere that goes on to another triangle of the same body takes along the bristle of one that it has left.
void GeneralContact::pass_bristles_on(int number, std::vector<Found>& found) const {
  const auto known = bristles_.of(number);
  const int first = set_->first_triangle();
  const auto has = [&](int other) {
    return std::ranges::any_of(found,
                               [&](const Found& f) { return first + f.triangle == other || f.bristle == other; });
  };
  for (Found& f : found)
    if (std::ranges::any_of(known, [&](const BristleList::Entry& entry) { return entry.other == first + f.triangle; }))
      f.bristle = first + f.triangle;
  for (Found& f : found) {
    if (f.bristle >= 0) continue;
    double nearest = far_from_root * sphere(number).radius;
    int left = -1;
    for (const BristleList::Entry& entry : known) {
      if (entry.other < first || triangle(entry.other - first).carrier != triangle(f.triangle).carrier ||
          has(entry.other))
        continue;
      const double distance = norm(entry.bristle.root1 - f.point);
      if (!(distance < nearest)) continue;
      nearest = distance;
      left = entry.other;
    }
    f.bristle = left;
  }
}

// Friction is added to pairs of spheres in the order in which their normal forces were computed.
void GeneralContact::add_gripping_pairs(int number, const Ports& ports) const {
  const Chunk& chunk = chunks_[static_cast<std::size_t>(number)];
  std::size_t pair = pairs_.first_pair(number);
  for (int i = chunk.begin; i < chunk.end; ++i)
    for (const int j : neighbours_.behind(i)) {
      const std::size_t place = pairs_.place_of_second(pair++);
      if (!overlap(i, j)) continue;
      const HeldContact contact{i, j, true, {}, j};
      const ContactPairing pairing = pairing_of(contact);
      if (pairing.friction == 0) continue;
      const Partner first{sphere(i).marker, turns(i)}, second{sphere(j).marker, turns(j)};
      const Meeting<double> at = meet(contact, ports);
      const Vec3<double> velocity = velocity_at(second.marker, second.turns, at.arm1, ports) -
                                    velocity_at(first.marker, first.turns, at.arm0, ports);
      const Grip<double> grip =
          grip_of(bristles_.find(i, j), at, frame_of(first.marker, ports), frame_of(second.marker, ports));
      const Vec3<double> all = gripping_force(pairing, at, velocity, grip), f = all - dot(all, at.normal) * at.normal;
      pairs_.force[static_cast<std::size_t>(i)].add(f);
      pairs_.force[place].add(-f);
      pairs_.moment[static_cast<std::size_t>(i)].add(cross(at.arm0, f));
      pairs_.moment[place].add(-cross(at.arm1, f));
    }
}

// The spring force of a bristle less its limit: negative as long as it sticks.
double GeneralContact::excess_of(const Bristle* bristle, const ContactPairing& pairing, const Meeting<double>& at,
                                 double normal_force, const RigidFrame<double>& frame0,
                                 const RigidFrame<double>& frame1) const {
  const Grip<double> grip = grip_of(bristle, at, frame0, frame1);
  const double stretch = norm(grip.span - dot(at.normal, grip.span) * at.normal);
  return set_->bristles.law(pairing).stiffness * stretch -
         pairing.friction * grip.holding * std::max(0.0, normal_force);
}

// At the end of a step, the length of a bristle is limited by friction, and it is attached on both sides of the
// contact point, so that rolling has no effect. A sliding bristle continues to slide until the slip velocity
// reverses, for any normal force.
Bristle GeneralContact::bristle_after(const Bristle* before, const ContactPairing& pairing, const Meeting<double>& at,
                                      const Vec3<double>& velocity, double normal_force,
                                      const RigidFrame<double>& frame0, const RigidFrame<double>& frame1) const {
  const Grip<double> grip = grip_of(before, at, frame0, frame1);
  const double longest = pairing.friction * grip.holding * normal_force / set_->bristles.law(pairing).stiffness;
  const Vec3<double> stretch = grip.span - dot(at.normal, grip.span) * at.normal, after = at_most(stretch, longest);
  const bool gives_way = dot(stretch, stretch) > longest * longest,
             still_slides = before != nullptr && before->slides && dot(stretch, velocity) > 0;
  return {transposed_times(frame0.rotation, at.arm0 - 0.5 * after),
          transposed_times(frame1.rotation, at.arm1 + 0.5 * after), gives_way || still_slides};
}

void GeneralContact::grow_bristles(const Ports& ports) {
  grown_bristles_.clear();
  grown_ = true;
  grow_convex(ports);
  if (!set_->active || set_->spheres.empty()) return;
  follow(ports);
  each_chunk([&](Chunk& chunk) {
    chunk.grown.clear();
    each_touch(chunk, [&](const HeldContact& c) {
      const ContactPairing pairing = pairing_of(c);
      if (pairing.friction == 0) return;
      const Partner first{sphere(c.sphere).marker, turns(c.sphere)}, second = partner_of(c);
      const Meeting<double> at = meet(c, ports);
      const Vec3<double> velocity = velocity_at(second.marker, second.turns, at.arm1, ports) -
                                    velocity_at(first.marker, first.turns, at.arm0, ports);
      const double normal_force = pairing.normal_force(at.gap, dot(at.normal, velocity));
      if (!(normal_force > 0)) return;
      const RigidFrame<double> frame0 = frame_of(first.marker, ports), frame1 = frame_of(second.marker, ports);
      chunk.grown.push_back(
          {c.sphere, c.other, bristle_after(bristle_of(c), pairing, at, velocity, normal_force, frame0, frame1)});
    });
  });
  for (const Chunk& chunk : chunks_)
    grown_bristles_.insert(grown_bristles_.end(), chunk.grown.begin(), chunk.grown.end());
}

void GeneralContact::keep() {
  if (grown_) {
    bristles_.take(grown_bristles_);
    convex_bristles_.swap(grown_convex_);
  }
  grown_ = false;
}

// Existing contacts get bristles of zero length.
void GeneralContact::begin_history(const Ports& ports) {
  bristles_.clear();
  convex_bristles_.clear();
  grown_ = false;
  if (!set_->bristles.grow()) return;
  grow_bristles(ports);
  keep();
}

void GeneralContact::write_history(std::vector<double>& numbers) const {
  const std::vector<BristleList::Entry>& now = grown_ ? grown_bristles_ : bristles_.all();
  numbers.push_back(static_cast<double>(now.size()));
  for (const BristleList::Entry& entry : now) {
    numbers.insert(numbers.end(), {static_cast<double>(entry.sphere), static_cast<double>(entry.other),
                                   entry.bristle.slides ? 1.0 : 0.0});
    for (const Vec3<double>* root : {&entry.bristle.root0, &entry.bristle.root1})
      numbers.insert(numbers.end(), root->x.begin(), root->x.end());
  }
  write_convex_history(numbers);
}

bool GeneralContact::take_history(std::span<const double>& numbers) {
  if (numbers.empty() || !(numbers[0] >= 0) || numbers[0] > static_cast<double>(numbers.size())) return false;
  const auto count = static_cast<std::size_t>(numbers[0]);
  numbers = numbers.subspan(1);
  if (numbers.size() < numbers_per_bristle * count) return false;
  std::vector<BristleList::Entry> entries;
  const auto things = static_cast<double>(set_->first_triangle()) + static_cast<double>(set_->triangles.size());
  for (std::size_t i = 0; i < count; ++i) {
    const double* x = numbers.data() + numbers_per_bristle * i;
    if (!(x[0] >= 0 && x[0] < x[1] && x[0] < spheres() && x[1] < things)) return false;
    if (!entries.empty() && x[0] < entries.back().sphere) return false;
    entries.push_back(
        {static_cast<int>(x[0]), static_cast<int>(x[1]), {{x[3], x[4], x[5]}, {x[6], x[7], x[8]}, x[2] != 0}});
  }
  numbers = numbers.subspan(numbers_per_bristle * count);
  if (!take_convex_history(numbers)) return false;
  bristles_.take(entries);
  grown_ = false;
  return true;
}

}  // namespace dalembert
