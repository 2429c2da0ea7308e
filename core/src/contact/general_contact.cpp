#include "dalembert/contact/general_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dalembert/batches/port_sweep.hpp"
#include "dalembert/finite_elements/ancf_cable_2d_parameters.hpp"
#include "dalembert/laws/touch.hpp"
#include "dalembert/model/model.hpp"
#include "dalembert/system/system.hpp"

namespace dalembert {
namespace {

constexpr int chunk_size = 1000;

bool has_rotation(const Ports& ports, int marker) { return ports.ports[static_cast<std::size_t>(marker)].forces == RigidPort::forces; }

template <class S>
RigidFrame<S> turned_never(const PointFrame<S>& point) {
  return {point.position, point.velocity, identity<S>(), {}};
}

Vec3<double> into(const RigidFrame<double>& frame, const Vec3<double>& point) { return transposed_times(frame.rotation, point - frame.position); }
Vec3<double> out_of(const RigidFrame<double>& frame, const Vec3<double>& point) { return frame.position + frame.rotation * point; }

bool overlap(const SphereAt& a, const SphereAt& b) {
  const double dx = b.x - a.x, dy = b.y - a.y, dz = b.z - a.z, reach = a.radius + b.radius, square = dx * dx + dy * dy + dz * dz;
  return square < reach * reach && square > 0;
}

}  // namespace

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

// ---- lists -----------------------------------------------------------------------------------------------------------

template <class F>
void GeneralContact::each_chunk(const F& f) const {
  const int count = static_cast<int>(chunks_.size());
  if (workers_ != nullptr && count > 1) {
    workers_->run(count, [&](int c) { f(chunks_[static_cast<std::size_t>(c)]); });
  } else {
    for (Chunk& chunk : chunks_) f(chunk);
  }
}

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

// ---- what touches ----------------------------------------------------------------------------------------------------

// Faces that a sphere dips into, and edges and corners of which no triangle around has a point that is nearer. Triangles touch from
// their positive side alone. What meets in one point counts once: at an inner edge of a smooth surface, for one of its triangles.
void GeneralContact::touching_triangles(int number, const Ports& ports, Chunk& chunk) const {
  std::vector<Found>& found = chunk.found;
  found.clear();
  const auto begin = first_triangle_[static_cast<std::size_t>(number)], end = first_triangle_[static_cast<std::size_t>(number) + 1];
  const SphereAt& s = at_[static_cast<std::size_t>(number)];
  int known = -1;
  Vec3<double> centre;
  if (begin == end) return;
  for (std::size_t k = begin; k < end; ++k) {
    const int t = near_triangles_[k], carrier = triangle(t).carrier;
    if (carrier != known) {
      centre = into(frame_of(this->carrier(carrier).marker, ports), {s.x, s.y, s.z});
      known = carrier;
    }
    const Triangle& corners = local_[static_cast<std::size_t>(t)];
    const Vec3<double> area = area_vector(corners);
    const double above = dot(area, centre - corners[0]);
    if (!(above > 0) || above * above > s.radius * s.radius * dot(area, area)) continue;
    const TriangleFeature feature = nearest_feature(corners, centre);
    const Vec3<double> point = nearest_point(corners, feature, centre);
    const double square = dot(point - centre, point - centre), least = set_->nearest_relative_distance * s.radius;
    if (square < s.radius * s.radius && square > 0 && square >= least * least) found.push_back({t, feature.is_face() ? 0 : feature.is_edge() ? 1 : 2, point});
  }
  if (found.size() < 2) return;
  const double same = 1e-9 * s.radius;
  const auto is_kept = [&](const Found& a) {
    if (a.rank == 0) return true;
    for (const Found& b : found) {
      if (b.triangle == a.triangle || triangle(b.triangle).carrier != triangle(a.triangle).carrier) continue;
      const Triangle& corners = local_[static_cast<std::size_t>(b.triangle)];
      const Vec3<double> on_b = nearest_point(corners, nearest_feature(corners, a.point), a.point);
      if (norm(on_b - a.point) > same) continue;  // it has nothing to do with this point
      const bool is_same = norm(b.point - a.point) <= same;
      if (!is_same || b.rank < a.rank || (b.rank == a.rank && b.triangle < a.triangle)) return false;
    }
    return true;
  };
  chunk.kept.clear();
  for (const Found& a : found)
    if (is_kept(a)) chunk.kept.push_back(a);
  found.swap(chunk.kept);
}

template <class F>
void GeneralContact::each_touch(const Ports& ports, Chunk& chunk, F&& f) const {
  for (int i = chunk.begin; i < chunk.end; ++i) {
    const SphereAt a = at_[static_cast<std::size_t>(i)];
    for (const int j : neighbours_.behind(i))
      if (overlap(a, at_[static_cast<std::size_t>(j)])) f(HeldContact{i, j});
    touching_triangles(i, ports, chunk);
    for (const Found& found : chunk.found) f(HeldContact{i, set_->first_triangle() + found.triangle});
  }
}

// ---- forces ----------------------------------------------------------------------------------------------------------

template <class S>
GeneralContact::Meeting<S> GeneralContact::meet_sphere(int i, int j, const Vec3<S>& p0, const Vec3<S>& p1) const {
  const double r0 = sphere(i).radius, r1 = sphere(j).radius;
  const Vec3<S> span = p1 - p0;
  const S distance = norm(span);
  Meeting<S> at;
  at.normal = (1.0 / distance) * span;
  at.gap = distance - (r0 + r1);
  at.arm0 = (r0 + 0.5 * at.gap) * at.normal;
  at.arm1 = (-r1 - 0.5 * at.gap) * at.normal;
  return at;
}

template <class S>
GeneralContact::Meeting<S> GeneralContact::meet_triangle(int i, int t, const Vec3<S>& p0, const RigidFrame<S>& frame) const {
  const Triangle& corners = triangle(t).points;
  const Vec3<S> centre = transposed_times(frame.rotation, p0 - frame.position);
  const TriangleFeature feature = nearest_feature(corners, vector_of<3>([&](int k) { return value_of(centre[k]); }));
  Meeting<S> at;
  at.arm0 = frame.rotation * (nearest_point(corners, feature, centre) - centre);
  const S distance = norm(at.arm0);
  at.normal = (1.0 / distance) * at.arm0;
  at.gap = distance - sphere(i).radius;
  at.arm1 = p0 + at.arm0 - frame.position;
  return at;
}

// On the sphere; `velocity` is that of the other against it. Friction grows with the slip in the proportional zone; whether it is there
// may be given.
template <class S>
Vec3<S> GeneralContact::force(const ContactPairing& pairing, const Meeting<S>& at, const Vec3<S>& velocity, std::optional<bool> sticks) const {
  const S away = dot(at.normal, velocity);
  const S pressure = -(pairing.stiffness * at.gap) - pairing.damping * away;
  if (!(pressure > 0.0)) return {};
  if (pairing.friction == 0) return -pressure * at.normal;
  const Vec3<S> slip = velocity - away * at.normal;
  const double zone = set_->proportional_zone;
  const S square = dot(slip, slip);
  const bool sticking = sticks ? *sticks : value_of(square) < zone * zone;
  using std::sqrt;
  const S factor = sticking ? S(1 / zone) : value_of(square) > 0 ? S(1.0 / sqrt(square)) : S(0);
  return (pairing.friction * pressure) * (factor * slip) - pressure * at.normal;
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

// ---- implicit solvers ------------------------------------------------------------------------------------------------

// Whether it pushes, and how it slips.
bool GeneralContact::touches(const HeldContact& c, const Ports& ports, bool& sticks) const {
  const ContactPairing pairing = pairing_of(c);
  const Partner first{sphere(c.sphere).marker, turns(c.sphere)}, second = partner_of(c);
  const Meeting<double> at = meet(c, ports);
  const Vec3<double> velocity = velocity_at(second.marker, second.turns, at.arm1, ports) - velocity_at(first.marker, first.turns, at.arm0, ports);
  const double away = dot(at.normal, velocity);
  sticks = pairing.friction == 0 || norm(velocity - away * at.normal) < set_->proportional_zone;
  return pairing.stiffness * at.gap + pairing.damping * away < 0;
}

void GeneralContact::find(const Ports& ports, std::vector<HeldContact>& found) const {
  found.clear();
  if (!set_->active || set_->spheres.empty()) return;
  follow(ports);
  for (Chunk& chunk : chunks_)
    each_touch(ports, chunk, [&](HeldContact c) {
      if (touches(c, ports, c.sticks)) found.push_back(c);
    });
  if (set_->cables.empty()) return;
  find_cable_touches(cable_touches_);
  for (HeldContact c : cable_touches_) {
    const CableNow& cable = cables_now_[static_cast<std::size_t>(c.other - set_->first_cable())];
    const CableForces<double> forces = cable_forces(c, frame_of(sphere(c.sphere).marker, ports), cable.q, cable.v, {});
    c.sticks = forces.slip < set_->proportional_zone;
    if (forces.pressure > 0) found.push_back(c);
  }
  std::ranges::sort(found, {}, [](const HeldContact& c) { return std::tuple(c.sphere, c.other, c.along.begin); });
}

void GeneralContact::update(const Ports& ports) {
  take_cables_of_system();
  find(ports, touching_);
}

bool GeneralContact::search(const Evaluation& e, const Ports& ports) {
  take_cables(e.q, e.v);
  find(ports, touching_);
  held_ = touching_;
  // Pairs of spheres and cables stay in the pattern once they have been near.
  const std::size_t before = cables_in_blocks_.size();
  each_cable_near(0.5, [&](int i, int c) {
    const auto place = std::ranges::lower_bound(cables_in_blocks_, std::pair(i, c));
    if (place == cables_in_blocks_.end() || *place != std::pair(i, c)) cables_in_blocks_.insert(place, {i, c});
  });
  if (blocks_of_list_ == lists_ && cables_in_blocks_.size() == before) return false;
  blocks_of_list_ = lists_;
  list_blocks(ports);
  return true;
}

void GeneralContact::list_blocks(const Ports& ports) {
  using With = Block::With;
  blocks_.clear();
  std::size_t slot = 0;
  const auto count = [&](int marker) { return static_cast<std::size_t>(ports.ports[static_cast<std::size_t>(marker)].n); };
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
    for (std::size_t k = first_triangle_[static_cast<std::size_t>(i)]; k < first_triangle_[static_cast<std::size_t>(i) + 1]; ++k)
      carriers.push_back(triangle(near_triangles_[k]).carrier);
    std::ranges::sort(carriers);
    carriers.erase(std::ranges::unique(carriers).begin(), carriers.end());
    for (const int c : carriers) add(i, With::carrier, c, carrier(c).marker);
  }
}

const GeneralContact::Block& GeneralContact::block_of(const HeldContact& c) const {
  using With = Block::With;
  const bool of_spheres = c.other < spheres();
  const With with = of_spheres ? With::sphere : is_cable(c) ? With::cable : With::carrier;
  const int number = of_spheres ? c.other : is_cable(c) ? c.other - set_->first_cable() : triangle(c.other - set_->first_triangle()).carrier;
  return *std::ranges::lower_bound(blocks_, std::tuple(c.sphere, with, number), {}, &Block::key);
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

namespace {

RigidFrame<SweepDual> moving_frame(const Ports& ports, int marker, int offset, int first) {
  if (has_rotation(ports, marker)) return read_moving_frame<RigidPort>(ports, marker, offset, first);
  return turned_never(read_moving_frame<PointPort>(ports, marker, offset, first));
}

// -J^T of a wrench to the rows of one marker.
void scatter(const Ports& ports, int marker, int offset, int total, int first, const Wrench<SweepDual>& wrench, const int* slots, double* values) {
  const PortLayout& port = ports.ports[static_cast<std::size_t>(marker)];
  const double* jacobian = ports.jacobian(marker);
  const int count = std::min(sweep_width, total - first);
  for (int i = 0; i < port.n; ++i) {
    std::array<double, sweep_width> row{};
    for (int f = 0; f < port.forces; ++f) {
      const double j = -jacobian[f * port.n + i];
      const SweepDual& component = f < 3 ? wrench.force[f] : wrench.moment[f - 3];
      for (int k = 0; k < sweep_width; ++k) row[static_cast<std::size_t>(k)] += j * component.d[k];
    }
    const int* slot = slots + (offset + i) * total + first;
    for (int k = 0; k < count; ++k)
      if (slot[k] >= 0) values[slot[k]] += row[static_cast<std::size_t>(k)];
  }
}

}  // namespace

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

// The number of contacts that have begun or ended; the next search holds what touches then.
PostNewton GeneralContact::post_newton(const Evaluation& e, const Ports& ports, const double*, double*, double*) {
  take_cables(e.q, e.v);
  find(ports, touching_);
  const std::vector<HeldContact>& now = touching_;
  std::size_t common = 0;
  for (std::size_t i = 0, j = 0; i < now.size() && j < held_.size();) {
    const auto a = std::pair(now[i].sphere, now[i].other), b = std::pair(held_[j].sphere, held_[j].other);
    common += a == b ? 1 : 0;
    i += a <= b ? 1 : 0;
    j += b <= a ? 1 : 0;
  }
  const double changes = static_cast<double>(now.size() + held_.size() - 2 * common);
  return {.error = changes};
}

// ---- cables ----------------------------------------------------------------------------------------------------------

void GeneralContact::enter(const System& system, const Model& model) {
  system_ = &system;
  for (const ContactCable& cable : set_->cables) {
    CableShape shape;
    std::ranges::copy(system.object_ltg(cable.object, System::Coordinates::ode2), shape.dofs.begin());
    shape.length = model.item(ItemKind::object, cable.object).as<ObjectANCFCable2DRecord>().parameters.physicsLength;
    cables_.push_back(shape);
  }
}

// With the box around them: a cubic lies between its control points.
void GeneralContact::take_cables(const double* q, const double* v) const {
  cables_now_.resize(cables_.size());
  for (std::size_t c = 0; c < cables_.size(); ++c) {
    CableNow& now = cables_now_[c];
    now.q = cables_[c].numbers(q);
    now.v = cables_[c].numbers(v);
    const double third = cables_[c].length / 3, half = set_->cables[c].half_height;
    now.box = {};
    for (const auto& [end, side] : {std::pair<std::size_t, double>{0, 0}, {0, third}, {4, 0}, {4, -third}}) {
      const double x = now.q[end] + side * now.q[end + 2], y = now.q[end + 1] + side * now.q[end + 3];
      now.box.add({x - half, y - half, -half});
      now.box.add({x + half, y + half, half});
    }
  }
}

// For questions between evaluations.
void GeneralContact::take_cables_of_system() const {
  if (cables_.empty()) return;
  const State& now = system_->state(ConfigurationType::Current);
  std::vector<double> q = system_->state(ConfigurationType::Reference).q;
  for (std::size_t i = 0; i < q.size(); ++i) q[i] += now.q[i];
  take_cables(q.data(), now.v.data());
}

// Calls f(sphere, cable) for those in the plane whose boxes are so near, in parts of the radius of the sphere.
template <class F>
void GeneralContact::each_cable_near(double distance, F&& f) const {
  for (int i = 0; !cables_now_.empty() && i < spheres(); ++i) {
    const SphereAt& s = at_[static_cast<std::size_t>(i)];
    const double reach = (1 + distance) * s.radius;
    for (std::size_t c = 0; c < cables_now_.size(); ++c) {
      const Box& box = cables_now_[c].box;
      if (s.x + reach >= box.lower[0] && s.x - reach <= box.upper[0] && s.y + reach >= box.lower[1] && s.y - reach <= box.upper[1]) f(i, static_cast<int>(c));
    }
  }
}

void GeneralContact::find_cable_touches(std::vector<HeldContact>& found) const {
  found.clear();
  each_cable_near(0, [&](int i, int c) {
    const SphereAt& s = at_[static_cast<std::size_t>(i)];
    const auto number = static_cast<std::size_t>(c);
    std::array<Stretch1D, 4> stretches;
    const int n = stretches_within(cables_[number], cables_now_[number].q, {s.x, s.y}, s.radius + set_->cables[number].half_height, stretches);
    for (int k = 0; k < n; ++k) found.push_back({i, set_->first_cable() + c, true, stretches[static_cast<std::size_t>(k)]});
  });
}

ContactPairing GeneralContact::cable_pairing(const HeldContact& c) const {
  return set_->pairing(sphere(c.sphere).surface, set_->cables[static_cast<std::size_t>(c.other - set_->first_cable())].surface);
}

// Forces per length at both ends and in the middle of the stretch, by the rule of Simpson; they act at the axis of the cable.
template <class S>
GeneralContact::CableForces<S> GeneralContact::cable_forces(const HeldContact& c, const RigidFrame<S>& circle, const std::array<S, 8>& q, const std::array<S, 8>& v,
                                                            std::optional<bool> sticks) const {
  const auto number = static_cast<std::size_t>(c.other - set_->first_cable());
  const CableShape& cable = cables_[number];
  const ContactPairing pairing = cable_pairing(c);
  const double reach = sphere(c.sphere).radius + set_->cables[number].half_height;
  CableForces<S> result;
  for (int k = 0; k < 3; ++k) {
    const double x = c.along.begin + 0.5 * k * (c.along.end - c.along.begin), share = (c.along.end - c.along.begin) * (k == 1 ? 4 : 1) / 6;
    const std::array<double, 4> weights = cable.weights(x);
    const Vec<S, 2> place = cable.at(weights, q), rate = cable.at(weights, v);
    Meeting<S> at;
    at.arm0 = {place[0] - circle.position[0], place[1] - circle.position[1], S(0)};
    const S distance = norm(at.arm0);
    if (value_of(distance) == 0) continue;
    at.normal = (1.0 / distance) * at.arm0;
    at.gap = distance - reach;
    const Vec3<S> planar{circle.velocity[0], circle.velocity[1], S(0)};
    const Vec3<S> velocity = Vec3<S>{rate[0], rate[1], S(0)} - planar - circle.angular_velocity[2] * Vec3<S>{-at.arm0[1], at.arm0[0], S(0)};
    const Vec3<S> f = share * force(pairing, at, velocity, sticks);
    result.on_circle.force += f;
    result.on_circle.moment += cross(at.arm0, f);
    for (std::size_t i = 0; i < 8; ++i) result.on_cable[i] = result.on_cable[i] - weights[i / 2] * f[static_cast<int>(i % 2)];
    const double away = value_of(dot(at.normal, velocity));
    result.pressure -= (pairing.stiffness * value_of(at.gap) + pairing.damping * away) / 3;
    if (pairing.friction != 0) result.slip = std::max(result.slip, value_of(norm(velocity - away * at.normal)));
  }
  return result;
}

void GeneralContact::add_cable(const HeldContact& c, Ports& ports, std::optional<bool> sticks, double* r) const {
  const auto number = static_cast<std::size_t>(c.other - set_->first_cable());
  const int marker = sphere(c.sphere).marker;
  const CableForces<double> forces = cable_forces(c, frame_of(marker, ports), cables_now_[number].q, cables_now_[number].v, sticks);
  double* to = ports.force(marker);
  add_vector(to, 1.0, forces.on_circle.force);
  if (turns(c.sphere)) add_vector(to + 3, 1.0, forces.on_circle.moment);
  for (std::size_t i = 0; i < 8; ++i) r[cables_[number].dofs[i]] -= forces.on_cable[i];
}

void GeneralContact::add_cable_tangent(const HeldContact& c, const Block& block, const Weights& weights, const Ports& ports, double* values) const {
  const auto number = static_cast<std::size_t>(block.number);
  const int marker = sphere(c.sphere).marker, own = ports.ports[static_cast<std::size_t>(marker)].n, total = own + 8;
  const int* slot = slots.data() + block.first_slot;
  for (int first = 0; first < total; first += sweep_width) {
    std::array<SweepDual, 8> q, v;
    for (int i = 0; i < 8; ++i) {
      const auto k = static_cast<std::size_t>(i);
      q[k] = SweepDual(cables_now_[number].q[k]);
      v[k] = SweepDual(cables_now_[number].v[k]);
      const int column = own + i - first;
      if (column < 0 || column >= sweep_width) continue;
      q[k].d[static_cast<std::size_t>(column)] = weights.q;
      v[k].d[static_cast<std::size_t>(column)] = weights.v;
    }
    const CableForces<SweepDual> forces = cable_forces(c, moving_frame(ports, marker, 0, first), q, v, c.sticks);
    scatter(ports, marker, 0, total, first, forces.on_circle, slot, values);
    for (int i = 0; i < 8; ++i)
      for (int k = 0; k < std::min(sweep_width, total - first); ++k) {
        const int at = slot[(own + i) * total + first + k];
        if (at >= 0) values[at] -= forces.on_cable[static_cast<std::size_t>(i)].d[static_cast<std::size_t>(k)];
      }
  }
}

// ---- questions -------------------------------------------------------------------------------------------------------

GeneralContact::Items GeneralContact::items_in(const Box& box, const Ports& ports) const {
  Items items;
  for (int i = 0; i < spheres(); ++i) {
    const double* x = ports.frame(sphere(i).marker);
    const double r = sphere(i).radius;
    if (box.overlaps({{x[0] - r, x[1] - r, x[2] - r}, {x[0] + r, x[1] + r, x[2] + r}})) items.spheres.push_back(i);
  }
  take_cables_of_system();
  for (std::size_t c = 0; c < cables_now_.size(); ++c)
    if (box.overlaps(cables_now_[c].box)) items.cables.push_back(static_cast<int>(c));
  for (std::size_t t = 0; t < set_->triangles.size(); ++t) {
    const RigidFrame<double> frame = frame_of(carrier(set_->triangles[t].carrier).marker, ports);
    Box around;
    for (const Vec3<double>& point : set_->triangles[t].points) around.add(out_of(frame, point));
    if (box.overlaps(around)) items.triangles.push_back(static_cast<int>(t));
  }
  return items;
}

LineHit GeneralContact::first_hit(const Line& line, const Ports& ports) const {
  LineHit hit;
  hit.distance = line.farthest;
  if (line.spheres) {
    for (int i = 0; i < spheres(); ++i) {
      const double* x = ports.frame(sphere(i).marker);
      const double r = sphere(i).radius;
      const Vec3<double> to{x[0] - line.start[0], x[1] - line.start[1], x[2] - line.start[2]};
      const double along = dot(to, line.direction), aside = std::sqrt(std::max(0.0, dot(to - along * line.direction, to - along * line.direction)));
      if (aside > r + line.radius) continue;
      const double off = std::max(0.0, aside - line.radius), distance = along - std::sqrt(std::max(0.0, r * r - off * off));
      if (!(distance >= line.nearest && distance < hit.distance)) continue;
      hit = {distance, dot(line.direction, Vec3<double>{x[3], x[4], x[5]}), i};
    }
  }
  if (line.cables && line.direction[2] == 0) {  // in the plane: what is not meets them nowhere
    take_cables_of_system();
    for (std::size_t c = 0; c < cables_.size(); ++c) {
      const auto r = cables_[c].polynomials(cables_now_[c].q);
      const Vec3<double>& d = line.direction;
      std::array<double, 4> aside{};
      for (std::size_t k = 0; k < 4; ++k) aside[k] = d[0] * r[1][k] - d[1] * r[0][k];
      aside[0] -= d[0] * line.start[1] - d[1] * line.start[0];
      std::array<double, 6> zeros{};
      const int n = real_zeros(aside, 0, cables_[c].length, zeros);
      for (int k = 0; k < n; ++k) {
        const auto weights = cables_[c].weights(zeros[static_cast<std::size_t>(k)]);
        const Vec<double, 2> point = cables_[c].at(weights, cables_now_[c].q), velocity = cables_[c].at(weights, cables_now_[c].v);
        const double distance = d[0] * (point[0] - line.start[0]) + d[1] * (point[1] - line.start[1]);
        if (distance >= line.nearest && distance < hit.distance) hit = {distance, d[0] * velocity[0] + d[1] * velocity[1], -1, static_cast<int>(c)};
      }
    }
  }
  if (!line.triangles) return hit;
  renew_shapes();
  for (std::size_t c = 0; c < trees_.size(); ++c) {
    const RigidFrame<double> frame = read_frame<RigidPort>(ports, set_->carriers[c].marker);
    const Vec3<double> start = into(frame, line.start), direction = transposed_times(frame.rotation, line.direction);
    trees_[c].each_along(start, direction, line.nearest, [&] { return hit.distance; }, [&](int t) {
      const Triangle& corners = local_[static_cast<std::size_t>(t)];
      const Vec3<double> area = area_vector(corners);
      const double slope = dot(area, direction), square = dot(area, area);
      if (slope * slope <= 1e-28 * square) return;  // along the plane
      const double distance = dot(area, corners[0] - start) / slope;
      if (!(distance >= line.nearest && distance < hit.distance)) return;
      const Vec3<double> point = start + distance * direction;
      for (std::size_t k = 0; k < 3; ++k)  // what lies on an edge belongs to both triangles there
        if (dot(area, cross(corners[(k + 1) % 3] - corners[k], point - corners[k])) < -1e-10 * square) return;
      const Vec3<double> velocity = frame.velocity + cross(frame.angular_velocity, frame.rotation * point);
      hit = {distance, dot(line.direction, velocity), -1, -1, t};
    });
  }
  return hit;
}

}  // namespace dalembert
