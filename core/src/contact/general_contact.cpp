// Forces of what touches, and their tangent.
#include "dalembert/contact/general_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "meetings.hpp"

namespace dalembert {

GeneralContact::GeneralContact(std::shared_ptr<const ContactSet> set, const Ports& ports) : set_(std::move(set)) {
  for (const ContactSphere& s : set_->spheres) {
    markers_.push_back(s.marker);
    turns_.push_back(has_rotation(ports, s.marker) ? 1 : 0);
  }
  std::vector<int> sorted = markers_;
  std::ranges::sort(sorted);
  shares_markers_ = std::ranges::adjacent_find(sorted) != sorted.end();
  for (const ContactCarrier& c : set_->carriers) markers_.push_back(c.marker);
}

RigidFrame<double> GeneralContact::frame_of(int marker, const Ports& ports) const {
  return has_rotation(ports, marker) ? read_frame<RigidPort>(ports, marker) : turned_never(read_frame<PointPort>(ports, marker));
}

ContactPairing GeneralContact::pairing_of(const HeldContact& c) const {
  const ContactSurface& other = c.other < spheres() ? sphere(c.other).surface : carrier(triangle(c.other - set_->first_triangle()).carrier).surface;
  return set_->pairing(sphere(c.sphere).surface, other);
}

GeneralContact::Partner GeneralContact::partner_of(const HeldContact& c) const {
  if (c.other < spheres()) return {sphere(c.other).marker, turns(c.other)};
  return {carrier(triangle(c.other - set_->first_triangle()).carrier).marker, true};
}

GeneralContact::Meeting<double> GeneralContact::meet(const HeldContact& c, const Ports& ports) const {
  const Vec3<double>& p0 = read_frame<PointPort>(ports, sphere(c.sphere).marker).position;
  const int marker1 = partner_of(c).marker;
  if (c.other < spheres()) return meet_sphere(c.sphere, c.other, p0, read_frame<PointPort>(ports, marker1).position);
  return meet_triangle(c.sphere, c.other - set_->first_triangle(), p0, read_frame<RigidPort>(ports, marker1));
}

Vec3<double> GeneralContact::velocity_at(int marker, bool turns, const Vec3<double>& arm, const Ports& ports) const {
  const Vec3<double>& velocity = read_frame<PointPort>(ports, marker).velocity;  // frames of rigid bodies begin with those of points
  return turns ? velocity + cross(read_frame<RigidPort>(ports, marker).angular_velocity, arm) : velocity;
}

void GeneralContact::add_contact(const HeldContact& c, Ports& ports, std::optional<bool> sticks, Chunk& chunk) const {
  const Partner first{sphere(c.sphere).marker, turns(c.sphere)}, second = partner_of(c);
  const Meeting<double> at = meet(c, ports);
  const Vec3<double> velocity = velocity_at(second.marker, second.turns, at.arm1, ports) - velocity_at(first.marker, first.turns, at.arm0, ports);
  const Vec3<double> f = force(pairing_of(c), at, velocity, sticks);
  const auto push = [&](const Partner& on, const Vec3<double>& force, const Vec3<double>& moment) {
    double* to = ports.force(on.marker);
    add_vector(to, 1.0, force);
    if (on.turns) add_vector(to + 3, 1.0, moment);
  };
  push(first, f, cross(at.arm0, f));
  if (c.other < chunk.end) push(second, -f, -cross(at.arm1, f));
  else chunk.far.push_back({second.marker, second.turns, -f, -cross(at.arm1, f)});
}

// The same for spheres behind one of them, by what is at hand: without friction, neither spin nor moments play a part.
void GeneralContact::add_pairs_without_friction(int i, Ports& ports, Chunk& chunk) const {
  const SphereAt a = at_[static_cast<std::size_t>(i)];
  const ContactSphere& first = sphere(i);
  const Vec3<double>& v0 = read_frame<PointPort>(ports, first.marker).velocity;
  Vec3<double> sum;
  for (const int j : neighbours_.behind(i)) {
    const SphereAt& b = at_[static_cast<std::size_t>(j)];
    const double dx = b.x - a.x, dy = b.y - a.y, dz = b.z - a.z, reach = a.radius + b.radius, square = dx * dx + dy * dy + dz * dz;
    if (!(square < reach * reach) || square == 0) continue;
    const ContactSphere& second = sphere(j);
    const Vec3<double>& v1 = read_frame<PointPort>(ports, second.marker).velocity;
    const double distance = std::sqrt(square), inverse = 1 / distance;
    const double away = inverse * (dx * (v1[0] - v0[0]) + dy * (v1[1] - v0[1]) + dz * (v1[2] - v0[2]));
    const ContactPairing pairing = set_->pairing(first.surface, second.surface);
    const double pressure = pairing.stiffness * (reach - distance) - pairing.damping * away;
    if (!(pressure > 0)) continue;
    const double factor = pressure * inverse;
    const Vec3<double> f{factor * dx, factor * dy, factor * dz};
    sum -= f;
    if (j < chunk.end) add_vector(ports.force(second.marker), 1.0, f);
    else chunk.far.push_back({second.marker, false, f, {}});
  }
  add_vector(ports.force(first.marker), 1.0, sum);
}

void GeneralContact::residual(const Evaluation& e, Ports& ports, double* r) const {
  if (!set_->active || set_->spheres.empty()) return;
  take_cables(e.q, e.v);
  if (!e.direct) {
    Chunk all{.begin = 0, .end = std::numeric_limits<int>::max(), .far = {}, .found = {}, .kept = {}};
    for (const HeldContact& c : held_) is_cable(c) ? add_cable(c, ports, c.sticks, r) : add_contact(c, ports, c.sticks, all);
    return;
  }
  follow(ports);
  const bool slides = std::ranges::all_of(set_->friction, [](double mu) { return mu == 0; });
  each_chunk([&](Chunk& chunk) {
    chunk.far.clear();
    for (int i = chunk.begin; slides && i < chunk.end; ++i) {
      add_pairs_without_friction(i, ports, chunk);
      touching_triangles(i, ports, chunk);
      for (const Found& found : chunk.found) add_contact({i, set_->first_triangle() + found.triangle}, ports, {}, chunk);
    }
    if (!slides) each_touch(ports, chunk, [&](const HeldContact& c) { add_contact(c, ports, {}, chunk); });
  });
  for (const Chunk& chunk : chunks_)
    for (const Chunk::Far& far : chunk.far) {
      double* to = ports.force(far.marker);
      add_vector(to, 1.0, far.force);
      if (far.turns) add_vector(to + 3, 1.0, far.moment);
    }
  find_cable_touches(cable_touches_);
  for (const HeldContact& c : cable_touches_) add_cable(c, ports, {}, r);
}

void GeneralContact::visit(BlockVisitor& visitor, const Ports& ports) const {
  for (const Block& block : blocks_) {
    std::vector<int> dofs;
    const auto add = [&](std::span<const int> some) { dofs.insert(dofs.end(), some.begin(), some.end()); };
    add(ports.marker_dofs(sphere(block.sphere).marker));
    if (block.with == Block::With::cable) add(cables_[static_cast<std::size_t>(block.number)].dofs);
    else add(ports.marker_dofs(block.marker1));
    visitor.block(dofs, dofs);
  }
}

void GeneralContact::tangent(const Evaluation&, const Weights& weights, Ports& ports, double* values) const {
  if (!set_->active) return;
  for (const HeldContact& c : held_) {
    const Block& block = block_of(c);
    if (is_cable(c)) {
      add_cable_tangent(c, block, weights, ports, values);
      continue;
    }
    const bool of_spheres = c.other < spheres();
    const int marker0 = sphere(c.sphere).marker, marker1 = block.marker1;
    const ContactPairing pairing = pairing_of(c);
    const Columns<2> columns(ports, {marker0, marker1});
    const int* slot = slots.data() + block.first_slot;
    for (int first = 0; first < columns.total; first += sweep_width) {
      const RigidFrame<SweepDual> m0 = moving_frame(ports, marker0, columns.offset[0], first), m1 = moving_frame(ports, marker1, columns.offset[1], first);
      const Meeting<SweepDual> at = of_spheres ? meet_sphere(c.sphere, c.other, m0.position, m1.position) : meet_triangle(c.sphere, c.other - set_->first_triangle(), m0.position, m1);
      const Vec3<SweepDual> velocity = m1.velocity + cross(m1.angular_velocity, at.arm1) - m0.velocity - cross(m0.angular_velocity, at.arm0);
      const Vec3<SweepDual> f = force(pairing, at, velocity, c.sticks);
      scatter(ports, marker0, columns.offset[0], columns.total, first, {f, cross(at.arm0, f)}, slot, values);
      scatter(ports, marker1, columns.offset[1], columns.total, first, {-f, -cross(at.arm1, f)}, slot, values);
    }
  }
}

}  // namespace dalembert
