// A disc on a plane: contact point and relative motion. Vectors are global, except for components in the contact
// frame c.
#pragma once

#include <vector>

#include "dalembert/enums.hpp"
#include "dalembert/frames.hpp"

namespace dalembert {

template <class S>
struct RollingContact {
  Vec3<S> lateral, forward, normal;  // axes of the contact frame
  Vec3<S> radius;  // from the center of the disc to its lowest point,
  Vec3<S> arm;                       // and from the marker on the plane to that point
  Vec3<S> slip;                      // velocity of the disc against the plane there

  template <class Parameters>
  RollingContact(const Parameters& p, const RigidFrame<S>& plane, const RigidFrame<S>& disc)
      : normal(plane.rotation * p.planeNormal) {
    const Vec3<S> axis = disc.rotation * p.discAxis, along = cross(axis, normal);
    forward = (1.0 / norm(along)) * along;
    lateral = cross(normal, forward);
    radius = p.discRadius * cross(axis, forward);
    arm = disc.position + radius - plane.position;
    slip = disc.velocity + cross(disc.angular_velocity, radius) - plane.velocity - cross(plane.angular_velocity, arm);
  }

  // v_c = A_0c^T v_0
  Vec3<S> local(const Vec3<S>& v_0) const { return {dot(lateral, v_0), dot(forward, v_0), dot(normal, v_0)}; }

  // A force on the disc at the contact point, and its reaction on the plane: f_0 = A_0c f_c.
  std::array<Wrench<S>, 2> forces(const Vec3<S>& f_c) const {
    const Vec3<S> f_0 = f_c[0] * lateral + f_c[1] * forward + f_c[2] * normal;
    return {Wrench<S>{-f_0, -cross(arm, f_0)}, Wrench<S>{f_0, cross(radius, f_0)}};
  }
};

// The velocity at which the lowest point of the disc moves on; the plane's own velocity is taken at `point`.
template <class Parameters>
Vec3<double> trail_velocity(const Parameters& p, const RigidFrame<double>& plane, const RigidFrame<double>& disc,
                            const RollingContact<double>& contact, const Vec3<double>& point) {
  const Vec3<double> axis = disc.rotation * p.discAxis, along = cross(axis, contact.normal);
  const Vec3<double> axis_rate = cross(disc.angular_velocity, axis);
  const Vec3<double> along_rate =
      cross(axis_rate, contact.normal) + cross(axis, cross(plane.angular_velocity, contact.normal));
  const Vec3<double> forward_rate =
      (1 / norm(along)) * (along_rate - dot(contact.forward, along_rate) * contact.forward);
  const Vec3<double> radius_rate = p.discRadius * (cross(axis_rate, contact.forward) + cross(axis, forward_rate));
  return disc.velocity + radius_rate - plane.velocity - cross(plane.angular_velocity, point);
}

// Rotation from the contact frame to the global one, row by row.
inline void assign_contact_axes(const RollingContact<double>& contact, std::vector<double>& values) {
  values.clear();
  for (int i = 0; i < 3; ++i) values.insert(values.end(), {contact.lateral[i], contact.forward[i], contact.normal[i]});
}

}  // namespace dalembert
