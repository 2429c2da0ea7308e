// Events of general contact: contact begins or ends, friction slides or sticks.
#include <algorithm>
#include <cmath>
#include <limits>

#include "meetings.hpp"

namespace dalembert {

namespace {
constexpr int switches_per_thing = 2;
constexpr int places_along_cable = 16;
constexpr double far_away = 1;  // an arbitrary value
}  // namespace

void GeneralContact::Verge::add(double margin) {
  if (margin < 0) {
    ++touching;
    closed = std::min(closed, -margin);
  } else {
    open = std::min(open, margin);
  }
}

void GeneralContact::Verge::add_slip(double excess) {
  if (excess < 0) ++sticking;
  slip = std::min(slip, std::abs(excess));
}

double GeneralContact::Verge::contact(const Verge& before) const {
  if (touching == before.touching) return std::min({open, closed, far_away});
  return -std::min(touching > before.touching ? closed : open, far_away);
}

double GeneralContact::Verge::friction(const Verge& before) const {
  if (touching != before.touching) return far_away;
  return (sticking == before.sticking ? 1 : -1) * std::min(slip, far_away);
}

// Active contact: the distance is below the sum of the radii, and damping does not exceed the elastic force.
void GeneralContact::add_verge(const HeldContact& c, const Ports& ports, Verge& verge) const {
  const ContactPairing pairing = pairing_of(c);
  const Partner first{sphere(c.sphere).marker, turns(c.sphere)}, second = partner_of(c);
  const Meeting<double> at = meet(c, ports);
  const Vec3<double> velocity =
      velocity_at(second.marker, second.turns, at.arm1, ports) - velocity_at(first.marker, first.turns, at.arm0, ports);
  const double away = dot(at.normal, velocity), elastic = pairing.stiffness * at.gap,
               margin = std::max(elastic, elastic + pairing.damping * away);
  verge.add(margin);
  if (!(margin < 0) || pairing.friction == 0) return;
  if (!set_->bristles.grow()) return verge.add_slip(norm(velocity - away * at.normal) - set_->proportional_zone);
  const Bristle* bristle = bristle_of(c);
  if (bristle == nullptr || !bristle->slides) {
    const RigidFrame<double> frame0 = frame_of(first.marker, ports), frame1 = frame_of(second.marker, ports);
    verge.add_slip(excess_of(bristle, pairing, at, pairing.normal_force(at.gap, away), frame0, frame1));
  }
}

// Triangles that it does not yet contact.
void GeneralContact::add_open_triangles(int number, Verge& verge) const {
  const auto i = static_cast<std::size_t>(number);
  const SphereAt& s = pairs_.at[i];
  for (std::size_t k = first_triangle_[i]; k < first_triangle_[i + 1]; ++k) {
    const int t = near_triangles_[k], c = triangle(t).carrier;
    const Vec3<double> centre = into(carriers_now_[static_cast<std::size_t>(c)], {s.x, s.y, s.z});
    if (!(facets_[static_cast<std::size_t>(t)].height(centre) > 0)) continue;
    const Triangle& corners = local_[static_cast<std::size_t>(t)];
    const double gap = norm(nearest_point(corners, nearest_feature(corners, centre), centre) - centre) - s.radius;
    if (gap >= 0) verge.add(set_->pairing(sphere(number).surface, carrier(c).surface).stiffness * gap);
  }
}

void GeneralContact::add_cables(const Ports& ports, std::vector<Verge>& verges) const {
  if (set_->cables.empty()) return;
  each_cable_near(0.5, [&](int i, int c) {
    const SphereAt& s = pairs_.at[static_cast<std::size_t>(i)];
    const auto number = static_cast<std::size_t>(c);
    double gap = std::numeric_limits<double>::infinity();
    for (int k = 0; k <= places_along_cable; ++k) {
      const Vec<double, 2> place = cables_[number].at(
          cables_[number].weights(cables_[number].length * k / places_along_cable), cables_now_[number].q);
      gap = std::min(gap, std::hypot(place[0] - s.x, place[1] - s.y) - s.radius - set_->cables[number].half_height);
    }
    if (gap >= 0)
      verges[static_cast<std::size_t>(i)].add(set_->pairing(sphere(i).surface, set_->cables[number].surface).stiffness *
                                              gap);
  });
  find_cable_touches(cable_touches_);
  for (const HeldContact& c : cable_touches_) {
    const CableNow& cable = cables_now_[static_cast<std::size_t>(c.other - set_->first_cable())];
    const CableForces<double> forces = cable_forces(c, frame_of(sphere(c.sphere).marker, ports), cable.q, cable.v, {});
    Verge& verge = verges[static_cast<std::size_t>(c.sphere)];
    verge.add(-forces.normal_force);
    if (forces.normal_force > 0 && cable_pairing(c).friction != 0)
      verge.add_slip(forces.slip - set_->proportional_zone);
  }
}

void GeneralContact::find_verges(const Evaluation& e, const Ports& ports, std::vector<Verge>& verges) const {
  verges.assign(set_->spheres.size() + set_->convex.size(), Verge());
  add_convex_verges(ports, verges);
  if (set_->spheres.empty()) return;
  take_cables(e.q, e.v);
  follow(ports);
  for (Chunk& chunk : chunks_) {
    for (int i = chunk.begin; i < chunk.end; ++i) {
      Verge& verge = verges[static_cast<std::size_t>(i)];
      for (const int j : neighbours_.behind(i))
        if (sphere(i).marker != sphere(j).marker) add_verge({i, j}, ports, verge);
    }
    for (const int i : chunk.at_triangles) {
      Verge& verge = verges[static_cast<std::size_t>(i)];
      touching_triangles(i, triangles_near(i), chunk);
      for (const Found& found : chunk.found)
        add_verge({i, set_->first_triangle() + found.triangle, true, {}, found.bristle}, ports, verge);
      add_open_triangles(i, verge);
    }
  }
  add_cables(ports, verges);
}

void GeneralContact::find_switches(const Evaluation& e, const Ports& ports, Switches& switches) const {
  if (!set_->active)
    return switches.none(switches_per_thing * static_cast<int>(set_->spheres.size() + set_->convex.size()));
  find_verges(e, ports, verges_);
  if (verges_before_.empty()) verges_before_ = verges_;
  for (std::size_t i = 0; i < verges_.size(); ++i) {
    switches.of_part(*this, static_cast<int>(i));
    const Verge &now = verges_[i], &before = verges_before_[i];
    switches.holds("contact", now.touching < before.touching, now.contact(before));
    switches.holds("friction", now.sticking > before.sticking, now.friction(before));
  }
}

std::string GeneralContact::name_of_part(int part) const {
  return (part < spheres() ? "sphere " + std::to_string(part) : "convex shape " + std::to_string(part - spheres())) +
         " of " + name_;
}

void GeneralContact::switch_over(const Evaluation& e, const Ports& ports, const double*, double*, double*) {
  keep();  // sticking and sliding states from now on
  if (set_->active) find_verges(e, ports, verges_before_);
}

}  // namespace dalembert
