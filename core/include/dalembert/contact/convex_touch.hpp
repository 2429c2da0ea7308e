// One contact point of a convex shape, defined by the two contacting features in the frames of their markers: gap and
// normal follow both bodies exactly while the features stay in contact.
#pragma once

#include <cmath>
#include <cstdint>
#include <tuple>

#include "dalembert/contact/rim_normal.hpp"
#include "dalembert/frames.hpp"

namespace dalembert {

// Geometry of a contact point.
template <class S>
struct ContactMeeting {
  Vec3<S> normal, arm0, arm1;  // from the first to the second; from the markers to the common point of action
  S gap;
};

struct ConvexTouch {
  enum class Kind {
    point_plane,  // first: a point with a radius; second: a plane
    rim_plane,  // first: the lowest point of a circle over the plane, or a point at an angle from it; second: the plane
    points,  // points with radii
    point_line,  // first: a point; second: a line; with radii
    point_rim,  // first: a point with a radius; second: a circle
    lines,  // with radii
    rim_line,  // first: a circle; second: a line with a radius
    rims  // two circles
  };
  int first = -1, second = -1;  // participants
  std::int64_t key = 0;  // identifies the point within its pair: convex_keys
  Kind kind = Kind::point_plane;
  bool swapped = false;  // the point, rim or first line belongs to the second one
  Vec3<double> at0, along0, at1, along1;  // point and direction: the normal of a plane, the axis of a circle
  double radius0 = 0, radius1 = 0;  // radii, which are added; the radius of a circle
  double cosine = 1, sine = 0;  // cosine of the angle on a rim
  Vec3<double> nearby;  // rim and line, or two rims: a direction near the normal
  double share = 1;  // share in the stiffness of the pair
  bool sticks = true, presses = true;
  std::int64_t bristle = -1;  // the key that its bristle has been known by

  auto order() const { return std::tuple(first, second, key); }
};

// A point, edge or rim of one shape touches the other shape: the normal points from the former to the latter.
template <class S>
struct MeetingPlace {
  Vec3<S> normal, place;
  S gap;
};

namespace convex_touch_detail {

template <class S>
Vec3<S> out(const RigidFrame<S>& frame, const Vec3<double>& point) {
  return frame.position + frame.rotation * point;
}

template <class S>
MeetingPlace<S> above_plane(const Vec3<S>& point, double radius, const Vec3<S>& normal, const Vec3<S>& in_plane) {
  const S height = dot(normal, point - in_plane);
  return {-normal, point - height * normal, height - radius};
}

// Two round things at points.
template <class S>
MeetingPlace<S> between(const Vec3<S>& point, double radius, const Vec3<S>& other, double other_radius) {
  const Vec3<S> span = other - point;
  const S distance = norm(span);
  const Vec3<S> normal = (1.0 / distance) * span;
  const S gap = distance - (radius + other_radius);
  return {normal, point + (radius + 0.5 * gap) * normal, gap};
}

template <class S>
Vec3<S> on_rim(const ConvexTouch& t, const Vec3<S>& centre, const Vec3<S>& axis, const Vec3<S>& down, double radius) {
  const Vec3<S> across = down - dot(axis, down) * axis;
  const Vec3<S> unit = (1.0 / norm(across)) * across;
  return centre + (radius * t.cosine) * unit + (radius * t.sine) * cross(axis, unit);
}

template <class S>
Rim<S> rim_of(const Vec3<S>& centre, const Vec3<S>& axis, double radius) {
  return {centre, axis, radius};
}
// `beyond`: how far the second one reaches against the normal from its own point.
template <class S>
MeetingPlace<S> between_rim_and(const Rim<S>& rim, const Vec3<S>& normal, const Vec3<S>& other, const S& beyond) {
  const auto reach = rim.reach(normal);
  const S gap = -(dot(normal, rim.centre - other) + rim.radius * reach.sine + beyond);
  return {normal, rim.centre + rim.radius * reach.out + (0.5 * gap) * normal, gap};
}

template <class S>
MeetingPlace<S> between_lines(const ConvexTouch& t, const Vec3<S>& x0, const Vec3<S>& d0, const Vec3<S>& x1,
                              const Vec3<S>& d1) {
  const Vec3<S> across = cross(d0, d1), span = x1 - x0;
  const S square = dot(across, across);
  using std::sqrt;
  const Vec3<S> normal = (t.cosine / sqrt(square)) * across;  // carries the sign
  const S gap = dot(normal, span) - (t.radius0 + t.radius1);
  const Vec3<S> nearest = x0 + (dot(cross(span, d1), across) / square) * d0;
  return {normal, nearest + (t.radius0 + 0.5 * gap) * normal, gap};
}

}  // namespace convex_touch_detail

template <class S>
ContactMeeting<S> meeting_of(const ConvexTouch& t, const RigidFrame<S>& first, const RigidFrame<S>& second) {
  using namespace convex_touch_detail;
  const RigidFrame<S>&a = t.swapped ? second : first, &b = t.swapped ? first : second;
  const Vec3<S> x0 = out(a, t.at0), x1 = out(b, t.at1), d1 = b.rotation * t.along1;
  const auto nearby = [&] { return rim_normals::value_of_vector(Vec3<S>(a.rotation * t.nearby)); };
  MeetingPlace<S> place;
  switch (t.kind) {
    case ConvexTouch::Kind::point_plane: place = above_plane(x0, t.radius0, d1, x1); break;
    case ConvexTouch::Kind::rim_plane:
      place = above_plane(on_rim(t, x0, a.rotation * t.along0, -d1, t.radius0), 0, d1, x1);
      break;
    case ConvexTouch::Kind::points: place = between(x0, t.radius0, x1, t.radius1); break;
    case ConvexTouch::Kind::point_line: place = between(x0, t.radius0, x1 + dot(x0 - x1, d1) * d1, t.radius1); break;
    case ConvexTouch::Kind::point_rim: place = between(x0, t.radius0, on_rim(t, x1, d1, x0 - x1, t.radius1), 0); break;
    case ConvexTouch::Kind::lines: place = between_lines(t, x0, a.rotation * t.along0, x1, d1); break;
    case ConvexTouch::Kind::rim_line: {
      const Rim<S> rim = rim_of<S>(x0, a.rotation * t.along0, t.radius0);
      place = between_rim_and(rim, normal_of_rim_and_line(rim, x1, d1, nearby()), x1, S(t.radius1));
      break;
    }
    case ConvexTouch::Kind::rims: {
      const Rim<S> rim = rim_of<S>(x0, a.rotation * t.along0, t.radius0), other = rim_of<S>(x1, d1, t.radius1);
      const Vec3<S> normal = normal_of_rims(rim, other, nearby());
      place = between_rim_and(rim, normal, x1, S(t.radius1 * other.reach(normal).sine));
      break;
    }
  }
  const Vec3<S> normal = t.swapped ? -place.normal : place.normal;
  return {normal, place.place - first.position, place.place - second.position, place.gap};
}

}  // namespace dalembert
