// Common functions of general contact: frames of markers without rotation, contact geometry, and loops over contacts.
#pragma once

#include <cmath>

#include "dalembert/batches/port_sweep.hpp"
#include "dalembert/contact/general_contact.hpp"

namespace dalembert {

// in radii: contact points of a sphere with triangles within this distance are equal
inline constexpr double same_point = 1e-9;

inline bool has_rotation(const Ports& ports, int marker) {
  return ports.ports[static_cast<std::size_t>(marker)].forces == RigidPort::forces;
}

template <class S>
RigidFrame<S> turned_never(const PointFrame<S>& point) {
  return {point.position, point.velocity, identity<S>(), {}};
}

template <class S = double>  // a point, or several side by side
DALEMBERT_INLINE inline Vec3<S> into(const RigidFrame<double>& frame, const Vec3<S>& point) {
  return transposed_times(frame.rotation, point - frame.position);
}
inline Vec3<double> out_of(const RigidFrame<double>& frame, const Vec3<double>& point) {
  return frame.position + frame.rotation * point;
}

// Velocity of the second body relative to the first one at the contact point.
template <class S>
Vec3<S> relative_velocity(const RigidFrame<S>& frame0, const RigidFrame<S>& frame1, const ContactMeeting<S>& at) {
  return frame1.velocity + cross(frame1.angular_velocity, at.arm1) - frame0.velocity -
         cross(frame0.angular_velocity, at.arm0);
}

inline RigidFrame<SweepDual> moving_frame(const Ports& ports, int marker, int offset, int first) {
  if (has_rotation(ports, marker)) return read_moving_frame<RigidPort>(ports, marker, offset, first);
  return turned_never(read_moving_frame<PointPort>(ports, marker, offset, first));
}

// -J^T of a wrench to the rows of one marker.
inline void scatter(const Ports& ports, int marker, int offset, int total, int first, const Wrench<SweepDual>& wrench,
                    const int* slots, double* values) {
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

template <class F>
void GeneralContact::each_chunk(const F& f) const {
  share_tasks(workers_, static_cast<int>(chunks_.size()), [&](int c) { f(chunks_[static_cast<std::size_t>(c)]); });
}

template <class F>
void GeneralContact::each_touch(Chunk& chunk, F&& f) const {
  for (int i = chunk.begin; i < chunk.end; ++i) {
    for (const int j : neighbours_.behind(i))
      if (overlap(i, j)) f(HeldContact{i, j, true, {}, j});
    touching_triangles(i, triangles_near(i), chunk);
    for (const Found& found : chunk.found)
      f(HeldContact{i, set_->first_triangle() + found.triangle, true, {}, found.bristle});
  }
}

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
GeneralContact::Meeting<S> GeneralContact::meet_triangle(int i, int t, const Vec3<S>& p0,
                                                         const RigidFrame<S>& frame) const {
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

// Force on the sphere; `velocity` is that of the other body relative to it. Friction is proportional to the slip in
// the proportional zone; the branch may be given.
template <class S>
Vec3<S> GeneralContact::force(const ContactPairing& pairing, const Meeting<S>& at, const Vec3<S>& velocity,
                              std::optional<bool> sticks) const {
  const S away = dot(at.normal, velocity);
  const S normal_force = pairing.normal_force(at.gap, away);
  if (!(normal_force > 0.0)) return {};
  if (pairing.friction == 0) return -normal_force * at.normal;
  return pairing.friction_force(normal_force, velocity - away * at.normal, set_->proportional_zone, sticks) -
         normal_force * at.normal;
}

template <class S>
GeneralContact::Grip<S> GeneralContact::grip_of(const Bristle* bristle, const Meeting<S>& at,
                                                const RigidFrame<S>& frame0, const RigidFrame<S>& frame1) const {
  const double most = set_->bristles.holding;
  if (bristle == nullptr) return {{}, most};  // it takes root at the end of the step
  return {(frame1.rotation * bristle->root1 - at.arm1) - (frame0.rotation * bristle->root0 - at.arm0),
          bristle->slides ? 1.0 : most};
}

// Force on the sphere, as above, with the friction force of a bristle.
template <class S>
Vec3<S> GeneralContact::gripping_force(const ContactPairing& pairing, const Meeting<S>& at, const Vec3<S>& velocity,
                                       const Grip<S>& grip) const {
  const S away = dot(at.normal, velocity);
  const S normal_force = pairing.normal_force(at.gap, away);
  if (!(normal_force > 0.0)) return {};
  if (pairing.friction == 0) return -normal_force * at.normal;
  const S most = (pairing.friction * grip.holding) * normal_force;
  const Vec3<S> stretch = grip.span - dot(at.normal, grip.span) * at.normal, slip = velocity - away * at.normal;
  return set_->bristles.law(pairing).bounded_force(stretch, slip, most) - normal_force * at.normal;
}

template <class S>
Vec3<S> GeneralContact::convex_force(const ConvexTouch& t, const Meeting<S>& at, const Vec3<S>& velocity,
                                     const RigidFrame<S>& frame0, const RigidFrame<S>& frame1,
                                     std::optional<bool> sticks) const {
  if (!set_->bristles.grow()) return force(convex_pairing(t), at, velocity, sticks);
  return gripping_force(convex_pairing(t), at, velocity, grip_of(bristle_of(t), at, frame0, frame1));
}

template <class S>
Vec3<S> GeneralContact::force_of(const HeldContact& c, const Meeting<S>& at, const Vec3<S>& velocity,
                                 const RigidFrame<S>& frame0, const RigidFrame<S>& frame1) const {
  if (!set_->bristles.grow()) return force(pairing_of(c), at, velocity, c.sticks);
  return gripping_force(pairing_of(c), at, velocity, grip_of(bristle_of(c), at, frame0, frame1));
}

// Calls f(sphere, cable) for those in the plane whose boxes are so near, in parts of the radius of the sphere.
template <class F>
void GeneralContact::each_cable_near(double distance, F&& f) const {
  for (int i = 0; !cables_now_.empty() && i < spheres(); ++i) {
    const SphereAt& s = pairs_.at[static_cast<std::size_t>(i)];
    const double reach = (1 + distance) * s.radius;
    for (std::size_t c = 0; c < cables_now_.size(); ++c) {
      const Box& box = cables_now_[c].box;
      if (s.x + reach >= box.lower[0] && s.x - reach <= box.upper[0] && s.y + reach >= box.lower[1] &&
          s.y - reach <= box.upper[1])
        f(i, static_cast<int>(c));
    }
  }
}

}  // namespace dalembert
