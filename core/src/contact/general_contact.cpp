// Contact forces and their tangent.
#include "dalembert/contact/general_contact.hpp"

#include <algorithm>
#include <cmath>

#include "dalembert/system/system.hpp"
#include "meetings.hpp"

namespace dalembert {
namespace {

bool has_twins(std::vector<int> numbers) {
  if (!std::ranges::is_sorted(numbers)) std::ranges::sort(numbers);  // usually sorted
  return std::ranges::adjacent_find(numbers) != numbers.end();
}

}  // namespace

GeneralContact::GeneralContact(std::shared_ptr<const ContactSet> set, const Ports& ports, std::string name)
    : set_(std::move(set)), name_(std::move(name)) {
  for (const ContactSphere& s : set_->spheres) {
    markers_.push_back(s.marker);
    turns_.push_back(has_rotation(ports, s.marker) ? 1 : 0);
    offsets_.push_back(ports.offsets(s.marker));
  }
  shares_markers_ = has_twins(markers_);
  for (const ContactCarrier& c : set_->carriers) markers_.push_back(c.marker);
  for (const ContactConvex& c : set_->convex) markers_.push_back(c.marker);
  for (const ContactPlane& p : set_->planes) markers_.push_back(p.marker);
  renew_shapes();
}

void GeneralContact::find_nodes(const System& system) {
  at_nodes_.clear();
  at_nodes_.reserve(set_->spheres.size());
  for (const ContactSphere& s : set_->spheres) at_nodes_.push_back(system.node_frame(s.marker));
  std::vector<int> nodes;  // two markers at one node are as one
  nodes.reserve(at_nodes_.size());
  for (const NodeFrame& node : at_nodes_)
    if (node.dof >= 0) nodes.push_back(node.dof);
  shares_nodes_ = has_twins(std::move(nodes));
}

// Convex shapes, cables and bristles need frames.
bool GeneralContact::reads_nodes() const {
  return !shares_nodes_ && cables_.empty() && set_->convex.empty() && set_->planes.empty() && !set_->bristles.grow();
}

RigidFrame<double> GeneralContact::frame_of(int marker, const Ports& ports) const {
  return has_rotation(ports, marker) ? read_frame<RigidPort>(ports, marker)
                                     : turned_never(read_frame<PointPort>(ports, marker));
}

ContactPairing GeneralContact::pairing_of(const HeldContact& c) const {
  const ContactSurface& other = c.other < spheres()
                                    ? sphere(c.other).surface
                                    : carrier(triangle(c.other - set_->first_triangle()).carrier).surface;
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
  const Vec3<double>& velocity =
      read_frame<PointPort>(ports, marker).velocity;  // frames of rigid bodies begin with those of points
  return turns ? velocity + cross(read_frame<RigidPort>(ports, marker).angular_velocity, arm) : velocity;
}

void GeneralContact::add_held(const HeldContact& c, Ports& ports) const {
  const Partner first{sphere(c.sphere).marker, turns(c.sphere)}, second = partner_of(c);
  const Meeting<double> at = meet(c, ports);
  const Vec3<double> velocity =
      velocity_at(second.marker, second.turns, at.arm1, ports) - velocity_at(first.marker, first.turns, at.arm0, ports);
  const Vec3<double> f = force_of(c, at, velocity, frame_of(first.marker, ports), frame_of(second.marker, ports));
  const auto push = [&](const Partner& on, const Vec3<double>& force, const Vec3<double>& moment) {
    double* to = ports.force(on.marker);
    add_vector(to, 1.0, force);
    if (on.turns) add_vector(to + 3, 1.0, moment);
  };
  push(first, f, cross(at.arm0, f));
  push(second, -f, -cross(at.arm1, f));
}

std::vector<GeneralContact::Push> GeneralContact::pushes(const Ports& ports, ConfigurationType configuration) {
  take_cables_of_system(configuration);
  find(ports, touching_);
  std::vector<Push> result;
  for (const HeldContact& c : touching_) {
    const Partner first{sphere(c.sphere).marker, turns(c.sphere)};
    const Vec3<double>& centre = read_frame<PointPort>(ports, first.marker).position;
    if (is_cable(c)) {
      const CableNow& cable = cables_now_[static_cast<std::size_t>(c.other - set_->first_cable())];
      const Vec3<double> f = cable_forces(c, frame_of(first.marker, ports), cable.q, cable.v, {}).on_circle.force;
      const CableShape& shape = cables_[static_cast<std::size_t>(c.other - set_->first_cable())];
      const Vec<double, 2> middle = shape.at(shape.weights(0.5 * (c.along.begin + c.along.end)), cable.q);
      const Vec3<double> arm{middle[0] - centre[0], middle[1] - centre[1], 0};
      result.push_back({c.sphere, c.other, centre + (sphere(c.sphere).radius / norm(arm)) * arm, f});
      continue;
    }
    const Partner second = partner_of(c);
    const Meeting<double> at = meet(c, ports);
    const Vec3<double> velocity = velocity_at(second.marker, second.turns, at.arm1, ports) -
                                  velocity_at(first.marker, first.turns, at.arm0, ports);
    result.push_back({c.sphere, c.other, centre + at.arm0,
                      force_of(c, at, velocity, frame_of(first.marker, ports), frame_of(second.marker, ports))});
  }
  for (const ConvexPlace& p : convex_places(ports)) result.push_back({p.first, p.second, p.point, p.force});
  return result;
}

// Adds forces of triangles on a sphere; forces on the carriers are stored in the chunk.
void GeneralContact::add_on_triangles(int number, const Ports& ports, bool rubs, Chunk& chunk) const {
  touching_triangles(number, chunk.of_sphere, chunk);
  const auto i = static_cast<std::size_t>(number);
  const bool spins = turns(number), grips = set_->bristles.grow();
  for (const Found& found : chunk.found) {
    const auto c = static_cast<std::size_t>(triangle(found.triangle).carrier);
    const ContactCarrier& carrier = set_->carriers[c];
    const RigidFrame<double>& frame = carriers_now_[c];
    Meeting<double> at;
    at.normal = frame.rotation * found.normal;
    at.gap = found.distance - pairs_.at[i].radius;
    at.arm0 = found.distance * at.normal;
    // a fixed carrier has no velocity, and needs no forces
    const bool moves = ports.ports[static_cast<std::size_t>(carrier.marker)].n > 0;
    Vec3<double> velocity = -pairs_.velocity[i].vector();
    if (moves || grips) at.arm1 = frame.rotation * found.point;
    if (moves) velocity += frame.velocity + cross(frame.angular_velocity, at.arm1);
    if (spins) velocity -= cross(pairs_.spin[i].vector(), at.arm0);
    const ContactPairing pairing = pairs_.pairing_with(*set_, number, static_cast<int>(c));
    const Vec3<double> f = grips ? gripping_force(pairing, at, velocity,
                                                  grip_of(bristles_.find(number, found.bristle), at,
                                                          frame_of(sphere(number).marker, ports), frame))
                                 : force(pairing, at, velocity, {});
    pairs_.force[i].add(f);
    if (spins && rubs) pairs_.moment[i].add(cross(at.arm0, f));
    if (moves) chunk.on_carriers.push_back({carrier.marker, -f, -cross(at.arm1, f)});
  }
}

// Forces on spheres at nodes go there, if there is where.
void GeneralContact::add_direct(Ports& ports, double* at_nodes) const {
  const bool rubs = !std::ranges::all_of(set_->friction, [](double mu) { return mu == 0; }),
             grips = rubs && set_->bristles.grow();
  const auto friction = grips  ? SpherePairs::Friction::of_others
                        : rubs ? SpherePairs::Friction::of_slip
                               : SpherePairs::Friction::none;
  if (rubs) pairs_.make_room_for_moments();
  const auto number_of = [&](const Chunk& chunk) { return static_cast<int>(&chunk - chunks_.data()); };
  const auto leave = [&](const Chunk& chunk) {
    for (int number = chunk.begin; number < chunk.end; ++number) {
      const auto i = static_cast<std::size_t>(number);
      const Vec3<double> force = pairs_.force[i].vector(),
                         moment = rubs && turns_[i] != 0 ? pairs_.moment[i].vector() : Vec3<double>{};
      if (const NodeFrame node = at_nodes != nullptr ? at_nodes_[i] : NodeFrame(); node.dof >= 0) {
        if (node.rotating_node >= 0)
          ports.node_loads[static_cast<std::size_t>(node.rotating_node)].add_at_node(force, moment);
        else
          add_vector(at_nodes + node.dof, -1.0, force);
        continue;
      }
      double* to = ports.forces.data() + offsets_[i].force;
      add_vector(to, 1.0, force);
      if (rubs && turns_[i] != 0) add_vector(to + 3, 1.0, moment);
    }
  };
  const auto finish = [&](const Chunk& chunk) {
    pairs_.collect(number_of(chunk), rubs);
    if (!shares_markers_) leave(chunk);
  };
  const bool in_turn =
      workers_ ==
      nullptr;  // all that acts on spheres of a chunk is there with its own pairs, as second ones have larger numbers
  each_chunk([&](Chunk& chunk) {
    if (pairs_.compute(number_of(chunk), *set_, friction) == 0) {
      for (int i = chunk.begin; i < chunk.end; ++i)
        for (const int j : neighbours_.behind(i)) overlap(i, j);  // refuses those of one centre
    }
    if (grips) add_gripping_pairs(number_of(chunk), ports);
    add_on_triangles(ports, rubs, chunk);
    if (in_turn) finish(chunk);
  });
  if (!in_turn) each_chunk(finish);
  for (const Chunk& chunk : chunks_) {
    if (shares_markers_) leave(chunk);
    for (const Chunk::OnCarrier& on : chunk.on_carriers) {
      double* to = ports.force(on.marker);
      add_vector(to, 1.0, on.force);
      add_vector(to + 3, 1.0, on.moment);
    }
  }
}

void GeneralContact::residual(const Evaluation& e, Ports& ports, double* r) const {
  if (has_convex()) {
    if (e.direct) find_convex(ports, convex_found_, Places::pushing);
    add_convex(e.direct ? convex_found_ : convex_held_, ports, e.direct);
  }
  if (!set_->active || set_->spheres.empty()) return;
  take_cables(e.q, e.v);
  if (!e.direct) {
    for (const HeldContact& c : held_) is_cable(c) ? add_cable(c, ports, c.sticks, r) : add_held(c, ports);
    return;
  }
  follow(ports, e.reads_nodes ? &e : nullptr);
  add_direct(ports, e.reads_nodes ? r : nullptr);
  find_cable_touches(cable_touches_);
  for (const HeldContact& c : cable_touches_) add_cable(c, ports, {}, r);
}

void GeneralContact::visit(BlockVisitor& visitor, const Ports& ports) const {
  for (const Block& block : blocks_) {
    std::vector<int> dofs;
    const auto add = [&](std::span<const int> some) { dofs.insert(dofs.end(), some.begin(), some.end()); };
    add(ports.marker_dofs(sphere(block.sphere).marker));
    if (block.with == Block::With::cable)
      add(cables_[static_cast<std::size_t>(block.number)].dofs);
    else
      add(ports.marker_dofs(block.marker1));
    visitor.block(dofs, dofs);
  }
  for (const ConvexBlock& block : convex_blocks_) {
    std::vector<int> dofs;
    for (const int participant : {block.first, block.second}) {
      const auto own = ports.marker_dofs(scene_.marker(participant));
      dofs.insert(dofs.end(), own.begin(), own.end());
    }
    visitor.block(dofs, dofs);
  }
}

void GeneralContact::tangent(const Evaluation&, const Weights& weights, Ports& ports, double* values) const {
  if (!set_->active) return;
  add_convex_tangent(ports, values);
  for (const HeldContact& c : held_) {
    const Block& block = block_of(c);
    if (is_cable(c)) {
      add_cable_tangent(c, block, weights, ports, values);
      continue;
    }
    const bool of_spheres = c.other < spheres();
    const int marker0 = sphere(c.sphere).marker, marker1 = block.marker1;
    const Columns<2> columns(ports, {marker0, marker1});
    const int* slot = slots.data() + block.first_slot;
    for (int first = 0; first < columns.total; first += sweep_width) {
      const RigidFrame<SweepDual> m0 = moving_frame(ports, marker0, columns.offset[0], first),
                                  m1 = moving_frame(ports, marker1, columns.offset[1], first);
      const Meeting<SweepDual> at = of_spheres
                                        ? meet_sphere(c.sphere, c.other, m0.position, m1.position)
                                        : meet_triangle(c.sphere, c.other - set_->first_triangle(), m0.position, m1);
      const Vec3<SweepDual> velocity = relative_velocity(m0, m1, at);
      const Vec3<SweepDual> f = force_of(c, at, velocity, m0, m1);
      scatter(ports, marker0, columns.offset[0], columns.total, first, {f, cross(at.arm0, f)}, slot, values);
      scatter(ports, marker1, columns.offset[1], columns.total, first, {-f, -cross(at.arm1, f)}, slot, values);
    }
  }
}

}  // namespace dalembert
