// Detection of active contacts among neighbours, and the fixed contacts of implicit solvers.
#include "dalembert/contact/general_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dalembert/model/errors.hpp"
#include "meetings.hpp"

namespace dalembert {

// Faces that a sphere penetrates, and edges and corners if no adjacent triangle has a nearer point. Triangles have
// contact on their positive side only. Coinciding points count once: at an inner edge of a smooth surface, for one of
// its triangles.
void GeneralContact::find_triangles(int number, std::span<const int> near, Chunk& chunk) const {
  std::vector<Found>& found = chunk.found;
  found.clear();
  const SphereAt& s = pairs_.at[static_cast<std::size_t>(number)];
  const double least = set_->nearest_relative_distance * s.radius;
  int known = -1;
  Vec3<double> centre;
  for (const int t : near) {
    const int carrier = triangle(t).carrier;
    if (carrier != known) {
      centre = into(carriers_now_[static_cast<std::size_t>(carrier)], {s.x, s.y, s.z});
      known = carrier;
    }
    const Facet& facet = facets_[static_cast<std::size_t>(t)];
    const double height = facet.height(centre);
    if (!(height > 0) || height > s.radius) continue;
    const double within = facet.within_edges(centre);
    if (within < 0 && within * within + height * height > s.radius * s.radius) continue;
    Found one{t, 0, centre - height * facet.normal, -facet.normal, height};
    if (!(within > 0)) {
      const Triangle& corners = local_[static_cast<std::size_t>(t)];
      const TriangleFeature feature = nearest_feature(corners, centre);
      if (!feature.is_face()) {
        one.rank = feature.is_edge() ? 1 : 2;
        one.point = nearest_point(corners, feature, centre);
        one.normal = one.point - centre;
        one.distance = norm(one.normal);
        one.normal = (1 / one.distance) * one.normal;
      }
    }
    if (one.distance < s.radius && one.distance > 0 && one.distance >= least) found.push_back(one);
  }
  if (found.size() < 2) return;
  const double same = same_point * s.radius;
  const auto is_kept = [&](const Found& a) {
    for (const Found& b : found) {
      if (b.triangle == a.triangle || triangle(b.triangle).carrier != triangle(a.triangle).carrier) continue;
      const bool is_same = norm(b.point - a.point) <= same;
      if (is_same && (b.rank < a.rank || (b.rank == a.rank && b.triangle < a.triangle))) return false;
      if (is_same || a.rank == 0) continue;
      const Triangle& corners = local_[static_cast<std::size_t>(b.triangle)];
      const Vec3<double> on_b = nearest_point(corners, nearest_feature(corners, a.point), a.point);
      if (norm(on_b - a.point) <= same) return false;  // the other has a point that is nearer
    }
    return true;
  };
  chunk.kept.clear();
  for (const Found& a : found)
    if (is_kept(a)) chunk.kept.push_back(a);
  found.swap(chunk.kept);
}

void GeneralContact::touching_triangles(int number, std::span<const int> near, Chunk& chunk) const {
  find_triangles(number, near, chunk);
  if (!bristles_.empty()) pass_bristles_on(number, chunk.found);
}

// Spheres of one marker do not touch: neither would feel anything of it.
bool GeneralContact::overlap(int i, int j) const {
  const SphereAt &a = pairs_.at[static_cast<std::size_t>(i)], &b = pairs_.at[static_cast<std::size_t>(j)];
  const double dx = b.x - a.x, dy = b.y - a.y, dz = b.z - a.z, reach = a.radius + b.radius,
               square = dx * dx + dy * dy + dz * dz;
  if (square > 0) [[likely]]
    return square < reach * reach;
  if (sphere(i).marker != sphere(j).marker) refuse_same_centre(i, j);
  return false;
}

void GeneralContact::refuse_same_centre(int i, int j) const {
  const auto named = [&](int number) {
    return std::to_string(number) + " (marker " + std::to_string(sphere(number).marker) + ")";
  };
  refuse(ErrorKind::value, {name_, "",
                            "spheres " + named(i) + " and " + named(j) +
                                " have one and the same centre, so that their contact has no direction",
                            "", "", "Place one of them elsewhere; spheres at one marker do not touch each other"});
}

// Whether it pushes, and how it slips.
bool GeneralContact::touches(const HeldContact& c, const Ports& ports, bool& sticks) const {
  const ContactPairing pairing = pairing_of(c);
  const Partner first{sphere(c.sphere).marker, turns(c.sphere)}, second = partner_of(c);
  const Meeting<double> at = meet(c, ports);
  const Vec3<double> velocity =
      velocity_at(second.marker, second.turns, at.arm1, ports) - velocity_at(first.marker, first.turns, at.arm0, ports);
  const double away = dot(at.normal, velocity);
  const double normal_force = pairing.normal_force(at.gap, away);
  if (set_->bristles.grow()) {
    const Bristle* bristle = bristle_of(c);
    sticks = pairing.friction == 0 || bristle == nullptr || !bristle->slides;
  } else {
    sticks = pairing.friction == 0 || in_zone(norm(velocity - away * at.normal), set_->proportional_zone);
  }
  return normal_force > 0;
}

void GeneralContact::find(const Ports& ports, std::vector<HeldContact>& found) const {
  found.clear();
  if (!set_->active || set_->spheres.empty()) return;
  follow(ports);
  for (Chunk& chunk : chunks_)
    each_touch(chunk, [&](HeldContact c) {
      if (touches(c, ports, c.sticks)) found.push_back(c);
    });
  if (set_->cables.empty()) return;
  find_cable_touches(cable_touches_);
  for (HeldContact c : cable_touches_) {
    const CableNow& cable = cables_now_[static_cast<std::size_t>(c.other - set_->first_cable())];
    const CableForces<double> forces = cable_forces(c, frame_of(sphere(c.sphere).marker, ports), cable.q, cable.v, {});
    c.sticks = in_zone(forces.slip, set_->proportional_zone);
    if (forces.normal_force > 0) found.push_back(c);
  }
  std::ranges::sort(found, {}, [](const HeldContact& c) { return std::tuple(c.sphere, c.other, c.along.begin); });
}

void GeneralContact::update(const Ports& ports) {
  take_cables_of_system();
  find(ports, touching_);
  find_convex(ports, convex_touching_, Places::of_pushing_pairs);
}

bool GeneralContact::search(const Evaluation& e, const Ports& ports) {
  take_cables(e.q, e.v);
  find(ports, touching_);
  held_ = touching_;
  find_convex(ports, convex_touching_, Places::of_pushing_pairs);
  convex_held_ = convex_touching_;
  // Pairs of spheres and cables stay in the pattern once they have been near.
  const std::size_t before = cables_in_blocks_.size();
  each_cable_near(0.5, [&](int i, int c) {
    const auto place = std::ranges::lower_bound(cables_in_blocks_, std::pair(i, c));
    if (place == cables_in_blocks_.end() || *place != std::pair(i, c)) cables_in_blocks_.insert(place, {i, c});
  });
  if (blocks_of_list_ == lists_ + convex_lists_ && cables_in_blocks_.size() == before) return false;
  blocks_of_list_ = lists_ + convex_lists_;
  list_blocks(ports);
  return true;
}

bool GeneralContact::forget() {
  const bool knows = blocks_of_list_ != 0;
  at_list_.clear();
  skin_ = 0;
  since_list_ = 0;
  blocks_of_list_ = 0;
  blocks_.clear();
  held_.clear();
  cables_in_blocks_.clear();
  scene_.forget();
  convex_blocks_.clear();
  convex_held_.clear();
  return knows;
}

void GeneralContact::list_blocks(const Ports& ports) {
  using With = Block::With;
  blocks_.clear();
  std::size_t slot = 0;
  const auto count = [&](int marker) {
    return static_cast<std::size_t>(ports.ports[static_cast<std::size_t>(marker)].n);
  };
  const auto add = [&](int i, With with, int number, int marker1) {
    blocks_.push_back({i, marker1, with, number, slot});
    const std::size_t total = count(sphere(i).marker) + (with == With::cable ? 8 : count(marker1));
    slot += total * total;
  };
  std::vector<int> carriers;
  auto cable = cables_in_blocks_.begin();
  for (int i = 0; i < spheres(); ++i) {
    for (const int j : neighbours_.behind(i)) add(i, With::sphere, j, sphere(j).marker);
    for (; cable != cables_in_blocks_.end() && cable->first == i; ++cable) add(i, With::cable, cable->second, -1);
    carriers.clear();
    for (const int t : triangles_near(i)) carriers.push_back(triangle(t).carrier);
    std::ranges::sort(carriers);
    carriers.erase(std::unique(carriers.begin(), carriers.end()), carriers.end());
    for (const int c : carriers) add(i, With::carrier, c, carrier(c).marker);
  }
  list_convex_blocks(ports, slot);
}

const GeneralContact::Block& GeneralContact::block_of(const HeldContact& c) const {
  using With = Block::With;
  const bool of_spheres = c.other < spheres();
  const With with = of_spheres ? With::sphere : is_cable(c) ? With::cable : With::carrier;
  const int number = of_spheres    ? c.other
                     : is_cable(c) ? c.other - set_->first_cable()
                                   : triangle(c.other - set_->first_triangle()).carrier;
  return *std::ranges::lower_bound(blocks_, std::tuple(c.sphere, with, number), {}, &Block::key);
}

// Also where it would pull.
double GeneralContact::elastic_force(const HeldContact& c, const Ports& ports) const {
  if (!is_cable(c)) return pairing_of(c).stiffness * std::abs(meet(c, ports).gap);
  const CableNow& cable = cables_now_[static_cast<std::size_t>(c.other - set_->first_cable())];
  return std::abs(cable_forces(c, frame_of(sphere(c.sphere).marker, ports), cable.q, cable.v, {}).normal_force);
}

// The error is the number of contacts that have begun or ended, or the largest of their forces if that is more; the next search fixes the
// active contacts.
PostNewton GeneralContact::post_newton(const Evaluation& e, const Ports& ports, const double*, double*, double*) {
  if (set_->bristles.grow()) grow_bristles(ports);
  if (e.direct) return {};
  take_cables(e.q, e.v);
  find(ports, touching_);
  const std::vector<HeldContact>& now = touching_;
  find_convex(ports, convex_touching_, Places::of_pushing_pairs);
  Changes changes = convex_changes();
  const auto change = [&](const HeldContact& c) {
    ++changes.count;
    changes.force = std::max(changes.force, elastic_force(c, ports));
  };
  for (std::size_t i = 0, j = 0; i < now.size() || j < held_.size();) {
    const auto key = [](const std::vector<HeldContact>& all, std::size_t k) {
      return k < all.size() ? std::pair(all[k].sphere, all[k].other) : std::pair(std::numeric_limits<int>::max(), 0);
    };
    const auto a = key(now, i), b = key(held_, j);
    if (a < b) change(now[i]);
    if (b < a) change(held_[j]);
    i += a <= b ? 1 : 0;
    j += b <= a ? 1 : 0;
  }
  return {.error = std::max(changes.count, changes.force)};
}

}  // namespace dalembert
